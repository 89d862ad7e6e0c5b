"""Single equations with functions: a given one, such as f(x)=x^2, or an arbitrary f."""

from __future__ import annotations

import pytest

from mechproof.latex import ReadingError
from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

# A print, an insertion that makes it true, and one that makes it false.
ANY = [
    (r"\frac{d}{dx}\int_0^xf(t)\,dt=%s", "f(x)", "f'(x)"),
    (r"\frac{d}{dx}\int_x^{x^2}f(t)\,dt=%s", "2xf(x^2)-f(x)", "f(x^2)-f(x)"),
    (
        r"\frac{d}{dx}\int_0^x(x-t)f(t)\,dt=%s",
        r"\int_0^xf(t)\,dt",
        r"\int_0^x(x-t)f'(t)\,dt",
    ),
    (r"\frac{d}{dx}f(g(x))=%s", "f'(g(x))g'(x)", "f'(x)g'(x)"),
    (r"\frac{d}{dx}\ln f(x)=%s", r"\frac{f'(x)}{f(x)}", r"\frac{f(x)}{f'(x)}"),
    (r"\int_a^bu\,v'\,dx=%s", r"[uv]_a^b-\int_a^bu'v\,dx", r"[uv]_a^b+\int_a^bu'v\,dx"),
    (r"\int_0^1xf'(x)\,dx=%s", r"f(1)-\int_0^1f(x)\,dx", r"f(1)-f(0)"),
    (r"\int_a^bf(x)\,dx=%s", r"-\int_b^af(x)\,dx", r"\int_b^af(x)\,dx"),
    (r"\int_0^af(x)\,dx=%s", r"\int_0^af(a-x)\,dx", r"\int_0^af(-x)\,dx"),
    (r"\int_a^bf(g(x))g'(x)\,dx=%s", r"\int_{g(a)}^{g(b)}f(u)\,du", r"\int_a^bf(u)g(u)\,du"),
    (r"\int_a^bf(x)g(x)\,dx=%s", r"\int_a^cf(x)g(x)\,dx+\int_c^bf(x)g(x)\,dx", "f(b)g(b)"),
    (r"\lim_{h\to0}\frac{f(x+h)-f(x-h)}h=%s", "2f'(x)", "f'(x)"),
    (r"f(x)=f(0)+xf'(0)+%s", r"\int_0^x(x-t)f''(t)\,dt", r"\int_0^xtf''(t)\,dt"),
]
# Not true of all functions, or not everywhere defined, or a condition on the function.
NOT_PROVED = [
    r"\int_{-a}^af(x)\,dx=0",
    r"\int_0^1f(x)\,dx=1",
    r"\int_0^\infty f'(x)\,dx=-f(0)",
    r"\int_0^1\frac{f'(x)}x\,dx=\int_0^1\frac{f'(x)}x\,dx",
    r"\int_0^1f'(\ln x)\frac1x\,dx=\int_0^1f'(\ln x)\frac1x\,dx",
    r"\sum_{k=1}^n\int_0^kf(x)\,dx=n\int_0^nf(x)\,dx",
    r"\int_0^1f(x^2)\,dx=\int_0^1f(x)\,dx",
    r"\frac{d}{dx}f(x)=f'(x)+f(\sqrt x)-f(\sqrt x)",
    r"\frac{d}{dx}f(x)=f'(x)+\frac{f(x)-|f(x)|}{f(x)-|f(x)|}-1",
    r"\frac{d}{dx}\sqrt{f(x)^2}=f'(x)",
    r"\int_0^1f(\lfloor x\rfloor)\,dx=\int_0^1f(x)\,dx",
    r"\int_{-1}^1|f(x)|\,dx=\left|\int_{-1}^1f(x)\,dx\right|",
]
REFUSED = [
    r"\frac{d}{dx}(u(x)v)=u'(x)v",
    r"\int_0^1xu'\,dx=\frac{u'}2",
    r"\int_0^1pf(x)\,dx=p\int_0^1f(x)\,dx",
    "f(x+h)=f(x)",
]
# A print, the definition of the function, a true insertion and a false one.
SAID = [
    ("f(x+%s)=f(x)", (r"f(x)=\sin x+\cos2x",), r"2\pi", r"\pi"),
    ("f(f(x))=%s", (r"f(x)=\frac{1-x}{1+x}",), "x", "-x"),
    (r"f''(x)+%sf(x)=0", (r"f(x)=A\cos\omega x+B\sin\omega x",), r"\omega^2", r"\omega "),
    (r"\int_{-a}^af(x)\,dx=%s", (r"f(x)=x^3\cos x",), "0", "1"),
    (r"\dot x(0)=%s", (r"x(t)=vt\cos\omega t",), "v", r"v\omega"),
    ("f(g(x))=%s", ("f(x)=x^3", r"g(x)=\sqrt[3]{x}"), "x", "x^2"),
    (r"\frac{f(x+h)-f(x)}h=%s", ("f(x)=x^2",), "2x+h", "2x"),
]


def judge(latex: str, values: tuple[str, ...] = ()) -> Verdict:
    (found,) = judge_pasted(Pasted(latex, values=values)).judgements
    return found.verdict


@pytest.mark.parametrize(("latex", "true", "wrong"), ANY)
def test_what_is_true_of_any_function_is_proved(latex: str, true: str, wrong: str) -> None:
    assert judge(latex % true) is Verdict.PROVED
    assert judge(latex % wrong) is Verdict.REFUTED


@pytest.mark.parametrize("latex", NOT_PROVED)
def test_what_is_not_true_of_any_function_is_not_proved(latex: str) -> None:
    assert judge(latex) is not Verdict.PROVED


@pytest.mark.parametrize("latex", REFUSED)
def test_what_may_be_a_function_or_a_constant_is_asked_for(latex: str) -> None:
    with pytest.raises((ReadingError, ValueError)):
        judge(latex)


@pytest.mark.parametrize(("latex", "values", "true", "wrong"), SAID)
def test_a_function_that_is_said_is_put_in(
    latex: str, values: tuple[str, ...], true: str, wrong: str
) -> None:
    assert judge(latex % true, values) is Verdict.PROVED
    assert judge(latex % wrong, values) is Verdict.REFUTED
