"""Which drives with a cylindrical pair 4-5 dwell: the basis of a search for all of them.

About x = pi, where the satellite's wheel 6 drives wheel 3 most slowly, and about x = 0, where it
drives it fastest, the position is a single arctangent with the factor q = (1 - e2)/(1 + e2) or 1/q.
"""

import sympy as sp

from mechproof.record import Equality, Part, all_of, less, ours

from ..mechanics import *
from ..mechanics import quotient as q, t_place as t

BRANCH = Part("|x| < pi", {x: sp.Interval.open(-sp.pi, sp.pi)})
PROPER = Part("0 < e2 < 1", {e2: OVAL})
RETURNS = Part(
    "q k < 1 < k/q or k/q < 1 < q k, where the ratio changes its sign",
    where=((1 - q * k) * (k - q) > 0,),
)
HALF = sp.tan(x / 2)
OF_E = (1 - e2) / (1 + e2)
QUARTER = sp.pi * R5 / (2 * R4)


def from_place(place: sp.Expr) -> sp.Expr:
    """Return how far the output has moved from its position at a place of the carrier."""
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

ROWS = (
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
        note="As arctg(q t) rises with q, the output counted from the place falls.",
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
        note="Where the output turns back, dM/dt = 0, so only q counts.",
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
        note="The larger e2 is, the less the carrier turns while the output changes from one "
        "speed to another, and the sooner the output leaves a band about a place where it turns "
        "back.",
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
