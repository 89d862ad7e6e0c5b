"""Paper 1: planetary mechanism with one internal cylindrical mesh and one elliptical pair."""

from mechproof.record import OnePass, Paper, PublishedSizes

from .aside import ASIDE
from .consequences import CONSEQUENCES
from .design import DESIGN_QUANTITIES, DESIGN_ROWS
from .findings import FINDINGS
from .kernels import QUANTITIES
from .peaks import PEAK_QUANTITIES
from .peaks_proved import PEAK_ROWS
from .position_rows import POSITION_CLAIMS, POSITION_ROWS
from .ratio_rows import RATIO_ROWS
from .readings import TABLE_CLAIMS, TYPE_A_ROWS
from .symbols import PRINT, R1, R2, VARIABLES, VARIANTS, e

PAPER = Paper(
    system="elliptic_planetary",
    citation="Prikhodko, Polivoda, Shchetinin 2024, planetary mechanism with an elliptical pair",
    doi="10.37313/1990-5378-2024-26-3-164-171",
    variables=VARIABLES,
    notation=PRINT.notation,
    where=PRINT.where,
    print=PRINT.file,
    rows=(
        *RATIO_ROWS,
        *POSITION_ROWS,
        *POSITION_CLAIMS,
        *TYPE_A_ROWS,
        *TABLE_CLAIMS,
        *CONSEQUENCES,
        *PEAK_ROWS,
        *DESIGN_ROWS,
    ),
    quantities=(*QUANTITIES, *PEAK_QUANTITIES, *DESIGN_QUANTITIES),
    derivatives=True,
    one_pass=(OnePass("motion", ("position", "ratio", "acceleration")),),
    published=tuple(
        PublishedSizes(f"Table 1, variant {number}", dict(zip((R1, R2, e), sizes, strict=True)))
        for number, sizes in VARIANTS.items()
    ),
    findings=FINDINGS,
    transcription="2",
    sentences=60,
    aside=ASIDE,
    conventions=(
        "Angles are positive in the direction of the carrier's rotation; distances on the line "
        "A-C are positive from A towards C and B. Lengths in mm, angles in rad."
    ),
)
