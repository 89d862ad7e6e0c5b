"""Kernels of the system `elliptic_planetary`.

Prikhodko, Polivoda, Shchetinin 2024, planetary mechanism with an elliptical pair, doi
10.37313/1990-5378-2024-26-3-164-171

Angles are positive in the direction of the carrier's rotation; distances on the line A-C
are positive from A towards C and B. Lengths in mm, angles in rad.

Arguments broadcast. The result is a NumPy scalar where they are scalars, an array
otherwise; float32 if every array argument is float32, float64 otherwise. `out`, an array of
the result's type and shape, takes the result; it may overlap an argument. Outside the
domain and where an argument is NaN the result is NaN; in a domain numpy.pi counts as pi.

TypeError: an argument is complex or not numeric, or `out` is no array of the result's type.
ValueError: shapes do not broadcast or a last axis is wrong, or `out` has another shape.

Accuracy is tested: on the stated arguments no search has found a result that is off by
more. It is of float64, in which float32 is computed, too; eps = 2**-52.

What is proved holds for all arguments that its line states, of float64 rounded to nearest,
on the assumptions of that line: the results that they speak of are those of all operations
on the way, and the normal range is 0 and what is at least 2**-1022 in size. More may be
proved than is tested, since a proof adds up roundings that may never meet.

What errors are relative to:

    the value and what eps*x makes of it (ratio) = 1 + k*(1 - e**2)/(1 + e**2 - 2*e*cos(x))
        + e*k*(1 - e**2)*|x|/(2**51*(1 + e**2 - 2*e*cos(x))**2)

    the value and what eps*x makes of it (acceleration) = 2*k**2*|e*(e**2 - 1)*sin(x)/(1 +
        e**2 - 2*e*cos(x))**2| + e*k**2*(1 - e**2)*|x|/(2**51*(1 + e**2 - 2*e*cos(x))**2)

Generated from mechproof.derivations.elliptic_planetary with SymPy 1.14.0.
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
    is_positive as _is_positive,
    nan_outside as _nan_outside,
)
from mechproof.kernel_support.error_free import (
    product_rest as _product_rest,
    quotient_rest as _quotient_rest,
    small_tangent as _small_tangent,
)
from mechproof.kernel_support.facts import Condition as _Condition, Sizes as _Sizes
from mechproof.kernel_support.functions import (
    small_arctan as _small_arctan,
    square as _square,
    tangent_quotient as _tangent_quotient,
)

__all__ = [
    "acceleration",
    "largest_ratio",
    "position",
    "ratio",
    "smallest_ratio",
]

DOMAIN = (
    _Condition(
        "R1",
        "0 < R1 < oo",
        ("R1",),
        lambda R1: (R1 > 0) & _is_finite(R1),
        ("ratio", "position", "acceleration", "largest_ratio", "smallest_ratio"),
    ),
    _Condition(
        "R2",
        "0 < R2 < oo",
        ("R2",),
        lambda R2: (R2 > 0) & _is_finite(R2),
        ("ratio", "position", "acceleration", "largest_ratio", "smallest_ratio"),
    ),
    _Condition(
        "e",
        "0 <= e < 1",
        ("e",),
        lambda e: (e >= 0) & (e < 1),
        ("ratio", "position", "acceleration", "largest_ratio", "smallest_ratio"),
    ),
    _Condition(
        "R2",
        "R2 < R1",
        ("R1", "R2"),
        lambda R1, R2: R2 < R1,
        ("ratio", "position", "acceleration", "largest_ratio", "smallest_ratio"),
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

    Accuracy, tested: 10 eps of the value and what eps*x makes of it, where |x| <= 2**26 and
    (phi1 = 0 or 1e-290 <= |phi1|) and 1e-300 <= R1 and 1e-300 <= R2.

    Proved, where |x| <= 22/7 or |x| <= 2**26 and e <= 1 - 2**-10, as long as no result
    overflows or falls below the normal range: at most 11.59 eps with np.tan within 1 ulp, found
    6.15; at most 13.31 eps compiled, found 7.57.

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
# Form where e <= 0.5: half-angle atan
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

    Returns
    -------
    ndarray or NumPy scalar (rad)

    Notes
    -----
    Domain: 0 < R1, R2 < oo, 0 <= e < 1, R2 < R1.

    Where e <= 1/2 for all elements, half-angle atan is computed.

    Accuracy, tested: 4 eps of the value, where |x| <= 2**26 and (phi1 = 0 or 1e-290 <= |phi1|)
    and 1e-300 <= R1 and 1e-300 <= R2.

    Proved of half-angle atan, where |x| <= 2**26, as long as no result overflows or falls below
    the normal range: at most 4.35 eps with np.arctan within 1 ulp and np.tan within 1 ulp,
    found 3.38; at most 4.54 eps compiled, found 3.54.

    Proved of half-angle atan with low word, where |x| <= 22/7 or |x| <= 2**26 and e <= 1 -
    2**-10, as long as no result overflows or falls below the normal range: at most 5.78 eps
    with np.arctan within 1 ulp and np.tan within 1 ulp, found 2.98; at most 5.56 eps compiled,
    found 3.48.

    Source: Prikhodko et al. 2024, integral (9) of equation (8).

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_position, R1, R2, e)
    if _holds(e <= 0.5):
        return _in_blocks(
            _form_1_of_position, (phi1,), _prepare_1_of_position, (R1, R2, e), out=out
        )
    return _in_blocks(_form_of_position, (phi1,), _prepare_of_position, (R1, R2, e), out=out)


def _check_of_position(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    return (_is_positive(R1), _is_positive(R2), e >= 0.0, e < 1.0, R2 < R1)


def _prepare_1_of_position(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    k = R1 / R2
    one_minus_e = 1.0 - e
    one_plus_e = 1.0 + e

    return (e, k, one_minus_e, one_plus_e)


def _form_1_of_position(phi1: Any, e: Any, k: Any, one_minus_e: Any, one_plus_e: Any) -> Any:
    x = k * phi1

    return (1.0 + k) * phi1 + 2.0 * _small_arctan(
        2.0 * e * _tangent_quotient(x / 2.0, one_minus_e, one_plus_e)
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
    t = _np.tan(x / 2.0)
    x_low = k_low * phi1 + _product_rest(k, phi1, x)
    t_low = _small_tangent(x_low / 2.0)
    adjacent = 1.0 - t * t_low
    opposite = t + t_low

    return (1.0 + k) * phi1 + 2.0 * _np.arctan(
        2.0
        * e
        / (one_minus_e * _square(adjacent) + one_plus_e * _square(opposite))
        * adjacent
        * opposite
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

    Accuracy, tested: 16 eps of the value and what eps*x makes of it, where |x| <= 2**26 and
    (phi1 = 0 or 1e-290 <= |phi1|) and 1e-300 <= R1 and 1e-300 <= R2 and R1 <= 1e130*R2 and (e =
    0 or 1e-200 <= e).

    Proved, where |x| <= 22/7 and |pi - |x|| >= 2**-40, as long as no result overflows or falls
    below the normal range: at most 21.88 eps with np.tan within 1 ulp, found 10.23; at most
    25.49 eps compiled, found 11.46.

    Source: derivative of Prikhodko et al. 2024, equation (8).

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_acceleration, R1, R2, e)
    return _in_blocks(
        _form_of_acceleration, (phi1,), _prepare_of_acceleration, (R1, R2, e), out=out
    )


def _check_of_acceleration(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    return (_is_positive(R1), _is_positive(R2), e >= 0.0, e < 1.0, R2 < R1)


def _prepare_of_acceleration(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    k = R1 / R2
    k_low = _quotient_rest(R1, R2, k)
    one_minus_e = 1.0 - e
    one_plus_e = 1.0 + e

    return (e, k, k_low, one_minus_e, one_plus_e)


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
    """Compute the largest transmission ratio, met at phi1 = 0 and every period 2*pi*R2/R1 on.

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

    Source: extremes of Prikhodko et al. 2024, equation (8).

    """
    R1, R2, e = _as_floats("R1 R2 e", R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_largest_ratio, R1, R2, e)
    return _in_blocks(_form_of_largest_ratio, (R1,), _prepare_of_largest_ratio, (R2, e), out=out)


def _check_of_largest_ratio(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    return (_is_positive(R2), e >= 0.0, e < 1.0, _is_positive(R1), R2 < R1)


def _prepare_of_largest_ratio(R2: Any, e: Any) -> tuple[Any, ...]:

    return (R2, e)


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

    Source: extremes of Prikhodko et al. 2024, equation (8).

    """
    R1, R2, e = _as_floats("R1 R2 e", R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_smallest_ratio, R1, R2, e)
    return _in_blocks(_form_of_smallest_ratio, (R1,), _prepare_of_smallest_ratio, (R2, e), out=out)


def _check_of_smallest_ratio(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    return (_is_positive(R2), e >= 0.0, e < 1.0, _is_positive(R1), R2 < R1)


def _prepare_of_smallest_ratio(R2: Any, e: Any) -> tuple[Any, ...]:

    return (R2, e)


def _form_of_smallest_ratio(R1: Any, R2: Any, e: Any) -> Any:
    k = R1 / R2

    return 1.0 + (1.0 - e) / (1.0 + e) * k
