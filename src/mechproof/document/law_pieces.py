"""Laws whose pieces are printed one by one: each piece with its range, and the pieces in order."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from mechproof.latex.values import find_end, is_lower
from mechproof.nomenclature.said_relations import open_modulus


@dataclass(frozen=True)
class LawPiece:
    """The value of a letter in a range of another one, `by`, with the name of its equation.

    `low` or `high` is None if the range has no such end.
    """

    name: str
    value: Any
    by: sp.Basic
    where: tuple[sp.Basic, ...]
    low: sp.Expr | None
    high: sp.Expr | None
    is_closed: tuple[bool, bool]

    @property
    def range(self) -> tuple[sp.Expr | None, sp.Expr | None]:
        """Return the ends of the range, expanded so that they can be compared."""
        low, high = (None if x is None else sp.expand(x) for x in (self.low, self.high))
        return low, high


def read_piece(
    name: str, value: Any, relations: Sequence[sp.Basic], by: sp.Basic
) -> LawPiece | None:
    """Return the piece that relations select, or None if they say more than a range."""
    ends: dict[bool, tuple[sp.Expr, bool]] = {}
    where = tuple(part for one in relations for part in open_modulus(one))
    for relation in where:
        if not isinstance(relation, sp.Lt | sp.Le | sp.Gt | sp.Ge):
            return None
        end, lower = find_end(relation, by), is_lower(relation, by)
        if end is None or lower in ends:
            return None
        ends[lower] = (end, isinstance(relation, sp.Le | sp.Ge))
    low, high = (ends.get(lower, (None, False)) for lower in (True, False))
    closed = low[1], high[1]
    return LawPiece(name, value, by, where, low[0], high[0], closed) if ends else None


def order_pieces(pieces: Sequence[LawPiece]) -> list[LawPiece]:
    """Return pieces in an order in which each begins where the last one ends, or none.

    Of pieces with the same range the first is used. All ranges must be of the same letter.
    """
    ranges: dict[Any, LawPiece] = {}
    if any(piece.by != pieces[0].by for piece in pieces):
        return []
    for piece in pieces:
        ranges.setdefault(piece.range, piece)
    starts = {low: piece for (low, _), piece in ranges.items()}
    ends = {high for _, high in ranges}
    first = [piece for (low, _), piece in ranges.items() if low is None or low not in ends]
    if len(starts) < len(ranges) or len(ends) < len(ranges) or len(first) != 1:
        return []
    found = first[:1]
    while found[-1].high is not None and (following := starts.get(found[-1].range[1])):
        found.append(following)
    return found if len(found) == len(ranges) else []
