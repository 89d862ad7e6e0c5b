"""Ratio, position and acceleration of paper 2: of two oval pairs, of one, with cylinders."""

from __future__ import annotations

import sympy as sp

from mechproof.record import list_given

from .mechanics import COS_4, oval_radius, pair_ratio, ratio_by_plan, sun_radius
from .symbols import (
    R3,
    R4,
    R5,
    R6,
    VARIABLES,
    a,
    alpha,
    alpha_double,
    beta,
    beta_double,
    delta,
    driven_angle,
    e1,
    e2,
    gamma,
    gamma_double,
    k,
    lam,
    mu,
    nu,
    phi1,
    rho5,
    rho6,
    x,
)


# Both pairs are Moebius maps of tangents, and so is their composition:
# tan(chi) = lambda*t/(mu + nu*t), t = tan(phi1), chi the turn of wheel 3 against the carrier,
# reversed. mu*cos(phi1) + nu*sin(phi1) + i*lambda*sin(phi1) has the argument chi.
def ratio_of_map(p: sp.Expr, q_: sp.Expr, g: sp.Expr) -> sp.Expr:
    """1 - d chi/d phi1 for the coefficients lambda, mu, nu = p, q_, g."""
    square = q_**2 * (1 + COS_4) + 2 * q_ * g * sp.sin(2 * phi1) + (p**2 + g**2) * (1 - COS_4)
    return 1 - 2 * p * q_ / square


def position_of_map(p: sp.Expr, q_: sp.Expr, g: sp.Expr, difference: sp.Expr) -> sp.Expr:
    """phi1 - chi as one argument; `difference` is p - q_."""
    return sp.atan2(
        g * (1 - COS_4) - difference * sp.sin(2 * phi1),
        p + q_ + (q_ - p) * COS_4 + g * sp.sin(2 * phi1),
    )


# The same as the argument of a constant vector and of one that turns about 1, as for one pair.
square_sum = (lam + mu) ** 2 + nu**2
along, across = lam**2 - mu**2 + nu**2, -2 * mu * nu
position_by_one_pair = -sp.atan2(-nu, lam + mu) - sp.atan2(
    along * sp.sin(2 * phi1) - across * COS_4,
    square_sum - along * COS_4 - across * sp.sin(2 * phi1),
)
GIVEN = list_given(VARIABLES)
COEFFICIENTS = tuple(GIVEN[s] for s in (alpha_double, beta_double, gamma_double))

t = sp.tan(phi1)
POSITION = position_of_map(alpha, beta, gamma, delta)
RATIO = ratio_of_map(alpha, beta, gamma)
ACCELERATION = sp.diff(RATIO, phi1)

# Mounted as in the paper the two eccentricities act as one.
E_SERIES = (e1 + e2) / (1 + e1 * e2)
E_ALIGNED = (e1 - e2) / (1 - e1 * e2)


def position_of_one(eccentricity: sp.Expr) -> sp.Expr:
    """Position function of two pairs that act like one."""
    return phi1 - driven_angle(eccentricity, phi1)


def ratio_of_one(eccentricity: sp.Expr) -> sp.Expr:
    """Transmission ratio of two pairs that act like one."""
    return 1 - pair_ratio(eccentricity, COS_4)


# Pair 4-5 cylindrical: the satellite turns by (R4/R5) phi1 against the carrier.
RATIO_CYLINDRICAL = 1 - k * (1 - e2**2) / (1 + e2**2 - 2 * e2 * sp.cos(x))
POSITION_CYLINDRICAL = (R5 - R4) / R5 * phi1 - sp.atan2(e2 * sp.sin(x), 1 - e2 * sp.cos(x))
ACCELERATION_CYLINDRICAL = sp.diff(RATIO_CYLINDRICAL, x) * 2 * k
AXES_45 = {a: (R4 + R5) / 2, rho5: R5}
ratio_with_cylinders_45 = ratio_by_plan.subs(AXES_45).subs(
    rho6, oval_radius(e2, sp.cos(2 * R4 / R5 * phi1)).subs(AXES_45)
)
explicit = {x: 2 * R4 / R5 * phi1, k: R4 / R5}
ratio_45, position_45 = (f.subs(explicit) for f in (RATIO_CYLINDRICAL, POSITION_CYLINDRICAL))

# Pair 3-6 cylindrical.
AXES_36 = {a: (R3 + R6) / 2, rho6: R6}
ratio_with_cylinders_36 = ratio_by_plan.subs(AXES_36).subs(rho5, (2 * a - sun_radius).subs(AXES_36))
position_36 = phi1 - R6 / R3 * driven_angle(e1, phi1)
