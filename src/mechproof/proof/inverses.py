"""Rungs: inverse functions and roots, by the functions that they invert and by their ranges.

arcsin u = y means that sin y = u and that y lies within a quarter turn of zero; sqrt(b) = y means
that y**2 = b and y >= 0. Inverse sines, cosines and tangents add up to zero if their sum lies
within a turn and points along the first axis. Logarithms add up to zero if the product of their
arguments is one, all of them being positive wherever the sum has a value.

Arguments of plane vectors are added, too: atan2(y1, x1) + atan2(y2, x2), x1 and x2 being positive,
lies between -pi and pi and is the argument of the product of both vectors taken as complex numbers.
Two arguments are equal exactly if their vectors point the same way: zero cross product, positive
scalar product, wherever they point. Arctangents of numbers may be added up any number of times.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import lcm

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.proof.algebra import decide_equal
from mechproof.proof.coordinates import list_terms
from mechproof.proof.inequalities import isolate_root, show_sign
from mechproof.proof.polynomial_signs import sign_of_number
from mechproof.proof.signs import find_sign, is_positive, is_shown
from mechproof.record import Slack
from mechproof.record.parts import ARCS, INVERSES, has_parts
from mechproof.record.relations import list_gaps
from mechproof.statement_domains.domain import Domain

INVERSE = "inverse function: value and range"
ROOT = "square of a root and its sign"
TURNS = "sum of angles within a turn"
LOGARITHMS = "product under one logarithm"
# Work limits: terms of a sum of angles, their whole multiples, roots that are squared.
_MOST_TERMS = 6
_MOST_TIMES = 12
_MOST_ROOTS = 4
# Work limit: operations of the difference of the sides.
_LARGEST = 150
_TURN = 2 * sp.pi

_AREAS: Mapping[type[sp.Basic], Callable[[sp.Expr], sp.Expr]] = {
    sp.asinh: lambda u: sp.log(u + sp.sqrt(u**2 + 1)),
    sp.acosh: lambda u: sp.log(u + sp.sqrt(u**2 - 1)),
    sp.atanh: lambda u: (sp.log(1 + u) - sp.log(1 - u)) / 2,
}


def decide_by_inverse(left: sp.Expr, right: sp.Expr, domain: Domain) -> str | None:
    """Return the rung if left = right gives the value of an inverse function or root, else None."""
    difference = domain.resolve(left - right)
    if has_parts(difference, sp.Sum, sp.Product, sp.Integral, sp.Limit, sp.Indexed):
        return None
    powers = (p.exp for p in difference.atoms(sp.Pow) if p.exp.is_Integer)
    if difference.count_ops() > _LARGEST or any(abs(power) > _MOST_TIMES for power in powers):
        return None
    difference = sp.expand(difference)
    if plain := decide_equal(difference, sp.S.Zero, domain):
        return plain
    difference = _divide(difference)
    rungs = (
        (LOGARITHMS, _multiply_to_one),
        (INVERSE, _is_inverse),
        (TURNS, _adds_to_nothing),
        (ROOT, _is_root),
    )
    return next((name for name, rung in rungs if rung(difference, domain)), None)


def _divide(difference: sp.Expr) -> sp.Expr:
    """Divide by an inverse function's factor if that is a nonzero irrational number."""
    inverses = (*INVERSES, sp.log)
    for term in sp.Add.make_args(difference):
        number, rest = term.as_independent(*difference.free_symbols, *inverses, as_Add=False)
        if type(rest) not in inverses or not number.is_number or number.is_rational:
            continue
        if (sign := sign_of_number(number)) and sign.strict:
            return sp.expand(difference / number)
    return difference


def _is_met(need: Slack, domain: Domain) -> bool:
    return is_shown(need, domain) or show_sign(need, domain) is not None


