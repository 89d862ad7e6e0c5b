"""Rungs: exact numbers, compared by balls, and sides that are infinite or have no value.

A printed number is recomputed with the rounding that the print implies.

A number built from whole numbers by sums, products, quotients and roots, and from sines, cosines
and tangents of rational parts of a turn, is the quotient of two algebraic integers whose conjugates
have bounds. It is zero, or larger than a bound set by these and its degree: the bound of Burnikel,
Funke, Mehlhorn, Schirra and Schmitt (2001), with twice the cosine of a part of a turn as another
algebraic integer, whose conjugates are at most two in modulus.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import reduce
from math import lcm

import sympy as sp
from sympy.core.relational import Relational

from mechproof.arithmetic import balls
from mechproof.proof.canonical_sums import write_out
from mechproof.proof.verdict import Answer, Evidence, Verdict
from mechproof.proof.witness_text import clip, show_plainly
from mechproof.record import PrintedNumber
from mechproof.record.parts import CIRCULAR, find_free
from mechproof.statement_domains.domain import Domain

RUNG, RECOMPUTATION = "evaluation", "recomputation"
_SIGNS = {"==": "=", "!=": "differs from"}
# Added to the bits that the printed digits, or the separation bound, need.
_GUARD_BITS = 64


def resolve_sides(relation: sp.Basic, domain: Domain) -> tuple[sp.Expr, ...]:
    """Return the exact numbers that a relation compares, or () if it has a side with letters."""
    sides = relation.args if isinstance(relation, Relational) else ()
    resolved = tuple(domain.resolve(side) for side in sides)
    return () if any(map(find_free, resolved)) else resolved


def decide_exact(relation: sp.Basic, sides: tuple[sp.Expr, ...], sign: str) -> Answer:
    """Decide a relation without letters by balls, and report those of its sides, if any."""
    holds = balls.truth(relation, {}, 512)
    verdicts = {True: Verdict.PROVED, False: Verdict.REFUTED, None: Verdict.UNDECIDED}
    outcome = {True: "is true", False: "is false", None: "is not decided"}[holds]
    if not sides:
        is_settled = relation in (sp.true, sp.false)
        told = "with the definitions of its letters it" if is_settled else clip(str(relation))
        return Answer(verdicts[holds], RUNG, f"{told} {outcome}")
    values = [balls.evaluate(side, {}, 512) for side in sides]
    plain, enclosed = show_plainly(*values), balls.show_apart(*values)
    sign = f" {_SIGNS.get(sign, sign)} "
    printed, rebuilt = enclosed if holds is False else ("", "")
    evidence = Evidence(f"{sign.join(enclosed)} {outcome}", printed=printed, rebuilt=rebuilt)
    told = "" if holds else f" {outcome}"
    return Answer(verdicts[holds], RUNG, f"{sign.join(plain)}{told}", (evidence,))


def write_value(value: sp.Expr) -> str:
    """Return a value as text, with "infinity" spelt out."""
    return str(value).replace("oo", "infinity")


def decide_endless(sides: tuple[sp.Expr, sp.Expr]) -> Answer | None:
    """Decide an equality with a side that is infinite, or has no value in SymPy; else None."""
    if any(side.has(sp.nan, sp.zoo) for side in sides):
        return Answer(Verdict.UNDECIDED, "none", "a side has no value for the given letters")
    if not any(side in (sp.oo, -sp.oo) for side in sides):
        return None
    printed, rebuilt = map(write_value, sides)
    if sides[0] == sides[1]:
        return Answer(Verdict.PROVED, RUNG, f"both sides are {printed}")
    if not all(side.is_finite or side.is_infinite for side in sides):
        return None
    what = f"one side is {printed}, the other {rebuilt}"
    return Answer(Verdict.REFUTED, RUNG, what, (Evidence(what),))


def decide_number(statement: PrintedNumber, value: sp.Expr) -> Answer:
    """Compare the exact value with the closed interval of half a last place around the print."""
    printed = sp.Rational(statement.printed)
    half_place = statement.half_place
    bits = int(printed / half_place).bit_length() + _GUARD_BITS
    ball = balls.evaluate_until(value, {}, bits)
    with balls.working_precision(2 * bits):
        given, allowed = balls.to_ball(printed), balls.to_ball(half_place)
        distance = abs(ball - given)
    if value.is_Rational:
        distance, allowed = abs(value - printed), half_place
    evidence = Evidence("printed and recomputed", {}, statement.printed, balls.show(ball))
    if distance <= allowed:
        return Answer(
            Verdict.PROVED, RECOMPUTATION, f"recomputed {show_plainly(ball)[0]}", (evidence,)
        )
    if distance > allowed:
        recomputed, _ = show_plainly(ball, given)
        reason = f"recomputed {recomputed}, printed {statement.printed}"
        return Answer(Verdict.REFUTED, RECOMPUTATION, reason, (evidence,))
    return Answer(
        Verdict.UNDECIDED, RECOMPUTATION, "the ball meets the rounding boundary", (evidence,)
    )


SEPARATION = "separation bound"
# Work limit: bits of a separation bound.
_MOST_BITS = 2**14


class _NotAlgebraicError(ValueError):
    """A number whose conjugates have no known bounds."""


@dataclass(frozen=True)
class _Bits:
    """Bounds, in bits, on the conjugates of two algebraic integers whose quotient is a number."""

    above: int
    below: int

    def add(self, other: _Bits) -> _Bits:
        crosswise = (self.above + other.below, other.above + self.below)
        return _Bits(max(crosswise) + 1, self.below + other.below)

    def multiply(self, other: _Bits) -> _Bits:
        return _Bits(self.above + other.above, self.below + other.below)

    def extract(self, degree: int) -> _Bits:
        """Return the bounds for a root of a/b, as root(a*b**(k-1))/b or as a/root(a**(k-1)*b)."""
        above, below = self.above, self.below
        if above >= below:
            return _Bits(-(-(above + (degree - 1) * below) // degree), below)
        return _Bits(above, -(-(below + (degree - 1) * above) // degree))

    def raise_to(self, power: int) -> _Bits:
        above, below = abs(power) * self.above, abs(power) * self.below
        return _Bits(above, below) if power >= 0 else _Bits(below, above)


@dataclass
class _Extension:
    """The roots and the parts of a turn from which a number is built."""

    roots: dict[tuple[sp.Expr, int], None] = field(default_factory=dict)
    turn: int = 1

    def find_degree(self) -> int:
        """Return an upper bound for the degree of the number."""
        # cos(2*pi/n) has degree phi(n)/2, and all the cosines of its multiples lie in the same
        # field.
        circle = max(int(sp.totient(self.turn)) // 2, 1)
        return reduce(lambda total, root: total * root[1], self.roots, circle)

    def measure(self, number: sp.Expr) -> _Bits:
        """Return a number's bits, collecting its roots; `_NotAlgebraicError` if none are known."""
        if number.is_Rational:
            # The exponents of a power of two above |p|, and of the least one that is at least q.
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
            # sin(x) = cos(pi/2 - x).
            self.turn = lcm(self.turn, 4, 2 * int(part.q))
            return _Bits(1, 1)
        raise _NotAlgebraicError(str(number))


def decide_by_separation(left: sp.Expr, right: sp.Expr, domain: Domain) -> str | None:
    """Return the rung if two numbers differ by less than unequal ones could, else None."""
    difference = domain.resolve(left - right)
    if difference.free_symbols:
        return None
    difference, extension = write_out(difference), _Extension()
    try:
        bits = extension.measure(difference)
    except _NotAlgebraicError:
        return None
    # The product of all conjugates of the numerator is an integer: at least 1 in size, if not 0.
    most = (extension.find_degree() - 1) * bits.above + bits.below
    if most > _MOST_BITS:
        return None
    ball = balls.evaluate(difference, {}, most + _GUARD_BITS)
    is_zero = ball.is_finite() and ball.abs_upper() < balls.to_ball(sp.S(2) ** -most)
    return SEPARATION if is_zero else None
