"""Tables 1 to 3 of paper 1: its variants, its encoders, its readings and what follows from them."""

from sympy import Abs, Expr, Ge, Gt, Integral, Ne, Rational, atan, cos, diff, pi, sin

from mechproof.record import *

from ... import _readings
from ..._metrology import estimate_row, qbar, s2, s2_mean, u_mean
from ..mechanics import *
from .position import ROOT, of_variant, print_8

TYPE_A_ROWS = (
    PRINT.equation("(13)", defines=(qbar,), note="The mean of the readings."),
    PRINT.equation("(14)", defines=(s2,), note="Needs n >= 2."),
    PRINT.equation("(15)", defines=(s2_mean,)),
    estimate_row(
        "(15)",
        cites=("S50",),
        latex=r"\text{we get the estimate of the variance of the mean value}",
    ),
    PRINT.equation(
        "(16)", defines=(u_mean,), note="The GUM's type A standard uncertainty of the mean."
    ),
)

# Table 3: n, mean error and u in degrees; and the half-width of the printed interval.
READINGS = {
    1: _readings.Readings(198, Rational("-0.93"), Rational("0.82"), Rational("0.01")),
    2: _readings.Readings(194, Rational("-0.98"), Rational("1.36"), Rational("0.01")),
    3: _readings.Readings(192, Rational("0.68"), Rational("0.28"), Rational("0.01")),
    4: _readings.Readings(171, Rational("-0.89"), Rational("1.01"), Rational("0.01")),
}
HALF_WIDTHS = {1: "1.64", 2: "2.72", 3: "0.28", 4: "2.02"}
INTERVAL_NOTES = {
    **dict.fromkeys(READINGS, "The half-width is twice the u of Table 3."),
    3: "Half-width and u do not agree: either the half-width should be 0.56°, twice the u of "
    "Table 3, or that u is the misprint and should be 0.14°.",
}


GAINS = {number: of_variant(largest, number) for number in VARIANTS}
LIMITS = {number: _readings.two_encoders(gain) for number, gain in GAINS.items()}


def interval_row(number: int, note: str) -> Claim:
    """Recompute the 95 % interval of one variant: its half-width is twice the printed u."""
    line, printed = READINGS[number], HALF_WIDTHS[number]
    mean, right = f"{float(line.mean):.2f}", f"{float(2 * line.uncertainty):.2f}"
    half = f"{float(Rational(printed) / 2):.2f}"
    return Claim(
        f"Table 3, interval {number}",
        rf"{mean} \pm {printed}^\circ",
        PrintedNumber(printed, 2 * line.uncertainty),
        note=note,
        cites=("S56",),
        corrected=Correction(
            rf"{mean} \pm {right}^\circ\text{{, or }}u={half}^\circ\text{{ in Table 3}}",
            all_of(
                PrintedNumber(right, 2 * line.uncertainty),
                PrintedNumber(half, Rational(printed) / 2),
            ),
        ),
    )


def turned_wheel_6(degrees: str) -> Expr:
    """Return the mean error, in degrees, if wheel 6 is turned on its shaft by this angle."""
    return -2 * lead.subs(x, Rational(degrees) * pi / 180).subs(e, VARIANTS[2][2]) * 180 / pi


