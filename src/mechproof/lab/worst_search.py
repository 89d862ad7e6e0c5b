"""The search: from the worst of all point sets uphill to worse inputs.

Balls tell which are worse, of hundreds of points; then long doubles of millions, and balls judge
what these have found. It belongs in the regression table. S3FP (Chiang et al. 2014) narrows
ranges of inputs at random instead of moving points.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial

import numpy as np

from mechproof.lab.accuracy_domain import mark_accuracy_domain
from mechproof.lab.extended_oracle import extend
from mechproof.lab.oracle import Truth, find_errors, find_truth
from mechproof.lab.sampling.named_sets import TUNE, choose_evenly, draw_points, join
from mechproof.lab.sampling.point_sets import list_sets
from mechproof.lab.subject import Subject
from mechproof.lab.ways import Arguments, Array, Compute
from mechproof.roundoff.climb import BY_BALLS, JUDGED, Schedule, climb, climb_and_judge, gather

BY_LONG_DOUBLES = Schedule(3000, 6)
# So many rounds by long doubles for one by balls; after so many a population has met, and begins
# again.
ROUNDS, CLIMB = 20, 100


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
    """Climb for some rounds from a share of each set, by balls from at most so many points of it.

    The domain is not left. Without long doubles, or code of the quantity, balls are all there is.
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
    """Divide rounds into climbs; none at all are one that looks around."""
    return (min(CLIMB, rounds - done) for done in range(0, max(rounds, 1), CLIMB))


def scaled_errors(subject: Subject, compute: Compute, arguments: Arguments) -> Array:
    """Return the errors in units of the accuracy bound; -1 where undecided or out of it."""
    truth = find_truth(subject, arguments)
    return np.where(
        mark_accuracy_domain(subject, arguments), compare(compute, arguments, truth), -1.0
    )


def compare(compute: Compute, arguments: Arguments, truth: Truth) -> Array:
    """Return the errors against a truth, in units of the accuracy bound; -1 where undecided."""
    with np.errstate(all="ignore"):
        errors = find_errors(compute(*arguments), truth).scaled
    return np.where(truth.decided, np.nan_to_num(errors, nan=-1.0, posinf=np.inf), -1.0)


def draw_sets(subject: Subject, seed: int, share: float) -> Iterator[Arguments]:
    """Draw the points of every set that has no order, all arguments with an axis of points."""
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
    """Mark the points of the domain; of sums a kernel alone knows it, which is NaN elsewhere."""
    if subject.quantity.has_families:
        known: Array = ~np.isnan(subject.kernel(*points))
        return known
    return subject.facts.region.mark_inside(subject.facts.unpack(points))
