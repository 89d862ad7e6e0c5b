"""Certain facts about a drive of oval wheels, in balls: decisions that are True, False or open."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from mechproof.mechanisms.dwells.band import Swing, start_swing

Decision = bool | None


class Open(ArithmeticError):  # noqa: N818
    """Raised if balls cannot decide something; the text names it."""


def as_ball(number: Any) -> Any:
    """Return the ball of an exact number; balls are returned unchanged."""
    from flint import arb, fmpq

    if isinstance(number, Fraction):
        return arb(fmpq(number.numerator, number.denominator))
    return number if isinstance(number, arb) else arb(number)


def is_above(left: Any, right: Any) -> Decision:
    """Return whether left >= right, exactly for fractions; None if balls cannot tell."""
    if isinstance(left, Fraction) and isinstance(right, Fraction):
        return left >= right
    difference = as_ball(left) - as_ball(right)
    return True if difference >= 0 else False if difference < 0 else None


def sure(decision: Decision, what: str) -> bool:
    """Return a decision; raise `Open` if there is none."""
    if decision is None:
        raise Open(what)
    return decision


class EnclosedDrive:
    """A drive with exact R4/R5 = k, enclosed in balls from the place where it is first slow."""

    def __init__(self, k: Fraction, e: Fraction) -> None:
        q = (1 - e) / (1 + e)
        self.exact = (k, q if k > 1 else 1 / q)
        self.k, self.q = map(as_ball, self.exact)
        self.sign = 1 if k > 1 else -1
        self.floats: Swing = start_swing(float(k), float(e))

    @property
    def turns_back(self) -> bool:
        """Whether the output turns back at all, decided exactly."""
        k, q = self.exact
        return k * q < 1 if self.sign > 0 else k * q > 1

    def moved(self, d: Any) -> Any:
        """How far the output has moved back at d from the place, |k d| < pi."""
        from flint import arb

        sine, cosine = (self.k * d).sin_cos()
        return self.sign * (d - arb.atan2(self.q * sine, cosine))

    @property
    def top(self) -> Any:
        """How far it moves back until it turns (row "dwells, how far the output turns back")."""
        t = ((1 - self.k * self.q) / (self.q * (self.k - self.q))).sqrt()
        return self.sign * (t.atan() / self.k - (self.q * t).atan())

    def goes_back(self, d: Any) -> Decision:
        """Return whether `moved` rises at d."""
        sine, cosine = (self.k * d).sin_cos()
        speed = self.k * self.q / (cosine**2 + self.q**2 * sine**2)
        back = self.sign * (1 - speed)
        return True if back > 0 else False if back < 0 else None
