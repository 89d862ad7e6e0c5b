"""A paper's source -> its rows, judged where something is asserted; nothing of it ends the run."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from mechproof.arguments.scalars import check_function, check_number, check_text, require
from mechproof.document.consequences import GIVEN, list_letters
from mechproof.document.judging import (
    COMPARED,
    LIMIT,
    Key,
    judge_beside,
    judge_excused,
    judge_members,
    judge_misprint,
    judge_row,
    leave_out,
    opened,
)
from mechproof.document.roles import Role, name_member
from mechproof.document.rows import Document
from mechproof.document.sources import read_source
from mechproof.document.tasks import Task
from mechproof.proof.findings import list_findings
from mechproof.proof.ledger import JudgedPaper
from mechproof.proof.verdict import Judgement, Left, Place, State, Verdict
from mechproof.record import Conjunction, Equality, Equation, Paper, Row
from mechproof.tools.processes import WorkerError, run_tasks

_EITHER = (
    "the two sides differ, though they have the same letters: a misprint, or a constraint? Say "
    "which in the block of letters: identity, or constraint"
)
# What may yet follow from constraints.
_UNPROVED = (Verdict.DEFINITION, Verdict.UNDECIDED, Verdict.ENCLOSED)


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


@dataclass(frozen=True)
class CheckedPaper:
    """The rows of a paper's source, the letters taken as real numbers, and files not found.

    `paper` has the letters, without rows; `told` are tables and columns that are not compared;
    `names` are those of all equations, in their order.
    """

    file: str
    rows: tuple[CheckedRow, ...]
    paper: Paper
    taken: tuple[str, ...] = ()
    missing: tuple[tuple[Place, str], ...] = ()
    told: tuple[tuple[Place, str], ...] = ()
    names: tuple[str, ...] = ()

    def to_ledger(self, system: str = "") -> JudgedPaper:
        """Return the ledger of the paper: rows of one name are told apart by their places.

        `system` is the name of the paper, left out that of its file.
        """
        names = [row.name for row in self.rows]
        rows = [
            row if names.count(row.name) == 1 else replace(row, name=f"{row.name}, {row.place}")
            for row in self.rows
        ]
        system = system or self.paper.system
        judged = tuple(
            replace(row.judgement, system=system, number=row.name) for row in rows if row.judgement
        )
        paper = replace(
            self.paper,
            system=system,
            citation=Path(self.file).name,
            rows=tuple(Equation(row.name, row.latex) for row in rows),
        )
        return JudgedPaper(
            paper.system,
            paper.reference,
            judged,
            findings=list_findings(paper, judged),
            left=tuple(row.leave() for row in rows if not row.judgement),
            paper=paper,
        )


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
    return _check((str(path), content, frozenset()), limit, report)


def check_rest(
    path: Path, rows: Iterable[Row], limit: float, report: Callable[[str], None]
) -> CheckedPaper:
    """Judge what a paper's source has besides the numbers and prints of rows, as `check` does."""
    elsewhere = frozenset(text for row in rows for text in (row.number, row.printed_latex))
    return _check((str(path), None, elsewhere), limit, report)


def _check(key: Key, limit: float, report: Callable[[str], None]) -> CheckedPaper:
    path, content, elsewhere = key
    source = read_source(path, content)
    document = Document(source)
    found = tuple(leave_out(document.read(limit), elsewhere))
    tasks = [one for one in found if isinstance(one, Task)]
    report(f"judging {len(tasks)} rows")
    opened[key] = tasks
    try:
        numbers = [(key, number) for number in range(len(tasks))]
        answers = run_tasks(judge_row, numbers, limit=limit)
        rows = {number: _make_row(tasks[number], answer) for number, answer in answers}
        rows |= dict(_compare_members(key, tasks, rows, limit))
        rows |= dict(_follow(key, tasks, rows, limit))
        rows |= dict(_excuse(key, tasks, rows, limit))
        misprints = dict(_find_misprints(key, tasks, rows, limit))
        rows |= dict(_leave_open(tasks, rows))
        rows |= misprints
    finally:
        del opened[key]
    judged = iter(rows[number] for number in range(len(tasks)))
    shown = tuple(_show(one) if isinstance(one, Left) else next(judged) for one in found)
    paper = document.papers[True]
    missing, told = tuple(source.missing), tuple(document.told)
    names = tuple(dict.fromkeys(printed.name for printed in document.printed))
    return CheckedPaper(path, shown, paper, document.taken, missing, told, names)


def _leave_open(
    tasks: Sequence[Task], rows: Mapping[int, CheckedRow]
) -> Iterator[tuple[int, CheckedRow]]:
    """Leave open what is compared with another print and differs from it by its letters.

    So is what is not true and has the same letters on both sides, as identities have.
    """
    for number, task in enumerate(tasks):
        found = rows[number].judgement
        if not found or found.rung != GIVEN:
            continue
        if task.sign.role in COMPARED:
            other = task.sign.first or "the member before"
            reason = f"it differs from {other} and has other letters: a constraint, or a misprint?"
            yield number, _make_row(task, reason)
        elif task.is_either:
            yield number, _make_row(task, _EITHER)


def _make_row(task: Task, answer: Judgement | str | WorkerError) -> CheckedRow:
    head = (task.row.number, task.place, task.row.printed_latex)
    if isinstance(answer, Judgement):
        judged = replace(answer, place=task.place)
        return CheckedRow(*head, State.JUDGED, task.sign.role, judged, answer.reason)
    return CheckedRow(*head, State.NOT_JUDGED, task.sign.role, reason=str(answer))


