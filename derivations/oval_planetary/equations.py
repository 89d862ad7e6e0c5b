"""The equations (1)-(11) of paper 2, and what is found beside each."""

from __future__ import annotations

import sympy as sp

from mechproof.record import (
    Claim,
    Conjunction,
    Definition,
    Equality,
    Equation,
    Holds,
    Part,
    Reading,
    Row,
)

from .mechanics import (
    cos_6,
    focal_radius,
    integrate,
    point_b,
    point_c,
    point_d,
    ratio_by_inversion,
    ratio_by_plan,
    roll,
    roll_reduced,
    sun_radius,
)
from .positions import E_SERIES, position_of_one
from .printed import print_5, print_7, print_9, print_10, print_11, print_radius
from .symbols import (
    AC,
    BC,
    BD,
    DE,
    VC,
    VD,
    a,
    driven_angle,
    e,
    e1,
    e2,
    omega1,
    omega3,
    phi,
    phi1,
    phi5,
    phi6,
    ratio_symbol,
    sB,
    sC,
    sD,
    start,
    theta,
)

oval = print_radius(e, phi)
slope = sp.diff(oval, phi)

# Positive where the curve bends towards its centre.
bend = sp.factor(oval**2 + 2 * slope**2 - oval * sp.diff(oval, phi, 2))
mate_cosine, _ = roll(e, phi)
mate = a * (1 - e**2) / (1 + e * mate_cosine)

