r"""Prints that say two things: with a double sign, or of plane vectors as complex numbers.

a\mathrm{e}^{j\varphi} stands for two equations, of real and imaginary parts: all letters are real
except those to which an earlier equation gives a complex value. An equation said to follow from
others defines no letter unless it is a chain, and a print with a double sign defines none.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from mechproof.document.constraints.solutions import SIGN, read_signs
from mechproof.document.known import Known
from mechproof.document.printed_signs import find_roles
from mechproof.document.tasks import Role, Sign
from mechproof.latex import Reader
from mechproof.latex.latex_signs import DOUBLE
from mechproof.latex.matrix_meaning import is_matrix
from mechproof.latex.reader import Print
from mechproof.nomenclature.shown_letters import name_symbol
from mechproof.record import Definition, Equality, Row
from mechproof.sources.displays import Printed
from mechproof.statement_domains.preparation import take_values

# Roles that a print with a double sign may have.
_SOLVED = (Role.DEFINITION, Role.REPEATED, Role.CONSTRAINT)
# Fields of a sign that say which number a letter has.
_COUNTED = ("letter", "number", "value", "unit")
# The two letters x_1 and x_2, by the name of x_{1,2}, which is printed for both.
Pairs = Mapping[str, Sequence[str]]
_COMMAND = re.compile(r"\\[A-Za-z]+")
_EXPONENTIAL = re.compile(r"e\s*\}?\s*\^\s*\{\s*[-+]?\s*([ij])(?!\s*[_}])")
# An upright i or j that begins a term, a side or an exponent is no index.
_UPRIGHT = re.compile(
    r"(?:\A|[-+=(&]|(?<![_^])\^\s*\{)\s*(?:\\mathrm|\{\\rm)\s*\{?\s*(?P<unit>[ij])\s*\}"
)
_NAMES = ("real part", "imaginary part")


def find_following(name: str, read: Print, known: Known) -> list[Sign]:
    """Return the signs of an equation said to follow from others, with definitions as constraints.

    If a chain defines a letter, it does so here, too: only its further members follow.
    """
    signs = find_roles(name, read, known.copy())
    if len(signs) > 1 and signs[0].role is Role.DEFINITION:
        return find_roles(name, read, known)
    return [replace(s, role=Role.CONSTRAINT) if s.role is Role.DEFINITION else s for s in signs]


def find_double_signs(
    printed: Printed, read: Print, reader: Reader, known: Known, pairs: Pairs
) -> list[Sign]:
    """Return the signs of a print with a double sign.

    Raises `ReadingError` if such a print would define a letter.
    """
    own = known.copy()
    signs = find_roles(printed.name, read, own)
    if solved := _find_solutions(printed, reader, known, pairs):
        if own.has_either_sign(signs[0].letter):
            upper = {name: getattr(signs[0], name) for name in _COUNTED}
            solved[0] = replace(solved[0], **upper)
        return solved
    double = DOUBLE.search(printed.latex.string)
    if double and any(sign.role in (Role.DEFINITION, Role.REPEATED) for sign in signs):
        raise read.source.refuse(
            double.start(),
            "a double sign in the definition of a letter: both signs, or either?",
            r"Declare branch \sigma=\pm1 in the block of letters.",
        )
    return signs


def _find_solutions(printed: Printed, reader: Reader, known: Known, pairs: Pairs) -> list[Sign]:
    """Return a print's signs if only one side has a double sign, read as a letter; else none."""
    read = read_signs(reader).parse(printed.latex.string)
    own = known.copy()
    sign, *steps = find_roles(printed.name, read, own)
    if sign.role not in _SOLVED or any(step.role is not Role.STEP for step in steps):
        return []
    if sign.role is Role.DEFINITION:
        if sign.letter not in own.values:
            # A definition for one range only gives the letter no value.
            return []
        sign = replace(sign, sides=(sign.letter, own.values[sign.letter]))
    sides = sorted(sign.sides, key=lambda side: side.has(SIGN))
    is_one_sided = [side.has(SIGN) for side in sides] == [False, True]
    if is_one_sided and any(map(is_complex, sides)):
        raise read.source.refuse(
            next(DOUBLE.finditer(printed.latex.string)).start(),
            "a double sign next to the imaginary unit: which of the two numbers is the letter?",
            "Print them one by one, as separate letters.",
        )
    if not is_one_sided or any(map(is_matrix, sides)):
        return []
    halves = _find_halves(sides[0], sides[1], known, pairs)
    # Later rows about either letter refer to what is printed for both.
    known.met.update(halves)
    solved = replace(sign, role=Role.SOLUTIONS, sides=tuple(sides), number="", halves=halves)
    return [solved, *steps]


def _find_halves(left: sp.Expr, value: sp.Expr, known: Known, pairs: Pairs) -> tuple[sp.Basic, ...]:
    """Return x_1 and x_2 for a printed x_{1,2}; nothing if the value has such letters as well."""
    letter = name_symbol(str(left.as_base_exp()[0]))
    is_any = any(name_symbol(str(s)) in pairs for s in value.free_symbols)
    names = known.symbols.names
    return () if is_any else tuple(names[x] for x in pairs.get(letter, ()))


def find_imaginary_unit(prints: Iterable[str]) -> str:
    r"""Return the letter of the imaginary unit, as e^{j\varphi} shows it; "" if none does."""
    prints = list(prints)
    if upright := next(filter(None, map(_UPRIGHT.search, prints)), None):
        return rf"\mathrm{{{upright['unit']}}}"
    found = (_EXPONENTIAL.search(_COMMAND.sub("x", latex)) for latex in prints)
    return next((match[1] for match in found if match), "")


def split_parts(row: Row, sign: Sign, known: Known) -> Iterator[tuple[Row, Sign]]:
    """Yield a row with its sign, or a row each for the real and imaginary parts of its sides."""
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
    """Return whether a value contains the imaginary unit."""
    return isinstance(value, sp.Expr) and bool(value.has(sp.I))


def _take_parts(side: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return the real and imaginary parts; raises `NotImplementedError` if they are not found."""
    real, imaginary = sp.expand(take_values(side)).as_real_imag()
    if real.has(sp.re, sp.im) or imaginary.has(sp.re, sp.im):
        raise NotImplementedError
    return real, imaginary
