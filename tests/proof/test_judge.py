"""How answers become a row's verdict: correction, reading, part, marks."""

from dataclasses import replace

import pytest
import sympy as sp

from mechproof.proof.judge import judge
from mechproof.proof.verdict import Verdict
from mechproof.record import (
    LENGTH,
    Claim,
    Completion,
    Completions,
    Conjunction,
    Correction,
    Definition,
    Distinct,
    Equality,
    Equation,
    Holds,
    IntegralWithoutDifferential,
    Paper,
    Part,
    Reading,
    Variable,
)

x, y, undeclared = sp.symbols("x y undeclared", real=True)
a = sp.Symbol("a", positive=True)
TRUE, FALSE = Equality(x**2 + 2 * x + 1, (x + 1) ** 2), Equality(x**2 + 1, (x + 1) ** 2)
OPEN = Equality((x + 1) ** 2 * (sp.erf(x) + sp.erfc(x)), (x + 1) ** 2)
MIXED = Equality(a + a**2, a)
LIKE = Equality(a * (sp.sin(x) ** 2 + sp.cos(x) ** 2), a)
TURN = sp.atan(sp.tan(x))
NEAR_ZERO = Part("|x| < 1", {x: sp.Interval.open(-1, 1)})
FAR = Part("x > 0", {x: sp.Interval.open(0, sp.oo)})
ONE_POINT = Part("x = 0", {x: sp.FiniteSet(0)})
PAPER = Paper(
    "system",
    "citation",
    (Variable(x, "x"), Variable(y, "y"), Variable(a, "a", LENGTH, sp.Interval.open(0, sp.oo))),
    (),
)


def row(says, **more):
    return Equation("(1)", "print", says, **more)


def corrected(says):
    return Correction("right", says)


CASES = {
    "proved": (row(TRUE), Verdict.PROVED),
    "refuted and corrected": (row(FALSE, corrected=corrected(TRUE)), Verdict.REFUTED),
    "corrected form wrong as well": (row(FALSE, corrected=corrected(FALSE)), Verdict.UNDECIDED),
    "corrected form open": (row(FALSE, corrected=corrected(OPEN)), Verdict.UNDECIDED),
    "another reading": (row(FALSE, readings=(Reading("other", TRUE),)), Verdict.CONVENTION),
    "another reading, open": (row(FALSE, readings=(Reading("other", OPEN),)), Verdict.ENCLOSED),
    "another reading, wrong": (row(FALSE, readings=(Reading("other", FALSE),)), Verdict.REFUTED),
    "true as printed, reading unused": (
        row(TRUE, readings=(Reading("other", FALSE),)),
        Verdict.PROVED,
    ),
    "true on a part": (row(Equality(TURN, x), holds_on=NEAR_ZERO), Verdict.CONDITIONAL),
    "open on a part": (
        row(Equality(sp.Abs(x) * OPEN.printed, x * OPEN.rebuilt), holds_on=FAR),
        Verdict.ENCLOSED,
    ),
    "false on the part": (row(Equality(TURN, x), holds_on=FAR), Verdict.REFUTED),
    "part without interior": (row(Equality(x, 2 * x), holds_on=ONE_POINT), Verdict.REFUTED),
    "part beyond where it is said of": (
        row(Equality(sp.Abs(x), -x), on=FAR, holds_on=Part("x < 0", {x: sp.Interval(-sp.oo, 0)})),
        Verdict.REFUTED,
    ),
    "part within where it is said of": (
        row(Equality(TURN, x), on=Part("x > -2", {x: sp.Interval(-2, sp.oo)}), holds_on=NEAR_ZERO),
        Verdict.CONDITIONAL,
    ),
    "restricted row": (row(Equality(TURN, x), on=NEAR_ZERO), Verdict.PROVED),
    "inequality on a part": (row(Holds(x > 0), holds_on=FAR), Verdict.CONDITIONAL),
    "mixed units": (row(MIXED, corrected=corrected(LIKE)), Verdict.ILL_FORMED),
    "another dimension": (
        row(Equality(a**2, a), corrected=corrected(LIKE)),
        Verdict.ILL_FORMED,
    ),
    "another dimension that is not mended": (
        row(Equality(a**2, a), corrected=corrected(Equality(2 * a, a))),
        Verdict.UNDECIDED,
    ),
    "another dimension in a part": (
        row(Conjunction((TRUE, Equality(a**2, a))), corrected=corrected(LIKE)),
        Verdict.ILL_FORMED,
    ),
    "another dimension of what differs": (
        row(Distinct(a**2, a), corrected=corrected(Distinct(2 * a, a))),
        Verdict.ILL_FORMED,
    ),
    "unbound symbol": (row(Equality(x + undeclared, x)), Verdict.ILL_FORMED),
    "no differential": (row(Equality(IntegralWithoutDifferential(x), x)), Verdict.ILL_FORMED),
    "definition": (row(Definition(x, y)), Verdict.DEFINITION),
    "ill-formed definition": (row(Definition(x, undeclared)), Verdict.ILL_FORMED),
    "two completions": (
        row(Completions("a datum", Completion("one", TRUE), Completion("two", FALSE))),
        Verdict.UNDERDETERMINED,
    ),
    "open": (row(OPEN), Verdict.ENCLOSED),
    "function that no rung knows": (row(Equality(sp.LambertW(x), x)), Verdict.UNDECIDED),
}


