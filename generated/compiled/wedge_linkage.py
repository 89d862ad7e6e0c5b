"""Compiled kernels of the system `wedge_linkage`: one loop for each, by numba.

Names, arguments, domains, NaN and errors are those of `mechproof.kernels.wedge_linkage`,
and so are the formulas. Numbers and NumPy arrays are taken. With numbers,
kernels can be called inside functions that numba compiles; arguments with components are then
indexed, and so are results.

Tests hold them to the same accuracy bounds. What help says is proved of rounding errors
is proved of these kernels where it says `compiled`, and of the NumPy kernels elsewhere.

Elementary functions: `elementary` 4aa7b0fd5d8b.

Generated from mechproof.derivations.wedge_linkage with SymPy 1.14.0.
Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""

from __future__ import annotations

import math as _math
from builtins import float as _float, range as _range, type as _type
from typing import Any

import numpy as _np
from numpy import float64 as _float64, ndarray as _ndarray
from numpy.typing import ArrayLike, NDArray

from mechproof.compiled_support import (
    BLOCK as _BLOCK,
    Loops as _Loops,
    choose as _choose,
    has_nan as _has_nan,
    is_finite as _is_finite,
    loop as _loop,
    maximum as _maximum,
    overload as _overload,
    run as _run,
    scalar as _scalar,
    take_row as _take_row,
    widen as _widen,
)
from mechproof.kernels.compiled import elementary as _elementary

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


@_scalar
def _prepare_of_guide_radicand(l_AB, l_BC, l_CD):

    return (l_AB, l_BC, l_CD)


@_scalar
def _form_of_guide_radicand(x1, l_AB, l_BC, l_CD):

    return l_BC**2 + x1 * (2 * l_AB + 2 * l_CD + x1)


@_scalar
def _value_of_guide_radicand(x1, l_AB, l_BC, l_CD):
    if not (
        (l_AB > 0)
        & _is_finite(l_AB)
        & (l_BC > 0)
        & _is_finite(l_BC)
        & (l_CD > 0)
        & _is_finite(l_CD)
    ):
        return _math.nan
    _prepared = _prepare_of_guide_radicand(l_AB, l_BC, l_CD)
    return _form_of_guide_radicand(x1, *_prepared)


@_scalar
def _point_of_guide_radicand(x1, l_AB, l_BC, l_CD):
    return _value_of_guide_radicand(x1, l_AB, l_BC, l_CD)


@_loop
def _row_of_guide_radicand(
    _out,
    _values_of_x1,
    l_AB,
    l_BC,
    l_CD,
):
    _widen()
    for _i in _range(_out.size):
        x1 = _float64(_values_of_x1[_i])

        _value = _value_of_guide_radicand(x1, l_AB, l_BC, l_CD)
        _out[_i] = _value


@_loop
def _fill_of_guide_radicand(
    _out,
    _values_of_x1,
    l_AB,
    l_BC,
    l_CD,
):
    _row_of_guide_radicand(
        _out,
        _values_of_x1,
        l_AB,
        l_BC,
        l_CD,
    )


@_loop
def _row_each_of_guide_radicand(
    _out,
    _values_of_x1,
    _values_of_l_AB,
    _values_of_l_BC,
    _values_of_l_CD,
):
    _widen()
    for _i in _range(_out.size):
        x1 = _float64(_values_of_x1[_i])

        l_AB = _float64(_values_of_l_AB[_i])

        l_BC = _float64(_values_of_l_BC[_i])

        l_CD = _float64(_values_of_l_CD[_i])

        _value = _value_of_guide_radicand(x1, l_AB, l_BC, l_CD)
        _out[_i] = _value


@_loop
def _fill_each_of_guide_radicand(
    _out,
    _values_of_x1,
    _values_of_l_AB,
    _values_of_l_BC,
    _values_of_l_CD,
):
    _row_each_of_guide_radicand(
        _out,
        _values_of_x1,
        _values_of_l_AB,
        _values_of_l_BC,
        _values_of_l_CD,
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
    if _type(l_AB) is _type(l_BC) is _type(l_CD) is _float:
        if _type(x1) is _ndarray:
            _row = _take_row(x1, out)
            if _row is not None:
                _loops_of_guide_radicand.fill(_row, x1, l_AB, l_BC, l_CD)
                return _row
        elif _type(x1) is _float and out is None:
            return _float64(_loops_of_guide_radicand.point(x1, l_AB, l_BC, l_CD))
    return _run(
        _loops_of_guide_radicand,
        (
            x1,
            l_AB,
            l_BC,
            l_CD,
        ),
        out,
    )


_loops_of_guide_radicand = _Loops(
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
    at=_point_of_guide_radicand,
    uniform=_fill_of_guide_radicand,
    each=_fill_each_of_guide_radicand,
)


@_overload(guide_radicand)
def _offer_of_guide_radicand(
    x1,
    l_AB,
    l_BC,
    l_CD,
):
    return lambda x1, l_AB, l_BC, l_CD: _point_of_guide_radicand(
        _float64(x1),
        _float64(l_AB),
        _float64(l_BC),
        _float64(l_CD),
    )


@_scalar
def _prepare_of_lever_angle(l_AB, l_BC, l_CD):
    arm = l_AB + l_CD

    return (l_BC, arm)


@_scalar
def _form_of_lever_angle(x1, l_BC, arm):
    guide_length = _np.sqrt(l_BC**2 + x1 * (2 * arm + x1))
    guide_sum = guide_length + l_BC

    return -2 * _elementary.arctan_quotient(x1, guide_sum)


@_scalar
def _value_of_lever_angle(x1, l_AB, l_BC, l_CD):
    if not (
        (l_AB > 0)
        & _is_finite(l_AB)
        & (l_BC > 0)
        & _is_finite(l_BC)
        & (l_CD > 0)
        & _is_finite(l_CD)
    ):
        return _math.nan
    _prepared = _prepare_of_lever_angle(l_AB, l_BC, l_CD)
    return _form_of_lever_angle(x1, *_prepared)


@_scalar
def _point_of_lever_angle(x1, l_AB, l_BC, l_CD):
    return _value_of_lever_angle(x1, l_AB, l_BC, l_CD)


@_loop
def _row_of_lever_angle(
    _out,
    _values_of_x1,
    l_AB,
    l_BC,
    l_CD,
):
    _widen()
    for _i in _range(_out.size):
        x1 = _float64(_values_of_x1[_i])

        _value = _value_of_lever_angle(x1, l_AB, l_BC, l_CD)
        _out[_i] = _value


@_loop
def _fill_of_lever_angle(
    _out,
    _values_of_x1,
    l_AB,
    l_BC,
    l_CD,
):
    _row_of_lever_angle(
        _out,
        _values_of_x1,
        l_AB,
        l_BC,
        l_CD,
    )


@_loop
def _row_each_of_lever_angle(
    _out,
    _values_of_x1,
    _values_of_l_AB,
    _values_of_l_BC,
    _values_of_l_CD,
):
    _widen()
    for _i in _range(_out.size):
        x1 = _float64(_values_of_x1[_i])

        l_AB = _float64(_values_of_l_AB[_i])

        l_BC = _float64(_values_of_l_BC[_i])

        l_CD = _float64(_values_of_l_CD[_i])

        _value = _value_of_lever_angle(x1, l_AB, l_BC, l_CD)
        _out[_i] = _value


@_loop
def _fill_each_of_lever_angle(
    _out,
    _values_of_x1,
    _values_of_l_AB,
    _values_of_l_BC,
    _values_of_l_CD,
):
    _row_each_of_lever_angle(
        _out,
        _values_of_x1,
        _values_of_l_AB,
        _values_of_l_BC,
        _values_of_l_CD,
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
    if _type(l_AB) is _type(l_BC) is _type(l_CD) is _float:
        if _type(x1) is _ndarray:
            _row = _take_row(x1, out)
            if _row is not None:
                _loops_of_lever_angle.fill(_row, x1, l_AB, l_BC, l_CD)
                return _row
        elif _type(x1) is _float and out is None:
            return _float64(_loops_of_lever_angle.point(x1, l_AB, l_BC, l_CD))
    return _run(
        _loops_of_lever_angle,
        (
            x1,
            l_AB,
            l_BC,
            l_CD,
        ),
        out,
    )


_loops_of_lever_angle = _Loops(
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
    at=_point_of_lever_angle,
    uniform=_fill_of_lever_angle,
    each=_fill_each_of_lever_angle,
)


@_overload(lever_angle)
def _offer_of_lever_angle(
    x1,
    l_AB,
    l_BC,
    l_CD,
):
    return lambda x1, l_AB, l_BC, l_CD: _point_of_lever_angle(
        _float64(x1),
        _float64(l_AB),
        _float64(l_BC),
        _float64(l_CD),
    )


@_scalar
def _prepare_of_rod_displacement(l_DE, alpha_DE, _exact):

    return (l_DE, alpha_DE)


@_scalar
def _form_of_rod_displacement(phi3, l_DE, alpha_DE, _exact):

    return (
        -2 * l_DE * _elementary.sin(phi3 / 2, _exact) * _elementary.sin(alpha_DE + phi3 / 2, _exact)
    )


@_scalar
def _value_of_rod_displacement(phi3, l_DE, alpha_DE, _exact):
    if not ((l_DE > 0) & _is_finite(l_DE)):
        return _math.nan
    _prepared = _prepare_of_rod_displacement(l_DE, alpha_DE, _exact)
    return _form_of_rod_displacement(phi3, *_prepared, _exact)


@_scalar
def _point_of_rod_displacement(phi3, l_DE, alpha_DE):
    return _value_of_rod_displacement(phi3, l_DE, alpha_DE, True)


@_loop
def _row_of_rod_displacement(_out, _values_of_phi3, l_DE, alpha_DE, _exact):
    _widen()
    for _i in _range(_out.size):
        phi3 = _float64(_values_of_phi3[_i])

        _value = _value_of_rod_displacement(phi3, l_DE, alpha_DE, _exact)
        _out[_i] = _value


@_loop
def _fill_of_rod_displacement(
    _out,
    _values_of_phi3,
    l_DE,
    alpha_DE,
):
    for _start in _range(0, _out.size, _BLOCK):
        _stop = _start + _BLOCK
        _out_block = _out[_start:_stop]
        _block_of_phi3 = _values_of_phi3[_start:_stop]
        _row_of_rod_displacement(_out_block, _block_of_phi3, l_DE, alpha_DE, None)
        if _has_nan(_out_block):
            _row_of_rod_displacement(_out_block, _block_of_phi3, l_DE, alpha_DE, True)


@_loop
def _row_each_of_rod_displacement(
    _out, _values_of_phi3, _values_of_l_DE, _values_of_alpha_DE, _exact
):
    _widen()
    for _i in _range(_out.size):
        phi3 = _float64(_values_of_phi3[_i])

        l_DE = _float64(_values_of_l_DE[_i])

        alpha_DE = _float64(_values_of_alpha_DE[_i])

        _value = _value_of_rod_displacement(phi3, l_DE, alpha_DE, _exact)
        _out[_i] = _value


@_loop
def _fill_each_of_rod_displacement(
    _out,
    _values_of_phi3,
    _values_of_l_DE,
    _values_of_alpha_DE,
):
    for _start in _range(0, _out.size, _BLOCK):
        _stop = _start + _BLOCK
        _out_block = _out[_start:_stop]
        _block_of_phi3 = _values_of_phi3[_start:_stop]
        _block_of_l_DE = _values_of_l_DE[_start:_stop]
        _block_of_alpha_DE = _values_of_alpha_DE[_start:_stop]
        _row_each_of_rod_displacement(
            _out_block, _block_of_phi3, _block_of_l_DE, _block_of_alpha_DE, None
        )
        if _has_nan(_out_block):
            _row_each_of_rod_displacement(
                _out_block, _block_of_phi3, _block_of_l_DE, _block_of_alpha_DE, True
            )


def rod_displacement(
    phi3: ArrayLike, l_DE: ArrayLike, alpha_DE: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the displacement x5 of the rod.

    Compiled. The help of `mechproof.kernels.wedge_linkage.rod_displacement` has all words.
    """
    if _type(l_DE) is _type(alpha_DE) is _float:
        if _type(phi3) is _ndarray:
            _row = _take_row(phi3, out)
            if _row is not None:
                _loops_of_rod_displacement.fill(_row, phi3, l_DE, alpha_DE)
                return _row
        elif _type(phi3) is _float and out is None:
            return _float64(_loops_of_rod_displacement.point(phi3, l_DE, alpha_DE))
    return _run(
        _loops_of_rod_displacement,
        (
            phi3,
            l_DE,
            alpha_DE,
        ),
        out,
    )


