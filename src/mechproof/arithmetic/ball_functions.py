"""Ball functions: SymPy's constants, functions and comparisons, applied to balls.

Comparisons that balls do not decide are open, and so is all that depends on them, as in Kleene's
three-valued logic (1952). For complex balls, functions also report whether they are analytic, as
Arb's integration requires (Johansson 2018).
"""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from operator import methodcaller
from typing import Any

import sympy as sp
from flint import acb, arb

from mechproof.record import DerivativeWhere, ValueWhere

Ball = Any
NOT_FINITE = arb("nan")
NOT_ANALYTIC = acb("nan")

CONSTANTS: dict[sp.Basic, Callable[[], Ball]] = {
    sp.pi: arb.pi,
    sp.E: arb.const_e,
    sp.EulerGamma: arb.const_euler,
    sp.I: lambda: NOT_FINITE,
    sp.nan: lambda: NOT_FINITE,
    sp.zoo: lambda: NOT_FINITE,
    sp.oo: lambda: NOT_FINITE,
    -sp.oo: lambda: NOT_FINITE,
}

ENTIRE = (
    *(sp.sin, sp.cos, sp.tan, sp.cot, sp.sec, sp.csc, sp.exp, sp.erf, sp.erfc, sp.Si),
    *(sp.sinh, sp.cosh, sp.tanh, sp.coth, sp.sech, sp.csch),
)

# Functions that flint has under SymPy's names, in small letters.
_ALIKE = (
    *(*ENTIRE, sp.log, sp.asin, sp.acos, sp.atan, sp.asinh, sp.acosh, sp.atanh),
    *(sp.sinc, sp.floor, sp.zeta, sp.gamma),
)
FUNCTIONS: dict[type[sp.Basic], Callable[..., Ball]] = {
    **{kind: methodcaller(kind.__name__.lower()) for kind in _ALIKE},
    # Flint gives [-pi, pi] for a vector that may be zero, which has no argument.
    sp.atan2: lambda y, x: NOT_FINITE if y.contains(0) and x.contains(0) else arb.atan2(y, x),
    sp.factorial: lambda x: (x + 1).gamma(),
    ValueWhere: lambda value, needed: value,
    DerivativeWhere: lambda value, needed: value,
    sp.Mod: lambda x, y: x - y * (x / y).floor(),
    sp.ceiling: lambda x: x.ceil(),
    sp.Heaviside: lambda x, at_zero: _step(x, at_zero),
    sp.Abs: abs,
    sp.sign: lambda x: x.sgn(),
    sp.Max: lambda *xs: reduce(arb.max, xs),
    sp.Min: lambda *xs: reduce(arb.min, xs),
    sp.elliptic_e: lambda m: take_real_part(acb(m).elliptic_e()),
    sp.elliptic_k: lambda m: take_real_part(acb(m).elliptic_k()),
    sp.betainc_regularized: lambda a, b, x0, x1: _beta(a, b, x1) - _beta(a, b, x0),
}

# Functions of a complex ball and of whether the integration asks for an analytic function.
COMPLEX: dict[type[sp.Basic], Callable[..., Ball]] = {
    **dict.fromkeys(
        (ValueWhere, DerivativeWhere),
        lambda z, needed, analytic: z if needed.is_finite() else NOT_ANALYTIC,
    ),
    sp.Abs: lambda z, analytic: z.real_abs(analytic),
    sp.sign: lambda z, analytic: z.real_sgn(analytic),
    sp.Pow: lambda z, exponent, analytic: acb(z).pow(exponent, analytic),
    sp.log: lambda z, analytic: z.log(analytic),
    # Analytic only away from their branch cuts.
    sp.atan: lambda z, analytic: z.atan() if not analytic or abs(z.imag) < 1 else NOT_ANALYTIC,
    sp.asin: lambda z, analytic: z.asin() if not analytic or abs(z.real) < 1 else NOT_ANALYTIC,
    sp.acos: lambda z, analytic: z.acos() if not analytic or abs(z.real) < 1 else NOT_ANALYTIC,
}


def are_equal(left: Ball, right: Ball) -> bool | None:
    """Return whether two balls are the same number; None if they only overlap."""
    exact = left.is_exact() and right.is_exact() and left == right
    return _certain(exact, not left.overlaps(right))


def _certain(yes: Ball, no: Ball) -> bool | None:
    return True if yes else False if no else None


COMPARISONS: dict[type[sp.Basic], Callable[[Ball, Ball], bool | None]] = {
    sp.StrictLessThan: lambda a, b: _certain(a < b, a >= b),
    sp.LessThan: lambda a, b: _certain(a <= b, a > b),
    sp.StrictGreaterThan: lambda a, b: _certain(a > b, a <= b),
    sp.GreaterThan: lambda a, b: _certain(a >= b, a < b),
    sp.Equality: are_equal,
    sp.Unequality: lambda a, b: None if (e := are_equal(a, b)) is None else not e,
}

# Connectives of truth values that may be undecided, as in Kleene's logic.
CONNECTIVES: dict[type[sp.Basic], Callable[..., bool | None]] = {
    sp.And: lambda *parts: False if False in parts else None if None in parts else True,
    sp.Or: lambda *parts: True if True in parts else None if None in parts else False,
    sp.Not: lambda part: None if part is None else not part,
}


def _beta(a: Ball, b: Ball, x: Ball) -> Ball:
    return arb(0) if x == 0 else arb.beta_lower(x, a, b, regularized=True)


def _step(x: Ball, at_zero: Ball) -> Ball:
    if x == 0:
        return at_zero
    return NOT_FINITE if x.contains(0) else arb(int(x > 0))


def take_real_part(ball: Ball) -> Ball:
    """Return the real part of a complex ball; not finite if the ball is off the real line."""
    return ball.real if ball.imag.contains(0) else NOT_FINITE
