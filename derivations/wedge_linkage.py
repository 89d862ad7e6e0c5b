"""Paper 4: pusher, lever, rod, roller lever and wedge, split into four Assur groups.

Order of the file: symbols; the groups rebuilt from their vector equations, each with its
assembly branch; sizes, legible and reconstructed; what the paper prints, row by row; the
quantities.

Conventions: x to the right, y upwards; angles from Ox, positive counter-clockwise; x_i, y_i and
varphi_i are displacements and rotations from the position x1 = 0; lengths in mm, angles in rad.
"""

# The symbols keep the paper's letters.

from collections.abc import Callable, Iterable, Mapping, Sequence

import sympy as sp
from sympy import Rational, cos, pi, sin, sqrt

from mechproof.record import (
    LENGTH,
    Argument,
    Bar,
    Claim,
    Completion,
    Completions,
    Conjunction,
    Definition,
    Equality,
    Equation,
    Form,
    Holds,
    Paper,
    Part,
    PrintedNumber,
    Quantity,
    Reading,
    Statement,
    Variable,
)

# Symbols --------------------------------------------------------------------------------------

x1, x5, y9 = sp.symbols("x1 x5 y9", real=True)
x5_driven = sp.Symbol("x5'", real=True)
phi2, phi3, phi7 = sp.symbols("varphi2 varphi3 varphi7", real=True)
l_AB, l_BC, l_CD, l_DE, l_EF = sp.symbols("l_AB l_BC l_CD l_DE l_EF", positive=True)
l_GH, l_IK, l_KL, l_LM, l_MN = sp.symbols("l_GH l_IK l_KL l_LM l_MN", positive=True)
l_FG, l_HI, l_NP = sp.symbols("l_FG l_HI l_NP", positive=True)
alpha_DE, alpha_KL, alpha_LM = sp.symbols("alpha_DE alpha_KL alpha_LM", real=True)
dBC, dFG, dHI, dPN = sp.symbols("delta_BC delta_FG delta_HI delta_PN", real=True)
Q, R = sp.symbols("Q R", real=True)
overlap = sp.Symbol("x5-l_GH", real=True)
phi3_x1, phi7_x5, clearance = sp.symbols("varphi3(x1) varphi7(x5) l_G'H''", real=True)
millimetre = sp.Symbol("mm", positive=True)
stages, ratio = sp.symbols("n k", positive=True)
tau, sigma, kappa = sp.symbols("tau sigma kappa", real=True)
guide_square, height_square = sp.symbols("guide_square height_square", real=True)

reach, h3, height, h7 = sp.symbols("reach h3 height h7", positive=True)

# Steps of the kernels, in the order of the chain.
arm, guide_length, guide_sum = sp.symbols("arm guide_length guide_sum", real=True)
run, push, rise, rise_sum = sp.symbols("run push rise rise_sum", real=True)
lever_square, roller_square = sp.symbols("lever_square roller_square", real=True)
cos_lever, sin_arm, cos_wedge, gain = sp.symbols("cos_lever sin_arm cos_wedge gain", real=True)
sin_DE, cos_DE, sin_LM, cos_LM = sp.symbols("sin_DE cos_DE sin_LM cos_LM", real=True)
start_height, to_right, to_left = sp.symbols("start_height to_right to_left", real=True)
# The chain as the paper's equations have it: what the kernels are measured against.
lever, travel, contact, offset, roller, engaged = sp.symbols(
    "turn_3 travel_5 driven_5 KL_x turn_7 engaged", real=True
)

Table = Mapping[sp.Symbol, tuple[str, str, str]]
Signs = Mapping[sp.Symbol, int]

POSITIVE = sp.Interval.open(0, sp.oo)
LENGTHS = {
    l_AB: "length of AB, pusher to foot of the guide",
    l_BC: "length of BC at x1 = 0",
    l_CD: "length of CD",
    l_DE: "length of DE, arm of the lever",
    l_EF: "length of EF on the rod",
    l_GH: "clearance between the rod 5 and the link 5'",
    l_IK: "length of IK on the link 5'",
    l_KL: "length of KL, driven arm of the roller lever",
    l_LM: "length of LM, driving arm of the roller lever",
    l_MN: "length of MN on the wedge",
    l_FG: "length of FG at x1 = 0",
    l_HI: "length of HI at x1 = 0",
    l_NP: "length of NP at x1 = 0",
    millimetre: "the unit of length",
}
DISPLACEMENTS = {
    x1: "displacement of the pusher",
    x5: "displacement of the rod; in (6)-(8) of the link 5'",
    x5_driven: "displacement of the link 5' after the clearance",
    y9: "displacement of the wedge",
    dBC: "change of the length BC",
    dFG: "change of the length FG",
    dHI: "change of the length HI",
    dPN: "change of the length NP",
}
ROTATIONS = {
    phi2: "rotation of link 2",
    phi3: "rotation of the lever",
    phi7: "rotation of the roller lever",
    phi3_x1: "rotation of the lever as a function of x1",
    phi7_x5: "rotation of the roller lever as a function of x5",
    alpha_DE: "direction of DE at x1 = 0",
    alpha_LM: "direction of LM at x1 = 0",
}
PRINTED_Q = sqrt(l_BC**4 + x1 * l_BC**2 * (2 * l_CD + 2 * l_AB + x1))
PRINTED_R = l_KL * cos(alpha_KL) - x5


def turn(angle: sp.Expr) -> sp.Matrix:
    """Return the matrix that turns a vector counter-clockwise."""
    return sp.Matrix([[cos(angle), -sin(angle)], [sin(angle), cos(angle)]])


def towards(angle: sp.Expr) -> sp.Matrix:
    """Return the unit vector of a direction."""
    return sp.Matrix([cos(angle), sin(angle)])


RIGHT, UP = towards(0), towards(pi / 2)

# The mechanics --------------------------------------------------------------------------------

# Group 1. Lever 3 carries BC as a guide; A moves with the pusher, D is fixed. AB and CD point to
# the left at x1 = 0 and BC downwards; the guide gets longer by delta_BC.
guide = l_BC + dBC
lever_at_start = (l_AB + l_CD) * -RIGHT
from_a_to_d = lever_at_start + l_BC * -UP - x1 * RIGHT
group_1 = turn(phi3) * (lever_at_start + guide * -UP) - from_a_to_d

# The turn keeps the length of AD, which fixes the guide; branch: BC does not turn over, its
# length stays positive. Then both projections are linear in cos and sin.
guide_now = sp.Symbol("BC", positive=True)
turned_length = (l_AB + l_CD) ** 2 + guide_now**2
guide_squared = sp.solve(sp.Eq(turned_length, from_a_to_d.dot(from_a_to_d)), guide_now**2)[0]
cosine, sine = sp.symbols("cosine sine", real=True)
linear = group_1.subs({cos(phi3): cosine, sin(phi3): sine, dBC: guide_now - l_BC})
solved = sp.solve(list(linear), [cosine, sine], dict=True)[0]
lever_cosine, lever_sine = (
    solved[part].subs(guide_now, sqrt(sp.expand(guide_squared))) for part in (cosine, sine)
)
lever_angle = sp.atan2(lever_sine, lever_cosine)

# Group 2. EF stays level on the rod, FG vertical; the rod moves by x5 along Ox.
from_d_to_g = l_DE * towards(alpha_DE) + l_EF * RIGHT + l_FG * UP + x5 * RIGHT
group_2 = l_DE * towards(alpha_DE + phi3) + l_EF * RIGHT + (l_FG + dFG) * UP - from_d_to_g
rod = sp.solve(group_2[0], x5)[0]

# Clearance. Link 5' is pushed only, and not before the rod has run through the clearance.
driven = (overlap + sp.Abs(overlap)) / 2

# Group 3. H moves with the link 5' by x5', HI stays vertical and IK level; L is fixed.
from_h_to_l = l_HI * UP + l_IK * RIGHT + l_KL * towards(alpha_KL) - x5_driven * RIGHT
group_3 = (l_HI + dHI) * UP + l_IK * RIGHT + l_KL * towards(alpha_KL + phi7) - from_h_to_l

