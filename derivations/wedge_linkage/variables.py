"""The variables of paper 4: its printed symbols, and those that the proofs need besides."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from mechproof.record import ANGLE, LENGTH, Variable

from .mechanics import POLYGON_SIDES
from .prints import PRINTED_Q, PRINTED_R
from .symbols import (
    AD,
    DG,
    HL,
    LENGTH_OF_Q,
    LP,
    POSITIVE,
    PRINTED_VARIABLES,
    alpha_1,
    alpha_2,
    apart,
    beyond,
    combinations,
    crossing_place,
    elements,
    error,
    guide_square,
    h3,
    h7,
    height,
    height_square,
    kappa,
    l_GH,
    l_KL,
    overlap,
    own_error,
    radicand,
    reach,
    sigma,
    stage_ratio,
    tau,
    tolerances,
    x5,
)

VARIABLES = (
    *PRINTED_VARIABLES,
    Variable(tau, "tangent of half the direction of KL", within=sp.Interval(0, sp.oo)),
    Variable(sigma, "cotangent of half the direction of KL", within=sp.Interval(0, sp.oo)),
    Variable(kappa, "tangent of half of alpha_KL", within=sp.Interval(0, sp.oo)),
    replace(LENGTH_OF_Q, given=PRINTED_Q),
    Variable(overlap, "x5 less the clearance", LENGTH, given=x5 - l_GH),
    Variable(reach, "present length of BC", LENGTH, POSITIVE),
    Variable(h3, "sum of both lengths of BC", LENGTH, POSITIVE),
    Variable(h7, "sum of both heights of K over L", LENGTH, POSITIVE),
    Variable(height, "height of K over L", LENGTH, POSITIVE),
    Variable(guide_square, "square of the present length of BC", LENGTH**2, given=radicand),
    Variable(height_square, "square of the height", LENGTH**2, given=l_KL**2 - PRINTED_R**2),
    Variable(error, "error that a stage takes in, in amount", LENGTH, POSITIVE),
    Variable(stage_ratio, "ratio of a stage, in amount", within=POSITIVE),
    Variable(own_error, "error that a stage adds, in amount", LENGTH, sp.Interval(0, sp.oo)),
    *(Variable(a, "a direction of KL at x1 = 0", ANGLE) for a in (alpha_1, alpha_2)),
    *(
        Variable(v, f"vector {v}", LENGTH, given=value, latex=(rf"\vec{{{v}}}",))
        for v, value in POLYGON_SIDES.items()
    ),
    *(Variable(v, f"vector {v}", LENGTH, latex=(rf"\vec{{{v}}}",)) for v in (AD, DG, HL, LP)),
    Variable(apart, "distance of x5 from the start of contact, in amount", LENGTH, POSITIVE),
    Variable(elements, "number of elements", within=sp.S.Naturals),
    Variable(tolerances, "number of sizes with tolerances", within=sp.S.Naturals),
    Variable(combinations, "number of combinations of limits", within=sp.S.Naturals),
    Variable(crossing_place, "displacement at which the curves III and IV cross", LENGTH),
    Variable(beyond, "half of what varphi7 exceeds pi - 2 alpha_KL by", ANGLE),
)
