"""Rows that hold at what a worked example says of letters, and may not belong to it.

They are neither proved nor refuted: where an example ends words do not always tell.
"""

from __future__ import annotations

from mechproof.document.checked_rows import CheckedRow, make_row
from mechproof.document.judged_tasks import Changes, Judging
from mechproof.document.judging_workers import COMPARED, judge_special
from mechproof.document.tasks import Task
from mechproof.proof.verdict import Judgement, State, Verdict

_OPEN = (Verdict.UNDECIDED, Verdict.ENCLOSED)


def doubt_by_examples(at: Judging) -> Changes:
    """Leave open what holds in an example only; in one also what is not decided there."""
    asked = [(n, "local") for n, task in enumerate(at.tasks) if _may_be_local(task, at.rows[n])]
    for (n, _), answer in at.ask(judge_special, asked):
        task = at.tasks[n]
        found = answer.verdict if isinstance(answer, Judgement) else None
        is_within = bool(task.said.example.number) and found in _OPEN
        if task.local and (found is Verdict.PROVED or is_within):
            said = ", ".join(f"{s} = {value}" for s, value in task.local.at.items())
            verb = "holds" if found is Verdict.PROVED else "may hold"
            reason = f"it {verb} for {said}, which is printed in a worked example: is that meant?"
            yield n, make_row(task, reason)


def _may_be_local(task: Task, row: CheckedRow) -> bool:
    """Return whether a row that is not shown says something else in an example."""
    is_open = row.state is State.NOT_JUDGED and task.sign.role in COMPARED
    is_open |= row.outcome == Verdict.REFUTED.value
    return is_open and task.local is not None and task.local.row.says != task.row.says
