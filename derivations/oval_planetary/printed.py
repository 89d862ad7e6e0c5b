"""Right-hand sides of the equations that paper 2 prints."""

from __future__ import annotations

import sympy as sp

from .mechanics import cos_6, integrate, oval_radius
from .symbols import a, e1, e2, phi1, rho5, rho6, tau


def print_radius(eccentricity: sp.Expr, angle: sp.Expr) -> sp.Expr:
    """Right-hand side of (2), (3) and (4)."""
    return a * (1 - eccentricity**2) / (1 - eccentricity * sp.cos(2 * angle))


print_5 = sp.Integral((1 - e1**2) / (1 + e1**2 - 2 * e1 * sp.cos(2 * tau)), (tau, 0, phi1))
print_7 = rho6 - rho5
print_9 = 2 * a - rho6
print_10 = (rho6 - rho5) * 2 * a / (rho5 * (2 * a - rho6))
print_11 = integrate(
    print_10.subs({rho5: a * (1 - e1**2) / (1 + e1 * cos_6), rho6: oval_radius(e2, cos_6)})
)
