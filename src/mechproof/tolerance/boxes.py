"""Boxes of sizes, balls over them and what is read off balls; flint is loaded when called."""

from __future__ import annotations

from collections.abc import Mapping
from functools import reduce
from typing import Any

import numpy as np

Limits = tuple[float, float]
Box = dict[Any, Limits]
# Values of the symbols that do not vary.
Known = Mapping[Any, float]


def to_values(known: Known, box: Box) -> dict[Any, Any]:
    """Return balls of the known numbers and of all that lies between the limits."""
    from flint import arb

    values = {s: arb(v) for s, v in known.items()}
    return values | {s: enclose_interval(limits) for s, limits in box.items()}


def enclose_interval(limits: Limits) -> Any:
    """Return a ball that holds both limits."""
    from flint import arb

    low, high = limits
    return arb(low) if low == high else arb(low).union(arb(high))


def open_symbols(box: Box) -> list[Any]:
    """List the symbols whose limits are apart."""
    return [s for s, (a, b) in box.items() if a < b]


def find_middle(box: Box) -> Box:
    """Return the point in the middle of the box."""
    return {s: ((a + b) / 2,) * 2 for s, (a, b) in box.items()}


def put_to_limit(box: Box, symbol: Any, upper: bool) -> Box:
    """Return the face of the box where the symbol is at one of its limits."""
    return {**box, symbol: (box[symbol][upper],) * 2}


def halve(box: Box, symbol: Any) -> tuple[Box, Box]:
    """Cut the box in the middle between the limits of the symbol."""
    low, high = box[symbol]
    middle = (low + high) / 2
    return {**box, symbol: (low, middle)}, {**box, symbol: (middle, high)}


def find_widest(box: Box, whole: Box) -> Any:
    """Return the symbol that has kept most of its limits' distance, None for a point."""
    shares = {s: np.subtract(*box[s]) / np.subtract(*whole[s]) for s in open_symbols(box)}
    return max(shares, key=shares.__getitem__, default=None)


def common_sign(slopes: list[Any]) -> int:
    """Return the sign that all slopes are proved to have, 0 if none."""
    if all(s >= 0 for s in slopes):
        return 1
    return -1 if all(s <= 0 for s in slopes) else 0


def hull(slopes: list[Any]) -> Any:
    """Return a ball that holds all slopes."""
    return reduce(lambda whole, slope: whole.union(slope), slopes)


def steepest(slopes: list[Any], limits: Limits) -> float:
    """Return how far the value may run between the limits."""
    whole = hull(slopes)
    slope = float(whole.abs_upper()) if whole.is_finite() else np.inf
    return slope * (limits[1] - limits[0])


def width(ball: Any) -> float:
    """Return the radius of a ball, infinite where it is not finite."""
    return float(ball.rad()) if ball.is_finite() else np.inf


def round_up(ball: Any) -> float:
    """Return a double not below any value of the ball, infinite where it is not finite."""
    return -_round_down(-ball.upper()) if ball.is_finite() else np.inf


def round_down(ball: Any) -> float:
    """Return a double not above any value of the ball, infinite where it is not finite."""
    return _round_down(ball.lower()) if ball.is_finite() else -np.inf


def _round_down(number: Any) -> float:
    # float() of a ball rounds to some neighbour.
    return float(np.nextafter(float(number), -np.inf))
