"""Kernels of the system `oval_planetary`.

Prikhodko, Kurapov, Belina, Azizov, Polivoda 2024, planetary mechanism with oval wheels, EDN HZWKZJ

Angles in radians, positive in the direction of the carrier's rotation; lengths in mm. The paper's
(10) has the opposite sign.

Generated from mechproof.derivations.oval_planetary with SymPy 1.14.0.
Regenerate with `mechproof regenerate`; edits are overwritten.
"""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import as_floats, in_blocks, nan_outside

__all__ = [
    "acceleration",
    "acceleration_cylindrical",
    "position",
    "position_cylindrical",
    "ratio",
    "ratio_cylindrical",
]


# Source: Prikhodko et al. 2024 (oval wheels), equation (10)
# Expression sha256: 022fc7d163eb7d7e105032cc7a0cbaf2ec6025d79d60fa1b91bdbb07b445d3b6
# Form: quotient in tan(phi1)
# Operations: 34
def ratio(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute the transmission ratio d phi3/d phi1 of the output wheel to the carrier.

        ratio = 1 - 2*alpha*beta/(beta**2*(1 + cos(2*phi1)) + (1 - cos(2*phi1))*(alpha**2 +
            gamma**2) + 2*beta*gamma*sin(2*phi1))
        alpha = (1 - e2)*(1 + e1)*(1 + e2)
        beta = (1 - e1)*((1 - e2)**2*cos(mount)**2 + (1 + e2)**2*sin(mount)**2)
        gamma = e2*(4 + 4*e1)*sin(mount)*cos(mount)

    Parameters
    ----------
    phi1 : array_like, any shape
        Carrier angle, any number of turns (rad).
    e1 : array_like, any shape
        Eccentricity of the oval pair 4-5 (pure number).
    e2 : array_like, any shape
        Eccentricity of the oval pair 6-3 (pure number).
    mount : array_like, any shape, default 0
        Turn of wheel 6 on its shaft, forward from its place in the paper (rad).
    out : ndarray, optional
        Where the result goes, of its type and shape; it may overlap an argument.

    Returns
    -------
    ndarray or NumPy scalar
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
    Domain: 0 <= e1 < 1, 0 <= e2 < 1.

    Outside it the result is NaN, by way of e1.

    Accuracy held by the tests: error <= 41 eps * (1 + W*(1 + |beta + gamma*t|*(beta +
    |gamma*t|)/S), W = 1 - value, S = (beta + gamma*t)**2 + alpha**2*t**2, t = tan(phi1)), eps
    the spacing of floats at 1.

    Source: Prikhodko et al. 2024 (oval wheels), equation (10).

    """
    phi1, e1, e2, mount = as_floats(phi1=phi1, e1=e1, e2=e2, mount=mount)
    inside = (e1 >= 0) & (e1 < 1) & (e2 >= 0) & (e2 < 1)
    e1 = nan_outside(e1, inside)
    return in_blocks(_ratio, (phi1,), _prepare_ratio, (e1, e2, mount), out=out)


def _prepare_ratio(e1: Any, e2: Any, mount: Any) -> tuple[Any, ...]:
    one_minus_e2 = 1 - e2
    one_plus_e2 = 1 + e2
    alpha = one_minus_e2 * one_plus_e2 * (1 + e1)
    cos_mount = np.cos(mount)
    sin_mount = np.sin(mount)
    beta = (1 - e1) * (cos_mount**2 * one_minus_e2**2 + one_plus_e2**2 * sin_mount**2)
    gamma = cos_mount * e2 * sin_mount * (4 + 4 * e1)

    return (alpha, beta, gamma)


def _ratio(phi1: Any, alpha: Any, beta: Any, gamma: Any) -> Any:
    tan_phi1 = np.tan(phi1)
    tan_phi1_squared = tan_phi1**2

    return 1 - alpha * beta / (alpha**2 * tan_phi1_squared + (beta + gamma * tan_phi1) ** 2) * (
        1 + tan_phi1_squared
    )


# Source: Prikhodko et al. 2024 (oval wheels), integral (11)
# Expression sha256: 8817606f32f392023b204bcde56505981bbd92140212cac1df7e5638e8bebf59
# Form: one arctangent of tan(phi1)
# Operations: 39
def position(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute the position function phi3(phi1) of the output wheel, phi3(0) = 0.

        position = atan2(gamma*(1 - cos(2*phi1)) - delta*sin(2*phi1), alpha + beta +
            gamma*sin(2*phi1) + (beta - alpha)*cos(2*phi1))
        alpha = (1 - e2)*(1 + e1)*(1 + e2)
        beta = (1 - e1)*((1 - e2)**2*cos(mount)**2 + (1 + e2)**2*sin(mount)**2)
        gamma = e2*(4 + 4*e1)*sin(mount)*cos(mount)
        delta = 2*(1 - e2)*(e1 + e2)*cos(mount)**2 + 2*(e1 - e2)*(1 + e2)*sin(mount)**2

    Parameters
    ----------
    phi1 : array_like, any shape
        Carrier angle, any number of turns (rad).
    e1 : array_like, any shape
        Eccentricity of the oval pair 4-5 (pure number).
    e2 : array_like, any shape
        Eccentricity of the oval pair 6-3 (pure number).
    mount : array_like, any shape, default 0
        Turn of wheel 6 on its shaft, forward from its place in the paper (rad).
    out : ndarray, optional
        Where the result goes, of its type and shape; it may overlap an argument.

    Returns
    -------
    ndarray or NumPy scalar
        The broadcast of the arguments (rad); float32 if every array argument is float32,
        float64 otherwise.

    Raises
    ------
    TypeError
        If an argument is complex or not numeric, or `out` has another type.
    ValueError
        If shapes do not broadcast, or `out` has another shape.

    Notes
    -----
    Domain: 0 <= e1 < 1, 0 <= e2 < 1.

    Outside it the result is NaN, by way of e1.

    Accuracy held by the tests: error <= 20 eps * (|value| + (|X|*Y' + |Y|*X')/(X**2 + Y**2), Y
    = t*(gamma*t - delta), X = beta + gamma*t + alpha*t**2, t = tan(phi1), Y' and X' with the
    absolute values of all terms, where Y does not underflow), eps the spacing of floats at 1.

    Source: Prikhodko et al. 2024 (oval wheels), integral (11).

    """
    phi1, e1, e2, mount = as_floats(phi1=phi1, e1=e1, e2=e2, mount=mount)
    inside = (e1 >= 0) & (e1 < 1) & (e2 >= 0) & (e2 < 1)
    e1 = nan_outside(e1, inside)
    return in_blocks(_position, (phi1,), _prepare_position, (e1, e2, mount), out=out)


def _prepare_position(e1: Any, e2: Any, mount: Any) -> tuple[Any, ...]:
    cos_mount = np.cos(mount)
    sin_mount = np.sin(mount)
    gamma = cos_mount * e2 * sin_mount * (4 + 4 * e1)
    cos_mount_squared = cos_mount**2
    one_minus_e2 = 1 - e2
    one_plus_e2 = 1 + e2
    sin_mount_squared = sin_mount**2
    delta = 2 * cos_mount_squared * one_minus_e2 * (
        e1 + e2
    ) + 2 * one_plus_e2 * sin_mount_squared * (e1 - e2)
    beta = (1 - e1) * (cos_mount_squared * one_minus_e2**2 + sin_mount_squared * one_plus_e2**2)
    alpha = one_minus_e2 * one_plus_e2 * (1 + e1)

    return (gamma, delta, beta, alpha)


def _position(phi1: Any, gamma: Any, delta: Any, beta: Any, alpha: Any) -> Any:
    tan_phi1 = np.tan(phi1)
    gamma_tan_phi1 = gamma * tan_phi1

    return np.arctan2(
        tan_phi1 * (gamma_tan_phi1 - delta), beta + gamma_tan_phi1 + alpha * tan_phi1**2
    )


# Source: Prikhodko et al. 2024 (oval wheels), derivative of (10)
# Expression sha256: 907c4abe06994bdeef687c761a926056581c7b0431435370803e3a4a9987ca76
# Form: quotient in tan(phi1)
# Operations: 54
def acceleration(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute d ratio/d phi1, the angular acceleration of the output at unit carrier speed.

        acceleration = -2*alpha*beta*(2*beta**2*sin(2*phi1) - 2*(alpha**2 +
            gamma**2)*sin(2*phi1) - 4*beta*gamma*cos(2*phi1))/(beta**2*(1 + cos(2*phi1)) + (1 -
            cos(2*phi1))*(alpha**2 + gamma**2) + 2*beta*gamma*sin(2*phi1))**2
        alpha = (1 - e2)*(1 + e1)*(1 + e2)
        beta = (1 - e1)*((1 - e2)**2*cos(mount)**2 + (1 + e2)**2*sin(mount)**2)
        gamma = e2*(4 + 4*e1)*sin(mount)*cos(mount)

    Parameters
    ----------
    phi1 : array_like, any shape
        Carrier angle, any number of turns (rad).
    e1 : array_like, any shape
        Eccentricity of the oval pair 4-5 (pure number).
    e2 : array_like, any shape
        Eccentricity of the oval pair 6-3 (pure number).
    mount : array_like, any shape, default 0
        Turn of wheel 6 on its shaft, forward from its place in the paper (rad).
    out : ndarray, optional
        Where the result goes, of its type and shape; it may overlap an argument.

    Returns
    -------
    ndarray or NumPy scalar
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
    Domain: 0 <= e1 < 1, 0 <= e2 < 1.

    Outside it the result is NaN, by way of e1.

    Accuracy held by the tests: error <= 90 eps * (2*alpha*beta*(1 + t**2)*Z'/S**2*(1 + |beta +
    gamma*t|*(beta + |gamma*t|)/S), S = (beta + gamma*t)**2 + alpha**2*t**2, t = tan(phi1), Z' =
    |beta*gamma|*(1 + t**2) + (delta'*(alpha + beta) + gamma**2)*|t|, delta' with absolute
    values of its terms), eps the spacing of floats at 1.

    Source: Prikhodko et al. 2024 (oval wheels), derivative of (10).

    """
    phi1, e1, e2, mount = as_floats(phi1=phi1, e1=e1, e2=e2, mount=mount)
    inside = (e1 >= 0) & (e1 < 1) & (e2 >= 0) & (e2 < 1)
    e1 = nan_outside(e1, inside)
    return in_blocks(_acceleration, (phi1,), _prepare_acceleration, (e1, e2, mount), out=out)


def _prepare_acceleration(e1: Any, e2: Any, mount: Any) -> tuple[Any, ...]:
    one_minus_e2 = 1 - e2
    one_plus_e2 = 1 + e2
    alpha = one_minus_e2 * one_plus_e2 * (1 + e1)
    cos_mount = np.cos(mount)
    cos_mount_squared = cos_mount**2
    sin_mount = np.sin(mount)
    sin_mount_squared = sin_mount**2
    beta = (1 - e1) * (cos_mount_squared * one_minus_e2**2 + sin_mount_squared * one_plus_e2**2)
    gamma = cos_mount * e2 * sin_mount * (4 + 4 * e1)
    delta = 2 * cos_mount_squared * one_minus_e2 * (
        e1 + e2
    ) + 2 * one_plus_e2 * sin_mount_squared * (e1 - e2)

    return (alpha, beta, gamma, delta)


def _acceleration(phi1: Any, alpha: Any, beta: Any, gamma: Any, delta: Any) -> Any:
    tan_phi1 = np.tan(phi1)
    tan_phi1_squared = tan_phi1**2

    return (
        2
        * alpha
        * beta
        / (alpha**2 * tan_phi1_squared + (beta + gamma * tan_phi1) ** 2) ** 2
        * (1 + tan_phi1_squared)
        * ((gamma**2 + delta * (alpha + beta)) * tan_phi1 + beta * gamma * (1 - tan_phi1_squared))
    )


# Source: Prikhodko et al. 2024 (oval wheels), equation (10), pair 4-5 cylindrical
# Expression sha256: 66813425db29bb27833abeeeb7af61d5e1e556ca1182dddf5d3142408fbcb750
# Form: half-angle quotient
# Rewrites: half_angle_tangent
# Operations: 18
def ratio_cylindrical(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the ratio d phi3/d phi1 with a cylindrical pair 4-5.

        ratio_cylindrical = 1 - k*(1 - e2**2)/(1 + e2**2 - 2*e2*cos(x))
        k = R4/R5
        x = 2*k*phi1

    Parameters
    ----------
    phi1 : array_like, any shape
        Carrier angle, any number of turns (rad).
    R4 : array_like, any shape
        Radius of the cylindrical sun 4 (mm).
    R5 : array_like, any shape
        Radius of the cylindrical wheel 5 (mm).
    e2 : array_like, any shape
        Eccentricity of the oval pair 6-3 (pure number).
    out : ndarray, optional
        Where the result goes, of its type and shape; it may overlap an argument.

    Returns
    -------
    ndarray or NumPy scalar
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
    Domain: 0 < R4 < oo, 0 < R5 < oo, 0 <= e2 < 1.

    Outside it the result is NaN, by way of R4.

    Accuracy held by the tests: error <= 16 eps * (1 + W*(1 + 2*sqrt(e2)*|x|/sqrt(1 + e2**2 -
    2*e2*cos(x))), W = 1 - value, where eps*|x| <= (1 - e2)/4), eps the spacing of floats at 1.

    Source: Prikhodko et al. 2024 (oval wheels), equation (10), pair 4-5 cylindrical.

    """
    phi1, R4, R5, e2 = as_floats(phi1=phi1, R4=R4, R5=R5, e2=e2)
    inside = (R4 > 0) & np.isfinite(R4) & (R5 > 0) & np.isfinite(R5) & (e2 >= 0) & (e2 < 1)
    R4 = nan_outside(R4, inside)
    return in_blocks(_ratio_cylindrical, (phi1,), _prepare_ratio_cylindrical, (R4, R5, e2), out=out)


def _prepare_ratio_cylindrical(R4: Any, R5: Any, e2: Any) -> tuple[Any, ...]:
    k = R4 / R5
    one_minus_e2 = 1 - e2
    one_plus_e2 = 1 + e2

    return (k, one_minus_e2, one_plus_e2)


def _ratio_cylindrical(phi1: Any, k: Any, one_minus_e2: Any, one_plus_e2: Any) -> Any:
    x = 2 * k * phi1
    t = np.tan(x / 2)
    t_squared = t**2

    return 1 - k * one_minus_e2 * one_plus_e2 / (one_minus_e2**2 + one_plus_e2**2 * t_squared) * (
        1 + t_squared
    )


# Source: Prikhodko et al. 2024 (oval wheels), integral (11), pair 4-5 cylindrical
# Expression sha256: d968249bfe4369830ea6a02f2dd824ffc2a6049abadb9f31cf4ddfd6fe006fe3
# Form: half-angle atan
# Rewrites: positive_atan2, half_angle_tangent
# Operations: 18
def position_cylindrical(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the position function phi3(phi1) with a cylindrical pair 4-5, phi3(0) = 0.

        position_cylindrical = phi1*(R5 - R4)/R5 - atan2(e2*sin(x), 1 - e2*cos(x))
        k = R4/R5
        x = 2*k*phi1

    Parameters
    ----------
    phi1 : array_like, any shape
        Carrier angle, any number of turns (rad).
    R4 : array_like, any shape
        Radius of the cylindrical sun 4 (mm).
    R5 : array_like, any shape
        Radius of the cylindrical wheel 5 (mm).
    e2 : array_like, any shape
        Eccentricity of the oval pair 6-3 (pure number).
    out : ndarray, optional
        Where the result goes, of its type and shape; it may overlap an argument.

    Returns
    -------
    ndarray or NumPy scalar
        The broadcast of the arguments (rad); float32 if every array argument is float32,
        float64 otherwise.

    Raises
    ------
    TypeError
        If an argument is complex or not numeric, or `out` has another type.
    ValueError
        If shapes do not broadcast, or `out` has another shape.

    Notes
    -----
    Domain: 0 < R4 < oo, 0 < R5 < oo, 0 <= e2 < 1.

    Outside it the result is NaN, by way of R4.

    Accuracy held by the tests: error <= 12 eps * (the sum of both terms' absolute values +
    |phi1|*(k + 1 - ratio), where eps*|x| <= (1 - e2)/4), eps the spacing of floats at 1.

    Source: Prikhodko et al. 2024 (oval wheels), integral (11), pair 4-5 cylindrical.

    """
    phi1, R4, R5, e2 = as_floats(phi1=phi1, R4=R4, R5=R5, e2=e2)
    inside = (R4 > 0) & np.isfinite(R4) & (R5 > 0) & np.isfinite(R5) & (e2 >= 0) & (e2 < 1)
    R4 = nan_outside(R4, inside)
    return in_blocks(
        _position_cylindrical, (phi1,), _prepare_position_cylindrical, (R4, R5, e2), out=out
    )


def _prepare_position_cylindrical(R4: Any, R5: Any, e2: Any) -> tuple[Any, ...]:
    k = R4 / R5
    one_minus_e2 = 1 - e2
    one_plus_e2 = 1 + e2

    return (R4, R5, e2, k, one_minus_e2, one_plus_e2)


def _position_cylindrical(
    phi1: Any, R4: Any, R5: Any, e2: Any, k: Any, one_minus_e2: Any, one_plus_e2: Any
) -> Any:
    x = 2 * k * phi1
    t = np.tan(x / 2)

    return (R5 - R4) / R5 * phi1 - np.arctan(2 * e2 / (one_minus_e2 + one_plus_e2 * t**2) * t)


# Source: Prikhodko et al. 2024 (oval wheels), derivative of (10), pair 4-5 cylindrical
# Expression sha256: bd0148c962e84df813095c1a019189f4a423d568a23a9314b13f59408733a46b
# Form: half-angle quotient
# Rewrites: half_angle_tangent
# Operations: 22
def acceleration_cylindrical(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute d ratio/d phi1 with a cylindrical pair 4-5.

        acceleration_cylindrical = 4*e2*k**2*(1 - e2**2)*sin(x)/(1 + e2**2 - 2*e2*cos(x))**2
        k = R4/R5
        x = 2*k*phi1

    Parameters
    ----------
    phi1 : array_like, any shape
        Carrier angle, any number of turns (rad).
    R4 : array_like, any shape
        Radius of the cylindrical sun 4 (mm).
    R5 : array_like, any shape
        Radius of the cylindrical wheel 5 (mm).
    e2 : array_like, any shape
        Eccentricity of the oval pair 6-3 (pure number).
    out : ndarray, optional
        Where the result goes, of its type and shape; it may overlap an argument.

    Returns
    -------
    ndarray or NumPy scalar
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
    Domain: 0 < R4 < oo, 0 < R5 < oo, 0 <= e2 < 1.

    Outside it the result is NaN, by way of R4.

    Accuracy held by the tests: error <= 25 eps * (|value| + |x|*4*e2*k**2*(1 - e2**2)/(1 +
    e2**2 - 2*e2*cos(x))**2, where eps*|x| <= (1 - e2)/4), eps the spacing of floats at 1.

    Source: Prikhodko et al. 2024 (oval wheels), derivative of (10), pair 4-5 cylindrical.

    """
    phi1, R4, R5, e2 = as_floats(phi1=phi1, R4=R4, R5=R5, e2=e2)
    inside = (R4 > 0) & np.isfinite(R4) & (R5 > 0) & np.isfinite(R5) & (e2 >= 0) & (e2 < 1)
    R4 = nan_outside(R4, inside)
    return in_blocks(
        _acceleration_cylindrical, (phi1,), _prepare_acceleration_cylindrical, (R4, R5, e2), out=out
    )


def _prepare_acceleration_cylindrical(R4: Any, R5: Any, e2: Any) -> tuple[Any, ...]:
    one_minus_e2 = 1 - e2
    one_plus_e2 = 1 + e2
    k = R4 / R5

    return (e2, one_minus_e2, one_plus_e2, k)


def _acceleration_cylindrical(
    phi1: Any, e2: Any, one_minus_e2: Any, one_plus_e2: Any, k: Any
) -> Any:
    x = 2 * k * phi1
    t = np.tan(x / 2)
    t_squared = t**2

    return (
        8
        * e2
        * one_minus_e2
        * one_plus_e2
        * k**2
        / (one_minus_e2**2 + one_plus_e2**2 * t_squared) ** 2
        * t
        * (1 + t_squared)
    )
