"""Other forms of the kernels of `oval_planetary`.

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

Generated from the derivation oval_planetary with SymPy 1.14.0.
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
from mechproof.kernel_support.functions import floor as _floor, square as _square

__all__ = [
    "acceleration_cylindrical_direct",
    "acceleration_direct",
    "jerk_cylindrical_direct",
    "jerk_direct",
    "position_atan2",
    "position_cylindrical_atan2",
    "position_cylindrical_atan2_stable",
    "position_cylindrical_floor",
    "position_floor",
    "position_unsplit",
    "ratio_cylindrical_half_angle",
    "ratio_cylindrical_printed",
    "ratio_direct",
    "ratio_printed",
]


def __dir__() -> list[str]:
    return __all__


# Source: Prikhodko et al. 2024 (oval wheels), equation (10)
# Expressions sha256: ca4a74ae06f540dc0d5f8800c02025bbed107a98e8592c71215daf2eaf0e4183
# Form: printed (3)-(6), (10)
# Operations: 33
def ratio_printed(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute `ratio` by another form: printed (3)-(6), (10).

        ratio_printed = -2*(1 + e1*cos(2*phi6))*((1 - e2**2)/(1 - e2*cos(2*mount + 2*phi6)) - (1
            - e1**2)/(1 + e1*cos(2*phi6)))/((1 - e1**2)*(2 - (1 - e2**2)/(1 - e2*cos(2*mount +
            2*phi6))))
        phi6 = phi1 + atan2(e1*sin(2*phi1), 1 - e1*cos(2*phi1))

    The print with its sign reversed, wheel 6 at its mounted angle; proved to be the speed of
    wheel 3, which the row on any mount has for the map.

    Same domain as `ratio`.

    Source: Prikhodko et al. 2024 (oval wheels), equations (3)-(6) and (10).

    """
    phi1, e1, e2, mount = _as_floats("phi1 e1 e2 mount", phi1, e1, e2, mount)
    e1, e2 = _nan_outside(_check_of_ratio_printed, e1, e2)
    return _in_blocks(
        _form_of_ratio_printed, (phi1,), _prepare_of_ratio_printed, (e1, e2, mount), out=out
    )


def _check_of_ratio_printed(e1: Any, e2: Any) -> tuple[Any, ...]:
    return (e1 >= 0.0, e1 < 1.0, e2 >= 0.0, e2 < 1.0)


def _prepare_of_ratio_printed(e1: Any, e2: Any, mount: Any) -> tuple[Any, ...]:
    one_minus_e1_squared = 1.0 - _square(e1)
    one_minus_e2_squared = 1.0 - _square(e2)

    return (e1, e2, mount, one_minus_e1_squared, one_minus_e2_squared)


def _form_of_ratio_printed(
    phi1: Any, e1: Any, e2: Any, mount: Any, one_minus_e1_squared: Any, one_minus_e2_squared: Any
) -> Any:
    phi6 = phi1 + _np.arctan2(e1 * _np.sin(2.0 * phi1), 1.0 - e1 * _np.cos(2.0 * phi1))
    one_plus_e1_cos_two_phi6 = 1.0 + e1 * _np.cos(2.0 * phi6)
    term = 1.0 / (1.0 - e2 * _np.cos(2.0 * mount + 2.0 * phi6))

    return (
        -2.0
        / (one_minus_e1_squared * (2.0 - one_minus_e2_squared * term))
        * one_plus_e1_cos_two_phi6
        * (one_minus_e2_squared * term - one_minus_e1_squared / one_plus_e1_cos_two_phi6)
    )


