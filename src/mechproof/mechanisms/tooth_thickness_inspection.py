"""Sorting of gears by the measured tooth thickness: the four shares of parts and the two risks.

Every law is given by the caller: the paper prints none, nor how a standard deviation follows from
an IT grade or from the limit error of a gauge.

>>> from mechproof import ThicknessInspection
>>> from mechproof.conformity import Normal
>>> gauge = Normal.from_width(0.0, 0.004, 4)  # U = 2 um, coverage factor 2
>>> inspection = ThicknessInspection.published(
...     true=Normal.from_width(-0.0345, 0.045, 6),  # centred, K = 6
...     tip_diameter=Normal.from_width(0.0, IT_120_TO_180[8], 6),
...     height=gauge,
...     thickness=gauge,
... )
>>> round(100 * float(inspection.producer_risk()), 2)  # per cent of parts
0.63
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from concurrent.futures import Executor
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.arrays import check_flag, check_pair
from mechproof.arguments.scalars import refuse, require
from mechproof.conformity import (
    Law,
    Normal,
    Shares,
    SimulatedShares,
    conformance_probability,
    simulate_shares,
)
from mechproof.conformity.risks import Limits
from mechproof.kernels.forms import tooth_thickness as forms
from mechproof.laws.kinds import check_law
from mechproof.mechanisms.tooth_thickness import ToothThickness
from mechproof.mechanisms.tooth_thickness_errors import add_normals, exact_shares, scale_law
from mechproof.notebook import Displayed

__all__ = ["IT_120_TO_180", "ThicknessInspection"]

# ISO 286-1, standard tolerances of sizes above 120 up to 180 mm, in mm, by grade.
IT_120_TO_180: Mapping[int, float] = MappingProxyType({6: 0.025, 7: 0.040, 8: 0.063})

# Paper on tooth thickness: smallest decrease 12 um, tolerance 45 um; as deviations.
PUBLISHED_TOLERANCE = (-0.057, -0.012)


@dataclass(frozen=True, eq=False)
class ThicknessInspection(Displayed):
    """A wheel, the limits of its tooth thickness, and the laws of the part and of the errors.

    Parameters
    ----------
    wheel : ToothThickness
        The wheel.
    tolerance : (lower, upper)
        Tolerance limits of the deviation of the constant chord (mm); a prescribed decrease
        E_cs with the tolerance T_c is (-E_cs - T_c, -E_cs).
    true : Law
        Law of the true deviation of the constant chord (mm).
    tip_diameter : Law
        Law of the deviation of the tip diameter (mm).
    height : Law
        Law of the error of the gauge's height (mm), positive if set too deep.
    thickness : Law
        Law of the gauge's indication error in thickness (mm).
    steps_as_printed : bool
        Follow the paper's steps 5 and 6, which count the tip diameter as a radius and with the
        wrong sign; by default they follow the geometry.

    Raises
    ------
    TypeError, ValueError
        If the wheel, a law or a flag is none, or the lower limit is not below the upper one; the
        message names it.

    Notes
    -----
    The parameters of all laws and limits broadcast. The change of thickness with the height is
    taken to first order; `wheel.linearisation_bound` tells what that neglects.

    Source: paper on tooth thickness, steps 1-10; JCGM 106:2012 for the risks.

    """

    wheel: ToothThickness
    tolerance: Limits
    true: Law
    tip_diameter: Law
    height: Law
    thickness: Law
    steps_as_printed: bool = False

    def __post_init__(self) -> None:
        """Check the limits and the kinds of all else, which has checked itself."""
        is_wheel = isinstance(self.wheel, ToothThickness)
        require(is_wheel, "wheel", self.wheel, "must be a ToothThickness", TypeError)
        object.__setattr__(self, "tolerance", check_pair("tolerance", self.tolerance))
        for name in ("true", "tip_diameter", "height", "thickness"):
            check_law(name, getattr(self, name))
        printed = check_flag("steps_as_printed", self.steps_as_printed)
        object.__setattr__(self, "steps_as_printed", printed)

    @classmethod
    def published(
        cls,
        *,
        true: Law,
        tip_diameter: Law,
        height: Law,
        thickness: Law,
        steps_as_printed: bool = False,
    ) -> ThicknessInspection:
        """Return the wheel and the limits of the paper, E_cs = 12 um and T_c = 45 um.

        The deviation has to lie between -57 and -12 um: E_cs is a prescribed decrease. Step 2 as
        printed has -33 to 12 um; a law of the true deviation moved likewise has the same shares.
        """
        laws = true, tip_diameter, height, thickness
        return cls(ToothThickness.published(), PUBLISHED_TOLERANCE, *laws, steps_as_printed)

    @property
    def influences(self) -> tuple[float, float]:
        """Change of the measured thickness with the tip diameter and with the gauge's height."""
        tip, height = [1.0, 0.0], [0.0, 1.0]
        by_tip, by_height = (
            forms.thickness_error_printed(tip, height, self.wheel.alpha)
            if self.steps_as_printed
            else self.wheel.thickness_error(tip, height)
        )
        return float(by_tip), float(by_height)

    @property
    def errors(self) -> tuple[Law, Law, Law]:
        """Laws of the errors of the measured thickness: tip diameter, height, indication."""
        tip, height = self.influences
        return scale_law(self.tip_diameter, tip), scale_law(self.height, height), self.thickness

    def shares(self, acceptance: Limits | None = None) -> Shares:
        """Return the exact shares of rightly and wrongly accepted and rejected parts.

        `acceptance` are the acceptance limits if there is a guard band. See `exact_shares` for
        the accuracy and `conformity.shares` for arguments and errors.
        """
        return exact_shares(self.true, self.errors, self.tolerance, acceptance)

    def simulate(
        self,
        *,
        rng: np.random.Generator,
        count: int,
        acceptance: Limits | None = None,
        chunk: int = 1 << 18,
        progress: Callable[[int, int], object] | None = None,
        executor: Executor | None = None,
    ) -> SimulatedShares:
        """Return the shares among `count` simulated teeth, with their standard errors.

        Steps 1-10, in chunks of bounded memory; see `conformity.simulate_shares`, also for the
        errors raised and for `progress` and `executor`.
        """
        return simulate_shares(
            self.true,
            self.errors,
            self.tolerance,
            acceptance,
            rng=rng,
            count=count,
            chunk=chunk,
            progress=progress,
            executor=executor,
        )

    def consumer_risk(self, acceptance: Limits | None = None) -> Any:
        """Return the global consumer's risk: the part does not conform and is accepted."""
        return self.shares(acceptance).wrongly_accepted

    def producer_risk(self, acceptance: Limits | None = None) -> Any:
        """Return the global producer's risk: the part conforms and is rejected."""
        return self.shares(acceptance).wrongly_rejected

    def conformance_probability(self, measured: ArrayLike) -> tuple[Any, Any]:
        """Return the probabilities that a tooth of this measured deviation conforms, and not.

        Raises TypeError naming the first law that is not normal.
        """
        names = ("true", "tip_diameter", "height", "thickness")
        wrong = [name for name in names if not isinstance(getattr(self, name), Normal)]
        errors = [law for law in self.errors if isinstance(law, Normal)]
        if wrong or not isinstance(self.true, Normal):
            law = getattr(self, wrong[0])
            refuse(wrong[0], law, "must be Normal for a conformance probability", TypeError)
        return conformance_probability(measured, self.true, add_normals(errors), self.tolerance)
