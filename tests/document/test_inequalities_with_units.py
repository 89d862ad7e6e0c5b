"""Inequalities with a unit: both sides are compared as numbers in the same unit."""

from __future__ import annotations

import pytest

from mechproof.document.checking import CheckedPaper, check

pytestmark = pytest.mark.usefixtures("judged_here")

BLOCK = r"""%% mechproof
%% F : force [kN] {0<F<3}
%% A : area [mm^2]
%% \sigma : stress [MPa]
%% n : speed [rpm]
%% \omega : angular velocity [rad/s] {0<\omega<100}
%% \alpha : angle [deg] {0<\alpha<1}
%% T : temperature [°C] {0<T<50}
%% k : a letter without unit
%% \eta : efficiency [%] {0<\eta<90}
%% P : power [kW]
%% M : torque [N m]
"""


def run(*equations: str, sizes: str = "") -> CheckedPaper:
    lines = "".join(f"\\begin{{equation}}{latex}\\end{{equation}}\n" for latex in equations)
    return check("paper.tex", f"{BLOCK}{sizes}%% end\n{lines}")


def outcomes(*equations: str, sizes: str = "") -> list[str]:
    return [row.outcome for row in run(*equations, sizes=sizes).rows]


# Inequalities within the ranges of the block: true, false, or true for some values only.
LIMITS = {
    r"F<4000\,\mathrm{N}": "PROVED",
    r"4\,\mathrm{kN}>F": "PROVED",
    r"F<2000\,\mathrm{N}": "DEFINITION",
    r"F>4000\,\mathrm{N}": "REFUTED",
    r"-1\,\mathrm{kN}<F": "PROVED",
    r"2F<6.1\,\mathrm{kN}": "PROVED",
    r"\omega<1000\,\mathrm{min^{-1}}": "PROVED",
    r"\omega<900\,\mathrm{min^{-1}}": "DEFINITION",
    r"\omega>\SI{1000}{rpm}": "REFUTED",
    r"\alpha<1.1\,\mathrm{rad}": "PROVED",
    r"\eta\le90\,\%": "PROVED",
    r"T<50\,^\circ\mathrm{C}": "PROVED",
    r"5\,\mathrm{kN}>4000\,\mathrm{N}": "PROVED",
    r"5\,\mathrm{kN}>6000\,\mathrm{N}": "REFUTED",
    r"\frac{500\,\mathrm{N}}{10\,\mathrm{mm^2}}\le 60\,\mathrm{MPa}": "PROVED",
    r"\frac{500\,\mathrm{N}}{10\,\mathrm{mm^2}}\le 40\,\mathrm{MPa}": "REFUTED",
}


@pytest.mark.parametrize(("latex", "outcome"), LIMITS.items())
def test_both_sides_are_numbers_in_one_unit(latex: str, outcome: str) -> None:
    assert outcomes(latex) == [outcome]


# Inequalities that are left open, and why.
OPEN = {
    r"T<353\,\mathrm{K}": "different zero points",
    r"k<5\,\mathrm{mm}": "none is declared for k",
    r"F<5\,\mathrm{mm}": "dimension",
    r"n<50\,\mathrm{s^{-1}}": "turns, or radians?",
    r"F+A<5\,\mathrm{mm}": "is not known",
}


@pytest.mark.parametrize(("latex", "reason"), OPEN.items())
def test_what_other_units_would_say_is_left_open(latex: str, reason: str) -> None:
    (row,) = run(latex).rows
    assert row.outcome == "not judged"
    assert reason in row.reason


def test_a_letter_is_as_large_as_the_formula_that_gives_it() -> None:
    # F/A is a number in kN/mm^2.
    sizes = "%% sizes F=2, A=100\n"
    right = outcomes(r"\sigma=\frac FA", r"\sigma<30001\,\frac{\mathrm{N}}{\mathrm{mm^2}}")
    assert right[1] == "DEFINITION"
    chain = r"\sigma=\frac{F}{A}=20\,\mathrm{MPa}\le 160\,\mathrm{MPa}"
    assert outcomes(chain, sizes=sizes)[2] == "PROVED"
    wrong = r"\sigma=\frac{F}{A}=20\,\mathrm{MPa}\ge 160\,\mathrm{MPa}"
    assert outcomes(wrong, sizes=sizes)[2] == "REFUTED"
    # The unit of a formula that converts units itself is not known.
    assert outcomes(r"P=\frac{Mn}{9550}", r"P<5\,\mathrm{kW}")[1] == "not judged"
