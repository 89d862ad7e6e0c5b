"""Tables 1 to 3 of paper 1: its variants, its encoders, and what its readings say."""

from __future__ import annotations

from collections import Counter

from sympy import Add, And, Eq, Expr, Ge, Gt, Integer, Ne, Rational, Sum, diff, sqrt

from mechproof.record import (
    Claim,
    Completion,
    Completions,
    Conjunction,
    Correction,
    Datum,
    Definition,
    Holds,
    PrintedNumber,
)

from .._metrology import estimate_row, n, q, qbar, s2, s2_mean, u_mean, unbiased_row
from .._readings import (
    COVERAGE_OF_MEAN,
    FULL_SCALE_LINEARITY,
    READING_LINEARITY,
    RESOLUTION,
    Readings,
    adequacy_row,
    beyond_encoders,
    coverage_of_errors,
    coverage_row,
    encoder_rows,
    millimetre,
    resolution_row,
    two_encoders,
)
from .._relations import less
from .mechanics import largest, non_uniformity
from .position_rows import of_variant
from .symbols import PRINT, R1, R2, READER, VARIANTS, e, k

TYPE_A_EQUATIONS = EQUATION_13, EQUATION_14, EQUATION_15, EQUATION_16 = (
    PRINT.equation("(13)", defines=(qbar,), note="The mean of the readings; a definition."),
    PRINT.equation("(14)", defines=(s2,), note="Needs n >= 2."),
    PRINT.equation("(15)", defines=(s2_mean,)),
    PRINT.equation(
        "(16)", defines=(u_mean,), note="The GUM's type A standard uncertainty of the mean."
    ),
)
TYPE_A_ROWS = (
    EQUATION_13,
    EQUATION_14,
    unbiased_row("(14)"),
    EQUATION_15,
    estimate_row("(15)"),
    EQUATION_16,
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
    **dict.fromkeys(READINGS, "The half-width is twice the u of table 3."),
    3: "Half-width and u do not fit: either the half-width is to be 0.56 deg, twice the u of table "
    "3, or that u is the misprint and is to be 0.14 deg.",
}


GAINS = {number: of_variant(largest, number) for number in VARIANTS}
LIMITS = {number: two_encoders(gain) for number, gain in GAINS.items()}
LARGEST_MEAN_ERROR = max(abs(line.mean) for line in READINGS.values())


def implied_scatter(number: int) -> tuple[Expr, Expr]:
    """Return s = u sqrt(n) and its largest possible value for errors within +-180 degrees."""
    line = READINGS[number]
    return line.implied_scatter, 180 * sqrt(Rational(line.count, line.count - 1))


def interval_row(number: int, note: str) -> Claim:
    """Recompute the 95 % interval of one variant: its half-width is twice the printed u."""
    line, printed = READINGS[number], HALF_WIDTHS[number]
    mean, right = f"{float(line.mean):.2f}", f"{float(2 * line.uncertainty):.2f}"
    half = f"{float(Rational(printed) / 2):.2f}"
    return Claim(
        f"table 3, interval {number}",
        rf"{mean} \pm {printed}^\circ",
        PrintedNumber(printed, 2 * line.uncertainty),
        note=note,
        corrected=Correction(
            rf"{mean} \pm {right}^\circ\text{{, or }}u={half}^\circ\text{{ in table 3}}",
            Conjunction(
                (
                    PrintedNumber(right, 2 * line.uncertainty),
                    PrintedNumber(half, Rational(printed) / 2),
                )
            ),
        ),
    )


def pairs_of_readings(line: Readings, part: Rational) -> dict[Expr, Expr]:
    """Return readings q_k in pairs about the printed mean, an odd one left at it.

    They are at `part` of the distance from it at which (16) gives the printed u.
    """
    pairs = line.count // 2
    distance = part * line.implied_scatter * sqrt(Rational(line.count - 1, 2 * pairs))
    places = [line.mean + sign * distance for _ in range(pairs) for sign in (1, -1)]
    return {q[number]: place for number, place in enumerate((*places, line.mean)[: line.count], 1)}


def evaluate_type_a(readings: dict[Expr, Expr]) -> tuple[Expr, Expr]:
    """Return what (13)-(16), as printed, make of readings: their mean and its uncertainty."""
    values: dict[Expr, Expr] = {n: Integer(len(readings))}
    frequencies = Counter(readings.values())

    def add_up(summand: Expr, limit: tuple[Expr, ...]) -> Expr:
        index, *_ = limit
        return Add(*(m * summand.xreplace({q[index]: x}) for x, m in frequencies.items()))

    for row in TYPE_A_EQUATIONS:
        symbol, print_ = READER.members(row)
        values[symbol] = print_.replace(Sum, add_up).xreplace(values)
    return values[qbar], values[u_mean]


def table_by_pairs(part: Rational) -> Conjunction:
    """State that (13)-(16) give the printed mean and u for pairs of readings."""
    return Conjunction(
        tuple(
            PrintedNumber(f"{float(printed):.2f}", value)
            for line in READINGS.values()
            for printed, value in zip(
                (line.mean, line.uncertainty),
                evaluate_type_a(pairs_of_readings(line, part)),
                strict=True,
            )
        )
    )


