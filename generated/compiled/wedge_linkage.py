"""Compiled kernels of the system `wedge_linkage`: one loop for each, by numba.

Names, arguments, domains, NaN and errors are those of `mechproof.kernels.wedge_linkage`,
and so are the formulas. Kernels take numbers and NumPy arrays. Functions that numba
compiles can call them, also with numbers and arrays mixed; arguments and results with
components are then indexed.

Tests hold them to the same accuracy bounds. Proved bounds on rounding errors, as help
states them, hold for these kernels where it says `compiled`, otherwise for NumPy's.

Elementary functions: `elementary` 2b535d4ac6f8.

Generated from the derivation wedge_linkage with SymPy 1.14.0.
Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""

from __future__ import annotations

import math as _math
from builtins import float as _float, type as _type
from typing import Any

import numpy as _np
from numpy import float64 as _float64, ndarray as _ndarray
from numpy.typing import ArrayLike, NDArray

from mechproof.compiled_support import (
    Loops as _Loops,
    choose as _choose,
    fill as _fill,
    fill_blocks as _fill_blocks,
    is_finite as _is_finite,
    loop as _loop,
    maximum as _maximum,
    point_of as _point_of,
    run as _run,
    scalar as _scalar,
    take_row as _take_row,
    vector as _vector,
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
    return l_BC**2 + x1 * (2 * l_AB + 2 * l_CD + x1)


@_loop
def _fill_of_guide_radicand(_out, x1, l_AB, l_BC, l_CD):
    _fill(_value_of_guide_radicand, _out, (x1, l_AB, l_BC, l_CD))


def guide_radicand(
    x1: ArrayLike,
    l_AB: ArrayLike,
    l_BC: ArrayLike,
    l_CD: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute the radicand of Q, the square of BC: the guide follows where it is not negative.

    Compiled. Its full documentation is that of
    `mechproof.kernels.wedge_linkage.guide_radicand`.
    """
    if _type(l_AB) is _type(l_BC) is _type(l_CD) is _float:
        if _type(x1) is _ndarray and (_row := _take_row(x1, out)) is not None:
            _loops_of_guide_radicand.fill(_row, x1, l_AB, l_BC, l_CD)
            return _row
        if _type(x1) is _float and out is None:
            return _float64(_loops_of_guide_radicand.point(x1, l_AB, l_BC, l_CD))
    return _run(_loops_of_guide_radicand, (x1, l_AB, l_BC, l_CD), out)


@_point_of(guide_radicand, spread=True)
def _point_of_guide_radicand(x1, l_AB, l_BC, l_CD):
    return _value_of_guide_radicand(_float64(x1), _float64(l_AB), _float64(l_BC), _float64(l_CD))


_loops_of_guide_radicand = _Loops(
    ("x1", "l_AB", "l_BC", "l_CD"), _point_of_guide_radicand, _fill_of_guide_radicand
)


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
    arm = l_AB + l_CD
    guide_length = _np.sqrt(l_BC**2 + x1 * (2 * arm + x1))
    guide_sum = guide_length + l_BC
    return -2 * _elementary.arctan_quotient(x1, guide_sum)


@_loop
def _fill_of_lever_angle(_out, x1, l_AB, l_BC, l_CD):
    _fill(_value_of_lever_angle, _out, (x1, l_AB, l_BC, l_CD))


