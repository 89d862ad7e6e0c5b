"""Values of a set: any number of exact ones inside it, its closed ends, the special ones.

Also the check of a symbol's assumptions, which must follow from its set, or from its limits: SymPy
uses assumptions while an expression is built, so that an unjustified one cannot be taken back.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache, lru_cache, partial
from typing import Any

import sympy as sp

from mechproof.record import RecordError

COUNTS = (sp.S.Naturals, sp.S.Naturals0, sp.S.Integers)
# Values at which formulas fail that hold elsewhere: one, a half, fractions of a turn.
_SPECIAL = tuple(
    sign * value
    for value in (sp.S.One, sp.S.Half, sp.pi / 2, sp.pi, sp.pi / 3, sp.pi / 4, 2 * sp.pi)
    for sign in (1, -1)
)


@lru_cache(maxsize=4096)
def contains(where: sp.Set, value: sp.Expr) -> sp.Basic:
    """Return SymPy's answer, cached: every row asks for the same special values at every point."""
    if isinstance(where, sp.Interval) and value.is_real:
        # Interval.contains would write the relation for a dummy and then substitute the value.
        return where.as_relational(value)
    return where.contains(value)


@cache
def list_special_values(where: sp.Set) -> tuple[sp.Expr, ...]:
    """List values where formulas fail that hold at ordinary points; all of a finite set."""
    if isinstance(where, sp.FiniteSet):
        return tuple(where.args)
    ends = list_closed_ends(where)
    values = dict.fromkeys((sp.S.Zero, *_SPECIAL, *ends))
    return tuple(value for value in values if contains(where, value) == sp.true)


@lru_cache(maxsize=1024)
def radical_inverse(step: int, base: int) -> sp.Rational:
    """Return the digits of a number, mirrored at the point: an even spread over (0, 1)."""
    numerator, denominator = 0, 1
    while step:
        step, digit = divmod(step, base)
        numerator, denominator = numerator * base + digit, denominator * base
    return sp.Rational(numerator, denominator)


# Cached, as the same numbers are placed in the same sets for every row; for each set separately, as
# SymPy takes long to hash one.
@cache
def placing(where: sp.Set) -> Callable[[sp.Rational, int], sp.Expr]:
    """Return the function that places numbers in a set."""
    return lru_cache(maxsize=1024)(partial(place, where))


def place(where: sp.Set, u: sp.Rational, step: int) -> sp.Expr:
    """Map u in (0, 1) into the set; values on the whole line are spread over several turns."""
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
    """Return an end of an interval, or a rational just inside it if the end is irrational."""
    if end.is_Rational:
        return sp.Rational(end)
    return sp.Rational(int(sp.floor(end * scale)) + int(above), scale)


def list_closed_ends(where: sp.Set) -> list[sp.Rational]:
    """List the rational ends that belong to an interval."""
    if not isinstance(where, sp.Interval):
        return []
    ends = ((where.start, where.left_open), (where.end, where.right_open))
    return [sp.Rational(end) for end, is_open in ends if not is_open and end.is_Rational]


Facts = Mapping[str, bool]


@cache
def facts_of(where: sp.Set) -> Facts:
    """Return the assumptions that hold for every member of a set of real numbers."""
    told: dict[str, bool] = {"real": True}
    if where.is_subset(sp.S.Integers):
        told["integer"] = True
    if where.is_subset(sp.Interval(0, sp.oo)):
        told["nonnegative"] = True
    if where.is_subset(sp.Interval(-sp.oo, 0)):
        told["nonpositive"] = True
    if where.contains(0) == sp.false:
        told["nonzero"] = True
    facts = dict(sp.Dummy(**told).assumptions0)
    if isinstance(where, sp.FiniteSet):
        names = sp.Dummy(integer=True, positive=True, prime=True).assumptions0
        shared = {name: {getattr(member, f"is_{name}") for member in where} for name in names}
        facts |= {name: next(iter(found)) for name, found in shared.items() if len(found) == 1}
    return facts


def find_excess(symbol: Any, facts: Facts) -> list[str]:
    """Name the assumptions of a symbol that go beyond the facts."""
    told = symbol.assumptions0
    return sorted(name for name, value in told.items() if value and not facts.get(name)) + sorted(
        f"not {name}" for name, value in told.items() if not value and facts.get(name) is not False
    )


def describe_excess(excess: list[str]) -> str:
    """Return the first few results of `find_excess` as text."""
    return ", ".join(excess[:3]) + (", ..." if len(excess) > 3 else "")


@cache
def check_set(symbol: sp.Basic, where: sp.Set) -> None:
    """Refuse sets without a rule for points, and symbols whose assumptions exclude set members."""
    if not (where in COUNTS or isinstance(where, sp.Interval | sp.FiniteSet)):
        raise RecordError(
            f"{symbol} in {where}: use an Interval, a FiniteSet, Naturals or Integers"
        )
    if excess := find_excess(symbol, facts_of(where)):
        raise RecordError(
            f"{symbol} in {where}: the set does not imply all assumptions of the SymPy symbol: "
            f"{describe_excess(excess)}"
        )


@cache
def check_given(symbol: sp.Basic, definition: sp.Expr) -> None:
    """Refuse assumptions of a given symbol that SymPy does not know of its definition."""
    known = {name: getattr(definition, f"is_{name}") for name in symbol.assumptions0}
    if excess := find_excess(symbol, {**known, **facts_of(sp.S.Reals)}):
        raise RecordError(
            f"{symbol} = {definition}: declare the symbol real only, not {describe_excess(excess)}"
        )


def check_relation(relation: sp.Basic, declared: set[sp.Basic]) -> None:
    """Refuse symbols that are not declared, except indices, which run over all elements."""
    labels = {getattr(symbol, "label", symbol) for symbol in declared}
    entries = relation.atoms(sp.Indexed)
    indices = {s for entry in entries for index in entry.indices for s in index.free_symbols}
    if unknown := relation.free_symbols - entries - indices - declared - labels:
        names = ", ".join(sorted(map(str, unknown)))
        raise RecordError(f"the domain {relation}: {names} is not declared")
