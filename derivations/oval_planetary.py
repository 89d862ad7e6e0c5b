"""Paper 2: planetary mechanism with two external pairs of oval wheels.

Order of the file: symbols; the mechanics (velocity plan, inversion, ovals, position); kinds of
motion; what the paper prints, row by row; what is measured; the quantities that become kernels.

Conventions: angles are positive in the direction of the carrier's rotation; distances on the
line A-C are positive from A towards C; at phi1 = 0 a major axis of the sun 4 points to C and the
major axes of the satellite's wheels 5 and 6 stand at right angles, that of 6 along the line A-C.
"""

from __future__ import annotations

import sympy as sp

from mechproof.record import (
    FREQUENCY,
    LENGTH,
    SPEED,
    Argument,
    Bar,
    Claim,
    Completion,
    Completions,
    Conjunction,
    Definition,
    Distinct,
    Equality,
    Equation,
    Form,
    Holds,
    Paper,
    Part,
    PrintedNumber,
    Quantity,
    Reading,
    Row,
    Shortcut,
    Variable,
)

# Symbols --------------------------------------------------------------------------------------

phi1, mount = sp.symbols("phi1 mount", real=True)
R4, R5 = sp.symbols("R4 R5", positive=True)
R3, R6 = sp.symbols("R3 R6", positive=True)
e, e1, e2 = sp.symbols("e e1 e2", real=True)
a, rho3, rho4, rho5, rho6, span = sp.symbols("a rho3 rho4 rho5 rho6 L", positive=True)
phi, phi5, phi6, start = sp.symbols("varphi varphi5 varphi6 c", real=True)
omega1, omega3 = sp.symbols("omega1 omega3", real=True)
VC, VD, AC, BC, BD, CD, DE = sp.symbols("v_C v_D AC BC BD CD DE", real=True)
sB, sC, sD = sp.symbols("s_B s_C s_D", real=True)
ratio_symbol = sp.Symbol("varphi3'", real=True)
k, x = sp.symbols("k x", real=True)
alpha, beta, gamma, delta = sp.symbols("alpha beta gamma delta", real=True)
both, less, swing, lever, shift, rise, y = sp.symbols(
    "both less swing lever shift rise y", real=True
)
lam, mu = sp.symbols("lambda mu", positive=True)
nu, xi, tangent = sp.symbols("nu xi U", real=True)
width, eta = sp.symbols("T eta", positive=True)
n = sp.Symbol("n", integer=True, positive=True)
q = sp.IndexedBase("q", real=True)
qbar, s2, s2_mean, u_mean, sigma2 = sp.symbols("qbar s2 s2_mean u_mean sigma2", real=True)
lowest, highest = sp.symbols("q_min q_max", real=True)
read_time, output, diameter, millimetre = sp.symbols("t_read V_out d_encoder mm", positive=True)
i, j, m, index = sp.symbols("i j m k", integer=True)
tau, theta, r = sp.symbols("tau theta r", real=True)

POSITIVE = sp.Interval.open(0, sp.oo)
ECCENTRICITY = sp.Interval.Ropen(0, 1)

VARIABLES = (
    Variable(phi1, "angle of the carrier 1", sign="positive in its direction of rotation"),
    Variable(mount, "turn of wheel 6 on its shaft, from its place in the paper", sign="as phi1"),
    Variable(R4, "radius of a cylindrical sun 4", LENGTH, POSITIVE),
    Variable(R5, "radius of a cylindrical wheel 5", LENGTH, POSITIVE),
    Variable(R3, "radius of a cylindrical wheel 3", LENGTH, POSITIVE),
    Variable(R6, "radius of a cylindrical wheel 6", LENGTH, POSITIVE),
    Variable(e, "eccentricity of the ellipse that generates an oval", within=ECCENTRICITY),
    Variable(e1, "eccentricity of the oval pair 4-5", within=ECCENTRICITY),
    Variable(e2, "eccentricity of the oval pair 6-3", within=ECCENTRICITY),
    Variable(k, "ratio of the cylindrical wheels 4 and 5", given=R4 / R5),
    Variable(x, "twice the turn of the satellite against the carrier", given=2 * k * phi1),
    Variable(
        alpha,
        "coefficient of tan(chi) = alpha*t/(beta + gamma*t), t = tan(phi1)",
        given=(1 + e1) * (1 + e2) * (1 - e2),
    ),
    Variable(
        beta,
        "coefficient of tan(chi)",
        given=(1 - e1) * ((1 - e2) ** 2 * sp.cos(mount) ** 2 + (1 + e2) ** 2 * sp.sin(mount) ** 2),
    ),
    Variable(
        gamma,
        "coefficient of tan(chi)",
        given=4 * (1 + e1) * e2 * sp.sin(mount) * sp.cos(mount),
    ),
    Variable(
        delta,
        "alpha - beta",
        given=2
        * ((e1 + e2) * (1 - e2) * sp.cos(mount) ** 2 + (e1 - e2) * (1 + e2) * sp.sin(mount) ** 2),
    ),
    Variable(both, "alpha/(1 - e2)", given=(1 + e1) * (1 + e2)),
    Variable(less, "what beta/(1 - e2) has without a turn of wheel 6", given=(1 - e1) * (1 - e2)),
    Variable(lever, "part of shift and rise", given=4 * e2 * sp.sin(mount) / (1 - e2)),
    Variable(shift, "the rest of beta/(1 - e2)", given=lever * (1 - e1) * sp.sin(mount)),
    Variable(rise, "gamma/(1 - e2)", given=lever * (1 + e1) * sp.cos(mount)),
    Variable(swing, "both - less", given=2 * (e1 + e2)),
    Variable(y, "what the turn of wheel 6 adds", given=shift + rise * sp.tan(phi1)),
    Variable(lam, "alpha, any positive number", within=POSITIVE),
    Variable(mu, "beta, any positive number", within=POSITIVE),
    Variable(nu, "gamma, any real number"),
    Variable(xi, "part of beta, any real number"),
    Variable(tangent, "tg(phi1) as a variable of its own"),
    Variable(a, "major semi-axis of the generating ellipse", LENGTH, POSITIVE),
    Variable(phi, "polar angle of an oval from its major axis"),
    Variable(phi6, "angle of wheel 6 against the carrier"),
    Variable(phi5, "angle of wheel 5 against the carrier", given=sp.pi / 2 - phi6),
    Variable(start, "constant of the integral (5)"),
    Variable(rho3, "radius of wheel 3 at D", LENGTH, POSITIVE),
    Variable(rho4, "radius of wheel 4 at B", LENGTH, POSITIVE),
    Variable(rho5, "radius of wheel 5 at B", LENGTH, POSITIVE),
    Variable(rho6, "radius of wheel 6 at D", LENGTH, POSITIVE),
    Variable(span, "distance of two fixed axes", LENGTH, POSITIVE),
    Variable(omega1, "angular velocity of the carrier", FREQUENCY, POSITIVE),
    Variable(omega3, "angular velocity of wheel 3", FREQUENCY),
    Variable(sB, "coordinate of B on the line A-C", LENGTH),
    Variable(sC, "coordinate of C", LENGTH, POSITIVE),
    Variable(sD, "coordinate of D", LENGTH),
    Variable(AC, "from A to C", LENGTH, given=sC),
    Variable(BC, "from B to C", LENGTH, given=sC - sB),
    Variable(BD, "from B to D", LENGTH, given=sD - sB),
    Variable(CD, "from D to C", LENGTH, given=sC - sD),
    Variable(DE, "from E to D", LENGTH, given=sD),
    Variable(VC, "velocity of C, positive with the carrier", SPEED, given=omega1 * sC),
    Variable(VD, "velocity of D, positive with the carrier", SPEED, given=omega3 * sD),
    Variable(ratio_symbol, "analogue of the angular velocity"),
    Variable(theta, "x as a variable of its own"),
    Variable(width, "tangent of half the angle x from the double zero", within=POSITIVE),
    Variable(eta, "ratio up to which the output counts as at rest", within=POSITIVE),
    Variable(n, "number of observations", within=sp.S.Naturals),
    Variable(q, "measurement errors"),
    Variable(lowest, "smallest possible measurement error"),
    Variable(highest, "largest possible measurement error"),
    Variable(qbar, "mean measurement error"),
    Variable(s2, "sample variance"),
    Variable(s2_mean, "estimate of the variance of the mean"),
    Variable(u_mean, "type A standard uncertainty"),
    Variable(sigma2, "variance of one observation", within=POSITIVE),
    Variable(read_time, "read time of the encoder, s", within=POSITIVE),
    Variable(output, "output range of the encoder, V", within=POSITIVE),
    Variable(diameter, "diameter of the encoder", LENGTH, POSITIVE),
    Variable(millimetre, "the unit of length", LENGTH, POSITIVE),
)

# A proper oval or ellipse, not a circle.
OVAL = sp.Interval.open(0, 1)

# The mechanics --------------------------------------------------------------------------------

