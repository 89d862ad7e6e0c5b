"""Printed matrices: of numbers, of other matrices as their blocks, and parts of them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from mechproof.latex.products import is_matrix, show_entries


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


def _measure(entries: Sequence[Any], axis: int) -> int:
    """Return how many rows or columns a row or column of blocks has."""
    sizes = {entry.shape[axis] for entry in entries if is_matrix(entry)} or {1}
    if len(sizes) > 1:
        raise ValueError("blocks of different sizes")
    return int(sizes.pop())


def _fill(entry: Any, height: int, width: int) -> sp.Matrix:
    if is_matrix(entry):
        return sp.Matrix(entry)
    if entry != 0 and (height, width) != (1, 1):
        raise ValueError("a number in the place of a block")
    return sp.Matrix(height, width, [entry] * (height * width))


def cut(matrix: Any, ranges: Sequence[tuple[int, int] | None]) -> Any:
    """Return rows and columns of a matrix, counted from 1, the last one included; None is all.

    Raises `ValueError` for what it does not have.
    """
    shown = show_entries(matrix)
    if len(ranges) == 1 and shown.shape[1] == 1:
        ranges = (*ranges, None)
    if len(ranges) != 2:
        raise ValueError("a matrix has rows and columns")
    slices = []
    for size, limits in zip(shown.shape, ranges, strict=True):
        first, last = limits or (1, size)
        if not 1 <= first <= last <= size:
            raise ValueError(f"{first} to {last} of {size}")
        slices.append(slice(first - 1, last))
    part = shown[slices[0], slices[1]]
    return part[0, 0] if part.shape == (1, 1) else part
