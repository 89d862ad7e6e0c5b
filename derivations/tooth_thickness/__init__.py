"""Paper 3: thickness of gear teeth, measured with a gear-tooth gauge, and the sorting by it."""

from sympy import Rational

from mechproof.record import Paper, PublishedSizes

from .kernels import QUANTITIES
from .mechanics import *
from .rows import ROWS
from .rows.findings import FINDINGS

BEFORE = "describes what earlier work or the standard has, with no number"
MODEL = "describes the structure of the model, with no formula"
ASIDE = {
    "S1": "title and authors",
    **dict.fromkeys(("S2", "S3", "S4"), "abstract: names steps and results of the flow chart"),
    "S5": "keywords",
    "S6": BEFORE,
    "S7": "says what the tolerances of thickness depend on in GOST 1643-81, with no number of it",
    "S10": "caption, explains letters",
    **dict.fromkeys(("S11", "S12"), BEFORE),
    "S13": "aim",
    **dict.fromkeys(("S14", "S15", "S16", "S17", "S18", "S19"), MODEL),
    "S21": "refers to the flow chart",
    "S22": "names the software",
    "S40": "says where the indices stand in the table, whose body is lost",
    **dict.fromkeys(("S43", "S44"), "says what the model serves for"),
}

PAPER = Paper(
    system="tooth_thickness",
    citation="Derbaba, Korsun, Patsera, stochastic simulation of the thickness of an involute "
    "tooth and of its measurement",
    variables=VARIABLES,
    notation=NOTATION,
    where=PRINT.where,
    print=PRINT.file,
    rows=ROWS,
    quantities=QUANTITIES,
    derivatives=True,
    published=(PublishedSizes("the design data", PRINTED_SIZES, ("fitted",)),),
    # A tip diameter off by IT6, a gauge and a tooth off by less.
    usual={
        e_tip: Rational(25, 1000),
        dh_gauge: Rational(10, 1000),
        ds_gauge: Rational(10, 1000),
        E_true: Rational(-30, 1000),
        dh: Rational(20, 1000),
    },
    findings=FINDINGS,
    transcription="2",
    sentences=49,
    aside=ASIDE,
    conventions="Lengths in mm, angles in rad. Heights grow from the tip towards the centre; "
    "deviations of thickness are positive for a thicker tooth.",
)
