"""Constraints that are false wherever those hold from which further rows are proved to follow."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from mechproof.document.checked_rows import CheckedRow, make_row
from mechproof.document.constraints.applicable_constraints import may_hold_for
from mechproof.document.constraints.consequences import GIVEN
from mechproof.document.context.accused_rows import may_be_misprint
from mechproof.document.context.constrained_rows import connect, is_constraint, list_following
from mechproof.document.context.judging_beside import tell_misprint
from mechproof.document.judging import Key
from mechproof.document.tasks import Task
from mechproof.proof.verdict import Verdict
from mechproof.tools.processes import run_tasks


def doubt_by_proved(
    key: Key, tasks: Sequence[Task], rows: Mapping[int, CheckedRow], limit: float
) -> Iterator[tuple[int, CheckedRow]]:
    """Take no row as given that is one with a slip, false beside what others follow from.

    Several such rows hide one another, so those are left out from which nothing follows.
    """
    proved = tuple(n for n, row in rows.items() if row.outcome == Verdict.PROVED.value)
    given = [n for n, task in enumerate(tasks) if is_constraint(task, rows[n])]
    given = [n for n in given if any(m in proved for m in list_following(n, tasks, rows))]
    asked = []
    for n, task in enumerate(tasks):
        found = rows[n].judgement
        is_open = found is not None and found.rung == GIVEN and may_be_misprint(task, rows[n])
        beside = [g for g in given if g < n and may_hold_for(tasks[g], task)]
        beside = [*connect(n, beside, tasks)]
        if is_open and beside and n not in given and not task.is_case:
            asked.append((key, n, tuple(beside), tuple(m for m in proved if m < n)))
    for place, said in run_tasks(tell_misprint, asked, limit=limit):
        if isinstance(said, str) and said:
            number = asked[place][1]
            yield number, make_row(tasks[number], said)
