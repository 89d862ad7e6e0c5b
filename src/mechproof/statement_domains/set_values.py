"""Values of a set: any number of exact ones inside it, its closed ends, the special ones."""

from __future__ import annotations

from functools import cache, lru_cache

import sympy as sp

COUNTS = (sp.S.Naturals, sp.S.Naturals0, sp.S.Integers)
# Where formulas that hold at ordinary points fail: zero, one, fractions of a turn.
_SPECIAL = tuple(
    sign * value
    for value in (sp.S.One, sp.S.Half, sp.pi / 2, sp.pi, sp.pi / 3, sp.pi / 4, 2 * sp.pi)
    for sign in (1, -1)
)


@lru_cache(maxsize=4096)
def contains(where: sp.Set, value: sp.Expr) -> sp.Basic:
    """Return what SymPy says; the same special values are asked for at every point of every row."""
    return where.contains(value)


@cache
def list_special_values(where: sp.Set) -> tuple[sp.Expr, ...]:
    """List values where formulas fail that hold at ordinary points; all of a finite set."""
    if isinstance(where, sp.FiniteSet):
        return tuple(where.args)
    ends = list_closed_ends(where)
    values = dict.fromkeys((sp.S.Zero, *_SPECIAL, *ends))
    return tuple(value for value in values if contains(where, value) == sp.true)


def radical_inverse(step: int, base: int) -> sp.Rational:
    """Return the digits of a number, mirrored at the point: an even spread over (0, 1)."""
    numerator, denominator = 0, 1
    while step:
        step, digit = divmod(step, base)
        numerator, denominator = numerator * base + digit, denominator * base
    return sp.Rational(numerator, denominator)


def place(where: sp.Set, u: sp.Rational, step: int) -> sp.Expr:
    """Map u in (0, 1) into the set; the odds of the whole line are spread over several turns."""
    if where in COUNTS:
        return sp.Integer(step % 7 + (-3 if where == sp.S.Integers else 1))
    if isinstance(where, sp.Range):
        return where.inf + step % int(min(where.sup - where.inf + 1, 7))
    if isinstance(where, sp.FiniteSet):
        return where.args[step % len(where)]
    low, high = where.inf, where.sup
    if low.is_infinite and high.is_infinite:
        return (2 * u - 1) / (u * (1 - u)) if u != sp.Rational(1, 2) else sp.Rational(3, 4)
    if high.is_infinite:
        return _rational(low, above=True) + 4 * u / (1 - u)
    if low.is_infinite:
        return _rational(high, above=False) - 4 * (1 - u) / u
    for scale in (10**3, 10**9, 10**30):
        bottom, top = _rational(low, True, scale), _rational(high, False, scale)
        if bottom < top:
            return bottom + (top - bottom) * u
    raise ValueError(f"no rational point found in {where}")


def _rational(end: sp.Expr, above: bool, scale: int = 1000) -> sp.Rational:
    """Return an end of an interval, or a rational just inside it where the end is irrational."""
    if end.is_Rational:
        return sp.Rational(end)
    return sp.Rational(int(sp.floor(end * scale)) + int(above), scale)


def list_closed_ends(where: sp.Set) -> list[sp.Rational]:
    """List the rational ends that belong to an interval."""
    if not isinstance(where, sp.Interval):
        return []
    ends = ((where.start, where.left_open), (where.end, where.right_open))
    return [sp.Rational(end) for end, is_open in ends if not is_open and end.is_Rational]
