r"""Names of the symbols of letters and of their derivatives, and how these are printed.

Two letters may be printed at once, x_{1,2}=a\pm b: which letters are meant, and how they are
related.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import replace
from functools import partial
from itertools import product

import sympy as sp

from mechproof.latex.latex_signs import DOUBLE
from mechproof.latex.name_table import to_signs
from mechproof.latex.printed_commands import ACCENTS
from mechproof.nomenclature.block import Block, Declared
from mechproof.nomenclature.shown_letters import name_symbol, show_letter
from mechproof.record import Variable
from mechproof.record.unit_notation import read_unit
from mechproof.sources.located_text import Place

# Orders of derivatives that have prints of their own.
ORDERS = (1, 2, 3)
TIME = "t"
# A letter with its accents, and the rest of its name.
_ACCENT = "|".join(map(re.escape, ACCENTS))
_STEM = re.compile(
    rf"((?:(?:{_ACCENT})(?![A-Za-z])\s*)*(?:\\[A-Za-z]+(?:\s*\{{[^{{}}]*\}})?|\{{[^{{}}]*\}}|.))(.*)\Z",
    re.DOTALL,
)

# A word as an index, and the commands that may set it.
_SET = (
    r"\\(?:mathrm|text|textrm)\s*\{\s*[A-Za-z]{2,}\s*\}|"
    r"\\rm\s+[A-Za-z]{2,}|\\(?:max|min)(?![A-Za-z])"
)
_INDEX = re.compile(rf"_\{{\s*(?:{_SET}|[A-Za-z]{{2,}})\s*\}}|_(?:{_SET})")
_WORD = re.compile(r"[A-Za-z]{2,}(?=[\s}]*\Z)")
_TYPES = (r"_{{{}}}", r"_{{\mathrm{{{}}}}}", r"_{{\text{{{}}}}}")
_PAIR = re.compile(r"(.+)_\{?(\d)\s*(?:[,/]|\{,\}|\\,)+\s*(\d)\}?")
_PRINT = re.compile(
    r"(?:\\[A-Za-z]+|[A-Za-z])\s*_\s*\{\s*\d\s*(?:[,/]|\{,\}|\\,)+\s*\d\s*\}", re.DOTALL
)


def name_letter(letter: Declared, rates: Collection[str], *, assume: bool) -> str:
    """Return the name of a letter's symbol: its print, so that answers show it.

    A letter printed as the derivative of another gets braces around its name, as it is another
    symbol. With `assume`, as modules do, the name has no braces.
    """
    printed = letter.symbol or letter.names[0]
    if assume:
        return name_symbol(printed)
    is_rate = not letter.symbol and name_symbol(printed) in rates
    return f"{{{show_letter(printed)}}}" if is_rate else show_letter(printed)


def list_rates(letter: Declared) -> list[str]:
    """Return all prints of the derivatives of a letter, none if it depends on nothing."""
    first, by = letter.names[0], letter.running
    return [rate for order in ORDERS for rate in print_rate(first, by, order)] if by else []


def print_rate(latex: str, by: str, order: int) -> Iterator[str]:
    r"""Yield the prints of a derivative: \dot x_1, x', dx/dt."""
    match = _STEM.match(latex)
    stem, script = (match[1], match[2]) if match else (latex, "")
    power = f"^{{{order}}}" if order > 1 else ""
    if by == TIME:
        accent = (r"\dot", r"\ddot", r"\dddot")[order - 1]
        yield rf"{accent}{{{stem}}}{script}"
        if script:
            yield rf"{accent}{{{latex}}}"
    else:
        yield latex + "'" * order
    for d in ("d", r"\mathrm{d}"):
        yield rf"\frac{{{d}{power}{latex}}}{{{d}{by}{power}}}"


def say_rate(
    letter: Declared, variables: list[Variable], scales: dict[sp.Basic, sp.Expr]
) -> sp.Basic:
    r"""Apply the declaration of a derivative, \dot x for x(t): meaning, unit, names.

    Returns its symbol; raises `ValueError` if its unit has another dimension than the derivative.
    """
    names = {*map(name_symbol, letter.names)}
    place, rate = next(
        (n, v) for n, v in enumerate(variables) if names & {*map(name_symbol, v.latex)}
    )
    if letter.unit is not None:
        unit = read_unit(letter.unit)
        if rate.symbol in scales and unit.dimension != rate.dimension:
            reason = f"{letter.names[0]} is the {rate.meaning}: its unit cannot be"
            raise ValueError(f"{reason} [{letter.unit}]")
        scales[rate.symbol] = unit.scale
    latex = tuple(dict.fromkeys((*rate.latex, *letter.names)))
    meaning = letter.meaning.partition("; ")[0] or rate.meaning
    variables[place] = replace(rate, meaning=meaning, latex=latex)
    return rate.symbol


