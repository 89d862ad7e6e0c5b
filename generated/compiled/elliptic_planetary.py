"""Compiled kernels of the system `elliptic_planetary`: one loop for each, by numba.

Names, arguments, domains, NaN and errors are those of `mechproof.kernels.elliptic_planetary`,
and so are the formulas. Numbers and NumPy arrays are taken. With numbers,
kernels can be called inside functions that numba compiles; arguments with components are then
indexed, and so are results.

Tests hold them to the same accuracy bounds. What help says is proved of rounding errors
is proved of these kernels where it says `compiled`, and of the NumPy kernels elsewhere.

Elementary functions: `elementary` 8db31d8544f3.

Generated from mechproof.derivations.elliptic_planetary with SymPy 1.14.0.
Regenerate with `mechproof regenerate`; edits are overwritten.
"""

from __future__ import annotations

import math
from typing import Any

from numpy import float64, ndarray
from numpy.typing import ArrayLike, NDArray

from mechproof.compiled_support import (
    BLOCK,
    Loops,
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
    "acceleration",
    "largest_ratio",
    "motion",
    "position",
    "ratio",
    "smallest_ratio",
]


def __dir__() -> list[str]:
    return __all__


@scalar
def _prepare_ratio(R1, R2, e, exact):
    k = R1 / R2
    one_minus_e = 1 - e
    one_plus_e = 1 + e
    k_low = elementary.quotient_rest(R1, R2, k)

    return (k, one_minus_e, one_plus_e, k_low)


@scalar
def _ratio(phi1, k, one_minus_e, one_plus_e, k_low, exact):
    x = k * phi1
    t_angle = x / 2
    t_below = elementary.tangent_below(t_angle, exact)
    t = elementary.tangent_above(t_angle, exact)
    x_low = k_low * phi1 + elementary.product_rest(k, phi1, x)
    t_low = elementary.small_tangent(x_low / 2)
    adjacent = t_below - t * t_low
    adjacent_squared = adjacent**2
    opposite = t + t_low * t_below
    opposite_squared = opposite**2

    return 1 + k * one_minus_e * one_plus_e / (
        one_minus_e**2 * adjacent_squared + one_plus_e**2 * opposite_squared
    ) * (adjacent_squared + opposite_squared)


@scalar
def _ratio_at(phi1, R1, R2, e, exact):
    if not ((R1 > 0) & is_finite(R1) & (R2 > 0) & is_finite(R2) & (e >= 0) & (e < 1) & (R2 < R1)):
        return math.nan
    prepared = _prepare_ratio(R1, R2, e, exact)
    return _ratio(phi1, *prepared, exact)


@scalar
def _ratio_point(phi1, R1, R2, e):
    return _ratio_at(phi1, R1, R2, e, True)


@loop
def _row_ratio(out, phi1_values, R1, R2, e, exact):
    widen()
    for i in range(out.size):
        phi1 = float64(phi1_values[i])

        value = _ratio_at(phi1, R1, R2, e, exact)
        out[i] = value