# Branch: KL points upwards as at x1 = 0, so that its direction is 2*atan(tau), tau >= 0 (or
# pi - 2*atan(sigma), sigma >= 0). Ox of (6) then gives the displacement that belongs to it.
direction_tau, direction_sigma = 2 * sp.atan(tau), pi - 2 * sp.atan(sigma)
cosine_of_tau, cosine_of_sigma = (1 - tau**2) / (1 + tau**2), (sigma**2 - 1) / (sigma**2 + 1)
sine_of_tau = 2 * tau / (1 + tau**2)
displacement = sp.solve(group_3[0], x5_driven)[0]
displacement = {
    parameter: displacement.subs(cos(alpha_KL + phi7), value)
    for parameter, value in ((tau, cosine_of_tau), (sigma, cosine_of_sigma))
}

# Group 4. MN stays vertical on the wedge, NP level; the wedge moves by y9 along Oy.
from_l_to_p = l_LM * towards(alpha_LM) + l_MN * -UP + l_NP * RIGHT + y9 * UP
group_4 = l_LM * towards(alpha_LM + phi7) + l_MN * -UP + (l_NP + dPN) * RIGHT - from_l_to_p
wedge = sp.solve(group_4[1], y9)[0]

# What the paper prints ------------------------------------------------------------------------

print_ox1 = (
    l_AB * cos(pi + phi3) + (l_BC + dBC) * cos(phi3 + 3 * pi / 2) + l_CD * cos(pi + phi3)
) + (l_CD + l_AB + x1)
print_oy1 = (
    l_AB * sin(pi + phi3) + (l_BC + dBC) * sin(phi3 + 3 * pi / 2) + l_CD * sin(pi + phi3)
) + l_BC
print_1_top = -(x1 + l_AB) * Q + l_CD * (l_BC**2 - Q) + l_BC**2 * l_AB
print_1_bottom = l_BC * ((l_AB + l_CD) * (l_AB + l_CD + x1) + Q)
print_1 = sp.atan(print_1_top / print_1_bottom)
print_2_ox = l_DE * cos(alpha_DE + phi3) + l_EF - (l_DE * cos(alpha_DE) + l_EF + x5)
print_2_oy = l_DE * sin(alpha_DE + phi3) + dFG - l_DE * sin(alpha_DE)
print_3 = l_DE * (cos(alpha_DE + phi3) - cos(alpha_DE))
print_6_ox = l_KL * cos(alpha_KL + phi7) - (l_KL * cos(alpha_KL) - x5)
print_6_oy = dHI + l_KL * sin(alpha_KL + phi7) - l_KL * sin(alpha_KL)
print_7 = -alpha_KL + sp.atan(sqrt(l_KL**2 - R**2) / R)
print_8 = pi - alpha_KL + sp.atan(sqrt(l_KL**2 - R**2) / R)
print_9_ox = l_LM * cos(alpha_LM + phi7) + dPN - l_LM * cos(alpha_LM)
print_9_oy = l_LM * sin(alpha_LM + phi7) - (l_LM * sin(alpha_LM) + y9)
print_10 = l_LM * (sin(phi7 + alpha_LM) - sin(alpha_LM))

# The half-angle forms: what the kernels compute.
radicand = l_BC**2 + x1 * (2 * (l_AB + l_CD) + x1)
half_3 = -x1 / (l_BC + sqrt(radicand))
half_7 = x5 / (l_KL * sin(alpha_KL) + height)
root_7 = sqrt(l_KL**2 - PRINTED_R**2)


def by_half_angle(expression: sp.Expr, angle: sp.Symbol, tangent: sp.Expr) -> sp.Expr:
    """Put the tangent of half an angle into sines and cosines of sums with it."""
    expanded = sp.expand_trig(expression)
    cosine, sine = (1 - tangent**2) / (1 + tangent**2), 2 * tangent / (1 + tangent**2)
    return expanded.subs({cos(angle): cosine, sin(angle): sine})


def upright(expression: sp.Expr) -> sp.Expr:
    """Give alpha_KL by the tangent kappa of its half, as the direction of KL by tau."""
    placed = expression.subs({x5: displacement[tau], height: l_KL * sine_of_tau})
    by_tangent = by_half_angle(placed, alpha_KL, kappa)
    return by_tangent.subs(alpha_KL, 2 * sp.atan(kappa))


MOVABLE = Part("the radicand of Q is positive", where=(radicand > 0,))
BEFORE_PIVOT = Part(
    "x1 > -(l_AB + l_CD), A has not passed D", where=(x1 > -l_AB - l_CD, radicand > 0)
)
FIRST_QUADRANT = Part("R > 0", {tau: sp.Interval.Ropen(0, 1)})
SECOND_QUADRANT = Part("R < 0", {sigma: sp.Interval.Ropen(0, 1)})

# Sizes: nominal, upper and lower limit deviation (mm, degrees), as text. What is legible, and two
# reconstructions; in both, lost upper deviations are +1.22 (BC) and, in the first, 0 (CD).
CALIBRATED = {
    l_AB: ("6.25", "0", "0"),
    l_BC: ("49.75", "1.22", "-1.22"),
    l_CD: ("38", "0", "-2.06"),
    l_DE: ("83", "0.92", "-1.05"),
    l_GH: ("2", "1.03", "-0.72"),
    l_KL: ("60", "0.2", "-0.2"),
    l_LM: ("145", "0.1", "-0.1"),
    alpha_DE: ("283.06", "0.62", "-1.10"),
    alpha_KL: ("65", "0.24", "-0.25"),
    alpha_LM: ("123.48", "0", "0"),
}
ALTERNATIVE = {
    **CALIBRATED,
    l_BC: ("39.75", "1.22", "-1.22"),
    l_CD: ("28", "1.19", "-2.06"),
    l_DE: ("70.83", "0.92", "-1.05"),
}
FIRST_SET = "the set with l_BC = 49.75, l_CD = 38, l_DE = 83"
SECOND_SET = "the set with l_BC = 39.75, l_CD = 28, l_DE = 70.83"

# Symbol, what is printed of it, the value taken for the row, is it uncertain?
LEGIBLE = (
    (l_AB, r"l_{AB}=6.25", "6.25", "", False),
    (l_BC, r"l_{BC}=19.75_{-1.22}", "19.75", "Digits uncertain, upper deviation lost.", True),
    (l_CD, r"l_{CD}=38_{-2.06}", "38", "Upper deviation lost.", True),
    (l_DE, r"l_{DE}=70.833\ (83)^{+0.92}_{-1.05}", "70.833", "Two strings, 70,833 and 83.", True),
    (l_EF, r"l_{EF}=4\pm0.3", "4", "Digits uncertain; without influence.", True),
    (l_GH, r"l_{GH'}=2^{+1.03}_{-0.72}", "2", "The primes vary from place to place.", True),
    (l_KL, r"l_{KL}=60\pm0.2", "60", "", False),
    (l_LM, r"l_{LM}=145\pm0.1", "145", "The sign of the lower deviation is lost.", True),
)
LEGIBLE_ANGLES = (
    (alpha_DE, r"\alpha_{DE}=283.06^{\circ\,+0.62}_{\;\;-1.10}", "283.06"),
    (alpha_KL, r"\alpha_{KL}=65^{\circ\,+0.24}_{\;\;-0.25}", "65"),
    (alpha_LM, r"\alpha_{LM}=123.48^\circ", "123.48"),
)
LOST = (
    (l_IK, r"l_{IK}=z1_{-0.3}", "Digits and upper deviation lost; without influence."),
    (l_MN, r"l_{MN}=\dots^{+0.00}_{-0.17}", "Digits lost; without influence."),
)
TOLERANCED = (l_BC, l_CD, l_DE, l_EF, l_GH, l_IK, l_KL, l_LM, l_MN, alpha_DE, alpha_KL)

