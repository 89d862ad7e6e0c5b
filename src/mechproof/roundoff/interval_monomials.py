"""Interval monomials: intervals times powers of variables that may be zero.

A value that vanishes with a variable keeps it as a factor: quotients of values that vanish alike
stay finite on boxes that contain zero, and an error can be compared with a value that vanishes as
fast. A pole is a monomial too: the reciprocal of a variable that stands for the value's reciprocal.
Gappa (Daumas and Melquiond 2010) rewrites quotients until common factors have cancelled; here they
are never multiplied in.

Boxes are bounded together if the same decisions hold in them; boxes where decisions differ are
bounded separately.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Hashable, Sequence
from functools import reduce

import numpy as np
from numpy.typing import NDArray

from mechproof.arithmetic.cover import Boxes
from mechproof.arithmetic.interval_functions import Function
from mechproof.arithmetic.intervals import (
    ONE,
    Array,
    Ends,
    Interval,
    Mask,
    careful,
)

Powers = tuple[int, ...]
# The most boxes that are bounded together.
TOGETHER = 8192
# Bounds boxes in which all decisions agree, given the first few of these.
BoundAlike = Callable[[Boxes, tuple[int, ...]], Array]
Rows = NDArray[np.intp]
# An interval is wide if the ratio of its largest to its least absolute value is at least this.
WIDE = 1.25


class MixedBoxesError(Exception):
    """Raised if a decision differs between boxes; each box is in one of the masks."""

    def __init__(self, path: tuple[int, ...], masks: Sequence[Mask]) -> None:
        super().__init__("the boxes differ in what holds")
        self.path, self.masks = path, masks


class BoxVariables:
    """The variables of one evaluation, their intervals, and which of them are never negative.

    They cover many boxes at once. `choose` makes decisions that may differ between boxes: `forced`
    are the first of these. `nonzero` are the indices of variables that never vanish; `poles` and
    `zeros` count the variables reserved for poles and for values that may vanish.
    """

    def __init__(
        self,
        spans: Sequence[Interval],
        positive: Sequence[bool],
        poles: int = 0,
        forced: tuple[int, ...] = (),
        zeros: int = 0,
        nonzero: Collection[int] = (),
    ) -> None:
        more = poles + zeros
        self._nonzero = nonzero
        self._positive = (*positive, *(False,) * more)
        self.spans = list(spans)
        self._free = list(range(len(spans), len(spans) + more))
        self.none: Powers = (0,) * (len(spans) + more)
        # Function values that may vanish, shared by all steps that use them.
        self._named: dict[Hashable, IntervalMonomial] | None = {} if zeros else None
        self._known: dict[Powers, Interval] = {}
        self._forced = forced
        self._path: tuple[int, ...] = ()

    def choose(self, *masks: Mask) -> int:
        """Return the index of the mask that holds in all boxes; `MixedBoxesError` if they differ.

        Each box is in exactly one mask; by convention the last means undecided.
        """
        if len(self._path) < len(self._forced):
            choice = self._forced[len(self._path)]
        else:
            some = [number for number, mask in enumerate(masks) if np.any(mask)]
            if len(some) != 1:
                raise MixedBoxesError(self._path, masks)
            (choice,) = some
        self._path = (*self._path, choice)
        return choice

    def constant(self, span: Interval) -> IntervalMonomial:
        """Return a monomial that vanishes with no variable."""
        return IntervalMonomial(self, span, self.none)

    def variable(self, index: int, power: int = 1) -> IntervalMonomial:
        """Return a variable, or a power of it."""
        powers = tuple(power if i == index else 0 for i in range(len(self.none)))
        return IntervalMonomial(self, ONE, powers)

    def is_apart(self, index: int) -> bool:
        """Return whether a variable's interval excludes zero."""
        span = self.spans[index]
        apart = (span.low > 0) | (span.high < 0)
        return self.choose(apart, ~apart) == 0

    def never_vanish(self, powers: Powers) -> Mask:
        """Return where no variable of a product of powers may be zero."""
        spans = (self.spans[i] for i, p in enumerate(powers) if p and i not in self._nonzero)
        return reduce(np.logical_and, ((s.low > 0) | (s.high < 0) for s in spans), True)

    def is_positive(self, powers: Powers) -> bool:
        """Return whether a product of powers is never negative."""
        return self.keep_positive(powers) == powers

    def keep_positive(self, powers: Powers) -> Powers:
        """Return powers whose product is never negative, each exponent the same or one less."""
        return tuple(
            power if power % 2 == 0 or positive else power - 1
            for power, positive in zip(powers, self._positive, strict=True)
        )

    def intern(self, powers: Powers) -> Powers:
        """Return the shared object `none` if all powers are zero, else the powers unchanged."""
        return powers if any(powers) else self.none

    def add_variable(self, span: Interval) -> IntervalMonomial:
        """Add a variable for a value that may vanish, or for the reciprocal of one with a pole."""
        index = self._free.pop(0)
        self.spans.append(span)
        return self.variable(index)

    def name(
        self, function: Function, argument: IntervalMonomial, value: Interval
    ) -> IntervalMonomial:
        """Return a function's value; one near zero becomes a variable, shared by all its uses.

        So it cancels where it is divided by itself.
        """
        # Only an exact number times powers of variables is known to be the same at every use.
        if self._named is None or not np.all(argument.span.low == argument.span.high):
            return self.constant(value)
        wide = self.constant(value).is_wide
        if self.choose(~wide, wide) == 0:
            return self.constant(value)
        key = (function, argument.powers, np.asarray(argument.span.low).tobytes())
        if key not in self._named:
            self._named[key] = self.add_variable(value)
        return self._named[key]

    def expand(self, powers: Powers) -> Interval:
        """Return the interval of a product of powers; not finite for reciprocals with a pole."""
        if powers not in self._known:
            product = ONE
            for span, power in zip(self.spans, powers, strict=False):
                if power:
                    product *= span.power(power)
            self._known[powers] = product
        return self._known[powers]


