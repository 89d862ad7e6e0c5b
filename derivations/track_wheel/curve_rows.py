"""Part three: what is printed of the track, (16)-(18)."""

from __future__ import annotations

import sympy as sp

from mechproof.record import (
    ChainLink,
    Claim,
    Conjunction,
    Correction,
    Definition,
    Distinct,
    Equality,
    Holds,
    Part,
    Reading,
    Row,
)

from .._relations import less, not_above
from .mechanics import on_track, radius_by_sine_rule
from .symbols import (
    PRINT,
    PRINTED_16,
    SURFACE_POINT,
    THETA,
    amplitude,
    any_radius,
    any_shift,
    dummy,
    periods,
    phi,
    planar_error,
    printed_radius,
    radius,
    radius_vector,
    spatial_error,
)


def squared_distance_from_centre(count: int) -> sp.Expr:
    """Squared distance of a point of the track with `count` periods from the circle's centre."""
    x, y = (coordinate.subs(periods, count) for coordinate in PRINTED_16[:2])
    return (x - amplitude) ** 2 + y**2


CURVE_ROWS: tuple[Row, ...] = (
    PRINT.equation(
        "(16)",
        derived=dict(zip(SURFACE_POINT[:2], on_track(radius_by_sine_rule(THETA)), strict=False)),
        defines=(SURFACE_POINT[2],),
        note="Rebuilt by the sine rule in the triangle of pole, centre and point.",
        on=Part("|A| <= R", where=(sp.Le(sp.Abs(amplitude), radius),)),
        singular=("A = R: the circle passes through the pole and the track has corners there",),
        links={3: ChainLink(note="Names the height of the points.")},
    ),
    Claim(
        "(16), a radius at every angle",
        r"R^2-A^2\sin^2(z\varphi)\ge0",
        Holds(sp.Le(any_shift**2 * sp.sin(phi) ** 2, any_radius**2)),
        holds_on=Part("|A| <= R", where=(sp.Abs(any_shift) <= any_radius,)),
        note="Not printed, and needed for the root in (16): where this paper's rows are decided.",
        marks=("ours",),
    ),
    Claim(
        "(16), radius vector",
        r"\rho\text{: radius vector of a point of the curve}",
        Definition(radius_vector, printed_radius(THETA)),
        note="The symbol is explained but does not occur in the printed formula; it is the "
        "bracket.",
    ),
    Claim(
        "(16), length of the radius vector",
        r"x_{13}^2+y_{13}^2=\rho^2",
        Equality(PRINTED_16[0] ** 2 + PRINTED_16[1] ** 2, printed_radius(THETA) ** 2),
        note="The bracket is the polar radius at the polar angle.",
        marks=("ours",),
    ),
    Claim(
        "(16), shifted circle",
        r"\text{by the formulas of the shifted circle}",
        Equality(
            (printed_radius(THETA) * sp.cos(THETA) - amplitude) ** 2
            + (printed_radius(THETA) * sp.sin(THETA)) ** 2,
            radius**2,
        ),
        note="The formula is the shifted circle's, at the angle z varphi.",
    ),
    Claim(
        "(16), the track and the circle",
        r"(x_{13}-A)^2+y_{13}^2=R^2\text{ for }z=1",
        Conjunction(
            (
                Equality(squared_distance_from_centre(1), radius**2),
                Distinct(squared_distance_from_centre(2), radius**2),
            )
        ),
        note="The radius vector is laid off at the angle varphi, so the track itself is that "
        "circle for one period only; two periods do for the other case.",
        marks=("ours",),
    ),
    Claim(
        "(16), sign of the root",
        r"\rho>0\text{ and the other root is negative}",
        Conjunction(
            (
                Equality(
                    printed_radius(THETA) * (2 * amplitude * sp.cos(THETA) - printed_radius(THETA)),
                    amplitude**2 - radius**2,
                ),
                less(amplitude**2, radius**2),
            )
        ),
        note="The two roots of the circle's equation have a negative product while A < R, so the "
        "larger, printed one is the positive one.",
        on=Part("A < R", where=(amplitude < radius,)),
        marks=("ours",),
    ),
    Claim(
        "(16), amplitude",
        r"A\text{: shift of the circle, amplitude of the multi-period curve}",
        Conjunction(
            (
                Equality((printed_radius(sp.Integer(0)) - printed_radius(sp.pi)) / 2, amplitude),
                not_above(
                    (radius - amplitude) ** 2,
                    (amplitude + radius * sp.cos(phi)) ** 2 + (radius * sp.sin(phi)) ** 2,
                ),
                not_above(
                    (amplitude + radius * sp.cos(phi)) ** 2 + (radius * sp.sin(phi)) ** 2,
                    (radius + amplitude) ** 2,
                ),
            )
        ),
        note="Seen from the pole the points of the shifted circle lie between R - A and R + A, "
        "and both are reached; A is half of the difference.",
    ),
    Claim(
        "(16), number of periods",
        r"z\text{: number of periods}",
        Equality(printed_radius(periods * (phi + 2 * sp.pi / periods)), radius_by_sine_rule(THETA)),
        note="The radius vector repeats after 1/z of a turn.",
    ),
    Claim(
        "(16) and Table 1, R",
        r"R\text{: radius of the circle (16), mean radius of the track (Table 1)}",
        Equality(sp.Integral(printed_radius(THETA), (phi, 0, 2 * sp.pi)) / (2 * sp.pi), radius),
        readings=(
            Reading(
                "the middle between the largest and the smallest radius",
                Equality((printed_radius(sp.Integer(0)) + printed_radius(sp.pi)) / 2, radius),
            ),
        ),
        corrected=Correction(
            r"R=\tfrac12(\rho_{max}+\rho_{min})",
            Equality((printed_radius(sp.Integer(0)) + printed_radius(sp.pi)) / 2, radius),
        ),
        note="The radius of the circle is the middle of the extreme radii; the average of the "
        "radius over the polar angle is smaller.",
    ),
    Claim(
        "(16), average radius",
        r"\tfrac12(\rho(\theta)+\rho(\theta+\pi))=\sqrt{R^2-A^2\sin^2\theta}\le R",
        Conjunction(
            (
                Equality(
                    (printed_radius(phi) + radius_by_sine_rule(phi + sp.pi)) / 2,
                    sp.sqrt(radius**2 - amplitude**2 * sp.sin(phi) ** 2),
                ),
                not_above(radius**2 - amplitude**2 * sp.sin(phi) ** 2, radius**2),
            )
        ),
        note="Pairs of opposite phases average to at most R, so the average over the angle is "
        "below R for every A > 0.",
        marks=("ours",),
    ),
    Claim(
        "(16), enclosed area",
        r"\tfrac12\int_0^{2\pi}\rho^2\,d\varphi=\pi R^2",
        Conjunction(
            (
                Equality(
                    (printed_radius(phi) ** 2 + radius_by_sine_rule(phi + sp.pi) ** 2) / 2,
                    radius**2 + amplitude**2 * sp.cos(2 * phi),
                ),
                Equality(
                    sp.Integral(radius**2 + amplitude**2 * sp.cos(2 * dummy), (dummy, 0, phi)),
                    radius**2 * phi + amplitude**2 * sp.sin(2 * phi) / 2,
                ),
            )
        ),
        note="Over a full turn the last term vanishes: for every z the track encloses the area of "
        "the circle, and R is also the quadratic mean of the radius vector.",
        marks=("ours",),
    ),
    PRINT.equation(
        "(17)",
        defines=(planar_error,),
        note="The position error of one point; not the scatter field that (3)-(7) call "
        "Delta_Sigma.",
    ),
    PRINT.equation("(18)", defines=(spatial_error,), note="As (17), in space."),
)
