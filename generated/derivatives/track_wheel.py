"""Partial derivatives of the kernels of `track_wheel`, by every argument.

Kapitonov, Yakubovsky 2022, machining error of a wheel with a multi-period track, doi
10.24412/2079-7958-2022-1-43-52

Arguments, domain, `out` and errors are those of the kernel with the same name, one module
up; along a last axis the result has the derivative by each argument, in their order.

At a kink a derivative is that on the side of the greater argument; at a pole it is infinite
or NaN. Each is proved to follow from the definition by the chain rule. Accuracy is tested:
the error of an entry d is at most the stated multiple of eps = 2**-52 times its condition,
|d| + the sum of |p * d d/d p| over the arguments and the symbols p of the kernel's formula,
plus, if the kernel's own error has a scale, that scale divided by the argument (the first
counts as at most 1 rad or mm).

Generated from the derivation track_wheel with SymPy 1.14.0.
Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""

from __future__ import annotations

from builtins import abs as _abs
from typing import Any

import numpy as _np
from numpy.typing import ArrayLike, NDArray

from mechproof.kernel_support.arrays import as_floats as _as_floats
from mechproof.kernel_support.blocks import in_blocks as _in_blocks
from mechproof.kernel_support.domains import (
    is_finite as _is_finite,
    is_nonnegative as _is_nonnegative,
    is_positive as _is_positive,
    nan_outside as _nan_outside,
)
from mechproof.kernel_support.functions import (
    choose_where as _choose_where,
    floor as _floor,
    square as _square,
)

__all__ = [
    "largest_radius",
    "radius",
    "smallest_radius",
    "tilt_of_planar_error",
    "tilt_of_spatial_error",
]


def __dir__() -> list[str]:
    return __all__


# Source: Kapitonov, Yakubovsky 2022, equation (16)
# Expressions sha256: 85239d7e05775620ed58f21fc1f3cf5a5012595d307016aa35500665102a7030
# Form: backward pass
# Rewrites: conjugate_root
# Operations: 30
def radius(
    phi: ArrayLike, R: ArrayLike, A: ArrayLike, z: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `radius` by its arguments, in their order.

    In mm per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where 1e-140
    <= R <= 1e150 and z*|phi| <= 2**26.

    """
    phi, R, A, z = _as_floats("phi R A z", phi, R, A, z)
    R, A, z = _nan_outside(_check_of_radius, R, A, z)
    return _in_blocks(_form_of_radius, (phi,), _prepare_of_radius, (R, A, z), out=out, shape=(4,))


def _check_of_radius(R: Any, A: Any, z: Any) -> tuple[Any, ...]:
    return (_is_positive(R), z >= 1.0, _is_finite(z), z == _floor(z), _abs(A) <= R)


def _prepare_of_radius(R: Any, A: Any, z: Any) -> tuple[Any, ...]:
    A_squared = _square(A)

    return (R, A, z, A_squared)


def _form_of_radius(phi: Any, R: Any, A: Any, z: Any, A_squared: Any) -> Any:
    phi_z = z * phi
    sin_phi_z = _np.sin(phi_z)
    cos_phi_z = _np.cos(phi_z)
    sin_phi_z_squared = _square(sin_phi_z)
    term = 1.0 / _np.sqrt(_square(R) - A_squared * sin_phi_z_squared)

    return (
        -A * z * sin_phi_z - A_squared * z * cos_phi_z * sin_phi_z * term,
        R * term,
        cos_phi_z - A * sin_phi_z_squared * term,
        -A * phi * sin_phi_z - A_squared * cos_phi_z * phi * sin_phi_z * term,
    )


# Source: extremes of Kapitonov, Yakubovsky 2022, equation (16)
# Expressions sha256: bad4908b3bf57438aa28d10beee4920f9cf9ed31efd2e614a87ad745d44f3708
# Form: backward pass
# Operations: 6
def largest_radius(R: ArrayLike, A: ArrayLike, *, out: NDArray[Any] | None = None) -> NDArray[Any]:
    """Differentiate `largest_radius` by its arguments, in their order.

    In mm per unit of each argument. Accuracy, tested: 4 eps of its conditioning.

    """
    R, A = _as_floats("R A", R, A)
    R, A = _nan_outside(_check_of_largest_radius, R, A)
    return _in_blocks(
        _form_of_largest_radius, (R,), parameters=(A,), out=out, shape=(2,), quiet=True
    )


def _check_of_largest_radius(R: Any, A: Any) -> tuple[Any, ...]:
    return (_is_positive(R), _abs(A) <= R)


def _form_of_largest_radius(R: Any, A: Any) -> Any:
    return (
        1.0 + 0.0 * R,
        _choose_where(A < 0.0, -1.0, 1.0) + 0.0 * R,
    )


# Source: extremes of Kapitonov, Yakubovsky 2022, equation (16)
# Expressions sha256: 34c7a7c1d7c3e337533b957d1c7127e385af6b97afceeae5909366532f2994b6
# Form: backward pass
# Operations: 7
def smallest_radius(R: ArrayLike, A: ArrayLike, *, out: NDArray[Any] | None = None) -> NDArray[Any]:
    """Differentiate `smallest_radius` by its arguments, in their order.

    In mm per unit of each argument. Accuracy, tested: 4 eps of its conditioning.

    """
    R, A = _as_floats("R A", R, A)
    R, A = _nan_outside(_check_of_largest_radius, R, A)
    return _in_blocks(
        _form_of_smallest_radius, (R,), parameters=(A,), out=out, shape=(2,), quiet=True
    )


