"""Paper 5: the machining error of a wheel with a multi-period track.

Part one propagates the errors of machining, (1)-(7); part two turns and shifts the frame of
the part, (8)-(15); part three is the track and what the displacement does to it, (16)-(18),
Table 1 and the figures. Rows marked `ours` are not printed in the paper.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import permutations

import sympy as sp

from mechproof.record import (
    LENGTH,
    Argument,
    Bar,
    Claim,
    Completion,
    Completions,
    Conjunction,
    Correction,
    Definition,
    Distinct,
    Equality,
    Equation,
    Form,
    Holds,
    Paper,
    Part,
    Quantity,
    Reading,
    Row,
    Variable,
    sum_distinct,
)

POSITIVE = sp.Interval.open(0, sp.oo)
UNIT_INTERVAL = sp.Interval(-1, 1)


def positive(names: str) -> tuple[sp.Symbol, ...]:
    """Positive symbols."""
    return tuple(sp.symbols(names, positive=True, seq=True))


def real(names: str) -> tuple[sp.Symbol, ...]:
    """Real symbols."""
    return tuple(sp.symbols(names, real=True, seq=True))


def positive_families(names: str) -> tuple[sp.IndexedBase, ...]:
    """Symbols with an index whose members are positive."""
    return tuple(sp.IndexedBase(name, positive=True) for name in names.split())


def lengths(meanings: dict[sp.Symbol | sp.IndexedBase, str]) -> tuple[Variable, ...]:
    """Positive lengths (errors, tolerances, radii)."""
    return tuple(Variable(s, meaning, LENGTH, POSITIVE) for s, meaning in meanings.items())


def coefficients(meanings: dict[sp.Symbol | sp.IndexedBase, str]) -> tuple[Variable, ...]:
    """Positive pure numbers."""
    return tuple(Variable(s, meaning, within=POSITIVE) for s, meaning in meanings.items())


def coordinates(meanings: dict[sp.Symbol, str]) -> tuple[Variable, ...]:
    """Lengths of either sign."""
    return tuple(Variable(s, meaning, LENGTH) for s, meaning in meanings.items())


# Part one. Errors of machining: the total scatter field, (1)-(7).

i, j, k = sp.symbols("i j k", integer=True, positive=True)
n, n_y, n_delta = sp.symbols("n n_y n_delta", integer=True, positive=True)
output, function_value, actual, nominal, error = real("Y f_X X_i X_0 Delta_i")
scatter, total, sigma = positive("K Delta_Sigma sigma")
half_width, level = positive("h m")
offset, dummy = real("x u")
influences = sp.IndexedBase("S_i", real=True)
correlations = sp.IndexedBase("R_ij", real=True)
correlations_t = sp.IndexedBase("R_ij(t)", real=True)
scatters, tolerances, scatters_t, tolerances_t = positive_families("K_i T_i K_i(t) T_i(t)")

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
(share,) = positive("tau")
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

# Part two. The frame of the part: turns and shift, (8)-(15).

alpha, beta, gamma = ANGLES = real("alpha beta gamma")
SHIFT = sp.ImmutableMatrix(real("a b c"))
MACHINE_POINT = sp.ImmutableMatrix(real("x_0N y_0N z_0N"))
PART_POINT = sp.ImmutableMatrix(real("x_1N y_1N z_1N"))
SURFACE_POINT = sp.ImmutableMatrix(real("x_13 y_13 z_13"))
ELEMENTS = sp.ImmutableMatrix(3, 3, real("a_11:14 a_21:24 a_31:34"))
(parameter,) = real("s")
ZERO_ANGLES = dict.fromkeys(ANGLES, 0)
IDENTITY = sp.ImmutableMatrix(sp.eye(3))
UNIT_VECTORS = tuple(IDENTITY[:, axis] for axis in range(3))
Triad = Sequence[sp.ImmutableMatrix]


def turn(vector: sp.Matrix, axis: sp.Matrix, angle: sp.Expr) -> sp.Matrix:
    """Turn a vector counter-clockwise about a unit axis (the formula of Rodrigues)."""
    along = axis * axis.dot(vector)
    return vector * sp.cos(angle) + axis.cross(vector) * sp.sin(angle) + along * (1 - sp.cos(angle))


def turn_about_own_axes(angles: Sequence[tuple[int, sp.Expr]]) -> Triad:
    """Turn a triad in sequence, each time about the axis where the last turn has left it."""
    triad = UNIT_VECTORS
    for axis, angle in angles:
        own = triad[axis]
        triad = tuple(turn(vector, own, angle).expand() for vector in triad)
    return triad


def turn_about_fixed_axes(angles: Sequence[tuple[int, sp.Expr]]) -> Triad:
    """Turn a triad in sequence, each time about an axis of the frame that stays."""
    triad = UNIT_VECTORS
    for axis, angle in angles:
        triad = tuple(turn(vector, UNIT_VECTORS[axis], angle).expand() for vector in triad)
    return triad


def project(triad: Triad) -> sp.ImmutableMatrix:
    """Projections of the fixed unit vectors (columns) on the axes of the triad (rows)."""
    return sp.ImmutableMatrix(3, 3, lambda row, column: triad[row].dot(UNIT_VECTORS[column]))


def see_from_turned_frame(axis: int, angle: sp.Expr) -> sp.ImmutableMatrix:
    """Coordinates in a frame turned about one axis: there the space is turned backwards."""
    seen = (turn(vector, UNIT_VECTORS[axis], -angle) for vector in UNIT_VECTORS)
    return sp.ImmutableMatrix.hstack(*seen)


def compose(triad: Triad, components: sp.Matrix) -> sp.Matrix:
    """Build the vector with the given components along the axes of the triad."""
    pairs = zip(components, triad, strict=True)
    return sum((component * axis for component, axis in pairs), sp.zeros(3, 1)).as_immutable()


def cross_product_matrix(vector: sp.Matrix) -> sp.ImmutableMatrix:
    """Return the matrix of p -> vector x p."""
    return sp.ImmutableMatrix.hstack(*(vector.cross(unit_vector) for unit_vector in UNIT_VECTORS))


PRINTED_A = sp.ImmutableMatrix(
    [
        [1, 0, 0],
        [0, sp.cos(alpha), sp.sin(alpha)],
        [0, -sp.sin(alpha), sp.cos(alpha)],
    ]
)
PRINTED_K = sp.ImmutableMatrix(
    [
        [
            sp.cos(beta) * sp.cos(gamma),
            sp.sin(alpha) * sp.sin(beta) * sp.cos(gamma) + sp.cos(alpha) * sp.sin(gamma),
            -sp.cos(alpha) * sp.sin(beta) * sp.cos(gamma) + sp.sin(alpha) * sp.sin(gamma),
        ],
        [
            -sp.cos(beta) * sp.sin(gamma),
            -sp.sin(alpha) * sp.sin(beta) * sp.sin(gamma) + sp.cos(alpha) * sp.cos(gamma),
            sp.cos(alpha) * sp.sin(beta) * sp.sin(gamma) + sp.sin(alpha) * sp.cos(gamma),
        ],
        [
            sp.sin(beta),
            -sp.sin(alpha) * sp.cos(beta),
            sp.cos(alpha) * sp.cos(beta),
        ],
    ]
)
MATRIX_B, MATRIX_C = see_from_turned_frame(1, beta), see_from_turned_frame(2, gamma)
FACTORS = {"A": PRINTED_A, "B": MATRIX_B, "C": MATRIX_C}
IN_ORDER = tuple(enumerate(ANGLES))
TURNED_BY_ALPHA = turn_about_own_axes(IN_ORDER[:1])
TURNED_PART = turn_about_own_axes(IN_ORDER)
FROM_ORIGIN = MACHINE_POINT - SHIFT
PRINTED_12 = PRINTED_A * FROM_ORIGIN
PRINTED_13 = PRINTED_A.T * PART_POINT + SHIFT
PRINTED_15 = PRINTED_K.T * SURFACE_POINT - (SURFACE_POINT - SHIFT)
GENERATORS = tuple(-cross_product_matrix(axis) for axis in UNIT_VECTORS)
ALONG_LINE = PRINTED_K.subs({angle: parameter * angle for angle in ANGLES}, simultaneous=True)


def product_of(order: Sequence[str]) -> sp.ImmutableMatrix:
    """Multiply the factors in the order written, from left to right."""
    left, middle, right = (FACTORS[name] for name in order)
    return left * middle * right


def second_derivative_along_line() -> sp.ImmutableMatrix:
    """Apply the product rule to C B A at s alpha, s beta, s gamma, with A' = alpha G_x A."""
    scaled = {angle: parameter * angle for angle in ANGLES}
    weights = [angle * g for angle, g in zip(ANGLES, GENERATORS, strict=True)]
    a, b, c = (FACTORS[name].subs(scaled, simultaneous=True) for name in "ABC")
    u, v, w = weights
    squares = c * b * u**2 * a + c * v**2 * b * a + w**2 * c * b * a
    return squares + 2 * (c * v * b * u * a + w * c * b * u * a + w * c * v * b * a)


