"""Canonical form of sums with a symbolic number of terms.

A polynomial in such sums is written as a polynomial in *canonical* sums: from 1 to a symbolic
limit, Kronecker deltas carried out, constants in front, unused indices turned into factors n,
sums of powers of the index written as polynomials in n, independent indices split into products
of sums, bound indices renamed in one order. Two canonical sums with
different summands are independent as functions of arbitrarily many terms, so equality of the
polynomials decides equality for every n.

Sums are not evaluated, as by Gosper (1978) and Karr (1981); they are only shown to be equal.
"""

from __future__ import annotations

from functools import cache, lru_cache
from itertools import combinations, permutations

import sympy as sp
from sympy.utilities.iterables import connected_components

from mechproof.arithmetic.ball_evaluation import MOST_TERMS
from mechproof.proof.signs import is_nonnegative
from mechproof.record.parts import has_parts
from mechproof.record.substitution import substitute
from mechproof.statement_domains.domain import Domain

# Work limits: terms split off at the ends of a sum, and powers of an index summed by Faulhaber.
_MOST_ALIGNED = 8
_LARGEST_POWER = 8
Limit = tuple[sp.Symbol, sp.Expr]


def canonicalise(expression: sp.Basic, domain: Domain) -> sp.Basic:
    """Replace every Sum in the expression by its canonical form.

    Raises `NotImplementedError` for a Sum whose limits are not shown to be integers with the upper
    one at least the lower one less 1, or whose upper limit depends on another index.
    """
    if not has_parts(expression, sp.Sum):
        return expression
    if isinstance(expression, sp.Sum):
        return _canonical_sum(expression, domain)
    return expression.func(*(canonicalise(argument, domain) for argument in expression.args))


def write_out(expression: sp.Basic) -> sp.Basic:
    """Write out sums and products between integers; one that ends before it begins is NaN."""
    if not has_parts(expression, sp.Sum, sp.Product):
        return expression
    if isinstance(expression, sp.Sum | sp.Product):
        return _write_out(expression)
    return expression.func(*map(write_out, expression.args))


# A search for counterexamples meets the same sums at all points with the same counts.
@lru_cache(maxsize=256)
def _write_out(node: sp.Sum | sp.Product) -> sp.Basic:
    *inner, (index, lower, upper) = node.limits
    body = node.func(node.function, *inner) if inner else node.function
    if not (lower.is_Integer and upper.is_Integer and upper - lower < MOST_TERMS):
        return node
    if upper < lower - 1:
        return sp.nan
    numbers = range(int(lower), int(upper) + 1)
    combine = sp.Add if isinstance(node, sp.Sum) else sp.Mul
    return combine(*(write_out(substitute(body, {index: sp.Integer(k)})) for k in numbers))


# Many rows of a paper contain the same sums.
@lru_cache(maxsize=256)
def _canonical_sum(node: sp.Sum, domain: Domain) -> sp.Expr:
    aligned = _align(node, domain)
    if aligned != node:
        return canonicalise(aligned, domain)
    limits: list[Limit] = []
    body = _flatten(node, limits, domain)
    terms = sp.Add.make_args(sp.expand(body))
    return sp.Add(*(_canonical_term(term, limits) for term in terms))


def _align(node: sp.Sum, domain: Domain) -> sp.Expr:
    """Split off single terms at the ends, so that a sum runs from 1 to a limit without constant."""
    (index, lower, upper), *others = node.limits
    if others or not lower.is_Integer:
        return node
    shift, free = upper.as_coeff_Add()
    if free == 0 or not shift.is_Integer or max(abs(lower - 1), abs(shift)) > _MOST_ALIGNED:
        return node
    _check_limits(index, lower, upper, domain)
    if not _is_not_negative(free, domain) or not _is_not_negative(upper, domain):
        return node
    ends = ((lower, 0, 1), (1, lower - 1, -1), (free + 1, upper, 1), (upper + 1, free, -1))
    terms = (
        sign * node.function.subs(index, first + k)
        for first, last, sign in ends
        for k in range(int(last - first) + 1)
    )
    return sp.Sum(node.function, (index, 1, free)) + sp.Add(*terms)


def _check_limits(index: sp.Symbol, lower: sp.Expr, upper: sp.Expr, domain: Domain) -> None:
    if not (upper.is_integer and _is_not_negative(upper - lower + 1, domain)):
        raise NotImplementedError(f"a sum from {lower} to {upper} is not worked out")


def _is_not_negative(expression: sp.Expr, domain: Domain) -> bool:
    return bool(expression.is_nonnegative) or is_nonnegative(expression, domain)


