r"""The symbols of a paper: letters, what is said of each, and the reader of prints in them.

Time derivatives of letters that depend on a moving letter are known: \dot s of s(\theta), given
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
from mechproof.nomenclature.guessed_letters import REMEDIES
from mechproof.nomenclature.shown_letters import name_symbol
from mechproof.nomenclature.symbol_names import ORDERS, TIME, print_rate
from mechproof.record import NUMBER, Dimension, Notation, Paper, Scope, Variable
from mechproof.record.unit_notation import UNITS
from mechproof.sources.displays import Printed
from mechproof.sources.located_text import Place

# The name of a rate -> the name of its letter, and its order.
Chained = Mapping[str, tuple[str, int]]
_TO = "-"


@dataclass(frozen=True)
class Symbols:
    """The letters of a paper.

    `bare` are the symbols without a declared unit; `scales` are the sizes of the declared units.
    `faults` report names that no print can have, with the places of their declarations. `matrices`
    has the matrices whose time derivatives are declared, with time and these.
    """

    variables: tuple[Variable, ...]
    notation: Notation
    where: tuple[sp.Basic, ...] = ()
    usual: Mapping[sp.Basic, sp.Expr] = field(default_factory=dict)
    bare: frozenset[sp.Basic] = frozenset()
    scales: Mapping[sp.Basic, sp.Expr] = field(default_factory=dict)
    faults: tuple[tuple[Place | None, str], ...] = ()
    matrices: Moving = field(default_factory=dict)

    @property
    def moving(self) -> Moving:
        """Return the letters that depend on another, with their derivatives by it."""
        return self.notation.moving

    @property
    def branches(self) -> tuple[sp.Basic, ...]:
        """Return the letters that take one of a few values, 1 or -1."""
        return tuple(v.symbol for v in self.variables if v.within.is_FiniteSet)

    @property
    def prints(self) -> dict[str, sp.Basic]:
        """Return the letters by their prints."""
        return {latex: v.symbol for v in self.variables for latex in v.latex}

    @property
    def names(self) -> dict[str, sp.Basic]:
        """Return the letters by the names of their prints."""
        return {name_symbol(latex): symbol for latex, symbol in self.prints.items()}

    def list_branches(self, letters: Collection[sp.Basic]) -> list[dict[sp.Basic, sp.Expr]]:
        """Return all combinations of values of the branches among letters, at least {}."""
        sets = {v.symbol: v.within for v in self.variables if v.symbol in self.branches}
        chosen = [[(s, value) for value in sets[s]] for s in sets if s in letters]
        return [dict(choice) for choice in product(*chosen)]

    def list_exact(self) -> set[sp.Expr]:
        """Return the declared sizes of letters, in their units and in SI units."""
        scaled = {size * self.scales.get(s, sp.S.One) for s, size in self.usual.items()}
        return {*self.usual.values()} | scaled

    def find_dimension(self, symbol: sp.Basic) -> Dimension | None:
        """Return the dimension of a letter, None if no unit is declared."""
        declared = (v.dimension for v in self.variables if v.symbol == symbol)
        return next(declared) if symbol in self.scales else None

    def find_steps(self, symbol: sp.Basic) -> tuple[sp.Basic, tuple[sp.Basic, ...]]:
        """Return the variable of a letter's derivatives, and the letter with all its derivatives.

        The symbol may be any of these; one that depends on nothing is returned alone, as its own
        variable.
        """
        moving = {**self.moving, **self.matrices}
        all_steps = ((by, (letter, *rates)) for letter, (by, rates) in moving.items())
        return next((one for one in all_steps if symbol in one[1]), (symbol, (symbol,)))

    def find_rates(self, symbol: sp.Basic) -> tuple[sp.Basic, ...]:
        """Return a letter or a derivative with its own derivatives."""
        _, steps = self.find_steps(symbol)
        return steps[steps.index(symbol) :]

    def find_alike(self, letters: Collection[sp.Basic]) -> sp.Basic | None:
        """Return one of the letters if all have the same declared unit, else None."""
        units = {(self.find_dimension(x), self.scales.get(x)) for x in letters}
        return min(letters, key=str) if len(units) == 1 and (None, None) not in units else None

    def show_entries(self, given: Mapping[sp.Basic, Any]) -> tuple[Symbols, dict[sp.Basic, Any]]:
        """Return these letters with entries for matrices without a value, and those matrices."""
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
        """Return these letters and the SI units, each with scale and size one."""
        units = dict.fromkeys((v.symbol for v in UNITS), sp.S.One)
        scales, usual = {**self.scales, **units}, {**self.usual, **units}
        return replace(self, variables=(*self.variables, *UNITS), scales=scales, usual=usual)

    def reader(self, given: Mapping[sp.Basic, Any] | None = None) -> Reader:
        """Return the reader of the paper's prints, with the values of letters that are defined."""
        values = given or {}
        variables = tuple(replace(v, given=values.get(v.symbol)) for v in self.variables)
        return Reader(variables, self.notation, REMEDIES)

    def paper(self, system: str, given: Mapping[sp.Basic, Any], *, with_units: bool) -> Paper:
        """Return the paper of these letters, without rows; `with_units` makes it compare units.

        The set of a defined letter becomes a condition on the letters that define it.
        """
        variables, where = [], [*self.where]
        for v in self.variables:
            value = given.get(v.symbol)
            # The value of an integer letter is an integer, too: its set adds no condition.
            is_free = value is None or v.symbol.is_integer
            if not is_free and v.within is not sp.S.Reals:
                where.append(v.within.as_relational(v.symbol))
            within = v.within if is_free else sp.S.Reals
            unit = v.dimension if with_units else NUMBER
            variables.append(replace(v, given=value, within=within, dimension=unit))
        return Paper(system, "", tuple(variables), (), tuple(where), usual=self.usual)


