"""What paper 2 prints, row by row, and what is found beside it."""

from __future__ import annotations

import sympy as sp

from mechproof.record import (
    Claim,
    Completion,
    Completions,
    Conjunction,
    Definition,
    Distinct,
    Equality,
    Equation,
    Holds,
    Part,
    PrintedNumber,
    Reading,
    Row,
)

from .._metrology import (
    FULL_SCALE_LINEARITY,
    READING_LINEARITY,
    RESOLUTION,
    coverage_row,
    encoder_rows,
    j,
    linearity_row,
    mean_row,
    n,
    q,
    qbar,
    resolution_row,
    unbiased_row,
    uncertainty_row,
    variance_of_mean_row,
    variance_row,
)
from .._relations import less
from .paper import (
    ABOVE_LOWER,
    AC,
    ACCELERATION_CYLINDRICAL,
    AXES_45,
    BC,
    BD,
    BELOW_UPPER,
    COEFFICIENTS,
    COS_4,
    DE,
    E_ALIGNED,
    E_SERIES,
    FASTER,
    OVAL,
    PROPER_45,
    R4,
    R5,
    REACHED,
    SLOWER,
    VARIANTS,
    VC,
    VD,
    a,
    alpha,
    beta,
    cos_6,
    delta,
    driven_angle,
    e,
    e1,
    e2,
    edge,
    eta,
    explicit,
    fastest,
    focal_radius,
    gamma,
    highest,
    index,
    integrate,
    lam,
    limit_ratio,
    lowest,
    mount,
    mu,
    nu,
    omega1,
    omega3,
    oval_radius,
    pair_ratio,
    phi,
    phi1,
    phi5,
    phi6,
    point_b,
    point_c,
    point_d,
    position_36,
    position_45,
    position_by_one_pair,
    position_of_map,
    position_of_one,
    ratio_45,
    ratio_beside,
    ratio_by_inversion,
    ratio_by_plan,
    ratio_of_map,
    ratio_of_one,
    ratio_symbol,
    ratio_with_cylinders_36,
    ratio_with_cylinders_45,
    rho3,
    rho5,
    rho6,
    roll,
    roll_reduced,
    sB,
    sC,
    sD,
    slowest,
    span,
    start,
    sun_radius,
    tau,
    theta,
    wheel_3_rate,
    width,
)

# n, mean error, u, printed half-width, all but n in degrees.
READINGS = {
    1: (175, "0.777", "0.18", "0.360"),
    2: (190, "0.035", "0.04", "0.080"),
    3: (214, "1.280", "0.11", "0.220"),
    4: (193, "-0.540", "0.15", "0.300"),
}


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
    return expression.subs(VARIANTS[variant])


def with_radii(variant: int, angle_of_6: sp.Expr) -> sp.Expr:
    """Ratio by the velocity plan with numbers for pair 4-5, any angle of wheel 6."""
    radius = oval_radius(e2, sp.cos(2 * angle_of_6)).subs(AXES_45)
    return with_cylinders(ratio_by_plan.subs(AXES_45).subs(rho6, radius), variant)


position_1 = position_of_one(E_SERIES).subs(VARIANTS[1])
ratio_1 = ratio_of_one(E_SERIES).subs(VARIANTS[1])
DWELL_3 = sp.pi / 3


def reverses(ratio: sp.Expr, backward: sp.Expr, forward: sp.Expr) -> tuple[Holds, Holds]:
    """State that the ratio is negative at one carrier angle and positive at another."""
    return less(ratio.subs(phi1, backward), sp.S.Zero), less(sp.S.Zero, ratio.subs(phi1, forward))


def advances(position: sp.Expr, carrier: sp.Expr, output_angle: sp.Expr) -> Equality:
    """State by how much the output advances while the carrier turns by an angle."""
    return Equality(position.subs(phi1, phi1 + carrier) - position, output_angle)


