"""Letters and geometry of paper 3, rebuilt, its wheel in numbers, and the shares of its parts.

Conventions: lengths in mm, angles in rad. The tooth's axis points from the wheel's centre to the
tip. Heights grow from the tip towards the centre, deviations of thickness are positive for a
thicker tooth. Letters that the paper uses twice are kept apart: `Delta h_c` and `Delta S_c` are the
gauge's errors of the flow chart; `K` is T/sigma and `K_m` the influence of the height.
"""

from pathlib import Path

import sympy as sp

from mechproof.document.transcription import Transcription
from mechproof.record import ANGLE, LENGTH, Notation, Part, Scope, Variable, list_given

from .._algebra import solve_linear
from .._metrology import POSITIVE, normal_between, normal_outside

PRINT = Transcription(Path(__file__).with_name("paper.tex"))
m, z, s_c, sigma, K, K_m, E_cs, T_c = PRINT.symbols("m z s_c sigma K K_m E_cs T_c")
dh, dh_gauge, ds_gauge, ds_height = PRINT.symbols("Delta_h Delta_hc Delta_Sc Delta_Sca")
e_tip, E_true, E_measured, f_true, f_measured = PRINT.symbols("e_dau E_csu E_cs0 f_u f_0")
alpha, psi, place, width, degree = sp.symbols("alpha psi p w degree", positive=True)
incline, gauge_um, millimetre = sp.symbols("tan_alpha sigma_gauge mm", positive=True)
sigma_tip, sigma_height, sigma_thickness = sp.symbols("sigma_d sigma_h sigma_S", positive=True)
tip_tolerance, interval = sp.symbols("IT_d U", positive=True)
clearance = sp.Symbol("j_n", nonnegative=True)
delta, tilt, turn, thinning = sp.symbols("delta tilt turn Delta_s", real=True)
r_b, t_c, y_c, above, below = sp.symbols("r_b t_c y_c q_1 q_2", real=True)
mate, centre_change, micrometre = sp.symbols("E_mate Delta_a um", real=True)
rightly_accepted, wrongly_accepted, rightly_rejected, wrongly_rejected = sp.symbols(
    "rightly_accepted wrongly_accepted rightly_rejected wrongly_rejected", real=True
)

# The design: the constant chord and its height below the tip, addendum of one module.
chord = sp.pi * m * sp.cos(alpha) ** 2 / 2
chord_height = m * (1 - sp.pi * sp.sin(2 * alpha) / 8)

