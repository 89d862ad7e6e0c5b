"""Other forms of the kernels of `track_wheel`.

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
from mechproof.kernel_support.functions import add_up as _add_up, floor as _floor, square as _square

__all__ = [
    "displacement_direct",
    "displacement_linear",
    "error_sum_thermal_direct",
    "planar_error_printed",
    "radius_printed",
    "spatial_error_printed",
    "track_printed",
]


def __dir__() -> list[str]:
    return __all__


# Source: Kapitonov, Yakubovsky 2022, equation (15)
# Expressions sha256: 9c3b364591307c1882a9f9eab81c1c909b9a7d9f9c4cf8a6c9c4209a7cd0587a
# Form: direct (K^T - I)*p + t
# Operations: 31
def displacement_direct(
    points: ArrayLike, angles: ArrayLike, shift: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Compute `displacement` by another form: direct (K^T - I)*p + t.

        [a + z_13*sin(beta) + x_13*cos(beta)*cos(gamma) - x_13 - y_13*sin(gamma)*cos(beta)]
        [b + x_13*(sin(gamma)*cos(alpha) + sin(alpha)*sin(beta)*cos(gamma)) +
            y_13*(cos(alpha)*cos(gamma) - sin(alpha)*sin(beta)*sin(gamma)) - y_13 -
            z_13*sin(alpha)*cos(beta)]
        [c + x_13*(sin(alpha)*sin(gamma) - sin(beta)*cos(alpha)*cos(gamma)) +
            y_13*(sin(alpha)*cos(gamma) + sin(beta)*sin(gamma)*cos(alpha)) +
            z_13*cos(alpha)*cos(beta) - z_13]

    The entries of K are rounded before the ones are taken off.

    Same domain as `displacement`.

    Source: Kapitonov, Yakubovsky 2022, equation (15).

    """
    points, angles, shift = _as_floats("points angles shift", points, angles, shift, axes=(1, 1, 1))
    _check_components("points", points, 3)
    alpha, beta, gamma = _split_components("angles", angles, 3)
    a, b, c = _split_components("shift", shift, 3)
    return _transform(
        points, _prepare_of_displacement_direct, (alpha, beta, gamma, a, b, c), out=out
    )


def _prepare_of_displacement_direct(
    alpha: Any, beta: Any, gamma: Any, a: Any, b: Any, c: Any
) -> tuple[Any, ...]:
    sin_beta = _np.sin(beta)
    cos_beta = _np.cos(beta)
    cos_gamma = _np.cos(gamma)
    sin_gamma = _np.sin(gamma)
    cos_alpha = _np.cos(alpha)
    sin_alpha = _np.sin(alpha)

    return (
        cos_beta * cos_gamma - 1.0,
        -cos_beta * sin_gamma,
        sin_beta,
        cos_alpha * sin_gamma + cos_gamma * sin_alpha * sin_beta,
        cos_alpha * cos_gamma - 1.0 - sin_alpha * sin_beta * sin_gamma,
        -cos_beta * sin_alpha,
        sin_alpha * sin_gamma - cos_alpha * cos_gamma * sin_beta,
        cos_gamma * sin_alpha + cos_alpha * sin_beta * sin_gamma,
        cos_alpha * cos_beta - 1.0,
        a,
        b,
        c,
    )


