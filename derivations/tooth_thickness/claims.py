"""Rows of paper 3 on what it concludes, (a) to (e)."""

from __future__ import annotations

from sympy import Interval, Rational, S, diff, oo, pi, sqrt

from mechproof.record import Claim, Completion, Completions, Equality, Part, PrintedNumber, Reading

from .._relations import all_of, less
from .mechanics import (
    GAUGE_UM,
    GRADES,
    POSITIVE,
    RECOMMENDED_UM,
    TOLERANCE_UM,
    VARIANCE_BY_SLOPE,
    K_m,
    above,
    below,
    chance_to_accept,
    crossover,
    error_variance,
    gauge_spread,
    gauge_um,
    good_but_rejected,
    influence,
    rejected_by,
    sigma,
    sigma_height,
    sigma_thickness,
    sigma_tip,
    tip_spread,
    width,
)

# Grade, multiple of sigma, limit error (um) at the crossover: as printed, by the geometry.
CROSSOVERS = (
    (6, 2, "4.9", "2.5"),
    (6, 3, "7.4", "3.7"),
    (7, 2, "7.9", "3.9"),
    (7, 3, "11.8", "5.9"),
    (8, 2, "12.4", "6.2"),
    (8, 3, "18.5", "9.3"),
)

CLAIM_ROWS = (
    Claim(
        "(a), curves of Figs. 4 and 5",
        r"\text{percentage of wrongly rejected at a limit error of }10~\mu\mathrm{m}",
        Completions(
            "multiple of the limit error and law of the gauge",
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
        marks=("inferred",),
    ),
    Claim(
        "(a), rise with the limit error",
        r"\frac{\partial}{\partial w}\tfrac12\left[\mathrm{erf}\frac{q_1}w"
        r"+\mathrm{erf}\frac{q_2}w\right]<0",
        less((sqrt(pi) * diff(chance_to_accept, width)).expand(), S.Zero),
        on=Part("the limits are apart", where=(above + below > 0,)),
        holds_on=Part(
            "teeth whose expected reading lies inside the limits",
            {above: POSITIVE, below: POSITIVE},
        ),
        note=(
            "The chance to accept a tooth, whose expected reading is q_1 and q_2 from the limits, "
            "falls as the normal error grows. With a centred gauge that is so of every good tooth, "
            "so that for every law of the true deviation Fig. 4 rises and Fig. 5 falls; a gauge "
            "with a bias, a parameter of the flow chart, accepts some the more often it errs more."
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
        less(tip_spread(6), gauge_spread(gauge_um)),
        holds_on=Part(
            "a gauge of IT6's crossover on, a standard deviation over 2.454 um: a limit error over "
            "4.91 um (2 sigma) or 7.36 um (3 sigma)",
            {gauge_um: Interval.open(Rational("2.454"), oo)},
        ),
        note="Steps 5 and 6 as printed, IT6 for the tip, tip of IT/sigma = K; by standard "
        "deviations, with which the shares rise. Over which gauges the two are compared is not "
        "said. The gauge of Table 1, 50 um, is above the crossover, the gauge recommended in (c), "
        "2 um, below it.",
        marks=("rebuilt", "inferred", "calibrated"),
    ),
    *(
        Claim(
            f"(b), crossover, IT{grade}, {multiple} sigma",
            rf"\text{{tip of IT{grade} and gauge disturb alike at a limit error of }}"
            rf"{printed}~\mu\mathrm{{m}},\text{{ by the geometry }}{involute}~\mu\mathrm{{m}}",
            all_of(
                PrintedNumber(printed, multiple * crossover(grade)),
                PrintedNumber(involute, multiple * crossover(grade, "involute")),
            ),
            note=f"Limit error {multiple} sigma. Printed: steps 5 and 6.",
            marks=("ours", "calibrated"),
        )
        for grade, multiple, printed, involute in CROSSOVERS
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
        r"\text{for degrees 6, 7, 8 gauges with }U\le\pm2~\mu\mathrm{m}"
        r"\text{ can be recommended}",
        Completions(
            "criterion of the recommendation",
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
        r"\text{from }\pm25\text{ to }\pm2~\mu\mathrm{m}\text{: wrongly rejected more than 20 "
        r"times rarer}",
        less(20 * rejected_by(6, RECOMMENDED_UM), rejected_by(6, Rational(GAUGE_UM, 2))),
        note="IT6, normal laws, centred, limit errors of 3 sigma, steps 5 and 6 as printed.",
        marks=("ours",),
    ),
    Claim(
        "(d)",
        r"\text{the grade of the tip diameter should be 6 and 7, not 8}",
        Completions(
            "criterion of the recommendation",
            Completion(
                "at most 2 % wrongly rejected with a perfect gauge",
                all_of(
                    less(Rational("0.02"), rejected_by(8, 0)),
                    less(rejected_by(7, 0), Rational("0.02")),
                ),
            ),
            Completion(
                "at most 4 %",
                all_of(
                    less(Rational("0.04"), rejected_by(8, 0)),
                    less(rejected_by(7, 0), Rational("0.04")),
                ),
            ),
        ),
        note="Stated: IT8 fails where IT7 passes. No criterion is printed; steps 5 and 6 as "
        "printed, K = 6 for tooth and tip, normal laws, centred. From which gauge on the tip "
        "matters more than the gauge say the crossovers at (b).",
    ),
    Claim(
        "(d), IT8 by the geometry against IT7 as printed",
        r"\text{IT8 with }\tfrac12K_m\text{ disturbs less than IT7 with }K_m",
        less(
            tip_spread(8, "involute"),
            tip_spread(7),
        ),
        note="So that every limit of the wrongly rejected that admits IT7 by the printed steps "
        "admits IT8 by the geometry. What the recommendation itself rests on is not printed.",
        marks=("ours", "calibrated"),
    ),
    Claim(
        "(e)",
        r"\text{with a zero limit error of the gauge the shares depend only on the tip's grade}",
        Equality(
            good_but_rejected(tip_spread(6), 6),
            good_but_rejected(tip_spread(6), 4),
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
        all_of(
            less(Rational("0.003"), rejected_by(6, 0)),
            less(rejected_by(6, 0), Rational("0.004")),
            less(Rational("0.001"), rejected_by(6, 0, geometry="involute")),
            less(rejected_by(6, 0, geometry="involute"), Rational("0.002")),
        ),
        note="K = 6 for tooth and tip, normal laws, centred.",
        marks=("ours", "calibrated"),
    ),
)
