"""Conditions of a print: relations joined by "and"."""

from __future__ import annotations

import pytest
import sympy as sp

from mechproof.latex import Reader
from mechproof.latex.errors import ReadingError
from mechproof.latex.words import AND
from mechproof.record import Equation, Variable

f, x, y = sp.symbols("f x y", real=True)
READER = Reader([Variable(s, "a number", latex=(str(s),)) for s in (f, x, y)])


def test_relations_are_joined_by_and() -> None:
    print_ = r"f=1\text{ if }x<y\text{ and }y>2x,\text{ else }0"
    _, value = READER.members(Equation("(1)", print_))
    condition = sp.And(sp.Lt(x, y), sp.Gt(y, 2 * x), evaluate=False)
    assert value == sp.Piecewise((1, condition), (0, True), evaluate=False)


@pytest.mark.parametrize(
    "condition", [r"x\text{ and }x<y", r"x<y\text{ and }x", r"x<y\text{ and }y\text{ and }x<1"]
)
def test_each_side_of_and_needs_a_relation(condition: str) -> None:
    with pytest.raises(ReadingError, match="relation sign"):
        READER.members(Equation("(1)", rf"f=1\text{{ if }}{condition},\text{{ else }}0"))


BEHIND = [
    *(rf"f=1\text{{ {word} }}x>0" for word in ("if", "for", "where", "when", "with", "for all")),
    *(rf"f=1{mark}x>0" for mark in (",", r",\ ", r",\quad ", r"\quad ", r"\qquad ", ";", r",\;")),
    *(rf"f=1{mark}\text{{ for }}x>0" for mark in (",", r"\quad", r"\ ", r",\ ")),
    *(rf"f=1\quad\text{{for}}{gap}x>0" for gap in (r"\quad ", r"\qquad ", r"\ ")),
    *(rf"f=1{mark}(x>0)" for mark in ("", ",", r"\quad", r"\ ")),
    *(r"f=1\ [x>0]", r"f=1\quad(\text{for }x>0)", r"f=1\ (\forall x>0)", r"f=1\ \forall x>0"),
    *(r"f=1\mathrm{\ for\ }x>0", r"f=1\mbox{ If }x>0", r"f=1\textrm{, for }x>0", "f=1 ∀x>0"),
]
BOTH = [
    *(r"f=1,\ x>0,\ y>0", "f=1,x,y>0", r"f=1\quad x,\ y>0", r"f=1\text{ for }x,y>0"),
    *(r"f=1\text{ for }x>0\text{ and }y>0", r"f=1\ (x>0,\ y>0)", r"f=1\quad x>0\quad y>0"),
    *(r"f=1\text{ for }x>0,\ y>0", r"f=1\text{ for }x>0\land y>0", r"f=1\quad(x>0)\ (y>0)"),
]


BEFORE = [rf"x>0{mark}f=1" for mark in (",", r",\ ", r",\quad ", r"\quad ", r",\qquad ", ";")]


def conditions(print_: str) -> set[sp.Basic]:
    read = READER.parse(print_)
    (chain,) = read.chains
    assert read.meaning().of(chain.members[1]) == 1
    assert chain.condition is not None
    return set(read.meaning().relate(chain.condition))


@pytest.mark.parametrize("print_", [*BEHIND, *BEFORE])
def test_a_condition_is_read_in_every_spelling(print_: str) -> None:
    assert conditions(print_) == {sp.Gt(x, 0)}


@pytest.mark.parametrize("print_", BOTH)
def test_several_conditions_hold_together(print_: str) -> None:
    assert conditions(print_) == {sp.Gt(x, 0), sp.Gt(y, 0)}


def test_two_bounds_of_one_letter_are_no_question() -> None:
    assert conditions(r"f=1,\ 0<x,x<1") == {sp.Lt(0, x), sp.Lt(x, 1)}


@pytest.mark.parametrize("more", [r"y=0", r"y=\frac{\pi}{2}", r"y=-1"])
@pytest.mark.parametrize("first", ["x=0", "x>0", "0<x<1"])
def test_a_value_behind_a_condition_is_one(first: str, more: str) -> None:
    said = conditions(rf"f=1\text{{ for }}{first},\ {more}")
    assert said == conditions(rf"f=1\text{{ for }}{first}\text{{ and }}{more}")


def test_a_condition_holds_for_all_equations_before_it() -> None:
    chains = READER.parse(r"f=1,\ y=2,\ x>0").chains
    assert [len(chain.relations) for chain in chains] == [1, 1]
    assert chains[0].condition == chains[1].condition is not None


def test_a_gap_without_a_relation_around_it_is_a_blank() -> None:
    assert READER.members(Equation("(1)", r"f=x\quad+\quad y")) == (f, x + y)
    assert READER.members(Equation("(1)", r"f\quad x=x\ f")) == (f * x, f * x)
    ((_, value),) = [READER.members(Equation("(1)", r"f=\int_0^1y\quad dy"))]
    assert value.doit() == sp.Rational(1, 2)


def test_an_inequality_of_more_than_a_letter_before_an_equation_is_a_claim_as_well() -> None:
    claim, statement = READER.parse(r"x+y>0,\quad f=1,\ x<1").chains
    assert (claim.relations, claim.condition) == ((">",), None)
    assert statement.condition is not None
    assert statement.condition.relations == (">", AND, "<")


def test_several_equations_behind_an_inequality_are_meant_where_it_holds() -> None:
    first, second = READER.parse(r"x>0,\ y>0,\quad f=1,\quad |x|=x").chains
    assert first.condition == second.condition
    assert second.condition is not None
    assert second.condition.relations == (">", AND, ">")


REFUSED = [
    (r"f=x\;y>0", "a blank before a relation"),
    (r"f=x~x,y>0", "a blank before a relation"),
    (r"f=x\ -1<x<1", "a blank before a relation"),
    (r"f=x\quad y=1", "a wide gap before an equation"),
    (r"f=1\quad f=2", "a wide gap before an equation"),
    (r"\text{for }x>0,\ f=1", "a condition before"),
    (r"\forall x>0:f=1", "a condition before"),
    (r"f=1,\ x>0,\ y=2", "an equation after a condition"),
    (r"f=1\text{ for }x>0,\ y=2x", "an equation after a condition"),
    (r"f=1\text{ for }x>0,\ f=2", "an equation after a condition"),
    (r"f=1\text{ for }x>0,\ x=2", "an equation after a condition"),
    (r"x^2\ge0,\ y^2\ge0", "a condition of the first, or a claim of its own"),
    (r"f=1,\ 0<x,y<1", "letters between two bounds"),
    (r"f=1,\ x\in(0,1,2)", "two ends"),
    (r"f=1,\ x\in\mathbb Q", "sets are not read"),
    (r"f=1\quad(x\in\mathbb N)", "sets are not read"),
    (r"f=1\ \forall x\in\mathbb N", "sets are not read"),
    (r"f=1\text{ if $x>0$}", "is not understood here"),
    (r"f=1\text{ if and only if }x>0", "is not understood here"),
    (r"f=1\text{ or }x>0", "is not understood here"),
    (r"x>0\Rightarrow f=1", "no meaning here"),
    (r"f=x for x>0", "in italics"),
    (r"f=1\hspace{1em}x>0", "no meaning here"),
]


@pytest.mark.parametrize(("print_", "told"), REFUSED)
def test_what_may_be_a_condition_or_not_is_refused(print_: str, told: str) -> None:
    with pytest.raises(ReadingError, match=told):
        READER.parse(print_)
