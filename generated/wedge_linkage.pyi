"""Types of the kernels of `wedge_linkage`.

Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""

from builtins import float as _float, tuple as _tuple
from typing import Any, TypeAlias as _TypeAlias, overload as _overload

from numpy import float64 as _float64
from numpy.typing import ArrayLike, NDArray

from mechproof.kernel_support.facts import Condition as _Condition, Sizes as _Sizes

DOMAIN: _tuple[_Condition, ...]
PUBLISHED: _tuple[_Sizes, ...]
_Floats: _TypeAlias = _float | NDArray[_float64]
_Out: _TypeAlias = NDArray[Any] | None

@_overload
def guide_radicand(x1: _float, l_AB: _float, l_BC: _float, l_CD: _float) -> _float64: ...
@_overload
def guide_radicand(
    x1: _Floats, l_AB: _Floats, l_BC: _Floats, l_CD: _Floats
) -> NDArray[_float64]: ...
@_overload
def guide_radicand(
    x1: ArrayLike, l_AB: ArrayLike, l_BC: ArrayLike, l_CD: ArrayLike, *, out: _Out = None
) -> Any: ...
@_overload
def lever_angle(x1: _float, l_AB: _float, l_BC: _float, l_CD: _float) -> _float64: ...
@_overload
def lever_angle(x1: _Floats, l_AB: _Floats, l_BC: _Floats, l_CD: _Floats) -> NDArray[_float64]: ...
@_overload
def lever_angle(
    x1: ArrayLike, l_AB: ArrayLike, l_BC: ArrayLike, l_CD: ArrayLike, *, out: _Out = None
) -> Any: ...
@_overload
def rod_displacement(phi3: _float, l_DE: _float, alpha_DE: _float) -> _float64: ...
@_overload
def rod_displacement(phi3: _Floats, l_DE: _Floats, alpha_DE: _Floats) -> NDArray[_float64]: ...
@_overload
def rod_displacement(
    phi3: ArrayLike, l_DE: ArrayLike, alpha_DE: ArrayLike, *, out: _Out = None
) -> Any: ...
@_overload
def clearance(x5: _float, l_GH: _float) -> _float64: ...
@_overload
def clearance(x5: _Floats, l_GH: _Floats) -> NDArray[_float64]: ...
@_overload
def clearance(x5: ArrayLike, l_GH: ArrayLike, *, out: _Out = None) -> Any: ...
@_overload
def roller_offset(x5: _float, l_KL: _float, alpha_KL: _float) -> _float64: ...
@_overload
def roller_offset(x5: _Floats, l_KL: _Floats, alpha_KL: _Floats) -> NDArray[_float64]: ...
@_overload
def roller_offset(
    x5: ArrayLike, l_KL: ArrayLike, alpha_KL: ArrayLike, *, out: _Out = None
) -> Any: ...
@_overload
def roller_lever_angle(x5: _float, l_KL: _float, alpha_KL: _float) -> _float64: ...
@_overload
def roller_lever_angle(x5: _Floats, l_KL: _Floats, alpha_KL: _Floats) -> NDArray[_float64]: ...
@_overload
def roller_lever_angle(
    x5: ArrayLike, l_KL: ArrayLike, alpha_KL: ArrayLike, *, out: _Out = None
) -> Any: ...
@_overload
def wedge_displacement(phi7: _float, l_LM: _float, alpha_LM: _float) -> _float64: ...
@_overload
def wedge_displacement(phi7: _Floats, l_LM: _Floats, alpha_LM: _Floats) -> NDArray[_float64]: ...
@_overload
def wedge_displacement(
    phi7: ArrayLike, l_LM: ArrayLike, alpha_LM: ArrayLike, *, out: _Out = None
) -> Any: ...
@_overload
def position(
    x1: _float,
    l_AB: _float,
    l_BC: _float,
    l_CD: _float,
    l_DE: _float,
    l_GH: _float,
    l_KL: _float,
    l_LM: _float,
    alpha_DE: _float,
    alpha_KL: _float,
    alpha_LM: _float,
) -> _float64: ...
@_overload
def position(
    x1: _Floats,
    l_AB: _Floats,
    l_BC: _Floats,
    l_CD: _Floats,
    l_DE: _Floats,
    l_GH: _Floats,
    l_KL: _Floats,
    l_LM: _Floats,
    alpha_DE: _Floats,
    alpha_KL: _Floats,
    alpha_LM: _Floats,
) -> NDArray[_float64]: ...
@_overload
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
    out: _Out = None,
) -> Any: ...
@_overload
def velocity(
    x1: _float,
    l_AB: _float,
    l_BC: _float,
    l_CD: _float,
    l_DE: _float,
    l_GH: _float,
    l_KL: _float,
    l_LM: _float,
    alpha_DE: _float,
    alpha_KL: _float,
    alpha_LM: _float,
) -> _float64: ...
@_overload
def velocity(
    x1: _Floats,
    l_AB: _Floats,
    l_BC: _Floats,
    l_CD: _Floats,
    l_DE: _Floats,
    l_GH: _Floats,
    l_KL: _Floats,
    l_LM: _Floats,
    alpha_DE: _Floats,
    alpha_KL: _Floats,
    alpha_LM: _Floats,
) -> NDArray[_float64]: ...
@_overload
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
    out: _Out = None,
) -> Any: ...
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
    out: _Out = None,
) -> NDArray[Any]: ...
