"""Compiled kernels of the system `elliptic_planetary`: one loop for each, by numba.

Names, arguments, domains, NaN and errors are those of `mechproof.kernels.elliptic_planetary`,
and so are the formulas. Numbers and NumPy arrays are taken. With numbers,
kernels can be called inside functions that numba compiles; arguments with components are then
indexed, and so are results.

Tests hold them to the same accuracy bounds. What help says is proved of rounding errors
is proved of these kernels where it says `compiled`, and of the NumPy kernels elsewhere.

Elementary functions: `elementary` 7c4f48979007.

Generated from mechproof.derivations.elliptic_planetary with SymPy 1.14.0.
Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""

from __future__ import annotations

import math as _math
from builtins import float as _float, type as _type
from typing import Any

from numpy import float64 as _float64, ndarray as _ndarray
from numpy.typing import ArrayLike, NDArray

from mechproof.compiled_support import (
    Loops as _Loops,
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
    "largest_ratio",
    "motion",
    "position",
    "ratio",
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

    Compiled. The help of `mechproof.kernels.elliptic_planetary.ratio` has all words.
    """
    if _type(R1) is _type(R2) is _type(e) is _float:
        if _type(phi1) is _ndarray and (_row := _take_row(phi1, out)) is not None:
            _loops_of_ratio.fill(_row, phi1, R1, R2, e)
            return _row
        if _type(phi1) is _float and out is None:
            return _float64(_loops_of_ratio.point(phi1, R1, R2, e))
    return _run(_loops_of_ratio, (phi1, R1, R2, e), out)


@_point_of(ratio)
def _point_of_ratio(phi1, R1, R2, e):
    return _value_of_ratio(_float64(phi1), _float64(R1), _float64(R2), _float64(e), True)


_loops_of_ratio = _Loops(("phi1", "R1", "R2", "e"), _point_of_ratio, _fill_of_ratio)


@_scalar
def _form_1_of_position(phi1, R1, R2, e, _exact):
    k = R1 / R2
    one_minus_e = 1 - e
    one_plus_e = 1 + e
    x = k * phi1
    return (1 + k) * phi1 + 2 * _elementary.small_arctan(
        2 * e * _elementary.tangent_quotient(x / 2, one_minus_e, one_plus_e, _exact)
    )


@_scalar
def _value_of_position(phi1, R1, R2, e, _exact):
    if not ((R1 > 0) & _is_finite(R1) & (R2 > 0) & _is_finite(R2) & (e >= 0) & (e < 1) & (R2 < R1)):
        return _math.nan
    if e <= 0.5:
        return _form_1_of_position(phi1, R1, R2, e, _exact)
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
    return (1 + k) * phi1 + 2 * _elementary.arctan_quotient(
        2 * e * adjacent * opposite, one_minus_e * adjacent**2 + one_plus_e * opposite**2
    )


@_loop
def _fill_of_position(_out, phi1, R1, R2, e):
    _fill_blocks(_value_of_position, _out, (phi1, R1, R2, e))


def position(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the position function phi3(phi1) of the output wheel, phi3(0) = 0.

    Compiled. The help of `mechproof.kernels.elliptic_planetary.position` has all words.
    """
    if _type(R1) is _type(R2) is _type(e) is _float:
        if _type(phi1) is _ndarray and (_row := _take_row(phi1, out)) is not None:
            _loops_of_position.fill(_row, phi1, R1, R2, e)
            return _row
        if _type(phi1) is _float and out is None:
            return _float64(_loops_of_position.point(phi1, R1, R2, e))
    return _run(_loops_of_position, (phi1, R1, R2, e), out)


@_point_of(position)
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

    Compiled. The help of `mechproof.kernels.elliptic_planetary.acceleration` has all words.
    """
    if _type(R1) is _type(R2) is _type(e) is _float:
        if _type(phi1) is _ndarray and (_row := _take_row(phi1, out)) is not None:
            _loops_of_acceleration.fill(_row, phi1, R1, R2, e)
            return _row
        if _type(phi1) is _float and out is None:
            return _float64(_loops_of_acceleration.point(phi1, R1, R2, e))
    return _run(_loops_of_acceleration, (phi1, R1, R2, e), out)


@_point_of(acceleration)
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
    """Compute the largest transmission ratio, met at phi1 = 0 and every period 2*pi*R2/R1 on.

    Compiled. The help of `mechproof.kernels.elliptic_planetary.largest_ratio` has all words.
    """
    if _type(R2) is _type(e) is _float:
        if _type(R1) is _ndarray and (_row := _take_row(R1, out)) is not None:
            _loops_of_largest_ratio.fill(_row, R1, R2, e)
            return _row
        if _type(R1) is _float and out is None:
            return _float64(_loops_of_largest_ratio.point(R1, R2, e))
    return _run(_loops_of_largest_ratio, (R1, R2, e), out)


@_point_of(largest_ratio)
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

    Compiled. The help of `mechproof.kernels.elliptic_planetary.smallest_ratio` has all words.
    """
    if _type(R2) is _type(e) is _float:
        if _type(R1) is _ndarray and (_row := _take_row(R1, out)) is not None:
            _loops_of_smallest_ratio.fill(_row, R1, R2, e)
            return _row
        if _type(R1) is _float and out is None:
            return _float64(_loops_of_smallest_ratio.point(R1, R2, e))
    return _run(_loops_of_smallest_ratio, (R1, R2, e), out)


@_point_of(smallest_ratio)
def _point_of_smallest_ratio(R1, R2, e):
    return _value_of_smallest_ratio(_float64(R1), _float64(R2), _float64(e))


_loops_of_smallest_ratio = _Loops(
    ("R1", "R2", "e"), _point_of_smallest_ratio, _fill_of_smallest_ratio
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
