"""Quantities of paper 4: the chain and its derivatives; every form of them."""

import sympy as sp
from sympy import Abs, Eq, Le, sqrt

from mechproof.record import Accuracy, Chart, Form, Part, Quantity, Scale, Singular

from ..._algebra import LARGEST
from ..mechanics import BEFORE_PIVOT, MOVABLE, guide_square, l_GH, l_KL, x1
from . import chain, charts, inputs, proofs
from .stages import CHAIN_SOURCE, LOW_ROLLER

CLOSED = Part(
    "the linkage closes",
    where=(guide_square >= 0, l_KL - chain.MEANT.offset >= 0, l_KL + chain.MEANT.offset >= 0),
)
MOVING = Part(
    "the linkage closes and is at no dead centre",
    where=(guide_square > 0, l_KL - chain.MEANT.offset > 0, l_KL + chain.MEANT.offset > 0),
)
OPEN = Part(f"{MOVABLE.text}; {proofs.UPWARD.text}", proofs.UPWARD.within, MOVABLE.where)
IN_CASES = Part(
    f"{BEFORE_PIVOT.text}; {proofs.NOT_UPRIGHT.text}", proofs.NOT_UPRIGHT.within, BEFORE_PIVOT.where
)
RANGE = f"{inputs.SHORT_GUIDE} or {LOW_ROLLER}"

ALONG_CHAIN = (
    inputs.AT_REST,
    Singular(
        Eq(chain.MEANT.travel, l_GH),
        "the start of contact: derivatives jump, here they are those in contact",
    ),
    Singular(Eq(chain.MEANT.offset, 0)),
    inputs.PIVOT,
)
POSITION_ALONG_CHAIN = (inputs.AT_REST, Singular(Eq(chain.MEANT.travel, l_GH)), *ALONG_CHAIN[2:])


# A clearance is never squared.
LINKED = (
    *inputs.moderate(x1, *(size for size in chain.SIZES if size not in (*inputs.ANGLES, l_GH))),
    Le(l_GH, LARGEST),
    inputs.CLOSING,
    inputs.beside(l_KL + chain.MEANT.offset, "roller_condition"),
)
PUSHING = (inputs.beside(Abs(chain.MEANT.travel - l_GH), "run_condition"), *LINKED)
OF_ROLLER = f"{inputs.OF_GUIDE}, roller_condition of KL_x + l_KL in contact"
LINK_EDGES = f"{inputs.CONDITIONING}: {OF_ROLLER}"
ALL_EDGES = f"{inputs.CONDITIONING}: run_condition of travel_5, {OF_ROLLER}"


def conditioned_in_contact(
    ulp: float, value: sp.Basic, within: tuple[sp.Basic, ...] = ()
) -> Accuracy:
    """Bound the error by the conditioning in contact of a value of the chain, or by its norm."""
    in_contact = sp.Matrix([value]).subs(chain.MEANT.engaged, 1)
    # Nobody reads these long sums, and SymPy would take a second to tidy them.
    parts = [inputs.condition(part, (x1, *chain.SIZES), tidy=False) for part in in_contact]
    size = parts[0] if len(parts) == 1 else sqrt(sp.Add(*(part**2 for part in parts)))
    norm = "" if len(parts) == 1 else "norm over the entries (each keeps its own) of "
    scale = Scale(f"{norm}{inputs.CONDITION}, in contact", size)
    return Accuracy(ulp, scale, within)


# position: guide 3.5; run 5; push 1/2; rise and its sum 6.5, the share of alpha_KL 0.8 more; the
# last quotient 5: 22 if every step counted in full. Each has only its own share of the scale, and
# searches find less than 1 here; 8 leaves room for a sine that is 4 off. The same holds for
# derivatives.
CHAIN_ULP = 8
CHAIN_LOADS = (
    ("N inputs, one linkage", ("x1",)),
    ("one input, N linkages", tuple(map(str, chain.SIZES))),
)


def differentiate(
    name: str,
    summary: str,
    value: sp.Basic,
    form: sp.Basic,
    unit: str = "1",
    covering: tuple[Chart, ...] = (),
) -> Quantity:
    """Return the quantity of derivatives in contact: by the half-angle chain and by the slopes."""
    return Quantity(
        name,
        summary,
        inputs.arguments(x1, *chain.SIZES),
        value,
        (
            Form(
                "half-angle chain",
                form,
                states=proofs.slopes_in_contact(value),
                on=proofs.REACHED,
                charts=covering,
            ),
            Form(
                "product of slopes",
                chain.in_chain(value, chain.BY_ATAN2),
                key="slopes",
                states=proofs.by_stages(chain.BY_ATAN2, proofs.as_meant, value),
                on=OPEN,
                note="stage by stage, at the angles of the chain with atan2",
            ),
        ),
        CHAIN_SOURCE,
        unit=unit,
        accuracy=conditioned_in_contact(CHAIN_ULP, value, PUSHING),
        # No rung decides second derivatives of the chain in reasonable time.
        slopes=None,
        on=MOVING,
        singular=ALONG_CHAIN,
        workloads=CHAIN_LOADS,
        remarks=(RANGE, ALL_EDGES, inputs.BEYOND_SQUARES),
    )


QUANTITIES = (
    Quantity(
        "position",
        "Compute the displacement y9 of the wedge, the whole chain.",
        inputs.arguments(x1, *chain.SIZES),
        chain.POSITION,
        (
            Form(
                "half-angle chain",
                chain.POSITION_FORM,
                states=proofs.position_in_contact,
                on=proofs.REACHED,
                charts=charts.CHAIN,
            ),
            Form(
                "printed chain",
                chain.in_chain(chain.POSITION, chain.IN_PRINT),
                key="printed",
                states=proofs.by_stages(chain.IN_PRINT, proofs.by_quadrants, chain.POSITION),
                on=IN_CASES,
                source=CHAIN_SOURCE,
                note="stage by stage; R = 0 is in neither case: NaN",
            ),
            Form(
                "chain with atan2",
                chain.in_chain(chain.POSITION, chain.BY_ATAN2),
                key="atan2",
                states=proofs.by_stages(chain.BY_ATAN2, proofs.as_meant, chain.POSITION),
                on=OPEN,
                note="stage by stage",
            ),
        ),
        CHAIN_SOURCE,
        unit="mm",
        accuracy=conditioned_in_contact(CHAIN_ULP, chain.POSITION, LINKED),
        slopes=Accuracy(4, within=PUSHING),
        on=CLOSED,
        singular=POSITION_ALONG_CHAIN,
        workloads=CHAIN_LOADS,
        remarks=(RANGE, LINK_EDGES, inputs.BEYOND_SQUARES),
    ),
    differentiate(
        "velocity",
        "Compute dy9/dx1, the velocity of the wedge at unit speed of the pusher.",
        chain.VELOCITY,
        chain.VELOCITY_FORM,
        covering=charts.VELOCITY,
    ),
    differentiate(
        "sensitivities",
        "Compute the derivatives of y9 by the sizes, in the order of the arguments.",
        chain.SENSITIVITIES,
        sp.ImmutableDenseMatrix([chain.SENSITIVITY_FORMS[size] for size in chain.SIZES]),
        unit="mm per mm or mm per rad",
        covering=charts.VELOCITY,
    ),
)
