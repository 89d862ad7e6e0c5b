"""Improvement: from a quantity to a proved form that loses fewer digits than the shipped one.

The named rewrites are tried one after another in the order of their table, each on the best
candidates found so far. Candidates that a rewrite does not change, or that compute the same as
another candidate, are dropped. A rewrite that gains nothing on its own, such as the low word of an
angle, is kept for those after it. The search is tuned on other points than those reported on.

Herbie (Panchekha et al. 2015) searches for rules for single expressions in a graph of equal ones;
here a rule is a named rewrite of a whole form, so that each find is a form as a person would write
it, which is emitted, read back and proved like any other.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from mechproof.codegen.form_rows import form_rows, number_shipped
from mechproof.derivation import rewrite_definition
from mechproof.lab.oracle import ALL_BITS, Errors, Truth, find_errors, find_truth
from mechproof.lab.sampling.named_sets import REPORT, TUNE, choose_evenly, join
from mechproof.lab.subject import Subject, find_subjects
from mechproof.lab.ways import Arguments, Array, Compute
from mechproof.lab.worst_search import draw_sets, mark_accuracy_domain
from mechproof.programs.kernel import Kernel, build_kernel
from mechproof.programs.rewrites import REWRITES
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Verdict
from mechproof.record import Form, Quantity
from mechproof.roundoff.kernel_runs import name_values, put_points_last, run_stage
from mechproof.roundoff.running import IN_DOUBLES
from mechproof.tools.processes import WorkerError, run_tasks

# Share of each set of points that is drawn, and the most points of it that are compared.
SHARE, MOST = 0.1, 24
# A double has no more digits to lose.
ALL_DIGITS = 16
# Number of the best candidates for which a proof is tried.
TRIED = 4
# Level of a form that loses less than a digit at worst, and less than a bit on average.
NOTHING = (0, 0)


@dataclass(frozen=True)
class Points:
    """Points at which a quantity is hard to compute, and its values there."""

    arguments: Arguments
    truth: Truth
    counts: Array


@dataclass(frozen=True)
class Loss:
    """The loss of a way of computing on points: the worst error, its point, and mean bits lost."""

    worst: float
    bits: float
    at: tuple[Any, ...]

    @property
    def digits(self) -> float:
        """Return the decimal digits that are lost at the worst point."""
        return float(np.clip(np.log10(max(self.worst, 1.0)), 0, ALL_DIGITS))

    @property
    def level(self) -> tuple[int, int]:
        """Return the values to be compared: whole digits, then whole bits; the rest is chance."""
        return round(self.digits), int(self.bits)


def draw(subject: Subject, seed: int) -> Points:
    """Draw points of every set; those where no accuracy is stated do not count."""
    sets = (
        tuple(column[choose_evenly(len(column), MOST)] for column in drawn)
        for drawn in draw_sets(subject, seed, SHARE)
    )
    arguments = join(*sets)
    truth = find_truth(subject, arguments)
    return Points(arguments, truth, mark_accuracy_domain(subject, arguments) & truth.decided)


def measure_loss(compute: Compute, points: Points) -> Loss:
    """Compare the results of a way of computing with the truth."""
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
        """Return the code; raises ValueError or NotImplementedError if a rewrite does not fit."""
        return build_kernel(self.quantity.name, self.quantity, (self.form,), self.subject.paper)

    @property
    def operations(self) -> int:
        """Return the number of operations."""
        return self.kernel.code.count_operations()[-1]

    def compute(self, *arguments: Array) -> Array:
        """Compute the form in doubles, as its kernel does."""
        (stage,), shape = self.kernel.code.stages, self.kernel.code.shape
        with np.errstate(all="ignore"):
            given = name_values(self.kernel.code, put_points_last(arguments, np.float64))
            found = run_stage(stage, given, IN_DOUBLES)
        values = np.stack([np.broadcast_to(v, len(arguments[0])) for v in found], -1)
        return values.reshape(len(values), *shape)


def can_be_searched(quantity: Quantity) -> bool:
    """Return whether a quantity is computed point by point; sums over axes are not rewritten."""
    return bool(quantity.forms) and not quantity.has_families


# Number of candidates that are kept after each rewrite.
KEPT = 8
# Rewrites that save no digits: they are for speed, or for float32.
FOR_SPEED = ("clenshaw", "in_single")
# Errors of a rewrite that does not fit: something it needs is missing, or has no operation.
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
    """Yield each candidate after the rewrite, with its loss, if the rewrite changes it."""
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


@dataclass(frozen=True)
class Offer:
    """The loss of the shipped form, and a better form, if one was found, with its proving rungs.

    `why` is the reason why none is offered.
    """

    quantity: str
    shipped: Loss
    operations: int
    arguments: tuple[str, ...]
    rewrites: tuple[str, ...] = ()
    found: Loss | None = None
    found_operations: int = 0
    rungs: tuple[str, ...] = ()
    why: str = ""

    def describe(self) -> str:
        """Return the offer as a sentence."""
        named = zip(self.arguments, self.shipped.at, strict=True)
        at = ", ".join(f"{name} = {_show(value)}" for name, value in named)
        lost = f"loses {_describe(self.shipped)}"
        if self.shipped.digits >= 1:
            lost += f" (worst at {at})"
        if self.found is None:
            return f"{self.quantity}: the shipped form {lost}; {self.why}"
        return (
            f"{self.quantity}: the shipped form {lost}; with {', '.join(self.rewrites)}, proved "
            f"equal ({', '.join(self.rungs)}), it loses {_describe(self.found)}: "
            f"{self.found_operations} operations instead of {self.operations}"
        )


def _describe(loss: Loss) -> str:
    """Return how many digits are lost; below 0.5, just the rounding of a few operations, "none"."""
    if loss.digits < 0.5:
        return "none"
    if loss.digits >= ALL_DIGITS:
        return "all digits"
    return f"{loss.digits:.1f} digits"


def _show(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def find_offer(subject: Subject) -> Offer:
    """Search for a form of one quantity, and prove it."""
    quantity = subject.quantity
    tuning, report = draw(subject, TUNE), draw(subject, REPORT)
    stated = Candidate(subject, quantity.shipped[-1])
    shipped = measure_loss(stated.compute, tuning)
    names = tuple(argument.name for argument in quantity.arguments)
    offer = Offer(subject.name, measure_loss(stated.compute, report), stated.operations, names)
    if shipped.level == offer.shipped.level == NOTHING:
        return replace(offer, why="there is nothing to gain")
    better = [c for loss, c in search(subject, tuning) if loss.level < shipped.level]
    if not better:
        return replace(offer, why="no rewrite is better")
    for candidate in better[:TRIED]:
        rungs = prove(candidate)
        found = measure_loss(candidate.compute, report)
        if rungs and found.level < offer.shipped.level:
            return replace(
                offer,
                rewrites=candidate.form.rewrites,
                found=found,
                found_operations=candidate.operations,
                rungs=rungs,
            )
    return replace(offer, why="no better form is proved")


def prove(candidate: Candidate) -> tuple[str, ...]:
    """Return the rungs that prove all claims of a form's emitted source, or none if one fails."""
    paper = replace(candidate.subject.paper, quantities=(candidate.quantity,), one_pass=())
    try:
        rows = form_rows(paper)
    except UNFIT:
        return ()
    needed = number_shipped(paper)
    judged = [judge(row, paper) for row in rows if row.number in needed]
    if any(answer.verdict is not Verdict.PROVED for answer in judged):
        return ()
    return tuple(dict.fromkeys(part for answer in judged for part in answer.rung.split(", ")))


