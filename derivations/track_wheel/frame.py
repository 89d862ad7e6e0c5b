"""Part two: the frame of the part, its turns and its shift."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from mechproof.record import ANGLE, Variable

from .notation import UNIT_INTERVAL, coordinates, real

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


MATRIX_A, MATRIX_K = sp.MatrixSymbol("matrix_A", 3, 3), sp.MatrixSymbol("matrix_K", 3, 3)
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
UNIT_QUATERNION = (
    sp.Quaternion(sp.cos(alpha / 2), sp.sin(alpha / 2), 0, 0)
    * sp.Quaternion(sp.cos(beta / 2), 0, sp.sin(beta / 2), 0)
    * sp.Quaternion(sp.cos(gamma / 2), 0, 0, sp.sin(gamma / 2))
)

FRAME_VARIABLES = (
    *(
        Variable(
            angle, f"turn about {axis}", ANGLE, sign="counter-clockwise positive", latex=(latex,)
        )
        for angle, axis, latex in zip(ANGLES, "xyz", (r"\alpha", r"\beta", r"\gamma"), strict=True)
    ),
    *coordinates({s: (f"coordinate {s} of the shift vector r", str(s)) for s in SHIFT}),
    *coordinates(
        {
            symbol: (f"{meaning}, {axis}", f"{axis}_{{{index}}}")
            for point, index, meaning in (
                (MACHINE_POINT, "0N", "coordinate of the point N in the machine frame"),
                (PART_POINT, "1N", "coordinate of the point N in the part's frame"),
                (SURFACE_POINT, "13", "coordinate of a point of the machined surface"),
            )
            for symbol, axis in zip(point, "xyz", strict=True)
        }
    ),
    *(
        Variable(symbol, "element of A", within=UNIT_INTERVAL, latex=(f"a_{{{str(symbol)[2:]}}}",))
        for symbol in ELEMENTS
    ),
    Variable(MATRIX_A, "matrix of the turn by alpha", given=ELEMENTS),
    Variable(MATRIX_K, "matrix of the three turns"),
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
