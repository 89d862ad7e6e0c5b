"""The motion of an output in time: its angle and derivatives, by the chain rule.

The carrier's derivatives are taken from samples or from a function.

>>> import math
>>> from mechproof import EllipticPlanetary
>>> drive = EllipticPlanetary.published(2)
>>> motion = drive.at(0.5, speed_rpm=120)
>>> print(f"{motion.speed:.3f} rad/s = {motion.speed_rpm:.1f} rpm")
36.543 rad/s = 349.0 rpm
"""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import ArrayLike, NDArray

from mechproof.arguments.array_checks import check_array
from mechproof.arguments.scalars import refuse, require
from mechproof.mechanisms.pointwise_types import pointwise_in_angles
from mechproof.mechanisms.units import Units, is_quantity
from mechproof.tools.notebook import Displayed

Floats = NDArray[np.float64]
# One turn per minute in each unit.
RAD_PER_S, DEGREES_PER_S = math.tau / 60, 6.0


UNITS = {"angle": "rad", "speed": "rad/s", "acceleration": "rad/s**2", "jerk": "rad/s**3"}


class Motion(NamedTuple):
    """Angle (rad), speed (rad/s), acceleration (rad/s²) and jerk (rad/s³), arrays of one shape."""

    angle: Any
    speed: Any
    acceleration: Any
    jerk: Any

    @property
    def speed_rpm(self) -> Any:
        """The speed in turns per minute."""
        return self.speed.to("rpm") if is_quantity(self.speed) else self.speed / RAD_PER_S


class MotionInDegrees(Motion):
    """Angle (°), speed (°/s), acceleration (°/s²) and jerk (°/s³), arrays of one shape."""

    @property
    def speed_rpm(self) -> Any:
        """The speed in turns per minute."""
        return self.speed / DEGREES_PER_S


