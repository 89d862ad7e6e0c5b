r"""The symbols of a paper: letters, what is said of each, and the reader of prints in them.

Rates in time of what depends on a letter that moves are known: \dot s of s(\theta) beside
\theta(t). In some equations a print may mean another letter than elsewhere.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import product
from typing import Any

import sympy as sp

from mechproof.latex import Reader
from mechproof.latex.values import Moving, differentiate
from mechproof.nomenclature.block import Block, Declared
from mechproof.nomenclature.shown_letters import REMEDIES, name_symbol
from mechproof.nomenclature.symbol_names import ORDERS, TIME, print_rate
from mechproof.record import NUMBER, Dimension, Notation, Paper, Scope, Variable
from mechproof.record.unit_notation import UNITS
from mechproof.sources.displays import Printed
from mechproof.sources.located_text import Place

# For the name of a rate: its letter, and its order.
Chained = Mapping[str, tuple[str, int]]
_TO = "-"


@dataclass(frozen=True)
class Symbols:
    """What the letters of a paper are.

    `bare` are the symbols of which no unit is declared; `scales` are the sizes of declared ones.
    `faults` tell of names that no print can have, with the places of their declarations.
    """

    variables: tuple[Variable, ...]
    notation: Notation
    where: tuple[sp.Basic, ...] = ()
    usual: Mapping[sp.Basic, sp.Expr] = field(default_factory=dict)
    bare: frozenset[sp.Basic] = frozenset()
    scales: Mapping[sp.Basic, sp.Expr] = field(default_factory=dict)
    faults: tuple[tuple[Place | None, str], ...] = ()

    @property
    def moving(self) -> Moving:
        """Return the letters that depend on another, and their derivatives by it."""
        return self.notation.moving

    @property
    def branches(self) -> tuple[sp.Basic, ...]:
        """Return the letters that are one of a few numbers, 1 or -1."""
        return tuple(v.symbol for v in self.variables if v.within.is_FiniteSet)

    @property
    def names(self) -> dict[str, sp.Basic]:
        """Return the letters by the names of their prints."""
        return {name_symbol(name): v.symbol for v in self.variables for name in v.latex}

    def list_branches(self, letters: Collection[sp.Basic]) -> list[dict[sp.Basic, sp.Expr]]:
        """Return the choices of the branches among letters: one without any if there is none."""
        sets = {v.symbol: v.within for v in self.variables if v.symbol in self.branches}
        chosen = [[(s, value) for value in sets[s]] for s in sets if s in letters]
        return [dict(choice) for choice in product(*chosen)]

    def list_exact(self) -> set[sp.Expr]:
        """Return the declared sizes of letters, in their units and in those of SI."""
        scaled = {size * self.scales.get(s, sp.S.One) for s, size in self.usual.items()}
        return {*self.usual.values()} | scaled

    def find_dimension(self, symbol: sp.Basic) -> Dimension | None:
        """Return the dimension of a letter, None where no unit is declared."""
        declared = (v.dimension for v in self.variables if v.symbol == symbol)
        return next(declared) if symbol in self.scales else None

    def find_steps(self, symbol: sp.Basic) -> tuple[sp.Basic, tuple[sp.Basic, ...]]:
        """Return by what a letter is differentiated, and the letter with all its derivatives.

        It may be one of these; one that depends on nothing stands alone.
        """
        all_steps = ((by, (letter, *rates)) for letter, (by, rates) in self.moving.items())
        return next((one for one in all_steps if symbol in one[1]), (symbol, (symbol,)))

    def find_alike(self, letters: Collection[sp.Basic]) -> sp.Basic | None:
        """Return one of letters that all have the same declared unit, None for others."""
        units = {(self.find_dimension(x), self.scales.get(x)) for x in letters}
        return min(letters, key=str) if len(units) == 1 and (None, None) not in units else None

    def show_entries(self, given: Mapping[sp.Basic, Any]) -> tuple[Symbols, dict[sp.Basic, Any]]:
        """Return these letters with those of the entries of matrices that nothing gives."""
        new, values = [], {}
        for v in self.variables:
            if isinstance(v.symbol, sp.MatrixSymbol) and v.symbol not in given:
                entries = sp.ImmutableMatrix(
                    *v.symbol.shape,
                    lambda row, column, v=v: sp.Symbol(
                        f"{v.symbol}[{row + 1}, {column + 1}]", real=True
                    ),
                )
                values[v.symbol] = entries
                new += [replace(v, symbol=entry, latex=()) for entry in entries]
        bare = {entry for s in values.keys() & self.bare for entry in values[s]}
        scales = {entry: self.scales[s] for s in values.keys() & self.scales for entry in values[s]}
        return replace(
            self,
            variables=(*self.variables, *new),
            bare=self.bare | bare,
            scales={**self.scales, **scales},
        ), values

    def with_units(self) -> Symbols:
        """Return these letters and the units of SI, which count in themselves."""
        units = dict.fromkeys((v.symbol for v in UNITS), sp.S.One)
        scales, usual = {**self.scales, **units}, {**self.usual, **units}
        return replace(self, variables=(*self.variables, *UNITS), scales=scales, usual=usual)

    def reader(self, given: Mapping[sp.Basic, Any] | None = None) -> Reader:
        """Return the reader of the paper's prints, with the values of letters that are defined."""
        values = given or {}
        variables = tuple(replace(v, given=values.get(v.symbol)) for v in self.variables)
        return Reader(variables, self.notation, REMEDIES)

    def paper(self, system: str, given: Mapping[sp.Basic, Any], *, with_units: bool) -> Paper:
        """Return the paper of these letters, without rows; without units none are compared.

        What is said of a letter that is defined becomes a condition on those that define it.
        """
        variables, where = [], [*self.where]
        for v in self.variables:
            value = given.get(v.symbol)
            if value is not None and v.within is not sp.S.Reals:
                where.append(v.within.as_relational(v.symbol))
            within = v.within if value is None else sp.S.Reals
            unit = v.dimension if with_units else NUMBER
            variables.append(replace(v, given=value, within=within, dimension=unit))
        return Paper(system, "", tuple(variables), (), tuple(where), usual=self.usual)


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
    """Yield the names of the equations listed, and of those in ranges between two."""
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
