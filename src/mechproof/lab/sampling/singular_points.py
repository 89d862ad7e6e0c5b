"""Point sets made from what the derivation states: near places, where they meet, tiny sizes.

A place is a singular set or an edge of the domain. Its equation is solved for each of its arguments
in turn, with the others drawn. Points are the nearest double, doubles up to 1000 ulps off, and
points at logarithmic distances on both sides. Where several places meet, the last one is left by
distances about the product of the others', which is how wide a peak usually is there.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial

import numpy as np
import sympy as sp

from mechproof.kernel_support.order import step_ulps
from mechproof.lab.sampling.draws import SIGNS, Rng, count_points, draw_inside, draw_mixed, pick
from mechproof.lab.sampling.named_sets import PointSet, draw_ladder
from mechproof.lab.sampling.stated_sizes import FEWEST, Facts
from mechproof.lab.sampling.zero_sets import Columns, ZeroSet, find_integers, find_roots
from mechproof.lab.ways import Arguments, Array

GENERIC, ALONE, MEETING, FAR, TINY = 300, 80, 200, 300, 160
MOST_OTHERS, PASSES, PARTS = 2, 3, 10
SMALL_INTEGERS = 4
DECADES = 16.0
TINIEST, HUGEST = 1e-290, 1e200


@dataclass(frozen=True)
class SingularTarget:
    """A place and the argument that is moved onto it."""

    place: ZeroSet
    symbol: sp.Symbol

    def leaves(self, other: SingularTarget) -> bool:
        """Return whether moving onto this place does not move off the other."""
        return self.symbol not in other.place.symbols


def list_point_sets(facts: Facts) -> tuple[PointSet, ...]:
    """Return the sets of a quantity: generic, about each singular place, the edges, far, tiny."""
    groups: list[tuple[str, tuple[ZeroSet, ...]]] = [
        (place.text, (place,)) for place in facts.singular_places
    ]
    if facts.edges:
        groups.append(("edges of the domain", facts.edges))
    far = (PointSet("far", partial(_make_far, facts)),) if _list_recurring(facts) else ()
    return (
        PointSet("generic", partial(_make_generic, facts)),
        *(
            PointSet(f"{number}: {text}", partial(_make_about, facts, list_targets(facts, places)))
            for number, (text, places) in enumerate(groups, 1)
        ),
        *far,
        PointSet("tiny", partial(_make_tiny, facts)),
    )


def list_targets(facts: Facts, places: tuple[ZeroSet, ...]) -> list[SingularTarget]:
    """Return every pair of a place and an argument that can be moved onto it by any distance."""
    return [
        SingularTarget(place, symbol)
        for place in places
        for symbol in facts.symbols
        if symbol in place.symbols and not facts.region.is_discrete(symbol)
    ]


def _make_generic(facts: Facts, rng: Rng) -> Arguments:
    count = GENERIC if facts.places else 2 * GENERIC
    drawn = draw_inside(facts, rng, facts.part(count), partial(draw_mixed, facts))
    return facts.pack(_refuse_few(facts, drawn, "generic"))


def _make_about(facts: Facts, targets: list[SingularTarget], rng: Rng) -> Arguments:
    """Draw about a third of the points near the place alone, the others where it meets others."""
    known = list_targets(facts, facts.places)
    drawn = _fill(facts, rng, targets, [], ALONE) + _fill(facts, rng, targets, known, MEETING)
    joined = {s: np.concatenate([d[s] for d in drawn]) for s in facts.symbols}
    return facts.pack(_refuse_few(facts, joined, targets[0].place.text))


def _fill(
    facts: Facts, rng: Rng, targets: list[SingularTarget], known: list[SingularTarget], count: int
) -> list[Columns]:
    """Draw `count` points, shared out evenly among the targets that can be met in the domain."""
    drawn: list[Columns] = []
    missing = wanted = facts.part(count)
    # With fewer points than targets, some of the targets get one point each.
    targets = [targets[i] for i in rng.permutation(len(targets))[:wanted]]
    for _ in range(PASSES):
        if missing <= 0:
            break
        share, fruitful = -(-missing // len(targets)), []
        for target in targets:
            drawn.append(draw_inside(facts, rng, share, partial(draw_about, facts, target, known)))
            fruitful += [target] if count_points(drawn[-1]) else []
        targets = fruitful or targets
        missing = wanted - sum(map(count_points, drawn))
    return drawn


def _refuse_few(facts: Facts, columns: Columns, name: str) -> Columns:
    if count_points(columns) < facts.part(FEWEST):
        raise ValueError(f"{name}: only {count_points(columns)} points lie in the domain")
    return columns


def draw_about(
    facts: Facts,
    target: SingularTarget,
    known: list[SingularTarget],
    rng: Rng,
    count: int,
    start: Callable[[Facts, Rng, int], Columns] = draw_mixed,
) -> Columns:
    """Draw points about a place, after moving other arguments near places of theirs."""
    columns, width = start(facts, rng, count), np.ones(count)
    for other in _choose_others(rng, [t for t in known if target.leaves(t)]):
        columns, distance = _move_onto(facts, rng, other, columns, np.ones(count))
        width = width * np.where(distance > 0, np.minimum(distance, 1), 1)
    return _move_onto(facts, rng, target, columns, width)[0]


def _choose_others(rng: Rng, free: list[SingularTarget]) -> list[SingularTarget]:
    """Choose one or two targets, every place equally likely however many arguments it has."""
    places = list(dict.fromkeys(t.place for t in free))
    chosen = rng.permutation(len(places))[: rng.integers(1, MOST_OTHERS + 1)]
    groups = [[t for t in free if t.place == places[index]] for index in chosen]
    return [group[rng.integers(len(group))] for group in groups]


def _move_onto(
    facts: Facts, rng: Rng, target: SingularTarget, columns: Columns, width: Array
) -> tuple[Columns, Array]:
    """Move an argument near a place; return also its distance relative to the argument's size."""
    place, symbol = target.place, target.symbol
    integers = _draw_integers(facts, rng, place, columns)
    values = {s: columns[s] for s in facts.symbols if s in place.symbols}
    roots = find_roots(
        place,
        symbol,
        {**values, **integers},
        facts.region.ends(symbol),
        lambda guesses: (
            facts.mark_in_reach(symbol, guesses, recurring=bool(integers))
            & facts.region.mark_near({**columns, symbol: guesses})
        ),
    )
    period = 1.0 if integers else np.inf
    size = np.where(roots == 0, np.abs(columns[symbol]), np.minimum(np.abs(roots), period))
    moved = _spread(rng, roots, size, width)
    with np.errstate(all="ignore"):
        distance = np.abs(moved - roots) / np.where(size > 0, size, 1.0)
    return {**columns, symbol: moved}, distance