# Velocity plan on the line A-C at one instant, the sun 4 at rest: the satellite turns about B.
s, omega_satellite, omega_out = sp.symbols("s omega_5 omega_3", real=True)
point_c = 2 * a
point_b = point_c - rho5
point_d = point_c - rho6
satellite_velocity = omega1 * point_c + omega_satellite * (s - point_c)
rolling = sp.solve(satellite_velocity.subs(s, point_b), omega_satellite)[0]
driven = sp.Eq(omega_out * point_d, satellite_velocity.subs({s: point_d, omega_satellite: rolling}))
ratio_by_plan = sp.solve(driven, omega_out)[0] / omega1

# Inversion (Willis), in units of omega1: seen from the carrier the sun turns with -1, and each
# external mesh reverses the sense of rotation.
sun_against_carrier = sp.Integer(-1)
satellite_against_carrier = -sun_against_carrier * (2 * a - rho5) / rho5
wheel_3_against_carrier = -satellite_against_carrier * rho6 / (2 * a - rho6)
ratio_by_inversion = 1 + wheel_3_against_carrier

# Ellipse seen from a focus: the distances to both foci (2 a e apart) add up to 2 a. The oval has
# at half the polar angle the radius of the ellipse.
second_focus_squared = r**2 - 4 * a * e * r * sp.cos(theta) + 4 * a**2 * e**2
focal_radius = sp.solve(sp.Eq((2 * a - r) ** 2, second_focus_squared), r)[0]


def oval_radius(eccentricity: sp.Expr, cosine: sp.Expr) -> sp.Expr:
    """Radius of the oval, by the cosine of twice the polar angle."""
    return focal_radius.subs({e: eccentricity, sp.cos(theta): cosine})


def pair_ratio(eccentricity: sp.Expr, cosine: sp.Expr) -> sp.Expr:
    """Speed of the driven wheel by that of the driver, both external: the quotient of the radii."""
    radius = oval_radius(eccentricity, cosine)
    return sp.cancel(radius / (2 * a - radius))


def driven_angle(eccentricity: sp.Expr, driver: sp.Expr) -> sp.Expr:
    """Angle of the driven wheel of an oval pair, 0 where that of the driver is 0."""
    return driver + sp.atan2(
        eccentricity * sp.sin(2 * driver), 1 - eccentricity * sp.cos(2 * driver)
    )