# "+" is the upper limit, "-" the lower; what is not named is at its nominal value.
BOUNDARY_II = {
    l_BC: 1, l_CD: -1, l_DE: -1, l_GH: 1, l_KL: 1, l_LM: -1, alpha_DE: 1, alpha_KL: 1,
}  # fmt: skip
BOUNDARY_III = {size: -sign for size, sign in BOUNDARY_II.items()}
BOUNDARY_IV = {**BOUNDARY_III, alpha_KL: 1}
LENGTHS_OF_IV = {size: sign for size, sign in BOUNDARY_III.items() if str(size).startswith("l_")}


def limits(table: Table, signs: Signs) -> dict[sp.Symbol, sp.Expr]:
    """Return the exact sizes of a combination: nominal, or at the limit its sign names."""
    sizes = {}
    for size, (nominal, upper, lower) in table.items():
        deviation = {1: upper, -1: lower}.get(signs.get(size, 0), "0")
        unit = pi / 180 if size in (alpha_DE, alpha_KL, alpha_LM) else 1
        sizes[size] = (Rational(nominal) + Rational(deviation)) * unit
    return sizes


def position_of(table: Table, signs: Signs, displacement: int | str) -> sp.Expr:
    """Compose the chain of (1), (3), (4), (7)/(8) and (10) at exact sizes: an exact number."""
    sizes = limits(table, signs)
    # Unevaluated: SymPy would spend seconds on assumptions of numbers that balls decide.
    with sp.evaluate(False):
        turned = print_1.xreplace({Q: PRINTED_Q}).xreplace({**sizes, x1: Rational(displacement)})
        run = driven.xreplace({overlap: print_3.xreplace({**sizes, phi3: turned}) - sizes[l_GH]})
        offset = PRINTED_R.xreplace({**sizes, x5: run})
        direction = sp.atan2(sqrt(sizes[l_KL] ** 2 - offset**2), offset)
        return print_10.xreplace({**sizes, phi7: direction - sizes[alpha_KL]})


def above(table: Table, one: Signs, other: Signs, displacement: int | str) -> Holds:
    """State that curve `one` lies above curve `other` at a displacement (mm)."""
    first, second = (position_of(table, signs, displacement) for signs in (one, other))
    return Holds(sp.Gt(first, second, evaluate=False))


def crossing(table: Table) -> Conjunction:
    """State that curves III and IV change order within half a last place around -29.4 mm."""
    return Conjunction(
        (
            above(table, BOUNDARY_III, BOUNDARY_IV, "-29.45"),
            above(table, BOUNDARY_IV, BOUNDARY_III, "-29.35"),
        )
    )


def spread(table: Table, displacement: int) -> sp.Expr:
    """Return the width between the boundaries II and III or IV."""
    lower = BOUNDARY_III if displacement > Rational("-29.4") else BOUNDARY_IV
    upper = position_of(table, BOUNDARY_II, displacement)
    return sp.Add(upper, -position_of(table, lower, displacement), evaluate=False)


def largest_at_the_end(table: Table) -> Conjunction:
    """State that the spread at -40 mm is not below that at -35, -30, ..., 0 mm."""
    at_the_end = spread(table, -40)
    return Conjunction(
        tuple(
            Holds(sp.Ge(at_the_end, spread(table, displacement), evaluate=False))
            for displacement in range(-35, 1, 5)
        )
    )


def ten_percent(table: Table) -> Conjunction:
    """State that both deviations at -40 mm round to 10 % of the nominal position."""
    nominal, upper, lower = (
        position_of(table, signs, -40) for signs in ({}, BOUNDARY_II, BOUNDARY_IV)
    )
    # The position is negative, so the upper boundary is the smaller one in amount.
    with sp.evaluate(False):
        deviations = (100 * (1 - upper / nominal), 100 * (lower / nominal - 1))
    return Conjunction(tuple(PrintedNumber("10", deviation) for deviation in deviations))


def in_both(statement: Callable[[Table], Statement]) -> Conjunction:
    """State the same of both reconstructions."""
    return Conjunction((statement(CALIBRATED), statement(ALTERNATIVE)))


def differ(statement: Callable[[Table], Statement]) -> Completions:
    """State a claim on which the reconstructions may differ."""
    return Completions(
        Completion(FIRST_SET, statement(CALIBRATED)),
        Completion(SECOND_SET, statement(ALTERNATIVE)),
    )


def signs_of_iv(table: Table) -> Conjunction:
    """State that of four ways to complete IV only -alpha_DE, +alpha_KL is lowest."""
    others = [
        {**LENGTHS_OF_IV, alpha_DE: one, alpha_KL: two} for one, two in ((1, 1), (1, -1), (-1, -1))
    ]
    return Conjunction(
        tuple(
            above(table, other, BOUNDARY_IV, displacement)
            for other in others
            for displacement in (-40, -35)
        )
    )


def radicand_of(displacement: int | str, guide: str) -> sp.Expr:
    """Return the radicand of Q over l_BC**2 at the legible sizes and the length `guide` of BC."""
    sizes = {**limits(CALIBRATED, {}), l_BC: Rational(guide), x1: Rational(displacement)}
    return radicand.subs(sizes)


# Sensitivities, stage by stage ----------------------------------------------------------------

lever_slopes = {
    x1: -cos(phi3) / reach,
    l_AB: (1 - cos(phi3)) / reach,
    l_CD: (1 - cos(phi3)) / reach,
    l_BC: -sin(phi3) / reach,
}
roller_slopes = {
    x5: 1 / (l_KL * sin(alpha_KL + phi7)),
    l_KL: (cos(alpha_KL + phi7) - cos(alpha_KL)) / (l_KL * sin(alpha_KL + phi7)),
    alpha_KL: sin(alpha_KL) / sin(alpha_KL + phi7) - 1,
}


def slope_by_projections(
    projections: Iterable[sp.Expr], unknowns: Sequence[sp.Symbol], size: sp.Symbol
) -> sp.Expr:
    """Return the derivative of the first unknown, from the differentiated equations."""
    rates = {unknown: sp.Dummy(str(unknown)) for unknown in unknowns}
    differentiated = [
        sp.diff(p, size) + sum(sp.diff(p, u) * rate for u, rate in rates.items())
        for p in projections
    ]
    return sp.solve(differentiated, list(rates.values()), dict=True)[0][rates[unknowns[0]]]


def lever_slope(size: sp.Symbol) -> sp.Expr:
    """Return the derivative of varphi3 from both projections of group 1."""
    return slope_by_projections(group_1.subs(dBC, reach - l_BC), (phi3, reach), size)


def roller_slope(size: sp.Symbol) -> sp.Expr:
    """Return the derivative of varphi7 from the projection of group 3 on Ox."""
    return slope_by_projections([group_3[0].subs(x5_driven, x5)], (phi7,), size)


def no_influence(size: sp.Symbol) -> Conjunction:
    """State that no solution of a group, all lengths kept in, changes with the size."""
    outputs = (rod, displacement[tau], wedge, lever_cosine, lever_sine)
    return Conjunction(tuple(Equality(sp.diff(output, size), sp.S.Zero) for output in outputs))


def influence(size: sp.Symbol) -> Conjunction:
    """State that the position at -40 mm differs between the limits of the size, both sets."""
    return in_both(
        lambda table: Holds(
            sp.Ne(
                position_of(table, {size: 1}, -40),
                position_of(table, {size: -1}, -40),
                evaluate=False,
            )
        )
    )


def datum_row(symbol: sp.Symbol, latex: str, value: str, note: str, uncertain: bool) -> Claim:
    """Record a size of the table, as far as it is legible."""
    unit = pi / 180 if symbol in (alpha_DE, alpha_KL, alpha_LM) else millimetre
    return Claim(
        f"sizes, {symbol}",
        latex,
        Definition(symbol, Rational(value) * unit),
        note=note or "A datum.",
        marks=("uncertain",) if uncertain else (),
    )


