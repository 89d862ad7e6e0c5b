"""Type A and type B evaluation of measurements, and their combination (GUM, JCGM 100).

Errors of a measured output angle, relative to a mechanism, are evaluated likewise.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from mechproof.arguments.array_checks import check_array
from mechproof.arguments.scalars import (
    check_count,
    check_items,
    check_not_negative,
    check_number,
    refuse,
    require,
)
from mechproof.kernel_support.arrays import as_floats
from mechproof.measurement.estimate import Estimate, check_degrees_of_freedom


@dataclass(frozen=True)
class TypeA:
    """Type A evaluation of independent readings (GUM 4.2).

    `standard_deviation` is the experimental one of a single reading (divisor n - 1).
    """

    mean: float
    standard_deviation: float
    count: int

    def __post_init__(self) -> None:
        """Check the numbers."""
        check_number("mean", self.mean)
        check_not_negative("standard_deviation", self.standard_deviation)
        check_count("count", self.count, least=2)

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
        check_not_negative("uncertainty", self.uncertainty)
        check_degrees_of_freedom(self.degrees_of_freedom)

    @classmethod
    def rectangular(cls, half_width: float) -> TypeB:
        """Return the part due to an error anywhere within ± half_width (GUM 4.3.7)."""
        check_not_negative("half_width", half_width)
        return cls(half_width / math.sqrt(3))

    @classmethod
    def from_resolution(cls, resolution: float) -> TypeB:
        """Return the part due to an indication with this step: resolution/√12 (GUM F.2.2.1)."""
        check_not_negative("resolution", resolution)
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
    values = check_array("readings", readings)
    allowed = f"must be one-dimensional with at least two readings, not shape {values.shape}"
    require(values.ndim == 1 and values.size >= 2, "readings", readings, allowed)
    if np.isinf(values).any():
        index = int(np.argmax(np.isinf(values)))
        refuse(f"readings[{index}]", float(values[index]), "must be finite or NaN")
    return values


def _root_mean_square(deviations: NDArray[np.float64], divisor: int) -> float:
    # Scaled by the largest, so that no square leaves the range of a double.
    largest = np.max(np.abs(deviations))
    if largest == 0:
        return 0.0
    return float(largest * np.sqrt(np.sum((deviations / largest) ** 2) / divisor))


def combine(type_a: TypeA, *type_b: TypeB, unit: str = "") -> Estimate:
    """Combine the readings' mean with type B parts that all add to it with weight one.

    The uncertainties add in quadrature (GUM 5.1.2, independent parts); the effective degrees of
    freedom follow Welch and Satterthwaite (GUM G.4.1). Where every part is zero, the
    degrees of freedom are the smallest of the parts'.
    """
    require(isinstance(type_a, TypeA), "type_a", type_a, "must be a TypeA", TypeError)
    for i, part in enumerate(type_b):
        require(isinstance(part, TypeB), f"type_b[{i}]", part, "must be a TypeB", TypeError)
    parts: tuple[TypeA | TypeB, ...] = (type_a, *type_b)
    total = math.hypot(*(part.uncertainty for part in parts))
    if total == 0:
        freedom = min(part.degrees_of_freedom for part in parts)
    else:
        loss = sum((part.uncertainty / total) ** 4 / part.degrees_of_freedom for part in parts)
        freedom = 1 / loss if loss else math.inf
    return Estimate(type_a.mean, total, freedom, unit)


class Mechanism(Protocol):
    """Anything with a vectorised position function, in radians."""

    def position(self, phi1: Any, /) -> Any:
        """Return the output angle at the continuous input angle `phi1`."""


def wrap_angle(angle: ArrayLike) -> Any:
    """Return `angle` less whole turns, in [-π, π]; radians, any shape, NaN if not finite.

    The turn is the true 2π, not the double next to it: the tests hold 12 eps, relative to the
    result (three library calls of at most 4 ulp, none of which is amplified).
    """
    (angle,) = as_floats("angle", angle)
    with np.errstate(invalid="ignore"):
        return np.arctan2(np.sin(angle), np.cos(angle))


def position_errors(mechanism: Mechanism, phi1: ArrayLike, measured: ArrayLike) -> Any:
    """Return measured minus calculated output angle, on the right turn, in [-π, π].

    `phi1` is the continuous input angle (whole turns count), `measured` the reading of the
    output's encoder, on any turn; both in radians, broadcast against each other. NaN in, NaN
    out. A mechanism without `position` raises TypeError; a position of another shape than
    `phi1`, ValueError.
    """
    is_mechanism = callable(getattr(mechanism, "position", None))
    require(is_mechanism, "mechanism", mechanism, "must have a method position(phi1)", TypeError)
    given, reading = as_floats("phi1 measured", phi1, measured)
    calculated = mechanism.position(phi1)
    if np.shape(calculated) != np.shape(given):
        raise ValueError(
            f"mechanism.position gave shape {np.shape(calculated)} "
            f"for phi1 of shape {np.shape(given)}: must be the same"
        )
    return wrap_angle(np.subtract(reading, calculated))


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
    parts = check_items("type_b", type_b, None, "must be an iterable of TypeB")
    errors = position_errors(mechanism, phi1, measured)
    result = evaluate_type_a(errors)
    spread = np.ptp(errors)
    if spread > np.pi:
        raise ValueError(
            f"measured: the position errors spread over {spread:.3g} rad, more than half a turn, "
            "so their mean is not defined; set the encoder's zero near that of the mechanism"
        )
    return combine(result, TypeB.from_resolution(resolution), *parts, unit="rad")
