"""Rung: sums of arguments of plane vectors, such as atan2(y1, x1) + atan2(y2, x2) = atan2(y, x).

Where x1 and x2 are positive, the sum lies between -pi and pi and is the argument of the product
of both vectors taken as complex numbers. Two arguments are equal exactly if their vectors point
the same way: no cross product, a positive scalar product.
"""

from __future__ import annotations

import sympy as sp

from mechproof.proof.algebra import decide_equal
from mechproof.proof.domain import Domain
from mechproof.proof.signs import find_sign

RUNG = "arguments of vectors"
Vector = tuple[sp.Expr, sp.Expr]


def decide_by_argument(left: sp.Expr, right: sp.Expr, domain: Domain) -> str | None:
    """Return the rung if left - right is c*(one argument - one or two others) = 0, else None."""
    terms = sp.Add.make_args(domain.resolve(left - right))
    parted = [term.as_coeff_Mul(rational=True) for term in terms]
    if not all(isinstance(node, sp.atan | sp.atan2) for _, node in parted):
        return None
    size = abs(parted[0][0])
    sides = [[_vector(node) for c, node in parted if c == sign * size] for sign in (1, -1)]
    if sum(map(len, sides)) < len(parted):
        return None
    vectors = [_multiply(side, domain) for side in sides]
    return RUNG if None not in vectors and _same_direction(*vectors, domain) else None


def _vector(node: sp.Expr) -> Vector:
    return (sp.Integer(1), node.args[0]) if isinstance(node, sp.atan) else node.args[::-1]


def _multiply(vectors: list[Vector], domain: Domain) -> Vector | None:
    """Return the vector whose argument is the sum of the arguments, if that is sure."""
    if len(vectors) == 1:
        return vectors[0]
    if len(vectors) != 2 or not all(_is_positive(x, domain) for x, _ in vectors):
        return None
    (x1, y1), (x2, y2) = vectors
    return x1 * x2 - y1 * y2, x1 * y2 + x2 * y1


def _same_direction(one: Vector, other: Vector, domain: Domain) -> bool:
    cross = one[0] * other[1] - one[1] * other[0]
    scalar = one[0] * other[0] + one[1] * other[1]
    return decide_equal(cross, sp.S.Zero, domain) is not None and _is_positive(scalar, domain)


def _is_positive(expression: sp.Expr, domain: Domain) -> bool:
    sign = find_sign(expression, domain)
    return sign is not None and sign.strict and sign.direction > 0
