"""Signs of rational expressions in sines, cosines and exponentials over given ranges.

Every angle is an integer multiple of a base angle, whose half has a tangent: while the angle stays
within one turn, its tangent runs over an interval. Exponentials and hyperbolic functions are powers
of one positive number. That leaves the sign of a quotient of polynomials (`signs`), which Sturm's
theorem decides for one variable. The substitution is the one that integrates rational functions of
sines and cosines; here the half turn, which no tangent reaches, is examined separately.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from math import lcm

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.proof.coordinates import (
    BY_SINES,
    HYPERBOLIC,
    list_terms,
    write_by_exponentials,
)
from mechproof.proof.polynomial_signs import StrictSign
from mechproof.proof.signs import find_sign, is_positive, is_workable, multiply_signs
from mechproof.record import RecordError, Root, Slack
from mechproof.record.parts import CIRCULAR, INVERSES, has_parts
from mechproof.statement_domains.domain import Domain

# Monotonic functions, and the intervals of their values.
_RANGES: Mapping[type[sp.Basic], sp.Interval] = {
    **{kind: values for kind, (_, values) in INVERSES.items()},
    sp.erf: sp.Interval.open(-1, 1),
    sp.log: sp.Interval(-sp.oo, sp.oo),
}
_PLACES = (sp.S.Zero, sp.S.One, -sp.S.One)
# Work limits: the largest multiple of a base angle, and the number of base angles.
_MOST_TIMES = 12
_MOST_ANGLES = 3
# Work limits: symbols and operations of an expression.
_MOST_SYMBOLS = 4
_LARGEST = 80
# Points at which a sign is refuted before a proof is tried.
_TRIED = 6


def is_negative_somewhere(value: sp.Expr, domain: Domain) -> bool:
    """Return whether a number is negative at one of a few points, before a proof is tried."""
    value = domain.resolve(value)
    try:
        points = domain.points(sorted(value.free_symbols, key=str), _TRIED)[: 2 * _TRIED]
    except RecordError:
        return False
    return any(balls.evaluate(value, point) < 0 for point in points)


def find_sign_in_half_angles(expression: sp.Expr, domain: Domain) -> StrictSign | None:
    """Return the proved sign of an expression on a domain, or None if it is not shown."""
    expression = domain.resolve(expression)
    if not has_parts(expression, *CIRCULAR, *HYPERBOLIC, sp.exp, *_RANGES):
        return None
    if has_parts(expression, sp.Sum, sp.Integral, Root) or not is_workable(expression):
        return None
    if len(expression.free_symbols) > _MOST_SYMBOLS or expression.count_ops() > _LARGEST:
        return None
    named, within = _name_ranges(expression, domain)
    domain = replace(domain, within={**domain.within, **within})
    named, within = _write_exponentials(named, domain)
    domain = replace(domain, within={**domain.within, **within})
    bases = _find_bases(named)
    if bases is None or len(bases) > _MOST_ANGLES:
        return None
    return _find_sign(named, sorted(bases.items(), key=lambda item: str(item[0])), domain)


def find_sign_there(expression: sp.Expr, domain: Domain) -> StrictSign | None:
    """Return the sign proved in positive coordinates, half-angle tangents, powers or factors."""
    found = None
    for find in (find_sign, find_sign_in_half_angles, _find_sign_of_powers, _find_sign_of_factors):
        sign = find(expression, domain)
        if sign is not None and sign.strict:
            return sign
        found = sign or found
    return found


def _find_sign_of_factors(expression: sp.Expr, domain: Domain) -> StrictSign | None:
    """Return the sign of a product, each of whose factors is proved in its own way."""
    expression = domain.resolve(expression)
    if has_parts(expression, sp.Sum, sp.Integral, Root) or not is_workable(expression):
        return None
    if expression.count_ops() > _LARGEST:
        return None
    if len(sp.Mul.make_args(factored := sp.factor(expression))) < 2:
        return None
    return multiply_signs(factored, lambda base: find_sign_there(base, domain))


def _find_sign_of_powers(expression: sp.Expr, domain: Domain) -> StrictSign | None:
    """Return the sign of a sum of powers of non-negative numbers; strict if not all are zero."""
    powers = [term.as_base_exp() for term in sp.Add.make_args(domain.resolve(expression))]
    if len(powers) < 2 or all(exponent.is_Integer for _, exponent in powers):
        return None
    if not all(is_positive(exponent, domain) for _, exponent in powers):
        return None
    if not all(is_shown_there(Slack(base, False), domain) for base, _ in powers):
        return None
    squares = sp.Add(*(base**2 for base, _ in powers))
    return StrictSign(1, is_shown_there(Slack(squares, True), domain))


def is_shown_there(slack: Slack, domain: Domain) -> bool:
    """Return whether `find_sign_there` shows a slack positive, or non-negative if not strict."""
    sign = find_sign_there(slack.value, domain)
    return sign is not None and sign.is_above(slack.strict)


def _name_ranges(
    expression: sp.Expr, domain: Domain
) -> tuple[sp.Expr, dict[sp.Basic, sp.Interval]]:
    """Replace functions of which only the range is known by variables with that range."""
    nodes = sorted(expression.atoms(*_RANGES), key=sp.default_sort_key)
    outer = [n for n in nodes if not any(n != o and o.has(n) for o in nodes)]
    named: dict[sp.Basic, sp.Symbol] = {}
    within: dict[sp.Basic, sp.Interval] = {}
    for node in outer:
        named[node] = sp.Dummy("f", real=True)
        within[named[node]] = _find_range(node, domain)
    return expression.xreplace(named), within


def _find_range(node: sp.Expr, domain: Domain) -> sp.Interval:
    """Return the range of a monotonic function's values, given what is known of its argument."""
    (argument,) = node.args
    values = _RANGES[type(node)]
    direction = -1 if isinstance(node, sp.acos) else 1
    for place in _list_places(argument, domain):
        there = node.func(place)
        if not (there.is_number and there.is_extended_real):
            continue
        sign = find_sign_there(argument - place, domain)
        if sign is not None:
            above = sp.Interval(there, sp.oo, left_open=sign.strict)
            below = sp.Interval(-sp.oo, there, right_open=sign.strict)
            values = values.intersect(above if sign.direction * direction > 0 else below)
    return values


