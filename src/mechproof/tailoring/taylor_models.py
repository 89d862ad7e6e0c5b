"""Taylor models: in, a program and a ball its input is in; out, its value there and its roundings.

A value is what exact arithmetic would give, as a Taylor series about the middle of the ball and as
one whose coefficients hold over all of it, and how far the computed one may be off: a Taylor model
(Makino and Berz 1996) whose remainder is the rounding. A product and the sum after it are both
rounded, although backends with an fma round once: the bound holds for all of them.
"""

from __future__ import annotations

from dataclasses import dataclass

from flint import arb, arb_series

from mechproof.arithmetic.balls import Ball
from mechproof.arithmetic.series import Series, list_terms
from mechproof.programs.elementary.fits import expand_about
from mechproof.programs.operations import Arithmetic
from mechproof.programs.program import Program
from mechproof.roundoff.running import run

UNIT = arb(2) ** -53
# What a product loses that is too small for a double.
LEAST = arb(2) ** -1074


class UndecidedError(ArithmeticError):
    """A comparison has two answers within the ball."""


@dataclass(frozen=True)
class TaylorModel:
    """A value: about the middle, over the ball, how far off; at both ends where it is exact."""

    middle: Series
    whole: Series
    off: Ball
    ends: tuple[Ball, Ball] | None = None

    @property
    def largest(self) -> Ball:
        """Return the largest size that the computed value has."""
        return abs(list_terms(self.whole)[0]).upper() + self.off

    def __add__(self, other: TaylorModel) -> TaylorModel:
        return _round(self.middle + other.middle, self.whole + other.whole, self.off + other.off)

    def __neg__(self) -> TaylorModel:
        ends = (-self.ends[1], -self.ends[0]) if self.ends else None
        return TaylorModel(-self.middle, -self.whole, self.off, ends)

    def __sub__(self, other: TaylorModel) -> TaylorModel:
        return self + -other

    def __mul__(self, other: TaylorModel) -> TaylorModel:
        off = self.largest * other.off + other.largest * self.off
        return _round(self.middle * other.middle, self.whole * other.whole, off, LEAST)


def track(program: Program, low: float, high: float) -> TaylorModel:
    """Run a program of one input on an interval, in the working precision and order.

    Series are in shares of half the interval, from its middle. Raises `UndecidedError`.
    """
    (name,) = program.inputs
    (found,) = run(program, {name: start(low, high)}, TAYLOR_MODELS)
    assert isinstance(found, TaylorModel)
    return found


def start(low: float, high: float) -> TaylorModel:
    """Return the input: a double, exact."""
    middle, half = (arb(low) + high) / 2, (arb(high) - low) / 2
    return TaylorModel(*expand_about(middle, half), arb(0), (arb(low), arb(high)))


def _number(number: float) -> TaylorModel:
    series = arb_series([arb(number)])
    return TaylorModel(series, series, arb(0), (arb(number), arb(number)))


def _round(middle: Series, whole: Series, off: Ball, least: Ball | int = 0) -> TaylorModel:
    size = abs(list_terms(whole)[0]).upper() + off
    return TaylorModel(middle, whole, (off + UNIT * size + least).upper())


def _compare(a: TaylorModel, b: TaylorModel) -> bool:
    """Say whether a <= b, equality apart: at an edge both answers are enclosed."""
    if a.ends is None or b.ends is None:
        raise NotImplementedError("no comparison of what is rounded")
    if a.ends[1] <= b.ends[0]:
        return True
    if a.ends[0] >= b.ends[1]:
        return False
    raise UndecidedError


def _take_size(a: TaylorModel) -> TaylorModel:
    return -a if _compare(a, _number(0.0)) else a


def _take_sign(a: TaylorModel, b: TaylorModel) -> TaylorModel:
    size = _take_size(a)
    return -size if _compare(b, _number(0.0)) else size


TAYLOR_MODELS = Arithmetic(
    {
        "number": _number,
        "absolute": _take_size,
        "copysign": _take_sign,
        "greater_equal": lambda a, b: _compare(b, a),
        "choose": lambda holds, a, b: a if holds else b,
    }
)
