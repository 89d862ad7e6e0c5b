"""What paper 1 prints and what is rebuilt: symbols, mechanics, rows.

Order of the file: symbols and how they are printed; the mechanics (velocity plan, inversion,
ellipse, position); what the paper prints, row by row.

Conventions: angles are positive in the direction of the carrier's rotation; distances on the
line A-C are positive from A towards C and B; lengths in mm, angles in rad.
"""

from sympy import (
    Eq,
    Expr,
    Gt,
    Integral,
    Interval,
    Matrix,
    Rational,
    S,
    Symbol,
    atan,
    atan2,
    cos,
    diff,
    oo,
    pi,
    sin,
    solve,
    symbols,
    tan,
)

from mechproof.latex import Reader
from mechproof.record import (
    ANGLE,
    FREQUENCY,
    LENGTH,
    SPEED,
    Claim,
    Correction,
    Definition,
    Equality,
    Equation,
    Holds,
    Notation,
    Part,
    Reading,
    Sign,
    Variable,
)

from .._metrology import (
    TYPE_A_VARIABLES,
    estimate_row,
    mean_row,
    unbiased_row,
    uncertainty_row,
    variance_of_mean_row,
    variance_row,
)
from .._readings import ENCODER_VARIABLES

# Symbols --------------------------------------------------------------------------------------

phi1 = Symbol("phi1", real=True)
R1, R2 = symbols("R1 R2", positive=True)
e = Symbol("e", real=True)
a, rho = symbols("a rho", real=True)
phi5, k, x, a1, b1, nearest = symbols("phi5 k x a1 b1 nearest", real=True)
omega1, omega3 = symbols("omega1 omega3", real=True)
VC, VD, AC, BC, BD, CD, DE = symbols("V_C V_D AC BC BD CD DE", real=True)
at_b, at_c, at_d = symbols("s_B s_C s_D", real=True)
U = Symbol("U", real=True)
tau = Symbol("tau", real=True)
turns = Symbol("m_turns", integer=True)
nu, E = symbols("nu E", positive=True)
T = Symbol("T", real=True)


phi3 = Symbol("phi3", real=True)
ratio_symbol = Symbol("phi3'", real=True)
slope = Symbol("dphi3/dphi1", real=True)
C = Symbol("C", real=True)

# Ellipse seen from a focus: the distances to both foci (2 a e apart) add up to 2 a.
r, theta = symbols("r theta", real=True)
second_focus_squared = r**2 - 4 * a * e * r * cos(theta) + 4 * a**2 * e**2
focal_radius = solve(Eq((2 * a - r) ** 2, second_focus_squared), r)[0]

