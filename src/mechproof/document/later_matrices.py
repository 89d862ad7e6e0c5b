"""Matrices of which others are made before they are printed: which are known at once, and when."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import sympy as sp

if TYPE_CHECKING:
    from mechproof.document.known import Known

# Matrices, each with its value and what prints it.
Later = dict[sp.Basic, tuple[sp.MatrixBase, str]]


def define_later(later: Later, known: Known) -> None:
    """Take matrices as known before they are printed."""
    known.later |= later
    for symbol, (value, name) in later.items():
        known.define(symbol, value, name)


def find_later(known: Known) -> Later:
    """Return the matrices that are known, if another was made of a letter for one of them.

    What is also made of the other is left to the print that makes it, if others are known.
    """
    met = {letter for value in known.values.values() for letter in _list_open(value)}
    met |= known.later.keys()
    closed = {s: v for s, v in known.list_matrices().items() if not _list_open(v)}
    plain = {s: v for s, v in closed.items() if s not in known.circular}
    found = next((one for one in (plain, closed) if met & one.keys()), {})
    return {s: (v, known.printed[s]) for s, v in found.items()}


def define_now(name: str, symbol: sp.Basic, value: Any, known: Known) -> bool:
    """Take a print for the definition of a matrix, if it was known before, or made of unknown ones.

    Return whether it is: what was printed before is compared with it.
    """
    if symbol in known.later:
        is_here = known.later[symbol][1] == name
        if is_here:
            del known.later[symbol]
        return is_here
    if not isinstance(value, sp.MatrixBase) or symbol not in known.values:
        return False
    is_open = bool(_list_open(known.settle(known.values[symbol])))
    if is_open:
        define_later({symbol: (value, name)}, known)
    return is_open


def _list_open(value: Any) -> set[sp.Basic]:
    """Return the letters for matrices that stand in a matrix."""
    is_matrix = isinstance(value, sp.MatrixBase | sp.MatrixExpr)
    return value.atoms(sp.MatrixSymbol) if is_matrix else set()
