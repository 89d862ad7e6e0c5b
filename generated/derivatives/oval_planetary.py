"""Partial derivatives of the kernels of `oval_planetary`, by every argument.

Prikhodko, Kurapov, Belina, Azizov, Polivoda 2024, planetary mechanism with oval wheels, EDN
HZWKZJ

Arguments, domain, `out` and errors are those of the kernel with the same name, one module
up; along a last axis the result has the derivative by each argument, in their order.

At a kink a derivative is that on the side of the greater argument; at a pole it is infinite
or NaN. Each is proved to follow from the definition by the chain rule. Accuracy is tested:
the error of an entry d is at most the stated multiple of eps = 2**-52 times its condition,
|d| + the sum of |p * d d/d p| over the arguments and the symbols p of the kernel's formula,
plus, if the kernel's own error has a scale, that scale divided by the argument (the first
counts as at most 1 rad or mm).

Generated from the derivation oval_planetary with SymPy 1.14.0.
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
    sum_rest as _sum_rest,
)
from mechproof.kernel_support.functions import square as _square

__all__ = [
    "acceleration",
    "acceleration_cylindrical",
    "jerk",
    "jerk_cylindrical",
    "position",
    "position_cylindrical",
    "ratio",
    "ratio_cylindrical",
]


def __dir__() -> list[str]:
    return __all__


# Source: Prikhodko et al. 2024 (oval wheels), equation (10)
# Expressions sha256: 7920190c68e7d3de17dd66dce463bd6ef591a4a5c06392619e916e4dc7dfe39e
# Form: backward pass
# Operations: 169
def ratio(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> NDArray[Any]:
    """Differentiate `ratio` by its arguments, in their order.

    In 1 per unit of each argument. Accuracy, tested: 4 eps of its conditioning.

    """
    phi1, e1, e2, mount = _as_floats("phi1 e1 e2 mount", phi1, e1, e2, mount)
    e1, e2 = _nan_outside(_check_of_ratio, e1, e2)
    return _in_blocks(
        _form_of_ratio, (phi1,), _prepare_of_ratio, (e1, e2, mount), out=out, shape=(4,)
    )


def _check_of_ratio(e1: Any, e2: Any) -> tuple[Any, ...]:
    return (e1 >= 0.0, e1 < 1.0, e2 >= 0.0, e2 < 1.0)


def _prepare_of_ratio(e1: Any, e2: Any, mount: Any) -> tuple[Any, ...]:
    one_plus_e1 = 1.0 + e1
    one_plus_e2 = 1.0 + e2
    both = one_plus_e1 * one_plus_e2
    one_minus_e1 = 1.0 - e1
    one_minus_e2 = 1.0 - e2
    less = one_minus_e1 * one_minus_e2
    sin_mount = _np.sin(mount)
    term_8 = 1.0 / one_minus_e2
    lever = 4.0 * e2 * sin_mount * term_8
    shift = lever * one_minus_e1 * sin_mount
    less_plus_shift = less + shift
    both_squared = _square(both)
    less_squared = _square(less)
    shift_squared = _square(shift)
    cos_mount = _np.cos(mount)
    rise = cos_mount * lever * one_plus_e1
    rise_squared = _square(rise)

    return (
        e1,
        e2,
        one_plus_e1,
        one_plus_e2,
        both,
        one_minus_e1,
        one_minus_e2,
        less,
        sin_mount,
        term_8,
        lever,
        shift,
        less_plus_shift,
        both_squared,
        less_squared,
        shift_squared,
        cos_mount,
        rise,
        rise_squared,
    )


def _form_of_ratio(
    phi1: Any,
    e1: Any,
    e2: Any,
    one_plus_e1: Any,
    one_plus_e2: Any,
    both: Any,
    one_minus_e1: Any,
    one_minus_e2: Any,
    less: Any,
    sin_mount: Any,
    term_8: Any,
    lever: Any,
    shift: Any,
    less_plus_shift: Any,
    both_squared: Any,
    less_squared: Any,
    shift_squared: Any,
    cos_mount: Any,
    rise: Any,
    rise_squared: Any,
) -> Any:
    sin_phi1 = _np.sin(phi1)
    sin_phi1_squared = _square(sin_phi1)
    cos_phi1 = _np.cos(phi1)
    cos_phi1_squared = _square(cos_phi1)
    term_6 = (
        both_squared * sin_phi1_squared
        + less_squared * cos_phi1_squared
        + shift_squared * cos_phi1_squared
        + rise_squared * sin_phi1_squared
        + 2.0 * less * shift * cos_phi1_squared
        + 2.0 * less * rise * cos_phi1 * sin_phi1
        + 2.0 * rise * shift * cos_phi1 * sin_phi1
    )
    term_4 = 1.0 / _square(term_6)
    term_5 = 1.0 / term_6
    term_3 = (
        2.0 * both_squared * less_plus_shift * sin_phi1_squared * term_4 - less_plus_shift * term_5
    )
    term_2 = -both * term_5 - both * less_plus_shift * term_4 * (
        -2.0 * less * cos_phi1_squared
        - 2.0 * shift * cos_phi1_squared
        - 2.0 * rise * cos_phi1 * sin_phi1
    )
    term_7 = (
        -2.0 * rise * sin_phi1_squared
        - 2.0 * less * cos_phi1 * sin_phi1
        - 2.0 * shift * cos_phi1 * sin_phi1
    )
    term = (
        one_minus_e1 * sin_mount * term_2
        - both * cos_mount * less_plus_shift * one_plus_e1 * term_4 * term_7
    )

    return (
        -both
        * less_plus_shift
        * term_4
        * (
            2.0 * less_squared * cos_phi1 * sin_phi1
            + 2.0 * shift_squared * cos_phi1 * sin_phi1
            + 2.0 * less * rise * sin_phi1_squared
            + 2.0 * rise * shift * sin_phi1_squared
            + 4.0 * less * shift * cos_phi1 * sin_phi1
            - 2.0 * both_squared * cos_phi1 * sin_phi1
            - 2.0 * rise_squared * cos_phi1 * sin_phi1
            - 2.0 * less * rise * cos_phi1_squared
            - 2.0 * rise * shift * cos_phi1_squared
        ),
        one_plus_e2 * term_3
        + (e2 - 1.0) * term_2
        - lever * sin_mount * term_2
        - both * cos_mount * less_plus_shift * lever * term_4 * term_7,
        one_plus_e1 * term_3
        + (4.0 * sin_mount * term_8 + 4.0 * e2 * sin_mount / _square(one_minus_e2)) * term
        + (e1 - 1.0) * term_2,
        4.0 * cos_mount * e2 * term_8 * term
        + cos_mount * lever * one_minus_e1 * term_2
        + both * less_plus_shift * lever * one_plus_e1 * sin_mount * term_4 * term_7,
    )


# Source: Prikhodko et al. 2024 (oval wheels), integral (11)
# Expressions sha256: c760e6e470354eef93e934050bae7358e13ad55aa8e100ade8f65ea89704ea2c
# Form: backward pass
# Operations: 145
def position(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> NDArray[Any]:
    """Differentiate `position` by its arguments, in their order.

    In rad per unit of each argument. Accuracy, tested: 16 eps of its conditioning, where (phi1
    = 0 or e1 + e2 = 0 or 2**-960 <= (e1 + e2)*|phi1|) and (e2 = 0 or mount = 0 or 2**-830 <=
    e2*|mount|) and e1 <= 999/1000 and e2 <= 999/1000.

    """
    phi1, e1, e2, mount = _as_floats("phi1 e1 e2 mount", phi1, e1, e2, mount)
    e1, e2 = _nan_outside(_check_of_ratio, e1, e2)
    return _in_blocks(
        _form_of_position, (phi1,), _prepare_of_position, (e1, e2, mount), out=out, shape=(4,)
    )


def _prepare_of_position(e1: Any, e2: Any, mount: Any) -> tuple[Any, ...]:
    sin_mount = _np.sin(mount)
    one_minus_e2 = 1.0 - e2
    term_8 = 1.0 / one_minus_e2
    lever = 4.0 * e2 * sin_mount * term_8
    one_minus_e1 = 1.0 - e1
    shift = lever * one_minus_e1 * sin_mount
    one_plus_e1 = 1.0 + e1
    one_plus_e2 = 1.0 + e2
    both = one_plus_e1 * one_plus_e2
    less = one_minus_e1 * one_minus_e2
    cos_mount = _np.cos(mount)
    rise = cos_mount * lever * one_plus_e1
    swing = 2.0 * e1 + 2.0 * e2

    return (
        e1,
        e2,
        sin_mount,
        one_minus_e2,
        term_8,
        lever,
        one_minus_e1,
        shift,
        one_plus_e1,
        one_plus_e2,
        both,
        less,
        cos_mount,
        rise,
        swing,
    )


def _form_of_position(
    phi1: Any,
    e1: Any,
    e2: Any,
    sin_mount: Any,
    one_minus_e2: Any,
    term_8: Any,
    lever: Any,
    one_minus_e1: Any,
    shift: Any,
    one_plus_e1: Any,
    one_plus_e2: Any,
    both: Any,
    less: Any,
    cos_mount: Any,
    rise: Any,
    swing: Any,
) -> Any:
    cos_phi1 = _np.cos(phi1)
    cos_phi1_squared = _square(cos_phi1)
    shift_cos_phi1_squared = shift * cos_phi1_squared
    sin_phi1 = _np.sin(phi1)
    sin_phi1_squared = _square(sin_phi1)
    term_6 = (
        shift_cos_phi1_squared
        + both * sin_phi1_squared
        + less * cos_phi1_squared
        + rise * cos_phi1 * sin_phi1
    )
    term_5 = 1.0 / (
        _square(term_6)
        + _square(
            rise * sin_phi1_squared + shift * cos_phi1 * sin_phi1 - swing * cos_phi1 * sin_phi1
        )
    )
    term_7 = swing * cos_phi1 * sin_phi1 - rise * sin_phi1_squared - shift * cos_phi1 * sin_phi1
    term_4 = -2.0 * cos_phi1 * sin_phi1 * term_5 * term_6
    term_2 = sin_phi1_squared * term_5 * term_6 + cos_phi1 * sin_phi1 * term_5 * term_7
    term_3 = cos_phi1_squared * term_5 * term_7 + cos_phi1 * sin_phi1 * term_5 * term_6
    term = cos_mount * one_plus_e1 * term_2 + one_minus_e1 * sin_mount * term_3

    return (
        term_5
        * term_6
        * (
            shift_cos_phi1_squared
            + swing * sin_phi1_squared
            + 2.0 * rise * cos_phi1 * sin_phi1
            - swing * cos_phi1_squared
            - shift * sin_phi1_squared
        )
        + term_5
        * term_7
        * (
            rise * cos_phi1_squared
            + 2.0 * both * cos_phi1 * sin_phi1
            - rise * sin_phi1_squared
            - 2.0 * less * cos_phi1 * sin_phi1
            - 2.0 * shift * cos_phi1 * sin_phi1
        ),
        term_4
        + cos_mount * lever * term_2
        + (e2 - 1.0) * cos_phi1_squared * term_5 * term_7
        + one_plus_e2 * sin_phi1_squared * term_5 * term_7
        - lever * sin_mount * term_3,
        term_4
        + (4.0 * sin_mount * term_8 + 4.0 * e2 * sin_mount / _square(one_minus_e2)) * term
        + (e1 - 1.0) * cos_phi1_squared * term_5 * term_7
        + one_plus_e1 * sin_phi1_squared * term_5 * term_7,
        4.0 * cos_mount * e2 * term_8 * term
        + cos_mount * lever * one_minus_e1 * term_3
        - lever * one_plus_e1 * sin_mount * term_2,
    )


# Source: Prikhodko et al. 2024 (oval wheels), derivative of (10)
# Expressions sha256: 0cbc9b5564086cfe79dd047a005528b4097b583be50ded0e9611fde936e52b07
# Form: backward pass
# Rewrites: low_product
# Operations: 328
def acceleration(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> NDArray[Any]:
    """Differentiate `acceleration` by its arguments, in their order.

    In 1 per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where (phi1 = 0
    or e1 + e2 = 0 or 2**-960 <= (e1 + e2)*|phi1|) and (e2 = 0 or mount = 0 or 2**-830 <=
    e2*|mount|).

    """
    phi1, e1, e2, mount = _as_floats("phi1 e1 e2 mount", phi1, e1, e2, mount)
    e1, e2 = _nan_outside(_check_of_ratio, e1, e2)
    return _in_blocks(
        _form_of_acceleration,
        (phi1,),
        _prepare_of_acceleration,
        (e1, e2, mount),
        out=out,
        shape=(4,),
    )


def _prepare_of_acceleration(e1: Any, e2: Any, mount: Any) -> tuple[Any, ...]:
    one_plus_e1 = 1.0 + e1
    one_plus_e2 = 1.0 + e2
    both_high = one_plus_e1 * one_plus_e2
    one_plus_e2_low = _sum_rest(1.0, e2, one_plus_e2)
    one_plus_e1_low = _sum_rest(1.0, e1, one_plus_e1)
    both_low = (
        one_plus_e1 * one_plus_e2_low
        + one_plus_e1_low * one_plus_e2
        + _product_rest(one_plus_e1, one_plus_e2, both_high)
    )
    both = both_high + both_low
    one_minus_e1 = 1.0 - e1
    one_minus_e2 = 1.0 - e2
    less_high = one_minus_e1 * one_minus_e2
    one_minus_e2_low = _sum_rest(1.0, -e2, one_minus_e2)
    one_minus_e1_low = _sum_rest(1.0, -e1, one_minus_e1)
    less_low = (
        one_minus_e1 * one_minus_e2_low
        + one_minus_e1_low * one_minus_e2
        + _product_rest(one_minus_e1, one_minus_e2, less_high)
    )
    less = less_high + less_low
    sin_mount = _np.sin(mount)
    lever = 4.0 * e2 * sin_mount / one_minus_e2
    shift = lever * one_minus_e1 * sin_mount
    less_plus_shift = less + shift
    both_squared = _square(both)
    less_squared = _square(less)
    shift_squared = _square(shift)
    cos_mount = _np.cos(mount)
    rise = cos_mount * lever * one_plus_e1
    rise_squared = _square(rise)
    swing = 2.0 * e1 + 2.0 * e2

    return (
        e1,
        e2,
        one_plus_e1,
        one_plus_e2,
        both,
        one_minus_e1,
        one_minus_e2,
        less,
        sin_mount,
        lever,
        shift,
        less_plus_shift,
        both_squared,
        less_squared,
        shift_squared,
        cos_mount,
        rise,
        rise_squared,
        swing,
    )


def _form_of_acceleration(
    phi1: Any,
    e1: Any,
    e2: Any,
    one_plus_e1: Any,
    one_plus_e2: Any,
    both: Any,
    one_minus_e1: Any,
    one_minus_e2: Any,
    less: Any,
    sin_mount: Any,
    lever: Any,
    shift: Any,
    less_plus_shift: Any,
    both_squared: Any,
    less_squared: Any,
    shift_squared: Any,
    cos_mount: Any,
    rise: Any,
    rise_squared: Any,
    swing: Any,
) -> Any:
    sin_phi1 = _np.sin(phi1)
    sin_phi1_squared = _square(sin_phi1)
    cos_phi1 = _np.cos(phi1)
    cos_phi1_squared = _square(cos_phi1)
    term_12 = (
        both_squared * sin_phi1_squared
        + less_squared * cos_phi1_squared
        + shift_squared * cos_phi1_squared
        + rise_squared * sin_phi1_squared
        + 2.0 * less * shift * cos_phi1_squared
        + 2.0 * less * rise * cos_phi1 * sin_phi1
        + 2.0 * rise * shift * cos_phi1 * sin_phi1
    )
    term_10 = 1.0 / _square(term_12)
    term_11 = 1.0 / (term_12 * _square(term_12))
    term_9 = (
        rise_squared * cos_phi1 * sin_phi1
        + less * rise * cos_phi1_squared
        + rise * shift * cos_phi1_squared
        + both * swing * cos_phi1 * sin_phi1
        + less * swing * cos_phi1 * sin_phi1
        - shift_squared * cos_phi1 * sin_phi1
        - less * rise * sin_phi1_squared
        - rise * shift * sin_phi1_squared
        - 2.0 * less * shift * cos_phi1 * sin_phi1
    )
    term_8 = (
        4.0
        * both
        * less_plus_shift
        * term_10
        * (both * cos_phi1 * sin_phi1 + less * cos_phi1 * sin_phi1)
    )
    term_4 = (
        2.0 * less_plus_shift * term_10 * term_9
        + 2.0 * both * less_plus_shift * swing * cos_phi1 * sin_phi1 * term_10
        - 8.0 * both_squared * less_plus_shift * sin_phi1_squared * term_11 * term_9
    )
    term_6 = (
        2.0
        * both
        * less_plus_shift
        * term_11
        * term_9
        * (
            -4.0 * less * cos_phi1_squared
            - 4.0 * shift * cos_phi1_squared
            - 4.0 * rise * cos_phi1 * sin_phi1
        )
    )
    term_7 = 2.0 * both * term_10 * term_9
    rise_cos_phi1_squared = rise * cos_phi1_squared
    term_13 = -2.0 * shift * cos_phi1 * sin_phi1
    term_3 = (
        term_6
        + term_7
        + 2.0
        * both
        * less_plus_shift
        * term_10
        * (rise_cos_phi1_squared + term_13 + swing * cos_phi1 * sin_phi1 - rise * sin_phi1_squared)
    )
    term_5 = 2.0 * both * less_plus_shift * term_10 * (
        less * cos_phi1_squared
        + shift * cos_phi1_squared
        + 2.0 * rise * cos_phi1 * sin_phi1
        - less * sin_phi1_squared
        - shift * sin_phi1_squared
    ) + 2.0 * both * less_plus_shift * term_11 * term_9 * (
        -4.0 * rise * sin_phi1_squared
        - 4.0 * less * cos_phi1 * sin_phi1
        - 4.0 * shift * cos_phi1 * sin_phi1
    )
    term_2 = (
        term_6
        + term_7
        + 2.0
        * both
        * less_plus_shift
        * term_10
        * (
            rise_cos_phi1_squared
            + term_13
            - rise * sin_phi1_squared
            - 2.0 * less * cos_phi1 * sin_phi1
        )
    )
    term = cos_mount * one_plus_e1 * term_5 + one_minus_e1 * sin_mount * term_2

    return (
        2.0
        * both
        * less_plus_shift
        * term_10
        * (
            rise_squared * cos_phi1_squared
            + shift_squared * sin_phi1_squared
            + both * swing * cos_phi1_squared
            + less * swing * cos_phi1_squared
            + 2.0 * less * shift * sin_phi1_squared
            - shift_squared * cos_phi1_squared
            - rise_squared * sin_phi1_squared
            - both * swing * sin_phi1_squared
            - 2.0 * less * shift * cos_phi1_squared
            - less * swing * sin_phi1_squared
            - 4.0 * less * rise * cos_phi1 * sin_phi1
            - 4.0 * rise * shift * cos_phi1 * sin_phi1
        )
        + 2.0
        * both
        * less_plus_shift
        * term_11
        * term_9
        * (
            4.0 * less_squared * cos_phi1 * sin_phi1
            + 4.0 * shift_squared * cos_phi1 * sin_phi1
            + 4.0 * less * rise * sin_phi1_squared
            + 4.0 * rise * shift * sin_phi1_squared
            + 8.0 * less * shift * cos_phi1 * sin_phi1
            - 4.0 * both_squared * cos_phi1 * sin_phi1
            - 4.0 * rise_squared * cos_phi1 * sin_phi1
            - 4.0 * less * rise * cos_phi1_squared
            - 4.0 * rise * shift * cos_phi1_squared
        ),
        term_8
        + one_plus_e2 * term_4
        + (e2 - 1.0) * term_3
        + cos_mount * lever * term_5
        - lever * sin_mount * term_2,
        term_8
        + one_plus_e1 * term_4
        + (4.0 * sin_mount / one_minus_e2 + 4.0 * e2 * sin_mount / _square(one_minus_e2)) * term
        + (e1 - 1.0) * term_3,
        4.0 * cos_mount * e2 / one_minus_e2 * term
        + cos_mount * lever * one_minus_e1 * term_2
        - lever * one_plus_e1 * sin_mount * term_5,
    )


# Source: Prikhodko et al. 2024 (oval wheels), equation (10), pair 4-5 cylindrical
# Expressions sha256: 0515c3c21243ecae839ea4e2996c99b953b47d367b8c085fde22c775f367547b
# Form: backward pass
# Rewrites: low_word, half_angle_tangent
# Operations: 76
def ratio_cylindrical(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `ratio_cylindrical` by its arguments, in their order.

    In 1 per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where |x| <=
    2**26.

    """
    phi1, R4, R5, e2 = _as_floats("phi1 R4 R5 e2", phi1, R4, R5, e2)
    R4, R5, e2 = _nan_outside(_check_of_ratio_cylindrical, R4, R5, e2)
    return _in_blocks(
        _form_of_ratio_cylindrical,
        (phi1,),
        _prepare_of_ratio_cylindrical,
        (R4, R5, e2),
        out=out,
        shape=(4,),
    )


