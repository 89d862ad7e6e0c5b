"""Words before a print: a print of another case is not accused, a consequence is."""

from __future__ import annotations

from functools import partial

import pytest
from small_papers import judge_parts

from mechproof.sources.announcements import NOTHING, Announced

pytestmark = pytest.mark.usefixtures("judged_here")

BLOCK = r"""%% mechproof
%% r ; l ; d ; s : lengths [mm] {r>0, l>0, d>0, s>0}
%% x(t) ; y(t) : position [mm]
%% h(t) : height [mm]
%% \varphi(t) ; \psi(t) ; \beta(t) : angles [rad]
%% k ; k_1 ; k_2 : rates [N/mm] {k_1>0, k_2>0}
%% z_1 ; z_3 : numbers of teeth [1] {z_1>0, z_3>0}
%% \omega_1 ; \omega_3 ; \omega_4 : speeds [rad/s]
%% where d>r
%% factor l, r
%% end
"""
PIN = r"y=r\sin\varphi"
BELOW = r"y=-r\sin\varphi"
# Words before a print, and whether it is accused if it differs from the print before them.
WORDS = {
    "": True,
    "and": True,
    "Hence": True,
    "Substituting this, we obtain": True,
    "Squaring and adding, it follows that": True,
    "Multiplication gives": True,
    "Multiplied by two such pins, we find": False,
    "Adding (1) and (2), we obtain": True,
    "Turned by a right angle, it follows that": False,
    "Removing the pin, we obtain": False,
    "--": False,
    "(b)": False,
    r"\textbf{B}": False,
    r"$(\beta)$": False,
    "where $r$ is the crank radius.": False,
    r"With $\varphi$ measured clockwise, the pin is at": False,
    r"Here $\varphi$ is now counted clockwise:": False,
    "In a left-handed frame this reads": False,
    "In the lower position": False,
    "Seen from behind,": False,
    "On the far side": False,
    r"\section{The lower crank}": False,
    "In the other case, hence,": False,
}


judge = partial(judge_parts, BLOCK)


@pytest.mark.slow
@pytest.mark.parametrize("words", WORDS)
def test_only_a_consequence_is_accused(words: str) -> None:
    accused = "REFUTED" if WORDS[words] else "not judged"
    assert judge("#The pin is at", PIN, f"#{words}", BELOW) == ["DEFINITION", accused]


