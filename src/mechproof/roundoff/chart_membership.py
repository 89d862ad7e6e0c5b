"""Chart membership: in, a form's charts; out, whether arguments lie in one, but for signs.

The coordinates of arguments are what their expressions are solved for. What is turned has the
nearest number of turns; any other would do, where a rest that is in its range is a proof.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, reduce
from operator import and_, or_
from typing import Any

import sympy as sp

from mechproof.programs.lowering import CONSTANTS, lower_steps
from mechproof.programs.operations import Arithmetic
from mechproof.programs.program import Program
from mechproof.record import Chart, Form
from mechproof.roundoff.running import Values, run
from mechproof.roundoff.symmetry import ODD, list_negated

TURNS, PI = sp.Symbol("turns"), CONSTANTS[sp.pi]
Signs = frozenset[str]
# What is less is a rounding.
NEAR = 1e-9


@dataclass(frozen=True)
class ChartMembership:
    """Of each chart what is not negative inside; whose signs may change without a difference."""

    gaps: tuple[Program, ...]
    signs: tuple[Signs, ...]

    def holds(self, given: Mapping[str, Any], arithmetic: Arithmetic) -> Any:
        """Say where arguments are for certain inside."""
        given = {PI: arithmetic["arctan"](arithmetic["number"](1)) * 4, **given}
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
    # What is no coordinate's is one number.
    fixed = {symbol: value for symbol, value in chart.arguments.items() if value.is_number}
    equations = [v - drawn[symbol] for symbol, v in chart.arguments.items() if symbol not in fixed]
    if chart.rest is not None:
        equations.append(chart.rest + 2 * sp.pi * TURNS - chart.angle)
    found = _solve(tuple(equations), tuple(chart.within))
    if len(found) > 1:
        found = [place for place in found if _is_at_middle(chart, drawn, place)]
    if len(found) != 1 or found[0].keys() != chart.within.keys():
        raise ValueError(f"chart: {chart.arguments} do not tell their coordinates")
    (place,) = found
    gaps = [gap for name, side in chart.within.items() for gap in _list_gaps(place[name], side)]
    gaps += [off for s, v in fixed.items() for off in (drawn[s] - v, v - drawn[s])]
    inputs = {drawn[symbol]: names[symbol] for symbol in chart.arguments}
    return lower_steps(
        inputs, frozenset(), tuple(inputs.values()), _count_turns(chart, place), gaps
    )


@cache
def _draw(symbol: sp.Basic) -> sp.Dummy:
    """Return what stands for the value of an argument, the same in all charts."""
    return sp.Dummy(str(symbol))


@cache
def _solve(
    equations: tuple[sp.Expr, ...], coordinates: tuple[sp.Symbol, ...]
) -> Sequence[Mapping[sp.Symbol, sp.Expr]]:
    """Solve equations, once for all kernels with these charts.

    Solutions of other signs of roots are not left out here: that takes SymPy as long again.
    """
    found: list[dict[sp.Symbol, sp.Expr]] = sp.solve(equations, coordinates, dict=True, check=False)
    return found


def _is_at_middle(
    chart: Chart, drawn: Mapping[sp.Basic, sp.Dummy], place: Mapping[sp.Symbol, sp.Expr]
) -> bool:
    """Say whether a solution is that of the two signs of a root which the coordinates have."""
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
    """List how far a coordinate is above and below the ends of its range."""
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
