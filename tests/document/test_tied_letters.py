"""Operations over one letter alone are left open where constraints tie other letters to it."""

from __future__ import annotations

import pytest
from small_papers import judge_rows

pytestmark = pytest.mark.usefixtures("judged_here")

BLOCK = r"""%% mechproof
%% r ; l ; a ; b ; s : lengths [mm] {r>0}
%% \varphi ; \psi ; \beta : angles [rad] {-\pi/2<\psi<\pi/2}
%% x ; y : position [mm]
%% A ; B : lengths [mm]
%% k : stiffness [N/mm]
%% F : force [N]
%% W : work [mJ]
%% where l>r
%% end
"""
TIE, ROD = r"l\sin\psi=r\sin\varphi", r"x=r\cos\varphi+l\cos\psi"
PLAIN = r"y=r\cos\varphi+l\cos\beta"
OPEN = "not judged"
# Equations, and the outcome of the last one.
PAPERS = {
    "a derivative": ((TIE, ROD, r"\frac{dx}{d\varphi}=-r\sin\varphi"), OPEN),
    "a wrong derivative": ((TIE, ROD, r"\frac{dx}{d\varphi}=r\sin\varphi"), OPEN),
    "a partial derivative": (
        (TIE, ROD, r"\frac{\partial x}{\partial\varphi}=-r\sin\varphi"),
        "PROVED",
    ),
    "a letter that is not tied": ((TIE, PLAIN, r"\frac{dy}{d\varphi}=-r\sin\varphi"), "PROVED"),
    "tied by another": (
        (TIE, r"a\tan\psi=b\tan\beta", PLAIN, r"\frac{dy}{d\varphi}=-r\sin\varphi"),
        OPEN,
    ),
    "an integral": ((TIE, ROD, r"A=\int_0^\pi x\,d\varphi=\pi l\cos\psi"), OPEN),
    "an integral over a length": (
        ("s^2=x^2+b^2", "F=ks", r"W=\int_0^bF\,dx=kbs"),
        OPEN,
    ),
    "an integral of what is not tied": (
        ("s^2=x^2+b^2", r"W=\int_0^bkx\,dx=\frac{kb^2}2"),
        "PROVED",
    ),
    "values": ((TIE, ROD, r"A=x|_{\varphi=0}", r"B=x|_{\varphi=\pi/2}", "A-B=r"), OPEN),
    "values of what is not tied": (
        (TIE, PLAIN, r"A=y|_{\varphi=0}", r"B=y|_{\varphi=\pi/2}", "A-B=r"),
        "PROVED",
    ),
    "a special case": ((TIE, ROD, r"x=l\cos\psi\quad\text{for }\varphi=\pi/2"), OPEN),
    "the largest value": ((TIE, ROD, r"A=\max_\varphi x=r+l\cos\psi"), OPEN),
    "a letter alone on a side": (
        (r"s^2=r^2+l^2-2rl\cos\varphi", "y=s+a", r"\frac{d}{d\varphi}(y+\sin\varphi)=\cos\varphi"),
        OPEN,
    ),
    "a parameter, where another letter may move": (
        (
            r"\tan\psi=\tan\varphi\cos\beta",
            r"y=\frac{r\cos\beta}{1-\sin^2\beta\cos^2\varphi}",
            r"y|_{\varphi=0}=\frac r{\cos\beta}",
        ),
        "PROVED",
    ),
    "a constraint of another letter": (
        (r"l\sin\psi=r\sin\beta", ROD, r"\frac{dx}{d\varphi}=-r\sin\varphi"),
        "PROVED",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", PAPERS)
def test_nothing_that_is_tied_is_held(name: str) -> None:
    equations, outcome = PAPERS[name]
    row = judge_rows(BLOCK, *equations)[-1]
    assert row.outcome == outcome, row.reason
    if outcome == OPEN:
        assert "may change with" in row.reason


# A tied letter has one value at a place, or may have several: prints, and the outcome of the last.
ACUTE, ANY = (TIE.replace(r"\psi", letter) for letter in (r"\gamma", r"\beta"))
RODS = {letter: ROD.replace(r"\psi", letter) for letter in (r"\gamma", r"\beta")}
PLACES = {
    "at an end": ((TIE, ROD, r"x|_{\varphi=0}=r+l"), "PROVED"),
    "wrong at an end": ((TIE, ROD, r"x|_{\varphi=0}=l-r"), "REFUTED"),
    "at the other end": ((TIE, ROD, r"x|_{\varphi=\pi}=l-r"), "PROVED"),
    "wrong at the other end": ((TIE, ROD, r"x|_{\varphi=\pi}=l+r"), "REFUTED"),
    "between": ((TIE, ROD, r"x|_{\varphi=\pi/2}=\sqrt{l^2-r^2}"), "PROVED"),
    "wrong between": ((TIE, ROD, r"x|_{\varphi=\pi/2}=\sqrt{l^2+r^2}"), "REFUTED"),
    "in a condition": ((TIE, ROD, r"x=l-r\quad\text{for }\varphi=\pi"), "PROVED"),
    "wrong in a condition": ((TIE, ROD, r"x=r-l\quad\text{for }\varphi=\pi"), "REFUTED"),
    "an offset": (
        (r"l\sin\psi+b=r\sin\varphi", ROD, r"x|_{\varphi=0}=r+\sqrt{l^2-b^2}"),
        "PROVED",
    ),
    # It has other letters, so it may be meant for another case.
    "an offset that is none": (
        (r"l\sin\psi+b=r\sin\varphi", ROD, r"x|_{\varphi=0}=r+l"),
        OPEN,
    ),
    "no range": ((ANY, RODS[r"\beta"], r"x|_{\varphi=0}=r+l"), OPEN),
    "another branch": ((ANY, RODS[r"\beta"], r"x|_{\varphi=0}=r-l"), OPEN),
    # The angle has no such value there.
    "never there": ((ACUTE, RODS[r"\gamma"], r"x|_{\varphi=0}=r-l"), OPEN),
    "what is tied stands beside it": ((TIE, ROD, r"x|_{\varphi=0}=r-l\cos\psi"), OPEN),
    "another constraint contradicts": (
        (TIE, r"r\cos\varphi+l\cos\psi=2r", ROD, r"x|_{\varphi=0}=l-r"),
        "DEFINITION",
    ),
    # Nothing else gives b.
    "what introduces a letter contradicts nothing": (
        (TIE, r"r\cos\varphi+l\cos\psi=b", ROD, r"x|_{\varphi=0}=l-r"),
        "REFUTED",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", PLACES)
def test_what_is_tied_has_the_only_value_that_constraints_leave_it(name: str) -> None:
    equations, outcome = PLACES[name]
    block = BLOCK.replace("%% x", "%% \\gamma : angle [rad] {0<\\gamma<\\pi/2}\n%% x", 1)
    row = judge_rows(block, *equations)[-1]
    assert row.outcome == outcome, row.reason


# Values when the crank turns evenly, given by its speed alone or by its angle at any time.
EVENLY = {
    # It is true with the angle at this place, but not with any other angle.
    r"x|_{\varphi=0}=\left(l+r\right)\cos\psi": OPEN,
    r"x|_{\varphi=\pi}=l-r": "PROVED",
    r"x|_{\varphi=\pi}=l+r": "REFUTED",
    r"\dot x|_{\varphi=\pi/2}=-r\omega": "PROVED",
    r"\dot x|_{\varphi=\pi/2}=r\omega": "REFUTED",
    r"\ddot x|_{\varphi=0}=-r\omega^2\left(1+\frac rl\right)": "PROVED",
    r"\ddot x|_{\varphi=0}=-r\omega^2\left(1-\frac rl\right)": "REFUTED",
}


@pytest.mark.slow
@pytest.mark.parametrize("given", [r"\dot\varphi=\omega", r"\varphi=\omega t"])
@pytest.mark.parametrize("place", EVENLY)
def test_rates_of_what_is_tied_are_those_at_the_place(place: str, given: str) -> None:
    said = f"%% \\omega : speed\n%% t : time\n%% let {given}\n%% factor \\omega\n%% end"
    block = BLOCK.replace(r"\varphi ; \psi ;", r"\varphi(t) ; \psi(t) ;")
    block = block.replace("x ; y", "x(t) ; y").replace("%% end", said)
    row = judge_rows(block, TIE, ROD, place)[-1]
    assert row.outcome == EVENLY[place], row.reason


@pytest.mark.slow
def test_no_rate_is_taken_at_a_place_without_what_is_tied() -> None:
    block = (
        BLOCK.replace(r"\varphi ; \psi ;", r"\varphi(t) ; \psi(t) ;")
        .replace("x ; y", "x(t) ; y")
        .replace("A ; B : lengths [mm]", r"\omega ; A ; B : speeds")
        .replace("%% end", "%% let \\dot\\varphi=\\omega\n%% end")
    )
    rate = r"\dot\psi=\frac{r\omega\cos\varphi}{l\cos\psi}"
    places = (r"A=\dot x|_{\varphi=\pi/4}", r"B=\dot x|_{\varphi=-\pi/4}", r"A-B=-\sqrt2r\omega")
    equations = (TIE, ROD, rate, *places)
    row = judge_rows(block, *equations)[-1]
    assert (row.outcome, "may change with" in row.reason) == (OPEN, True)


CAM = r"""%% mechproof
%% s(\theta) ; h ; r : lengths [mm]
%% \theta(t) ; \beta ; \alpha ; \gamma : angles [rad]
%% end
"""
RISE = r"s=h\left(1-\cos\frac{\pi\theta}\beta\right)"
PRESSURE = r"\tan\alpha=\frac{s'}{r+s}"
# An angle that appears in one equation only may move with a law; one in two equations is asked for.
LAWS = {
    "a derivative": ((RISE, r"s'=\frac{\pi h}\beta\sin\frac{\pi\theta}\beta", PRESSURE), "PROVED"),
    "a wrong derivative": (
        (RISE, r"s'=\frac{\pi h}\beta\cos\frac{\pi\theta}\beta", PRESSURE),
        "REFUTED",
    ),
    "an angle of two constraints": (
        (
            RISE,
            r"s'=\frac{\pi h}\beta\sin\frac{\pi\theta}\beta",
            PRESSURE,
            r"h\sin\beta=s\cos\alpha",
        ),
        OPEN,
    ),
}


@pytest.mark.parametrize("name", LAWS)
def test_an_angle_of_its_own_moves_beside_a_law(name: str) -> None:
    equations, expected = LAWS[name]
    assert judge_rows(CAM, *equations)[1].outcome == expected


@pytest.mark.parametrize(("moving", "outcome"), [("s", OPEN), ("s(t)", "PROVED")])
def test_rates_of_what_moves_are_not_zero_where_nothing_that_gives_it_moves(
    moving: str, outcome: str
) -> None:
    block = rf"""%% mechproof
%% \theta(t) : angle [rad]
%% r : radius [mm]
%% {moving} : way [mm]
%% \omega : rate [rad/s]
%% end
"""
    prints = (
        r"\theta=\frac sr",
        r"\omega=\dot\theta",
        r"r^2\omega=r^2\dot\theta",
        r"\omega=2\dot\theta",
    )
    rows = judge_rows(block, *prints)
    assert rows[2].outcome == outcome
    assert rows[3].outcome == ("REFUTED" if moving == "s(t)" else OPEN)
