"""Regions: in, a chart; out, boxes of its coordinates, divided by the number of whole turns.

An angle below half a turn is itself a coordinate. Beyond that its rest after whole turns is one
and, for many turns, so is the reciprocal of the whole angle. Whether arguments lie in a chart, up
to signs, is decided by their coordinates, for which the chart's expressions are solved. A turned
angle takes the nearest number of turns; any number would do for which the rest lies in its range.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, reduce
from operator import and_, or_
from typing import Any

import numpy as np
import sympy as sp

from mechproof.arithmetic.balls import to_ball
from mechproof.arithmetic.cover import Box, Boxes, Side
from mechproof.arithmetic.intervals import ONE, PI, Interval, enclose_ball, exactly, list_spans
from mechproof.programs.lowering import CONSTANTS, lower_steps
from mechproof.programs.operations import SYMBOLIC, Arithmetic
from mechproof.programs.program import Program
from mechproof.record import Chart, Form
from mechproof.roundoff.angles import Turn
from mechproof.roundoff.interval_monomials import BoxVariables, IntervalMonomial
from mechproof.roundoff.running import Values, add_exactly, run
from mechproof.roundoff.steps import EXACT, StraightLineProgram
from mechproof.roundoff.symmetry import ODD, list_negated

POLYNOMIAL = ("add", "subtract", "multiply", "square", "negate")
# Slightly more than half a turn, to include angles whose number of turns depends on rounding.
HALF_TURN = math.pi * (1 + 2.0**-40)
# Each number of turns below this has its own region, with a lower limit where the rest has
# coordinates; all higher numbers share one region.
APART, APART_FROM_REST = 4, 2
TURNS, PI_NAME = sp.Symbol("turns"), CONSTANTS[sp.pi]
Signs = frozenset[str]
# Differences below this are attributed to rounding.
NEAR = 1e-9


@dataclass(frozen=True)
class ChartRegion:
    """A box of coordinates; for an angle beyond half a turn, of its rest after `turns` turns.

    If a turned region has no number of turns, the last side is the reciprocal of the whole angle.
    """

    chart: Chart
    names: tuple[sp.Symbol, ...]
    box: Box
    is_turned: bool = False
    turns: int | None = None

    def describe(self) -> str:
        """Return the region's name by its number of turns."""
        if not self.is_turned:
            return "no turn" if self.chart.angle else "all"
        return "more turns" if self.turns is None else f"{self.turns} turns"

    def enter(
        self,
        boxes: Boxes,
        poles: int,
        forced: tuple[int, ...] = (),
        zeros: int = 0,
        *,
        has_forms: bool = False,
        is_bent: bool = False,
    ) -> tuple[BoxVariables, dict[sp.Symbol, IntervalMonomial], Turn | None]:
        """Return the variables of boxes, the coordinates as monomials, and the angle's turn.

        `poles` and `zeros` are the numbers of variables to reserve for poles and vanishing values.
        """
        spans = list_spans(boxes, has_forms=has_forms, is_bent=is_bent)
        if self.turns is not None:
            # Placeholder for the reciprocal of the angle, which is set once the rest is known.
            spans.append(ONE)
        nonzero = {i for i, name in enumerate(self.names) if self._leaves_zero_out(name)}
        variables = BoxVariables(spans, self._list_positive(boxes), poles, forced, zeros, nonzero)
        monomials = {name: variables.variable(i) for i, name in enumerate(self.names)}
        if not self.is_turned:
            return variables, monomials, None
        residue, offset = self._find_residue(variables, monomials)
        if self.turns is not None:
            whole = PI * exactly(2.0 * self.turns + offset) + residue.expanded()
            variables.spans[len(self.names)] = ONE / whole
        inverse = variables.spans[len(self.names)]
        angle = variables.variable(len(self.names), -1)
        turn = Turn(angle.powers, residue, ONE / inverse, bool(offset))
        return variables, {**monomials, self.angle: angle}, turn

    def count_first(self) -> int:
        """Count the sides to cut first: all, except a whole angle's whose rest has coordinates."""
        return len(self.box) if self.chart.rest is None else len(self.names)

    def _find_residue(
        self, variables: BoxVariables, monomials: Mapping[sp.Symbol, IntervalMonomial]
    ) -> tuple[IntervalMonomial, int]:
        """Return the rest of the angle, and the half turns (0 or 1) taken off with whole ones."""
        if self.chart.rest is None:
            return variables.constant(monomials[self.angle].expanded()), 0
        half = self.chart.rest.subs(dict.fromkeys(monomials, 0))
        if half not in (0, sp.pi):
            raise ValueError(f"chart: {self.chart.rest} is not near a multiple of half a turn")
        return express(sp.expand(self.chart.rest - half), variables, monomials), int(half / sp.pi)

    def _leaves_zero_out(self, name: sp.Symbol) -> bool:
        within = self.chart.within[name]
        return bool(within.inf == 0 and within.left_open)

    def _list_positive(self, boxes: Boxes) -> list[bool]:
        """List whether each coordinate, and the inverse of a turned angle, is never negative."""
        positive = [bool(np.all(boxes[:, i, 0] >= 0)) for i in range(len(self.names))]
        return [*positive, True] if self.is_turned else positive

    @property
    def angle(self) -> sp.Symbol:
        """Return the angle that is reduced by whole turns."""
        assert self.chart.angle is not None
        return self.chart.angle


