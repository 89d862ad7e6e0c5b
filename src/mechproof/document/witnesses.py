"""Points at which constraints hold together: of constraints without any, everything follows.

Newton's method, with the least step where there are more letters than constraints, starts at
points of the domain. A point is found where its steps become small and the domain allows it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import mpmath
import sympy as sp

from mechproof.proof.domain import Domain
from mechproof.record import RecordError

_STARTS = 16
_STEPS = 60
_DIGITS = 30
_SMALL = mpmath.mpf(10) ** -20
# What is divided by zero, has no real value, or no name in mpmath, is no witness.
_NONE = (ArithmeticError, ValueError, TypeError, NameError, NotImplementedError, RecordError)

Vector = list[mpmath.mpf]


def hold_together(residuals: Sequence[sp.Expr], domain: Domain) -> bool:
    """Return whether a point of the domain is found at which all residuals are zero."""
    symbols = sorted({s for one in residuals for s in one.free_symbols}, key=str)
    slopes = sp.Matrix(residuals).jacobian(symbols).tolist()
    values = sp.lambdify(symbols, list(residuals), "mpmath")
    matrix = sp.lambdify(symbols, slopes, "mpmath")
    try:
        starts = domain.points(symbols, _STARTS)[:_STARTS]
    except RecordError:
        return False
    with mpmath.workdps(_DIGITS):
        ends = (_descend(values, matrix, [start[s] for s in symbols]) for start in starts)
        points = (dict(zip(symbols, map(_to_fraction, end), strict=True)) for end in ends if end)
        return any(domain.allows(point) for point in points)


def _descend(
    values: Callable[..., Vector], slopes: Callable[..., list[Vector]], start: Sequence[sp.Expr]
) -> Vector | None:
    """Return the zero that Newton's steps lead to, None if they lead to none."""
    place = [mpmath.mpf(sp.N(value, _DIGITS)) for value in start]
    try:
        for _ in range(_STEPS):
            step = _solve(mpmath.matrix(slopes(*place)), mpmath.matrix(values(*place)))
            place = [x - dx for x, dx in zip(place, step, strict=True)]
            is_still = all(
                abs(dx) < _SMALL * (1 + abs(x)) for x, dx in zip(place, step, strict=True)
            )
            if is_still:
                return place if max(map(abs, values(*place))) < _SMALL else None
    except _NONE:
        pass
    return None


def _solve(matrix: mpmath.matrix, right: mpmath.matrix) -> Vector:
    """Return the least solution of linear equations, of dependent ones the best."""
    left, sizes, others = mpmath.svd_r(matrix)
    part = left.T * right
    scaled = [p / s if s > _SMALL else mpmath.mpf(0) for p, s in zip(part, sizes, strict=True)]
    return list(others.T * mpmath.matrix(scaled))


def _to_fraction(value: mpmath.mpf) -> sp.Expr:
    return sp.Rational(*mpmath.libmp.to_rational(value._mpf_))
