"""Types of the kernels of `tooth_thickness`.

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
def constant_chord(m: _float, alpha: _float) -> _float64: ...
@_overload
def constant_chord(m: _Floats, alpha: _Floats) -> NDArray[_float64]: ...
@_overload
def constant_chord(m: ArrayLike, alpha: ArrayLike, *, out: _Out = None) -> Any: ...
@_overload
def chord_height(m: _float, alpha: _float) -> _float64: ...
@_overload
def chord_height(m: _Floats, alpha: _Floats) -> NDArray[_float64]: ...
@_overload
def chord_height(m: ArrayLike, alpha: ArrayLike, *, out: _Out = None) -> Any: ...
@_overload
def height_change(tilt: _float, m: _float, z: _float, alpha: _float) -> _float64: ...
@_overload
def height_change(tilt: _Floats, m: _Floats, z: _Floats, alpha: _Floats) -> NDArray[_float64]: ...
@_overload
def height_change(
    tilt: ArrayLike, m: ArrayLike, z: ArrayLike, alpha: ArrayLike, *, out: _Out = None
) -> Any: ...
@_overload
def thickness_change(tilt: _float, m: _float, z: _float, alpha: _float) -> _float64: ...
@_overload
def thickness_change(
    tilt: _Floats, m: _Floats, z: _Floats, alpha: _Floats
) -> NDArray[_float64]: ...
@_overload
def thickness_change(
    tilt: ArrayLike, m: ArrayLike, z: ArrayLike, alpha: ArrayLike, *, out: _Out = None
) -> Any: ...
@_overload
def thickness_change_linear(dh: _float, alpha: _float) -> _float64: ...
@_overload
def thickness_change_linear(dh: _Floats, alpha: _Floats) -> NDArray[_float64]: ...
@_overload
def thickness_change_linear(dh: ArrayLike, alpha: ArrayLike, *, out: _Out = None) -> Any: ...
@_overload
def linearisation_bound(dh: _float, m: _float, z: _float, alpha: _float) -> _float64: ...
@_overload
def linearisation_bound(
    dh: _Floats, m: _Floats, z: _Floats, alpha: _Floats
) -> NDArray[_float64]: ...
@_overload
def linearisation_bound(
    dh: ArrayLike, m: ArrayLike, z: ArrayLike, alpha: ArrayLike, *, out: _Out = None
) -> Any: ...
@_overload
def thickness_error(e_tip: _float, height_error: _float, alpha: _float) -> _float64: ...
@_overload
def thickness_error(e_tip: _Floats, height_error: _Floats, alpha: _Floats) -> NDArray[_float64]: ...
@_overload
def thickness_error(
    e_tip: ArrayLike, height_error: ArrayLike, alpha: ArrayLike, *, out: _Out = None
) -> Any: ...
