"""Compiled kernels of the system `elliptic_planetary`: one loop for each, by numba.

Names, arguments, domains, NaN and errors are those of `mechproof.kernels.elliptic_planetary`,
and so are the formulas. Kernels take numbers and NumPy arrays. Functions that numba
compiles can call them, also with numbers and arrays mixed; arguments and results with
components are then indexed.

Tests hold them to the same accuracy bounds. Proved bounds on rounding errors, as help
states them, hold for these kernels where it says `compiled`, otherwise for NumPy's.

Elementary functions: `elementary` 2b535d4ac6f8.

Generated from the derivation elliptic_planetary with SymPy 1.14.0.
Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""

from __future__ import annotations

import math as _math
from builtins import float as _float, type as _type
from typing import Any

import numpy as _np
from numpy import float64 as _float64, ndarray as _ndarray
from numpy.typing import ArrayLike, NDArray

from mechproof.compiled_support import (
    Loops as _Loops,
    choose as _choose,
    fill as _fill,
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
    "angle_of_largest_jerk",
    "angle_of_smallest_acceleration",
    "eccentricity_of_extremes",
    "eccentricity_of_largest_ratio",
    "eccentricity_of_non_uniformity",
    "eccentricity_of_quotient",
    "eccentricity_of_smallest_ratio",
    "jerk",
    "largest_acceleration",
    "largest_jerk",
    "largest_ratio",
    "motion",
    "position",
    "radii_of_extremes",
    "ratio",
    "smallest_jerk",
    "smallest_ratio",
]


def __dir__() -> list[str]:
    return __all__


@_scalar
def _value_of_ratio(phi1, R1, R2, e, _exact):
    if not ((R1 > 0) & _is_finite(R1) & (R2 > 0) & _is_finite(R2) & (e >= 0) & (e < 1) & (R2 < R1)):
        return _math.nan
    k = R1 / R2
    one_minus_e = 1 - e
    one_plus_e = 1 + e
    k_low = _elementary.quotient_rest(R1, R2, k)
    x = k * phi1
    t_angle = x / 2
    t_below = _elementary.tangent_below(t_angle, _exact)
    t = _elementary.tangent_above(t_angle, _exact)
    x_low = k_low * phi1 + _elementary.product_rest(k, phi1, x)
    t_low = _elementary.small_tangent(x_low / 2)
    adjacent = t_below - t * t_low
    adjacent_squared = adjacent**2
    opposite = t + t_low * t_below
    opposite_squared = opposite**2
    return 1 + k * one_minus_e * one_plus_e / (
        one_minus_e**2 * adjacent_squared + one_plus_e**2 * opposite_squared
    ) * (adjacent_squared + opposite_squared)


@_loop
def _fill_of_ratio(_out, phi1, R1, R2, e):
    _fill_blocks(_value_of_ratio, _out, (phi1, R1, R2, e))


def ratio(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the transmission ratio d phi3/d phi1 of the output wheel to the carrier.

    Compiled. Its full documentation is that of
    `mechproof.kernels.elliptic_planetary.ratio`.
    """
    if _type(R1) is _type(R2) is _type(e) is _float:
        if _type(phi1) is _ndarray and (_row := _take_row(phi1, out)) is not None:
            _loops_of_ratio.fill(_row, phi1, R1, R2, e)
            return _row
        if _type(phi1) is _float and out is None:
            return _float64(_loops_of_ratio.point(phi1, R1, R2, e))
    return _run(_loops_of_ratio, (phi1, R1, R2, e), out)


@_point_of(ratio, spread=True)
def _point_of_ratio(phi1, R1, R2, e):
    return _value_of_ratio(_float64(phi1), _float64(R1), _float64(R2), _float64(e), True)


_loops_of_ratio = _Loops(("phi1", "R1", "R2", "e"), _point_of_ratio, _fill_of_ratio)


@_scalar
def _form_1_of_position(phi1, R1, R2, e, _exact):
    k = R1 / R2
    half_k = k / 2
    one_minus_e = 1 - e
    one_minus_e_low = _elementary.sum_rest(1, -e, one_minus_e)
    one_plus_e = 1 + e
    return (1 + k) * phi1 + 2 * _elementary.small_arctan(
        _elementary.tangent_quotient(
            half_k * phi1, 2 * e, one_minus_e, one_minus_e_low, one_plus_e, _exact
        )
    )