class Drive(Displayed):
    """A mechanism whose output angle phi3 is a function of the carrier's angle phi1."""

    @abstractmethod
    def _call(self, name: str, phi1: ArrayLike) -> Any:
        """Return the values of a kernel of the mechanism."""

    @pointwise_in_angles
    def ratio(self, phi1: ArrayLike, *, degrees: bool = False) -> Any:
        """Return d phi3/d phi1 at the carrier angles `phi1`; see the kernels of the mechanism."""
        return self._give("ratio", phi1, "1", degrees)

    @pointwise_in_angles
    def position(self, phi1: ArrayLike, *, degrees: bool = False) -> Any:
        """Return the output angles phi3(phi1), continuous over any number of turns."""
        return self._give("position", phi1, "rad", degrees)

    @pointwise_in_angles
    def acceleration(self, phi1: ArrayLike, *, degrees: bool = False) -> Any:
        """Return d ratio/d phi1 at the carrier angles `phi1`."""
        return self._give("acceleration", phi1, "1/rad", degrees)

    @pointwise_in_angles
    def jerk(self, phi1: ArrayLike, *, degrees: bool = False) -> Any:
        """Return d acceleration/d phi1 at the carrier angles `phi1`."""
        return self._give("jerk", phi1, "1/rad**2", degrees)

    def _give(self, name: str, phi1: ArrayLike, unit: str, degrees: bool) -> Any:
        units = Units(degrees)
        return units.give(self._call(name, units.take("phi1", phi1, "rad")), unit)

    def at(
        self,
        phi1: ArrayLike,
        speed: ArrayLike | None = None,
        acceleration: ArrayLike = 0.0,
        jerk: ArrayLike = 0.0,
        *,
        speed_rpm: ArrayLike | None = None,
        degrees: bool = False,
    ) -> Motion:
        """Return the motion of the output for the given position and motion of the carrier.

        Parameters
        ----------
        phi1 : array_like
            Carrier angle (rad).
        speed : array_like
            Speed of the carrier (rad/s).
        acceleration, jerk : array_like, optional
            Acceleration and jerk of the carrier (rad/s², rad/s³), zero by default.
        speed_rpm : array_like
            Turns of the carrier per minute, instead of `speed`.
        degrees : bool
            Whether all angles, including those in speeds, are in degrees.

        Returns
        -------
        Motion
            Motion of the output, in the broadcast shape of the arguments; NaN where one is NaN.

        Raises
        ------
        TypeError, ValueError
            If not exactly one speed is given, or an argument is not an array of real numbers or has
            the wrong dimension.

        Notes
        -----
        With i, a, j the ratio and its derivatives by phi1, and w, w', w'' the carrier's speed and
        its derivatives by time: speed i w, acceleration i w' + a w², jerk i w'' + 3 a w w' + j w³.
        Each term has the accuracy of its kernel plus a rounding for each product; where terms
        cancel, the error is relative to the largest.

        """
        if (speed is None) == (speed_rpm is None):
            allowed = f"give exactly one of speed and speed_rpm = {speed_rpm!r}"
            refuse("speed", speed, allowed, TypeError)
        units = Units(degrees)
        if speed is None:
            speed = check_array("speed_rpm", speed_rpm) * (DEGREES_PER_S if degrees else RAD_PER_S)
        given = {"phi1": phi1, "speed": speed, "acceleration": acceleration, "jerk": jerk}
        taken = (
            check_array(name, units.take(name, value, unit))
            for (name, value), unit in zip(given.items(), UNITS.values(), strict=True)
        )
        return self._chain(units, *taken)

    def run(
        self,
        t: ArrayLike,
        phi1: ArrayLike | Callable[[Floats], ArrayLike],
        *,
        degrees: bool = False,
    ) -> Motion:
        """Return the motion of the output while the carrier's angle is a function of time.

        Parameters
        ----------
        t : array_like
            Times (s). For samples: one axis, increasing, six or more.
        phi1 : array_like or function
            Carrier angles (rad): samples at `t`, interpolated by a quintic spline, or a function of
            an array of times (s) that returns an array of the same shape.
        degrees : bool
            Whether all angles, including those in speeds, are in degrees.

        Returns
        -------
        Motion
            Motion of the output at `t`. NaN where a function is NaN, or has no such derivative, or
            none that could be found to 1e-6 of its largest, or of 1 rad/s, 1 rad/s², 1 rad/s³.

        Raises
        ------
        TypeError, ValueError
            If `t` or `phi1` is not an array of real numbers, or the samples are too few, not
            increasing in time, not finite or not as many as the times.

        Notes
        -----
        For samples, the carrier's speed, acceleration and jerk are those of the spline. For a
        smooth motion they are off by the third to fifth power of the sample spacing, and by more
        within a few samples of the ends; noise is not smoothed. For a function, they come from
        polynomials of degree 12 through its values around each time, within 2⁻²⁰ s to 32 s on both
        sides: those with the smallest last coefficients and rounding errors. Polynomials through
        places where the function is NaN are not used.

        """
        units = Units(degrees)
        times = check_array("t", units.take("t", t, "s"))
        if callable(phi1):
            function = phi1
            moved = differentiate(lambda at: units.take("phi1(t)", function(at), "rad"), times)
        else:
            moved = interpolate(units.take("phi1", phi1, "rad"), times)
        return self._chain(units, *moved)

    def _chain(
        self, units: Units, phi1: Floats, omega: Floats, alpha: Floats, jerk: Floats
    ) -> Motion:
        phi1, omega, alpha, jerk = np.broadcast_arrays(phi1, omega, alpha, jerk)
        ratio, slope, bend = self.ratio(phi1), self.acceleration(phi1), self.jerk(phi1)
        found = Motion(
            self.position(phi1),
            ratio * omega,
            ratio * alpha + slope * omega**2,
            ratio * jerk + 3 * slope * omega * alpha + bend * omega**3,
        )
        given = units.give_fields(found, UNITS)
        return MotionInDegrees(*given) if units.degrees else given