def _draw_integers(
    facts: Facts, rng: Rng, place: ZeroSet, columns: Columns
) -> Mapping[sp.Symbol, Array]:
    """Draw integers: the ones nearest to the values drawn, and small ones."""
    _, integers = place.split(facts.symbols)
    found = {}
    for integer in integers:
        small = rng.integers(-SMALL_INTEGERS, SMALL_INTEGERS + 1, count_points(columns))
        nearest = find_integers(place, integer, columns)
        near = small if nearest is None else np.where(np.isfinite(nearest), nearest, small)
        found[integer] = np.where(rng.random(len(small)) < 0.3, small, near).astype(float)
    return found


def _spread(rng: Rng, roots: Array, size: Array, width: Array) -> Array:
    """Return roots, doubles next to them, and points at distances of all magnitudes from them."""
    count = len(roots)
    side = pick(rng, SIGNS, count)
    ulps = np.rint(side * 10 ** rng.uniform(0, 3, count))
    with np.errstate(all="ignore"):
        ladder = roots + side * size * 10 ** rng.uniform(-DECADES, 0, count)
        lowest = np.where(rng.random(count) < 0.5, TINIEST, 10**-DECADES)
        tiny = side * lowest ** rng.random(count)
        peak = roots + side * size * width * 10 ** rng.uniform(-3, 2, count)
    beside = np.where(np.isfinite(roots), step_ulps(np.nan_to_num(roots), ulps), np.nan)
    # Not the neighbours of zero: these are subnormals, which have lost their digits.
    ways = [roots, *(np.where(roots == 0, tiny, way) for way in (beside, ladder)), peak]
    moved: Array = np.choose(rng.choice(4, count, p=[0.25, 0.15, 0.3, 0.3]), ways)
    return moved