# The rows -------------------------------------------------------------------------------------

ROWS = (
    Equation(
        "group 1, Ox",
        r"l_{AB}\cos(\pi+\varphi_3)+(l_{BC}+\delta_{BC})\cos(\varphi_3+\tfrac{3\pi}2)"
        r"+l_{CD}\cos(\pi+\varphi_3)=-(l_{CD}+l_{AB}+x_1)",
        Equality(print_ox1, group_1[0]),
        note="Left minus right against the turned vectors minus AD.",
    ),
    Equation(
        "group 1, Oy",
        r"l_{AB}\sin(\pi+\varphi_3)+(l_{BC}+\delta_{BC})\sin(\varphi_3+\tfrac{3\pi}2)"
        r"+l_{CD}\sin(\pi+\varphi_3)=-l_{BC}",
        Equality(print_oy1, group_1[1]),
        note="The last pi of the left side is lost in print.",
        marks=("rebuilt",),
    ),
    Equation(
        "(1), Q",
        r"Q=\left[l_{BC}^4+x_1l_{BC}^2(2l_{CD}+2l_{AB}+x_1)\right]^{1/2}",
        Equality(PRINTED_Q, l_BC * sqrt(guide_squared)),
        note="Q is l_BC (l_BC + delta_BC); the exponents are rebuilt.",
        marks=("rebuilt",),
    ),
    Equation(
        "(1)",
        r"\varphi_3(x_1)=\arctan\frac{-(x_1+l_{AB})Q+l_{CD}(l_{BC}^2-Q)+l_{BC}^2l_{AB}}"
        r"{l_{BC}\left[(l_{AB}+l_{CD})(l_{AB}+l_{CD}+x_1)+Q\right]}",
        Equality(print_1, lever_angle),
        note="Against the two-argument arctangent of the solved projections.",
        on=BEFORE_PIVOT,
        marks=("rebuilt",),
    ),
    Claim(
        "(1), wherever the linkage can move",
        r"\arctan\text{ of (1)}=\text{direction of the lever wherever the radicand is positive}",
        Equality(print_1, lever_angle),
        note="Beyond a right angle of the lever the arctangent is off by pi.",
        on=MOVABLE,
        holds_on=BEFORE_PIVOT,
        marks=("rebuilt", "ours"),
    ),
    Claim(
        "(1), where the arctangent is right",
        r"(l_{AB}+l_{CD})(l_{AB}+l_{CD}+x_1)+Q=\left[(l_{AB}+l_{CD}+x_1)^2+l_{BC}^2\right]"
        r"\cos\varphi_3",
        Equality(
            (l_AB + l_CD) * (l_AB + l_CD + x1) + PRINTED_Q,
            ((l_AB + l_CD + x1) ** 2 + l_BC**2) * lever_cosine,
        ),
        note="The denominator of (1) has the sign of the cosine: (1) holds exactly where it is "
        "positive.",
        marks=("rebuilt", "ours"),
    ),
    Claim(
        "(1), half-angle form",
        r"\varphi_3=-2\arctan\frac{x_1}{l_{BC}+\sqrt{l_{BC}^2+x_1(2l_{AB}+2l_{CD}+x_1)}}",
        Equality(
            sp.Matrix([2 * half_3 / (1 + half_3**2), (1 - half_3**2) / (1 + half_3**2)]),
            sp.Matrix([lever_sine, lever_cosine]),
        ),
        note="Sine and cosine of the form are those of the solution; twice an arctangent keeps "
        "inside (-pi, pi), so no turn is lost, wherever the radicand is not negative.",
        marks=("ours",),
    ),
    Equation(
        "(2), Ox",
        r"l_{DE}\cos(\alpha_{DE}+\varphi_3)+l_{EF}=l_{DE}\cos\alpha_{DE}+l_{EF}+x_5",
        Equality(print_2_ox, group_2[0]),
    ),
    Equation(
        "(2), Oy",
        r"l_{DE}\sin(\alpha_{DE}+\varphi_3)+\delta_{FG}=l_{DE}\sin\alpha_{DE}",
        Equality(print_2_oy, group_2[1]),
    ),
    Equation(
        "(3)",
        r"x_5(\varphi_3)=l_{DE}\left[\cos(\alpha_{DE}+\varphi_3)-\cos\alpha_{DE}\right]",
        Equality(print_3, rod),
        marks=("rebuilt",),
    ),
    Equation(
        "(4), before contact",
        r"x_{5'}=0\text{ if }x_5<l_{G'H''}",
        Equality(sp.S.Zero, driven),
        on=Part("x5 < l_G'H''", {overlap: sp.Interval.open(-sp.oo, 0)}),
        note="A link that is only pushed.",
        marks=("rebuilt",),
    ),
    Equation(
        "(4), in contact",
        r"x_{5'}=x_5-l_{G'H''}\text{ if }x_5>l_{G'H''}",
        Equality(x5 - l_GH, driven),
        on=Part("x5 > l_G'H''", {overlap: POSITIVE}),
        marks=("rebuilt",),
    ),
    Claim(
        "(4), start of contact",
        r"x_5=l_{G'H''}",
        Equality((x5 - l_GH).subs(x5, l_GH), sp.S.Zero),
        note="Both branches give 0 there, so that < and <= say the same.",
        marks=("uncertain", "ours"),
    ),
    Claim(
        "(4), argument",
        r"x_5(\varphi_2)",
        Completions(
            Completion("the letter is varphi3", Equality(print_3, rod)),
            Completion("the letter is varphi2", Equality(print_3.subs(phi3, phi2), rod)),
        ),
        note="Printed three times, where all else has the lever's angle.",
        marks=("rebuilt", "uncertain"),
    ),
    Equation(
        "(5)",
        r"\vec{HI}+\vec{IK}+\vec{KL}=\vec{HL}",
        Equality(
            l_HI * UP + l_IK * RIGHT + l_KL * towards(alpha_KL),
            from_h_to_l.subs(x5_driven, 0),
        ),
        note="At x1 = 0; displaced, its projections are (6).",
    ),
    Equation(
        "(6), Ox",
        r"l_{KL}\cos(\alpha_{KL}+\varphi_7)=l_{KL}\cos\alpha_{KL}-x_5",
        Equality(print_6_ox, group_3[0].subs(x5_driven, x5 - l_GH)),
        note="In contact, the link 5' lags behind the rod by the clearance.",
        readings=(
            Reading(
                "x5 is the displacement of the link 5' after the clearance",
                Equality(print_6_ox.subs(x5, x5_driven), group_3[0]),
            ),
        ),
        marks=("inferred",),
    ),
    Equation(
        "(6), Oy",
        r"\delta_{HI}+l_{KL}\sin(\alpha_{KL}+\varphi_7)=l_{KL}\sin\alpha_{KL}",
        Equality(print_6_oy, group_3[1]),
    ),
    Equation(
        "(7)",
        r"\varphi_7(x_5)=-\alpha_{KL}+\arctan\frac{(l_{KL}^2-R^2)^{1/2}}{R},\ R>0",
        Equality(print_7.subs(R, l_KL * cosine_of_tau), direction_tau - alpha_KL),
        on=FIRST_QUADRANT,
        note="R, the projection of KL, by the direction 2 arctan(tau) of KL.",
        marks=("rebuilt", "inferred"),
    ),
    Equation(
        "(8)",
        r"\varphi_7(x_5)=\pi-\alpha_{KL}+\arctan\frac{(l_{KL}^2-R^2)^{1/2}}{R},\ R<0",
        Equality(print_8.subs(R, l_KL * cosine_of_sigma), direction_sigma - alpha_KL),
        on=SECOND_QUADRANT,
        note="R, the projection of KL, by the direction pi - 2 arctan(sigma) of KL.",
        marks=("rebuilt", "inferred"),
    ),
    Claim(
        "(7) and (8), R",
        r"R=l_{KL}\cos\alpha_{KL}-x_5",
        Conjunction(
            (
                Equality(PRINTED_R.subs(x5, displacement[tau]), l_KL * cosine_of_tau),
                Equality(PRINTED_R.subs(x5, displacement[sigma]), l_KL * cosine_of_sigma),
                Equality(sqrt(l_KL**2 - (l_KL * cosine_of_tau) ** 2), l_KL * sine_of_tau),
            )
        ),
        note="R is the projection of KL on Ox, the root that on Oy, so |R| <= l_KL; R = 0 lies "
        "in neither formula. x5 is that of the link 5'.",
    ),
    Claim(
        "(7) and (8), one form",
        r"\varphi_7=2\arctan\frac{x_5}{l_{KL}\sin\alpha_{KL}+\sqrt{l_{KL}^2-R^2}}",
        Equality(upright(2 * sp.atan(half_7)), direction_tau - 2 * sp.atan(kappa)),
        note="Without a hole at R = 0, for 0 < alpha_KL < pi and KL pointing upwards; equal to "
        "the same right side as (7) and (8).",
        on=Part(
            "alpha_KL = 2 arctan(kappa) in [0, pi), KL upwards",
            {kappa: sp.Interval(0, sp.oo), tau: POSITIVE},
        ),
        marks=("ours",),
    ),
    Equation(
        "(9), Ox",
        r"l_{LM}\cos(\alpha_{LM}+\varphi_7)+\delta_{PN}=l_{LM}\cos\alpha_{LM}",
        Equality(print_9_ox, group_4[0]),
    ),
    Equation(
        "(9), Oy",
        r"l_{LM}\sin(\alpha_{LM}+\varphi_7)=l_{LM}\sin\alpha_{LM}+y_9",
        Equality(print_9_oy, group_4[1]),
    ),
    Equation(
        "(10)",
        r"y_9(\varphi_7)=l_{LM}\left[\sin(\varphi_7+\alpha_{LM})-\sin\alpha_{LM}\right]",
        Equality(print_10, wedge),
        marks=("rebuilt",),
    ),
    Claim(
        "chain, rod by half-angle",
        r"x_5=\frac{2l_{DE}x_1(h\sin\alpha_{DE}-x_1\cos\alpha_{DE})}{h^2+x_1^2}",
        Equality(
            2 * l_DE * x1 * (h3 * sin(alpha_DE) - x1 * cos(alpha_DE)) / (h3**2 + x1**2),
            by_half_angle(rod, phi3, -x1 / h3),
        ),
        note="(1) put into (3), h = l_BC + l_BC + delta_BC.",
        marks=("ours",),
    ),
    Claim(
        "chain, wedge by half-angle",
        r"y_9=\frac{2l_{LM}x_5(h\cos\alpha_{LM}-x_5\sin\alpha_{LM})}{h^2+x_5^2}",
        Equality(
            2 * l_LM * x5 * (h7 * cos(alpha_LM) - x5 * sin(alpha_LM)) / (h7**2 + x5**2),
            by_half_angle(wedge, phi7, x5 / h7),
        ),
        note="(7) or (8) put into (10), h = l_KL sin(alpha_KL) + (l_KL^2 - R^2)^(1/2).",
        marks=("ours",),
    ),
    *(
        Claim(
            f"sensitivity of varphi3 to {size}",
            rf"\partial\varphi_3/\partial {size}={sp.latex(slope)}",
            Equality(slope, lever_slope(size)),
            note="From both differentiated projections; reach is l_BC + delta_BC.",
            on=Part("the guide has a length", {reach: POSITIVE}),
            marks=("ours",),
        )
        for size, slope in lever_slopes.items()
    ),
    *(
        Claim(
            f"sensitivity of varphi7 to {size}",
            rf"\partial\varphi_7/\partial {size}={sp.latex(slope)}",
            Equality(slope, roller_slope(size)),
            note="From the differentiated projection on Ox.",
            marks=("ours",),
        )
        for size, slope in roller_slopes.items()
    ),
    *(datum_row(*row) for row in LEGIBLE),
    *(datum_row(*row, "", False) for row in LEGIBLE_ANGLES),
    *(
        Claim(
            f"sizes, {symbol}", latex, Definition(symbol, symbol), note=note, marks=("uncertain",)
        )
        for symbol, latex, note in LOST
    ),
    Claim(
        "sizes, domain of Fig. 4",
        r"Q\text{ is real on }x_1\in[-40,0]",
        Completions(
            Completion(
                "the legible digits l_BC = 19.75, l_CD = 38, at x1 = -40 mm",
                Holds(sp.Ge(radicand_of(-40, "19.75"), 0, evaluate=False)),
            ),
            Completion(
                "one digit changed, l_BC = 49.75, at x1 = -40 mm",
                Holds(sp.Ge(radicand_of(-40, "49.75"), 0, evaluate=False)),
            ),
        ),
        note="The curve of Fig. 4 cannot have been computed with the legible digits.",
        marks=("uncertain", "calibrated"),
    ),
    Claim(
        "sizes, end of the legible ones",
        r"Q\text{ of the legible sizes ends between }x_1=-4.66\text{ and }-4.65",
        Conjunction(
            (
                Holds(sp.Lt(radicand_of("-4.66", "19.75"), 0, evaluate=False)),
                Holds(sp.Gt(radicand_of("-4.65", "19.75"), 0, evaluate=False)),
            )
        ),
        marks=("ours", "uncertain"),
    ),
    Claim(
        "11 sizes with tolerances",
        r"11\text{ sizes with tolerances}",
        Equality(sp.Integer(11), sp.Integer(len(TOLERANCED))),
        note="Counted in the table of sizes.",
    ),
    Claim(
        "combinations",
        r"2^{11}\text{ combinations}",
        Equality(sp.Integer(2) ** 11, 2 ** sp.Integer(len(TOLERANCED))),
        note='Two limits for each size; the exponent is lost in the text that survives, "211".',
        marks=("rebuilt", "uncertain"),
    ),
    Claim(
        "combinations that matter",
        r"2^8\text{ of the }2^{11}\text{ combinations are distinct}",
        Conjunction(
            (
                *(no_influence(size) for size in (l_EF, l_IK, l_MN)),
                *(influence(size) for size in BOUNDARY_II),
            )
        ),
        note="Three of the 11 sizes have no influence, each of the other eight has.",
        marks=("ours", "calibrated"),
    ),
    Claim(
        "boundary II",
        r"\text{upper boundary: }+l_{BC},-l_{CD},-l_{DE},+l_{GH'},+l_{KL},-l_{LM},"
        r"+\alpha_{DE},+\alpha_{KL}",
        differ(lambda table: above(table, BOUNDARY_II, {**BOUNDARY_II, alpha_KL: -1}, -40)),
        note="At x1 = -40 mm, against the same combination with -alpha_KL.",
        marks=("calibrated", "uncertain"),
    ),
    Claim(
        "boundary II, from -37 mm on",
        r"\text{II lies above every combination that differs in one size},"
        r"\ x_1=-37,-30,-20,-10,-5",
        in_both(
            lambda table: Conjunction(
                tuple(
                    above(table, BOUNDARY_II, {**BOUNDARY_II, size: -sign}, displacement)
                    for size, sign in BOUNDARY_II.items()
                    for displacement in (-37, -30, -20, -10, -5)
                )
            )
        ),
        note="Neighbours only, at five positions; all 2^11 combinations are searched in the tests.",
        marks=("calibrated", "uncertain"),
    ),
    Claim(
        "boundary III",
        r"\text{lower boundary on }[-29.4,0]\text{: }-l_{BC},+l_{CD},+l_{DE},-l_{GH'},-l_{KL},"
        r"+l_{LM},-\alpha_{DE},-\alpha_{KL}",
        in_both(
            lambda table: Conjunction(
                tuple(
                    above(table, {**BOUNDARY_III, size: -sign}, BOUNDARY_III, displacement)
                    for size, sign in BOUNDARY_III.items()
                    for displacement in (-29, -20, -10, -5)
                )
            )
        ),
        note="Below every combination that differs in one size, at four positions.",
        marks=("calibrated",),
    ),
    Claim(
        "boundary IV",
        r"\text{lower boundary on }[-40,-29.4]\text{: }-l_{BC},+l_{CD},+l_{DE},-l_{GH'},-l_{KL},"
        r"+l_{LM},\ \alpha_{DE},\alpha_{KL}\text{ lost}",
        in_both(signs_of_iv),
        note="The lost signs can only be -alpha_DE, +alpha_KL; IV then differs from III in "
        "alpha_KL alone.",
        marks=("calibrated", "uncertain"),
    ),
    Claim(
        "crossing",
        r"x_1=-29.4\text{ is the crossing of curves III and IV}",
        in_both(crossing),
        note="The sets were fitted to it: no confirmation.",
        marks=("calibrated", "fitted"),
    ),
    Claim(
        "sizes without influence",
        r"\text{changing }l_{EF},\ l_{IK}\text{ does not influence }y_9(x_1)",
        Conjunction((no_influence(l_EF), no_influence(l_IK))),
        note="Both stay in the vector equations and cancel there.",
    ),
    Claim(
        "third size without influence",
        r"l_{MN}\text{ (or }l_{LM}\text{) does not influence }y_9(x_1)",
        Completions(
            Completion("the damaged letter is l_MN", no_influence(l_MN)),
            Completion("the damaged letter is l_LM", no_influence(l_LM)),
        ),
        marks=("uncertain",),
    ),
    Claim(
        "reason for no influence",
        r"\text{confirmed by the absence of these quantities in the corresponding equations}",
        Conjunction(
            tuple(
                Equality(sp.diff(printed, size), sp.S.Zero)
                for printed in (print_1, print_3, print_7, print_8, print_10)
                for size in (l_EF, l_IK, l_MN)
            )
        ),
        note="Of (1), (3), (7), (8), (10); l_EF is printed on both sides of (2) and cancels.",
        marks=("uncertain",),
    ),
    Claim(
        "largest spread",
        r"\text{the spread is largest at }x_1=-40",
        differ(largest_at_the_end),
        note="Between the boundaries as printed, compared every 5 mm.",
        marks=("calibrated",),
    ),
    Claim(
        "deviation at -40",
        r"\text{the spread reaches }\pm10\,\%\text{ of the nominal position}",
        differ(ten_percent),
        note="At x1 = -40 mm, rounded to whole percent.",
        marks=("calibrated", "fitted"),
    ),
    Claim(
        "all links contribute",
        r"\text{deviations of all intermediate links contribute to the error of the output}",
        Conjunction(tuple(influence(size) for size in (l_CD, l_GH, l_KL))),
        note="Of links: lever 3, rod 5 with its clearance and roller lever 7 each have a size that "
        "contributes; l_EF, l_IK and l_MN do not.",
        marks=("calibrated",),
    ),
    Claim(
        "chain, velocity of the rod",
        r"dx_5/dx_1=l_{DE}\sin(\alpha_{DE}+\varphi_3)\cos\varphi_3/(l_{BC}+\delta_{BC})",
        Conjunction(
            (
                Equality(-l_DE * sin(alpha_DE + phi3), sp.diff(rod, phi3)),
                Equality(-lever_cosine / sqrt(radicand), sp.diff(2 * sp.atan(half_3), x1)),
            )
        ),
        note="The product of both stages.",
        on=MOVABLE,
        marks=("ours",),
    ),
    Claim(
        "chain, velocity of the wedge",
        r"dy_9/dx_5=l_{LM}\cos(\alpha_{LM}+\varphi_7)/(l_{KL}^2-R^2)^{1/2}",
        Conjunction(
            (
                Equality(l_LM * cos(alpha_LM + phi7), sp.diff(wedge, phi7)),
                Equality(1 / root_7, sp.diff(2 * sp.atan(half_7.subs(height, root_7)), x5)),
            )
        ),
        note="The product of both stages; with the rod's, errors multiply along the chain.",
        on=Part("|R| < l_KL", where=(l_KL**2 - PRINTED_R**2 > 0,)),
        marks=("ours",),
    ),
    Claim(
        "more links, larger effect",
        r"\text{the accumulating effect is the larger, the more links the chain has}",
        Completions(
            Completion(
                "each further stage has the ratio k = 2",
                Holds(sp.Gt(sp.Integer(2) ** 5, sp.Integer(2) ** 4, evaluate=False)),
            ),
            Completion(
                "each further stage has the ratio k = 1/2",
                Holds(sp.Gt(Rational(1, 2) ** 5, Rational(1, 2) ** 4, evaluate=False)),
            ),
        ),
        note="Errors are multiplied by the ratio of every later stage, which may be below one.",
    ),
)

