"""Printed numbers hold to half a unit in the last place, neither more nor less."""

import pytest
import sympy as sp

from mechproof.proof.ladder import decide
from mechproof.proof.verdict import Verdict
from mechproof.record import PrintedNumber, rounded
from mechproof.statement_domains.domain import Domain

ANYWHERE = Domain({}, (), {})
DUST = sp.Rational(1, 10**40)

TRUE = {
    "resolution": ("0.088", sp.Rational(360, 4096)),
    "negative": ("-0.93", sp.Rational("-0.934")),
    "integer": ("95", 1000 * sp.sqrt(2) / 15 + sp.Rational("0.7")),
    "trailing zero": ("0.90", sp.Rational("0.904")),
    "half a place above": ("0.1", sp.Rational("0.15")),
    "half a place below": ("0.2", sp.Rational("0.15")),
    "negative half a place": ("-0.1", sp.Rational("-0.15")),
    "irrational": ("3.1416", sp.pi),
    "many digits": ("3.1415926535897932384626433832795028841972", sp.pi),
    "power of ten": ("2.1e5", sp.Integer(214_999)),
    "negative power of ten": ("5e-3", sp.Rational("0.0054")),
}
WRONG = {
    "last digit": ("0.087", sp.Rational(360, 4096)),
    "sign lost": ("0.93", sp.Rational("-0.934")),
    "sign added": ("-0.93", sp.Rational("0.934")),
    "trailing zero claims more": ("0.90", sp.Rational("0.91")),
    "beyond half a place": ("0.1", sp.Rational("0.15") + DUST),
    "beyond half a place, negative": ("-0.1", sp.Rational("-0.15") - DUST),
    "half the value": ("0.28", sp.Rational("0.56")),
    "irrational": ("3.1415", sp.pi),
    "the last of many digits": ("3.1415926535897932384626433832795028841973", sp.pi),
    "power of ten": ("2.10e5", sp.Integer(214_999)),
    "negative power of ten": ("5.0e-3", sp.Rational("0.0054")),
}


@pytest.mark.parametrize("name", TRUE)
def test_a_right_number_is_proved(name):
    answer = decide(PrintedNumber(*TRUE[name]), ANYWHERE)
    assert (answer.verdict, answer.rung) == (Verdict.PROVED, "recomputation")


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_number_is_refuted(name):
    answer = decide(PrintedNumber(*WRONG[name]), ANYWHERE)
    assert answer.verdict is Verdict.REFUTED
    assert answer.evidence[0].printed == WRONG[name][0]


@pytest.mark.parametrize("printed", ["1e", "e3", "1E3", "1/3", "0,5", "", " 1", ".5"])
def test_a_print_without_a_last_place_is_refused(printed):
    with pytest.raises(ValueError, match="is not a decimal number"):
        decide(PrintedNumber(printed, sp.Rational(2, 5)), ANYWHERE)


@pytest.mark.parametrize(
    "value", [sp.nan, sp.zoo, 1 / sp.Add(sp.pi, -sp.pi, evaluate=False), sp.log(-2)], ids=str
)
def test_an_undefined_value_is_not_proved(value):
    assert decide(PrintedNumber("0.1", value), ANYWHERE).verdict is Verdict.UNDECIDED


def test_a_value_on_the_rounding_boundary_that_balls_cannot_separate_stays_open():
    value = sp.Rational("0.15") + sp.Add(sp.sin(1) ** 2, sp.cos(1) ** 2, -1, evaluate=False)
    assert decide(PrintedNumber("0.1", value), ANYWHERE).verdict is Verdict.UNDECIDED


def test_numbers_and_values_go_in_pairs():
    assert rounded(("3", "2.7"), (sp.pi, sp.E)) == (
        PrintedNumber("3", sp.pi),
        PrintedNumber("2.7", sp.E),
    )
    with pytest.raises(ValueError, match="shorter"):
        rounded(("3", "2.7"), (sp.pi,))