def _check_of_ratio_cylindrical(R4: Any, R5: Any, e2: Any) -> tuple[Any, ...]:
    return (_is_positive(R4), _is_positive(R5), e2 >= 0.0, e2 < 1.0)


def _prepare_of_ratio_cylindrical(R4: Any, R5: Any, e2: Any) -> tuple[Any, ...]:
    k = R4 / R5
    k_low = _quotient_rest(R4, R5, k)
    one_minus_e2 = 1.0 - e2
    one_plus_e2 = 1.0 + e2
    one_minus_e2_squared = _square(one_minus_e2)
    one_plus_e2_squared = _square(one_plus_e2)

    return (
        R4,
        R5,
        e2,
        k,
        k_low,
        one_minus_e2,
        one_plus_e2,
        one_minus_e2_squared,
        one_plus_e2_squared,
    )


def _form_of_ratio_cylindrical(
    phi1: Any,
    R4: Any,
    R5: Any,
    e2: Any,
    k: Any,
    k_low: Any,
    one_minus_e2: Any,
    one_plus_e2: Any,
    one_minus_e2_squared: Any,
    one_plus_e2_squared: Any,
) -> Any:
    x = 2.0 * k * phi1
    t = _np.tan(x / 2.0)
    x_low = 2.0 * k_low * phi1 + 2.0 * _product_rest(k, phi1, x / 2.0)
    t_low = _small_tangent(x_low / 2.0)
    adjacent = 1.0 - t * t_low
    opposite = t + t_low
    adjacent_squared = _square(adjacent)
    term_2 = one_minus_e2_squared * adjacent_squared
    opposite_squared = _square(opposite)
    term_3 = one_plus_e2_squared * opposite_squared
    term = 1.0 / _square(term_2 + term_3)
    term_4 = adjacent_squared + opposite_squared
    one_plus_e2_opposite = one_plus_e2 * opposite

    return (
        8.0 * e2 * one_minus_e2 * one_plus_e2 * _square(k) * adjacent * opposite * term * term_4,
        one_minus_e2
        * one_plus_e2
        / R5
        * term
        * term_4
        * (
            8.0 * e2 * k * adjacent * opposite * phi1
            - one_minus_e2_squared * adjacent_squared
            - one_plus_e2_squared * opposite_squared
        ),
        one_minus_e2
        * one_plus_e2
        * R4
        / _square(R5)
        * term
        * term_4
        * (term_2 + term_3 - 8.0 * e2 * k * adjacent * opposite * phi1),
        2.0
        * k
        * term
        * term_4
        * (one_plus_e2_opposite + one_minus_e2 * adjacent)
        * (one_plus_e2_opposite - one_minus_e2 * adjacent),
    )