# The quantities -------------------------------------------------------------------------------

# The chain by the half-angle forms: x5 by x1 and the sum of both lengths of BC, x5' by Max, y9 by
# x5' and the sum of both heights of K over L. No cancellation at x1 = 0, at the start of contact
# or at R = 0, and no sine or cosine but those of the sizes.
# What the sizes alone decide is a step of its own, computed once for all x1.
STEPS = {
    arm: l_AB + l_CD,
    sin_DE: sin(alpha_DE),
    cos_DE: cos(alpha_DE),
    sin_LM: sin(alpha_LM),
    cos_LM: cos(alpha_LM),
    start_height: l_KL * sin(alpha_KL),
    to_right: 2 * l_KL * sin(alpha_KL / 2) ** 2,
    to_left: 2 * l_KL * cos(alpha_KL / 2) ** 2,
    guide_length: sqrt(l_BC**2 + x1 * (2 * arm + x1)),
    guide_sum: l_BC + guide_length,
    lever_square: guide_sum**2 + x1**2,
    run: 2 * l_DE * x1 * (guide_sum * sin_DE - x1 * cos_DE) / lever_square,
    push: sp.Max(0, run - l_GH),
    rise: sqrt((to_right + push) * (to_left - push)),
    rise_sum: start_height + rise,
    roller_square: rise_sum**2 + push**2,
    cos_lever: (guide_sum - x1) * (guide_sum + x1) / lever_square,
    sin_arm: cos_lever * sin_DE - 2 * guide_sum * x1 * cos_DE / lever_square,
    cos_wedge: ((rise_sum - push) * (rise_sum + push) * cos_LM - 2 * rise_sum * push * sin_LM)
    / roller_square,
    gain: sp.Piecewise((0, run < l_GH), (l_LM * cos_wedge / rise, True)),
}
CHAIN = {
    lever: -2 * sp.atan(x1 / (l_BC + sqrt(radicand))),
    travel: print_3.subs(phi3, lever),
    contact: sp.Max(0, travel - l_GH),
    offset: PRINTED_R.subs(x5, contact),
    roller: sp.atan2(sqrt(l_KL**2 - offset**2), offset) - alpha_KL,
    engaged: sp.Piecewise((0, travel / l_GH < 1), (1, True)),
}
POSITION = print_10.subs(phi7, roller)
DRIVEN = engaged * POSITION  # before contact no size has an influence
POSITION_FORM = 2 * l_LM * push * (rise_sum * cos_LM - push * sin_LM) / roller_square


