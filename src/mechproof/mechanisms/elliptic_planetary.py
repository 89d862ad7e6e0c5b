"""Planetary mechanism with an internal cylindrical mesh and an external elliptical pair.

Angles are in radians, positive in the direction of the carrier's rotation, and count every turn.
With `degrees=True`, arguments and results are in degrees, and derivatives are with respect to
degrees. pint quantities are accepted and returned in their units.

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

from mechproof.arguments.scalars import check_real, choose_one, refuse, require
from mechproof.kernels import elliptic_planetary as kernels
from mechproof.mechanisms.inversion import FINEST, WIDENING, invert, invert_odd
from mechproof.mechanisms.motion import Drive
from mechproof.mechanisms.parameters import check_domain, choose_published
from mechproof.mechanisms.pointwise_types import pointwise_in_angles
from mechproof.mechanisms.units import PLACES, Extremes, Units


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
        Units().set_fields(self, {"R1": "mm", "R2": "mm", "e": "1"})
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
        """Return the mechanism with the wanted ratio.

        Parameters
        ----------
        largest_ratio, smallest_ratio : float
            Extremes of the ratio: one of them, or both, which determine R1/R2.
        quotient : float
            Alternative: the largest ratio over the smallest.
        non_uniformity : float
            Alternative: (largest - smallest)/mean of the ratio.
        k : float
            R1/R2, above 1. With k alone, or with both extremes alone, R2 is 1 mm: ratios and
            angles depend on R1/R2 only.
        R1, R2 : float
            Radii (mm): both, or one of them with k or with both extremes.

        Raises
        ------
        TypeError
            If too few or too many parameters are given, or one is not a real number.
        ValueError
            If the wanted ratio is out of reach; the message names the reachable range.

        Notes
        -----
        The eccentricity is unique, and given in closed form by the kernels `eccentricity_of_...`,
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
        smallest half a turn later. The acceleration is smallest after a largest ratio, and largest
        as far before it. The jerk is smallest at a largest ratio and largest on both sides of it
        or, for e <= 5 - 2*sqrt(6), half a period away. With e = 0, the ratio is constant. At a
        carrier speed w, the ratio is multiplied by w, the acceleration by w² and the jerk by w³.

        Raises ValueError for any other name.
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
            phi1 (rad); NaN where `phi3` is not finite. The position function increases everywhere,
            so there is exactly one. A mask or an index is kept.

        Raises
        ------
        TypeError
            If `phi3` is complex, not numeric or not an angle.

        Notes
        -----
        position(phi1) is inverted within a bracket: with delta = position - (1 + k)*phi1,
        |delta| <= 2*asin(e), and position/phi1 lies between the extremes of the ratio.

        Accuracy held by the tests, where R1/R2*|phi1| <= 2**25, for every e: the exact position at
        phi1 differs from phi3 by at most 11*eps*|phi3| (5.5 eps of the position kernel, twice) plus
        the change of position from phi1 to a neighbouring double.

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


Sizes = tuple[float, float, float]
EPS = 2.0**-52


def find_sizes(wanted: dict[str, object], k: object, radius_1: object, radius_2: object) -> Sizes:
    """Return R1, R2 and e; arguments as in `EllipticPlanetary.design`."""
    given = {name: check_real(name, value) for name, value in wanted.items() if value is not None}
    if given.keys() == {"largest_ratio", "smallest_ratio"}:
        return _find_all(given["largest_ratio"], given["smallest_ratio"], k, radius_1, radius_2)
    name, _ = choose_one(wanted, ", or the largest and the smallest ratio")
    r1, r2 = _find_radii(k, radius_1, radius_2)
    return r1, r2, _find_eccentricity(name, given[name], r1, r2)


def _find_all(
    largest: float, smallest: float, k: object, radius_1: object, radius_2: object
) -> Sizes:
    require(k is None, "k", k, "follows from both extremes; leave it out")
    require(smallest > 1, "smallest_ratio", smallest, "must be above 1")
    allowed = f"must be at least the smallest, {smallest!r}"
    require(smallest <= largest, "largest_ratio", largest, allowed)
    least = 1 + 1 / (smallest - 1)
    allowed = f"must be above {least!r} with this smallest_ratio, {smallest!r}: else R1 <= R2"
    found = float(kernels.radii_of_extremes(largest, smallest))
    require(found > 1, "largest_ratio", largest, allowed)
    e = float(kernels.eccentricity_of_extremes(largest, smallest))
    both = radius_1 is not None and radius_2 is not None
    require(not both, "R2", radius_2, "follows from R1 and both extremes; leave it out")
    return *_find_radii(found, radius_1, radius_2), _check_below_one("largest_ratio", largest, e)


def _find_radii(k: object, radius_1: object, radius_2: object) -> tuple[float, float]:
    """Return both radii from two of the three, or from k alone with R2 = 1 mm."""
    sizes = {"k": k, "R1": radius_1, "R2": radius_2}
    numbers = {n: check_real(n, size) for n, size in sizes.items() if size is not None}
    for name, number in numbers.items():
        require(number > 0, name, number, "must be positive")
    if len(numbers) == 3 or not ("k" in numbers or len(numbers) == 2):
        raise TypeError(f"{sizes!r}: give R1 and R2, or k = R1/R2 and at most one of them")
    if "k" in numbers:
        require(numbers["k"] > 1, "k", k, "must be above 1, for R2 < R1")
        r2 = numbers["R1"] / numbers["k"] if "R1" in numbers else numbers.get("R2", 1.0)
        return numbers.get("R1", numbers["k"] * r2), r2
    r1, r2 = numbers["R1"], numbers["R2"]
    require(r2 < r1, "R2", r2, f"must be below R1 = {r1!r}")
    return r1, r2


def _find_eccentricity(name: str, value: float, r1: float, r2: float) -> float:
    uniform = 1 + r1 / r2
    reach = {
        "largest_ratio": (value >= uniform, f"must be at least 1 + k = {uniform!r}, that of e = 0"),
        "smallest_ratio": (
            1 < value <= uniform,
            f"must be above 1 and at most 1 + k = {uniform!r}, that of e = 0",
        ),
        "quotient": (value >= 1, "must be at least 1, that of e = 0"),
        "non_uniformity": (value >= 0, "must not be negative"),
    }
    holds, allowed = reach[name]
    require(holds, name, value, allowed)
    kernel = getattr(kernels, f"eccentricity_of_{name}")
    e = float(kernel(value, r1, r2))
    if not e > 0:
        # A wanted value close to that of e = 0 may leave the kernel's domain by rounding; the
        # squares of one far from it overflow, as e nears 1.
        plain = {"quotient": 1.0, "non_uniformity": 0.0}.get(name, uniform)
        e = 0.0 if abs(value - plain) <= 4 * EPS * uniform else 1.0
    return _check_below_one(name, value, e)


def _check_below_one(name: str, value: float, e: float) -> float:
    """Return e, or raise ValueError if it is rounded to 1."""
    if not 0 <= e < 1:
        refuse(name, value, f"needs an eccentricity so near to 1 that it rounds to {e!r}")
    return e
