"""Declarations: the block of a paper's letters -> their symbols, with the rates of some."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import product

import sympy as sp

from mechproof.latex import Reader, ReadingError
from mechproof.latex.printed_functions import FUNCTIONS, RANGES
from mechproof.latex.tokens import list_signs
from mechproof.nomenclature.adjacent_letters import find_phases
from mechproof.nomenclature.block import Block, Declared
from mechproof.nomenclature.cells import name_unit
from mechproof.nomenclature.defined_functions import find_bracketed
from mechproof.nomenclature.said_relations import narrow, read_relations
from mechproof.nomenclature.shown_letters import name_symbol
from mechproof.nomenclature.symbol_names import (
    ORDERS,
    TIME,
    leave_names,
    list_rates,
    name_letter,
    print_rate,
    refuse_twins,
    say_rate,
    set_otherwise,
)
from mechproof.nomenclature.symbols import Symbols
from mechproof.record import NUMBER, Notation, Variable
from mechproof.record.unit_notation import ONE, Unit, UnitError, read_unit, weigh, weigh_unit
from mechproof.sources.located_text import Place

# The unit at the end of a size.
_UNITS = re.compile(r"(?<=\d)(?:\s|\\,|~)*((?:[A-Za-zµ°/%·* ]+(?:\^?\{?-?\d\}?)?)+)\s*\Z")


def declare(block: Block, *, assume: bool = False) -> Symbols:
    """Return the symbols of a block's letters, recording contradictory statements as its faults.

    With `assume`, SymPy is told which letters are positive; then no equation of the paper may
    define those. Raises `ValueError` for an unknown function.
    """
    letters, unknown = _leave_units(_add_running(_name_values(block.letters)))
    variables: list[Variable] = []
    depending: dict[sp.Basic, tuple[str, tuple[sp.Basic, ...]]] = {}
    bare: set[sp.Basic] = set()
    scales: dict[sp.Basic, sp.Expr] = {}
    places: dict[sp.Basic, Place | None] = {}
    rates = {name_symbol(rate) for x in letters for rate in list_rates(x)}
    declared = [x for x in letters if not x.symbol and {*map(name_symbol, x.names)} & rates]
    letters = [x for x in letters if x not in declared]
    for letter in letters:
        units = _list_units(letter, letters)
        name = name_letter(letter, rates, assume=assume)
        own = list(_make(letter, name, units, block, assume=assume))
        variables += own
        places |= dict.fromkeys((v.symbol for v in own), letter.place)
        scales |= {v.symbol: unit.scale for v, unit in zip(own, units, strict=False)}
        if letter.is_family:
            bare |= {own[0].symbol.label} if letter.unit is None else set()
        if letter.running:
            depending[own[0].symbol] = letter.running, tuple(v.symbol for v in own[1:])
        has_no_unit = {x.names[0] for x in letters if x.unit is None}
        if has_no_unit & {letter.names[0], letter.running}:
            bare |= {v.symbol for v in own}
    said = set[sp.Basic]()
    for letter in declared:
        with block.blame(letter.names[0], letter.place):
            rate = say_rate(letter, variables, scales)
            if rate in said:
                raise ValueError(f"{rate} is declared twice")
            said.add(rate)
    of_rates = {rate for _, own in depending.values() for rate in own}
    refuse_twins(variables, of_rates, lambda v: block.blame(v.latex[0], places.get(v.symbol)))
    variables, unread = leave_names(variables, places)
    variables = variables if assume else [*set_otherwise(variables)]
    faults = [*unknown, *unread]
    plain = [v for v in variables if not isinstance(v.symbol, sp.IndexedBase)]
    symbols = {name: v.symbol for v in plain for name in v.latex}
    moving = {symbol: (symbols[running], rates) for symbol, (running, rates) in depending.items()}
    matrices = dict(_find_matrix_rates(letters, symbols))
    factors = (*block.factors, *block.natural)
    phases = frozenset(_find_phases(variables, {by for by, _ in moving.values()}, bare))
    dimensions = {v.symbol: v.dimension for v in variables if v.symbol not in bare}
    notation = Notation(
        factors=factors,
        functions={
            name.removeprefix("\\"): _find_function(what) for name, what in block.functions.items()
        },
        moving=moving,
        name_unit=name_unit,
        weigh_unit=weigh_unit,
        phases=phases,
        dimensions=dimensions,
        imaginary=block.imaginary,
    )
    for name in (*block.branches, *block.natural, *block.integer):
        with block.blame(name):
            if name not in symbols:
                raise ValueError(
                    f"{name} is named as a branch or as a whole number, but it is not declared"
                )
    if len(block.branches) == 1 and block.branches[0] in symbols:
        notation = replace(notation, branch=symbols[block.branches[0]])
    known = {symbol: scale for symbol, scale in scales.items() if symbol not in bare}
    weights = {v.symbol: weigh(v.dimension) for v in variables if v.symbol in known}
    scaled = {symbol: known[symbol] * weight for symbol, weight in weights.items()}
    notation = replace(notation, units=scaled)
    found = Symbols(
        tuple(variables),
        notation,
        bare=frozenset(bare),
        scales=known,
        faults=tuple(faults),
        matrices=matrices,
    )
    return _say(found, block)


def _leave_units(
    letters: Sequence[Declared],
) -> tuple[list[Declared], list[tuple[Place | None, str]]]:
    """Return the letters with unknown units removed, and the faults that report these."""
    found, faults = [], []
    for letter in letters:
        try:
            read_unit(letter.unit or "")
            found.append(letter)
        except UnitError as error:
            faults.append((letter.place, f"{error}; {letter.names[0]} is taken to have no unit"))
            found.append(replace(letter, unit=None))
    return found, faults


def _name_values(letters: Sequence[Declared]) -> list[Declared]:
    r"""Make a dependent letter with another argument a letter of its own: \dot x(t_1)."""
    known: dict[str, str] = {}
    found = []
    for letter in letters:
        first, by = letter.names[0], letter.running
        if by and known.get(name_symbol(first), by) != by:
            found.append(replace(letter, names=(f"{first}({by})", *letter.names[1:]), running=""))
            continue
        known |= {name_symbol(latex): by for latex in (first, *list_rates(letter)) if by}
        found.append(letter)
    return found


def _find_function(latex: str) -> Callable[..., sp.Expr]:
    """Return the function with this printed name, or with this range."""
    if make := RANGES.get("".join(latex.split())):
        return make
    name = latex.strip().removeprefix("\\")
    if name not in FUNCTIONS:
        raise ValueError(f"function: {latex} is not one of the functions that are read")
    return FUNCTIONS[name]


def _add_running(letters: Sequence[Declared]) -> list[Declared]:
    """Add undeclared letters by which others are differentiated, such as t.

    Declared ones are given the name of their declaration, t_{2} for t_2.
    """
    known = {name_symbol(name): name for x in letters if not x.is_family for name in x.names}
    letters = [replace(x, running=known.get(name_symbol(x.running), x.running)) for x in letters]
    new = dict.fromkeys(x.running for x in letters if x.running not in ("", *known.values()))
    return [*letters, *(Declared((name,), unit="s" if name == TIME else None) for name in new)]


def _list_units(letter: Declared, letters: Sequence[Declared]) -> list[Unit]:
    """Return the units of a letter and of its derivatives; undeclared units count as 1."""
    by = next((x.unit for x in letters if letter.running in x.names), None)
    unit, step = (ONE if text is None else read_unit(text) for text in (letter.unit, by))
    return [unit / step**order for order in (0, *ORDERS)]


def _make(
    letter: Declared, name: str, units: Sequence[Unit], block: Block, *, assume: bool
) -> Iterator[Variable]:
    """Yield the variable of a letter, and one for each of its derivatives."""
    first, *others = letter.names
    dimension = units[0].dimension
    meaning, _, convention = letter.meaning.partition("; ")
    if letter.is_family:
        yield Variable(sp.IndexedBase(name, real=True), meaning, dimension, latex=letter.names)
        return
    if letter.shape:
        yield Variable(sp.MatrixSymbol(name, *letter.shape), meaning, dimension, latex=letter.names)
        return
    printed = (first, *others, *((f"{first}({letter.running})",) if letter.running else ()))
    within: sp.Set = sp.S.Reals
    is_positive = assume and f"{first}>0" in letter.conditions
    symbol = sp.Symbol(name, positive=True) if is_positive else sp.Symbol(name, real=True)
    if first in block.natural:
        symbol, within = sp.Symbol(name, integer=True, positive=True), sp.S.Naturals
    given = (name_symbol(text.partition("=")[0]) for text in block.values)
    if first in block.integer or (first in block.natural and name_symbol(first) in given):
        symbol, within = sp.Symbol(name, integer=True), sp.S.Integers
    if first in block.branches:
        within = sp.FiniteSet(-1, 1)
    yield Variable(symbol, meaning, dimension, within, sign=convention, latex=printed)
    for order in ORDERS if letter.running else ():
        rates = [*print_rate(first, letter.running, order)]
        yield Variable(
            sp.Symbol(f"d{order if order > 1 else ''}{name}" if assume else rates[0], real=True),
            f"derivative of {meaning or first} by {letter.running}, order {order}",
            units[order].dimension,
            latex=tuple(p for rate in rates for p in (rate, f"{rate}({letter.running})")),
        )


def _find_matrix_rates(
    letters: Sequence[Declared], symbols: Mapping[str, sp.Basic]
) -> Iterator[tuple[sp.Basic, tuple[sp.Basic, tuple[sp.Basic, ...]]]]:
    r"""Yield matrices with time and their derivatives by it, which have lines of their own."""
    shaped = {name_symbol(name): x for x in letters if x.shape for name in x.names}
    for letter in letters if TIME in symbols else ():
        found = []
        for order in ORDERS:
            names = map(name_symbol, print_rate(letter.names[0], TIME, order))
            rate = next((shaped[name] for name in names if name in shaped), None)
            if rate is None or rate.shape != letter.shape:
                break
            found.append(symbols[rate.names[0]])
        if found:
            yield symbols[letter.names[0]], (symbols[TIME], tuple(found))


def _find_phases(
    variables: Sequence[Variable], running: Collection[sp.Basic], bare: Collection[sp.Basic]
) -> Iterator[tuple[sp.Basic, sp.Basic]]:
    r"""Yield pairs of adjacent letters that form a phase: \omega t by their units, or N\varphi.

    N counts or is a number; the first letter of a phase may itself follow N or pi.
    """
    known = [v for v in variables if v.symbol not in bare]
    units = [v for v in known if v.dimension != NUMBER]
    speeds: set[sp.Basic] = set()
    for by in (v for v in units if v.symbol in running):
        for v in units:
            if v.dimension * by.dimension == NUMBER:
                speeds.add(v.symbol)
                yield v.symbol, by.symbol
    angles = {v.symbol for v in known if v.dimension.is_angle}
    numbers = {v.symbol for v in known if v.dimension == NUMBER} - angles
    counts = numbers | {v.symbol for v in variables if v.symbol.is_integer}
    yield from product(counts, {*angles, *speeds, sp.pi})
    yield from product([sp.pi], speeds)


def add_shown(symbols: Symbols, prints: Sequence[str]) -> Symbols:
    r"""Return the symbols with what prints show: letters that always have a bracket after them.

    Phases of letters without units, \cos\Omega t, are added as well.
    """
    names = {name_symbol(name): v.symbol for v in symbols.variables for name in v.latex}
    prints = [text for text in prints if _has_signs(text)]
    pairs = find_phases(prints)
    shown = ([*map(names.get, map(name_symbol, pair))] for pair in pairs)
    found = {(one, other) for one, other in shown if {one, other} & symbols.bare and one and other}
    notation = replace(
        symbols.notation,
        phases=symbols.notation.phases | found,
        bracketed=find_bracketed(prints),
    )
    return replace(symbols, notation=notation)


def _has_signs(text: str) -> bool:
    """Return whether a print can be split into signs; rows report the others."""
    with suppress(ReadingError):
        return bool(list_signs(text))
    return False


def _say(symbols: Symbols, block: Block) -> Symbols:
    """Add what the block says of the letters: relations, sizes, where integrals start."""
    reader = symbols.reader()
    said = [condition for letter in block.letters for condition in letter.conditions]
    variables, where = symbols.variables, list[sp.Basic]()
    for text in (*said, *block.where):
        with block.blame(text):
            variables, more = narrow(variables, read_relations(text, reader))
            where += more
    usual: dict[sp.Basic, sp.Expr] = {}
    for text in block.sizes:
        with block.blame(text):
            usual |= _read_sizes(text, variables, reader, block)
    notation = symbols.notation
    if block.start:
        with block.blame(block.start):
            read = reader.parse(block.start)
            limit = read.meaning().of(read.chains[0].members[0])
            notation = replace(notation, lower_limit=limit)
    return replace(symbols, variables=variables, where=tuple(where), usual=usual, notation=notation)


def _read_sizes(
    text: str, variables: Sequence[Variable], reader: Reader, block: Block
) -> dict[sp.Basic, sp.Expr]:
    """Read the sizes of letters, converted to their declared units."""
    unit = _UNITS.search(text)
    sizes = {}
    for relation in read_relations(text[: unit.start()] if unit else text, reader):
        if not (isinstance(relation, sp.Equality) and relation.lhs.is_Symbol):
            raise ValueError(f"sizes: {text}: a size is written letter=number")
        names = next(v.latex for v in variables if v.symbol == relation.lhs)
        factor = _convert(text, unit[1], names, block) if unit else sp.S.One
        sizes[relation.lhs] = relation.rhs * factor
    return sizes


def _convert(text: str, printed: str, names: Sequence[str], block: Block) -> sp.Expr:
    """Return a printed unit in the unit of the letter; raises `ValueError` if they do not match."""
    declared = next((x.unit for x in block.letters if {*x.names} & {*names}), None)
    own, unit = read_unit(declared or ""), read_unit(printed)
    factor = unit.scale / own.scale
    if declared is None or unit.dimension != own.dimension or not factor.is_finite:
        raise ValueError(f"sizes: {text}: the letter is declared in [{declared or ''}]")
    return factor
