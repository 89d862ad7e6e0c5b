"""The prints of the papers are read as they were once typed by hand.

`frozen/<system>.tsv` has a line for each sign that was typed: the number of its row and the tree of
the printed side. The reading of the print must equal that tree up to names of bound symbols,
declared values, expansion, and cancelled parts that are noted because they need a value.
"""

from __future__ import annotations

from pathlib import Path

import pytest
import sympy as sp
from derived import paper_of

from mechproof import record
from mechproof.record import Definition, Equality, Paper, Row, ValueWhere

FROZEN = sorted((Path(__file__).parent / "frozen").glob("*.tsv"))
NAMES = vars(sp) | vars(record)
LINES = [
    pytest.param(file.stem, *line.split("\t"), id=f"{file.stem} {line.split(chr(9))[0]}")
    for file in FROZEN
    for line in file.read_text(encoding="utf-8").splitlines()
]


def resolve(tree: sp.Basic, paper: Paper) -> sp.Basic:
    given = {v.symbol: v.given for v in paper.variables if v.given is not None}
    while found := tree.free_symbols & given.keys():
        tree = tree.xreplace({symbol: given[symbol] for symbol in found})
    tree = tree.replace(ValueWhere, lambda value, needed: value)
    # A symbol alone would become a dummy itself.
    return tree if tree.is_Symbol else tree.as_dummy()


def is_same(one: sp.Basic, other: sp.Basic) -> bool:
    if one == other:
        return True
    if isinstance(one, sp.MatrixBase) or isinstance(other, sp.MatrixBase):
        return one.shape == other.shape and (one - other).expand().is_zero_matrix
    return sp.expand(one - other) == 0


def sides(row: Row) -> list[sp.Basic]:
    says = row.statement
    assert isinstance(says, Equality | Definition)
    return [says.printed, says.rebuilt] if isinstance(says, Equality) else [says.printed]


@pytest.mark.parametrize(("system", "number", "tree"), LINES)
def test_a_print_is_read_as_it_was_typed(system: str, number: str, tree: str) -> None:
    paper = paper_of(system)
    (row,) = (row for row in paper.rows if row.number == number)
    typed = resolve(sp.sympify(tree, locals=NAMES), paper)
    assert any(is_same(resolve(side, paper), typed) for side in sides(row))
