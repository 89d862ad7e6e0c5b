"""Kernels of the system `oval_planetary`.

Prikhodko, Kurapov, Belina, Azizov, Polivoda 2024, planetary mechanism with oval wheels, EDN
HZWKZJ

Angles in radians, positive in the direction of the carrier's rotation; lengths in mm. The
paper's (10) has the opposite sign.

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

    t = tan(phi1)
    both = (1 + e1)*(1 + e2)
    less = (1 - e1)*(1 - e2)
    lever = 4*e2*sin(mount)/(1 - e2)
    rise = lever*(1 + e1)*cos(mount)
    shift = lever*(1 - e1)*sin(mount)
    y = shift + rise*t
    S = both**2*t**2 + (less + y)**2
    W = both*(less + shift)*(1 + t**2)/S
    swing = 2*e1 + 2*e2
    Z = t*(swing*(both + less) - 2*less*shift) + y*(rise - shift*t) + less*rise*(1 - t**2)
    k = R4/R5
    x = 2*k*phi1

    the larger of 1 and W, and what the roundings of y make of it (ratio) = W*(rise*t -
        shift)**2/(2**52*S) + |W*(less + y)*(rise*t - shift)/S| + Max(1, W)

    the value or its largest term, and what the roundings of y make of it (position) =
        |both*t*(rise*t - shift)|/(2*S) + Max(|y*sin(phi1)|/R, swing*|sin(phi1)|/R, |value|)
    R = sqrt(S)
    value = atan2(t*(y - swing), less + y + both*t**2)

    the value or its largest term, and what the roundings of y make of it (acceleration) =
        W*(|(rise*t - shift)*(shift*t + Z*(4*less + 4*y)/S - rise)| +
        2*Max(2*less*shift*|t|, less*(1 + t**2)*|rise|, swing*(both + less)*|t|, |Z|,
        |y*(rise - shift*t)|, |y*(rise + shift*t)|/2))/S

    the larger of 1 and 1 - value, and the effect of eps*x (ratio_cylindrical) =
        |x|*|e2*k*(e2**2 - 1)*sin(x)/(1 + e2**2 - 2*e2*cos(x))**2|/2**51 + Max(1, k*(1 -
        e2**2)/(1 + e2**2 - 2*e2*cos(x)))

    the larger of both terms, and what eps*x makes of the second (position_cylindrical) =
        |x|*|e2**2*sin(x)**2/(e2**2*sin(x)**2 + (e2*cos(x) - 1)**2) + e2*(e2*cos(x) -
        1)*cos(x)/(e2**2*sin(x)**2 + (e2*cos(x) - 1)**2)|/2**52 + Max(|phi1*(R4 - R5)|/R5,
        |atan2(e2*sin(x), 1 - e2*cos(x))|)

    the value and the effect of eps*x (acceleration_cylindrical) = 4*k**2*|e2*(e2**2 -
        1)*sin(x)/(1 + e2**2 - 2*e2*cos(x))**2| + e2*k**2*(1 - e2**2)*|x|/(2**50*(1 + e2**2
        - 2*e2*cos(x))**2)

    the larger of the terms, and what the roundings of y make of them (jerk) = W*(8*Z**2/S +
        8*(less + shift)*|rise*t| + 2*(1 + t**2)*(rise**2 + shift*(2*less + shift) +
        swing*(both + less)) + 16*(|less + y| + |rise - shift*t|)*|Z*(rise*t - shift)|/S)/S

    the larger of the two terms, with 1 for cos(x), and the effect of eps*x
        (jerk_cylindrical) = e2*k**3*(1 - e2**2)*(24*e2**2*sin(x)**2 +
        12*e2*(4*e2*sin(x/2)**2 + (1 - e2)**2)*|cos(x)| + (4*e2*sin(x/2)**2 + (1 -
        e2)**2)**2)*|x|*|sin(x)|/(2**49*(4*e2*sin(x/2)**2 + (1 - e2)**2)**4) +
        Max(8*e2*k**3*(1 - e2**2)/(4*e2*sin(x/2)**2 + (1 - e2)**2)**2, 32*e2**2*k**3*(1 -
        e2**2)*sin(x)**2/(4*e2*sin(x/2)**2 + (1 - e2)**2)**3)

Generated from the derivation oval_planetary with SymPy 1.14.0.
Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""

from __future__ import annotations

from builtins import abs as _abs
from typing import Any

import numpy as _np
from numpy.typing import ArrayLike, NDArray

from mechproof.kernel_support.arrays import as_floats as _as_floats
from mechproof.kernel_support.blocks import in_blocks as _in_blocks
from mechproof.kernel_support.domains import (
    holds as _holds,
    is_finite as _is_finite,
    is_positive as _is_positive,
    nan_outside as _nan_outside,
)
from mechproof.kernel_support.error_free import (
    product_rest as _product_rest,
    quotient_rest as _quotient_rest,
    small_tangent as _small_tangent,
    sum_rest as _sum_rest,
)
from mechproof.kernel_support.facts import Condition as _Condition, Sizes as _Sizes
from mechproof.kernel_support.functions import square as _square

__all__ = [
    "acceleration",
    "acceleration_cylindrical",
    "jerk",
    "jerk_cylindrical",
    "position",
    "position_cylindrical",
    "ratio",
    "ratio_cylindrical",
]

DOMAIN = (
    _Condition(
        "e1",
        "0 <= e1 < 1",
        ("e1",),
        lambda e1: (e1 >= 0) & (e1 < 1),
        ("ratio", "position", "acceleration", "jerk"),
    ),
    _Condition(
        "e2",
        "0 <= e2 < 1",
        ("e2",),
        lambda e2: (e2 >= 0) & (e2 < 1),
        (
            "ratio",
            "position",
            "acceleration",
            "ratio_cylindrical",
            "position_cylindrical",
            "acceleration_cylindrical",
            "jerk",
            "jerk_cylindrical",
        ),
    ),
    _Condition(
        "R4",
        "0 < R4 < oo",
        ("R4",),
        lambda R4: (R4 > 0) & _is_finite(R4),
        (
            "ratio_cylindrical",
            "position_cylindrical",
            "acceleration_cylindrical",
            "jerk_cylindrical",
        ),
    ),
    _Condition(
        "R5",
        "0 < R5 < oo",
        ("R5",),
        lambda R5: (R5 > 0) & _is_finite(R5),
        (
            "ratio_cylindrical",
            "position_cylindrical",
            "acceleration_cylindrical",
            "jerk_cylindrical",
        ),
    ),
)
PUBLISHED = (
    _Sizes("variant 1", {"e1": 0.2, "e2": 0.2}, ()),
    _Sizes("variant 2", {"R4": 25.0, "R5": 25.0, "e2": 0.2}, ()),
    _Sizes("variant 3", {"R4": 30.0, "R5": 20.0, "e2": 0.2}, ()),
    _Sizes("variant 4", {"R4": 32.0, "R5": 18.0, "e2": 0.2}, ()),
)


def __dir__() -> list[str]:
    return __all__


# Source: Prikhodko et al. 2024 (oval wheels), equation (10)
# Expressions sha256: 4fa78bd90400bf094bf74bd08a302fb8230798daf67a6337c651a2ea558b75c0
# Form: quotient in tan(phi1)
# Operations: 30
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

    Returns
    -------
    ndarray or NumPy scalar (pure number)

    Notes
    -----
    Domain: 0 <= e1, e2 < 1.

    Accuracy, tested: 10 eps of the larger of 1 and W, and what the roundings of y make of it.

    Proved, where mount = 0, |phi1| <= 3/2 and e1, e2 <= 1/2, as long as no result overflows or
    falls below the normal range: at most 6.8 eps with np.cos within 1 ulp and np.sin within 1
    ulp and np.tan within 1 ulp, found 4.83; at most 7.75 eps compiled, found 5.86.

    Source: Prikhodko et al. 2024 (oval wheels), equation (10).

    """
    phi1, e1, e2, mount = _as_floats("phi1 e1 e2 mount", phi1, e1, e2, mount)
    e1, e2 = _nan_outside(_check_of_ratio, e1, e2)
    return _in_blocks(_form_of_ratio, (phi1,), _prepare_of_ratio, (e1, e2, mount), out=out)


