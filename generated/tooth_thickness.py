"""Kernels of the system `tooth_thickness`.

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

Accuracy is tested: on the stated arguments no search has found a larger error. It is that
of float64, in which float32 is computed, too; eps = 2**-52.

A proved bound holds for all arguments stated in its line, in float64 rounded to nearest, on
the assumptions of that line. These speak of the results of all intermediate operations; the
normal range is 0 and everything of at least 2**-1022 in size. A proved bound may be larger
than a tested one, since a proof adds up roundings that may never occur together.

What errors are relative to:

    the way that the chord's end rolls (height_change) = r_b*(1 + t_c + |tilt|)*|tilt|

    the way that the chord's end rolls (thickness_change) = r_b*(1 + t_c + |tilt|)*|tilt|

    the value times what its root's difference loses (linearisation_bound) = value*(1 +
        r_b**2*t_c**2/radicand)
    value = dh**2*(y_c + |dh|)**3/(r_b**3*sqrt(r_b**2*t_c**2 - (2*y_c - |dh|)*|dh|))
    radicand = r_b**2*t_c**2 - (2*y_c - |dh|)*|dh|

    the sum of its terms' sizes (thickness_error) = 2*(|height_error| +
        |e_tip|/2)*tan(alpha)

Generated from the derivation tooth_thickness with SymPy 1.14.0.
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
    is_finite as _is_finite,
    is_positive as _is_positive,
    nan_outside as _nan_outside,
)
from mechproof.kernel_support.facts import Condition as _Condition, Sizes as _Sizes
from mechproof.kernel_support.functions import floor as _floor, square as _square

__all__ = [
    "chord_height",
    "constant_chord",
    "height_change",
    "linearisation_bound",
    "thickness_change",
    "thickness_change_linear",
    "thickness_error",
]

DOMAIN = (
    _Condition(
        "m",
        "0 < m < oo",
        ("m",),
        lambda m: (m > 0) & _is_finite(m),
        (
            "constant_chord",
            "chord_height",
            "height_change",
            "thickness_change",
            "linearisation_bound",
        ),
    ),
    _Condition(
        "alpha",
        "0 < alpha < pi/4",
        ("alpha",),
        lambda alpha: (alpha > 0) & (alpha < _np.pi / 4),
        (
            "constant_chord",
            "chord_height",
            "height_change",
            "thickness_change",
            "thickness_change_linear",
            "linearisation_bound",
            "thickness_error",
        ),
    ),
    _Condition(
        "z",
        "1 <= z < oo, z = floor(z)",
        ("z",),
        lambda z: (z >= 1) & _is_finite(z) & (z == _floor(z)),
        ("height_change", "thickness_change", "linearisation_bound"),
    ),
)
PUBLISHED = (
    _Sizes("the design data", {"m": 3.0, "z": 50.0, "alpha": 0.3490658503988659}, ("fitted",)),
)


def __dir__() -> list[str]:
    return __all__


# Source: paper on tooth thickness, design data; basic rack
# Expressions sha256: 5d996c2779e83934afc76123a3e0219c20e257c52378d201fe729022e5169307
# Form: squared cosine
# Operations: 5
def constant_chord(m: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the constant chord, between the points where a rack touches both flanks.

        constant_chord = pi*m*cos(alpha)**2/2

    Parameters
    ----------
    m : array_like, any shape
        Module (mm).
    alpha : array_like, any shape
        Profile angle of the basic rack (rad).

    Returns
    -------
    ndarray or NumPy scalar (mm)

    Notes
    -----
    Domain: 0 < m < oo, 0 < alpha < pi/4.

    Accuracy, tested: 4 eps of the value.

    Proved, where alpha <= 11/14, as long as no result overflows or falls below the normal
    range: at most 3.5 eps with np.cos within 1 ulp, found 2.17; at most 3.17 eps compiled,
    found 2.43.

    Source: paper on tooth thickness, design data; basic rack.

    """
    m, alpha = _as_floats("m alpha", m, alpha)
    m, alpha = _nan_outside(_check_of_constant_chord, m, alpha)
    return _in_blocks(_form_of_constant_chord, (m,), parameters=(alpha,), out=out)


def _check_of_constant_chord(m: Any, alpha: Any) -> tuple[Any, ...]:
    return (alpha > 0.0, alpha < _np.pi / 4.0, _is_positive(m))


def _form_of_constant_chord(m: Any, alpha: Any) -> Any:
    return _np.pi * _square(_np.cos(alpha)) / 2.0 * m


