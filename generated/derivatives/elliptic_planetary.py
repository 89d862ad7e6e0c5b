"""Partial derivatives of the kernels of `elliptic_planetary`, by every argument.

Prikhodko, Polivoda, Shchetinin 2024, planetary mechanism with an elliptical pair, doi
10.37313/1990-5378-2024-26-3-164-171

Arguments, domain, `out` and errors are those of the kernel with the same name, one module
up; along a last axis the result has the derivative by each argument, in their order.

At a kink a derivative is that on the side of the greater argument; at a pole it is infinite
or NaN. Each is proved to follow from the definition by the chain rule. Accuracy is tested:
the error of an entry d is at most the stated multiple of eps = 2**-52 times its condition,
|d| + the sum of |p * d d/d p| over the arguments and the symbols p of the kernel's formula,
plus, if the kernel's own error has a scale, that scale divided by the argument (the first
counts as at most 1 rad or mm).

Generated from the derivation elliptic_planetary with SymPy 1.14.0.
Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""

from __future__ import annotations

from typing import Any

import numpy as _np
from numpy.typing import ArrayLike, NDArray

from mechproof.kernel_support.arrays import as_floats as _as_floats
from mechproof.kernel_support.blocks import in_blocks as _in_blocks
from mechproof.kernel_support.domains import (
    is_finite as _is_finite,
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
    "angle_of_smallest_acceleration",
    "eccentricity_of_extremes",
    "eccentricity_of_largest_ratio",
    "eccentricity_of_quotient",
    "eccentricity_of_smallest_ratio",
    "jerk",
    "largest_acceleration",
    "largest_ratio",
    "position",
    "radii_of_extremes",
    "ratio",
    "smallest_jerk",
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
) -> NDArray[Any]:
    """Differentiate `ratio` by its arguments, in their order.

    In 1 per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where |x| <=
    2**26 and (phi1 = 0 or 1e-290 <= |phi1|) and 1e-300 <= R1 and 1e-300 <= R2.

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
# Rewrites: positive_atan2, low_word, low_sum, half_angle_tangent, quotient_arc
# Operations: 49
def position(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `position` by its arguments, in their order.

    In rad per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where |x| <=
    2**26 and (phi1 = 0 or 1e-290 <= |phi1|) and 1e-300 <= R1 and 1e-300 <= R2.

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio, R1, R2, e)
    return _in_blocks(
        _form_of_position, (phi1,), _prepare_of_position, (R1, R2, e), out=out, shape=(4,)
    )


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
) -> NDArray[Any]:
    """Differentiate `acceleration` by its arguments, in their order.

    In 1 per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where |x| <=
    2**26 and (phi1 = 0 or 1e-290 <= |phi1|) and 1e-300 <= R1 and 1e-300 <= R2 and R1 <=
    1e130*R2 and (e = 0 or 1e-200 <= e).

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio, R1, R2, e)
    return _in_blocks(
        _form_of_acceleration, (phi1,), _prepare_of_acceleration, (R1, R2, e), out=out, shape=(4,)
    )


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
) -> NDArray[Any]:
    """Differentiate `largest_ratio` by its arguments, in their order.

    In 1 per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where R1 <=
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
) -> NDArray[Any]:
    """Differentiate `smallest_ratio` by its arguments, in their order.

    In 1 per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where R1 <=
    1e300*R2.

    """
    R1, R2, e = _as_floats("R1 R2 e", R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_largest_ratio, R1, R2, e)
    return _in_blocks(
        _form_of_smallest_ratio, (R1,), _prepare_of_smallest_ratio, (R2, e), out=out, shape=(3,)
    )


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


# Source: second derivative of Prikhodko et al. 2024, equation (8)
# Expressions sha256: c1f713a201ffecff899f169bd6c78e55c676a46b063f84f2e2636158b31499dd
# Form: backward pass
# Rewrites: low_word, half_angle_tangent
# Operations: 211
def jerk(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `jerk` by its arguments, in their order.

    In 1 per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where |x| <=
    2**26 and (phi1 = 0 or 1e-290 <= |phi1|) and 1e-300 <= R1 and 1e-300 <= R2 and R1 <= 1e75*R2
    and (e = 0 or 1e-100 <= e).

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio, R1, R2, e)
    return _in_blocks(_form_of_jerk, (phi1,), _prepare_of_jerk, (R1, R2, e), out=out, shape=(4,))


