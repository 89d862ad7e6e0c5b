"""Shares of parts, accepted and rejected, good and bad, by normal laws."""

from __future__ import annotations

from sympy import Expr, Integral, Rational, S, Symbol, exp, pi, sqrt, tan

from .._metrology import normal_between, normal_outside
from .symbols import (
    above,
    below,
    incline,
    sigma_height,
    sigma_thickness,
    sigma_tip,
    width,
)
from .wheel import GRADES, K_PRINTED, PRINTED_INFLUENCE, PROFILE_ANGLE, TOLERANCE_UM

GEOMETRIES = {
    "printed": (PRINTED_INFLUENCE, PRINTED_INFLUENCE),
    "involute": (tan(PROFILE_ANGLE), 2 * tan(PROFILE_ANGLE)),
}


# Share of good teeth, normal law centred on its field of K = 6 standard deviations.
THREE_SIGMA = Rational(K_PRINTED, 2)
NORMAL_SHARE = normal_between(S.Zero, S.One, -THREE_SIGMA, THREE_SIGMA)


def tip_spread(grade: int, geometry: str = "printed") -> Expr:
    """Give the standard deviation (um) of thickness from the tip diameter, IT/sigma = K."""
    return GEOMETRIES[geometry][0] * Rational(GRADES[grade][1], K_PRINTED)


def gauge_spread(gauge: Expr, geometry: str = "printed") -> Expr:
    """Give the standard deviation of thickness from that of the gauge, in height and thickness."""
    return sqrt(1 + GEOMETRIES[geometry][1] ** 2) * gauge


def measurement_spread(grade: int, gauge: Expr, geometry: str = "printed") -> Expr:
    """Give the standard deviation (um) of the whole error, from tip and gauge."""
    return sqrt(tip_spread(grade, geometry) ** 2 + gauge_spread(gauge, geometry) ** 2)


def crossover(grade: int, geometry: str = "printed") -> Expr:
    """Give the standard deviation of the gauge (um) that disturbs as much as the tip."""
    return tip_spread(grade, geometry) / gauge_spread(S.One, geometry)


def wrongly_rejected(spread: Expr, ratio: int = K_PRINTED, tolerance: int = TOLERANCE_UM) -> Expr:
    """Share of good teeth rejected; normal laws, centred, T/sigma = ratio."""
    y = Symbol("y", real=True)
    half, spread_true = Rational(tolerance, 2), Rational(tolerance, ratio)
    density = exp(-(y**2) / (2 * spread_true**2)) / (spread_true * sqrt(2 * pi))
    return Integral(density * normal_outside(y, spread**2, -half, half), (y, -half, half))


def rejected_by(
    grade: int, limit_error: int | Rational, multiple: int = 3, geometry: str = "printed"
) -> Expr:
    """Share of good teeth rejected with a tip of a grade and a gauge."""
    return wrongly_rejected(measurement_spread(grade, Rational(limit_error) / multiple, geometry))


def accepted_by(grade: int, limit_error: Rational, expected: Expr = S.Zero) -> Expr:
    """Share of all teeth accepted; limit error 3 sigma, the indication off by `expected` (um)."""
    half, spread_true = Rational(TOLERANCE_UM, 2), Rational(TOLERANCE_UM, K_PRINTED)
    spread = measurement_spread(grade, limit_error / 3)
    return normal_between(expected, spread_true**2 + spread**2, -half, half)


def error_variance(tip: Expr, height: Expr) -> Expr:
    """Variance of the measured thickness about the true one."""
    return (tip * sigma_tip) ** 2 + (height * sigma_height) ** 2 + sigma_thickness**2


VARIANCE_BY_SLOPE = error_variance(2 * incline, 2 * incline)
chance_to_accept = normal_between(S.Zero, width**2 / 2, -below, above)
