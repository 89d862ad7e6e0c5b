"""Paper 4: pusher, lever, rod, roller lever and wedge, split into four Assur groups."""

from sympy import Rational, S

from mechproof.record import Paper

from . import kernels, mechanics, rows
from .mechanics import PRINT, error, own_error, stage_ratio
from .rows.findings import FINDINGS
from .rows.sizes import FIRST_SET, SECOND_SET

MODEL = "describes the model, whose equations are judged"
USE = "says what the model can be used for"
OTHERS = "describes practice and literature, with no number"
ASIDE = {
    "S1": "title and authors",
    **dict.fromkeys(("S2", "S3", "S4", "S5"), f"abstract: {MODEL}"),
    **dict.fromkeys(("S8", "S9"), f"abstract: {USE}"),
    "S10": "keywords",
    **dict.fromkeys(("S11", "S12", "S13", "S14", "S15", "S16"), OTHERS),
    **dict.fromkeys(("S17", "S19"), "aim"),
    "S24": "caption",
    "S26": "explains letters",
    **dict.fromkeys(("S37", "S38"), "caption and legend"),
    **dict.fromkeys(("S47", "S49", "S50", "S51"), USE),
}

PAPER = Paper(
    system="wedge_linkage",
    citation="Bazuev, Koksharov, Naichuk 2021, transfer function of a rod semi-automatic",
    doi="10.15593/2224-9982/2021.64.07",
    variables=(*mechanics.VARIABLES, *kernels.VARIABLES, *rows.VARIABLES),
    notation=PRINT.notation,
    print=PRINT.file,
    rows=rows.ROWS,
    quantities=kernels.QUANTITIES,
    derivatives=True,
    published=(FIRST_SET, SECOND_SET),
    usual={error: S.One, stage_ratio: S.Half, own_error: Rational(1, 5)},
    findings=FINDINGS,
    transcription="2",
    sentences=52,
    aside=ASIDE,
    conventions="Displacements and rotations are counted from the position x1 = 0; angles from Ox, "
    "positive counter-clockwise; x to the right, y upwards.",
)
