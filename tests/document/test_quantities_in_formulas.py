"""Numbers with units next to letters: quantities, whatever units the letters are declared in."""

from __future__ import annotations

import pytest

from mechproof.document.checking import check

BLOCK = r"""%% mechproof
%% m : mass [kg]
%% F : force [N]
%% A : area [mm^2]
%% \sigma : stress [MPa]
%% \epsilon : strain [1]
%% s : path [mm]
%% v : speed [m/s]
%% t : time [s]
%% k : anything
%% end
"""
G = r"9.81\,\mathrm{m/s^2}"
ROWS = {
    rf"F=m\cdot{G}=\frac{{m}}{{2}}\cdot19.62\,\frac{{\mathrm m}}{{\mathrm s^2}}": "PROVED",
    rf"F=m\cdot{G}=\frac m2\cdot19.64\,\mathrm{{m/s^2}}": "not judged",
    r"F=m\cdot10\,\mathrm{m/s^2}=\frac m2\cdot21\,\mathrm{m/s^2}": "REFUTED",
    rf"F=m\cdot{G}=m\cdot9810\,\mathrm{{mm/s^2}}": "PROVED",
    rf"\frac F{{{G}}}=\frac F{{981\,\mathrm{{cm/s^2}}}}": "PROVED",
    r"s=5\,\mathrm{mm}+vt=vt+0.5\,\mathrm{cm}": "PROVED",
    r"s=5\,\mathrm{mm}+vt=vt+5\,\mathrm{cm}": "REFUTED",
    r"\sigma=210\,\mathrm{GPa}\cdot\epsilon=\epsilon\cdot2.1\cdot10^5\,\frac{\mathrm N}"
    r"{\mathrm{mm}^2}": "PROVED",
    r"(\epsilon^2+1)\cdot5\,\mathrm{GPa}\ge5000\,\mathrm{MPa}": "PROVED",
    r"(\epsilon^2+1)\cdot5\,\mathrm{GPa}<4\,\mathrm{GPa}": "REFUTED",
    # Sums and comparisons of different dimensions.
    r"s=vt+5\,\mathrm{mm}=v+5\,\mathrm{mm}": "ILL_FORMED",
    r"F=m\cdot10\,\mathrm{m/s^2}=m+10\,\mathrm{m/s^2}": "ILL_FORMED",
    r"(\epsilon^2+1)\cdot5\,\mathrm{GPa}\ge5000\,\mathrm{mm}": "not judged",
    # A letter without a unit may be in any; degrees Celsius have a zero of their own.
    r"k=m\cdot5\,\mathrm{mm}=5m\,\mathrm{mm}": "not read",
    r"t=v\cdot20\,^\circ\mathrm C": "not read",
}
# Equations with numbers, after words that state the sizes.
CALCULATED = {
    rf"F=m\cdot{G}=98.1\,\mathrm N": "PROVED",
    rf"F=m\cdot{G}=0.0981\,\mathrm{{kN}}": "PROVED",
    rf"\sigma=\frac{{m\cdot{G}}}A=1.962\,\mathrm{{MPa}}": "PROVED",
    rf"F=m\cdot{G}=981\,\mathrm N": "not judged",
    rf"\sigma=\frac{{m\cdot{G}}}A=1.962\,\mathrm{{Pa}}": "not judged",
}


def judge_last(words: str, latex: str) -> str:
    content = f"{BLOCK}{words}\n\\begin{{equation}}{latex}\\end{{equation}}\n"
    return check("paper.tex", content).rows[-1].outcome


@pytest.mark.parametrize("latex", ROWS)
def test_a_number_with_a_unit_beside_letters_is_a_quantity(latex: str) -> None:
    assert judge_last("", latex) == ROWS[latex]


@pytest.mark.parametrize("latex", CALCULATED)
def test_a_quantity_in_a_formula_is_worked_out_at_sizes(latex: str) -> None:
    words = r"For $m=10\,\mathrm{kg}$ and $A=50\,\mathrm{mm^2}$ we get"
    assert judge_last(words, latex) == CALCULATED[latex]
