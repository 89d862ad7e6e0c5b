"""Antiderivatives of integrands with sines and cosines, without jumps; nothing is proved here.

An antiderivative by tan(x/2) jumps at odd multiples of pi; its arctangent is written without a jump
(Jeffrey 1993).
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp
from sympy.simplify.fu import TR8

from mechproof.proof.rule_antiderivatives import propose_by_rules, split_fraction

# The tangent of half an angle, or another function by which one integrates.
TANGENT = sp.Dummy("t", real=True)


def propose_by_cosine(integrand: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    """Integrate by t = cos x an integrand with one factor sin x, and the other way round."""
    t, s = TANGENT, sp.Dummy("s")
    for one, other, sign in ((sp.cos, sp.sin, -1), (sp.sin, sp.cos, 1)):
        written = integrand.xreplace({one(variable): t, other(variable): s})
        rest = sp.cancel(sp.together(written / s).subs(s**2, 1 - t**2))
        if not rest.has(s, variable):
            found = propose_by_rules(sp.apart(rest, t), t)
            yield from (sign * candidate.subs(t, one(variable)) for candidate in found)


def propose_by_half_angle(integrand: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    """Integrate a rational function of the variable's sine and cosine by t = tan(x/2).

    With sines, x is also counted from a quarter turn: for a + b*sin(x) the angle then stays small.
    """
    t = TANGENT
    circle = {sp.sin(variable): 2 * t / (1 + t**2), sp.cos(variable): (1 - t**2) / (1 + t**2)}
    for shift in (sp.S.Zero, sp.pi / 2) if integrand.has(sp.sin) else (sp.S.Zero,):
        turned = sp.expand_trig(integrand.subs(variable, variable + shift))
        rational = turned.xreplace(circle) * 2 / (1 + t**2)
        for found in _propose_by_slope(rational, variable, variable):
            yield found.subs(variable, variable - shift)


def propose_by_tangent(integrand: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    """Integrate by t = tan x an integrand of period pi."""
    t, c, s = TANGENT, sp.Dummy("c"), sp.Dummy("s")
    written = sp.expand_trig(integrand).xreplace({sp.sin(variable): s, sp.cos(variable): c})
    tangent = sp.cancel(sp.together(written.subs(s, t * c)))
    above, below = (sp.Poly(part, c) for part in sp.fraction(tangent))
    powers = [m[0] for polynomial in (above, below) for m in polynomial.monoms()]
    if any((power - powers[0]) % 2 for power in powers):
        return
    rational = tangent.subs(c, 1 / sp.sqrt(1 + t**2)) / (1 + t**2)
    yield from _propose_by_slope(rational, 2 * variable, variable)


def _propose_by_slope(rational: sp.Expr, double: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    """Integrate a rational function of t, the tangent of half an angle."""
    t = TANGENT
    if rational.has(variable):
        return
    whole, rest = split_fraction(rational, t)
    for found in propose_by_rules(sp.apart(rest, t), t):
        turned = found.replace(sp.atan, lambda slope: _turn(slope, double))
        turned = turned.subs(t, sp.sin(double) / (1 + sp.cos(double)))
        yield _turn_fraction(whole, double) + turned


def _turn_fraction(fraction: sp.Expr, angle: sp.Expr) -> sp.Expr:
    """Write a fraction of t = tan(angle/2) by sine and cosine, without a pole of t."""
    c, s = sp.symbols("c s", cls=sp.Dummy)
    square = (1 - c) / (1 + c)
    above, below = (
        sum(
            factor * square ** (power // 2) * (s / (1 + c)) ** (power % 2)
            for (power,), factor in sp.Poly(part, TANGENT).terms()
        )
        for part in sp.fraction(fraction)
    )
    return sp.cancel(above / below).xreplace({c: sp.cos(angle), s: sp.sin(angle)})


def _turn(slope: sp.Expr, variable: sp.Expr) -> sp.Expr:
    """Write atan(a*t + b), t = tan(x/2), as x/2 plus an angle that does not jump."""
    slope = sp.expand(slope)
    a, b = slope.coeff(TANGENT, 1), slope.coeff(TANGENT, 0)
    if slope != sp.expand(a * TANGENT + b):
        return sp.atan(slope)
    sine, cosine = sp.sin(variable), sp.cos(variable)
    across = (a - 1) * sine + b * (1 + cosine)
    along = (1 + cosine) + a * (1 - cosine) + b * sine
    return variable / 2 + sp.atan(across / along)


def propose_by_waves(integrand: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    """Integrate waves divided by a power of x by parts, until sine integrals are left."""
    above, below = sp.fraction(sp.together(integrand))
    scale, rest = below.as_independent(variable, as_Add=False)
    divided, power = rest.as_base_exp()
    waves = above.atoms(sp.sin, sp.cos)
    if divided != variable or not power.is_Integer or not waves:
        return
    left, found = sp.expand(above / scale), sp.S.Zero
    while (written := sp.expand(TR8(left))) != left:
        left = written
    for n in range(power - 1, 0, -1):
        found -= left / (n * variable**n)
        left = sp.expand(sp.diff(left, variable) / n)
    remaining = sp.S.Zero
    for term in sp.Add.make_args(left):
        factor, wave = term.as_independent(variable, as_Add=False)
        if isinstance(wave, sp.sin) and not sp.cancel(wave.args[0] / variable).has(variable):
            found += factor * sp.Si(wave.args[0])
        else:
            remaining += term / variable
    if not remaining.subs(variable, 0).has(sp.zoo, sp.nan):
        for other in propose_by_rules(remaining, variable):
            yield sp.expand(found + other)
