"""Planetary mechanism with two external pairs: oval or cylindrical 4-5, oval 6-3.

Angles are in radians, positive in the direction of the carrier's rotation, and count every turn;
with `degrees=True` they are in degrees, as arguments and as results, and so are those that results
are derived by. Quantities of pint are taken and given back in their units.
At zero a major axis of an oval sun points to the satellite, whose wheels 5 and 6 have theirs at
right angles. Parameters given as integers, fractions, decimals or decimal strings are exact, and
so is then what is said of the kind of motion.

>>> from mechproof import OvalPlanetary
>>> mechanism = OvalPlanetary.published(3)
>>> mechanism.motion().kind
'intermittent'
>>> round(float(mechanism.position(2.0)), 6)
-0.930945
"""

from __future__ import annotations

import math
from dataclasses import InitVar, asdict, dataclass, field
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.scalars import check_real, refuse, require
from mechproof.kernels import oval_planetary as kernels
from mechproof.mechanisms.extremes import PLACES, Extremes
from mechproof.mechanisms.facts import check_domain, choose_published
from mechproof.mechanisms.inversion import FINEST, WIDENING, invert, invert_odd
from mechproof.mechanisms.oval_planetary_motion import (
    ANGLES,
    Motion,
    Number,
    OnePair,
    compose,
    describe_motion,
)
from mechproof.mechanisms.units import Units
from mechproof.notebook import Displayed

__all__ = ["CylindricalPair", "Motion", "OvalPair", "OvalPlanetary"]

# Decimal strings are exact, too; every parameter is kept as a Fraction or a float.
Given = float | Fraction | Decimal | str


@dataclass(frozen=True)
class OvalPair:
    """Pair 4-5 of congruent ovals.

    Parameters
    ----------
    e : real number or decimal string
        Eccentricity of the generating ellipse, 0 <= e < 1.
    mount : real number or decimal string
        Turn of wheel 6 on its shaft (rad), forward from its place in the paper, where the major
        axes of 5 and 6 are at right angles.
    degrees : bool
        Whether the mount is in degrees; no field.

    """

    e: Given
    mount: Given = Fraction(0)
    degrees: InitVar[bool] = field(default=False, kw_only=True)

    def __post_init__(self, degrees: bool) -> None:
        """Check the parameters and keep them exact where they are."""
        units = Units(degrees)
        e, mount = units.take("e", self.e, "1"), self.mount
        if isinstance(mount, str | Decimal | Fraction | int):
            mount = _check_number("mount", mount)
        # No turn at all stays exact.
        if not (isinstance(mount, Fraction) and mount == 0):
            mount = units.take(
                "mount", float(mount) if degrees and isinstance(mount, Fraction) else mount, "rad"
            )
        object.__setattr__(self, "e", _check_size("e", e, kernel_name="e1"))
        object.__setattr__(self, "mount", _check_number("mount", mount))


@dataclass(frozen=True)
class CylindricalPair:
    """Pair 4-5 of cylindrical wheels.

    Parameters
    ----------
    R4, R5 : real number or decimal string
        Radii of the sun 4 and of the satellite's wheel 5 (mm), positive.

    """

    R4: Given
    R5: Given

    def __post_init__(self) -> None:
        """Check the parameters and keep them exact where they are."""
        for name, radius in asdict(self).items():
            object.__setattr__(self, name, _check_size(name, Units().take(name, radius, "mm")))


