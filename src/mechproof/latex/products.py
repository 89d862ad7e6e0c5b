r"""Products of numbers, vectors and matrices: what a dot and a cross say of which.

`a\cdot b` of two columns is a number, `a\times b` of two with three entries a column; between
matrices both signs say what none says. What depends on which product comes first is refused.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import reduce
from operator import mul
from typing import Any

import sympy as sp

_CROSS, _DOT = r"\times", r"\cdot"


# What is not clear of a product, and what to print instead.
_SIDE_BY_SIDE = (
    "vectors and matrices side by side: which product is meant, which is taken first?",
    "Print brackets around a product of two vectors, T at one that is a row.",
)
_NUMBER_BY_VECTOR = (
    "a cross between a number and a vector: a cross product, or a multiple?",
    "Print the number as a vector for a cross product, no cross for a multiple.",
)
_OUT_OF_PLANE = (
    "a cross between vectors in space and in the plane: the one in space is not along z",
    "Print the third component of the other, too.",
)


class UnclearProductError(ValueError):
    """Factors of which it is not clear how they are multiplied: the reason, and the remedy."""


def is_matrix(value: Any) -> bool:
    """Return whether a value has rows and columns."""
    return isinstance(value, sp.MatrixBase | sp.MatrixExpr)


def show_entries(value: Any) -> Any:
    """Return a matrix with its entries, those of a symbol as elements of it."""
    return value.as_explicit() if isinstance(value, sp.MatrixExpr) else value


def invert(matrix: Any) -> Any:
    """Return the inverse of a matrix; `ValueError` for one that is not square."""
    shown = show_entries(matrix)
    if not shown.is_square:
        raise ValueError("only square matrices have an inverse")
    # Elimination would simplify at each step.
    return shown.adjugate(method="berkowitz") / shown.det(method="berkowitz")


def make_cross_matrix(vector: Any) -> sp.ImmutableMatrix:
    """Return the matrix of a cross product; `ValueError` for what has not three entries."""
    x, y, z = show_entries(vector)
    return sp.ImmutableMatrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def multiply(values: Sequence[Any], signs: Sequence[str]) -> Any:
    """Return a product; `UnclearProductError` where it may be one of several."""
    if not any(map(is_matrix, values)):
        return sp.Mul(*values)
    signs = signs or ("",) * (len(values) - 1)
    parts = [_cross(*part) for part in _split(values, signs, _DOT)]
    vectors = [part for part in parts if is_vector(part)]
    if len(vectors) < 2:
        return _take_number(reduce(mul, parts), values)
    _refuse_third(parts, vectors)
    one, other = map(show_entries, vectors)
    if one.shape != other.shape and other.shape[1] > 1:
        # A column before a row: a number to some, a matrix to others.
        raise UnclearProductError(*_SIDE_BY_SIDE)
    return sp.Mul(*_find_numbers(parts), one.dot(other))


def _split(
    values: Sequence[Any], signs: Sequence[str], sign: str
) -> Iterator[tuple[Sequence[Any], Sequence[str]]]:
    """Yield the factors between two of a sign, with the other signs between them."""
    ends = [n + 1 for n, one in enumerate(signs) if one == sign]
    for start, end in zip([0, *ends], [*ends, len(values)], strict=True):
        yield values[start:end], signs[start : end - 1]


def _cross(values: Sequence[Any], signs: Sequence[str]) -> Any:
    runs = [run for run, _ in _split(values, signs, _CROSS)]
    parts = [reduce(mul, run) for run in runs]
    vectors = [part for part in parts if is_vector(part)]
    if len(vectors) == 1 and any(part.free_symbols for part in _find_numbers(parts)):
        raise UnclearProductError(*_NUMBER_BY_VECTOR)
    if len(vectors) < 2:
        return reduce(mul, parts)
    _refuse_third(parts, vectors)
    turned = [n for n, run in enumerate(runs, 1) if sum(map(is_matrix, run)) > 1]
    # A matrix between the cross and a vector: whichever product is taken first is the same.
    if turned and (turned != [len(runs)] or not is_vector(parts[-1]) or is_vector(runs[-1][0])):
        raise UnclearProductError(*_SIDE_BY_SIDE)
    return sp.Mul(*_find_numbers(parts)) * _cross_entries(*map(show_entries, vectors))


def _cross_entries(one: Any, other: Any) -> Any:
    """Return a cross product; that of a vector along z by one in the plane is in the plane."""
    if {len(one), len(other)} != {2, 3}:
        return one.cross(other)
    x, y, z = sp.Matrix([*one, 0][:3]).cross(sp.Matrix([*other, 0][:3]))
    if z != 0:
        raise UnclearProductError(*_OUT_OF_PLANE)
    return sp.ImmutableMatrix(*((1, 2) if one.rows == 1 else (2, 1)), [x, y])


def _refuse_third(parts: Sequence[Any], vectors: Sequence[Any]) -> None:
    if len(vectors) > 2 or sum(map(is_matrix, parts)) > 2:
        raise UnclearProductError(*_SIDE_BY_SIDE)


def _find_numbers(parts: Sequence[Any]) -> list[Any]:
    return [part for part in parts if not is_matrix(part)]


def is_vector(value: Any) -> bool:
    """Return whether a value has one row or one column, of several entries."""
    return is_matrix(value) and 1 in value.shape and value.shape != (1, 1)


def _take_number(product: Any, values: Sequence[Any]) -> Any:
    """Return the entry of a row times a column."""
    if is_matrix(product) and product.shape == (1, 1) and any(map(is_vector, values)):
        return show_entries(product)[0, 0]
    return product
