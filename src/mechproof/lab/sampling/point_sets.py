"""The point sets, cells and timed calls of a quantity, made from what its derivation states."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from itertools import pairwise, product

import numpy as np

from mechproof.lab.sampling.named_sets import PointSet
from mechproof.lab.sampling.singular_points import list_point_sets
from mechproof.lab.sampling.usual_sizes import Sides, draw_cell, make_workload
from mechproof.lab.subject import Subject
from mechproof.lab.ways import Arguments

Workload = tuple[str, Callable[[int], Arguments]]
# Half turns of the running variable in a sweep, and the numbers of its samples.
SWEEP, SAMPLES = 32, (3301, 201)


def list_sets(subject: Subject, share: float = 1.0) -> tuple[PointSet, ...]:
    """Return the point sets of a quantity: made from its facts, by hand, and sweeps.

    None is made from facts if an argument has axes that are summed over, or if there are sets by
    hand and no singular set is stated. `share` is the part of the usual number of points to be
    drawn.
    """
    by_hand = subject.by_hand.sets
    facts = replace(subject.facts, share=share)
    can_be_made = not subject.quantity.has_families
    wanted = subject.quantity.singular or not by_hand
    made = list_point_sets(facts) if can_be_made and wanted else ()
    return (*made, *by_hand, *list_sweeps(subject))


def list_cells(subject: Subject) -> list[Sides]:
    """Return the cells between the usual sizes of the arguments; none if no argument has any."""
    edges = {a.name: a.usual for a in subject.quantity.arguments if len(a.usual) > 1}
    if not edges:
        return []
    spans = [list(pairwise(e)) for e in edges.values()]
    return [dict(zip(edges, sides, strict=True)) for sides in product(*spans)]


def draw_in_cell(subject: Subject, rng: np.random.Generator, cell: Sides) -> Arguments:
    """Draw points of one cell."""
    by_hand = subject.by_hand.in_cell
    return by_hand(rng, cell) if by_hand else draw_cell(subject.facts, rng, cell)


def list_workloads(subject: Subject) -> list[Workload]:
    """Return the timed calls of a quantity: the named ones, or with the first argument varying."""
    if subject.by_hand.workloads:
        return list(subject.by_hand.workloads.items())
    first = subject.quantity.arguments[0].name
    named = subject.quantity.workloads or ((f"N values of {first}", (first,)),)
    return [
        (name, partial(make_workload, subject.facts, varying=varying)) for name, varying in named
    ]


def list_sweeps(subject: Subject) -> tuple[PointSet, ...]:
    """Return sweeps from 0, for ways that need ordered samples and for jumps between branches.

    The end of a sweep is a singular place many turns away, so that some samples lie on others.
    """
    if subject.period is None:
        return ()
    _, *parameters = make_workload(subject.facts, 1, (subject.quantity.arguments[0].name,))

    def sweep(count: int, rng: np.random.Generator) -> Arguments:
        del rng
        return np.linspace(0, SWEEP * np.pi, count), *parameters

    return tuple(
        PointSet(f"sweep, {count} samples", partial(sweep, count), ordered=True)
        for count in SAMPLES
    )
