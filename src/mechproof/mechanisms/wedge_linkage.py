"""Pusher, lever, rod, roller lever and wedge: a chain of four Assur groups with a clearance.

Lengths are in millimetres, angles in radians, or in degrees with `degrees=True`, from Ox, positive
counter-clockwise; displacements and rotations are counted from the position x1 = 0. pint quantities
are accepted and returned in their units.

>>> from mechproof import WedgeLinkage
>>> linkage = WedgeLinkage.published(1)
>>> round(float(linkage.position(-40.0)), 3)
-123.212
"""

from __future__ import annotations

from collections.abc import Mapping
from concurrent.futures import Executor
from dataclasses import InitVar, asdict, dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.array_checks import check_array
from mechproof.arguments.scalars import check_items, check_mapping, check_real, require
from mechproof.kernel_support.arrays import as_floats
from mechproof.kernels import wedge_linkage as kernels
from mechproof.mechanisms.parameters import check_domain, choose_published
from mechproof.mechanisms.pointwise_types import pointwise
from mechproof.mechanisms.units import Units
from mechproof.tools.notebook import Displayed

if TYPE_CHECKING:
    from mechproof.tolerance import CornerRange, Size


class PusherReachError(ValueError):
    """The guide BC cannot follow the pusher: the radicand of Q is negative."""


class RollerLeverReachError(ValueError):
    """The roller lever cannot follow the rod: |R| > l_KL."""


