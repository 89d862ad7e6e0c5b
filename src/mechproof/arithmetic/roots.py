"""Roots in balls: a bracket and an expression -> an enclosure of its only root there.

Parts of the bracket in which the expression is nonzero are discarded until its derivative has one
sign on the rest, which Newton's method for intervals (Moore 1966) then narrows.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache, reduce

import sympy as sp
from flint import acb, arb

from mechproof.arithmetic.ball_functions import NOT_ANALYTIC, NOT_FINITE, Ball
from mechproof.arithmetic.layout import Values
from mechproof.record.implicit import Implicit
from mechproof.record.substitution import substitute

Evaluate = Callable[[sp.Basic, Values], Ball]
# The most halvings of the parts of a bracket, and the most steps that narrow a root.
HALVINGS = 12
_NARROWINGS = 40
# With more parts than this at a time the search for a root is given up.
MOST_PARTS = 64


@dataclass(frozen=True)
class Frame:
    """A root seen from the lower end of its bracket, all in terms of the distance from there."""

    distance: sp.Symbol
    low: sp.Expr
    width: sp.Expr
    start: sp.Expr
    of: sp.Expr
    slope: sp.Expr
    curvature: sp.Expr


@lru_cache(maxsize=64)
def frame(node: Implicit) -> Frame:
    """Write a root by its distance from the lower end, so that common terms may cancel."""
    low, high = node.ends
    distance = sp.Dummy("distance", real=True)
    moved = substitute(node.function, {node.unknown: low + distance})
    of = sp.expand(moved, multinomial=False, power_base=False, power_exp=False, log=False)
    slope = sp.diff(of, distance)
    width, start = sp.expand(high - low), sp.expand(node.start - low)
    return Frame(distance, low, width, start, of, slope, sp.diff(slope, distance))


@dataclass(frozen=True)
class Isolated:
    """Parts of a bracket that contain all its roots: at most one if the slope has a sign."""

    parts: tuple[Ball, ...]
    slope: Ball

    @property
    def is_one(self) -> bool:
        """Return whether there is at most one root."""
        return len(self.parts) == 1 and has_sign(self.slope)


def has_sign(ball: Ball) -> bool:
    """Return whether a ball is finite and excludes zero."""
    return bool(ball.is_finite() and not ball.contains(0))


class Bracketed:
    """A root for given balls of its symbols."""

    def __init__(self, seen: Frame, values: Values, evaluate: Evaluate) -> None:
        self._frame, self._values, self._evaluate = seen, values, evaluate
        self.low, self.width, self.start = (
            evaluate(part, values) for part in (seen.low, seen.width, seen.start)
        )

    def of(self, place: Ball) -> Ball:
        """Enclose the expression whose root is sought, at a distance."""
        return self._at(self._frame.of, place)

    def slope(self, place: Ball) -> Ball:
        """Enclose its derivative."""
        return self._at(self._frame.slope, place)

    def curvature(self, place: Ball) -> Ball:
        """Enclose its second derivative."""
        return self._at(self._frame.curvature, place)

    def _at(self, expression: sp.Expr, place: Ball) -> Ball:
        return self._evaluate(expression, {**self._values, self._frame.distance: place})

    def changes_sign(self) -> bool:
        """Return whether the expression is shown to have opposite signs, or zeros, at the ends."""
        first, last = self.of(arb(0)), self.of(self.width)
        return bool((first <= 0 and last >= 0) or (first >= 0 and last <= 0))

    def isolate(self) -> Isolated:
        """Discard parts without a root until the slope has one sign on the rest, or give up."""
        parts = [arb(0).union(self.width)]
        for _ in range(HALVINGS):
            parts = [part for part in parts if not self._is_nowhere_zero(part)]
            if not parts or len(parts) > MOST_PARTS:
                break
            whole = reduce(arb.union, parts)
            if has_sign(slope := self.slope(whole)):
                return Isolated((whole,), slope)
            parts = [half for part in parts for half in _halve(part)]
        return Isolated(tuple(parts), NOT_FINITE)

    def _is_nowhere_zero(self, part: Ball) -> bool:
        """Check the values over a part, also expanded about its middle, where less cancels."""
        if has_sign(self.of(part)):
            return True
        middle = arb(part.mid())
        return has_sign(self.of(middle) + self.slope(part) * (part - middle))

    def narrow(self, isolated: Isolated) -> Ball:
        """Return as narrow an enclosure as possible of the root known to lie in the only part."""
        (place,), slope = isolated.parts, isolated.slope
        for _ in range(_NARROWINGS):
            middle = arb(place.mid())
            step = middle - self.of(middle) / slope
            # Both contain the root, if there is one: if they do not meet, nothing is known.
            if not step.overlaps(place):
                return NOT_FINITE
            narrower = step.intersection(place)
            # Newton's steps square the error: a step that does not even halve it is at the limit of
            # precision.
            if not 2 * narrower.rad() < place.rad():
                return narrower
            place, slope = narrower, self.slope(narrower)
        return place


def _halve(part: Ball) -> tuple[Ball, Ball]:
    middle = arb(part.mid())
    return part.lower().union(middle), middle.union(part.upper())


def enclose_root(node: Implicit, values: Values, evaluate: Evaluate) -> Ball:
    """Enclose the only root in the bracket; not finite unless exactly one is shown to exist."""
    if any(isinstance(value, acb) for value in values.values()):
        return NOT_ANALYTIC
    given = Bracketed(frame(node), values, evaluate)
    if not (given.low.is_finite() and given.width.is_finite() and given.width >= 0):
        return NOT_FINITE
    isolated = given.isolate()
    # At most one root by the slope, at least one by the signs at the ends.
    if not (isolated.is_one and given.changes_sign()):
        return NOT_FINITE
    return given.low + given.narrow(isolated)


def enclose_iterate(node: Implicit, values: Values, evaluate: Evaluate) -> Ball:
    """Enclose the last of Newton's iterates."""
    if any(isinstance(value, acb) for value in values.values()):
        return NOT_ANALYTIC
    given = Bracketed(frame(node), values, evaluate)
    place = given.start
    for _ in range(node.steps):
        place = place - given.of(place) / given.slope(place)
    return given.low + place
