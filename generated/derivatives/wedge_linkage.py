"""Partial derivatives of the kernels of `wedge_linkage`, by every argument.

Bazuev, Koksharov, Naichuk 2021, transfer function of a rod semi-automatic, doi
10.15593/2224-9982/2021.64.07

Arguments, domain, `out` and errors are those of the kernel with the same name, one module
up; along a last axis the result has the derivative by each argument, in their order.

At a kink a derivative is that on the side of the greater argument; at a pole it is infinite
or NaN. Each is proved to follow from the definition by the chain rule. Accuracy is tested:
the error of an entry d is at most the stated multiple of eps = 2**-52 times its condition,
|d| + the sum of |p * d d/d p| over the arguments and the symbols p of the kernel's formula,
plus, if the kernel's own error has a scale, that scale divided by the argument (the first
counts as at most 1 rad or mm).

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
    "clearance",
    "guide_radicand",
    "lever_angle",
    "position",
    "rod_displacement",
    "roller_lever_angle",
    "roller_offset",
    "wedge_displacement",
]


def __dir__() -> list[str]:
    return __all__


# Source: Bazuev et al. 2021, equation (1)
# Expressions sha256: d879a9d346b4f6228bfd3f5a1dd074c72f0c0bab7e18a6761a1fa41789b962f5
# Form: backward pass
# Operations: 12
def guide_radicand(
    x1: ArrayLike,
    l_AB: ArrayLike,
    l_BC: ArrayLike,
    l_CD: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> NDArray[Any]:
    """Differentiate `guide_radicand` by its arguments, in their order.

    In mm**2 per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where
    (1e-50 <= |x1| <= 1e50 or x1 = 0) and 1e-50 <= l_AB, l_BC, l_CD <= 1e50.

    """
    x1, l_AB, l_BC, l_CD = _as_floats("x1 l_AB l_BC l_CD", x1, l_AB, l_BC, l_CD)
    l_AB, l_BC, l_CD = _nan_outside(_check_of_guide_radicand, l_AB, l_BC, l_CD)
    return _in_blocks(
        _form_of_guide_radicand, (x1,), parameters=(l_AB, l_BC, l_CD), out=out, shape=(4,)
    )


def _check_of_guide_radicand(l_AB: Any, l_BC: Any, l_CD: Any) -> tuple[Any, ...]:
    return (_is_positive(l_AB), _is_positive(l_BC), _is_positive(l_CD))


def _form_of_guide_radicand(x1: Any, l_AB: Any, l_BC: Any, l_CD: Any) -> Any:
    return (
        2.0 * l_AB + 2.0 * l_CD + 2.0 * x1,
        2.0 * x1 + 0.0 * l_CD,
        2.0 * l_BC,
        2.0 * x1 + 0.0 * l_CD,
    )


# Source: Bazuev et al. 2021, equation (1)
# Expressions sha256: 8d9c8521f298011b3b2e09fdd6d0217ff57a573735f452b3246c1ecfe81847aa
# Form: backward pass
# Operations: 38
def lever_angle(
    x1: ArrayLike,
    l_AB: ArrayLike,
    l_BC: ArrayLike,
    l_CD: ArrayLike,
    *,
    out: NDArray[Any] | None = None,
) -> NDArray[Any]:
    """Differentiate `lever_angle` by its arguments, in their order.

    In rad per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where (1e-50
    <= |x1| <= 1e50 or x1 = 0) and 1e-50 <= l_AB, l_BC, l_CD <= 1e50 and guide_condition/2**48 <
    guide_square.

    """
    x1, l_AB, l_BC, l_CD = _as_floats("x1 l_AB l_BC l_CD", x1, l_AB, l_BC, l_CD)
    l_AB, l_BC, l_CD = _nan_outside(_check_of_guide_radicand, l_AB, l_BC, l_CD)
    return _in_blocks(
        _form_of_lever_angle,
        (x1,),
        _prepare_of_lever_angle,
        (l_AB, l_BC, l_CD),
        out=out,
        shape=(4,),
        quiet=True,
    )


def _prepare_of_lever_angle(l_AB: Any, l_BC: Any, l_CD: Any) -> tuple[Any, ...]:
    arm = l_AB + l_CD

    return (l_BC, arm)


def _form_of_lever_angle(x1: Any, l_BC: Any, arm: Any) -> Any:
    term_3 = _square(l_BC) + x1 * (2.0 * arm + x1)
    guide_length = _np.sqrt(term_3)
    guide_sum = guide_length + l_BC
    term_5 = 1.0 / _square(guide_sum)
    x1_squared = _square(x1)
    term_4 = 1.0 / (1.0 + term_5 * x1_squared)
    term_2 = 1.0 / _np.sqrt(term_3)
    term = 2.0 * term_2 * term_4 * term_5 * x1_squared

    return (
        2.0 * term_2 * term_4 * term_5 * x1 * (arm + x1) - 2.0 / guide_sum * term_4,
        term,
        2.0 * term_4 * term_5 * x1 + 2.0 * l_BC * term_2 * term_4 * term_5 * x1,
        term,
    )


# Source: Bazuev et al. 2021, equation (3)
# Expressions sha256: 7711f02188d2e1f5af9b8faf09e0700c39065a41adb3ec1e94589a491fbbceb1
# Form: backward pass
# Operations: 21
def rod_displacement(
    phi3: ArrayLike, l_DE: ArrayLike, alpha_DE: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `rod_displacement` by its arguments, in their order.

    In mm per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where |phi3|
    <= pi and (phi3 = 0 or 1e-140 <= |phi3|) and 1e-10 <= l_DE <= 1e300.

    """
    phi3, l_DE, alpha_DE = _as_floats("phi3 l_DE alpha_DE", phi3, l_DE, alpha_DE)
    (l_DE,) = _nan_outside(_check_of_rod_displacement, l_DE)
    return _in_blocks(
        _form_of_rod_displacement, (phi3,), parameters=(l_DE, alpha_DE), out=out, shape=(3,)
    )


