"""Forms, their proofs and the accuracy of the kernels of paper 2."""

from collections.abc import Callable

import sympy as sp

from mechproof.record import Accuracy, EmittedForm, Equality, Part, Scale, Statement, all_of

from ..._algebra import EPS
from ..._eccentric import on_branch
from ..mechanics import *
from ..rows.equations import print_radius

# All coefficients divided by 1 - e2, and beta + gamma*t split into lesser + y. y has the sine of
# the mounted wheel's angle as a factor and dominates the rest as e2 -> 1; rounded once, it enters
# both arguments of atan2, and its remainder where it vanishes is a single small angle.
POSITION_FORM = sp.atan2(t * (y - swing), lesser + y + both * t**2)
SPREAD_FORM = (lesser + y) ** 2 + both**2 * t**2
WHEEL_3_FORM = both * (lesser + shift) * (1 + t**2) / SPREAD_FORM
TILT = (
    y * (rise - shift * t),
    lesser * rise * (1 - t**2),
    (swing * (lesser + both) - 2 * lesser * shift) * t,
)
ACCELERATION_FORM = 2 * WHEEL_3_FORM * sum(TILT) / SPREAD_FORM

# Statements. The coefficients of the map are variables of their own, lambda, mu, nu, and the steps
# are those of the paper: so each proof deals only with its own subject.
PARTS = {both: lam, lesser: mu - xi, shift: xi, rise: nu, swing: lam - mu + xi}
DOUBLE = {alpha_double: lam, beta_double: mu, gamma_double: nu}
ANY_MAP = {alpha: lam, beta: mu, gamma: nu, delta: lam - mu}
SCALED_MAP = {s: (1 - e2) * value for s, value in ANY_MAP.items()}
BY_TANGENT = {
    sp.cos(2 * phi1): (1 - tangent**2) / (1 + tangent**2),
    sp.sin(2 * phi1): 2 * tangent / (1 + tangent**2),
}
TANGENT = tuple(Equality(f, by.subs(tangent, t)) for f, by in BY_TANGENT.items())


def of_parts(code: EmittedForm, *unused: sp.Symbol) -> tuple[Equality, ...]:
    """State that the emitted steps, times 1 - e2, are the coefficients of the map."""
    step = {part: code.step(part) for part in PARTS if part not in unused}
    sums = {
        alpha: step[both],
        beta: step[lesser] + step[shift],
        gamma: step[rise],
        delta: step.get(swing, step[both] - step[lesser]) - step[shift],
    }
    return tuple(Equality((1 - e2) * total, coefficient) for coefficient, total in sums.items())


def by_parts(definition: sp.Expr, *unused: sp.Symbol) -> Callable[[EmittedForm], Statement]:
    """Return the statement of a form in terms of the parts, and of the parts themselves."""

    def states(code: EmittedForm) -> Statement:
        form = code.output(*PARTS).xreplace(PARTS)
        return all_of(Equality(form, definition.xreplace(SCALED_MAP)), *of_parts(code, *unused))

    return states


def position_by_parts(code: EmittedForm) -> Statement:
    """State the position in terms of the parts, by the tangent, and the parts themselves."""
    form = code.output(*PARTS).xreplace({**PARTS, t: tangent})
    position = POSITION.xreplace(SCALED_MAP).xreplace(BY_TANGENT)
    return all_of(Equality(form, position), *TANGENT, *of_parts(code))


def of_double(code: EmittedForm) -> tuple[Equality, ...]:
    """State that the emitted steps are the coefficients of the map."""
    pairs = zip(DOUBLE, (alpha, beta, gamma), strict=True)
    return tuple(Equality(code.step(step), coefficient) for step, coefficient in pairs)


def by_map(definition: sp.Expr) -> Callable[[EmittedForm], Statement]:
    """Return the statement of a form for any map, and of the coefficients."""

    def states(code: EmittedForm) -> Statement:
        form = code.output(*DOUBLE).xreplace(DOUBLE)
        return all_of(Equality(form, definition.xreplace(ANY_MAP)), *of_double(code))

    return states


def position_by_map(code: EmittedForm) -> Statement:
    """State the position for any map, by the tangent, and the coefficients."""
    form = code.output(*DOUBLE).xreplace({**DOUBLE, t: tangent})
    position = POSITION.xreplace(ANY_MAP).xreplace(BY_TANGENT)
    return all_of(Equality(form, position), *TANGENT, *of_double(code))


