"""The measurement of paper 2: (12)-(15), tables 1 and 2, what the readings say."""

from __future__ import annotations

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

from .._metrology import (
    FULL_SCALE_LINEARITY,
    READING_LINEARITY,
    RESOLUTION,
    coverage_row,
    encoder_rows,
    j,
    linearity_row,
    mean_row,
    n,
    q,
    qbar,
    resolution_row,
    unbiased_row,
    uncertainty_row,
    variance_of_mean_row,
    variance_row,
)
from .._relations import less
from .symbols import highest, index, lowest

# n, mean error, u, printed half-width, all but n in degrees.
READINGS = {
    1: (175, "0.777", "0.18", "0.360"),
    2: (190, "0.035", "0.04", "0.080"),
    3: (214, "1.280", "0.11", "0.220"),
    4: (193, "-0.540", "0.15", "0.300"),
}


def interval_row(variant: int) -> Claim:
    """State the 95 % interval of one variant: the half-width is twice the printed u."""
    _, mean, uncertainty, printed = READINGS[variant]
    return Claim(
        f"table 2, interval {variant}",
        rf"{mean}\pm{printed}^\circ",
        PrintedNumber(printed, 2 * sp.Rational(uncertainty)),
        note="The half-width is 2u with the u of table 2; the mean is the table's.",
    )


def least_scatter(variant: int) -> sp.Expr:
    """Smallest s = u sqrt(n) of single readings that rounds to the printed u."""
    count, _, uncertainty, _ = READINGS[variant]
    return (sp.Rational(uncertainty) - sp.Rational("0.005")) * sp.sqrt(count)


def largest_scatter(variant: int, half_range: sp.Expr) -> sp.Expr:
    """Largest standard deviation of n readings that stay within +- half_range."""
    count = READINGS[variant][0]
    return half_range * sp.sqrt(sp.Rational(count, count - 1))


MEANS = {variant: sp.Rational(row[1]) for variant, row in READINGS.items()}
UNCERTAINTIES = {variant: sp.Rational(row[2]) for variant, row in READINGS.items()}


def means_below(limits: dict[int, sp.Expr]) -> Conjunction:
    """State |mean error| <= limit for the variants of `limits`."""
    return Conjunction(
        tuple(
            Holds(sp.Le(abs(MEANS[variant]), limit, evaluate=False))
            for variant, limit in limits.items()
        )
    )


def scatter_rows() -> tuple[Claim, ...]:
    """State what u says of single readings, beside what the encoder can explain."""
    return (
        Claim(
            "table 2, scatter and resolution",
            r"s(q_k)=u\sqrt n>6\cdot0.088^\circ",
            Conjunction(tuple(less(6 * RESOLUTION, least_scatter(v)) for v in (1, 3, 4))),
            note="In variants 1, 3 and 4 single readings scatter by more than six steps of the "
            "encoder, u taken at the lower end of its rounding; one step spreads 0.088/sqrt(12).",
            marks=("ours",),
        ),
        Claim(
            "table 2, scatter of variant 2",
            r"s(q_k)=u\sqrt n>0.088^\circ",
            less(RESOLUTION, least_scatter(2)),
            marks=("ours",),
        ),
        Claim(
            "largest scatter in a range",
            r"\textstyle\sum(q_k-\bar q)^2=n(M-\bar q)(\bar q-m)-\sum(M-q_k)(q_k-m),\ "
            r"(M-\bar q)(\bar q-m)\le\tfrac14(M-m)^2",
            Conjunction(
                (
                    Equality(
                        sp.Sum((q[index] - MEAN) ** 2, (index, 1, n)),
                        n * (highest - MEAN) * (MEAN - lowest)
                        - sp.Sum((highest - q[index]) * (q[index] - lowest), (index, 1, n)),
                    ),
                    Holds(sp.Ge((highest - lowest) ** 2 / 4, (highest - qbar) * (qbar - lowest))),
                )
            ),
            note="Readings between m and M have s <= (M - m)/2 sqrt(n/(n - 1)).",
            marks=("ours",),
        ),
        Claim(
            "table 2, scatter and one encoder",
            r"u\sqrt n>1.08^\circ\sqrt{n/(n-1)}",
            Conjunction(
                tuple(
                    less(largest_scatter(v, FULL_SCALE_LINEARITY), least_scatter(v))
                    for v in (1, 3, 4)
                )
            ),
            note="Errors within 0.3 % of 360 deg cannot scatter as much as variants 1, 3 and 4.",
            marks=("ours",),
        ),
        Claim(
            "table 2, scatter and two encoders",
            r"u\sqrt n>2.16^\circ\sqrt{n/(n-1)}\text{ in variant 1}",
            less(largest_scatter(1, 2 * FULL_SCALE_LINEARITY), least_scatter(1)),
            note="Not even the difference of two such encoders explains variant 1.",
            marks=("ours",),
        ),
    )


MEAN = sp.Sum(q[j], (j, 1, n)) / n

MEASUREMENT_ROWS: tuple[Row, ...] = (
    mean_row("(12)", marks=("rebuilt",)),
    variance_row("(13)", ("rebuilt",)),
    unbiased_row("(13)"),
    variance_of_mean_row("(14)", r"s^2(q)=s^2(q_k)/n", ("rebuilt",)),
    uncertainty_row(
        "(15)",
        "The right-hand side is lost; by its name the type A standard uncertainty.",
        ("rebuilt", "inferred"),
    ),
    resolution_row("table 1", "A 12-bit encoder is inferred.", ("inferred",)),
    linearity_row(
        "table 1",
        "the mean errors of variants 1, 2 and 4",
        lambda limit: means_below(dict.fromkeys((1, 2, 4), limit)),
    ),
    *encoder_rows("table 1"),
    *(interval_row(variant) for variant in READINGS),
    *(
        coverage_row(
            variant,
            count,
            "Coverage of the factor 2 by Student's t, normal observations assumed.",
        )
        for variant, (count, *_) in READINGS.items()
    ),
    *scatter_rows(),
    Claim(
        "measured functions adequate",
        r"\text{the measured functions of all variants are adequate to the model}",
        Completions(
            Completion(
                "adequate: the 95 % interval of the mean error contains 0, all variants",
                means_below({v: 2 * UNCERTAINTIES[v] for v in READINGS}),
            ),
            Completion(
                "adequate: the mean error stays inside 0.3 % of 360 deg of two encoders",
                means_below(dict.fromkeys(READINGS, 2 * FULL_SCALE_LINEARITY)),
            ),
        ),
        note="No criterion and no readings are printed; variants 1, 3 and 4 fail the first one.",
    ),
    Claim(
        "largest mean errors",
        r"\text{the mean errors of variants 1 and 3 are the large ones}",
        Conjunction(
            tuple(
                less(abs(MEANS[small]), abs(MEANS[large])) for small in (2, 4) for large in (1, 3)
            )
        ),
    ),
    Claim(
        "inaccurate manufacture",
        r"\text{the large mean error of variants 1 and 3 may point to inaccurate manufacture}",
        Completions(
            Completion(
                "linearity of a reading of 90 deg: both mean errors exceed it",
                Conjunction(tuple(less(READING_LINEARITY, abs(MEANS[v])) for v in (1, 3))),
            ),
            Completion(
                "linearity of the full scale of two encoders: both mean errors exceed it",
                Conjunction(tuple(less(2 * FULL_SCALE_LINEARITY, abs(MEANS[v])) for v in (1, 3))),
            ),
        ),
        note="The encoders alone may explain the mean errors, or may not.",
    ),
)