def _check_of_rod_displacement(l_DE: Any) -> tuple[Any, ...]:
    return (_is_positive(l_DE),)


def _form_of_rod_displacement(phi3: Any, l_DE: Any, alpha_DE: Any) -> Any:
    sin__varphi3 = _np.sin(phi3 / 2.0)
    alpha_DE_plus__varphi3 = alpha_DE + phi3 / 2.0
    term_2 = _np.cos(alpha_DE_plus__varphi3)
    term = _np.sin(alpha_DE_plus__varphi3)

    return (
        -l_DE * sin__varphi3 * term_2 - l_DE * term * _np.cos(phi3 / 2.0),
        -2.0 * sin__varphi3 * term + 0.0 * l_DE,
        -2.0 * l_DE * sin__varphi3 * term_2,
    )


# Source: Bazuev et al. 2021, equation (4)
# Expressions sha256: acc932b58a5c05ef36ed6ff46fa685c1c7c754d19b8ed37ecc2b5a0ca8a3ad3c
# Form: backward pass
# Operations: 12
def clearance(x5: ArrayLike, l_GH: ArrayLike, *, out: NDArray[Any] | None = None) -> NDArray[Any]:
    """Differentiate `clearance` by its arguments, in their order.

    In mm per unit of each argument. Accuracy, tested: 4 eps of its conditioning.

    """
    x5, l_GH = _as_floats("x5 l_GH", x5, l_GH)
    (l_GH,) = _nan_outside(_check_of_clearance, l_GH)
    return _in_blocks(
        _form_of_clearance, (x5,), parameters=(l_GH,), out=out, shape=(2,), quiet=True
    )


def _check_of_clearance(l_GH: Any) -> tuple[Any, ...]:
    return (_is_positive(l_GH),)


def _form_of_clearance(x5: Any, l_GH: Any) -> Any:
    term = _choose_where(l_GH - x5 > 0.0, 0.0, 1.0)

    return (
        term + 0.0 * x5 + 0.0 * l_GH,
        -term + 0.0 * x5 + 0.0 * l_GH,
    )


