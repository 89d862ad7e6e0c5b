"""Rows of paper 4 from the clearance to the wedge: equations (4) to (10), and all substituted."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from mechproof.record import (
    Claim,
    Completion,
    Completions,
    Conjunction,
    Correction,
    Equality,
    Part,
    Reading,
)

from .chain import PUSHED_IN_PRINT
from .half_angles import (
    BEFORE_PIVOT,
    FIRST_QUADRANT,
    SECOND_QUADRANT,
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
    group_3,
    group_4,
    lever_angle,
    rod,
    wedge,
)
from .prints import (
    EQUATION_4,
    EQUATION_5,
    EQUATION_6_OX,
    EQUATION_6_OY,
    EQUATION_7,
    EQUATION_8,
    EQUATION_9_OX,
    EQUATION_9_OY,
    EQUATION_10,
    EQUATION_R,
    GROUP_4,
    print_1,
    print_3,
    print_6_ox,
    print_7,
    print_8,
    print_10,
)
from .proofs import push_by
from .symbols import (
    HL,
    LP,
    POSITIVE,
    R,
    alpha_KL,
    apart,
    kappa,
    l_GH,
    l_KL,
    overlap,
    phi2,
    phi3,
    phi7,
    tau,
    x5,
    x5_driven,
    y9,
)

PUSHED = {x5_driven: driven.subs(overlap, x5 - l_GH)}
IN_CONTACT = Equality(print_6_ox.subs(x5, x5 - l_GH), group_3[0].subs(x5_driven, x5 - l_GH))

ROLLER_ROWS = (
    replace(
        EQUATION_4,
        number="(4), before contact",
        derived=PUSHED,
        substituted={x5: l_GH - apart},
        note="A link that is only pushed; x5 is short of the clearance by apart > 0.",
        marks=("rebuilt",),
    ),
    replace(
        EQUATION_4,
        number="(4), in contact",
        derived=PUSHED,
        substituted={x5: l_GH + apart},
        note="x5 exceeds the clearance. At the start of contact, which is in neither case, both "
        "give 0, so that < and <= would say the same.",
        marks=("rebuilt", "uncertain"),
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
    replace(
        EQUATION_5,
        defines=(HL,),
        note="See group 1; HL, from H on the link 5' to the fixed L. Its projections are (6).",
    ),
    replace(
        EQUATION_6_OX,
        residual=IN_CONTACT.rebuilt,
        corrected=Correction(
            r"l_{KL}\cos(\alpha_{KL}+\varphi_7)=l_{KL}\cos\alpha_{KL}-x_{5'}",
            IN_CONTACT,
        ),
        note="In contact, the link 5' lags behind the rod by the clearance. The print may have "
        "lost a prime. The one letter stands in (7), (8) and R, too, which are judged with the "
        "link 5'.",
        readings=(
            Reading(
                "x5 is the displacement of the link 5' after the clearance",
                IN_CONTACT,
            ),
        ),
        marks=("inferred", "uncertain"),
    ),
    replace(
        EQUATION_6_OY,
        residual=group_3[1],
    ),
    replace(
        EQUATION_7,
        derived={phi7: direction_tau - alpha_KL},
        substituted={R: l_KL * cosine_of_tau},
        on=FIRST_QUADRANT,
        note="R, the projection of KL, by the direction 2 arctan(tau) of KL.",
        marks=("rebuilt", "inferred"),
    ),
    replace(
        EQUATION_8,
        derived={phi7: direction_sigma - alpha_KL},
        substituted={R: l_KL * cosine_of_sigma},
        on=SECOND_QUADRANT,
        note="R, the projection of KL, by the direction pi - 2 arctan(sigma) of KL.",
        marks=("rebuilt", "inferred"),
    ),
    replace(
        EQUATION_R,
        derived={R: l_KL * cosine_of_tau},
        substituted={x5: displacement[tau]},
        note="R is the projection of KL on Ox, so |R| <= l_KL; R = 0 lies in neither formula. x5 "
        "is that of the link 5'.",
        marks=("inferred",),
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
    replace(
        GROUP_4,
        defines=(LP,),
        note="See group 1; LP, from the fixed L to the guide of the wedge.",
    ),
    replace(
        EQUATION_9_OX,
        residual=group_4[0],
    ),
    replace(
        EQUATION_9_OY,
        residual=group_4[1],
    ),
    replace(
        EQUATION_10,
        derived={y9: wedge},
        marks=("rebuilt",),
    ),
    Claim(
        "(1), (3), (4), (7), (8), (10), substituted",
        r"\text{substituting (1), (3), (4), (7), (8), (10) successively gives }y_9(x_1)",
        Conjunction(
            (
                Equality(print_1, lever_angle),
                Equality(print_3, rod),
                *push_by(PUSHED_IN_PRINT),
                Equality(print_7.subs(R, l_KL * cosine_of_tau), direction_tau - alpha_KL),
                Equality(print_8.subs(R, l_KL * cosine_of_sigma), direction_sigma - alpha_KL),
                Equality(print_10, wedge),
            )
        ),
        note="Each stage against its group. (7) and (8) take x5' of (4) for their x5, see '(6), "
        "Ox'; else (4) would be left out. R = 0 is in neither case.",
        on=Part(
            f"{BEFORE_PIVOT.text}; R > 0 for (7), R < 0 for (8)",
            {**FIRST_QUADRANT.within, **SECOND_QUADRANT.within},
            BEFORE_PIVOT.where,
        ),
        marks=("rebuilt", "inferred", "uncertain"),
    ),
)
