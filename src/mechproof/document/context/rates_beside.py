"""Derivatives behind a heading: what they are compared with, if one beside them is proved.

A heading may go on to another mechanism, whose letters nobody prints anew. Where a display has a
true derivative of one letter, it is about the mechanism that printed this one, and so are the other
derivatives of the display, of letters printed beside it, and those of the same letter behind words
of a consequence. One with all signs turned may count otherwise: it is left open.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from mechproof.document.checked_rows import make_row
from mechproof.document.judged_tasks import Changes, Judging
from mechproof.document.tasks import Role, Task
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Judgement, State, Verdict
from mechproof.record import Equality


def compare_rates(at: Judging) -> Changes:
    """Judge again derivatives that are left open behind a heading only."""
    tasks, rows, asked = at.tasks, at.rows, []
    for n, task in enumerate(tasks):
        if rows[n].state is not State.NOT_JUDGED or not task.is_solution:
            continue
        proved = [m for m, row in rows.items() if row.outcome == Verdict.PROVED.value]
        anew = [one for m, one in enumerate(tasks) if m not in proved]
        if any(_are_beside(tasks[m], task, tasks, anew) for m in proved):
            asked.append((n,))
    for (n,), answer in at.ask(judge_rate, asked):
        if isinstance(answer, Judgement):
            yield n, make_row(tasks[n], answer)


def _are_beside(one: Task, other: Task, tasks: Sequence[Task], anew: Sequence[Task]) -> bool:
    """Return whether derivatives are printed without words between, and what they are of, too.

    Those of one print may have words of a consequence between. Of letters that are printed `anew`
    nothing is known.
    """
    if any(task.sign.role is not Role.DERIVATIVE or task.said.is_case for task in (one, other)):
        return False
    names = one.sign.first, other.sign.first
    first = [t for name in names for t in tasks if t.row.number == name]
    is_near = one.said.passage == other.said.passage
    if names[0] == names[1] and not one.said.is_apart(other.said):
        later = max(one.said, other.said, key=lambda said: said.passage)
        is_near |= not (later.is_new or one.said.is_equating or other.said.is_equating)
    if len(first) != len(names) or not is_near:
        return False
    is_turned = first[1].said.turns != other.said.turns or other.said.is_of_other(first[1].said)
    letters = {x.sign.letter for x in first}
    is_anew = any(t.sign.letter in letters and t.sign.role is Role.REPEATED for t in anew)
    return first[0].said.passage == first[1].said.passage and not (is_turned or is_anew)


def judge_rate(tasks: Sequence[Task], number: int) -> Judgement | None:
    """Judge a derivative by what it is of; None if it is that, but for the sense of counting."""
    task = tasks[number]
    found, says = judge(task.row, task.paper), task.row.says
    if found.verdict is not Verdict.REFUTED or not isinstance(says, Equality):
        return None
    turned = replace(task.row, says=Equality(says.printed, -says.rebuilt, "member"))
    if judge(turned, task.paper).verdict is not Verdict.REFUTED:
        return None
    return replace(
        found, reason=f"{found.reason.removesuffix('.')}; compared with {task.sign.first}"
    )
