"""Compiled kernels of the system `tooth_thickness`: one loop for each, by numba.

Names, arguments, domains, NaN and errors are those of `mechproof.kernels.tooth_thickness`,
and so are the formulas. Kernels take numbers and NumPy arrays. Functions that numba
compiles can call them, also with numbers and arrays mixed; arguments and results with
components are then indexed.

Tests hold them to the same accuracy bounds. Proved bounds on rounding errors, as help
states them, hold for these kernels where it says `compiled`, otherwise for NumPy's.

Elementary functions: `elementary` 2b535d4ac6f8.

Generated from the derivation tooth_thickness with SymPy 1.14.0.
Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""

from __future__ import annotations

import math as _math
from builtins import abs as _abs, float as _float, type as _type
from typing import Any

import numpy as _np
from numpy import float64 as _float64, ndarray as _ndarray
from numpy.typing import ArrayLike, NDArray

from mechproof.compiled_support import (
    Loops as _Loops,
    fill_blocks as _fill_blocks,
    floor as _floor,
    is_finite as _is_finite,
    loop as _loop,
    point_of as _point_of,
    run as _run,
    scalar as _scalar,
    take_row as _take_row,
)
from mechproof.kernels.compiled import elementary as _elementary

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


@_scalar
def _value_of_constant_chord(m, alpha, _exact):
    if not ((alpha > 0) & (alpha < _np.pi / 4) & (m > 0) & _is_finite(m)):
        return _math.nan
    return _np.pi * _elementary.cos(alpha, _exact) ** 2 / 2 * m


@_loop
def _fill_of_constant_chord(_out, m, alpha):
    _fill_blocks(_value_of_constant_chord, _out, (m, alpha))


def constant_chord(m: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the constant chord, between the points where a rack touches both flanks.

    Compiled. Its full documentation is that of
    `mechproof.kernels.tooth_thickness.constant_chord`.
    """
    if _type(alpha) is _float:
        if _type(m) is _ndarray and (_row := _take_row(m, out)) is not None:
            _loops_of_constant_chord.fill(_row, m, alpha)
            return _row
        if _type(m) is _float and out is None:
            return _float64(_loops_of_constant_chord.point(m, alpha))
    return _run(_loops_of_constant_chord, (m, alpha), out)


@_point_of(constant_chord, spread=True)
def _point_of_constant_chord(m, alpha):
    return _value_of_constant_chord(_float64(m), _float64(alpha), True)


_loops_of_constant_chord = _Loops(("m", "alpha"), _point_of_constant_chord, _fill_of_constant_chord)


@_scalar
def _value_of_chord_height(m, alpha, _exact):
    if not ((alpha > 0) & (alpha < _np.pi / 4) & (m > 0) & _is_finite(m)):
        return _math.nan
    return (1 - _np.pi * _elementary.sin(2 * alpha, _exact) / 8) * m


@_loop
def _fill_of_chord_height(_out, m, alpha):
    _fill_blocks(_value_of_chord_height, _out, (m, alpha))


