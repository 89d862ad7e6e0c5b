"""Half-angle forms of the stages of paper 4, which the kernels compute, and parts of the domain."""

from __future__ import annotations

import sympy as sp
from sympy import cos, sin, sqrt

from mechproof.record import Part

from .mechanics import displacement, sine_of_tau
from .prints import PRINTED_R
from .symbols import alpha_KL, height, kappa, l_AB, l_BC, l_CD, l_KL, radicand, sigma, tau, x1, x5

half_3 = -x1 / (l_BC + sqrt(radicand))
half_7 = x5 / (l_KL * sin(alpha_KL) + height)
root_7 = sqrt(l_KL**2 - PRINTED_R**2)


def by_half_angle(expression: sp.Expr, angle: sp.Symbol, tangent: sp.Expr) -> sp.Expr:
    """Put the tangent of half an angle into sines and cosines of sums with it."""
    expanded = sp.expand_trig(expression)
    cosine, sine = (1 - tangent**2) / (1 + tangent**2), 2 * tangent / (1 + tangent**2)
    return expanded.subs({cos(angle): cosine, sin(angle): sine})


def upright(expression: sp.Expr) -> sp.Expr:
    """Give alpha_KL by the tangent kappa of its half, as the direction of KL by tau."""
    placed = expression.subs({x5: displacement[tau], height: l_KL * sine_of_tau})
    by_tangent = by_half_angle(placed, alpha_KL, kappa)
    return by_tangent.subs(alpha_KL, 2 * sp.atan(kappa))


MOVABLE = Part("the radicand of Q is positive", where=(radicand > 0,))
BEFORE_PIVOT = Part(
    "the radicand of Q is positive and x1 > -(l_AB + l_CD), A has not passed D",
    where=(x1 > -l_AB - l_CD, radicand > 0),
)
FIRST_QUADRANT = Part("R > 0", {tau: sp.Interval.Ropen(0, 1)})
SECOND_QUADRANT = Part("R < 0", {sigma: sp.Interval.Ropen(0, 1)})
