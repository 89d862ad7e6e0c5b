"""Disc cam: rise by a polynomial of the fifth degree, dwell, cycloidal return, dwell."""

from pathlib import Path

from sympy import Eq, Piecewise, cos, diff, pi, sin

from mechproof.document.transcription import Transcription
from mechproof.record import (
    Accuracy,
    Argument,
    Form,
    Paper,
    PublishedSizes,
    Quantity,
    Scale,
    Singular,
)

PRINT = Transcription(Path(__file__).with_name("cam.tex"))
h, u, w, velocity, acceleration, theta = PRINT.symbols("h u w s_1 s_2 theta")

# The laws, in terms of the completed fractions of the rise and of the return.
RISE_ENDS, DWELL_ENDS, RETURN_ENDS = 2 * pi / 3, pi, 5 * pi / 3
RISEN, RETURNED = theta / RISE_ENDS, (theta - DWELL_ENDS) / (RETURN_ENDS - DWELL_ENDS)


def join(rise, dwell, fall):
    """Return a piecewise function of theta: rise, dwell, return (`fall`), and 0 for the rest."""
    return Piecewise(
        (rise, theta < RISE_ENDS),
        (dwell, theta < DWELL_ENDS),
        (fall, theta < RETURN_ENDS),
        (0, True),
    ).subs({u: RISEN, w: RETURNED})


LIFT = join(h * (10 * u**3 - 15 * u**4 + 6 * u**5), h, h * (1 - w + sin(2 * pi * w) / (2 * pi)))
VELOCITY = join(45 * h / pi * u**2 * (1 - u) ** 2, 0, -3 * h / (2 * pi) * (1 - cos(2 * pi * w)))
ACCELERATION = join(
    135 * h / pi**2 * u * (1 - u) * (1 - 2 * u), 0, -9 * h / (2 * pi) * sin(2 * pi * w)
)

ARGUMENTS = (
    Argument("theta", (theta,), "angle of the cam", "rad", usual=(0.001, 1, 6.28)),
    Argument("h", (h,), "lift", "mm", usual=(1, 100)),
)
SEAMS = tuple(Singular(Eq(theta, seam)) for seam in (RISE_ENDS, DWELL_ENDS, RETURN_ENDS))
SOURCE = "a textbook's chapter on cams"

PAPER = Paper(
    system="cam",
    citation="A textbook's disc cam, with a misprint",
    variables=PRINT.give({u: RISEN, w: RETURNED}),
    notation=PRINT.notation,
    where=PRINT.where,
    print=PRINT.file,
    rows=(
        PRINT.equation("(2)", derived={velocity: diff(LIFT, theta)}),
        PRINT.equation(
            "(3)",
            derived={acceleration: diff(LIFT, theta, 2)},
            corrected=PRINT.mend("(3)", "+\\frac", r"-\frac"),
        ),
    ),
    quantities=(
        Quantity(
            "lift",
            "Compute the lift of the follower.",
            ARGUMENTS,
            LIFT,
            (Form("as printed", LIFT),),
            SOURCE,
            unit="mm",
            singular=SEAMS,
            # The terms are up to 10, 15 and 6 times the lift, each with up to four roundings.
            accuracy=Accuracy(64, Scale("the lift", h)),
        ),
        Quantity(
            "velocity",
            "Compute the derivative of the lift by the angle.",
            ARGUMENTS,
            diff(LIFT, theta),
            (Form("products", VELOCITY),),
            SOURCE,
            unit="mm",
            singular=SEAMS,
            accuracy=Accuracy(32, Scale("the lift", h)),
        ),
        Quantity(
            "acceleration",
            "Compute the second derivative of the lift by the angle.",
            ARGUMENTS,
            diff(LIFT, theta, 2),
            (Form("products", ACCELERATION),),
            SOURCE,
            unit="mm",
            singular=SEAMS,
            accuracy=Accuracy(32, Scale("the lift", h)),
        ),
    ),
    published=(PublishedSizes("example 1", {h: 20}),),
)
