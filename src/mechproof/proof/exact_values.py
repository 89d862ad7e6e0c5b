"""Rungs: exact numbers, which balls compare, and what has no value or is infinite.

A printed number is recomputed with the rounding that the print implies.
"""

from __future__ import annotations

import sympy as sp
from sympy.core.relational import Relational

from mechproof.arithmetic import balls
from mechproof.proof.verdict import Answer, Evidence, Verdict
from mechproof.proof.witness_text import clip, show_plainly
from mechproof.record import PrintedNumber
from mechproof.record.parts import find_free
from mechproof.statement_domains.domain import Domain

RUNG, RECOMPUTATION = "evaluation", "recomputation"
_SIGNS = {"==": "=", "!=": "differs from"}
# Beside those of the digits that are printed.
_GUARD_BITS = 64


def resolve_sides(relation: sp.Basic, domain: Domain) -> tuple[sp.Expr, ...]:
    """Return the exact numbers that a relation compares; none where it compares no two numbers."""
    sides = relation.args if isinstance(relation, Relational) else ()
    resolved = tuple(domain.resolve(side) for side in sides)
    return () if any(map(find_free, resolved)) else resolved


def decide_exact(relation: sp.Basic, sides: tuple[sp.Expr, ...], sign: str) -> Answer:
    """Decide a relation without letters by balls of its sides, if it has two, and tell them."""
    holds = balls.truth(relation, {}, 512)
    verdicts = {True: Verdict.PROVED, False: Verdict.REFUTED, None: Verdict.UNDECIDED}
    outcome = {True: "is true", False: "is false", None: "is not decided"}[holds]
    if not sides:
        is_settled = relation in (sp.true, sp.false)
        told = "by what defines its letters it" if is_settled else clip(str(relation))
        return Answer(verdicts[holds], RUNG, f"{told} {outcome}")
    values = [balls.evaluate(side, {}, 512) for side in sides]
    plain, enclosed = show_plainly(*values), balls.show_apart(*values)
    sign = f" {_SIGNS.get(sign, sign)} "
    printed, rebuilt = enclosed if holds is False else ("", "")
    evidence = Evidence(f"{sign.join(enclosed)} {outcome}", printed=printed, rebuilt=rebuilt)
    told = "" if holds else f" {outcome}"
    return Answer(verdicts[holds], RUNG, f"{sign.join(plain)}{told}", (evidence,))


def write_value(value: sp.Expr) -> str:
    """Return a value in words where it is infinite."""
    return str(value).replace("oo", "infinity")


def decide_endless(sides: tuple[sp.Expr, sp.Expr]) -> Answer | None:
    """Decide where SymPy says that a side has no value, or that one is infinite; None elsewhere."""
    if any(side.has(sp.nan, sp.zoo) for side in sides):
        return Answer(Verdict.UNDECIDED, "none", "a side has no value for what is given")
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
