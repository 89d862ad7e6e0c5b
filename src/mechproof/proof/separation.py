"""Rung: a number that is smaller than its separation bound is zero.

A number that is made of whole numbers by sums, products, quotients and roots, and of sines, cosines
and tangents of parts of a turn, is the quotient of two algebraic integers whose conjugates have
bounds. It is zero, or larger than what they and its degree give: the bound of Burnikel, Funke,
Mehlhorn, Schirra and Schmitt (2001), with twice the cosine of a part of a turn as a further
algebraic integer, no conjugate of which is beyond two.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import reduce
from math import lcm

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.proof.canonical_sums import write_out
from mechproof.record.parts import CIRCULAR
from mechproof.statement_domains.domain import Domain

RUNG = "separation bound"
# Work limit: bits of a bound.
_MOST_BITS = 2**14
# Of what is computed beside the bound.
_GUARD_BITS = 64


class _NotAlgebraicError(ValueError):
    """A number of which no bound is known."""


@dataclass(frozen=True)
class _Bits:
    """Bounds of the conjugates of two algebraic integers whose quotient is a number, in bits."""

    above: int
    below: int

    def add(self, other: _Bits) -> _Bits:
        crosswise = (self.above + other.below, other.above + self.below)
        return _Bits(max(crosswise) + 1, self.below + other.below)

    def multiply(self, other: _Bits) -> _Bits:
        return _Bits(self.above + other.above, self.below + other.below)

    def extract(self, degree: int) -> _Bits:
        """Return those of a root: of a*b**(k-1), over b, or of a over that of a**(k-1)*b."""
        above, below = self.above, self.below
        if above >= below:
            return _Bits(-(-(above + (degree - 1) * below) // degree), below)
        return _Bits(above, -(-(below + (degree - 1) * above) // degree))

    def raise_to(self, power: int) -> _Bits:
        above, below = abs(power) * self.above, abs(power) * self.below
        return _Bits(above, below) if power >= 0 else _Bits(below, above)


@dataclass
class _Extension:
    """The roots and the parts of a turn that a number is made of."""

    roots: dict[tuple[sp.Expr, int], None] = field(default_factory=dict)
    turn: int = 1

    def find_degree(self) -> int:
        """Return the most that the degree of the number can be."""
        # The cosines of all multiples of a part of a turn are half of its roots of unity.
        circle = max(int(sp.totient(self.turn)) // 2, 1)
        return reduce(lambda total, root: total * root[1], self.roots, circle)

    def measure(self, number: sp.Expr) -> _Bits:
        """Return the bits of a number; `_NotAlgebraicError` if none are known."""
        if number.is_Rational:
            # Of p a power of two above it, of q the least that is not below it.
            return _Bits(abs(int(number.p)).bit_length(), int(number.q - 1).bit_length())
        if isinstance(number, sp.Add | sp.Mul):
            join = _Bits.add if number.is_Add else _Bits.multiply
            return reduce(join, map(self.measure, number.args))
        if isinstance(number, sp.Pow) and number.exp.is_Rational:
            base, degree = self.measure(number.base), int(number.exp.q)
            if degree > 1:
                if not balls.evaluate(number.base, {}) > 0:
                    raise _NotAlgebraicError(f"{number.base} is not shown to be positive")
                self.roots[number.base, degree] = None
                base = base.extract(degree)
            return base.raise_to(int(number.exp.p))
        if isinstance(number, CIRCULAR) and (part := number.args[0] / sp.pi).is_Rational:
            # A sine is a cosine of the quarter turn less its angle.
            self.turn = lcm(self.turn, 4, 2 * int(part.q))
            return _Bits(1, 1)
        raise _NotAlgebraicError(str(number))


def decide_by_separation(left: sp.Expr, right: sp.Expr, domain: Domain) -> str | None:
    """Return the rung if two numbers differ by less than different ones could, else None."""
    difference = domain.resolve(left - right)
    if difference.free_symbols:
        return None
    difference, extension = write_out(difference), _Extension()
    try:
        bits = extension.measure(difference)
    except _NotAlgebraicError:
        return None
    # The product of all conjugates of the upper integer is a whole number: at least 1, if not 0.
    most = (extension.find_degree() - 1) * bits.above + bits.below
    if most > _MOST_BITS:
        return None
    ball = balls.evaluate(difference, {}, most + _GUARD_BITS)
    is_zero = ball.is_finite() and ball.abs_upper() < balls.to_ball(sp.S(2) ** -most)
    return RUNG if is_zero else None