_loops_of_rod_displacement = _Loops(
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
    at=_point_of_rod_displacement,
    uniform=_fill_of_rod_displacement,
    each=_fill_each_of_rod_displacement,
)


@_overload(rod_displacement)
def _offer_of_rod_displacement(
    phi3,
    l_DE,
    alpha_DE,
):
    return lambda phi3, l_DE, alpha_DE: _point_of_rod_displacement(
        _float64(phi3),
        _float64(l_DE),
        _float64(alpha_DE),
    )


@_scalar
def _prepare_of_clearance(l_GH):

    return (l_GH,)


@_scalar
def _form_of_clearance(x5, l_GH):

    return _maximum(0, x5 - l_GH)


@_scalar
def _value_of_clearance(x5, l_GH):
    if not ((l_GH > 0) & _is_finite(l_GH)):
        return _math.nan
    _prepared = _prepare_of_clearance(l_GH)
    return _form_of_clearance(x5, *_prepared)


@_scalar
def _point_of_clearance(x5, l_GH):
    return _value_of_clearance(x5, l_GH)


@_loop
def _row_of_clearance(
    _out,
    _values_of_x5,
    l_GH,
):
    _widen()
    for _i in _range(_out.size):
        x5 = _float64(_values_of_x5[_i])

        _value = _value_of_clearance(x5, l_GH)
        _out[_i] = _value