def _list_places(argument: sp.Expr, domain: Domain) -> list[sp.Expr]:
    """List numbers to compare an argument with: finite ends of its set and a few usual ones."""
    values = domain.set_of(argument) if argument.is_Symbol else sp.S.Reals
    ends = (values.start, values.end) if isinstance(values, sp.Interval) else ()
    return [*(end for end in ends if end.is_finite), *_PLACES]


def _write_exponentials(
    expression: sp.Expr, domain: Domain
) -> tuple[sp.Expr, dict[sp.Basic, sp.Interval]]:
    """Write exponentials as powers of positive variables; also return the variables' sets."""
    expression = write_by_exponentials(expression)
    denominators: dict[sp.Expr, int] = {}
    nodes = sorted(expression.atoms(sp.exp), key=sp.default_sort_key)
    for node in nodes:
        for monomial, factor in list_terms(node.args[0]):
            denominators[monomial] = lcm(denominators.get(monomial, 1), int(factor.q))
    bases = {m: sp.Dummy("E", positive=True) for m in denominators}
    powers = {
        node: sp.Mul(*(bases[m] ** (f * denominators[m]) for m, f in list_terms(node.args[0])))
        for node in nodes
    }
    within = {base: _exponentiate(monomial, domain) for monomial, base in bases.items()}
    return expression.xreplace(powers), within


def _exponentiate(monomial: sp.Expr, domain: Domain) -> sp.Interval:
    """Return the range of exp of a monomial's fraction: above or below one, if that is known."""
    sign = find_sign(monomial, domain)
    if sign is None:
        return sp.Interval.open(0, sp.oo)
    if sign.direction > 0:
        return sp.Interval(1, sp.oo, left_open=sign.strict)
    return sp.Interval(0, 1, left_open=True, right_open=sign.strict)