def interval_row(variant: int) -> Claim:
    """State the 95 % interval of one variant: the half-width is twice the printed u."""
    _, mean, uncertainty, printed = READINGS[variant]
    return Claim(
        f"table 2, interval {variant}",
        rf"{mean}\pm{printed}^\circ",
        PrintedNumber(printed, 2 * sp.Rational(uncertainty)),
        note="The half-width is 2u with the u of table 2; the mean is the table's.",
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
            Conjunction(tuple(less(6 * RESOLUTION, least_scatter(v)) for v in (1, 3, 4))),
            note="In variants 1, 3 and 4 single readings scatter by more than six steps of the "
            "encoder, u taken at the lower end of its rounding; one step spreads 0.088/sqrt(12).",
            marks=("ours",),
        ),
        Claim(
            "table 2, scatter of variant 2",
            r"s(q_k)=u\sqrt n>0.088^\circ",
            less(RESOLUTION, least_scatter(2)),
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
                    less(largest_scatter(v, FULL_SCALE_LINEARITY), least_scatter(v))
                    for v in (1, 3, 4)
                )
            ),
            note="Errors within 0.3 % of 360 deg cannot scatter as much as variants 1, 3 and 4.",
            marks=("ours",),
        ),
        Claim(
            "table 2, scatter and two encoders",
            r"u\sqrt n>2.16^\circ\sqrt{n/(n-1)}\text{ in variant 1}",
            less(largest_scatter(1, 2 * FULL_SCALE_LINEARITY), least_scatter(1)),
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
                Holds(sp.Eq(with_cylinders(R4 + R5, v), with_cylinders(R4 + R5, 2), evaluate=False))
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
                Equality(position_1, integrate(1 - wheel_3_rate.subs(mount, 0)).subs(VARIANTS[1])),
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
                less(sp.diff(with_cylinders(ratio_45, 3), phi1, 2).subs(phi1, DWELL_3), sp.S.Zero),
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
            "by how much wheel 6 has turned",
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
            "which variant the figure shows",
            Completion(
                "the figure shows variant 1: its whole swing is within 50 deg",
                less(2 * sp.asin(E_SERIES.subs(VARIANTS[1])), 50 * sp.pi / 180),
            ),
            Completion(
                "the figure shows variant 4: its advance in one turn is within 50 deg",
                less(2 * sp.pi * (with_cylinders(R4 / R5, 4) - 1), 50 * sp.pi / 180),
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
    mean_row("(12)", marks=("rebuilt",)),
    variance_row("(13)", ("rebuilt",)),
    unbiased_row("(13)"),
    variance_of_mean_row("(14)", r"s^2(q)=s^2(q_k)/n", ("rebuilt",)),
    uncertainty_row(
        "(15)",
        "The right-hand side is lost; by its name the type A standard uncertainty.",
        ("rebuilt", "inferred"),
    ),
    resolution_row("table 1", "A 12-bit encoder is inferred.", ("inferred",)),
    linearity_row(
        "table 1",
        "the mean errors of variants 1, 2 and 4",
        lambda limit: means_below(dict.fromkeys((1, 2, 4), limit)),
    ),
    *encoder_rows("table 1"),
    *(interval_row(variant) for variant in READINGS),
    *(
        coverage_row(
            variant,
            count,
            "Coverage of the factor 2 by Student's t, normal observations assumed.",
        )
        for variant, (count, *_) in READINGS.items()
    ),
    *scatter_rows(),
    Claim(
        "measured functions adequate",
        r"\text{the measured functions of all variants are adequate to the model}",
        Completions(
            "the criterion of adequacy and the readings",
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
                less(abs(MEANS[small]), abs(MEANS[large])) for small in (2, 4) for large in (1, 3)
            )
        ),
    ),
    Claim(
        "inaccurate manufacture",
        r"\text{the large mean error of variants 1 and 3 may point to inaccurate manufacture}",
        Completions(
            "what the linearity of 0.3 % refers to",
            Completion(
                "linearity of a reading of 90 deg: both mean errors exceed it",
                Conjunction(tuple(less(READING_LINEARITY, abs(MEANS[v])) for v in (1, 3))),
            ),
            Completion(
                "linearity of the full scale of two encoders: both mean errors exceed it",
                Conjunction(tuple(less(2 * FULL_SCALE_LINEARITY, abs(MEANS[v])) for v in (1, 3))),
            ),
        ),
        note="The encoders alone may explain the mean errors, or may not.",
    ),
)

ROWS = EQUATION_ROWS + THEOREM_ROWS + VARIANT_ROWS + MEASUREMENT_ROWS
