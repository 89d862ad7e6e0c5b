"""What compiled kernels call: machine operations, and loops over arrays of every shape.

Needs numba; only the generated package `kernels.compiled` imports it.
"""

from numba.extending import overload

from mechproof.compiled_support.loops import Loops, run
from mechproof.compiled_support.machine import (
    BLOCK,
    copysign,
    floor,
    fma,
    is_finite,
    loop,
    maximum,
    rint,
    scalar,
)

__all__ = [
    "BLOCK",
    "Loops",
    "copysign",
    "floor",
    "fma",
    "is_finite",
    "loop",
    "maximum",
    "overload",
    "rint",
    "run",
    "scalar",
]
