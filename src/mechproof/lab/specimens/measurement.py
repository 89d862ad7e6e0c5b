"""The standard deviation of readings: one pass over the sums, two passes, centred twice."""

from __future__ import annotations

import numpy as np
import sympy as sp

from mechproof.lab.specimen import Arguments, Array, Compute, Specimen
from mechproof.lab.subject import PointSet, Study, Table
from mechproof.measurement import evaluate_type_a
from mechproof.record import Argument, Bar, Equality, Form, Paper, Quantity, Variable

READINGS = 12
SERIES = 60
q = sp.IndexedBase("q", real=True)
n = sp.Symbol("n", integer=True, positive=True)
i, j = sp.symbols("i j", integer=True, positive=True)
MEAN = sp.Sum(q[j], (j, 1, n)) / n
VARIANCE = sp.Sum((q[i] - MEAN) ** 2, (i, 1, n)) / (n - 1)
ONE_PASS = (sp.Sum(q[i] ** 2, (i, 1, n)) - sp.Sum(q[i], (i, 1, n)) ** 2 / n) / (n - 1)
DEVIATION = sp.sqrt(VARIANCE)

PAPER = Paper(
    system="measurement",
    citation="GUM (JCGM 100), 4.2.2",
    variables=(
        Variable(q, "readings"),
        Variable(n, "number of readings, at least 2", within=sp.S.Naturals),
    ),
    rows=(),
    quantities=(
        Quantity(
            "standard_deviation",
            "Experimental standard deviation of a single reading.",
            (Argument("readings", (q,), "readings of one quantity"),),
            DEVIATION,
            Form("centred twice", DEVIATION),
            "GUM 4.2.2",
            bar=Bar(16),
        ),
    ),
)


def over_rows(compute: Compute) -> Compute:
    """Apply a function of one series of readings to every row."""
    return lambda rows: np.array([compute(row) for row in np.atleast_2d(rows)])


def one_pass(rows: Array) -> Array:
    """Subtract the square of the sum from the sum of squares."""
    count = rows.shape[-1]
    squares = np.sum(rows**2, axis=-1) - np.sum(rows, axis=-1) ** 2 / count
    return np.asarray(np.sqrt(squares / (count - 1)))


def two_pass(rows: Array) -> Array:
    """Call the standard deviation of NumPy."""
    return np.asarray(np.std(rows, axis=-1, ddof=1))


def readings(rng: np.random.Generator) -> Arguments:
    """Draw series with no offset and with offsets up to 1e12 times their scatter."""
    offset = np.concatenate([np.zeros(10), 10 ** rng.uniform(0, 12, 60)])
    return (rng.normal(size=(len(offset), READINGS)) + offset[:, None],)


def far_readings(rng: np.random.Generator) -> Arguments:
    """Draw series with offsets of 1e8 to 1e15 whose scatter is some last digits of the offset."""
    offset = 10 ** rng.uniform(8, 15, SERIES) * rng.choice([-1, 1], SERIES)
    scatter = np.spacing(np.abs(offset)) * 10 ** rng.uniform(0.5, 4, SERIES)
    return (rng.normal(size=(SERIES, READINGS)) * scatter[:, None] + offset[:, None],)


def tiny_readings(rng: np.random.Generator) -> Arguments:
    """Draw series whose squares underflow, with offsets up to 1e12 times their scatter."""
    (rows,) = readings(rng)
    return (rows * 10 ** rng.uniform(-290, -150, (len(rows), 1)),)


def one_series(count: int) -> Arguments:
    """Return one series of N readings."""
    return (np.random.default_rng(6).normal(1.0, 1e-3, (1, count)),)


TABLE = Table(
    studies={
        "standard_deviation": Study(
            specimens=(
                Specimen(
                    "one pass",
                    one_pass,
                    Equality(ONE_PASS, VARIANCE),
                    note="the variances are compared; two nearly equal sums are subtracted",
                ),
                Specimen("np.std", two_pass, source="peer"),
            ),
            sets=(
                PointSet("offset 0 to 1e12", readings),
                PointSet("offset 1e8 to 1e15, scatter its last digits", far_readings),
                PointSet("squares that underflow", tiny_readings),
            ),
            workloads=(("one series of N readings", one_series),),
        ),
    },
    paper=PAPER,
    kernels={"standard_deviation": over_rows(lambda row: evaluate_type_a(row).standard_deviation)},
)
