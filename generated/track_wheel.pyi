"""Types of the kernels of `track_wheel`.

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

def rotation(
    alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, *, out: _Out = None
) -> NDArray[Any]: ...
def displacement(
    points: ArrayLike, angles: ArrayLike, shift: ArrayLike, *, out: _Out = None
) -> NDArray[Any]: ...
def planar_error(displacement: ArrayLike, *, out: _Out = None) -> Any: ...
def spatial_error(displacement: ArrayLike, *, out: _Out = None) -> Any: ...
@_overload
def radius(phi: _float, R: _float, A: _float, z: _float) -> _float64: ...
@_overload
def radius(phi: _Floats, R: _Floats, A: _Floats, z: _Floats) -> NDArray[_float64]: ...
@_overload
def radius(
    phi: ArrayLike, R: ArrayLike, A: ArrayLike, z: ArrayLike, *, out: _Out = None
) -> Any: ...
def track(
    phi: ArrayLike, R: ArrayLike, A: ArrayLike, z: ArrayLike, H: ArrayLike, *, out: _Out = None
) -> NDArray[Any]: ...
@_overload
def largest_radius(R: _float, A: _float) -> _float64: ...
@_overload
def largest_radius(R: _Floats, A: _Floats) -> NDArray[_float64]: ...
@_overload
def largest_radius(R: ArrayLike, A: ArrayLike, *, out: _Out = None) -> Any: ...
@_overload
def smallest_radius(R: _float, A: _float) -> _float64: ...
@_overload
def smallest_radius(R: _Floats, A: _Floats) -> NDArray[_float64]: ...
@_overload
def smallest_radius(R: ArrayLike, A: ArrayLike, *, out: _Out = None) -> Any: ...
def error_sum_correlated(
    tolerances: ArrayLike,
    sensitivities: ArrayLike,
    scatters: ArrayLike,
    correlation: ArrayLike,
    total_scatter: ArrayLike,
    *,
    out: _Out = None,
) -> Any: ...
def error_sum(
    tolerances: ArrayLike,
    sensitivities: ArrayLike,
    scatters: ArrayLike,
    total_scatter: ArrayLike,
    *,
    out: _Out = None,
) -> Any: ...
def error_sum_thermal(
    tolerances: ArrayLike,
    sensitivities: ArrayLike,
    scatters: ArrayLike,
    total_scatter: ArrayLike,
    thermal_share: ArrayLike,
    thermal_scatter: ArrayLike,
    *,
    out: _Out = None,
) -> Any: ...
@_overload
def tilt_of_planar_error(error: _float, offset: _float, rho: _float, H: _float) -> _float64: ...
@_overload
def tilt_of_planar_error(
    error: _Floats, offset: _Floats, rho: _Floats, H: _Floats
) -> NDArray[_float64]: ...
@_overload
def tilt_of_planar_error(
    error: ArrayLike, offset: ArrayLike, rho: ArrayLike, H: ArrayLike, *, out: _Out = None
) -> Any: ...
@_overload
def tilt_of_spatial_error(error: _float, offset: _float, rho: _float, H: _float) -> _float64: ...
@_overload
def tilt_of_spatial_error(
    error: _Floats, offset: _Floats, rho: _Floats, H: _Floats
) -> NDArray[_float64]: ...
@_overload
def tilt_of_spatial_error(
    error: ArrayLike, offset: ArrayLike, rho: ArrayLike, H: ArrayLike, *, out: _Out = None
) -> Any: ...
