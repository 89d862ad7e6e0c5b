"""What follows from the rows of paper 1 for its own numbers and conclusions."""

from sympy import Abs, Expr, Integral, atan, cos, pi, sin

from mechproof.record import Claim, PrintedNumber

from .._readings import beyond_encoders, if_u_is_s
from .._relations import all_of, less
from .position_rows import ROOT, of_variant
from .readings import LIMITS, READINGS
from .symbols import e, x

LARGEST_MEAN_ERROR = max(Abs(line.mean) for line in READINGS.values())


def mean_lack(number: int) -> Expr:
    """Return by how many degrees (12) is too small in the mean of its first branch."""
    # Without tangents: 2 arctg((1 + e)/(1 - e) tg(x/2)) is x and twice the lead, and the root in
    # (12) is (1 + e)/(1 - e) of another e.
    other = (1 - ROOT) / (1 + ROOT)
    right, printed = (x + 2 * atan(b * sin(x) / (1 - b * cos(x))) for b in (e, other))
    return Integral(of_variant(right - ROOT * printed, number), (x, 0, pi)) / pi * 180 / pi


CONSEQUENCES = (
    Claim(
        "(12) and the mean errors of Table 3",
        r"\text{mean of }(12)-\varphi_3\text{ over }0\le x\le\pi:\ -35.3^\circ\ (e=0.28),\ "
        r"-60.8^\circ\ (e=0.475)",
        all_of(
            PrintedNumber("-35.3", -mean_lack(1)),
            PrintedNumber("-60.8", -mean_lack(2)),
            PrintedNumber("0.98", LARGEST_MEAN_ERROR),
            less(LARGEST_MEAN_ERROR, mean_lack(1)),
        ),
        note="On the first branch alone, before it jumps back, (12) is off by this much on "
        "average. Mean errors of at most 0.98° cannot have been found by comparison with it: "
        "the calculation behind Table 3 used another formula, and the slip in (12) is one of the "
        "article only.",
        marks=("ours", "consequence"),
    ),
    Claim(
        "Table 3, scatter and two encoders",
        r"u\sqrt n=11.5^\circ,\ 18.9^\circ,\ 3.9^\circ,\ 13.2^\circ;\ "
        r"u\sqrt n>M\sqrt{\tfrac n{n-1}}\text{ in variants 1, 2, 4},\ "
        r"M=1.08^\circ\,(1+\max\varphi_3')=10.1^\circ,\ 14.7^\circ,\ 7.3^\circ,\ 10.3^\circ",
        all_of(
            *(
                PrintedNumber(printed, line.implied_scatter)
                for printed, line in zip(
                    ("11.5", "18.9", "3.9", "13.2"), READINGS.values(), strict=True
                )
            ),
            *(
                PrintedNumber(printed, limit)
                for printed, limit in zip(
                    ("10.1", "14.7", "7.3", "10.3"), LIMITS.values(), strict=True
                )
            ),
            beyond_encoders(READINGS, {number: LIMITS[number] for number in (1, 2, 4)}),
            less(READINGS[3].implied_scatter, LIMITS[3]),
        ),
        note="If u belongs to the mean, as (15) and (16) have it, single errors scatter by u "
        "sqrt(n). An encoder on each shaft that keeps to 0.3 % of 360° allows errors of at "
        "most M about any offset of the mechanism, and such errors cannot scatter so much in "
        "variants 1, 2 and 4: either the mechanism or its model is off, or u is not an "
        "uncertainty of the mean.",
        marks=("ours", "inferred", "consequence"),
    ),
    if_u_is_s(
        "Table 3",
        READINGS,
        halves=("0.117", "0.195", "0.040", "0.154"),
        distances=("16", "10", "34", "12"),
    ),
)
