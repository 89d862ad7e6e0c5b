"""What paper 4 prints, row by row, against the groups rebuilt from their vector equations."""

import sympy as sp
from sympy import Rational, cos, pi, sin, sqrt

from mechproof.record import (
    LENGTH,
    Claim,
    Completion,
    Completions,
    Conjunction,
    Definition,
    Equality,
    Equation,
    Holds,
    Part,
    Reading,
    Variable,
)

from .mechanics import (
    BEFORE_PIVOT,
    DISPLACEMENTS,
    FIRST_QUADRANT,
    LENGTHS,
    MOVABLE,
    POSITIVE,
    PRINTED_Q,
    PRINTED_R,
    RIGHT,
    ROTATIONS,
    SECOND_QUADRANT,
    UP,
    Q,
    R,
    alpha_DE,
    alpha_KL,
    alpha_LM,
    by_half_angle,
    cosine_of_sigma,
    cosine_of_tau,
    direction_sigma,
    direction_tau,
    displacement,
    driven,
    from_h_to_l,
    group_1,
    group_2,
    group_3,
    group_4,
    guide_square,
    guide_squared,
    h3,
    h7,
    half_3,
    half_7,
    height,
    height_square,
    kappa,
    l_AB,
    l_BC,
    l_CD,
    l_DE,
    l_EF,
    l_GH,
    l_HI,
    l_IK,
    l_KL,
    l_LM,
    l_MN,
    lever_angle,
    lever_cosine,
    lever_sine,
    lever_slope,
    lever_slopes,
    millimetre,
    overlap,
    phi2,
    phi3,
    phi7,
    print_1,
    print_2_ox,
    print_2_oy,
    print_3,
    print_6_ox,
    print_6_oy,
    print_7,
    print_8,
    print_9_ox,
    print_9_oy,
    print_10,
    print_ox1,
    print_oy1,
    radicand,
    reach,
    rod,
    roller_slope,
    roller_slopes,
    root_7,
    sigma,
    sine_of_tau,
    tau,
    towards,
    upright,
    wedge,
    x1,
    x5,
    x5_driven,
)
from .sizes import (
    ANGLES,
    BOUNDARY_II,
    BOUNDARY_III,
    LEGIBLE,
    LEGIBLE_ANGLES,
    LOST,
    TOLERANCED,
    above,
    crossing,
    differ,
    in_both,
    influence,
    largest_at_the_end,
    radicand_of,
    signs_of_iv,
    ten_percent,
    unit,
)

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
    Variable(height, "height of K over L", LENGTH, POSITIVE),
    Variable(guide_square, "square of the present length of BC", LENGTH**2, given=radicand),
    Variable(height_square, "square of the height", LENGTH**2, given=l_KL**2 - PRINTED_R**2),
    Variable(R, "projection of KL on Ox", LENGTH),
)


def no_influence(size: sp.Symbol) -> Conjunction:
    """State that no solution of a group, all lengths kept in, changes with the size."""
    outputs = (rod, displacement[tau], wedge, lever_cosine, lever_sine)
    return Conjunction(tuple(Equality(sp.diff(output, size), sp.S.Zero) for output in outputs))


def datum_row(symbol: sp.Symbol, latex: str, value: str, note: str, uncertain: bool) -> Claim:
    """Record a size of the table, as far as it is legible."""
    scale = unit(symbol) if symbol in ANGLES else millimetre
    return Claim(
        f"sizes, {symbol}",
        latex,
        Definition(symbol, Rational(value) * scale),
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
            "the damaged letter of the angle",
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
            "digits of l_BC and l_CD",
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
            "the damaged letter",
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
            "the ratio of each further stage",
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
