"""Limits from one side, by how fast parts grow: only those that are proved.

The variable is written so that it tends to infinity. A product is compared with
c*exp(a*y)*y**p*(ln y)**q: exponentials beat powers, powers beat logarithms (Hardy, Orders of
Infinity, 1910). The algorithm of Gruntz (1996) ranks the parts of any expression of exponentials
and logarithms, and asks an oracle whether a leading coefficient is zero; here these scales
are the only ones, and each exponent's and coefficient's sign is proved on the domain, or there is
no answer.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache, reduce

import sympy as sp

from mechproof.proof.algebra import decide_equal
from mechproof.proof.orders import (
    ENDS,
    LIKE_ARGUMENT,
    Order,
    join_logarithms,
    rewrite_sum,
    write_inverses,
    write_like,
)
from mechproof.proof.signs import find_sign, is_nonzero, is_positive
from mechproof.record import list_divisors, list_needs, list_partial
from mechproof.statement_domains.domain import Domain

_Y = sp.Dummy("y", positive=True)
# Work limits: the depth of nested parts, and how many levels of it rewriting a sum uses up.
_DEEPEST = 15
_REWRITTEN = 3
_UNREAD = (sp.nan, sp.zoo, sp.Piecewise, sp.Integral, sp.Sum, sp.Product, sp.Limit)
_CONTINUOUS = (*ENDS, sp.sin, sp.cos, sp.asin, sp.acos)
_BOUNDED = (sp.sin, sp.cos, sp.atan, sp.tanh, sp.asin, sp.acos, sp.erf, sp.Si)
_FACTORIALS = (sp.factorial, sp.gamma)


def find_limit(
    expression: sp.Expr, x: sp.Symbol, point: sp.Expr, side: int, domain: Domain
) -> sp.Expr | None:
    """Return the limit as x tends to a point from above (1) or below (-1), or None if not shown."""
    written = _write_far_out(expression, x, point, side)
    if written.has(*_UNREAD):
        return None
    written = _take_rates(_write_directions(written, domain), domain)
    seen = write_inverses(written, lambda node: _find(node, domain, _DEEPEST))
    found = _find(seen, domain, _DEEPEST)
    if found is None and seen.has(*_FACTORIALS):
        return _find(sp.combsimp(seen), domain, _DEEPEST)
    return found


def is_defined_near(
    expression: sp.Expr, x: sp.Symbol, point: sp.Expr, side: int, domain: Domain
) -> bool | None:
    """Return whether roots, logarithms and so on have values near a point; None if not shown."""
    # The needs are read from the print: SymPy takes an imaginary root out of a negative radicand.
    needs = [need.value for part in list_partial(expression) for need in list_needs(part)]
    written = [_write_far_out(number, x, point, side) for number in (expression, *needs)]
    if any(number.has(*_UNREAD) for number in written):
        return None
    signs = [_find_direction_far_out(number, domain) for number in written[1:]]
    return None if None in signs else -1 not in signs


def _write_far_out(expression: sp.Expr, x: sp.Symbol, point: sp.Expr, side: int) -> sp.Expr:
    return expression.subs(x, sp.sign(point) * _Y if point.is_infinite else point + side / _Y)


def _write_directions(expression: sp.Expr, domain: Domain) -> sp.Expr:
    """Replace signs and moduli of numbers whose sign for all large y is known."""
    nodes = (node for node in expression.atoms(sp.sign, sp.Abs) if node.has(_Y))
    ways = {node: _find_direction_far_out(node.args[0], domain) for node in nodes}
    known = {node: sp.Integer(way) for node, way in ways.items() if way is not None}
    return expression.xreplace(
        {n: way if isinstance(n, sp.sign) else way * n.args[0] for n, way in known.items()}
    )


def _take_rates(expression: sp.Expr, domain: Domain) -> sp.Expr:
    """Write ln of a sum as a*y + ln(sum*exp(-a*y)) if it grows at a rate a of unknown sign."""
    written = expression.replace(
        lambda node: isinstance(node, sp.Pow) and node.exp.has(_Y),
        lambda power: sp.exp(power.exp * sp.log(power.base)),
    )
    found: dict[sp.Expr, sp.Expr] = {}
    for total in (node.args[0] for node in written.atoms(sp.log) if node.args[0].is_Add):
        order = _find_order(total, domain, _DEEPEST)
        if order is not None and order.rate.free_symbols:
            rest = sp.expand(total * sp.exp(-order.rate * _Y))
            found[sp.log(total)] = order.rate * _Y + sp.log(rest)
    return written.xreplace(found) if found else expression


def _find_direction_far_out(number: sp.Expr, domain: Domain) -> int | None:
    """Return 1 or -1 if a number is shown to be positive or negative for all large y, else None."""
    limit = _find(number, domain, _DEEPEST)
    if limit is not None and limit != 0:
        return _direction(limit, domain)
    order = _find_order(number, domain, _DEEPEST)
    return None if order is None or order.factor is None else _direction(order.factor, domain)


def _direction(number: sp.Expr, domain: Domain) -> int | None:
    """Return the sign, 1 or -1, of a number that is shown to be nonzero, else None.

    That of ln u is the sign of u - 1.
    """
    if number in (sp.oo, -sp.oo):
        return 1 if number == sp.oo else -1
    scale, logarithm = (join_logarithms(number) or number).as_coeff_Mul()
    if isinstance(logarithm, sp.log) and is_positive(logarithm.args[0], domain):
        number = scale * sp.together(logarithm.args[0] - 1)
    sign = find_sign(number, domain)
    return sign.direction if sign is not None and sign.strict else None


@lru_cache(maxsize=4096)
def _find(node: sp.Expr, domain: Domain, depth: int) -> sp.Expr | None:
    if not node.has(_Y):
        return node
    if node == _Y:
        return sp.oo
    if depth <= 0:
        return None
    if isinstance(node, sp.Add):
        return _find_sum(node, domain, depth - 1)
    if isinstance(node, _CONTINUOUS):
        inner = _find(node.args[0], domain, depth - 1)
        if inner is None:
            return None
        if inner.is_infinite:
            ends = ENDS.get(type(node))
            return ends[inner == sp.oo] if ends else None
        return node.func(inner)
    if isinstance(node, sp.log):
        return _find_logarithm(node.args[0], domain, depth - 1)
    if isinstance(node, _FACTORIALS):
        return sp.oo if _find(node.args[0], domain, depth - 1) == sp.oo else None
    if isinstance(node, sp.Pow) and node.exp.has(_Y):
        return _find(sp.exp(node.exp * sp.log(node.base)), domain, depth - 1)
    order = _find_order(node, domain, depth - 1)
    settled = None if order is None else _settle(order, domain)
    if settled is None and isinstance(node, sp.Pow) and node.exp.is_negative:
        base = _find(node.base, domain, depth - 1)
        return sp.S.Zero if base is not None and base.is_infinite else None
    if settled is not None or not isinstance(node, sp.Mul):
        return settled
    limit = _find_product(node, domain, depth - 1)
    if limit is None and (expanded := sp.expand(node)) != node:
        return _find(expanded, domain, depth - _REWRITTEN)
    return limit


def _find_product(node: sp.Mul, domain: Domain, depth: int) -> sp.Expr | None:
    """Return the product of the limits, infinite ones included; 0 if its logarithm tends to -oo."""
    limits = [_find(factor, domain, depth) for factor in node.args]
    known = [limit for limit in limits if limit is not None]
    if len(known) == len(limits):
        if not any(limit.is_infinite for limit in known):
            return sp.Mul(*known)
        ways = [way for limit in known if (way := _direction(limit, domain))]
        if len(ways) == len(known):
            return sp.Mul(*ways) * sp.oo
    if (found := _find_like(node, domain, depth)) is not None:
        return found
    constant, rest = node.as_independent(_Y)
    if constant != 1 and all(is_nonzero(one, domain) for one in list_divisors(constant)):
        limit = _find(rest, domain, depth)
        if limit is not None and limit.is_finite:
            return constant * limit
    bases = [factor.as_base_exp()[0] for factor in sp.Mul.make_args(rest)]
    if {*bases} != {_Y, sp.E}:
        return None
    # Settles 0*oo, as in exp(-y**2)*y**p.
    logarithm = _find(sp.expand_log(sp.log(rest)), domain, depth)
    return sp.S.Zero if logarithm == -sp.oo else None


def _find_like(node: sp.Expr, domain: Domain, depth: int) -> sp.Expr | None:
    """Return the limit of a product, its factors replaced by asymptotically equal ones."""
    factors = sp.Mul.make_args(node)
    like = sp.Mul(*(write_like(f, _Y, lambda u: _find(u, domain, depth), domain) for f in factors))
    lost = {*list_divisors(node)} - {*list_divisors(like)}
    if like == node or not all(is_nonzero(x, domain) for x in lost if not x.has(_Y)):
        return None
    return _find(like, domain, depth)


def _settle(order: Order, domain: Domain) -> sp.Expr | None:
    for grade in order.size:
        if grade == 0:
            continue
        way = _direction(grade, domain)
        if way is None:
            return None
        if way < 0:
            return sp.S.Zero
        sign = _direction(order.factor, domain) if order.factor is not None else None
        return None if sign is None else sign * sp.oo
    return order.factor


def _find_sum(node: sp.Add, domain: Domain, depth: int) -> sp.Expr | None:
    limits = [_find(term, domain, depth) for term in node.args]
    endless = {limit for limit in limits if limit is not None and limit.is_infinite}
    if None not in limits and len(endless) <= 1:
        return sp.Add(*limits) if not endless else endless.pop()
    order = _find_order(node, domain, depth)
    if order is not None:
        return _settle(order, domain)
    finite = [limit for limit in limits if limit is not None and not limit.is_infinite]
    others = [t for t, limit in zip(node.args, limits, strict=True) if limit not in finite]
    if finite and (rest := _find(sp.Add(*others), domain, depth)) is not None:
        return sp.Add(*finite, rest)
    forms = (_find(form, domain, depth - _REWRITTEN) for form in rewrite_sum(node, _Y))
    return next((found for found in forms if found is not None), None)


def _find_logarithm(argument: sp.Expr, domain: Domain, depth: int) -> sp.Expr | None:
    """Return the limit of a logarithm, whose argument is positive wherever it has a value."""
    inner = _find(argument, domain, depth)
    if inner is None or inner == sp.oo:
        return inner
    if inner == 0:
        return -sp.oo
    return sp.log(inner) if _direction(inner, domain) == 1 else None


@lru_cache(maxsize=4096)
def _find_order(node: sp.Expr, domain: Domain, depth: int) -> Order | None:
    if not node.has(_Y):
        return _constant(node if _direction(node, domain) else None)
    if node == _Y:
        return Order(sp.S.Zero, sp.S.One, sp.S.Zero, sp.S.One)
    if isinstance(node, sp.Add) and node.is_rational_function(_Y):
        return _find_order_of_fraction(node, domain)
    if depth <= 0:
        return None
    if isinstance(node, sp.Mul):
        orders = _find_orders(node.args, domain, depth - 1)
        return reduce(Order.times, orders) if orders else None
    if isinstance(node, sp.Add):
        found = _find_order_of_sum(node, domain, depth - 1)
        joined = None if found else join_logarithms(node)
        return found if joined is None else _find_order(joined, domain, depth)
    if isinstance(node, sp.Pow) and not node.exp.has(_Y):
        base = _find_order(node.base, domain, depth - 1)
        return None if base is None else _raise(base, node.exp, domain)
    if isinstance(node, sp.exp):
        return _find_order_of_exponential(node.args[0], domain, depth - 1)
    if isinstance(node, sp.Pow) and is_positive(node.base, domain):
        exponent = node.exp * sp.log(node.base)
        return _find_order_of_exponential(exponent, domain, depth - 1)
    if isinstance(node, sp.log):
        return _find_order_of_logarithm(node.args[0], domain, depth - 1)
    limit = _find(node, domain, depth - 1) if not isinstance(node, sp.Pow) else None
    if limit is not None and not limit.is_infinite and _direction(limit, domain):
        return _constant(limit)
    if isinstance(node, LIKE_ARGUMENT) and _find(node.args[0], domain, depth - 1) == 0:
        return _find_order(node.args[0], domain, depth - 1)
    # It is bounded, but has no limit and no known sign.
    return _constant(None) if isinstance(node, _BOUNDED) else None


def _find_orders(parts: Sequence[sp.Expr], domain: Domain, depth: int) -> list[Order]:
    """Return the orders of all parts, or an empty list if one is not known."""
    orders = [_find_order(part, domain, depth) for part in parts]
    known = [order for order in orders if order is not None]
    return known if len(known) == len(orders) else []


def _constant(factor: sp.Expr | None) -> Order:
    return Order(sp.S.Zero, sp.S.Zero, sp.S.Zero, factor)


def _raise(base: Order, exponent: sp.Expr, domain: Domain) -> Order | None:
    if base.factor is None and not exponent.is_nonnegative:
        return None
    if not exponent.is_integer and (base.factor is None or _direction(base.factor, domain) != 1):
        return None
    factor = None if base.factor is None else base.factor**exponent
    rate, power, logs = (grade * exponent for grade in base.size)
    return Order(rate, power, logs, factor)


def _find_order_of_fraction(node: sp.Expr, domain: Domain) -> Order | None:
    above, below = (sp.Poly(part, _Y) for part in sp.fraction(sp.together(node)))
    factor = above.LC() / below.LC()
    power = sp.Integer(above.degree() - below.degree())
    # A leading coefficient with letters may be zero, which would make the degree smaller.
    is_known = all(_direction(c, domain) for c in (above.LC(), below.LC()))
    return Order(sp.S.Zero, power, sp.S.Zero, factor) if is_known else None


def _find_order_of_sum(node: sp.Add, domain: Domain, depth: int) -> Order | None:
    """Return the order of the terms that grow fastest, unless they cancel."""
    orders = _find_orders(node.args, domain, depth)
    if not orders:
        return None
    largest = orders[0]
    for order in orders[1:]:
        way = _compare(order, largest, domain)
        if way is None:
            return None
        largest = order if way > 0 else largest
    top = [order for order in orders if order.size == largest.size]
    if any(order.factor is None for order in top):
        return replace(largest, factor=None)
    factor = sp.Add(*(order.factor for order in top))
    # If the leading terms cancel, the order is a lower one that is not known here.
    return Order(*largest.size, factor) if _direction(factor, domain) else None


def _compare(one: Order, other: Order, domain: Domain) -> int | None:
    for first, second in zip(one.size, other.size, strict=True):
        if first != second:
            return _direction(sp.expand(first - second), domain)
    return 0


def _find_order_of_exponential(argument: sp.Expr, domain: Domain, depth: int) -> Order | None:
    argument = sp.expand(argument)
    rate, power = argument.coeff(_Y, 1), argument.coeff(sp.log(_Y), 1)
    if rate.has(_Y) or power.has(_Y):
        return None
    rest = _find(sp.expand(argument - rate * _Y - power * sp.log(_Y)), domain, depth)
    if rest is None or rest.is_infinite:
        return None
    return Order(rate, power, sp.S.Zero, sp.exp(rest))


def _find_order_of_logarithm(argument: sp.Expr, domain: Domain, depth: int) -> Order | None:
    limit = _find(argument, domain, depth)
    if limit is None:
        return None
    if not limit.is_infinite and decide_equal(limit, sp.S.One, domain):
        return _find_order(sp.expand(argument - 1), domain, depth)
    if not limit.is_infinite and _direction(limit, domain) == 1:
        return _constant(sp.log(limit)) if _direction(sp.log(limit), domain) else None
    order = _find_order(argument, domain, depth)
    if order is None or order.factor is None:
        return None
    if order.rate != 0:
        is_known = _direction(order.rate, domain) is not None
        return Order(sp.S.Zero, sp.S.One, sp.S.Zero, order.rate) if is_known else None
    return Order(sp.S.Zero, sp.S.Zero, sp.S.One, order.power) if order.power != 0 else None
