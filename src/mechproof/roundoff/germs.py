"""Germs: balls times powers of variables that may be zero.

What vanishes with a variable keeps it as a factor: quotients of what vanishes alike stay finite on
boxes that hold zero, and an error is compared with a value that vanishes as it does. A pole is a
germ too: the reciprocal of a variable that is its value's reciprocal.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from flint import arb

Ball = Any
Powers = tuple[int, ...]


def ball_between(low: float, high: float) -> Ball:
    """Return a ball that holds an interval of doubles; not finite for an endless one."""
    if math.isinf(high - low):
        return arb("nan")
    if low == high:
        return arb(low)
    middle = low + (high - low) / 2
    reach = math.nextafter(max(high - middle, middle - low), math.inf)
    return arb(middle, reach)


def raise_ball(ball: Ball, power: int) -> Ball:
    """Return a whole power, from the ends: a product of a ball with itself is wider."""
    if power == 1:
        return ball
    if power < 0:
        return 1 / raise_ball(ball, -power)
    if power % 2 or ball > 0:
        return (ball.lower() ** power).union(ball.upper() ** power)
    # Not abs(): the ball of a size may hold negative numbers.
    return (ball.abs_lower() ** power).union(ball.abs_upper() ** power)


class Frame:
    """The variables of one evaluation, the balls they are in, and which are never negative."""

    def __init__(self, balls: Sequence[Ball], positive: Sequence[bool], poles: int = 0) -> None:
        self._positive = (*positive, *(False,) * poles)
        self.balls = list(balls)
        self._free = list(range(len(balls), len(balls) + poles))
        self.none: Powers = (0,) * (len(balls) + poles)
        self._known: dict[Powers, Ball] = {}

    def constant(self, ball: Ball) -> Germ:
        """Return a germ that vanishes with no variable."""
        return Germ(self, ball, self.none)

    def variable(self, index: int, power: int = 1) -> Germ:
        """Return a variable, or a power of it."""
        powers = tuple(power if i == index else 0 for i in range(len(self.none)))
        return Germ(self, arb(1), powers)

    def is_positive(self, powers: Powers) -> bool:
        """Say whether a product of powers is never negative."""
        return all(
            power % 2 == 0 or positive
            for power, positive in zip(powers, self._positive, strict=True)
        )

    def intern(self, powers: Powers) -> Powers:
        """Return no powers as the one object that says so."""
        return powers if any(powers) else self.none

    def add_variable(self, ball: Ball) -> int:
        """Take in a variable, the reciprocal of what has a pole, and return its index."""
        index = self._free.pop(0)
        self.balls.append(ball)
        return index

    def expand(self, powers: Powers) -> Ball:
        """Return the ball of a product of powers; not finite for reciprocals of what may vanish."""
        if powers not in self._known:
            product = arb(1)
            for ball, power in zip(self.balls, powers, strict=False):
                if power:
                    product *= raise_ball(ball, power)
            self._known[powers] = product
        return self._known[powers]


class Germ:
    """A ball times powers of the frame's variables."""

    __slots__ = ("ball", "frame", "powers")

    def __init__(self, frame: Frame, ball: Ball, powers: Powers) -> None:
        self.frame, self.ball, self.powers = frame, ball, powers

    def __add__(self, other: Germ) -> Germ:
        if self.powers is other.powers or self.powers == other.powers:
            return Germ(self.frame, self.ball + other.ball, self.powers)
        common = self.frame.intern(tuple(map(min, self.powers, other.powers)))
        return Germ(self.frame, self._over(common) + other._over(common), common)

    def __sub__(self, other: Germ) -> Germ:
        return self + -other

    def __neg__(self) -> Germ:
        return Germ(self.frame, -self.ball, self.powers)

    def __mul__(self, other: Germ) -> Germ:
        powers, others, none = self.powers, other.powers, self.frame.none
        if powers is none:
            powers = others
        elif others is not none:
            powers = self.frame.intern(tuple([a + b for a, b in zip(powers, others, strict=True)]))
        return Germ(self.frame, self.ball * other.ball, powers)

    def __truediv__(self, other: Germ) -> Germ:
        powers = self.powers
        if other.powers is not self.frame.none:
            powers = self.frame.intern(
                tuple([a - b for a, b in zip(powers, other.powers, strict=True)])
            )
        return Germ(self.frame, self.ball / other.ball, powers)

    def scaled(self, ball: Ball) -> Germ:
        """Return the germ times a ball."""
        return Germ(self.frame, self.ball * ball, self.powers)

    def squared(self) -> Germ:
        """Return the square, which is never negative."""
        powers = self.powers
        if powers is not self.frame.none:
            powers = tuple([2 * p for p in powers])
        return Germ(self.frame, raise_ball(self.ball, 2), powers)

    def expanded(self) -> Ball:
        """Return the ball of the value."""
        if self.powers is self.frame.none:
            return self.ball
        return self.ball * self.frame.expand(self.powers)

    @property
    def sign(self) -> int:
        """Return the sign of the value, where it vanishes too, 0 if it is not known."""
        if not self.frame.is_positive(self.powers):
            return 0
        return 1 if self.ball >= 0 else -1 if self.ball <= 0 else 0

    def united(self, other: Germ) -> Germ:
        """Return a germ that holds the values of both."""
        common = self.frame.intern(tuple(map(min, self.powers, other.powers)))
        return Germ(self.frame, self._over(common).union(other._over(common)), common)

    def _over(self, common: Powers) -> Ball:
        if self.powers == common:
            return self.ball
        left = tuple([a - b for a, b in zip(self.powers, common, strict=True)])
        return self.ball * self.frame.expand(left)
