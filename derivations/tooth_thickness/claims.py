"""Rows of paper 3 on what it concludes, (a) to (e)."""

from __future__ import annotations

from sympy import Rational, S, diff, pi, sqrt

from mechproof.record import Claim, Completion, Completions, Conjunction, Equality, Reading

from .._relations import less
from .geometry import influence
from .shares import (
    VARIANCE_BY_SLOPE,
    chance_to_accept,
    error_variance,
    measurement_spread,
    rejected_by,
    wrongly_rejected,
)
from .symbols import K_m, sigma, sigma_height, sigma_thickness, sigma_tip, width
from .wheel import GAUGE_UM, GRADES, RECOMMENDED_UM, TOLERANCE_UM

CLAIM_ROWS = (
    Claim(
        "(a), curves of Figs. 4 and 5",
        r"\text{percentage of wrongly rejected at a limit error of }10~\mu\mathrm m",
        Completions(
            Completion(
                "IT6, normal laws, limit error 3 sigma: below 2 %",
                less(rejected_by(6, 10), Rational("0.02")),
            ),
            Completion(
                "IT6, normal laws, limit error 2 sigma: below 2 %",
                less(rejected_by(6, 10, 2), Rational("0.02")),
            ),
        ),
        note="The curves are lost, and the multiple of the limit error is not printed.",
    ),
    Claim(
        "(a), rise with the limit error",
        r"\frac{\partial}{\partial w}\tfrac12\left[\mathrm{erf}\frac{q_1}w"
        r"+\mathrm{erf}\frac{q_2}w\right]<0",
        less((sqrt(pi) * diff(chance_to_accept, width)).expand(), S.Zero),
        note=(
            "The chance that a good tooth, q_1 and q_2 inside its limits, is accepted falls as the "
            "normal error grows: for every law of the true deviation Fig. 4 rises and Fig. 5 falls."
        ),
        marks=("ours",),
    ),
    Claim(
        "(a), order of the curves",
        r"\text{curve 2 (IT7) lies above curve 1 (IT6) in Fig. 4, below it in Fig. 5}",
        less(
            VARIANCE_BY_SLOPE.subs(sigma_tip, sigma),
            VARIANCE_BY_SLOPE.subs(sigma_tip, GRADES[7][1] * sigma / GRADES[6][1]),
        ),
        note="The total error of IT7 has the larger variance at every limit error of the gauge.",
        marks=("ours",),
    ),
    Claim(
        "(b)",
        r"\text{the gauge influences the shares more strongly than the tip diameter}",
        Completions(
            Completion(
                "the gauge of Table 1 (50 um in all, 3 sigma), IT6: its variance is the larger",
                less(
                    measurement_spread(6, 0, 3, "printed") ** 2,
                    measurement_spread(6, 25, 3, "printed") ** 2
                    - measurement_spread(6, 0, 3, "printed") ** 2,
                ),
            ),
            Completion(
                "the gauge recommended in (c) (2 um, 3 sigma), IT6: the same",
                less(
                    measurement_spread(6, 0, 3, "printed") ** 2,
                    measurement_spread(6, RECOMMENDED_UM, 3, "printed") ** 2
                    - measurement_spread(6, 0, 3, "printed") ** 2,
                ),
            ),
        ),
        note="Steps 5 and 6 as printed. Over which range the two are compared is not said.",
    ),
    Claim(
        "(b), at equal standard deviations",
        r"1+K_m^2>K_m^2",
        less(
            VARIANCE_BY_SLOPE.subs({sigma_height: 0, sigma_thickness: 0, sigma_tip: sigma}),
            VARIANCE_BY_SLOPE.subs({sigma_tip: 0, sigma_height: sigma, sigma_thickness: sigma}),
        ),
        note="The gauge enters twice, in height and in thickness; by the geometry K_m/2 for the "
        "tip makes the difference larger still.",
        marks=("ours",),
    ),
    Claim(
        "(c)",
        r"\text{for degrees 6, 7, 8 gauges with }U\le\pm2~\mu\mathrm m\text{ can be recommended}",
        Completions(
            Completion(
                "degree 6, IT6, U = 2 sigma, criterion: at most 1 % wrongly rejected",
                less(rejected_by(6, RECOMMENDED_UM, 2), Rational("0.01")),
            ),
            Completion(
                "the same, criterion: at most 0.1 % wrongly rejected",
                less(rejected_by(6, RECOMMENDED_UM, 2), Rational("0.001")),
            ),
        ),
        note="No criterion is printed, nor the tolerances of degrees 7 and 8.",
    ),
    Claim(
        "(c), part of the tolerance",
        r"2U/T_c=4/45<\tfrac1{10}",
        less(Rational(2 * RECOMMENDED_UM, TOLERANCE_UM), Rational(1, 10)),
        note="The interval of the recommended gauge is below a tenth of the tolerance of degree 6.",
        marks=("ours",),
    ),
    Claim(
        "(c), what 2 um buy",
        r"\text{from }\pm25\text{ to }\pm2~\mu\mathrm m\text{: wrongly rejected more than 20 times "
        r"rarer}",
        less(20 * rejected_by(6, RECOMMENDED_UM), rejected_by(6, Rational(GAUGE_UM, 2))),
        note="IT6, normal laws, centred, limit errors of 3 sigma, steps 5 and 6 as printed.",
        marks=("ours",),
    ),
    Claim(
        "(d)",
        r"\text{the grade of the tip diameter should be 6 and 7, not 8}",
        Completions(
            Completion(
                "steps 5 and 6 as printed: a perfect gauge wrongly rejects over 2 % with IT8, "
                "less with IT7",
                Conjunction(
                    (
                        less(Rational("0.02"), rejected_by(8, 0)),
                        less(rejected_by(7, 0), Rational("0.02")),
                    )
                ),
            ),
            Completion(
                "steps 5 and 6 by the geometry: the same",
                Conjunction(
                    (
                        less(Rational("0.02"), rejected_by(8, 0, geometry="involute")),
                        less(rejected_by(7, 0, geometry="involute"), Rational("0.02")),
                    )
                ),
            ),
        ),
        note="No criterion is printed. K = 6 for tooth and tip, normal laws, centred.",
    ),
    Claim(
        "(d), IT8 by the geometry against IT7 as printed",
        r"\text{IT8 with }\tfrac12K_m\text{ disturbs less than IT7 with }K_m",
        less(
            measurement_spread(8, 0, 3, "involute"),
            measurement_spread(7, 0, 3, "printed"),
        ),
        note="The recommendation against grade 8 rests on the lost factor 1/2.",
        marks=("ours", "calibrated"),
    ),
    Claim(
        "(e)",
        r"\text{with a zero limit error of the gauge the shares depend only on the tip's grade}",
        Equality(
            wrongly_rejected(measurement_spread(6, 0, 3, "printed"), 6),
            wrongly_rejected(measurement_spread(6, 0, 3, "printed"), 4),
        ),
        readings=(
            Reading(
                "of the measurement errors only that of the tip diameter remains",
                Equality(
                    error_variance(K_m, K_m).subs({sigma_height: 0, sigma_thickness: 0}),
                    (influence * sigma_tip) ** 2,
                ),
            ),
        ),
        note="The shares depend on the spread and the expectation of the tooth thickness, too: "
        "K = 6 and K = 4 differ.",
    ),
    Claim(
        "(e), what remains",
        r"\text{perfect gauge, IT6: }0.3\text{ to }0.4~\%\text{ wrongly rejected as printed, "
        r"}0.1\text{ to }0.2~\%\text{ by the geometry}",
        Conjunction(
            (
                less(Rational("0.003"), rejected_by(6, 0)),
                less(rejected_by(6, 0), Rational("0.004")),
                less(Rational("0.001"), rejected_by(6, 0, geometry="involute")),
                less(rejected_by(6, 0, geometry="involute"), Rational("0.002")),
            )
        ),
        note="K = 6 for tooth and tip, normal laws, centred.",
        marks=("ours", "calibrated"),
    ),
)
