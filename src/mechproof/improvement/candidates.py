"""Candidates: a definition with named rewrites, computed in doubles and compared with the truth.

They are searched for: rewrites in the order of their table, each tried on the best that was found
so far. What a rewrite does not change is dropped, and so is what computes the same as another
candidate. A rewrite that gains nothing by itself, as the low word of an angle, is kept for those
after it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from mechproof.chosen import rewrite_definition
from mechproof.lab.accuracy_domain import mark_accuracy_domain
from mechproof.lab.error import ALL_BITS, Errors, find_errors
from mechproof.lab.extended_oracle import name_values
from mechproof.lab.oracle import Truth, find_truth
from mechproof.lab.sampling.named_sets import choose_evenly, join
from mechproof.lab.subject import Subject
from mechproof.lab.ways import Arguments, Array, Compute
from mechproof.lab.worst_search import draw_sets
from mechproof.programs.kernel import Kernel, build_kernel
from mechproof.programs.rewrites import REWRITES
from mechproof.record import Form, Quantity
from mechproof.roundoff.running import IN_DOUBLES, run
from mechproof.roundoff.steps import flatten_stage

# Of each set of points such a part is drawn, and no more than so many are compared.
SHARE, MOST = 0.1, 24
# A double has no more digits to lose.
ALL_DIGITS = 16


@dataclass(frozen=True)
class Points:
    """Points on which a quantity hurts, and its values there."""

    arguments: Arguments
    truth: Truth
    counts: Array


@dataclass(frozen=True)
class Loss:
    """What a way of computing loses on points: the worst of them, and the bits lost on average."""

    worst: float
    bits: float
    at: tuple[Any, ...]

    @property
    def digits(self) -> float:
        """Return the decimal digits that are lost at the worst point."""
        return float(np.clip(np.log10(max(self.worst, 1.0)), 0, ALL_DIGITS))

    @property
    def level(self) -> tuple[int, int]:
        """Return what is compared: whole digits, then whole bits; the rest is chance."""
        return round(self.digits), int(self.bits)


def draw(subject: Subject, seed: int) -> Points:
    """Draw some points of every set, as far as the accuracy of the quantity is stated there."""
    sets = (
        tuple(column[choose_evenly(len(column), MOST)] for column in drawn)
        for drawn in draw_sets(subject, seed, SHARE)
    )
    arguments = join(*sets)
    truth = find_truth(subject, arguments)
    return Points(arguments, truth, mark_accuracy_domain(subject, arguments) & truth.decided)


def measure_loss(compute: Compute, points: Points) -> Loss:
    """Compare what is computed with the truth."""
    with np.errstate(all="ignore"):
        errors: Errors = find_errors(compute(*points.arguments), points.truth)
    scaled = np.where(points.counts, errors.scaled, 0.0)
    bits = np.minimum(np.log2(1 + scaled), ALL_BITS)[points.counts]
    worst = int(np.argmax(scaled))
    at = tuple(argument[worst].tolist() for argument in points.arguments)
    return Loss(float(scaled[worst]), float(bits.mean()) if bits.size else 0.0, at)


@dataclass(frozen=True)
class Candidate:
    """A form of a quantity."""

    subject: Subject
    form: Form

    @cached_property
    def quantity(self) -> Quantity:
        """Return the quantity with this form alone."""
        return replace(self.subject.quantity, forms=(self.form,))

    @cached_property
    def kernel(self) -> Kernel:
        """Return the code; ValueError or NotImplementedError where a rewrite does not fit."""
        return build_kernel(self.quantity.name, self.quantity, (self.form,), self.subject.paper)

    @property
    def operations(self) -> int:
        """Count the operations."""
        return self.kernel.code.count_operations()[-1]

    def compute(self, *arguments: Array) -> Array:
        """Compute the form in doubles, as its kernel does."""
        (stage,), shape = self.kernel.code.stages, self.kernel.code.shape
        with np.errstate(all="ignore"):
            straight = flatten_stage(stage.spell_out(), {})
            given = name_values(self.quantity, self.kernel.code, arguments, np.float64)
            found = run(straight, given, IN_DOUBLES)
        values = np.stack([np.broadcast_to(v, len(arguments[0])) for v in found], -1)
        return values.reshape(len(values), *shape)


def can_be_searched(quantity: Quantity) -> bool:
    """Say whether a quantity is computed point by point; sums over axes are not rewritten."""
    return bool(quantity.forms) and not quantity.has_families


# So many candidates are kept after each rewrite.
KEPT = 8
# Rewrites that save no digits: they are for speed, or for float32.
FOR_SPEED = ("clenshaw", "in_single")
# Why a rewrite does not fit: what it needs is not there, or has no operation.
UNFIT = (ValueError, NotImplementedError)

Found = tuple[Loss, Candidate]


def search(subject: Subject, points: Points) -> list[Found]:
    """Return the best candidates, the one that loses least on the points first."""
    plain = Candidate(subject, rewrite_definition(subject.quantity, ()))
    found = [(measure_loss(plain.compute, points), plain)]
    for name in REWRITES:
        if name not in FOR_SPEED:
            found = sorted([*found, *_grow(found, name, points)], key=_rank)[:KEPT]
    return found


def _rank(found: Found) -> tuple[tuple[int, int], int, int]:
    loss, candidate = found
    return loss.level, candidate.operations, len(candidate.form.rewrites)


def _grow(found: list[Found], name: str, points: Points) -> Iterator[Found]:
    """Yield what the rewrite makes of each candidate, if it changes it."""
    known = {candidate.kernel.code.stages for _, candidate in found}
    for _, candidate in found:
        rewrites = (*candidate.form.rewrites, name)
        grown = replace(candidate, form=rewrite_definition(candidate.quantity, rewrites))
        try:
            stages = grown.kernel.code.stages
        except UNFIT:
            continue
        if stages not in known:
            known.add(stages)
            yield measure_loss(grown.compute, points), grown