DEGREE = 5
# Polynomials through values at 13 Chebyshev points of windows of these half widths (s).
POINTS = 13
WIDTHS = tuple(2.0**power for power in range(5, -21, -1))
FOUND = 1e-6
# Number of times whose windows are in memory at once.
BLOCK = 4096
EPS = float(np.finfo(float).eps)


def interpolate(phi1: ArrayLike, t: Floats) -> Floats:
    """Return samples and their first three derivatives, by a quintic spline."""
    from scipy.interpolate import make_interp_spline

    angles = check_array("phi1", phi1)
    require(t.ndim == 1 and t.size > DEGREE, "t", t, f"must be {DEGREE + 1} or more on one axis")
    require(angles.shape == t.shape, "phi1", angles, f"must be as many as the times, {t.size}")
    require(np.isfinite(angles).all(), "phi1", angles, "must be finite")
    require((np.diff(t) > 0).all() and np.isfinite(t).all(), "t", t, "must be finite and increase")
    spline = make_interp_spline(t, angles, k=DEGREE)
    return np.array([angles, *(spline(t, order) for order in (1, 2, 3))])


def differentiate(phi1: Callable[[Floats], ArrayLike], t: Floats) -> Floats:
    """Return values of a function and its first three derivatives, NaN where none are found."""
    values = _call(phi1, t)
    flat = t.ravel()
    blocks = [flat[start : start + BLOCK] for start in range(0, flat.size, BLOCK)]
    found = [_search(phi1, block) for block in blocks]
    derivatives, errors = (
        np.concatenate([pair[part] for pair in found], axis=1) if found else np.empty((3, 0))
        for part in (0, 1)
    )
    size = np.abs(derivatives, where=np.isfinite(derivatives), out=np.zeros_like(derivatives))
    allowed = FOUND * np.maximum(size.max(axis=1, keepdims=True, initial=0.0), 1.0)
    derivatives[~(errors <= allowed)] = np.nan
    return np.concatenate([values[None], derivatives.reshape(3, *t.shape)])


def _call(phi1: Callable[[Floats], ArrayLike], t: Floats) -> Floats:
    with np.errstate(invalid="ignore", divide="ignore"):
        values = check_array("phi1(t)", phi1(t))
    require(values.shape == t.shape, "phi1(t)", values, f"must have the shape {t.shape} of t")
    return values


def _search(phi1: Callable[[Floats], ArrayLike], t: Floats) -> tuple[Floats, Floats]:
    """Return the derivatives of three orders with the least estimated errors, and these estimates.

    The truncation error is estimated by the last two coefficients of the polynomial, and that of a
    derivative by these times a power of the degree; rounding errors are added.
    """
    nodes, last, weights = _weights()
    best, least = np.full((3, t.size), np.nan), np.full((3, t.size), np.inf)
    orders = np.arange(1, 4)[:, None]
    rounded = EPS * np.abs(weights).sum(axis=1, keepdims=True)
    for width in WIDTHS:
        values = _call(phi1, t[:, None] + width * nodes).T
        unseen = np.abs(last @ values).sum(axis=0) * float(POINTS - 1) ** orders
        error = (unseen + rounded * np.abs(values).max(axis=0)) / width**orders
        better = error < least
        best = np.where(better, (weights @ values) / width**orders, best)
        least = np.where(better, error, least)
    return best, least


@cache
def _weights() -> tuple[Floats, Floats, Floats]:
    """Return nodes, and matrices from values there to the last coefficients and the derivatives."""
    nodes = chebyshev.chebpts1(POINTS)
    coefficients = np.linalg.inv(chebyshev.chebvander(nodes, POINTS - 1))
    at_zero = [
        [chebyshev.chebval(0.0, chebyshev.chebder(row, order)) for row in np.eye(POINTS)]
        for order in (1, 2, 3)
    ]
    found = nodes, coefficients[-2:], np.array(at_zero) @ coefficients
    nodes, last, weights = (np.asarray(part, np.float64) for part in found)
    return nodes, last, weights
