"""Two oval pairs act as one and only swing the output; a cylindrical pair with an oval one."""

import sympy as sp

from mechproof.record import Equality, Holds, Part, all_of, ours

from ..mechanics import *


def advances(position: sp.Expr, carrier: sp.Expr, output_angle: sp.Expr) -> Equality:
    """State by how much the output advances while the carrier turns by an angle."""
    return Equality(position.subs(phi1, phi1 + carrier) - position, output_angle)


OVAL_PAIR_ROWS = (
    ours(
        "two eccentricities as one",
        r"\frac{1+E}{1-E}=\frac{1+e_1}{1-e_1}\cdot\frac{1+e_2}{1-e_2},\ "
        r"E=\frac{e_1+e_2}{1+e_1e_2}",
        all_of(
            Equality((1 + E_SERIES) / (1 - E_SERIES), (1 + e1) / (1 - e1) * (1 + e2) / (1 - e2)),
            Equality(ratio_of_one(E_SERIES), 1 - wheel_3_rate.subs(mount, 0)),
        ),
        note="Two oval pairs in series act as one; their eccentricities add as velocities do in "
        "relativity.",
        marks=("inferred",),
    ),
    ours(
        "mounted at any angle",
        r"\frac1{1-\varphi_3'}=\frac{\mu^2(1+\cos2\varphi_1)+2\mu\nu\sin2\varphi_1"
        r"+(\lambda^2+\nu^2)(1-\cos2\varphi_1)}{2\lambda\mu}",
        Equality(1 / (1 - ratio_of_map(*COEFFICIENTS)), 1 / wheel_3_rate),
        note="lambda = (1 + e1)(1 - e2^2), mu = (1 - e1)(1 + e2^2 - 2 e2 cos 2m), nu = 2 (1 + e1) "
        "e2 sin 2m: the pairs compose as tan(chi) = lambda t/(mu + nu t), t = tan(phi1); the ratio "
        "is not 1.",
        marks=("inferred",),
        quantities=("ratio",),
    ),
    ours(
        "coefficients without cancellation",
        r"\alpha,\beta,\gamma=\lambda,\mu,\nu;\ \delta=\alpha-\beta",
        all_of(
            *(
                Equality(kernel, coefficient)
                for kernel, coefficient in zip(
                    (alpha, beta, gamma, delta),
                    (*COEFFICIENTS, COEFFICIENTS[0] - COEFFICIENTS[1]),
                    strict=True,
                )
            )
        ),
        quantities=("ratio", "position", "acceleration"),
    ),
    ours(
        "position, any mount",
        r"\int_0^{\varphi_1}\varphi_3'\,d\varphi_1\text{ as two arguments}",
        Equality(position_by_one_pair, integrate(ratio_of_map(lam, mu, nu))),
        quantities=("position",),
    ),
    ours(
        "position, any mount, one argument",
        r"\varphi_3=\mathrm{atan2}(\nu(1-\cos2\varphi_1)-(\lambda-\mu)\sin2\varphi_1,\ "
        r"\lambda+\mu+(\mu-\lambda)\cos2\varphi_1+\nu\sin2\varphi_1)",
        Equality(position_of_map(lam, mu, nu, lam - mu), position_by_one_pair),
        note="The output never leaves (-pi, pi): two oval pairs only make it swing.",
        quantities=("position",),
    ),
    ours(
        "drift, oval pairs",
        r"\varphi_3(\varphi_1+\pi)=\varphi_3(\varphi_1)",
        advances(position_of_map(lam, mu, nu, lam - mu), sp.pi, sp.S.Zero),
        note="There is no mean drift, whatever the eccentricities and the mounting.",
        marks=("inferred",),
        quantities=("position",),
    ),
    ours(
        "amplitude",
        r"|\sin\varphi_3|\le E,\ \varphi_3=-\arcsin E\text{ at }\cos2\varphi_1=E",
        all_of(
            Holds(e**2 - e**2 * sp.sin(theta) ** 2 / (1 + e**2 - 2 * e * sp.cos(theta)) >= 0),
            Equality(sp.atan2(e * sp.sqrt(1 - e**2), 1 - e**2), sp.asin(e)),
        ),
        note="sin(phi3)^2 = E^2 sin(x)^2/(1 + E^2 - 2 E cos(x)); E written e.",
        quantities=("position",),
    ),
)

# Extremes of d chi/d phi1 with a cylindrical pair 4-5.
fastest = R4 / R5 * (1 + e2) / (1 - e2)
slowest = R4 / R5 * (1 - e2) / (1 + e2)
PROPER_45 = Part("e2 > 0", {e2: OVAL})

