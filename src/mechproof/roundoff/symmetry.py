"""Symmetry: whether steps with arguments negated round as they did, but for signs."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from types import MappingProxyType

import sympy as sp

from mechproof.codegen.program import CONSTANTS, Operand
from mechproof.record import Chart
from mechproof.roundoff.steps import CONSTANT, Straight

# 1 for what stays, -1 for what is negated.
Parity = int


def _same(*parities: Parity) -> Parity:
    if len(set(parities)) > 1:
        raise ValueError("a sum of what is negated and what is not")
    return parities[0]


def _product(a: Parity, b: Parity) -> Parity:
    return a * b


def _even(*parities: Parity) -> Parity:
    return 1


def _keep(parity: Parity) -> Parity:
    return parity


def _compare(a: Parity, b: Parity) -> Parity:
    if a < 0 or b < 0:
        raise ValueError("what is negated is compared")
    return 1


def _choose(condition: Parity, a: Parity, b: Parity) -> Parity:
    return _same(a, b)


def _take_sign(size: Parity, sign: Parity) -> Parity:
    return sign


# To round to nearest is odd, and so are NumPy's odd functions.
PARITIES: Mapping[str, Callable[..., Parity]] = MappingProxyType(
    {
        **dict.fromkeys(("add", "subtract"), _same),
        **dict.fromkeys(("multiply", "divide"), _product),
        **dict.fromkeys(("square", "cos", "absolute", CONSTANT), _even),
        **dict.fromkeys(("negate", "copy", "approximate", "pi_off"), _keep),
        **dict.fromkeys(("tan", "sin", "arctan", "small_tangent"), _keep),
        "greater": _compare,
        "choose": _choose,
        "copysign": _take_sign,
        "fma": lambda a, b, c: _same(a * b, c),
        "product_rest": lambda a, b, p: _same(a * b, p),
        "quotient_rest": lambda a, b, q: _same(a * b, q),
    }
)


def check_symmetry(straight: Straight, chart: Chart, names: Mapping[sp.Basic, str]) -> None:
    """Require that negative angles are off as positive ones are; ValueError if not."""
    if chart.angle is not None:
        find_parities(straight, dict(list_parities(chart, chart.angle, names)))


def check_mirror(
    straight: Straight, mirror: Sequence[sp.Basic], names: Mapping[sp.Basic, str]
) -> None:
    """Require that arguments, all negated, turn no more than signs; ValueError if not."""
    find_parities(straight, {name: -1 if s in mirror else 1 for s, name in names.items()})


def list_parities(
    chart: Chart, angle: sp.Symbol, names: Mapping[sp.Basic, str]
) -> Iterator[tuple[str, Parity]]:
    """List what an angle negated does to arguments; ValueError if that is neither."""
    for symbol, value in chart.arguments.items():
        turned = value.subs(angle, -angle)
        if turned not in (value, -value):
            raise ValueError(f"chart: {value} is neither odd nor even in {angle}")
        yield names[symbol], 1 if turned == value else -1


def find_parities(straight: Straight, given: Mapping[str, Parity]) -> Mapping[Operand, Parity]:
    """Return what becomes of all results where the given ones do; ValueError if that is neither."""
    parities: dict[Operand, Parity] = dict.fromkeys(CONSTANTS, 1)
    parities.update(given.items())
    for step in straight.steps:
        operands = [parities[o] if isinstance(o, str) else 1 for o in step.operands]
        if step.kind not in PARITIES:
            raise ValueError(f"{step.kind} has no parity")
        parities[step.result] = PARITIES[step.kind](*operands)
    return parities