def _check_of_ratio(e1: Any, e2: Any) -> tuple[Any, ...]:
    return (e1 >= 0.0, e1 < 1.0, e2 >= 0.0, e2 < 1.0)


def _prepare_of_ratio(e1: Any, e2: Any, mount: Any) -> tuple[Any, ...]:
    one_plus_e1 = 1.0 + e1
    both = one_plus_e1 * (1.0 + e2)
    one_minus_e1 = 1.0 - e1
    one_minus_e2 = 1.0 - e2
    less = one_minus_e1 * one_minus_e2
    sin_mount = _np.sin(mount)
    lever = 4.0 * e2 * sin_mount / one_minus_e2
    shift = lever * one_minus_e1 * sin_mount
    rise = lever * one_plus_e1 * _np.cos(mount)

    return (both, less, shift, rise)


def _form_of_ratio(phi1: Any, both: Any, less: Any, shift: Any, rise: Any) -> Any:
    tan_phi1 = _np.tan(phi1)
    y = shift + rise * tan_phi1
    tan_phi1_squared = _square(tan_phi1)

    return 1.0 - both * (less + shift) / (_square(both) * tan_phi1_squared + _square(less + y)) * (
        1.0 + tan_phi1_squared
    )


# Source: Prikhodko et al. 2024 (oval wheels), integral (11)
# Expressions sha256: a2397a9e807261f3665754144248d98d8b3a51cf18b1eef27f8fd921132d3051
# Form: one arctangent of tan(phi1)
# Operations: 28
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

    Returns
    -------
    ndarray or NumPy scalar (rad)

    Notes
    -----
    Domain: 0 <= e1, e2 < 1.

    Accuracy, tested: 7 eps of the value or its largest term, and what the roundings of y make
    of it, where (phi1 = 0 or e1 + e2 = 0 or 2**-960 <= (e1 + e2)*|phi1|) and (e2 = 0 or mount =
    0 or 2**-830 <= e2*|mount|).

    Proved, where mount = 0, |phi1| <= 3/2 and e1, e2 <= 1/2, as long as no result overflows or
    falls below the normal range: at most 6.45 eps with np.arctan2 within 1 ulp and np.cos
    within 1 ulp and np.sin within 1 ulp and np.tan within 1 ulp, found 4.66; at most 7.38 eps
    compiled, found 5.71.

    Source: Prikhodko et al. 2024 (oval wheels), integral (11).

    """
    phi1, e1, e2, mount = _as_floats("phi1 e1 e2 mount", phi1, e1, e2, mount)
    e1, e2 = _nan_outside(_check_of_ratio, e1, e2)
    return _in_blocks(_form_of_position, (phi1,), _prepare_of_position, (e1, e2, mount), out=out)


def _prepare_of_position(e1: Any, e2: Any, mount: Any) -> tuple[Any, ...]:
    sin_mount = _np.sin(mount)
    one_minus_e2 = 1.0 - e2
    lever = 4.0 * e2 * sin_mount / one_minus_e2
    one_minus_e1 = 1.0 - e1
    shift = lever * one_minus_e1 * sin_mount
    one_plus_e1 = 1.0 + e1
    rise = lever * one_plus_e1 * _np.cos(mount)
    swing = 2.0 * e1 + 2.0 * e2
    less = one_minus_e1 * one_minus_e2
    both = one_plus_e1 * (1.0 + e2)

    return (shift, rise, swing, less, both)


def _form_of_position(phi1: Any, shift: Any, rise: Any, swing: Any, less: Any, both: Any) -> Any:
    tan_phi1 = _np.tan(phi1)
    y = shift + rise * tan_phi1

    return _np.arctan2(tan_phi1 * (y - swing), less + y + both * _square(tan_phi1))


# Source: Prikhodko et al. 2024 (oval wheels), derivative of (10)
# Expressions sha256: 03ad4ce6b842072ee747b9bb46ff1a7cdddaef00cc9e6332565ec616e81ae2fa
# Form: quotient in tan(phi1)
# Rewrites: low_product
# Operations: 67
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

    Returns
    -------
    ndarray or NumPy scalar (pure number)

    Notes
    -----
    Domain: 0 <= e1, e2 < 1.

    Accuracy, tested: 15 eps of the value or its largest term, and what the roundings of y make
    of it, where (phi1 = 0 or e1 + e2 = 0 or 2**-960 <= (e1 + e2)*|phi1|) and (e2 = 0 or mount =
    0 or 2**-830 <= e2*|mount|).

    Proved, where mount = 0, |phi1| <= 3/2 and e1, e2 <= 1/4, as long as no result overflows or
    falls below the normal range: at most 15.56 eps with np.cos within 1 ulp and np.sin within 1
    ulp and np.tan within 1 ulp, found 8.04; at most 17.17 eps compiled, found 8.56.

    Source: Prikhodko et al. 2024 (oval wheels), derivative of (10).

    """
    phi1, e1, e2, mount = _as_floats("phi1 e1 e2 mount", phi1, e1, e2, mount)
    e1, e2 = _nan_outside(_check_of_ratio, e1, e2)
    return _in_blocks(
        _form_of_acceleration, (phi1,), _prepare_of_acceleration, (e1, e2, mount), out=out
    )


