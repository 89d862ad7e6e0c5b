"""The measurement of paper 2: (12)-(15), tables 1 and 2, what the readings say."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from mechproof.record import (
    Claim,
    Completion,
    Completions,
    Conjunction,
    Equality,
    Holds,
    PrintedNumber,
    Row,
)

from .._metrology import estimate_row, j, n, q, qbar, s2, s2_mean, u_mean, unbiased_row
from .._readings import (
    COVERAGE_OF_MEAN,
    FULL_SCALE_LINEARITY,
    READING_LINEARITY,
    RESOLUTION,
    Readings,
    adequacy_row,
    beyond_encoders,
    coverage_row,
    encoder_rows,
    resolution_row,
    two_encoders,
)
from .._relations import all_of, less, not_above
from .mechanics import PRINT, highest, index, lowest, phi1, ratio_45
from .pairs import fastest
from .variants import ratio_1, with_cylinders

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
        f"table 2, interval {variant}",
        rf"{float(line.mean):.3f}\pm{printed}^\circ",
        PrintedNumber(printed, 2 * line.uncertainty),
        note="The half-width is 2u with the u of table 2; the mean is the table's.",
    )


def beyond(limits: Mapping[int, sp.Expr]) -> Conjunction:
    """State |mean error| > limit for the variants of `limits`."""
    return all_of(*(less(limit, abs(READINGS[variant].mean)) for variant, limit in limits.items()))


def scatter_rows() -> tuple[Claim, ...]:
    """State what u says of single readings, beside what the encoder can explain."""
    return (
        Claim(
            "table 2, scatter and resolution",
            r"s(q_k)=u\sqrt n>6\cdot0.088^\circ",
            all_of(*(less(6 * RESOLUTION, READINGS[v].least_scatter) for v in (1, 3, 4))),
            note="In variants 1, 3 and 4 single readings scatter by more than six steps of the "
            "encoder, u taken at the lower end of its rounding; one step spreads 0.088/sqrt(12).",
            marks=("ours",),
        ),
        Claim(
            "table 2, scatter of variant 2",
            r"s(q_k)=u\sqrt n>0.088^\circ",
            less(RESOLUTION, READINGS[2].least_scatter),
            marks=("ours",),
        ),
        Claim(
            "largest scatter in a range",
            r"\textstyle\sum(q_k-\bar q)^2=n(M-\bar q)(\bar q-m)-\sum(M-q_k)(q_k-m),\ "
            r"(M-\bar q)(\bar q-m)\le\tfrac14(M-m)^2",
            all_of(
                Equality(
                    sp.Sum((q[index] - MEAN) ** 2, (index, 1, n)),
                    n * (highest - MEAN) * (MEAN - lowest)
                    - sp.Sum((highest - q[index]) * (q[index] - lowest), (index, 1, n)),
                ),
                Holds(sp.Ge((highest - lowest) ** 2 / 4, (highest - qbar) * (qbar - lowest))),
            ),
            note="Readings between m and M have s <= (M - m)/2 sqrt(n/(n - 1)).",
            marks=("ours",),
        ),
        Claim(
            "table 2, largest ratios",
            r"\max|\varphi_3'|=1.25,\ 0.50,\ 1.25,\ 1.67",
            all_of(
                *(
                    statement
                    for variant, printed in enumerate(("1.25", "0.50", "1.25", "1.67"), start=1)
                    for statement in (
                        PrintedNumber(printed, GAINS[variant]),
                        not_above(-GAINS[variant], RATIOS[variant]),
                        not_above(RATIOS[variant], GAINS[variant]),
                    )
                )
            ),
            note="By so much an error of the carrier's angle is enlarged in that of the output.",
            marks=("ours", "inferred"),
        ),
        Claim(
            "table 2, scatter and one encoder",
            r"u\sqrt n>\sqrt{\tfrac n{n-1}\left(M^2-\bar q^2\right)},\ "
            r"M=1.08^\circ\max(1,|\varphi_3'|)",
            beyond_encoders(
                READINGS,
                {v: FULL_SCALE_LINEARITY * sp.Max(1, GAINS[v]) for v in (1, 3, 4)},
            ),
            note="Errors within 0.3 % of 360 deg at one shaft, whichever, cannot scatter as much "
            "as variants 1, 3 and 4 about their means.",
            marks=("ours", "inferred"),
        ),
        Claim(
            "table 2, scatter and two encoders",
            r"u\sqrt n>\sqrt{\tfrac n{n-1}\left(M^2-\bar q^2\right)},\ "
            r"M=1.08^\circ(1+\max|\varphi_3'|)\text{ in variant 1}",
            beyond_encoders(READINGS, {1: LIMITS[1]}),
            note="Not even two such encoders explain variant 1: with its mean error the bound is "
            "2.309 deg, u at the lower end of its rounding gives 2.315 deg. Readings about a mean "
            "of zero could scatter by 2.437 deg.",
            marks=("ours", "inferred"),
        ),
        Claim(
            "table 2, scatter of variants 2, 3 and 4",
            r"u\sqrt n<\sqrt{\tfrac n{n-1}\left(M^2-\bar q^2\right)}",
            all_of(
                *(
                    less(READINGS[v].least_scatter, READINGS[v].scatter_within(LIMITS[v]))
                    for v in (2, 3, 4)
                )
            ),
            note="Two such encoders may explain them.",
            marks=("ours", "inferred"),
        ),
    )


MEAN = sp.Sum(q[j], (j, 1, n)) / n

MEASUREMENT_ROWS: tuple[Row, ...] = (
    PRINT.equation("(12)", defines=(qbar,), marks=("rebuilt",)),
    PRINT.equation(
        "(13)",
        note="Needs n >= 2.",
        defines=(s2,),
        marks=("rebuilt",),
    ),
    unbiased_row("(13)"),
    PRINT.equation("(14)", defines=(s2_mean,), marks=("rebuilt",)),
    estimate_row("(14)", ("rebuilt",)),
    PRINT.equation(
        "(15)",
        note="The right-hand side is lost; by its name the type A standard uncertainty.",
        defines=(u_mean,),
        marks=("rebuilt", "inferred"),
    ),
    resolution_row("table 1", "A 12-bit encoder is inferred.", ("inferred",)),
    *encoder_rows("table 1"),
    *(interval_row(variant) for variant in READINGS),
    *(
        coverage_row(
            variant,
            line.count,
            COVERAGE_OF_MEAN,
            ("inferred",),
        )
        for variant, line in READINGS.items()
    ),
    *scatter_rows(),
    adequacy_row(READINGS, GAINS, "variants 1, 3 and 4 fail"),
    Claim(
        "largest mean errors",
        r"\text{the mean errors of variants 1 and 3 are the large ones}",
        all_of(
            *(
                less(abs(READINGS[small].mean), abs(READINGS[large].mean))
                for small in (2, 4)
                for large in (1, 3)
            )
        ),
    ),
    Claim(
        "inaccurate manufacture",
        r"\text{the large mean error of variants 1 and 3 may point to inaccurate manufacture}",
        Completions(
            "what the linearity of 0.3 % refers to",
            Completion(
                "linearity taken of a reading of 90 deg: both mean errors exceed it",
                beyond(dict.fromkeys((1, 3), READING_LINEARITY)),
            ),
            Completion(
                "linearity taken of the full scale of 360 deg: both mean errors exceed what two "
                "encoders allow",
                beyond({variant: LIMITS[variant] for variant in (1, 3)}),
            ),
        ),
        note="The encoders alone may explain the mean errors, or may not.",
    ),
)
