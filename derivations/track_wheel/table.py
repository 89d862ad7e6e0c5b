"""Part three: the data of Table 1, and what follows from them."""

from __future__ import annotations

import sympy as sp

from mechproof.record import (
    Claim,
    Completion,
    Completions,
    Conjunction,
    Datum,
    Definition,
    Distinct,
    Equality,
    PrintedNumber,
    Reading,
    Row,
)

from .._relations import less, not_above
from .mechanics import (
    FIVE_ERRORS,
    SUM_OF_SQUARES,
    first_order_remainder,
    project,
    turn_about_fixed_axes,
    turn_about_own_axes,
    turn_by_vector,
)
from .symbols import (
    MM,
    PRINT,
    PRINTED_16,
    PRINTED_K,
    PRINTED_VALUES,
    TABLE,
    THERMAL_SHARE,
    alpha,
    amplitude,
    ball_radius,
    beta,
    form,
    gamma,
    millimetre,
    mounting,
    periods,
    phi,
    radius,
    setting,
    share,
    thermal,
    total,
)

REMARKS = {
    setting: "The symbol may be misread: as transcribed it is the one used for the wear in the "
    "next line; the words say machine setting, so Delta_n of (6) is taken.",
    ball_radius: "It enters none of the printed formulas, so no printed result depends on it.",
}
SUM_OF_PRINTED_SQUARES = SUM_OF_SQUARES.subs(PRINTED_VALUES)


def crest_radius_of_curvature() -> sp.Expr:
    """Radius of curvature, in mm, of the printed track where it is farthest from the pole."""
    x, y = (c.subs(PRINTED_VALUES) for c in PRINTED_16[:2])
    (dx, dy), (ddx, ddy) = ([c.diff(phi, order).subs(phi, 0) for c in (x, y)] for order in (1, 2))
    return sp.sqrt(dx**2 + dy**2) ** 3 / (dx * ddy - dy * ddx)


# The radius of curvature at the crest exceeds the ball's radius.
FITTING_BALL = less(PRINTED_VALUES[ball_radius], crest_radius_of_curvature())


def total_by_corrected_sum(coefficient: sp.Expr) -> sp.Expr:
    """Solve the corrected (6), Delta_T being a share of the total: K = 1, equal K_i, one each."""
    return sp.sqrt(coefficient**2 * SUM_OF_SQUARES / (1 - (coefficient * share) ** 2))


def total_by_printed_sum(
    unit_of_length: sp.Expr, sum_of_squares: sp.Expr = SUM_OF_PRINTED_SQUARES
) -> sp.Expr:
    """Solve (6) as printed, all coefficients 1: Delta_T unsquared, so the unit enters."""
    linear = THERMAL_SHARE * unit_of_length
    return (linear + sp.sqrt(linear**2 + 4 * sum_of_squares)) / 2


SOLVED_TOTAL = total_by_corrected_sum(sp.Integer(1))

# Tolerances of ISO 286 for 80 to 120 mm, mm; the track is 2(R + A) = 90.5 mm wide.
IT6, IT12 = sp.Rational("0.022"), sp.Rational("0.35")


def exceeds_others(form_error: sp.Expr) -> Conjunction:
    """State that a form error exceeds each other error of Table 1 and all of them together."""
    together = SOLVED_TOTAL.subs(form, 0).subs(PRINTED_VALUES)
    others = (*(PRINTED_VALUES[other] for other in FIVE_ERRORS[1:]), together)
    return Conjunction(tuple(less(other, form_error) for other in others))


# Turns about X_0 and Y_0, as gamma = 0: with own axes and with fixed ones.
TURNS_OF_TABLE = ((0, alpha), (1, beta))
K_OF_TABLE = PRINTED_K.subs(gamma, 0)
ACROSS = sp.sin(alpha) * sp.sin(beta)
ALONG = (sp.sin(beta) * (1 - sp.cos(alpha)), sp.sin(alpha) * (1 - sp.cos(beta)))
AXES_DIFFERENCE = sp.ImmutableMatrix(
    [[0, ACROSS, ALONG[0]], [-ACROSS, 0, ALONG[1]], [ALONG[0], ALONG[1], 0]]
)
# The squared length of its product with a unit vector (cos, sin, 0) is at most this.
SQUARED_DIFFERENCE = ACROSS**2 + ALONG[0] ** 2 + ALONG[1] ** 2

