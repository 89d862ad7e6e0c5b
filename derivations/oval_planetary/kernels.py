"""What can be computed of paper 2: ratio, position and acceleration, and every form of them."""

from __future__ import annotations

import sympy as sp

from mechproof.record import (
    Accuracy,
    Argument,
    Conjunction,
    Equality,
    Form,
    Part,
    Quantity,
    Scale,
    Singular,
    Statement,
    Written,
)

from .paper import (
    ACCELERATION,
    ACCELERATION_CYLINDRICAL,
    COS_4,
    GIVEN,
    POSITION,
    POSITION_CYLINDRICAL,
    R4,
    R5,
    RATIO,
    RATIO_CYLINDRICAL,
    a,
    alpha,
    alpha_double,
    beta,
    beta_double,
    both,
    cos_6,
    count_branches,
    delta,
    driven_angle,
    e1,
    e2,
    gamma,
    gamma_double,
    k,
    lam,
    lead,
    less,
    lever,
    m,
    mount,
    mount_counted,
    mu,
    nearest,
    nu,
    pair_ratio,
    phi1,
    phi6,
    phi6_closed,
    phi6_counted,
    ratio_of_map,
    rho5,
    rho6,
    rise,
    shift,
    sin_6,
    swing,
    t,
    tangent,
    tau,
    turns,
    x,
    xi,
    y,
)
from .rows import print_10, print_radius

ECCENTRICITIES = (0, 0.28, 0.5, 0.9, 0.99, 1)
CARRIER = Argument(
    "phi1", (phi1,), "carrier angle, any number of turns", "rad", usual=(0, 10, 1000)
)
OVAL_63 = Argument("e2", (e2,), "eccentricity of the oval pair 6-3", usual=ECCENTRICITIES)
OF_OVALS = (
    CARRIER,
    Argument("e1", (e1,), "eccentricity of the oval pair 4-5", usual=(0, 0.5, 1)),
    OVAL_63,
    Argument(
        "mount",
        (mount,),
        "turn of wheel 6 on its shaft, forward from its place in the paper",
        "rad",
        0.0,
        usual=(0, 0.4, float(sp.pi)),
    ),
)
OF_CYLINDERS = (
    CARRIER,
    Argument("R4", (R4,), "radius of the cylindrical sun 4", "mm"),
    Argument("R5", (R5,), "radius of the cylindrical wheel 5", "mm"),
    OVAL_63,
)

# Two oval pairs -------------------------------------------------------------------------------

# A wheel makes quarter turns; the major axes of the pair 6-3 meet, where the ratio is steep; wheel
# 6 is mounted along an axis; equal ovals; round and flat ones.
SINGULAR_OVALS = tuple(
    map(
        Singular,
        (
            sp.Eq(phi1, sp.pi / 2 * m),
            sp.Eq(
                (1 + e1) * sp.sin(phi1) * sp.cos(mount) + (1 - e1) * sp.cos(phi1) * sp.sin(mount), 0
            ),
            sp.Eq(mount, sp.pi / 2 * m),
            sp.Eq(e1, e2),
            sp.Eq(e1, 0),
            sp.Eq(e2, 0),
            sp.Eq(e1, 1),
            sp.Eq(e2, 1),
        ),
    )
)

# All coefficients divided by 1 - e2, and beta + gamma*t split into less + y. y has the sine of the
# mounted wheel's angle as a factor and is large beside the rest as e2 -> 1; rounded once, it
# enters both arguments of atan2, and what is left of it where it vanishes is one small angle.
POSITION_FORM = sp.atan2(t * (y - swing), less + y + both * t**2)
SPREAD_FORM = (less + y) ** 2 + both**2 * t**2
WHEEL_3_FORM = both * (less + shift) * (1 + t**2) / SPREAD_FORM
TILT = (
    y * (rise - shift * t),
    less * rise * (1 - t**2),
    (swing * (less + both) - 2 * less * shift) * t,
)
ACCELERATION_FORM = 2 * WHEEL_3_FORM * sum(TILT) / SPREAD_FORM

