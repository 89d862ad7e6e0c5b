"""Rows of paper 3 on the example of Table 1."""

from __future__ import annotations

from sympy import Rational, S

from mechproof.record import (
    Claim,
    Completion,
    Completions,
    Datum,
    Definition,
    Equality,
    PrintedNumber,
)

from .._relations import all_of, less
from .mechanics import (
    GAUGE_UM,
    GRADES,
    NORMAL_SHARE,
    PRINT,
    TEETH,
    TOLERANCE_UM,
    E_true,
    K,
    K_m,
    clearance,
    degree,
    dh,
    dh_gauge,
    ds_gauge,
    e_tip,
    height_deviation,
    interval,
    millimetre,
    reading,
    tip_tolerance,
)

EXAMPLE_ROWS = (
    Datum(
        "Table 1, accuracy degree",
        r"6\text{ of }6\mathrm H",
        Definition(degree, S(6)),
        note="A datum; no formula of the paper uses it.",
    ),
    Datum(
        "Table 1, kind of mating",
        r"\mathrm H\text{ of }6\mathrm H",
        Definition(clearance, S.Zero),
        note="A datum; no formula of the paper uses it. That H asks for no guaranteed clearance is "
        "from GOST 1643; the paper names no standard.",
        marks=("inferred",),
    ),
    PRINT.datum(
        "Table 1, ratio of tolerance and standard deviation",
        defines=(K,),
        note="A datum, called the normal accuracy of the technology in step 1.",
    ),
    Datum(
        "Table 1, grade of the tip diameter",
        r"\text{tip diameter of IT6}",
        Definition(tip_tolerance, Rational(GRADES[6][1], 1000) * millimetre),
        note="A datum; 25 um of ISO 286-1 is no print of the paper (see 'step 3, IT6').",
    ),
    Datum(
        "Table 1, interval of the gauge",
        r"\text{interval measure of the uncertainty }50~\mu\mathrm{m}",
        Definition(interval, Rational(GAUGE_UM, 1000) * millimetre),
        note="A datum; which interval is meant, 'steps 4 and 7, spread of the gauge' asks.",
    ),
    Claim(
        "Table 1, uncertainty of the gauge",
        r"50~\mu\mathrm{m}\text{ against the tolerance of }45~\mu\mathrm{m}",
        Completions(
            "what the limit error of the gauge is",
            Completion(
                "full width: the largest error is below the tolerance",
                less(Rational(GAUGE_UM, 2), S(TOLERANCE_UM)),
            ),
            Completion(
                "half the width: the same",
                less(S(GAUGE_UM), S(TOLERANCE_UM)),
            ),
        ),
        note="In both readings far above the usual tenth of the tolerance.",
        marks=("ours",),
    ),
    Claim(
        "Table 1, column 9",
        r"(9)=(2)+(7)+(8)",
        Equality(E_true + K_m * dh + ds_gauge, reading),
        note="True deviation, thickness error from the shift, gauge; as in step 8.",
    ),
    Claim(
        "Table 1, columns 4 to 6",
        r"(6)=(4)+(5)",
        Completions(
            "what column 4 lists",
            Completion(
                "column 4 lists the deviation of the diameter",
                Equality(e_tip + dh_gauge, height_deviation),
            ),
            Completion(
                "column 4 lists half of it, counted towards the centre",
                Equality(e_tip + dh_gauge, height_deviation.subs(e_tip, -2 * e_tip)),
            ),
        ),
        note="Total shift from tip diameter and gauge, as in step 5; the rule is read from there.",
        marks=("inferred",),
    ),
    Claim(
        "Table 1, number of teeth",
        r"50\text{ deviations: as many as the wheel has teeth}",
        PrintedNumber("50", S(TEETH)),
        marks=("ours",),
    ),
    Claim(
        "Table 1, 50 of 50",
        r"50\text{ of }50\text{, i.e. }100~\%",
        PrintedNumber("100", 100 * Rational(50, 50)),
        note="Right as the share in the sample; of all teeth see 'step 1, normal accuracy'.",
    ),
    Claim(
        "Table 1, 50 of 50, what it is compatible with",
        r"p^{50}\ge0.05\text{ down to }p=94.2~\%",
        all_of(
            less(Rational(1, 20), Rational("0.942") ** 50),
            less(Rational("0.941") ** 50, Rational(1, 20)),
        ),
        note="Clopper and Pearson: the one-sided 95 % bound lies between 94.1 and 94.2 % good.",
        marks=("ours",),
    ),
    Claim(
        "Table 1, 50 of 50, how often",
        r"0.87<\mathrm{erf}(3/\sqrt2)^{50}<0.88",
        all_of(
            less(Rational("0.87"), NORMAL_SHARE**50),
            less(NORMAL_SHARE**50, Rational("0.88")),
        ),
        note="The chance of 50 good teeth in 50 at K = 6, centred.",
        marks=("ours",),
    ),
)
