"""A paper's source -> its rows, judged where something is asserted; nothing of it ends the run."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import sympy as sp

from mechproof.arguments.scalars import check_function, check_number, check_text, require
from mechproof.document.constraints import find_multiple
from mechproof.document.roles import Role
from mechproof.document.rows import Document, Left, State, Task
from mechproof.document.sources import read_source
from mechproof.document.text import Place
from mechproof.processes import WorkerError, run_tasks
from mechproof.proof.domain import Domain
from mechproof.proof.judge import judge
from mechproof.proof.ladder import ContradictionError, decide
from mechproof.proof.verdict import Judgement, Verdict
from mechproof.record import Equality, Holds, RecordError

# Seconds for one equation.
LIMIT = 60.0
MULTIPLE = "multiple of a constraint"


# Where a paper comes from, and the rows of papers that are at work: a process that was forked finds
# here what its parent had. SymPy would work relations out on their way through a pipe.
_Key = tuple[str, str | None]
_opened: dict[_Key, list[Task]] = {}


@dataclass(frozen=True)
class CheckedRow:
    """One relation sign of a paper: where it stands, what it does, its judgement or why none."""

    name: str
    place: Place
    latex: str
    state: State
    role: Role | None = None
    judgement: Judgement | None = None
    reason: str = ""
    remedy: str = ""

    @property
    def outcome(self) -> str:
        """Return the verdict, or the state of what has none."""
        return self.judgement.verdict.value if self.judgement else self.state.value

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


@dataclass(frozen=True)
class CheckedPaper:
    """The rows of a paper's source, the letters taken as real numbers, and what was not found."""

    file: str
    rows: tuple[CheckedRow, ...]
    taken: tuple[str, ...] = ()
    missing: tuple[tuple[Place, str], ...] = ()


def rows_to_json(rows: Sequence[CheckedRow]) -> str:
    """Return rows as JSON, each on a line of its own."""
    written = (json.dumps(row.as_dict(), ensure_ascii=False) for row in rows)
    return '{\n"rows": [' + ",".join(f"\n{line}" for line in written) + "]\n}\n"


def check(
    path: str | Path,
    content: str | None = None,
    *,
    limit: float = LIMIT,
    report: Callable[[str], None] = lambda text: None,
) -> CheckedPaper:
    """Read a paper's source and judge what it asserts.

    `path` names a LaTeX or a Markdown file; `content` is what stands in it, where it is no file.
    A row that takes longer than `limit` seconds is not judged and says so; `report` is told what
    is done.
    Raises `DocumentError` for a file that cannot be read, `ValueError` (also `BlockError`) for a
    block of letters that cannot, `TypeError` for arguments of another kind.
    """
    allowed = "must be the name of a file"
    require(isinstance(path, str | Path), "path", path, allowed, TypeError)
    if content is not None:
        check_text("content", content)
    require(check_number("limit", limit) > 0, "limit", limit, "must be positive")
    check_function("report", report)
    key = (str(path), content)
    source = read_source(*key)
    document = Document(source)
    found = document.read(limit)
    tasks = [one for one in found if isinstance(one, Task)]
    report(f"judging {len(tasks)} rows")
    _opened[key] = tasks
    try:
        rows = _run(_judge, [(key, number) for number in range(len(tasks))], tasks, limit)
        rows |= _follow(key, tasks, rows, limit)
    finally:
        del _opened[key]
    judged = iter(rows[number] for number in range(len(tasks)))
    shown = tuple(_show(one) if isinstance(one, Left) else next(judged) for one in found)
    return CheckedPaper(str(path), shown, document.taken, tuple(source.missing))


def _open(key: _Key) -> list[Task]:
    if key not in _opened:
        found = Document(read_source(*key)).read(LIMIT)
        _opened[key] = [one for one in found if isinstance(one, Task)]
    return _opened[key]


def _run(
    function: Callable[[Any], Judgement | str],
    numbers: Sequence[Any],
    tasks: Sequence[Task],
    limit: float,
) -> dict[int, CheckedRow]:
    """Judge rows on all processors; one that hangs or crashes is a row that says so."""
    return {
        numbers[place][1]: _make_row(tasks[numbers[place][1]], answer)
        for place, answer in run_tasks(function, numbers, limit=limit)
    }