def _prepare_of_acceleration(e1: Any, e2: Any, mount: Any) -> tuple[Any, ...]:
    one_plus_e1 = 1.0 + e1
    one_plus_e2 = 1.0 + e2
    both_high = one_plus_e1 * one_plus_e2
    one_plus_e2_low = _sum_rest(1.0, e2, one_plus_e2)
    one_plus_e1_low = _sum_rest(1.0, e1, one_plus_e1)
    both_low = (
        one_plus_e1 * one_plus_e2_low
        + one_plus_e1_low * one_plus_e2
        + _product_rest(one_plus_e1, one_plus_e2, both_high)
    )
    both = both_high + both_low
    one_minus_e1 = 1.0 - e1
    one_minus_e2 = 1.0 - e2
    less_high = one_minus_e1 * one_minus_e2
    one_minus_e2_low = _sum_rest(1.0, -e2, one_minus_e2)
    one_minus_e1_low = _sum_rest(1.0, -e1, one_minus_e1)
    less_low = (
        one_minus_e1 * one_minus_e2_low
        + one_minus_e1_low * one_minus_e2
        + _product_rest(one_minus_e1, one_minus_e2, less_high)
    )
    less = less_high + less_low
    sin_mount = _np.sin(mount)
    lever = 4.0 * e2 * sin_mount / one_minus_e2
    shift = lever * one_minus_e1 * sin_mount
    rise = lever * one_plus_e1 * _np.cos(mount)
    swing = 2.0 * e1 + 2.0 * e2

    return (both, less, shift, rise, swing)


