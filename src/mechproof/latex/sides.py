"""Two sides of a relation, matched in kind: rows, entries, signs, decimals."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import sympy as sp
from sympy.matrices.expressions.matexpr import MatrixElement

from mechproof.latex.matrix_meaning import is_matrix, show_entries
from mechproof.latex.measures import split_sign
from mechproof.latex.tree import Degrees, Entries, Measure, Node, Number, strip
from mechproof.record import PrintedNumber, family_of

# Functions that take each value once in a range -> their inverses, and that range.
INVERSES: Mapping[type[sp.Basic], tuple[type[sp.Basic], sp.Interval]] = {
    sp.sin: (sp.asin, sp.Interval(-sp.pi / 2, sp.pi / 2)),
    sp.cos: (sp.acos, sp.Interval(0, sp.pi)),
    sp.tan: (sp.atan, sp.Interval.open(-sp.pi / 2, sp.pi / 2)),
}


def turn(nodes: tuple[Node, Node], sides: tuple[Any, Any]) -> tuple[Any, Any]:
    """Return sides in which comma-separated entries become a column if the other side is one.

    A zero opposite a matrix becomes a matrix of zeros, except opposite a letter, whose value it is.
    """
    left, right = (_fill(*pair) for pair in (sides, sides[::-1]))
    sides = left, right
    if not (is_matrix(left) and is_matrix(right)) or left.shape != right.shape[::-1]:
        return sides
    if isinstance(strip(nodes[1]), Entries) and 1 in left.shape:
        return left, right.T
    if isinstance(strip(nodes[0]), Entries) and 1 in left.shape:
        return left.T, right
    return sides


def _fill(side: Any, other: Any) -> Any:
    is_open = is_matrix(other) and not isinstance(other, sp.MatrixSymbol)
    return sp.ImmutableMatrix.zeros(*other.shape) if is_open and side == 0 else side


def list_arcs(sides: tuple[Any, Any]) -> Iterator[tuple[sp.Function, sp.Expr]]:
    """Yield a side that is the sine, cosine or tangent of a letter, and the arc of the other."""
    for function, value in (sides, sides[::-1]):
        arc, _ = INVERSES.get(getattr(function, "func", sp.Basic), (None, None))
        is_formula = isinstance(value, sp.Expr) and not value.is_Matrix
        if arc and function.args[0].is_Symbol and is_formula:
            yield function, arc(value)


def name_entries(side: Any) -> Any:
    """Return a side in which the elements of matrix symbols are members of an indexed family."""
    if not side.has(sp.MatrixSymbol):
        return side
    shown = show_entries(side)
    elements = shown.atoms(MatrixElement)
    named = {e: family_of(e.parent)[e.i + 1, e.j + 1] for e in elements}
    return shown.xreplace(named)


def says_nothing(left: Any, right: Any) -> bool:
    """Return whether an equation cannot be checked for matrices without known entries.

    It cannot if one of them is alone on a side, or if they are on one side only, or on sides of
    different kinds, and the sides are not identically equal.
    """
    sides = (left, right)
    if any(isinstance(side, sp.MatrixSymbol) for side in sides):
        return True
    unknown = [side.has(sp.MatrixSymbol) for side in sides]
    if not any(unknown) or (all(unknown) and left.is_Matrix == right.is_Matrix):
        return False
    entries = [[*side] if is_matrix(side) else [side] for side in map(name_entries, sides)]
    if len(entries[0]) != len(entries[1]):
        return True
    return any(sp.expand(one - other) != 0 for one, other in zip(*entries, strict=True))


def round_to(node: Node, value: Any) -> PrintedNumber | None:
    """Return the claim that a value rounds to a printed number; None if no number is printed."""
    sign, node = split_sign(strip(node))
    if isinstance(node, Degrees):
        node, value = node.number, value * 180 / sp.pi
    if isinstance(node, Measure):
        node = node.number
    return PrintedNumber(sign + node.text, value) if isinstance(node, Number) else None
