"""Sizes of paper 1 from what its ratio is wanted to be: the inverses of its extremes.

Written without differences of like numbers but those that the wanted ratios themselves make.
"""

from sympy import Eq, Expr, Integer, diff, sqrt

from mechproof.record import *

from . import charts
from .kernels import ARGUMENTS, SOURCE
from .mechanics import *

ONE = Integer(1)
# With r = (1 + e)/(1 - e) the largest ratio is 1 + k*r and the smallest 1 + k/r.
OF_LARGEST = (largest_wanted - 1 - k) / (largest_wanted - 1 + k)
OF_SMALLEST = (k - (smallest_wanted - 1)) / (k + (smallest_wanted - 1))
EXCESS = quotient_wanted - 1
ROOT_OF_QUOTIENT = sqrt(EXCESS**2 + 4 * k**2 * quotient_wanted)
OF_QUOTIENT = (
    EXCESS
    * (1 + (EXCESS + 4 * k**2) / (ROOT_OF_QUOTIENT + 2 * k))
    / (EXCESS + 2 * k + ROOT_OF_QUOTIENT)
)
SPAN = non_uniformity_wanted * (1 + k) / k
OF_NON_UNIFORMITY = SPAN / (2 + sqrt(4 + SPAN**2))
OF_BOTH = (largest_wanted - smallest_wanted) / (
    sqrt(largest_wanted - 1) + sqrt(smallest_wanted - 1)
) ** 2
RADII_OF_BOTH = sqrt((largest_wanted - 1) * (smallest_wanted - 1))

REACHED_LARGEST = Part("largest >= 1 + R1/R2", where=((largest_wanted - 1) * R2 >= R1,))
REACHED_SMALLEST = Part("smallest <= 1 + R1/R2", where=((smallest_wanted - 1) * R2 <= R1,))
REACHED_BOTH = Part(
    "smallest <= largest and R1 > R2",
    where=(smallest_wanted <= largest_wanted, (largest_wanted - 1) * (smallest_wanted - 1) > 1),
)


def inverse_row(
    number: str,
    quantities: tuple[str, ...],
    latex: str,
    *parts: tuple[Expr, Expr],
    on: Part | None = None,
) -> Claim:
    """State that sizes so found have the ratios that are wanted."""
    return ours(
        f"design, {number}",
        latex,
        all_of(*(Equality(found, wanted) for found, wanted in parts)),
        on=on,
        quantities=quantities,
    )


DESIGN_ROWS = (
    inverse_row(
        "largest ratio",
        ("eccentricity_of_largest_ratio",),
        r"e=\frac{i_{\max}-1-k}{i_{\max}-1+k},\ k=\tfrac{R_1}{R_2}",
        (largest.subs(e, OF_LARGEST), largest_wanted),
        on=REACHED_LARGEST,
    ),
    inverse_row(
        "smallest ratio",
        ("eccentricity_of_smallest_ratio",),
        r"e=\frac{k+1-i_{\min}}{k-1+i_{\min}}",
        (smallest.subs(e, OF_SMALLEST), smallest_wanted),
        on=REACHED_SMALLEST,
    ),
    inverse_row(
        "quotient of the extremes",
        ("eccentricity_of_quotient",),
        r"q=\tfrac{i_{\max}}{i_{\min}}:\ \frac{1+e}{1-e}=\frac{q-1+\sqrt{(q-1)^2+4k^2q}}{2k}",
        (largest.subs(e, OF_QUOTIENT), quotient_wanted * smallest.subs(e, OF_QUOTIENT)),
        ((1 + OF_QUOTIENT) / (1 - OF_QUOTIENT), (EXCESS + ROOT_OF_QUOTIENT) / (2 * k)),
    ),
    inverse_row(
        "non-uniformity",
        ("eccentricity_of_non_uniformity",),
        r"\delta=\tfrac{i_{\max}-i_{\min}}{1+k}:\ e=\frac n{2+\sqrt{4+n^2}},\ n=\delta\tfrac{1+k}k",
        (non_uniformity.subs(e, OF_NON_UNIFORMITY), non_uniformity_wanted),
    ),
    inverse_row(
        "both extremes",
        ("eccentricity_of_extremes", "radii_of_extremes"),
        r"k=\sqrt{(i_{\max}-1)(i_{\min}-1)},\ "
        r"e=\frac{i_{\max}-i_{\min}}{(\sqrt{i_{\max}-1}+\sqrt{i_{\min}-1})^2}",
        (1 + RADII_OF_BOTH * (1 + OF_BOTH) / (1 - OF_BOTH), largest_wanted),
        (1 + RADII_OF_BOTH * (1 - OF_BOTH) / (1 + OF_BOTH), smallest_wanted),
        on=REACHED_BOTH,
    ),
    ours(
        "design, one eccentricity at most",
        r"\frac{\partial i_{\max}}{\partial e}>0,\ \frac{\partial i_{\min}}{\partial e}<0,\ "
        r"\frac{\partial}{\partial e}\frac{i_{\max}}{i_{\min}}>0,\ "
        r"\frac{\partial\delta}{\partial e}>0",
        all_of(
            less(0 * e, diff(largest, e)),
            less(diff(smallest, e), 0 * e),
            less(0 * e, diff(largest / smallest, e)),
            less(0 * e, diff(non_uniformity, e)),
        ),
        note="At e = 0 they are 1 + k, 1 + k, 1 and 0; as e nears 1 the largest ratio, the "
        "quotient and the non-uniformity pass every limit and the smallest ratio nears 1.",
        quantities=(
            "eccentricity_of_largest_ratio",
            "eccentricity_of_smallest_ratio",
            "eccentricity_of_quotient",
            "eccentricity_of_non_uniformity",
        ),
    ),
)

