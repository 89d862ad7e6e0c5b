"""Planetary mechanism with two external pairs: oval or cylindrical 4-5, oval 6-3.

Angles are in radians, positive in the direction of the carrier's rotation, and count every turn.
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
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from mechproof.kernel_support.arrays import as_floats
from mechproof.kernels import oval_planetary as kernels
from mechproof.oval_planetary_motion import Motion, Number, OnePair, compose, describe_motion
from mechproof.validation import check_count, check_real, require

__all__ = ["CylindricalPair", "Motion", "OvalPair", "OvalPlanetary"]

# Decimal strings are exact, too; every parameter is kept as a Fraction or a float.
Given = float | Fraction | Decimal | str

# Prikhodko et al. 2024: pair 4-5 (e, or R4 and R5 in mm) and the eccentricity of pair 6-3.
VARIANTS = (("0.2",), (25, 25), (30, 20), (32, 18))
ECCENTRICITY_36 = "0.2"

# The bracket of the inverse is widened by this relative amount: twice the accuracy bar of the
# position kernel, 4 eps of the larger term, which is at most twice the position at the lower end,
# and the rounding of the bounds, some ten operations of half an eps.
WIDENING = 16 * np.finfo(float).eps
# A carrier angle may be subnormal where phi3 is not; there widening and tolerance are absolute.
FINEST = 4 * float(np.finfo(float).smallest_subnormal)
# About 1100 halvings lead from a bracket of some radians to a subnormal angle, the worst case;
# Chandrupatla's method needs at most a few steps for each.
MOST_STEPS = 4000


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

    """

    e: Given
    mount: Given = Fraction(0)

    def __post_init__(self) -> None:
        """Check the parameters and keep them exact where they are."""
        _check_eccentricity(self, "e")
        object.__setattr__(self, "mount", _check_number("mount", self.mount))


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
        for name in ("R4", "R5"):
            object.__setattr__(self, name, _check_number(name, getattr(self, name)))
            require(getattr(self, name) > 0, name, getattr(self, name), "must be positive")


@dataclass(frozen=True)
class OvalPlanetary:
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
            raise TypeError(f"pair = {self.pair!r}: must be an OvalPair or a CylindricalPair")
        _check_eccentricity(self, "e2")

    @classmethod
    def published(cls, variant: int) -> OvalPlanetary:
        """Return variant 1 to 4 of Prikhodko et al. 2024, its parameters exact."""
        number = check_count("variant", variant)
        require(number <= len(VARIANTS), "variant", variant, f"must be 1 to {len(VARIANTS)}")
        sizes = [_check_number("variant", size) for size in VARIANTS[number - 1]]
        pair = OvalPair(*sizes) if len(sizes) == 1 else CylindricalPair(*sizes)
        return cls(pair, _check_number("e2", ECCENTRICITY_36))

    def ratio(self, phi1: ArrayLike) -> Any:
        """Return d phi3/d phi1 at the carrier angles `phi1`; see `kernels.oval_planetary`."""
        return self._call("ratio", phi1)

    def position(self, phi1: ArrayLike) -> Any:
        """Return the output angles phi3(phi1), continuous over any number of turns."""
        return self._call("position", phi1)

    def acceleration(self, phi1: ArrayLike) -> Any:
        """Return d ratio/d phi1 at the carrier angles `phi1`."""
        return self._call("acceleration", phi1)

    def motion(self, eta: Given | None = None) -> Motion:
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
        return describe_motion(self._act_as_one(), limit)

    def carrier_angle(self, phi3: ArrayLike) -> Any:
        """Return the carrier angles at which the output angles are `phi3`: inverse of `position`.

        Parameters
        ----------
        phi3 : array_like, any shape
            Output angle, any number of turns (rad).

        Returns
        -------
        ndarray or NumPy scalar
            phi1 (rad); NaN where `phi3` is not finite.

        Raises
        ------
        TypeError
            If `phi3` is complex or not numeric.
        ValueError
            If the position function is not monotonic: the ratio changes its sign or is zero
            throughout. Floats are taken at their exact values, with no tolerance.

        Notes
        -----
        With delta = phi3 - (1 - R4/R5)*phi1, |delta| <= asin(e2).

        Accuracy held by the tests, where R4/R5*|phi1| <= 2**25: the exact position at phi1 misses
        phi3 by at most 4*(eps times the larger term of the position + what an ulp of phi1 makes
        of it). Near a double zero of the ratio the angle itself is known only to the square root
        of that.

        """
        sign = self._direction()
        (target,) = as_floats(phi3=phi3)
        proper = np.isfinite(target) & (target != 0)
        # The function is odd; its positive half is enough.
        size = np.where(proper, np.abs(target), 1.0).astype(np.float64)
        root = sign * np.copysign(self._invert(size, sign), target)
        root = np.where(proper, root, np.where(target == 0, target, np.nan))
        return root.astype(target.dtype)[()]

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
        from scipy.optimize.elementwise import find_root

        one = self._act_as_one()
        speed = max(abs(float(1 - one.slowest)), abs(float(1 - one.fastest)))
        mean, swing = abs(float(1 - one.rate)), math.asin(one.e) * (1 + WIDENING)
        small, large = size * (1 - WIDENING), size * (1 + WIDENING)
        low = np.maximum(small / speed, (small - swing) / mean) - FINEST
        high = (large + swing) / mean + FINEST
        found = find_root(
            lambda phi1, wanted: sign * self.position(phi1) - wanted,
            (low, high),
            args=(size,),
            tolerances={"xatol": FINEST, "fatol": 0.0},
            maxiter=MOST_STEPS,
        )
        if not np.all(found.success):
            lost = np.asarray(size)[~np.asarray(found.success)]
            raise ArithmeticError(f"{self!r}: no carrier angle found for phi3 = {lost!r}")
        return found.x


def _check_number(name: str, value: Any) -> Number:
    """Return an exact fraction, or a float for what is one."""
    if isinstance(value, np.integer):
        value = int(value)
    if isinstance(value, str | Decimal | int | Fraction) and not isinstance(value, bool):
        try:
            return Fraction(value)
        except (ValueError, OverflowError):
            raise ValueError(f"{name} = {value!r}: must be a finite number") from None
    return check_real(name, value)


def _check_eccentricity(owner: object, name: str) -> None:
    number = _check_number(name, getattr(owner, name))
    require(0 <= number < 1, name, getattr(owner, name), f"must satisfy 0 <= {name} < 1")
    object.__setattr__(owner, name, number)
