"""The search: from the worst points of all sets uphill to worse inputs, where a bound is stated.

Balls evaluate hundreds of points; then long doubles evaluate millions, and balls judge the finds.
Bad inputs belong in the regression table. S3FP (Chiang et al. 2014) narrows ranges of inputs at
random instead of moving points.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Any

import numpy as np
import sympy as sp

from mechproof.arithmetic import balls
from mechproof.arithmetic.balls import evaluate
from mechproof.lab.extended_oracle import extend
from mechproof.lab.oracle import (
    PRECISIONS,
    Truth,
    count_points,
    find_errors,
    find_truth,
    give_balls,
    list_values,
)
from mechproof.lab.sampling.named_sets import TUNE, choose_evenly, draw_points, join
from mechproof.lab.sampling.point_sets import list_sets
from mechproof.lab.sampling.usual_sizes import Sides
from mechproof.lab.subject import Subject
from mechproof.lab.ways import Arguments, Array, Compute, Way, list_columns
from mechproof.proof.signs import find_sign
from mechproof.record.relations import is_comparison
from mechproof.roundoff.climb import BY_BALLS, JUDGED, Schedule, climb, climb_and_judge, gather
from mechproof.statement_domains.domain import Domain

BY_LONG_DOUBLES = Schedule(3000, 6)
# Rounds by long doubles for each one by balls; and the number of rounds after which a population
# has gathered in one place, so that a new climb begins.
ROUNDS, CLIMB = 20, 100


def mark_accuracy_domain(subject: Subject, arguments: Arguments) -> Array:
    """Return a mask of points where all relations of the bound certainly hold.

    Computed relations, such as a difference near zero, are decided by balls: the rounding of
    doubles would decide them at the very points that the relation is meant to exclude. A relation
    between elements must hold for all of them.
    """
    accuracy = subject.quantity.accuracy
    relations = accuracy.within if accuracy else ()
    computed = [r for r in relations if not is_comparison(subject.domain.resolve(r))]
    held = np.ones(count_points(subject, arguments), bool)
    for relation in relations:
        if relation not in computed:
            held &= _compare(subject, relation, arguments)
    for index, values in enumerate(list_values(subject, arguments)) if computed else ():
        held[index] &= all(_is_true(subject, relation, values) for relation in computed)
    return held


def _is_true(subject: Subject, relation: sp.Basic, values: Mapping[sp.Basic, Any]) -> bool:
    for bits in PRECISIONS:
        known = give_balls(relation, subject.domain.given, values, bits)
        found = balls.truth(relation, known, bits)
        if found is not None:
            return found
    return False


def _compare(subject: Subject, relation: sp.Basic, arguments: Arguments) -> Array:
    """Decide a relation in doubles."""
    symbols = subject.quantity.symbols
    plain = {s: sp.Symbol(str(s)) for s in symbols if isinstance(s, sp.IndexedBase)}
    elements = {item: plain[item.base] for item in relation.atoms(sp.Indexed)}
    test = sp.lambdify([plain.get(s, s) for s in symbols], relation.xreplace(elements), "numpy")
    columns = list_columns(subject.quantity, arguments)
    if not plain:
        # SymPy's code for "or" joins its parts into one array.
        columns = list(np.broadcast_arrays(*columns))
    with np.errstate(all="ignore"):
        found: Array = np.asarray(test(*columns), bool)
    return np.asarray(found.all(axis=-1)) if elements else found


def bound_approximation(subject: Subject, way: Way, cell: Sides) -> float | None:
    """Return an upper limit of an approximation's error on a cell of sizes.

    None without a bound, or for a bound that does not provably rise with every size.
    """
    if way.bound is None:
        return None
    bound = subject.domain.resolve(way.bound)
    sizes = {s: sp.Symbol(f"size_{s}", positive=True) for s in sorted(bound.free_symbols, key=str)}
    if not sizes.keys() <= _corner(subject, cell).keys() or not _rises(bound, subject, sizes):
        return None
    ball = evaluate(bound, {s: _corner(subject, cell)[s] for s in sizes}, 128)
    return float(np.nextafter(float(ball.upper()), np.inf)) if ball.is_finite() else None


def _corner(subject: Subject, cell: Sides) -> dict[sp.Symbol, float]:
    """Return the largest size in the cell for every symbol of its arguments."""
    return {
        symbol: cell[argument.name][1]
        for argument in subject.quantity.arguments
        if argument.name in cell
        for symbol in argument.symbols
    }


def _rises(bound: sp.Expr, subject: Subject, sizes: dict[sp.Symbol, sp.Symbol]) -> bool:
    """Return whether the bound provably depends on sizes alone and falls with none of them."""
    sets = {s: subject.domain.set_of(s) for s in sizes}
    signed = [s for s in sizes if sets[s].inf < 0]
    if any(sp.simplify(bound - bound.subs(s, -s)) != 0 for s in signed):
        return False
    positive = sp.Interval.open(0, sp.oo)
    within = tuple((size, sp.Intersection(sets[s], positive)) for s, size in sizes.items())
    return _rises_in_sizes(bound.subs(sizes), within)


@lru_cache(maxsize=256)
def _rises_in_sizes(bound: sp.Expr, within: tuple[tuple[sp.Symbol, sp.Set], ...]) -> bool:
    """Return whether an expression in positive sizes is provably nonnegative and never falls."""
    if bound.is_Number or bound.is_Symbol:
        return bool(bound.is_nonnegative)
    if isinstance(bound, sp.Add | sp.Mul):
        return all(_rises_in_sizes(part, within) for part in bound.args)
    if isinstance(bound, sp.Pow) and bound.exp.is_positive and bound.exp.is_number:
        return _rises_in_sizes(bound.base, within)
    domain = Domain(dict(within), (), {})
    signs = [find_sign(bound, domain)]
    signs += [find_sign(sp.factor(sp.diff(bound, size)), domain) for size, _ in within]
    return all(sign is not None and sign.direction > 0 for sign in signs)


@dataclass(frozen=True)
class SearchedInput:
    """The worst input of a search, its error in units of the bound, and how many were tried."""

    arguments: tuple[Array, ...]
    scaled: float
    tried: int


def find_worst(
    subject: Subject,
    compute: Compute,
    rounds: int,
    seed: int = TUNE,
    share: float = 1.0,
    most: int | None = None,
) -> SearchedInput:
    """Climb for `rounds` rounds from a share of each set, by balls from at most `most` points.

    The climb stays in the domain. Without long doubles, or without code of the quantity, balls do
    all of it.
    """
    rng = np.random.default_rng(seed)
    sets = [*draw_sets(subject, seed, share)]
    judge = partial(scaled_errors, subject, compute)
    few = (tuple(c[choose_evenly(len(c), most)] for c in drawn) for drawn in sets)
    inside = partial(_mark_inside, subject)
    population = climb(judge, join(*few), BY_BALLS, rounds, rng, inside)
    extended = extend(subject)
    if extended is not None:

        def estimate(points: Arguments) -> Array:
            return compare(compute, points, extended.find_truth(points))

        start = join(population.points, *sets)
        for length in _divide(ROUNDS * rounds):
            found = climb_and_judge(judge, estimate, start, BY_LONG_DOUBLES, length, rng)
            population = gather(population, found, JUDGED)
    return SearchedInput(*population.worst, population.tried)


def _divide(rounds: int) -> Iterator[int]:
    """Divide rounds into climbs; for zero rounds there is one climb that only looks around."""
    return (min(CLIMB, rounds - done) for done in range(0, max(rounds, 1), CLIMB))


def scaled_errors(subject: Subject, compute: Compute, arguments: Arguments) -> Array:
    """Return the errors in units of the accuracy bound; -1 if undecided or outside its domain."""
    truth = find_truth(subject, arguments)
    return np.where(
        mark_accuracy_domain(subject, arguments), compare(compute, arguments, truth), -1.0
    )


def compare(compute: Compute, arguments: Arguments, truth: Truth) -> Array:
    """Return the errors against a truth, in units of the accuracy bound; -1 if undecided."""
    with np.errstate(all="ignore"):
        errors = find_errors(compute(*arguments), truth).scaled
    return np.where(truth.decided, np.nan_to_num(errors, nan=-1.0, posinf=np.inf), -1.0)


def draw_sets(subject: Subject, seed: int, share: float) -> Iterator[Arguments]:
    """Draw the points of every unordered set, all arguments with an axis of points."""
    for point_set in list_sets(subject, share):
        if not point_set.ordered:
            yield _with_leading_axis(draw_points(point_set, seed))


def _with_leading_axis(arguments: Arguments) -> Arguments:
    count = max(len(a) for a in arguments if np.ndim(a))
    return tuple(
        a if np.ndim(a) and len(a) == count else np.broadcast_to(a, (count, *np.shape(a))).copy()
        for a in arguments
    )


def _mark_inside(subject: Subject, points: Arguments) -> Array:
    """Return a mask of points in the domain; for sums, of those where the kernel is not NaN."""
    if subject.quantity.has_families:
        known: Array = ~np.isnan(subject.kernel(*points))
        return known
    return subject.facts.region.mark_inside(subject.facts.unpack(points))
