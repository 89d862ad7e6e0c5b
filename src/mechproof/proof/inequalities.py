"""Rungs of inequalities beyond the sign in positive coordinates.

Roots and moduli are squared one after another: p + q*r, with r >= 0 and r**2 = b, is non-negative
if p and q are, if q**2*b >= p**2 and q >= 0, or if p**2 >= q**2*b and p >= 0. A polynomial in a
few non-negative numbers is examined for every order of them, each written as the one below plus a
gap (successive difference substitution, Yang 2005). Numbers with given linear relations are
written by the gaps of these relations.

|u| is the largest of t*u, -1 <= t <= 1: a sum of moduli is at least another if, for each choice of
signs in the latter, factors t are found with which both sums agree. And |f(x) - f(y)| is at most
the largest slope of f times |x - y|.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from itertools import combinations, permutations, product

import sympy as sp

from mechproof.arithmetic.polynomials import expand, split
from mechproof.proof import angle_differences, binomial_squares, monotonicity
from mechproof.proof.continuity import find_break
from mechproof.proof.coordinates import list_by_values
from mechproof.proof.half_angles import find_sign_there, is_negative_somewhere, is_shown_there
from mechproof.proof.signs import is_shown
from mechproof.record import Root, Slack
from mechproof.record.parts import find_roots, has_parts
from mechproof.record.relations import find_slack
from mechproof.statement_domains.domain import Domain

SQUARES = "squares of roots and moduli"
HALF_ANGLES = "signs in half-angle tangents"
ORDERS = "every order of the numbers"
GAPS = "gaps of linear relations"
VALUES = "order of inverse functions"
# Work limits: roots that are squared, variables whose orders are tried, terms of a square.
_MOST_ROOTS = 4
_MOST_ORDERED = 3
_MOST_TERMS = 120
# Work limit: relations of the domain from which independent ones are chosen.
_MOST_SAID = 6
# Work limits: operations of a number, and of a number that is written by gaps.
_LARGEST, _LARGEST_MOVED = 150, 40
_UNREAD = (sp.Sum, sp.Product, sp.Integral, sp.Indexed, sp.Piecewise, sp.KroneckerDelta, Root)


def show_sign(slack: Slack, domain: Domain) -> str | None:
    """Return the rung that proves a slack positive, or non-negative if not strict; else None."""
    if has_parts(slack.value, *_UNREAD) or slack.value.count_ops() > _LARGEST:
        return None
    if is_negative_somewhere(slack.value, domain):
        return None
    rungs = (
        (HALF_ANGLES, is_shown_there),
        (angle_differences.RUNG, partial(angle_differences.holds_at_ends, show=show_sign)),
        (SIGNS, holds_by_signs),
        (MEAN_VALUE, partial(holds_by_mean_value, show=show_sign)),
        (ORDERS, _by_orders),
        (VALUES, _by_values),
        (SQUARES, _by_squares),
        (binomial_squares.RUNG, binomial_squares.holds_by_squares),
        (monotonicity.RUNG, monotonicity.holds_by_slope),
        (GAPS, _by_gaps),
    )
    return next((name for name, rung in rungs if rung(slack, domain)), None)


def _by_values(slack: Slack, domain: Domain) -> bool:
    """Compare an arc, such as an inverse sine, with another number by applying its inverse."""
    return any(
        not end.value.is_infinite and is_shown_there(end, domain) and show_sign(value, domain)
        for value, _, end in list_by_values(slack._replace(value=domain.resolve(slack.value)))
    )


def _by_orders(slack: Slack, domain: Domain) -> bool:
    """Prove the sign for every order of two or three non-negative symbols."""
    value = domain.resolve(slack.value)
    symbols = sorted(value.free_symbols, key=str)
    sets = [domain.set_of(s) for s in symbols]
    if not 2 <= len(symbols) <= _MOST_ORDERED or not value.is_rational_function(*symbols):
        return False
    if not all(isinstance(s, sp.Interval) and s.start == 0 and s.end == sp.oo for s in sets):
        return False
    if any(r.free_symbols & set(symbols) for r in domain.where):
        return False
    is_open = all(s.left_open for s in sets)
    return all(
        _holds_in_order(value, order, slack.strict, is_open) for order in permutations(symbols)
    )


def _holds_in_order(
    value: sp.Expr, order: tuple[sp.Symbol, ...], strict: bool, is_open: bool
) -> bool:
    gaps = [sp.Dummy("gap", nonnegative=True) for _ in order]
    written = {s: sp.Add(*gaps[: k + 1]) for k, s in enumerate(order)}
    within = dict.fromkeys(gaps, sp.Interval(0, sp.oo))
    within[gaps[0]] = sp.Interval(0, sp.oo, left_open=is_open)
    return is_shown(Slack(value.xreplace(written), strict), Domain(within, (), {}))


def _by_gaps(slack: Slack, domain: Domain) -> bool:
    """Write numbers by the gaps of as many independent linear relations, such as a < b + c.

    For the sides of a triangle this is Ravi's substitution.
    """
    value = domain.resolve(slack.value)
    symbols = sorted(value.free_symbols, key=str)
    if any(s.is_integer for s in symbols) or value.count_ops() > _LARGEST_MOVED:
        return False
    ends = ((s, v) for s in symbols if isinstance(v := domain.set_of(s), sp.Interval))
    said = [Slack(s - v.start, v.left_open) for s, v in ends if v.start.is_finite]
    related = [one for one in map(find_slack, domain.where) if one and _is_linear(one, symbols)]
    if not (related and 2 <= len(symbols) <= _MOST_ORDERED and len(said + related) <= _MOST_SAID):
        return False
    few = combinations(related, min(len(related), len(symbols)))
    chosen = ((*one, *rest) for one in few for rest in combinations(said, len(symbols) - len(one)))
    return any(_holds_by_gaps(value, symbols, slack.strict, some) for some in chosen)


def _is_linear(one: Slack, symbols: Sequence[sp.Basic]) -> bool:
    if not (one.value.free_symbols <= {*symbols} and one.value.is_polynomial(*symbols)):
        return False
    return int(sp.Poly(one.value, *symbols).total_degree()) == 1


def _holds_by_gaps(
    value: sp.Expr, symbols: Sequence[sp.Symbol], strict: bool, said: Sequence[Slack]
) -> bool:
    gaps = [sp.Dummy("gap", nonnegative=True) for _ in said]
    equations = [one.value - gap for one, gap in zip(said, gaps, strict=True)]
    (found,) = sp.linsolve(equations, symbols) or [sp.Tuple(*symbols)]
    if found.free_symbols & {*symbols}:
        return False
    written = value.xreplace(dict(zip(symbols, found, strict=True)))
    within = {g: sp.Interval(0, sp.oo, left_open=s.strict) for g, s in zip(gaps, said, strict=True)}
    moved, part = Slack(written, strict), Domain(within, (), {})
    rungs = (is_shown_there, _by_orders, _by_squares, binomial_squares.holds_by_squares)
    if any(rung(moved, part) for rung in rungs):
        return True
    # With more gaps the derivatives take too long.
    return len(gaps) == 2 and monotonicity.holds_by_slope(moved, part)


def _by_squares(slack: Slack, domain: Domain) -> bool:
    value = domain.resolve(slack.value)
    count = len(_list_roots(value))
    if not 0 < count <= _MOST_ROOTS or value.has(sp.Sum, sp.Integral):
        return False
    return _holds(value, slack.strict, domain, count + 2)


def _list_roots(value: sp.Expr) -> list[sp.Expr]:
    """List all square roots and moduli, longest first."""
    nodes = find_roots(value) | value.atoms(sp.Abs)
    return sorted(nodes, key=lambda n: (-n.count_ops(), sp.default_sort_key(n)))


def _holds(value: sp.Expr, strict: bool, domain: Domain, depth: int) -> bool:
    """Return whether a number is shown to be positive, or non-negative if not `strict`."""
    slack, has_roots = Slack(value, strict), bool(_list_roots(value))
    if is_shown_there(slack, domain):
        return True
    if not has_roots and monotonicity.holds_by_slope(slack, domain):
        return True
    if depth == 0 or is_negative_somewhere(value, domain):
        return False
    if not has_roots:
        return binomial_squares.holds_by_squares(slack, domain)
    return any(
        _holds_by_root(*parts, strict, domain, depth - 1) for parts in isolate_root(value, domain)
    )


def isolate_root(value: sp.Expr, domain: Domain) -> Iterator[tuple[sp.Expr, sp.Expr, sp.Expr]]:
    """Yield p, q, b of p + q*sqrt(b), which has the number's sign, for each outermost root."""
    nodes = _list_roots(value)
    squares: dict[sp.Expr, sp.Expr] = {}
    for node in nodes:
        if any(node != other and other.has(node) for other in nodes):
            continue
        squares.setdefault(*_write_square(node))
    if not squares or value.has(Root):
        return
    names = {root: sp.Dummy("root", nonnegative=True) for root in squares}
    named = value.replace(
        lambda n: isinstance(n, sp.Pow) and n.exp.is_Rational and n.exp.q == 2,
        lambda n: names[sp.sqrt(n.base)] ** (2 * n.exp) if sp.sqrt(n.base) in names else n,
    ).xreplace(names)
    above, below = split(named)
    sign = None if below.free_symbols & set(names.values()) else find_sign_there(below, domain)
    direction = sign.direction if sign and sign.strict else below
    whole = expand(above * direction)
    if not whole.is_polynomial(*names.values()):
        return
    back = {name: root for root, name in names.items()}
    for root, name in names.items():
        polynomial = sp.Poly(whole, name)
        if len(polynomial.as_expr().args) > _MOST_TERMS:
            return
        p = q = sp.S.Zero
        for (power,), coefficient in polynomial.terms():
            part = coefficient * squares[root] ** (power // 2)
            p, q = (p, q + part) if power % 2 else (p + part, q)
        p, q = (sp.expand(part.xreplace(back)) for part in (p, q))
        yield p, q, squares[root]


def _write_square(node: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    if isinstance(node, sp.Abs):
        return node, node.args[0] ** 2
    return sp.sqrt(node.base), node.base


def _holds_by_root(
    p: sp.Expr, q: sp.Expr, b: sp.Expr, strict: bool, domain: Domain, depth: int
) -> bool:
    """Return whether p + q*sqrt(b) is shown to be positive, or non-negative if not `strict`."""
    if q == 0:
        return _holds(p, strict, domain, depth)
    gap = sp.expand(q**2 * b - p**2)
    if _holds(q, False, domain, depth):
        return _holds(gap, strict, domain, depth) or _holds(p, strict, domain, depth)
    if not _holds(-q, False, domain, depth):
        return False
    return _holds(p, False, domain, depth) and _holds(-gap, strict, domain, depth)


SIGNS = "signs of moduli"
MEAN_VALUE = "mean value theorem"
# Work limit: moduli that are subtracted.
_MOST_SUBTRACTED = 4


def holds_by_signs(slack: Slack, domain: Domain) -> bool:
    """Return whether a sum of moduli is at least other moduli and a rest, for all signs of these.

    Powers are not expanded: high ones have too many terms.
    """
    rest, factors = _read(domain.resolve(slack.value))
    above = {node: c for node, c in factors.items() if c > 0}
    below = {node: c for node, c in factors.items() if c < 0}
    is_met = above and len(below) <= _MOST_SUBTRACTED and not rest.has(sp.Abs)
    if slack.strict or not is_met:
        return False
    signs = product((1, -1), repeat=len(below))
    parts = [c * node.args[0] for node, c in below.items()]
    sums = (rest + sp.Add(*map(sp.Mul, some, parts)) for some in signs)
    return all(_is_reached([c * node.args[0] for node, c in above.items()], x) for x in sums)


def _read(value: sp.Expr) -> tuple[sp.Expr, dict[sp.Abs, sp.Expr]]:
    """Return the sum of all other terms, and the moduli with their numerical factors."""
    terms = sp.expand_mul(value).as_coefficients_dict()
    factors = {node: c for node, c in terms.items() if isinstance(node, sp.Abs)}
    return sp.Add(*(c * term for term, c in terms.items() if term not in factors)), factors


def _is_reached(parts: list[sp.Expr], subtracted: sp.Expr) -> bool:
    """Return whether, for some t in [-1, 1], the sum of t*u plus `subtracted` is a number >= 0."""
    shares = [sp.Dummy("t", real=True) for _ in parts]
    equations: dict[sp.Expr, sp.Expr] = defaultdict(lambda: sp.S.Zero)
    for share, part in zip((sp.S.One, *shares), (subtracted, *parts), strict=True):
        for term, number in sp.expand_mul(part).as_coefficients_dict().items():
            equations[term] += number * share
    least = equations.pop(sp.S.One, sp.S.Zero)
    solved = next(iter(sp.linsolve([*equations.values()], shares)), None)
    if solved is None:
        return False
    free = dict.fromkeys(shares, sp.S.Zero)
    chosen = dict(zip(shares, (share.xreplace(free) for share in solved), strict=True))
    is_within = all(abs(share) <= 1 for share in chosen.values())
    return is_within and bool(least.xreplace(chosen) >= 0)


def holds_by_mean_value(
    slack: Slack, domain: Domain, show: Callable[[Slack, Domain], str | None]
) -> bool:
    """Return whether a multiple of |x - y| is at least |f(x) - f(y)|, by the slope of f."""
    rest, factors = _read(domain.resolve(slack.value))
    if slack.strict or rest != 0 or sorted(map(sp.sign, factors.values())) != [-1, 1]:
        return False
    (length, scale), (gap, factor) = sorted(factors.items(), key=lambda item: -item[1])
    x, *others = sorted(length.free_symbols, key=str)
    if len(others) != 1 or (slope := sp.diff(length.args[0], x)) not in (1, -1):
        return False
    (y,), c = others, sp.Dummy("c", real=True)
    f, where = gap.args[0], domain.set_of(x)
    is_met = (
        sp.expand_mul(length.args[0] - slope * (x - y)) == 0
        and sp.expand_mul(f + f.xreplace({x: y, y: x})) == 0
        and not sp.diff(f, x).has(y)
        and isinstance(where, sp.Interval)
        and where == domain.set_of(y)
    )
    if not is_met:
        return False
    steep, inner = sp.diff(f, x).xreplace({x: c}), domain.with_set(c, where.interior)
    return find_break(f.xreplace({x: c}), c, domain.with_set(c, where)) is None and all(
        show(Slack(scale + sign * factor * steep, False), inner) for sign in (1, -1)
    )
