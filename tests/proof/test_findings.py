"""Findings: costs at stated sizes, and followers that are proved once their cause is corrected."""

from __future__ import annotations

import pytest
import sympy as sp

from mechproof.proof.findings import Found, follower_rows, list_findings
from mechproof.proof.judge import judge
from mechproof.record import (
    LENGTH,
    Claim,
    Correction,
    Cost,
    Equality,
    Equation,
    Finding,
    Holds,
    Paper,
    PrintedNumber,
    Variable,
)

phi = sp.Symbol("phi", real=True)
r = sp.Symbol("r", positive=True)
PRINTED, RIGHT = r * sp.cos(phi), r * sp.sin(phi)
ROOT = Equation(
    "(1)",
    r"y=r\cos\varphi",
    Equality(PRINTED, RIGHT),
    corrected=Correction("y", Equality(RIGHT, RIGHT)),
)
FOLLOWER = Equation(
    "(2)",
    "z",
    Equality(2 * PRINTED, 2 * RIGHT),
    corrected=Correction("z", Equality(2 * RIGHT, 2 * RIGHT)),
)
WRONG_ANYWAY = Equation("(3)", "w", Equality(PRINTED + r, RIGHT))
UNRELATED = Equation("(4)", "v", Equality(r, 2 * r))
TRUE = Claim("true", "t", Holds(sp.Ge(r, 0, evaluate=False)))
NUMBER = Claim("number", "1.2", PrintedNumber("1.2", sp.Rational(5, 2)))


def find(*findings: Finding) -> tuple[Found, ...]:
    paper = Paper(
        "mine",
        "",
        (Variable(phi, "angle"), Variable(r, "radius", LENGTH, sp.Interval.open(0, sp.oo))),
        (ROOT, FOLLOWER, WRONG_ANYWAY, UNRELATED, TRUE, NUMBER),
        findings=findings,
    )
    rows = (*paper.rows, *follower_rows(paper))
    return list_findings(paper, [judge(row, paper) for row in rows])


def test_every_wrong_row_is_a_finding_of_its_own() -> None:
    assert [found.number for found in find()] == ["(1)", "(2)", "(3)", "(4)", "number"]


def test_what_follows_is_listed_under_its_cause_and_not_counted_again() -> None:
    first, *others = find(Finding("(1)", "sine, not cosine", follows=("(2)",)))
    assert (first.number, first.wrong, first.follows) == ("(1)", "sine, not cosine", ("(2)",))
    assert [found.number for found in others] == ["(3)", "(4)", "number"]


def test_costs_are_computed_at_the_sizes_in_the_unit() -> None:
    at = {phi: sp.pi / 6, r: sp.Integer(10)}
    turned = Cost("as angles", {phi: sp.pi / 6}, "°", 2, printed=phi, right=2 * phi)
    first, *_, last = find(
        Finding("(1)", "", (Cost("30°", at, "mm", 3), turned)),
        Finding("number", "", (Cost("here", {}),)),
    )
    assert first.costs == (
        "30°: printed 8.660mm, right 5.000mm, off by 3.660mm",
        "as angles: printed 30.00°, right 60.00°, off by 30.00°",
    )
    assert last.costs == ("here: printed 1.2, right 2.5, off by 1.3",)


@pytest.mark.parametrize(
    ("finding", "message"),
    [
        (Finding("(9)", "", follows=("(2)",)), r"no row '\(9\)'"),
        (Finding("(1)", "", follows=("(9)",)), r"no row '\(9\)'"),
        (Finding("true", ""), "it is PROVED"),
        (Finding("(1)", "", follows=("(4)",)), r"'\(4\)' does not hold what '\(1\)' corrects"),
        (Finding("(1)", "", follows=("(3)",)), r"'\(3\)' does not follow from '\(1\)'.*REFUTED"),
        (Finding("(4)", "", follows=("(3)",)), "it needs a correction"),
        (
            Finding("(1)", "", (Cost("nowhere", {r: sp.Integer(1)}),)),
            "nowhere: no size is given for .'phi'",
        ),
        (Finding("(1)", "", (Cost("x", {}, "km"),)), "unit = 'km'"),
        (Finding("(3)", "", (Cost("x", {}, "", printed=1 / r, right=r),)), "no size"),
        (Finding("(3)", "", (Cost("x", {r: sp.S.Zero}, "", 1, 1 / r, r),)), "no value there"),
    ],
)
def test_what_is_no_finding_is_refused(finding: Finding, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        find(finding)
