"""The inverse of an increasing function, to the last bit: a bracket shrinks to two neighbours.

Doubles are numbered in order, so a bracket of any width holds fewer than 2**64 of them, even in a
steep part, where the function covers much of its range between neighbours. Each step is an ITP step
(Oliveira and Takahashi 2020): interpolation, pushed towards the middle and kept so near to it that
at most one more step is needed than by bisection of the count.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechproof.kernel_support.arrays import as_floats
from mechproof.kernel_support.order import from_order, to_order

Floats = NDArray[np.float64]
Orders = NDArray[np.int64]

LARGEST = np.finfo(np.float64).max
# A bracket for the exact function is widened for the computed one by this relative amount: twice
# the accuracy bound of the position kernels, 5.5 and 7 eps, plus the rounding of the bracket, some
# ten operations of half an eps.
WIDENING = 20 * np.finfo(float).eps
# An angle may be subnormal where the value is not; there the widening is absolute.
FINEST = 4 * float(np.finfo(float).smallest_subnormal)
# The push towards the middle, as a share of the bracket's squared width over the first width.
PUSH = 0.2


def invert(
    function: Callable[[Floats], Any], wanted: Floats, low: Floats, high: Floats, *, failure: str
) -> Floats:
    """Solve function(x) = wanted for x between `low` and `high`, arrays of one shape.

    Of the two neighbouring doubles between which the computed function passes `wanted`, return the
    one with the nearer value. The function must increase; ends are clipped to the largest doubles.

    Raises
    ------
    ArithmeticError
        If the function's values at the ends do not enclose a value of `wanted`, or are NaN; the
        message has `failure` and these values.

    """
    target = np.ravel(wanted)
    ends = [np.clip(np.ravel(end), -LARGEST, LARGEST) for end in (low, high)]
    below, above = map(to_order, ends)
    short, long = (np.asarray(function(end) - target) for end in ends)
    _check_enclosed(target, short, long, failure)
    first = _count(below, above)
    halvings = np.ceil(np.log2(np.maximum(first, 1.0)))
    step = 0
    (active,) = np.nonzero(first > 1)
    while active.size:
        a, b, fa, fb = below[active], above[active], short[active], long[active]
        room = np.exp2(halvings[active] - step)
        c = _place(a, b, fa, fb, first[active], room)
        value = np.asarray(function(from_order(c)) - target[active])
        beneath = value <= 0
        below[active], short[active] = np.where(beneath, c, a), np.where(beneath, value, fa)
        above[active], long[active] = np.where(beneath, b, c), np.where(beneath, fb, value)
        active = active[_count(below[active], above[active]) > 1]
        step += 1
    _check_enclosed(target, short, long, failure)
    nearest = np.where(-short <= long, below, above)
    return from_order(nearest).reshape(np.shape(wanted))


def invert_odd(name: str, given: Any, solve: Callable[[Floats], Any]) -> Any:
    """Invert an odd function at angles of any number of turns; NaN where they are not finite.

    `solve` inverts the function at positive, finite values. A mask or an index is kept, and so is
    the type of the floats. A TypeError calls `given` by `name`.
    """
    (angles,) = as_floats(name, given)
    target = np.asarray(angles)
    proper = np.isfinite(target) & (target != 0)
    size = np.where(proper, np.abs(target), 1.0).astype(np.float64)
    root = np.copysign(1.0, target) * solve(size)
    root = np.where(proper, root, np.where(target == 0, target, np.nan))
    return follow_kind(angles, root.astype(target.dtype))


def _check_enclosed(target: Floats, short: Floats, long: Floats, failure: str) -> None:
    enclosed = (short <= 0) & (long >= 0)
    if not enclosed.all():
        raise ArithmeticError(f"{failure} = {target[~enclosed]!r}")


def _place(a: Orders, b: Orders, fa: Floats, fb: Floats, first: Floats, room: Floats) -> Orders:
    """Return a place strictly between a and b: interpolate, push, keep near the middle."""
    width, (low, high) = _count(a, b), map(from_order, (a, b))
    with np.errstate(over="ignore", invalid="ignore"):
        crossing = low - fa * ((high - low) / (fb - fa))
    crossing = np.where(np.isfinite(crossing), np.clip(crossing, low, high), low / 2 + high / 2)
    away = _count(a, to_order(crossing)) - width / 2
    push = np.maximum(PUSH * width * (width / first), 1.0)
    away = np.sign(away) * np.maximum(np.abs(away) - push, 0.0)
    reach = np.maximum(room - width / 2, 0.0)
    ahead = np.clip(np.rint(width / 2 + np.clip(away, -reach, reach)), 1.0, None)
    # Beyond 2**53 the count is rounded.
    steps = np.minimum(ahead.astype(np.uint64), (b - a).view(np.uint64) - np.uint64(1))
    places: Orders = (a.view(np.uint64) + steps).view(np.int64)
    return places


def _count(a: Orders, b: Orders) -> Floats:
    """Return the number of doubles from a to b; the difference may need all 64 bits."""
    return (b - a).view(np.uint64).astype(np.float64)


def follow_kind(given: Any, values: NDArray[Any]) -> Any:
    """Return `values` with the mask, index or other kind of the array they were computed from.

    The result is NaN where `given` is not finite, and a NumPy scalar if there are no axes.
    """
    if type(given) is np.ndarray or isinstance(given, (float, np.generic)):
        return values[()]
    with np.errstate(invalid="ignore"):
        return (1 + (given - given)) * values
