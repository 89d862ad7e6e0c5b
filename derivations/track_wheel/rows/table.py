"""Part three: the data of Table 1, and what follows from them."""

import sympy as sp

from mechproof.record import *
from mechproof.record.parts import differentiate

from ..mechanics import *

MM, RAD = r"~\mathrm{mm}", r"~\mathrm{rad}"
# The words for a size, its symbol, the print before its number, the number, and the print after it.
TABLE = (
    ("form error", form, r"\Delta_\phi=", "0.016", MM),
    ("mounting error", mounting, r"\Delta_y=", "0.05", MM),
    ("elastic error", elastic, r"\Delta_\delta=", "0.042", MM),
    ("setting error", setting, r"\Delta_u=", "0.01", MM),
    ("tool wear", wear, r"\Delta_u=", "0.021", MM),
    ("radius", radius, "R=", "41.5", MM),
    ("amplitude", amplitude, "A=", "3.75", MM),
    ("ball radius", ball_radius, "r_u=", "7.5", MM),
    ("turn about X", alpha, r"\alpha=", "0.00103", RAD),
    ("turn about Y", beta, r"\beta=", "0.00103", RAD),
    ("turn about Z", gamma, r"\gamma=", "0", ""),
)
THERMAL_SHARE = sp.Rational("0.15")
PRINTED_VALUES = {
    **{symbol: sp.Rational(number) for _, symbol, _, number, _ in TABLE},
    share: THERMAL_SHARE,
}
TABLE_1 = PublishedSizes("Table 1", PRINTED_VALUES)
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
    """Solve (6) as printed, all coefficients 1: Delta_T is not squared, so the unit matters."""
    linear = THERMAL_SHARE * unit_of_length
    return (linear + sp.sqrt(linear**2 + 4 * sum_of_squares)) / 2


def total_rounds_to(number: str, coefficient: sp.Expr) -> PrintedNumber:
    """State the total of Table 1, with all K_i equal."""
    return PrintedNumber(number, total_by_corrected_sum(coefficient).subs(PRINTED_VALUES))


SOLVED_TOTAL = total_by_corrected_sum(sp.Integer(1))

# Tolerance of ISO 286 for 80 to 120 mm, mm; the track is 2(R + A) = 90.5 mm wide.
IT12 = sp.Rational("0.35")


def exceeds_others(tolerance: sp.Expr) -> Conjunction:
    """State that a tolerance exceeds each other error of Table 1 and all of them together."""
    together = SOLVED_TOTAL.subs(form, 0).subs(PRINTED_VALUES)
    others = (*(PRINTED_VALUES[other] for other in FIVE_ERRORS[1:]), together)
    return all_of(*(less(other, tolerance) for other in others))


TABLE_ROWS = (
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
        note='It "can", so one example proves it: the tolerance on size of grade 12, 0.35 mm (ISO '
        "286, 80 to 120 mm), which a form error may use up, compared with the other errors of "
        "Table 1, each and all together. Those are of finish milling; the errors after roughing "
        "are not in the transcription.",
        marks=("inferred",),
    ),
)


# What follows for its sizes; none of it is printed in the paper -----------------------------------

SQUARES = {error: PRINTED_VALUES[error] ** 2 for error in FIVE_ERRORS}
FARTHEST = (radius + amplitude).subs(PRINTED_VALUES)
TURNS = PRINTED_K.subs(PRINTED_VALUES)
LARGEST_HEIGHT_ERROR = FARTHEST * sp.sqrt(TURNS[0, 2] ** 2 + TURNS[1, 2] ** 2)
UNIFORM = sp.Integer(3)  # the square of the coefficient of a uniform law
HALF = sp.Rational(1, 2)


def gain(
    error: sp.Symbol, left: sp.Expr = sp.S.Zero, own: sp.Expr = sp.S.One, others: sp.Expr = sp.S.One
) -> sp.Expr:
    """Fall of the total, in %, if this share of an error is left; K squared of it and the rest.

    It is the same for a temperature error of either kind that remains the same share of the total.
    """
    rest = others * (SUM_OF_PRINTED_SQUARES - SQUARES[error])
    before, after = (rest + own * part**2 * SQUARES[error] for part in (sp.S.One, left))
    return 100 * (1 - sp.sqrt(after / before))


def gain_by_printed_sum(error: sp.Symbol) -> sp.Expr:
    """Fall of the total by (6) as printed, in mm, when an error vanishes, in %."""
    before, after = (
        total_by_printed_sum(sp.S.One, SUM_OF_PRINTED_SQUARES - part)
        for part in (sp.S.Zero, SQUARES[error])
    )
    return 100 * (1 - after / before)


def share_of(error: sp.Symbol) -> sp.Expr:
    """Share of an error in the squared total of the five, in %."""
    return 100 * SQUARES[error] / SUM_OF_PRINTED_SQUARES


def radius_of_curvature(count: int, phase: sp.Expr) -> sp.Expr:
    """Radius of curvature, in mm, of the track with `count` periods, taken positive."""
    x, y = (c.subs({**PRINTED_VALUES, periods: count}) for c in PRINTED_16[:2])
    first = [differentiate(c, phi) for c in (x, y)]
    second = [differentiate(c, phi) for c in first]
    dx, dy, ddx, ddy = (c.subs(phi, phase / count) for c in (*first, *second))
    return sp.Abs(sp.sqrt(dx**2 + dy**2) ** 3 / (dx * ddy - dy * ddx))


