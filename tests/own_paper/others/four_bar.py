"""Four-bar linkage: the rocker's angle in both branches of its assembly, and its velocity ratio."""

from pathlib import Path

from sympy import acos, atan2, cos, diff, pi, sin, sqrt

from mechproof.document.transcription import Transcription
from mechproof.record import Argument, Correction, Form, Paper, PublishedSizes, Quantity

PRINT = Transcription(Path(__file__).with_name("four_bar.tex"))
a, b, c, d, sigma, phi, ratio, theta = PRINT.symbols("a b c d sigma phi phi_prime theta")

# The mechanics. The diagonal joins the rocker's pivot and the crank pin; the rocker is turned from
# it by the angle at the pivot in the triangle of diagonal, rocker and coupler.
DIAGONAL = sqrt(a**2 + d**2 - 2 * a * d * cos(theta))
COSINE = (DIAGONAL**2 + c**2 - b**2) / (2 * c * DIAGONAL)
ROCKER = pi - atan2(a * sin(theta), d - a * cos(theta)) - sigma * acos(COSINE)
# The loop a + b = d + c closes with the coupler at its length.
CLOSURE = (d + c * cos(phi) - a * cos(theta)) ** 2 + (c * sin(phi) - a * sin(theta)) ** 2 - b**2
RATIO = -diff(CLOSURE, theta) / diff(CLOSURE, phi)
SHORT = a * (d * sin(theta) + c * sin(theta - phi)) / (c * (d * sin(phi) + a * sin(theta - phi)))

SIZES = tuple(
    Argument(str(s), (s,), meaning, "mm", usual=(1, 1000))
    for s, meaning in ((a, "crank"), (b, "coupler"), (c, "rocker"), (d, "frame"))
)
CRANK = Argument("theta", (theta,), "angle of the crank", "rad", usual=(0, 10, 1000))
OUTPUT = Argument("phi", (phi,), "angle of the rocker", "rad", usual=(0, 10, 1000))
BRANCH = Argument("sigma", (sigma,), "branch of the assembly, 1 or -1")
SOURCE = "a textbook's chapter on four-bar linkages"

PAPER = Paper(
    system="four_bar",
    citation="A textbook's four-bar linkage, with a misprint",
    variables=PRINT.variables,
    notation=PRINT.notation,
    where=PRINT.where,
    print=PRINT.file,
    rows=(
        PRINT.equation("(1)", residual=CLOSURE / (2 * a * c)),
        PRINT.equation(
            "(2)",
            residual=CLOSURE / (2 * a * c),
            corrected=Correction(PRINT.find("(1)")),
        ),
        PRINT.equation("(3)", derived={ratio: RATIO}),
    ),
    quantities=(
        Quantity(
            "rocker",
            "Compute the angle of the rocker.",
            (CRANK, *SIZES, BRANCH),
            ROCKER,
            (Form("diagonal", ROCKER),),
            SOURCE,
            unit="rad",
        ),
        Quantity(
            "velocity_ratio",
            "Compute the ratio of the angular velocities of rocker and crank.",
            (CRANK, OUTPUT, SIZES[0], *SIZES[2:]),
            RATIO,
            (Form("equation (3)", SHORT),),
            SOURCE,
        ),
    ),
    published=(PublishedSizes("example 1", {a: 40, b: 120, c: 80, d: 100}),),
)