def lever_angle(
    x1: ArrayLike,
    l_AB: ArrayLike,
    l_BC: ArrayLike,
    l_CD: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> Any:
    """Compute the rotation phi3 of the lever.

    Compiled. Its full documentation is that of
    `mechproof.kernels.wedge_linkage.lever_angle`.
    """
    if _type(l_AB) is _type(l_BC) is _type(l_CD) is _float:
        if _type(x1) is _ndarray and (_row := _take_row(x1, out)) is not None:
            _loops_of_lever_angle.fill(_row, x1, l_AB, l_BC, l_CD)
            return _row
        if _type(x1) is _float and out is None:
            return _float64(_loops_of_lever_angle.point(x1, l_AB, l_BC, l_CD))
    return _run(_loops_of_lever_angle, (x1, l_AB, l_BC, l_CD), out)


@_point_of(lever_angle, spread=True)
def _point_of_lever_angle(x1, l_AB, l_BC, l_CD):
    return _value_of_lever_angle(_float64(x1), _float64(l_AB), _float64(l_BC), _float64(l_CD))


_loops_of_lever_angle = _Loops(
    ("x1", "l_AB", "l_BC", "l_CD"), _point_of_lever_angle, _fill_of_lever_angle
)


@_scalar
def _value_of_rod_displacement(phi3, l_DE, alpha_DE, _exact):
    if not ((l_DE > 0) & _is_finite(l_DE)):
        return _math.nan
    return (
        -2 * l_DE * _elementary.sin(phi3 / 2, _exact) * _elementary.sin(alpha_DE + phi3 / 2, _exact)
    )


@_loop
def _fill_of_rod_displacement(_out, phi3, l_DE, alpha_DE):
    _fill_blocks(_value_of_rod_displacement, _out, (phi3, l_DE, alpha_DE))


def rod_displacement(
    phi3: ArrayLike, l_DE: ArrayLike, alpha_DE: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the displacement x5 of the rod.

    Compiled. Its full documentation is that of
    `mechproof.kernels.wedge_linkage.rod_displacement`.
    """
    if _type(l_DE) is _type(alpha_DE) is _float:
        if _type(phi3) is _ndarray and (_row := _take_row(phi3, out)) is not None:
            _loops_of_rod_displacement.fill(_row, phi3, l_DE, alpha_DE)
            return _row
        if _type(phi3) is _float and out is None:
            return _float64(_loops_of_rod_displacement.point(phi3, l_DE, alpha_DE))
    return _run(_loops_of_rod_displacement, (phi3, l_DE, alpha_DE), out)


@_point_of(rod_displacement, spread=True)
def _point_of_rod_displacement(phi3, l_DE, alpha_DE):
    return _value_of_rod_displacement(_float64(phi3), _float64(l_DE), _float64(alpha_DE), True)


_loops_of_rod_displacement = _Loops(
    ("phi3", "l_DE", "alpha_DE"), _point_of_rod_displacement, _fill_of_rod_displacement
)


@_scalar
def _value_of_clearance(x5, l_GH):
    if not ((l_GH > 0) & _is_finite(l_GH)):
        return _math.nan
    return _maximum(0, x5 - l_GH)


@_loop
def _fill_of_clearance(_out, x5, l_GH):
    _fill(_value_of_clearance, _out, (x5, l_GH))


def clearance(x5: ArrayLike, l_GH: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
    """Compute the displacement x5' of the pushed link after the clearance.

    Compiled. Its full documentation is that of
    `mechproof.kernels.wedge_linkage.clearance`.
    """
    if _type(l_GH) is _float:
        if _type(x5) is _ndarray and (_row := _take_row(x5, out)) is not None:
            _loops_of_clearance.fill(_row, x5, l_GH)
            return _row
        if _type(x5) is _float and out is None:
            return _float64(_loops_of_clearance.point(x5, l_GH))
    return _run(_loops_of_clearance, (x5, l_GH), out)


@_point_of(clearance, spread=True)
def _point_of_clearance(x5, l_GH):
    return _value_of_clearance(_float64(x5), _float64(l_GH))


_loops_of_clearance = _Loops(("x5", "l_GH"), _point_of_clearance, _fill_of_clearance)


@_scalar
def _value_of_roller_offset(x5, l_KL, alpha_KL, _exact):
    if not ((l_KL > 0) & _is_finite(l_KL) & (alpha_KL > 0) & (alpha_KL < _np.pi)):
        return _math.nan
    return l_KL * _elementary.cos(alpha_KL, _exact) - x5


@_loop
def _fill_of_roller_offset(_out, x5, l_KL, alpha_KL):
    _fill_blocks(_value_of_roller_offset, _out, (x5, l_KL, alpha_KL))


def roller_offset(
    x5: ArrayLike, l_KL: ArrayLike, alpha_KL: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute R, the projection of KL on Ox: the roller lever follows where |R| <= l_KL.

    Compiled. Its full documentation is that of
    `mechproof.kernels.wedge_linkage.roller_offset`.
    """
    if _type(l_KL) is _type(alpha_KL) is _float:
        if _type(x5) is _ndarray and (_row := _take_row(x5, out)) is not None:
            _loops_of_roller_offset.fill(_row, x5, l_KL, alpha_KL)
            return _row
        if _type(x5) is _float and out is None:
            return _float64(_loops_of_roller_offset.point(x5, l_KL, alpha_KL))
    return _run(_loops_of_roller_offset, (x5, l_KL, alpha_KL), out)


@_point_of(roller_offset, spread=True)
def _point_of_roller_offset(x5, l_KL, alpha_KL):
    return _value_of_roller_offset(_float64(x5), _float64(l_KL), _float64(alpha_KL), True)


_loops_of_roller_offset = _Loops(
    ("x5", "l_KL", "alpha_KL"), _point_of_roller_offset, _fill_of_roller_offset
)


@_scalar
def _value_of_roller_lever_angle(x5, l_KL, alpha_KL, _exact):
    if not ((l_KL > 0) & _is_finite(l_KL) & (alpha_KL > 0) & (alpha_KL < _np.pi)):
        return _math.nan
    return 2 * _elementary.arctan_quotient(
        x5,
        l_KL * _elementary.sin(alpha_KL, _exact)
        + _np.sqrt(
            (x5 + 2 * l_KL * _elementary.sin(alpha_KL / 2, _exact) ** 2)
            * (2 * l_KL * _elementary.cos(alpha_KL / 2, _exact) ** 2 - x5)
        ),
    )


@_loop
def _fill_of_roller_lever_angle(_out, x5, l_KL, alpha_KL):
    _fill_blocks(_value_of_roller_lever_angle, _out, (x5, l_KL, alpha_KL))


def roller_lever_angle(
    x5: ArrayLike, l_KL: ArrayLike, alpha_KL: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the rotation phi7 of the roller lever.

    Compiled. Its full documentation is that of
    `mechproof.kernels.wedge_linkage.roller_lever_angle`.
    """
    if _type(l_KL) is _type(alpha_KL) is _float:
        if _type(x5) is _ndarray and (_row := _take_row(x5, out)) is not None:
            _loops_of_roller_lever_angle.fill(_row, x5, l_KL, alpha_KL)
            return _row
        if _type(x5) is _float and out is None:
            return _float64(_loops_of_roller_lever_angle.point(x5, l_KL, alpha_KL))
    return _run(_loops_of_roller_lever_angle, (x5, l_KL, alpha_KL), out)


@_point_of(roller_lever_angle, spread=True)
def _point_of_roller_lever_angle(x5, l_KL, alpha_KL):
    return _value_of_roller_lever_angle(_float64(x5), _float64(l_KL), _float64(alpha_KL), True)


_loops_of_roller_lever_angle = _Loops(
    ("x5", "l_KL", "alpha_KL"), _point_of_roller_lever_angle, _fill_of_roller_lever_angle
)


@_scalar
def _value_of_wedge_displacement(phi7, l_LM, alpha_LM, _exact):
    if not ((l_LM > 0) & _is_finite(l_LM)):
        return _math.nan
    return (
        2 * l_LM * _elementary.cos(alpha_LM + phi7 / 2, _exact) * _elementary.sin(phi7 / 2, _exact)
    )


@_loop
def _fill_of_wedge_displacement(_out, phi7, l_LM, alpha_LM):
    _fill_blocks(_value_of_wedge_displacement, _out, (phi7, l_LM, alpha_LM))


def wedge_displacement(
    phi7: ArrayLike, l_LM: ArrayLike, alpha_LM: ArrayLike, *, out: NDArray[Any] | None = None
) -> Any:
    """Compute the displacement y9 of the wedge.

    Compiled. Its full documentation is that of
    `mechproof.kernels.wedge_linkage.wedge_displacement`.
    """
    if _type(l_LM) is _type(alpha_LM) is _float:
        if _type(phi7) is _ndarray and (_row := _take_row(phi7, out)) is not None:
            _loops_of_wedge_displacement.fill(_row, phi7, l_LM, alpha_LM)
            return _row
        if _type(phi7) is _float and out is None:
            return _float64(_loops_of_wedge_displacement.point(phi7, l_LM, alpha_LM))
    return _run(_loops_of_wedge_displacement, (phi7, l_LM, alpha_LM), out)


@_point_of(wedge_displacement, spread=True)
def _point_of_wedge_displacement(phi7, l_LM, alpha_LM):
    return _value_of_wedge_displacement(_float64(phi7), _float64(l_LM), _float64(alpha_LM), True)


_loops_of_wedge_displacement = _Loops(
    ("phi7", "l_LM", "alpha_LM"), _point_of_wedge_displacement, _fill_of_wedge_displacement
)


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
    arm = l_AB + l_CD
    sin_DE = _elementary.sin(alpha_DE, _exact)
    cos_DE = _elementary.cos(alpha_DE, _exact)
    to_right = 2 * l_KL * _elementary.sin(alpha_KL / 2, _exact) ** 2
    to_left = 2 * l_KL * _elementary.cos(alpha_KL / 2, _exact) ** 2
    start_height = l_KL * _elementary.sin(alpha_KL, _exact)
    cos_LM = _elementary.cos(alpha_LM, _exact)
    sin_LM = _elementary.sin(alpha_LM, _exact)
    guide_length = _np.sqrt(l_BC**2 + x1 * (2 * arm + x1))
    guide_sum = guide_length + l_BC
    lever_square = guide_sum**2 + x1**2
    run = 2 * l_DE / lever_square * x1 * (sin_DE * guide_sum - cos_DE * x1)
    push = _maximum(0, run - l_GH)
    rise = _np.sqrt((push + to_right) * (to_left - push))
    rise_sum = rise + start_height
    roller_square = push**2 + rise_sum**2
    return 2 * l_LM / roller_square * push * (cos_LM * rise_sum - sin_LM * push)


@_loop
def _fill_of_position(
    _out, x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM
):
    _fill_blocks(
        _value_of_position,
        _out,
        (x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM),
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

    Compiled. Its full documentation is that of
    `mechproof.kernels.wedge_linkage.position`.
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
        if _type(x1) is _ndarray and (_row := _take_row(x1, out)) is not None:
            _loops_of_position.fill(
                _row, x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM
            )
            return _row
        if _type(x1) is _float and out is None:
            return _float64(
                _loops_of_position.point(
                    x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM
                )
            )
    return _run(
        _loops_of_position,
        (x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM),
        out,
    )


@_point_of(position, spread=True)
def _point_of_position(x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM):
    return _value_of_position(
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
        True,
    )


_loops_of_position = _Loops(
    (
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
    _point_of_position,
    _fill_of_position,
)


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
    arm = l_AB + l_CD
    sin_DE = _elementary.sin(alpha_DE, _exact)
    cos_DE = _elementary.cos(alpha_DE, _exact)
    to_right = 2 * l_KL * _elementary.sin(alpha_KL / 2, _exact) ** 2
    to_left = 2 * l_KL * _elementary.cos(alpha_KL / 2, _exact) ** 2
    start_height = l_KL * _elementary.sin(alpha_KL, _exact)
    cos_LM = _elementary.cos(alpha_LM, _exact)
    sin_LM = _elementary.sin(alpha_LM, _exact)
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


@_loop
def _fill_of_velocity(
    _out, x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM
):
    _fill_blocks(
        _value_of_velocity,
        _out,
        (x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM),
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

    Compiled. Its full documentation is that of
    `mechproof.kernels.wedge_linkage.velocity`.
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
        if _type(x1) is _ndarray and (_row := _take_row(x1, out)) is not None:
            _loops_of_velocity.fill(
                _row, x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM
            )
            return _row
        if _type(x1) is _float and out is None:
            return _float64(
                _loops_of_velocity.point(
                    x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM
                )
            )
    return _run(
        _loops_of_velocity,
        (x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM),
        out,
    )


@_point_of(velocity, spread=True)
def _point_of_velocity(x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM):
    return _value_of_velocity(
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
        True,
    )


_loops_of_velocity = _Loops(
    (
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
    _point_of_velocity,
    _fill_of_velocity,
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
    arm = l_AB + l_CD
    sin_DE = _elementary.sin(alpha_DE, _exact)
    cos_DE = _elementary.cos(alpha_DE, _exact)
    to_right = 2 * l_KL * _elementary.sin(alpha_KL / 2, _exact) ** 2
    to_left = 2 * l_KL * _elementary.cos(alpha_KL / 2, _exact) ** 2
    start_height = l_KL * _elementary.sin(alpha_KL, _exact)
    cos_LM = _elementary.cos(alpha_LM, _exact)
    sin_LM = _elementary.sin(alpha_LM, _exact)
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


@_loop
def _fill_of_sensitivities(
    _out, x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM
):
    _fill_blocks(
        _value_of_sensitivities,
        _vector(_out, 10),
        (x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM),
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

    Compiled. Its full documentation is that of
    `mechproof.kernels.wedge_linkage.sensitivities`.
    """
    return _run(
        _loops_of_sensitivities,
        (x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM),
        out,
    )


@_point_of(sensitivities)
def _point_of_sensitivities(
    x1, l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM
):
    return _value_of_sensitivities(
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
        True,
    )


_loops_of_sensitivities = _Loops(
    (
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
    _point_of_sensitivities,
    _fill_of_sensitivities,
    shape=(10,),
)
