"""Slightly wrong variants of the paper's rows are refuted, or hold on a smaller part."""

from __future__ import annotations

import dataclasses

import pytest
from derived import paper_of
from sympy import Interval, Rational, oo
from weights import make_thorough

from mechproof.derivations.tooth_thickness import mechanics
from mechproof.derivations.tooth_thickness.rows import claims
from mechproof.proof.judge import judge
from mechproof.proof.ladder import decide
from mechproof.proof.verdict import Verdict
from mechproof.record import Part, PrintedNumber, Row
from mechproof.statement_domains.domain import Domain


def row(number: str) -> Row:
    return next(row for row in paper_of("tooth_thickness").rows if row.number == number)


# Parts slightly larger than those on which the claims are said to hold.
TOO_WIDE = {
    "(b)": {mechanics.gauge_um: Interval.Lopen(Rational("1.2260"), mechanics.GAUGE_UM)},
    "(1), influence 0.7284": {mechanics.tilt: Interval(0, 3 * mechanics.NARROW)},
    "step 6, influence of the involute": {mechanics.tilt: Interval(0, 3 * mechanics.NARROW)},
    "(a), rise with the limit error": {mechanics.above: Interval.open(0, oo)},
}


# These take seconds each.
SLOW = ("(1), influence 0.7284", "step 6, influence of the involute")


@pytest.mark.parametrize("number", [make_thorough(n) if n in SLOW else n for n in TOO_WIDE])
def test_a_claim_does_not_hold_on_more(number: str) -> None:
    claim, more = row(number), Part("more", TOO_WIDE[number])
    field, verdict = ("holds_on", Verdict.CONDITIONAL) if claim.holds_on else ("on", Verdict.PROVED)
    wider = dataclasses.replace(claim, **{field: more})
    assert judge(claim, paper_of("tooth_thickness")).verdict is verdict
    assert judge(wider, paper_of("tooth_thickness")).verdict is not verdict


def test_another_crossover_is_refuted() -> None:
    says = PrintedNumber("5.0", 2 * mechanics.crossover(6))
    assert decide(says, Domain.of(paper_of("tooth_thickness"))).verdict is Verdict.REFUTED


def test_other_shares_are_refuted() -> None:
    for shares in ({7: ("1.00", "0.24")}, {6: ("0.36", "0.11")}):
        says = claims.table(shares, 0)
        assert decide(says, Domain.of(paper_of("tooth_thickness"))).verdict is Verdict.REFUTED


def test_step_5_is_refuted_with_either_sign() -> None:
    step_5 = row("step 5")
    (other,) = step_5.readings
    for says in (step_5.statement, other.says):
        assert decide(says, Domain.of(paper_of("tooth_thickness"))).verdict is Verdict.REFUTED


def test_a_wrong_turn_of_the_flanks_refutes_the_reading() -> None:
    wrong = (
        mechanics.reading
        + mechanics.chord_by_thinning.subs(mechanics.thinning, mechanics.E_true) / 10
    )
    step_8 = row("step 8")
    says = dataclasses.replace(step_8.statement, rebuilt=wrong)
    assert decide(says, Domain.of(paper_of("tooth_thickness"))).verdict is Verdict.REFUTED