def turn_by_vector() -> sp.ImmutableMatrix:
    """Coordinates after one turn by the angle |phi| about the vector phi = (alpha, beta, gamma)."""
    vector = sp.ImmutableMatrix(ANGLES)
    angle = sp.sqrt(vector.dot(vector))
    return project(tuple(turn(axis, vector / angle, angle) for axis in UNIT_VECTORS))


# The turns about X0, Y0 and Z0 one after the other, as quaternions over the cosines of the half
# angles: the vector v vanishes only with the turn itself, without cancellation.
HALF_TANGENTS = sp.symbols("t_alpha t_beta t_gamma", real=True)
AXIS = sp.Matrix(sp.symbols("v_x v_y v_z", real=True))
w, scale = sp.symbols("w scale", real=True)
QUATERNION = (
    sp.Quaternion(1, HALF_TANGENTS[0], 0, 0)
    * sp.Quaternion(1, 0, HALF_TANGENTS[1], 0)
    * sp.Quaternion(1, 0, 0, HALF_TANGENTS[2])
)

FRAME_VARIABLES = (
    Variable(alpha, "turn about x", sign="counter-clockwise positive"),
    Variable(beta, "turn about y", sign="counter-clockwise positive"),
    Variable(gamma, "turn about z", sign="counter-clockwise positive"),
    *coordinates({s: f"coordinate {s} of the shift vector r" for s in SHIFT}),
    *coordinates(dict.fromkeys(MACHINE_POINT, "coordinate of the point N in the machine frame")),
    *coordinates(dict.fromkeys(PART_POINT, "coordinate of the point N in the part's frame")),
    *coordinates(dict.fromkeys(SURFACE_POINT, "coordinate of a point of the machined surface")),
    *(
        Variable(symbol, f"element {symbol} of A, by (8)", given=value)
        for symbol, value in zip(ELEMENTS, PRINTED_A, strict=True)
    ),
    Variable(parameter, "parameter of the line (s alpha, s beta, s gamma)"),
    *(
        Variable(symbol, f"tangent of {angle}/2", given=sp.tan(angle / 2))
        for symbol, angle in zip(HALF_TANGENTS, (alpha, beta, gamma), strict=True)
    ),
    *(
        Variable(symbol, "part of the turn's quaternion", given=value)
        for symbol, value in zip((w, *AXIS), QUATERNION.args, strict=True)
    ),
    Variable(scale, "2/|quaternion|^2", given=2 / sp.prod(1 + t**2 for t in HALF_TANGENTS)),
)

LATEX_A = r"\begin{pmatrix}1&0&0\\0&\cos\alpha&\sin\alpha\\0&-\sin\alpha&\cos\alpha\end{pmatrix}"
LATEX_K = (
    r"\begin{pmatrix}\cos\beta\cos\gamma&\sin\alpha\sin\beta\cos\gamma+\cos\alpha\sin\gamma"
    r"&-\cos\alpha\sin\beta\cos\gamma+\sin\alpha\sin\gamma\\"
    r"-\cos\beta\sin\gamma&-\sin\alpha\sin\beta\sin\gamma+\cos\alpha\cos\gamma"
    r"&\cos\alpha\sin\beta\sin\gamma+\sin\alpha\cos\gamma\\"
    r"\sin\beta&-\sin\alpha\cos\beta&\cos\alpha\cos\beta\end{pmatrix}"
)


def coordinate_row(number: str, name: str, row: int) -> Equation:
    """One of (9)-(11): the vector from O_1 to N along one turned axis."""
    elements = [f"a_{{{row + 1}{column}}}" for column in (1, 2, 3)]
    return Equation(
        number,
        rf"{name}_{{1N}}=(x_{{0N}}-a){elements[0]}+(y_{{0N}}-b){elements[1]}"
        rf"+(z_{{0N}}-c){elements[2]}",
        Equality(
            sum(FROM_ORIGIN[column] * ELEMENTS[row, column] for column in range(3)),
            TURNED_BY_ALPHA[row].dot(FROM_ORIGIN),
        ),
        note="The elements are those of (8); the other side is the dot product with the turned "
        "unit vector.",
    )


