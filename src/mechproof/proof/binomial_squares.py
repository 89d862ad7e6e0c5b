"""Rung: a polynomial is a sum of squares of monomials and of sums and differences of two.

Such sums are found by a linear program (Ahmadi and Majumdar, DSOS and SDSOS optimization, 2019) in
doubles, then solved exactly for the squares that it chooses; its numbers are not trusted.
Non-negative numbers are squares themselves, so that means of numbers become such sums (Reznick
1989).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations, product
from math import comb, lcm, prod

import sympy as sp
from sympy.core.relational import Relational
from sympy.polys.matrices import DomainMatrix

from mechproof.proof.signs import find_sign
from mechproof.record import Slack
from mechproof.statement_domains.domain import Domain

RUNG = "sum of binomial squares"
Monomial = tuple[int, ...]
# A monomial alone, or two with the sign between them.
Square = tuple[Monomial, Monomial, int]
# Work limits: symbols; the degree; terms of a polynomial, and its terms before like ones are
# collected; monomials that are tried as squares, and those that are used.
_MOST_SYMBOLS = 6
_LARGEST_DEGREE = 24
_MOST_TERMS = 120
_MOST_EXPANDED = 2000
_MOST_TRIED = 20_000
_MOST_MONOMIALS = 70
# Weights below this size are rounding errors of the linear program.
_SMALL = 1e-9
_JUMPING = (sp.sign, sp.Heaviside, sp.floor, sp.ceiling)
_LINE, _HALF_LINES = sp.S.Reals, (sp.Interval(0, sp.oo), sp.Interval.open(0, sp.oo))


def holds_by_squares(slack: Slack, domain: Domain) -> bool:
    """Return whether a sum of squares shows a number positive, or non-negative if not strict."""
    polynomial = _write_polynomial(domain.resolve(slack.value), domain)
    if polynomial is None:
        return False
    is_bounded = len(polynomial.gens) <= _MOST_SYMBOLS and len(polynomial.terms()) <= _MOST_TERMS
    if not is_bounded or polynomial.total_degree() > _LARGEST_DEGREE:
        return False
    return _is_sum(polynomial, strict=slack.strict)


def _write_polynomial(value: sp.Expr, domain: Domain) -> sp.Poly | None:
    """Return a polynomial in real numbers with the sign of a value, or None if there is none."""
    symbols = sorted(value.free_symbols, key=str)
    sets = {symbol: domain.set_of(symbol) for symbol in symbols}
    if not symbols or not all(s == _LINE or s in _HALF_LINES for s in sets.values()):
        return None
    # Where such a function jumps, its value does not follow from the polynomials found below.
    if _drop_odd_roots(value).has(*_JUMPING):
        return None
    degree = lcm(*(int(power.exp.q) for power in value.atoms(sp.Pow) if power.exp.is_Rational))
    real = {s: sp.Dummy(s.name, real=True) for s in symbols if sets[s] == _LINE}
    # sqrt(x) and sqrt(x*y) become polynomials in roots of the variables only if these are positive.
    positive = {s: sp.Dummy(s.name, positive=True) for s in symbols if s not in real}
    names = {**real, **{s: root**degree for s, root in positive.items()}}
    above, below = sp.fraction(sp.together(sp.powdenest(value.xreplace(names))))
    letters = [*real.values(), *positive.values()]
    if not (above.is_polynomial(*letters) and below.is_polynomial(*letters)):
        return None
    if not _is_small(above):
        return None
    within = {x: _LINE if x in real.values() else _HALF_LINES[1] for x in letters}
    said = (relation.xreplace(names) for relation in domain.where)
    where = tuple(relation for relation in said if isinstance(relation, Relational))
    # A quotient has no value where its denominator is zero, so a weak sign is enough.
    sign = find_sign(below, Domain(within, where, {}))
    if sign is None:
        return None
    squared = {root: sp.Dummy(root.name, real=True) for root in positive.values()}
    above = (above * sign.direction).xreplace({root: x**2 for root, x in squared.items()})
    polynomial = sp.Poly(above, *real.values(), *squared.values())
    return polynomial if polynomial.domain in (sp.ZZ, sp.QQ) else None


def _drop_odd_roots(value: sp.Expr) -> sp.Expr:
    """Leave out odd roots, sign(x)*|x|**(1/3), which do not jump."""

    def is_root(node: sp.Expr) -> bool:
        signs = [factor.args[0] for factor in node.args if isinstance(factor, sp.sign)]
        powers = (factor.as_base_exp() for factor in node.args)
        roots = {
            base.args[0] for base, power in powers if isinstance(base, sp.Abs) and power.is_positive
        }
        return bool(signs) and roots.issuperset(signs)

    return value.replace(lambda node: node.is_Mul and is_root(node), lambda node: sp.S.One)


def _is_small(polynomial: sp.Expr) -> bool:
    """Return whether a polynomial has few terms and a low degree, without multiplying it out."""
    degree, terms = _measure(polynomial)
    return degree <= _LARGEST_DEGREE and terms <= _MOST_EXPANDED


def _measure(part: sp.Expr) -> tuple[int, int]:
    """Return upper bounds on the degree of a polynomial and on the number of its terms."""
    if not part.args:
        return int(part.is_Symbol), 1
    if part.is_Pow:
        (degree, terms), power = _measure(part.base), int(part.exp)
        return degree * power, comb(terms + power - 1, power) if power <= _LARGEST_DEGREE else power
    degrees, counts = zip(*map(_measure, part.args), strict=True)
    return (max(degrees), sum(counts)) if part.is_Add else (sum(degrees), prod(counts))


def _is_sum(polynomial: sp.Poly, *, strict: bool) -> bool:
    """Return whether a polynomial is such a sum of squares; if strict, plus a positive number."""
    terms = dict(polynomial.terms())
    squares = list(_list_squares([*terms]))
    if not squares:
        return False
    zero = (0,) * len(polynomial.gens)
    chosen = _choose(squares, terms, zero if strict else None)
    weights = _solve(chosen, terms)
    if weights is None or any(weight < 0 for weight in weights.values()):
        return False
    return not strict or weights.get((zero, zero, 1), 0) > 0


def _list_squares(terms: Sequence[Monomial]) -> Iterator[Square]:
    """List the squares whose monomials may appear in a sum, by half the exponents of its terms.

    No monomial of a sum of squares lies outside half the Newton polytope (Reznick 1978), hence none
    outside the surrounding box and range of degrees.
    """
    degrees = [sum(term) for term in terms]
    powers = zip(*terms, strict=True)
    ranges = [range(-(-min(found) // 2), max(found) // 2 + 1) for found in powers]
    if prod(map(len, ranges)) > _MOST_TRIED:
        return
    monomials = [one for one in product(*ranges) if min(degrees) <= 2 * sum(one) <= max(degrees)]
    if len(monomials) > _MOST_MONOMIALS:
        return
    yield from ((one, one, 1) for one in monomials)
    yield from ((*pair, sign) for pair in combinations(monomials, 2) for sign in (1, -1))


def _expand(square: Square) -> dict[Monomial, int]:
    one, other, sign = square
    if one == other:
        return {_add(one, one): 1}
    return {_add(one, one): 1, _add(other, other): 1, _add(one, other): 2 * sign}


def _add(one: Monomial, other: Monomial) -> Monomial:
    return tuple(a + b for a, b in zip(one, other, strict=True))


def _choose(
    squares: Sequence[Square], terms: Mapping[Monomial, sp.Rational], most: Monomial | None
) -> list[Square]:
    """Return the squares that a linear program finds for a sum, or none if it fails.

    The square of the monomial `most` gets as large a weight as possible.
    """
    from scipy.optimize import linprog
    from scipy.sparse import coo_array

    expanded = [_expand(square) for square in squares]
    rows = {m: row for row, m in enumerate(dict.fromkeys(m for e in expanded for m in e))}
    if not terms.keys() <= rows.keys():
        return []
    entries = [(rows[m], k, n) for k, e in enumerate(expanded) for m, n in e.items()]
    places, columns, numbers = zip(*entries, strict=True)
    matrix = coo_array((numbers, (places, columns)), shape=(len(rows), len(squares)))
    right = [float(terms.get(monomial, 0)) for monomial in rows]
    costs = [-1.0 if square == (most, most, 1) else 0.0 for square in squares]
    # The simplex method ends at a vertex, whose squares are independent.
    found = linprog(costs, A_eq=matrix.tocsr(), b_eq=right, method="highs-ds")
    if not found.success:
        return []
    return [one for one, weight in zip(squares, found.x, strict=True) if weight > _SMALL]


def _solve(
    squares: Sequence[Square], terms: Mapping[Monomial, sp.Rational]
) -> dict[Square, sp.Rational] | None:
    """Return the exact weights of squares that add up to a polynomial, or None."""
    expanded = [_expand(square) for square in squares]
    monomials = list(dict.fromkeys([*terms, *(m for e in expanded for m in e)]))
    columns = [*expanded, terms]
    rows = [[sp.QQ.convert(c.get(m, 0)) for c in columns] for m in monomials]
    reduced, pivots = DomainMatrix(rows, (len(rows), len(columns)), sp.QQ).rref()
    if pivots != tuple(range(len(squares))):
        return None
    solved = reduced.to_Matrix()[: len(squares), -1]
    return dict(zip(squares, solved, strict=True))