def _prepare_of_jerk(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    k = R1 / R2
    k_low = _quotient_rest(R1, R2, k)
    one_minus_e = 1.0 - e
    one_plus_e = 1.0 + e
    one_minus_e_squared = _square(one_minus_e)
    one_plus_e_squared = _square(one_plus_e)
    e_squared = _square(e)
    factor = 1.0 + e_squared - 10.0 * e
    factor_3 = 1.0 + 10.0 * e + e_squared
    term_4 = _square(_square(e))
    factor_2 = 1.0 + term_4 - 26.0 * e_squared
    k_squared = _square(k)
    term_8 = _square(_square(one_minus_e))
    term_9 = _square(_square(one_plus_e))
    factor_4 = 1.0 + e_squared - 4.0 * e
    factor_7 = 1.0 + 4.0 * e + e_squared
    term_2 = -86.0 * e_squared
    e_cubed = e * _square(e)
    factor_5 = 1.0 + 30.0 * e + 30.0 * e_cubed + term_2 + term_4
    factor_6 = 1.0 + term_2 + term_4 - 30.0 * e - 30.0 * e_cubed

    return (
        R1,
        R2,
        e,
        k,
        k_low,
        one_minus_e,
        one_plus_e,
        one_minus_e_squared,
        one_plus_e_squared,
        factor,
        factor_3,
        factor_2,
        k_squared,
        term_8,
        term_9,
        factor_4,
        factor_7,
        factor_5,
        factor_6,
    )


def _form_of_jerk(
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
    factor: Any,
    factor_3: Any,
    factor_2: Any,
    k_squared: Any,
    term_8: Any,
    term_9: Any,
    factor_4: Any,
    factor_7: Any,
    factor_5: Any,
    factor_6: Any,
) -> Any:
    x = k * phi1
    t = _np.tan(x / 2.0)
    x_low = k_low * phi1 + _product_rest(k, phi1, x)
    t_low = _small_tangent(x_low / 2.0)
    adjacent = 1.0 - t * t_low
    opposite = t + t_low
    adjacent_squared = _square(adjacent)
    opposite_squared = _square(opposite)
    term = 1.0 / _square(
        _square(one_minus_e_squared * adjacent_squared + one_plus_e_squared * opposite_squared)
    )
    term_3 = adjacent_squared + opposite_squared
    term_5 = _square(_square(opposite))
    term_6 = _square(_square(adjacent))
    term_7 = _square(adjacent * _square(adjacent))
    term_10 = _square(opposite * _square(opposite))
    adjacent_cubed = adjacent * _square(adjacent)
    opposite_cubed = opposite * _square(opposite)
    term_11 = opposite * _square(_square(opposite))
    term_12 = adjacent * _square(_square(adjacent))

    return (
        4.0
        * e
        * one_minus_e
        * one_plus_e
        * _square(_square(k))
        * adjacent
        * opposite
        * term
        * term_3
        * (
            2.0 * factor_2 * adjacent_squared * opposite_squared
            + factor * one_plus_e_squared * term_5
            + factor_3 * one_minus_e_squared * term_6
        ),
        2.0
        * e
        * k_squared
        * one_minus_e
        * one_plus_e
        / R2
        * term
        * term_3
        * (
            3.0 * term_9 * term_10
            + 3.0 * factor_3 * one_plus_e_squared * adjacent_squared * term_5
            + 4.0 * factor_2 * k * adjacent_cubed * opposite_cubed * phi1
            + 2.0 * factor * k * one_plus_e_squared * adjacent * phi1 * term_11
            + 2.0 * factor_3 * k * one_minus_e_squared * opposite * phi1 * term_12
            - 3.0 * term_8 * term_7
            - 3.0 * factor * one_minus_e_squared * opposite_squared * term_6
        ),
        2.0
        * e
        * k_squared
        * one_minus_e
        * one_plus_e
        * R1
        / _square(R2)
        * term
        * term_3
        * (
            3.0 * term_8 * term_7
            + 3.0 * factor * one_minus_e_squared * opposite_squared * term_6
            - 3.0 * term_9 * term_10
            - 3.0 * factor_3 * one_plus_e_squared * adjacent_squared * term_5
            - 4.0 * factor_2 * k * adjacent_cubed * opposite_cubed * phi1
            - 2.0 * factor * k * one_plus_e_squared * adjacent * phi1 * term_11
            - 2.0 * factor_3 * k * one_minus_e_squared * opposite * phi1 * term_12
        ),
        2.0
        * (k * _square(k))
        * term
        * term_3
        * (
            factor_4 * term_9 * term_10
            + factor_5 * one_plus_e_squared * adjacent_squared * term_5
            - factor_7 * term_8 * term_7
            - factor_6 * one_minus_e_squared * opposite_squared * term_6
        ),
    )


# Source: extremes of the derivatives of Prikhodko et al. 2024, equation (8)
# Expressions sha256: a85abae185ec7d0329d3bd9920c4c7b3d3c715aa127fad0ac69ee772a0c30096
# Form: backward pass
# Operations: 165
def largest_acceleration(
    R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `largest_acceleration` by its arguments, in their order.

    In 1 per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where 1e-300 <=
    R1 and 1e-300 <= R2 and R1 <= 1e75*R2.

    """
    R1, R2, e = _as_floats("R1 R2 e", R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_largest_ratio, R1, R2, e)
    return _in_blocks(
        _form_of_largest_acceleration,
        (R1,),
        _prepare_of_largest_acceleration,
        (R2, e),
        out=out,
        shape=(3,),
    )


def _prepare_of_largest_acceleration(R2: Any, e: Any) -> tuple[Any, ...]:
    one_plus_e = 1.0 + e
    one_minus_e = 1.0 - e
    term_16 = 1.0 / _square(one_minus_e)
    e_squared = _square(e)
    square = 1.0 + e_squared
    term_10 = 32.0 * e_squared + _square(square)
    root_acceleration = _np.sqrt(term_10)
    term_18 = root_acceleration + square
    one_plus_e_squared = _square(one_plus_e)
    term_17 = 6.0 * e + root_acceleration
    term_14 = 1.0 / term_17
    peak_acceleration = 1.0 + one_plus_e_squared * term_14
    term_15 = 8.0 * e + root_acceleration + square
    term_7 = _np.sqrt(peak_acceleration * term_15)
    term_11 = root_acceleration + square + 2.0 * e * peak_acceleration
    term_8 = 1.0 / _square(term_11)
    term_9 = 1.0 / (term_11 * _square(term_11))
    term_13 = 1.0 / term_15
    term_12 = 1.0 / _square(term_17)
    term_6 = 1.0 / _np.sqrt(term_10)

    return (
        R2,
        e,
        one_plus_e,
        one_minus_e,
        term_16,
        e_squared,
        square,
        root_acceleration,
        term_18,
        one_plus_e_squared,
        term_14,
        peak_acceleration,
        term_7,
        term_8,
        term_9,
        term_13,
        term_12,
        term_6,
    )


def _form_of_largest_acceleration(
    R1: Any,
    R2: Any,
    e: Any,
    one_plus_e: Any,
    one_minus_e: Any,
    term_16: Any,
    e_squared: Any,
    square: Any,
    root_acceleration: Any,
    term_18: Any,
    one_plus_e_squared: Any,
    term_14: Any,
    peak_acceleration: Any,
    term_7: Any,
    term_8: Any,
    term_9: Any,
    term_13: Any,
    term_12: Any,
    term_6: Any,
) -> Any:
    k = R1 / R2
    k_squared = _square(k)
    term_2 = (
        2.0
        * e
        * one_plus_e
        * term_13
        * term_16
        * term_18
        * term_7
        * term_8
        * (4.0 * e + root_acceleration / 2.0 + square / 2.0)
        / peak_acceleration
        * k_squared
        - 8.0 * e_squared * one_plus_e * term_16 * term_18 * term_7 * term_9 * k_squared
    )
    term_3 = e * one_plus_e * term_13 * term_16 * term_18 * term_7 * term_8 * k_squared
    term_4 = -4.0 * e * one_plus_e * term_16 * term_18 * term_7 * term_9 * k_squared
    term_5 = 2.0 * e * one_plus_e * term_16 * term_7 * term_8 * k_squared
    term = term_3 + term_4 + term_5 - one_plus_e_squared * term_12 * term_2

    return (
        4.0 * e * one_plus_e * term_16 * term_18 * term_7 * term_8 / R2 * k,
        -4.0 * e * one_plus_e * term_16 * term_18 * term_7 * term_8 / _square(R2) * k * R1,
        2.0 * e * (term_3 + term_4 + term_5 + square * term_6 * term)
        + (term_14 * (2.0 + 2.0 * e) - 6.0 * one_plus_e_squared * term_12) * term_2
        + 32.0 * e * term_6 * term
        + 2.0 * e * term_16 * term_18 * term_7 * term_8 * k_squared
        + 2.0 * one_plus_e * term_16 * term_18 * term_7 * term_8 * k_squared
        + 4.0
        * e
        * one_plus_e
        * term_18
        * term_7
        * term_8
        / (one_minus_e * _square(one_minus_e))
        * k_squared
        + 8.0 * e * one_plus_e * term_13 * term_16 * term_18 * term_7 * term_8 * k_squared
        - 8.0
        * e
        * one_plus_e
        * peak_acceleration
        * term_16
        * term_18
        * term_7
        * term_9
        * k_squared,
    )


# Source: extremes of the derivatives of Prikhodko et al. 2024, equation (8)
# Expressions sha256: bca6662de95627c884e6346854911fc06fbbd12d92b2a5071cac528bd5011614
# Form: backward pass
# Operations: 94
def angle_of_smallest_acceleration(
    R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `angle_of_smallest_acceleration` by its arguments, in their order.

    In rad per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where 1e-300
    <= R1 and 1e-300 <= R2 and R1 <= 1e75*R2.

    """
    R1, R2, e = _as_floats("R1 R2 e", R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_largest_ratio, R1, R2, e)
    return _in_blocks(
        _form_of_angle_of_smallest_acceleration,
        (R1,),
        _prepare_of_angle_of_smallest_acceleration,
        (R2, e),
        out=out,
        shape=(3,),
    )


def _prepare_of_angle_of_smallest_acceleration(R2: Any, e: Any) -> tuple[Any, ...]:
    one_minus_e = 1.0 - e
    one_plus_e_squared = _square(1.0 + e)
    e_squared = _square(e)
    square = 1.0 + e_squared
    term_7 = 32.0 * e_squared + _square(square)
    root_acceleration = _np.sqrt(term_7)
    term_12 = 6.0 * e + root_acceleration
    term_9 = 1.0 / term_12
    peak_acceleration = 1.0 + one_plus_e_squared * term_9
    root_peak_acceleration = _np.sqrt(peak_acceleration)
    term_10 = 8.0 * e + root_acceleration + square
    term_6 = _np.sqrt(term_10)
    term_2 = _np.arctan2(one_minus_e * root_peak_acceleration, term_6)
    term_3 = 1.0 / (8.0 * e + root_acceleration + square + peak_acceleration * _square(one_minus_e))
    term_5 = 1.0 / _np.sqrt(term_10)
    term_11 = 1.0 / _np.sqrt(peak_acceleration)
    term_8 = 1.0 / _square(term_12)
    term_4 = 1.0 / _np.sqrt(term_7)

    return (
        R2,
        e,
        one_minus_e,
        one_plus_e_squared,
        square,
        term_9,
        root_peak_acceleration,
        term_6,
        term_2,
        term_3,
        term_5,
        term_11,
        term_8,
        term_4,
    )


def _form_of_angle_of_smallest_acceleration(
    R1: Any,
    R2: Any,
    e: Any,
    one_minus_e: Any,
    one_plus_e_squared: Any,
    square: Any,
    term_9: Any,
    root_peak_acceleration: Any,
    term_6: Any,
    term_2: Any,
    term_3: Any,
    term_5: Any,
    term_11: Any,
    term_8: Any,
    term_4: Any,
) -> Any:
    k = R1 / R2
    term_13 = 1.0 / _square(k)
    term = (
        -one_minus_e * root_peak_acceleration * term_3 * term_5 / k
        - one_minus_e * one_plus_e_squared * term_11 * term_3 * term_6 * term_8 / k
    )

    return (
        -2.0 * term_2 / R2 * term_13,
        2.0 * term_2 / _square(R2) * term_13 * R1,
        2.0
        * e
        * (square * term_4 * term - one_minus_e * root_peak_acceleration * term_3 * term_5 / k)
        + (
            -2.0 * root_peak_acceleration * term_3 * term_6
            - 8.0 * one_minus_e * root_peak_acceleration * term_3 * term_5
        )
        / k
        + 32.0 * e * term_4 * term
        + one_minus_e
        * term_11
        * term_3
        * term_6
        * (term_9 * (2.0 + 2.0 * e) - 6.0 * one_plus_e_squared * term_8)
        / k,
    )


# Source: extremes of the derivatives of Prikhodko et al. 2024, equation (8)
# Expressions sha256: 5a71e52d640e61c0f31471cb680ed055f3f694b19f106047c7da802e5edb3369
# Form: backward pass
# Operations: 35
def smallest_jerk(
    R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `smallest_jerk` by its arguments, in their order.

    In 1 per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where 1e-300 <=
    R1 and 1e-300 <= R2 and R1 <= 1e75*R2.

    """
    R1, R2, e = _as_floats("R1 R2 e", R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_largest_ratio, R1, R2, e)
    return _in_blocks(
        _form_of_smallest_jerk, (R1,), _prepare_of_smallest_jerk, (R2, e), out=out, shape=(3,)
    )


def _prepare_of_smallest_jerk(R2: Any, e: Any) -> tuple[Any, ...]:
    one_plus_e = 1.0 + e
    one_minus_e = 1.0 - e
    term = 1.0 / (one_minus_e * _square(one_minus_e))

    return (R2, e, one_plus_e, one_minus_e, term)


def _form_of_smallest_jerk(
    R1: Any, R2: Any, e: Any, one_plus_e: Any, one_minus_e: Any, term: Any
) -> Any:
    k = R1 / R2
    k_squared = _square(k)
    k_cubed = k * _square(k)

    return (
        -6.0 * e * one_plus_e * term / R2 * k_squared,
        6.0 * e * one_plus_e * term / _square(R2) * k_squared * R1,
        -2.0 * e * term * k_cubed
        - 2.0 * one_plus_e * term * k_cubed
        - 6.0 * e * one_plus_e / _square(_square(one_minus_e)) * k_cubed,
    )


# Source: inverse of the extremes of Prikhodko et al. 2024, equation (8)
# Expressions sha256: 50a7809cf35f42ce95fa66737d406d3444895d65599c588544c3fc3aa183e93c
# Form: backward pass
# Operations: 18
def eccentricity_of_largest_ratio(
    largest: ArrayLike, R1: ArrayLike, R2: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `eccentricity_of_largest_ratio` by its arguments, in their order.

    In 1 per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where R1 <=
    1e100*R2.

    """
    largest, R1, R2 = _as_floats("largest R1 R2", largest, R1, R2)
    largest, R1, R2 = _nan_outside(_check_of_eccentricity_of_largest_ratio, largest, R1, R2)
    return _in_blocks(
        _form_of_eccentricity_of_largest_ratio,
        (largest,),
        _prepare_of_eccentricity_of_largest_ratio,
        (R1, R2),
        out=out,
        shape=(3,),
    )


def _check_of_eccentricity_of_largest_ratio(largest: Any, R1: Any, R2: Any) -> tuple[Any, ...]:
    return (
        _is_positive(R1),
        _is_positive(R2),
        R2 < R1,
        largest > 1.0,
        _is_finite(largest),
        R1 <= R2 * (largest - 1.0),
    )


def _prepare_of_eccentricity_of_largest_ratio(R1: Any, R2: Any) -> tuple[Any, ...]:
    k = R1 / R2

    return (R1, R2, k)


def _form_of_eccentricity_of_largest_ratio(largest: Any, R1: Any, R2: Any, k: Any) -> Any:
    k_plus_largest_minus_one = k + largest - 1.0
    term_3 = 1.0 / k_plus_largest_minus_one
    term_2 = 1.0 / _square(k_plus_largest_minus_one)
    term_4 = largest - 1.0 - k
    term = -term_3 - term_2 * term_4

    return (
        term_3 - term_2 * term_4,
        term / R2,
        -R1 / _square(R2) * term,
    )


# Source: inverse of the extremes of Prikhodko et al. 2024, equation (8)
# Expressions sha256: eaf1acc0a1d0b45b93134cd977cfa1157f1b297cf8edcd01edaf4150f6eac48f
# Form: backward pass
# Operations: 18
def eccentricity_of_smallest_ratio(
    smallest: ArrayLike, R1: ArrayLike, R2: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `eccentricity_of_smallest_ratio` by its arguments, in their order.

    In 1 per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where R1 <=
    1e100*R2.

    """
    smallest, R1, R2 = _as_floats("smallest R1 R2", smallest, R1, R2)
    smallest, R1, R2 = _nan_outside(_check_of_eccentricity_of_smallest_ratio, smallest, R1, R2)
    return _in_blocks(
        _form_of_eccentricity_of_smallest_ratio,
        (smallest,),
        _prepare_of_eccentricity_of_largest_ratio,
        (R1, R2),
        out=out,
        shape=(3,),
    )


def _check_of_eccentricity_of_smallest_ratio(smallest: Any, R1: Any, R2: Any) -> tuple[Any, ...]:
    return (
        _is_positive(R1),
        _is_positive(R2),
        R2 < R1,
        smallest > 1.0,
        _is_finite(smallest),
        R2 * (smallest - 1.0) <= R1,
    )


def _form_of_eccentricity_of_smallest_ratio(smallest: Any, R1: Any, R2: Any, k: Any) -> Any:
    term_4 = k + smallest - 1.0
    term_3 = 1.0 / term_4
    term_2 = 1.0 / _square(term_4)
    term_5 = 1.0 + k - smallest
    term = term_3 - term_2 * term_5

    return (
        -term_3 - term_2 * term_5,
        term / R2,
        -R1 / _square(R2) * term,
    )


# Source: inverse of the extremes of Prikhodko et al. 2024, equation (8)
# Expressions sha256: f61491813f74a685e5e518eb23d26f1fa8fec5513a49943966e9016e2314672e
# Form: backward pass
# Operations: 64
def eccentricity_of_quotient(
    quotient: ArrayLike, R1: ArrayLike, R2: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `eccentricity_of_quotient` by its arguments, in their order.

    In 1 per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where R1 <=
    1e100*R2 and quotient <= 1e100.

    """
    quotient, R1, R2 = _as_floats("quotient R1 R2", quotient, R1, R2)
    quotient, R1, R2 = _nan_outside(_check_of_eccentricity_of_quotient, quotient, R1, R2)
    return _in_blocks(
        _form_of_eccentricity_of_quotient,
        (quotient,),
        _prepare_of_eccentricity_of_quotient,
        (R1, R2),
        out=out,
        shape=(3,),
    )


def _check_of_eccentricity_of_quotient(quotient: Any, R1: Any, R2: Any) -> tuple[Any, ...]:
    return (_is_positive(R1), _is_positive(R2), R2 < R1, quotient >= 1.0, _is_finite(quotient))


def _prepare_of_eccentricity_of_quotient(R1: Any, R2: Any) -> tuple[Any, ...]:
    k = R1 / R2
    k_squared = _square(k)

    return (R1, R2, k, k_squared)


def _form_of_eccentricity_of_quotient(
    quotient: Any, R1: Any, R2: Any, k: Any, k_squared: Any
) -> Any:
    term_13 = 4.0 * k_squared + quotient - 1.0
    quotient_minus_one = quotient - 1.0
    term_12 = _square(quotient_minus_one) + 4.0 * k_squared * quotient
    term_11 = _np.sqrt(term_12)
    term_9 = 2.0 * k + term_11
    term_8 = 1.0 / term_9
    term_2 = 1.0 + term_13 * term_8
    term_6 = 2.0 * k + quotient + term_11 - 1.0
    term_4 = 1.0 / term_6
    term_10 = 1.0 / _np.sqrt(term_12)
    term_14 = 2.0 * k_squared + quotient - 1.0
    term_7 = 1.0 / _square(term_9)
    term_3 = 1.0 / _square(term_6)
    term_5 = -2.0 - 4.0 * k * quotient * term_10
    term = (
        quotient_minus_one * term_4 * (8.0 * k * term_8 + term_13 * term_5 * term_7)
        + quotient_minus_one * term_2 * term_3 * term_5
    )

    return (
        term_2 * term_4
        + quotient_minus_one * term_4 * (term_8 - term_10 * term_13 * term_14 * term_7)
        + quotient_minus_one * term_2 * term_3 * (-1.0 - term_10 * term_14),
        term / R2,
        -R1 / _square(R2) * term,
    )


# Source: inverse of the extremes of Prikhodko et al. 2024, equation (8)
# Expressions sha256: f5d9211e35a8d249b9a6274471882b683ba3e263ed17a42cb2d618b0d49b1e69
# Form: backward pass
# Operations: 20
def eccentricity_of_extremes(
    largest: ArrayLike, smallest: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `eccentricity_of_extremes` by its arguments, in their order.

    In 1 per unit of each argument. Accuracy, tested: 4 eps of its conditioning.

    """
    largest, smallest = _as_floats("largest smallest", largest, smallest)
    largest, smallest = _nan_outside(_check_of_eccentricity_of_extremes, largest, smallest)
    return _in_blocks(
        _form_of_eccentricity_of_extremes,
        (largest,),
        _prepare_of_eccentricity_of_extremes,
        (smallest,),
        out=out,
        shape=(2,),
    )


def _check_of_eccentricity_of_extremes(largest: Any, smallest: Any) -> tuple[Any, ...]:
    return (
        smallest > 1.0,
        _is_finite(smallest),
        largest > 1.0,
        _is_finite(largest),
        smallest <= largest,
        (largest - 1.0) * (smallest - 1.0) > 1.0,
    )


def _prepare_of_eccentricity_of_extremes(smallest: Any) -> tuple[Any, ...]:
    smallest_minus_one = smallest - 1.0

    return (smallest, smallest_minus_one)


def _form_of_eccentricity_of_extremes(largest: Any, smallest: Any, smallest_minus_one: Any) -> Any:
    largest_minus_one = largest - 1.0
    term_3 = _np.sqrt(largest_minus_one) + _np.sqrt(smallest_minus_one)
    term = 1.0 / _square(term_3)
    largest_minus_smallest = largest - smallest
    term_2 = 1.0 / (term_3 * _square(term_3))

    return (
        term - largest_minus_smallest * term_2 / _np.sqrt(largest_minus_one),
        -term - largest_minus_smallest * term_2 / _np.sqrt(smallest_minus_one),
    )


# Source: inverse of the extremes of Prikhodko et al. 2024, equation (8)
# Expressions sha256: f57fc02c2e2308da69a46e658adcb2566f298cf2241f0b1a1afb00bdc06f4097
# Form: backward pass
# Operations: 16
def radii_of_extremes(
    largest: ArrayLike, smallest: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `radii_of_extremes` by its arguments, in their order.

    In 1 per unit of each argument. Accuracy, tested: 4 eps of its conditioning.

    """
    largest, smallest = _as_floats("largest smallest", largest, smallest)
    largest, smallest = _nan_outside(_check_of_eccentricity_of_extremes, largest, smallest)
    return _in_blocks(
        _form_of_radii_of_extremes,
        (largest,),
        _prepare_of_radii_of_extremes,
        (smallest,),
        out=out,
        shape=(2,),
    )


def _prepare_of_radii_of_extremes(smallest: Any) -> tuple[Any, ...]:
    smallest_minus_one = smallest - 1.0
    term_3 = 1.0 / smallest_minus_one

    return (smallest, smallest_minus_one, term_3)


def _form_of_radii_of_extremes(
    largest: Any, smallest: Any, smallest_minus_one: Any, term_3: Any
) -> Any:
    largest_minus_one = largest - 1.0
    term = _np.sqrt(smallest_minus_one * largest_minus_one)
    term_2 = 1.0 / largest_minus_one

    return (
        term_3 * (smallest / 2.0 - 0.5) * term * term_2,
        term_3 * term * term_2 * (largest / 2.0 - 0.5),
    )
