"""The rows of a paper while they are judged, and what worker processes are asked of them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from mechproof.document.checked_rows import CheckedRow
from mechproof.document.judging_workers import Key, open_tasks
from mechproof.document.tasks import Task
from mechproof.nomenclature.symbols import Symbols
from mechproof.tools.processes import run_tasks

# Rows that have become others, by their numbers.
Changes = Iterator[tuple[int, CheckedRow]]


@dataclass(frozen=True)
class Judging:
    """The tasks of a paper, what has become of each so far, and the time that one may take."""

    key: Key
    tasks: list[Task]
    rows: dict[int, CheckedRow]
    symbols: Symbols
    limit: float

    def ask(
        self, judge: Callable[..., Any], asked: Sequence[tuple[Any, ...]]
    ) -> Iterator[tuple[tuple[Any, ...], Any]]:
        """Yield what is asked with each answer, a `WorkerError` for none, as they come.

        `judge` is a function of a module: it gets all tasks, and what is asked.
        """
        calls = [(self.key, judge, one) for one in asked]
        for place, answer in run_tasks(_answer, calls, limit=self.limit):
            yield asked[place], answer


def _answer(call: tuple[Key, Callable[..., Any], tuple[Any, ...]]) -> Any:
    key, judge, asked = call
    return judge(open_tasks(key), *asked)
