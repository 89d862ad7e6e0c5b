"""Rung: a transcendental inequality in one variable on a finite interval, by bisection.

The variable appears both inside a sine (exponential, ...) and outside it, or in nested functions. A
strict sign is proved by balls over subintervals. Where the function vanishes at an end of one, its
sign follows from that of its derivative. This is Moore's bisection (1966), with the derivative
where no box is small enough.

Bounds near zero, |f(x)| <= b*|x|**n for |x| <= r, are proved by the Taylor coefficients of f at 0.
Those below n vanish, being rational numbers; the sum of the others and of Lagrange's remainder,
enclosed in balls over the whole range, is at most b.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import sympy as sp
from flint import arb, arb_series

from mechproof.arithmetic import balls
from mechproof.arithmetic.exact_series import ORDER, expand_at_zero
from mechproof.arithmetic.series import LONGEST, TaylorExpression, list_terms, working
from mechproof.proof.algebra import decide_equal
from mechproof.proof.sign_forms import drop_signed_factors
from mechproof.record.parts import has_parts
from mechproof.record.relations import find_slack
from mechproof.statement_domains.domain import Domain

BISECTION = "bisection and derivatives"
_SMOOTH = (
    *(sp.sin, sp.cos, sp.tan, sp.atan, sp.exp, sp.log, sp.erf, sp.erfc),
    *(sp.sinh, sp.cosh, sp.tanh),
)
# Work limits: 2**7 parts of the interval, 2**3 for slopes, and zeros of order up to 7.
_HALVINGS = 7
_HALVINGS_OF_SLOPES = 3
_ORDERS = 7
_BITS = 128

Ends = tuple[sp.Expr, sp.Expr]


def holds_on_interval(relation: sp.Basic, domain: Domain) -> bool:
    """Return True if an inequality in one variable is proved between two rational numbers."""
    where = _find_interval(relation, domain)
    is_rational = where is not None and where.start.is_Rational and where.end.is_Rational
    return is_rational and holds_between(relation, domain)


def holds_between(relation: sp.Basic, domain: Domain) -> bool:
    """Return True if an inequality in one variable of a finite interval is proved."""
    where, slack = _find_interval(relation, domain), find_slack(relation)
    if where is None or slack is None:
        return False
    if not (_is_smooth(slack.value) and _is_mixed(slack.value)):
        return False
    closed = [end for end in (where.start, where.end) if end in where]
    # Factors are only dropped where the number itself does not show its sign: that takes longer.
    if _holds(slack.value, where.args[:2], slack.strict, closed):
        return True
    freed = drop_signed_factors(slack.value, domain)
    return freed != slack.value and _holds(freed, where.args[:2], slack.strict, closed)


def _find_interval(relation: sp.Basic, domain: Domain) -> sp.Interval | None:
    symbols = relation.free_symbols
    where = domain.set_of(next(iter(symbols))) if len(symbols) == 1 else None
    return where if isinstance(where, sp.Interval) and where.measure.is_finite else None


def _is_smooth(expression: sp.Expr) -> bool:
    """Return whether each function used has finite balls only where it is continuous."""
    powers = expression.atoms(sp.Pow)
    functions = expression.atoms(sp.Function)
    return (
        all(isinstance(f, _SMOOTH) for f in functions)
        and all(p.exp.is_Rational for p in powers)
        and not has_parts(expression, sp.Integral, sp.Sum, sp.Piecewise)
    )


def _is_mixed(expression: sp.Expr) -> bool:
    """Return whether the variable appears both inside a function and outside all of them."""
    functions = expression.atoms(sp.Function)
    if any(other.has(f) for f in functions for other in functions if other != f):
        return True
    named = {f: sp.Dummy() for f in functions}
    return expression.has(*named) and not expression.free_symbols.isdisjoint(
        expression.xreplace(named).free_symbols
    )


def _holds(f: sp.Expr, ends: Ends, strict: bool, closed: Sequence[sp.Expr]) -> bool:
    """Return whether f is positive, or not negative, between two ends and at the closed ones."""
    if strict and not all(_enclose(f, (end, end)) > 0 for end in closed):
        return False
    low, high = ends
    cuts = [low, sp.S.Zero, high] if (low < 0) == sp.true and (high > 0) == sp.true else [*ends]
    if strict and len(cuts) > 2 and not _enclose(f, (cuts[1], cuts[1])) > 0:
        return False
    return all(_is_above(f, part, strict, _ORDERS, _HALVINGS) for part in pairwise(cuts))


def _is_above(f: sp.Expr, ends: Ends, strict: bool, orders: int, halvings: int) -> bool:
    """Return whether f is positive between two ends, or zero at single points if not strict."""
    if _enclose(f, ends) > 0:
        return True
    if any(_enclose(f, (end, end)) < 0 for end in ends):
        return False
    if orders and _is_above_by_slope(f, ends, orders, halvings):
        return True
    middle = (ends[0] + ends[1]) / 2
    there = _enclose(f, (middle, middle))
    if halvings == 0 or (not there > 0 and (strict or not _vanishes(f, middle))):
        return False
    halves = pairwise((ends[0], middle, ends[1]))
    return all(_is_above(f, half, strict, orders, halvings - 1) for half in halves)


def _is_above_by_slope(f: sp.Expr, ends: Ends, orders: int, halvings: int) -> bool:
    """Return whether f is not negative at one end and grows from there to the other."""
    turns = zip(ends, (1, -1), strict=True)
    rising = [t for end, t in turns if _vanishes(f, end) or _enclose(f, (end, end)) > 0]
    if not f.free_symbols or not rising or not _is_finite(f, ends, halvings):
        return False
    slope = sp.diff(f, *f.free_symbols)
    fewer = min(halvings, _HALVINGS_OF_SLOPES)
    return any(_is_above(turn * slope, ends, False, orders - 1, fewer) for turn in rising)


def _vanishes(f: sp.Expr, place: sp.Expr) -> bool:
    if not _enclose(f, (place, place)).contains(0):
        return False
    at = f.subs(dict.fromkeys(f.free_symbols, place))
    return decide_equal(at, sp.Integer(0), Domain({}, (), {})) is not None


def _is_finite(f: sp.Expr, ends: Ends, halvings: int) -> bool:
    if _enclose(f, ends).is_finite():
        return True
    middle = (ends[0] + ends[1]) / 2
    halves = pairwise((ends[0], middle, ends[1]))
    return halvings > 0 and all(_is_finite(f, half, halvings - 1) for half in halves)


def _enclose(f: sp.Expr, ends: Ends) -> balls.Ball:
    """Enclose the values over a closed interval."""
    with balls.working_precision(_BITS):
        low, high = (balls.evaluate(end, {}, _BITS) for end in ends)
        between = low.union(high)
    return balls.evaluate(f, dict.fromkeys(f.free_symbols, between), _BITS)


NEAR_ZERO = "Taylor series with its remainder in balls"
BITS = 256
# Parts of the range on which the remainder is enclosed separately.
PARTS = 64


def holds_near_zero(relation: sp.Basic, domain: Domain) -> bool:
    """Return whether a relation is a bound |f(x)| <= b*|x|**n near zero and is proved."""
    if not (isinstance(relation, sp.LessThan) and isinstance(relation.lhs, sp.Abs)):
        return False
    value, symbols = relation.lhs.args[0], relation.free_symbols
    if len(symbols) != 1:
        return False
    (x,) = symbols
    where = domain.set_of(x)
    bound, power = _read_power(relation.rhs, x, where.inf >= 0)
    reach = _find_reach(where)
    if not power or reach is None:
        return False
    terms = expand_at_zero(value, x)
    if terms is None or any(terms[:power]):
        return False
    total = sum(abs(c) * reach ** (k - power) for k, c in enumerate(terms) if k >= power)
    rest = _enclose_remainder(value, x, reach) * balls.to_ball(reach) ** (ORDER - power)
    return bool(balls.to_ball(sp.Rational(total)) + rest <= balls.to_ball(bound))


def _read_power(side: sp.Expr, x: sp.Symbol, is_size: bool) -> tuple[sp.Rational, int]:
    """Return b and n of b*|x|**n, with n = 0 for any other side. `is_size`: x is not negative."""
    size = sp.Symbol("size", positive=True)
    sized = side.xreplace({sp.Abs(x): size})
    is_even = sized.subs(x, -x) == sized
    bound, rest = sized.subs(x, size).as_coeff_Mul()
    base, power = rest.as_base_exp()
    is_power = base == size and power.is_Integer and bound.is_Rational and (is_size or is_even)
    return (bound, int(power)) if is_power else (bound, 0)


def _find_reach(values: sp.Set) -> sp.Rational | None:
    """Return the largest modulus in an interval with rational ends, or None for other sets."""
    ends = (values.inf, values.sup) if isinstance(values, sp.Interval) else ()
    return max(map(abs, ends)) if ends and all(end.is_Rational for end in ends) else None


def _enclose_remainder(value: sp.Expr, x: sp.Symbol, reach: sp.Rational) -> arb:
    """Bound the Taylor coefficient of the remainder, that of order `ORDER`, over the range."""
    expression = TaylorExpression(value, x, {}, {})
    sizes: list[arb] = []
    assert ORDER < LONGEST
    with working(ORDER + 1, BITS):
        half = balls.to_ball(reach / PARTS)
        for part in range(PARTS):
            middle = balls.to_ball(reach * sp.Rational(2 * part + 1 - PARTS, PARTS))
            place = arb_series([middle + half * arb(0, 1), 1])
            terms = list_terms(expression.expand(place))
            # NaN, as infinite balls cannot be compared with numbers.
            if not all(term.is_finite() for term in terms):
                return balls.NOT_FINITE
            sizes.append(terms[ORDER].abs_upper())
    return max(sizes)