# The kernels list definitions in this order.
VARIABLES = (
    Variable(r_b, "base radius", LENGTH, POSITIVE, given=m * z * sp.cos(alpha) / 2, latex=("r_b",)),
    Variable(
        t_c,
        "roll angle at the constant chord",
        ANGLE,
        given=sp.tan(alpha) + sp.pi / (2 * z),
        latex=("t_c",),
    ),
    Variable(
        y_c,
        "from the wheel's centre to the constant chord",
        LENGTH,
        given=m * (z / 2 + sp.pi * sp.sin(2 * alpha) / 8),
    ),
    *PRINT.give({s_c: chord, K_m: 2 * sp.tan(alpha)}),
    Variable(
        alpha,
        "profile angle of the basic rack",
        ANGLE,
        within=sp.Interval.open(0, sp.pi / 4),
        latex=(r"\alpha",),
    ),
    Variable(incline, "tangent of the profile angle", within=sp.Interval.open(0, 1)),
    Variable(
        delta, "angle of the flank's tangent with the tooth's axis", ANGLE, latex=(r"\delta",)
    ),
    Variable(
        tilt,
        "angle between the tangents at a chord's end and at the constant chord's",
        ANGLE,
        latex=(r"\varepsilon",),
    ),
    Variable(psi, "half the tooth's angle at the base circle", ANGLE, within=POSITIVE),
    Variable(thinning, "change of thickness on the pitch circle", LENGTH),
    Variable(millimetre, "the unit of length", LENGTH, POSITIVE, latex=(r"\mathrm{mm}",)),
    Variable(
        micrometre, "a thousandth of it", LENGTH, given=millimetre / 1000, latex=(r"\mu\mathrm{m}",)
    ),
    Variable(rightly_accepted, "share of good teeth that are accepted", within=sp.Interval(0, 1)),
    Variable(wrongly_accepted, "share of bad teeth that are accepted", within=sp.Interval(0, 1)),
    Variable(rightly_rejected, "share of bad teeth that are rejected", within=sp.Interval(0, 1)),
    Variable(wrongly_rejected, "share of good teeth that are rejected", within=sp.Interval(0, 1)),
    Variable(
        place, "place in the tolerance field, from its upper end", within=sp.Interval.open(0, 1)
    ),
    Variable(
        sigma_tip, "standard deviation of the tip diameter", LENGTH, POSITIVE, latex=(r"\sigma_d",)
    ),
    Variable(sigma_height, "standard deviation of the gauge in height", LENGTH, POSITIVE),
    Variable(sigma_thickness, "standard deviation of the gauge in thickness", LENGTH, POSITIVE),
    Variable(above, "from the expected reading of a tooth to the upper limit", LENGTH),
    Variable(below, "from the lower limit to the expected reading of a tooth", LENGTH),
    Variable(width, "standard deviation of the measurement error times sqrt(2)", LENGTH, POSITIVE),
    Variable(degree, "accuracy degree", within=POSITIVE),
    Variable(mate, "decrease of the mate's tooth thickness", LENGTH),
    Variable(centre_change, "deviation of the centre distance", LENGTH, sign="positive: too long"),
    Variable(clearance, "guaranteed side clearance", LENGTH, sp.Interval(0, sp.oo)),
    Variable(tip_tolerance, "tolerance of the tip diameter", LENGTH, POSITIVE),
    Variable(interval, "interval measure of the gauge's uncertainty", LENGTH, POSITIVE),
    Variable(gauge_um, "standard deviation of the gauge in um", within=POSITIVE),
)
# Letters printed twice: Delta S_c of (1) is the thickness that follows from the height.
NOTATION = Notation(
    factors=("m", "mz", "t_c"), scopes=(Scope(rows=("(1)",), names={r"\Delta S_c": ds_height}),)
)
read = PRINT.reader(VARIABLES, NOTATION)

# Basic rack, involute, gauge on the tip circle ----------------------------------------------------

# Basic rack, symmetric about its tooth space's axis; the pitch point is the origin, y points to the
# tip of the wheel's tooth. The rack's flank cuts the pitch line half a tooth from the axis; the
# common normal goes through the pitch point, so contact is at the foot of the perpendicular.
flank_point = sp.Matrix([sp.pi * m / 4, 0])
flank_normal = sp.Matrix([sp.cos(alpha), sp.sin(alpha)])
contact = flank_normal * flank_point.dot(flank_normal)
rack_chord = 2 * contact[0]
rack_height = m - contact[1]

# Clearance along both normals, the mate being such a rack: the tooth is thinner by E_cs, the mate
# by its own decrease, and the mate is withdrawn by the deviation of the centre distance.
withdrawal = sp.Matrix([mate / 2, centre_change]) - sp.Matrix([-E_cs / 2, 0])
side_clearance = 2 * flank_normal.dot(withdrawal)

# Involute of the base circle: in the frame of the tangent the chord's end has the coordinates
# r_b (radius to the tangency point) and r_b t (along the generating line, t the roll angle).
# The tangent of the flank is parallel to that radius, at the angle delta to the tooth's axis.


def chord_half(slope: sp.Expr, half_angle: sp.Expr, radius: sp.Expr = r_b) -> sp.Expr:
    """Half the chord's length where the flank's tangent has the angle `slope` to the axis."""
    return radius * ((slope + half_angle) * sp.cos(slope) - sp.sin(slope))


def chord_distance(slope: sp.Expr, half_angle: sp.Expr, radius: sp.Expr = r_b) -> sp.Expr:
    """Distance of that chord from the wheel's centre."""
    return radius * (sp.cos(slope) + (slope + half_angle) * sp.sin(slope))


roll = delta + psi
thickness, distance = 2 * chord_half(delta, psi), chord_distance(delta, psi)
slope_of_thickness = sp.diff(thickness, delta) / sp.diff(-distance, delta)
curvature_of_thickness = sp.diff(slope_of_thickness, delta) / sp.diff(-distance, delta)

