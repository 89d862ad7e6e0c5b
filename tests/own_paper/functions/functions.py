"""Functions of one or two numbers, each a quantity, as a user's own paper may have them."""

from sympy import (
    FiniteSet,
    Interval,
    Max,
    Min,
    Mod,
    Piecewise,
    Rational,
    Sum,
    Symbol,
    acos,
    asinh,
    cbrt,
    cot,
    csc,
    log,
    sec,
    sign,
    sinc,
    tanh,
)

from mechproof.record import Argument, Form, Paper, Quantity, Variable

x = Symbol("x", real=True)
y = Symbol("y", positive=True)
s = Symbol("s", real=True)
i = Symbol("i", integer=True)

X = Argument("x", (x,), "a number", "1", usual=(-Rational(1, 2), Rational(1, 4), Rational(1, 2)))
Y = Argument("y", (y,), "a number", "1", usual=(0.5, 1, 3))
S = Argument("s", (s,), "the branch", "1", usual=(-1, 1))

DEFINITIONS = {
    "arccosine": (acos(x), X),
    "logarithm": (log(y), Y),
    "direction": (sign(x), X),
    "power": (y**x, X, Y),
    "root": (cbrt(y), Y),
    "secant": (sec(x), X),
    "cosecant": (csc(y / 4), Y),
    "cotangent": (cot(y / 4), Y),
    "smaller": (Min(x, y), X, Y),
    "larger": (Max(x**2, y), X, Y),
    "rest": (Mod(y, 2), Y),
    "tangent": (tanh(x), X),
    "area": (asinh(x), X),
    "wave": (sinc(x), X),
    "pieces": (Piecewise((x**2, x < Rational(1, 4)), (x / 4, True)), X),
    "branch": (y + s * sinc(x), X, Y, S),
    "total": (Sum(x**i / i, (i, 1, 5)), X),
}

PAPER = Paper(
    system="functions",
    citation="Functions of a paper of one's own",
    variables=(
        Variable(x, "x", within=Interval(-Rational(9, 10), Rational(9, 10))),
        Variable(y, "y", within=Interval(Rational(1, 10), 5)),
        Variable(s, "the branch", within=FiniteSet(-1, 1)),
    ),
    rows=(),
    quantities=tuple(
        Quantity(name, f"Compute {name}.", arguments, value, (Form("as defined", value),), "none")
        for name, (value, *arguments) in DEFINITIONS.items()
    ),
)
