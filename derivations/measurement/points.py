"""Points where readings are hard: large common offsets, scatter in the last digits, underflow.

`POINTS` maps each quantity to its point sets by name, `WORKLOADS` is what is timed for N readings.
"""

from collections.abc import Callable, Mapping

import numpy as np

from .._peers import Arguments, Draw

READINGS = 12
SERIES = 60


def readings(rng: np.random.Generator) -> Arguments:
    """Draw series with no offset and with offsets up to 1e12 times their scatter."""
    offset = np.concatenate([np.zeros(10), 10 ** rng.uniform(0, 12, SERIES)])
    return (rng.normal(size=(len(offset), READINGS)) + offset[:, None],)


def far_readings(rng: np.random.Generator) -> Arguments:
    """Draw series with offsets of 1e8 to 1e15 that scatter in the offset's last digits only."""
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


POINTS: Mapping[str, Mapping[str, Draw]] = {
    "standard_deviation": {
        "offset 0 to 1e12": readings,
        "offset 1e8 to 1e15, scatter its last digits": far_readings,
        "squares that underflow": tiny_readings,
    }
}
WORKLOADS: Mapping[str, Mapping[str, Callable[[int], Arguments]]] = {
    "standard_deviation": {"one series of N readings": one_series}
}
