"""What two papers print of one test rig: its encoders, tables of mean errors and intervals."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sympy import Abs, Expr, Interval, Le, Rational, oo, sqrt, symbols

from mechproof.record import (
    LENGTH,
    Claim,
    Completion,
    Completions,
    Conjunction,
    Datum,
    Definition,
    Holds,
    PrintedNumber,
    Variable,
)

from ._metrology import student_coverage
from ._relations import less

POSITIVE = Interval.open(0, oo)

# The encoders -----------------------------------------------------------------------------------

RESOLUTION = Rational(360, 4096)
LINEARITY = Rational("0.003")
READING_LINEARITY = LINEARITY * 90
FULL_SCALE_LINEARITY = LINEARITY * 360
linearity, read_time, output, diameter, millimetre = symbols(
    "linearity t_read V_out d_encoder mm", positive=True
)

ENCODER_VARIABLES = (
    Variable(linearity, "linearity of the encoder", within=POSITIVE),
    Variable(read_time, "read time of the encoder, s", within=POSITIVE),
    Variable(output, "output range of the encoder, V", within=POSITIVE),
    Variable(diameter, "diameter of the encoder", LENGTH, POSITIVE),
    Variable(millimetre, "the unit of length", LENGTH, POSITIVE),
)


def two_encoders(gain: Expr) -> Expr:
    """Return the largest error of an output angle compared with the model, in degrees.

    Two encoders that keep 0.3 % of 360 degrees: the one at the output, and the one at the input
    times the largest ratio, `gain`.
    """
    return FULL_SCALE_LINEARITY * (1 + gain)


def resolution_row(table: str, note: str = "", marks: tuple[str, ...] = ()) -> Datum:
    """State the step of a 12-bit encoder."""
    return Datum(
        f"{table}, resolution",
        r"360^\circ/4096\approx0.088^\circ",
        PrintedNumber("0.088", RESOLUTION),
        note=note,
        marks=marks,
    )


def encoder_rows(table: str) -> tuple[Datum, ...]:
    """List what else is printed of the encoder; no formula uses it."""
    unused = "A datum; no formula of the paper uses it."
    open_base = (
        "A datum; not said of what the percentage is taken: 1.08 deg of a full scale of 360 deg."
    )
    data = (
        ("linearity", r"\text{linearity }0.3\,\%", Definition(linearity, LINEARITY), open_base),
        ("read time", r"0.6\text{ ms}", Definition(read_time, Rational("0.0006")), unused),
        ("output", r"0\dots5\text{ V}", Definition(output, Rational(5)), unused),
        ("diameter", r"22\text{ mm}", Definition(diameter, 22 * millimetre), unused),
    )
    return tuple(Datum(f"{table}, {what}", latex, says, note) for what, latex, says, note in data)


# The readings -----------------------------------------------------------------------------------


@dataclass(frozen=True)
class Readings:
    """A line of the table of results: number, mean error and its u, to `step` and 0.01 degree."""

    count: int
    mean: Rational
    uncertainty: Rational
    step: Rational

    @property
    def implied_scatter(self) -> Expr:
        """Return s = u sqrt(n), the scatter of single readings if u is that of the mean."""
        return self.uncertainty * sqrt(self.count)

    @property
    def least_scatter(self) -> Expr:
        """Return the smallest s = u sqrt(n) of single readings that rounds to the printed u."""
        return (self.uncertainty - Rational("0.005")) * sqrt(self.count)

    def scatter_within(self, limit: Expr) -> Expr:
        """Return the largest s of readings in -limit ... limit with this mean.

        The sum of (q_k - mean)^2 is at most n (limit - mean) (mean + limit); the mean is taken at
        the end of its rounding that is nearer to zero.
        """
        mean = abs(self.mean) - self.step / 2
        return sqrt((limit**2 - mean**2) * Rational(self.count, self.count - 1))


def means_within(readings: Mapping[int, Readings], limits: Mapping[int, Expr]) -> Conjunction:
    """State |mean error| <= limit for the variants of `limits`."""
    return Conjunction(
        tuple(
            Holds(Le(Abs(readings[variant].mean), limit, evaluate=False))
            for variant, limit in limits.items()
        )
    )


COVERAGE_OF_MEAN = (
    "Of the mean error: a confidence level is that of an estimate. Coverage of the factor 2 by "
    "Student's t, normal observations assumed."
)


def coverage_row(variant: int, count: int, note: str, marks: tuple[str, ...] = ()) -> Datum:
    """Recompute the level of the factor 2 for the mean of `count` readings of one variant."""
    return Datum(
        f"95 %, variant {variant}",
        rf"\text{{the 95 \% interval is }}\bar q\pm 2u,\ n={count}",
        PrintedNumber("95", student_coverage(count, Rational(2))),
        note=note,
        marks=marks,
    )


def coverage_of_errors(count: int) -> Expr:
    """Return how many per cent of single errors lie within 2 u, u that of the mean of `count`."""
    return student_coverage(count, 2 / sqrt(count + 1))


def adequacy_row(
    readings: Mapping[int, Readings], gains: Mapping[int, Expr], failing: str
) -> Claim:
    """Judge the measured functions by two criteria, the same in both papers."""
    return Claim(
        "measured functions adequate",
        r"\text{the measured functions of all variants are adequate to the model}",
        Completions(
            "the criterion of adequacy",
            Completion(
                "criterion of adequacy: the 95 % interval of the mean error contains 0",
                means_within(readings, {v: 2 * r.uncertainty for v, r in readings.items()}),
            ),
            Completion(
                "criterion of adequacy: the mean error stays within what two encoders of 0.3 % of "
                "360 deg allow, 1.08 deg (1 + max |phi3'|)",
                means_within(readings, {v: two_encoders(gain) for v, gain in gains.items()}),
            ),
        ),
        note=f"No criterion and no readings are printed; {failing} the first criterion.",
        marks=("inferred",),
    )


def beyond_encoders(readings: Mapping[int, Readings], limits: Mapping[int, Expr]) -> Conjunction:
    """State that errors within the limits cannot scatter as the readings of these variants do."""
    return Conjunction(
        tuple(
            less(readings[v].scatter_within(limit), readings[v].least_scatter)
            for v, limit in limits.items()
        )
    )
