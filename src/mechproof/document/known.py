"""What is known about the letters of a paper while its equations are read one after another.

This includes which matrices are used before they are printed, and the ranges of laws whose pieces
are printed one by one.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field, replace
from itertools import chain
from typing import Any

import sympy as sp

from mechproof.document.law_pieces import LawPiece, order_pieces
from mechproof.latex.matrix_meaning import is_matrix
from mechproof.latex.values import differentiate, list_reached, settle_all
from mechproof.nomenclature.symbols import Symbols
from mechproof.sources.announcements import NOTHING, Announced

Values = dict[sp.Basic, Any]
# Named as the source of time derivatives of letters that depend on a moving one.
CHAIN_RULE = "the chain rule"
# Named as the source of values that no equation prints.
BLOCK = "the block of letters"
# Matrices, each with its value and the name of the equation that prints it.
Later = dict[sp.Basic, tuple[sp.MatrixBase, str]]


@dataclass
class Known:
    """What is known about letters: their values and the equations that printed them first.

    `met` counts the equations and tables in which a letter occurs; `unread` is all unread text.
    `others` holds the further members of the chains that first printed a letter, with their names;
    `cases` holds later prints that may be other solutions, `again` later prints without a condition
    that are compared. `sizes` has the sizes of letters declared as numbers but printed as matrices;
    `entries` has the entries that stand for matrices without a value. `pieces` holds the pieces of
    laws printed one by one; `laws` the pieces of letters that have such a law as their value.
    `arcs` gives, as arc functions, angles whose sine, cosine or tangent is printed; `angles`, by
    passage and letter, the functions of angles that numbers give there, with the arcs. `later`
    holds the matrices used before they are printed, with their values and the equations that print
    them. `circular` has matrices that are made of matrices made of them. `constrained` has the
    letters in constraints, `tied` the prints of their derivatives, and `held`, by equation, the
    letters said to be zero after it. `said` is the announcement in the text before the current
    equation. `examples` holds, by example and equation, the values that hold in a worked example
    only, None for letters printed anew there; `shown_in` maps letters to the examples they occur
    in, 0 outside of any.
    """

    symbols: Symbols
    values: Values = field(default_factory=dict)
    printed: dict[sp.Basic, str] = field(default_factory=dict)
    met: Counter[sp.Basic] = field(default_factory=Counter)
    unread: str = ""
    others: dict[sp.Basic, list[tuple[str, Any]]] = field(default_factory=dict)
    cases: dict[sp.Basic, list[tuple[str, Any]]] = field(default_factory=dict)
    again: dict[sp.Basic, list[tuple[str, Any]]] = field(default_factory=dict)
    sizes: dict[sp.Basic, tuple[int, int]] = field(default_factory=dict)
    entries: Values = field(default_factory=dict)
    pieces: dict[sp.Basic, list[LawPiece]] = field(default_factory=dict)
    laws: dict[sp.Basic, list[LawPiece]] = field(default_factory=dict)
    arcs: dict[sp.Basic, list[sp.Expr]] = field(default_factory=dict)
    angles: dict[tuple[int, sp.Basic], list[tuple[Any, sp.Expr]]] = field(default_factory=dict)
    later: Later = field(default_factory=dict)
    circular: set[sp.Basic] = field(default_factory=set)
    constrained: set[sp.Basic] = field(default_factory=set)
    tied: Values = field(default_factory=dict)
    held: dict[str, list[sp.Basic]] = field(default_factory=dict)
    said: Announced = NOTHING
    examples: dict[int, dict[str, Values]] = field(default_factory=dict)
    shown_in: dict[sp.Basic, set[int]] = field(default_factory=dict)

    def copy(self) -> Known:
        """Return a copy on which the effects of a print can be tried."""
        changed = {**self.values}, {**self.printed}, {**self.later}
        return replace(self, values=changed[0], printed=changed[1], others={}, later=changed[2])

    def settle(self, expression: Any, stop: Collection[sp.Basic] = ()) -> Any:
        """Put in all values, repeatedly, except those of the letters in `stop`."""
        return settle_all(expression, {s: v for s, v in self.values.items() if s not in stop})

    def list_formulas(
        self, value: Any, have: Collection[sp.Basic], stop: Collection[sp.Basic]
    ) -> list[Any]:
        """Return a value by letters in `have` only, with values put in fully or up to `stop`.

        Further members of its chain are tried, too, as they may need fewer letters.
        """
        members = [value, *(other for _, other in self.others.get(value, ()))]
        settled = [(self.settle(one), self.settle(one, stop=stop)) for one in members]
        return [x for x in dict.fromkeys(chain(*settled)) if x.free_symbols <= {*have}]

    def list_restated(
        self, value: Any, have: Collection[sp.Basic], stop: Collection[sp.Basic]
    ) -> Iterator[tuple[str, Any]]:
        """Yield a value by letters in `have` only, using a later print of a letter it contains.

        Each comes with the name of the later print, which may be wrong.
        """
        for letter in sorted(self.again.keys() & self.list_used(value), key=str):
            for name, printed in self.again[letter]:
                known = replace(self, values={**self.values, letter: printed}, others={})
                yield from ((name, one) for one in known.list_formulas(value, have, stop))

    def has_either_sign(self, letter: sp.Basic | None) -> bool:
        """Return whether numbers in this passage give an angle by its cosine only."""
        found = self.list_angles(letter, self.said)
        return bool(found) and all(function == sp.cos for function, _ in found)

    def list_angles(self, letter: sp.Basic | None, said: Announced) -> list[tuple[Any, sp.Expr]]:
        """Return the functions of an angle that numbers give in a passage, each with the arc."""
        return [] if letter is None else self.angles.get((said.passage, letter), [])

    def list_matrices(self) -> dict[sp.Basic, sp.MatrixBase]:
        """Return the matrices whose entries are known."""
        return {s: v for s, v in self.values.items() if isinstance(v, sp.MatrixBase)}

    def is_shown(self, symbol: sp.Basic, value: Any) -> bool:
        """Return whether a value, or a definition it uses, contains a letter or one of its entries.

        The letter may cancel there; in that case the print is wrong, and no definition.
        """
        own = {symbol, *self.entries.get(symbol, ())}
        return bool(own & (self.list_used(value) | self.settle(value).free_symbols))

    def list_used(self, value: Any) -> set[sp.Basic]:
        """Return the letters of a value and, repeatedly, of their values."""
        return list_reached(value.free_symbols, self.values)

    def follows_from_constraints(self, symbol: sp.Basic, value: Any) -> bool:
        """Return whether a derivative is printed only in terms of what constraints tie together."""
        letter = self.symbols.find_steps(symbol)[1][0]
        if letter == symbol or letter in self.values or letter not in self.constrained:
            return False
        tied = {s for one in self.constrained for s in self.symbols.find_steps(one)[1]}
        given = (self.settle(s).free_symbols for s in tied & self.values.keys())
        return bool(self.settle(value).free_symbols <= tied.union(*given))

    def define(self, symbol: sp.Basic, value: Any, name: str) -> None:
        """Take a print of a letter as its definition, and derive the values of its derivatives."""
        self.values[symbol] = value
        self.printed[symbol] = name
        above = symbol
        by, _ = self.symbols.find_steps(symbol)
        for rate in self.symbols.find_rates(symbol)[1:]:
            if rate in self.values:
                break
            try:
                derivative = self._differentiate(self._show_moving(self.values[above], by), by)
            except ValueError:
                # Its letters have no symbols for derivatives of so high an order.
                break
            if self.is_shown(rate, derivative):
                # The derivative contains itself, as that of y = \dot y^2 does.
                break
            self.values[rate] = derivative
            self.printed[rate] = name
            above = rate

    def redefine(self, symbol: sp.Basic, value: Any, name: str) -> Values:
        """Return the values that a newer print gives letters and derivatives, None for no value.

        Letters that are not said to move have their values put in before derivatives are taken.
        """
        own = self.symbols.find_rates(symbol)
        values = {s: v for s, v in self.values.items() if s not in own}
        known = replace(self, values=values, printed={**self.printed})
        if known.is_shown(symbol, value):
            return {}
        known.define(symbol, value, name)
        resting = [
            s for s, v in values.items() if not self.is_derived(s) and self.is_shown(symbol, v)
        ]
        for letter in resting:
            for rate in self.symbols.find_rates(letter)[1:]:
                known.values.pop(rate, None)
            known.define(letter, values[letter], self.printed[letter])
        changed = (s for s in self.values if known.values.get(s) != self.values[s])
        return {s: known.values.get(s) for s in (*own, *changed)}

    def is_derived(self, rate: sp.Basic) -> bool:
        """Return whether a derivative was found by differentiation and not printed itself."""
        _, steps = self.symbols.find_steps(rate)
        before = steps[max(steps.index(rate) - 1, 0)]
        is_below = before != rate and self.printed.get(before) == self.printed.get(rate)
        return is_below or self.printed.get(rate) == CHAIN_RULE

    def _show_moving(self, value: Any, by: sp.Basic) -> Any:
        """Put in the values of letters that depend on `by` without being declared to."""
        moving = {s for s, (other, rates) in self.symbols.moving.items() if other == by}
        moving |= {s for _, rates in self.symbols.moving.values() for s in rates} | {by}
        fixed = {s: self.settle(v, moving) for s, v in self.values.items() if s not in moving}
        return value.xreplace({s: v for s, v in fixed.items() if v.free_symbols & moving})

    def _differentiate(self, value: Any, by: sp.Basic) -> Any:
        """Return a derivative; raises `ValueError` if it is not known.

        That of a matrix is not known if some entries are not, or if none is known to move.
        """
        if not is_matrix(value):
            return differentiate(value, by, self.symbols.moving)
        value = self.settle(value)
        derivative = value if _list_open(value) else differentiate(value, by, self.symbols.moving)
        if _list_open(value) or derivative.is_zero_matrix:
            raise ValueError(f"nothing is known about how {value} moves")
        return derivative

    def join_pieces(self) -> dict[sp.Basic, list[LawPiece]]:
        """Return the laws that pieces form, for letters that have no other value."""
        ordered = {letter: order_pieces(pieces) for letter, pieces in self.pieces.items()}
        return {s: pieces for s, pieces in ordered.items() if pieces and s not in self.values}

    def define_laws(self, laws: Mapping[sp.Basic, list[LawPiece]]) -> None:
        """Take piecewise laws as definitions, unless a letter already has a derived value."""
        for letter in sorted(laws, key=lambda s: self.symbols.find_steps(s)[1].index(s)):
            self.laws[letter] = laws[letter]
            if letter not in self.values:
                pieces = ((one.value, sp.And(*one.where)) for one in laws[letter])
                self.define(letter, sp.Piecewise(*pieces), self.name_law(letter))

    def find_parted(self, letter: sp.Basic) -> sp.Basic:
        """Return the letter over whose ranges a letter, or one that it is a rate of, has pieces."""
        by, steps = self.symbols.find_steps(letter)
        return next((self.laws[s][0].by for s in steps if s in self.laws), by)

    def name_law(self, letter: sp.Basic) -> str:
        """Return the names of the equations that print the pieces of a law."""
        return " and ".join(dict.fromkeys(one.name for one in self.laws[letter]))

    def list_others(self, symbol: sp.Basic) -> Iterator[tuple[str, Any]]:
        """Yield other prints of a letter, or of the one it is a derivative of, differentiated."""
        by, steps = self.symbols.find_steps(symbol)
        letter, order = steps[0], steps.index(symbol)
        for name, value in (*self.others.get(letter, ()), *self.cases.get(letter, ())):
            with suppress(ValueError):
                for _ in range(order):
                    value = self._differentiate(self.settle(value, {letter}), by)
                yield name, value


def define_later(later: Later, known: Known) -> None:
    """Define matrices before the equations that print them."""
    known.later |= later
    for symbol, (value, name) in later.items():
        known.define(symbol, value, name)


def find_later(known: Known) -> Later:
    """Return the known matrices, if one of them was used as a letter before it was printed.

    Matrices that depend on one another in a circle are left out if others remain.
    """
    met = {letter for value in known.values.values() for letter in _list_open(value)}
    met |= known.later.keys()
    closed = {s: v for s, v in known.list_matrices().items() if not _list_open(v)}
    plain = {s: v for s, v in closed.items() if s not in known.circular}
    found = next((one for one in (plain, closed) if met & one.keys()), {})
    return {s: (v, known.printed[s]) for s, v in found.items()}


def define_now(name: str, symbol: sp.Basic, value: Any, known: Known) -> bool:
    """Take a print as the definition of a matrix, if it is that or the old one is not explicit.

    Returns whether it was taken. In the latter case the earlier print is compared with this one.
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
    """Return the matrix symbols in a matrix."""
    return value.atoms(sp.MatrixSymbol) if is_matrix(value) else set()
