r"""Printed vectors and matrices -> SymPy.

`a\cdot b` of two columns is a number, `a\times b` of two with three entries a column; between
matrices both signs mean the same as no sign. A product whose value depends on which factors are
multiplied first is refused.

A power of a matrix to a whole number n is read by its first value and its recursion:
A^n = B(n) for n = 1, 2, ... asserts that B(1) = A and B(n + 1) = B(n)A, and no more.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from functools import reduce
from operator import mul
from typing import TYPE_CHECKING, Any

import sympy as sp

from mechproof.latex.tree import Excerpt, Magnitude, Product, Transposed
from mechproof.record import Conjunction, Equality, ValueWhere, list_divisors
from mechproof.record.substitution import substitute

if TYPE_CHECKING:
    from mechproof.latex.meaning import Meaning

ENTRIES = r"Print the entries, \det for a determinant, or the root of the squares for a length."
_CROSS, _DOT = r"\times", r"\cdot"


# Reasons why a product is unclear, and what to print instead.
_SIDE_BY_SIDE = (
    "adjacent vectors and matrices: which product is meant, and which comes first?",
    "Print brackets around a product of two vectors, and T on a row vector.",
)
_NUMBER_BY_VECTOR = (
    "a cross between a number and a vector: a cross product, or a multiple?",
    "Print the number as a vector for a cross product, no cross for a multiple.",
)
_OUT_OF_PLANE = (
    "a cross between vectors in space and in the plane: the one in space is not along z",
    "Print the third component of the other, too.",
)


def assemble(rows: Sequence[Sequence[Any]]) -> sp.ImmutableMatrix:
    """Return the matrix of entries or blocks; a zero fills its block.

    Raises `ValueError` for blocks whose shapes do not fit.
    """
    blocks = [[show_entries(entry) for entry in row] for row in rows]
    if not any(is_matrix(entry) for row in blocks for entry in row):
        return sp.ImmutableMatrix(blocks)
    heights = [_measure(row, 0) for row in blocks]
    widths = [_measure(column, 1) for column in zip(*blocks, strict=True)]
    filled = [
        [_fill(entry, height, width) for entry, width in zip(row, widths, strict=True)]
        for row, height in zip(blocks, heights, strict=True)
    ]
    return sp.ImmutableMatrix(sp.Matrix.vstack(*(sp.Matrix.hstack(*row) for row in filled)))


def give_list(values: Sequence[Any]) -> sp.ImmutableMatrix:
    """Return a row; a vector among numbers contributes its entries, as in [w, (x, y, z)]."""
    is_mixed = not all(map(is_vector, values))
    parts = (show_entries(x) if is_mixed and is_vector(x) else [x] for x in values)
    return sp.ImmutableMatrix([[entry for part in parts for entry in part]])


def _measure(entries: Sequence[Any], axis: int) -> int:
    """Return the number of rows (axis 0) or columns (axis 1) of blocks side by side."""
    sizes = {entry.shape[axis] for entry in entries if is_matrix(entry)} or {1}
    if len(sizes) > 1:
        raise ValueError("blocks of different sizes")
    return int(sizes.pop())


def _fill(entry: Any, height: int, width: int) -> sp.Matrix:
    if is_matrix(entry):
        return sp.Matrix(entry)
    if entry != 0 and (height, width) != (1, 1):
        raise ValueError("a number in place of a block")
    return sp.Matrix(height, width, [entry] * (height * width))


def cut(matrix: Any, ranges: Sequence[tuple[int, int] | None]) -> Any:
    """Return rows and columns of a matrix, counted from 1, the last included; None means all.

    Raises `ValueError` for rows or columns that it lacks.
    """
    shown = show_entries(matrix)
    if len(ranges) == 1 and shown.shape[1] == 1:
        ranges = (*ranges, None)
    if len(ranges) != 2:
        raise ValueError("a matrix needs both rows and columns")
    slices = []
    for size, limits in zip(shown.shape, ranges, strict=True):
        first, last = limits or (1, size)
        if not 1 <= first <= last <= size:
            raise ValueError(f"{first} to {last} of {size}")
        slices.append(slice(first - 1, last))
    part = shown[slices[0], slices[1]]
    return part[0, 0] if part.shape == (1, 1) else part


def give_product(meaning: Meaning, node: Product) -> Any:
    """Return a product of numbers, vectors or matrices."""
    factors = [meaning.of(factor) for factor in node.factors]
    try:
        return multiply(factors, node.signs)
    except UnclearProductError as error:
        raise meaning.source.refuse(node.start, *error.args) from error


def give_excerpt(meaning: Meaning, node: Excerpt) -> Any:
    """Return rows and columns of a matrix."""
    whole = meaning.of(node.of)
    if not is_matrix(whole):
        raise meaning.source.refuse(
            node.start, "rows and columns of something that is not a matrix", ENTRIES
        )
    try:
        return cut(whole, node.ranges)
    except ValueError as error:
        raise meaning.source.refuse(
            node.start,
            f"rows and columns that this matrix does not have: {error}",
            "They count from 1, and the last one is included: [1:3, 4].",
        ) from error


def give_magnitude(meaning: Meaning, node: Magnitude) -> sp.Expr:
    """Return an absolute value, or the length of a vector."""
    inside = meaning.of(node.inside)
    if not is_matrix(inside):
        return sp.Abs(inside)
    if 1 not in inside.shape:
        raise meaning.source.refuse(node.start, "a matrix where a number is expected", ENTRIES)
    return sp.sqrt(sp.Add(*(entry**2 for entry in show_entries(inside))))


def give_transposed(meaning: Meaning, node: Transposed) -> Any:
    """Return the transpose of a matrix."""
    whole = meaning.of(node.of)
    if not is_matrix(whole):
        raise meaning.source.refuse(
            node.start, "the transpose of something that is not a matrix", ENTRIES
        )
    return whole.T


def is_power(value: Any) -> bool:
    """Return whether a value is an unevaluated power of a matrix."""
    return isinstance(value, sp.MatPow)


def raise_matrix(base: sp.MatrixBase, exponent: sp.Expr) -> sp.MatPow | None:
    """Return an unevaluated power to a letter that counts, None for any other exponent."""
    is_count = exponent.is_Symbol and exponent.is_integer and exponent.is_nonnegative
    return sp.MatPow(base, exponent) if is_count and base.is_square else None


def says_from_one_on(relation: sp.Basic) -> bool:
    """Return whether a relation only repeats that a positive symbol counts from one."""
    is_lower = isinstance(relation, sp.GreaterThan | sp.StrictGreaterThan)
    return bool(
        is_lower
        and relation.lhs.is_Symbol
        and relation.lhs.is_positive
        and relation.rhs == isinstance(relation, sp.GreaterThan)
    )


def state_power(sides: Sequence[Any], counts: Collection[sp.Basic]) -> Conjunction | None:
    """Return what an equation with a matrix power on one side asserts, or None if that is unclear.

    The exponent must be one of `counts`, which run over all whole numbers from 0 or 1.
    """
    powers = [side for side in sides if isinstance(side, sp.MatPow)]
    values = [side for side in sides if isinstance(side, sp.MatrixBase)]
    if len(powers) != 1 or len(values) != 1:
        return None
    (value,), (base, count) = values, powers[0].args
    if base.has(count) or value.shape != base.shape or count not in counts:
        return None
    first = base if count.is_positive else sp.eye(base.rows).as_immutable()
    number = sp.Integer(bool(count.is_positive))
    at_first = value.applyfunc(lambda entry: _put_in(entry, count, number))
    later = value.applyfunc(lambda entry: substitute(entry, {count: count + 1}))
    return Conjunction(
        (Equality(at_first, first, "member"), Equality(later, value * base, "member"))
    )


def _put_in(entry: sp.Expr, count: sp.Basic, number: sp.Integer) -> sp.Expr:
    """Put in a number, keeping powers that cancel but may be undefined, as in n*a^(n - 1)."""
    found = substitute(entry, {count: number})
    powers = (substitute(power, {count: number}) for power in entry.atoms(sp.Pow))
    return reduce(ValueWhere, (p for p in powers if list_divisors(p) and not found.has(p)), found)


class UnclearProductError(ValueError):
    """A product that may be read in several ways; its arguments are the reason and the remedy."""


def is_matrix(value: Any) -> bool:
    """Return whether a value has rows and columns."""
    return isinstance(value, sp.MatrixBase | sp.MatrixExpr)


def show_entries(value: Any) -> Any:
    """Return a matrix with its entries written out, those of a symbol as its elements."""
    return value.as_explicit() if isinstance(value, sp.MatrixExpr) else value


def invert(matrix: Any) -> Any:
    """Return the inverse of a matrix; raises `ValueError` if it is not square."""
    shown = show_entries(matrix)
    if not shown.is_square:
        raise ValueError("only square matrices have an inverse")
    # Elimination would simplify at each step, which takes long.
    return shown.adjugate(method="berkowitz") / shown.det(method="berkowitz")


def make_cross_matrix(vector: Any) -> sp.ImmutableMatrix:
    """Return the matrix of a cross product; raises `ValueError` unless there are three entries."""
    x, y, z = show_entries(vector)
    return sp.ImmutableMatrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def give_inner_product(one: Any, other: Any) -> sp.Expr:
    """Return the inner product; raises `ValueError` unless both are vectors of the same size."""
    shown = [show_entries(value) for value in (one, other) if is_vector(value)]
    if len(shown) != 2 or len(shown[0]) != len(shown[1]):
        raise ValueError("an inner product needs two vectors of the same size")
    return shown[0].dot(shown[1])


def multiply(values: Sequence[Any], signs: Sequence[str]) -> Any:
    """Return a product; raises `UnclearProductError` if it can be read in several ways."""
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
        # Some read a column times a row as a number, others as a matrix.
        raise UnclearProductError(*_SIDE_BY_SIDE)
    return sp.Mul(*_find_numbers(parts), one.dot(other))


def _split(
    values: Sequence[Any], signs: Sequence[str], sign: str
) -> Iterator[tuple[Sequence[Any], Sequence[str]]]:
    """Yield the factors between occurrences of `sign`, with the other signs between them."""
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
    # With a matrix between the cross and a vector, both orders of multiplication agree.
    if turned and (turned != [len(runs)] or not is_vector(parts[-1]) or is_vector(runs[-1][0])):
        raise UnclearProductError(*_SIDE_BY_SIDE)
    return sp.Mul(*_find_numbers(parts)) * _cross_entries(*map(show_entries, vectors))


def _cross_entries(one: Any, other: Any) -> Any:
    """Return a cross product; for a vector along z and one in the plane, it lies in the plane."""
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
    """Return whether a value is a single row or column with several entries."""
    return is_matrix(value) and 1 in value.shape and value.shape != (1, 1)


def _take_number(product: Any, values: Sequence[Any]) -> Any:
    """Return the only entry of a 1x1 product of vectors, any other product unchanged."""
    if is_matrix(product) and product.shape == (1, 1) and any(map(is_vector, values)):
        return show_entries(product)[0, 0]
    return product