# Statements. The coefficients of the map are variables of their own, lambda, mu, nu, and the steps
# are those of the paper: so neither proof has to deal with more than it is about.
PARTS = {both: lam, less: mu - xi, shift: xi, rise: nu, swing: lam - mu + xi}
DOUBLE = {alpha_double: lam, beta_double: mu, gamma_double: nu}
ANY_MAP = {alpha: lam, beta: mu, gamma: nu, delta: lam - mu}
SCALED_MAP = {s: (1 - e2) * value for s, value in ANY_MAP.items()}
BY_TANGENT = {
    sp.cos(2 * phi1): (1 - tangent**2) / (1 + tangent**2),
    sp.sin(2 * phi1): 2 * tangent / (1 + tangent**2),
}
TANGENT = tuple(Equality(f, by.subs(tangent, t)) for f, by in BY_TANGENT.items())


def of_parts(code: Written, *unused: sp.Symbol) -> tuple[Equality, ...]:
    """State what the emitted steps are, 1 - e2 times: the coefficients of the map."""
    step = {part: code.step(part) for part in PARTS if part not in unused}
    sums = {
        alpha: step[both],
        beta: step[less] + step[shift],
        gamma: step[rise],
        delta: step.get(swing, step[both] - step[less]) - step[shift],
    }
    return tuple(Equality((1 - e2) * total, coefficient) for coefficient, total in sums.items())


def ratio_by_parts(code: Written) -> Statement:
    """State the ratio of the parts, and the parts."""
    form = code.output(*PARTS).xreplace(PARTS)
    return Conjunction((Equality(form, RATIO.xreplace(SCALED_MAP)), *of_parts(code, swing)))


def acceleration_by_parts(code: Written) -> Statement:
    """State the acceleration of the parts, and the parts."""
    form = code.output(*PARTS).xreplace(PARTS)
    return Conjunction((Equality(form, ACCELERATION.xreplace(SCALED_MAP)), *of_parts(code)))


def position_by_parts(code: Written) -> Statement:
    """State the position of the parts, by the tangent, and the parts."""
    form = code.output(*PARTS).xreplace({**PARTS, t: tangent})
    position = POSITION.xreplace(SCALED_MAP).xreplace(BY_TANGENT)
    return Conjunction((Equality(form, position), *TANGENT, *of_parts(code)))


def of_double(code: Written) -> tuple[Equality, ...]:
    """State what the emitted steps are: the coefficients of the map."""
    pairs = zip(DOUBLE, (alpha, beta, gamma), strict=True)
    return tuple(Equality(code.step(step), coefficient) for step, coefficient in pairs)


def ratio_by_map(code: Written) -> Statement:
    """State the ratio of any map, and the coefficients."""
    form = code.output(*DOUBLE).xreplace(DOUBLE)
    return Conjunction((Equality(form, RATIO.xreplace(ANY_MAP)), *of_double(code)))


def acceleration_by_map(code: Written) -> Statement:
    """State the acceleration of any map, and the coefficients."""
    form = code.output(*DOUBLE).xreplace(DOUBLE)
    return Conjunction((Equality(form, ACCELERATION.xreplace(ANY_MAP)), *of_double(code)))


def position_by_map(code: Written) -> Statement:
    """State the position of any map, by the tangent, and the coefficients."""
    form = code.output(*DOUBLE).xreplace({**DOUBLE, t: tangent})
    position = POSITION.xreplace(ANY_MAP).xreplace(BY_TANGENT)
    return Conjunction((Equality(form, position), *TANGENT, *of_double(code)))


# The double angle of wheel 6, by which the row on any mount puts the two pairs in series.
WHEEL_6 = (
    Equality(sp.cos(2 * phi6_closed), cos_6),
    Equality(sp.sin(2 * phi6_closed), sin_6),
)


def through_pairs(code: Written) -> Statement:
    """State that each pair integrates its ratio, and the double angle of wheel 6."""
    form = code.output(phi6_closed).xreplace({phi6_closed: phi6})
    of_first = pair_ratio(e1, COS_4).subs(phi1, tau)
    of_second = pair_ratio(e2, sp.cos(2 * (tau + mount)))
    return Conjunction(
        (
            Equality(code.step(phi6_closed), sp.Integral(of_first, (tau, 0, phi1))),
            Equality(form, phi1 - sp.Integral(of_second, (tau, 0, phi6))),
            *WHEEL_6,
        )
    )


