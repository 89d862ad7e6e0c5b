"""Rung: recomputation of a printed number with the rounding that the print implies."""

from __future__ import annotations

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.proof.verdict import Answer, Evidence, Verdict
from mechproof.proof.witness_text import show_plainly
from mechproof.record import PrintedNumber

RUNG = "recomputation"
# Beside those of the digits that are printed.
_GUARD_BITS = 64


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
        return Answer(Verdict.PROVED, RUNG, f"recomputed {show_plainly(ball)[0]}", (evidence,))
    if distance > allowed:
        recomputed, _ = show_plainly(ball, given)
        reason = f"recomputed {recomputed}, printed {statement.printed}"
        return Answer(Verdict.REFUTED, RUNG, reason, (evidence,))
    return Answer(Verdict.UNDECIDED, RUNG, "the ball meets the rounding boundary", (evidence,))
