"""Quantities of paper 1: ratio, position and acceleration, and every form of them."""

from collections.abc import Callable

import sympy as sp

from mechproof.record import *
from mechproof.record.parts import differentiate

from ..._algebra import EPS
from ..._eccentric import by_half_angle, directly, on_branch
from ..mechanics import *
from ..rows.position import print_8, print_12
from .charts import (
    BY_SIZES,
    ECCENTRIC,
    FAR,
    MOST_PLAIN,
    PEAKS,
    PLAIN_CHART,
    ROUNDER,
    SMOOTH,
)

ARGUMENTS = (
    Argument("phi1", (phi1,), "carrier angle, any number of turns", "rad", usual=(0, 10, 1000)),
    Argument("R1", (R1,), "radius of the epicycle", "mm"),
    Argument("R2", (R2,), "radius of the satellite's cylindrical wheel", "mm"),
    Argument("e", (e,), "eccentricity of the ellipse", usual=(0, 0.28, 0.5, 0.9, 0.99, 1)),
)

ENDS_OF_E = (Singular(sp.Eq(e, 1)), Singular(sp.Eq(e, 0)))
SINGULAR = (
    Singular(sp.Eq(x, 2 * sp.pi * turns)),
    Singular(sp.Eq(x, sp.pi + 2 * sp.pi * turns)),
    *ENDS_OF_E,
)

# Accuracy. With the low word, x is known to eps**2 relative; the roundings of some 20 operations
# remain, tan and atan within an ulp; the bounds below leave room for all of them in one direction.
# The effect of the error of x itself, eps**2*|x| times the slope, matters where the acceleration
# passes through zero and, far away, where e is so near to 1 that the peak of the ratio is narrower
# than eps*|x|; the slopes have the envelope of |sin x|, |cos x| <= 1. The proved bounds, and the
# worst errors found, are in the certificates.
# Below 1e-290 the products with phi1 lose bits to the range of doubles.
LEAST = sp.Rational(1, 10**300)
LOW_WORD = (
    sp.Abs(x) <= 2**26,
    sp.Or(sp.Eq(phi1, 0), sp.Abs(phi1) >= sp.Rational(1, 10**290)),
    R1 >= LEAST,
    R2 >= LEAST,
)
# k**2, and its divisor where e is next to 1.
SQUARE_OF_SPEED = R1 <= 10**130 * R2
SLOPE = 2 * e * k**2 * (1 - e**2) / (1 + e**2 - 2 * e * sp.cos(x)) ** 2
EPS_X = EPS * sp.Abs(x)
RATIO_SCALE = Scale("the value and the effect of eps*x", RATIO + EPS_X * SLOPE / k)
ACCELERATION_SCALE = Scale(
    "the value and the effect of eps*x", sp.Abs(ACCELERATION) + EPS_X * SLOPE
)

# Without it x = k*phi1 is off by two roundings, eps*|x|. The slope of the arctangent in x lies
# between -2*e/(1 + e) and 2*e/(1 - e), by the extremes of the ratio, and is steepest at whole
# turns, where |x| < |position|: there the plain product costs 2*e/(1 - e) eps of the value, and at
# most 1 % more just before, where the arctangent is negative. Up to e = 12/25 that is 1.85 eps,
# whatever phi1 and R1/R2 are, which leaves room below 4 eps for the other roundings. The ratio and
# the acceleration lose some |x| times 2*e/(1 - e) eps, however small the eccentricity is: they have
# no such threshold except e = 0.
PLAIN_PRODUCT = e <= MOST_PLAIN

HALF_ANGLE = (1 - e) ** 2 + 4 * e * sp.sin(x / 2) ** 2


def over_turns(code: EmittedForm) -> Statement:
    """State the form at x + 2*pi*m for |x| < pi, where its floor is m."""
    whole = phi1 + x + 2 * sp.atan2(e * sp.sin(x), 1 - e * sp.cos(x))
    return on_branch(code.output(x), whole, {x: x + 2 * sp.pi * turns}, turns)


