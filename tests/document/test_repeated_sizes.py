"""Sizes printed again: a difference that no words explain is left open."""

from __future__ import annotations

import pytest
from small_papers import judge_parts, judge_rows

pytestmark = pytest.mark.usefixtures("judged_here")

BLOCK = r"""%% mechproof
%% k ; n : numbers
%% d : diameter [mm]
%% \varphi(t) : angle [rad]
%% x(\alpha) : lift
%% \alpha : angle
%% end
"""
D, OPEN = "DEFINITION", "not judged"
FIRST = "k=1.2345"
CASES = {
    "the same number, or fewer places of it": ([FIRST, FIRST, "k=1.23,", r"k\approx1.2"], [D] * 4),
    "another number": ([FIRST, "#Hence", "k=1.24"], [D, OPEN]),
    "another one than that before the last": (["k=1.2", "k=1.24", "k=1.21"], [D, D, OPEN]),
    "in another unit": (
        [r"d=12\,\mathrm{mm}", r"d=1.2\,\mathrm{cm}", r"d=1.3\,\mathrm{cm}"],
        [D, D, OPEN],
    ),
    "a number without a unit beside one with it": ([r"d=12\,\mathrm{mm}", "d=1.3"], [D, D]),
    "words that say something new": ([FIRST, "#A larger screw has", "k=1.24"], [D, D]),
    "a sentence that says its size": ([FIRST, "#With $k=1.24$ we have", "k=1.24"], [D, D]),
    "a case behind it": ([r"k=1.2\quad(n=3)", "k=1.3"], [D, D]),
    "a special position": (["k=0", "k=1.3"], [D, D]),
    "what moves": ([r"\varphi=30^\circ", r"\varphi=60^\circ"], [D, D]),
    "what runs": ([r"\alpha=30^\circ", r"\alpha=60^\circ"], [D, D]),
}


@pytest.mark.parametrize("name", CASES)
def test_sizes_are_compared_with_those_before(name: str) -> None:
    parts, outcomes = CASES[name]
    assert judge_parts(BLOCK, *parts) == outcomes


def test_solutions_of_one_display_are_no_other_prints() -> None:
    rows = judge_rows(BLOCK, r"\begin{aligned}k&=1.5\\k&=-2.5\end{aligned}")
    assert {row.outcome for row in rows} == {D}


def test_the_answer_names_the_first_print() -> None:
    *_, row = judge_rows(BLOCK, FIRST, "k=1.24")
    assert row.reason == "k=1.2345 is printed in (1): another case, or a misprint?"
