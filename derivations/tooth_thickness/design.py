"""Rows of paper 3 on design data, smallest deviation, measuring base, controlled parameters."""

from sympy import Rational, S, atan, cos, diff, pi, tan

from mechproof.record import (
    Definition,
    Distinct,
    Equality,
    NotCheckable,
    PrintedNumber,
    Reading,
    all_of,
    less,
    not_above,
    ours,
)

from .._metrology import normal_between
from .mechanics import (
    GAUGE_UM,
    HEIGHTS_TO_0_1_MM,
    MODULE,
    NORMAL_SHARE,
    TEETH,
    THREE_SIGMA,
    TOLERANCE_UM,
    accepted_by,
    at_angle,
    chord_height,
    good_but_rejected,
    height_change,
    height_deviation,
    involute_chord,
    involute_distance,
    measurement_spread,
    nominal_height,
    of_wheel,
    rack_chord,
    rack_height,
    reading,
    side_clearance,
    thickness_change,
    tip_radius,
    tip_spread,
)
from .symbols import *

DESIGN_ROWS = (
    PRINT.claim("data, pitch diameter", PrintedNumber("150", MODULE * S(TEETH))),
    PRINT.datum(
        "data, constant chord",
        Definition(s_c, Rational("4.161") * millimetre),
        note="A datum. The profile angle, which is not in the text at hand, was fitted to it: 20°"
        ", see 'data, profile angle'.",
        marks=("fitted",),
    ),
    PRINT.claim(
        "data, height to the constant chord",
        PrintedNumber("2.243", at_angle(rack_height, 20)),
        note="By the 20° from the constant chord, with an addendum of one module.",
        marks=("calibrated",),
    ),
    ours(
        "data, profile angle",
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
        note="Chord and height both fall as the angle grows (up to 45°). At 19.99° the chord "
        "is already too long, at 20.01° the height is too small.",
        quantities=("constant_chord", "chord_height"),
    ),
    ours(
        "constant chord",
        r"\bar S_c=\frac{\pi m}2\cos^2\alpha",
        Equality(rack_chord, involute_chord),
        note="The chord along which the rack touches both flanks at once, by the rack (foot of the "
        "perpendicular from the pitch point) and by the involute; the number of teeth "
        "cancels.",
        quantities=("constant_chord",),
    ),
    ours(
        "height to the constant chord",
        r"\bar h_c=m\left(1-\frac\pi8\sin2\alpha\right)",
        all_of(Equality(chord_height, rack_height), Equality(rack_height, nominal_height)),
        note="By the rack and by the involute, with an addendum of one module.",
        quantities=("chord_height",),
    ),
    PRINT.datum(
        "data, smallest deviation",
        defines=(E_cs,),
        note="A datum; for its sign see 'smallest deviation, smallest prescribed decrease'.",
    ),
    PRINT.datum("data, tolerance", defines=(T_c,), note="A datum."),
    PRINT.claim(
        "smallest deviation, smallest prescribed decrease",
        not_above(E_cs, -(E_cs - T_c * place)),
        readings=(
            Reading(
                "E_cs enters step 2 with its sign, as the upper deviation -12 µm",
                not_above(E_cs, -(-E_cs - T_c * place)),
            ),
        ),
        corrected=PRINT.mend(
            "smallest deviation, smallest prescribed decrease",
            "E_{cs}-T_c<E_{csu}<",
            "-E_{cs}-T_c<E_{csu}<-",
            not_above(E_cs, -(-E_cs - T_c * place)),
        ),
        note="E_csu = E_cs - T_c p, 0 < p < 1, is any tooth that step 2 calls good; its decrease "
        "is -E_csu. With E_cs = 12 µm as printed, good teeth may be thicker than nominal. To "
        "simulate a decrease instead of a deviation does not help: step 2 would then admit "
        "only decreases below E_cs.",
        marks=("rebuilt",),
    ),
    PRINT.claim(
        "smallest deviation, guaranteed side clearance",
        Equality(diff(side_clearance, E_cs), cos(alpha)),
        note="As a decrease it gives E_cs cos(alpha) along the normal; the mating wheel and the "
        "centre distance contribute to the clearance, too.",
    ),
    PRINT.claim(
        "smallest deviation, kind of mating",
        NotCheckable(
            "which clearance belongs to which kind of mating: that stands in the tables of the "
            "standard cited as [2], of which the text at hand has no number"
        ),
    ),
    PRINT.claim(
        "measuring base, nominal tip diameter",
        Equality(tip_radius - rack_height, involute_distance),
        note="Measured from the nominal tip circle, with the outer cylinder as base, the height "
        "leads to the constant chord of the involute.",
    ),
    PRINT.claim(
        "measuring base, tip diameter not nominal",
        Equality(tip_radius + e_tip / 2 - rack_height - involute_distance, e_tip / 2),
        note="The line of a gauge that stands on the actual tip circle and is set to the nominal "
        "height, compared with the constant chord of the involute: it is off by half the "
        "deviation of the diameter, towards the tip if the circle is larger.",
    ),
    PRINT.claim(
        "measuring base, thickness",
        all_of(
            *(
                not_above(*(side.subs(tilt, tilt * way) for side in sides))
                for way, sides in (
                    (1, (-of_wheel(height_change) / 2, -of_wheel(thickness_change))),
                    (-1, (of_wheel(height_change) / 2, of_wheel(thickness_change))),
                )
            )
        ),
        on=HEIGHTS_TO_0_1_MM,
        note="On the involute of this wheel the thickness is off by at least half as much; deeper "
        "is thicker, so that a larger tip diameter makes the tooth measure thinner.",
        marks=("calibrated",),
    ),
)

GAUGE_LIMIT = Rational(GAUGE_UM, 2)
SHARE = good_but_rejected(tip_spread(6))

PARAMETER_ROWS = (
    PRINT.claim(
        "controlled parameters",
        all_of(
            less(measurement_spread(6, S.Zero), measurement_spread(7, S.Zero)),
            Distinct(good_but_rejected(tip_spread(6), tolerance=TOLERANCE_UM + 1), SHARE),
            less(normal_between(S.One, S.One, -THREE_SIGMA, THREE_SIGMA), NORMAL_SHARE),
            less(accepted_by(6, GAUGE_LIMIT, bias=GAUGE_LIMIT), accepted_by(6, GAUGE_LIMIT)),
        ),
        note="Each of them changes the shares: the grade by the error of measurement; the degree "
        "by T_c and E_cs, which depend on it by GOST 1643-81, shown for a change of one "
        "micrometre; the mean deviation, shown for a sixth of the field off its middle; the mean "
        "error of the gauge, shown for its limit error in height and thickness, half of 50 µm, 3 "
        "sigma. The limit error, over which Figs. 4 and 5 are drawn, is not in the list. Normal "
        "laws, tip of IT6.",
        marks=("calibrated",),
    ),
    ours(
        "controlled parameters, mean error",
        r"\mathrm E\,(E_{cs0}-E_{csu})=\mathrm{tg}\,\alpha\,(2\mu_h-\mu_d)+\mu_S",
        Equality(
            tan(alpha) * (2 * dh_gauge - e_tip) + ds_gauge,
            (reading - E_true).subs(dh, height_deviation),
        ),
        note="How the expectations of tip diameter, height and thickness shift the mean "
        "indication: where they are not zero the sign in step 5 matters, and the printed steps "
        "give K_m (mu_h + mu_d) + mu_S.",
        marks=("consequence",),
    ),
)
