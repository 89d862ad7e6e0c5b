"""A paper's source -> its rows, judged where they assert something; no row can end the run."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from pathlib import Path

from mechproof.arguments.scalars import check_function, check_number, check_text, require
from mechproof.document.checked_rows import CheckedRow, list_standing, make_row, show_left
from mechproof.document.constraints.consequences import GIVEN, ROOT
from mechproof.document.context.accused_rows import doubt_by_proved, find_misprints
from mechproof.document.context.constrained_rows import (
    doubt_by_premises,
    excuse_by_constraints,
    follow_from_constraints,
    solve_constraints,
    support_steps,
)
from mechproof.document.context.doubted_letters import (
    EITHER,
    doubt_by_examples,
    doubt_by_frames,
    doubt_by_lengths,
    doubt_by_letters,
    doubt_by_matrices,
    doubt_by_rounded,
)
from mechproof.document.context.doubts import (
    doubt_by_decimals,
    doubt_by_factors,
    doubt_by_indices,
    doubt_by_positions,
    doubt_by_rates,
    doubt_by_unread,
    doubt_conditions,
    find_contradictions,
    find_other_solutions,
)
from mechproof.document.context.newer_prints import compare_newer_prints, doubt_by_cases, find_roots
from mechproof.document.context.restated_prints import (
    compare_rates,
    compare_restated,
    describe_unlike,
    doubt_by_restated,
)
from mechproof.document.context.undeclared_motion import (
    doubt_by_motion,
    doubt_by_stillness,
    doubt_by_ties,
)
from mechproof.document.context.values_at_places import compare_at_places
from mechproof.document.judging_workers import (
    COMPARED,
    LIMIT,
    UNLIKE,
    Changes,
    Judging,
    Key,
    judge_members,
    judge_row,
    judge_special,
    leave_out,
    opened,
)
from mechproof.document.source_rows import Document
from mechproof.document.tasks import Task
from mechproof.ledger.judged import JudgedPaper
from mechproof.ledger.ledger_findings import list_findings
from mechproof.proof.verdict import Judgement, Left, Verdict
from mechproof.record import Equation, Paper, Row
from mechproof.record.estimates import without_estimates
from mechproof.record.statements import list_parts
from mechproof.sources.displays import EXPECTED
from mechproof.sources.located_text import Place
from mechproof.sources.paper_files import SUFFIXES, DocumentError, is_file, read_source

# Advice for a caller who passes an equation where a file name belongs.
_PASTED = "to judge an equation, use mechproof.judge_equation"


@dataclass(frozen=True)
class CheckedPaper:
    """The rows of a paper's source, the letters assumed to be real, and the files not found.

    `paper` has the letters, without rows. `told` lists names that cannot be read, and tables and
    columns that are not compared. `names` lists the names of all equations in order.
    """

    file: str
    rows: tuple[CheckedRow, ...]
    paper: Paper
    taken: tuple[str, ...] = ()
    missing: tuple[tuple[Place, str], ...] = ()
    told: tuple[tuple[Place, str], ...] = ()
    names: tuple[str, ...] = ()

    def to_ledger(self, system: str = "") -> JudgedPaper:
        """Return the ledger of the paper; places distinguish rows with the same name.

        `system` is the name of the paper, by default that of its file.
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
            rows=tuple(_state(row) for row in rows),
        )
        return JudgedPaper(
            paper.system,
            paper.reference,
            judged,
            findings=list_findings(paper, judged),
            left=tuple(row.leave() for row in rows if not row.judgement),
            paper=paper,
        )


def _state(row: CheckedRow) -> Row:
    """Return the printed row, which states nothing if it could not be read."""
    return replace(row.stated or Equation("", row.latex), number=row.name)


def check(
    path: str | Path,
    content: str | None = None,
    *,
    limit: float = LIMIT,
    report: Callable[[str], None] = lambda text: None,
) -> CheckedPaper:
    """Read a paper's source and judge what it asserts.

    `path` names a LaTeX or Markdown file; `content`, if given, is its text, and no file is read. A
    row that takes longer than `limit` seconds is not judged, and its reason says so. `report` is
    called with progress messages.
    Raises `DocumentError` if the file cannot be read or has no equation, `ValueError` (including
    `BlockError`) if a block of letters cannot be read, and `TypeError` for other types.
    """
    allowed = "must be the name of a file"
    require(isinstance(path, str | Path), "path", path, allowed, TypeError)
    if content is not None:
        check_text("content", content)
    elif not str(path).endswith(SUFFIXES) and not is_file(str(path)):
        raise DocumentError(f"{path}: there is no such file; {_PASTED}")
    require(check_number("limit", limit) > 0, "limit", limit, "must be positive")
    check_function("report", report)
    paper = _check((str(path), content, frozenset()), limit, report)
    if not paper.rows:
        told = "".join(f"; {place}: {reason}" for place, reason in (*paper.missing, *paper.told))
        raise DocumentError(f"{path}: there is no equation to judge: {EXPECTED}{told}")
    return paper


def check_rest(
    path: Path, rows: Iterable[Row], limit: float, report: Callable[[str], None]
) -> CheckedPaper:
    """Judge, as `check` does, the equations of a paper's source that are not among `rows`."""
    elsewhere = frozenset(
        (text, len([*list_parts(row.says)]) if row.says else 1)
        for row in rows
        for text in (row.number, row.printed_latex)
    )
    return _check((str(path), None, elsewhere), limit, report)


