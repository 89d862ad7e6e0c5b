"""Equations under a printed condition: what follows there, what does not, and what they prove."""

from __future__ import annotations

import pytest

from mechproof.document.checking import check

pytestmark = pytest.mark.usefixtures("judged_here")

WILLIS = r"""%% mechproof
%% n_1 ; n_2 ; n_3 : speeds of sun, carrier, ring [rad/s]
%% z_1 ; z_3 : numbers of teeth {z_1>0}
%% where z_3>0
%% end
\begin{equation}\frac{n_1-n_2}{n_3-n_2}=-\frac{z_3}{z_1}\end{equation}
"""
LETTERS = r"""%% mechproof
%% a ; b ; c ; d : numbers
%% end
$$a+b=c+d$$
"""
LOOP = r"""%% mechproof
%% r ; l ; c : lengths [m] {r>0}
%% \varphi(t) ; \psi(t) : angles [rad]
%% end
$$l\sin\psi=r\sin\varphi+c$$
"""
PENDULUM = r"""%% mechproof
%% J ; D ; M : inertia, constant, moment
%% \varphi(t) : angle [rad]
%% end
$$J\ddot\varphi=M-D\sin\varphi$$
"""
SLIDER = r"""%% mechproof
%% r ; l : lengths [m] {r>0}
%% e : offset [m]
%% \varphi(t) ; \beta(t) : angles [rad] {-\pi/2<\beta<\pi/2}
%% where l>r
%% end
$$l\sin\beta=r\sin\varphi-e$$
"""
HELD = r"With the ring held ($n_3=0$) we get $$\frac{n_1}{n_2}=1+\frac{z_3}{z_1}$$"
CENTRED = r"$$l\sin\beta=r\sin\varphi\quad(e=0)$$"
# The text before, the equations after it, and the outcomes of these.
PAPERS = [
    (WILLIS, rf"{HELD} and $$n_2=\frac{{z_1}}{{z_1+z_3}}n_1\quad(n_3=0)$$", "PROVED PROVED"),
    (WILLIS, rf"{HELD} and $$n_2=\frac{{z_3}}{{z_1+z_3}}n_1\quad(n_3=0)$$", "PROVED REFUTED"),
    (
        WILLIS,
        HELD.replace("1+", "1-") + r"and $$n_2=\frac{z_1}{z_1+z_3}n_1\quad(n_3=0)$$",
        "REFUTED PROVED",
    ),
    # Each holds in a case of its own.
    (
        WILLIS,
        r"$$n_1=\frac{z_1+z_3}{z_1}n_2\quad(n_3=0)$$ $$n_3=\frac{z_1+z_3}{z_3}n_2\quad(n_1=0)$$"
        r"$$\frac{n_1}{n_3}=-\frac{z_3}{z_1}\quad\text{for }n_2=0$$",
        "PROVED PROVED PROVED",
    ),
    (WILLIS, r"$$n_3=\frac{z_1-z_3}{z_3}n_2\quad(n_1=0)$$", "REFUTED"),
    (WILLIS, r"$$n_1=\frac{z_1+z_3}{z_1}n_2,\quad n_3=0$$", "PROVED DEFINITION"),
    (WILLIS, r"$$n_1=\frac{z_1-z_3}{z_1}n_2,\quad n_3=0$$", "REFUTED DEFINITION"),
    # A condition stated in a sentence applies until the text says something new.
    (WILLIS, rf"{HELD} Hence $$z_1n_1=(z_1+z_3)n_2$$", "PROVED PROVED"),
    (WILLIS, rf"{HELD} In general $$z_1n_1=(z_1+z_3)n_2$$", "PROVED DEFINITION"),
    # An equation that prints the letter is meant for its other values, too.
    (
        LOOP,
        r"It starts at $\varphi=0$. Hence $$l\dot\psi\cos\psi=r\dot\varphi\cos\varphi$$"
        r"$$l\dot\psi\cos\psi=r\dot\varphi$$",
        "PROVED DEFINITION",
    ),
    # Nothing about one special case is proved or refuted by another.
    (LETTERS, r"$$a+b-c=0\quad(d=0)$$ $$2a+2b=2c$$", "PROVED DEFINITION"),
    (LETTERS, r"$$a+b-c=0\quad(d=0)$$ $$2a+2b=2c\quad(d=0)$$", "PROVED PROVED"),
    (LETTERS, r"$$a+b-c=0\quad(d=0)$$ $$a+b-c=1\quad(d=1)$$", "PROVED PROVED"),
    (LETTERS, r"$$a+b=2c\quad(d>c)$$ $$2a+2b=4c$$", "DEFINITION DEFINITION"),
    (SLIDER, CENTRED + r"$$\sin\beta=\frac{r\sin\varphi}l$$", "PROVED DEFINITION"),
    (SLIDER, CENTRED + r"$$\sin\beta=\frac{r\sin\varphi}l\quad(e=0)$$", "PROVED PROVED"),
    (SLIDER, CENTRED + r"$$\sin\beta=\frac{r\cos\varphi}l\quad(e=0)$$", "PROVED REFUTED"),
    (SLIDER, r"$$l\dot\beta\cos\beta=r\dot\varphi\cos\varphi\quad(e=0)$$", "PROVED"),
    # An equation that holds at one instant only has no derivative.
    (LOOP, r"$$l\sin\psi=c\quad(\varphi=0)$$ $$\dot\psi=0\quad(\varphi=0)$$", "PROVED DEFINITION"),
    (LOOP, r"$$l\dot\psi\cos\psi=r\dot\varphi\quad(\varphi=0)$$", "PROVED"),
    (
        LOOP,
        r"$$l\sin\psi=c\quad(\varphi=0)$$ $$l\sin\psi=2c\quad(\varphi=0)$$",
        "PROVED REFUTED",
    ),
    (
        PENDULUM,
        r"$$M=D\sin\varphi,\quad\ddot\varphi=0$$ $$J\ddot\varphi=-D\sin\varphi\quad(M=0)$$",
        "PROVED DEFINITION PROVED",
    ),
    (
        PENDULUM,
        r"$$M=D\cos\varphi,\quad\ddot\varphi=0$$ $$J\ddot\varphi=-D\sin\varphi\quad(M=0)$$",
        "REFUTED DEFINITION PROVED",
    ),
    (PENDULUM, r"$$\ddot\varphi=\frac MJ\quad\text{for }\varphi=0$$", "PROVED"),
    (
        PENDULUM,
        r"$$M=D\sin\varphi,\quad\ddot\varphi=0$$ $$\ddot\varphi=\frac JM\quad(\varphi=0)$$",
        "PROVED DEFINITION REFUTED",
    ),
]


