"""Coq scripts: their statements are right and are read back, and changed scripts are refused."""

from __future__ import annotations

import pytest
import sympy as sp
from sympy import Eq, Interval, Rational, S, cos, sin, sqrt, symbols

from mechproof.coq.script_comparison import ReadBackError, compare_script
from mechproof.coq.scripts import write_script
from mechproof.coq.terms import UnwritableError, list_needs, name_symbols, write_term
from mechproof.coq.theorems import build_theorems, list_cases
from mechproof.proof.verdict import Verdict
from mechproof.record import (
    ANGLE,
    Differentiated,
    Distinct,
    Equality,
    Equation,
    Holds,
    Paper,
    PrintedNumber,
    PublishedSizes,
    Variable,
)
from mechproof.statement_domains.domain import Domain

e, x = symbols("e x", real=True)
EQUAL = Equality(sin(x) ** 2 / (1 - e), (1 - cos(x) ** 2) / (1 - e))
RATIO = Holds(sp.Lt((1 - e) / (1 + e), 2, evaluate=False))
NUMBER = PrintedNumber("1.414", sqrt(2))
WAVE = sin(x) ** 2 / (1 - e)
SLOPE = Equality(WAVE.diff(x), WAVE.diff(x), differentiated=Differentiated(WAVE, (x,)))


def write(statement: object, verdict: Verdict = Verdict.PROVED, where: tuple = ()) -> tuple:
    variables = (Variable(e, "a share", within=Interval.Ropen(0, 1)), Variable(x, "an angle"))
    row = Equation("(1)", "1", statement)
    paper = Paper("mine", "my notes", variables, (row,), where=where)
    theorems = build_theorems(row, verdict, Domain.of(paper))
    return write_script("mine", theorems), theorems


@pytest.mark.parametrize("statement", [EQUAL, RATIO, NUMBER, SLOPE])
def test_a_script_says_what_it_was_written_from(statement: object) -> None:
    text, theorems = write(statement)
    compare_script(text, theorems)


@pytest.mark.parametrize(
    ("statement", "old", "new"),
    [
        (EQUAL, "(e < 1)", "(e <= 1)"),
        (EQUAL, "(e < 1) -> ", ""),
        (EQUAL, "(cos x) ^ 2", "(cos x) ^ 3"),
        (EQUAL, "exists e x : R, ", "exists x e : R, "),
        (EQUAL, "forall e x", "forall x e"),
        (EQUAL, "Theorem part_1", "Theorem part_2"),
        (RATIO, "< 2)", "> 2)"),
        (RATIO, "1 + ", "1 - "),
        (RATIO, "< 2)", "< 3)"),
        (NUMBER, "2000", "20000"),
        (SLOPE, "(sin x) ^ 2", "(sin x) ^ 3"),
        (SLOPE, "(is_derive (fun x : R => ", "(is_derive (fun e : R => "),
        (SLOPE, ")))) x (", ")))) e ("),
        (SLOPE, "(2 * ", "((- 2) * "),
    ],
)
def test_a_changed_script_is_refused(statement: object, old: str, new: str) -> None:
    text, theorems = write(statement)
    assert old in text
    with pytest.raises(ReadBackError):
        compare_script(text.replace(old, new), theorems)


@pytest.mark.parametrize(
    ("function", "rebuilt", "is_stated"),
    [
        (WAVE, WAVE.diff(x), True),
        (WAVE, 2 * sin(x) * sqrt(1 - sin(x) ** 2) / (1 - e), False),
        (sp.Abs(sin(x)), sp.Integer(0), False),
        (sqrt(1 + sqrt(1 + x**2)), sqrt(1 + sqrt(1 + x**2)).diff(x), False),
        (sqrt(1 + sqrt(2 + e)) * x, sqrt(1 + sqrt(2 + e)), True),
        (e + sp.Piecewise((x, x < 0), (2 * x, True)), S.One, False),
        (cos(e), S.Zero, False),
    ],
)
def test_a_slope_is_stated_where_both_sides_are_one(
    function: sp.Expr, rebuilt: sp.Expr, is_stated: bool
) -> None:
    slope = WAVE.diff(x) if function is WAVE else rebuilt
    differentiated = Differentiated(function, (x,))
    _, theorems = write(Equality(slope, rebuilt, differentiated=differentiated))
    assert [t.conclusion.has(sp.Derivative) for t in theorems] == [is_stated]