@_loop
def _fill_of_clearance(
    _out,
    _values_of_x5,
    l_GH,
):
    _row_of_clearance(
        _out,
        _values_of_x5,
        l_GH,
    )


@_loop
def _row_each_of_clearance(
    _out,
    _values_of_x5,
    _values_of_l_GH,
):
    _widen()
    for _i in _range(_out.size):
        x5 = _float64(_values_of_x5[_i])

        l_GH = _float64(_values_of_l_GH[_i])

        _value = _value_of_clearance(x5, l_GH)
        _out[_i] = _value


@_loop
def _fill_each_of_clearance(
    _out,
    _values_of_x5,
    _values_of_l_GH,
):
    _row_each_of_clearance(
        _out,
        _values_of_x5,
        _values_of_l_GH,
    )


def clearance(x5: ArrayLike, l_GH: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the displacement x5' of the pushed link after the clearance.

    Compiled. The help of `mechproof.kernels.wedge_linkage.clearance` has all words.
    """
    if _type(l_GH) is _float:
        if _type(x5) is _ndarray:
            _row = _take_row(x5, out)
            if _row is not None:
                _loops_of_clearance.fill(_row, x5, l_GH)
                return _row
        elif _type(x5) is _float and out is None:
            return _float64(_loops_of_clearance.point(x5, l_GH))
    return _run(
        _loops_of_clearance,
        (
            x5,
            l_GH,
        ),
        out,
    )


_loops_of_clearance = _Loops(
    names=(
        "x5",
        "l_GH",
    ),
    widths=(
        0,
        0,
    ),
    shape=(),
    at=_point_of_clearance,
    uniform=_fill_of_clearance,
    each=_fill_each_of_clearance,
)


@_overload(clearance)
def _offer_of_clearance(
    x5,
    l_GH,
):
    return lambda x5, l_GH: _point_of_clearance(
        _float64(x5),
        _float64(l_GH),
    )


@_scalar
def _prepare_of_roller_offset(l_KL, alpha_KL, _exact):

    return (l_KL, alpha_KL)


@_scalar
def _form_of_roller_offset(x5, l_KL, alpha_KL, _exact):

    return l_KL * _elementary.cos(alpha_KL, _exact) - x5


@_scalar
def _value_of_roller_offset(x5, l_KL, alpha_KL, _exact):
    if not ((l_KL > 0) & _is_finite(l_KL) & (alpha_KL > 0) & (alpha_KL < _np.pi)):
        return _math.nan
    _prepared = _prepare_of_roller_offset(l_KL, alpha_KL, _exact)
    return _form_of_roller_offset(x5, *_prepared, _exact)


@_scalar
def _point_of_roller_offset(x5, l_KL, alpha_KL):
    return _value_of_roller_offset(x5, l_KL, alpha_KL, True)


@_loop
def _row_of_roller_offset(_out, _values_of_x5, l_KL, alpha_KL, _exact):
    _widen()
    for _i in _range(_out.size):
        x5 = _float64(_values_of_x5[_i])

        _value = _value_of_roller_offset(x5, l_KL, alpha_KL, _exact)
        _out[_i] = _value


@_loop
def _fill_of_roller_offset(
    _out,
    _values_of_x5,
    l_KL,
    alpha_KL,
):
    for _start in _range(0, _out.size, _BLOCK):
        _stop = _start + _BLOCK
        _out_block = _out[_start:_stop]
        _block_of_x5 = _values_of_x5[_start:_stop]
        _row_of_roller_offset(_out_block, _block_of_x5, l_KL, alpha_KL, None)
        if _has_nan(_out_block):
            _row_of_roller_offset(_out_block, _block_of_x5, l_KL, alpha_KL, True)


@_loop
def _row_each_of_roller_offset(_out, _values_of_x5, _values_of_l_KL, _values_of_alpha_KL, _exact):
    _widen()
    for _i in _range(_out.size):
        x5 = _float64(_values_of_x5[_i])

        l_KL = _float64(_values_of_l_KL[_i])

        alpha_KL = _float64(_values_of_alpha_KL[_i])

        _value = _value_of_roller_offset(x5, l_KL, alpha_KL, _exact)
        _out[_i] = _value


@_loop
def _fill_each_of_roller_offset(
    _out,
    _values_of_x5,
    _values_of_l_KL,
    _values_of_alpha_KL,
):
    for _start in _range(0, _out.size, _BLOCK):
        _stop = _start + _BLOCK
        _out_block = _out[_start:_stop]
        _block_of_x5 = _values_of_x5[_start:_stop]
        _block_of_l_KL = _values_of_l_KL[_start:_stop]
        _block_of_alpha_KL = _values_of_alpha_KL[_start:_stop]
        _row_each_of_roller_offset(
            _out_block, _block_of_x5, _block_of_l_KL, _block_of_alpha_KL, None
        )
        if _has_nan(_out_block):
            _row_each_of_roller_offset(
                _out_block, _block_of_x5, _block_of_l_KL, _block_of_alpha_KL, True
            )


def roller_offset(
    x5: ArrayLike, l_KL: ArrayLike, alpha_KL: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute R, the projection of KL on Ox: the roller lever follows where |R| <= l_KL.

    Compiled. The help of `mechproof.kernels.wedge_linkage.roller_offset` has all words.
    """
    if _type(l_KL) is _type(alpha_KL) is _float:
        if _type(x5) is _ndarray:
            _row = _take_row(x5, out)
            if _row is not None:
                _loops_of_roller_offset.fill(_row, x5, l_KL, alpha_KL)
                return _row
        elif _type(x5) is _float and out is None:
            return _float64(_loops_of_roller_offset.point(x5, l_KL, alpha_KL))
    return _run(
        _loops_of_roller_offset,
        (
            x5,
            l_KL,
            alpha_KL,
        ),
        out,
    )


_loops_of_roller_offset = _Loops(
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
    at=_point_of_roller_offset,
    uniform=_fill_of_roller_offset,
    each=_fill_each_of_roller_offset,
)


@_overload(roller_offset)
def _offer_of_roller_offset(
    x5,
    l_KL,
    alpha_KL,
):
    return lambda x5, l_KL, alpha_KL: _point_of_roller_offset(
        _float64(x5),
        _float64(l_KL),
        _float64(alpha_KL),
    )


@_scalar
def _prepare_of_roller_lever_angle(l_KL, alpha_KL, _exact):

    return (l_KL, alpha_KL)


@_scalar
def _form_of_roller_lever_angle(x5, l_KL, alpha_KL, _exact):

    return 2 * _elementary.arctan_quotient(
        x5,
        l_KL * _elementary.sin(alpha_KL, _exact)
        + _np.sqrt(
            (x5 + 2 * l_KL * _elementary.sin(alpha_KL / 2, _exact) ** 2)
            * (2 * l_KL * _elementary.cos(alpha_KL / 2, _exact) ** 2 - x5)
        ),
    )


@_scalar
def _value_of_roller_lever_angle(x5, l_KL, alpha_KL, _exact):
    if not ((l_KL > 0) & _is_finite(l_KL) & (alpha_KL > 0) & (alpha_KL < _np.pi)):
        return _math.nan
    _prepared = _prepare_of_roller_lever_angle(l_KL, alpha_KL, _exact)
    return _form_of_roller_lever_angle(x5, *_prepared, _exact)


@_scalar
def _point_of_roller_lever_angle(x5, l_KL, alpha_KL):
    return _value_of_roller_lever_angle(x5, l_KL, alpha_KL, True)


@_loop
def _row_of_roller_lever_angle(_out, _values_of_x5, l_KL, alpha_KL, _exact):
    _widen()
    for _i in _range(_out.size):
        x5 = _float64(_values_of_x5[_i])

        _value = _value_of_roller_lever_angle(x5, l_KL, alpha_KL, _exact)
        _out[_i] = _value


@_loop
def _fill_of_roller_lever_angle(
    _out,
    _values_of_x5,
    l_KL,
    alpha_KL,
):
    for _start in _range(0, _out.size, _BLOCK):
        _stop = _start + _BLOCK
        _out_block = _out[_start:_stop]
        _block_of_x5 = _values_of_x5[_start:_stop]
        _row_of_roller_lever_angle(_out_block, _block_of_x5, l_KL, alpha_KL, None)
        if _has_nan(_out_block):
            _row_of_roller_lever_angle(_out_block, _block_of_x5, l_KL, alpha_KL, True)


@_loop
def _row_each_of_roller_lever_angle(
    _out, _values_of_x5, _values_of_l_KL, _values_of_alpha_KL, _exact
):
    _widen()
    for _i in _range(_out.size):
        x5 = _float64(_values_of_x5[_i])

        l_KL = _float64(_values_of_l_KL[_i])

        alpha_KL = _float64(_values_of_alpha_KL[_i])

        _value = _value_of_roller_lever_angle(x5, l_KL, alpha_KL, _exact)
        _out[_i] = _value


@_loop
def _fill_each_of_roller_lever_angle(
    _out,
    _values_of_x5,
    _values_of_l_KL,
    _values_of_alpha_KL,
):
    for _start in _range(0, _out.size, _BLOCK):
        _stop = _start + _BLOCK
        _out_block = _out[_start:_stop]
        _block_of_x5 = _values_of_x5[_start:_stop]
        _block_of_l_KL = _values_of_l_KL[_start:_stop]
        _block_of_alpha_KL = _values_of_alpha_KL[_start:_stop]
        _row_each_of_roller_lever_angle(
            _out_block, _block_of_x5, _block_of_l_KL, _block_of_alpha_KL, None
        )
        if _has_nan(_out_block):
            _row_each_of_roller_lever_angle(
                _out_block, _block_of_x5, _block_of_l_KL, _block_of_alpha_KL, True
            )


def roller_lever_angle(
    x5: ArrayLike, l_KL: ArrayLike, alpha_KL: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the rotation phi7 of the roller lever.

    Compiled. The help of `mechproof.kernels.wedge_linkage.roller_lever_angle` has all words.
    """
    if _type(l_KL) is _type(alpha_KL) is _float:
        if _type(x5) is _ndarray:
            _row = _take_row(x5, out)
            if _row is not None:
                _loops_of_roller_lever_angle.fill(_row, x5, l_KL, alpha_KL)
                return _row
        elif _type(x5) is _float and out is None:
            return _float64(_loops_of_roller_lever_angle.point(x5, l_KL, alpha_KL))
    return _run(
        _loops_of_roller_lever_angle,
        (
            x5,
            l_KL,
            alpha_KL,
        ),
        out,
    )


_loops_of_roller_lever_angle = _Loops(
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
    at=_point_of_roller_lever_angle,
    uniform=_fill_of_roller_lever_angle,
    each=_fill_each_of_roller_lever_angle,
)


@_overload(roller_lever_angle)
def _offer_of_roller_lever_angle(
    x5,
    l_KL,
    alpha_KL,
):
    return lambda x5, l_KL, alpha_KL: _point_of_roller_lever_angle(
        _float64(x5),
        _float64(l_KL),
        _float64(alpha_KL),
    )


@_scalar
def _prepare_of_wedge_displacement(l_LM, alpha_LM, _exact):

    return (l_LM, alpha_LM)


@_scalar
def _form_of_wedge_displacement(phi7, l_LM, alpha_LM, _exact):

    return (
        2 * l_LM * _elementary.cos(alpha_LM + phi7 / 2, _exact) * _elementary.sin(phi7 / 2, _exact)
    )


@_scalar
def _value_of_wedge_displacement(phi7, l_LM, alpha_LM, _exact):
    if not ((l_LM > 0) & _is_finite(l_LM)):
        return _math.nan
    _prepared = _prepare_of_wedge_displacement(l_LM, alpha_LM, _exact)
    return _form_of_wedge_displacement(phi7, *_prepared, _exact)


@_scalar
def _point_of_wedge_displacement(phi7, l_LM, alpha_LM):
    return _value_of_wedge_displacement(phi7, l_LM, alpha_LM, True)


@_loop
def _row_of_wedge_displacement(_out, _values_of_phi7, l_LM, alpha_LM, _exact):
    _widen()
    for _i in _range(_out.size):
        phi7 = _float64(_values_of_phi7[_i])

        _value = _value_of_wedge_displacement(phi7, l_LM, alpha_LM, _exact)
        _out[_i] = _value


@_loop
def _fill_of_wedge_displacement(
    _out,
    _values_of_phi7,
    l_LM,
    alpha_LM,
):
    for _start in _range(0, _out.size, _BLOCK):
        _stop = _start + _BLOCK
        _out_block = _out[_start:_stop]
        _block_of_phi7 = _values_of_phi7[_start:_stop]
        _row_of_wedge_displacement(_out_block, _block_of_phi7, l_LM, alpha_LM, None)
        if _has_nan(_out_block):
            _row_of_wedge_displacement(_out_block, _block_of_phi7, l_LM, alpha_LM, True)


@_loop
def _row_each_of_wedge_displacement(
    _out, _values_of_phi7, _values_of_l_LM, _values_of_alpha_LM, _exact
):
    _widen()
    for _i in _range(_out.size):
        phi7 = _float64(_values_of_phi7[_i])

        l_LM = _float64(_values_of_l_LM[_i])

        alpha_LM = _float64(_values_of_alpha_LM[_i])

        _value = _value_of_wedge_displacement(phi7, l_LM, alpha_LM, _exact)
        _out[_i] = _value


@_loop
def _fill_each_of_wedge_displacement(
    _out,
    _values_of_phi7,
    _values_of_l_LM,
    _values_of_alpha_LM,
):
    for _start in _range(0, _out.size, _BLOCK):
        _stop = _start + _BLOCK
        _out_block = _out[_start:_stop]
        _block_of_phi7 = _values_of_phi7[_start:_stop]
        _block_of_l_LM = _values_of_l_LM[_start:_stop]
        _block_of_alpha_LM = _values_of_alpha_LM[_start:_stop]
        _row_each_of_wedge_displacement(
            _out_block, _block_of_phi7, _block_of_l_LM, _block_of_alpha_LM, None
        )
        if _has_nan(_out_block):
            _row_each_of_wedge_displacement(
                _out_block, _block_of_phi7, _block_of_l_LM, _block_of_alpha_LM, True
            )


def wedge_displacement(
    phi7: ArrayLike, l_LM: ArrayLike, alpha_LM: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the displacement y9 of the wedge.

    Compiled. The help of `mechproof.kernels.wedge_linkage.wedge_displacement` has all words.
    """
    if _type(l_LM) is _type(alpha_LM) is _float:
        if _type(phi7) is _ndarray:
            _row = _take_row(phi7, out)
            if _row is not None:
                _loops_of_wedge_displacement.fill(_row, phi7, l_LM, alpha_LM)
                return _row
        elif _type(phi7) is _float and out is None:
            return _float64(_loops_of_wedge_displacement.point(phi7, l_LM, alpha_LM))
    return _run(
        _loops_of_wedge_displacement,
        (
            phi7,
            l_LM,
            alpha_LM,
        ),
        out,
    )


_loops_of_wedge_displacement = _Loops(
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
    at=_point_of_wedge_displacement,
    uniform=_fill_of_wedge_displacement,
    each=_fill_each_of_wedge_displacement,
)


@_overload(wedge_displacement)
def _offer_of_wedge_displacement(
    phi7,
    l_LM,
    alpha_LM,
):
    return lambda phi7, l_LM, alpha_LM: _point_of_wedge_displacement(
        _float64(phi7),
        _float64(l_LM),
        _float64(alpha_LM),
    )


@_scalar
def _prepare_of_position(
    l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, _exact
):
    arm = l_AB + l_CD
    sin_DE = _elementary.sin(alpha_DE, _exact)
    cos_DE = _elementary.cos(alpha_DE, _exact)
    to_right = 2 * l_KL * _elementary.sin(alpha_KL / 2, _exact) ** 2
    to_left = 2 * l_KL * _elementary.cos(alpha_KL / 2, _exact) ** 2
    start_height = l_KL * _elementary.sin(alpha_KL, _exact)
    cos_LM = _elementary.cos(alpha_LM, _exact)
    sin_LM = _elementary.sin(alpha_LM, _exact)

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


@_scalar
def _form_of_position(
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
    _exact,
):
    guide_length = _np.sqrt(l_BC**2 + x1 * (2 * arm + x1))
    guide_sum = guide_length + l_BC
    lever_square = guide_sum**2 + x1**2
    run = 2 * l_DE / lever_square * x1 * (sin_DE * guide_sum - cos_DE * x1)
    push = _maximum(0, run - l_GH)
    rise = _np.sqrt((push + to_right) * (to_left - push))
    rise_sum = rise + start_height
    roller_square = push**2 + rise_sum**2

    return 2 * l_LM / roller_square * push * (cos_LM * rise_sum - sin_LM * push)


@_scalar
def _value_of_position(
    x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, _exact
):
    if not (
        (l_AB > 0)
        & _is_finite(l_AB)
        & (l_BC > 0)
        & _is_finite(l_BC)
        & (l_CD > 0)
        & _is_finite(l_CD)
        & (l_DE > 0)
        & _is_finite(l_DE)
        & (l_GH > 0)
        & _is_finite(l_GH)
        & (l_KL > 0)
        & _is_finite(l_KL)
        & (l_LM > 0)
        & _is_finite(l_LM)
        & (alpha_KL > 0)
        & (alpha_KL < _np.pi)
    ):
        return _math.nan
    _prepared = _prepare_of_position(
        l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, _exact
    )
    return _form_of_position(x1, *_prepared, _exact)


@_scalar
def _point_of_position(x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM):
    return _value_of_position(
        x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, True
    )


@_loop
def _row_of_position(
    _out,
    _values_of_x1,
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
    _exact,
):
    _widen()
    for _i in _range(_out.size):
        x1 = _float64(_values_of_x1[_i])

        _value = _value_of_position(
            x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, _exact
        )
        _out[_i] = _value


@_loop
def _fill_of_position(
    _out,
    _values_of_x1,
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
    for _start in _range(0, _out.size, _BLOCK):
        _stop = _start + _BLOCK
        _out_block = _out[_start:_stop]
        _block_of_x1 = _values_of_x1[_start:_stop]
        _row_of_position(
            _out_block,
            _block_of_x1,
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
        if _has_nan(_out_block):
            _row_of_position(
                _out_block,
                _block_of_x1,
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


@_loop
def _row_each_of_position(
    _out,
    _values_of_x1,
    _values_of_l_AB,
    _values_of_l_BC,
    _values_of_l_CD,
    _values_of_l_DE,
    _values_of_l_GH,
    _values_of_l_KL,
    _values_of_l_LM,
    _values_of_alpha_DE,
    _values_of_alpha_KL,
    _values_of_alpha_LM,
    _exact,
):
    _widen()
    for _i in _range(_out.size):
        x1 = _float64(_values_of_x1[_i])

        l_AB = _float64(_values_of_l_AB[_i])

        l_BC = _float64(_values_of_l_BC[_i])

        l_CD = _float64(_values_of_l_CD[_i])

        l_DE = _float64(_values_of_l_DE[_i])

        l_GH = _float64(_values_of_l_GH[_i])

        l_KL = _float64(_values_of_l_KL[_i])

        l_LM = _float64(_values_of_l_LM[_i])

        alpha_DE = _float64(_values_of_alpha_DE[_i])

        alpha_KL = _float64(_values_of_alpha_KL[_i])

        alpha_LM = _float64(_values_of_alpha_LM[_i])

        _value = _value_of_position(
            x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, _exact
        )
        _out[_i] = _value


@_loop
def _fill_each_of_position(
    _out,
    _values_of_x1,
    _values_of_l_AB,
    _values_of_l_BC,
    _values_of_l_CD,
    _values_of_l_DE,
    _values_of_l_GH,
    _values_of_l_KL,
    _values_of_l_LM,
    _values_of_alpha_DE,
    _values_of_alpha_KL,
    _values_of_alpha_LM,
):
    for _start in _range(0, _out.size, _BLOCK):
        _stop = _start + _BLOCK
        _out_block = _out[_start:_stop]
        _block_of_x1 = _values_of_x1[_start:_stop]
        _block_of_l_AB = _values_of_l_AB[_start:_stop]
        _block_of_l_BC = _values_of_l_BC[_start:_stop]
        _block_of_l_CD = _values_of_l_CD[_start:_stop]
        _block_of_l_DE = _values_of_l_DE[_start:_stop]
        _block_of_l_GH = _values_of_l_GH[_start:_stop]
        _block_of_l_KL = _values_of_l_KL[_start:_stop]
        _block_of_l_LM = _values_of_l_LM[_start:_stop]
        _block_of_alpha_DE = _values_of_alpha_DE[_start:_stop]
        _block_of_alpha_KL = _values_of_alpha_KL[_start:_stop]
        _block_of_alpha_LM = _values_of_alpha_LM[_start:_stop]
        _row_each_of_position(
            _out_block,
            _block_of_x1,
            _block_of_l_AB,
            _block_of_l_BC,
            _block_of_l_CD,
            _block_of_l_DE,
            _block_of_l_GH,
            _block_of_l_KL,
            _block_of_l_LM,
            _block_of_alpha_DE,
            _block_of_alpha_KL,
            _block_of_alpha_LM,
            None,
        )
        if _has_nan(_out_block):
            _row_each_of_position(
                _out_block,
                _block_of_x1,
                _block_of_l_AB,
                _block_of_l_BC,
                _block_of_l_CD,
                _block_of_l_DE,
                _block_of_l_GH,
                _block_of_l_KL,
                _block_of_l_LM,
                _block_of_alpha_DE,
                _block_of_alpha_KL,
                _block_of_alpha_LM,
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
        _type(l_AB)
        is _type(l_BC)
        is _type(l_CD)
        is _type(l_DE)
        is _type(l_GH)
        is _type(l_KL)
        is _type(l_LM)
        is _type(alpha_DE)
        is _type(alpha_KL)
        is _type(alpha_LM)
        is _float
    ):
        if _type(x1) is _ndarray:
            _row = _take_row(x1, out)
            if _row is not None:
                _loops_of_position.fill(
                    _row, x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM
                )
                return _row
        elif _type(x1) is _float and out is None:
            return _float64(
                _loops_of_position.point(
                    x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM
                )
            )
    return _run(
        _loops_of_position,
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


_loops_of_position = _Loops(
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
    at=_point_of_position,
    uniform=_fill_of_position,
    each=_fill_each_of_position,
)


@_overload(position)
def _offer_of_position(
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
        _point_of_position(
            _float64(x1),
            _float64(l_AB),
            _float64(l_BC),
            _float64(l_CD),
            _float64(l_DE),
            _float64(l_GH),
            _float64(l_KL),
            _float64(l_LM),
            _float64(alpha_DE),
            _float64(alpha_KL),
            _float64(alpha_LM),
        )
    )


@_scalar
def _prepare_of_velocity(
    l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, _exact
):
    arm = l_AB + l_CD
    sin_DE = _elementary.sin(alpha_DE, _exact)
    cos_DE = _elementary.cos(alpha_DE, _exact)
    to_right = 2 * l_KL * _elementary.sin(alpha_KL / 2, _exact) ** 2
    to_left = 2 * l_KL * _elementary.cos(alpha_KL / 2, _exact) ** 2
    start_height = l_KL * _elementary.sin(alpha_KL, _exact)
    cos_LM = _elementary.cos(alpha_LM, _exact)
    sin_LM = _elementary.sin(alpha_LM, _exact)

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


@_scalar
def _form_of_velocity(
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
    _exact,
):
    guide_length = _np.sqrt(l_BC**2 + x1 * (2 * arm + x1))
    guide_sum = guide_length + l_BC
    lever_square = guide_sum**2 + x1**2
    cos_lever = (2 * arm * x1 + 2 * l_BC * guide_sum) / lever_square
    run = 2 * l_DE / lever_square * x1 * (sin_DE * guide_sum - cos_DE * x1)
    push = _maximum(0, run - l_GH)
    rise = _np.sqrt((push + to_right) * (to_left - push))
    rise_sum = rise + start_height
    roller_square = push**2 + rise_sum**2
    cos_wedge = (
        cos_LM * (push + rise_sum) * (rise_sum - push) - 2 * sin_LM * push * rise_sum
    ) / roller_square
    gain = cos_wedge * _choose(run < l_GH, 0, l_LM) / rise
    sin_arm = sin_DE * cos_lever - 2 * cos_DE / lever_square * guide_sum * x1

    return l_DE / guide_length * cos_lever * gain * sin_arm


@_scalar
def _value_of_velocity(
    x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, _exact
):
    if not (
        (l_AB > 0)
        & _is_finite(l_AB)
        & (l_BC > 0)
        & _is_finite(l_BC)
        & (l_CD > 0)
        & _is_finite(l_CD)
        & (l_DE > 0)
        & _is_finite(l_DE)
        & (l_GH > 0)
        & _is_finite(l_GH)
        & (l_KL > 0)
        & _is_finite(l_KL)
        & (l_LM > 0)
        & _is_finite(l_LM)
        & (alpha_KL > 0)
        & (alpha_KL < _np.pi)
    ):
        return _math.nan
    _prepared = _prepare_of_velocity(
        l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, _exact
    )
    return _form_of_velocity(x1, *_prepared, _exact)


@_scalar
def _point_of_velocity(x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM):
    return _value_of_velocity(
        x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, True
    )


@_loop
def _row_of_velocity(
    _out,
    _values_of_x1,
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
    _exact,
):
    _widen()
    for _i in _range(_out.size):
        x1 = _float64(_values_of_x1[_i])

        _value = _value_of_velocity(
            x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, _exact
        )
        _out[_i] = _value


@_loop
def _fill_of_velocity(
    _out,
    _values_of_x1,
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
    for _start in _range(0, _out.size, _BLOCK):
        _stop = _start + _BLOCK
        _out_block = _out[_start:_stop]
        _block_of_x1 = _values_of_x1[_start:_stop]
        _row_of_velocity(
            _out_block,
            _block_of_x1,
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
        if _has_nan(_out_block):
            _row_of_velocity(
                _out_block,
                _block_of_x1,
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


@_loop
def _row_each_of_velocity(
    _out,
    _values_of_x1,
    _values_of_l_AB,
    _values_of_l_BC,
    _values_of_l_CD,
    _values_of_l_DE,
    _values_of_l_GH,
    _values_of_l_KL,
    _values_of_l_LM,
    _values_of_alpha_DE,
    _values_of_alpha_KL,
    _values_of_alpha_LM,
    _exact,
):
    _widen()
    for _i in _range(_out.size):
        x1 = _float64(_values_of_x1[_i])

        l_AB = _float64(_values_of_l_AB[_i])

        l_BC = _float64(_values_of_l_BC[_i])

        l_CD = _float64(_values_of_l_CD[_i])

        l_DE = _float64(_values_of_l_DE[_i])

        l_GH = _float64(_values_of_l_GH[_i])

        l_KL = _float64(_values_of_l_KL[_i])

        l_LM = _float64(_values_of_l_LM[_i])

        alpha_DE = _float64(_values_of_alpha_DE[_i])

        alpha_KL = _float64(_values_of_alpha_KL[_i])

        alpha_LM = _float64(_values_of_alpha_LM[_i])

        _value = _value_of_velocity(
            x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, _exact
        )
        _out[_i] = _value


@_loop
def _fill_each_of_velocity(
    _out,
    _values_of_x1,
    _values_of_l_AB,
    _values_of_l_BC,
    _values_of_l_CD,
    _values_of_l_DE,
    _values_of_l_GH,
    _values_of_l_KL,
    _values_of_l_LM,
    _values_of_alpha_DE,
    _values_of_alpha_KL,
    _values_of_alpha_LM,
):
    for _start in _range(0, _out.size, _BLOCK):
        _stop = _start + _BLOCK
        _out_block = _out[_start:_stop]
        _block_of_x1 = _values_of_x1[_start:_stop]
        _block_of_l_AB = _values_of_l_AB[_start:_stop]
        _block_of_l_BC = _values_of_l_BC[_start:_stop]
        _block_of_l_CD = _values_of_l_CD[_start:_stop]
        _block_of_l_DE = _values_of_l_DE[_start:_stop]
        _block_of_l_GH = _values_of_l_GH[_start:_stop]
        _block_of_l_KL = _values_of_l_KL[_start:_stop]
        _block_of_l_LM = _values_of_l_LM[_start:_stop]
        _block_of_alpha_DE = _values_of_alpha_DE[_start:_stop]
        _block_of_alpha_KL = _values_of_alpha_KL[_start:_stop]
        _block_of_alpha_LM = _values_of_alpha_LM[_start:_stop]
        _row_each_of_velocity(
            _out_block,
            _block_of_x1,
            _block_of_l_AB,
            _block_of_l_BC,
            _block_of_l_CD,
            _block_of_l_DE,
            _block_of_l_GH,
            _block_of_l_KL,
            _block_of_l_LM,
            _block_of_alpha_DE,
            _block_of_alpha_KL,
            _block_of_alpha_LM,
            None,
        )
        if _has_nan(_out_block):
            _row_each_of_velocity(
                _out_block,
                _block_of_x1,
                _block_of_l_AB,
                _block_of_l_BC,
                _block_of_l_CD,
                _block_of_l_DE,
                _block_of_l_GH,
                _block_of_l_KL,
                _block_of_l_LM,
                _block_of_alpha_DE,
                _block_of_alpha_KL,
                _block_of_alpha_LM,
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
        _type(l_AB)
        is _type(l_BC)
        is _type(l_CD)
        is _type(l_DE)
        is _type(l_GH)
        is _type(l_KL)
        is _type(l_LM)
        is _type(alpha_DE)
        is _type(alpha_KL)
        is _type(alpha_LM)
        is _float
    ):
        if _type(x1) is _ndarray:
            _row = _take_row(x1, out)
            if _row is not None:
                _loops_of_velocity.fill(
                    _row, x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM
                )
                return _row
        elif _type(x1) is _float and out is None:
            return _float64(
                _loops_of_velocity.point(
                    x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM
                )
            )
    return _run(
        _loops_of_velocity,
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


_loops_of_velocity = _Loops(
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
    at=_point_of_velocity,
    uniform=_fill_of_velocity,
    each=_fill_each_of_velocity,
)


@_overload(velocity)
def _offer_of_velocity(
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
        _point_of_velocity(
            _float64(x1),
            _float64(l_AB),
            _float64(l_BC),
            _float64(l_CD),
            _float64(l_DE),
            _float64(l_GH),
            _float64(l_KL),
            _float64(l_LM),
            _float64(alpha_DE),
            _float64(alpha_KL),
            _float64(alpha_LM),
        )
    )


@_scalar
def _prepare_of_sensitivities(
    l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, _exact
):
    arm = l_AB + l_CD
    sin_DE = _elementary.sin(alpha_DE, _exact)
    cos_DE = _elementary.cos(alpha_DE, _exact)
    to_right = 2 * l_KL * _elementary.sin(alpha_KL / 2, _exact) ** 2
    to_left = 2 * l_KL * _elementary.cos(alpha_KL / 2, _exact) ** 2
    start_height = l_KL * _elementary.sin(alpha_KL, _exact)
    cos_LM = _elementary.cos(alpha_LM, _exact)
    sin_LM = _elementary.sin(alpha_LM, _exact)

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


@_scalar
def _form_of_sensitivities(
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
    _exact,
):
    x1_squared = x1**2
    guide_length = _np.sqrt(l_BC**2 + x1 * (2 * arm + x1))
    guide_sum = guide_length + l_BC
    lever_square = guide_sum**2 + x1_squared
    run = 2 * l_DE / lever_square * x1 * (sin_DE * guide_sum - cos_DE * x1)
    push = _maximum(0, run - l_GH)
    rise = _np.sqrt((push + to_right) * (to_left - push))
    rise_sum = rise + start_height
    roller_square = push**2 + rise_sum**2
    cos_wedge = (
        cos_LM * (push + rise_sum) * (rise_sum - push) - 2 * sin_LM * push * rise_sum
    ) / roller_square
    gain = cos_wedge * _choose(run < l_GH, 0, l_LM) / rise
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


@_scalar
def _value_of_sensitivities(
    x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, _exact
):
    if not (
        (l_AB > 0)
        & _is_finite(l_AB)
        & (l_BC > 0)
        & _is_finite(l_BC)
        & (l_CD > 0)
        & _is_finite(l_CD)
        & (l_DE > 0)
        & _is_finite(l_DE)
        & (l_GH > 0)
        & _is_finite(l_GH)
        & (l_KL > 0)
        & _is_finite(l_KL)
        & (l_LM > 0)
        & _is_finite(l_LM)
        & (alpha_KL > 0)
        & (alpha_KL < _np.pi)
    ):
        return (
            _math.nan,
            _math.nan,
            _math.nan,
            _math.nan,
            _math.nan,
            _math.nan,
            _math.nan,
            _math.nan,
            _math.nan,
            _math.nan,
        )
    _prepared = _prepare_of_sensitivities(
        l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, _exact
    )
    return _form_of_sensitivities(x1, *_prepared, _exact)


@_scalar
def _point_of_sensitivities(
    x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM
):
    return _value_of_sensitivities(
        x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, True
    )


@_loop
def _row_of_sensitivities(
    _out,
    _values_of_x1,
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
    _exact,
):
    _widen()
    for _i in _range(_out.size // 10):
        x1 = _float64(_values_of_x1[_i])

        _value = _value_of_sensitivities(
            x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, _exact
        )
        _out[10 * _i + 0] = _value[0]
        _out[10 * _i + 1] = _value[1]
        _out[10 * _i + 2] = _value[2]
        _out[10 * _i + 3] = _value[3]
        _out[10 * _i + 4] = _value[4]
        _out[10 * _i + 5] = _value[5]
        _out[10 * _i + 6] = _value[6]
        _out[10 * _i + 7] = _value[7]
        _out[10 * _i + 8] = _value[8]
        _out[10 * _i + 9] = _value[9]


@_loop
def _fill_of_sensitivities(
    _out,
    _values_of_x1,
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
    for _start in _range(0, _out.size // 10, _BLOCK):
        _stop = _start + _BLOCK
        _out_block = _out[10 * _start : 10 * _stop]
        _block_of_x1 = _values_of_x1[_start:_stop]
        _row_of_sensitivities(
            _out_block,
            _block_of_x1,
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
        if _has_nan(_out_block):
            _row_of_sensitivities(
                _out_block,
                _block_of_x1,
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


@_loop
def _row_each_of_sensitivities(
    _out,
    _values_of_x1,
    _values_of_l_AB,
    _values_of_l_BC,
    _values_of_l_CD,
    _values_of_l_DE,
    _values_of_l_GH,
    _values_of_l_KL,
    _values_of_l_LM,
    _values_of_alpha_DE,
    _values_of_alpha_KL,
    _values_of_alpha_LM,
    _exact,
):
    _widen()
    for _i in _range(_out.size // 10):
        x1 = _float64(_values_of_x1[_i])

        l_AB = _float64(_values_of_l_AB[_i])

        l_BC = _float64(_values_of_l_BC[_i])

        l_CD = _float64(_values_of_l_CD[_i])

        l_DE = _float64(_values_of_l_DE[_i])

        l_GH = _float64(_values_of_l_GH[_i])

        l_KL = _float64(_values_of_l_KL[_i])

        l_LM = _float64(_values_of_l_LM[_i])

        alpha_DE = _float64(_values_of_alpha_DE[_i])

        alpha_KL = _float64(_values_of_alpha_KL[_i])

        alpha_LM = _float64(_values_of_alpha_LM[_i])

        _value = _value_of_sensitivities(
            x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM, _exact
        )
        _out[10 * _i + 0] = _value[0]
        _out[10 * _i + 1] = _value[1]
        _out[10 * _i + 2] = _value[2]
        _out[10 * _i + 3] = _value[3]
        _out[10 * _i + 4] = _value[4]
        _out[10 * _i + 5] = _value[5]
        _out[10 * _i + 6] = _value[6]
        _out[10 * _i + 7] = _value[7]
        _out[10 * _i + 8] = _value[8]
        _out[10 * _i + 9] = _value[9]


@_loop
def _fill_each_of_sensitivities(
    _out,
    _values_of_x1,
    _values_of_l_AB,
    _values_of_l_BC,
    _values_of_l_CD,
    _values_of_l_DE,
    _values_of_l_GH,
    _values_of_l_KL,
    _values_of_l_LM,
    _values_of_alpha_DE,
    _values_of_alpha_KL,
    _values_of_alpha_LM,
):
    for _start in _range(0, _out.size // 10, _BLOCK):
        _stop = _start + _BLOCK
        _out_block = _out[10 * _start : 10 * _stop]
        _block_of_x1 = _values_of_x1[_start:_stop]
        _block_of_l_AB = _values_of_l_AB[_start:_stop]
        _block_of_l_BC = _values_of_l_BC[_start:_stop]
        _block_of_l_CD = _values_of_l_CD[_start:_stop]
        _block_of_l_DE = _values_of_l_DE[_start:_stop]
        _block_of_l_GH = _values_of_l_GH[_start:_stop]
        _block_of_l_KL = _values_of_l_KL[_start:_stop]
        _block_of_l_LM = _values_of_l_LM[_start:_stop]
        _block_of_alpha_DE = _values_of_alpha_DE[_start:_stop]
        _block_of_alpha_KL = _values_of_alpha_KL[_start:_stop]
        _block_of_alpha_LM = _values_of_alpha_LM[_start:_stop]
        _row_each_of_sensitivities(
            _out_block,
            _block_of_x1,
            _block_of_l_AB,
            _block_of_l_BC,
            _block_of_l_CD,
            _block_of_l_DE,
            _block_of_l_GH,
            _block_of_l_KL,
            _block_of_l_LM,
            _block_of_alpha_DE,
            _block_of_alpha_KL,
            _block_of_alpha_LM,
            None,
        )
        if _has_nan(_out_block):
            _row_each_of_sensitivities(
                _out_block,
                _block_of_x1,
                _block_of_l_AB,
                _block_of_l_BC,
                _block_of_l_CD,
                _block_of_l_DE,
                _block_of_l_GH,
                _block_of_l_KL,
                _block_of_l_LM,
                _block_of_alpha_DE,
                _block_of_alpha_KL,
                _block_of_alpha_LM,
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
    return _run(
        _loops_of_sensitivities,
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


_loops_of_sensitivities = _Loops(
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
    at=_point_of_sensitivities,
    uniform=_fill_of_sensitivities,
    each=_fill_each_of_sensitivities,
)


@_overload(sensitivities)
def _offer_of_sensitivities(
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
        _point_of_sensitivities(
            _float64(x1),
            _float64(l_AB),
            _float64(l_BC),
            _float64(l_CD),
            _float64(l_DE),
            _float64(l_GH),
            _float64(l_KL),
            _float64(l_LM),
            _float64(alpha_DE),
            _float64(alpha_KL),
            _float64(alpha_LM),
        )
    )
