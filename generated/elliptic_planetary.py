"""Kernels of the system `elliptic_planetary`.

Prikhodko, Polivoda, Shchetinin 2024, planetary mechanism with an elliptical pair, doi
10.37313/1990-5378-2024-26-3-164-171

Angles are positive in the direction of the carrier's rotation; distances on the line A-C are
positive from A towards C and B. Lengths in mm, angles in rad.

Generated from mechproof.derivations.elliptic_planetary with SymPy 1.14.0.
Regenerate with `mechproof regenerate`; edits are overwritten.
"""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from mechproof.kernel_support.arrays import as_floats, holds, in_blocks, is_finite, nan_outside
from mechproof.kernel_support.error_free import product_rest, quotient_rest, small_tangent
from mechproof.kernel_support.polynomials import small_arctan, tangent_quotient

__all__ = [
    "acceleration",
    "position",
    "position_principal",
    "position_printed",
    "ratio",
]

# tan(r/2)/r in powers of r**2
TANGENT = (
    (0.5, -0.016035293642667474, 8.768104139812438e-05, -5.8456452551230476e-08),
    (1.0, -0.11540392061866767, 0.0014590221343479823, -3.256720523293968e-06),
)
# (atan(y)/y - 1)/y**2 in powers of y**2
ARCTANGENT = (
    (
        -0.333333333333333,
        -0.5450762850257569,
        -0.2613626368664646,
        -0.034672159668541744,
        -0.00014839242515389607,
    ),
    (1.0, 2.2352288550767723, 1.696653795115032, 0.4973868644715952, 0.04408898987456305),
)


