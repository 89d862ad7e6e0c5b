"""Compiled kernels of the system `oval_planetary`: one loop for each, by numba.

Names, arguments, domains, NaN and errors are those of `mechproof.kernels.oval_planetary`,
and so are the formulas. Kernels take numbers and NumPy arrays. Functions that numba
compiles can call them, also with numbers and arrays mixed; arguments and results with
components are then indexed.

Tests hold them to the same accuracy bounds. Proved bounds on rounding errors, as help
states them, hold for these kernels where it says `compiled`, otherwise for NumPy's.

Elementary functions: `elementary` 2b535d4ac6f8.

Generated from the derivation oval_planetary with SymPy 1.14.0.
Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""

from __future__ import annotations

import math as _math
from builtins import abs as _abs, float as _float, type as _type
from typing import Any

from numpy import float64 as _float64, ndarray as _ndarray
from numpy.typing import ArrayLike, NDArray

from mechproof.compiled_support import (
    Loops as _Loops,
    fill_blocks as _fill_blocks,
    is_finite as _is_finite,
    loop as _loop,
    point_of as _point_of,
    run as _run,
    scalar as _scalar,
    take_row as _take_row,
)
from mechproof.kernels.compiled import elementary as _elementary

__all__ = [
    "acceleration",
    "acceleration_cylindrical",
    "jerk",
    "jerk_cylindrical",
    "motion",
    "motion_cylindrical",
    "position",
    "position_cylindrical",
    "ratio",
    "ratio_cylindrical",
]


def __dir__() -> list[str]:
    return __all__


@_scalar
def _value_of_ratio(phi1, e1, e2, mount, _exact):
    if not ((e1 >= 0) & (e1 < 1) & (e2 >= 0) & (e2 < 1)):
        return _math.nan
    one_plus_e1 = 1 + e1
    both = one_plus_e1 * (1 + e2)
    one_minus_e1 = 1 - e1
    one_minus_e2 = 1 - e2
    less = one_minus_e1 * one_minus_e2
    sin_mount = _elementary.sin(mount, _exact)
    lever = 4 * e2 * sin_mount / one_minus_e2
    shift = lever * one_minus_e1 * sin_mount
    rise = lever * one_plus_e1 * _elementary.cos(mount, _exact)
    tan_phi1_below = _elementary.tangent_below(phi1, _exact)
    tan_phi1 = _elementary.tangent_above(phi1, _exact)
    y = shift * tan_phi1_below + rise * tan_phi1
    tan_phi1_squared = tan_phi1**2
    return 1 - both * (less + shift) / (
        both**2 * tan_phi1_squared + (less * tan_phi1_below + y) ** 2
    ) * (tan_phi1_below * tan_phi1_below + tan_phi1_squared)


@_loop
def _fill_of_ratio(_out, phi1, e1, e2, mount):
    _fill_blocks(_value_of_ratio, _out, (phi1, e1, e2, mount))


def ratio(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute the transmission ratio d phi3/d phi1 of the output wheel to the carrier.

    Compiled. Its full documentation is that of
    `mechproof.kernels.oval_planetary.ratio`.
    """
    if _type(e1) is _type(e2) is _type(mount) is _float:
        if _type(phi1) is _ndarray and (_row := _take_row(phi1, out)) is not None:
            _loops_of_ratio.fill(_row, phi1, e1, e2, mount)
            return _row
        if _type(phi1) is _float and out is None:
            return _float64(_loops_of_ratio.point(phi1, e1, e2, mount))
    return _run(_loops_of_ratio, (phi1, e1, e2, mount), out)


@_point_of(ratio, spread=True)
def _point_of_ratio(phi1, e1, e2, mount=0.0):
    return _value_of_ratio(_float64(phi1), _float64(e1), _float64(e2), _float64(mount), True)


_loops_of_ratio = _Loops(("phi1", "e1", "e2", "mount"), _point_of_ratio, _fill_of_ratio)


