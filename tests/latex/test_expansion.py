"""A print becomes one row for each relation sign, compared with what is declared for it."""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp

from mechproof.latex import Reader, read_paper
from mechproof.latex.expansion import read_row
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Judgement, Verdict
from mechproof.record import (
    LENGTH,
    ChainLink,
    Claim,
    Conjunction,
    Correction,
    Definition,
    Distinct,
    Equality,
    Equation,
    Holds,
    Nearly,
    Notation,
    Paper,
    Part,
    PrintedNumber,
    Row,
    Variable,
)

x, y, z, w, c = sp.symbols("x y z w c", real=True)
length = sp.Symbol("L", positive=True)
K = sp.MatrixSymbol("K", 2, 2)
q = sp.IndexedBase("q", real=True)
TURN = sp.ImmutableMatrix([[sp.cos(x), sp.sin(x)], [-sp.sin(x), sp.cos(x)]])
LATEX_TURN = r"\begin{pmatrix}\cos x&\sin x\\-\sin x&\cos x\end{pmatrix}"
VARIABLES = (
    Variable(x, "", latex=("x",)),
    Variable(y, "", given=2 * x, latex=("y",)),
    Variable(z, "", given=3 * w, latex=("z",)),
    Variable(w, "", latex=("w",)),
    Variable(c, "", given=x**2, latex=("c",)),
    Variable(length, "", LENGTH, sp.Interval.open(0, sp.oo), latex=("L",)),
    Variable(K, "", latex=("K",)),
    Variable(q, "", latex=("q",)),
)
NOTATION = Notation(lower_limit=sp.S.Zero)
READER = Reader(VARIABLES, NOTATION)


def expand(latex: str, **declared: Any) -> tuple[Row, ...]:
    return read_row(Equation("(1)", latex, **declared), READER)


def says(latex: str, **declared: Any) -> Any:
    (row,) = expand(latex, **declared)
    return row.says


def verdicts(latex: str, **declared: Any) -> list[Judgement]:
    paper = Paper("p", "c", VARIABLES, (Equation("(1)", latex, **declared),), notation=NOTATION)
    return [judge(row, paper) for row in read_paper(paper).rows]


def test_each_sign_is_a_row_with_its_number_print_and_reading() -> None:
    rows = expand(r"y=x+x=2x", links={2: ChainLink(note="Added.")}, marks=("rebuilt",))
    assert [row.number for row in rows] == ["(1), first equals sign", "(1), second equals sign"]
    assert [row.printed_latex for row in rows] == ["y=x+x", "x+x=2x"]
    assert [row.read_as for row in rows] == ["y = x + x", "x + x = 2*x"]
    assert [row.note for row in rows] == ["", "Added."]
    assert all(row.marks == ("rebuilt",) for row in rows)
    assert [r.number for r in expand(r"0\le w^2=w^2")] == ["(1), first sign", "(1), second sign"]
    assert [row.number for row in expand("x+1=w", defines=(w,))] == ["(1)"]


def test_signs_are_counted_beyond_the_ninth() -> None:
    rows = expand("=".join(["w"] * 25))
    assert [row.number for row in rows[8:13]] == [
        f"(1), {n} equals sign" for n in ("ninth", "10th", "11th", "12th", "13th")
    ]
    assert [row.number for row in rows[20:]] == [
        f"(1), {n} equals sign" for n in ("21st", "22nd", "23rd", "24th")
    ]


def test_a_bound_variable_is_no_letter_of_the_print() -> None:
    under = sp.Symbol("x_", real=True)
    reader = Reader((*VARIABLES, Variable(under, "", latex=(r"\xi",))), NOTATION)
    for latex, value in (
        (r"\int_0^w(x-\xi)\,dx", w**2 / 2 - under * w),
        (r"\lim_{x\to0}(x+\xi)", under),
        (r"\int_0^1\left(\int_0^1\cos x\sin w\,d\cos x\right)d\sin w", sp.Rational(1, 4)),
        (r"\int_0^1\int_0^xx\,dx\,dx", sp.Rational(1, 6)),
    ):
        one, other = (reader.members(Equation("(1)", latex)) for _ in range(2))
        assert one == other
        assert sp.expand(one[0].doit() - value) == 0


