"""Kernels of the system `elliptic_planetary`.

Prikhodko, Polivoda, Shchetinin 2024, planetary mechanism with an elliptical pair, doi
10.37313/1990-5378-2024-26-3-164-171

Angles are positive in the direction of the carrier's rotation; distances on the line A-C
are positive from A towards C and B. Lengths in mm, angles in rad.

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

    the value and the effect of eps*x (ratio) = 1 + k*(1 - e**2)/(1 + e**2 - 2*e*cos(x)) +
        e*k*(1 - e**2)*|x|/(2**51*(1 + e**2 - 2*e*cos(x))**2)

    the value and the effect of eps*x (acceleration) = 2*k**2*|e*(e**2 - 1)*sin(x)/(1 + e**2
        - 2*e*cos(x))**2| + e*k**2*(1 - e**2)*|x|/(2**51*(1 + e**2 - 2*e*cos(x))**2)

    the larger of the two terms, with 1 for cos(x), and the effect of eps*x (jerk) =
        e*k**3*(1 - e**2)*(24*e**2*sin(x)**2 + 12*e*(4*e*sin(x/2)**2 + (1 - e)**2)*|cos(x)|
        + (4*e*sin(x/2)**2 + (1 - e)**2)**2)*|x|*|sin(x)|/(2**51*(4*e*sin(x/2)**2 + (1 -
        e)**2)**4) + Max(2*e*k**3*(1 - e**2)/(4*e*sin(x/2)**2 + (1 - e)**2)**2,
        8*e**2*k**3*(1 - e**2)*sin(x)**2/(4*e*sin(x/2)**2 + (1 - e)**2)**3)

    the value and the effect of rounding 10*e - square (angle_of_largest_jerk) =
        Piecewise((pi, 10*e <= square), (2*atan2(sqrt((10*e + square)*(root_jerk + 2*square
        - 2*e))*(1 - e), sqrt((10*e - square)*(2*e + root_jerk + 2*square))*(1 + e)),
        True))/k + 1/(k*sqrt(Max(2**-52, |10*e - square|)))

    1 (eccentricity_of_largest_ratio) = 1

    1 (eccentricity_of_smallest_ratio) = 1

Generated from the derivation elliptic_planetary with SymPy 1.14.0.
Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""

from __future__ import annotations

from typing import Any

import numpy as _np
from numpy.typing import ArrayLike, NDArray

from mechproof.kernel_support.arrays import as_floats as _as_floats
from mechproof.kernel_support.blocks import in_blocks as _in_blocks
from mechproof.kernel_support.domains import (
    holds as _holds,
    is_finite as _is_finite,
    is_nonnegative as _is_nonnegative,
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
from mechproof.kernel_support.functions import (
    arctan_quotient as _arctan_quotient,
    choose_where as _choose_where,
    small_arctan as _small_arctan,
    square as _square,
    tangent_quotient as _tangent_quotient,
)

__all__ = [
    "acceleration",
    "angle_of_largest_jerk",
    "angle_of_smallest_acceleration",
    "eccentricity_of_extremes",
    "eccentricity_of_largest_ratio",
    "eccentricity_of_non_uniformity",
    "eccentricity_of_quotient",
    "eccentricity_of_smallest_ratio",
    "jerk",
    "largest_acceleration",
    "largest_jerk",
    "largest_ratio",
    "position",
    "radii_of_extremes",
    "ratio",
    "smallest_jerk",
    "smallest_ratio",
]

DOMAIN = (
    _Condition(
        "R1",
        "0 < R1 < oo",
        ("R1",),
        lambda R1: (R1 > 0) & _is_finite(R1),
        (
            "ratio",
            "position",
            "acceleration",
            "largest_ratio",
            "smallest_ratio",
            "jerk",
            "largest_acceleration",
            "angle_of_smallest_acceleration",
            "largest_jerk",
            "smallest_jerk",
            "angle_of_largest_jerk",
            "eccentricity_of_largest_ratio",
            "eccentricity_of_smallest_ratio",
            "eccentricity_of_quotient",
            "eccentricity_of_non_uniformity",
        ),
    ),
    _Condition(
        "R2",
        "0 < R2 < oo",
        ("R2",),
        lambda R2: (R2 > 0) & _is_finite(R2),
        (
            "ratio",
            "position",
            "acceleration",
            "largest_ratio",
            "smallest_ratio",
            "jerk",
            "largest_acceleration",
            "angle_of_smallest_acceleration",
            "largest_jerk",
            "smallest_jerk",
            "angle_of_largest_jerk",
            "eccentricity_of_largest_ratio",
            "eccentricity_of_smallest_ratio",
            "eccentricity_of_quotient",
            "eccentricity_of_non_uniformity",
        ),
    ),
    _Condition(
        "e",
        "0 <= e < 1",
        ("e",),
        lambda e: (e >= 0) & (e < 1),
        (
            "ratio",
            "position",
            "acceleration",
            "largest_ratio",
            "smallest_ratio",
            "jerk",
            "largest_acceleration",
            "angle_of_smallest_acceleration",
            "largest_jerk",
            "smallest_jerk",
            "angle_of_largest_jerk",
        ),
    ),
    _Condition(
        "R2",
        "R2 < R1",
        ("R1", "R2"),
        lambda R1, R2: R2 < R1,
        (
            "ratio",
            "position",
            "acceleration",
            "largest_ratio",
            "smallest_ratio",
            "jerk",
            "largest_acceleration",
            "angle_of_smallest_acceleration",
            "largest_jerk",
            "smallest_jerk",
            "angle_of_largest_jerk",
            "eccentricity_of_largest_ratio",
            "eccentricity_of_smallest_ratio",
            "eccentricity_of_quotient",
            "eccentricity_of_non_uniformity",
        ),
    ),
    _Condition(
        "largest",
        "1 < largest < oo",
        ("largest",),
        lambda largest: (largest > 1) & _is_finite(largest),
        ("eccentricity_of_largest_ratio", "eccentricity_of_extremes", "radii_of_extremes"),
    ),
    _Condition(
        "R1",
        "R1 <= R2*(largest - 1)",
        ("largest", "R1", "R2"),
        lambda largest, R1, R2: R1 <= R2 * (largest - 1),
        ("eccentricity_of_largest_ratio",),
    ),
    _Condition(
        "smallest",
        "1 < smallest < oo",
        ("smallest",),
        lambda smallest: (smallest > 1) & _is_finite(smallest),
        ("eccentricity_of_smallest_ratio", "eccentricity_of_extremes", "radii_of_extremes"),
    ),
    _Condition(
        "R2",
        "R2*(smallest - 1) <= R1",
        ("smallest", "R1", "R2"),
        lambda smallest, R1, R2: R2 * (smallest - 1) <= R1,
        ("eccentricity_of_smallest_ratio",),
    ),
    _Condition(
        "quotient",
        "1 <= quotient < oo",
        ("quotient",),
        lambda quotient: (quotient >= 1) & _is_finite(quotient),
        ("eccentricity_of_quotient",),
    ),
    _Condition(
        "non_uniformity",
        "0 <= non_uniformity < oo",
        ("non_uniformity",),
        lambda non_uniformity: (non_uniformity >= 0) & _is_finite(non_uniformity),
        ("eccentricity_of_non_uniformity",),
    ),
    _Condition(
        "smallest",
        "smallest <= largest, 1 < (largest - 1)*(smallest - 1)",
        ("largest", "smallest"),
        lambda largest, smallest: (smallest <= largest) & ((largest - 1) * (smallest - 1) > 1),
        ("eccentricity_of_extremes", "radii_of_extremes"),
    ),
)
PUBLISHED = (
    _Sizes("Table 1, variant 1", {"R1": 66.0, "R2": 16.0, "e": 0.28}, ()),
    _Sizes("Table 1, variant 2", {"R1": 66.0, "R2": 16.0, "e": 0.475}, ()),
    _Sizes("Table 1, variant 3", {"R1": 80.0, "R2": 30.0, "e": 0.28}, ()),
    _Sizes("Table 1, variant 4", {"R1": 80.0, "R2": 30.0, "e": 0.475}, ()),
)


def __dir__() -> list[str]:
    return __all__


# Source: Prikhodko et al. 2024, equation (8)
# Expressions sha256: b5fb0f9dcade9b79936108565603b2f32333369257747622bbaec24aeb5a9dad
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

    Returns
    -------
    ndarray or NumPy scalar (pure number)

    Notes
    -----
    Domain: 0 < R1, R2 < oo, 0 <= e < 1, R2 < R1.

    Accuracy, tested: 10 eps of the value and the effect of eps*x, where |x| <= 2**26 and (phi1
    = 0 or 1e-290 <= |phi1|) and 1e-300 <= R1 and 1e-300 <= R2.

    Proved, where |x| <= 22/7 or |x| <= 2**26 and (e <= 1 - 2**-10 or |x - 2*pi*n| >= 2**-7 for
    all n), as long as no result overflows or falls below the normal range: at most 10 eps with
    np.tan within 1 ulp, found 7.01; at most 10.82 eps compiled, found 7.88.

    Source: Prikhodko et al. 2024, equation (8).

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio, R1, R2, e)
    return _in_blocks(_form_of_ratio, (phi1,), _prepare_of_ratio, (R1, R2, e), out=out)


def _check_of_ratio(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    return (_is_positive(R1), _is_positive(R2), e >= 0.0, e < 1.0, R2 < R1)


def _prepare_of_ratio(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    k = R1 / R2
    one_minus_e = 1.0 - e
    one_plus_e = 1.0 + e
    k_low = _quotient_rest(R1, R2, k)

    return (k, one_minus_e, one_plus_e, k_low)


def _form_of_ratio(phi1: Any, k: Any, one_minus_e: Any, one_plus_e: Any, k_low: Any) -> Any:
    x = k * phi1
    t = _np.tan(x / 2.0)
    x_low = k_low * phi1 + _product_rest(k, phi1, x)
    t_low = _small_tangent(x_low / 2.0)
    adjacent = 1.0 - t * t_low
    adjacent_squared = _square(adjacent)
    opposite = t + t_low
    opposite_squared = _square(opposite)

    return 1.0 + k * one_minus_e * one_plus_e / (
        _square(one_minus_e) * adjacent_squared + _square(one_plus_e) * opposite_squared
    ) * (adjacent_squared + opposite_squared)


# Source: Prikhodko et al. 2024, integral (9) of equation (8)
# Expressions sha256: 13f880f4a6a21c5572bc39200def7042d9af11411e8c1ef77771dd1fd987cd2d
# Form where e <= 12.0 / 25.0: half-angle atan
# Rewrites: positive_atan2, half_angle_tangent, small_arc
# Operations: 14
# Form: half-angle atan with low word
# Rewrites: positive_atan2, low_word, low_sum, half_angle_tangent, quotient_arc
# Operations: 28
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

    Returns
    -------
    ndarray or NumPy scalar (rad)

    Notes
    -----
    Domain: 0 < R1, R2 < oo, 0 <= e < 1, R2 < R1.

    Where e <= 12/25 for all elements, half-angle atan is computed.

    Accuracy, tested: 5.5 eps of the value, where |x| <= 2**26 and (phi1 = 0 or 1e-290 <=
    |phi1|) and 1e-300 <= R1 and 1e-300 <= R2.

    Proved of half-angle atan, where |x| <= 2**26, as long as no result overflows or falls below
    the normal range: at most 3.94 eps with np.arctan within 1 ulp and np.tan within 1 ulp,
    found 3.17; at most 3.86 eps compiled, found 3.29.

    Proved of half-angle atan with low word, where |x| <= 22/7 or |x| <= 2**26 and (e <= 1 -
    2**-10 or |x - 2*pi*n| >= 2**-7 for all n), as long as no result overflows or falls below
    the normal range: at most 4.03 eps with np.arctan2 within 1 ulp and np.tan within 1 ulp,
    found 2.87; at most 5.27 eps compiled, found 4.26.

    Source: Prikhodko et al. 2024, integral (9) of equation (8).

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio, R1, R2, e)
    if _holds(e <= 12.0 / 25.0):
        return _in_blocks(
            _form_1_of_position, (phi1,), _prepare_1_of_position, (R1, R2, e), out=out
        )
    return _in_blocks(_form_of_position, (phi1,), _prepare_of_position, (R1, R2, e), out=out)


def _prepare_1_of_position(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    k = R1 / R2
    half_k = k / 2.0
    one_minus_e = 1.0 - e
    one_minus_e_low = _sum_rest(1.0, -e, one_minus_e)
    one_plus_e = 1.0 + e

    return (e, k, half_k, one_minus_e, one_minus_e_low, one_plus_e)


def _form_1_of_position(
    phi1: Any, e: Any, k: Any, half_k: Any, one_minus_e: Any, one_minus_e_low: Any, one_plus_e: Any
) -> Any:
    return (1.0 + k) * phi1 + 2.0 * _small_arctan(
        _tangent_quotient(half_k * phi1, 2.0 * e, one_minus_e, one_minus_e_low, one_plus_e)
    )


def _prepare_of_position(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    k = R1 / R2
    k_low = _quotient_rest(R1, R2, k)
    one_minus_e = 1.0 - e
    one_plus_e = 1.0 + e

    return (e, k, k_low, one_minus_e, one_plus_e)


def _form_of_position(
    phi1: Any, e: Any, k: Any, k_low: Any, one_minus_e: Any, one_plus_e: Any
) -> Any:
    x = k * phi1
    x_low = k_low * phi1 + _product_rest(k, phi1, x)
    phi1_plus_x_low = phi1 + x_low
    t = _np.tan(x / 2.0)
    t_low = _small_tangent(x_low / 2.0)
    adjacent = 1.0 - t * t_low
    opposite = t + t_low

    return (
        phi1_plus_x_low
        + x
        + 2.0
        * _arctan_quotient(
            2.0 * e * adjacent * opposite,
            one_minus_e * _square(adjacent) + one_plus_e * _square(opposite),
        )
    )


# Source: derivative of Prikhodko et al. 2024, equation (8)
# Expressions sha256: 91b69a6ba07be0093cc100c53552f487804079c310d6d68931af9e3d14dcd55f
# Form: half-angle quotient with low word
# Rewrites: low_word, half_angle_tangent
# Operations: 33
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

    Returns
    -------
    ndarray or NumPy scalar (pure number)

    Notes
    -----
    Domain: 0 < R1, R2 < oo, 0 <= e < 1, R2 < R1.

    Accuracy, tested: 16 eps of the value and the effect of eps*x, where |x| <= 2**26 and (phi1
    = 0 or 1e-290 <= |phi1|) and 1e-300 <= R1 and 1e-300 <= R2 and R1 <= 1e130*R2 and (e = 0 or
    1e-200 <= e).

    Proved, where |x| <= 22/7 and |pi - |x|| >= 2**-40, as long as no result overflows or falls
    below the normal range: at most 14.55 eps with np.tan within 1 ulp, found 10.23; at most
    15.86 eps compiled, found 11.46.

    Source: derivative of Prikhodko et al. 2024, equation (8).

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio, R1, R2, e)
    return _in_blocks(_form_of_acceleration, (phi1,), _prepare_of_position, (R1, R2, e), out=out)


def _form_of_acceleration(
    phi1: Any, e: Any, k: Any, k_low: Any, one_minus_e: Any, one_plus_e: Any
) -> Any:
    x = k * phi1
    t = _np.tan(x / 2.0)
    x_low = k_low * phi1 + _product_rest(k, phi1, x)
    t_low = _small_tangent(x_low / 2.0)
    adjacent = 1.0 - t * t_low
    opposite = t + t_low
    adjacent_squared = _square(adjacent)
    opposite_squared = _square(opposite)

    return (
        -4.0
        * e
        * one_minus_e
        * one_plus_e
        * _square(k)
        / _square(_square(one_minus_e) * adjacent_squared + _square(one_plus_e) * opposite_squared)
        * adjacent
        * opposite
        * (adjacent_squared + opposite_squared)
    )


# Source: extremes of Prikhodko et al. 2024, equation (8)
# Expressions sha256: b017edbd5d2e5e430c3333c1c68ccc82f8b19eb3899ca560e04999267c36d672
# Form: quotient
# Operations: 6
def largest_ratio(
    R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the largest transmission ratio, at phi1 = 0 and once in each period 2*pi*R2/R1.

        largest_ratio = 1 + k*(1 + e)/(1 - e)
        k = R1/R2

    Parameters
    ----------
    R1 : array_like, any shape
        Radius of the epicycle (mm).
    R2 : array_like, any shape
        Radius of the satellite's cylindrical wheel (mm).
    e : array_like, any shape
        Eccentricity of the ellipse (pure number).

    Returns
    -------
    ndarray or NumPy scalar (pure number)

    Notes
    -----
    Domain: 0 < R1, R2 < oo, 0 <= e < 1, R2 < R1.

    Accuracy, tested: 3 eps of the value, where R1 <= 1e300*R2.

    Proved, as long as no result overflows or falls below the normal range: at most 2.76 eps
    with NumPy's functions, found 2.09; at most 2.76 eps compiled, found 2.09.

    Source: extremes of Prikhodko et al. 2024, equation (8).

    """
    R1, R2, e = _as_floats("R1 R2 e", R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_largest_ratio, R1, R2, e)
    return _in_blocks(_form_of_largest_ratio, (R1,), parameters=(R2, e), out=out)


