"""What is wrong or missing in paper 5, and what it costs at the sizes of its Table 1."""

from __future__ import annotations

import sympy as sp

from mechproof.record import Cost, Finding, Follower

from .mechanics import product_of
from .symbols import (
    ANGLES,
    AT_TIME,
    ERROR_FIELDS,
    PRINTED_K,
    PRINTED_VALUES,
    THERMAL_SHARE,
    amplitude,
    elastic,
    elastics,
    elastics_t,
    form,
    gamma,
    i,
    k_elastic,
    k_form,
    k_mounting,
    k_setting,
    k_wear,
    mounting,
    mountings,
    mountings_t,
    n,
    n_delta,
    n_y,
    periods,
    radius,
    scatters,
    setting,
    wear,
)
from .table import SUM_OF_PRINTED_SQUARES, total_by_corrected_sum, total_by_printed_sum

RIGHT_TOTAL = total_by_corrected_sum(sp.Integer(1)).subs(PRINTED_VALUES)
SYSTEMATIC_TOTAL = sp.sqrt(SUM_OF_PRINTED_SQUARES) / (1 - THERMAL_SHARE)
LIKE_TABLE_1 = {symbol: PRINTED_VALUES[symbol] for symbol in (radius, amplitude, *ANGLES)}
TEN_DEGREES = {**LIKE_TABLE_1, **dict.fromkeys(ANGLES, sp.pi / 18)}

# What (7) calls the errors of (6).
RENAMED = {
    **{error: AT_TIME[error] for error in ERROR_FIELDS},
    mountings: mountings_t,
    elastics: elastics_t,
}


def own_coefficients() -> dict[sp.Expr, sp.Expr]:
    """Pair the terms of (6) that have the one index i with those of its correction."""
    singles = {form: k_form, setting: k_setting, wear: k_wear}
    groups = ((mounting, mountings, k_mounting, n_y), (elastic, elastics, k_elastic, n_delta))
    return {
        **{(scatters[i] * error) ** 2: (own * error) ** 2 for error, own in singles.items()},
        **{
            sp.Sum((scatters[i] * error) ** 2, (i, 1, n)): sp.Sum(
                (own[i] * errors[i]) ** 2, (i, 1, count)
            )
            for error, errors, own, count in groups
        },
    }


def along_y(matrix: sp.Matrix) -> sp.Expr:
    """Place along Y_0 of the track's farthest point (R + A, 0, 0) once the part is turned."""
    return (radius + amplitude) * matrix[0, 1]


def cost_of_turns(matrix: sp.Matrix) -> tuple[Cost, ...]:
    """Compare a matrix with (14) by where the farthest point goes, turns of Table 1 and of 10°."""
    right, printed = along_y(PRINTED_K), along_y(matrix)
    where = "farthest point of the track, along Y_0"
    return (
        Cost(f"{where}, turns of Table 1", LIKE_TABLE_1, "µm", 3, printed, right),
        Cost(f"{where}, three turns of 10°", TEN_DEGREES, "mm", 2, printed, right),
    )


FINDINGS = (
    Finding(
        "(3)",
        "The inner sum runs over k while its terms carry j, which nothing binds; (4) and the list "
        "of symbols have j.",
    ),
    Finding(
        "(6)",
        "The length Δ_T is added to squares of lengths, so that the total depends on the unit, "
        "and the index i of K_i is bound by nothing outside the sums. A random Δ_T belongs there "
        "squared, a systematic one outside the root.",
        costs=tuple(
            Cost(
                f"total of Table 1, all K = 1, Δ_T {kind}, reckoned in {unit}",
                {},
                "mm",
                3,
                total_by_printed_sum(length),
                right,
            )
            for kind, right in (("random", RIGHT_TOTAL), ("systematic", SYSTEMATIC_TOTAL))
            for unit, length in (("mm", sp.Integer(1)), ("µm", sp.Rational(1, 1000)))
        ),
        follows=(
            Follower("(6), Delta_T outside the root", parts=own_coefficients()),
            Follower("(7)", renamed=RENAMED),
        ),
    ),
    Finding(
        "before (14), product",
        "Multiplied in the order A B C the matrices do not give the printed K; only C B A does. "
        "A B C is turns about the fixed axes, C B A those about axes that turn with the part.",
        costs=cost_of_turns(product_of("ABC")),
        follows=(
            "before (14), axes",
            Follower("Table 1, turns about X_0 and Y_0", renamed={gamma: sp.S.Zero}),
        ),
    ),
    Finding(
        "(16) and Table 1, R",
        "R is called the radius of the circle in (16) and the mean radius of the track in Table 1. "
        "It is the middle of the extreme radii; the average over the angle is smaller.",
        costs=(
            Cost(
                "mean radius",
                {**LIKE_TABLE_1, periods: sp.S.One},
                "mm",
                3,
                names=("average over the angle", "Table 1"),
            ),
        ),
    ),
    Finding(
        "Table 1, missing data",
        "The number of periods z, the thickness H_s, the shift a, b, c and the coefficients K, "
        "K_i, S_i are not printed, so that neither the total of Table 1 nor Figs. 3 to 5 can be "
        "recomputed.",
        costs=(
            Cost(
                "total of Table 1",
                {},
                "mm",
                3,
                RIGHT_TOTAL,
                total_by_corrected_sum(sp.sqrt(3)).subs(PRINTED_VALUES),
                ("all K_i = 1 (normal laws)", "all K_i = √3 (uniform laws)"),
            ),
        ),
    ),
)