# With R4/R5 at a limit the ratio has a double zero; half the width of a dwell is 2 atan(T) in x.
limit_ratio = RATIO_CYLINDRICAL.subs(k, (1 + e2) / (1 - e2)).subs(sp.cos(x), sp.cos(theta))
cos_beside = -(1 - width**2) / (1 + width**2)
ratio_beside = limit_ratio.subs(sp.cos(theta), cos_beside)
edge = (1 + e2) * sp.sqrt(eta / (4 * e2 - eta * (1 - e2) ** 2))
REACHED = Part(
    "e2 > 0 and eta below the largest ratio", {e2: OVAL}, (eta < 4 * e2 / (1 - e2) ** 2,)
)

CYLINDRICAL_PAIR_ROWS = (
    ours(
        "special case, radii",
        r"\varphi_3'=1-\frac{R_4}{R_5}\cdot\frac{1-e_2^2}{1+e_2^2-2e_2\cos x},\ "
        r"x=2\tfrac{R_4}{R_5}\varphi_1",
        Equality(ratio_45, ratio_with_cylinders_45),
        note="(10) with the radii of pair 4-5 replaced by numbers, its sign as in the mechanics, "
        "and wheel 6 turned by (R4/R5) phi1.",
        marks=("inferred",),
        quantities=("ratio_cylindrical",),
    ),
    ours(
        "position, cylindrical pair 4-5",
        r"\varphi_3=\left(1-\tfrac{R_4}{R_5}\right)\varphi_1"
        r"-\mathrm{arctg}\frac{e_2\sin x}{1-e_2\cos x}",
        Equality(position_45, integrate(ratio_with_cylinders_45)),
        marks=("inferred",),
        quantities=("position_cylindrical",),
    ),
    ours(
        "drift, cylindrical pair 4-5",
        r"\varphi_3(\varphi_1+\pi\tfrac{R_5}{R_4})-\varphi_3(\varphi_1)"
        r"=\pi\left(\tfrac{R_5}{R_4}-1\right)",
        advances(position_45, sp.pi * R5 / R4, sp.pi * (R5 / R4 - 1)),
        note="The mean ratio is 1 - R4/R5; only for R4 = R5 is there no drift.",
        marks=("inferred",),
        quantities=("position_cylindrical",),
    ),
    ours(
        "extremes, cylindrical pair 4-5",
        r"1-\tfrac{R_4}{R_5}\tfrac{1+e_2}{1-e_2}\le\varphi_3'"
        r"\le1-\tfrac{R_4}{R_5}\tfrac{1-e_2}{1+e_2}",
        all_of(Holds(1 - fastest <= ratio_45), Holds(1 - slowest >= ratio_45)),
        note="Reached at x = 0 and x = pi. So the output always turns against the carrier for "
        "R4/R5 > (1 + e2)/(1 - e2), always with it for R4/R5 < (1 - e2)/(1 + e2), and reverses in "
        "between.",
        marks=("inferred",),
        quantities=("ratio_cylindrical",),
    ),
    ours(
        "intermittent, against the carrier",
        r"\tfrac{R_4}{R_5}=\tfrac{1+e_2}{1-e_2}\Rightarrow"
        r"\varphi_3'=-\frac{2e_2(1+\cos x)}{1+e_2^2-2e_2\cos x}\le0",
        all_of(
            Equality(
                limit_ratio, -2 * e2 * (1 + sp.cos(theta)) / (1 + e2**2 - 2 * e2 * sp.cos(theta))
            ),
            Holds(limit_ratio <= 0),
            Holds(sp.diff(limit_ratio, theta, 2).subs(theta, sp.pi) < 0),
        ),
        note="A double zero at x = pi. The ratio is analytic and cannot vanish on an interval: a "
        "dwell is a double zero.",
        on=PROPER_45,
        marks=("inferred",),
        quantities=("ratio_cylindrical",),
    ),
    ours(
        "width of a dwell",
        r"|\varphi_3'|\le\eta\iff|x-\pi|\le2\,\mathrm{arctg}\,T,\ "
        r"T^2=\frac{\eta(1+e_2)^2}{4e_2-\eta(1-e_2)^2}",
        all_of(
            Equality(ratio_beside.subs(width, edge), -eta), Holds(sp.diff(ratio_beside, width) < 0)
        ),
        note="For R4/R5 = (1 + e2)/(1 - e2), where the ratio falls on both sides of x = pi; in the "
        "carrier's angle the dwell is 2 (R5/R4) arctan(T) wide.",
        on=REACHED,
        marks=("inferred",),
        quantities=("ratio_cylindrical",),
    ),
)

ROWS = (*OVAL_PAIR_ROWS, *CYLINDRICAL_PAIR_ROWS)
