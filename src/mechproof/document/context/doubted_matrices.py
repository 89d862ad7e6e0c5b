"""Verdicts of what may be matrices, and of matrices with rounded decimals.

Letters that nobody declared and that may be matrices commute if they are taken as numbers, and have
no other inverse than one over them.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from mechproof.document.checked_rows import make_row
from mechproof.document.context.doubts import ROUNDING, defines, list_compared, list_used
from mechproof.document.judged_tasks import Changes, Judging
from mechproof.document.row_sides import write_out
from mechproof.document.tasks import Task
from mechproof.proof.verdict import Verdict
from mechproof.record import Equality
from mechproof.statement_domains.domain import Domain


def doubt_by_matrices(at: Judging, shown: Mapping[sp.Basic, str]) -> Changes:
    """Neither prove nor refute what rests on letters that are `shown` as matrices are."""
    for n, task in enumerate(at.tasks):
        outcome = at.rows[n].outcome
        if outcome not in (Verdict.PROVED.value, Verdict.REFUTED.value) or not shown:
            continue
        named = (one for one in at.tasks if one is task or one.row.number in at.rows[n].reason)
        letters = set[sp.Basic]().union(*(list_compared(one, at.tasks) for one in named))
        if met := sorted(letters & shown.keys(), key=str):
            holds = "it holds" if outcome == Verdict.PROVED.value else "it differs"
            yield n, make_row(task, f"{holds} if {met[0]} is a number: {_ask(met[0], shown)}")


def _ask(letter: sp.Basic, shown: Mapping[sp.Basic, str]) -> str:
    asked = f"is it a matrix, as {shown[letter]} looks?"
    return (
        f"{asked} Say in the block of letters what it is, {letter} 3x3 : its meaning, or "
        f"{letter} : number"
    )


def doubt_by_rounded(at: Judging) -> Changes:
    """Accuse no matrix that differs little from what letters with rounded decimals give."""
    rounded = [one for one in at.tasks if one.is_rounded or one.sign.is_calculated]
    for n, task in enumerate(at.tasks):
        if at.rows[n].outcome != Verdict.REFUTED.value or not rounded:
            continue
        used = list_used(task, at.tasks)
        names = [one.row.number for one in rounded if one is not task and defines(one, used)]
        if names and _differ_little(task):
            reason = f"it differs by no more than the decimals of {', '.join(names)} may explain"
            yield n, make_row(task, reason)


def _differ_little(task: Task) -> bool:
    """Return whether the factors in what differs are small beside those of what is compared."""
    says = task.row.says
    if not isinstance(says, Equality):
        return False
    domain = Domain.of(task.paper, task.row.on)
    one, other = (write_out(domain.resolve(side)) for side in (says.printed, says.rebuilt))
    if not all(isinstance(x, sp.MatrixBase) for x in (one, other)) or one.shape != other.shape:
        return False
    return bool(_find_largest(one - other) < ROUNDING * _find_largest(other))


def _find_largest(matrix: sp.MatrixBase) -> Any:
    """Return the largest factor of a term of an entry."""
    terms = (sp.expand(entry).as_coefficients_dict() for entry in matrix)
    return max((abs(factor) for one in terms for factor in one.values()), default=0)
