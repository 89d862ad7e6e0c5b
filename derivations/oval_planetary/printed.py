"""Prints of paper 2 that claims and kernels go back to, read."""

from __future__ import annotations

import sympy as sp

from mechproof.record import Equation

from .mechanics import (
    PLACES,
    cos_6,
    focal_radius,
    integrate,
    oval_radius,
    ratio_by_plan,
    sun_radius,
)
from .symbols import READER, a, e, e1, e2, phi, phi6, ratio_symbol, rho, rho5, rho6, theta

EQUATION_2 = Equation(
    "(2)",
    r"\rho(\varphi)=\frac{a(1-e^2)}{1-e\cos2\varphi}",
    derived={rho: focal_radius.subs(theta, 2 * phi)},
    note="The oval has at half the polar angle the focal radius of its ellipse.",
    marks=("rebuilt", "uncertain", "inferred"),
)
EQUATION_5 = Equation(
    "(5)",
    r"\varphi_6=\int\frac{1-e_1^2}{1+e_1^2-2e_1\cos2\varphi_1}\,d\varphi_1",
    derived={phi6: integrate(sun_radius / (2 * a - sun_radius))},
    note="Seen from the carrier: wheel 5 turns by rho4/rho5, the sun's major axis on the line "
    "of centres at the lower limit 0.",
    marks=("rebuilt", "uncertain", "inferred"),
)
EQUATION_7 = Equation(
    "(7)",
    r"BD=\rho_6-\rho_5",
    derived=PLACES,
    note="From D to B, in the order that is legible in (10): the output's side counts against the "
    "carrier.",
    marks=("rebuilt", "inferred"),
)
EQUATION_10 = Equation(
    "(10)",
    r"\varphi_3'=\frac{(\rho_6-\rho_5)\,2a}{\rho_5\,(2a-\rho_6)}",
    derived={ratio_symbol: -ratio_by_plan},
    note="The output counted against the carrier.",
    marks=("rebuilt", "inferred"),
)
_, print_2 = READER.members(EQUATION_2)
_, print_5 = READER.members(EQUATION_5)
_, print_7 = READER.members(EQUATION_7)
_, print_10 = READER.members(EQUATION_10)


def print_radius(eccentricity: sp.Expr, angle: sp.Expr) -> sp.Expr:
    """Right-hand side of (2), and with other letters of (3) and (4)."""
    return print_2.subs({e: eccentricity, phi: angle}, simultaneous=True)


def print_3_by_6(cosine: sp.Expr) -> sp.Expr:
    """Right-hand side of (3) with (6), by the cosine of twice the angle of wheel 6."""
    return print_2.subs({e: e1, sp.cos(2 * phi): -cosine}, simultaneous=True)


# (10) with the radii of two oval pairs.
RATIO_OF_10 = print_10.subs({rho5: print_3_by_6(cos_6), rho6: oval_radius(e2, cos_6)})
