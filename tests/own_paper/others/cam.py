"""Disc cam: rise by a polynomial of the fifth degree, dwell, cycloidal return, dwell."""

from sympy import Eq, Interval, Piecewise, Symbol, cos, diff, oo, pi, sin

from mechproof.record import (
    LENGTH,
    Accuracy,
    Argument,
    Correction,
    Equation,
    Form,
    Notation,
    Paper,
    PublishedSizes,
    Quantity,
    Scale,
    Singular,
    Variable,
)

theta, h = Symbol("theta", real=True), Symbol("h", positive=True)
u, w = Symbol("u", real=True), Symbol("w", real=True)
velocity, acceleration = Symbol("s_1", real=True), Symbol("s_2", real=True)

# The laws, by the part of the rise and of the return that is gone through.
RISE_ENDS, DWELL_ENDS, RETURN_ENDS = 2 * pi / 3, pi, 5 * pi / 3
RISEN, RETURNED = theta / RISE_ENDS, (theta - DWELL_ENDS) / (RETURN_ENDS - DWELL_ENDS)


def join(rise, dwell, fall):
    """Return what is one thing in each part of a turn."""
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
PIECES = (
    r"%s=\begin{cases}%s,&\theta<\frac{2\pi}3\\%s,&\frac{2\pi}3\le\theta<\pi\\"
    r"%s,&\pi\le\theta<\frac{5\pi}3\\0,&\theta\ge\frac{5\pi}3\end{cases}"
)
RISE, RETURN = r"\frac{45h}{\pi}u^2(1-u)^2", r"-\frac{3h}{2\pi}(1-\cos(2\pi w))"
ACCELERATION_PRINT = PIECES % (
    "s''",
    r"\frac{135h}{\pi^2}u(1-u)(1-2u)",
    "0",
    r"%s\frac{9h}{2\pi}\sin(2\pi w)",
)

PAPER = Paper(
    system="cam",
    citation="A textbook's disc cam, with a misprint",
    variables=(
        Variable(theta, "angle of the cam", within=Interval(0, 2 * pi), latex=(r"\theta",)),
        Variable(h, "lift", LENGTH, Interval.open(0, oo), latex=("h",)),
        Variable(u, "part of the rise", given=RISEN, latex=("u",)),
        Variable(w, "part of the return", given=RETURNED, latex=("w",)),
        Variable(velocity, "derivative of the lift", LENGTH, latex=("s'",)),
        Variable(acceleration, "second derivative of the lift", LENGTH, latex=("s''",)),
    ),
    rows=(
        Equation("(2)", PIECES % (r"s'", RISE, "0", RETURN), derived={velocity: diff(LIFT, theta)}),
        Equation(
            "(3)",
            ACCELERATION_PRINT % "+",
            derived={acceleration: diff(LIFT, theta, 2)},
            corrected=Correction(ACCELERATION_PRINT % "-"),
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
    notation=Notation(factors=("u",)),
    published=(PublishedSizes("example 1", {h: 20}),),
)
