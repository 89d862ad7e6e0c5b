"""Part three: the track and the position errors of its points, (16)-(18)."""

from __future__ import annotations

import sympy as sp

from mechproof.record import (
    Claim,
    Conjunction,
    Definition,
    Equality,
    Equation,
    Part,
    Reading,
    Row,
    Variable,
)

from .._relations import less, not_above
from .errors import dummy
from .notation import coordinates, lengths, positive, real

radius, ball_radius, thickness, millimetre = positive("R r_b H_s mm")
(amplitude,) = real("A")
periods = sp.Symbol("z", integer=True, positive=True)
(phi,) = real("phi")
radius_vector, planar_error, spatial_error = positive("rho Delta_Sigma^XY Delta_Sigma^XYZ")
POSITION_ERROR = error_x, error_y, error_z = real("Delta_x0 Delta_y0 Delta_z0")

CURVE_VARIABLES = (
    *lengths(
        {
            radius: "radius of the circle in (16)",
            amplitude: "shift of the circle, amplitude of the multi-period curve",
            ball_radius: "radius of the ball",
            thickness: "thickness of the part",
            millimetre: "the unit of length",
            radius_vector: "radius vector of a point of the curve",
            planar_error: "position error in the end plane",
            spatial_error: "position error in space",
        }
    ),
    Variable(periods, "number of periods", within=sp.S.Naturals),
    Variable(phi, "polar angle", sign="counter-clockwise positive"),
    *coordinates(
        dict.fromkeys(POSITION_ERROR, "coordinate of the position error in the machine frame")
    ),
)


def printed_radius(theta: sp.Expr) -> sp.Expr:
    """Bracket printed in (16), at theta = z varphi."""
    return sp.sqrt(radius**2 - amplitude**2 * sp.sin(theta) ** 2) + amplitude * sp.cos(theta)


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


THETA = periods * phi
PRINTED_16 = on_track(printed_radius(THETA))
PRINTED_17 = sp.sqrt(error_x**2 + error_y**2)
PRINTED_18 = sp.sqrt(error_x**2 + error_y**2 + error_z**2)


CURVE_ROWS: tuple[Row, ...] = (
    Equation(
        "(16)",
        r"x_{13}=\left(\sqrt{R^2-A^2\sin^2(z\varphi)}+A\cos(z\varphi)\right)\cos\varphi,\ "
        r"y_{13}=(\dots)\sin\varphi,\ z_{13}=H_s",
        Equality(PRINTED_16, on_track(radius_by_sine_rule(THETA))),
        note="Rebuilt by the sine rule in the triangle of pole, centre and point.",
        singular=("A = R: the circle passes through the pole and the track has corners there",),
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
        Equality((PRINTED_16[0] - amplitude) ** 2 + PRINTED_16[1] ** 2, radius**2),
        readings=(
            Reading(
                "the radius vector is that of the shifted circle at the angle z varphi, laid off "
                "at the angle varphi",
                Equality(
                    (printed_radius(THETA) * sp.cos(THETA) - amplitude) ** 2
                    + (printed_radius(THETA) * sp.sin(THETA)) ** 2,
                    radius**2,
                ),
            ),
        ),
        note="The track itself is a circle only for one period, z = 1.",
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
    Equation(
        "(17)",
        r"\Delta_\Sigma^{XY}=\sqrt{\Delta x_0^2+\Delta y_0^2}",
        Definition(planar_error, PRINTED_17),
        note="The position error of one point; not the scatter field that (3)-(7) call "
        "Delta_Sigma.",
    ),
    Equation(
        "(18)",
        r"\Delta_\Sigma^{XYZ}=\sqrt{\Delta x_0^2+\Delta y_0^2+\Delta z_0^2}",
        Definition(spatial_error, PRINTED_18),
        note="As (17), in space.",
    ),
)