@_scalar
def _value_of_position(phi1, e1, e2, mount, _exact):
    if not ((e1 >= 0) & (e1 < 1) & (e2 >= 0) & (e2 < 1)):
        return _math.nan
    sin_mount = _elementary.sin(mount, _exact)
    one_minus_e2 = 1 - e2
    lever = 4 * e2 * sin_mount / one_minus_e2
    one_minus_e1 = 1 - e1
    shift = lever * one_minus_e1 * sin_mount
    one_plus_e1 = 1 + e1
    rise = lever * one_plus_e1 * _elementary.cos(mount, _exact)
    swing = 2 * e1 + 2 * e2
    less = one_minus_e1 * one_minus_e2
    both = one_plus_e1 * (1 + e2)
    tan_phi1 = _elementary.tan(phi1, _exact)
    y = shift + rise * tan_phi1
    return _elementary.arctan2(tan_phi1 * (y - swing), less + y + both * tan_phi1**2)


@_loop
def _fill_of_position(_out, phi1, e1, e2, mount):
    _fill_blocks(_value_of_position, _out, (phi1, e1, e2, mount))


def position(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute the position function phi3(phi1) of the output wheel, phi3(0) = 0.

    Compiled. Its full documentation is that of
    `mechproof.kernels.oval_planetary.position`.
    """
    if _type(e1) is _type(e2) is _type(mount) is _float:
        if _type(phi1) is _ndarray and (_row := _take_row(phi1, out)) is not None:
            _loops_of_position.fill(_row, phi1, e1, e2, mount)
            return _row
        if _type(phi1) is _float and out is None:
            return _float64(_loops_of_position.point(phi1, e1, e2, mount))
    return _run(_loops_of_position, (phi1, e1, e2, mount), out)


@_point_of(position, spread=True)
def _point_of_position(phi1, e1, e2, mount=0.0):
    return _value_of_position(_float64(phi1), _float64(e1), _float64(e2), _float64(mount), True)


_loops_of_position = _Loops(("phi1", "e1", "e2", "mount"), _point_of_position, _fill_of_position)


@_scalar
def _value_of_acceleration(phi1, e1, e2, mount, _exact):
    if not ((e1 >= 0) & (e1 < 1) & (e2 >= 0) & (e2 < 1)):
        return _math.nan
    one_plus_e1 = 1 + e1
    one_plus_e2 = 1 + e2
    both_high = one_plus_e1 * one_plus_e2
    one_plus_e2_low = _elementary.sum_rest(1, e2, one_plus_e2)
    one_plus_e1_low = _elementary.sum_rest(1, e1, one_plus_e1)
    both_low = (
        one_plus_e1 * one_plus_e2_low
        + one_plus_e1_low * one_plus_e2
        + _elementary.product_rest(one_plus_e1, one_plus_e2, both_high)
    )
    both = both_high + both_low
    one_minus_e1 = 1 - e1
    one_minus_e2 = 1 - e2
    less_high = one_minus_e1 * one_minus_e2
    one_minus_e2_low = _elementary.sum_rest(1, -e2, one_minus_e2)
    one_minus_e1_low = _elementary.sum_rest(1, -e1, one_minus_e1)
    less_low = (
        one_minus_e1 * one_minus_e2_low
        + one_minus_e1_low * one_minus_e2
        + _elementary.product_rest(one_minus_e1, one_minus_e2, less_high)
    )
    less = less_high + less_low
    sin_mount = _elementary.sin(mount, _exact)
    lever = 4 * e2 * sin_mount / one_minus_e2
    shift = lever * one_minus_e1 * sin_mount
    rise = lever * one_plus_e1 * _elementary.cos(mount, _exact)
    swing = 2 * e1 + 2 * e2
    tan_phi1_below = _elementary.tangent_below(phi1, _exact)
    tan_phi1 = _elementary.tangent_above(phi1, _exact)
    y = shift * tan_phi1_below + rise * tan_phi1
    tan_phi1_squared = tan_phi1**2
    return (
        2
        * both
        * (less + shift)
        / (both**2 * tan_phi1_squared + (less * tan_phi1_below + y) ** 2) ** 2
        * (tan_phi1_below * tan_phi1_below + tan_phi1_squared)
        * (
            (swing * (both + less) - 2 * less * shift) * tan_phi1 * tan_phi1_below
            + y * (rise * tan_phi1_below - shift * tan_phi1)
            + less * rise * (tan_phi1_below * tan_phi1_below - tan_phi1_squared)
        )
    )


@_loop
def _fill_of_acceleration(_out, phi1, e1, e2, mount):
    _fill_blocks(_value_of_acceleration, _out, (phi1, e1, e2, mount))


def acceleration(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute d ratio/d phi1, the angular acceleration of the output at unit carrier speed.

    Compiled. Its full documentation is that of
    `mechproof.kernels.oval_planetary.acceleration`.
    """
    if _type(e1) is _type(e2) is _type(mount) is _float:
        if _type(phi1) is _ndarray and (_row := _take_row(phi1, out)) is not None:
            _loops_of_acceleration.fill(_row, phi1, e1, e2, mount)
            return _row
        if _type(phi1) is _float and out is None:
            return _float64(_loops_of_acceleration.point(phi1, e1, e2, mount))
    return _run(_loops_of_acceleration, (phi1, e1, e2, mount), out)


@_point_of(acceleration, spread=True)
def _point_of_acceleration(phi1, e1, e2, mount=0.0):
    return _value_of_acceleration(_float64(phi1), _float64(e1), _float64(e2), _float64(mount), True)


_loops_of_acceleration = _Loops(
    ("phi1", "e1", "e2", "mount"), _point_of_acceleration, _fill_of_acceleration
)


@_scalar
def _value_of_ratio_cylindrical(phi1, R4, R5, e2, _exact):
    if not ((R4 > 0) & _is_finite(R4) & (R5 > 0) & _is_finite(R5) & (e2 >= 0) & (e2 < 1)):
        return _math.nan
    k = R4 / R5
    one_minus_e2 = 1 - e2
    one_plus_e2 = 1 + e2
    k_low = _elementary.quotient_rest(R4, R5, k)
    x = 2 * k * phi1
    t_angle = x / 2
    t_below = _elementary.tangent_below(t_angle, _exact)
    t = _elementary.tangent_above(t_angle, _exact)
    x_low = 2 * k_low * phi1 + 2 * _elementary.product_rest(k, phi1, x / 2)
    t_low = _elementary.small_tangent(x_low / 2)
    adjacent = t_below - t * t_low
    adjacent_squared = adjacent**2
    opposite = t + t_low * t_below
    opposite_squared = opposite**2
    return 1 - k * one_minus_e2 * one_plus_e2 / (
        one_minus_e2**2 * adjacent_squared + one_plus_e2**2 * opposite_squared
    ) * (adjacent_squared + opposite_squared)


@_loop
def _fill_of_ratio_cylindrical(_out, phi1, R4, R5, e2):
    _fill_blocks(_value_of_ratio_cylindrical, _out, (phi1, R4, R5, e2))


def ratio_cylindrical(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the ratio d phi3/d phi1 with a cylindrical pair 4-5.

    Compiled. Its full documentation is that of
    `mechproof.kernels.oval_planetary.ratio_cylindrical`.
    """
    if _type(R4) is _type(R5) is _type(e2) is _float:
        if _type(phi1) is _ndarray and (_row := _take_row(phi1, out)) is not None:
            _loops_of_ratio_cylindrical.fill(_row, phi1, R4, R5, e2)
            return _row
        if _type(phi1) is _float and out is None:
            return _float64(_loops_of_ratio_cylindrical.point(phi1, R4, R5, e2))
    return _run(_loops_of_ratio_cylindrical, (phi1, R4, R5, e2), out)


@_point_of(ratio_cylindrical, spread=True)
def _point_of_ratio_cylindrical(phi1, R4, R5, e2):
    return _value_of_ratio_cylindrical(
        _float64(phi1), _float64(R4), _float64(R5), _float64(e2), True
    )


_loops_of_ratio_cylindrical = _Loops(
    ("phi1", "R4", "R5", "e2"), _point_of_ratio_cylindrical, _fill_of_ratio_cylindrical
)


@_scalar
def _form_1_of_position_cylindrical(phi1, R4, R5, e2, _exact):
    k = R4 / R5
    one_minus_e2 = 1 - e2
    one_plus_e2 = 1 + e2
    x = 2 * k * phi1
    t_angle = x / 2
    t_below = _elementary.tangent_below(t_angle, _exact)
    t = _elementary.tangent_above(t_angle, _exact)
    return (R5 - R4) / R5 * phi1 - _elementary.arctan_quotient(
        2 * e2 * t * t_below, one_minus_e2 * t_below * t_below + one_plus_e2 * t**2
    )


@_scalar
def _value_of_position_cylindrical(phi1, R4, R5, e2, _exact):
    if not ((R4 > 0) & _is_finite(R4) & (R5 > 0) & _is_finite(R5) & (e2 >= 0) & (e2 < 1)):
        return _math.nan
    if e2 * R4 <= (1 - e2) * _abs(R4 - R5):
        return _form_1_of_position_cylindrical(phi1, R4, R5, e2, _exact)
    k = R4 / R5
    k_low = _elementary.quotient_rest(R4, R5, k)
    one_minus_e2 = 1 - e2
    one_plus_e2 = 1 + e2
    x = 2 * k * phi1
    t_angle = x / 2
    t_below = _elementary.tangent_below(t_angle, _exact)
    t = _elementary.tangent_above(t_angle, _exact)
    x_low = 2 * k_low * phi1 + 2 * _elementary.product_rest(k, phi1, x / 2)
    t_low = _elementary.small_tangent(x_low / 2)
    adjacent = t_below - t * t_low
    opposite = t + t_low * t_below
    return (R5 - R4) / R5 * phi1 - _elementary.arctan_quotient(
        2 * e2 * adjacent * opposite, one_minus_e2 * adjacent**2 + one_plus_e2 * opposite**2
    )


@_loop
def _fill_of_position_cylindrical(_out, phi1, R4, R5, e2):
    _fill_blocks(_value_of_position_cylindrical, _out, (phi1, R4, R5, e2))


def position_cylindrical(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the position function phi3(phi1) with a cylindrical pair 4-5, phi3(0) = 0.

    Compiled. Its full documentation is that of
    `mechproof.kernels.oval_planetary.position_cylindrical`.
    """
    if _type(R4) is _type(R5) is _type(e2) is _float:
        if _type(phi1) is _ndarray and (_row := _take_row(phi1, out)) is not None:
            _loops_of_position_cylindrical.fill(_row, phi1, R4, R5, e2)
            return _row
        if _type(phi1) is _float and out is None:
            return _float64(_loops_of_position_cylindrical.point(phi1, R4, R5, e2))
    return _run(_loops_of_position_cylindrical, (phi1, R4, R5, e2), out)


@_point_of(position_cylindrical, spread=True)
def _point_of_position_cylindrical(phi1, R4, R5, e2):
    return _value_of_position_cylindrical(
        _float64(phi1), _float64(R4), _float64(R5), _float64(e2), True
    )


_loops_of_position_cylindrical = _Loops(
    ("phi1", "R4", "R5", "e2"), _point_of_position_cylindrical, _fill_of_position_cylindrical
)


@_scalar
def _value_of_acceleration_cylindrical(phi1, R4, R5, e2, _exact):
    if not ((R4 > 0) & _is_finite(R4) & (R5 > 0) & _is_finite(R5) & (e2 >= 0) & (e2 < 1)):
        return _math.nan
    k = R4 / R5
    k_low = _elementary.quotient_rest(R4, R5, k)
    one_minus_e2 = 1 - e2
    one_plus_e2 = 1 + e2
    x = 2 * k * phi1
    t_angle = x / 2
    t_below = _elementary.tangent_below(t_angle, _exact)
    t = _elementary.tangent_above(t_angle, _exact)
    x_low = 2 * k_low * phi1 + 2 * _elementary.product_rest(k, phi1, x / 2)
    t_low = _elementary.small_tangent(x_low / 2)
    adjacent = t_below - t * t_low
    opposite = t + t_low * t_below
    adjacent_squared = adjacent**2
    opposite_squared = opposite**2
    return (
        8
        * e2
        * one_minus_e2
        * one_plus_e2
        * k**2
        / (one_minus_e2**2 * adjacent_squared + one_plus_e2**2 * opposite_squared) ** 2
        * adjacent
        * opposite
        * (adjacent_squared + opposite_squared)
    )


@_loop
def _fill_of_acceleration_cylindrical(_out, phi1, R4, R5, e2):
    _fill_blocks(_value_of_acceleration_cylindrical, _out, (phi1, R4, R5, e2))


def acceleration_cylindrical(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute d ratio/d phi1 with a cylindrical pair 4-5.

    Compiled. Its full documentation is that of
    `mechproof.kernels.oval_planetary.acceleration_cylindrical`.
    """
    if _type(R4) is _type(R5) is _type(e2) is _float:
        if _type(phi1) is _ndarray and (_row := _take_row(phi1, out)) is not None:
            _loops_of_acceleration_cylindrical.fill(_row, phi1, R4, R5, e2)
            return _row
        if _type(phi1) is _float and out is None:
            return _float64(_loops_of_acceleration_cylindrical.point(phi1, R4, R5, e2))
    return _run(_loops_of_acceleration_cylindrical, (phi1, R4, R5, e2), out)


@_point_of(acceleration_cylindrical, spread=True)
def _point_of_acceleration_cylindrical(phi1, R4, R5, e2):
    return _value_of_acceleration_cylindrical(
        _float64(phi1), _float64(R4), _float64(R5), _float64(e2), True
    )


_loops_of_acceleration_cylindrical = _Loops(
    ("phi1", "R4", "R5", "e2"),
    _point_of_acceleration_cylindrical,
    _fill_of_acceleration_cylindrical,
)


@_scalar
def _value_of_jerk(phi1, e1, e2, mount, _exact):
    if not ((e1 >= 0) & (e1 < 1) & (e2 >= 0) & (e2 < 1)):
        return _math.nan
    one_plus_e1 = 1 + e1
    one_plus_e2 = 1 + e2
    both_high = one_plus_e1 * one_plus_e2
    one_plus_e2_low = _elementary.sum_rest(1, e2, one_plus_e2)
    one_plus_e1_low = _elementary.sum_rest(1, e1, one_plus_e1)
    both_low = (
        one_plus_e1 * one_plus_e2_low
        + one_plus_e1_low * one_plus_e2
        + _elementary.product_rest(one_plus_e1, one_plus_e2, both_high)
    )
    both = both_high + both_low
    one_minus_e1 = 1 - e1
    one_minus_e2 = 1 - e2
    less_high = one_minus_e1 * one_minus_e2
    one_minus_e2_low = _elementary.sum_rest(1, -e2, one_minus_e2)
    one_minus_e1_low = _elementary.sum_rest(1, -e1, one_minus_e1)
    less_low = (
        one_minus_e1 * one_minus_e2_low
        + one_minus_e1_low * one_minus_e2
        + _elementary.product_rest(one_minus_e1, one_minus_e2, less_high)
    )
    less = less_high + less_low
    sin_mount = _elementary.sin(mount, _exact)
    lever = 4 * e2 * sin_mount / one_minus_e2
    shift = lever * one_minus_e1 * sin_mount
    less_plus_shift = less + shift
    rise = lever * one_plus_e1 * _elementary.cos(mount, _exact)
    swing = 2 * e1 + 2 * e2
    swing_both_plus_less = swing * (both + less)
    tan_phi1_below = _elementary.tangent_below(phi1, _exact)
    tan_phi1 = _elementary.tangent_above(phi1, _exact)
    y = shift * tan_phi1_below + rise * tan_phi1
    tan_phi1_squared = tan_phi1**2
    term = both**2 * tan_phi1_squared + (less * tan_phi1_below + y) ** 2
    term_2 = tan_phi1_below * tan_phi1_below - tan_phi1_squared
    return (
        2
        * both
        * less_plus_shift
        / term**2
        * (tan_phi1_below * tan_phi1_below + tan_phi1_squared)
        * (
            (rise**2 + swing_both_plus_less) * term_2
            - 4
            / term
            * (
                (swing_both_plus_less - 2 * less * shift) * tan_phi1 * tan_phi1_below
                + y * (rise * tan_phi1_below - shift * tan_phi1)
                + less * rise * term_2
            )
            ** 2
            - 4 * less_plus_shift * rise * tan_phi1 * tan_phi1_below
            - shift * (2 * less + shift) * term_2
        )
    )


@_loop
def _fill_of_jerk(_out, phi1, e1, e2, mount):
    _fill_blocks(_value_of_jerk, _out, (phi1, e1, e2, mount))


def jerk(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute d acceleration/d phi1, the jerk of the output at unit carrier speed.

    Compiled. Its full documentation is that of
    `mechproof.kernels.oval_planetary.jerk`.
    """
    if _type(e1) is _type(e2) is _type(mount) is _float:
        if _type(phi1) is _ndarray and (_row := _take_row(phi1, out)) is not None:
            _loops_of_jerk.fill(_row, phi1, e1, e2, mount)
            return _row
        if _type(phi1) is _float and out is None:
            return _float64(_loops_of_jerk.point(phi1, e1, e2, mount))
    return _run(_loops_of_jerk, (phi1, e1, e2, mount), out)


@_point_of(jerk, spread=True)
def _point_of_jerk(phi1, e1, e2, mount=0.0):
    return _value_of_jerk(_float64(phi1), _float64(e1), _float64(e2), _float64(mount), True)


_loops_of_jerk = _Loops(("phi1", "e1", "e2", "mount"), _point_of_jerk, _fill_of_jerk)


@_scalar
def _value_of_jerk_cylindrical(phi1, R4, R5, e2, _exact):
    if not ((R4 > 0) & _is_finite(R4) & (R5 > 0) & _is_finite(R5) & (e2 >= 0) & (e2 < 1)):
        return _math.nan
    one_minus_e2 = 1 - e2
    one_plus_e2 = 1 + e2
    k = R4 / R5
    k_low = _elementary.quotient_rest(R4, R5, k)
    one_minus_e2_squared = one_minus_e2**2
    one_plus_e2_squared = one_plus_e2**2
    x = 2 * k * phi1
    t_angle = x / 2
    t_below = _elementary.tangent_below(t_angle, _exact)
    t = _elementary.tangent_above(t_angle, _exact)
    x_low = 2 * k_low * phi1 + 2 * _elementary.product_rest(k, phi1, x / 2)
    t_low = _elementary.small_tangent(x_low / 2)
    adjacent = t_below - t * t_low
    adjacent_squared = adjacent**2
    opposite = t + t_low * t_below
    opposite_squared = opposite**2
    base = one_minus_e2_squared * adjacent_squared + one_plus_e2_squared * opposite_squared
    return (
        8
        * e2
        * one_minus_e2
        * one_plus_e2
        * (k * k**2)
        / (base * base**2)
        * (adjacent_squared + opposite_squared)
        * (
            one_minus_e2_squared * (adjacent**2) ** 2
            - one_plus_e2_squared * (opposite**2) ** 2
            - 12 * e2 * adjacent_squared * opposite_squared
        )
    )


@_loop
def _fill_of_jerk_cylindrical(_out, phi1, R4, R5, e2):
    _fill_blocks(_value_of_jerk_cylindrical, _out, (phi1, R4, R5, e2))


def jerk_cylindrical(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute d acceleration/d phi1 with a cylindrical pair 4-5.

    Compiled. Its full documentation is that of
    `mechproof.kernels.oval_planetary.jerk_cylindrical`.
    """
    if _type(R4) is _type(R5) is _type(e2) is _float:
        if _type(phi1) is _ndarray and (_row := _take_row(phi1, out)) is not None:
            _loops_of_jerk_cylindrical.fill(_row, phi1, R4, R5, e2)
            return _row
        if _type(phi1) is _float and out is None:
            return _float64(_loops_of_jerk_cylindrical.point(phi1, R4, R5, e2))
    return _run(_loops_of_jerk_cylindrical, (phi1, R4, R5, e2), out)


@_point_of(jerk_cylindrical, spread=True)
def _point_of_jerk_cylindrical(phi1, R4, R5, e2):
    return _value_of_jerk_cylindrical(
        _float64(phi1), _float64(R4), _float64(R5), _float64(e2), True
    )


_loops_of_jerk_cylindrical = _Loops(
    ("phi1", "R4", "R5", "e2"), _point_of_jerk_cylindrical, _fill_of_jerk_cylindrical
)


@_scalar
def _value_of_motion(phi1, e1, e2, mount, _exact):
    return (
        _value_of_position(phi1, e1, e2, mount, _exact),
        _value_of_ratio(phi1, e1, e2, mount, _exact),
        _value_of_acceleration(phi1, e1, e2, mount, _exact),
    )


@_loop
def _fill_of_motion(_out_of_position, _out_of_ratio, _out_of_acceleration, phi1, e1, e2, mount):
    _fill_blocks(
        _value_of_motion,
        (_out_of_position, _out_of_ratio, _out_of_acceleration),
        (phi1, e1, e2, mount),
    )


def motion(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute position, ratio and acceleration in one pass.

    They lie along the first axis of the result, each with the bits of its own kernel. Compiled.
    """
    return _run(_loops_of_motion, (phi1, e1, e2, mount), out)


@_point_of(motion)
def _point_of_motion(phi1, e1, e2, mount=0.0):
    return _value_of_motion(_float64(phi1), _float64(e1), _float64(e2), _float64(mount), True)


_loops_of_motion = _Loops(
    ("phi1", "e1", "e2", "mount"), _point_of_motion, _fill_of_motion, results=3
)


@_scalar
def _value_of_motion_cylindrical(phi1, R4, R5, e2, _exact):
    return (
        _value_of_position_cylindrical(phi1, R4, R5, e2, _exact),
        _value_of_ratio_cylindrical(phi1, R4, R5, e2, _exact),
        _value_of_acceleration_cylindrical(phi1, R4, R5, e2, _exact),
    )


@_loop
def _fill_of_motion_cylindrical(
    _out_of_position_cylindrical,
    _out_of_ratio_cylindrical,
    _out_of_acceleration_cylindrical,
    phi1,
    R4,
    R5,
    e2,
):
    _fill_blocks(
        _value_of_motion_cylindrical,
        (_out_of_position_cylindrical, _out_of_ratio_cylindrical, _out_of_acceleration_cylindrical),
        (phi1, R4, R5, e2),
    )


def motion_cylindrical(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute position_cylindrical, ratio_cylindrical and acceleration_cylindrical in one pass.

    They lie along the first axis of the result, each with the bits of its own kernel. Compiled.
    """
    return _run(_loops_of_motion_cylindrical, (phi1, R4, R5, e2), out)


@_point_of(motion_cylindrical)
def _point_of_motion_cylindrical(phi1, R4, R5, e2):
    return _value_of_motion_cylindrical(
        _float64(phi1), _float64(R4), _float64(R5), _float64(e2), True
    )


_loops_of_motion_cylindrical = _Loops(
    ("phi1", "R4", "R5", "e2"), _point_of_motion_cylindrical, _fill_of_motion_cylindrical, results=3
)
