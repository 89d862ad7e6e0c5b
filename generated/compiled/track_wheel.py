"""Compiled kernels of the system `track_wheel`: one loop for each, by numba.

Names, arguments, domains, NaN and errors are those of `mechproof.kernels.track_wheel`,
and so are the formulas. Numbers and NumPy arrays are taken. With numbers,
kernels can be called inside functions that numba compiles; arguments with components are then
indexed, and so are results.

Tests hold them to the same accuracy bounds. What help says is proved of rounding errors
is proved of these kernels where it says `compiled`, and of the NumPy kernels elsewhere.

Elementary functions: `elementary` 8db31d8544f3.

Sums over axes are added in the order of the index, with the rest of every addition. Many
sets of terms are added beside each other, each to the bits that it has alone. Inside
functions that numba compiles they take one array of terms for each argument, or a number for
equal ones.

Generated from mechproof.derivations.track_wheel with SymPy 1.14.0.
Regenerate with `mechproof regenerate`; edits are overwritten.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy import empty, float64, ndarray
from numpy.typing import ArrayLike, NDArray

from mechproof.compiled_support import (
    BLOCK,
    Loops,
    Sums,
    choose,
    count_sets,
    count_terms,
    floor,
    fma,
    has_nan,
    is_finite,
    loop,
    overload,
    own_row,
    put_sets,
    run,
    run_sums,
    scalar,
    take_row,
    take_square,
    take_terms,
    widen,
)
from mechproof.kernels.compiled import elementary

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


@scalar
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


@loop
def _sum_1(sensitivities, scatters, tolerances, correlation):
    high, low = 0.0, 0.0
    for i in range(len(sensitivities)):
        for j in range(len(sensitivities)):
            term = _sum_1_term(
                float64(sensitivities[i]),
                float64(scatters[i]),
                float64(tolerances[i]),
                float64(sensitivities[j]),
                float64(scatters[j]),
                float64(tolerances[j]),
                float64(correlation[i, j]),
            )
            total = high + term
            low += elementary.total_rest(high, term, total)
            high = total
    # A sum that leaves the range of doubles has no rest.
    return choose(is_finite(low), high + low, high)


@loop
def _sum_1_sets(out, sensitivities, scatters, tolerances, correlation):
    widen()
    high, low = own_row(), own_row()
    for s in range(len(out)):
        high[s], low[s] = 0.0, 0.0
    for i in range(len(sensitivities)):
        for j in range(len(sensitivities)):
            for s in range(len(out)):
                term = _sum_1_term(
                    sensitivities[i, s],
                    scatters[i, s],
                    tolerances[i, s],
                    sensitivities[j, s],
                    scatters[j, s],
                    tolerances[j, s],
                    correlation[i, j, s],
                )
                total = high[s] + term
                low[s] += elementary.total_rest(high[s], term, total)
                high[s] = total
    for s in range(len(out)):
        out[s] = choose(is_finite(low[s]), high[s] + low[s], high[s])


@scalar
def _sum_2_term(sensitivities_i, scatters_i, tolerances_i, correlation_ii):

    return abs(sensitivities_i * scatters_i * tolerances_i) * np.sqrt(abs(correlation_ii))


@loop
def _sum_2(sensitivities, scatters, tolerances, correlation):
    high, low = 0.0, 0.0
    for i in range(len(sensitivities)):
        term = _sum_2_term(
            float64(sensitivities[i]),
            float64(scatters[i]),
            float64(tolerances[i]),
            float64(correlation[i, i]),
        )
        total = high + term
        low += elementary.total_rest(high, term, total)
        high = total
    # A sum that leaves the range of doubles has no rest.
    return choose(is_finite(low), high + low, high)


@loop
def _sum_2_sets(out, sensitivities, scatters, tolerances, correlation):
    widen()
    high, low = own_row(), own_row()
    for s in range(len(out)):
        high[s], low[s] = 0.0, 0.0
    for i in range(len(sensitivities)):
        for s in range(len(out)):
            term = _sum_2_term(
                sensitivities[i, s], scatters[i, s], tolerances[i, s], correlation[i, i, s]
            )
            total = high[s] + term
            low[s] += elementary.total_rest(high[s], term, total)
            high[s] = total
    for s in range(len(out)):
        out[s] = choose(is_finite(low[s]), high[s] + low[s], high[s])


@scalar
def _every_3_term(scatters_i):

    return scatters_i > 0


@loop
def _every_3(scatters):
    holds = True
    for i in range(len(scatters)):
        holds = holds & _every_3_term(float64(scatters[i]))
    return holds


@loop
def _every_3_sets(out, scatters):
    widen()
    holds = own_row()
    for s in range(len(out)):
        holds[s] = 1.0
    for i in range(len(scatters)):
        for s in range(len(out)):
            holds[s] = choose(_every_3_term(scatters[i, s]), holds[s], 0.0)
    for s in range(len(out)):
        out[s] = holds[s]


@scalar
def _every_4_term(scatters_i):

    return is_finite(scatters_i)


@loop
def _every_4(scatters):
    holds = True
    for i in range(len(scatters)):
        holds = holds & _every_4_term(float64(scatters[i]))
    return holds


@loop
def _every_4_sets(out, scatters):
    widen()
    holds = own_row()
    for s in range(len(out)):
        holds[s] = 1.0
    for i in range(len(scatters)):
        for s in range(len(out)):
            holds[s] = choose(_every_4_term(scatters[i, s]), holds[s], 0.0)
    for s in range(len(out)):
        out[s] = holds[s]


@scalar
def _every_5_term(correlation_ij):

    return correlation_ij >= -1


@loop
def _every_5(correlation):
    holds = True
    for i in range(len(correlation)):
        for j in range(len(correlation)):
            holds = holds & _every_5_term(float64(correlation[i, j]))
    return holds


@loop
def _every_5_sets(out, correlation):
    widen()
    holds = own_row()
    for s in range(len(out)):
        holds[s] = 1.0
    for i in range(len(correlation)):
        for j in range(len(correlation)):
            for s in range(len(out)):
                holds[s] = choose(_every_5_term(correlation[i, j, s]), holds[s], 0.0)
    for s in range(len(out)):
        out[s] = holds[s]


@scalar
def _every_6_term(correlation_ij):

    return correlation_ij <= 1


@loop
def _every_6(correlation):
    holds = True
    for i in range(len(correlation)):
        for j in range(len(correlation)):
            holds = holds & _every_6_term(float64(correlation[i, j]))
    return holds


@loop
def _every_6_sets(out, correlation):
    widen()
    holds = own_row()
    for s in range(len(out)):
        holds[s] = 1.0
    for i in range(len(correlation)):
        for j in range(len(correlation)):
            for s in range(len(out)):
                holds[s] = choose(_every_6_term(correlation[i, j, s]), holds[s], 0.0)
    for s in range(len(out)):
        out[s] = holds[s]


@scalar
def _every_7_term(correlation_ii):

    return correlation_ii == 1


@loop
def _every_7(correlation):
    holds = True
    for i in range(len(correlation)):
        holds = holds & _every_7_term(float64(correlation[i, i]))
    return holds


@loop
def _every_7_sets(out, correlation):
    widen()
    holds = own_row()
    for s in range(len(out)):
        holds[s] = 1.0
    for i in range(len(correlation)):
        for s in range(len(out)):
            holds[s] = choose(_every_7_term(correlation[i, i, s]), holds[s], 0.0)
    for s in range(len(out)):
        out[s] = holds[s]


@scalar
def _every_8_term(correlation_ij, correlation_ji):

    return correlation_ij == correlation_ji


@loop
def _every_8(correlation):
    holds = True
    for i in range(len(correlation)):
        for j in range(len(correlation)):
            holds = holds & _every_8_term(float64(correlation[i, j]), float64(correlation[j, i]))
    return holds


@loop
def _every_8_sets(out, correlation):
    widen()
    holds = own_row()
    for s in range(len(out)):
        holds[s] = 1.0
    for i in range(len(correlation)):
        for j in range(len(correlation)):
            for s in range(len(out)):
                holds[s] = choose(
                    _every_8_term(correlation[i, j, s], correlation[j, i, s]), holds[s], 0.0
                )
    for s in range(len(out)):
        out[s] = holds[s]


@scalar
def _every_9_term(tolerances_i):

    return tolerances_i >= 0


@loop
def _every_9(tolerances):
    holds = True
    for i in range(len(tolerances)):
        holds = holds & _every_9_term(float64(tolerances[i]))
    return holds


@loop
def _every_9_sets(out, tolerances):
    widen()
    holds = own_row()
    for s in range(len(out)):
        holds[s] = 1.0
    for i in range(len(tolerances)):
        for s in range(len(out)):
            holds[s] = choose(_every_9_term(tolerances[i, s]), holds[s], 0.0)
    for s in range(len(out)):
        out[s] = holds[s]


@scalar
def _every_10_term(tolerances_i):

    return is_finite(tolerances_i)


@loop
def _every_10(tolerances):
    holds = True
    for i in range(len(tolerances)):
        holds = holds & _every_10_term(float64(tolerances[i]))
    return holds


@loop
def _every_10_sets(out, tolerances):
    widen()
    holds = own_row()
    for s in range(len(out)):
        holds[s] = 1.0
    for i in range(len(tolerances)):
        for s in range(len(out)):
            holds[s] = choose(_every_10_term(tolerances[i, s]), holds[s], 0.0)
    for s in range(len(out)):
        out[s] = holds[s]


@scalar
def _sum_11_term(sensitivities_i, scatters_i, tolerances_i):

    return (sensitivities_i * scatters_i * tolerances_i) ** 2


@loop
def _sum_11(sensitivities, scatters, tolerances):
    high, low = 0.0, 0.0
    for i in range(len(sensitivities)):
        term = _sum_11_term(float64(sensitivities[i]), float64(scatters[i]), float64(tolerances[i]))
        total = high + term
        low += elementary.total_rest(high, term, total)
        high = total
    # A sum that leaves the range of doubles has no rest.
    return choose(is_finite(low), high + low, high)


@loop
def _sum_11_sets(out, sensitivities, scatters, tolerances):
    widen()
    high, low = own_row(), own_row()
    for s in range(len(out)):
        high[s], low[s] = 0.0, 0.0
    for i in range(len(sensitivities)):
        for s in range(len(out)):
            term = _sum_11_term(sensitivities[i, s], scatters[i, s], tolerances[i, s])
            total = high[s] + term
            low[s] += elementary.total_rest(high[s], term, total)
            high[s] = total
    for s in range(len(out)):
        out[s] = choose(is_finite(low[s]), high[s] + low[s], high[s])


@scalar
def _prepare_rotation(beta, gamma, exact):
    cos_beta = elementary.cos(beta, exact)
    cos_gamma = elementary.cos(gamma, exact)
    sin_gamma = elementary.sin(gamma, exact)
    sin_beta = elementary.sin(beta, exact)

    return (cos_beta, cos_gamma, sin_gamma, sin_beta)


@scalar
def _rotation(alpha, cos_beta, cos_gamma, sin_gamma, sin_beta, exact):
    cos_alpha = elementary.cos(alpha, exact)
    sin_alpha = elementary.sin(alpha, exact)

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


@scalar
def _rotation_at(alpha, beta, gamma, exact):
    prepared = _prepare_rotation(beta, gamma, exact)
    return _rotation(alpha, *prepared, exact)


@scalar
def _rotation_point(alpha, beta, gamma):
    return _rotation_at(alpha, beta, gamma, True)


@loop
def _row_rotation(out, alpha_values, beta, gamma, exact):
    widen()
    for i in range(out.size // 9):
        alpha = float64(alpha_values[i])

        value = _rotation_at(alpha, beta, gamma, exact)
        out[9 * i + 0] = value[0]
        out[9 * i + 1] = value[1]
        out[9 * i + 2] = value[2]
        out[9 * i + 3] = value[3]
        out[9 * i + 4] = value[4]
        out[9 * i + 5] = value[5]
        out[9 * i + 6] = value[6]
        out[9 * i + 7] = value[7]
        out[9 * i + 8] = value[8]


@loop
def _fill_rotation(
    out,
    alpha_values,
    beta,
    gamma,
):
    for start in range(0, out.size // 9, BLOCK):
        stop = start + BLOCK
        out_block = out[9 * start : 9 * stop]
        alpha_block = alpha_values[start:stop]
        _row_rotation(out_block, alpha_block, beta, gamma, None)
        if has_nan(out_block):
            _row_rotation(out_block, alpha_block, beta, gamma, True)


@loop
def _row_each_rotation(out, alpha_values, beta_values, gamma_values, exact):
    widen()
    for i in range(out.size // 9):
        alpha = float64(alpha_values[i])

        beta = float64(beta_values[i])

        gamma = float64(gamma_values[i])

        value = _rotation_at(alpha, beta, gamma, exact)
        out[9 * i + 0] = value[0]
        out[9 * i + 1] = value[1]
        out[9 * i + 2] = value[2]
        out[9 * i + 3] = value[3]
        out[9 * i + 4] = value[4]
        out[9 * i + 5] = value[5]
        out[9 * i + 6] = value[6]
        out[9 * i + 7] = value[7]
        out[9 * i + 8] = value[8]


@loop
def _fill_each_rotation(
    out,
    alpha_values,
    beta_values,
    gamma_values,
):
    for start in range(0, out.size // 9, BLOCK):
        stop = start + BLOCK
        out_block = out[9 * start : 9 * stop]
        alpha_block = alpha_values[start:stop]
        beta_block = beta_values[start:stop]
        gamma_block = gamma_values[start:stop]
        _row_each_rotation(out_block, alpha_block, beta_block, gamma_block, None)
        if has_nan(out_block):
            _row_each_rotation(out_block, alpha_block, beta_block, gamma_block, True)


def rotation(
    alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the matrix K of the turns alpha, beta, gamma: coordinates in the part's frame.

    Compiled. The help of `mechproof.kernels.track_wheel.rotation` has all words.
    """
    return run(
        _ROTATION,
        (
            alpha,
            beta,
            gamma,
        ),
        out,
    )


