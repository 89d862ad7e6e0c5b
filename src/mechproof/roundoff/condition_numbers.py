"""Condition numbers: by what share of a scale an output moves with a step moved by a share.

Of products and quotients they are 1 and -1, and a sum has each term once: carried from the output
back to a step (Bauer 1974), they lose nothing to how wide a box is where only these are passed. A
slope, a value and the inverse of a scale over a box do, each of which is known to a box apart.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import sympy as sp

from mechproof.arithmetic.intervals import EPS, ONE, Ends, Interval, around, exactly
from mechproof.programs.operations import SYMBOLIC
from mechproof.programs.program import Operand
from mechproof.roundoff.interval_monomials import IntervalMonomial
from mechproof.roundoff.rules import SOME
from mechproof.roundoff.steps import CHOICE

SUMS = ("add", "subtract", "fma")
# Which operand is taken may not be known: by that it is 1, by the other 0.
CHOICES = ("maximum", "minimum", CHOICE)


class CarriedConditions:
    """The condition numbers of an output by the steps that are still to be passed, scale by scale.

    `starts` are those by the output itself.
    """

    def __init__(self, output: Operand, starts: Sequence[Interval]) -> None:
        self._known: dict[Operand, list[Interval]] = {output: list(starts)}

    def take(self, result: Operand, others: Sequence[Interval]) -> list[Interval]:
        """Return those by a step, of which others are known besides."""
        known = self._known.pop(result, None)
        if known is None:
            return list(others)
        return [one.intersection(other) for one, other in zip(known, others, strict=True)]

    def carry(
        self,
        conditions: Sequence[Interval],
        moved: Ends,
        operands: Sequence[Operand],
        numbers: Sequence[Interval | None],
    ) -> None:
        """Pass a step, by which the output has these and which has its own by its operands.

        By its own rounding it is moved by at most a share.
        """
        own = around(1.0, moved * (1 + 4 * EPS))
        for operand, number in zip(operands, numbers, strict=True):
            if number is None or not isinstance(operand, str):
                continue
            parts = [condition * number * own for condition in conditions]
            known = self._known.get(operand)
            self._known[operand] = (
                [a + b for a, b in zip(known, parts, strict=True)] if known else parts
            )


def find_condition_numbers(
    kind: str,
    given: Sequence[IntervalMonomial],
    exact: IntervalMonomial,
    slopes: Sequence[IntervalMonomial | None],
) -> list[Interval | None]:
    """Return those of a step by its operands; None where it does not move with one."""
    if kind in CHOICES:
        return [None if slope is None else SOME for slope in slopes]
    if powers := _find_powers(kind, len(given)):
        return [exactly(power) for power in powers]
    found = [
        None if slope is None else (slope * operand / exact).expanded()
        for slope, operand in zip(slopes, given, strict=True)
    ]
    if kind not in SUMS:
        return found
    *factors, last = given
    first = factors[0] * factors[1] if kind == "fma" else factors[0]
    last = -last if kind == "subtract" else last
    shares = [*[_find_share(first, last)] * len(factors), _find_share(last, first)]
    return [
        None if one is None else one.intersection(share)
        for one, share in zip(found, shares, strict=True)
    ]


@cache
def _find_powers(kind: str, count: int) -> tuple[float, ...]:
    """Return the exponents of the operands of what is a product of powers; nothing for others."""
    letters = [sp.Dummy(positive=True) for _ in range(count)]
    meaning = SYMBOLIC[kind](*letters)
    if not isinstance(meaning, sp.Expr):
        return ()
    numbers = [sp.cancel(letter * meaning.diff(letter) / meaning) for letter in letters]
    is_power = all(n.is_Rational and sp.Rational(float(n)) == n for n in numbers)
    return tuple(map(float, numbers)) if is_power else ()


def _find_share(term: IntervalMonomial, other: IntervalMonomial) -> Interval:
    """Return a term's share of a sum."""
    # The one is finite where the term does not vanish, the other where the rest of the sum does
    # not.
    of_rest = (ONE + (other / term).expanded()).inverted()
    return of_rest.intersection(ONE - (ONE + (term / other).expanded()).inverted())
