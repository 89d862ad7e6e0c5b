"""Compiled kernels of the system `tooth_thickness`: one loop for each, by numba.

Names, arguments, domains, NaN and errors are those of `mechproof.kernels.tooth_thickness`,
and so are the formulas. Numbers and NumPy arrays are taken. With numbers,
kernels can be called inside functions that numba compiles; arguments with components are then
indexed, and so are results.

Tests hold them to the same accuracy bounds. What help says is proved of rounding errors
is proved of these kernels where it says `compiled`, and of the NumPy kernels elsewhere.

Elementary functions: `elementary` 8db31d8544f3.

Generated from mechproof.derivations.tooth_thickness with SymPy 1.14.0.
Regenerate with `mechproof regenerate`; edits are overwritten.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy import float64, ndarray
from numpy.typing import ArrayLike, NDArray

from mechproof.compiled_support import (
    BLOCK,
    Loops,
    floor,
    has_nan,
    is_finite,
    loop,
    overload,
    run,
    scalar,
    take_row,
    widen,
)
from mechproof.kernels.compiled import elementary

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


@scalar
def _prepare_constant_chord(alpha, exact):

    return (alpha,)


@scalar
def _constant_chord(m, alpha, exact):

    return np.pi * elementary.cos(alpha, exact) ** 2 / 2 * m


@scalar
def _constant_chord_at(m, alpha, exact):
    if not ((alpha > 0) & (alpha < np.pi / 4) & (m > 0) & is_finite(m)):
        return math.nan
    prepared = _prepare_constant_chord(alpha, exact)
    return _constant_chord(m, *prepared, exact)


@scalar
def _constant_chord_point(m, alpha):
    return _constant_chord_at(m, alpha, True)


@loop
def _row_constant_chord(out, m_values, alpha, exact):
    widen()
    for i in range(out.size):
        m = float64(m_values[i])

        value = _constant_chord_at(m, alpha, exact)
        out[i] = value


@loop
def _fill_constant_chord(
    out,
    m_values,
    alpha,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        m_block = m_values[start:stop]
        _row_constant_chord(out_block, m_block, alpha, None)
        if has_nan(out_block):
            _row_constant_chord(out_block, m_block, alpha, True)


@loop
def _row_each_constant_chord(out, m_values, alpha_values, exact):
    widen()
    for i in range(out.size):
        m = float64(m_values[i])

        alpha = float64(alpha_values[i])

        value = _constant_chord_at(m, alpha, exact)
        out[i] = value


@loop
def _fill_each_constant_chord(
    out,
    m_values,
    alpha_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        m_block = m_values[start:stop]
        alpha_block = alpha_values[start:stop]
        _row_each_constant_chord(out_block, m_block, alpha_block, None)
        if has_nan(out_block):
            _row_each_constant_chord(out_block, m_block, alpha_block, True)


def constant_chord(m: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the constant chord, between the points where a rack touches both flanks.

    Compiled. The help of `mechproof.kernels.tooth_thickness.constant_chord` has all words.
    """
    if type(alpha) is float:
        if type(m) is ndarray:
            row = take_row(m, out)
            if row is not None:
                _CONSTANT_CHORD.fill(row, m, alpha)
                return row
        elif type(m) is float and out is None:
            return float64(_CONSTANT_CHORD.point(m, alpha))
    return run(
        _CONSTANT_CHORD,
        (
            m,
            alpha,
        ),
        out,
    )


_CONSTANT_CHORD = Loops(
    names=(
        "m",
        "alpha",
    ),
    widths=(
        0,
        0,
    ),
    shape=(),
    at=_constant_chord_point,
    uniform=_fill_constant_chord,
    each=_fill_each_constant_chord,
)


@overload(constant_chord)
def _offer_constant_chord(
    m,
    alpha,
):
    return lambda m, alpha: _constant_chord_point(
        float64(m),
        float64(alpha),
    )


@scalar
def _prepare_chord_height(alpha, exact):

    return (alpha,)


@scalar
def _chord_height(m, alpha, exact):

    return (1 - np.pi * elementary.sin(2 * alpha, exact) / 8) * m


@scalar
def _chord_height_at(m, alpha, exact):
    if not ((alpha > 0) & (alpha < np.pi / 4) & (m > 0) & is_finite(m)):
        return math.nan
    prepared = _prepare_chord_height(alpha, exact)
    return _chord_height(m, *prepared, exact)


