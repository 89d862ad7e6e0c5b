"""Rung: sums of floors that repeat after a period, checked step by step; and their fractions.

A sum of multiples of floors of q*x + r, q and r rational, is constant between the places where one
of these arguments is whole, and is periodic if the multiples of q add up to zero (Graham, Knuth,
Patashnik, Concrete Mathematics, 1994, chapter 3). For a polynomial of whole numbers over m, the
difference to its floor depends only on their remainders modulo m.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise, product

import sympy as sp

from mechproof.statement_domains.domain import Domain

RUNG = "steps of floors"
# Work limit: places where a floor steps, within a period.
_MOST_STEPS = 200


def decide_by_floors(left: sp.Expr, right: sp.Expr, domain: Domain) -> str | None:
    """Return the rung if left = right at and between all steps within a period, else None."""
    difference = domain.resolve(left - right)
    # Most statements have no floors, and expanding some of them takes seconds.
    if not difference.has(sp.floor):
        return None
    difference = sp.expand(sp.expand(difference).replace(sp.floor, _take_whole_out))
    if difference == 0:
        return RUNG
    floors = sorted(difference.atoms(sp.floor), key=sp.default_sort_key)
    letters = sorted(difference.free_symbols, key=str)
    counts = {one: sp.Dummy() for one in floors}
    named = difference.xreplace(counts)
    weights = {one: sp.diff(named, count) for one, count in counts.items()}
    if not (floors and letters and all(weight.is_Rational for weight in weights.values())):
        return None
    if all(letter.is_integer for letter in letters):
        return RUNG if _is_zero_by_remainders(difference, floors, letters) else None
    if len(letters) > 1:
        return None
    (x,) = letters
    slopes = {one: sp.diff(one.args[0], x) for one in floors}
    own = sp.diff(named, x)
    numbers = [own, *slopes.values(), *(f.args[0].subs(x, 0) for f in floors)]
    if not all(number.is_Rational for number in numbers):
        return None
    period = sp.ilcm(1, *(slope.q for slope in slopes.values()))
    drift = own + sum(weights[one] * slopes[one] for one in floors)
    steps = period + sum(abs(slope) * period for slope in slopes.values())
    if drift != 0 or steps > _MOST_STEPS or own != 0:
        return None
    places = sorted({place for one in floors for place in _list_steps(one.args[0], x, period)})
    # Between two steps the difference is constant, so that any place between them will do.
    between = [(one + other) / 2 for one, other in pairwise(places)]
    left_out = _list_left_out(x, period, domain)
    met = [place for place in places if all(one.subs(x, place) != 0 for one in left_out)]
    return RUNG if all(difference.subs(x, place) == 0 for place in [*met, *between]) else None


def _take_whole_out(argument: sp.Expr) -> sp.Expr:
    """Return a floor whose argument has a constant term from 0 to below 1, plus the rest."""
    argument = sp.expand(argument)
    number, _ = argument.as_coeff_Add()
    whole = sp.floor(number) if number.is_Rational else sp.S.Zero
    return sp.floor(argument - whole) + whole


def _is_zero_by_remainders(
    difference: sp.Expr, floors: Iterable[sp.Expr], letters: list[sp.Symbol]
) -> bool:
    """Return whether a sum of multiples of floors is zero for all whole numbers."""
    arguments = {one: one.args[0] for one in floors}
    if not all(argument.is_polynomial(*letters) for argument in arguments.values()):
        return False
    polynomials = [sp.Poly(argument, *letters) for argument in arguments.values()]
    left = sp.expand(difference.xreplace(arguments))
    if not (left.is_Rational and all(p.domain in (sp.ZZ, sp.QQ) for p in polynomials)):
        return False
    period = sp.ilcm(1, *(number.q for p in polynomials for number in p.coeffs()))
    if period ** len(letters) > _MOST_STEPS:
        return False
    tried = product(range(period), repeat=len(letters))
    return all(difference.subs(dict(zip(letters, one, strict=True))) == 0 for one in tried)


def _list_left_out(x: sp.Symbol, period: int, domain: Domain) -> list[sp.Expr]:
    """List periodic expressions stated to be nonzero, as x - floor(x) is for non-integer x."""
    said = (relation.lhs - relation.rhs for relation in domain.where if isinstance(relation, sp.Ne))
    alone = (sp.expand(number) for number in said if number.free_symbols == {x})
    return [n for n in alone if n.has(sp.floor) and sp.expand(n.subs(x, x + period) - n) == 0]


def _list_steps(argument: sp.Expr, x: sp.Symbol, period: int) -> list[sp.Rational]:
    """List 0, the period, and the places within it where a linear expression is whole."""
    slope, start = sp.diff(argument, x), argument.subs(x, 0)
    ends = sorted((start, start + slope * period))
    wholes = range(int(sp.ceiling(ends[0])), int(sp.floor(ends[1])) + 1)
    steps = [(whole - start) / slope for whole in wholes] if slope else []
    return [sp.S.Zero, sp.Integer(period), *steps]


def leave_fractions(number: sp.Expr, domain: Domain) -> tuple[sp.Expr, Domain]:
    """Write floor(u) as u - t with t in [0, 1), and return the domain that includes these t.

    A letter with a lower bound is written as its floor plus t, which keeps the bound visible.
    """
    tied = {letter for relation in domain.where for letter in relation.free_symbols}
    while floors := number.atoms(sp.floor):
        one = max(floors, key=sp.default_sort_key)
        (x,), t = one.args, sp.Dummy("t", real=True)
        domain = domain.with_set(t, sp.Interval.Ropen(0, 1))
        values = domain.set_of(x) if x.is_Symbol and x not in tied else sp.S.Reals
        if isinstance(values, sp.Interval) and values.start.is_finite:
            whole = sp.Dummy(x.name, real=True)
            number = number.xreplace({one: whole}).xreplace({x: whole + t})
            domain = domain.with_set(whole, sp.Interval(sp.floor(values.start), sp.oo))
        else:
            number = number.xreplace({one: x - t})
    return number, domain