def _make_far(facts: Facts, rng: Rng) -> Arguments:
    count = max(1, facts.part(FAR) // PARTS)
    shares = [draw_inside(facts, rng, count, partial(_draw_far, facts)) for _ in range(PARTS)]
    joined = {s: np.concatenate([share[s] for share in shares]) for s in facts.symbols}
    return facts.pack(_refuse_few(facts, joined, "far"))


def _draw_far(facts: Facts, rng: Rng, count: int) -> Columns:
    """Draw turning arguments up to their largest usual size, and others near places.

    Half of the draws are then moved near a recurring place, mostly the nearest.
    """
    columns, width, turning = draw_mixed(facts, rng, count), np.ones(count), _list_recurring(facts)
    targets = list_targets(facts, facts.places)
    for other in _choose_others(rng, [t for t in targets if t.symbol not in turning]):
        columns, distance = _move_onto(facts, rng, other, columns, np.ones(count))
        width = width * np.where(distance > 0, np.minimum(distance, 1), 1)
    far = {s: rng.uniform(-1, 1, count) * facts.usual[s][-1] for s in turning}
    columns = {**columns, **far}
    if rng.random() < 0.5:
        there = [t for t in targets if t.symbol in turning and t.place.split(facts.symbols)[1]]
        columns, _ = _move_onto(facts, rng, there[rng.integers(len(there))], columns, width)
    return columns


def _list_recurring(facts: Facts) -> list[sp.Symbol]:
    """Return the arguments of recurring places that have both signs and usual sizes."""
    recurring = [p for p in facts.singular_places if p.split(facts.symbols)[1]]
    return [
        s
        for s in facts.usual
        if facts.region.ends(s)[0] < 0 and any(s in place.symbols for place in recurring)
    ]


def _make_tiny(facts: Facts, rng: Rng) -> Arguments:
    drawn = draw_inside(facts, rng, facts.part(TINY), partial(_draw_tiny, facts))
    return facts.pack(_refuse_few(facts, drawn, "tiny"))


def _draw_tiny(facts: Facts, rng: Rng, count: int) -> Columns:
    """Draw arguments that may vanish logarithmically towards zero, each at half of the points.

    The sole argument of a quantity is bounded only by the range of doubles.
    """
    columns = dict(draw_mixed(facts, rng, count))
    largest = HUGEST if len(facts.arguments) == 1 else 1.0
    for group in _list_vanishing(facts):
        lowest = TINIEST if rng.random() < 0.5 else 10**-DECADES
        ladder = rng.permutation(draw_ladder(rng, count, lowest, largest))
        ladder = np.where(rng.random(count) < 0.1, 0.0, ladder)
        chosen = rng.random(count) < 0.5
        for symbol in group:
            part = ladder * rng.uniform(-1, 1, count) if len(group) > 1 else ladder
            sized = np.abs(part) if facts.region.ends(symbol)[0] >= 0 else part
            columns[symbol] = np.where(chosen, sized, columns[symbol])
    return columns


def _list_vanishing(facts: Facts) -> Iterator[tuple[sp.Symbol, ...]]:
    """Yield the symbols of arguments that may be arbitrarily small."""
    for argument in facts.arguments:
        ends = [facts.region.ends(s) for s in argument.symbols]
        if all(low <= 0 <= high and (low < 0 or np.isfinite(high)) for low, high in ends):
            yield argument.symbols
