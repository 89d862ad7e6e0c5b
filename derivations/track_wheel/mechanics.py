"""Letters, prints and mechanics of paper 5: sums of errors, turns of the frame, the track.

Letters that the paper uses twice are kept apart: K (scatter coefficient) and the matrix K,
A (amplitude) and the matrix A, z (number of periods) and the coordinate.
"""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import sympy as sp

from mechproof.document.transcription import Transcription
from mechproof.record import LENGTH, NUMBER, Dimension, Scope, Variable

from .._metrology import POSITIVE

PRINT = Transcription(Path(__file__).with_name("paper.tex"))
UNIT_INTERVAL = sp.Interval(-1, 1)

# Errors of machining ---------------------------------------------------------------------------

output, error, n, scatter, total = PRINT.symbols("Y Delta_i n K Delta_Sigma")
ERROR_FIELDS = form, mounting, elastic, setting, wear, thermal = PRINT.symbols(
    "Delta_phi Delta_y Delta_delta Delta_n Delta_u Delta_T"
)
AT_TIME = {x: sp.Symbol(f"{x}(t)", positive=True) for x in (total, *ERROR_FIELDS)}
i, j, k, n_y, n_delta = sp.symbols("i j k n_y n_delta", integer=True, positive=True)
function_value, offset, dummy = sp.symbols("f_X x u", real=True)
sigma, half_width, level = sp.symbols("sigma h m", positive=True)
k_form, k_setting, k_wear, k_thermal = sp.symbols("K_phi K_n K_u K_T", positive=True)
share = sp.Symbol("tau", nonnegative=True)
kept, spread = sp.symbols("lambda eta", real=True)
depth, depth_exponent, feed_exponent = sp.symbols("t_c x_t y_s", positive=True)

influences = sp.IndexedBase("S_i", real=True)
correlations, correlations_t = (sp.IndexedBase(name, real=True) for name in ("R_ij", "R_ij(t)"))
# Positive in the paper; the kernels accept zeros.
tolerances = sp.IndexedBase("T_i", nonnegative=True)
scatters, scatters_t, tolerances_t, k_mounting, k_elastic = (
    sp.IndexedBase(name, positive=True) for name in ("K_i", "K_i(t)", "T_i(t)", "K_yi", "K_deltai")
)
mountings, elastics, mountings_t, elastics_t = (
    sp.IndexedBase(name, positive=True)
    for name in ("Delta_yi", "Delta_deltai", "Delta_yi(t)", "Delta_deltai(t)")
)

# The frame of the part -------------------------------------------------------------------------

ANGLES = alpha, beta, gamma = PRINT.symbols("alpha beta gamma")
SHIFT = sp.ImmutableMatrix(PRINT.symbols("a b c"))
MACHINE_POINT = sp.ImmutableMatrix(PRINT.symbols("x_0N y_0N z_0N"))
PART_POINT = sp.ImmutableMatrix(PRINT.symbols("x_1N y_1N z_1N"))
SURFACE_POINT = sp.ImmutableMatrix(PRINT.symbols("x_13 y_13 z_13"))
POSITION_ERROR = error_x, error_y, error_z = PRINT.symbols("Delta_x0 Delta_y0 Delta_z0")
ELEMENTS = sp.ImmutableMatrix(3, 3, PRINT.symbols("a_11 a_12 a_13 a_21 a_22 a_23 a_31 a_32 a_33"))
MATRIX_A, MATRIX_K = sp.MatrixSymbol("matrix_A", 3, 3), sp.MatrixSymbol("matrix_K", 3, 3)
parameter = sp.Symbol("s", real=True)
# The turns about X0, Y0 and Z0 one after the other, as quaternions over the cosines of the half
# angles: the vector v vanishes only with the turn itself, without cancellation.
HALF_TANGENTS = sp.symbols("t_alpha t_beta t_gamma", real=True)
AXIS = sp.Matrix(sp.symbols("v_x v_y v_z", real=True))
w, scale = sp.symbols("w scale", real=True)
SCALED_AXIS = sp.Matrix(sp.symbols("s_x s_y s_z", real=True))
QUATERNION = (
    sp.Quaternion(1, HALF_TANGENTS[0], 0, 0)
    * sp.Quaternion(1, 0, HALF_TANGENTS[1], 0)
    * sp.Quaternion(1, 0, 0, HALF_TANGENTS[2])
)

# The track -------------------------------------------------------------------------------------

radius, thickness, amplitude, periods, phi = PRINT.symbols("R H_s A z phi")
radius_vector, planar_error, spatial_error = PRINT.symbols("rho Delta_Sigma^XY Delta_Sigma^XYZ")
ball_radius, millimetre = sp.symbols("r_b mm", positive=True)
THETA = periods * phi
eccentricity, nearer, farther = sp.symbols("e d f", nonnegative=True)
tilt_tangent = sp.Symbol("t", positive=True)