# Source: Prikhodko et al. 2024 (oval wheels), equation (10)
# Expressions sha256: e85d586e1c75cf87ebeca656dcabdaba74b43ecab42fec8973a012066e5c7f0a
# Form: double angles
# Operations: 39
def ratio_direct(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute `ratio` by another form: double angles.

        ratio_direct = 1 - 2*alpha_double*beta_double/(beta_double**2*(1 + cos(2*phi1)) + (1 -
            cos(2*phi1))*(alpha_double**2 + gamma_double**2) +
            2*beta_double*gamma_double*sin(2*phi1))
        alpha_double = (1 - e2**2)*(1 + e1)
        beta_double = (1 - e1)*(1 + e2**2 - 2*e2*cos(2*mount))
        gamma_double = e2*(2 + 2*e1)*sin(2*mount)

    Same domain as `ratio`.

    """
    phi1, e1, e2, mount = _as_floats("phi1 e1 e2 mount", phi1, e1, e2, mount)
    e1, e2 = _nan_outside(_check_of_ratio_printed, e1, e2)
    return _in_blocks(
        _form_of_ratio_direct, (phi1,), _prepare_of_ratio_direct, (e1, e2, mount), out=out
    )


def _prepare_of_ratio_direct(e1: Any, e2: Any, mount: Any) -> tuple[Any, ...]:
    e2_squared = _square(e2)
    alpha_double = (1.0 + e1) * (1.0 - e2_squared)
    beta_double = (1.0 - e1) * (1.0 + e2_squared - 2.0 * e2 * _np.cos(2.0 * mount))
    gamma_double = e2 * (2.0 + 2.0 * e1) * _np.sin(2.0 * mount)

    return (alpha_double, beta_double, gamma_double)


def _form_of_ratio_direct(phi1: Any, alpha_double: Any, beta_double: Any, gamma_double: Any) -> Any:
    cos_two_phi1 = _np.cos(2.0 * phi1)

    return 1.0 - 2.0 * alpha_double * beta_double / (
        _square(beta_double) * (1.0 + cos_two_phi1)
        + (_square(alpha_double) + _square(gamma_double)) * (1.0 - cos_two_phi1)
        + 2.0 * beta_double * gamma_double * _np.sin(2.0 * phi1)
    )


# Source: Prikhodko et al. 2024 (oval wheels), integral (11)
# Expressions sha256: 62e7475df8934fd500d5c17b765bb3df939c4e1abcde9ce76f5be69832d9d327
# Form: leads by atan2, 1 - e cos 2 phi
# Operations: 29
def position_atan2(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute `position` by another form: leads by atan2, 1 - e cos 2 phi.

        position_atan2 = phi1 + atan2(e2*sin(2*mount), 1 - e2*cos(2*mount)) - phi6 -
            atan2(e2*sin(2*mount + 2*phi6), 1 - e2*cos(2*mount + 2*phi6))
        phi6 = phi1 + atan2(e1*sin(2*phi1), 1 - e1*cos(2*phi1))

    Proved for each pair; the rows on any mount put the pairs in series.

    Same domain as `position`.

    """
    phi1, e1, e2, mount = _as_floats("phi1 e1 e2 mount", phi1, e1, e2, mount)
    e1, e2 = _nan_outside(_check_of_ratio_printed, e1, e2)
    return _in_blocks(_form_of_position_atan2, (phi1,), parameters=(e1, e2, mount), out=out)


def _form_of_position_atan2(phi1: Any, e1: Any, e2: Any, mount: Any) -> Any:
    phi6 = phi1 + _np.arctan2(e1 * _np.sin(2.0 * phi1), 1.0 - e1 * _np.cos(2.0 * phi1))
    two_mount_plus_two_phi6 = 2.0 * mount + 2.0 * phi6

    return (
        phi1
        + _np.arctan2(e2 * _np.sin(2.0 * mount), 1.0 - e2 * _np.cos(2.0 * mount))
        - phi6
        - _np.arctan2(
            e2 * _np.sin(two_mount_plus_two_phi6), 1.0 - e2 * _np.cos(two_mount_plus_two_phi6)
        )
    )


# Source: Prikhodko et al. 2024 (oval wheels), integral (11)
# Expressions sha256: 6ba20f38f59c1f73931c4d5fe0b73582bc2081d2545e615428355106739ed671
# Form: tan/arctan + floor
# Operations: 35
def position_floor(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute `position` by another form: tan/arctan + floor.

        position_floor = mount_counted + phi1 - pi*floor(1/2 + (mount + phi6_counted)/pi) -
            atan((1 + e2)*tan(mount + phi6_counted)/(1 - e2))
        phi6_counted = pi*floor(1/2 + phi1/pi) + atan((1 + e1)*tan(phi1)/(1 - e1))
        mount_counted = pi*floor(1/2 + mount/pi) + atan((1 + e2)*tan(mount)/(1 - e2))

    Proved to be that by atan2, for each angle beside pi m; the computed floor and tangent
    disagree at the ends.

    Same domain as `position`, each angle is on its first branch.

    """
    phi1, e1, e2, mount = _as_floats("phi1 e1 e2 mount", phi1, e1, e2, mount)
    e1, e2 = _nan_outside(_check_of_ratio_printed, e1, e2)
    return _in_blocks(
        _form_of_position_floor, (phi1,), _prepare_of_position_floor, (e1, e2, mount), out=out
    )


def _prepare_of_position_floor(e1: Any, e2: Any, mount: Any) -> tuple[Any, ...]:
    one_plus_e2 = 1.0 + e2
    term = 1.0 / (1.0 - e2)
    mount_counted = _np.pi * _floor(0.5 + mount / _np.pi) + _np.arctan(
        one_plus_e2 * term * _np.tan(mount)
    )

    return (e1, mount, one_plus_e2, term, mount_counted)


def _form_of_position_floor(
    phi1: Any, e1: Any, mount: Any, one_plus_e2: Any, term: Any, mount_counted: Any
) -> Any:
    phi6_counted = _np.pi * _floor(0.5 + phi1 / _np.pi) + _np.arctan(
        (1.0 + e1) / (1.0 - e1) * _np.tan(phi1)
    )
    mount_plus_phi6_counted = mount + phi6_counted

    return (
        mount_counted
        + phi1
        - _np.pi * _floor(0.5 + mount_plus_phi6_counted / _np.pi)
        - _np.arctan(one_plus_e2 * term * _np.tan(mount_plus_phi6_counted))
    )


# Source: Prikhodko et al. 2024 (oval wheels), integral (11)
# Expressions sha256: e44feb034ceb98236caa37bc6414805925f4da26f3fa3a7365fd624a7b2cce7d
# Form: one atan2, unsplit
# Operations: 28
def position_unsplit(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute `position` by another form: one atan2, unsplit.

        position_unsplit = atan2((beta_double + gamma_double*tan(phi1) -
            alpha_double)*tan(phi1), beta_double + alpha_double*tan(phi1)**2 +
            gamma_double*tan(phi1))
        alpha_double = (1 - e2**2)*(1 + e1)
        beta_double = (1 - e1)*(1 + e2**2 - 2*e2*cos(2*mount))
        gamma_double = e2*(2 + 2*e1)*sin(2*mount)

    Same domain as `position`.

    """
    phi1, e1, e2, mount = _as_floats("phi1 e1 e2 mount", phi1, e1, e2, mount)
    e1, e2 = _nan_outside(_check_of_ratio_printed, e1, e2)
    return _in_blocks(
        _form_of_position_unsplit, (phi1,), _prepare_of_position_unsplit, (e1, e2, mount), out=out
    )


def _prepare_of_position_unsplit(e1: Any, e2: Any, mount: Any) -> tuple[Any, ...]:
    e2_squared = _square(e2)
    beta_double = (1.0 - e1) * (1.0 + e2_squared - 2.0 * e2 * _np.cos(2.0 * mount))
    gamma_double = e2 * (2.0 + 2.0 * e1) * _np.sin(2.0 * mount)
    alpha_double = (1.0 + e1) * (1.0 - e2_squared)

    return (beta_double, gamma_double, alpha_double)


def _form_of_position_unsplit(
    phi1: Any, beta_double: Any, gamma_double: Any, alpha_double: Any
) -> Any:
    tan_phi1 = _np.tan(phi1)
    gamma_double_tan_phi1 = gamma_double * tan_phi1

    return _np.arctan2(
        tan_phi1 * (beta_double + gamma_double_tan_phi1 - alpha_double),
        beta_double + gamma_double_tan_phi1 + alpha_double * _square(tan_phi1),
    )


# Source: Prikhodko et al. 2024 (oval wheels), derivative of (10)
# Expressions sha256: 83f1585f750dbf1d07ebb5dbd3d461668eae4ab2e716f02807506636870def95
# Form: double angles
# Operations: 49
def acceleration_direct(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute `acceleration` by another form: double angles.

        acceleration_direct = -2*alpha_double*beta_double*(2*beta_double**2*sin(2*phi1) -
            2*(alpha_double**2 + gamma_double**2)*sin(2*phi1) -
            4*beta_double*gamma_double*cos(2*phi1))/(beta_double**2*(1 + cos(2*phi1)) + (1 -
            cos(2*phi1))*(alpha_double**2 + gamma_double**2) +
            2*beta_double*gamma_double*sin(2*phi1))**2
        alpha_double = (1 - e2**2)*(1 + e1)
        beta_double = (1 - e1)*(1 + e2**2 - 2*e2*cos(2*mount))
        gamma_double = e2*(2 + 2*e1)*sin(2*mount)

    Same domain as `acceleration`.

    """
    phi1, e1, e2, mount = _as_floats("phi1 e1 e2 mount", phi1, e1, e2, mount)
    e1, e2 = _nan_outside(_check_of_ratio_printed, e1, e2)
    return _in_blocks(
        _form_of_acceleration_direct,
        (phi1,),
        _prepare_of_acceleration_direct,
        (e1, e2, mount),
        out=out,
    )


def _prepare_of_acceleration_direct(e1: Any, e2: Any, mount: Any) -> tuple[Any, ...]:
    e2_squared = _square(e2)
    alpha_double = (1.0 + e1) * (1.0 - e2_squared)
    beta_double = (1.0 - e1) * (1.0 + e2_squared - 2.0 * e2 * _np.cos(2.0 * mount))
    beta_double_squared = _square(beta_double)
    gamma_double = e2 * (2.0 + 2.0 * e1) * _np.sin(2.0 * mount)
    term = _square(alpha_double) + _square(gamma_double)

    return (alpha_double, beta_double, beta_double_squared, gamma_double, term)


def _form_of_acceleration_direct(
    phi1: Any,
    alpha_double: Any,
    beta_double: Any,
    beta_double_squared: Any,
    gamma_double: Any,
    term: Any,
) -> Any:
    cos_two_phi1 = _np.cos(2.0 * phi1)
    sin_two_phi1 = _np.sin(2.0 * phi1)

    return (
        -2.0
        * alpha_double
        * beta_double
        / _square(
            beta_double_squared * (1.0 + cos_two_phi1)
            + term * (1.0 - cos_two_phi1)
            + 2.0 * beta_double * gamma_double * sin_two_phi1
        )
        * (
            2.0 * beta_double_squared * sin_two_phi1
            - 2.0 * term * sin_two_phi1
            - 4.0 * beta_double * gamma_double * cos_two_phi1
        )
    )


# Source: Prikhodko et al. 2024 (oval wheels), equation (10), pair 4-5 cylindrical
# Expressions sha256: 4f7a0e61441a09251b29401211777028c98b6afe9cde12514027a872347afeea
# Form: printed (4), (10)
# Operations: 23
def ratio_cylindrical_printed(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `ratio_cylindrical` by another form: printed (4), (10).

        ratio_cylindrical_printed = -2*(R4/2 + R5/2)*((1 - e2**2)*(R4/2 + R5/2)/(1 - e2*cos(x))
            - R5)/(R5*(R4 + R5 - (1 - e2**2)*(R4/2 + R5/2)/(1 - e2*cos(x))))
        k = R4/R5
        x = 2*k*phi1

    The print with its sign reversed.

    Same domain as `ratio_cylindrical`.

    Source: Prikhodko et al. 2024 (oval wheels), equations (4) and (10).

    """
    phi1, R4, R5, e2 = _as_floats("phi1 R4 R5 e2", phi1, R4, R5, e2)
    R4, R5, e2 = _nan_outside(_check_of_ratio_cylindrical_printed, R4, R5, e2)
    return _in_blocks(
        _form_of_ratio_cylindrical_printed,
        (phi1,),
        _prepare_of_ratio_cylindrical_printed,
        (R4, R5, e2),
        out=out,
    )


def _check_of_ratio_cylindrical_printed(R4: Any, R5: Any, e2: Any) -> tuple[Any, ...]:
    return (_is_positive(R4), _is_positive(R5), e2 >= 0.0, e2 < 1.0)


def _prepare_of_ratio_cylindrical_printed(R4: Any, R5: Any, e2: Any) -> tuple[Any, ...]:
    term_2 = R4 / 2.0 + R5 / 2.0
    one_minus_e2_squared = 1.0 - _square(e2)
    k = R4 / R5

    return (R4, R5, e2, term_2, one_minus_e2_squared, k)


def _form_of_ratio_cylindrical_printed(
    phi1: Any, R4: Any, R5: Any, e2: Any, term_2: Any, one_minus_e2_squared: Any, k: Any
) -> Any:
    x = 2.0 * k * phi1
    term = 1.0 / (1.0 - e2 * _np.cos(x))

    return (
        -2.0
        * term_2
        / (R5 * (R4 + R5 - one_minus_e2_squared * term_2 * term))
        * (one_minus_e2_squared * term_2 * term - R5)
    )


# Source: Prikhodko et al. 2024 (oval wheels), equation (10), pair 4-5 cylindrical
# Expressions sha256: 2410532441e7ae395b7a37652b4086188ba22f71b48e476ce6f6644f19b59b9f
# Form: half-angle sine
# Operations: 16
def ratio_cylindrical_half_angle(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `ratio_cylindrical` by another form: half-angle sine.

        ratio_cylindrical_half_angle = 1 - k*(1 - e2)*(1 + e2)/(4*e2*sin(x/2)**2 + (1 - e2)**2)
        k = R4/R5
        x = 2*k*phi1

    Same domain as `ratio_cylindrical`.

    """
    phi1, R4, R5, e2 = _as_floats("phi1 R4 R5 e2", phi1, R4, R5, e2)
    R4, R5, e2 = _nan_outside(_check_of_ratio_cylindrical_printed, R4, R5, e2)
    return _in_blocks(
        _form_of_ratio_cylindrical_half_angle,
        (phi1,),
        _prepare_of_ratio_cylindrical_half_angle,
        (R4, R5, e2),
        out=out,
    )


def _prepare_of_ratio_cylindrical_half_angle(R4: Any, R5: Any, e2: Any) -> tuple[Any, ...]:
    k = R4 / R5
    one_minus_e2 = 1.0 - e2

    return (e2, k, one_minus_e2)


def _form_of_ratio_cylindrical_half_angle(phi1: Any, e2: Any, k: Any, one_minus_e2: Any) -> Any:
    x = 2.0 * k * phi1

    return 1.0 - k * one_minus_e2 * (1.0 + e2) / (
        _square(one_minus_e2) + 4.0 * e2 * _square(_np.sin(x / 2.0))
    )


# Source: Prikhodko et al. 2024 (oval wheels), integral (11), pair 4-5 cylindrical
# Expressions sha256: 79116fa3ceb4735b72f946bba74f36a483d6f4c83e6e7421d2fe2e519e2e0893
# Form: atan2, 1 - e cos x
# Operations: 12
def position_cylindrical_atan2(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `position_cylindrical` by another form: atan2, 1 - e cos x.

        position_cylindrical_atan2 = phi1*(1 - k) - atan2(e2*sin(x), 1 - e2*cos(x))
        k = R4/R5
        x = 2*k*phi1

    Same domain as `position_cylindrical`.

    """
    phi1, R4, R5, e2 = _as_floats("phi1 R4 R5 e2", phi1, R4, R5, e2)
    R4, R5, e2 = _nan_outside(_check_of_ratio_cylindrical_printed, R4, R5, e2)
    return _in_blocks(
        _form_of_position_cylindrical_atan2,
        (phi1,),
        _prepare_of_position_cylindrical_atan2,
        (R4, R5, e2),
        out=out,
    )


def _prepare_of_position_cylindrical_atan2(R4: Any, R5: Any, e2: Any) -> tuple[Any, ...]:
    k = R4 / R5

    return (e2, k)


def _form_of_position_cylindrical_atan2(phi1: Any, e2: Any, k: Any) -> Any:
    x = 2.0 * k * phi1

    return (1.0 - k) * phi1 - _np.arctan2(e2 * _np.sin(x), 1.0 - e2 * _np.cos(x))


# Source: Prikhodko et al. 2024 (oval wheels), integral (11), pair 4-5 cylindrical
# Expressions sha256: de1be2a005030f0ab8e3d5995ec13a8f50579db96825daf5786686f69b2cd531
# Form: atan2, no cancellation
# Operations: 16
def position_cylindrical_atan2_stable(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `position_cylindrical` by another form: atan2, no cancellation.

        position_cylindrical_atan2_stable = phi1*(1 - k) - atan2(e2*sin(x), nearest +
            2*e2*sin(x/2)**2)
        k = R4/R5
        x = 2*k*phi1
        nearest = 1 - e2

    Same domain as `position_cylindrical`.

    """
    phi1, R4, R5, e2 = _as_floats("phi1 R4 R5 e2", phi1, R4, R5, e2)
    R4, R5, e2 = _nan_outside(_check_of_ratio_cylindrical_printed, R4, R5, e2)
    return _in_blocks(
        _form_of_position_cylindrical_atan2_stable,
        (phi1,),
        _prepare_of_position_cylindrical_atan2_stable,
        (R4, R5, e2),
        out=out,
    )


def _prepare_of_position_cylindrical_atan2_stable(R4: Any, R5: Any, e2: Any) -> tuple[Any, ...]:
    k = R4 / R5
    nearest = 1.0 - e2

    return (e2, k, nearest)


def _form_of_position_cylindrical_atan2_stable(phi1: Any, e2: Any, k: Any, nearest: Any) -> Any:
    x = 2.0 * k * phi1

    return (1.0 - k) * phi1 - _np.arctan2(
        e2 * _np.sin(x), nearest + 2.0 * e2 * _square(_np.sin(x / 2.0))
    )


# Source: Prikhodko et al. 2024 (oval wheels), integral (11), pair 4-5 cylindrical
# Expressions sha256: 11d548d1e1333a3f11154e9653753d268fa049237d9ea66c66af545d2e1e4929
# Form: tan/arctan + floor
# Operations: 17
def position_cylindrical_floor(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `position_cylindrical` by another form: tan/arctan + floor.

        position_cylindrical_floor = phi1 - pi*floor(1/2 + x/(2*pi)) - atan((1 + e2)*tan(x/2)/(1
            - e2))
        k = R4/R5
        x = 2*k*phi1

    Proved for |x - 2 pi m| < pi; the computed floor and tangent disagree at the ends.

    Same domain as `position_cylindrical`, |x| < pi, the first branch.

    """
    phi1, R4, R5, e2 = _as_floats("phi1 R4 R5 e2", phi1, R4, R5, e2)
    R4, R5, e2 = _nan_outside(_check_of_ratio_cylindrical_printed, R4, R5, e2)
    return _in_blocks(
        _form_of_position_cylindrical_floor,
        (phi1,),
        _prepare_of_position_cylindrical_atan2,
        (R4, R5, e2),
        out=out,
    )


def _form_of_position_cylindrical_floor(phi1: Any, e2: Any, k: Any) -> Any:
    x = 2.0 * k * phi1

    return (
        phi1
        - _np.pi * _floor(0.5 + x / (2.0 * _np.pi))
        - _np.arctan((1.0 + e2) / (1.0 - e2) * _np.tan(x / 2.0))
    )


# Source: Prikhodko et al. 2024 (oval wheels), derivative of (10), pair 4-5 cylindrical
# Expressions sha256: bd0148c962e84df813095c1a019189f4a423d568a23a9314b13f59408733a46b
# Form: 1 + e**2 - 2 e cos x
# Operations: 18
def acceleration_cylindrical_direct(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `acceleration_cylindrical` by another form: 1 + e**2 - 2 e cos x.

        acceleration_cylindrical_direct = 4*e2*k**2*(1 - e2**2)*sin(x)/(1 + e2**2 -
            2*e2*cos(x))**2
        k = R4/R5
        x = 2*k*phi1

    Same domain as `acceleration_cylindrical`.

    """
    phi1, R4, R5, e2 = _as_floats("phi1 R4 R5 e2", phi1, R4, R5, e2)
    R4, R5, e2 = _nan_outside(_check_of_ratio_cylindrical_printed, R4, R5, e2)
    return _in_blocks(
        _form_of_acceleration_cylindrical_direct,
        (phi1,),
        _prepare_of_acceleration_cylindrical_direct,
        (R4, R5, e2),
        out=out,
    )


def _prepare_of_acceleration_cylindrical_direct(R4: Any, R5: Any, e2: Any) -> tuple[Any, ...]:
    k = R4 / R5
    e2_squared = _square(e2)

    return (e2, k, e2_squared)


def _form_of_acceleration_cylindrical_direct(phi1: Any, e2: Any, k: Any, e2_squared: Any) -> Any:
    x = 2.0 * k * phi1

    return (
        4.0
        * e2
        * _square(k)
        * (1.0 - e2_squared)
        / _square(1.0 + e2_squared - 2.0 * e2 * _np.cos(x))
        * _np.sin(x)
    )


# Source: Prikhodko et al. 2024 (oval wheels), second derivative of (10)
# Expressions sha256: 227b2fecf2509a5d29a78e4234a19748482aac452c1499d98fb01f5df7ebc54f
# Form: double angles
# Operations: 55
def jerk_direct(
    phi1: ArrayLike,
    e1: ArrayLike,
    e2: ArrayLike,
    mount: ArrayLike = 0.0,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute `jerk` by another form: double angles.

        jerk_direct = -8*alpha_double*beta_double*(beta_double**2*cos(2*phi1) +
            2*((alpha_double**2 + gamma_double**2)*sin(2*phi1) +
            2*beta_double*gamma_double*cos(2*phi1) -
            beta_double**2*sin(2*phi1))**2/(beta_double**2*(1 + cos(2*phi1)) +
            2*beta_double*gamma_double*sin(2*phi1) - (alpha_double**2 +
            gamma_double**2)*(cos(2*phi1) - 1)) + 2*beta_double*gamma_double*sin(2*phi1) -
            (alpha_double**2 + gamma_double**2)*cos(2*phi1))/(beta_double**2*(1 + cos(2*phi1)) +
            2*beta_double*gamma_double*sin(2*phi1) - (alpha_double**2 +
            gamma_double**2)*(cos(2*phi1) - 1))**2
        alpha_double = (1 - e2**2)*(1 + e1)
        beta_double = (1 - e1)*(1 + e2**2 - 2*e2*cos(2*mount))
        gamma_double = e2*(2 + 2*e1)*sin(2*mount)

    Same domain as `jerk`.

    """
    phi1, e1, e2, mount = _as_floats("phi1 e1 e2 mount", phi1, e1, e2, mount)
    e1, e2 = _nan_outside(_check_of_ratio_printed, e1, e2)
    return _in_blocks(
        _form_of_jerk_direct, (phi1,), _prepare_of_jerk_direct, (e1, e2, mount), out=out
    )


def _prepare_of_jerk_direct(e1: Any, e2: Any, mount: Any) -> tuple[Any, ...]:
    e2_squared = _square(e2)
    alpha_double = (1.0 + e1) * (1.0 - e2_squared)
    beta_double = (1.0 - e1) * (1.0 + e2_squared - 2.0 * e2 * _np.cos(2.0 * mount))
    gamma_double = e2 * (2.0 + 2.0 * e1) * _np.sin(2.0 * mount)
    beta_double_squared = _square(beta_double)
    term_3 = _square(alpha_double) + _square(gamma_double)

    return (alpha_double, beta_double, gamma_double, beta_double_squared, term_3)


def _form_of_jerk_direct(
    phi1: Any,
    alpha_double: Any,
    beta_double: Any,
    gamma_double: Any,
    beta_double_squared: Any,
    term_3: Any,
) -> Any:
    sin_two_phi1 = _np.sin(2.0 * phi1)
    term_2 = 2.0 * beta_double * gamma_double * sin_two_phi1
    cos_two_phi1 = _np.cos(2.0 * phi1)
    term = term_2 + beta_double_squared * (1.0 + cos_two_phi1) - term_3 * (cos_two_phi1 - 1.0)

    return (
        -8.0
        * alpha_double
        * beta_double
        / _square(term)
        * (
            term_2
            + beta_double_squared * cos_two_phi1
            + 2.0
            / term
            * _square(
                term_3 * sin_two_phi1
                + 2.0 * beta_double * gamma_double * cos_two_phi1
                - beta_double_squared * sin_two_phi1
            )
            - term_3 * cos_two_phi1
        )
    )


# Source: Prikhodko et al. 2024 (oval wheels), second derivative of (10), pair 4-5 cylindrical
# Expressions sha256: b294710bd1c63694bab7f851345011c86ab70a21f829d7eec175cd95e0720685
# Form: 1 + e**2 - 2 e cos x
# Operations: 28
def jerk_cylindrical_direct(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `jerk_cylindrical` by another form: 1 + e**2 - 2 e cos x.

        jerk_cylindrical_direct = k*(8*e2*k**2*(1 - e2**2)*cos(x)/(1 + e2**2 - 2*e2*cos(x))**2 -
            32*e2**2*k**2*(1 - e2**2)*sin(x)**2/(1 + e2**2 - 2*e2*cos(x))**3)
        k = R4/R5
        x = 2*k*phi1

    Same domain as `jerk_cylindrical`.

    """
    phi1, R4, R5, e2 = _as_floats("phi1 R4 R5 e2", phi1, R4, R5, e2)
    R4, R5, e2 = _nan_outside(_check_of_ratio_cylindrical_printed, R4, R5, e2)
    return _in_blocks(
        _form_of_jerk_cylindrical_direct,
        (phi1,),
        _prepare_of_jerk_cylindrical_direct,
        (R4, R5, e2),
        out=out,
    )


def _prepare_of_jerk_cylindrical_direct(R4: Any, R5: Any, e2: Any) -> tuple[Any, ...]:
    k = R4 / R5
    e2_squared = _square(e2)
    k_squared = _square(k)
    one_minus_e2_squared = 1.0 - e2_squared

    return (e2, k, e2_squared, k_squared, one_minus_e2_squared)


def _form_of_jerk_cylindrical_direct(
    phi1: Any, e2: Any, k: Any, e2_squared: Any, k_squared: Any, one_minus_e2_squared: Any
) -> Any:
    x = 2.0 * k * phi1
    cos_x = _np.cos(x)
    term = 1.0 + e2_squared - 2.0 * e2 * cos_x

    return k * (
        8.0 * e2 * k_squared * one_minus_e2_squared / _square(term) * cos_x
        - 32.0
        * e2_squared
        * k_squared
        * one_minus_e2_squared
        / (term * _square(term))
        * _square(_np.sin(x))
    )