@pytest.mark.parametrize("name", CASES)
def test_the_verdict_of_a_row(name):
    case, verdict = CASES[name]
    assert judge(case, PAPER).verdict is verdict


def test_a_correction_names_its_proof():
    judgement = judge(CASES["refuted and corrected"][0], PAPER)
    assert (judgement.corrected_by, judgement.corrected_latex) == ("rational field", "right")
    assert judgement.evidence[-1].what == "corrected form: PROVED (rational field)"


def test_a_convention_shows_both_readings():
    literal, meant = judge(CASES["another reading"][0], PAPER).evidence
    assert literal.what.startswith("read literally")
    assert literal.printed != literal.rebuilt
    assert meant.what == "read as: other: PROVED (rational field)"


def test_a_condition_shows_where_it_fails():
    inside, outside = judge(CASES["true on a part"][0], PAPER).evidence
    assert inside.what.startswith("|x| < 1: PROVED")
    assert abs(sp.Rational(outside.at["x"])) > 1


def test_where_a_row_is_proved_is_shown():
    judgement = judge(row(Equality(TURN, x), on=NEAR_ZERO, singular=("x = pi/2",)), PAPER)
    assert (judgement.on, judgement.singular) == ("|x| < 1", ("x = pi/2",))
    assert judgement.reason.endswith("; where |x| < 1; singular at x = pi/2")
    assert judgement.as_dict()["on"] == "|x| < 1"
    assert judgement.as_dict()["singular"] == ["x = pi/2"]


def test_what_is_rebuilt_from_the_print_is_a_definition_and_proves_no_correction():
    same = Equality(TRUE.printed, TRUE.rebuilt, "print")
    assert judge(row(same), PAPER).verdict is Verdict.DEFINITION
    assert judge(row(FALSE, corrected=corrected(same)), PAPER).verdict is Verdict.UNDECIDED
    assert judge(row(FALSE, readings=(Reading("r", same),)), PAPER).verdict is Verdict.REFUTED


def test_marks_and_note_are_handed_on():
    judgement = judge(Claim("c", "p", OPEN, note="Said why.", marks=("inferred",)), PAPER)
    assert judgement.marks == ("inferred", "as typed")
    assert judgement.reason.endswith(". Said why.")
    assert judgement.kind == "claim"


def test_unknown_marks_and_double_numbers_are_refused():
    with pytest.raises(ValueError, match="marks"):
        Claim("c", "p", TRUE, marks=("sure",))
    with pytest.raises(ValueError, match="row numbers given twice"):
        Paper("s", "c", (), (row(TRUE), row(FALSE)))


def test_a_row_cites_sentences_of_the_transcription_that_are_not_aside():
    cited = row(TRUE, cites=("S2",))
    paper = replace(PAPER, system="s", rows=(cited,), sentences=2, aside={"S1": "motivation"})
    judgement = judge(cited, paper)
    assert (judgement.id, judgement.as_dict()["cites"]) == ("s/eq-1", ["S2"])
    with pytest.raises(ValueError, match=r"sentences = 1: unknown \['S2'\]"):
        replace(paper, sentences=1)
    with pytest.raises(ValueError, match=r"aside: rows also judge \['S2'\]"):
        replace(paper, aside={"S2": "motivation"})


def test_every_wrong_entry_of_a_matrix_is_told() -> None:
    printed = sp.ImmutableMatrix([[x, 1, OPEN.printed], [2, x, 3]])
    rebuilt = sp.ImmutableMatrix([[x, -1, OPEN.rebuilt], [2, x, -3]])
    judgement = judge(row(Equality(printed, rebuilt)), PAPER)
    assert judgement.verdict is Verdict.REFUTED
    assert judgement.reason.startswith("entry (1, 2): ")
    assert "; entry (2, 3): " in judgement.reason
    assert "entry (1, 3)" not in judgement.reason
    assert [e.what.partition(":")[0] for e in judgement.evidence] == [
        "entry (1, 2)",
        "entry (2, 3)",
    ]
    one = judge(row(Equality(printed[:, :2], rebuilt[:, :2])), PAPER)
    assert one.reason == "entry (1, 2): the two sides differ"


@pytest.mark.parametrize(
    ("error", "told"),
    [
        (RecursionError("maximum recursion depth"), "nested too deeply"),
        (ZeroDivisionError("division by zero"), "divides by zero"),
        (AttributeError("'Foo' object has no attribute 'bar'"), "no rule for a part of it"),
        (NotImplementedError("a Sum inside a root"), "a Sum inside a root"),
    ],
)
def test_errors_are_told_in_words(
    monkeypatch: pytest.MonkeyPatch, error: Exception, told: str
) -> None:
    def fail(*_: object) -> None:
        raise error

    monkeypatch.setattr("mechproof.proof.judge.decide", fail)
    judged = judge(row(FALSE), PAPER)
    assert judged.verdict is Verdict.UNDECIDED
    assert told in judged.reason
    assert "Error" not in judged.reason
    assert "Foo" not in judged.reason
