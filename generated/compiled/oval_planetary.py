"""Compiled kernels of the system `oval_planetary`: one loop for each, by numba.

Names, arguments, domains, NaN and errors are those of `mechproof.kernels.oval_planetary`,
and so are the formulas. Numbers and NumPy arrays are taken. With numbers,
kernels can be called inside functions that numba compiles; arguments with components are then
indexed, and so are results.

Tests hold them to the same accuracy bounds. What help says is proved of rounding errors
is proved of these kernels where it says `compiled`, and of the NumPy kernels elsewhere.

Elementary functions: `elementary` 8db31d8544f3.

Generated from mechproof.derivations.oval_planetary with SymPy 1.14.0.
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
    "acceleration_cylindrical",
    "motion",
    "motion_cylindrical",
    "position",
    "position_cylindrical",
    "ratio",
    "ratio_cylindrical",
]


def __dir__() -> list[str]:
    return __all__


@scalar
def _prepare_ratio(e1, e2, mount, exact):
    one_plus_e1 = 1 + e1
    both = one_plus_e1 * (1 + e2)
    one_minus_e1 = 1 - e1
    one_minus_e2 = 1 - e2
    less = one_minus_e1 * one_minus_e2
    sin_mount = elementary.sin(mount, exact)
    lever = 4 * e2 * sin_mount / one_minus_e2
    shift = lever * one_minus_e1 * sin_mount
    rise = lever * one_plus_e1 * elementary.cos(mount, exact)

    return (both, less, shift, rise)


@scalar
def _ratio(phi1, both, less, shift, rise, exact):
    tan_phi1_below = elementary.tangent_below(phi1, exact)
    tan_phi1 = elementary.tangent_above(phi1, exact)
    y = shift * tan_phi1_below + rise * tan_phi1
    tan_phi1_squared = tan_phi1**2

    return 1 - both * (less + shift) / (
        both**2 * tan_phi1_squared + (less * tan_phi1_below + y) ** 2
    ) * (tan_phi1_below * tan_phi1_below + tan_phi1_squared)


@scalar
def _ratio_at(phi1, e1, e2, mount, exact):
    if not ((e1 >= 0) & (e1 < 1) & (e2 >= 0) & (e2 < 1)):
        return math.nan
    prepared = _prepare_ratio(e1, e2, mount, exact)
    return _ratio(phi1, *prepared, exact)


@scalar
def _ratio_point(phi1, e1, e2, mount):
    return _ratio_at(phi1, e1, e2, mount, True)


@loop
def _row_ratio(out, phi1_values, e1, e2, mount, exact):
    widen()
    for i in range(out.size):
        phi1 = float64(phi1_values[i])

        value = _ratio_at(phi1, e1, e2, mount, exact)
        out[i] = value


@loop
def _fill_ratio(
    out,
    phi1_values,
    e1,
    e2,
    mount,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi1_block = phi1_values[start:stop]
        _row_ratio(out_block, phi1_block, e1, e2, mount, None)
        if has_nan(out_block):
            _row_ratio(out_block, phi1_block, e1, e2, mount, True)


@loop
def _row_each_ratio(out, phi1_values, e1_values, e2_values, mount_values, exact):
    widen()
    for i in range(out.size):
        phi1 = float64(phi1_values[i])

        e1 = float64(e1_values[i])

        e2 = float64(e2_values[i])

        mount = float64(mount_values[i])

        value = _ratio_at(phi1, e1, e2, mount, exact)
        out[i] = value


@loop
def _fill_each_ratio(
    out,
    phi1_values,
    e1_values,
    e2_values,
    mount_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi1_block = phi1_values[start:stop]
        e1_block = e1_values[start:stop]
        e2_block = e2_values[start:stop]
        mount_block = mount_values[start:stop]
        _row_each_ratio(out_block, phi1_block, e1_block, e2_block, mount_block, None)
        if has_nan(out_block):
            _row_each_ratio(out_block, phi1_block, e1_block, e2_block, mount_block, True)


def ratio(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute the transmission ratio d phi3/d phi1 of the output wheel to the carrier.

    Compiled. The help of `mechproof.kernels.oval_planetary.ratio` has all words.
    """
    if type(e1) is type(e2) is type(mount) is float:
        if type(phi1) is ndarray:
            row = take_row(phi1, out)
            if row is not None:
                _RATIO.fill(row, phi1, e1, e2, mount)
                return row
        elif type(phi1) is float and out is None:
            return float64(_RATIO.point(phi1, e1, e2, mount))
    return run(
        _RATIO,
        (
            phi1,
            e1,
            e2,
            mount,
        ),
        out,
    )


