"""Where a function of one variable is looked at for its least value: ends and turning points.

At an end that an interval does not hold, or at infinity, the limit is taken for the value.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from mechproof.proof.continuity import find_break
from mechproof.proof.growth import find_limit
from mechproof.proof.half_angles import is_shown_there
from mechproof.record import Slack
from mechproof.record.needs import KINKED
from mechproof.record.parts import has_parts
from mechproof.statement_domains.domain import Domain

# Work limit: parts of a fraction in the exponent of a place.
_LARGEST_EXPONENT = 50
_PLACES = (sp.S.Zero, sp.S.One, -sp.S.One)


def list_values(
    f: sp.Expr, x: sp.Symbol, slope: sp.Expr, domain: Domain
) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """Yield places with the values there of a function, continuous up to them, or its limits."""
    values = domain.set_of(x)
    inner = dict.fromkeys([*_PLACES, *list_zeros(slope, x)])
    inside = [p for p in inner if p.is_number and values.interior.contains(p) == sp.true]
    for place in dict.fromkeys([values.start, values.end, *inside]):
        if place.is_finite:
            closed = sp.Union(values, sp.FiniteSet(place))
            if find_break(f, x, domain.with_set(x, closed)) is None:
                yield place, f.subs(x, place)
                continue
        if values.contains(place) == sp.true or find_break(f, x, domain) is not None:
            continue
        limit = find_limit(f, x, place, 1 if place == values.start else -1, domain)
        if limit is not None and limit != -sp.oo:
            yield place, limit


def list_zeros(slope: sp.Expr, x: sp.Symbol) -> Iterator[sp.Expr]:
    """Propose zeros of factors with two terms, whose quotient is a power or an exponential."""
    for factor in sp.Mul.make_args(sp.factor_terms(slope)):
        terms = sp.Add.make_args(sp.expand(factor))
        if len(terms) != 2 or not factor.has(x):
            continue
        letters = {s: sp.Dummy(s.name, positive=True) for s in factor.free_symbols}
        one, other = (term.xreplace(letters) for term in terms)
        logarithm = sp.expand(sp.expand_log(sp.log(-one / other), force=True))
        for unit in (sp.log(letters[x]), letters[x]):
            rate = logarithm.coeff(unit)
            rest = sp.expand(logarithm - rate * unit)
            if rate != 0 and not rate.has(letters[x]) and not rest.has(letters[x]):
                place = sp.expand(sp.cancel(-rest / rate), log=False)
                place = place if unit == letters[x] else _exponentiate(place)
                if all(_is_small(power.exp) for power in place.atoms(sp.Pow)):
                    yield place.xreplace({letter: s for s, letter in letters.items()})


def _is_small(exponent: sp.Expr) -> bool:
    """Tell whether a power is written out in reasonable time, which SymPy does of fractions."""
    return not exponent.is_Rational or max(abs(exponent.p), exponent.q) <= _LARGEST_EXPONENT


def _exponentiate(logarithm: sp.Expr) -> sp.Expr:
    """Write exp(k*ln b + m*ln c + d) as b**k*c**m*exp(d)."""
    nodes = sorted(logarithm.atoms(sp.log), key=sp.default_sort_key)
    powers = {node: sp.factor(logarithm.coeff(node)) for node in nodes}
    rest = sp.expand(logarithm - sum(node * power for node, power in powers.items()))
    return sp.Mul(sp.exp(rest), *(node.args[0] ** power for node, power in powers.items()))


def is_analytic_inside(f: sp.Expr, x: sp.Symbol, domain: Domain) -> bool:
    """Tell whether a function is shown to be analytic in a variable on an open interval."""
    if has_parts(f, *KINKED) or find_break(f, x, domain) is not None:
        return False
    numbers = (number for node in sp.preorder_traversal(f) for number in _list_inner(node, x))
    return all(is_shown_there(Slack(number, True), domain) for number in numbers)


def _list_inner(node: sp.Basic, x: sp.Symbol) -> Iterator[sp.Expr]:
    """List what must be positive for a continuous function of an analytic one to be analytic."""
    if not node.has(x):
        return
    if isinstance(node, sp.Pow) and not node.exp.is_integer:
        yield node.base
    elif isinstance(node, sp.asin | sp.acos):
        yield 1 - node.args[0] ** 2
    elif isinstance(node, sp.acosh):
        yield node.args[0] - 1
