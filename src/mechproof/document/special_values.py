"""Rows compared at a value that words or a print beside them say of a letter.

"With the ring held ($n_3=0$) the ratio is" says at which value a row is meant. What does not hold
in general may hold there. What differs there, too, is refuted if both sides have the same letters
then, as identities have.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from mechproof.document.checked_rows import CheckedRow, make_row
from mechproof.document.consequences import GIVEN
from mechproof.document.judging import COMPARED, Key, judge_special
from mechproof.document.tasks import Task
from mechproof.proof.verdict import Judgement, Verdict
from mechproof.tools.processes import run_tasks


def compare_specially(
    key: Key, tasks: Sequence[Task], rows: Mapping[int, CheckedRow], limit: float
) -> Iterator[tuple[int, CheckedRow]]:
    """Judge again at the values that are said beside it what is not shown to hold in general."""
    asked = [(key, n) for n, task in enumerate(tasks) if task.special and _is_open(rows[n])]
    for place, answer in run_tasks(judge_special, asked, limit=limit):
        number = asked[place][1]
        task = tasks[number]
        if not (isinstance(answer, Judgement) and task.special):
            continue
        is_misprint = answer.verdict is Verdict.REFUTED and task.special.asserts
        if answer.verdict is Verdict.PROVED or (is_misprint and task.sign.role in COMPARED):
            yield number, make_row(task, answer)


def _is_open(row: CheckedRow) -> bool:
    found = row.judgement
    verdicts = (Verdict.REFUTED, Verdict.UNDECIDED, Verdict.ENCLOSED)
    return found is not None and (found.rung == GIVEN or found.verdict in verdicts)
