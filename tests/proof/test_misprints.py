"""The commonest misprints get a verdict and a correction; our own faults get no verdict."""

from __future__ import annotations

from pathlib import Path

import pytest
import sympy as sp

from mechproof.derivation import DerivationError, load_paper
from mechproof.latex import read_paper
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Verdict
from mechproof.record import LENGTH, Correction, Equation, Paper, RecordError, Variable

s, w, m = sp.symbols("s w m", real=True)
r = sp.Symbol("r", positive=True)
n, j = sp.symbols("n j", integer=True, positive=True)
q = sp.IndexedBase("q", real=True)
MECHANICS = {s: r * w, m: sp.Sum(q[j], (j, 1, n)) / n}
VARIABLES = (
    Variable(s, "arc", LENGTH, latex=("s",)),
    Variable(w, "angle", latex=("w",)),
    Variable(r, "radius", LENGTH, sp.Interval.open(0, sp.oo), latex=("r",)),
    Variable(m, "mean", LENGTH, latex=("m",)),
    Variable(n, "count", within=sp.S.Naturals, latex=("n",)),
    Variable(q, "reading", LENGTH, latex=("q",)),
)
ARC, MEAN = "s=rw", r"m=\frac1n\sum_{j=1}^nq_j"
MISPRINTS = {
    "s=r^2w": (ARC, Verdict.ILL_FORMED, "dimension L^2"),
    "r^2w=s": ("rw=s", Verdict.ILL_FORMED, "dimension L^2"),
    "s=w": (ARC, Verdict.ILL_FORMED, "dimension 1"),
    r"s=\frac wr": (ARC, Verdict.ILL_FORMED, "dimension L^-1"),
    "s=r+w": (ARC, Verdict.ILL_FORMED, "dimension"),
    r"s=\cos r": (ARC, Verdict.ILL_FORMED, "inside cos"),
    "s=2rw": (ARC, Verdict.REFUTED, "differ"),
    r"m=\frac1n\sum_{j=1}^nq_k": (MEAN, Verdict.ILL_FORMED, "k has no value"),
    r"m=\frac1n\sum_{j=1}^nq_n": (MEAN, Verdict.REFUTED, "differ"),
    r"m=\frac1n\sum_{j=1}^nq_j^2": (MEAN, Verdict.ILL_FORMED, "dimension L^2"),
    r"m=\sum_{j=1}^{n-1}q_j": (MEAN, Verdict.REFUTED, "differ"),
}


def judge_print(latex: str, correction: str | None) -> tuple[Verdict, str, str]:
    mend = Correction(correction) if correction else None
    row = Equation("(1)", latex, derived=MECHANICS, corrected=mend)
    paper = read_paper(Paper("system", "citation", VARIABLES, (row,)))
    found = judge(paper.rows[0], paper)
    return found.verdict, found.reason, found.corrected_by


@pytest.mark.parametrize("latex", MISPRINTS)
def test_a_misprint_is_judged_and_mended(latex: str) -> None:
    correction, verdict, reason = MISPRINTS[latex]
    found, why, mended_by = judge_print(latex, correction)
    assert (found, bool(mended_by)) == (verdict, True)
    assert reason in why


def test_a_relation_of_unlike_sides_is_ill_formed() -> None:
    assert judge_print("s<r^2w", None)[0] is Verdict.ILL_FORMED


def test_without_a_correction_another_dimension_may_be_our_fault() -> None:
    with pytest.raises(RecordError, match=r"different dimensions.*give its correction"):
        judge_print("s=r^2w", None)


@pytest.mark.parametrize("latex", ["s=r^2w", "s=2rw"])
def test_a_correction_of_another_dimension_is_our_fault(latex: str) -> None:
    with pytest.raises(RecordError, match="different dimensions"):
        judge_print(latex, "s=r^3w")


def test_a_derived_value_of_another_dimension_is_our_fault(tmp_path: Path) -> None:
    file = tmp_path / "mine.py"
    file.write_text(
        "from sympy import symbols\n"
        "from mechproof.record import *\n"
        's, r = symbols("s r", real=True)\n'
        "V = (Variable(s, 's', LENGTH, latex=('s',)), Variable(r, 'r', LENGTH, latex=('r',)))\n"
        "PAPER = Paper('mine', 'notes', V, (Equation('(1)', 's=r', derived={s: r**2}, "
        "corrected=Correction('s=r^2')),))\n",
        encoding="utf-8",
    )
    with pytest.raises(DerivationError, match=r"row '\(1\)': derived: s has dimension L but"):
        load_paper(file)
