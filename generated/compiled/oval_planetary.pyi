"""Types of the kernels of `oval_planetary`.

Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""

from typing import Any, TypeAlias as _TypeAlias

from numpy.typing import ArrayLike, NDArray

from ..oval_planetary import *

_Out: _TypeAlias = NDArray[Any] | None

def motion(
    phi1: ArrayLike, e1: ArrayLike, e2: ArrayLike, mount: ArrayLike = ..., *, out: _Out = None
) -> NDArray[Any]: ...
def motion_cylindrical(
    phi1: ArrayLike, R4: ArrayLike, R5: ArrayLike, e2: ArrayLike, *, out: _Out = None
) -> NDArray[Any]: ...