FRAME_ROWS: tuple[Row, ...] = (
    Equation(
        "(8)",
        r"A=\begin{pmatrix}a_{11}&a_{12}&a_{13}\\a_{21}&a_{22}&a_{23}\\a_{31}&a_{32}&a_{33}"
        r"\end{pmatrix}=" + LATEX_A,
        Equality(PRINTED_A, see_from_turned_frame(0, alpha)),
        note="Rebuilt from the turn of space backwards that an observer in the turned frame sees.",
    ),
    Claim(
        "before (8), direction",
        r"\text{turning by }\alpha\text{ in the positive direction (counter-clockwise)}",
        Conjunction(
            (
                Equality(PRINTED_A, project(turn_about_fixed_axes([(0, alpha)]))),
                Distinct(PRINTED_A, project(turn_about_fixed_axes([(0, -alpha)]))),
            )
        ),
        note="The clockwise turn gives another matrix, so the printed direction is the right one.",
    ),
    Claim(
        "after (8), elements",
        r"\text{elements: the projections of the unit vectors of the axes of }x_{10}y_{10}z_{10}"
        r"\text{ on the axes of }x_{1i}y_{1i}z_{1i}",
        Equality(PRINTED_A, project(TURNED_BY_ALPHA)),
        note="Row: axis of the turned frame; column: unit vector of the frame that stays.",
    ),
    coordinate_row("(9)", "x", 0),
    coordinate_row("(10)", "y", 1),
    coordinate_row("(11)", "z", 2),
    Equation(
        "(12)",
        r"(x_{1N},y_{1N},z_{1N})^T=A\,(x_{0N}-a,\;y_{0N}-b,\;z_{0N}-c)^T",
        Equality(PRINTED_12, turn(FROM_ORIGIN, UNIT_VECTORS[0], -alpha)),
        note="Rebuilt by turning the vector from O_1 to N backwards.",
    ),
    Equation(
        "(13)",
        r"(x_{0N},y_{0N},z_{0N})^T=A^T(x_{1N},y_{1N},z_{1N})^T+(a,b,c)^T",
        Equality(PRINTED_13, SHIFT + compose(TURNED_BY_ALPHA, PART_POINT)),
        note="Rebuilt as the shift plus the components along the turned unit vectors.",
    ),
    Claim(
        "(13), inverse of (12)",
        r"A^TA\,(x_{0N}-a,\;y_{0N}-b,\;z_{0N}-c)^T+(a,b,c)^T=(x_{0N},y_{0N},z_{0N})^T",
        Equality(
            PRINTED_13.subs(dict(zip(PART_POINT, PRINTED_12, strict=True)), simultaneous=True),
            MACHINE_POINT,
        ),
        marks=("ours",),
    ),
    Claim(
        "before (14), B and C",
        r"\text{B and C can be obtained if the system is turned by }\beta\text{ about }y_{10}"
        r"\text{ and by }\gamma\text{ about }z_{10}\text{ in the positive direction}",
        Conjunction(
            (
                Equality(PRINTED_K.subs({beta: 0, gamma: 0}), see_from_turned_frame(0, alpha)),
                Equality(PRINTED_K.subs({alpha: 0, gamma: 0}), MATRIX_B),
                Equality(PRINTED_K.subs({alpha: 0, beta: 0}), MATRIX_C),
            )
        ),
        note="B and C are not printed; K with the two other angles zero shows that they are the "
        "matrices of these turns.",
    ),
    Claim(
        "before (14), axes",
        r"\text{if the system }x_{10}y_{10}z_{10}\text{ is turned by }\alpha,\beta,\gamma",
        Equality(PRINTED_K, project(turn_about_fixed_axes(IN_ORDER))),
        readings=(
            Reading(
                "each turn about an axis of the frame that the turn before has left: "
                "x10, then y11, then z12",
                Equality(PRINTED_K, project(TURNED_PART)),
            ),
            Reading(
                "about the fixed axes, but in the order z10, y10, x10",
                Equality(PRINTED_K, project(turn_about_fixed_axes(IN_ORDER[::-1]))),
            ),
        ),
        note="In the order as written, turns about the fixed axes x10, y10, z10 give A B C. The "
        "names of the frames x11..., x12..., x13... say that successive axes are meant.",
    ),
    Claim(
        "before (14), product",
        r"K\text{ may be represented by the product of the matrices }A,B,C",
        Equality(PRINTED_K, product_of("ABC")),
        readings=(
            Reading(
                "the first turn stands on the right: K = C B A",
                Equality(PRINTED_K, product_of("CBA")),
            ),
        ),
        note="Only the order C B A gives the printed K.",
    ),
    Claim(
        "before (14), other orders",
        r"K\ne ABC,\;ACB,\;BAC,\;BCA,\;CAB",
        Conjunction(
            tuple(
                Distinct(PRINTED_K, product_of(order))
                for order in permutations("ABC")
                if order != ("C", "B", "A")
            )
        ),
        marks=("ours",),
    ),
    Equation(
        "(14)",
        "K=" + LATEX_K,
        Equality(PRINTED_K, project(TURNED_PART)),
        note="Rebuilt by turning a triad about its own axes x10, y11, z12 and projecting.",
    ),
    Claim(
        "(14), rotation",
        r"KK^T=I,\ \det K=1",
        Conjunction(
            (
                Equality(PRINTED_K * PRINTED_K.T, IDENTITY),
                Equality(PRINTED_K[0, :].cross(PRINTED_K[1, :]), PRINTED_K[2, :]),
                Equality(PRINTED_K.det(), sp.Integer(1)),
            )
        ),
        note="The rows form a right-handed triad of unit vectors.",
        marks=("ours",),
    ),
    Claim(
        "frames, rotation vector",
        r"\alpha,\beta,\gamma\text{ are the coordinates of the rotation vector }\vec\varphi",
        Equality(PRINTED_K, turn_by_vector()),
        corrected=Correction(
            r"\left.\frac{d}{ds}K(s\alpha,s\beta,s\gamma)\right|_{s=0}p=-\vec\varphi\times p",
            Equality(
                ALONG_LINE.diff(parameter).subs(parameter, 0),
                -cross_product_matrix(sp.ImmutableMatrix(ANGLES)),
            ),
        ),
        note="They are the angles of three successive turns; as a rotation vector they serve to "
        "first order only.",
    ),
    Equation(
        "(15)",
        r"(\Delta x_0,\Delta y_0,\Delta z_0)^T=K^T(x_{13},y_{13},z_{13})^T"
        r"-(x_{13}-a,\;y_{13}-b,\;z_{13}-c)^T",
        Equality(PRINTED_15, SHIFT + compose(TURNED_PART, SURFACE_POINT) - SURFACE_POINT),
        note="Where the point is after the displacement minus where it should be: the same three "
        "numbers serve as coordinates in the part and as nominal place from O_1.",
    ),
    Claim(
        "(15), linear term",
        r"\left.\frac{d}{ds}(\Delta x_0,\Delta y_0,\Delta z_0)^T\right|_{s=0}=\vec\varphi\times p",
        Equality(
            (ALONG_LINE.T * SURFACE_POINT).diff(parameter).subs(parameter, 0),
            sp.ImmutableMatrix(ANGLES).cross(SURFACE_POINT),
        ),
        note="The first-order model of the position error is the shift plus this cross product.",
        marks=("ours",),
    ),
    Claim(
        "(15), derivatives of the turns",
        r"\frac{dA}{d\alpha}=G_xA,\quad\frac{dB}{d\beta}=G_yB,\quad\frac{dC}{d\gamma}=G_zC",
        Conjunction(
            tuple(
                Equality(factor.diff(angle), generator * factor)
                for factor, angle, generator in zip(
                    FACTORS.values(), ANGLES, GENERATORS, strict=True
                )
            )
        ),
        note="G_x p = p x e_x, and so on.",
        marks=("ours",),
    ),
    Claim(
        "(15), norms",
        r"G_x^TG_x=I-e_xe_x^T\ (\text{likewise }y,z),\quad A^TA=B^TB=C^TC=I",
        Conjunction(
            tuple(
                Equality(generator.T * generator, IDENTITY - axis * axis.T)
                for generator, axis in zip(GENERATORS, UNIT_VECTORS, strict=True)
            )
            + tuple(Equality(factor.T * factor, IDENTITY) for factor in FACTORS.values())
        ),
        note="So each G has the spectral norm 1 and the factors do not change a length.",
        marks=("ours",),
    ),
    Claim(
        "(15), second derivative",
        r"\frac{d^2}{ds^2}K(s\alpha,s\beta,s\gamma)=\alpha^2CBG_x^2A+\beta^2CG_y^2BA"
        r"+\gamma^2G_z^2CBA+2\alpha\beta\,CG_yBG_xA+2\alpha\gamma\,G_zCBG_xA"
        r"+2\beta\gamma\,G_zCG_yBA",
        Equality(ALONG_LINE.diff(parameter, 2), second_derivative_along_line()),
        note="By the norms of the row before, the second derivative has at most the norm "
        "(|alpha| + |beta| + |gamma|)^2. Taylor's formula with remainder then bounds what the "
        "first-order model leaves out at p by |p| (|alpha| + |beta| + |gamma|)^2 / 2.",
        marks=("ours",),
    ),
)

