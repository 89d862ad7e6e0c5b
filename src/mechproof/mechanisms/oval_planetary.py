"""Planetary mechanism with two external pairs: oval or cylindrical 4-5, oval 6-3.

Angles are in radians, positive in the direction of the carrier's rotation, and count every turn.
With `degrees=True`, arguments and results are in degrees, and derivatives are with respect to
degrees. pint quantities are accepted and returned in their units. At zero, a major axis of an oval
sun points to the satellite, whose wheels 5 and 6 have theirs at right angles. Parameters given as
integers, fractions, decimals or decimal strings are exact; the kind of motion is then decided
exactly.

>>> from mechproof import OvalPlanetary
>>> mechanism = OvalPlanetary.published(3)
>>> mechanism.classify().kind
'intermittent'
>>> round(float(mechanism.position(2.0)), 6)
-0.930945
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.scalars import check_real, refuse, require
from mechproof.kernels import oval_planetary as kernels
from mechproof.mechanisms.dwells.band import find_longest_dwell
from mechproof.mechanisms.dwells.tooth_search import (
    DWELL_ANGLES,
    Dwell,
    DwellInDegrees,
    Dwells,
    Rank,
    find_dwells,
)
from mechproof.mechanisms.inversion import FINEST, WIDENING, invert, invert_odd
from mechproof.mechanisms.motion import Drive
from mechproof.mechanisms.oval_pairs import (
    ANGLES,
    Classified,
    CylindricalPair,
    OnePair,
    OvalPair,
    check_size,
    classify,
    compose,
)
from mechproof.mechanisms.parameters import Given, check_number, choose_published
from mechproof.mechanisms.pointwise_types import pointwise_in_angles
from mechproof.mechanisms.units import PLACES, Extremes, Units


@dataclass(frozen=True)
class OvalPlanetary(Drive):
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
    Source: Prikhodko et al. 2024, equations (1)-(11), with the sign that mechanics requires: the
    paper's (10) counts the output's angle against the carrier's direction of rotation.

    """

    pair: OvalPair | CylindricalPair
    e2: Given

    def __post_init__(self) -> None:
        """Check the parameters; exact ones stay exact."""
        if not isinstance(self.pair, OvalPair | CylindricalPair):
            refuse("pair", self.pair, "must be an OvalPair or a CylindricalPair", TypeError)
        Units().set_fields(self, {"e2": "1"}, check_size)

    @classmethod
    def published(cls, variant: int) -> OvalPlanetary:
        """Return variant 1 to 4 of Prikhodko et al. 2024, its parameters exact.

        They are printed with so few digits that the shortest decimal of a double is the printed
        one.
        """
        printed = choose_published(kernels.PUBLISHED, "variant", variant)
        sizes = {name: Fraction(repr(size)) for name, size in printed.items()}
        e2 = sizes.pop("e2")
        return cls(OvalPair(sizes["e1"]) if "e1" in sizes else CylindricalPair(**sizes), e2)

    def extremes(self, *, degrees: bool = False) -> Extremes:
        """Return the largest and the smallest ratio in closed form, and where they occur.

        They are half a period apart. The smallest is at the carrier angle 0 unless wheel 6 is
        mounted at an angle other than the paper's. With circles only, the ratio is constant.
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

    def classify(self, eta: Given | None = None, *, degrees: bool = False) -> Classified:
        """Return the kind of motion, decided by theorems on the parameters.

        Parameters
        ----------
        eta : real number or decimal string, optional
            |ratio| up to which the output counts as at rest, and |mean ratio| up to which it counts
            as without drift; zero by default, which needs exact parameters.

        Returns
        -------
        Classified
            The kind is "rest" if both extremes of the ratio are within eta; "reciprocating" if they
            are beyond it on both sides and the mean is within, "pilgrim-step" if the mean is not;
            "intermittent" if one extreme is within; otherwise "one-way".

        Raises
        ------
        ValueError
            If `eta` is negative, or is left out and a parameter is a float.

        """
        if eta is None:
            require(self._is_exact, "eta", None, f"must be given, since {self!r} has floats")
        limit = Fraction(0) if eta is None else check_number("eta", eta)
        require(limit >= 0, "eta", eta, "must not be negative")
        return Units(degrees).give_fields(classify(self._act_as_one(), limit), ANGLES)

    def longest_dwell(
        self, *, eta: Given | None = None, band: float | None = None, degrees: bool = False
    ) -> tuple[float, float]:
        """Return the longest interval of the carrier angle in which the output dwells.

        Parameters
        ----------
        eta : real number or decimal string
            |ratio| up to which the output counts as at rest, as in `classify`.
        band : float
            Alternative: how far from a position the output may be (rad).
        degrees : bool
            Whether the band and the interval are in degrees.

        Returns
        -------
        tuple of float
            Start and end (rad) of one such interval, which repeats with the period of the ratio;
            infinite if the output always dwells, and both NaN if it never does.

        Raises
        ------
        TypeError, ValueError
            If not exactly one of the two is given, it is not positive, or the output advances in a
            period of the ratio, but by no more than the width of the band.

        """
        units = Units(degrees)
        half = band if band is None else units.take("band", band, "rad")
        start, end = find_longest_dwell(self._act_as_one(), eta, half)
        return units.give(start, "rad"), units.give(end, "rad")

    @classmethod
    def of_dwell(
        cls, dwell: Dwell, e2: Given | None = None, *, module: float = 1.0
    ) -> OvalPlanetary:
        """Return the drive of a row of `find_dwells`.

        `e2` is by default that with an exact dwell, or else that with the longest one; `module` is
        that of the cylindrical wheels (mm).
        """
        require(isinstance(dwell, Dwell), "dwell", dwell, "must be a row of find_dwells", TypeError)
        size = Fraction(check_real("module", module)) / 2
        chosen = e2 if e2 is not None else dwell.best if dwell.exact is None else dwell.exact
        return cls(CylindricalPair(size * dwell.z4, size * dwell.z5), chosen)

    @staticmethod
    def find_dwells(
        width: float,
        *,
        eta: Given | None = None,
        band: float | None = None,
        teeth: tuple[int, int] = (17, 60),
        largest_e: Given = Fraction(1, 3),
        rank: Rank = "width",
        degrees: bool = False,
    ) -> Dwells:
        """Find every drive with a cylindrical pair 4-5 that dwells, by tooth numbers and e2.

        Parameters
        ----------
        width : float
            Least carrier angle of the dwell (rad).
        eta : real number or decimal string
            The output dwells where |ratio| <= eta.
        band : float
            Alternative: it dwells within +-band of a position (rad), whether or not it turns back.
        teeth : two integers
            Least and largest number of teeth of wheels 4 and 5.
        largest_e : real number or decimal string, optional
            Largest e2; the pitch curves are convex up to 1/3.
        rank : "width", "step" or "teeth"
            What ranks first: the longest dwell, the largest advance of the output from one dwell
            to the next, or the fewest teeth.
        degrees : bool
            Whether `width` and `band`, and the angles in the rows, are in degrees.

        Returns
        -------
        Dwells
            A table: for each ratio z4/z5, in the fewest teeth, all intervals of eccentricities. It
            is complete, or names the tooth numbers for which it is not. Ends of e2 that are not
            fractions are enclosed to 1e-9 in balls. Drives that rest throughout are left out.

        Raises
        ------
        TypeError, ValueError
            If not exactly one of `eta` and `band` is given, or one is out of its range.
        ImportError
            If the extra `derive` is not installed.

        """
        units = Units(degrees)
        least = units.take("width", width, "rad")
        half = band if band is None else units.take("band", band, "rad")
        found = find_dwells(least, eta=eta, band=half, teeth=teeth, largest_e=largest_e, rank=rank)
        rows = (units.give_fields(row, DWELL_ANGLES) for row in found.candidates)
        kind = DwellInDegrees if units.degrees else Dwell
        return replace(found, candidates=tuple(kind(*row) for row in rows))

    @pointwise_in_angles
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
            If `phi3` is complex, not numeric or not an angle.
        ValueError
            If the position function is not monotonic: the ratio changes sign or is zero throughout.
            Floats are taken at their exact values, without tolerance.

        Notes
        -----
        With delta = phi3 - (1 - R4/R5)*phi1, |delta| <= asin(e2).

        Accuracy held by the tests, where R4/R5*|phi1| <= 2**25, for every e2: the exact position at
        phi1 differs from phi3 by at most 14*eps times the larger term of the position (7 eps of the
        kernel, twice) plus its change from phi1 to a neighbouring double. Near a double zero of the
        ratio, the angle itself is known only to the square root of that.

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
        """Return one pair that acts like both; eccentricities add like relativistic velocities."""
        first, second, e2 = self._numbers
        if isinstance(self.pair, CylindricalPair):
            return OnePair(first / second, e2, 1 - e2, 0.0)
        e1, mount = first, second
        if mount == 0:
            both = 1 + e1 * e2
            return OnePair(Fraction(1), (e1 + e2) / both, (1 - e1) * (1 - e2) / both, 0.0)
        return compose(float(e1), float(e2), float(mount))

    def _direction(self) -> int:
        """Return the sign of the ratio; raise ValueError if it changes."""
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
            f"{self!r}: phi3 does not determine the carrier angle, as the ratio ranges from "
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
