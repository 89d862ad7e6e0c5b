"""Symbols of paper 3.

Conventions: lengths in mm, angles in rad. The tooth's axis points from the wheel's centre to the
tip. Heights grow from the tip towards the centre, deviations of thickness are positive for a
thicker tooth. Letters that the paper uses twice are kept apart: `Delta h_c` and `Delta S_c` are the
gauge's errors of the flow chart; `K` is T/sigma and `K_m` the influence of the height.
"""

from __future__ import annotations

from sympy import Interval, S, Symbol, cos, oo, pi, sin, symbols, tan

from mechproof.latex import Reader
from mechproof.record import ANGLE, LENGTH, Notation, Scope, Variable

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
rightly_accepted, wrongly_accepted, rightly_rejected, wrongly_rejected = symbols(
    "rightly_accepted wrongly_accepted rightly_rejected wrongly_rejected", real=True
)
place = Symbol("p", positive=True)
sigma_tip, sigma_height, sigma_thickness = symbols("sigma_d sigma_h sigma_S", positive=True)
above, below = symbols("q_1 q_2", real=True)
width = Symbol("w", positive=True)
degree = Symbol("degree", positive=True)
mate, centre_change = symbols("E_mate Delta_a", real=True)
clearance = Symbol("j_n", nonnegative=True)
gauge_um = Symbol("sigma_gauge", positive=True)
micrometre = Symbol("um", real=True)
tip_tolerance, interval = symbols("IT_d U", positive=True)

POSITIVE = Interval.open(0, oo)

# The design: the constant chord and its height below the tip, addendum of one module.
chord = pi * m * cos(alpha) ** 2 / 2
chord_height = m * (1 - pi * sin(2 * alpha) / 8)

VARIABLES = (
    Variable(m, "module", LENGTH, POSITIVE, latex=("m",)),
    Variable(z, "number of teeth", within=S.Naturals, latex=("z",)),
    Variable(
        alpha,
        "profile angle of the basic rack",
        ANGLE,
        within=Interval.open(0, pi / 4),
        latex=(r"\alpha",),
    ),
    Variable(incline, "tangent of the profile angle", within=Interval.open(0, 1)),
    Variable(
        delta, "angle of the flank's tangent with the tooth's axis", ANGLE, latex=(r"\delta",)
    ),
    Variable(
        tilt,
        "angle between the tangents at a chord's end and at the constant chord's",
        ANGLE,
        latex=(r"\varepsilon",),
    ),
    Variable(start, "angle of the flank's tangent with the tooth's axis at a first chord", ANGLE),
    Variable(r_b, "base radius", LENGTH, POSITIVE, given=m * z * cos(alpha) / 2, latex=("r_b",)),
    Variable(
        t_c,
        "roll angle at the constant chord",
        ANGLE,
        given=tan(alpha) + pi / (2 * z),
        latex=("t_c",),
    ),
    Variable(
        y_c,
        "from the wheel's centre to the constant chord",
        LENGTH,
        given=m * (z / 2 + pi * sin(2 * alpha) / 8),
    ),
    Variable(s_c, "constant chord", LENGTH, given=chord, latex=(r"\bar S_c",)),
    Variable(psi, "half the tooth's angle at the base circle", ANGLE, within=POSITIVE),
    Variable(thinning, "change of thickness on the pitch circle", LENGTH),
    Variable(
        dh,
        "deviation of the measured height: how much deeper the chord lies",
        LENGTH,
        latex=(r"\Delta h",),
    ),
    Variable(
        dh_gauge,
        "error of the gauge's height",
        LENGTH,
        sign="positive: set too deep",
        latex=(r"\Delta h_c",),
    ),
    Variable(
        ds_gauge, "indication error of the gauge in thickness", LENGTH, latex=(r"\Delta S_c",)
    ),
    Variable(e_tip, "deviation of the tip diameter", LENGTH, latex=("e_{dau}",)),
    Variable(E_true, "true deviation of the tooth thickness", LENGTH, latex=("E_{csu}",)),
    Variable(E_measured, "measured deviation of the tooth thickness", LENGTH, latex=("E_{cs0}",)),
    Variable(
        ds_height,
        "change of the measured thickness with the height",
        LENGTH,
        latex=(r"\Delta S_{ca}",),
    ),
    Variable(
        E_cs, "smallest deviation of the tooth thickness", LENGTH, POSITIVE, latex=("E_{cs}",)
    ),
    Variable(T_c, "tolerance of the tooth thickness", LENGTH, POSITIVE, latex=("T_c",)),
    Variable(
        sigma, "standard deviation of the true thickness", LENGTH, POSITIVE, latex=(r"\sigma",)
    ),
    Variable(millimetre, "the unit of length", LENGTH, POSITIVE, latex=(r"\mathrm{mm}",)),
    Variable(K, "tolerance over standard deviation", within=POSITIVE, latex=("K",)),
    Variable(K_m, "influence of the height on the thickness", given=2 * tan(alpha), latex=("K_m",)),
    Variable(f_true, "1 for a good tooth, else 0", within=Interval(0, 1), latex=("f_u",)),
    Variable(f_measured, "1 for an accepted tooth, else 0", within=Interval(0, 1), latex=("f_0",)),
    Variable(rightly_accepted, "share of good teeth that are accepted", within=Interval(0, 1)),
    Variable(wrongly_accepted, "share of bad teeth that are accepted", within=Interval(0, 1)),
    Variable(rightly_rejected, "share of bad teeth that are rejected", within=Interval(0, 1)),
    Variable(wrongly_rejected, "share of good teeth that are rejected", within=Interval(0, 1)),
    Variable(place, "place in the tolerance field, from its upper end", within=Interval.open(0, 1)),
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
    Variable(clearance, "guaranteed side clearance", LENGTH, Interval(0, oo)),
    Variable(tip_tolerance, "tolerance of the tip diameter", LENGTH, POSITIVE),
    Variable(interval, "interval measure of the gauge's uncertainty", LENGTH, POSITIVE),
    Variable(
        micrometre, "a thousandth of it", LENGTH, given=millimetre / 1000, latex=(r"\mu\mathrm{m}",)
    ),
    Variable(gauge_um, "standard deviation of the gauge in um", within=POSITIVE),
)
# Letters printed twice: Delta S_c of (1) is the thickness that follows from the height.
NOTATION = Notation(
    factors=("m", "mz", "t_c"),
    scopes=(Scope(rows=("(1)",), names={r"\Delta S_c": ds_height}),),
)
READER = Reader(VARIABLES, NOTATION)
