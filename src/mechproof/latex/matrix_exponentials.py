r"""Exponentials of matrices in closed form: e^{\hat\omega\theta} -> its entries.

A matrix K with K^4 = -q^2 K^2 has e^{cK} = I + cK + (1 - cos qc)/q^2 K^2 + (qc - sin qc)/q^3 K^3, a
polynomial in c if q = 0. The matrices of cross products, twists and rotations in the plane are of
this kind; if q^2 is negative, the functions are hyperbolic. A multiple of the unit matrix may be
added, which covers every 2x2 matrix. Other matrices need numbers as entries and distinct rational
eigenvalues.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from mechproof.latex.errors import MeaningError
from mechproof.latex.matrix_meaning import show_entries

_MOST_ROWS = 6


def give_exponential(exponent: Any) -> sp.ImmutableMatrix:
    """Return the exponential of a matrix; raise `MeaningError` if no closed form is found."""
    matrix = show_entries(exponent)
    if not matrix.is_square:
        raise MeaningError("only square matrices have an exponential")
    if (found := exponentiate(matrix)) is not None:
        return found
    # Unknown entries are named after the matrix, A[1, 2].
    if unknown := sorted(str(s).partition("[")[0] for s in matrix.free_symbols if "[" in str(s)):
        raise MeaningError(
            f"the exponential of a matrix, but the entries of {unknown[0]} are not known: print "
            "them in an earlier equation, or say in the block of letters: let name=matrix"
        )
    raise MeaningError(
        "the exponential of this matrix is not worked out: only those of cross products, twists, "
        "nilpotent matrices and some others are; print its entries"
    )


def exponentiate(matrix: sp.MatrixBase) -> sp.ImmutableMatrix | None:
    """Return the exponential of a square matrix, None if no closed form is found."""
    if matrix.is_diagonal():
        return sp.diag(*map(sp.exp, matrix.diagonal())).as_immutable()
    if matrix.rows > _MOST_ROWS:
        return None
    scale, kernel = _take_factor(matrix)
    return _by_powers(kernel, scale) or _by_values(kernel, scale) or _by_shift(kernel, scale)


def _take_factor(matrix: sp.MatrixBase) -> tuple[sp.Expr, sp.MatrixBase]:
    """Return the common factor of a matrix's entries, and the matrix divided by it."""
    common = sp.gcd_list([entry for entry in matrix if entry != 0])
    return common, matrix.applyfunc(lambda entry: sp.cancel(entry / common))


def _by_powers(kernel: sp.MatrixBase, scale: sp.Expr) -> sp.ImmutableMatrix | None:
    square = (kernel**2).applyfunc(sp.cancel)
    negative = sp.cancel(sp.trace(square) / 2)
    if (square**2 - negative * square).applyfunc(sp.cancel) != sp.zeros(*kernel.shape):
        return None
    cube = (square * kernel).applyfunc(sp.cancel)
    if negative == 0:
        second, third = scale**2 / 2, scale**3 / 6
    else:
        second, third = _work_out(negative, scale)
    found = sp.eye(kernel.rows) + scale * kernel + second * square + third * cube
    return found.applyfunc(sp.cancel).as_immutable()


def _work_out(negative: sp.Expr, scale: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return the factors of the second and the third power of a matrix.

    If the sign of -q^2 is not seen, it is taken to be negative; where it is not, the factors have
    no value.
    """
    if (root := _take_root(negative)) is not None:
        angle = root * scale
        return (sp.cosh(angle) - 1) / root**2, (sp.sinh(angle) - angle) / root**3
    root = _take_root(-negative) or sp.sqrt(-negative)
    angle = root * scale
    return (1 - sp.cos(angle)) / root**2, (angle - sp.sin(angle)) / root**3


def _take_root(number: sp.Expr) -> sp.Expr | None:
    """Return a square root, without a modulus, of a number seen to be nowhere negative, else None.

    Either root will do: the factors of the powers are even functions of it.
    """
    above, below = (sp.factor_list(part) for part in sp.fraction(sp.together(number)))
    factor = above[0] / below[0]
    if not factor.is_positive:
        return None
    root = sp.sqrt(factor)
    for base, power in (*above[1], *((base, -power) for base, power in below[1])):
        half, rest = divmod(power, 2)
        if rest and not _is_sum_of_squares(base):
            return None
        root *= base**half * sp.sqrt(base) ** rest
    return root


def _is_sum_of_squares(number: sp.Expr) -> bool:
    coefficients = sp.expand(number).as_coefficients_dict()
    terms = ((sp.factor_list(term)[1], factor) for term, factor in coefficients.items())
    return all(f.is_positive and all(p % 2 == 0 for _, p in parts) for parts, f in terms)


def _by_shift(kernel: sp.MatrixBase, scale: sp.Expr) -> sp.ImmutableMatrix | None:
    """Return the exponential of the traceless part times that of the rest of a matrix."""
    mean = sp.cancel(sp.trace(kernel) / kernel.rows)
    found = _by_powers(kernel - mean * sp.eye(kernel.rows), scale) if mean != 0 else None
    return found and (sp.exp(mean * scale) * found).as_immutable()


def _by_values(kernel: sp.MatrixBase, scale: sp.Expr) -> sp.ImmutableMatrix | None:
    """Return the exponential of a matrix of numbers by its eigenvalues (Sylvester's formula)."""
    if kernel.free_symbols:
        return None
    values = [root for root in sp.roots(kernel.charpoly().as_expr()) if root.is_Rational]
    if len(values) != kernel.rows:
        return None
    unit: Any = sp.eye(kernel.rows)
    found = sp.zeros(*kernel.shape)
    for value in values:
        others = (other for other in values if other != value)
        parts = ((kernel - other * unit) / (value - other) for other in others)
        found += sp.exp(value * scale) * sp.prod(parts, start=unit)
    return found.as_immutable()