def test_chains_with_commas_count_their_signs_through() -> None:
    rows = expand(r"x=(w+1)w,\ z=(\dots)x", defines=(x, z))
    assert rows[1].printed_latex == r"z=(\dots)x"
    assert rows[1].read_as == "z = (w + 1)*x"


def test_members_without_derived_values_are_compared_as_read() -> None:
    assert says("2w=w+w") == Equality(2 * w, 2 * w, "member")
    assert says(r"\int_0^x\cos t\,dt=\sin x").rebuilt == sp.sin(x)


def test_a_derived_value_takes_the_place_of_the_declared_one() -> None:
    assert says("x=w+1", derived={x: 2 * w}) == Equality(w + 1, 2 * w)
    assert says("w+1=x", derived={x: 2 * w}) == Equality(w + 1, 2 * w)
    # Also in letters given by it, and in an integral.
    assert says("y=w", derived={x: w / 2}) == Equality(w, w)
    (row,) = expand(r"w=\int c\,dx", derived={w: x**3 / 3})
    assert isinstance(row.says, Equality)
    assert row.says.printed.doit() == x**3 / 3


def test_a_derived_value_may_stand_for_a_whole_member() -> None:
    assert says("x-w=2L", derived={x - w: length + length}) == Equality(2 * length, 2 * length)


def test_a_residual_is_compared_with_the_difference() -> None:
    assert says("x+w=L", residual=x - length) == Equality(x + w - length, x - length)


def test_a_symbol_that_is_declared_by_its_own_print_proves_nothing() -> None:
    for latex in ("c=x^2", "x^2=c", "2c=x^2+c"):
        (judgement,) = verdicts(latex)
        assert judgement.verdict is Verdict.DEFINITION
    # A consequence of the declared value does say something.
    (follows,) = verdicts("c^2=x^4")
    assert follows.verdict is Verdict.PROVED
    (derived,) = verdicts("c=x^2", derived={c: x * x})
    assert derived.verdict is Verdict.PROVED
    # The declared value is in other symbols than the print, so the print says something.
    (said,) = verdicts("y=x+x", derived={x: w})
    assert said.verdict is Verdict.PROVED


def test_a_print_may_introduce_a_symbol() -> None:
    assert says("x=w+1", defines=(x,)) == Definition(x, w + 1)
    assert says("w+1=x", defines=(x,)) == Definition(x, w + 1)


def test_a_symbol_of_which_nothing_is_known_is_an_error_of_the_module() -> None:
    with pytest.raises(ValueError, match="nothing is known about x"):
        expand("x=w+1")
    for latex in ("Kx=1", "K<x", r"K\ne x", "K=K^T", r"\det K=1", "K+K=2x"):
        with pytest.raises(ValueError, match="nothing is known about K"):
            expand(latex)
    with pytest.raises(ValueError, match="nothing is known about K"):
        expand("K=1", residual=x)
    with pytest.raises(ValueError, match="do not fit together here; K is a 2x2 matrix"):
        expand("K+x=1")


def test_a_substitution_is_made_on_both_sides_and_shown() -> None:
    (row,) = expand(r"2\cos x=\cos x+\cos x", substituted={sp.cos(x): w})
    assert row.says == Equality(2 * w, 2 * w, "member")
    assert row.read_as == "2*cos(x) = cos(x) + cos(x), with cos(x) -> w"


def test_a_letter_may_say_which_of_two_signs_is_meant() -> None:
    branch = sp.Symbol("sigma", real=True)
    variables = (*VARIABLES, Variable(branch, "", within=sp.FiniteSet(-1, 1), latex=(r"\sigma",)))
    reader = Reader(variables, Notation(branch=branch))
    root = sp.sqrt(w**2 + 1)
    (row,) = read_row(Equation("(1)", r"x=w\pm\sqrt{w^2+1}", defines=(x,)), reader)
    assert row.says == Definition(x, w + branch * root)
    (row,) = read_row(Equation("(1)", r"x=\mp(w+1)L", derived={x: length}), reader)
    assert row.says == Equality(-branch * (w + 1) * length, length)
    (row,) = read_row(Equation("(1)", r"\sin(x\pm w)=\sin(w\pm x)"), reader)
    assert isinstance(row.says, Conjunction)
    with pytest.raises(ValueError, match="both signs, or either"):
        expand(r"x=w\pm\sqrt{w^2+1}", derived={x: w})


