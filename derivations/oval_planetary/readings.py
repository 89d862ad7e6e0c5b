"""The measurement of paper 2: (12)-(15), tables 1 and 2, what the readings say."""

from __future__ import annotations

import sympy as sp

from mechproof.record import Claim, PrintedNumber, Row

from .._metrology import estimate_row, qbar, s2, s2_mean, u_mean
from .._readings import (
    Readings,
    adequacy_row,
    encoder_row,
    interval_of_errors,
    table_row,
    two_encoders,
)
from .._relations import all_of, less
from .mechanics import COEFFICIENTS, PRINT, e1, e2, mount, phi1, ratio_45
from .pairs import fastest
from .variants import VARIANTS, ratio_1, with_cylinders

# Table 2: n, mean error and u in degrees; and the half-widths of the printed intervals.
READINGS = {
    1: Readings(175, sp.Rational("0.777"), sp.Rational("0.18"), sp.Rational("0.001")),
    2: Readings(190, sp.Rational("0.035"), sp.Rational("0.04"), sp.Rational("0.001")),
    3: Readings(214, sp.Rational("1.280"), sp.Rational("0.11"), sp.Rational("0.001")),
    4: Readings(193, sp.Rational("-0.540"), sp.Rational("0.15"), sp.Rational("0.001")),
}
HALF_WIDTHS = {1: "0.360", 2: "0.080", 3: "0.220", 4: "0.300"}

# Where the mechanism runs fastest, for which (10) is negative.
RATIOS = {1: ratio_1} | {variant: with_cylinders(ratio_45, variant) for variant in (2, 3, 4)}
GAINS = {1: -ratio_1.subs(phi1, 0)} | {
    variant: with_cylinders(fastest - 1, variant) for variant in (2, 3, 4)
}
LIMITS = {variant: two_encoders(gain) for variant, gain in GAINS.items()}


def interval_row(variant: int) -> Claim:
    """State the 95 % interval of one variant: the half-width is twice the printed u."""
    line, printed = READINGS[variant], HALF_WIDTHS[variant]
    return Claim(
        f"Table 2, interval {variant}",
        rf"{float(line.mean):.3f}\pm{printed}^\circ",
        PrintedNumber(printed, 2 * line.uncertainty),
        note="The half-width is 2u with the u of Table 2; the mean is the table's.",
        cites=("S51",),
    )


def turned_wheel_6(variant: int, degrees: str) -> sp.Expr:
    """Return the mean error, in degrees, that wheel 6 makes if it is so turned on its shaft."""
    lam, mu, nu = COEFFICIENTS
    double = sp.atan2(e2 * sp.sin(2 * mount), 1 - e2 * sp.cos(2 * mount))
    mean = sp.atan2(nu, lam + mu) if e1 in VARIANTS[variant] else double
    turned = {**VARIANTS[variant], mount: sp.Rational(degrees) * sp.pi / 180}
    return mean.subs(turned) * 180 / sp.pi


MEASUREMENT_ROWS: tuple[Row, ...] = (
    PRINT.equation("(12)", defines=(qbar,), marks=("rebuilt",), cites=("S43",)),
    PRINT.equation("(13)", note="Needs n >= 2.", defines=(s2,), marks=("rebuilt",), cites=("S44",)),
    PRINT.equation("(14)", defines=(s2_mean,), marks=("rebuilt",), cites=("S45",)),
    estimate_row("(14)", ("rebuilt",), ("S45",), r"\text{variance of the mean value}"),
    PRINT.equation(
        "(15)",
        note="The right-hand side is lost; by its name it is the type A standard uncertainty.",
        defines=(u_mean,),
        marks=("rebuilt", "inferred"),
        cites=("S46",),
    ),
    encoder_row("Table 1", ("S37",)),
    table_row("Table 2", "(12)-(15)", READINGS, ("S47", "S48"), marks=("rebuilt",)),
    interval_of_errors(READINGS, ("S47", "S51", "S57"), ("rebuilt",)),
    *(interval_row(variant) for variant in READINGS),
    adequacy_row(("S7", "S41", "S50", "S56")),
    Claim(
        "inaccurate manufacture",
        r"\text{the large mean error for the first and the third variants may point to inaccurate "
        r"manufacture}",
        all_of(
            *(
                less(abs(READINGS[small].mean), abs(READINGS[large].mean))
                for small in (2, 4)
                for large in (1, 3)
            ),
            PrintedNumber("0.777", turned_wheel_6(1, "1.348")),
            PrintedNumber("1.280", turned_wheel_6(3, "2.566")),
        ),
        note="These two mean errors are the large ones, and it may indeed: they result if wheel 6 "
        "is mounted 1.348° off on its shaft in variant 1, and 2.566° off in variant 3.",
        marks=("inferred",),
        cites=("S49",),
    ),
)
