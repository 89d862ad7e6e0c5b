"""What paper 3 prints and what is rebuilt: symbols, geometry, rows.

Order of the file: symbols; the geometry (basic rack, involute, gauge); the shares of parts; what
the paper prints, row by row.

Conventions: lengths in mm, angles in rad. The tooth's axis points from the wheel's centre to the
tip. Heights grow from the tip towards the centre, deviations of thickness are positive for a
thicker tooth. Letters that the paper uses twice are kept apart: `Delta h_c` and `Delta S_c` are the
gauge's errors of the flow chart; `K` is T/sigma and `K_m` the influence of the height.
"""

from __future__ import annotations

from sympy import (
    Abs,
    Eq,
    Expr,
    Heaviside,
    Integral,
    Interval,
    Matrix,
    Ne,
    Rational,
    S,
    Symbol,
    acos,
    atan,
    cos,
    diff,
    exp,
    oo,
    pi,
    sin,
    solve,
    sqrt,
    symbols,
    tan,
)

from mechproof.record import (
    LENGTH,
    Claim,
    Completion,
    Completions,
    Conjunction,
    Correction,
    Definition,
    Distinct,
    Equality,
    Equation,
    Holds,
    Part,
    PrintedNumber,
    Reading,
    Variable,
)

from .._metrology import normal_between, normal_outside
from .._relations import less, not_above

# Symbols --------------------------------------------------------------------------------------

m = Symbol("m", positive=True)
z = Symbol("z", integer=True, positive=True)
alpha = Symbol("alpha", positive=True)
incline = Symbol("tan_alpha", positive=True)
delta, tilt, start = symbols("delta tilt delta_0", real=True)
r_b, t_c, y_c, s_c, K_m = symbols("r_b t_c y_c s_c K_m", real=True)
psi = Symbol("psi", positive=True)
thinning = Symbol("Delta_s", real=True)

dh, dh_gauge, ds_gauge = symbols("Delta_h Delta_hc Delta_Sc", real=True)
e_tip, E_true, E_measured, ds_height = symbols("e_dau E_csu E_cs0 Delta_Sca", real=True)
E_cs, T_c, sigma, millimetre = symbols("E_cs T_c sigma mm", positive=True)
K = symbols("K", positive=True)
f_true, f_measured = symbols("f_u f_0", real=True)
place = Symbol("p", positive=True)
sigma_tip, sigma_height, sigma_thickness = symbols("sigma_d sigma_h sigma_S", positive=True)
above, below, width = symbols("q_1 q_2 w", positive=True)
degree = Symbol("degree", positive=True)

POSITIVE = Interval.open(0, oo)

# The design: the constant chord and its height below the tip, addendum of one module.
chord = pi * m * cos(alpha) ** 2 / 2
chord_height = m * (1 - pi * sin(2 * alpha) / 8)

VARIABLES = (
    Variable(m, "module", LENGTH, POSITIVE),
    Variable(z, "number of teeth", within=S.Naturals),
    Variable(alpha, "profile angle of the basic rack", within=Interval.open(0, pi / 4)),
    Variable(incline, "tangent of the profile angle", within=Interval.open(0, 1)),
    Variable(delta, "angle of the flank's tangent with the tooth's axis"),
    Variable(tilt, "angle between the tangents at a chord's end and at the constant chord's"),
    Variable(start, "angle of the flank's tangent with the tooth's axis at a first chord"),
    Variable(r_b, "base radius", LENGTH, POSITIVE, given=m * z * cos(alpha) / 2),
    Variable(t_c, "roll angle at the constant chord", given=tan(alpha) + pi / (2 * z)),
    Variable(
        y_c,
        "from the wheel's centre to the constant chord",
        LENGTH,
        given=m * (z / 2 + pi * sin(2 * alpha) / 8),
    ),
    Variable(s_c, "constant chord", LENGTH, given=chord),
    Variable(psi, "half the tooth's angle at the base circle", within=POSITIVE),
    Variable(thinning, "change of thickness on the pitch circle", LENGTH),
    Variable(dh, "deviation of the measured height: how much deeper the chord lies", LENGTH),
    Variable(dh_gauge, "error of the gauge's height", LENGTH, sign="positive: set too deep"),
    Variable(ds_gauge, "indication error of the gauge in thickness", LENGTH),
    Variable(e_tip, "deviation of the tip diameter", LENGTH),
    Variable(E_true, "true deviation of the tooth thickness", LENGTH),
    Variable(E_measured, "measured deviation of the tooth thickness", LENGTH),
    Variable(ds_height, "change of the measured thickness with the height", LENGTH),
    Variable(E_cs, "smallest deviation of the tooth thickness", LENGTH, POSITIVE),
    Variable(T_c, "tolerance of the tooth thickness", LENGTH, POSITIVE),
    Variable(sigma, "standard deviation of the true thickness", LENGTH, POSITIVE),
    Variable(millimetre, "the unit of length", LENGTH, POSITIVE),
    Variable(K, "tolerance over standard deviation", within=POSITIVE),
    Variable(K_m, "influence of the height on the thickness", given=2 * tan(alpha)),
    Variable(f_true, "1 for a good tooth, else 0", within=Interval(0, 1)),
    Variable(f_measured, "1 for an accepted tooth, else 0", within=Interval(0, 1)),
    Variable(place, "place in the tolerance field, from its upper end", within=Interval.open(0, 1)),
    Variable(sigma_tip, "standard deviation of the tip diameter", LENGTH, POSITIVE),
    Variable(sigma_height, "standard deviation of the gauge in height", LENGTH, POSITIVE),
    Variable(sigma_thickness, "standard deviation of the gauge in thickness", LENGTH, POSITIVE),
    Variable(above, "from a true deviation to the upper limit", LENGTH, POSITIVE),
    Variable(below, "from the lower limit to a true deviation", LENGTH, POSITIVE),
    Variable(width, "standard deviation of the measurement error times sqrt(2)", LENGTH, POSITIVE),
    Variable(degree, "accuracy degree", within=POSITIVE),
)