def test_a_print_is_cut_with_the_size_of_its_bars() -> None:
    first, _ = expand(r"\left|w\right|=\left|x\right|=w^2")
    assert first.printed_latex == r"\left|w\right|=\left|x\right|"


def test_other_signs() -> None:
    assert says(r"w^2\ge0") == Holds(sp.Ge(w**2, 0, evaluate=False))
    assert says("w<L", derived={w: length / 2}) == Holds(sp.Lt(length / 2, length, evaluate=False))
    assert says(r"w\ne L") == Holds(sp.Ne(w, length, evaluate=False))
    assert says(r"\frac13\approx0.33") == PrintedNumber("0.33", sp.Rational(1, 3))
    assert says(r"\frac13\simeq0.33") == PrintedNumber("0.33", sp.Rational(1, 3))
    assert says(r"\frac12\approx0.50") == PrintedNumber("0.50", sp.Rational(1, 2))
    assert says(r"-w\approx-2", derived={w: 2 * x}) == PrintedNumber("-2", -2 * x)
    assert says(r"\pi/1800\approx0.1^\circ") == PrintedNumber("0.1", sp.Rational(1, 10))
    assert says(r"w\approx L") == Nearly(w, length)


def test_matrices_are_compared_by_their_entries() -> None:
    derived = {K: TURN}
    assert says(f"K={LATEX_TURN}", derived=derived) == Equality(TURN, TURN)
    both = says(r"K^T(x,w)^T=(x,w)^T", derived=derived)
    assert both == Equality(sp.ImmutableMatrix([x, w]), TURN.T * sp.ImmutableMatrix([x, w]))
    assert isinstance(says(r"K\ne K^T", derived=derived), Distinct)
    assert says(f"K={LATEX_TURN}", defines=(K,)) == Definition(K, TURN)
    declared = (*VARIABLES[:-2], Variable(K, "", given=TURN, latex=("K",)))
    (row,) = read_row(Equation("(1)", f"K={LATEX_TURN}"), Reader(declared))
    assert row.says == Definition(K, TURN)
    (row,) = read_row(Equation("(1)", f"K={LATEX_TURN}", derived={K: TURN}), Reader(declared))
    assert row.says == Equality(TURN, TURN)


def test_a_printed_condition_narrows_where_it_is_meant() -> None:
    (row,) = expand(r"|w|=w\text{ if }w>0")
    assert row.on == Part("w > 0", where=(sp.Gt(w, 0, evaluate=False),))
    assert row.read_as == "|w| = w if w > 0"
    (judgement,) = verdicts(r"|w|=w\text{ if }w>0")
    assert judgement.verdict is Verdict.PROVED


def test_a_printed_condition_and_that_of_the_row_narrow_together() -> None:
    within = {w: sp.Interval.open(-1, sp.oo)}
    part = Part("w > -1 and x < w", within, (sp.Lt(x, w),))
    printed = sp.Gt(w, 0, evaluate=False)
    (row,) = expand(r"|w|=w\text{ if }w>0", on=part)
    assert row.on == Part("w > 0 and w > -1 and x < w", within, (printed, sp.Lt(x, w)))
    # Without the printed condition it would be refuted at w = -1/2.
    (judgement,) = verdicts(r"|w|=w\text{ if }w>0", on=part)
    assert judgement.verdict is Verdict.PROVED
    assert judgement.on == "w > 0 and w > -1 and x < w"
    assert "where w > 0 and w > -1 and x < w" in judgement.reason
    (judgement,) = verdicts(r"|w|=-w\text{ if }w>0", on=part)
    assert judgement.verdict is Verdict.REFUTED
    # A part declared for one sign does not hide the printed condition; equal texts show once.
    again = Part("w > 0", within)
    (row,) = expand(r"|w|=w\text{ if }w>0", links={1: ChainLink(on=again)})
    assert row.on == Part("w > 0", within, (printed,))


