"""Prints with a double sign: both values are roots of a constraint, or one of them holds."""

from __future__ import annotations

import pytest

from mechproof.document.checking import check

pytestmark = pytest.mark.usefixtures("judged_here")

BLOCK = r"""%% mechproof
%% E ; F ; G ; T ; c ; x ; y ; x_{1,2} : numbers
%% a ; b : numbers {a>0, b>0}
%% q ; p ; q_1 ; q_2 : angles [rad]
%% y_1 ; y_2 ; v_1 ; v_2 ; v_{1,2} : numbers
%% z_1 ; z_2 : numbers {z_1>0, z_2>0}
%% end
"""
ROOTS = r"T=\frac{-F\pm\sqrt{E^2+F^2-G^2}}{G-E}"
WAVE = r"E\cos q+F\sin q+G=0"
HALF = r"T=\tan\frac q2"
QUADRATIC = r"ax^2+bx+c=0"
TWO = r"x=\frac{-b\pm\sqrt{b^2-4ac}}{2a}"
FOR_Y = QUADRATIC.replace("x", "y")
BOTH = TWO.replace("x", "y_{1,2}")
ROOT = r"\sqrt{E^2+F^2-G^2}"
RADIUS = r"\sqrt{E^2+F^2}"
REACH = (r"x=a\cos p+b\cos(p+q)", r"y=a\sin p+b\sin(p+q)")
ELBOW = "x^2+y^2-a^2-b^2"
SHOULDER = "x^2+y^2+a^2-b^2"
# The prints before, a print, and its outcome.
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
    # Two misprints at once are not accused; without a constraint nothing is known.
    ((QUADRATIC,), r"x=\frac{b\pm\sqrt{b^2+4ac}}{2a}", "not judged"),
    ((), r"x=a\pm\sqrt b", "DEFINITION"),
    # With a range printed after it, it does not define the letter.
    ((), r"q=\arccos(a\pm b)\qquad0\le q\le\pi", "not read"),
    ((), r"q=\arccos(a\pm b)\qquad0\le x\le1", "not read"),
    # Two letters at once that are the two roots.
    ((QUADRATIC,), r"x_{1,2}=\frac{-b\pm\sqrt{b^2-4ac}}{2a}", "PROVED"),
    ((QUADRATIC,), r"x_{1,2}=\frac{-b\pm\sqrt{b^2-4ac}}{a}", "REFUTED"),
    # Of two prints, the first does not rest on the second.
    ((r"x=a\pm\sqrt b",), r"x=\sqrt b\left(\frac a{\sqrt b}\pm1\right)", "PROVED"),
    # In a chain, the first member gives the two values; the others must hold with both signs.
    ((QUADRATIC,), rf"{TWO}=\frac{{2c}}{{-b\mp\sqrt{{b^2-4ac}}}}", "PROVED"),
    ((QUADRATIC,), rf"{TWO}=\frac{{2c}}{{b\mp\sqrt{{b^2-4ac}}}}", "REFUTED"),
    # With its signs the other way round, a member has the same two values.
    ((QUADRATIC,), rf"{TWO}=\frac{{2c}}{{-b\pm\sqrt{{b^2-4ac}}}}", "not judged"),
    ((r"(a-b)^2x^2=1",), r"x=\pm\frac1{a-b}=\pm\frac1{b-a}", "not judged"),
    ((), r"q=\pm\arccos(-T)=\pi\mp\arccos T", "PROVED"),
    ((), r"q=\pm\arccos(-T)=\pi\mp\arcsin T", "REFUTED"),
    # A correction may make the print satisfy the constraint.
    ((r"x^2+2Tx+c=0",), r"x=T\pm\sqrt{T^2-c}", "REFUTED"),
    ((QUADRATIC,), rf"{TWO}=c", "not read"),
    ((QUADRATIC,), r"x=\frac{-b\mp\sqrt{b^2-4ac}}{2a}", "PROVED"),
    # Left sides that are not letters: the tangent of a half angle, or a term with two values.
    ((WAVE,), ROOTS.replace("T", r"\tan\frac q2"), "PROVED"),
    ((WAVE,), ROOTS.replace("T", r"\tan\frac q2").replace("-G^2", "+G^2"), "REFUTED"),
    ((WAVE,), rf"\cos q=\frac{{-EG\pm F{ROOT}}}{{E^2+F^2}}", "PROVED"),
    ((WAVE,), rf"\cos q=\frac{{-EG\pm E{ROOT}}}{{E^2+F^2}}", "REFUTED"),
    ((), r"\sin q=\pm\sqrt{1-\cos^2q}", "PROVED"),
    ((), r"\sin q=\pm\sqrt{1+\cos^2q}", "REFUTED"),
    ((), r"x=\pm\sqrt{x^2}", "PROVED"),
    ((), r"\cos q=\pm\cos q", "not judged"),
    # Angles have one of two directions.
    ((WAVE,), rf"q=\operatorname{{atan2}}(F,E)\pm\arccos\frac{{-G}}{{{RADIUS}}}", "PROVED"),
    ((WAVE,), rf"q=\operatorname{{atan2}}(F,E)\mp\arccos\frac G{{{RADIUS}}}", "REFUTED"),
    ((WAVE,), rf"q=\operatorname{{atan2}}(E,F)\pm\arccos\frac{{-G}}{{{RADIUS}}}", "REFUTED"),
    ((WAVE,), r"q=\operatorname{atan2}(F,E)\pm\arccos\frac{-G}{E^2+F^2}", "REFUTED"),
    (REACH, rf"q=\pm\arccos\frac{{{ELBOW}}}{{2ab}}", "PROVED"),
    (REACH, rf"q=\pm\arcsin\frac{{{ELBOW}}}{{2ab}}", "REFUTED"),
    (REACH, rf"q=\pm\arccos\frac{{{ELBOW}}}{{ab}}", "REFUTED"),
    (
        REACH,
        rf"p=\operatorname{{atan2}}(y,x)\mp\arccos\frac{{{SHOULDER}}}{{2a\sqrt{{x^2+y^2}}}}",
        "PROVED",
    ),
    (
        REACH,
        rf"p=\operatorname{{atan2}}(y,x)\mp\arccos\frac{{{SHOULDER}}}{{2b\sqrt{{x^2+y^2}}}}",
        "REFUTED",
    ),
    # Without a double sign it is one of the two values, which may be meant for one case.
    (REACH, rf"q=\arccos\frac{{{ELBOW}}}{{2ab}}", "DEFINITION"),
    (REACH, r"p=\operatorname{atan2}(y,x)-\operatorname{atan2}(b\sin q,a+b\cos q)", "PROVED"),
    (REACH, r"p=\operatorname{atan2}(y,x)+\operatorname{atan2}(b\sin q,a+b\cos q)", "REFUTED"),
    (REACH, r"p=\operatorname{atan2}(y,x)-\operatorname{atan2}(b\sin q,a-b\cos q)", "REFUTED"),
    # Two letters at once: whichever has the upper sign, their sum and product are known.
    ((FOR_Y, BOTH), r"y_1+y_2=-\frac ba", "PROVED"),
    ((FOR_Y, BOTH), r"y_1+y_2=\frac ba", "REFUTED"),
    ((FOR_Y, BOTH), r"y_1y_2=\frac ca", "PROVED"),
    ((FOR_Y, BOTH), r"y_1y_2=-\frac ca", "REFUTED"),
    ((FOR_Y, BOTH.replace("4ac", "2ac")), r"y_1y_2=\frac ca", "DEFINITION"),
    ((r"y_{1,2}=a\pm b",), "(y_1-y_2)^2=4b^2", "PROVED"),
    ((r"y_{1,2}=a\pm b",), "(y_1-y_2)^2=b^2", "not judged"),
    ((r"y_{1,2}=a\pm b",), "y_1-y_2=2b", "DEFINITION"),
    ((r"y_{1,2}=a\pm b", "y_1+y_2=2a"), "y_1=a-b", "PROVED"),
    ((r"y_{1,2}=a\pm b", "y_1+y_2=2a"), "y_1=2a+b", "not judged"),
    ((FOR_Y, BOTH), BOTH.replace("{1,2}", "1").replace(r"\pm", "+"), "PROVED"),
    ((FOR_Y, BOTH), BOTH.replace("{1,2}", "1").replace(r"-b\pm", "b+"), "REFUTED"),
    ((r"z_{1/2}^2=a\pm b",), r"z_1z_2=\sqrt{a^2-b^2}", "PROVED"),
    ((r"y_{1/2}^2=a\pm b",), r"y_1y_2=\sqrt{a^2-b^2}", "DEFINITION"),
    ((r"z_{1,2}^2=a\pm b",), r"z_2=\sqrt{a-b}", "PROVED"),
    ((r"z_{1,2}^2=a\pm b",), r"z_2=\sqrt{2a-b}", "REFUTED"),
    # A double index on both sides, and a letter that the block itself declares with one.
    ((r"y_{1,2}=a\pm z_{1,2}",), "y_1+y_2=2a", "DEFINITION"),
    ((r"v_{1,2}=a\pm b",), "v_1+v_2=2a", "DEFINITION"),
    # Angles are known only up to whole turns.
    ((r"q_{1,2}=p\pm\arccos T",), "q_1+q_2=2p", "DEFINITION"),
    # The square is a root only where no odd power appears next to it.
    (("ax^4+bx^2+c=0",), TWO.replace("x", "x^2", 1), "PROVED"),
    (("ax^4+bx^2+c=0",), TWO.replace("x", "x^2", 1).replace("4a", "2a"), "REFUTED"),
    (("ax^4+bx+c=0",), TWO.replace("x", "x^2", 1), "not judged"),
    # A special position says nothing about the other positions.
    ((r"E\sin q=F\sin p", "q=-p"), r"q+p=\pi", "DEFINITION"),
]


