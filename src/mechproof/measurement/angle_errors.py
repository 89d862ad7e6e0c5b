"""Errors of a measured output angle against a mechanism, and their mean with its uncertainty."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.scalars import check_items, require
from mechproof.kernel_support.arrays import as_floats
from mechproof.measurement.estimate import Estimate
from mechproof.measurement.uncertainty import TypeB, combine, evaluate_type_a


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
    parts = check_items("type_b", type_b, None, "must be any number of TypeB")
    errors = position_errors(mechanism, phi1, measured)
    result = evaluate_type_a(errors)
    spread = np.ptp(errors)
    if spread > np.pi:
        raise ValueError(
            f"measured: the position errors spread over {spread:.3g} rad, more than half a turn, "
            "so their mean is not defined; set the encoder's zero near that of the mechanism"
        )
    return combine(result, TypeB.from_resolution(resolution), *parts, unit="rad")
