"""Part three: prints on the track, (16)-(18), on figures, on cutting and its results."""

import sympy as sp

from mechproof.record import *

from ..mechanics import *

CURVE_ROWS = (
    PRINT.equation(
        "(16)",
        derived=dict(zip(SURFACE_POINT[:2], on_track(radius_by_sine_rule(THETA)), strict=False)),
        defines=(SURFACE_POINT[2],),
        note="Compared with the sine rule in the triangle of pole, centre and point.",
        on=Part("|A| <= R", where=(sp.Le(sp.Abs(amplitude), radius),)),
        singular=("A = R: the circle passes through the pole and the track has corners there",),
        links={3: ChainLink(note="Gives the height of the points a name.")},
    ),
    PRINT.claim(
        "(16), radius vector",
        Definition(radius_vector, printed_radius(THETA)),
        note="Explained below (16), in which the letter does not occur: it is the bracket.",
    ),
    PRINT.claim(
        "(16), shifted circle",
        Equality(
            (printed_radius(THETA) * sp.cos(THETA) - amplitude) ** 2
            + (printed_radius(THETA) * sp.sin(THETA)) ** 2,
            radius**2,
        ),
        note="The formula is that of the shifted circle, at the angle z varphi.",
    ),
    PRINT.claim(
        "(16), amplitude",
        all_of(
            Equality((printed_radius(sp.Integer(0)) - printed_radius(sp.pi)) / 2, amplitude),
            not_above(
                (radius - amplitude) ** 2,
                (amplitude + radius * sp.cos(phi)) ** 2 + (radius * sp.sin(phi)) ** 2,
            ),
            not_above(
                (amplitude + radius * sp.cos(phi)) ** 2 + (radius * sp.sin(phi)) ** 2,
                (radius + amplitude) ** 2,
            ),
        ),
        note="Seen from the pole, the points of the shifted circle lie between R - A and R + A "
        "away, and both are reached; A is half the difference.",
    ),
    PRINT.claim(
        "(16), number of periods",
        Equality(printed_radius(periods * (phi + 2 * sp.pi / periods)), radius_by_sine_rule(THETA)),
        note="The radius vector repeats after 1/z of a turn.",
    ),
    PRINT.claim(
        "(16) and Table 1, R",
        Equality((printed_radius(sp.Integer(0)) + printed_radius(sp.pi)) / 2, radius),
        note="The mean radius is taken as the middle between the largest and the smallest one.",
    ),
    PRINT.equation(
        "(17)",
        defines=(planar_error,),
        note="The position error of one point, not the scatter field that (3) to (7) call "
        "Delta_Sigma.",
    ),
    PRINT.equation("(18)", defines=(spatial_error,), note="Like (17), in space."),
)


# Figures, cutting, conclusions --------------------------------------------------------------------