@without_estimates()
def _check(key: Key, limit: float, report: Callable[[str], None]) -> CheckedPaper:
    path, content, elsewhere = key
    source = read_source(path, content)
    document = Document(source)
    found = tuple(leave_out(document.read(limit), elsewhere))
    tasks = [one for one in found if isinstance(one, Task)]
    report(f"judging {len(tasks)} rows")
    opened[key] = tasks
    try:
        rows: dict[int, CheckedRow] = {}
        at = Judging(key, tasks, rows, document.symbols, limit)
        answers = at.ask(judge_row, [(n,) for n in range(len(tasks))])
        rows |= {n: make_row(tasks[n], answer) for (n,), answer in answers}
        for change in (
            *(_compare_members, follow_from_constraints, compare_rates, compare_restated),
            *(excuse_by_constraints, support_steps, _compare_specially, solve_constraints),
        ):
            rows |= dict(change(at))
        misprints = dict(find_misprints(at))
        rows |= dict(_leave_open(at))
        rows |= misprints
        for doubt in (
            *(doubt_by_proved, doubt_by_indices, doubt_by_decimals, doubt_by_rounded),
            *(
                doubt_by_rates,
                doubt_by_factors,
                doubt_by_lengths,
                doubt_by_frames,
                doubt_conditions,
            ),
        ):
            rows |= dict(doubt(at))
        unlike = dict(find_other_solutions(at))
        unlike |= dict(find_roots(at))
        rows |= unlike
        rows |= dict(doubt_by_premises(at))
        contested = {**misprints, **unlike, **dict(find_contradictions(at))}
        rows |= contested
        rows |= dict(compare_newer_prints(at, contested))
        placed = dict(compare_at_places(at))
        placed = {n: row for n, row in placed.items() if n not in contested}
        rows |= placed
        rows |= dict(doubt_by_letters(at, contested))
        rows |= dict(doubt_by_positions(at))
        rows |= dict(doubt_by_unread(at, found))
        rows |= dict(doubt_by_cases(at))
        rows |= {n: row for n, row in doubt_by_ties(at) if n not in placed}
        for doubt in (doubt_by_motion, doubt_by_stillness, doubt_by_examples, doubt_by_restated):
            rows |= dict(doubt(at))
        rows |= dict(doubt_by_matrices(at, document.find_possible_matrices()))
    finally:
        del opened[key]
    judged = iter(rows[number] for number in range(len(tasks)))
    shown = tuple(show_left(one) if isinstance(one, Left) else next(judged) for one in found)
    paper = document.papers[True]
    missing, told = tuple(source.missing), tuple(document.told)
    names = tuple(dict.fromkeys(printed.name for printed in document.printed))
    return CheckedPaper(path, shown, paper, document.taken, missing, told, names)


def _leave_open(at: Judging) -> Changes:
    """Leave a row open that was compared with another print whose letters differ.

    Likewise leave open a row that does not hold and may be an identity or a constraint, since both
    sides have the same letters.
    """
    for number, task in enumerate(at.tasks):
        found = at.rows[number].judgement
        if not found or found.rung != GIVEN or task.is_given:
            continue
        if task.sign.role in COMPARED:
            is_said = UNLIKE in found.reason or ROOT in found.reason
            yield number, make_row(task, found.reason if is_said else describe_unlike(task))
        elif task.is_indexed:
            yield number, make_row(task, "it was not shown that the bracket has this value there")
        elif task.is_either:
            yield number, make_row(task, EITHER)


def _compare_members(at: Judging) -> Changes:
    """Judge later values printed for a letter by all agreeing members of its first chain."""
    asked = []
    for n, task in enumerate(at.tasks):
        if not task.others or task.follows:
            continue
        standing = list_standing(task, at.tasks, at.rows)
        is_proved = at.rows[n].outcome == Verdict.PROVED.value
        if not (is_proved and task.sign.first in standing[0]):
            asked.append((n, standing))
    for (n, _), answer in at.ask(judge_members, asked):
        yield n, make_row(at.tasks[n], answer)


def _compare_specially(at: Judging) -> Changes:
    """Judge rows that are not proved in general again, at the values stated in the nearby text.

    "With the ring held ($n_3=0$) the ratio is" states such a value. A row that is false there, too,
    is refuted if both sides then have the same letters, as identities have.
    """
    kinds = ("special", "case")
    asked = [
        (n, x) for n, task in enumerate(at.tasks) for x in kinds if _is_special(task, x, at, n)
    ]
    for (n, kind), answer in at.ask(judge_special, asked):
        task = at.tasks[n]
        if not isinstance(answer, Judgement):
            continue
        is_misprint = answer.verdict is Verdict.REFUTED and kind == "special"
        is_misprint = is_misprint and task.special is not None and task.special.asserts
        if answer.verdict is Verdict.PROVED or (is_misprint and task.sign.role in COMPARED):
            yield n, make_row(task, answer)


def _is_special(task: Task, kind: str, at: Judging, number: int) -> bool:
    """Return whether a row is open and reads differently at the values stated beside it."""
    row, special = at.rows[number], task.special if kind == "special" else task.case
    verdicts = (Verdict.REFUTED, Verdict.UNDECIDED, Verdict.ENCLOSED)
    is_open = row.judgement and (row.judgement.rung == GIVEN or row.outcome in verdicts)
    # A row that may be another case of a definition may be the case that the words state.
    is_open = is_open or task.is_solution
    return bool(is_open) and special is not None and special.row.says != task.row.says
