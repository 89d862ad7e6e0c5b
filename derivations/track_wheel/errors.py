"""Part one: errors of machining, the total scatter field, (1)-(7)."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from mechproof.record import (
    Claim,
    Completion,
    Completions,
    Conjunction,
    Correction,
    Definition,
    Equality,
    Equation,
    Holds,
    Row,
    Variable,
    sum_distinct,
)

from .notation import (
    UNIT_INTERVAL,
    coefficients,
    coordinates,
    lengths,
    positive,
    positive_families,
    real,
)

i, j, k = sp.symbols("i j k", integer=True, positive=True)
n, n_y, n_delta = sp.symbols("n n_y n_delta", integer=True, positive=True)
output, function_value, actual, nominal, error = real("Y f_X X_i X_0 Delta_i")
scatter, total, sigma = positive("K Delta_Sigma sigma")
half_width, level = positive("h m")
offset, dummy = real("x u")
influences = sp.IndexedBase("S_i", real=True)
correlations = sp.IndexedBase("R_ij", real=True)
correlations_t = sp.IndexedBase("R_ij(t)", real=True)
scatters, scatters_t, tolerances_t = positive_families("K_i K_i(t) T_i(t)")
# Positive in the paper; the kernels take zeros.
tolerances = sp.IndexedBase("T_i", nonnegative=True)

form, mounting, elastic, setting, wear, thermal = positive(
    "Delta_phi Delta_y Delta_delta Delta_n Delta_u Delta_T"
)
form_t, mounting_t, elastic_t, setting_t, wear_t, thermal_t = positive(
    "Delta_phi(t) Delta_y(t) Delta_delta(t) Delta_n(t) Delta_u(t) Delta_T(t)"
)
k_form, k_setting, k_wear, k_thermal = positive("K_phi K_n K_u K_T")
k_mounting, k_elastic = positive_families("K_yi K_deltai")
mountings, elastics, mountings_t, elastics_t = positive_families(
    "Delta_yi Delta_deltai Delta_yi(t) Delta_deltai(t)"
)
share = sp.Symbol("tau", nonnegative=True)
kept, spread = real("lambda eta")
place, other_place = real("v_1 v_2")

ERROR_VARIABLES = (
    Variable(n, "number of parameters", within=sp.S.Naturals),
    Variable(n_y, "number of mounting errors", within=sp.S.Naturals),
    Variable(n_delta, "number of elastic deformations", within=sp.S.Naturals),
    *coordinates(
        {
            output: "output parameter",
            function_value: "value of the function f at (X_1, ..., X_n)",
            actual: "real value of the i-th parameter",
            nominal: "nominal value of the i-th parameter",
            error: "absolute error of the i-th parameter",
            offset: "deviation from the middle of a tolerance",
        }
    ),
    *coefficients(
        {
            scatter: "relative-scatter coefficient of the output",
            scatters: "relative-scatter coefficients of the inputs",
            scatters_t: "relative-scatter coefficients of the inputs at time t",
            k_form: "relative-scatter coefficient of the form error",
            k_mounting: "relative-scatter coefficients of the mounting errors",
            k_elastic: "relative-scatter coefficients of the elastic deformations",
            k_setting: "relative-scatter coefficient of the machine setting",
            k_wear: "relative-scatter coefficient of the tool wear",
            k_thermal: "relative-scatter coefficient of the temperature deformation",
        }
    ),
    Variable(influences, "absolute sensitivities; all inputs and the output are lengths"),
    Variable(correlations, "correlation coefficients", within=UNIT_INTERVAL),
    Variable(correlations_t, "correlation coefficients at time t", within=UNIT_INTERVAL),
    *lengths(
        {
            total: "total machining error",
            sigma: "standard deviation of the output",
            tolerances: "tolerances",
            tolerances_t: "tolerances at time t",
            form: "form error of the mounting surface",
            mounting: "mounting error",
            elastic: "error from elastic deformations",
            setting: "error of the machine setting",
            wear: "error from tool wear",
            thermal: "error from temperature deformation",
            form_t: "form error of the mounting surface at time t",
            mounting_t: "mounting error at time t",
            elastic_t: "error from elastic deformations at time t",
            setting_t: "error of the machine setting at time t",
            wear_t: "error from tool wear at time t",
            thermal_t: "error from temperature deformation at time t",
            mountings: "mounting errors",
            elastics: "errors from elastic deformations",
            mountings_t: "mounting errors at time t",
            elastics_t: "errors from elastic deformations at time t",
            half_width: "half width of a uniform law",
            level: "level of the elastic deformation",
        }
    ),
    Variable(share, "temperature error / total error", within=sp.Interval.open(0, 1)),
    Variable(kept, "elastic error after / before", within=sp.Interval.Ropen(0, 1)),
    Variable(spread, "largest relative change of the deformation", within=sp.Interval.open(0, 1)),
    Variable(place, "relative change at a place / largest one", within=UNIT_INTERVAL),
    Variable(other_place, "the same at another place", within=UNIT_INTERVAL),
)


def deviation(coefficient: sp.Expr, field: sp.Expr) -> sp.Expr:
    """Return the standard deviation of an error; its coefficient is 6 sigma / field."""
    return coefficient * field / 6


def variance(term: sp.Expr, correlation: sp.Expr, count: sp.Symbol) -> sp.Expr:
    """Variance of a sum of correlated terms, by the bilinearity of the covariance.

    `term` is the standard deviation of the i-th term with the sign of its influence,
    `correlation` the coefficient of the i-th and j-th.
    """
    same = sp.KroneckerDelta(i, j)
    covariance = term * term.subs(i, j) * (same + (1 - same) * correlation)
    return sp.Sum(covariance, (i, 1, count), (j, 1, count))


def propagate(terms: sp.Expr, correlation: sp.Expr, influence: sp.Expr) -> sp.Expr:
    """Total error 6 sigma_Y / K of Y = sum S_i X_i, from the deviations of the inputs."""
    return 6 * sp.sqrt(variance(influence * terms, correlation, n)) / scatter


def propagate_groups(
    singles: Sequence[tuple[sp.Expr, sp.Expr]],
    mounting_fields: sp.IndexedBase,
    elastic_fields: sp.IndexedBase,
) -> sp.Expr:
    """Total error of independent single errors and groups of errors: variances add."""
    of_singles = sp.Add(*(deviation(*single) ** 2 for single in singles))
    of_mounting = variance(deviation(k_mounting[i], mounting_fields[i]), UNCORRELATED, n_y)
    of_elastic = variance(deviation(k_elastic[i], elastic_fields[i]), UNCORRELATED, n_delta)
    return 6 * sp.sqrt(of_singles + of_mounting + of_elastic) / scatter


def printed_groups(
    form: sp.Symbol,
    mounting: sp.Symbol,
    elastic: sp.Symbol,
    setting: sp.Symbol,
    wear: sp.Symbol,
    thermal: sp.Symbol,
) -> sp.Expr:
    """Transcribe the right side of (6) and (7)."""
    return (
        sp.sqrt(
            (scatters[i] * form) ** 2
            + sp.Sum((scatters[i] * mounting) ** 2, (i, 1, n))
            + sp.Sum((scatters[i] * elastic) ** 2, (i, 1, n))
            + (scatters[i] * setting) ** 2
            + (scatters[i] * wear) ** 2
            + thermal
        )
        / scatter
    )


def corrected_groups(
    form: sp.Symbol,
    mountings: sp.IndexedBase,
    elastics: sp.IndexedBase,
    setting: sp.Symbol,
    wear: sp.Symbol,
    thermal: sp.Symbol,
) -> sp.Expr:
    """Write (6) and (7) with an index and coefficients for each group and Delta_T squared."""
    return (
        sp.sqrt(
            (k_form * form) ** 2
            + sp.Sum((k_mounting[i] * mountings[i]) ** 2, (i, 1, n_y))
            + sp.Sum((k_elastic[i] * elastics[i]) ** 2, (i, 1, n_delta))
            + (k_setting * setting) ** 2
            + (k_wear * wear) ** 2
            + (k_thermal * thermal) ** 2
        )
        / scatter
    )


UNCORRELATED, FULLY_CORRELATED, UNIT_INFLUENCE = sp.Integer(0), sp.Integer(1), sp.Integer(1)
DEVIATIONS = deviation(scatters[i], tolerances[i])
DEVIATIONS_T = deviation(scatters_t[i], tolerances_t[i])

SQUARES = sp.Sum((scatters[i] * influences[i] * tolerances[i]) ** 2, (i, 1, n))
CROSS = scatters[i] * scatters[j] * influences[i] * influences[j] * tolerances[i] * tolerances[j]
PRINTED_3 = sp.sqrt(SQUARES + sum_distinct(CROSS * correlations[i, j], i, k, n)) / scatter
CORRECTED_3 = sp.sqrt(SQUARES + sum_distinct(CROSS * correlations[i, j], i, j, n)) / scatter

SQUARES_4 = sp.Sum((scatters_t[i] * influences[i] * tolerances_t[i]) ** 2, (i, 1, n))
CROSS_4 = (
    scatters_t[i]
    * scatters_t[j]
    * influences[i]
    * influences[j]
    * tolerances_t[i]
    * tolerances_t[j]
    * correlations_t[i, j]
)
PRINTED_4 = sp.sqrt(SQUARES_4 + sum_distinct(CROSS_4, i, j, n)) / scatter
PRINTED_5 = sp.sqrt(sp.Sum((scatters[i] * tolerances[i]) ** 2, (i, 1, n))) / scatter
CORRECTED_5 = sp.sqrt(SQUARES) / scatter

CORRECTED_6 = corrected_groups(form, mountings, elastics, setting, wear, thermal)
SINGLES = ((k_form, form), (k_setting, setting), (k_wear, wear), (k_thermal, thermal))
SINGLES_T = ((k_form, form_t), (k_setting, setting_t), (k_wear, wear_t), (k_thermal, thermal_t))

FIVE_ERRORS = (form, mounting, elastic, setting, wear)
SUM_OF_SQUARES = sp.Add(*(field**2 for field in FIVE_ERRORS))
LATEX_SUM = (
    r"\Delta_\Sigma=\frac1K\sqrt{\sum_{i=1}^n(K_iS_iT_i)^2"
    r"+\sum_{i=1}^n\sum_{%s=1,%s\ne i}^n(K_iK_jS_iS_jT_iT_jR_{ij})}"
)
LATEX_GROUPS = (
    r"\Delta_\Sigma%(t)s=\frac1K\sqrt{(K_i\Delta_\phi%(t)s)^2+\sum_{i=1}^n(K_i\Delta_y%(t)s)^2"
    r"+\sum_{i=1}^n(K_i\Delta_\delta%(t)s)^2+(K_i\Delta_n%(t)s)^2+(K_i\Delta_u%(t)s)^2"
    r"+\Delta_T%(t)s}"
)
LATEX_CORRECTED_GROUPS = (
    r"\Delta_\Sigma%(t)s=\frac1K\sqrt{(K_\phi\Delta_\phi%(t)s)^2"
    r"+\sum_{i=1}^{n_y}(K_{y,i}\Delta_{y,i}%(t)s)^2"
    r"+\sum_{i=1}^{n_\delta}(K_{\delta,i}\Delta_{\delta,i}%(t)s)^2"
    r"+(K_n\Delta_n%(t)s)^2+(K_u\Delta_u%(t)s)^2+(K_T\Delta_T%(t)s)^2}"
)

ERROR_ROWS: tuple[Row, ...] = (
    Equation(
        "(1)",
        r"Y=f(X_1,\dots,X_i,\dots,X_n)",
        Definition(output, function_value),
        note="Names the output and its parameters; everything after it uses f to first order.",
    ),
    Equation(
        "(2)",
        r"\Delta_i=(X_i-X_0)",
        Definition(error, actual - nominal),
        note="The nominal value X_0 should carry the index i, since each parameter has its own.",
    ),
    Claim(
        "after (3), K",
        r"K\text{: relative-scatter coefficient of the output; }K_i\text{: ratio of the scatter "
        r"field under the normal law to the actual field}",
        Definition(scatter, 6 * sigma / total),
        note="The ratio is printed for the inputs and read for the output likewise; the field "
        "under the normal law is taken as six standard deviations.",
        marks=("inferred",),
    ),
    Claim(
        "after (3), K of a uniform law",
        r"K_i=\sqrt3",
        Conjunction(
            (
                Equality(sp.Integral(dummy**2, (dummy, 0, offset)), offset**3 / 3),
                Equality(
                    6 * sp.sqrt((half_width**3 / 3 - (-half_width) ** 3 / 3) / (2 * half_width)),
                    sp.sqrt(3) * (2 * half_width),
                ),
            )
        ),
        note="The coefficient of an error that is uniform over its tolerance, where the normal "
        "law has 1: six standard deviations are sqrt(3) tolerances.",
        marks=("ours",),
    ),
    Equation(
        "(3)",
        LATEX_SUM % ("k", "k"),
        Equality(
            PRINTED_3,
            propagate(DEVIATIONS, correlations[i, j], influences[i]),
        ),
        corrected=Correction(
            LATEX_SUM % ("j", "j"),
            Equality(
                CORRECTED_3,
                propagate(DEVIATIONS, correlations[i, j], influences[i]),
            ),
        ),
        note="The inner sum runs over k while its terms carry j; the list of symbols names i, j "
        "as the pair and (4) sums over j, so j is meant.",
    ),
    Claim(
        "(3), coefficients that fit together",
        r"R_{ij}=-1\ (i\ne j,\ n=3)",
        Holds(
            sp.Lt(
                sp.Sum(1, (i, 1, 3)) + sum_distinct(sp.Integer(-1), i, j, sp.Integer(3)),
                0,
                evaluate=False,
            )
        ),
        note="Values between -1 and 1 are not enough: three unit errors with all R_ij = -1 make "
        "the radicand negative. The matrix of the R_ij must be positive semidefinite.",
        marks=("ours",),
    ),
    Equation(
        "(4)",
        r"\Delta_\Sigma=\frac1K\sqrt{\sum_{i=1}^n(K_i(t)S_iT_i(t))^2"
        r"+\sum_{i=1}^n\sum_{j=1,j\ne i}^n(K_i(t)K_j(t)S_iS_jT_i(t)T_j(t)R_{ij}(t))}",
        Equality(
            PRINTED_4,
            propagate(DEVIATIONS_T, correlations_t[i, j], influences[i]),
        ),
        note="Holds at each instant t; the left side is then a function of t too.",
    ),
    Claim(
        "after (4), S_i = 1",
        r"\text{If the elementary errors are independent and do not change in time, then }"
        r"S_i=1\text{ may be taken}",
        Equality(PRINTED_5, propagate(DEVIATIONS, UNCORRELATED, influences[i])),
        corrected=Correction(
            r"\Delta_\Sigma=\frac1K\sqrt{\sum_{i=1}^n(K_iS_iT_i)^2}",
            Equality(CORRECTED_5, propagate(DEVIATIONS, UNCORRELATED, influences[i])),
        ),
        note="Independence removes the correlation terms but says nothing about the "
        "sensitivities: S_i = 1 is a second, separate assumption.",
    ),
    Equation(
        "(5)",
        r"\Delta_\Sigma=\frac1K\sqrt{\sum_{i=1}^n(K_iT_i)^2}",
        Equality(PRINTED_5, propagate(DEVIATIONS, UNCORRELATED, UNIT_INFLUENCE)),
        note="True under both stated premises together: independent errors and S_i = 1.",
    ),
    Claim(
        "after (5), usual conditions",
        r"\text{(5) may be used for machining blanks on machine tools in usual production"
        r" conditions}",
        Completions(
            "the correlations under usual conditions",
            Completion(
                "usual conditions: uncorrelated errors, each with S_i = 1",
                Equality(PRINTED_5, propagate(DEVIATIONS, UNCORRELATED, UNIT_INFLUENCE)),
            ),
            Completion(
                "usual conditions: errors with one common cause, R_ij = 1, each with S_i = 1",
                Equality(PRINTED_5, propagate(DEVIATIONS, FULLY_CORRELATED, UNIT_INFLUENCE)),
            ),
        ),
        note="The paper gives neither the correlations nor the sensitivities of usual conditions.",
    ),
    Equation(
        "(6)",
        LATEX_GROUPS % {"t": ""},
        Equality(
            printed_groups(form, mounting, elastic, setting, wear, thermal),
            propagate_groups(SINGLES, mountings, elastics),
        ),
        corrected=Correction(
            LATEX_CORRECTED_GROUPS % {"t": ""},
            Equality(CORRECTED_6, propagate_groups(SINGLES, mountings, elastics)),
        ),
        note="The index i is free outside the sums, and the length Delta_T is added to squares of "
        "lengths. In the corrected form each group has its own index and each term is a square; "
        "as in (5) every sensitivity is one.",
    ),
    Equation(
        "(7)",
        LATEX_GROUPS % {"t": "(t)"},
        Equality(
            printed_groups(form_t, mounting_t, elastic_t, setting_t, wear_t, thermal_t),
            propagate_groups(SINGLES_T, mountings_t, elastics_t),
        ),
        corrected=Correction(
            LATEX_CORRECTED_GROUPS % {"t": "(t)"},
            Equality(
                corrected_groups(form_t, mountings_t, elastics_t, setting_t, wear_t, thermal_t),
                propagate_groups(SINGLES_T, mountings_t, elastics_t),
            ),
        ),
        note="As (6), at each instant t; the K_i are printed without t and kept so.",
    ),
)
