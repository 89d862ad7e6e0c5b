"""Guesses about letters: what would remedy the reader's refusals of prints."""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import dataclass, field
from typing import TypeVar

from mechproof.latex import ReadingError
from mechproof.latex.errors import Remedies

T = TypeVar("T")
REMEDIES = Remedies(
    name="Declare it in the block of letters: {0} : its meaning",
    bracket="Declare in the block of letters: factor {0}, or the whole print, {0}(…), as a letter.",
    function=r"State in the block of letters which function it is: function \{0} is …",
    scope="Print another letter for '{0}' where it is bound.",
    lower_limit="State in the block of letters: from 0, or wherever it starts.",
    family="Declare a family in the block of letters: {0} ({1}) : its meaning",
    membership="Declare a letter that counts in the block of letters, natural or integer; "
    "print an interval as a relation, 0<x<1.",
    rate="If it is a derivative, declare what {0} depends on: {0}({1}) : its meaning. Otherwise:",
    sign=r", or declare a letter that is 1 or -1 in the block of letters, branch \sigma=\pm1",
    depends="If {0} depends on {1}, say so in the block of letters: {0}({1}) : its meaning. "
    "Otherwise:",
)
_ASKS = re.compile(r"a (?:bracket|fraction) after (.+?): a factor")
_INVERSE = re.compile(r"function \\([a-z]+)\^\{-1\} is")
_ITALICS = re.compile(r"([A-Za-z]+) in italics: a function")
# The functions that the power -1 mostly means.
INVERSES = {
    **{"sin": "arcsin", "cos": "arccos", "tan": "arctan"},
    **{"sinh": "arsinh", "cosh": "arcosh", "tanh": "artanh"},
}
NAMES = re.compile(re.escape(REMEDIES.name).replace(r"\{0\}", r"(.+?)"))
# A bracket, and contents that are arguments: one letter, or several parts.
BRACKET = re.compile(r"(?:\\left\s*)?\((?P<inner>(?:[^()]|\([^()]*\))*?)(?:\\right\s*)?\)")
_ARGUMENTS = re.compile(r"\s*(?:\\[A-Za-z]+|[A-Za-z])(?:_(?:\w|\{[^{}]*\}))?\s*|[^()]*,[^()]*")
# A power of e other than a number, which may be a power of a length e.
_NO_SQUARE = r"(?!\s*(?:\d|\{\s*\d+\s*\}))"
# Signs after the first value of an index.
_RUNS_ON = r"(?:\}|,\s*(?:\d|\\[lc]?dots|\.\.)|\\[lc]?dots|\.\.)"
# Prints that show that such a letter is not a quantity.
NO_LETTER = {
    "e": re.compile(rf"(?<![A-Za-z\\])[A-Za-z]{{0,3}}e\s*\^{_NO_SQUARE}"),
    "d": re.compile(r"\\int|\{\s*d\s*(?:\\[A-Za-z]+|[A-Za-z])[^{}]*\}"),
    "i": re.compile(rf"i\s*(?:=\s*\d+\s*{_RUNS_ON}|\\in)|e\s*\^{_NO_SQUARE}"),
}
# Signs of an increment where they are alone, and so are letters.
_INCREMENTS = {
    sign: re.compile(rf"\\{sign[1:]}\s*(?:[=+\-)}},^&]|\\\\|\Z)", re.MULTILINE)
    for sign in (r"\delta", r"\Delta")
}


@dataclass
class Guesses:
    """Remedies for refusals of the prints `all_prints`; `declares` permits letters, too.

    Letters that are `said` are quantities, whatever else is printed like them.
    """

    all_prints: str
    declares: bool
    imaginary: str
    said: Collection[str]
    factors: dict[str, None] = field(default_factory=dict)
    letters: dict[str, None] = field(default_factory=dict)
    functions: dict[str, str] = field(default_factory=dict)

    def take(self, error: ReadingError) -> bool:
        """Add what would remedy a refusal; return whether there is anything new."""
        inverse = _INVERSE.search(error.remedy) if self.declares else None
        if inverse and inverse[1] in INVERSES:
            printed = rf"\{inverse[1]}^{{-1}}"
            return _enter(printed, self.functions, rf"\{INVERSES[inverse[1]]}")
        italics = _ITALICS.search(error.reason)
        if self.declares and italics:
            return _enter(italics[1], self.functions, rf"\{italics[1]}")
        asked = _ASKS.search(error.reason)
        named = NAMES.search(error.remedy)
        if asked:
            arguments = _find_arguments(error.latex, error.place) if self.declares else ""
            if arguments == r"\pi" and "pi" not in self.said:
                arguments = ""
            if not arguments:
                return _enter(asked[1], self.factors, None)
            return _enter(f"{asked[1]}({arguments})", self.letters, None)
        if not named or self._is_taken_up(named[1]):
            return False
        # If nothing is declared, such a letter may be accepted after all, also with an index.
        if not (self.declares or named[1].partition("_")[0] in NO_LETTER):
            return False
        sign = named[1].partition(" ")[0]
        if sign in _INCREMENTS and _INCREMENTS[sign].search(self.all_prints):
            return _enter(sign, self.letters, None)
        return _enter(named[1], self.letters, None)

    def _is_taken_up(self, name: str) -> bool:
        is_open = name in NO_LETTER and name not in self.said
        return is_open and bool(NO_LETTER[name].search(self.all_prints))


def _enter(name: str, names: dict[str, T], value: T) -> bool:
    is_new = name not in names
    names[name] = value
    return is_new


def _find_arguments(latex: str, place: int) -> str:
    """Return the content of a bracket if it holds arguments rather than a factor, else ""."""
    bracket = BRACKET.match(latex, place)
    is_list = bracket is not None and _ARGUMENTS.fullmatch(bracket["inner"])
    return bracket["inner"].strip() if bracket and is_list else ""
