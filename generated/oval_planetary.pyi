"""Types of the kernels of `oval_planetary`.

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
def ratio(phi1: _float, e1: _float, e2: _float, mount: _float = ...) -> _float64: ...
@_overload
def ratio(phi1: _Floats, e1: _Floats, e2: _Floats, mount: _Floats = ...) -> NDArray[_float64]: ...
@_overload
def ratio(
    phi1: ArrayLike, e1: ArrayLike, e2: ArrayLike, mount: ArrayLike = ..., *, out: _Out = None
) -> Any: ...
@_overload
def position(phi1: _float, e1: _float, e2: _float, mount: _float = ...) -> _float64: ...
@_overload
def position(
    phi1: _Floats, e1: _Floats, e2: _Floats, mount: _Floats = ...
) -> NDArray[_float64]: ...
@_overload
def position(
    phi1: ArrayLike, e1: ArrayLike, e2: ArrayLike, mount: ArrayLike = ..., *, out: _Out = None
) -> Any: ...
@_overload
def acceleration(phi1: _float, e1: _float, e2: _float, mount: _float = ...) -> _float64: ...
@_overload
def acceleration(
    phi1: _Floats, e1: _Floats, e2: _Floats, mount: _Floats = ...
) -> NDArray[_float64]: ...
@_overload
def acceleration(
    phi1: ArrayLike, e1: ArrayLike, e2: ArrayLike, mount: ArrayLike = ..., *, out: _Out = None
) -> Any: ...
@_overload
def ratio_cylindrical(phi1: _float, R4: _float, R5: _float, e2: _float) -> _float64: ...
@_overload
def ratio_cylindrical(
    phi1: _Floats, R4: _Floats, R5: _Floats, e2: _Floats
) -> NDArray[_float64]: ...
@_overload
def ratio_cylindrical(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: _Out = None
) -> Any: ...
@_overload
def position_cylindrical(phi1: _float, R4: _float, R5: _float, e2: _float) -> _float64: ...
@_overload
def position_cylindrical(
    phi1: _Floats, R4: _Floats, R5: _Floats, e2: _Floats
) -> NDArray[_float64]: ...
@_overload
def position_cylindrical(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: _Out = None
) -> Any: ...
@_overload
def acceleration_cylindrical(phi1: _float, R4: _float, R5: _float, e2: _float) -> _float64: ...
@_overload
def acceleration_cylindrical(
    phi1: _Floats, R4: _Floats, R5: _Floats, e2: _Floats
) -> NDArray[_float64]: ...
@_overload
def acceleration_cylindrical(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: _Out = None
) -> Any: ...
@_overload
def jerk(phi1: _float, e1: _float, e2: _float, mount: _float = ...) -> _float64: ...
@_overload
def jerk(phi1: _Floats, e1: _Floats, e2: _Floats, mount: _Floats = ...) -> NDArray[_float64]: ...
@_overload
def jerk(
    phi1: ArrayLike, e1: ArrayLike, e2: ArrayLike, mount: ArrayLike = ..., *, out: _Out = None
) -> Any: ...
@_overload
def jerk_cylindrical(phi1: _float, R4: _float, R5: _float, e2: _float) -> _float64: ...
@_overload
def jerk_cylindrical(phi1: _Floats, R4: _Floats, R5: _Floats, e2: _Floats) -> NDArray[_float64]: ...
@_overload
def jerk_cylindrical(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: _Out = None
) -> Any: ...