VARIABLES = (
    Variable(
        phi1,
        "angle of the carrier 1",
        ANGLE,
        sign="positive in its direction of rotation",
        latex=(r"\varphi_1",),
    ),
    Variable(phi3, "angle of wheel 3", ANGLE, latex=(r"\varphi_3",)),
    Variable(R1, "radius of the epicycle 4", LENGTH, Interval.open(0, oo), latex=("R_1",)),
    Variable(R2, "radius of the satellite wheel 5", LENGTH, Interval.open(0, oo), latex=("R_2",)),
    Variable(e, "eccentricity of the ellipse", within=Interval.Ropen(0, 1), latex=("e",)),
    Variable(a, "major semi-axis of the ellipse", LENGTH, given=(R1 - R2) / 2, latex=("a",)),
    Variable(
        phi5,
        "rotation of wheel 6 against the carrier",
        ANGLE,
        given=-R1 / R2 * phi1,
        latex=(r"\varphi_5",),
    ),
    Variable(k, "ratio of the cylindrical radii", given=R1 / R2),
    Variable(
        x,
        "rotation of wheel 6 against the carrier, reversed",
        ANGLE,
        given=k * phi1,
        latex=("x", r"\frac{R_1}{R_2}\varphi_1"),
    ),
    Variable(a1, "1 + e^2", given=1 + e**2, latex=("a_1",)),
    Variable(b1, "2 e", given=2 * e, latex=("b_1",)),
    Variable(nearest, "least focal distance over a, a sum of its own", given=1 - e),
    Variable(
        rho,
        "radius CD",
        LENGTH,
        given=focal_radius.subs(theta, phi5),
        latex=(r"\rho(\varphi_5)", r"\rho"),
    ),
    Variable(
        omega1,
        "angular velocity of the carrier",
        FREQUENCY,
        Interval.open(0, oo),
        latex=(r"\omega_1",),
    ),
    Variable(omega3, "angular velocity of wheel 3", FREQUENCY, latex=(r"\omega_3",)),
    Variable(at_b, "coordinate of B on the line A-C", LENGTH),
    Variable(at_c, "coordinate of C", LENGTH, Interval.open(0, oo)),
    Variable(at_d, "coordinate of D", LENGTH),
    Variable(AC, "from A to C", LENGTH, given=at_c, latex=("AC",)),
    Variable(BC, "from C to B", LENGTH, given=at_b - at_c, latex=("BC",)),
    Variable(CD, "from D to C", LENGTH, given=at_c - at_d, latex=("CD",)),
    Variable(BD, "from D to B", LENGTH, given=at_b - at_d, latex=("BD",)),
    Variable(DE, "from E to D", LENGTH, given=at_d, latex=("DE",)),
    Variable(
        VC, "velocity of C, positive with the carrier", SPEED, given=omega1 * at_c, latex=("V_C",)
    ),
    Variable(
        VD, "velocity of D, positive with the carrier", SPEED, given=omega3 * at_d, latex=("V_D",)
    ),
    Variable(U, "tg(x/2) as a variable of integration's limit"),
    Variable(C, "constant of integrals that start at 0", given=S.Zero, latex=("C",)),
    *TYPE_A_VARIABLES,
    Variable(ratio_symbol, "analogue of the angular velocity", latex=(r"\varphi_3'",)),
    Variable(
        slope, "derivative of the position function", latex=(r"\frac{d\varphi_3}{d\varphi_1}",)
    ),
    *ENCODER_VARIABLES,
    Variable(turns, "whole turns of x", within=S.Naturals0),
    Variable(nu, "number of terms of a series", within=Interval.open(0, oo)),
    Variable(E, "e**nu", within=Interval.open(0, oo)),
    Variable(T, "nu*x", ANGLE),
)
# Integrals without limits start at 0, where phi10 = phi30 = 0.
NOTATION = Notation(factors=("a",), lower_limit=S.Zero)
READER = Reader(VARIABLES, NOTATION)

BRANCH = Part("|x| < pi, the first branch of the half-angle", {x: Interval.open(-pi, pi)})
UP_TO_ONE = Part("0 <= e <= 1", {e: Interval(0, 1)})
BELOW_ONE = Part("0 <= e < 1", {e: Interval.Ropen(0, 1)})

# The mechanics --------------------------------------------------------------------------------

# Velocity plan on the line A-C at one instant. The carrier turns about A = E = 0, the satellite
# rolls inside the fixed epicycle, so the point B at the coordinate R1 is at rest.
s, omega_satellite, omega_out = symbols("s omega_5 omega_3", real=True)
centre_c = solve(Eq(at_c + R2, R1), at_c)[0]
satellite_velocity = omega1 * centre_c + omega_satellite * (s - centre_c)
rolling = solve(satellite_velocity.subs(s, R1), omega_satellite)[0]
point_d = centre_c - rho
PLACES = {at_b: R1, at_c: centre_c, at_d: point_d}
driven = Eq(omega_out * point_d, satellite_velocity.subs({s: point_d, omega_satellite: rolling}))
ratio_by_plan = solve(driven, omega_out)[0] / omega1

