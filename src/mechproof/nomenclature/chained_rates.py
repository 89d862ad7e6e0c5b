r"""Rates in time of what depends on a letter that moves: \dot s of s(\theta) beside \theta(t)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import product

import sympy as sp

from mechproof.latex.values import differentiate
from mechproof.nomenclature.block import Block, Declared
from mechproof.nomenclature.shown_letters import name_symbol
from mechproof.nomenclature.symbol_names import ORDERS, TIME, print_rate
from mechproof.nomenclature.symbols import Symbols

# The letter and the order of a rate, by its name.
Chained = Mapping[str, tuple[str, int]]


def add_chained_rates(block: Block) -> Chained:
    """Declare the rates in time of letters that depend on one that does; return what they are."""
    step = next((x.unit for x in block.letters if TIME in x.names), "s")
    moving = {name_symbol(x.names[0]) for x in block.letters if x.running == TIME}
    found: dict[str, tuple[str, int]] = {}
    declared = {name_symbol(name) for x in block.letters for name in x.names}
    chained = [x for x in block.letters if name_symbol(x.running) in moving and not x.shape]
    for letter, order in product(chained, ORDERS):
        names = tuple(print_rate(letter.names[0], TIME, order))
        said = (name for name in map(name_symbol, names) if name in declared)
        rate = next(said, name_symbol(names[0]))
        found[rate] = name_symbol(letter.names[0]), order
        if rate not in declared:
            is_bare = letter.unit is None or step is None
            unit = None if is_bare else f"{letter.unit} {step}^-{order}".strip()
            block.letters.append(Declared(names, f"{letter.meaning}, rate in time", unit))
    return found


def give_chained_rates(chained: Chained, symbols: Symbols) -> Iterator[tuple[sp.Basic, sp.Expr]]:
    """Yield the rates in time with their values by the chain rule."""
    names = symbols.names
    for name, (letter, order) in chained.items():
        value, time = names[letter], names[TIME]
        for _ in range(order):
            value = differentiate(value, time, symbols.moving)
        yield names[name], value