def _show(left: Left) -> CheckedRow:
    head = (left.number, left.place, left.printed_latex, left.state)
    return CheckedRow(*head, reason=left.reason, remedy=left.remedy)


# Members ----------------------------------------------------------------------------------------


def _compare_members(
    key: Key, tasks: Sequence[Task], rows: Mapping[int, CheckedRow], limit: float
) -> Iterator[tuple[int, CheckedRow]]:
    """Judge later prints of a letter by all members that stand of the chain that printed it."""
    numbers = []
    for n, task in enumerate(tasks):
        if not task.others or task.follows:
            continue
        standing = _list_standing(task, tasks, rows)
        is_proved = rows[n].outcome == Verdict.PROVED.value
        if not (is_proved and task.sign.first in standing[0]):
            numbers.append((key, n, standing))
    for place, answer in run_tasks(judge_members, numbers, limit=limit):
        number = numbers[place][1]
        yield number, _make_row(tasks[number], answer)


def _list_standing(
    task: Task, tasks: Sequence[Task], rows: Mapping[int, CheckedRow]
) -> list[list[str]]:
    """Return the members that a print is compared with, those together that do not differ.

    Of groups of which one is the largest the others do not stand.
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


# Constraints ------------------------------------------------------------------------------------


def _follow(
    key: Key, tasks: Sequence[Task], rows: Mapping[int, CheckedRow], limit: float
) -> Iterator[tuple[int, CheckedRow]]:
    """Judge again what is not shown to hold by itself: it may follow from constraints before it."""
    given = [n for n, task in enumerate(tasks) if _is_constraint(task, rows[n])]
    numbers = []
    for n, task in enumerate(tasks):
        common = [g for g in given if g < n and _have_common(tasks[g], task)]
        if common and rows[n].outcome in _UNPROVED and not task.is_claimed:
            numbers.append((key, n, tuple(common)))
    for place, found in run_tasks(judge_beside, numbers, limit=limit):
        number = numbers[place][1]
        if isinstance(found, Judgement):
            yield number, _make_row(tasks[number], found)


def _excuse(
    key: Key, tasks: Sequence[Task], rows: Mapping[int, CheckedRow], limit: float
) -> Iterator[tuple[int, CheckedRow]]:
    """Judge again two sides that were said to be equal and are not: constraints may make them so.

    Without any that have letters of theirs, and no letter of their own, they are not asked.
    """
    given = [n for n, task in enumerate(tasks) if _is_constraint(task, rows[n])]
    numbers = []
    for n, task in enumerate(tasks):
        common = [g for g in given if _have_common(tasks[g], task) and not tasks[g].is_loose]
        is_refuted = rows[n].outcome == Verdict.REFUTED.value and task.asserts
        if common and is_refuted and not task.is_claimed:
            numbers.append((key, n, tuple(_connect(n, given, tasks))))
    for place, answer in run_tasks(judge_excused, numbers, limit=limit):
        yield numbers[place][1], _make_row(tasks[numbers[place][1]], answer)


def _have_common(one: Task, other: Task) -> bool:
    says = other.row.says
    is_equation = isinstance(says, Equality | Conjunction)
    return is_equation and bool(list_letters(one) & list_letters(other))


def _find_misprints(
    key: Key, tasks: Sequence[Task], rows: Mapping[int, CheckedRow], limit: float
) -> Iterator[tuple[int, CheckedRow]]:
    """Judge what may be a constraint or a misprint."""
    given = [n for n, task in enumerate(tasks) if _is_constraint(task, rows[n])]
    numbers = [
        (key, n, tuple(_connect(n, given, tasks)))
        for n, task in enumerate(tasks)
        if _may_be_misprint(task, rows[n])
        # Of a letter whose first prints differ nobody knows which is meant.
        and not (task.others and len(_list_standing(task, tasks, rows)) > 1)
    ]
    for place, found in run_tasks(judge_misprint, numbers, limit=limit):
        number = numbers[place][1]
        if isinstance(found, Judgement):
            yield number, _make_row(tasks[number], found)


def _may_be_misprint(task: Task, row: CheckedRow) -> bool:
    is_open = row.state is State.NOT_JUDGED or bool(row.judgement and row.judgement.rung == GIVEN)
    is_equation = isinstance(task.row.says, Equality) and task.sign.number in ("", "0")
    is_one_of_two = task.is_solution or (task.is_excused and not task.asserts)
    return is_open and is_equation and not (task.is_rounded or is_one_of_two)


def _connect(number: int, given: Sequence[int], tasks: Sequence[Task]) -> Iterator[int]:
    """Yield the constraints that have letters of a row, or of others of them."""
    letters, left = list_letters(tasks[number]), [g for g in given if g != number]
    while tied := [g for g in left if list_letters(tasks[g]) & letters]:
        yield from tied
        letters = letters.union(*(list_letters(tasks[g]) for g in tied))
        left = [g for g in left if g not in tied]


def _is_constraint(task: Task, row: CheckedRow) -> bool:
    is_given = row.outcome == Verdict.DEFINITION.value and task.sign.role is Role.CONSTRAINT
    is_equation = isinstance(task.row.says, Equality) and task.residual is not None
    return is_given and is_equation and not (task.is_rounded or task.is_either)
