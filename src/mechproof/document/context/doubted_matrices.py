"""Verdicts that rest on letters that nobody declared and that may be matrices.

Taken as numbers, they commute and have no other inverse than one over them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import sympy as sp

from mechproof.document.checked_rows import CheckedRow, make_row
from mechproof.document.context.doubts import list_compared
from mechproof.document.tasks import Task
from mechproof.proof.verdict import Verdict


def doubt_by_matrices(
    tasks: Sequence[Task], rows: Mapping[int, CheckedRow], shown: Mapping[sp.Basic, str]
) -> Iterator[tuple[int, CheckedRow]]:
    """Neither prove nor refute what rests on letters that are `shown` as matrices are."""
    for n, task in enumerate(tasks):
        outcome = rows[n].outcome
        if outcome not in (Verdict.PROVED.value, Verdict.REFUTED.value) or not shown:
            continue
        named = (one for one in tasks if one is task or one.row.number in rows[n].reason)
        letters = set[sp.Basic]().union(*(list_compared(one, tasks) for one in named))
        if met := sorted(letters & shown.keys(), key=str):
            holds = "it holds" if outcome == Verdict.PROVED.value else "it differs"
            yield n, make_row(task, f"{holds} if {met[0]} is a number: {_ask(met[0], shown)}")


def _ask(letter: sp.Basic, shown: Mapping[sp.Basic, str]) -> str:
    asked = f"is it a matrix, as {shown[letter]} looks?"
    return (
        f"{asked} Say in the block of letters what it is, {letter} 3x3 : its meaning, or "
        f"{letter} : number"
    )
