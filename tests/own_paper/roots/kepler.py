"""Kepler's equation: the eccentric anomaly and its rate, both from the root of the equation."""

from sympy import Interval, Rational, Symbol, cos, diff, sin

from mechproof.record import Argument, Equation, Form, Paper, Quantity, Root, Variable

E, M, e = Symbol("E", real=True), Symbol("M", real=True), Symbol("e", nonnegative=True)
rate = Symbol("E_prime", real=True)

# The sector swept in the circle about the ellipse, less the triangle at its centre.
SWEPT = E - e * sin(E)
ANOMALY = Root(SWEPT - M, (E, M - 1, M + 1), start=M + e * sin(M), steps=5)

ARGUMENTS = (
    Argument("M", (M,), "mean anomaly", "rad", usual=(0.01, 1, 100)),
    Argument("e", (e,), "eccentricity", usual=(0.01, 0.7)),
)
SOURCE = "a textbook's chapter on orbits"

PAPER = Paper(
    system="kepler",
    citation="A textbook's equation of Kepler",
    variables=(
        Variable(E, "eccentric anomaly", latex=("E",)),
        Variable(M, "mean anomaly", latex=("M",)),
        Variable(e, "eccentricity", within=Interval(0, Rational(7, 10)), latex=("e",)),
        Variable(rate, "derivative of the eccentric anomaly", latex=("E'",)),
    ),
    rows=(
        Equation("(1)", r"M=E-e\sin E", residual=M - SWEPT),
        Equation("(2)", r"E'=\frac1{1-e\cos E}", derived={rate: 1 / diff(SWEPT, E)}),
    ),
    quantities=(
        Quantity(
            "anomaly",
            "Compute the eccentric anomaly.",
            ARGUMENTS,
            ANOMALY,
            (Form("Newton's method", ANOMALY),),
            SOURCE,
            unit="rad",
        ),
        Quantity(
            "rate",
            "Compute the derivative of the eccentric anomaly by the mean anomaly.",
            ARGUMENTS,
            diff(ANOMALY, M),
            (Form("by the root", 1 / (1 - e * cos(ANOMALY))),),
            SOURCE,
        ),
    ),
)