@dataclass(frozen=True)
class OvalPlanetary(Displayed):
    """A planetary mechanism: carrier in, oval wheel 3 out, sun 4 fixed.

    Parameters
    ----------
    pair : OvalPair or CylindricalPair
        The pair 4-5.
    e2 : real number or decimal string
        Eccentricity of the oval pair 6-3, 0 <= e2 < 1.

    Raises
    ------
    TypeError, ValueError
        If a parameter is not a real number or out of its range; the message names it.

    Notes
    -----
    Source: Prikhodko et al. 2024, equations (1)-(11), with the sign of the mechanics: the
    paper's (10) counts the output's angle against the carrier's direction of rotation.

    """

    pair: OvalPair | CylindricalPair
    e2: Given

    def __post_init__(self) -> None:
        """Check the parameters and keep them exact where they are."""
        if not isinstance(self.pair, OvalPair | CylindricalPair):
            refuse("pair", self.pair, "must be an OvalPair or a CylindricalPair", TypeError)
        object.__setattr__(self, "e2", _check_size("e2", Units().take("e2", self.e2, "1")))

    @classmethod
    def published(cls, variant: int) -> OvalPlanetary:
        """Return variant 1 to 4 of Prikhodko et al. 2024, its parameters exact.

        They are printed with so few digits that the shortest decimal of a double is what is
        printed.
        """
        printed = choose_published(kernels.PUBLISHED, "variant", variant)
        sizes = {name: Fraction(repr(size)) for name, size in printed.items()}
        e2 = sizes.pop("e2")
        return cls(OvalPair(sizes["e1"]) if "e1" in sizes else CylindricalPair(**sizes), e2)

    def ratio(self, phi1: ArrayLike, *, degrees: bool = False) -> Any:
        """Return d phi3/d phi1 at the carrier angles `phi1`; see `kernels.oval_planetary`."""
        units = Units(degrees)
        angles = units.take("phi1", phi1, "rad")
        return units.give(self._call("ratio", angles), "1")

    def position(self, phi1: ArrayLike, *, degrees: bool = False) -> Any:
        """Return the output angles phi3(phi1), continuous over any number of turns."""
        units = Units(degrees)
        angles = units.take("phi1", phi1, "rad")
        return units.give(self._call("position", angles), "rad")

    def acceleration(self, phi1: ArrayLike, *, degrees: bool = False) -> Any:
        """Return d ratio/d phi1 at the carrier angles `phi1`."""
        units = Units(degrees)
        angles = units.take("phi1", phi1, "rad")
        return units.give(self._call("acceleration", angles), "1/rad")

    def extremes(self, *, degrees: bool = False) -> Extremes:
        """Return the largest and the smallest ratio in closed form, and where they occur.

        They are half a period apart; the smallest is at the carrier angle 0 unless wheel 6 is
        mounted at another angle than the paper's. With circles alone the ratio is constant.
        """
        one = self._act_as_one()
        period = math.pi / float(one.rate)
        found = Extremes(
            maximum=float(1 - one.slowest),
            at_maximum=one.phase + period / 2,
            minimum=float(1 - one.fastest),
            at_minimum=one.phase,
            period=period,
        )
        return Units(degrees).give_fields(found, PLACES)

    def motion(self, eta: Given | None = None, *, degrees: bool = False) -> Motion:
        """Return the kind of motion, decided by theorems in the parameters.

        Parameters
        ----------
        eta : real number or decimal string, optional
            |ratio| up to which the output counts as at rest, and |mean ratio| up to which it
            counts as without drift. Zero if left out, which needs exact parameters.

        Returns
        -------
        Motion
            With low and high the extremes of the ratio, the kind is "rest" if both are within
            eta; "reciprocating" if they are beyond it on both sides and the mean is within,
            "pilgrim-step" if the mean is not; "intermittent" if one is within; else "one-way".

        Raises
        ------
        ValueError
            If `eta` is negative, or is left out and a parameter is a float.

        """
        if eta is None:
            require(self._is_exact, "eta", None, f"must be stated, for {self!r} has floats")
        limit = Fraction(0) if eta is None else _check_number("eta", eta)
        require(limit >= 0, "eta", eta, "must not be negative")
        return Units(degrees).give_fields(describe_motion(self._act_as_one(), limit), ANGLES)

    def carrier_angle(self, phi3: ArrayLike, *, degrees: bool = False) -> Any:
        """Return the carrier angles at which the output angles are `phi3`: inverse of `position`.

        Parameters
        ----------
        phi3 : array_like, any shape
            Output angle, any number of turns (rad).

        Returns
        -------
        ndarray or NumPy scalar
            phi1 (rad); NaN where `phi3` is not finite. A mask or an index is kept.

        Raises
        ------
        TypeError
            If `phi3` is complex, not numeric or no angle.
        ValueError
            If the position function is not monotonic: the ratio changes its sign or is zero
            throughout. Floats are taken at their exact values, with no tolerance.

        Notes
        -----
        With delta = phi3 - (1 - R4/R5)*phi1, |delta| <= asin(e2).

        Accuracy held by the tests, where R4/R5*|phi1| <= 2**25, for every e2: the exact position
        at phi1 misses phi3 by at most 8*eps times the larger term of the position (4 eps of the
        kernel, twice) and what the step to a neighbour of phi1 makes of it. Near a double zero of
        the ratio the angle itself is known only to the square root of that.

        """
        sign = self._direction()
        units = Units(degrees)
        target = units.take("phi3", phi3, "rad")
        found = invert_odd("phi3", target, lambda size: sign * self._invert(size, sign))
        return units.give(found, "rad")

    @property
    def _numbers(self) -> tuple[Any, Any, Any]:
        """Radii R4, R5, or eccentricity e1 and mount; and e2."""
        first, second = vars(self.pair).values()
        return first, second, self.e2

    @property
    def _is_exact(self) -> bool:
        return all(isinstance(number, Fraction) for number in self._numbers)

    def _call(self, name: str, phi1: ArrayLike) -> Any:
        first, second, e2 = map(float, self._numbers)
        if isinstance(self.pair, CylindricalPair):
            return getattr(kernels, f"{name}_cylindrical")(phi1, first, second, e2)
        return getattr(kernels, name)(phi1, first, e2, second)

    def _act_as_one(self) -> OnePair:
        """Compose both pairs; eccentricities add like velocities."""
        first, second, e2 = self._numbers
        if isinstance(self.pair, CylindricalPair):
            return OnePair(first / second, e2, 1 - e2, 0.0)
        e1, mount = first, second
        if mount == 0:
            both = 1 + e1 * e2
            return OnePair(Fraction(1), (e1 + e2) / both, (1 - e1) * (1 - e2) / both, 0.0)
        return compose(float(e1), float(e2), float(mount))

    def _direction(self) -> int:
        """Return the sign of a ratio that does not change it."""
        one = self._act_as_one()
        if isinstance(self.pair, CylindricalPair):
            r4, r5, e2 = map(Fraction, self._numbers)
            one = OnePair(r4 / r5, e2, 1 - e2, 0.0)
            if one.fastest <= 1 and one.slowest < 1:
                return 1
            if one.slowest >= 1 and one.fastest > 1:
                return -1
        low, high = float(1 - one.fastest), float(1 - one.slowest)
        raise ValueError(
            f"{self!r}: phi3 does not determine the carrier angle, for the ratio runs from "
            f"{low!r} to {high!r}; it must keep its sign"
        )

    def _invert(self, size: Any, sign: int) -> Any:
        """Solve sign*position(phi1) = size for positive, finite sizes."""
        one = self._act_as_one()
        speed = max(abs(float(1 - one.slowest)), abs(float(1 - one.fastest)))
        mean, swing = abs(float(1 - one.rate)), math.asin(one.e) * (1 + WIDENING)
        small, large = size * (1 - WIDENING), size * (1 + WIDENING)
        low = np.maximum(small / speed, (small - swing) / mean) - FINEST
        high = (large + swing) / mean + FINEST
        failure = f"{self!r}: no carrier angle found for phi3"
        return invert(lambda phi1: sign * self.position(phi1), size, low, high, failure=failure)


def _check_number(name: str, value: Any) -> Number:
    """Return an exact fraction, or a float for what is one."""
    if isinstance(value, np.integer):
        value = int(value)
    if isinstance(value, str | Decimal | int | Fraction) and not isinstance(value, bool):
        try:
            return Fraction(value)
        except (ValueError, OverflowError):
            refuse(name, value, "must be a finite number")
    return check_real(name, value)


def _check_size(name: str, value: Any, kernel_name: str = "") -> Number:
    """Return the number, exact where it is, after the kernels' conditions on it."""
    number = _check_number(name, value)
    called = kernel_name or name
    check_domain(kernels.DOMAIN, {called: number}, {called: (name, value)})
    return number
