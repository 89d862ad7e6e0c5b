"""Paper 2: planetary mechanism with two external pairs of oval wheels."""

from mechproof.record import Paper, PublishedSizes, Together

from .cylindrical_pairs import CYLINDRICAL_PAIR_ROWS
from .equations import EQUATION_ROWS
from .findings import FINDINGS
from .kernels import QUANTITIES
from .oval_pairs import OVAL_PAIR_ROWS
from .readings import MEASUREMENT_ROWS
from .symbols import NOTATION, VARIABLES
from .variants import VARIANT_ROWS, VARIANTS

PAPER = Paper(
    system="oval_planetary",
    citation=(
        "Prikhodko, Kurapov, Belina, Azizov, Polivoda 2024, planetary mechanism with oval "
        "wheels, EDN HZWKZJ"
    ),
    variables=VARIABLES,
    notation=NOTATION,
    rows=EQUATION_ROWS + OVAL_PAIR_ROWS + CYLINDRICAL_PAIR_ROWS + VARIANT_ROWS + MEASUREMENT_ROWS,
    quantities=QUANTITIES,
    together=(
        Together("motion", ("position", "ratio", "acceleration")),
        Together(
            "motion_cylindrical",
            ("position_cylindrical", "ratio_cylindrical", "acceleration_cylindrical"),
        ),
    ),
    published=tuple(
        PublishedSizes(f"variant {number}", sizes) for number, sizes in VARIANTS.items()
    ),
    findings=FINDINGS,
    conventions=(
        "Angles in radians, positive in the direction of the carrier's rotation; lengths in mm. "
        "The paper's (10) has the opposite sign."
    ),
)
