r"""Vectors and matrices in a single equation, by their letters: \mathbf{a}, \vec{F}, \mathbf{A}."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from mechproof.latex.printed_commands import VECTORS
from mechproof.latex.values import Moving
from mechproof.record import Definition, Equality, Row, Variable

_BOLD = re.compile(
    rf"(?:{'|'.join(map(re.escape, VECTORS))})"
    r"(?:\s*\{\s*(?P<inside>\\?[A-Za-z]+)\s*\}|\s*(?P<command>\\[A-Za-z]+)|\s+(?P<letter>[A-Za-z]))"
    r"(?P<index>_(?:\w|\{[^{}]*\}))?"
)
# An index after the dots of a letter belongs to the letter.
_BEHIND_DOTS = re.compile(r"(\\d{1,3}ot\s*\{[^{}]*(?:\{[^{}]*\})?)\s*\}(_(?:\w|\{[^{}]*\}))")
# Typefaces in which a capital may be a matrix, and adjacent letters are a product; an arrow, by
# contrast, may be above two points.
_TYPE = r"\\(?:mathbf|boldsymbol|bm|pmb)\s*"
_PRODUCT = re.compile(rf"{_TYPE}\{{\s*[A-Za-z]{{2,}}\s*\}}")
_CAPITAL = re.compile(rf"{_TYPE}\{{?\s*(?:[A-Z]|\\[A-Z])")
# Unit vectors and unit matrices, by the letters that they mostly have.
_UNITY = re.compile(rf"(?:{_TYPE}|\\vect?\s*)\{{?\s*[eijknIE]\s*\}}?(?:_.*)?")


def find_bold(prints: Iterable[str], named: Iterable[str]) -> tuple[str, ...]:
    """Return the letters of prints that are bold or have an arrow, except those named as numbers.

    Each comes with its index.
    """
    texts = (_BEHIND_DOTS.sub(r"\1\2}", text) for text in prints)
    found = [one[0] for text in texts for one in _BOLD.finditer(text)]
    numbers = {*map(_bare, named)}
    letters = {_bare(latex): latex for latex in reversed(found)}
    return tuple(latex for bare, latex in letters.items() if bare not in numbers)


def is_capital(latex: str) -> bool:
    """Return whether a print has a bold capital, which is a matrix as often as a vector."""
    return bool(_CAPITAL.search(latex))


def show_entries(variable: Variable) -> Iterator[Variable]:
    """Yield a letter, and the letters of its entries if it is a vector or a matrix."""
    symbol = variable.symbol
    if not isinstance(symbol, sp.MatrixSymbol):
        yield variable
        return
    entries = _list_entries(symbol)
    yield replace(variable, given=sp.ImmutableMatrix(*symbol.shape, entries))
    yield from (Variable(entry, variable.meaning, latex=()) for entry in entries)


def move_entries(moving: Moving) -> Moving:
    """Return the dependences of letters, with entries in place of vectors and matrices."""
    entries = {
        entry: (by, own)
        for letter, (by, rates) in moving.items()
        if isinstance(letter, sp.MatrixSymbol)
        for entry, *own in zip(*map(_list_entries, (letter, *rates)), strict=True)
    }
    return {**moving, **{entry: (by, tuple(own)) for entry, (by, own) in entries.items()}}


def _list_entries(symbol: sp.MatrixSymbol) -> list[sp.Symbol]:
    return [sp.Symbol(f"{symbol}[{place}]", real=True) for place in _list_places(symbol)]


def _list_places(symbol: sp.MatrixSymbol) -> list[str]:
    rows, columns = (range(1, int(size) + 1) for size in symbol.shape)
    if len(columns) == 1:
        return [str(row) for row in rows]
    return [f"{row}, {column}" for row in rows for column in columns]


def refuse_unclear(letters: Iterable[str], bold: Iterable[str]) -> None:
    r"""Raise `ValueError` for \mathbf{AB}, unit vectors, and F, F_x, or x and y next to \vec{F}."""
    letters, bold = tuple(letters), tuple(bold)
    for latex in (*letters, *bold):
        if _PRODUCT.match(latex):
            raise ValueError(f"{latex}: one letter, or a product? Print \\mathbf for each letter")
        if _UNITY.fullmatch(latex) or (r"\hat" in latex and _BOLD.search(latex)):
            raise ValueError(
                f"{latex}: a unit vector or matrix, or not? Print its components, or another letter"
            )
    plain = {letter for letter in letters if not _BOLD.fullmatch(letter)}
    if bold and {"x", "y"} <= plain:
        raise ValueError(
            f"x and y next to {bold[0]}: its components? Print all of them, or other letters"
        )
    for latex in bold:
        found = _BOLD.fullmatch(latex)
        name = "".join(filter(None, found.groups())) if found else ""
        for letter in sorted(plain):
            if _bare(name) in (_bare(letter), _bare(letter.partition("_")[0])):
                raise ValueError(
                    f"{letter} next to {latex}: its length, or a component of it? Print |{latex}| "
                    "for the length, all components for the vectors, or another letter"
                )


def _bare(name: str) -> str:
    """Return a name without braces and blanks."""
    return name.replace("{", "").replace("}", "").replace(" ", "")


def compare_bold(row: Row, variables: Sequence[Variable]) -> Row:
    """Treat a bold letter alone on one side, and not on the other, as introduced there.

    Raises `ValueError` for sides of different sizes.
    """
    says = row.says
    given: dict[sp.Basic, Any] = {
        v.symbol: v.given for v in variables if isinstance(v.symbol, sp.MatrixSymbol)
    }
    if isinstance(says, Definition) and says.symbol in given:
        sides = (given[says.symbol], says.printed)
    elif isinstance(says, Equality) and given:
        sides = (says.printed, says.rebuilt)
    else:
        return row
    one, other = (given.get(side, side) for side in sides)
    shapes = [getattr(side, "shape", ()) for side in (one, other)]
    if shapes[0] != shapes[1]:
        raise ValueError(
            f"the sides differ in size, {shapes[0]} and {shapes[1]}: bold letters are taken as "
            "vectors of 3 components, capitals as 3x3 matrices where that fits"
        )
    for symbol, entries in given.items():
        for side, rest in ((one, other), (other, one)):
            if side == entries and not entries.free_symbols & rest.free_symbols:
                return replace(row, says=Definition(symbol, rest))
    return replace(row, says=Equality(one, other, "member"))