def test_letters_with_one_published_value_are_told_apart() -> None:
    """At the published sizes both letters have the same value."""
    a, b = symbols("a b", positive=True)
    row = Equation("(1)", "1", Equality((a + b) * sin(x) ** 2, (a + b) * (1 - cos(x) ** 2)))
    lengths = (Variable(s, "a length", within=Interval.open(0, S.Infinity)) for s in (a, b))
    sizes = (PublishedSizes("a table", {a: S(2), b: S(2)}),)
    paper = Paper(
        "mine", "notes", (*lengths, Variable(x, "an angle", ANGLE)), (row,), published=sizes
    )
    theorems = build_theorems(row, Verdict.PROVED, Domain.of(paper))
    text = write_script("mine", theorems)
    compare_script(text, theorems)
    assert "(a + b)" in text
    with pytest.raises(ReadBackError):
        compare_script(text.replace("(a + b)", "(a + a)"), theorems)


SHARED = sqrt(sqrt(2) + sqrt(3) + sqrt(5) + sp.pi)


def write_shared() -> tuple[str, list]:
    _, theorems = write(Holds(sp.Lt(SHARED * cos(SHARED), sin(SHARED), evaluate=False)))
    return write_script("mine", theorems, 0), theorems


def test_shared_parts_are_read_back() -> None:
    text, theorems = write_shared()
    assert text.count("PI") == 1
    compare_script(text, theorems)


@pytest.mark.parametrize(
    ("old", "new"),
    [("(sqrt 3)", "(sqrt 4)"), ("(cos (sqrt", "(sin (sqrt"), ("Definition", "Axiom")],
)
def test_a_changed_definition_is_refused(old: str, new: str) -> None:
    text, theorems = write_shared()
    assert old in text
    with pytest.raises(ReadBackError):
        compare_script(text.replace(old, new), theorems)


q, n, i, j = sp.IndexedBase("q"), *symbols("n i j", integer=True)
SUMS = Equality(
    sp.Sum(sp.KroneckerDelta(i, j) * q[i] * q[j] / n, (i, 1, n), (j, 1, n)),
    sp.Sum(q[i] ** 2, (i, 1, n)) / n,
)


def write_sums() -> tuple[str, list]:
    family = Variable(n, "how many", within=S.Naturals), Variable(q, "numbers")
    row = Equation("(1)", "1", SUMS)
    theorems = build_theorems(
        row, Verdict.PROVED, Domain.of(Paper("mine", "notes", family, (row,)))
    )
    return write_script("mine", theorems), theorems


def test_sums_are_read_back() -> None:
    text, theorems = write_sums()
    assert "forall (n : nat) (q : nat -> R), ((INR n) >= 1) -> " in text
    compare_script(text, theorems)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("forall (n : nat) (q : nat -> R)", "forall (q : nat -> R) (n : nat)"),
        ("(q : nat -> R)", "(q : nat -> nat -> R)"),
        ("forall (n : nat)", "forall (n : R)"),
        ("(kronecker i j)", "(kronecker i i)"),
        ("(q j)", "((q j) * (q j))"),
        ("((q i) ^ 2)", "((q i) ^ 3)"),
        ("(INR n)", "(INR i)"),
    ],
)
def test_a_changed_sum_is_refused(old: str, new: str) -> None:
    text, theorems = write_sums()
    assert old in text
    with pytest.raises(ReadBackError):
        compare_script(text.replace(old, new), theorems)


LAW = Equality(sp.Piecewise((x, x > e), (e, True)), sp.Max(e, x))


