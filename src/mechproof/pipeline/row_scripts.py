"""Row scripts: from papers to the Coq script of each row, in three stages.

1. Judge: every row of each paper gets a verdict.
2. Write: each certifiable row becomes a script, on all processors if processes can be forked.
3. Check: Coq runs the scripts, refused ones are removed, and the results can be recorded.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from mechproof.coq.checker import RECORD_LIMIT, CheckerError
from mechproof.coq.folder import (
    CERTIFIABLE,
    Coverage,
    RowScript,
    check_folder,
    keep_record,
    list_texts,
    read_known,
    read_refused,
    withhold,
    write_folder,
    write_row_script,
)
from mechproof.document.constraints.consequences import FOLLOWING
from mechproof.ledger.judged import JudgedPaper
from mechproof.pipeline import judging
from mechproof.pipeline.opening import Opened, open_paper
from mechproof.pipeline.verification import LIMIT
from mechproof.proof.verdict import Judgement, Verdict
from mechproof.record import Row
from mechproof.tools.made import ForeignFileError
from mechproof.tools.processes import START, WorkerError, run_tasks

WITHOUT_ROW = "the print is judged, but the paper's module has no row for it"
BESIDE_OTHERS = "it follows from other equations, but each script has one row"
Task = tuple[int, int]


@dataclass(frozen=True)
class Certified:
    """How many scripts of how many rows are written and left out, and Coq's results if checked.

    `lost` names scripts that a record has as accepted but Coq does not accept.
    """

    rows: int
    written: int
    left_out: int
    coverage: Coverage | None = None
    lost: tuple[str, ...] = ()


# The papers at work, for the processes that are forked.
_opened: list[tuple[Opened, JudgedPaper]] = []


def certify(
    locations: Sequence[Path],
    folder: Path,
    generated: Path,
    *,
    check: bool = False,
    record: bool = False,
    one_in: int = 1,
    use_cache: bool = True,
    limit: float = LIMIT,
    progress: judging.Progress = judging.report_nothing,
) -> Iterator[Certified]:
    """Write the scripts of papers into a folder; with `check` have Coq check one in `one_in`.

    If they are not checked, scripts that Coq refused according to the record in `generated` are
    left out. With `record`, scripts that the record has as accepted are not run again, and the
    record is updated. Yields the numbers once before and, with `check`, once after checking. Raises
    `PipelineError`.
    """
    ledgers = judging.judge_papers(locations, use_cache=use_cache, limit=limit, progress=progress)
    judging.refuse_failures(ledgers)
    known, refused = read_known(generated), read_refused(generated)
    with judging.name_faults(CheckerError, ForeignFileError, OSError, ValueError):
        with progress("writing scripts") as tell:
            scripts = write_row_scripts(dict(zip(locations, ledgers, strict=True)), tell)
        left = [
            one for one in scripts if not check and one.text and refused.get(one.id) == one.digest
        ]
        write_folder(folder, list_texts(one for one in scripts if one not in left))
        written = sum(bool(one.text) for one in scripts) - len(left)
        yield (done := Certified(len(scripts), written, len(left)))
        if not check:
            return
        with progress("running Coq") as tell:
            if record:
                coverage = check_folder(folder, scripts, tell, known=known, limit=RECORD_LIMIT)
            else:
                coverage = check_folder(folder, scripts, tell, one_in=one_in)
        if record:
            keep_record(generated, coverage)
        yield replace(
            done, coverage=coverage, lost=() if record else tuple(coverage.find_lost(known))
        )


def write_row_scripts(
    ledgers: Mapping[Path, JudgedPaper], tell: Callable[[str], None] = lambda text: None
) -> list[RowScript]:
    """Return, for each certifiable row in order, its script or the reason why there is none.

    `ledgers` are given by the places of their papers. Raises ValueError for a row that fails.
    """
    _opened[:] = [(open_paper(place, ledger.paper), ledger) for place, ledger in ledgers.items()]
    try:
        written = {script.id: script for script in _write(_list_tasks(), tell)}
    finally:
        _opened.clear()
    judged = (judgement for ledger in ledgers.values() for judgement in ledger.judgements)
    proved = (judgement for judgement in judged if judgement.verdict in CERTIFIABLE)
    return [written.get(one.id) or withhold(one, WITHOUT_ROW) for one in proved]


def _list_tasks() -> list[Task]:
    """Return the numbers of papers and of their tasks, in the order of the ledgers."""
    counts = enumerate(len(opened.tasks) for opened, _ in _opened)
    return [(place, task) for place, count in counts for task in range(count)]


def _write(tasks: Sequence[Task], tell: Callable[[str], None]) -> Iterator[RowScript]:
    for number, result in _run(tasks):
        place, task = tasks[number]
        name = f"{_opened[place][0].paper.system}: {_opened[place][0].tasks[task]}"
        if isinstance(result, WorkerError):
            raise ValueError(f"{name}: {result}") from result
        tell(name)
        yield from result


def _run(tasks: Sequence[Task]) -> Iterator[tuple[int, tuple[RowScript, ...] | WorkerError]]:
    if START == "fork":
        return run_tasks(_write_task, tasks, limit=LIMIT)
    return enumerate(map(_write_task, tasks))


def _write_task(task: Task) -> tuple[RowScript, ...]:
    opened, ledger = _opened[task[0]]
    judged = {j.number: j for j in ledger.judgements if j.verdict in CERTIFIABLE}
    rows = [row for row in opened.state(task[1]) if row.number in judged and row.says]
    return tuple(_write_row(judged[row.number], row, ledger) for row in rows)


def _write_row(judgement: Judgement, row: Row, ledger: JudgedPaper) -> RowScript:
    if judgement.rung in FOLLOWING and judgement.verdict is Verdict.PROVED:
        return withhold(judgement, BESIDE_OTHERS)
    return write_row_script(judgement, row, ledger)
