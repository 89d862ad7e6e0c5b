"""Draws of arguments: usual sizes, published ones and their limits, wide ones, ladders."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import sympy as sp

from mechproof.lab.sampling.stated_sizes import FEWEST, WIDE, Facts
from mechproof.lab.sampling.zero_sets import Columns
from mechproof.lab.ways import Array
from mechproof.record import Argument

Rng = np.random.Generator
Draw = Callable[[Rng, int], Columns]
BATCHES, HOPELESS = 8, 1
# Range from which a size is drawn if nothing is known about it.
UNKNOWN = (0.1, 10.0)
MOST_COUNTED = 1e6
# Logarithms of sizes in a range from zero go down to this share of its upper end.
SMALL = 1e-6
EPS = float(np.finfo(float).eps)
SIGNS, THIRDS, SPREADS = np.array([-1.0, 1.0]), np.array([-1.0, 0.0, 1.0]), np.array([0.02, 0.5])


def draw_inside(facts: Facts, rng: Rng, count: int, draw: Draw) -> Columns:
    """Draw in batches until `count` points lie in the domain; stop early if none do."""
    kept: list[Columns] = []
    found = 0
    for batch in range(BATCHES):
        kept.append(_keep_inside(facts, draw(rng, max(count - found, facts.part(FEWEST)))))
        found += count_points(kept[-1])
        if found >= count or (found == 0 and batch >= HOPELESS):
            break
    return {s: np.concatenate([k[s] for k in kept])[:count] for s in facts.symbols}


def _keep_inside(facts: Facts, columns: Columns) -> Columns:
    inside = facts.region.mark_inside(columns)
    return {s: columns[s][inside] for s in facts.symbols}


def pick(rng: Rng, values: Array, count: int | tuple[int, ...]) -> Array:
    """Draw from values as `rng.choice` does, in a third of the time if the values are few."""
    picked: Array = values[rng.integers(0, len(values), count)]
    return picked


def count_points(columns: Columns) -> int:
    """Return the number of points."""
    return len(next(iter(columns.values())))


def draw_mixed(facts: Facts, rng: Rng, count: int) -> Columns:
    """Draw each point in one of four ways: usual, published, roughly published, wide."""
    ways = draw_usual, draw_published, draw_about_published, draw_wide
    tables = [way(facts, rng, count) for way in ways]
    chosen = rng.integers(0, len(ways), count)
    return {s: np.choose(chosen, [table[s] for table in tables]) for s in facts.symbols}


def draw_usual(facts: Facts, rng: Rng, count: int) -> Columns:
    """Draw from the ranges between usual edges; published sizes for arguments without edges."""
    columns = dict(draw_published(facts, rng, count))
    for argument in facts.arguments:
        if argument.usual:
            edges = np.array(argument.usual)
            which = rng.integers(0, len(edges) - 1, count)
            sizes = draw_sizes(rng, edges[which], edges[which + 1], _find_beyond(facts, argument))
            columns |= _point_any_way(facts, rng, argument.symbols, sizes)
    return columns


def draw_sizes(rng: Rng, low: Array, high: Array, beyond: float = np.inf) -> Array:
    """Draw sizes between limits: evenly, by logarithm, towards a place beyond, or at the ends."""
    count = len(low)
    floor = np.where(low > 0, low, high * SMALL)
    drawn = [rng.uniform(low, high), np.exp(rng.uniform(np.log(floor), np.log(high)))]
    if np.isfinite(beyond):
        nearest = np.maximum(beyond - high, EPS)
        drawn.append(beyond - np.exp(rng.uniform(np.log(nearest), np.log(beyond - low))))
    sizes = np.choose(rng.integers(0, len(drawn), count), drawn)
    ends = np.where(rng.random(count) < 0.5, low, high)
    return np.where(rng.random(count) < 0.05, ends, np.clip(sizes, low, high))


def _find_beyond(facts: Facts, argument: Argument) -> float:
    """Return the next place beyond the largest usual size, infinity if there is none."""
    known = facts.own_places[argument.symbols[0]] if len(argument.symbols) == 1 else []
    return min((p for p in known if p >= argument.usual[-1]), default=np.inf)


def _point_any_way(facts: Facts, rng: Rng, symbols: tuple[sp.Symbol, ...], sizes: Array) -> Columns:
    """Give sizes a sign or a direction: any, along axes and diagonals, with unlike parts."""
    count = len(sizes)
    if len(symbols) == 1:
        return {symbols[0]: sign_randomly(facts, rng, symbols[0], sizes)}
    shape = (count, len(symbols))
    directions = (
        rng.uniform(-1, 1, shape),
        pick(rng, THIRDS, shape),
        pick(rng, SIGNS, shape),
        pick(rng, SIGNS, shape) * 10 ** rng.uniform(-12, 0, shape),
    )
    direction = np.choose(rng.integers(0, len(directions), (count, 1)), directions)
    largest = np.max(np.abs(direction), axis=1, keepdims=True)
    direction = direction / np.where(largest > 0, largest, 1) * sizes[:, np.newaxis]
    return dict(zip(symbols, direction.T, strict=True))


def sign_randomly(facts: Facts, rng: Rng, symbol: sp.Symbol, sizes: Array) -> Array:
    """Give sizes both signs if the domain has both; draw from its values if it has only a few."""
    if values := facts.region.list_values(symbol):
        return pick(rng, np.array(values), len(sizes))
    if facts.region.is_count(symbol):
        return np.rint(sizes)
    low, high = facts.region.ends(symbol)
    if low >= 0 or high <= 0:
        return sizes if low >= 0 else -sizes
    signed: Array = sizes * pick(rng, SIGNS, len(sizes))
    return signed


def draw_published(facts: Facts, rng: Rng, count: int) -> Columns:
    """Draw published sizes, nominal or at a limit, or usual sizes if none is published."""
    rows = rng.integers(0, max(1, len(facts.printed)), count)
    return {symbol: _draw_printed(facts, rng, symbol, rows) for symbol in facts.symbols}


def _draw_printed(facts: Facts, rng: Rng, symbol: sp.Symbol, rows: Array) -> Array:
    """Draw a size of the row, else of any row that has the symbol, else between usual ends."""
    count = len(rows)
    anywhere = facts.printed_anywhere[symbol]
    if not len(anywhere):
        edges = facts.usual.get(symbol, UNKNOWN)
        low, high = np.full(count, edges[0]), np.full(count, edges[-1])
        return sign_randomly(facts, rng, symbol, draw_sizes(rng, low, high))
    column = pick(rng, anywhere, count)
    for number, row in enumerate(facts.printed):
        if symbol in row:
            column = np.where(rows == number, pick(rng, row[symbol], count), column)
    return column


def draw_about_published(facts: Facts, rng: Rng, count: int) -> Columns:
    """Draw published sizes off by up to 2 %, or by up to half."""
    columns = draw_published(facts, rng, count)
    spread = pick(rng, SPREADS, count)
    return {
        s: c if facts.region.is_discrete(s) else c * (1 + rng.uniform(-1, 1, count) * spread)
        for s, c in columns.items()
    }


def draw_wide(facts: Facts, rng: Rng, count: int) -> Columns:
    """Draw all that the sets allow: bounded ones whole and towards both ends, others by decades."""
    columns = dict(draw_usual(facts, rng, count))
    for symbol, column in columns.items():
        low, high = facts.region.ends(symbol)
        if facts.region.is_count(symbol):
            columns[symbol] = np.rint(10 ** rng.uniform(0, np.log10(MOST_COUNTED), count))
        elif facts.region.is_discrete(symbol):
            continue
        elif np.isfinite([low, high]).all():
            columns[symbol] = _draw_bounded(rng, count, low, high)
        elif symbol not in facts.usual:
            columns[symbol] = column * WIDE ** rng.uniform(-1, 1, count)
    return columns


def _draw_bounded(rng: Rng, count: int, low: float, high: float) -> Array:
    width = high - low
    near = width * 10 ** rng.uniform(-16, 0, count)
    return np.choose(
        rng.integers(0, 3, count), [rng.uniform(low, high, count), low + near, high - near]
    )
