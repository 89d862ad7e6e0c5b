"""Rows of paper 3 on design data, deviations, parameters; (1) and step 6: height and thickness."""

from sympy import Expr, Rational, S, atan, cos, diff, pi, sin, tan

from mechproof.record import *

from ..._metrology import normal_between
from ..mechanics import *

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
        note="With the 20° fitted to the constant chord, and an addendum of one module.",
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
        "is -E_csu. With E_cs = 12 µm as printed, good teeth may be thicker than nominal. "
        "Simulating a decrease instead of a deviation does not help: step 2 would then admit only "
        "decreases below E_cs.",
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


in_print = read("step 6, influence of the involute")[1].subs(dh, height_change)
excess_in_print = of_wheel(in_print - thickness_change)
excess_of_0_7284 = of_wheel(PRINTED_INFLUENCE * height_change - thickness_change)
# The tilt of a chord nearer to the tip, in 1e-6, between which the secant has the printed slope.
SECANT = (Rational(405, 10**6), Rational(406, 10**6))


def good_to_the_last_place(excess: Expr) -> Conjunction:
    """State that an excess (mm) is below one unit in the paper's last place, for its height.

    It covers tilts of both signs; deeper chords have negative ones.
    """
    return all_of(
        *(
            not_above(sign * excess.subs(tilt, way * tilt), height)
            for way in (1, -1)
            for height in (-way * LAST_SHARE * of_wheel(height_change).subs(tilt, way * tilt),)
            for sign in (1, -1)
        )
    )


INFLUENCE_ROWS = (
    PRINT.equation(
        "(1), influence 0.7284",
        good_to_the_last_place(excess_of_0_7284),
        on=HEIGHTS_TO_0_1_MM,
        note="An approximation, as the paper says. For this wheel it is judged to one micrometre, "
        "the last place of the paper's deviations, at a height that is off by 0.1 mm, and in "
        "proportion for less. See '(1), where 0.7284 is the slope'.",
        marks=("calibrated", "inferred"),
    ),
    ours(
        "(1), exact derivative",
        r"\frac{dS}{dh}=2\,\mathrm{tg}\,\delta,\quad\delta=\alpha\text{ at the constant chord}",
        all_of(Equality(slope_of_thickness, 2 * tan(delta)), Equality(K_m, influence)),
        note="On the involute itself; delta is the angle between the tangent of the flank and the "
        "axis of the tooth. On the rack the derivative is 2 tan(alpha) at every height.",
        quantities=("thickness_change_linear",),
    ),
    ours(
        "(1), where 0.7284 is the slope",
        r"2\,\mathrm{tg}\,20^\circ=0.7279,\quad\Delta S=0.7284\,\Delta h\text{ at }\Delta h=-11~"
        r"\mu\mathrm{m}",
        all_of(
            PrintedNumber("0.7279", of_wheel(K_m)),
            *(
                PrintedNumber("-0.011", of_wheel(height_change).subs(tilt, turned))
                for turned in SECANT
            ),
            less(excess_of_0_7284.subs(tilt, SECANT[0]), S.Zero),
            less(S.Zero, excess_of_0_7284.subs(tilt, SECANT[1])),
        ),
        note="0.7279 is the slope at the constant chord; the secant from there to a chord 11 µm "
        "nearer the tip, within half of IT6, has the printed slope. For heights that are off by "
        "up to 0.1 mm the two differ by less than 0.05 µm.",
        marks=("calibrated",),
    ),
    PRINT.equation(
        "step 6, influence of the involute",
        good_to_the_last_place(excess_in_print),
        on=HEIGHTS_TO_0_1_MM,
        note="An approximation, as the paper says, judged as (1) was; the product is never too "
        "small: see 'step 6, excess of the linear model', on the page of the linearisation bound.",
        marks=("rebuilt", "calibrated"),
    ),
    ours(
        "step 6, tilt as parameter",
        r"\Delta h(\varepsilon)=y(\alpha)-y(\alpha+\varepsilon),\ "
        r"\Delta S(\varepsilon)=S(\alpha+\varepsilon)-S(\alpha)",
        all_of(
            Equality(height_change, involute_distance - chord_distance(alpha + tilt, half_tooth)),
            Equality(thickness_change, 2 * chord_half(alpha + tilt, half_tooth) - involute_chord),
        ),
        note="The closed forms of the kernels, compared with the involute.",
        quantities=("height_change", "thickness_change"),
    ),
    ours(
        "step 6, curvature",
        r"\frac{d^2S}{dh^2}=-\frac{2}{r_b t\cos^3\delta},\quad y\cos\delta-\tfrac S2\sin\delta="
        r"r_b,\quad (r_bt)^2=y^2+\tfrac{S^2}4-r_b^2",
        all_of(
            Equality(curvature_of_thickness, -2 / (r_b * roll * cos(delta) ** 3)),
            Equality(distance * cos(delta) - thickness / 2 * sin(delta), r_b),
            Equality((r_b * roll) ** 2, distance**2 + thickness**2 / 4 - r_b**2),
        ),
        note="r_b t is the radius of curvature of the flank; the linear model is never too small. "
        "By the second, cos(delta) >= r_b/y wherever S >= 0 and 0 <= delta < pi/2; by the third, "
        "deeper chords being thicker, r_b t falls by no more than y^2 does.",
        quantities=("linearisation_bound",),
    ),
    ours(
        "step 6, excess of the linear model",
        r"K_m\Delta h-\Delta S=mz\,N,\ N(0)=0,\ \frac{dN}{d\varepsilon}="
        r"(t_c+\varepsilon)\sin\varepsilon",
        all_of(
            Equality(m * z * across, K_m * height_change - thickness_change),
            Equality(across.subs(tilt, 0), S.Zero),
            Equality(diff(across, tilt), (t_c + tilt) * sin(tilt)),
            Equality(s_c, involute_chord),
            Equality(y_c, involute_distance),
            Equality(linearisation_root, (y_c - dh) ** 2 + s_c**2 / 4 - r_b**2),
        ),
        note="N = t_c (1 - cos(tilt)) + sin(tilt) - tilt cos(tilt), the tilt being epsilon. With "
        "'step 6, curvature', Taylor's remainder gives the bound of the kernel: "
        "dh^2 (y_c + |dh|)^3/(r_b^3 R), R^2 the last part with |dh| for dh, for "
        "|dh| <= y_c - r_b, up to the tip.",
        quantities=("thickness_change_linear", "linearisation_bound"),
    ),
)

ROWS = (*DESIGN_ROWS, *INFLUENCE_ROWS, *PARAMETER_ROWS)