# Accuracy, in eps: of the difference the roundings of i - 1 and of k remain, 1/2 of i - 1 + k, and
# with its own, those of the sum and that of the quotient 2.5 of 1. The rest are sums and roots of
# positive terms; all roundings in one direction make 9, 6, 4 and 2 of the value.
IN_UNITS = Scale("1", ONE)
RADII = ARGUMENTS[1:3]
MODERATE = (R1 <= 10**100 * R2,)


def ratio_argument(name: str, symbol: Expr, meaning: str, *usual: float) -> Argument:
    """Make an argument that says what is wanted."""
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
    """Make a quantity of what is wanted."""
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


DESIGN_QUANTITIES = (
    inverse(
        "eccentricity_of_largest_ratio",
        "Compute the eccentricity at which the largest ratio has a wanted value.",
        (WANT_LARGEST, *RADII),
        OF_LARGEST,
        Accuracy(2.5, IN_UNITS, MODERATE),
        charts.FOR_LARGEST,
        REACHED_LARGEST,
        (Singular(Eq(largest_wanted, 1 + k)),),
    ),
    inverse(
        "eccentricity_of_smallest_ratio",
        "Compute the eccentricity at which the smallest ratio has a wanted value.",
        (WANT_SMALLEST, *RADII),
        OF_SMALLEST,
        Accuracy(2.5, IN_UNITS, MODERATE),
        charts.FOR_SMALLEST,
        REACHED_SMALLEST,
        (Singular(Eq(smallest_wanted, 1 + k)),),
    ),
    inverse(
        "eccentricity_of_quotient",
        "Compute the eccentricity at which the largest ratio is a wanted multiple of the smallest.",
        (ratio_argument("quotient", quotient_wanted, "largest over smallest ratio", 1, 20), *RADII),
        OF_QUOTIENT,
        Accuracy(9, within=(*MODERATE, quotient_wanted <= 10**100)),
        charts.FOR_QUOTIENT,
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
        OF_NON_UNIFORMITY,
        Accuracy(6, within=(*MODERATE, non_uniformity_wanted <= 10**50)),
        charts.FOR_NON_UNIFORMITY,
        singular=(Singular(Eq(non_uniformity_wanted, 0)),),
        # Near a ratio that does not vary they would cancel.
        slopes=None,
    ),
    inverse(
        "eccentricity_of_extremes",
        "Compute the eccentricity at which both extremes of the ratio have wanted values.",
        (WANT_LARGEST, WANT_SMALLEST),
        OF_BOTH,
        Accuracy(4),
        charts.FOR_EXTREMES,
        REACHED_BOTH,
        (Singular(Eq(largest_wanted, smallest_wanted)),),
    ),
    inverse(
        "radii_of_extremes",
        "Compute R1/R2 at which both extremes of the ratio have wanted values.",
        (WANT_LARGEST, WANT_SMALLEST),
        RADII_OF_BOTH,
        Accuracy(2),
        charts.FOR_EXTREMES,
        REACHED_BOTH,
    ),
)