# Part three. The track, its position errors, Table 1 and the figures: (16)-(18).

radius, ball_radius, thickness, millimetre = positive("R r_b H_s mm")
(amplitude,) = real("A")
periods = sp.Symbol("z", integer=True, positive=True)
(phi,) = real("phi")
radius_vector, planar_error, spatial_error = positive("rho Delta_Sigma^XY Delta_Sigma^XYZ")
POSITION_ERROR = error_x, error_y, error_z = real("Delta_x0 Delta_y0 Delta_z0")

TRACK_VARIABLES = (
    *lengths(
        {
            radius: "radius of the circle in (16)",
            amplitude: "shift of the circle, amplitude of the multi-period curve",
            ball_radius: "radius of the ball",
            thickness: "thickness of the part",
            millimetre: "the unit of length",
            radius_vector: "radius vector of a point of the curve",
            planar_error: "position error in the end plane",
            spatial_error: "position error in space",
        }
    ),
    Variable(periods, "number of periods", within=sp.S.Naturals),
    Variable(phi, "polar angle", sign="counter-clockwise positive"),
    *coordinates(
        dict.fromkeys(POSITION_ERROR, "coordinate of the position error in the machine frame")
    ),
)


# Table 1, in millimetres and radians.
PRINTED_VALUES = {
    symbol: sp.Rational(printed)
    for symbol, printed in {
        form: "0.016",
        mounting: "0.05",
        elastic: "0.042",
        setting: "0.01",
        wear: "0.021",
        radius: "41.5",
        amplitude: "3.75",
        ball_radius: "7.5",
        alpha: "0.00103",
        beta: "0.00103",
        gamma: "0",
    }.items()
}
THERMAL_SHARE = sp.Rational("0.15")
SUM_OF_PRINTED_SQUARES = SUM_OF_SQUARES.subs(PRINTED_VALUES)


def printed_radius(theta: sp.Expr) -> sp.Expr:
    """Bracket printed in (16), at theta = z varphi."""
    return sp.sqrt(radius**2 - amplitude**2 * sp.sin(theta) ** 2) + amplitude * sp.cos(theta)


def radius_by_sine_rule(theta: sp.Expr) -> sp.Expr:
    """Distance from the pole to a circle whose centre is at the distance A.

    In the triangle pole, centre, point the sine rule gives the angle at the point; the two
    other sides are projected on the radius vector.
    """
    at_point = sp.asin(amplitude * sp.sin(theta) / radius)
    return amplitude * sp.cos(theta) + radius * sp.cos(at_point)


def on_track(distance: sp.Expr) -> sp.ImmutableMatrix:
    """Place a point at the polar angle and the given distance from the pole."""
    return sp.ImmutableMatrix([distance * sp.cos(phi), distance * sp.sin(phi), thickness])


def crest_radius_of_curvature(count: int) -> sp.Expr:
    """Radius of curvature, in mm, of the printed track where it is farthest from the pole."""
    x, y = (c.subs({periods: count, **PRINTED_VALUES}) for c in PRINTED_16[:2])
    (dx, dy), (ddx, ddy) = ([c.diff(phi, order).subs(phi, 0) for c in (x, y)] for order in (1, 2))
    return sp.sqrt(dx**2 + dy**2) ** 3 / (dx * ddy - dy * ddx)


def position_error_at_crest(values: dict[sp.Symbol, sp.Expr]) -> sp.Expr:
    """Position error (15) along X_0, in mm, at varphi = 0 with the turns of Table 1."""
    point = dict(zip(SURFACE_POINT, PRINTED_16.subs(phi, 0), strict=True))
    return PRINTED_15[0].subs(point).subs(PRINTED_VALUES | values)


def first_order_remainder(distance: sp.Expr) -> sp.Expr:
    """Bound of what the first-order model leaves out at a point at this distance from O_1."""
    return distance * sum(abs(PRINTED_VALUES[angle]) for angle in ANGLES) ** 2 / 2


def total_by_corrected_sum(coefficient: sp.Expr) -> sp.Expr:
    """Solve the corrected (6), Delta_T being a share of the total: K = 1, equal K_i, one each."""
    return sp.sqrt(coefficient**2 * SUM_OF_SQUARES / (1 - (coefficient * share) ** 2))


def total_by_printed_sum(unit_of_length: sp.Expr) -> sp.Expr:
    """Solve (6) as printed, all coefficients 1: Delta_T unsquared, so the unit enters."""
    linear = THERMAL_SHARE * unit_of_length
    return (linear + sp.sqrt(linear**2 + 4 * SUM_OF_SQUARES.subs(PRINTED_VALUES))) / 2


SOLVED_TOTAL = total_by_corrected_sum(sp.Integer(1))
THETA = periods * phi
PRINTED_16 = on_track(printed_radius(THETA))
PRINTED_17 = sp.sqrt(error_x**2 + error_y**2)
PRINTED_18 = sp.sqrt(error_x**2 + error_y**2 + error_z**2)
RADIAL_ERROR = error_x * sp.cos(phi) + error_y * sp.sin(phi)
TANGENTIAL_ERROR = error_y * sp.cos(phi) - error_x * sp.sin(phi)
ALONG_X_ONLY = {error_x: 1, error_y: 0}


def less(small: sp.Expr, large: sp.Expr) -> Holds:
    """`small` < `large`, left for the ladder to decide."""
    return Holds(sp.Lt(small, large, evaluate=False))


def not_above(small: sp.Expr, large: sp.Expr) -> Holds:
    """`small` <= `large`, left for the ladder to decide."""
    return Holds(sp.Le(small, large, evaluate=False))


