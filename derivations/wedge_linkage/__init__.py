"""Paper 4: pusher, lever, rod, roller lever and wedge, split into four Assur groups."""

from mechproof.record import Paper

from . import chain, kernels, proofs, steps
from .kernels import QUANTITIES
from .paper import ROWS, VARIABLES
from .sizes import FIRST_SET, SECOND_SET

PAPER = Paper(
    system="wedge_linkage",
    citation=(
        "Bazuev, Koksharov, Naichuk 2021, transfer function of a rod semi-automatic, "
        "doi 10.15593/2224-9982/2021.64.07"
    ),
    variables=(
        *VARIABLES,
        *steps.VARIABLES,
        *chain.VARIABLES,
        *kernels.VARIABLES,
        *proofs.VARIABLES,
    ),
    rows=ROWS,
    quantities=QUANTITIES,
    published=(FIRST_SET, SECOND_SET),
    conventions=(
        "Displacements and rotations are counted from the position x1 = 0; angles from Ox, "
        "positive counter-clockwise; x to the right, y upwards."
    ),
)
