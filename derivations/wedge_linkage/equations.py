"""Rows of paper 4 on its equations (1) to (10), against the groups rebuilt."""

from __future__ import annotations

import sympy as sp
from sympy import sqrt

from mechproof.record import (
    Claim,
    Completion,
    Completions,
    Conjunction,
    Definition,
    Equality,
    Equation,
    Part,
    Reading,
)

from .chain import PUSHED_IN_PRINT
from .half_angles import (
    BEFORE_PIVOT,
    FIRST_QUADRANT,
    MOVABLE,
    SECOND_QUADRANT,
    half_3,
    half_7,
    upright,
)
from .mechanics import (
    cosine_of_sigma,
    cosine_of_tau,
    direction_sigma,
    direction_tau,
    displacement,
    driven,
    from_a_to_d,
    from_d_to_g,
    from_h_to_l,
    from_l_to_p,
    group_1,
    group_2,
    group_3,
    group_4,
    guide_squared,
    lever_angle,
    lever_cosine,
    lever_sine,
    rod,
    sine_of_tau,
    wedge,
)
from .prints import (
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
)
from .proofs import push_by
from .symbols import (
    AD,
    DG,
    HL,
    LP,
    POSITIVE,
    PRINTED_Q,
    PRINTED_R,
    R,
    alpha_KL,
    kappa,
    l_AB,
    l_BC,
    l_CD,
    l_GH,
    l_KL,
    overlap,
    phi2,
    phi3,
    sigma,
    tau,
    x1,
    x5,
    x5_driven,
)


def introduce(vector: tuple[sp.Symbol, ...], closing: sp.Matrix) -> Conjunction:
    """Introduce the projections of the vector that closes a polygon."""
    return Conjunction(tuple(map(Definition, vector, closing)))


EQUATION_ROWS = (
    Equation(
        "group 1",
        r"\vec{AB}+\vec{BC}+\vec{CD}=\vec{AD}",
        introduce(AD, from_a_to_d),
        note="A polygon of any four points closes; AD, from A on the pusher to the fixed D, is "
        "what closes it. Judged are its projections.",
    ),
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
        note="Against the two-argument arctangent of the solved projections. Beyond a right angle "
        "of the lever, which no size within its limits reaches, it is off by pi; the next row says "
        "exactly where.",
        on=MOVABLE,
        holds_on=BEFORE_PIVOT,
        marks=("rebuilt",),
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
        "group 2",
        r"\vec{DE}+\vec{EF}+\vec{FG}=\vec{DG}",
        introduce(DG, from_d_to_g),
        note="See group 1; DG, from the fixed D to the guide of the rod.",
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
        introduce(HL, from_h_to_l),
        note="See group 1; HL, from H on the link 5' to the fixed L. Its projections are (6).",
    ),
    Equation(
        "(6), Ox",
        r"l_{KL}\cos(\alpha_{KL}+\varphi_7)=l_{KL}\cos\alpha_{KL}-x_5",
        Equality(print_6_ox, group_3[0].subs(x5_driven, x5 - l_GH)),
        note="In contact, the link 5' lags behind the rod by the clearance. The print may have "
        "lost a prime.",
        readings=(
            Reading(
                "x5 is the displacement of the link 5' after the clearance",
                Equality(print_6_ox.subs(x5, x5_driven), group_3[0]),
            ),
        ),
        marks=("inferred", "uncertain"),
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
        "group 4",
        r"\vec{LM}+\vec{MN}+\vec{NP}=\vec{LP}",
        introduce(LP, from_l_to_p),
        note="See group 1; LP, from the fixed L to the guide of the wedge.",
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
        "(1), (3), (4), (7), (8), (10), substituted",
        r"\text{substituting (1), (3), (4), (7), (8), (10) successively gives }y_9(x_1)",
        Equality(PRINTED_R, PRINTED_R.subs(x5, driven)),
        readings=(
            Reading(
                "(7) and (8) take x5' of (4) for their x5",
                Conjunction(
                    (
                        Equality(print_1, lever_angle),
                        Equality(print_3, rod),
                        *push_by(PUSHED_IN_PRINT),
                        Equality(print_7.subs(R, l_KL * cosine_of_tau), direction_tau - alpha_KL),
                        Equality(
                            print_8.subs(R, l_KL * cosine_of_sigma), direction_sigma - alpha_KL
                        ),
                        Equality(print_10, wedge),
                    )
                ),
            ),
        ),
        note="Each stage against its group; with the letter x5 as printed (4) would be left out. "
        "R = 0 is in neither case.",
        on=Part(
            f"{BEFORE_PIVOT.text}; R > 0 for (7), R < 0 for (8)",
            {**FIRST_QUADRANT.within, **SECOND_QUADRANT.within},
            BEFORE_PIVOT.where,
        ),
        marks=("rebuilt", "inferred", "uncertain"),
    ),
)
