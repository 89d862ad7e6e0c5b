"""Cells of tables: a head is a letter or formula with its unit, a cell below it is a number."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from mechproof.latex import Reader, ReadingError
from mechproof.record import find_last_place
from mechproof.record.unit_notation import Unit, UnitError, drop_braces, read_unit, spell_unit

_UPRIGHT = re.compile(r"\\(?:mathrm|text|textrm|si|unit|mathsf|SI|qty)\s*\{([^{}]*)\}")
_FRACTION = re.compile(r"\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}")
_SINGLE = re.compile(r"\\(?:mathrm|text|rm)\s+(?=[A-Za-z])")
_DEGREE = re.compile(r"\^?\s*\{?\s*\\(?:circ|degree)(?![A-Za-z])\s*\}?|º")
_MICRO = re.compile(r"\\mu(?![A-Za-z])\s*")
_BLANK = re.compile(r"\\[,;:! ]|~|\$|\\(?:quad|left|right)(?![A-Za-z])")
_UNIT = re.compile(
    r"(?:[\s~$]|\\[,; ])*(?:[\[(](?P<a>[^\[\]()]*)[\])]|[,;](?P<b>[^,;]+)|/(?P<c>[^/]+)"
    r"|\bin\b(?P<d>.+))[\s$]*\Z",
    re.DOTALL,
)
_WORDS = re.compile(r"(?P<before>[^$]*)\$(?P<letter>[^$]+)\$(?P<after>[^$]*)\Z")
_NUMBER = re.compile(
    r"(?P<sign>[-+\u2212]?)(?P<digits>\d+(?:\.\d+)?)"
    r"(?:(?:\\cdot|\\times|[x\u00d7·])10\^?\{?(?P<ten>[-+\u2212]?\d+)\}?|[eE](?P<power>[-+]?\d+))?"
    r"(?P<unit>[^\d].*)?\Z"
)
# Marks of a head that shows a formula.
MATH = re.compile(r"\$|\\\(")
# What an empty cell contains.
NOTHING = "-$ {}\u2212\u2013\u2014"
_COMMA = re.compile(r"(?<=\d)(?:\{,\}|,)(?=\d)")
_THOUSANDS = re.compile(r"[-+\u2212]?[1-9]\d{0,2}(?:,\d{3})+(?:\.\d+)?")


@dataclass(frozen=True)
class Head:
    """The content of a column: a letter or a formula, its unit if printed, and words around it."""

    symbol: sp.Basic
    printed: str
    unit: Unit | None
    words: str = ""

    @property
    def is_letter(self) -> bool:
        """Return whether it is a letter, whose numbers can serve as sizes, too."""
        return isinstance(self.symbol, sp.Symbol)


@dataclass(frozen=True)
class Numeral:
    """A number of a cell: its digits, the power of ten that multiplies them, and its unit."""

    digits: str
    factor: sp.Expr
    unit: Unit | None = None

    @property
    def value(self) -> sp.Expr:
        """Return the number, without its unit."""
        return sp.Rational(self.digits) * self.factor

    @property
    def half_place(self) -> sp.Expr:
        """Return half a unit of the last place; zeros that end an integer do not count."""
        zeros = 0 if self.is_decimal else len(self.digits) - len(self.digits.rstrip("0"))
        return find_last_place(self.digits) * sp.Integer(10) ** zeros / 2

    @property
    def is_decimal(self) -> bool:
        """Return whether it has decimal places or a power of ten, and so may have been rounded."""
        return "." in self.digits or "e" in self.digits


def name_unit(text: str) -> str:
    r"""Return the name of a printed unit, mm for \,\mathrm{mm}; "" if it is not a unit."""
    shown = _DEGREE.sub("°", _BLANK.sub(" ", _MICRO.sub("µ", text)).replace(r"\%", "%"))
    shown = _SINGLE.sub("", drop_braces(shown))
    while (inside := _FRACTION.sub(_write_slash, _UPRIGHT.sub(r"\1", shown))) != shown:
        shown = inside
    shown = spell_unit(shown.strip(" {}[]")).replace("{", "").replace("}", "")
    if shown.startswith("(") and shown.endswith(")"):
        shown = shown[1:-1]
    try:
        read_unit(shown)
    except UnitError:
        return ""
    return shown


def _write_slash(fraction: re.Match[str]) -> str:
    """Write a fraction of units with slashes, W/m^2/K."""
    below = re.split(r"\s*(?:\\cdot\s*|[\s·*])\s*", fraction[2].strip())
    return "/".join((fraction[1], *below))


def find_unit(text: str) -> Unit | None:
    """Return the unit that a text prints, None if it is not a unit."""
    name = name_unit(text)
    return replace(read_unit(name), name=name) if name else None


def read_head(text: str, reader: Reader) -> Head | None:
    """Return the content of a head, None unless it is a declared letter or a formula of these."""
    text = text.strip()
    if text.startswith("{") and text.endswith("}"):
        text = text[1:-1].strip()
    if letter := _find_letter(text, reader):
        return Head(letter, text.strip("$ "), None)
    formula = find_formula(text, reader) if MATH.search(text) else None
    plain = _DEGREE.search(text)
    if plain and not text[plain.end() :].strip("$ "):
        before = text[: plain.start()].rstrip(" ,[($")
        if letter := _find_letter(before, reader):
            return Head(letter, before.strip("$ "), find_unit("°"))
    unit = _UNIT.search(text)
    known = find_unit(next(filter(None, unit.groups()), "")) if unit else None
    before = text[: unit.start()] if unit else ""
    letter = _find_letter(before, reader)
    if known and letter and formula:
        # After a slash there is a unit, or a letter that is divided by.
        other = reader.notation.dimensions.get(letter, known.dimension)
        return None if other == known.dimension else Head(formula, text.strip("$ "), None)
    if formula:
        return Head(formula, text.strip("$ "), None)
    if unit and letter:
        return Head(letter, before.strip("$ "), known) if known else None
    if known and MATH.search(before) and (formula := find_formula(before, reader)):
        return Head(formula, before.strip("$ "), known)
    return _read_among_words(text, reader)


def _read_among_words(text: str, reader: Reader) -> Head | None:
    words = _WORDS.match(text)
    letter = _find_letter(words["letter"], reader) if words else None
    if words is None or letter is None:
        return None
    after = words["after"]
    unit = _UNIT.search(after)
    known = find_unit(next(filter(None, unit.groups()), "")) if unit else None
    rest = after[: unit.start()] if unit and known else after
    said = " ".join(f"{words['before']} {rest}".replace("~", " ").split()).strip(" ,:")
    return Head(letter, words["letter"].strip(), known, said)


def _find_letter(text: str, reader: Reader) -> sp.Symbol | None:
    found = _read_alone(text, reader)
    return found if isinstance(found, sp.Symbol) else None


def find_formula(text: str, reader: Reader) -> sp.Expr | None:
    """Return the formula of declared letters that a text consists of, or None."""
    found = _read_alone(text, reader)
    is_formula = isinstance(found, sp.Expr) and bool(found.free_symbols)
    return found if is_formula and not isinstance(found, sp.Symbol) else None


def _read_alone(text: str, reader: Reader) -> Any:
    try:
        read = reader.parse(text.strip(" $~"))
        (chain, *others) = read.chains
        (member, *more) = chain.members
        alone = not (others or more or chain.condition)
        return read.meaning().of(member) if alone else None
    except ReadingError:
        return None


def is_unit_or_empty(text: str) -> bool:
    """Return whether a cell below a head contains only a unit, or nothing."""
    has_digits = any(sign.isdigit() for sign in text)
    return not text.strip(NOTHING) or (not has_digits and find_unit(text) is not None)


def finds_decimal_commas(texts: Iterable[str]) -> bool | None:
    """Return whether the commas of a table are decimal, None if they may separate thousands."""
    shown = [_clean(text) for text in texts]
    commas = [text for text in shown if _COMMA.search(text)]
    if any("{,}" in text or not _THOUSANDS.fullmatch(text) for text in commas):
        return True
    has_points = any(re.search(r"\d\.\d", text) for text in shown)
    return False if has_points or not commas else None


def _clean(text: str) -> str:
    wrapped = re.sub(r"\\(?:num|SI|qty|mathbf|bm)\s*\{([^{}]*)\}", r"\1", text)
    return re.sub(r"\s", "", _BLANK.sub("", wrapped))


def read_numeral(text: str, *, decimal_comma: bool) -> Numeral | None:
    """Return the number of a cell, None if it is not a number."""
    shown = _clean(text).strip("{}") if text.strip().startswith("{") else _clean(text)
    shown = _COMMA.sub("." if decimal_comma else "", shown)
    found = _NUMBER.match(shown)
    if found is None:
        return None
    unit = find_unit(found["unit"]) if found["unit"] else None
    if found["unit"] and unit is None:
        return None
    ten = (found["ten"] or found["power"] or "0").replace("\u2212", "-")
    sign = "" if found["sign"] in ("", "+") else "-"
    return Numeral(sign + found["digits"], sp.Integer(10) ** int(ten), unit)