@_scalar
def _value_of_position(phi1, R1, R2, e, _exact):
    if not ((R1 > 0) & _is_finite(R1) & (R2 > 0) & _is_finite(R2) & (e >= 0) & (e < 1) & (R2 < R1)):
        return _math.nan
    if e <= 12 / 25:
        return _form_1_of_position(phi1, R1, R2, e, _exact)
    k = R1 / R2
    k_low = _elementary.quotient_rest(R1, R2, k)
    one_minus_e = 1 - e
    one_plus_e = 1 + e
    x = k * phi1
    x_low = k_low * phi1 + _elementary.product_rest(k, phi1, x)
    phi1_plus_x_low = phi1 + x_low
    t_angle = x / 2
    t_below = _elementary.tangent_below(t_angle, _exact)
    t = _elementary.tangent_above(t_angle, _exact)
    t_low = _elementary.small_tangent(x_low / 2)
    adjacent = t_below - t * t_low
    opposite = t + t_low * t_below
    return (
        phi1_plus_x_low
        + x
        + 2
        * _elementary.arctan_quotient(
            2 * e * adjacent * opposite, one_minus_e * adjacent**2 + one_plus_e * opposite**2
        )
    )


@_loop
def _fill_of_position(_out, phi1, R1, R2, e):
    _fill_blocks(_value_of_position, _out, (phi1, R1, R2, e))


