"""Branch and bound over a box of sizes."""

from __future__ import annotations

import heapq
import itertools
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from mechproof.tolerance.boxes import (
    Box,
    Known,
    common_sign,
    enclose,
    enclose_interval,
    find_middle,
    find_widest,
    halve,
    hull,
    open_symbols,
    put_to_limit,
    round_down,
    round_up,
    steepest,
    width,
)

if TYPE_CHECKING:
    from mechproof.tolerance.problem import Problem


class Part(NamedTuple):
    """A bound over a box, its face where the extreme lies, the size to cut, if it is inside."""

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
        """Cut the box with the largest bound until the gap is closed or the budget spent."""
        order = itertools.count()
        first = self._examine(self.problem.limits, inside=False)
        self.turning = set(open_symbols(first.box))
        # Of equal bounds, one that no cut can lower comes first: it ends the search.
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

    def _examine(self, box: Box, inside: bool) -> Part:
        self.boxes += 1
        holds = inside or self._holds(box)
        if not holds:
            self._attain(find_middle(box))
            cut = None if holds is False else find_widest(box, self.problem.limits)
            return Part(np.inf, box, cut, inside=False)
        face, slopes = self._descend(box)
        middle = find_middle(face)
        centre = self._evaluate(self.problem.values[-1], middle)
        self._attain(middle)
        self._attain(self._climb(face, slopes))
        linear, steep = centre, {}
        for symbol in open_symbols(face):
            deviation = enclose_interval(face[symbol]) - enclose_interval(middle[symbol])
            linear = linear + hull(slopes[symbol]) * deviation
            steep[symbol] = steepest(slopes[symbol], face[symbol])
        natural = [self._evaluate(value, face) for value in self.problem.values]
        bound = min(map(round_up, [linear, *natural]))
        return Part(bound, face, self._choose_cut(face, steep), inside=True)

    def _choose_cut(self, box: Box, steep: dict[Any, float]) -> Any:
        """Return the size with the largest reach; where none is known, the widest."""
        if any(np.isinf(reach) for reach in steep.values()):
            return find_widest(box, self.problem.limits)
        return max(steep, key=steep.__getitem__, default=None)

    def _holds(self, box: Box) -> bool | None:
        """Decide the conditions of the domain over the box, False if one is violated in it."""
        found = [condition.decide(self.known, box) for condition in self.problem.conditions]
        return False if False in found else None if None in found else True

    def _descend(self, box: Box) -> tuple[Box, dict[Any, list[Any]]]:
        """Put every size to a limit in which the quantity is monotonic; and all slopes."""
        slopes: dict[Any, list[Any]] = {}
        while True:
            before = box
            for symbol in open_symbols(box):
                slopes[symbol] = self._slope(symbol, box)
                sign = common_sign(slopes[symbol])
                if sign:
                    box = put_to_limit(box, symbol, upper=sign > 0)
            if box == before:
                return box, slopes

    def _climb(self, box: Box, slopes: dict[Any, list[Any]]) -> Box:
        """Return the corner to which the middle slopes point."""
        for symbol in open_symbols(box):
            box = put_to_limit(box, symbol, upper=float(hull(slopes[symbol]).mid()) > 0)
        return box

    def _slope(self, symbol: Any, box: Box) -> list[Any]:
        """Return the branches of the derivative, by the way whose hull is narrowest."""
        ways = [[self._evaluate(b, box) for b in way] for way in self.problem.slopes[symbol]]
        signed = [way for way in ways if common_sign(way)]
        return signed[0] if signed else min(ways, key=lambda way: width(hull(way)))

    def _evaluate(self, expression: Any, box: Box) -> Any:
        return self.direction * enclose(expression, self.known, box)

    def _attain(self, point: Box) -> None:
        """Note the value at a point, unless it may lie outside the domain."""
        if self._holds(point):
            value = self._evaluate(self.problem.values[-1], point)
            self.attained = max(self.attained, round_down(value))
