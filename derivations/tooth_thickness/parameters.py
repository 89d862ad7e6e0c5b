"""Rows of paper 3 on the parameters that its flow chart controls."""

from __future__ import annotations

from sympy import Rational, S, tan

from mechproof.record import Claim, Completion, Completions, Correction, Distinct, Equality

from .._metrology import normal_between
from .._relations import less
from .geometry import height_deviation, reading
from .shares import (
    NORMAL_SHARE,
    THREE_SIGMA,
    accepted_by,
    measurement_spread,
    rejected_by,
    tip_spread,
    wrongly_rejected,
)
from .symbols import E_true, K_m, alpha, dh, dh_gauge, ds_gauge, e_tip
from .wheel import GAUGE_UM, TOLERANCE_UM

GAUGE_LIMIT = Rational(GAUGE_UM, 2)
SHARE = wrongly_rejected(tip_spread(6))

PARAMETER_ROWS = (
    Claim(
        "controlled parameters, grade of the tip diameter",
        r"\text{the IT grade of the tip diameter}",
        less(measurement_spread(6, S.Zero), measurement_spread(7, S.Zero)),
        note="Steps 3, 5 and 6 as printed: the grade changes the error of measurement.",
    ),
    Claim(
        "controlled parameters, accuracy degree",
        r"\text{the accuracy degree of the wheel changes the shares}",
        Completions(
            "what the degree sets",
            Completion(
                f"not T_c, which goes with the mating: {TOLERANCE_UM} um stay",
                Distinct(wrongly_rejected(tip_spread(6), tolerance=TOLERANCE_UM), SHARE),
            ),
            Completion(
                "T_c: 56 um for degree 7",
                Distinct(wrongly_rejected(tip_spread(6), tolerance=56), SHARE),
            ),
        ),
        note="No formula has the degree; it can act through T_c alone, printed for degree 6 only. "
        "Perfect gauge, tip of IT6, normal laws, centred.",
        marks=("inferred",),
    ),
    Claim(
        "controlled parameters, expectation of the thickness",
        r"\text{the expectation of the thickness deviation}",
        less(normal_between(S.One, S.One, -THREE_SIGMA, THREE_SIGMA), NORMAL_SHARE),
        note="A sixth of the field off its middle, fewer teeth are good.",
    ),
    Claim(
        "controlled parameters, expectation of the instrument's error",
        r"\text{the expectation of the instrument's error}",
        less(accepted_by(6, GAUGE_LIMIT, expected=GAUGE_LIMIT), accepted_by(6, GAUGE_LIMIT)),
        note="A gauge that reads off by as much as its limit error on the average accepts fewer "
        "teeth; half of 50 um, 3 sigma, tip of IT6, normal laws, centred.",
    ),
    Claim(
        "controlled parameters, expectation of the error",
        r"\text{steps 5 to 8: the mean error is }K_m(\mu_d+\mu_h)+\mu_S",
        Equality(
            K_m * (e_tip + dh_gauge) + ds_gauge,
            (reading - E_true).subs(dh, height_deviation),
        ),
        corrected=Correction(
            r"\mathrm{tg}\,\alpha\,(2\mu_h-\mu_d)+\mu_S",
            Equality(
                tan(alpha) * (2 * dh_gauge - e_tip) + ds_gauge,
                (reading - E_true).subs(dh, height_deviation),
            ),
        ),
        note="With the expectations for the errors, as the mean is linear. Where an expectation "
        "is not zero the sign of step 5 matters.",
        marks=("ours",),
    ),
    Claim(
        "controlled parameters, what is not among them",
        r"\text{the limit error of the gauge changes the shares, too}",
        less(rejected_by(6, 0), rejected_by(6, 10)),
        note="The printed list has four parameters; Figs. 4 and 5 are drawn over this fifth one.",
        marks=("ours",),
    ),
)
