"""Part one: errors of machining, the symbols of (1)-(7)."""

from __future__ import annotations

import sympy as sp

from mechproof.record import Variable

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
scatter, total, total_t, sigma = positive("K Delta_Sigma Delta_Sigma(t) sigma")
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
    Variable(n, "number of parameters", within=sp.S.Naturals, latex=("n",)),
    Variable(n_y, "number of mounting errors", within=sp.S.Naturals, latex=("n_y",)),
    Variable(n_delta, "number of elastic deformations", within=sp.S.Naturals, latex=(r"n_\delta",)),
    *coordinates(
        {
            output: (
                "output parameter",
                "Y",
            ),
            function_value: (
                "value of the function f at (X_1, ..., X_n)",
                r"f(X_1,\dots,X_i,\dots,X_n)",
            ),
            actual: (
                "real value of the i-th parameter",
                "X_i",
            ),
            nominal: (
                "nominal value of the i-th parameter",
                "X_0",
            ),
            error: (
                "absolute error of the i-th parameter",
                r"\Delta_i",
            ),
            offset: ("deviation from the middle of a tolerance",),
        }
    ),
    *coefficients(
        {
            scatter: (
                "relative-scatter coefficient of the output",
                "K",
            ),
            scatters: (
                "relative-scatter coefficients of the inputs",
                "K",
            ),
            scatters_t: (
                "relative-scatter coefficients of the inputs at time t",
                "K_#(t)",
            ),
            k_form: (
                "relative-scatter coefficient of the form error",
                r"K_\phi",
            ),
            k_mounting: (
                "relative-scatter coefficients of the mounting errors",
                "K_{y,#}",
            ),
            k_elastic: (
                "relative-scatter coefficients of the elastic deformations",
                r"K_{\delta,#}",
            ),
            k_setting: (
                "relative-scatter coefficient of the machine setting",
                "K_n",
            ),
            k_wear: (
                "relative-scatter coefficient of the tool wear",
                "K_u",
            ),
            k_thermal: (
                "relative-scatter coefficient of the temperature deformation",
                "K_T",
            ),
        }
    ),
    Variable(
        influences, "absolute sensitivities; all inputs and the output are lengths", latex=("S",)
    ),
    Variable(correlations, "correlation coefficients", within=UNIT_INTERVAL, latex=("R",)),
    Variable(
        correlations_t,
        "correlation coefficients at time t",
        within=UNIT_INTERVAL,
        latex=("R_#(t)",),
    ),
    *lengths(
        {
            total_t: ("total machining error at time t", r"\Delta_\Sigma(t)"),
            total: (
                "total machining error",
                r"\Delta_\Sigma",
            ),
            sigma: ("standard deviation of the output",),
            tolerances: (
                "tolerances",
                "T",
            ),
            tolerances_t: (
                "tolerances at time t",
                "T_#(t)",
            ),
            form: (
                "form error of the mounting surface",
                r"\Delta_\phi",
            ),
            mounting: (
                "mounting error",
                r"\Delta_y",
            ),
            elastic: (
                "error from elastic deformations",
                r"\Delta_\delta",
            ),
            setting: (
                "error of the machine setting",
                r"\Delta_n",
            ),
            wear: (
                "error from tool wear",
                r"\Delta_u",
            ),
            thermal: (
                "error from temperature deformation",
                r"\Delta_T",
            ),
            form_t: (
                "form error of the mounting surface at time t",
                r"\Delta_\phi(t)",
            ),
            mounting_t: (
                "mounting error at time t",
                r"\Delta_y(t)",
            ),
            elastic_t: (
                "error from elastic deformations at time t",
                r"\Delta_\delta(t)",
            ),
            setting_t: (
                "error of the machine setting at time t",
                r"\Delta_n(t)",
            ),
            wear_t: (
                "error from tool wear at time t",
                r"\Delta_u(t)",
            ),
            thermal_t: (
                "error from temperature deformation at time t",
                r"\Delta_T(t)",
            ),
            mountings: (
                "mounting errors",
                r"\Delta_{y,#}",
            ),
            elastics: (
                "errors from elastic deformations",
                r"\Delta_{\delta,#}",
            ),
            mountings_t: (
                "mounting errors at time t",
                r"\Delta_{y,#}(t)",
            ),
            elastics_t: (
                "errors from elastic deformations at time t",
                r"\Delta_{\delta,#}(t)",
            ),
            half_width: ("half width of a uniform law",),
            level: ("level of the elastic deformation",),
        }
    ),
    Variable(share, "temperature error / total error", within=sp.Interval.open(0, 1)),
    Variable(kept, "elastic error after / before", within=sp.Interval.Ropen(0, 1)),
    Variable(spread, "largest relative change of the deformation", within=sp.Interval.open(0, 1)),
    Variable(place, "relative change at a place / largest one", within=UNIT_INTERVAL),
    Variable(other_place, "the same at another place", within=UNIT_INTERVAL),
)
