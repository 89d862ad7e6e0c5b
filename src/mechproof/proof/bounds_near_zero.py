"""Bounds near zero: |f(x)| <= b*|x|**n for |x| <= r, by the Taylor coefficients of f at zero.

Those below n vanish, being rational numbers; the others, and Lagrange's remainder in balls over the
whole range, add up to b at most.
"""

from __future__ import annotations

import sympy as sp
from flint import arb, arb_series, fmpq

from mechproof.arithmetic.exact_series import ORDER, expand_at_zero
from mechproof.arithmetic.series import LONGEST, NAN, TaylorExpression, list_terms, working
from mechproof.statement_domains.domain import Domain

RUNG = "Taylor series with its remainder in balls"
BITS = 256
# The remainder is enclosed on so many parts of the range.
PARTS = 64


def holds_near_zero(relation: sp.Basic, domain: Domain) -> bool:
    """Tell whether a relation is such a bound, and true."""
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
    rest = _enclose_remainder(value, x, reach) * _ball(reach) ** (ORDER - power)
    return bool(_ball(sp.Rational(total)) + rest <= _ball(bound))


def _read_power(side: sp.Expr, x: sp.Symbol) -> tuple[sp.Rational, int]:
    """Return b and n of b*|x|**n, n = 0 for what is none."""
    size = sp.Symbol("size", positive=True)
    bound, rest = side.xreplace({sp.Abs(x): size, x: size}).as_coeff_Mul()
    base, power = rest.as_base_exp()
    is_power = base == size and power.is_Integer and bound.is_Rational
    return (bound, int(power)) if is_power else (bound, 0)


def _find_reach(values: sp.Set) -> sp.Rational | None:
    """Return the largest size in a bounded interval with rational ends."""
    ends = (values.inf, values.sup) if isinstance(values, sp.Interval) else ()
    return max(map(abs, ends)) if ends and all(end.is_Rational for end in ends) else None


def _enclose_remainder(value: sp.Expr, x: sp.Symbol, reach: sp.Rational) -> arb:
    """Bound the coefficient after the last one at every place of the range."""
    expression = TaylorExpression(value, x, {}, {})
    sizes: list[arb] = []
    assert ORDER < LONGEST
    with working(ORDER + 1, BITS):
        half = _ball(reach / PARTS)
        for part in range(PARTS):
            middle = _ball(reach * sp.Rational(2 * part + 1 - PARTS, PARTS))
            place = arb_series([middle + half * arb(0, 1), 1])
            terms = list_terms(expression.expand(place))
            # What is not finite is in no order with numbers.
            if not all(term.is_finite() for term in terms):
                return NAN
            sizes.append(terms[ORDER].abs_upper())
    return max(sizes)


def _ball(number: sp.Rational) -> arb:
    return arb(fmpq(int(number.p), int(number.q)))
