"""Rung: sums of arguments of plane vectors, such as atan2(y1, x1) + atan2(y2, x2) = atan2(y, x).

Where x1 and x2 are positive, the sum lies between -pi and pi and is the argument of the product
of both vectors taken as complex numbers. Two arguments are equal exactly if their vectors point
the same way: no cross product, a positive scalar product; where they point does not matter then.
Arctangents of numbers may be added up any number of times.
"""

from __future__ import annotations

from math import lcm

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.proof.algebra import decide_equal
from mechproof.proof.signs import is_positive
from mechproof.statement_domains.domain import Domain

RUNG = "arguments of vectors"
# Work limit: so many times an angle is added.
_MOST_TURNS = 24
Vector = tuple[sp.Expr, sp.Expr]


def decide_by_argument(left: sp.Expr, right: sp.Expr, domain: Domain) -> str | None:
    """Return the rung if left = right says that one argument is another or the sum of two."""
    parted = [
        term.as_coeff_Mul(rational=True) for term in sp.Add.make_args(domain.resolve(left - right))
    ]
    angles = (node for _, node in parted if node != sp.pi)
    if all(isinstance(one, sp.atan | sp.atan2) and not one.free_symbols for one in angles):
        return RUNG if _is_nothing(parted, domain) else None
    sizes = {abs(factor) for factor, _ in parted}
    is_sum = all(isinstance(node, sp.atan | sp.atan2) for _, node in parted)
    if not is_sum or len(sizes) > 1 or len(parted) not in (2, 3):
        return None
    # The one whose vector may point anywhere goes first, the others are added up.
    parted.sort(key=lambda term: is_positive(_vector(term[1])[0], domain))
    (factor, alone), *others = parted
    is_pair = len(others) == 1 and others[0][0] == -factor
    if not is_pair and not all(is_positive(_vector(node)[0], domain) for _, node in others):
        return None
    product: Vector = (sp.S.One, sp.S.Zero)
    for sign, node in others:
        product = _multiply(product, _vector(node), -sign / factor)
    return RUNG if _same_direction(_vector(alone), product, domain) else None


def _is_nothing(parted: list[tuple[sp.Rational, sp.Expr]], domain: Domain) -> bool:
    """Tell whether angles add up to nothing: whole multiples of them point along the first axis.

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
