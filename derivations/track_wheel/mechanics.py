"""The mechanics of paper 5: sums of errors by their variances, turns of the frame, the track."""

from collections.abc import Sequence

import sympy as sp

from .symbols import *

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


MATRIX_B, MATRIX_C = see_from_turned_frame(1, beta), see_from_turned_frame(2, gamma)
IN_ORDER = tuple(enumerate(ANGLES))
TURNED_BY_ALPHA = turn_about_own_axes(IN_ORDER[:1])
TURNED_PART = turn_about_own_axes(IN_ORDER)
FROM_ORIGIN = MACHINE_POINT - SHIFT


def first_order_remainder(distance: sp.Expr) -> sp.Expr:
    """Bound what the first-order model leaves out at a point at this distance from O_1."""
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