# The geometry ---------------------------------------------------------------------------------

# Basic rack, symmetric about its tooth space's axis; the pitch point is the origin, y points to
# the tip of the wheel's tooth. The rack's flank cuts the pitch line half a tooth from the axis;
# the common normal goes through the pitch point, so contact is at the foot of the perpendicular.
flank_point = Matrix([pi * m / 4, 0])
flank_normal = Matrix([cos(alpha), sin(alpha)])
contact = flank_normal * flank_point.dot(flank_normal)
rack_chord = 2 * contact[0]
rack_height = m - contact[1]

# Involute of the base circle: in the frame of the tangent the chord's end has the coordinates
# r_b (radius to the tangency point) and r_b t (along the generating line, t the roll angle).
# The tangent of the flank is parallel to that radius, at the angle delta to the tooth's axis.


def chord_half(slope: Expr, half_angle: Expr, radius: Expr = r_b) -> Expr:
    """Half the chord's length where the flank's tangent has the angle `slope` to the axis."""
    return radius * ((slope + half_angle) * cos(slope) - sin(slope))


def chord_distance(slope: Expr, half_angle: Expr, radius: Expr = r_b) -> Expr:
    """Distance of that chord from the wheel's centre."""
    return radius * (cos(slope) + (slope + half_angle) * sin(slope))


roll = delta + psi
thickness, distance = 2 * chord_half(delta, psi), chord_distance(delta, psi)
slope_of_thickness = diff(thickness, delta) / diff(-distance, delta)
curvature_of_thickness = diff(slope_of_thickness, delta) / diff(-distance, delta)

# Half the angle of the tooth at the base circle: half of pi/z at the pitch circle, plus inv(alpha).
half_tooth = pi / (2 * z) + tan(alpha) - alpha
involute_chord = 2 * chord_half(alpha, half_tooth)
involute_distance = chord_distance(alpha, half_tooth)
tip_radius = m * z / 2 + m
nominal_height = tip_radius - involute_distance

# From the constant chord to a chord where the tangent has turned by `tilt`: the integrals of
# r_b t along and across the first tangent.
along = (t_c + tilt) * sin(tilt) - (1 - cos(tilt))
across = t_c * (1 - cos(tilt)) + sin(tilt) - tilt * cos(tilt)
height_change = r_b * (across * sin(alpha) - along * cos(alpha))
thickness_change = -2 * r_b * (along * sin(alpha) + across * cos(alpha))
linear_change = K_m * dh
linearisation_root = (r_b * t_c) ** 2 - dh * (2 * y_c - dh)
linearisation_bound = (
    dh**2 * (y_c + Abs(dh)) ** 3 / (r_b**3 * sqrt(linearisation_root.subs(dh, Abs(dh))))
)

# The gauge stands on the actual tip circle, its line h_c + Delta h_c below.
line_nominal = tip_radius - nominal_height
line_actual = tip_radius + e_tip / 2 - (nominal_height + dh_gauge)
height_deviation = line_nominal - line_actual
influence = slope_of_thickness.subs(delta, alpha)
measured_change = influence * height_deviation
reading = (involute_chord + E_true + influence * dh + ds_gauge) - involute_chord

