"""Part three: what is printed of the track, (16)-(18)."""

import sympy as sp

from mechproof.record import ChainLink, Definition, Equality, Part, Row, all_of, not_above

from .mechanics import on_track, radius_by_sine_rule
from .symbols import *

CURVE_ROWS: tuple[Row, ...] = (
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
