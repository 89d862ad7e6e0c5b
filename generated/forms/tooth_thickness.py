"""Other forms of the kernels of `tooth_thickness`.

Derbaba, Korsun, Patsera, stochastic simulation of the thickness of an involute tooth and of
its measurement

Lengths in mm, angles in rad. Heights grow from the tip towards the centre; deviations of
thickness are positive for a thicker tooth.

Arguments broadcast. The result is a NumPy scalar if all arguments are scalars, otherwise an
array; it is float32 if every array argument is float32, otherwise float64. `out`, an array
of the result's type and shape, receives the result; it may overlap an argument. The result
is NaN outside the domain and where an argument is NaN; in a domain numpy.pi counts as pi.

TypeError: an argument is complex or not numeric, or `out` is not an array of the result's
type. ValueError: shapes do not broadcast, a last axis is wrong, or `out` has another shape.

Generated from the derivation tooth_thickness with SymPy 1.14.0.
Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""

from __future__ import annotations

from typing import Any

import numpy as _np
from numpy.typing import ArrayLike, NDArray

from mechproof.kernel_support.arrays import as_floats as _as_floats
from mechproof.kernel_support.blocks import in_blocks as _in_blocks
from mechproof.kernel_support.domains import (
    is_finite as _is_finite,
    is_positive as _is_positive,
    nan_outside as _nan_outside,
)
from mechproof.kernel_support.functions import floor as _floor, square as _square

__all__ = [
    "chord_height_handbook",
    "constant_chord_handbook",
    "height_change_distances",
    "height_change_first_order",
    "thickness_change_by_height",
    "thickness_change_chords",
    "thickness_change_first_order",
    "thickness_change_half_angle",
    "thickness_change_linear_printed",
    "thickness_error_printed",
]


def __dir__() -> list[str]:
    return __all__


# Source: paper on tooth thickness, design data; basic rack
# Expressions sha256: 936559349d97f637613058013326cf4733d1ab39c945855d9286c8dcba8e8360
# Form: 1.387 m
# Operations: 4
def constant_chord_handbook(
    m: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `constant_chord` by another form: 1.387 m.

        constant_chord_handbook = 1387*m/1000

    Printed for a profile angle of 20 deg, rounded; wrong for every other.

    Same domain as `constant_chord`.

    """
    m, alpha = _as_floats("m alpha", m, alpha)
    m, alpha = _nan_outside(_check_of_constant_chord_handbook, m, alpha)
    return _in_blocks(_form_of_constant_chord_handbook, (m,), parameters=(alpha,), out=out)


def _check_of_constant_chord_handbook(m: Any, alpha: Any) -> tuple[Any, ...]:
    return (alpha > 0.0, alpha < _np.pi / 4.0, _is_positive(m))


def _form_of_constant_chord_handbook(m: Any, alpha: Any) -> Any:
    return 1387.0 / 1000.0 * m + 0.0 * alpha


