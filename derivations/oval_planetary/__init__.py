"""Paper 2: planetary mechanism with two external pairs of oval wheels."""

from mechproof.record import Paper, Published

from .kernels import QUANTITIES
from .paper import VARIABLES, VARIANTS
from .rows import ROWS

PAPER = Paper(
    system="oval_planetary",
    citation=(
        "Prikhodko, Kurapov, Belina, Azizov, Polivoda 2024, planetary mechanism with oval "
        "wheels, EDN HZWKZJ"
    ),
    variables=VARIABLES,
    rows=ROWS,
    quantities=QUANTITIES,
    published=tuple(Published(f"variant {number}", sizes) for number, sizes in VARIANTS.items()),
    conventions=(
        "Angles in radians, positive in the direction of the carrier's rotation; lengths in mm. "
        "The paper's (10) has the opposite sign."
    ),
)
