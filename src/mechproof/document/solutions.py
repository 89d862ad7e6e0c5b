r"""Prints with a double sign on one side, T = (-F ± \sqrt{…}) / …: with both they are roots.

The letter, or that of whose part it is the tangent, is put into the constraints that have it. Where
it meets none, what is printed may have one of its two values wherever the others hold; a change of
one part of the print with which it does is a misprint.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import sympy as sp

from mechproof.document.misprints import Misprint, find_misprint
from mechproof.document.slips import Entry, Sides
from mechproof.document.special_cases import state_angles
from mechproof.proof.dimensions import Dimensions, is_angle
from mechproof.proof.domain import Domain
from mechproof.proof.ladder import decide
from mechproof.proof.verdict import Verdict
from mechproof.record import Conjunction, Equality, Statement

SIGN = sp.Symbol("±", real=True)
SUBSTITUTION = "substitution"
_PAIR = re.compile(r"(.+)_(?:\{1, ?2\}|1,2)")


def write_sign(text: str) -> str:
    """Return the text of an expression with SIGN for a factor as it is printed."""
    return text.replace("+ ±*", "± ").replace("±*", "±")


@dataclass(frozen=True)
class Solutions:
    """What is printed to have a value with both values of SIGN: mostly a letter."""

    left: sp.Expr
    value: sp.Expr

    def state(self, dimensions: Dimensions) -> Equality:
        """State that it has one of the two values, angles up to whole turns."""
        one, other = _choose(self.value)
        if is_angle((self.left, self.value), dimensions):
            # With cos a - cos b = -2 sin((a + b)/2) sin((a - b)/2).
            turned = self.left - (one + other) / 2
            return Equality(sp.cos(turned), sp.cos((one - other) / 2), "member")
        # Of the product the root in both values leaves nothing.
        total, times = (sp.cancel(sp.expand(x)) for x in (one + other, one * other))
        rest = self.left**2 - total * self.left + times
        return Equality(rest, sp.S.Zero, "member")

    def state_each(self, dimensions: Dimensions) -> list[Statement]:
        """State that it has the value with the one sign, and with the other."""
        says = [Equality(self.left, value, "member") for value in _choose(self.value)]
        if is_angle((self.left, self.value), dimensions):
            return [state_angles(one) for one in says]
        return [*says]

    def name_root(self, letters: Iterable[sp.Basic]) -> Solutions:
        """Return what is printed of both roots, x_{1,2}, as what it says of x, if that is met."""
        pair = _PAIR.fullmatch(str(self.left))
        named = [s for s in letters if pair and str(s) == pair[1]]
        return replace(self, left=named[0]) if named else self

    def find_met(self, given: Mapping[str, sp.Expr], domain: Domain) -> tuple[sp.Basic, str] | None:
        """Return the letter that is put in, and the first constraint that both values meet."""
        unknown, value = _invert(self.left, self.value, domain)
        alone = replace(domain, given={s: v for s, v in domain.given.items() if s != unknown})
        where = (*domain.where, *_list_conditions(alone.resolve(self.value)))
        value = alone.resolve(value)
        if not unknown.is_Symbol or unknown in value.free_symbols:
            return None
        for name, residual in given.items():
            if unknown not in residual.free_symbols:
                continue
            rests = (residual.xreplace({unknown: one}) for one in _choose(value))
            says = Conjunction(tuple(Equality(sp.expand_trig(r), sp.S.Zero) for r in rests))
            if decide(says, replace(domain, where=where)).verdict is Verdict.PROVED:
                return unknown, name
        return None

    def find_misprint(
        self, given: Sequence[sp.Expr], domain: Domain, printed: Collection[sp.Basic]
    ) -> Misprint | None:
        """Return a change of the print with which it has one of its values beside constraints."""

        def state(sides: Sides) -> Sides:
            says = Solutions(*sides).state(domain.dimensions)
            return says.printed, says.rebuilt

        entry = Entry((self.left, self.value), (not self.left.is_Symbol, True))
        return find_misprint(entry, given, domain, printed, state=state)


def _invert(left: sp.Expr, value: sp.Expr, domain: Domain) -> tuple[sp.Basic, sp.Expr]:
    """Return the letter of whose part a tangent is printed, or is a letter, and its value then."""
    known = domain.given.get(left, left)
    if isinstance(known, sp.tan) and len(known.free_symbols) == 1:
        (unknown,) = known.free_symbols
        part = known.args[0] / unknown
        if part.is_number:
            return unknown, sp.atan(value) / part
    return left, value


def _choose(value: sp.Expr) -> list[sp.Expr]:
    return [value.xreplace({SIGN: sp.Integer(sign)}) for sign in (1, -1)]


def _list_conditions(value: sp.Expr) -> Iterator[sp.Basic]:
    """Yield what values have that have roots, and nothing below that is zero."""
    for power in value.atoms(sp.Pow):
        if power.exp.is_number and not power.exp.is_integer:
            yield sp.Ge(power.base, 0)
        if power.exp.is_negative:
            yield sp.Ne(power.base, 0)
