"""Which rows are judged with the units of their letters, and what is judged by itself where not."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp
from sympy.functions.elementary.hyperbolic import HyperbolicFunction
from sympy.functions.elementary.trigonometric import (
    InverseTrigonometricFunction,
    TrigonometricFunction,
)

from mechproof.document.known import Known
from mechproof.document.row_sides import list_related, list_stated, raises_by_letter
from mechproof.document.tasks import Role, Sign
from mechproof.record import Definition, Equality, Paper, Row, ValueWhere
from mechproof.statement_domains.dimension_inference import (
    DimensionError,
    dimensions_of,
    infer_common,
)

# A logarithm of a length is a difference of two that may be printed elsewhere.
_OF_NUMBERS = (TrigonometricFunction, InverseTrigonometricFunction, HyperbolicFunction, sp.exp)
_BINDING = (sp.Integral, sp.Sum, sp.Product, sp.Limit, sp.Derivative, sp.Subs, ValueWhere)
_TOLD = 3


@dataclass(frozen=True)
class RowUnits:
    """Whether a row is judged with units, or why it is not; a part that mixes them by itself."""

    are_known: bool
    lacking: str = ""
    mixed: sp.Expr | None = None


def find_units(
    row: Row,
    sign: Sign,
    sides: Sequence[Any],
    known: Known,
    papers: Mapping[bool, Paper],
    is_stated: bool,
) -> RowUnits:
    """Return whether the units of all letters of a row are known, and its sides no numbers."""
    letters = {sign.letter}.union(*(side.free_symbols for side in sides))
    letters |= list_related(row.says) | list_stated(row.says)
    is_special = sign.role is Role.CONSTRAINT and sign.letter is not None
    is_special &= not _is_given_by_itself(sign, known)
    is_number = is_stated or sign.role is Role.SIZE or any(sign.units)
    if is_number or is_special:
        return RowUnits(False, "one side is a number")
    if any(map(raises_by_letter, sides)):
        return RowUnits(False, "a letter is raised by a letter")
    bare = letters & known.symbols.bare
    if not bare:
        return RowUnits(True)
    if letters <= {*bare, None}:
        return RowUnits(False, "its letters have no units")
    names = sorted(map(str, bare))
    told = ", ".join(names[:_TOLD]) + (" and others" if len(names) > _TOLD else "")
    mixed = _find_mixed(row, known.symbols.bare, papers[True])
    return RowUnits(False, f"no unit is said of {told}", mixed)


def _is_given_by_itself(sign: Sign, known: Known) -> bool:
    """Return whether a quantity stands on both sides: their dimensions are compared, too.

    Those of angles would hold up to turns.
    """
    dimension = known.symbols.find_dimension(sign.letter) if sign.letter else None
    others = [side for side in sign.sides if side is not None and side != sign.letter]
    is_within = any(sign.letter in side.free_symbols for side in others)
    return is_within and dimension is not None and not dimension.is_angle


def _find_mixed(row: Row, bare: Collection[sp.Basic], paper: Paper) -> sp.Expr | None:
    """Return a part of a side that mixes dimensions, whatever the letters without a unit are."""
    says, dimensions = row.says, dimensions_of(paper)
    sides = [says.printed] if isinstance(says, Equality | Definition) else []
    sides += [says.rebuilt] if isinstance(says, Equality) else []
    known = dimensions.keys() - {*bare}
    for side in sides:
        for part in _list_parts(side, known) if isinstance(side, sp.Expr) else ():
            try:
                infer_common((part,), dimensions)
            except DimensionError:
                return part
    return None


def _list_parts(side: sp.Expr, known: Collection[sp.Basic]) -> Iterator[sp.Expr]:
    """Yield sums of terms whose units are known, and functions of such terms.

    A factor that is a number may have a unit that is not printed, and a bound letter that of
    another.
    """
    nodes = sp.preorder_traversal(side)
    for node in nodes:
        if isinstance(node, _BINDING):
            nodes.skip()
        elif isinstance(node, sp.Add):
            if len(terms := [term for term in node.args if _has_units(term, known)]) > 1:
                yield sp.Add(*terms)
        elif isinstance(node, _OF_NUMBERS) and _has_units(node.args[0], known):
            yield node


def _has_units(term: sp.Basic, known: Collection[sp.Basic]) -> bool:
    letters = term.free_symbols
    is_plain = isinstance(term, sp.Expr) and term.as_coeff_Mul()[0] in (1, -1)
    return is_plain and bool(letters) and letters <= {*known} and not term.has(*_BINDING)
