"""The support for compiled code: machine operations, and loops over arrays of every shape.

Needs numba; only the generated package `kernels.compiled` and `conformity.compiled` import it.
"""

from mechproof.compiled_support.loops import Loops, run, run_parts, take_row
from mechproof.compiled_support.machine import (
    choose,
    copysign,
    floor,
    fma,
    inner,
    is_finite,
    loop,
    maximum,
    point_of,
    power_of_two,
    rint,
    scalar,
    stand_in,
    widen,
)
from mechproof.compiled_support.point_loops import fill, fill_blocks, vector
from mechproof.compiled_support.points import POINTS, count_numbers, put, take
from mechproof.compiled_support.sum_sets import add_up, element, every, fill_sets
from mechproof.compiled_support.sum_terms import count_terms, take_square, take_terms
from mechproof.compiled_support.sums import Sums, run_sums

__all__ = [
    "POINTS",
    "Loops",
    "Sums",
    "add_up",
    "choose",
    "copysign",
    "count_numbers",
    "count_terms",
    "element",
    "every",
    "fill",
    "fill_blocks",
    "fill_sets",
    "floor",
    "fma",
    "inner",
    "is_finite",
    "loop",
    "maximum",
    "point_of",
    "power_of_two",
    "put",
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
    "vector",
    "widen",
]