@loop
def _fill_ratio(
    out,
    phi1_values,
    R1,
    R2,
    e,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi1_block = phi1_values[start:stop]
        _row_ratio(out_block, phi1_block, R1, R2, e, None)
        if has_nan(out_block):
            _row_ratio(out_block, phi1_block, R1, R2, e, True)


@loop
def _row_each_ratio(out, phi1_values, R1_values, R2_values, e_values, exact):
    widen()
    for i in range(out.size):
        phi1 = float64(phi1_values[i])

        R1 = float64(R1_values[i])

        R2 = float64(R2_values[i])

        e = float64(e_values[i])

        value = _ratio_at(phi1, R1, R2, e, exact)
        out[i] = value


@loop
def _fill_each_ratio(
    out,
    phi1_values,
    R1_values,
    R2_values,
    e_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi1_block = phi1_values[start:stop]
        R1_block = R1_values[start:stop]
        R2_block = R2_values[start:stop]
        e_block = e_values[start:stop]
        _row_each_ratio(out_block, phi1_block, R1_block, R2_block, e_block, None)
        if has_nan(out_block):
            _row_each_ratio(out_block, phi1_block, R1_block, R2_block, e_block, True)


def ratio(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the transmission ratio d phi3/d phi1 of the output wheel to the carrier.

    Compiled. The help of `mechproof.kernels.elliptic_planetary.ratio` has all words.
    """
    if type(R1) is type(R2) is type(e) is float:
        if type(phi1) is ndarray:
            row = take_row(phi1, out)
            if row is not None:
                _RATIO.fill(row, phi1, R1, R2, e)
                return row
        elif type(phi1) is float and out is None:
            return float64(_RATIO.point(phi1, R1, R2, e))
    return run(
        _RATIO,
        (
            phi1,
            R1,
            R2,
            e,
        ),
        out,
    )


_RATIO = Loops(
    names=(
        "phi1",
        "R1",
        "R2",
        "e",
    ),
    widths=(
        0,
        0,
        0,
        0,
    ),
    shape=(),
    at=_ratio_point,
    uniform=_fill_ratio,
    each=_fill_each_ratio,
)


@overload(ratio)
def _offer_ratio(
    phi1,
    R1,
    R2,
    e,
):
    return lambda phi1, R1, R2, e: _ratio_point(
        float64(phi1),
        float64(R1),
        float64(R2),
        float64(e),
    )


@scalar
def _prepare_position_1(R1, R2, e, exact):
    k = R1 / R2
    one_minus_e = 1 - e
    one_plus_e = 1 + e

    return (e, k, one_minus_e, one_plus_e)


@scalar
def _position_1(phi1, e, k, one_minus_e, one_plus_e, exact):
    x = k * phi1

    return (1 + k) * phi1 + 2 * elementary.small_arctan(
        2 * e * elementary.tangent_quotient(x / 2, one_minus_e, one_plus_e, exact)
    )


@scalar
def _prepare_position(R1, R2, e, exact):
    k = R1 / R2
    k_low = elementary.quotient_rest(R1, R2, k)
    one_minus_e = 1 - e
    one_plus_e = 1 + e

    return (e, k, k_low, one_minus_e, one_plus_e)


@scalar
def _position(phi1, e, k, k_low, one_minus_e, one_plus_e, exact):
    x = k * phi1
    t_angle = x / 2
    t_below = elementary.tangent_below(t_angle, exact)
    t = elementary.tangent_above(t_angle, exact)
    x_low = k_low * phi1 + elementary.product_rest(k, phi1, x)
    t_low = elementary.small_tangent(x_low / 2)
    adjacent = t_below - t * t_low
    opposite = t + t_low * t_below

    return (1 + k) * phi1 + 2 * elementary.arctan_quotient(
        2 * e * adjacent * opposite, one_minus_e * adjacent**2 + one_plus_e * opposite**2
    )


@scalar
def _position_at(phi1, R1, R2, e, exact):
    if not ((R1 > 0) & is_finite(R1) & (R2 > 0) & is_finite(R2) & (e >= 0) & (e < 1) & (R2 < R1)):
        return math.nan
    if e <= 0.5:
        prepared = _prepare_position_1(R1, R2, e, exact)
        return _position_1(phi1, *prepared, exact)

    prepared = _prepare_position(R1, R2, e, exact)
    return _position(phi1, *prepared, exact)


@scalar
def _position_point(phi1, R1, R2, e):
    return _position_at(phi1, R1, R2, e, True)


@loop
def _row_position(out, phi1_values, R1, R2, e, exact):
    widen()
    for i in range(out.size):
        phi1 = float64(phi1_values[i])

        value = _position_at(phi1, R1, R2, e, exact)
        out[i] = value


@loop
def _fill_position(
    out,
    phi1_values,
    R1,
    R2,
    e,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi1_block = phi1_values[start:stop]
        _row_position(out_block, phi1_block, R1, R2, e, None)
        if has_nan(out_block):
            _row_position(out_block, phi1_block, R1, R2, e, True)


@loop
def _row_each_position(out, phi1_values, R1_values, R2_values, e_values, exact):
    widen()
    for i in range(out.size):
        phi1 = float64(phi1_values[i])

        R1 = float64(R1_values[i])

        R2 = float64(R2_values[i])

        e = float64(e_values[i])

        value = _position_at(phi1, R1, R2, e, exact)
        out[i] = value


@loop
def _fill_each_position(
    out,
    phi1_values,
    R1_values,
    R2_values,
    e_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi1_block = phi1_values[start:stop]
        R1_block = R1_values[start:stop]
        R2_block = R2_values[start:stop]
        e_block = e_values[start:stop]
        _row_each_position(out_block, phi1_block, R1_block, R2_block, e_block, None)
        if has_nan(out_block):
            _row_each_position(out_block, phi1_block, R1_block, R2_block, e_block, True)


def position(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the position function phi3(phi1) of the output wheel, phi3(0) = 0.

    Compiled. The help of `mechproof.kernels.elliptic_planetary.position` has all words.
    """
    if type(R1) is type(R2) is type(e) is float:
        if type(phi1) is ndarray:
            row = take_row(phi1, out)
            if row is not None:
                _POSITION.fill(row, phi1, R1, R2, e)
                return row
        elif type(phi1) is float and out is None:
            return float64(_POSITION.point(phi1, R1, R2, e))
    return run(
        _POSITION,
        (
            phi1,
            R1,
            R2,
            e,
        ),
        out,
    )


_POSITION = Loops(
    names=(
        "phi1",
        "R1",
        "R2",
        "e",
    ),
    widths=(
        0,
        0,
        0,
        0,
    ),
    shape=(),
    at=_position_point,
    uniform=_fill_position,
    each=_fill_each_position,
)


@overload(position)
def _offer_position(
    phi1,
    R1,
    R2,
    e,
):
    return lambda phi1, R1, R2, e: _position_point(
        float64(phi1),
        float64(R1),
        float64(R2),
        float64(e),
    )


@scalar
def _prepare_acceleration(R1, R2, e, exact):
    k = R1 / R2
    k_low = elementary.quotient_rest(R1, R2, k)
    one_minus_e = 1 - e
    one_plus_e = 1 + e

    return (e, k, k_low, one_minus_e, one_plus_e)


@scalar
def _acceleration(phi1, e, k, k_low, one_minus_e, one_plus_e, exact):
    x = k * phi1
    t_angle = x / 2
    t_below = elementary.tangent_below(t_angle, exact)
    t = elementary.tangent_above(t_angle, exact)
    x_low = k_low * phi1 + elementary.product_rest(k, phi1, x)
    t_low = elementary.small_tangent(x_low / 2)
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


@scalar
def _acceleration_at(phi1, R1, R2, e, exact):
    if not ((R1 > 0) & is_finite(R1) & (R2 > 0) & is_finite(R2) & (e >= 0) & (e < 1) & (R2 < R1)):
        return math.nan
    prepared = _prepare_acceleration(R1, R2, e, exact)
    return _acceleration(phi1, *prepared, exact)


@scalar
def _acceleration_point(phi1, R1, R2, e):
    return _acceleration_at(phi1, R1, R2, e, True)


@loop
def _row_acceleration(out, phi1_values, R1, R2, e, exact):
    widen()
    for i in range(out.size):
        phi1 = float64(phi1_values[i])

        value = _acceleration_at(phi1, R1, R2, e, exact)
        out[i] = value


@loop
def _fill_acceleration(
    out,
    phi1_values,
    R1,
    R2,
    e,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi1_block = phi1_values[start:stop]
        _row_acceleration(out_block, phi1_block, R1, R2, e, None)
        if has_nan(out_block):
            _row_acceleration(out_block, phi1_block, R1, R2, e, True)


@loop
def _row_each_acceleration(out, phi1_values, R1_values, R2_values, e_values, exact):
    widen()
    for i in range(out.size):
        phi1 = float64(phi1_values[i])

        R1 = float64(R1_values[i])

        R2 = float64(R2_values[i])

        e = float64(e_values[i])

        value = _acceleration_at(phi1, R1, R2, e, exact)
        out[i] = value


@loop
def _fill_each_acceleration(
    out,
    phi1_values,
    R1_values,
    R2_values,
    e_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi1_block = phi1_values[start:stop]
        R1_block = R1_values[start:stop]
        R2_block = R2_values[start:stop]
        e_block = e_values[start:stop]
        _row_each_acceleration(out_block, phi1_block, R1_block, R2_block, e_block, None)
        if has_nan(out_block):
            _row_each_acceleration(out_block, phi1_block, R1_block, R2_block, e_block, True)


def acceleration(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute d ratio/d phi1, the angular acceleration of the output at unit carrier speed.

    Compiled. The help of `mechproof.kernels.elliptic_planetary.acceleration` has all words.
    """
    if type(R1) is type(R2) is type(e) is float:
        if type(phi1) is ndarray:
            row = take_row(phi1, out)
            if row is not None:
                _ACCELERATION.fill(row, phi1, R1, R2, e)
                return row
        elif type(phi1) is float and out is None:
            return float64(_ACCELERATION.point(phi1, R1, R2, e))
    return run(
        _ACCELERATION,
        (
            phi1,
            R1,
            R2,
            e,
        ),
        out,
    )


_ACCELERATION = Loops(
    names=(
        "phi1",
        "R1",
        "R2",
        "e",
    ),
    widths=(
        0,
        0,
        0,
        0,
    ),
    shape=(),
    at=_acceleration_point,
    uniform=_fill_acceleration,
    each=_fill_each_acceleration,
)


@overload(acceleration)
def _offer_acceleration(
    phi1,
    R1,
    R2,
    e,
):
    return lambda phi1, R1, R2, e: _acceleration_point(
        float64(phi1),
        float64(R1),
        float64(R2),
        float64(e),
    )


@scalar
def _prepare_largest_ratio(R2, e):

    return (R2, e)


@scalar
def _largest_ratio(R1, R2, e):
    k = R1 / R2

    return 1 + (1 + e) / (1 - e) * k


@scalar
def _largest_ratio_at(R1, R2, e):
    if not ((R2 > 0) & is_finite(R2) & (e >= 0) & (e < 1) & (R1 > 0) & is_finite(R1) & (R2 < R1)):
        return math.nan
    prepared = _prepare_largest_ratio(R2, e)
    return _largest_ratio(R1, *prepared)


@scalar
def _largest_ratio_point(R1, R2, e):
    return _largest_ratio_at(R1, R2, e)


@loop
def _row_largest_ratio(
    out,
    R1_values,
    R2,
    e,
):
    widen()
    for i in range(out.size):
        R1 = float64(R1_values[i])

        value = _largest_ratio_at(R1, R2, e)
        out[i] = value


@loop
def _fill_largest_ratio(
    out,
    R1_values,
    R2,
    e,
):
    _row_largest_ratio(
        out,
        R1_values,
        R2,
        e,
    )


@loop
def _row_each_largest_ratio(
    out,
    R1_values,
    R2_values,
    e_values,
):
    widen()
    for i in range(out.size):
        R1 = float64(R1_values[i])

        R2 = float64(R2_values[i])

        e = float64(e_values[i])

        value = _largest_ratio_at(R1, R2, e)
        out[i] = value


@loop
def _fill_each_largest_ratio(
    out,
    R1_values,
    R2_values,
    e_values,
):
    _row_each_largest_ratio(
        out,
        R1_values,
        R2_values,
        e_values,
    )


def largest_ratio(
    R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the largest transmission ratio, met at phi1 = 0 and every period 2*pi*R2/R1 on.

    Compiled. The help of `mechproof.kernels.elliptic_planetary.largest_ratio` has all words.
    """
    if type(R2) is type(e) is float:
        if type(R1) is ndarray:
            row = take_row(R1, out)
            if row is not None:
                _LARGEST_RATIO.fill(row, R1, R2, e)
                return row
        elif type(R1) is float and out is None:
            return float64(_LARGEST_RATIO.point(R1, R2, e))
    return run(
        _LARGEST_RATIO,
        (
            R1,
            R2,
            e,
        ),
        out,
    )


_LARGEST_RATIO = Loops(
    names=(
        "R1",
        "R2",
        "e",
    ),
    widths=(
        0,
        0,
        0,
    ),
    shape=(),
    at=_largest_ratio_point,
    uniform=_fill_largest_ratio,
    each=_fill_each_largest_ratio,
)


@overload(largest_ratio)
def _offer_largest_ratio(
    R1,
    R2,
    e,
):
    return lambda R1, R2, e: _largest_ratio_point(
        float64(R1),
        float64(R2),
        float64(e),
    )


@scalar
def _prepare_smallest_ratio(R2, e):

    return (R2, e)


@scalar
def _smallest_ratio(R1, R2, e):
    k = R1 / R2

    return 1 + (1 - e) / (1 + e) * k


@scalar
def _smallest_ratio_at(R1, R2, e):
    if not ((R2 > 0) & is_finite(R2) & (e >= 0) & (e < 1) & (R1 > 0) & is_finite(R1) & (R2 < R1)):
        return math.nan
    prepared = _prepare_smallest_ratio(R2, e)
    return _smallest_ratio(R1, *prepared)


@scalar
def _smallest_ratio_point(R1, R2, e):
    return _smallest_ratio_at(R1, R2, e)


@loop
def _row_smallest_ratio(
    out,
    R1_values,
    R2,
    e,
):
    widen()
    for i in range(out.size):
        R1 = float64(R1_values[i])

        value = _smallest_ratio_at(R1, R2, e)
        out[i] = value


@loop
def _fill_smallest_ratio(
    out,
    R1_values,
    R2,
    e,
):
    _row_smallest_ratio(
        out,
        R1_values,
        R2,
        e,
    )


@loop
def _row_each_smallest_ratio(
    out,
    R1_values,
    R2_values,
    e_values,
):
    widen()
    for i in range(out.size):
        R1 = float64(R1_values[i])

        R2 = float64(R2_values[i])

        e = float64(e_values[i])

        value = _smallest_ratio_at(R1, R2, e)
        out[i] = value


@loop
def _fill_each_smallest_ratio(
    out,
    R1_values,
    R2_values,
    e_values,
):
    _row_each_smallest_ratio(
        out,
        R1_values,
        R2_values,
        e_values,
    )


def smallest_ratio(
    R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the smallest transmission ratio, met half a period after the largest.

    Compiled. The help of `mechproof.kernels.elliptic_planetary.smallest_ratio` has all words.
    """
    if type(R2) is type(e) is float:
        if type(R1) is ndarray:
            row = take_row(R1, out)
            if row is not None:
                _SMALLEST_RATIO.fill(row, R1, R2, e)
                return row
        elif type(R1) is float and out is None:
            return float64(_SMALLEST_RATIO.point(R1, R2, e))
    return run(
        _SMALLEST_RATIO,
        (
            R1,
            R2,
            e,
        ),
        out,
    )


_SMALLEST_RATIO = Loops(
    names=(
        "R1",
        "R2",
        "e",
    ),
    widths=(
        0,
        0,
        0,
    ),
    shape=(),
    at=_smallest_ratio_point,
    uniform=_fill_smallest_ratio,
    each=_fill_each_smallest_ratio,
)


@overload(smallest_ratio)
def _offer_smallest_ratio(
    R1,
    R2,
    e,
):
    return lambda R1, R2, e: _smallest_ratio_point(
        float64(R1),
        float64(R2),
        float64(e),
    )


@scalar
def _motion_at(phi1, R1, R2, e, exact):
    return (
        _position_at(phi1, R1, R2, e, exact),
        _ratio_at(phi1, R1, R2, e, exact),
        _acceleration_at(phi1, R1, R2, e, exact),
    )


@scalar
def _motion_point(phi1, R1, R2, e):
    return _motion_at(phi1, R1, R2, e, True)


@loop
def _row_motion(out_position, out_ratio, out_acceleration, phi1_values, R1, R2, e, exact):
    widen()
    for i in range(out_position.size):
        phi1 = float64(phi1_values[i])

        value = _motion_at(phi1, R1, R2, e, exact)
        out_position[i] = value[0]
        out_ratio[i] = value[1]
        out_acceleration[i] = value[2]


@loop
def _fill_motion(
    out_position,
    out_ratio,
    out_acceleration,
    phi1_values,
    R1,
    R2,
    e,
):
    for start in range(0, out_position.size, BLOCK):
        stop = start + BLOCK
        out_position_block = out_position[start:stop]
        out_ratio_block = out_ratio[start:stop]
        out_acceleration_block = out_acceleration[start:stop]
        phi1_block = phi1_values[start:stop]
        _row_motion(
            out_position_block, out_ratio_block, out_acceleration_block, phi1_block, R1, R2, e, None
        )
        if (
            has_nan(out_position_block)
            or has_nan(out_ratio_block)
            or has_nan(out_acceleration_block)
        ):
            _row_motion(
                out_position_block,
                out_ratio_block,
                out_acceleration_block,
                phi1_block,
                R1,
                R2,
                e,
                True,
            )


@loop
def _row_each_motion(
    out_position, out_ratio, out_acceleration, phi1_values, R1_values, R2_values, e_values, exact
):
    widen()
    for i in range(out_position.size):
        phi1 = float64(phi1_values[i])

        R1 = float64(R1_values[i])

        R2 = float64(R2_values[i])

        e = float64(e_values[i])

        value = _motion_at(phi1, R1, R2, e, exact)
        out_position[i] = value[0]
        out_ratio[i] = value[1]
        out_acceleration[i] = value[2]


@loop
def _fill_each_motion(
    out_position,
    out_ratio,
    out_acceleration,
    phi1_values,
    R1_values,
    R2_values,
    e_values,
):
    for start in range(0, out_position.size, BLOCK):
        stop = start + BLOCK
        out_position_block = out_position[start:stop]
        out_ratio_block = out_ratio[start:stop]
        out_acceleration_block = out_acceleration[start:stop]
        phi1_block = phi1_values[start:stop]
        R1_block = R1_values[start:stop]
        R2_block = R2_values[start:stop]
        e_block = e_values[start:stop]
        _row_each_motion(
            out_position_block,
            out_ratio_block,
            out_acceleration_block,
            phi1_block,
            R1_block,
            R2_block,
            e_block,
            None,
        )
        if (
            has_nan(out_position_block)
            or has_nan(out_ratio_block)
            or has_nan(out_acceleration_block)
        ):
            _row_each_motion(
                out_position_block,
                out_ratio_block,
                out_acceleration_block,
                phi1_block,
                R1_block,
                R2_block,
                e_block,
                True,
            )


def motion(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute position, ratio and acceleration in one pass.

    They lie along the first axis of the result, each with the bits of its own kernel. Compiled.
    """
    return run(
        _MOTION,
        (
            phi1,
            R1,
            R2,
            e,
        ),
        out,
    )


_MOTION = Loops(
    names=(
        "phi1",
        "R1",
        "R2",
        "e",
    ),
    widths=(
        0,
        0,
        0,
        0,
    ),
    shape=(),
    at=_motion_point,
    uniform=_fill_motion,
    results=3,
    each=_fill_each_motion,
)


@overload(motion)
def _offer_motion(
    phi1,
    R1,
    R2,
    e,
):
    return lambda phi1, R1, R2, e: _motion_point(
        float64(phi1),
        float64(R1),
        float64(R2),
        float64(e),
    )
