"""Prints of paper 1 on ratio and position: the velocity plan and (1) to (8), (9) to (12)."""

from sympy import Expr, Ge, Integral, Matrix, S, atan, diff, oo, pi, sqrt, tan

from mechproof.record import *

from ..mechanics import *

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
                note="The centre distance at which two congruent ellipses roll about their foci; "
                "with it, R1, R2 and a are no longer independent.",
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


# Position: the integral (9) and its steps to (12) -------------------------------------------------

CORRECT_FOURTH = r"\int\frac{\frac{dx}{\cos^2\frac x2}}{(a_1+b_1)\,\mathrm{tg}^2\frac x2+(a_1-b_1)}"
LAST_OF_10 = (
    r"\frac{2}{a_1+b_1}\int\frac{d\,\mathrm{tg}\frac x2}"
    r"{\mathrm{tg}^2\frac x2+\frac{a_1-b_1}{a_1+b_1}}"
)
CORRECT_12 = (
    r"\varphi_3=\left(1+\frac{R_1}{R_2}\right)\varphi_1+2\,\mathrm{arctg}"
    r"\frac{e\sin x}{1-e\cos x}"
)
EQUATION_12 = PRINT.equation(
    "(12)",
    note="As a1 ± b1 = (1 ± e)^2, the root in (11) is already (1 + e)/(1 - e), but (12) takes the "
    "root once more. Without that root the factor before the arctangent is 2 and the quotient "
    "inside is (1 + e)/(1 - e). Besides, the arctangent jumps back after each turn. Compared with "
    "the integral of (8), which is proved, from 0.",
    corrected=Correction(CORRECT_12),
    singular=("R1 phi1/R2 = (2m+1) pi",),
    derived={phi3: position},
)
DX_SUPPLIED = ours(
    "(10), third equals sign, dx supplied",
    r"\int\frac{dx}{(a_1+b_1)\sin^2\frac x2+(a_1-b_1)\cos^2\frac x2}="
    r"\int\frac{\cos^2\frac x2\,dx}{(a_1+b_1)\,\mathrm{tg}^2\frac x2+(a_1-b_1)}",
    note="With the missing differential supplied, the numerator is still wrong.",
    corrected=Correction(CORRECT_FOURTH),
    on=BRANCH,
)
_, print_12 = READER.members(EQUATION_12)

POSITION_ROWS = (
    PRINT.equation(
        "(9)",
        derived={phi3: position},
        note="Compared with the integral of (8), the ratio, from the initial conditions phi10 = "
        "phi30 = 0; holds over all turns.",
    ),
    PRINT.equation("before (10), a_1"),
    PRINT.equation("before (10), b_1"),
    PRINT.equation("before (10), x", Definition(x, R1 / R2 * phi1)),
    PRINT.equation(
        "(10)",
        links={
            3: ChainLink(
                note="The factor cos^2(x/2) belongs in the denominator, and dx is missing.",
                corrected=Correction(CORRECT_FOURTH),
                on=BRANCH,
            ),
            4: ChainLink(
                note="Its left-hand side is the ill-formed integral; the right-hand side is sound.",
                corrected=Correction(f"{CORRECT_FOURTH}={LAST_OF_10}"),
                on=BRANCH,
            ),
        },
    ),
    DX_SUPPLIED,
    PRINT.claim("since e <= 1", on=UP_TO_ONE),
    PRINT.equation(
        "(11)",
        substituted={tan(x / 2): U},
        note="As an integral over tg(x/2) = U; C = 0 for the lower limit 0. At e = 1, which is no "
        "ellipse, it would divide by zero.",
    ),
    ours(
        "(11) over all turns",
        r"\int_0^x\frac{dx}{a_1-b_1\cos x}=\frac{2}{a_1+b_1}\sqrt{\frac{a_1+b_1}{a_1-b_1}}\,"
        r"\mathrm{arctg}\frac{\mathrm{tg}\frac x2}{\sqrt{\frac{a_1-b_1}{a_1+b_1}}}",
        note="With a single constant C the right-hand side jumps back at every odd multiple of pi.",
        holds_on=BRANCH,
        singular=("x = (2m+1) pi",),
        corrected=Correction(
            r"\frac{1}{1-e^2}\left(x+2\,\mathrm{arctg}\frac{e\sin x}{1-e\cos x}\right)"
        ),
    ),
    EQUATION_12,
    ours(
        "(12) without its roots",
        r"\varphi_3=\varphi_1+2\;\mathrm{arctg}\left(\mathrm{tg}\left(\frac{R_1}{2R_2}"
        r"\varphi_1\right)\cdot\frac{1+e}{1-e}\right)",
        Equality(position_principal, position),
        note="The root before the arctangent is dropped, and so is the one inside. This is right "
        "up to half a turn of x; the general form holds beyond.",
        on=BRANCH,
    ),
    PRINT.claim(
        "(12), initial conditions",
        Equality(print_12.subs(phi1, 0), S.Zero),
        note="(12), as printed, starts at 0.",
    ),
    ours(
        "half-angle arctangent without branches",
        r"2\,\mathrm{arctg}\left(\tfrac{1+e}{1-e}\mathrm{tg}\tfrac x2\right)="
        r"x+2\,\mathrm{arctg}\frac{e\sin x}{1-e\cos x}",
        on=BRANCH,
        note="The right-hand side also holds beyond the branch.",
        quantities=("position",),
    ),
)

