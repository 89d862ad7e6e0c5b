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
    power_of_two,
    rint,
    scalar,
    widen,
)
from mechproof.compiled_support.sums import (
    Sums,
    count_terms,
    run_sums,
    take_square,
    take_terms,
)

__all__ = [
    "BLOCK",
    "Loops",
    "Sums",
    "choose",
    "copysign",
    "count_terms",
    "floor",
    "fma",
    "has_nan",
    "is_finite",
    "loop",
    "maximum",
    "overload",
    "power_of_two",
    "rint",
    "run",
    "run_sums",
    "scalar",
    "take_row",
    "take_square",
    "take_terms",
    "widen",
]
