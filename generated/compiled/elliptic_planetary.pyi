"""Types of the kernels of `elliptic_planetary`.

Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""

from typing import Any, TypeAlias as _TypeAlias

from numpy.typing import ArrayLike, NDArray

from ..elliptic_planetary import *

_Out: _TypeAlias = NDArray[Any] | None

def motion(
    phi1: ArrayLike, R1: ArrayLike, R2: ArrayLike, e: ArrayLike, *, out: _Out = None
) -> NDArray[Any]: ...
