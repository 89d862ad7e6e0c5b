"""Thickness of involute gear teeth at the constant chord, measured at a height below the tip.

Lengths are in mm, angles in radians, or in degrees with `degrees=True`; pint quantities are
accepted and returned in their units. Heights increase from the tip towards the wheel's centre; a
deviation of thickness is positive for a thicker tooth.

>>> from mechproof import ToothThickness
>>> wheel = ToothThickness.published()
>>> round(float(wheel.constant_chord), 3), round(float(wheel.chord_height), 3)
(4.161, 2.243)
>>> error = wheel.thickness_error(e_tip=0.025, height_error=0.0)
>>> round(float(error), 4)
-0.0091
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import InitVar, asdict, dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.scalars import check_count
from mechproof.kernel_support.arrays import as_floats, as_numpy
from mechproof.kernels import tooth_thickness as kernels
from mechproof.mechanisms.inversion import follow_kind, invert
from mechproof.mechanisms.parameters import check_domain
from mechproof.mechanisms.pointwise_types import pointwise
from mechproof.mechanisms.units import Units
from mechproof.tools.notebook import Displayed


@dataclass(frozen=True)
class ToothThickness(Displayed):
    """A spur gear without profile shift, addendum of one module.

    Parameters
    ----------
    m : float
        Module (mm), positive.
    z : int
        Number of teeth, at least 4.
    alpha : float
        Profile angle of the basic rack (rad), 0 < alpha < pi/4; 20° by default.
    degrees : bool
        Whether alpha is in degrees; not a field.

    Raises
    ------
    TypeError, ValueError
        If a parameter has the wrong type or is out of its range; the message names it.

    Notes
    -----
    Undercut and root fillet are not considered: the flank is an involute down to the base circle.

    Source: paper on tooth thickness, design data and steps 5 and 6.

    """

    m: float
    z: int
    alpha: float = math.pi / 9
    degrees: InitVar[bool] = field(default=False, kw_only=True)

    def __post_init__(self, degrees: bool) -> None:
        """Check the parameters and convert them."""
        # The default angle is in radians.
        angle = {} if self.alpha is ToothThickness.alpha else {"alpha": "rad"}
        Units(degrees).set_fields(self, {"m": "mm", **angle})
        # From z = 4 on, the flank's tangent is within a right angle of the axis up to the tip.
        object.__setattr__(self, "z", check_count("z", self.z, least=4))
        check_domain(kernels.DOMAIN, asdict(self))

    @classmethod
    def published(cls) -> ToothThickness:
        """Return the wheel of the paper, m = 3 mm, z = 50.

        alpha = 20 deg is the profile angle that gives its constant chord of 4.161 mm and height of
        2.243 mm.
        """
        sizes: Mapping[str, Any] = kernels.PUBLISHED[0].sizes
        return cls(sizes["m"], int(sizes["z"]), sizes["alpha"])

    @property
    def constant_chord(self) -> np.float64:
        """Distance of the points where a rack touches both flanks (mm)."""
        return kernels.constant_chord(self.m, self.alpha)

    @property
    def chord_height(self) -> np.float64:
        """Height from the tip circle to the constant chord (mm)."""
        return kernels.chord_height(self.m, self.alpha)

    @property
    def deepest(self) -> np.float64:
        """Depth below the constant chord where the flank is parallel to the tooth's axis (mm)."""
        return kernels.height_change(-self.alpha, self.m, self.z, self.alpha)

    @pointwise
    def thickness_change(self, dh: ArrayLike) -> Any:
        """Return how much the chord thickens if it lies `dh` deeper: exact, on the involute.

        Parameters
        ----------
        dh : array_like, any shape
            How much deeper than the constant chord the measured chord lies (mm).

        Returns
        -------
        ndarray or NumPy scalar
            Change of the chord (mm), negative for a chord nearer the tip; NaN where there is no
            involute: above the tip circle (dh < -chord_height) or the point of a pointed tooth,
            and below `deepest`, where the flank is parallel to the tooth's axis.

        Raises
        ------
        TypeError
            If `dh` is complex, not numeric or not a length.

        Notes
        -----
        Accuracy held by the tests: error <= 61 eps * r_b*|tilt|*(1 + t_c + |tilt|), with `tilt` the
        angle by which the flank's tangent has turned: 29 for the thickness and, times the influence
        of the height, 2*tan of the flank's angle <= 2, 15 for the height and 1 for the tilt.

        """
        units = Units()
        (given,) = as_floats("dh", units.take("dh", dh, "mm"))
        depth = np.asarray(given)
        proper = (depth >= -self.chord_height) & (depth <= self.deepest)
        tilt = self._invert(np.where(proper, depth, 0.0).astype(np.float64))
        change = kernels.thickness_change(tilt, self.m, self.z, self.alpha)
        proper &= self.constant_chord + change >= 0
        found = follow_kind(given, np.where(proper, change, np.nan).astype(depth.dtype))
        return units.give(found, "mm")

    @pointwise
    def thickness_change_linear(self, dh: ArrayLike) -> Any:
        """Return the change of thickness to first order, 2*tan(alpha)*dh."""
        units = Units()
        depth = units.take("dh", dh, "mm")
        return units.give(kernels.thickness_change_linear(depth, self.alpha), "mm")

    @pointwise
    def linearisation_bound(self, dh: ArrayLike) -> Any:
        """Bound the excess of the first-order value: 0 <= linear - exact <= bound (mm).

        NaN where |dh| > `deepest`; see `kernels.tooth_thickness.linearisation_bound`.
        """
        units = Units()
        depth = as_numpy(*as_floats("dh", units.take("dh", dh, "mm")))
        within = np.where(np.abs(depth) <= self.deepest, depth, depth.dtype.type(np.nan))
        bound = kernels.linearisation_bound(within, self.m, self.z, self.alpha)
        return units.give(bound, "mm")

    def thickness_error(self, e_tip: ArrayLike, height_error: ArrayLike) -> Any:
        """Return the error of the measured thickness, to first order (mm).

        `e_tip` is the deviation of the tip diameter, `height_error` that of the gauge's height,
        positive if set too deep. A larger tip diameter makes the measured tooth thinner.
        """
        units = Units()
        tip = units.take("e_tip", e_tip, "mm")
        height = units.take("height_error", height_error, "mm")
        return units.give(kernels.thickness_error(tip, height, self.alpha), "mm")

    def _invert(self, depth: Any) -> Any:
        """Solve height_change(tilt) = depth; the chord falls as the tangent turns to the axis."""
        low = np.full(np.shape(depth), -self.alpha * (1 + 1e-9))
        high = np.full(np.shape(depth), math.pi / 2 - self.alpha)
        failure = f"{self!r}: no chord found for dh"

        def rise(tilt: Any) -> Any:
            return -kernels.height_change(tilt, self.m, self.z, self.alpha)

        return invert(rise, -depth, low, high, failure=failure)
