"""False statements that once came back PROVED, or were passed over in silence."""

from __future__ import annotations

from pathlib import Path

import pytest
import sympy as sp

from mechproof.derivation import DerivationError, load_paper
from mechproof.proof.judge import judge
from mechproof.proof.ladder import decide
from mechproof.proof.verdict import Verdict
from mechproof.record import (
    Claim,
    Conjunction,
    Definition,
    Equality,
    Equation,
    Holds,
    Paper,
    Statement,
    Variable,
)
from mechproof.statement_domains.domain import Domain

x = sp.Symbol("x", real=True)
POSITIVE = sp.Interval.open(0, sp.oo)


def paper(*variables: Variable, where: tuple[sp.Basic, ...] = ()) -> Paper:
    return Paper("mine", "notes", variables, (), where)


@pytest.mark.parametrize(
    "symbol",
    [
        sp.Symbol("n", integer=True),
        sp.Symbol("q", negative=True),
        sp.Symbol("w", nonzero=True, real=True),
        sp.Symbol("p", positive=True),
        sp.Symbol("e", even=True),
    ],
)
def test_assumptions_narrower_than_the_set_are_refused(symbol: sp.Symbol) -> None:
    with pytest.raises(ValueError, match="the set does not imply all assumptions"):
        Domain.of(paper(Variable(symbol, "a symbol")))


def test_assumptions_of_a_given_symbol_must_follow_from_its_definition() -> None:
    a, b, gap = sp.symbols("a b gap", positive=True)
    sizes = (Variable(a, "a", within=POSITIVE), Variable(b, "b", within=POSITIVE))
    Domain.of(paper(*sizes, Variable(gap, "a sum", given=a + b)))
    with pytest.raises(ValueError, match="declare the symbol real only"):
        Domain.of(paper(*sizes, Variable(gap, "a difference", given=a - b)))


def test_a_relation_that_sympy_evaluated_is_not_believed() -> None:
    undeclared = sp.Symbol("x", positive=True)
    answer = decide(Holds(undeclared > 0), Domain({}, (), {}))
    assert answer.verdict is Verdict.UNDECIDED
    assert "evaluate=False" in answer.reason


def test_an_empty_domain_is_refused() -> None:
    with pytest.raises(ValueError, match="always false"):
        Domain.of(paper(Variable(x, "x"), where=(sp.false,)))


@pytest.mark.thorough
def test_a_break_of_the_integrand_in_another_variable_is_seen() -> None:
    t = sp.Symbol("t", real=True)
    domain = Domain({x: sp.Interval.Ropen(0, sp.Rational(16, 10))}, (), {})
    printed = sp.Integral(sp.atan(sp.tan(x)), (t, 0, 1))
    answer = decide(Equality(printed, sp.Integral(x, (t, 0, 1))), domain)
    assert answer.verdict is not Verdict.PROVED


def test_definitions_prove_nothing() -> None:
    domain = Domain({x: sp.S.Reals}, (), {})
    answer = decide(Conjunction((Definition(x, sp.Integer(5)),)), domain)
    assert answer.verdict is Verdict.DEFINITION


@pytest.mark.parametrize(
    "says",
    [
        Equality(sp.Integral(sp.cos(x), x), sp.sin(x)),
        Equality(sp.LambertW(x), x),
    ],
)
def test_a_statement_that_cannot_be_read_is_undecided_and_says_why(says: Statement) -> None:
    judgement = judge(Claim("1", "1", says), paper(Variable(x, "x")))
    assert judgement.verdict is Verdict.UNDECIDED
    assert judgement.reason


def test_a_false_equation_is_still_refuted() -> None:
    judgement = judge(Equation("1", "1", Equality(2 * x, x)), paper(Variable(x, "x")))
    assert judgement.verdict is Verdict.REFUTED


def test_a_paper_that_ends_the_program_is_no_paper(tmp_path: Path) -> None:
    file = tmp_path / "leaving.py"
    file.write_text("import sys\nsys.exit(0)\n", encoding="utf-8")
    with pytest.raises(DerivationError, match="SystemExit"):
        load_paper(file)