# The double angle of wheel 6, by which the row on any mount combines the two pairs in series.
WHEEL_6 = (Equality(sp.cos(2 * phi6_closed), cos_6), Equality(sp.sin(2 * phi6_closed), sin_6))


def through_pairs(code: EmittedForm) -> Statement:
    """State that each pair integrates its ratio, and the double angle of wheel 6."""
    form = code.output(phi6_closed).xreplace({phi6_closed: phi6})
    of_first = pair_ratio(e1, COS_4).subs(phi1, tau)
    of_second = pair_ratio(e2, sp.cos(2 * (tau + mount)))
    return all_of(
        Equality(code.step(phi6_closed), sp.Integral(of_first, (tau, 0, phi1))),
        Equality(form, phi1 - sp.Integral(of_second, (tau, 0, phi6))),
        *WHEEL_6,
    )


def over_branches(code: EmittedForm) -> Statement:
    """State each pair at its angle + pi*m, |angle| < pi/2, where its floor is m."""
    form = code.output(phi6_counted, mount_counted).xreplace({phi6_counted: phi6})
    turned = sp.pi * turns
    of_second = phi1 - driven_angle(e2, phi6 + mount) + mount_counted
    return all_of(
        on_branch(code.step(phi6_counted), driven_angle(e1, phi1), {phi1: phi1 + turned}, turns),
        on_branch(
            code.step(mount_counted), driven_angle(e2, mount), {mount: mount + turned}, turns
        ),
        on_branch(form, of_second, {phi6: phi6 - mount + turned}, turns),
    )


def as_printed(code: EmittedForm) -> Statement:
    """State the speed of wheel 3 through both pairs at any angle of wheel 6, and that angle."""
    form = code.output(phi6_closed).xreplace({phi6_closed: phi6})
    second = pair_ratio(e2, sp.cos(2 * (phi6 + mount)))
    return all_of(
        Equality(1 - form, second / pair_ratio(e1, -sp.cos(2 * phi6))),
        Equality(1 / pair_ratio(e1, -cos_6), pair_ratio(e1, COS_4)),
        Equality(code.step(phi6_closed), phi6_closed),
        *WHEEL_6,
    )


QUARTER = sp.Interval.open(-sp.pi / 2, sp.pi / 2)
BRANCHES = Part("each angle is on its first branch", dict.fromkeys((phi1, phi6, mount), QUARTER))
PRINTED_RADII = {
    rho5: print_radius(e1, sp.pi / 2 - phi6_closed),
    rho6: print_radius(e2, phi6_closed + mount),
}

# Accuracy. The terms of y = shift + rise*t are rounded, and where they cancel, the value amplifies
# that in a way that no evaluation from a rounded tangent can avoid: up to 1/(1 - e2), where the
# major axes of the pair 6-3 meet away from phi1 = 0. So the scales are the largest term, plus the
# effect on the value of changing the terms of y against each other, 0 without a mount; at the peak
# of the ratio, where lesser + y vanishes, that is of second order in eps. The rest is some 20
# operations; the bounds are above the worst errors that long searches find, compiled.
# At its peak the acceleration goes with the cube of (1 - e1)*(1 - e2), three roundings if both
# eccentricities are below 1/2: 4 eps, which the rest of the product saves. With a mounted wheel two
# terms of similar size meet, each with roundings of its own.
T, R, S, W, Z, VALUE = sp.symbols("t R S W Z value", real=True)
OF_T = {t: T}
STEPS = (
    (T, t),
    *((step, GIVEN[step]) for step in (both, lesser, lever, rise, shift)),
    (y, GIVEN[y].xreplace(OF_T)),
    (S, SPREAD_FORM.xreplace(OF_T)),
)
WHEEL_3 = (W, both * (lesser + shift) * (1 + T**2) / S)
CHANGE = rise * T - shift
RATIO_SCALE = Scale(
    "the larger of 1 and W, and what the roundings of y make of it",
    sp.Max(1, W) + sp.Abs(W * (lesser + y) * CHANGE / S) + EPS * W * CHANGE**2 / S,
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
            lesser * sp.Abs(rise) * (1 + T**2),
            swing * (lesser + both) * sp.Abs(T),
            2 * lesser * shift * sp.Abs(T),
            sp.Abs(y * (rise + shift * T)) / 2,
        )
        + sp.Abs((rise - shift * T - 4 * (lesser + y) * Z / S) * CHANGE)
    ),
    (*STEPS, WHEEL_3, (swing, GIVEN[swing]), (Z, sum(TILT).xreplace(OF_T))),
)

