"""Odd prints: none ends a run, none has a reason that only a programmer understands."""

from __future__ import annotations

import pytest

from mechproof.document import source_rows
from mechproof.document.checked_rows import UNFORESEEN
from mechproof.document.checking import check

pytestmark = pytest.mark.usefixtures("judged_here")

LETTERS = r"""%% mechproof
%% x ; y ; a : numbers
%% \mathbf{v} 3x1 : vector
%% n : count
%% natural n
%% w_i (i) : weights
%% end
"""
ODD = {
    r"\sum_{i=5}^{1}i=0": "a sum from 5 to 1 is not worked out",
    r"\lfloor x\rfloor=\lceil x\rceil": "a misprint, or a constraint?",
    r"\int_0^x\int_0^ya\,da\,dy=1": "an integral of an integral cannot be enclosed",
    r"\max_x\mathbf{v}=1": "values of letters cannot be substituted",
    r"\cos x\approx1": "an approximation",
}
# Elements whose index is another where n is.
TELESCOPES = [
    (r"\sum_{i=1}^n(w_{i+1}-w_i)=w_{n+1}-w_1", "PROVED"),
    (r"\sum_{i=1}^n(w_{i+1}^2-w_i^2)=w_{n+1}^2-w_1^2", "PROVED"),
    (r"\sum_{i=1}^n(w_{i+1}-w_i)=w_n-w_1", "DEFINITION"),
    (r"[\mathbf{v}]_\times^T=-[\mathbf{v}]_\times", "PROVED"),
    (r"[\mathbf{v}]_\times^T=[\mathbf{v}]_\times", "not judged"),
]


def judge(*prints: str) -> list[tuple[str, str]]:
    text = LETTERS + "".join(f"$${x}$$" for x in prints)
    return [(row.outcome, row.reason) for row in check("paper.tex", text).rows]


@pytest.mark.parametrize(("latex", "told"), ODD.items())
def test_a_reason_is_plain(latex: str, told: str) -> None:
    ((outcome, reason),) = judge(latex)
    assert outcome in ("not judged", "UNDECIDED")
    assert told in reason


@pytest.mark.parametrize(("latex", "outcome"), TELESCOPES)
def test_an_index_counts(latex: str, outcome: str) -> None:
    assert judge(latex)[0][0] == outcome


def test_a_print_that_lacks_a_part_gives_no_letter_a_value() -> None:
    rows = judge(r"x=\text{max}", "y=2x", "y=(x+1)^2-x^2-1", "y=3x")
    assert [outcome for outcome, _ in rows] == ["ILL_FORMED", "DEFINITION", "PROVED", "REFUTED"]


def test_an_error_that_nobody_foresaw_leaves_its_row_open(monkeypatch: pytest.MonkeyPatch) -> None:
    make = source_rows.TaskMaker.make

    def fail(self: object, printed: source_rows.Printed, *more: object) -> object:
        if "a" in printed.latex.string:
            raise KeyError("a")
        return make(self, printed, *more)  # type: ignore[arg-type]

    monkeypatch.setattr(source_rows.TaskMaker, "make", fail)
    first, second = judge("y=2x", "a=2x")
    assert (first[0], second) == ("DEFINITION", ("not judged", f"{UNFORESEEN} (KeyError)"))
