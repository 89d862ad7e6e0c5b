r"""Ranges below sums: \sum_{1\le i<j\le n}, \sum_{i,j=1}^n, and conditions of their indices."""

from __future__ import annotations

import pytest

from mechproof.latex import ReadingError
from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

# A sum, its value, and one that a slip in the range would give.
SUMS = [
    (r"\sum_{1\le i\le3}i", "6", "3"),
    (r"\sum_{1\le i<3}i", "3", "6"),
    (r"\sum_{0<i\le3}i", "6", "5"),
    (r"\sum_{1\le i<j\le3}ij", "11", "25"),
    (r"\sum_{1\le i\le j\le2}ij", "7", "2"),
    (r"\sum_{i,j=1}^2ij", "9", "5"),
    (r"\sum_{\substack{i,j=1\\i\ne j}}^2ij", "4", "9"),
    (r"\sum_{\substack{i,j=1\\j\ne i}}^2ij", "4", "9"),
    (r"\sum_{\substack{1\le i\le3\\i\ne2}}i", "4", "6"),
    (r"\sum_{\substack{i=1\\2\ne i\\i\ne3}}^4i", "5", "10"),
]
REFUSED = [
    r"\sum_{1\le i\le3}^4i=x",
    r"\sum_{1\le i}i=x",
    r"\sum_{i}i=x",
    r"\sum_{i,i=1}^2i=x",
    r"\sum_{\substack{i=1\\a\ne b}}^2i=x",
]


def judge(latex: str) -> Verdict:
    (found,) = judge_pasted(Pasted(latex)).judgements
    return found.verdict


@pytest.mark.parametrize(("latex", "value", "other"), SUMS)
def test_a_sum_goes_over_the_printed_range(latex: str, value: str, other: str) -> None:
    assert judge(f"{latex}={value}") is Verdict.PROVED
    assert judge(f"{latex}={other}") is Verdict.REFUTED


@pytest.mark.parametrize("latex", REFUSED)
def test_a_range_that_is_not_clear_is_refused(latex: str) -> None:
    with pytest.raises(ReadingError):
        judge(latex)
