"""Compiled kernels of the system `track_wheel`: one loop for each, by numba.

Names, arguments, domains, NaN and errors are those of `mechproof.kernels.track_wheel`,
and so are the formulas. Numbers and NumPy arrays are taken. With numbers,
kernels can be called inside functions that numba compiles; arguments with components are then
indexed, and so are results.

Tests hold them to the same accuracy bounds. What help says is proved of rounding errors
is proved of these kernels where it says `compiled`, and of the NumPy kernels elsewhere.

Elementary functions: `elementary` 4aa7b0fd5d8b.

Sums over axes are added in the order of the index, with the rest of every addition. Many
sets of terms are added beside each other, each to the bits that it has alone. Inside
functions that numba compiles they take one array of terms for each argument, or a number for
equal ones.

Generated from mechproof.derivations.track_wheel with SymPy 1.14.0.
Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""

from __future__ import annotations

import math as _math
from builtins import (
    abs as _abs,
    float as _float,
    len as _len,
    min as _min,
    range as _range,
    type as _type,
)
from typing import Any

import numpy as _np
from numpy import empty as _empty, float64 as _float64, ndarray as _ndarray
from numpy.typing import ArrayLike, NDArray

from mechproof.compiled_support import (
    BLOCK as _BLOCK,
    Loops as _Loops,
    Sums as _Sums,
    choose as _choose,
    count_sets as _count_sets,
    count_terms as _count_terms,
    floor as _floor,
    fma as _fma,
    has_nan as _has_nan,
    is_finite as _is_finite,
    loop as _loop,
    overload as _overload,
    own_row as _own_row,
    put_sets as _put_sets,
    run as _run,
    run_sums as _run_sums,
    scalar as _scalar,
    take_row as _take_row,
    take_square as _take_square,
    take_terms as _take_terms,
    widen as _widen,
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
    "track",
]


def __dir__() -> list[str]:
    return __all__


@_scalar
def _sum_1_term(
    sensitivities_i,
    scatters_i,
    tolerances_i,
    sensitivities_j,
    scatters_j,
    tolerances_j,
    correlation_ij,
):

    return (
        sensitivities_i
        * scatters_i
        * tolerances_i
        * (sensitivities_j * scatters_j * tolerances_j)
        * correlation_ij
    )


@_loop
def _sum_1(sensitivities, scatters, tolerances, correlation):
    _high, _low = 0.0, 0.0
    for _i in _range(_len(sensitivities)):
        for _j in _range(_len(sensitivities)):
            _term = _sum_1_term(
                _float64(sensitivities[_i]),
                _float64(scatters[_i]),
                _float64(tolerances[_i]),
                _float64(sensitivities[_j]),
                _float64(scatters[_j]),
                _float64(tolerances[_j]),
                _float64(correlation[_i, _j]),
            )
            _total = _high + _term
            _low += _elementary.total_rest(_high, _term, _total)
            _high = _total
    # A sum that leaves the range of doubles has no rest.
    return _choose(_is_finite(_low), _high + _low, _high)


@_loop
def _sum_1_sets(_out, sensitivities, scatters, tolerances, correlation):
    _widen()
    _high, _low = _own_row(), _own_row()
    for _s in _range(_len(_out)):
        _high[_s], _low[_s] = 0.0, 0.0
    for _i in _range(_len(sensitivities)):
        for _j in _range(_len(sensitivities)):
            for _s in _range(_len(_out)):
                _term = _sum_1_term(
                    sensitivities[_i, _s],
                    scatters[_i, _s],
                    tolerances[_i, _s],
                    sensitivities[_j, _s],
                    scatters[_j, _s],
                    tolerances[_j, _s],
                    correlation[_i, _j, _s],
                )
                _total = _high[_s] + _term
                _low[_s] += _elementary.total_rest(_high[_s], _term, _total)
                _high[_s] = _total
    for _s in _range(_len(_out)):
        _out[_s] = _choose(_is_finite(_low[_s]), _high[_s] + _low[_s], _high[_s])


@_scalar
def _sum_2_term(sensitivities_i, scatters_i, tolerances_i, correlation_ii):

    return _abs(sensitivities_i * scatters_i * tolerances_i) * _np.sqrt(_abs(correlation_ii))


@_loop
def _sum_2(sensitivities, scatters, tolerances, correlation):
    _high, _low = 0.0, 0.0
    for _i in _range(_len(sensitivities)):
        _term = _sum_2_term(
            _float64(sensitivities[_i]),
            _float64(scatters[_i]),
            _float64(tolerances[_i]),
            _float64(correlation[_i, _i]),
        )
        _total = _high + _term
        _low += _elementary.total_rest(_high, _term, _total)
        _high = _total
    # A sum that leaves the range of doubles has no rest.
    return _choose(_is_finite(_low), _high + _low, _high)


@_loop
def _sum_2_sets(_out, sensitivities, scatters, tolerances, correlation):
    _widen()
    _high, _low = _own_row(), _own_row()
    for _s in _range(_len(_out)):
        _high[_s], _low[_s] = 0.0, 0.0
    for _i in _range(_len(sensitivities)):
        for _s in _range(_len(_out)):
            _term = _sum_2_term(
                sensitivities[_i, _s], scatters[_i, _s], tolerances[_i, _s], correlation[_i, _i, _s]
            )
            _total = _high[_s] + _term
            _low[_s] += _elementary.total_rest(_high[_s], _term, _total)
            _high[_s] = _total
    for _s in _range(_len(_out)):
        _out[_s] = _choose(_is_finite(_low[_s]), _high[_s] + _low[_s], _high[_s])


@_scalar
def _every_3_term(scatters_i):

    return scatters_i > 0


@_loop
def _every_3(scatters):
    _holds = True
    for _i in _range(_len(scatters)):
        _holds = _holds & _every_3_term(_float64(scatters[_i]))
    return _holds


@_loop
def _every_3_sets(_out, scatters):
    _widen()
    _holds = _own_row()
    for _s in _range(_len(_out)):
        _holds[_s] = 1.0
    for _i in _range(_len(scatters)):
        for _s in _range(_len(_out)):
            _holds[_s] = _choose(_every_3_term(scatters[_i, _s]), _holds[_s], 0.0)
    for _s in _range(_len(_out)):
        _out[_s] = _holds[_s]


@_scalar
def _every_4_term(scatters_i):

    return _is_finite(scatters_i)


@_loop
def _every_4(scatters):
    _holds = True
    for _i in _range(_len(scatters)):
        _holds = _holds & _every_4_term(_float64(scatters[_i]))
    return _holds


@_loop
def _every_4_sets(_out, scatters):
    _widen()
    _holds = _own_row()
    for _s in _range(_len(_out)):
        _holds[_s] = 1.0
    for _i in _range(_len(scatters)):
        for _s in _range(_len(_out)):
            _holds[_s] = _choose(_every_4_term(scatters[_i, _s]), _holds[_s], 0.0)
    for _s in _range(_len(_out)):
        _out[_s] = _holds[_s]


@_scalar
def _every_5_term(correlation_ij):

    return correlation_ij >= -1


@_loop
def _every_5(correlation):
    _holds = True
    for _i in _range(_len(correlation)):
        for _j in _range(_len(correlation)):
            _holds = _holds & _every_5_term(_float64(correlation[_i, _j]))
    return _holds


@_loop
def _every_5_sets(_out, correlation):
    _widen()
    _holds = _own_row()
    for _s in _range(_len(_out)):
        _holds[_s] = 1.0
    for _i in _range(_len(correlation)):
        for _j in _range(_len(correlation)):
            for _s in _range(_len(_out)):
                _holds[_s] = _choose(_every_5_term(correlation[_i, _j, _s]), _holds[_s], 0.0)
    for _s in _range(_len(_out)):
        _out[_s] = _holds[_s]


@_scalar
def _every_6_term(correlation_ij):

    return correlation_ij <= 1


@_loop
def _every_6(correlation):
    _holds = True
    for _i in _range(_len(correlation)):
        for _j in _range(_len(correlation)):
            _holds = _holds & _every_6_term(_float64(correlation[_i, _j]))
    return _holds


@_loop
def _every_6_sets(_out, correlation):
    _widen()
    _holds = _own_row()
    for _s in _range(_len(_out)):
        _holds[_s] = 1.0
    for _i in _range(_len(correlation)):
        for _j in _range(_len(correlation)):
            for _s in _range(_len(_out)):
                _holds[_s] = _choose(_every_6_term(correlation[_i, _j, _s]), _holds[_s], 0.0)
    for _s in _range(_len(_out)):
        _out[_s] = _holds[_s]


@_scalar
def _every_7_term(correlation_ii):

    return correlation_ii == 1


@_loop
def _every_7(correlation):
    _holds = True
    for _i in _range(_len(correlation)):
        _holds = _holds & _every_7_term(_float64(correlation[_i, _i]))
    return _holds


@_loop
def _every_7_sets(_out, correlation):
    _widen()
    _holds = _own_row()
    for _s in _range(_len(_out)):
        _holds[_s] = 1.0
    for _i in _range(_len(correlation)):
        for _s in _range(_len(_out)):
            _holds[_s] = _choose(_every_7_term(correlation[_i, _i, _s]), _holds[_s], 0.0)
    for _s in _range(_len(_out)):
        _out[_s] = _holds[_s]


@_scalar
def _every_8_term(correlation_ij, correlation_ji):

    return correlation_ij == correlation_ji


@_loop
def _every_8(correlation):
    _holds = True
    for _i in _range(_len(correlation)):
        for _j in _range(_len(correlation)):
            _holds = _holds & _every_8_term(
                _float64(correlation[_i, _j]), _float64(correlation[_j, _i])
            )
    return _holds


@_loop
def _every_8_sets(_out, correlation):
    _widen()
    _holds = _own_row()
    for _s in _range(_len(_out)):
        _holds[_s] = 1.0
    for _i in _range(_len(correlation)):
        for _j in _range(_len(correlation)):
            for _s in _range(_len(_out)):
                _holds[_s] = _choose(
                    _every_8_term(correlation[_i, _j, _s], correlation[_j, _i, _s]), _holds[_s], 0.0
                )
    for _s in _range(_len(_out)):
        _out[_s] = _holds[_s]


@_scalar
def _every_9_term(tolerances_i):

    return tolerances_i >= 0


@_loop
def _every_9(tolerances):
    _holds = True
    for _i in _range(_len(tolerances)):
        _holds = _holds & _every_9_term(_float64(tolerances[_i]))
    return _holds


@_loop
def _every_9_sets(_out, tolerances):
    _widen()
    _holds = _own_row()
    for _s in _range(_len(_out)):
        _holds[_s] = 1.0
    for _i in _range(_len(tolerances)):
        for _s in _range(_len(_out)):
            _holds[_s] = _choose(_every_9_term(tolerances[_i, _s]), _holds[_s], 0.0)
    for _s in _range(_len(_out)):
        _out[_s] = _holds[_s]


@_scalar
def _every_10_term(tolerances_i):

    return _is_finite(tolerances_i)


@_loop
def _every_10(tolerances):
    _holds = True
    for _i in _range(_len(tolerances)):
        _holds = _holds & _every_10_term(_float64(tolerances[_i]))
    return _holds


@_loop
def _every_10_sets(_out, tolerances):
    _widen()
    _holds = _own_row()
    for _s in _range(_len(_out)):
        _holds[_s] = 1.0
    for _i in _range(_len(tolerances)):
        for _s in _range(_len(_out)):
            _holds[_s] = _choose(_every_10_term(tolerances[_i, _s]), _holds[_s], 0.0)
    for _s in _range(_len(_out)):
        _out[_s] = _holds[_s]


@_scalar
def _sum_11_term(sensitivities_i, scatters_i, tolerances_i):

    return (sensitivities_i * scatters_i * tolerances_i) ** 2


@_loop
def _sum_11(sensitivities, scatters, tolerances):
    _high, _low = 0.0, 0.0
    for _i in _range(_len(sensitivities)):
        _term = _sum_11_term(
            _float64(sensitivities[_i]), _float64(scatters[_i]), _float64(tolerances[_i])
        )
        _total = _high + _term
        _low += _elementary.total_rest(_high, _term, _total)
        _high = _total
    # A sum that leaves the range of doubles has no rest.
    return _choose(_is_finite(_low), _high + _low, _high)


@_loop
def _sum_11_sets(_out, sensitivities, scatters, tolerances):
    _widen()
    _high, _low = _own_row(), _own_row()
    for _s in _range(_len(_out)):
        _high[_s], _low[_s] = 0.0, 0.0
    for _i in _range(_len(sensitivities)):
        for _s in _range(_len(_out)):
            _term = _sum_11_term(sensitivities[_i, _s], scatters[_i, _s], tolerances[_i, _s])
            _total = _high[_s] + _term
            _low[_s] += _elementary.total_rest(_high[_s], _term, _total)
            _high[_s] = _total
    for _s in _range(_len(_out)):
        _out[_s] = _choose(_is_finite(_low[_s]), _high[_s] + _low[_s], _high[_s])


@_scalar
def _prepare_of_rotation(beta, gamma, _exact):
    cos_beta = _elementary.cos(beta, _exact)
    cos_gamma = _elementary.cos(gamma, _exact)
    sin_gamma = _elementary.sin(gamma, _exact)
    sin_beta = _elementary.sin(beta, _exact)

    return (cos_beta, cos_gamma, sin_gamma, sin_beta)


@_scalar
def _form_of_rotation(alpha, cos_beta, cos_gamma, sin_gamma, sin_beta, _exact):
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


@_scalar
def _value_of_rotation(alpha, beta, gamma, _exact):
    _prepared = _prepare_of_rotation(beta, gamma, _exact)
    return _form_of_rotation(alpha, *_prepared, _exact)


@_scalar
def _point_of_rotation(alpha, beta, gamma):
    return _value_of_rotation(alpha, beta, gamma, True)


@_loop
def _row_of_rotation(_out, _values_of_alpha, beta, gamma, _exact):
    _widen()
    for _i in _range(_out.size // 9):
        alpha = _float64(_values_of_alpha[_i])

        _value = _value_of_rotation(alpha, beta, gamma, _exact)
        _out[9 * _i + 0] = _value[0]
        _out[9 * _i + 1] = _value[1]
        _out[9 * _i + 2] = _value[2]
        _out[9 * _i + 3] = _value[3]
        _out[9 * _i + 4] = _value[4]
        _out[9 * _i + 5] = _value[5]
        _out[9 * _i + 6] = _value[6]
        _out[9 * _i + 7] = _value[7]
        _out[9 * _i + 8] = _value[8]


@_loop
def _fill_of_rotation(
    _out,
    _values_of_alpha,
    beta,
    gamma,
):
    for _start in _range(0, _out.size // 9, _BLOCK):
        _stop = _start + _BLOCK
        _out_block = _out[9 * _start : 9 * _stop]
        _block_of_alpha = _values_of_alpha[_start:_stop]
        _row_of_rotation(_out_block, _block_of_alpha, beta, gamma, None)
        if _has_nan(_out_block):
            _row_of_rotation(_out_block, _block_of_alpha, beta, gamma, True)


@_loop
def _row_each_of_rotation(_out, _values_of_alpha, _values_of_beta, _values_of_gamma, _exact):
    _widen()
    for _i in _range(_out.size // 9):
        alpha = _float64(_values_of_alpha[_i])

        beta = _float64(_values_of_beta[_i])

        gamma = _float64(_values_of_gamma[_i])

        _value = _value_of_rotation(alpha, beta, gamma, _exact)
        _out[9 * _i + 0] = _value[0]
        _out[9 * _i + 1] = _value[1]
        _out[9 * _i + 2] = _value[2]
        _out[9 * _i + 3] = _value[3]
        _out[9 * _i + 4] = _value[4]
        _out[9 * _i + 5] = _value[5]
        _out[9 * _i + 6] = _value[6]
        _out[9 * _i + 7] = _value[7]
        _out[9 * _i + 8] = _value[8]


@_loop
def _fill_each_of_rotation(
    _out,
    _values_of_alpha,
    _values_of_beta,
    _values_of_gamma,
):
    for _start in _range(0, _out.size // 9, _BLOCK):
        _stop = _start + _BLOCK
        _out_block = _out[9 * _start : 9 * _stop]
        _block_of_alpha = _values_of_alpha[_start:_stop]
        _block_of_beta = _values_of_beta[_start:_stop]
        _block_of_gamma = _values_of_gamma[_start:_stop]
        _row_each_of_rotation(_out_block, _block_of_alpha, _block_of_beta, _block_of_gamma, None)
        if _has_nan(_out_block):
            _row_each_of_rotation(
                _out_block, _block_of_alpha, _block_of_beta, _block_of_gamma, True
            )


def rotation(
    alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the matrix K of the turns alpha, beta, gamma: coordinates in the part's frame.

    Compiled. The help of `mechproof.kernels.track_wheel.rotation` has all words.
    """
    return _run(
        _loops_of_rotation,
        (
            alpha,
            beta,
            gamma,
        ),
        out,
    )


