"""The rows of a judged paper: the place, the role and the outcome of each."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from mechproof.document.printed_signs import name_member
from mechproof.document.tasks import Role, Task
from mechproof.proof.verdict import Judgement, Left, State, Verdict
from mechproof.proof.witness_text import name_bound
from mechproof.record import Row
from mechproof.sources.located_text import Place
from mechproof.tools.processes import WorkerError

# Why an equation is not judged if a step of the program fails on it.
UNFORESEEN = (
    "it could not be judged: it has an unexpected form; print it in another way, or in parts"
)
# The name of a Python exception, in front of its message.
_RAISED = re.compile(r"([A-Za-z]\w*(?:Error|Exception|Needed|Failed)|[A-Z]\w+): ")
# A member of a family with a value of its index, such as d_{bi}[1].
_MEMBER = re.compile(r"_(?:\{([^{}]*?)([i-n]+)\}|([i-n]+))\[([^\[\]]+)\]")


@dataclass(frozen=True)
class CheckedRow:
    """One relation sign of a paper: its place, its role, and its judgement or why it has none.

    `stated` is the row with its statement taken on its own, or None if that could not be read.
    """

    name: str
    place: Place
    latex: str
    state: State
    role: Role | None = None
    judgement: Judgement | None = None
    reason: str = ""
    remedy: str = ""
    stated: Row | None = None

    @property
    def outcome(self) -> str:
        """Return the verdict, or the state of a row that has none."""
        return self.judgement.verdict.value if self.judgement else self.state.value

    def leave(self) -> Left:
        """Return the ledger's entry for a row without a verdict."""
        return Left(self.name, self.place, self.latex, self.state, self.reason, self.remedy)

    def as_dict(self) -> dict[str, object]:
        """Return the JSON row."""
        return {
            "name": self.name,
            "place": str(self.place),
            "latex": self.latex,
            "outcome": self.outcome,
            "role": self.role.value if self.role else "",
            "reason": self.reason,
            "remedy": self.remedy,
            "judgement": self.judgement.as_dict() if self.judgement else None,
        }


def rows_to_json(rows: Sequence[CheckedRow]) -> str:
    """Return rows as JSON, each on a line of its own."""
    written = (json.dumps(row.as_dict(), ensure_ascii=False) for row in rows)
    return '{\n"rows": [' + ",".join(f"\n{line}" for line in written) + "]\n}\n"


def make_row(task: Task, answer: Judgement | str | WorkerError) -> CheckedRow:
    """Return a task's row with its judgement, or with the reason why there is none."""
    head = (task.row.number, task.place, task.row.printed_latex)
    if isinstance(answer, Judgement):
        judged = replace(answer, place=task.place, reason=_write_plainly(answer.reason))
        told = (task.sign.role, judged, judged.reason)
        return CheckedRow(*head, State.JUDGED, *told, stated=task.row)
    reason = _describe_failure(answer) if isinstance(answer, WorkerError) else answer
    return CheckedRow(*head, State.NOT_JUDGED, task.sign.role, reason=_write_plainly(reason))


def _describe_failure(error: WorkerError) -> str:
    """Return why a row has no answer, with the name of the exception in brackets."""
    told = str(error)
    if found := _RAISED.match(told):
        return f"{UNFORESEEN} ({found[1]})"
    is_ended = told.startswith("its process ended")
    return f"{told}: it may need more memory than is available" if is_ended else told


def show_left(left: Left) -> CheckedRow:
    """Return the row of a print that is not judged."""
    head = (left.number, left.place, left.printed_latex, left.state)
    return CheckedRow(*head, reason=_write_plainly(left.reason), remedy=left.remedy)


def _write_plainly(reason: str) -> str:
    """Write powers as x^2, bound variables by name, and members of families as printed."""
    return _MEMBER.sub(_write_member, name_bound(reason.replace("**", "^")))


def _write_member(found: re.Match[str]) -> str:
    """Return the printed index of a member of a family: d_{b1} for d_{bi}[1]."""
    letters, values = found[2] or found[3], found[4].split(", ")
    if len(letters) < len(values):
        return found[0]
    numbers = ("" if all(len(value) == 1 for value in values) else ",").join(values)
    index = f"{found[1] or ''}{letters[: -len(values)]}{numbers}"
    return f"_{index}" if len(index) == 1 else f"_{{{index}}}"


def list_standing(
    task: Task, tasks: Sequence[Task], rows: Mapping[int, CheckedRow]
) -> list[list[str]]:
    """Return the members that a print is compared with, in groups that agree among themselves.

    Only the largest groups are returned, each with the other cases that are printed.
    """
    first = task.sign.first
    groups = [[first]]
    steps = (n for n, one in enumerate(tasks) if one.row.number.startswith(f"{first}, "))
    for number, step in enumerate((n for n in steps if tasks[n].sign.role is Role.STEP), 3):
        if rows[step].outcome == Verdict.REFUTED.value:
            groups.append([])
        groups[-1].append(name_member(number, first))
    largest = max(map(len, groups))
    cases = [one.sign.first for one in task.others if not one.sign.first.endswith(f" of {first}")]
    return [[*group, *cases] for group in groups if len(group) == largest]