# Fourier series. Cut off after n terms, its error starts with slope 0 at x = 0, where it vanishes,
# and has the slope of `remainder` with e**n, n*x. Each further term takes no more from that than
# `tail` falls, and both go to 0 with e**n: the error stays below `tail`. E stands for e**n and T
# for n*x, so that one step proves every n.
def remainder(power: sp.Expr, angle: sp.Expr) -> sp.Expr:
    """Slope of the remainder of the series, power = e**n and angle = n*x."""
    return 2 * power * e * (sp.cos(angle + x) - e * sp.cos(angle)) / (1 + e**2 - 2 * e * sp.cos(x))


def tail(power: sp.Expr, terms: sp.Expr) -> sp.Expr:
    """Bound of the remainder of the series after `terms` terms, power = e**terms."""
    return 2 * power * e / ((terms + 1) * (1 - e))


STEP_OF_SERIES = (
    Equality(remainder(E, T) - remainder(E * e, T + x), 2 * E * e * sp.cos(T + x)),
    Holds(sp.Ge(tail(E, nu) - tail(E * e, nu + 1), 2 * E * e / (nu + 1))),
)


def by_series(terms: int) -> Callable[[EmittedForm], Statement]:
    """Return the statement that a form is the series cut off after `terms` terms."""

    def states(code: EmittedForm) -> Statement:
        form = code.output(x)
        return all_of(
            Equality(form.subs(x, 0), (1 + k) * phi1),
            Equality(
                differentiate(position_closed, x) - differentiate(form, x),
                remainder(e**terms, terms * x),
            ),
            *STEP_OF_SERIES,
        )

    return states


def cut_series(terms: int) -> sp.Expr:
    """Return the position by the series cut off after `terms` terms."""
    return (1 + k) * phi1 + sum(
        sp.Rational(2, m) * e**m * sp.sin(m * x) for m in range(1, terms + 1)
    )


# Roundings of float32, u = 2**-24, in Clenshaw's recurrence b_m = a_m + 2 cos(y) b_(m+1) - b_(m+2):
# |b_m| <= 2 e**m/(1 - e), and an error d in b_m moves the sum by |sin(m y)*d| <= |d|. A step loses
# 3u |2 cos(y) b_(m+1)| + 2u |b_(m+2)| + u |b_m|, the cosine 3u of itself; coefficients and y lose
# u, the sine 3u and the product u. Up to |x| = 2**26 x, rounded twice, and its reduction lose
# 2**-26 each, as do the two sums in double.
IN_SINGLE = (e * (2 + 24 * e + 4 * e**2) / (1 - e) ** 2 + 17 * e / (1 - e)) / 2**24 + sp.Rational(
    1, 2**24
)


def fourier(terms: int, single: bool = False) -> Form:
    """Return the form of a series cut off after `terms` terms, in doubles or in float32."""
    bound = tail(e**terms, sp.Integer(terms))
    return Form(
        f"Fourier series, {terms} terms" + (", float32" if single else ""),
        cut_series(terms),
        ("clenshaw", "in_single") if single else ("clenshaw",),
        key=f"fourier_{terms}" + ("_single" if single else ""),
        bound=bound + IN_SINGLE if single else bound,
        states=by_series(terms),
        note="the bound includes the roundings of float32, |x| <= 2**26" if single else "",
    )


# Roundings of k, 1 + e and 1 - e, of a product, a quotient of positive terms and their sum with 1:
# 1/2 eps each, 3 eps if all are in one direction.
EXTREME = Accuracy(3, within=(R1 <= 10**300 * R2,))

