"""Models: polynomials of pieces and the reduction before them, as numbers and as programs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from mechproof.programs.program import Program
from mechproof.programs.trace import Value, choose, copysign, fma, trace

# A double so large that a sum with it is a whole number: cheaper than rounding to one.
WHOLE = 1.5 * 2.0**52


@dataclass(frozen=True)
class Piece:
    """A polynomial about a centre, lowest power first, or of odd powers alone."""

    centre: float
    coefficients: tuple[float, ...]


@dataclass(frozen=True)
class Pieces:
    """Polynomials, one after the other; `edges` are between them.

    `odd`: of odd powers, the second about where |r| ends. `mirrored`: they are right of 0, and the
    function is odd.
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
        """Return the value at what the reduction leaves."""
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
            # Half a period on or back the function is the same: which of both, the sign says.
            s = r - choose(beyond[0], copysign(last.centre, r), 0.0)
        return s * _put(s * s, beyond, [p.coefficients for p in self.pieces])


def _pick(beyond: Sequence[Value], numbers: Sequence[float]) -> Value | float:
    """Return the number of the last piece that begins before the point."""
    picked: Value | float = numbers[0]
    for condition, number in zip(beyond, numbers[1:], strict=True):
        same = not isinstance(picked, Value) and number == picked
        picked = picked if same else choose(condition, number, picked)
    return picked


def _put(z: Value, beyond: Sequence[Value], rows: Sequence[Sequence[float]]) -> Value | float:
    """Return the polynomials by Horner's rule: loops over points wait for nothing else."""
    first, *others = [_pick(beyond, column) for column in zip(*rows, strict=True)][::-1]
    value = first
    for number in others:
        value = z.apply("fma", value, z, number)
    return value


@dataclass(frozen=True)
class PeriodReduction:
    """Whole periods taken off: `words` add up to the period, `rate` is the gain over it."""

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
    """What a tailored kernel computes from `low` to `high`; beyond it gives NaN."""

    name: str
    low: float
    high: float
    reduction: PeriodReduction | None
    pieces: Pieces

    def program(self) -> Program:
        """Return the whole program, for points of the range."""
        return trace(self._write, (self.name,))

    def part(self) -> Program:
        """Return the program of what is left of the point after the reduction."""
        return trace(self.pieces.write, ("r",))

    def inside(self) -> Program:
        """Return the program that says whether a point is in the range."""
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
