"""Partial derivatives of the kernels of `elliptic_planetary`, by every argument.

Prikhodko, Polivoda, Shchetinin 2024, planetary mechanism with an elliptical pair, doi
10.37313/1990-5378-2024-26-3-164-171

Arguments, domain, `out` and errors are those of the kernel with the same name, one module
up; the result has a last axis with a derivative for each argument, in their order. At a
kink it is the derivative on the side of the greater argument, at a pole infinite or NaN.

Each is proved to be what the chain rule makes of the definition. Accuracy is tested: no
error of an entry d is more than the stated multiple of eps = 2**-52 and its conditioning,
|d| + sum of |p * d d/d p| over the arguments and the symbols p of the kernel's formula, and
of the part of the kernel's own error, where that has a scale, divided by the argument (the
first: by it or by 1 rad or mm, what is less).

Generated from mechproof.derivations.elliptic_planetary with SymPy 1.14.0.
Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""

from __future__ import annotations

from typing import Any

import numpy as _np
from numpy.typing import ArrayLike, NDArray

from mechproof.kernel_support.arrays import as_floats as _as_floats
from mechproof.kernel_support.blocks import in_blocks as _in_blocks
from mechproof.kernel_support.domains import (
    is_positive as _is_positive,
    nan_outside as _nan_outside,
)
from mechproof.kernel_support.error_free import (
    product_rest as _product_rest,
    quotient_rest as _quotient_rest,
    small_tangent as _small_tangent,
)
from mechproof.kernel_support.functions import square as _square

__all__ = [
    "acceleration",
    "largest_ratio",
    "position",
    "ratio",
    "smallest_ratio",
]


def __dir__() -> list[str]:
    return __all__


# Source: Prikhodko et al. 2024, equation (8)
# Expressions sha256: f57eb1851cf383226d932bde03dfb04d97abc2544a6bad91870d4424cf1d1930
# Form: backward pass
# Rewrites: low_word, half_angle_tangent
# Operations: 72
def ratio(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the derivatives of `ratio` by its arguments, in their order.

    Of a value in: pure number. Accuracy, tested: 4 eps of its conditioning, where |x| <= 2**26
    and (phi1 = 0 or 1e-290 <= |phi1|) and 1e-300 <= R1 and 1e-300 <= R2.

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio, R1, R2, e)
    return _in_blocks(_form_of_ratio, (phi1,), _prepare_of_ratio, (R1, R2, e), out=out, shape=(4,))


def _check_of_ratio(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    return (_is_positive(R1), _is_positive(R2), e >= 0.0, e < 1.0, R2 < R1)


def _prepare_of_ratio(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    k = R1 / R2
    k_low = _quotient_rest(R1, R2, k)
    one_minus_e = 1.0 - e
    one_plus_e = 1.0 + e
    one_minus_e_squared = _square(one_minus_e)
    one_plus_e_squared = _square(one_plus_e)

    return (R1, R2, e, k, k_low, one_minus_e, one_plus_e, one_minus_e_squared, one_plus_e_squared)


def _form_of_ratio(
    phi1: Any,
    R1: Any,
    R2: Any,
    e: Any,
    k: Any,
    k_low: Any,
    one_minus_e: Any,
    one_plus_e: Any,
    one_minus_e_squared: Any,
    one_plus_e_squared: Any,
) -> Any:
    x = k * phi1
    t = _np.tan(x / 2.0)
    x_low = k_low * phi1 + _product_rest(k, phi1, x)
    t_low = _small_tangent(x_low / 2.0)
    adjacent = 1.0 - t * t_low
    opposite = t + t_low
    adjacent_squared = _square(adjacent)
    term_2 = one_minus_e_squared * adjacent_squared
    opposite_squared = _square(opposite)
    term_3 = one_plus_e_squared * opposite_squared
    term = 1.0 / _square(term_2 + term_3)
    term_4 = adjacent_squared + opposite_squared
    adjacent_one_minus_e = one_minus_e * adjacent

    return (
        -4.0 * e * one_minus_e * one_plus_e * _square(k) * adjacent * opposite * term * term_4,
        one_minus_e
        * one_plus_e
        / R2
        * term
        * term_4
        * (term_2 + term_3 - 4.0 * e * k * adjacent * opposite * phi1),
        one_minus_e
        * one_plus_e
        * R1
        / _square(R2)
        * term
        * term_4
        * (
            4.0 * e * k * adjacent * opposite * phi1
            - one_minus_e_squared * adjacent_squared
            - one_plus_e_squared * opposite_squared
        ),
        2.0
        * k
        * term
        * term_4
        * (adjacent_one_minus_e + one_plus_e * opposite)
        * (adjacent_one_minus_e - one_plus_e * opposite),
    )


# Source: Prikhodko et al. 2024, integral (9) of equation (8)
# Expressions sha256: 0e047ab03020c28c972c7b2b4197867c0d21ee41bc82f95f186ef7e4da9e5107
# Form: backward pass
# Rewrites: positive_atan2, low_word, half_angle_tangent
# Operations: 49
def position(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the derivatives of `position` by its arguments, in their order.

    Of a value in: rad. Accuracy, tested: 4 eps of its conditioning, where |x| <= 2**26 and
    (phi1 = 0 or 1e-290 <= |phi1|) and 1e-300 <= R1 and 1e-300 <= R2.

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_position, R1, R2, e)
    return _in_blocks(
        _form_of_position, (phi1,), _prepare_of_position, (R1, R2, e), out=out, shape=(4,)
    )


def _check_of_position(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    return (_is_positive(R1), _is_positive(R2), e >= 0.0, e < 1.0, R2 < R1)


def _prepare_of_position(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    k = R1 / R2
    k_low = _quotient_rest(R1, R2, k)
    one_minus_e = 1.0 - e
    one_plus_e = 1.0 + e

    return (R1, R2, e, k, k_low, one_minus_e, one_plus_e)


def _form_of_position(
    phi1: Any, R1: Any, R2: Any, e: Any, k: Any, k_low: Any, one_minus_e: Any, one_plus_e: Any
) -> Any:
    x = k * phi1
    t = _np.tan(x / 2.0)
    x_low = k_low * phi1 + _product_rest(k, phi1, x)
    t_low = _small_tangent(x_low / 2.0)
    adjacent = 1.0 - t * t_low
    adjacent_squared = _square(adjacent)
    opposite = t + t_low
    opposite_squared = _square(opposite)
    term = 1.0 / (_square(one_minus_e) * adjacent_squared + _square(one_plus_e) * opposite_squared)
    term_2 = adjacent_squared + opposite_squared

    return (
        1.0
        + k
        + 2.0 * e * k * term * (one_minus_e * adjacent_squared - one_plus_e * opposite_squared),
        one_minus_e * one_plus_e / R2 * phi1 * term * term_2,
        -one_minus_e * one_plus_e * R1 / _square(R2) * phi1 * term * term_2,
        4.0 * adjacent * opposite * term,
    )


# Source: derivative of Prikhodko et al. 2024, equation (8)
# Expressions sha256: b8fd073ecb388d3c6159a22f79a4f0b985fd8f96d3ff17f3ea4602121f9fe317
# Form: backward pass
# Rewrites: low_word, half_angle_tangent
# Operations: 129
def acceleration(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the derivatives of `acceleration` by its arguments, in their order.

    Of a value in: pure number. Accuracy, tested: 4 eps of its conditioning, where |x| <= 2**26
    and (phi1 = 0 or 1e-290 <= |phi1|) and 1e-300 <= R1 and 1e-300 <= R2 and R1 <= 1e130*R2 and
    (e = 0 or 1e-200 <= e).

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_acceleration, R1, R2, e)
    return _in_blocks(
        _form_of_acceleration, (phi1,), _prepare_of_acceleration, (R1, R2, e), out=out, shape=(4,)
    )


def _check_of_acceleration(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    return (_is_positive(R1), _is_positive(R2), e >= 0.0, e < 1.0, R2 < R1)


def _prepare_of_acceleration(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    one_minus_e = 1.0 - e
    one_plus_e = 1.0 + e
    k = R1 / R2
    k_low = _quotient_rest(R1, R2, k)
    one_minus_e_squared = _square(one_minus_e)
    one_plus_e_squared = _square(one_plus_e)
    e_squared = _square(e)
    factor_2 = 1.0 + 4.0 * e + e_squared
    factor = 1.0 + e_squared - 4.0 * e

    return (
        R1,
        R2,
        e,
        one_minus_e,
        one_plus_e,
        k,
        k_low,
        one_minus_e_squared,
        one_plus_e_squared,
        factor_2,
        factor,
    )


def _form_of_acceleration(
    phi1: Any,
    R1: Any,
    R2: Any,
    e: Any,
    one_minus_e: Any,
    one_plus_e: Any,
    k: Any,
    k_low: Any,
    one_minus_e_squared: Any,
    one_plus_e_squared: Any,
    factor_2: Any,
    factor: Any,
) -> Any:
    x = k * phi1
    t = _np.tan(x / 2.0)
    x_low = k_low * phi1 + _product_rest(k, phi1, x)
    t_low = _small_tangent(x_low / 2.0)
    adjacent = 1.0 - t * t_low
    adjacent_squared = _square(adjacent)
    opposite = t + t_low
    opposite_squared = _square(opposite)
    base = one_minus_e_squared * adjacent_squared + one_plus_e_squared * opposite_squared
    term = 1.0 / (base * _square(base))
    term_2 = adjacent_squared + opposite_squared
    term_3 = _square(_square(opposite))
    term_4 = _square(_square(adjacent))
    opposite_cubed = opposite * _square(opposite)
    adjacent_cubed = adjacent * _square(adjacent)

    return (
        2.0
        * e
        * one_minus_e
        * one_plus_e
        * (k * _square(k))
        * term
        * term_2
        * (
            one_plus_e_squared * term_3
            + 12.0 * e * adjacent_squared * opposite_squared
            - one_minus_e_squared * term_4
        ),
        2.0
        * e
        * k
        * one_minus_e
        * one_plus_e
        / R2
        * term
        * term_2
        * (
            k * one_plus_e_squared * phi1 * term_3
            + 12.0 * e * k * adjacent_squared * opposite_squared * phi1
            - 4.0 * one_plus_e_squared * adjacent * opposite_cubed
            - 4.0 * one_minus_e_squared * adjacent_cubed * opposite
            - k * one_minus_e_squared * phi1 * term_4
        ),
        2.0
        * e
        * k
        * one_minus_e
        * one_plus_e
        * R1
        / _square(R2)
        * term
        * term_2
        * (
            4.0 * one_plus_e_squared * adjacent * opposite_cubed
            + 4.0 * one_minus_e_squared * adjacent_cubed * opposite
            + k * one_minus_e_squared * phi1 * term_4
            - k * one_plus_e_squared * phi1 * term_3
            - 12.0 * e * k * adjacent_squared * opposite_squared * phi1
        ),
        -4.0
        * _square(k)
        * adjacent
        * opposite
        * term
        * term_2
        * (
            factor_2 * one_minus_e_squared * adjacent_squared
            + factor * one_plus_e_squared * opposite_squared
        ),
    )


# Source: extremes of Prikhodko et al. 2024, equation (8)
# Expressions sha256: b00e77ffbd14cb98860f36783aceceab2cac306f4967ea6d965478053dae4bd4
# Form: backward pass
# Operations: 16
def largest_ratio(
    R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the derivatives of `largest_ratio` by its arguments, in their order.

    Of a value in: pure number. Accuracy, tested: 4 eps of its conditioning, where R1 <=
    1e300*R2.

    """
    R1, R2, e = _as_floats("R1 R2 e", R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_largest_ratio, R1, R2, e)
    return _in_blocks(
        _form_of_largest_ratio, (R1,), _prepare_of_largest_ratio, (R2, e), out=out, shape=(3,)
    )


