"""Pusher, lever, rod, roller lever and wedge: a chain of four Assur groups with a clearance.

Lengths are in millimetres, angles in radians from Ox, positive counter-clockwise; displacements
and rotations are counted from the position x1 = 0.

>>> from mechproof import WedgeLinkage
>>> linkage = WedgeLinkage.published(1)
>>> round(float(linkage.position(-40.0)), 3)
-123.212
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from mechproof.kernel_support.arrays import as_floats
from mechproof.kernels import wedge_linkage as kernels
from mechproof.validation import check_count, check_real, require

if TYPE_CHECKING:
    from mechproof.tolerance import CornerRange, Size

__all__ = ["PusherReachError", "RollerLeverReachError", "WedgeLinkage"]

LENGTHS = ("l_AB", "l_BC", "l_CD", "l_DE", "l_GH", "l_KL", "l_LM")
ANGLES = ("alpha_DE", "alpha_KL", "alpha_LM")

# Bazuev et al. 2021: nominal, upper and lower limit deviation (mm, degrees). The digits of l_BC
# and l_DE and two deviations cannot be read; both sets are reconstructions, fitted to the printed
# crossing of two boundary curves at x1 = -29.4 mm.
FIRST_SET = {
    "l_AB": (6.25, 0.0, 0.0),
    "l_BC": (49.75, 1.22, -1.22),
    "l_CD": (38.0, 0.0, -2.06),
    "l_DE": (83.0, 0.92, -1.05),
    "l_GH": (2.0, 1.03, -0.72),
    "l_KL": (60.0, 0.2, -0.2),
    "l_LM": (145.0, 0.1, -0.1),
    "alpha_DE": (283.06, 0.62, -1.10),
    "alpha_KL": (65.0, 0.24, -0.25),
    "alpha_LM": (123.48, 0.0, 0.0),
}
SECOND_SET = FIRST_SET | {
    "l_BC": (39.75, 1.22, -1.22),
    "l_CD": (28.0, 1.19, -2.06),
    "l_DE": (70.83, 0.92, -1.05),
}
SETS = (FIRST_SET, SECOND_SET)


class PusherReachError(ValueError):
    """The guide BC cannot follow the pusher: the radicand of Q is negative."""


class RollerLeverReachError(ValueError):
    """The roller lever cannot follow the rod: |R| > l_KL."""


@dataclass(frozen=True)
class WedgeLinkage:
    """The linkage by its sizes: pusher in, wedge out.

    Parameters
    ----------
    l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM : float
        Lengths and the clearance l_GH (mm), positive.
    alpha_DE, alpha_KL, alpha_LM : float
        Directions of the arms at x1 = 0 (rad), 0 < alpha_KL < pi.

    Raises
    ------
    TypeError, ValueError
        If a size is not a real number or out of its range; the message names it.

    Notes
    -----
    Source: Bazuev et al. 2021, equations (1)-(10), with (7) and (8) in one form.

    """

    l_AB: float  # noqa: N815
    l_BC: float  # noqa: N815
    l_CD: float  # noqa: N815
    l_DE: float  # noqa: N815
    l_GH: float  # noqa: N815
    l_KL: float  # noqa: N815
    l_LM: float  # noqa: N815
    alpha_DE: float  # noqa: N815
    alpha_KL: float  # noqa: N815
    alpha_LM: float  # noqa: N815

    def __post_init__(self) -> None:
        """Check the sizes and convert them to floats."""
        for name in (*LENGTHS, *ANGLES):
            object.__setattr__(self, name, check_real(name, getattr(self, name)))
        for name in LENGTHS:
            require(getattr(self, name) > 0, name, getattr(self, name), "must be positive")
        require(0 < self.alpha_KL < math.pi, "alpha_KL", self.alpha_KL, "must lie in (0, pi)")

    @classmethod
    def published(cls, set: int) -> WedgeLinkage:
        """Return the nominal sizes of reconstruction 1 or 2 of Bazuev et al. 2021.

        The sizes of the paper cannot be read in full. Set 1 changes one digit of l_BC and meets
        the crossing at -29.4 mm and the largest spread at -40 mm; set 2 meets the crossing and
        deviations of 10 %. Both were fitted to the crossing: it does not confirm them.
        """
        return cls(**{name: size.nominal for name, size in cls.published_sizes(set).items()})

    @staticmethod
    def published_sizes(set: int) -> dict[str, Size]:
        """Return the sizes of reconstruction 1 or 2 with their limits (mm, rad)."""
        from mechproof.tolerance import Size

        number = check_count("set", set)
        require(number <= len(SETS), "set", set, f"must be 1 to {len(SETS)}")
        return {
            name: Size(*(math.radians(v) if name in ANGLES else v for v in values))
            for name, values in SETS[number - 1].items()
        }

    def position(self, x1: ArrayLike) -> Any:
        """Return the displacements y9 of the wedge; see `kernels.wedge_linkage`.

        Raises
        ------
        PusherReachError
            Where the radicand of Q is negative.
        RollerLeverReachError
            Where |R| > l_KL; both name the first displacement concerned.

        """
        self._check_reach(x1)
        return kernels.position(x1, **asdict(self))

    def velocity(self, x1: ArrayLike) -> Any:
        """Return dy9/dx1, the velocity of the wedge at unit speed of the pusher.

        0 before contact; at its start the value in contact. Raises as `position`.
        """
        self._check_reach(x1)
        return kernels.velocity(x1, **asdict(self))

    def sensitivities(self, x1: ArrayLike) -> dict[str, Any]:
        """Return the derivative of y9 by every size (mm per mm or rad). Raises as `position`."""
        self._check_reach(x1)
        columns = np.moveaxis(kernels.sensitivities(x1, **asdict(self)), -1, 0)
        return {name: column[()] for name, column in zip(asdict(self), columns, strict=True)}

    def tolerance_range(
        self, x1: ArrayLike, deviations: Mapping[str, tuple[float, float]]
    ) -> CornerRange:
        """Return the range of y9 over all combinations of limits of the sizes.

        Parameters
        ----------
        x1 : array_like
            Displacements of the pusher (mm).
        deviations : mapping
            Name of a size and its upper and lower limit deviation (mm, rad); others are fixed.

        Notes
        -----
        No bound over the box of sizes: `mechproof.tolerance_certified` has one. Combinations
        outside the reach of the linkage are counted in `undefined`.

        """
        from mechproof.tolerance import Size, corner_range

        unknown = sorted(deviations.keys() - asdict(self).keys())
        require(not unknown, "deviations", unknown, f"names must be among {[*asdict(self)]}")
        sizes = {
            name: Size(nominal, *deviations.get(name, (0.0, 0.0)))
            for name, nominal in asdict(self).items()
        }
        with np.errstate(invalid="ignore"):
            return corner_range(kernels.position, x1, sizes)

    def _check_reach(self, x1: ArrayLike) -> None:
        """Raise for the first displacement that the linkage cannot follow; NaN passes."""
        (moved,) = (np.ravel(a).astype(np.float64) for a in as_floats(x1=x1))
        radicand = self.l_BC**2 + moved * (2 * (self.l_AB + self.l_CD) + moved)
        if (beyond := radicand < 0).any():
            raise PusherReachError(
                f"x1 = {moved[beyond][0]}: the radicand of Q, l_BC**2 + x1*(2*(l_AB + l_CD) + "
                f"x1) = {radicand[beyond][0]:.6g}, must not be negative"
            )
        turned = kernels.lever_angle(moved, self.l_AB, self.l_BC, self.l_CD)
        run = kernels.rod_displacement(turned, self.l_DE, self.alpha_DE)
        projection = self.l_KL * math.cos(self.alpha_KL) - kernels.clearance(run, self.l_GH)
        if (beyond := np.abs(projection) > self.l_KL).any():
            raise RollerLeverReachError(
                f"x1 = {moved[beyond][0]}: |R| <= l_KL = {self.l_KL!r} is violated, "
                f"R = l_KL*cos(alpha_KL) - x5' = {projection[beyond][0]:.6g}"
            )
