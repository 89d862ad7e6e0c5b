"""Paper 3: thickness of gear teeth, measured with a gear-tooth gauge, and the sorting by it."""

from sympy import Rational

from mechproof.record import Paper, PublishedSizes

from .algorithm import ALGORITHM_ROWS
from .claims import CLAIM_ROWS
from .design import DESIGN_ROWS
from .example import EXAMPLE_ROWS
from .findings import FINDINGS
from .influence import INFLUENCE_ROWS
from .kernels import QUANTITIES
from .parameters import PARAMETER_ROWS
from .symbols import NOTATION, VARIABLES, E_true, dh, dh_gauge, ds_gauge, e_tip
from .wheel import PRINTED_SIZES

PAPER = Paper(
    system="tooth_thickness",
    citation="Paper 3: stochastic simulation of tooth thickness and of its measurement",
    variables=VARIABLES,
    notation=NOTATION,
    rows=(
        *DESIGN_ROWS,
        *INFLUENCE_ROWS,
        *PARAMETER_ROWS,
        *ALGORITHM_ROWS,
        *EXAMPLE_ROWS,
        *CLAIM_ROWS,
    ),
    quantities=QUANTITIES,
    published=(
        PublishedSizes("paper on tooth thickness, design data", PRINTED_SIZES, ("fitted",)),
    ),
    # A tip diameter off by IT6, a gauge and a tooth off by less.
    usual={
        e_tip: Rational(25, 1000),
        dh_gauge: Rational(10, 1000),
        ds_gauge: Rational(10, 1000),
        E_true: Rational(-30, 1000),
        dh: Rational(20, 1000),
    },
    findings=FINDINGS,
    conventions="Lengths in mm, angles in rad. Heights grow from the tip towards the centre; "
    "deviations of thickness are positive for a thicker tooth.",
)
