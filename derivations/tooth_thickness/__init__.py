"""Paper 3: thickness of gear teeth, measured with a gear-tooth gauge, and the sorting by it."""

from mechproof.record import Paper, Published

from .kernels import QUANTITIES
from .paper import ROWS, VARIABLES, WHEEL

PAPER = Paper(
    system="tooth_thickness",
    citation="Paper 3: stochastic simulation of tooth thickness and of its measurement",
    variables=VARIABLES,
    rows=ROWS,
    quantities=QUANTITIES,
    published=(Published("paper on tooth thickness, design data", WHEEL, ("fitted",)),),
    conventions="Lengths in mm, angles in rad. Heights grow from the tip towards the centre; "
    "deviations of thickness are positive for a thicker tooth.",
)