# Source: Bazuev et al. 2021, equations (7) and (8)
# Expressions sha256: a6a329d7678d271dc9f34d36088082f9c039923bea1d680a21cfb406b77995c4
# Form: backward pass
# Operations: 12
def roller_offset(
    x5: ArrayLike, l_KL: ArrayLike, alpha_KL: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `roller_offset` by its arguments, in their order.

    In mm per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where (1e-50
    <= |x5| <= 1e50 or x5 = 0) and 1e-50 <= l_KL <= 1e50.

    """
    x5, l_KL, alpha_KL = _as_floats("x5 l_KL alpha_KL", x5, l_KL, alpha_KL)
    l_KL, alpha_KL = _nan_outside(_check_of_roller_offset, l_KL, alpha_KL)
    return _in_blocks(
        _form_of_roller_offset, (x5,), parameters=(l_KL, alpha_KL), out=out, shape=(3,)
    )


def _check_of_roller_offset(l_KL: Any, alpha_KL: Any) -> tuple[Any, ...]:
    return (_is_positive(l_KL), alpha_KL > 0.0, alpha_KL < _np.pi)


def _form_of_roller_offset(x5: Any, l_KL: Any, alpha_KL: Any) -> Any:
    return (
        -1.0 + 0.0 * x5 + 0.0 * alpha_KL,
        _np.cos(alpha_KL) + 0.0 * x5,
        -l_KL * _np.sin(alpha_KL) + 0.0 * x5,
    )


# Source: Bazuev et al. 2021, equations (7) and (8)
# Expressions sha256: a0de59709c5225647bf23ebbf61302b65d7f7b76362cb29cf59dd3765d5b6865
# Form: backward pass
# Operations: 68
def roller_lever_angle(
    x5: ArrayLike, l_KL: ArrayLike, alpha_KL: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `roller_lever_angle` by its arguments, in their order.

    In rad per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where (1e-50
    <= |x5| <= 1e50 or x5 = 0) and 1e-50 <= l_KL <= 1e50 and height_condition/2**48 <
    height_square.

    """
    x5, l_KL, alpha_KL = _as_floats("x5 l_KL alpha_KL", x5, l_KL, alpha_KL)
    l_KL, alpha_KL = _nan_outside(_check_of_roller_offset, l_KL, alpha_KL)
    return _in_blocks(
        _form_of_roller_lever_angle,
        (x5,),
        _prepare_of_roller_lever_angle,
        (l_KL, alpha_KL),
        out=out,
        shape=(3,),
        quiet=True,
    )


def _prepare_of_roller_lever_angle(l_KL: Any, alpha_KL: Any) -> tuple[Any, ...]:
    sin__alpha_KL = _np.sin(alpha_KL / 2.0)
    sin__alpha_KL_squared = _square(sin__alpha_KL)
    cos__alpha_KL = _np.cos(alpha_KL / 2.0)
    cos__alpha_KL_squared = _square(cos__alpha_KL)
    sin_alpha_KL = _np.sin(alpha_KL)

    return (
        l_KL,
        alpha_KL,
        sin__alpha_KL,
        sin__alpha_KL_squared,
        cos__alpha_KL,
        cos__alpha_KL_squared,
        sin_alpha_KL,
    )


def _form_of_roller_lever_angle(
    x5: Any,
    l_KL: Any,
    alpha_KL: Any,
    sin__alpha_KL: Any,
    sin__alpha_KL_squared: Any,
    cos__alpha_KL: Any,
    cos__alpha_KL_squared: Any,
    sin_alpha_KL: Any,
) -> Any:
    term_7 = x5 + 2.0 * sin__alpha_KL_squared * l_KL
    term_8 = 2.0 * cos__alpha_KL_squared * l_KL - x5
    term_4 = _np.sqrt(term_7 * term_8)
    term_3 = term_4 + sin_alpha_KL * l_KL
    term_2 = 1.0 / _square(term_3)
    term = 1.0 / (1.0 + term_2 * _square(x5))
    term_5 = 1.0 / term_7
    term_6 = 1.0 / term_8

    return (
        2.0
        * term
        * (
            1.0 / term_3
            - term_2
            * term_4
            * term_5
            * term_6
            * x5
            * (cos__alpha_KL_squared * l_KL - x5 - sin__alpha_KL_squared * l_KL)
        ),
        2.0
        * term
        * term_2
        * x5
        * (
            -sin_alpha_KL
            - term_4
            * term_5
            * term_6
            * (cos__alpha_KL_squared * term_7 + sin__alpha_KL_squared * term_8)
        ),
        2.0
        * term
        * term_2
        * x5
        * (
            -l_KL * _np.cos(alpha_KL)
            - term_4
            * term_5
            * term_6
            * (
                cos__alpha_KL * sin__alpha_KL * l_KL * term_8
                - cos__alpha_KL * sin__alpha_KL * l_KL * term_7
            )
        ),
    )


# Source: Bazuev et al. 2021, equation (10)
# Expressions sha256: 4a96f80eecc9b6a1586aaa1c7f1ad0d31579f49c393216afc5f93ad264acee20
# Form: backward pass
# Operations: 20
def wedge_displacement(
    phi7: ArrayLike, l_LM: ArrayLike, alpha_LM: ArrayLike, *, out: NDArray[Any] | None = None
) -> NDArray[Any]:
    """Differentiate `wedge_displacement` by its arguments, in their order.

    In mm per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where |phi7|
    <= pi and (phi7 = 0 or 1e-140 <= |phi7|) and 1e-10 <= l_LM <= 1e300.

    """
    phi7, l_LM, alpha_LM = _as_floats("phi7 l_LM alpha_LM", phi7, l_LM, alpha_LM)
    (l_LM,) = _nan_outside(_check_of_wedge_displacement, l_LM)
    return _in_blocks(
        _form_of_wedge_displacement, (phi7,), parameters=(l_LM, alpha_LM), out=out, shape=(3,)
    )


def _check_of_wedge_displacement(l_LM: Any) -> tuple[Any, ...]:
    return (_is_positive(l_LM),)


def _form_of_wedge_displacement(phi7: Any, l_LM: Any, alpha_LM: Any) -> Any:
    alpha_LM_plus__varphi7 = alpha_LM + phi7 / 2.0
    term = _np.cos(alpha_LM_plus__varphi7)
    sin__varphi7 = _np.sin(phi7 / 2.0)
    term_2 = _np.sin(alpha_LM_plus__varphi7)

    return (
        l_LM * term * _np.cos(phi7 / 2.0) - l_LM * sin__varphi7 * term_2,
        2.0 * sin__varphi7 * term + 0.0 * l_LM,
        -2.0 * l_LM * sin__varphi7 * term_2,
    )


# Source: Bazuev et al. 2021, equations (1), (3), (4), (7), (8), (10)
# Expressions sha256: d2cf9216d59746f10dd8b1223fe2f0041868752105673fbfbe360a9338701c75
# Form: backward pass
# Operations: 207
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
) -> NDArray[Any]:
    """Differentiate `position` by its arguments, in their order.

    In mm per unit of each argument. Accuracy, tested: 4 eps of its conditioning, where (1e-50
    <= |x1| <= 1e50 or x1 = 0) and 1e-50 <= l_AB, l_BC, l_CD, l_DE, l_KL, l_LM <= 1e50 and l_GH
    <= 1e50 and guide_condition/2**48 < guide_square and roller_condition/2**48 < KL_x + l_KL
    and run_condition/2**48 < |l_GH - travel_5|.

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
        shape=(11,),
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
    cos_LM = _np.cos(alpha_LM)
    sin__alpha_KL = _np.sin(alpha_KL / 2.0)
    sin__alpha_KL_squared = _square(sin__alpha_KL)
    to_right = 2.0 * sin__alpha_KL_squared * l_KL
    cos__alpha_KL = _np.cos(alpha_KL / 2.0)
    cos__alpha_KL_squared = _square(cos__alpha_KL)
    to_left = 2.0 * cos__alpha_KL_squared * l_KL
    sin_alpha_KL = _np.sin(alpha_KL)
    start_height = sin_alpha_KL * l_KL
    sin_LM = _np.sin(alpha_LM)

    return (
        l_BC,
        l_DE,
        l_GH,
        l_KL,
        l_LM,
        alpha_KL,
        arm,
        sin_DE,
        cos_DE,
        cos_LM,
        sin__alpha_KL,
        sin__alpha_KL_squared,
        to_right,
        cos__alpha_KL,
        cos__alpha_KL_squared,
        to_left,
        sin_alpha_KL,
        start_height,
        sin_LM,
    )


def _form_of_position(
    x1: Any,
    l_BC: Any,
    l_DE: Any,
    l_GH: Any,
    l_KL: Any,
    l_LM: Any,
    alpha_KL: Any,
    arm: Any,
    sin_DE: Any,
    cos_DE: Any,
    cos_LM: Any,
    sin__alpha_KL: Any,
    sin__alpha_KL_squared: Any,
    to_right: Any,
    cos__alpha_KL: Any,
    cos__alpha_KL_squared: Any,
    to_left: Any,
    sin_alpha_KL: Any,
    start_height: Any,
    sin_LM: Any,
) -> Any:
    term_8 = _square(l_BC) + x1 * (2.0 * arm + x1)
    guide_length = _np.sqrt(term_8)
    guide_sum = guide_length + l_BC
    term_9 = sin_DE * guide_sum - cos_DE * x1
    x1_squared = _square(x1)
    lever_square = _square(guide_sum) + x1_squared
    run = 2.0 * l_DE / lever_square * term_9 * x1
    term_17 = _choose_where(l_GH - run > 0.0, 0.0, 1.0)
    push = _maximum(0.0, run - l_GH)
    push_plus_to_right = push + to_right
    to_left_minus_push = to_left - push
    term_10 = push_plus_to_right * to_left_minus_push
    rise = _np.sqrt(term_10)
    rise_sum = rise + start_height
    term_11 = cos_LM * rise_sum - sin_LM * push
    push_squared = _square(push)
    roller_square = push_squared + _square(rise_sum)
    term_14 = 1.0 / _square(roller_square)
    term_15 = 1.0 / push_plus_to_right
    term_16 = 1.0 / to_left_minus_push
    term_6 = (
        2.0 * cos_LM * l_LM / roller_square * push
        - 4.0 * l_LM * push * rise_sum * term_11 * term_14
    )
    term_5 = (
        2.0 * l_LM / roller_square * term_11
        + rise * term_15 * term_16 * term_6 * (to_left / 2.0 - push - to_right / 2.0)
        - 2.0 * sin_LM * l_LM / roller_square * push
        - 4.0 * l_LM * push_squared * term_11 * term_14
    )
    term_18 = 1.0 / _square(lever_square)
    term_3 = -4.0 * l_DE * guide_sum * term_17 * term_18 * term_5 * term_9 * x1
    term_4 = 2.0 * sin_DE * l_DE / lever_square * term_17 * term_5 * x1
    term_2 = term_3 + term_4
    term_7 = 1.0 / _np.sqrt(term_8)
    term = term_2 * term_7 * x1
    term_12 = push / 2.0 + to_right / 2.0
    term_13 = to_left / 2.0 - push / 2.0

    return (
        term_17
        * term_5
        * (2.0 * l_DE / lever_square * term_9 - 2.0 * cos_DE * l_DE / lever_square * x1)
        + term_2 * term_7 * (arm + x1)
        - 4.0 * l_DE * term_17 * term_18 * term_5 * term_9 * x1_squared,
        term,
        term_3 + term_4 + l_BC * term_2 * term_7,
        term,
        2.0 / lever_square * term_17 * term_5 * term_9 * x1,
        -term_17 * term_5,
        sin_alpha_KL * term_6
        + 2.0 * cos__alpha_KL_squared * rise * term_12 * term_15 * term_16 * term_6
        + 2.0 * sin__alpha_KL_squared * rise * term_13 * term_15 * term_16 * term_6,
        2.0 / roller_square * push * term_11,
        2.0 * sin_DE * l_DE / lever_square * term_17 * term_5 * x1_squared
        + 2.0 * cos_DE * l_DE / lever_square * guide_sum * term_17 * term_5 * x1,
        l_KL * _np.cos(alpha_KL) * term_6
        + 2.0 * cos__alpha_KL * sin__alpha_KL * l_KL * rise * term_13 * term_15 * term_16 * term_6
        - 2.0 * cos__alpha_KL * sin__alpha_KL * l_KL * rise * term_12 * term_15 * term_16 * term_6,
        -2.0 * cos_LM * l_LM / roller_square * push_squared
        - 2.0 * sin_LM * l_LM / roller_square * push * rise_sum,
    )
