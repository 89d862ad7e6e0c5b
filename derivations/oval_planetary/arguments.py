"""Arguments and singular sets of the kernels of paper 2."""

from __future__ import annotations

import sympy as sp

from mechproof.record import Argument, Singular

from .symbols import R4, R5, e1, e2, k, m, mount, phi1, x

ECCENTRICITIES = (0, 0.28, 0.5, 0.9, 0.99, 1)
CARRIER = Argument(
    "phi1", (phi1,), "carrier angle, any number of turns", "rad", usual=(0, 10, 1000)
)
OVAL_63 = Argument("e2", (e2,), "eccentricity of the oval pair 6-3", usual=ECCENTRICITIES)
OF_OVALS = (
    CARRIER,
    Argument("e1", (e1,), "eccentricity of the oval pair 4-5", usual=(0, 0.5, 1)),
    OVAL_63,
    Argument(
        "mount",
        (mount,),
        "turn of wheel 6 on its shaft, forward from its place in the paper",
        "rad",
        0.0,
        usual=(0, 0.4, float(sp.pi)),
    ),
)
OF_CYLINDERS = (
    CARRIER,
    Argument("R4", (R4,), "radius of the cylindrical sun 4", "mm"),
    Argument("R5", (R5,), "radius of the cylindrical wheel 5", "mm"),
    OVAL_63,
)

# A wheel makes quarter turns; the major axes of the pair 6-3 meet, where the ratio is steep; wheel
# 6 is mounted along an axis; equal ovals; round and flat ones.
SINGULAR_OVALS = tuple(
    map(
        Singular,
        (
            sp.Eq(phi1, sp.pi / 2 * m),
            sp.Eq(
                (1 + e1) * sp.sin(phi1) * sp.cos(mount) + (1 - e1) * sp.cos(phi1) * sp.sin(mount), 0
            ),
            sp.Eq(mount, sp.pi / 2 * m),
            sp.Eq(e1, e2),
            sp.Eq(e1, 0),
            sp.Eq(e2, 0),
            sp.Eq(e1, 1),
            sp.Eq(e2, 1),
        ),
    )
)

# The ratio is farthest from 1 and nearest to it; equal circles; double zeros of the ratio; the
# round and the flat oval.
SINGULAR_CYLINDERS = tuple(
    map(
        Singular,
        (
            sp.Eq(x, 2 * sp.pi * m),
            sp.Eq(x, sp.pi + 2 * sp.pi * m),
            sp.Eq(R4, R5),
            sp.Eq(k * (1 - e2), 1 + e2),
            sp.Eq(k * (1 + e2), 1 - e2),
            sp.Eq(e2, 0),
            sp.Eq(e2, 1),
        ),
    )
)
