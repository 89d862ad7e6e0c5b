"""Measured positions in the words of the GUM (JCGM 100).

Type A evaluation of readings, type B parts, the combined standard uncertainty with its
effective degrees of freedom, coverage intervals, and the two usual ways to print a result:

>>> result = Estimate(0.68, 0.28, degrees_of_freedom=191, unit="°")
>>> print(result)
0.68(28)°
>>> print(result.expand(2))
0.68° ± 0.56° (k = 2)
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from mechproof.measurement_estimate import (
    CoverageInterval,
    Estimate,
    check_degrees_of_freedom,
    check_uncertainty,
)

__all__ = [
    "CoverageInterval",
    "Estimate",
    "Mechanism",
    "TypeA",
    "TypeB",
    "combine",
    "evaluate_position_errors",
    "evaluate_type_a",
    "position_errors",
    "wrap_angle",
]


class Mechanism(Protocol):
    """Anything with a vectorised position function, in radians."""

    def position(self, phi1: Any, /) -> Any:
        """Return the output angle at the continuous input angle `phi1`."""


@dataclass(frozen=True)
class TypeA:
    """Type A evaluation of independent readings (GUM 4.2).

    `standard_deviation` is the experimental one of a single reading (divisor n - 1).
    """

    mean: float
    standard_deviation: float
    count: int

    @property
    def uncertainty(self) -> float:
        """Standard uncertainty of the mean, s/√n."""
        return self.standard_deviation / math.sqrt(self.count)

    @property
    def degrees_of_freedom(self) -> float:
        """Return n - 1."""
        return self.count - 1


@dataclass(frozen=True)
class TypeB:
    """A part of the uncertainty known by other means than readings (GUM 4.3)."""

    uncertainty: float
    degrees_of_freedom: float = math.inf

    def __post_init__(self) -> None:
        """Check the uncertainty and its degrees of freedom."""
        check_uncertainty("uncertainty", self.uncertainty)
        check_degrees_of_freedom(self.degrees_of_freedom)

    @classmethod
    def rectangular(cls, half_width: float) -> TypeB:
        """Return the part of an error that lies anywhere within ± half_width (GUM 4.3.7)."""
        check_uncertainty("half_width", half_width)
        return cls(half_width / math.sqrt(3))

    @classmethod
    def from_resolution(cls, resolution: float) -> TypeB:
        """Return the part of an indication with this step: resolution/√12 (GUM F.2.2.1)."""
        check_uncertainty("resolution", resolution)
        return cls(resolution / math.sqrt(12))


def evaluate_type_a(readings: ArrayLike) -> TypeA:
    """Evaluate n ≥ 2 independent readings: mean, experimental standard deviation, count.

    Equations (13)-(16) of Prikhodko et al. 2024 (elliptic_planetary); GUM 4.2.1-4.2.3.
    `readings` is one-dimensional and real. A NaN reading makes both results NaN. Other shapes,
    fewer than two readings and infinite readings raise ValueError, other types TypeError.

    A large common offset costs no digits, because the deviations are centred twice. The tests
    hold the standard deviation to 16 eps (n up to 1e5), and the mean to 1 ulp where the readings
    lie within a factor of two of each other.
    """
    values = _as_readings(readings)
    rounded_mean = np.mean(values)
    deviations = values - rounded_mean
    correction = np.mean(deviations)
    spread = _root_mean_square(deviations - correction, values.size - 1)
    return TypeA(float(rounded_mean + correction), spread, values.size)


def _as_readings(readings: ArrayLike) -> NDArray[np.float64]:
    if isinstance(readings, np.ma.MaskedArray):
        raise TypeError("readings is a masked array: give readings.compressed()")
    values = np.asarray(readings)
    if values.ndim != 1 or values.size < 2:
        raise ValueError(
            f"readings has shape {values.shape}: one dimension of at least two is needed"
        )
    if values.dtype.kind not in "fiu":
        raise TypeError(f"readings has dtype {values.dtype}: real numbers are needed")
    values = values.astype(np.float64)
    if np.isinf(values).any():
        index = int(np.argmax(np.isinf(values)))
        raise ValueError(f"readings[{index}] = {values[index]}: must be finite or NaN")
    return values


def _root_mean_square(deviations: NDArray[np.float64], divisor: int) -> float:
    # Scaled by the largest, so that no square leaves the range of a double.
    largest = np.max(np.abs(deviations))
    if largest == 0:
        return 0.0
    return float(largest * np.sqrt(np.sum((deviations / largest) ** 2) / divisor))


def combine(type_a: TypeA, *type_b: TypeB, unit: str = "") -> Estimate:
    """Combine the readings' mean with type B parts that all add to it with weight one.

    The uncertainties add in squares (GUM 5.1.2, independent parts); the effective degrees of
    freedom follow Welch and Satterthwaite (GUM G.4.1). Where every part is zero, the
    degrees of freedom are the smallest of the parts'.
    """
    parts: tuple[TypeA | TypeB, ...] = (type_a, *type_b)
    total = math.hypot(*(part.uncertainty for part in parts))
    if total == 0:
        freedom = min(part.degrees_of_freedom for part in parts)
    else:
        loss = sum((part.uncertainty / total) ** 4 / part.degrees_of_freedom for part in parts)
        freedom = 1 / loss if loss else math.inf
    return Estimate(type_a.mean, total, freedom, unit)


def wrap_angle(angle: ArrayLike) -> Any:
    """Return `angle` less whole turns, in [-π, π]; radians, any shape, NaN in, NaN out.

    The turn is the true 2π, not the double next to it: the tests hold 12 eps, relative to the
    result (three library calls of at most 4 ulp, none of which is amplified).
    """
    return np.arctan2(np.sin(angle), np.cos(angle))


def position_errors(mechanism: Mechanism, phi1: ArrayLike, measured: ArrayLike) -> Any:
    """Return measured minus calculated output angle, on the right turn, in [-π, π].

    `phi1` is the continuous input angle (whole turns count), `measured` the reading of the
    output's encoder, on any turn; both in radians, broadcast against each other. NaN in, NaN
    out. A mechanism without `position` raises TypeError; a position of another shape than
    `phi1`, ValueError.
    """
    if not callable(getattr(mechanism, "position", None)):
        raise TypeError(f"mechanism = {mechanism!r}: needs a method position(phi1)")
    calculated = mechanism.position(phi1)
    if np.shape(calculated) != np.shape(phi1):
        raise ValueError(
            f"mechanism.position gave shape {np.shape(calculated)} "
            f"for phi1 of shape {np.shape(phi1)}: must be the same"
        )
    return wrap_angle(np.subtract(measured, calculated))


def evaluate_position_errors(
    mechanism: Mechanism,
    phi1: ArrayLike,
    measured: ArrayLike,
    *,
    resolution: float,
    type_b: Iterable[TypeB] = (),
) -> Estimate:
    """Return the mean position error in radians with its combined standard uncertainty.

    Type A from the scatter of the errors; type B from the step `resolution` of the output's
    encoder (radians) and from any further parts. Both are taken as common to all readings, so
    averaging does not lower them. Arguments as in `position_errors`, one-dimensional.

    Errors known only to a whole turn have a mean only if they keep within half a turn of
    each other; a wider spread (a wrong zero of the encoder, a lost turn of phi1) raises ValueError.
    """
    errors = position_errors(mechanism, phi1, measured)
    result = evaluate_type_a(errors)
    spread = np.ptp(errors)
    if spread > np.pi:
        raise ValueError(
            f"measured: the position errors spread over {spread:.3g} rad, more than half a turn, "
            "so their mean is not defined; set the encoder's zero near that of the mechanism"
        )
    return combine(result, TypeB.from_resolution(resolution), *type_b, unit="rad")