TABLE_CLAIMS = (
    *(
        PRINT.datum(
            f"Table 1, variant {number}",
            all_of(
                Definition(R1, large * _readings.millimetre),
                Definition(R2, small * _readings.millimetre),
                Definition(e, eccentricity),
            ),
        )
        for number, (large, small, eccentricity) in VARIANTS.items()
    ),
    PRINT.datum("Table 2, resolution", PrintedNumber("0.088", _readings.RESOLUTION)),
    _readings.encoder_row(PRINT, "Table 2"),
    PRINT.claim(
        "different non-uniformity",
        all_of(
            Holds(Gt(diff(non_uniformity, e), 0)),
            Holds(Ge(diff(non_uniformity, k), 0)),
            *(
                Holds(
                    Ne(
                        of_variant(non_uniformity, one),
                        of_variant(non_uniformity, two),
                        evaluate=False,
                    )
                )
                for one in VARIANTS
                for two in VARIANTS
                if one < two
            ),
        ),
        note="The non-uniformity, (largest - smallest)/mean ratio, grows with e and with R1/R2; "
        "no two variants have the same.",
    ),
    _readings.table_row("Table 3", "(13)-(16)", READINGS, ("S52", "S53")),
    _readings.interval_of_errors(PRINT, READINGS),
    *(interval_row(number, INTERVAL_NOTES[number]) for number in READINGS),
    _readings.adequacy_row(PRINT),
    PRINT.claim(
        "inaccurate manufacture",
        all_of(
            Equality(
                phi1 + x + 2 * (lead.subs(x, x + misfit) - lead.subs(x, misfit)),
                Integral(print_8.subs(phi5, -R1 / R2 * tau - misfit), (tau, 0, phi1)),
            ),
            Equality(lead.subs(x, -x), -lead),
            PrintedNumber("-0.98", turned_wheel_6("0.541")),
        ),
        note="It may: mounting wheel 6 off by 0.541° on its shaft shifts the odd, periodic part "
        "of the position function and gives the mean error of variant 2.",
    ),
)


# What follows for its own numbers and conclusions -------------------------------------------------

LARGEST_MEAN_ERROR = max(Abs(line.mean) for line in READINGS.values())


def mean_lack(number: int) -> Expr:
    """Return the mean number of degrees by which (12) is too small on its first branch."""
    # Without tangents: 2 arctg((1 + e)/(1 - e) tg(x/2)) is x and twice the lead, and the root in
    # (12) is (1 + e)/(1 - e) of another e.
    other = (1 - ROOT) / (1 + ROOT)
    right, printed = (x + 2 * atan(b * sin(x) / (1 - b * cos(x))) for b in (e, other))
    return Integral(of_variant(right - ROOT * printed, number), (x, 0, pi)) / pi * 180 / pi


CONSEQUENCES = (
    ours(
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
        "average. Mean errors of at most 0.98° cannot come from a comparison with it: the "
        "calculation behind Table 3 used another formula, and the slip in (12) is in the article "
        "only.",
        marks=("consequence",),
    ),
    ours(
        "Table 3, scatter and two encoders",
        r"u\sqrt n=11.5^\circ,\ 18.9^\circ,\ 3.9^\circ,\ 13.2^\circ;\ "
        r"u\sqrt n>M\sqrt{\tfrac n{n-1}}\text{ in variants 1, 2, 4},\ "
        r"M=1.08^\circ\,(1+\max\varphi_3')=10.1^\circ,\ 14.7^\circ,\ 7.3^\circ,\ 10.3^\circ",
        all_of(
            *rounded(
                ("11.5", "18.9", "3.9", "13.2"),
                (line.implied_scatter for line in READINGS.values()),
            ),
            *rounded(("10.1", "14.7", "7.3", "10.3"), LIMITS.values()),
            _readings.beyond_encoders(READINGS, {number: LIMITS[number] for number in (1, 2, 4)}),
            less(READINGS[3].implied_scatter, LIMITS[3]),
        ),
        note="If u belongs to the mean, as by (15) and (16), single errors scatter by u sqrt(n). "
        "An encoder within 0.3 % of 360° on each shaft allows errors of at most M about any "
        "offset of the mechanism. In variants 1, 2 and 4 such errors cannot scatter so much: "
        "either the mechanism or its model is off, or u is not an uncertainty of the mean.",
        marks=("inferred", "consequence"),
    ),
    _readings.if_u_is_s(
        "Table 3",
        READINGS,
        halves=("0.117", "0.195", "0.040", "0.154"),
        distances=("16", "10", "34", "12"),
    ),
)

ROWS = (*TYPE_A_ROWS, *TABLE_CLAIMS, *CONSEQUENCES)