def displaced(point: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
    """Place of a point of the part after the displacement, by (15)."""
    error = PRINTED_15.subs(dict(zip(SURFACE_POINT, point, strict=True)), simultaneous=True)
    return error + point


def squared_distance(vector: sp.ImmutableMatrix) -> sp.Expr:
    """Squared length of a vector between two points."""
    return sum(entry**2 for entry in vector)


DISTANCE = squared_distance(SURFACE_POINT - PART_POINT)
DISPLACED_DISTANCE = squared_distance(displaced(SURFACE_POINT) - displaced(PART_POINT))

RADIAL_ERROR = error_x * sp.cos(phi) + error_y * sp.sin(phi)
TANGENTIAL_ERROR = error_y * sp.cos(phi) - error_x * sp.sin(phi)


def deformation_range(relative_change: sp.Expr) -> sp.Expr:
    """Largest minus smallest elastic deformation along the track."""
    largest, smallest = (level * (1 + sign * relative_change) for sign in (1, -1))
    return largest - smallest


def cutting_force(feed: sp.Expr) -> sp.Expr:
    """Cutting force by a power law of depth and feed, relative to its value at the least depth."""
    return depth**depth_exponent * feed**feed_exponent


# A feed that decreases as the depth increases.
LESS_FEED = depth ** (-depth_exponent / feed_exponent)


FIGURE_ROWS = (
    PRINT.claim(
        "Fig. 3, values",
        NotCheckable("the values of Fig. 3, which are lost, and a, b, c, z, H_s"),
        note="For what the turns of Table 1 do by themselves see 'Consequences, turns alone'.",
    ),
    PRINT.claim(
        "Fig. 3, form and location",
        Distinct(DISPLACED_DISTANCE, DISTANCE),
        readings=(
            Reading(
                "deviations of location alone: no distance between two points of the part changes",
                Equality(DISPLACED_DISTANCE, DISTANCE),
            ),
        ),
        corrected=PRINT.mend(
            "Fig. 3, form and location",
            "form and location",
            "location",
            Equality(DISPLACED_DISTANCE, DISTANCE),
        ),
        note="A deviation of form changes the distance between some points of the track. By (15), "
        "shift and turn move the part as a rigid body and change none: (15), (17) and (18) "
        "contain no deviation of form.",
    ),
    PRINT.claim(
        "Fig. 4, values",
        NotCheckable(
            "the graphs of Fig. 4, which are lost, and how the form error leads to a, b, c"
        ),
        note="For what the form error contributes to (6) see 'Consequences, no form error'.",
    ),
    PRINT.claim(
        "Fig. 4, both together",
        all_of(
            Equality(RADIAL_ERROR**2 + TANGENTIAL_ERROR**2, PRINTED_17**2),
            not_above(RADIAL_ERROR**2, PRINTED_17**2),
            not_above(TANGENTIAL_ERROR**2, PRINTED_17**2),
        ),
        note="By (17) the total is the hypotenuse over the radial and the tangential error of a "
        "point, and no smaller than either.",
        marks=("inferred",),
    ),
    PRINT.claim(
        "before Fig. 5, considerable errors",
        NotCheckable("what counts as considerable"),
        note="In Table 1 only the mounting error is larger; for their shares see 'Consequences, "
        "shares of the errors'.",
    ),
    PRINT.claim(
        "before Fig. 5, allowance and force",
        NotCheckable("the law of the cutting force and the stiffness of machine and tool"),
    ),
    PRINT.claim(
        "before Fig. 5, feed and depth",
        all_of(
            Equality(cutting_force(LESS_FEED), sp.Integer(1)),
            less(LESS_FEED.diff(depth), sp.Integer(0)),
            less(sp.Integer(0), cutting_force(sp.Integer(1)).diff(depth)),
        ),
        note='It "can", so one example proves it. If the force follows powers of depth and feed, '
        "reducing the feed as the depth grows keeps the force as low as at the least depth; at a "
        "constant feed it would grow. So it is reduced, too. The law of the force is not in the "
        "transcription.",
        marks=("inferred",),
    ),
    PRINT.claim(
        "Fig. 5, elastic deformations",
        all_of(
            Equality(deformation_range(kept * spread), kept * deformation_range(spread)),
            less(deformation_range(kept * spread), deformation_range(spread)),
        ),
        note="Compared along the profile, where the allowance is uneven: the error is the range "
        "of the deformation there, and falls in proportion as the deformation changes less. That "
        "it changes little, and how far the error fell, was read off the graphs.",
    ),
    PRINT.claim(
        "Fig. 5, considerably",
        NotCheckable("the graphs of Fig. 5 are lost, and with them the new elastic error"),
    ),
    PRINT.claim("Fig. 5, total", NotCheckable("the values of Figs. 3 and 5, which are lost")),
    PRINT.claim(
        "conclusions, total error",
        NotCheckable("the total after the choice, lost with Fig. 5, and a measure of considerably"),
        note="For how far the total can fall at most, by the sizes of Table 1, see 'Fig. 5, "
        "largest possible gain'.",
    ),
)