def position(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the position function phi3(phi1) of the output wheel, phi3(0) = 0.

    Compiled. Its full documentation is that of
    `mechproof.kernels.elliptic_planetary.position`.
    """
    if _type(R1) is _type(R2) is _type(e) is _float:
        if _type(phi1) is _ndarray and (_row := _take_row(phi1, out)) is not None:
            _loops_of_position.fill(_row, phi1, R1, R2, e)
            return _row
        if _type(phi1) is _float and out is None:
            return _float64(_loops_of_position.point(phi1, R1, R2, e))
    return _run(_loops_of_position, (phi1, R1, R2, e), out)


@_point_of(position, spread=True)
def _point_of_position(phi1, R1, R2, e):
    return _value_of_position(_float64(phi1), _float64(R1), _float64(R2), _float64(e), True)


_loops_of_position = _Loops(("phi1", "R1", "R2", "e"), _point_of_position, _fill_of_position)


@_scalar
def _value_of_acceleration(phi1, R1, R2, e, _exact):
    if not ((R1 > 0) & _is_finite(R1) & (R2 > 0) & _is_finite(R2) & (e >= 0) & (e < 1) & (R2 < R1)):
        return _math.nan
    k = R1 / R2
    k_low = _elementary.quotient_rest(R1, R2, k)
    one_minus_e = 1 - e
    one_plus_e = 1 + e
    x = k * phi1
    t_angle = x / 2
    t_below = _elementary.tangent_below(t_angle, _exact)
    t = _elementary.tangent_above(t_angle, _exact)
    x_low = k_low * phi1 + _elementary.product_rest(k, phi1, x)
    t_low = _elementary.small_tangent(x_low / 2)
    adjacent = t_below - t * t_low
    opposite = t + t_low * t_below
    adjacent_squared = adjacent**2
    opposite_squared = opposite**2
    return (
        -4
        * e
        * one_minus_e
        * one_plus_e
        * k**2
        / (one_minus_e**2 * adjacent_squared + one_plus_e**2 * opposite_squared) ** 2
        * adjacent
        * opposite
        * (adjacent_squared + opposite_squared)
    )


@_loop
def _fill_of_acceleration(_out, phi1, R1, R2, e):
    _fill_blocks(_value_of_acceleration, _out, (phi1, R1, R2, e))


def acceleration(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute d ratio/d phi1, the angular acceleration of the output at unit carrier speed.

    Compiled. Its full documentation is that of
    `mechproof.kernels.elliptic_planetary.acceleration`.
    """
    if _type(R1) is _type(R2) is _type(e) is _float:
        if _type(phi1) is _ndarray and (_row := _take_row(phi1, out)) is not None:
            _loops_of_acceleration.fill(_row, phi1, R1, R2, e)
            return _row
        if _type(phi1) is _float and out is None:
            return _float64(_loops_of_acceleration.point(phi1, R1, R2, e))
    return _run(_loops_of_acceleration, (phi1, R1, R2, e), out)


@_point_of(acceleration, spread=True)
def _point_of_acceleration(phi1, R1, R2, e):
    return _value_of_acceleration(_float64(phi1), _float64(R1), _float64(R2), _float64(e), True)


_loops_of_acceleration = _Loops(
    ("phi1", "R1", "R2", "e"), _point_of_acceleration, _fill_of_acceleration
)


@_scalar
def _value_of_largest_ratio(R1, R2, e):
    if not ((R2 > 0) & _is_finite(R2) & (e >= 0) & (e < 1) & (R1 > 0) & _is_finite(R1) & (R2 < R1)):
        return _math.nan
    k = R1 / R2
    return 1 + (1 + e) / (1 - e) * k


@_loop
def _fill_of_largest_ratio(_out, R1, R2, e):
    _fill(_value_of_largest_ratio, _out, (R1, R2, e))


def largest_ratio(
    R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the largest transmission ratio, at phi1 = 0 and once in each period 2*pi*R2/R1.

    Compiled. Its full documentation is that of
    `mechproof.kernels.elliptic_planetary.largest_ratio`.
    """
    if _type(R2) is _type(e) is _float:
        if _type(R1) is _ndarray and (_row := _take_row(R1, out)) is not None:
            _loops_of_largest_ratio.fill(_row, R1, R2, e)
            return _row
        if _type(R1) is _float and out is None:
            return _float64(_loops_of_largest_ratio.point(R1, R2, e))
    return _run(_loops_of_largest_ratio, (R1, R2, e), out)


@_point_of(largest_ratio, spread=True)
def _point_of_largest_ratio(R1, R2, e):
    return _value_of_largest_ratio(_float64(R1), _float64(R2), _float64(e))


_loops_of_largest_ratio = _Loops(("R1", "R2", "e"), _point_of_largest_ratio, _fill_of_largest_ratio)


@_scalar
def _value_of_smallest_ratio(R1, R2, e):
    if not ((R2 > 0) & _is_finite(R2) & (e >= 0) & (e < 1) & (R1 > 0) & _is_finite(R1) & (R2 < R1)):
        return _math.nan
    k = R1 / R2
    return 1 + (1 - e) / (1 + e) * k


@_loop
def _fill_of_smallest_ratio(_out, R1, R2, e):
    _fill(_value_of_smallest_ratio, _out, (R1, R2, e))


def smallest_ratio(
    R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the smallest transmission ratio, met half a period after the largest.

    Compiled. Its full documentation is that of
    `mechproof.kernels.elliptic_planetary.smallest_ratio`.
    """
    if _type(R2) is _type(e) is _float:
        if _type(R1) is _ndarray and (_row := _take_row(R1, out)) is not None:
            _loops_of_smallest_ratio.fill(_row, R1, R2, e)
            return _row
        if _type(R1) is _float and out is None:
            return _float64(_loops_of_smallest_ratio.point(R1, R2, e))
    return _run(_loops_of_smallest_ratio, (R1, R2, e), out)


@_point_of(smallest_ratio, spread=True)
def _point_of_smallest_ratio(R1, R2, e):
    return _value_of_smallest_ratio(_float64(R1), _float64(R2), _float64(e))


_loops_of_smallest_ratio = _Loops(
    ("R1", "R2", "e"), _point_of_smallest_ratio, _fill_of_smallest_ratio
)


@_scalar
def _value_of_jerk(phi1, R1, R2, e, _exact):
    if not ((R1 > 0) & _is_finite(R1) & (R2 > 0) & _is_finite(R2) & (e >= 0) & (e < 1) & (R2 < R1)):
        return _math.nan
    one_minus_e = 1 - e
    one_plus_e = 1 + e
    k = R1 / R2
    k_low = _elementary.quotient_rest(R1, R2, k)
    one_minus_e_squared = one_minus_e**2
    one_plus_e_squared = one_plus_e**2
    x = k * phi1
    t_angle = x / 2
    t_below = _elementary.tangent_below(t_angle, _exact)
    t = _elementary.tangent_above(t_angle, _exact)
    x_low = k_low * phi1 + _elementary.product_rest(k, phi1, x)
    t_low = _elementary.small_tangent(x_low / 2)
    adjacent = t_below - t * t_low
    adjacent_squared = adjacent**2
    opposite = t + t_low * t_below
    opposite_squared = opposite**2
    base = one_minus_e_squared * adjacent_squared + one_plus_e_squared * opposite_squared
    return (
        2
        * e
        * one_minus_e
        * one_plus_e
        * (k * k**2)
        / (base * base**2)
        * (adjacent_squared + opposite_squared)
        * (
            one_plus_e_squared * (opposite**2) ** 2
            + 12 * e * adjacent_squared * opposite_squared
            - one_minus_e_squared * (adjacent**2) ** 2
        )
    )


@_loop
def _fill_of_jerk(_out, phi1, R1, R2, e):
    _fill_blocks(_value_of_jerk, _out, (phi1, R1, R2, e))


def jerk(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute d acceleration/d phi1, the jerk of the output at unit carrier speed.

    Compiled. Its full documentation is that of
    `mechproof.kernels.elliptic_planetary.jerk`.
    """
    if _type(R1) is _type(R2) is _type(e) is _float:
        if _type(phi1) is _ndarray and (_row := _take_row(phi1, out)) is not None:
            _loops_of_jerk.fill(_row, phi1, R1, R2, e)
            return _row
        if _type(phi1) is _float and out is None:
            return _float64(_loops_of_jerk.point(phi1, R1, R2, e))
    return _run(_loops_of_jerk, (phi1, R1, R2, e), out)


@_point_of(jerk, spread=True)
def _point_of_jerk(phi1, R1, R2, e):
    return _value_of_jerk(_float64(phi1), _float64(R1), _float64(R2), _float64(e), True)


_loops_of_jerk = _Loops(("phi1", "R1", "R2", "e"), _point_of_jerk, _fill_of_jerk)


@_scalar
def _value_of_largest_acceleration(R1, R2, e):
    if not ((R2 > 0) & _is_finite(R2) & (e >= 0) & (e < 1) & (R1 > 0) & _is_finite(R1) & (R2 < R1)):
        return _math.nan
    one_plus_e = 1 + e
    e_squared = e**2
    square = 1 + e_squared
    root_acceleration = _np.sqrt(32 * e_squared + square**2)
    peak_acceleration = 1 + one_plus_e**2 / (6 * e + root_acceleration)
    k = R1 / R2
    return (
        2
        * e
        * one_plus_e
        * _np.sqrt(peak_acceleration * (8 * e + root_acceleration + square))
        * (root_acceleration + square)
        / ((1 - e) ** 2 * (root_acceleration + square + 2 * e * peak_acceleration) ** 2)
        * k**2
    )


@_loop
def _fill_of_largest_acceleration(_out, R1, R2, e):
    _fill(_value_of_largest_acceleration, _out, (R1, R2, e))


def largest_acceleration(
    R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the largest acceleration; the smallest is its negative.

    Compiled. Its full documentation is that of
    `mechproof.kernels.elliptic_planetary.largest_acceleration`.
    """
    if _type(R2) is _type(e) is _float:
        if _type(R1) is _ndarray and (_row := _take_row(R1, out)) is not None:
            _loops_of_largest_acceleration.fill(_row, R1, R2, e)
            return _row
        if _type(R1) is _float and out is None:
            return _float64(_loops_of_largest_acceleration.point(R1, R2, e))
    return _run(_loops_of_largest_acceleration, (R1, R2, e), out)


@_point_of(largest_acceleration, spread=True)
def _point_of_largest_acceleration(R1, R2, e):
    return _value_of_largest_acceleration(_float64(R1), _float64(R2), _float64(e))


_loops_of_largest_acceleration = _Loops(
    ("R1", "R2", "e"), _point_of_largest_acceleration, _fill_of_largest_acceleration
)


@_scalar
def _value_of_angle_of_smallest_acceleration(R1, R2, e):
    if not ((R2 > 0) & _is_finite(R2) & (e >= 0) & (e < 1) & (R1 > 0) & _is_finite(R1) & (R2 < R1)):
        return _math.nan
    e_squared = e**2
    square = 1 + e_squared
    root_acceleration = _np.sqrt(32 * e_squared + square**2)
    peak_acceleration = 1 + (1 + e) ** 2 / (6 * e + root_acceleration)
    k = R1 / R2
    return (
        2
        * _elementary.arctan2(
            _np.sqrt(peak_acceleration) * (1 - e), _np.sqrt(8 * e + root_acceleration + square)
        )
        / k
    )


@_loop
def _fill_of_angle_of_smallest_acceleration(_out, R1, R2, e):
    _fill(_value_of_angle_of_smallest_acceleration, _out, (R1, R2, e))


def angle_of_smallest_acceleration(
    R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the first phi1 >= 0 where the acceleration is smallest; at -phi1 it is largest.

    Compiled. Its full documentation is that of
    `mechproof.kernels.elliptic_planetary.angle_of_smallest_acceleration`.
    """
    if _type(R2) is _type(e) is _float:
        if _type(R1) is _ndarray and (_row := _take_row(R1, out)) is not None:
            _loops_of_angle_of_smallest_acceleration.fill(_row, R1, R2, e)
            return _row
        if _type(R1) is _float and out is None:
            return _float64(_loops_of_angle_of_smallest_acceleration.point(R1, R2, e))
    return _run(_loops_of_angle_of_smallest_acceleration, (R1, R2, e), out)


@_point_of(angle_of_smallest_acceleration, spread=True)
def _point_of_angle_of_smallest_acceleration(R1, R2, e):
    return _value_of_angle_of_smallest_acceleration(_float64(R1), _float64(R2), _float64(e))


_loops_of_angle_of_smallest_acceleration = _Loops(
    ("R1", "R2", "e"),
    _point_of_angle_of_smallest_acceleration,
    _fill_of_angle_of_smallest_acceleration,
)


@_scalar
def _value_of_largest_jerk(R1, R2, e):
    if not ((R2 > 0) & _is_finite(R2) & (e >= 0) & (e < 1) & (R1 > 0) & _is_finite(R1) & (R2 < R1)):
        return _math.nan
    one_minus_e = 1 - e
    one_plus_e = 1 + e
    term = 1 / (one_plus_e * one_plus_e**2)
    e_squared = e**2
    square = 1 + e_squared
    square_squared = square**2
    root_jerk = _np.sqrt(24 * e_squared + 3 * square_squared)
    k = R1 / R2
    k_cubed = k * k**2
    return _choose(
        10 * e <= square,
        2 * e * one_minus_e * term * k_cubed,
        term
        * (root_jerk + 3 * square) ** 2
        * (32 * e_squared + square_squared)
        / (36 * (one_minus_e * one_minus_e**2) * (2 * root_jerk + 3 * square))
        * k_cubed,
    )


@_loop
def _fill_of_largest_jerk(_out, R1, R2, e):
    _fill(_value_of_largest_jerk, _out, (R1, R2, e))


def largest_jerk(
    R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the largest jerk, which it has at phi1 = angle_of_largest_jerk and -phi1.

    Compiled. Its full documentation is that of
    `mechproof.kernels.elliptic_planetary.largest_jerk`.
    """
    if _type(R2) is _type(e) is _float:
        if _type(R1) is _ndarray and (_row := _take_row(R1, out)) is not None:
            _loops_of_largest_jerk.fill(_row, R1, R2, e)
            return _row
        if _type(R1) is _float and out is None:
            return _float64(_loops_of_largest_jerk.point(R1, R2, e))
    return _run(_loops_of_largest_jerk, (R1, R2, e), out)


@_point_of(largest_jerk, spread=True)
def _point_of_largest_jerk(R1, R2, e):
    return _value_of_largest_jerk(_float64(R1), _float64(R2), _float64(e))


_loops_of_largest_jerk = _Loops(("R1", "R2", "e"), _point_of_largest_jerk, _fill_of_largest_jerk)


@_scalar
def _value_of_smallest_jerk(R1, R2, e):
    if not ((R2 > 0) & _is_finite(R2) & (e >= 0) & (e < 1) & (R1 > 0) & _is_finite(R1) & (R2 < R1)):
        return _math.nan
    k = R1 / R2
    one_minus_e = 1 - e
    return -2 * e * (1 + e) / (one_minus_e * one_minus_e**2) * (k * k**2)


@_loop
def _fill_of_smallest_jerk(_out, R1, R2, e):
    _fill(_value_of_smallest_jerk, _out, (R1, R2, e))


def smallest_jerk(
    R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the smallest jerk, met where the ratio is largest.

    Compiled. Its full documentation is that of
    `mechproof.kernels.elliptic_planetary.smallest_jerk`.
    """
    if _type(R2) is _type(e) is _float:
        if _type(R1) is _ndarray and (_row := _take_row(R1, out)) is not None:
            _loops_of_smallest_jerk.fill(_row, R1, R2, e)
            return _row
        if _type(R1) is _float and out is None:
            return _float64(_loops_of_smallest_jerk.point(R1, R2, e))
    return _run(_loops_of_smallest_jerk, (R1, R2, e), out)


@_point_of(smallest_jerk, spread=True)
def _point_of_smallest_jerk(R1, R2, e):
    return _value_of_smallest_jerk(_float64(R1), _float64(R2), _float64(e))


_loops_of_smallest_jerk = _Loops(("R1", "R2", "e"), _point_of_smallest_jerk, _fill_of_smallest_jerk)


@_scalar
def _value_of_angle_of_largest_jerk(R1, R2, e):
    if not ((R2 > 0) & _is_finite(R2) & (e >= 0) & (e < 1) & (R1 > 0) & _is_finite(R1) & (R2 < R1)):
        return _math.nan
    e_squared = e**2
    square = 1 + e_squared
    root_jerk = _np.sqrt(24 * e_squared + 3 * square**2)
    k = R1 / R2
    return (
        _choose(
            10 * e <= square,
            _np.pi,
            2
            * _elementary.arctan2(
                _np.sqrt((10 * e + square) * (root_jerk + 2 * square - 2 * e)) * (1 - e),
                _np.sqrt((10 * e - square) * (2 * e + root_jerk + 2 * square)) * (1 + e),
            ),
        )
        / k
    )


@_loop
def _fill_of_angle_of_largest_jerk(_out, R1, R2, e):
    _fill(_value_of_angle_of_largest_jerk, _out, (R1, R2, e))


def angle_of_largest_jerk(
    R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the first phi1 >= 0 where the jerk is largest.

    Compiled. Its full documentation is that of
    `mechproof.kernels.elliptic_planetary.angle_of_largest_jerk`.
    """
    if _type(R2) is _type(e) is _float:
        if _type(R1) is _ndarray and (_row := _take_row(R1, out)) is not None:
            _loops_of_angle_of_largest_jerk.fill(_row, R1, R2, e)
            return _row
        if _type(R1) is _float and out is None:
            return _float64(_loops_of_angle_of_largest_jerk.point(R1, R2, e))
    return _run(_loops_of_angle_of_largest_jerk, (R1, R2, e), out)


@_point_of(angle_of_largest_jerk, spread=True)
def _point_of_angle_of_largest_jerk(R1, R2, e):
    return _value_of_angle_of_largest_jerk(_float64(R1), _float64(R2), _float64(e))


_loops_of_angle_of_largest_jerk = _Loops(
    ("R1", "R2", "e"), _point_of_angle_of_largest_jerk, _fill_of_angle_of_largest_jerk
)


@_scalar
def _value_of_eccentricity_of_largest_ratio(largest, R1, R2):
    if not (
        (R1 > 0)
        & _is_finite(R1)
        & (R2 > 0)
        & _is_finite(R2)
        & (R2 < R1)
        & (largest > 1)
        & _is_finite(largest)
        & (R1 <= R2 * (largest - 1))
    ):
        return _math.nan
    k = R1 / R2
    return (largest - 1 - k) / (k + largest - 1)


@_loop
def _fill_of_eccentricity_of_largest_ratio(_out, largest, R1, R2):
    _fill(_value_of_eccentricity_of_largest_ratio, _out, (largest, R1, R2))


def eccentricity_of_largest_ratio(
    largest: ArrayLike, R1: ArrayLike, R2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the eccentricity at which the largest ratio has a wanted value.

    Compiled. Its full documentation is that of
    `mechproof.kernels.elliptic_planetary.eccentricity_of_largest_ratio`.
    """
    if _type(R1) is _type(R2) is _float:
        if _type(largest) is _ndarray and (_row := _take_row(largest, out)) is not None:
            _loops_of_eccentricity_of_largest_ratio.fill(_row, largest, R1, R2)
            return _row
        if _type(largest) is _float and out is None:
            return _float64(_loops_of_eccentricity_of_largest_ratio.point(largest, R1, R2))
    return _run(_loops_of_eccentricity_of_largest_ratio, (largest, R1, R2), out)


@_point_of(eccentricity_of_largest_ratio, spread=True)
def _point_of_eccentricity_of_largest_ratio(largest, R1, R2):
    return _value_of_eccentricity_of_largest_ratio(_float64(largest), _float64(R1), _float64(R2))


_loops_of_eccentricity_of_largest_ratio = _Loops(
    ("largest", "R1", "R2"),
    _point_of_eccentricity_of_largest_ratio,
    _fill_of_eccentricity_of_largest_ratio,
)


@_scalar
def _value_of_eccentricity_of_smallest_ratio(smallest, R1, R2):
    if not (
        (R1 > 0)
        & _is_finite(R1)
        & (R2 > 0)
        & _is_finite(R2)
        & (R2 < R1)
        & (smallest > 1)
        & _is_finite(smallest)
        & (R2 * (smallest - 1) <= R1)
    ):
        return _math.nan
    k = R1 / R2
    return (1 + k - smallest) / (k + smallest - 1)


@_loop
def _fill_of_eccentricity_of_smallest_ratio(_out, smallest, R1, R2):
    _fill(_value_of_eccentricity_of_smallest_ratio, _out, (smallest, R1, R2))


def eccentricity_of_smallest_ratio(
    smallest: ArrayLike, R1: ArrayLike, R2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the eccentricity at which the smallest ratio has a wanted value.

    Compiled. Its full documentation is that of
    `mechproof.kernels.elliptic_planetary.eccentricity_of_smallest_ratio`.
    """
    if _type(R1) is _type(R2) is _float:
        if _type(smallest) is _ndarray and (_row := _take_row(smallest, out)) is not None:
            _loops_of_eccentricity_of_smallest_ratio.fill(_row, smallest, R1, R2)
            return _row
        if _type(smallest) is _float and out is None:
            return _float64(_loops_of_eccentricity_of_smallest_ratio.point(smallest, R1, R2))
    return _run(_loops_of_eccentricity_of_smallest_ratio, (smallest, R1, R2), out)


@_point_of(eccentricity_of_smallest_ratio, spread=True)
def _point_of_eccentricity_of_smallest_ratio(smallest, R1, R2):
    return _value_of_eccentricity_of_smallest_ratio(_float64(smallest), _float64(R1), _float64(R2))


_loops_of_eccentricity_of_smallest_ratio = _Loops(
    ("smallest", "R1", "R2"),
    _point_of_eccentricity_of_smallest_ratio,
    _fill_of_eccentricity_of_smallest_ratio,
)


@_scalar
def _value_of_eccentricity_of_quotient(quotient, R1, R2):
    if not (
        (R1 > 0)
        & _is_finite(R1)
        & (R2 > 0)
        & _is_finite(R2)
        & (R2 < R1)
        & (quotient >= 1)
        & _is_finite(quotient)
    ):
        return _math.nan
    k = R1 / R2
    k_squared = k**2
    quotient_minus_one = quotient - 1
    term = _np.sqrt(quotient_minus_one**2 + 4 * k_squared * quotient)
    return (
        quotient_minus_one
        * (1 + (4 * k_squared + quotient - 1) / (2 * k + term))
        / (2 * k + quotient + term - 1)
    )


@_loop
def _fill_of_eccentricity_of_quotient(_out, quotient, R1, R2):
    _fill(_value_of_eccentricity_of_quotient, _out, (quotient, R1, R2))


def eccentricity_of_quotient(
    quotient: ArrayLike, R1: ArrayLike, R2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the eccentricity at which the largest ratio is a wanted multiple of the smallest.

    Compiled. Its full documentation is that of
    `mechproof.kernels.elliptic_planetary.eccentricity_of_quotient`.
    """
    if _type(R1) is _type(R2) is _float:
        if _type(quotient) is _ndarray and (_row := _take_row(quotient, out)) is not None:
            _loops_of_eccentricity_of_quotient.fill(_row, quotient, R1, R2)
            return _row
        if _type(quotient) is _float and out is None:
            return _float64(_loops_of_eccentricity_of_quotient.point(quotient, R1, R2))
    return _run(_loops_of_eccentricity_of_quotient, (quotient, R1, R2), out)


@_point_of(eccentricity_of_quotient, spread=True)
def _point_of_eccentricity_of_quotient(quotient, R1, R2):
    return _value_of_eccentricity_of_quotient(_float64(quotient), _float64(R1), _float64(R2))


_loops_of_eccentricity_of_quotient = _Loops(
    ("quotient", "R1", "R2"), _point_of_eccentricity_of_quotient, _fill_of_eccentricity_of_quotient
)


@_scalar
def _value_of_eccentricity_of_non_uniformity(non_uniformity, R1, R2):
    if not (
        (R1 > 0)
        & _is_finite(R1)
        & (R2 > 0)
        & _is_finite(R2)
        & (R2 < R1)
        & (non_uniformity >= 0)
        & _is_finite(non_uniformity)
    ):
        return _math.nan
    k = R1 / R2
    one_plus_k = 1 + k
    return (
        one_plus_k
        / (k * (2 + _np.sqrt(4 + one_plus_k**2 / k**2 * non_uniformity**2)))
        * non_uniformity
    )


@_loop
def _fill_of_eccentricity_of_non_uniformity(_out, non_uniformity, R1, R2):
    _fill(_value_of_eccentricity_of_non_uniformity, _out, (non_uniformity, R1, R2))


def eccentricity_of_non_uniformity(
    non_uniformity: ArrayLike, R1: ArrayLike, R2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the eccentricity for a wanted (largest - smallest ratio)/(mean ratio).

    Compiled. Its full documentation is that of
    `mechproof.kernels.elliptic_planetary.eccentricity_of_non_uniformity`.
    """
    if _type(R1) is _type(R2) is _float:
        if (
            _type(non_uniformity) is _ndarray
            and (_row := _take_row(non_uniformity, out)) is not None
        ):
            _loops_of_eccentricity_of_non_uniformity.fill(_row, non_uniformity, R1, R2)
            return _row
        if _type(non_uniformity) is _float and out is None:
            return _float64(_loops_of_eccentricity_of_non_uniformity.point(non_uniformity, R1, R2))
    return _run(_loops_of_eccentricity_of_non_uniformity, (non_uniformity, R1, R2), out)


@_point_of(eccentricity_of_non_uniformity, spread=True)
def _point_of_eccentricity_of_non_uniformity(non_uniformity, R1, R2):
    return _value_of_eccentricity_of_non_uniformity(
        _float64(non_uniformity), _float64(R1), _float64(R2)
    )


_loops_of_eccentricity_of_non_uniformity = _Loops(
    ("non_uniformity", "R1", "R2"),
    _point_of_eccentricity_of_non_uniformity,
    _fill_of_eccentricity_of_non_uniformity,
)


@_scalar
def _value_of_eccentricity_of_extremes(largest, smallest):
    if not (
        (smallest > 1)
        & _is_finite(smallest)
        & (largest > 1)
        & _is_finite(largest)
        & (smallest <= largest)
        & ((largest - 1) * (smallest - 1) > 1)
    ):
        return _math.nan
    return (largest - smallest) / (_np.sqrt(largest - 1) + _np.sqrt(smallest - 1)) ** 2


@_loop
def _fill_of_eccentricity_of_extremes(_out, largest, smallest):
    _fill(_value_of_eccentricity_of_extremes, _out, (largest, smallest))


def eccentricity_of_extremes(
    largest: ArrayLike, smallest: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the eccentricity at which both extremes of the ratio have wanted values.

    Compiled. Its full documentation is that of
    `mechproof.kernels.elliptic_planetary.eccentricity_of_extremes`.
    """
    if _type(smallest) is _float:
        if _type(largest) is _ndarray and (_row := _take_row(largest, out)) is not None:
            _loops_of_eccentricity_of_extremes.fill(_row, largest, smallest)
            return _row
        if _type(largest) is _float and out is None:
            return _float64(_loops_of_eccentricity_of_extremes.point(largest, smallest))
    return _run(_loops_of_eccentricity_of_extremes, (largest, smallest), out)


@_point_of(eccentricity_of_extremes, spread=True)
def _point_of_eccentricity_of_extremes(largest, smallest):
    return _value_of_eccentricity_of_extremes(_float64(largest), _float64(smallest))


_loops_of_eccentricity_of_extremes = _Loops(
    ("largest", "smallest"), _point_of_eccentricity_of_extremes, _fill_of_eccentricity_of_extremes
)


@_scalar
def _value_of_radii_of_extremes(largest, smallest):
    if not (
        (smallest > 1)
        & _is_finite(smallest)
        & (largest > 1)
        & _is_finite(largest)
        & (smallest <= largest)
        & ((largest - 1) * (smallest - 1) > 1)
    ):
        return _math.nan
    return _np.sqrt((smallest - 1) * (largest - 1))


@_loop
def _fill_of_radii_of_extremes(_out, largest, smallest):
    _fill(_value_of_radii_of_extremes, _out, (largest, smallest))


def radii_of_extremes(
    largest: ArrayLike, smallest: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute R1/R2 at which both extremes of the ratio have wanted values.

    Compiled. Its full documentation is that of
    `mechproof.kernels.elliptic_planetary.radii_of_extremes`.
    """
    if _type(smallest) is _float:
        if _type(largest) is _ndarray and (_row := _take_row(largest, out)) is not None:
            _loops_of_radii_of_extremes.fill(_row, largest, smallest)
            return _row
        if _type(largest) is _float and out is None:
            return _float64(_loops_of_radii_of_extremes.point(largest, smallest))
    return _run(_loops_of_radii_of_extremes, (largest, smallest), out)


@_point_of(radii_of_extremes, spread=True)
def _point_of_radii_of_extremes(largest, smallest):
    return _value_of_radii_of_extremes(_float64(largest), _float64(smallest))


_loops_of_radii_of_extremes = _Loops(
    ("largest", "smallest"), _point_of_radii_of_extremes, _fill_of_radii_of_extremes
)


@_scalar
def _value_of_motion(phi1, R1, R2, e, _exact):
    return (
        _value_of_position(phi1, R1, R2, e, _exact),
        _value_of_ratio(phi1, R1, R2, e, _exact),
        _value_of_acceleration(phi1, R1, R2, e, _exact),
    )


@_loop
def _fill_of_motion(_out_of_position, _out_of_ratio, _out_of_acceleration, phi1, R1, R2, e):
    _fill_blocks(
        _value_of_motion, (_out_of_position, _out_of_ratio, _out_of_acceleration), (phi1, R1, R2, e)
    )


def motion(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute position, ratio and acceleration in one pass.

    They lie along the first axis of the result, each with the bits of its own kernel. Compiled.
    """
    return _run(_loops_of_motion, (phi1, R1, R2, e), out)


@_point_of(motion)
def _point_of_motion(phi1, R1, R2, e):
    return _value_of_motion(_float64(phi1), _float64(R1), _float64(R2), _float64(e), True)


_loops_of_motion = _Loops(("phi1", "R1", "R2", "e"), _point_of_motion, _fill_of_motion, results=3)