class IntervalMonomial:
    """An interval times powers of the variables of boxes."""

    __slots__ = ("powers", "span", "variables")

    def __init__(self, variables: BoxVariables, span: Interval, powers: Powers) -> None:
        self.variables, self.span, self.powers = variables, span, powers

    def __add__(self, other: IntervalMonomial) -> IntervalMonomial:
        if self.powers is other.powers or self.powers == other.powers:
            return IntervalMonomial(self.variables, self.span + other.span, self.powers)
        if other._is_zero or self._is_zero:
            return self if other._is_zero else other
        # Only factors common to both terms are factors of the sum.
        common = self.variables.intern(tuple(map(min, self.powers, other.powers)))
        return IntervalMonomial(self.variables, self._over(common) + other._over(common), common)

    @property
    def _is_zero(self) -> bool:
        """Return whether the monomial is zero in all boxes, whatever its powers are."""
        return not (self.span.low.any() or self.span.high.any())

    def __sub__(self, other: IntervalMonomial) -> IntervalMonomial:
        return self + -other

    def __neg__(self) -> IntervalMonomial:
        return IntervalMonomial(self.variables, -self.span, self.powers)

    def __mul__(self, other: IntervalMonomial) -> IntervalMonomial:
        powers, others, none = self.powers, other.powers, self.variables.none
        # Most monomials have no powers, which an identity check with `none` shows at once.
        if powers is none:
            powers = others
        elif others is not none:
            powers = self.variables.intern(
                tuple([a + b for a, b in zip(powers, others, strict=True)])
            )
        return IntervalMonomial(self.variables, self.span * other.span, powers)

    def __truediv__(self, other: IntervalMonomial) -> IntervalMonomial:
        powers = self.powers
        if other.powers is not self.variables.none:
            powers = self.variables.intern(
                tuple([a - b for a, b in zip(powers, other.powers, strict=True)])
            )
        return IntervalMonomial(self.variables, self.span / other.span, powers)

    def scaled(self, span: Interval) -> IntervalMonomial:
        """Return the monomial times an interval."""
        return IntervalMonomial(self.variables, self.span * span, self.powers)

    def power(self, exponent: int) -> IntervalMonomial:
        """Return a whole power; an even one is never negative."""
        powers = self.powers
        if powers is not self.variables.none:
            powers = tuple([exponent * p for p in powers])
        return IntervalMonomial(self.variables, self.span.power(exponent), powers)

    @property
    def is_wide(self) -> Mask:
        """Return where the interval is wide for its distance from zero, contains zero or is NaN."""
        return ~(np.maximum(self.span.low, -self.span.high) * WIDE > self.span.largest())

    def expanded(self) -> Interval:
        """Return the interval of the value, powers multiplied in."""
        if self.powers is self.variables.none or self._is_zero:
            return self.span
        return self.span * self.variables.expand(self.powers)

    def over(self, powers: Powers) -> IntervalMonomial:
        """Return the value with, as factors, the given powers of variables that never vanish."""
        kept = [p if p and self.variables.is_apart(i) else 0 for i, p in enumerate(powers)]
        inverse = self.variables.expand(tuple([-p for p in kept]))
        return IntervalMonomial(
            self.variables, self.expanded() * inverse, self.variables.intern(tuple(kept))
        )

    def decide_sign(self) -> int:
        """Return 1 if the value is nowhere negative, -1 if nowhere positive; 0 if unknown."""
        if not self.variables.is_positive(self.powers):
            return 0
        above, below = self.span.low >= 0, self.span.high <= 0
        return (1, -1, 0)[self.variables.choose(above, below & ~above, ~(above | below))]

    def size(self) -> IntervalMonomial:
        """Return the absolute value; variables that may be negative keep only even powers."""
        kept = self.variables.intern(self.variables.keep_positive(self.powers))
        return IntervalMonomial(self.variables, self._over(kept).size(), kept)

    def extreme(
        self, other: IntervalMonomial, choose: Callable[[Ends, Ends], Ends]
    ) -> IntervalMonomial:
        """Return the larger or the smaller of two values, as `choose` picks from their ends."""
        common = self.variables.intern(tuple(map(min, self.powers, other.powers)))
        if not self.variables.is_positive(common):
            common = self.variables.none
        one, two = self._over(common), other._over(common)
        span = Interval(choose(one.low, two.low), choose(one.high, two.high))
        return IntervalMonomial(self.variables, span, common)

    def hull(self, other: IntervalMonomial) -> IntervalMonomial:
        """Return the smallest monomial found that encloses both values."""
        low, high = self.extreme(other, np.minimum), self.extreme(other, np.maximum)
        return IntervalMonomial(self.variables, Interval(low.span.low, high.span.high), low.powers)

    def _over(self, common: Powers) -> Interval:
        if self.powers == common:
            return self.span
        left = tuple([a - b for a, b in zip(self.powers, common, strict=True)])
        return self.span * self.variables.expand(left)


