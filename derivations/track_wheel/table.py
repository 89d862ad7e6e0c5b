"""Part three: the data of Table 1, and what follows from them."""

import sympy as sp

from mechproof.record import (
    Completion,
    Completions,
    Conjunction,
    Datum,
    Definition,
    Equality,
    NotCheckable,
    PrintedNumber,
    Row,
    all_of,
    less,
    ours,
)

from .mechanics import FIVE_ERRORS, SUM_OF_SQUARES
from .symbols import *

REMARKS = {
    setting: "The symbol may be misread: as transcribed it is the one used for the wear in the "
    "next line; the words say setting of the machine, so that Delta_n of (6) is meant.",
    ball_radius: "The index of the letter may be misread. It enters none of the equations (1) to "
    "(18).",
}
SUM_OF_PRINTED_SQUARES = SUM_OF_SQUARES.subs(PRINTED_VALUES)


def total_by_corrected_sum(coefficient: sp.Expr) -> sp.Expr:
    """Solve the corrected (6), Delta_T being a share of the total: K = 1, equal K_i, one each."""
    return sp.sqrt(coefficient**2 * SUM_OF_SQUARES / (1 - (coefficient * share) ** 2))


def total_by_printed_sum(
    unit_of_length: sp.Expr, sum_of_squares: sp.Expr = SUM_OF_PRINTED_SQUARES
) -> sp.Expr:
    """Solve (6) as printed, all coefficients 1: Delta_T unsquared, so the unit enters."""
    linear = THERMAL_SHARE * unit_of_length
    return (linear + sp.sqrt(linear**2 + 4 * sum_of_squares)) / 2


def total_rounds_to(number: str, coefficient: sp.Expr) -> PrintedNumber:
    """State the total of Table 1, all K_i equal."""
    return PrintedNumber(number, total_by_corrected_sum(coefficient).subs(PRINTED_VALUES))


SOLVED_TOTAL = total_by_corrected_sum(sp.Integer(1))

# Tolerance of ISO 286 for 80 to 120 mm, mm; the track is 2(R + A) = 90.5 mm wide.
IT12 = sp.Rational("0.35")


def exceeds_others(tolerance: sp.Expr) -> Conjunction:
    """State that a tolerance exceeds each other error of Table 1 and all of them together."""
    together = SOLVED_TOTAL.subs(form, 0).subs(PRINTED_VALUES)
    others = (*(PRINTED_VALUES[other] for other in FIVE_ERRORS[1:]), together)
    return all_of(*(less(other, tolerance) for other in others))


TABLE_ROWS: tuple[Row, ...] = (
    *(
        Datum(
            f"Table 1, {what}",
            f"{before}{number}{unit}",
            Definition(symbol, sp.Rational(number) * (millimetre if unit == MM else 1)),
            note=REMARKS.get(symbol, ""),
            cites=("S46",),
            marks=("uncertain",) if symbol in REMARKS else (),
        )
        for what, symbol, before, number, unit in TABLE
    ),
    PRINT.datum(
        "Table 1, temperature error",
        Definition(thermal, THERMAL_SHARE * total),
        note="The error is given as a share of the total of which it is a part, so that (6) "
        "becomes an equation for the total.",
    ),
    ours(
        "Table 1, total",
        r"\Delta_\Sigma^2=q+(\tau\Delta_\Sigma)^2\text{ has exactly one positive solution, }"
        r"q=\Delta_\phi^2+\Delta_y^2+\Delta_\delta^2+\Delta_n^2+\Delta_u^2",
        all_of(
            Equality(
                total**2 - (SUM_OF_SQUARES + (share * total) ** 2),
                (1 - share**2) * (total - SOLVED_TOTAL) * (total + SOLVED_TOTAL),
            ),
            less(share**2, sp.Integer(1)),
            less(sp.Integer(0), SOLVED_TOTAL**2),
        ),
        note="The corrected (6), with one error in each group and all coefficients 1. The other "
        "root is the negative of this one; in Table 1 the share is 0.15.",
        quantities=("error_sum_thermal",),
    ),
    ours(
        "Table 1, missing data",
        r"\Delta_\Sigma=0.072\text{ mm, without }K,K_i",
        Completions(
            "the coefficients K_i",
            Completion("all K_i = 1 (normal laws)", total_rounds_to("0.072", sp.Integer(1))),
            Completion("all K_i = sqrt(3) (uniform laws)", total_rounds_to("0.072", sp.sqrt(3))),
        ),
        note="Table 1 has no K and no K_i. Nor does the transcription have z, H_s, a, b, c, S_i "
        "and n, which Figs. 3 to 5 need as well.",
    ),
    PRINT.claim(
        "before Fig. 4, form and size",
        NotCheckable("the levels of [7, 8] and the tolerance on the size of the base surface"),
        note="Of the two sizes only the form error, 0.016 mm, is in Table 1.",
    ),
    PRINT.claim(
        "after roughing",
        exceeds_others(IT12),
        note='It "can", so that one example proves it: the tolerance on size of grade 12, 0.35 '
        "mm (ISO 286, 80 to 120 mm), which a form error may use up, compared with the other "
        "errors of Table 1, each and all together. Those are of finish milling; the errors after "
        "roughing are not in the transcription.",
        marks=("inferred",),
    ),
)
