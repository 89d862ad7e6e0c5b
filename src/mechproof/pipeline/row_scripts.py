"""Row scripts: in, papers with their verdicts; out, what Coq is given of each row.

They are written on all processors, where those share memory.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path

from mechproof.coq.folder import CERTIFIABLE, RowScript, withhold, write_row_script
from mechproof.document.constraints.consequences import FOLLOWING
from mechproof.ledger.judged import JudgedPaper
from mechproof.pipeline.opening import Opened, open_paper
from mechproof.proof.verdict import Judgement, Verdict
from mechproof.record import Row
from mechproof.tools.processes import START, WorkerError, run_tasks

# Seconds for the scripts of a row; beyond, something hangs.
LIMIT = 600.0
WITHOUT_ROW = "the print is judged, but the paper's module has no row of it"
BESIDE_OTHERS = "it follows from other equations, and scripts have one row each"
Task = tuple[int, int]
# What is at work, for the processes that are forked.
_opened: list[tuple[Opened, JudgedPaper]] = []


def write_row_scripts(
    ledgers: Mapping[Path, JudgedPaper], tell: Callable[[str], None] = lambda text: None
) -> list[RowScript]:
    """Write a script for every row that is certifiable, or say why not, in their order.

    Ledgers are by the places of their papers. Raises ValueError for a row at which it fails.
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
    """List the numbers of papers and of their tasks, in the order of the ledgers."""
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
