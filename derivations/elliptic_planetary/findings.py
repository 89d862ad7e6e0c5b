"""What is wrong in paper 1: the causes, what they cost at its own sizes, what follows from them."""

from sympy import Expr, Rational, Symbol, pi

from mechproof.record import Cost, Finding

from .position_rows import DX_SUPPLIED
from .readings import HALF_WIDTHS, LIMITS, READINGS, implied_scatter
from .symbols import R1, R2, READER, VARIANTS, e, phi1

DEGREE = pi / 180


def place(variant: int, degrees: Expr | int) -> dict[Symbol, Expr]:
    """Return the sizes of a variant and an angle of the carrier."""
    sizes = dict(zip((R1, R2, e), VARIANTS[variant], strict=True))
    return {**sizes, phi1: degrees * DEGREE}


RIGHT_INTEGRAL, PRINTED_INTEGRAL = READER.members(DX_SUPPLIED)
FINDINGS = (
    Finding(
        "(10), third equals sign",
        "The fourth expression of (10) has the factor cos^2(x/2) in its numerator, where it "
        "belongs in the denominator, and no differential dx.",
        costs=tuple(
            Cost(
                f"with dx supplied, up to x = 90°, e = {float(eccentricity)}",
                place(variant, 90 * Rational(small, large)),
                decimals=3,
                printed=PRINTED_INTEGRAL,
                right=RIGHT_INTEGRAL,
            )
            for variant, (large, small, eccentricity) in list(VARIANTS.items())[:2]
        ),
        follows=("(10), fourth equals sign",),
    ),
    Finding(
        "(12)",
        "(12) takes the root of (1 + e)/(1 - e) in two places where (11) gives (1 + e)/(1 - e) "
        "itself; besides, its arctangent falls back once in each turn of x = R_1 φ_1/R_2, where "
        "the position goes on.",
        costs=tuple(
            Cost(f"variant {variant}, {degrees}° of the carrier", place(variant, degrees), "°")
            for variant, degrees in ((1, 30), (2, 30), (2, 90))
        ),
        follows=("(12) gives the position function",),
    ),
    Finding(
        "table 3, interval 3",
        "The interval of variant 3 is the mean and once the uncertainty u; the other three and "
        "the text have twice u. Half-width and u do not fit, and which of the two is the misprint "
        "is not decided: the half-width is to be 0.56°, or the u of table 3 is to be 0.14°.",
        costs=(
            Cost(
                "half-width of variant 3",
                {},
                "°",
                decimals=2,
                printed=Rational(HALF_WIDTHS[3]) * DEGREE,
                right=2 * READINGS[3].uncertainty * DEGREE,
                names=("printed", "by the printed u"),
            ),
            Cost(
                "u of variant 3",
                {},
                "°",
                decimals=2,
                printed=READINGS[3].uncertainty * DEGREE,
                right=Rational(HALF_WIDTHS[3]) / 2 * DEGREE,
                names=("printed", "by the printed interval"),
            ),
        ),
    ),
    Finding(
        "measured functions adequate",
        "Neither a criterion of adequacy nor the readings are printed. By the paper's own numbers "
        "the interval of variant 3 excludes an error of zero, and single errors of variants 1, 2 "
        "and 4 scatter by more than two encoders of 0.3 % of 360° allow, or u is no uncertainty of "
        "the mean.",
        costs=(
            Cost(
                "variant 3",
                {},
                "°",
                decimals=2,
                printed=READINGS[3].mean * DEGREE,
                right=2 * READINGS[3].uncertainty * DEGREE,
                names=("mean error", "2u"),
            ),
            *(
                Cost(
                    f"variant {variant}",
                    {},
                    "°",
                    printed=implied_scatter(variant)[0] * DEGREE,
                    right=LIMITS[variant] * DEGREE,
                    names=("scatter u√n", "largest error of two encoders"),
                )
                for variant in (1, 2, 4)
            ),
        ),
    ),
)