@dataclass(frozen=True)
class WedgeLinkage(Displayed):
    """The linkage by its sizes: pusher in, wedge out.

    Parameters
    ----------
    l_AB, l_BC, l_CD, l_DE, l_GH, l_KL, l_LM : float
        Lengths and the clearance l_GH (mm), positive.
    alpha_DE, alpha_KL, alpha_LM : float
        Directions of the arms at x1 = 0 (rad), 0 < alpha_KL < pi.
    degrees : bool
        Whether the directions are in degrees; not a field.

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
    degrees: InitVar[bool] = field(default=False, kw_only=True)

    def __post_init__(self, degrees: bool) -> None:
        """Check the sizes and convert them to floats."""
        units = {name: "rad" if name.startswith("alpha") else "mm" for name in asdict(self)}
        Units(degrees).set_fields(self, units)
        check_domain(kernels.DOMAIN, asdict(self))

    @classmethod
    def published(cls, set: int) -> WedgeLinkage:
        """Return the nominal sizes of reconstruction 1 or 2 of Bazuev et al. 2021.

        The sizes in the paper are not fully legible. Set 1 changes one digit of l_BC and meets the
        crossing at -29.4 mm and the largest spread at -40 mm; set 2 meets the crossing and
        deviations of 10 %. Both were fitted to the crossing, so it does not confirm them.
        """
        sizes = cls.published_sizes(set).items()
        nominal: dict[str, Any] = {name: size.nominal for name, size in sizes}
        return cls(**nominal)

    @staticmethod
    def published_sizes(set: int) -> dict[str, Size]:
        """Return the sizes of reconstruction 1 or 2 with their limits (mm, rad).

        The digits of l_BC and l_DE and two deviations are illegible; both sets are fitted to the
        printed crossing of two boundary curves at x1 = -29.4 mm.
        """
        from mechproof.tolerance import Size

        sizes = choose_published(kernels.PUBLISHED, "set", set)
        return {name: Size(*limits) for name, limits in sizes.items()}

    @pointwise
    def position(self, x1: ArrayLike) -> Any:
        """Return the displacements y9 of the wedge; see `kernels.wedge_linkage`.

        Raises
        ------
        PusherReachError
            Where the radicand of Q is negative.
        RollerLeverReachError
            Where |R| > l_KL; both name the first displacement concerned.

        """
        units = Units()
        moved = units.take("x1", x1, "mm")
        self._check_reach(moved)
        return units.give(kernels.position(moved, **asdict(self)), "mm")

    @pointwise
    def velocity(self, x1: ArrayLike) -> Any:
        """Return dy9/dx1, the velocity of the wedge at unit speed of the pusher.

        0 before contact; at the start of contact, the value in contact. Raises as `position`.
        """
        units = Units()
        moved = units.take("x1", x1, "mm")
        self._check_reach(moved)
        return units.give(kernels.velocity(moved, **asdict(self)), "1")

    def sensitivities(self, x1: ArrayLike, *, degrees: bool = False) -> dict[str, Any]:
        """Return dy9/d(size) for every size (mm per mm, rad or °). Raises as `position`."""
        units = Units(degrees)
        moved = units.take("x1", x1, "mm")
        self._check_reach(moved)
        columns = np.moveaxis(kernels.sensitivities(moved, **asdict(self)), -1, 0)
        return {
            name: units.give(column[()], "mm/rad" if name.startswith("alpha") else "1")
            for name, column in zip(asdict(self), columns, strict=True)
        }

    def tolerance_range(
        self,
        x1: ArrayLike,
        deviations: Mapping[str, tuple[float, float]],
        *,
        executor: Executor | None = None,
    ) -> CornerRange:
        """Return the range of y9 over all combinations of limits of the sizes.

        Parameters
        ----------
        x1 : array_like
            Displacements of the pusher (mm).
        deviations : mapping
            Name of a size and its upper and lower limit deviation (mm, rad); others are fixed.
        executor : concurrent.futures.Executor, optional
            As in `mechproof.tolerance.corner_range`.

        Raises
        ------
        TypeError, ValueError
            Names the size whose deviations are not a pair, not real numbers or not in order.

        Notes
        -----
        No bound over the box of sizes; `mechproof.tolerance.certified_range` gives one.
        Combinations outside the reach of the linkage are counted in `undefined`.

        """
        from mechproof.tolerance import corner_range

        points = check_array("x1", x1)
        check_mapping("deviations", deviations, "must map names of sizes to pairs of deviations")
        unknown = sorted(map(str, deviations.keys() - asdict(self).keys()))
        require(not unknown, "deviations", unknown, f"names must be among {[*asdict(self)]}")
        sizes = {
            name: _make_size(name, nominal, deviations.get(name, (0.0, 0.0)))
            for name, nominal in asdict(self).items()
        }
        with np.errstate(invalid="ignore"):
            return corner_range(kernels.position, points, sizes, executor=executor)

    def _check_reach(self, x1: ArrayLike) -> None:
        """Raise for the first displacement that the linkage cannot follow; NaN passes."""
        (moved,) = (np.ravel(a).astype(np.float64) for a in as_floats("x1", x1))
        radicand = kernels.guide_radicand(moved, self.l_AB, self.l_BC, self.l_CD)
        if (beyond := radicand < 0).any():
            raise PusherReachError(
                f"x1 = {moved[beyond][0]}: the radicand of Q, guide_radicand = "
                f"{radicand[beyond][0]:.6g}, must not be negative"
            )
        turned = kernels.lever_angle(moved, self.l_AB, self.l_BC, self.l_CD)
        run = kernels.rod_displacement(turned, self.l_DE, self.alpha_DE)
        pushed = kernels.clearance(run, self.l_GH)
        projection = kernels.roller_offset(pushed, self.l_KL, self.alpha_KL)
        if (beyond := np.abs(projection) > self.l_KL).any():
            raise RollerLeverReachError(
                f"x1 = {moved[beyond][0]}: |R| <= l_KL = {self.l_KL!r} is violated, "
                f"R = roller_offset = {projection[beyond][0]:.6g}"
            )


def _make_size(name: str, nominal: float, pair: Any) -> Size:
    """Return a size with its upper and its lower deviation; errors name the deviations."""
    from mechproof.tolerance import Size

    where = f"deviations[{name!r}]"
    upper, lower = check_items(where, pair, 2, "must be a pair, the upper and the lower deviation")
    ends = check_real(f"{where}[0]", upper), check_real(f"{where}[1]", lower)
    try:
        return Size(nominal, *ends)
    except ValueError as error:
        raise ValueError(f"{where} = {pair!r}: {error}") from None