def step_slopes(size: sp.Symbol) -> dict[sp.Symbol, sp.Expr]:
    """Return the derivatives of the steps of the chain in contact: the proved stage slopes."""
    by_size = {phi3: lever, phi7: roller, reach: guide_length}
    turned = lever_slopes.get(size, sp.S.Zero).subs(by_size)
    moved = sp.diff(print_3.subs(phi3, lever) - l_GH, size) - turned * l_DE * sin(alpha_DE + lever)
    own = roller_slopes.get(size, sp.S.Zero)
    return {
        guide_length: sp.diff(radicand, size) / (2 * guide_length),
        lever: turned,
        roller: (own + roller_slopes[x5] * moved).subs(by_size),
    }


def chain_slope(expression: sp.Expr, size: sp.Symbol) -> sp.Expr:
    """Return the derivative of an expression of the steps by a size or by x1."""
    through = (sp.diff(expression, step) * slope for step, slope in step_slopes(size).items())
    return sp.Add(sp.diff(expression, size), *through)


SIZES = (l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM, alpha_DE, alpha_KL, alpha_LM)
VELOCITY = chain_slope(DRIVEN, x1)
VELOCITY_FORM = gain * l_DE * sin_arm * cos_lever / guide_length
SENSITIVITIES = sp.ImmutableDenseMatrix([chain_slope(DRIVEN, size) for size in SIZES])
BY_ARM = -2 * gain * l_DE * sin_arm * x1**2 / (lever_square * guide_length)
SENSITIVITY_FORMS = {
    l_AB: BY_ARM,
    l_BC: -2 * gain * l_DE * sin_arm * guide_sum * x1 / (lever_square * guide_length),
    l_CD: BY_ARM,
    l_DE: gain * run / l_DE,
    l_GH: -gain,
    l_KL: -gain * push / l_KL,
    l_LM: POSITION_FORM / l_LM,
    alpha_DE: 2 * gain * l_DE * x1 * (guide_sum * cos_DE + x1 * sin_DE) / lever_square,
    alpha_KL: gain * push * (push - to_left + to_right) / rise_sum,
    alpha_LM: -2 * l_LM * push * (rise_sum * sin_LM + push * cos_LM) / roller_square,
}

