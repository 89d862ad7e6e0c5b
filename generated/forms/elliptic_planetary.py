"""Other forms of the kernels of `elliptic_planetary`.

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
    is_positive as _is_positive,
    nan_outside as _nan_outside,
)
from mechproof.kernel_support.error_free import (
    single as _single,
    whole_turns_off as _whole_turns_off,
)
from mechproof.kernel_support.functions import floor as _floor, square as _square

__all__ = [
    "acceleration_direct",
    "acceleration_half_angle",
    "jerk_direct",
    "position_atan2",
    "position_atan2_stable",
    "position_floor",
    "position_fourier_12_single",
    "position_fourier_2",
    "position_fourier_2_single",
    "position_fourier_4",
    "position_fourier_4_single",
    "position_fourier_8",
    "position_fourier_8_single",
    "position_principal",
    "position_printed",
    "position_tan_half",
    "ratio_half_angle",
    "ratio_printed",
]


def __dir__() -> list[str]:
    return __all__


# Source: Prikhodko et al. 2024, equation (8)
# Expressions sha256: 55738b8963410c3537493ee47b9e8856244e96edcd0c8946b21b8664150a0081
# Form: printed (8)
# Operations: 13
def ratio_printed(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `ratio` by another form: printed (8).

        ratio_printed = 1 + R1*(1 - e**2)/(R2*(1 + e**2 - 2*e*cos(x)))
        k = R1/R2
        x = k*phi1

    Same domain as `ratio`.

    Source: Prikhodko et al. 2024, equation (8).

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio_printed, R1, R2, e)
    return _in_blocks(
        _form_of_ratio_printed, (phi1,), _prepare_of_ratio_printed, (R1, R2, e), out=out
    )


def _check_of_ratio_printed(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    return (_is_positive(R1), _is_positive(R2), e >= 0.0, e < 1.0, R2 < R1)


def _prepare_of_ratio_printed(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    e_squared = _square(e)
    k = R1 / R2

    return (R1, R2, e, e_squared, k)


def _form_of_ratio_printed(phi1: Any, R1: Any, R2: Any, e: Any, e_squared: Any, k: Any) -> Any:
    x = k * phi1

    return 1.0 + R1 * (1.0 - e_squared) / (R2 * (1.0 + e_squared - 2.0 * e * _np.cos(x)))


# Source: Prikhodko et al. 2024, equation (8)
# Expressions sha256: bd79fdb05bf67c67d93dc0c7a4c9d95686ee6c40f24dd16098fe27310be364f2
# Form: half-angle sine
# Operations: 15
def ratio_half_angle(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `ratio` by another form: half-angle sine.

        ratio_half_angle = 1 + k*(1 - e)*(1 + e)/(4*e*sin(x/2)**2 + (1 - e)**2)
        k = R1/R2
        x = k*phi1

    Same domain as `ratio`.

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio_printed, R1, R2, e)
    return _in_blocks(
        _form_of_ratio_half_angle, (phi1,), _prepare_of_ratio_half_angle, (R1, R2, e), out=out
    )


def _prepare_of_ratio_half_angle(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    k = R1 / R2
    one_minus_e = 1.0 - e

    return (e, k, one_minus_e)


def _form_of_ratio_half_angle(phi1: Any, e: Any, k: Any, one_minus_e: Any) -> Any:
    x = k * phi1

    return 1.0 + k * one_minus_e * (1.0 + e) / (
        _square(one_minus_e) + 4.0 * e * _square(_np.sin(x / 2.0))
    )


# Source: Prikhodko et al. 2024, integral (9) of equation (8)
# Expressions sha256: 57141eb1f5a1911636963a3944f616d16509b37ec44b8f956c64f2d10da47e9d
# Form: printed (12)
# Operations: 15
def position_printed(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `position` by another form: printed (12).

        position_printed = phi1 + 2*sqrt((1 - e)/(1 + e))*atan(sqrt((1 + e)/(1 -
            e))*tan(R1*phi1/(2*R2)))

    Its derivative is not the ratio (8), and it jumps where x/2 passes pi/2.

    Same domain as `position`.

    Source: Prikhodko et al. 2024, equation (12).

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio_printed, R1, R2, e)
    return _in_blocks(
        _form_of_position_printed, (phi1,), _prepare_of_position_printed, (R1, R2, e), out=out
    )


def _prepare_of_position_printed(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    one_minus_e = 1.0 - e
    one_plus_e = 1.0 + e

    return (R1, R2, one_minus_e, one_plus_e)


def _form_of_position_printed(
    phi1: Any, R1: Any, R2: Any, one_minus_e: Any, one_plus_e: Any
) -> Any:
    return phi1 + 2.0 * _np.sqrt(one_minus_e / one_plus_e) * _np.arctan(
        _np.sqrt(one_plus_e / one_minus_e) * _np.tan(R1 / (2.0 * R2) * phi1)
    )


# Source: Prikhodko et al. 2024, integral (9) of equation (8)
# Expressions sha256: 387e96024e7cecf0d2a5583237b63348953846e0d42093f13a93e610793c85df
# Form: tan/arctan
# Operations: 11
def position_principal(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `position` by another form: tan/arctan.

        position_principal = phi1 + 2*atan((1 + e)*tan(x/2)/(1 - e))
        k = R1/R2
        x = k*phi1

    Right for |phi1| < pi*R2/R1, beyond that off by multiples of 2*pi.

    Same domain as `position`.

    Source: Prikhodko et al. 2024, equation (12) with the factor of (11) corrected.

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio_printed, R1, R2, e)
    return _in_blocks(
        _form_of_position_principal, (phi1,), _prepare_of_position_principal, (R1, R2, e), out=out
    )


def _prepare_of_position_principal(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    k = R1 / R2

    return (e, k)


def _form_of_position_principal(phi1: Any, e: Any, k: Any) -> Any:
    x = k * phi1

    return phi1 + 2.0 * _np.arctan((1.0 + e) / (1.0 - e) * _np.tan(x / 2.0))


# Source: Prikhodko et al. 2024, integral (9) of equation (8)
# Expressions sha256: 37f6214c2cb46f15360b70517ba8b0224c00ac2c6d044bd5b586f3606e96700d
# Form: tan/arctan + floor
# Operations: 18
def position_floor(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `position` by another form: tan/arctan + floor.

        position_floor = phi1 + 2*pi*floor((pi + x)/(2*pi)) + 2*atan((1 + e)*tan(x/2)/(1 - e))
        k = R1/R2
        x = k*phi1

    Proved for |x - 2 pi m| < pi; the computed floor and tangent disagree at the ends.

    Same domain as `position`, |x| < pi, the first branch of the half-angle.

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio_printed, R1, R2, e)
    return _in_blocks(
        _form_of_position_floor, (phi1,), _prepare_of_position_principal, (R1, R2, e), out=out
    )


def _form_of_position_floor(phi1: Any, e: Any, k: Any) -> Any:
    x = k * phi1

    return (
        phi1
        + 2.0 * _np.pi * _floor((_np.pi + x) / (2.0 * _np.pi))
        + 2.0 * _np.arctan((1.0 + e) / (1.0 - e) * _np.tan(x / 2.0))
    )


# Source: Prikhodko et al. 2024, integral (9) of equation (8)
# Expressions sha256: 830fe82f29ff22f44e6d333c5bd0f88fa521076110b435a728b2024280a941ff
# Form: x + 2 atan2, 1 - e cos x
# Operations: 12
def position_atan2(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `position` by another form: x + 2 atan2, 1 - e cos x.

        position_atan2 = phi1*(1 + k) + 2*atan2(e*sin(x), 1 - e*cos(x))
        k = R1/R2
        x = k*phi1

    Same domain as `position`.

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio_printed, R1, R2, e)
    return _in_blocks(
        _form_of_position_atan2, (phi1,), _prepare_of_position_principal, (R1, R2, e), out=out
    )


def _form_of_position_atan2(phi1: Any, e: Any, k: Any) -> Any:
    x = k * phi1

    return (1.0 + k) * phi1 + 2.0 * _np.arctan2(e * _np.sin(x), 1.0 - e * _np.cos(x))


# Source: Prikhodko et al. 2024, integral (9) of equation (8)
# Expressions sha256: 84a7f376cbc2f3dbb05f6b7d852e108960f2a578c5bebc5f4b79a02b4870cbe0
# Form: x + 2 atan2, no cancellation
# Operations: 16
def position_atan2_stable(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `position` by another form: x + 2 atan2, no cancellation.

        position_atan2_stable = phi1*(1 + k) + 2*atan2(e*sin(x), nearest + 2*e*sin(x/2)**2)
        k = R1/R2
        x = k*phi1
        nearest = 1 - e

    Same domain as `position`.

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio_printed, R1, R2, e)
    return _in_blocks(
        _form_of_position_atan2_stable,
        (phi1,),
        _prepare_of_position_atan2_stable,
        (R1, R2, e),
        out=out,
    )


def _prepare_of_position_atan2_stable(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    k = R1 / R2
    nearest = 1.0 - e

    return (e, k, nearest)


def _form_of_position_atan2_stable(phi1: Any, e: Any, k: Any, nearest: Any) -> Any:
    x = k * phi1

    return (1.0 + k) * phi1 + 2.0 * _np.arctan2(
        e * _np.sin(x), nearest + 2.0 * e * _square(_np.sin(x / 2.0))
    )


# Source: Prikhodko et al. 2024, integral (9) of equation (8)
# Expressions sha256: a817654089fb5c4bdddeca17e75ff568b2f75b5aeecd3c2fd67f456cee4e11eb
# Form: tan-half, by hand
# Operations: 17
def position_tan_half(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `position` by another form: tan-half, by hand.

        position_tan_half = phi1*(1 + k) + 2*atan(2*e*tan(x/2)/(nearest + (1 + e)*tan(x/2)**2))
        k = R1/R2
        x = k*phi1
        nearest = 1 - e

    Same domain as `position`.

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio_printed, R1, R2, e)
    return _in_blocks(
        _form_of_position_tan_half, (phi1,), _prepare_of_position_atan2_stable, (R1, R2, e), out=out
    )


def _form_of_position_tan_half(phi1: Any, e: Any, k: Any, nearest: Any) -> Any:
    x = k * phi1
    tan__x = _np.tan(x / 2.0)

    return (1.0 + k) * phi1 + 2.0 * _np.arctan(
        2.0 * e / (nearest + (1.0 + e) * _square(tan__x)) * tan__x
    )


# Source: Prikhodko et al. 2024, integral (9) of equation (8)
# Expressions sha256: f93c78d29790197279f8b57b816590b434a217193e12ca9061f03af4f0d0e490
# Form: Fourier series, 2 terms
# Rewrites: clenshaw
# Operations: 13
def position_fourier_2(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `position` by another form: Fourier series, 2 terms.

        position_fourier_2 = 2*e*sin(x) + e**2*sin(2*x) + phi1*(1 + k)
        k = R1/R2
        x = k*phi1

    Approximation, Fourier series, 2 terms: |result - exact| <= 2*e**3/(3 - 3*e), apart from
    rounding.

    Same domain as `position`.

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio_printed, R1, R2, e)
    return _in_blocks(
        _form_of_position_fourier_2, (phi1,), _prepare_of_position_fourier_2, (R1, R2, e), out=out
    )


def _prepare_of_position_fourier_2(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    c_1 = 2.0 * e
    c_2 = _square(e)
    k = R1 / R2

    return (c_1, c_2, k)


def _form_of_position_fourier_2(phi1: Any, c_1: Any, c_2: Any, k: Any) -> Any:
    x = k * phi1
    twice_cosine = 2.0 * _np.cos(x)
    b_1 = c_1 + c_2 * twice_cosine

    return b_1 * _np.sin(x) + (1.0 + k) * phi1


# Source: Prikhodko et al. 2024, integral (9) of equation (8)
# Expressions sha256: 76c285e9227d1ad25949bf3c385c34ca27852ce263eba192f95312c03b8e1991
# Form: Fourier series, 4 terms
# Rewrites: clenshaw
# Operations: 26
def position_fourier_4(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `position` by another form: Fourier series, 4 terms.

        position_fourier_4 = 2*e*sin(x) + e**2*sin(2*x) + 2*e**3*sin(3*x)/3 + e**4*sin(4*x)/2 +
            phi1*(1 + k)
        k = R1/R2
        x = k*phi1

    Approximation, Fourier series, 4 terms: |result - exact| <= 2*e**5/(5 - 5*e), apart from
    rounding.

    Same domain as `position`.

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio_printed, R1, R2, e)
    return _in_blocks(
        _form_of_position_fourier_4, (phi1,), _prepare_of_position_fourier_4, (R1, R2, e), out=out
    )


def _prepare_of_position_fourier_4(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    c_1 = 2.0 * e
    c_3 = 2.0 * (e * _square(e)) / 3.0
    c_4 = _square(_square(e)) / 2.0
    k = R1 / R2
    c_2 = _square(e)

    return (c_1, c_3, c_4, k, c_2)


def _form_of_position_fourier_4(phi1: Any, c_1: Any, c_3: Any, c_4: Any, k: Any, c_2: Any) -> Any:
    x = k * phi1
    twice_cosine = 2.0 * _np.cos(x)
    b_3 = c_3 + c_4 * twice_cosine
    b_2 = c_2 + b_3 * twice_cosine - c_4
    b_1 = c_1 + b_2 * twice_cosine - b_3

    return b_1 * _np.sin(x) + (1.0 + k) * phi1


# Source: Prikhodko et al. 2024, integral (9) of equation (8)
# Expressions sha256: c1b4ff069f62fe58caaf360caa9fab7828d83c252affcb8f2c5891b5e313d23d
# Form: Fourier series, 8 terms
# Rewrites: clenshaw
# Operations: 57
def position_fourier_8(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `position` by another form: Fourier series, 8 terms.

        position_fourier_8 = 2*e*sin(x) + e**2*sin(2*x) + 2*e**3*sin(3*x)/3 + e**4*sin(4*x)/2 +
            2*e**5*sin(5*x)/5 + e**6*sin(6*x)/3 + 2*e**7*sin(7*x)/7 + e**8*sin(8*x)/4 + phi1*(1
            + k)
        k = R1/R2
        x = k*phi1

    Approximation, Fourier series, 8 terms: |result - exact| <= 2*e**9/(9 - 9*e), apart from
    rounding.

    Same domain as `position`.

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio_printed, R1, R2, e)
    return _in_blocks(
        _form_of_position_fourier_8, (phi1,), _prepare_of_position_fourier_8, (R1, R2, e), out=out
    )


def _prepare_of_position_fourier_8(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    c_1 = 2.0 * e
    c_3 = 2.0 * (e * _square(e)) / 3.0
    c_5 = 2.0 * (e * _square(_square(e))) / 5.0
    c_7 = 2.0 * (e * _square(e * _square(e))) / 7.0
    c_8 = _square(_square(_square(e))) / 4.0
    k = R1 / R2
    c_6 = _square(e * _square(e)) / 3.0
    c_4 = _square(_square(e)) / 2.0
    c_2 = _square(e)

    return (c_1, c_3, c_5, c_7, c_8, k, c_6, c_4, c_2)


def _form_of_position_fourier_8(
    phi1: Any,
    c_1: Any,
    c_3: Any,
    c_5: Any,
    c_7: Any,
    c_8: Any,
    k: Any,
    c_6: Any,
    c_4: Any,
    c_2: Any,
) -> Any:
    x = k * phi1
    twice_cosine = 2.0 * _np.cos(x)
    b_7 = c_7 + c_8 * twice_cosine
    b_6 = c_6 + b_7 * twice_cosine - c_8
    b_5 = c_5 + b_6 * twice_cosine - b_7
    b_4 = c_4 + b_5 * twice_cosine - b_6
    b_3 = c_3 + b_4 * twice_cosine - b_5
    b_2 = c_2 + b_3 * twice_cosine - b_4
    b_1 = c_1 + b_2 * twice_cosine - b_3

    return b_1 * _np.sin(x) + (1.0 + k) * phi1


# Source: Prikhodko et al. 2024, integral (9) of equation (8)
# Expressions sha256: f93c78d29790197279f8b57b816590b434a217193e12ca9061f03af4f0d0e490
# Form: Fourier series, 2 terms, float32
# Rewrites: clenshaw, in_single
# Operations: 17
def position_fourier_2_single(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `position` by another form: Fourier series, 2 terms, float32.

        position_fourier_2_single = 2*e*sin(x) + e**2*sin(2*x) + phi1*(1 + k)
        k = R1/R2
        x = k*phi1

    The bound includes the roundings of float32, |x| <= 2**26.

    Approximation, Fourier series, 2 terms, float32: |result - exact| <= 2**-24 + 17*e/(2**24*(1
    - e)) + 2*e**3/(3 - 3*e) + e*(2 + 24*e + 4*e**2)/(2**24*(1 - e)**2), apart from rounding.

    Same domain as `position`.

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio_printed, R1, R2, e)
    return _in_blocks(
        _form_of_position_fourier_2_single,
        (phi1,),
        _prepare_of_position_fourier_2_single,
        (R1, R2, e),
        out=out,
    )


def _prepare_of_position_fourier_2_single(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    c_1 = _single(2.0 * e)
    c_2 = _single(_square(e))
    k = R1 / R2

    return (c_1, c_2, k)


def _form_of_position_fourier_2_single(phi1: Any, c_1: Any, c_2: Any, k: Any) -> Any:
    x = k * phi1
    single_x = _single(_whole_turns_off(x))
    twice_cosine = 2.0 * _np.cos(single_x)
    b_1 = c_1 + c_2 * twice_cosine

    return b_1 * _np.sin(single_x) + (1.0 + k) * phi1


# Source: Prikhodko et al. 2024, integral (9) of equation (8)
# Expressions sha256: 76c285e9227d1ad25949bf3c385c34ca27852ce263eba192f95312c03b8e1991
# Form: Fourier series, 4 terms, float32
# Rewrites: clenshaw, in_single
# Operations: 32
def position_fourier_4_single(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `position` by another form: Fourier series, 4 terms, float32.

        position_fourier_4_single = 2*e*sin(x) + e**2*sin(2*x) + 2*e**3*sin(3*x)/3 +
            e**4*sin(4*x)/2 + phi1*(1 + k)
        k = R1/R2
        x = k*phi1

    The bound includes the roundings of float32, |x| <= 2**26.

    Approximation, Fourier series, 4 terms, float32: |result - exact| <= 2**-24 + 17*e/(2**24*(1
    - e)) + 2*e**5/(5 - 5*e) + e*(2 + 24*e + 4*e**2)/(2**24*(1 - e)**2), apart from rounding.

    Same domain as `position`.

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio_printed, R1, R2, e)
    return _in_blocks(
        _form_of_position_fourier_4_single,
        (phi1,),
        _prepare_of_position_fourier_4_single,
        (R1, R2, e),
        out=out,
    )


def _prepare_of_position_fourier_4_single(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    c_1 = _single(2.0 * e)
    c_3 = _single(2.0 * (e * _square(e)) / 3.0)
    c_4 = _single(_square(_square(e)) / 2.0)
    k = R1 / R2
    c_2 = _single(_square(e))

    return (c_1, c_3, c_4, k, c_2)


def _form_of_position_fourier_4_single(
    phi1: Any, c_1: Any, c_3: Any, c_4: Any, k: Any, c_2: Any
) -> Any:
    x = k * phi1
    single_x = _single(_whole_turns_off(x))
    twice_cosine = 2.0 * _np.cos(single_x)
    b_3 = c_3 + c_4 * twice_cosine
    b_2 = c_2 + b_3 * twice_cosine - c_4
    b_1 = c_1 + b_2 * twice_cosine - b_3

    return b_1 * _np.sin(single_x) + (1.0 + k) * phi1


# Source: Prikhodko et al. 2024, integral (9) of equation (8)
# Expressions sha256: c1b4ff069f62fe58caaf360caa9fab7828d83c252affcb8f2c5891b5e313d23d
# Form: Fourier series, 8 terms, float32
# Rewrites: clenshaw, in_single
# Operations: 67
def position_fourier_8_single(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `position` by another form: Fourier series, 8 terms, float32.

        position_fourier_8_single = 2*e*sin(x) + e**2*sin(2*x) + 2*e**3*sin(3*x)/3 +
            e**4*sin(4*x)/2 + 2*e**5*sin(5*x)/5 + e**6*sin(6*x)/3 + 2*e**7*sin(7*x)/7 +
            e**8*sin(8*x)/4 + phi1*(1 + k)
        k = R1/R2
        x = k*phi1

    The bound includes the roundings of float32, |x| <= 2**26.

    Approximation, Fourier series, 8 terms, float32: |result - exact| <= 2**-24 + 17*e/(2**24*(1
    - e)) + 2*e**9/(9 - 9*e) + e*(2 + 24*e + 4*e**2)/(2**24*(1 - e)**2), apart from rounding.

    Same domain as `position`.

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio_printed, R1, R2, e)
    return _in_blocks(
        _form_of_position_fourier_8_single,
        (phi1,),
        _prepare_of_position_fourier_8_single,
        (R1, R2, e),
        out=out,
    )


def _prepare_of_position_fourier_8_single(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    c_1 = _single(2.0 * e)
    c_3 = _single(2.0 * (e * _square(e)) / 3.0)
    c_5 = _single(2.0 * (e * _square(_square(e))) / 5.0)
    c_7 = _single(2.0 * (e * _square(e * _square(e))) / 7.0)
    c_8 = _single(_square(_square(_square(e))) / 4.0)
    k = R1 / R2
    c_6 = _single(_square(e * _square(e)) / 3.0)
    c_4 = _single(_square(_square(e)) / 2.0)
    c_2 = _single(_square(e))

    return (c_1, c_3, c_5, c_7, c_8, k, c_6, c_4, c_2)


def _form_of_position_fourier_8_single(
    phi1: Any,
    c_1: Any,
    c_3: Any,
    c_5: Any,
    c_7: Any,
    c_8: Any,
    k: Any,
    c_6: Any,
    c_4: Any,
    c_2: Any,
) -> Any:
    x = k * phi1
    single_x = _single(_whole_turns_off(x))
    twice_cosine = 2.0 * _np.cos(single_x)
    b_7 = c_7 + c_8 * twice_cosine
    b_6 = c_6 + b_7 * twice_cosine - c_8
    b_5 = c_5 + b_6 * twice_cosine - b_7
    b_4 = c_4 + b_5 * twice_cosine - b_6
    b_3 = c_3 + b_4 * twice_cosine - b_5
    b_2 = c_2 + b_3 * twice_cosine - b_4
    b_1 = c_1 + b_2 * twice_cosine - b_3

    return b_1 * _np.sin(single_x) + (1.0 + k) * phi1


# Source: Prikhodko et al. 2024, integral (9) of equation (8)
# Expressions sha256: 6b8b8250eeb934d113b82188782b1154e95336f214f49d351fb7d60df4849ef4
# Form: Fourier series, 12 terms, float32
# Rewrites: clenshaw, in_single
# Operations: 106
def position_fourier_12_single(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `position` by another form: Fourier series, 12 terms, float32.

        position_fourier_12_single = 2*e*sin(x) + e**2*sin(2*x) + 2*e**3*sin(3*x)/3 +
            e**4*sin(4*x)/2 + 2*e**5*sin(5*x)/5 + e**6*sin(6*x)/3 + 2*e**7*sin(7*x)/7 +
            e**8*sin(8*x)/4 + 2*e**9*sin(9*x)/9 + e**10*sin(10*x)/5 + 2*e**11*sin(11*x)/11 +
            e**12*sin(12*x)/6 + phi1*(1 + k)
        k = R1/R2
        x = k*phi1

    The bound includes the roundings of float32, |x| <= 2**26.

    Approximation, Fourier series, 12 terms, float32: |result - exact| <= 2**-24 +
    17*e/(2**24*(1 - e)) + 2*e**13/(13 - 13*e) + e*(2 + 24*e + 4*e**2)/(2**24*(1 - e)**2), apart
    from rounding.

    Same domain as `position`.

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio_printed, R1, R2, e)
    return _in_blocks(
        _form_of_position_fourier_12_single,
        (phi1,),
        _prepare_of_position_fourier_12_single,
        (R1, R2, e),
        out=out,
    )


def _prepare_of_position_fourier_12_single(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    c_1 = _single(2.0 * e)
    c_3 = _single(2.0 * (e * _square(e)) / 3.0)
    c_5 = _single(2.0 * (e * _square(_square(e))) / 5.0)
    c_7 = _single(2.0 * (e * _square(e * _square(e))) / 7.0)
    c_9 = _single(2.0 * (e * _square(_square(_square(e)))) / 9.0)
    c_11 = _single(2.0 * (e * _square(e * _square(_square(e)))) / 11.0)
    c_12 = _single(_square(_square(e * _square(e))) / 6.0)
    k = R1 / R2
    c_10 = _single(_square(e * _square(_square(e))) / 5.0)
    c_8 = _single(_square(_square(_square(e))) / 4.0)
    c_6 = _single(_square(e * _square(e)) / 3.0)
    c_4 = _single(_square(_square(e)) / 2.0)
    c_2 = _single(_square(e))

    return (c_1, c_3, c_5, c_7, c_9, c_11, c_12, k, c_10, c_8, c_6, c_4, c_2)


def _form_of_position_fourier_12_single(
    phi1: Any,
    c_1: Any,
    c_3: Any,
    c_5: Any,
    c_7: Any,
    c_9: Any,
    c_11: Any,
    c_12: Any,
    k: Any,
    c_10: Any,
    c_8: Any,
    c_6: Any,
    c_4: Any,
    c_2: Any,
) -> Any:
    x = k * phi1
    single_x = _single(_whole_turns_off(x))
    twice_cosine = 2.0 * _np.cos(single_x)
    b_11 = c_11 + c_12 * twice_cosine
    b_10 = c_10 + b_11 * twice_cosine - c_12
    b_9 = c_9 + b_10 * twice_cosine - b_11
    b_8 = c_8 + b_9 * twice_cosine - b_10
    b_7 = c_7 + b_8 * twice_cosine - b_9
    b_6 = c_6 + b_7 * twice_cosine - b_8
    b_5 = c_5 + b_6 * twice_cosine - b_7
    b_4 = c_4 + b_5 * twice_cosine - b_6
    b_3 = c_3 + b_4 * twice_cosine - b_5
    b_2 = c_2 + b_3 * twice_cosine - b_4
    b_1 = c_1 + b_2 * twice_cosine - b_3

    return b_1 * _np.sin(single_x) + (1.0 + k) * phi1


# Source: derivative of Prikhodko et al. 2024, equation (8)
# Expressions sha256: 91b69a6ba07be0093cc100c53552f487804079c310d6d68931af9e3d14dcd55f
# Form: 1 + e**2 - 2 e cos x
# Operations: 17
def acceleration_direct(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `acceleration` by another form: 1 + e**2 - 2 e cos x.

        acceleration_direct = -2*e*k**2*(1 - e**2)*sin(x)/(1 + e**2 - 2*e*cos(x))**2
        k = R1/R2
        x = k*phi1

    Same domain as `acceleration`.

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio_printed, R1, R2, e)
    return _in_blocks(
        _form_of_acceleration_direct, (phi1,), _prepare_of_acceleration_direct, (R1, R2, e), out=out
    )


def _prepare_of_acceleration_direct(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    k = R1 / R2
    e_squared = _square(e)

    return (e, k, e_squared)


def _form_of_acceleration_direct(phi1: Any, e: Any, k: Any, e_squared: Any) -> Any:
    x = k * phi1

    return (
        -2.0
        * e
        * _square(k)
        * (1.0 - e_squared)
        / _square(1.0 + e_squared - 2.0 * e * _np.cos(x))
        * _np.sin(x)
    )


# Source: derivative of Prikhodko et al. 2024, equation (8)
# Expressions sha256: 451f7ad45b78d59a76edea454707f71141d26ad2ae407477d78699fa21609fdb
# Form: half-angle sine
# Operations: 20
def acceleration_half_angle(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `acceleration` by another form: half-angle sine.

        acceleration_half_angle = -2*e*k**2*(1 - e)*(1 + e)*sin(x)/(4*e*sin(x/2)**2 + (1 -
            e)**2)**2
        k = R1/R2
        x = k*phi1

    Same domain as `acceleration`.

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio_printed, R1, R2, e)
    return _in_blocks(
        _form_of_acceleration_half_angle,
        (phi1,),
        _prepare_of_acceleration_half_angle,
        (R1, R2, e),
        out=out,
    )


def _prepare_of_acceleration_half_angle(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    one_minus_e = 1.0 - e
    k = R1 / R2

    return (e, one_minus_e, k)


def _form_of_acceleration_half_angle(phi1: Any, e: Any, one_minus_e: Any, k: Any) -> Any:
    x = k * phi1

    return (
        -2.0
        * e
        * one_minus_e
        * _square(k)
        * (1.0 + e)
        / _square(_square(one_minus_e) + 4.0 * e * _square(_np.sin(x / 2.0)))
        * _np.sin(x)
    )


# Source: second derivative of Prikhodko et al. 2024, equation (8)
# Expressions sha256: 51e8ad209ef40e708c2f4dfdce25b1d5e4b439e22bf7c28209bc82018c776ea4
# Form: 1 + e**2 - 2 e cos x
# Operations: 27
def jerk_direct(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `jerk` by another form: 1 + e**2 - 2 e cos x.

        jerk_direct = k*(8*e**2*k**2*(1 - e**2)*sin(x)**2/(1 + e**2 - 2*e*cos(x))**3 -
            2*e*k**2*(1 - e**2)*cos(x)/(1 + e**2 - 2*e*cos(x))**2)
        k = R1/R2
        x = k*phi1

    Same domain as `jerk`.

    """
    phi1, R1, R2, e = _as_floats("phi1 R1 R2 e", phi1, R1, R2, e)
    R1, R2, e = _nan_outside(_check_of_ratio_printed, R1, R2, e)
    return _in_blocks(_form_of_jerk_direct, (phi1,), _prepare_of_jerk_direct, (R1, R2, e), out=out)


def _prepare_of_jerk_direct(R1: Any, R2: Any, e: Any) -> tuple[Any, ...]:
    k = R1 / R2
    k_squared = _square(k)
    e_squared = _square(e)
    one_minus_e_squared = 1.0 - e_squared

    return (e, k, k_squared, e_squared, one_minus_e_squared)


def _form_of_jerk_direct(
    phi1: Any, e: Any, k: Any, k_squared: Any, e_squared: Any, one_minus_e_squared: Any
) -> Any:
    x = k * phi1
    cos_x = _np.cos(x)
    term = 1.0 + e_squared - 2.0 * e * cos_x

    return k * (
        8.0
        * e_squared
        * k_squared
        * one_minus_e_squared
        / (term * _square(term))
        * _square(_np.sin(x))
        - 2.0 * e * k_squared * one_minus_e_squared / _square(term) * cos_x
    )
