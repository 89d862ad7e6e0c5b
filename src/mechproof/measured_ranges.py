"""Ranges of arguments, as a caller states them, and the cells of a record that they meet."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from mechproof.arguments.scalars import check_items, check_number, require
from mechproof.measured import Cell, Record

Size = float | Sequence[float]


def check_ranges(record: Record, ranges: Mapping[str, Size]) -> dict[str, tuple[float, float]]:
    """Return the ends of each range; raises ValueError for sizes that were not measured."""
    pairs = {}
    for name, given in ranges.items():
        known = ", ".join(record.ranges)
        require(name in record.ranges, name, given, f"{record.quantity} has the arguments {known}")
        low, high = _as_pair(name, given)
        least, most = record.ranges[name]
        require(0 <= low <= high, name, given, "must be a size or an ordered pair")
        measured = f"sizes were measured from {least!r} to {most!r}"
        require(least <= low and high <= most, name, given, measured)
        pairs[name] = low, high
    return pairs


def _as_pair(name: str, given: Size) -> tuple[float, float]:
    """Return both ends of a range; a single number is both, as its absolute value."""
    if not isinstance(given, Sequence):
        return (size := abs(check_number(name, given))), size
    items = check_items(name, given, 2, "must be a size or an ordered pair")
    low, high = (check_number(f"{name}[{i}]", item) for i, item in enumerate(items))
    return low, high


def find_cells(record: Record, pairs: Mapping[str, tuple[float, float]]) -> Iterator[int]:
    """Yield the places of the cells that share more than an edge with the ranges."""
    for place, cell in enumerate(record.cells):
        if _shares(cell, pairs, record.ranges):
            yield place


def _shares(
    cell: Cell,
    pairs: Mapping[str, tuple[float, float]],
    ranges: Mapping[str, tuple[float, float]],
) -> bool:
    sides = ((name, edges) for name, edges in cell.sides.items() if name in pairs)
    return all(_overlap(edges, pairs[name], ranges[name][0]) for name, edges in sides)


def _overlap(edges: Sequence[float], pair: tuple[float, float], least: float) -> bool:
    """Return whether a cell and a range share more than an edge.

    A range of one size that is an edge belongs to the cell below it.
    """
    (lower, upper), (low, high) = edges, pair
    if low == high:
        return lower < low <= upper or low == lower == least
    return low < upper and high > lower
