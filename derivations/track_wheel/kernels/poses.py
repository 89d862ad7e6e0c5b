"""Quantities of poses: the turn, the position errors and their first-order model."""

import itertools

import sympy as sp

from mechproof.record import *

from ..mechanics import *
from .charts import BY_PLANE, BY_SPACE, NEAR_NO_TURN, WITHIN_HALF_TURNS

a, b, c = SHIFT
turns = sp.Symbol("turns", integer=True)

ROTATION = sp.ImmutableDenseMatrix(
    see_from_turned_frame(2, gamma)
    * see_from_turned_frame(1, beta)
    * see_from_turned_frame(0, alpha)
)
DISPLACEMENT = sp.ImmutableDenseMatrix(ROTATION.T * SURFACE_POINT - (SURFACE_POINT - SHIFT))
# The vector v of the quaternion vanishes with the turn itself, and with it every entry of K - I.
# Each product of two of its parts is written in one way, so that both entries use it.
PRODUCTS = sp.Matrix(3, 3, lambda i, j: SCALED_AXIS[min(i, j)] * AXIS[max(i, j)])
SQUARES = sp.diag(*(scale * (part**2 - AXIS.dot(AXIS)) for part in AXIS))
FROM_IDENTITY = w * SCALED_AXIS.hat() + PRODUCTS - sp.diag(*PRODUCTS.diagonal()) + SQUARES
BY_TANGENTS = sp.ImmutableDenseMatrix(FROM_IDENTITY * SURFACE_POINT + SHIFT)
LINEAR = sp.ImmutableDenseMatrix(sp.ImmutableMatrix(ANGLES).cross(SURFACE_POINT) + SHIFT)
PLANAR = sp.sqrt(error_x**2 + error_y**2)
SPATIAL = sp.sqrt(error_x**2 + error_y**2 + error_z**2)

# First order in the angles. Along the line s*(alpha, beta, gamma) the model is the value at s = 0
# plus the slope there. With A' = alpha*G_x*A and so on, where G_x*p = p x e_x, the product rule
# gives the second derivative of K = C*B*A. Every G has the spectral norm 1, and A, B, C change no
# length: its norm is at most (|alpha| + |beta| + |gamma|)**2, and Taylor's formula bounds the
# omitted part at p by |p|*(|alpha| + |beta| + |gamma|)**2/2.
GENERATORS = tuple(-cross_product_matrix(axis) for axis in UNIT_VECTORS)
ALONG_LINE = {angle: parameter * angle for angle in ANGLES}


def slow_down(expression: sp.Basic) -> sp.Basic:
    """Return an expression along the line: with s times the angles."""
    return expression.subs(ALONG_LINE, simultaneous=True)


def second_derivative() -> sp.Matrix:
    """Return the second derivative of C*B*A along the line by the product rule."""
    weights = (angle * g for angle, g in zip(ANGLES, GENERATORS, strict=True))
    u, v, w = weights
    a, b, c = (slow_down(factor) for factor in FACTORS.values())
    squares = c * b * u**2 * a + c * v**2 * b * a + w**2 * c * b * a
    return squares + 2 * (c * v * b * u * a + w * c * b * u * a + w * c * v * b * a)


def by_taylor(code: EmittedForm) -> Statement:
    """State that a form is the first-order model, and all that bounds the part it omits."""
    whole = slow_down(DISPLACEMENT)
    slope = whole.diff(parameter).subs(parameter, 0)
    factors = tuple(zip(FACTORS.values(), ANGLES, GENERATORS, strict=True))
    return all_of(
        Equality(code.output(), whole.subs(parameter, 0) + slope),
        *(Equality(factor.diff(angle), g * factor) for factor, angle, g in factors),
        *(Equality(factor.T * factor, IDENTITY) for factor, _, _ in factors),
        *(
            Equality(g.T * g, IDENTITY - axis * axis.T)
            for g, axis in zip(GENERATORS, UNIT_VECTORS, strict=True)
        ),
        Equality(slow_down(ROTATION).diff(parameter, 2), second_derivative()),
    )


POINT_LENGTH = sp.sqrt(SURFACE_POINT.dot(SURFACE_POINT))
# Parts of the turn's unit quaternion: its vector is as long as the sine of half the angle.
HALF_SINES = sp.symbols("u_x u_y u_z", real=True)
DISTANCE, POINT_SIZE, SHIFT_SIZE = sp.symbols("|K-I| |p| |t|", nonnegative=True)

