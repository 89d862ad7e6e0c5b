"""Paper 4: pusher, lever, rod, roller lever and wedge, split into four Assur groups."""

import sympy as sp

from mechproof.record import Paper

from . import chain, conditioning, proofs, sizes, steps, variables
from .findings import FINDINGS
from .kernels import QUANTITIES
from .lever_equations import LEVER_ROWS
from .roller_equations import ROLLER_ROWS
from .sizes import FIRST_SET, SECOND_SET
from .structure import STRUCTURE_ROWS
from .symbols import NOTATION, error, own_error, stage_ratio
from .table import SIZE_ROWS
from .tolerances import RANGE_ROWS
from .transfer import TRANSFER_ROWS

PAPER = Paper(
    system="wedge_linkage",
    citation=(
        "Bazuev, Koksharov, Naichuk 2021, transfer function of a rod semi-automatic, "
        "doi 10.15593/2224-9982/2021.64.07"
    ),
    variables=(
        *variables.VARIABLES,
        *steps.VARIABLES,
        *chain.VARIABLES,
        *conditioning.VARIABLES,
        *proofs.VARIABLES,
        *sizes.VARIABLES,
    ),
    notation=NOTATION,
    rows=(*STRUCTURE_ROWS, *LEVER_ROWS, *ROLLER_ROWS, *TRANSFER_ROWS, *SIZE_ROWS, *RANGE_ROWS),
    quantities=QUANTITIES,
    published=(FIRST_SET, SECOND_SET),
    usual={error: sp.S.One, stage_ratio: sp.S.Half, own_error: sp.Rational(1, 5)},
    findings=FINDINGS,
    conventions=(
        "Displacements and rotations are counted from the position x1 = 0; angles from Ox, "
        "positive counter-clockwise; x to the right, y upwards."
    ),
)