def _multiply_to_one(difference: sp.Expr, domain: Domain) -> bool:
    if not difference.has(sp.log, *_AREAS):
        return False
    written = difference.replace(
        lambda node: isinstance(node, tuple(_AREAS)), lambda node: _AREAS[type(node)](*node.args)
    )
    terms = list_terms(written)
    logarithms = [(factor, node.args[0]) for node, factor in terms if isinstance(node, sp.log)]
    rest = sp.Add(*(factor * node for node, factor in terms if not isinstance(node, sp.log)))
    if not logarithms or rest.has(sp.log):
        return False
    times = lcm(*(int(factor.q) for factor, _ in logarithms))
    if any(abs(factor * times) > _MOST_TIMES for factor, _ in logarithms):
        return False
    above, below = (
        sp.Mul(*(u ** (sign * f * times) for f, u in logarithms if sign * f > 0))
        for sign in (1, -1)
    )
    return decide_equal(above * sp.exp(sp.expand(times * rest)), below, domain) is not None


def _is_inverse(difference: sp.Expr, domain: Domain) -> bool:
    return any(
        check(node, _write_arcs(sp.expand(node - difference / factor), domain), domain)
        for node, factor in list_terms(difference)
        for kinds, check in (
            (tuple(INVERSES), _has_value),
            ((sp.atan, sp.atan2), _has_direction),
        )
        if isinstance(node, kinds)
    )


def _write_arcs(value: sp.Expr, domain: Domain) -> sp.Expr:
    """Write a plane vector's angle by an arctangent if the vector stays in a half plane."""

    def write(y: sp.Expr, x: sp.Expr) -> sp.Expr:
        if is_positive(x, domain):
            return sp.atan(y / x)
        sign = find_sign(y, domain)
        if sign is None or not sign.strict:
            return sp.atan2(y, x)
        return sign.direction * sp.pi / 2 - sp.atan(x / y)

    return value.replace(sp.atan2, write)


def _has_direction(node: sp.Expr, value: sp.Expr, domain: Domain) -> bool:
    """Return whether a value is the angle of a plane vector: same direction, within (-pi, pi].

    The arctangent of a quotient with a positive denominator is such an angle.
    """
    y, x = sp.fraction(node.args[0]) if isinstance(node, sp.atan) else node.args
    if isinstance(node, sp.atan) and not (x.free_symbols and is_positive(x, domain)):
        return False
    cosine, sine = sp.expand_trig(sp.cos(value)), sp.expand_trig(sp.sin(value))
    if decide_equal(y * cosine, x * sine, domain) is None:
        return False
    needs = (
        Slack(x * cosine + y * sine, True),
        Slack(sp.pi - value, False),
        Slack(sp.pi + value, True),
    )
    return all(_is_met(need, domain) for need in needs)


def _has_value(node: sp.Expr, value: sp.Expr, domain: Domain) -> bool:
    function, values = INVERSES[type(node)]
    if type(node) in _AREAS:
        there = function(value).rewrite(sp.exp).replace(sp.exp, _exponentiate)
    else:
        there = function(value)
    if decide_equal(there, node.args[0], domain) is None:
        return False
    return all(_is_met(need, domain) for need in list_gaps(value, values))


def _exponentiate(argument: sp.Expr) -> sp.Expr:
    """Return the exponential of a sum, with multiples of logarithms written as powers."""
    written = argument.replace(
        lambda node: isinstance(node, tuple(_AREAS)), lambda node: _AREAS[type(node)](*node.args)
    )
    return sp.Mul(
        *(
            node.args[0] ** factor
            if isinstance(node, sp.log) and (2 * factor).is_Integer
            else sp.exp(factor * node)
            for node, factor in list_terms(written)
        )
    )


def _adds_to_nothing(difference: sp.Expr, domain: Domain) -> bool:
    terms = list_terms(difference)
    factors = [factor for node, factor in terms if isinstance(node, ARCS)]
    times = lcm(*(int(factor.q) for factor in factors))
    if not factors or len(terms) > _MOST_TERMS or max(map(abs, factors)) * times > _MOST_TIMES:
        return False
    total = times * difference
    return (
        decide_equal(sp.sin(total), sp.S.Zero, domain) is not None
        and decide_equal(sp.cos(total), sp.S.One, domain) is not None
        and all(_is_met(Slack(_TURN + k * total, True), domain) for k in (1, -1))
    )


