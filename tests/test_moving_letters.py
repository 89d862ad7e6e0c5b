"""Letters of a single equation that depend on others: u with u', dotted letters, f(x)."""

from __future__ import annotations

import pytest

from mechproof.latex import ReadingError
from mechproof.pipeline.moving_letters import find_functions
from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

# A print, an insertion that makes it true, and one that makes it false.
PAIRS = [
    (r"(uv)'=%s", "u'v+uv'", "u'v'"),
    (r"(uv)''=%s", "u''v+2u'v'+uv''", "u''v+u'v'+uv''"),
    (r"\left(\frac uv\right)'=%s", r"\frac{u'v-uv'}{v^2}", r"\frac{u'v+uv'}{v^2}"),
    (r"(e^u)'=%s", "u'e^u", "u'e^{u'}"),
    (r"(x^3\sin x)'=%s", r"3x^2\sin x+x^3\cos x", r"3x^2\cos x"),
    (r"\frac{d}{dt}(m\dot x^2+2mgx)=%s", r"2m\dot x\ddot x+2mg\dot x", r"2m\dot x\ddot x"),
    ("(ay)'=%s", "ay'", "yy'"),
    ("(tu)'=%s", "u+tu'", "tu'"),
    (r"(r\cos\varphi)'=%s", r"-r\sin\varphi", r"r\sin\varphi"),
    (r"\frac{d}{dx}(u(x)v(x))=%s", "u'(x)v(x)+u(x)v'(x)", "u'(x)v'(x)"),
    (r"\frac{d}{dx}f(x)^2=%s", "2f(x)f'(x)", "2f(x)"),
    (r"\frac{d}{dt}(x\dot x)=%s", r"\dot x^2+x\ddot x", r"\dot x^2+x\dot x"),
    (r"d(x\dot x)/dt=%s", r"\dot x^2+x\ddot x", r"\dot x^2+x\dot x"),
    (r"\frac{d}{dt}\left(\frac12mv^2\right)=%s", r"mv\dot v", r"m\dot v"),
    (r"\frac{d}{dt}\left(\frac12m\dot x^2\right)=%s", r"m\dot x\ddot x", r"m\ddot x"),
    (
        r"\frac{d^2}{dt^2}(r\cos\varphi)=%s",
        r"-r\ddot\varphi\sin\varphi-r\dot\varphi^2\cos\varphi",
        r"-r\ddot\varphi\sin\varphi",
    ),
    ("(xu)'=%s", "x'u+xu'", "x'u+u+xu'"),
    ("(x^2+y^2)'=%s", "2xx'+2yy'", "2x+2y"),
    (
        r"\frac{d}{dt}(\dot x_1\dot x_2)=%s",
        r"\ddot x_1\dot x_2+\dot x_1\ddot x_2",
        r"\ddot x_1\ddot x_2",
    ),
    (r"f(x)=x^2\Rightarrow f'(x)=%s", "2x", "3x"),
    # With respect to the letter of the derivative that appears next to them.
    (r"\frac{d}{d\varphi}(r\cos\varphi)=%s", r"r'\cos\varphi-r\sin\varphi", r"r'\cos\varphi"),
    (r"\frac{d}{d\varphi}(rr'\varphi)=%s", r"rr'+(r'^2+rr'')\varphi", "rr'"),
    (r"\frac{d}{dz}(uv)=%s", "u'v+uv'", "u'v-uv'"),
    (r"\frac{d}{dt}(x^2u)=%s", "2xx'u+x^2u'", "2xx'u-x^2u'"),
    # A power whose exponent is a letter.
    ("(u^n)'=%s", "nu^{n-1}u'", "nu^{n+1}u'"),
    ("(u^n)''=%s", "n(n-1)u^{n-2}u'^2+nu^{n-1}u''", "n(n-1)u^{n-2}u'^2"),
]
REFUSED = [
    # Other arguments of the function, or another letter; constants next to rates; no letter that a
    # prime could refer to.
    "f(x)=f(-x)",
    "f(x)f(t)=1",
    "f(x)=1",
    "(uv)'=u'v",
    "(u+v)'=u'",
    r"\frac{d}{dt}(xy)=\dot xy",
    r"\frac{d}{dx}(u(x)v)=u'(x)v",
    "f(x)=f(x)",
    r"f'(x)+f_0=f_0+f'(x)",
    "a(x)=ax",
    r"\frac{d}{dt}(\dot x)=0",
    r"(\ln u)'=\frac1u",
    r"(r\cos\varphi)'=r'\cos\varphi-r\sin\varphi",
    r"(\cos\alpha\cos\varphi)'=-\cos\alpha\sin\varphi",
    # Functions of a letter that depends on another; integrals, limits and partial derivatives of
    # moving letters; dots together with primes.
    r"\frac{d}{dt}(f(x)\dot x)=f'(x)\dot x^2+f(x)\ddot x",
    r"\frac{\partial}{\partial x}(uv)=u'v+uv'",
    r"\int_0^1xu'\,dx=\frac{u'}2",
    r"\int_0^T t\dot x\,dt=\frac{T^2}2\dot x",
    r"\lim_{x\to0}u'=u'",
    r"\frac{d}{dt}(\dot u^2+u'^2)=2u'\ddot u",
    # Other letters that may move too.
    "(pu)'=pu'",
    "(py')'=py''",
    "(y_1y_2')'=y_1y_2''",
    r"\frac{d}{dt}(x_1\dot x_2)=x_1\ddot x_2",
    r"\frac{d}{dt}(x_1t+\dot x_2)=x_1+\ddot x_2",
    r"\frac{d}{dt}(\alpha\dot\beta)=\alpha\ddot\beta",
    r"\frac{d}{dx}(pf(x))=pf'(x)",
    r"\frac{d}{dt}(\dot x_1\dot x_2)=\ddot x_1\dot x_2",
    # With respect to another letter than the derivatives next to it, or to one of several.
    r"\frac{d}{d\varphi}(r'\varphi)=r'",
    r"\frac{d}{d\xi}(u'\xi)=u'",
    r"\frac{d}{ds}(u'vs)=u'v",
    r"\frac{d}{du}(uu')=u'",
    r"\frac{d}{dx_1}(x_1u')=u'",
    r"\frac{d}{dx}(x\dot y)=\dot y",
    r"\frac{d}{dt}(x^2u)=2xu+x^2u'",
    r"\frac{d}{d\varphi}(u\cos\varphi)=xu'\cos\varphi-u\sin\varphi",
    r"\frac{d}{d\alpha}\frac{d}{d\beta}(u\cos\alpha\cos\beta)=-u'\sin\alpha",
]


