"""Kernels of the system `wedge_linkage`.

Bazuev, Koksharov, Naichuk 2021, transfer function of a rod semi-automatic, doi
10.15593/2224-9982/2021.64.07

Displacements and rotations are counted from the position x1 = 0; angles from Ox, positive
counter-clockwise; x to the right, y upwards.

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

    |value| + sum of |p * d value/d p| over the arguments p (guide_radicand) = 2*l_BC**2 +
        2*l_AB*|x1| + 2*l_CD*|x1| + |x1*(2*l_AB + 2*l_CD + 2*x1)| + |l_BC**2 + x1*(2*l_AB +
        2*l_CD + x1)|

    |value| + sum of |p * d value/d p| over the arguments p (rod_displacement) =
        l_DE*|alpha_DE*(sin(alpha_DE) - sin(alpha_DE + phi3))| + l_DE*|phi3*sin(alpha_DE +
        phi3)| + l_DE*|cos(alpha_DE) - cos(alpha_DE + phi3)|

    |value| + sum of |p * d value/d p| over the arguments p (roller_offset) =
        l_KL*|cos(alpha_KL)| + |x5| + |l_KL*cos(alpha_KL) - x5|

    |value| + sum of |p * d value/d p| over the arguments p (wedge_displacement) =
        l_LM*|alpha_LM*(cos(alpha_LM) - cos(alpha_LM + phi7))| + l_LM*|phi7*cos(alpha_LM +
        phi7)| + l_LM*|sin(alpha_LM) - sin(alpha_LM + phi7)|

Symbols of the formulas:

    BC_length = sqrt(l_BC**2 + x1*(2*l_AB + 2*l_CD + x1))
    turn_3 = -2*atan(x1/(l_BC + sqrt(l_BC**2 + x1*(2*l_AB + 2*l_CD + x1))))
    travel_5 = l_DE*(cos(alpha_DE + turn_3) - cos(alpha_DE))
    driven_5 = Max(0, travel_5 - l_GH)
    KL_x = l_KL*cos(alpha_KL) - driven_5
    turn_7 = atan2(sqrt(l_KL**2 - KL_x**2), KL_x) - alpha_KL
    engaged = Piecewise((0, travel_5 < l_GH), (1, True))

Generated from the derivation wedge_linkage with SymPy 1.14.0.
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
from mechproof.kernel_support.facts import Condition as _Condition, Sizes as _Sizes
from mechproof.kernel_support.functions import (
    choose_where as _choose_where,
    maximum as _maximum,
    square as _square,
)

__all__ = [
    "clearance",
    "guide_radicand",
    "lever_angle",
    "position",
    "rod_displacement",
    "roller_lever_angle",
    "roller_offset",
    "sensitivities",
    "velocity",
    "wedge_displacement",
]

DOMAIN = (
    _Condition(
        "l_AB",
        "0 < l_AB < oo",
        ("l_AB",),
        lambda l_AB: (l_AB > 0) & _is_finite(l_AB),
        ("guide_radicand", "lever_angle", "position", "velocity", "sensitivities"),
    ),
    _Condition(
        "l_BC",
        "0 < l_BC < oo",
        ("l_BC",),
        lambda l_BC: (l_BC > 0) & _is_finite(l_BC),
        ("guide_radicand", "lever_angle", "position", "velocity", "sensitivities"),
    ),
    _Condition(
        "l_CD",
        "0 < l_CD < oo",
        ("l_CD",),
        lambda l_CD: (l_CD > 0) & _is_finite(l_CD),
        ("guide_radicand", "lever_angle", "position", "velocity", "sensitivities"),
    ),
    _Condition(
        "l_DE",
        "0 < l_DE < oo",
        ("l_DE",),
        lambda l_DE: (l_DE > 0) & _is_finite(l_DE),
        ("rod_displacement", "position", "velocity", "sensitivities"),
    ),
    _Condition(
        "l_GH",
        "0 < l_GH < oo",
        ("l_GH",),
        lambda l_GH: (l_GH > 0) & _is_finite(l_GH),
        ("clearance", "position", "velocity", "sensitivities"),
    ),
    _Condition(
        "l_KL",
        "0 < l_KL < oo",
        ("l_KL",),
        lambda l_KL: (l_KL > 0) & _is_finite(l_KL),
        ("roller_offset", "roller_lever_angle", "position", "velocity", "sensitivities"),
    ),
    _Condition(
        "alpha_KL",
        "0 < alpha_KL < pi",
        ("alpha_KL",),
        lambda alpha_KL: (alpha_KL > 0) & (alpha_KL < _np.pi),
        ("roller_offset", "roller_lever_angle", "position", "velocity", "sensitivities"),
    ),
    _Condition(
        "l_LM",
        "0 < l_LM < oo",
        ("l_LM",),
        lambda l_LM: (l_LM > 0) & _is_finite(l_LM),
        ("wedge_displacement", "position", "velocity", "sensitivities"),
    ),
)
PUBLISHED = (
    _Sizes(
        "the set reconstructed with l_BC = 49.75, l_CD = 38, l_DE = 83",
        {
            "l_AB": (6.25, 0.0, 0.0),
            "l_BC": (49.75, 1.22, -1.22),
            "l_CD": (38.0, 0.0, -2.06),
            "l_DE": (83.0, 0.92, -1.05),
            "l_GH": (2.0, 1.03, -0.72),
            "l_KL": (60.0, 0.2, -0.2),
            "l_LM": (145.0, 0.1, -0.1),
            "alpha_DE": (4.940328980695149, 0.010821041362364843, -0.019198621771937624),
            "alpha_KL": (1.1344640137963142, 0.004188790204786391, -0.004363323129985824),
            "alpha_LM": (2.155132560362598, 0.0, 0.0),
        },
        ("calibrated", "fitted", "uncertain"),
    ),
    _Sizes(
        "the set reconstructed with l_BC = 39.75, l_CD = 28, l_DE = 70.83",
        {
            "l_AB": (6.25, 0.0, 0.0),
            "l_BC": (39.75, 1.22, -1.22),
            "l_CD": (28.0, 1.19, -2.06),
            "l_DE": (70.83, 0.92, -1.05),
            "l_GH": (2.0, 1.03, -0.72),
            "l_KL": (60.0, 0.2, -0.2),
            "l_LM": (145.0, 0.1, -0.1),
            "alpha_DE": (4.940328980695149, 0.010821041362364843, -0.019198621771937624),
            "alpha_KL": (1.1344640137963142, 0.004188790204786391, -0.004363323129985824),
            "alpha_LM": (2.155132560362598, 0.0, 0.0),
        },
        ("calibrated", "fitted", "uncertain"),
    ),
)


def __dir__() -> list[str]:
    return __all__


# Source: Bazuev et al. 2021, equation (1)
# Expressions sha256: 31b22938b916ad3f6ccf72d90186f0f0769c635661f7a070f404cc3dd827ae07
# Form: product
# Operations: 7
def guide_radicand(
    x1: ArrayLike,
    l_AB: ArrayLike,
    l_BC: ArrayLike,
    l_CD: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute the radicand of Q, the square of BC: the guide follows where it is not negative.

        guide_radicand = l_BC**2 + x1*(2*l_AB + 2*l_CD + x1)

    Parameters
    ----------
    x1 : array_like, any shape
        Displacement of the pusher (mm).
    l_AB : array_like, any shape
        Length of AB, pusher to foot of the guide (mm).
    l_BC : array_like, any shape
        Length of BC at x1 = 0 (mm).
    l_CD : array_like, any shape
        Length of CD (mm).

    Returns
    -------
    ndarray or NumPy scalar (mm**2)

    Notes
    -----
    Domain: 0 < l_AB, l_BC, l_CD < oo.

    Accuracy, tested: 2.5 eps of |value| + sum of |p * d value/d p| over the arguments p, where
    (1e-50 <= |x1| <= 1e50 or x1 = 0) and 1e-50 <= l_AB, l_BC, l_CD <= 1e50.

    Proved, as long as no result overflows or falls below the normal range: at most 0.86 eps
    with NumPy's functions, found 0.83; at most 0.86 eps compiled, found 0.83.

    Source: Bazuev et al. 2021, equation (1).

    """
    x1, l_AB, l_BC, l_CD = _as_floats("x1 l_AB l_BC l_CD", x1, l_AB, l_BC, l_CD)
    l_AB, l_BC, l_CD = _nan_outside(_check_of_guide_radicand, l_AB, l_BC, l_CD)
    return _in_blocks(_form_of_guide_radicand, (x1,), parameters=(l_AB, l_BC, l_CD), out=out)


