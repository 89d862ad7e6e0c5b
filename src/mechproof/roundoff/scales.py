"""Scales: factors that nobody knows, of a tangent's two parts, and that no output may have."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import replace
from types import MappingProxyType

from mechproof.codegen.program import Operand
from mechproof.roundoff.steps import Straight

Powers = Counter[Operand]


def _same(*powers: Powers) -> Powers:
    if any(other != powers[0] for other in powers):
        raise ValueError("a sum of what is scaled and what is not")
    return powers[0]


def _multiply(a: Powers, b: Powers) -> Powers:
    return _join(a, b, 1)


def _divide(a: Powers, b: Powers) -> Powers:
    return _join(a, b, -1)


def _join(a: Powers, b: Powers, sign: int) -> Powers:
    powers = {angle: a[angle] + sign * b[angle] for angle in (*a, *b)}
    return Counter({angle: power for angle, power in powers.items() if power})


DEGREES: Mapping[str, Callable[..., Powers]] = MappingProxyType(
    {
        **dict.fromkeys(("add", "subtract", "negate", "copy"), _same),
        "multiply": _multiply,
        "divide": _divide,
        "square": lambda a: _multiply(a, a),
        "fma": lambda a, b, c: _same(_multiply(a, b), c),
    }
)


def find_scaled(straight: Straight) -> Straight:
    """Return the steps with what is scaled told; ValueError where an output depends on a scale."""
    known: dict[Operand, Powers] = {}
    for step in straight.steps:
        given = [known.get(operand, Counter()) for operand in step.operands]
        if step.scaled:
            known[step.result] = Counter({step.scaled: 1})
        elif any(given):
            if step.kind not in DEGREES:
                raise ValueError(f"{step.result}: {step.kind} of what is scaled")
            known[step.result] = DEGREES[step.kind](*given)
    if any(known.get(output) for output in straight.outputs):
        raise ValueError("an output is scaled")
    return replace(straight, scaled=tuple(str(r) for r, powers in known.items() if powers))
