"""Part two: what is printed of the frame of the part, (8)-(15)."""

from __future__ import annotations

from itertools import permutations

import sympy as sp

from mechproof.record import (
    ChainLink,
    Claim,
    Conjunction,
    Correction,
    Distinct,
    Equality,
    Equation,
    Reading,
    Row,
)

from .mechanics import (
    FROM_ORIGIN,
    IDENTITY,
    IN_ORDER,
    MATRIX_B,
    MATRIX_C,
    TURNED_BY_ALPHA,
    TURNED_PART,
    UNIT_VECTORS,
    compose,
    cross_product_matrix,
    product_of,
    project,
    see_from_turned_frame,
    turn,
    turn_about_fixed_axes,
    turn_by_vector,
)
from .symbols import (
    ANGLES,
    ELEMENTS,
    MACHINE_POINT,
    MATRIX_A,
    MATRIX_K,
    PART_POINT,
    POSITION_ERROR,
    PRINT,
    PRINTED_15,
    PRINTED_A,
    PRINTED_K,
    SHIFT,
    SURFACE_POINT,
    alpha,
    beta,
    gamma,
    parameter,
)


def coordinate_row(number: str, row: int) -> Equation:
    """One of (9)-(11): the vector from O_1 to N along one turned axis."""
    return PRINT.equation(
        number,
        derived={PART_POINT[row]: compose(UNIT_VECTORS, ELEMENTS[row, :]).dot(FROM_ORIGIN)},
        note="The other side is the dot product with a unit vector whose projections are the "
        "elements. It holds whatever they are: those that are 0 in (8) hide no factor.",
    )


def displaced(point: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
    """Place of a point of the part after the displacement, by (15)."""
    error = PRINTED_15.subs(dict(zip(SURFACE_POINT, point, strict=True)), simultaneous=True)
    return error + point


ALONG_LINE = PRINTED_K.subs({angle: parameter * angle for angle in ANGLES}, simultaneous=True)

FRAME_ROWS: tuple[Row, ...] = (
    PRINT.equation(
        "(8)",
        links={
            2: ChainLink(
                derived=dict(zip(ELEMENTS, see_from_turned_frame(0, alpha), strict=True)),
                note="Rebuilt from the turn of space backwards that an observer in the turned "
                "frame sees.",
            )
        },
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
    coordinate_row("(9)", 0),
    coordinate_row("(10)", 1),
    coordinate_row("(11)", 2),
    PRINT.equation(
        "(12)",
        derived={
            MATRIX_A: PRINTED_A,
            **dict(zip(PART_POINT, turn(FROM_ORIGIN, UNIT_VECTORS[0], -alpha), strict=True)),
        },
        note="Rebuilt by turning the vector from O_1 to N backwards.",
    ),
    PRINT.equation(
        "(13)",
        derived={
            MATRIX_A: PRINTED_A,
            **dict(zip(MACHINE_POINT, SHIFT + compose(TURNED_BY_ALPHA, PART_POINT), strict=True)),
        },
        note="Rebuilt as the shift plus the components along the turned unit vectors.",
    ),
    Claim(
        "(13), inverse of (12)",
        r"A^TA\,(x_{0N}-a,\;y_{0N}-b,\;z_{0N}-c)^T+(a,b,c)^T=(x_{0N},y_{0N},z_{0N})^T",
        Equality(PRINTED_A.T * (PRINTED_A * FROM_ORIGIN) + SHIFT, MACHINE_POINT),
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
        Equality(project(turn_about_fixed_axes(IN_ORDER)), PRINTED_K),
        readings=(
            Reading(
                "each turn about an axis of the frame that the turn before has left: "
                "x10, then y11, then z12",
                Equality(project(TURNED_PART), PRINTED_K),
            ),
            Reading(
                "about the fixed axes, but in the order z10, y10, x10",
                Equality(project(turn_about_fixed_axes(IN_ORDER[::-1])), PRINTED_K),
            ),
        ),
        note="In the order as written, turns about the fixed axes x10, y10, z10 give A B C. The "
        "names of the frames x11..., x12..., x13... say that successive axes are meant.",
    ),
    Claim(
        "before (14), product",
        r"K\text{ may be represented by the product of the matrices }A,B,C",
        Equality(product_of("ABC"), PRINTED_K),
        readings=(
            Reading(
                "the first turn stands on the right: K = C B A",
                Equality(product_of("CBA"), PRINTED_K),
            ),
        ),
        corrected=Correction("K=CBA", Equality(product_of("CBA"), PRINTED_K)),
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
    PRINT.equation(
        "(14)",
        derived={MATRIX_K: project(TURNED_PART)},
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
        readings=(
            Reading(
                "to first order in the angles",
                Equality(
                    ALONG_LINE.diff(parameter).subs(parameter, 0),
                    -cross_product_matrix(sp.ImmutableMatrix(ANGLES)),
                ),
            ),
        ),
        note="They are the angles of three successive turns; as a rotation vector they serve to "
        "first order, which with the angles of Table 1 is wrong by 2.4e-5 mm at the distance R + A "
        "from O_1: see Table 1, rotation vector.",
    ),
    PRINT.equation(
        "(15)",
        derived={
            MATRIX_K: PRINTED_K,
            **dict(
                zip(
                    POSITION_ERROR,
                    SHIFT + compose(TURNED_PART, SURFACE_POINT) - SURFACE_POINT,
                    strict=True,
                )
            ),
        },
        note="Where the point is after the displacement minus where it should be: the same three "
        "numbers serve as coordinates in the part and as nominal place from O_1.",
    ),
    Claim(
        "(15), rigid motion",
        r"|p'-q'|=|p-q|,\ p'=K^Tp+(a,b,c)^T",
        Equality(
            sum(entry**2 for entry in displaced(SURFACE_POINT) - displaced(PART_POINT)),
            sum(entry**2 for entry in SURFACE_POINT - PART_POINT),
        ),
        note="All distances between points of the part stay: (15), (17) and (18) are errors of "
        "position. No deviation of form comes from them, in the plane or in space.",
        marks=("ours",),
    ),
)
