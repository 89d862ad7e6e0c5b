"""Part two: what is printed of the frame of the part, (8)-(15)."""

import sympy as sp

from mechproof.record import ChainLink, Distinct, Equality, Equation, Reading, all_of

from .mechanics import *


def coordinate_row(number: str, row: int) -> Equation:
    """One of (9)-(11): the vector from O_1 to N along one turned axis."""
    return PRINT.equation(
        number,
        derived={PART_POINT[row]: compose(UNIT_VECTORS, ELEMENTS[row, :]).dot(FROM_ORIGIN)},
        note="Compared with the dot product with a unit vector whose projections are the "
        "elements. It holds whatever they are, so that the elements that are 0 in (8) hide no "
        "wrong factor.",
        cites=("S34",),
    )


ALONG_LINE = PRINTED_K.subs({angle: parameter * angle for angle in ANGLES}, simultaneous=True)

FRAME_ROWS = (
    PRINT.equation(
        "(8)",
        links={
            2: ChainLink(
                derived=dict(zip(ELEMENTS, see_from_turned_frame(0, alpha), strict=True)),
                note="Compared with the backward turn of space that an observer in the turned "
                "frame sees.",
            )
        },
    ),
    PRINT.claim(
        "before (8), direction",
        all_of(
            Equality(PRINTED_A, project(turn_about_fixed_axes([(0, alpha)]))),
            Distinct(PRINTED_A, project(turn_about_fixed_axes([(0, -alpha)]))),
        ),
        note="A clockwise turn gives another matrix, so that the printed direction is the right "
        "one.",
    ),
    PRINT.claim(
        "after (8), elements",
        Equality(PRINTED_A, project(TURNED_BY_ALPHA)),
        note="The row is an axis of the turned frame, the column a unit vector of the fixed one.",
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
        note="Compared with the vector from O_1 to N, turned backwards.",
    ),
    PRINT.equation(
        "(13)",
        derived={
            MATRIX_A: PRINTED_A,
            **dict(zip(MACHINE_POINT, SHIFT + compose(TURNED_BY_ALPHA, PART_POINT), strict=True)),
        },
        note="Compared with the shift plus the components along the turned unit vectors.",
    ),
    PRINT.claim(
        "before (14), B and C",
        all_of(
            Equality(PRINTED_K.subs({beta: 0, gamma: 0}), see_from_turned_frame(0, alpha)),
            Equality(PRINTED_K.subs({alpha: 0, gamma: 0}), MATRIX_B),
            Equality(PRINTED_K.subs({alpha: 0, beta: 0}), MATRIX_C),
        ),
        note="The transcription does not have B and C; K with the other two angles set to zero "
        "shows that they are the matrices of these turns.",
    ),
    PRINT.claim(
        "before (14), product",
        Equality(product_of("ABC"), PRINTED_K),
        readings=(
            Reading(
                "the first turn stands on the right: K = CBA",
                all_of(
                    Equality(product_of("CBA"), PRINTED_K),
                    Equality(product_of("ABC"), project(turn_about_fixed_axes(IN_ORDER))),
                ),
            ),
        ),
        corrected=PRINT.mend(
            "before (14), product", "A,B,C", "C,B,A", Equality(product_of("CBA"), PRINTED_K)
        ),
        note="ABC is the matrix of turns about x_10, y_10 and z_10, which stay fixed.",
    ),
    PRINT.equation(
        "(14)",
        derived={MATRIX_K: project(TURNED_PART)},
        note="Compared with the projections of a triad that is turned about its own axes x_10, "
        "y_11 and z_12, as the names of the frames suggest.",
    ),
    PRINT.claim(
        "frames, any point",
        all_of(
            Equality(PRINTED_K.T * (PRINTED_K * FROM_ORIGIN) + SHIFT, MACHINE_POINT),
            Equality(PRINTED_K * PRINTED_K.T, IDENTITY),
        ),
        note="The matrix (14) gives the coordinates of every point in the part, its transpose "
        "gives them back.",
    ),
    PRINT.claim(
        "frames, rotation vector",
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
        note="They are the angles of three successive turns; they serve as a rotation vector only "
        "to first order, which with the angles of Table 1 is off by less than 0.1 µm at the "
        "distance R + A from O_1, see 'Consequences, first order'.",
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
        note="Where the point is after the displacement, minus where it should be: the same three "
        "numbers serve as its coordinates in the part and as its nominal place from O_1.",
    ),
)