_ROTATION = Loops(
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
    at=_rotation_point,
    uniform=_fill_rotation,
    each=_fill_each_rotation,
)


@overload(rotation)
def _offer_rotation(
    alpha,
    beta,
    gamma,
):
    return lambda alpha, beta, gamma: _rotation_point(
        float64(alpha),
        float64(beta),
        float64(gamma),
    )


@scalar
def _prepare_displacement(angles_0, angles_1, angles_2, shift_0, shift_1, shift_2, exact):
    t_alpha_angle = angles_0 / 2
    t_alpha_below = elementary.tangent_below(t_alpha_angle, exact)
    t_alpha = elementary.tangent_above(t_alpha_angle, exact)
    t_beta_angle = angles_1 / 2
    t_beta_below = elementary.tangent_below(t_beta_angle, exact)
    t_beta = elementary.tangent_above(t_beta_angle, exact)
    t_gamma_angle = angles_2 / 2
    t_gamma_below = elementary.tangent_below(t_gamma_angle, exact)
    t_gamma = elementary.tangent_above(t_gamma_angle, exact)
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


@scalar
def _displacement(
    points_0, points_1, points_2, m00, m01, m02, m10, m11, m12, m20, m21, m22, v0, v1, v2, exact
):

    return (
        fma(m00, points_0, fma(m01, points_1, fma(m02, points_2, v0))),
        fma(m10, points_0, fma(m11, points_1, fma(m12, points_2, v1))),
        fma(m20, points_0, fma(m21, points_1, fma(m22, points_2, v2))),
    )