# By how much (12) is too small on its first branch, by U = tg(x/2), and where that branch ends, in
# degrees.
ROOT = sqrt((1 - e) / (1 + e))
LACK = 2 * atan(U * (1 + e) / (1 - e)) - 2 * ROOT * atan(U / ROOT)
BRANCH_END = 180 * R2 / R1


def of_variant(expression: Expr, number: int) -> Expr:
    """Put the sizes of Table 1 into an expression."""
    return expression.subs(k, R1 / R2).subs(dict(zip((R1, R2, e), VARIANTS[number], strict=True)))


def lack_at_branch_end(number: int) -> Expr:
    """Return by how many degrees (12) is too small as x nears half a turn."""
    # Arctangents are continuous at infinity: their values there are the limits.
    return of_variant(LACK, number).subs(U, oo) * 180 / pi


POSITION_CLAIMS = (
    ours(
        "(12), size of its error",
        r"0\le\varphi_3-(12)<\pi\left(1-\sqrt{\tfrac{1-e}{1+e}}\right),\ 0\le x<\pi:\ "
        r"45.0^\circ,\ 72.6^\circ\text{ at }\varphi_1=\pi\tfrac{R_2}{R_1}=43.6^\circ,\ 67.5^\circ",
        all_of(
            Equality(LACK.subs(U, tan(x / 2)), position_principal - print_12),
            Holds(Ge(diff(LACK, U), 0)),
            PrintedNumber("45.0", lack_at_branch_end(1)),
            PrintedNumber("72.6", lack_at_branch_end(2)),
            PrintedNumber("43.6", of_variant(BRANCH_END, 1)),
            PrintedNumber("67.5", of_variant(BRANCH_END, 3)),
        ),
        note="(12) falls short by an angle that grows with x over the first branch, up to 45.0°"
        " for e = 0.28 and 72.6° for e = 0.475, whatever the radii. The branch ends at 43.6°"
        " of the carrier in variants 1 and 2, at 67.5° in variants 3 and 4; beyond it the "
        "arctangent jumps back.",
        on=BRANCH,
        marks=("consequence",),
    ),
    PRINT.claim(
        "(12) gives the position function",
        Equality(print_12, position),
        note="Follows from (12); not a second error.",
        corrected=Correction(CORRECT_12, Equality(position_closed, position)),
    ),
    PRINT.claim(
        "Fig. 3, formula used",
        Equality(Integral(print_8.subs(phi5, -R1 / R2 * tau), (tau, 0, phi1)), position),
        note="By the integral of (8), a ratio, from phi1 = 0, as in (9). The curves of Fig. 3 are "
        "not at hand.",
        marks=("inferred",),
    ),
    ours(
        "extremes of the ratio",
        r"1+\frac{R_1}{R_2}\cdot\frac{1-e}{1+e}\le\varphi_3'\le"
        r"1+\frac{R_1}{R_2}\cdot\frac{1+e}{1-e}",
        derived={ratio_symbol: print_8},
        note="Reached at x = pi and x = 0 modulo 2 pi.",
        quantities=("largest_ratio", "smallest_ratio"),
    ),
)

ROWS = (*RATIO_ROWS, *POSITION_ROWS, *POSITION_CLAIMS)
