"""Paper 2: planetary mechanism with two external pairs of oval wheels."""

from mechproof.record import OnePass, Paper, PublishedSizes

from .kernels import QUANTITIES
from .mechanics import PRINT, VARIABLES
from .rows import ROWS
from .rows.findings import FINDINGS
from .rows.variants import VARIANTS

ASIDE = {
    "S1": "title, authors and dates",
    "S2": "why such transmissions are used; no number",
    "S5": "names the stand and the four variants",
    "S6": "how the position function was measured",
    "S8": "keywords",
    "S9": "history",
    "S10": "history, and a comparison with linkages without a number",
    "S11": "why such devices are used",
    "S12": "what others hold",
    "S13": "works of others",
    "S15": "follows from S14 and S32: reciprocating rotation, which fixed axes do not give",
    "S16": "the aim",
    "S17": "caption of Fig. 1: names the links and the points, which the mechanics take over",
    "S33": "caption of Fig. 2, whose curves are not at hand",
    "S35": "announces the experiment",
    "S36": "how the prototype was made",
    "S38": "captions of Fig. 3 and Fig. 4",
    "S39": "how the data were taken; no number",
    "S40": "caption of Fig. 5, of which only tick labels of no variant survive",
    "S42": "announces (12) to (15)",
}


PAPER = Paper(
    system="oval_planetary",
    citation="Prikhodko, Kurapov, Belina, Azizov, Polivoda 2024, planetary mechanism with oval "
    "wheels, EDN HZWKZJ",
    variables=VARIABLES,
    notation=PRINT.notation,
    where=PRINT.where,
    print=PRINT.file,
    rows=ROWS,
    quantities=QUANTITIES,
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
    conventions="Angles in radians, positive in the direction of the carrier's rotation; lengths "
    "in mm. The paper's (10) has the opposite sign.",
)
