"""The search: rewrites in the order of their table, each tried on the best that was found so far.

What a rewrite does not change is dropped, and so is what computes the same as another candidate. A
rewrite that gains nothing by itself, as the low word of an angle, is kept for those after it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from mechproof.chosen import rewrite_definition
from mechproof.improvement.candidates import Candidate, Loss, Points, measure_loss
from mechproof.lab.subject import Subject
from mechproof.programs.rewrites import REWRITES

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
