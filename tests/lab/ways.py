"""Quantities, ways to compute them, and their errors against the oracle, for these tests."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
from quantities import find_subject

from mechproof.lab.oracle import Errors, Truth, find_errors, find_truth, summarise
from mechproof.lab.sampling.named_sets import REPORT, draw_points
from mechproof.lab.sampling.point_sets import list_sets
from mechproof.lab.ways import Arguments, Way
from mechproof.measured import SetErrors

EPS = float(np.finfo(float).eps)
ELLIPTIC, OVAL = "elliptic_planetary.position", "oval_planetary.position"
CYLINDRICAL = "oval_planetary.position_cylindrical"
HEIGHT, THICKNESS = "tooth_thickness.height_change", "tooth_thickness.thickness_change"
# Sizes of the wheels in their kernels' order.
SPUR, OVALS, CYLINDERS = (66.0, 16.0, 0.475), (0.8, 0.8, 0.0), (32.0, 18.0, 0.2)
WHEEL = (3.0, 50.0, np.pi / 9)


def at(running: Any, *sizes: float) -> Arguments:
    return np.asarray(running, float), *map(np.array, sizes)


def sweep(turns: float, count: int, *sizes: float) -> Arguments:
    return at(np.linspace(0, turns * 2 * np.pi, count), *sizes)


def find_way(quantity: str, name: str) -> Way:
    return next(w for w in find_subject(quantity).ways if w.name == name)


def bound_of(quantity: str) -> float:
    accuracy = find_subject(quantity).quantity.accuracy
    assert accuracy is not None
    return accuracy.ulp


KNOWN: dict[tuple[object, ...], Truth] = {}


def truth_of(quantity: str, arguments: Arguments) -> Truth:
    """Return the true values, cached because several ways are compared with them."""
    key = (quantity, *((np.shape(a), np.asarray(a).tobytes()) for a in arguments))
    if key not in KNOWN:
        KNOWN[key] = find_truth(find_subject(quantity), arguments)
    return KNOWN[key]


def compare(quantity: str, name: str, arguments: Arguments) -> Errors:
    """Return a way's errors against the oracle, NaN where it is undecided."""
    with np.errstate(all="ignore"):
        result = find_way(quantity, name).compute(*arguments)
    return find_errors(result, truth_of(quantity, arguments))


def run(quantity: str, name: str, arguments: Arguments) -> Errors:
    """Return a way's errors against the oracle, which must decide every point."""
    assert truth_of(quantity, arguments).undecided == 0
    return compare(quantity, name, arguments)


def sum_up(quantity: str, name: str, arguments: Arguments) -> SetErrors:
    """Return a summary of a way's errors, including the number of wrong branches."""
    errors = run(quantity, name, arguments)
    return summarise(errors, truth_of(quantity, arguments), find_subject(quantity).period)


@cache
def draw_set(quantity: str, name: str, share: float = 1.0) -> Arguments:
    """Draw the first set whose name contains `name`."""
    sets = list_sets(find_subject(quantity), share)
    return draw_points(next(s for s in sets if name in s.name), REPORT)
