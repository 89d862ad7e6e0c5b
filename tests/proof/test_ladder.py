"""The ladder: matrices, relations, conjunctions, completions, and what stays open."""

import pytest
import sympy as sp

from mechproof.proof import equation_ladder, ladder
from mechproof.proof.equation_ladder import ContradictionError
from mechproof.proof.ladder import decide
from mechproof.proof.limits import FROM_SIDES
from mechproof.proof.verdict import Verdict
from mechproof.record import (
    Completion,
    Completions,
    Conjunction,
    Definition,
    Distinct,
    Equality,
    Holds,
    NotCheckable,
    RecordError,
)
from mechproof.statement_domains.domain import Domain

x, y = sp.symbols("x y", real=True)
ANYWHERE = Domain({}, (), {})
PROVED, REFUTED, UNDECIDED = Verdict.PROVED, Verdict.REFUTED, Verdict.UNDECIDED
TURN = sp.ImmutableMatrix([[sp.cos(x), sp.sin(x)], [-sp.sin(x), sp.cos(x)]])
TURN_BACK = TURN.subs(x, -x)
TRUE = Equality((x + 1) ** 2, x**2 + 2 * x + 1)
FALSE = Equality((x + 1) ** 2, x**2 + 1)
OPEN = Equality(sp.exp(x + y), sp.exp(x) ** 2 * sp.exp(y - x))
NUMBERS = sp.Lt(sp.sqrt(2) + sp.sqrt(3), sp.pi + sp.Rational(1, 1000), evaluate=False)

DECISIONS = {
    "structural": (Equality(x + y, y + x), PROVED, "identical"),
    "rational": (TRUE, PROVED, "rational field"),
    "refuted": (FALSE, REFUTED, "separating balls"),
    "enclosed": (Equality(sp.erf(x) + sp.erfc(x), sp.S.One), Verdict.ENCLOSED, "enclosure"),
    "matrix": (
        Equality(TURN * TURN.T, sp.ImmutableMatrix.eye(2)),
        PROVED,
        "entrywise, trigonometric field, identical",
    ),
    "matrix turned the wrong way": (
        Equality(TURN, TURN_BACK),
        REFUTED,
        "entrywise, separating balls",
    ),
    "matrix transposed": (Equality(TURN, TURN.T), REFUTED, "entrywise, separating balls"),
    "matrix and number": (Equality(TURN, x), REFUTED, "entrywise"),
    "number and matrix": (Equality(x, TURN), REFUTED, "entrywise"),
    "row and column": (Equality(TURN[0, :], TURN[0, :].T), REFUTED, "entrywise"),
    "distinct": (Distinct(TURN, TURN_BACK), PROVED, "entrywise, separating balls"),
    "not distinct": (Distinct((x + 1) ** 2, x**2 + 2 * x + 1), REFUTED, "rational field"),
    "distinct not shown": (Distinct(sp.erf(x) + sp.erfc(x), sp.S.One), UNDECIDED, "enclosure"),
    "distinct from no limit": (
        Distinct(sp.Limit(sp.Abs(x) / x, x, 0, "+-"), sp.Integer(2)),
        UNDECIDED,
        FROM_SIDES,
    ),
    "exact numbers": (Holds(NUMBERS), REFUTED, "evaluation"),
    "exact numbers, other way": (Holds(NUMBERS.reversedsign), REFUTED, "evaluation"),
    "exact numbers, negated": (Holds(NUMBERS.negated), PROVED, "evaluation"),
    "equal numbers stay open": (
        Holds(sp.Ge(sp.sin(1) ** 2 + sp.cos(1) ** 2, 1, evaluate=False)),
        UNDECIDED,
        "evaluation",
    ),
    "and": (
        Holds(sp.And(x**2 + y**2 + 1 > 0, x**4 + 1 > x**2)),
        PROVED,
        "sign in positive coordinates",
    ),
    "and, one wrong": (Holds(sp.And(x**2 + y**2 + 1 > 0, x > y)), REFUTED, "separating balls"),
    "relation of equality": (
        Holds(sp.Eq((x + y) ** 2, x**2 + 2 * x * y + y**2)),
        PROVED,
        "rational field",
    ),
    "conjunction": (Conjunction((TRUE, Equality(x, x))), PROVED, "rational field, identical"),
    "conjunction, last wrong": (Conjunction((TRUE, FALSE)), REFUTED, "separating balls"),
    "conjunction, definition before a wrong part": (
        Conjunction((Definition(x, y), FALSE)),
        REFUTED,
        "separating balls",
    ),
    "conjunction, open before a wrong part": (
        Conjunction((Holds(sp.erf(x) <= sp.erf(x) + sp.erfc(x)), FALSE)),
        REFUTED,
        "separating balls",
    ),
    "definition": (Definition(x, y + 1), Verdict.DEFINITION, "definition"),
}