def find_offers(
    names: Sequence[str],
    directory: Path | None,
    *,
    limit: float,
    report: Callable[[str], None] = lambda text: None,
) -> Iterator[tuple[Subject, Offer | WorkerError | str]]:
    """Yield the offer for each quantity, from processes, or a text why it is not searched.

    Names are those that `find_subjects` accepts, which raises ValueError for an unknown one. A
    search that takes longer than `limit` seconds gives a `WorkerError`.
    """
    subjects = find_subjects(tuple(names), directory)
    found: dict[str, Offer | WorkerError | str] = {
        s.name: why for s in subjects if (why := _refuse(s))
    }
    tasks = [(s.name, directory) for s in subjects if s.name not in found]
    for number, result in run_tasks(_find, tasks, limit=limit):
        found[tasks[number][0]] = result
        report(f"{len(found)} of {len(subjects)} quantities")
    yield from ((subject, found[subject.name]) for subject in subjects)


def _refuse(subject: Subject) -> str:
    """Return why a quantity is not searched, or "" if it is."""
    if not can_be_searched(subject.quantity):
        return "not searched: sums over axes and hand-written code are not rewritten"
    if len(subject.quantity.shipped) > 1:
        return "not searched: its forms are chosen by a condition"
    return ""


def _find(task: tuple[str, Path | None]) -> Offer:
    name, directory = task
    (subject,) = find_subjects((name,), directory)
    return find_offer(subject)
