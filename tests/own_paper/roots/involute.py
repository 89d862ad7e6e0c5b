"""The pressure angle from its involute, as needed for the thickness of a tooth."""

from sympy import Interval, Rational, Symbol, cbrt, tan

from mechproof.record import Argument, Equation, Form, Paper, Quantity, Root, Variable

alpha, y = Symbol("alpha", positive=True), Symbol("y", positive=True)

# The involute function: the angle unrolled from the base circle, less the pressure angle.
UNROLLED = tan(alpha) - alpha
# The start is the first term of the series, which is too large, as the derivative rises.
ANGLE = Root(UNROLLED - y, (alpha, Rational(1, 20), Rational(13, 10)), start=cbrt(3 * y), steps=6)

PAPER = Paper(
    system="involute",
    citation="A textbook's involute",
    variables=(
        Variable(
            alpha,
            "pressure angle",
            within=Interval(Rational(1, 20), Rational(13, 10)),
            latex=(r"\alpha",),
        ),
        Variable(y, "involute", within=Interval(Rational(1, 10000), Rational(1, 2)), latex=("y",)),
    ),
    rows=(Equation("(1)", r"y=\tan\alpha-\alpha", residual=y - UNROLLED),),
    quantities=(
        Quantity(
            "pressure_angle",
            "Compute the pressure angle by its involute.",
            (Argument("y", (y,), "involute", usual=(0.001, 0.01, 0.1)),),
            ANGLE,
            (Form("Newton's method", ANGLE),),
            "a textbook's chapter on gears",
            unit="rad",
        ),
    ),
)
