"""The rows of a paper that is judged: where each stands, what it does, what became of it."""

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

# A member of a family with a value of its index, such as d_{bi}[1].
_MEMBER = re.compile(r"_(?:\{([^{}]*?)([i-n]+)\}|([i-n]+))\[([^\[\]]+)\]")


@dataclass(frozen=True)
class CheckedRow:
    """One relation sign of a paper: where it stands, what it does, its judgement or why none.

    `stated` is the row with what it says by itself, where that could be read.
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
        """Return the verdict, or the state of what has none."""
        return self.judgement.verdict.value if self.judgement else self.state.value

    def leave(self) -> Left:
        """Return what the ledger has of a row without a verdict."""
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
    """Return the row of a task with its judgement, or why there is none."""
    head = (task.row.number, task.place, task.row.printed_latex)
    if isinstance(answer, Judgement):
        judged = replace(answer, place=task.place, reason=_write_plainly(answer.reason))
        told = (task.sign.role, judged, judged.reason)
        return CheckedRow(*head, State.JUDGED, *told, stated=task.row)
    return CheckedRow(*head, State.NOT_JUDGED, task.sign.role, reason=_write_plainly(str(answer)))


def show_left(left: Left) -> CheckedRow:
    """Return the row of what is not judged."""
    head = (left.number, left.place, left.printed_latex, left.state)
    return CheckedRow(*head, reason=_write_plainly(left.reason), remedy=left.remedy)


def _write_plainly(reason: str) -> str:
    """Write powers and bound variables as in what a print is read as, x^2, members as printed."""
    return _MEMBER.sub(_write_member, name_bound(reason.replace("**", "^")))


def _write_member(found: re.Match[str]) -> str:
    """Return the index of a member of a family, d_{b1} for d_{bi}[1]."""
    letters, values = found[2] or found[3], found[4].split(", ")
    if len(letters) < len(values):
        return found[0]
    numbers = ("" if all(len(value) == 1 for value in values) else ",").join(values)
    index = f"{found[1] or ''}{letters[: -len(values)]}{numbers}"
    return f"_{index}" if len(index) == 1 else f"_{{{index}}}"


def list_standing(
    task: Task, tasks: Sequence[Task], rows: Mapping[int, CheckedRow]
) -> list[list[str]]:
    """Return the members that a print is compared with, those together that do not differ.

    If one group is the largest, the members of the others do not stand.
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
