"""Rows of paper 3 on the steps of the flow chart."""

from __future__ import annotations

from sympy import Add, Expr, KroneckerDelta, Rational, S, Sum, sqrt, symbols, tan

from mechproof.record import (
    Claim,
    Completion,
    Completions,
    Correction,
    Definition,
    Distinct,
    Equality,
    PrintedNumber,
    Reading,
)

from .._metrology import normal_between
from .._relations import all_of, less, not_above
from .mechanics import (
    GAUGE_UM,
    GRADES,
    NORMAL_SHARE,
    PRINT,
    RANGE,
    THREE_SIGMA,
    TIP_DIAMETER,
    TOLERANCE_UNIT,
    E_measured,
    E_true,
    K,
    K_m,
    alpha,
    dh,
    dh_gauge,
    ds_gauge,
    ds_height,
    e_tip,
    error_variance,
    f_measured,
    f_true,
    height_deviation,
    height_towards_tip,
    influence,
    measured_change,
    reading,
    rightly_accepted,
    rightly_rejected,
    sigma_tip,
    wrongly_accepted,
    wrongly_rejected,
    z,
)

SHARES_OF_TOOTH = {
    rightly_accepted: f_true * f_measured,
    wrongly_accepted: (1 - f_true) * f_measured,
    rightly_rejected: (1 - f_true) * (1 - f_measured),
    wrongly_rejected: f_true * (1 - f_measured),
}
i, j = symbols("i j", integer=True, positive=True)


def variance_of_wheel_mean(covariance: Expr) -> Expr:
    """Variance of the mean over a wheel's teeth, from the covariance of teeth i and j."""
    return Sum(covariance / z**2, (i, 1, z), (j, 1, z))


# Counted towards the centre, and towards the tip.
HALF_OF_THE_DEVIATION = all_of(
    Equality(dh_gauge - e_tip / 2, height_deviation),
    Equality(dh_gauge + e_tip / 2, height_towards_tip),
)