def test_a_law_by_pieces_is_a_theorem_for_each() -> None:
    text, theorems = write(LAW)
    assert [theorem.conclusion.lhs for theorem in theorems] == [x, e]
    assert sp.Lt(e, x, evaluate=False) in theorems[0].hypotheses
    assert sp.Le(x, e, evaluate=False) in theorems[1].hypotheses
    compare_script(text, theorems)


@pytest.mark.parametrize(
    ("old", "new"),
    [(" -> (e < x)", ""), ("(e < x)", "(x < e)"), ("(x <= e)", "(x < e)"), ("= (Rmax", "= (Rmin")],
)
def test_a_changed_piece_is_refused(old: str, new: str) -> None:
    text, theorems = write(LAW)
    assert old in text
    with pytest.raises(ReadBackError):
        compare_script(text.replace(old, new), theorems)


def test_pieces_that_contradict_each_other_are_no_case() -> None:
    same = sp.Piecewise((x, x > e), (e, True))
    cases = list(list_cases(sp.Eq(same, sp.Piecewise((x, e < x), (e, True)), evaluate=False)))
    assert len(cases) == 2


def test_a_piece_under_what_is_no_comparison_has_no_theorem() -> None:
    with pytest.raises(UnwritableError, match="condition"):
        write(Equality(sp.Piecewise((x, (x > e) & (x < 2)), (e, True)), x))


def test_a_statement_over_no_point_is_not_written() -> None:
    with pytest.raises(UnwritableError, match="no point"):
        write(Equality(e, e), where=(e > Rational(1, 2), e < Rational(1, 3)))


def test_a_refuted_row_is_a_point() -> None:
    text, theorems = write(Equality(sin(x), cos(x)), Verdict.REFUTED)
    assert "exists x : R, ((sin x) <> (cos x))" in text
    compare_script(text, theorems)


def test_sides_that_differ_are_a_point() -> None:
    text, theorems = write(Distinct(sin(x), cos(x)))
    assert "exists x : R, ((sin x) <> (cos x))" in text
    compare_script(text, theorems)


def test_a_true_row_has_no_point_that_refutes_it() -> None:
    with pytest.raises(UnwritableError, match="no point"):
        write(EQUAL, Verdict.REFUTED)


@pytest.mark.parametrize(
    ("expression", "text"),
    [
        (x - e, "(x + ((- 1) * e))"),
        (Rational(-2, 3) * x, "((- (2 / 3)) * x)"),
        (x**-2, "(/ (x ^ 2))"),
        (e / x, "(e / x)"),
        (sqrt(x) ** 3, "((sqrt x) ^ 3)"),
        (x ** Rational(1, 3), "(exp ((1 / 3) * (ln x)))"),
        (x**e, "(exp (e * (ln x)))"),
        (2 * sp.pi, "(2 * PI)"),
        (sp.atan2(e, x), "(atan2 e x)"),
    ],
)
def test_terms(expression: sp.Expr, text: str) -> None:
    assert write_term(expression, {e: "e", x: "x"}) == text


@pytest.mark.parametrize("expression", [sp.gamma(x), sp.Integral(x, x), S.ImaginaryUnit])
def test_what_has_no_term_is_named(expression: sp.Expr) -> None:
    with pytest.raises(UnwritableError):
        write_term(expression, {e: "e", x: "x"})


def test_needs_of_parts() -> None:
    assert list_needs(1 / (x - e)) == [sp.Ne(x - e, 0)]
    assert list_needs(sp.log(x) + sp.tan(e)) in (
        [sp.Gt(x, 0), sp.Ne(cos(e), 0)],
        [sp.Ne(cos(e), 0), sp.Gt(x, 0)],
    )
    assert list_needs(x**e) == [sp.Gt(x, 0)]
    assert list_needs(Eq(x, e)) == []


def test_no_letter_takes_a_name_of_coq() -> None:
    letters = symbols("R E sin exists H1 varphi' 2x R_")
    names = name_symbols(letters)
    assert len(set(names.values())) == len(letters)
    assert not {"R", "E", "sin", "exists", "H1"} & set(names.values())
