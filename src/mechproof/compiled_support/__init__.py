"""What compiled code calls: machine operations, and loops over arrays of every shape.

Needs numba; only the generated package `kernels.compiled` and `conformity.compiled` import it.
"""

from mechproof.compiled_support.loops import Loops, run, run_parts, take_row
from mechproof.compiled_support.machine import (
    BLOCK,
    choose,
    copysign,
    floor,
    fma,
    has_nan,
    inner,
    is_finite,
    loop,
    maximum,
    overload,
    power_of_two,
    rint,
    scalar,
    stand_in,
    widen,
)
from mechproof.compiled_support.points import POINTS, count_numbers, own_row, put, take
from mechproof.compiled_support.sums import (
    Sums,
    count_sets,
    count_terms,
    put_sets,
    run_sums,
    take_square,
    take_terms,
)

__all__ = [
    "BLOCK",
    "POINTS",
    "Loops",
    "Sums",
    "choose",
    "copysign",
    "count_numbers",
    "count_sets",
    "count_terms",
    "floor",
    "fma",
    "has_nan",
    "inner",
    "is_finite",
    "loop",
    "maximum",
    "overload",
    "own_row",
    "power_of_two",
    "put",
    "put_sets",
    "rint",
    "run",
    "run_parts",
    "run_sums",
    "scalar",
    "stand_in",
    "take",
    "take_row",
    "take_square",
    "take_terms",
    "widen",
]
