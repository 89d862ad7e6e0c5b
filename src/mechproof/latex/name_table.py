"""The table of names: how the symbols of a paper are printed, longest first."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from functools import lru_cache

import sympy as sp

from mechproof.latex.errors import ReadingError
from mechproof.latex.latex_signs import Token
from mechproof.latex.tokens import list_signs
from mechproof.record import Notation, Variable

INDEX = "#"
_BRACES = re.compile(r"[\\{}\s]")


@dataclass(frozen=True)
class Name:
    """A declared way to print a symbol, as signs; `INDEX` stands for indices."""

    signs: tuple[str, ...]
    symbol: sp.Symbol | sp.IndexedBase | sp.MatrixSymbol
    latex: str


@dataclass(frozen=True)
class Match:
    """A name that was found: the place after it, and the places of its indices."""

    name: Name
    end: int
    indices: tuple[tuple[int, int], ...]


def strip_braces(latex: str) -> str:
    """Return a name without blanks, braces and backslashes, alike for all prints of a letter."""
    return _BRACES.sub("", latex)


class Names:
    """All names of a row, found by their first sign."""

    def __init__(self, names: Collection[Name]) -> None:
        self._by_first: dict[str, list[Name]] = {}
        self._plain = {strip_braces(str(name.symbol)): name.latex for name in names}
        self.signs = {sign for name in names for sign in name.signs}
        for name in names:
            self._by_first.setdefault(name.signs[0], []).append(name)

    def match(self, tokens: Sequence[Token], place: int) -> Match | None:
        """Return the longest name at a place; of equally long ones the one without an index."""
        candidates = self._by_first.get(tokens[place].text, ()) if place < len(tokens) else ()
        found = filter(None, (_fit(name, tokens, place) for name in candidates))
        return max(found, key=_rank, default=None)

    def find(self, *signs: str) -> Name | None:
        """Return the name that consists of exactly these signs."""
        return next((n for n in self._by_first.get(signs[0], ()) if n.signs == signs), None)

    def find_alike(self, symbol: sp.Basic) -> str:
        """Return the print of a name that differs from a symbol only in braces, or ""."""
        return self._plain.get(strip_braces(str(symbol)), "")

    def find_argument(self, symbol: sp.Basic) -> Name | None:
        r"""Return the name of a symbol's declared argument: \theta for R(\theta)."""
        inside = (signs[1:-1] for signs in self.list_arguments(symbol))
        return next(filter(None, (self.find(*signs) for signs in inside if signs)), None)

    def list_arguments(self, symbol: sp.Basic) -> list[tuple[str, ...]]:
        r"""Return the brackets with which a symbol is declared: (\theta) for R(\theta)."""
        named = (n.signs for names in self._by_first.values() for n in names if n.symbol == symbol)
        return [s[s.index("(") :] for s in named if "(" in s and s[-1] == ")"]

    def longer(self, name: Name, sign: str) -> Name | None:
        """Return a name that continues this one with the given sign."""
        start = (*name.signs, sign)
        names = self._by_first[name.signs[0]]
        return next((n for n in names if n.signs[: len(start)] == start), None)

    def beginning(self, sign: str) -> list[str]:
        """Return the prints of names that begin with a sign, the first one for each symbol."""
        names = reversed(self._by_first.get(sign, ()))
        return sorted({name.symbol: name.latex for name in names}.values())


def _fit(name: Name, tokens: Sequence[Token], place: int) -> Match | None:
    indices: list[tuple[int, int]] = []
    for sign in name.signs:
        if place >= len(tokens):
            return None
        if sign == INDEX:
            end = find_brace(tokens, place)
            if not _is_index(tokens[place:end]):
                return None
            indices.append((place, end))
            place = end
        elif tokens[place].text == sign:
            place += 1
        else:
            return None
    return Match(name, place, tuple(indices))


def _rank(match: Match) -> tuple[int, bool, int]:
    """Return the rank of a match: by length, then names without index first, then by signs."""
    signs = match.name.signs
    return match.end, INDEX not in signs, len(signs)


def find_brace(tokens: Sequence[Token], place: int) -> int:
    """Return the place of the brace that closes the group around a place."""
    depth = 0
    while place < len(tokens) and (depth or tokens[place].text != "}"):
        depth += {"{": 1, "}": -1}.get(tokens[place].text, 0)
        place += 1
    return place


def _is_index(tokens: Sequence[Token]) -> bool:
    """Return whether all signs are small letters, digits, plus or minus."""
    texts = [token.text for token in tokens]
    return bool(texts) and all(
        t.isdigit() or t in "+-" or (len(t) == 1 and t.islower()) for t in texts
    )


def build_names(variables: Sequence[Variable], notation: Notation, row: str = "") -> Names:
    """Return the names of a row: those of its scopes, then those of the symbols.

    Raises `ValueError` if two symbols share a print, or if a name cannot be read.
    """
    scoped = {
        to_signs(latex): (latex, symbol)
        for scope in notation.scopes
        if any(row == name or row.startswith(f"{name}, ") for name in scope.rows)
        for latex, symbol in scope.names.items()
    }
    names = {s: Name(s, symbol, latex) for s, (latex, symbol) in scoped.items() if symbol}
    declared: dict[tuple[str, ...], Name] = {}
    for variable in variables:
        for latex in variable.latex:
            signs = to_signs(latex, isinstance(variable.symbol, sp.IndexedBase))
            other = declared.setdefault(signs, Name(signs, variable.symbol, latex))
            if other.symbol != variable.symbol and signs not in scoped:
                raise ValueError(
                    f"{latex} is printed for {other.symbol} and for {variable.symbol}: "
                    "state the rows of each in Notation.scopes"
                )
    return Names([*names.values(), *(n for s, n in declared.items() if s not in scoped)])


@lru_cache(4096)
def to_signs(latex: str, is_family: bool = False) -> tuple[str, ...]:
    """Return the signs of a name; a family's name without a place for its indices gets one."""
    try:
        signs = tuple(list_signs(latex))
    except ReadingError as error:
        raise ValueError(f"the name {latex}: {error.reason}") from error
    if not signs:
        raise ValueError("the LaTeX of a name is empty")
    return (*signs, "_", "{", INDEX, "}") if is_family and INDEX not in signs else signs