def test_a_correction_has_the_condition_of_its_print() -> None:
    right = Correction(r"-w\text{ if }w<0")
    with pytest.raises(ValueError, match="its own condition"):
        expand(r"z=2w\text{ if }w>0", derived={z: w}, corrected=right)
    same = Correction(r"w\text{ if }w>0")
    (row,) = expand(r"z=2w\text{ if }w>0", derived={z: w}, corrected=same)
    assert row.corrected is not None
    assert row.corrected.says == Equality(w, w)


def test_cases() -> None:
    one, nothing = sp.Integer(1), sp.Integer(0)
    inside = sp.And(sp.Lt(0, w, evaluate=False), sp.Lt(w, length, evaluate=False), evaluate=False)
    definition = says(r"x=1\text{ if }0<w<L,\text{ else }0", defines=(x,))
    assert definition.printed == sp.Piecewise((one, inside), (nothing, True), evaluate=False)
    (row,) = expand(r"x=0\text{ if }w<0,\ w\text{ if }w>0", defines=(x,))
    assert row.read_as == "x = {0 if w < 0; w if w > 0}"


def test_a_correction_is_read_like_its_sign() -> None:
    right = Correction("2w")
    (row,) = expand("x=3w", derived={x: w + w}, corrected=right)
    assert row.corrected is not None
    assert row.corrected.says == Equality(2 * w, 2 * w)
    (row,) = expand("x=3w", derived={x: w + w}, corrected=Correction("x=w+w"))
    assert row.corrected is not None
    assert row.corrected.says == Equality(2 * w, 2 * w)
    with pytest.raises(ValueError, match="needs a `says`"):
        read_row(Claim("c", "?", Holds(sp.true), corrected=right), READER)


def test_a_sign_may_be_typed_and_is_then_marked() -> None:
    rows = verdicts("2w=w+w=3w-w", links={2: ChainLink(says=Equality(w, w))})
    assert [row.marks for row in rows] == [(), ("as typed",)]
    assert rows[1].read_as == ""


def test_declarations_that_do_not_fit_the_print_are_errors() -> None:
    with pytest.raises(ValueError, match="it has 1 signs, but links for"):
        expand("2w=w+w", links={2: ChainLink(note="!")})
    with pytest.raises(ValueError, match="no relation sign"):
        expand("2w")
    with pytest.raises(ValueError, match="no relation sign"):
        expand("2w=w+w, 5")
    with pytest.raises(ValueError, match="marks"):
        Equation("(1)", "w", links={1: ChainLink(marks=("sure",))})


ILL_FORMED = [
    (r"\int\cos x=\sin x", "an integral has no differential"),
    (r"\sin x=\int\cos x", "an integral has no differential"),
    (r"\cos+1=w", "cos has no argument"),
    (r"w+1=\frac{\cos}{2}", "cos has no argument"),
    (r"w+1=q_k", "k has no value there"),
    (r"\sum_{i=1}^3\sum_{k=1}^3 q_j=w+1", "j has no value there"),
    (r"L+1=w+1", "dimension"),
]


@pytest.mark.parametrize(("latex", "reason"), ILL_FORMED)
def test_what_reading_finds_is_the_witness(latex: str, reason: str) -> None:
    (judgement,) = verdicts(latex)
    assert judgement.verdict is Verdict.ILL_FORMED
    assert reason in judgement.reason


def test_an_index_that_its_sum_does_not_use_is_told() -> None:
    (judgement,) = verdicts(r"\sum_{i=1}^3\sum_{k=1}^3 q_iq_j=w+1")
    assert "The index k of a sum does not appear in its term." in judgement.reason
    (row,) = expand(r"\sum_{i=1}^3 q_i=w+1")
    assert row.note == ""


def test_members_of_a_row_can_be_read_for_claims_and_forms() -> None:
    assert READER.members(Equation("(1)", "x=2w,z=3w")) == (x, 2 * w, z, 3 * w)