_loops_of_rotation = _Loops(
    names=(
        "alpha",
        "beta",
        "gamma",
    ),
    widths=(
        0,
        0,
        0,
    ),
    shape=(
        3,
        3,
    ),
    at=_point_of_rotation,
    uniform=_fill_of_rotation,
    each=_fill_each_of_rotation,
)


@_overload(rotation)
def _offer_of_rotation(
    alpha,
    beta,
    gamma,
):
    return lambda alpha, beta, gamma: _point_of_rotation(
        _float64(alpha),
        _float64(beta),
        _float64(gamma),
    )


@_scalar
def _prepare_of_displacement(angles_0, angles_1, angles_2, shift_0, shift_1, shift_2, _exact):
    t_alpha_angle = angles_0 / 2
    t_alpha_below = _elementary.tangent_below(t_alpha_angle, _exact)
    t_alpha = _elementary.tangent_above(t_alpha_angle, _exact)
    t_beta_angle = angles_1 / 2
    t_beta_below = _elementary.tangent_below(t_beta_angle, _exact)
    t_beta = _elementary.tangent_above(t_beta_angle, _exact)
    t_gamma_angle = angles_2 / 2
    t_gamma_below = _elementary.tangent_below(t_gamma_angle, _exact)
    t_gamma = _elementary.tangent_above(t_gamma_angle, _exact)
    scale = 2 / (
        (t_alpha_below * t_alpha_below + t_alpha**2)
        * (t_beta_below * t_beta_below + t_beta**2)
        * (t_gamma_below * t_gamma_below + t_gamma**2)
    )
    v_y = t_beta * t_alpha_below * t_gamma_below - t_alpha * t_gamma * t_beta_below
    v_y_squared = v_y**2
    v_z = t_gamma * t_alpha_below * t_beta_below + t_alpha * t_beta * t_gamma_below
    v_z_squared = v_z**2
    C11 = scale * (-v_y_squared - v_z_squared)
    v_x = t_alpha * t_beta_below * t_gamma_below + t_beta * t_gamma * t_alpha_below
    v_x_v_y = v_x * v_y
    w = t_alpha_below * t_beta_below * t_gamma_below - t_alpha * t_beta * t_gamma
    C12 = scale * (v_x_v_y - v_z * w)
    v_x_v_z = v_x * v_z
    C13 = scale * (v_x_v_z + v_y * w)
    C21 = scale * (v_x_v_y + v_z * w)
    v_x_squared = v_x**2
    C22 = scale * (-v_x_squared - v_z_squared)
    v_y_v_z = v_y * v_z
    C23 = scale * (v_y_v_z - v_x * w)
    C31 = scale * (v_x_v_z - v_y * w)
    C32 = scale * (v_y_v_z + v_x * w)
    C33 = scale * (-v_x_squared - v_y_squared)

    return (C11, C12, C13, C21, C22, C23, C31, C32, C33, shift_0, shift_1, shift_2)


