r"""Vectors of the plane as complex numbers, a\mathrm{e}^{j\varphi}: two equations of real parts.

All letters are real but those that an equation before gives a complex value.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import Any

import sympy as sp

from mechproof.document.known import Known
from mechproof.document.tasks import Role, Sign
from mechproof.record import Definition, Equality, Row, ValueWhere

_COMMAND = re.compile(r"\\[A-Za-z]+")
_EXPONENTIAL = re.compile(r"e\s*\}?\s*\^\s*\{\s*[-+]?\s*([ij])(?!\s*[_}])")
# Upright it is no index, and begins a term, a side or an exponent.
_UPRIGHT = re.compile(
    r"(?:\A|[-+=(&]|(?<![_^])\^\s*\{)\s*(?:\\mathrm|\{\\rm)\s*\{?\s*(?P<unit>[ij])\s*\}"
)
_NAMES = ("real part", "imaginary part")


def find_imaginary_unit(prints: Iterable[str]) -> str:
    r"""Return the letter of the imaginary unit, as e^{j\varphi} shows it; nothing if none does."""
    prints = list(prints)
    if upright := next(filter(None, map(_UPRIGHT.search, prints)), None):
        return rf"\mathrm{{{upright['unit']}}}"
    found = (_EXPONENTIAL.search(_COMMAND.sub("x", latex)) for latex in prints)
    return next((match[1] for match in found if match), "")


def split_parts(row: Row, sign: Sign, known: Known) -> Iterator[tuple[Row, Sign]]:
    """Yield a row with its sign, or one for each of the parts of complex sides."""
    if sign.role is Role.DEFINITION:
        value = known.settle(known.values.get(sign.letter, sp.S.Zero))
        if is_complex(value):
            parts = sp.ImmutableMatrix(_take_parts(value))
            row = replace(row, says=Definition(sign.letter, parts))
        yield row, sign
        return
    sides = [known.settle(side) for side in sign.sides if side is not None]
    if not any(map(is_complex, sides)):
        yield row, sign
        return
    for name, one, other in zip(_NAMES, *map(_take_parts, sides), strict=True):
        if one != other or one != 0:
            says = Equality(one, other, "member")
            own = replace(sign, letter=None, sides=(one, other))
            yield replace(row, number=f"{row.number}, {name}", says=says), own


def is_complex(value: Any) -> bool:
    """Return whether the imaginary unit stands in a value."""
    return isinstance(value, sp.Expr) and bool(value.has(sp.I))


def _take_parts(side: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return both parts; `NotImplementedError` where they are not found."""
    real, imaginary = sp.expand(side.replace(ValueWhere, lambda value, _: value)).as_real_imag()
    if real.has(sp.re, sp.im) or imaginary.has(sp.re, sp.im):
        raise NotImplementedError
    return real, imaginary