# A flank turned about the wheel's centre by -turn: the change of its half chord at fixed height.
turn = Symbol("turn", real=True)
half_moved = (
    chord_half(alpha, half_tooth)
    - turn * chord_distance(alpha, half_tooth)
    + tan(alpha) * turn * chord_half(alpha, half_tooth)
)
turn_by_thinning = solve(Eq(2 * turn * m * z / 2, thinning), turn)[0]
chord_by_thinning = 2 * (chord_half(alpha, half_tooth) - half_moved).subs(turn, turn_by_thinning)

# What is printed, with its numbers (mm, unless said otherwise) ----------------------------------

PROFILE_ANGLE = pi / 9
MODULE, TEETH = 3, 50
WHEEL = {m: S(MODULE), z: S(TEETH), alpha: PROFILE_ANGLE}
PRINTED_INFLUENCE = Rational("0.7284")
DECREASE_UM, TOLERANCE_UM, GAUGE_UM, K_PRINTED = 12, 45, 50, 6
RECOMMENDED_UM = 2

# ISO 286-1: i = 0.45 D^(1/3) + 0.001 D (um; D in mm, the geometric mean of the range 120 to 180).
RANGE = (120, 180)
TIP_DIAMETER = MODULE * (TEETH + 2)
RANGE_MEAN = sqrt(RANGE[0] * RANGE[1])
TOLERANCE_UNIT = Rational("0.45") * RANGE_MEAN ** Rational(1, 3) + Rational("0.001") * RANGE_MEAN
GRADES = {6: (10, 25), 7: (16, 40), 8: (25, 63)}


def of_wheel(expression: Expr) -> Expr:
    """Put the printed wheel into an expression."""
    given = {v.symbol: v.given for v in VARIABLES if v.given is not None}
    return expression.subs(given).subs(WHEEL)


def at_angle(expression: Expr, degrees: int | str) -> Expr:
    """Put the printed module and a profile angle in degrees into an expression."""
    return expression.subs({m: MODULE, alpha: Rational(degrees) * pi / 180})


excess_of_wheel = of_wheel(m * z * across)

# The shares -----------------------------------------------------------------------------------

GEOMETRIES = {
    "printed": (PRINTED_INFLUENCE, PRINTED_INFLUENCE),
    "involute": (tan(PROFILE_ANGLE), 2 * tan(PROFILE_ANGLE)),
}


# Share of good teeth, normal law centred on its field of K = 6 standard deviations.
THREE_SIGMA = Rational(K_PRINTED, 2)
NORMAL_SHARE = normal_between(S.Zero, S.One, -THREE_SIGMA, THREE_SIGMA)


def measurement_spread(
    grade: int, limit_error: int | Rational, multiple: int, geometry: str
) -> Expr:
    """Give the standard deviation (um) of the whole error: tip with IT/sigma = K, and gauge."""
    tip, height = GEOMETRIES[geometry]
    gauge = Rational(limit_error) / multiple
    return sqrt((tip * Rational(GRADES[grade][1], K_PRINTED)) ** 2 + (1 + height**2) * gauge**2)


def wrongly_rejected(spread: Expr, ratio: int = K_PRINTED) -> Expr:
    """Share of good teeth rejected; normal laws, centred, T/sigma = ratio."""
    y = Symbol("y", real=True)
    half, spread_true = Rational(TOLERANCE_UM, 2), Rational(TOLERANCE_UM, ratio)
    density = exp(-(y**2) / (2 * spread_true**2)) / (spread_true * sqrt(2 * pi))
    return Integral(density * normal_outside(y, spread**2, -half, half), (y, -half, half))


def rejected_by(
    grade: int, limit_error: int | Rational, multiple: int = 3, geometry: str = "printed"
) -> Expr:
    """Share of good teeth rejected with a tip of a grade and a gauge."""
    return wrongly_rejected(measurement_spread(grade, limit_error, multiple, geometry))


def error_variance(tip: Expr, height: Expr) -> Expr:
    """Variance of the measured thickness about the true one."""
    return (tip * sigma_tip) ** 2 + (height * sigma_height) ** 2 + sigma_thickness**2


VARIANCE_BY_SLOPE = error_variance(2 * incline, 2 * incline)
chance_to_accept = normal_between(S.Zero, width**2 / 2, -below, above)
UPWARD = Part("the tip diameter is too large", {e_tip: POSITIVE})

# Rows -----------------------------------------------------------------------------------------