def _form_of_acceleration(
    phi1: Any, both: Any, less: Any, shift: Any, rise: Any, swing: Any
) -> Any:
    tan_phi1 = _np.tan(phi1)
    y = shift + rise * tan_phi1
    tan_phi1_squared = _square(tan_phi1)

    return (
        2.0
        * both
        * (less + shift)
        / _square(_square(both) * tan_phi1_squared + _square(less + y))
        * (1.0 + tan_phi1_squared)
        * (
            (swing * (both + less) - 2.0 * less * shift) * tan_phi1
            + y * (rise - shift * tan_phi1)
            + less * rise * (1.0 - tan_phi1_squared)
        )
    )


# Source: Prikhodko et al. 2024 (oval wheels), equation (10), pair 4-5 cylindrical
# Expressions sha256: 66813425db29bb27833abeeeb7af61d5e1e556ca1182dddf5d3142408fbcb750
# Form: half-angle quotient with low word
# Rewrites: low_word, half_angle_tangent
# Operations: 32
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

    Returns
    -------
    ndarray or NumPy scalar (pure number)

    Notes
    -----
    Domain: 0 < R4, R5 < oo, 0 <= e2 < 1.

    Accuracy, tested: 10 eps of the larger of 1 and 1 - value, and the effect of eps*x, where
    |x| <= 2**26.

    Proved, where |x| <= 22/7, as long as no result overflows or falls below the normal range:
    at most 11 eps with np.tan within 1 ulp, found 6.22; at most 12.5 eps compiled, found 6.72.

    Source: Prikhodko et al. 2024 (oval wheels), equation (10), pair 4-5 cylindrical.

    """
    phi1, R4, R5, e2 = _as_floats("phi1 R4 R5 e2", phi1, R4, R5, e2)
    R4, R5, e2 = _nan_outside(_check_of_ratio_cylindrical, R4, R5, e2)
    return _in_blocks(
        _form_of_ratio_cylindrical, (phi1,), _prepare_of_ratio_cylindrical, (R4, R5, e2), out=out
    )


def _check_of_ratio_cylindrical(R4: Any, R5: Any, e2: Any) -> tuple[Any, ...]:
    return (_is_positive(R4), _is_positive(R5), e2 >= 0.0, e2 < 1.0)


def _prepare_of_ratio_cylindrical(R4: Any, R5: Any, e2: Any) -> tuple[Any, ...]:
    k = R4 / R5
    one_minus_e2 = 1.0 - e2
    one_plus_e2 = 1.0 + e2
    k_low = _quotient_rest(R4, R5, k)

    return (k, one_minus_e2, one_plus_e2, k_low)


def _form_of_ratio_cylindrical(
    phi1: Any, k: Any, one_minus_e2: Any, one_plus_e2: Any, k_low: Any
) -> Any:
    x = 2.0 * k * phi1
    t = _np.tan(x / 2.0)
    x_low = 2.0 * k_low * phi1 + 2.0 * _product_rest(k, phi1, x / 2.0)
    t_low = _small_tangent(x_low / 2.0)
    adjacent = 1.0 - t * t_low
    adjacent_squared = _square(adjacent)
    opposite = t + t_low
    opposite_squared = _square(opposite)

    return 1.0 - k * one_minus_e2 * one_plus_e2 / (
        _square(one_minus_e2) * adjacent_squared + _square(one_plus_e2) * opposite_squared
    ) * (adjacent_squared + opposite_squared)


# Source: Prikhodko et al. 2024 (oval wheels), integral (11), pair 4-5 cylindrical
# Expressions sha256: f8b907549eae029485216bcc629080770ee49b161db6cef2debba288a7aae18d
# Form where e2 * R4 <= (1.0 - e2) * _abs(R4 - R5): half-angle atan
# Rewrites: positive_atan2, half_angle_tangent
# Operations: 18
# Form: half-angle atan with low word
# Rewrites: positive_atan2, low_word, half_angle_tangent
# Operations: 33
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

    Returns
    -------
    ndarray or NumPy scalar (rad)

    Notes
    -----
    Domain: 0 < R4, R5 < oo, 0 <= e2 < 1.

    Where R4*e2 <= (1 - e2)*|R4 - R5| for all elements, half-angle atan is computed.

    Accuracy, tested: 7 eps of the larger of both terms, and what eps*x makes of the second,
    where |x| <= 2**26 and (e2 = 0 or phi1 = 0 or 2**-960 <= e2*|phi1|).

    Proved of half-angle atan, where |x| <= 3 and e2 <= 1/2, as long as no result overflows or
    falls below the normal range: at most 8 eps with np.arctan within 1 ulp and np.tan within 1
    ulp, found 4.97; at most 10 eps compiled, found 5.76.

    Source: Prikhodko et al. 2024 (oval wheels), integral (11), pair 4-5 cylindrical.

    """
    phi1, R4, R5, e2 = _as_floats("phi1 R4 R5 e2", phi1, R4, R5, e2)
    R4, R5, e2 = _nan_outside(_check_of_ratio_cylindrical, R4, R5, e2)
    if _holds(e2 * R4 <= (1.0 - e2) * _abs(R4 - R5)):
        return _in_blocks(
            _form_1_of_position_cylindrical,
            (phi1,),
            _prepare_1_of_position_cylindrical,
            (R4, R5, e2),
            out=out,
        )
    return _in_blocks(
        _form_of_position_cylindrical,
        (phi1,),
        _prepare_of_position_cylindrical,
        (R4, R5, e2),
        out=out,
    )


