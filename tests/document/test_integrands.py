"""Integrands, and the variables of integration."""

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
        # s depends on the variable of integration, and nothing is known about how.
        (r"F=\int_0^as(r)\,dr", "not read"),
        (r"\int_0^as\,dr=as", "not read"),
    ],
)
def test_what_is_integrated_shows_its_letter(latex: str, outcome: str) -> None:
    found = check("paper.tex", f"{PRESSURE}\\begin{{equation}}{latex}\\end{{equation}}\n")
    assert found.rows[-1].outcome == outcome, found.rows[-1].reason


MOTION = r"""%% mechproof
%% y(t) ; F(t) : moving
%% s(y) : moving with y
%% W ; c ; b : numbers
%% t : time
%% end
"""


@pytest.mark.parametrize(
    ("value", "taken_as_fixed", "outcome"),
    [
        # A letter that moves in time is not constant, though its argument is not printed.
        (r"\int_0^t\dot y\,dt", r"t\dot y", "not read"),
        (r"\int_0^t\ddot F\dot y\cdot dt", r"t\ddot F\dot y", "not read"),
        (r"\int_0^ts\,dt", "ts", "not read"),
        (r"\int_0^yF\,dy", "Fy", "not read"),
        (r"\int_0^yc\dot y\,dy", r"c\dot yy", "not read"),
        (r"\int_0^yct\,dy", "cty", "not read"),
        (r"\lim_{t\to0}(c\dot y+t)", r"c\dot y", "not read"),
        (r"\max_t(\dot y+\sin t)", r"\dot y+1", "not read"),
        (r"\int_0^ycy\,dy", r"\frac12cy^2", "PROVED"),
        (r"\int_0^yct\,dc", r"\frac12y^2t", "PROVED"),
        (r"\int_0^yc\cdot dy", "cy", "PROVED"),
        (r"\int_0^yc\cdot dy", "2cy", "REFUTED"),
        (r"\lim_{b\to0}(c\dot y+b)", r"c\dot y", "PROVED"),
    ],
)
def test_what_moves_with_a_letter_is_not_fixed(
    value: str, taken_as_fixed: str, outcome: str
) -> None:
    first, again = check("paper.tex", f"{MOTION}$$W={value}$$ $$W={taken_as_fixed}$$").rows
    assert (first if outcome == "not read" else again).outcome == outcome, again.reason


@pytest.mark.parametrize(
    ("print_", "outcome"),
    [(r"b=y+c\dot y^2", "PROVED"), (r"b=y-c\dot y^2", "not judged")],
)
def test_a_letter_may_be_given_by_its_own_rate(print_: str, outcome: str) -> None:
    *_, row = check("paper.tex", f"{MOTION}$$y=b-c\\dot y^2$$ $${print_}$$").rows
    assert row.outcome == outcome, row.reason


INVOLUTE = r"""%% mechproof
%% x(t) ; y(t) : coordinates
%% t : angle {t>0}
%% r ; L : lengths {r>0}
%% s(t) : way
%% factor r
%% end
\begin{align}x&=r(\cos t+t\sin t)\\y&=r(\sin t-t\cos t)\end{align}
"""


@pytest.mark.parametrize(
    ("latex", "outcome"),
    [
        # The variable of integration stands for the upper limit, on which x and y depend.
        (r"\int_0^t\sqrt{\dot x^2+\dot y^2}\,d\tau=\frac{rt^2}2", "PROVED"),
        (r"\int_0^t\sqrt{\dot x^2+\dot y^2}\,d\tau=rt^2", "REFUTED"),
        (r"\int_0^ty\,d\tau=2r-2r\cos t-rt\sin t", "PROVED"),
        # It does not where the upper limit itself appears in the integrand.
        (r"\int_0^t\frac yt\,d\tau=y", "PROVED"),
        (r"\int_0^rt\,d\tau=rt", "PROVED"),
        # Nor does it where it is a letter of its own that moves.
        (r"\int_0^tx\,ds=\int_0^tx\,dt", "not read"),
    ],
)
def test_an_integral_to_a_letter_that_moves_is_one_over_it(latex: str, outcome: str) -> None:
    text = f"{INVOLUTE}\\begin{{equation}}{latex}\\end{{equation}}\n"
    found = check("paper.tex", text.replace("%% end", "%% identity (3)\n%% end"))
    assert found.rows[-1].outcome == outcome, found.rows[-1].reason