def _is_root(difference: sp.Expr, domain: Domain, depth: int = _MOST_ROOTS) -> bool:
    """Return whether p + q*sqrt(b) is zero: p**2 = q**2*b, and p and q have opposite signs."""
    return depth > 0 and any(
        _vanishes(sp.expand(p**2 - q**2 * b), domain, depth - 1)
        and _is_met(Slack(-p * q, False), domain)
        for p, q, b in isolate_root(difference, domain)
        if q != 0
    )


def _vanishes(value: sp.Expr, domain: Domain, depth: int) -> bool:
    is_zero = decide_equal(value, sp.S.Zero, domain) is not None
    return is_zero or _is_root(value, domain, depth)


ARGUMENTS = "arguments of vectors"
# Work limit: the largest whole multiple of an angle.
_MOST_TURNS = 24
Vector = tuple[sp.Expr, sp.Expr]


def decide_by_argument(left: sp.Expr, right: sp.Expr, domain: Domain) -> str | None:
    """Return the rung if left = right equates an argument with another or a sum of two."""
    parted = [
        term.as_coeff_Mul(rational=True) for term in sp.Add.make_args(domain.resolve(left - right))
    ]
    angles = (node for _, node in parted if node != sp.pi)
    if all(isinstance(one, sp.atan | sp.atan2) and not one.free_symbols for one in angles):
        return ARGUMENTS if _is_nothing(parted, domain) else None
    sizes = {abs(factor) for factor, _ in parted}
    is_sum = all(isinstance(node, sp.atan | sp.atan2) for _, node in parted)
    if not is_sum or len(sizes) > 1 or len(parted) not in (2, 3):
        return None
    # The angle whose vector may point anywhere comes first; the others are added up.
    parted.sort(key=lambda term: is_positive(_vector(term[1])[0], domain))
    (factor, alone), *others = parted
    is_pair = len(others) == 1 and others[0][0] == -factor
    if not is_pair and not all(is_positive(_vector(node)[0], domain) for _, node in others):
        return None
    product: Vector = (sp.S.One, sp.S.Zero)
    for sign, node in others:
        product = _multiply(product, _vector(node), -sign / factor)
    return ARGUMENTS if _same_direction(_vector(alone), product, domain) else None


def _is_nothing(parted: list[tuple[sp.Rational, sp.Expr]], domain: Domain) -> bool:
    """Return whether angles add up to zero: their whole multiples point along the first axis.

    That leaves whole turns, which balls exclude (as in Machin's formula for pi).
    """
    scale = lcm(*(int(factor.q) for factor, node in parted if node != sp.pi))
    product: Vector = (sp.S.One, sp.S.Zero)
    for factor, node in parted:
        turns = scale * factor
        if node == sp.pi:
            product = _multiply(product, (sp.cos(turns * sp.pi), sp.sin(turns * sp.pi)), sp.S.One)
            continue
        if abs(turns) > _MOST_TURNS:
            return False
        for _ in range(abs(int(turns))):
            product = _multiply(product, _vector(node), sp.sign(turns))
    total = sp.Add(*(factor * node for factor, node in parted))
    is_no_turn = balls.truth(sp.Lt(sp.Abs(scale * total), sp.pi, evaluate=False), {})
    return is_no_turn is True and _same_direction((sp.S.One, sp.S.Zero), product, domain)


def _vector(node: sp.Expr) -> Vector:
    return (sp.S.One, node.args[0]) if isinstance(node, sp.atan) else node.args[::-1]


def _multiply(one: Vector, other: Vector, sign: sp.Expr) -> Vector:
    """Multiply as complex numbers; `other` is conjugated for the sign -1."""
    (x1, y1), (x2, y2) = one, (other[0], sign * other[1])
    return x1 * x2 - y1 * y2, x1 * y2 + x2 * y1


def _same_direction(one: Vector, other: Vector, domain: Domain) -> bool:
    cross = one[0] * other[1] - one[1] * other[0]
    scalar = one[0] * other[0] + one[1] * other[1]
    return decide_equal(cross, sp.S.Zero, domain) is not None and is_positive(scalar, domain)
