"""Partial derivatives of the kernels of `tooth_thickness`, by every argument.

Derbaba, Korsun, Patsera, stochastic simulation of the thickness of an involute tooth and of
its measurement

Arguments, domain, `out` and errors are those of the kernel with the same name, one module
up; along a last axis the result has the derivative by each argument, in their order.

At a kink a derivative is that on the side of the greater argument; at a pole it is infinite
or NaN. Each is proved to follow from the definition by the chain rule. Accuracy is tested:
the error of an entry d is at most the stated multiple of eps = 2**-52 times its condition,
|d| + the sum of |p * d d/d p| over the arguments and the symbols p of the kernel's formula,
plus, if the kernel's own error has a scale, that scale divided by the argument (the first
counts as at most 1 rad or mm).

Generated from the derivation tooth_thickness with SymPy 1.14.0.
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
    is_positive as _is_positive,
    nan_outside as _nan_outside,
)
from mechproof.kernel_support.functions import (
    choose_where as _choose_where,
    floor as _floor,
    square as _square,
)

__all__ = [
    "chord_height",
    "constant_chord",
    "height_change",
    "linearisation_bound",
    "thickness_change",
    "thickness_change_linear",
    "thickness_error",
]


def __dir__() -> list[str]:
    return __all__


# Source: paper on tooth thickness, design data; basic rack
# Expressions sha256: 73571909309937bfbf8c496fdc6742f47d8b2c2f006828c9aacf2a913ed0b1b6
# Form: backward pass
# Operations: 9
def constant_chord(
    m: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `constant_chord` by its arguments, in their order.

    In mm per unit of each argument. Accuracy, tested: 4 eps of its conditioning.

    """
    m, alpha = _as_floats("m alpha", m, alpha)
    m, alpha = _nan_outside(_check_of_constant_chord, m, alpha)
    return _in_blocks(
        _form_of_constant_chord, (m,), _prepare_of_constant_chord, (alpha,), out=out, shape=(2,)
    )


def _check_of_constant_chord(m: Any, alpha: Any) -> tuple[Any, ...]:
    return (alpha > 0.0, alpha < _np.pi / 4.0, _is_positive(m))


def _prepare_of_constant_chord(alpha: Any) -> tuple[Any, ...]:
    cos_alpha = _np.cos(alpha)

    return (alpha, cos_alpha)


def _form_of_constant_chord(m: Any, alpha: Any, cos_alpha: Any) -> Any:
    return (
        _np.pi * _square(cos_alpha) / 2.0,
        -_np.pi * cos_alpha * _np.sin(alpha) * m,
    )


