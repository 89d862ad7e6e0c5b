"""What is wrong in paper 1: the causes, what they cost at its own sizes, what follows from them."""

from sympy import Expr, Symbol, pi

from mechproof.record import Cost, Finding

from .paper import R1, R2, VARIANTS, e, phi1


def place(variant: int, degrees: int) -> dict[Symbol, Expr]:
    """Return the sizes of a variant and an angle of the carrier."""
    sizes = dict(zip((R1, R2, e), VARIANTS[variant], strict=True))
    return {**sizes, phi1: degrees * pi / 180}


FINDINGS = (
    Finding(
        "(10), third equals sign",
        "The factor 1/cos^2(x/2) has moved into the numerator and the differential is missing, so "
        "the fourth expression of (10) is no integral.",
        follows=("(10), fourth equals sign",),
    ),
    Finding(
        "(12)",
        "As a1 -+ b1 = (1 -+ e)^2, the root of (11) is (1 + e)/(1 - e) itself; "
        "(12) still has its root, in two places. Besides, the arctangent falls back by half a turn "
        "at |x| = pi, where the position goes on.",
        costs=tuple(
            Cost(f"variant {variant}, {degrees}° of the carrier", place(variant, degrees), "°")
            for variant, degrees in ((1, 30), (2, 30), (2, 90))
        ),
        follows=("(12) gives the position function",),
    ),
    Finding(
        "table 3, interval 3",
        "The interval is the mean and once the uncertainty; the other three and the text have "
        "twice.",
        costs=(Cost("half-width in degrees", {}, decimals=2),),
    ),
)
