"""Powers of matrices to the n-th: judged at the first n, and from each n to the next."""

from __future__ import annotations

import pytest

from mechproof.latex import ReadingError
from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict


def show(*rows: str) -> str:
    r"""Return the LaTeX of a matrix; commas separate the entries of a row."""
    inside = r"\\".join(row.replace(",", "&") for row in rows)
    return rf"\begin{{pmatrix}}{inside}\end{{pmatrix}}"


TURN = show(r"\cos\theta,-\sin\theta", r"\sin\theta,\cos\theta")
TURNED = show(r"\cos n\theta,-\sin n\theta", r"\sin n\theta,\cos n\theta")
SHEAR, ONES = show("1,1", "0,1"), show("1,1", "1,1")
PROVED = [
    (TURN, TURNED, ()),
    (SHEAR, show("1,n", "0,1"), ()),
    (SHEAR, show("1,n", "0,1"), (r"n\ge0",)),
    (SHEAR, show("1,n", "0,1"), (r"n\ge1",)),
    (show("a,0", "0,b"), show("a^n,0", "0,b^n"), (r"n\ge0",)),
    (show("a,1", "0,a"), show("a^n,na^{n-1}", "0,a^n"), ()),
    (ONES, r"2^{n-1}\cdot" + ONES, ()),
]
REFUTED = [
    (TURN, TURN, ()),
    (TURN, show(r"\cos n\theta,\sin n\theta", r"-\sin n\theta,\cos n\theta"), ()),
    (SHEAR, show("1,n+1", "0,1"), ()),
    (show("a,b", "0,c"), show("a^n,nb", "0,c^n"), ()),
    (ONES, r"2^n\cdot" + ONES, ()),
    # Not true for n = 0.
    (ONES, r"2^{n-1}\cdot" + ONES, (r"n\ge0",)),
]
REFUSED = [
    # A value from some n onwards or for one n only, no value, or a power that is not alone.
    (rf"{show('0,1', '0,0')}^n={show('0,0', '0,0')}", (r"n\ge2",)),
    (rf"{SHEAR}^n={show('1,3', '0,1')}", ("n=3",)),
    (rf"{SHEAR}^n={show('1,m', '0,1')}", ("m=n",)),
    (rf"{SHEAR}^n={show('1,n', '0,1')}", (r"n\ge3",)),
    (rf"{SHEAR}^n={SHEAR}^n", ()),
    (rf"{SHEAR}^n=1", ()),
    (rf"{SHEAR}^n{SHEAR}={show('1,n+1', '0,1')}", ()),
    (rf"({SHEAR}^n)^2={show('1,2n', '0,1')}", ()),
    (rf"{SHEAR}^n-{SHEAR}^n={show('0,0', '0,0')}", ()),
    (rf"\det({SHEAR}^n)=1", ()),
    (rf"{show('1,n', '0,1')}^n={show('1,n^2', '0,1')}", ()),
    (rf"{SHEAR}^x={show('1,x', '0,1')}", ()),
]


def judge(latex: str, where: tuple[str, ...] = ()) -> Verdict:
    pasted = Pasted(latex, where=where, natural=("n",))
    (found,) = judge_pasted(pasted).judgements
    return found.verdict


@pytest.mark.parametrize(("matrix", "value", "where"), PROVED)
def test_a_power_is_proved(matrix: str, value: str, where: tuple[str, ...]) -> None:
    assert judge(f"{matrix}^n={value}", where) is Verdict.PROVED


@pytest.mark.parametrize(("matrix", "value", "where"), REFUTED)
def test_another_value_is_refuted(matrix: str, value: str, where: tuple[str, ...]) -> None:
    assert judge(f"{matrix}^n={value}", where) is Verdict.REFUTED


@pytest.mark.parametrize(("latex", "where"), REFUSED)
def test_what_says_no_value_for_all_numbers_is_not_read(latex: str, where: tuple[str, ...]) -> None:
    with pytest.raises((ReadingError, ValueError)):
        judge(latex, where)
