"""Single equations: e, i and d, which might not be letters, and letters that have values."""

from __future__ import annotations

import pytest

from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

PROVED, REFUTED = Verdict.PROVED, Verdict.REFUTED

# A print, the values and the conditions given for its letters, and its verdict.
ROWS = [
    (r"e^x\ge1+x", (), (), PROVED),
    (r"e^x\ge1+x+x^2", (), (), REFUTED),
    (r"\int_0^1e^x\,dx=e-1", (), (), PROVED),
    (r"\frac d{dx}e^{-x^2}=-2xe^{-x^2}", (), (), PROVED),
    (r"\ln e^x=x", (), (), PROVED),
    # An e next to running powers or factorials is Euler's number if nothing else is free.
    (r"\lim_{n\to\infty}\left(1+\frac1n\right)^n=e", (), (), PROVED),
    (r"\lim_{x\to0}(\cos x)^{1/x^2}=e^{-1/2}", (), (), PROVED),
    (r"\lim_{x\to0}(1+2x)^{1/x}=e", (), (), REFUTED),
    (r"\sum_{k=0}^\infty\frac{(-1)^k}{k!}=\frac1e", (), (), PROVED),
    # So is one up to which a logarithm is integrated.
    (r"\int_1^e\frac{dx}x=1", (), (), PROVED),
    (r"\int_1^e\ln x\,dx=e-1", (), (), REFUTED),
    # Likewise in a given value.
    (r"\ddot x=x", ("x=e^{-t}",), (), PROVED),
    (r"\ddot x=-x", ("x=e^{-t}",), (), REFUTED),
    (
        r"\ddot x+2\delta\dot x+(\delta^2+\omega^2)x=0",
        (r"x=e^{-\delta t}(A\cos\omega t+B\sin\omega t)",),
        (),
        PROVED,
    ),
    (
        r"\ddot x+2\delta\dot x+(\delta^2-\omega^2)x=0",
        (r"x=e^{-\delta t}(A\cos\omega t+B\sin\omega t)",),
        (),
        REFUTED,
    ),
    # An e is a letter if it is integrated or differentiated over, or tends to a number.
    (r"\int_0^1e\,de=\frac12", (), (), PROVED),
    (r"\frac d{de}(1-e^2)=-2e", (), (), PROVED),
    (r"\lim_{e\to0}\frac{1-\sqrt{1-e^2}}{e^2}=\frac12", (), (), PROVED),
    (r"\lim_{e\to0}\frac{1-\sqrt{1-e^2}}{e^2}=1", (), (), REFUTED),
    # So is a letter that a condition bounds by numbers.
    (
        r"1-e\cos E=\frac{1-e^2}{1+e\cos\nu}",
        (r"\nu=2\arctan\left(\sqrt{\frac{1+e}{1-e}}\tan\frac E2\right)",),
        (r"0\le e<1", r"-\pi<E<\pi"),
        PROVED,
    ),
    (r"(1+e)^2\ge1", (), (r"0\le e<1",), PROVED),
    (r"(1+e)^2>1", (), (r"0\le e<1",), REFUTED),
    (r"i^2>0", (), ("i>0",), PROVED),
    (r"\int_0^1xd\,\mathrm dx=\frac d2", (), ("x>0,d>0",), PROVED),
    # An e with a given value is a letter; so is a d that forms no differential.
    (r"e^x=2^x", ("e=2",), (), PROVED),
    (r"\frac{\pi D^2}4-\frac{\pi d^2}4=\frac\pi4(D-d)(D+d)", (), (), PROVED),
    (r"\frac d2+\frac d2=d", (), (), PROVED),
    (r"\frac n{n+1}<1\quad(n\in\mathbb N)", (), (), PROVED),
    (r"|\sin x|\le1,\quad x\in\mathbb{R}", (), (), PROVED),
    (r"|\sin x|<1\quad(x\in\mathbb{R})", (), (), REFUTED),
    (r"\sin(\pi n)=0", (), (r"n\in\mathbb N",), PROVED),
    (r"\int_0^\pi\cos(nx)\,dx=0", (), (r"n\in\mathbb N",), PROVED),
    (r"\int_0^\pi\cos(nx)\,dx=0", (), (r"n\in\mathbb N_0",), REFUTED),
    (r"\cos(m\pi)\cos(n\pi)=(-1)^{m+n}\text{ for }m,n\in\mathbb{N}", (), (), PROVED),
    # The gamma function, where it has values.
    (r"\Gamma\left(\frac12\right)=\sqrt\pi", (), (), PROVED),
    (r"\Gamma(n+1)=n!", (), (), PROVED),
    (r"\Gamma(n)=n!", (), (), REFUTED),
    (r"\Gamma(x+1)=x\Gamma(x)", (), ("x>0",), PROVED),
    (r"\Gamma(x+1)=x\Gamma(x)", (), (), Verdict.UNDECIDED),
    (r"\Gamma(x+1)=\Gamma(x)", (), ("x>0",), REFUTED),
    (r"\Gamma(x)\Gamma(1-x)=\frac\pi{\sin\pi x}", (), ("0<x<1",), PROVED),
    (r"\Gamma(x)\Gamma(1-x)=\frac\pi{\cos\pi x}", (), ("0<x<1",), REFUTED),
    (r"\int_0^\infty t^{x-1}e^{-t}\,dt=\Gamma(x)", (), ("x>0",), PROVED),
    (r"\int_0^\infty t^{x-1}e^{-t}\,dt=\Gamma(x)", (), (), Verdict.UNDECIDED),
    # An expression given for a letter has a real value.
    (r"|x|\le R", (r"y=\sqrt{R^2-x^2}",), ("R>0",), PROVED),
    (r"|x|\le R-1", (r"y=\sqrt{R^2-x^2}",), ("R>0",), REFUTED),
    (r"x\ge1", (r"t=\ln(x-1)",), (), PROVED),
    (r"x\ge2", (r"t=\ln(x-1)",), (), REFUTED),
    (r"x\ne0", (r"y=\frac1x",), (), PROVED),
    (r"|x|=x", (r"y=\sqrt x",), (), PROVED),
    (r"|x|=x", (r"y=\sqrt[3]x",), (), REFUTED),
]


@pytest.mark.parametrize(("latex", "values", "where", "verdict"), ROWS)
def test_a_letter_is_what_it_is_taken_for(
    latex: str, values: tuple[str, ...], where: tuple[str, ...], verdict: Verdict
) -> None:
    (judgement,) = judge_pasted(Pasted(latex, values=values, where=where)).judgements
    assert judgement.verdict is verdict


def test_what_an_e_is_taken_for_is_told() -> None:
    assert judge_pasted(Pasted(r"e^x>0")).taken["e"] == "Euler's number"


# An e that may be Euler's number: it bounds a letter, or is alone on one side.
OPEN = [
    (r"\ln x>1", (), ("x>e",)),
    (r"e=\lim_{x\to0}\frac{\sin x}x", (), ()),
    (r"\sum_{k=1}^n2^k=e", (), ()),
    (r"\lim_{x\to0}(1+2x)^{1/x}=e", ("e",), ()),
    (r"e=\frac{\sqrt{a^2-b^2}}a", ("e",), ()),
]


@pytest.mark.parametrize(("latex", "names", "where"), OPEN)
def test_both_ways_to_print_an_e_are_told(
    latex: str, names: tuple[str, ...], where: tuple[str, ...]
) -> None:
    with pytest.raises(ValueError, match=r"Print \\mathrm\{e\} for.* (?:--name 'e'|by --let)"):
        judge_pasted(Pasted(latex, names=names, where=where))