# Meanings and prints of symbols that the block does not declare ---------------------------------

TABLES: dict[tuple[Dimension, sp.Set], dict[Any, tuple[str, ...]]] = {
    (NUMBER, sp.S.Naturals): {
        n_y: ("number of mounting errors", "n_y"),
        n_delta: ("number of elastic deformations", r"n_\delta"),
    },
    (NUMBER, POSITIVE): {
        scatters: ("relative-scatter coefficients of the inputs", "K"),
        scatters_t: ("relative-scatter coefficients of the inputs at time t", "K_#(t)"),
        k_form: ("relative-scatter coefficient of the form error", r"K_\phi"),
        k_mounting: ("relative-scatter coefficients of the mounting errors", "K_{y,#}"),
        k_elastic: ("relative-scatter coefficients of the elastic deformations", r"K_{\delta,#}"),
        k_setting: ("relative-scatter coefficient of the machine setting", "K_n"),
        k_wear: ("relative-scatter coefficient of the tool wear", "K_u"),
        k_thermal: ("relative-scatter coefficient of the temperature deformation", "K_T"),
        depth: ("depth of cut / the least one",),
        depth_exponent: ("exponent of the depth in the cutting force",),
        feed_exponent: ("exponent of the feed in the cutting force",),
    },
    (NUMBER, sp.S.Reals): {
        influences: ("absolute sensitivities; all inputs and the output are lengths", "S"),
        parameter: ("parameter of the line (s alpha, s beta, s gamma)",),
        MATRIX_K: ("matrix of the three turns",),
    },
    (NUMBER, UNIT_INTERVAL): {
        correlations: ("correlation coefficients", "R"),
        correlations_t: ("correlation coefficients at time t", "R_{#}(t)"),
    },
    (LENGTH, POSITIVE): {
        **{
            AT_TIME[v.symbol]: (f"{v.meaning} at time t", f"{v.latex[0]}(t)")
            for v in PRINT.variables
            if v.symbol in AT_TIME
        },
        sigma: ("standard deviation of the output",),
        tolerances: ("tolerances", "T"),
        tolerances_t: ("tolerances at time t", "T_#(t)"),
        mountings: ("mounting errors", r"\Delta_{y,#}"),
        elastics: ("errors from elastic deformations", r"\Delta_{\delta,#}"),
        mountings_t: ("mounting errors at time t", r"\Delta_{y,#}(t)"),
        elastics_t: ("errors from elastic deformations at time t", r"\Delta_{\delta,#}(t)"),
        half_width: ("half width of a uniform law",),
        level: ("level of the elastic deformation",),
        ball_radius: ("radius of the ball",),
        millimetre: ("the unit of length",),
    },
    (LENGTH, sp.S.Reals): {
        function_value: (
            "value of the function f at (X_1, ..., X_n)",
            r"f(X_1,\dots,X_i,\dots,X_n)",
        ),
        offset: ("deviation from the middle of a tolerance",),
    },
    (LENGTH, sp.Interval(0, sp.oo)): {
        eccentricity: ("offset of the axis",),
        nearer: ("distance of a point from the plane of the crest that rises",),
        farther: ("distance of a point from the plane of the crest that falls",),
    },
    (NUMBER, sp.Interval.Lopen(0, 1)): {tilt_tangent: ("tangent of half the tilt",)},
    (NUMBER, sp.Interval.open(0, 1)): {
        share: ("temperature error / total error",),
        spread: ("largest relative change of the deformation",),
    },
}
VARIABLES = (
    *PRINT.variables,
    *(
        Variable(symbol, meaning, dimension, within, latex=tuple(prints))
        for (dimension, within), table in TABLES.items()
        for symbol, (meaning, *prints) in table.items()
    ),
    Variable(kept, "elastic error after / before", within=sp.Interval.Ropen(0, 1)),
    Variable(MATRIX_A, "matrix of the turn by alpha", given=ELEMENTS),
    *(
        Variable(symbol, f"tangent of {angle}/2", given=sp.tan(angle / 2))
        for symbol, angle in zip(HALF_TANGENTS, ANGLES, strict=True)
    ),
    *(
        Variable(symbol, "part of the turn's quaternion", given=value)
        for symbol, value in zip((w, *AXIS), QUATERNION.args, strict=True)
    ),
    Variable(scale, "2/|quaternion|^2", given=2 / (w**2 + AXIS.dot(AXIS))),
    *(
        Variable(symbol, "part of the quaternion, times the scale", given=scale * part)
        for symbol, part in zip(SCALED_AXIS, AXIS, strict=True)
    ),
)
NOTATION = replace(
    PRINT.notation,
    indices=(i, j, k),
    scopes=(
        Scope(("(8)", "(12)", "(13)"), {"A": MATRIX_A}),
        Scope(("(14)", "(15)"), {"K": MATRIX_K}),
    ),
)
read = PRINT.reader(VARIABLES, NOTATION)
(_, PRINTED_5), (_, PRINTED_17) = map(read, ("(5)", "(17)"))
(*_, PRINTED_A), (_, PRINTED_K) = read("(8)"), read("(14)")
PRINTED_15 = read("(15)")[1].subs(MATRIX_K, PRINTED_K).doit()
PRINTED_16 = sp.ImmutableMatrix(read("(16)")[1::2])


