"""What is integrated, and the letter by which it is."""

from __future__ import annotations

import pytest

from mechproof.document.checking import check

pytestmark = pytest.mark.usefixtures("judged_here")

PRESSURE = r"""%% mechproof
%% F : force
%% a ; q : sizes {a>0}
%% p(r) ; s(r) : pressures
%% r : radius
%% end
\begin{equation}p=q\sqrt{1-\frac{r^2}{a^2}}\end{equation}
\begin{equation}F=\frac23\pi a^2q\end{equation}
"""


@pytest.mark.parametrize(
    ("latex", "outcome"),
    [
        (r"\int_0^a2\pi r\,p(r)\,dr=\frac23\pi a^2q", "PROVED"),
        (r"F=\int_0^a2\pi r\,p(r)\,dr", "PROVED"),
        (r"F=\int_0^a\pi r\,p(r)\,dr", "REFUTED"),
        # Of what depends on the letter by which is integrated nothing is known.
        (r"F=\int_0^as(r)\,dr", "not read"),
        (r"\int_0^as\,dr=as", "not read"),
    ],
)
def test_what_is_integrated_shows_its_letter(latex: str, outcome: str) -> None:
    found = check("paper.tex", f"{PRESSURE}\\begin{{equation}}{latex}\\end{{equation}}\n")
    assert found.rows[-1].outcome == outcome, found.rows[-1].reason
