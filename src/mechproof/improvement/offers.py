"""Offers: in, a quantity; out, a proved form that loses fewer digits than the shipped one.

The search is tuned on other points than those on which it is reported.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from mechproof.codegen.form_rows import form_rows, number_shipped
from mechproof.improvement.candidates import (
    ALL_DIGITS,
    UNFIT,
    Candidate,
    Loss,
    can_be_searched,
    draw,
    measure_loss,
    search,
)
from mechproof.lab.sampling.named_sets import REPORT, TUNE
from mechproof.lab.subject import Subject, find_subjects
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Verdict
from mechproof.tools.processes import WorkerError, run_tasks

# So many of the best candidates are tried to be proved.
TRIED = 4
# The level of a form that loses less than a digit, and less than a bit on average.
NOTHING = (0, 0)


@dataclass(frozen=True)
class Offer:
    """What the shipped form loses, and a form that was found, if any, with the rungs that prove it.

    `why` says why none is offered.
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
        """Return a line for people."""
        named = zip(self.arguments, self.shipped.at, strict=True)
        at = ", ".join(f"{name} = {_show(value)}" for name, value in named)
        lost = f"loses {_tell(self.shipped)}"
        if self.shipped.digits >= 1:
            lost += f" (worst at {at})"
        if self.found is None:
            return f"{self.quantity}: the shipped form {lost}; {self.why}"
        return (
            f"{self.quantity}: the shipped form {lost}; with {', '.join(self.rewrites)}, proved "
            f"equal ({', '.join(self.rungs)}), it loses {_tell(self.found)}: "
            f"{self.found_operations} operations instead of {self.operations}"
        )


def _tell(loss: Loss) -> str:
    """Say how many digits are lost; less than one half is the rounding of a few operations."""
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
    """Return the rungs that prove all that the emitted source of a form claims, none otherwise."""
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
    """Yield the offer for each quantity, in processes; a text says why one is not searched.

    Names are those that `find_subjects` takes, which raises ValueError for one that is unknown.
    What takes longer than `limit` seconds is a `WorkerError`.
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
    """Say why a quantity is not searched, empty if it is."""
    if not can_be_searched(subject.quantity):
        return "not searched: sums over axes and code by hand are not rewritten"
    if len(subject.quantity.shipped) > 1:
        return "not searched: its forms are chosen by a condition"
    return ""


def _find(task: tuple[str, Path | None]) -> Offer:
    name, directory = task
    (subject,) = find_subjects((name,), directory)
    return find_offer(subject)