def over_branches(code: Written) -> Statement:
    """State each pair at its angle + pi*m, |angle| < pi/2, where its floor is m."""
    form = code.output(phi6_counted, mount_counted).xreplace({phi6_counted: phi6})
    of_second = phi1 - driven_angle(e2, phi6 + mount) + mount_counted
    return Conjunction(
        (
            on_branch(code.step(phi6_counted), driven_angle(e1, phi1), phi1, phi1),
            on_branch(code.step(mount_counted), driven_angle(e2, mount), mount, mount),
            on_branch(form, of_second, phi6, phi6 - mount),
        )
    )


def on_branch(form: sp.Expr, whole: sp.Expr, angle: sp.Symbol, value: sp.Expr) -> Equality:
    """State that a form with one floor is a whole where an angle has a value and m half turns."""
    (count,) = form.atoms(sp.floor)
    at_turn = {angle: value + sp.pi * turns}
    return Equality(form.xreplace({count: turns}).subs(at_turn), whole.subs(at_turn))


def as_printed(code: Written) -> Statement:
    """State the speed of wheel 3 through both pairs at any angle of wheel 6, and that angle."""
    form = code.output(phi6_closed).xreplace({phi6_closed: phi6})
    second = pair_ratio(e2, sp.cos(2 * (phi6 + mount)))
    return Conjunction(
        (
            Equality(1 - form, second / pair_ratio(e1, -sp.cos(2 * phi6))),
            Equality(1 / pair_ratio(e1, -cos_6), pair_ratio(e1, COS_4)),
            Equality(code.step(phi6_closed), phi6_closed),
            *WHEEL_6,
        )
    )


QUARTER = sp.Interval.open(-sp.pi / 2, sp.pi / 2)
BRANCHES = Part("each angle on its first branch", dict.fromkeys((phi1, phi6, mount), QUARTER))
PRINTED_RADII = {
    rho5: print_radius(e1, sp.pi / 2 - phi6_closed),
    rho6: print_radius(e2, phi6_closed + mount),
}

# Accuracy. The terms of y = shift + rise*t are rounded, and where they cancel the value makes of
# that what no evaluation from a rounded tangent is spared: up to 1/(1 - e2), where the major axes
# of the pair 6-3 meet away from phi1 = 0. So the scales are the largest term, and added to it what
# the value makes of y with its terms changed against each other, 0 without a mount; at the peak of
# the ratio, where less + y vanishes, that is of second order in eps. The rest is some 20
# operations; all of them in one direction would make twice the bounds, which are what searches for
# the worst input hold.
# At its peak the acceleration goes with the cube of (1 - e1)*(1 - e2), three roundings where both
# eccentricities are below 1/2: 4 eps that the rest of the product saves. Beside a mounted wheel two
# terms of like size meet, each with roundings of its own: searches find 8.6 of the larger one, and
# 6.3 where wheel 6 is mounted as in the paper.
EPS = sp.Rational(1, 2**52)
T, R, S, W, Z, VALUE = sp.symbols("t R S W Z value", real=True)
OF_T = {t: T}
STEPS = (
    (T, t),
    *((step, GIVEN[step]) for step in (both, less, lever, rise, shift)),
    (y, GIVEN[y].xreplace(OF_T)),
    (S, SPREAD_FORM.xreplace(OF_T)),
)
WHEEL_3 = (W, both * (less + shift) * (1 + T**2) / S)
CHANGE = rise * T - shift
RATIO_SCALE = Scale(
    "the larger of 1 and W, and what the roundings of y make of it",
    sp.Max(1, W) + sp.Abs(W * (less + y) * CHANGE / S) + EPS * W * CHANGE**2 / S,
    (*STEPS, WHEEL_3),
)
POSITION_SCALE = Scale(
    "the value or its largest term, and what the roundings of y make of it",
    sp.Max(sp.Abs(VALUE), sp.Abs(y * sp.sin(phi1)) / R, swing * sp.Abs(sp.sin(phi1)) / R)
    + sp.Abs(both * T * CHANGE) / (2 * S),
    (*STEPS, (swing, GIVEN[swing]), (R, sp.sqrt(S)), (VALUE, POSITION_FORM.xreplace(OF_T))),
)
ACCELERATION_SCALE = Scale(
    "the value or its largest term, and what the roundings of y make of it",
    W
    / S
    * (
        2
        * sp.Max(
            sp.Abs(Z),
            sp.Abs(y * (rise - shift * T)),
            less * sp.Abs(rise) * (1 + T**2),
            swing * (less + both) * sp.Abs(T),
            2 * less * shift * sp.Abs(T),
            sp.Abs(y * (rise + shift * T)) / 2,
        )
        + sp.Abs((rise - shift * T - 4 * (less + y) * Z / S) * CHANGE)
    ),
    (*STEPS, WHEEL_3, (swing, GIVEN[swing]), (Z, sum(TILT).xreplace(OF_T))),
)

