"""A cylindrical pair beside an oval one: position, drift, kinds of motion, dwells."""

from __future__ import annotations

import sympy as sp

from mechproof.record import Claim, Conjunction, Equality, Holds, Part, Row

from .mechanics import integrate, pair_ratio
from .oval_pairs import advances
from .positions import (
    RATIO_CYLINDRICAL,
    position_36,
    position_45,
    ratio_45,
    ratio_with_cylinders_36,
    ratio_with_cylinders_45,
)
from .symbols import OVAL, R4, R5, e2, eta, k, theta, width, x

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

CYLINDRICAL_PAIR_ROWS: tuple[Row, ...] = (
    Claim(
        "special case, radii",
        r"\varphi_3'=1-\frac{R_4}{R_5}\cdot\frac{1-e_2^2}{1+e_2^2-2e_2\cos x},\ "
        r"x=2\tfrac{R_4}{R_5}\varphi_1",
        Equality(ratio_45, ratio_with_cylinders_45),
        note="The radii of pair 4-5 replaced by numbers in (10), its sign as in the mechanics, "
        "and wheel 6 turned by (R4/R5) phi1.",
        marks=("ours", "inferred"),
    ),
    Claim(
        "position, cylindrical pair 4-5",
        r"\varphi_3=\left(1-\tfrac{R_4}{R_5}\right)\varphi_1"
        r"-\mathrm{arctg}\frac{e_2\sin x}{1-e_2\cos x}",
        Equality(position_45, integrate(ratio_with_cylinders_45)),
        marks=("ours", "inferred"),
    ),
    Claim(
        "position, cylindrical pair 3-6",
        r"\varphi_3=\left(1-\tfrac{R_6}{R_3}\right)\varphi_1"
        r"-\tfrac{R_6}{R_3}\mathrm{arctg}\frac{e_1\sin2\varphi_1}{1-e_1\cos2\varphi_1}",
        Equality(position_36, integrate(ratio_with_cylinders_36)),
        marks=("ours", "inferred"),
    ),
    Claim(
        "drift, cylindrical pair 4-5",
        r"\varphi_3(\varphi_1+\pi\tfrac{R_5}{R_4})-\varphi_3(\varphi_1)"
        r"=\pi\left(\tfrac{R_5}{R_4}-1\right)",
        advances(position_45, sp.pi * R5 / R4, sp.pi * (R5 / R4 - 1)),
        note="The mean ratio is 1 - R4/R5, no drift only for R4 = R5.",
        marks=("ours", "inferred"),
    ),
    Claim(
        "extremes, cylindrical pair 4-5",
        r"1-\tfrac{R_4}{R_5}\tfrac{1+e_2}{1-e_2}\le\varphi_3'"
        r"\le1-\tfrac{R_4}{R_5}\tfrac{1-e_2}{1+e_2}",
        Conjunction((Holds(1 - fastest <= ratio_45), Holds(1 - slowest >= ratio_45))),
        note="Reached at x = 0 and x = pi.",
        marks=("ours", "inferred"),
    ),
    Claim(
        "one-way, against the carrier",
        r"\tfrac{R_4}{R_5}>\tfrac{1+e_2}{1-e_2}\Rightarrow\varphi_3'<0",
        Holds(ratio_45 < 0),
        on=FASTER,
        marks=("ours", "inferred"),
    ),
    Claim(
        "one-way, with the carrier",
        r"\tfrac{R_4}{R_5}<\tfrac{1-e_2}{1+e_2}\Rightarrow\varphi_3'>0",
        Holds(ratio_45 > 0),
        on=SLOWER,
        marks=("ours", "inferred"),
    ),
    Claim(
        "both ways, forward",
        r"\tfrac{R_4}{R_5}<\tfrac{1+e_2}{1-e_2}\Rightarrow\max\varphi_3'>0",
        Holds(1 - slowest > 0),
        on=BELOW_UPPER,
        marks=("ours", "inferred"),
    ),
    Claim(
        "both ways, backward",
        r"\tfrac{R_4}{R_5}>\tfrac{1-e_2}{1+e_2}\Rightarrow\min\varphi_3'<0",
        Holds(1 - fastest < 0),
        note="Between both limits the output reverses: reciprocating for R4 = R5, else with drift.",
        on=ABOVE_LOWER,
        marks=("ours", "inferred"),
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
        marks=("ours", "inferred"),
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
        marks=("ours", "inferred"),
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
        marks=("ours", "inferred"),
    ),
)