TRACK_ROWS: tuple[Row, ...] = (
    Equation(
        "(16)",
        r"x_{13}=\left(\sqrt{R^2-A^2\sin^2(z\varphi)}+A\cos(z\varphi)\right)\cos\varphi,\ "
        r"y_{13}=(\dots)\sin\varphi,\ z_{13}=H_s",
        Equality(PRINTED_16, on_track(radius_by_sine_rule(THETA))),
        note="Rebuilt by the sine rule in the triangle of pole, centre and point.",
        singular=("A = R: the circle passes through the pole and the track has corners there",),
    ),
    Claim(
        "(16), radius vector",
        r"\rho\text{: radius vector of a point of the curve}",
        Definition(radius_vector, printed_radius(THETA)),
        note="The symbol is explained but does not occur in the printed formula; it is the "
        "bracket.",
    ),
    Claim(
        "(16), length of the radius vector",
        r"x_{13}^2+y_{13}^2=\rho^2",
        Equality(PRINTED_16[0] ** 2 + PRINTED_16[1] ** 2, printed_radius(THETA) ** 2),
        note="The bracket is the polar radius at the polar angle.",
        marks=("ours",),
    ),
    Claim(
        "(16), shifted circle",
        r"\text{by the formulas of the shifted circle}",
        Equality((PRINTED_16[0] - amplitude) ** 2 + PRINTED_16[1] ** 2, radius**2),
        readings=(
            Reading(
                "the radius vector is that of the shifted circle at the angle z varphi, laid off "
                "at the angle varphi",
                Equality(
                    (printed_radius(THETA) * sp.cos(THETA) - amplitude) ** 2
                    + (printed_radius(THETA) * sp.sin(THETA)) ** 2,
                    radius**2,
                ),
            ),
        ),
        note="The track itself is a circle only for one period, z = 1.",
    ),
    Claim(
        "(16), sign of the root",
        r"\rho>0\text{ and the other root is negative}",
        Conjunction(
            (
                Equality(
                    printed_radius(THETA) * (2 * amplitude * sp.cos(THETA) - printed_radius(THETA)),
                    amplitude**2 - radius**2,
                ),
                less(amplitude**2, radius**2),
            )
        ),
        note="The two roots of the circle's equation have a negative product while A < R, so the "
        "larger, printed one is the positive one.",
        on=Part("A < R", where=(amplitude < radius,)),
        marks=("ours",),
    ),
    Claim(
        "(16), amplitude",
        r"A\text{: shift of the circle, amplitude of the multi-period curve}",
        Conjunction(
            (
                Equality((printed_radius(sp.Integer(0)) - printed_radius(sp.pi)) / 2, amplitude),
                not_above(
                    (radius - amplitude) ** 2,
                    (amplitude + radius * sp.cos(phi)) ** 2 + (radius * sp.sin(phi)) ** 2,
                ),
                not_above(
                    (amplitude + radius * sp.cos(phi)) ** 2 + (radius * sp.sin(phi)) ** 2,
                    (radius + amplitude) ** 2,
                ),
            )
        ),
        note="Seen from the pole the points of the shifted circle lie between R - A and R + A, "
        "and both are reached; A is half of the difference.",
    ),
    Claim(
        "(16), number of periods",
        r"z\text{: number of periods}",
        Equality(printed_radius(periods * (phi + 2 * sp.pi / periods)), radius_by_sine_rule(THETA)),
        note="The radius vector repeats after 1/z of a turn.",
    ),
    Claim(
        "(16) and Table 1, R",
        r"R\text{: radius of the circle (16), mean radius of the track (Table 1)}",
        Equality(sp.Integral(printed_radius(THETA), (phi, 0, 2 * sp.pi)) / (2 * sp.pi), radius),
        readings=(
            Reading(
                "the middle between the largest and the smallest radius",
                Equality((printed_radius(sp.Integer(0)) + printed_radius(sp.pi)) / 2, radius),
            ),
        ),
        note="The radius of the circle is the middle of the extreme radii; the average of the "
        "radius over the polar angle is smaller.",
    ),
    Claim(
        "(16), average radius",
        r"\tfrac12(\rho(\theta)+\rho(\theta+\pi))=\sqrt{R^2-A^2\sin^2\theta}\le R",
        Conjunction(
            (
                Equality(
                    (printed_radius(phi) + radius_by_sine_rule(phi + sp.pi)) / 2,
                    sp.sqrt(radius**2 - amplitude**2 * sp.sin(phi) ** 2),
                ),
                not_above(radius**2 - amplitude**2 * sp.sin(phi) ** 2, radius**2),
            )
        ),
        note="Pairs of opposite phases average to at most R, so the average over the angle is "
        "below R for every A > 0.",
        marks=("ours",),
    ),
    Claim(
        "(16), enclosed area",
        r"\tfrac12\int_0^{2\pi}\rho^2\,d\varphi=\pi R^2",
        Conjunction(
            (
                Equality(
                    (printed_radius(phi) ** 2 + radius_by_sine_rule(phi + sp.pi) ** 2) / 2,
                    radius**2 + amplitude**2 * sp.cos(2 * phi),
                ),
                Equality(
                    sp.Integral(radius**2 + amplitude**2 * sp.cos(2 * dummy), (dummy, 0, phi)),
                    radius**2 * phi + amplitude**2 * sp.sin(2 * phi) / 2,
                ),
            )
        ),
        note="Over a full turn the last term vanishes: for every z the track encloses the area of "
        "the circle, and R is also the quadratic mean of the radius vector.",
        marks=("ours",),
    ),
    Equation(
        "(17)",
        r"\Delta_\Sigma^{XY}=\sqrt{\Delta x_0^2+\Delta y_0^2}",
        Definition(planar_error, PRINTED_17),
        note="The position error of one point; not the scatter field that (3)-(7) call "
        "Delta_Sigma.",
    ),
    Equation(
        "(18)",
        r"\Delta_\Sigma^{XYZ}=\sqrt{\Delta x_0^2+\Delta y_0^2+\Delta z_0^2}",
        Definition(spatial_error, PRINTED_18),
        note="As (17), in space.",
    ),
    *(
        Claim(
            f"Table 1, {what}",
            latex,
            Definition(symbol, PRINTED_VALUES[symbol] * unit_of_value),
            note=note,
            marks=marks,
        )
        for what, latex, symbol, unit_of_value, note, marks in (
            ("form error", r"\Delta_\phi=0.016~\mathrm{mm}", form, millimetre, "", ()),
            ("mounting error", r"\Delta_y=0.05~\mathrm{mm}", mounting, millimetre, "", ()),
            ("elastic error", r"\Delta_\delta=0.042~\mathrm{mm}", elastic, millimetre, "", ()),
            (
                "setting error",
                r"\Delta_u=0.01~\mathrm{mm}",
                setting,
                millimetre,
                "The symbol printed here is hard to read and is the one used for the wear in the "
                "next line; the words say machine setting, so Delta_n of (6) is taken.",
                ("uncertain",),
            ),
            ("tool wear", r"\Delta_u=0.021~\mathrm{mm}", wear, millimetre, "", ()),
            ("radius", r"R=41.5~\mathrm{mm}", radius, millimetre, "", ()),
            ("amplitude", r"A=3.75~\mathrm{mm}", amplitude, millimetre, "", ()),
            (
                "ball radius",
                r"7.5~\mathrm{mm}",
                ball_radius,
                millimetre,
                "It enters none of the printed formulas, so no printed result depends on it.",
                (),
            ),
            ("turn about X", r"\alpha=0.00103~\mathrm{rad}", alpha, sp.Integer(1), "", ()),
            ("turn about Y", r"\beta=0.00103~\mathrm{rad}", beta, sp.Integer(1), "", ()),
            ("turn about Z", r"\gamma=0", gamma, sp.Integer(1), "", ()),
        )
    ),
    Claim(
        "Table 1, temperature error",
        r"\Delta_T=0.15\,\Delta_\Sigma",
        Definition(thermal, THERMAL_SHARE * total),
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
            Completion(
                "all K_i = 1 (normal laws): the total is below twice the mounting error",
                less(
                    total_by_corrected_sum(sp.Integer(1)).subs(
                        {**PRINTED_VALUES, share: THERMAL_SHARE}
                    ),
                    2 * PRINTED_VALUES[mounting],
                ),
            ),
            Completion(
                "all K_i = sqrt(3) (uniform laws): the same",
                less(
                    total_by_corrected_sum(sp.sqrt(3)).subs(
                        {**PRINTED_VALUES, share: THERMAL_SHARE}
                    ),
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
            Completion(
                "one period: the radius of curvature at the crest exceeds the ball's radius",
                less(PRINTED_VALUES[ball_radius], crest_radius_of_curvature(1)),
            ),
            Completion(
                "twelve periods: the same",
                less(PRINTED_VALUES[ball_radius], crest_radius_of_curvature(12)),
            ),
        ),
        note="The number of periods is not printed, so the ball's radius cannot be checked "
        "against the track.",
        marks=("ours",),
    ),
    Claim(
        "Table 1, small turns",
        r"\tfrac12(R+A)(|\alpha|+|\beta|+|\gamma|)^2<\tfrac1{100}\Delta_n",
        less(
            first_order_remainder(PRINTED_VALUES[radius] + PRINTED_VALUES[amplitude]),
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
            Completion(
                "form error 0.1 mm after roughing, the other errors as in Table 1",
                Conjunction(
                    tuple(
                        less(PRINTED_VALUES[other], sp.Rational("0.1")) for other in FIVE_ERRORS[1:]
                    )
                ),
            ),
            Completion(
                "form error and the other errors as in Table 1 (finish milling)",
                Conjunction(
                    tuple(
                        less(PRINTED_VALUES[other], PRINTED_VALUES[form])
                        for other in FIVE_ERRORS[1:]
                    )
                ),
            ),
        ),
        note="No error after roughing is printed.",
    ),
    Claim(
        "Fig. 3, shift only",
        r"\alpha=\beta=\gamma=0:\ (\Delta x_0,\Delta y_0,\Delta z_0)=(a,b,c)",
        Equality(PRINTED_15.subs(ZERO_ANGLES), SHIFT),
        note="Without turns the error is the shift at every point, so the bars of the shift are "
        "|a|, |b|, |c|; their values are lost.",
        marks=("inferred",),
    ),
    Claim(
        "Fig. 3, axes, plane and space",
        r"|\Delta x_0|,|\Delta y_0|\le\Delta_\Sigma^{XY};\ "
        r"\Delta_\Sigma^{XY},|\Delta z_0|\le\Delta_\Sigma^{XYZ}",
        Conjunction(
            (
                not_above(error_x**2, PRINTED_17**2),
                not_above(error_y**2, PRINTED_17**2),
                not_above(PRINTED_17**2, PRINTED_18**2),
                not_above(error_z**2, PRINTED_18**2),
            )
        ),
        note="Stated by squares, as both sides are not negative. It holds point by point and "
        "therefore for the largest values.",
        marks=("ours",),
    ),
    Claim(
        "Fig. 3, shift and turns",
        r"\text{along }X_0\text{ the error from shift and turns exceeds that from the shift}",
        Completions(
            Completion(
                "a = 0.05 mm, H_s = 20 mm, turns of Table 1, at varphi = 0",
                less(
                    sp.Rational("0.05") ** 2,
                    position_error_at_crest(
                        {SHIFT[0]: sp.Rational("0.05"), thickness: sp.Integer(20)}
                    )
                    ** 2,
                ),
            ),
            Completion(
                "a = -0.05 mm, the rest as before",
                less(
                    sp.Rational("-0.05") ** 2,
                    position_error_at_crest(
                        {SHIFT[0]: sp.Rational("-0.05"), thickness: sp.Integer(20)}
                    )
                    ** 2,
                ),
            ),
        ),
        note="Shift and turn can add or cancel; neither the shift nor the thickness is printed.",
        marks=("ours",),
    ),
    Claim(
        "Fig. 4, both together",
        r"(\Delta x_0\cos\varphi+\Delta y_0\sin\varphi)^2"
        r"+(\Delta y_0\cos\varphi-\Delta x_0\sin\varphi)^2=(\Delta_\Sigma^{XY})^2",
        Conjunction(
            (
                Equality(RADIAL_ERROR**2 + TANGENTIAL_ERROR**2, PRINTED_17**2),
                not_above(RADIAL_ERROR**2, PRINTED_17**2),
                not_above(TANGENTIAL_ERROR**2, PRINTED_17**2),
            )
        ),
        note="Curve 3 (both together) is the hypotenuse of 1 (tangential) and 2 (radial) and lies "
        "above both.",
        marks=("inferred",),
    ),
    Claim(
        "Fig. 4, tangential and radial",
        r"\text{the radial error exceeds the tangential error}",
        Completions(
            Completion(
                "error along X_0 only, at varphi = 0",
                less(
                    (TANGENTIAL_ERROR**2).subs({phi: 0, **ALONG_X_ONLY}),
                    (RADIAL_ERROR**2).subs({phi: 0, **ALONG_X_ONLY}),
                ),
            ),
            Completion(
                "error along X_0 only, at varphi = pi/2",
                less(
                    (TANGENTIAL_ERROR**2).subs({phi: sp.pi / 2, **ALONG_X_ONLY}),
                    (RADIAL_ERROR**2).subs({phi: sp.pi / 2, **ALONG_X_ONLY}),
                ),
            ),
        ),
        note="The order of curves 1 and 2 depends on the place on the track, which is not given.",
        marks=("ours",),
    ),
    Claim(
        "Fig. 4, growth with the form error",
        r"\frac{\partial}{\partial\Delta_\phi}\Delta_\Sigma^2>0",
        less(sp.Integer(0), (CORRECTED_6**2).diff(form)),
        note="By the corrected (6) the total grows with the form error. How the shift and the "
        "turns depend on it is not printed, so the curves themselves cannot be recomputed.",
        marks=("ours",),
    ),
    Claim(
        "Fig. 5, elastic deformations",
        r"\text{the elastic deformations change little, hence their error fell considerably}",
        Completions(
            Completion(
                "change along the track: the range of the deformation falls with it",
                less(2 * kept * spread * level, 2 * spread * level),
            ),
            Completion(
                "change from the old cut to the new: the deformation itself becomes smaller",
                less(level * (1 + spread * place), level),
            ),
        ),
        note="What the deformation is compared with is not said; a small change from the old cut "
        "to the new would leave the error about as it was, and it may even grow.",
    ),
    Claim(
        "Fig. 5, total",
        r"\text{the total error fell against Fig. 3}",
        Completions(
            Completion(
                "only the elastic error falls",
                less(
                    SUM_OF_SQUARES.subs(elastic, kept * elastic) / (1 - share**2),
                    SUM_OF_SQUARES / (1 - share**2),
                ),
            ),
            Completion(
                "the elastic error halves and the wear rises to 0.05 mm, the rest as in Table 1",
                less(
                    SUM_OF_SQUARES.subs(
                        {elastic: PRINTED_VALUES[elastic] / 2, wear: sp.Rational("0.05")}
                    ).subs(PRINTED_VALUES),
                    SUM_OF_PRINTED_SQUARES,
                ),
            ),
        ),
        note="The values of both figures are lost, and what else the optimised cut changes is not "
        "said.",
    ),
    Claim(
        "Fig. 5, largest possible gain",
        r"\sqrt{(q-\Delta_\delta^2)/q}>0.8",
        less(
            sp.Rational("0.8"),
            sp.sqrt(
                (SUM_OF_PRINTED_SQUARES - PRINTED_VALUES[elastic] ** 2) / SUM_OF_PRINTED_SQUARES
            ),
        ),
        note="With the other errors of Table 1 unchanged and all coefficients 1, even a vanishing "
        "elastic error lowers the total by less than 20 %.",
        marks=("ours",),
    ),
)

# Part four. What the kernels compute.

a, b, c = SHIFT
x13, y13, z13 = SURFACE_POINT
ROTATION = sp.ImmutableDenseMatrix(
    see_from_turned_frame(2, gamma)
    * see_from_turned_frame(1, beta)
    * see_from_turned_frame(0, alpha)
)
DISPLACEMENT = sp.ImmutableDenseMatrix(ROTATION.T * SURFACE_POINT - (SURFACE_POINT - SHIFT))
FROM_IDENTITY = scale * (w * AXIS.hat() + AXIS * AXIS.T - AXIS.dot(AXIS) * IDENTITY)
BY_TANGENTS = sp.ImmutableDenseMatrix(FROM_IDENTITY * SURFACE_POINT + SHIFT)
FIRST_ORDER = sp.diff(ALONG_LINE, parameter).subs(parameter, 0)
LINEAR = sp.ImmutableDenseMatrix(FIRST_ORDER.T * SURFACE_POINT + SHIFT)

RADIUS = printed_radius(THETA)
TRACK = sp.ImmutableDenseMatrix([RADIUS * sp.cos(phi), RADIUS * sp.sin(phi), thickness])
PLANAR = sp.sqrt(error_x**2 + error_y**2)
SPATIAL = sp.sqrt(error_x**2 + error_y**2 + error_z**2)

PAIR = CROSS * correlations[i, j]
CORRELATED = sp.sqrt(sp.Sum(PAIR, (j, 1, n), (i, 1, n))) / scatter
INDEPENDENT = CORRECTED_5
SOLVED = sp.sqrt(SQUARES) / sp.sqrt(scatter**2 - (k_thermal * share) ** 2)

SHIFTED_INSIDE = Part(
    "|A| <= R, A of either sign", {amplitude: sp.S.Reals}, (sp.Abs(amplitude) <= radius,)
)
NONNEGATIVE = sp.Interval(0, sp.oo)
ANY_TOLERANCES = Part("tolerances from zero on", {tolerances: NONNEGATIVE})
CORRELATION_MATRIX = Part(
    "a symmetric matrix with ones on its diagonal",
    {tolerances: NONNEGATIVE},
    (sp.Eq(correlations[i, i], 1), sp.Eq(correlations[i, j], correlations[j, i])),
)
SOLVABLE = Part(
    "the temperature error below the total",
    {tolerances: NONNEGATIVE, share: NONNEGATIVE},
    (k_thermal * share < scatter,),
)

ANGLE_SUM = sp.Abs(alpha) + sp.Abs(beta) + sp.Abs(gamma)
# The largest singular value of K - I, twice the sine of half the angle of the turn.
DISTANCE_FROM_IDENTITY = sp.sqrt(3 - ROTATION.trace())
LENGTHS = sp.sqrt(x13**2 + y13**2 + z13**2), sp.sqrt(a**2 + b**2 + c**2)

TURNS = Argument("angles", (alpha, beta, gamma), "turns about X0, Y0 and Z0, in this order", "rad")
POINTS = Argument("points", (x13, y13, z13), "points in the part's frame", "mm")
SHIFTS = Argument("shift", (a, b, c), "shift of the part along X0, Y0 and Z0", "mm")
ERRORS = Argument("displacement", POSITION_ERROR, "position errors along X0, Y0 and Z0", "mm")
CIRCLE = (
    Argument("phi", (phi,), "polar angle", "rad"),
    Argument("R", (radius,), "radius of the shifted circle", "mm"),
    Argument("A", (amplitude,), "shift of the circle, amplitude of the track", "mm"),
    Argument("z", (periods,), "number of periods, a natural number"),
)
TOLERANCE = Argument("tolerances", (tolerances,), "tolerances of the elementary errors", "mm")
SENSITIVITY = Argument("sensitivities", (influences,), "sensitivity of the total to each error")
SCATTER = Argument("scatters", (scatters,), "relative-scatter coefficient of each error")
CORRELATION = Argument(
    "correlation",
    (correlations,),
    "correlation matrix: symmetric, positive semi-definite, ones on its diagonal",
)
TOTAL = Argument("total_scatter", (scatter,), "relative-scatter coefficient of the total")
SHARE = Argument("thermal_share", (share,), "temperature error over total error")
THERMAL_SCATTER = Argument(
    "thermal_scatter", (k_thermal,), "relative-scatter coefficient of the temperature error"
)

# The bars, in eps, from 1/2 for an arithmetic operation and 1 for sin, cos and hypot.
# rotation: an entry is at most a product of three plus a product of two, each factor <= 1:
# (3 * 1 + 2/2) + (2 * 1 + 1/2) + 1/2.
ROTATION_ULP = 7
# displacement: the vector v of the quaternion is a sum without cancellation wherever K is near
# I, so every entry of K - I is good relative to the norm. Some 40 roundings in one direction would
# make 17 eps; the bar is 3e-15, and searches for the worst input find 2.4 eps.
DISPLACEMENT_ULP = 3e-15 * 2.0**52
# displacement_linear: two products, three sums, entries at most s: 2.5 each, norm 3 * 2.5 s.
LINEAR_ULP = 8
# radius: u 1.5, w 1.5, its root 1.25, q 3.25 relative, w/q 5.25; the rounding of z*phi 1/2.
RADIUS_ULP = 6
# track: the radius, a sine and a product.
TRACK_ULP = RADIUS_ULP + 1.5
# Sums of n <= 128 nonnegative terms: NumPy adds in 8 strands, at most 16 + 3 roundings, 9.5;
# a term 2 * 1 + 1/2; the root halves 12, then root and quotient 1 more; n <= 128.
SUM_ULP = 7
# No square and no product of three squares leaves the doubles where the factors lie in MODERATE.
MODERATE = "factors 0 or 1e-50 to 1e50 in size"
BEYOND_SQUARES = (
    "squares of tolerances, sensitivities and scatters are added: of sizes beyond 1e-50 to 1e50 "
    "they may leave the range of doubles, and the result is infinite, NaN or too small"
)
# correlated: the same for n**2 <= 128 terms of 6 roundings, and `scale` has the terms' sizes.
CORRELATED_ULP = 8
# thermal: as independent, and the root of the product of K - K_T*thermal and K + K_T*thermal, on
# the condition number of the difference.
THERMAL_ULP = 9


def running(ulp: float, value: sp.Expr) -> Bar:
    """Set a bar on |value| + |phi * d value/d phi|, which pays for the rounding of z*phi."""
    size = sp.Abs(value) + sp.Abs(phi * sp.diff(value, phi))
    return Bar(ulp, "|value| + |phi * d value/d phi|", size)


QUANTITIES = (
    Quantity(
        "rotation",
        "Compute the matrix K of the turns alpha, beta, gamma: coordinates in the part's frame.",
        tuple(
            Argument(str(angle), (angle,), f"turn about {axis}0", "rad")
            for angle, axis in zip((alpha, beta, gamma), "XYZ", strict=True)
        ),
        ROTATION,
        Form("product C*B*A", ROTATION),
        "Kapitonov, Yakubovsky 2022, equation (14)",
        bar=Bar(ROTATION_ULP, "1, per entry", sp.Integer(1)),
    ),
    Quantity(
        "displacement",
        "Compute the position errors K^T*p - (p - t) of points p, turn K and shift t.",
        (POINTS, TURNS, SHIFTS),
        DISPLACEMENT,
        Form("(K - I)^T*p + t by tangents of half angles", BY_TANGENTS, ("name_coefficients",)),
        "Kapitonov, Yakubovsky 2022, equation (15)",
        unit="mm",
        bar=Bar(
            DISPLACEMENT_ULP,
            "|K - I|*|p| + |t|, norm of the error",
            DISTANCE_FROM_IDENTITY * LENGTHS[0] + LENGTHS[1],
        ),
    ),
    Quantity(
        "displacement_linear",
        "Compute the position errors to first order in the angles.",
        (POINTS, TURNS, SHIFTS),
        DISPLACEMENT,
        Form("first order in the angles", LINEAR, bound=LENGTHS[0] * ANGLE_SUM**2 / 2),
        "linearised from Kapitonov, Yakubovsky 2022, equation (15)",
        unit="mm",
        bar=Bar(
            LINEAR_ULP,
            "(|alpha| + |beta| + |gamma|)*|p| + |t|, norm of the rounding error",
            ANGLE_SUM * LENGTHS[0] + LENGTHS[1],
        ),
    ),
    Quantity(
        "radius",
        "Compute the radius vector of the track, a shifted circle repeated z times.",
        CIRCLE,
        RADIUS,
        Form("conjugate root", RADIUS, ("conjugate_root",)),
        "Kapitonov, Yakubovsky 2022, equation (16)",
        unit="mm",
        on=SHIFTED_INSIDE,
        bar=running(RADIUS_ULP, RADIUS),
    ),
    Quantity(
        "track",
        "Compute points of the track.",
        (*CIRCLE, Argument("H", (thickness,), "thickness of the part", "mm")),
        TRACK,
        Form("conjugate root", TRACK, ("conjugate_root",)),
        "Kapitonov, Yakubovsky 2022, equation (16)",
        unit="mm",
        on=SHIFTED_INSIDE,
        bar=running(TRACK_ULP, RADIUS),
    ),
    Quantity(
        "planar_error",
        "Compute the error in the end plane X0Y0.",
        (ERRORS,),
        PLANAR,
        Form("hypot", PLANAR, ("hypotenuse",)),
        "Kapitonov, Yakubovsky 2022, equation (17)",
        unit="mm",
        bar=Bar(1),
    ),
    Quantity(
        "spatial_error",
        "Compute the error in space.",
        (ERRORS,),
        SPATIAL,
        Form("hypot", SPATIAL, ("hypotenuse",)),
        "Kapitonov, Yakubovsky 2022, equation (18)",
        unit="mm",
        bar=Bar(2),
    ),
    Quantity(
        "error_sum_correlated",
        "Compute the total error of correlated elementary errors.",
        (TOLERANCE, SENSITIVITY, SCATTER, CORRELATION, TOTAL),
        CORRELATED,
        Form("double sum", CORRELATED),
        "Kapitonov, Yakubovsky 2022, equation (3) with its indices corrected",
        unit="mm",
        on=CORRELATION_MATRIX,
        bar=Bar(
            CORRELATED_ULP,
            f"|value| + sum |terms under the root|/(K**2*|value|), n <= 11, {MODERATE}",
            CORRELATED + sp.Sum(sp.Abs(PAIR), (j, 1, n), (i, 1, n)) / (scatter**2 * CORRELATED),
        ),
        singular=(
            "where a singular correlation matrix makes the sum vanish, rounding may leave it "
            "negative and the result NaN",
            BEYOND_SQUARES,
        ),
    ),
    Quantity(
        "error_sum",
        "Compute the total error of independent elementary errors.",
        (TOLERANCE, SENSITIVITY, SCATTER, TOTAL),
        INDEPENDENT,
        Form("sum of squares", INDEPENDENT),
        "Kapitonov, Yakubovsky 2022, equation (5) with sensitivities",
        unit="mm",
        on=ANY_TOLERANCES,
        bar=Bar(SUM_ULP, f"the value, n <= 128, {MODERATE}"),
        singular=(BEYOND_SQUARES,),
    ),
    Quantity(
        "error_sum_thermal",
        "Compute the total error with a temperature error in fixed proportion to the total itself.",
        (TOLERANCE, SENSITIVITY, SCATTER, TOTAL, SHARE, THERMAL_SCATTER),
        SOLVED,
        Form("solved for the total", SOLVED, ("difference_of_squares",)),
        "Kapitonov, Yakubovsky 2022, equation (6) made homogeneous, Table 1 for the share",
        unit="mm",
        on=SOLVABLE,
        bar=Bar(
            THERMAL_ULP,
            f"the value*K/(K - K_T*thermal), n <= 128, {MODERATE}",
            SOLVED * scatter / (scatter - k_thermal * share),
        ),
        singular=(BEYOND_SQUARES,),
    ),
)

PAPER = Paper(
    system="track_wheel",
    citation="Kapitonov, Yakubovsky 2022, machining error of a wheel with a multi-period track, "
    "doi 10.24412/2079-7958-2022-1-43-52",
    variables=ERROR_VARIABLES + FRAME_VARIABLES + TRACK_VARIABLES,
    rows=ERROR_ROWS + FRAME_ROWS + TRACK_ROWS,
    quantities=QUANTITIES,
    where=(sp.Ge(radius, amplitude),),
    conventions="Lengths in mm, angles in radians, turns counter-clockwise positive. The matrices "
    "give coordinates in the turned frame. Letters that the paper uses twice are kept apart: K "
    "(scatter coefficient) and the matrix K, A (amplitude) and the matrix A, z (number of "
    "periods) and the coordinate, varphi (polar angle) and the rotation vector.",
)