def chord_height(m: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the height from the tip circle to the constant chord, addendum of one module.

    Compiled. Its full documentation is that of
    `mechproof.kernels.tooth_thickness.chord_height`.
    """
    if _type(alpha) is _float:
        if _type(m) is _ndarray and (_row := _take_row(m, out)) is not None:
            _loops_of_chord_height.fill(_row, m, alpha)
            return _row
        if _type(m) is _float and out is None:
            return _float64(_loops_of_chord_height.point(m, alpha))
    return _run(_loops_of_chord_height, (m, alpha), out)


@_point_of(chord_height, spread=True)
def _point_of_chord_height(m, alpha):
    return _value_of_chord_height(_float64(m), _float64(alpha), True)


_loops_of_chord_height = _Loops(("m", "alpha"), _point_of_chord_height, _fill_of_chord_height)


@_scalar
def _value_of_height_change(tilt, m, z, alpha, _exact):
    if not (
        (m > 0)
        & _is_finite(m)
        & (z >= 1)
        & _is_finite(z)
        & (z == _floor(z))
        & (alpha > 0)
        & (alpha < _np.pi / 4)
    ):
        return _math.nan
    cosm1_alpha = -2 * _elementary.sin(alpha / 2, _exact) ** 2
    cos_alpha = 1 + cosm1_alpha
    r_b = cos_alpha * m * z / 2
    t_c = _np.pi / (2 * z) + _elementary.tan(alpha, _exact)
    sin_tilt = _elementary.sin(tilt, _exact)
    cosm1_tilt = -2 * _elementary.sin(tilt / 2, _exact) ** 2
    cos_tilt = 1 + cosm1_tilt
    return r_b * (
        _elementary.sin(alpha, _exact) * (sin_tilt - cos_tilt * tilt - t_c * cosm1_tilt)
        - cos_alpha * (cosm1_tilt + t_c * sin_tilt + sin_tilt * tilt)
    )


@_loop
def _fill_of_height_change(_out, tilt, m, z, alpha):
    _fill_blocks(_value_of_height_change, _out, (tilt, m, z, alpha))


def height_change(
    tilt: ArrayLike,
    m: ArrayLike,
    z: ArrayLike,
    alpha: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute how much deeper than the constant chord the chord lies, by its flank's tangent.

    Compiled. Its full documentation is that of
    `mechproof.kernels.tooth_thickness.height_change`.
    """
    if _type(m) is _type(z) is _type(alpha) is _float:
        if _type(tilt) is _ndarray and (_row := _take_row(tilt, out)) is not None:
            _loops_of_height_change.fill(_row, tilt, m, z, alpha)
            return _row
        if _type(tilt) is _float and out is None:
            return _float64(_loops_of_height_change.point(tilt, m, z, alpha))
    return _run(_loops_of_height_change, (tilt, m, z, alpha), out)


@_point_of(height_change, spread=True)
def _point_of_height_change(tilt, m, z, alpha):
    return _value_of_height_change(_float64(tilt), _float64(m), _float64(z), _float64(alpha), True)


_loops_of_height_change = _Loops(
    ("tilt", "m", "z", "alpha"), _point_of_height_change, _fill_of_height_change
)


@_scalar
def _value_of_thickness_change(tilt, m, z, alpha, _exact):
    if not (
        (m > 0)
        & _is_finite(m)
        & (z >= 1)
        & _is_finite(z)
        & (z == _floor(z))
        & (alpha > 0)
        & (alpha < _np.pi / 4)
    ):
        return _math.nan
    cosm1_alpha = -2 * _elementary.sin(alpha / 2, _exact) ** 2
    cos_alpha = 1 + cosm1_alpha
    r_b = cos_alpha * m * z / 2
    t_c = _np.pi / (2 * z) + _elementary.tan(alpha, _exact)
    sin_tilt = _elementary.sin(tilt, _exact)
    cosm1_tilt = -2 * _elementary.sin(tilt / 2, _exact) ** 2
    cos_tilt = 1 + cosm1_tilt
    return (
        -2
        * r_b
        * (
            cos_alpha * (sin_tilt - cos_tilt * tilt - t_c * cosm1_tilt)
            + _elementary.sin(alpha, _exact) * (cosm1_tilt + t_c * sin_tilt + sin_tilt * tilt)
        )
    )


@_loop
def _fill_of_thickness_change(_out, tilt, m, z, alpha):
    _fill_blocks(_value_of_thickness_change, _out, (tilt, m, z, alpha))


def thickness_change(
    tilt: ArrayLike,
    m: ArrayLike,
    z: ArrayLike,
    alpha: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute how much thicker than the constant chord the chord is, by its flank's tangent.

    Compiled. Its full documentation is that of
    `mechproof.kernels.tooth_thickness.thickness_change`.
    """
    if _type(m) is _type(z) is _type(alpha) is _float:
        if _type(tilt) is _ndarray and (_row := _take_row(tilt, out)) is not None:
            _loops_of_thickness_change.fill(_row, tilt, m, z, alpha)
            return _row
        if _type(tilt) is _float and out is None:
            return _float64(_loops_of_thickness_change.point(tilt, m, z, alpha))
    return _run(_loops_of_thickness_change, (tilt, m, z, alpha), out)


@_point_of(thickness_change, spread=True)
def _point_of_thickness_change(tilt, m, z, alpha):
    return _value_of_thickness_change(
        _float64(tilt), _float64(m), _float64(z), _float64(alpha), True
    )


_loops_of_thickness_change = _Loops(
    ("tilt", "m", "z", "alpha"), _point_of_thickness_change, _fill_of_thickness_change
)


@_scalar
def _value_of_thickness_change_linear(dh, alpha, _exact):
    if not ((alpha > 0) & (alpha < _np.pi / 4)):
        return _math.nan
    return 2 * _elementary.tan(alpha, _exact) * dh


@_loop
def _fill_of_thickness_change_linear(_out, dh, alpha):
    _fill_blocks(_value_of_thickness_change_linear, _out, (dh, alpha))


def thickness_change_linear(
    dh: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the change of thickness with the height to first order, on the rack exactly.

    Compiled. Its full documentation is that of
    `mechproof.kernels.tooth_thickness.thickness_change_linear`.
    """
    if _type(alpha) is _float:
        if _type(dh) is _ndarray and (_row := _take_row(dh, out)) is not None:
            _loops_of_thickness_change_linear.fill(_row, dh, alpha)
            return _row
        if _type(dh) is _float and out is None:
            return _float64(_loops_of_thickness_change_linear.point(dh, alpha))
    return _run(_loops_of_thickness_change_linear, (dh, alpha), out)


@_point_of(thickness_change_linear, spread=True)
def _point_of_thickness_change_linear(dh, alpha):
    return _value_of_thickness_change_linear(_float64(dh), _float64(alpha), True)


_loops_of_thickness_change_linear = _Loops(
    ("dh", "alpha"), _point_of_thickness_change_linear, _fill_of_thickness_change_linear
)


@_scalar
def _value_of_linearisation_bound(dh, m, z, alpha, _exact):
    if not (
        (m > 0)
        & _is_finite(m)
        & (z >= 1)
        & _is_finite(z)
        & (z == _floor(z))
        & (alpha > 0)
        & (alpha < _np.pi / 4)
    ):
        return _math.nan
    r_b = m * z * _elementary.cos(alpha, _exact) / 2
    y_c = m * (z / 2 + _np.pi * _elementary.sin(2 * alpha, _exact) / 8)
    t_c = _np.pi / (2 * z) + _elementary.tan(alpha, _exact)
    abs_Delta_h = _abs(dh)
    abs_Delta_h_plus_y_c = abs_Delta_h + y_c
    return (
        dh**2
        * (abs_Delta_h_plus_y_c * abs_Delta_h_plus_y_c**2)
        / (r_b * r_b**2 * _np.sqrt(r_b**2 * t_c**2 - abs_Delta_h * (2 * y_c - abs_Delta_h)))
    )


@_loop
def _fill_of_linearisation_bound(_out, dh, m, z, alpha):
    _fill_blocks(_value_of_linearisation_bound, _out, (dh, m, z, alpha))


def linearisation_bound(
    dh: ArrayLike, m: ArrayLike, z: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Bound the excess of the first order over the exact change of thickness; it is >= 0.

    Compiled. Its full documentation is that of
    `mechproof.kernels.tooth_thickness.linearisation_bound`.
    """
    if _type(m) is _type(z) is _type(alpha) is _float:
        if _type(dh) is _ndarray and (_row := _take_row(dh, out)) is not None:
            _loops_of_linearisation_bound.fill(_row, dh, m, z, alpha)
            return _row
        if _type(dh) is _float and out is None:
            return _float64(_loops_of_linearisation_bound.point(dh, m, z, alpha))
    return _run(_loops_of_linearisation_bound, (dh, m, z, alpha), out)


@_point_of(linearisation_bound, spread=True)
def _point_of_linearisation_bound(dh, m, z, alpha):
    return _value_of_linearisation_bound(
        _float64(dh), _float64(m), _float64(z), _float64(alpha), True
    )


_loops_of_linearisation_bound = _Loops(
    ("dh", "m", "z", "alpha"), _point_of_linearisation_bound, _fill_of_linearisation_bound
)


@_scalar
def _value_of_thickness_error(e_tip, height_error, alpha, _exact):
    if not ((alpha > 0) & (alpha < _np.pi / 4)):
        return _math.nan
    return 2 * _elementary.tan(alpha, _exact) * (height_error - e_tip / 2)


@_loop
def _fill_of_thickness_error(_out, e_tip, height_error, alpha):
    _fill_blocks(_value_of_thickness_error, _out, (e_tip, height_error, alpha))


def thickness_error(
    e_tip: ArrayLike, height_error: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the error of thickness from the tip diameter and the gauge's height.

    Compiled. Its full documentation is that of
    `mechproof.kernels.tooth_thickness.thickness_error`.
    """
    if _type(height_error) is _type(alpha) is _float:
        if _type(e_tip) is _ndarray and (_row := _take_row(e_tip, out)) is not None:
            _loops_of_thickness_error.fill(_row, e_tip, height_error, alpha)
            return _row
        if _type(e_tip) is _float and out is None:
            return _float64(_loops_of_thickness_error.point(e_tip, height_error, alpha))
    return _run(_loops_of_thickness_error, (e_tip, height_error, alpha), out)


@_point_of(thickness_error, spread=True)
def _point_of_thickness_error(e_tip, height_error, alpha):
    return _value_of_thickness_error(_float64(e_tip), _float64(height_error), _float64(alpha), True)


_loops_of_thickness_error = _Loops(
    ("e_tip", "height_error", "alpha"), _point_of_thickness_error, _fill_of_thickness_error
)