# Products with an eccentricity and the angle or the mount stay above the subnormals, with all
# their digits.
NO_UNDERFLOW = (
    sp.Or(
        sp.Eq(phi1, 0),
        sp.Eq(e1 + e2, 0),
        sp.Ge(sp.Abs(phi1) * (e1 + e2), sp.Rational(1, 2**960)),
    ),
    sp.Or(sp.Eq(mount, 0), sp.Eq(e2, 0), sp.Ge(sp.Abs(mount) * e2, sp.Rational(1, 2**830))),
)

# A cylindrical pair 4-5 -----------------------------------------------------------------------

# The ratio is farthest from 1 and nearest to it; equal circles; double zeros of the ratio; the
# round and the flat oval.
SINGULAR_CYLINDERS = tuple(
    map(
        Singular,
        (
            sp.Eq(x, 2 * sp.pi * m),
            sp.Eq(x, sp.pi + 2 * sp.pi * m),
            sp.Eq(R4, R5),
            sp.Eq(k * (1 - e2), 1 + e2),
            sp.Eq(k * (1 + e2), 1 - e2),
            sp.Eq(e2, 0),
            sp.Eq(e2, 1),
        ),
    )
)

# With the low word, x is known to eps**2 relative, and what is left are the roundings of some 20
# operations, tan and atan within an ulp; the bounds are what searches for the worst input hold.
# What the error of x itself makes, eps**2*|x| times the slope, counts where the acceleration passes
# through zero, and beside it only far away near e2 = 1. The slope of the acceleration has the
# envelope of |sin x|, |cos x| <= 1.
LOW_WORD = (sp.Abs(x) <= 2**26,)
NO_UNDERFLOW_OF_LEAD = (
    sp.Or(sp.Eq(phi1, 0), sp.Eq(e2, 0), sp.Ge(sp.Abs(phi1) * e2, sp.Rational(1, 2**960))),
)
# Beside half turns of x the acceleration divides by a power of the tangent before it multiplies.
NO_UNDERFLOW_OF_QUOTIENT = (sp.Or(sp.Eq(e2, 0), sp.Ge(e2, sp.Rational(1, 2**660))),)
EPS_X = EPS * sp.Abs(x)
OF_X = ((k, GIVEN[k]), (x, GIVEN[x]))
LEAD = sp.atan2(e2 * sp.sin(x), 1 - e2 * sp.cos(x))
RATIO_CYLINDRICAL_SCALE = Scale(
    "the larger of 1 and 1 - value, and what eps*x makes of it",
    sp.Max(1, 1 - RATIO_CYLINDRICAL) + EPS_X * sp.Abs(sp.diff(RATIO_CYLINDRICAL, x)),
    OF_X,
)
POSITION_CYLINDRICAL_SCALE = Scale(
    "the larger of both terms, and what eps*x makes of the second",
    sp.Max(sp.Abs((R5 - R4) / R5 * phi1), sp.Abs(LEAD)) + EPS_X * sp.Abs(sp.diff(LEAD, x)),
    OF_X,
)
ACCELERATION_CYLINDRICAL_SCALE = Scale(
    "the value and what eps*x makes of it",
    sp.Abs(ACCELERATION_CYLINDRICAL)
    + EPS_X * 4 * e2 * k**2 * (1 - e2**2) / (1 + e2**2 - 2 * e2 * sp.cos(x)) ** 2,
    OF_X,
)