# Source: Kapitonov, Yakubovsky 2022, equation (15)
# Expressions sha256: e58ef8fa94509c948da8a770d7047ec06cfe8ee2caab9cf1d24ca425f8c0f01e
# Form: first order in the angles
# Operations: 3
def displacement_linear(
    points: ArrayLike, angles: ArrayLike, shift: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Compute `displacement` by another form: first order in the angles.

        [a + beta*z_13 - gamma*y_13]
        [b + gamma*x_13 - alpha*z_13]
        [c + alpha*y_13 - beta*x_13]

    The bound is that of the norm of the error.

    Approximation, first order in the angles: |result - exact| <= sqrt(x_13**2 + y_13**2 +
    z_13**2)*(|alpha| + |beta| + |gamma|)**2/2, apart from rounding.

    Same domain as `displacement`.

    """
    points, angles, shift = _as_floats("points angles shift", points, angles, shift, axes=(1, 1, 1))
    _check_components("points", points, 3)
    alpha, beta, gamma = _split_components("angles", angles, 3)
    a, b, c = _split_components("shift", shift, 3)
    return _transform(
        points, _prepare_of_displacement_linear, (alpha, beta, gamma, a, b, c), out=out
    )


def _prepare_of_displacement_linear(
    alpha: Any, beta: Any, gamma: Any, a: Any, b: Any, c: Any
) -> tuple[Any, ...]:
    return (0.0, -gamma, beta, gamma, 0.0, -alpha, -beta, alpha, 0.0, a, b, c)


# Source: Kapitonov, Yakubovsky 2022, equation (17)
# Expressions sha256: 14e4884bac83d19c6b82566fa55a54b132dd8f49b74bb0324b329bfab95547d3
# Form: printed (17)
# Operations: 4
def planar_error_printed(displacement: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute `planar_error` by another form: printed (17).

        planar_error_printed = sqrt(Delta_x0**2 + Delta_y0**2)

    Same domain as `planar_error`.

    Source: Kapitonov, Yakubovsky 2022, equation (17).

    """
    (displacement,) = _as_floats("displacement", displacement, axes=(1,))
    Delta_x0, Delta_y0, _ = _split_components("displacement", displacement, 3)
    return _in_blocks(_form_of_planar_error_printed, (Delta_x0, Delta_y0), out=out)


def _form_of_planar_error_printed(Delta_x0: Any, Delta_y0: Any) -> Any:
    return _np.sqrt(_square(Delta_x0) + _square(Delta_y0))


# Source: Kapitonov, Yakubovsky 2022, equation (18)
# Expressions sha256: 704a84eb6694283854149d86d68ea5fc31a8c9f3d765f5e35bf9b26a42c607fe
# Form: printed (18)
# Operations: 6
def spatial_error_printed(displacement: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute `spatial_error` by another form: printed (18).

        spatial_error_printed = sqrt(Delta_x0**2 + Delta_y0**2 + Delta_z0**2)

    Same domain as `spatial_error`.

    Source: Kapitonov, Yakubovsky 2022, equation (18).

    """
    (displacement,) = _as_floats("displacement", displacement, axes=(1,))
    Delta_x0, Delta_y0, Delta_z0 = _split_components("displacement", displacement, 3)
    return _in_blocks(_form_of_spatial_error_printed, (Delta_x0, Delta_y0, Delta_z0), out=out)


def _form_of_spatial_error_printed(Delta_x0: Any, Delta_y0: Any, Delta_z0: Any) -> Any:
    return _np.sqrt(_square(Delta_x0) + _square(Delta_y0) + _square(Delta_z0))


# Source: Kapitonov, Yakubovsky 2022, equation (16)
# Expressions sha256: bcc8d5b79cb3045914e1969c5fd6ba7254aa274323f55489839dfbd98d6309d7
# Form: printed (16)
# Operations: 11
def radius_printed(
    phi: ArrayLike, R: ArrayLike, A: ArrayLike, z: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `radius` by another form: printed (16).

        radius_printed = A*cos(phi*z) + sqrt(R**2 - A**2*sin(phi*z)**2)

    Same domain as `radius`, A has either sign.

    Source: Kapitonov, Yakubovsky 2022, equation (16).

    """
    phi, R, A, z = _as_floats("phi R A z", phi, R, A, z)
    R, A, z = _nan_outside(_check_of_radius_printed, R, A, z)
    return _in_blocks(_form_of_radius_printed, (phi,), parameters=(R, A, z), out=out)


def _check_of_radius_printed(R: Any, A: Any, z: Any) -> tuple[Any, ...]:
    return (_is_positive(R), z >= 1.0, _is_finite(z), z == _floor(z), _abs(A) <= R)


def _form_of_radius_printed(phi: Any, R: Any, A: Any, z: Any) -> Any:
    phi_z = z * phi

    return A * _np.cos(phi_z) + _np.sqrt(_square(R) - _square(A) * _square(_np.sin(phi_z)))


# Source: Kapitonov, Yakubovsky 2022, equation (16)
# Expressions sha256: 2b587a728eeac7d4234ec241f2e8f065649a9cbcf7994471b0fcb3b523bca0d7
# Form: printed (16)
# Operations: 15
def track_printed(
    phi: ArrayLike,
    R: ArrayLike,
    A: ArrayLike,
    z: ArrayLike,
    H: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> NDArray[Any]:
    """Compute `track` by another form: printed (16).

        [(A*cos(phi*z) + sqrt(R**2 - A**2*sin(phi*z)**2))*cos(phi)]
        [(A*cos(phi*z) + sqrt(R**2 - A**2*sin(phi*z)**2))*sin(phi)]
        [H]

    Same domain as `track`, A has either sign.

    Source: Kapitonov, Yakubovsky 2022, equation (16).

    """
    phi, R, A, z, H = _as_floats("phi R A z H", phi, R, A, z, H)
    R, A, z, H = _nan_outside(_check_of_track_printed, R, A, z, H)
    return _in_blocks(_form_of_track_printed, (phi,), parameters=(R, A, z, H), out=out, shape=(3,))


def _check_of_track_printed(R: Any, A: Any, z: Any, H: Any) -> tuple[Any, ...]:
    return (_is_positive(R), _is_positive(H), z >= 1.0, _is_finite(z), z == _floor(z), _abs(A) <= R)


def _form_of_track_printed(phi: Any, R: Any, A: Any, z: Any, H: Any) -> Any:
    phi_z = z * phi
    term = A * _np.cos(phi_z) + _np.sqrt(_square(R) - _square(A) * _square(_np.sin(phi_z)))

    return (
        term * _np.cos(phi),
        term * _np.sin(phi),
        H,
    )


# Source: Kapitonov, Yakubovsky 2022, equation (6) made homogeneous, Table 1 for the share
# Expressions sha256: 7fff15e2b77264d9943ed6fac71e8c97670915ebed3cc734ffdf6e2555bd8298
# Form: difference of squares
# Operations: 12
def error_sum_thermal_direct(
    tolerances: ArrayLike,
    sensitivities: ArrayLike,
    scatters: ArrayLike,
    total_scatter: ArrayLike,
    thermal_share: ArrayLike,
    thermal_scatter: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute `error_sum_thermal` by another form: difference of squares.

        error_sum_thermal_direct = sqrt(Sum[i=1..n](scatters[i]**2*sensitivities[i]**2*
            tolerances[i]**2))/sqrt(total_scatter**2 - thermal_scatter**2*thermal_share**2)

    Same domain as `error_sum_thermal`, the temperature error is below the total.

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
        _check_of_error_sum_thermal_direct,
        total_scatter,
        thermal_share,
        thermal_scatter,
        terms=(tolerances, scatters),
    )

    return _store(
        _np.sqrt(_add_up(_square(sensitivities * scatters * tolerances), axis=-1))
        / _np.sqrt(_square(total_scatter) - _square(thermal_share) * _square(thermal_scatter)),
        out,
    )


def _check_of_error_sum_thermal_direct(
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
