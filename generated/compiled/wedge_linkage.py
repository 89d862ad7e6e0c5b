"""Compiled kernels of the system `wedge_linkage`: one loop for each, by numba.

Names, arguments, domains, NaN and errors are those of `mechproof.kernels.wedge_linkage`,
and so are the formulas. Numbers and NumPy arrays are taken. With numbers,
kernels can be called inside functions that numba compiles; arguments with components are then
indexed, and so are results.

Tests hold them to the same accuracy bounds. What help says is proved of rounding errors
is proved of these kernels where it says `compiled`, and of the NumPy kernels elsewhere.

Elementary functions: `elementary` 8db31d8544f3.

Generated from mechproof.derivations.wedge_linkage with SymPy 1.14.0.
Regenerate with `mechproof regenerate`; edits are overwritten.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy import float64, ndarray
from numpy.typing import ArrayLike, NDArray

from mechproof.compiled_support import (
    BLOCK,
    Loops,
    choose,
    has_nan,
    is_finite,
    loop,
    maximum,
    overload,
    run,
    scalar,
    take_row,
    widen,
)
from mechproof.kernels.compiled import elementary

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


def __dir__() -> list[str]:
    return __all__


@scalar
def _prepare_guide_radicand(l_AB, l_BC, l_CD):

    return (l_AB, l_BC, l_CD)


@scalar
def _guide_radicand(x1, l_AB, l_BC, l_CD):

    return l_BC**2 + x1 * (2 * l_AB + 2 * l_CD + x1)


@scalar
def _guide_radicand_at(x1, l_AB, l_BC, l_CD):
    if not (
        (l_AB > 0) & is_finite(l_AB) & (l_BC > 0) & is_finite(l_BC) & (l_CD > 0) & is_finite(l_CD)
    ):
        return math.nan
    prepared = _prepare_guide_radicand(l_AB, l_BC, l_CD)
    return _guide_radicand(x1, *prepared)


@scalar
def _guide_radicand_point(x1, l_AB, l_BC, l_CD):
    return _guide_radicand_at(x1, l_AB, l_BC, l_CD)


@loop
def _row_guide_radicand(
    out,
    x1_values,
    l_AB,
    l_BC,
    l_CD,
):
    widen()
    for i in range(out.size):
        x1 = float64(x1_values[i])

        value = _guide_radicand_at(x1, l_AB, l_BC, l_CD)
        out[i] = value


@loop
def _fill_guide_radicand(
    out,
    x1_values,
    l_AB,
    l_BC,
    l_CD,
):
    _row_guide_radicand(
        out,
        x1_values,
        l_AB,
        l_BC,
        l_CD,
    )


@loop
def _row_each_guide_radicand(
    out,
    x1_values,
    l_AB_values,
    l_BC_values,
    l_CD_values,
):
    widen()
    for i in range(out.size):
        x1 = float64(x1_values[i])

        l_AB = float64(l_AB_values[i])

        l_BC = float64(l_BC_values[i])

        l_CD = float64(l_CD_values[i])

        value = _guide_radicand_at(x1, l_AB, l_BC, l_CD)
        out[i] = value


@loop
def _fill_each_guide_radicand(
    out,
    x1_values,
    l_AB_values,
    l_BC_values,
    l_CD_values,
):
    _row_each_guide_radicand(
        out,
        x1_values,
        l_AB_values,
        l_BC_values,
        l_CD_values,
    )


def guide_radicand(
    x1: ArrayLike,
    l_AB: ArrayLike,
    l_BC: ArrayLike,
    l_CD: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute the radicand of Q, the square of BC: the guide follows where it is not negative.

    Compiled. The help of `mechproof.kernels.wedge_linkage.guide_radicand` has all words.
    """
    if type(l_AB) is type(l_BC) is type(l_CD) is float:
        if type(x1) is ndarray:
            row = take_row(x1, out)
            if row is not None:
                _GUIDE_RADICAND.fill(row, x1, l_AB, l_BC, l_CD)
                return row
        elif type(x1) is float and out is None:
            return float64(_GUIDE_RADICAND.point(x1, l_AB, l_BC, l_CD))
    return run(
        _GUIDE_RADICAND,
        (
            x1,
            l_AB,
            l_BC,
            l_CD,
        ),
        out,
    )


_GUIDE_RADICAND = Loops(
    names=(
        "x1",
        "l_AB",
        "l_BC",
        "l_CD",
    ),
    widths=(
        0,
        0,
        0,
        0,
    ),
    shape=(),
    at=_guide_radicand_point,
    uniform=_fill_guide_radicand,
    each=_fill_each_guide_radicand,
)


@overload(guide_radicand)
def _offer_guide_radicand(
    x1,
    l_AB,
    l_BC,
    l_CD,
):
    return lambda x1, l_AB, l_BC, l_CD: _guide_radicand_point(
        float64(x1),
        float64(l_AB),
        float64(l_BC),
        float64(l_CD),
    )


@scalar
def _prepare_lever_angle(l_AB, l_BC, l_CD):
    arm = l_AB + l_CD

    return (l_BC, arm)


@scalar
def _lever_angle(x1, l_BC, arm):
    guide_length = np.sqrt(l_BC**2 + x1 * (2 * arm + x1))
    guide_sum = guide_length + l_BC

    return -2 * elementary.arctan_quotient(x1, guide_sum)


@scalar
def _lever_angle_at(x1, l_AB, l_BC, l_CD):
    if not (
        (l_AB > 0) & is_finite(l_AB) & (l_BC > 0) & is_finite(l_BC) & (l_CD > 0) & is_finite(l_CD)
    ):
        return math.nan
    prepared = _prepare_lever_angle(l_AB, l_BC, l_CD)
    return _lever_angle(x1, *prepared)


@scalar
def _lever_angle_point(x1, l_AB, l_BC, l_CD):
    return _lever_angle_at(x1, l_AB, l_BC, l_CD)


@loop
def _row_lever_angle(
    out,
    x1_values,
    l_AB,
    l_BC,
    l_CD,
):
    widen()
    for i in range(out.size):
        x1 = float64(x1_values[i])

        value = _lever_angle_at(x1, l_AB, l_BC, l_CD)
        out[i] = value


