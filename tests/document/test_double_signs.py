"""Letters printed with a double sign: both values are roots of a constraint, or a misprint."""

from __future__ import annotations

import pytest

from mechproof.document.checking import check

pytestmark = pytest.mark.usefixtures("judged_here")

BLOCK = r"""%% mechproof
%% E ; F ; G ; T ; a ; b ; c ; x : numbers
%% q ; p : angles
%% end
"""
ROOTS = r"T=\frac{-F\pm\sqrt{E^2+F^2-G^2}}{G-E}"
WAVE = r"E\cos q+F\sin q+G=0"
HALF = r"T=\tan\frac q2"
QUADRATIC = r"ax^2+bx+c=0"
# What is printed before, a print, and what becomes of it.
CASES: list[tuple[tuple[str, ...], str, str]] = [
    ((WAVE, HALF), ROOTS, "PROVED"),
    ((WAVE, HALF), ROOTS.replace("G-E", "G+E"), "REFUTED"),
    ((WAVE, HALF), ROOTS.replace("-F", "F"), "REFUTED"),
    (("E=-2a", WAVE, HALF), ROOTS, "PROVED"),
    (("(G-E)T^2+2FT+G+E=0",), ROOTS, "PROVED"),
    (("(G-E)T^2+2FT+G+E=0",), ROOTS.replace("-G", "+G"), "REFUTED"),
    ((WAVE,), ROOTS.replace("T=", r"q=2\arctan"), "PROVED"),
    ((QUADRATIC,), r"x=\frac{-b\pm\sqrt{b^2-4ac}}{2a}", "PROVED"),
    ((QUADRATIC,), r"x=\frac{-b\pm\sqrt{b^2-4ac}}{a}", "REFUTED"),
    # Two changes contradict the other; without a constraint nothing is known.
    ((QUADRATIC,), r"x=\frac{b\pm\sqrt{b^2+4ac}}{2a}", "not judged"),
    ((), r"x=a\pm\sqrt b", "DEFINITION"),
    # One of them only, and chains, are not read so.
    ((QUADRATIC,), r"x=\frac{-b\pm\sqrt{b^2-4ac}}{2a}=c", "not read"),
    ((QUADRATIC,), r"x=\frac{-b\mp\sqrt{b^2-4ac}}{2a}", "not read"),
]


@pytest.mark.parametrize(("before", "latex", "outcome"), CASES)
def test_both_signs_are_judged(before: tuple[str, ...], latex: str, outcome: str) -> None:
    text = "".join(f"$${one}$$\n" for one in (*before, latex))
    *others, row = check("paper.tex", BLOCK + text).rows
    assert row.outcome == outcome, row.reason
    assert "REFUTED" not in {one.outcome for one in others}
