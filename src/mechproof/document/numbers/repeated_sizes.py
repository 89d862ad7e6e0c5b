"""Sizes that are printed again: one that differs may be another case, or a misprint."""

from __future__ import annotations

import re

import sympy as sp

from mechproof.document.numbers.letter_sizes import LetterSizes, PrintedSize, read_size
from mechproof.document.tasks import Sign
from mechproof.nomenclature.cells import Numeral
from mechproof.sources.displays import Printed

_DIFFERS = "{} is printed in {}: another case, or a misprint?"
# What may say for which case a number is.
_CASE = re.compile(r"\\(?:text|mbox|q?quad)|[(\[|]|(?<![\\{])[,;](?!\s*\Z)|\\\\")


def doubt_size(sign: Sign, printed: Printed, sizes: LetterSizes) -> str:
    """Say that a letter has another size before, if nothing tells that it may go on to others."""
    letter, moving = sign.letter, sizes.known.symbols.moving
    if letter is None or not sign.number:
        return ""
    if letter in moving or letter in {by for by, _ in moving.values()}:
        return ""
    if _is_case(printed) or letter in sizes.restated.list_before(printed):
        return ""
    own = read_size(sign, printed, sizes.known)
    for before, other, one in sizes.every.get(letter, ()):
        if before.name == printed.name:
            return ""
        is_apart = _is_case(before) or _may_be_other(before, printed)
        if not (is_apart or _agree((other, one), (sign, own))):
            return _DIFFERS.format(before.latex.string.strip(" .,;\n"), before.name)
    return ""


def _is_case(printed: Printed) -> bool:
    return bool(_CASE.search(printed.latex.string))


def _may_be_other(before: Printed, printed: Printed) -> bool:
    """Return whether two prints are of one display, or words between may go on to another case."""
    first, said = before.announced, printed.announced
    is_anew = first.passage != said.passage and (said.is_case or said.is_new)
    is_other = first.is_apart(said) or first.example.number != said.example.number
    return before.group == printed.group or is_anew or is_other


def _agree(one: tuple[Sign, PrintedSize], other: tuple[Sign, PrintedSize]) -> bool:
    """Return whether sizes agree to the places that both have, or nothing tells that they do not.

    Zeros are special positions, and a number with a unit may be one without.
    """
    values, halves = zip(*map(_measure, (one, other)), strict=True)
    if not all(values) or (one[1].head.unit is None) != (other[1].head.unit is None):
        return True
    return bool(sp.Abs(values[0] - values[1]) <= max(halves))


def _measure(read: tuple[Sign, PrintedSize]) -> tuple[sp.Expr, sp.Expr]:
    """Return a size, and half of its last place, in units that all sizes of a letter have."""
    sign, one = read
    number, value = Numeral(sign.number, sp.S.One), one.size.value * one.unit
    return value, sp.Abs(number.half_place * value / number.value) if value else sp.S.Zero
