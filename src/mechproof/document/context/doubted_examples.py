"""Rows that hold at what a worked example says of letters, and may not belong to it.

They are neither proved nor refuted: where an example ends words do not always tell.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from mechproof.document.checked_rows import CheckedRow, make_row
from mechproof.document.judging_workers import COMPARED, Key, judge_local
from mechproof.document.tasks import Task
from mechproof.proof.verdict import Judgement, State, Verdict
from mechproof.tools.processes import run_tasks

_OPEN = (Verdict.UNDECIDED, Verdict.ENCLOSED)


def doubt_by_examples(
    key: Key, tasks: Sequence[Task], rows: Mapping[int, CheckedRow], limit: float
) -> Iterator[tuple[int, CheckedRow]]:
    """Leave open what holds in an example only; in one also what is not decided there."""
    asked = [(key, n) for n, task in enumerate(tasks) if _may_be_local(task, rows[n])]
    for place, answer in run_tasks(judge_local, asked, limit=limit):
        number = asked[place][1]
        task = tasks[number]
        found = answer.verdict if isinstance(answer, Judgement) else None
        is_within = bool(task.said.example.number) and found in _OPEN
        if task.local and (found is Verdict.PROVED or is_within):
            said = ", ".join(f"{s} = {value}" for s, value in task.local.at.items())
            verb = "holds" if found is Verdict.PROVED else "may hold"
            reason = f"it {verb} for {said}, which is printed in a worked example: is that meant?"
            yield number, make_row(task, reason)


def _may_be_local(task: Task, row: CheckedRow) -> bool:
    """Return whether a row that is not shown says something else in an example."""
    is_open = row.state is State.NOT_JUDGED and task.sign.role in COMPARED
    is_open |= row.outcome == Verdict.REFUTED.value
    return is_open and task.local is not None and task.local.row.says != task.row.says
