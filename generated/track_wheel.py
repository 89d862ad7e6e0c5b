"""Kernels of the system `track_wheel`.

Kapitonov, Yakubovsky 2022, machining error of a wheel with a multi-period track, doi
10.24412/2079-7958-2022-1-43-52

Lengths in mm, angles in radians, turns counter-clockwise positive. The matrices give
coordinates in the turned frame. Letters that the paper uses twice are kept apart: K
(scatter coefficient) and the matrix K, A (amplitude) and the matrix A, z (number of
periods) and the coordinate, varphi (polar angle) and the rotation vector.

Arguments broadcast. The result is a NumPy scalar if all arguments are scalars, otherwise an
array; it is float32 if every array argument is float32, otherwise float64. `out`, an array
of the result's type and shape, receives the result; it may overlap an argument. The result
is NaN outside the domain and where an argument is NaN; in a domain numpy.pi counts as pi.

TypeError: an argument is complex or not numeric, or `out` is not an array of the result's
type. ValueError: shapes do not broadcast, a last axis is wrong, or `out` has another shape.

Accuracy is tested: on the stated arguments no search has found a larger error. It is that
of float64, in which float32 is computed, too; eps = 2**-52.

A proved bound holds for all arguments stated in its line, in float64 rounded to nearest, on
the assumptions of that line. These speak of the results of all intermediate operations; the
normal range is 0 and everything of at least 2**-1022 in size. A proved bound may be larger
than a tested one, since a proof adds up roundings that may never occur together.

What errors are relative to:

    root = sqrt(R**2 - A**2*sin(phi*z)**2)
    rho = root + A*cos(phi*z)

    the largest size of an entry (rotation) = 1

    the sizes of turn and shift, for the norm of the error (displacement) = |t| + |K-I|*|p|
    u_x = sin(alpha/2)*cos(beta/2)*cos(gamma/2) + sin(beta/2)*sin(gamma/2)*cos(alpha/2)
    u_y = sin(beta/2)*cos(alpha/2)*cos(gamma/2) - sin(alpha/2)*sin(gamma/2)*cos(beta/2)
    u_z = sin(alpha/2)*sin(beta/2)*cos(gamma/2) + sin(gamma/2)*cos(alpha/2)*cos(beta/2)
    |K-I| = 2*sqrt(u_x**2 + u_y**2 + u_z**2)
    |p| = sqrt(x_13**2 + y_13**2 + z_13**2)
    |t| = sqrt(a**2 + b**2 + c**2)

    the radius and the effect of eps*z*phi (radius) = (1 + z*|A*phi*sin(phi*z)/root|)*|rho|

    the radius and the effect of eps*z*phi (track) = (1 + z*|A*phi*sin(phi*z)/root|)*|rho|

    the value and what the sizes of the terms make of it (error_sum_correlated) = value +
        Sum[i=1..n, j=1..n](|correlation[i,j]*sensitivities[i]*sensitivities[j]|*
        scatters[i]*scatters[j]*tolerances[i]*tolerances[j])/(total_scatter**2*value)
    value = sqrt(Sum[i=1..n, j=1..n](scatters[i]*scatters[j]*correlation[i,j]*
        sensitivities[i]*sensitivities[j]*tolerances[i]*tolerances[j]))/total_scatter

    the value times the condition of its denominator (error_sum_thermal) = value +
        thermal_scatter*thermal_share*value/(total_scatter - thermal_scatter*thermal_share)
    value = sqrt(Sum[i=1..n](scatters[i]**2*sensitivities[i]**2*tolerances[i]**2))/
        sqrt(total_scatter**2 - thermal_scatter**2*thermal_share**2)

    the tilt and the effect of eps*(error - offset) (tilt_of_planar_error) = (error -
        offset)/sqrt(H**2 + 2*rho*(error - offset) - (error - offset)**2) + 2*atan2(error -
        offset, H + sqrt(H**2 + 2*rho*(error - offset) - (error - offset)**2))

    the tilt and the effect of eps*(error - offset) (tilt_of_spatial_error) = 2*error*(error
        - offset)/sqrt(4*H**2*offset**2 + (error - offset)*(error + offset)*(4*H**2 +
        4*rho**2 + 4*offset*rho - (error - offset)*(error + offset))) + 2*atan2((error -
        offset)*(error + offset), 2*H*offset + sqrt(4*H**2*offset**2 + (error -
        offset)*(error + offset)*(4*H**2 + 4*rho**2 + 4*offset*rho - (error - offset)*(error
        + offset))))

Generated from the derivation track_wheel with SymPy 1.14.0.
Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""

from __future__ import annotations

from builtins import abs as _abs
from typing import Any

import numpy as _np
from numpy.typing import ArrayLike, NDArray

from mechproof.kernel_support.arrays import (
    as_floats as _as_floats,
    check_components as _check_components,
    split_components as _split_components,
    sum_axes as _sum_axes,
)
from mechproof.kernel_support.blocks import (
    in_blocks as _in_blocks,
    quietly as _quietly,
    store as _store,
    transform as _transform,
)
from mechproof.kernel_support.domains import (
    every as _every,
    is_finite as _is_finite,
    is_nonnegative as _is_nonnegative,
    is_positive as _is_positive,
    nan_outside as _nan_outside,
)
from mechproof.kernel_support.facts import Condition as _Condition, Sizes as _Sizes
from mechproof.kernel_support.functions import (
    add_up as _add_up,
    choose_where as _choose_where,
    floor as _floor,
    hypot as _hypot,
    nonnegative_form as _nonnegative_form,
    square as _square,
)

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

DOMAIN = (
    _Condition(
        "R",
        "0 < R < oo",
        ("R",),
        lambda R: (R > 0) & _is_finite(R),
        ("radius", "track", "largest_radius", "smallest_radius"),
    ),
    _Condition(
        "z",
        "1 <= z < oo, z = floor(z)",
        ("z",),
        lambda z: (z >= 1) & _is_finite(z) & (z == _floor(z)),
        ("radius", "track"),
    ),
    _Condition(
        "A",
        "|A| <= R",
        ("R", "A"),
        lambda R, A: _abs(A) <= R,
        ("radius", "track", "largest_radius", "smallest_radius"),
    ),
    _Condition(
        "H",
        "0 < H < oo",
        ("H",),
        lambda H: (H > 0) & _is_finite(H),
        ("track", "tilt_of_planar_error", "tilt_of_spatial_error"),
    ),
    _Condition(
        "total_scatter",
        "0 < total_scatter < oo",
        ("total_scatter",),
        lambda total_scatter: (total_scatter > 0) & _is_finite(total_scatter),
        ("error_sum_correlated", "error_sum", "error_sum_thermal"),
    ),
    _Condition(
        "thermal_scatter",
        "0 < thermal_scatter < oo",
        ("thermal_scatter",),
        lambda thermal_scatter: (thermal_scatter > 0) & _is_finite(thermal_scatter),
        ("error_sum_thermal",),
    ),
    _Condition(
        "thermal_share",
        "0 <= thermal_share < oo",
        ("thermal_share",),
        lambda thermal_share: (thermal_share >= 0) & _is_finite(thermal_share),
        ("error_sum_thermal",),
    ),
    _Condition(
        "thermal_scatter",
        "thermal_scatter*thermal_share < total_scatter",
        ("total_scatter", "thermal_share", "thermal_scatter"),
        lambda total_scatter, thermal_share, thermal_scatter: (
            thermal_share * thermal_scatter < total_scatter
        ),
        ("error_sum_thermal",),
    ),
    _Condition(
        "rho",
        "0 < rho < oo",
        ("rho",),
        lambda rho: (rho > 0) & _is_finite(rho),
        ("tilt_of_planar_error", "tilt_of_spatial_error"),
    ),
    _Condition(
        "error",
        "0 < error < oo",
        ("error",),
        lambda error: (error > 0) & _is_finite(error),
        ("tilt_of_planar_error",),
    ),
    _Condition(
        "offset",
        "0 <= offset < oo",
        ("offset",),
        lambda offset: (offset >= 0) & _is_finite(offset),
        ("tilt_of_planar_error", "tilt_of_spatial_error"),
    ),
    _Condition(
        "error",
        "0 <= error - offset",
        ("error", "offset"),
        lambda error, offset: error - offset >= 0,
        ("tilt_of_planar_error",),
    ),
    _Condition(
        "error",
        "error - offset <= H + rho",
        ("error", "offset", "rho", "H"),
        lambda error, offset, rho, H: error - offset <= H + rho,
        ("tilt_of_planar_error",),
    ),
    _Condition(
        "error",
        "0 < error < oo",
        ("error",),
        lambda error: (error > 0) & _is_finite(error),
        ("tilt_of_spatial_error",),
    ),
    _Condition(
        "offset",
        "offset <= error",
        ("error", "offset"),
        lambda error, offset: offset <= error,
        ("tilt_of_spatial_error",),
    ),
    _Condition(
        "error",
        "(error - offset)*(error + offset) <= 2*H**2 + 2*rho**2 + 2*H*offset + 2*offset*rho",
        ("error", "offset", "rho", "H"),
        lambda error, offset, rho, H: (
            (error + offset) * (error - offset)
            <= 2 * _square(H) + 2 * _square(rho) + 2 * offset * H + 2 * offset * rho
        ),
        ("tilt_of_spatial_error",),
    ),
)
PUBLISHED = (
    _Sizes(
        "Table 1",
        {
            "R": 41.5,
            "A": 3.75,
            "alpha": 0.00103,
            "beta": 0.00103,
            "gamma": 0.0,
            "thermal_share": 0.15,
        },
        (),
    ),
)


def __dir__() -> list[str]:
    return __all__


# Source: Kapitonov, Yakubovsky 2022, equation (14)
# Expressions sha256: d71a982fb66d37c4656f056299636ac918608c8569bedbfb43b1f8240b393391
# Form: printed (14)
# Operations: 28
def rotation(
    alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
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

    Returns
    -------
    ndarray, shape (..., 3, 3) (pure number)

    Notes
    -----
    Domain: all real arguments.

    Accuracy, tested: 7 eps of the largest size of an entry.

    Proved, where |alpha|, |beta|, |gamma| <= 22/7, as long as no result overflows or falls
    below the normal range: at most 4.66 eps with np.cos within 1 ulp and np.sin within 1 ulp,
    found 1.6; at most 3.28 eps compiled, found 2.01.

    Source: Kapitonov, Yakubovsky 2022, equation (14).

    """
    alpha, beta, gamma = _as_floats("alpha beta gamma", alpha, beta, gamma)
    return _in_blocks(
        _form_of_rotation, (alpha,), _prepare_of_rotation, (beta, gamma), out=out, shape=(3, 3)
    )