@_scalar
def _form_of_displacement(
    points_0, points_1, points_2, m00, m01, m02, m10, m11, m12, m20, m21, m22, v0, v1, v2, _exact
):

    return (
        _fma(m00, points_0, _fma(m01, points_1, _fma(m02, points_2, v0))),
        _fma(m10, points_0, _fma(m11, points_1, _fma(m12, points_2, v1))),
        _fma(m20, points_0, _fma(m21, points_1, _fma(m22, points_2, v2))),
    )


@_scalar
def _value_of_displacement(
    points_0, points_1, points_2, angles_0, angles_1, angles_2, shift_0, shift_1, shift_2, _exact
):
    _prepared = _prepare_of_displacement(
        angles_0, angles_1, angles_2, shift_0, shift_1, shift_2, _exact
    )
    return _form_of_displacement(points_0, points_1, points_2, *_prepared, _exact)


@_scalar
def _point_of_displacement(
    points_0, points_1, points_2, angles_0, angles_1, angles_2, shift_0, shift_1, shift_2
):
    return _value_of_displacement(
        points_0, points_1, points_2, angles_0, angles_1, angles_2, shift_0, shift_1, shift_2, True
    )


@_loop
def _row_of_displacement(
    _out, _values_of_points, angles_0, angles_1, angles_2, shift_0, shift_1, shift_2, _exact
):
    _widen()
    for _i in _range(_out.size // 3):
        points_0 = _float64(_values_of_points[3 * _i + 0])
        points_1 = _float64(_values_of_points[3 * _i + 1])
        points_2 = _float64(_values_of_points[3 * _i + 2])

        _value = _value_of_displacement(
            points_0,
            points_1,
            points_2,
            angles_0,
            angles_1,
            angles_2,
            shift_0,
            shift_1,
            shift_2,
            _exact,
        )
        _out[3 * _i + 0] = _value[0]
        _out[3 * _i + 1] = _value[1]
        _out[3 * _i + 2] = _value[2]


@_loop
def _fill_of_displacement(
    _out,
    _values_of_points,
    angles_0,
    angles_1,
    angles_2,
    shift_0,
    shift_1,
    shift_2,
):
    for _start in _range(0, _out.size // 3, _BLOCK):
        _stop = _start + _BLOCK
        _out_block = _out[3 * _start : 3 * _stop]
        _block_of_points = _values_of_points[3 * _start : 3 * _stop]
        _row_of_displacement(
            _out_block,
            _block_of_points,
            angles_0,
            angles_1,
            angles_2,
            shift_0,
            shift_1,
            shift_2,
            None,
        )
        if _has_nan(_out_block):
            _row_of_displacement(
                _out_block,
                _block_of_points,
                angles_0,
                angles_1,
                angles_2,
                shift_0,
                shift_1,
                shift_2,
                True,
            )


@_loop
def _row_each_of_displacement(_out, _values_of_points, _values_of_angles, _values_of_shift, _exact):
    _widen()
    for _i in _range(_out.size // 3):
        points_0 = _float64(_values_of_points[3 * _i + 0])
        points_1 = _float64(_values_of_points[3 * _i + 1])
        points_2 = _float64(_values_of_points[3 * _i + 2])

        angles_0 = _float64(_values_of_angles[3 * _i + 0])
        angles_1 = _float64(_values_of_angles[3 * _i + 1])
        angles_2 = _float64(_values_of_angles[3 * _i + 2])

        shift_0 = _float64(_values_of_shift[3 * _i + 0])
        shift_1 = _float64(_values_of_shift[3 * _i + 1])
        shift_2 = _float64(_values_of_shift[3 * _i + 2])

        _value = _value_of_displacement(
            points_0,
            points_1,
            points_2,
            angles_0,
            angles_1,
            angles_2,
            shift_0,
            shift_1,
            shift_2,
            _exact,
        )
        _out[3 * _i + 0] = _value[0]
        _out[3 * _i + 1] = _value[1]
        _out[3 * _i + 2] = _value[2]


@_loop
def _fill_each_of_displacement(
    _out,
    _values_of_points,
    _values_of_angles,
    _values_of_shift,
):
    for _start in _range(0, _out.size // 3, _BLOCK):
        _stop = _start + _BLOCK
        _out_block = _out[3 * _start : 3 * _stop]
        _block_of_points = _values_of_points[3 * _start : 3 * _stop]
        _block_of_angles = _values_of_angles[3 * _start : 3 * _stop]
        _block_of_shift = _values_of_shift[3 * _start : 3 * _stop]
        _row_each_of_displacement(
            _out_block, _block_of_points, _block_of_angles, _block_of_shift, None
        )
        if _has_nan(_out_block):
            _row_each_of_displacement(
                _out_block, _block_of_points, _block_of_angles, _block_of_shift, True
            )


def displacement(
    points: ArrayLike, angles: ArrayLike, shift: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the position errors K^T*p - (p - t) of points p, turn K and shift t.

    Compiled. The help of `mechproof.kernels.track_wheel.displacement` has all words.
    """
    return _run(
        _loops_of_displacement,
        (
            points,
            angles,
            shift,
        ),
        out,
    )


_loops_of_displacement = _Loops(
    names=(
        "points",
        "angles",
        "shift",
    ),
    widths=(
        3,
        3,
        3,
    ),
    shape=(3,),
    at=_point_of_displacement,
    uniform=_fill_of_displacement,
    each=_fill_each_of_displacement,
)


@_overload(displacement)
def _offer_of_displacement(
    points,
    angles,
    shift,
):
    return lambda points, angles, shift: _point_of_displacement(
        _float64(points[0]),
        _float64(points[1]),
        _float64(points[2]),
        _float64(angles[0]),
        _float64(angles[1]),
        _float64(angles[2]),
        _float64(shift[0]),
        _float64(shift[1]),
        _float64(shift[2]),
    )


@_scalar
def _form_of_planar_error(displacement_0, displacement_1):

    return _elementary.hypot(displacement_0, displacement_1)


@_scalar
def _value_of_planar_error(displacement_0, displacement_1):
    return _form_of_planar_error(displacement_0, displacement_1)


@_scalar
def _point_of_planar_error(displacement_0, displacement_1, displacement_2):
    return _value_of_planar_error(displacement_0, displacement_1)


@_loop
def _row_of_planar_error(
    _out,
    _values_of_displacement,
):
    _widen()
    for _i in _range(_out.size):
        displacement_0 = _float64(_values_of_displacement[3 * _i + 0])
        displacement_1 = _float64(_values_of_displacement[3 * _i + 1])

        _value = _value_of_planar_error(displacement_0, displacement_1)
        _out[_i] = _value


@_loop
def _fill_of_planar_error(
    _out,
    _values_of_displacement,
):
    _row_of_planar_error(
        _out,
        _values_of_displacement,
    )


@_loop
def _row_each_of_planar_error(
    _out,
    _values_of_displacement,
):
    _widen()
    for _i in _range(_out.size):
        displacement_0 = _float64(_values_of_displacement[3 * _i + 0])
        displacement_1 = _float64(_values_of_displacement[3 * _i + 1])

        _value = _value_of_planar_error(displacement_0, displacement_1)
        _out[_i] = _value


@_loop
def _fill_each_of_planar_error(
    _out,
    _values_of_displacement,
):
    _row_each_of_planar_error(
        _out,
        _values_of_displacement,
    )


def planar_error(displacement: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the error in the end plane X0Y0.

    Compiled. The help of `mechproof.kernels.track_wheel.planar_error` has all words.
    """
    return _run(_loops_of_planar_error, (displacement,), out)


_loops_of_planar_error = _Loops(
    names=("displacement",),
    widths=(3,),
    shape=(),
    at=_point_of_planar_error,
    uniform=_fill_of_planar_error,
    each=_fill_each_of_planar_error,
)


@_overload(planar_error)
def _offer_of_planar_error(
    displacement,
):
    return lambda displacement: _point_of_planar_error(
        _float64(displacement[0]),
        _float64(displacement[1]),
        _float64(displacement[2]),
    )


@_scalar
def _form_of_spatial_error(displacement_0, displacement_1, displacement_2):

    return _elementary.hypot(_elementary.hypot(displacement_0, displacement_1), displacement_2)


@_scalar
def _value_of_spatial_error(displacement_0, displacement_1, displacement_2):
    return _form_of_spatial_error(displacement_0, displacement_1, displacement_2)


@_scalar
def _point_of_spatial_error(displacement_0, displacement_1, displacement_2):
    return _value_of_spatial_error(displacement_0, displacement_1, displacement_2)


@_loop
def _row_of_spatial_error(
    _out,
    _values_of_displacement,
):
    _widen()
    for _i in _range(_out.size):
        displacement_0 = _float64(_values_of_displacement[3 * _i + 0])
        displacement_1 = _float64(_values_of_displacement[3 * _i + 1])
        displacement_2 = _float64(_values_of_displacement[3 * _i + 2])

        _value = _value_of_spatial_error(displacement_0, displacement_1, displacement_2)
        _out[_i] = _value


@_loop
def _fill_of_spatial_error(
    _out,
    _values_of_displacement,
):
    _row_of_spatial_error(
        _out,
        _values_of_displacement,
    )


@_loop
def _row_each_of_spatial_error(
    _out,
    _values_of_displacement,
):
    _widen()
    for _i in _range(_out.size):
        displacement_0 = _float64(_values_of_displacement[3 * _i + 0])
        displacement_1 = _float64(_values_of_displacement[3 * _i + 1])
        displacement_2 = _float64(_values_of_displacement[3 * _i + 2])

        _value = _value_of_spatial_error(displacement_0, displacement_1, displacement_2)
        _out[_i] = _value


@_loop
def _fill_each_of_spatial_error(
    _out,
    _values_of_displacement,
):
    _row_each_of_spatial_error(
        _out,
        _values_of_displacement,
    )


def spatial_error(displacement: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the error in space.

    Compiled. The help of `mechproof.kernels.track_wheel.spatial_error` has all words.
    """
    return _run(_loops_of_spatial_error, (displacement,), out)


_loops_of_spatial_error = _Loops(
    names=("displacement",),
    widths=(3,),
    shape=(),
    at=_point_of_spatial_error,
    uniform=_fill_of_spatial_error,
    each=_fill_each_of_spatial_error,
)


@_overload(spatial_error)
def _offer_of_spatial_error(
    displacement,
):
    return lambda displacement: _point_of_spatial_error(
        _float64(displacement[0]),
        _float64(displacement[1]),
        _float64(displacement[2]),
    )


@_scalar
def _prepare_of_radius(R, A, z, _exact):
    A_plus_R = A + R
    R_minus_A = R - A
    w = A_plus_R * R_minus_A

    return (A, z, w)


@_scalar
def _form_of_radius(phi, A, z, w, _exact):
    u = A * _elementary.cos(z * phi, _exact)
    q = _abs(u) + _elementary.hypot(_np.sqrt(w), u)

    return _choose(u >= 0, q, w / q)


@_scalar
def _value_of_radius(phi, R, A, z, _exact):
    if not ((R > 0) & _is_finite(R) & (z >= 1) & _is_finite(z) & (z == _floor(z)) & (_abs(A) <= R)):
        return _math.nan
    _prepared = _prepare_of_radius(R, A, z, _exact)
    return _form_of_radius(phi, *_prepared, _exact)


@_scalar
def _point_of_radius(phi, R, A, z):
    return _value_of_radius(phi, R, A, z, True)


@_loop
def _row_of_radius(_out, _values_of_phi, R, A, z, _exact):
    _widen()
    for _i in _range(_out.size):
        phi = _float64(_values_of_phi[_i])

        _value = _value_of_radius(phi, R, A, z, _exact)
        _out[_i] = _value


@_loop
def _fill_of_radius(
    _out,
    _values_of_phi,
    R,
    A,
    z,
):
    for _start in _range(0, _out.size, _BLOCK):
        _stop = _start + _BLOCK
        _out_block = _out[_start:_stop]
        _block_of_phi = _values_of_phi[_start:_stop]
        _row_of_radius(_out_block, _block_of_phi, R, A, z, None)
        if _has_nan(_out_block):
            _row_of_radius(_out_block, _block_of_phi, R, A, z, True)


@_loop
def _row_each_of_radius(_out, _values_of_phi, _values_of_R, _values_of_A, _values_of_z, _exact):
    _widen()
    for _i in _range(_out.size):
        phi = _float64(_values_of_phi[_i])

        R = _float64(_values_of_R[_i])

        A = _float64(_values_of_A[_i])

        z = _float64(_values_of_z[_i])

        _value = _value_of_radius(phi, R, A, z, _exact)
        _out[_i] = _value


@_loop
def _fill_each_of_radius(
    _out,
    _values_of_phi,
    _values_of_R,
    _values_of_A,
    _values_of_z,
):
    for _start in _range(0, _out.size, _BLOCK):
        _stop = _start + _BLOCK
        _out_block = _out[_start:_stop]
        _block_of_phi = _values_of_phi[_start:_stop]
        _block_of_R = _values_of_R[_start:_stop]
        _block_of_A = _values_of_A[_start:_stop]
        _block_of_z = _values_of_z[_start:_stop]
        _row_each_of_radius(_out_block, _block_of_phi, _block_of_R, _block_of_A, _block_of_z, None)
        if _has_nan(_out_block):
            _row_each_of_radius(
                _out_block, _block_of_phi, _block_of_R, _block_of_A, _block_of_z, True
            )


def radius(
    phi: ArrayLike, R: ArrayLike, A: ArrayLike, z: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the radius vector of the track, a shifted circle repeated z times.

    Compiled. The help of `mechproof.kernels.track_wheel.radius` has all words.
    """
    if _type(R) is _type(A) is _type(z) is _float:
        if _type(phi) is _ndarray:
            _row = _take_row(phi, out)
            if _row is not None:
                _loops_of_radius.fill(_row, phi, R, A, z)
                return _row
        elif _type(phi) is _float and out is None:
            return _float64(_loops_of_radius.point(phi, R, A, z))
    return _run(
        _loops_of_radius,
        (
            phi,
            R,
            A,
            z,
        ),
        out,
    )


_loops_of_radius = _Loops(
    names=(
        "phi",
        "R",
        "A",
        "z",
    ),
    widths=(
        0,
        0,
        0,
        0,
    ),
    shape=(),
    at=_point_of_radius,
    uniform=_fill_of_radius,
    each=_fill_each_of_radius,
)


@_overload(radius)
def _offer_of_radius(
    phi,
    R,
    A,
    z,
):
    return lambda phi, R, A, z: _point_of_radius(
        _float64(phi),
        _float64(R),
        _float64(A),
        _float64(z),
    )


@_scalar
def _prepare_of_track(R, A, z, H, _exact):
    A_plus_R = A + R
    R_minus_A = R - A
    w = A_plus_R * R_minus_A

    return (A, z, H, w)


@_scalar
def _form_of_track(phi, A, z, H, w, _exact):
    u = A * _elementary.cos(z * phi, _exact)
    q = _abs(u) + _elementary.hypot(_np.sqrt(w), u)
    term = _choose(u >= 0, q, w / q)

    return (
        term * _elementary.cos(phi, _exact),
        term * _elementary.sin(phi, _exact),
        H,
    )


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
    _prepared = _prepare_of_track(R, A, z, H, _exact)
    return _form_of_track(phi, *_prepared, _exact)


@_scalar
def _point_of_track(phi, R, A, z, H):
    return _value_of_track(phi, R, A, z, H, True)


@_loop
def _row_of_track(_out, _values_of_phi, R, A, z, H, _exact):
    _widen()
    for _i in _range(_out.size // 3):
        phi = _float64(_values_of_phi[_i])

        _value = _value_of_track(phi, R, A, z, H, _exact)
        _out[3 * _i + 0] = _value[0]
        _out[3 * _i + 1] = _value[1]
        _out[3 * _i + 2] = _value[2]


@_loop
def _fill_of_track(
    _out,
    _values_of_phi,
    R,
    A,
    z,
    H,
):
    for _start in _range(0, _out.size // 3, _BLOCK):
        _stop = _start + _BLOCK
        _out_block = _out[3 * _start : 3 * _stop]
        _block_of_phi = _values_of_phi[_start:_stop]
        _row_of_track(_out_block, _block_of_phi, R, A, z, H, None)
        if _has_nan(_out_block):
            _row_of_track(_out_block, _block_of_phi, R, A, z, H, True)


@_loop
def _row_each_of_track(
    _out, _values_of_phi, _values_of_R, _values_of_A, _values_of_z, _values_of_H, _exact
):
    _widen()
    for _i in _range(_out.size // 3):
        phi = _float64(_values_of_phi[_i])

        R = _float64(_values_of_R[_i])

        A = _float64(_values_of_A[_i])

        z = _float64(_values_of_z[_i])

        H = _float64(_values_of_H[_i])

        _value = _value_of_track(phi, R, A, z, H, _exact)
        _out[3 * _i + 0] = _value[0]
        _out[3 * _i + 1] = _value[1]
        _out[3 * _i + 2] = _value[2]


@_loop
def _fill_each_of_track(
    _out,
    _values_of_phi,
    _values_of_R,
    _values_of_A,
    _values_of_z,
    _values_of_H,
):
    for _start in _range(0, _out.size // 3, _BLOCK):
        _stop = _start + _BLOCK
        _out_block = _out[3 * _start : 3 * _stop]
        _block_of_phi = _values_of_phi[_start:_stop]
        _block_of_R = _values_of_R[_start:_stop]
        _block_of_A = _values_of_A[_start:_stop]
        _block_of_z = _values_of_z[_start:_stop]
        _block_of_H = _values_of_H[_start:_stop]
        _row_each_of_track(
            _out_block, _block_of_phi, _block_of_R, _block_of_A, _block_of_z, _block_of_H, None
        )
        if _has_nan(_out_block):
            _row_each_of_track(
                _out_block, _block_of_phi, _block_of_R, _block_of_A, _block_of_z, _block_of_H, True
            )


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

    Compiled. The help of `mechproof.kernels.track_wheel.track` has all words.
    """
    return _run(
        _loops_of_track,
        (
            phi,
            R,
            A,
            z,
            H,
        ),
        out,
    )


_loops_of_track = _Loops(
    names=(
        "phi",
        "R",
        "A",
        "z",
        "H",
    ),
    widths=(
        0,
        0,
        0,
        0,
        0,
    ),
    shape=(3,),
    at=_point_of_track,
    uniform=_fill_of_track,
    each=_fill_each_of_track,
)


@_overload(track)
def _offer_of_track(
    phi,
    R,
    A,
    z,
    H,
):
    return lambda phi, R, A, z, H: _point_of_track(
        _float64(phi),
        _float64(R),
        _float64(A),
        _float64(z),
        _float64(H),
    )


@_scalar
def _prepare_of_largest_radius(A):

    return (A,)


@_scalar
def _form_of_largest_radius(R, A):

    return R + _abs(A)


@_scalar
def _value_of_largest_radius(R, A):
    if not ((R > 0) & _is_finite(R) & (_abs(A) <= R)):
        return _math.nan
    _prepared = _prepare_of_largest_radius(A)
    return _form_of_largest_radius(R, *_prepared)


@_scalar
def _point_of_largest_radius(R, A):
    return _value_of_largest_radius(R, A)


@_loop
def _row_of_largest_radius(
    _out,
    _values_of_R,
    A,
):
    _widen()
    for _i in _range(_out.size):
        R = _float64(_values_of_R[_i])

        _value = _value_of_largest_radius(R, A)
        _out[_i] = _value


@_loop
def _fill_of_largest_radius(
    _out,
    _values_of_R,
    A,
):
    _row_of_largest_radius(
        _out,
        _values_of_R,
        A,
    )


@_loop
def _row_each_of_largest_radius(
    _out,
    _values_of_R,
    _values_of_A,
):
    _widen()
    for _i in _range(_out.size):
        R = _float64(_values_of_R[_i])

        A = _float64(_values_of_A[_i])

        _value = _value_of_largest_radius(R, A)
        _out[_i] = _value


@_loop
def _fill_each_of_largest_radius(
    _out,
    _values_of_R,
    _values_of_A,
):
    _row_each_of_largest_radius(
        _out,
        _values_of_R,
        _values_of_A,
    )


def largest_radius(R: ArrayLike, A: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the largest radius vector of the track.

    Compiled. The help of `mechproof.kernels.track_wheel.largest_radius` has all words.
    """
    if _type(A) is _float:
        if _type(R) is _ndarray:
            _row = _take_row(R, out)
            if _row is not None:
                _loops_of_largest_radius.fill(_row, R, A)
                return _row
        elif _type(R) is _float and out is None:
            return _float64(_loops_of_largest_radius.point(R, A))
    return _run(
        _loops_of_largest_radius,
        (
            R,
            A,
        ),
        out,
    )


_loops_of_largest_radius = _Loops(
    names=(
        "R",
        "A",
    ),
    widths=(
        0,
        0,
    ),
    shape=(),
    at=_point_of_largest_radius,
    uniform=_fill_of_largest_radius,
    each=_fill_each_of_largest_radius,
)


@_overload(largest_radius)
def _offer_of_largest_radius(
    R,
    A,
):
    return lambda R, A: _point_of_largest_radius(
        _float64(R),
        _float64(A),
    )


@_scalar
def _prepare_of_smallest_radius(A):

    return (A,)


@_scalar
def _form_of_smallest_radius(R, A):

    return R - _abs(A)


@_scalar
def _value_of_smallest_radius(R, A):
    if not ((R > 0) & _is_finite(R) & (_abs(A) <= R)):
        return _math.nan
    _prepared = _prepare_of_smallest_radius(A)
    return _form_of_smallest_radius(R, *_prepared)


@_scalar
def _point_of_smallest_radius(R, A):
    return _value_of_smallest_radius(R, A)


@_loop
def _row_of_smallest_radius(
    _out,
    _values_of_R,
    A,
):
    _widen()
    for _i in _range(_out.size):
        R = _float64(_values_of_R[_i])

        _value = _value_of_smallest_radius(R, A)
        _out[_i] = _value


@_loop
def _fill_of_smallest_radius(
    _out,
    _values_of_R,
    A,
):
    _row_of_smallest_radius(
        _out,
        _values_of_R,
        A,
    )


@_loop
def _row_each_of_smallest_radius(
    _out,
    _values_of_R,
    _values_of_A,
):
    _widen()
    for _i in _range(_out.size):
        R = _float64(_values_of_R[_i])

        A = _float64(_values_of_A[_i])

        _value = _value_of_smallest_radius(R, A)
        _out[_i] = _value


@_loop
def _fill_each_of_smallest_radius(
    _out,
    _values_of_R,
    _values_of_A,
):
    _row_each_of_smallest_radius(
        _out,
        _values_of_R,
        _values_of_A,
    )


def smallest_radius(R: ArrayLike, A: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the smallest radius vector of the track.

    Compiled. The help of `mechproof.kernels.track_wheel.smallest_radius` has all words.
    """
    if _type(A) is _float:
        if _type(R) is _ndarray:
            _row = _take_row(R, out)
            if _row is not None:
                _loops_of_smallest_radius.fill(_row, R, A)
                return _row
        elif _type(R) is _float and out is None:
            return _float64(_loops_of_smallest_radius.point(R, A))
    return _run(
        _loops_of_smallest_radius,
        (
            R,
            A,
        ),
        out,
    )


_loops_of_smallest_radius = _Loops(
    names=(
        "R",
        "A",
    ),
    widths=(
        0,
        0,
    ),
    shape=(),
    at=_point_of_smallest_radius,
    uniform=_fill_of_smallest_radius,
    each=_fill_each_of_smallest_radius,
)


@_overload(smallest_radius)
def _offer_of_smallest_radius(
    R,
    A,
):
    return lambda R, A: _point_of_smallest_radius(
        _float64(R),
        _float64(A),
    )


@_scalar
def _form_of_error_sum_correlated(total_scatter, sum_1, sum_2):

    return _np.sqrt(_elementary.nonnegative(sum_1, sum_2**2)) / total_scatter


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
    return _form_of_error_sum_correlated(total_scatter, sum_1, sum_2)


@_scalar
def _point_of_error_sum_correlated(tolerances, sensitivities, scatters, correlation, total_scatter):
    return _value_of_error_sum_correlated(
        total_scatter,
        _every_3(scatters),
        _every_4(scatters),
        _every_5(correlation),
        _every_6(correlation),
        _every_7(correlation),
        _every_8(correlation),
        _every_9(tolerances),
        _every_10(tolerances),
        _sum_1(sensitivities, scatters, tolerances, correlation),
        _sum_2(sensitivities, scatters, tolerances, correlation),
    )


@_loop
def _fill_each_of_error_sum_correlated(
    _out,
    _terms,
    _values_of_tolerances,
    _values_of_sensitivities,
    _values_of_scatters,
    _values_of_correlation,
    _values_of_total_scatter,
):
    _widen()
    _sets = _count_sets(_out.size, _terms * _terms)
    _sets_of_tolerances = _empty((_terms, _sets))
    _sets_of_sensitivities = _empty((_terms, _sets))
    _sets_of_scatters = _empty((_terms, _sets))
    _sets_of_correlation = _empty((_terms, _terms, _sets))
    _sets_of_total_scatter = _empty((1, _sets))
    _sets_of_every_3 = _empty(_sets)
    _sets_of_every_4 = _empty(_sets)
    _sets_of_every_5 = _empty(_sets)
    _sets_of_every_6 = _empty(_sets)
    _sets_of_every_7 = _empty(_sets)
    _sets_of_every_8 = _empty(_sets)
    _sets_of_every_9 = _empty(_sets)
    _sets_of_every_10 = _empty(_sets)
    _sets_of_sum_1 = _empty(_sets)
    _sets_of_sum_2 = _empty(_sets)
    for _start in _range(0, _out.size, _sets):
        _stop = _min(_start + _sets, _out.size)
        _put_sets(_sets_of_tolerances, _values_of_tolerances, _start, _stop)
        _put_sets(_sets_of_sensitivities, _values_of_sensitivities, _start, _stop)
        _put_sets(_sets_of_scatters, _values_of_scatters, _start, _stop)
        _put_sets(_sets_of_correlation.reshape(-1, _sets), _values_of_correlation, _start, _stop)
        _put_sets(_sets_of_total_scatter, _values_of_total_scatter, _start, _stop)
        if _start == 0 or _len(_values_of_scatters) > 1:
            _every_3_sets(_sets_of_every_3, _sets_of_scatters)
        if _start == 0 or _len(_values_of_scatters) > 1:
            _every_4_sets(_sets_of_every_4, _sets_of_scatters)
        if _start == 0 or _len(_values_of_correlation) > 1:
            _every_5_sets(_sets_of_every_5, _sets_of_correlation)
        if _start == 0 or _len(_values_of_correlation) > 1:
            _every_6_sets(_sets_of_every_6, _sets_of_correlation)
        if _start == 0 or _len(_values_of_correlation) > 1:
            _every_7_sets(_sets_of_every_7, _sets_of_correlation)
        if _start == 0 or _len(_values_of_correlation) > 1:
            _every_8_sets(_sets_of_every_8, _sets_of_correlation)
        if _start == 0 or _len(_values_of_tolerances) > 1:
            _every_9_sets(_sets_of_every_9, _sets_of_tolerances)
        if _start == 0 or _len(_values_of_tolerances) > 1:
            _every_10_sets(_sets_of_every_10, _sets_of_tolerances)
        if (
            _start == 0
            or _len(_values_of_tolerances) > 1
            or _len(_values_of_sensitivities) > 1
            or _len(_values_of_scatters) > 1
            or _len(_values_of_correlation) > 1
        ):
            _sum_1_sets(
                _sets_of_sum_1,
                _sets_of_sensitivities,
                _sets_of_scatters,
                _sets_of_tolerances,
                _sets_of_correlation,
            )
        if (
            _start == 0
            or _len(_values_of_tolerances) > 1
            or _len(_values_of_sensitivities) > 1
            or _len(_values_of_scatters) > 1
            or _len(_values_of_correlation) > 1
        ):
            _sum_2_sets(
                _sets_of_sum_2,
                _sets_of_sensitivities,
                _sets_of_scatters,
                _sets_of_tolerances,
                _sets_of_correlation,
            )
        for _s in _range(_stop - _start):
            _out[_start + _s] = _value_of_error_sum_correlated(
                _sets_of_total_scatter[0, _s],
                _sets_of_every_3[_s] > 0,
                _sets_of_every_4[_s] > 0,
                _sets_of_every_5[_s] > 0,
                _sets_of_every_6[_s] > 0,
                _sets_of_every_7[_s] > 0,
                _sets_of_every_8[_s] > 0,
                _sets_of_every_9[_s] > 0,
                _sets_of_every_10[_s] > 0,
                _sets_of_sum_1[_s],
                _sets_of_sum_2[_s],
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

    Compiled. The help of `mechproof.kernels.track_wheel.error_sum_correlated` has all words.
    """
    return _run_sums(
        _loops_of_error_sum_correlated,
        (
            tolerances,
            sensitivities,
            scatters,
            correlation,
            total_scatter,
        ),
        out,
    )


_loops_of_error_sum_correlated = _Sums(
    names=(
        "tolerances",
        "sensitivities",
        "scatters",
        "correlation",
        "total_scatter",
    ),
    widths=(
        0,
        0,
        0,
        0,
        0,
    ),
    axes=(
        1,
        1,
        1,
        2,
        0,
    ),
    at=_point_of_error_sum_correlated,
    each=_fill_each_of_error_sum_correlated,
)


@_overload(error_sum_correlated)
def _offer_of_error_sum_correlated(
    tolerances,
    sensitivities,
    scatters,
    correlation,
    total_scatter,
):
    def _take(
        tolerances,
        sensitivities,
        scatters,
        correlation,
        total_scatter,
    ):
        _terms = 1
        _terms = _count_terms(_terms, tolerances)
        _terms = _count_terms(_terms, sensitivities)
        _terms = _count_terms(_terms, scatters)
        _terms = _count_terms(_terms, correlation)
        return _point_of_error_sum_correlated(
            _take_terms("tolerances", tolerances, _terms),
            _take_terms("sensitivities", sensitivities, _terms),
            _take_terms("scatters", scatters, _terms),
            _take_square("correlation", correlation, _terms),
            _float64(total_scatter),
        )

    return _take


@_scalar
def _form_of_error_sum(total_scatter, sum_11):

    return _np.sqrt(sum_11) / total_scatter


@_scalar
def _value_of_error_sum(total_scatter, every_3, every_4, every_9, every_10, sum_11):
    if not (
        (total_scatter > 0) & _is_finite(total_scatter) & every_3 & every_4 & every_9 & every_10
    ):
        return _math.nan
    return _form_of_error_sum(total_scatter, sum_11)


@_scalar
def _point_of_error_sum(tolerances, sensitivities, scatters, total_scatter):
    return _value_of_error_sum(
        total_scatter,
        _every_3(scatters),
        _every_4(scatters),
        _every_9(tolerances),
        _every_10(tolerances),
        _sum_11(sensitivities, scatters, tolerances),
    )


@_loop
def _fill_each_of_error_sum(
    _out,
    _terms,
    _values_of_tolerances,
    _values_of_sensitivities,
    _values_of_scatters,
    _values_of_total_scatter,
):
    _widen()
    _sets = _count_sets(_out.size, _terms)
    _sets_of_tolerances = _empty((_terms, _sets))
    _sets_of_sensitivities = _empty((_terms, _sets))
    _sets_of_scatters = _empty((_terms, _sets))
    _sets_of_total_scatter = _empty((1, _sets))
    _sets_of_every_3 = _empty(_sets)
    _sets_of_every_4 = _empty(_sets)
    _sets_of_every_9 = _empty(_sets)
    _sets_of_every_10 = _empty(_sets)
    _sets_of_sum_11 = _empty(_sets)
    for _start in _range(0, _out.size, _sets):
        _stop = _min(_start + _sets, _out.size)
        _put_sets(_sets_of_tolerances, _values_of_tolerances, _start, _stop)
        _put_sets(_sets_of_sensitivities, _values_of_sensitivities, _start, _stop)
        _put_sets(_sets_of_scatters, _values_of_scatters, _start, _stop)
        _put_sets(_sets_of_total_scatter, _values_of_total_scatter, _start, _stop)
        if _start == 0 or _len(_values_of_scatters) > 1:
            _every_3_sets(_sets_of_every_3, _sets_of_scatters)
        if _start == 0 or _len(_values_of_scatters) > 1:
            _every_4_sets(_sets_of_every_4, _sets_of_scatters)
        if _start == 0 or _len(_values_of_tolerances) > 1:
            _every_9_sets(_sets_of_every_9, _sets_of_tolerances)
        if _start == 0 or _len(_values_of_tolerances) > 1:
            _every_10_sets(_sets_of_every_10, _sets_of_tolerances)
        if (
            _start == 0
            or _len(_values_of_tolerances) > 1
            or _len(_values_of_sensitivities) > 1
            or _len(_values_of_scatters) > 1
        ):
            _sum_11_sets(
                _sets_of_sum_11, _sets_of_sensitivities, _sets_of_scatters, _sets_of_tolerances
            )
        for _s in _range(_stop - _start):
            _out[_start + _s] = _value_of_error_sum(
                _sets_of_total_scatter[0, _s],
                _sets_of_every_3[_s] > 0,
                _sets_of_every_4[_s] > 0,
                _sets_of_every_9[_s] > 0,
                _sets_of_every_10[_s] > 0,
                _sets_of_sum_11[_s],
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

    Compiled. The help of `mechproof.kernels.track_wheel.error_sum` has all words.
    """
    return _run_sums(
        _loops_of_error_sum,
        (
            tolerances,
            sensitivities,
            scatters,
            total_scatter,
        ),
        out,
    )


_loops_of_error_sum = _Sums(
    names=(
        "tolerances",
        "sensitivities",
        "scatters",
        "total_scatter",
    ),
    widths=(
        0,
        0,
        0,
        0,
    ),
    axes=(
        1,
        1,
        1,
        0,
    ),
    at=_point_of_error_sum,
    each=_fill_each_of_error_sum,
)


@_overload(error_sum)
def _offer_of_error_sum(
    tolerances,
    sensitivities,
    scatters,
    total_scatter,
):
    def _take(
        tolerances,
        sensitivities,
        scatters,
        total_scatter,
    ):
        _terms = 1
        _terms = _count_terms(_terms, tolerances)
        _terms = _count_terms(_terms, sensitivities)
        _terms = _count_terms(_terms, scatters)
        return _point_of_error_sum(
            _take_terms("tolerances", tolerances, _terms),
            _take_terms("sensitivities", sensitivities, _terms),
            _take_terms("scatters", scatters, _terms),
            _float64(total_scatter),
        )

    return _take


@_scalar
def _form_of_error_sum_thermal(total_scatter, thermal_share, thermal_scatter, sum_11):
    K_minus_tau_K_T = total_scatter - thermal_share * thermal_scatter
    K_plus_tau_K_T = total_scatter + thermal_share * thermal_scatter

    return _np.sqrt(sum_11) / _np.sqrt(K_minus_tau_K_T * K_plus_tau_K_T)


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
    return _form_of_error_sum_thermal(total_scatter, thermal_share, thermal_scatter, sum_11)


@_scalar
def _point_of_error_sum_thermal(
    tolerances, sensitivities, scatters, total_scatter, thermal_share, thermal_scatter
):
    return _value_of_error_sum_thermal(
        total_scatter,
        thermal_share,
        thermal_scatter,
        _every_3(scatters),
        _every_4(scatters),
        _every_9(tolerances),
        _every_10(tolerances),
        _sum_11(sensitivities, scatters, tolerances),
    )


@_loop
def _fill_each_of_error_sum_thermal(
    _out,
    _terms,
    _values_of_tolerances,
    _values_of_sensitivities,
    _values_of_scatters,
    _values_of_total_scatter,
    _values_of_thermal_share,
    _values_of_thermal_scatter,
):
    _widen()
    _sets = _count_sets(_out.size, _terms)
    _sets_of_tolerances = _empty((_terms, _sets))
    _sets_of_sensitivities = _empty((_terms, _sets))
    _sets_of_scatters = _empty((_terms, _sets))
    _sets_of_total_scatter = _empty((1, _sets))
    _sets_of_thermal_share = _empty((1, _sets))
    _sets_of_thermal_scatter = _empty((1, _sets))
    _sets_of_every_3 = _empty(_sets)
    _sets_of_every_4 = _empty(_sets)
    _sets_of_every_9 = _empty(_sets)
    _sets_of_every_10 = _empty(_sets)
    _sets_of_sum_11 = _empty(_sets)
    for _start in _range(0, _out.size, _sets):
        _stop = _min(_start + _sets, _out.size)
        _put_sets(_sets_of_tolerances, _values_of_tolerances, _start, _stop)
        _put_sets(_sets_of_sensitivities, _values_of_sensitivities, _start, _stop)
        _put_sets(_sets_of_scatters, _values_of_scatters, _start, _stop)
        _put_sets(_sets_of_total_scatter, _values_of_total_scatter, _start, _stop)
        _put_sets(_sets_of_thermal_share, _values_of_thermal_share, _start, _stop)
        _put_sets(_sets_of_thermal_scatter, _values_of_thermal_scatter, _start, _stop)
        if _start == 0 or _len(_values_of_scatters) > 1:
            _every_3_sets(_sets_of_every_3, _sets_of_scatters)
        if _start == 0 or _len(_values_of_scatters) > 1:
            _every_4_sets(_sets_of_every_4, _sets_of_scatters)
        if _start == 0 or _len(_values_of_tolerances) > 1:
            _every_9_sets(_sets_of_every_9, _sets_of_tolerances)
        if _start == 0 or _len(_values_of_tolerances) > 1:
            _every_10_sets(_sets_of_every_10, _sets_of_tolerances)
        if (
            _start == 0
            or _len(_values_of_tolerances) > 1
            or _len(_values_of_sensitivities) > 1
            or _len(_values_of_scatters) > 1
        ):
            _sum_11_sets(
                _sets_of_sum_11, _sets_of_sensitivities, _sets_of_scatters, _sets_of_tolerances
            )
        for _s in _range(_stop - _start):
            _out[_start + _s] = _value_of_error_sum_thermal(
                _sets_of_total_scatter[0, _s],
                _sets_of_thermal_share[0, _s],
                _sets_of_thermal_scatter[0, _s],
                _sets_of_every_3[_s] > 0,
                _sets_of_every_4[_s] > 0,
                _sets_of_every_9[_s] > 0,
                _sets_of_every_10[_s] > 0,
                _sets_of_sum_11[_s],
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

    Compiled. The help of `mechproof.kernels.track_wheel.error_sum_thermal` has all words.
    """
    return _run_sums(
        _loops_of_error_sum_thermal,
        (
            tolerances,
            sensitivities,
            scatters,
            total_scatter,
            thermal_share,
            thermal_scatter,
        ),
        out,
    )


_loops_of_error_sum_thermal = _Sums(
    names=(
        "tolerances",
        "sensitivities",
        "scatters",
        "total_scatter",
        "thermal_share",
        "thermal_scatter",
    ),
    widths=(
        0,
        0,
        0,
        0,
        0,
        0,
    ),
    axes=(
        1,
        1,
        1,
        0,
        0,
        0,
    ),
    at=_point_of_error_sum_thermal,
    each=_fill_each_of_error_sum_thermal,
)


@_overload(error_sum_thermal)
def _offer_of_error_sum_thermal(
    tolerances,
    sensitivities,
    scatters,
    total_scatter,
    thermal_share,
    thermal_scatter,
):
    def _take(
        tolerances,
        sensitivities,
        scatters,
        total_scatter,
        thermal_share,
        thermal_scatter,
    ):
        _terms = 1
        _terms = _count_terms(_terms, tolerances)
        _terms = _count_terms(_terms, sensitivities)
        _terms = _count_terms(_terms, scatters)
        return _point_of_error_sum_thermal(
            _take_terms("tolerances", tolerances, _terms),
            _take_terms("sensitivities", sensitivities, _terms),
            _take_terms("scatters", scatters, _terms),
            _float64(total_scatter),
            _float64(thermal_share),
            _float64(thermal_scatter),
        )

    return _take
