"""Dimensions of rows in which some letters have no unit: parts with units are judged alone."""

from __future__ import annotations

import pytest

from mechproof.document.checking import check

pytestmark = pytest.mark.usefixtures("judged_here")

BLOCK = r"""%% mechproof
%% r; l : lengths [mm]
%% x : length [mm]
%% t : time [s]
%% \omega : speed [rad/s]
%% \varphi : angle [rad]
%% n : exponent
%% y; c : numbers
%% end
"""
MIXED = [
    "y=r+l^2",
    r"y=\sin r",
    r"y=c+\frac{r-l}t+r",
    r"y=c\,\sin r",
    r"y=l\omega t+\sin\frac rl+c",
    "c+r+l^2=y",
]
# Numbers may have units that are not printed, and bound letters may have those of others.
OTHER = [
    "y=r+l",
    "y=r+cl^2",
    "y=5t+2t^2",
    r"y=\sin2t",
    r"y=\ln r-\ln l",
    r"y=\cos(\varphi+\omega t)+\varphi",
    r"y=\sqrt{r^2+4}",
    r"y=\int_0^{\varphi}\sin t\,dt",
    r"y=r^n+l",
]


@pytest.mark.parametrize("latex", MIXED)
def test_a_part_whose_letters_all_have_units_is_judged_by_itself(latex: str) -> None:
    (row,) = check("paper.tex", f"{BLOCK}\\begin{{equation}}{latex}\\end{{equation}}").rows
    assert row.outcome == "ILL_FORMED"


@pytest.mark.parametrize("latex", OTHER)
def test_what_may_fit_is_not_accused_and_said_not_to_be_compared(latex: str) -> None:
    (row,) = check("paper.tex", f"{BLOCK}\\begin{{equation}}{latex}\\end{{equation}}").rows
    assert row.outcome == "DEFINITION"
    assert "bound symbols agree; dimensions are not compared: " in row.reason


def test_what_is_compared_says_so() -> None:
    (row,) = check("paper.tex", f"{BLOCK}\\begin{{equation}}x=r+l\\end{{equation}}").rows
    assert "dimensions and bound symbols agree" in row.reason
