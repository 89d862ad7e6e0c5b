"""Rows of paper 3 on design data, smallest deviation, measuring base, controlled parameters."""

from __future__ import annotations

from sympy import Expr, Interval, Rational, S, acos, atan, cos, diff, oo, pi, sqrt, tan

from mechproof.record import (
    Claim,
    Completion,
    Completions,
    Correction,
    Definition,
    Distinct,
    Equality,
    Part,
    PrintedNumber,
    Reading,
)

from .._metrology import normal_between
from .._relations import all_of, less, not_above
from .mechanics import (
    DECREASE_UM,
    GAUGE_UM,
    HEIGHTS_TO_1_MM,
    MODULE,
    NORMAL_SHARE,
    PRINT,
    PROFILE_ANGLE,
    TEETH,
    THREE_SIGMA,
    TOLERANCE_UM,
    E_cs,
    E_true,
    K_m,
    T_c,
    accepted_by,
    alpha,
    at_angle,
    centre_change,
    chord_by_thinning,
    chord_height,
    dh,
    dh_gauge,
    ds_gauge,
    e_tip,
    good_but_rejected,
    height_change,
    height_deviation,
    incline,
    involute_chord,
    involute_distance,
    line_actual,
    m,
    mate,
    measurement_spread,
    millimetre,
    nominal_height,
    of_wheel,
    place,
    rack_chord,
    rack_height,
    reading,
    rejected_by,
    s_c,
    side_clearance,
    thickness_change,
    thinning,
    tilt,
    tip_radius,
    tip_spread,
)


def of_pair(too_long: int) -> Expr:
    """Give the clearance (um) of this wheel with a nominal mate, `too_long` um off the centre."""
    deviations = {E_cs: S(DECREASE_UM), mate: S.Zero, centre_change: S(too_long)}
    return side_clearance.subs({**deviations, alpha: PROFILE_ANGLE})


