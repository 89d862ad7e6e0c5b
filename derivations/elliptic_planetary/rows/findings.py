"""What is wrong in paper 1, what it costs, and how to see it."""

from sympy import Expr, Rational, S, Symbol, diff, pi

from mechproof.record import Check, Cost, Finding, Weight

from ..._readings import ADEQUACY, DEGREE, costs_of_mean, interval_finding
from ..mechanics import *
from .position import DX_SUPPLIED, print_8, print_12
from .readings import HALF_WIDTHS, LIMITS, READINGS


def place(variant: int, degrees: Expr | int) -> dict[Symbol, Expr]:
    """Return the sizes of a variant and an angle of the carrier."""
    sizes = dict(zip((R1, R2, e), VARIANTS[variant], strict=True))
    return {**sizes, phi1: degrees * DEGREE}


def start_of_8(variant: int) -> Expr:
    """Return the ratio by (8) at the start, where phi5 = 0."""
    return print_8.subs(phi5, S.Zero).subs(place(variant, 0))


def at_quarter(member: Expr) -> Expr:
    """Return the integrand of a member of (10) at x = 90 degrees, for the smaller e."""
    integrand = member.function.subs(member.variables[0], pi / 2)
    return integrand.subs({a1: 1 + e**2, b1: 2 * e}).subs(e, VARIANTS[1][2])


RIGHT_INTEGRAL, PRINTED_INTEGRAL = READER.members(DX_SUPPLIED)
FINDINGS = (
    Finding(
        "(12)",
        "With a_1 ± b_1 = (1 ± e)² the root in (11) already equals (1 + e)/(1 - e), but (12) "
        "takes the root again, in both places. Besides, its arctangent jumps back once in each "
        "turn of x = R_1 φ_1/R_2, whereas the position keeps rising. So by (12) the output "
        "averages one turn per turn of the carrier, not 1 + R_1/R_2.",
        costs=tuple(
            Cost(f"variant {variant}, {degrees}° of the carrier", "°", at=place(variant, degrees))
            for variant, degrees in ((1, 30), (2, 30), (2, 90), (1, 360))
        ),
        follows=("(12) gives the position function",),
        weight=Weight.CONCLUSION,
        mend="(12) without its roots",
        check=Check(
            "At φ_1 = 0 the slope of (12) is 1 + R_1/R_2 = {0} in variants 1 and 2, whatever e "
            "is; (8) gives {1} and {2} there.",
            (diff(print_12, phi1).subs(phi1, 0).subs(place(1, 0)), start_of_8(1), start_of_8(2)),
        ),
        figure="fig-3",
    ),
    interval_finding(READINGS, "(15)", "(16)"),
    Finding(
        ADEQUACY,
        "The text at hand gives neither a criterion of adequacy nor the readings. By the paper's "
        "own numbers the interval of variant 3 excludes a mean error of zero, and single errors "
        "of variants 1, 2 and 4 scatter more than two encoders of 0.3 % of 360° allow. If u is "
        "not an uncertainty of the mean, all four means are far from zero.",
        costs=(
            *costs_of_mean(READINGS, (3,)),
            *(
                Cost(
                    f"variant {variant}",
                    "°",
                    printed=READINGS[variant].implied_scatter * DEGREE,
                    right=LIMITS[variant] * DEGREE,
                    names=("scatter u√n", "largest error of two encoders"),
                )
                for variant in (1, 2, 4)
            ),
        ),
        weight=Weight.CONCLUSION,
        check=Check(
            "Variant 3, mean error over u: 0.68/0.28 = {0}, more than 2.",
            (READINGS[3].mean / READINGS[3].uncertainty,),
            1,
        ),
        figure="table-3",
    ),
    Finding(
        "Table 3, interval 3",
        "The interval of variant 3 is the mean plus or minus u; the other three, and the text, "
        "have 2u. Half-width and u do not agree: either the half-width should be 0.56°, or the u "
        "of Table 3 should be 0.14°. The text at hand does not decide which.",
        costs=(
            Cost(
                "half-width of variant 3",
                "°",
                decimals=2,
                printed=Rational(HALF_WIDTHS[3]) * DEGREE,
                right=2 * READINGS[3].uncertainty * DEGREE,
                names=("printed", "by the printed u"),
            ),
            Cost(
                "u of variant 3",
                "°",
                decimals=2,
                printed=READINGS[3].uncertainty * DEGREE,
                right=Rational(HALF_WIDTHS[3]) / 2 * DEGREE,
                names=("printed", "by the printed interval"),
            ),
        ),
        weight=Weight.NUMBER,
        check=Check(
            "Half-width over u: 1.64/0.82 = {0}, 2.72/1.36 = {1} and 2.02/1.01 = {2} in variants "
            "1, 2 and 4, but 0.28/0.28 = {3} in variant 3.",
            tuple(
                Rational(HALF_WIDTHS[variant]) / READINGS[variant].uncertainty
                for variant in (1, 2, 4, 3)
            ),
            0,
        ),
        figure="table-3",
    ),
    Finding(
        "(10), third equals sign",
        "In the fourth expression of (10) cos²(x/2) stands in the numerator instead of the "
        "denominator, and the differential dx is missing. The fifth expression and (11) are right "
        "again.",
        costs=tuple(
            Cost(
                f"with dx supplied, up to x = 90°, e = {float(eccentricity)}",
                decimals=3,
                printed=PRINTED_INTEGRAL,
                right=RIGHT_INTEGRAL,
                at=place(variant, 90 * Rational(small, large)),
            )
            for variant, (large, small, eccentricity) in list(VARIANTS.items())[:2]
        ),
        follows=("(10), fourth equals sign",),
        weight=Weight.FORMULA,
        check=Check(
            "At x = 90° and e = 0.28 the integrand of the first expression is 1/a_1 = {0}, that "
            "of the fourth (1/2)/(2 a_1) = {1}.",
            (at_quarter(RIGHT_INTEGRAL), at_quarter(PRINTED_INTEGRAL)),
        ),
    ),
)