def printed_radius(theta: sp.Expr) -> sp.Expr:
    """Return the bracket printed in (16), at theta = z varphi."""
    return (PRINTED_16[0] / sp.cos(phi)).subs(THETA, theta)


# Part one: total scatter fields, as printed in (3)-(7) and by adding variances ------------------


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


UNCORRELATED, UNIT_INFLUENCE = sp.Integer(0), sp.Integer(1)
DEVIATIONS = deviation(scatters[i], tolerances[i])
DEVIATIONS_T = deviation(scatters_t[i], tolerances_t[i])

SQUARES = sp.Sum((scatters[i] * influences[i] * tolerances[i]) ** 2, (i, 1, n))
CROSS = scatters[i] * scatters[j] * influences[i] * influences[j] * tolerances[i] * tolerances[j]

CORRECTED_5 = sp.sqrt(SQUARES) / scatter

SINGLES = ((k_form, form), (k_setting, setting), (k_wear, wear), (k_thermal, thermal))
SINGLES_T = tuple((own, AT_TIME[field]) for own, field in SINGLES)

FIVE_ERRORS = (form, mounting, elastic, setting, wear)
SUM_OF_SQUARES = sp.Add(*(field**2 for field in FIVE_ERRORS))

# Part two: the frame of the part, its turns and its shift ---------------------------------------

IDENTITY = sp.ImmutableMatrix(sp.eye(3))
UNIT_VECTORS = tuple(IDENTITY[:, axis] for axis in range(3))
Triad = Sequence[sp.ImmutableMatrix]


def turn(vector: sp.Matrix, axis: sp.Matrix, angle: sp.Expr) -> sp.Matrix:
    """Turn a vector counter-clockwise about a unit axis (the formula of Rodrigues)."""
    along = axis * axis.dot(vector)
    return vector * sp.cos(angle) + axis.cross(vector) * sp.sin(angle) + along * (1 - sp.cos(angle))


def turn_about_own_axes(angles: Sequence[tuple[int, sp.Expr]]) -> Triad:
    """Turn a triad in sequence, each time about its own axis where the last turn has left it."""
    triad = UNIT_VECTORS
    for axis, angle in angles:
        own = triad[axis]
        triad = tuple(turn(vector, own, angle).expand() for vector in triad)
    return triad


def turn_about_fixed_axes(angles: Sequence[tuple[int, sp.Expr]]) -> Triad:
    """Turn a triad in sequence, each time about an axis of the fixed frame."""
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


MATRIX_B, MATRIX_C = see_from_turned_frame(1, beta), see_from_turned_frame(2, gamma)
IN_ORDER = tuple(enumerate(ANGLES))
TURNED_BY_ALPHA = turn_about_own_axes(IN_ORDER[:1])
TURNED_PART = turn_about_own_axes(IN_ORDER)
FROM_ORIGIN = MACHINE_POINT - SHIFT


def first_order_remainder(distance: sp.Expr) -> sp.Expr:
    """Bound the part that the first-order model omits at a point at this distance from O_1."""
    return distance * sum(map(sp.Abs, ANGLES)) ** 2 / 2


def turn_by_vector() -> sp.ImmutableMatrix:
    """Coordinates after one turn by the angle |phi| about the vector phi = (alpha, beta, gamma)."""
    vector = sp.ImmutableMatrix(ANGLES)
    angle = sp.sqrt(vector.dot(vector))
    return project(tuple(turn(axis, vector / angle, angle) for axis in UNIT_VECTORS))


UNIT_QUATERNION = (
    sp.Quaternion(sp.cos(alpha / 2), sp.sin(alpha / 2), 0, 0)
    * sp.Quaternion(sp.cos(beta / 2), 0, sp.sin(beta / 2), 0)
    * sp.Quaternion(sp.cos(gamma / 2), 0, 0, sp.sin(gamma / 2))
)
FACTORS = {"A": PRINTED_A, "B": MATRIX_B, "C": MATRIX_C}


def product_of(order: Sequence[str]) -> sp.ImmutableMatrix:
    """Multiply the factors in the order written, from left to right."""
    left, middle, right = (FACTORS[name] for name in order)
    return left * middle * right


# Part three: the track and the position errors of its points ------------------------------------


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
