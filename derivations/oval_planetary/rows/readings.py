"""The measurement of paper 2, (12)-(15), tables 1 and 2; its conclusions; and what follows."""

import sympy as sp

from mechproof.record import *

from ... import _readings
from ..._metrology import estimate_row, qbar, s2, s2_mean, u_mean
from ..mechanics import *
from .pairs import edge, fastest
from .variants import DWELL_3, VARIANTS, ratio_1, with_cylinders

# Table 2: n, mean error and u in degrees; and the half-widths of the printed intervals.
READINGS = {
    1: _readings.Readings(175, sp.Rational("0.777"), sp.Rational("0.18"), sp.Rational("0.001")),
    2: _readings.Readings(190, sp.Rational("0.035"), sp.Rational("0.04"), sp.Rational("0.001")),
    3: _readings.Readings(214, sp.Rational("1.280"), sp.Rational("0.11"), sp.Rational("0.001")),
    4: _readings.Readings(193, sp.Rational("-0.540"), sp.Rational("0.15"), sp.Rational("0.001")),
}
HALF_WIDTHS = {1: "0.360", 2: "0.080", 3: "0.220", 4: "0.300"}

# Where the mechanism runs fastest, for which (10) is negative.
RATIOS = {1: ratio_1} | {variant: with_cylinders(ratio_45, variant) for variant in (2, 3, 4)}
GAINS = {1: -ratio_1.subs(phi1, 0)} | {
    variant: with_cylinders(fastest - 1, variant) for variant in (2, 3, 4)
}
LIMITS = {variant: _readings.two_encoders(gain) for variant, gain in GAINS.items()}


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
    """Return the mean error, in degrees, if wheel 6 is turned on its shaft by this angle."""
    lam, mu, nu = COEFFICIENTS
    double = sp.atan2(e2 * sp.sin(2 * mount), 1 - e2 * sp.cos(2 * mount))
    mean = sp.atan2(nu, lam + mu) if e1 in VARIANTS[variant] else double
    turned = {**VARIANTS[variant], mount: sp.Rational(degrees) * sp.pi / 180}
    return mean.subs(turned) * 180 / sp.pi


MEASUREMENT_ROWS = (
    PRINT.equation("(12)", defines=(qbar,), marks=("rebuilt",)),
    PRINT.equation("(13)", note="Needs n >= 2.", defines=(s2,), marks=("rebuilt",)),
    PRINT.equation("(14)", defines=(s2_mean,), marks=("rebuilt",)),
    estimate_row("(14)", ("rebuilt",), ("S45",), r"\text{variance of the mean value}"),
    PRINT.equation(
        "(15)",
        note="The right-hand side is lost; by its name it is the type A standard uncertainty.",
        defines=(u_mean,),
        marks=("rebuilt", "inferred"),
    ),
    _readings.encoder_row(PRINT, "Table 1"),
    _readings.table_row("Table 2", "(12)-(15)", READINGS, ("S47", "S48"), marks=("rebuilt",)),
    _readings.interval_of_errors(PRINT, READINGS, ("rebuilt",)),
    *(interval_row(variant) for variant in READINGS),
    _readings.adequacy_row(PRINT),
    PRINT.claim(
        "inaccurate manufacture",
        all_of(
            *(
                less(abs(READINGS[small].mean), abs(READINGS[large].mean))
                for small in (2, 4)
                for large in (1, 3)
            ),
            PrintedNumber("0.777", turned_wheel_6(1, "1.348")),
            PrintedNumber("1.280", turned_wheel_6(3, "2.566")),
        ),
        note="It may: these two mean errors, the large ones, result if wheel 6 is mounted 1.348° "
        "off on its shaft in variant 1, and 2.566° off in variant 3.",
        marks=("inferred",),
    ),
)


# What its conclusions say beyond its formulas, and its acceleration by the model ------------------

DOUBLE = 2 * R4 / R5 * phi1