@pytest.mark.parametrize("name", DECISIONS)
def test_the_decision_and_its_rung(name):
    statement, verdict, rung = DECISIONS[name]
    answer = decide(statement, ANYWHERE)
    assert (answer.verdict, answer.rung) == (verdict, rung)


def test_a_counterexample_shows_the_point_and_both_balls():
    (evidence,) = decide(FALSE, ANYWHERE).evidence
    assert evidence.at["x"]
    assert evidence.printed != evidence.rebuilt


def test_a_violated_relation_shows_the_point():
    (evidence,) = decide(Holds(x > y), ANYWHERE).evidence
    assert set(evidence.at) == {"x", "y"}
    assert evidence.printed
    assert evidence.rebuilt


@pytest.mark.parametrize(
    ("first", "second", "verdict"),
    [
        (TRUE, FALSE, Verdict.UNDERDETERMINED),
        (FALSE, TRUE, Verdict.UNDERDETERMINED),
        (TRUE, TRUE, UNDECIDED),
        (FALSE, FALSE, UNDECIDED),
        (TRUE, OPEN, UNDECIDED),
    ],
)
def test_completions_need_opposite_answers(first, second, verdict):
    both = Completions("a datum", Completion("one", first), Completion("two", second))
    answer = decide(both, ANYWHERE)
    assert answer.verdict is verdict
    assert [evidence.what[:3] for evidence in answer.evidence] == ["one", "two"]


def test_what_is_lost_is_not_checkable():
    answer = decide(NotCheckable("the curves of Fig. 5 are lost"), ANYWHERE)
    assert answer.verdict is Verdict.NOT_CHECKABLE
    assert answer.reason == "not checkable: the curves of Fig. 5 are lost"
    with pytest.raises(RecordError, match="name what is lost"):
        NotCheckable(" ")


def test_completions_of_a_symbol_are_put_into_one_statement():
    says = Holds(x > 1)
    both = Completions(x, Completion("a half", says, sp.S.Half), Completion("two", says, sp.S(2)))
    answer = decide(both, Domain({x: sp.S.Reals}, (), {}))
    assert answer.verdict is Verdict.UNDERDETERMINED
    assert answer.reason.startswith("not stated: x")


@pytest.mark.parametrize(
    ("missing", "first", "second"),
    [
        ("", Completion("one", TRUE), Completion("two", FALSE)),
        ("a datum", Completion("one", TRUE), Completion("one", FALSE)),
        (x, Completion("one", TRUE), Completion("two", FALSE)),
        (x, Completion("one", TRUE, sp.S(1)), Completion("two", FALSE, sp.S(2))),
        (x, Completion("one", TRUE, sp.S(1)), Completion("two", TRUE, sp.S(1))),
    ],
)
def test_completions_name_what_is_missing_and_differ_in_it(missing, first, second):
    with pytest.raises(RecordError, match="Completions"):
        Completions(missing, first, second)


@pytest.mark.parametrize("source", ["print", "declaration"])
def test_a_side_that_is_built_from_the_other_proves_nothing(source):
    answer = decide(Equality(*vars(TRUE).values()), ANYWHERE)
    assert answer.verdict is PROVED
    same = Equality(TRUE.printed, TRUE.rebuilt, source)
    assert decide(same, ANYWHERE).verdict is Verdict.DEFINITION
    assert decide(Equality(FALSE.printed, FALSE.rebuilt, source), ANYWHERE).verdict is REFUTED


def test_what_a_symbol_is_declared_to_be_is_not_proved_by_the_declaration():
    domain = Domain({x: sp.S.Reals}, (), {y: x + 1})
    assert decide(Equality(y, x + 1), domain).verdict is Verdict.DEFINITION
    assert decide(Equality(x + 1, y), domain).verdict is Verdict.DEFINITION
    assert decide(Equality(y**2, (x + 1) ** 2), domain).verdict is PROVED


def test_a_rung_that_proves_what_balls_refute_is_caught(monkeypatch):
    monkeypatch.setattr(equation_ladder, "_FIRST", (lambda left, right, domain: "broken rung",))
    with pytest.raises(ContradictionError, match="proved, yet"):
        decide(FALSE, ANYWHERE)


def test_a_sign_that_balls_refute_is_not_believed(monkeypatch):
    monkeypatch.setattr(ladder, "_holds_by_sign", lambda relation, domain: True)
    assert decide(Holds(x > y), ANYWHERE).verdict is REFUTED