# Half the angle of the tooth at the base circle: half of pi/z at the pitch circle, plus inv(alpha).
half_tooth = sp.pi / (2 * z) + sp.tan(alpha) - alpha
involute_chord = 2 * chord_half(alpha, half_tooth)
involute_distance = chord_distance(alpha, half_tooth)
tip_radius = m * z / 2 + m
nominal_height = tip_radius - involute_distance

# From the constant chord to a chord where the tangent has turned by `tilt`: the integrals of r_b t
# along and across the first tangent.
along = (t_c + tilt) * sp.sin(tilt) - (1 - sp.cos(tilt))
across = t_c * (1 - sp.cos(tilt)) + sp.sin(tilt) - tilt * sp.cos(tilt)
height_change = r_b * (across * sp.sin(alpha) - along * sp.cos(alpha))
thickness_change = -2 * r_b * (along * sp.sin(alpha) + across * sp.cos(alpha))
linearisation_root = (r_b * t_c) ** 2 - dh * (2 * y_c - dh)
linearisation_bound = (
    dh**2 * (y_c + sp.Abs(dh)) ** 3 / (r_b**3 * sp.sqrt(linearisation_root.subs(dh, sp.Abs(dh))))
)

# The gauge rests on the actual tip circle, its line h_c + Delta h_c below.
line_nominal = tip_radius - nominal_height
line_actual = tip_radius + e_tip / 2 - (nominal_height + dh_gauge)
height_deviation = line_nominal - line_actual
# The same with the gauge's error counted towards the tip, too.
height_towards_tip = (line_actual - line_nominal).subs(dh_gauge, -dh_gauge)
influence = slope_of_thickness.subs(delta, alpha)

# A flank turned about the wheel's centre by -turn: the change of its half chord at fixed height.
half_moved = (
    chord_half(alpha, half_tooth)
    - turn * chord_distance(alpha, half_tooth)
    + sp.tan(alpha) * turn * chord_half(alpha, half_tooth)
)
turn_by_thinning = solve_linear(sp.Eq(2 * turn * m * z / 2, thinning), turn)
chord_by_thinning = 2 * (chord_half(alpha, half_tooth) - half_moved).subs(turn, turn_by_thinning)

# The indication minus the nominal chord, to first order: the tooth, thicker by its true deviation,
# along the gauge's line, `dh` deeper than the nominal one.
gauge_line = line_nominal - dh
chord_at_line = involute_chord + influence * (involute_distance - gauge_line)
reading = chord_at_line - chord_by_thinning.subs(thinning, -E_true) + ds_gauge - involute_chord

# The wheel in numbers (mm, unless said otherwise), and ISO tolerances -----------------------------

PROFILE_ANGLE = sp.pi / 9
MODULE, TEETH = 3, 50
WHEEL = {m: sp.S(MODULE), z: sp.S(TEETH), alpha: PROFILE_ANGLE}
PRINTED_INFLUENCE = read("(1), influence 0.7284")[1].coeff(dh)
DECREASE_UM = int(read("data, smallest deviation")[1] / micrometre)
TOLERANCE_UM = int(read("data, tolerance")[1] / micrometre)
K_PRINTED = int(read("Table 1, ratio of tolerance and standard deviation")[1])
GAUGE_UM, RECOMMENDED_UM = 50, 2
PRINTED_SIZES = {
    **WHEEL,
    E_cs: sp.Rational(DECREASE_UM, 1000),
    T_c: sp.Rational(TOLERANCE_UM, 1000),
    interval: sp.Rational(GAUGE_UM, 1000),
    K: sp.S(K_PRINTED),
    clearance: sp.S.Zero,
    millimetre: sp.S.One,
}

# A tilt (rad) that turns the tangent over more than 0.1 mm of height: the 50 µm of the gauge and
# the 25 µm of IT6 together are less.
NARROW = sp.Rational(1, 260)
HEIGHTS_TO_0_1_MM = Part(
    "the height is off by up to 0.1 mm, either way", {tilt: sp.Interval(0, NARROW)}
)
# The paper gives deviations in whole micrometres: one micrometre as a share of 0.1 mm.
LAST_SHARE = sp.Rational(1, 100)

