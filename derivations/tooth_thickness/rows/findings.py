"""What is wrong in paper 3, what it costs, and how to see it."""

from sympy import Rational, S, sqrt

from mechproof.record import Check, Cost, Finding, Weight

from ..mechanics import *
from .algorithm import wheels_rejected

MICROMETRE = Rational(1, 1000)
LAWS = f"normal laws, centred, K = {K_PRINTED}"
READINGS_OF_50 = ("if 3 sigma are ±25 µm", "if 2 sigma are ±50 µm")
SPREAD_6 = Rational(GRADES[6][1], K_PRINTED) * MICROMETRE
# A tip circle off by the whole tolerance, a gauge without error.
TIP_6 = {**WHEEL, e_tip: GRADES[6][1] * MICROMETRE, dh_gauge: S.Zero}


# Standard deviations of the thickness from the recommended gauge (3 sigma) and from a tip of IT6.
RECOMMENDED_SPREADS = (
    gauge_spread(Rational(RECOMMENDED_UM, 3), "involute") * MICROMETRE,
    tip_spread(6, "involute") * MICROMETRE,
)

FINDINGS = (
    Finding(
        "step 5",
        "Step 5 adds the whole deviation of the tip diameter to the height. The gauge stands on "
        "the tip circle, so only half of that, the deviation of the radius, can enter. Steps 6 "
        "and 8 hold with heights counted towards the centre; a larger tip circle then counts as "
        "negative.",
        costs=(
            Cost(
                f"good teeth rejected, tip of IT8, perfect gauge, {LAWS}",
                "%",
                2,
                rejected_by(8, 0),
                rejected_by(8, 0, geometry="involute"),
            ),
            Cost(
                f"Δh for a tip diameter {GRADES[6][1]} µm too large (IT6)",
                "µm",
                printed=e_tip + dh_gauge,
                right=dh_gauge - e_tip / 2,
                at=TIP_6,
            ),
            Cost(
                "measured thickness for it",
                "µm",
                printed=(e_tip + dh_gauge) * K_m,
                right=(dh_gauge - e_tip / 2) * K_m,
                at=TIP_6,
            ),
        ),
        follows=("Table 1, columns 4 to 6",),
        weight=Weight.CONCLUSION,
        mend="step 5, half the deviation",
        check=Check(
            f"A tip circle of {TIP_DIAMETER}.025 mm instead of {TIP_DIAMETER} mm has a radius that "
            "is {0} larger.",
            (Rational(GRADES[6][1], 2) * MICROMETRE,),
            1,
            "µm",
        ),
        figure="fig-4",
    ),
    Finding(
        "(d)",
        "The paper rejects IT8 and recommends IT7 by steps that count the whole deviation of the "
        "tip diameter. With half of it, IT8 disturbs the measurement less than IT7 does by the "
        "printed steps, and IT7 less than IT6: the recommended grades 6 and 7 are each one grade "
        "too fine.",
        costs=(
            Cost(
                f"good teeth rejected, perfect gauge, {LAWS}",
                "%",
                2,
                printed=rejected_by(7, 0),
                right=rejected_by(8, 0, geometry="involute"),
                names=("IT7 as printed", "IT8 by the geometry"),
            ),
        ),
        weight=Weight.CONCLUSION,
        check=Check(
            "By the printed steps IT7 changes the thickness by 0.7284·40 µm = {0}, by the "
            "geometry IT8 changes it by tg 20°·63 µm = {1}.",
            tuple(K_PRINTED * s * MICROMETRE for s in (tip_spread(7), tip_spread(8, "involute"))),
            1,
            "µm",
        ),
        figure="fig-4",
    ),
    Finding(
        "(b)",
        "The gauge matters more than a tip diameter of IT6 only above a limit error of 2.5 to 3.7 "
        "µm; for the gauge that (c) recommends it is the other way round.",
        costs=(
            Cost(
                f"spread of the thickness, gauge of ±{RECOMMENDED_UM} µm (3 sigma), tip of IT6",
                "µm",
                2,
                *RECOMMENDED_SPREADS,
                names=("gauge", "tip diameter"),
            ),
        ),
        weight=Weight.CONCLUSION,
        mend="(b), crossovers",
        check=Check(
            "Tip: tg 20°·25 µm/6 = {0}; gauge: √(1 + 0.7279²)·2 µm/3 = {1}.",
            RECOMMENDED_SPREADS[::-1],
            2,
            "µm",
        ),
        figure="fig-4",
    ),
    Finding(
        "smallest deviation, smallest prescribed decrease",
        "E_cs = 12 µm is called the smallest prescribed decrease, but with its plus sign step 2 "
        "passes teeth that are up to 12 µm thicker than nominal; it has to enter with a minus.",
        costs=(
            Cost(
                "thickest good tooth, from nominal",
                "µm",
                0,
                DECREASE_UM * MICROMETRE,
                -DECREASE_UM * MICROMETRE,
            ),
        ),
        check=Check(
            "Step 2 passes deviations from {0} to {1}, among them that of the nominal tooth, "
            "which has no decrease at all.",
            ((DECREASE_UM - TOLERANCE_UM) * MICROMETRE, DECREASE_UM * MICROMETRE),
            0,
            "µm",
        ),
    ),
    Finding(
        "step 3, a new tip deviation for each tooth",
        "The rows are the teeth of one wheel, and each is given a new deviation of the tip "
        "diameter; but a wheel has one tip circle, whose error does not average out over its "
        "teeth.",
        costs=(
            Cost(
                "spread of the tip circle's mean over the wheel, IT6",
                "µm",
                printed=SPREAD_6 / sqrt(TEETH),
                right=SPREAD_6,
                names=("a deviation per tooth", "one per wheel"),
            ),
        ),
        check=Check(
            "25 µm/6 = {0} for every tooth; the mean of 50 such teeth has {0}/√50 = {1}.",
            (SPREAD_6, SPREAD_6 / sqrt(TEETH)),
            1,
            "µm",
        ),
    ),
    Finding(
        "step 10, per cent of parts",
        "The indices are called percentages of parts, but teeth are counted; a wheel is "
        f"rejected as soon as one of its {TEETH} teeth is, which happens far more often.",
        costs=(
            Cost(
                "wrongly rejected, tip of IT6, perfect gauge, steps as printed, a tip deviation "
                "for each tooth",
                "%",
                2,
                printed=rejected_by(6, 0),
                right=wheels_rejected(6),
                names=("of teeth", "of wheels"),
            ),
        ),
        check=Check(
            f"With {{0}} good teeth, and {{1}} good but rejected, {{0:4}}^{TEETH} - ({{0:4}} - "
            f"{{1:6}})^{TEETH} = {{2}} of the wheels are good and rejected.",
            (NORMAL_SHARE, rejected_by(6, 0), wheels_rejected(6)),
            2,
            "%",
        ),
    ),
    Finding(
        "steps 4 and 7, spread of the gauge",
        "The text at hand does not say what interval the 50 µm of the gauge stand for, nor how "
        "many standard deviations they span; without that steps 4 and 7 cannot be repeated.",
        costs=(
            Cost(
                f"good teeth rejected, tip of IT6, steps as printed, {LAWS}",
                "%",
                printed=rejected_by(6, Rational(GAUGE_UM, 2), 3),
                right=rejected_by(6, GAUGE_UM, 2),
                names=READINGS_OF_50,
            ),
        ),
        weight=Weight.FORMULA,
        check=Check(
            "±25 µm of 3 sigma: 25 µm/3 = {0}; ±50 µm of 2 sigma: 50 µm/2 = {1}.",
            (Rational(GAUGE_UM, 6) * MICROMETRE, Rational(GAUGE_UM, 2) * MICROMETRE),
            1,
            "µm",
        ),
    ),
)