# Without it x = 2*k*phi1 is off by two roundings, eps*|x|. The slope of the arctangent in x lies
# between -e2/(1 + e2) and e2/(1 - e2), so the plain product costs at most 2*k*e2/(1 - e2) eps of
# |phi1|. Where k*e2/(1 - e2) <= |1 - k| that is half the bound, whatever phi1. The ratio and the
# acceleration lose some |x|*e2/(1 - e2) eps, however small the eccentricity: they have no such
# threshold but e2 = 0.
PLAIN_PRODUCT = R4 * e2 <= sp.Abs(R5 - R4) * (1 - e2)

BRANCH_OF_X = Part("|x| < pi, the first branch", {x: sp.Interval.open(-sp.pi, sp.pi)})


def over_turns(code: Written) -> Statement:
    """State the form at x + 2*pi*m for |x| < pi, where its floor is m."""
    form = code.output(x)
    (count,) = form.atoms(sp.floor)
    whole = phi1 - driven_angle(e2, x / 2)
    at_turn = {x: x + 2 * sp.pi * turns}
    return Conjunction(
        (
            Equality(form.xreplace({count: turns}).subs(at_turn), whole.subs(at_turn)),
            Equality(whole, POSITION_CYLINDRICAL),
        )
    )


SOURCE = "Prikhodko et al. 2024 (oval wheels)"
HALF_ANGLE = (1 - e2) ** 2 + 4 * e2 * sp.sin(x / 2) ** 2