TABLE_CLAIMS = (
    *(
        Datum(
            f"table 1, variant {number}",
            rf"R_1={large}~\mathrm{{mm}},\ R_2={small}~\mathrm{{mm}},\ e={float(eccentricity)}",
            Conjunction(
                (
                    Definition(R1, large * millimetre),
                    Definition(R2, small * millimetre),
                    Definition(e, eccentricity),
                )
            ),
        )
        for number, (large, small, eccentricity) in VARIANTS.items()
    ),
    Claim(
        "table 1, centre distances",
        r"R_1-R_2\text{ is the same in all four variants}",
        Conjunction(
            tuple(
                Holds(Eq(of_variant(R1 - R2, 1), of_variant(R1 - R2, number), evaluate=False))
                for number in (2, 3, 4)
            )
        ),
        note="2a = 50 mm, so one pair of ellipses with a = 25 mm fits every variant of its e.",
        marks=("ours",),
    ),
    Claim(
        "table 1, domain",
        r"0<R_2<R_1,\ 0\le e<1\text{ in all four variants}",
        Conjunction(
            tuple(
                Holds(
                    And(
                        Gt(of_variant(R1 - R2, number), 0, evaluate=False),
                        Ge(of_variant(e, number), 0, evaluate=False),
                        Gt(1 - of_variant(e, number), 0, evaluate=False),
                    )
                )
                for number in VARIANTS
            )
        ),
        marks=("ours",),
    ),
    resolution_row("table 2"),
    *encoder_rows("table 2"),
    *(interval_row(number, INTERVAL_NOTES[number]) for number in READINGS),
    Claim(
        "table 3, u of variant 3 by its interval",
        r"u=\tfrac12\cdot0.28^\circ=0.14^\circ",
        PrintedNumber("0.14", Rational(HALF_WIDTHS[3]) / 2),
        note="One of the two is wrong: the half-width, or the u of table 3, equal to it.",
        marks=("ours",),
    ),
    Claim(
        "table 3 by (13)-(16)",
        r"\text{applying (13)-(16) we obtain table 3}",
        Completions(
            "the readings q_k",
            Completion(
                "the readings q_k: pairs at equal distances from the printed mean that give u",
                table_by_pairs(Rational(1)),
            ),
            Completion(
                "the readings q_k: the same pairs at half that distance",
                table_by_pairs(Rational(1, 2)),
            ),
        ),
        note="The readings are not printed, so neither the mean errors nor u can be recomputed.",
        marks=("inferred",),
    ),
    Claim(
        "table 3, scatter of single readings",
        r"s(q_k)=u\sqrt n",
        Conjunction(
            tuple(
                less(small, large)
                for scatter, limit in map(implied_scatter, READINGS)
                for small, large in ((40 * RESOLUTION, scatter), (scatter, limit))
            )
        ),
        note=(
            "If u is that of the mean, single errors scatter by "
            + ", ".join(f"{float(implied_scatter(number)[0]):.1f}" for number in READINGS)
            + " deg: more than 40 steps of the encoder each, but possible for errors within half "
            "a turn."
        ),
        marks=("ours",),
    ),
    Claim(
        "table 3, scatter and two encoders",
        r"u\sqrt n>\sqrt{\tfrac n{n-1}\left(M^2-\bar q^2\right)},\ "
        r"M=1.08^\circ\,(1+\max\varphi_3')",
        beyond_encoders(READINGS, {number: LIMITS[number] for number in (1, 2, 4)}),
        note=(
            "An encoder at each shaft that keeps 0.3 % of 360 deg allows errors of at most M = "
            + ", ".join(f"{float(limit):.1f}" for limit in LIMITS.values())
            + " deg. Single readings of variants 1, 2 and 4 scatter by more: either the mechanism "
            "or its model is off, or u is no uncertainty of the mean."
        ),
        marks=("ours", "inferred"),
    ),
    Claim(
        "table 3, scatter of variant 3",
        r"u\sqrt n<M",
        less(implied_scatter(3)[0], LIMITS[3]),
        note="Two encoders may explain variant 3.",
        marks=("ours", "inferred"),
    ),
    *(
        coverage_row(number, line.count, COVERAGE_OF_MEAN, ("inferred",))
        for number, line in READINGS.items()
    ),
    Claim(
        "95 %, single errors",
        r"P(|q-\bar q|\le2u)=11\,\%,\ 11\,\%,\ 11\,\%,\ 12\,\%",
        Conjunction(
            tuple(
                PrintedNumber(share, coverage_of_errors(line.count))
                for share, line in zip(("11", "11", "11", "12"), READINGS.values(), strict=True)
            )
        ),
        note="An interval of single errors it is not, as u is the uncertainty of their mean.",
        marks=("ours", "inferred"),
    ),
    Claim(
        "different non-uniformity",
        r"\text{varying the parameters gives position functions of different non-uniformity}",
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
            "(largest - smallest)/mean of the ratio grows with e and with R1/R2 and differs "
            "between any two of the four variants."
        ),
    ),
    adequacy_row(READINGS, GAINS, "variant 3 fails"),
    Claim(
        "inaccurate manufacture",
        r"\text{a large mean error may point to inaccurate manufacture}",
        Completions(
            "what the linearity of 0.3 % refers to",
            Completion(
                "linearity taken of the full scale of 360 deg: the largest mean error exceeds it",
                less(FULL_SCALE_LINEARITY, LARGEST_MEAN_ERROR),
            ),
            Completion(
                "linearity taken of a reading of 90 deg: the largest mean error exceeds it",
                less(READING_LINEARITY, LARGEST_MEAN_ERROR),
            ),
        ),
        note="The encoder alone may explain the mean errors, or may not.",
    ),
)