def _prepare_of_rotation(beta: Any, gamma: Any) -> tuple[Any, ...]:
    cos_beta = _np.cos(beta)
    cos_gamma = _np.cos(gamma)
    sin_gamma = _np.sin(gamma)
    sin_beta = _np.sin(beta)

    return (cos_beta, cos_gamma, sin_gamma, sin_beta)


def _form_of_rotation(
    alpha: Any, cos_beta: Any, cos_gamma: Any, sin_gamma: Any, sin_beta: Any
) -> Any:
    cos_alpha = _np.cos(alpha)
    sin_alpha = _np.sin(alpha)

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
# Expressions sha256: a36e62589851939cefe7ea25c3e3f1a4ddde4e21b8e0b25adcc789b9c1424f92
# Form: (K - I)^T*p + t by tangents of half angles
# Rewrites: name_coefficients
# Operations: 50
def displacement(
    points: ArrayLike, angles: ArrayLike, shift: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
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

    Returns
    -------
    ndarray, shape (..., 3) (mm)

    Notes
    -----
    Domain: all real arguments.

    Accuracy, tested: 9 eps of the sizes of turn and shift, for the norm of the error.

    Proved, where |alpha|, |beta|, |gamma| <= 11/7, as long as no result overflows or falls
    below the normal range: at most 7.83 eps with np.tan within 1 ulp and np.matmul by products
    and their sums in any order, found 5.67; at most 7.58 eps compiled, found 5.08.

    Source: Kapitonov, Yakubovsky 2022, equation (15).

    """
    points, angles, shift = _as_floats("points angles shift", points, angles, shift, axes=(1, 1, 1))
    _check_components("points", points, 3)
    alpha, beta, gamma = _split_components("angles", angles, 3)
    a, b, c = _split_components("shift", shift, 3)
    return _transform(points, _prepare_of_displacement, (alpha, beta, gamma, a, b, c), out=out)


def _prepare_of_displacement(
    alpha: Any, beta: Any, gamma: Any, a: Any, b: Any, c: Any
) -> tuple[Any, ...]:
    t_alpha = _np.tan(alpha / 2.0)
    t_beta = _np.tan(beta / 2.0)
    t_gamma = _np.tan(gamma / 2.0)
    v_x = t_alpha + t_beta * t_gamma
    v_x_squared = _square(v_x)
    v_y = t_beta - t_alpha * t_gamma
    v_y_squared = _square(v_y)
    v_z = t_gamma + t_alpha * t_beta
    v_z_squared = _square(v_z)
    w = 1.0 - t_alpha * t_beta * t_gamma
    scale = 2.0 / (v_x_squared + v_y_squared + v_z_squared + _square(w))
    C11 = scale * (-v_y_squared - v_z_squared)
    s_x = scale * v_x
    s_x_v_y = s_x * v_y
    s_z = scale * v_z
    C12 = s_x_v_y - s_z * w
    s_x_v_z = s_x * v_z
    s_y = scale * v_y
    C13 = s_x_v_z + s_y * w
    C21 = s_x_v_y + s_z * w
    C22 = scale * (-v_x_squared - v_z_squared)
    s_y_v_z = s_y * v_z
    C23 = s_y_v_z - s_x * w
    C31 = s_x_v_z - s_y * w
    C32 = s_y_v_z + s_x * w
    C33 = scale * (-v_x_squared - v_y_squared)

    return (C11, C12, C13, C21, C22, C23, C31, C32, C33, a, b, c)


# Source: Kapitonov, Yakubovsky 2022, equation (17)
# Expressions sha256: 14e4884bac83d19c6b82566fa55a54b132dd8f49b74bb0324b329bfab95547d3
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

    Returns
    -------
    ndarray or NumPy scalar (mm)

    Notes
    -----
    Domain: all real arguments.

    Accuracy, tested: 1 eps of the value.

    Proved, as long as no result overflows or falls below the normal range: at most 1.01 eps
    with np.hypot within 1 ulp, found 0.53; at most 1.01 eps compiled, found 0.99.

    Source: Kapitonov, Yakubovsky 2022, equation (17).

    """
    (displacement,) = _as_floats("displacement", displacement, axes=(1,))
    Delta_x0, Delta_y0, _ = _split_components("displacement", displacement, 3)
    return _in_blocks(_form_of_planar_error, (Delta_x0, Delta_y0), out=out)


def _form_of_planar_error(Delta_x0: Any, Delta_y0: Any) -> Any:
    return _hypot(Delta_x0, Delta_y0)


# Source: Kapitonov, Yakubovsky 2022, equation (18)
# Expressions sha256: 704a84eb6694283854149d86d68ea5fc31a8c9f3d765f5e35bf9b26a42c607fe
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

    Returns
    -------
    ndarray or NumPy scalar (mm)

    Notes
    -----
    Domain: all real arguments.

    Accuracy, tested: 2 eps of the value.

    Proved, as long as no result overflows or falls below the normal range: at most 2.01 eps
    with np.hypot within 1 ulp, found 1.02; at most 1.76 eps compiled, found 1.74.

    Source: Kapitonov, Yakubovsky 2022, equation (18).

    """
    (displacement,) = _as_floats("displacement", displacement, axes=(1,))
    Delta_x0, Delta_y0, Delta_z0 = _split_components("displacement", displacement, 3)
    return _in_blocks(_form_of_spatial_error, (Delta_x0, Delta_y0, Delta_z0), out=out)


def _form_of_spatial_error(Delta_x0: Any, Delta_y0: Any, Delta_z0: Any) -> Any:
    return _hypot(_hypot(Delta_x0, Delta_y0), Delta_z0)


# Source: Kapitonov, Yakubovsky 2022, equation (16)
# Expressions sha256: bcc8d5b79cb3045914e1969c5fd6ba7254aa274323f55489839dfbd98d6309d7
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

    Returns
    -------
    ndarray or NumPy scalar (mm)

    Notes
    -----
    Domain: 0 < R < oo, 1 <= z < oo, z = floor(z), |A| <= R (A has either sign).

    Singular: |A| = R, the circle passes through the pole and the track has corners there.

    Accuracy, tested: 6 eps of the radius and the effect of eps*z*phi, where 1e-140 <= R <=
    1e150 and z*|phi| <= 2**26.

    Proved, where |A| <= 63/64*R and z*|phi| <= 21, as long as no result overflows or falls
    below the normal range: at most 4.5 eps with np.cos within 1 ulp and np.hypot within 1 ulp,
    found 2.85; at most 4.08 eps compiled, found 3.03.

    Source: Kapitonov, Yakubovsky 2022, equation (16).

    """
    phi, R, A, z = _as_floats("phi R A z", phi, R, A, z)
    R, A, z = _nan_outside(_check_of_radius, R, A, z)
    return _in_blocks(_form_of_radius, (phi,), _prepare_of_radius, (R, A, z), out=out)


def _check_of_radius(R: Any, A: Any, z: Any) -> tuple[Any, ...]:
    return (_is_positive(R), z >= 1.0, _is_finite(z), z == _floor(z), _abs(A) <= R)


def _prepare_of_radius(R: Any, A: Any, z: Any) -> tuple[Any, ...]:
    A_plus_R = A + R
    R_minus_A = R - A
    w = A_plus_R * R_minus_A

    return (A, z, w)


def _form_of_radius(phi: Any, A: Any, z: Any, w: Any) -> Any:
    u = A * _np.cos(z * phi)
    q = _abs(u) + _hypot(_np.sqrt(w), u)

    return _choose_where(u >= 0.0, q, w / q)


# Source: Kapitonov, Yakubovsky 2022, equation (16)
# Expressions sha256: 2b587a728eeac7d4234ec241f2e8f065649a9cbcf7994471b0fcb3b523bca0d7
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
) -> NDArray[Any]:
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

    Returns
    -------
    ndarray, shape (..., 3) (mm)

    Notes
    -----
    Domain: 0 < R, H < oo, 1 <= z < oo, z = floor(z), |A| <= R (A has either sign).

    Singular: |A| = R, the circle passes through the pole and the track has corners there.

    Accuracy, tested: 7.5 eps of the radius and the effect of eps*z*phi, where 1e-140 <= R <=
    1e150 and z*|phi| <= 2**26.

    Proved, where |A| <= 15/16*R and z*|phi| <= 22/7, as long as no result overflows or falls
    below the normal range: at most 6.31 eps with np.cos within 1 ulp and np.hypot within 1 ulp
    and np.sin within 1 ulp, found 3.21; at most 5.41 eps compiled, found 3.13.

    Source: Kapitonov, Yakubovsky 2022, equation (16).

    """
    phi, R, A, z, H = _as_floats("phi R A z H", phi, R, A, z, H)
    R, A, z, H = _nan_outside(_check_of_track, R, A, z, H)
    return _in_blocks(_form_of_track, (phi,), _prepare_of_track, (R, A, z, H), out=out, shape=(3,))


def _check_of_track(R: Any, A: Any, z: Any, H: Any) -> tuple[Any, ...]:
    return (_is_positive(R), _is_positive(H), z >= 1.0, _is_finite(z), z == _floor(z), _abs(A) <= R)


def _prepare_of_track(R: Any, A: Any, z: Any, H: Any) -> tuple[Any, ...]:
    A_plus_R = A + R
    R_minus_A = R - A
    w = A_plus_R * R_minus_A

    return (A, z, H, w)


def _form_of_track(phi: Any, A: Any, z: Any, H: Any, w: Any) -> Any:
    u = A * _np.cos(z * phi)
    q = _abs(u) + _hypot(_np.sqrt(w), u)
    term = _choose_where(u >= 0.0, q, w / q)

    return (
        term * _np.cos(phi),
        term * _np.sin(phi),
        H,
    )


# Source: extremes of Kapitonov, Yakubovsky 2022, equation (16)
# Expressions sha256: e35438d0af5d4450dc57468cb339fb912a80b9f5f13d5e776dede4b2ff38facb
# Form: sum
# Operations: 2
def largest_radius(R: ArrayLike, A: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the largest radius vector of the track.

        largest_radius = R + |A|

    Parameters
    ----------
    R : array_like, any shape
        Radius of the shifted circle (mm).
    A : array_like, any shape
        Shift of the circle, amplitude of the track (mm).

    Returns
    -------
    ndarray or NumPy scalar (mm)

    Notes
    -----
    Domain: 0 < R < oo, |A| <= R (A has either sign).

    Accuracy, tested: 0.5 eps of the value.

    Proved, as long as no result overflows or falls below the normal range: at most 0.51 eps
    with NumPy's functions, found 0.49; at most 0.51 eps compiled, found 0.49.

    Source: extremes of Kapitonov, Yakubovsky 2022, equation (16).

    """
    R, A = _as_floats("R A", R, A)
    R, A = _nan_outside(_check_of_largest_radius, R, A)
    return _in_blocks(_form_of_largest_radius, (R,), parameters=(A,), out=out)