CONCLUSION_ROWS = (
    PRINT.claim(
        "conclusion 2, acceleration",
        NotCheckable(
            "the text at hand has no formula, graph or value of an acceleration; its abstract "
            "names only the analogue of the speed and the position function"
        ),
    ),
    PRINT.claim(
        "conclusion 2, required transfer functions",
        NotCheckable("the text at hand does not say which transfer functions are required"),
    ),
    PRINT.claim(
        "conclusion 1, compactness",
        NotCheckable("the text at hand has no size, mass or force of either mechanism"),
    ),
    ours(
        "acceleration by the model",
        r"\varphi_3''=\frac{4E(1-E^2)\sin2\varphi_1}{(1+E^2-2E\cos2\varphi_1)^2},\quad "
        r"E=\frac{e_1+e_2}{1+e_1e_2},\quad\varphi_3''=\frac{R_4^2}{R_5^2}\cdot"
        r"\frac{4e_2(1-e_2^2)\sin x}{(1+e_2^2-2e_2\cos x)^2},\ x=2\frac{R_4}{R_5}\varphi_1",
        all_of(
            Equality(
                4 * e * (1 - e**2) * sp.sin(2 * phi1) / (1 + e**2 - 2 * e * COS_4) ** 2,
                sp.diff(ratio_of_one(e), phi1),
            ),
            Equality(
                (R4 / R5) ** 2
                * 4
                * e2
                * (1 - e2**2)
                * sp.sin(DOUBLE)
                / (1 + e2**2 - 2 * e2 * sp.cos(DOUBLE)) ** 2,
                sp.diff(ratio_with_cylinders_45, phi1),
            ),
        ),
        note="First for two oval pairs, then for a cylindrical pair 4-5. The output is counted "
        "with the carrier.",
        marks=("inferred",),
    ),
)


# What follows for its own numbers and conclusions -------------------------------------------------

NEAR_REST = sp.Rational("0.01")
DWELL = with_cylinders(2 * R5 / R4 * sp.atan(edge), 3).subs(eta, NEAR_REST)
MOVED = with_cylinders(position_45, 3)

CONSEQUENCES = (
    ours(
        "near rest of variant 3",
        r"|\varphi_3'|\le0.01\text{ over }10.2^\circ\text{ of the carrier, in which the output "
        r"turns by }0.034^\circ",
        all_of(
            PrintedNumber("10.2", DWELL * 180 / sp.pi),
            PrintedNumber(
                "-0.034",
                (MOVED.subs(phi1, DWELL_3 + DWELL / 2) - MOVED.subs(phi1, DWELL_3 - DWELL / 2))
                * 180
                / sp.pi,
            ),
        ),
        note="Variant 3, called intermittent, rests only at single points; around each of them, "
        "three times in a turn of the carrier, the ratio stays below a hundredth over this angle. "
        "The output then turns by less than half a step of the encoder, 0.088°: its reading "
        "changes by one step at most.",
        marks=("consequence", "inferred"),
    ),
    ours(
        "Table 2, scatter and two encoders",
        r"u\sqrt n=2.38^\circ,\ 0.55^\circ,\ 1.61^\circ,\ 2.08^\circ,\quad "
        r"u\sqrt n<M\sqrt{\tfrac n{n-1}},\quad "
        r"M=1.08^\circ(1+\max|\varphi_3'|)=2.43^\circ,\ 1.62^\circ,\ 2.43^\circ,\ "
        r"2.88^\circ,\quad\max|\varphi_3'|=1.25,\ 0.50,\ 1.25,\ 1.67",
        all_of(
            *rounded(
                ("2.38", "0.55", "1.61", "2.08"),
                (line.implied_scatter for line in READINGS.values()),
            ),
            *rounded(("2.43", "1.62", "2.43", "2.88"), LIMITS.values()),
            *(
                less(line.least_scatter, line.scatter_within(LIMITS[variant]))
                for variant, line in READINGS.items()
            ),
            *(
                statement
                for variant, printed in enumerate(("1.25", "0.50", "1.25", "1.67"), start=1)
                for statement in (
                    PrintedNumber(printed, GAINS[variant]),
                    not_above(-GAINS[variant], RATIOS[variant]),
                    not_above(RATIOS[variant], GAINS[variant]),
                )
            ),
        ),
        note="If u belongs to the mean, two encoders within 0.3 % of 360° may explain the scatter "
        "of single errors, whatever offset manufacture adds. In variant 1 both would have to be "
        "near their limits all the time: u at the lower end of its rounding gives 2.315°, the "
        "bound is 2.437°.",
        marks=("inferred", "consequence"),
    ),
    _readings.if_u_is_s(
        "Table 2",
        READINGS,
        halves=("0.027", "0.006", "0.015", "0.022"),
        distances=("57", "12", "170", "50"),
    ),
)

ROWS = (*MEASUREMENT_ROWS, *CONCLUSION_ROWS, *CONSEQUENCES)
