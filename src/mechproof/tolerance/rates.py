"""Balls that carry the rate at which they go with one symbol (dual numbers)."""

from __future__ import annotations

from typing import Any, NamedTuple


class Rated(NamedTuple):
    """A ball and a ball of its derivative; a plain ball beside it is constant."""

    value: Any
    rate: Any

    def __add__(self, other: Any) -> Rated:  # type: ignore[override]
        value, rate = split(other)
        return Rated(self.value + value, self.rate + rate)

    def __mul__(self, other: Any) -> Rated:  # type: ignore[override]
        value, rate = split(other)
        return Rated(self.value * value, self.rate * value + self.value * rate)

    __radd__ = __add__
    __rmul__ = __mul__  # type: ignore[assignment]


def split(ball: Any) -> tuple[Any, Any]:
    """Return the value and its rate."""
    return (ball.value, ball.rate) if isinstance(ball, Rated) else (ball, 0)
