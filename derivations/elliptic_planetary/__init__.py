"""Paper 1: planetary mechanism with one internal cylindrical mesh and one elliptical pair."""

from mechproof.record import Paper, Published

from .findings import FINDINGS
from .kernels import QUANTITIES
from .paper import NOTATION, R1, R2, ROWS, VARIABLES, VARIANTS, e

PAPER = Paper(
    system="elliptic_planetary",
    citation=(
        "Prikhodko, Polivoda, Shchetinin 2024, planetary mechanism with an elliptical pair, "
        "doi 10.37313/1990-5378-2024-26-3-164-171"
    ),
    variables=VARIABLES,
    notation=NOTATION,
    where=(R2 < R1,),
    rows=ROWS,
    quantities=QUANTITIES,
    published=tuple(
        Published(f"Table 1, variant {number}", dict(zip((R1, R2, e), sizes, strict=True)))
        for number, sizes in VARIANTS.items()
    ),
    findings=FINDINGS,
    conventions=(
        "Angles are positive in the direction of the carrier's rotation; distances on the line "
        "A-C are positive from A towards C and B. Lengths in mm, angles in rad."
    ),
)