@loop
def _fill_lever_angle(
    out,
    x1_values,
    l_AB,
    l_BC,
    l_CD,
):
    _row_lever_angle(
        out,
        x1_values,
        l_AB,
        l_BC,
        l_CD,
    )


@loop
def _row_each_lever_angle(
    out,
    x1_values,
    l_AB_values,
    l_BC_values,
    l_CD_values,
):
    widen()
    for i in range(out.size):
        x1 = float64(x1_values[i])

        l_AB = float64(l_AB_values[i])

        l_BC = float64(l_BC_values[i])

        l_CD = float64(l_CD_values[i])

        value = _lever_angle_at(x1, l_AB, l_BC, l_CD)
        out[i] = value


@loop
def _fill_each_lever_angle(
    out,
    x1_values,
    l_AB_values,
    l_BC_values,
    l_CD_values,
):
    _row_each_lever_angle(
        out,
        x1_values,
        l_AB_values,
        l_BC_values,
        l_CD_values,
    )


def lever_angle(
    x1: ArrayLike,
    l_AB: ArrayLike,
    l_BC: ArrayLike,
    l_CD: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute the rotation phi3 of the lever.

    Compiled. The help of `mechproof.kernels.wedge_linkage.lever_angle` has all words.
    """
    if type(l_AB) is type(l_BC) is type(l_CD) is float:
        if type(x1) is ndarray:
            row = take_row(x1, out)
            if row is not None:
                _LEVER_ANGLE.fill(row, x1, l_AB, l_BC, l_CD)
                return row
        elif type(x1) is float and out is None:
            return float64(_LEVER_ANGLE.point(x1, l_AB, l_BC, l_CD))
    return run(
        _LEVER_ANGLE,
        (
            x1,
            l_AB,
            l_BC,
            l_CD,
        ),
        out,
    )


_LEVER_ANGLE = Loops(
    names=(
        "x1",
        "l_AB",
        "l_BC",
        "l_CD",
    ),
    widths=(
        0,
        0,
        0,
        0,
    ),
    shape=(),
    at=_lever_angle_point,
    uniform=_fill_lever_angle,
    each=_fill_each_lever_angle,
)


@overload(lever_angle)
def _offer_lever_angle(
    x1,
    l_AB,
    l_BC,
    l_CD,
):
    return lambda x1, l_AB, l_BC, l_CD: _lever_angle_point(
        float64(x1),
        float64(l_AB),
        float64(l_BC),
        float64(l_CD),
    )


@scalar
def _prepare_rod_displacement(l_DE, alpha_DE, exact):

    return (l_DE, alpha_DE)


@scalar
def _rod_displacement(phi3, l_DE, alpha_DE, exact):

    return -2 * l_DE * elementary.sin(phi3 / 2, exact) * elementary.sin(alpha_DE + phi3 / 2, exact)


@scalar
def _rod_displacement_at(phi3, l_DE, alpha_DE, exact):
    if not ((l_DE > 0) & is_finite(l_DE)):
        return math.nan
    prepared = _prepare_rod_displacement(l_DE, alpha_DE, exact)
    return _rod_displacement(phi3, *prepared, exact)


@scalar
def _rod_displacement_point(phi3, l_DE, alpha_DE):
    return _rod_displacement_at(phi3, l_DE, alpha_DE, True)


@loop
def _row_rod_displacement(out, phi3_values, l_DE, alpha_DE, exact):
    widen()
    for i in range(out.size):
        phi3 = float64(phi3_values[i])

        value = _rod_displacement_at(phi3, l_DE, alpha_DE, exact)
        out[i] = value


@loop
def _fill_rod_displacement(
    out,
    phi3_values,
    l_DE,
    alpha_DE,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi3_block = phi3_values[start:stop]
        _row_rod_displacement(out_block, phi3_block, l_DE, alpha_DE, None)
        if has_nan(out_block):
            _row_rod_displacement(out_block, phi3_block, l_DE, alpha_DE, True)


@loop
def _row_each_rod_displacement(out, phi3_values, l_DE_values, alpha_DE_values, exact):
    widen()
    for i in range(out.size):
        phi3 = float64(phi3_values[i])

        l_DE = float64(l_DE_values[i])

        alpha_DE = float64(alpha_DE_values[i])

        value = _rod_displacement_at(phi3, l_DE, alpha_DE, exact)
        out[i] = value


@loop
def _fill_each_rod_displacement(
    out,
    phi3_values,
    l_DE_values,
    alpha_DE_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi3_block = phi3_values[start:stop]
        l_DE_block = l_DE_values[start:stop]
        alpha_DE_block = alpha_DE_values[start:stop]
        _row_each_rod_displacement(out_block, phi3_block, l_DE_block, alpha_DE_block, None)
        if has_nan(out_block):
            _row_each_rod_displacement(out_block, phi3_block, l_DE_block, alpha_DE_block, True)


def rod_displacement(
    phi3: ArrayLike, l_DE: ArrayLike, alpha_DE: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the displacement x5 of the rod.

    Compiled. The help of `mechproof.kernels.wedge_linkage.rod_displacement` has all words.
    """
    if type(l_DE) is type(alpha_DE) is float:
        if type(phi3) is ndarray:
            row = take_row(phi3, out)
            if row is not None:
                _ROD_DISPLACEMENT.fill(row, phi3, l_DE, alpha_DE)
                return row
        elif type(phi3) is float and out is None:
            return float64(_ROD_DISPLACEMENT.point(phi3, l_DE, alpha_DE))
    return run(
        _ROD_DISPLACEMENT,
        (
            phi3,
            l_DE,
            alpha_DE,
        ),
        out,
    )


_ROD_DISPLACEMENT = Loops(
    names=(
        "phi3",
        "l_DE",
        "alpha_DE",
    ),
    widths=(
        0,
        0,
        0,
    ),
    shape=(),
    at=_rod_displacement_point,
    uniform=_fill_rod_displacement,
    each=_fill_each_rod_displacement,
)


@overload(rod_displacement)
def _offer_rod_displacement(
    phi3,
    l_DE,
    alpha_DE,
):
    return lambda phi3, l_DE, alpha_DE: _rod_displacement_point(
        float64(phi3),
        float64(l_DE),
        float64(alpha_DE),
    )


@scalar
def _prepare_clearance(l_GH):

    return (l_GH,)


@scalar
def _clearance(x5, l_GH):

    return maximum(0, x5 - l_GH)


@scalar
def _clearance_at(x5, l_GH):
    if not ((l_GH > 0) & is_finite(l_GH)):
        return math.nan
    prepared = _prepare_clearance(l_GH)
    return _clearance(x5, *prepared)


@scalar
def _clearance_point(x5, l_GH):
    return _clearance_at(x5, l_GH)


@loop
def _row_clearance(
    out,
    x5_values,
    l_GH,
):
    widen()
    for i in range(out.size):
        x5 = float64(x5_values[i])

        value = _clearance_at(x5, l_GH)
        out[i] = value


@loop
def _fill_clearance(
    out,
    x5_values,
    l_GH,
):
    _row_clearance(
        out,
        x5_values,
        l_GH,
    )


@loop
def _row_each_clearance(
    out,
    x5_values,
    l_GH_values,
):
    widen()
    for i in range(out.size):
        x5 = float64(x5_values[i])

        l_GH = float64(l_GH_values[i])

        value = _clearance_at(x5, l_GH)
        out[i] = value


@loop
def _fill_each_clearance(
    out,
    x5_values,
    l_GH_values,
):
    _row_each_clearance(
        out,
        x5_values,
        l_GH_values,
    )


def clearance(x5: ArrayLike, l_GH: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the displacement x5' of the pushed link after the clearance.

    Compiled. The help of `mechproof.kernels.wedge_linkage.clearance` has all words.
    """
    if type(l_GH) is float:
        if type(x5) is ndarray:
            row = take_row(x5, out)
            if row is not None:
                _CLEARANCE.fill(row, x5, l_GH)
                return row
        elif type(x5) is float and out is None:
            return float64(_CLEARANCE.point(x5, l_GH))
    return run(
        _CLEARANCE,
        (
            x5,
            l_GH,
        ),
        out,
    )


_CLEARANCE = Loops(
    names=(
        "x5",
        "l_GH",
    ),
    widths=(
        0,
        0,
    ),
    shape=(),
    at=_clearance_point,
    uniform=_fill_clearance,
    each=_fill_each_clearance,
)


@overload(clearance)
def _offer_clearance(
    x5,
    l_GH,
):
    return lambda x5, l_GH: _clearance_point(
        float64(x5),
        float64(l_GH),
    )


@scalar
def _prepare_roller_offset(l_KL, alpha_KL, exact):

    return (l_KL, alpha_KL)


@scalar
def _roller_offset(x5, l_KL, alpha_KL, exact):

    return l_KL * elementary.cos(alpha_KL, exact) - x5


@scalar
def _roller_offset_at(x5, l_KL, alpha_KL, exact):
    if not ((l_KL > 0) & is_finite(l_KL) & (alpha_KL > 0) & (alpha_KL < np.pi)):
        return math.nan
    prepared = _prepare_roller_offset(l_KL, alpha_KL, exact)
    return _roller_offset(x5, *prepared, exact)


@scalar
def _roller_offset_point(x5, l_KL, alpha_KL):
    return _roller_offset_at(x5, l_KL, alpha_KL, True)


@loop
def _row_roller_offset(out, x5_values, l_KL, alpha_KL, exact):
    widen()
    for i in range(out.size):
        x5 = float64(x5_values[i])

        value = _roller_offset_at(x5, l_KL, alpha_KL, exact)
        out[i] = value


@loop
def _fill_roller_offset(
    out,
    x5_values,
    l_KL,
    alpha_KL,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        x5_block = x5_values[start:stop]
        _row_roller_offset(out_block, x5_block, l_KL, alpha_KL, None)
        if has_nan(out_block):
            _row_roller_offset(out_block, x5_block, l_KL, alpha_KL, True)


@loop
def _row_each_roller_offset(out, x5_values, l_KL_values, alpha_KL_values, exact):
    widen()
    for i in range(out.size):
        x5 = float64(x5_values[i])

        l_KL = float64(l_KL_values[i])

        alpha_KL = float64(alpha_KL_values[i])

        value = _roller_offset_at(x5, l_KL, alpha_KL, exact)
        out[i] = value


@loop
def _fill_each_roller_offset(
    out,
    x5_values,
    l_KL_values,
    alpha_KL_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        x5_block = x5_values[start:stop]
        l_KL_block = l_KL_values[start:stop]
        alpha_KL_block = alpha_KL_values[start:stop]
        _row_each_roller_offset(out_block, x5_block, l_KL_block, alpha_KL_block, None)
        if has_nan(out_block):
            _row_each_roller_offset(out_block, x5_block, l_KL_block, alpha_KL_block, True)


def roller_offset(
    x5: ArrayLike, l_KL: ArrayLike, alpha_KL: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute R, the projection of KL on Ox: the roller lever follows where |R| <= l_KL.

    Compiled. The help of `mechproof.kernels.wedge_linkage.roller_offset` has all words.
    """
    if type(l_KL) is type(alpha_KL) is float:
        if type(x5) is ndarray:
            row = take_row(x5, out)
            if row is not None:
                _ROLLER_OFFSET.fill(row, x5, l_KL, alpha_KL)
                return row
        elif type(x5) is float and out is None:
            return float64(_ROLLER_OFFSET.point(x5, l_KL, alpha_KL))
    return run(
        _ROLLER_OFFSET,
        (
            x5,
            l_KL,
            alpha_KL,
        ),
        out,
    )


_ROLLER_OFFSET = Loops(
    names=(
        "x5",
        "l_KL",
        "alpha_KL",
    ),
    widths=(
        0,
        0,
        0,
    ),
    shape=(),
    at=_roller_offset_point,
    uniform=_fill_roller_offset,
    each=_fill_each_roller_offset,
)


@overload(roller_offset)
def _offer_roller_offset(
    x5,
    l_KL,
    alpha_KL,
):
    return lambda x5, l_KL, alpha_KL: _roller_offset_point(
        float64(x5),
        float64(l_KL),
        float64(alpha_KL),
    )


@scalar
def _prepare_roller_lever_angle(l_KL, alpha_KL, exact):

    return (l_KL, alpha_KL)


@scalar
def _roller_lever_angle(x5, l_KL, alpha_KL, exact):

    return 2 * elementary.arctan_quotient(
        x5,
        l_KL * elementary.sin(alpha_KL, exact)
        + np.sqrt(
            (x5 + 2 * l_KL * elementary.sin(alpha_KL / 2, exact) ** 2)
            * (2 * l_KL * elementary.cos(alpha_KL / 2, exact) ** 2 - x5)
        ),
    )


@scalar
def _roller_lever_angle_at(x5, l_KL, alpha_KL, exact):
    if not ((l_KL > 0) & is_finite(l_KL) & (alpha_KL > 0) & (alpha_KL < np.pi)):
        return math.nan
    prepared = _prepare_roller_lever_angle(l_KL, alpha_KL, exact)
    return _roller_lever_angle(x5, *prepared, exact)


@scalar
def _roller_lever_angle_point(x5, l_KL, alpha_KL):
    return _roller_lever_angle_at(x5, l_KL, alpha_KL, True)


@loop
def _row_roller_lever_angle(out, x5_values, l_KL, alpha_KL, exact):
    widen()
    for i in range(out.size):
        x5 = float64(x5_values[i])

        value = _roller_lever_angle_at(x5, l_KL, alpha_KL, exact)
        out[i] = value


@loop
def _fill_roller_lever_angle(
    out,
    x5_values,
    l_KL,
    alpha_KL,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        x5_block = x5_values[start:stop]
        _row_roller_lever_angle(out_block, x5_block, l_KL, alpha_KL, None)
        if has_nan(out_block):
            _row_roller_lever_angle(out_block, x5_block, l_KL, alpha_KL, True)


@loop
def _row_each_roller_lever_angle(out, x5_values, l_KL_values, alpha_KL_values, exact):
    widen()
    for i in range(out.size):
        x5 = float64(x5_values[i])

        l_KL = float64(l_KL_values[i])

        alpha_KL = float64(alpha_KL_values[i])

        value = _roller_lever_angle_at(x5, l_KL, alpha_KL, exact)
        out[i] = value


@loop
def _fill_each_roller_lever_angle(
    out,
    x5_values,
    l_KL_values,
    alpha_KL_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        x5_block = x5_values[start:stop]
        l_KL_block = l_KL_values[start:stop]
        alpha_KL_block = alpha_KL_values[start:stop]
        _row_each_roller_lever_angle(out_block, x5_block, l_KL_block, alpha_KL_block, None)
        if has_nan(out_block):
            _row_each_roller_lever_angle(out_block, x5_block, l_KL_block, alpha_KL_block, True)


def roller_lever_angle(
    x5: ArrayLike, l_KL: ArrayLike, alpha_KL: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the rotation phi7 of the roller lever.

    Compiled. The help of `mechproof.kernels.wedge_linkage.roller_lever_angle` has all words.
    """
    if type(l_KL) is type(alpha_KL) is float:
        if type(x5) is ndarray:
            row = take_row(x5, out)
            if row is not None:
                _ROLLER_LEVER_ANGLE.fill(row, x5, l_KL, alpha_KL)
                return row
        elif type(x5) is float and out is None:
            return float64(_ROLLER_LEVER_ANGLE.point(x5, l_KL, alpha_KL))
    return run(
        _ROLLER_LEVER_ANGLE,
        (
            x5,
            l_KL,
            alpha_KL,
        ),
        out,
    )


_ROLLER_LEVER_ANGLE = Loops(
    names=(
        "x5",
        "l_KL",
        "alpha_KL",
    ),
    widths=(
        0,
        0,
        0,
    ),
    shape=(),
    at=_roller_lever_angle_point,
    uniform=_fill_roller_lever_angle,
    each=_fill_each_roller_lever_angle,
)


@overload(roller_lever_angle)
def _offer_roller_lever_angle(
    x5,
    l_KL,
    alpha_KL,
):
    return lambda x5, l_KL, alpha_KL: _roller_lever_angle_point(
        float64(x5),
        float64(l_KL),
        float64(alpha_KL),
    )


@scalar
def _prepare_wedge_displacement(l_LM, alpha_LM, exact):

    return (l_LM, alpha_LM)


@scalar
def _wedge_displacement(phi7, l_LM, alpha_LM, exact):

    return 2 * l_LM * elementary.cos(alpha_LM + phi7 / 2, exact) * elementary.sin(phi7 / 2, exact)


@scalar
def _wedge_displacement_at(phi7, l_LM, alpha_LM, exact):
    if not ((l_LM > 0) & is_finite(l_LM)):
        return math.nan
    prepared = _prepare_wedge_displacement(l_LM, alpha_LM, exact)
    return _wedge_displacement(phi7, *prepared, exact)


@scalar
def _wedge_displacement_point(phi7, l_LM, alpha_LM):
    return _wedge_displacement_at(phi7, l_LM, alpha_LM, True)


@loop
def _row_wedge_displacement(out, phi7_values, l_LM, alpha_LM, exact):
    widen()
    for i in range(out.size):
        phi7 = float64(phi7_values[i])

        value = _wedge_displacement_at(phi7, l_LM, alpha_LM, exact)
        out[i] = value


@loop
def _fill_wedge_displacement(
    out,
    phi7_values,
    l_LM,
    alpha_LM,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi7_block = phi7_values[start:stop]
        _row_wedge_displacement(out_block, phi7_block, l_LM, alpha_LM, None)
        if has_nan(out_block):
            _row_wedge_displacement(out_block, phi7_block, l_LM, alpha_LM, True)


@loop
def _row_each_wedge_displacement(out, phi7_values, l_LM_values, alpha_LM_values, exact):
    widen()
    for i in range(out.size):
        phi7 = float64(phi7_values[i])

        l_LM = float64(l_LM_values[i])

        alpha_LM = float64(alpha_LM_values[i])

        value = _wedge_displacement_at(phi7, l_LM, alpha_LM, exact)
        out[i] = value


@loop
def _fill_each_wedge_displacement(
    out,
    phi7_values,
    l_LM_values,
    alpha_LM_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        phi7_block = phi7_values[start:stop]
        l_LM_block = l_LM_values[start:stop]
        alpha_LM_block = alpha_LM_values[start:stop]
        _row_each_wedge_displacement(out_block, phi7_block, l_LM_block, alpha_LM_block, None)
        if has_nan(out_block):
            _row_each_wedge_displacement(out_block, phi7_block, l_LM_block, alpha_LM_block, True)


def wedge_displacement(
    phi7: ArrayLike, l_LM: ArrayLike, alpha_LM: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the displacement y9 of the wedge.

    Compiled. The help of `mechproof.kernels.wedge_linkage.wedge_displacement` has all words.
    """
    if type(l_LM) is type(alpha_LM) is float:
        if type(phi7) is ndarray:
            row = take_row(phi7, out)
            if row is not None:
                _WEDGE_DISPLACEMENT.fill(row, phi7, l_LM, alpha_LM)
                return row
        elif type(phi7) is float and out is None:
            return float64(_WEDGE_DISPLACEMENT.point(phi7, l_LM, alpha_LM))
    return run(
        _WEDGE_DISPLACEMENT,
        (
            phi7,
            l_LM,
            alpha_LM,
        ),
        out,
    )


_WEDGE_DISPLACEMENT = Loops(
    names=(
        "phi7",
        "l_LM",
        "alpha_LM",
    ),
    widths=(
        0,
        0,
        0,
    ),
    shape=(),
    at=_wedge_displacement_point,
    uniform=_fill_wedge_displacement,
    each=_fill_each_wedge_displacement,
)


@overload(wedge_displacement)
def _offer_wedge_displacement(
    phi7,
    l_LM,
    alpha_LM,
):
    return lambda phi7, l_LM, alpha_LM: _wedge_displacement_point(
        float64(phi7),
        float64(l_LM),
        float64(alpha_LM),
    )


@scalar
def _prepare_position(
    l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, exact
):
    arm = l_AB + l_CD
    sin_DE = elementary.sin(alpha_DE, exact)
    cos_DE = elementary.cos(alpha_DE, exact)
    to_right = 2 * l_KL * elementary.sin(alpha_KL / 2, exact) ** 2
    to_left = 2 * l_KL * elementary.cos(alpha_KL / 2, exact) ** 2
    start_height = l_KL * elementary.sin(alpha_KL, exact)
    cos_LM = elementary.cos(alpha_LM, exact)
    sin_LM = elementary.sin(alpha_LM, exact)

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


@scalar
def _position(
    x1,
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
    exact,
):
    guide_length = np.sqrt(l_BC**2 + x1 * (2 * arm + x1))
    guide_sum = guide_length + l_BC
    lever_square = guide_sum**2 + x1**2
    run = 2 * l_DE / lever_square * x1 * (sin_DE * guide_sum - cos_DE * x1)
    push = maximum(0, run - l_GH)
    rise = np.sqrt((push + to_right) * (to_left - push))
    rise_sum = rise + start_height
    roller_square = push**2 + rise_sum**2

    return 2 * l_LM / roller_square * push * (cos_LM * rise_sum - sin_LM * push)


@scalar
def _position_at(x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, exact):
    if not (
        (l_AB > 0)
        & is_finite(l_AB)
        & (l_BC > 0)
        & is_finite(l_BC)
        & (l_CD > 0)
        & is_finite(l_CD)
        & (l_DE > 0)
        & is_finite(l_DE)
        & (l_GH > 0)
        & is_finite(l_GH)
        & (l_KL > 0)
        & is_finite(l_KL)
        & (l_LM > 0)
        & is_finite(l_LM)
        & (alpha_KL > 0)
        & (alpha_KL < np.pi)
    ):
        return math.nan
    prepared = _prepare_position(
        l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, exact
    )
    return _position(x1, *prepared, exact)


@scalar
def _position_point(x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM):
    return _position_at(
        x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, True
    )


@loop
def _row_position(
    out, x1_values, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, exact
):
    widen()
    for i in range(out.size):
        x1 = float64(x1_values[i])

        value = _position_at(
            x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, exact
        )
        out[i] = value


@loop
def _fill_position(
    out,
    x1_values,
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
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        x1_block = x1_values[start:stop]
        _row_position(
            out_block,
            x1_block,
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
            None,
        )
        if has_nan(out_block):
            _row_position(
                out_block,
                x1_block,
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
                True,
            )


@loop
def _row_each_position(
    out,
    x1_values,
    l_AB_values,
    l_BC_values,
    l_CD_values,
    l_DE_values,
    l_GH_values,
    l_KL_values,
    l_LM_values,
    alpha_DE_values,
    alpha_KL_values,
    alpha_LM_values,
    exact,
):
    widen()
    for i in range(out.size):
        x1 = float64(x1_values[i])

        l_AB = float64(l_AB_values[i])

        l_BC = float64(l_BC_values[i])

        l_CD = float64(l_CD_values[i])

        l_DE = float64(l_DE_values[i])

        l_GH = float64(l_GH_values[i])

        l_KL = float64(l_KL_values[i])

        l_LM = float64(l_LM_values[i])

        alpha_DE = float64(alpha_DE_values[i])

        alpha_KL = float64(alpha_KL_values[i])

        alpha_LM = float64(alpha_LM_values[i])

        value = _position_at(
            x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, exact
        )
        out[i] = value


@loop
def _fill_each_position(
    out,
    x1_values,
    l_AB_values,
    l_BC_values,
    l_CD_values,
    l_DE_values,
    l_GH_values,
    l_KL_values,
    l_LM_values,
    alpha_DE_values,
    alpha_KL_values,
    alpha_LM_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        x1_block = x1_values[start:stop]
        l_AB_block = l_AB_values[start:stop]
        l_BC_block = l_BC_values[start:stop]
        l_CD_block = l_CD_values[start:stop]
        l_DE_block = l_DE_values[start:stop]
        l_GH_block = l_GH_values[start:stop]
        l_KL_block = l_KL_values[start:stop]
        l_LM_block = l_LM_values[start:stop]
        alpha_DE_block = alpha_DE_values[start:stop]
        alpha_KL_block = alpha_KL_values[start:stop]
        alpha_LM_block = alpha_LM_values[start:stop]
        _row_each_position(
            out_block,
            x1_block,
            l_AB_block,
            l_BC_block,
            l_CD_block,
            l_DE_block,
            l_GH_block,
            l_KL_block,
            l_LM_block,
            alpha_DE_block,
            alpha_KL_block,
            alpha_LM_block,
            None,
        )
        if has_nan(out_block):
            _row_each_position(
                out_block,
                x1_block,
                l_AB_block,
                l_BC_block,
                l_CD_block,
                l_DE_block,
                l_GH_block,
                l_KL_block,
                l_LM_block,
                alpha_DE_block,
                alpha_KL_block,
                alpha_LM_block,
                True,
            )


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

    Compiled. The help of `mechproof.kernels.wedge_linkage.position` has all words.
    """
    if (
        type(l_AB)
        is type(l_BC)
        is type(l_CD)
        is type(l_DE)
        is type(l_GH)
        is type(l_KL)
        is type(l_LM)
        is type(alpha_DE)
        is type(alpha_KL)
        is type(alpha_LM)
        is float
    ):
        if type(x1) is ndarray:
            row = take_row(x1, out)
            if row is not None:
                _POSITION.fill(
                    row, x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM
                )
                return row
        elif type(x1) is float and out is None:
            return float64(
                _POSITION.point(
                    x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM
                )
            )
    return run(
        _POSITION,
        (
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
        ),
        out,
    )


_POSITION = Loops(
    names=(
        "x1",
        "l_AB",
        "l_BC",
        "l_CD",
        "l_DE",
        "l_GH",
        "l_KL",
        "l_LM",
        "alpha_DE",
        "alpha_KL",
        "alpha_LM",
    ),
    widths=(
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
    ),
    shape=(),
    at=_position_point,
    uniform=_fill_position,
    each=_fill_each_position,
)


@overload(position)
def _offer_position(
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
):
    return lambda x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM: (
        _position_point(
            float64(x1),
            float64(l_AB),
            float64(l_BC),
            float64(l_CD),
            float64(l_DE),
            float64(l_GH),
            float64(l_KL),
            float64(l_LM),
            float64(alpha_DE),
            float64(alpha_KL),
            float64(alpha_LM),
        )
    )


@scalar
def _prepare_velocity(
    l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, exact
):
    arm = l_AB + l_CD
    sin_DE = elementary.sin(alpha_DE, exact)
    cos_DE = elementary.cos(alpha_DE, exact)
    to_right = 2 * l_KL * elementary.sin(alpha_KL / 2, exact) ** 2
    to_left = 2 * l_KL * elementary.cos(alpha_KL / 2, exact) ** 2
    start_height = l_KL * elementary.sin(alpha_KL, exact)
    cos_LM = elementary.cos(alpha_LM, exact)
    sin_LM = elementary.sin(alpha_LM, exact)

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


@scalar
def _velocity(
    x1,
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
    exact,
):
    guide_length = np.sqrt(l_BC**2 + x1 * (2 * arm + x1))
    guide_sum = guide_length + l_BC
    lever_square = guide_sum**2 + x1**2
    cos_lever = (2 * arm * x1 + 2 * l_BC * guide_sum) / lever_square
    run = 2 * l_DE / lever_square * x1 * (sin_DE * guide_sum - cos_DE * x1)
    push = maximum(0, run - l_GH)
    rise = np.sqrt((push + to_right) * (to_left - push))
    rise_sum = rise + start_height
    roller_square = push**2 + rise_sum**2
    cos_wedge = (
        cos_LM * (push + rise_sum) * (rise_sum - push) - 2 * sin_LM * push * rise_sum
    ) / roller_square
    gain = cos_wedge * choose(run < l_GH, 0, l_LM) / rise
    sin_arm = sin_DE * cos_lever - 2 * cos_DE / lever_square * guide_sum * x1

    return l_DE / guide_length * cos_lever * gain * sin_arm


@scalar
def _velocity_at(x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, exact):
    if not (
        (l_AB > 0)
        & is_finite(l_AB)
        & (l_BC > 0)
        & is_finite(l_BC)
        & (l_CD > 0)
        & is_finite(l_CD)
        & (l_DE > 0)
        & is_finite(l_DE)
        & (l_GH > 0)
        & is_finite(l_GH)
        & (l_KL > 0)
        & is_finite(l_KL)
        & (l_LM > 0)
        & is_finite(l_LM)
        & (alpha_KL > 0)
        & (alpha_KL < np.pi)
    ):
        return math.nan
    prepared = _prepare_velocity(
        l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, exact
    )
    return _velocity(x1, *prepared, exact)


@scalar
def _velocity_point(x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM):
    return _velocity_at(
        x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, True
    )


@loop
def _row_velocity(
    out, x1_values, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, exact
):
    widen()
    for i in range(out.size):
        x1 = float64(x1_values[i])

        value = _velocity_at(
            x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, exact
        )
        out[i] = value


@loop
def _fill_velocity(
    out,
    x1_values,
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
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        x1_block = x1_values[start:stop]
        _row_velocity(
            out_block,
            x1_block,
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
            None,
        )
        if has_nan(out_block):
            _row_velocity(
                out_block,
                x1_block,
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
                True,
            )


@loop
def _row_each_velocity(
    out,
    x1_values,
    l_AB_values,
    l_BC_values,
    l_CD_values,
    l_DE_values,
    l_GH_values,
    l_KL_values,
    l_LM_values,
    alpha_DE_values,
    alpha_KL_values,
    alpha_LM_values,
    exact,
):
    widen()
    for i in range(out.size):
        x1 = float64(x1_values[i])

        l_AB = float64(l_AB_values[i])

        l_BC = float64(l_BC_values[i])

        l_CD = float64(l_CD_values[i])

        l_DE = float64(l_DE_values[i])

        l_GH = float64(l_GH_values[i])

        l_KL = float64(l_KL_values[i])

        l_LM = float64(l_LM_values[i])

        alpha_DE = float64(alpha_DE_values[i])

        alpha_KL = float64(alpha_KL_values[i])

        alpha_LM = float64(alpha_LM_values[i])

        value = _velocity_at(
            x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, exact
        )
        out[i] = value


@loop
def _fill_each_velocity(
    out,
    x1_values,
    l_AB_values,
    l_BC_values,
    l_CD_values,
    l_DE_values,
    l_GH_values,
    l_KL_values,
    l_LM_values,
    alpha_DE_values,
    alpha_KL_values,
    alpha_LM_values,
):
    for start in range(0, out.size, BLOCK):
        stop = start + BLOCK
        out_block = out[start:stop]
        x1_block = x1_values[start:stop]
        l_AB_block = l_AB_values[start:stop]
        l_BC_block = l_BC_values[start:stop]
        l_CD_block = l_CD_values[start:stop]
        l_DE_block = l_DE_values[start:stop]
        l_GH_block = l_GH_values[start:stop]
        l_KL_block = l_KL_values[start:stop]
        l_LM_block = l_LM_values[start:stop]
        alpha_DE_block = alpha_DE_values[start:stop]
        alpha_KL_block = alpha_KL_values[start:stop]
        alpha_LM_block = alpha_LM_values[start:stop]
        _row_each_velocity(
            out_block,
            x1_block,
            l_AB_block,
            l_BC_block,
            l_CD_block,
            l_DE_block,
            l_GH_block,
            l_KL_block,
            l_LM_block,
            alpha_DE_block,
            alpha_KL_block,
            alpha_LM_block,
            None,
        )
        if has_nan(out_block):
            _row_each_velocity(
                out_block,
                x1_block,
                l_AB_block,
                l_BC_block,
                l_CD_block,
                l_DE_block,
                l_GH_block,
                l_KL_block,
                l_LM_block,
                alpha_DE_block,
                alpha_KL_block,
                alpha_LM_block,
                True,
            )


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

    Compiled. The help of `mechproof.kernels.wedge_linkage.velocity` has all words.
    """
    if (
        type(l_AB)
        is type(l_BC)
        is type(l_CD)
        is type(l_DE)
        is type(l_GH)
        is type(l_KL)
        is type(l_LM)
        is type(alpha_DE)
        is type(alpha_KL)
        is type(alpha_LM)
        is float
    ):
        if type(x1) is ndarray:
            row = take_row(x1, out)
            if row is not None:
                _VELOCITY.fill(
                    row, x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM
                )
                return row
        elif type(x1) is float and out is None:
            return float64(
                _VELOCITY.point(
                    x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM
                )
            )
    return run(
        _VELOCITY,
        (
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
        ),
        out,
    )


_VELOCITY = Loops(
    names=(
        "x1",
        "l_AB",
        "l_BC",
        "l_CD",
        "l_DE",
        "l_GH",
        "l_KL",
        "l_LM",
        "alpha_DE",
        "alpha_KL",
        "alpha_LM",
    ),
    widths=(
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
    ),
    shape=(),
    at=_velocity_point,
    uniform=_fill_velocity,
    each=_fill_each_velocity,
)


@overload(velocity)
def _offer_velocity(
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
):
    return lambda x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM: (
        _velocity_point(
            float64(x1),
            float64(l_AB),
            float64(l_BC),
            float64(l_CD),
            float64(l_DE),
            float64(l_GH),
            float64(l_KL),
            float64(l_LM),
            float64(alpha_DE),
            float64(alpha_KL),
            float64(alpha_LM),
        )
    )


@scalar
def _prepare_sensitivities(
    l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, exact
):
    arm = l_AB + l_CD
    sin_DE = elementary.sin(alpha_DE, exact)
    cos_DE = elementary.cos(alpha_DE, exact)
    to_right = 2 * l_KL * elementary.sin(alpha_KL / 2, exact) ** 2
    to_left = 2 * l_KL * elementary.cos(alpha_KL / 2, exact) ** 2
    start_height = l_KL * elementary.sin(alpha_KL, exact)
    cos_LM = elementary.cos(alpha_LM, exact)
    sin_LM = elementary.sin(alpha_LM, exact)

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


@scalar
def _sensitivities(
    x1,
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
    exact,
):
    x1_squared = x1**2
    guide_length = np.sqrt(l_BC**2 + x1 * (2 * arm + x1))
    guide_sum = guide_length + l_BC
    lever_square = guide_sum**2 + x1_squared
    run = 2 * l_DE / lever_square * x1 * (sin_DE * guide_sum - cos_DE * x1)
    push = maximum(0, run - l_GH)
    rise = np.sqrt((push + to_right) * (to_left - push))
    rise_sum = rise + start_height
    roller_square = push**2 + rise_sum**2
    cos_wedge = (
        cos_LM * (push + rise_sum) * (rise_sum - push) - 2 * sin_LM * push * rise_sum
    ) / roller_square
    gain = cos_wedge * choose(run < l_GH, 0, l_LM) / rise
    cos_lever = (2 * arm * x1 + 2 * l_BC * guide_sum) / lever_square
    sin_arm = sin_DE * cos_lever - 2 * cos_DE / lever_square * guide_sum * x1
    term = -2 * l_DE / (guide_length * lever_square) * gain * sin_arm * x1_squared

    return (
        term,
        -2 * l_DE / (guide_length * lever_square) * gain * guide_sum * sin_arm * x1,
        term,
        gain * run / l_DE,
        -gain,
        -gain * push / l_KL,
        2 / roller_square * push * (cos_LM * rise_sum - sin_LM * push),
        2 * l_DE / lever_square * gain * x1 * (cos_DE * guide_sum + sin_DE * x1),
        gain * push * (push + to_right - to_left) / rise_sum,
        -2 * l_LM / roller_square * push * (cos_LM * push + sin_LM * rise_sum),
    )


@scalar
def _sensitivities_at(
    x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, exact
):
    if not (
        (l_AB > 0)
        & is_finite(l_AB)
        & (l_BC > 0)
        & is_finite(l_BC)
        & (l_CD > 0)
        & is_finite(l_CD)
        & (l_DE > 0)
        & is_finite(l_DE)
        & (l_GH > 0)
        & is_finite(l_GH)
        & (l_KL > 0)
        & is_finite(l_KL)
        & (l_LM > 0)
        & is_finite(l_LM)
        & (alpha_KL > 0)
        & (alpha_KL < np.pi)
    ):
        return (
            math.nan,
            math.nan,
            math.nan,
            math.nan,
            math.nan,
            math.nan,
            math.nan,
            math.nan,
            math.nan,
            math.nan,
        )
    prepared = _prepare_sensitivities(
        l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, exact
    )
    return _sensitivities(x1, *prepared, exact)


@scalar
def _sensitivities_point(
    x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM
):
    return _sensitivities_at(
        x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, True
    )


@loop
def _row_sensitivities(
    out, x1_values, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, exact
):
    widen()
    for i in range(out.size // 10):
        x1 = float64(x1_values[i])

        value = _sensitivities_at(
            x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, exact
        )
        out[10 * i + 0] = value[0]
        out[10 * i + 1] = value[1]
        out[10 * i + 2] = value[2]
        out[10 * i + 3] = value[3]
        out[10 * i + 4] = value[4]
        out[10 * i + 5] = value[5]
        out[10 * i + 6] = value[6]
        out[10 * i + 7] = value[7]
        out[10 * i + 8] = value[8]
        out[10 * i + 9] = value[9]


@loop
def _fill_sensitivities(
    out,
    x1_values,
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
):
    for start in range(0, out.size // 10, BLOCK):
        stop = start + BLOCK
        out_block = out[10 * start : 10 * stop]
        x1_block = x1_values[start:stop]
        _row_sensitivities(
            out_block,
            x1_block,
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
            None,
        )
        if has_nan(out_block):
            _row_sensitivities(
                out_block,
                x1_block,
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
                True,
            )


@loop
def _row_each_sensitivities(
    out,
    x1_values,
    l_AB_values,
    l_BC_values,
    l_CD_values,
    l_DE_values,
    l_GH_values,
    l_KL_values,
    l_LM_values,
    alpha_DE_values,
    alpha_KL_values,
    alpha_LM_values,
    exact,
):
    widen()
    for i in range(out.size // 10):
        x1 = float64(x1_values[i])

        l_AB = float64(l_AB_values[i])

        l_BC = float64(l_BC_values[i])

        l_CD = float64(l_CD_values[i])

        l_DE = float64(l_DE_values[i])

        l_GH = float64(l_GH_values[i])

        l_KL = float64(l_KL_values[i])

        l_LM = float64(l_LM_values[i])

        alpha_DE = float64(alpha_DE_values[i])

        alpha_KL = float64(alpha_KL_values[i])

        alpha_LM = float64(alpha_LM_values[i])

        value = _sensitivities_at(
            x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, exact
        )
        out[10 * i + 0] = value[0]
        out[10 * i + 1] = value[1]
        out[10 * i + 2] = value[2]
        out[10 * i + 3] = value[3]
        out[10 * i + 4] = value[4]
        out[10 * i + 5] = value[5]
        out[10 * i + 6] = value[6]
        out[10 * i + 7] = value[7]
        out[10 * i + 8] = value[8]
        out[10 * i + 9] = value[9]


@loop
def _fill_each_sensitivities(
    out,
    x1_values,
    l_AB_values,
    l_BC_values,
    l_CD_values,
    l_DE_values,
    l_GH_values,
    l_KL_values,
    l_LM_values,
    alpha_DE_values,
    alpha_KL_values,
    alpha_LM_values,
):
    for start in range(0, out.size // 10, BLOCK):
        stop = start + BLOCK
        out_block = out[10 * start : 10 * stop]
        x1_block = x1_values[start:stop]
        l_AB_block = l_AB_values[start:stop]
        l_BC_block = l_BC_values[start:stop]
        l_CD_block = l_CD_values[start:stop]
        l_DE_block = l_DE_values[start:stop]
        l_GH_block = l_GH_values[start:stop]
        l_KL_block = l_KL_values[start:stop]
        l_LM_block = l_LM_values[start:stop]
        alpha_DE_block = alpha_DE_values[start:stop]
        alpha_KL_block = alpha_KL_values[start:stop]
        alpha_LM_block = alpha_LM_values[start:stop]
        _row_each_sensitivities(
            out_block,
            x1_block,
            l_AB_block,
            l_BC_block,
            l_CD_block,
            l_DE_block,
            l_GH_block,
            l_KL_block,
            l_LM_block,
            alpha_DE_block,
            alpha_KL_block,
            alpha_LM_block,
            None,
        )
        if has_nan(out_block):
            _row_each_sensitivities(
                out_block,
                x1_block,
                l_AB_block,
                l_BC_block,
                l_CD_block,
                l_DE_block,
                l_GH_block,
                l_KL_block,
                l_LM_block,
                alpha_DE_block,
                alpha_KL_block,
                alpha_LM_block,
                True,
            )


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
) -> Any:
    """Compute the derivatives of y9 by the sizes, in the order of the arguments.

    Compiled. The help of `mechproof.kernels.wedge_linkage.sensitivities` has all words.
    """
    return run(
        _SENSITIVITIES,
        (
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
        ),
        out,
    )


_SENSITIVITIES = Loops(
    names=(
        "x1",
        "l_AB",
        "l_BC",
        "l_CD",
        "l_DE",
        "l_GH",
        "l_KL",
        "l_LM",
        "alpha_DE",
        "alpha_KL",
        "alpha_LM",
    ),
    widths=(
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
    ),
    shape=(10,),
    at=_sensitivities_point,
    uniform=_fill_sensitivities,
    each=_fill_each_sensitivities,
)


@overload(sensitivities)
def _offer_sensitivities(
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
):
    return lambda x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM: (
        _sensitivities_point(
            float64(x1),
            float64(l_AB),
            float64(l_BC),
            float64(l_CD),
            float64(l_DE),
            float64(l_GH),
            float64(l_KL),
            float64(l_LM),
            float64(alpha_DE),
            float64(alpha_KL),
            float64(alpha_LM),
        )
    )
