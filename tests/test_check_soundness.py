"""Pasted statements that fail only where no point is tried, or by a rule's own gap; true twins."""

from __future__ import annotations

import pytest

from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

COUNT = r"n\in\mathbb N"
FROM_ONE = r"\sum_{k=1}^n|k-x|=|1-x|+\frac{n(n+1)}2-1-(n-1)x"
TO_HALVES = r"\sum_{k=1}^n\left|k-\frac72\right|=\frac{n(n+1)}2-\frac{7n}2+%d"
# The statement and what it is said under; first a true one, then one that is false somewhere.
PAIRS = {
    # A step from n to n + 1 must not rest on what ties other letters to n, or n to a part.
    "a letter far below n": ((FROM_ONE, (COUNT, "x<1")), (FROM_ONE, (COUNT, "x<n-100"))),
    "a letter below n": ((FROM_ONE, (COUNT, "x<1")), (FROM_ONE, (COUNT, "x<n"))),
    "later n": ((TO_HALVES % 9, (COUNT, r"n\ge4")), (TO_HALVES % 5, (COUNT, r"n\ge4"))),
    "n with a gap": ((TO_HALVES % 9, (COUNT, r"n\ge3")), (TO_HALVES % 5, (COUNT, "n(n-4)>-1"))),
}


def judge(latex: str, where: tuple[str, ...]) -> set[Verdict]:
    return {found.verdict for found in judge_pasted(Pasted(latex, where=where)).judgements}


@pytest.mark.parametrize("name", PAIRS)
def test_what_is_false_somewhere_is_not_proved_and_its_true_neighbour_is(name: str) -> None:
    true, false = PAIRS[name]
    assert judge(*true) == {Verdict.PROVED}
    assert Verdict.PROVED not in judge(*false)
