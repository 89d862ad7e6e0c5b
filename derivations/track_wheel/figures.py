"""Part three: what is said of the figures, of cutting and of what was reached by it."""

from __future__ import annotations

import sympy as sp

from mechproof.record import (
    Claim,
    Correction,
    Distinct,
    Equality,
    NotCheckable,
    Reading,
    Row,
    all_of,
    less,
    not_above,
)

from .symbols import (
    PART_POINT,
    PRINTED_15,
    PRINTED_17,
    SURFACE_POINT,
    depth,
    depth_exponent,
    error_x,
    error_y,
    feed_exponent,
    kept,
    level,
    phi,
    spread,
)


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
    """Cutting force by a power law of depth and feed, all by their values at the least depth."""
    return depth**depth_exponent * feed**feed_exponent


# A feed that goes down as the depth goes up.
LESS_FEED = depth ** (-depth_exponent / feed_exponent)


FIGURE_ROWS: tuple[Row, ...] = (
    Claim(
        "Fig. 3, values",
        r"\text{diagram of the largest values of the total error, which takes account of the shift"
        r" and the turns of the blank, calculated by the formulas given above}",
        NotCheckable("the values of Fig. 3, which are lost, and a, b, c, z, H_s"),
        note="For what the turns of Table 1 do by themselves see 'Consequences, turns alone'.",
        cites=("S6", "S47", "S48", "S65"),
    ),
    Claim(
        "Fig. 3, form and location",
        r"\text{The errors on the diagram may be regarded as deviations of form and location of"
        r" the given profile of the track}",
        Distinct(DISPLACED_DISTANCE, DISTANCE),
        readings=(
            Reading(
                "deviations of location alone: no distance between two points of the part changes",
                Equality(DISPLACED_DISTANCE, DISTANCE),
            ),
        ),
        corrected=Correction(
            r"\text{The errors on the diagram may be regarded as deviations of location of the"
            r" given profile of the track}",
            Equality(DISPLACED_DISTANCE, DISTANCE),
        ),
        note="A deviation of form changes the distance between some points of the track. By (15), "
        "shift and turn move the part as a rigid body and change none: of a combined deviation of "
        "form and location, the part of form is zero in (15), (17) and (18).",
        cites=("S49",),
    ),
    Claim(
        "Fig. 4, values",
        r"\text{graphs that characterise the influence of the error of form of the cylindrical"
        r" surface of the blank on the total error of machining}",
        NotCheckable(
            "the graphs of Fig. 4, which are lost, and how the form error leads to a, b, c"
        ),
        note="For what the form error contributes to (6) see 'Consequences, no form error'.",
        cites=("S6", "S53", "S54", "S66"),
    ),
    Claim(
        "Fig. 4, both together",
        r"\text{graph 3 shows the total (radial and tangential) errors}",
        all_of(
            Equality(RADIAL_ERROR**2 + TANGENTIAL_ERROR**2, PRINTED_17**2),
            not_above(RADIAL_ERROR**2, PRINTED_17**2),
            not_above(TANGENTIAL_ERROR**2, PRINTED_17**2),
        ),
        note="By (17) the total is the hypotenuse over the radial and the tangential error of a "
        "point, and no smaller than either.",
        marks=("inferred",),
        cites=("S54",),
    ),
    Claim(
        "before Fig. 5, considerable errors",
        r"\text{considerable errors from elastic deformations of the machine and the tool arise}",
        NotCheckable("what counts as considerable"),
        note="In Table 1 only the mounting error is larger; for their shares see 'Consequences, "
        "shares of the errors'.",
        cites=("S55",),
    ),
    Claim(
        "before Fig. 5, allowance and force",
        r"\text{With an increase of the allowance the depth and the force of cutting increase, and"
        r" correspondingly the shifts of the blank from elastic deformations}",
        NotCheckable("the law of the cutting force and the stiffness of machine and tool"),
        cites=("S55", "S56", "S57"),
    ),
    Claim(
        "before Fig. 5, feed and depth",
        r"\text{The cutting force can be stabilised by optimisation of the modes of machining. It"
        r" was proposed to reduce the feed per tooth of the cutter as the depth of cut increases}",
        all_of(
            Equality(cutting_force(LESS_FEED), sp.Integer(1)),
            less(LESS_FEED.diff(depth), sp.Integer(0)),
            less(sp.Integer(0), cutting_force(sp.Integer(1)).diff(depth)),
        ),
        note='It "can", so that one example proves it: if the force follows powers of depth and '
        "feed, a feed that falls as the depth grows keeps it as low as it is at the least depth, "
        "whereas at a constant feed it would grow. So it is reduced, too. The law of the force is "
        "not in the transcription.",
        marks=("inferred",),
        cites=("S6", "S58"),
    ),
    Claim(
        "Fig. 5, elastic deformations",
        r"\text{the elastic deformations change little, consequently the error from elastic"
        r" deformations fell ...}",
        all_of(
            Equality(deformation_range(kept * spread), kept * deformation_range(spread)),
            less(deformation_range(kept * spread), deformation_range(spread)),
        ),
        note="Compared along the profile, where the allowance is uneven: the error is the range "
        "of the deformation there, and falls in proportion as the deformation changes less. That "
        "it changes little, and how far the error fell, was read off the graphs.",
        cites=("S56", "S60"),
    ),
    Claim(
        "Fig. 5, considerably",
        r"\text{the error from elastic deformations fell considerably}",
        NotCheckable("the graphs of Fig. 5 are lost, and with them the new elastic error"),
        cites=("S59", "S60"),
    ),
    Claim(
        "Fig. 5, total",
        r"\text{the total error of machining also fell in comparison with the values on the"
        r" diagram (Fig. 3)}",
        NotCheckable("the values of Figs. 3 and 5, which are lost"),
        cites=("S61",),
    ),
    Claim(
        "conclusions, total error",
        r"\text{choosing optimal ratios of the parameters of depth of cut and feed allowed to"
        r" considerably reduce the total error of machining}",
        NotCheckable("the total after the choice, lost with Fig. 5, and a measure of considerably"),
        note="For how far the total can fall at most, by the sizes of Table 1, see 'Fig. 5, "
        "largest possible gain'.",
        cites=("S67",),
    ),
)
