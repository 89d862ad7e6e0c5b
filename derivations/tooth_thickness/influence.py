"""Rows of paper 3 on the influence of the height on the thickness: (1) and step 6."""

from sympy import Expr, Rational, S, cos, diff, sin, tan

from mechproof.record import Conjunction, Equality, PrintedNumber, all_of, less, not_above, ours

from .mechanics import (
    HEIGHTS_TO_0_1_MM,
    LAST_SHARE,
    PRINTED_INFLUENCE,
    across,
    chord_distance,
    chord_half,
    curvature_of_thickness,
    distance,
    half_tooth,
    height_change,
    influence,
    involute_chord,
    involute_distance,
    linearisation_root,
    of_wheel,
    read,
    roll,
    slope_of_thickness,
    thickness,
    thickness_change,
)
from .symbols import PRINT, K_m, alpha, delta, dh, m, r_b, s_c, t_c, tilt, y_c, z

in_print = read("step 6, influence of the involute")[1].subs(dh, height_change)
excess_in_print = of_wheel(in_print - thickness_change)
excess_of_0_7284 = of_wheel(PRINTED_INFLUENCE * height_change - thickness_change)
# The tilt of a chord nearer the tip, in 1e-6, between which the secant has the printed slope.
SECANT = (Rational(405, 10**6), Rational(406, 10**6))


def good_to_the_last_place(excess: Expr) -> Conjunction:
    """State that an excess (mm) is below one of the paper's last place, its share of the height.

    For tilts of both signs; deeper chords have negative ones.
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
        note="In its own words an approximation, for this wheel: judged to one micrometre, the "
        "last place to which the paper gives deviations, for a height that is off by 0.1 mm, and "
        "in proportion for less. See '(1), where 0.7284 is the slope'.",
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
        note="In its own words an approximation, judged as (1) was; the product is never too "
        "small: see 'step 6, excess of the linear model', on the page of the linearisation "
        "bound.",
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
