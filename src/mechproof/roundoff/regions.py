"""Regions: in, a chart; out, ranges of its coordinates within which whole turns are told apart.

An angle below half a turn is a coordinate itself. Beyond, its rest is one, and so is, for many
turns, the reciprocal of the whole angle.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import sympy as sp
from flint import arb

from mechproof.proof.balls import to_ball
from mechproof.record import Chart
from mechproof.roundoff.angles import Turn
from mechproof.roundoff.germs import Frame, Germ, ball_between, raise_ball

Side = tuple[float, float]
Box = tuple[Side, ...]
# Half a turn and a little: where the nearest number of turns is no matter of rounding.
HALF_TURN = math.pi * (1 + 2.0**-40)
# Turns that are told apart; more are one region.
APART = 4


@dataclass(frozen=True)
class Region:
    """A box of coordinates; of an angle beyond half a turn the rest, and the number of turns.

    Without a number the last side is the reciprocal of the whole angle.
    """

    chart: Chart
    names: tuple[sp.Symbol, ...]
    box: Box
    is_turned: bool = False
    turns: int | None = None

    def describe(self) -> str:
        """Name the region."""
        if not self.is_turned:
            return "no turn" if self.chart.angle else "all"
        return f"{self.turns} turns" if self.turns else f"{APART} turns and more"

    def enter(self, box: Box, poles: int) -> tuple[Frame, dict[sp.Symbol, Germ], Turn | None]:
        """Return the frame of a box, its coordinates as germs and the angle's turn."""
        balls = [ball_between(*side) for side in box]
        positive = [low >= 0 for low, _ in box]
        if not self.is_turned:
            frame = Frame(balls, positive, poles)
            return frame, self._name(frame), None
        rest = balls[self.names.index(self.angle)]
        inverse = balls.pop() if self.turns is None else 1 / (2 * arb.pi() * self.turns + rest)
        frame = Frame([*balls, inverse], [*positive[: len(balls)], True], poles)
        whole = frame.variable(len(balls), -1)
        germs = {**self._name(frame), self.angle: whole}
        return frame, germs, Turn(whole.powers, rest, 1 / inverse)

    def _name(self, frame: Frame) -> dict[sp.Symbol, Germ]:
        return {name: frame.variable(i) for i, name in enumerate(self.names)}

    @property
    def angle(self) -> sp.Symbol:
        """Return the angle that is taken off by whole turns."""
        assert self.chart.angle is not None
        return self.chart.angle


def express(value: sp.Expr, frame: Frame, germs: Mapping[sp.Symbol, Germ]) -> Germ:
    """Return the germ of a polynomial in coordinates."""
    if value in germs:
        return germs[value]
    if value.is_Number:
        return frame.constant(to_ball(value))
    parts = [express(part, frame, germs) for part in value.args[:1] if value.is_Pow] or [
        express(part, frame, germs) for part in value.args
    ]
    if value.is_Pow:
        return _raise(parts[0], int(value.args[1]))
    if not (value.is_Add or value.is_Mul):
        raise ValueError(f"chart: {value} is no polynomial of its coordinates")
    total = parts[0]
    for part in parts[1:]:
        total = total + part if value.is_Add else total * part
    return total


def _raise(germ: Germ, power: int) -> Germ:
    return Germ(germ.frame, raise_ball(germ.ball, power), tuple([power * p for p in germ.powers]))


def list_regions(chart: Chart) -> Iterator[Region]:
    """Divide a chart by whole turns of its angle; negative angles go by symmetry."""
    names = tuple(chart.within)
    box = tuple(_enclose(chart.within[name]) for name in names)
    if chart.angle is None:
        yield Region(chart, names, box)
        return
    index = names.index(chart.angle)
    low, high = box[index]
    if not 0 <= low <= math.pi < HALF_TURN < high:
        raise ValueError(f"chart: the angle {chart.angle} must reach beyond half a turn")
    if low == 0:
        yield Region(chart, names, put_side(box, index, (0.0, HALF_TURN)))
    rest = put_side(box, index, (-HALF_TURN, HALF_TURN))
    for turns in range(1, APART):
        yield Region(chart, names, rest, True, turns)
    last = 2 * math.pi * APART - HALF_TURN
    inverse = (math.nextafter(1 / high, 0), math.nextafter(1 / last, 1))
    yield Region(chart, names, (*rest, inverse), True)


def _enclose(interval: sp.Interval) -> Side:
    """Return doubles on or beyond the ends of an interval."""
    start, end = float(interval.inf), float(interval.sup)
    start = (
        start
        if interval.inf.is_infinite or sp.Rational(start) <= interval.inf
        else math.nextafter(start, -math.inf)
    )
    end = (
        end
        if interval.sup.is_infinite or sp.Rational(end) >= interval.sup
        else math.nextafter(end, math.inf)
    )
    return start, end


def put_side(box: Sequence[Side], index: int, side: Side) -> Box:
    """Return a box with another side."""
    return (*box[:index], side, *box[index + 1 :])
