"""Equations in which a print means another letter than elsewhere."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from mechproof.nomenclature.block import Block
from mechproof.nomenclature.symbols import Symbols
from mechproof.record import Scope
from mechproof.sources.displays import Printed

_TO = "-"


def add_scopes(symbols: Symbols, block: Block, printed: Sequence[Printed]) -> Symbols:
    """Return the symbols with what the block says of equations and of ranges of them.

    Raises `ValueError` for equations and letters that are not there.
    """
    declared = {name: v.symbol for v in symbols.variables for name in v.latex}
    scopes = []
    for equations, means in block.scopes:
        for latex, name in means.items():
            with block.blame(f"{latex} is {name}"):
                if name not in declared:
                    raise ValueError(f"in: {name} is not declared")
        names = {latex: declared[name] for latex, name in means.items() if name in declared}
        with block.blame(equations[0]):
            scopes.append(Scope(tuple(_list_names(equations, printed)), names))
    return replace(symbols, notation=replace(symbols.notation, scopes=tuple(scopes)))


def _list_names(equations: Sequence[str], printed: Sequence[Printed]) -> Iterator[str]:
    """Yield the names of equations that are named, and of those between two of them."""
    first = 0
    for place, equation in enumerate(equations):
        if equation == _TO:
            continue
        number = _find(equation, printed)
        is_range = place > 1 and equations[place - 1] == _TO
        for one in printed[first if is_range else number : number + 1]:
            yield one.name
        first = number


def _find(equation: str, printed: Sequence[Printed]) -> int:
    found = (n for n, one in enumerate(printed) if equation in (one.name, *one.labels))
    if (number := next(found, None)) is None:
        raise ValueError(f"in: {equation}: no equation has that name or label")
    return number
