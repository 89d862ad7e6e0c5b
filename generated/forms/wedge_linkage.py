"""Other forms of the kernels of `wedge_linkage`.

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

Symbols of the formulas:

    Q = sqrt(l_BC**4 + l_BC**2*x1*(2*l_AB + 2*l_CD + x1))
    BC_length = sqrt(l_BC**2 + x1*(2*l_AB + 2*l_CD + x1))
    turn_3_atan2 = atan2(l_AB*l_BC**2 + l_CD*(l_BC**2 - Q) - Q*(l_AB + x1), l_BC*(Q + (l_AB
        + l_CD)*(l_AB + l_CD + x1)))
    travel_5_atan2 = l_DE*(cos(alpha_DE + turn_3_atan2) - cos(alpha_DE))
    driven_5_atan2 = Max(0, travel_5_atan2 - l_GH)
    KL_x_atan2 = l_KL*cos(alpha_KL) - driven_5_atan2
    turn_7_atan2 = atan2(sqrt(l_KL**2 - KL_x_atan2**2), KL_x_atan2) - alpha_KL
    engaged_atan2 = Piecewise((0, travel_5_atan2 < l_GH), (1, True))

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
    is_positive as _is_positive,
    nan_outside as _nan_outside,
)
from mechproof.kernel_support.functions import (
    choose_where as _choose_where,
    maximum as _maximum,
    square as _square,
)

__all__ = [
    "clearance_printed",
    "lever_angle_atan2",
    "lever_angle_printed",
    "position_atan2",
    "position_printed",
    "rod_displacement_printed",
    "roller_lever_angle_arccosine",
    "roller_lever_angle_atan2",
    "roller_lever_angle_or_else",
    "roller_lever_angle_printed",
    "sensitivities_slopes",
    "velocity_slopes",
    "wedge_displacement_printed",
]


def __dir__() -> list[str]:
    return __all__


# Source: Bazuev et al. 2021, equation (1)
# Expressions sha256: 19f89cd360357760c68eeb8493e64ff22530159926492fd9eeec818c42543fad
# Form: printed (1)
# Operations: 26
def lever_angle_printed(
    x1: ArrayLike,
    l_AB: ArrayLike,
    l_BC: ArrayLike,
    l_CD: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute `lever_angle` by another form: printed (1).

        lever_angle_printed = atan((l_AB*l_BC**2 + l_CD*(l_BC**2 - Q) - Q*(l_AB + x1))/(l_BC*(Q
            + (l_AB + l_CD)*(l_AB + l_CD + x1))))
        Q = sqrt(l_BC**4 + l_BC**2*x1*(2*l_AB + 2*l_CD + x1))

    Beyond a right angle of the lever it is off by pi.

    Same domain as `lever_angle`, the radicand of Q is positive.

    Source: Bazuev et al. 2021, equation (1).

    """
    x1, l_AB, l_BC, l_CD = _as_floats("x1 l_AB l_BC l_CD", x1, l_AB, l_BC, l_CD)
    l_AB, l_BC, l_CD = _nan_outside(_check_of_lever_angle_printed, l_AB, l_BC, l_CD)
    return _in_blocks(
        _form_of_lever_angle_printed,
        (x1,),
        _prepare_of_lever_angle_printed,
        (l_AB, l_BC, l_CD),
        out=out,
        quiet=True,
    )


def _check_of_lever_angle_printed(l_AB: Any, l_BC: Any, l_CD: Any) -> tuple[Any, ...]:
    return (_is_positive(l_AB), _is_positive(l_BC), _is_positive(l_CD))


def _prepare_of_lever_angle_printed(l_AB: Any, l_BC: Any, l_CD: Any) -> tuple[Any, ...]:
    l_BC_squared = _square(l_BC)

    return (l_AB, l_BC, l_CD, l_BC_squared)


