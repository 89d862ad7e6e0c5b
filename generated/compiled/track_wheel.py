"""Compiled kernels of the system `track_wheel`: one loop for each, by numba.

Names, arguments, domains, NaN and errors are those of `mechproof.kernels.track_wheel`,
and so are the formulas. Kernels take numbers and NumPy arrays. Functions that numba
compiles can call them, also with numbers and arrays mixed; arguments and results with
components are then indexed.

Tests hold them to the same accuracy bounds. Proved bounds on rounding errors, as help
states them, hold for these kernels where it says `compiled`, otherwise for NumPy's.

Elementary functions: `elementary` 2b535d4ac6f8.

Sums over axes are added in the order of the index, keeping the rounding error of every
addition. Many sets of terms are added side by side, each to the same bits as alone. Inside
functions that numba compiles, a sum takes one array of terms for each argument, or a number
if all are equal.

Generated from the derivation track_wheel with SymPy 1.14.0.
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
    Sums as _Sums,
    add_up as _add_up,
    choose as _choose,
    count_terms as _count_terms,
    element as _element,
    every as _every,
    fill as _fill,
    fill_blocks as _fill_blocks,
    fill_sets as _fill_sets,
    floor as _floor,
    fma as _fma,
    is_finite as _is_finite,
    loop as _loop,
    point_of as _point_of,
    run as _run,
    run_sums as _run_sums,
    scalar as _scalar,
    take_row as _take_row,
    take_square as _take_square,
    take_terms as _take_terms,
    vector as _vector,
)
from mechproof.kernels.compiled import elementary as _elementary

__all__ = [
    "displacement",
    "error_sum",
    "error_sum_correlated",
    "error_sum_thermal",
    "largest_radius",
    "planar_error",
    "radius",
    "rotation",
    "smallest_radius",
    "spatial_error",
    "tilt_of_planar_error",
    "tilt_of_spatial_error",
    "track",
]


def __dir__() -> list[str]:
    return __all__


@_scalar
def _sum_1_term(_at, _i, _j, sensitivities, scatters, tolerances, correlation):
    sensitivities_i = _element(sensitivities, _at, _i)
    scatters_i = _element(scatters, _at, _i)
    tolerances_i = _element(tolerances, _at, _i)
    sensitivities_j = _element(sensitivities, _at, _j)
    scatters_j = _element(scatters, _at, _j)
    tolerances_j = _element(tolerances, _at, _j)
    correlation_ij = _element(correlation, _at, _i, _j)
    return (
        sensitivities_i
        * scatters_i
        * tolerances_i
        * (sensitivities_j * scatters_j * tolerances_j)
        * correlation_ij
    )


@_scalar
def _sum_2_term(_at, _i, _j, sensitivities, scatters, tolerances, correlation):
    sensitivities_i = _element(sensitivities, _at, _i)
    scatters_i = _element(scatters, _at, _i)
    tolerances_i = _element(tolerances, _at, _i)
    correlation_ii = _element(correlation, _at, _i, _i)
    return _abs(sensitivities_i * scatters_i * tolerances_i) * _np.sqrt(_abs(correlation_ii))


@_scalar
def _every_3_term(_at, _i, _j, scatters):
    scatters_i = _element(scatters, _at, _i)
    return scatters_i > 0


@_scalar
def _every_4_term(_at, _i, _j, scatters):
    scatters_i = _element(scatters, _at, _i)
    return _is_finite(scatters_i)


@_scalar
def _every_5_term(_at, _i, _j, correlation):
    correlation_ij = _element(correlation, _at, _i, _j)
    return correlation_ij >= -1


@_scalar
def _every_6_term(_at, _i, _j, correlation):
    correlation_ij = _element(correlation, _at, _i, _j)
    return correlation_ij <= 1


@_scalar
def _every_7_term(_at, _i, _j, correlation):
    correlation_ii = _element(correlation, _at, _i, _i)
    return correlation_ii == 1


@_scalar
def _every_8_term(_at, _i, _j, correlation):
    correlation_ij = _element(correlation, _at, _i, _j)
    correlation_ji = _element(correlation, _at, _j, _i)
    return correlation_ij == correlation_ji


@_scalar
def _every_9_term(_at, _i, _j, tolerances):
    tolerances_i = _element(tolerances, _at, _i)
    return tolerances_i >= 0


@_scalar
def _every_10_term(_at, _i, _j, tolerances):
    tolerances_i = _element(tolerances, _at, _i)
    return _is_finite(tolerances_i)


@_scalar
def _sum_11_term(_at, _i, _j, sensitivities, scatters, tolerances):
    sensitivities_i = _element(sensitivities, _at, _i)
    scatters_i = _element(scatters, _at, _i)
    tolerances_i = _element(tolerances, _at, _i)
    return (sensitivities_i * scatters_i * tolerances_i) ** 2


@_scalar
def _value_of_rotation(alpha, beta, gamma, _exact):
    cos_beta = _elementary.cos(beta, _exact)
    cos_gamma = _elementary.cos(gamma, _exact)
    sin_gamma = _elementary.sin(gamma, _exact)
    sin_beta = _elementary.sin(beta, _exact)
    cos_alpha = _elementary.cos(alpha, _exact)
    sin_alpha = _elementary.sin(alpha, _exact)
    return (
        cos_beta * cos_gamma,
        sin_gamma * cos_alpha + cos_gamma * sin_beta * sin_alpha,
        sin_gamma * sin_alpha - cos_gamma * sin_beta * cos_alpha,
        -cos_beta * sin_gamma,
        cos_gamma * cos_alpha - sin_beta * sin_gamma * sin_alpha,
        cos_gamma * sin_alpha + sin_beta * sin_gamma * cos_alpha,
        sin_beta,
        -cos_beta * sin_alpha,
        cos_beta * cos_alpha,
    )


@_loop
def _fill_of_rotation(_out, alpha, beta, gamma):
    _fill_blocks(_value_of_rotation, _vector(_out, 9), (alpha, beta, gamma))


def rotation(
    alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the matrix K of the turns alpha, beta, gamma: coordinates in the part's frame.

    Compiled. Its full documentation is that of
    `mechproof.kernels.track_wheel.rotation`.
    """
    return _run(_loops_of_rotation, (alpha, beta, gamma), out)


