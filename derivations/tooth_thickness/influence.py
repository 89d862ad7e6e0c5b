"""Rows of paper 3 on the influence of the height on the thickness: (1) and step 6."""

from __future__ import annotations

from sympy import Expr, Interval, Rational, S, atan, cos, diff, sin, tan

from mechproof.record import Claim, Correction, Equality, Holds, Part, PrintedNumber

from .._relations import all_of, less, not_above
from .mechanics import (
    GRADES,
    HEIGHTS_TO_0_1_MM,
    HEIGHTS_TO_1_MM,
    MODULE,
    NARROW,
    PRINT,
    PRINTED_INFLUENCE,
    WIDE,
    K_m,
    across,
    alpha,
    chord_distance,
    chord_half,
    curvature_of_thickness,
    delta,
    dh,
    distance,
    excess_of_wheel,
    half_tooth,
    height_change,
    incline,
    influence,
    involute_chord,
    involute_distance,
    linearisation_bound,
    linearisation_root,
    m,
    of_wheel,
    r_b,
    rack_chord,
    rack_height,
    read,
    roll,
    s_c,
    slope_of_thickness,
    t_c,
    thickness,
    thickness_change,
    tilt,
    y_c,
    z,
)

in_print = read("step 6, influence of the involute").subs(dh, height_change)
excess_in_print = of_wheel(in_print - thickness_change)
excess_of_0_7284 = of_wheel(PRINTED_INFLUENCE * height_change - thickness_change)
rack_chord_by_slope, rack_height_by_slope = (
    size.subs(alpha, atan(incline)).subs(m, MODULE) for size in (rack_chord, rack_height)
)


def reaches(turned: Rational, height: Expr) -> tuple[Holds, Holds]:
    """State that a tilt either way goes with more than a height (mm) either way."""
    return (
        less(of_wheel(height_change).subs(tilt, turned), -height),
        less(height, of_wheel(height_change).subs(tilt, -turned)),
    )


def rounds_at(size: Expr, end: Rational, influence_there: Rational) -> tuple[Holds, Holds]:
    """State that a size passes `end` between an influence and the next in its last place."""
    last_place = Rational(1, 10**5)
    return (
        less(end, size.subs(incline, influence_there / 2)),
        less(size.subs(incline, (influence_there + last_place) / 2), end),
    )


