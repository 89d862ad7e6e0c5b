"""The geometry of paper 3, rebuilt: basic rack, involute, gauge on the tip circle."""

from __future__ import annotations

from sympy import Abs, Eq, Expr, Matrix, Symbol, cos, diff, pi, sin, sqrt, tan

from .._linear import solve_linear
from .symbols import (
    E_cs,
    E_true,
    alpha,
    centre_change,
    delta,
    dh,
    dh_gauge,
    ds_gauge,
    e_tip,
    m,
    mate,
    psi,
    r_b,
    t_c,
    thinning,
    tilt,
    y_c,
    z,
)

# Basic rack, symmetric about its tooth space's axis; the pitch point is the origin, y points to
# the tip of the wheel's tooth. The rack's flank cuts the pitch line half a tooth from the axis;
# the common normal goes through the pitch point, so contact is at the foot of the perpendicular.
flank_point = Matrix([pi * m / 4, 0])
flank_normal = Matrix([cos(alpha), sin(alpha)])
contact = flank_normal * flank_point.dot(flank_normal)
rack_chord = 2 * contact[0]
rack_height = m - contact[1]

# Clearance along both normals, the mate being such a rack: the tooth is thinner by E_cs, the mate
# by its own decrease, and the mate is withdrawn by the deviation of the centre distance.
withdrawal = Matrix([mate / 2, centre_change]) - Matrix([-E_cs / 2, 0])
side_clearance = 2 * flank_normal.dot(withdrawal)

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
linearisation_root = (r_b * t_c) ** 2 - dh * (2 * y_c - dh)
linearisation_bound = (
    dh**2 * (y_c + Abs(dh)) ** 3 / (r_b**3 * sqrt(linearisation_root.subs(dh, Abs(dh))))
)

# The gauge stands on the actual tip circle, its line h_c + Delta h_c below.
line_nominal = tip_radius - nominal_height
line_actual = tip_radius + e_tip / 2 - (nominal_height + dh_gauge)
height_deviation = line_nominal - line_actual
# Counted towards the tip instead, the gauge's error as well.
height_towards_tip = (line_actual - line_nominal).subs(dh_gauge, -dh_gauge)
influence = slope_of_thickness.subs(delta, alpha)
measured_change = influence * height_deviation

# A flank turned about the wheel's centre by -turn: the change of its half chord at fixed height.
turn = Symbol("turn", real=True)
half_moved = (
    chord_half(alpha, half_tooth)
    - turn * chord_distance(alpha, half_tooth)
    + tan(alpha) * turn * chord_half(alpha, half_tooth)
)
turn_by_thinning = solve_linear(Eq(2 * turn * m * z / 2, thinning), turn)
chord_by_thinning = 2 * (chord_half(alpha, half_tooth) - half_moved).subs(turn, turn_by_thinning)

# The indication less the nominal chord, to first order: the tooth, thicker by its true deviation,
# along the gauge's line, `dh` deeper than the nominal one.
gauge_line = line_nominal - dh
chord_at_line = involute_chord + influence * (involute_distance - gauge_line)
reading = chord_at_line - chord_by_thinning.subs(thinning, -E_true) + ds_gauge - involute_chord