def _check_of_largest_ratio(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    return (_is_positive(R2), e >= 0.0, e < 1.0, _is_positive(R1), R2 < R1)


def _prepare_of_largest_ratio(R2: Any, e: Any) -> tuple[Any, ...]:
    one_plus_e = 1.0 + e
    one_minus_e = 1.0 - e
    term = 1.0 / one_minus_e

    return (R2, one_plus_e, one_minus_e, term)


def _form_of_largest_ratio(R1: Any, R2: Any, one_plus_e: Any, one_minus_e: Any, term: Any) -> Any:
    k = R1 / R2

    return (
        one_plus_e * term / R2,
        -one_plus_e * term / _square(R2) * R1,
        term * k + one_plus_e / _square(one_minus_e) * k,
    )


# Source: extremes of Prikhodko et al. 2024, equation (8)
# Expressions sha256: a91a625592f46f946360c54e1280a591894059ed743ee57e2db3c351dc76fca1
# Form: backward pass
# Operations: 17
def smallest_ratio(
    R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the derivatives of `smallest_ratio` by its arguments, in their order.

    Of a value in: pure number. Accuracy, tested: 4 eps of its conditioning, where R1 <=
    1e300*R2.

    """
    R1, R2, e = _as_floats("R1 R2 e", R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_smallest_ratio, R1, R2, e)
    return _in_blocks(
        _form_of_smallest_ratio, (R1,), _prepare_of_smallest_ratio, (R2, e), out=out, shape=(3,)
    )


def _check_of_smallest_ratio(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    return (_is_positive(R2), e >= 0.0, e < 1.0, _is_positive(R1), R2 < R1)


def _prepare_of_smallest_ratio(R2: Any, e: Any) -> tuple[Any, ...]:
    one_minus_e = 1.0 - e
    one_plus_e = 1.0 + e
    term = 1.0 / one_plus_e

    return (R2, one_minus_e, one_plus_e, term)


def _form_of_smallest_ratio(R1: Any, R2: Any, one_minus_e: Any, one_plus_e: Any, term: Any) -> Any:
    k = R1 / R2

    return (
        one_minus_e * term / R2,
        -one_minus_e * term / _square(R2) * R1,
        -term * k - one_minus_e / _square(one_plus_e) * k,
    )
