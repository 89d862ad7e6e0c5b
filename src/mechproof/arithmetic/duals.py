"""Duals: balls that carry the rate at which they go with one symbol (Clifford 1873)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, eq=False)
class Dual:
    """A ball and a ball of its derivative; a plain ball beside it is constant."""

    value: Any
    rate: Any

    def __add__(self, other: Any) -> Dual:
        value, rate = split(other)
        return Dual(self.value + value, self.rate + rate)

    def __mul__(self, other: Any) -> Dual:
        value, rate = split(other)
        return Dual(self.value * value, self.rate * value + self.value * rate)

    __radd__ = __add__
    __rmul__ = __mul__


def split(ball: Any) -> tuple[Any, Any]:
    """Return the value and its rate."""
    return (ball.value, ball.rate) if isinstance(ball, Dual) else (ball, 0)