@pytest.mark.slow
@pytest.mark.parametrize(("before", "latex", "outcome"), CASES)
def test_both_signs_are_judged(before: tuple[str, ...], latex: str, outcome: str) -> None:
    text = "".join(f"$${one}$$\n" for one in (*before, latex))
    *others, row = check("paper.tex", BLOCK + text).rows
    assert row.outcome == outcome, row.reason
    wrong = {one.latex for one in others if one.outcome == "REFUTED"}
    assert wrong == {one for one in before if "2ac" in one}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("words", "outcome"),
    [
        ("Hence", "REFUTED"),
        ("It has the roots", "REFUTED"),
        ("Its two solutions are, for any c,", "REFUTED"),
        ("In the other case", "not judged"),
        ("Now, measured clockwise,", "DEFINITION"),
    ],
)
def test_roots_of_another_case_are_not_accused(words: str, outcome: str) -> None:
    text = rf"$$ax^2+2bx+c=0$$ {words} $$x=\frac{{b\pm\sqrt{{b^2-ac}}}}a$$"
    assert check("paper.tex", BLOCK + text).rows[-1].outcome == outcome


@pytest.mark.slow
def test_roots_do_not_rest_on_another_arrangement_behind_them() -> None:
    text = r"$$x=\frac{b\pm\sqrt{b^2-ac}}a$$ In the second arrangement $$ax^2-2bx+c=0$$"
    assert check("paper.tex", BLOCK + text).rows[0].outcome == "DEFINITION"
    follows = text.replace("In the second arrangement", "and so")
    rows = check("paper.tex", BLOCK + follows).rows
    assert [row.outcome for row in rows] == ["DEFINITION", "PROVED"]


@pytest.mark.parametrize(
    ("latex", "outcomes"),
    [
        # One letter cannot be two complex numbers; an equation for either sign is read.
        (r"x=-b\pm i\sqrt{c-b^2}", ["not read"]),
        (r"e^{\pm ia}=\cos a\pm i\sin a", ["PROVED", "PROVED"]),
        (r"e^{\pm ia}=\cos a\mp i\sin a", ["PROVED", "not judged"]),
    ],
)
def test_double_signs_beside_the_imaginary_unit(latex: str, outcomes: list[str]) -> None:
    found = check("paper.tex", f"$$x^2+2bx+c=0$$ $${latex}$$ $$y=e^{{ia}}$$")
    assert [row.outcome for row in found.rows[1:-1]] == outcomes
    assert found.rows[0].outcome == "DEFINITION"
