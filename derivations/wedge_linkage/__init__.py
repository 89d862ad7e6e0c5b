"""Paper 4: pusher, lever, rod, roller lever and wedge, split into four Assur groups."""

import sympy as sp

from mechproof.record import Check, Cost, Finding, Paper, Weight

from . import chain, conditioning, mechanics, proofs, sizes
from .boundaries import BUDGET_ROWS, upright_at, upright_wedge
from .kernels import QUANTITIES
from .mechanics import PRINT, alpha_KL, error, l_KL, own_error, stage_ratio
from .sizes import FIRST_SET, SECOND_SET, SIZE_ROWS, limits
from .tolerances import RANGE_ROWS
from .transfer import GROUP_ROWS, SUBSTITUTED, SUBSTITUTION_ROWS, TRANSFER_ROWS

UPRIGHT_RUN = (l_KL * sp.cos(alpha_KL)).xreplace(limits(FIRST_SET, {}))

FINDINGS = (
    Finding(
        SUBSTITUTED,
        "(7) holds for R > 0 and (8) for R < 0, and the arctangents of both divide by R; the text "
        "at hand has no case for R = 0. There KL is upright, in the middle of Fig. 4, and "
        "y_9(x_1) has no value. Both cases tend to the same limit, so that a third one closes the "
        "gap.",
        costs=(
            Cost(
                "x_1 of the gap",
                "mm",
                printed=upright_at(FIRST_SET),
                right=upright_at(SECOND_SET),
                names=("by the first reconstructed set of sizes", "by the second"),
            ),
        ),
        weight=Weight.FORMULA,
        mend="(7) and (8), at R = 0",
        check=Check(
            "R = 0 at x_5' = 60 cos 65° = {0}; y_9 there is 145 (sin 148.48° - sin 123.48°) = {1}.",
            (UPRIGHT_RUN, upright_wedge(FIRST_SET)),
            2,
            "mm",
        ),
    ),
)

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
    variables=tuple(
        variable
        for module in (mechanics, chain, conditioning, proofs, sizes)
        for variable in module.VARIABLES
    ),
    notation=PRINT.notation,
    print=PRINT.file,
    rows=(*GROUP_ROWS, *SUBSTITUTION_ROWS, *TRANSFER_ROWS, *SIZE_ROWS, *RANGE_ROWS, *BUDGET_ROWS),
    quantities=QUANTITIES,
    derivatives=True,
    published=(FIRST_SET, SECOND_SET),
    usual={error: sp.S.One, stage_ratio: sp.S.Half, own_error: sp.Rational(1, 5)},
    findings=FINDINGS,
    transcription="2",
    sentences=52,
    aside=ASIDE,
    conventions="Displacements and rotations are counted from the position x1 = 0; angles from Ox, "
    "positive counter-clockwise; x to the right, y upwards.",
)
