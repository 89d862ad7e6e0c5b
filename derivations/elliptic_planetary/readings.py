"""Tables 1 to 3 of paper 1: its variants, its encoders, and what its readings say."""

from __future__ import annotations

from sympy import Expr, Ge, Gt, Integral, Ne, Rational, diff, pi

from mechproof.record import (
    Claim,
    Conjunction,
    Correction,
    Datum,
    Definition,
    Equality,
    Holds,
    PrintedNumber,
)

from .._metrology import estimate_row, qbar, s2, s2_mean, u_mean
from .._readings import (
    RESOLUTION,
    Readings,
    adequacy_row,
    encoder_row,
    interval_of_errors,
    millimetre,
    table_row,
    two_encoders,
)
from .._relations import all_of
from .mechanics import largest, lead, non_uniformity
from .position_rows import of_variant
from .ratio_rows import print_8
from .symbols import PRINT, R1, R2, VARIANTS, e, k, misfit, phi1, phi5, tau, x

TYPE_A_ROWS = (
    PRINT.equation(
        "(13)",
        defines=(qbar,),
        note="The mean of the readings.",
        cites=("S47", "S48"),
    ),
    PRINT.equation("(14)", defines=(s2,), note="Needs n >= 2.", cites=("S49",)),
    PRINT.equation("(15)", defines=(s2_mean,), cites=("S50",)),
    estimate_row(
        "(15)",
        cites=("S50",),
        latex=r"\text{we get the estimate of the variance of the mean value}",
    ),
    PRINT.equation(
        "(16)",
        defines=(u_mean,),
        note="The GUM's type A standard uncertainty of the mean.",
        cites=("S51",),
    ),
)

# Table 3: n, mean error and u in degrees; and the half-width of the printed interval.
READINGS = {
    1: Readings(198, Rational("-0.93"), Rational("0.82"), Rational("0.01")),
    2: Readings(194, Rational("-0.98"), Rational("1.36"), Rational("0.01")),
    3: Readings(192, Rational("0.68"), Rational("0.28"), Rational("0.01")),
    4: Readings(171, Rational("-0.89"), Rational("1.01"), Rational("0.01")),
}
HALF_WIDTHS = {1: "1.64", 2: "2.72", 3: "0.28", 4: "2.02"}
INTERVAL_NOTES = {
    **dict.fromkeys(READINGS, "The half-width is twice the u of Table 3."),
    3: "Half-width and u do not agree: either the half-width should be 0.56°, twice the u of "
    "Table 3, or that u is the misprint and should be 0.14°.",
}


GAINS = {number: of_variant(largest, number) for number in VARIANTS}
LIMITS = {number: two_encoders(gain) for number, gain in GAINS.items()}


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
            Conjunction(
                (
                    PrintedNumber(right, 2 * line.uncertainty),
                    PrintedNumber(half, Rational(printed) / 2),
                )
            ),
        ),
    )


def turned_wheel_6(degrees: str) -> Expr:
    """Return the mean error, in degrees, that wheel 6 makes if it is so turned on its shaft."""
    return -2 * lead.subs(x, Rational(degrees) * pi / 180).subs(e, VARIANTS[2][2]) * 180 / pi


TABLE_CLAIMS = (
    *(
        Datum(
            f"Table 1, variant {number}",
            rf"R_1={large}~\mathrm{{mm}},\ R_2={small}~\mathrm{{mm}},\ e={float(eccentricity)}",
            Conjunction(
                (
                    Definition(R1, large * millimetre),
                    Definition(R2, small * millimetre),
                    Definition(e, eccentricity),
                )
            ),
            cites=("S34",),
        )
        for number, (large, small, eccentricity) in VARIANTS.items()
    ),
    Datum(
        "Table 2, resolution",
        r"360^\circ/4096\approx0.088^\circ",
        PrintedNumber("0.088", RESOLUTION),
        cites=("S40",),
    ),
    encoder_row("Table 2", ("S40",)),
    Claim(
        "different non-uniformity",
        r"\text{varying the parameters of the cylindrical and of the elliptical wheels allows to "
        r"obtain various position functions, differing in the non-uniformity of rotation}",
        Conjunction(
            (
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
            )
        ),
        note=(
            "The ratio's (largest - smallest)/mean grows with e and with R1/R2, and no two of the "
            "four variants have the same."
        ),
        cites=("S37", "S58"),
    ),
    table_row("Table 3", "(13)-(16)", READINGS, ("S52", "S53")),
    interval_of_errors(READINGS, ("S7", "S52", "S56")),
    *(interval_row(number, INTERVAL_NOTES[number]) for number in READINGS),
    adequacy_row(("S6", "S45", "S55", "S59", "S60")),
    Claim(
        "inaccurate manufacture",
        r"\text{a large value of the mean error may point to inaccurate manufacture}",
        all_of(
            Equality(
                phi1 + x + 2 * (lead.subs(x, x + misfit) - lead.subs(x, misfit)),
                Integral(print_8.subs(phi5, -R1 / R2 * tau - misfit), (tau, 0, phi1)),
            ),
            Equality(lead.subs(x, -x), -lead),
            PrintedNumber("-0.98", turned_wheel_6("0.541")),
        ),
        note="It may indeed: if wheel 6 is mounted 0.541° off on its shaft, which shifts the "
        "odd and periodic part of the position function, the mean error of variant 2 results.",
        cites=("S54",),
    ),
)
