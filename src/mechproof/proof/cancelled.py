"""What a print divides by and SymPy has cancelled: u/u is 1 to it, though u is zero everywhere.

A factorial has no value where its reciprocal is zero. Where a divisor is zero at single points of a
line nothing is said: a quotient is meant where it has values.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.domains.domain import Domain, Point
from mechproof.proof.count_zeros import list_ends, list_zeros
from mechproof.proof.counts import has_steps
from mechproof.proof.refutation import name_point, points_for, put_exactly

# Points that are tried; at so many of them zero is no single point of a line.
_TRIED = 8
_MANY = 2
_BITS = (64, 512)


def tell_division_by_zero(divisors: Sequence[sp.Expr], domain: Domain) -> str:
    """Say which divisor is zero, at a count or at more than single points; empty for none."""
    for divisor in divisors:
        resolved = domain.resolve(divisor)
        points = list(islice(points_for((resolved,), domain, _TRIED), _TRIED))
        zeros = [point for point in points if _is_zero(resolved, point)]
        factorial = 1 / divisor if isinstance(1 / divisor, sp.factorial) else None
        solved = map(domain.resolve, list_ends(factorial)) if factorial else [resolved]
        zeros += islice((zero for one in solved for zero in list_zeros(one, domain)), 1)
        needed = 1 if has_steps(resolved, domain) else min(_MANY, len(points))
        if len(zeros) >= needed:
            at = name_point(zeros[0], domain)
            told = f"it divides by {divisor}, which is zero"
            told = f"{factorial} in it has no value" if factorial else told
            return told + (f" at {at}" if at else "")
    return ""


def _is_zero(divisor: sp.Expr, point: Point) -> bool:
    """Tell whether a number cannot be told from zero."""
    exact = put_exactly(divisor, point)
    found = (balls.evaluate(exact, point, bits) for bits in _BITS)
    return all(ball.is_finite() and ball.contains(0) for ball in found)
