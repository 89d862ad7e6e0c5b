"""Quantities for the design of paper 1: sizes from the ratio that is wanted."""

from sympy import Eq, Expr, Interval, Rational, S, Symbol

from mechproof.record import *

from ..._eccentric import D
from ..mechanics import *
from ..rows import design
from .charts import FREE, INVERSE, RADIUS
from .motion import ARGUMENTS, SOURCE

# The wanted quantity apart from the radii.
PART = Symbol("part", positive=True)


def wish(wanted: Symbol, value: Expr, inverse: Expr = INVERSE) -> Chart:
    """Return the chart of a wanted quantity, by 1/k and a share."""
    arguments = {R1: RADIUS, R2: inverse * RADIUS, wanted: value}
    return Chart("", arguments, {**FREE, PART: Interval(0, 1)})


FOR_LARGEST = (wish(largest_wanted, 1 + 1 / (INVERSE * PART)),)
FOR_SMALLEST = (wish(smallest_wanted, 1 + PART / INVERSE),)
FOR_NON_UNIFORMITY = tuple(wish(non_uniformity_wanted, value) for value in (PART, 1 / PART))
# Beyond 2, by whether it or k**2 is larger.
FOR_QUOTIENT = (
    wish(quotient_wanted, 1 + PART),
    wish(quotient_wanted, 1 + 1 / (INVERSE**2 * PART)),
    wish(quotient_wanted, 1 + 1 / INVERSE**2, INVERSE * PART),
)
# The largest ratio is beyond 2; the smallest is nearly as large, or not.
INVERSE_ROOT = Symbol("1/sqrt(i - 1)", positive=True)
FOR_EXTREMES = tuple(
    Chart(
        "",
        {largest_wanted: 1 + 1 / INVERSE_ROOT**2, smallest_wanted: 1 + share / INVERSE_ROOT**2},
        {INVERSE_ROOT: Interval(0, 1), part: Interval(0, Rational(3, 4))},
    )
    for share, part in ((1 - D, D), (PART**2, PART))
)

# Accuracy, in eps: for the difference, the roundings of i - 1 and of k remain, 1/2 of i - 1 + k,
# and together with its own, that of the sum and that of the quotient 2.5 of 1. The rest are sums
# and roots of positive terms; all roundings in one direction make 9, 6, 4 and 2 of the value.
IN_UNITS = Scale("1", S.One)
RADII = ARGUMENTS[1:3]
MODERATE = (R1 <= 10**100 * R2,)


def ratio_argument(name: str, symbol: Expr, meaning: str, *usual: float) -> Argument:
    """Return an argument for a wanted quantity."""
    return Argument(name, (symbol,), meaning, usual=usual)


WANT_LARGEST = ratio_argument("largest", largest_wanted, "largest ratio wanted", 2, 20)
WANT_SMALLEST = ratio_argument("smallest", smallest_wanted, "smallest ratio wanted", 1.1, 5)


def inverse(
    name: str,
    summary: str,
    arguments: tuple[Argument, ...],
    value: Expr,
    accuracy: Accuracy,
    covering: tuple[Chart, ...],
    on: Part | None = None,
    singular: tuple[Singular, ...] = (),
    slopes: Accuracy | None = SLOPES,
) -> Quantity:
    """Return a quantity that computes sizes from wanted ones."""
    return Quantity(
        name,
        summary,
        arguments,
        value,
        (Form("quotient", value, charts=covering),),
        f"inverse of the extremes of {SOURCE}, equation (8)",
        accuracy=accuracy,
        on=on,
        singular=singular,
        slopes=slopes,
    )


QUANTITIES = (
    inverse(
        "eccentricity_of_largest_ratio",
        "Compute the eccentricity at which the largest ratio has a wanted value.",
        (WANT_LARGEST, *RADII),
        design.OF_LARGEST,
        Accuracy(2.5, IN_UNITS, MODERATE),
        FOR_LARGEST,
        design.REACHED_LARGEST,
        (Singular(Eq(largest_wanted, 1 + k)),),
    ),
    inverse(
        "eccentricity_of_smallest_ratio",
        "Compute the eccentricity at which the smallest ratio has a wanted value.",
        (WANT_SMALLEST, *RADII),
        design.OF_SMALLEST,
        Accuracy(2.5, IN_UNITS, MODERATE),
        FOR_SMALLEST,
        design.REACHED_SMALLEST,
        (Singular(Eq(smallest_wanted, 1 + k)),),
    ),
    inverse(
        "eccentricity_of_quotient",
        "Compute the eccentricity at which the largest ratio is a wanted multiple of the smallest.",
        (ratio_argument("quotient", quotient_wanted, "largest over smallest ratio", 1, 20), *RADII),
        design.OF_QUOTIENT,
        Accuracy(9, within=(*MODERATE, quotient_wanted <= 10**100)),
        FOR_QUOTIENT,
        singular=(Singular(Eq(quotient_wanted, 1)),),
    ),
    inverse(
        "eccentricity_of_non_uniformity",
        "Compute the eccentricity for a wanted (largest - smallest ratio)/(mean ratio).",
        (
            ratio_argument(
                "non_uniformity",
                non_uniformity_wanted,
                "(largest - smallest ratio)/(mean ratio) wanted",
                0,
                10,
            ),
            *RADII,
        ),
        design.OF_NON_UNIFORMITY,
        Accuracy(6, within=(*MODERATE, non_uniformity_wanted <= 10**50)),
        FOR_NON_UNIFORMITY,
        singular=(Singular(Eq(non_uniformity_wanted, 0)),),
        # Near a ratio that does not vary they would cancel.
        slopes=None,
    ),
    inverse(
        "eccentricity_of_extremes",
        "Compute the eccentricity at which both extremes of the ratio have wanted values.",
        (WANT_LARGEST, WANT_SMALLEST),
        design.OF_BOTH,
        Accuracy(4),
        FOR_EXTREMES,
        design.REACHED_BOTH,
        (Singular(Eq(largest_wanted, smallest_wanted)),),
    ),
    inverse(
        "radii_of_extremes",
        "Compute R1/R2 at which both extremes of the ratio have wanted values.",
        (WANT_LARGEST, WANT_SMALLEST),
        design.RADII_OF_BOTH,
        Accuracy(2),
        FOR_EXTREMES,
        design.REACHED_BOTH,
    ),
)
