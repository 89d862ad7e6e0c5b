"""Corrections and readings concern their row: a true statement of something else is an error."""

from __future__ import annotations

import pytest
import sympy as sp

from mechproof.latex import read_paper
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Verdict
from mechproof.record import (
    Claim,
    Conjunction,
    Correction,
    Definition,
    Distinct,
    Equality,
    Equation,
    Holds,
    Paper,
    PrintedNumber,
    Reading,
    RecordError,
    Row,
    Statement,
    Variable,
)

r, x, d = sp.symbols("r x d", real=True)
ONE = sp.sin(r) ** 2 + sp.cos(r) ** 2
VARIABLES = (
    Variable(r, "radius", latex=("r",)),
    Variable(x, "length", latex=("x",)),
    Variable(d, "diameter", given=2 * r, latex=("d",)),
)
PAPER = Paper("s", "c", VARIABLES, ())
FORMULA, WORDS = "x=2r", r"\text{the length is two radii}"
SAYS: Statement = Equality(2 * r, 3 * r)
OF_PRINT: Statement = Equality(2 * r, 3 * r, "member")

MENDS: dict[str, tuple[Statement, Statement]] = {
    "the other side again": (SAYS, Equality(3 * r * ONE, 3 * r)),
    "the other side, the same": (SAYS, Equality(3 * r, 3 * r)),
    "the other side by a declared letter": (Equality(r, 2 * r), Equality(2 * r * ONE, d)),
    "one of several": (SAYS, Conjunction((Equality(3 * r, 3 * r), Equality(ONE, 1)))),
    "a member of the print": (OF_PRINT, Equality(2 * r, 2 * r * ONE, "member")),
    "a number": (PrintedNumber("2", sp.Integer(3)), PrintedNumber("3", sp.Integer(3))),
    "a side of a relation": (
        Holds(sp.Gt(-(r**2), 1, evaluate=False)),
        Holds(sp.Lt(-(r**2), 1, evaluate=False)),
    ),
}
STRANGE: dict[str, tuple[Statement, Statement]] = {
    "a letter is itself": (SAYS, Equality(r, r)),
    "an identity": (SAYS, Equality((r + 1) ** 2, r**2 + 2 * r + 1)),
    "the print is itself": (SAYS, Equality(2 * r, 2 * r)),
    "the print in other words": (SAYS, Equality(2 * r, 2 * r * ONE)),
    "a member is itself": (OF_PRINT, Equality(2 * r, 2 * r, "member")),
    "a declaration": (SAYS, Equality(d, 2 * r)),
    "a definition": (SAYS, Definition(d, 2 * r)),
    "a relation": (SAYS, Holds(sp.Ge(r**2, 0, evaluate=False))),
    "a relation of a side to itself": (
        Holds(sp.Gt(-(r**2), 1, evaluate=False)),
        Holds(sp.Ge(-(r**2), -(r**2), evaluate=False)),
    ),
    "another number": (PrintedNumber("2", sp.Integer(3)), PrintedNumber("4", sp.Integer(4))),
    "parts of others": (SAYS, Conjunction((Equality(r, r), Equality(ONE, 1)))),
    "sides that differ": (SAYS, Distinct(r, r + 1)),
}


@pytest.mark.parametrize("name", MENDS)
def test_a_correction_states_the_quantity_of_its_row(name: str) -> None:
    says, mend = MENDS[name]
    judgement = judge(Equation("(1)", FORMULA, says, corrected=Correction("x=3r", mend)), PAPER)
    assert (judgement.verdict, bool(judgement.corrected_by)) == (Verdict.REFUTED, True)


@pytest.mark.parametrize("name", STRANGE)
def test_a_correction_of_something_else_is_an_error(name: str) -> None:
    says, mend = STRANGE[name]
    with pytest.raises(RecordError, match="correction 'r=r'"):
        judge(Equation("(1)", FORMULA, says, corrected=Correction("r=r", mend)), PAPER)


READINGS: dict[str, Statement] = {
    "the print against something else": Equality(2 * r, 2 * r * ONE),
    "another print against the same": Equality(3 * r * ONE, 3 * r),
}
NO_READINGS: dict[str, Statement] = {
    "a letter is itself": Equality(r, r),
    "the print is itself": Equality(2 * r, 2 * r),
    "the print is itself, and more": Conjunction((Equality(2 * r, 2 * r), Equality(ONE, 1))),
    "an identity": Equality((r + 1) ** 2, r**2 + 2 * r + 1),
    "a relation": Holds(sp.Ge(r**2, 0, evaluate=False)),
    "nothing": Equality(sp.S.Zero, sp.S.Zero),
}


@pytest.mark.parametrize("name", READINGS)
def test_a_reading_keeps_the_print_or_what_is_held_against_it(name: str) -> None:
    row = Equation("(1)", FORMULA, SAYS, readings=(Reading("radii of two", READINGS[name]),))
    assert judge(row, PAPER).verdict is Verdict.CONVENTION


@pytest.mark.parametrize("name", NO_READINGS)
@pytest.mark.parametrize("latex", [FORMULA, "2r"])
def test_a_reading_of_something_else_is_an_error(name: str, latex: str) -> None:
    reading = Reading("radii of two", NO_READINGS[name])
    with pytest.raises(RecordError, match="reading 'radii of two'"):
        judge(Equation("(1)", latex, SAYS, readings=(reading,)), PAPER)


@pytest.mark.parametrize("name", ["a letter is itself", "nothing"])
def test_of_words_a_reading_still_says_something(name: str) -> None:
    def read(says: Statement) -> Row:
        return Claim("c", WORDS, SAYS, readings=(Reading("read so", says),))

    assert judge(read(Equality(r * ONE, r)), PAPER).verdict is Verdict.CONVENTION
    with pytest.raises(RecordError, match="reading 'read so'"):
        judge(read(NO_READINGS[name]), PAPER)


READ = {
    "r=r": "keeps no member",
    "x=x": "only says that x is",
    r"x=\sqrt{x^2}": "only says that x is",
    "3r=3r": "keeps no member",
    "2r=2r": "only says that 2[*]r is",
}


@pytest.mark.parametrize("latex", READ)
@pytest.mark.parametrize("more", [{"derived": {x: 3 * r}}, {"residual": sp.S.Zero}])
def test_a_correction_that_is_read_keeps_a_member_and_says_something(
    latex: str, more: dict[str, object]
) -> None:
    row = Equation("(1)", FORMULA, corrected=Correction(latex), **more)
    with pytest.raises(ValueError, match=READ[latex]):
        read_paper(Paper("s", "c", VARIABLES, (row,)))


@pytest.mark.parametrize("latex", ["3r", "x=3r", "3r=x", "2x=6r"])
def test_a_correction_of_a_side_is_read(latex: str) -> None:
    row = Equation("(1)", FORMULA, derived={x: 3 * r}, corrected=Correction(latex))
    if latex in ("3r", "x=3r"):
        (read,) = read_paper(Paper("s", "c", VARIABLES, (row,))).rows
        assert judge(read, PAPER).corrected_by
        return
    with pytest.raises(ValueError, match="keeps no member"):
        read_paper(Paper("s", "c", VARIABLES, (row,)))
