"""Prints of two papers on the same test rig: its encoders, tables of mean errors and intervals."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sympy import Abs, Expr, Rational, erf, pi, sqrt, symbols

from mechproof.document.transcription import Transcription
from mechproof.record import *

from ._metrology import POSITIVE, student_coverage

DEGREE = pi / 180
# The rows that are findings of both papers.
INTERVAL, ADEQUACY = "95 % interval", "measured functions adequate"

# The encoders -----------------------------------------------------------------------------------

RESOLUTION = Rational(360, 4096)
FULL_SCALE_LINEARITY = Rational("0.003") * 360
resolution, linearity, read_time, output, diameter, millimetre = symbols(
    "resolution linearity t_read V_out d_encoder mm", positive=True
)

ENCODER_VARIABLES = (
    Variable(resolution, "resolution of the encoder, degrees", within=POSITIVE),
    Variable(linearity, "linearity of the encoder", within=POSITIVE),
    Variable(read_time, "read time of the encoder, s", within=POSITIVE),
    Variable(output, "output range of the encoder, V", within=POSITIVE),
    Variable(diameter, "diameter of the encoder", LENGTH, POSITIVE),
    Variable(millimetre, "the unit of length", LENGTH, POSITIVE),
)


def two_encoders(gain: Expr) -> Expr:
    """Return the largest error of an output angle compared with the model, in degrees.

    It is that of two encoders with an error of 0.3 % of 360 degrees: the one at the output, and the
    one at the input times the largest ratio, `gain`.
    """
    return FULL_SCALE_LINEARITY * (1 + gain)


def encoder_row(paper: Transcription, table: str) -> Datum:
    """Return the row of what is printed of the encoder, except how its resolution comes about."""
    return paper.datum(
        f"{table}, encoder",
        all_of(
            Definition(resolution, Rational("0.088")),
            Definition(linearity, Rational("0.003")),
            Definition(read_time, Rational("0.0006")),
            Definition(output, Rational(5)),
            Definition(diameter, 22 * millimetre),
        ),
        note="Resolution, linearity, reading speed, output signal, diameter; no formula uses "
        "them. The text at hand does not say what the 0.3 % refers to; of 360° it is 1.08°.",
    )


# The readings -----------------------------------------------------------------------------------


@dataclass(frozen=True)
class Readings:
    """A line of the table of results: number, mean error and its u, to `step` and 0.01 degree."""

    count: int
    mean: Rational
    uncertainty: Rational
    step: Rational

    @property
    def printed(self) -> str:
        """Return n, mean and u as the table prints them, for LaTeX."""
        return rf"{self.count},\ {self.printed_mean}^\circ,\ {float(self.uncertainty):.2f}^\circ"

    @property
    def printed_mean(self) -> str:
        """Return the mean with the decimals of the table."""
        return f"{float(self.mean):.{len(str(self.step.q)) - 1}f}"

    @property
    def implied_scatter(self) -> Expr:
        """Return s = u sqrt(n), the scatter of single readings if u is that of the mean."""
        return self.uncertainty * sqrt(self.count)

    @property
    def least_scatter(self) -> Expr:
        """Return the smallest s = u sqrt(n) of single readings that rounds to the printed u."""
        return (self.uncertainty - Rational("0.005")) * sqrt(self.count)

    def scatter_within(self, limit: Expr) -> Expr:
        """Return the largest s of readings within -limit ... limit of any offset.

        The sum of (q_k - mean)^2 is at most that about the offset, n limit^2.
        """
        return limit * sqrt(Rational(self.count, self.count - 1))


def of_the_mean(count: int) -> Expr:
    """Return the percentage of intervals of 2 u that contain the mean of `count` readings."""
    return student_coverage(count, Rational(2))


def coverage_of_errors(count: int) -> Expr:
    """Return the percentage of single errors within 2 u, where u is that of the mean of `count`."""
    return student_coverage(count, 2 / sqrt(count + 1))


def of_single_errors(count: int) -> Expr:
    """Return the percentage of single errors within 2 s of the mean of `count` readings."""
    return student_coverage(count, 2 * sqrt(Rational(count, count + 1)))


def interval_of_errors(
    paper: Transcription, readings: Mapping[int, Readings], marks: tuple[str, ...] = ()
) -> Claim:
    """Return the claim on the interval: of the errors, as it is called, or of their mean."""
    counts = [line.count for line in readings.values()]
    of_mean = all_of(*(PrintedNumber("95", of_the_mean(count)) for count in counts))
    return paper.claim(
        INTERVAL,
        all_of(*(PrintedNumber("95", coverage_of_errors(count)) for count in counts)),
        readings=(Reading("the interval of the mean of the errors, to which u belongs", of_mean),),
        corrected=paper.mend(INTERVAL, "interval of", "interval of the mean of", of_mean),
        note="Coverage by Student's t, for normal observations. If u is the standard deviation of "
        "single errors, the words are right, but u is not what the preceding formulas make it.",
        marks=(*marks, "inferred"),
    )


def if_u_is_s(
    table: str, readings: Mapping[int, Readings], halves: Sequence[str], distances: Sequence[str]
) -> Claim:
    """State the intervals of the means if u is s, and the means in units of their uncertainty."""
    printed = tuple(zip(readings.values(), halves, distances, strict=True))
    intervals = ",\\ ".join(rf"{line.printed_mean}\pm{half}^\circ" for line, half, _ in printed)
    away = ",\\ ".join(distances)
    return ours(
        f"{table}, if u is s",
        rf"\bar q\pm\tfrac{{2u}}{{\sqrt n}}:\ {intervals},\quad|\bar q|\tfrac{{\sqrt n}}u={away}",
        all_of(
            *(
                statement
                for line, half, distance in printed
                for statement in (
                    PrintedNumber(half, 2 * line.uncertainty / sqrt(line.count)),
                    PrintedNumber(distance, Abs(line.mean) * sqrt(line.count) / line.uncertainty),
                    PrintedNumber("95", of_single_errors(line.count)),
                )
            )
        ),
        note="If the printed u is the standard deviation s of single errors, mean ± 2u does cover "
        "95 % of the errors. These are then the intervals of the means: all four differ from "
        f"zero, by {min(distances, key=int)} to {max(distances, key=int)} of their standard "
        "uncertainties.",
        marks=("consequence", "inferred"),
    )


def table_row(
    table: str,
    equations: str,
    readings: Mapping[int, Readings],
    cites: tuple[str, ...],
    **marks: Any,
) -> Claim:
    """State that a table of results, with its n, means and u shown, cannot be recomputed."""
    values = ";\\ ".join(line.printed for line in readings.values())
    return Claim(
        f"{table} by {equations}",
        rf"\text{{applying equations {equations} to the results, we get the values of {table}: }}"
        rf"n,\ \bar q,\ u=\ {values}",
        NotCheckable("the readings q_k are not in the text at hand"),
        cites=cites,
        **marks,
    )


def adequacy_row(paper: Transcription) -> Claim:
    """State that no calculation decides whether the model is adequate."""
    return paper.claim(
        ADEQUACY,
        NotCheckable("neither a criterion of adequacy nor the readings are in the text at hand"),
    )


def beyond_encoders(readings: Mapping[int, Readings], limits: Mapping[int, Expr]) -> Conjunction:
    """State that errors within the limits cannot scatter as the readings of these variants do."""
    return all_of(
        *(
            less(readings[v].scatter_within(limit), readings[v].least_scatter)
            for v, limit in limits.items()
        )
    )


def interval_finding(
    readings: Mapping[int, Readings], of_mean: str, of_root: str, called: str = "of the errors"
) -> Finding:
    """Return the finding on the interval: its share of single errors, and how wide theirs would be.

    It covers variants 1 and 3.
    """
    costs = (
        cost
        for variant, line in readings.items()
        if variant in (1, 3)
        for cost in (
            Cost(
                f"variant {variant}, share of single errors within mean ± 2u",
                "%",
                printed=Rational(95, 100),
                right=coverage_of_errors(line.count) / 100,
                names=("as called", "by u = s/√n"),
            ),
            Cost(
                f"variant {variant}, half-width for 95 % of single errors",
                "°",
                decimals=2,
                printed=2 * line.uncertainty * DEGREE,
                right=2 * line.implied_scatter * DEGREE,
                names=("2u", "2s = 2u√n"),
            ),
        )
    )
    count = readings[1].count
    return Finding(
        INTERVAL,
        f"By {of_mean} and {of_root} u is the uncertainty of the mean, so mean ± 2u is an interval "
        f"for the mean error. It is called an interval {called}, but covers only 11 to 12 % of "
        f"them. Or the printed u is the standard deviation s, and {of_mean} was not applied to it.",
        costs=tuple(costs),
        weight=Weight.CONCLUSION,
        check=Check(
            f"2u = 2s/√n, which is {{0}} s for n = {count}; by a table of the normal law {{1}} of "
            "the errors lie within ±{0} s, not 0.95.",
            (2 / sqrt(count), erf(sqrt(2) / sqrt(count))),
        ),
    )


def costs_of_mean(readings: Mapping[int, Readings], variants: Sequence[int]) -> tuple[Cost, ...]:
    """Return how far mean errors are from zero, next to what their interval allows."""
    return tuple(
        Cost(
            f"variant {variant}",
            "°",
            decimals=2,
            printed=abs(readings[variant].mean) * DEGREE,
            right=2 * readings[variant].uncertainty * DEGREE,
            names=("mean error", "2u"),
        )
        for variant in variants
    )