EQUATION_ROWS: tuple[Row, ...] = (
    Equation(
        "(1), first equals sign",
        r"\varphi_3'=\frac{\omega_3}{\omega_1}",
        Definition(ratio_symbol, omega3 / omega1),
        marks=("rebuilt",),
    ),
    Equation(
        "(1), second equals sign",
        r"\frac{\omega_3}{\omega_1}=\frac{v_D\cdot AC}{v_C\cdot DE}",
        Equality(VD * AC / (VC * DE), omega3 / omega1),
        note="v_C = omega1 AC and v_D = omega3 DE, all signed on the line A-C.",
        marks=("rebuilt", "inferred"),
    ),
    Equation(
        "(1), third equals sign",
        r"\frac{v_D\cdot AC}{v_C\cdot DE}=\frac{BD\cdot AC}{BC\cdot DE}",
        Equality(BD * AC / (BC * DE), -(sD - sB) / (sC - sB) * sC / sD),
        note="Velocities of the satellite are proportional to the distance from B; that of D is "
        "counted against the carrier.",
        marks=("rebuilt", "inferred"),
    ),
    Equation(
        "(2)",
        r"\rho(\varphi)=\frac{a(1-e^2)}{1-e\cos2\varphi}",
        Equality(print_radius(e, phi), focal_radius.subs(theta, 2 * phi)),
        note="The oval has at half the polar angle the focal radius of its ellipse.",
        marks=("rebuilt", "uncertain"),
    ),
    Claim(
        "(2), semi-axes",
        r"a(1-e)\le\rho\le a(1+e)",
        Conjunction((Holds(oval >= a * (1 - e)), Holds(oval <= a * (1 + e)))),
        marks=("ours",),
    ),
    Claim(
        "(2), convex",
        r"\rho^2+2\rho'^2-\rho\rho''\ge0",
        Holds(bend >= 0),
        note="The sign is that of 1 + 3 e cos(2 phi): beyond e = 1/3 the pitch curve has hollow "
        "flanks. The paper's e = 0.2 is convex.",
        holds_on=Part("e <= 1/3", {e: sp.Interval(0, sp.Rational(1, 3))}),
        marks=("ours",),
    ),
    Claim(
        "(2), convex up to 1/3",
        r"\rho^2+2\rho'^2-\rho\rho''<0\text{ at }\varphi=\tfrac\pi2,\ e>\tfrac13",
        Holds(bend.subs(phi, sp.pi / 2) < 0),
        on=Part("e > 1/3", {e: sp.Interval.open(sp.Rational(1, 3), 1)}),
        marks=("ours",),
    ),
    Equation(
        "(3)",
        r"BC=\rho_5=\frac{a(1-e_1^2)}{1-e_1\cos2\varphi_5}",
        Equality(print_radius(e1, phi5), focal_radius.subs({e: e1, theta: 2 * phi5})),
        marks=("rebuilt",),
    ),
    Equation(
        "(4)",
        r"CD=\rho_6=\frac{a(1-e_2^2)}{1-e_2\cos2\varphi_6}",
        Equality(print_radius(e2, phi6), focal_radius.subs({e: e2, theta: 2 * phi6})),
        marks=("rebuilt",),
    ),
    Equation(
        "(5)",
        r"\varphi_6=\int\frac{1-e_1^2}{1+e_1^2-2e_1\cos2\varphi_1}\,d\varphi_1",
        Equality(print_5, integrate(sun_radius / (2 * a - sun_radius))),
        note="Seen from the carrier: wheel 5 turns by rho4/rho5, the sun's major axis on the line "
        "of centres at the lower limit 0.",
        marks=("rebuilt", "uncertain", "inferred"),
    ),
    Claim(
        "(5), constant",
        r"\rho_4(0)+\rho_5\left(\tfrac\pi2-c\right)-2a"
        r"=\frac{2ae_1(1-e_1)\sin^2c}{1+e_1\cos2c}",
        Equality(
            print_radius(e1, sp.S.Zero) + print_radius(e1, sp.pi / 2 - start) - 2 * a,
            2 * a * e1 * (1 - e1) * sp.sin(start) ** 2 / (1 + e1 * sp.cos(2 * start)),
        ),
        note="With (3), (6) and the axes 2a apart the lost constant of (5) is 0 (or half turns, "
        "which change no radius).",
        marks=("ours",),
    ),
    Claim(
        "(5), closed form",
        r"\varphi_6=\varphi_1+\mathrm{arctg}\frac{e_1\sin2\varphi_1}{1-e_1\cos2\varphi_1}",
        Equality(driven_angle(e1, phi1), print_5),
        note="Over any number of turns; tan(phi6) = (1 + e1)/(1 - e1) tan(phi1).",
        marks=("ours",),
    ),
    Claim(
        "(5), double angle",
        r"\cos2\varphi_6=\frac{(1+e^2)\cos2\varphi_1-2e}{1+e^2-2e\cos2\varphi_1},\ "
        r"\sin2\varphi_6=\frac{(1-e^2)\sin2\varphi_1}{1+e^2-2e\cos2\varphi_1}",
        Conjunction(
            tuple(
                Equality(one, two)
                for one, two in zip(roll_reduced(e, phi1), roll(e, phi1), strict=True)
            )
        ),
        marks=("ours",),
    ),
    Equation(
        "(6)",
        r"\varphi_5=\frac\pi2-\varphi_6",
        Equality(a * (1 - e1**2) / (1 + e1 * cos_6), 2 * a - sun_radius),
        note="With it (3) is the radius that meshes with the sun: cos(2 phi5) = -cos(2 phi6).",
        marks=(
            "rebuilt",
            "uncertain",
        ),
    ),
    Claim(
        "(6), sign",
        r"\rho_5\left(\tfrac\pi2-\varphi_6\right)=\rho_5\left(\tfrac\pi2+\varphi_6\right)",
        Equality(
            print_radius(e1, sp.pi / 2 - phi6), focal_radius.subs({e: e1, theta: sp.pi + 2 * phi6})
        ),
        note="Nothing depends on the sign that may be the bar of a fraction.",
        marks=("ours",),
    ),
    Equation(
        "(7)",
        r"BD=\rho_6-\rho_5",
        Equality(print_7, point_b - point_d),
        note="From D to B, as the order is legible: the output's side counts against the carrier.",
        marks=("rebuilt", "inferred"),
    ),
    Equation(
        "(8)",
        r"AC=EC=2a",
        Conjunction((Equality(2 * a, print_radius(e, phi) + mate), Equality(2 * a, point_c))),
        note="Two congruent ovals mesh at this distance in every position.",
        marks=("rebuilt", "inferred"),
    ),
    Claim(
        "(8), rolling",
        r"\rho\,d\varphi=\rho_{mate}\,d\chi",
        Equality(print_radius(e, phi), mate * sp.diff(driven_angle(e, phi), phi)),
        note="The arcs are equal: congruent ovals roll without slip.",
        marks=("ours",),
    ),
    Equation("(9)", r"DE=2a-\rho_6", Equality(print_9, point_d), marks=("rebuilt", "inferred")),
    Claim(
        "two routes",
        r"\text{velocity plan}=\text{method of inversion}",
        Equality(ratio_by_plan, ratio_by_inversion),
        marks=("ours", "inferred"),
    ),
    Equation(
        "(10)",
        r"\varphi_3'=\frac{(\rho_6-\rho_5)\,2a}{\rho_5\,(2a-\rho_6)}",
        Equality(print_10, -ratio_by_plan),
        note="The output counted against the carrier.",
        marks=("rebuilt", "inferred"),
    ),
    Equation(
        "(11)",
        r"\varphi_3(\varphi_1)=\int\varphi_3'\,d\varphi_1",
        Equality(print_11, -position_of_one(E_SERIES)),
        note="From phi3(0) = 0, with (3)-(6), the output counted against the carrier; in closed "
        "form phi3 = arctan(E sin(2 phi1)/(1 - E cos(2 phi1))), E = (e1 + e2)/(1 + e1 e2).",
        marks=("rebuilt", "inferred"),
    ),
    Claim(
        "(1)-(11), sense of the output",
        r"BD=\rho_6-\rho_5,\ \varphi_3'=\frac{(\rho_6-\rho_5)\,2a}{\rho_5\,(2a-\rho_6)}",
        Conjunction(
            (
                Equality(print_7, point_d - point_b),
                Equality(print_10, ratio_by_plan),
                Equality(print_11, position_of_one(E_SERIES)),
            )
        ),
        readings=(
            Reading(
                "the output counted against the carrier's direction of rotation throughout: "
                "omega3, v_D, BD from D to B, phi3",
                Conjunction(
                    (
                        Equality(print_7, point_b - point_d),
                        Equality(print_10, -ratio_by_plan),
                        Equality(print_11, -position_of_one(E_SERIES)),
                    )
                ),
            ),
        ),
        note="No direction of phi3 survives in the text. One choice makes the whole chain true; "
        "the other equations are judged with it.",
        marks=("rebuilt", "inferred"),
    ),
)
