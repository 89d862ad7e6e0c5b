"""Domains that constrain a statement through letters it does not contain, and empty ones."""

from __future__ import annotations

from typing import Any

import pytest
from weights import make_thorough

from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

N = ("n",)
NM = ("n", "m")
ANY = "2x=x+x"


def judge(latex: str, where: tuple[str, ...], natural: tuple[str, ...] = ()) -> Verdict:
    return judge_pasted(Pasted(latex, where=where, natural=natural)).judgements[0].verdict


TRUE = [
    # Through a real letter, a family's bound, another count.
    (r"n!\ge2^n", ("n>p", "p>5"), N),
    (r"\sum_{k=1}^na_k<0", ("a_k<b", "b<0"), ()),
    ("(-1)^n=1", (r"n\ge2m", r"n\le2m"), NM),
    ("|n-3|=n-3", ("n>p", "p>3"), N),
    # Chains of strict and weak inequalities down to a number.
    ("|x-1|=x-1", ("x>y", "y>z", "z>1"), ()),
    ("|n-9|=n-9", (r"n\ge m", r"m\ge q", "q>8"), NM),
    ("n>30", ("n>p", "p>q", "q>30"), N),
    ("n^2>1000", ("n>p", "p>q", "q>40"), N),
    (r"\sqrt{x^2}=x", ("x>2y", "y>3z", "z>1"), ()),
    ("x<1", (r"x<\frac y2", r"y\le z", "z<2"), ()),
    # Circular inequalities that imply equalities.
    ("2x=2y", (r"x\le y", r"y\le x"), ()),
    ("2x=2z", (r"x\le y", r"y\le z", r"z\le x"), ()),
    ("2n=2m", (r"n\le m", r"m\le n"), NM),
    ("|x-2|=0", (r"x\le y", r"y\le2", r"x\ge2"), ()),
    ("2n=4", (r"n\le p", "p<3", r"n\ge q", "q>1"), N),
    # Through nonlinear relations.
    ("n>30", ("n^2>p", "p>1000"), N),
    ("|x|<1", ("x^2+y^2<1",), ()),
    (r"x<\frac12", ("x<y^2", r"y^2<\frac12", "y>0"), ()),
    ("n>7", (r"n>\sqrt p", "p>50"), N),
    (r"n\ge m", (r"n^2\ge m^2",), NM),
    ("n!>100", ("2n>p", r"p\ge9"), N),
    ("x>0", ("x>y", r"y>\sin z", r"\sin z>0"), ()),
    (r"x\ge1", ("x>y", r"y>\ln z", r"z>\mathrm{e}"), ()),
    # Families bounded by other families or letters.
    (r"\sum_{k=1}^2a_k<0", ("a_k<b_k", "b_k<0"), ()),
    (r"\sum_{k=1}^3a_k>3", ("a_k>c", "c>1"), ()),
    (r"a_1<a_2", (r"a_1<b", "b<a_2"), ()),
    (r"\sum_{k=1}^2a_k^2>0", (r"a_k\ge b", "b>c", "c>0"), ()),
]
FALSE = [
    ("n!>3^n", ("n>p", "p>5"), N),
    (r"\sum_{k=1}^3a_k<-50", ("a_k<b", "b<0"), ()),
    ("(-1)^n=-1", (r"n\ge2m", r"n\le2m"), NM),
    ("|n-3|=n-4", ("n>p", "p>3"), N),
    ("|x-1|=x", ("x>y", "y>z", "z>1"), ()),
    ("n<30", ("n>p", "p>q", "q>30"), N),
    ("3x=2y", (r"x\le y", r"y\le x"), ()),
    ("3n=2m", (r"n\le m", r"m\le n"), NM),
    (r"x<\frac14", ("x<y^2", r"y^2<\frac12", "y>0"), ()),
    (r"\sum_{k=1}^3a_k>0", ("a_k<b_k", "b_k<0"), ()),
]
FAR = [
    # False only far from zero.
    (r"\max(x,-10^9)=x", (), ()),
    (r"\min(x,10^9)=x", (), ()),
    ("|x+5000|=x+5000", (), ()),
    (r"\max(x,-10^9y)=x", (), ()),
    (r"\sqrt{(x-777)^2}=777-x", (), ()),
    (r"\operatorname{sgn}(x+2000)=1", (), ()),
    ("n<100", (), N),
    ("n^2<10^6", (), N),
    # A whole power of -1 is a real number, whatever SymPy says.
    (r"(-1)^{\frac{n(n+1)}2}=1", (), N),
    (r"(-1)^{\frac{n(n+1)}2}<1", (), N),
    # Domains that no rational relation describes.
    ("|x|=x", (r"\sin x>0",), ()),
    (r"\min(x,1)=x", (r"\max(x,1)>2",), ()),
    ("|x|=x", (r"\max(x,-x)>x",), ()),
    ("|x|=x", ("|x-2|<3",), ()),
]
MEANT = [
    (r"(-1)^{\frac{n(n+1)}2}=(-1)^{\frac{n(n-1)}2}(-1)^n", (), N),
    (r"(-1)^{\frac{n(n+1)}2}\le1", (), N),
    (r"|\sin x|=\sin x", (r"\sin x>0",), ()),
    (r"\max(x,1)=x", (r"\max(x,1)>2",), ()),
    (r"\min(x,1)=x", (r"\min(x,1)<\frac12",), ()),
    ("x^2>1", (r"\max(x,-x)>1",), ()),
    (r"\sqrt x<3", (r"\sqrt x<2",), ()),
    ("|x|=x", ("|x-2|<1",), ()),
    ("x^2=1", (r"x\le1", r"x\ge1"), ()),
]
EMPTY = [
    ("y=1", (), ("y<0",), ("y=x^2",)),
    ("y=1", (), ("y<-1",), (r"y=\sin x",)),
    ("y=1", (), ("y>0", "y<z", "z<0"), ("y=x+1",)),
    (ANY, (), ("y<z", "z<y"), ()),
    (ANY, (), ("y>z+1", "z>y+1"), ()),
    (ANY, (), ("x>y", "y>z", "z>x"), ()),
    (ANY, N, ("n>p", "p>3", "n<4"), ()),
    (ANY, N, (r"n<p", "p<1"), ()),
    (ANY, NM, ("n>m", "n<m+1"), ()),
    (ANY, (), ("x^2+y^2<0",), ()),
    (ANY, (), ("z>2", "y<3"), (r"z=\sqrt y",)),
    (r"\sum_{k=1}^na_k\ge0", (), (r"a_k^2\le b", "b<0"), ()),
    (r"\sum_{k=1}^2a_k<0", (), ("a_k<b", "b<0", "a_k>0"), ()),
]


