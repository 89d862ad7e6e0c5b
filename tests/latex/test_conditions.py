"""Conditions of a print: relations joined by "and"."""

from __future__ import annotations

import pytest
import sympy as sp

from mechproof.latex import Reader
from mechproof.latex.errors import ReadingError
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
