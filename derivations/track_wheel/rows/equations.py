"""Prints on errors of machining, (1)-(7), and on the frame of the part, (8)-(15)."""

import sympy as sp

from mechproof.record import *

from ..mechanics import *

LATEX_CORRECTED_GROUPS = (
    r"\Delta_\Sigma%(t)s=\frac1K\sqrt{(K_\phi\Delta_\phi%(t)s)^2"
    r"+\sum_{i=1}^{n_y}(K_{y,i}\Delta_{y,i}%(t)s)^2"
    r"+\sum_{i=1}^{n_\delta}(K_{\delta,i}\Delta_{\delta,i}%(t)s)^2"
    r"+(K_n\Delta_n%(t)s)^2+(K_u\Delta_u%(t)s)^2+(K_T\Delta_T%(t)s)^2}"
)
LATEX_GROUPS_AND_THERMAL = (LATEX_CORRECTED_GROUPS % {"t": ""}).replace(
    r"+(K_T\Delta_T)^2}", r"}+\Delta_T"
)


ERROR_ROWS = (
    PRINT.equation(
        "(1)",
        defines=(output,),
        note="Names the output and its parameters; everything that follows uses f to first order.",
    ),
    PRINT.equation("(2)", defines=(error,), note="X_0 is the nominal value of the same parameter."),
    PRINT.claim(
        "after (3), K",
        Definition(scatter, 6 * sigma / total),
        note="The ratio is printed for the inputs and read in the same way for the output; the "
        "field under the normal law is taken to be six standard deviations.",
        marks=("inferred",),
    ),
    ours(
        "after (3), K of a uniform law",
        r"K_i=\sqrt3",
        all_of(
            Equality(sp.Integral(dummy**2, (dummy, 0, offset)), offset**3 / 3),
            Equality(
                6 * sp.sqrt((half_width**3 / 3 - (-half_width) ** 3 / 3) / (2 * half_width)),
                sp.sqrt(3) * (2 * half_width),
            ),
        ),
        note="The coefficient of an error that is uniform over its tolerance, where the normal "
        "law has 1: its six standard deviations are sqrt(3) times the tolerance.",
        quantities=("error_sum", "error_sum_correlated", "error_sum_thermal"),
    ),
    PRINT.claim(
        "after (3), K for a reliability",
        Definition(scatter, 6 * sigma / (2 * half_width)),
        note="Chosen by whoever uses (3); h is half the field that the reliability requires. By "
        "the normal law K = 1 for 99.73 % and K = 3/1.96 for 95 %.",
    ),
    PRINT.equation(
        "(3)",
        derived={total: propagate(DEVIATIONS, correlations[i, j], influences[i])},
        corrected=PRINT.mend("(3)", "k", "j"),
        note="The inner sum runs over k, while its terms carry j; the list of symbols names i, j "
        "as the pair and (4) sums over j, so that j is meant.",
    ),
    ours(
        "(3), coefficients that fit together",
        r"R_{ij}=-1\ (i\ne j,\ n=3)",
        less(sp.Sum(1, (i, 1, 3)) + sum_distinct(sp.Integer(-1), i, j, sp.Integer(3)), 0),
        note="That each R_ij lies between -1 and 1 is not enough: three unit errors with all R_ij "
        "= -1 make the radicand negative. The matrix of the R_ij must be positive semidefinite.",
        quantities=("error_sum_correlated",),
    ),
    PRINT.equation(
        "(4)",
        derived={total: propagate(DEVIATIONS_T, correlations_t[i, j], influences[i])},
        note="Holds at each instant t; the left side is then a function of t, too.",
    ),
    PRINT.claim(
        "after (4), S_i = 1",
        Equality(PRINTED_5, propagate(DEVIATIONS, UNCORRELATED, influences[i])),
        readings=(
            Reading(
                "each T_i is already its share of the end value, so that S_i = 1 by choice",
                Equality(PRINTED_5, propagate(DEVIATIONS, UNCORRELATED, UNIT_INFLUENCE)),
            ),
        ),
        corrected=Correction(
            r"\Delta_\Sigma=\frac1K\sqrt{\sum_{i=1}^n(K_iS_iT_i)^2}",
            Equality(CORRECTED_5, propagate(DEVIATIONS, UNCORRELATED, influences[i])),
        ),
        note="Independence removes the terms with R_ij from (3), but leaves every S_i as it is.",
    ),
    PRINT.equation(
        "(5)",
        derived={total: propagate(DEVIATIONS, UNCORRELATED, UNIT_INFLUENCE)},
        note="True under both stated premises together: independent errors and S_i = 1.",
    ),
    PRINT.claim(
        "after (5), usual conditions",
        NotCheckable("the recommendation of [5], its correlations and sensitivities"),
        note="(5) needs independent errors, each with S_i = 1. Whether those of usual production "
        "are of this kind would have to be looked up in [5].",
    ),
    PRINT.equation(
        "(6)",
        derived={total: propagate_groups(SINGLES, mountings, elastics)},
        corrected=Correction(LATEX_CORRECTED_GROUPS % {"t": ""}),
        note="The index i is free outside the sums, and the length Delta_T is added to squares of "
        "lengths. In the corrected form each group has an index of its own and each term is a "
        "square; as in (5), every sensitivity is one. This is for a random Delta_T; a systematic "
        "one stands outside the root, as in the next row. The transcription does not say which of "
        "the two it is.",
    ),
    ours(
        "(6), systematic temperature error",
        LATEX_GROUPS_AND_THERMAL,
        derived={total: propagate_groups(SINGLES[:-1], mountings, elastics) + thermal},
        note="For a systematic Delta_T: the root of (6) ends before it, and the error is added as "
        "it is. The same goes for (7).",
    ),
    PRINT.claim(
        "after (6), shift along the axes",
        NotCheckable("how the single total of (6) becomes a shift a, b, c along three axes"),
        note="(6) and (7) give one length, without a direction; (15) takes a, b, c as given.",
    ),
    PRINT.equation(
        "(7)",
        derived={AT_TIME[total]: propagate_groups(SINGLES_T, mountings_t, elastics_t)},
        corrected=Correction(LATEX_CORRECTED_GROUPS % {"t": "(t)"}),
        note="Like (6), at each instant t; the K_i are printed without t and left so.",
    ),
)


def coordinate_row(number: str, row: int) -> Equation:
    """Return one of (9)-(11): the vector from O_1 to N along one turned axis."""
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

ROWS = (*ERROR_ROWS, *FRAME_ROWS)
