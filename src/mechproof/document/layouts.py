"""Matrices that are worked out entry by entry: inverses, products, derivatives by a vector.

Of such derivatives each row is of one entry, or in the other layout by one letter.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from mechproof.document.tasks import Task
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Verdict
from mechproof.record import Equality

TRANSPOSED = (
    "it holds with one side transposed: a misprint, or derivatives of which each row is by one "
    "letter?"
)


def gives_entries(sides: Sequence[Any], worked_out: Sequence[bool]) -> bool:
    r"""Return whether a matrix that is given by others has its entries printed, \mathbf J^{-1}=….

    That is meant wherever its letters lie, where a vector may tie some.
    """
    shown = [side.doit() if isinstance(side, sp.MatrixExpr) else side for side in sides]
    are_matrices = all(isinstance(side, sp.MatrixBase) and min(side.shape) > 1 for side in shown)
    return are_matrices and len(shown) > 1 and sum(worked_out) == 1


def holds_transposed(task: Task) -> bool:
    """Return whether a matrix of derivatives is printed in the other layout."""
    says = task.row.says
    if r"\partial" not in task.row.printed_latex or not isinstance(says, Equality):
        return False
    one, other = says.printed, says.rebuilt
    if not all(isinstance(side, sp.MatrixBase | sp.MatrixExpr) for side in (one, other)):
        return False
    turned = replace(task.row, says=Equality(one.T, other, "member"))
    return one.shape == other.shape[::-1] and judge(turned, task.paper).verdict is Verdict.PROVED