HALF_TANGENT = sp.tan(x / 2)
SOURCE = "Prikhodko et al. 2024"
EXTREMES = f"extremes of {SOURCE}, equation (8)"
QUANTITIES = (
    Quantity(
        "ratio",
        "Compute the transmission ratio d phi3/d phi1 of the output wheel to the carrier.",
        ARGUMENTS,
        RATIO,
        (
            by_half_angle(RATIO, (*ECCENTRIC, ROUNDER, *PEAKS, FAR)),
            Form(
                "printed (8)",
                print_8.subs(phi5, -x),
                key="printed",
                source=f"{SOURCE}, equation (8)",
            ),
            Form("half-angle sine", 1 + k * (1 - e) * (1 + e) / HALF_ANGLE, key="half_angle"),
        ),
        f"{SOURCE}, equation (8)",
        accuracy=Accuracy(10, RATIO_SCALE, LOW_WORD),
        singular=SINGULAR,
        periodicity=Periodicity(2 * sp.pi / k),
    ),
    Quantity(
        "position",
        "Compute the position function phi3(phi1) of the output wheel, phi3(0) = 0.",
        ARGUMENTS,
        position_closed,
        (
            Form(
                "half-angle atan",
                position_closed,
                ("positive_atan2", "half_angle_tangent", "small_arc"),
                when=PLAIN_PRODUCT,
                charts=(PLAIN_CHART,),
            ),
            Form(
                "half-angle atan with low word",
                position_closed,
                ("positive_atan2", "low_word", "low_sum", "half_angle_tangent", "quotient_arc"),
                charts=(*ECCENTRIC, ROUNDER, *PEAKS, FAR),
            ),
            Form(
                "printed (12)",
                print_12,
                key="printed",
                source=f"{SOURCE}, equation (12)",
                note="its derivative is not the ratio (8), and it jumps where x/2 passes pi/2",
            ),
            Form(
                "tan/arctan",
                position_principal,
                key="principal",
                holds_on=BRANCH,
                source=f"{SOURCE}, equation (12) with the factor of (11) corrected",
                note="right for |phi1| < pi*R2/R1, beyond that off by multiples of 2*pi",
            ),
            Form(
                "tan/arctan + floor",
                position_principal + 2 * sp.pi * sp.floor((x + sp.pi) / (2 * sp.pi)),
                key="floor",
                states=over_turns,
                on=BRANCH,
                note="proved for |x - 2 pi m| < pi; the computed floor and tangent disagree at "
                "the ends",
            ),
            Form("x + 2 atan2, 1 - e cos x", position_closed, key="atan2"),
            Form(
                "x + 2 atan2, no cancellation",
                (1 + k) * phi1 + 2 * sp.atan2(e * sp.sin(x), nearest + 2 * e * sp.sin(x / 2) ** 2),
                key="atan2_stable",
            ),
            Form(
                "tan-half, by hand",
                (1 + k) * phi1
                + 2 * sp.atan(2 * e * HALF_TANGENT / (nearest + (1 + e) * HALF_TANGENT**2)),
                key="tan_half",
            ),
            *map(fourier, (2, 4, 8)),
            *(fourier(terms, single=True) for terms in (2, 4, 8, 12)),
        ),
        f"{SOURCE}, integral (9) of equation (8)",
        unit="rad",
        accuracy=Accuracy(5.5, within=LOW_WORD),
        singular=SINGULAR,
        period=2 * sp.pi,
        periodicity=Periodicity(2 * sp.pi / k, 2 * sp.pi * (1 + k) / k),
    ),
    Quantity(
        "acceleration",
        "Compute d ratio/d phi1, the angular acceleration of the output at unit carrier speed.",
        ARGUMENTS,
        ACCELERATION,
        (
            by_half_angle(ACCELERATION, SMOOTH),
            directly(ACCELERATION),
            Form(
                "half-angle sine",
                -2 * e * k**2 * (1 - e) * (1 + e) * sp.sin(x) / HALF_ANGLE**2,
                key="half_angle",
            ),
        ),
        f"derivative of {SOURCE}, equation (8)",
        accuracy=Accuracy(
            16,
            ACCELERATION_SCALE,
            (*LOW_WORD, SQUARE_OF_SPEED, sp.Or(sp.Eq(e, 0), sp.Ge(e, sp.Rational(1, 10**200)))),
        ),
        singular=SINGULAR,
        periodicity=Periodicity(2 * sp.pi / k),
    ),
    Quantity(
        "largest_ratio",
        "Compute the largest transmission ratio, at phi1 = 0 and once in each period 2*pi*R2/R1.",
        ARGUMENTS[1:],
        largest,
        (Form("quotient", largest, charts=BY_SIZES),),
        EXTREMES,
        accuracy=EXTREME,
        singular=ENDS_OF_E,
    ),
    Quantity(
        "smallest_ratio",
        "Compute the smallest transmission ratio, met half a period after the largest.",
        ARGUMENTS[1:],
        smallest,
        (Form("quotient", smallest, charts=BY_SIZES),),
        EXTREMES,
        accuracy=EXTREME,
        singular=ENDS_OF_E,
    ),
)
