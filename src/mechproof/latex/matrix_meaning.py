"""What is printed of vectors and matrices -> SymPy."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import sympy as sp

from mechproof.latex.matrices import assemble, cut
from mechproof.latex.products import UnclearProductError, is_matrix, multiply, show_entries
from mechproof.latex.tree import Entries, Excerpt, Magnitude, Product, Table, Transposed

if TYPE_CHECKING:
    from mechproof.latex.meaning import Meaning

ENTRIES = r"Print it for the entries, or \det for a determinant, the root of squares for a length."


def give_product(meaning: Meaning, node: Product) -> Any:
    """Return a product of numbers, vectors or matrices."""
    factors = [meaning.of(factor) for factor in node.factors]
    try:
        return multiply(factors, node.signs)
    except UnclearProductError as error:
        raise meaning.source.refuse(node.start, *error.args) from error


def give_table(meaning: Meaning, node: Table) -> sp.Basic:
    """Return a matrix of what is printed in it."""
    return assemble([[meaning.of(entry) for entry in row] for row in node.rows])


def give_entries(meaning: Meaning, node: Entries) -> sp.Basic:
    """Return several expressions in a bracket as a row."""
    return sp.ImmutableMatrix([[meaning.of(part) for part in node.parts]])


def give_excerpt(meaning: Meaning, node: Excerpt) -> Any:
    """Return rows and columns of a matrix."""
    whole = meaning.of(node.of)
    if not is_matrix(whole):
        raise meaning.source.refuse(node.start, "rows and columns of what is no matrix", ENTRIES)
    try:
        return cut(whole, node.ranges)
    except ValueError as error:
        raise meaning.source.refuse(
            node.start,
            f"rows and columns that this matrix does not have: {error}",
            "They count from 1 to the last one that is named, [1:3, 4].",
        ) from error


def give_magnitude(meaning: Meaning, node: Magnitude) -> sp.Expr:
    """Return an absolute value, or the length of a vector."""
    inside = meaning.of(node.inside)
    if not is_matrix(inside):
        return sp.Abs(inside)
    if 1 not in inside.shape:
        raise meaning.source.refuse(node.start, "a matrix where a number is meant", ENTRIES)
    return sp.sqrt(sp.Add(*(entry**2 for entry in show_entries(inside))))


def give_transposed(meaning: Meaning, node: Transposed) -> Any:
    """Return the transposed of a matrix."""
    whole = meaning.of(node.of)
    if not is_matrix(whole):
        raise meaning.source.refuse(node.start, "the transposed of what is no matrix", ENTRIES)
    return whole.T
