"""Paper 2: planetary mechanism with two external pairs of oval wheels."""

from mechproof.record import OnePass, Paper, PublishedSizes

from .aside import ASIDE
from .conclusions import CONCLUSION_ROWS
from .consequences import CONSEQUENCES
from .dwells import DWELL_ROWS
from .equations import EQUATION_ROWS
from .findings import FINDINGS
from .jerk import JERK_QUANTITIES
from .kernels import QUANTITIES
from .mechanics import VARIABLES
from .pairs import CYLINDRICAL_PAIR_ROWS, OVAL_PAIR_ROWS
from .readings import MEASUREMENT_ROWS
from .symbols import PRINT
from .variants import VARIANT_ROWS, VARIANTS

PAPER = Paper(
    system="oval_planetary",
    citation=(
        "Prikhodko, Kurapov, Belina, Azizov, Polivoda 2024, planetary mechanism with oval "
        "wheels, EDN HZWKZJ"
    ),
    variables=VARIABLES,
    notation=PRINT.notation,
    where=PRINT.where,
    print=PRINT.file,
    rows=(
        *EQUATION_ROWS,
        *OVAL_PAIR_ROWS,
        *CYLINDRICAL_PAIR_ROWS,
        *VARIANT_ROWS,
        *MEASUREMENT_ROWS,
        *CONCLUSION_ROWS,
        *CONSEQUENCES,
        *DWELL_ROWS,
    ),
    quantities=(*QUANTITIES, *JERK_QUANTITIES),
    derivatives=True,
    one_pass=(
        OnePass("motion", ("position", "ratio", "acceleration")),
        OnePass(
            "motion_cylindrical",
            ("position_cylindrical", "ratio_cylindrical", "acceleration_cylindrical"),
        ),
    ),
    published=tuple(
        PublishedSizes(f"variant {number}", sizes) for number, sizes in VARIANTS.items()
    ),
    findings=FINDINGS,
    transcription="2",
    sentences=57,
    aside=ASIDE,
    conventions=(
        "Angles in radians, positive in the direction of the carrier's rotation; lengths in mm. "
        "The paper's (10) has the opposite sign."
    ),
)