# Inversion (Willis), in units of omega1: seen from the carrier the epicycle turns with -1, an
# internal mesh keeps the sense of rotation, an external one reverses it.
satellite_against_carrier = -k
wheel_3_against_carrier = -satellite_against_carrier * rho / (2 * a - rho)
ratio_by_inversion = 1 + wheel_3_against_carrier


def radius_of_mate(angle: Expr) -> Expr:
    """Radius of the congruent ellipse at the angle it has reached by rolling from its far end.

    It has turned by angle + 2 delta, tan(delta) = y/x below; its polar angle is measured from
    the side away from its own centre of rotation.
    """
    y, x_ = e * sin(angle), 1 - e * cos(angle)
    cos_2delta = (x_**2 - y**2) / (x_**2 + y**2)
    sin_2delta = 2 * x_ * y / (x_**2 + y**2)
    cos_turned = cos(angle) * cos_2delta - sin(angle) * sin_2delta
    return a * (1 - e**2) / (1 + e * cos_turned)


# Position: the ratio integrated from phi10 = 0, phi30 = 0, over any number of turns.
position = Integral(ratio_by_inversion.subs(rho, focal_radius.subs(theta, k * tau)), (tau, 0, phi1))
position_closed = (1 + k) * phi1 + 2 * atan2(e * sin(x), 1 - e * cos(x))
position_principal = phi1 + 2 * atan((1 + e) / (1 - e) * tan(x / 2))

# Planar vectors for the sentences of the velocity plan.
axis_c = Matrix([cos(phi1), sin(phi1)]) * centre_c
axis_b = Matrix([cos(phi1), sin(phi1)]) * R1
quarter_turn = Matrix([[0, -1], [1, 0]])
velocity_c = diff(axis_c, phi1)
velocity_b = velocity_c + (rolling / omega1) * quarter_turn * (axis_b - axis_c)

# Non-uniformity of the ratio, (largest - smallest)/mean.
largest = 1 + k * (1 + e) / (1 - e)
smallest = 1 + k * (1 - e) / (1 + e)
non_uniformity = (largest - smallest) / (1 + k)

# What the paper prints ------------------------------------------------------------------------

EQUATION_8 = Equation(
    "(8)",
    r"\frac{d\varphi_3}{d\varphi_1}=1+\frac{R_1}{R_2}\cdot"
    r"\left(\frac{1-e^2}{1+e^2-2e\cos\varphi_5}\right)",
    derived={slope: ratio_by_plan},
    marks=("inferred",),
)
CORRECT_FOURTH = (
    r"\int\frac{dx}{\cos^2\frac x2\cdot\left[(a_1+b_1)\,\mathrm{tg}^2\frac x2+(a_1-b_1)\right]}"
)
LAST_OF_10 = (
    r"\frac{2}{a_1+b_1}\int\frac{d\,\mathrm{tg}\frac x2}"
    r"{\mathrm{tg}^2\frac x2+\frac{a_1-b_1}{a_1+b_1}}"
)
CORRECT_12 = (
    r"\varphi_3=\left(1+\frac{R_1}{R_2}\right)\varphi_1+2\,\mathrm{arctg}"
    r"\frac{e\sin x}{1-e\cos x}"
)
EQUATION_12 = Equation(
    "(12)",
    r"\varphi_3=\varphi_1+2\cdot\sqrt{\frac{1-e}{1+e}}\;\mathrm{arctg}\left(\mathrm{tg}"
    r"\left(\frac{R_1}{2R_2}\varphi_1\right)\cdot\sqrt{\frac{1+e}{1-e}}\right)",
    note=(
        "As a1 +- b1 = (1 +- e)^2, the root in (11) is (1+e)/(1-e) itself, but (12) still has "
        "the root of that. Without it the factor before the arctangent is 2 and the quotient "
        "inside is (1+e)/(1-e). Besides, the arctangent falls back after each turn."
    ),
    corrected=Correction(CORRECT_12),
    singular=("R1 phi1/R2 = (2m+1) pi",),
    derived={phi3: position},
)
DX_SUPPLIED = Claim(
    "(10), third equals sign, dx supplied",
    r"\int\frac{dx}{(a_1+b_1)\sin^2\frac x2+(a_1-b_1)\cos^2\frac x2}="
    r"\int\frac{\cos^2\frac x2\,dx}{(a_1+b_1)\,\mathrm{tg}^2\frac x2+(a_1-b_1)}",
    note="With the missing differential supplied the numerator is still wrong.",
    corrected=Correction(CORRECT_FOURTH),
    on=BRANCH,
    marks=("ours",),
)
_, print_8 = READER.members(EQUATION_8)
_, print_12 = READER.members(EQUATION_12)

