"""Rules: for each kind of operation its value and its partial derivatives, in germs."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType

from flint import arb

from mechproof.roundoff.angles import Turn, take_arctangent, take_cosine, take_sine, take_tangent
from mechproof.roundoff.germs import Germ

# How the value of an operation moves with each operand; None where it does not.
Slopes = tuple[Germ | None, ...]
Moved = tuple[Germ, Slopes]
Rule = Callable[[Sequence[Germ], Turn | None], Moved]


def _one(germ: Germ) -> Germ:
    return germ.frame.constant(arb(1))


def _add(given: Sequence[Germ], turn: Turn | None) -> Moved:
    a, b = given
    return a + b, (_one(a), _one(a))


def _subtract(given: Sequence[Germ], turn: Turn | None) -> Moved:
    a, b = given
    return a - b, (_one(a), -_one(a))


def _multiply(given: Sequence[Germ], turn: Turn | None) -> Moved:
    a, b = given
    return a * b, (b, a)


def _divide(given: Sequence[Germ], turn: Turn | None) -> Moved:
    a, b = given
    quotient = a / b
    return quotient, (_one(a) / b, -(quotient / b))


def _fma(given: Sequence[Germ], turn: Turn | None) -> Moved:
    a, b, c = given
    return a * b + c, (b, a, _one(a))


def _negate(given: Sequence[Germ], turn: Turn | None) -> Moved:
    return -given[0], (-_one(given[0]),)


def _square(given: Sequence[Germ], turn: Turn | None) -> Moved:
    return given[0].squared(), (given[0].scaled(arb(2)),)


def _sqrt(given: Sequence[Germ], turn: Turn | None) -> Moved:
    (a,) = given
    # Odd powers of what vanishes have no root among the germs.
    rooted = a if all(p % 2 == 0 for p in a.powers) else a.frame.constant(a.expanded())
    root = Germ(a.frame, rooted.ball.sqrt(), tuple([p // 2 for p in rooted.powers]))
    return root, (a.frame.constant(arb(0.5)) / root,)


def _hypot(given: Sequence[Germ], turn: Turn | None) -> Moved:
    a, b = given
    root, _ = _sqrt((a.squared() + b.squared(),), turn)
    return root, (a / root, b / root)


def _absolute(given: Sequence[Germ], turn: Turn | None) -> Moved:
    (a,) = given
    if a.sign:
        sign = a.frame.constant(arb(a.sign))
        return a * sign, (sign,)
    return a.frame.constant(abs(a.expanded())), (a.frame.constant(arb(0, 1)),)


def _maximum(given: Sequence[Germ], turn: Turn | None) -> Moved:
    return _either(given, (given[0] - given[1]).expanded())


def _minimum(given: Sequence[Germ], turn: Turn | None) -> Moved:
    return _either(given, (given[1] - given[0]).expanded())


def _either(given: Sequence[Germ], lead: arb) -> Moved:
    """Return the first where it leads, the second where it does not, both where undecided."""
    a, b = given
    one = _one(a)
    if lead >= 0:
        return a, (one, None)
    if lead <= 0:
        return b, (None, one)
    some = a.frame.constant(arb(0.5, 0.5))
    return a.united(b), (some, some)


def _tan(given: Sequence[Germ], turn: Turn | None) -> Moved:
    tangent = take_tangent(given[0], turn)
    return tangent, (_one(tangent) + tangent.squared(),)


def _sin(given: Sequence[Germ], turn: Turn | None) -> Moved:
    return take_sine(given[0], turn), (take_cosine(given[0], turn),)


def _cos(given: Sequence[Germ], turn: Turn | None) -> Moved:
    return take_cosine(given[0], turn), (-take_sine(given[0], turn),)


def _arctan(given: Sequence[Germ], turn: Turn | None) -> Moved:
    (a,) = given
    return take_arctangent(a), (_one(a) / (_one(a) + a.squared()),)


RULES: Mapping[str, Rule] = MappingProxyType(
    {
        "add": _add,
        "subtract": _subtract,
        "multiply": _multiply,
        "divide": _divide,
        "fma": _fma,
        "negate": _negate,
        "square": _square,
        "sqrt": _sqrt,
        "hypot": _hypot,
        "absolute": _absolute,
        "maximum": _maximum,
        "minimum": _minimum,
        "sin": _sin,
        "cos": _cos,
        "tan": _tan,
        "arctan": _arctan,
    }
)
