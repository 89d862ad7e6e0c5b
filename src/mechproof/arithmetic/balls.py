"""Ball arithmetic: a SymPy expression at exact values -> an enclosure (python-flint).

Balls are those of Arb (Johansson 2017), a midpoint of any precision and a radius. Every number that
leaves this module encloses the true value. An expression that is undefined at the point, or that
cannot be decided there (a comparison inside the ball), gives a non-finite ball, never a guess.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction
from typing import Any

import flint
import sympy as sp
from flint import acb, arb, fmpq

from mechproof.arithmetic.ball_evaluation import compile_expression, decide
from mechproof.arithmetic.ball_functions import NOT_FINITE, Ball, take_real_part
from mechproof.arithmetic.layout import Values

__all__ = [
    "NOT_FINITE",
    "PRECISIONS",
    "Ball",
    "evaluate",
    "evaluate_until",
    "show",
    "show_apart",
    "to_ball",
    "truth",
    "working_precision",
]

# Bits of precision, each twice the last (Ziv 1991): all together cost no more than twice the last
# one.
PRECISIONS = (64, 128, 256, 512, 1024)


@contextmanager
def working_precision(bits: int) -> Iterator[None]:
    """Set flint's precision for a block and restore the old one afterwards."""
    before = flint.ctx.prec
    flint.ctx.prec = bits
    try:
        yield
    finally:
        flint.ctx.prec = before


def to_ball(number: Any) -> Ball:
    """Return the exact ball of a double, integer or fraction, or a ball of a number of SymPy."""
    # Asked first, as most numbers are fractions of SymPy.
    if isinstance(number, sp.Rational):
        return arb(fmpq(int(number.p), int(number.q)))
    if isinstance(number, (arb, acb)):
        return number
    if isinstance(number, sp.Float):
        return to_ball(sp.Rational(number))
    if isinstance(number, Fraction):
        return arb(fmpq(number.numerator, number.denominator))
    if isinstance(number, sp.Expr):
        return compile_expression(number)({})
    return arb(int(number)) if isinstance(number, int) else arb(float(number))


def evaluate(expression: sp.Basic, values: Values, bits: int = 128) -> Ball:
    """Enclose `expression` at `values` (symbol -> exact number) with `bits` of precision.

    Returns an `arb`; non-finite where the expression is undefined or undecided.
    Raises `NotImplementedError` naming a function that has no ball version.
    """
    with working_precision(bits):
        result = compile_expression(expression)(_to_balls(values))
        return result if isinstance(result, arb) else take_real_part(result)


def evaluate_until(
    expression: sp.Basic,
    values: Values,
    relative_bits: int,
    precisions: tuple[int, ...] = PRECISIONS,
) -> Ball:
    """Raise the precision until the ball has `relative_bits` correct bits; non-finite if never."""
    for bits in precisions:
        ball = evaluate(expression, values, bits)
        if ball.is_finite() and (ball.rel_accuracy_bits() >= relative_bits or ball == 0):
            return ball
    return NOT_FINITE


def show(ball: Ball, digits: int = 12) -> str:
    """Return the ball as text: midpoint and radius.

    A wide ball that does not contain zero keeps the digits of its middle, which show its sign.
    """
    shown = str(ball.str(digits))
    return str(ball.str(3, more=True)) if "[+/-" in shown and not ball.contains(0) else shown


def read(text: str) -> Ball:
    """Return a ball that contains every number that was shown as this text."""
    return arb(text)


def show_apart(left: Ball, right: Ball) -> tuple[str, str]:
    """Return two balls as texts with enough digits to tell them apart, at most 96.

    Equal balls, where one should be smaller, are shown with the default digits.
    """
    if left == right:
        return show(left), show(right)
    for digits in (12, 24, 48, 96):
        texts = show(left, digits), show(right, digits)
        with working_precision(4 * digits + 64):
            if not arb(texts[0]).overlaps(arb(texts[1])):
                return texts
    with working_precision(PRECISIONS[-1]):
        return show(left), f"{show(right)}, the difference is {show(right - left, 3)}"


def truth(relation: sp.Basic, values: Values, bits: int = 128) -> bool | None:
    """Decide a relation (or And, Or, Not of relations) at a point; None where balls overlap."""
    with working_precision(bits):
        return decide(relation, _to_balls(values))


def _to_balls(values: Values) -> dict[sp.Basic, Ball]:
    return {symbol: to_ball(value) for symbol, value in values.items()}