@_point_of(rotation)
def _point_of_rotation(alpha, beta, gamma):
    return _value_of_rotation(_float64(alpha), _float64(beta), _float64(gamma), True)


_loops_of_rotation = _Loops(
    ("alpha", "beta", "gamma"), _point_of_rotation, _fill_of_rotation, shape=(3, 3)
)


@_scalar
def _value_of_displacement(
    points_0, points_1, points_2, angles_0, angles_1, angles_2, shift_0, shift_1, shift_2, _exact
):
    t_alpha_angle = angles_0 / 2
    t_alpha_below = _elementary.tangent_below(t_alpha_angle, _exact)
    t_alpha = _elementary.tangent_above(t_alpha_angle, _exact)
    t_beta_angle = angles_1 / 2
    t_beta_below = _elementary.tangent_below(t_beta_angle, _exact)
    t_beta = _elementary.tangent_above(t_beta_angle, _exact)
    t_gamma_angle = angles_2 / 2
    t_gamma_below = _elementary.tangent_below(t_gamma_angle, _exact)
    t_gamma = _elementary.tangent_above(t_gamma_angle, _exact)
    v_x = _fma(t_alpha * t_beta_below, t_gamma_below, t_beta * t_gamma * t_alpha_below)
    v_x_squared = v_x**2
    v_y = _fma(t_beta * t_alpha_below, t_gamma_below, -(t_alpha * t_gamma * t_beta_below))
    v_y_squared = v_y**2
    v_z = _fma(t_gamma * t_alpha_below, t_beta_below, t_alpha * t_beta * t_gamma_below)
    v_z_squared = v_z**2
    w = _fma(t_alpha_below * t_beta_below, t_gamma_below, -(t_alpha * t_beta * t_gamma))
    scale = 2 / _fma(w, w, v_x_squared + v_y_squared + v_z_squared)
    C11 = scale * (-v_y_squared - v_z_squared)
    s_x = scale * v_x
    s_x_v_y = s_x * v_y
    s_z = scale * v_z
    C12 = _fma(-s_z, w, s_x_v_y)
    s_x_v_z = s_x * v_z
    s_y = scale * v_y
    C13 = _fma(s_y, w, s_x_v_z)
    C21 = _fma(s_z, w, s_x_v_y)
    C22 = scale * (-v_x_squared - v_z_squared)
    s_y_v_z = s_y * v_z
    C23 = _fma(-s_x, w, s_y_v_z)
    C31 = _fma(-s_y, w, s_x_v_z)
    C32 = _fma(s_x, w, s_y_v_z)
    C33 = scale * (-v_x_squared - v_y_squared)
    return (
        _fma(C11, points_0, _fma(C12, points_1, _fma(C13, points_2, shift_0))),
        _fma(C21, points_0, _fma(C22, points_1, _fma(C23, points_2, shift_1))),
        _fma(C31, points_0, _fma(C32, points_1, _fma(C33, points_2, shift_2))),
    )


