"""Rows that the constraints of their paper show to be misprints, and what contradicts them.

A constraint from which other rows follow may also accuse a definition that makes it false.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from mechproof.document.checked_rows import CheckedRow, list_standing, make_row
from mechproof.document.constraints.consequences import (
    FOLLOWING,
    GIVEN,
    holds_elsewhere,
    is_plain,
    is_turned,
    list_letters,
    may_hold_for,
)
from mechproof.document.context.constrained_rows import (
    connect,
    is_constraint,
    is_proof,
    list_following,
)
from mechproof.document.context.doubted_letters import leaves_free
from mechproof.document.context.doubts import (
    defines,
    describe_contradiction,
    list_printed,
    list_used,
)
from mechproof.document.context.judging_by_constraints import (
    describe_misprint,
    judge_by_constraints,
    judge_misprint,
)
from mechproof.document.judging_workers import Changes, Judging
from mechproof.document.slips import WITHIN
from mechproof.document.tasks import Role, Task
from mechproof.proof.verdict import Judgement, State, Verdict
from mechproof.record import Equality
from mechproof.tools.processes import WorkerError


def find_misprints(at: Judging) -> Changes:
    """Judge rows that may be constraints or misprints.

    A row may be false only given another print that may itself be wrong or be meant for another
    case. Then the two contradict each other and neither is refuted, unless the other print comes
    first and the rows that follow from it alone accuse this row, too. If the other print comes
    first and further rows follow from it, but not without it, it is not meant for another case.
    """
    tasks, rows = at.tasks, at.rows
    given = [n for n, task in enumerate(tasks) if is_constraint(task, rows[n])]
    proved = {row.name for row in rows.values() if row.outcome == Verdict.PROVED.value}
    asked = {
        n: tuple(connect(n, [g for g in given if may_hold_for(tasks[g], task)], tasks))
        for n, task in enumerate(tasks)
        if may_be_misprint(task, rows[n])
        # The ties between the roots of a constraint are as right as the constraint.
        and not (task.sign.is_tied and task.sign.first in proved)
        # If the first prints of a letter differ, nobody knows which one is meant.
        and not (task.others and len(list_standing(task, tasks, rows)) > 1)
    }
    accused = {n: found for (n, _), found in _accuse(at, [*asked.items()]).items()}
    beside = [(n, other) for n in accused for other in asked[n]]
    certain = {
        (n, other)
        for n, other in beside
        if (other in accused and n in asked[other]) or _may_be_special(tasks, n, other)
    }
    rivals = [pair for pair in beside if pair in certain or tasks[pair[1]].is_excused]
    without = []
    for n, other in rivals:
        kept = [o for o in asked[n] if o != other]
        if other < n and other in accused and not _may_be_special(tasks, n, other):
            kept += [m for m in list_following(other, at) if m not in (n, *kept)]
        without.append((n, tuple(kept)))
    still = _accuse(at, without)
    pairs = [pair for pair, one in zip(rivals, without, strict=True) if one not in still]
    # A row is not accused if its only accuser is itself wrong without it.
    kept_pairs = {*rivals} - {*pairs}
    cleared = {n for n, other in pairs if (other, n) in kept_pairs}
    accused = {n: one for n, one in accused.items() if n not in cleared}
    pairs = [pair for pair in pairs if pair[0] in accused]
    excused = {(n, other) for n, other in pairs if other < n} - certain
    needed = _find_needed(at, {other for _, other in excused})
    pairs = [pair for pair in pairs if not (pair in excused and pair[1] in needed)]
    open_pairs, wrong = _ask_definitions(at, accused)
    pairs += [*open_pairs, *_list_later(at, accused)]
    refuted = accused.keys() - {n for n, _ in pairs} - {*wrong.values()}
    for n in {*accused, *(one for pair in pairs for one in pair)}:
        others = {one for pair in pairs if n in pair for one in pair} - {n}
        names = ", ".join(tasks[other].row.number for other in sorted(others))
        said = f": {accused[n].reason}" if n in accused else ""
        contradicts = f"{describe_contradiction(names)}{said}"
        if n in refuted or n not in wrong.values():
            yield n, make_row(tasks[n], accused[n] if n in refuted else contradicts)
    for m, n in wrong.items():
        yield m, make_row(tasks[m], _charge(rows[m], accused[n], tasks[n].row.number))


def _ask_definitions(
    at: Judging, accused: Mapping[int, Judgement]
) -> tuple[list[tuple[int, int]], dict[int, int]]:
    """Return pairs of a misprint and a contradicting definition, and the definitions to blame.

    Such a definition is printed later, or words that reverse a sense lie between. It is to blame,
    mapped to the row it contradicts, if further rows follow from that row and the misprint is in a
    definition.
    """
    tasks = at.tasks
    later = [(n, m) for n in accused for m in range(n + 1, len(tasks))]
    # A later definition of a letter by all the others is the same equation solved for it.
    printed = [list_printed(task) for task in tasks]
    later = [(n, m) for n, m in later if printed[m] == printed[n] and defines(tasks[m], printed[n])]
    needed = _find_needed(at, {n for n, _ in later})
    wrong = {
        m: n
        for n, m in later
        if n in needed and WITHIN in accused[n].reason and not tasks[m].is_case
    }
    turned = [
        (n, m)
        for n in accused
        for m, one in enumerate(tasks)
        if is_turned(one, tasks[n]) and defines(one, list_used(tasks[n], tasks))
    ]
    return [(n, m) for n, m in later if m not in wrong] + turned, wrong


def _accuse(
    at: Judging, asked: Sequence[tuple[int, tuple[int, ...]]]
) -> dict[tuple[Any, ...], Judgement]:
    """Return the misprints, keyed by row and constraints that show them, with their judgements."""
    answers = at.ask(judge_misprint, asked)
    return {one: found for one, found in answers if isinstance(found, Judgement)}


def _may_be_special(tasks: Sequence[Task], number: int, other: int) -> bool:
    """Return whether a constraint may describe a special position that does not concern a row.

    It may if it is announced as another case, if words between the two reverse a sense, if it is a
    print of both roots, or if it is an equation such as a = b + pi that comes later or is announced
    as equating letters.
    """
    may_equate = other > number or tasks[other].said.is_equating
    is_other = tasks[other].is_case or is_turned(tasks[other], tasks[number])
    is_equal = may_equate and is_plain(tasks[other])
    return is_equal or is_other or tasks[other].sign.role is Role.SOLUTIONS


def _find_needed(at: Judging, others: Collection[int]) -> set[int]:
    """Return the constraints without which some row that is shown to follow no longer does."""
    given = [n for n, task in enumerate(at.tasks) if is_constraint(task, at.rows[n])]
    judged = ((n, row.judgement) for n, row in at.rows.items())
    following = [n for n, found in judged if found and found.rung in FOLLOWING]
    pairs = [(other, n) for other in others for n in following if other < n]
    asked = [(n, tuple(g for g in given if g < n and g != other)) for other, n in pairs]
    found = dict(at.ask(judge_by_constraints, asked))
    # A row that took too long may follow without it.
    without = {one for one, x in found.items() if isinstance(x, WorkerError) or is_proof(x)}
    return {other for (other, _), one in zip(pairs, asked, strict=True) if one not in without}


def _charge(row: CheckedRow, found: Judgement, name: str) -> Judgement | str:
    """Judge a definition wrong that contradicts an equation from which further rows follow."""
    reason = f"it contradicts {name}, from which further rows follow: {found.reason}"
    if row.judgement is None:
        return reason
    verdict, rung, evidence = Verdict.REFUTED, found.rung, found.evidence
    return replace(row.judgement, verdict=verdict, rung=rung, reason=reason, evidence=evidence)


def _list_later(at: Judging, accused: Collection[int]) -> Iterator[tuple[int, int]]:
    """Yield accused rows, each with a later row that defines one of its letters.

    A clause after a display that only explains its letters is no print of its own, and a proved row
    is as right as what is printed before it.
    """
    tasks = at.tasks
    for n in accused:
        used = list_used(tasks[n], tasks)
        after = (m for m in range(n + 1, len(tasks)) if not tasks[m].said.is_clause)
        open_ones = (m for m in after if at.rows[m].outcome != Verdict.PROVED.value)
        used_later = [m for m in open_ones if defines(tasks[m], used)]
        used_later = [m for m in used_later if not holds_elsewhere(tasks[m], tasks[n])]
        yield from ((n, m) for m in used_later if not leaves_free(tasks[m], tasks[n], tasks))


def may_be_misprint(task: Task, row: CheckedRow) -> bool:
    """Return whether a row is an equation that is neither proved nor refuted, and not rounded."""
    is_open = row.state is State.NOT_JUDGED or bool(row.judgement and row.judgement.rung == GIVEN)
    is_equation = isinstance(task.row.says, Equality) and task.sign.number in ("", "0")
    is_one_of_two = task.is_solution or (task.is_excused and not task.asserts)
    is_one_of_two |= task.sign.role is Role.SOLUTIONS
    return is_open and is_equation and not (task.is_rounded or is_one_of_two)


def _list_moving(task: Task) -> set[sp.Basic]:
    """Return the letters of a constraint and of its derivatives."""
    return list_letters(task).union(*(rate.free_symbols for rate in task.rates))


def doubt_by_proved(at: Judging) -> Changes:
    """Leave open a row that one slip makes false, given constraints from which others follow.

    Several such rows hide one another, so rows from which nothing follows are not used as
    constraints. A row from which others follow counts as a slip only given earlier constraints that
    have all its letters.
    """
    tasks, rows = at.tasks, at.rows
    proved = tuple(n for n, row in rows.items() if row.outcome == Verdict.PROVED.value)
    given = [n for n, task in enumerate(tasks) if is_constraint(task, rows[n])]
    given = [n for n in given if any(m in proved for m in list_following(n, at))]
    asked = []
    for n, task in enumerate(tasks):
        found = rows[n].judgement
        is_open = found is not None and found.rung == GIVEN and may_be_misprint(task, rows[n])
        beside = [g for g in given if g < n and may_hold_for(tasks[g], task)]
        beside = [*connect(n, beside, tasks)]
        met = set[sp.Basic]().union(*(_list_moving(tasks[g]) for g in beside))
        is_bound = n not in given or list_letters(task) <= met
        if is_open and beside and is_bound and not task.is_case:
            asked.append((n, tuple(beside), tuple(m for m in proved if m < n)))
    for (n, *_), said in at.ask(describe_misprint, asked):
        if isinstance(said, str) and said:
            yield n, make_row(tasks[n], said)
