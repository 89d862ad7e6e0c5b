"""Rows that rest on a later case, an unread equation, or a letter not declared to move."""

from __future__ import annotations

from functools import partial

import pytest
from small_papers import judge_parts, judge_rows

from mechproof.document.checking import check

pytestmark = pytest.mark.usefixtures("judged_here")

BLOCK = r"""%% mechproof
%% F ; G ; A : forces [N] {F>0}
%% M : moment [N*mm]
%% a ; b ; l ; r ; h : lengths [mm] {a>0, b>0, l>0, r>0}
%% x(t) : position [mm]
%% \varphi(t) : angle of the crank [rad]
%% \beta@ ; \delta : angles [rad]
%% s(\theta) : lift [mm]
%% \theta : angle of the cam [rad]
%% n_i ; n_a ; n_k ; d ; D ; f : numbers {D>0}
%% k ; k_1 ; k_2 ; k_3 : stiffness [N/mm] {k_1>0, k_2>0, k_3>0}
%% end
"""
BEAM = ("#The bearing carries", r"A=F\frac{l-a}l", "#and the moment is")
WRONG, RIGHT = (rf"M=Aa=F\frac{{a{other}}}l" for other in ("^2", "(l-a)"))
MIDDLE = ("#It is largest if the load stands in the middle,", r"a=\frac l2")
LOOP = (r"x=r\cos\varphi+l\cos\beta", "#where", r"r\sin\varphi=l\sin\beta", "#The speed is")
SPEED = r"\dot x=-r\dot\varphi\sin\varphi-r\dot\varphi\cos\varphi\tan\beta"
HARMONIC = r"s=\frac h2(1-\cos\theta)"
UNREAD = r"s=h(\theta)"
SLOPE = r"s'=\frac h2\sin\theta"
CAGE = ("#A fault is met with", r"f=n_i-n_k=\frac12(n_i-n_a)(1+\frac dD)")
AT_REST = ("#With the outer ring at rest,", r"n_k=\frac{n_i}2-\frac{n_id}{2D}")
PULLEY = ("#A fixed pulley turns a force, so that", "F=G")
RETURN = r"s'=-\frac h2\sin\theta"
PISTON = ("#The pin moves along", r"x=r\cos\varphi")
OTHER_SPEED = r"\dot x=-r\dot\varphi\cos\varphi"
PARABOLIC = ("#The parabolic law is", r"s=h\theta^2", "#with")
LOADED = ("M=Fa", r"G=F\frac bl")
IN_PARALLEL = ("#Springs in parallel have", "k=k_1+k_2")
OPEN = "not judged"
# Displays, with text before them marked by #, and the outcomes of all displays.
PAPERS: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "proved by a later case": (
        (*BEAM, WRONG, *MIDDLE),
        ("DEFINITION", "DEFINITION", OPEN, "DEFINITION"),
    ),
    "true without it": (
        (*BEAM, RIGHT, *MIDDLE),
        ("DEFINITION", "DEFINITION", "PROVED", "DEFINITION"),
    ),
    "wrong without it": ((*BEAM, WRONG), ("DEFINITION", "DEFINITION", "REFUTED")),
    "what a letter means is no case": (
        (*BEAM, WRONG, "#where", r"a=\frac l2"),
        ("DEFINITION", "DEFINITION", "PROVED", "DEFINITION"),
    ),
    "said of the case, behind it": (
        (*BEAM, RIGHT, *MIDDLE, "#Then", r"Aa=F\frac l4"),
        ("DEFINITION", "DEFINITION", "PROVED", "DEFINITION", "PROVED"),
    ),
    "refuted by a later case": ((*CAGE, *AT_REST), ("DEFINITION", OPEN, "DEFINITION")),
    "a special position accuses no loop before it": (
        (*LOOP[:3], "#At the dead centres", r"\sin\varphi=0"),
        ("DEFINITION", "DEFINITION", "DEFINITION"),
    ),
    "what is not read may say anew": (
        (HARMONIC, "#The other law is", UNREAD, "#with", SLOPE),
        ("DEFINITION", "not read", OPEN),
    ),
    "a derivative of another law": (
        ("#The harmonic law is", HARMONIC, "#The parabolic law has the velocity", r"s'=2h\theta"),
        ("DEFINITION", OPEN),
    ),
    "a derivative of the law": (
        ("#The harmonic law is", HARMONIC, "#This law has the velocity", r"s'=2h\theta"),
        ("DEFINITION", "REFUTED"),
    ),
    "a derivative of the law before": (
        ("#The harmonic law is", HARMONIC, *PARABOLIC, r"s'=2h\theta"),
        ("DEFINITION", OPEN, "PROVED"),
    ),
    "a wrong derivative of the law before": (
        ("#The harmonic law is", HARMONIC, *PARABOLIC, r"s'=h\theta"),
        ("DEFINITION", OPEN, "REFUTED"),
    ),
    "the velocity of another": (
        (*PISTON, "#The velocity of the second pin is", OTHER_SPEED),
        ("DEFINITION", OPEN),
    ),
    "a second derivative is of no other": (
        (
            *PISTON,
            "#The second derivative is",
            r"\ddot x=r\dot\varphi^2\cos\varphi-r\ddot\varphi\sin\varphi",
        ),
        ("DEFINITION", "REFUTED"),
    ),
    "a derivative printed anew": (
        (HARMONIC, "#The velocity", SLOPE, "#and the return has", RETURN),
        ("DEFINITION", "PROVED", OPEN),
    ),
    "a derivative that follows": (
        (HARMONIC, "#The velocity", SLOPE, "#and therefore", RETURN),
        ("DEFINITION", "PROVED", "REFUTED"),
    ),
    "a case first, then all": (
        ("#First let it stand in the middle,", r"a=\frac l2", "#In general", *BEAM[1:], WRONG),
        ("DEFINITION", "DEFINITION", "DEFINITION", OPEN),
    ),
    "a case to the end": (
        ("#Let it stand in the middle,", r"a=\frac l2", *BEAM, WRONG),
        ("DEFINITION", "DEFINITION", "DEFINITION", "PROVED"),
    ),
    "an item of a list may be another case": (
        ("k=k_1+k_2", r"#\item[(b)]", r"k=\frac{k_1k_2}{k_1+k_2}"),
        ("DEFINITION", OPEN),
    ),
    "a number before a display": (
        ("k=k_1+k_2", "#\n2.\n", r"k=\frac{k_1k_2}{k_1+k_2}"),
        ("DEFINITION", OPEN),
    ),
    "a consequence of the opposite": (
        (*IN_PARALLEL, "#Consequently, those in series have", r"k=\frac{k_1k_2}{k_1+k_2}"),
        ("DEFINITION", OPEN),
    ),
    "another thing": (
        ("#A solid disc has", "k=k_1+k_2", "#Hence a plate has", "k=k_1-k_2"),
        ("DEFINITION", OPEN),
    ),
    "another thing, which is said to follow": (
        ("#A disc has", "k=k_1+k_2", "#It follows from this that a thin plate has", "k=k_1-k_2"),
        ("DEFINITION", OPEN),
    ),
    "by symmetry": (
        ("#The left half has", "k=k_1+k_2", "#Hence by symmetry the right half has", "k=k_1-k_2"),
        ("DEFINITION", OPEN),
    ),
    "sides of an equation": (
        ("#The left side is", "k=k_1+k_2", "#Hence the right side is", "k=k_1-k_2"),
        ("DEFINITION", "REFUTED"),
    ),
    "a consequence of the same": (
        (*IN_PARALLEL, "#Consequently, parallel ones have", r"k=\frac{k_1k_2}{k_1+k_2}"),
        ("DEFINITION", "REFUTED"),
    ),
    "a consequence behind the opposite": (
        (*IN_PARALLEL, "#In series they differ,", "d>0", "#so that", "k=k_1-k_2"),
        ("DEFINITION", "DEFINITION", "REFUTED"),
    ),
    "a derivative of the opposite": (
        ("#The rise is", HARMONIC, "#The return has", RETURN, "#and during the fall", RETURN),
        ("DEFINITION", OPEN, OPEN),
    ),
    "letters that a case makes equal": (
        ("#The square has", "a=b", "#and the moment of the rectangle is", "M=Fa=Fb"),
        ("DEFINITION", "DEFINITION", OPEN),
    ),
    "letters that are equal by a law": (
        ("#The pin is held at", "x=l", "#and the moment is", "M=Fx=Fl"),
        ("DEFINITION", "DEFINITION", "PROVED"),
    ),
    "a letter that is zero in a case": (
        ("#Of the central one", "a=0", "#The offset one has", "M=F(b+a)=Fb"),
        ("DEFINITION", "DEFINITION", OPEN),
    ),
    "letters that are made equal, and a consequence": (
        ("#The square has", "a=b", "#and hence the moment", "M=Fa=Fb"),
        ("DEFINITION", "DEFINITION", "PROVED"),
    ),
    "a constraint that makes letters equal": (
        (*LOADED, "#The square has", "a=b", "#The rectangle has", r"A=F\frac{a+b}l=2F\frac al"),
        ("DEFINITION", "DEFINITION", "DEFINITION", "DEFINITION", OPEN),
    ),
    "a constraint that makes letters equal, and a consequence": (
        (*LOADED, "#The square has", "a=b", "#so that", r"A=F\frac{a+b}l=2F\frac al"),
        ("DEFINITION", "DEFINITION", "DEFINITION", "DEFINITION", "PROVED"),
    ),
    "what follows later may have the misprint itself": (
        ("M=Fa=Gb", "#Hence the other force is", r"G=\frac{2Fa}b"),
        ("DEFINITION", OPEN, "DEFINITION"),
    ),
    "what defines a letter is no misprint": (
        ("M=Fa=Gb", "#where", r"G=\frac{2Fa}b"),
        ("DEFINITION", "REFUTED", "DEFINITION"),
    ),
    "no words": (("k=k_1+k_2", r"k=\frac{k_1k_2}{k_1+k_2}"), ("DEFINITION", "REFUTED")),
    "the condition of a case that is not declared": (
        ("A=FD", "#It slips if", "a<0"),
        ("DEFINITION", OPEN),
    ),
    "a condition that is said of all": (("A=FD", "#Here", "a<0"), ("DEFINITION", "REFUTED")),
    "nothing is said anew": ((HARMONIC, "#with", SLOPE), ("DEFINITION", "PROVED")),
    "what is not read is of another letter": (
        (HARMONIC, UNREAD.replace("s=", "A="), "#with", SLOPE),
        ("DEFINITION", "not read", "PROVED"),
    ),
    "it stands behind": (
        (HARMONIC, "#with", SLOPE, UNREAD),
        ("DEFINITION", "PROVED", "not read"),
    ),
    "a case is set before the consequence": (
        (*PULLEY, "#A loose one hangs in two ropes. It follows that", r"F=\frac G2"),
        ("DEFINITION", OPEN),
    ),
    "a consequence": (
        (*PULLEY, "#It follows that", r"F=\frac G2"),
        ("DEFINITION", "REFUTED"),
    ),
    "what letters mean stands before the consequence": (
        ("k=k_1+k_2", r"#where $k_1$ is the first. Hence", r"k=k_1\left(1+\frac{k_1}{k_2}\right)"),
        ("DEFINITION", "REFUTED"),
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", PAPERS)
def test_rows_beside_later_cases_have_their_outcome(name: str) -> None:
    parts, expected = PAPERS[name]
    assert judge_parts(BLOCK.replace("@", "(t)"), *parts) == [*expected]


judge_speed = partial(judge_parts, BLOCK.replace("@", ""), *LOOP)


@pytest.mark.slow
@pytest.mark.parametrize("wrong", ["", r"\cos\beta"])
def test_what_has_to_move_and_is_not_said_to_is_named(wrong: str) -> None:
    speed = SPEED.replace(r"\tan\beta", wrong or r"\tan\beta")
    assert judge_speed(speed)[-1] == OPEN
    moving = judge_parts(BLOCK.replace("@", "(t)"), *LOOP, speed)
    assert moving[-1] == ("REFUTED" if wrong else "PROVED")


def test_an_angle_that_need_not_move_is_constant() -> None:
    still = (r"x=r\cos(\varphi+\delta)", r"\dot x=-r\dot\varphi\sin(\varphi+\delta)")
    assert judge_parts(BLOCK.replace("@", "(t)"), *still) == ["DEFINITION", "PROVED"]


ROOTS = r"""%% mechproof
%% m ; b ; k : numbers {b>0}
%% T : period
%% p ; q : roots
%% c ; u ; v ; x : numbers
%% factor c
%% end
If both are real
$$p=\frac{-b+\sqrt{b^2-4mk}}{2m}$$
$$q=\frac{-b-\sqrt{b^2-4mk}}{2m}$$
Hence
$$u+c=x$$
$$up+cq=v$$
$$c(q-p)=v-px$$
The body with less damping has
$$b=2m\sqrt{\frac km-\frac{4\pi^2}{T^2}}$$
"""


@pytest.mark.slow
@pytest.mark.parametrize(("sign", "outcome"), [("-", "PROVED"), ("+", "DEFINITION")])
def test_a_later_case_in_which_letters_have_no_values_is_left_out(sign: str, outcome: str) -> None:
    row = check("paper.tex", ROOTS.replace("v-px", f"v{sign}px")).rows[4]
    assert row.outcome == outcome
    assert row.reason.endswith("does not rest on display 6") == (outcome == "PROVED")


LIFT = "%% mechproof\n%% x ; a ; z : numbers {a>0}\n%% y(x) ; w(x) : lifts [1]\n%% end\n"
FLAT = ("w=y+1", "#In the special case of a flat follower,", "y=ax^2")


@pytest.mark.parametrize(
    ("words", "value", "outcome"),
    [
        # The law of the case is put into the integral, which nothing can then be judged without.
        ("#In general,", r"z=\int_0^1 y\,dx=\frac a2", "not judged"),
        ("#In general,", r"z=\int_0^1 w\,dx=\frac a2", "not judged"),
        ("#In general,", r"z=\int_0^1 ax\,dx=\frac a3", "REFUTED"),
        ("#", r"z=\int_0^1 y\,dx=\frac a2", "REFUTED"),
        ("#", r"z=\int_0^1 y\,dx=\frac a3", "PROVED"),
    ],
)
def test_an_integral_rests_on_the_law_of_a_case(words: str, value: str, outcome: str) -> None:
    row = judge_rows(LIFT, *FLAT, words, value)[-1]
    assert row.outcome == outcome
    assert "this does not rest on" not in row.reason