def express(
    value: sp.Expr, variables: BoxVariables, monomials: Mapping[sp.Symbol, IntervalMonomial]
) -> IntervalMonomial:
    """Return the monomial of a polynomial in coordinates; ValueError for anything else."""
    if value in monomials:
        return monomials[value]
    if value.is_Number:
        number = float(value)
        span = exactly(number) if sp.Rational(number) == value else enclose_ball(to_ball(value))
        return variables.constant(span)
    parts = [express(part, variables, monomials) for part in value.args[:1] if value.is_Pow] or [
        express(part, variables, monomials) for part in value.args
    ]
    if value.is_Pow:
        return parts[0].power(int(value.args[1]))
    if not (value.is_Add or value.is_Mul):
        raise ValueError(f"chart: {value} is not a polynomial in its coordinates")
    total = parts[0]
    for part in parts[1:]:
        total = _add_nearly(total, part) if value.is_Add else total * part
    return total


def _add_nearly(one: IntervalMonomial, other: IntervalMonomial) -> IntervalMonomial:
    """Return a sum whose ends are moved outwards only where they are rounded.

    So 1 - d is at most 1 where d is not negative, and an end crosses a power of two only if the
    sum itself does.
    """
    total = one + other
    if any(total.powers):
        return total
    a, b = one.expanded(), other.expanded()
    (low, below), (high, above) = add_exactly(a.low, b.low), add_exactly(a.high, b.high)
    span = Interval(
        np.where(below == 0, low, total.span.low),
        np.where(above == 0, high, total.span.high),
        form=total.span.form,
    )
    return IntervalMonomial(total.variables, span, total.powers)


def list_regions(chart: Chart) -> Iterator[ChartRegion]:
    """Yield a chart's regions by whole turns of its angle; symmetry covers negative angles."""
    names = tuple(chart.within)
    box = tuple(_enclose(chart.within[name]) for name in names)
    if chart.angle is None:
        yield ChartRegion(chart, names, box)
        return
    index = names.index(chart.angle)
    low, high = box[index]
    if chart.rest is not None:
        others = (*names[:index], *names[index + 1 :])
        yield from _list_turned(chart, others, (*box[:index], *box[index + 1 :]), high)
        return
    if not 0 <= low <= math.pi < HALF_TURN < high:
        raise ValueError(f"chart: the angle {chart.angle} must reach beyond half a turn")
    if low == 0:
        yield ChartRegion(chart, names, put_side(box, index, (0.0, HALF_TURN)))
    rest = put_side(box, index, (-HALF_TURN, HALF_TURN))
    yield from _list_turned(chart, names, rest, high)


def _list_turned(
    chart: Chart, names: tuple[sp.Symbol, ...], box: Box, high: float
) -> Iterator[ChartRegion]:
    """Yield a region for each number of turns below `high` radians, and one for many."""
    is_half = chart.rest is not None and chart.rest.has(sp.pi)
    apart = APART if chart.rest is None else APART_FROM_REST
    for turns in range(0 if is_half else 1, apart):
        if 2 * math.pi * turns - (0 if is_half else HALF_TURN) < high:
            yield ChartRegion(chart, names, box, True, turns)
    last = 2 * math.pi * apart - HALF_TURN
    if last < high:
        # The reciprocals of unbounded angles form a bounded box.
        inverse = (math.nextafter(1 / high, 0), math.nextafter(1 / last, 1))
        yield ChartRegion(chart, names, (*box, inverse), True)


def _enclose(interval: sp.Interval) -> Side:
    """Return the doubles at or just beyond the ends of an interval."""
    start, end = float(interval.inf), float(interval.sup)
    if interval.inf.is_finite and sp.Rational(start) > interval.inf:
        start = math.nextafter(start, -math.inf)
    if interval.sup.is_finite and sp.Rational(end) < interval.sup:
        end = math.nextafter(end, math.inf)
    return start, end


def put_side(box: Sequence[Side], index: int, side: Side) -> Box:
    """Return a box with one side replaced."""
    return (*box[:index], side, *box[index + 1 :])


def add_up(
    straight: StraightLineProgram, chart: Chart, names: Mapping[sp.Basic, str]
) -> Mapping[str, sp.Expr]:
    """Return the results that are sums of arguments and numbers, written in coordinates.

    What cancels in coordinates, such as 1 - e for e = 1 - d, thus cancels symbolically.
    """
    values = {names[symbol]: value for symbol, value in chart.arguments.items()}
    sums: dict[str, sp.Expr] = {}
    for step in straight.steps:
        given = [values.get(o) if isinstance(o, str) else sp.Rational(o) for o in step.operands]
        if step.kind in POLYNOMIAL and all(value is not None for value in given):
            value = _factor(SYMBOLIC[step.kind](*given))
            if step.kind in ("add", "subtract"):
                sums[step.result] = value
            if step.ulps == EXACT:
                values[step.result] = value
    return sums


