"""A factor of a print is judged even if another print makes the other factor zero."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import pytest
from derived import paper_of

from mechproof.latex import Reader
from mechproof.latex.expansion import read_row
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Verdict
from mechproof.record import Equation, Paper

COORDINATES = dict(zip(("(9)", "(10)", "(11)"), (1, 2, 3), strict=True))
CHANGES = (
    *(("x_{0N}", "y_{0N}"), ("y_{0N}", "z_{0N}"), ("z_{0N}", "z_{1N}")),
    *(("-a", "+a"), ("-b", "+b"), ("-c", "+c"), ("-a", "-b"), ("-c", "-b")),
)


@lru_cache
def load() -> Paper:
    return paper_of("track_wheel")


def judge_changed(row: Equation, old: str, new: str) -> Verdict:
    """Judge the first sign of a print with one thing changed, after it was accepted unchanged."""
    reader = Reader(load().variables, load().notation)
    prints = (row.printed_latex, row.printed_latex.replace(old, new, 1))
    assert prints[0] != prints[1]
    signs = [read_row(replace(row, printed_latex=latex), reader)[0] for latex in prints]
    right, changed = (judge(sign, load()).verdict for sign in signs)
    assert right in (Verdict.PROVED, Verdict.DEFINITION)
    return changed


def unread(number: str) -> Equation:
    """Return a row of the paper as declared, with its print unread."""
    from mechproof.derivations.track_wheel.rows.equations import FRAME_ROWS

    load()
    (row,) = (row for row in FRAME_ROWS if row.number == number)
    assert isinstance(row, Equation)
    return row


@pytest.mark.slow
@pytest.mark.parametrize("number", COORDINATES)
def test_no_element_that_is_zero_hides_a_factor(number: str) -> None:
    row = COORDINATES[number]
    elements = [(f"a_{{{row}{k}}}", f"a_{{{row % 3 + 1}{k}}}") for k in (1, 2, 3)]
    verdicts = {change: judge_changed(unread(number), *change) for change in (*CHANGES, *elements)}
    assert set(verdicts.values()) <= {Verdict.REFUTED, Verdict.ILL_FORMED}, verdicts


@pytest.mark.parametrize("change", [("a_{12}", "a_{13}"), ("a_{22}", "a_{33}")])
def test_elements_of_equal_value_are_not_taken_for_each_other(change: tuple[str, str]) -> None:
    assert judge_changed(unread("(8)"), *change) is Verdict.REFUTED