# Source: Prikhodko et al. 2024 (oval wheels), integral (11), pair 4-5 cylindrical
# Expressions sha256: 786a92b6f985f3d099ac08874d9d40e97c4d1da33073a13a9566ad20f14f59a2
# Form: backward pass
# Rewrites: positive_atan2, low_word, half_angle_tangent
# Operations: 54
def position_cylindrical(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `position_cylindrical` by its arguments, in their order.

    In rad per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where |x| <=
    2**26 and (e2 = 0 or phi1 = 0 or 2**-960 <= e2*|phi1|).

    """
    phi1, R4, R5, e2 = _as_floats("phi1 R4 R5 e2", phi1, R4, R5, e2)
    R4, R5, e2 = _nan_outside(_check_of_ratio_cylindrical, R4, R5, e2)
    return _in_blocks(
        _form_of_position_cylindrical,
        (phi1,),
        _prepare_of_position_cylindrical,
        (R4, R5, e2),
        out=out,
        shape=(4,),
    )


def _prepare_of_position_cylindrical(R4: Any, R5: Any, e2: Any) -> tuple[Any, ...]:
    k = R4 / R5
    k_low = _quotient_rest(R4, R5, k)
    one_minus_e2 = 1.0 - e2
    one_plus_e2 = 1.0 + e2

    return (R4, R5, e2, k, k_low, one_minus_e2, one_plus_e2)


def _form_of_position_cylindrical(
    phi1: Any, R4: Any, R5: Any, e2: Any, k: Any, k_low: Any, one_minus_e2: Any, one_plus_e2: Any
) -> Any:
    x = 2.0 * k * phi1
    t = _np.tan(x / 2.0)
    x_low = 2.0 * k_low * phi1 + 2.0 * _product_rest(k, phi1, x / 2.0)
    t_low = _small_tangent(x_low / 2.0)
    adjacent = 1.0 - t * t_low
    adjacent_squared = _square(adjacent)
    opposite = t + t_low
    opposite_squared = _square(opposite)
    term = 1.0 / (
        _square(one_minus_e2) * adjacent_squared + _square(one_plus_e2) * opposite_squared
    )
    term_2 = adjacent_squared + opposite_squared

    return (
        (R5 - R4) / R5
        + 2.0 * e2 * k * term * (one_plus_e2 * opposite_squared - one_minus_e2 * adjacent_squared),
        -one_minus_e2 * one_plus_e2 / R5 * phi1 * term * term_2,
        one_minus_e2 * one_plus_e2 * R4 / _square(R5) * phi1 * term * term_2,
        -2.0 * adjacent * opposite * term,
    )


# Source: Prikhodko et al. 2024 (oval wheels), derivative of (10), pair 4-5 cylindrical
# Expressions sha256: 78a53324c84796ca0c74f3da523e1d3ca0d190c516dc0cb9b29bc3398342aaa1
# Form: backward pass
# Rewrites: low_word, half_angle_tangent
# Operations: 133
def acceleration_cylindrical(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `acceleration_cylindrical` by its arguments, in their order.

    In 1 per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where |x| <=
    2**26 and R5/1e45 <= R4 <= 1e130*R5 and (e2 = 0 or phi1 = 0 or 2**-960 <= e2*|phi1|) and (e2
    = 0 or 2**-330 <= e2).

    """
    phi1, R4, R5, e2 = _as_floats("phi1 R4 R5 e2", phi1, R4, R5, e2)
    R4, R5, e2 = _nan_outside(_check_of_ratio_cylindrical, R4, R5, e2)
    return _in_blocks(
        _form_of_acceleration_cylindrical,
        (phi1,),
        _prepare_of_acceleration_cylindrical,
        (R4, R5, e2),
        out=out,
        shape=(4,),
    )


def _prepare_of_acceleration_cylindrical(R4: Any, R5: Any, e2: Any) -> tuple[Any, ...]:
    one_minus_e2 = 1.0 - e2
    one_plus_e2 = 1.0 + e2
    k = R4 / R5
    k_low = _quotient_rest(R4, R5, k)
    one_minus_e2_squared = _square(one_minus_e2)
    one_plus_e2_squared = _square(one_plus_e2)
    e2_squared = _square(e2)
    factor_2 = 1.0 + 4.0 * e2 + e2_squared
    factor = 1.0 + e2_squared - 4.0 * e2

    return (
        R4,
        R5,
        e2,
        one_minus_e2,
        one_plus_e2,
        k,
        k_low,
        one_minus_e2_squared,
        one_plus_e2_squared,
        factor_2,
        factor,
    )


def _form_of_acceleration_cylindrical(
    phi1: Any,
    R4: Any,
    R5: Any,
    e2: Any,
    one_minus_e2: Any,
    one_plus_e2: Any,
    k: Any,
    k_low: Any,
    one_minus_e2_squared: Any,
    one_plus_e2_squared: Any,
    factor_2: Any,
    factor: Any,
) -> Any:
    x = 2.0 * k * phi1
    t = _np.tan(x / 2.0)
    x_low = 2.0 * k_low * phi1 + 2.0 * _product_rest(k, phi1, x / 2.0)
    t_low = _small_tangent(x_low / 2.0)
    adjacent = 1.0 - t * t_low
    adjacent_squared = _square(adjacent)
    opposite = t + t_low
    opposite_squared = _square(opposite)
    base = one_minus_e2_squared * adjacent_squared + one_plus_e2_squared * opposite_squared
    term = 1.0 / (base * _square(base))
    term_2 = adjacent_squared + opposite_squared
    term_3 = _square(_square(adjacent))
    term_4 = _square(_square(opposite))
    opposite_cubed = opposite * _square(opposite)
    adjacent_cubed = adjacent * _square(adjacent)

    return (
        8.0
        * e2
        * one_minus_e2
        * one_plus_e2
        * (k * _square(k))
        * term
        * term_2
        * (
            one_minus_e2_squared * term_3
            - one_plus_e2_squared * term_4
            - 12.0 * e2 * adjacent_squared * opposite_squared
        ),
        8.0
        * e2
        * k
        * one_minus_e2
        * one_plus_e2
        / R5
        * term
        * term_2
        * (
            2.0 * one_plus_e2_squared * adjacent * opposite_cubed
            + 2.0 * one_minus_e2_squared * adjacent_cubed * opposite
            + k * one_minus_e2_squared * phi1 * term_3
            - k * one_plus_e2_squared * phi1 * term_4
            - 12.0 * e2 * k * adjacent_squared * opposite_squared * phi1
        ),
        8.0
        * e2
        * k
        * one_minus_e2
        * one_plus_e2
        * R4
        / _square(R5)
        * term
        * term_2
        * (
            k * one_plus_e2_squared * phi1 * term_4
            + 12.0 * e2 * k * adjacent_squared * opposite_squared * phi1
            - 2.0 * one_plus_e2_squared * adjacent * opposite_cubed
            - 2.0 * one_minus_e2_squared * adjacent_cubed * opposite
            - k * one_minus_e2_squared * phi1 * term_3
        ),
        8.0
        * _square(k)
        * adjacent
        * opposite
        * term
        * term_2
        * (
            factor_2 * one_minus_e2_squared * adjacent_squared
            + factor * one_plus_e2_squared * opposite_squared
        ),
    )


# Source: Prikhodko et al. 2024 (oval wheels), second derivative of (10)
# Expressions sha256: ae49c90d9f8a8ae62a23f9cc374615b9792573021cf30b8a5e06f9a7519b485f
# Form: backward pass
# Rewrites: low_product
# Operations: 1731
def jerk(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> NDArray[Any]:
    """Differentiate `jerk` by its arguments, in their order.

    In 1 per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where (phi1 = 0
    or e1 + e2 = 0 or 2**-960 <= (e1 + e2)*|phi1|) and (e2 = 0 or mount = 0 or 2**-830 <=
    e2*|mount|).

    """
    phi1, e1, e2, mount = _as_floats("phi1 e1 e2 mount", phi1, e1, e2, mount)
    e1, e2 = _nan_outside(_check_of_ratio, e1, e2)
    return _in_blocks(
        _form_of_jerk, (phi1,), _prepare_of_jerk, (e1, e2, mount), out=out, shape=(4,)
    )


def _prepare_of_jerk(e1: Any, e2: Any, mount: Any) -> tuple[Any, ...]:
    one_plus_e1 = 1.0 + e1
    one_plus_e2 = 1.0 + e2
    both_high = one_plus_e1 * one_plus_e2
    one_plus_e2_low = _sum_rest(1.0, e2, one_plus_e2)
    one_plus_e1_low = _sum_rest(1.0, e1, one_plus_e1)
    both_low = (
        one_plus_e1 * one_plus_e2_low
        + one_plus_e1_low * one_plus_e2
        + _product_rest(one_plus_e1, one_plus_e2, both_high)
    )
    both = both_high + both_low
    one_minus_e1 = 1.0 - e1
    one_minus_e2 = 1.0 - e2
    less_high = one_minus_e1 * one_minus_e2
    one_minus_e2_low = _sum_rest(1.0, -e2, one_minus_e2)
    one_minus_e1_low = _sum_rest(1.0, -e1, one_minus_e1)
    less_low = (
        one_minus_e1 * one_minus_e2_low
        + one_minus_e1_low * one_minus_e2
        + _product_rest(one_minus_e1, one_minus_e2, less_high)
    )
    less = less_high + less_low
    sin_mount = _np.sin(mount)
    lever = 4.0 * e2 * sin_mount / one_minus_e2
    shift = lever * one_minus_e1 * sin_mount
    less_plus_shift = less + shift
    both_squared = _square(both)
    less_squared = _square(less)
    shift_squared = _square(shift)
    cos_mount = _np.cos(mount)
    rise = cos_mount * lever * one_plus_e1
    rise_squared = _square(rise)
    term_44 = _square(_square(rise))
    rise_cubed = rise * _square(rise)
    less_cubed = less * _square(less)
    term_45 = _square(_square(shift))
    shift_cubed = shift * _square(shift)
    swing = 2.0 * e1 + 2.0 * e2
    swing_squared = _square(swing)
    both_cubed = both * _square(both)

    return (
        e1,
        e2,
        one_plus_e1,
        one_plus_e2,
        both,
        one_minus_e1,
        one_minus_e2,
        less,
        sin_mount,
        lever,
        shift,
        less_plus_shift,
        both_squared,
        less_squared,
        shift_squared,
        cos_mount,
        rise,
        rise_squared,
        term_44,
        rise_cubed,
        less_cubed,
        term_45,
        shift_cubed,
        swing,
        swing_squared,
        both_cubed,
    )


def _form_of_jerk(
    phi1: Any,
    e1: Any,
    e2: Any,
    one_plus_e1: Any,
    one_plus_e2: Any,
    both: Any,
    one_minus_e1: Any,
    one_minus_e2: Any,
    less: Any,
    sin_mount: Any,
    lever: Any,
    shift: Any,
    less_plus_shift: Any,
    both_squared: Any,
    less_squared: Any,
    shift_squared: Any,
    cos_mount: Any,
    rise: Any,
    rise_squared: Any,
    term_44: Any,
    rise_cubed: Any,
    less_cubed: Any,
    term_45: Any,
    shift_cubed: Any,
    swing: Any,
    swing_squared: Any,
    both_cubed: Any,
) -> Any:
    sin_phi1 = _np.sin(phi1)
    sin_phi1_squared = _square(sin_phi1)
    cos_phi1 = _np.cos(phi1)
    cos_phi1_squared = _square(cos_phi1)
    term_12 = (
        both_squared * sin_phi1_squared
        + less_squared * cos_phi1_squared
        + shift_squared * cos_phi1_squared
        + rise_squared * sin_phi1_squared
        + 2.0 * less * shift * cos_phi1_squared
        + 2.0 * less * rise * cos_phi1 * sin_phi1
        + 2.0 * rise * shift * cos_phi1 * sin_phi1
    )
    term_10 = 1.0 / (term_12 * _square(term_12))
    cos_phi1_cubed = cos_phi1 * _square(cos_phi1)
    term_42 = _square(_square(cos_phi1))
    term_43 = _square(_square(sin_phi1))
    sin_phi1_cubed = sin_phi1 * _square(sin_phi1)
    term_11 = 1.0 / _square(_square(term_12))
    term_8 = (
        both_squared * shift_squared * term_43
        + less_cubed * swing * term_42
        + both * less_squared * swing * term_42
        + both * shift_squared * swing * term_42
        + both_cubed * swing * cos_phi1_squared * sin_phi1_squared
        + both_squared * rise_squared * cos_phi1_squared * sin_phi1_squared
        + 2.0 * both_squared * less * shift * term_43
        + 2.0 * less * rise_cubed * cos_phi1 * sin_phi1_cubed
        + 2.0 * rise_cubed * shift * cos_phi1 * sin_phi1_cubed
        + 2.0 * rise * shift_cubed * cos_phi1_cubed * sin_phi1
        + 2.0 * less_cubed * shift * cos_phi1_squared * sin_phi1_squared
        + 6.0 * rise_squared * shift_squared * cos_phi1_squared * sin_phi1_squared
        + less * shift_squared * swing * term_42
        + 2.0 * less_squared * shift * swing * term_42
        + 7.0 * both * shift_squared * swing * cos_phi1_squared * sin_phi1_squared
        + 2.0 * both * less * shift * swing * term_42
        + both_squared * less * swing * cos_phi1_squared * sin_phi1_squared
        + 6.0 * less_squared * rise * swing * cos_phi1 * sin_phi1_cubed
        + 6.0 * less * rise * shift_squared * cos_phi1_cubed * sin_phi1
        + 12.0 * less * rise_squared * shift * cos_phi1_squared * sin_phi1_squared
        + 7.0 * less * shift_squared * swing * cos_phi1_squared * sin_phi1_squared
        + 14.0 * less_squared * shift * swing * cos_phi1_squared * sin_phi1_squared
        + 6.0 * both * less * rise * swing * cos_phi1 * sin_phi1_cubed
        + 6.0 * both * rise * shift * swing * cos_phi1 * sin_phi1_cubed
        + 14.0 * both * less * shift * swing * cos_phi1_squared * sin_phi1_squared
        + 6.0 * less * rise * shift * swing * cos_phi1 * sin_phi1_cubed
        - term_45 * term_42
        - term_44 * term_43
        - both_cubed * swing * term_43
        - both_squared * rise_squared * term_43
        - 3.0 * term_44 * cos_phi1_squared * sin_phi1_squared
        - 3.0 * term_45 * cos_phi1_squared * sin_phi1_squared
        - 4.0 * less * shift_cubed * term_42
        - 2.0 * less_cubed * shift * term_42
        - 3.0 * less_squared * rise_squared * term_42
        - 4.0 * less_squared * rise_squared * term_43
        - 5.0 * less_squared * shift_squared * term_42
        - 3.0 * rise_squared * shift_squared * term_42
        - 3.0 * rise_squared * shift_squared * term_43
        - both * rise_squared * swing * term_43
        - both_squared * shift_squared * cos_phi1_squared * sin_phi1_squared
        - 4.0 * both_squared * swing_squared * cos_phi1_squared * sin_phi1_squared
        - both_squared * less * swing * term_43
        - 6.0 * rise * shift_cubed * cos_phi1 * sin_phi1_cubed
        - 6.0 * less * rise_cubed * cos_phi1_cubed * sin_phi1
        - 4.0 * less_cubed * rise * cos_phi1_cubed * sin_phi1
        - 6.0 * rise_cubed * shift * cos_phi1_cubed * sin_phi1
        - 12.0 * less * shift_cubed * cos_phi1_squared * sin_phi1_squared
        - less_cubed * swing * cos_phi1_squared * sin_phi1_squared
        - less_squared * rise_squared * cos_phi1_squared * sin_phi1_squared
        - 11.0 * less_squared * shift_squared * cos_phi1_squared * sin_phi1_squared
        - 4.0 * less_squared * swing_squared * cos_phi1_squared * sin_phi1_squared
        - 6.0 * less * rise_squared * shift * term_42
        - 6.0 * less * rise_squared * shift * term_43
        - less * rise_squared * swing * term_43
        - 8.0 * both * less * swing_squared * cos_phi1_squared * sin_phi1_squared
        - both * less_squared * swing * cos_phi1_squared * sin_phi1_squared
        - 7.0 * both * rise_squared * swing * cos_phi1_squared * sin_phi1_squared
        - 4.0 * both_squared * less * rise * cos_phi1 * sin_phi1_cubed
        - 4.0 * both_squared * rise * shift * cos_phi1 * sin_phi1_cubed
        - 2.0 * both_squared * less * shift * cos_phi1_squared * sin_phi1_squared
        - 18.0 * less * rise * shift_squared * cos_phi1 * sin_phi1_cubed
        - 12.0 * less_squared * rise * shift * cos_phi1 * sin_phi1_cubed
        - 6.0 * less_squared * rise * swing * cos_phi1_cubed * sin_phi1
        - 7.0 * less * rise_squared * swing * cos_phi1_squared * sin_phi1_squared
        - 6.0 * both * less * rise * swing * cos_phi1_cubed * sin_phi1
        - 6.0 * both * rise * shift * swing * cos_phi1_cubed * sin_phi1
        - 6.0 * less * rise * shift * swing * cos_phi1_cubed * sin_phi1
    )
    term_9 = (
        4.0
        * both
        * less_plus_shift
        * term_10
        * (
            less_cubed * term_42
            + both * less_squared * term_42
            + both * shift_squared * term_42
            + both_cubed * cos_phi1_squared * sin_phi1_squared
            + less * shift_squared * term_42
            + 2.0 * less_squared * shift * term_42
            + 7.0 * both * shift_squared * cos_phi1_squared * sin_phi1_squared
            + 2.0 * both * less * shift * term_42
            + both_squared * less * cos_phi1_squared * sin_phi1_squared
            + 6.0 * less_squared * rise * cos_phi1 * sin_phi1_cubed
            + 7.0 * less * shift_squared * cos_phi1_squared * sin_phi1_squared
            + 14.0 * less_squared * shift * cos_phi1_squared * sin_phi1_squared
            + 6.0 * both * less * rise * cos_phi1 * sin_phi1_cubed
            + 6.0 * both * rise * shift * cos_phi1 * sin_phi1_cubed
            + 14.0 * both * less * shift * cos_phi1_squared * sin_phi1_squared
            + 6.0 * less * rise * shift * cos_phi1 * sin_phi1_cubed
            - both_cubed * term_43
            - both * rise_squared * term_43
            - both_squared * less * term_43
            - less_cubed * cos_phi1_squared * sin_phi1_squared
            - less * rise_squared * term_43
            - both * less_squared * cos_phi1_squared * sin_phi1_squared
            - 7.0 * both * rise_squared * cos_phi1_squared * sin_phi1_squared
            - 8.0 * both_squared * swing * cos_phi1_squared * sin_phi1_squared
            - 6.0 * less_squared * rise * cos_phi1_cubed * sin_phi1
            - 7.0 * less * rise_squared * cos_phi1_squared * sin_phi1_squared
            - 8.0 * less_squared * swing * cos_phi1_squared * sin_phi1_squared
            - 6.0 * both * less * rise * cos_phi1_cubed * sin_phi1
            - 6.0 * both * rise * shift * cos_phi1_cubed * sin_phi1
            - 16.0 * both * less * swing * cos_phi1_squared * sin_phi1_squared
            - 6.0 * less * rise * shift * cos_phi1_cubed * sin_phi1
        )
    )
    term_13 = -8.0 * both * swing_squared * cos_phi1_squared * sin_phi1_squared
    term_14 = -8.0 * less * swing_squared * cos_phi1_squared * sin_phi1_squared
    term_15 = -7.0 * rise_squared * swing * cos_phi1_squared * sin_phi1_squared
    term_17 = 7.0 * shift_squared * swing * cos_phi1_squared * sin_phi1_squared
    term_18 = -6.0 * less * rise * swing * cos_phi1_cubed * sin_phi1
    term_19 = -6.0 * rise * shift * swing * cos_phi1_cubed * sin_phi1
    term_20 = 14.0 * less * shift * swing * cos_phi1_squared * sin_phi1_squared
    term_27 = 6.0 * less * rise * swing * cos_phi1 * sin_phi1_cubed
    term_28 = 6.0 * rise * shift * swing * cos_phi1 * sin_phi1_cubed
    term_36 = 2.0 * less * shift * swing * term_42
    term_41 = shift_squared * swing * term_42
    term_4 = (
        2.0 * less_plus_shift * term_10 * term_8
        + 2.0
        * both
        * less_plus_shift
        * term_10
        * (
            term_13
            + term_14
            + term_15
            + term_17
            + term_18
            + term_19
            + term_20
            + term_27
            + term_28
            + term_36
            + term_41
            + 2.0 * both * shift_squared * term_43
            + less_squared * swing * term_42
            + 2.0 * both * rise_squared * cos_phi1_squared * sin_phi1_squared
            + 4.0 * both * less * shift * term_43
            + 3.0 * both_squared * swing * cos_phi1_squared * sin_phi1_squared
            + 2.0 * both * less * swing * cos_phi1_squared * sin_phi1_squared
            - 2.0 * both * rise_squared * term_43
            - 3.0 * both_squared * swing * term_43
            - rise_squared * swing * term_43
            - 2.0 * both * shift_squared * cos_phi1_squared * sin_phi1_squared
            - 2.0 * both * less * swing * term_43
            - less_squared * swing * cos_phi1_squared * sin_phi1_squared
            - 8.0 * both * less * rise * cos_phi1 * sin_phi1_cubed
            - 8.0 * both * rise * shift * cos_phi1 * sin_phi1_cubed
            - 4.0 * both * less * shift * cos_phi1_squared * sin_phi1_squared
        )
        - 12.0 * both_squared * less_plus_shift * sin_phi1_squared * term_11 * term_8
    )
    term_6 = (
        2.0
        * both
        * less_plus_shift
        * term_11
        * term_8
        * (
            -6.0 * less * cos_phi1_squared
            - 6.0 * shift * cos_phi1_squared
            - 6.0 * rise * cos_phi1 * sin_phi1
        )
    )
    term_7 = 2.0 * both * term_10 * term_8
    term_16 = -2.0 * both_squared * shift * cos_phi1_squared * sin_phi1_squared
    term_21 = -12.0 * shift_cubed * cos_phi1_squared * sin_phi1_squared
    term_22 = -18.0 * rise * shift_squared * cos_phi1 * sin_phi1_cubed
    term_23 = -4.0 * both_squared * rise * cos_phi1 * sin_phi1_cubed
    term_24 = 12.0 * rise_squared * shift * cos_phi1_squared * sin_phi1_squared
    term_25 = -6.0 * both * rise * swing * cos_phi1_cubed * sin_phi1
    term_26 = 14.0 * both * shift * swing * cos_phi1_squared * sin_phi1_squared
    term_29 = -6.0 * rise_cubed * cos_phi1_cubed * sin_phi1
    term_30 = 6.0 * rise * shift_squared * cos_phi1_cubed * sin_phi1
    term_31 = 6.0 * both * rise * swing * cos_phi1 * sin_phi1_cubed
    term_32 = -6.0 * less * rise_squared * term_42
    term_33 = -6.0 * rise_squared * shift * term_42
    term_34 = -6.0 * rise_squared * shift * term_43
    term_35 = 2.0 * rise_cubed * cos_phi1 * sin_phi1_cubed
    term_37 = -4.0 * shift_cubed * term_42
    term_38 = 2.0 * both_squared * shift * term_43
    term_39 = 2.0 * both * less * swing * term_42
    term_40 = 2.0 * both * shift * swing * term_42
    term_2 = (
        term_6
        + term_7
        + 2.0
        * both
        * less_plus_shift
        * term_10
        * (
            term_13
            + term_14
            + term_15
            + term_16
            + term_17
            + term_19
            + term_21
            + term_22
            + term_23
            + term_24
            + term_25
            + term_26
            + term_28
            + term_29
            + term_30
            + term_31
            + term_32
            + term_33
            + term_34
            + term_35
            + term_37
            + term_38
            + term_39
            + term_40
            + term_41
            + 3.0 * less_squared * swing * term_42
            + both_squared * swing * cos_phi1_squared * sin_phi1_squared
            + 6.0 * less_squared * shift * cos_phi1_squared * sin_phi1_squared
            + 4.0 * less * shift * swing * term_42
            + 12.0 * less * rise * swing * cos_phi1 * sin_phi1_cubed
            + 28.0 * less * shift * swing * cos_phi1_squared * sin_phi1_squared
            - both_squared * swing * term_43
            - 8.0 * less * rise_squared * term_43
            - 10.0 * less * shift_squared * term_42
            - 6.0 * less_squared * shift * term_42
            - rise_squared * swing * term_43
            - 12.0 * less_squared * rise * cos_phi1_cubed * sin_phi1
            - 2.0 * less * rise_squared * cos_phi1_squared * sin_phi1_squared
            - 22.0 * less * shift_squared * cos_phi1_squared * sin_phi1_squared
            - 3.0 * less_squared * swing * cos_phi1_squared * sin_phi1_squared
            - 2.0 * both * less * swing * cos_phi1_squared * sin_phi1_squared
            - 24.0 * less * rise * shift * cos_phi1 * sin_phi1_cubed
            - 12.0 * less * rise * swing * cos_phi1_cubed * sin_phi1
        )
    )
    term_5 = 2.0 * both * less_plus_shift * term_10 * (
        2.0 * shift_cubed * cos_phi1_cubed * sin_phi1
        + 2.0 * both_squared * rise * cos_phi1_squared * sin_phi1_squared
        + 6.0 * less * rise_squared * cos_phi1 * sin_phi1_cubed
        + 6.0 * less_squared * swing * cos_phi1 * sin_phi1_cubed
        + 6.0 * rise_squared * shift * cos_phi1 * sin_phi1_cubed
        + 6.0 * less * shift_squared * cos_phi1_cubed * sin_phi1
        + 12.0 * rise * shift_squared * cos_phi1_squared * sin_phi1_squared
        + 6.0 * both * less * swing * cos_phi1 * sin_phi1_cubed
        + 6.0 * both * shift * swing * cos_phi1 * sin_phi1_cubed
        + 6.0 * less * shift * swing * cos_phi1 * sin_phi1_cubed
        + 24.0 * less * rise * shift * cos_phi1_squared * sin_phi1_squared
        - 4.0 * rise_cubed * term_43
        - 2.0 * both_squared * rise * term_43
        - 6.0 * shift_cubed * cos_phi1 * sin_phi1_cubed
        - 4.0 * less_cubed * cos_phi1_cubed * sin_phi1
        - 12.0 * rise_cubed * cos_phi1_squared * sin_phi1_squared
        - 6.0 * less_squared * rise * term_42
        - 8.0 * less_squared * rise * term_43
        - 6.0 * rise * shift_squared * term_42
        - 6.0 * rise * shift_squared * term_43
        - 2.0 * both * rise * swing * term_43
        - 4.0 * both_squared * less * cos_phi1 * sin_phi1_cubed
        - 4.0 * both_squared * shift * cos_phi1 * sin_phi1_cubed
        - 18.0 * less * shift_squared * cos_phi1 * sin_phi1_cubed
        - 12.0 * less_squared * shift * cos_phi1 * sin_phi1_cubed
        - 18.0 * less * rise_squared * cos_phi1_cubed * sin_phi1
        - 6.0 * less_squared * swing * cos_phi1_cubed * sin_phi1
        - 18.0 * rise_squared * shift * cos_phi1_cubed * sin_phi1
        - 2.0 * less_squared * rise * cos_phi1_squared * sin_phi1_squared
        - 12.0 * less * rise * shift * term_42
        - 12.0 * less * rise * shift * term_43
        - 2.0 * less * rise * swing * term_43
        - 6.0 * both * less * swing * cos_phi1_cubed * sin_phi1
        - 6.0 * both * shift * swing * cos_phi1_cubed * sin_phi1
        - 14.0 * both * rise * swing * cos_phi1_squared * sin_phi1_squared
        - 6.0 * less * shift * swing * cos_phi1_cubed * sin_phi1
        - 14.0 * less * rise * swing * cos_phi1_squared * sin_phi1_squared
    ) + 2.0 * both * less_plus_shift * term_11 * term_8 * (
        -6.0 * rise * sin_phi1_squared
        - 6.0 * less * cos_phi1 * sin_phi1
        - 6.0 * shift * cos_phi1 * sin_phi1
    )
    term_3 = (
        term_6
        + term_7
        + 2.0
        * both
        * less_plus_shift
        * term_10
        * (
            term_16
            + term_18
            + term_20
            + term_21
            + term_22
            + term_23
            + term_24
            + term_25
            + term_26
            + term_27
            + term_29
            + term_30
            + term_31
            + term_32
            + term_33
            + term_34
            + term_35
            + term_36
            + term_37
            + term_38
            + term_39
            + term_40
            + 2.0 * both_squared * less * term_43
            + 2.0 * less_cubed * cos_phi1_squared * sin_phi1_squared
            + 2.0 * less_squared * swing * term_42
            + 12.0 * less * rise_squared * cos_phi1_squared * sin_phi1_squared
            + 14.0 * less_squared * swing * cos_phi1_squared * sin_phi1_squared
            + 14.0 * both * less * swing * cos_phi1_squared * sin_phi1_squared
            + 12.0 * less * rise * shift * cos_phi1_cubed * sin_phi1
            - 2.0 * less_cubed * term_42
            - 6.0 * less * rise_squared * term_43
            - 12.0 * less * shift_squared * term_42
            - 10.0 * less_squared * shift * term_42
            - 2.0 * both_squared * less * cos_phi1_squared * sin_phi1_squared
            - 12.0 * less_squared * rise * cos_phi1 * sin_phi1_cubed
            - 36.0 * less * shift_squared * cos_phi1_squared * sin_phi1_squared
            - 22.0 * less_squared * shift * cos_phi1_squared * sin_phi1_squared
            - 36.0 * less * rise * shift * cos_phi1 * sin_phi1_cubed
        )
    )
    term = cos_mount * one_plus_e1 * term_5 + one_minus_e1 * sin_mount * term_3

    return (
        2.0
        * both
        * less_plus_shift
        * term_10
        * (
            2.0 * term_44 * cos_phi1 * sin_phi1_cubed
            + 6.0 * term_45 * cos_phi1 * sin_phi1_cubed
            + 2.0 * rise * shift_cubed * term_42
            + 6.0 * rise * shift_cubed * term_43
            + 2.0 * both_cubed * swing * cos_phi1_cubed * sin_phi1
            + 6.0 * both_squared * shift_squared * cos_phi1 * sin_phi1_cubed
            + 8.0 * both_squared * swing_squared * cos_phi1 * sin_phi1_cubed
            + 2.0 * both_squared * rise_squared * cos_phi1_cubed * sin_phi1
            + 4.0 * both_squared * less * rise * term_43
            + 4.0 * both_squared * rise * shift * term_43
            + 24.0 * less * shift_cubed * cos_phi1 * sin_phi1_cubed
            + 2.0 * less_cubed * swing * cos_phi1 * sin_phi1_cubed
            + 22.0 * less_squared * shift_squared * cos_phi1 * sin_phi1_cubed
            + 8.0 * less_squared * swing_squared * cos_phi1 * sin_phi1_cubed
            + 12.0 * less_cubed * shift * cos_phi1_cubed * sin_phi1
            + 10.0 * less_squared * rise_squared * cos_phi1_cubed * sin_phi1
            + 24.0 * rise_squared * shift_squared * cos_phi1_cubed * sin_phi1
            + 24.0 * less * rise_cubed * cos_phi1_squared * sin_phi1_squared
            + 12.0 * less_cubed * rise * cos_phi1_squared * sin_phi1_squared
            + 24.0 * rise_cubed * shift * cos_phi1_squared * sin_phi1_squared
            + 6.0 * less * rise * shift_squared * term_42
            + 18.0 * less * rise * shift_squared * term_43
            + 12.0 * less_squared * rise * shift * term_43
            + 16.0 * both * less * swing_squared * cos_phi1 * sin_phi1_cubed
            + 2.0 * both * less_squared * swing * cos_phi1 * sin_phi1_cubed
            + 10.0 * both * rise_squared * swing * cos_phi1 * sin_phi1_cubed
            + 10.0 * both * shift_squared * swing * cos_phi1_cubed * sin_phi1
            + 12.0 * both_squared * less * shift * cos_phi1 * sin_phi1_cubed
            + 2.0 * both_squared * less * swing * cos_phi1_cubed * sin_phi1
            + 10.0 * less * rise_squared * swing * cos_phi1 * sin_phi1_cubed
            + 48.0 * less * rise_squared * shift * cos_phi1_cubed * sin_phi1
            + 10.0 * less * shift_squared * swing * cos_phi1_cubed * sin_phi1
            + 20.0 * less_squared * shift * swing * cos_phi1_cubed * sin_phi1
            + 36.0 * less_squared * rise * swing * cos_phi1_squared * sin_phi1_squared
            + 20.0 * both * less * shift * swing * cos_phi1_cubed * sin_phi1
            + 36.0 * both * less * rise * swing * cos_phi1_squared * sin_phi1_squared
            + 36.0 * both * rise * shift * swing * cos_phi1_squared * sin_phi1_squared
            + 36.0 * less * rise * shift * swing * cos_phi1_squared * sin_phi1_squared
            - 6.0 * term_44 * cos_phi1_cubed * sin_phi1
            - 2.0 * term_45 * cos_phi1_cubed * sin_phi1
            - 6.0 * less * rise_cubed * term_42
            - 2.0 * less * rise_cubed * term_43
            - 4.0 * less_cubed * rise * term_42
            - 6.0 * rise_cubed * shift * term_42
            - 2.0 * rise_cubed * shift * term_43
            - 6.0 * both_cubed * swing * cos_phi1 * sin_phi1_cubed
            - 6.0 * both_squared * rise_squared * cos_phi1 * sin_phi1_cubed
            - 2.0 * both_squared * shift_squared * cos_phi1_cubed * sin_phi1
            - 8.0 * both_squared * swing_squared * cos_phi1_cubed * sin_phi1
            - 4.0 * less_cubed * shift * cos_phi1 * sin_phi1_cubed
            - 14.0 * less_squared * rise_squared * cos_phi1 * sin_phi1_cubed
            - 24.0 * rise_squared * shift_squared * cos_phi1 * sin_phi1_cubed
            - 8.0 * less * shift_cubed * cos_phi1_cubed * sin_phi1
            - 6.0 * less_cubed * swing * cos_phi1_cubed * sin_phi1
            - 2.0 * less_squared * shift_squared * cos_phi1_cubed * sin_phi1
            - 8.0 * less_squared * swing_squared * cos_phi1_cubed * sin_phi1
            - 24.0 * rise * shift_cubed * cos_phi1_squared * sin_phi1_squared
            - 6.0 * less_squared * rise * swing * term_42
            - 6.0 * less_squared * rise * swing * term_43
            - 14.0 * both * shift_squared * swing * cos_phi1 * sin_phi1_cubed
            - 16.0 * both * less * swing_squared * cos_phi1_cubed * sin_phi1
            - 6.0 * both * less_squared * swing * cos_phi1_cubed * sin_phi1
            - 14.0 * both * rise_squared * swing * cos_phi1_cubed * sin_phi1
            - 6.0 * both * less * rise * swing * term_42
            - 6.0 * both * less * rise * swing * term_43
            - 6.0 * both * rise * shift * swing * term_42
            - 6.0 * both * rise * shift * swing * term_43
            - 6.0 * both_squared * less * swing * cos_phi1 * sin_phi1_cubed
            - 4.0 * both_squared * less * shift * cos_phi1_cubed * sin_phi1
            - 12.0 * both_squared * less * rise * cos_phi1_squared * sin_phi1_squared
            - 12.0 * both_squared * rise * shift * cos_phi1_squared * sin_phi1_squared
            - 48.0 * less * rise_squared * shift * cos_phi1 * sin_phi1_cubed
            - 14.0 * less * shift_squared * swing * cos_phi1 * sin_phi1_cubed
            - 28.0 * less_squared * shift * swing * cos_phi1 * sin_phi1_cubed
            - 14.0 * less * rise_squared * swing * cos_phi1_cubed * sin_phi1
            - 72.0 * less * rise * shift_squared * cos_phi1_squared * sin_phi1_squared
            - 36.0 * less_squared * rise * shift * cos_phi1_squared * sin_phi1_squared
            - 6.0 * less * rise * shift * swing * term_42
            - 6.0 * less * rise * shift * swing * term_43
            - 28.0 * both * less * shift * swing * cos_phi1 * sin_phi1_cubed
        )
        + 2.0
        * both
        * less_plus_shift
        * term_11
        * term_8
        * (
            6.0 * less_squared * cos_phi1 * sin_phi1
            + 6.0 * shift_squared * cos_phi1 * sin_phi1
            + 6.0 * less * rise * sin_phi1_squared
            + 6.0 * rise * shift * sin_phi1_squared
            + 12.0 * less * shift * cos_phi1 * sin_phi1
            - 6.0 * both_squared * cos_phi1 * sin_phi1
            - 6.0 * rise_squared * cos_phi1 * sin_phi1
            - 6.0 * less * rise * cos_phi1_squared
            - 6.0 * rise * shift * cos_phi1_squared
        ),
        term_9
        + one_plus_e2 * term_4
        + (e2 - 1.0) * term_2
        + cos_mount * lever * term_5
        - lever * sin_mount * term_3,
        term_9
        + one_plus_e1 * term_4
        + (4.0 * sin_mount / one_minus_e2 + 4.0 * e2 * sin_mount / _square(one_minus_e2)) * term
        + (e1 - 1.0) * term_2,
        4.0 * cos_mount * e2 / one_minus_e2 * term
        + cos_mount * lever * one_minus_e1 * term_3
        - lever * one_plus_e1 * sin_mount * term_5,
    )


# Source: Prikhodko et al. 2024 (oval wheels), second derivative of (10), pair 4-5 cylindrical
# Expressions sha256: b6f1d14f0f8101d8772820f3b63113b9107aebf5c8fb52d0b117d93912ce68d3
# Form: backward pass
# Rewrites: low_word, half_angle_tangent
# Operations: 215
def jerk_cylindrical(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `jerk_cylindrical` by its arguments, in their order.

    In 1 per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where |x| <=
    2**26 and R5/1e30 <= R4 <= 1e80*R5 and (e2 = 0 or phi1 = 0 or 2**-960 <= e2*|phi1|) and (e2
    = 0 or 2**-300 <= e2).

    """
    phi1, R4, R5, e2 = _as_floats("phi1 R4 R5 e2", phi1, R4, R5, e2)
    R4, R5, e2 = _nan_outside(_check_of_ratio_cylindrical, R4, R5, e2)
    return _in_blocks(
        _form_of_jerk_cylindrical,
        (phi1,),
        _prepare_of_jerk_cylindrical,
        (R4, R5, e2),
        out=out,
        shape=(4,),
    )


def _prepare_of_jerk_cylindrical(R4: Any, R5: Any, e2: Any) -> tuple[Any, ...]:
    k = R4 / R5
    k_low = _quotient_rest(R4, R5, k)
    one_minus_e2 = 1.0 - e2
    one_plus_e2 = 1.0 + e2
    one_minus_e2_squared = _square(one_minus_e2)
    one_plus_e2_squared = _square(one_plus_e2)
    e2_squared = _square(e2)
    factor = 1.0 + e2_squared - 10.0 * e2
    factor_3 = 1.0 + 10.0 * e2 + e2_squared
    term_4 = _square(_square(e2))
    factor_2 = 1.0 + term_4 - 26.0 * e2_squared
    k_squared = _square(k)
    term_7 = _square(_square(one_plus_e2))
    term_10 = _square(_square(one_minus_e2))
    factor_7 = 1.0 + 4.0 * e2 + e2_squared
    factor_4 = 1.0 + e2_squared - 4.0 * e2
    term_2 = -86.0 * e2_squared
    e2_cubed = e2 * _square(e2)
    factor_6 = 1.0 + term_2 + term_4 - 30.0 * e2 - 30.0 * e2_cubed
    factor_5 = 1.0 + 30.0 * e2 + 30.0 * e2_cubed + term_2 + term_4

    return (
        R4,
        R5,
        e2,
        k,
        k_low,
        one_minus_e2,
        one_plus_e2,
        one_minus_e2_squared,
        one_plus_e2_squared,
        factor,
        factor_3,
        factor_2,
        k_squared,
        term_7,
        term_10,
        factor_7,
        factor_4,
        factor_6,
        factor_5,
    )


def _form_of_jerk_cylindrical(
    phi1: Any,
    R4: Any,
    R5: Any,
    e2: Any,
    k: Any,
    k_low: Any,
    one_minus_e2: Any,
    one_plus_e2: Any,
    one_minus_e2_squared: Any,
    one_plus_e2_squared: Any,
    factor: Any,
    factor_3: Any,
    factor_2: Any,
    k_squared: Any,
    term_7: Any,
    term_10: Any,
    factor_7: Any,
    factor_4: Any,
    factor_6: Any,
    factor_5: Any,
) -> Any:
    x = 2.0 * k * phi1
    t = _np.tan(x / 2.0)
    x_low = 2.0 * k_low * phi1 + 2.0 * _product_rest(k, phi1, x / 2.0)
    t_low = _small_tangent(x_low / 2.0)
    adjacent = 1.0 - t * t_low
    opposite = t + t_low
    adjacent_squared = _square(adjacent)
    opposite_squared = _square(opposite)
    term = 1.0 / _square(
        _square(one_minus_e2_squared * adjacent_squared + one_plus_e2_squared * opposite_squared)
    )
    term_3 = adjacent_squared + opposite_squared
    term_5 = _square(_square(opposite))
    term_6 = _square(_square(adjacent))
    term_8 = _square(opposite * _square(opposite))
    term_9 = _square(adjacent * _square(adjacent))
    adjacent_cubed = adjacent * _square(adjacent)
    opposite_cubed = opposite * _square(opposite)
    term_11 = opposite * _square(_square(opposite))
    term_12 = adjacent * _square(_square(adjacent))

    return (
        -32.0
        * e2
        * one_minus_e2
        * one_plus_e2
        * _square(_square(k))
        * adjacent
        * opposite
        * term
        * term_3
        * (
            2.0 * factor_2 * adjacent_squared * opposite_squared
            + factor * one_plus_e2_squared * term_5
            + factor_3 * one_minus_e2_squared * term_6
        ),
        8.0
        * e2
        * k_squared
        * one_minus_e2
        * one_plus_e2
        / R5
        * term
        * term_3
        * (
            3.0 * term_10 * term_9
            + 3.0 * factor * one_minus_e2_squared * opposite_squared * term_6
            - 3.0 * term_7 * term_8
            - 3.0 * factor_3 * one_plus_e2_squared * adjacent_squared * term_5
            - 8.0 * factor_2 * k * adjacent_cubed * opposite_cubed * phi1
            - 4.0 * factor * k * one_plus_e2_squared * adjacent * phi1 * term_11
            - 4.0 * factor_3 * k * one_minus_e2_squared * opposite * phi1 * term_12
        ),
        8.0
        * e2
        * k_squared
        * one_minus_e2
        * one_plus_e2
        * R4
        / _square(R5)
        * term
        * term_3
        * (
            3.0 * term_7 * term_8
            + 3.0 * factor_3 * one_plus_e2_squared * adjacent_squared * term_5
            + 8.0 * factor_2 * k * adjacent_cubed * opposite_cubed * phi1
            + 4.0 * factor * k * one_plus_e2_squared * adjacent * phi1 * term_11
            + 4.0 * factor_3 * k * one_minus_e2_squared * opposite * phi1 * term_12
            - 3.0 * term_10 * term_9
            - 3.0 * factor * one_minus_e2_squared * opposite_squared * term_6
        ),
        8.0
        * (k * _square(k))
        * term
        * term_3
        * (
            factor_7 * term_10 * term_9
            + factor_6 * one_minus_e2_squared * opposite_squared * term_6
            - factor_4 * term_7 * term_8
            - factor_5 * one_plus_e2_squared * adjacent_squared * term_5
        ),
    )
