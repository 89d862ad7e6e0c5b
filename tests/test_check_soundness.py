"""Pasted statements that fail only where no point is tried, or by a rule's own gap; true twins."""

from __future__ import annotations

import pytest

from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

COUNT = r"n\in\mathbb N"
FROM_ONE = r"\sum_{k=1}^n|k-x|=|1-x|+\frac{n(n+1)}2-1-(n-1)x"
TO_HALVES = r"\sum_{k=1}^n\left|k-\frac72\right|=\frac{n(n+1)}2-\frac{7n}2+%d"
POLES = r"\sum_{k=1}^n\left(\frac1{k%+d}-\frac1{k%+d}\right)=\frac1{%d}-\frac1{n%+d}"
POWERS = (
    r"\sum_{k=1}^n\left(\frac1{2^k%s2^{50}}-\frac1{2^{k+1}%s2^{50}}\right)"
    r"=\frac1{2%s2^{50}}-\frac1{2^{n+1}%s2^{50}}"
)
SQUARES = (
    r"\sum_{k=1}^n\left(\frac1{2^{2k}%s2^{100}}-\frac1{2^{2k+2}%s2^{100}}\right)"
    r"=\frac1{4%s2^{100}}-\frac1{2^{2n+2}%s2^{100}}"
)
INVERSE_ROOTS = (
    r"\sum_{k=1}^n\left(\frac1{\sqrt[3]{%s}}-\frac1{\sqrt[3]{%s}}\right)"
    r"=\frac1{\sqrt[3]{%s}}-\frac1{\sqrt[3]{%s}}"
)
NO_HOLE = "x^2-0.6x+0.09005"
HOLE = "x^2-0.6x+0.08995"  # negative between two irrational numbers near 0.3
EXP = r"\mathrm{e}^{\ln(%s)}=%s"
# The statement and what it is said under; first a true one, then one that is false somewhere.
PAIRS = {
    # A step from n to n + 1 must not rest on what ties other letters to n, or n to a part.
    "a letter far below n": ((FROM_ONE, (COUNT, "x<1")), (FROM_ONE, (COUNT, "x<n-100"))),
    "a letter below n": ((FROM_ONE, (COUNT, "x<1")), (FROM_ONE, (COUNT, "x<n"))),
    "later n": ((TO_HALVES % 9, (COUNT, r"n\ge4")), (TO_HALVES % 5, (COUNT, r"n\ge4"))),
    "n with a gap": ((TO_HALVES % 9, (COUNT, r"n\ge3")), (TO_HALVES % 5, (COUNT, "n(n-4)>-1"))),
    # Where only one side has a value: on a short interval, at irrational numbers, in a small disc.
    "a logarithm": ((EXP % (NO_HOLE, NO_HOLE), ()), (EXP % (HOLE, HOLE), ())),
    "a root squared": (
        (r"\sqrt{(x-0.37)^2+10^{-9}}^2=(x-0.37)^2+10^{-9}", ()),
        (r"\sqrt{(x-0.37)^2-10^{-9}}^2=(x-0.37)^2-10^{-9}", ()),
    ),
    "a root that is compared": ((rf"\sqrt{{{NO_HOLE}}}\ge0", ()), (rf"\sqrt{{{HOLE}}}\ge0", ())),
    "single numbers": (
        (EXP % ("(x^2-2)^2", "(x^2-2)^2"), ("x>2",)),
        (EXP % ("(x^2-2)^2", "(x^2-2)^2"), ()),
    ),
    "two letters": (
        (r"\sqrt{x^2+y^2-0.6x+0.09}^2=x^2+y^2-0.6x+0.09", ()),
        (r"\sqrt{x^2+y^2-0.6x+0.08995}^2=x^2+y^2-0.6x+0.08995", ()),
    ),
    "three letters": (
        (r"\sqrt{x^2+y^2-2xy\cos z+0.001}\ge0", ()),
        (r"\sqrt{x^2+y^2-2xy\cos z-0.001}\ge0", ()),
    ),
    "the end of a range": ((EXP % ("x", "x"), ("x>0",)), (EXP % ("x", "x"), (r"x\ge0",))),
    "poles among the terms": (
        (POLES % (500, 501, 501, 501), (COUNT,)),
        (POLES % (-500, -499, -499, -499), (COUNT,)),
    ),
    "poles among terms with powers": (
        (POWERS % (*"++++",), (COUNT,)),
        (POWERS % (*"----",), (COUNT,)),
    ),
    "poles among terms with squares of powers": (
        (SQUARES % (*"++++",), (COUNT,)),
        (SQUARES % (*"----",), (COUNT,)),
    ),
    "what divides a term is asked about where its index runs": (
        (INVERSE_ROOTS % ("k", "k+1", "1", "n+1"), (COUNT,)),
        (INVERSE_ROOTS % ("k-9", "k-8", "-8", "n-8"), (COUNT,)),
    ),
    "between pieces": (
        (r"\begin{cases}1+x^2&x\le0.37\\2+x^2&x>0.37\end{cases}>0", ()),
        (r"\begin{cases}1+x^2&x\le0.37\\2+x^2&x\ge0.370001\end{cases}>0", ()),
    ),
    "beside an integral": (
        (r"\int_0^a\sqrt x\,dx=\frac23\sqrt a^3", ()),
        (rf"\int_0^a\sqrt t\,dt+\sqrt{{{HOLE}}}^2=\frac23\sqrt a^3+{HOLE}", ()),
    ),
}


def judge(latex: str, where: tuple[str, ...]) -> set[Verdict]:
    return {found.verdict for found in judge_pasted(Pasted(latex, where=where)).judgements}


@pytest.mark.parametrize("name", PAIRS)
def test_what_is_false_somewhere_is_not_proved_and_its_true_neighbour_is(name: str) -> None:
    true, false = PAIRS[name]
    assert judge(*true) == {Verdict.PROVED}
    assert Verdict.PROVED not in judge(*false)
