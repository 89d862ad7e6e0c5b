"""Models: polynomials of pieces and the reduction before them, as numbers and as programs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from mechproof.codegen.elementary.trace import Value, choose, copysign, fma, rint, trace
from mechproof.codegen.program import Program

NAN = Value([], "#nan")


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
        before = [w < edge for edge in self.edges]
        s = w - _pick(before, [p.centre for p in self.pieces])
        value = _put(s, before, [p.coefficients for p in self.pieces])
        assert isinstance(value, Value)
        return value * copysign(1.0, r) if self.mirrored else value

    def _write_odd(self, r: Value) -> Value:
        *_, last = self.pieces
        before, s = [], r
        if self.edges:
            # Half a period on or back the function is the same: which of both, the sign says.
            (edge,) = self.edges
            before = [abs(r) < edge]
            s = r - choose(before[0], 0.0, copysign(last.centre, r))
        return s * _put(s * s, before, [p.coefficients for p in self.pieces])


def _pick(before: Sequence[Value], numbers: Sequence[float]) -> Value | float:
    """Return the number of the first piece that ends beyond the point."""
    *others, value = numbers
    picked: Value | float = value
    for condition, number in zip(reversed(before), reversed(others), strict=True):
        picked = picked if number == picked else choose(condition, number, picked)
    return picked


def _put(z: Value, before: Sequence[Value], rows: Sequence[Sequence[float]]) -> Value | float:
    """Return the polynomials by Horner's rule: loops over points wait for nothing else."""
    first, *others = [_pick(before, column) for column in zip(*rows, strict=True)][::-1]
    value = first
    for number in others:
        value = z.apply("fma", value, z, number)
    return value


@dataclass(frozen=True)
class Reduction:
    """Whole periods taken off: `words` add up to the period, `rate` is the gain over it."""

    words: tuple[float, ...]
    per_period: float
    rate: float

    def write(self, point: Value) -> Value:
        """Return the point less the nearest number of periods."""
        count = rint(point * self.per_period)
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
    reduction: Reduction | None
    pieces: Pieces

    def program(self) -> Program:
        """Return the whole program."""
        return trace(self._write, (self.name,))

    def part(self) -> Program:
        """Return the program of what is left of the point after the reduction."""
        return trace(self.pieces.write, ("r",))

    def _write(self, point: Value) -> Value:
        # At once: what lies far out would overflow on its way.
        point = choose(self._write_inside(point), point, NAN)
        reduction = self.reduction
        value = self.pieces.write(reduction.write(point) if reduction else point)
        if reduction and reduction.rate:
            return point.apply("fma", reduction.rate, point, value)
        return value

    def _write_inside(self, point: Value) -> Value:
        if self.low == -self.high:
            return point.apply("less_equal", abs(point), self.high)
        above = point.apply("greater_equal", point, self.low)
        return above.apply("both", above, point.apply("less_equal", point, self.high))
