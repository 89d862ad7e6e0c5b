"""Numbers that are compared with a later print of a letter, which has to be proved itself.

Beside a loop the definition of a position may need an angle that no table has; what follows from
both gives the position by the angle of the crank alone.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from mechproof.document.checked_rows import CheckedRow, make_row
from mechproof.document.constraints.applicable_constraints import is_plain
from mechproof.document.constraints.consequences import FOLLOWING
from mechproof.document.context.constrained_rows import binds
from mechproof.document.judging import name_equation
from mechproof.document.tasks import Task
from mechproof.proof.verdict import Verdict


def doubt_by_restated(
    tasks: Sequence[Task], rows: Mapping[int, CheckedRow]
) -> Iterator[tuple[int, CheckedRow]]:
    """Leave open what rests on a later print that is not proved, or that may be of a case."""
    for n, task in enumerate(tasks):
        name, reason = task.rests_on
        if name and not _holds_in_general(name, tasks, rows):
            yield n, make_row(task, reason)


def _holds_in_general(name: str, tasks: Sequence[Task], rows: Mapping[int, CheckedRow]) -> bool:
    """Return whether all signs of an equation are proved, and nothing tells that this is a case."""
    own = [n for n, task in enumerate(tasks) if name_equation(task.row.number) == name]
    are_proved = bool(own) and all(rows[n].outcome == Verdict.PROVED.value for n in own)
    return are_proved and not any(
        _may_be_case(tasks[m]) or (m not in own and is_plain(tasks[m]))
        for n in own
        for m in (n, *_list_premises(n, tasks, rows))
    )


def _list_premises(
    number: int, tasks: Sequence[Task], rows: Mapping[int, CheckedRow]
) -> Iterator[int]:
    """Yield the constraints that a row follows from, as it says."""
    found = rows[number].judgement
    for m, one in enumerate(tasks):
        is_used = found is not None and found.rung in FOLLOWING and binds(one)
        if is_used and m != number and one.row.number in rows[number].reason:
            yield m


def _may_be_case(task: Task) -> bool:
    said = task.said
    is_special = said.is_special or said.is_position or said.is_equating or bool(task.at)
    return is_special or said.is_case or bool(said.example.number)
