"""Rung: a transcendental inequality in one variable on a closed interval, by bisection.

This is for a variable that appears both inside a sine (exponential, ...) and outside it. A strict
sign is proved by balls over subintervals. Where the function vanishes at an end of the interval, or
at 0 inside it, its sign follows from that of its derivative. This is Moore's bisection (1966), with
the derivative where no box is small enough.

Bounds near zero, |f(x)| <= b*|x|**n for |x| <= r, are proved by the Taylor coefficients of f at 0.
Those below n vanish, being rational numbers; the sum of the others and of Lagrange's remainder,
enclosed in balls over the whole range, is at most b.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp
from flint import arb, arb_series

from mechproof.arithmetic import balls
from mechproof.arithmetic.exact_series import ORDER, expand_at_zero
from mechproof.arithmetic.series import LONGEST, NAN, TaylorExpression, list_terms, working
from mechproof.proof.algebra import decide_equal
from mechproof.record.parts import has_parts
from mechproof.record.relations import find_slack
from mechproof.statement_domains.domain import Domain

BISECTION = "bisection and derivatives"
_SMOOTH = (sp.sin, sp.cos, sp.tan, sp.atan, sp.exp, sp.log, sp.erf, sp.erfc)
# Work limits: 2**7 parts of the interval, and zeros at its ends of order up to 5.
_HALVINGS = 7
_ORDERS = 5
_BITS = 128

Ends = tuple[sp.Rational, sp.Rational]


def holds_on_interval(relation: sp.Basic, domain: Domain) -> bool:
    """Return True if an inequality in one variable of a closed interval is proved."""
    slack = find_slack(relation)
    if slack is None:
        return False
    symbols = relation.free_symbols
    where = domain.set_of(next(iter(symbols))) if len(symbols) == 1 else None
    if not (isinstance(where, sp.Interval) and where.start.is_Rational and where.end.is_Rational):
        return False
    if not (_is_smooth(slack.value) and _is_mixed(slack.value)):
        return False
    ends = sp.Rational(where.start), sp.Rational(where.end)
    if slack.strict:
        return _is_positive(slack.value, ends)
    return _is_not_negative(slack.value, ends, _ORDERS)


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
    named = {f: sp.Dummy() for f in expression.atoms(sp.Function)}
    return expression.has(*named) and not expression.free_symbols.isdisjoint(
        expression.xreplace(named).free_symbols
    )


def _is_not_negative(f: sp.Expr, ends: Ends, orders: int) -> bool:
    if _is_positive(f, ends):
        return True
    low, high = ends
    if low < 0 < high:
        halves = ((low, sp.Integer(0)), (sp.Integer(0), high))
        return all(_is_not_negative(f, half, orders) for half in halves)
    if orders == 0 or not _is_finite(f, ends):
        return False
    (variable,) = f.free_symbols or {sp.Dummy()}
    slope = sp.diff(f, variable)
    return any(
        _vanishes(f, variable, end) and _is_not_negative(direction * slope, ends, orders - 1)
        for end, direction in ((low, 1), (high, -1))
    )


def _vanishes(f: sp.Expr, variable: sp.Symbol, end: sp.Rational) -> bool:
    nothing = Domain({}, (), {})
    return decide_equal(f.subs(variable, end), sp.Integer(0), nothing) is not None


def _is_positive(f: sp.Expr, ends: Ends, halvings: int = _HALVINGS) -> bool:
    ball = _enclose(f, ends)
    if ball > 0:
        return True
    # Cutting the interval does not help if the value at an end is not positive.
    if halvings == 0 or any(_enclose(f, (end, end)) <= 0 for end in ends):
        return False
    return all(_is_positive(f, half, halvings - 1) for half in _halve(ends))


def _is_finite(f: sp.Expr, ends: Ends, halvings: int = _HALVINGS) -> bool:
    if _enclose(f, ends).is_finite():
        return True
    return halvings > 0 and all(_is_finite(f, half, halvings - 1) for half in _halve(ends))


def _enclose(f: sp.Expr, ends: Ends) -> balls.Ball:
    """Enclose the values over a closed interval."""
    with balls.working_precision(_BITS):
        between = balls.to_ball(ends[0]).union(balls.to_ball(ends[1]))
    return balls.evaluate(f, dict.fromkeys(f.free_symbols, between), _BITS)


def _halve(ends: Ends) -> Iterator[Ends]:
    middle = (ends[0] + ends[1]) / 2
    yield ends[0], middle
    yield middle, ends[1]


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
    bound, power = _read_power(relation.rhs, x)
    reach = _find_reach(domain.set_of(x))
    if not power or reach is None:
        return False
    terms = expand_at_zero(value, x)
    if terms is None or any(terms[:power]):
        return False
    total = sum(abs(c) * reach ** (k - power) for k, c in enumerate(terms) if k >= power)
    rest = _enclose_remainder(value, x, reach) * balls.to_ball(reach) ** (ORDER - power)
    return bool(balls.to_ball(sp.Rational(total)) + rest <= balls.to_ball(bound))


def _read_power(side: sp.Expr, x: sp.Symbol) -> tuple[sp.Rational, int]:
    """Return b and n of b*|x|**n, with n = 0 for any other side."""
    size = sp.Symbol("size", positive=True)
    bound, rest = side.xreplace({sp.Abs(x): size, x: size}).as_coeff_Mul()
    base, power = rest.as_base_exp()
    is_power = base == size and power.is_Integer and bound.is_Rational
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
                return NAN
            sizes.append(terms[ORDER].abs_upper())
    return max(sizes)