def add_chained_rates(block: Block) -> Chained:
    """Declare time derivatives of letters that depend on a letter that depends on time.

    Returns the name of each with its letter and order.
    """
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
    """Yield the time derivatives with their values by the chain rule."""
    names = symbols.names
    for name, (letter, order) in chained.items():
        value, time = names[letter], names[TIME]
        for _ in range(order):
            value = differentiate(value, time, symbols.moving)
        yield names[name], value


def add_scopes(symbols: Symbols, block: Block, printed: Sequence[Printed]) -> Symbols:
    """Return the symbols with the block's statements on single equations and ranges of them.

    Unknown equations and letters are recorded as faults of the block.
    """
    declared = symbols.prints
    scopes = []
    for equations, means in block.scopes:
        for latex, name in means.items():
            with block.blame(f"{latex} is {name}"):
                if name not in declared:
                    raise ValueError(f"in: {name} is not declared")
        names = {latex: declared[name] for latex, name in means.items() if name in declared}
        names = dict(_list_rates_of(names, symbols)) | names
        with block.blame(equations[0]):
            scopes.append(Scope(tuple(_list_names(equations, printed)), names))
    return replace(symbols, notation=replace(symbols.notation, scopes=tuple(scopes)))


def _list_rates_of(
    names: Mapping[str, sp.Basic], symbols: Symbols
) -> Iterator[tuple[str, sp.Basic]]:
    """Yield the printed derivatives of letters with the derivatives that they mean."""
    for latex, meant in names.items():
        by, rates = symbols.notation.moving.get(meant, (None, ()))
        for running in (v.latex[0] for v in symbols.variables if v.symbol == by):
            for order, rate in zip(ORDERS, rates, strict=False):
                yield from ((printed, rate) for printed in print_rate(latex, running, order))


def _list_names(equations: Sequence[str], printed: Sequence[Printed]) -> Iterator[str]:
    """Yield the names of the listed equations, including those in ranges between two."""
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
