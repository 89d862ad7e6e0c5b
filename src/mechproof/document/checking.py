"""A paper's source -> its rows, judged where they assert something; no row can end the run."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from pathlib import Path

from mechproof.arguments.scalars import check_function, check_number, check_text, require
from mechproof.document.checked_rows import CheckedRow, list_standing, make_row, show_left
from mechproof.document.constraints.consequences import GIVEN, ROOT
from mechproof.document.context import (
    accused_rows,
    constrained_rows,
    doubted_letters,
    doubts,
    newer_prints,
    restated_prints,
    undeclared_motion,
    values_at_places,
)
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
        matrices = document.find_possible_matrices()
        at = Judging(key, tasks, rows, document.symbols, limit, found, matrices)
        answers = at.ask(judge_row, [(n,) for n in range(len(tasks))])
        rows |= {n: make_row(tasks[n], answer) for (n,), answer in answers}
        for change in _CHANGES:
            rows |= dict(change(at))
    finally:
        del opened[key]
    judged = iter(rows[number] for number in range(len(tasks)))
    shown = tuple(show_left(one) if isinstance(one, Left) else next(judged) for one in found)
    paper = document.papers[True]
    missing, told = tuple(source.missing), tuple(document.told)
    names = tuple(dict.fromkeys(printed.name for printed in document.printed))
    return CheckedPaper(path, shown, paper, document.taken, missing, told, names)


def _accuse(at: Judging) -> Changes:
    """Find the misprints before rows are left open, and keep them."""
    misprints = dict(accused_rows.find_misprints(at))
    yield from _leave_open(at)
    yield from misprints.items()
    at.contested.update(misprints)


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
            reason = found.reason if is_said else restated_prints.describe_unlike(task)
            yield number, make_row(task, reason)
        elif task.is_indexed:
            yield number, make_row(task, "it was not shown that the bracket has this value there")
        elif task.is_either:
            yield number, make_row(task, doubted_letters.EITHER)


def _find_unlike(at: Judging) -> Changes:
    """Leave open prints that may be other solutions, or other roots."""
    unlike = dict(doubts.find_other_solutions(at)) | dict(newer_prints.find_roots(at))
    at.contested.update(unlike)
    yield from unlike.items()


def _contest(at: Judging) -> Changes:
    """Leave open contradictions, and all that was contested before, whatever was found since."""
    at.contested.update(doubts.find_contradictions(at))
    yield from at.contested.items()


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


# The changes that are made, in this order, once every row has been judged by itself.
_CHANGES: tuple[Callable[[Judging], Changes], ...] = (
    *(_compare_members, constrained_rows.follow_from_constraints),
    *(restated_prints.compare_rates, restated_prints.compare_restated),
    *(constrained_rows.excuse_by_constraints, constrained_rows.support_steps),
    *(_compare_specially, constrained_rows.solve_constraints, _accuse),
    *(accused_rows.doubt_by_proved, doubts.doubt_by_indices, doubts.doubt_by_decimals),
    *(doubted_letters.doubt_by_rounded, doubts.doubt_by_rates, doubts.doubt_by_factors),
    *(doubted_letters.doubt_by_lengths, doubted_letters.doubt_by_frames),
    *(doubts.doubt_conditions, _find_unlike, constrained_rows.doubt_by_premises, _contest),
    *(newer_prints.compare_newer_prints, values_at_places.compare_at_places),
    *(doubted_letters.doubt_by_letters, doubts.doubt_by_positions, doubts.doubt_by_unread),
    *(newer_prints.doubt_by_cases, undeclared_motion.doubt_by_ties),
    *(undeclared_motion.doubt_by_motion, undeclared_motion.doubt_by_stillness),
    *(doubted_letters.doubt_by_examples, restated_prints.doubt_by_restated),
    doubted_letters.doubt_by_matrices,
)
