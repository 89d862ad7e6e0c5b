"""What paper 1 prints of the transmission ratio: the velocity plan and (1) to (8)."""

from sympy import Matrix, S

from mechproof.record import ChainLink, Claim, Equality, Equation, Reading

from .mechanics import (
    PLACES,
    axis_c,
    centre_c,
    omega_satellite,
    radius_of_mate,
    ratio_by_inversion,
    ratio_by_plan,
    rolling,
    velocity_b,
    velocity_c,
)
from .symbols import (
    AC,
    R1,
    R2,
    VC,
    VD,
    at_b,
    at_c,
    at_d,
    focal_radius,
    omega1,
    omega3,
    phi1,
    phi5,
    ratio_symbol,
    rho,
    slope,
    theta,
)
from .variables import READER

EQUATION_8 = Equation(
    "(8)",
    r"\frac{d\varphi_3}{d\varphi_1}=1+\frac{R_1}{R_2}\cdot"
    r"\left(\frac{1-e^2}{1+e^2-2e\cos\varphi_5}\right)",
    derived={slope: ratio_by_plan},
    marks=("inferred",),
)
_, print_8 = READER.members(EQUATION_8)

RATIO_ROWS = (
    Claim(
        "velocity plan, V_C",
        r"V_C\perp AC",
        Equality(S.Zero, velocity_c.dot(axis_c)),
    ),
    Claim(
        "velocity plan, B",
        r"V_B=0:\ B\text{ is the instant centre of the satellite}",
        Equality(Matrix([0, 0]), velocity_b),
        note="V_A and V_E are zero because A and E lie on the fixed axis.",
        marks=("inferred",),
    ),
    Equation(
        "(1)",
        r"\varphi_3'=\frac{\omega_3}{\omega_1}=\frac{d\varphi_3}{d\varphi_1}"
        r"=\frac{V_D\cdot AC}{V_C\cdot DE}=\frac{BD\cdot AC}{BC\cdot DE}",
        defines=(ratio_symbol, slope),
        links={
            1: ChainLink(note="Introduces the analogue of the velocity."),
            2: ChainLink(note="Introduces the derivative of the position, by the chain rule."),
            3: ChainLink(
                derived={slope: omega3 / omega1},
                note="V_C = omega1 AC and V_D = omega3 DE, all signed on the line A-C.",
                marks=("inferred",),
            ),
            4: ChainLink(
                derived={
                    VC: omega_satellite * (at_c - at_b),
                    VD: omega_satellite * (at_d - at_b),
                },
                note="Velocities of the satellite are proportional to the distance from B.",
                marks=("inferred",),
            ),
        },
    ),
    Equation(
        "(2)",
        r"AC=R_1-R_2=2a",
        links={
            1: ChainLink(
                derived={AC: centre_c},
                note="Circle 5 touches circle 4 from inside: AC + R2 = R1.",
                marks=("inferred",),
            ),
            2: ChainLink(
                derived={R1 - R2: rho + radius_of_mate(phi5)},
                note=(
                    "The centre distance at which two congruent ellipses roll about their foci; "
                    "with it, R1, R2 and a are no longer independent."
                ),
            ),
        },
    ),
    Equation("(3)", r"BC=R_2", derived=PLACES, marks=("inferred",)),
    Equation(
        "(4)",
        r"CD=\rho(\varphi_5)=\frac{a(1-e^2)}{1-e\cos\varphi_5}",
        defines=(rho,),
        links={
            1: ChainLink(note="Introduces the radius of wheel 6 in the direction of D."),
            2: ChainLink(
                derived={rho: focal_radius.subs(theta, phi5)},
                note="At phi1 = 0 the second focus lies towards A: read from the sign in (4).",
                marks=("inferred",),
            ),
        },
    ),
    Claim(
        "(4), phi5",
        r"\varphi_5=-\frac{R_1}{R_2}\varphi_1\text{ is the rotation of the ellipse}",
        Equality(-R1 / R2 * phi1, rolling / omega1 * phi1),
        readings=(
            Reading(
                "the rotation against the carrier, not against the frame",
                Equality(-R1 / R2 * phi1, (rolling - omega1) / omega1 * phi1),
            ),
        ),
    ),
    Equation(
        "(5)", r"BD=BC+CD=R_2+\rho", links={2: ChainLink(derived=PLACES, marks=("inferred",))}
    ),
    Equation("(6)", r"DE=AC-CD=2a-\rho", links={2: ChainLink(derived=PLACES, marks=("inferred",))}),
    Claim(
        "two routes",
        r"\text{velocity plan}=\text{method of inversion}",
        Equality(ratio_by_plan, ratio_by_inversion),
        marks=("ours",),
    ),
    Equation(
        "(7)",
        r"\varphi_3'=\frac{(R_2+\rho)\cdot 2a}{R_2\cdot(2a-\rho)}",
        derived={ratio_symbol: ratio_by_plan},
        marks=("inferred",),
    ),
    EQUATION_8,
)
