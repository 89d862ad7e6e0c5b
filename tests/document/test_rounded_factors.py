"""Decimals next to letters: a factor that was rounded is recomputed, others are left open."""

from __future__ import annotations

import pytest

from mechproof.document.checking import check

pytestmark = pytest.mark.usefixtures("judged_here")

BLOCK = r"""%% mechproof
%% a ; b ; c ; d : lengths [mm] {a>0, b>0}
%% \varphi : angle [rad]
%% end
"""
DIAGONAL = r"\begin{equation}c=\sqrt2a\end{equation}"
HEIGHT = r"\begin{equation}b=\frac{\sqrt3}2a\end{equation}"
OPEN = "not judged"
# A print after the definitions, and its outcome.
PRINTS = {
    "two digits": ("c=1.41a", "PROVED"),
    "three digits, turned around": (r"1.414\,a=c", "PROVED"),
    "a comma": ("c=1{,}414a", "PROVED"),
    "a sign": ("-c=-1.41a", "PROVED"),
    "a wrong digit": ("c=1.42a", OPEN),
    "a wrong digit behind a decimal that is right": ("c=1.4143a", OPEN),
    "a step": (r"d=\frac{\sqrt5}2a=1.12a", "PROVED"),
    "a wrong step": (r"d=\frac{\sqrt5}2a=1.21a", "REFUTED"),
    "of letters that cancel": (r"\frac cb=1.63", "PROVED"),
    "a wrong one of letters that cancel": (r"\frac cb=1.64", "REFUTED"),
    "two decimals": (r"c=1.41\cdot1.0a", OPEN),
    "of what has letters left": (r"c=1.41a\cos\varphi", OPEN),
    "no factor, but an exponent": (
        r"d=\frac{\sqrt{13}}7\sqrt a\sqrt b=\frac12a^{0.5}\sqrt b",
        OPEN,
    ),
    "no factor, but in a sum": (r"d=\frac{\sqrt{13}}7a=\frac12a+0.5(a-a)", OPEN),
    "an approximation": (r"d=\frac{\sqrt5}2a\approx1.12a", "PROVED"),
    "a wrong approximation": (r"d=\frac{\sqrt5}2a\approx1.21a", "REFUTED"),
    "an approximation that is off by its last digit": (r"d=\frac{\sqrt5}2a\approx1.11a", OPEN),
    "an approximation of a letter": (r"c\approx1.41a", "PROVED"),
    "a wrong approximation of a letter": (r"c\approx1.14a", "REFUTED"),
    "an approximation of a new letter": (r"d\approx1.12a", OPEN),
    "an approximation that drops something": (r"d=a+b\cos\varphi\approx1.9a", OPEN),
    "an approximation of what was rounded": (r"d=1.27a\approx1.25a", OPEN),
    "an approximation of zero": (r"d=\frac{\sqrt5}2a\approx1.12(a-a)", OPEN),
    "in brackets": (r"c=(1.41)a", OPEN),
}


@pytest.mark.parametrize("name", PRINTS)
def test_a_factor_is_recomputed(name: str) -> None:
    latex, expected = PRINTS[name]
    parts = (BLOCK, DIAGONAL, HEIGHT, rf"\begin{{equation}}{latex}\end{{equation}}")
    assert check("paper.tex", "\n".join(parts)).rows[-1].outcome == expected


@pytest.mark.parametrize(("latex", "outcome"), [("b=2c", OPEN), ("b=3c", "REFUTED")])
def test_an_exact_print_behind_a_rounded_one_is_not_accused(latex: str, outcome: str) -> None:
    rounded = r"\begin{equation}b=2.82a\end{equation}"
    text = f"{BLOCK}{DIAGONAL}{rounded}\\begin{{equation}}{latex}\\end{{equation}}"
    assert check("paper.tex", text).rows[-1].outcome == outcome
