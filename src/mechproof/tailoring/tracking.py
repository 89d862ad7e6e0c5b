"""Tracking: in, a program and a ball its input is in; out, its value there and its roundings.

A value is what exact arithmetic would give, as a Taylor series about the middle of the ball and as
one whose coefficients hold over all of it, and how far the computed one may be off. A product and
the sum after it are both rounded, although backends with an fma round once: the bound holds for
all of them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

from flint import arb, arb_series

from mechproof.codegen.program import Operand, Program
from mechproof.proof.balls import Ball
from mechproof.tailoring.series import Series, list_terms

UNIT = arb(2) ** -53
# What a product loses that is too small for a double.
LEAST = arb(2) ** -1074


class UndecidedError(ArithmeticError):
    """A comparison has two answers within the ball."""


@dataclass(frozen=True)
class Tracked:
    """A value: about the middle, over the ball, how far off; at both ends where it is exact."""

    middle: Series
    whole: Series
    off: Ball
    ends: tuple[Ball, Ball] | None = None

    @property
    def largest(self) -> Ball:
        """Return the largest size that the computed value has."""
        return abs(list_terms(self.whole)[0]).upper() + self.off


def track(program: Program, low: float, high: float) -> Tracked:
    """Run a program of one input on an interval, in the working precision and order.

    Series are in shares of half the interval, from its middle. Raises `UndecidedError`.
    """
    (name,) = program.inputs
    values: dict[Operand, Any] = {name: start(low, high)}
    for step in program.operations:
        given = [values[o] if isinstance(o, str) else _number(o) for o in step.operands]
        values[step.result] = _RULES[step.kind](*given)
    (output,) = program.outputs
    found: Tracked = values[output]
    return found


def start(low: float, high: float) -> Tracked:
    """Return the input: a double, exact."""
    middle, half = (arb(low) + high) / 2, (arb(high) - low) / 2
    ball = arb(middle, half.upper())
    return Tracked(
        arb_series([middle, half]), arb_series([ball, half]), arb(0), (arb(low), arb(high))
    )


def _number(number: float) -> Tracked:
    series = arb_series([arb(number)])
    return Tracked(series, series, arb(0), (arb(number), arb(number)))


def _round(middle: Series, whole: Series, off: Ball, least: Ball | int = 0) -> Tracked:
    size = abs(list_terms(whole)[0]).upper() + off
    return Tracked(middle, whole, (off + UNIT * size + least).upper())


def _add(a: Tracked, b: Tracked) -> Tracked:
    return _round(a.middle + b.middle, a.whole + b.whole, a.off + b.off)


def _negate(a: Tracked) -> Tracked:
    ends = (-a.ends[1], -a.ends[0]) if a.ends else None
    return Tracked(-a.middle, -a.whole, a.off, ends)


def _multiply(a: Tracked, b: Tracked) -> Tracked:
    off = a.largest * b.off + b.largest * a.off
    return _round(a.middle * b.middle, a.whole * b.whole, off, LEAST)


def _compare(a: Tracked, b: Tracked) -> bool:
    """Say whether a <= b, equality apart: at an edge both answers are enclosed."""
    if a.ends is None or b.ends is None:
        raise NotImplementedError("no comparison of what is rounded")
    if a.ends[1] <= b.ends[0]:
        return True
    if a.ends[0] >= b.ends[1]:
        return False
    raise UndecidedError


def _take_size(a: Tracked) -> Tracked:
    return _negate(a) if _compare(a, _number(0.0)) else a


def _take_sign(a: Tracked, b: Tracked) -> Tracked:
    size = _take_size(a)
    return _negate(size) if _compare(b, _number(0.0)) else size


_RULES: Mapping[str, Callable[..., Any]] = MappingProxyType(
    {
        "add": _add,
        "subtract": lambda a, b: _add(a, _negate(b)),
        "multiply": _multiply,
        "fma": lambda a, b, c: _add(_multiply(a, b), c),
        "negate": _negate,
        "absolute": _take_size,
        "copysign": _take_sign,
        "greater_equal": lambda a, b: _compare(b, a),
        "choose": lambda holds, a, b: a if holds else b,
    }
)
