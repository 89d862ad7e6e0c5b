"""Part one: total scatter fields, as printed in (3)-(7) and by adding variances."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from .errors import (
    elastic,
    elastics,
    form,
    form_t,
    i,
    influences,
    j,
    k_elastic,
    k_form,
    k_mounting,
    k_setting,
    k_thermal,
    k_wear,
    mounting,
    mountings,
    n,
    n_delta,
    n_y,
    scatter,
    scatters,
    scatters_t,
    setting,
    setting_t,
    thermal,
    thermal_t,
    tolerances,
    tolerances_t,
    wear,
    wear_t,
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

CORRECTED_5 = sp.sqrt(SQUARES) / scatter

CORRECTED_6 = corrected_groups(form, mountings, elastics, setting, wear, thermal)
SINGLES = ((k_form, form), (k_setting, setting), (k_wear, wear), (k_thermal, thermal))
SINGLES_T = ((k_form, form_t), (k_setting, setting_t), (k_wear, wear_t), (k_thermal, thermal_t))

FIVE_ERRORS = (form, mounting, elastic, setting, wear)
SUM_OF_SQUARES = sp.Add(*(field**2 for field in FIVE_ERRORS))
