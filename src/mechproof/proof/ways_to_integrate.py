"""Antiderivatives by rules, by partial fractions, by exponentials, and by functions of angles.

Nothing is proved here. An antiderivative by tan(x/2) jumps at odd multiples of pi; its arctangent
is written without a jump (Jeffrey 1993).
"""

from __future__ import annotations

from collections.abc import Iterator
from math import gcd, lcm

import sympy as sp
from sympy.integrals.manualintegrate import manualintegrate
from sympy.integrals.rationaltools import ratint, ratint_ratpart
from sympy.simplify.fu import TR8

from mechproof.proof.coordinates import HYPERBOLIC, write_by_exponentials

# The tangent of half an angle, or another function by which one integrates.
TANGENT = sp.Dummy("t", real=True)


def propose_by_rules(integrand: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    """Integrate by SymPy's rules, which are those of integration by hand."""
    found = _close(manualintegrate(integrand, variable), sp.Integral(integrand, variable))
    if not found.has(sp.Integral):
        yield from list_pieces(found)


def _close(found: sp.Expr, whole: sp.Integral) -> sp.Expr:
    """Solve an integral by parts that has led back to itself: I = A + c*I."""
    around = sp.expand(found).coeff(whole)
    return (found - around * whole).expand() / (1 - around) if around not in (0, 1) else found


def propose_by_fractions(integrand: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    """Integrate a quotient of polynomials by its partial fractions, or its quadratic factors.

    The rational part of the integral needs no rules, which take long.
    """
    if not integrand.is_rational_function(variable):
        return
    if integrand.free_symbols == {variable}:
        yield ratint(integrand, variable, real=True)
    whole, rest = split_fraction(integrand, variable)
    for found in propose_by_rules(sp.apart(rest, variable), variable):
        yield whole + found


def split_fraction(fraction: sp.Expr, variable: sp.Symbol) -> tuple[sp.Expr, sp.Expr]:
    """Return the rational part of an integral, and what is left to integrate (Horowitz 1971)."""
    above, below = sp.fraction(sp.cancel(fraction))
    whole, above = sp.div(above, below, variable)
    part, rest = ratint_ratpart(above, below, variable)
    return sp.Poly(whole, variable).integrate().as_expr() + part, rest


def list_pieces(candidate: sp.Expr) -> Iterator[sp.Expr]:
    """List SymPy's proposals for every case, such as one sign of a parameter and the other."""
    node = min(candidate.atoms(sp.Piecewise), key=sp.default_sort_key, default=None)
    if node is None:
        yield candidate
        return
    for value, _ in node.args:
        yield from list_pieces(candidate.xreplace({node: value}))


def propose_by_exponentials(integrand: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    """Integrate terms p(x)*exp(a*x)*cos(b*x + c), p a polynomial, by repeated parts."""
    if not integrand.has(sp.exp, *HYPERBOLIC):
        return
    written = sp.expand(TR8(sp.expand(write_by_exponentials(integrand))))
    terms = [_integrate_term(term, variable) for term in sp.Add.make_args(written)]
    if None not in terms:
        yield sp.Add(*terms)


def write_by_power(
    integrand: sp.Expr, variable: sp.Symbol, t: sp.Symbol
) -> tuple[sp.Expr, sp.Expr] | None:
    """Return the integrand in t, an exponential that all others are powers of, and t itself.

    The integrand is divided by dt/dx. None if it is not rational in one exponential.
    """
    written = write_by_exponentials(integrand)
    nodes = [node for node in written.atoms(sp.exp) if node.has(variable)]
    # Growing exponentials come first, so that t does not tend to zero at infinity.
    order = {node: (node.args[0].could_extract_minus_sign(), str(node)) for node in nodes}
    exponentials = sorted(nodes, key=order.__getitem__)
    slopes = [sp.diff(node.args[0], variable) for node in exponentials]
    if not slopes or slopes[0] == 0 or slopes[0].has(variable):
        return None
    ratios = [sp.cancel(slope / slopes[0]) for slope in slopes]
    if not all(ratio.is_Rational for ratio in ratios):
        return None
    below = lcm(*(int(ratio.q) for ratio in ratios))
    steps = [int(ratio * below) for ratio in ratios]
    step = slopes[0] * gcd(*steps) / below
    powers = {
        node: sp.exp(node.args[0].subs(variable, 0)) * t ** (number // gcd(*steps))
        for node, number in zip(exponentials, steps, strict=True)
    }
    rational = written.xreplace(powers) / (step * t)
    is_met = rational.is_rational_function(t) and not rational.has(variable)
    return (rational, sp.exp(step * variable)) if is_met else None


def _integrate_term(term: sp.Expr, variable: sp.Symbol) -> sp.Expr | None:
    """Integrate a polynomial times an exponential and a wave; None for any other term.

    It is the real or imaginary part of p*exp(r*x), r = a + i*b, whose integral is exp(r*x) times
    the sum of p/r - p'/r**2 + p''/r**3 and so on.
    """
    factor, moving = sp.powsimp(term).as_independent(variable, as_Add=False)
    functions = {node for node in moving.atoms(sp.exp, sp.sin, sp.cos) if node.has(variable)}
    grown, waves = (
        [node for node in functions if isinstance(node, kind)]
        for kind in (sp.exp, (sp.sin, sp.cos))
    )
    rest = sp.cancel(moving / sp.Mul(*functions))
    slopes = [sp.diff(sp.Add(*(n.args[0] for n in some)), variable) for some in (grown, waves)]
    is_met = rest.is_polynomial(variable) and not any(slope.has(variable) for slope in slopes)
    if not is_met or max(len(grown), len(waves)) > 1:
        return None
    polynomial = sp.Poly(rest, variable)
    if not functions:
        return factor * polynomial.integrate().as_expr()
    a, b = slopes
    size = sp.factor(a**2 + b**2)
    along, across = _integrate_by_parts(polynomial, a / size, -b / size)
    angle = waves[0].args[0] if waves else sp.S.Zero
    cosine, sine = sp.cos(angle), sp.sin(angle)
    parts = (along * cosine - across * sine, along * sine + across * cosine)
    return factor * sp.Mul(*grown) * parts[any(isinstance(wave, sp.sin) for wave in waves)]


def _integrate_by_parts(
    polynomial: sp.Poly, real: sp.Expr, imaginary: sp.Expr
) -> tuple[sp.Expr, sp.Expr]:
    """Return the parts of p*u - p'*u**2 + p''*u**3 and so on of a complex number u."""
    along, across, power = sp.S.Zero, sp.S.Zero, (real, imaginary)
    while not polynomial.is_zero:
        along += polynomial.as_expr() * power[0]
        across += polynomial.as_expr() * power[1]
        power = (
            imaginary * power[1] - real * power[0],
            -real * power[1] - imaginary * power[0],
        )
        polynomial = polynomial.diff()
    return along, across


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