@scalar
def _displacement_at(
    points_0, points_1, points_2, angles_0, angles_1, angles_2, shift_0, shift_1, shift_2, exact
):
    prepared = _prepare_displacement(angles_0, angles_1, angles_2, shift_0, shift_1, shift_2, exact)
    return _displacement(points_0, points_1, points_2, *prepared, exact)


@scalar
def _displacement_point(
    points_0, points_1, points_2, angles_0, angles_1, angles_2, shift_0, shift_1, shift_2
):
    return _displacement_at(
        points_0, points_1, points_2, angles_0, angles_1, angles_2, shift_0, shift_1, shift_2, True
    )


@loop
def _row_displacement(
    out, points_values, angles_0, angles_1, angles_2, shift_0, shift_1, shift_2, exact
):
    widen()
    for i in range(out.size // 3):
        points_0 = float64(points_values[3 * i + 0])
        points_1 = float64(points_values[3 * i + 1])
        points_2 = float64(points_values[3 * i + 2])

        value = _displacement_at(
            points_0,
            points_1,
            points_2,
            angles_0,
            angles_1,
            angles_2,
            shift_0,
            shift_1,
            shift_2,
            exact,
        )
        out[3 * i + 0] = value[0]
        out[3 * i + 1] = value[1]
        out[3 * i + 2] = value[2]


@loop
def _fill_displacement(
    out,
    points_values,
    angles_0,
    angles_1,
    angles_2,
    shift_0,
    shift_1,
    shift_2,
):
    for start in range(0, out.size // 3, BLOCK):
        stop = start + BLOCK
        out_block = out[3 * start : 3 * stop]
        points_block = points_values[3 * start : 3 * stop]
        _row_displacement(
            out_block, points_block, angles_0, angles_1, angles_2, shift_0, shift_1, shift_2, None
        )
        if has_nan(out_block):
            _row_displacement(
                out_block,
                points_block,
                angles_0,
                angles_1,
                angles_2,
                shift_0,
                shift_1,
                shift_2,
                True,
            )


@loop
def _row_each_displacement(out, points_values, angles_values, shift_values, exact):
    widen()
    for i in range(out.size // 3):
        points_0 = float64(points_values[3 * i + 0])
        points_1 = float64(points_values[3 * i + 1])
        points_2 = float64(points_values[3 * i + 2])

        angles_0 = float64(angles_values[3 * i + 0])
        angles_1 = float64(angles_values[3 * i + 1])
        angles_2 = float64(angles_values[3 * i + 2])

        shift_0 = float64(shift_values[3 * i + 0])
        shift_1 = float64(shift_values[3 * i + 1])
        shift_2 = float64(shift_values[3 * i + 2])

        value = _displacement_at(
            points_0,
            points_1,
            points_2,
            angles_0,
            angles_1,
            angles_2,
            shift_0,
            shift_1,
            shift_2,
            exact,
        )
        out[3 * i + 0] = value[0]
        out[3 * i + 1] = value[1]
        out[3 * i + 2] = value[2]


@loop
def _fill_each_displacement(
    out,
    points_values,
    angles_values,
    shift_values,
):
    for start in range(0, out.size // 3, BLOCK):
        stop = start + BLOCK
        out_block = out[3 * start : 3 * stop]
        points_block = points_values[3 * start : 3 * stop]
        angles_block = angles_values[3 * start : 3 * stop]
        shift_block = shift_values[3 * start : 3 * stop]
        _row_each_displacement(out_block, points_block, angles_block, shift_block, None)
        if has_nan(out_block):
            _row_each_displacement(out_block, points_block, angles_block, shift_block, True)


def displacement(
    points: ArrayLike, angles: ArrayLike, shift: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the position errors K^T*p - (p - t) of points p, turn K and shift t.

    Compiled. The help of `mechproof.kernels.track_wheel.displacement` has all words.
    """
    return run(
        _DISPLACEMENT,
        (
            points,
            angles,
            shift,
        ),
        out,
    )


_DISPLACEMENT = Loops(
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
    at=_displacement_point,
    uniform=_fill_displacement,
    each=_fill_each_displacement,
)


@overload(displacement)
def _offer_displacement(
    points,
    angles,
    shift,
):
    return lambda points, angles, shift: _displacement_point(
        float64(points[0]),
        float64(points[1]),
        float64(points[2]),
        float64(angles[0]),
        float64(angles[1]),
        float64(angles[2]),
        float64(shift[0]),
        float64(shift[1]),
        float64(shift[2]),
    )


@scalar
def _planar_error(displacement_0, displacement_1):

    return elementary.hypot(displacement_0, displacement_1)


@scalar
def _planar_error_at(displacement_0, displacement_1):
    return _planar_error(displacement_0, displacement_1)


@scalar
def _planar_error_point(displacement_0, displacement_1, displacement_2):
    return _planar_error_at(displacement_0, displacement_1)


@loop
def _row_planar_error(
    out,
    displacement_values,
):
    widen()
    for i in range(out.size):
        displacement_0 = float64(displacement_values[3 * i + 0])
        displacement_1 = float64(displacement_values[3 * i + 1])

        value = _planar_error_at(displacement_0, displacement_1)
        out[i] = value


@loop
def _fill_planar_error(
    out,
    displacement_values,
):
    _row_planar_error(
        out,
        displacement_values,
    )


@loop
def _row_each_planar_error(
    out,
    displacement_values,
):
    widen()
    for i in range(out.size):
        displacement_0 = float64(displacement_values[3 * i + 0])
        displacement_1 = float64(displacement_values[3 * i + 1])

        value = _planar_error_at(displacement_0, displacement_1)
        out[i] = value


@loop
def _fill_each_planar_error(
    out,
    displacement_values,
):
    _row_each_planar_error(
        out,
        displacement_values,
    )


def planar_error(displacement: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the error in the end plane X0Y0.

    Compiled. The help of `mechproof.kernels.track_wheel.planar_error` has all words.
    """
    return run(_PLANAR_ERROR, (displacement,), out)


_PLANAR_ERROR = Loops(
    names=("displacement",),
    widths=(3,),
    shape=(),
    at=_planar_error_point,
    uniform=_fill_planar_error,
    each=_fill_each_planar_error,
)


@overload(planar_error)
def _offer_planar_error(
    displacement,
):
    return lambda displacement: _planar_error_point(
        float64(displacement[0]),
        float64(displacement[1]),
        float64(displacement[2]),
    )


@scalar
def _spatial_error(displacement_0, displacement_1, displacement_2):

    return elementary.hypot(elementary.hypot(displacement_0, displacement_1), displacement_2)


@scalar
def _spatial_error_at(displacement_0, displacement_1, displacement_2):
    return _spatial_error(displacement_0, displacement_1, displacement_2)


@scalar
def _spatial_error_point(displacement_0, displacement_1, displacement_2):
    return _spatial_error_at(displacement_0, displacement_1, displacement_2)


@loop
def _row_spatial_error(
    out,
    displacement_values,
):
    widen()
    for i in range(out.size):
        displacement_0 = float64(displacement_values[3 * i + 0])
        displacement_1 = float64(displacement_values[3 * i + 1])
        displacement_2 = float64(displacement_values[3 * i + 2])

        value = _spatial_error_at(displacement_0, displacement_1, displacement_2)
        out[i] = value


@loop
def _fill_spatial_error(
    out,
    displacement_values,
):
    _row_spatial_error(
        out,
        displacement_values,
    )


@loop
def _row_each_spatial_error(
    out,
    displacement_values,
):
    widen()
    for i in range(out.size):
        displacement_0 = float64(displacement_values[3 * i + 0])
        displacement_1 = float64(displacement_values[3 * i + 1])
        displacement_2 = float64(displacement_values[3 * i + 2])

        value = _spatial_error_at(displacement_0, displacement_1, displacement_2)
        out[i] = value


@loop
def _fill_each_spatial_error(
    out,
    displacement_values,
):
    _row_each_spatial_error(
        out,
        displacement_values,
    )


def spatial_error(displacement: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the error in space.

    Compiled. The help of `mechproof.kernels.track_wheel.spatial_error` has all words.
    """
    return run(_SPATIAL_ERROR, (displacement,), out)


_SPATIAL_ERROR = Loops(
    names=("displacement",),
    widths=(3,),
    shape=(),
    at=_spatial_error_point,
    uniform=_fill_spatial_error,
    each=_fill_each_spatial_error,
)


@overload(spatial_error)
def _offer_spatial_error(
    displacement,
):
    return lambda displacement: _spatial_error_point(
        float64(displacement[0]),
        float64(displacement[1]),
        float64(displacement[2]),
    )


@scalar
def _prepare_radius(R, A, z, exact):
    A_plus_R = A + R
    R_minus_A = R - A
    w = A_plus_R * R_minus_A

    return (A, z, w)


@scalar
def _radius(phi, A, z, w, exact):
    u = A * elementary.cos(z * phi, exact)
    q = abs(u) + elementary.hypot(np.sqrt(w), u)

    return choose(u >= 0, q, w / q)


@scalar
def _radius_at(phi, R, A, z, exact):
    if not ((R > 0) & is_finite(R) & (z >= 1) & is_finite(z) & (z == floor(z)) & (abs(A) <= R)):
        return math.nan
    prepared = _prepare_radius(R, A, z, exact)
    return _radius(phi, *prepared, exact)


@scalar
def _radius_point(phi, R, A, z):
    return _radius_at(phi, R, A, z, True)


@loop
def _row_radius(out, phi_values, R, A, z, exact):
    widen()
    for i in range(out.size):
        phi = float64(phi_values[i])

        value = _radius_at(phi, R, A, z, exact)
        out[i] = value


@loop
def _fill_radius(
    out,
    phi_values,
    R,
    A,
    z,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi_block = phi_values[start:stop]
        _row_radius(out_block, phi_block, R, A, z, None)
        if has_nan(out_block):
            _row_radius(out_block, phi_block, R, A, z, True)


@loop
def _row_each_radius(out, phi_values, R_values, A_values, z_values, exact):
    widen()
    for i in range(out.size):
        phi = float64(phi_values[i])

        R = float64(R_values[i])

        A = float64(A_values[i])

        z = float64(z_values[i])

        value = _radius_at(phi, R, A, z, exact)
        out[i] = value


@loop
def _fill_each_radius(
    out,
    phi_values,
    R_values,
    A_values,
    z_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi_block = phi_values[start:stop]
        R_block = R_values[start:stop]
        A_block = A_values[start:stop]
        z_block = z_values[start:stop]
        _row_each_radius(out_block, phi_block, R_block, A_block, z_block, None)
        if has_nan(out_block):
            _row_each_radius(out_block, phi_block, R_block, A_block, z_block, True)


def radius(
    phi: ArrayLike, R: ArrayLike, A: ArrayLike, z: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the radius vector of the track, a shifted circle repeated z times.

    Compiled. The help of `mechproof.kernels.track_wheel.radius` has all words.
    """
    if type(R) is type(A) is type(z) is float:
        if type(phi) is ndarray:
            row = take_row(phi, out)
            if row is not None:
                _RADIUS.fill(row, phi, R, A, z)
                return row
        elif type(phi) is float and out is None:
            return float64(_RADIUS.point(phi, R, A, z))
    return run(
        _RADIUS,
        (
            phi,
            R,
            A,
            z,
        ),
        out,
    )


_RADIUS = Loops(
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
    at=_radius_point,
    uniform=_fill_radius,
    each=_fill_each_radius,
)


@overload(radius)
def _offer_radius(
    phi,
    R,
    A,
    z,
):
    return lambda phi, R, A, z: _radius_point(
        float64(phi),
        float64(R),
        float64(A),
        float64(z),
    )


@scalar
def _prepare_track(R, A, z, H, exact):
    A_plus_R = A + R
    R_minus_A = R - A
    w = A_plus_R * R_minus_A

    return (A, z, H, w)


@scalar
def _track(phi, A, z, H, w, exact):
    u = A * elementary.cos(z * phi, exact)
    q = abs(u) + elementary.hypot(np.sqrt(w), u)
    term = choose(u >= 0, q, w / q)

    return (
        term * elementary.cos(phi, exact),
        term * elementary.sin(phi, exact),
        H,
    )


@scalar
def _track_at(phi, R, A, z, H, exact):
    if not (
        (R > 0)
        & is_finite(R)
        & (H > 0)
        & is_finite(H)
        & (z >= 1)
        & is_finite(z)
        & (z == floor(z))
        & (abs(A) <= R)
    ):
        return (math.nan, math.nan, math.nan)
    prepared = _prepare_track(R, A, z, H, exact)
    return _track(phi, *prepared, exact)


@scalar
def _track_point(phi, R, A, z, H):
    return _track_at(phi, R, A, z, H, True)


@loop
def _row_track(out, phi_values, R, A, z, H, exact):
    widen()
    for i in range(out.size // 3):
        phi = float64(phi_values[i])

        value = _track_at(phi, R, A, z, H, exact)
        out[3 * i + 0] = value[0]
        out[3 * i + 1] = value[1]
        out[3 * i + 2] = value[2]


@loop
def _fill_track(
    out,
    phi_values,
    R,
    A,
    z,
    H,
):
    for start in range(0, out.size // 3, BLOCK):
        stop = start + BLOCK
        out_block = out[3 * start : 3 * stop]
        phi_block = phi_values[start:stop]
        _row_track(out_block, phi_block, R, A, z, H, None)
        if has_nan(out_block):
            _row_track(out_block, phi_block, R, A, z, H, True)


@loop
def _row_each_track(out, phi_values, R_values, A_values, z_values, H_values, exact):
    widen()
    for i in range(out.size // 3):
        phi = float64(phi_values[i])

        R = float64(R_values[i])

        A = float64(A_values[i])

        z = float64(z_values[i])

        H = float64(H_values[i])

        value = _track_at(phi, R, A, z, H, exact)
        out[3 * i + 0] = value[0]
        out[3 * i + 1] = value[1]
        out[3 * i + 2] = value[2]


@loop
def _fill_each_track(
    out,
    phi_values,
    R_values,
    A_values,
    z_values,
    H_values,
):
    for start in range(0, out.size // 3, BLOCK):
        stop = start + BLOCK
        out_block = out[3 * start : 3 * stop]
        phi_block = phi_values[start:stop]
        R_block = R_values[start:stop]
        A_block = A_values[start:stop]
        z_block = z_values[start:stop]
        H_block = H_values[start:stop]
        _row_each_track(out_block, phi_block, R_block, A_block, z_block, H_block, None)
        if has_nan(out_block):
            _row_each_track(out_block, phi_block, R_block, A_block, z_block, H_block, True)


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
    return run(
        _TRACK,
        (
            phi,
            R,
            A,
            z,
            H,
        ),
        out,
    )


_TRACK = Loops(
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
    at=_track_point,
    uniform=_fill_track,
    each=_fill_each_track,
)


@overload(track)
def _offer_track(
    phi,
    R,
    A,
    z,
    H,
):
    return lambda phi, R, A, z, H: _track_point(
        float64(phi),
        float64(R),
        float64(A),
        float64(z),
        float64(H),
    )


@scalar
def _prepare_largest_radius(A):

    return (A,)


@scalar
def _largest_radius(R, A):

    return R + abs(A)


@scalar
def _largest_radius_at(R, A):
    if not ((R > 0) & is_finite(R) & (abs(A) <= R)):
        return math.nan
    prepared = _prepare_largest_radius(A)
    return _largest_radius(R, *prepared)


@scalar
def _largest_radius_point(R, A):
    return _largest_radius_at(R, A)


@loop
def _row_largest_radius(
    out,
    R_values,
    A,
):
    widen()
    for i in range(out.size):
        R = float64(R_values[i])

        value = _largest_radius_at(R, A)
        out[i] = value


@loop
def _fill_largest_radius(
    out,
    R_values,
    A,
):
    _row_largest_radius(
        out,
        R_values,
        A,
    )


@loop
def _row_each_largest_radius(
    out,
    R_values,
    A_values,
):
    widen()
    for i in range(out.size):
        R = float64(R_values[i])

        A = float64(A_values[i])

        value = _largest_radius_at(R, A)
        out[i] = value


@loop
def _fill_each_largest_radius(
    out,
    R_values,
    A_values,
):
    _row_each_largest_radius(
        out,
        R_values,
        A_values,
    )


def largest_radius(R: ArrayLike, A: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the largest radius vector of the track.

    Compiled. The help of `mechproof.kernels.track_wheel.largest_radius` has all words.
    """
    if type(A) is float:
        if type(R) is ndarray:
            row = take_row(R, out)
            if row is not None:
                _LARGEST_RADIUS.fill(row, R, A)
                return row
        elif type(R) is float and out is None:
            return float64(_LARGEST_RADIUS.point(R, A))
    return run(
        _LARGEST_RADIUS,
        (
            R,
            A,
        ),
        out,
    )


_LARGEST_RADIUS = Loops(
    names=(
        "R",
        "A",
    ),
    widths=(
        0,
        0,
    ),
    shape=(),
    at=_largest_radius_point,
    uniform=_fill_largest_radius,
    each=_fill_each_largest_radius,
)


@overload(largest_radius)
def _offer_largest_radius(
    R,
    A,
):
    return lambda R, A: _largest_radius_point(
        float64(R),
        float64(A),
    )


@scalar
def _prepare_smallest_radius(A):

    return (A,)


@scalar
def _smallest_radius(R, A):

    return R - abs(A)


@scalar
def _smallest_radius_at(R, A):
    if not ((R > 0) & is_finite(R) & (abs(A) <= R)):
        return math.nan
    prepared = _prepare_smallest_radius(A)
    return _smallest_radius(R, *prepared)


@scalar
def _smallest_radius_point(R, A):
    return _smallest_radius_at(R, A)


@loop
def _row_smallest_radius(
    out,
    R_values,
    A,
):
    widen()
    for i in range(out.size):
        R = float64(R_values[i])

        value = _smallest_radius_at(R, A)
        out[i] = value


@loop
def _fill_smallest_radius(
    out,
    R_values,
    A,
):
    _row_smallest_radius(
        out,
        R_values,
        A,
    )


@loop
def _row_each_smallest_radius(
    out,
    R_values,
    A_values,
):
    widen()
    for i in range(out.size):
        R = float64(R_values[i])

        A = float64(A_values[i])

        value = _smallest_radius_at(R, A)
        out[i] = value


@loop
def _fill_each_smallest_radius(
    out,
    R_values,
    A_values,
):
    _row_each_smallest_radius(
        out,
        R_values,
        A_values,
    )


def smallest_radius(R: ArrayLike, A: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the smallest radius vector of the track.

    Compiled. The help of `mechproof.kernels.track_wheel.smallest_radius` has all words.
    """
    if type(A) is float:
        if type(R) is ndarray:
            row = take_row(R, out)
            if row is not None:
                _SMALLEST_RADIUS.fill(row, R, A)
                return row
        elif type(R) is float and out is None:
            return float64(_SMALLEST_RADIUS.point(R, A))
    return run(
        _SMALLEST_RADIUS,
        (
            R,
            A,
        ),
        out,
    )


_SMALLEST_RADIUS = Loops(
    names=(
        "R",
        "A",
    ),
    widths=(
        0,
        0,
    ),
    shape=(),
    at=_smallest_radius_point,
    uniform=_fill_smallest_radius,
    each=_fill_each_smallest_radius,
)


@overload(smallest_radius)
def _offer_smallest_radius(
    R,
    A,
):
    return lambda R, A: _smallest_radius_point(
        float64(R),
        float64(A),
    )


@scalar
def _error_sum_correlated(total_scatter, sum_1, sum_2):

    return np.sqrt(elementary.nonnegative(sum_1, sum_2**2)) / total_scatter


@scalar
def _error_sum_correlated_at(
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
        & is_finite(total_scatter)
        & every_3
        & every_4
        & every_5
        & every_6
        & every_7
        & every_8
        & every_9
        & every_10
    ):
        return math.nan
    return _error_sum_correlated(total_scatter, sum_1, sum_2)


@scalar
def _error_sum_correlated_point(tolerances, sensitivities, scatters, correlation, total_scatter):
    return _error_sum_correlated_at(
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


@loop
def _fill_each_error_sum_correlated(
    out,
    terms,
    tolerances_values,
    sensitivities_values,
    scatters_values,
    correlation_values,
    total_scatter_values,
):
    widen()
    sets = count_sets(out.size, terms * terms)
    tolerances_sets = empty((terms, sets))
    sensitivities_sets = empty((terms, sets))
    scatters_sets = empty((terms, sets))
    correlation_sets = empty((terms, terms, sets))
    total_scatter_sets = empty((1, sets))
    every_3_sets = empty(sets)
    every_4_sets = empty(sets)
    every_5_sets = empty(sets)
    every_6_sets = empty(sets)
    every_7_sets = empty(sets)
    every_8_sets = empty(sets)
    every_9_sets = empty(sets)
    every_10_sets = empty(sets)
    sum_1_sets = empty(sets)
    sum_2_sets = empty(sets)
    for start in range(0, out.size, sets):
        stop = min(start + sets, out.size)
        put_sets(tolerances_sets, tolerances_values, start, stop)
        put_sets(sensitivities_sets, sensitivities_values, start, stop)
        put_sets(scatters_sets, scatters_values, start, stop)
        put_sets(correlation_sets.reshape(-1, sets), correlation_values, start, stop)
        put_sets(total_scatter_sets, total_scatter_values, start, stop)
        if start == 0 or len(scatters_values) > 1:
            _every_3_sets(every_3_sets, scatters_sets)
        if start == 0 or len(scatters_values) > 1:
            _every_4_sets(every_4_sets, scatters_sets)
        if start == 0 or len(correlation_values) > 1:
            _every_5_sets(every_5_sets, correlation_sets)
        if start == 0 or len(correlation_values) > 1:
            _every_6_sets(every_6_sets, correlation_sets)
        if start == 0 or len(correlation_values) > 1:
            _every_7_sets(every_7_sets, correlation_sets)
        if start == 0 or len(correlation_values) > 1:
            _every_8_sets(every_8_sets, correlation_sets)
        if start == 0 or len(tolerances_values) > 1:
            _every_9_sets(every_9_sets, tolerances_sets)
        if start == 0 or len(tolerances_values) > 1:
            _every_10_sets(every_10_sets, tolerances_sets)
        if (
            start == 0
            or len(tolerances_values) > 1
            or len(sensitivities_values) > 1
            or len(scatters_values) > 1
            or len(correlation_values) > 1
        ):
            _sum_1_sets(
                sum_1_sets, sensitivities_sets, scatters_sets, tolerances_sets, correlation_sets
            )
        if (
            start == 0
            or len(tolerances_values) > 1
            or len(sensitivities_values) > 1
            or len(scatters_values) > 1
            or len(correlation_values) > 1
        ):
            _sum_2_sets(
                sum_2_sets, sensitivities_sets, scatters_sets, tolerances_sets, correlation_sets
            )
        for s in range(stop - start):
            out[start + s] = _error_sum_correlated_at(
                total_scatter_sets[0, s],
                every_3_sets[s] > 0,
                every_4_sets[s] > 0,
                every_5_sets[s] > 0,
                every_6_sets[s] > 0,
                every_7_sets[s] > 0,
                every_8_sets[s] > 0,
                every_9_sets[s] > 0,
                every_10_sets[s] > 0,
                sum_1_sets[s],
                sum_2_sets[s],
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
    return run_sums(
        _ERROR_SUM_CORRELATED,
        (
            tolerances,
            sensitivities,
            scatters,
            correlation,
            total_scatter,
        ),
        out,
    )


_ERROR_SUM_CORRELATED = Sums(
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
    at=_error_sum_correlated_point,
    each=_fill_each_error_sum_correlated,
)


@overload(error_sum_correlated)
def _offer_error_sum_correlated(
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
        _terms = count_terms(_terms, tolerances)
        _terms = count_terms(_terms, sensitivities)
        _terms = count_terms(_terms, scatters)
        _terms = count_terms(_terms, correlation)
        return _error_sum_correlated_point(
            take_terms("tolerances", tolerances, _terms),
            take_terms("sensitivities", sensitivities, _terms),
            take_terms("scatters", scatters, _terms),
            take_square("correlation", correlation, _terms),
            float64(total_scatter),
        )

    return _take


@scalar
def _error_sum(total_scatter, sum_11):

    return np.sqrt(sum_11) / total_scatter


@scalar
def _error_sum_at(total_scatter, every_3, every_4, every_9, every_10, sum_11):
    if not (
        (total_scatter > 0) & is_finite(total_scatter) & every_3 & every_4 & every_9 & every_10
    ):
        return math.nan
    return _error_sum(total_scatter, sum_11)


@scalar
def _error_sum_point(tolerances, sensitivities, scatters, total_scatter):
    return _error_sum_at(
        total_scatter,
        _every_3(scatters),
        _every_4(scatters),
        _every_9(tolerances),
        _every_10(tolerances),
        _sum_11(sensitivities, scatters, tolerances),
    )


@loop
def _fill_each_error_sum(
    out,
    terms,
    tolerances_values,
    sensitivities_values,
    scatters_values,
    total_scatter_values,
):
    widen()
    sets = count_sets(out.size, terms)
    tolerances_sets = empty((terms, sets))
    sensitivities_sets = empty((terms, sets))
    scatters_sets = empty((terms, sets))
    total_scatter_sets = empty((1, sets))
    every_3_sets = empty(sets)
    every_4_sets = empty(sets)
    every_9_sets = empty(sets)
    every_10_sets = empty(sets)
    sum_11_sets = empty(sets)
    for start in range(0, out.size, sets):
        stop = min(start + sets, out.size)
        put_sets(tolerances_sets, tolerances_values, start, stop)
        put_sets(sensitivities_sets, sensitivities_values, start, stop)
        put_sets(scatters_sets, scatters_values, start, stop)
        put_sets(total_scatter_sets, total_scatter_values, start, stop)
        if start == 0 or len(scatters_values) > 1:
            _every_3_sets(every_3_sets, scatters_sets)
        if start == 0 or len(scatters_values) > 1:
            _every_4_sets(every_4_sets, scatters_sets)
        if start == 0 or len(tolerances_values) > 1:
            _every_9_sets(every_9_sets, tolerances_sets)
        if start == 0 or len(tolerances_values) > 1:
            _every_10_sets(every_10_sets, tolerances_sets)
        if (
            start == 0
            or len(tolerances_values) > 1
            or len(sensitivities_values) > 1
            or len(scatters_values) > 1
        ):
            _sum_11_sets(sum_11_sets, sensitivities_sets, scatters_sets, tolerances_sets)
        for s in range(stop - start):
            out[start + s] = _error_sum_at(
                total_scatter_sets[0, s],
                every_3_sets[s] > 0,
                every_4_sets[s] > 0,
                every_9_sets[s] > 0,
                every_10_sets[s] > 0,
                sum_11_sets[s],
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
    return run_sums(
        _ERROR_SUM,
        (
            tolerances,
            sensitivities,
            scatters,
            total_scatter,
        ),
        out,
    )


_ERROR_SUM = Sums(
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
    at=_error_sum_point,
    each=_fill_each_error_sum,
)


@overload(error_sum)
def _offer_error_sum(
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
        _terms = count_terms(_terms, tolerances)
        _terms = count_terms(_terms, sensitivities)
        _terms = count_terms(_terms, scatters)
        return _error_sum_point(
            take_terms("tolerances", tolerances, _terms),
            take_terms("sensitivities", sensitivities, _terms),
            take_terms("scatters", scatters, _terms),
            float64(total_scatter),
        )

    return _take


@scalar
def _error_sum_thermal(total_scatter, thermal_share, thermal_scatter, sum_11):
    K_minus_tau_K_T = total_scatter - thermal_share * thermal_scatter
    K_plus_tau_K_T = total_scatter + thermal_share * thermal_scatter

    return np.sqrt(sum_11) / np.sqrt(K_minus_tau_K_T * K_plus_tau_K_T)


@scalar
def _error_sum_thermal_at(
    total_scatter, thermal_share, thermal_scatter, every_3, every_4, every_9, every_10, sum_11
):
    if not (
        (total_scatter > 0)
        & is_finite(total_scatter)
        & every_3
        & every_4
        & (thermal_scatter > 0)
        & is_finite(thermal_scatter)
        & (thermal_share >= 0)
        & is_finite(thermal_share)
        & (thermal_share * thermal_scatter < total_scatter)
        & every_9
        & every_10
    ):
        return math.nan
    return _error_sum_thermal(total_scatter, thermal_share, thermal_scatter, sum_11)


@scalar
def _error_sum_thermal_point(
    tolerances, sensitivities, scatters, total_scatter, thermal_share, thermal_scatter
):
    return _error_sum_thermal_at(
        total_scatter,
        thermal_share,
        thermal_scatter,
        _every_3(scatters),
        _every_4(scatters),
        _every_9(tolerances),
        _every_10(tolerances),
        _sum_11(sensitivities, scatters, tolerances),
    )


@loop
def _fill_each_error_sum_thermal(
    out,
    terms,
    tolerances_values,
    sensitivities_values,
    scatters_values,
    total_scatter_values,
    thermal_share_values,
    thermal_scatter_values,
):
    widen()
    sets = count_sets(out.size, terms)
    tolerances_sets = empty((terms, sets))
    sensitivities_sets = empty((terms, sets))
    scatters_sets = empty((terms, sets))
    total_scatter_sets = empty((1, sets))
    thermal_share_sets = empty((1, sets))
    thermal_scatter_sets = empty((1, sets))
    every_3_sets = empty(sets)
    every_4_sets = empty(sets)
    every_9_sets = empty(sets)
    every_10_sets = empty(sets)
    sum_11_sets = empty(sets)
    for start in range(0, out.size, sets):
        stop = min(start + sets, out.size)
        put_sets(tolerances_sets, tolerances_values, start, stop)
        put_sets(sensitivities_sets, sensitivities_values, start, stop)
        put_sets(scatters_sets, scatters_values, start, stop)
        put_sets(total_scatter_sets, total_scatter_values, start, stop)
        put_sets(thermal_share_sets, thermal_share_values, start, stop)
        put_sets(thermal_scatter_sets, thermal_scatter_values, start, stop)
        if start == 0 or len(scatters_values) > 1:
            _every_3_sets(every_3_sets, scatters_sets)
        if start == 0 or len(scatters_values) > 1:
            _every_4_sets(every_4_sets, scatters_sets)
        if start == 0 or len(tolerances_values) > 1:
            _every_9_sets(every_9_sets, tolerances_sets)
        if start == 0 or len(tolerances_values) > 1:
            _every_10_sets(every_10_sets, tolerances_sets)
        if (
            start == 0
            or len(tolerances_values) > 1
            or len(sensitivities_values) > 1
            or len(scatters_values) > 1
        ):
            _sum_11_sets(sum_11_sets, sensitivities_sets, scatters_sets, tolerances_sets)
        for s in range(stop - start):
            out[start + s] = _error_sum_thermal_at(
                total_scatter_sets[0, s],
                thermal_share_sets[0, s],
                thermal_scatter_sets[0, s],
                every_3_sets[s] > 0,
                every_4_sets[s] > 0,
                every_9_sets[s] > 0,
                every_10_sets[s] > 0,
                sum_11_sets[s],
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
    return run_sums(
        _ERROR_SUM_THERMAL,
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


_ERROR_SUM_THERMAL = Sums(
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
    at=_error_sum_thermal_point,
    each=_fill_each_error_sum_thermal,
)


@overload(error_sum_thermal)
def _offer_error_sum_thermal(
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
        _terms = count_terms(_terms, tolerances)
        _terms = count_terms(_terms, sensitivities)
        _terms = count_terms(_terms, scatters)
        return _error_sum_thermal_point(
            take_terms("tolerances", tolerances, _terms),
            take_terms("sensitivities", sensitivities, _terms),
            take_terms("scatters", scatters, _terms),
            float64(total_scatter),
            float64(thermal_share),
            float64(thermal_scatter),
        )

    return _take