def _check_of_largest_radius(R: Any, A: Any) -> tuple[Any, ...]:
    return (_is_positive(R), _abs(A) <= R)


def _form_of_largest_radius(R: Any, A: Any) -> Any:
    return R + _abs(A)


# Source: extremes of Kapitonov, Yakubovsky 2022, equation (16)
# Expressions sha256: 76217091d78435d52f2d1c4ff7b3ef104cac6b61586c219d68da1a519e3f3f90
# Form: difference
# Operations: 2
def smallest_radius(R: ArrayLike, A: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the smallest radius vector of the track.

        smallest_radius = R - |A|

    Parameters
    ----------
    R : array_like, any shape
        Radius of the shifted circle (mm).
    A : array_like, any shape
        Shift of the circle, amplitude of the track (mm).

    Returns
    -------
    ndarray or NumPy scalar (mm)

    Notes
    -----
    Domain: 0 < R < oo, |A| <= R (A has either sign).

    Singular: |A| = R, the circle passes through the pole and the track has corners there.

    Accuracy, tested: 0.5 eps of the value.

    Proved, as long as no result overflows or falls below the normal range: at most 0.51 eps
    with NumPy's functions, found 0.49; at most 0.51 eps compiled, found 0.49.

    Source: extremes of Kapitonov, Yakubovsky 2022, equation (16).

    """
    R, A = _as_floats("R A", R, A)
    R, A = _nan_outside(_check_of_largest_radius, R, A)
    return _in_blocks(_form_of_smallest_radius, (R,), parameters=(A,), out=out)


def _form_of_smallest_radius(R: Any, A: Any) -> Any:
    return R - _abs(A)


# Source: Kapitonov, Yakubovsky 2022, equation (3) with its indices corrected
# Expressions sha256: 6f084fa75dd066a5b51438cf22bf6f6d94de06892bd7117bc160059b31d2f83b
# Form: double sum
# Operations: 14
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

        error_sum_correlated = sqrt(Sum[i=1..n, j=1..n](scatters[i]*scatters[j]*
            correlation[i,j]*sensitivities[i]*sensitivities[j]*tolerances[i]*tolerances[j]))/
            total_scatter

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

    Returns
    -------
    ndarray or NumPy scalar (mm)

    Notes
    -----
    Domain: 0 < total_scatter, scatters[i] < oo, -1 <= correlation[i,j] <= 1, 0 <= tolerances[i]
    < oo, correlation[i,i] = 1, correlation[i,j] = correlation[j,i] (the matrix is symmetric,
    has ones on its diagonal and gives no negative square).

    Singular: a sum that is negative by no more than its own rounding counts as 0.

    Squares of tolerances, sensitivities and scatters are added: of sizes beyond 1e-50 to 1e50
    they may leave the range of doubles, and the result is infinite, NaN or too small.

    The accuracy is that of sums of at most 11 errors.

    Accuracy, tested: 8 eps of the value and what the sizes of the terms make of it, where
    (1e-50 <= tolerances[i] <= 1e50 or tolerances[i] = 0) and (1e-50 <= |sensitivities[i]| <=
    1e50 or sensitivities[i] = 0) and 1e-50 <= scatters[i] <= 1e50.

    Source: Kapitonov, Yakubovsky 2022, equation (3) with its indices corrected.

    """
    tolerances, sensitivities, scatters, correlation, total_scatter = _as_floats(
        "tolerances sensitivities scatters correlation total_scatter",
        tolerances,
        sensitivities,
        scatters,
        correlation,
        total_scatter,
        axes=(1, 1, 1, 2, 0),
    )
    tolerances, sensitivities, scatters, correlation = _sum_axes(
        tolerances=(tolerances, 1),
        sensitivities=(sensitivities, 1),
        scatters=(scatters, 1),
        correlation=(correlation, 2),
    )
    (total_scatter,) = _nan_outside(
        _check_of_error_sum_correlated, total_scatter, terms=(tolerances, scatters, correlation)
    )

    with _quietly():
        return _store(
            _np.sqrt(_nonnegative_form(sensitivities * scatters * tolerances, correlation))
            / total_scatter,
            out,
        )


def _check_of_error_sum_correlated(
    total_scatter: Any, tolerances: Any, scatters: Any, correlation: Any
) -> tuple[Any, ...]:
    return (
        _is_positive(total_scatter),
        _every(_is_positive(scatters), axis=-1),
        _every(correlation >= -1.0, axis=(-2, -1)),
        _every(correlation <= 1.0, axis=(-2, -1)),
        _every(_np.diagonal(correlation, axis1=-2, axis2=-1) == 1.0, axis=-1),
        _every(correlation == _np.swapaxes(correlation, -1, -2), axis=(-2, -1)),
        _every(_is_nonnegative(tolerances), axis=-1),
    )


# Source: Kapitonov, Yakubovsky 2022, equation (5) with sensitivities
# Expressions sha256: 4fd33494f7d6de64ce3231e3ec40e1ae74cddc83caa044313f27bd6650f05f88
# Form: sum of squares
# Operations: 6
def error_sum(
    tolerances: ArrayLike,
    sensitivities: ArrayLike,
    scatters: ArrayLike,
    total_scatter: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute the total error of independent elementary errors.

        error_sum =
            sqrt(Sum[i=1..n](scatters[i]**2*sensitivities[i]**2*tolerances[i]**2))/total_scatter

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

    Returns
    -------
    ndarray or NumPy scalar (mm)

    Notes
    -----
    Domain: 0 < total_scatter, scatters[i] < oo, 0 <= tolerances[i] < oo (no tolerance is
    negative).

    Squares of tolerances, sensitivities and scatters are added: of sizes beyond 1e-50 to 1e50
    they may leave the range of doubles, and the result is infinite, NaN or too small.

    The accuracy is that of sums of at most 128 errors.

    Accuracy, tested: 7 eps of the value, where (1e-50 <= tolerances[i] <= 1e50 or tolerances[i]
    = 0) and (1e-50 <= |sensitivities[i]| <= 1e50 or sensitivities[i] = 0) and 1e-50 <=
    scatters[i] <= 1e50.

    Proved, where n <= 2**20, as long as no result overflows or falls below the normal range: at
    most 2.26 + 0.25*(n - 1) eps with np.sum by additions in any order, found 3.11 where n = 5;
    at most 2.51 eps compiled, found 2.38.

    Source: Kapitonov, Yakubovsky 2022, equation (5) with sensitivities.

    """
    tolerances, sensitivities, scatters, total_scatter = _as_floats(
        "tolerances sensitivities scatters total_scatter",
        tolerances,
        sensitivities,
        scatters,
        total_scatter,
        axes=(1, 1, 1, 0),
    )
    tolerances, sensitivities, scatters = _sum_axes(
        tolerances=(tolerances, 1), sensitivities=(sensitivities, 1), scatters=(scatters, 1)
    )
    (total_scatter,) = _nan_outside(
        _check_of_error_sum, total_scatter, terms=(tolerances, scatters)
    )

    return _store(
        _np.sqrt(_add_up(_square(sensitivities * scatters * tolerances), axis=-1)) / total_scatter,
        out,
    )


def _check_of_error_sum(total_scatter: Any, tolerances: Any, scatters: Any) -> tuple[Any, ...]:
    return (
        _is_positive(total_scatter),
        _every(_is_positive(scatters), axis=-1),
        _every(_is_nonnegative(tolerances), axis=-1),
    )


# Source: Kapitonov, Yakubovsky 2022, equation (6) made homogeneous, Table 1 for the share
# Expressions sha256: 7fff15e2b77264d9943ed6fac71e8c97670915ebed3cc734ffdf6e2555bd8298
# Form: solved for the total
# Rewrites: difference_of_squares
# Operations: 12
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

        error_sum_thermal = sqrt(Sum[i=1..n](scatters[i]**2*sensitivities[i]**2*
            tolerances[i]**2))/sqrt(total_scatter**2 - thermal_scatter**2*thermal_share**2)

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

    Returns
    -------
    ndarray or NumPy scalar (mm)

    Notes
    -----
    Domain: 0 < total_scatter, scatters[i], thermal_scatter < oo, 0 <= tolerances[i],
    thermal_share < oo, thermal_scatter*thermal_share < total_scatter (the temperature error is
    below the total).

    Squares of tolerances, sensitivities and scatters are added: of sizes beyond 1e-50 to 1e50
    they may leave the range of doubles, and the result is infinite, NaN or too small.

    The accuracy is that of sums of at most 128 errors.

    Accuracy, tested: 9 eps of the value times the condition of its denominator, where (1e-50 <=
    tolerances[i] <= 1e50 or tolerances[i] = 0) and (1e-50 <= |sensitivities[i]| <= 1e50 or
    sensitivities[i] = 0) and 1e-50 <= scatters[i] <= 1e50.

    Proved, where n <= 2**20 and thermal_share*thermal_scatter <= (1 - 2**-20)*total_scatter, as
    long as no result overflows or falls below the normal range: at most 3.53 + 0.25*(n - 1) eps
    with np.sum by additions in any order, found 3.97 where n = 5; at most 3.78 eps compiled,
    found 3.24.

    Source: Kapitonov, Yakubovsky 2022, equation (6) made homogeneous, Table 1 for the share.

    """
    tolerances, sensitivities, scatters, total_scatter, thermal_share, thermal_scatter = _as_floats(
        "tolerances sensitivities scatters total_scatter thermal_share thermal_scatter",
        tolerances,
        sensitivities,
        scatters,
        total_scatter,
        thermal_share,
        thermal_scatter,
        axes=(1, 1, 1, 0, 0, 0),
    )
    tolerances, sensitivities, scatters = _sum_axes(
        tolerances=(tolerances, 1), sensitivities=(sensitivities, 1), scatters=(scatters, 1)
    )
    total_scatter, thermal_share, thermal_scatter = _nan_outside(
        _check_of_error_sum_thermal,
        total_scatter,
        thermal_share,
        thermal_scatter,
        terms=(tolerances, scatters),
    )

    K_minus_tau_K_T = total_scatter - thermal_share * thermal_scatter
    K_plus_tau_K_T = total_scatter + thermal_share * thermal_scatter

    return _store(
        _np.sqrt(_add_up(_square(sensitivities * scatters * tolerances), axis=-1))
        / _np.sqrt(K_minus_tau_K_T * K_plus_tau_K_T),
        out,
    )


def _check_of_error_sum_thermal(
    total_scatter: Any, thermal_share: Any, thermal_scatter: Any, tolerances: Any, scatters: Any
) -> tuple[Any, ...]:
    return (
        _is_positive(total_scatter),
        _every(_is_positive(scatters), axis=-1),
        _is_positive(thermal_scatter),
        _is_nonnegative(thermal_share),
        thermal_share * thermal_scatter < total_scatter,
        _every(_is_nonnegative(tolerances), axis=-1),
    )


# Source: inverse of Kapitonov, Yakubovsky 2022, equation (15)
# Expressions sha256: a99a315cb289374257f5d9e7c037d6efc62711fb3e889f9796d451d45870de2f
# Form: root without cancellation
# Operations: 11
def tilt_of_planar_error(
    error: ArrayLike,
    offset: ArrayLike,
    rho: ArrayLike,
    H: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute the tilt with which the largest error in the plane is the one wanted.

        tilt_of_planar_error = 2*atan2(error - offset, H + sqrt(H**2 + 2*rho*(error - offset) -
            (error - offset)**2))

    Parameters
    ----------
    error : array_like, any shape
        Largest error wanted (mm).
    offset : array_like, any shape
        Offset of the axis (mm).
    rho : array_like, any shape
        Largest radius of the track (mm).
    H : array_like, any shape
        Thickness of the part (mm).

    Returns
    -------
    ndarray or NumPy scalar (rad)

    Notes
    -----
    Domain: 0 < H, rho, error < oo, 0 <= offset < oo, 0 <= error - offset, error - offset <= H +
    rho (e <= Delta^XY <= e + rho + H_s).

    Accuracy, tested: 6 eps of the tilt and the effect of eps*(error - offset), where 1e-50 <=
    rho, H, error <= 1e50 and (1e-50 <= offset <= 1e50 or offset = 0).

    Proved, where error - offset <= 15/16*(rho + H), as long as no result overflows or falls
    below the normal range: at most 2.02 eps with np.arctan2 within 1 ulp, found 1.61; at most
    2.02 eps compiled, found 1.83.

    Source: inverse of Kapitonov, Yakubovsky 2022, equation (15).

    """
    error, offset, rho, H = _as_floats("error offset rho H", error, offset, rho, H)
    error, offset, rho, H = _nan_outside(_check_of_tilt_of_planar_error, error, offset, rho, H)
    return _in_blocks(_form_of_tilt_of_planar_error, (error,), parameters=(offset, rho, H), out=out)


def _check_of_tilt_of_planar_error(error: Any, offset: Any, rho: Any, H: Any) -> tuple[Any, ...]:
    return (
        _is_positive(H),
        _is_positive(rho),
        _is_nonnegative(offset),
        _is_positive(error),
        error - offset >= 0.0,
        error - offset <= H + rho,
    )


def _form_of_tilt_of_planar_error(error: Any, offset: Any, rho: Any, H: Any) -> Any:
    term = error - offset

    return 2.0 * _np.arctan2(term, H + _np.sqrt(_square(H) + 2.0 * rho * term - _square(term)))


# Source: inverse of Kapitonov, Yakubovsky 2022, equation (15)
# Expressions sha256: 0340a11c7f728546d65e567cdac000ff31459bbcb5725dbbcddf8a528f4492b7
# Form: root without cancellation
# Operations: 25
def tilt_of_spatial_error(
    error: ArrayLike,
    offset: ArrayLike,
    rho: ArrayLike,
    H: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute the tilt with which the largest error in space is the one wanted.

        tilt_of_spatial_error = 2*atan2((error - offset)*(error + offset), 2*H*offset +
            sqrt(4*H**2*offset**2 + (error - offset)*(error + offset)*(4*H**2 + 4*rho**2 +
            4*offset*rho - (error - offset)*(error + offset))))

    Parameters
    ----------
    error : array_like, any shape
        Largest error wanted (mm).
    offset : array_like, any shape
        Offset of the axis (mm).
    rho : array_like, any shape
        Largest radius of the track (mm).
    H : array_like, any shape
        Thickness of the part (mm).

    Returns
    -------
    ndarray or NumPy scalar (rad)

    Notes
    -----
    Domain: 0 < H, rho, error < oo, 0 <= offset < oo, offset <= error, (error - offset)*(error +
    offset) <= 2*H**2 + 2*rho**2 + 2*H*offset + 2*offset*rho (e <= Delta^XYZ, the tilt up to a
    right angle).

    Accuracy, tested: 6 eps of the tilt and the effect of eps*(error - offset), where 1e-50 <=
    rho, H, error <= 1e50 and (1e-50 <= offset <= 1e50 or offset = 0).

    Proved, where offset <= H and error - offset <= rho + H, as long as no result overflows or
    falls below the normal range: at most 3.76 eps with np.arctan2 within 1 ulp, found 2.09; at
    most 4.12 eps compiled, found 2.32.

    Source: inverse of Kapitonov, Yakubovsky 2022, equation (15).

    """
    error, offset, rho, H = _as_floats("error offset rho H", error, offset, rho, H)
    error, offset, rho, H = _nan_outside(_check_of_tilt_of_spatial_error, error, offset, rho, H)
    return _in_blocks(
        _form_of_tilt_of_spatial_error,
        (error,),
        _prepare_of_tilt_of_spatial_error,
        (offset, rho, H),
        out=out,
    )


def _check_of_tilt_of_spatial_error(error: Any, offset: Any, rho: Any, H: Any) -> tuple[Any, ...]:
    return (
        _is_positive(H),
        _is_positive(rho),
        _is_nonnegative(offset),
        _is_positive(error),
        offset <= error,
        (error + offset) * (error - offset)
        <= 2.0 * _square(H) + 2.0 * _square(rho) + 2.0 * offset * H + 2.0 * offset * rho,
    )


def _prepare_of_tilt_of_spatial_error(offset: Any, rho: Any, H: Any) -> tuple[Any, ...]:
    H_s_squared = _square(H)

    return (offset, rho, H, H_s_squared)


def _form_of_tilt_of_spatial_error(
    error: Any, offset: Any, rho: Any, H: Any, H_s_squared: Any
) -> Any:
    term = error + offset
    term_2 = error - offset

    return 2.0 * _np.arctan2(
        term * term_2,
        2.0 * offset * H
        + _np.sqrt(
            4.0 * H_s_squared * _square(offset)
            + term
            * term_2
            * (4.0 * H_s_squared + 4.0 * _square(rho) + 4.0 * offset * rho - term * term_2)
        ),
    )