def _make_row(task: Task, answer: Judgement | str | WorkerError) -> CheckedRow:
    head = (task.row.number, task.place, task.row.printed_latex)
    if isinstance(answer, Judgement):
        return CheckedRow(*head, State.JUDGED, task.sign.role, answer, answer.reason)
    return CheckedRow(*head, State.NOT_JUDGED, task.sign.role, reason=str(answer))


def _show(left: Left) -> CheckedRow:
    head = (left.name, left.place, left.latex, left.state)
    return CheckedRow(*head, reason=left.reason, remedy=left.remedy)


def _judge(which: tuple[_Key, int]) -> Judgement | str:
    """Judge a row, or say why not; what asserts nothing is refuted only if it is true nowhere."""
    task = _open(which[0])[which[1]]
    try:
        found = judge(task.row, task.paper)
    except (RecordError, ContradictionError) as error:
        return str(error)
    if task.sign.first and found.verdict is Verdict.REFUTED and task.asserts:
        return replace(found, reason=f"{found.reason}; compared with {task.sign.first}")
    if task.asserts or found.verdict not in (Verdict.REFUTED, Verdict.UNDECIDED, Verdict.ENCLOSED):
        return found
    if found.verdict is Verdict.REFUTED and _is_nowhere_true(task):
        return replace(found, reason=f"it is true nowhere: {found.reason}")
    return _take_as_given(task, found)


def _is_nowhere_true(task: Task) -> bool:
    says = task.row.says
    domain = Domain.of(task.paper, task.row.on)
    if isinstance(says, Equality) and task.residual is not None:
        apart = Holds(sp.Ne(says.printed, says.rebuilt, evaluate=False))
        return decide(apart, domain).verdict is Verdict.PROVED
    if isinstance(says, Holds):
        return decide(Holds(sp.Not(says.relation)), domain).verdict is Verdict.PROVED
    return False


def _take_as_given(task: Task, found: Judgement) -> Judgement:
    what = "a condition" if isinstance(task.row.says, Holds) else "a constraint between its letters"
    reason = f"{what}, taken as given: it is not true for all values of its letters"
    if found.verdict is not Verdict.REFUTED:
        reason = f"{what}, taken as given"
    return replace(found, verdict=Verdict.DEFINITION, rung="definition", reason=reason, evidence=())


# Constraints ------------------------------------------------------------------------------------


def _follow(
    key: _Key, tasks: Sequence[Task], rows: Mapping[int, CheckedRow], limit: float
) -> dict[int, CheckedRow]:
    """Judge again what was taken as given, beside the constraints that are printed before it."""
    given = [
        number
        for number, task in enumerate(tasks)
        if task.residual is not None and isinstance(task.row.says, Equality)
        if rows[number].outcome == Verdict.DEFINITION.value
    ]
    numbers = [(key, number, tuple(given[:place])) for place, number in enumerate(given)]
    found = _run(_compare, numbers[1:], tasks, limit)
    return {number: row for number, row in found.items() if row.outcome != State.NOT_JUDGED}


def _compare(which: tuple[_Key, int, tuple[int, ...]]) -> Judgement | str:
    """Judge a row by the first constraint before it that it follows from, or contradicts."""
    key, number, before = which
    task, domain = (
        _open(key)[number],
        Domain.of(_open(key)[number].paper, _open(key)[number].row.on),
    )
    for other in before:
        name, residual = _open(key)[other].row.number, _open(key)[other].residual
        multiple = find_multiple(task.residual, residual, domain)
        if multiple is None:
            continue
        factor, rest = multiple
        reason = f"left - right is that of {name} times {factor}"
        if rest == 0:
            return _decide_by(task, Verdict.PROVED, f"follows from {name}: {reason}")
        return _decide_by(task, Verdict.REFUTED, f"contradicts {name}: {reason}, plus {rest}")
    return "neither follows nor contradicts"


def _decide_by(task: Task, verdict: Verdict, reason: str) -> Judgement:
    return replace(judge(task.row, task.paper), verdict=verdict, rung=MULTIPLE, reason=reason)