@cache
def _factor(value: sp.Expr) -> sp.Expr:
    """Factor a sum; cached, as all ways of computing a form share their sums."""
    return sp.factor(value)


@dataclass(frozen=True)
class ChartMembership:
    """Gaps that are nonnegative inside each chart, and sets of arguments that may be negated."""

    gaps: tuple[Program, ...]
    signs: tuple[Signs, ...]

    def holds(self, given: Mapping[str, Any], arithmetic: Arithmetic) -> Any:
        """Return where arguments are certainly inside a chart, up to signs."""
        given = {PI_NAME: arithmetic["arctan"](arithmetic["number"](1)) * 4, **given}
        turned = ({n: -v if n in names else v for n, v in given.items()} for names in self.signs)
        return reduce(or_, (_hold(gaps, some, arithmetic) for some in turned for gaps in self.gaps))


def _hold(gaps: Program, given: Values, arithmetic: Arithmetic) -> Any:
    return reduce(and_, (gap >= 0 for gap in run(gaps, given, arithmetic)))


def find_membership(form: Form, names: Mapping[sp.Basic, str]) -> ChartMembership:
    """Solve the charts of a form; ValueError for one without unique coordinates."""
    gaps = tuple(_write_gaps(chart, names) for chart in form.charts)
    return ChartMembership(gaps, tuple(dict.fromkeys(_list_signs(form, names))))


def _list_signs(form: Form, names: Mapping[sp.Basic, str]) -> Iterator[Signs]:
    yield frozenset()
    for given in list_negated(form, names):
        yield frozenset(name for name, parity in given.items() if parity == ODD)


def _write_gaps(chart: Chart, names: Mapping[sp.Basic, str]) -> Program:
    drawn = {symbol: _draw(symbol) for symbol in chart.arguments}
    # Arguments that depend on no coordinate are fixed numbers.
    fixed = {symbol: value for symbol, value in chart.arguments.items() if value.is_number}
    equations = [v - drawn[symbol] for symbol, v in chart.arguments.items() if symbol not in fixed]
    if chart.rest is not None:
        equations.append(chart.rest + 2 * sp.pi * TURNS - chart.angle)
    found = _solve(tuple(equations), tuple(chart.within))
    if len(found) > 1:
        found = [place for place in found if _is_at_middle(chart, drawn, place)]
    if len(found) != 1 or found[0].keys() != chart.within.keys():
        raise ValueError(f"chart: {chart.arguments} do not determine their coordinates")
    (place,) = found
    gaps = [gap for name, side in chart.within.items() for gap in _list_gaps(place[name], side)]
    gaps += [off for s, v in fixed.items() for off in (drawn[s] - v, v - drawn[s])]
    inputs = {drawn[symbol]: names[symbol] for symbol in chart.arguments}
    return lower_steps(
        inputs, frozenset(), tuple(inputs.values()), _count_turns(chart, place), gaps
    )


@cache
def _draw(symbol: sp.Basic) -> sp.Dummy:
    """Return the symbol for the value of an argument, the same in all charts."""
    return sp.Dummy(str(symbol))


@cache
def _solve(
    equations: tuple[sp.Expr, ...], coordinates: tuple[sp.Symbol, ...]
) -> Sequence[Mapping[sp.Symbol, sp.Expr]]:
    """Solve equations for coordinates; cached for all kernels with these charts.

    Solutions with a wrong sign of a root are kept: to check them takes SymPy as long again.
    """
    found: list[dict[sp.Symbol, sp.Expr]] = sp.solve(equations, coordinates, dict=True, check=False)
    return found


def _is_at_middle(
    chart: Chart, drawn: Mapping[sp.Basic, sp.Dummy], place: Mapping[sp.Symbol, sp.Expr]
) -> bool:
    """Return whether a solution, of those by the signs of roots, recovers the middle of a chart."""
    middle = {
        name: (side.inf + side.sup) / 2 if side.sup.is_finite else sp.S.One
        for name, side in chart.within.items()
    }
    arguments = {drawn[symbol]: value.subs(middle) for symbol, value in chart.arguments.items()}
    return all(
        name in place and abs(sp.N(place[name].subs(arguments) - value)) < NEAR
        for name, value in middle.items()
    )


def _list_gaps(value: sp.Expr, side: sp.Interval) -> Iterator[sp.Expr]:
    """Yield how far a coordinate is inside each finite end of its range."""
    if side.inf.is_finite:
        yield value - side.inf
    if side.sup.is_finite:
        yield side.sup - value


def _count_turns(
    chart: Chart, place: Mapping[sp.Symbol, sp.Expr]
) -> Sequence[tuple[sp.Symbol, sp.Expr]]:
    if chart.rest is None:
        return []
    half = chart.rest.subs(dict.fromkeys(chart.within, 0))
    return [(TURNS, sp.floor((place[chart.angle] - half) / (2 * sp.pi) + sp.S.Half))]