_RATIO = Loops(
    names=(
        "phi1",
        "e1",
        "e2",
        "mount",
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
    e1,
    e2,
    mount=0.0,
):
    return lambda phi1, e1, e2, mount=0.0: _ratio_point(
        float64(phi1),
        float64(e1),
        float64(e2),
        float64(mount),
    )


@scalar
def _prepare_position(e1, e2, mount, exact):
    sin_mount = elementary.sin(mount, exact)
    one_minus_e2 = 1 - e2
    lever = 4 * e2 * sin_mount / one_minus_e2
    one_minus_e1 = 1 - e1
    shift = lever * one_minus_e1 * sin_mount
    one_plus_e1 = 1 + e1
    rise = lever * one_plus_e1 * elementary.cos(mount, exact)
    swing = 2 * e1 + 2 * e2
    less = one_minus_e1 * one_minus_e2
    both = one_plus_e1 * (1 + e2)

    return (shift, rise, swing, less, both)


@scalar
def _position(phi1, shift, rise, swing, less, both, exact):
    tan_phi1 = elementary.tan(phi1, exact)
    y = shift + rise * tan_phi1

    return elementary.arctan2(tan_phi1 * (y - swing), less + y + both * tan_phi1**2)


@scalar
def _position_at(phi1, e1, e2, mount, exact):
    if not ((e1 >= 0) & (e1 < 1) & (e2 >= 0) & (e2 < 1)):
        return math.nan
    prepared = _prepare_position(e1, e2, mount, exact)
    return _position(phi1, *prepared, exact)


@scalar
def _position_point(phi1, e1, e2, mount):
    return _position_at(phi1, e1, e2, mount, True)


@loop
def _row_position(out, phi1_values, e1, e2, mount, exact):
    widen()
    for i in range(out.size):
        phi1 = float64(phi1_values[i])

        value = _position_at(phi1, e1, e2, mount, exact)
        out[i] = value


@loop
def _fill_position(
    out,
    phi1_values,
    e1,
    e2,
    mount,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi1_block = phi1_values[start:stop]
        _row_position(out_block, phi1_block, e1, e2, mount, None)
        if has_nan(out_block):
            _row_position(out_block, phi1_block, e1, e2, mount, True)


@loop
def _row_each_position(out, phi1_values, e1_values, e2_values, mount_values, exact):
    widen()
    for i in range(out.size):
        phi1 = float64(phi1_values[i])

        e1 = float64(e1_values[i])

        e2 = float64(e2_values[i])

        mount = float64(mount_values[i])

        value = _position_at(phi1, e1, e2, mount, exact)
        out[i] = value


@loop
def _fill_each_position(
    out,
    phi1_values,
    e1_values,
    e2_values,
    mount_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi1_block = phi1_values[start:stop]
        e1_block = e1_values[start:stop]
        e2_block = e2_values[start:stop]
        mount_block = mount_values[start:stop]
        _row_each_position(out_block, phi1_block, e1_block, e2_block, mount_block, None)
        if has_nan(out_block):
            _row_each_position(out_block, phi1_block, e1_block, e2_block, mount_block, True)


def position(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute the position function phi3(phi1) of the output wheel, phi3(0) = 0.

    Compiled. The help of `mechproof.kernels.oval_planetary.position` has all words.
    """
    if type(e1) is type(e2) is type(mount) is float:
        if type(phi1) is ndarray:
            row = take_row(phi1, out)
            if row is not None:
                _POSITION.fill(row, phi1, e1, e2, mount)
                return row
        elif type(phi1) is float and out is None:
            return float64(_POSITION.point(phi1, e1, e2, mount))
    return run(
        _POSITION,
        (
            phi1,
            e1,
            e2,
            mount,
        ),
        out,
    )


_POSITION = Loops(
    names=(
        "phi1",
        "e1",
        "e2",
        "mount",
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
    e1,
    e2,
    mount=0.0,
):
    return lambda phi1, e1, e2, mount=0.0: _position_point(
        float64(phi1),
        float64(e1),
        float64(e2),
        float64(mount),
    )


@scalar
def _prepare_acceleration(e1, e2, mount, exact):
    one_plus_e1 = 1 + e1
    one_plus_e2 = 1 + e2
    both_high = one_plus_e1 * one_plus_e2
    one_plus_e2_low = elementary.sum_rest(1, e2, one_plus_e2)
    one_plus_e1_low = elementary.sum_rest(1, e1, one_plus_e1)
    both_low = (
        one_plus_e1 * one_plus_e2_low
        + one_plus_e1_low * one_plus_e2
        + elementary.product_rest(one_plus_e1, one_plus_e2, both_high)
    )
    both = both_high + both_low
    one_minus_e1 = 1 - e1
    one_minus_e2 = 1 - e2
    less_high = one_minus_e1 * one_minus_e2
    one_minus_e2_low = elementary.sum_rest(1, -e2, one_minus_e2)
    one_minus_e1_low = elementary.sum_rest(1, -e1, one_minus_e1)
    less_low = (
        one_minus_e1 * one_minus_e2_low
        + one_minus_e1_low * one_minus_e2
        + elementary.product_rest(one_minus_e1, one_minus_e2, less_high)
    )
    less = less_high + less_low
    sin_mount = elementary.sin(mount, exact)
    lever = 4 * e2 * sin_mount / one_minus_e2
    shift = lever * one_minus_e1 * sin_mount
    rise = lever * one_plus_e1 * elementary.cos(mount, exact)
    swing = 2 * e1 + 2 * e2

    return (both, less, shift, rise, swing)


@scalar
def _acceleration(phi1, both, less, shift, rise, swing, exact):
    tan_phi1_below = elementary.tangent_below(phi1, exact)
    tan_phi1 = elementary.tangent_above(phi1, exact)
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


@scalar
def _acceleration_at(phi1, e1, e2, mount, exact):
    if not ((e1 >= 0) & (e1 < 1) & (e2 >= 0) & (e2 < 1)):
        return math.nan
    prepared = _prepare_acceleration(e1, e2, mount, exact)
    return _acceleration(phi1, *prepared, exact)


@scalar
def _acceleration_point(phi1, e1, e2, mount):
    return _acceleration_at(phi1, e1, e2, mount, True)


@loop
def _row_acceleration(out, phi1_values, e1, e2, mount, exact):
    widen()
    for i in range(out.size):
        phi1 = float64(phi1_values[i])

        value = _acceleration_at(phi1, e1, e2, mount, exact)
        out[i] = value


@loop
def _fill_acceleration(
    out,
    phi1_values,
    e1,
    e2,
    mount,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi1_block = phi1_values[start:stop]
        _row_acceleration(out_block, phi1_block, e1, e2, mount, None)
        if has_nan(out_block):
            _row_acceleration(out_block, phi1_block, e1, e2, mount, True)


@loop
def _row_each_acceleration(out, phi1_values, e1_values, e2_values, mount_values, exact):
    widen()
    for i in range(out.size):
        phi1 = float64(phi1_values[i])

        e1 = float64(e1_values[i])

        e2 = float64(e2_values[i])

        mount = float64(mount_values[i])

        value = _acceleration_at(phi1, e1, e2, mount, exact)
        out[i] = value


@loop
def _fill_each_acceleration(
    out,
    phi1_values,
    e1_values,
    e2_values,
    mount_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi1_block = phi1_values[start:stop]
        e1_block = e1_values[start:stop]
        e2_block = e2_values[start:stop]
        mount_block = mount_values[start:stop]
        _row_each_acceleration(out_block, phi1_block, e1_block, e2_block, mount_block, None)
        if has_nan(out_block):
            _row_each_acceleration(out_block, phi1_block, e1_block, e2_block, mount_block, True)


def acceleration(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute d ratio/d phi1, the angular acceleration of the output at unit carrier speed.

    Compiled. The help of `mechproof.kernels.oval_planetary.acceleration` has all words.
    """
    if type(e1) is type(e2) is type(mount) is float:
        if type(phi1) is ndarray:
            row = take_row(phi1, out)
            if row is not None:
                _ACCELERATION.fill(row, phi1, e1, e2, mount)
                return row
        elif type(phi1) is float and out is None:
            return float64(_ACCELERATION.point(phi1, e1, e2, mount))
    return run(
        _ACCELERATION,
        (
            phi1,
            e1,
            e2,
            mount,
        ),
        out,
    )


_ACCELERATION = Loops(
    names=(
        "phi1",
        "e1",
        "e2",
        "mount",
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
    e1,
    e2,
    mount=0.0,
):
    return lambda phi1, e1, e2, mount=0.0: _acceleration_point(
        float64(phi1),
        float64(e1),
        float64(e2),
        float64(mount),
    )


@scalar
def _prepare_ratio_cylindrical(R4, R5, e2, exact):
    k = R4 / R5
    one_minus_e2 = 1 - e2
    one_plus_e2 = 1 + e2
    k_low = elementary.quotient_rest(R4, R5, k)

    return (k, one_minus_e2, one_plus_e2, k_low)


@scalar
def _ratio_cylindrical(phi1, k, one_minus_e2, one_plus_e2, k_low, exact):
    x = 2 * k * phi1
    t_angle = x / 2
    t_below = elementary.tangent_below(t_angle, exact)
    t = elementary.tangent_above(t_angle, exact)
    x_low = 2 * k_low * phi1 + 2 * elementary.product_rest(k, phi1, x / 2)
    t_low = elementary.small_tangent(x_low / 2)
    adjacent = t_below - t * t_low
    adjacent_squared = adjacent**2
    opposite = t + t_low * t_below
    opposite_squared = opposite**2

    return 1 - k * one_minus_e2 * one_plus_e2 / (
        one_minus_e2**2 * adjacent_squared + one_plus_e2**2 * opposite_squared
    ) * (adjacent_squared + opposite_squared)


@scalar
def _ratio_cylindrical_at(phi1, R4, R5, e2, exact):
    if not ((R4 > 0) & is_finite(R4) & (R5 > 0) & is_finite(R5) & (e2 >= 0) & (e2 < 1)):
        return math.nan
    prepared = _prepare_ratio_cylindrical(R4, R5, e2, exact)
    return _ratio_cylindrical(phi1, *prepared, exact)


@scalar
def _ratio_cylindrical_point(phi1, R4, R5, e2):
    return _ratio_cylindrical_at(phi1, R4, R5, e2, True)


@loop
def _row_ratio_cylindrical(out, phi1_values, R4, R5, e2, exact):
    widen()
    for i in range(out.size):
        phi1 = float64(phi1_values[i])

        value = _ratio_cylindrical_at(phi1, R4, R5, e2, exact)
        out[i] = value


@loop
def _fill_ratio_cylindrical(
    out,
    phi1_values,
    R4,
    R5,
    e2,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi1_block = phi1_values[start:stop]
        _row_ratio_cylindrical(out_block, phi1_block, R4, R5, e2, None)
        if has_nan(out_block):
            _row_ratio_cylindrical(out_block, phi1_block, R4, R5, e2, True)


@loop
def _row_each_ratio_cylindrical(out, phi1_values, R4_values, R5_values, e2_values, exact):
    widen()
    for i in range(out.size):
        phi1 = float64(phi1_values[i])

        R4 = float64(R4_values[i])

        R5 = float64(R5_values[i])

        e2 = float64(e2_values[i])

        value = _ratio_cylindrical_at(phi1, R4, R5, e2, exact)
        out[i] = value


@loop
def _fill_each_ratio_cylindrical(
    out,
    phi1_values,
    R4_values,
    R5_values,
    e2_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi1_block = phi1_values[start:stop]
        R4_block = R4_values[start:stop]
        R5_block = R5_values[start:stop]
        e2_block = e2_values[start:stop]
        _row_each_ratio_cylindrical(out_block, phi1_block, R4_block, R5_block, e2_block, None)
        if has_nan(out_block):
            _row_each_ratio_cylindrical(out_block, phi1_block, R4_block, R5_block, e2_block, True)


def ratio_cylindrical(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the ratio d phi3/d phi1 with a cylindrical pair 4-5.

    Compiled. The help of `mechproof.kernels.oval_planetary.ratio_cylindrical` has all words.
    """
    if type(R4) is type(R5) is type(e2) is float:
        if type(phi1) is ndarray:
            row = take_row(phi1, out)
            if row is not None:
                _RATIO_CYLINDRICAL.fill(row, phi1, R4, R5, e2)
                return row
        elif type(phi1) is float and out is None:
            return float64(_RATIO_CYLINDRICAL.point(phi1, R4, R5, e2))
    return run(
        _RATIO_CYLINDRICAL,
        (
            phi1,
            R4,
            R5,
            e2,
        ),
        out,
    )


_RATIO_CYLINDRICAL = Loops(
    names=(
        "phi1",
        "R4",
        "R5",
        "e2",
    ),
    widths=(
        0,
        0,
        0,
        0,
    ),
    shape=(),
    at=_ratio_cylindrical_point,
    uniform=_fill_ratio_cylindrical,
    each=_fill_each_ratio_cylindrical,
)


@overload(ratio_cylindrical)
def _offer_ratio_cylindrical(
    phi1,
    R4,
    R5,
    e2,
):
    return lambda phi1, R4, R5, e2: _ratio_cylindrical_point(
        float64(phi1),
        float64(R4),
        float64(R5),
        float64(e2),
    )


@scalar
def _prepare_position_cylindrical_1(R4, R5, e2, exact):
    k = R4 / R5
    one_minus_e2 = 1 - e2
    one_plus_e2 = 1 + e2

    return (R4, R5, e2, k, one_minus_e2, one_plus_e2)


@scalar
def _position_cylindrical_1(phi1, R4, R5, e2, k, one_minus_e2, one_plus_e2, exact):
    x = 2 * k * phi1
    t_angle = x / 2
    t_below = elementary.tangent_below(t_angle, exact)
    t = elementary.tangent_above(t_angle, exact)

    return (R5 - R4) / R5 * phi1 - elementary.arctan_quotient(
        2 * e2 * t * t_below, one_minus_e2 * t_below * t_below + one_plus_e2 * t**2
    )


@scalar
def _prepare_position_cylindrical(R4, R5, e2, exact):
    k = R4 / R5
    k_low = elementary.quotient_rest(R4, R5, k)
    one_minus_e2 = 1 - e2
    one_plus_e2 = 1 + e2

    return (R4, R5, e2, k, k_low, one_minus_e2, one_plus_e2)


@scalar
def _position_cylindrical(phi1, R4, R5, e2, k, k_low, one_minus_e2, one_plus_e2, exact):
    x = 2 * k * phi1
    t_angle = x / 2
    t_below = elementary.tangent_below(t_angle, exact)
    t = elementary.tangent_above(t_angle, exact)
    x_low = 2 * k_low * phi1 + 2 * elementary.product_rest(k, phi1, x / 2)
    t_low = elementary.small_tangent(x_low / 2)
    adjacent = t_below - t * t_low
    opposite = t + t_low * t_below

    return (R5 - R4) / R5 * phi1 - elementary.arctan_quotient(
        2 * e2 * adjacent * opposite, one_minus_e2 * adjacent**2 + one_plus_e2 * opposite**2
    )


@scalar
def _position_cylindrical_at(phi1, R4, R5, e2, exact):
    if not ((R4 > 0) & is_finite(R4) & (R5 > 0) & is_finite(R5) & (e2 >= 0) & (e2 < 1)):
        return math.nan
    if e2 * R4 <= (1 - e2) * abs(R4 - R5):
        prepared = _prepare_position_cylindrical_1(R4, R5, e2, exact)
        return _position_cylindrical_1(phi1, *prepared, exact)

    prepared = _prepare_position_cylindrical(R4, R5, e2, exact)
    return _position_cylindrical(phi1, *prepared, exact)


@scalar
def _position_cylindrical_point(phi1, R4, R5, e2):
    return _position_cylindrical_at(phi1, R4, R5, e2, True)


@loop
def _row_position_cylindrical(out, phi1_values, R4, R5, e2, exact):
    widen()
    for i in range(out.size):
        phi1 = float64(phi1_values[i])

        value = _position_cylindrical_at(phi1, R4, R5, e2, exact)
        out[i] = value


@loop
def _fill_position_cylindrical(
    out,
    phi1_values,
    R4,
    R5,
    e2,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi1_block = phi1_values[start:stop]
        _row_position_cylindrical(out_block, phi1_block, R4, R5, e2, None)
        if has_nan(out_block):
            _row_position_cylindrical(out_block, phi1_block, R4, R5, e2, True)


@loop
def _row_each_position_cylindrical(out, phi1_values, R4_values, R5_values, e2_values, exact):
    widen()
    for i in range(out.size):
        phi1 = float64(phi1_values[i])

        R4 = float64(R4_values[i])

        R5 = float64(R5_values[i])

        e2 = float64(e2_values[i])

        value = _position_cylindrical_at(phi1, R4, R5, e2, exact)
        out[i] = value


@loop
def _fill_each_position_cylindrical(
    out,
    phi1_values,
    R4_values,
    R5_values,
    e2_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi1_block = phi1_values[start:stop]
        R4_block = R4_values[start:stop]
        R5_block = R5_values[start:stop]
        e2_block = e2_values[start:stop]
        _row_each_position_cylindrical(out_block, phi1_block, R4_block, R5_block, e2_block, None)
        if has_nan(out_block):
            _row_each_position_cylindrical(
                out_block, phi1_block, R4_block, R5_block, e2_block, True
            )


def position_cylindrical(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the position function phi3(phi1) with a cylindrical pair 4-5, phi3(0) = 0.

    Compiled. The help of `mechproof.kernels.oval_planetary.position_cylindrical` has all words.
    """
    if type(R4) is type(R5) is type(e2) is float:
        if type(phi1) is ndarray:
            row = take_row(phi1, out)
            if row is not None:
                _POSITION_CYLINDRICAL.fill(row, phi1, R4, R5, e2)
                return row
        elif type(phi1) is float and out is None:
            return float64(_POSITION_CYLINDRICAL.point(phi1, R4, R5, e2))
    return run(
        _POSITION_CYLINDRICAL,
        (
            phi1,
            R4,
            R5,
            e2,
        ),
        out,
    )


_POSITION_CYLINDRICAL = Loops(
    names=(
        "phi1",
        "R4",
        "R5",
        "e2",
    ),
    widths=(
        0,
        0,
        0,
        0,
    ),
    shape=(),
    at=_position_cylindrical_point,
    uniform=_fill_position_cylindrical,
    each=_fill_each_position_cylindrical,
)


@overload(position_cylindrical)
def _offer_position_cylindrical(
    phi1,
    R4,
    R5,
    e2,
):
    return lambda phi1, R4, R5, e2: _position_cylindrical_point(
        float64(phi1),
        float64(R4),
        float64(R5),
        float64(e2),
    )


@scalar
def _prepare_acceleration_cylindrical(R4, R5, e2, exact):
    k = R4 / R5
    k_low = elementary.quotient_rest(R4, R5, k)
    one_minus_e2 = 1 - e2
    one_plus_e2 = 1 + e2

    return (e2, k, k_low, one_minus_e2, one_plus_e2)


@scalar
def _acceleration_cylindrical(phi1, e2, k, k_low, one_minus_e2, one_plus_e2, exact):
    x = 2 * k * phi1
    t_angle = x / 2
    t_below = elementary.tangent_below(t_angle, exact)
    t = elementary.tangent_above(t_angle, exact)
    x_low = 2 * k_low * phi1 + 2 * elementary.product_rest(k, phi1, x / 2)
    t_low = elementary.small_tangent(x_low / 2)
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


@scalar
def _acceleration_cylindrical_at(phi1, R4, R5, e2, exact):
    if not ((R4 > 0) & is_finite(R4) & (R5 > 0) & is_finite(R5) & (e2 >= 0) & (e2 < 1)):
        return math.nan
    prepared = _prepare_acceleration_cylindrical(R4, R5, e2, exact)
    return _acceleration_cylindrical(phi1, *prepared, exact)


@scalar
def _acceleration_cylindrical_point(phi1, R4, R5, e2):
    return _acceleration_cylindrical_at(phi1, R4, R5, e2, True)


@loop
def _row_acceleration_cylindrical(out, phi1_values, R4, R5, e2, exact):
    widen()
    for i in range(out.size):
        phi1 = float64(phi1_values[i])

        value = _acceleration_cylindrical_at(phi1, R4, R5, e2, exact)
        out[i] = value


@loop
def _fill_acceleration_cylindrical(
    out,
    phi1_values,
    R4,
    R5,
    e2,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi1_block = phi1_values[start:stop]
        _row_acceleration_cylindrical(out_block, phi1_block, R4, R5, e2, None)
        if has_nan(out_block):
            _row_acceleration_cylindrical(out_block, phi1_block, R4, R5, e2, True)


@loop
def _row_each_acceleration_cylindrical(out, phi1_values, R4_values, R5_values, e2_values, exact):
    widen()
    for i in range(out.size):
        phi1 = float64(phi1_values[i])

        R4 = float64(R4_values[i])

        R5 = float64(R5_values[i])

        e2 = float64(e2_values[i])

        value = _acceleration_cylindrical_at(phi1, R4, R5, e2, exact)
        out[i] = value


@loop
def _fill_each_acceleration_cylindrical(
    out,
    phi1_values,
    R4_values,
    R5_values,
    e2_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi1_block = phi1_values[start:stop]
        R4_block = R4_values[start:stop]
        R5_block = R5_values[start:stop]
        e2_block = e2_values[start:stop]
        _row_each_acceleration_cylindrical(
            out_block, phi1_block, R4_block, R5_block, e2_block, None
        )
        if has_nan(out_block):
            _row_each_acceleration_cylindrical(
                out_block, phi1_block, R4_block, R5_block, e2_block, True
            )


def acceleration_cylindrical(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute d ratio/d phi1 with a cylindrical pair 4-5.

    Compiled. The help of `mechproof.kernels.oval_planetary.acceleration_cylindrical` has all words.
    """
    if type(R4) is type(R5) is type(e2) is float:
        if type(phi1) is ndarray:
            row = take_row(phi1, out)
            if row is not None:
                _ACCELERATION_CYLINDRICAL.fill(row, phi1, R4, R5, e2)
                return row
        elif type(phi1) is float and out is None:
            return float64(_ACCELERATION_CYLINDRICAL.point(phi1, R4, R5, e2))
    return run(
        _ACCELERATION_CYLINDRICAL,
        (
            phi1,
            R4,
            R5,
            e2,
        ),
        out,
    )


_ACCELERATION_CYLINDRICAL = Loops(
    names=(
        "phi1",
        "R4",
        "R5",
        "e2",
    ),
    widths=(
        0,
        0,
        0,
        0,
    ),
    shape=(),
    at=_acceleration_cylindrical_point,
    uniform=_fill_acceleration_cylindrical,
    each=_fill_each_acceleration_cylindrical,
)


@overload(acceleration_cylindrical)
def _offer_acceleration_cylindrical(
    phi1,
    R4,
    R5,
    e2,
):
    return lambda phi1, R4, R5, e2: _acceleration_cylindrical_point(
        float64(phi1),
        float64(R4),
        float64(R5),
        float64(e2),
    )


@scalar
def _motion_at(phi1, e1, e2, mount, exact):
    return (
        _position_at(phi1, e1, e2, mount, exact),
        _ratio_at(phi1, e1, e2, mount, exact),
        _acceleration_at(phi1, e1, e2, mount, exact),
    )


@scalar
def _motion_point(phi1, e1, e2, mount):
    return _motion_at(phi1, e1, e2, mount, True)


@loop
def _row_motion(out_position, out_ratio, out_acceleration, phi1_values, e1, e2, mount, exact):
    widen()
    for i in range(out_position.size):
        phi1 = float64(phi1_values[i])

        value = _motion_at(phi1, e1, e2, mount, exact)
        out_position[i] = value[0]
        out_ratio[i] = value[1]
        out_acceleration[i] = value[2]


@loop
def _fill_motion(
    out_position,
    out_ratio,
    out_acceleration,
    phi1_values,
    e1,
    e2,
    mount,
):
    for start in range(0, out_position.size, BLOCK):
        stop = start + BLOCK
        out_position_block = out_position[start:stop]
        out_ratio_block = out_ratio[start:stop]
        out_acceleration_block = out_acceleration[start:stop]
        phi1_block = phi1_values[start:stop]
        _row_motion(
            out_position_block,
            out_ratio_block,
            out_acceleration_block,
            phi1_block,
            e1,
            e2,
            mount,
            None,
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
                e1,
                e2,
                mount,
                True,
            )


@loop
def _row_each_motion(
    out_position,
    out_ratio,
    out_acceleration,
    phi1_values,
    e1_values,
    e2_values,
    mount_values,
    exact,
):
    widen()
    for i in range(out_position.size):
        phi1 = float64(phi1_values[i])

        e1 = float64(e1_values[i])

        e2 = float64(e2_values[i])

        mount = float64(mount_values[i])

        value = _motion_at(phi1, e1, e2, mount, exact)
        out_position[i] = value[0]
        out_ratio[i] = value[1]
        out_acceleration[i] = value[2]


@loop
def _fill_each_motion(
    out_position,
    out_ratio,
    out_acceleration,
    phi1_values,
    e1_values,
    e2_values,
    mount_values,
):
    for start in range(0, out_position.size, BLOCK):
        stop = start + BLOCK
        out_position_block = out_position[start:stop]
        out_ratio_block = out_ratio[start:stop]
        out_acceleration_block = out_acceleration[start:stop]
        phi1_block = phi1_values[start:stop]
        e1_block = e1_values[start:stop]
        e2_block = e2_values[start:stop]
        mount_block = mount_values[start:stop]
        _row_each_motion(
            out_position_block,
            out_ratio_block,
            out_acceleration_block,
            phi1_block,
            e1_block,
            e2_block,
            mount_block,
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
                e1_block,
                e2_block,
                mount_block,
                True,
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
    return run(
        _MOTION,
        (
            phi1,
            e1,
            e2,
            mount,
        ),
        out,
    )


_MOTION = Loops(
    names=(
        "phi1",
        "e1",
        "e2",
        "mount",
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
    e1,
    e2,
    mount=0.0,
):
    return lambda phi1, e1, e2, mount=0.0: _motion_point(
        float64(phi1),
        float64(e1),
        float64(e2),
        float64(mount),
    )


@scalar
def _motion_cylindrical_at(phi1, R4, R5, e2, exact):
    return (
        _position_cylindrical_at(phi1, R4, R5, e2, exact),
        _ratio_cylindrical_at(phi1, R4, R5, e2, exact),
        _acceleration_cylindrical_at(phi1, R4, R5, e2, exact),
    )


@scalar
def _motion_cylindrical_point(phi1, R4, R5, e2):
    return _motion_cylindrical_at(phi1, R4, R5, e2, True)


@loop
def _row_motion_cylindrical(
    out_position_cylindrical,
    out_ratio_cylindrical,
    out_acceleration_cylindrical,
    phi1_values,
    R4,
    R5,
    e2,
    exact,
):
    widen()
    for i in range(out_position_cylindrical.size):
        phi1 = float64(phi1_values[i])

        value = _motion_cylindrical_at(phi1, R4, R5, e2, exact)
        out_position_cylindrical[i] = value[0]
        out_ratio_cylindrical[i] = value[1]
        out_acceleration_cylindrical[i] = value[2]


@loop
def _fill_motion_cylindrical(
    out_position_cylindrical,
    out_ratio_cylindrical,
    out_acceleration_cylindrical,
    phi1_values,
    R4,
    R5,
    e2,
):
    for start in range(0, out_position_cylindrical.size, BLOCK):
        stop = start + BLOCK
        out_position_cylindrical_block = out_position_cylindrical[start:stop]
        out_ratio_cylindrical_block = out_ratio_cylindrical[start:stop]
        out_acceleration_cylindrical_block = out_acceleration_cylindrical[start:stop]
        phi1_block = phi1_values[start:stop]
        _row_motion_cylindrical(
            out_position_cylindrical_block,
            out_ratio_cylindrical_block,
            out_acceleration_cylindrical_block,
            phi1_block,
            R4,
            R5,
            e2,
            None,
        )
        if (
            has_nan(out_position_cylindrical_block)
            or has_nan(out_ratio_cylindrical_block)
            or has_nan(out_acceleration_cylindrical_block)
        ):
            _row_motion_cylindrical(
                out_position_cylindrical_block,
                out_ratio_cylindrical_block,
                out_acceleration_cylindrical_block,
                phi1_block,
                R4,
                R5,
                e2,
                True,
            )


@loop
def _row_each_motion_cylindrical(
    out_position_cylindrical,
    out_ratio_cylindrical,
    out_acceleration_cylindrical,
    phi1_values,
    R4_values,
    R5_values,
    e2_values,
    exact,
):
    widen()
    for i in range(out_position_cylindrical.size):
        phi1 = float64(phi1_values[i])

        R4 = float64(R4_values[i])

        R5 = float64(R5_values[i])

        e2 = float64(e2_values[i])

        value = _motion_cylindrical_at(phi1, R4, R5, e2, exact)
        out_position_cylindrical[i] = value[0]
        out_ratio_cylindrical[i] = value[1]
        out_acceleration_cylindrical[i] = value[2]


@loop
def _fill_each_motion_cylindrical(
    out_position_cylindrical,
    out_ratio_cylindrical,
    out_acceleration_cylindrical,
    phi1_values,
    R4_values,
    R5_values,
    e2_values,
):
    for start in range(0, out_position_cylindrical.size, BLOCK):
        stop = start + BLOCK
        out_position_cylindrical_block = out_position_cylindrical[start:stop]
        out_ratio_cylindrical_block = out_ratio_cylindrical[start:stop]
        out_acceleration_cylindrical_block = out_acceleration_cylindrical[start:stop]
        phi1_block = phi1_values[start:stop]
        R4_block = R4_values[start:stop]
        R5_block = R5_values[start:stop]
        e2_block = e2_values[start:stop]
        _row_each_motion_cylindrical(
            out_position_cylindrical_block,
            out_ratio_cylindrical_block,
            out_acceleration_cylindrical_block,
            phi1_block,
            R4_block,
            R5_block,
            e2_block,
            None,
        )
        if (
            has_nan(out_position_cylindrical_block)
            or has_nan(out_ratio_cylindrical_block)
            or has_nan(out_acceleration_cylindrical_block)
        ):
            _row_each_motion_cylindrical(
                out_position_cylindrical_block,
                out_ratio_cylindrical_block,
                out_acceleration_cylindrical_block,
                phi1_block,
                R4_block,
                R5_block,
                e2_block,
                True,
            )


def motion_cylindrical(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute position_cylindrical, ratio_cylindrical and acceleration_cylindrical in one pass.

    They lie along the first axis of the result, each with the bits of its own kernel. Compiled.
    """
    return run(
        _MOTION_CYLINDRICAL,
        (
            phi1,
            R4,
            R5,
            e2,
        ),
        out,
    )


_MOTION_CYLINDRICAL = Loops(
    names=(
        "phi1",
        "R4",
        "R5",
        "e2",
    ),
    widths=(
        0,
        0,
        0,
        0,
    ),
    shape=(),
    at=_motion_cylindrical_point,
    uniform=_fill_motion_cylindrical,
    results=3,
    each=_fill_each_motion_cylindrical,
)


@overload(motion_cylindrical)
def _offer_motion_cylindrical(
    phi1,
    R4,
    R5,
    e2,
):
    return lambda phi1, R4, R5, e2: _motion_cylindrical_point(
        float64(phi1),
        float64(R4),
        float64(R5),
        float64(e2),
    )
