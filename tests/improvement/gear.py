"""Formulas as textbooks print them and new users first type them, whose digits cancel."""

from sympy import Expr, Interval, Symbol, atan, cos, exp, log, oo, pi, sin, sqrt, tan

from mechproof.record import Argument, Form, Paper, Quantity, Variable

x = Symbol("x", real=True)
p, b, c = (Symbol(name, positive=True) for name in "pbc")
ANGLE = (Argument("x", (x,), "an angle", usual=(0, 1)),)
SIZE = (Argument("p", (p,), "a size", usual=(0, 1000)),)
EQUATION = (
    Argument("b", (b,), "half a coefficient", usual=(1, 1000)),
    Argument("c", (c,), "a coefficient", usual=(1e-3, 1)),
)


def ship(name: str, arguments: tuple[Argument, ...], value: Expr) -> Quantity:
    """Return a quantity whose only form is its definition."""
    form = Form("as defined", value)
    return Quantity(name, f"Compute the {name}.", arguments, value, (form,), "a textbook")


PAPER = Paper(
    system="gear",
    citation="a textbook",
    variables=(
        Variable(x, "an angle", within=Interval.open(-pi / 2, pi / 2)),
        *(Variable(symbol, "a size", within=Interval.open(0, oo)) for symbol in (p, b, c)),
    ),
    rows=(),
    quantities=(
        ship("involute", ANGLE, tan(x) - x),
        ship("segment", ANGLE, x - sin(x)),
        ship("versine", ANGLE, 1 - cos(x)),
        ship("curvature", ANGLE, (1 - cos(x)) / x**2),
        ship("step", SIZE, sqrt(p + 1) - sqrt(p)),
        ship("turn", SIZE, atan(p + 1) - atan(p)),
        ship("growth", SIZE, exp(p) - 1),
        ship("doubling", SIZE, log(1 + p)),
        ship("root", EQUATION, sqrt(b**2 + c) - b),
        ship("tangent", ANGLE, tan(x)),
    ),
)
