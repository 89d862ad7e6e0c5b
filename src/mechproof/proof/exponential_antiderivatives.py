"""Antiderivatives of integrands with exponentials; nothing is proved here."""

from __future__ import annotations

from collections.abc import Iterator
from math import gcd, lcm

import sympy as sp
from sympy.simplify.fu import TR8

from mechproof.proof.coordinates import HYPERBOLIC, write_by_exponentials


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