LENGTH_ARGUMENTS = {
    size: Argument(str(size), (size,), LENGTHS[size], "mm")
    for size in (l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM)
}
ANGLE_ARGUMENTS = {
    angle: Argument(str(angle), (angle,), meaning, "rad")
    for angle, meaning in (
        (alpha_DE, ROTATIONS[alpha_DE]),
        (alpha_KL, "direction of KL at x1 = 0, in (0, pi)"),
        (alpha_LM, ROTATIONS[alpha_LM]),
    )
}
ARGUMENT = {
    x1: Argument("x1", (x1,), DISPLACEMENTS[x1], "mm"),
    **LENGTH_ARGUMENTS,
    **ANGLE_ARGUMENTS,
}
PUSHED = Argument("x5", (x5,), "displacement of the link 5' after the clearance", "mm")
BAZUEV = "Bazuev et al. 2021, equation"
CONTACT = "at the start of contact the derivatives are those in contact"
CONDITION = "|value| + sum of |p * d value/d p| over the arguments p"
CLOSED = Part(
    "the linkage closes", where=(guide_square >= 0, l_KL - offset >= 0, l_KL + offset >= 0)
)
MOVING = Part(
    "the linkage closes and is at no dead centre",
    where=(guide_square > 0, l_KL - offset > 0, l_KL + offset > 0),
)
RANGE = "NaN where the radicand l_BC**2 + x1*(2*(l_AB + l_CD) + x1) is negative or |R| > l_KL"


def arguments(*symbols: sp.Symbol) -> tuple[Argument, ...]:
    """List the arguments of a kernel, the running variable first."""
    return tuple(ARGUMENT[symbol] for symbol in symbols)


def chained(
    name: str,
    summary: str,
    definition: sp.Basic,
    form: sp.Basic,
    unit: str,
    bar: Bar,
    on: Part,
    singular: tuple[str, ...],
) -> Quantity:
    """Make a quantity of the whole chain."""
    return Quantity(
        name,
        summary,
        arguments(x1, *SIZES),
        definition,
        Form("half-angle chain", form, proved_by=f"kernel {name}"),
        "Bazuev et al. 2021, equations (1), (3), (4), (7), (8), (10)",
        unit=unit,
        bar=bar,
        on=on,
        singular=singular,
    )


Slope = Callable[[sp.Expr, sp.Symbol], sp.Expr]


def condition(value: sp.Expr, inputs: Iterable[sp.Symbol], slope: Slope = sp.diff) -> sp.Expr:
    """Return the value's size and what the rounding of every input makes of it."""
    return sp.Abs(value) + sp.Add(*(sp.Abs(s * slope(value, s)) for s in inputs))


def conditioned(ulp: float, value: sp.Expr, inputs: Iterable[sp.Symbol]) -> Bar:
    """Set a bar on the conditioning of a value."""
    return Bar(ulp, CONDITION, condition(value, inputs))


def conditioned_in_contact(ulp: float, value: sp.Basic) -> Bar:
    """Set a bar on the conditioning in contact of a value of the chain, of a column's norm."""
    parts = [condition(part, (x1, *SIZES), chain_slope) for part in sp.Matrix([value])]
    size = parts[0] if len(parts) == 1 else sqrt(sp.Add(*(part**2 for part in parts)))
    norm = "" if len(parts) == 1 else "norm over the entries (each keeps its own) of "
    return Bar(ulp, f"{norm}{CONDITION}, in contact", size.subs(engaged, 1))


# In eps, 1/2 for an operation, 1 for a sine or cosine, 4 for atan (what NumPy's vector loops are
# allowed). An error of a term of a sum is one of the inputs in that term, which the scale has; a
# common factor of the lengths takes what a sum itself rounds.
# lever_angle: seven operations under and after the root, atan.
LEVER_ULP = 8
# rod_displacement, wedge_displacement: two sines, the sum of their angle, two products.
PRODUCT_ULP = 4
# roller_lever_angle: 3.5 for each factor under the root, an error of l_KL and, at most 1.3 times,
# of alpha_KL; root, sine, sum, quotient 4; atan.
ROLLER_ULP = 16
# position: guide 3.5; run 5; push 1/2; rise and its sum 6.5, the share of alpha_KL 0.8 more; the
# last quotient 5: 22 if every step counted in full. Each has only its own share of the scale, and
# searches find less than 1 here; 8 leaves room for a sine that is 4 off. The same for derivatives.
CHAIN_ULP = 8

ROLLER_FORM = 2 * sp.atan(
    x5
    / (
        l_KL * sin(alpha_KL)
        + sqrt((2 * l_KL * sin(alpha_KL / 2) ** 2 + x5) * (2 * l_KL * cos(alpha_KL / 2) ** 2 - x5))
    )
)
ROLLER = sp.atan2(sqrt(l_KL**2 - PRINTED_R**2), PRINTED_R) - alpha_KL

