"""Expressions over boxes of sizes, enclosed by balls; SymPy and flint are loaded when called."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from functools import reduce
from typing import Any

import numpy as np

BITS = 96

Limits = tuple[float, float]
Box = dict[Any, Limits]
# Values of the symbols that do not vary.
Known = Mapping[Any, float]


def enclose(expression: Any, known: Known, box: Box) -> Any:
    """Return a ball that holds every value of the expression over the box."""
    from mechproof.proof import balls

    values = {s: balls.to_ball(v) for s, v in known.items()}
    values |= {s: enclose_interval(limits) for s, limits in box.items()}
    return balls.evaluate(expression, values, BITS)


def enclose_interval(limits: Limits) -> Any:
    """Return a ball that holds both limits."""
    from flint import arb

    low, high = limits
    return arb(low) if low == high else arb(low).union(arb(high))


def differentiate(value: Any, symbol: Any) -> list[Any]:
    """Differentiate; each step function at a kink of Max may be anything from 0 to 1.

    The expression must be continuous: by the mean value theorem of Lipschitz functions the slope
    between two points lies in the hull of the branches. Raises ValueError for branches that need
    not meet.
    """
    import sympy as sp

    if value.has(sp.Piecewise, sp.floor, sp.sign):
        raise ValueError("the quantity has branches that need not meet; use Max, Min or Abs")
    kinked = value.replace(sp.Abs, lambda a: sp.Max(a, -a))
    slope = sp.diff(kinked, symbol)
    steps = sorted(slope.atoms(sp.Heaviside), key=str)
    choices = itertools.product((0, 1), repeat=len(steps))
    return [slope.xreplace(dict(zip(steps, map(sp.Integer, c), strict=True))) for c in choices]


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