INFLUENCE_ROWS = (
    PRINT.equation(
        "(1), influence 0.7284",
        says=all_of(
            *(
                not_above(*(side.subs(tilt, tilt * way) for side in sides))
                for way in (1, -1)
                for sides in (
                    (excess_of_0_7284, -way * of_wheel(height_change) / 100),
                    (-excess_of_0_7284, -way * of_wheel(height_change) / 100),
                )
            )
        ),
        on=HEIGHTS_TO_1_MM,
        holds_on=HEIGHTS_TO_0_1_MM,
        note="An approximation by its own words, judged like step 6, to a hundredth of Delta h: up "
        "to 0.1 mm it is off by about 0.5 um at most. The slope at the constant chord is "
        "2 tan 20 deg = 0.7279, see '(1), cost of 0.7284'; of other profile angles see the next "
        "row.",
        marks=("calibrated", "inferred"),
    ),
    Claim(
        "(1), profile angles that the data leave",
        r"\bar h_c=2.243\text{ leaves }K_m\le0.72823;\ \bar S_c=4.161\text{ alone }K_m\le0.72842",
        all_of(
            less(diff(rack_chord_by_slope, incline), S.Zero),
            less(diff(rack_height_by_slope, incline), S.Zero),
            *rounds_at(rack_height_by_slope, Rational("2.2425"), Rational("0.72823")),
            *rounds_at(rack_chord_by_slope, Rational("4.1605"), Rational("0.72842")),
        ),
        note="K_m = 2 tan(alpha), and both fall as the angle grows: 2.2425 mm, where 2.243 ends, "
        "belongs to 0.72823 < K_m < 0.72824, 4.1605 mm to 0.72842 < K_m < 0.72843. The chord "
        "alone would leave 0.7284 possible, the height does not: no angle that rounds to it.",
        marks=("ours", "calibrated"),
    ),
    Claim(
        "(1), exact derivative",
        r"\frac{dS}{dh}=2\,\mathrm{tg}\,\delta,\quad\delta=\alpha\text{ at the constant chord}",
        all_of(
            Equality(slope_of_thickness, 2 * tan(delta)),
            Equality(K_m, influence),
        ),
        note=(
            "On the involute itself; delta is the angle of the flank's tangent with the tooth's "
            "axis. On the rack the derivative is 2 tan(alpha) at every height."
        ),
        marks=("ours",),
    ),
    Claim(
        "(1), where the flank has the slope 0.7284",
        r"2\,\mathrm{tg}\,\delta=0.7284\text{ 5 to 6 }\mu\mathrm{m}\text{ nearer the tip}",
        all_of(
            less(
                Rational("0.005"),
                of_wheel(
                    chord_distance(atan(PRINTED_INFLUENCE / 2), half_tooth) - involute_distance
                ),
            ),
            less(
                of_wheel(
                    chord_distance(atan(PRINTED_INFLUENCE / 2), half_tooth) - involute_distance
                ),
                Rational("0.006"),
            ),
        ),
        note="The graphic construction was off by as little as that; a secant from the constant "
        "chord has the slope about twice as far from it, well inside IT6.",
        marks=("ours", "calibrated"),
    ),
    Claim(
        "(1), cost of 0.7284",
        r"2\,\mathrm{tg}\,20^\circ=0.7279,\ "
        r"|0.7284-2\,\mathrm{tg}\,20^\circ|\cdot 0.1~\mathrm{mm}<0.05~\mu\mathrm{m}",
        all_of(
            PrintedNumber("0.7279", of_wheel(K_m)),
            less((PRINTED_INFLUENCE - of_wheel(K_m)) * 100, Rational("0.05")),
        ),
        note="For heights that are off by up to 0.1 mm; the third digit does no harm.",
        marks=("ours", "calibrated"),
    ),
    PRINT.equation(
        "step 6, influence of the involute",
        says=all_of(
            not_above(excess_in_print, -of_wheel(height_change) / 100),
            not_above(
                *(
                    side.subs(tilt, -tilt)
                    for side in (excess_in_print, of_wheel(height_change) / 100)
                )
            ),
        ),
        on=HEIGHTS_TO_1_MM,
        holds_on=HEIGHTS_TO_0_1_MM,
        corrected=Correction(
            r"\Delta S_{ca}=K_m\,\Delta h-mz\left[t_c(1-\cos\varepsilon)+\sin\varepsilon"
            r"-\varepsilon\cos\varepsilon\right],\ t_c=\mathrm{tg}\,\alpha+\frac\pi{2z}",
            all_of(
                Equality(K_m * height_change - m * z * across, thickness_change),
                Equality(of_wheel(m * z * across), excess_in_print),
            ),
        ),
        note=(
            "An approximation by its own words: judged to a hundredth of Delta h, for this wheel. "
            "At 0.1 mm that is 1 um, the last place of T_c; the product is never too small (see "
            "'excess of the linear model'). Epsilon is the angle between the tangents of the flank "
            "at the chord measured and at the constant chord."
        ),
        marks=("rebuilt", "calibrated"),
    ),
    Claim(
        "step 6, tilt as parameter",
        r"\Delta h(\varepsilon)=y(\alpha)-y(\alpha+\varepsilon),\ "
        r"\Delta S(\varepsilon)=S(\alpha+\varepsilon)-S(\alpha)",
        all_of(
            Equality(
                height_change,
                involute_distance - chord_distance(alpha + tilt, half_tooth),
            ),
            Equality(
                thickness_change,
                2 * chord_half(alpha + tilt, half_tooth) - involute_chord,
            ),
        ),
        note="The closed forms of the kernels against the involute.",
        marks=("ours",),
    ),
    Claim(
        "step 6, curvature",
        r"\frac{d^2S}{dh^2}=-\frac{2}{r_b t\cos^3\delta}",
        Equality(curvature_of_thickness, -2 / (r_b * roll * cos(delta) ** 3)),
        note="r_b t is the radius of curvature of the flank; the linear model is never too small.",
        marks=("ours",),
    ),
    Claim(
        "step 6, distance of the tangent",
        r"y\cos\delta-\tfrac S2\sin\delta=r_b",
        Equality(distance * cos(delta) - thickness / 2 * sin(delta), r_b),
        note="Hence cos(delta) >= r_b/y wherever S >= 0 and 0 <= delta < pi/2.",
        marks=("ours",),
    ),
    Claim(
        "step 6, radius of curvature",
        r"(r_bt)^2=y^2+\tfrac{S^2}4-r_b^2",
        Equality((r_b * roll) ** 2, distance**2 + thickness**2 / 4 - r_b**2),
        note="Deeper chords are thicker, so it falls by no more than y^2 does.",
        marks=("ours",),
    ),
    Claim(
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
        note=(
            "N is the bracket of step 6. With 'curvature', 'distance of the tangent' and 'radius "
            "of curvature', Taylor's remainder gives the bound of the kernel: dh^2 (y_c + |dh|)^3/"
            "(r_b^3 R), R^2 the last part with |dh| for dh, for |dh| <= y_c - r_b, up to the tip."
        ),
        marks=("ours",),
    ),
    Claim(
        "step 6, excess of the linear model, this wheel",
        r"|\varepsilon|\le\tfrac1{20}\text{ (over 1 mm either way): }"
        r"0\le K_m\Delta h-\Delta S\le\frac{\Delta h^2}{20~\mathrm{mm}}",
        all_of(
            not_above(S.Zero, excess_of_wheel),
            not_above(excess_of_wheel, of_wheel(height_change) ** 2 / 20),
            *reaches(WIDE, S.One),
            *reaches(NARROW, Rational(1, 10)),
        ),
        on=Part("over 1 mm of height either way", {tilt: Interval(-WIDE, WIDE)}),
        note="The other parts: 1/20 of a radian is over 1 mm, 1/260 over 0.1 mm, either way.",
        marks=("ours", "calibrated"),
    ),
    Claim(
        "step 6, excess of the linear model, IT8",
        r"|\Delta h|\le0.063~\mathrm{mm}:\ \text{bound}<0.2~\mu\mathrm{m}",
        less(
            of_wheel(linearisation_bound.subs(dh, Rational(GRADES[8][1], 1000))),
            Rational("0.0002"),
        ),
        note="For tip diameters of IT8 the linear model is good to a two-hundredth of T_c.",
        marks=("ours", "calibrated"),
    ),
)