def _flatten(node: sp.Expr, limits: list[Limit], domain: Domain) -> sp.Expr:
    """Collect the limits of nested sums under fresh indices; return the innermost summand."""
    if not isinstance(node, sp.Sum):
        return _flatten_inside(node, limits, domain)
    body = node.function
    bound = {limit[0] for limit in node.limits} | {index for index, _ in limits}
    for index, lower, upper in node.limits:
        if lower != 1 or upper.free_symbols & bound:
            raise NotImplementedError(f"a sum from {lower} to {upper} is not worked out")
        _check_limits(index, lower, upper, domain)
        fresh = sp.Dummy(index.name, integer=True)
        body = body.subs(index, fresh)
        limits.append((fresh, upper))
    return _flatten(body, limits, domain)


def _flatten_inside(node: sp.Expr, limits: list[Limit], domain: Domain) -> sp.Expr:
    """Move a summand's inner sums, also those in products and whole powers, out of it."""
    if not has_parts(node, sp.Sum):
        return node
    if isinstance(node, sp.Mul):
        return sp.Mul(*(_flatten(argument, limits, domain) for argument in node.args))
    if isinstance(node, sp.Pow) and node.exp.is_Integer and node.exp > 0:
        return sp.Mul(*(_flatten(node.base, limits, domain) for _ in range(int(node.exp))))
    if isinstance(node, sp.Add):
        inner = [canonicalise(argument, domain) for argument in node.args]
        if any(
            argument.has(sp.Sum) and argument.free_symbols & {i for i, _ in limits}
            for argument in inner
        ):
            raise NotImplementedError(f"an inner sum next to other terms is not rearranged: {node}")
        return sp.Add(*inner)
    raise NotImplementedError("a sum whose terms contain another sum is not rearranged")


def _canonical_term(term: sp.Expr, limits: list[Limit]) -> sp.Expr:
    term, limits = _carry_out_deltas(term, limits)
    indices = {index for index, _ in limits}
    factors = sp.Mul.make_args(term)
    outside = [f for f in factors if not f.free_symbols & indices]
    result = sp.Mul(*outside)
    remaining = [f for f in factors if f.free_symbols & indices]
    for index, upper in limits:
        if not any(index in f.free_symbols for f in remaining):
            result *= upper
    for component in _components(remaining, indices):
        used = {i for f in component for i in f.free_symbols & indices}
        result *= _rename(sp.Mul(*component), [lim for lim in limits if lim[0] in used])
    return result


def _carry_out_deltas(term: sp.Expr, limits: list[Limit]) -> tuple[sp.Expr, list[Limit]]:
    limits = list(limits)
    while deltas := sorted(term.atoms(sp.KroneckerDelta), key=sp.default_sort_key):
        delta = deltas[0]
        # A delta that is not a factor, but under a root, say, does not just pick one index.
        if delta not in sp.Mul.make_args(term):
            raise NotImplementedError(f"{delta} is not a factor of {term}")
        first, second = delta.args
        bounds = dict(limits)
        if first not in bounds or second not in bounds or bounds[first] != bounds[second]:
            raise NotImplementedError(f"{delta}: its two indices do not run over the same range")
        term = term.subs(second, first)
        limits = [limit for limit in limits if limit[0] != second]
    return term, limits


def _components(factors: list[sp.Expr], indices: set[sp.Symbol]) -> list[list[sp.Expr]]:
    """Group the factors that share indices."""
    pairs = combinations(factors, 2)
    joined = [(a, b) for a, b in pairs if a.free_symbols & b.free_symbols & indices]
    return list(connected_components((factors, joined)))


def _rename(body: sp.Expr, limits: list[Limit]) -> sp.Expr:
    """Return a sum with canonical index names: of all orders, the one whose text sorts first."""
    if len(limits) == 1 and (power := _power_of_index(body, limits[0][0])):
        return _sum_of_powers(power, limits[0][1])
    names = [_index(k) for k in range(1, len(limits) + 1)]
    candidates = []
    for order in permutations(limits):
        renamed = body.subs(dict(zip((i for i, _ in order), names, strict=True)), simultaneous=True)
        bounds = [(n, 1, u) for n, (_, u) in zip(names, order, strict=True)]
        candidates.append(sp.Sum(renamed, *bounds))
    # Any rule would do that does not depend on the names in the paper.
    return min(candidates, key=sp.srepr)


@cache
def _index(number: int) -> sp.Dummy:
    """Return a canonical index, a dummy that no symbol of a paper can equal."""
    return sp.Dummy(f"_{number}", integer=True)


def _power_of_index(body: sp.Expr, index: sp.Symbol) -> int:
    base, exponent = body.as_base_exp()
    is_power = base == index and exponent.is_Integer and 0 < exponent <= _LARGEST_POWER
    return int(exponent) if is_power else 0


def _sum_of_powers(power: int, upper: sp.Expr) -> sp.Expr:
    """Sum k**power over k = 1..upper by Faulhaber's formula."""
    polynomials = (sp.bernoulli(power + 1, argument) for argument in (upper + 1, sp.S.One))
    last, first = polynomials
    return sp.expand((last - first) / (power + 1))