# Source: Prikhodko et al. 2024, equation (8)
# Expression sha256: b5fb0f9dcade9b79936108565603b2f32333369257747622bbaec24aeb5a9dad
# Form: half-angle quotient with low word
# Rewrites: low_word, half_angle_tangent
# Operations: 28
def ratio(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the transmission ratio d phi3/d phi1 of the output wheel to the carrier.

        ratio = 1 + k*(1 - e**2)/(1 + e**2 - 2*e*cos(x))
        k = R1/R2
        x = k*phi1

    Parameters
    ----------
    phi1 : array_like, any shape
        Carrier angle, any number of turns (rad).
    R1 : array_like, any shape
        Radius of the epicycle (mm).
    R2 : array_like, any shape
        Radius of the satellite's cylindrical wheel (mm).
    e : array_like, any shape
        Eccentricity of the ellipse (pure number).
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
    Domain: 0 < R1 < oo, 0 < R2 < oo, 0 <= e < 1, R2 < R1.

    Outside it the result is NaN, by way of R1.

    Accuracy held by the tests: error <= 8 eps * (the value, where |x| <= 2**26), eps the
    spacing of floats at 1.

    Source: Prikhodko et al. 2024, equation (8).

    """
    phi1, R1, R2, e = as_floats(phi1=phi1, R1=R1, R2=R2, e=e)
    inside = (R1 > 0) & is_finite(R1) & (R2 > 0) & is_finite(R2) & (e >= 0) & (e < 1) & (R2 < R1)
    R1 = nan_outside(R1, inside)
    return in_blocks(_ratio, (phi1,), _prepare_ratio, (R1, R2, e), out=out)


def _prepare_ratio(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    k = R1 / R2
    one_minus_e = 1 - e
    one_plus_e = 1 + e
    k_low = quotient_rest(R1, R2, k)

    return (k, one_minus_e, one_plus_e, k_low)


def _ratio(phi1: Any, k: Any, one_minus_e: Any, one_plus_e: Any, k_low: Any) -> Any:
    x = k * phi1
    t = np.tan(x / 2)
    x_low = k_low * phi1 + product_rest(k, phi1, x)
    t_low = small_tangent(x_low / 2)
    adjacent = 1 - t * t_low
    adjacent_squared = adjacent**2
    opposite = t + t_low
    opposite_squared = opposite**2

    return 1 + k * one_minus_e * one_plus_e / (
        one_minus_e**2 * adjacent_squared + one_plus_e**2 * opposite_squared
    ) * (adjacent_squared + opposite_squared)


# Source: Prikhodko et al. 2024, integral (9) of equation (8)
# Expression sha256: 830fe82f29ff22f44e6d333c5bd0f88fa521076110b435a728b2024280a941ff
# Form where e <= 1 / 2: half-angle atan
# Rewrites: positive_atan2, half_angle_tangent, small_arc
# Operations: 13
# Form: half-angle atan with low word
# Rewrites: positive_atan2, low_word, half_angle_tangent
# Operations: 29
def position(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the position function phi3(phi1) of the output wheel, phi3(0) = 0.

        position = phi1*(1 + k) + 2*atan2(e*sin(x), 1 - e*cos(x))
        k = R1/R2
        x = k*phi1

    Parameters
    ----------
    phi1 : array_like, any shape
        Carrier angle, any number of turns (rad).
    R1 : array_like, any shape
        Radius of the epicycle (mm).
    R2 : array_like, any shape
        Radius of the satellite's cylindrical wheel (mm).
    e : array_like, any shape
        Eccentricity of the ellipse (pure number).
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
    Domain: 0 < R1 < oo, 0 < R2 < oo, 0 <= e < 1, R2 < R1.

    Outside it the result is NaN, by way of R1.

    Where e <= 1/2 for all elements, half-angle atan is as good.

    There, where NumPy has no vector loop for tan, long arrays are computed by polynomials:
    faster, with other last bits than short ones, and held to the same accuracy.

    Accuracy held by the tests: error <= 4 eps * (the value, where |x| <= 2**26), eps the
    spacing of floats at 1.

    Source: Prikhodko et al. 2024, integral (9) of equation (8).

    """
    phi1, R1, R2, e = as_floats(phi1=phi1, R1=R1, R2=R2, e=e)
    inside = (R1 > 0) & is_finite(R1) & (R2 > 0) & is_finite(R2) & (e >= 0) & (e < 1) & (R2 < R1)
    R1 = nan_outside(R1, inside)
    if holds(e <= 1 / 2):
        return in_blocks(
            _position_shortcut, (phi1,), _prepare_position_shortcut, (R1, R2, e), out=out
        )
    return in_blocks(_position, (phi1,), _prepare_position, (R1, R2, e), out=out)


def _prepare_position_shortcut(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    k = R1 / R2
    one_minus_e = 1 - e
    one_plus_e = 1 + e

    return (e, k, one_minus_e, one_plus_e)


def _position_shortcut(phi1: Any, e: Any, k: Any, one_minus_e: Any, one_plus_e: Any) -> Any:
    x = k * phi1

    return (1 + k) * phi1 + 2 * small_arctan(
        2 * e * tangent_quotient(x / 2, one_minus_e, one_plus_e, TANGENT), ARCTANGENT
    )


def _prepare_position(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    k = R1 / R2
    k_low = quotient_rest(R1, R2, k)
    one_minus_e = 1 - e
    one_plus_e = 1 + e

    return (e, k, k_low, one_minus_e, one_plus_e)


def _position(phi1: Any, e: Any, k: Any, k_low: Any, one_minus_e: Any, one_plus_e: Any) -> Any:
    x = k * phi1
    t = np.tan(x / 2)
    x_low = k_low * phi1 + product_rest(k, phi1, x)
    t_low = small_tangent(x_low / 2)
    adjacent = 1 - t * t_low
    opposite = t + t_low

    return (1 + k) * phi1 + 2 * np.arctan(
        2 * e / (one_minus_e * adjacent**2 + one_plus_e * opposite**2) * adjacent * opposite
    )


# Source: derivative of Prikhodko et al. 2024, equation (8)
# Expression sha256: 91b69a6ba07be0093cc100c53552f487804079c310d6d68931af9e3d14dcd55f
# Form: half-angle quotient with low word
# Rewrites: low_word, half_angle_tangent
# Operations: 34
def acceleration(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute d ratio/d phi1, the angular acceleration of the output at unit carrier speed.

        acceleration = -2*e*k**2*(1 - e**2)*sin(x)/(1 + e**2 - 2*e*cos(x))**2
        k = R1/R2
        x = k*phi1

    Parameters
    ----------
    phi1 : array_like, any shape
        Carrier angle, any number of turns (rad).
    R1 : array_like, any shape
        Radius of the epicycle (mm).
    R2 : array_like, any shape
        Radius of the satellite's cylindrical wheel (mm).
    e : array_like, any shape
        Eccentricity of the ellipse (pure number).
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
    Domain: 0 < R1 < oo, 0 < R2 < oo, 0 <= e < 1, R2 < R1.

    Outside it the result is NaN, by way of R1.

    Accuracy held by the tests: error <= 8 eps * (|value| + eps*|x|*2*e*k**2*(1 - e**2)/(1 +
    e**2 - 2*e*cos(x))**2, where |x| <= 2**26 and e = 0 or e >= 1e-200), eps the spacing of
    floats at 1.

    Source: derivative of Prikhodko et al. 2024, equation (8).

    """
    phi1, R1, R2, e = as_floats(phi1=phi1, R1=R1, R2=R2, e=e)
    inside = (R1 > 0) & is_finite(R1) & (R2 > 0) & is_finite(R2) & (e >= 0) & (e < 1) & (R2 < R1)
    R1 = nan_outside(R1, inside)
    return in_blocks(_acceleration, (phi1,), _prepare_acceleration, (R1, R2, e), out=out)


def _prepare_acceleration(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    k = R1 / R2
    k_low = quotient_rest(R1, R2, k)
    one_minus_e = 1 - e
    one_plus_e = 1 + e

    return (e, k, k_low, one_minus_e, one_plus_e)


def _acceleration(phi1: Any, e: Any, k: Any, k_low: Any, one_minus_e: Any, one_plus_e: Any) -> Any:
    x = k * phi1
    t = np.tan(x / 2)
    x_low = k_low * phi1 + product_rest(k, phi1, x)
    t_low = small_tangent(x_low / 2)
    adjacent = 1 - t * t_low
    opposite = t + t_low
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


# Source: Prikhodko et al. 2024, equation (12)
# Expression sha256: 57141eb1f5a1911636963a3944f616d16509b37ec44b8f956c64f2d10da47e9d
# Form: as printed
# Operations: 17
def position_printed(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute equation (12) as it stands in print.

    Specimen, not for use: its derivative is not the ratio (8), and it jumps where x/2 passes
    pi/2.

        position_printed = phi1 + 2*sqrt((1 - e)/(1 + e))*atan(sqrt((1 + e)/(1 -
            e))*tan(R1*phi1/(2*R2)))

    Parameters
    ----------
    phi1 : array_like, any shape
        Carrier angle, any number of turns (rad).
    R1 : array_like, any shape
        Radius of the epicycle (mm).
    R2 : array_like, any shape
        Radius of the satellite's cylindrical wheel (mm).
    e : array_like, any shape
        Eccentricity of the ellipse (pure number).
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
    Domain: 0 < R1 < oo, 0 < R2 < oo, 0 <= e < 1, R2 < R1.

    Outside it the result is NaN, by way of R1.

    Source: Prikhodko et al. 2024, equation (12).

    """
    phi1, R1, R2, e = as_floats(phi1=phi1, R1=R1, R2=R2, e=e)
    inside = (R1 > 0) & is_finite(R1) & (R2 > 0) & is_finite(R2) & (e >= 0) & (e < 1) & (R2 < R1)
    R1 = nan_outside(R1, inside)
    return in_blocks(_position_printed, (phi1,), _prepare_position_printed, (R1, R2, e), out=out)


def _prepare_position_printed(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    one_minus_e = 1 - e
    one_plus_e = 1 + e

    return (R1, R2, one_minus_e, one_plus_e)


def _position_printed(phi1: Any, R1: Any, R2: Any, one_minus_e: Any, one_plus_e: Any) -> Any:

    return phi1 + 2 * np.sqrt(one_minus_e / one_plus_e) * np.arctan(
        np.sqrt(one_plus_e / one_minus_e) * np.tan(R1 / (2 * R2) * phi1)
    )


# Source: Prikhodko et al. 2024, equation (12) with the factor of (11) corrected
# Expression sha256: 387e96024e7cecf0d2a5583237b63348953846e0d42093f13a93e610793c85df
# Form: principal branch
# Operations: 11
def position_principal(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the integral (9) by one principal arctangent.

    Specimen, not for use: right only for |phi1| < pi*R2/R1, beyond that off by multiples of
    2*pi.

        position_principal = phi1 + 2*atan((1 + e)*tan(x/2)/(1 - e))
        k = R1/R2
        x = k*phi1

    Parameters
    ----------
    phi1 : array_like, any shape
        Carrier angle, any number of turns (rad).
    R1 : array_like, any shape
        Radius of the epicycle (mm).
    R2 : array_like, any shape
        Radius of the satellite's cylindrical wheel (mm).
    e : array_like, any shape
        Eccentricity of the ellipse (pure number).
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
    Domain: 0 < R1 < oo, 0 < R2 < oo, 0 <= e < 1, R2 < R1, Abs(phi1) < pi*R2/R1 (less than half
    a turn of the satellite).

    Outside it the result is NaN, by way of R1; Abs(phi1) < pi*R2/R1 is not checked.

    Singular: jumps by 2*pi at odd multiples of pi*R2/R1.

    Source: Prikhodko et al. 2024, equation (12) with the factor of (11) corrected.

    """
    phi1, R1, R2, e = as_floats(phi1=phi1, R1=R1, R2=R2, e=e)
    inside = (R1 > 0) & is_finite(R1) & (R2 > 0) & is_finite(R2) & (e >= 0) & (e < 1) & (R2 < R1)
    R1 = nan_outside(R1, inside)
    return in_blocks(
        _position_principal, (phi1,), _prepare_position_principal, (R1, R2, e), out=out
    )


def _prepare_position_principal(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    k = R1 / R2

    return (e, k)


def _position_principal(phi1: Any, e: Any, k: Any) -> Any:
    x = k * phi1

    return phi1 + 2 * np.arctan((1 + e) / (1 - e) * np.tan(x / 2))