# ISO 286-1: i = 0.45 D^(1/3) + 0.001 D (um; D in mm, the geometric mean of the range 120 to 180).
RANGE = (120, 180)
TIP_DIAMETER = MODULE * (TEETH + 2)
RANGE_MEAN = sp.sqrt(RANGE[0] * RANGE[1])
TOLERANCE_UNIT = (
    sp.Rational("0.45") * RANGE_MEAN ** sp.Rational(1, 3) + sp.Rational("0.001") * RANGE_MEAN
)
GRADES = {6: (10, 25), 7: (16, 40), 8: (25, 63)}


def of_wheel(expression: sp.Expr) -> sp.Expr:
    """Put the printed wheel into an expression."""
    return expression.subs(list_given(VARIABLES)).subs(WHEEL)


def at_angle(expression: sp.Expr, degrees: int | str) -> sp.Expr:
    """Put the printed module and a profile angle in degrees into an expression."""
    return expression.subs({m: MODULE, alpha: sp.Rational(degrees) * sp.pi / 180})


# Shares of parts, accepted and rejected, good and bad, by normal laws -----------------------------

GEOMETRIES = {
    "printed": (PRINTED_INFLUENCE, PRINTED_INFLUENCE),
    "involute": (sp.tan(PROFILE_ANGLE), 2 * sp.tan(PROFILE_ANGLE)),
}


# Share of good teeth, normal law centred on its field of K = 6 standard deviations.
THREE_SIGMA = sp.Rational(K_PRINTED, 2)
NORMAL_SHARE = normal_between(sp.S.Zero, sp.S.One, -THREE_SIGMA, THREE_SIGMA)


def tip_spread(grade: int, geometry: str = "printed") -> sp.Expr:
    """Return the standard deviation (um) of thickness from the tip diameter, IT/sigma = K."""
    return GEOMETRIES[geometry][0] * sp.Rational(GRADES[grade][1], K_PRINTED)


def gauge_spread(gauge: sp.Expr, geometry: str = "printed") -> sp.Expr:
    """Return the standard deviation of thickness from that of the gauge in both directions."""
    return sp.sqrt(1 + GEOMETRIES[geometry][1] ** 2) * gauge


def measurement_spread(grade: int, gauge: sp.Expr, geometry: str = "printed") -> sp.Expr:
    """Return the standard deviation (um) of the whole error, from tip and gauge."""
    return sp.sqrt(tip_spread(grade, geometry) ** 2 + gauge_spread(gauge, geometry) ** 2)


def crossover(grade: int, geometry: str = "printed") -> sp.Expr:
    """Return the standard deviation of the gauge (um) that disturbs as much as the tip."""
    return tip_spread(grade, geometry) / gauge_spread(sp.S.One, geometry)


def good_but_rejected(spread: sp.Expr, tolerance: int = TOLERANCE_UM) -> sp.Expr:
    """Share of good teeth rejected; normal laws, centred, T/sigma = K."""
    y = sp.Symbol("y", real=True)
    half, spread_true = sp.Rational(tolerance, 2), sp.Rational(tolerance, K_PRINTED)
    density = sp.exp(-(y**2) / (2 * spread_true**2)) / (spread_true * sp.sqrt(2 * sp.pi))
    return sp.Integral(density * normal_outside(y, spread**2, -half, half), (y, -half, half))


def rejected_by(
    grade: int, limit_error: int | sp.Rational, multiple: int = 3, geometry: str = "printed"
) -> sp.Expr:
    """Share of good teeth rejected, for a grade of the tip and a limit error of the gauge."""
    return good_but_rejected(
        measurement_spread(grade, sp.Rational(limit_error) / multiple, geometry)
    )


def accepted_by(grade: int, limit_error: sp.Rational, bias: sp.Expr = sp.S.Zero) -> sp.Expr:
    """Share of all teeth accepted; limit error 3 sigma, a bias (um) in height and thickness."""
    half, spread_true = sp.Rational(TOLERANCE_UM, 2), sp.Rational(TOLERANCE_UM, K_PRINTED)
    spread = measurement_spread(grade, limit_error / 3)
    expected = (1 + PRINTED_INFLUENCE) * bias
    return normal_between(expected, spread_true**2 + spread**2, -half, half)


def error_variance(tip: sp.Expr, height: sp.Expr) -> sp.Expr:
    """Variance of the measured thickness about the true one."""
    return (tip * sigma_tip) ** 2 + (height * sigma_height) ** 2 + sigma_thickness**2


chance_to_accept = normal_between(sp.S.Zero, width**2 / 2, -below, above)