@pytest.mark.slow
@pytest.mark.parametrize(("before", "equations", "outcomes"), PAPERS)
def test_what_is_said_of_a_case_is_judged_there(before: str, equations: str, outcomes: str) -> None:
    rows = check("paper.tex", before + equations).rows
    given = len(check("paper.tex", before).rows)
    assert {row.outcome for row in rows[:given]} == {"DEFINITION"}
    assert [row.outcome for row in rows[given:]] == outcomes.split()


@pytest.mark.parametrize(("value", "expected"), [("1+", "PROVED"), ("1-", "REFUTED")])
def test_what_is_said_to_follow_is_judged_under_its_condition(value: str, expected: str) -> None:
    block = WILLIS.replace("%% end", "%% follows (2): (1)\n%% end")
    latex = rf"\frac{{n_1}}{{n_2}}={value}\frac{{z_3}}{{z_1}}\quad(n_3=0)"
    row = check("paper.tex", rf"{block}\begin{{equation}}{latex}\end{{equation}}").rows[-1]
    assert row.outcome == expected


@pytest.mark.parametrize(("value", "expected"), [("i_0", "PROVED"), ("-i_0", "DEFINITION")])
def test_a_value_of_a_letter_with_another_definition_follows(value: str, expected: str) -> None:
    block = WILLIS.replace("%% end", "%% i_0 : ratio\n%% let i_0=-z_3/z_1\n%% end")
    case = r"If the carrier is fixed ($n_2=0$) $$\frac{n_1}{n_3}="
    assert check("paper.tex", f"{block}{case}{value}$$").rows[-1].outcome == expected


# Words around a condition, and whether they leave its meaning unchanged.
WORDS = {
    r"\quad\text{with the ring held }(n_3=0)": True,
    r"\quad\text{(ring held, }n_3=0)": True,
    r"\text{ (ring held, }n_3=0\text{)}": True,
    r"\quad\mbox{(with }n_3=0\mbox{)}": True,
    r"\qquad\text{if } n_3=0": True,
    r"\quad\text{without a turning ring }(n_3=0)": True,
    r"\quad\text{unless the ring is held }(n_3=0)": False,
    r"\quad\text{(but not for }n_3=0)": False,
    r"\quad\text{or }(n_3=0)": False,
}


@pytest.mark.parametrize("words", WORDS)
def test_a_condition_may_be_said_in_words_too(words: str) -> None:
    for above, outcome in (("z_1", "PROVED"), ("z_3", "REFUTED")):
        latex = rf"n_2=\frac{{{above}}}{{z_1+z_3}}n_1{words}"
        row = check("paper.tex", f"{WILLIS}$${latex}$$").rows[-1]
        assert row.outcome == (outcome if WORDS[words] else "not read")
