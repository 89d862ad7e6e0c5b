"""What can be computed of paper 4: its stages, the chain, its derivatives; every form of them."""

from __future__ import annotations

import sympy as sp

from mechproof.record import Form, Quantity

from .chain import BY_ATAN2, IN_PRINT, POSITION, SENSITIVITIES, SIZES, VELOCITY, in_chain
from .conditioning import (
    ALL_EDGES,
    ALONG_CHAIN,
    BEYOND_SQUARES,
    CHAIN_ULP,
    CLOSED,
    IN_CASES,
    LINK_EDGES,
    LINKED,
    MOVING,
    OPEN,
    POSITION_ALONG_CHAIN,
    PUSHING,
    RANGE,
    arguments,
    conditioned_in_contact,
)
from .proofs import (
    REACHED,
    as_meant,
    by_quadrants,
    by_stages,
    position_in_contact,
    slopes_in_contact,
)
from .stages import CHAIN_SOURCE, STAGES
from .steps import POSITION_FORM, SENSITIVITY_FORMS, VELOCITY_FORM
from .symbols import x1

CHAIN_LOADS = (
    ("N inputs, one linkage", ("x1",)),
    ("one input, N linkages", tuple(map(str, SIZES))),
)

QUANTITIES = (
    *STAGES,
    Quantity(
        "position",
        "Compute the displacement y9 of the wedge, the whole chain.",
        arguments(x1, *SIZES),
        POSITION,
        (
            Form("half-angle chain", POSITION_FORM, states=position_in_contact, on=REACHED),
            Form(
                "printed chain",
                in_chain(POSITION, IN_PRINT),
                key="printed",
                states=by_stages(IN_PRINT, by_quadrants, POSITION),
                on=IN_CASES,
                source=CHAIN_SOURCE,
                note="stage by stage; R = 0 is in neither case: NaN",
            ),
            Form(
                "chain with atan2",
                in_chain(POSITION, BY_ATAN2),
                key="atan2",
                states=by_stages(BY_ATAN2, as_meant, POSITION),
                on=OPEN,
                note="stage by stage",
            ),
        ),
        CHAIN_SOURCE,
        unit="mm",
        accuracy=conditioned_in_contact(CHAIN_ULP, POSITION, LINKED),
        on=CLOSED,
        singular=POSITION_ALONG_CHAIN,
        workloads=CHAIN_LOADS,
        remarks=(RANGE, LINK_EDGES, BEYOND_SQUARES),
    ),
    Quantity(
        "velocity",
        "Compute dy9/dx1, the velocity of the wedge at unit speed of the pusher.",
        arguments(x1, *SIZES),
        VELOCITY,
        (
            Form("half-angle chain", VELOCITY_FORM, states=slopes_in_contact(VELOCITY), on=REACHED),
            Form(
                "product of slopes",
                in_chain(VELOCITY, BY_ATAN2),
                key="slopes",
                states=by_stages(BY_ATAN2, as_meant, VELOCITY),
                on=OPEN,
                note="stage by stage, at the angles of the chain with atan2",
            ),
        ),
        CHAIN_SOURCE,
        accuracy=conditioned_in_contact(CHAIN_ULP, VELOCITY, PUSHING),
        on=MOVING,
        singular=ALONG_CHAIN,
        workloads=CHAIN_LOADS,
        remarks=(RANGE, ALL_EDGES, BEYOND_SQUARES),
    ),
    Quantity(
        "sensitivities",
        "Compute the derivatives of y9 by the sizes, in the order of the arguments.",
        arguments(x1, *SIZES),
        SENSITIVITIES,
        (
            Form(
                "half-angle chain",
                sp.ImmutableDenseMatrix([SENSITIVITY_FORMS[size] for size in SIZES]),
                states=slopes_in_contact(SENSITIVITIES),
                on=REACHED,
            ),
            Form(
                "product of slopes",
                in_chain(SENSITIVITIES, BY_ATAN2),
                key="slopes",
                states=by_stages(BY_ATAN2, as_meant, SENSITIVITIES),
                on=OPEN,
                note="stage by stage, at the angles of the chain with atan2",
            ),
        ),
        CHAIN_SOURCE,
        unit="mm per mm or mm per rad",
        accuracy=conditioned_in_contact(CHAIN_ULP, SENSITIVITIES, PUSHING),
        on=MOVING,
        singular=ALONG_CHAIN,
        workloads=CHAIN_LOADS,
        remarks=(RANGE, ALL_EDGES, BEYOND_SQUARES),
    ),
)