def _prepare_1_of_position_cylindrical(R4: Any, R5: Any, e2: Any) -> tuple[Any, ...]:
    k = R4 / R5
    one_minus_e2 = 1.0 - e2
    one_plus_e2 = 1.0 + e2

    return (R4, R5, e2, k, one_minus_e2, one_plus_e2)


def _form_1_of_position_cylindrical(
    phi1: Any, R4: Any, R5: Any, e2: Any, k: Any, one_minus_e2: Any, one_plus_e2: Any
) -> Any:
    x = 2.0 * k * phi1
    t = _np.tan(x / 2.0)

    return (R5 - R4) / R5 * phi1 - _np.arctan(
        2.0 * e2 / (one_minus_e2 + one_plus_e2 * _square(t)) * t
    )


def _prepare_of_position_cylindrical(R4: Any, R5: Any, e2: Any) -> tuple[Any, ...]:
    k = R4 / R5
    k_low = _quotient_rest(R4, R5, k)
    one_minus_e2 = 1.0 - e2
    one_plus_e2 = 1.0 + e2

    return (R4, R5, e2, k, k_low, one_minus_e2, one_plus_e2)


def _form_of_position_cylindrical(
    phi1: Any, R4: Any, R5: Any, e2: Any, k: Any, k_low: Any, one_minus_e2: Any, one_plus_e2: Any
) -> Any:
    x = 2.0 * k * phi1
    t = _np.tan(x / 2.0)
    x_low = 2.0 * k_low * phi1 + 2.0 * _product_rest(k, phi1, x / 2.0)
    t_low = _small_tangent(x_low / 2.0)
    adjacent = 1.0 - t * t_low
    opposite = t + t_low

    return (R5 - R4) / R5 * phi1 - _np.arctan(
        2.0
        * e2
        / (one_minus_e2 * _square(adjacent) + one_plus_e2 * _square(opposite))
        * adjacent
        * opposite
    )


