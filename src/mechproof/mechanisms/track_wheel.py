"""Wheel with a multi-period track, and the errors from the way it lies on the machine.

Lengths are in millimetres, angles in radians, or in degrees with `degrees=True`; quantities of pint
are taken and given back in their units. The part is turned by alpha about X0, then beta
about Y0, then gamma about Z0, each counter-clockwise, and shifted by (a, b, c).

>>> from mechproof import TrackWheel
>>> wheel = TrackWheel.published(z=6, H=20, shift=(0, 0, 0))
>>> wheel.radius_extremes().maximum
45.25
>>> wheel.displacement([0.0, 1.0]).shape
(2, 3)
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import InitVar, dataclass, field
from typing import Any

from numpy.typing import ArrayLike

from mechproof.arguments.scalars import check_count, check_real, check_triple
from mechproof.kernels import track_wheel as kernels
from mechproof.mechanisms.extremes import PLACES, Extremes
from mechproof.mechanisms.facts import check_domain
from mechproof.mechanisms.units import Units
from mechproof.notebook import Displayed

__all__ = ["TrackWheel"]

Triple = tuple[float, float, float]


@dataclass(frozen=True)
class TrackWheel(Displayed):
    """A wheel with a track of z periods, and its turn and shift on the machine.

    Parameters
    ----------
    R : float
        Radius of the shifted circle (mm), positive.
    A : float
        Shift of the circle, amplitude of the track (mm), |A| <= R.
    z : int
        Number of periods, at least 1.
    H : float
        Thickness of the part, height of the track (mm), positive.
    angles : three floats
        Turns alpha, beta, gamma about X0, Y0, Z0, in this order (rad).
    shift : three floats
        Shift a, b, c along X0, Y0, Z0 (mm).
    degrees : bool
        Whether the angles are in degrees; no field.

    Raises
    ------
    TypeError, ValueError
        If a parameter is not of its kind or out of its range; the message names it.

    Notes
    -----
    Source: Kapitonov, Yakubovsky 2022, equations (8)-(18).

    """

    R: float
    A: float
    z: int
    H: float
    angles: Triple = (0.0, 0.0, 0.0)
    shift: Triple = (0.0, 0.0, 0.0)
    degrees: InitVar[bool] = field(default=False, kw_only=True)

    def __post_init__(self, degrees: bool) -> None:
        """Check the parameters and convert them."""
        units = Units(degrees)
        for name in ("R", "A", "H"):
            given = units.take(name, getattr(self, name), "mm")
            object.__setattr__(self, name, check_real(name, given))
        for name, unit in (("angles", "rad"), ("shift", "mm")):
            given = units.take(name, getattr(self, name), unit)
            object.__setattr__(self, name, check_triple(name, given))
        object.__setattr__(self, "z", check_count("z", self.z))
        check_domain(kernels.DOMAIN, {name: getattr(self, name) for name in ("R", "A", "z", "H")})

    @classmethod
    def published(cls, *, z: int, H: float, shift: Triple) -> TrackWheel:
        """Return the wheel of Table 1 of Kapitonov, Yakubovsky 2022.

        R = 41.5 mm, A = 3.75 mm, alpha = beta = 0.00103 rad, gamma = 0. The paper does not
        print the number of periods, the thickness and the shift: they have to be given.
        """
        sizes: Mapping[str, Any] = kernels.PUBLISHED[0].sizes
        angles = sizes["alpha"], sizes["beta"], sizes["gamma"]
        return cls(sizes["R"], sizes["A"], z, H, angles=angles, shift=shift)

    def rotation(self) -> Any:
        """Return the matrix K (14), shape (3, 3): coordinates in the part's frame."""
        return kernels.rotation(*self.angles)

    def radius(self, phi: ArrayLike, *, degrees: bool = False) -> Any:
        """Return the radius vector of the track (16) at polar angles `phi`."""
        units = Units(degrees)
        angles = units.take("phi", phi, "rad")
        return units.give(kernels.radius(angles, self.R, self.A, self.z), "mm")

    def radius_extremes(self, *, degrees: bool = False) -> Extremes:
        """Return the largest and the smallest radius in closed form, and where they occur.

        They are half a period apart; the largest is at phi = 0 if A >= 0.
        """
        period = 2 * math.pi / self.z
        first, second = (0.0, period / 2) if self.A >= 0 else (period / 2, 0.0)
        found = Extremes(
            maximum=float(kernels.largest_radius(self.R, self.A)),
            at_maximum=first,
            minimum=float(kernels.smallest_radius(self.R, self.A)),
            at_minimum=second,
            period=period,
        )
        return Units(degrees).give_fields(found, PLACES)

    def track(self, phi: ArrayLike, *, degrees: bool = False) -> Any:
        """Return the points of the track (16) in the part's frame, shape (..., 3)."""
        units = Units(degrees)
        angles = units.take("phi", phi, "rad")
        return units.give(kernels.track(angles, self.R, self.A, self.z, self.H), "mm")

    def displacement_of(self, points: ArrayLike) -> Any:
        """Return the position errors (15) of `points` in the part's frame, shape (..., 3)."""
        units = Units()
        places = units.take("points", points, "mm")
        return units.give(kernels.displacement(places, self.angles, self.shift), "mm")

    def displacement(self, phi: ArrayLike, *, degrees: bool = False) -> Any:
        """Return the position errors (15) of the track's points, shape (..., 3)."""
        return self.displacement_of(self.track(phi, degrees=degrees))

    def planar_error(self, phi: ArrayLike, *, degrees: bool = False) -> Any:
        """Return the error in the end plane (17) of the track's points."""
        units = Units()
        moved = units.take("phi", self.displacement(phi, degrees=degrees), "mm")
        return units.give(kernels.planar_error(moved), "mm")

    def spatial_error(self, phi: ArrayLike, *, degrees: bool = False) -> Any:
        """Return the error in space (18) of the track's points."""
        units = Units()
        moved = units.take("phi", self.displacement(phi, degrees=degrees), "mm")
        return units.give(kernels.spatial_error(moved), "mm")
