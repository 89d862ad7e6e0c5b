"""Decimals beside letters: a factor that was rounded is recomputed, others are left open."""

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
# What stands between the definitions and a print, the print, and its outcome.
PRINTS = {
    "two digits": ("", "c=1.41a", "PROVED"),
    "three digits, turned around": ("", r"1.414\,a=c", "PROVED"),
    "a comma": ("", "c=1{,}414a", "PROVED"),
    "a sign": ("", "-c=-1.41a", "PROVED"),
    "a wrong digit": ("", "c=1.42a", "not judged"),
    "a wrong digit behind a decimal that is right": ("", "c=1.4143a", "not judged"),
    "a step": ("", r"d=\frac{\sqrt5}2a=1.12a", "PROVED"),
    "a wrong step": ("", r"d=\frac{\sqrt5}2a=1.21a", "not judged"),
    "of letters that cancel": ("", r"\frac cb=1.63", "PROVED"),
    "a wrong one of letters that cancel": ("", r"\frac cb=1.64", "REFUTED"),
    "two decimals": ("", "c=1.42a+0.5b", "not judged"),
    "of what has letters left": ("", r"c=1.42a\cos\varphi", "not judged"),
}


@pytest.mark.parametrize("name", PRINTS)
def test_a_factor_is_recomputed(name: str) -> None:
    words, latex, expected = PRINTS[name]
    parts = (BLOCK, DIAGONAL, HEIGHT, words, rf"\begin{{equation}}{latex}\end{{equation}}")
    assert check("paper.tex", "\n".join(parts)).rows[-1].outcome == expected