def _form_of_lever_angle_printed(
    x1: Any, l_AB: Any, l_BC: Any, l_CD: Any, l_BC_squared: Any
) -> Any:
    Q = _np.sqrt(_square(_square(l_BC)) + l_BC_squared * x1 * (2.0 * l_AB + 2.0 * l_CD + x1))

    return _np.arctan(
        (l_BC_squared * l_AB + l_CD * (l_BC_squared - Q) - Q * (l_AB + x1))
        / (l_BC * (Q + (l_AB + l_CD) * (l_AB + l_CD + x1)))
    )


# Source: Bazuev et al. 2021, equation (1)
# Expressions sha256: a418a34ad20bd73555ad15c086e5af105d8404351888e4c81a0b9dfe511efec0
# Form: (1) with atan2
# Operations: 25
def lever_angle_atan2(
    x1: ArrayLike,
    l_AB: ArrayLike,
    l_BC: ArrayLike,
    l_CD: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute `lever_angle` by another form: (1) with atan2.

        lever_angle_atan2 = atan2(l_AB*l_BC**2 + l_CD*(l_BC**2 - Q) - Q*(l_AB + x1), l_BC*(Q +
            (l_AB + l_CD)*(l_AB + l_CD + x1)))
        Q = sqrt(l_BC**4 + l_BC**2*x1*(2*l_AB + 2*l_CD + x1))

    Same domain as `lever_angle`, the radicand of Q is positive.

    """
    x1, l_AB, l_BC, l_CD = _as_floats("x1 l_AB l_BC l_CD", x1, l_AB, l_BC, l_CD)
    l_AB, l_BC, l_CD = _nan_outside(_check_of_lever_angle_printed, l_AB, l_BC, l_CD)
    return _in_blocks(
        _form_of_lever_angle_atan2,
        (x1,),
        _prepare_of_lever_angle_printed,
        (l_AB, l_BC, l_CD),
        out=out,
        quiet=True,
    )


def _form_of_lever_angle_atan2(x1: Any, l_AB: Any, l_BC: Any, l_CD: Any, l_BC_squared: Any) -> Any:
    Q = _np.sqrt(_square(_square(l_BC)) + l_BC_squared * x1 * (2.0 * l_AB + 2.0 * l_CD + x1))

    return _np.arctan2(
        l_BC_squared * l_AB + l_CD * (l_BC_squared - Q) - Q * (l_AB + x1),
        l_BC * (Q + (l_AB + l_CD) * (l_AB + l_CD + x1)),
    )


# Source: Bazuev et al. 2021, equation (3)
# Expressions sha256: c259a9eb668b11d74a163d09e1c2d5da9b743aab3232290ddb9f4c483059c57c
# Form: printed (3)
# Operations: 5
def rod_displacement_printed(
    phi3: ArrayLike, l_DE: ArrayLike, alpha_DE: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `rod_displacement` by another form: printed (3).

        rod_displacement_printed = l_DE*(cos(alpha_DE + phi3) - cos(alpha_DE))

    Same domain as `rod_displacement`.

    Source: Bazuev et al. 2021, equation (3).

    """
    phi3, l_DE, alpha_DE = _as_floats("phi3 l_DE alpha_DE", phi3, l_DE, alpha_DE)
    (l_DE,) = _nan_outside(_check_of_rod_displacement_printed, l_DE)
    return _in_blocks(
        _form_of_rod_displacement_printed, (phi3,), parameters=(l_DE, alpha_DE), out=out
    )


def _check_of_rod_displacement_printed(l_DE: Any) -> tuple[Any, ...]:
    return (_is_positive(l_DE),)


def _form_of_rod_displacement_printed(phi3: Any, l_DE: Any, alpha_DE: Any) -> Any:
    return l_DE * (_np.cos(alpha_DE + phi3) - _np.cos(alpha_DE))


# Source: Bazuev et al. 2021, equation (4)
# Expressions sha256: 796c0ff2c4b7fbd700fd8514bd0d9170d6d783e05c963645bf3a0df7705e8404
# Form: printed (4)
# Operations: 3
def clearance_printed(x5: ArrayLike, l_GH: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute `clearance` by another form: printed (4).

        clearance_printed = Piecewise((0, x5 < l_GH), (x5 - l_GH, True))

    Same domain as `clearance`.

    Source: Bazuev et al. 2021, equation (4).

    """
    x5, l_GH = _as_floats("x5 l_GH", x5, l_GH)
    (l_GH,) = _nan_outside(_check_of_clearance_printed, l_GH)
    return _in_blocks(_form_of_clearance_printed, (x5,), parameters=(l_GH,), out=out, quiet=True)


def _check_of_clearance_printed(l_GH: Any) -> tuple[Any, ...]:
    return (_is_positive(l_GH),)


def _form_of_clearance_printed(x5: Any, l_GH: Any) -> Any:
    return _choose_where(x5 < l_GH, 0.0, x5 - l_GH)


# Source: Bazuev et al. 2021, equations (7) and (8)
# Expressions sha256: 1b73d4c36bbf8a0c3f48665172650163271a5435d1a64b8c4de077ecc95fb63c
# Form: printed (7), (8)
# Operations: 16
def roller_lever_angle_printed(
    x5: ArrayLike, l_KL: ArrayLike, alpha_KL: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `roller_lever_angle` by another form: printed (7), (8).

        roller_lever_angle_printed = Piecewise((atan(sqrt(l_KL**2 - (l_KL*cos(alpha_KL) -
            x5)**2)/(l_KL*cos(alpha_KL) - x5)) - alpha_KL, 0 < l_KL*cos(alpha_KL) - x5), (pi +
            atan(sqrt(l_KL**2 - (l_KL*cos(alpha_KL) - x5)**2)/(l_KL*cos(alpha_KL) - x5)) -
            alpha_KL, l_KL*cos(alpha_KL) - x5 < 0), (nan, True))

    R = 0 is in neither case: NaN.

    Same domain as `roller_lever_angle`, R > 0 or R < 0, |R| <= l_KL.

    Source: Bazuev et al. 2021, equations (7) and (8).

    """
    x5, l_KL, alpha_KL = _as_floats("x5 l_KL alpha_KL", x5, l_KL, alpha_KL)
    l_KL, alpha_KL = _nan_outside(_check_of_roller_lever_angle_printed, l_KL, alpha_KL)
    return _in_blocks(
        _form_of_roller_lever_angle_printed, (x5,), parameters=(l_KL, alpha_KL), out=out, quiet=True
    )


def _check_of_roller_lever_angle_printed(l_KL: Any, alpha_KL: Any) -> tuple[Any, ...]:
    return (_is_positive(l_KL), alpha_KL > 0.0, alpha_KL < _np.pi)


def _form_of_roller_lever_angle_printed(x5: Any, l_KL: Any, alpha_KL: Any) -> Any:
    term_2 = l_KL * _np.cos(alpha_KL) - x5
    term = _np.arctan(_np.sqrt(_square(l_KL) - _square(term_2)) / term_2)

    return _choose_where(
        term_2 > 0.0,
        term - alpha_KL,
        _choose_where(term_2 < 0.0, _np.pi + term - alpha_KL, _np.nan),
    )


# Source: Bazuev et al. 2021, equations (7) and (8)
# Expressions sha256: fb72964592027305f4257925cbd4a4f9de8d3459638035926878b60d939c1f6a
# Form: (7) or else (8)
# Operations: 14
def roller_lever_angle_or_else(
    x5: ArrayLike, l_KL: ArrayLike, alpha_KL: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `roller_lever_angle` by another form: (7) or else (8).

        roller_lever_angle_or_else = Piecewise((atan(sqrt(l_KL**2 - (l_KL*cos(alpha_KL) -
            x5)**2)/(l_KL*cos(alpha_KL) - x5)) - alpha_KL, 0 < l_KL*cos(alpha_KL) - x5), (pi +
            atan(sqrt(l_KL**2 - (l_KL*cos(alpha_KL) - x5)**2)/(l_KL*cos(alpha_KL) - x5)) -
            alpha_KL, True))

    At R = 0 the quotient is infinite and (8) off by pi.

    Same domain as `roller_lever_angle`, R > 0 or R < 0, |R| <= l_KL.

    """
    x5, l_KL, alpha_KL = _as_floats("x5 l_KL alpha_KL", x5, l_KL, alpha_KL)
    l_KL, alpha_KL = _nan_outside(_check_of_roller_lever_angle_printed, l_KL, alpha_KL)
    return _in_blocks(
        _form_of_roller_lever_angle_or_else, (x5,), parameters=(l_KL, alpha_KL), out=out, quiet=True
    )


def _form_of_roller_lever_angle_or_else(x5: Any, l_KL: Any, alpha_KL: Any) -> Any:
    term_2 = l_KL * _np.cos(alpha_KL) - x5
    term = _np.arctan(_np.sqrt(_square(l_KL) - _square(term_2)) / term_2)

    return _choose_where(term_2 > 0.0, term - alpha_KL, _np.pi + term - alpha_KL)


# Source: Bazuev et al. 2021, equations (7) and (8)
# Expressions sha256: 3f0268d8b2efcdfdaaf43cb9fa60a6542316aadf642280e60f489d48eafad960
# Form: atan2
# Operations: 9
def roller_lever_angle_atan2(
    x5: ArrayLike, l_KL: ArrayLike, alpha_KL: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `roller_lever_angle` by another form: atan2.

        roller_lever_angle_atan2 = atan2(sqrt(l_KL**2 - (l_KL*cos(alpha_KL) - x5)**2),
            l_KL*cos(alpha_KL) - x5) - alpha_KL

    Same domain as `roller_lever_angle`, the roller lever follows the link 5'.

    """
    x5, l_KL, alpha_KL = _as_floats("x5 l_KL alpha_KL", x5, l_KL, alpha_KL)
    l_KL, alpha_KL = _nan_outside(_check_of_roller_lever_angle_printed, l_KL, alpha_KL)
    return _in_blocks(
        _form_of_roller_lever_angle_atan2, (x5,), parameters=(l_KL, alpha_KL), out=out, quiet=True
    )


def _form_of_roller_lever_angle_atan2(x5: Any, l_KL: Any, alpha_KL: Any) -> Any:
    term = l_KL * _np.cos(alpha_KL) - x5

    return _np.arctan2(_np.sqrt(_square(l_KL) - _square(term)), term) - alpha_KL


# Source: Bazuev et al. 2021, equations (7) and (8)
# Expressions sha256: b97f8ea1de5f7ba333b79944cd7e07e73bf7c73127e168bd5c429d9ea29b06a2
# Form: arccosine
# Operations: 5
def roller_lever_angle_arccosine(
    x5: ArrayLike, l_KL: ArrayLike, alpha_KL: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `roller_lever_angle` by another form: arccosine.

        roller_lever_angle_arccosine = acos(cos(alpha_KL) - x5/l_KL) - alpha_KL

    Same domain as `roller_lever_angle`, alpha_KL = 2 arctan(kappa) in [0, pi), KL upwards.

    """
    x5, l_KL, alpha_KL = _as_floats("x5 l_KL alpha_KL", x5, l_KL, alpha_KL)
    l_KL, alpha_KL = _nan_outside(_check_of_roller_lever_angle_printed, l_KL, alpha_KL)
    return _in_blocks(
        _form_of_roller_lever_angle_arccosine,
        (x5,),
        parameters=(l_KL, alpha_KL),
        out=out,
        quiet=True,
    )


def _form_of_roller_lever_angle_arccosine(x5: Any, l_KL: Any, alpha_KL: Any) -> Any:
    return _np.arccos(_np.cos(alpha_KL) - x5 / l_KL) - alpha_KL


# Source: Bazuev et al. 2021, equation (10)
# Expressions sha256: 93cb92e4570440792e65e4efc2e24e0e79ff9a204760d4fe9261a947b5f7782e
# Form: printed (10)
# Operations: 5
def wedge_displacement_printed(
    phi7: ArrayLike, l_LM: ArrayLike, alpha_LM: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute `wedge_displacement` by another form: printed (10).

        wedge_displacement_printed = l_LM*(sin(alpha_LM + phi7) - sin(alpha_LM))

    Same domain as `wedge_displacement`.

    Source: Bazuev et al. 2021, equation (10).

    """
    phi7, l_LM, alpha_LM = _as_floats("phi7 l_LM alpha_LM", phi7, l_LM, alpha_LM)
    (l_LM,) = _nan_outside(_check_of_wedge_displacement_printed, l_LM)
    return _in_blocks(
        _form_of_wedge_displacement_printed, (phi7,), parameters=(l_LM, alpha_LM), out=out
    )


def _check_of_wedge_displacement_printed(l_LM: Any) -> tuple[Any, ...]:
    return (_is_positive(l_LM),)


def _form_of_wedge_displacement_printed(phi7: Any, l_LM: Any, alpha_LM: Any) -> Any:
    return l_LM * (_np.sin(alpha_LM + phi7) - _np.sin(alpha_LM))


# Source: Bazuev et al. 2021, equations (1), (3), (4), (7), (8), (10)
# Expressions sha256: 19738a12373efaff41b984bad662934f029b9b9b2d8e4b062377b538909bd122
# Form: printed chain
# Operations: 55
def position_printed(
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
    """Compute `position` by another form: printed chain.

        position_printed = l_LM*(sin(alpha_LM + turn_7_printed) - sin(alpha_LM))
        turn_3_printed = atan((l_AB*l_BC**2 + l_CD*(l_BC**2 - Q) - Q*(l_AB + x1))/(l_BC*(Q +
            (l_AB + l_CD)*(l_AB + l_CD + x1))))
        travel_5_printed = l_DE*(cos(alpha_DE + turn_3_printed) - cos(alpha_DE))
        driven_5_printed = Piecewise((0, travel_5_printed < l_GH), (travel_5_printed - l_GH,
            True))
        KL_x_printed = l_KL*cos(alpha_KL) - driven_5_printed
        turn_7_printed = Piecewise((atan(sqrt(l_KL**2 - KL_x_printed**2)/KL_x_printed) -
            alpha_KL, 0 < KL_x_printed), (pi + atan(sqrt(l_KL**2 -
            KL_x_printed**2)/KL_x_printed) - alpha_KL, KL_x_printed < 0), (nan, True))

    Symbols without an equation here: see the module.

    Stage by stage; R = 0 is in neither case: NaN.

    Same domain as `position`, the radicand of Q is positive and x1 > -(l_AB + l_CD), A has not
    passed D; R > 0 or R < 0, |R| <= l_KL.

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
        _check_of_position_printed, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_KL
    )
    return _in_blocks(
        _form_of_position_printed,
        (x1,),
        _prepare_of_position_printed,
        (l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM),
        out=out,
        quiet=True,
    )


def _check_of_position_printed(
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


def _prepare_of_position_printed(
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
    l_BC_squared = _square(l_BC)

    return (l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, l_BC_squared)


def _form_of_position_printed(
    x1: Any,
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
    l_BC_squared: Any,
) -> Any:
    Q = _np.sqrt(_square(_square(l_BC)) + l_BC_squared * x1 * (2.0 * l_AB + 2.0 * l_CD + x1))
    turn_3_printed = _np.arctan(
        (l_BC_squared * l_AB + l_CD * (l_BC_squared - Q) - Q * (l_AB + x1))
        / (l_BC * (Q + (l_AB + l_CD) * (l_AB + l_CD + x1)))
    )
    travel_5_printed = l_DE * (_np.cos(alpha_DE + turn_3_printed) - _np.cos(alpha_DE))
    driven_5_printed = _choose_where(travel_5_printed < l_GH, 0.0, travel_5_printed - l_GH)
    KL_x_printed = l_KL * _np.cos(alpha_KL) - driven_5_printed
    term = _np.arctan(_np.sqrt(_square(l_KL) - _square(KL_x_printed)) / KL_x_printed)
    turn_7_printed = _choose_where(
        KL_x_printed > 0.0,
        term - alpha_KL,
        _choose_where(KL_x_printed < 0.0, _np.pi + term - alpha_KL, _np.nan),
    )

    return l_LM * (_np.sin(alpha_LM + turn_7_printed) - _np.sin(alpha_LM))


# Source: Bazuev et al. 2021, equations (1), (3), (4), (7), (8), (10)
# Expressions sha256: 5fe241f591b4b0e5a1eded9e3ad96953a59e6f88dd9e052bc2ef2473d126f17c
# Form: chain with atan2
# Operations: 46
def position_atan2(
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
    """Compute `position` by another form: chain with atan2.

        position_atan2 = l_LM*(sin(alpha_LM + turn_7_atan2) - sin(alpha_LM))

    Symbols without an equation here: see the module.

    Stage by stage.

    Same domain as `position`, the radicand of Q is positive; alpha_KL = 2 arctan(kappa) in [0,
    pi), KL upwards.

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
        _check_of_position_printed, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_KL
    )
    return _in_blocks(
        _form_of_position_atan2,
        (x1,),
        _prepare_of_position_printed,
        (l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM),
        out=out,
        quiet=True,
    )


def _form_of_position_atan2(
    x1: Any,
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
    l_BC_squared: Any,
) -> Any:
    Q = _np.sqrt(_square(_square(l_BC)) + l_BC_squared * x1 * (2.0 * l_AB + 2.0 * l_CD + x1))
    turn_3_atan2 = _np.arctan2(
        l_BC_squared * l_AB + l_CD * (l_BC_squared - Q) - Q * (l_AB + x1),
        l_BC * (Q + (l_AB + l_CD) * (l_AB + l_CD + x1)),
    )
    travel_5_atan2 = l_DE * (_np.cos(alpha_DE + turn_3_atan2) - _np.cos(alpha_DE))
    driven_5_atan2 = _maximum(0.0, travel_5_atan2 - l_GH)
    KL_x_atan2 = l_KL * _np.cos(alpha_KL) - driven_5_atan2
    turn_7_atan2 = _np.arctan2(_np.sqrt(_square(l_KL) - _square(KL_x_atan2)), KL_x_atan2) - alpha_KL

    return l_LM * (_np.sin(alpha_LM + turn_7_atan2) - _np.sin(alpha_LM))


# Source: Bazuev et al. 2021, equations (1), (3), (4), (7), (8), (10)
# Expressions sha256: c299948803878985556f018d29cdca9b992f78bd852a17a3985d5d80361917c8
# Form: product of slopes
# Operations: 60
def velocity_slopes(
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
    """Compute `velocity` by another form: product of slopes.

        velocity_slopes = engaged_atan2*l_DE*l_LM*sin(alpha_DE +
            turn_3_atan2)*cos(turn_3_atan2)*cos(alpha_LM +
            turn_7_atan2)/(BC_length*l_KL*sin(alpha_KL + turn_7_atan2))

    Symbols without an equation here: see the module.

    Stage by stage, at the angles of the chain with atan2.

    Same domain as `velocity`, the radicand of Q is positive; alpha_KL = 2 arctan(kappa) in [0,
    pi), KL upwards.

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
        _check_of_position_printed, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_KL
    )
    return _in_blocks(
        _form_of_velocity_slopes,
        (x1,),
        _prepare_of_position_printed,
        (l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM),
        out=out,
        quiet=True,
    )


def _form_of_velocity_slopes(
    x1: Any,
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
    l_BC_squared: Any,
) -> Any:
    term = 2.0 * l_AB + 2.0 * l_CD + x1
    Q = _np.sqrt(_square(_square(l_BC)) + l_BC_squared * term * x1)
    turn_3_atan2 = _np.arctan2(
        l_BC_squared * l_AB + l_CD * (l_BC_squared - Q) - Q * (l_AB + x1),
        l_BC * (Q + (l_AB + l_CD) * (l_AB + l_CD + x1)),
    )
    term_2 = alpha_DE + turn_3_atan2
    travel_5_atan2 = l_DE * (_np.cos(term_2) - _np.cos(alpha_DE))
    engaged_atan2 = _choose_where(travel_5_atan2 < l_GH, 0.0, 1.0)
    BC_length = _np.sqrt(l_BC_squared + term * x1)
    driven_5_atan2 = _maximum(0.0, travel_5_atan2 - l_GH)
    KL_x_atan2 = l_KL * _np.cos(alpha_KL) - driven_5_atan2
    turn_7_atan2 = _np.arctan2(_np.sqrt(_square(l_KL) - _square(KL_x_atan2)), KL_x_atan2) - alpha_KL

    return (
        l_DE
        * l_LM
        / (l_KL * BC_length * _np.sin(alpha_KL + turn_7_atan2))
        * engaged_atan2
        * _np.cos(turn_3_atan2)
        * _np.cos(alpha_LM + turn_7_atan2)
        * _np.sin(term_2)
    )


# Source: Bazuev et al. 2021, equations (1), (3), (4), (7), (8), (10)
# Expressions sha256: 5f5eff26437c61e888bc9d329aaa5b061ca7b719acf63a43784e4a386fb6d694
# Form: product of slopes
# Operations: 120
def sensitivities_slopes(
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
    """Compute `sensitivities` by another form: product of slopes.

        [-engaged_atan2*l_DE*l_LM*(1 - cos(turn_3_atan2))*sin(alpha_DE +
            turn_3_atan2)*cos(alpha_LM + turn_7_atan2)/(BC_length*l_KL*sin(alpha_KL +
            turn_7_atan2))]
        [engaged_atan2*l_DE*l_LM*sin(turn_3_atan2)*sin(alpha_DE + turn_3_atan2)*cos(alpha_LM +
            turn_7_atan2)/(BC_length*l_KL*sin(alpha_KL + turn_7_atan2))]
        [-engaged_atan2*l_DE*l_LM*(1 - cos(turn_3_atan2))*sin(alpha_DE +
            turn_3_atan2)*cos(alpha_LM + turn_7_atan2)/(BC_length*l_KL*sin(alpha_KL +
            turn_7_atan2))]
        [engaged_atan2*l_LM*(cos(alpha_DE + turn_3_atan2) - cos(alpha_DE))*cos(alpha_LM +
            turn_7_atan2)/(l_KL*sin(alpha_KL + turn_7_atan2))]
        [-engaged_atan2*l_LM*cos(alpha_LM + turn_7_atan2)/(l_KL*sin(alpha_KL + turn_7_atan2))]
        [engaged_atan2*l_LM*(cos(alpha_KL + turn_7_atan2) - cos(alpha_KL))*cos(alpha_LM +
            turn_7_atan2)/(l_KL*sin(alpha_KL + turn_7_atan2))]
        [engaged_atan2*(sin(alpha_LM + turn_7_atan2) - sin(alpha_LM))]
        [engaged_atan2*l_DE*l_LM*(sin(alpha_DE) - sin(alpha_DE + turn_3_atan2))*cos(alpha_LM +
            turn_7_atan2)/(l_KL*sin(alpha_KL + turn_7_atan2))]
        [engaged_atan2*l_LM*(sin(alpha_KL)/sin(alpha_KL + turn_7_atan2) - 1)*cos(alpha_LM +
            turn_7_atan2)]
        [engaged_atan2*l_LM*(cos(alpha_LM + turn_7_atan2) - cos(alpha_LM))]

    Symbols without an equation here: see the module.

    Stage by stage, at the angles of the chain with atan2.

    Same domain as `sensitivities`, the radicand of Q is positive; alpha_KL = 2 arctan(kappa) in
    [0, pi), KL upwards.

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
        _check_of_position_printed, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_KL
    )
    return _in_blocks(
        _form_of_sensitivities_slopes,
        (x1,),
        _prepare_of_sensitivities_slopes,
        (l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM),
        out=out,
        shape=(10,),
        quiet=True,
    )


def _prepare_of_sensitivities_slopes(
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
    l_BC_squared = _square(l_BC)
    cos_alpha_KL = _np.cos(alpha_KL)

    return (
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
        l_BC_squared,
        cos_alpha_KL,
    )


def _form_of_sensitivities_slopes(
    x1: Any,
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
    l_BC_squared: Any,
    cos_alpha_KL: Any,
) -> Any:
    term = 2.0 * l_AB + 2.0 * l_CD + x1
    Q = _np.sqrt(_square(_square(l_BC)) + l_BC_squared * term * x1)
    turn_3_atan2 = _np.arctan2(
        l_BC_squared * l_AB + l_CD * (l_BC_squared - Q) - Q * (l_AB + x1),
        l_BC * (Q + (l_AB + l_CD) * (l_AB + l_CD + x1)),
    )
    term_7 = alpha_DE + turn_3_atan2
    term_2 = _np.cos(term_7) - _np.cos(alpha_DE)
    travel_5_atan2 = l_DE * term_2
    engaged_atan2 = _choose_where(travel_5_atan2 < l_GH, 0.0, 1.0)
    driven_5_atan2 = _maximum(0.0, travel_5_atan2 - l_GH)
    KL_x_atan2 = cos_alpha_KL * l_KL - driven_5_atan2
    turn_7_atan2 = _np.arctan2(_np.sqrt(_square(l_KL) - _square(KL_x_atan2)), KL_x_atan2) - alpha_KL
    term_8 = alpha_KL + turn_7_atan2
    term_3 = 1.0 / _np.sin(term_8)
    term_4 = 1.0 - _np.cos(turn_3_atan2)
    term_9 = alpha_LM + turn_7_atan2
    term_5 = _np.cos(term_9)
    term_6 = _np.sin(term_7)
    BC_length = _np.sqrt(l_BC_squared + term * x1)

    return (
        -l_DE * l_LM / (l_KL * BC_length) * engaged_atan2 * term_3 * term_4 * term_5 * term_6,
        l_DE
        * l_LM
        / (l_KL * BC_length)
        * engaged_atan2
        * term_3
        * term_5
        * term_6
        * _np.sin(turn_3_atan2),
        -l_DE * l_LM / (l_KL * BC_length) * engaged_atan2 * term_3 * term_4 * term_5 * term_6,
        l_LM / l_KL * engaged_atan2 * term_2 * term_3 * term_5,
        -l_LM / l_KL * engaged_atan2 * term_3 * term_5,
        l_LM / l_KL * engaged_atan2 * term_3 * term_5 * (_np.cos(term_8) - cos_alpha_KL),
        engaged_atan2 * (_np.sin(term_9) - _np.sin(alpha_LM)),
        l_DE * l_LM / l_KL * engaged_atan2 * term_3 * term_5 * (_np.sin(alpha_DE) - term_6),
        l_LM * engaged_atan2 * term_5 * (_np.sin(alpha_KL) * term_3 - 1.0),
        l_LM * engaged_atan2 * (term_5 - _np.cos(alpha_LM)),
    )
