"""Planetary mechanism with an internal cylindrical mesh and an external elliptical pair.

Angles are in radians, positive in the direction of the carrier's rotation, and count every turn;
with `degrees=True` they are in degrees, as arguments and as results, and so are those that results
are derived by. Quantities of pint are taken and given back in their units.

>>> from mechproof import EllipticPlanetary
>>> mechanism = EllipticPlanetary.published(2)
>>> mechanism
EllipticPlanetary(R1=66.0, R2=16.0, e=0.475)
>>> round(float(mechanism.ratio(0.0)), 6)
12.589286
"""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.scalars import check_real, refuse
from mechproof.kernels import elliptic_planetary as kernels
from mechproof.mechanisms.elliptic_planetary_design import find_sizes
from mechproof.mechanisms.extremes import PLACES, Extremes
from mechproof.mechanisms.inversion import FINEST, WIDENING, invert, invert_odd
from mechproof.mechanisms.motion import Drive
from mechproof.mechanisms.pointwise_types import pointwise_in_angles
from mechproof.mechanisms.published_sizes import check_domain, choose_published
from mechproof.mechanisms.units import Units


@dataclass(frozen=True)
class EllipticPlanetary(Drive):
    """A planetary mechanism: carrier in, elliptical wheel out, epicycle fixed.

    Parameters
    ----------
    R1 : float
        Radius of the epicycle (mm), positive.
    R2 : float
        Radius of the satellite's cylindrical wheel (mm), 0 < R2 < R1.
    e : float
        Eccentricity of the ellipse, 0 <= e < 1.

    Raises
    ------
    TypeError, ValueError
        If a parameter is not a real number or out of its range; the message names it.

    Notes
    -----
    Source: Prikhodko, Polivoda, Shchetinin 2024, equations (2)-(9).

    """

    R1: float
    R2: float
    e: float

    def __post_init__(self) -> None:
        """Check the parameters and convert them to floats."""
        for name in ("R1", "R2", "e"):
            given = Units().take(name, getattr(self, name), "1" if name == "e" else "mm")
            object.__setattr__(self, name, check_real(name, given))
        check_domain(kernels.DOMAIN, asdict(self))

    @classmethod
    def published(cls, variant: int) -> EllipticPlanetary:
        """Return variant 1 to 4 of Table 1 of Prikhodko et al. 2024."""
        return cls(**choose_published(kernels.PUBLISHED, "variant", variant))

    @classmethod
    def design(
        cls,
        *,
        largest_ratio: float | None = None,
        smallest_ratio: float | None = None,
        quotient: float | None = None,
        non_uniformity: float | None = None,
        k: float | None = None,
        R1: float | None = None,
        R2: float | None = None,
    ) -> EllipticPlanetary:
        """Return the mechanism whose ratio is as wanted.

        Parameters
        ----------
        largest_ratio, smallest_ratio : float
            Extremes of the ratio: one of them, or both, from which R1/R2 follows.
        quotient : float
            Instead: the largest ratio over the smallest.
        non_uniformity : float
            Instead: (largest - smallest)/mean of the ratio.
        k : float
            R1/R2, above 1. With k alone, or with both extremes alone, R2 is 1 mm: ratios and
            angles depend on R1/R2 only.
        R1, R2 : float
            Radii (mm): both, or one of them with k or with both extremes.

        Raises
        ------
        TypeError
            If what is given is too little or too much, or no real number.
        ValueError
            If what is wanted is out of reach; the message names the reachable range.

        Notes
        -----
        The eccentricity is the only one: in closed form, by the kernels `eccentricity_of_...`,
        within 2 to 9 eps.

        """
        wanted: dict[str, object] = {
            "largest_ratio": largest_ratio,
            "smallest_ratio": smallest_ratio,
            "quotient": quotient,
            "non_uniformity": non_uniformity,
        }
        return cls(*find_sizes(wanted, k, R1, R2))

    @property
    def radius_ratio(self) -> float:
        """R1/R2: turns of the satellite relative to the carrier, per turn of the carrier."""
        return self.R1 / self.R2

    def _call(self, name: str, phi1: ArrayLike) -> Any:
        return getattr(kernels, name)(phi1, self.R1, self.R2, self.e)

    def extremes(
        self, of: Literal["ratio", "acceleration", "jerk"] = "ratio", *, degrees: bool = False
    ) -> Extremes:
        """Return the largest and the smallest value in closed form, and where they occur.

        The ratio is largest where the satellite has made whole turns relative to the carrier, and
        smallest half a turn later; the acceleration is smallest after a largest ratio and largest
        as far before it; the jerk is smallest at a largest ratio and largest to both sides of it,
        from e = 5 - 2*sqrt(6) down half a period away. With e = 0 the ratio is constant. By the
        carrier's speed w times the ratio, w² times the acceleration and w³ times the jerk.

        Raises ValueError for another name.
        """
        sizes = self.R1, self.R2, self.e
        period = 2 * math.pi / self.radius_ratio
        if of == "ratio":
            unit = "1"
            largest, smallest = kernels.largest_ratio(*sizes), kernels.smallest_ratio(*sizes)
            places = 0.0, period / 2
        elif of == "acceleration":
            unit = "1/rad"
            place = float(kernels.angle_of_smallest_acceleration(*sizes))
            largest = kernels.largest_acceleration(*sizes)
            smallest, places = -largest, (period - place, place)
        elif of == "jerk":
            unit = "1/rad**2"
            largest, smallest = kernels.largest_jerk(*sizes), kernels.smallest_jerk(*sizes)
            places = float(kernels.angle_of_largest_jerk(*sizes)), 0.0
        else:
            refuse("of", of, "must be 'ratio', 'acceleration' or 'jerk'")
        found = Extremes(float(largest), places[0], float(smallest), places[1], period)
        return Units(degrees).give_fields(found, PLACES | {"maximum": unit, "minimum": unit})

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
            phi1 (rad); NaN where `phi3` is not finite. The position function rises everywhere,
            so there is exactly one. A mask or an index is kept.

        Raises
        ------
        TypeError
            If `phi3` is complex, not numeric or no angle.

        Notes
        -----
        position(phi1) is inverted in its bracket: with delta = position - (1 + k)*phi1,
        |delta| <= 2*asin(e), and position/phi1 lies between the extremes of the ratio.

        Accuracy held by the tests, where R1/R2*|phi1| <= 2**25, for every e: the exact position at
        phi1 misses phi3 by at most 8*eps*|phi3| (4 eps of the position kernel, twice) and what the
        step to a neighbour of phi1 makes of the position.

        """
        units = Units(degrees)
        target = units.take("phi3", phi3, "rad")
        return units.give(invert_odd("phi3", target, self._invert), "rad")

    def _invert(self, size: Any) -> Any:
        """Solve position(phi1) = size for positive, finite sizes."""
        k, swing, extremes = self.radius_ratio, 2 * math.asin(self.e), self.extremes()
        small, large = size * (1 - WIDENING), size * (1 + WIDENING)
        swing *= 1 + WIDENING
        low = np.maximum(small / extremes.maximum, (small - swing) / (1 + k)) - FINEST
        high = np.minimum(large / extremes.minimum, (large + swing) / (1 + k)) + FINEST
        failure = f"{self!r}: no carrier angle found for phi3"
        return invert(self.position, size, low, high, failure=failure)