# Table 1: R1, R2, e.
VARIANTS = {
    1: (66, 16, Rational("0.28")),
    2: (66, 16, Rational("0.475")),
    3: (80, 30, Rational("0.28")),
    4: (80, 30, Rational("0.475")),
}
ROWS = (
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
        signs={
            1: Sign(note="Introduces the analogue of the velocity."),
            2: Sign(note="Introduces the derivative of the position, by the chain rule."),
            3: Sign(
                derived={slope: omega3 / omega1},
                note="V_C = omega1 AC and V_D = omega3 DE, all signed on the line A-C.",
                marks=("inferred",),
            ),
            4: Sign(
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
        signs={
            1: Sign(
                derived={AC: centre_c},
                note="Circle 5 touches circle 4 from inside: AC + R2 = R1.",
                marks=("inferred",),
            ),
            2: Sign(
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
        signs={
            1: Sign(note="Introduces the radius of wheel 6 in the direction of D."),
            2: Sign(
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
    Equation("(5)", r"BD=BC+CD=R_2+\rho", signs={2: Sign(derived=PLACES, marks=("inferred",))}),
    Equation("(6)", r"DE=AC-CD=2a-\rho", signs={2: Sign(derived=PLACES, marks=("inferred",))}),
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
    Equation(
        "(9)",
        r"\varphi_3=\varphi_1+(1-e^2)\cdot\int\frac{1}{1+e^2-2e\cos\frac{R_1}{R_2}\varphi_1}"
        r"\,d\frac{R_1}{R_2}\varphi_1",
        derived={phi3: position},
        note="Read from the initial conditions phi10 = phi30 = 0; holds over all turns.",
    ),
    *(
        Equation(f"before (10), {name}", latex, says)
        for name, latex, says in (
            ("a_1", "a_1=1+e^2", None),
            ("b_1", "b_1=2e", None),
            ("x", r"x=\frac{R_1}{R_2}\varphi_1", Definition(x, R1 / R2 * phi1)),
        )
    ),
    Equation(
        "(10)",
        r"\int\frac{dx}{a_1-b_1\cos x}"
        r"=\int\frac{dx}{a_1\sin^2\frac x2+a_1\cos^2\frac x2-b_1\cos^2\frac x2+b_1\sin^2\frac x2}"
        r"=\int\frac{dx}{(a_1+b_1)\sin^2\frac x2+(a_1-b_1)\cos^2\frac x2}"
        r"=\int\frac{\cos^2\frac x2}{(a_1+b_1)\,\mathrm{tg}^2\frac x2+(a_1-b_1)}"
        r"=\frac{2}{a_1+b_1}\int\frac{d\,\mathrm{tg}\frac x2}"
        r"{\mathrm{tg}^2\frac x2+\frac{a_1-b_1}{a_1+b_1}}",
        signs={
            3: Sign(
                note="The factor 1/cos^2(x/2) has moved into the numerator and dx is missing.",
                corrected=Correction(CORRECT_FOURTH),
                on=BRANCH,
            ),
            4: Sign(
                note="Its left-hand side is the ill-formed integral; the right-hand side is sound.",
                corrected=Correction(f"{CORRECT_FOURTH}={LAST_OF_10}"),
                on=BRANCH,
            ),
        },
    ),
    DX_SUPPLIED,
    Claim(
        "(10), first and last expression",
        rf"\int\frac{{dx}}{{a_1-b_1\cos x}}={LAST_OF_10}",
        note=(
            "Read as integrals from 0. The chain's end is right although its fourth "
            "expression is not."
        ),
        holds_on=BRANCH,
        marks=("inferred",),
    ),
    Claim(
        "since e <= 1",
        r"\frac{a_1-b_1}{a_1+b_1}\ge0\text{ since }e\le1",
        on=UP_TO_ONE,
    ),
    Claim(
        "since e <= 1, used for (11)",
        r"e\le1\text{ lets (11) divide by }\sqrt{\tfrac{a_1-b_1}{a_1+b_1}}",
        Holds(Gt((a1 - b1) / (a1 + b1), 0)),
        note="(11) divides by the root: e = 1 must be excluded.",
        on=UP_TO_ONE,
        holds_on=BELOW_ONE,
        marks=("inferred",),
    ),
    Equation(
        "(11)",
        rf"{LAST_OF_10}=\frac{{2}}{{a_1+b_1}}\cdot\sqrt{{\frac{{a_1+b_1}}{{a_1-b_1}}}}\cdot"
        r"\mathrm{arctg}\frac{\mathrm{tg}\frac x2}{\sqrt{\frac{a_1-b_1}{a_1+b_1}}}+C",
        substituted={tan(x / 2): U},
        note="As an integral over tg(x/2) = U; C = 0 for the lower limit 0.",
    ),
    Claim(
        "(11) over all turns",
        r"\int_0^x\frac{dx}{a_1-b_1\cos x}=\frac{2}{a_1+b_1}\sqrt{\frac{a_1+b_1}{a_1-b_1}}\,"
        r"\mathrm{arctg}\frac{\mathrm{tg}\frac x2}{\sqrt{\frac{a_1-b_1}{a_1+b_1}}}",
        note="With one constant C the right-hand side falls back at every odd multiple of pi.",
        holds_on=BRANCH,
        singular=("x = (2m+1) pi",),
        corrected=Correction(
            r"\frac{1}{1-e^2}\left(x+2\,\mathrm{arctg}\frac{e\sin x}{1-e\cos x}\right)"
        ),
        marks=("inferred",),
    ),
    EQUATION_12,
    Claim(
        "(12), first branch",
        r"\text{(12) for }|x|<\pi",
        Equality(print_12, position),
        note="The error is not only one of branches.",
        corrected=Correction(
            r"\varphi_3=\varphi_1+2\,\mathrm{arctg}\left(\frac{1+e}{1-e}\,"
            r"\mathrm{tg}\left(\frac{R_1}{2R_2}\varphi_1\right)\right)",
            Equality(position_principal, position),
        ),
        on=BRANCH,
        marks=("ours",),
    ),
    Claim(
        "(12), initial conditions",
        r"\varphi_{10}=0,\ \varphi_{30}=0",
        Equality(print_12.subs(phi1, 0), S.Zero),
    ),
    Claim(
        "half-angle arctangent without branches",
        r"2\,\mathrm{arctg}\left(\tfrac{1+e}{1-e}\mathrm{tg}\tfrac x2\right)="
        r"x+2\,\mathrm{arctg}\frac{e\sin x}{1-e\cos x}",
        on=BRANCH,
        note="The right-hand side goes on beyond the branch.",
        marks=("ours",),
    ),
)

TYPE_A_EQUATIONS = EQUATION_13, EQUATION_14, EQUATION_15, EQUATION_16 = (
    mean_row("(13)", "The mean of the readings; a definition."),
    variance_row("(14)"),
    variance_of_mean_row("(15)", r"s^2(q)=\frac{s^2(q_k)}{n}"),
    uncertainty_row("(16)", "The GUM's type A standard uncertainty of the mean."),
)
TYPE_A_ROWS = (
    EQUATION_13,
    EQUATION_14,
    unbiased_row("(14)"),
    EQUATION_15,
    estimate_row("(15)"),
    EQUATION_16,
)