GEOMETRY_ROWS = (
    Claim(
        "data, pitch diameter",
        r"d=150~\mathrm{mm}\quad(m=3~\mathrm{mm},\ z=50)",
        PrintedNumber("150", MODULE * S(TEETH)),
    ),
    Claim(
        "data, constant chord",
        r"\bar S_c=4.161~\mathrm{mm}",
        PrintedNumber("4.161", at_angle(rack_chord, 20)),
        note="With the profile angle 20 deg, which is not printed; it is fitted to this number.",
        marks=("fitted",),
    ),
    Claim(
        "data, height to the constant chord",
        r"\bar h_c=2.243~\mathrm{mm}",
        PrintedNumber("2.243", at_angle(rack_height, 20)),
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
        Conjunction(
            (
                Equality(rack_chord.subs(alpha, atan(incline)), pi * m / 2 / (1 + incline**2)),
                less(diff(pi * m / 2 / (1 + incline**2), incline), S.Zero),
                Equality(
                    rack_height.subs(alpha, atan(incline)),
                    m * (1 - pi / 4 * incline / (1 + incline**2)),
                ),
                less(diff(m * (1 - pi / 4 * incline / (1 + incline**2)), incline), S.Zero),
                less(Rational("4.1615"), at_angle(rack_chord, "19.99")),
                less(at_angle(rack_height, "20.01"), Rational("2.2425")),
            )
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
        Conjunction(
            (
                Equality(chord_height, rack_height),
                Equality(rack_height, nominal_height),
            )
        ),
        note="From the rack and from the involute, addendum of one module.",
        marks=("ours",),
    ),
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
        note=(
            "E_csu = E_cs - T_c p, 0 < p < 1, is any good tooth of step 2; its decrease is -E_csu. "
            "With E_cs = 12 um as printed, good teeth may be thicker than nominal."
        ),
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
        r"E_{csu}=0\text{ is good by step 2 with }E_{cs}=12,\ T_c=45~\mu\mathrm m",
        Conjunction((less(S.Zero, S(DECREASE_UM)), less(S(DECREASE_UM - TOLERANCE_UM), S.Zero))),
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
        Completions(
            "how much thinner the teeth of the mate are",
            Completion(
                "the mate is thinned by 12 um, too: the clearance along the normal is over 15 um",
                less(S(15), 2 * DECREASE_UM * cos(PROFILE_ANGLE)),
            ),
            Completion(
                "the mate is not thinned: the same",
                less(S(15), DECREASE_UM * cos(PROFILE_ANGLE)),
            ),
        ),
        note="The mate and the centre distance have their share, and neither is printed.",
    ),
    Claim(
        "measuring base",
        r"\text{if the tip diameter differs from nominal, the height gets an error}",
        Holds(Ne(height_deviation.subs(dh_gauge, 0), 0, evaluate=False)),
        on=UPWARD,
        note="Half the deviation, and negative: the gauge stands higher, its line nearer the tip.",
    ),
    Claim(
        "measuring base, thickness",
        r"\text{the error of the height leads to an error of the thickness}",
        Conjunction(
            (
                Equality(2 * incline, influence.subs(alpha, atan(incline))),
                less(S.Zero, 2 * incline),
            )
        ),
        note="The derivative is positive: deeper is thicker, so a larger tip diameter makes the "
        "measured tooth thinner.",
    ),
)

