"""Rung: an inequality by the slope of the difference of its sides.

f >= 0 on an interval if f >= 0 at a place from which f grows to both sides, or at both ends of it
where f is concave. The sign of a slope is shown as that of any other number, or again by its own
slope; f is shown to be continuous, and its slope exists inside.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from mechproof.proof.algebra import decide_equal
from mechproof.proof.continuity import find_break
from mechproof.proof.domain import Domain
from mechproof.proof.half_angles import (
    find_sign_there,
    is_negative_somewhere,
    is_shown_there,
)
from mechproof.record import Slack
from mechproof.record.parts import has_parts

RUNG = "monotonicity"
_KINKED = (sp.Abs, sp.Max, sp.Min, sp.sign, sp.floor, sp.ceiling, sp.Piecewise, sp.Heaviside)
_TRANSCENDENTAL = (
    *(sp.exp, sp.log, sp.sin, sp.cos, sp.tan, sp.asin, sp.acos, sp.atan, sp.erf),
    *(sp.sinh, sp.cosh, sp.tanh, sp.asinh, sp.acosh, sp.atanh),
)
_PLACES = (sp.S.Zero, sp.S.One, -sp.S.One)
# Work limits: slopes of slopes, operations of a slope, and variables that are tried.
_MOST_SLOPES = 3
_LARGEST = 60
_MOST_VARIABLES = 2


def holds_by_slope(slack: Slack, domain: Domain) -> bool:
    """Tell whether a number is shown to be positive, or not negative, by its slope."""
    value = domain.resolve(slack.value)
    if has_parts(value, *_KINKED, sp.Sum, sp.Product, sp.Integral):
        return False
    powers = {p for p in value.atoms(sp.Pow) if not p.exp.is_Rational}
    nodes = {*value.atoms(*_TRANSCENDENTAL), *powers}
    coupled = {s for relation in domain.where for s in relation.free_symbols}
    symbols = {s for node in nodes for s in node.free_symbols} - coupled
    runs = sorted((s for s in symbols if isinstance(domain.set_of(s), sp.Interval)), key=str)
    return any(
        _holds(number, x, slack.strict, domain, _MOST_SLOPES)
        for x in runs[:_MOST_VARIABLES]
        for number in (value, *_multiply_out(value, domain))
    )


def _multiply_out(value: sp.Expr, domain: Domain) -> Iterator[sp.Expr]:
    """Yield a quotient times what is below it, or its opposite, if that is positive."""
    above, below = sp.fraction(sp.together(value))
    sign = find_sign_there(below, domain) if below.free_symbols else None
    if sign is not None and sign.strict:
        yield sign.direction * above


def _holds(f: sp.Expr, x: sp.Symbol, strict: bool, domain: Domain, slopes: int) -> bool:
    if _is_shown(f, strict, domain):
        return True
    if not slopes or not f.has(x) or f.count_ops() > _LARGEST:
        return False
    if is_negative_somewhere(f, domain):
        return False
    slope = sp.factor_terms(sp.together(sp.diff(f, x)))
    if any(
        all(
            _holds(direction * slope, x, is_strict, part, slopes - 1)
            for direction, is_strict, part in parts
        )
        for parts in _list_ways(f, x, strict, domain)
    ):
        return True
    return _is_concave(f, slope, x, strict, domain, slopes)


def _is_shown(value: sp.Expr, strict: bool, domain: Domain) -> bool:
    value = sp.factor_terms(value)
    if is_shown_there(Slack(value, strict), domain):
        return True
    return not strict and decide_equal(value, sp.S.Zero, domain) is not None


_Way = list[tuple[sp.Integer, bool, Domain]]


def _list_ways(f: sp.Expr, x: sp.Symbol, strict: bool, domain: Domain) -> Iterator[_Way]:
    """Yield what must grow, and where, for f to be at least what it is at one place."""
    values = domain.set_of(x)
    ends = [end for end in (values.start, values.end) if end.is_finite]
    places = [*ends, *(p for p in _PLACES if values.interior.contains(p) == sp.true)]
    for place in dict.fromkeys(places):
        closed = sp.Union(values, sp.FiniteSet(place))
        if not isinstance(closed, sp.Interval):
            continue
        if find_break(f, x, domain.with_set(x, closed)) is not None:
            continue
        there = f.subs(x, place)
        is_left_out = values.contains(place) == sp.false
        is_above = _is_shown(there, strict, _without(domain, x))
        if not is_above and not (
            strict and is_left_out and _is_shown(there, False, _without(domain, x))
        ):
            continue
        needs_growth = not is_above
        sides = ((sp.Integer(-1), values.start, place), (sp.Integer(1), place, values.end))
        yield [
            (direction, needs_growth, domain.with_set(x, sp.Interval.open(low, high)))
            for direction, low, high in sides
            if (low < high) == sp.true
        ]


def _is_concave(
    f: sp.Expr, slope: sp.Expr, x: sp.Symbol, strict: bool, domain: Domain, slopes: int
) -> bool:
    """Tell whether f is shown to be concave between two ends at which it is not negative."""
    values = domain.set_of(x)
    low, high = values.start, values.end
    if strict or not (low.is_finite and high.is_finite):
        return False
    if find_break(f, x, domain.with_set(x, sp.Interval(low, high))) is not None:
        return False
    if not all(_is_shown(f.subs(x, end), False, _without(domain, x)) for end in (low, high)):
        return False
    inside = domain.with_set(x, sp.Interval.open(low, high))
    return _holds(-sp.diff(slope, x), x, False, inside, min(slopes - 1, 1))


def _without(domain: Domain, x: sp.Symbol) -> Domain:
    return replace(domain, within={s: v for s, v in domain.within.items() if s != x})
