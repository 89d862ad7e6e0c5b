"""The equations (1)-(11) of paper 2 as read, and our findings on each."""

import sympy as sp

from mechproof.record import ChainLink, Correction, Equality, Holds, Part, Reading, all_of, ours

from ..._eccentric import roll
from ..mechanics import *

# Printed expressions, for claims and kernels.
(_, print_2), (_, print_5), (_, print_7), (_, print_10) = map(read, ("(2)", "(5)", "(7)", "(10)"))


def print_radius(eccentricity: sp.Expr, angle: sp.Expr) -> sp.Expr:
    """Right-hand side of (2), and with other letters that of (3) and (4)."""
    return print_2.subs({e: eccentricity, phi: angle}, simultaneous=True)


def print_3_by_6(cosine: sp.Expr) -> sp.Expr:
    """Right-hand side of (3) with (6), by the cosine of twice the angle of wheel 6."""
    return print_2.subs({e: e1, sp.cos(2 * phi): -cosine}, simultaneous=True)


# (10) with the radii of two oval pairs.
RATIO_OF_10 = print_10.subs({rho5: print_3_by_6(cos_6), rho6: oval_radius(e2, cos_6)})

# The satellite turns about B: its velocity at D by its angular velocity.
FROM_B_TO_D = satellite_velocity.subs({s: point_d, omega_satellite: rolling}) / rolling
oval = print_radius(e, phi)
slope = sp.diff(oval, phi)

# Positive where the curve bends towards its centre.
bend = sp.factor(oval**2 + 2 * slope**2 - oval * sp.diff(oval, phi, 2))
mate_cosine, _ = roll(e, 2 * phi)
mate = oval_radius(e, -mate_cosine)