LINEAR_ROWS = (
    Equation(
        "(1), influence 0.7284",
        r"\Delta S_c=0.7284\,\Delta h",
        PrintedNumber("0.7284", of_wheel(K_m)),
        corrected=Correction(
            r"\Delta S_c=2\,\mathrm{tg}\,20^\circ\,\Delta h=0.7279\,\Delta h",
            PrintedNumber("0.7279", of_wheel(K_m)),
        ),
        note="At the constant chord the flank's tangent has exactly the rack's angle.",
        marks=("calibrated", "inferred"),
    ),
    Claim(
        "(1), exact derivative",
        r"\frac{dS}{dh}=2\,\mathrm{tg}\,\delta,\quad\delta=\alpha\text{ at the constant chord}",
        Conjunction(
            (
                Equality(slope_of_thickness, 2 * tan(delta)),
                Equality(K_m, influence),
            )
        ),
        note=(
            "On the involute itself; delta is the angle of the flank's tangent with the tooth's "
            "axis. On the rack the derivative is 2 tan(alpha) at every height."
        ),
        marks=("ours",),
    ),
    Claim(
        "(1), where the flank has the slope 0.7284",
        r"2\,\mathrm{tg}\,\delta=0.7284\text{ 5 to 6 }\mu\mathrm m\text{ nearer the tip}",
        Conjunction(
            (
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
            )
        ),
        note="The graphic construction was off by as little as that.",
        marks=("ours", "calibrated"),
    ),
    Claim(
        "(1), cost of 0.7284",
        r"|0.7284-2\,\mathrm{tg}\,20^\circ|\cdot 0.1~\mathrm{mm}<0.05~\mu\mathrm m",
        less((PRINTED_INFLUENCE - of_wheel(K_m)) * 100, Rational("0.05")),
        note="For heights that are off by up to 0.1 mm; the third digit does no harm.",
        marks=("ours", "calibrated"),
    ),
    Equation(
        "step 6, influence of the involute",
        r"\Delta S_{ca}=K_m\cdot\Delta h",
        Equality(K_m * height_change, thickness_change),
        on=Part("up to an eighth of a turn about the constant chord", {tilt: Interval(0, pi / 4)}),
        corrected=Correction(
            r"\Delta S_{ca}=K_m\,\Delta h-mz\left[t_c(1-\cos\varepsilon)+\sin\varepsilon"
            r"-\varepsilon\cos\varepsilon\right],\ t_c=\mathrm{tg}\,\alpha+\frac\pi{2z}",
            Equality(K_m * height_change - m * z * across, thickness_change),
        ),
        note=(
            "Right to first order only; epsilon is the angle between the tangents of the flank at "
            "the chord measured and at the constant chord."
        ),
    ),
    Claim(
        "step 6, tilt as parameter",
        r"\Delta h(\varepsilon)=y(\alpha)-y(\alpha+\varepsilon),\ "
        r"\Delta S(\varepsilon)=S(\alpha+\varepsilon)-S(\alpha)",
        Conjunction(
            (
                Equality(
                    height_change,
                    involute_distance - chord_distance(alpha + tilt, half_tooth),
                ),
                Equality(
                    thickness_change,
                    2 * chord_half(alpha + tilt, half_tooth) - involute_chord,
                ),
            )
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
        Conjunction(
            (
                Equality(m * z * across, K_m * height_change - thickness_change),
                Equality(across.subs(tilt, 0), S.Zero),
                Equality(diff(across, tilt), (t_c + tilt) * sin(tilt)),
                Equality(s_c, involute_chord),
                Equality(y_c, involute_distance),
                Equality(linearisation_root, (y_c - dh) ** 2 + s_c**2 / 4 - r_b**2),
            )
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
        Conjunction(
            (
                not_above(S.Zero, excess_of_wheel),
                not_above(excess_of_wheel, of_wheel(height_change) ** 2 / 20),
                less(of_wheel(height_change).subs(tilt, Rational(1, 20)), S.NegativeOne),
                less(S.One, of_wheel(height_change).subs(tilt, Rational(-1, 20))),
            )
        ),
        on=Part(
            "a twentieth of a radian either way",
            {tilt: Interval(-Rational(1, 20), Rational(1, 20))},
        ),
        marks=("ours", "calibrated"),
    ),
    Claim(
        "step 6, excess of the linear model, IT8",
        r"|\Delta h|\le0.063~\mathrm{mm}:\ \text{bound}<0.2~\mu\mathrm m",
        less(
            of_wheel(linearisation_bound.subs(dh, Rational(GRADES[8][1], 1000))),
            Rational("0.0002"),
        ),
        note="For tip diameters of IT8 the linear model is good to a two-hundredth of T_c.",
        marks=("ours", "calibrated"),
    ),
)

ALGORITHM_ROWS = (
    Equation(
        "step 1",
        r"K=T_c/\sigma",
        Definition(K, T_c / sigma),
        note="The tolerance field over the standard deviation.",
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
        note="Neither is printed.",
    ),
    Equation(
        "step 2",
        r"f_u=1\text{ if }E_{cs}-T_c<E_{csu}<E_{cs},\text{ else }0",
        Definition(
            f_true,
            Heaviside((E_cs - E_true) / T_c, 0) * Heaviside((E_true - E_cs + T_c) / T_c, 0),
        ),
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
        "step 3, range of ISO 286-1",
        r"120<d_a=m(z+2)=156\le180~\mathrm{mm}",
        Conjunction(
            (
                less(S(RANGE[0]), S(TIP_DIAMETER)),
                not_above(S(TIP_DIAMETER), S(RANGE[1])),
            )
        ),
        note="Addendum of one module, as the height to the constant chord shows.",
        marks=("ours", "calibrated"),
    ),
    *(
        Claim(
            f"step 3, IT{grade}",
            rf"\mathrm{{IT}}{grade}={value}~\mu\mathrm m",
            PrintedNumber(str(value), factor * TOLERANCE_UNIT),
            note=f"{factor} i, i = 0.45 D^(1/3) + 0.001 D, D = sqrt(120*180) mm.",
            marks=("ours",),
        )
        for grade, (factor, value) in GRADES.items()
    ),
    Claim(
        "steps 4 and 7, spread of the gauge",
        r"\text{interval measure of the uncertainty }50~\mu\mathrm m",
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
    Equation(
        "step 5",
        r"\Delta h=e_{dau}+\Delta h_c",
        Equality(e_tip + dh_gauge, height_deviation),
        corrected=Correction(
            r"\Delta h=\Delta h_c-\tfrac12e_{dau}",
            Equality(dh_gauge - e_tip / 2, height_deviation),
        ),
        note=(
            "The gauge stands on the tip circle, so half the deviation of the diameter "
            "counts, whichever way heights are counted. The sign of Delta h is not printed: "
            "counted towards the centre the tip's half enters with a minus, towards the tip "
            "with a plus. The charge rests on the words 'tip diameter' of step 3, not on a "
            "subscript."
        ),
        marks=("rebuilt",),
    ),
    Equation(
        "steps 5 and 6, tip diameter alone",
        r"\Delta S_{ca}=K_m\,e_{dau}",
        Equality(K_m * e_tip, measured_change.subs(dh_gauge, 0)),
        corrected=Correction(
            r"\Delta S_{ca}=-e_{dau}\,\mathrm{tg}\,\alpha",
            Equality(-e_tip * tan(alpha), measured_change.subs(dh_gauge, 0)),
        ),
        note=(
            "Twice too much; the sign is wrong as well if deviations are positive for a "
            "thicker tooth (see the next row)."
        ),
        marks=("rebuilt",),
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
        "letter Delta h_c",
        r"\Delta h_c\text{ (from the tip circle, text)}\ne\Delta h_c\text{ (gauge, chart)}",
        Distinct((e_tip + dh_gauge).subs(dh_gauge, height_deviation), height_deviation),
        note="With the text's meaning in step 5 the tip diameter would be counted again.",
        marks=("rebuilt",),
    ),
    Claim(
        "letter Delta S_c",
        r"\Delta S_c\text{ (from the height, text)}\ne\Delta S_c\text{ (gauge, chart)}",
        Distinct((E_true + K_m * dh + ds_gauge).subs(ds_gauge, K_m * dh), reading),
        note="With the text's meaning in step 8 the height would be counted twice.",
        marks=("rebuilt",),
    ),
    Equation(
        "step 8",
        r"E_{cs0}=E_{csu}+\Delta S_{ca}+\Delta S_c",
        Equality(E_true + K_m * dh + ds_gauge, reading),
        note="The indication less the nominal chord, to first order in the height.",
        marks=("rebuilt",),
    ),
    Equation(
        "step 9",
        r"f_0=1\text{ if }E_{cs}-T_c<E_{cs0}<E_{cs},\text{ else }0",
        Definition(
            f_measured,
            Heaviside((E_cs - E_measured) / T_c, 0) * Heaviside((E_measured - E_cs + T_c) / T_c, 0),
        ),
        note="Acceptance limits equal to the tolerance limits: no guard band.",
    ),
    Claim(
        "step 10",
        r"f_uf_0+(1-f_u)f_0+(1-f_u)(1-f_0)+f_u(1-f_0)=1",
        Equality(
            f_true * f_measured
            + (1 - f_true) * f_measured
            + (1 - f_true) * (1 - f_measured)
            + f_true * (1 - f_measured),
            S.One,
        ),
        note="The four shares add up to all parts; (1-f_u) f_0 is the consumer's risk of JCGM 106, "
        "f_u (1-f_0) the producer's.",
    ),
)

EXAMPLE_ROWS = (
    Claim(
        "Table 1, smallest deviation",
        r"E_{cs}=12~\mu\mathrm m",
        Definition(E_cs, Rational(DECREASE_UM, 1000) * millimetre),
        note="A datum; its sign is a matter of 'smallest deviation'.",
    ),
    Claim(
        "Table 1, tolerance",
        r"T_c=45~\mu\mathrm m",
        Definition(T_c, Rational(TOLERANCE_UM, 1000) * millimetre),
        note="A datum.",
    ),
    Claim(
        "Table 1, accuracy degree",
        r"6\mathrm H",
        Definition(degree, S(6)),
        note="A datum; no formula of the paper uses it.",
    ),
    Claim(
        "Table 1, uncertainty of the gauge",
        r"50~\mu\mathrm m\text{ against the tolerance of }45~\mu\mathrm m",
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
        note="Right as the share in the sample.",
    ),
    Claim(
        "Table 1, 50 of 50, share of all teeth",
        r"100~\%\text{ good at }K=6",
        Equality(S.One, NORMAL_SHARE),
        corrected=Correction(r"99.73~\%", PrintedNumber("99.73", 100 * NORMAL_SHARE)),
        note="Of the process, if the sample's share is taken for it; normal law, centred.",
        marks=("ours",),
    ),
    Claim(
        "Table 1, 50 of 50, what it is compatible with",
        r"p^{50}\ge0.05\text{ down to }p=94.2~\%",
        Conjunction(
            (
                less(Rational(1, 20), Rational("0.942") ** 50),
                less(Rational("0.941") ** 50, Rational(1, 20)),
            )
        ),
        note="Clopper and Pearson: the one-sided 95 % bound lies between 94.1 and 94.2 % good.",
        marks=("ours",),
    ),
    Claim(
        "Table 1, 50 of 50, how often",
        r"0.87<\mathrm{erf}(3/\sqrt2)^{50}<0.88",
        Conjunction(
            (
                less(Rational("0.87"), NORMAL_SHARE**50),
                less(NORMAL_SHARE**50, Rational("0.88")),
            )
        ),
        note="The chance of 50 good teeth in 50 at K = 6, centred.",
        marks=("ours",),
    ),
)

CLAIM_ROWS = (
    Claim(
        "(a), curves of Figs. 4 and 5",
        r"\text{percentage of wrongly rejected at a limit error of }10~\mu\mathrm m",
        Completions(
            "grade of the tip diameter and law of the gauge",
            Completion(
                "IT6, normal laws, limit error 3 sigma: below 2 %",
                less(rejected_by(6, 10), Rational("0.02")),
            ),
            Completion(
                "IT6, normal laws, limit error 2 sigma: below 2 %",
                less(rejected_by(6, 10, 2), Rational("0.02")),
            ),
        ),
        note="The curves are lost, and the multiple of the limit error is not printed.",
    ),
    Claim(
        "(a), rise with the limit error",
        r"\frac{\partial}{\partial w}\tfrac12\left[\mathrm{erf}\frac{q_1}w"
        r"+\mathrm{erf}\frac{q_2}w\right]<0",
        less((sqrt(pi) * diff(chance_to_accept, width)).expand(), S.Zero),
        note=(
            "The chance that a good tooth, q_1 and q_2 inside its limits, is accepted falls as the "
            "normal error grows: for every law of the true deviation Fig. 4 rises and Fig. 5 falls."
        ),
        marks=("ours",),
    ),
    Claim(
        "(a), order of the curves",
        r"\text{curve 2 (IT7) lies above curve 1 (IT6) in Fig. 4, below it in Fig. 5}",
        less(
            VARIANCE_BY_SLOPE.subs(sigma_tip, sigma),
            VARIANCE_BY_SLOPE.subs(sigma_tip, GRADES[7][1] * sigma / GRADES[6][1]),
        ),
        note="The total error of IT7 has the larger variance at every limit error of the gauge.",
        marks=("ours",),
    ),
    Claim(
        "(b)",
        r"\text{the gauge influences the shares more strongly than the tip diameter}",
        Completions(
            "the gauge, its law and the grade of the tip diameter",
            Completion(
                "the gauge of Table 1 (50 um in all, 3 sigma), IT6: its variance is the larger",
                less(
                    measurement_spread(6, 0, 3, "printed") ** 2,
                    measurement_spread(6, 25, 3, "printed") ** 2
                    - measurement_spread(6, 0, 3, "printed") ** 2,
                ),
            ),
            Completion(
                "the gauge recommended in (c) (2 um, 3 sigma), IT6: the same",
                less(
                    measurement_spread(6, 0, 3, "printed") ** 2,
                    measurement_spread(6, RECOMMENDED_UM, 3, "printed") ** 2
                    - measurement_spread(6, 0, 3, "printed") ** 2,
                ),
            ),
        ),
        note="Steps 5 and 6 as printed. Over which range the two are compared is not said.",
    ),
    Claim(
        "(b), at equal standard deviations",
        r"1+K_m^2>K_m^2",
        less(
            VARIANCE_BY_SLOPE.subs({sigma_height: 0, sigma_thickness: 0, sigma_tip: sigma}),
            VARIANCE_BY_SLOPE.subs({sigma_tip: 0, sigma_height: sigma, sigma_thickness: sigma}),
        ),
        note="The gauge enters twice, in height and in thickness; by the geometry K_m/2 for the "
        "tip makes the difference larger still.",
        marks=("ours",),
    ),
    Claim(
        "(c)",
        r"\text{for degrees 6, 7, 8 gauges with }U\le\pm2~\mu\mathrm m\text{ can be recommended}",
        Completions(
            "the criterion of the recommendation",
            Completion(
                "degree 6, IT6, U = 2 sigma, criterion: at most 1 % wrongly rejected",
                less(rejected_by(6, RECOMMENDED_UM, 2), Rational("0.01")),
            ),
            Completion(
                "the same, criterion: at most 0.1 % wrongly rejected",
                less(rejected_by(6, RECOMMENDED_UM, 2), Rational("0.001")),
            ),
        ),
        note="No criterion is printed, nor the tolerances of degrees 7 and 8.",
    ),
    Claim(
        "(c), part of the tolerance",
        r"2U/T_c=4/45<\tfrac1{10}",
        less(Rational(2 * RECOMMENDED_UM, TOLERANCE_UM), Rational(1, 10)),
        note="The interval of the recommended gauge is below a tenth of the tolerance of degree 6.",
        marks=("ours",),
    ),
    Claim(
        "(c), what 2 um buy",
        r"\text{from }\pm25\text{ to }\pm2~\mu\mathrm m\text{: wrongly rejected more than 20 times "
        r"rarer}",
        less(20 * rejected_by(6, RECOMMENDED_UM), rejected_by(6, Rational(GAUGE_UM, 2))),
        note="IT6, normal laws, centred, limit errors of 3 sigma, steps 5 and 6 as printed.",
        marks=("ours",),
    ),
    Claim(
        "(d)",
        r"\text{the grade of the tip diameter should be 6 and 7, not 8}",
        Completions(
            "which formulas the figures were computed by",
            Completion(
                "steps 5 and 6 as printed: a perfect gauge wrongly rejects over 2 % with IT8, "
                "less with IT7",
                Conjunction(
                    (
                        less(Rational("0.02"), rejected_by(8, 0)),
                        less(rejected_by(7, 0), Rational("0.02")),
                    )
                ),
            ),
            Completion(
                "steps 5 and 6 by the geometry: the same",
                Conjunction(
                    (
                        less(Rational("0.02"), rejected_by(8, 0, geometry="involute")),
                        less(rejected_by(7, 0, geometry="involute"), Rational("0.02")),
                    )
                ),
            ),
        ),
        note="No criterion is printed. K = 6 for tooth and tip, normal laws, centred.",
    ),
    Claim(
        "(d), IT8 by the geometry against IT7 as printed",
        r"\text{IT8 with }\tfrac12K_m\text{ disturbs less than IT7 with }K_m",
        less(
            measurement_spread(8, 0, 3, "involute"),
            measurement_spread(7, 0, 3, "printed"),
        ),
        note="The recommendation against grade 8 rests on the lost factor 1/2.",
        marks=("ours", "calibrated"),
    ),
    Claim(
        "(e)",
        r"\text{with a zero limit error of the gauge the shares depend only on the tip's grade}",
        Equality(
            wrongly_rejected(measurement_spread(6, 0, 3, "printed"), 6),
            wrongly_rejected(measurement_spread(6, 0, 3, "printed"), 4),
        ),
        readings=(
            Reading(
                "of the measurement errors only that of the tip diameter remains",
                Equality(
                    error_variance(K_m, K_m).subs({sigma_height: 0, sigma_thickness: 0}),
                    (influence * sigma_tip) ** 2,
                ),
            ),
        ),
        note="The shares depend on the spread and the expectation of the tooth thickness, too: "
        "K = 6 and K = 4 differ.",
    ),
    Claim(
        "(e), what remains",
        r"\text{perfect gauge, IT6: }0.3\text{ to }0.4~\%\text{ wrongly rejected as printed, "
        r"}0.1\text{ to }0.2~\%\text{ by the geometry}",
        Conjunction(
            (
                less(Rational("0.003"), rejected_by(6, 0)),
                less(rejected_by(6, 0), Rational("0.004")),
                less(Rational("0.001"), rejected_by(6, 0, geometry="involute")),
                less(rejected_by(6, 0, geometry="involute"), Rational("0.002")),
            )
        ),
        note="K = 6 for tooth and tip, normal laws, centred.",
        marks=("ours", "calibrated"),
    ),
)

ROWS = GEOMETRY_ROWS + LINEAR_ROWS + ALGORITHM_ROWS + EXAMPLE_ROWS + CLAIM_ROWS