ALGORITHM_ROWS = (
    PRINT.claim(
        "step 1",
        defines=(K,),
        note="The ratio of the tolerance field to the standard deviation, in words.",
    ),
    Claim(
        "step 1, normal accuracy",
        r"K=6",
        PrintedNumber("99.73", 100 * NORMAL_SHARE),
        note="Per cent of good teeth for a normal law centred on the field.",
        marks=("ours",),
    ),
    Claim(
        "step 1, law and expectation",
        r"\text{the law and the expectation of the deviation}",
        Completions(
            "law and expectation of the thickness",
            Completion(
                "normal, centred, K = 6: more than 99 % good",
                less(Rational("0.99"), NORMAL_SHARE),
            ),
            Completion(
                "normal, expectation a sixth of the field above its middle, K = 6: the same",
                less(
                    Rational("0.99"),
                    normal_between(S.One, S.One, -THREE_SIGMA, THREE_SIGMA),
                ),
            ),
        ),
        note="No law is legible, and no value of the expectation is printed.",
    ),
    PRINT.equation(
        "step 2",
        defines=(f_true,),
        note="For the sign of E_cs see 'smallest deviation'.",
        marks=("rebuilt",),
    ),
    Claim(
        "step 3, spread of the tip diameter",
        r"e_{dau}\text{ for an IT grade}",
        Completions(
            "how many standard deviations a tolerance spans",
            Completion(
                "IT6 is six standard deviations: below 5 um",
                less(Rational(GRADES[6][1], 6), S(5)),
            ),
            Completion(
                "uniform over IT6: below 5 um",
                less(GRADES[6][1] / sqrt(12), S(5)),
            ),
        ),
        note="How a standard deviation follows from an IT grade is not printed.",
    ),
    Claim(
        "step 3, a new tip deviation for each tooth",
        r"\text{per tooth: simulate }e_{dau}",
        Equality(variance_of_wheel_mean(sigma_tip**2 * KroneckerDelta(i, j)), sigma_tip**2),
        readings=(
            Reading(
                "each row is a tooth of another wheel",
                Equality(
                    variance_of_wheel_mean(sigma_tip**2 * KroneckerDelta(i, j)), sigma_tip**2 / z
                ),
            ),
        ),
        corrected=Correction(
            r"\text{per wheel: simulate }e_{dau}\text{, the same for all of its teeth}",
            Equality(variance_of_wheel_mean(sigma_tip**2), sigma_tip**2),
        ),
        note="Judged for teeth of one wheel, which is not said: Table 1 has as many rows as the "
        "wheel has teeth. The variance of the tip's mean deviation over z teeth; a wheel has one "
        "tip circle, so that its deviation is common to all of its teeth and does not average out. "
        "Shares over many wheels are the same in both.",
        marks=("inferred",),
    ),
    Claim(
        "step 3, range of ISO 286-1",
        r"120<d_a=m(z+2)=156\le180~\mathrm{mm}",
        all_of(
            less(S(RANGE[0]), S(TIP_DIAMETER)),
            not_above(S(TIP_DIAMETER), S(RANGE[1])),
        ),
        note="Addendum of one module, as the height to the constant chord shows.",
        marks=("ours", "calibrated"),
    ),
    *(
        Claim(
            f"step 3, IT{grade}",
            rf"\mathrm{{IT}}{grade}={value}~\mu\mathrm{{m}}",
            PrintedNumber(str(value), factor * TOLERANCE_UNIT),
            note=f"{factor} i, i = 0.45 D^(1/3) + 0.001 D, D = sqrt(120*180) mm.",
            marks=("ours",),
        )
        for grade, (factor, value) in GRADES.items()
    ),
    Claim(
        "steps 4 and 7, spread of the gauge",
        r"\text{interval measure of the uncertainty }50~\mu\mathrm{m}",
        Completions(
            "what the limit error of the gauge is",
            Completion(
                "full width of a 3 sigma interval: the standard deviation is below 10 um",
                less(Rational(GAUGE_UM, 6), S(10)),
            ),
            Completion(
                "half the width of a 2 sigma interval: the same",
                less(Rational(GAUGE_UM, 2), S(10)),
            ),
        ),
        note="Neither the multiple nor the kind of interval is printed.",
    ),
    PRINT.equation(
        "step 5",
        derived={dh: height_towards_tip},
        readings=(
            Reading(
                "heights are counted towards the centre",
                Equality(e_tip + dh_gauge, height_deviation),
            ),
        ),
        corrected=Correction(
            r"\Delta h=\Delta h_c\mp\tfrac12e_{dau}",
            HALF_OF_THE_DEVIATION,
        ),
        note=(
            "The gauge stands on the tip circle, so half the deviation of the diameter "
            "counts, whichever way heights are counted, which is not printed: it fails with the "
            "plus that is shown, towards the tip, and with the minus, towards the centre. The "
            "correction is proved with both. The charge rests on the words 'tip diameter' of step "
            "3, not on a subscript."
        ),
        marks=("rebuilt",),
    ),
    Claim(
        "step 5, half the deviation",
        r"\Delta h=\Delta h_c-\tfrac12e_{dau}\text{ towards the centre, }"
        r"\Delta h_c+\tfrac12e_{dau}\text{ towards the tip}",
        HALF_OF_THE_DEVIATION,
        marks=("ours",),
    ),
    Claim(
        "steps 5 and 6, tip diameter alone",
        r"\Delta S_{ca}=K_me_{dau}",
        derived={ds_height: measured_change.subs(dh_gauge, 0)},
        corrected=Correction(r"\Delta S_{ca}=-e_{dau}\,\mathrm{tg}\,\alpha"),
        note=(
            "Twice too much; the sign is wrong as well if deviations are positive for a "
            "thicker tooth (see the next row)."
        ),
        marks=("rebuilt", "ours"),
    ),
    Claim(
        "steps 5 and 6, tip diameter, counted as a decrease",
        r"\text{decrease of the measured thickness}=K_m\,e_{dau}",
        Equality(K_m * e_tip, -measured_change.subs(dh_gauge, 0)),
        corrected=Correction(
            r"e_{dau}\,\mathrm{tg}\,\alpha",
            Equality(e_tip * tan(alpha), -measured_change.subs(dh_gauge, 0)),
        ),
        note="Counting decreases as positive mends the sign; the factor 2 remains.",
        marks=("ours",),
    ),
    Claim(
        "steps 5 and 6, variance",
        r"D_{\text{printed}}-D_{\text{geometry}}=3\,\mathrm{tg}^2\alpha\,\sigma_d^2",
        Equality(
            error_variance(K_m, K_m) - error_variance(-influence / 2, influence),
            3 * tan(alpha) ** 2 * sigma_tip**2,
        ),
        note=(
            "The tip's part of the variance is printed four times too large. The sign does not "
            "matter to the variance; it moves the mean when the tip or the gauge has a bias."
        ),
        marks=("ours",),
    ),
    Claim(
        "letter Delta h_c",
        r"\Delta h_c\text{ (from the tip circle, text)}\ne\Delta h_c\text{ (gauge, chart)}",
        Distinct((e_tip + dh_gauge).subs(dh_gauge, height_deviation), height_deviation),
        note="With the text's meaning in step 5 the tip diameter would be counted again.",
        marks=("ours", "rebuilt"),
    ),
    Claim(
        "letter Delta S_c",
        r"\Delta S_c\text{ (from the height, text)}\ne\Delta S_c\text{ (gauge, chart)}",
        Distinct((E_true + K_m * dh + ds_gauge).subs(ds_gauge, K_m * dh), reading),
        note="With the text's meaning in step 8 the height would be counted twice.",
        marks=("ours", "rebuilt"),
    ),
    PRINT.equation(
        "step 8",
        derived={E_measured: reading},
        substituted={ds_height: K_m * dh},
        note="The indication less the nominal chord, to first order: a tooth whose flanks are "
        "turned to its true deviation, along a line deeper by Delta h; step 6 is put in.",
        marks=("rebuilt",),
    ),
    PRINT.equation(
        "step 9",
        defines=(f_measured,),
        note="Acceptance limits equal to the tolerance limits: no guard band.",
        marks=("rebuilt",),
    ),
    Claim(
        "step 10",
        r"\text{rightly accepted }(f_u=1,f_0=1)\text{, wrongly accepted }(f_u=0,f_0=1)"
        r"\text{, rightly rejected }(f_u=0,f_0=0)\text{, wrongly rejected }(f_u=1,f_0=0)",
        all_of(*(Definition(share, of_tooth) for share, of_tooth in SHARES_OF_TOOTH.items())),
        note="Wrongly accepted is the consumer's risk of JCGM 106, wrongly rejected the "
        "producer's.",
    ),
    Claim(
        "step 10, sum",
        r"f_uf_0+(1-f_u)f_0+(1-f_u)(1-f_0)+f_u(1-f_0)=1",
        Equality(
            Add(*SHARES_OF_TOOTH.values()),
            S.One,
        ),
        note="The four shares add up to all parts.",
        marks=("ours",),
    ),
)