def split_cases(compute: Callable[[Rows, tuple[int, ...]], Array], count: int) -> Array:
    """Return the bounds of `count` boxes, splitting them where a decision differs between boxes.

    `compute` takes indices of boxes and their first decisions.
    """
    bounds = np.full(count, np.inf)
    waiting: list[tuple[Rows, tuple[int, ...]]] = [(np.arange(count), ())]
    while waiting:
        rows, forced = waiting.pop()
        try:
            bounds[rows] = compute(rows, forced)
        except MixedBoxesError as undecided:
            for number, mask in enumerate(undecided.masks):
                inside = rows[np.broadcast_to(mask, len(rows))]
                if len(inside):
                    waiting.append((inside, (*undecided.path, number)))
    return bounds


def bound_in_groups(compute: BoundAlike, boxes: Boxes) -> Array:
    """Return the bounds of boxes, computed in groups of like signs; infinite where unknown."""
    bounds = np.full(len(boxes), np.inf)
    if not len(boxes):
        return bounds
    # All boxes that are bounded together must agree in which variables are never negative.
    _, groups = np.unique(boxes[:, :, 0] >= 0, axis=0, return_inverse=True)
    for group in range(groups.max() + 1):
        rows = np.flatnonzero(groups == group)
        for start in range(0, len(rows), TOGETHER):
            part = rows[start : start + TOGETHER]
            bounds[part] = _bound_alike(compute, boxes[part], moves=False)
    return bounds


def _bound_alike(compute: BoundAlike, boxes: Boxes, *, moves: bool) -> Array:
    def try_rows(rows: Rows, forced: tuple[int, ...]) -> Array:
        try:
            with careful(moves=moves):
                return compute(boxes[rows], forced)
        except FloatingPointError:
            if moves:
                return np.full(len(rows), np.inf)
            return _bound_alike(compute, boxes[rows], moves=True)

    return split_cases(try_rows, len(boxes))
