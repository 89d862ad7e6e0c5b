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
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.scalars import check_real
from mechproof.kernels import elliptic_planetary as kernels
from mechproof.mechanisms.extremes import PLACES, Extremes
from mechproof.mechanisms.facts import check_domain, choose_published
from mechproof.mechanisms.inversion import FINEST, WIDENING, invert, invert_odd
from mechproof.mechanisms.units import Units
from mechproof.notebook import Displayed

__all__ = ["EllipticPlanetary"]


@dataclass(frozen=True)
class EllipticPlanetary(Displayed):
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

    @property
    def radius_ratio(self) -> float:
        """R1/R2: turns of the satellite relative to the carrier, per turn of the carrier."""
        return self.R1 / self.R2

    def ratio(self, phi1: ArrayLike, *, degrees: bool = False) -> Any:
        """Return d phi3/d phi1 at the carrier angles `phi1`; see `kernels.elliptic_planetary`."""
        units = Units(degrees)
        angles = units.take("phi1", phi1, "rad")
        return units.give(kernels.ratio(angles, self.R1, self.R2, self.e), "1")

    def position(self, phi1: ArrayLike, *, degrees: bool = False) -> Any:
        """Return the output angles phi3(phi1), continuous over any number of turns."""
        units = Units(degrees)
        angles = units.take("phi1", phi1, "rad")
        return units.give(kernels.position(angles, self.R1, self.R2, self.e), "rad")

    def acceleration(self, phi1: ArrayLike, *, degrees: bool = False) -> Any:
        """Return d ratio/d phi1 at the carrier angles `phi1`."""
        units = Units(degrees)
        angles = units.take("phi1", phi1, "rad")
        return units.give(kernels.acceleration(angles, self.R1, self.R2, self.e), "1/rad")

    def extremes(self, *, degrees: bool = False) -> Extremes:
        """Return the largest and the smallest ratio in closed form, and where they occur.

        The largest where the satellite has made whole turns relative to the carrier, the smallest
        half a turn later; see `kernels.elliptic_planetary`. With e = 0 the ratio is constant.
        """
        period = 2 * math.pi / self.radius_ratio
        found = Extremes(
            maximum=float(kernels.largest_ratio(self.R1, self.R2, self.e)),
            at_maximum=0.0,
            minimum=float(kernels.smallest_ratio(self.R1, self.R2, self.e)),
            at_minimum=period / 2,
            period=period,
        )
        return Units(degrees).give_fields(found, PLACES)

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