CONSEQUENCES = (
    ours(
        "Consequences, shares of the errors",
        r"\Delta_y:49.4\,\%,\ \Delta_\delta:34.9\,\%,\ \Delta_u:8.7\,\%,\ \Delta_\phi:5.1\,\%,\ "
        r"\Delta_n:2.0\,\%\text{ of }q=\Delta_\phi^2+\Delta_y^2+\Delta_\delta^2+\Delta_n^2"
        r"+\Delta_u^2",
        all_of(*rounded(("5.1", "49.4", "34.9", "2.0", "8.7"), map(share_of, FIVE_ERRORS))),
        note="Mounting and elastic deformation make up five sixths of the squared total, with all "
        "coefficients 1. A random temperature error of 15 % of the total takes 2.25 % of its "
        "square; these are the shares of the rest.",
        marks=("consequence",),
    ),
    ours(
        "Fig. 5, largest possible gain",
        r"1-\sqrt{(q-\Delta_\delta^2)/q}\approx19.3\,\%,\ "
        r"q=\Delta_\phi^2+\Delta_y^2+\Delta_\delta^2+\Delta_n^2+\Delta_u^2",
        PrintedNumber("19.3", gain(elastic)),
        note="With all errors of one law and the other errors of Table 1 unchanged, the total "
        "falls by no more than this even if the elastic error vanishes, whether the temperature "
        "error is random or systematic.",
        marks=("consequence",),
    ),
    ours(
        "Consequences, gain by other laws",
        r"38.0\,\%\text{ if }\Delta_\delta\text{ alone has }K_i=\sqrt3,\ 7.9\,\%\text{ if all"
        r" others have};\ 5.0\,\%\text{ by (6) as printed, in mm}",
        all_of(
            PrintedNumber("38.0", gain(elastic, own=UNIFORM)),
            PrintedNumber("7.9", gain(elastic, others=UNIFORM)),
            PrintedNumber("5.0", gain_by_printed_sum(elastic)),
        ),
        note="How the bound of 19.3 % depends on the laws, which the text at hand does not have: "
        "for normal ones K_i = 1, for uniform ones the square root of 3.",
        marks=("consequence",),
    ),
    ours(
        "Consequences, half the mounting error",
        r"\Delta_y/2\text{ in the place of }\Delta_y\text{: }20.7\,\%\text{ less}",
        PrintedNumber("20.7", gain(mounting, left=HALF)),
        note="Halving the mounting error lowers the total by more than having no elastic error at "
        "all.",
        marks=("consequence",),
    ),
    ours(
        "Consequences, no form error",
        r"\Delta_\phi=0\text{: }2.6\,\%\text{ less}",
        PrintedNumber("2.6", gain(form)),
        note="In finish milling, by Table 1, the form error of the base surface accounts for no "
        "more than this.",
        marks=("consequence",),
    ),
    ours(
        "Consequences, turns alone",
        r"\max_{|p|\le R+A}|\Delta z_0|=0.0659\text{ mm at }z_{13}=0;\ "
        r"\Delta_\Sigma^{XY}=0.00146\,z_{13}\text{ on the axis}",
        all_of(
            PrintedNumber("0.0659", LARGEST_HEIGHT_ERROR),
            PrintedNumber("0.00146", sp.sqrt(TURNS[2, 0] ** 2 + TURNS[2, 1] ** 2)),
        ),
        note="By (15), with a = b = c = 0. In height the two turns of Table 1 alone can move a "
        "point of the track by nearly as much as all errors of (6) together (0.072 mm); in the "
        "plane they act in proportion to the height over O_1, by 1.46 µm for each millimetre.",
        marks=("consequence",),
    ),
    ours(
        "Consequences, first order",
        r"\tfrac12(R+A)(|\alpha|+|\beta|+|\gamma|)^2=0.000096\text{ mm}",
        PrintedNumber("0.000096", first_order_remainder(radius + amplitude).subs(PRINTED_VALUES)),
        note="At points with z_13 = 0, the shift plus the vector product of (alpha, beta, gamma) "
        "and the point gives (15) to within 0.1 µm. At these sizes neither the order of the turns "
        'nor the name "rotation vector" matters.',
        marks=("consequence",),
    ),
    ours(
        "Consequences, number of periods",
        r"\text{radius of curvature at a crest: }8.3\text{ mm for }z=7,\ 6.7\text{ mm for }"
        r"z=8;\text{ at a root for }z=7\text{: }11.0\text{ mm}",
        all_of(
            PrintedNumber("8.3", radius_of_curvature(7, sp.S.Zero)),
            PrintedNumber("6.7", radius_of_curvature(8, sp.S.Zero)),
            PrintedNumber("11.0", radius_of_curvature(7, sp.pi)),
        ),
        note="For R and A of Table 1. If (16) is the path of the centres of the balls, whose "
        "radius is 7.5 mm, a track of eight periods is undercut at its crests; one of seven is "
        "not, neither there nor at its roots.",
        marks=("consequence",),
    ),
)
