"""Rows of the paper that are slightly wrong are refuted, or true on less."""

from __future__ import annotations

import dataclasses

import pytest
from derived import paper_of
from sympy import Interval, Rational, oo
from weights import make_thorough

from mechproof.derivations.tooth_thickness import influence, mechanics
from mechproof.proof.domain import Domain
from mechproof.proof.judge import judge
from mechproof.proof.ladder import decide
from mechproof.proof.verdict import Verdict
from mechproof.record import Part, PrintedNumber, Row


def row(number: str) -> Row:
    return next(row for row in paper_of("tooth_thickness").rows if row.number == number)


# Where the claim is said to hold, a little too much.
TOO_WIDE = {
    "(b)": {mechanics.gauge_um: Interval.open(Rational("2.453"), oo)},
    "(1), influence 0.7284": {mechanics.tilt: Interval(0, 3 * mechanics.NARROW)},
    "step 6, influence of the involute": {mechanics.tilt: Interval(0, 3 * mechanics.NARROW)},
    "smallest deviation, guaranteed side clearance": {mechanics.mate: Interval(0, oo)},
    "(a), rise with the limit error": {mechanics.above: Interval.open(0, oo)},
}


# These take seconds each.
SLOW = ("(1), influence 0.7284", "step 6, influence of the involute")


@pytest.mark.parametrize("number", [make_thorough(n) if n in SLOW else n for n in TOO_WIDE])
def test_a_claim_does_not_hold_on_more(number: str) -> None:
    wider = dataclasses.replace(row(number), holds_on=Part("more", TOO_WIDE[number]))
    assert judge(row(number), paper_of("tooth_thickness")).verdict is Verdict.CONDITIONAL
    assert judge(wider, paper_of("tooth_thickness")).verdict is not Verdict.CONDITIONAL


def test_another_crossover_is_refuted() -> None:
    says = PrintedNumber("5.0", 2 * mechanics.crossover(6))
    assert decide(says, Domain.of(paper_of("tooth_thickness"))).verdict is Verdict.REFUTED


def test_the_height_leaves_no_profile_angle_for_the_printed_influence() -> None:
    printed = influence.rounds_at(
        influence.rack_height_by_slope, Rational("2.2425"), Rational("0.7284")
    )
    assert decide(printed[0], Domain.of(paper_of("tooth_thickness"))).verdict is Verdict.REFUTED


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
