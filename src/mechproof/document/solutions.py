r"""Letters printed with a double sign, T = (-F ± \sqrt{…}) / …: with both signs they are roots.

The letter, or that of whose part it is the tangent, is put into the constraints that have it.
Where it meets none, a change of one part of the print with which both signs do is a misprint.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import islice

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.document.misprints import FEW, MOST, Values, agree
from mechproof.document.slips import Change, Entry, list_alike, list_changes
from mechproof.document.witnesses import find_points
from mechproof.proof.domain import Domain
from mechproof.proof.ladder import decide
from mechproof.proof.verdict import Verdict
from mechproof.record import Conjunction, Equality

SIGN = sp.Symbol("±", real=True)
RUNG = "substitution"
_COUNT = 24


@dataclass(frozen=True)
class Solutions:
    """A letter, and what it is printed to be with both values of SIGN."""

    letter: sp.Basic
    value: sp.Expr

    @property
    def residual(self) -> sp.Expr:
        """Return what is zero where the letter has one of the two values."""
        return sp.Mul(*(self.letter - one for one in _choose(self.value)))

    def judge(
        self, given: Mapping[str, sp.Expr], domain: Domain
    ) -> tuple[Verdict, str, str] | None:
        """Judge by the first constraint that has the letter whether both values meet it.

        None if that is not shown, nor a change with which they would.
        """
        unknown, value = self._find_unknown(domain)
        alone = replace(domain, given={s: v for s, v in domain.given.items() if s != unknown})
        for name, residual in given.items():
            if unknown not in residual.free_symbols:
                continue
            rests = (residual.xreplace({unknown: one}) for one in _choose(alone.resolve(value)))
            says = Conjunction(tuple(Equality(sp.expand_trig(r), sp.S.Zero) for r in rests))
            where = (*domain.where, *_list_conditions(alone.resolve(self.value)))
            answer = decide(says, replace(domain, where=where))
            if answer.verdict is Verdict.PROVED:
                return Verdict.PROVED, RUNG, f"both signs give {unknown} of {name}, taken as given"
            if answer.verdict is not Verdict.REFUTED:
                continue
            if change := self._find_change(unknown, residual, alone):
                reason = f"{change.reason}; both signs compared with {name}"
                return Verdict.REFUTED, RUNG, reason
        return None

    def _find_unknown(self, domain: Domain) -> tuple[sp.Basic, sp.Expr]:
        """Return the letter that is put in, and its value: of T = tan(q/2) it is q."""
        return _invert(domain.given.get(self.letter), self.letter, self.value)

    def _find_change(self, unknown: sp.Basic, residual: sp.Expr, domain: Domain) -> Change | None:
        """Return a change of the print with which both signs meet a constraint at points."""
        letters = list_alike(self.value.free_symbols - {SIGN}, domain)
        met = {s for one in (residual, *letters) for s in domain.resolve(one).free_symbols}
        points = find_points([], met - {unknown}, domain, _COUNT)
        places = [
            {**point, **{s: balls.evaluate(domain.resolve(s), point) for s in letters}}
            for point in points
        ]
        own = Entry((self.value, sp.S.Zero), (True, False))
        for change in islice(list_changes(own, letters, {}), MOST):
            _, value = _invert(domain.given.get(self.letter), self.letter, change.sides[0])
            met_at = 0
            for place in places:
                holds = _holds(residual, unknown, value, place)
                if holds is False:
                    break
                met_at += bool(holds)
                if met_at >= FEW:
                    return change
        return None


def _invert(known: sp.Expr | None, letter: sp.Basic, value: sp.Expr) -> tuple[sp.Basic, sp.Expr]:
    """Return the letter of whose part another is known to be the tangent, and what it is then."""
    if isinstance(known, sp.tan) and len(known.free_symbols) == 1:
        (unknown,) = known.free_symbols
        part = known.args[0] / unknown
        if part.is_number:
            return unknown, sp.atan(value) / part
    return letter, value


def _choose(value: sp.Expr) -> list[sp.Expr]:
    return [value.xreplace({SIGN: sp.Integer(sign)}) for sign in (1, -1)]


def _list_conditions(value: sp.Expr) -> Iterator[sp.Basic]:
    """Yield what values have that have roots, and nothing below that is zero."""
    for power in value.atoms(sp.Pow):
        if power.exp.is_number and not power.exp.is_integer:
            yield sp.Ge(power.base, 0)
        if power.exp.is_negative:
            yield sp.Ne(power.base, 0)


def _holds(residual: sp.Expr, unknown: sp.Basic, value: sp.Expr, place: Values) -> bool | None:
    """Return whether both signs meet a constraint at a place, None where they have no value."""
    answers = []
    for one in _choose(value):
        try:
            there = balls.evaluate(one, place)
        except (NotImplementedError, KeyError):
            return None
        answers.append(agree((residual, sp.S.Zero), {**place, unknown: there}))
    return None if None in answers else all(answers)