def judge(latex: str) -> Verdict:
    (found,) = judge_pasted(Pasted(latex)).judgements
    return found.verdict


@pytest.mark.parametrize(("latex", "true", "wrong"), PAIRS)
def test_what_depends_on_another_letter_is_differentiated(
    latex: str, true: str, wrong: str
) -> None:
    assert judge(latex % true) is Verdict.PROVED
    assert judge(latex % wrong) is Verdict.REFUTED


@pytest.mark.parametrize("latex", REFUSED)
def test_what_is_not_said_is_asked_for(latex: str) -> None:
    with pytest.raises((ReadingError, ValueError)):
        judge(latex)


def test_what_depends_on_the_letter_is_asked_for() -> None:
    with pytest.raises(ReadingError, match="the derivatives of the letters that depend on it"):
        judge(r"(\ln u)'=\frac1u")


def test_a_letter_that_is_said_to_be_a_factor_is_no_function() -> None:
    assert find_functions(["u'(x)=v'(x)"], ["v"]) == {"u": "x"}
    (found,) = judge_pasted(Pasted("f(x)=xf", factors=("f",))).judgements
    assert found.verdict is Verdict.PROVED


def test_it_is_told_what_depends_on_what() -> None:
    taken = judge_pasted(Pasted(r"\frac{d}{dt}(mv^2)=2mv\dot v")).taken
    assert (taken["m"], taken["v"]) == ("real, a constant", "real, depends on t")
