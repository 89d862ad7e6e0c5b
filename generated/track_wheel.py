"""Kernels of the system `track_wheel`.

Kapitonov, Yakubovsky 2022, machining error of a wheel with a multi-period track, doi
10.24412/2079-7958-2022-1-43-52

Lengths in mm, angles in radians, turns counter-clockwise positive. The matrices give coordinates in
the turned frame. Letters that the paper uses twice are kept apart: K (scatter coefficient) and the
matrix K, A (amplitude) and the matrix A, z (number of periods) and the coordinate, varphi (polar
angle) and the rotation vector.

Generated from mechproof.derivations.track_wheel with SymPy 1.14.0.
Regenerate with `mechproof regenerate`; edits are overwritten.
"""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from mechproof.kernel_support.arrays import (
    as_floats,
    check_components,
    choose_where,
    in_blocks,
    is_finite,
    nan_outside,
    split_components,
    store,
    sum_axes,
    transform,
)

__all__ = [
    "displacement",
    "displacement_linear",
    "error_sum",
    "error_sum_correlated",
    "error_sum_thermal",
    "planar_error",
    "radius",
    "rotation",
    "spatial_error",
    "track",
]


# Source: Kapitonov, Yakubovsky 2022, equation (14)
# Expression sha256: d71a982fb66d37c4656f056299636ac918608c8569bedbfb43b1f8240b393391
# Form: product C*B*A
# Operations: 28
def rotation(
    alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the matrix K of the turns alpha, beta, gamma: coordinates in the part's frame.

        [cos(beta)*cos(gamma), sin(gamma)*cos(alpha) + sin(alpha)*sin(beta)*cos(gamma),
            sin(alpha)*sin(gamma) - sin(beta)*cos(alpha)*cos(gamma)]
        [-sin(gamma)*cos(beta), cos(alpha)*cos(gamma) - sin(alpha)*sin(beta)*sin(gamma),
            sin(alpha)*cos(gamma) + sin(beta)*sin(gamma)*cos(alpha)]
        [sin(beta), -sin(alpha)*cos(beta), cos(alpha)*cos(beta)]

    Parameters
    ----------
    alpha : array_like, any shape
        Turn about X0 (rad).
    beta : array_like, any shape
        Turn about Y0 (rad).
    gamma : array_like, any shape
        Turn about Z0 (rad).
    out : ndarray, optional
        Where the result goes, of its type and shape; it may overlap an argument.

    Returns
    -------
    ndarray, shape (..., 3, 3)
        The broadcast of the arguments (pure number); float32 if every array argument is
        float32, float64 otherwise.

    Raises
    ------
    TypeError
        If an argument is complex or not numeric, or `out` has another type.
    ValueError
        If shapes do not broadcast, or `out` has another shape.

    Notes
    -----
    Domain: all real arguments.

    Accuracy held by the tests: error <= 7 eps * (1, per entry), eps the spacing of floats at 1.

    Source: Kapitonov, Yakubovsky 2022, equation (14).

    """
    alpha, beta, gamma = as_floats(alpha=alpha, beta=beta, gamma=gamma)
    return in_blocks(_rotation, (alpha,), _prepare_rotation, (beta, gamma), out=out, shape=(3, 3))


def _prepare_rotation(beta: Any, gamma: Any) -> tuple[Any, ...]:
    cos_beta = np.cos(beta)
    cos_gamma = np.cos(gamma)
    sin_gamma = np.sin(gamma)
    sin_beta = np.sin(beta)

    return (cos_beta, cos_gamma, sin_gamma, sin_beta)


def _rotation(alpha: Any, cos_beta: Any, cos_gamma: Any, sin_gamma: Any, sin_beta: Any) -> Any:
    cos_alpha = np.cos(alpha)
    sin_alpha = np.sin(alpha)

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


# Source: Kapitonov, Yakubovsky 2022, equation (15)
# Expression sha256: 4dfab7cda67ee65d4f4ff1e0c18da090d2adcbc8265bb418ce04ea68e141f79a
# Form: (K - I)^T*p + t by tangents of half angles
# Rewrites: name_coefficients
# Operations: 75
def displacement(
    points: ArrayLike, angles: ArrayLike, shift: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the position errors K^T*p - (p - t) of points p, turn K and shift t.

        [a + z_13*sin(beta) + x_13*cos(beta)*cos(gamma) - x_13 - y_13*sin(gamma)*cos(beta)]
        [b + x_13*(sin(gamma)*cos(alpha) + sin(alpha)*sin(beta)*cos(gamma)) +
            y_13*(cos(alpha)*cos(gamma) - sin(alpha)*sin(beta)*sin(gamma)) - y_13 -
            z_13*sin(alpha)*cos(beta)]
        [c + x_13*(sin(alpha)*sin(gamma) - sin(beta)*cos(alpha)*cos(gamma)) +
            y_13*(sin(alpha)*cos(gamma) + sin(beta)*sin(gamma)*cos(alpha)) +
            z_13*cos(alpha)*cos(beta) - z_13]

    Parameters
    ----------
    points : array_like, shape (..., 3)
        Points in the part's frame (mm).
    angles : array_like, shape (..., 3)
        Turns about X0, Y0 and Z0, in this order (rad).
    shift : array_like, shape (..., 3)
        Shift of the part along X0, Y0 and Z0 (mm).
    out : ndarray, optional
        Where the result goes, of its type and shape; it may overlap an argument.

    Returns
    -------
    ndarray, shape (..., 3)
        The broadcast of the arguments (mm); float32 if every array argument is float32, float64
        otherwise.

    Raises
    ------
    TypeError
        If an argument is complex or not numeric, or `out` has another type.
    ValueError
        If the last axis of points or angles or shift is wrong, shapes do not broadcast, or
        `out` has another shape.

    Notes
    -----
    Domain: all real arguments.

    Accuracy held by the tests: error <= 13.5108 eps * (|K - I|*|p| + |t|, norm of the error),
    eps the spacing of floats at 1.

    Source: Kapitonov, Yakubovsky 2022, equation (15).

    """
    points, angles, shift = as_floats(points=points, angles=angles, shift=shift)
    check_components("points", points, 3)
    alpha, beta, gamma = split_components("angles", angles, 3)
    a, b, c = split_components("shift", shift, 3)
    return transform(points, _displacement, (alpha, beta, gamma, a, b, c), out=out)


def _displacement(alpha: Any, beta: Any, gamma: Any, a: Any, b: Any, c: Any) -> tuple[Any, ...]:
    t_alpha = np.tan(alpha / 2)
    t_beta = np.tan(beta / 2)
    t_gamma = np.tan(gamma / 2)
    scale = 2 / ((1 + t_alpha**2) * (1 + t_beta**2) * (1 + t_gamma**2))
    v_y = t_beta - t_alpha * t_gamma
    v_y_squared = v_y**2
    v_z = t_gamma + t_alpha * t_beta
    v_z_squared = v_z**2
    C11 = scale * (-v_y_squared - v_z_squared)
    v_x = t_alpha + t_beta * t_gamma
    v_x_v_y = v_x * v_y
    w = 1 - t_alpha * t_beta * t_gamma
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

    return (C11, C12, C13, C21, C22, C23, C31, C32, C33, a, b, c)


# Source: linearised from Kapitonov, Yakubovsky 2022, equation (15)
# Expression sha256: e58ef8fa94509c948da8a770d7047ec06cfe8ee2caab9cf1d24ca425f8c0f01e
# Form: first order in the angles
# Operations: 12
def displacement_linear(
    points: ArrayLike, angles: ArrayLike, shift: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the position errors to first order in the angles.

        [a + z_13*sin(beta) + x_13*cos(beta)*cos(gamma) - x_13 - y_13*sin(gamma)*cos(beta)]
        [b + x_13*(sin(gamma)*cos(alpha) + sin(alpha)*sin(beta)*cos(gamma)) +
            y_13*(cos(alpha)*cos(gamma) - sin(alpha)*sin(beta)*sin(gamma)) - y_13 -
            z_13*sin(alpha)*cos(beta)]
        [c + x_13*(sin(alpha)*sin(gamma) - sin(beta)*cos(alpha)*cos(gamma)) +
            y_13*(sin(alpha)*cos(gamma) + sin(beta)*sin(gamma)*cos(alpha)) +
            z_13*cos(alpha)*cos(beta) - z_13]

    Parameters
    ----------
    points : array_like, shape (..., 3)
        Points in the part's frame (mm).
    angles : array_like, shape (..., 3)
        Turns about X0, Y0 and Z0, in this order (rad).
    shift : array_like, shape (..., 3)
        Shift of the part along X0, Y0 and Z0 (mm).
    out : ndarray, optional
        Where the result goes, of its type and shape; it may overlap an argument.

    Returns
    -------
    ndarray, shape (..., 3)
        The broadcast of the arguments (mm); float32 if every array argument is float32, float64
        otherwise.

    Raises
    ------
    TypeError
        If an argument is complex or not numeric, or `out` has another type.
    ValueError
        If the last axis of points or angles or shift is wrong, shapes do not broadcast, or
        `out` has another shape.

    Notes
    -----
    Domain: all real arguments.

    Approximation, first order in the angles: |result - exact| <= sqrt(x_13**2 + y_13**2 +
    z_13**2)*(Abs(alpha) + Abs(beta) + Abs(gamma))**2/2, rounding apart.

    Accuracy held by the tests: error <= 8 eps * ((|alpha| + |beta| + |gamma|)*|p| + |t|, norm
    of the rounding error), eps the spacing of floats at 1.

    Source: linearised from Kapitonov, Yakubovsky 2022, equation (15).

    """
    points, angles, shift = as_floats(points=points, angles=angles, shift=shift)
    check_components("points", points, 3)
    alpha, beta, gamma = split_components("angles", angles, 3)
    a, b, c = split_components("shift", shift, 3)
    return transform(points, _displacement_linear, (alpha, beta, gamma, a, b, c), out=out)


def _displacement_linear(
    alpha: Any, beta: Any, gamma: Any, a: Any, b: Any, c: Any
) -> tuple[Any, ...]:

    return (0, -gamma, beta, gamma, 0, -alpha, -beta, alpha, 0, a, b, c)


# Source: Kapitonov, Yakubovsky 2022, equation (16)
# Expression sha256: bcc8d5b79cb3045914e1969c5fd6ba7254aa274323f55489839dfbd98d6309d7
# Form: conjugate root
# Rewrites: conjugate_root
# Operations: 13
def radius(
    phi: ArrayLike, R: ArrayLike, A: ArrayLike, z: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the radius vector of the track, a shifted circle repeated z times.

        radius = A*cos(phi*z) + sqrt(R**2 - A**2*sin(phi*z)**2)

    Parameters
    ----------
    phi : array_like, any shape
        Polar angle (rad).
    R : array_like, any shape
        Radius of the shifted circle (mm).
    A : array_like, any shape
        Shift of the circle, amplitude of the track (mm).
    z : array_like, any shape
        Number of periods, a natural number (pure number).
    out : ndarray, optional
        Where the result goes, of its type and shape; it may overlap an argument.

    Returns
    -------
    ndarray or NumPy scalar
        The broadcast of the arguments (mm); float32 if every array argument is float32, float64
        otherwise.

    Raises
    ------
    TypeError
        If an argument is complex or not numeric, or `out` has another type.
    ValueError
        If shapes do not broadcast, or `out` has another shape.

    Notes
    -----
    Domain: 0 < R < oo, 1 <= z < oo, z = floor(z), A <= R, Abs(A) <= R (|A| <= R, A of either
    sign).

    Outside it the result is NaN, by way of R.

    Accuracy held by the tests: error <= 6 eps * (|value| + |phi * d value/d phi|), eps the
    spacing of floats at 1.

    Source: Kapitonov, Yakubovsky 2022, equation (16).

    """
    phi, R, A, z = as_floats(phi=phi, R=R, A=A, z=z)
    inside = (
        (R > 0)
        & is_finite(R)
        & (z >= 1)
        & is_finite(z)
        & (z == np.floor(z))
        & (A <= R)
        & (np.abs(A) <= R)
    )
    R = nan_outside(R, inside)
    return in_blocks(_radius, (phi,), _prepare_radius, (R, A, z), out=out)


def _prepare_radius(R: Any, A: Any, z: Any) -> tuple[Any, ...]:
    A_plus_R = A + R
    R_minus_A = R - A
    w = A_plus_R * R_minus_A

    return (A, z, w)


def _radius(phi: Any, A: Any, z: Any, w: Any) -> Any:
    u = A * np.cos(z * phi)
    q = np.abs(u) + np.hypot(np.sqrt(w), u)

    return choose_where(u >= 0, q, w / q)


# Source: Kapitonov, Yakubovsky 2022, equation (16)
# Expression sha256: 2b587a728eeac7d4234ec241f2e8f065649a9cbcf7994471b0fcb3b523bca0d7
# Form: conjugate root
# Rewrites: conjugate_root
# Operations: 17
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

        [(A*cos(phi*z) + sqrt(R**2 - A**2*sin(phi*z)**2))*cos(phi)]
        [(A*cos(phi*z) + sqrt(R**2 - A**2*sin(phi*z)**2))*sin(phi)]
        [H]

    Parameters
    ----------
    phi : array_like, any shape
        Polar angle (rad).
    R : array_like, any shape
        Radius of the shifted circle (mm).
    A : array_like, any shape
        Shift of the circle, amplitude of the track (mm).
    z : array_like, any shape
        Number of periods, a natural number (pure number).
    H : array_like, any shape
        Thickness of the part (mm).
    out : ndarray, optional
        Where the result goes, of its type and shape; it may overlap an argument.

    Returns
    -------
    ndarray, shape (..., 3)
        The broadcast of the arguments (mm); float32 if every array argument is float32, float64
        otherwise.

    Raises
    ------
    TypeError
        If an argument is complex or not numeric, or `out` has another type.
    ValueError
        If shapes do not broadcast, or `out` has another shape.

    Notes
    -----
    Domain: 0 < R < oo, 0 < H < oo, 1 <= z < oo, z = floor(z), A <= R, Abs(A) <= R (|A| <= R, A
    of either sign).

    Outside it the result is NaN, by way of R and H.

    Accuracy held by the tests: error <= 7.5 eps * (|value| + |phi * d value/d phi|), eps the
    spacing of floats at 1.

    Source: Kapitonov, Yakubovsky 2022, equation (16).

    """
    phi, R, A, z, H = as_floats(phi=phi, R=R, A=A, z=z, H=H)
    inside = (
        (R > 0)
        & is_finite(R)
        & (H > 0)
        & is_finite(H)
        & (z >= 1)
        & is_finite(z)
        & (z == np.floor(z))
        & (A <= R)
        & (np.abs(A) <= R)
    )
    R = nan_outside(R, inside)
    H = nan_outside(H, inside)
    return in_blocks(_track, (phi,), _prepare_track, (R, A, z, H), out=out, shape=(3,))


def _prepare_track(R: Any, A: Any, z: Any, H: Any) -> tuple[Any, ...]:
    A_plus_R = A + R
    R_minus_A = R - A
    w = A_plus_R * R_minus_A

    return (A, z, H, w)


def _track(phi: Any, A: Any, z: Any, H: Any, w: Any) -> Any:
    u = A * np.cos(z * phi)
    q = np.abs(u) + np.hypot(np.sqrt(w), u)
    term = choose_where(u >= 0, q, w / q)

    return (
        term * np.cos(phi),
        term * np.sin(phi),
        H,
    )


# Source: Kapitonov, Yakubovsky 2022, equation (17)
# Expression sha256: 14e4884bac83d19c6b82566fa55a54b132dd8f49b74bb0324b329bfab95547d3
# Form: hypot
# Rewrites: hypotenuse
# Operations: 1
def planar_error(displacement: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the error in the end plane X0Y0.

        planar_error = sqrt(Delta_x0**2 + Delta_y0**2)

    Parameters
    ----------
    displacement : array_like, shape (..., 3)
        Position errors along X0, Y0 and Z0 (mm).
    out : ndarray, optional
        Where the result goes, of its type and shape; it may overlap an argument.

    Returns
    -------
    ndarray or NumPy scalar
        The broadcast of the arguments (mm); float32 if every array argument is float32, float64
        otherwise.

    Raises
    ------
    TypeError
        If an argument is complex or not numeric, or `out` has another type.
    ValueError
        If the last axis of displacement is wrong, shapes do not broadcast, or `out` has another
        shape.

    Notes
    -----
    Domain: all real arguments.

    Accuracy held by the tests: error <= 1 eps * (the value), eps the spacing of floats at 1.

    Source: Kapitonov, Yakubovsky 2022, equation (17).

    """
    (displacement,) = as_floats(displacement=displacement)
    Delta_x0, Delta_y0, _ = split_components("displacement", displacement, 3)
    return in_blocks(_planar_error, (Delta_x0, Delta_y0), out=out)


def _planar_error(Delta_x0: Any, Delta_y0: Any) -> Any:

    return np.hypot(Delta_x0, Delta_y0)


# Source: Kapitonov, Yakubovsky 2022, equation (18)
# Expression sha256: 704a84eb6694283854149d86d68ea5fc31a8c9f3d765f5e35bf9b26a42c607fe
# Form: hypot
# Rewrites: hypotenuse
# Operations: 2
def spatial_error(displacement: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the error in space.

        spatial_error = sqrt(Delta_x0**2 + Delta_y0**2 + Delta_z0**2)

    Parameters
    ----------
    displacement : array_like, shape (..., 3)
        Position errors along X0, Y0 and Z0 (mm).
    out : ndarray, optional
        Where the result goes, of its type and shape; it may overlap an argument.

    Returns
    -------
    ndarray or NumPy scalar
        The broadcast of the arguments (mm); float32 if every array argument is float32, float64
        otherwise.

    Raises
    ------
    TypeError
        If an argument is complex or not numeric, or `out` has another type.
    ValueError
        If the last axis of displacement is wrong, shapes do not broadcast, or `out` has another
        shape.

    Notes
    -----
    Domain: all real arguments.

    Accuracy held by the tests: error <= 2 eps * (the value), eps the spacing of floats at 1.

    Source: Kapitonov, Yakubovsky 2022, equation (18).

    """
    (displacement,) = as_floats(displacement=displacement)
    Delta_x0, Delta_y0, Delta_z0 = split_components("displacement", displacement, 3)
    return in_blocks(_spatial_error, (Delta_x0, Delta_y0, Delta_z0), out=out)


def _spatial_error(Delta_x0: Any, Delta_y0: Any, Delta_z0: Any) -> Any:

    return np.hypot(np.hypot(Delta_x0, Delta_y0), Delta_z0)


# Source: Kapitonov, Yakubovsky 2022, equation (3) with its indices corrected
# Expression sha256: cabb146df9ac945efdf19badb63ac910a66d59ef35a80f3a4e78ddda5801624f
# Form: double sum
# Operations: 10
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

        error_sum_correlated = sqrt(Sum[i=1..n, j=1..n](K_i[i]*K_i[j]*R_ij[i,
            j]*S_i[i]*S_i[j]*T_i[i]*T_i[j]))/total_scatter

    Parameters
    ----------
    tolerances : array_like, shape (..., n)
        Tolerances of the elementary errors (mm).
    sensitivities : array_like, shape (..., n)
        Sensitivity of the total to each error (pure number).
    scatters : array_like, shape (..., n)
        Relative-scatter coefficient of each error (pure number).
    correlation : array_like, shape (..., n, n)
        Correlation matrix: symmetric, positive semi-definite, ones on its diagonal (pure
        number).
    total_scatter : array_like, any shape
        Relative-scatter coefficient of the total (pure number).
    out : ndarray, optional
        Where the result goes, of its type and shape; it may overlap an argument.

    Returns
    -------
    ndarray or NumPy scalar
        The broadcast of the arguments (mm); float32 if every array argument is float32, float64
        otherwise.

    Raises
    ------
    TypeError
        If an argument is complex or not numeric, or `out` has another type.
    ValueError
        If the last axis of tolerances or sensitivities or scatters or correlation is wrong,
        shapes do not broadcast, or `out` has another shape.

    Notes
    -----
    Domain: 0 < total_scatter < oo, 0 < K_i[i] < oo, -1 <= R_ij[i, j], R_ij[i, j] <= 1, 0 <=
    T_i[i] < oo, R_ij[i, i] = 1, R_ij[i, j] = R_ij[j, i] (a symmetric matrix with ones on its
    diagonal).

    Outside it the result is NaN, by way of total_scatter.

    Singular: where a singular correlation matrix makes the sum vanish, rounding may leave it
    negative and the result NaN.

    Singular: squares of tolerances, sensitivities and scatters are added: of sizes beyond 1e-50
    to 1e50 they may leave the range of doubles, and the result is infinite, NaN or too small.

    Accuracy held by the tests: error <= 8 eps * (|value| + sum |terms under the
    root|/(K**2*|value|), n <= 11, factors 0 or 1e-50 to 1e50 in size), eps the spacing of
    floats at 1.

    Source: Kapitonov, Yakubovsky 2022, equation (3) with its indices corrected.

    """
    tolerances, sensitivities, scatters, correlation, total_scatter = as_floats(
        tolerances=tolerances,
        sensitivities=sensitivities,
        scatters=scatters,
        correlation=correlation,
        total_scatter=total_scatter,
    )
    tolerances, sensitivities, scatters, correlation = sum_axes(
        tolerances=(tolerances, 1),
        sensitivities=(sensitivities, 1),
        scatters=(scatters, 1),
        correlation=(correlation, 2),
    )
    inside = (
        (total_scatter > 0)
        & is_finite(total_scatter)
        & np.all(scatters > 0, axis=-1)
        & np.all(is_finite(scatters), axis=-1)
        & np.all(correlation >= -1, axis=(-2, -1))
        & np.all(correlation <= 1, axis=(-2, -1))
        & np.all(tolerances >= 0, axis=-1)
        & np.all(is_finite(tolerances), axis=-1)
        & np.all(np.diagonal(correlation, axis1=-2, axis2=-1) == 1, axis=-1)
        & np.all(correlation == np.swapaxes(correlation, -1, -2), axis=(-2, -1))
    )
    total_scatter = nan_outside(total_scatter, inside)

    return store(
        np.sqrt(
            np.sum(
                sensitivities[..., :, np.newaxis]
                * sensitivities[..., np.newaxis, :]
                * correlation
                * scatters[..., :, np.newaxis]
                * scatters[..., np.newaxis, :]
                * tolerances[..., :, np.newaxis]
                * tolerances[..., np.newaxis, :],
                axis=(-2, -1),
            )
        )
        / total_scatter,
        out,
    )


# Source: Kapitonov, Yakubovsky 2022, equation (5) with sensitivities
# Expression sha256: 124fe9776da9a22b0a1543e256cf859710b148c89e99d34be9d859f263442e06
# Form: sum of squares
# Operations: 9
def error_sum(
    tolerances: ArrayLike,
    sensitivities: ArrayLike,
    scatters: ArrayLike,
    total_scatter: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute the total error of independent elementary errors.

        error_sum = sqrt(Sum[i=1..n](K_i[i]**2*S_i[i]**2*T_i[i]**2))/total_scatter

    Parameters
    ----------
    tolerances : array_like, shape (..., n)
        Tolerances of the elementary errors (mm).
    sensitivities : array_like, shape (..., n)
        Sensitivity of the total to each error (pure number).
    scatters : array_like, shape (..., n)
        Relative-scatter coefficient of each error (pure number).
    total_scatter : array_like, any shape
        Relative-scatter coefficient of the total (pure number).
    out : ndarray, optional
        Where the result goes, of its type and shape; it may overlap an argument.

    Returns
    -------
    ndarray or NumPy scalar
        The broadcast of the arguments (mm); float32 if every array argument is float32, float64
        otherwise.

    Raises
    ------
    TypeError
        If an argument is complex or not numeric, or `out` has another type.
    ValueError
        If the last axis of tolerances or sensitivities or scatters is wrong, shapes do not
        broadcast, or `out` has another shape.

    Notes
    -----
    Domain: 0 < total_scatter < oo, 0 < K_i[i] < oo, 0 <= T_i[i] < oo (tolerances from zero on).

    Outside it the result is NaN, by way of total_scatter.

    Singular: squares of tolerances, sensitivities and scatters are added: of sizes beyond 1e-50
    to 1e50 they may leave the range of doubles, and the result is infinite, NaN or too small.

    Accuracy held by the tests: error <= 7 eps * (the value, n <= 128, factors 0 or 1e-50 to
    1e50 in size), eps the spacing of floats at 1.

    Source: Kapitonov, Yakubovsky 2022, equation (5) with sensitivities.

    """
    tolerances, sensitivities, scatters, total_scatter = as_floats(
        tolerances=tolerances,
        sensitivities=sensitivities,
        scatters=scatters,
        total_scatter=total_scatter,
    )
    tolerances, sensitivities, scatters = sum_axes(
        tolerances=(tolerances, 1), sensitivities=(sensitivities, 1), scatters=(scatters, 1)
    )
    inside = (
        (total_scatter > 0)
        & is_finite(total_scatter)
        & np.all(scatters > 0, axis=-1)
        & np.all(is_finite(scatters), axis=-1)
        & np.all(tolerances >= 0, axis=-1)
        & np.all(is_finite(tolerances), axis=-1)
    )
    total_scatter = nan_outside(total_scatter, inside)

    return store(
        np.sqrt(np.sum(sensitivities**2 * scatters**2 * tolerances**2, axis=-1)) / total_scatter,
        out,
    )


# Source: Kapitonov, Yakubovsky 2022, equation (6) made homogeneous, Table 1 for the share
# Expression sha256: 91ab685c9f759455fbdf90eed88ca09861cc8c6a9e0067c0332fb8d2f72f3734
# Form: solved for the total
# Rewrites: difference_of_squares
# Operations: 16
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

        error_sum_thermal =
            sqrt(Sum[i=1..n](K_i[i]**2*S_i[i]**2*T_i[i]**2))/sqrt(total_scatter**2 -
            thermal_scatter**2*thermal_share**2)

    Parameters
    ----------
    tolerances : array_like, shape (..., n)
        Tolerances of the elementary errors (mm).
    sensitivities : array_like, shape (..., n)
        Sensitivity of the total to each error (pure number).
    scatters : array_like, shape (..., n)
        Relative-scatter coefficient of each error (pure number).
    total_scatter : array_like, any shape
        Relative-scatter coefficient of the total (pure number).
    thermal_share : array_like, any shape
        Temperature error over total error (pure number).
    thermal_scatter : array_like, any shape
        Relative-scatter coefficient of the temperature error (pure number).
    out : ndarray, optional
        Where the result goes, of its type and shape; it may overlap an argument.

    Returns
    -------
    ndarray or NumPy scalar
        The broadcast of the arguments (mm); float32 if every array argument is float32, float64
        otherwise.

    Raises
    ------
    TypeError
        If an argument is complex or not numeric, or `out` has another type.
    ValueError
        If the last axis of tolerances or sensitivities or scatters is wrong, shapes do not
        broadcast, or `out` has another shape.

    Notes
    -----
    Domain: 0 < total_scatter < oo, 0 < K_i[i] < oo, 0 < thermal_scatter < oo, 0 <= T_i[i] < oo,
    0 <= thermal_share < oo, thermal_scatter*thermal_share < total_scatter (the temperature
    error below the total).

    Outside it the result is NaN, by way of total_scatter.

    Singular: squares of tolerances, sensitivities and scatters are added: of sizes beyond 1e-50
    to 1e50 they may leave the range of doubles, and the result is infinite, NaN or too small.

    Accuracy held by the tests: error <= 9 eps * (the value*K/(K - K_T*thermal), n <= 128,
    factors 0 or 1e-50 to 1e50 in size), eps the spacing of floats at 1.

    Source: Kapitonov, Yakubovsky 2022, equation (6) made homogeneous, Table 1 for the share.

    """
    tolerances, sensitivities, scatters, total_scatter, thermal_share, thermal_scatter = as_floats(
        tolerances=tolerances,
        sensitivities=sensitivities,
        scatters=scatters,
        total_scatter=total_scatter,
        thermal_share=thermal_share,
        thermal_scatter=thermal_scatter,
    )
    tolerances, sensitivities, scatters = sum_axes(
        tolerances=(tolerances, 1), sensitivities=(sensitivities, 1), scatters=(scatters, 1)
    )
    inside = (
        (total_scatter > 0)
        & is_finite(total_scatter)
        & np.all(scatters > 0, axis=-1)
        & np.all(is_finite(scatters), axis=-1)
        & (thermal_scatter > 0)
        & is_finite(thermal_scatter)
        & np.all(tolerances >= 0, axis=-1)
        & np.all(is_finite(tolerances), axis=-1)
        & (thermal_share >= 0)
        & is_finite(thermal_share)
        & (thermal_scatter * thermal_share < total_scatter)
    )
    total_scatter = nan_outside(total_scatter, inside)

    K_minus_K_T_tau = total_scatter - thermal_scatter * thermal_share
    K_plus_K_T_tau = total_scatter + thermal_scatter * thermal_share

    return store(
        np.sqrt(np.sum(sensitivities**2 * scatters**2 * tolerances**2, axis=-1))
        / np.sqrt(K_minus_K_T_tau * K_plus_K_T_tau),
        out,
    )
