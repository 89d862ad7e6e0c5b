"""Rows of paper 3 on the steps of the flow chart."""

from sympy import Add, Expr, KroneckerDelta, Rational, S, Sum, symbols, tan

from mechproof.record import *

from ..mechanics import *

SHARES_OF_TOOTH = {
    rightly_accepted: f_true * f_measured,
    wrongly_accepted: (1 - f_true) * f_measured,
    rightly_rejected: (1 - f_true) * (1 - f_measured),
    wrongly_rejected: f_true * (1 - f_measured),
}
ALL_TEETH = Equality(Add(*SHARES_OF_TOOTH.values()), S.One)
i, j = symbols("i j", integer=True, positive=True)


def variance_of_wheel_mean(covariance: Expr) -> Expr:
    """Variance of the mean over a wheel's teeth, from the covariance of teeth i and j."""
    return Sum(covariance / z**2, (i, 1, z), (j, 1, z))


# Counted towards the tip, and towards the centre.
HALF_OF_THE_DEVIATION = all_of(
    Equality(dh_gauge + e_tip / 2, height_towards_tip),
    Equality(dh_gauge - e_tip / 2, height_deviation),
)

# Percentage of good teeth rejected, tip of IT6, steps as printed, for the two intervals.
REJECTED = {(Rational(GAUGE_UM, 2), 3): "8.4", (Rational(GAUGE_UM), 2): "48.0"}


def reject(number: str, limit_error: Rational, multiple: int) -> PrintedNumber:
    """State the percentage of good teeth rejected for a limit error of `multiple` sigma."""
    return PrintedNumber(number, 100 * rejected_by(6, limit_error, multiple))


FULL, HALF = REJECTED


def wheels_rejected(grade: int) -> Expr:
    """Share of wheels with only good teeth of which a tooth is rejected by steps 1 to 10."""
    return NORMAL_SHARE**TEETH - (NORMAL_SHARE - rejected_by(grade, 0)) ** TEETH