# Source: Prikhodko et al. 2024 (oval wheels), derivative of (10), pair 4-5 cylindrical
# Expressions sha256: bd0148c962e84df813095c1a019189f4a423d568a23a9314b13f59408733a46b
# Form: half-angle quotient with low word
# Rewrites: low_word, half_angle_tangent
# Operations: 37
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

    Returns
    -------
    ndarray or NumPy scalar (pure number)

    Notes
    -----
    Domain: 0 < R4, R5 < oo, 0 <= e2 < 1.

    Accuracy, tested: 16 eps of the value and the effect of eps*x, where |x| <= 2**26 and
    R5/1e45 <= R4 <= 1e130*R5 and (e2 = 0 or phi1 = 0 or 2**-960 <= e2*|phi1|) and (e2 = 0 or
    2**-330 <= e2).

    Proved, where |x| <= 22/7 and |pi - |x|| >= 2**-40, as long as no result overflows or falls
    below the normal range: at most 15 eps with np.tan within 1 ulp, found 10.84; at most 16.5
    eps compiled, found 11.54.

    Source: Prikhodko et al. 2024 (oval wheels), derivative of (10), pair 4-5 cylindrical.

    """
    phi1, R4, R5, e2 = _as_floats("phi1 R4 R5 e2", phi1, R4, R5, e2)
    R4, R5, e2 = _nan_outside(_check_of_ratio_cylindrical, R4, R5, e2)
    return _in_blocks(
        _form_of_acceleration_cylindrical,
        (phi1,),
        _prepare_of_acceleration_cylindrical,
        (R4, R5, e2),
        out=out,
    )


def _prepare_of_acceleration_cylindrical(R4: Any, R5: Any, e2: Any) -> tuple[Any, ...]:
    k = R4 / R5
    k_low = _quotient_rest(R4, R5, k)
    one_minus_e2 = 1.0 - e2
    one_plus_e2 = 1.0 + e2

    return (e2, k, k_low, one_minus_e2, one_plus_e2)


def _form_of_acceleration_cylindrical(
    phi1: Any, e2: Any, k: Any, k_low: Any, one_minus_e2: Any, one_plus_e2: Any
) -> Any:
    x = 2.0 * k * phi1
    t = _np.tan(x / 2.0)
    x_low = 2.0 * k_low * phi1 + 2.0 * _product_rest(k, phi1, x / 2.0)
    t_low = _small_tangent(x_low / 2.0)
    adjacent = 1.0 - t * t_low
    opposite = t + t_low
    adjacent_squared = _square(adjacent)
    opposite_squared = _square(opposite)

    return (
        8.0
        * e2
        * one_minus_e2
        * one_plus_e2
        * _square(k)
        / _square(
            _square(one_minus_e2) * adjacent_squared + _square(one_plus_e2) * opposite_squared
        )
        * adjacent
        * opposite
        * (adjacent_squared + opposite_squared)
    )


# Source: Prikhodko et al. 2024 (oval wheels), second derivative of (10)
# Expressions sha256: e549b5ee6b9b78381a19f40a588dc2c9bce89149d7168efd29c848ffe136ac61
# Form: quotient in tan(phi1)
# Rewrites: low_product
# Operations: 83
def jerk(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute d acceleration/d phi1, the jerk of the output at unit carrier speed.

        jerk = -2*alpha*beta*(4*beta**2*cos(2*phi1) + 8*beta*gamma*sin(2*phi1) - 4*(alpha**2 +
            gamma**2)*cos(2*phi1))/(beta**2*(1 + cos(2*phi1)) + (1 - cos(2*phi1))*(alpha**2 +
            gamma**2) + 2*beta*gamma*sin(2*phi1))**2 - 2*alpha*beta*(2*beta**2*sin(2*phi1) -
            2*(alpha**2 + gamma**2)*sin(2*phi1) -
            4*beta*gamma*cos(2*phi1))*(4*beta**2*sin(2*phi1) - 4*(alpha**2 +
            gamma**2)*sin(2*phi1) - 8*beta*gamma*cos(2*phi1))/(beta**2*(1 + cos(2*phi1)) + (1 -
            cos(2*phi1))*(alpha**2 + gamma**2) + 2*beta*gamma*sin(2*phi1))**3
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

    Returns
    -------
    ndarray or NumPy scalar (pure number)

    Notes
    -----
    Domain: 0 <= e1, e2 < 1.

    Accuracy, tested: 30 eps of the larger of the terms, and what the roundings of y make of
    them, where (phi1 = 0 or e1 + e2 = 0 or 2**-960 <= (e1 + e2)*|phi1|) and (e2 = 0 or mount =
    0 or 2**-830 <= e2*|mount|).

    Proved, where mount = 0, |phi1| <= 3/2 and e1, e2 <= 1/4, as long as no result overflows or
    falls below the normal range: at most 16.5 eps with np.cos within 1 ulp and np.sin within 1
    ulp and np.tan within 1 ulp, found 7.39; at most 18.5 eps compiled, found 7.91.

    Source: Prikhodko et al. 2024 (oval wheels), second derivative of (10).

    """
    phi1, e1, e2, mount = _as_floats("phi1 e1 e2 mount", phi1, e1, e2, mount)
    e1, e2 = _nan_outside(_check_of_ratio, e1, e2)
    return _in_blocks(_form_of_jerk, (phi1,), _prepare_of_jerk, (e1, e2, mount), out=out)