# Accuracy, in eps: 1/2 for an arithmetic operation, 1 for sin, cos and hypot.
# rotation: an entry is at most a product of three plus a product of two, each factor <= 1:
# (3 * 1 + 2/2) + (2 * 1 + 1/2) + 1/2.
ROTATION_ULP = 7
# displacement: v is a sum without cancellation wherever K is near I, so every entry of K - I is
# accurate relative to the norm, which is twice the sine of half the angle of the turn. Divided by
# the square of its own length, not by the product of all 1 + t**2, the quaternion may be off by a
# factor. The bound is 2e-15. The one proved for angles up to a quarter of a turn, and the worst
# error found there, are in the certificates.
DISPLACEMENT_ULP = 9
ENTRIES = Scale("the largest size of an entry", sp.Integer(1))
SIZES = Scale(
    "the sizes of turn and shift, for the norm of the error",
    DISTANCE * POINT_SIZE + SHIFT_SIZE,
    where=(
        *zip(HALF_SINES, UNIT_QUATERNION.args[1:], strict=True),
        (DISTANCE, 2 * sp.sqrt(sum(part**2 for part in HALF_SINES))),
        (POINT_SIZE, POINT_LENGTH),
        (SHIFT_SIZE, sp.sqrt(a**2 + b**2 + c**2)),
    ),
)

# Turning about two axes the other way means looking from the other side of the third one.
OTHER_SIDES = tuple(itertools.combinations(ANGLES, 2))
EITHER_WAY = tuple((error,) for error in POSITION_ERROR)

SINGULAR = (
    Singular(sp.Eq(beta, sp.pi / 2 + sp.pi * turns)),
    Singular(sp.Eq(alpha, sp.pi / 2 * turns)),
    Singular(sp.Eq(beta, sp.pi * turns)),
    Singular(sp.Eq(gamma, sp.pi / 2 * turns)),
)
POSE = (
    Argument(
        "points",
        tuple(SURFACE_POINT),
        "points in the part's frame",
        "mm",
        usual=(0, 1, 10, 50, 100, 1000),
    ),
    Argument(
        "angles",
        ANGLES,
        "turns about X0, Y0 and Z0, in this order",
        "rad",
        usual=(0, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, float(sp.pi)),
    ),
    Argument("shift", (a, b, c), "shift of the part along X0, Y0 and Z0", "mm", usual=(0, 1)),
)
ERRORS = Argument(
    "displacement", POSITION_ERROR, "position errors along X0, Y0 and Z0", "mm", usual=(0, 1e-3, 1)
)
SOURCE = "Kapitonov, Yakubovsky 2022"

QUANTITIES = (
    Quantity(
        "rotation",
        "Compute the matrix K of the turns alpha, beta, gamma: coordinates in the part's frame.",
        tuple(
            Argument(str(angle), (angle,), f"turn about {axis}0", "rad", usual=(0, float(sp.pi)))
            for angle, axis in zip(ANGLES, "XYZ", strict=True)
        ),
        ROTATION,
        (
            Form(
                "printed (14)",
                sp.ImmutableDenseMatrix(PRINTED_K),
                charts=WITHIN_HALF_TURNS,
                mirrors=OTHER_SIDES,
            ),
        ),
        f"{SOURCE}, equation (14)",
        accuracy=Accuracy(ROTATION_ULP, ENTRIES),
        singular=SINGULAR,
        workloads=(("N turns", ("alpha", "beta", "gamma")),),
    ),
    Quantity(
        "displacement",
        "Compute the position errors K^T*p - (p - t) of points p, turn K and shift t.",
        POSE,
        DISPLACEMENT,
        (
            Form(
                "(K - I)^T*p + t by tangents of half angles",
                BY_TANGENTS,
                ("name_coefficients",),
                charts=NEAR_NO_TURN,
                mirrors=OTHER_SIDES,
            ),
            Form(
                "direct (K^T - I)*p + t",
                sp.ImmutableDenseMatrix(PRINTED_15),
                key="direct",
                source=f"{SOURCE}, equation (15)",
                note="the entries of K are rounded before the ones are taken off",
            ),
            Form(
                "first order in the angles",
                LINEAR,
                key="linear",
                bound=first_order_remainder(POINT_LENGTH),
                states=by_taylor,
                note="the bound is that of the norm of the error",
            ),
        ),
        f"{SOURCE}, equation (15)",
        unit="mm",
        accuracy=Accuracy(DISPLACEMENT_ULP, SIZES),
        singular=SINGULAR,
        workloads=(("N points, one pose", ("points",)), ("N poses, one point", ("angles",))),
    ),
    Quantity(
        "planar_error",
        "Compute the error in the end plane X0Y0.",
        (ERRORS,),
        PLANAR,
        (
            Form("hypot", PLANAR, ("hypotenuse",), charts=BY_PLANE, mirrors=EITHER_WAY[:2]),
            Form("printed (17)", PLANAR, key="printed", source=f"{SOURCE}, equation (17)"),
        ),
        f"{SOURCE}, equation (17)",
        unit="mm",
        accuracy=Accuracy(1),
    ),
    Quantity(
        "spatial_error",
        "Compute the error in space.",
        (ERRORS,),
        SPATIAL,
        (
            Form("hypot", SPATIAL, ("hypotenuse",), charts=BY_SPACE, mirrors=EITHER_WAY),
            Form("printed (18)", SPATIAL, key="printed", source=f"{SOURCE}, equation (18)"),
        ),
        f"{SOURCE}, equation (18)",
        unit="mm",
        accuracy=Accuracy(2),
    ),
)