def _form_of_smallest_radius(R: Any, A: Any) -> Any:
    return (
        1.0 + 0.0 * R,
        -_choose_where(A < 0.0, -1.0, 1.0) + 0.0 * R,
    )


# Source: inverse of Kapitonov, Yakubovsky 2022, equation (15)
# Expressions sha256: c28fe1f00495d6f751a3d88b5646e59d34417a6f999e42418c25c36c4487fa9b
# Form: backward pass
# Operations: 42
def tilt_of_planar_error(
    error: ArrayLike,
    offset: ArrayLike,
    rho: ArrayLike,
    H: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> NDArray[Any]:
    """Differentiate `tilt_of_planar_error` by its arguments, in their order.

    In rad per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where 1e-50
    <= rho, H, error <= 1e50 and (1e-50 <= offset <= 1e50 or offset = 0).

    """
    error, offset, rho, H = _as_floats("error offset rho H", error, offset, rho, H)
    error, offset, rho, H = _nan_outside(_check_of_tilt_of_planar_error, error, offset, rho, H)
    return _in_blocks(
        _form_of_tilt_of_planar_error, (error,), parameters=(offset, rho, H), out=out, shape=(4,)
    )


def _check_of_tilt_of_planar_error(error: Any, offset: Any, rho: Any, H: Any) -> tuple[Any, ...]:
    return (
        _is_positive(H),
        _is_positive(rho),
        _is_nonnegative(offset),
        _is_positive(error),
        error - offset >= 0.0,
        error - offset <= H + rho,
    )


def _form_of_tilt_of_planar_error(error: Any, offset: Any, rho: Any, H: Any) -> Any:
    term_6 = error - offset
    term_5 = _square(term_6)
    term_4 = _square(H) + 2.0 * rho * term_6 - term_5
    term_2 = H + _np.sqrt(term_4)
    term = 1.0 / (_square(term_2) + term_5)
    term_3 = 1.0 / _np.sqrt(term_4)
    term_7 = offset - error

    return (
        2.0 * term * term_2 + 2.0 * term * term_3 * term_7 * (offset + rho - error),
        2.0 * term * term_3 * term_7 * (error - offset - rho) - 2.0 * term * term_2,
        2.0 * term * term_3 * term_6 * term_7,
        2.0 * term * term_7 * (1.0 + H * term_3),
    )


# Source: inverse of Kapitonov, Yakubovsky 2022, equation (15)
# Expressions sha256: 2deca8a751ffe0bf72026e9a8a4342ac5a3b26de8a21f9312c7feb5c4456b172
# Form: backward pass
# Operations: 92
def tilt_of_spatial_error(
    error: ArrayLike,
    offset: ArrayLike,
    rho: ArrayLike,
    H: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> NDArray[Any]:
    """Differentiate `tilt_of_spatial_error` by its arguments, in their order.

    In rad per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where 1e-50
    <= rho, H, error <= 1e50 and (1e-50 <= offset <= 1e50 or offset = 0).

    """
    error, offset, rho, H = _as_floats("error offset rho H", error, offset, rho, H)
    error, offset, rho, H = _nan_outside(_check_of_tilt_of_spatial_error, error, offset, rho, H)
    return _in_blocks(
        _form_of_tilt_of_spatial_error,
        (error,),
        _prepare_of_tilt_of_spatial_error,
        (offset, rho, H),
        out=out,
        shape=(4,),
    )


def _check_of_tilt_of_spatial_error(error: Any, offset: Any, rho: Any, H: Any) -> tuple[Any, ...]:
    return (
        _is_positive(H),
        _is_positive(rho),
        _is_nonnegative(offset),
        _is_positive(error),
        offset <= error,
        (error + offset) * (error - offset)
        <= 2.0 * _square(H) + 2.0 * _square(rho) + 2.0 * offset * H + 2.0 * offset * rho,
    )


def _prepare_of_tilt_of_spatial_error(offset: Any, rho: Any, H: Any) -> tuple[Any, ...]:
    H_s_squared = _square(H)
    e_squared = _square(offset)

    return (offset, rho, H, H_s_squared, e_squared)


def _form_of_tilt_of_spatial_error(
    error: Any, offset: Any, rho: Any, H: Any, H_s_squared: Any, e_squared: Any
) -> Any:
    term_10 = error - offset
    term_9 = error + offset
    term_6 = 4.0 * H_s_squared + 4.0 * _square(rho) + 4.0 * offset * rho - term_10 * term_9
    term_4 = 4.0 * H_s_squared * e_squared + term_10 * term_6 * term_9
    term_2 = _np.sqrt(term_4) + 2.0 * offset * H
    term_7 = _square(term_9)
    term_8 = _square(term_10)
    term = 1.0 / (_square(term_2) + term_7 * term_8)
    term_3 = 1.0 / _np.sqrt(term_4)
    term_5 = term_10 * term_6 / 2.0

    return (
        4.0 * term * term_2 * error
        - 2.0
        * term
        * term_10
        * term_3
        * term_9
        * (term_5 + term_6 * term_9 / 2.0 - term_10 * term_9 * error),
        -4.0 * offset * term * term_2
        - 2.0
        * term
        * term_10
        * term_9
        * (
            2.0 * H
            + term_3
            * (
                term_5
                + 4.0 * H_s_squared * offset
                + (2.0 * offset + 4.0 * rho) / 2.0 * term_10 * term_9
                - term_6 * term_9 / 2.0
            )
        ),
        -(4.0 * offset + 8.0 * rho) * term * term_3 * term_7 * term_8,
        -2.0
        * term
        * term_10
        * term_9
        * (2.0 * offset + term_3 * (4.0 * e_squared * H + 4.0 * H * term_10 * term_9)),
    )
