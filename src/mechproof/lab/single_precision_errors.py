"""Single precision: a quantity's kernel as C computes it in floats, and the worst that is found."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import sympy as sp

from mechproof.codegen.docstrings import tell_bound
from mechproof.lab.error import EPS
from mechproof.lab.extended_oracle import extend
from mechproof.lab.sampling.named_sets import TUNE, choose_evenly, join
from mechproof.lab.sampling.stated_sizes import MARGIN
from mechproof.lab.subject import Subject, make_subjects
from mechproof.lab.ways import Arguments, Array
from mechproof.lab.worst_search import SearchedInput, compare, draw_sets, scaled_errors
from mechproof.measured import round_up
from mechproof.programs.elementary.formats import DOUBLE, SINGLE
from mechproof.programs.kernel import Kernel
from mechproof.programs.scalar import list_scalars
from mechproof.record import Paper
from mechproof.roundoff.climb import (
    BY_BALLS,
    JUDGED,
    Measure,
    Schedule,
    climb,
    climb_and_judge,
    gather,
)
from mechproof.roundoff.running import IN_EXTENDED
from mechproof.roundoff.singles import FORMAT, Singles

# Of each set this share, of it so many by balls; rounds uphill, led by long doubles.
SHARE, MOST, ROUNDS = 0.05, 20, 12
SCHEDULE = Schedule(300, 6)
WIDER = float(np.finfo(FORMAT).eps) / EPS
# Multiples of eps that a distance from an edge is stated in.
FEW = range(1, 1000)
# How far angles are reduced without the library.
FAR, NEAR = sp.Integer(DOUBLE.largest), sp.Integer(SINGLE.largest)


def find_worst_singles(subject: Subject, kernel: Kernel) -> SearchedInput:
    """Search for the worst error in floats, in their eps of the scale of the bound.

    Points are floats. Left out are those at which a value on the way leaves the range of floats,
    and those so near a computed limit of the domain that floats cannot tell the side.
    """
    subject = narrow(subject)
    singles, extended = Singles(kernel), extend(subject)

    def judge(points: Arguments) -> Array:
        return _judge(partial(scaled_errors, subject, singles), points)

    def estimate(points: Arguments) -> Array:
        assert extended is not None
        return _judge(lambda kept: compare(singles, kept, extended.find_truth(kept)), points)

    def _judge(measure: Measure, points: Arguments) -> Array:
        rounded = round_singly(points)
        kept = mark_judged(subject, singles, rounded)
        heights = np.full(len(points[0]), -1.0)
        if kept.any():
            heights[kept] = measure(tuple(c[kept] for c in rounded))
        return np.where(heights > 0, heights / WIDER, heights)

    sets = [*draw_sets(subject, TUNE, SHARE)]
    few = join(*(tuple(c[choose_evenly(len(c), MOST)] for c in drawn) for drawn in sets))
    rng = np.random.default_rng(TUNE)
    population = climb(judge, few, BY_BALLS, 0, rng)
    if extended is not None:
        found = climb_and_judge(judge, estimate, join(*sets), SCHEDULE, ROUNDS, rng)
        population = gather(population, found, JUDGED)
    point, scaled = population.worst
    return SearchedInput(round_singly(point), scaled, population.tried)


def state_errors(paper: Paper, place: Path) -> Mapping[str, str]:
    """Say of every kernel that C has in float how far off it was found."""
    subjects = {s.quantity.name: s for s in make_subjects(paper, place, None)}
    kernels = {kernel.name: kernel for kernel in list_scalars(paper)}
    return {name: _state_error(subjects[name], kernel) for name, kernel in kernels.items()}


def _state_error(subject: Subject, kernel: Kernel) -> str:
    found = find_worst_singles(subject, kernel)
    if found.scaled < 0:
        return f"none of {found.tried} points could be judged"
    quantity, worst = narrow(subject).quantity, round_up(found.scaled)
    if quantity.accuracy is None:
        return f"{worst:g} units in the last place at the worst of {found.tried} points"
    told = tell_bound(replace(quantity, accuracy=replace(quantity.accuracy, ulp=worst)))
    return f"{told}; the worst of {found.tried} points"


def narrow(subject: Subject) -> Subject:
    """Return a quantity whose bound is stated as far as floats reduce angles and tell edges."""
    accuracy = subject.quantity.accuracy
    if accuracy is None:
        return subject
    within = tuple(
        relation.xreplace({FAR: NEAR}).replace(_is_a_few_eps, lambda few: few * int(WIDER))
        for relation in accuracy.within
    )
    quantity = replace(subject.quantity, accuracy=replace(accuracy, within=within))
    return replace(subject, quantity=quantity)


def _is_a_few_eps(number: sp.Basic) -> bool:
    """Say whether a number is a small multiple of the eps of doubles, as distances from edges."""
    return isinstance(number, sp.Rational) and (number / sp.Rational(EPS)) in FEW


def round_singly(points: Arguments) -> Arguments:
    """Round every number to the float next to it."""
    with np.errstate(over="ignore"):
        return tuple(np.asarray(c, FORMAT).astype(float) for c in points)


def mark_judged(subject: Subject, singles: Singles, points: Arguments) -> Array:
    """Mark the points that are inside, and on whose way no value leaves the range of floats.

    Of sums floats themselves decide what is inside at the limits.
    """
    judged = singles.mark_inside(points, IN_EXTENDED, np.longdouble) & ~singles.run(points)[1]
    if subject.quantity.has_families:
        return judged & singles.mark_inside(points)
    columns = subject.facts.unpack(points)
    near: Array = subject.facts.region.mark_near(columns, MARGIN * WIDER)
    return judged & near