# Papers that are true as they may be meant, and papers with one wrong row, after no words or after
# words that announce nothing new.
CASES: dict[str, tuple[list[str], list[str]]] = {
    "a case goes on in the displays behind it": (
        [
            "#A point on the rim has",
            r"x=r\cos\varphi",
            PIN,
            "#If the wheel rolls, then",
            r"x=r(\varphi-\sin\varphi)",
            r"y=r(1-\cos\varphi)",
        ],
        ["DEFINITION", "DEFINITION", "not judged", "not judged"],
    ),
    "a case that is one by its own words only": (
        [
            "#Springs in parallel have",
            "k=k_1+k_2",
            "#Springs in series have",
            r"k=\frac{k_1}{k_2}k_1",
        ],
        ["DEFINITION", "not judged"],
    ),
    "a relation of another case": (
        [
            "#Springs in parallel have",
            "k=k_1+k_2",
            "#Springs in series have",
            r"\frac1k=\frac1{k_1}+\frac1{k_2}",
        ],
        ["not judged", "not judged"],
    ),
    "the same relation, without words": (
        ["k=k_1+k_2", r"\frac1k=\frac1{k_1}+\frac1{k_2}"],
        ["DEFINITION", "REFUTED"],
    ),
    "a derivative that holds nearly": (
        [
            "#The height is",
            r"h=l(1-\cos\varphi)",
            "#For small angles, if terms of the third order are neglected,",
            r"\dot h=l\dot\varphi\varphi",
        ],
        ["DEFINITION", "not judged"],
    ),
    "the same derivative, said to hold": (
        [
            "#The height is",
            r"h=l(1-\cos\varphi)",
            "#Its velocity is",
            r"\dot h=l\dot\varphi\varphi",
        ],
        ["DEFINITION", "REFUTED"],
    ),
    "a rate at a place": (
        [
            "#The velocity during the rise is",
            r"\dot h=l\left(1-\cos2\varphi\right)\dot\varphi",
            "#In the middle of the rise it is largest,",
            r"\dot h=2l\dot\varphi",
        ],
        ["DEFINITION", "not judged"],
    ),
    "speeds of two cases, and what holds in general": (
        [
            "#With the ring fixed,",
            r"\omega_1=\left(1+\frac{z_3}{z_1}\right)\omega_4",
            "#When the sun is held,",
            r"\omega_3=\left(1+\frac{z_1}{z_3}\right)\omega_4",
            "#In general",
            r"\omega_4=\frac{z_1\omega_1+z_3\omega_3}{z_1+z_3}",
        ],
        ["DEFINITION", "DEFINITION", "not judged"],
    ),
    "constant speed in words, beside a loop": (
        [
            r"x=r\cos\varphi+l\cos\psi",
            r"r\sin\varphi=l\sin\psi",
            "#The crank turns uniformly, therefore",
            r"\ddot x=-r\dot\varphi^2\cos\varphi-l\ddot\psi\sin\psi-l\dot\psi^2\cos\psi",
            r"l\ddot\psi\cos\psi-l\dot\psi^2\sin\psi=-r\dot\varphi^2\sin\varphi",
        ],
        ["DEFINITION", "DEFINITION", "not judged", "DEFINITION"],
    ),
    "loops of two senses of an angle prove nothing together": (
        [
            "#The swinging block obeys",
            r"s\cos\beta=d+r\cos\varphi",
            r"s\sin\beta=r\sin\varphi",
            r"#The angle $\varphi$ is now measured from the inner dead centre, so that",
            r"s\cos\beta=d-r\cos\varphi",
            "#Therefore",
            r"\tan\beta=\frac{r\sin\varphi}{d}",
        ],
        ["DEFINITION"] * 4,
    ),
    "loops of two arrangements prove nothing together": (
        [
            "#In the arrangement of Fig. 1 the loop closes with",
            r"r\sin\varphi=l\sin\psi",
            "#In the arrangement of Fig. 2 the guide is offset:",
            r"r\sin\varphi=l\sin\psi+h",
            "#The offset is seen as",
            r"h\cos\varphi=0",
        ],
        ["DEFINITION", "DEFINITION", "DEFINITION"],
    ),
    "loops of one arrangement": (
        [
            "#In the arrangement of Fig. 1 the loop closes with",
            r"r\sin\varphi=l\sin\psi",
            r"r\sin\varphi=l\sin\psi+h",
            "#The offset is seen as",
            r"h\cos\varphi=0",
        ],
        ["DEFINITION", "DEFINITION", "PROVED"],
    ),
    "a special position is left": (
        [
            "#For a circle the half axes are equal,",
            "l=r",
            "#The parameter of an ellipse is",
            r"s=\frac{l^2}{r}",
            "#The curvature has the radius",
            "s=l",
        ],
        ["DEFINITION", "DEFINITION", "not judged"],
    ),
    "a special position, and what follows there": (
        [
            "#The parameter of an ellipse is",
            r"s=\frac{l^2}{r}",
            "#For a circle the half axes are equal,",
            "l=r",
            "#Hence",
            "s=l",
        ],
        ["DEFINITION", "DEFINITION", "PROVED"],
    ),
    "speeds of two cases prove nothing together": (
        [
            "#With the ring fixed,",
            r"\omega_1=\left(1+\frac{z_3}{z_1}\right)\omega_4",
            "#When the sun is held,",
            r"\omega_3=\left(1+\frac{z_1}{z_3}\right)\omega_4",
            "#The speeds of sun and ring have the ratio",
            r"\frac{\omega_1}{\omega_3}=\frac{z_3}{z_1}",
        ],
        ["DEFINITION", "DEFINITION", "not judged"],
    ),
    "what is true of all speeds": (
        [
            "#With the ring fixed,",
            r"\omega_1=\left(1+\frac{z_3}{z_1}\right)\omega_4",
            "#When the sun is held,",
            r"\omega_3=\left(1+\frac{z_1}{z_3}\right)\omega_4",
            "#Their sum and difference obey",
            r"(\omega_1+\omega_3)(\omega_1-\omega_3)=\omega_1^2-\omega_3^2",
        ],
        ["DEFINITION", "DEFINITION", "PROVED"],
    ),
    "speeds of one case": (
        [
            "#With the ring fixed,",
            r"\omega_1=\left(1+\frac{z_3}{z_1}\right)\omega_4",
            r"\omega_3=\left(1+\frac{z_1}{z_3}\right)\omega_4",
            "#The speeds have the ratio",
            r"\frac{\omega_1}{\omega_3}=\frac{z_3}{z_1}",
        ],
        ["DEFINITION", "DEFINITION", "PROVED"],
    ),
    "an inequality may tell of another case": (
        ["d=2r", "d>2r", "#**Movable**", "d>2r", "d>3r", "-r^2>0"],
        ["DEFINITION", "REFUTED", "not judged", "not judged", "REFUTED"],
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_words_tell_of_other_cases(case: str) -> None:
    parts, expected = CASES[case]
    assert judge(*parts) == expected


def test_what_is_announced_goes_on_until_other_words() -> None:
    first = NOTHING.go_on("The crank turns clockwise.")
    assert first == Announced(is_new=True, passage=1, scope=1, turns=1)
    assert first.go_on(" and ") == first
    assert first.go_on("Thus") == Announced(passage=2, scope=1, turns=1)
    for words in (
        "It is measured from the axis.",
        "It is counted counter-clockwise.",
        "Anticlockwise",
    ):
        assert first.go_on(words).turns == 1
    assert first.go_on(" with ").is_clause
    assert not first.go_on("The crank turns with it.").is_clause
    assert first.go_on("Hence in general").is_general
    assert first.go_on(r"\section{Cams} Hence").subjects == 1
    case = first.go_on("In the other case, with small angles,")
    flags = case.is_case, case.is_special, case.is_new, case.is_equating, case.is_position
    assert flags == (True, True, True, True, False)
    assert (case.passage, case.scope, case.turns) == (2, 2, 1)
    assert case.go_on(r" where $r$ is counted clockwise.").turns == 1
    assert case.go_on(r" Here $r$ is counted clockwise.").turns == 2


PLACE = (r"x=r\cos\varphi", r"y=r\sin\varphi+l\varphi")
HEADING = r"#\section{Velocities} The velocities are"
RATE = r"\dot x=-r\dot\varphi\sin\varphi"
WRONG = r"\dot y=r\dot\varphi\cos\varphi-l\dot\varphi"
SECOND = r"\ddot x=-r\ddot\varphi\sin\varphi+r\dot\varphi^2\cos\varphi"
# The parts after two positions, and the outcome of the last derivative.
RATES = {
    "beside a true one": ((HEADING, RATE, WRONG), "REFUTED"),
    "before a true one": ((HEADING, r"\dot x=r\dot\varphi\sin\varphi", RATE, WRONG), "REFUTED"),
    "alone": ((HEADING, WRONG), "not judged"),
    "beside a wrong one": ((HEADING, r"\dot x=r\dot\varphi\sin\varphi", WRONG), "not judged"),
    "counted otherwise": (
        (HEADING, RATE, r"\dot y=-r\dot\varphi\cos\varphi-l\dot\varphi"),
        "not judged",
    ),
    "words between": ((HEADING, RATE, "#The height changes by", WRONG), "not judged"),
    "words that turn a sense": (
        (r"#\section{Velocities} With $\varphi$ now counted clockwise", RATE, WRONG),
        "not judged",
    ),
    "of the same letter, behind a consequence": (
        (HEADING, RATE, "#Differentiating once more, we find", SECOND),
        "REFUTED",
    ),
    "of the same letter, behind new words": (
        (HEADING, RATE, "#The other pin moves by", SECOND),
        "not judged",
    ),
    "of the same letter, at constant speed": (
        (HEADING, RATE, "#Hence, at constant speed,", r"\ddot x=-r\dot\varphi^2\cos\varphi"),
        "not judged",
    ),
    "printed anew": (
        (r"#\section{The lower pin}", r"y=r\sin\varphi-l", HEADING, RATE, WRONG),
        "not judged",
    ),
}


@pytest.mark.parametrize("name", RATES)
def test_a_derivative_behind_a_heading_is_compared_beside_a_true_one(name: str) -> None:
    parts, expected = RATES[name]
    assert judge(*PLACE, *parts)[-1] == expected