QUANTITIES = (
    Quantity(
        "ratio",
        "Compute the transmission ratio d phi3/d phi1 of the output wheel to the carrier.",
        OF_OVALS,
        RATIO,
        (
            Form("quotient in tan(phi1)", 1 - WHEEL_3_FORM, states=ratio_by_parts),
            Form(
                "printed (3)-(6), (10)",
                -print_10.subs(PRINTED_RADII).subs(a, 1),
                key="printed",
                states=as_printed,
                source=f"{SOURCE}, equations (3)-(6) and (10)",
                note="the print with its sign reversed, wheel 6 at its mounted angle; proved to be "
                "the speed of wheel 3, which the row on any mount has for the map",
            ),
            Form(
                "double angles",
                ratio_of_map(*DOUBLE),
                key="direct",
                states=ratio_by_map,
            ),
        ),
        f"{SOURCE}, equation (10)",
        accuracy=Accuracy(8, RATIO_SCALE),
        singular=SINGULAR_OVALS,
    ),
    Quantity(
        "position",
        "Compute the position function phi3(phi1) of the output wheel, phi3(0) = 0.",
        OF_OVALS,
        POSITION,
        (
            Form("one arctangent of tan(phi1)", POSITION_FORM, states=position_by_parts),
            Form(
                "leads by atan2, 1 - e cos 2 phi",
                phi1 - phi6_closed - lead(e2, phi6_closed + mount) + lead(e2, mount),
                key="atan2",
                states=through_pairs,
                note="proved for each pair; the rows on any mount put the pairs in series",
            ),
            Form(
                "tan/arctan + floor",
                phi1 - count_branches(e2, phi6_counted + mount) + mount_counted,
                key="floor",
                states=over_branches,
                on=BRANCHES,
                note="proved to be that by atan2, for each angle beside pi m; the computed floor "
                "and tangent disagree at the ends",
            ),
            Form(
                "one atan2, unsplit",
                sp.atan2(
                    t * (gamma_double * t - alpha_double + beta_double),
                    beta_double + gamma_double * t + alpha_double * t**2,
                ),
                key="unsplit",
                states=position_by_map,
            ),
        ),
        f"{SOURCE}, integral (11)",
        unit="rad",
        accuracy=Accuracy(4, POSITION_SCALE, NO_UNDERFLOW),
        singular=SINGULAR_OVALS,
        period=sp.pi,
    ),
    Quantity(
        "acceleration",
        "Compute d ratio/d phi1, the angular acceleration of the output at unit carrier speed.",
        OF_OVALS,
        ACCELERATION,
        (
            Form(
                "quotient in tan(phi1)",
                ACCELERATION_FORM,
                ("low_product",),
                states=acceleration_by_parts,
            ),
            Form(
                "double angles",
                sp.diff(ratio_of_map(*DOUBLE), phi1),
                key="direct",
                states=acceleration_by_map,
            ),
        ),
        f"{SOURCE}, derivative of (10)",
        accuracy=Accuracy(10, ACCELERATION_SCALE, NO_UNDERFLOW),
        singular=SINGULAR_OVALS,
    ),
    Quantity(
        "ratio_cylindrical",
        "Compute the ratio d phi3/d phi1 with a cylindrical pair 4-5.",
        OF_CYLINDERS,
        RATIO_CYLINDRICAL,
        (
            Form(
                "half-angle quotient with low word",
                RATIO_CYLINDRICAL,
                ("low_word", "half_angle_tangent"),
            ),
            Form(
                "printed (4), (10)",
                -print_10.subs({rho5: R5, rho6: print_radius(e2, x / 2)}).subs(a, (R4 + R5) / 2),
                key="printed",
                source=f"{SOURCE}, equations (4) and (10)",
                note="the print with its sign reversed",
            ),
            Form("half-angle sine", 1 - k * (1 - e2) * (1 + e2) / HALF_ANGLE, key="half_angle"),
        ),
        f"{SOURCE}, equation (10), pair 4-5 cylindrical",
        accuracy=Accuracy(8, RATIO_CYLINDRICAL_SCALE, LOW_WORD),
        singular=SINGULAR_CYLINDERS,
    ),
    Quantity(
        "position_cylindrical",
        "Compute the position function phi3(phi1) with a cylindrical pair 4-5, phi3(0) = 0.",
        OF_CYLINDERS,
        POSITION_CYLINDRICAL,
        (
            Form(
                "half-angle atan",
                POSITION_CYLINDRICAL,
                ("positive_atan2", "half_angle_tangent"),
                when=PLAIN_PRODUCT,
            ),
            Form(
                "half-angle atan with low word",
                POSITION_CYLINDRICAL,
                ("positive_atan2", "low_word", "half_angle_tangent"),
            ),
            Form("atan2, 1 - e cos x", (1 - k) * phi1 - LEAD, key="atan2"),
            Form(
                "atan2, no cancellation",
                (1 - k) * phi1 - sp.atan2(e2 * sp.sin(x), nearest + 2 * e2 * sp.sin(x / 2) ** 2),
                key="atan2_stable",
            ),
            Form(
                "tan/arctan + floor",
                phi1 - count_branches(e2, x / 2),
                key="floor",
                states=over_turns,
                on=BRANCH_OF_X,
                note="proved for |x - 2 pi m| < pi; the computed floor and tangent disagree at "
                "the ends",
            ),
        ),
        f"{SOURCE}, integral (11), pair 4-5 cylindrical",
        unit="rad",
        accuracy=Accuracy(4, POSITION_CYLINDRICAL_SCALE, (*LOW_WORD, *NO_UNDERFLOW_OF_LEAD)),
        singular=SINGULAR_CYLINDERS,
        period=sp.pi,
    ),
    Quantity(
        "acceleration_cylindrical",
        "Compute d ratio/d phi1 with a cylindrical pair 4-5.",
        OF_CYLINDERS,
        ACCELERATION_CYLINDRICAL,
        (
            Form(
                "half-angle quotient with low word",
                ACCELERATION_CYLINDRICAL,
                ("low_word", "half_angle_tangent"),
            ),
            Form("1 + e**2 - 2 e cos x", ACCELERATION_CYLINDRICAL, key="direct"),
        ),
        f"{SOURCE}, derivative of (10), pair 4-5 cylindrical",
        accuracy=Accuracy(
            8,
            ACCELERATION_CYLINDRICAL_SCALE,
            (*LOW_WORD, *NO_UNDERFLOW_OF_LEAD, *NO_UNDERFLOW_OF_QUOTIENT),
        ),
        singular=SINGULAR_CYLINDERS,
    ),
)