ROWS = (
    PRINT.equation(
        "(1)",
        defines=(ratio_symbol,),
        marks=("rebuilt",),
        links={
            2: ChainLink(
                note="v_C = omega1 AC and v_D = omega3 DE, all signed on the line A-C.",
                marks=("rebuilt", "inferred"),
            ),
            3: ChainLink(
                derived={VC: omega_satellite * (sC - sB), VD: -omega_satellite * (sD - sB)},
                note="Velocities of the satellite are proportional to the distance from B. Here BD "
                "and v_D are both counted against the carrier, as in (7); with both counted the "
                "other way it holds as well.",
                marks=("rebuilt", "inferred"),
            ),
        },
    ),
    PRINT.equation(
        "(2)",
        derived={rho: focal_radius.subs(theta, 2 * phi)},
        note="At half the polar angle the radius of the oval is the focal radius of its ellipse.",
        marks=("rebuilt", "uncertain", "inferred"),
    ),
    PRINT.claim(
        "(2), angle from the major semi-axis",
        all_of(
            Equality(print_radius(e, sp.S.Zero), a + a * e),
            Holds(print_radius(e, phi) <= a + a * e),
        ),
        note="The radius is largest at angle 0, a (1 + e), the largest focal distance of the "
        "ellipse; the major semi-axis of the oval itself is longer than a.",
        marks=("rebuilt",),
    ),
    ours(
        "(2), convex",
        r"\rho^2+2\rho'^2-\rho\rho''\ge0",
        Holds(bend >= 0),
        note="The sign is that of 1 + 3 e cos(2 phi): beyond e = 1/3 the pitch curve has hollow "
        "flanks. The paper's e = 0.2 is convex.",
        holds_on=Part("e <= 1/3", {e: sp.Interval(0, sp.Rational(1, 3))}),
    ),
    PRINT.equation(
        "(3)",
        defines=(rho5,),
        links={2: ChainLink(derived={rho5: focal_radius.subs({e: e1, theta: 2 * phi5})})},
        marks=("rebuilt", "inferred"),
    ),
    PRINT.equation(
        "(4)",
        defines=(rho6,),
        links={2: ChainLink(derived={rho6: focal_radius.subs({e: e2, theta: 2 * phi6})})},
        marks=("rebuilt", "inferred"),
    ),
    PRINT.equation(
        "(5)",
        derived={phi6: integrate(sun_radius / (2 * a - sun_radius))},
        note="Seen from the carrier, wheel 5 turns at the ratio rho4/rho5; at the lower limit 0 "
        "the sun's major axis lies on the line of centres.",
        marks=("rebuilt", "uncertain", "inferred"),
    ),
    ours(
        "(5), constant",
        r"\rho_4(0)+\rho_5\left(\tfrac\pi2-c\right)-2a"
        r"=\frac{2ae_1(1-e_1)\sin^2c}{1+e_1\cos2c}",
        Equality(
            print_radius(e1, sp.S.Zero) + print_radius(e1, sp.pi / 2 - start) - 2 * a,
            2 * a * e1 * (1 - e1) * sp.sin(start) ** 2 / (1 + e1 * sp.cos(2 * start)),
        ),
        note="By (3), (6) and axes that are 2a apart, the lost constant of (5) is 0 (or a number "
        "of half turns, which change no radius).",
    ),
    ours(
        "(5), closed form",
        r"\varphi_6=\varphi_1+\mathrm{arctg}\frac{e_1\sin2\varphi_1}{1-e_1\cos2\varphi_1}",
        derived={phi6: print_5},
        note="Over any number of turns; tan(phi6) = (1 + e1)/(1 - e1) tan(phi1).",
        quantities=("position",),
    ),
    ours(
        "(5), double angle",
        r"\cos2\varphi_6=\frac{(1+e^2)\cos2\varphi_1-2e}{1+e^2-2e\cos2\varphi_1},\ "
        r"\sin2\varphi_6=\frac{(1-e^2)\sin2\varphi_1}{1+e^2-2e\cos2\varphi_1}",
        all_of(
            *(
                Equality(one, two)
                for one, two in zip(roll_reduced(e, phi1), roll(e, 2 * phi1), strict=True)
            )
        ),
        quantities=("position", "ratio"),
    ),
    PRINT.equation(
        "(6)",
        defines=(phi5,),
        note="How wheels 5 and 6 are mounted on their shaft.",
        marks=("rebuilt", "uncertain"),
    ),
    ours(
        "(6), mesh with the sun",
        r"2a-\rho_4(\varphi_1)=\rho_5\left(\tfrac\pi2-\varphi_6\right)"
        r"=\rho_5\left(\tfrac\pi2+\varphi_6\right)",
        all_of(
            Equality(print_3_by_6(cos_6), 2 * a - sun_radius),
            Equality(
                print_radius(e1, sp.pi / 2 - phi6),
                focal_radius.subs({e: e1, theta: sp.pi + 2 * phi6}),
            ),
        ),
        note="With (6), (3) is the radius that meshes with the sun: cos(2 phi5) = -cos(2 phi6). "
        "Nothing depends on the sign, which may be the bar of a fraction.",
        marks=("rebuilt", "uncertain", "inferred"),
    ),
    PRINT.equation(
        "(7)",
        derived={BD: point_d - point_b},
        readings=(Reading("the distance from D to B", Equality(print_7, -FROM_B_TO_D)),),
        note="In the order that is legible, here and in (10). The distance is signed, as either "
        "of the two radii may be the larger one.",
        marks=("rebuilt", "inferred"),
    ),
    PRINT.equation(
        "(8)",
        defines=(EC,),
        links={
            1: ChainLink(
                note="E lies on the axis of A: another name for AC.", marks=("rebuilt", "inferred")
            ),
            2: ChainLink(
                derived={EC: focal_radius.subs(theta, 2 * phi) + mate},
                note="Two congruent ovals mesh at this distance in every position.",
            ),
        },
        marks=("rebuilt", "inferred"),
    ),
    ours(
        "(8), rolling",
        r"\rho\,d\varphi=\rho_{mate}\,d\chi",
        Equality(print_radius(e, phi), mate * sp.diff(driven_angle(e, phi), phi)),
        note="The arcs are equal: congruent ovals roll without slip.",
        quantities=("ratio",),
    ),
    PRINT.equation("(9)", derived=PLACES, marks=("rebuilt", "inferred")),
    ours(
        "two routes",
        r"\text{velocity plan}=\text{method of inversion}",
        Equality(ratio_by_plan, ratio_by_inversion),
        marks=("inferred",),
        quantities=("ratio",),
    ),
    PRINT.equation(
        "(10)",
        derived={ratio_symbol: ratio_by_plan},
        readings=(
            Reading(
                "the output counted against the carrier's direction of rotation",
                all_of(
                    Equality(print_10, -ratio_by_plan),
                    Equality(
                        integrate(RATIO_OF_10),
                        -position_of_one(E_SERIES),
                    ),
                ),
            ),
        ),
        corrected=Correction(
            r"\varphi_3'=\frac{(\rho_5-\rho_6)\,2a}{\rho_5\,(2a-\rho_6)}",
            Equality(-print_10, ratio_by_plan),
        ),
        note="The text at hand does not say in which direction the output is counted. The "
        "integral of (10) has the sign of (10).",
        marks=("rebuilt", "inferred"),
    ),
    PRINT.equation(
        "(11)",
        derived={
            phi3: position_of_one(E_SERIES),
            ratio_symbol: 1 - wheel_3_rate.subs(mount, sp.S.Zero),
        },
        note="From phi3(0) = 0, for two oval pairs, in whichever direction the output is counted; "
        "in closed form phi3 = -arctan(E sin(2 phi1)/(1 - E cos(2 phi1))) counted with the "
        "carrier, E = (e1 + e2)/(1 + e1 e2). Fig. 2, which was built by it, is not at hand.",
        marks=("rebuilt", "inferred"),
    ),
)
