"""Numbers that equations print of letters: sizes, and results that may have been rounded."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import sympy as sp

from mechproof.document.known import Known
from mechproof.document.numbers.scales import RoundedSize, Scales
from mechproof.document.roles import Role, Sign
from mechproof.nomenclature.cells import Head, Numeral
from mechproof.record import find_last_place
from mechproof.record.units import read_unit
from mechproof.sources.displays import Printed


@dataclass(frozen=True)
class PrintedSize:
    """A size that an equation prints, in units of its letter; of one without any, in its own."""

    size: RoundedSize
    head: Head
    unit: sp.Expr
    name: str
    group: int

    def is_zero(self, group: int) -> bool:
        """Return whether a display says that the letter is zero."""
        return self.group == group and self.size.value == 0


def read_size(sign: Sign, printed: Printed, known: Known) -> PrintedSize:
    """Return the size that a sign says of its letter."""
    unit = read_unit(sign.unit) if sign.unit else None
    head = Head(sign.letter, str(sign.letter), unit)
    scales = Scales(known.symbols, [head])
    size = scales.size(head, Numeral(sign.number, sp.S.One))
    scale = scales.known.get(sign.letter, sp.S.One)
    return PrintedSize(size, head, scale, printed.name, printed.group)


def list_numbers(
    printed: Printed, signs: Sequence[Sign], known: Known
) -> Iterator[tuple[sp.Basic, PrintedSize]]:
    """Yield the letters that an equation prints a number of, as a result, in the order of print.

    Whatever rounds to the number may be meant.
    """
    letter = None
    for sign in signs:
        letter = sign.letter or letter
        if sign.role is not Role.NUMBER or not sign.number or letter not in known.values:
            continue
        one = read_size(replace(sign, letter=letter), printed, known)
        unit = Scales(known.symbols, [one.head]).convert(letter, one.head.unit)
        size = RoundedSize(one.size.value, unit * find_last_place(sign.number) / 2)
        yield letter, replace(one, size=size)
