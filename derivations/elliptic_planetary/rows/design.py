"""Sizes of paper 1 from the ratio that is wanted: the inverses of its extremes.

Written without differences of nearly equal numbers, except those of the wanted ratios themselves.
"""

from sympy import Expr, diff, sqrt

from mechproof.record import *

from ..mechanics import *

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
    """State that sizes found in this way have the wanted ratios."""
    return ours(
        f"design, {number}",
        latex,
        all_of(*(Equality(found, wanted) for found, wanted in parts)),
        on=on,
        quantities=quantities,
    )


ROWS = (
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