# How far the turn by the vector misses the place of the point (R + A, 0, 0).
VECTOR_DIFFERENCE = (PRINTED_K - turn_by_vector())[0, :].subs(PRINTED_VALUES)
ROTATION_VECTOR_ERROR = (radius + amplitude).subs(PRINTED_VALUES) * sp.sqrt(
    VECTOR_DIFFERENCE.dot(VECTOR_DIFFERENCE)
)


TABLE_ROWS: tuple[Row, ...] = (
    *(
        Datum(
            f"Table 1, {what}",
            f"{before}{number}{unit}",
            Definition(symbol, sp.Rational(number) * (millimetre if unit == MM else 1)),
            note=REMARKS.get(symbol, ""),
            marks=("uncertain",) if symbol == setting else (),
        )
        for what, symbol, before, number, unit in TABLE
    ),
    PRINT.datum(
        "Table 1, temperature error",
        says=Definition(thermal, THERMAL_SHARE * total),
        note="The error is given by the total of which it is a part: (6) becomes an equation.",
    ),
    Claim(
        "Table 1, shift within the circle",
        r"A\le R",
        not_above(PRINTED_VALUES[amplitude], PRINTED_VALUES[radius]),
        note="Needed for the square root in (16) to be real at every angle.",
        marks=("ours",),
    ),
    Claim(
        "Table 1, total",
        r"\Delta_\Sigma^2=q+(\tau\Delta_\Sigma)^2\text{ has exactly one positive solution, }"
        r"q=\Delta_\phi^2+\Delta_y^2+\Delta_\delta^2+\Delta_n^2+\Delta_u^2",
        Conjunction(
            (
                Equality(
                    total**2 - (SUM_OF_SQUARES + (share * total) ** 2),
                    (1 - share**2) * (total - SOLVED_TOTAL) * (total + SOLVED_TOTAL),
                ),
                less(share**2, sp.Integer(1)),
                less(sp.Integer(0), SOLVED_TOTAL**2),
            )
        ),
        note="The corrected (6) with one error in each group and all coefficients 1. The other "
        "root is the negative of this one; Table 1 has the share 0.15.",
        marks=("ours",),
    ),
    Claim(
        "Table 1, share of the temperature",
        r"1/\sqrt{1-0.15^2}<1.012",
        less(1 / sp.sqrt(1 - THERMAL_SHARE**2), sp.Rational("1.012")),
        note="A temperature error of 15 % of the total raises that total by less than 1.2 %.",
        marks=("ours",),
    ),
    Claim(
        "Table 1, place of Delta_T",
        r"\text{the temperature raises the total of Table 1 by less than }2\,\%",
        Completions(
            "the kind of Delta_T",
            Completion(
                "the kind of Delta_T: random, its square inside the root of (6)",
                less(1 / sp.sqrt(1 - THERMAL_SHARE**2), sp.Rational("1.02")),
            ),
            Completion(
                "the kind of Delta_T: systematic, added outside the root of (6)",
                less(1 / (1 - THERMAL_SHARE), sp.Rational("1.02")),
            ),
        ),
        note="By 1.1 % or by 17.6 %. Printed is Delta_T inside the root without its square, which "
        "is neither.",
        marks=("ours",),
    ),
    Claim(
        "Table 1, total by each form of (6)",
        r"\Delta_\Sigma=0.0720\text{ mm},\ 0.0837\text{ mm},\ 0.178\text{ mm}",
        Conjunction(
            (
                PrintedNumber("0.0720", SOLVED_TOTAL.subs(PRINTED_VALUES)),
                PrintedNumber("0.0837", sp.sqrt(SUM_OF_PRINTED_SQUARES) / (1 - THERMAL_SHARE)),
                PrintedNumber("0.178", total_by_printed_sum(sp.Integer(1))),
            )
        ),
        note="Delta_T random, its square inside the root; systematic, outside the root; and as "
        "printed, reckoned in mm. All coefficients are 1.",
        marks=("ours",),
    ),
    Claim(
        "Table 1, unit of length in (6)",
        r"\Delta_\Sigma\text{ by (6) as printed, in mm}\ne"
        r"\Delta_\Sigma\text{ by (6) as printed, in }\mu\mathrm{m}",
        Distinct(total_by_printed_sum(sp.Integer(1)), total_by_printed_sum(sp.Rational(1, 1000))),
        note="Both totals are given in mm. With Delta_T unsquared the result depends on the unit "
        "in which Table 1 is written.",
        marks=("ours",),
    ),
    Claim(
        "Table 1, missing data",
        r"\text{not printed: }z,H_s,a,b,c,K,K_i,S_i,n",
        Completions(
            "the coefficients K_i",
            Completion(
                "all K_i = 1 (normal laws): the total is below twice the mounting error",
                less(
                    total_by_corrected_sum(sp.Integer(1)).subs(PRINTED_VALUES),
                    2 * PRINTED_VALUES[mounting],
                ),
            ),
            Completion(
                "all K_i = sqrt(3) (uniform laws): the same",
                less(
                    total_by_corrected_sum(sp.sqrt(3)).subs(PRINTED_VALUES),
                    2 * PRINTED_VALUES[mounting],
                ),
            ),
        ),
        note="Without the coefficients the total of Table 1 has no single value.",
        marks=("ours",),
    ),
    Claim(
        "Table 1, ball in the track",
        r"\text{a ball of }7.5~\mathrm{mm}\text{ fits the curvature of the track}",
        Completions(
            periods,
            Completion("one period", FITTING_BALL, sp.Integer(1)),
            Completion("twelve periods", FITTING_BALL, sp.Integer(12)),
        ),
        note="The number of periods is not printed, so the ball's radius cannot be checked "
        "against the track.",
        marks=("ours",),
    ),
    Claim(
        "Table 1, turns about X_0 and Y_0",
        r"\text{total turning angle about }X_0,\ Y_0,\ Z_0",
        Equality(project(turn_about_fixed_axes(TURNS_OF_TABLE)), K_OF_TABLE),
        readings=(
            Reading(
                "about X_0, then about the axis y_11 that this turn leaves",
                Equality(project(turn_about_own_axes(TURNS_OF_TABLE)), K_OF_TABLE),
            ),
        ),
        note="X_0, Y_0, Z_0 are the axes of the machine, which stay; the matrix (14) is that of "
        "turns about axes that turn with the part.",
    ),
    Claim(
        "Table 1, fixed or own axes",
        r"|K^Tp-K_0^Tp|<4.81\cdot10^{-5}\text{ mm},\ |p|\le R+A,\ z_{13}=0",
        Conjunction(
            (
                Equality(
                    K_OF_TABLE - project(turn_about_fixed_axes(TURNS_OF_TABLE)), AXES_DIFFERENCE
                ),
                less(
                    ((radius + amplitude) ** 2 * SQUARED_DIFFERENCE).subs(PRINTED_VALUES),
                    sp.Rational("4.81e-5") ** 2,
                ),
            )
        ),
        note="K_0 turns about the fixed axes. With the angles of Table 1, gamma = 0, it makes no "
        "difference that could be measured, whichever axes are meant.",
        marks=("ours",),
    ),
    Claim(
        "Table 1, rotation vector",
        r"|K^Tp-K_{\vec\varphi}^Tp|\approx2.4\cdot10^{-5}\text{ mm},\ p=(R+A,0,0)^T",
        PrintedNumber("0.000024", ROTATION_VECTOR_ERROR),
        note="K_phi is the one turn about the vector (alpha, beta, gamma), by the angles of Table "
        "1: where the track is farthest from its centre the difference cannot be measured.",
        marks=("ours",),
    ),
    Claim(
        "Table 1, small turns",
        r"\tfrac12(R+A)(|\alpha|+|\beta|+|\gamma|)^2<\tfrac1{100}\Delta_n",
        less(
            first_order_remainder(radius + amplitude).subs(PRINTED_VALUES),
            PRINTED_VALUES[setting] / 100,
        ),
        note="For points with z_13 = 0, at most R + A from O_1, the first-order model of (15) "
        "leaves out less than a hundredth of the smallest error of Table 1. For other points the "
        "distance from O_1 grows with the thickness H_s, which is not printed.",
        marks=("ours",),
    ),
    Claim(
        "after roughing",
        r"\text{After roughing the form tolerance can exceed all other technological errors}",
        Completions(
            "the errors after roughing",
            Completion(
                "the errors after roughing: a form error of IT12, 0.35 mm, beside the other "
                "errors of Table 1, each and together",
                exceeds_others(IT12),
            ),
            Completion(
                "the errors after roughing: a form error of IT6, 0.022 mm, beside the same",
                exceeds_others(IT6),
            ),
        ),
        note="Table 1 is of finish milling; no error after roughing is printed. The tolerances are "
        "those of ISO 286 for 80 to 120 mm.",
        marks=("inferred",),
    ),
)