def roll(eccentricity: sp.Expr, angle: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Cosine and sine of twice the angle of the driven wheel, by the angle of the driver.

    It is ahead of the driver by lead = atan(y/x): see `driven_angle`.
    """
    cosine, sine = sp.cos(2 * angle), sp.sin(2 * angle)
    y, x_ = eccentricity * sine, 1 - eccentricity * cosine
    cos_2lead = (x_**2 - y**2) / (x_**2 + y**2)
    sin_2lead = 2 * x_ * y / (x_**2 + y**2)
    return cosine * cos_2lead - sine * sin_2lead, sine * cos_2lead + cosine * sin_2lead


def roll_reduced(eccentricity: sp.Expr, angle: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Give the same as `roll` in the fewest terms."""
    cosine, sine = sp.cos(2 * angle), sp.sin(2 * angle)
    square = 1 + eccentricity**2 - 2 * eccentricity * cosine
    return (
        ((1 + eccentricity**2) * cosine - 2 * eccentricity) / square,
        (1 - eccentricity**2) * sine / square,
    )


# The two oval pairs in series: sun 4 turned by phi1 against the carrier, wheel 6 by phi6 + mount.
COS_4 = sp.cos(2 * phi1)
sun_radius = oval_radius(e1, COS_4)
cos_6, sin_6 = roll_reduced(e1, phi1)
cos_mounted = cos_6 * sp.cos(2 * mount) - sin_6 * sp.sin(2 * mount)
wheel_3_rate = pair_ratio(e1, COS_4) * pair_ratio(e2, cos_mounted)
two_pairs = {rho5: 2 * a - sun_radius, rho6: oval_radius(e2, cos_6)}

# Both pairs are Moebius maps of tangents, and so is their composition:
# tan(chi) = lambda*t/(mu + nu*t), t = tan(phi1), chi the turn of wheel 3 against the carrier,
# reversed. mu*cos(phi1) + nu*sin(phi1) + i*lambda*sin(phi1) has the argument chi.


def ratio_of_map(p: sp.Expr, q_: sp.Expr, g: sp.Expr) -> sp.Expr:
    """1 - d chi/d phi1 for the coefficients lambda, mu, nu = p, q_, g."""
    square = q_**2 * (1 + COS_4) + 2 * q_ * g * sp.sin(2 * phi1) + (p**2 + g**2) * (1 - COS_4)
    return 1 - 2 * p * q_ / square


def position_of_map(p: sp.Expr, q_: sp.Expr, g: sp.Expr, difference: sp.Expr) -> sp.Expr:
    """phi1 - chi as one argument; `difference` is p - q_."""
    return sp.atan2(
        g * (1 - COS_4) - difference * sp.sin(2 * phi1),
        p + q_ + (q_ - p) * COS_4 + g * sp.sin(2 * phi1),
    )


# The same as the argument of a constant vector and of one that turns about 1, as for one pair.
square_sum = (lam + mu) ** 2 + nu**2
along, across = lam**2 - mu**2 + nu**2, -2 * mu * nu
position_by_one_pair = -sp.atan2(-nu, lam + mu) - sp.atan2(
    along * sp.sin(2 * phi1) - across * COS_4,
    square_sum - along * COS_4 - across * sp.sin(2 * phi1),
)
COEFFICIENTS = (
    (1 + e1) * (1 - e2**2),
    (1 - e1) * (1 + e2**2 - 2 * e2 * sp.cos(2 * mount)),
    2 * (1 + e1) * e2 * sp.sin(2 * mount),
)

t = sp.tan(phi1)
POSITION = position_of_map(alpha, beta, gamma, delta)
RATIO = ratio_of_map(alpha, beta, gamma)
ACCELERATION = sp.diff(RATIO, phi1)

# All coefficients divided by 1 - e2, and beta + gamma*t split into less + y. y has the sine of the
# mounted wheel's angle as a factor and is large beside the rest as e2 -> 1; rounded once, it
# enters both arguments of atan2, and what is left of it where it vanishes is one small angle.
POSITION_FORM = sp.atan2(t * (y - swing), less + y + both * t**2)
spread = (less + y) ** 2 + both**2 * t**2
RATIO_FORM = 1 - both * (less + shift) * (1 + t**2) / spread
TILT = (
    y * (rise - shift * t),
    less * rise * (1 - t**2),
    (swing * (less + both) - 2 * less * shift) * t,
)
ACCELERATION_FORM = 2 * both * (less + shift) * (1 + t**2) * sum(TILT) / spread**2
ANY_MAP = {
    both: lam,
    less: mu - xi,
    shift: xi,
    rise: nu,
    swing: lam - mu + xi,
    y: xi + nu * t,
}

# Mounted as in the paper the two eccentricities act as one.
E_SERIES = (e1 + e2) / (1 + e1 * e2)
E_ALIGNED = (e1 - e2) / (1 - e1 * e2)


def position_of_one(eccentricity: sp.Expr) -> sp.Expr:
    """Position function of two pairs that act like one."""
    return phi1 - driven_angle(eccentricity, phi1)


def ratio_of_one(eccentricity: sp.Expr) -> sp.Expr:
    """Transmission ratio of two pairs that act like one."""
    return 1 - pair_ratio(eccentricity, COS_4)


# Pair 4-5 cylindrical: the satellite turns by (R4/R5) phi1 against the carrier.
RATIO_CYLINDRICAL = 1 - k * (1 - e2**2) / (1 + e2**2 - 2 * e2 * sp.cos(x))
POSITION_CYLINDRICAL = (R5 - R4) / R5 * phi1 - sp.atan2(e2 * sp.sin(x), 1 - e2 * sp.cos(x))
ACCELERATION_CYLINDRICAL = sp.diff(RATIO_CYLINDRICAL, x) * 2 * k
AXES_45 = {a: (R4 + R5) / 2, rho5: R5}
ratio_with_cylinders_45 = ratio_by_plan.subs(AXES_45).subs(
    rho6, oval_radius(e2, sp.cos(2 * R4 / R5 * phi1)).subs(AXES_45)
)
explicit = {x: 2 * R4 / R5 * phi1, k: R4 / R5}
ratio_45, position_45 = (f.subs(explicit) for f in (RATIO_CYLINDRICAL, POSITION_CYLINDRICAL))

# Pair 3-6 cylindrical.
AXES_36 = {a: (R3 + R6) / 2, rho6: R6}
ratio_with_cylinders_36 = ratio_by_plan.subs(AXES_36).subs(rho5, (2 * a - sun_radius).subs(AXES_36))
position_36 = phi1 - R6 / R3 * driven_angle(e1, phi1)


def integrate(ratio: sp.Expr) -> sp.Integral:
    """Integral of a ratio from phi1 = 0, where phi3 = 0."""
    return sp.Integral(ratio.subs(phi1, tau), (tau, 0, phi1))


# The kinds of motion --------------------------------------------------------------------------

# Extremes of d chi/d phi1 with a cylindrical pair 4-5.
fastest = R4 / R5 * (1 + e2) / (1 - e2)
slowest = R4 / R5 * (1 - e2) / (1 + e2)
FASTER = Part("R4/R5 > (1 + e2)/(1 - e2)", where=(R5 * (1 + e2) / (1 - e2) < R4,))
SLOWER = Part("R4/R5 < (1 - e2)/(1 + e2)", where=(R4 * (1 + e2) / (1 - e2) < R5,))
BELOW_UPPER = Part("R4/R5 < (1 + e2)/(1 - e2)", where=(R4 * (1 - e2) / (1 + e2) < R5,))
ABOVE_LOWER = Part("R4/R5 > (1 - e2)/(1 + e2)", where=(R5 * (1 - e2) / (1 + e2) < R4,))
PROPER_45 = Part("e2 > 0", {e2: OVAL})

# With R4/R5 at a limit the ratio has a double zero; half the width of a dwell is 2 atan(T) in x.
limit_ratio = RATIO_CYLINDRICAL.subs(k, (1 + e2) / (1 - e2)).subs(sp.cos(x), sp.cos(theta))
cos_beside = -(1 - width**2) / (1 + width**2)
ratio_beside = limit_ratio.subs(sp.cos(theta), cos_beside)
edge = (1 + e2) * sp.sqrt(eta / (4 * e2 - eta * (1 - e2) ** 2))
REACHED = Part(
    "e2 > 0 and eta below the largest ratio",
    {e2: OVAL},
    (eta < 4 * e2 / (1 - e2) ** 2,),
)

# What the paper prints ------------------------------------------------------------------------

VARIANT_36 = sp.Rational("0.2")
OVAL_45 = sp.Rational("0.2")
CYLINDERS_45 = {2: (25, 25), 3: (30, 20), 4: (32, 18)}
# n, mean error, u, printed half-width, all but n in degrees.
READINGS = {
    1: (175, "0.777", "0.18", "0.360"),
    2: (190, "0.035", "0.04", "0.080"),
    3: (214, "1.280", "0.11", "0.220"),
    4: (193, "-0.540", "0.15", "0.300"),
}
RESOLUTION = sp.Rational(360, 4096)
FULL_SCALE_LINEARITY = sp.Rational("0.003") * 360
READING_LINEARITY = sp.Rational("0.003") * 90


def print_radius(eccentricity: sp.Expr, angle: sp.Expr) -> sp.Expr:
    """Right-hand side of (2), (3) and (4)."""
    return a * (1 - eccentricity**2) / (1 - eccentricity * sp.cos(2 * angle))


print_5 = sp.Integral((1 - e1**2) / (1 + e1**2 - 2 * e1 * sp.cos(2 * tau)), (tau, 0, phi1))
print_7 = rho6 - rho5
print_9 = 2 * a - rho6
print_10 = (rho6 - rho5) * 2 * a / (rho5 * (2 * a - rho6))
print_11 = integrate(
    print_10.subs({rho5: a * (1 - e1**2) / (1 + e1 * cos_6), rho6: oval_radius(e2, cos_6)})
)

oval = print_radius(e, phi)
slope = sp.diff(oval, phi)
# Positive where the curve bends towards its centre.
bend = sp.factor(oval**2 + 2 * slope**2 - oval * sp.diff(oval, phi, 2))
mate_cosine, _ = roll(e, phi)
mate = a * (1 - e**2) / (1 + e * mate_cosine)


def with_cylinders(expression: sp.Expr, variant: int) -> sp.Expr:
    """Put the sizes of a variant with a cylindrical pair 4-5 into an expression."""
    sizes = dict(zip((R4, R5), CYLINDERS_45[variant], strict=True))
    return expression.subs({**sizes, e2: VARIANT_36})


def with_radii(variant: int, angle_of_6: sp.Expr) -> sp.Expr:
    """Ratio by the velocity plan with numbers for pair 4-5, any angle of wheel 6."""
    radius = oval_radius(e2, sp.cos(2 * angle_of_6)).subs(AXES_45)
    return with_cylinders(ratio_by_plan.subs(AXES_45).subs(rho6, radius), variant)


ovals = {e1: OVAL_45, e2: VARIANT_36}
position_1 = position_of_one(E_SERIES).subs(ovals)
ratio_1 = ratio_of_one(E_SERIES).subs(ovals)
DWELL_3 = sp.pi / 3


def below(left: sp.Expr, right: sp.Expr) -> Holds:
    """State left < right, for numbers, too, without deciding it here."""
    return Holds(sp.Lt(left, right, evaluate=False))


def reverses(ratio: sp.Expr, backward: sp.Expr, forward: sp.Expr) -> tuple[Holds, Holds]:
    """State that the ratio is negative at one carrier angle and positive at another."""
    return below(ratio.subs(phi1, backward), sp.S.Zero), below(sp.S.Zero, ratio.subs(phi1, forward))


def advances(position: sp.Expr, carrier: sp.Expr, output_angle: sp.Expr) -> Equality:
    """State by how much the output advances while the carrier turns by an angle."""
    return Equality(position.subs(phi1, phi1 + carrier) - position, output_angle)


def coverage(count: int) -> sp.Expr:
    """Percentage of Student's t with count - 1 degrees of freedom inside -2 ... 2."""
    freedom = sp.Rational(count - 1)
    share = sp.betainc_regularized(sp.S.Half, freedom / 2, 0, 4 / (4 + freedom))
    return 100 * share


def interval_row(variant: int) -> Claim:
    """State the 95 % interval of one variant: the half-width is twice the printed u."""
    _, mean, uncertainty, printed = READINGS[variant]
    return Claim(
        f"table 2, interval {variant}",
        rf"{mean}\pm{printed}^\circ",
        PrintedNumber(printed, 2 * sp.Rational(uncertainty)),
        note="The half-width is 2u with the u of table 2; the mean is the table's.",
    )


def coverage_row(variant: int) -> Claim:
    """State the level of the factor 2 for one variant."""
    count = READINGS[variant][0]
    return Claim(
        f"95 %, variant {variant}",
        rf"\text{{the 95 \% interval is }}\bar q\pm 2u,\ n={count}",
        PrintedNumber("95", coverage(count)),
        note="Coverage of the factor 2 by Student's t, normal observations assumed.",
    )


def least_scatter(variant: int) -> sp.Expr:
    """Smallest s = u sqrt(n) of single readings that rounds to the printed u."""
    count, _, uncertainty, _ = READINGS[variant]
    return (sp.Rational(uncertainty) - sp.Rational("0.005")) * sp.sqrt(count)


def largest_scatter(variant: int, half_range: sp.Expr) -> sp.Expr:
    """Largest standard deviation of n readings that stay within +- half_range."""
    count = READINGS[variant][0]
    return half_range * sp.sqrt(sp.Rational(count, count - 1))


MEANS = {variant: sp.Rational(row[1]) for variant, row in READINGS.items()}
UNCERTAINTIES = {variant: sp.Rational(row[2]) for variant, row in READINGS.items()}


def means_below(limits: dict[int, sp.Expr]) -> Conjunction:
    """State |mean error| <= limit for the variants of `limits`."""
    return Conjunction(
        tuple(
            Holds(sp.Le(abs(MEANS[variant]), limit, evaluate=False))
            for variant, limit in limits.items()
        )
    )


def scatter_rows() -> tuple[Claim, ...]:
    """State what u says of single readings, beside what the encoder can explain."""
    return (
        Claim(
            "table 2, scatter and resolution",
            r"s(q_k)=u\sqrt n>6\cdot0.088^\circ",
            Conjunction(tuple(below(6 * RESOLUTION, least_scatter(v)) for v in (1, 3, 4))),
            note="In variants 1, 3 and 4 single readings scatter by more than six steps of the "
            "encoder, u taken at the lower end of its rounding; one step spreads 0.088/sqrt(12).",
            marks=("ours",),
        ),
        Claim(
            "table 2, scatter of variant 2",
            r"s(q_k)=u\sqrt n>0.088^\circ",
            below(RESOLUTION, least_scatter(2)),
            marks=("ours",),
        ),
        Claim(
            "largest scatter in a range",
            r"\textstyle\sum(q_k-\bar q)^2=n(M-\bar q)(\bar q-m)-\sum(M-q_k)(q_k-m),\ "
            r"(M-\bar q)(\bar q-m)\le\tfrac14(M-m)^2",
            Conjunction(
                (
                    Equality(
                        sp.Sum((q[index] - MEAN) ** 2, (index, 1, n)),
                        n * (highest - MEAN) * (MEAN - lowest)
                        - sp.Sum((highest - q[index]) * (q[index] - lowest), (index, 1, n)),
                    ),
                    Holds(sp.Ge((highest - lowest) ** 2 / 4, (highest - qbar) * (qbar - lowest))),
                )
            ),
            note="Readings between m and M have s <= (M - m)/2 sqrt(n/(n - 1)).",
            marks=("ours",),
        ),
        Claim(
            "table 2, scatter and one encoder",
            r"u\sqrt n>1.08^\circ\sqrt{n/(n-1)}",
            Conjunction(
                tuple(
                    below(largest_scatter(v, FULL_SCALE_LINEARITY), least_scatter(v))
                    for v in (1, 3, 4)
                )
            ),
            note="Errors within 0.3 % of 360 deg cannot scatter as much as variants 1, 3 and 4.",
            marks=("ours",),
        ),
        Claim(
            "table 2, scatter and two encoders",
            r"u\sqrt n>2.16^\circ\sqrt{n/(n-1)}\text{ in variant 1}",
            below(largest_scatter(1, 2 * FULL_SCALE_LINEARITY), least_scatter(1)),
            note="Not even the difference of two such encoders explains variant 1.",
            marks=("ours",),
        ),
    )


MEAN = sp.Sum(q[j], (j, 1, n)) / n

EQUATION_ROWS: tuple[Row, ...] = (
    Equation(
        "(1), first equals sign",
        r"\varphi_3'=\frac{\omega_3}{\omega_1}",
        Definition(ratio_symbol, omega3 / omega1),
        marks=("rebuilt",),
    ),
    Equation(
        "(1), second equals sign",
        r"\frac{\omega_3}{\omega_1}=\frac{v_D\cdot AC}{v_C\cdot DE}",
        Equality(VD * AC / (VC * DE), omega3 / omega1),
        note="v_C = omega1 AC and v_D = omega3 DE, all signed on the line A-C.",
        marks=("rebuilt",),
    ),
    Equation(
        "(1), third equals sign",
        r"\frac{v_D\cdot AC}{v_C\cdot DE}=\frac{BD\cdot AC}{BC\cdot DE}",
        Equality(BD * AC / (BC * DE), (sD - sB) / (sC - sB) * sC / sD),
        note="Velocities of the satellite are proportional to the distance from B, both BD and "
        "BC taken from B.",
        marks=("rebuilt",),
    ),
    Equation(
        "(2)",
        r"\rho(\varphi)=\frac{a(1-e^2)}{1-e\cos2\varphi}",
        Equality(print_radius(e, phi), focal_radius.subs(theta, 2 * phi)),
        note="The oval has at half the polar angle the focal radius of its ellipse.",
        marks=("rebuilt", "uncertain"),
    ),
    Claim(
        "(2), semi-axes",
        r"a(1-e)\le\rho\le a(1+e)",
        Conjunction((Holds(oval >= a * (1 - e)), Holds(oval <= a * (1 + e)))),
        marks=("ours",),
    ),
    Claim(
        "(2), convex",
        r"\rho^2+2\rho'^2-\rho\rho''\ge0",
        Holds(bend >= 0),
        note="The sign is that of 1 + 3 e cos(2 phi): beyond e = 1/3 the pitch curve has hollow "
        "flanks. The paper's e = 0.2 is convex.",
        holds_on=Part("e <= 1/3", {e: sp.Interval(0, sp.Rational(1, 3))}),
        marks=("ours",),
    ),
    Claim(
        "(2), convex up to 1/3",
        r"\rho^2+2\rho'^2-\rho\rho''<0\text{ at }\varphi=\tfrac\pi2,\ e>\tfrac13",
        Holds(bend.subs(phi, sp.pi / 2) < 0),
        on=Part("e > 1/3", {e: sp.Interval.open(sp.Rational(1, 3), 1)}),
        marks=("ours",),
    ),
    Equation(
        "(3)",
        r"BC=\rho_5=\frac{a(1-e_1^2)}{1-e_1\cos2\varphi_5}",
        Equality(print_radius(e1, phi5), focal_radius.subs({e: e1, theta: 2 * phi5})),
        marks=("rebuilt",),
    ),
    Equation(
        "(4)",
        r"CD=\rho_6=\frac{a(1-e_2^2)}{1-e_2\cos2\varphi_6}",
        Equality(print_radius(e2, phi6), focal_radius.subs({e: e2, theta: 2 * phi6})),
        marks=("rebuilt",),
    ),
    Equation(
        "(5)",
        r"\varphi_6=\int\frac{1-e_1^2}{1+e_1^2-2e_1\cos2\varphi_1}\,d\varphi_1",
        Equality(print_5, integrate(sun_radius / (2 * a - sun_radius))),
        note="Seen from the carrier: wheel 5 turns by rho4/rho5, the sun's major axis on the line "
        "of centres at the lower limit 0.",
        marks=(
            "rebuilt",
            "uncertain",
        ),
    ),
    Claim(
        "(5), constant",
        r"\rho_4(0)+\rho_5\left(\tfrac\pi2-c\right)-2a"
        r"=\frac{2ae_1(1-e_1)\sin^2c}{1+e_1\cos2c}",
        Equality(
            print_radius(e1, sp.S.Zero) + print_radius(e1, sp.pi / 2 - start) - 2 * a,
            2 * a * e1 * (1 - e1) * sp.sin(start) ** 2 / (1 + e1 * sp.cos(2 * start)),
        ),
        note="With (3), (6) and the axes 2a apart the lost constant of (5) is 0 (or half turns, "
        "which change no radius).",
        marks=("ours",),
    ),
    Claim(
        "(5), closed form",
        r"\varphi_6=\varphi_1+\mathrm{arctg}\frac{e_1\sin2\varphi_1}{1-e_1\cos2\varphi_1}",
        Equality(driven_angle(e1, phi1), print_5),
        note="Over any number of turns; tan(phi6) = (1 + e1)/(1 - e1) tan(phi1).",
        marks=("ours",),
    ),
    Claim(
        "(5), double angle",
        r"\cos2\varphi_6=\frac{(1+e^2)\cos2\varphi_1-2e}{1+e^2-2e\cos2\varphi_1},\ "
        r"\sin2\varphi_6=\frac{(1-e^2)\sin2\varphi_1}{1+e^2-2e\cos2\varphi_1}",
        Conjunction(
            tuple(
                Equality(one, two)
                for one, two in zip(roll_reduced(e, phi1), roll(e, phi1), strict=True)
            )
        ),
        marks=("ours",),
    ),
    Equation(
        "(6)",
        r"\varphi_5=\frac\pi2-\varphi_6",
        Equality(a * (1 - e1**2) / (1 + e1 * cos_6), 2 * a - sun_radius),
        note="With it (3) is the radius that meshes with the sun: cos(2 phi5) = -cos(2 phi6).",
        marks=(
            "rebuilt",
            "uncertain",
        ),
    ),
    Claim(
        "(6), sign",
        r"\rho_5\left(\tfrac\pi2-\varphi_6\right)=\rho_5\left(\tfrac\pi2+\varphi_6\right)",
        Equality(
            print_radius(e1, sp.pi / 2 - phi6), focal_radius.subs({e: e1, theta: sp.pi + 2 * phi6})
        ),
        note="Nothing depends on the sign that may be the bar of a fraction.",
        marks=("ours",),
    ),
    Equation(
        "(7)",
        r"BD=\rho_6-\rho_5",
        Equality(print_7, point_d - point_b),
        readings=(
            Reading(
                "the distance from D to B, BC from B to C", Equality(print_7, point_b - point_d)
            ),
        ),
        note="The order is legible; it reverses the sign of (10).",
        marks=("rebuilt",),
    ),
    Equation(
        "(8)",
        r"AC=EC=2a",
        Conjunction((Equality(2 * a, print_radius(e, phi) + mate), Equality(2 * a, point_c))),
        note="Two congruent ovals mesh at this distance in every position.",
        marks=("rebuilt",),
    ),
    Claim(
        "(8), rolling",
        r"\rho\,d\varphi=\rho_{mate}\,d\chi",
        Equality(print_radius(e, phi), mate * sp.diff(driven_angle(e, phi), phi)),
        note="The arcs are equal: congruent ovals roll without slip.",
        marks=("ours",),
    ),
    Equation("(9)", r"DE=2a-\rho_6", Equality(print_9, point_d), marks=("rebuilt",)),
    Claim(
        "two routes",
        r"\text{velocity plan}=\text{method of inversion}",
        Equality(ratio_by_plan, ratio_by_inversion),
        marks=("ours",),
    ),
    Equation(
        "(10)",
        r"\varphi_3'=\frac{(\rho_6-\rho_5)\,2a}{\rho_5\,(2a-\rho_6)}",
        Equality(print_10, ratio_by_plan),
        readings=(
            Reading(
                "the output's angle counted against the carrier's direction of rotation",
                Equality(print_10, -ratio_by_plan),
            ),
        ),
        marks=("rebuilt",),
    ),
    Equation(
        "(11)",
        r"\varphi_3(\varphi_1)=\int\varphi_3'\,d\varphi_1",
        Equality(print_11, position_of_one(E_SERIES)),
        readings=(
            Reading(
                "the output's angle counted against the carrier's direction of rotation",
                Equality(print_11, -position_of_one(E_SERIES)),
            ),
        ),
        note="From phi3(0) = 0, with (3)-(6); in closed form phi3 = -arctan(E sin(2 phi1)/"
        "(1 - E cos(2 phi1))), E = (e1 + e2)/(1 + e1 e2).",
        marks=("rebuilt",),
    ),
)

THEOREM_ROWS: tuple[Row, ...] = (
    Claim(
        "two eccentricities as one",
        r"\frac{1+E}{1-E}=\frac{1+e_1}{1-e_1}\cdot\frac{1+e_2}{1-e_2},\ "
        r"E=\frac{e_1+e_2}{1+e_1e_2}",
        Conjunction(
            (
                Equality(
                    (1 + E_SERIES) / (1 - E_SERIES),
                    (1 + e1) / (1 - e1) * (1 + e2) / (1 - e2),
                ),
                Equality(ratio_of_one(E_SERIES), 1 - wheel_3_rate.subs(mount, 0)),
            )
        ),
        note="Two oval pairs in series are one oval pair; eccentricities add like velocities.",
        marks=("ours",),
    ),
    Claim(
        "parallel wheels",
        r"\text{major axes of 5 and 6 parallel: }E=\frac{e_1-e_2}{1-e_1e_2}",
        Equality(1 - pair_ratio(E_ALIGNED, COS_4), 1 - wheel_3_rate.subs(mount, sp.pi / 2)),
        note="Equal ovals mounted so leave the output at rest: the right angle of (6) matters.",
        marks=("ours",),
    ),
    Claim(
        "mounted at any angle",
        r"\frac1{1-\varphi_3'}=\frac{\mu^2(1+\cos2\varphi_1)+2\mu\nu\sin2\varphi_1"
        r"+(\lambda^2+\nu^2)(1-\cos2\varphi_1)}{2\lambda\mu}",
        Equality(1 / (1 - ratio_of_map(*COEFFICIENTS)), 1 / wheel_3_rate),
        note="lambda = (1+e1)(1-e2^2), mu = (1-e1)(1+e2^2-2 e2 cos 2m), nu = 2(1+e1) e2 sin 2m: "
        "the pairs compose as tan(chi) = lambda t/(mu + nu t), t = tan(phi1); the ratio is not 1.",
        marks=("ours",),
    ),
    Claim(
        "coefficients without cancellation",
        r"\alpha,\beta,\gamma=\lambda,\mu,\nu;\ \delta=\alpha-\beta",
        Conjunction(
            tuple(
                Equality(kernel, coefficient)
                for kernel, coefficient in zip(
                    (alpha, beta, gamma, delta),
                    (*COEFFICIENTS, COEFFICIENTS[0] - COEFFICIENTS[1]),
                    strict=True,
                )
            )
        ),
        marks=("ours",),
    ),
    Claim(
        "coefficients split",
        r"\alpha=(1-e_2)\lambda,\ \beta=(1-e_2)\mu,\ \gamma=(1-e_2)\nu,\ "
        r"\mu-\xi=(1-e_1)(1-e_2),\ \lambda-\mu+\xi=2(e_1+e_2)",
        Conjunction(
            (
                *(
                    Equality((1 - e2) * part, coefficient)
                    for part, coefficient in (
                        (both, alpha),
                        (less + shift, beta),
                        (rise, gamma),
                        (swing - shift, delta),
                    )
                ),
                Equality(both - less, swing),
                Equality(shift + rise * t, y),
            )
        ),
        note="A common factor of the coefficients cancels: so the kernels use lambda = both, "
        "nu = rise, xi = shift.",
        marks=("ours",),
    ),
    Claim(
        "position, any mount",
        r"\int_0^{\varphi_1}\varphi_3'\,d\varphi_1\text{ as two arguments}",
        Equality(position_by_one_pair, integrate(ratio_of_map(lam, mu, nu))),
        marks=("ours",),
    ),
    Claim(
        "position, any mount, one argument",
        r"\varphi_3=\mathrm{atan2}(\nu(1-\cos2\varphi_1)-(\lambda-\mu)\sin2\varphi_1,\ "
        r"\lambda+\mu+(\mu-\lambda)\cos2\varphi_1+\nu\sin2\varphi_1)",
        Equality(position_of_map(lam, mu, nu, lam - mu), position_by_one_pair),
        note="The output never leaves (-pi, pi): two oval pairs only swing it.",
        marks=("ours",),
    ),
    Claim(
        "position by the tangent",
        r"\varphi_3=\mathrm{atan2}(t(y-\lambda+\mu-\xi),\ \mu-\xi+y+\lambda t^2),\ "
        r"y=\xi+\nu t,\ t=\mathrm{tg}\,\varphi_1",
        Equality(
            POSITION_FORM.subs(ANY_MAP).subs(t, tangent),
            position_of_map(lam, mu, nu, lam - mu).subs(
                {
                    sp.cos(2 * phi1): (1 - tangent**2) / (1 + tangent**2),
                    sp.sin(2 * phi1): 2 * tangent / (1 + tangent**2),
                }
            ),
        ),
        note="The double angle is written by the tangent.",
        marks=("ours",),
    ),
    Claim(
        "ratio by the tangent",
        r"\varphi_3'=1-\frac{\lambda\mu(1+t^2)}{(\mu-\xi+y)^2+\lambda^2t^2},\ "
        r"y=\xi+\nu t,\ t=\mathrm{tg}\,\varphi_1",
        Equality(RATIO_FORM.subs(ANY_MAP), ratio_of_map(lam, mu, nu)),
        marks=("ours",),
    ),
    Claim(
        "acceleration by the tangent",
        r"\varphi_3''=2\lambda\mu(1+t^2)\frac{y(\nu-\xi t)+(\mu-\xi)\nu(1-t^2)"
        r"+(\lambda^2-\mu^2+\xi^2)t}{((\mu-\xi+y)^2+\lambda^2t^2)^2},\ y=\xi+\nu t",
        Equality(ACCELERATION_FORM.subs(ANY_MAP), sp.diff(ratio_of_map(lam, mu, nu), phi1)),
        marks=("ours",),
    ),
    Claim(
        "drift, oval pairs",
        r"\varphi_3(\varphi_1+\pi)=\varphi_3(\varphi_1)",
        advances(position_of_map(lam, mu, nu, lam - mu), sp.pi, sp.S.Zero),
        note="For all eccentricities and mountings: no mean drift.",
        marks=("ours",),
    ),
    Claim(
        "amplitude",
        r"|\sin\varphi_3|\le E,\ \varphi_3=-\arcsin E\text{ at }\cos2\varphi_1=E",
        Conjunction(
            (
                Holds(e**2 - e**2 * sp.sin(theta) ** 2 / (1 + e**2 - 2 * e * sp.cos(theta)) >= 0),
                Equality(sp.atan2(e * sp.sqrt(1 - e**2), 1 - e**2), sp.asin(e)),
            )
        ),
        note="sin(phi3)^2 = E^2 sin(x)^2/(1 + E^2 - 2 E cos(x)); E written e.",
        marks=("ours",),
    ),
    Claim(
        "reciprocating, oval pairs",
        r"0<E<1:\ \varphi_3'(0)<0<\varphi_3'(\tfrac\pi2)",
        Conjunction(
            (
                Holds(ratio_of_one(e).subs(phi1, 0) < 0),
                Holds(ratio_of_one(e).subs(phi1, sp.pi / 2) > 0),
            )
        ),
        note="With no drift: two oval pairs always reciprocate unless E = 0, when they rest.",
        on=Part("0 < e < 1", {e: OVAL}),
        marks=("ours",),
    ),
    Claim(
        "special case, radii",
        r"\varphi_3'=1-\frac{R_4}{R_5}\cdot\frac{1-e_2^2}{1+e_2^2-2e_2\cos x},\ "
        r"x=2\tfrac{R_4}{R_5}\varphi_1",
        Equality(ratio_45, ratio_with_cylinders_45),
        note="The radii of pair 4-5 replaced by numbers in (10), its sign as in the mechanics, "
        "and wheel 6 turned by (R4/R5) phi1.",
        marks=("inferred",),
    ),
    Claim(
        "position, cylindrical pair 4-5",
        r"\varphi_3=\left(1-\tfrac{R_4}{R_5}\right)\varphi_1"
        r"-\mathrm{arctg}\frac{e_2\sin x}{1-e_2\cos x}",
        Equality(position_45, integrate(ratio_with_cylinders_45)),
        marks=("ours",),
    ),
    Claim(
        "position, cylindrical pair 3-6",
        r"\varphi_3=\left(1-\tfrac{R_6}{R_3}\right)\varphi_1"
        r"-\tfrac{R_6}{R_3}\mathrm{arctg}\frac{e_1\sin2\varphi_1}{1-e_1\cos2\varphi_1}",
        Equality(position_36, integrate(ratio_with_cylinders_36)),
        marks=("ours",),
    ),
    Claim(
        "drift, cylindrical pair 4-5",
        r"\varphi_3(\varphi_1+\pi\tfrac{R_5}{R_4})-\varphi_3(\varphi_1)"
        r"=\pi\left(\tfrac{R_5}{R_4}-1\right)",
        advances(position_45, sp.pi * R5 / R4, sp.pi * (R5 / R4 - 1)),
        note="The mean ratio is 1 - R4/R5, no drift only for R4 = R5.",
        marks=("ours",),
    ),
    Claim(
        "extremes, cylindrical pair 4-5",
        r"1-\tfrac{R_4}{R_5}\tfrac{1+e_2}{1-e_2}\le\varphi_3'"
        r"\le1-\tfrac{R_4}{R_5}\tfrac{1-e_2}{1+e_2}",
        Conjunction((Holds(1 - fastest <= ratio_45), Holds(1 - slowest >= ratio_45))),
        note="Reached at x = 0 and x = pi.",
        marks=("ours",),
    ),
    Claim(
        "one-way, against the carrier",
        r"\tfrac{R_4}{R_5}>\tfrac{1+e_2}{1-e_2}\Rightarrow\varphi_3'<0",
        Holds(ratio_45 < 0),
        on=FASTER,
        marks=("ours",),
    ),
    Claim(
        "one-way, with the carrier",
        r"\tfrac{R_4}{R_5}<\tfrac{1-e_2}{1+e_2}\Rightarrow\varphi_3'>0",
        Holds(ratio_45 > 0),
        on=SLOWER,
        marks=("ours",),
    ),
    Claim(
        "both ways, forward",
        r"\tfrac{R_4}{R_5}<\tfrac{1+e_2}{1-e_2}\Rightarrow\max\varphi_3'>0",
        Holds(1 - slowest > 0),
        on=BELOW_UPPER,
        marks=("ours",),
    ),
    Claim(
        "both ways, backward",
        r"\tfrac{R_4}{R_5}>\tfrac{1-e_2}{1+e_2}\Rightarrow\min\varphi_3'<0",
        Holds(1 - fastest < 0),
        note="Between both limits the output reverses: reciprocating for R4 = R5, else with drift.",
        on=ABOVE_LOWER,
        marks=("ours",),
    ),
    Claim(
        "intermittent, against the carrier",
        r"\tfrac{R_4}{R_5}=\tfrac{1+e_2}{1-e_2}\Rightarrow"
        r"\varphi_3'=-\frac{2e_2(1+\cos x)}{1+e_2^2-2e_2\cos x}\le0",
        Conjunction(
            (
                Equality(
                    limit_ratio,
                    -2 * e2 * (1 + sp.cos(theta)) / (1 + e2**2 - 2 * e2 * sp.cos(theta)),
                ),
                Holds(limit_ratio <= 0),
                Holds(sp.diff(limit_ratio, theta, 2).subs(theta, sp.pi) < 0),
            )
        ),
        note="A double zero at x = pi. The ratio is analytic and vanishes on no interval: a dwell "
        "is a double zero.",
        on=PROPER_45,
        marks=("ours",),
    ),
    Claim(
        "intermittent, with the carrier",
        r"\tfrac{R_4}{R_5}=\tfrac{1-e_2}{1+e_2}\Rightarrow"
        r"\varphi_3'=\frac{2e_2(1-\cos x)}{1+e_2^2-2e_2\cos x}\ge0",
        Conjunction(
            (
                Equality(
                    1 - (1 - e2) / (1 + e2) * pair_ratio(e2, sp.cos(theta)),
                    2 * e2 * (1 - sp.cos(theta)) / (1 + e2**2 - 2 * e2 * sp.cos(theta)),
                ),
                Holds(1 - (1 - e2) / (1 + e2) * pair_ratio(e2, sp.cos(theta)) >= 0),
            )
        ),
        note="A double zero at x = 0.",
        on=PROPER_45,
        marks=("ours",),
    ),
    Claim(
        "width of a dwell",
        r"|\varphi_3'|\le\eta\iff|x-\pi|\le2\,\mathrm{arctg}\,T,\ "
        r"T^2=\frac{\eta(1+e_2)^2}{4e_2-\eta(1-e_2)^2}",
        Conjunction(
            (
                Equality(ratio_beside.subs(width, edge), -eta),
                Holds(sp.diff(ratio_beside, width) < 0),
            )
        ),
        note="For R4/R5 = (1+e2)/(1-e2), where the ratio falls on both sides of x = pi; in the "
        "carrier's angle the dwell is 2 (R5/R4) arctan(T) wide.",
        on=REACHED,
        marks=("ours",),
    ),
)

VARIANT_ROWS: tuple[Row, ...] = (
    Claim(
        "centre distance of the variants",
        r"R_4+R_5=50\text{ mm in variants 2, 3 and 4}",
        Conjunction(
            tuple(
                Holds(sp.Eq(sum(CYLINDERS_45[v]), sum(CYLINDERS_45[2]), evaluate=False))
                for v in (3, 4)
            )
        ),
        note="With (8) a = 25 mm, which the paper does not print.",
        marks=("inferred",),
    ),
    Claim(
        "variant 1, reciprocating",
        r"\text{variant 1 gives reciprocating rotation of the output shaft}",
        Conjunction(
            (
                Equality(position_1, integrate(1 - wheel_3_rate.subs(mount, 0)).subs(ovals)),
                advances(position_1, sp.pi, sp.S.Zero),
                *reverses(ratio_1, sp.S.Zero, sp.pi / 2),
            )
        ),
        note="E = 5/13: the output swings by 2 arcsin(5/13), twice for each turn of the carrier.",
    ),
    Claim(
        "variant 2, reciprocating",
        r"\text{variant 2 gives reciprocating rotation of the output shaft}",
        Conjunction(
            (
                advances(with_cylinders(position_45, 2), sp.pi, sp.S.Zero),
                *reverses(with_cylinders(ratio_45, 2), sp.S.Zero, sp.pi / 2),
            )
        ),
        note="R4 = R5: no drift; the amplitude is arcsin(0.2).",
    ),
    Claim(
        "variant 3, intermittent",
        r"\text{variant 3 gives intermittent rotation of the output shaft}",
        Conjunction(
            (
                Holds(with_cylinders(ratio_45, 3) <= 0),
                Equality(with_cylinders(ratio_45, 3).subs(phi1, DWELL_3), sp.S.Zero),
                below(sp.diff(with_cylinders(ratio_45, 3), phi1, 2).subs(phi1, DWELL_3), sp.S.Zero),
                advances(with_cylinders(position_45, 3), 2 * DWELL_3, -DWELL_3),
            )
        ),
        note="30/20 = (1 + 0.2)/(1 - 0.2) exactly: a double zero at every odd multiple of pi/3.",
    ),
    Claim(
        "variant 4, one-way",
        r"\text{variant 4 gives one-way non-uniform rotation}",
        Conjunction(
            (
                Holds(with_cylinders(ratio_45, 4) < 0),
                Distinct(with_cylinders(ratio_45, 4), with_cylinders(ratio_45, 4).subs(phi1, 0)),
            )
        ),
        note="32/18 > 3/2; the output turns against the carrier.",
    ),
    Claim(
        "special case, angle of wheel 6",
        r"\text{the output of variant 3 rests three times in a turn of the carrier}",
        Completions(
            Completion(
                "wheel 6 turned by (R4/R5) phi1: rest at phi1 = pi/3",
                Equality(
                    with_radii(3, R4 / R5 * phi1).subs({R4: 3, R5: 2, phi1: DWELL_3}), sp.S.Zero
                ),
            ),
            Completion(
                "wheel 6 turned as in (5) with e1 = 0, by phi1: rest at phi1 = pi/3",
                Equality(with_radii(3, phi1).subs(phi1, DWELL_3), sp.S.Zero),
            ),
        ),
        note="Nothing is said of (5) for cylindrical wheels.",
    ),
    Claim(
        "special case, kinds of motion",
        r"\text{the kinds of variants 3 and 4 do not depend on how fast wheel 6 turns}",
        Conjunction((Holds(with_radii(3, phi6) <= 0), Holds(with_radii(4, phi6) < 0))),
        note="For every angle of wheel 6 the sign is that of rho5 - rho6.",
        marks=("ours",),
    ),
    Claim(
        "position functions of Fig. 2",
        r"\text{with formula (11) the position functions were built}",
        Equality(
            integrate(
                print_10.subs(AXES_45).subs(
                    rho6, oval_radius(e2, sp.cos(2 * R4 / R5 * phi1)).subs(AXES_45)
                )
            ),
            position_45,
        ),
        readings=(
            Reading(
                "the output's angle counted against the carrier's direction of rotation",
                Equality(
                    integrate(
                        print_10.subs(AXES_45).subs(
                            rho6, oval_radius(e2, sp.cos(2 * R4 / R5 * phi1)).subs(AXES_45)
                        )
                    ),
                    -position_45,
                ),
            ),
        ),
        note="Of the figure only the axes in rad survive; stated for a cylindrical pair 4-5.",
        marks=("inferred",),
    ),
    Claim(
        "Fig. 5, tick labels",
        r"\varphi_3:\ 50^\circ",
        Completions(
            Completion(
                "the figure shows variant 1: its whole swing is within 50 deg",
                below(2 * sp.asin(E_SERIES.subs(ovals)), 50 * sp.pi / 180),
            ),
            Completion(
                "the figure shows variant 4: its advance in one turn is within 50 deg",
                below(2 * sp.pi * (sp.Rational(32, 18) - 1), 50 * sp.pi / 180),
            ),
        ),
        note="The labels 50, 20 and four times 240 are not attributed to a variant any more.",
    ),
    Claim(
        "fixed axes",
        r"\text{mechanisms with non-circular wheels on fixed axes give only one-way rotation}",
        Holds(-rho3 / (span - rho3) < 0),
        note="Any pitch curves with 0 < rho < L; a train of pairs is a product of such factors.",
        on=Part("the radius is shorter than the distance of the axes", where=(rho3 < span,)),
    ),
    Claim(
        "fixed axes, non-uniform",
        r"\text{the rotation on fixed axes is non-uniform}",
        Holds(pair_ratio(e, sp.S.One) - pair_ratio(e, -sp.S.One) > 0),
        on=Part("0 < e < 1", {e: OVAL}),
    ),
    Claim(
        "conclusion 2, acceleration",
        r"\text{the model gave the analogue of acceleration}",
        Conjunction(
            (
                Equality(
                    sp.diff(ratio_of_one(e), phi1),
                    4 * e * (1 - e**2) * sp.sin(2 * phi1) / (1 + e**2 - 2 * e * COS_4) ** 2,
                ),
                Equality(
                    sp.diff(ratio_with_cylinders_45, phi1), ACCELERATION_CYLINDRICAL.subs(explicit)
                ),
            )
        ),
        note="None is printed; the model determines it, here for two oval pairs (E written e) and "
        "for a cylindrical pair 4-5.",
        marks=("ours",),
    ),
)

MEASUREMENT_ROWS: tuple[Row, ...] = (
    Equation(
        "(12)",
        r"\bar q=\frac1n\sum_{k=1}^n q_k",
        Definition(qbar, sp.Sum(q[index], (index, 1, n)) / n),
        marks=("rebuilt",),
    ),
    Equation(
        "(13)",
        r"s^2(q_k)=\frac1{n-1}\sum_{k=1}^n(q_k-\bar q)^2",
        Definition(s2, sp.Sum((q[index] - qbar) ** 2, (index, 1, n)) / (n - 1)),
        note="Needs n >= 2.",
        marks=("rebuilt",),
    ),
    Claim(
        "(13) is free of bias",
        r"E\,s^2(q_k)=\sigma^2",
        Equality(
            sp.Sum(
                (sp.KroneckerDelta(i, j) - 1 / n)
                * (sp.KroneckerDelta(i, m) - 1 / n)
                * sigma2
                * sp.KroneckerDelta(j, m),
                (i, 1, n),
                (j, 1, n),
                (m, 1, n),
            ),
            (n - 1) * sigma2,
        ),
        note="For independent observations of one variance; the reason for n - 1.",
        marks=("ours",),
    ),
    Equation(
        "(14)",
        r"s^2(q)=s^2(q_k)/n",
        Equality(
            sigma2 / n,
            sp.Sum(sigma2 * sp.KroneckerDelta(i, j) / n**2, (i, 1, n), (j, 1, n)),
        ),
        note="The variance of the mean of n independent observations.",
        marks=("rebuilt",),
    ),
    Equation(
        "(15)",
        r"u(q)=\sqrt{s^2(q)}",
        Definition(u_mean, sp.sqrt(s2_mean)),
        note="The right-hand side is lost; by its name the type A standard uncertainty.",
        marks=("rebuilt", "inferred"),
    ),
    Claim(
        "table 1, resolution",
        r"360^\circ/4096\approx0.088^\circ",
        PrintedNumber("0.088", RESOLUTION),
        note="A 12-bit encoder is inferred.",
        marks=("inferred",),
    ),
    Claim(
        "table 1, linearity",
        r"\text{linearity }0.3\,\%",
        Completions(
            Completion(
                "0.3 % of the full scale of 360 deg bounds the mean errors of variants 1, 2 and 4",
                means_below(dict.fromkeys((1, 2, 4), FULL_SCALE_LINEARITY)),
            ),
            Completion(
                "0.3 % of a reading of 90 deg bounds the mean errors of variants 1, 2 and 4",
                means_below(dict.fromkeys((1, 2, 4), READING_LINEARITY)),
            ),
        ),
        note="Not said of what the percentage is taken; as full scale it is 1.08 deg.",
    ),
    Claim(
        "table 1, read time",
        r"0.6\text{ ms}",
        Definition(read_time, sp.Rational("0.0006")),
        note="A datum; no formula of the paper uses it.",
    ),
    Claim(
        "table 1, output",
        r"0\dots5\text{ V}",
        Definition(output, sp.S(5)),
        note="A datum; no formula of the paper uses it.",
    ),
    Claim(
        "table 1, diameter",
        r"22\text{ mm}",
        Definition(diameter, 22 * millimetre),
        note="A datum; no formula of the paper uses it.",
    ),
    *(interval_row(variant) for variant in READINGS),
    *(coverage_row(variant) for variant in READINGS),
    *scatter_rows(),
    Claim(
        "measured functions adequate",
        r"\text{the measured functions of all variants are adequate to the model}",
        Completions(
            Completion(
                "adequate: the 95 % interval of the mean error contains 0, all variants",
                means_below({v: 2 * UNCERTAINTIES[v] for v in READINGS}),
            ),
            Completion(
                "adequate: the mean error stays inside 0.3 % of 360 deg of two encoders",
                means_below(dict.fromkeys(READINGS, 2 * FULL_SCALE_LINEARITY)),
            ),
        ),
        note="No criterion and no readings are printed; variants 1, 3 and 4 fail the first one.",
    ),
    Claim(
        "largest mean errors",
        r"\text{the mean errors of variants 1 and 3 are the large ones}",
        Conjunction(
            tuple(
                below(abs(MEANS[small]), abs(MEANS[large])) for small in (2, 4) for large in (1, 3)
            )
        ),
    ),
    Claim(
        "inaccurate manufacture",
        r"\text{the large mean error of variants 1 and 3 may point to inaccurate manufacture}",
        Completions(
            Completion(
                "linearity of a reading of 90 deg: both mean errors exceed it",
                Conjunction(tuple(below(READING_LINEARITY, abs(MEANS[v])) for v in (1, 3))),
            ),
            Completion(
                "linearity of the full scale of two encoders: both mean errors exceed it",
                Conjunction(tuple(below(2 * FULL_SCALE_LINEARITY, abs(MEANS[v])) for v in (1, 3))),
            ),
        ),
        note="The encoders alone may explain the mean errors, or may not.",
    ),
)

# The kernels ----------------------------------------------------------------------------------

CARRIER = Argument("phi1", (phi1,), "carrier angle, any number of turns", "rad")
OF_OVALS = (
    CARRIER,
    Argument("e1", (e1,), "eccentricity of the oval pair 4-5"),
    Argument("e2", (e2,), "eccentricity of the oval pair 6-3"),
    Argument(
        "mount",
        (mount,),
        "turn of wheel 6 on its shaft, forward from its place in the paper",
        "rad",
        0.0,
    ),
)
OF_CYLINDERS = (
    CARRIER,
    Argument("R4", (R4,), "radius of the cylindrical sun 4", "mm"),
    Argument("R5", (R5,), "radius of the cylindrical wheel 5", "mm"),
    Argument("e2", (e2,), "eccentricity of the oval pair 6-3"),
)

# Bars of the oval pairs. The terms of y = shift + rise*t are rounded, and where they cancel the
# value makes of that what no evaluation from a rounded tangent is spared: up to 1/(1 - e2), where
# the major axes of the pair 6-3 meet away from phi1 = 0. So the scales are the largest term, and
# added to it what the value makes of y with its terms changed against each other, 0 without a
# mount. The rest is some 20 operations; all of them in one direction would make twice the bars,
# which are what searches for the worst input hold.
# All of it is multiplied by (1 - e2)*cos(phi1), so that nothing is divided, and the coefficients
# stand in full: to put them into absolute values later takes SymPy very long.
GIVEN = {v.symbol: v.given for v in VARIABLES if v.given is not None}
ALPHA, BETA, GAMMA, DELTA = (GIVEN[symbol] for symbol in (alpha, beta, gamma, delta))
LEVER = 4 * e2 * sp.sin(mount)
SIDE_6 = (1 - e1) * sp.cos(phi1), (1 + e1) * sp.sin(phi1)
LESS = (1 - e1) * (1 - e2) ** 2
TURNED = LEVER * (sp.sin(mount) * SIDE_6[0] + sp.cos(mount) * SIDE_6[1])
CHANGE = LEVER * (sp.cos(mount) * SIDE_6[1] - sp.sin(mount) * SIDE_6[0]) / 2
SLOPE_OF_TURNED = sp.diff(TURNED, phi1)
CHANGE_OF_SLOPE = sp.diff(CHANGE, phi1)
ALONG = LESS * sp.cos(phi1) + TURNED
SPREAD = ALONG**2 + (ALPHA * sp.sin(phi1)) ** 2
TILT_TERMS = (
    TURNED * SLOPE_OF_TURNED,
    LESS * GAMMA * sp.cos(2 * phi1),
    4 * (e1 + e2) * (1 + e1 * e2) * (1 - e2) ** 2 * sp.sin(phi1) * sp.cos(phi1),
    -LESS * (1 - e1) * LEVER * sp.sin(mount) * sp.sin(2 * phi1),
)


def largest(*terms: sp.Expr) -> sp.Expr:
    """Return the largest absolute value; unevaluated, for SymPy would compare them as symbols."""
    return sp.Max(*map(size, terms), evaluate=False)


def size(term: sp.Expr) -> sp.Expr:
    """Return the absolute value, unevaluated."""
    return sp.Abs(term, evaluate=False)


WHEEL_3 = ALPHA * BETA / SPREAD
RATIO_SCALE = largest(sp.S.One, WHEEL_3) + size(2 * WHEEL_3 / SPREAD * ALONG * CHANGE)
ACROSS_TERMS = TURNED, 2 * (e1 + e2) * (1 - e2) * sp.cos(phi1)
POSITION_SCALE = largest(
    position_of_map(ALPHA, BETA, GAMMA, DELTA),
    *(sp.sin(phi1) * term / sp.sqrt(SPREAD) for term in ACROSS_TERMS),
) + size(ALPHA * sp.sin(phi1) * CHANGE / SPREAD)
OF_CHANGE = (SLOPE_OF_TURNED * SPREAD - 4 * ALONG * sum(TILT_TERMS)) / SPREAD
ACCELERATION_SCALE = (
    2
    * WHEEL_3
    / SPREAD
    * (
        largest(
            sum(TILT_TERMS),
            TILT_TERMS[0],
            LESS * GAMMA,
            *TILT_TERMS[2:],
            TURNED * CHANGE_OF_SLOPE,
        )
        + size(OF_CHANGE * CHANGE)
    )
)
RATIO_ULP = 8
POSITION_ULP = 4
# At its peak the acceleration goes with the cube of (1 - e1)*(1 - e2), three roundings where both
# eccentricities are below 1/2: 4 eps that the rest of the product saves. Beside a mounted wheel two
# terms of like size meet, each with roundings of its own: searches find 8.6 of the larger one, and
# 6.3 where wheel 6 is mounted as in the paper.
ACCELERATION_ULP = 10

# Bars of a cylindrical pair 4-5. With the low word, x is known to eps**2 relative, and what is left
# are the roundings of some 20 operations, tan and atan within an ulp; the bars are what searches
# for the worst input hold. What the error of x itself makes, eps**2*|x| times the slope, counts
# where the acceleration passes through zero, and beside it only far away near e2 = 1. The slope of
# the acceleration has the envelope of |sin x|, |cos x| <= 1.
WHERE_LOW_WORD = ", where |x| <= 2**26"
SLOPE = 4 * e2 * k**2 * (1 - e2**2) / (1 + e2**2 - 2 * e2 * sp.cos(x)) ** 2
EPS_X = sp.Rational(1, 2**52) * sp.Abs(x)
RATIO_CYLINDRICAL_SCALE = largest(sp.S.One, 1 - RATIO_CYLINDRICAL) + EPS_X * size(
    sp.diff(RATIO_CYLINDRICAL, x)
)
lead_6 = sp.atan2(e2 * sp.sin(x), 1 - e2 * sp.cos(x))
POSITION_CYLINDRICAL_SCALE = largest((R5 - R4) / R5 * phi1, lead_6) + EPS_X * size(
    sp.diff(lead_6, x)
)
ACCELERATION_CYLINDRICAL_SCALE = sp.Abs(ACCELERATION_CYLINDRICAL) + EPS_X * SLOPE
RATIO_CYLINDRICAL_ULP = ACCELERATION_CYLINDRICAL_ULP = 8
POSITION_CYLINDRICAL_ULP = 4

# Without it x = 2*k*phi1 is off by two roundings, eps*|x|. The slope of the arctangent in x lies
# between -e2/(1 + e2) and e2/(1 - e2), so the plain product costs at most 2*k*e2/(1 - e2) eps of
# |phi1|. Where k*e2/(1 - e2) <= |1 - k| that is half the bar, whatever phi1. The ratio and the
# acceleration lose some |x|*e2/(1 - e2) eps, however small the eccentricity: they have no such
# threshold but e2 = 0.
PLAIN_PRODUCT = R4 * e2 <= sp.Abs(R5 - R4) * (1 - e2)

SOURCE = "Prikhodko et al. 2024 (oval wheels)"

QUANTITIES = (
    Quantity(
        "ratio",
        "Compute the transmission ratio d phi3/d phi1 of the output wheel to the carrier.",
        OF_OVALS,
        RATIO,
        Form("quotient in tan(phi1)", RATIO_FORM, proved_by="ratio by the tangent"),
        f"{SOURCE}, equation (10)",
        bar=Bar(
            RATIO_ULP,
            "the larger of 1 and W = 1 - value, + W*|(less + y)*(rise*t - shift)|/S (0 without a "
            "mount), S = (less + y)**2 + both**2*t**2, t = tan(phi1), y = shift + rise*t, both = "
            "alpha/(1 - e2), less = (1 - e1)*(1 - e2), rise = gamma/(1 - e2), shift = "
            "beta/(1 - e2) - less",
            RATIO_SCALE,
        ),
    ),
    Quantity(
        "position",
        "Compute the position function phi3(phi1) of the output wheel, phi3(0) = 0.",
        OF_OVALS,
        POSITION,
        Form("one arctangent of tan(phi1)", POSITION_FORM, proved_by="position by the tangent"),
        f"{SOURCE}, integral (11)",
        unit="rad",
        bar=Bar(
            POSITION_ULP,
            "the largest of |value|, |y*sin(phi1)|/R and 2*(e1 + e2)*|sin(phi1)|/R, R = sqrt(S), + "
            "|both*t*(rise*t - shift)|/(2*S) (|value| without a mount), with t, S, y, both, less, "
            "rise, shift as in `ratio`, where no product underflows",
            POSITION_SCALE,
        ),
    ),
    Quantity(
        "acceleration",
        "Compute d ratio/d phi1, the angular acceleration of the output at unit carrier speed.",
        OF_OVALS,
        ACCELERATION,
        Form(
            "quotient in tan(phi1)",
            ACCELERATION_FORM,
            ("low_product",),
            proved_by="acceleration by the tangent",
        ),
        f"{SOURCE}, derivative of (10)",
        bar=Bar(
            ACCELERATION_ULP,
            "the largest of |value| and 2*W/S times |y*(rise - shift*t)|, less*|rise|*(1 + t**2), "
            "2*(e1 + e2)*(less + both)*|t|, 2*less*shift*|t|, |y*(rise + shift*t)|/2, + W/S*|(rise "
            "- shift*t - 4*(less + y)*Z/S)*(rise*t - shift)|, Z = value*S/(2*W) (|value| without "
            "a mount), with W, S, t, y, both, less, rise, shift as in `ratio`, where no product "
            "underflows",
            ACCELERATION_SCALE,
        ),
    ),
    Quantity(
        "ratio_cylindrical",
        "Compute the ratio d phi3/d phi1 with a cylindrical pair 4-5.",
        OF_CYLINDERS,
        RATIO_CYLINDRICAL,
        Form(
            "half-angle quotient with low word",
            RATIO_CYLINDRICAL,
            ("low_word", "half_angle_tangent"),
        ),
        f"{SOURCE}, equation (10), pair 4-5 cylindrical",
        bar=Bar(
            RATIO_CYLINDRICAL_ULP,
            "the larger of 1 and 1 - value, + eps*|x*d value/d x|" + WHERE_LOW_WORD,
            RATIO_CYLINDRICAL_SCALE,
        ),
    ),
    Quantity(
        "position_cylindrical",
        "Compute the position function phi3(phi1) with a cylindrical pair 4-5, phi3(0) = 0.",
        OF_CYLINDERS,
        POSITION_CYLINDRICAL,
        Form(
            "half-angle atan with low word",
            POSITION_CYLINDRICAL,
            ("positive_atan2", "low_word", "half_angle_tangent"),
        ),
        f"{SOURCE}, integral (11), pair 4-5 cylindrical",
        unit="rad",
        bar=Bar(
            POSITION_CYLINDRICAL_ULP,
            "the larger of both terms + eps*|x| times the slope of the second in x"
            + WHERE_LOW_WORD,
            POSITION_CYLINDRICAL_SCALE,
        ),
        shortcut=Shortcut(
            Form("half-angle atan", POSITION_CYLINDRICAL, ("positive_atan2", "half_angle_tangent")),
            PLAIN_PRODUCT,
        ),
    ),
    Quantity(
        "acceleration_cylindrical",
        "Compute d ratio/d phi1 with a cylindrical pair 4-5.",
        OF_CYLINDERS,
        ACCELERATION_CYLINDRICAL,
        Form(
            "half-angle quotient with low word",
            ACCELERATION_CYLINDRICAL,
            ("low_word", "half_angle_tangent"),
        ),
        f"{SOURCE}, derivative of (10), pair 4-5 cylindrical",
        bar=Bar(
            ACCELERATION_CYLINDRICAL_ULP,
            "|value| + eps*|x|*4*e2*k**2*(1 - e2**2)/(1 + e2**2 - 2*e2*cos(x))**2" + WHERE_LOW_WORD,
            ACCELERATION_CYLINDRICAL_SCALE,
        ),
    ),
)

PAPER = Paper(
    system="oval_planetary",
    citation=(
        "Prikhodko, Kurapov, Belina, Azizov, Polivoda 2024, planetary mechanism with oval "
        "wheels, EDN HZWKZJ"
    ),
    variables=VARIABLES,
    rows=EQUATION_ROWS + THEOREM_ROWS + VARIANT_ROWS + MEASUREMENT_ROWS,
    quantities=QUANTITIES,
    conventions=(
        "Angles in radians, positive in the direction of the carrier's rotation; lengths in mm. "
        "The paper's (10) has the opposite sign."
    ),
)