def _find_bases(expression: sp.Expr) -> dict[sp.Expr, int] | None:
    """Return the angles' monomials with their denominators, or None if multiples are too large."""
    bases: dict[sp.Expr, int] = {}
    largest: dict[sp.Expr, sp.Rational] = {}
    for node in expression.atoms(*CIRCULAR):
        for monomial, factor in list_terms(node.args[0]):
            if monomial.is_number:
                continue
            bases[monomial] = lcm(bases.get(monomial, 1), int(factor.q))
            largest[monomial] = max(largest.get(monomial, sp.S.Zero), abs(factor))
    if any(largest[m] * bases[m] > _MOST_TIMES for m in bases):
        return None
    return bases


def _find_sign(
    expression: sp.Expr, bases: list[tuple[sp.Expr, int]], domain: Domain
) -> StrictSign | None:
    """Replace one base angle by the tangent of its half, then recurse for the others."""
    if not bases:
        return None if expression.has(*CIRCULAR) else find_sign(expression, domain)
    (monomial, denominator), *others = bases
    values = _find_values(monomial, domain)
    centre, run = _center(values, denominator)
    angle, tangent = sp.Dummy("u", real=True), sp.Dummy("t", real=True)
    base = denominator * (angle + centre)
    turned = expression.replace(
        lambda node: isinstance(node, CIRCULAR) and node.has(monomial),
        lambda node: _expand(node, monomial, base),
    )
    square = tangent**2
    halves = {sp.sin(angle): 2 * tangent / (1 + square)}
    halves[sp.cos(angle)] = (1 - square) / (1 + square)
    within = {**domain.within, tangent: _list_tangents(run)}
    sign = _find_sign(turned.xreplace(halves), others, replace(domain, within=within))
    if sign is None or sp.true not in (run.contains(sp.pi), run.contains(-sp.pi)):
        return sign
    return _extend(sign, turned.xreplace({sp.sin(angle): 0, sp.cos(angle): -1}), others, domain)


def _find_values(monomial: sp.Expr, domain: Domain) -> sp.Set:
    """Return the set of a symbol, or of a positive number times a symbol."""
    factor, symbol = monomial.as_independent(*monomial.free_symbols, as_Add=False)
    values = domain.set_of(symbol) if symbol.is_Symbol else sp.S.Reals
    if factor == 1 or not (isinstance(values, sp.Interval) and factor.is_positive):
        return values if factor == 1 else sp.S.Reals
    return sp.Interval(factor * values.start, factor * values.end, *values.args[2:])


def _center(values: sp.Set, denominator: int) -> tuple[sp.Expr, sp.Interval]:
    """Return a centre of the base angle and its interval about it, at most a whole turn."""
    if isinstance(values, sp.Interval) and values.start.is_finite and values.end.is_finite:
        ends = [end / denominator for end in values.args[:2]]
        # Shifts by quarter turns only swap sines and cosines or change their signs.
        centre = sp.pi / 2 * sp.floor((ends[0] + ends[1]) / sp.pi + sp.S.Half)
        low, high = (end - centre for end in ends)
        if (low >= -sp.pi) == sp.true and (high <= sp.pi) == sp.true:
            return centre, sp.Interval(low, high, *values.args[2:])
    return sp.S.Zero, sp.Interval(-sp.pi, sp.pi)


def _expand(node: sp.Expr, monomial: sp.Expr, base: sp.Expr) -> sp.Expr:
    """Write a function of multiples of the base angle by the base angle's sine and cosine."""
    argument = sp.expand(sp.expand(node.args[0]).subs(monomial, base))
    return sp.expand_trig(BY_SINES[node.func](sp.sin(argument), sp.cos(argument)))


def _list_tangents(run: sp.Interval) -> sp.Interval:
    """Return the interval of the half-angle tangent; at a half turn it is infinite."""
    low = -sp.oo if run.start == -sp.pi else sp.tan(run.start / 2)
    high = sp.oo if run.end == sp.pi else sp.tan(run.end / 2)
    return sp.Interval(low, high, run.left_open, run.right_open)


def _extend(
    sign: StrictSign, there: sp.Expr, others: list[tuple[sp.Expr, int]], domain: Domain
) -> StrictSign:
    """Return the sign with the half turn included, where the expression may be zero."""
    if not sign.strict or there.has(sp.nan, sp.zoo):
        return sign
    at_half_turn = _find_sign(there, others, domain)
    is_strict = at_half_turn is not None and at_half_turn.strict
    return StrictSign(sign.direction, is_strict)
