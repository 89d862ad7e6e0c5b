"""Models: piecewise polynomials and the reduction before them, as numbers and as programs.

For a program with its input in a ball, a value is the exact result, as a Taylor series about the
middle of the ball and as one with coefficients that hold over all of it, and a bound on how far the
computed result is off: a Taylor model (Makino and Berz 1996) whose remainder is the rounding error.
A product and the sum after it are both rounded, although backends with an fma round only once: so
the bound holds for all of them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, arb_series

from mechproof.arithmetic.balls import Ball
from mechproof.arithmetic.series import Series, list_terms
from mechproof.programs.elementary.fits import expand_about
from mechproof.programs.operations import Arithmetic
from mechproof.programs.program import Program
from mechproof.programs.trace import Value, choose, copysign, fma, trace
from mechproof.roundoff.running import run

# A double so large that adding to it rounds to a whole number, more cheaply than `rint`.
WHOLE = 1.5 * 2.0**52
UNIT = arb(2) ** -53
# The most that a product loses by underflow.
LEAST = arb(2) ** -1074


@dataclass(frozen=True)
class Piece:
    """A polynomial about a centre, lowest power first, or in odd powers only."""

    centre: float
    coefficients: tuple[float, ...]


@dataclass(frozen=True)
class Pieces:
    """Consecutive polynomials, separated by `edges`.

    `odd`: they have odd powers only, and a second one is about the end of |r|. `mirrored`: they are
    for r >= 0, and the function is odd.
    """

    edges: tuple[float, ...]
    pieces: tuple[Piece, ...]
    odd: bool
    mirrored: bool

    @property
    def degrees(self) -> tuple[int, ...]:
        """Return the degree of each piece."""
        return tuple(
            max((self._power(i) for i, c in enumerate(p.coefficients) if c), default=0)
            for p in self.pieces
        )

    def _power(self, index: int) -> int:
        return 2 * index + 1 if self.odd else index

    def write(self, r: Value) -> Value:
        """Return the value of the polynomials at the remainder of the reduction."""
        if self.odd:
            return self._write_odd(r)
        w = abs(r) if self.mirrored else r
        beyond = [w >= edge for edge in self.edges]
        s = w - _pick(beyond, [p.centre for p in self.pieces])
        value = _put(s, beyond, [p.coefficients for p in self.pieces])
        assert isinstance(value, Value)
        return value * copysign(1.0, r) if self.mirrored else value

    def _write_odd(self, r: Value) -> Value:
        *_, last = self.pieces
        beyond, s = [abs(r) >= edge for edge in self.edges], r
        if beyond:
            # The second centre is half a period to either side; the sign decides which.
            s = r - choose(beyond[0], copysign(last.centre, r), 0.0)
        return s * _put(s * s, beyond, [p.coefficients for p in self.pieces])


def _pick(beyond: Sequence[Value], numbers: Sequence[float]) -> Value | float:
    """Return the number that belongs to the last piece that begins before the point."""
    picked: Value | float = numbers[0]
    for condition, number in zip(beyond, numbers[1:], strict=True):
        same = not isinstance(picked, Value) and number == picked
        picked = picked if same else choose(condition, number, picked)
    return picked


def _put(z: Value, beyond: Sequence[Value], rows: Sequence[Sequence[float]]) -> Value | float:
    """Return the selected polynomial by Horner's rule; loops over points hide its latency."""
    first, *others = [_pick(beyond, column) for column in zip(*rows, strict=True)][::-1]
    value = first
    for number in others:
        value = z.apply("fma", value, z, number)
    return value


@dataclass(frozen=True)
class PeriodReduction:
    """Subtracts whole periods: `words` add up to the period, `rate` is the gain per unit of it."""

    words: tuple[float, ...]
    per_period: float
    rate: float

    def write(self, point: Value) -> Value:
        """Return the point less the nearest number of periods."""
        count = fma(point, self.per_period, WHOLE) - WHOLE
        r = point
        for word in self.words:
            r = fma(count, -word, r)
        return r


@dataclass(frozen=True)
class Model:
    """What a tailored kernel computes from `low` to `high`; outside it returns NaN."""

    name: str
    low: float
    high: float
    reduction: PeriodReduction | None
    pieces: Pieces

    def program(self) -> Program:
        """Return the whole program, for points of the range."""
        return trace(self._write, (self.name,))

    def part(self) -> Program:
        """Return the program for the remainder of the point after the reduction."""
        return trace(self.pieces.write, ("r",))

    def inside(self) -> Program:
        """Return the program that decides whether a point is in the range."""
        return trace(self._write_inside, (self.name,))

    def _write(self, point: Value) -> Value:
        reduction = self.reduction
        value = self.pieces.write(reduction.write(point) if reduction else point)
        if reduction and reduction.rate:
            return point.apply("fma", reduction.rate, point, value)
        return value

    def _write_inside(self, point: Value) -> Value:
        if self.low == -self.high:
            return abs(point) <= self.high
        return point.apply("both", point >= self.low, point <= self.high)


class UndecidedError(ArithmeticError):
    """Raised if a comparison has two answers within a ball."""


@dataclass(frozen=True)
class TaylorModel:
    """A value as series about the middle and over the ball, its error, and its ends if exact."""

    middle: Series
    whole: Series
    off: Ball
    ends: tuple[Ball, Ball] | None = None

    @property
    def largest(self) -> Ball:
        """Return an upper bound on the absolute value of the computed result."""
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
    """Return the model of an input, an exact double from `low` to `high`."""
    middle, half = (arb(low) + high) / 2, (arb(high) - low) / 2
    return TaylorModel(*expand_about(middle, half), arb(0), (arb(low), arb(high)))


def _number(number: float) -> TaylorModel:
    series = arb_series([arb(number)])
    return TaylorModel(series, series, arb(0), (arb(number), arb(number)))


def _round(middle: Series, whole: Series, off: Ball, least: Ball | int = 0) -> TaylorModel:
    size = abs(list_terms(whole)[0]).upper() + off
    return TaylorModel(middle, whole, (off + UNIT * size + least).upper())


def _compare(a: TaylorModel, b: TaylorModel) -> bool:
    """Return whether a <= b; for equal ends either answer will do, as both are enclosed."""
    if a.ends is None or b.ends is None:
        raise NotImplementedError("rounded values are not compared")
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