QUANTITIES = (
    Quantity(
        "lever_angle",
        "Compute the rotation phi3 of the lever.",
        arguments(x1, l_AB, l_BC, l_CD),
        CHAIN[lever],
        Form("half-angle atan", -2 * sp.atan(x1 / guide_sum)),
        f"{BAZUEV} (1)",
        unit="rad",
        bar=conditioned(LEVER_ULP, CHAIN[lever], (x1, l_AB, l_BC, l_CD)),
        on=Part("the guide follows the pusher", where=(guide_square >= 0,)),
        singular=("NaN where the radicand l_BC**2 + x1*(2*(l_AB + l_CD) + x1) is negative",),
    ),
    Quantity(
        "rod_displacement",
        "Compute the displacement x5 of the rod.",
        (Argument("phi3", (phi3,), ROTATIONS[phi3], "rad"), *arguments(l_DE, alpha_DE)),
        print_3,
        Form("product", -2 * l_DE * sin(phi3 / 2) * sin(alpha_DE + phi3 / 2)),
        f"{BAZUEV} (3)",
        unit="mm",
        bar=conditioned(PRODUCT_ULP, print_3, (phi3, alpha_DE)),
    ),
    Quantity(
        "clearance",
        "Compute the displacement x5' of the pushed link after the clearance.",
        (Argument("x5", (x5,), DISPLACEMENTS[x5], "mm"), *arguments(l_GH)),
        sp.Max(0, x5 - l_GH),
        Form("maximum", sp.Max(0, x5 - l_GH)),
        f"{BAZUEV} (4)",
        unit="mm",
        bar=Bar(0.5),
    ),
    Quantity(
        "roller_lever_angle",
        "Compute the rotation phi7 of the roller lever.",
        (PUSHED, *arguments(l_KL, alpha_KL)),
        ROLLER,
        Form("half-angle atan", ROLLER_FORM, proved_by="(7) and (8), one form"),
        f"{BAZUEV}s (7) and (8)",
        unit="rad",
        bar=conditioned(ROLLER_ULP, ROLLER, (x5, l_KL, alpha_KL)),
        on=Part("the roller lever follows the link 5'", where=(height_square >= 0,)),
        singular=("NaN where |l_KL*cos(alpha_KL) - x5| > l_KL",),
    ),
    Quantity(
        "wedge_displacement",
        "Compute the displacement y9 of the wedge.",
        (Argument("phi7", (phi7,), ROTATIONS[phi7], "rad"), *arguments(l_LM, alpha_LM)),
        print_10,
        Form("product", 2 * l_LM * sin(phi7 / 2) * cos(alpha_LM + phi7 / 2)),
        f"{BAZUEV} (10)",
        unit="mm",
        bar=conditioned(PRODUCT_ULP, print_10, (phi7, alpha_LM)),
    ),
    chained(
        "position",
        "Compute the displacement y9 of the wedge, the whole chain.",
        POSITION,
        POSITION_FORM,
        "mm",
        conditioned_in_contact(CHAIN_ULP, POSITION),
        CLOSED,
        (RANGE,),
    ),
    chained(
        "velocity",
        "Compute dy9/dx1, the velocity of the wedge at unit speed of the pusher.",
        VELOCITY,
        VELOCITY_FORM,
        "1",
        conditioned_in_contact(CHAIN_ULP, VELOCITY),
        MOVING,
        (RANGE, CONTACT),
    ),
    chained(
        "sensitivities",
        "Compute the derivatives of y9 by the sizes, in the order of the arguments.",
        SENSITIVITIES,
        sp.ImmutableDenseMatrix([SENSITIVITY_FORMS[size] for size in SIZES]),
        "mm per mm or mm per rad",
        conditioned_in_contact(CHAIN_ULP, SENSITIVITIES),
        MOVING,
        (RANGE, CONTACT),
    ),
)

# The forms of the whole chain, stage by stage: up to the rod in x1, from the link 5' on in x5'.


def write_out(form: sp.Expr, contact_gain: sp.Expr = sp.S.One) -> sp.Expr:
    """Insert the steps of a form; the push is x5', the gain that in contact."""
    form = form.subs(gain, contact_gain)
    for _ in STEPS:
        form = form.subs({s: v for s, v in STEPS.items() if s is not push}, simultaneous=True)
    return form.subs(push, x5)


def at_lever(expression: sp.Expr) -> sp.Expr:
    """Insert the angle of the lever and the present length of BC."""
    return expression.subs({phi3: CHAIN[lever], reach: sqrt(radicand)})


def state_sensitivity(size: sp.Symbol) -> Equality:
    """State that a sensitivity is the product of the proved slopes of its stages."""
    form = SENSITIVITY_FORMS[size]
    if size in lever_slopes:
        rod = at_lever(sp.diff(print_3, phi3) * lever_slopes[size])
        return Equality(write_out(form), rod)
    if size in (l_DE, alpha_DE, l_GH):
        return Equality(write_out(form), at_lever(sp.diff(print_3 - l_GH, size)))
    if size in (l_KL, alpha_KL):
        slope = l_LM * cos(alpha_LM + phi7) * roller_slopes[size]
        return Equality(write_out(form, CONTACT_GAIN), slope.subs(phi7, ROLLER))
    return Equality(write_out(form), sp.diff(print_10, size).subs(phi7, ROLLER))


CONTACT_GAIN = l_LM * cos_wedge / rise
REACHED = Part("|R| < l_KL", where=(l_KL - PRINTED_R > 0, l_KL + PRINTED_R > 0))
SAME_RUN = Equality(write_out(run), at_lever(print_3))
SAME_GAIN = Equality(
    write_out(CONTACT_GAIN),
    (l_LM * cos(alpha_LM + phi7) / (l_KL * sin(alpha_KL + phi7))).subs(phi7, ROLLER),
)
FORM_ROWS = tuple(
    Claim(
        f"kernel {name}",
        rf"\text{{the kernel {name} computes its definition}}",
        Conjunction(parts),
        note=f"Form: half-angle chain. {note}",
        on=REACHED,
        marks=("ours",),
    )
    for name, parts, note in (
        (
            "position",
            (SAME_RUN, Equality(write_out(POSITION_FORM), print_10.subs(phi7, ROLLER))),
            "Up to the rod as a function of x1, from the link 5' on of x5'.",
        ),
        (
            "velocity",
            (
                SAME_RUN,
                SAME_GAIN,
                Equality(
                    write_out(l_DE * sin_arm * cos_lever / guide_length),
                    at_lever(sp.diff(print_3, phi3) * lever_slopes[x1]),
                ),
            ),
            "The rod's slope by x1 and the gain, the slope of y9 by x5' in contact.",
        ),
        (
            "sensitivities",
            (SAME_RUN, SAME_GAIN, *map(state_sensitivity, SIZES)),
            "In contact; before it all are zero but those of the wedge, whose push is zero.",
        ),
    )
)

# Of the steps with a dimension, the power of the length.
STEP_POWERS = {
    **dict.fromkeys((arm, guide_length, guide_sum, run, push, rise, rise_sum), 1),
    **dict.fromkeys((start_height, to_right, to_left, travel, contact, offset), 1),
    **dict.fromkeys((lever_square, roller_square), 2),
}
VARIABLES = (
    *(Variable(s, meaning, LENGTH, POSITIVE) for s, meaning in LENGTHS.items()),
    *(Variable(s, meaning, LENGTH) for s, meaning in DISPLACEMENTS.items()),
    *(Variable(s, meaning) for s, meaning in ROTATIONS.items()),
    Variable(alpha_KL, "direction of KL at x1 = 0", within=sp.Interval.open(0, pi)),
    Variable(tau, "tangent of half the direction of KL", within=sp.Interval(0, sp.oo)),
    Variable(sigma, "cotangent of half the direction of KL", within=sp.Interval(0, sp.oo)),
    Variable(kappa, "tangent of half of alpha_KL", within=sp.Interval(0, sp.oo)),
    Variable(Q, "l_BC times the present length of BC", LENGTH**2, given=PRINTED_Q),
    Variable(overlap, "x5 less the clearance", LENGTH, given=x5 - l_GH),
    Variable(reach, "present length of BC", LENGTH, POSITIVE),
    Variable(h3, "sum of both lengths of BC", LENGTH, POSITIVE),
    Variable(h7, "sum of both heights of K over L", LENGTH, POSITIVE),
    *(
        Variable(s, "step of the kernels", LENGTH ** STEP_POWERS.get(s, 0), given=value)
        for s, value in STEPS.items()
    ),
    *(
        Variable(s, "step of the chain", LENGTH ** STEP_POWERS.get(s, 0), given=value)
        for s, value in CHAIN.items()
    ),
    Variable(height, "height of K over L", LENGTH, POSITIVE),
    Variable(guide_square, "square of the present length of BC", LENGTH**2, given=radicand),
    Variable(height_square, "square of the height", LENGTH**2, given=l_KL**2 - PRINTED_R**2),
    Variable(R, "projection of KL on Ox", LENGTH),
)

PAPER = Paper(
    system="wedge_linkage",
    citation=(
        "Bazuev, Koksharov, Naichuk 2021, transfer function of a rod semi-automatic, "
        "doi 10.15593/2224-9982/2021.64.07"
    ),
    variables=VARIABLES,
    rows=ROWS + FORM_ROWS,
    quantities=QUANTITIES,
    conventions=(
        "Displacements and rotations are counted from the position x1 = 0; angles from Ox,\n"
        "positive counter-clockwise; x to the right, y upwards."
    ),
)