DESIGN_ROWS = (
    PRINT.claim("data, pitch diameter", says=PrintedNumber("150", MODULE * S(TEETH))),
    PRINT.datum(
        "data, constant chord",
        says=Definition(s_c, Rational("4.161") * millimetre),
        note="A datum. The profile angle, which is not printed, is fitted to it: 20 deg, see "
        "'data, profile angle'.",
        marks=("fitted",),
    ),
    PRINT.claim(
        "data, height to the constant chord",
        says=PrintedNumber("2.243", at_angle(rack_height, 20)),
        note="With 20 deg from the constant chord and an addendum of one module.",
        marks=("calibrated",),
    ),
    Claim(
        "data, profile angle",
        r"\bar S_c=4.161\text{ mm solved for the profile angle: }20.0^\circ",
        PrintedNumber("20.0", 180 / pi * acos(sqrt(2 * Rational("4.161") / (pi * MODULE)))),
        marks=("ours",),
    ),
    Claim(
        "data, no other profile angle",
        r"4.161\text{ and }2.243\text{, rounded, leave }19.99^\circ<\alpha<20.01^\circ",
        all_of(
            Equality(rack_chord.subs(alpha, atan(incline)), pi * m / 2 / (1 + incline**2)),
            less(diff(pi * m / 2 / (1 + incline**2), incline), S.Zero),
            Equality(
                rack_height.subs(alpha, atan(incline)),
                m * (1 - pi / 4 * incline / (1 + incline**2)),
            ),
            less(diff(m * (1 - pi / 4 * incline / (1 + incline**2)), incline), S.Zero),
            less(Rational("4.1615"), at_angle(rack_chord, "19.99")),
            less(at_angle(rack_height, "20.01"), Rational("2.2425")),
        ),
        note=(
            "Chord and height both fall as the angle grows (to 45 deg). At 19.99 deg the chord "
            "is too long already, at 20.01 deg the height is too small."
        ),
        marks=("ours",),
    ),
    Claim(
        "constant chord",
        r"\bar S_c=\frac{\pi m}2\cos^2\alpha",
        Equality(rack_chord, involute_chord),
        note=(
            "Where the rack touches both flanks at once, from the rack (foot of the perpendicular "
            "from the pitch point) and from the involute; the number of teeth drops out."
        ),
        marks=("ours",),
    ),
    Claim(
        "height to the constant chord",
        r"\bar h_c=m\left(1-\frac\pi8\sin2\alpha\right)",
        all_of(
            Equality(chord_height, rack_height),
            Equality(rack_height, nominal_height),
        ),
        note="From the rack and from the involute, addendum of one module.",
        marks=("ours",),
    ),
    PRINT.datum(
        "data, smallest deviation",
        defines=(E_cs,),
        note="A datum; its sign is a matter of 'smallest deviation'.",
    ),
    PRINT.datum("data, tolerance", defines=(T_c,), note="A datum."),
    Claim(
        "smallest deviation, smallest prescribed decrease",
        r"E_{cs}\text{ is the smallest prescribed decrease; good: }"
        r"E_{cs}-T_c<E_{csu}<E_{cs}",
        not_above(E_cs, -(E_cs - T_c * place)),
        readings=(
            Reading(
                "E_cs enters step 2 with its sign, as the upper deviation -12 um",
                not_above(E_cs, -(-E_cs - T_c * place)),
            ),
        ),
        corrected=Correction(
            r"-E_{cs}-T_c<E_{csu}<-E_{cs}", not_above(E_cs, -(-E_cs - T_c * place))
        ),
        note=(
            "E_csu = E_cs - T_c p, 0 < p < 1, is any good tooth of step 2; its decrease is -E_csu. "
            "With E_cs = 12 um as printed, good teeth may be thicker than nominal."
        ),
        marks=("rebuilt",),
    ),
    Claim(
        "smallest deviation, counted as a decrease",
        r"E_{csu}\text{ counts the decrease; good: }E_{cs}-T_c<E_{csu}<E_{cs}",
        not_above(E_cs, E_cs - T_c * place),
        corrected=Correction(r"E_{cs}<E_{csu}<E_{cs}+T_c", not_above(E_cs, E_cs + T_c * place)),
        note="If the simulated deviation is itself a decrease, step 2 admits only smaller ones.",
        marks=("ours",),
    ),
    Claim(
        "smallest deviation, nominal tooth",
        r"E_{csu}=0\text{ is good by step 2 with }E_{cs}=12,\ T_c=45~\mu\mathrm{m}",
        all_of(less(S.Zero, S(DECREASE_UM)), less(S(DECREASE_UM - TOLERANCE_UM), S.Zero)),
        note="A tooth with no decrease at all passes, though 12 um is the smallest prescribed one.",
        marks=("ours",),
    ),
    Claim(
        "smallest deviation, decrease and backlash",
        r"\text{a thinner pitch arc thins the constant chord by the same amount}",
        Equality(chord_by_thinning, thinning),
        note=(
            "First order, measured at the fixed height: dS = ds on the pitch circle, so this wheel "
            "gives the normal backlash E_cs cos(alpha)."
        ),
        marks=("ours",),
    ),
    Claim(
        "smallest deviation, guaranteed side clearance",
        r"E_{cs}\text{ determines the guaranteed side clearance}",
        not_above(E_cs, (side_clearance / cos(alpha)).expand().subs(alpha, atan(incline))),
        holds_on=Part(
            "a mate with no thicker teeth and a centre distance that is not too short",
            {mate: Interval(0, oo), centre_change: Interval(0, oo)},
        ),
        note="E_cs as a decrease, alone, guarantees E_cs cos(alpha) along the normal (decided with "
        "both over the cosine); the mate and the centre distance, for which nothing is printed, "
        "can take it away.",
    ),
    Claim(
        "smallest deviation, kind of mating",
        r"E_{cs}\text{ determines, through the side clearance, the kind of mating}",
        Completions(
            "deviation of the centre distance",
            Completion(
                "none: E_cs leaves no clearance, as for the mating H",
                not_above(of_pair(0), S.Zero),
            ),
            Completion(
                "20 um too short: the same",
                not_above(of_pair(-20), S.Zero),
            ),
        ),
        note="E_cs determines the kind of mating only together with what the errors of the pair "
        "take of the clearance, which is not printed. H asks for no guaranteed clearance in GOST "
        "1643; the paper names no standard.",
        marks=("inferred",),
    ),
    Claim(
        "measuring base, nominal tip diameter",
        r"\text{the measuring base for the height is the nominal tip diameter}",
        Equality(tip_radius - (rack_height + dh_gauge), line_actual),
        readings=(
            Reading(
                "the height is counted from the nominal tip diameter when it is set",
                Equality(tip_radius - rack_height, involute_distance),
            ),
        ),
        note="The gauge stands on the actual tip circle; from the nominal one the height to the "
        "constant chord is reckoned.",
    ),
    Claim(
        "measuring base, tip diameter not nominal",
        r"\text{if the tip diameter differs from nominal, the height gets an error}",
        Equality(tip_radius + e_tip / 2 - rack_height - involute_distance, e_tip / 2),
        note="The line of a gauge on the actual tip circle, set to the rack's height, against the "
        "involute's constant chord: off by half the deviation, towards the tip on a larger "
        "circle.",
    ),
    Claim(
        "measuring base, thickness",
        r"\text{the error of the height leads to an error of the thickness}",
        all_of(
            *(
                not_above(*(side.subs(tilt, tilt * way) for side in sides))
                for way, sides in (
                    (1, (-of_wheel(height_change) / 2, -of_wheel(thickness_change))),
                    (-1, (of_wheel(height_change) / 2, of_wheel(thickness_change))),
                )
            )
        ),
        on=HEIGHTS_TO_1_MM,
        note="On the involute of this wheel, the thickness is off by half as much at least; deeper "
        "is thicker, so a larger tip diameter makes the measured tooth thinner.",
        marks=("calibrated",),
    ),
)

GAUGE_LIMIT = Rational(GAUGE_UM, 2)
SHARE = good_but_rejected(tip_spread(6))

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
                Distinct(good_but_rejected(tip_spread(6), tolerance=TOLERANCE_UM), SHARE),
            ),
            Completion(
                "T_c: 56 um for degree 7",
                Distinct(good_but_rejected(tip_spread(6), tolerance=56), SHARE),
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