def _prepare_of_jerk(e1: Any, e2: Any, mount: Any) -> tuple[Any, ...]:
    one_plus_e1 = 1.0 + e1
    one_plus_e2 = 1.0 + e2
    both_high = one_plus_e1 * one_plus_e2
    one_plus_e2_low = _sum_rest(1.0, e2, one_plus_e2)
    one_plus_e1_low = _sum_rest(1.0, e1, one_plus_e1)
    both_low = (
        one_plus_e1 * one_plus_e2_low
        + one_plus_e1_low * one_plus_e2
        + _product_rest(one_plus_e1, one_plus_e2, both_high)
    )
    both = both_high + both_low
    one_minus_e1 = 1.0 - e1
    one_minus_e2 = 1.0 - e2
    less_high = one_minus_e1 * one_minus_e2
    one_minus_e2_low = _sum_rest(1.0, -e2, one_minus_e2)
    one_minus_e1_low = _sum_rest(1.0, -e1, one_minus_e1)
    less_low = (
        one_minus_e1 * one_minus_e2_low
        + one_minus_e1_low * one_minus_e2
        + _product_rest(one_minus_e1, one_minus_e2, less_high)
    )
    less = less_high + less_low
    sin_mount = _np.sin(mount)
    lever = 4.0 * e2 * sin_mount / one_minus_e2
    shift = lever * one_minus_e1 * sin_mount
    less_plus_shift = less + shift
    rise = lever * one_plus_e1 * _np.cos(mount)
    swing = 2.0 * e1 + 2.0 * e2
    swing_both_plus_less = swing * (both + less)

    return (both, less, shift, less_plus_shift, rise, swing_both_plus_less)