@scalar
def _chord_height_point(m, alpha):
    return _chord_height_at(m, alpha, True)


@loop
def _row_chord_height(out, m_values, alpha, exact):
    widen()
    for i in range(out.size):
        m = float64(m_values[i])

        value = _chord_height_at(m, alpha, exact)
        out[i] = value


@loop
def _fill_chord_height(
    out,
    m_values,
    alpha,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        m_block = m_values[start:stop]
        _row_chord_height(out_block, m_block, alpha, None)
        if has_nan(out_block):
            _row_chord_height(out_block, m_block, alpha, True)


@loop
def _row_each_chord_height(out, m_values, alpha_values, exact):
    widen()
    for i in range(out.size):
        m = float64(m_values[i])

        alpha = float64(alpha_values[i])

        value = _chord_height_at(m, alpha, exact)
        out[i] = value


@loop
def _fill_each_chord_height(
    out,
    m_values,
    alpha_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        m_block = m_values[start:stop]
        alpha_block = alpha_values[start:stop]
        _row_each_chord_height(out_block, m_block, alpha_block, None)
        if has_nan(out_block):
            _row_each_chord_height(out_block, m_block, alpha_block, True)


def chord_height(m: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the height from the tip circle to the constant chord, addendum of one module.

    Compiled. The help of `mechproof.kernels.tooth_thickness.chord_height` has all words.
    """
    if type(alpha) is float:
        if type(m) is ndarray:
            row = take_row(m, out)
            if row is not None:
                _CHORD_HEIGHT.fill(row, m, alpha)
                return row
        elif type(m) is float and out is None:
            return float64(_CHORD_HEIGHT.point(m, alpha))
    return run(
        _CHORD_HEIGHT,
        (
            m,
            alpha,
        ),
        out,
    )


_CHORD_HEIGHT = Loops(
    names=(
        "m",
        "alpha",
    ),
    widths=(
        0,
        0,
    ),
    shape=(),
    at=_chord_height_point,
    uniform=_fill_chord_height,
    each=_fill_each_chord_height,
)


@overload(chord_height)
def _offer_chord_height(
    m,
    alpha,
):
    return lambda m, alpha: _chord_height_point(
        float64(m),
        float64(alpha),
    )


@scalar
def _prepare_height_change(m, z, alpha, exact):
    cosm1_alpha = -2 * elementary.sin(alpha / 2, exact) ** 2
    cos_alpha = 1 + cosm1_alpha
    r_b = cos_alpha * m * z / 2
    t_c = np.pi / (2 * z) + elementary.tan(alpha, exact)

    return (alpha, cos_alpha, r_b, t_c)


@scalar
def _height_change(tilt, alpha, cos_alpha, r_b, t_c, exact):
    sin_tilt = elementary.sin(tilt, exact)
    cosm1_tilt = -2 * elementary.sin(tilt / 2, exact) ** 2
    cos_tilt = 1 + cosm1_tilt

    return r_b * (
        elementary.sin(alpha, exact) * (sin_tilt - cos_tilt * tilt - t_c * cosm1_tilt)
        - cos_alpha * (cosm1_tilt + t_c * sin_tilt + sin_tilt * tilt)
    )


@scalar
def _height_change_at(tilt, m, z, alpha, exact):
    if not (
        (m > 0)
        & is_finite(m)
        & (z >= 1)
        & is_finite(z)
        & (z == floor(z))
        & (alpha > 0)
        & (alpha < np.pi / 4)
    ):
        return math.nan
    prepared = _prepare_height_change(m, z, alpha, exact)
    return _height_change(tilt, *prepared, exact)


@scalar
def _height_change_point(tilt, m, z, alpha):
    return _height_change_at(tilt, m, z, alpha, True)


@loop
def _row_height_change(out, tilt_values, m, z, alpha, exact):
    widen()
    for i in range(out.size):
        tilt = float64(tilt_values[i])

        value = _height_change_at(tilt, m, z, alpha, exact)
        out[i] = value


@loop
def _fill_height_change(
    out,
    tilt_values,
    m,
    z,
    alpha,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        tilt_block = tilt_values[start:stop]
        _row_height_change(out_block, tilt_block, m, z, alpha, None)
        if has_nan(out_block):
            _row_height_change(out_block, tilt_block, m, z, alpha, True)


@loop
def _row_each_height_change(out, tilt_values, m_values, z_values, alpha_values, exact):
    widen()
    for i in range(out.size):
        tilt = float64(tilt_values[i])

        m = float64(m_values[i])

        z = float64(z_values[i])

        alpha = float64(alpha_values[i])

        value = _height_change_at(tilt, m, z, alpha, exact)
        out[i] = value


@loop
def _fill_each_height_change(
    out,
    tilt_values,
    m_values,
    z_values,
    alpha_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        tilt_block = tilt_values[start:stop]
        m_block = m_values[start:stop]
        z_block = z_values[start:stop]
        alpha_block = alpha_values[start:stop]
        _row_each_height_change(out_block, tilt_block, m_block, z_block, alpha_block, None)
        if has_nan(out_block):
            _row_each_height_change(out_block, tilt_block, m_block, z_block, alpha_block, True)


def height_change(
    tilt: ArrayLike,
    m: ArrayLike,
    z: ArrayLike,
    alpha: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute how much deeper than the constant chord the chord lies, by its flank's tangent.

    Compiled. The help of `mechproof.kernels.tooth_thickness.height_change` has all words.
    """
    if type(m) is type(z) is type(alpha) is float:
        if type(tilt) is ndarray:
            row = take_row(tilt, out)
            if row is not None:
                _HEIGHT_CHANGE.fill(row, tilt, m, z, alpha)
                return row
        elif type(tilt) is float and out is None:
            return float64(_HEIGHT_CHANGE.point(tilt, m, z, alpha))
    return run(
        _HEIGHT_CHANGE,
        (
            tilt,
            m,
            z,
            alpha,
        ),
        out,
    )


_HEIGHT_CHANGE = Loops(
    names=(
        "tilt",
        "m",
        "z",
        "alpha",
    ),
    widths=(
        0,
        0,
        0,
        0,
    ),
    shape=(),
    at=_height_change_point,
    uniform=_fill_height_change,
    each=_fill_each_height_change,
)


@overload(height_change)
def _offer_height_change(
    tilt,
    m,
    z,
    alpha,
):
    return lambda tilt, m, z, alpha: _height_change_point(
        float64(tilt),
        float64(m),
        float64(z),
        float64(alpha),
    )


@scalar
def _prepare_thickness_change(m, z, alpha, exact):
    cosm1_alpha = -2 * elementary.sin(alpha / 2, exact) ** 2
    cos_alpha = 1 + cosm1_alpha
    r_b = cos_alpha * m * z / 2
    t_c = np.pi / (2 * z) + elementary.tan(alpha, exact)

    return (alpha, cos_alpha, r_b, t_c)


@scalar
def _thickness_change(tilt, alpha, cos_alpha, r_b, t_c, exact):
    sin_tilt = elementary.sin(tilt, exact)
    cosm1_tilt = -2 * elementary.sin(tilt / 2, exact) ** 2
    cos_tilt = 1 + cosm1_tilt

    return (
        -2
        * r_b
        * (
            cos_alpha * (sin_tilt - cos_tilt * tilt - t_c * cosm1_tilt)
            + elementary.sin(alpha, exact) * (cosm1_tilt + t_c * sin_tilt + sin_tilt * tilt)
        )
    )


@scalar
def _thickness_change_at(tilt, m, z, alpha, exact):
    if not (
        (m > 0)
        & is_finite(m)
        & (z >= 1)
        & is_finite(z)
        & (z == floor(z))
        & (alpha > 0)
        & (alpha < np.pi / 4)
    ):
        return math.nan
    prepared = _prepare_thickness_change(m, z, alpha, exact)
    return _thickness_change(tilt, *prepared, exact)


@scalar
def _thickness_change_point(tilt, m, z, alpha):
    return _thickness_change_at(tilt, m, z, alpha, True)


@loop
def _row_thickness_change(out, tilt_values, m, z, alpha, exact):
    widen()
    for i in range(out.size):
        tilt = float64(tilt_values[i])

        value = _thickness_change_at(tilt, m, z, alpha, exact)
        out[i] = value


@loop
def _fill_thickness_change(
    out,
    tilt_values,
    m,
    z,
    alpha,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        tilt_block = tilt_values[start:stop]
        _row_thickness_change(out_block, tilt_block, m, z, alpha, None)
        if has_nan(out_block):
            _row_thickness_change(out_block, tilt_block, m, z, alpha, True)


@loop
def _row_each_thickness_change(out, tilt_values, m_values, z_values, alpha_values, exact):
    widen()
    for i in range(out.size):
        tilt = float64(tilt_values[i])

        m = float64(m_values[i])

        z = float64(z_values[i])

        alpha = float64(alpha_values[i])

        value = _thickness_change_at(tilt, m, z, alpha, exact)
        out[i] = value


@loop
def _fill_each_thickness_change(
    out,
    tilt_values,
    m_values,
    z_values,
    alpha_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        tilt_block = tilt_values[start:stop]
        m_block = m_values[start:stop]
        z_block = z_values[start:stop]
        alpha_block = alpha_values[start:stop]
        _row_each_thickness_change(out_block, tilt_block, m_block, z_block, alpha_block, None)
        if has_nan(out_block):
            _row_each_thickness_change(out_block, tilt_block, m_block, z_block, alpha_block, True)


def thickness_change(
    tilt: ArrayLike,
    m: ArrayLike,
    z: ArrayLike,
    alpha: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute how much thicker than the constant chord the chord is, by its flank's tangent.

    Compiled. The help of `mechproof.kernels.tooth_thickness.thickness_change` has all words.
    """
    if type(m) is type(z) is type(alpha) is float:
        if type(tilt) is ndarray:
            row = take_row(tilt, out)
            if row is not None:
                _THICKNESS_CHANGE.fill(row, tilt, m, z, alpha)
                return row
        elif type(tilt) is float and out is None:
            return float64(_THICKNESS_CHANGE.point(tilt, m, z, alpha))
    return run(
        _THICKNESS_CHANGE,
        (
            tilt,
            m,
            z,
            alpha,
        ),
        out,
    )


_THICKNESS_CHANGE = Loops(
    names=(
        "tilt",
        "m",
        "z",
        "alpha",
    ),
    widths=(
        0,
        0,
        0,
        0,
    ),
    shape=(),
    at=_thickness_change_point,
    uniform=_fill_thickness_change,
    each=_fill_each_thickness_change,
)


@overload(thickness_change)
def _offer_thickness_change(
    tilt,
    m,
    z,
    alpha,
):
    return lambda tilt, m, z, alpha: _thickness_change_point(
        float64(tilt),
        float64(m),
        float64(z),
        float64(alpha),
    )


@scalar
def _prepare_thickness_change_linear(alpha, exact):

    return (alpha,)


@scalar
def _thickness_change_linear(dh, alpha, exact):

    return 2 * elementary.tan(alpha, exact) * dh


@scalar
def _thickness_change_linear_at(dh, alpha, exact):
    if not ((alpha > 0) & (alpha < np.pi / 4)):
        return math.nan
    prepared = _prepare_thickness_change_linear(alpha, exact)
    return _thickness_change_linear(dh, *prepared, exact)


@scalar
def _thickness_change_linear_point(dh, alpha):
    return _thickness_change_linear_at(dh, alpha, True)


@loop
def _row_thickness_change_linear(out, dh_values, alpha, exact):
    widen()
    for i in range(out.size):
        dh = float64(dh_values[i])

        value = _thickness_change_linear_at(dh, alpha, exact)
        out[i] = value


@loop
def _fill_thickness_change_linear(
    out,
    dh_values,
    alpha,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        dh_block = dh_values[start:stop]
        _row_thickness_change_linear(out_block, dh_block, alpha, None)
        if has_nan(out_block):
            _row_thickness_change_linear(out_block, dh_block, alpha, True)


@loop
def _row_each_thickness_change_linear(out, dh_values, alpha_values, exact):
    widen()
    for i in range(out.size):
        dh = float64(dh_values[i])

        alpha = float64(alpha_values[i])

        value = _thickness_change_linear_at(dh, alpha, exact)
        out[i] = value


@loop
def _fill_each_thickness_change_linear(
    out,
    dh_values,
    alpha_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        dh_block = dh_values[start:stop]
        alpha_block = alpha_values[start:stop]
        _row_each_thickness_change_linear(out_block, dh_block, alpha_block, None)
        if has_nan(out_block):
            _row_each_thickness_change_linear(out_block, dh_block, alpha_block, True)


def thickness_change_linear(
    dh: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the change of thickness with the height to first order, on the rack exactly.

    Compiled. The help of `mechproof.kernels.tooth_thickness.thickness_change_linear` has all words.
    """
    if type(alpha) is float:
        if type(dh) is ndarray:
            row = take_row(dh, out)
            if row is not None:
                _THICKNESS_CHANGE_LINEAR.fill(row, dh, alpha)
                return row
        elif type(dh) is float and out is None:
            return float64(_THICKNESS_CHANGE_LINEAR.point(dh, alpha))
    return run(
        _THICKNESS_CHANGE_LINEAR,
        (
            dh,
            alpha,
        ),
        out,
    )


_THICKNESS_CHANGE_LINEAR = Loops(
    names=(
        "dh",
        "alpha",
    ),
    widths=(
        0,
        0,
    ),
    shape=(),
    at=_thickness_change_linear_point,
    uniform=_fill_thickness_change_linear,
    each=_fill_each_thickness_change_linear,
)


@overload(thickness_change_linear)
def _offer_thickness_change_linear(
    dh,
    alpha,
):
    return lambda dh, alpha: _thickness_change_linear_point(
        float64(dh),
        float64(alpha),
    )


@scalar
def _prepare_linearisation_bound(m, z, alpha, exact):
    r_b = m * z * elementary.cos(alpha, exact) / 2
    y_c = m * (z / 2 + np.pi * elementary.sin(2 * alpha, exact) / 8)
    t_c = np.pi / (2 * z) + elementary.tan(alpha, exact)

    return (r_b, y_c, t_c)


@scalar
def _linearisation_bound(dh, r_b, y_c, t_c, exact):
    abs_Delta_h = abs(dh)
    abs_Delta_h_plus_y_c = abs_Delta_h + y_c

    return (
        dh**2
        * (abs_Delta_h_plus_y_c * abs_Delta_h_plus_y_c**2)
        / (r_b * r_b**2 * np.sqrt(r_b**2 * t_c**2 - abs_Delta_h * (2 * y_c - abs_Delta_h)))
    )


@scalar
def _linearisation_bound_at(dh, m, z, alpha, exact):
    if not (
        (m > 0)
        & is_finite(m)
        & (z >= 1)
        & is_finite(z)
        & (z == floor(z))
        & (alpha > 0)
        & (alpha < np.pi / 4)
    ):
        return math.nan
    prepared = _prepare_linearisation_bound(m, z, alpha, exact)
    return _linearisation_bound(dh, *prepared, exact)


@scalar
def _linearisation_bound_point(dh, m, z, alpha):
    return _linearisation_bound_at(dh, m, z, alpha, True)


@loop
def _row_linearisation_bound(out, dh_values, m, z, alpha, exact):
    widen()
    for i in range(out.size):
        dh = float64(dh_values[i])

        value = _linearisation_bound_at(dh, m, z, alpha, exact)
        out[i] = value


@loop
def _fill_linearisation_bound(
    out,
    dh_values,
    m,
    z,
    alpha,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        dh_block = dh_values[start:stop]
        _row_linearisation_bound(out_block, dh_block, m, z, alpha, None)
        if has_nan(out_block):
            _row_linearisation_bound(out_block, dh_block, m, z, alpha, True)


@loop
def _row_each_linearisation_bound(out, dh_values, m_values, z_values, alpha_values, exact):
    widen()
    for i in range(out.size):
        dh = float64(dh_values[i])

        m = float64(m_values[i])

        z = float64(z_values[i])

        alpha = float64(alpha_values[i])

        value = _linearisation_bound_at(dh, m, z, alpha, exact)
        out[i] = value


@loop
def _fill_each_linearisation_bound(
    out,
    dh_values,
    m_values,
    z_values,
    alpha_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        dh_block = dh_values[start:stop]
        m_block = m_values[start:stop]
        z_block = z_values[start:stop]
        alpha_block = alpha_values[start:stop]
        _row_each_linearisation_bound(out_block, dh_block, m_block, z_block, alpha_block, None)
        if has_nan(out_block):
            _row_each_linearisation_bound(out_block, dh_block, m_block, z_block, alpha_block, True)


def linearisation_bound(
    dh: ArrayLike, m: ArrayLike, z: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Bound the excess of the first order over the exact change of thickness; it is >= 0.

    Compiled. The help of `mechproof.kernels.tooth_thickness.linearisation_bound` has all words.
    """
    if type(m) is type(z) is type(alpha) is float:
        if type(dh) is ndarray:
            row = take_row(dh, out)
            if row is not None:
                _LINEARISATION_BOUND.fill(row, dh, m, z, alpha)
                return row
        elif type(dh) is float and out is None:
            return float64(_LINEARISATION_BOUND.point(dh, m, z, alpha))
    return run(
        _LINEARISATION_BOUND,
        (
            dh,
            m,
            z,
            alpha,
        ),
        out,
    )


_LINEARISATION_BOUND = Loops(
    names=(
        "dh",
        "m",
        "z",
        "alpha",
    ),
    widths=(
        0,
        0,
        0,
        0,
    ),
    shape=(),
    at=_linearisation_bound_point,
    uniform=_fill_linearisation_bound,
    each=_fill_each_linearisation_bound,
)


@overload(linearisation_bound)
def _offer_linearisation_bound(
    dh,
    m,
    z,
    alpha,
):
    return lambda dh, m, z, alpha: _linearisation_bound_point(
        float64(dh),
        float64(m),
        float64(z),
        float64(alpha),
    )


@scalar
def _prepare_thickness_error(height_error, alpha, exact):

    return (height_error, alpha)


@scalar
def _thickness_error(e_tip, height_error, alpha, exact):

    return 2 * elementary.tan(alpha, exact) * (height_error - e_tip / 2)


@scalar
def _thickness_error_at(e_tip, height_error, alpha, exact):
    if not ((alpha > 0) & (alpha < np.pi / 4)):
        return math.nan
    prepared = _prepare_thickness_error(height_error, alpha, exact)
    return _thickness_error(e_tip, *prepared, exact)


@scalar
def _thickness_error_point(e_tip, height_error, alpha):
    return _thickness_error_at(e_tip, height_error, alpha, True)


@loop
def _row_thickness_error(out, e_tip_values, height_error, alpha, exact):
    widen()
    for i in range(out.size):
        e_tip = float64(e_tip_values[i])

        value = _thickness_error_at(e_tip, height_error, alpha, exact)
        out[i] = value


@loop
def _fill_thickness_error(
    out,
    e_tip_values,
    height_error,
    alpha,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        e_tip_block = e_tip_values[start:stop]
        _row_thickness_error(out_block, e_tip_block, height_error, alpha, None)
        if has_nan(out_block):
            _row_thickness_error(out_block, e_tip_block, height_error, alpha, True)


@loop
def _row_each_thickness_error(out, e_tip_values, height_error_values, alpha_values, exact):
    widen()
    for i in range(out.size):
        e_tip = float64(e_tip_values[i])

        height_error = float64(height_error_values[i])

        alpha = float64(alpha_values[i])

        value = _thickness_error_at(e_tip, height_error, alpha, exact)
        out[i] = value


@loop
def _fill_each_thickness_error(
    out,
    e_tip_values,
    height_error_values,
    alpha_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        e_tip_block = e_tip_values[start:stop]
        height_error_block = height_error_values[start:stop]
        alpha_block = alpha_values[start:stop]
        _row_each_thickness_error(out_block, e_tip_block, height_error_block, alpha_block, None)
        if has_nan(out_block):
            _row_each_thickness_error(out_block, e_tip_block, height_error_block, alpha_block, True)


def thickness_error(
    e_tip: ArrayLike, height_error: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the error of thickness from the tip diameter and the gauge's height.

    Compiled. The help of `mechproof.kernels.tooth_thickness.thickness_error` has all words.
    """
    if type(height_error) is type(alpha) is float:
        if type(e_tip) is ndarray:
            row = take_row(e_tip, out)
            if row is not None:
                _THICKNESS_ERROR.fill(row, e_tip, height_error, alpha)
                return row
        elif type(e_tip) is float and out is None:
            return float64(_THICKNESS_ERROR.point(e_tip, height_error, alpha))
    return run(
        _THICKNESS_ERROR,
        (
            e_tip,
            height_error,
            alpha,
        ),
        out,
    )


_THICKNESS_ERROR = Loops(
    names=(
        "e_tip",
        "height_error",
        "alpha",
    ),
    widths=(
        0,
        0,
        0,
    ),
    shape=(),
    at=_thickness_error_point,
    uniform=_fill_thickness_error,
    each=_fill_each_thickness_error,
)


@overload(thickness_error)
def _offer_thickness_error(
    e_tip,
    height_error,
    alpha,
):
    return lambda e_tip, height_error, alpha: _thickness_error_point(
        float64(e_tip),
        float64(height_error),
        float64(alpha),
    )
