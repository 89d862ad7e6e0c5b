"""Wheel with a multi-period track, and the errors from its placement on the machine.

Lengths are in millimetres, angles in radians, or in degrees with `degrees=True`; pint quantities
are accepted and returned in their units. The part is turned by alpha about X0, then beta about Y0,
then gamma about Z0, each counter-clockwise, and shifted by (a, b, c).

The kernels `tilt_of_planar_error` and `tilt_of_spatial_error` give the permitted tilt and offset.
The rows "design, ..." of the track wheel's ledger prove that no other direction or tilt is worse.

>>> from mechproof import TrackWheel
>>> wheel = TrackWheel.published(z=6, H=20, shift=(0, 0, 0))
>>> wheel.radius_extremes().maximum
45.25
>>> wheel.displacement([0.0, 1.0]).shape
(2, 3)
>>> tilt = wheel.largest_tilt(spatial_error=0.05)
>>> round(float(wheel.worst_pose(tilt).spatial_error(0.0)), 12)
0.05
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import InitVar, dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from mechproof.arguments.scalars import check_count, check_real, check_triple, choose_one, require
from mechproof.kernel_support.arrays import as_floats
from mechproof.kernels import track_wheel as kernels
from mechproof.kernels.derivatives import track_wheel as derivatives
from mechproof.mechanisms.inversion import WIDENING
from mechproof.mechanisms.parameters import check_domain
from mechproof.mechanisms.pointwise_types import pointwise_in_angles
from mechproof.mechanisms.units import PLACES, Extremes, Units
from mechproof.tools.notebook import Displayed

QUARTER = math.pi / 2


def check_tilt(tilt: object) -> float:
    """Return a tilt from 0 up to a right angle."""
    number = check_real("tilt", tilt)
    require(0 <= number <= QUARTER, "tilt", tilt, "must lie between 0 and pi/2 rad")
    return number


def check_offset(offset: object) -> float:
    """Return an offset that is not negative."""
    number = check_real("offset", offset)
    require(number >= 0, "offset", offset, "must not be negative")
    return number


def choose_wish(wanted: Mapping[str, object], units: Units) -> tuple[str, float]:
    """Return the name and size of the one error given."""
    name, error = choose_one(wanted)
    return name, check_real(name, units.take(name, error, "mm"))


def find_angles(tilt: float, phi: float) -> tuple[float, float, float]:
    """Return the turns alpha, beta, gamma that together tilt the part so that `phi` rises most."""
    x, y = math.sin(phi), -math.cos(phi)
    sine, versine = math.sin(tilt), 2 * math.sin(tilt / 2) ** 2
    return (
        math.atan2(x * sine, math.cos(tilt)),
        math.asin(y * sine),
        math.atan2(-versine * x * y, math.cos(tilt) + versine * x * x),
    )


Triple = tuple[float, float, float]


@dataclass(frozen=True)
class TrackWheel(Displayed):
    """A wheel with a track of z periods, and its rotation and shift on the machine.

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
        Whether the angles are in degrees; not a field.

    Raises
    ------
    TypeError, ValueError
        If a parameter has the wrong type or is out of its range; the message names it.

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
        units.set_fields(self, {"R": "mm", "A": "mm", "H": "mm"})
        units.set_fields(self, {"angles": "rad", "shift": "mm"}, check_triple)
        object.__setattr__(self, "z", check_count("z", self.z))
        check_domain(kernels.DOMAIN, {name: getattr(self, name) for name in ("R", "A", "z", "H")})

    @classmethod
    def published(cls, *, z: int, H: float, shift: Triple) -> TrackWheel:
        """Return the wheel of Table 1 of Kapitonov, Yakubovsky 2022.

        R = 41.5 mm, A = 3.75 mm, alpha = beta = 0.00103 rad, gamma = 0. The paper does not state
        the number of periods, the thickness and the shift: they have to be given.
        """
        sizes: Mapping[str, Any] = kernels.PUBLISHED[0].sizes
        angles = sizes["alpha"], sizes["beta"], sizes["gamma"]
        return cls(sizes["R"], sizes["A"], z, H, angles=angles, shift=shift)

    def rotation(self) -> NDArray[np.float64]:
        """Return the matrix K (14), shape (3, 3): coordinates in the part's frame."""
        return kernels.rotation(*self.angles)

    @pointwise_in_angles
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

    @pointwise_in_angles
    def planar_error(self, phi: ArrayLike, *, degrees: bool = False) -> Any:
        """Return the error in the end plane (17) of the track's points."""
        units = Units()
        moved = units.take("phi", self.displacement(phi, degrees=degrees), "mm")
        return units.give(kernels.planar_error(moved), "mm")

    @pointwise_in_angles
    def spatial_error(self, phi: ArrayLike, *, degrees: bool = False) -> Any:
        """Return the error in space (18) of the track's points."""
        units = Units()
        moved = units.take("phi", self.displacement(phi, degrees=degrees), "mm")
        return units.give(kernels.spatial_error(moved), "mm")

    @pointwise_in_angles
    def normal_error(self, phi: ArrayLike, *, degrees: bool = False) -> Any:
        """Return the error along the normal of the track in the plane, positive outwards.

        It is the part of the displacement (15) that moves the track's wall sideways; NaN where a
        track with |A| = R passes through the pole and has no normal.
        """
        units = Units(degrees)
        (angles,) = as_floats("phi", units.take("phi", phi, "rad"))
        moved = np.asarray(self.displacement(angles))
        radius = kernels.radius(angles, self.R, self.A, self.z)
        cosine, sine = np.cos(angles), np.sin(angles)
        outwards = moved[..., 0] * cosine + moved[..., 1] * sine
        ahead = moved[..., 1] * cosine - moved[..., 0] * sine
        with np.errstate(divide="ignore", invalid="ignore"):
            slope = derivatives.radius(angles, self.R, self.A, self.z)[..., 0]
            error = (radius * outwards - slope * ahead) / np.hypot(radius, slope)
        return units.give(error, "mm")

    def worst_pose(
        self, tilt: float = 0.0, offset: float = 0.0, *, degrees: bool = False
    ) -> TrackWheel:
        """Return the wheel with its axis tilted and offset in the worst directions.

        The side that rises is at a crest of the track, `radius_extremes().at_maximum`, and the
        offset is away from it. No other directions give larger maximum errors in the plane, along
        the normal or in space; the maxima occur at this crest. The wheel's own angles and shift are
        ignored, as is a turn about its axis.

        Parameters
        ----------
        tilt : float
            Angle between the axis and Z0 (rad), 0 to pi/2.
        offset : float
            Shift in the plane X0Y0 (mm), not negative.
        degrees : bool
            Whether the tilt is in degrees.

        Raises
        ------
        TypeError, ValueError
            If a parameter has the wrong type or is out of its range; the message names it.

        """
        units = Units(degrees)
        angle = check_tilt(units.take("tilt", tilt, "rad"))
        length = check_offset(units.take("offset", offset, "mm"))
        return self._place(angle, length)

    def largest_tilt(
        self,
        *,
        planar_error: float | None = None,
        spatial_error: float | None = None,
        offset: float = 0.0,
        degrees: bool = False,
    ) -> Any:
        """Return the largest tilt at which no error exceeds the one wanted, in any direction.

        In closed form, by the kernels `tilt_of_planar_error` and `tilt_of_spatial_error`: in the
        directions of `worst_pose`, the largest error is the one wanted, to 20 eps, as held by the
        tests.

        Parameters
        ----------
        planar_error, spatial_error : float
            One of them: the largest error permitted in the plane, which is also that along the
            normal of the track, or in space (mm).
        offset : float
            Shift in the plane X0Y0, in any direction, that comes with the tilt (mm).
        degrees : bool
            Whether the tilt is returned in degrees.

        Returns
        -------
        float
            Angle between the axis and Z0 (rad), 0 to pi/2.

        Raises
        ------
        TypeError, ValueError
            If a parameter has the wrong type, or the error is out of reach; the message says what
            is allowed.

        """
        units = Units(degrees)
        wanted = {"planar_error": planar_error, "spatial_error": spatial_error}
        name, error = choose_wish(wanted, units)
        length = check_offset(units.take("offset", offset, "mm"))
        most = self._find_largest(name, QUARTER, length)
        allowed = f"must lie between the offset, {length!r}, and {most!r}, that of a right angle"
        require(length <= error <= most * (1 + WIDENING), name, error, allowed)
        if error == length:
            return units.give(0.0, "rad")
        rho = float(kernels.largest_radius(self.R, self.A))
        # In units of the crest's distance from the origin, no square leaves the range of doubles.
        unit = math.hypot(rho, self.H)
        sizes = (size / unit for size in (error, length, rho, self.H))
        tilt = float(getattr(kernels, f"tilt_of_{name}")(*sizes))
        # The error of a right angle may exceed that by rounding.
        return units.give(QUARTER if math.isnan(tilt) else min(tilt, QUARTER), "rad")

    def largest_offset(
        self,
        *,
        planar_error: float | None = None,
        spatial_error: float | None = None,
        tilt: float = 0.0,
        degrees: bool = False,
    ) -> Any:
        """Return the largest offset at which no error exceeds the one wanted, in any direction.

        In closed form, as in `largest_tilt`; `tilt` accompanies the offset (rad, 0 to pi/2). Raises
        the same errors; the error wanted must be at least that of the tilt alone.
        """
        units = Units(degrees)
        wanted = {"planar_error": planar_error, "spatial_error": spatial_error}
        name, error = choose_wish(wanted, units)
        angle = check_tilt(units.take("tilt", tilt, "rad"))
        least = self._find_largest(name, angle, 0.0)
        allowed = f"must be at least {least!r}, that of the tilt alone"
        require(error >= least * (1 - WIDENING), name, error, allowed)
        # A wanted error that was itself computed may be too small by rounding.
        error = max(error, least)
        inwards = self._find_largest("planar_error", angle, 0.0)
        if name == "planar_error":
            return units.give(error - inwards, "mm")
        *_, up = self._displace_crest(angle, 0.0)
        # A hypotenuse may be shorter than its longer leg by a last bit.
        side = math.sqrt(max(error - abs(up), 0.0)) * math.sqrt(error + abs(up))
        found = (error - least) * ((error + least) / (inwards + side)) if error > least else 0.0
        return units.give(found, "mm")

    def _place(self, tilt: float, offset: float) -> TrackWheel:
        crest = self.radius_extremes().at_maximum
        shift = (-offset * math.cos(crest), -offset * math.sin(crest), 0.0)
        return replace(self, angles=find_angles(tilt, crest), shift=shift)

    def _displace_crest(self, tilt: float, offset: float) -> Any:
        """Return the displacement of the crest where it is largest."""
        placed = self._place(tilt, offset)
        return placed.displacement(placed.radius_extremes().at_maximum)

    def _find_largest(self, name: str, tilt: float, offset: float) -> float:
        """Return the largest of the errors that the kernel of this name computes."""
        return float(getattr(kernels, name)(self._displace_crest(tilt, offset)))
