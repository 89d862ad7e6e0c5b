"""Two oval pairs act as one and only swing the output; a cylindrical pair beside an oval one.

About x = pi, where the satellite's wheel 6 drives wheel 3 most slowly, and about x = 0, where it
drives it fastest, the position is one arctangent with the factor q = (1 - e2)/(1 + e2) or 1/q.
"""

import sympy as sp

from mechproof.record import Equality, Holds, Part, all_of, less, ours

from .mechanics import *
from .mechanics import quotient as q, t_place as t


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
        note="Reached at x = 0 and x = pi. So the output turns one way against the carrier for "
        "R4/R5 > (1 + e2)/(1 - e2), one way with it for R4/R5 < (1 - e2)/(1 + e2), and reverses "
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


# Which drives with a cylindrical pair 4-5 dwell: what a search for all of them rests on -----------

BRANCH = Part("|x| < pi", {x: sp.Interval.open(-sp.pi, sp.pi)})
PROPER = Part("0 < e2 < 1", {e2: OVAL})
RETURNS = Part("q k < 1 < k/q, where the ratio changes its sign", where=(q * k < 1, q < k))
HALF = sp.tan(x / 2)
OF_E = (1 - e2) / (1 + e2)
QUARTER = sp.pi * R5 / (2 * R4)


def from_place(place: sp.Expr) -> sp.Expr:
    """Return how far the output is from where it is at a place of the carrier."""
    return position_45.subs(phi1, phi1 + place) - position_45.subs(phi1, place)


# Speed of wheel 3 against the carrier, by the tangent t of half of x counted from the place.
speed = k * q * (1 + t**2) / (1 + q**2 * t**2)
# Where it is 1 the output turns back, after the swing from the place.
turning = sp.sqrt((1 - k * q) / (q * (k - q)))
swing = sp.atan(t) / k - sp.atan(q * t)
# k over the speed, and the sum of q and its inverse.
slowness = (1 + e2**2 - 2 * e2 * sp.cos(x)) / (1 - e2**2)
spread = OF_E + 1 / OF_E
against = k * (1 - e2**2) - theta * (1 + e2**2 - 2 * e2 * sp.cos(x))

DWELL_ROWS = (
    ours(
        "dwells, position from the slowest place",
        r"\varphi_3\left(\tfrac{\pi R_5}{2R_4}+\varphi_1\right)-\varphi_3\left(\tfrac{\pi R_5}"
        r"{2R_4}\right)=\varphi_1-\mathrm{arctg}\left(\tfrac{1-e_2}{1+e_2}"
        r"\mathrm{tg}\tfrac{R_4\varphi_1}{R_5}\right)",
        Equality(from_place(QUARTER), phi1 - sp.atan(OF_E * HALF)),
        on=BRANCH,
        quantities=("position_cylindrical",),
    ),
    ours(
        "dwells, position from the fastest place",
        r"\varphi_3(\varphi_1)=\varphi_1-\mathrm{arctg}\left(\tfrac{1+e_2}{1-e_2}"
        r"\mathrm{tg}\tfrac{R_4\varphi_1}{R_5}\right)",
        Equality(from_place(sp.S.Zero), phi1 - sp.atan(HALF / OF_E)),
        on=BRANCH,
        quantities=("position_cylindrical",),
    ),
    ours(
        "dwells, where the output turns back",
        r"t^2=\mathrm{tg}^2\tfrac{R_4\varphi_1}{R_5}=\frac{1-kq}{q(k-q)}",
        all_of(
            Equality(speed.subs(t, HALF), sp.diff(sp.atan(q * HALF), x) * 2 * k),
            Equality(speed.subs(t, turning), sp.S.One),
            less(sp.S.Zero, sp.diff(sp.atan(q * t), q)),
        ),
        note="From there on it is nearer to the place the smaller q is: arctg(q t) rises with q.",
        on=RETURNS,
        quantities=("position_cylindrical",),
    ),
    ours(
        "dwells, how far the output turns back",
        r"M=\tfrac1k\mathrm{arctg}\,t-\mathrm{arctg}(qt),\ "
        r"\frac{dM}{dq}=-\frac t{1+q^2t^2}<0",
        all_of(
            Equality(sp.diff(swing, t).subs(t, turning), sp.S.Zero),
            Equality(sp.diff(swing, q), -t / (1 + (q * t) ** 2)),
        ),
        note="Where the output turns back M does not change with t, so only q counts.",
        on=RETURNS,
        quantities=("position_cylindrical",),
    ),
    ours(
        "dwells, time spent at a speed",
        r"\kappa=\frac k{1-\varphi_3'}:\ \left(\frac{d\kappa}{dx}\right)^2"
        r"=\kappa\left(q+\tfrac1q\right)-1-\kappa^2,\ \frac d{de_2}\left(q+\tfrac1q\right)>0",
        all_of(
            Equality(k / (1 - RATIO_CYLINDRICAL), slowness),
            Equality(sp.diff(slowness, x) ** 2, slowness * spread - 1 - slowness**2),
            less(sp.S.Zero, sp.diff(spread, e2)),
        ),
        note="The carrier passes each speed of the output in less of its angle the larger e2 is. "
        "So it passes from any speed to any other in less, and the output leaves a band about a "
        "place where it turns back after less.",
        on=PROPER,
        quantities=("ratio_cylindrical",),
    ),
    ours(
        "dwells, ratio within eta at an angle",
        r"1-\varphi_3'\gtrless u\iff-(u+k)e_2^2+2u\cos x\,e_2+k-u\gtrless0",
        all_of(
            Equality((1 - RATIO_CYLINDRICAL - theta) * (1 + e2**2 - 2 * e2 * sp.cos(x)), against),
            Equality(against, -(theta + k) * e2**2 + 2 * theta * sp.cos(x) * e2 + k - theta),
        ),
        note="u written theta. At an angle x from a place this is of the second degree in e2.",
        quantities=("ratio_cylindrical",),
    ),
    ours(
        "dwells, exact",
        r"e_2=\frac{k-1}{k+1}\Rightarrow\varphi_3'(x=\pi)=0,\ e_2=\frac{1-k}{1+k}\Rightarrow"
        r"\varphi_3'(x=0)=0",
        all_of(
            *(
                Equality(
                    RATIO_CYLINDRICAL.subs({e2: sign * (k - 1) / (k + 1), sp.cos(x): -sign}),
                    sp.S.Zero,
                )
                for sign in (1, -1)
            )
        ),
        quantities=("ratio_cylindrical",),
    ),
    ours(
        "dwells, equal circles",
        r"R_4=R_5:\ \sin\varphi_3=-e_2\sin(2\varphi_1-\varphi_3)",
        Equality(
            sp.sin(position_45).subs(R4, R5), -e2 * sp.sin(2 * phi1 - position_45).subs(R4, R5)
        ),
        note="By 2 phi1 - phi3 the output swings like a sine: it stays in the band of width 2 b "
        "below its largest value M, sin(M) = e2, while the carrier turns by L, "
        "cos(L) sin(M) = sin(M - 2 b).",
        quantities=("position_cylindrical",),
    ),
)
