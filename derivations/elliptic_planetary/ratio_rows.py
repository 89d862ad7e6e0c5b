"""What paper 1 prints of the transmission ratio: the velocity plan and (1) to (8)."""

from sympy import Matrix, S

from mechproof.record import ChainLink, Equality, all_of, ours

from .mechanics import (
    PLACES,
    axis_c,
    centre_c,
    omega_satellite,
    radius_of_mate,
    ratio_by_inversion,
    ratio_by_plan,
    rolling,
    velocity_at,
    velocity_b,
    velocity_c,
)
from .symbols import *

EQUATION_8 = PRINT.equation("(8)", derived={slope: ratio_by_plan}, marks=("inferred",))
_, print_8 = READER.members(EQUATION_8)

RATIO_ROWS = (
    PRINT.claim(
        "velocity plan, V_C",
        Equality(S.Zero, velocity_c.dot(axis_c)),
        note="The scalar product of V_C and AC is 0.",
    ),
    PRINT.claim(
        "velocity plan, B",
        all_of(
            Equality(Matrix([0, 0]), velocity_b),
            Equality(Matrix([0, 0]), velocity_at(S.Zero)),
        ),
        note="A and E lie on the fixed axis.",
        marks=("inferred",),
    ),
    PRINT.equation(
        "(1)",
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
    PRINT.equation(
        "(2)",
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
    PRINT.equation("(3)", derived=PLACES, marks=("inferred",)),
    PRINT.equation(
        "(4)",
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
    PRINT.claim(
        "(4), phi5",
        Equality(-R1 / R2 * phi1, (rolling - omega1) / omega1 * phi1),
        note="Relative to the carrier, as (4) needs it, since its radius lies on the line A-C; "
        "relative to the frame the satellite turns by (1 - R1/R2) phi1.",
        marks=("inferred",),
    ),
    PRINT.equation("(5)", links={2: ChainLink(derived=PLACES, marks=("inferred",))}),
    PRINT.equation("(6)", links={2: ChainLink(derived=PLACES, marks=("inferred",))}),
    ours(
        "two routes",
        r"\text{velocity plan}=\text{method of inversion}",
        Equality(ratio_by_plan, ratio_by_inversion),
        quantities=("ratio",),
    ),
    PRINT.equation("(7)", derived={ratio_symbol: ratio_by_plan}, marks=("inferred",)),
    EQUATION_8,
)
