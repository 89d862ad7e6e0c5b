"""A paper's source -> its rows, judged where something is asserted; nothing of it ends the run."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import sympy as sp

from mechproof.arguments.scalars import check_function, check_number, check_text, require
from mechproof.document.constraints import find_combination, find_multiple
from mechproof.document.roles import Role
from mechproof.document.rows import Document
from mechproof.document.sources import read_source
from mechproof.document.tasks import Task
from mechproof.processes import WorkerError, run_tasks
from mechproof.proof.domain import Domain
from mechproof.proof.findings import list_findings
from mechproof.proof.judge import judge
from mechproof.proof.ladder import ContradictionError, decide
from mechproof.proof.ledger import JudgedPaper
from mechproof.proof.verdict import Judgement, Left, Place, State, Verdict
from mechproof.record import Equality, Equation, Holds, Paper, RecordError, Row

# How the row of one sign of a chain is called.
_SIGN = re.compile(r", [\w-]+ (?:equals )?sign\Z")
# Seconds for one equation.
LIMIT = 60.0
MULTIPLE = "multiple of a constraint"
COMBINATION = "combination of constraints"
GIVEN = "definition"
# What is compared, even if letters that only one side has could make both sides equal.
_COMPARED = (Role.REPEATED, Role.DERIVATIVE, Role.STEP)

# Where a paper comes from, and rows that are judged elsewhere; the rows of papers that are at work:
# a process that was forked finds here what its parent had. SymPy would work relations out on their
# way through a pipe.
_Key = tuple[str, str | None, frozenset[str]]
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
    """The rows of a paper's source, the letters taken as real numbers, and what was not found.

    `paper` has the letters, without rows.
    """

    file: str
    rows: tuple[CheckedRow, ...]
    paper: Paper
    taken: tuple[str, ...] = ()
    missing: tuple[tuple[Place, str], ...] = ()

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
            paper.citation,
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


def _check(key: _Key, limit: float, report: Callable[[str], None]) -> CheckedPaper:
    path, content, elsewhere = key
    source = read_source(path, content)
    document = Document(source)
    found = tuple(_leave_out(document.read(limit), elsewhere))
    tasks = [one for one in found if isinstance(one, Task)]
    report(f"judging {len(tasks)} rows")
    _opened[key] = tasks
    try:
        numbers = [(key, number) for number in range(len(tasks))]
        answers = run_tasks(_judge, numbers, limit=limit)
        rows = {number: _make_row(tasks[number], answer) for number, answer in answers}
        rows |= dict(_follow(key, tasks, rows, limit))
        rows |= dict(_leave_open(tasks, rows))
    finally:
        del _opened[key]
    judged = iter(rows[number] for number in range(len(tasks)))
    shown = tuple(_show(one) if isinstance(one, Left) else next(judged) for one in found)
    paper = document.papers[True]
    missing = (*source.missing, *document.told)
    return CheckedPaper(path, shown, paper, document.taken, missing)


def _leave_out(rows: Sequence[Task | Left], elsewhere: frozenset[str]) -> Iterator[Task | Left]:
    """Yield the rows that are judged nowhere else; of what is not read the signs are not known."""
    equations = {_SIGN.sub("", number) for number in elsewhere}
    for one in rows:
        row, judged = (one.row, elsewhere) if isinstance(one, Task) else (one, equations)
        if not judged & {row.number, row.printed_latex}:
            yield one


def _leave_open(
    tasks: Sequence[Task], rows: Mapping[int, CheckedRow]
) -> Iterator[tuple[int, CheckedRow]]:
    """Leave open what is compared with another print and differs from it by its letters."""
    for number, task in enumerate(tasks):
        found = rows[number].judgement
        if found and found.rung == GIVEN and task.sign.role in _COMPARED:
            other = task.sign.first or "the member before"
            reason = f"it differs from {other}, in its letters too: a constraint, or a misprint?"
            yield number, _make_row(task, reason)


def _open(key: _Key) -> list[Task]:
    if key not in _opened:
        path, content, elsewhere = key
        found = _leave_out(Document(read_source(path, content)).read(LIMIT), elsewhere)
        _opened[key] = [one for one in found if isinstance(one, Task)]
    return _opened[key]


def _make_row(task: Task, answer: Judgement | str | WorkerError) -> CheckedRow:
    head = (task.row.number, task.place, task.row.printed_latex)
    if isinstance(answer, Judgement):
        judged = replace(answer, place=task.place)
        return CheckedRow(*head, State.JUDGED, task.sign.role, judged, answer.reason)
    return CheckedRow(*head, State.NOT_JUDGED, task.sign.role, reason=str(answer))


def _show(left: Left) -> CheckedRow:
    head = (left.number, left.place, left.printed_latex, left.state)
    return CheckedRow(*head, reason=left.reason, remedy=left.remedy)


def _judge(which: tuple[_Key, int]) -> Judgement | str:
    """Judge a row, or say why not; what asserts nothing is refuted only if it is true nowhere."""
    task = _open(which[0])[which[1]]
    try:
        found = judge(task.row, task.paper)
    except (RecordError, ContradictionError) as error:
        return str(error)
    if found.verdict is Verdict.REFUTED and task.is_rounded:
        return "the two sides differ, but a decimal is a rounded number"
    if found.verdict is Verdict.REFUTED and task.is_alone:
        return f"another value than at the sizes: {found.reason}"
    if task.sign.first and found.verdict is Verdict.REFUTED and task.asserts:
        reason = f"{found.reason.removesuffix('.')}; compared with {task.sign.first}"
        return replace(found, reason=reason)
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
    return replace(found, verdict=Verdict.DEFINITION, rung=GIVEN, reason=reason, evidence=())


# Constraints ------------------------------------------------------------------------------------


def _follow(
    key: _Key, tasks: Sequence[Task], rows: Mapping[int, CheckedRow], limit: float
) -> Iterator[tuple[int, CheckedRow]]:
    """Judge again what does not hold by itself, beside the constraints of the paper.

    It may follow from constraints before it; two sides that were said to be equal and are not are
    left open where any constraint has letters of theirs.
    """
    given = [n for n, task in enumerate(tasks) if _is_constraint(task, rows[n])]
    numbers = []
    for n, task in enumerate(tasks):
        if task.is_claimed or not isinstance(task.row.says, Equality):
            continue
        common = [g for g in given if g != n and _list_letters(tasks[g]) & _list_letters(task)]
        if rows[n].outcome == Verdict.DEFINITION.value:
            common = [g for g in common if g < n]
        if common and rows[n].outcome in (Verdict.DEFINITION.value, Verdict.REFUTED.value):
            numbers.append((key, n, tuple(common)))
    for place, answer in run_tasks(_compare, numbers, limit=limit):
        number = numbers[place][1]
        found = rows[number].judgement
        if found and isinstance(answer, tuple):
            verdict, rung, reason = answer
            new = replace(found, verdict=verdict, rung=rung, reason=reason, evidence=())
            yield number, _make_row(tasks[number], new)
        elif rows[number].outcome == Verdict.REFUTED.value:
            yield number, _make_row(tasks[number], str(answer))


def _is_constraint(task: Task, row: CheckedRow) -> bool:
    is_given = row.outcome == Verdict.DEFINITION.value and task.sign.role is Role.CONSTRAINT
    is_equation = isinstance(task.row.says, Equality) and task.residual is not None
    return is_given and is_equation and not task.is_rounded


def _list_letters(task: Task) -> set[sp.Basic]:
    return set() if task.residual is None else set(task.residual.free_symbols)


def _compare(which: tuple[_Key, int, tuple[int, ...]]) -> tuple[Verdict, str, str] | str:
    """Judge a row by the constraints that it follows from, or cannot hold together with."""
    key, number, others = which
    tasks = _open(key)
    task = tasks[number]
    domain = Domain.of(task.paper, task.row.on)
    for other in others:
        name = tasks[other].row.number
        multiple = find_multiple(task.residual, tasks[other].residual, domain)
        if multiple is None or other > number:
            continue
        factor, rest = multiple
        reason = f"left - right is that of {name} times {factor}"
        if rest == 0:
            return Verdict.PROVED, MULTIPLE, f"follows from {name}: {reason}"
        reason = f"cannot hold together with {name}: {reason}, plus {rest}"
        return Verdict.DEFINITION, GIVEN, reason
    if found := _combine(task, [tasks[other] for other in others if other < number], domain):
        return found
    names = ", ".join(tasks[other].row.number for other in others)
    return f"the two sides differ, unless {names} makes them equal, which is not decided"


def _combine(task: Task, others: Sequence[Task], domain: Domain) -> tuple[Verdict, str, str] | None:
    """Return that a row follows from several constraints, or from the derivative of some."""
    alone = [other for other in others if other.row.on is None and other.residual is not None]
    given = {other.row.number: other.residual for other in alone}
    for known in (given, *_list_rates(task, alone)):
        multipliers = find_combination(task.residual, list(known.values()), domain)
        if multipliers is not None:
            parts = [
                f"{name} times {m}" for name, m in zip(known, multipliers, strict=True) if m != 0
            ]
            reason = f"follows from constraints: left - right is {', plus '.join(parts)}"
            return Verdict.PROVED, COMBINATION, reason
    return None


def _list_rates(task: Task, others: Sequence[Task]) -> Iterator[dict[str, sp.Expr]]:
    """Yield the first derivatives of constraints, and with them the second ones."""
    found: dict[str, sp.Expr] = {}
    for order, name in enumerate(("the derivative", "the second derivative")):
        new = {
            f"{name} of {other.row.number}": other.rates[order]
            for other in others
            if len(other.rates) > order
            and other.rates[order].free_symbols & _list_letters(task) - _list_letters(other)
        }
        if new:
            found |= new
            yield found
