"""Two oval pairs: they act as one, and only swing the output."""

from __future__ import annotations

import sympy as sp

from mechproof.record import Claim, Conjunction, Equality, Holds, Part, Row

from .mechanics import COS_4, integrate, pair_ratio, wheel_3_rate
from .positions import (
    COEFFICIENTS,
    E_ALIGNED,
    E_SERIES,
    position_by_one_pair,
    position_of_map,
    ratio_of_map,
    ratio_of_one,
)
from .symbols import OVAL, alpha, beta, delta, e, e1, e2, gamma, lam, mount, mu, nu, phi1, theta


def advances(position: sp.Expr, carrier: sp.Expr, output_angle: sp.Expr) -> Equality:
    """State by how much the output advances while the carrier turns by an angle."""
    return Equality(position.subs(phi1, phi1 + carrier) - position, output_angle)


OVAL_PAIR_ROWS: tuple[Row, ...] = (
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
        marks=("ours", "inferred"),
    ),
    Claim(
        "parallel wheels",
        r"\text{major axes of 5 and 6 parallel: }E=\frac{e_1-e_2}{1-e_1e_2}",
        Equality(1 - pair_ratio(E_ALIGNED, COS_4), 1 - wheel_3_rate.subs(mount, sp.pi / 2)),
        note="Equal ovals mounted so leave the output at rest: the right angle of (6) matters.",
        marks=("ours", "inferred"),
    ),
    Claim(
        "mounted at any angle",
        r"\frac1{1-\varphi_3'}=\frac{\mu^2(1+\cos2\varphi_1)+2\mu\nu\sin2\varphi_1"
        r"+(\lambda^2+\nu^2)(1-\cos2\varphi_1)}{2\lambda\mu}",
        Equality(1 / (1 - ratio_of_map(*COEFFICIENTS)), 1 / wheel_3_rate),
        note="lambda = (1+e1)(1-e2^2), mu = (1-e1)(1+e2^2-2 e2 cos 2m), nu = 2(1+e1) e2 sin 2m: "
        "the pairs compose as tan(chi) = lambda t/(mu + nu t), t = tan(phi1); the ratio is not 1.",
        marks=("ours", "inferred"),
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
        marks=("ours", "inferred"),
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
        marks=("ours", "inferred"),
    ),
)