def _check_of_guide_radicand(l_AB: Any, l_BC: Any, l_CD: Any) -> tuple[Any, ...]:
    return (_is_positive(l_AB), _is_positive(l_BC), _is_positive(l_CD))


def _form_of_guide_radicand(x1: Any, l_AB: Any, l_BC: Any, l_CD: Any) -> Any:
    return _square(l_BC) + x1 * (2.0 * l_AB + 2.0 * l_CD + x1)


# Source: Bazuev et al. 2021, equation (1)
# Expressions sha256: 27235217bcc306856482c01aeca096e91f764b533e6c8b95cc82d10597dd8ff0
# Form: half-angle atan
# Operations: 11
def lever_angle(
    x1: ArrayLike,
    l_AB: ArrayLike,
    l_BC: ArrayLike,
    l_CD: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute the rotation phi3 of the lever.

        lever_angle = -2*atan(x1/(l_BC + sqrt(l_BC**2 + x1*(2*l_AB + 2*l_CD + x1))))

    Parameters
    ----------
    x1 : array_like, any shape
        Displacement of the pusher (mm).
    l_AB : array_like, any shape
        Length of AB, pusher to foot of the guide (mm).
    l_BC : array_like, any shape
        Length of BC at x1 = 0 (mm).
    l_CD : array_like, any shape
        Length of CD (mm).

    Returns
    -------
    ndarray or NumPy scalar (rad)

    Notes
    -----
    Domain: 0 < l_AB, l_BC, l_CD < oo (the guide follows the pusher).

    NaN where guide_radicand is negative.

    The conditioning |value| + sum of |p * d value/d p|: guide_condition of guide_square =
    guide_radicand.

    Lengths and displacements are squared: of sizes beyond 1e-50 to 1e50 squares may leave the
    range of doubles, and the result is NaN, 0 where it should not be, or another wrong number.

    Accuracy, tested: 8 eps of |value| + sum of |p * d value/d p| over the arguments p, where
    (1e-50 <= |x1| <= 1e50 or x1 = 0) and 1e-50 <= l_AB, l_BC, l_CD <= 1e50 and
    guide_condition/2**48 < guide_square.

    Proved, where x1 >= -l_BC*min(1, l_BC/(l_AB + l_CD))/4, as long as no result overflows or
    falls below the normal range: at most 2.46 eps with np.arctan within 1 ulp, found 1.42; at
    most 3.6 eps compiled, found 1.62.

    Source: Bazuev et al. 2021, equation (1).

    """
    x1, l_AB, l_BC, l_CD = _as_floats("x1 l_AB l_BC l_CD", x1, l_AB, l_BC, l_CD)
    l_AB, l_BC, l_CD = _nan_outside(_check_of_guide_radicand, l_AB, l_BC, l_CD)
    return _in_blocks(
        _form_of_lever_angle,
        (x1,),
        _prepare_of_lever_angle,
        (l_AB, l_BC, l_CD),
        out=out,
        quiet=True,
    )


def _prepare_of_lever_angle(l_AB: Any, l_BC: Any, l_CD: Any) -> tuple[Any, ...]:
    arm = l_AB + l_CD

    return (l_BC, arm)


def _form_of_lever_angle(x1: Any, l_BC: Any, arm: Any) -> Any:
    guide_length = _np.sqrt(_square(l_BC) + x1 * (2.0 * arm + x1))
    guide_sum = guide_length + l_BC

    return -2.0 * _np.arctan(x1 / guide_sum)


# Source: Bazuev et al. 2021, equation (3)
# Expressions sha256: 1ec3aa1fa41feaad5341e1f1800c06daca3988f50e50141ff1a51109f07f0e1b
# Form: product
# Operations: 8
def rod_displacement(
    phi3: ArrayLike, l_DE: ArrayLike, alpha_DE: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the displacement x5 of the rod.

        rod_displacement = l_DE*(cos(alpha_DE + phi3) - cos(alpha_DE))

    Parameters
    ----------
    phi3 : array_like, any shape
        Rotation of the lever (rad).
    l_DE : array_like, any shape
        Length of DE, arm of the lever (mm).
    alpha_DE : array_like, any shape
        Direction of DE at x1 = 0 (rad).

    Returns
    -------
    ndarray or NumPy scalar (mm)

    Notes
    -----
    Domain: 0 < l_DE < oo.

    Accuracy, tested: 4 eps of |value| + sum of |p * d value/d p| over the arguments p, where
    |phi3| <= pi and (phi3 = 0 or 1e-140 <= |phi3|) and 1e-10 <= l_DE <= 1e300.

    Proved, where |phi3| <= 22/7 and 1/8 <= alpha_DE <= 44/7, as long as no result overflows or
    falls below the normal range: at most 3.05 eps with np.sin within 1 ulp, found 1.37; at most
    2.5 eps compiled, found 1.4.

    Source: Bazuev et al. 2021, equation (3).

    """
    phi3, l_DE, alpha_DE = _as_floats("phi3 l_DE alpha_DE", phi3, l_DE, alpha_DE)
    (l_DE,) = _nan_outside(_check_of_rod_displacement, l_DE)
    return _in_blocks(_form_of_rod_displacement, (phi3,), parameters=(l_DE, alpha_DE), out=out)


def _check_of_rod_displacement(l_DE: Any) -> tuple[Any, ...]:
    return (_is_positive(l_DE),)


def _form_of_rod_displacement(phi3: Any, l_DE: Any, alpha_DE: Any) -> Any:
    return -2.0 * l_DE * _np.sin(phi3 / 2.0) * _np.sin(alpha_DE + phi3 / 2.0)


# Source: Bazuev et al. 2021, equation (4)
# Expressions sha256: 1bf73c4710c0ba7ef99998ca5abc5ff0c56cd2dd93acbf2a119b42d407d3c7e6
# Form: maximum
# Operations: 2
def clearance(x5: ArrayLike, l_GH: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the displacement x5' of the pushed link after the clearance.

        clearance = Max(0, x5 - l_GH)

    Parameters
    ----------
    x5 : array_like, any shape
        Displacement of the rod (mm).
    l_GH : array_like, any shape
        Clearance between the rod 5 and the link 5' (mm).

    Returns
    -------
    ndarray or NumPy scalar (mm)

    Notes
    -----
    Domain: 0 < l_GH < oo.

    Accuracy, tested: 0.5 eps of the value.

    Proved, as long as no result overflows or falls below the normal range: at most 0.51 eps
    with NumPy's functions, found 0.49; at most 0.51 eps compiled, found 0.49.

    Source: Bazuev et al. 2021, equation (4).

    """
    x5, l_GH = _as_floats("x5 l_GH", x5, l_GH)
    (l_GH,) = _nan_outside(_check_of_clearance, l_GH)
    return _in_blocks(_form_of_clearance, (x5,), parameters=(l_GH,), out=out)


def _check_of_clearance(l_GH: Any) -> tuple[Any, ...]:
    return (_is_positive(l_GH),)


def _form_of_clearance(x5: Any, l_GH: Any) -> Any:
    return _maximum(0.0, x5 - l_GH)


# Source: Bazuev et al. 2021, equations (7) and (8)
# Expressions sha256: 7a99ff4912deb887d2d3af1310d7613c3ce82dacb09a4962952ce3597403d443
# Form: difference
# Operations: 3
def roller_offset(
    x5: ArrayLike, l_KL: ArrayLike, alpha_KL: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute R, the projection of KL on Ox: the roller lever follows where |R| <= l_KL.

        roller_offset = l_KL*cos(alpha_KL) - x5

    Parameters
    ----------
    x5 : array_like, any shape
        Displacement of the link 5' after the clearance (mm).
    l_KL : array_like, any shape
        Length of KL, driven arm of the roller lever (mm).
    alpha_KL : array_like, any shape
        Direction of KL at x1 = 0, in (0, pi) (rad).

    Returns
    -------
    ndarray or NumPy scalar (mm)

    Notes
    -----
    Domain: 0 < l_KL < oo, 0 < alpha_KL < pi.

    Accuracy, tested: 1.5 eps of |value| + sum of |p * d value/d p| over the arguments p, where
    (1e-50 <= |x5| <= 1e50 or x5 = 0) and 1e-50 <= l_KL <= 1e50.

    Proved, where alpha_KL <= 22/7, as long as no result overflows or falls below the normal
    range: at most 1.51 eps with np.cos within 1 ulp, found 0.72; at most 2.06 eps compiled,
    found 0.96.

    Source: Bazuev et al. 2021, equations (7) and (8).

    """
    x5, l_KL, alpha_KL = _as_floats("x5 l_KL alpha_KL", x5, l_KL, alpha_KL)
    l_KL, alpha_KL = _nan_outside(_check_of_roller_offset, l_KL, alpha_KL)
    return _in_blocks(_form_of_roller_offset, (x5,), parameters=(l_KL, alpha_KL), out=out)


def _check_of_roller_offset(l_KL: Any, alpha_KL: Any) -> tuple[Any, ...]:
    return (_is_positive(l_KL), alpha_KL > 0.0, alpha_KL < _np.pi)


def _form_of_roller_offset(x5: Any, l_KL: Any, alpha_KL: Any) -> Any:
    return l_KL * _np.cos(alpha_KL) - x5


# Source: Bazuev et al. 2021, equations (7) and (8)
# Expressions sha256: cd704aa96a777112d9ba7deac4c586eb1c3403ed4c6333dd7baa5373bba38f80
# Form: half-angle atan
# Operations: 20
def roller_lever_angle(
    x5: ArrayLike, l_KL: ArrayLike, alpha_KL: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the rotation phi7 of the roller lever.

        roller_lever_angle = atan2(sqrt(l_KL**2 - (l_KL*cos(alpha_KL) - x5)**2),
            l_KL*cos(alpha_KL) - x5) - alpha_KL

    Parameters
    ----------
    x5 : array_like, any shape
        Displacement of the link 5' after the clearance (mm).
    l_KL : array_like, any shape
        Length of KL, driven arm of the roller lever (mm).
    alpha_KL : array_like, any shape
        Direction of KL at x1 = 0, in (0, pi) (rad).

    Returns
    -------
    ndarray or NumPy scalar (rad)

    Notes
    -----
    Domain: 0 < l_KL < oo, 0 < alpha_KL < pi (the roller lever follows the link 5').

    NaN where |roller_offset| > l_KL.

    The conditioning |value| + sum of |p * d value/d p|: height_condition of height_square =
    l_KL**2 - roller_offset**2.

    Lengths and displacements are squared: of sizes beyond 1e-50 to 1e50 squares may leave the
    range of doubles, and the result is NaN, 0 where it should not be, or another wrong number.

    Accuracy, tested: 16 eps of |value| + sum of |p * d value/d p| over the arguments p, where
    (1e-50 <= |x5| <= 1e50 or x5 = 0) and 1e-50 <= l_KL <= 1e50 and height_condition/2**48 <
    height_square.

    Proved, where -alpha_KL**2*l_KL/10 <= x5 <= l_KL/4 and alpha_KL <= 2 or l_KL/4 <= x5 <= l_KL
    and alpha_KL <= 5/4, as long as no result overflows or falls below the normal range: at most
    5.2 eps with np.arctan within 1 ulp and np.cos within 1 ulp and np.sin within 1 ulp, found
    1.29; at most 4.94 eps compiled, found 1.31.

    Source: Bazuev et al. 2021, equations (7) and (8).

    """
    x5, l_KL, alpha_KL = _as_floats("x5 l_KL alpha_KL", x5, l_KL, alpha_KL)
    l_KL, alpha_KL = _nan_outside(_check_of_roller_offset, l_KL, alpha_KL)
    return _in_blocks(
        _form_of_roller_lever_angle, (x5,), parameters=(l_KL, alpha_KL), out=out, quiet=True
    )


def _form_of_roller_lever_angle(x5: Any, l_KL: Any, alpha_KL: Any) -> Any:
    return 2.0 * _np.arctan(
        x5
        / (
            l_KL * _np.sin(alpha_KL)
            + _np.sqrt(
                (x5 + 2.0 * l_KL * _square(_np.sin(alpha_KL / 2.0)))
                * (2.0 * l_KL * _square(_np.cos(alpha_KL / 2.0)) - x5)
            )
        )
    )


# Source: Bazuev et al. 2021, equation (10)
# Expressions sha256: 73efa20a6bb33f331686cd156f10696b6395eecb8517166aea2ad20dfe4755ed
# Form: product
# Operations: 8
def wedge_displacement(
    phi7: ArrayLike, l_LM: ArrayLike, alpha_LM: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the displacement y9 of the wedge.

        wedge_displacement = l_LM*(sin(alpha_LM + phi7) - sin(alpha_LM))

    Parameters
    ----------
    phi7 : array_like, any shape
        Rotation of the roller lever (rad).
    l_LM : array_like, any shape
        Length of LM, driving arm of the roller lever (mm).
    alpha_LM : array_like, any shape
        Direction of LM at x1 = 0 (rad).

    Returns
    -------
    ndarray or NumPy scalar (mm)

    Notes
    -----
    Domain: 0 < l_LM < oo.

    Accuracy, tested: 4 eps of |value| + sum of |p * d value/d p| over the arguments p, where
    |phi7| <= pi and (phi7 = 0 or 1e-140 <= |phi7|) and 1e-10 <= l_LM <= 1e300.

    Proved, where |phi7| <= 22/7 and 0 <= alpha_LM <= 44/7, as long as no result overflows or
    falls below the normal range: at most 3.05 eps with np.cos within 1 ulp and np.sin within 1
    ulp, found 1.44; at most 3.1 eps compiled, found 2.

    Source: Bazuev et al. 2021, equation (10).

    """
    phi7, l_LM, alpha_LM = _as_floats("phi7 l_LM alpha_LM", phi7, l_LM, alpha_LM)
    (l_LM,) = _nan_outside(_check_of_wedge_displacement, l_LM)
    return _in_blocks(_form_of_wedge_displacement, (phi7,), parameters=(l_LM, alpha_LM), out=out)


def _check_of_wedge_displacement(l_LM: Any) -> tuple[Any, ...]:
    return (_is_positive(l_LM),)


def _form_of_wedge_displacement(phi7: Any, l_LM: Any, alpha_LM: Any) -> Any:
    return 2.0 * l_LM * _np.cos(alpha_LM + phi7 / 2.0) * _np.sin(phi7 / 2.0)


# Source: Bazuev et al. 2021, equations (1), (3), (4), (7), (8), (10)
# Expressions sha256: 757bf4851530486d23028c93c4b94b16921b69c62a3e50bd518a587e1c785308
# Form: half-angle chain
# Operations: 51
def position(
    x1: ArrayLike,
    l_AB: ArrayLike,
    l_BC: ArrayLike,
    l_CD: ArrayLike,
    l_DE: ArrayLike,
    l_GH: ArrayLike,
    l_KL: ArrayLike,
    l_LM: ArrayLike,
    alpha_DE: ArrayLike,
    alpha_KL: ArrayLike,
    alpha_LM: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute the displacement y9 of the wedge, the whole chain.

        position = l_LM*(sin(alpha_LM + turn_7) - sin(alpha_LM))

    Symbols without an equation here: see the module.

    Parameters
    ----------
    x1 : array_like, any shape
        Displacement of the pusher (mm).
    l_AB : array_like, any shape
        Length of AB, pusher to foot of the guide (mm).
    l_BC : array_like, any shape
        Length of BC at x1 = 0 (mm).
    l_CD : array_like, any shape
        Length of CD (mm).
    l_DE : array_like, any shape
        Length of DE, arm of the lever (mm).
    l_GH : array_like, any shape
        Clearance between the rod 5 and the link 5' (mm).
    l_KL : array_like, any shape
        Length of KL, driven arm of the roller lever (mm).
    l_LM : array_like, any shape
        Length of LM, driving arm of the roller lever (mm).
    alpha_DE : array_like, any shape
        Direction of DE at x1 = 0 (rad).
    alpha_KL : array_like, any shape
        Direction of KL at x1 = 0, in (0, pi) (rad).
    alpha_LM : array_like, any shape
        Direction of LM at x1 = 0 (rad).

    Returns
    -------
    ndarray or NumPy scalar (mm)

    Notes
    -----
    Domain: 0 < l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM < oo, 0 < alpha_KL < pi (the linkage
    closes).

    NaN where guide_radicand is negative or |roller_offset| > l_KL.

    The conditioning |value| + sum of |p * d value/d p|: guide_condition of guide_square =
    guide_radicand, roller_condition of KL_x + l_KL in contact.

    Lengths and displacements are squared: of sizes beyond 1e-50 to 1e50 squares may leave the
    range of doubles, and the result is NaN, 0 where it should not be, or another wrong number.

    Accuracy, tested: 8 eps of |value| + sum of |p * d value/d p| over the arguments p, in
    contact, where (1e-50 <= |x1| <= 1e50 or x1 = 0) and 1e-50 <= l_AB, l_BC, l_CD, l_DE, l_KL,
    l_LM <= 1e50 and l_GH <= 1e50 and guide_condition/2**48 < guide_square and
    roller_condition/2**48 < KL_x + l_KL.

    Proved, where -37 mm <= x1 <= 0, and the sizes are within the limits (at least 0.1 %) of the
    set reconstructed with l_BC = 49.75, l_CD = 38, l_DE = 83, as long as no result overflows or
    falls below the normal range: at most 3.13 eps with np.cos within 1 ulp and np.sin within 1
    ulp, found 0.62; at most 3.61 eps compiled, found 0.62.

    Source: Bazuev et al. 2021, equations (1), (3), (4), (7), (8), (10).

    """
    x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM = _as_floats(
        "x1 l_AB l_BC l_CD l_DE l_GH l_KL l_LM alpha_DE alpha_KL alpha_LM",
        x1,
        l_AB,
        l_BC,
        l_CD,
        l_DE,
        l_GH,
        l_KL,
        l_LM,
        alpha_DE,
        alpha_KL,
        alpha_LM,
    )
    l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_KL = _nan_outside(
        _check_of_position, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_KL
    )
    return _in_blocks(
        _form_of_position,
        (x1,),
        _prepare_of_position,
        (l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM),
        out=out,
        quiet=True,
    )


def _check_of_position(
    l_AB: Any, l_BC: Any, l_CD: Any, l_DE: Any, l_GH: Any, l_KL: Any, l_LM: Any, alpha_KL: Any
) -> tuple[Any, ...]:
    return (
        _is_positive(l_AB),
        _is_positive(l_BC),
        _is_positive(l_CD),
        _is_positive(l_DE),
        _is_positive(l_GH),
        _is_positive(l_KL),
        _is_positive(l_LM),
        alpha_KL > 0.0,
        alpha_KL < _np.pi,
    )


def _prepare_of_position(
    l_AB: Any,
    l_BC: Any,
    l_CD: Any,
    l_DE: Any,
    l_GH: Any,
    l_KL: Any,
    l_LM: Any,
    alpha_DE: Any,
    alpha_KL: Any,
    alpha_LM: Any,
) -> tuple[Any, ...]:
    arm = l_AB + l_CD
    sin_DE = _np.sin(alpha_DE)
    cos_DE = _np.cos(alpha_DE)
    to_right = 2.0 * l_KL * _square(_np.sin(alpha_KL / 2.0))
    to_left = 2.0 * l_KL * _square(_np.cos(alpha_KL / 2.0))
    start_height = l_KL * _np.sin(alpha_KL)
    cos_LM = _np.cos(alpha_LM)
    sin_LM = _np.sin(alpha_LM)

    return (
        l_BC,
        l_DE,
        l_GH,
        l_LM,
        arm,
        sin_DE,
        cos_DE,
        to_right,
        to_left,
        start_height,
        cos_LM,
        sin_LM,
    )


def _form_of_position(
    x1: Any,
    l_BC: Any,
    l_DE: Any,
    l_GH: Any,
    l_LM: Any,
    arm: Any,
    sin_DE: Any,
    cos_DE: Any,
    to_right: Any,
    to_left: Any,
    start_height: Any,
    cos_LM: Any,
    sin_LM: Any,
) -> Any:
    guide_length = _np.sqrt(_square(l_BC) + x1 * (2.0 * arm + x1))
    guide_sum = guide_length + l_BC
    lever_square = _square(guide_sum) + _square(x1)
    run = 2.0 * l_DE / lever_square * x1 * (sin_DE * guide_sum - cos_DE * x1)
    push = _maximum(0.0, run - l_GH)
    rise = _np.sqrt((push + to_right) * (to_left - push))
    rise_sum = rise + start_height
    roller_square = _square(push) + _square(rise_sum)

    return 2.0 * l_LM / roller_square * push * (cos_LM * rise_sum - sin_LM * push)


# Source: Bazuev et al. 2021, equations (1), (3), (4), (7), (8), (10)
# Expressions sha256: 1922dcce4f5fd29a7a7e97544e46afcb0698324d16a7fcf8a800ed27eebe439b
# Form: half-angle chain
# Operations: 73
def velocity(
    x1: ArrayLike,
    l_AB: ArrayLike,
    l_BC: ArrayLike,
    l_CD: ArrayLike,
    l_DE: ArrayLike,
    l_GH: ArrayLike,
    l_KL: ArrayLike,
    l_LM: ArrayLike,
    alpha_DE: ArrayLike,
    alpha_KL: ArrayLike,
    alpha_LM: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute dy9/dx1, the velocity of the wedge at unit speed of the pusher.

        velocity = engaged*l_DE*l_LM*sin(alpha_DE + turn_3)*cos(turn_3)*cos(alpha_LM +
            turn_7)/(BC_length*l_KL*sin(alpha_KL + turn_7))

    Symbols without an equation here: see the module.

    Parameters
    ----------
    x1 : array_like, any shape
        Displacement of the pusher (mm).
    l_AB : array_like, any shape
        Length of AB, pusher to foot of the guide (mm).
    l_BC : array_like, any shape
        Length of BC at x1 = 0 (mm).
    l_CD : array_like, any shape
        Length of CD (mm).
    l_DE : array_like, any shape
        Length of DE, arm of the lever (mm).
    l_GH : array_like, any shape
        Clearance between the rod 5 and the link 5' (mm).
    l_KL : array_like, any shape
        Length of KL, driven arm of the roller lever (mm).
    l_LM : array_like, any shape
        Length of LM, driving arm of the roller lever (mm).
    alpha_DE : array_like, any shape
        Direction of DE at x1 = 0 (rad).
    alpha_KL : array_like, any shape
        Direction of KL at x1 = 0, in (0, pi) (rad).
    alpha_LM : array_like, any shape
        Direction of LM at x1 = 0 (rad).

    Returns
    -------
    ndarray or NumPy scalar (pure number)

    Notes
    -----
    Domain: 0 < l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM < oo, 0 < alpha_KL < pi (the linkage
    closes and is at no dead centre).

    Singular: travel_5 = l_GH, the start of contact: derivatives jump, here they are those in
    contact.

    NaN where guide_radicand is negative or |roller_offset| > l_KL.

    The conditioning |value| + sum of |p * d value/d p|: run_condition of travel_5,
    guide_condition of guide_square = guide_radicand, roller_condition of KL_x + l_KL in
    contact.

    Lengths and displacements are squared: of sizes beyond 1e-50 to 1e50 squares may leave the
    range of doubles, and the result is NaN, 0 where it should not be, or another wrong number.

    Accuracy, tested: 8 eps of |value| + sum of |p * d value/d p| over the arguments p, in
    contact, where run_condition/2**48 < |l_GH - travel_5| and (1e-50 <= |x1| <= 1e50 or x1 = 0)
    and 1e-50 <= l_AB, l_BC, l_CD, l_DE, l_KL, l_LM <= 1e50 and l_GH <= 1e50 and
    guide_condition/2**48 < guide_square and roller_condition/2**48 < KL_x + l_KL.

    Proved, where -37 mm <= x1 <= -2 mm or -3/4 mm <= x1 <= 0, and the sizes are within the
    limits (at least 0.1 %) of the set reconstructed with l_BC = 49.75, l_CD = 38, l_DE = 83, as
    long as no result overflows or falls below the normal range: at most 3.11 eps with np.cos
    within 1 ulp and np.sin within 1 ulp, found 0.86; at most 4.09 eps compiled, found 0.86.

    Source: Bazuev et al. 2021, equations (1), (3), (4), (7), (8), (10).

    """
    x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM = _as_floats(
        "x1 l_AB l_BC l_CD l_DE l_GH l_KL l_LM alpha_DE alpha_KL alpha_LM",
        x1,
        l_AB,
        l_BC,
        l_CD,
        l_DE,
        l_GH,
        l_KL,
        l_LM,
        alpha_DE,
        alpha_KL,
        alpha_LM,
    )
    l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_KL = _nan_outside(
        _check_of_position, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_KL
    )
    return _in_blocks(
        _form_of_velocity,
        (x1,),
        _prepare_of_position,
        (l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM),
        out=out,
        quiet=True,
    )


def _form_of_velocity(
    x1: Any,
    l_BC: Any,
    l_DE: Any,
    l_GH: Any,
    l_LM: Any,
    arm: Any,
    sin_DE: Any,
    cos_DE: Any,
    to_right: Any,
    to_left: Any,
    start_height: Any,
    cos_LM: Any,
    sin_LM: Any,
) -> Any:
    guide_length = _np.sqrt(_square(l_BC) + x1 * (2.0 * arm + x1))
    guide_sum = guide_length + l_BC
    lever_square = _square(guide_sum) + _square(x1)
    cos_lever = (2.0 * arm * x1 + 2.0 * l_BC * guide_sum) / lever_square
    run = 2.0 * l_DE / lever_square * x1 * (sin_DE * guide_sum - cos_DE * x1)
    push = _maximum(0.0, run - l_GH)
    rise = _np.sqrt((push + to_right) * (to_left - push))
    rise_sum = rise + start_height
    roller_square = _square(push) + _square(rise_sum)
    cos_wedge = (
        cos_LM * (push + rise_sum) * (rise_sum - push) - 2.0 * sin_LM * push * rise_sum
    ) / roller_square
    gain = cos_wedge * _choose_where(run < l_GH, 0.0, l_LM) / rise
    sin_arm = sin_DE * cos_lever - 2.0 * cos_DE / lever_square * guide_sum * x1

    return l_DE / guide_length * cos_lever * gain * sin_arm


# Source: Bazuev et al. 2021, equations (1), (3), (4), (7), (8), (10)
# Expressions sha256: a89b4a9344c8eb7b4abba2baf383ffa8bce6ce44422654ab1223258302760cdf
# Form: half-angle chain
# Operations: 114
def sensitivities(
    x1: ArrayLike,
    l_AB: ArrayLike,
    l_BC: ArrayLike,
    l_CD: ArrayLike,
    l_DE: ArrayLike,
    l_GH: ArrayLike,
    l_KL: ArrayLike,
    l_LM: ArrayLike,
    alpha_DE: ArrayLike,
    alpha_KL: ArrayLike,
    alpha_LM: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> NDArray[Any]:
    """Compute the derivatives of y9 by the sizes, in the order of the arguments.

        [-engaged*l_DE*l_LM*(1 - cos(turn_3))*sin(alpha_DE + turn_3)*cos(alpha_LM +
            turn_7)/(BC_length*l_KL*sin(alpha_KL + turn_7))]
        [engaged*l_DE*l_LM*sin(turn_3)*sin(alpha_DE + turn_3)*cos(alpha_LM +
            turn_7)/(BC_length*l_KL*sin(alpha_KL + turn_7))]
        [-engaged*l_DE*l_LM*(1 - cos(turn_3))*sin(alpha_DE + turn_3)*cos(alpha_LM +
            turn_7)/(BC_length*l_KL*sin(alpha_KL + turn_7))]
        [engaged*l_LM*(cos(alpha_DE + turn_3) - cos(alpha_DE))*cos(alpha_LM +
            turn_7)/(l_KL*sin(alpha_KL + turn_7))]
        [-engaged*l_LM*cos(alpha_LM + turn_7)/(l_KL*sin(alpha_KL + turn_7))]
        [engaged*l_LM*(cos(alpha_KL + turn_7) - cos(alpha_KL))*cos(alpha_LM +
            turn_7)/(l_KL*sin(alpha_KL + turn_7))]
        [engaged*(sin(alpha_LM + turn_7) - sin(alpha_LM))]
        [engaged*l_DE*l_LM*(sin(alpha_DE) - sin(alpha_DE + turn_3))*cos(alpha_LM +
            turn_7)/(l_KL*sin(alpha_KL + turn_7))]
        [engaged*l_LM*(sin(alpha_KL)/sin(alpha_KL + turn_7) - 1)*cos(alpha_LM + turn_7)]
        [engaged*l_LM*(cos(alpha_LM + turn_7) - cos(alpha_LM))]

    Symbols without an equation here: see the module.

    Parameters
    ----------
    x1 : array_like, any shape
        Displacement of the pusher (mm).
    l_AB : array_like, any shape
        Length of AB, pusher to foot of the guide (mm).
    l_BC : array_like, any shape
        Length of BC at x1 = 0 (mm).
    l_CD : array_like, any shape
        Length of CD (mm).
    l_DE : array_like, any shape
        Length of DE, arm of the lever (mm).
    l_GH : array_like, any shape
        Clearance between the rod 5 and the link 5' (mm).
    l_KL : array_like, any shape
        Length of KL, driven arm of the roller lever (mm).
    l_LM : array_like, any shape
        Length of LM, driving arm of the roller lever (mm).
    alpha_DE : array_like, any shape
        Direction of DE at x1 = 0 (rad).
    alpha_KL : array_like, any shape
        Direction of KL at x1 = 0, in (0, pi) (rad).
    alpha_LM : array_like, any shape
        Direction of LM at x1 = 0 (rad).

    Returns
    -------
    ndarray, shape (..., 10) (mm per mm or mm per rad)

    Notes
    -----
    Domain: 0 < l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM < oo, 0 < alpha_KL < pi (the linkage
    closes and is at no dead centre).

    Singular: travel_5 = l_GH, the start of contact: derivatives jump, here they are those in
    contact.

    NaN where guide_radicand is negative or |roller_offset| > l_KL.

    The conditioning |value| + sum of |p * d value/d p|: run_condition of travel_5,
    guide_condition of guide_square = guide_radicand, roller_condition of KL_x + l_KL in
    contact.

    Lengths and displacements are squared: of sizes beyond 1e-50 to 1e50 squares may leave the
    range of doubles, and the result is NaN, 0 where it should not be, or another wrong number.

    Accuracy, tested: 8 eps of norm over the entries (each keeps its own) of |value| + sum of |p
    * d value/d p| over the arguments p, in contact, where run_condition/2**48 < |l_GH -
    travel_5| and (1e-50 <= |x1| <= 1e50 or x1 = 0) and 1e-50 <= l_AB, l_BC, l_CD, l_DE, l_KL,
    l_LM <= 1e50 and l_GH <= 1e50 and guide_condition/2**48 < guide_square and
    roller_condition/2**48 < KL_x + l_KL.

    Proved, where -37 mm <= x1 <= -2 mm or -3/4 mm <= x1 <= 0, and the sizes are within the
    limits (at least 0.1 %) of the set reconstructed with l_BC = 49.75, l_CD = 38, l_DE = 83, as
    long as no result overflows or falls below the normal range: at most 6.14 eps with np.cos
    within 1 ulp and np.sin within 1 ulp, found 0.59; at most 5.76 eps compiled, found 0.6.

    Source: Bazuev et al. 2021, equations (1), (3), (4), (7), (8), (10).

    """
    x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM = _as_floats(
        "x1 l_AB l_BC l_CD l_DE l_GH l_KL l_LM alpha_DE alpha_KL alpha_LM",
        x1,
        l_AB,
        l_BC,
        l_CD,
        l_DE,
        l_GH,
        l_KL,
        l_LM,
        alpha_DE,
        alpha_KL,
        alpha_LM,
    )
    l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_KL = _nan_outside(
        _check_of_position, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_KL
    )
    return _in_blocks(
        _form_of_sensitivities,
        (x1,),
        _prepare_of_sensitivities,
        (l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM),
        out=out,
        shape=(10,),
        quiet=True,
    )


def _prepare_of_sensitivities(
    l_AB: Any,
    l_BC: Any,
    l_CD: Any,
    l_DE: Any,
    l_GH: Any,
    l_KL: Any,
    l_LM: Any,
    alpha_DE: Any,
    alpha_KL: Any,
    alpha_LM: Any,
) -> tuple[Any, ...]:
    arm = l_AB + l_CD
    sin_DE = _np.sin(alpha_DE)
    cos_DE = _np.cos(alpha_DE)
    to_right = 2.0 * l_KL * _square(_np.sin(alpha_KL / 2.0))
    to_left = 2.0 * l_KL * _square(_np.cos(alpha_KL / 2.0))
    start_height = l_KL * _np.sin(alpha_KL)
    cos_LM = _np.cos(alpha_LM)
    sin_LM = _np.sin(alpha_LM)

    return (
        l_BC,
        l_DE,
        l_GH,
        l_KL,
        l_LM,
        arm,
        sin_DE,
        cos_DE,
        to_right,
        to_left,
        start_height,
        cos_LM,
        sin_LM,
    )


def _form_of_sensitivities(
    x1: Any,
    l_BC: Any,
    l_DE: Any,
    l_GH: Any,
    l_KL: Any,
    l_LM: Any,
    arm: Any,
    sin_DE: Any,
    cos_DE: Any,
    to_right: Any,
    to_left: Any,
    start_height: Any,
    cos_LM: Any,
    sin_LM: Any,
) -> Any:
    x1_squared = _square(x1)
    guide_length = _np.sqrt(_square(l_BC) + x1 * (2.0 * arm + x1))
    guide_sum = guide_length + l_BC
    lever_square = _square(guide_sum) + x1_squared
    run = 2.0 * l_DE / lever_square * x1 * (sin_DE * guide_sum - cos_DE * x1)
    push = _maximum(0.0, run - l_GH)
    rise = _np.sqrt((push + to_right) * (to_left - push))
    rise_sum = rise + start_height
    roller_square = _square(push) + _square(rise_sum)
    cos_wedge = (
        cos_LM * (push + rise_sum) * (rise_sum - push) - 2.0 * sin_LM * push * rise_sum
    ) / roller_square
    gain = cos_wedge * _choose_where(run < l_GH, 0.0, l_LM) / rise
    cos_lever = (2.0 * arm * x1 + 2.0 * l_BC * guide_sum) / lever_square
    sin_arm = sin_DE * cos_lever - 2.0 * cos_DE / lever_square * guide_sum * x1
    term = -2.0 * l_DE / (guide_length * lever_square) * gain * sin_arm * x1_squared

    return (
        term,
        -2.0 * l_DE / (guide_length * lever_square) * gain * guide_sum * sin_arm * x1,
        term,
        gain * run / l_DE,
        -gain,
        -gain * push / l_KL,
        2.0 / roller_square * push * (cos_LM * rise_sum - sin_LM * push),
        2.0 * l_DE / lever_square * gain * x1 * (cos_DE * guide_sum + sin_DE * x1),
        gain * push * (push + to_right - to_left) / rise_sum,
        -2.0 * l_LM / roller_square * push * (cos_LM * push + sin_LM * rise_sum),
    )