# Some of several similar domains are judged only with the thorough tests.
LONG = ("|n-9|=n-9", "n^2>1000", "n>30", "2x=2z", r"\sum_{k=1}^na_k<0")


def spared(cases: list[Any]) -> list[Any]:
    return [make_thorough(case) if case[0] in LONG else case for case in cases]


@pytest.mark.slow
@pytest.mark.parametrize(("latex", "where", "natural"), spared(TRUE + MEANT))
def test_a_true_statement_is_not_refuted_outside_its_domain(
    latex: str, where: tuple[str, ...], natural: tuple[str, ...]
) -> None:
    assert judge(latex, where, natural) is not Verdict.REFUTED


@pytest.mark.slow
@pytest.mark.parametrize(("latex", "where", "natural"), FALSE + FAR)
def test_a_false_statement_is_refuted_inside_its_domain(
    latex: str, where: tuple[str, ...], natural: tuple[str, ...]
) -> None:
    assert judge(latex, where, natural) is Verdict.REFUTED


@pytest.mark.parametrize(("latex", "natural", "where", "values"), EMPTY)
def test_an_empty_domain_is_an_error_whatever_is_stated(
    latex: str, natural: tuple[str, ...], where: tuple[str, ...], values: tuple[str, ...]
) -> None:
    with pytest.raises(ValueError, match=r"is it empty\?|is empty|leaves no value"):
        judge_pasted(Pasted(latex, where=where, natural=natural, values=values))