@_loop
def _fill_of_displacement(_out, points, angles, shift):
    _fill_blocks(
        _value_of_displacement,
        _vector(_out, 3),
        (_vector(points, 3), _vector(angles, 3), _vector(shift, 3)),
    )


def displacement(
    points: ArrayLike, angles: ArrayLike, shift: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the position errors K^T*p - (p - t) of points p, turn K and shift t.

    Compiled. Its full documentation is that of
    `mechproof.kernels.track_wheel.displacement`.
    """
    return _run(_loops_of_displacement, (points, angles, shift), out)


@_point_of(displacement)
def _point_of_displacement(points, angles, shift):
    return _value_of_displacement(
        _float64(points[0]),
        _float64(points[1]),
        _float64(points[2]),
        _float64(angles[0]),
        _float64(angles[1]),
        _float64(angles[2]),
        _float64(shift[0]),
        _float64(shift[1]),
        _float64(shift[2]),
        True,
    )


_loops_of_displacement = _Loops(
    ("points", "angles", "shift"),
    _point_of_displacement,
    _fill_of_displacement,
    widths=(3, 3, 3),
    shape=(3,),
)


@_scalar
def _value_of_planar_error(displacement_0, displacement_1, displacement_2):
    return _elementary.hypot(displacement_0, displacement_1)


@_loop
def _fill_of_planar_error(_out, displacement):
    _fill(_value_of_planar_error, _out, (_vector(displacement, 3),))


def planar_error(displacement: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the error in the end plane X0Y0.

    Compiled. Its full documentation is that of
    `mechproof.kernels.track_wheel.planar_error`.
    """
    return _run(_loops_of_planar_error, (displacement,), out)


@_point_of(planar_error)
def _point_of_planar_error(displacement):
    return _value_of_planar_error(
        _float64(displacement[0]), _float64(displacement[1]), _float64(displacement[2])
    )


_loops_of_planar_error = _Loops(
    ("displacement",), _point_of_planar_error, _fill_of_planar_error, widths=(3,)
)


@_scalar
def _value_of_spatial_error(displacement_0, displacement_1, displacement_2):
    return _elementary.hypot(_elementary.hypot(displacement_0, displacement_1), displacement_2)


@_loop
def _fill_of_spatial_error(_out, displacement):
    _fill(_value_of_spatial_error, _out, (_vector(displacement, 3),))


def spatial_error(displacement: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the error in space.

    Compiled. Its full documentation is that of
    `mechproof.kernels.track_wheel.spatial_error`.
    """
    return _run(_loops_of_spatial_error, (displacement,), out)


@_point_of(spatial_error)
def _point_of_spatial_error(displacement):
    return _value_of_spatial_error(
        _float64(displacement[0]), _float64(displacement[1]), _float64(displacement[2])
    )


_loops_of_spatial_error = _Loops(
    ("displacement",), _point_of_spatial_error, _fill_of_spatial_error, widths=(3,)
)


@_scalar
def _value_of_radius(phi, R, A, z, _exact):
    if not ((R > 0) & _is_finite(R) & (z >= 1) & _is_finite(z) & (z == _floor(z)) & (_abs(A) <= R)):
        return _math.nan
    A_plus_R = A + R
    R_minus_A = R - A
    w = A_plus_R * R_minus_A
    u = A * _elementary.cos(z * phi, _exact)
    q = _abs(u) + _elementary.hypot(_np.sqrt(w), u)
    return _choose(u >= 0, q, w / q)


@_loop
def _fill_of_radius(_out, phi, R, A, z):
    _fill_blocks(_value_of_radius, _out, (phi, R, A, z))


def radius(
    phi: ArrayLike, R: ArrayLike, A: ArrayLike, z: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the radius vector of the track, a shifted circle repeated z times.

    Compiled. Its full documentation is that of
    `mechproof.kernels.track_wheel.radius`.
    """
    if _type(R) is _type(A) is _type(z) is _float:
        if _type(phi) is _ndarray and (_row := _take_row(phi, out)) is not None:
            _loops_of_radius.fill(_row, phi, R, A, z)
            return _row
        if _type(phi) is _float and out is None:
            return _float64(_loops_of_radius.point(phi, R, A, z))
    return _run(_loops_of_radius, (phi, R, A, z), out)


@_point_of(radius, spread=True)
def _point_of_radius(phi, R, A, z):
    return _value_of_radius(_float64(phi), _float64(R), _float64(A), _float64(z), True)


_loops_of_radius = _Loops(("phi", "R", "A", "z"), _point_of_radius, _fill_of_radius)


@_scalar
def _value_of_track(phi, R, A, z, H, _exact):
    if not (
        (R > 0)
        & _is_finite(R)
        & (H > 0)
        & _is_finite(H)
        & (z >= 1)
        & _is_finite(z)
        & (z == _floor(z))
        & (_abs(A) <= R)
    ):
        return (_math.nan, _math.nan, _math.nan)
    A_plus_R = A + R
    R_minus_A = R - A
    w = A_plus_R * R_minus_A
    u = A * _elementary.cos(z * phi, _exact)
    q = _abs(u) + _elementary.hypot(_np.sqrt(w), u)
    term = _choose(u >= 0, q, w / q)
    return (term * _elementary.cos(phi, _exact), term * _elementary.sin(phi, _exact), H)


@_loop
def _fill_of_track(_out, phi, R, A, z, H):
    _fill_blocks(_value_of_track, _vector(_out, 3), (phi, R, A, z, H))


def track(
    phi: ArrayLike,
    R: ArrayLike,
    A: ArrayLike,
    z: ArrayLike,
    H: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute points of the track.

    Compiled. Its full documentation is that of
    `mechproof.kernels.track_wheel.track`.
    """
    return _run(_loops_of_track, (phi, R, A, z, H), out)


@_point_of(track)
def _point_of_track(phi, R, A, z, H):
    return _value_of_track(_float64(phi), _float64(R), _float64(A), _float64(z), _float64(H), True)


_loops_of_track = _Loops(("phi", "R", "A", "z", "H"), _point_of_track, _fill_of_track, shape=(3,))


@_scalar
def _value_of_largest_radius(R, A):
    if not ((R > 0) & _is_finite(R) & (_abs(A) <= R)):
        return _math.nan
    return R + _abs(A)


@_loop
def _fill_of_largest_radius(_out, R, A):
    _fill(_value_of_largest_radius, _out, (R, A))


def largest_radius(R: ArrayLike, A: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the largest radius vector of the track.

    Compiled. Its full documentation is that of
    `mechproof.kernels.track_wheel.largest_radius`.
    """
    if _type(A) is _float:
        if _type(R) is _ndarray and (_row := _take_row(R, out)) is not None:
            _loops_of_largest_radius.fill(_row, R, A)
            return _row
        if _type(R) is _float and out is None:
            return _float64(_loops_of_largest_radius.point(R, A))
    return _run(_loops_of_largest_radius, (R, A), out)


@_point_of(largest_radius, spread=True)
def _point_of_largest_radius(R, A):
    return _value_of_largest_radius(_float64(R), _float64(A))


_loops_of_largest_radius = _Loops(("R", "A"), _point_of_largest_radius, _fill_of_largest_radius)


@_scalar
def _value_of_smallest_radius(R, A):
    if not ((R > 0) & _is_finite(R) & (_abs(A) <= R)):
        return _math.nan
    return R - _abs(A)


@_loop
def _fill_of_smallest_radius(_out, R, A):
    _fill(_value_of_smallest_radius, _out, (R, A))


def smallest_radius(R: ArrayLike, A: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the smallest radius vector of the track.

    Compiled. Its full documentation is that of
    `mechproof.kernels.track_wheel.smallest_radius`.
    """
    if _type(A) is _float:
        if _type(R) is _ndarray and (_row := _take_row(R, out)) is not None:
            _loops_of_smallest_radius.fill(_row, R, A)
            return _row
        if _type(R) is _float and out is None:
            return _float64(_loops_of_smallest_radius.point(R, A))
    return _run(_loops_of_smallest_radius, (R, A), out)


@_point_of(smallest_radius, spread=True)
def _point_of_smallest_radius(R, A):
    return _value_of_smallest_radius(_float64(R), _float64(A))


_loops_of_smallest_radius = _Loops(("R", "A"), _point_of_smallest_radius, _fill_of_smallest_radius)


@_scalar
def _value_of_error_sum_correlated(
    total_scatter,
    every_3,
    every_4,
    every_5,
    every_6,
    every_7,
    every_8,
    every_9,
    every_10,
    sum_1,
    sum_2,
):
    if not (
        (total_scatter > 0)
        & _is_finite(total_scatter)
        & every_3
        & every_4
        & every_5
        & every_6
        & every_7
        & every_8
        & every_9
        & every_10
    ):
        return _math.nan
    return _np.sqrt(_elementary.nonnegative(sum_1, sum_2**2)) / total_scatter


@_scalar
def _sums_of_error_sum_correlated(
    _at, _terms, tolerances, sensitivities, scatters, correlation, total_scatter
):
    return (
        _element(total_scatter, _at),
        _every(_every_3_term, _at, 0, (_terms,), (scatters,)),
        _every(_every_4_term, _at, 1, (_terms,), (scatters,)),
        _every(_every_5_term, _at, 2, (_terms, _terms), (correlation,)),
        _every(_every_6_term, _at, 3, (_terms, _terms), (correlation,)),
        _every(_every_7_term, _at, 4, (_terms,), (correlation,)),
        _every(_every_8_term, _at, 5, (_terms, _terms), (correlation,)),
        _every(_every_9_term, _at, 6, (_terms,), (tolerances,)),
        _every(_every_10_term, _at, 7, (_terms,), (tolerances,)),
        _add_up(
            _sum_1_term,
            _elementary.total_rest,
            _at,
            8,
            (_terms, _terms),
            (sensitivities, scatters, tolerances, correlation),
        ),
        _add_up(
            _sum_2_term,
            _elementary.total_rest,
            _at,
            9,
            (_terms,),
            (sensitivities, scatters, tolerances, correlation),
        ),
    )


@_loop
def _fill_of_error_sum_correlated(
    _out, _terms, tolerances, sensitivities, scatters, correlation, total_scatter
):
    _fill_sets(
        _value_of_error_sum_correlated,
        _sums_of_error_sum_correlated,
        10,
        _out,
        _terms,
        (tolerances, sensitivities, scatters, correlation, total_scatter),
        (_terms, _terms, _terms, _terms * _terms, 1),
        (),
    )


def error_sum_correlated(
    tolerances: ArrayLike,
    sensitivities: ArrayLike,
    scatters: ArrayLike,
    correlation: ArrayLike,
    total_scatter: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute the total error of correlated elementary errors.

    Compiled. Its full documentation is that of
    `mechproof.kernels.track_wheel.error_sum_correlated`.
    """
    return _run_sums(
        _loops_of_error_sum_correlated,
        (tolerances, sensitivities, scatters, correlation, total_scatter),
        out,
    )


@_point_of(error_sum_correlated)
def _point_of_error_sum_correlated(tolerances, sensitivities, scatters, correlation, total_scatter):
    _terms = _count_terms(tolerances, sensitivities, scatters, correlation)
    tolerances = _take_terms("tolerances", tolerances, _terms)
    sensitivities = _take_terms("sensitivities", sensitivities, _terms)
    scatters = _take_terms("scatters", scatters, _terms)
    correlation = _take_square("correlation", correlation, _terms)
    return _value_of_error_sum_correlated(
        *_sums_of_error_sum_correlated(
            None, _terms, tolerances, sensitivities, scatters, correlation, total_scatter
        )
    )


_loops_of_error_sum_correlated = _Sums(
    ("tolerances", "sensitivities", "scatters", "correlation", "total_scatter"),
    (1, 1, 1, 2, 0),
    _point_of_error_sum_correlated,
    _fill_of_error_sum_correlated,
)


@_scalar
def _value_of_error_sum(total_scatter, every_3, every_4, every_9, every_10, sum_11):
    if not (
        (total_scatter > 0) & _is_finite(total_scatter) & every_3 & every_4 & every_9 & every_10
    ):
        return _math.nan
    return _np.sqrt(sum_11) / total_scatter


@_scalar
def _sums_of_error_sum(_at, _terms, tolerances, sensitivities, scatters, total_scatter):
    return (
        _element(total_scatter, _at),
        _every(_every_3_term, _at, 0, (_terms,), (scatters,)),
        _every(_every_4_term, _at, 1, (_terms,), (scatters,)),
        _every(_every_9_term, _at, 2, (_terms,), (tolerances,)),
        _every(_every_10_term, _at, 3, (_terms,), (tolerances,)),
        _add_up(
            _sum_11_term,
            _elementary.total_rest,
            _at,
            4,
            (_terms,),
            (sensitivities, scatters, tolerances),
        ),
    )


@_loop
def _fill_of_error_sum(_out, _terms, tolerances, sensitivities, scatters, total_scatter):
    _fill_sets(
        _value_of_error_sum,
        _sums_of_error_sum,
        5,
        _out,
        _terms,
        (tolerances, sensitivities, scatters, total_scatter),
        (_terms, _terms, _terms, 1),
        (),
    )


def error_sum(
    tolerances: ArrayLike,
    sensitivities: ArrayLike,
    scatters: ArrayLike,
    total_scatter: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute the total error of independent elementary errors.

    Compiled. Its full documentation is that of
    `mechproof.kernels.track_wheel.error_sum`.
    """
    return _run_sums(_loops_of_error_sum, (tolerances, sensitivities, scatters, total_scatter), out)


@_point_of(error_sum)
def _point_of_error_sum(tolerances, sensitivities, scatters, total_scatter):
    _terms = _count_terms(tolerances, sensitivities, scatters)
    tolerances = _take_terms("tolerances", tolerances, _terms)
    sensitivities = _take_terms("sensitivities", sensitivities, _terms)
    scatters = _take_terms("scatters", scatters, _terms)
    return _value_of_error_sum(
        *_sums_of_error_sum(None, _terms, tolerances, sensitivities, scatters, total_scatter)
    )


_loops_of_error_sum = _Sums(
    ("tolerances", "sensitivities", "scatters", "total_scatter"),
    (1, 1, 1, 0),
    _point_of_error_sum,
    _fill_of_error_sum,
)


@_scalar
def _value_of_error_sum_thermal(
    total_scatter, thermal_share, thermal_scatter, every_3, every_4, every_9, every_10, sum_11
):
    if not (
        (total_scatter > 0)
        & _is_finite(total_scatter)
        & every_3
        & every_4
        & (thermal_scatter > 0)
        & _is_finite(thermal_scatter)
        & (thermal_share >= 0)
        & _is_finite(thermal_share)
        & (thermal_share * thermal_scatter < total_scatter)
        & every_9
        & every_10
    ):
        return _math.nan
    K_minus_tau_K_T = total_scatter - thermal_share * thermal_scatter
    K_plus_tau_K_T = total_scatter + thermal_share * thermal_scatter
    return _np.sqrt(sum_11) / _np.sqrt(K_minus_tau_K_T * K_plus_tau_K_T)


@_scalar
def _sums_of_error_sum_thermal(
    _at, _terms, tolerances, sensitivities, scatters, total_scatter, thermal_share, thermal_scatter
):
    return (
        _element(total_scatter, _at),
        _element(thermal_share, _at),
        _element(thermal_scatter, _at),
        _every(_every_3_term, _at, 0, (_terms,), (scatters,)),
        _every(_every_4_term, _at, 1, (_terms,), (scatters,)),
        _every(_every_9_term, _at, 2, (_terms,), (tolerances,)),
        _every(_every_10_term, _at, 3, (_terms,), (tolerances,)),
        _add_up(
            _sum_11_term,
            _elementary.total_rest,
            _at,
            4,
            (_terms,),
            (sensitivities, scatters, tolerances),
        ),
    )


@_loop
def _fill_of_error_sum_thermal(
    _out, _terms, tolerances, sensitivities, scatters, total_scatter, thermal_share, thermal_scatter
):
    _fill_sets(
        _value_of_error_sum_thermal,
        _sums_of_error_sum_thermal,
        5,
        _out,
        _terms,
        (tolerances, sensitivities, scatters, total_scatter, thermal_share, thermal_scatter),
        (_terms, _terms, _terms, 1, 1, 1),
        (),
    )


def error_sum_thermal(
    tolerances: ArrayLike,
    sensitivities: ArrayLike,
    scatters: ArrayLike,
    total_scatter: ArrayLike,
    thermal_share: ArrayLike,
    thermal_scatter: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute the total error with a temperature error in fixed proportion to the total itself.

    Compiled. Its full documentation is that of
    `mechproof.kernels.track_wheel.error_sum_thermal`.
    """
    return _run_sums(
        _loops_of_error_sum_thermal,
        (tolerances, sensitivities, scatters, total_scatter, thermal_share, thermal_scatter),
        out,
    )


@_point_of(error_sum_thermal)
def _point_of_error_sum_thermal(
    tolerances, sensitivities, scatters, total_scatter, thermal_share, thermal_scatter
):
    _terms = _count_terms(tolerances, sensitivities, scatters)
    tolerances = _take_terms("tolerances", tolerances, _terms)
    sensitivities = _take_terms("sensitivities", sensitivities, _terms)
    scatters = _take_terms("scatters", scatters, _terms)
    return _value_of_error_sum_thermal(
        *_sums_of_error_sum_thermal(
            None,
            _terms,
            tolerances,
            sensitivities,
            scatters,
            total_scatter,
            thermal_share,
            thermal_scatter,
        )
    )


_loops_of_error_sum_thermal = _Sums(
    (
        "tolerances",
        "sensitivities",
        "scatters",
        "total_scatter",
        "thermal_share",
        "thermal_scatter",
    ),
    (1, 1, 1, 0, 0, 0),
    _point_of_error_sum_thermal,
    _fill_of_error_sum_thermal,
)


@_scalar
def _value_of_tilt_of_planar_error(error, offset, rho, H):
    if not (
        (H > 0)
        & _is_finite(H)
        & (rho > 0)
        & _is_finite(rho)
        & (offset >= 0)
        & _is_finite(offset)
        & (error > 0)
        & _is_finite(error)
        & (error - offset >= 0)
        & (error - offset <= H + rho)
    ):
        return _math.nan
    term = error - offset
    return 2 * _elementary.arctan2(term, H + _np.sqrt(H**2 + 2 * rho * term - term**2))


@_loop
def _fill_of_tilt_of_planar_error(_out, error, offset, rho, H):
    _fill(_value_of_tilt_of_planar_error, _out, (error, offset, rho, H))


def tilt_of_planar_error(
    error: ArrayLike,
    offset: ArrayLike,
    rho: ArrayLike,
    H: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute the tilt with which the largest error in the plane is the one wanted.

    Compiled. Its full documentation is that of
    `mechproof.kernels.track_wheel.tilt_of_planar_error`.
    """
    if _type(offset) is _type(rho) is _type(H) is _float:
        if _type(error) is _ndarray and (_row := _take_row(error, out)) is not None:
            _loops_of_tilt_of_planar_error.fill(_row, error, offset, rho, H)
            return _row
        if _type(error) is _float and out is None:
            return _float64(_loops_of_tilt_of_planar_error.point(error, offset, rho, H))
    return _run(_loops_of_tilt_of_planar_error, (error, offset, rho, H), out)


@_point_of(tilt_of_planar_error, spread=True)
def _point_of_tilt_of_planar_error(error, offset, rho, H):
    return _value_of_tilt_of_planar_error(
        _float64(error), _float64(offset), _float64(rho), _float64(H)
    )


_loops_of_tilt_of_planar_error = _Loops(
    ("error", "offset", "rho", "H"), _point_of_tilt_of_planar_error, _fill_of_tilt_of_planar_error
)


@_scalar
def _value_of_tilt_of_spatial_error(error, offset, rho, H):
    if not (
        (H > 0)
        & _is_finite(H)
        & (rho > 0)
        & _is_finite(rho)
        & (offset >= 0)
        & _is_finite(offset)
        & (error > 0)
        & _is_finite(error)
        & (offset <= error)
        & (
            (error + offset) * (error - offset)
            <= 2 * H**2 + 2 * rho**2 + 2 * offset * H + 2 * offset * rho
        )
    ):
        return _math.nan
    H_s_squared = H**2
    term = error + offset
    term_2 = error - offset
    return 2 * _elementary.arctan2(
        term * term_2,
        2 * offset * H
        + _np.sqrt(
            4 * H_s_squared * offset**2
            + term * term_2 * (4 * H_s_squared + 4 * rho**2 + 4 * offset * rho - term * term_2)
        ),
    )


@_loop
def _fill_of_tilt_of_spatial_error(_out, error, offset, rho, H):
    _fill(_value_of_tilt_of_spatial_error, _out, (error, offset, rho, H))


def tilt_of_spatial_error(
    error: ArrayLike,
    offset: ArrayLike,
    rho: ArrayLike,
    H: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute the tilt with which the largest error in space is the one wanted.

    Compiled. Its full documentation is that of
    `mechproof.kernels.track_wheel.tilt_of_spatial_error`.
    """
    if _type(offset) is _type(rho) is _type(H) is _float:
        if _type(error) is _ndarray and (_row := _take_row(error, out)) is not None:
            _loops_of_tilt_of_spatial_error.fill(_row, error, offset, rho, H)
            return _row
        if _type(error) is _float and out is None:
            return _float64(_loops_of_tilt_of_spatial_error.point(error, offset, rho, H))
    return _run(_loops_of_tilt_of_spatial_error, (error, offset, rho, H), out)


@_point_of(tilt_of_spatial_error, spread=True)
def _point_of_tilt_of_spatial_error(error, offset, rho, H):
    return _value_of_tilt_of_spatial_error(
        _float64(error), _float64(offset), _float64(rho), _float64(H)
    )


_loops_of_tilt_of_spatial_error = _Loops(
    ("error", "offset", "rho", "H"), _point_of_tilt_of_spatial_error, _fill_of_tilt_of_spatial_error
)
