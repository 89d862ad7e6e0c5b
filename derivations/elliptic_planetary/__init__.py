"""Paper 1: planetary mechanism with one internal cylindrical mesh and one elliptical pair."""

from mechproof.record import OnePass, Paper, PublishedSizes

from .kernels import QUANTITIES
from .mechanics import PRINT, R1, R2, VARIABLES, VARIANTS, e
from .rows import ROWS
from .rows.findings import FINDINGS

ASIDE = {
    "S1": "title, authors and dates",
    "S2": "why such transmissions are used; no number",
    "S3": "an application; no number",
    "S4": "names what is studied",
    "S8": "keywords",
    "S9": "history",
    "S10": "history",
    "S11": "what others make",
    "S12": "an application, by another work",
    "S13": "the aim",
    "S14": "caption of Fig. 1, with numbers of links that no formula uses",
    "S15": "announces Fig. 2",
    "S16": "caption of Fig. 2: names the links and the points, which the mechanics take over",
    "S36": "caption of Fig. 3; the letters of its axes are lost, its curves are not at hand",
    "S38": "announces the experiment",
    "S39": "how the prototype was made",
    "S41": "how the signal goes to the computer",
    "S42": "caption of Fig. 5",
    "S43": "how the data were taken; no number",
    "S44": "caption of Fig. 6, which is not at hand",
    "S46": "announces (13) to (16)",
    "S57": "proposes the mechanism",
}


PAPER = Paper(
    system="elliptic_planetary",
    citation="Prikhodko, Polivoda, Shchetinin 2024, planetary mechanism with an elliptical pair",
    doi="10.37313/1990-5378-2024-26-3-164-171",
    variables=VARIABLES,
    notation=PRINT.notation,
    where=PRINT.where,
    print=PRINT.file,
    rows=ROWS,
    quantities=QUANTITIES,
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
    conventions="Angles are positive in the direction of the carrier's rotation; distances on the "
    "line A-C are positive from A towards C and B. Lengths in mm, angles in rad.",
)
