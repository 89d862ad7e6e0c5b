"""Sums that vanish at zero faster than their terms: near zero by their Taylor polynomials.

No identity rids tan x - x of its difference. Below a limit the value is a polynomial that is off by
less than a rounding, as the prover shows; beyond the limit few digits cancel.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import sympy as sp

from mechproof.arithmetic.exact_series import ORDER, expand_at_zero
from mechproof.programs.evaluation import Enclosure, Evaluation, Step

# The largest error of the polynomial as a share of its first term, and the most terms it may have.
PART, MOST_TERMS = sp.Rational(1, 2**56), 20
# A polynomial is used up to the first of these limits for which its terms suffice.
LIMITS = (sp.Integer(2), sp.Integer(1), sp.Rational(1, 2), sp.Rational(1, 4), sp.Rational(1, 8))


def taylor(evaluation: Evaluation) -> Evaluation:
    """Rewrite sums in one input whose leading terms cancel at 0 to a polynomial near 0.

    Not exact: a row of the ledger states that the error is within `PART` of its first term.
    """
    steps: list[Step] = []
    enclosures: list[Enclosure] = []

    def convert(total: sp.Expr) -> sp.Expr:
        symbols = total.free_symbols & evaluation.inputs
        if not (total.is_Add and len(total.free_symbols) == len(symbols) == 1):
            return total.func(*map(convert, total.args)) if total.args else total
        (x,) = symbols
        found = _choose_polynomial(total, x)
        if found is None:
            return total.func(*map(convert, total.args))
        limit, terms = found
        first = next(k for k, c in enumerate(terms) if c)
        bound = PART * abs(terms[first]) * sp.Abs(x) ** first
        enclosure = Enclosure(evaluation.new_symbol("value", steps), total, x, limit, bound)
        near = evaluation.add_step("near", sp.Piecewise((x, enclosure.inside), (0, True)), steps)
        polynomial = _nest(terms, near, partial(evaluation.add_step, "part", steps=steps))
        value = sp.Piecewise((polynomial, enclosure.inside), (total, True))
        steps.append((enclosure.step, value))
        enclosures.append(enclosure)
        return enclosure.step

    return evaluation.transform(convert, steps).enclose(enclosures)


def _choose_polynomial(total: sp.Add, x: sp.Symbol) -> tuple[sp.Rational, list[sp.Rational]] | None:
    """Return limit and coefficients of a polynomial; None if nothing cancels or none suffices."""
    terms = expand_at_zero(total, x)
    parts = [expand_at_zero(part, x) for part in total.args]
    if terms is None or any(part is None for part in parts) or total.is_polynomial(x):
        return None
    first = next((k for k, c in enumerate(terms) if c), ORDER)
    if not any(c for part in parts for c in (part or ())[:first]) or first == ORDER:
        return None
    for limit in LIMITS:
        rest = sp.S.Zero
        for count in range(ORDER, first, -1):
            rest += abs(terms[count - 1]) * limit ** (count - 1 - first)
            if rest > PART * abs(terms[first]) / 2:
                if sum(map(bool, terms[:count])) <= MOST_TERMS and count < ORDER:
                    return limit, [_shorten(c) for c in terms[:count]]
                break
    return None


def _shorten(coefficient: sp.Rational) -> sp.Rational:
    """Return the coefficient if its numerator and denominator are doubles, else its double."""
    is_short = max(abs(coefficient.p), coefficient.q) < 2**53
    return coefficient if is_short else sp.Rational(float(coefficient))


def _nest(terms: list[sp.Rational], x: sp.Symbol, add: Callable[[sp.Expr], sp.Symbol]) -> sp.Expr:
    """Return the polynomial by Horner's rule, x**3*(c3 + x**2*(c5 + ...)), with sums as steps."""
    powers = [k for k, c in enumerate(terms) if c]
    value = terms[powers[-1]]
    for power, above in zip(powers[-2::-1], powers[:0:-1], strict=True):
        value = add(terms[power] + x ** (above - power) * value)
    return x ** powers[0] * value