def _form_of_jerk(
    phi1: Any,
    both: Any,
    less: Any,
    shift: Any,
    less_plus_shift: Any,
    rise: Any,
    swing_both_plus_less: Any,
) -> Any:
    tan_phi1 = _np.tan(phi1)
    y = shift + rise * tan_phi1
    tan_phi1_squared = _square(tan_phi1)
    term = _square(both) * tan_phi1_squared + _square(less + y)
    term_2 = 1.0 - tan_phi1_squared

    return (
        2.0
        * both
        * less_plus_shift
        / _square(term)
        * (1.0 + tan_phi1_squared)
        * (
            (_square(rise) + swing_both_plus_less) * term_2
            - 4.0
            / term
            * _square(
                (swing_both_plus_less - 2.0 * less * shift) * tan_phi1
                + y * (rise - shift * tan_phi1)
                + less * rise * term_2
            )
            - 4.0 * less_plus_shift * rise * tan_phi1
            - shift * (2.0 * less + shift) * term_2
        )
    )


# Source: Prikhodko et al. 2024 (oval wheels), second derivative of (10), pair 4-5 cylindrical
# Expressions sha256: ae8e85d683c09f477eee717bb8845be265395f7add51355f17c545f985d0adf4
# Form: half-angle quotient with low word
# Rewrites: low_word, half_angle_tangent
# Operations: 49
def jerk_cylindrical(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute d acceleration/d phi1 with a cylindrical pair 4-5.

        jerk_cylindrical = k*(8*e2*k**2*(1 - e2**2)*cos(x)/(1 + e2**2 - 2*e2*cos(x))**2 -
            32*e2**2*k**2*(1 - e2**2)*sin(x)**2/(1 + e2**2 - 2*e2*cos(x))**3)
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

    Returns
    -------
    ndarray or NumPy scalar (pure number)

    Notes
    -----
    Domain: 0 < R4, R5 < oo, 0 <= e2 < 1.

    Accuracy, tested: 24 eps of the larger of the two terms, with 1 for cos(x), and the effect
    of eps*x, where |x| <= 2**26 and R5/1e30 <= R4 <= 1e80*R5 and (e2 = 0 or phi1 = 0 or 2**-960
    <= e2*|phi1|) and (e2 = 0 or 2**-300 <= e2).

    Proved, where |x| <= 22/7, as long as no result overflows or falls below the normal range:
    at most 42.57 eps with np.tan within 1 ulp, found 14.33; at most 50.9 eps compiled, found
    15.23.

    Source: Prikhodko et al. 2024 (oval wheels), second derivative of (10), pair 4-5
    cylindrical.

    """
    phi1, R4, R5, e2 = _as_floats("phi1 R4 R5 e2", phi1, R4, R5, e2)
    R4, R5, e2 = _nan_outside(_check_of_ratio_cylindrical, R4, R5, e2)
    return _in_blocks(
        _form_of_jerk_cylindrical, (phi1,), _prepare_of_jerk_cylindrical, (R4, R5, e2), out=out
    )


def _prepare_of_jerk_cylindrical(R4: Any, R5: Any, e2: Any) -> tuple[Any, ...]:
    one_minus_e2 = 1.0 - e2
    one_plus_e2 = 1.0 + e2
    k = R4 / R5
    k_low = _quotient_rest(R4, R5, k)
    one_minus_e2_squared = _square(one_minus_e2)
    one_plus_e2_squared = _square(one_plus_e2)

    return (e2, one_minus_e2, one_plus_e2, k, k_low, one_minus_e2_squared, one_plus_e2_squared)


def _form_of_jerk_cylindrical(
    phi1: Any,
    e2: Any,
    one_minus_e2: Any,
    one_plus_e2: Any,
    k: Any,
    k_low: Any,
    one_minus_e2_squared: Any,
    one_plus_e2_squared: Any,
) -> Any:
    x = 2.0 * k * phi1
    t = _np.tan(x / 2.0)
    x_low = 2.0 * k_low * phi1 + 2.0 * _product_rest(k, phi1, x / 2.0)
    t_low = _small_tangent(x_low / 2.0)
    adjacent = 1.0 - t * t_low
    adjacent_squared = _square(adjacent)
    opposite = t + t_low
    opposite_squared = _square(opposite)
    base = one_minus_e2_squared * adjacent_squared + one_plus_e2_squared * opposite_squared

    return (
        8.0
        * e2
        * one_minus_e2
        * one_plus_e2
        * (k * _square(k))
        / (base * _square(base))
        * (adjacent_squared + opposite_squared)
        * (
            one_minus_e2_squared * _square(_square(adjacent))
            - one_plus_e2_squared * _square(_square(opposite))
            - 12.0 * e2 * adjacent_squared * opposite_squared
        )
    )