ROWS = (
    PRINT.claim(
        "step 1",
        defines=(K,),
        note="Printed in words: the ratio of the tolerance field to the standard deviation.",
    ),
    PRINT.equation(
        "step 2",
        defines=(f_true,),
        note="For the sign of E_cs see 'smallest deviation, smallest prescribed decrease'.",
        marks=("rebuilt",),
    ),
    PRINT.claim(
        "step 3, a new tip deviation for each tooth",
        Equality(variance_of_wheel_mean(sigma_tip**2 * KroneckerDelta(i, j)), sigma_tip**2),
        corrected=Correction(
            r"\text{per wheel: simulate }e_{dau}\text{, the same for all of its teeth}",
            Equality(variance_of_wheel_mean(sigma_tip**2), sigma_tip**2),
        ),
        note="The variance of the mean tip deviation over the z teeth of a wheel is compared. A "
        "wheel has one tip circle, so that its deviation is common to all teeth and does not "
        "average out. Shares over the teeth of many wheels are the same either way.",
    ),
    ours(
        "step 3, IT grades",
        r"120<d_a=156\le180~\mathrm{mm},\quad\mathrm{IT}6=25,\ \mathrm{IT}7=40,\ "
        r"\mathrm{IT}8=63~\mu\mathrm{m}",
        all_of(
            less(S(RANGE[0]), S(TIP_DIAMETER)),
            not_above(S(TIP_DIAMETER), S(RANGE[1])),
            *(
                PrintedNumber(str(value), factor * TOLERANCE_UNIT)
                for factor, value in GRADES.values()
            ),
        ),
        note="ISO 286-1: 10, 16 and 25 i, i = 0.45 ∛D + 0.001 D, D = √(120·180) mm; "
        "d_a = m (z + 2), addendum of one module, as the height to the constant chord shows.",
        marks=("calibrated",),
    ),
    PRINT.claim(
        "steps 4 and 7, spread of the gauge",
        Completions(
            "which interval it is and how many standard deviations it spans",
            Completion(
                "its full width, of 3 sigma to either side: 8.4 % of good teeth are rejected",
                reject(REJECTED[FULL], *FULL),
            ),
            Completion(
                "half of its width, of 2 sigma: 8.4 % of good teeth are rejected",
                reject(REJECTED[FULL], *HALF),
            ),
        ),
        note="The conclusions write their interval with a sign, U = ±2 µm; this one has none. Tip "
        "of IT6, steps as printed, normal laws, centred. Nor does the text at hand say how a "
        "standard deviation follows from an IT grade.",
        marks=("calibrated",),
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
        corrected=Correction(r"\Delta h=\Delta h_c\pm\tfrac12e_{dau}", HALF_OF_THE_DEVIATION),
        note="The gauge stands on the tip circle, so half the deviation of the diameter counts. "
        "The text at hand does not say which way heights are counted: the step fails both towards "
        "the tip (plus) and towards the centre (minus), and the correction is proved for both. "
        "The verdict rests on the words 'diameter of the tooth tips', in step 3 and column 4, not "
        "on a subscript.",
        marks=("rebuilt",),
    ),
    ours(
        "step 5, half the deviation",
        r"\Delta h=-\tfrac12e_{dau}+\Delta h_c",
        HALF_OF_THE_DEVIATION.parts[1],
        note="With heights counted towards the centre, as (1) and steps 6 and 8 have them, which "
        "are proved with K_m > 0; counted towards the tip, the sign is plus.",
    ),
    ours(
        "steps 5 and 6, variance",
        r"D_{\text{printed}}-D_{\text{geometry}}=3\,\mathrm{tg}^2\alpha\,\sigma_d^2",
        Equality(
            error_variance(K_m, K_m) - error_variance(-influence / 2, influence),
            3 * tan(alpha) ** 2 * sigma_tip**2,
        ),
        note="The printed steps make the tip's part of the variance four times too large. The "
        "sign does not affect the variance; it shifts the mean if the tip or the gauge has a "
        "bias.",
        marks=("consequence",),
    ),
    ours(
        "letters of two meanings",
        r"\Delta h_c,\ \Delta S_c\text{: from the tip circle and the height (text), errors of the "
        r"gauge (chart)}",
        all_of(
            Distinct((e_tip + dh_gauge).subs(dh_gauge, height_deviation), height_deviation),
            Distinct((E_true + K_m * dh + ds_gauge).subs(ds_gauge, K_m * dh), reading),
        ),
        note="With the meanings of the text, step 5 would count the tip diameter twice, and step "
        "8 the height.",
    ),
    PRINT.equation(
        "step 8",
        derived={E_measured: reading},
        substituted={ds_height: K_m * dh},
        note="The indication less the nominal chord, to first order, for a tooth whose flanks are "
        "turned to its true deviation and that is measured along a line deeper by Δh; step 6 "
        "is inserted.",
        marks=("rebuilt",),
    ),
    PRINT.equation(
        "step 9",
        defines=(f_measured,),
        note="Acceptance limits equal to the tolerance limits: no guard band.",
        marks=("rebuilt",),
    ),
    PRINT.claim(
        "step 10",
        all_of(*(Definition(share, of_tooth) for share, of_tooth in SHARES_OF_TOOTH.items())),
        note="Wrongly accepted is the consumer's risk of JCGM 106, wrongly rejected the "
        "producer's.",
    ),
    PRINT.claim(
        "step 10, per cent of parts",
        Equality(rejected_by(6, 0), wheels_rejected(6)),
        readings=(Reading("every tooth is a part, and the four shares are all teeth", ALL_TEETH),),
        corrected=PRINT.mend("step 10, per cent of parts", "parts", "teeth", ALL_TEETH),
        note="The shares wrongly rejected are compared. The blocks count teeth; the part that is "
        "sorted is a wheel, and a good wheel is rejected as soon as one of its teeth is. Perfect "
        "gauge, tip of IT6, steps as printed, K = 6, normal laws, centred; each tooth by itself, "
        "as in step 3.",
        marks=("calibrated",),
    ),
)
