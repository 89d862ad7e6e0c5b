"""The inverse of the position: residual by balls, against what an eps of both sides allows."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from mechproof import CylindricalPair, EllipticPlanetary, OvalPlanetary
from mechproof.lab.specimen import Array
from mechproof.lab.subject import find_subjects

EPS = float(np.finfo(float).eps)
ALLOWED = 4
ECCENTRICITIES = (0.0, 0.28, 0.475, 0.9, 0.99, 0.999999, 1 - 1e-12)
FIFTH = Fraction(1, 5)
Mechanism = EllipticPlanetary | OvalPlanetary
ELLIPTIC, OVAL, RATIO, RATIO_OF_OVAL = (
    find_subjects((name,))[0]
    for name in (
        "elliptic_planetary.position",
        "oval_planetary.position_cylindrical",
        "elliptic_planetary.ratio",
        "oval_planetary.ratio_cylindrical",
    )
)
MECHANISMS: dict[str, Mechanism] = {
    **{f"elliptic, e = {e!r}": EllipticPlanetary(66, 16, e) for e in ECCENTRICITIES},
    **{f"elliptic 50.3/50.2, e = {e!r}": EllipticPlanetary(50.3, 50.2, e) for e in (0.475, 0.99)},
    "intermittent": OvalPlanetary.published(3),
    "intermittent at zero": OvalPlanetary(CylindricalPair(20, 30), FIFTH),
    "one-way": OvalPlanetary.published(4),
    "with the carrier": OvalPlanetary(CylindricalPair(20, 30), 0.1),
    "uniform": OvalPlanetary(CylindricalPair(20, 30), 0.0),
    "steep": OvalPlanetary(CylindricalPair(1, 3000), 0.99),
    "steepest": OvalPlanetary(CylindricalPair(1e-13, 1), 1 - 1e-12),
    "fast": OvalPlanetary(CylindricalPair(4e12, 1), 1 - 1e-12),
}
# The worst targets that searches met, by mechanism.
WORST: dict[str, tuple[float, ...]] = {}


def sizes_of(mechanism: Mechanism) -> tuple[float, float, float]:
    if isinstance(mechanism, EllipticPlanetary):
        return mechanism.R1, mechanism.R2, mechanism.e
    pair = mechanism.pair
    assert isinstance(pair, CylindricalPair)
    return float(pair.R4), float(pair.R5), float(mechanism.e2)


def draw_targets(mechanism: Mechanism, seed: int) -> Array:
    """Draw output angles: even, by the logarithm, and where the carrier is at a singular point."""
    rng = np.random.default_rng(seed)
    r1, r2, e = sizes_of(mechanism)
    turns = np.pi * r2 / r1 * np.array([0.5, 1, 2, 3, 101, 100_000])
    width = 10.0 ** rng.uniform(-14, 1, 12) * (1 - e) * r2 / r1
    at = np.concatenate([np.add.outer(turns[:4], width).ravel(), turns, np.nextafter(turns, 0)])
    at = np.concatenate([at, rng.uniform(-1e6, 1e6, 15), rng.uniform(-30, 30, 15)])
    reached = np.asarray(mechanism.position(at[np.abs(at) <= 1e6]))
    ladder = 10.0 ** rng.uniform(-290, 1, 20) * rng.choice([-1, 1], 20)
    return np.concatenate([reached, ladder, WORST_OF(mechanism)])


def WORST_OF(mechanism: Mechanism) -> Array:
    return np.array(next((WORST.get(n, ()) for n, m in MECHANISMS.items() if m is mechanism), ()))
