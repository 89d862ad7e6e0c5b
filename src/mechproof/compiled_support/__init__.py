"""What compiled kernels call: machine operations, and loops over arrays of every shape.

Needs numba; only the generated package `kernels.compiled` imports it.
"""

from mechproof.compiled_support.loops import Loops, run, take_row
from mechproof.compiled_support.machine import (
    BLOCK,
    choose,
    copysign,
    floor,
    fma,
    has_nan,
    is_finite,
    loop,
    maximum,
    overload,
    rint,
    scalar,
    widen,
)

__all__ = [
    "BLOCK",
    "Loops",
    "choose",
    "copysign",
    "floor",
    "fma",
    "has_nan",
    "is_finite",
    "loop",
    "maximum",
    "overload",
    "rint",
    "run",
    "scalar",
    "take_row",
    "widen",
]
