"""Cells of usual sizes with points inside, and the arguments of timed calls."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial

import numpy as np
import sympy as sp

from mechproof.lab.sampling.draws import UNKNOWN, Rng, count_points, draw_inside, draw_usual
from mechproof.lab.sampling.singular_points import draw_about, list_targets
from mechproof.lab.sampling.stated_sizes import FEWEST, MARGIN, Facts
from mechproof.lab.sampling.zero_sets import Columns, call, solve_linear
from mechproof.lab.ways import Arguments, Array

# A cell: the lower and upper size of its arguments, by name; other arguments are free.
Sides = Mapping[str, tuple[float, float]]
IN_CELL, MOST_TARGETS = 120, 6
# Number of periods that a timed call goes through, if a place recurs.
PERIODS = 16
SEED = 8


def draw_cell(facts: Facts, rng: Rng, cell: Sides) -> Arguments:
    """Draw points of one cell, half of them near places; arguments without edges as published.

    Raises ValueError if hardly any lie in the domain.
    """
    within = tuple(replace(a, usual=cell.get(a.name, a.usual)) for a in facts.arguments)
    narrow = replace(facts, arguments=within)
    drawn = [draw_inside(narrow, rng, IN_CELL // 2, partial(draw_usual, narrow))]
    targets = list_targets(narrow, narrow.places)
    chosen = [targets[i] for i in rng.permutation(len(targets))[:MOST_TARGETS]]
    share = -(-IN_CELL // max(1, len(chosen)))
    for target in chosen:
        about = partial(draw_about, narrow, target, targets, start=draw_usual)
        drawn.append(draw_inside(narrow, rng, share, about))
    parts = [_keep_sizes(narrow, cell, columns) for columns in drawn]
    joined = {s: np.concatenate([part[s] for part in parts])[:IN_CELL] for s in facts.symbols}
    if count_points(joined) < facts.part(FEWEST):
        raise ValueError(
            f"only {count_points(joined)} points of the cell {dict(cell)} are in the domain"
        )
    return facts.pack(joined)


def _keep_sizes(facts: Facts, cell: Sides, columns: Columns) -> Mapping[sp.Symbol, Array]:
    """Drop points whose sizes (for vectors, of the largest component) lie outside the cell."""
    kept = np.ones(count_points(columns), bool)
    for argument in facts.arguments:
        if argument.name in cell:
            size = np.max([np.abs(columns[s]) for s in argument.symbols], axis=0)
            kept &= (size >= cell[argument.name][0]) & (size <= cell[argument.name][1])
    return {s: columns[s][kept] for s in facts.symbols}


def make_workload(facts: Facts, count: int, varying: Sequence[str]) -> Arguments:
    """Return `count` values of the `varying` arguments; the others, shared, are published or usual.

    A single number rises evenly: from 0 through some periods if its places recur, else over its
    usual range. Several numbers, and vectors, are drawn evenly from their ranges.
    """
    shared = {s: _middle(facts, s) for s in facts.symbols}
    rng = np.random.default_rng(SEED)
    arguments: list[Array] = []
    for argument in facts.arguments:
        if argument.name not in varying:
            fixed = np.array([shared[s] for s in argument.symbols])
            arguments.append(fixed if len(fixed) > 1 else fixed[0])
            continue
        ranges = [_range(facts, s, shared) for s in argument.symbols]
        if len(varying) == 1 and len(ranges) == 1:
            arguments.append(_spread(facts, argument.symbols[0], ranges[0], shared, count))
        else:
            drawn = np.stack([rng.uniform(*r, count) for r in ranges], axis=-1)
            arguments.append(drawn if len(ranges) > 1 else drawn[:, 0])
    return tuple(arguments)


def _spread(
    facts: Facts,
    symbol: sp.Symbol,
    ends: tuple[float, float],
    shared: Mapping[sp.Symbol, float],
    count: int,
) -> Array:
    """Spread values evenly over the part of a range that lies in the domain."""
    values = np.linspace(*ends, count)
    others = {s: np.full(count, value) for s, value in shared.items()}
    inside = values[facts.region.mark_near({**others, symbol: values}, MARGIN)]
    return values if len(inside) in (0, count) else np.linspace(inside[0], inside[-1], count)


def _middle(facts: Facts, symbol: sp.Symbol) -> float:
    """Return a size of the published row that has most arguments, or the middle usual edge."""
    fullest = max(facts.printed, key=len, default={})
    if symbol in fullest:
        return float(fullest[symbol][0])
    if values := facts.region.list_values(symbol):
        return values[-1]
    edges = facts.usual.get(symbol)
    return edges[len(edges) // 2] if edges else sum(_unknown(facts, symbol)) / 2


def _unknown(facts: Facts, symbol: sp.Symbol) -> tuple[float, float]:
    """Return the part of a symbol's set from which an unknown size is drawn."""
    low, high = facts.region.ends(symbol)
    inside = max(low, UNKNOWN[0]), min(high, UNKNOWN[1])
    return inside if inside[0] < inside[1] else (low, high)


def _range(
    facts: Facts, symbol: sp.Symbol, shared: Mapping[sp.Symbol, float]
) -> tuple[float, float]:
    """Return the range of a varying argument."""
    period = _period(facts, symbol, shared)
    if period is not None:
        return 0.0, PERIODS * period
    fullest = max(facts.printed, key=len, default={})
    edges = facts.usual.get(symbol) or sorted(fullest.get(symbol, _unknown(facts, symbol)))
    low, high = facts.region.ends(symbol)
    return (-edges[-1] if low < 0 and symbol in facts.usual else edges[0]), min(edges[-1], high)


def _period(facts: Facts, symbol: sp.Symbol, shared: Mapping[sp.Symbol, float]) -> float | None:
    """Return the distance between neighbouring recurring places, or None without such places."""
    if facts.region.ends(symbol)[0] >= 0:
        return None
    for place in facts.singular_places:
        _, integers = place.split(facts.symbols)
        solution = solve_linear(place.gap, symbol)
        if integers and solution is not None:
            slope = sp.diff(solution, integers[0])
            values = {s: np.array(v) for s, v in shared.items()}
            return abs(float(call(slope, {**values, integers[0]: np.array(0.0)})))
    return None