def refuse_twins(
    variables: Sequence[Variable],
    rates: Collection[sp.Basic],
    blame: Callable[[Variable], AbstractContextManager[None]],
) -> None:
    """Refuse letters, except derivatives, whose names differ in braces only.

    The second of two is blamed.
    """
    met: dict[str, Variable] = {}
    for variable in variables:
        name = variable.symbol.name
        key = name if variable.symbol in rates else name_symbol(name)
        other = met.setdefault(key, variable)
        if other is not variable:
            one, two = other.latex[0], variable.latex[0]
            same = "is declared twice" if one == two else f"and {two} are too similar"
            with blame(variable):
                raise ValueError(f"{one} {same}: print another letter, or declare them as one: |")


def leave_names(
    variables: Sequence[Variable], places: Mapping[sp.Basic, Place | None]
) -> tuple[list[Variable], list[tuple[Place | None, str]]]:
    """Return variables without names that are unreadable or taken, and the faults found."""
    met: dict[tuple[str, ...], Variable] = {}
    found, faults = [], []
    for v in variables:
        kept = []
        for latex in v.latex:
            try:
                signs = to_signs(latex, isinstance(v.symbol, sp.IndexedBase))
                other = met.setdefault(signs, v)
                is_own = other.symbol == v.symbol
                reason = "" if is_own else f"the name {latex} is also that of {other.latex[0]}"
            except ValueError as error:
                reason = str(error)
            kept += [] if reason else [latex]
            faults += [(places[v.symbol], f"{reason}; it is left out")] if reason else []
        found.append(replace(v, latex=tuple(kept)))
    return found, faults


def set_otherwise(variables: Sequence[Variable]) -> Iterator[Variable]:
    r"""Yield variables with their names in other typefaces added, F_{\max} for F_{max}, where free.

    A word as an index is the same in italics and upright.
    """
    taken = {name: v.symbol for v in variables for name in map(_to_signs(v), v.latex)}
    for v in variables:
        others = {
            _to_signs(v)(other): other
            for latex, kind in product(v.latex, _TYPES)
            if (other := _INDEX.sub(partial(_set, kind), latex)) != latex
        }
        new = {signs: other for signs, other in others.items() if signs not in taken}
        taken |= dict.fromkeys(new, v.symbol)
        yield replace(v, latex=(*v.latex, *new.values()))


def _to_signs(variable: Variable) -> Callable[[str], tuple[str, ...]]:
    return partial(to_signs, is_family=isinstance(variable.symbol, sp.IndexedBase))


def _set(kind: str, index: re.Match[str]) -> str:
    return kind.format(*_WORD.findall(index[0]))


def find_stem(letter: str) -> str:
    """Return x for the name of two letters, x_{1,2}, "" for any other."""
    pair = _PAIR.fullmatch(letter)
    return pair[1] if pair else ""


def list_halves(letter: str) -> tuple[str, ...]:
    """Return x_1 and x_2 for the name of two letters, x_{1,2}, () for any other."""
    pair = _PAIR.fullmatch(letter)
    return (f"{pair[1]}_{pair[2]}", f"{pair[1]}_{pair[3]}") if pair else ()


def find_pairs(prints: Iterable[str]) -> Iterator[str]:
    """Yield the names of two letters in prints with double signs."""
    for latex in prints:
        if DOUBLE.search(latex):
            yield from _PRINT.findall(latex)


def leave_pairs(letters: Iterable[str], prints: Iterable[str]) -> list[str]:
    """Return letters without names that stand for two of the other letters."""
    letters = [*letters]
    known = {*map(name_symbol, letters)}
    pairs = map(name_symbol, find_pairs(prints))
    both = {name for name in pairs if {*list_halves(name)} <= known}
    return [x for x in letters if name_symbol(x) not in both]


def add_pairs(block: Block, prints: Iterable[str]) -> dict[str, tuple[str, ...]]:
    """Declare names that stand for two declared letters; return the two letters by the name.

    The unit is that of the first letter; conditions on either letter are not copied. A name that
    the block itself declares is a letter of its own, such as the ratio i_{1,2}.
    """
    declared = {name_symbol(name): x for x in block.letters for name in x.names}
    found: dict[str, dict[str, None]] = {}
    for name in find_pairs(prints):
        if {*list_halves(name_symbol(name))} <= declared.keys() - {name_symbol(name)}:
            found.setdefault(name_symbol(name), {})[name] = None
    pairs = {name: list_halves(name) for name in found if name not in declared}
    for name, halves in pairs.items():
        one = declared[halves[0]]
        block.letters.append(Declared((*found[name],), one.meaning, one.unit, shape=one.shape))
    return pairs