# Products of an eccentricity with the angle or the mount stay above the subnormals, with all their
# digits.
NO_UNDERFLOW = (
    sp.Or(
        sp.Eq(phi1, 0), sp.Eq(e1 + e2, 0), sp.Ge(sp.Abs(phi1) * (e1 + e2), sp.Rational(1, 2**960))
    ),
    sp.Or(sp.Eq(mount, 0), sp.Eq(e2, 0), sp.Ge(sp.Abs(mount) * e2, sp.Rational(1, 2**830))),
)

# With the low word, x is known to eps**2 relative; the roundings of some 20 operations remain, tan
# and atan within an ulp; the bounds are above what searches find, as before. The effect of the
# error of x itself, eps**2*|x| times the slope, matters where the acceleration passes through zero,
# and otherwise only far away near e2 = 1. The slope of the acceleration has the envelope of |sin
# x|, |cos x| <= 1.
LOW_WORD = (sp.Abs(x) <= 2**26,)
NO_UNDERFLOW_OF_LEAD = (
    sp.Or(sp.Eq(phi1, 0), sp.Eq(e2, 0), sp.Ge(sp.Abs(phi1) * e2, sp.Rational(1, 2**960))),
)

# Next to half turns of x the acceleration divides by a power of the tangent before it multiplies.
NO_UNDERFLOW_OF_QUOTIENT = (sp.Or(sp.Eq(e2, 0), sp.Ge(e2, sp.Rational(1, 2**330))),)
# k**2, times a tiny e2, and divided by a tiny number where e2 is next to 1.
SQUARE_OF_SPEED = (R4 >= R5 / 10**45, R4 <= 10**130 * R5)
EPS_X = EPS * sp.Abs(x)
OF_X = ((k, GIVEN[k]), (x, GIVEN[x]))
LEAD = sp.atan2(e2 * sp.sin(x), 1 - e2 * sp.cos(x))
RATIO_CYLINDRICAL_SCALE = Scale(
    "the larger of 1 and 1 - value, and the effect of eps*x",
    sp.Max(1, 1 - RATIO_CYLINDRICAL) + EPS_X * sp.Abs(sp.diff(RATIO_CYLINDRICAL, x)),
    OF_X,
)
POSITION_CYLINDRICAL_SCALE = Scale(
    "the larger of both terms, and what eps*x makes of the second",
    sp.Max(sp.Abs((R5 - R4) / R5 * phi1), sp.Abs(LEAD)) + EPS_X * sp.Abs(sp.diff(LEAD, x)),
    OF_X,
)
ACCELERATION_CYLINDRICAL_SCALE = Scale(
    "the value and the effect of eps*x",
    sp.Abs(ACCELERATION_CYLINDRICAL)
    + EPS_X * 4 * e2 * k**2 * (1 - e2**2) / (1 + e2**2 - 2 * e2 * sp.cos(x)) ** 2,
    OF_X,
)

# Without it x = 2*k*phi1 is off by two roundings, eps*|x|. The slope of the arctangent in x lies
# between -e2/(1 + e2) and e2/(1 - e2), so the plain product costs at most 2*k*e2/(1 - e2) eps of
# |phi1|. Where k*e2/(1 - e2) <= |1 - k| that is half the bound, whatever phi1 is. The ratio and the
# acceleration lose some |x|*e2/(1 - e2) eps, however small the eccentricity is: they have no such
# threshold except e2 = 0.
PLAIN_PRODUCT = R4 * e2 <= sp.Abs(R5 - R4) * (1 - e2)

ACCURACY = {
    "ratio": Accuracy(10, RATIO_SCALE),
    "position": Accuracy(7, POSITION_SCALE, NO_UNDERFLOW),
    "acceleration": Accuracy(15, ACCELERATION_SCALE, NO_UNDERFLOW),
    "ratio_cylindrical": Accuracy(10, RATIO_CYLINDRICAL_SCALE, LOW_WORD),
    "position_cylindrical": Accuracy(
        7, POSITION_CYLINDRICAL_SCALE, (*LOW_WORD, *NO_UNDERFLOW_OF_LEAD)
    ),
    "acceleration_cylindrical": Accuracy(
        16,
        ACCELERATION_CYLINDRICAL_SCALE,
        (*LOW_WORD, *SQUARE_OF_SPEED, *NO_UNDERFLOW_OF_LEAD, *NO_UNDERFLOW_OF_QUOTIENT),
    ),
}