def _check_of_largest_ratio(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    return (_is_positive(R2), e >= 0.0, e < 1.0, _is_positive(R1), R2 < R1)


def _form_of_largest_ratio(R1: Any, R2: Any, e: Any) -> Any:
    k = R1 / R2

    return 1.0 + (1.0 + e) / (1.0 - e) * k


# Source: extremes of Prikhodko et al. 2024, equation (8)
# Expressions sha256: 68b0ec7ae12bd9b06b323ac53aacae2d0a7345c59fb9a11dd11ead6c00a516e3
# Form: quotient
# Operations: 6
def smallest_ratio(
    R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the smallest transmission ratio, met half a period after the largest.

        smallest_ratio = 1 + k*(1 - e)/(1 + e)
        k = R1/R2

    Parameters
    ----------
    R1 : array_like, any shape
        Radius of the epicycle (mm).
    R2 : array_like, any shape
        Radius of the satellite's cylindrical wheel (mm).
    e : array_like, any shape
        Eccentricity of the ellipse (pure number).

    Returns
    -------
    ndarray or NumPy scalar (pure number)

    Notes
    -----
    Domain: 0 < R1, R2 < oo, 0 <= e < 1, R2 < R1.

    Accuracy, tested: 3 eps of the value, where R1 <= 1e300*R2.

    Proved, as long as no result overflows or falls below the normal range: at most 2.76 eps
    with NumPy's functions, found 2.04; at most 2.76 eps compiled, found 2.04.

    Source: extremes of Prikhodko et al. 2024, equation (8).

    """
    R1, R2, e = _as_floats("R1 R2 e", R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_largest_ratio, R1, R2, e)
    return _in_blocks(_form_of_smallest_ratio, (R1,), parameters=(R2, e), out=out)


def _form_of_smallest_ratio(R1: Any, R2: Any, e: Any) -> Any:
    k = R1 / R2

    return 1.0 + (1.0 - e) / (1.0 + e) * k


# Source: second derivative of Prikhodko et al. 2024, equation (8)
# Expressions sha256: 4f9f6287068ff22af7021154f3ebc31f165e1d1436c88bdc3d171d9f074edd1a
# Form: half-angle quotient with low word
# Rewrites: low_word, half_angle_tangent
# Operations: 45
def jerk(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute d acceleration/d phi1, the jerk of the output at unit carrier speed.

        jerk = k*(8*e**2*k**2*(1 - e**2)*sin(x)**2/(1 + e**2 - 2*e*cos(x))**3 - 2*e*k**2*(1 -
            e**2)*cos(x)/(1 + e**2 - 2*e*cos(x))**2)
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

    Returns
    -------
    ndarray or NumPy scalar (pure number)

    Notes
    -----
    Domain: 0 < R1, R2 < oo, 0 <= e < 1, R2 < R1.

    Accuracy, tested: 24 eps of the larger of the two terms, with 1 for cos(x), and the effect
    of eps*x, where |x| <= 2**26 and (phi1 = 0 or 1e-290 <= |phi1|) and 1e-300 <= R1 and 1e-300
    <= R2 and R1 <= 1e75*R2 and (e = 0 or 1e-100 <= e).

    Proved, where |x| <= 22/7, as long as no result overflows or falls below the normal range:
    at most 25 eps with np.tan within 1 ulp, found 15.05; at most 30 eps compiled, found 16.39.

    Source: second derivative of Prikhodko et al. 2024, equation (8).

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio, R1, R2, e)
    return _in_blocks(_form_of_jerk, (phi1,), _prepare_of_jerk, (R1, R2, e), out=out)


def _prepare_of_jerk(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    one_minus_e = 1.0 - e
    one_plus_e = 1.0 + e
    k = R1 / R2
    k_low = _quotient_rest(R1, R2, k)
    one_minus_e_squared = _square(one_minus_e)
    one_plus_e_squared = _square(one_plus_e)

    return (e, one_minus_e, one_plus_e, k, k_low, one_minus_e_squared, one_plus_e_squared)


def _form_of_jerk(
    phi1: Any,
    e: Any,
    one_minus_e: Any,
    one_plus_e: Any,
    k: Any,
    k_low: Any,
    one_minus_e_squared: Any,
    one_plus_e_squared: Any,
) -> Any:
    x = k * phi1
    t = _np.tan(x / 2.0)
    x_low = k_low * phi1 + _product_rest(k, phi1, x)
    t_low = _small_tangent(x_low / 2.0)
    adjacent = 1.0 - t * t_low
    adjacent_squared = _square(adjacent)
    opposite = t + t_low
    opposite_squared = _square(opposite)
    base = one_minus_e_squared * adjacent_squared + one_plus_e_squared * opposite_squared

    return (
        2.0
        * e
        * one_minus_e
        * one_plus_e
        * (k * _square(k))
        / (base * _square(base))
        * (adjacent_squared + opposite_squared)
        * (
            one_plus_e_squared * _square(_square(opposite))
            + 12.0 * e * adjacent_squared * opposite_squared
            - one_minus_e_squared * _square(_square(adjacent))
        )
    )


# Source: extremes of the derivatives of Prikhodko et al. 2024, equation (8)
# Expressions sha256: 180e10f42ba3a710b7712920bb1b6a57982e3d7d0587e3d5590e98bfc702f718
# Form: quotient
# Operations: 34
def largest_acceleration(
    R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the largest acceleration; the smallest is its negative.

        largest_acceleration = 2*e*k**2*sqrt(peak_acceleration*(8*e + root_acceleration +
            square))*(1 + e)*(root_acceleration + square)/((1 - e)**2*(root_acceleration +
            square + 2*e*peak_acceleration)**2)
        k = R1/R2
        square = 1 + e**2
        root_acceleration = sqrt(32*e**2 + square**2)
        peak_acceleration = 1 + (1 + e)**2/(6*e + root_acceleration)

    Parameters
    ----------
    R1 : array_like, any shape
        Radius of the epicycle (mm).
    R2 : array_like, any shape
        Radius of the satellite's cylindrical wheel (mm).
    e : array_like, any shape
        Eccentricity of the ellipse (pure number).

    Returns
    -------
    ndarray or NumPy scalar (pure number)

    Notes
    -----
    Domain: 0 < R1, R2 < oo, 0 <= e < 1, R2 < R1.

    Accuracy, tested: 20 eps of the value, where 1e-300 <= R1 and 1e-300 <= R2 and R1 <=
    1e75*R2.

    Proved, as long as no result overflows or falls below the normal range: at most 11.66 eps
    with NumPy's functions, found 6.69; at most 11.66 eps compiled, found 6.69.

    Source: extremes of the derivatives of Prikhodko et al. 2024, equation (8).

    """
    R1, R2, e = _as_floats("R1 R2 e", R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_largest_ratio, R1, R2, e)
    return _in_blocks(
        _form_of_largest_acceleration, (R1,), _prepare_of_largest_acceleration, (R2, e), out=out
    )


def _prepare_of_largest_acceleration(R2: Any, e: Any) -> tuple[Any, ...]:
    one_plus_e = 1.0 + e
    e_squared = _square(e)
    square = 1.0 + e_squared
    root_acceleration = _np.sqrt(32.0 * e_squared + _square(square))
    peak_acceleration = 1.0 + _square(one_plus_e) / (6.0 * e + root_acceleration)

    return (R2, e, one_plus_e, square, root_acceleration, peak_acceleration)


def _form_of_largest_acceleration(
    R1: Any,
    R2: Any,
    e: Any,
    one_plus_e: Any,
    square: Any,
    root_acceleration: Any,
    peak_acceleration: Any,
) -> Any:
    k = R1 / R2

    return (
        2.0
        * e
        * one_plus_e
        * _np.sqrt(peak_acceleration * (8.0 * e + root_acceleration + square))
        * (root_acceleration + square)
        / (_square(1.0 - e) * _square(root_acceleration + square + 2.0 * e * peak_acceleration))
        * _square(k)
    )


# Source: extremes of the derivatives of Prikhodko et al. 2024, equation (8)
# Expressions sha256: c6a0636ebb925fc4bcbb5571a150c43df4132384e6611f9e9ac27c21dc473b52
# Form: quotient
# Operations: 23
def angle_of_smallest_acceleration(
    R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the first phi1 >= 0 where the acceleration is smallest; at -phi1 it is largest.

        angle_of_smallest_acceleration = 2*atan2(sqrt(peak_acceleration)*(1 - e), sqrt(8*e +
            root_acceleration + square))/k
        k = R1/R2
        square = 1 + e**2
        root_acceleration = sqrt(32*e**2 + square**2)
        peak_acceleration = 1 + (1 + e)**2/(6*e + root_acceleration)

    Parameters
    ----------
    R1 : array_like, any shape
        Radius of the epicycle (mm).
    R2 : array_like, any shape
        Radius of the satellite's cylindrical wheel (mm).
    e : array_like, any shape
        Eccentricity of the ellipse (pure number).

    Returns
    -------
    ndarray or NumPy scalar (rad)

    Notes
    -----
    Domain: 0 < R1, R2 < oo, 0 <= e < 1, R2 < R1.

    Accuracy, tested: 7 eps of the value, where 1e-300 <= R1 and 1e-300 <= R2 and R1 <= 1e75*R2.

    Proved, as long as no result overflows or falls below the normal range: at most 4.5 eps with
    np.arctan2 within 1 ulp, found 3.28; at most 5.47 eps compiled, found 3.46.

    Source: extremes of the derivatives of Prikhodko et al. 2024, equation (8).

    """
    R1, R2, e = _as_floats("R1 R2 e", R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_largest_ratio, R1, R2, e)
    return _in_blocks(
        _form_of_angle_of_smallest_acceleration,
        (R1,),
        _prepare_of_angle_of_smallest_acceleration,
        (R2, e),
        out=out,
    )


def _prepare_of_angle_of_smallest_acceleration(R2: Any, e: Any) -> tuple[Any, ...]:
    e_squared = _square(e)
    square = 1.0 + e_squared
    root_acceleration = _np.sqrt(32.0 * e_squared + _square(square))
    peak_acceleration = 1.0 + _square(1.0 + e) / (6.0 * e + root_acceleration)

    return (R2, e, square, root_acceleration, peak_acceleration)


def _form_of_angle_of_smallest_acceleration(
    R1: Any, R2: Any, e: Any, square: Any, root_acceleration: Any, peak_acceleration: Any
) -> Any:
    k = R1 / R2

    return (
        2.0
        * _np.arctan2(
            _np.sqrt(peak_acceleration) * (1.0 - e), _np.sqrt(8.0 * e + root_acceleration + square)
        )
        / k
    )


# Source: extremes of the derivatives of Prikhodko et al. 2024, equation (8)
# Expressions sha256: ce12ffd5caae2fb180c1707c0c2bf1db2d5087fcdf05bee29a57443d04937b22
# Form: quotient
# Operations: 38
def largest_jerk(
    R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the largest jerk, which it has at phi1 = angle_of_largest_jerk and -phi1.

        largest_jerk = Piecewise((2*e*k**3*(1 - e)/(1 + e)**3, 10*e <= square), (k**3*(32*e**2 +
            square**2)*(root_jerk + 3*square)**2/(36*(1 - e)**3*(1 + e)**3*(2*root_jerk +
            3*square)), True))
        k = R1/R2
        square = 1 + e**2
        root_jerk = sqrt(24*e**2 + 3*square**2)

    Parameters
    ----------
    R1 : array_like, any shape
        Radius of the epicycle (mm).
    R2 : array_like, any shape
        Radius of the satellite's cylindrical wheel (mm).
    e : array_like, any shape
        Eccentricity of the ellipse (pure number).

    Returns
    -------
    ndarray or NumPy scalar (pure number)

    Notes
    -----
    Domain: 0 < R1, R2 < oo, 0 <= e < 1, R2 < R1.

    Accuracy, tested: 21 eps of the value, where 1e-300 <= R1 and 1e-300 <= R2 and R1 <=
    1e75*R2.

    Proved, where e <= 101/1000 or e >= 102/1000, as long as no result overflows or falls below
    the normal range: at most 13.25 eps with NumPy's functions, found 9.09; at most 13.25 eps
    compiled, found 9.09.

    Source: extremes of the derivatives of Prikhodko et al. 2024, equation (8).

    """
    R1, R2, e = _as_floats("R1 R2 e", R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_largest_ratio, R1, R2, e)
    return _in_blocks(
        _form_of_largest_jerk, (R1,), _prepare_of_largest_jerk, (R2, e), out=out, quiet=True
    )


def _prepare_of_largest_jerk(R2: Any, e: Any) -> tuple[Any, ...]:
    one_minus_e = 1.0 - e
    one_plus_e = 1.0 + e
    term = 1.0 / (one_plus_e * _square(one_plus_e))
    e_squared = _square(e)
    square = 1.0 + e_squared
    square_squared = _square(square)
    root_jerk = _np.sqrt(24.0 * e_squared + 3.0 * square_squared)

    return (R2, e, one_minus_e, term, e_squared, square, square_squared, root_jerk)


def _form_of_largest_jerk(
    R1: Any,
    R2: Any,
    e: Any,
    one_minus_e: Any,
    term: Any,
    e_squared: Any,
    square: Any,
    square_squared: Any,
    root_jerk: Any,
) -> Any:
    k = R1 / R2
    k_cubed = k * _square(k)

    return _choose_where(
        10.0 * e <= square,
        2.0 * e * one_minus_e * term * k_cubed,
        term
        * _square(root_jerk + 3.0 * square)
        * (32.0 * e_squared + square_squared)
        / (36.0 * (one_minus_e * _square(one_minus_e)) * (2.0 * root_jerk + 3.0 * square))
        * k_cubed,
    )


# Source: extremes of the derivatives of Prikhodko et al. 2024, equation (8)
# Expressions sha256: 9dabdaf97c93e1c118123736d50ede9166bfc9b9de827a62f42c80403da8f701
# Form: quotient
# Operations: 11
def smallest_jerk(
    R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the smallest jerk, met where the ratio is largest.

        smallest_jerk = -2*e*k**3*(1 + e)/(1 - e)**3
        k = R1/R2

    Parameters
    ----------
    R1 : array_like, any shape
        Radius of the epicycle (mm).
    R2 : array_like, any shape
        Radius of the satellite's cylindrical wheel (mm).
    e : array_like, any shape
        Eccentricity of the ellipse (pure number).

    Returns
    -------
    ndarray or NumPy scalar (pure number)

    Notes
    -----
    Domain: 0 < R1, R2 < oo, 0 <= e < 1, R2 < R1.

    Accuracy, tested: 7 eps of the value, where 1e-300 <= R1 and 1e-300 <= R2 and R1 <= 1e75*R2.

    Proved, as long as no result overflows or falls below the normal range: at most 6.54 eps
    with NumPy's functions, found 5.94; at most 6.54 eps compiled, found 5.94.

    Source: extremes of the derivatives of Prikhodko et al. 2024, equation (8).

    """
    R1, R2, e = _as_floats("R1 R2 e", R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_largest_ratio, R1, R2, e)
    return _in_blocks(_form_of_smallest_jerk, (R1,), parameters=(R2, e), out=out)


def _form_of_smallest_jerk(R1: Any, R2: Any, e: Any) -> Any:
    k = R1 / R2
    one_minus_e = 1.0 - e

    return -2.0 * e * (1.0 + e) / (one_minus_e * _square(one_minus_e)) * (k * _square(k))


# Source: extremes of the derivatives of Prikhodko et al. 2024, equation (8)
# Expressions sha256: c74d8bbe490cd07c984559bf2d45650286f4436de57754b6aa6baf0785f73f10
# Form: quotient
# Operations: 34
def angle_of_largest_jerk(
    R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the first phi1 >= 0 where the jerk is largest.

        angle_of_largest_jerk = Piecewise((pi, 10*e <= square), (2*atan2(sqrt((10*e +
            square)*(root_jerk + 2*square - 2*e))*(1 - e), sqrt((10*e - square)*(2*e + root_jerk
            + 2*square))*(1 + e)), True))/k
        k = R1/R2
        square = 1 + e**2
        root_jerk = sqrt(24*e**2 + 3*square**2)

    Parameters
    ----------
    R1 : array_like, any shape
        Radius of the epicycle (mm).
    R2 : array_like, any shape
        Radius of the satellite's cylindrical wheel (mm).
    e : array_like, any shape
        Eccentricity of the ellipse (pure number).

    Returns
    -------
    ndarray or NumPy scalar (rad)

    Notes
    -----
    Domain: 0 < R1, R2 < oo, 0 <= e < 1, R2 < R1.

    Accuracy, tested: 8 eps of the value and the effect of rounding 10*e - square, where 1e-300
    <= R1 and 1e-300 <= R2 and R1 <= 1e75*R2.

    Proved, where e <= 101/1000 or e >= 102/1000, as long as no result overflows or falls below
    the normal range: at most 3.49 eps with np.arctan2 within 1 ulp, found 2.39; at most 4.01
    eps compiled, found 2.35.

    Source: extremes of the derivatives of Prikhodko et al. 2024, equation (8).

    """
    R1, R2, e = _as_floats("R1 R2 e", R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_largest_ratio, R1, R2, e)
    return _in_blocks(
        _form_of_angle_of_largest_jerk,
        (R1,),
        _prepare_of_angle_of_largest_jerk,
        (R2, e),
        out=out,
        quiet=True,
    )


def _prepare_of_angle_of_largest_jerk(R2: Any, e: Any) -> tuple[Any, ...]:
    e_squared = _square(e)
    square = 1.0 + e_squared
    root_jerk = _np.sqrt(24.0 * e_squared + 3.0 * _square(square))

    return (R2, e, square, root_jerk)


def _form_of_angle_of_largest_jerk(R1: Any, R2: Any, e: Any, square: Any, root_jerk: Any) -> Any:
    k = R1 / R2

    return (
        _choose_where(
            10.0 * e <= square,
            _np.pi,
            2.0
            * _np.arctan2(
                _np.sqrt((10.0 * e + square) * (root_jerk + 2.0 * square - 2.0 * e)) * (1.0 - e),
                _np.sqrt((10.0 * e - square) * (2.0 * e + root_jerk + 2.0 * square)) * (1.0 + e),
            ),
        )
        / k
    )


# Source: inverse of the extremes of Prikhodko et al. 2024, equation (8)
# Expressions sha256: 74e257862e5f941743159a57de0054eeb81efe215149b91206f0b293117056ab
# Form: quotient
# Operations: 6
def eccentricity_of_largest_ratio(
    largest: ArrayLike, R1: ArrayLike, R2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the eccentricity at which the largest ratio has a wanted value.

        eccentricity_of_largest_ratio = (largest - 1 - k)/(k + largest - 1)
        k = R1/R2

    Parameters
    ----------
    largest : array_like, any shape
        Largest ratio wanted (pure number).
    R1 : array_like, any shape
        Radius of the epicycle (mm).
    R2 : array_like, any shape
        Radius of the satellite's cylindrical wheel (mm).

    Returns
    -------
    ndarray or NumPy scalar (pure number)

    Notes
    -----
    Domain: 0 < R1, R2 < oo, 1 < largest < oo, R2 < R1 <= R2*(largest - 1) (largest >= 1 +
    R1/R2).

    Accuracy, tested: 2.5 eps of 1, where R1 <= 1e100*R2.

    Proved, as long as no result overflows or falls below the normal range: at most 2.51 eps
    with NumPy's functions, found 1.24; at most 2.51 eps compiled, found 1.24.

    Source: inverse of the extremes of Prikhodko et al. 2024, equation (8).

    """
    largest, R1, R2 = _as_floats("largest R1 R2", largest, R1, R2)
    largest, R1, R2 = _nan_outside(_check_of_eccentricity_of_largest_ratio, largest, R1, R2)
    return _in_blocks(
        _form_of_eccentricity_of_largest_ratio,
        (largest,),
        _prepare_of_eccentricity_of_largest_ratio,
        (R1, R2),
        out=out,
    )


def _check_of_eccentricity_of_largest_ratio(largest: Any, R1: Any, R2: Any) -> tuple[Any, ...]:
    return (
        _is_positive(R1),
        _is_positive(R2),
        R2 < R1,
        largest > 1.0,
        _is_finite(largest),
        R1 <= R2 * (largest - 1.0),
    )


def _prepare_of_eccentricity_of_largest_ratio(R1: Any, R2: Any) -> tuple[Any, ...]:
    k = R1 / R2

    return (k,)


def _form_of_eccentricity_of_largest_ratio(largest: Any, k: Any) -> Any:
    return (largest - 1.0 - k) / (k + largest - 1.0)


# Source: inverse of the extremes of Prikhodko et al. 2024, equation (8)
# Expressions sha256: 9195d302b7bb612e6be5ddba562e22384c445c3ba4600438137b3fd41631d43a
# Form: quotient
# Operations: 6
def eccentricity_of_smallest_ratio(
    smallest: ArrayLike, R1: ArrayLike, R2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the eccentricity at which the smallest ratio has a wanted value.

        eccentricity_of_smallest_ratio = (1 + k - smallest)/(k + smallest - 1)
        k = R1/R2

    Parameters
    ----------
    smallest : array_like, any shape
        Smallest ratio wanted (pure number).
    R1 : array_like, any shape
        Radius of the epicycle (mm).
    R2 : array_like, any shape
        Radius of the satellite's cylindrical wheel (mm).

    Returns
    -------
    ndarray or NumPy scalar (pure number)

    Notes
    -----
    Domain: 0 < R1, R2 < oo, 1 < smallest < oo, R2 < R1, R2*(smallest - 1) <= R1 (smallest <= 1
    + R1/R2).

    Accuracy, tested: 2.5 eps of 1, where R1 <= 1e100*R2.

    Proved, as long as no result overflows or falls below the normal range: at most 3.53 eps
    with NumPy's functions, found 2.24; at most 3.53 eps compiled, found 2.24.

    Source: inverse of the extremes of Prikhodko et al. 2024, equation (8).

    """
    smallest, R1, R2 = _as_floats("smallest R1 R2", smallest, R1, R2)
    smallest, R1, R2 = _nan_outside(_check_of_eccentricity_of_smallest_ratio, smallest, R1, R2)
    return _in_blocks(
        _form_of_eccentricity_of_smallest_ratio,
        (smallest,),
        _prepare_of_eccentricity_of_largest_ratio,
        (R1, R2),
        out=out,
    )


def _check_of_eccentricity_of_smallest_ratio(smallest: Any, R1: Any, R2: Any) -> tuple[Any, ...]:
    return (
        _is_positive(R1),
        _is_positive(R2),
        R2 < R1,
        smallest > 1.0,
        _is_finite(smallest),
        R2 * (smallest - 1.0) <= R1,
    )


def _form_of_eccentricity_of_smallest_ratio(smallest: Any, k: Any) -> Any:
    return (1.0 + k - smallest) / (k + smallest - 1.0)


# Source: inverse of the extremes of Prikhodko et al. 2024, equation (8)
# Expressions sha256: 75d76333d70e7c55aea6a4c44fba0ce0eabdc361e309762dd097f8006112cc27
# Form: quotient
# Operations: 21
def eccentricity_of_quotient(
    quotient: ArrayLike, R1: ArrayLike, R2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the eccentricity at which the largest ratio is a wanted multiple of the smallest.

        eccentricity_of_quotient = (1 + (4*k**2 + quotient - 1)/(2*k + sqrt(4*k**2*quotient +
            (quotient - 1)**2)))*(quotient - 1)/(2*k + quotient + sqrt(4*k**2*quotient +
            (quotient - 1)**2) - 1)
        k = R1/R2

    Parameters
    ----------
    quotient : array_like, any shape
        Largest over smallest ratio (pure number).
    R1 : array_like, any shape
        Radius of the epicycle (mm).
    R2 : array_like, any shape
        Radius of the satellite's cylindrical wheel (mm).

    Returns
    -------
    ndarray or NumPy scalar (pure number)

    Notes
    -----
    Domain: 0 < R1, R2 < oo, 1 <= quotient < oo, R2 < R1.

    Accuracy, tested: 9 eps of the value, where R1 <= 1e100*R2 and quotient <= 1e100.

    Proved, as long as no result overflows or falls below the normal range: at most 6.88 eps
    with NumPy's functions, found 4.41; at most 6.88 eps compiled, found 4.41.

    Source: inverse of the extremes of Prikhodko et al. 2024, equation (8).

    """
    quotient, R1, R2 = _as_floats("quotient R1 R2", quotient, R1, R2)
    quotient, R1, R2 = _nan_outside(_check_of_eccentricity_of_quotient, quotient, R1, R2)
    return _in_blocks(
        _form_of_eccentricity_of_quotient,
        (quotient,),
        _prepare_of_eccentricity_of_quotient,
        (R1, R2),
        out=out,
    )


def _check_of_eccentricity_of_quotient(quotient: Any, R1: Any, R2: Any) -> tuple[Any, ...]:
    return (_is_positive(R1), _is_positive(R2), R2 < R1, quotient >= 1.0, _is_finite(quotient))


def _prepare_of_eccentricity_of_quotient(R1: Any, R2: Any) -> tuple[Any, ...]:
    k = R1 / R2
    k_squared = _square(k)

    return (k, k_squared)


def _form_of_eccentricity_of_quotient(quotient: Any, k: Any, k_squared: Any) -> Any:
    quotient_minus_one = quotient - 1.0
    term = _np.sqrt(_square(quotient_minus_one) + 4.0 * k_squared * quotient)

    return (
        quotient_minus_one
        * (1.0 + (4.0 * k_squared + quotient - 1.0) / (2.0 * k + term))
        / (2.0 * k + quotient + term - 1.0)
    )


# Source: inverse of the extremes of Prikhodko et al. 2024, equation (8)
# Expressions sha256: 48d4b52e0e36da5a6d33ffc7798f62bbbdfaf9fa55e66119825d17500bb6c056
# Form: quotient
# Operations: 13
def eccentricity_of_non_uniformity(
    non_uniformity: ArrayLike, R1: ArrayLike, R2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the eccentricity for a wanted (largest - smallest ratio)/(mean ratio).

        eccentricity_of_non_uniformity = non_uniformity*(1 + k)/(k*(2 + sqrt(4 +
            non_uniformity**2*(1 + k)**2/k**2)))
        k = R1/R2

    Parameters
    ----------
    non_uniformity : array_like, any shape
        (largest - smallest ratio)/(mean ratio) wanted (pure number).
    R1 : array_like, any shape
        Radius of the epicycle (mm).
    R2 : array_like, any shape
        Radius of the satellite's cylindrical wheel (mm).

    Returns
    -------
    ndarray or NumPy scalar (pure number)

    Notes
    -----
    Domain: 0 < R1, R2 < oo, 0 <= non_uniformity < oo, R2 < R1.

    Accuracy, tested: 6 eps of the value, where R1 <= 1e100*R2 and non_uniformity <= 1e50.

    Proved, as long as no result overflows or falls below the normal range: at most 4 eps with
    NumPy's functions, found 2.68; at most 4 eps compiled, found 2.68.

    Source: inverse of the extremes of Prikhodko et al. 2024, equation (8).

    """
    non_uniformity, R1, R2 = _as_floats("non_uniformity R1 R2", non_uniformity, R1, R2)
    non_uniformity, R1, R2 = _nan_outside(
        _check_of_eccentricity_of_non_uniformity, non_uniformity, R1, R2
    )
    return _in_blocks(
        _form_of_eccentricity_of_non_uniformity,
        (non_uniformity,),
        _prepare_of_eccentricity_of_non_uniformity,
        (R1, R2),
        out=out,
    )


def _check_of_eccentricity_of_non_uniformity(
    non_uniformity: Any, R1: Any, R2: Any
) -> tuple[Any, ...]:
    return (_is_positive(R1), _is_positive(R2), R2 < R1, _is_nonnegative(non_uniformity))


def _prepare_of_eccentricity_of_non_uniformity(R1: Any, R2: Any) -> tuple[Any, ...]:
    k = R1 / R2
    one_plus_k = 1.0 + k

    return (k, one_plus_k)


def _form_of_eccentricity_of_non_uniformity(non_uniformity: Any, k: Any, one_plus_k: Any) -> Any:
    return (
        one_plus_k
        / (k * (2.0 + _np.sqrt(4.0 + _square(one_plus_k) / _square(k) * _square(non_uniformity))))
        * non_uniformity
    )


# Source: inverse of the extremes of Prikhodko et al. 2024, equation (8)
# Expressions sha256: 49d837c44f5df529d4259b4cd60ee5839c6670c7ce099dfa0c5b1ae452562887
# Form: quotient
# Operations: 8
def eccentricity_of_extremes(
    largest: ArrayLike, smallest: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the eccentricity at which both extremes of the ratio have wanted values.

        eccentricity_of_extremes = (largest - smallest)/(sqrt(largest - 1) + sqrt(smallest -
            1))**2

    Parameters
    ----------
    largest : array_like, any shape
        Largest ratio wanted (pure number).
    smallest : array_like, any shape
        Smallest ratio wanted (pure number).

    Returns
    -------
    ndarray or NumPy scalar (pure number)

    Notes
    -----
    Domain: 1 < largest, smallest < oo, smallest <= largest, 1 < (largest - 1)*(smallest - 1)
    (smallest <= largest and R1 > R2).

    Accuracy, tested: 4 eps of the value.

    Proved, as long as no result overflows or falls below the normal range: at most 4.02 eps
    with NumPy's functions, found 3.19; at most 4.02 eps compiled, found 3.19.

    Source: inverse of the extremes of Prikhodko et al. 2024, equation (8).

    """
    largest, smallest = _as_floats("largest smallest", largest, smallest)
    largest, smallest = _nan_outside(_check_of_eccentricity_of_extremes, largest, smallest)
    return _in_blocks(
        _form_of_eccentricity_of_extremes, (largest,), parameters=(smallest,), out=out
    )


def _check_of_eccentricity_of_extremes(largest: Any, smallest: Any) -> tuple[Any, ...]:
    return (
        smallest > 1.0,
        _is_finite(smallest),
        largest > 1.0,
        _is_finite(largest),
        smallest <= largest,
        (largest - 1.0) * (smallest - 1.0) > 1.0,
    )


def _form_of_eccentricity_of_extremes(largest: Any, smallest: Any) -> Any:
    return (largest - smallest) / _square(_np.sqrt(largest - 1.0) + _np.sqrt(smallest - 1.0))


# Source: inverse of the extremes of Prikhodko et al. 2024, equation (8)
# Expressions sha256: cda451cfcbbf5cd7694b00ed4fcdb37001c2412ecf9c502163f9a9702d78e52a
# Form: quotient
# Operations: 4
def radii_of_extremes(
    largest: ArrayLike, smallest: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute R1/R2 at which both extremes of the ratio have wanted values.

        radii_of_extremes = sqrt((largest - 1)*(smallest - 1))

    Parameters
    ----------
    largest : array_like, any shape
        Largest ratio wanted (pure number).
    smallest : array_like, any shape
        Smallest ratio wanted (pure number).

    Returns
    -------
    ndarray or NumPy scalar (pure number)

    Notes
    -----
    Domain: 1 < largest, smallest < oo, smallest <= largest, 1 < (largest - 1)*(smallest - 1)
    (smallest <= largest and R1 > R2).

    Accuracy, tested: 2 eps of the value.

    Proved, as long as no result overflows or falls below the normal range: at most 1.26 eps
    with NumPy's functions, found 0.74; at most 1.26 eps compiled, found 0.74.

    Source: inverse of the extremes of Prikhodko et al. 2024, equation (8).

    """
    largest, smallest = _as_floats("largest smallest", largest, smallest)
    largest, smallest = _nan_outside(_check_of_eccentricity_of_extremes, largest, smallest)
    return _in_blocks(_form_of_radii_of_extremes, (largest,), parameters=(smallest,), out=out)


def _form_of_radii_of_extremes(largest: Any, smallest: Any) -> Any:
    return _np.sqrt((smallest - 1.0) * (largest - 1.0))