# Source: paper on tooth thickness, design data; basic rack
# Expressions sha256: f8f91713908b5993bfecfa6f8a6fc972cf2f76ab05b5a5130600e5d546eb0c96
# Form: double angle
# Operations: 6
def chord_height(m: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the height from the tip circle to the constant chord, addendum of one module.

        chord_height = m*(1 - pi*sin(2*alpha)/8)

    Parameters
    ----------
    m : array_like, any shape
        Module (mm).
    alpha : array_like, any shape
        Profile angle of the basic rack (rad).

    Returns
    -------
    ndarray or NumPy scalar (mm)

    Notes
    -----
    Domain: 0 < m < oo, 0 < alpha < pi/4.

    Accuracy, tested: 3 eps of the value.

    Proved, where alpha <= 11/14, as long as no result overflows or falls below the normal
    range: at most 1.88 eps with np.sin within 1 ulp, found 1.39; at most 1.56 eps compiled,
    found 1.38.

    Source: paper on tooth thickness, design data; basic rack.

    """
    m, alpha = _as_floats("m alpha", m, alpha)
    m, alpha = _nan_outside(_check_of_constant_chord, m, alpha)
    return _in_blocks(_form_of_chord_height, (m,), parameters=(alpha,), out=out)


def _form_of_chord_height(m: Any, alpha: Any) -> Any:
    return (1.0 - _np.pi * _np.sin(2.0 * alpha) / 8.0) * m


# Source: paper on tooth thickness, step 6, on the involute
# Expressions sha256: 2325d90ada9cba6380f6debf5c328e39ba65c362b92d738d17706408d55e0ac7
# Form: along and across the first tangent
# Rewrites: cosine_minus_one
# Operations: 31
def height_change(
    tilt: ArrayLike,
    m: ArrayLike,
    z: ArrayLike,
    alpha: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute how much deeper than the constant chord the chord lies, by its flank's tangent.

        height_change = r_b*((t_c*(1 - cos(tilt)) + sin(tilt) - tilt*cos(tilt))*sin(alpha) -
            ((t_c + tilt)*sin(tilt) + cos(tilt) - 1)*cos(alpha))
        r_b = m*z*cos(alpha)/2
        t_c = pi/(2*z) + tan(alpha)

    Parameters
    ----------
    tilt : array_like, any shape
        Angle of the flank's tangent with its tangent at the constant chord (rad).
    m : array_like, any shape
        Module (mm).
    z : array_like, any shape
        Number of teeth, a natural number (pure number).
    alpha : array_like, any shape
        Profile angle of the basic rack (rad).

    Returns
    -------
    ndarray or NumPy scalar (mm)

    Notes
    -----
    Domain: 0 < m < oo, 1 <= z < oo, z = floor(z), 0 < alpha < pi/4.

    Accuracy, tested: 15 eps of the way that the chord's end rolls, where (tilt = 0 or 1e-250 <=
    |tilt|) and 1e-30 <= m and m*z <= 1e300.

    Proved, where |tilt| <= 1 and alpha <= 11/14, as long as no result overflows or falls below
    the normal range: at most 4.34 eps with np.sin within 1 ulp and np.tan within 1 ulp, found
    2.96; at most 4.06 eps compiled, found 3.06.

    Source: paper on tooth thickness, step 6, on the involute.

    """
    tilt, m, z, alpha = _as_floats("tilt m z alpha", tilt, m, z, alpha)
    m, z, alpha = _nan_outside(_check_of_height_change, m, z, alpha)
    return _in_blocks(
        _form_of_height_change, (tilt,), _prepare_of_height_change, (m, z, alpha), out=out
    )


def _check_of_height_change(m: Any, z: Any, alpha: Any) -> tuple[Any, ...]:
    return (
        _is_positive(m),
        z >= 1.0,
        _is_finite(z),
        z == _floor(z),
        alpha > 0.0,
        alpha < _np.pi / 4.0,
    )


def _prepare_of_height_change(m: Any, z: Any, alpha: Any) -> tuple[Any, ...]:
    cosm1_alpha = -2.0 * _square(_np.sin(alpha / 2.0))
    cos_alpha = 1.0 + cosm1_alpha
    r_b = cos_alpha * m * z / 2.0
    t_c = _np.pi / (2.0 * z) + _np.tan(alpha)

    return (alpha, cos_alpha, r_b, t_c)


def _form_of_height_change(tilt: Any, alpha: Any, cos_alpha: Any, r_b: Any, t_c: Any) -> Any:
    sin_tilt = _np.sin(tilt)
    cosm1_tilt = -2.0 * _square(_np.sin(tilt / 2.0))
    cos_tilt = 1.0 + cosm1_tilt

    return r_b * (
        _np.sin(alpha) * (sin_tilt - cos_tilt * tilt - t_c * cosm1_tilt)
        - cos_alpha * (cosm1_tilt + t_c * sin_tilt + sin_tilt * tilt)
    )


# Source: paper on tooth thickness, step 6, on the involute
# Expressions sha256: 40aa37f62df7174f3fec7d7a1d7e0746887b0997013ef91bf0add5b322763faf
# Form: along and across the first tangent
# Rewrites: cosine_minus_one
# Operations: 32
def thickness_change(
    tilt: ArrayLike,
    m: ArrayLike,
    z: ArrayLike,
    alpha: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute how much thicker than the constant chord the chord is, by its flank's tangent.

        thickness_change = -2*r_b*((t_c*(1 - cos(tilt)) + sin(tilt) - tilt*cos(tilt))*cos(alpha)
            + ((t_c + tilt)*sin(tilt) + cos(tilt) - 1)*sin(alpha))
        r_b = m*z*cos(alpha)/2
        t_c = pi/(2*z) + tan(alpha)

    Parameters
    ----------
    tilt : array_like, any shape
        Angle of the flank's tangent with its tangent at the constant chord (rad).
    m : array_like, any shape
        Module (mm).
    z : array_like, any shape
        Number of teeth, a natural number (pure number).
    alpha : array_like, any shape
        Profile angle of the basic rack (rad).

    Returns
    -------
    ndarray or NumPy scalar (mm)

    Notes
    -----
    Domain: 0 < m < oo, 1 <= z < oo, z = floor(z), 0 < alpha < pi/4.

    Accuracy, tested: 29 eps of the way that the chord's end rolls, where (tilt = 0 or 1e-250 <=
    |tilt|) and 1e-30 <= m and m*z <= 1e300.

    Proved, where |tilt| <= 1 and alpha <= 11/14, as long as no result overflows or falls below
    the normal range: at most 9.44 eps with np.sin within 1 ulp and np.tan within 1 ulp, found
    5.28; at most 9.56 eps compiled, found 5.81.

    Source: paper on tooth thickness, step 6, on the involute.

    """
    tilt, m, z, alpha = _as_floats("tilt m z alpha", tilt, m, z, alpha)
    m, z, alpha = _nan_outside(_check_of_height_change, m, z, alpha)
    return _in_blocks(
        _form_of_thickness_change, (tilt,), _prepare_of_height_change, (m, z, alpha), out=out
    )


def _form_of_thickness_change(tilt: Any, alpha: Any, cos_alpha: Any, r_b: Any, t_c: Any) -> Any:
    sin_tilt = _np.sin(tilt)
    cosm1_tilt = -2.0 * _square(_np.sin(tilt / 2.0))
    cos_tilt = 1.0 + cosm1_tilt

    return (
        -2.0
        * r_b
        * (
            cos_alpha * (sin_tilt - cos_tilt * tilt - t_c * cosm1_tilt)
            + _np.sin(alpha) * (cosm1_tilt + t_c * sin_tilt + sin_tilt * tilt)
        )
    )


# Source: paper on tooth thickness, equation (1) with the exact derivative
# Expressions sha256: 1b9034ac283745b8bec789db96d14e2ce3e3cdcb93362b3244f909fdf955e873
# Form: tangent
# Operations: 3
def thickness_change_linear(
    dh: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the change of thickness with the height to first order, on the rack exactly.

        thickness_change_linear = 2*dh*tan(alpha)

    Parameters
    ----------
    dh : array_like, any shape
        How much deeper than nominal the chord lies (mm).
    alpha : array_like, any shape
        Profile angle of the basic rack (rad).

    Returns
    -------
    ndarray or NumPy scalar (mm)

    Notes
    -----
    Domain: 0 < alpha < pi/4.

    Accuracy, tested: 5 eps of the value.

    Proved, where alpha <= 11/14, as long as no result overflows or falls below the normal
    range: at most 1.51 eps with np.tan within 1 ulp, found 1.02; at most 2.77 eps compiled,
    found 1.81.

    Source: paper on tooth thickness, equation (1) with the exact derivative.

    """
    dh, alpha = _as_floats("dh alpha", dh, alpha)
    (alpha,) = _nan_outside(_check_of_thickness_change_linear, alpha)
    return _in_blocks(_form_of_thickness_change_linear, (dh,), parameters=(alpha,), out=out)


def _check_of_thickness_change_linear(alpha: Any) -> tuple[Any, ...]:
    return (alpha > 0.0, alpha < _np.pi / 4.0)


def _form_of_thickness_change_linear(dh: Any, alpha: Any) -> Any:
    return 2.0 * _np.tan(alpha) * dh


# Source: paper on tooth thickness, step 6, second derivative on the involute
# Expressions sha256: 814d3d5a41c96e32619a3563588ae0542a4654f8dd46e457b4d20e5f6f26e9db
# Form: Taylor's remainder
# Operations: 33
def linearisation_bound(
    dh: ArrayLike, m: ArrayLike, z: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Bound the excess of the first order over the exact change of thickness; it is >= 0.

        linearisation_bound = dh**2*(y_c + |dh|)**3/(r_b**3*sqrt(r_b**2*t_c**2 - (2*y_c -
            |dh|)*|dh|))
        r_b = m*z*cos(alpha)/2
        t_c = pi/(2*z) + tan(alpha)
        y_c = m*(z/2 + pi*sin(2*alpha)/8)

    Parameters
    ----------
    dh : array_like, any shape
        How much deeper than nominal the chord lies (mm).
    m : array_like, any shape
        Module (mm).
    z : array_like, any shape
        Number of teeth, a natural number (pure number).
    alpha : array_like, any shape
        Profile angle of the basic rack (rad).

    Returns
    -------
    ndarray or NumPy scalar (mm)

    Notes
    -----
    Domain: 0 < m < oo, 1 <= z < oo, z = floor(z), 0 < alpha < pi/4 (the chord lies no deeper
    than the base circle and no higher than the tip).

    Accuracy, tested: 32 eps of the value times what its root's difference loses, where (dh = 0
    or 1e-100 <= |dh|) and 1e-30 <= m and m*z <= 1e50.

    Proved, where 1/4 <= alpha <= 11/14 and |dh| <= 3/16*m, as long as no result overflows or
    falls below the normal range: at most 13 eps with np.cos within 1 ulp and np.sin within 1
    ulp and np.tan within 1 ulp, found 5.64; at most 13 eps compiled, found 5.1.

    Source: paper on tooth thickness, step 6, second derivative on the involute.

    """
    dh, m, z, alpha = _as_floats("dh m z alpha", dh, m, z, alpha)
    m, z, alpha = _nan_outside(_check_of_height_change, m, z, alpha)
    return _in_blocks(
        _form_of_linearisation_bound,
        (dh,),
        _prepare_of_linearisation_bound,
        (m, z, alpha),
        out=out,
        quiet=True,
    )


def _prepare_of_linearisation_bound(m: Any, z: Any, alpha: Any) -> tuple[Any, ...]:
    r_b = m * z * _np.cos(alpha) / 2.0
    y_c = m * (z / 2.0 + _np.pi * _np.sin(2.0 * alpha) / 8.0)
    t_c = _np.pi / (2.0 * z) + _np.tan(alpha)

    return (r_b, y_c, t_c)


def _form_of_linearisation_bound(dh: Any, r_b: Any, y_c: Any, t_c: Any) -> Any:
    abs_Delta_h = _abs(dh)
    abs_Delta_h_plus_y_c = abs_Delta_h + y_c

    return (
        _square(dh)
        * (abs_Delta_h_plus_y_c * _square(abs_Delta_h_plus_y_c))
        / (
            r_b
            * _square(r_b)
            * _np.sqrt(_square(r_b) * _square(t_c) - abs_Delta_h * (2.0 * y_c - abs_Delta_h))
        )
    )


# Source: paper on tooth thickness, steps 5 and 6 corrected
# Expressions sha256: 9257170e7d0d391e452d5a1b7f2f2a85cba896431295e9f9ae55f06cddeba413
# Form: tangent
# Operations: 5
def thickness_error(
    e_tip: ArrayLike, height_error: ArrayLike, alpha: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the error of thickness from the tip diameter and the gauge's height.

        thickness_error = 2*(height_error - e_tip/2)*tan(alpha)

    Parameters
    ----------
    e_tip : array_like, any shape
        Deviation of the tip diameter (mm).
    height_error : array_like, any shape
        Error of the gauge's height, positive if set too deep (mm).
    alpha : array_like, any shape
        Profile angle of the basic rack (rad).

    Returns
    -------
    ndarray or NumPy scalar (mm)

    Notes
    -----
    Domain: 0 < alpha < pi/4.

    Accuracy, tested: 6 eps of the sum of its terms' sizes.

    Proved, where alpha <= 11/14, as long as no result overflows or falls below the normal
    range: at most 2.01 eps with np.tan within 1 ulp, found 1.52; at most 3.28 eps compiled,
    found 2.31.

    Source: paper on tooth thickness, steps 5 and 6 corrected.

    """
    e_tip, height_error, alpha = _as_floats("e_tip height_error alpha", e_tip, height_error, alpha)
    (alpha,) = _nan_outside(_check_of_thickness_change_linear, alpha)
    return _in_blocks(_form_of_thickness_error, (e_tip,), parameters=(height_error, alpha), out=out)


def _form_of_thickness_error(e_tip: Any, height_error: Any, alpha: Any) -> Any:
    return 2.0 * _np.tan(alpha) * (height_error - e_tip / 2.0)