# Source: paper on tooth thickness, design data; basic rack
# Expressions sha256: 9aa095afe556f0963b5fd0dd3541ab74a579e98b61b8d824f50481a44e8db02e
# Form: 0.7476 m
# Operations: 4
def chord_height_handbook(
    m: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `chord_height` by another form: 0.7476 m.

        chord_height_handbook = 1869*m/2500

    Printed for a profile angle of 20 deg, rounded; wrong for every other.

    Same domain as `chord_height`.

    """
    m, alpha = _as_floats("m alpha", m, alpha)
    m, alpha = _nan_outside(_check_of_constant_chord_handbook, m, alpha)
    return _in_blocks(_form_of_chord_height_handbook, (m,), parameters=(alpha,), out=out)


def _form_of_chord_height_handbook(m: Any, alpha: Any) -> Any:
    return 1869.0 / 2500.0 * m + 0.0 * alpha


# Source: paper on tooth thickness, step 6, on the involute
# Expressions sha256: 07a08b312a7bf4029f4e3feb5e834e01ae835d761083559c9af682a533ad37ce
# Form: difference of two distances
# Operations: 20
def height_change_distances(
    tilt: ArrayLike,
    m: ArrayLike,
    z: ArrayLike,
    alpha: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute `height_change` by another form: difference of two distances.

        height_change_distances = r_b*((pi/(2*z) + tan(alpha))*sin(alpha) + cos(alpha) - (tilt +
            pi/(2*z) + tan(alpha))*sin(alpha + tilt) - cos(alpha + tilt))
        r_b = m*z*cos(alpha)/2

    Same domain as `height_change`.

    """
    tilt, m, z, alpha = _as_floats("tilt m z alpha", tilt, m, z, alpha)
    m, z, alpha = _nan_outside(_check_of_height_change_distances, m, z, alpha)
    return _in_blocks(
        _form_of_height_change_distances,
        (tilt,),
        _prepare_of_height_change_distances,
        (m, z, alpha),
        out=out,
    )


def _check_of_height_change_distances(m: Any, z: Any, alpha: Any) -> tuple[Any, ...]:
    return (
        _is_positive(m),
        z >= 1.0,
        _is_finite(z),
        z == _floor(z),
        alpha > 0.0,
        alpha < _np.pi / 4.0,
    )


def _prepare_of_height_change_distances(m: Any, z: Any, alpha: Any) -> tuple[Any, ...]:
    cos_alpha = _np.cos(alpha)
    r_b = cos_alpha * m * z / 2.0
    tan_alpha = _np.tan(alpha)
    term = _np.pi / (2.0 * z)

    return (alpha, cos_alpha, r_b, tan_alpha, term)


def _form_of_height_change_distances(
    tilt: Any, alpha: Any, cos_alpha: Any, r_b: Any, tan_alpha: Any, term: Any
) -> Any:
    alpha_plus_tilt = alpha + tilt

    return r_b * (
        cos_alpha
        + (tan_alpha + term) * _np.sin(alpha)
        - (tan_alpha + term + tilt) * _np.sin(alpha_plus_tilt)
        - _np.cos(alpha_plus_tilt)
    )


# Source: paper on tooth thickness, step 6, on the involute
# Expressions sha256: 7b3dc25e57e1b23853bdb792fd200fc8e80665c0f2606089a3cc7d6906d4a4ea
# Form: first order in the tilt
# Operations: 12
def height_change_first_order(
    tilt: ArrayLike,
    m: ArrayLike,
    z: ArrayLike,
    alpha: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute `height_change` by another form: first order in the tilt.

        height_change_first_order = -r_b*t_c*tilt*cos(alpha)
        r_b = m*z*cos(alpha)/2
        t_c = pi/(2*z) + tan(alpha)

    Taylor's remainder with |sin|, |cos| <= 1.

    Approximation, first order in the tilt: |result - exact| <= m*tilt**2*(pi/2 + z*(2 +
    |tilt|))/4, apart from rounding.

    Same domain as `height_change`.

    """
    tilt, m, z, alpha = _as_floats("tilt m z alpha", tilt, m, z, alpha)
    m, z, alpha = _nan_outside(_check_of_height_change_distances, m, z, alpha)
    return _in_blocks(
        _form_of_height_change_first_order,
        (tilt,),
        _prepare_of_height_change_first_order,
        (m, z, alpha),
        out=out,
    )


def _prepare_of_height_change_first_order(m: Any, z: Any, alpha: Any) -> tuple[Any, ...]:
    cos_alpha = _np.cos(alpha)
    r_b = cos_alpha * m * z / 2.0
    t_c = _np.pi / (2.0 * z) + _np.tan(alpha)

    return (cos_alpha, r_b, t_c)


def _form_of_height_change_first_order(tilt: Any, cos_alpha: Any, r_b: Any, t_c: Any) -> Any:
    return -cos_alpha * r_b * t_c * tilt


# Source: paper on tooth thickness, step 6, on the involute
# Expressions sha256: 645b4665aa21ff3138a9d59e56f6ecb8e36dc1aa6cf3addbe40a7dd391256f7c
# Form: difference of two chords
# Operations: 21
def thickness_change_chords(
    tilt: ArrayLike,
    m: ArrayLike,
    z: ArrayLike,
    alpha: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute `thickness_change` by another form: difference of two chords.

        thickness_change_chords = 2*r_b*((tilt + pi/(2*z) + tan(alpha))*cos(alpha + tilt) +
            sin(alpha) - (pi/(2*z) + tan(alpha))*cos(alpha) - sin(alpha + tilt))
        r_b = m*z*cos(alpha)/2

    Same domain as `thickness_change`.

    """
    tilt, m, z, alpha = _as_floats("tilt m z alpha", tilt, m, z, alpha)
    m, z, alpha = _nan_outside(_check_of_height_change_distances, m, z, alpha)
    return _in_blocks(
        _form_of_thickness_change_chords,
        (tilt,),
        _prepare_of_height_change_distances,
        (m, z, alpha),
        out=out,
    )


def _form_of_thickness_change_chords(
    tilt: Any, alpha: Any, cos_alpha: Any, r_b: Any, tan_alpha: Any, term: Any
) -> Any:
    alpha_plus_tilt = alpha + tilt

    return (
        2.0
        * r_b
        * (
            (tan_alpha + term + tilt) * _np.cos(alpha_plus_tilt)
            + _np.sin(alpha)
            - cos_alpha * (tan_alpha + term)
            - _np.sin(alpha_plus_tilt)
        )
    )


# Source: paper on tooth thickness, step 6, on the involute
# Expressions sha256: 9eb995e4abcb59db862d2502633baf265a70c1d3ae4f929d288b8f919a5dd67b
# Form: half angles, by hand
# Operations: 28
def thickness_change_half_angle(
    tilt: ArrayLike,
    m: ArrayLike,
    z: ArrayLike,
    alpha: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute `thickness_change` by another form: half angles, by hand.

        thickness_change_half_angle = -2*r_b*(((t_c + tilt)*sin(tilt) -
            2*sin(tilt/2)**2)*sin(alpha) + (2*t_c*sin(tilt/2)**2 + sin(tilt) -
            tilt*cos(tilt))*cos(alpha))
        r_b = m*z*cos(alpha)/2
        t_c = pi/(2*z) + tan(alpha)

    Same domain as `thickness_change`.

    """
    tilt, m, z, alpha = _as_floats("tilt m z alpha", tilt, m, z, alpha)
    m, z, alpha = _nan_outside(_check_of_height_change_distances, m, z, alpha)
    return _in_blocks(
        _form_of_thickness_change_half_angle,
        (tilt,),
        _prepare_of_thickness_change_half_angle,
        (m, z, alpha),
        out=out,
    )


def _prepare_of_thickness_change_half_angle(m: Any, z: Any, alpha: Any) -> tuple[Any, ...]:
    cos_alpha = _np.cos(alpha)
    r_b = cos_alpha * m * z / 2.0
    t_c = _np.pi / (2.0 * z) + _np.tan(alpha)

    return (alpha, cos_alpha, r_b, t_c)


def _form_of_thickness_change_half_angle(
    tilt: Any, alpha: Any, cos_alpha: Any, r_b: Any, t_c: Any
) -> Any:
    sin_tilt = _np.sin(tilt)
    sin__tilt_squared = _square(_np.sin(tilt / 2.0))

    return (
        -2.0
        * r_b
        * (
            cos_alpha * (sin_tilt + 2.0 * t_c * sin__tilt_squared - tilt * _np.cos(tilt))
            + _np.sin(alpha) * (sin_tilt * (t_c + tilt) - 2.0 * sin__tilt_squared)
        )
    )


# Source: paper on tooth thickness, step 6, on the involute
# Expressions sha256: f6e7827b3cd7f8409b755701da7050002a85dc435d104c421c7cc7245f78395b
# Form: first order in the tilt
# Operations: 13
def thickness_change_first_order(
    tilt: ArrayLike,
    m: ArrayLike,
    z: ArrayLike,
    alpha: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute `thickness_change` by another form: first order in the tilt.

        thickness_change_first_order = -2*r_b*t_c*tilt*sin(alpha)
        r_b = m*z*cos(alpha)/2
        t_c = pi/(2*z) + tan(alpha)

    Taylor's remainder with |sin|, |cos| <= 1.

    Approximation, first order in the tilt: |result - exact| <= m*tilt**2*(pi/2 + z*(2 +
    |tilt|))/2, apart from rounding.

    Same domain as `thickness_change`.

    """
    tilt, m, z, alpha = _as_floats("tilt m z alpha", tilt, m, z, alpha)
    m, z, alpha = _nan_outside(_check_of_height_change_distances, m, z, alpha)
    return _in_blocks(
        _form_of_thickness_change_first_order,
        (tilt,),
        _prepare_of_thickness_change_first_order,
        (m, z, alpha),
        out=out,
    )


def _prepare_of_thickness_change_first_order(m: Any, z: Any, alpha: Any) -> tuple[Any, ...]:
    r_b = m * z * _np.cos(alpha) / 2.0
    t_c = _np.pi / (2.0 * z) + _np.tan(alpha)

    return (alpha, r_b, t_c)


def _form_of_thickness_change_first_order(tilt: Any, alpha: Any, r_b: Any, t_c: Any) -> Any:
    return -2.0 * r_b * t_c * _np.sin(alpha) * tilt


# Source: paper on tooth thickness, step 6, on the involute
# Expressions sha256: 0f015fdc2e6691340e3fcaf364b51793c366e972506e918da5e2f98cc6e425dd
# Form: 2 tan(alpha) times the height
# Rewrites: cosine_minus_one
# Operations: 33
def thickness_change_by_height(
    tilt: ArrayLike,
    m: ArrayLike,
    z: ArrayLike,
    alpha: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute `thickness_change` by another form: 2 tan(alpha) times the height.

        thickness_change_by_height = K_m*r_b*((t_c*(1 - cos(tilt)) + sin(tilt) -
            tilt*cos(tilt))*sin(alpha) - ((t_c + tilt)*sin(tilt) + cos(tilt) - 1)*cos(alpha))
        r_b = m*z*cos(alpha)/2
        t_c = pi/(2*z) + tan(alpha)
        K_m = 2*tan(alpha)

    The derivative of what is missing is proved; |sin(tilt)| <= |tilt|, integrated.

    Approximation, 2 tan(alpha) times the height: |result - exact| <= m*tilt**2*(pi/4 + z/2 +
    z*|tilt|/3), apart from rounding.

    Same domain as `thickness_change`.

    Source: paper on tooth thickness, step 6 with the exact derivative.

    """
    tilt, m, z, alpha = _as_floats("tilt m z alpha", tilt, m, z, alpha)
    m, z, alpha = _nan_outside(_check_of_height_change_distances, m, z, alpha)
    return _in_blocks(
        _form_of_thickness_change_by_height,
        (tilt,),
        _prepare_of_thickness_change_by_height,
        (m, z, alpha),
        out=out,
    )


def _prepare_of_thickness_change_by_height(m: Any, z: Any, alpha: Any) -> tuple[Any, ...]:
    tan_alpha = _np.tan(alpha)
    K_m = 2.0 * tan_alpha
    cosm1_alpha = -2.0 * _square(_np.sin(alpha / 2.0))
    cos_alpha = 1.0 + cosm1_alpha
    r_b = cos_alpha * m * z / 2.0
    t_c = tan_alpha + _np.pi / (2.0 * z)

    return (alpha, K_m, cos_alpha, r_b, t_c)


def _form_of_thickness_change_by_height(
    tilt: Any, alpha: Any, K_m: Any, cos_alpha: Any, r_b: Any, t_c: Any
) -> Any:
    sin_tilt = _np.sin(tilt)
    cosm1_tilt = -2.0 * _square(_np.sin(tilt / 2.0))
    cos_tilt = 1.0 + cosm1_tilt

    return (
        K_m
        * r_b
        * (
            _np.sin(alpha) * (sin_tilt - cos_tilt * tilt - t_c * cosm1_tilt)
            - cos_alpha * (cosm1_tilt + t_c * sin_tilt + sin_tilt * tilt)
        )
    )


# Source: paper on tooth thickness, equation (1) with the exact derivative
# Expressions sha256: c6bf7d9c9801d9c2bf7dcf2237ba44f443da441a7ff882c77f3bd2dafbad29b6
# Form: printed (1)
# Operations: 4
def thickness_change_linear_printed(
    dh: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `thickness_change_linear` by another form: printed (1).

        thickness_change_linear_printed = 1821*dh/2500

    Judged, as (1), to a hundredth of Delta_h; 2*tan(20 deg) = 0.7279, and it is not meant for
    other angles.

    Same domain as `thickness_change_linear`.

    Source: paper on tooth thickness, equation (1).

    """
    dh, alpha = _as_floats("dh alpha", dh, alpha)
    (alpha,) = _nan_outside(_check_of_thickness_change_linear_printed, alpha)
    return _in_blocks(_form_of_thickness_change_linear_printed, (dh,), parameters=(alpha,), out=out)


def _check_of_thickness_change_linear_printed(alpha: Any) -> tuple[Any, ...]:
    return (alpha > 0.0, alpha < _np.pi / 4.0)


def _form_of_thickness_change_linear_printed(dh: Any, alpha: Any) -> Any:
    return 1821.0 / 2500.0 * dh + 0.0 * alpha


# Source: paper on tooth thickness, steps 5 and 6 corrected
# Expressions sha256: 19eb798a2a68c48d5faaa67c3436f930da25074eb99d5da78c5ee0c6d011dd37
# Form: printed (1), steps 5 and 6
# Operations: 7
def thickness_error_printed(
    e_tip: ArrayLike, height_error: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `thickness_error` by another form: printed (1), steps 5 and 6.

        thickness_error_printed = 1821*height_error/2500 + 1821*e_tip/2500

    Takes the diameter for the radius and, as no sign is printed, the tip's part with the sign
    of the gauge's; 0.7284 approximates 2*tan(20 deg) = 0.7279.

    Same domain as `thickness_error`.

    Source: paper on tooth thickness, equation (1) and step 5.

    """
    e_tip, height_error, alpha = _as_floats("e_tip height_error alpha", e_tip, height_error, alpha)
    (alpha,) = _nan_outside(_check_of_thickness_change_linear_printed, alpha)
    return _in_blocks(
        _form_of_thickness_error_printed, (e_tip,), parameters=(height_error, alpha), out=out
    )


def _form_of_thickness_error_printed(e_tip: Any, height_error: Any, alpha: Any) -> Any:
    return 1821.0 * height_error / 2500.0 + 1821.0 / 2500.0 * e_tip + 0.0 * alpha