# Source: paper on tooth thickness, design data; basic rack
# Expressions sha256: 154cbbf5e31c4618dc0a290565ab1dcd56469b219c542f726f075e9d2f8ccc21
# Form: backward pass
# Operations: 11
def chord_height(
    m: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `chord_height` by its arguments, in their order.

    In mm per unit of each argument. Accuracy, tested: 4 eps of its conditioning.

    """
    m, alpha = _as_floats("m alpha", m, alpha)
    m, alpha = _nan_outside(_check_of_constant_chord, m, alpha)
    return _in_blocks(_form_of_chord_height, (m,), parameters=(alpha,), out=out, shape=(2,))


def _form_of_chord_height(m: Any, alpha: Any) -> Any:
    return (
        1.0 - _np.pi * _np.sin(2.0 * alpha) / 8.0,
        -_np.pi * _np.cos(2.0 * alpha) / 4.0 * m,
    )


# Source: paper on tooth thickness, step 6, on the involute
# Expressions sha256: ad7cd14339a2c74a36ad9a9cf66ae62d066ad283d7c0d049a71e7f4a01f8451c
# Form: backward pass
# Rewrites: cosine_minus_one
# Operations: 67
def height_change(
    tilt: ArrayLike,
    m: ArrayLike,
    z: ArrayLike,
    alpha: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> NDArray[Any]:
    """Differentiate `height_change` by its arguments, in their order.

    In mm per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where (tilt =
    0 or 1e-250 <= |tilt|) and 1e-30 <= m and m*z <= 1e300.

    """
    tilt, m, z, alpha = _as_floats("tilt m z alpha", tilt, m, z, alpha)
    m, z, alpha = _nan_outside(_check_of_height_change, m, z, alpha)
    return _in_blocks(
        _form_of_height_change,
        (tilt,),
        _prepare_of_height_change,
        (m, z, alpha),
        out=out,
        shape=(4,),
    )


def _check_of_height_change(m: Any, z: Any, alpha: Any) -> tuple[Any, ...]:
    return (
        _is_positive(m),
        z >= 1.0,
        _is_finite(z),
        z == _floor(z),
        alpha > 0.0,
        alpha < _np.pi / 4.0,
    )


def _prepare_of_height_change(m: Any, z: Any, alpha: Any) -> tuple[Any, ...]:
    cosm1_alpha = -2.0 * _square(_np.sin(alpha / 2.0))
    cos_alpha = 1.0 + cosm1_alpha
    r_b = cos_alpha * m * z / 2.0
    sin_alpha = _np.sin(alpha)
    tan_alpha = _np.tan(alpha)
    t_c = tan_alpha + _np.pi / (2.0 * z)

    return (m, z, cos_alpha, r_b, sin_alpha, tan_alpha, t_c)


def _form_of_height_change(
    tilt: Any, m: Any, z: Any, cos_alpha: Any, r_b: Any, sin_alpha: Any, tan_alpha: Any, t_c: Any
) -> Any:
    sin_tilt = _np.sin(tilt)
    t_c_sin_tilt = t_c * sin_tilt
    tilt_sin_tilt = sin_tilt * tilt
    cosm1_tilt = -2.0 * _square(_np.sin(tilt / 2.0))
    cos_tilt = 1.0 + cosm1_tilt
    term_4 = sin_tilt - cos_tilt * tilt - t_c * cosm1_tilt
    term_2 = cosm1_tilt + t_c_sin_tilt + tilt_sin_tilt
    term = sin_alpha * term_4 - cos_alpha * term_2
    term_3 = -cos_alpha * sin_tilt - sin_alpha * cosm1_tilt

    return (
        r_b * (sin_alpha * (t_c_sin_tilt + tilt_sin_tilt) - cos_alpha * cos_tilt * (t_c + tilt)),
        cos_alpha * z / 2.0 * term,
        cos_alpha * m / 2.0 * term - _np.pi * r_b / (2.0 * _square(z)) * term_3,
        r_b * (cos_alpha * term_4 + sin_alpha * term_2)
        + r_b * (1.0 + _square(tan_alpha)) * term_3
        - sin_alpha * m * z / 2.0 * term,
    )


# Source: paper on tooth thickness, step 6, on the involute
# Expressions sha256: 19ebcefb163ab29836db3f9a3dfd2c203502a958c1dd549903f8db6762f4da65
# Form: backward pass
# Rewrites: cosine_minus_one
# Operations: 70
def thickness_change(
    tilt: ArrayLike,
    m: ArrayLike,
    z: ArrayLike,
    alpha: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> NDArray[Any]:
    """Differentiate `thickness_change` by its arguments, in their order.

    In mm per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where (tilt =
    0 or 1e-250 <= |tilt|) and 1e-30 <= m and m*z <= 1e300.

    """
    tilt, m, z, alpha = _as_floats("tilt m z alpha", tilt, m, z, alpha)
    m, z, alpha = _nan_outside(_check_of_height_change, m, z, alpha)
    return _in_blocks(
        _form_of_thickness_change,
        (tilt,),
        _prepare_of_thickness_change,
        (m, z, alpha),
        out=out,
        shape=(4,),
    )


def _prepare_of_thickness_change(m: Any, z: Any, alpha: Any) -> tuple[Any, ...]:
    cosm1_alpha = -2.0 * _square(_np.sin(alpha / 2.0))
    cos_alpha = 1.0 + cosm1_alpha
    r_b = cos_alpha * m * z / 2.0
    tan_alpha = _np.tan(alpha)
    t_c = tan_alpha + _np.pi / (2.0 * z)
    sin_alpha = _np.sin(alpha)

    return (m, z, cos_alpha, r_b, tan_alpha, t_c, sin_alpha)


def _form_of_thickness_change(
    tilt: Any, m: Any, z: Any, cos_alpha: Any, r_b: Any, tan_alpha: Any, t_c: Any, sin_alpha: Any
) -> Any:
    sin_tilt = _np.sin(tilt)
    t_c_sin_tilt = t_c * sin_tilt
    tilt_sin_tilt = sin_tilt * tilt
    cosm1_tilt = -2.0 * _square(_np.sin(tilt / 2.0))
    cos_tilt = 1.0 + cosm1_tilt
    term_3 = sin_tilt - cos_tilt * tilt - t_c * cosm1_tilt
    term_2 = cosm1_tilt + t_c_sin_tilt + tilt_sin_tilt
    term = -2.0 * cos_alpha * term_3 - 2.0 * sin_alpha * term_2
    term_4 = sin_alpha * sin_tilt - cos_alpha * cosm1_tilt

    return (
        -2.0
        * r_b
        * (cos_alpha * (t_c_sin_tilt + tilt_sin_tilt) + sin_alpha * cos_tilt * (t_c + tilt)),
        cos_alpha * z / 2.0 * term,
        cos_alpha * m / 2.0 * term + _np.pi * r_b / _square(z) * term_4,
        -2.0 * r_b * (cos_alpha * term_2 - sin_alpha * term_3)
        - 2.0 * r_b * (1.0 + _square(tan_alpha)) * term_4
        - sin_alpha * m * z / 2.0 * term,
    )


# Source: paper on tooth thickness, equation (1) with the exact derivative
# Expressions sha256: a17ad5e33fc47792318f2e81961abf07611b91a1eff36cfa651533a6a8cabf9f
# Form: backward pass
# Operations: 6
def thickness_change_linear(
    dh: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `thickness_change_linear` by its arguments, in their order.

    In mm per unit of each argument. Accuracy, tested: 4 eps of its conditioning.

    """
    dh, alpha = _as_floats("dh alpha", dh, alpha)
    (alpha,) = _nan_outside(_check_of_thickness_change_linear, alpha)
    return _in_blocks(
        _form_of_thickness_change_linear,
        (dh,),
        _prepare_of_thickness_change_linear,
        (alpha,),
        out=out,
        shape=(2,),
    )


def _check_of_thickness_change_linear(alpha: Any) -> tuple[Any, ...]:
    return (alpha > 0.0, alpha < _np.pi / 4.0)


def _prepare_of_thickness_change_linear(alpha: Any) -> tuple[Any, ...]:
    tan_alpha = _np.tan(alpha)

    return (tan_alpha,)


def _form_of_thickness_change_linear(dh: Any, tan_alpha: Any) -> Any:
    return (
        2.0 * tan_alpha,
        2.0 * (1.0 + _square(tan_alpha)) * dh,
    )


# Source: paper on tooth thickness, step 6, second derivative on the involute
# Expressions sha256: 48b4f2daa01b13b6ef84b6fce7c29628840548ef95a2c27ee263d73b669e4f83
# Form: backward pass
# Operations: 120
def linearisation_bound(
    dh: ArrayLike, m: ArrayLike, z: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `linearisation_bound` by its arguments, in their order.

    In mm per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where (dh = 0
    or 1e-100 <= |dh|) and 1e-30 <= m and m*z <= 1e50.

    """
    dh, m, z, alpha = _as_floats("dh m z alpha", dh, m, z, alpha)
    m, z, alpha = _nan_outside(_check_of_height_change, m, z, alpha)
    return _in_blocks(
        _form_of_linearisation_bound,
        (dh,),
        _prepare_of_linearisation_bound,
        (m, z, alpha),
        out=out,
        shape=(4,),
        quiet=True,
    )


def _prepare_of_linearisation_bound(m: Any, z: Any, alpha: Any) -> tuple[Any, ...]:
    cos_alpha = _np.cos(alpha)
    r_b = cos_alpha * m * z / 2.0
    term_10 = 1.0 / (r_b * _square(r_b))
    tan_alpha = _np.tan(alpha)
    t_c = tan_alpha + _np.pi / (2.0 * z)
    t_c_squared = _square(t_c)
    term_6 = z / 2.0 + _np.pi * _np.sin(2.0 * alpha) / 8.0
    y_c = term_6 * m

    return (m, z, alpha, cos_alpha, r_b, term_10, tan_alpha, t_c, t_c_squared, term_6, y_c)


def _form_of_linearisation_bound(
    dh: Any,
    m: Any,
    z: Any,
    alpha: Any,
    cos_alpha: Any,
    r_b: Any,
    term_10: Any,
    tan_alpha: Any,
    t_c: Any,
    t_c_squared: Any,
    term_6: Any,
    y_c: Any,
) -> Any:
    abs_Delta_h = _abs(dh)
    term_8 = 2.0 * y_c - abs_Delta_h
    term_5 = t_c_squared * _square(r_b) - abs_Delta_h * term_8
    term_3 = 1.0 / _np.sqrt(term_5)
    y_c_plus_abs_Delta_h = abs_Delta_h + y_c
    term_7 = y_c_plus_abs_Delta_h * _square(y_c_plus_abs_Delta_h)
    Delta_h_squared = _square(dh)
    root_term_5 = _np.sqrt(term_5)
    term_4 = 1.0 / (root_term_5 * _square(root_term_5))
    term_11 = _choose_where(dh < 0.0, -1.0, 1.0)
    term_9 = _square(y_c_plus_abs_Delta_h)
    term_2 = (
        3.0 * term_10 * Delta_h_squared * term_3 * term_9
        + term_10 * Delta_h_squared * abs_Delta_h * term_4 * term_7
    )
    term = (
        -3.0 / _square(_square(r_b)) * Delta_h_squared * term_3 * term_7
        - t_c_squared / _square(r_b) * Delta_h_squared * term_4 * term_7
    )

    return (
        2.0 * term_10 * dh * term_3 * term_7
        + 3.0 * term_10 * Delta_h_squared * term_11 * term_3 * term_9
        + term_10
        * Delta_h_squared
        * term_4
        * term_7
        * (term_11 * term_8 / 2.0 - abs_Delta_h * term_11 / 2.0),
        term_6 * term_2 + cos_alpha * z / 2.0 * term,
        m / 2.0 * term_2
        + cos_alpha * m / 2.0 * term
        + _np.pi * t_c / (2.0 * r_b * _square(z)) * Delta_h_squared * term_4 * term_7,
        _np.pi * m * _np.cos(2.0 * alpha) / 4.0 * term_2
        - m * z * _np.sin(alpha) / 2.0 * term
        - t_c * (1.0 + _square(tan_alpha)) / r_b * Delta_h_squared * term_4 * term_7,
    )


# Source: paper on tooth thickness, steps 5 and 6 corrected
# Expressions sha256: a858122a84f17e1e8324c8fbd9aa222dd4aebaf98111e8d6b323a4db32f1343f
# Form: backward pass
# Operations: 9
def thickness_error(
    e_tip: ArrayLike, height_error: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `thickness_error` by its arguments, in their order.

    In mm per unit of each argument. Accuracy, tested: 4 eps of its conditioning.

    """
    e_tip, height_error, alpha = _as_floats("e_tip height_error alpha", e_tip, height_error, alpha)
    (alpha,) = _nan_outside(_check_of_thickness_change_linear, alpha)
    return _in_blocks(
        _form_of_thickness_error,
        (e_tip,),
        _prepare_of_thickness_error,
        (height_error, alpha),
        out=out,
        shape=(3,),
    )


def _prepare_of_thickness_error(height_error: Any, alpha: Any) -> tuple[Any, ...]:
    tan_alpha = _np.tan(alpha)

    return (height_error, tan_alpha)


def _form_of_thickness_error(e_tip: Any, height_error: Any, tan_alpha: Any) -> Any:
    return (
        -tan_alpha,
        2.0 * tan_alpha,
        2.0 * (1.0 + _square(tan_alpha)) * (height_error - e_tip / 2.0),
    )
