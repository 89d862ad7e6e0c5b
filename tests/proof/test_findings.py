"""Findings: costs at stated sizes, and followers that are proved once their cause is corrected."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp

from mechproof.ledger.cards import make_card
from mechproof.ledger.ledger_findings import LedgerFinding, follower_rows, list_findings
from mechproof.proof.judge import judge
from mechproof.record import (
    LENGTH,
    Check,
    Claim,
    Correction,
    Cost,
    Equality,
    Equation,
    Finding,
    FollowingRow,
    Holds,
    Paper,
    Part,
    PrintedNumber,
    Reading,
    Row,
    Variable,
    Weight,
)

phi, psi = sp.symbols("phi psi", real=True)
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
RENAMED = {phi: psi}
IN_OTHER_LETTERS = Equation(
    "(5)", "u", Equality(PRINTED.subs(RENAMED) + sp.cos(phi) * r, RIGHT.subs(RENAMED) + PRINTED)
)
A_PART = Equation("(6)", "s", Equality(r * sp.cos(phi) / 2 + r, r * sp.sin(phi) / 2 + r))
MEMBERS = Equation("(7)", "p=q", Equality(RIGHT, PRINTED, rebuilt_from="member"))
UNRELATED = Equation("(4)", "v", Equality(r, 2 * r))
TRUE = Claim("true", "t", Holds(sp.Ge(r, 0, evaluate=False)))
CONVENTION = Claim(
    "turned", "a", Equality(phi, -phi), readings=(Reading("against", Equality(-phi, -phi)),)
)
NUMBER = Claim("number", "1.2", PrintedNumber("1.2", sp.Rational(5, 2)))


def find(*findings: Finding, others: tuple[Row, ...] = ()) -> tuple[LedgerFinding, ...]:
    paper = Paper(
        "mine",
        "",
        (
            Variable(phi, "angle"),
            Variable(psi, "the angle of another wheel"),
            Variable(r, "radius", LENGTH, sp.Interval.open(0, sp.oo)),
        ),
        (ROOT, FOLLOWER, WRONG_ANYWAY, UNRELATED, *others, TRUE, NUMBER),
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


@pytest.mark.parametrize(
    ("row", "follower"),
    [
        # Our side of (5) contains the print as well: there it stays.
        (IN_OTHER_LETTERS, FollowingRow("(5)", renamed=RENAMED)),
        (A_PART, FollowingRow("(6)", parts={sp.cos(phi): sp.sin(phi)})),
        (MEMBERS, FollowingRow("(7)")),
    ],
)
def test_a_follower_may_have_other_letters_parts_or_the_print_as_second_member(
    row: Equation, follower: FollowingRow
) -> None:
    first, *others = find(Finding("(1)", "", follows=(follower,)), others=(row,))
    assert first.follows == (row.number,)
    assert row.number not in [found.number for found in others]


def test_a_follower_may_hold_the_matrix_of_its_cause_as_a_whole() -> None:
    printed, right = sp.ImmutableMatrix([[phi, psi]]), sp.ImmutableMatrix([[psi, phi]])
    cause = Claim(
        "order",
        "m",
        Equality(printed, right),
        corrected=Correction("m", Equality(right, right)),
    )
    again = Claim("order again", "n", Equality(printed, right))
    first = next(
        found
        for found in find(Finding("order", "", follows=("order again",)), others=(cause, again))
        if found.number == "order"
    )
    assert first.follows == ("order again",)


def test_two_values_of_which_neither_is_right_have_names_and_no_error() -> None:
    cost = Cost("sum", "mm", 0, sp.Integer(1), sp.Integer(2), ("as read", "as guessed"))
    first, *_ = find(Finding("(1)", "", (cost,)))
    assert tuple(map(str, first.costs)) == ("sum: as read 1 mm, as guessed 2 mm",)


def test_a_name_that_ends_in_a_letter_or_a_number_is_told_apart_from_its_value() -> None:
    cost = Cost("sum", "mm", 2, sp.S.Zero, sp.Integer(2), ("by 2u", "by u = s/√n"))
    first, *_ = find(Finding("(1)", "", (cost,)))
    assert tuple(map(str, first.costs)) == ("sum: by 2u: 0 mm, by u = s/√n: 2.00 mm",)


def test_a_convention_is_wrong_only_when_read_literally() -> None:
    found = find(
        Finding("turned", "", (Cost("here", "°", at={phi: sp.pi / 6}),)), others=(CONVENTION,)
    )
    (cost,) = next(finding.costs for finding in found if finding.number == "turned")
    assert str(cost) == "here: read literally 30.0°, right -30.0°, off by 60.0°"


def test_costs_are_computed_at_the_sizes_in_the_unit() -> None:
    at = {phi: sp.pi / 6, r: sp.Integer(10)}
    turned = Cost("as angles", "°", 2, printed=phi, right=2 * phi, at={phi: sp.pi / 6})
    first, *_, last = find(
        Finding("(1)", "", (Cost("30°", "mm", 3, at=at), turned)),
        Finding("number", "", (Cost("here"),)),
    )
    assert tuple(map(str, first.costs)) == (
        "30°: printed 8.660 mm, right 5.000 mm, off by 3.660 mm",
        "as angles: printed 30.00°, right 60.00°, off by 30.00°",
    )
    assert tuple(map(str, last.costs)) == ("here: printed 1.2, right 2.5, off by 1.3",)


@pytest.mark.parametrize(
    ("finding", "message"),
    [
        (Finding("(9)", "", follows=("(2)",)), r"no row '\(9\)'"),
        (Finding("(1)", "", follows=("(9)",)), r"no row '\(9\)'"),
        (Finding("true", ""), "row is PROVED"),
        (Finding("(1)", "", follows=("(4)",)), r"'\(4\)' does not contain .* '\(1\)' corrects"),
        (Finding("(1)", "", follows=("(3)",)), r"'\(3\)' does not follow from '\(1\)'.*REFUTED"),
        (Finding("(4)", "", follows=("(3)",)), "it needs a correction"),
        (
            Finding("(1)", "", follows=(FollowingRow("(2)", parts={sp.cos(phi): sp.tan(phi)}),)),
            r"it does not correct cos\(phi\) to tan\(phi\)",
        ),
        (
            Finding("(1)", "", follows=(FollowingRow("(2)", parts={sp.tan(phi): sp.sin(phi)}),)),
            r"it does not correct tan\(phi\) to sin\(phi\)",
        ),
        (
            Finding("(1)", "", follows=(FollowingRow("(2)", renamed={phi: psi}),)),
            r"'\(2\)' does not contain .* '\(1\)' corrects",
        ),
        (
            Finding("(1)", "", (Cost("nowhere", at={r: sp.Integer(1)}),)),
            "nowhere: no size is given for .'phi'",
        ),
        (Finding("(1)", "", mend="(4)"), r"mend = '\(4\)': must be PROVED, but is REFUTED"),
        (Finding("(1)", "", mend="(9)"), r"mend = '\(9\)': must be PROVED, but is not a row"),
        (Finding("(1)", "", check=Check("{0}", (1 / r,))), "no size"),
        (Finding("(1)", "", (Cost("x", "km"),)), "unit = 'km'"),
        (Finding("(3)", "", (Cost("x", "", printed=1 / r, right=r),)), "no size"),
        (Finding("(3)", "", (Cost("x", "", 1, 1 / r, r, at={r: sp.S.Zero}),)), "no value there"),
    ],
)
def test_what_is_no_finding_is_refused(finding: Finding, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        find(finding)


def test_the_gravest_findings_come_first() -> None:
    found = find(
        Finding("(1)", "", weight=Weight.WORDING), Finding("(4)", "", weight=Weight.CONCLUSION)
    )
    assert [one.number for one in found] == ["(4)", "(2)", "(3)", "number", "(1)"]


def test_a_mend_that_is_proved_is_shown_beside_the_correction() -> None:
    first, *_ = find(Finding("(1)", "", mend="true"))
    assert (first.mend_latex, first.corrected_latex) == ("t", "y")
    assert first.mend_by == "sign in positive coordinates"


def test_the_card_says_where_a_mend_holds() -> None:
    on = Part("r > 1", {r: sp.Interval.open(1, sp.oo)})
    within = Claim("within", "m", Holds(sp.Ge(r, 0, evaluate=False)), on=on)
    first, *_ = find(Finding("(1)", "", mend="within"), others=(within,))
    card = make_card(first)
    assert card.mends == (
        ("Right", "m", f"{first.mend_by}; where r > 1"),
        ("In general", "y", first.corrected_by),
    )


def test_the_numbers_of_a_check_are_computed() -> None:
    check = Check("at 30° {0}, twice {1}", (sp.pi / 6, sp.pi / 3), 1, "°")
    first, *_ = find(Finding("(1)", "", check=check))
    assert first.check == "at 30° 30.0°, twice 60.0°"
    bare = replace(check, text="{0} are {0:4} rad")
    first, *_ = find(Finding("(1)", "", check=bare))
    assert first.check == "30.0° are 0.5236 rad"


def test_a_row_is_one_finding() -> None:
    with pytest.raises(ValueError, match=r"findings given twice: \['\(1\)'\]"):
        find(Finding("(1)", "a cause"), Finding("(1)", "another"))
