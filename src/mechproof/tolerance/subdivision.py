"""Branch and bound over a box of sizes, with slopes that move sizes to their limits.

The method is that of Moore and Skelboe (1974) with the monotonicity test of Hansen and Walster
(2004). A box has slopes in balls, which reduce it to a face and choose the cut. A few hundred
suffice, one by one; `arithmetic.cover` bounds thousands at once in doubles, without slopes.
"""

from __future__ import annotations

import heapq
import itertools
from collections.abc import Mapping
from functools import reduce
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from mechproof.tolerance.problem import Problem

Limits = tuple[float, float]
Box = dict[Any, Limits]
# Values of the symbols that do not vary.
Known = Mapping[Any, float]


def to_values(known: Known, box: Box) -> dict[Any, Any]:
    """Return balls of the known numbers and of the ranges between the limits."""
    from flint import arb

    values = {s: arb(v) for s, v in known.items()}
    return values | {s: enclose_interval(limits) for s, limits in box.items()}


def enclose_interval(limits: Limits) -> Any:
    """Return a ball that contains both limits."""
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
    """Return the symbol with the largest remaining fraction of its range, or None for a point."""
    shares = {s: np.subtract(*box[s]) / np.subtract(*whole[s]) for s in open_symbols(box)}
    return max(shares, key=shares.__getitem__, default=None)


def common_sign(slopes: list[Any]) -> int:
    """Return the sign that all slopes are proved to have, or 0."""
    if all(s >= 0 for s in slopes):
        return 1
    return -1 if all(s <= 0 for s in slopes) else 0


def hull(slopes: list[Any]) -> Any:
    """Return a ball that contains all slopes."""
    return reduce(lambda whole, slope: whole.union(slope), slopes)


def steepest(slopes: list[Any], limits: Limits) -> float:
    """Return a bound on the change of the value between the limits."""
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


class BoundedBox(NamedTuple):
    """A bound over a box, the face with the extreme, the size to cut, and whether it is inside."""

    bound: float
    box: Box
    cut: Any
    inside: bool


class Search:
    """Branch and bound for the largest value of direction * quantity."""

    def __init__(self, problem: Problem, known: Known, direction: int) -> None:
        self.problem, self.known, self.direction = problem, known, direction
        self.attained = self.bound = -np.inf
        self.boxes = 0
        self.turning: set[Any] = set()

    def run(self, gap: float, budget: int) -> Search:
        """Cut the box with the largest bound until the gap is closed or the budget is spent."""
        order = itertools.count()
        first = self._examine(self.problem.limits, inside=False)
        self.turning = set(open_symbols(first.box))
        # Among equal bounds, one that no cut can lower comes first: it ends the search.
        heap = [(-first.bound, first.cut is not None, next(order), first)]
        while self.boxes < budget:
            part = heap[0][-1]
            if part.bound - self.attained <= gap or part.cut is None:
                break
            heapq.heappop(heap)
            for half in halve(part.box, part.cut):
                found = self._examine(half, part.inside)
                heapq.heappush(heap, (-found.bound, found.cut is not None, next(order), found))
        self.bound = max(heap[0][-1].bound, self.attained)
        return self

    def _examine(self, box: Box, inside: bool) -> BoundedBox:
        self.boxes += 1
        holds = inside or self._holds(box)
        if not holds:
            self._attain(find_middle(box), inside=False)
            cut = None if holds is False else find_widest(box, self.problem.limits)
            return BoundedBox(np.inf, box, cut, inside=False)
        face, natural, slopes = self._descend(box)
        middle = find_middle(face)
        linear, steep = self._attain(middle, inside=True), {}
        if face != middle:
            self._attain(self._climb(face, slopes), inside=True)
        for symbol in open_symbols(face):
            deviation = enclose_interval(face[symbol]) - enclose_interval(middle[symbol])
            linear = linear + hull(slopes[symbol]) * deviation
            steep[symbol] = steepest(slopes[symbol], face[symbol])
        bound = min(map(round_up, [linear, *natural]))
        return BoundedBox(bound, face, self._choose_cut(face, steep), inside=True)

    def _choose_cut(self, box: Box, steep: dict[Any, float]) -> Any:
        """Return the size with the largest reach, or the widest one if a reach is not known."""
        if any(np.isinf(reach) for reach in steep.values()):
            return find_widest(box, self.problem.limits)
        return max(steep, key=steep.__getitem__, default=None)

    def _holds(self, box: Box) -> bool | None:
        """Decide the domain's conditions over the box: False if one is violated somewhere in it."""
        found = [condition.decide(self.known, box) for condition in self.problem.conditions]
        return False if False in found else None if None in found else True

    def _descend(self, box: Box) -> tuple[Box, list[Any], dict[Any, list[Any]]]:
        """Narrow the box to where the extreme lies; return all values and slopes there.

        A size in which the quantity is monotonic goes to a limit. One in which it is concave goes
        to where the slope may vanish, or to a limit.
        """
        while True:
            natural, slopes = self._differentiate(box)
            before = box
            for symbol, sign in ((s, common_sign(slopes[s])) for s in slopes):
                box = put_to_limit(box, symbol, upper=sign > 0) if sign else box
            if box == before:
                box = self._narrow(box)
            if box == before:
                return box, natural, slopes

    def _narrow(self, box: Box) -> Box:
        """Narrow a size in which the quantity is concave by a Newton step towards its maxima."""
        for symbol in open_symbols(box):
            bend = self._bend(box, symbol)
            if not bend < 0:
                continue
            low, high = box[symbol]
            middle = (low + high) / 2
            _, slopes = self._differentiate({**box, symbol: (middle, middle)}, symbol)
            tops = enclose_interval((middle, middle)) - hull(slopes[symbol]) / bend
            narrow = (min(max(low, round_down(tops)), high), max(min(high, round_up(tops)), low))
            if narrow[1] - narrow[0] <= (high - low) / 2:
                return {**box, symbol: narrow}
        return box

    def _differentiate(self, box: Box, *more: Any) -> tuple[list[Any], dict[Any, list[Any]]]:
        """Enclose the quantity by every program, and its slopes by the more informative one."""
        values, symbols = to_values(self.known, box), [*open_symbols(box), *more]
        found = [p.differentiate(values, symbols) for p in self.problem.tapes]
        natural = [self.direction * value for value, _ in found]
        return natural, {s: self._choose_way([slopes[s] for _, slopes in found]) for s in symbols}

    def _choose_way(self, ways: list[list[Any]]) -> list[Any]:
        """Return the slopes with a common sign, or else those with the narrowest hull."""
        directed = [[self.direction * branch for branch in way] for way in ways]
        signed = [way for way in directed if common_sign(way)]
        return signed[0] if signed else min(directed, key=lambda way: width(hull(way)))

    def _bend(self, box: Box, symbol: Any) -> Any:
        """Enclose the second derivative with respect to a size."""
        values = to_values(self.known, box)
        bends = [self.direction * p.bend(values, symbol) for p in self.problem.tapes]
        return min(bends, key=width)

    def _climb(self, box: Box, slopes: dict[Any, list[Any]]) -> Box:
        """Return the corner in the direction of the middle slopes."""
        for symbol in open_symbols(box):
            box = put_to_limit(box, symbol, upper=float(hull(slopes[symbol]).mid()) > 0)
        return box

    def _attain(self, point: Box, inside: bool) -> Any:
        """Return the value at a point, and record it unless the point may be outside the domain."""
        value = self.direction * self.problem.tapes[-1].evaluate(to_values(self.known, point))
        if inside or self._holds(point):
            self.attained = max(self.attained, round_down(value))
        return value
