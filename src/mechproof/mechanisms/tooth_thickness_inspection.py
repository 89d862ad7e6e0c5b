"""Sorting of gears by the measured tooth thickness: the four shares of parts and the two risks.

The caller gives every law: the paper states none, nor how a standard deviation follows from an IT
grade or from the limit error of a gauge.

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
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.array_checks import check_flag, check_pair
from mechproof.arguments.scalars import check_real, refuse, require
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
from mechproof.mechanisms.tooth_thickness_design import (
    Window,
    check_symmetric,
    choose_risk,
    find_acceptance,
    find_factor,
    get_risk,
)
from mechproof.mechanisms.tooth_thickness_errors import add_normals, exact_shares, scale_law
from mechproof.tools.notebook import Displayed

# ISO 286-1, standard tolerances of sizes above 120 up to 180 mm, in mm, by grade.
IT_120_TO_180: Mapping[int, float] = MappingProxyType(
    {5: 0.018, 6: 0.025, 7: 0.040, 8: 0.063, 9: 0.100, 10: 0.160, 11: 0.250}
)

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
        wrong sign; by default, follow the geometry.

    Raises
    ------
    TypeError, ValueError
        If the wheel, a law or a flag has the wrong type, or the lower limit is not below the upper
        one; the message names it.

    Notes
    -----
    The parameters of all laws and limits broadcast. The change of thickness with the height is
    taken to first order; `wheel.linearisation_bound` bounds what that neglects.

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
        """Check the limits and the types of all other fields, which check themselves."""
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
        printed has -33 to 12 um; the shares are the same if the true deviation's law moves as much.
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

        `acceptance` gives the acceptance limits if there is a guard band. See `exact_shares` for
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
        """Return the probabilities that a tooth of this measured deviation conforms, or does not.

        Raises TypeError naming the first law that is not normal.
        """
        names = ("true", "tip_diameter", "height", "thickness")
        wrong = [name for name in names if not isinstance(getattr(self, name), Normal)]
        errors = [law for law in self.errors if isinstance(law, Normal)]
        if wrong or not isinstance(self.true, Normal):
            law = getattr(self, wrong[0])
            refuse(wrong[0], law, "must be Normal for a conformance probability", TypeError)
        return conformance_probability(measured, self.true, add_normals(errors), self.tolerance)

    def acceptance_limits(
        self, *, consumer_risk: float | None = None, producer_risk: float | None = None
    ) -> tuple[float, float]:
        """Return the acceptance limits for a wanted global risk.

        Both differ from the tolerance limits by the same guard band: inwards if the consumer's risk
        has to be less than with simple acceptance (guarded acceptance), outwards if the producer's
        has to be (guarded rejection). An infinite limit stays infinite.

        Parameters
        ----------
        consumer_risk, producer_risk : float
            One wanted risk: below the share of teeth that do not conform, or that do.

        Returns
        -------
        (lower, upper)
            Limits of the measured deviation (mm), as `shares` takes them.

        Raises
        ------
        TypeError
            If neither risk is given, or both are.
        ValueError
            If the risk is out of reach, or the laws and limits are several sets of parameters.

        Notes
        -----
        Root of a monotonic function; the risk has the accuracy of `shares`.

        Source: JCGM 106:2012, clauses 8 and 9.5.

        """
        name, risk = choose_risk(consumer_risk, producer_risk)
        laws = self.true, *self.errors
        reach = sum(float(np.max(np.abs(law.knots()))) for law in laws)
        low, high = self._window
        reach += max((abs(limit) for limit in (low, high) if np.isfinite(limit)), default=0.0)
        return find_acceptance(name, risk, self.shares, (low, high), reach)

    def scale_gauge(
        self, *, consumer_risk: float | None = None, producer_risk: float | None = None
    ) -> ThicknessInspection:
        """Return this inspection with the largest gauge errors that keep a wanted global risk.

        The errors of the gauge, `height` and `thickness`, are multiplied by one factor, the largest
        up to which the risk is no more than wanted, with simple acceptance. The producer's risk
        rises with the factor. The consumer's may fall again, because the gauge scatters as widely
        as the tolerance; this part is left out.

        Parameters
        ----------
        consumer_risk, producer_risk : float
            One wanted risk: above that of a gauge without error.

        Raises
        ------
        TypeError
            If neither risk is given, or both are.
        ValueError
            If the risk is out of reach, an error's law is not symmetric about 0, the gauge has no
            error that can be scaled, or the laws and limits are several sets of parameters.

        Notes
        -----
        Root of a monotonic function; the risk has the accuracy of `shares`.

        Source: paper on tooth thickness, Figs. 4 and 5; JCGM 106:2012, clause 9.5.

        """
        name, risk = choose_risk(consumer_risk, producer_risk)
        for error in ("tip_diameter", "height", "thickness"):
            check_symmetric(error, getattr(self, error))
        has_error = any(np.any(law.knots() != 0) for law in (self.height, self.thickness))
        require(
            has_error, "thickness", self.thickness, "this or height must have an error to scale"
        )
        tip, *others = self.errors

        def scaled(factor: float, tolerance: Window, acceptance: Window) -> Shares:
            errors = [scale_law(law, factor) for law in others] if factor else []
            return exact_shares(self.true, [tip, *errors], tolerance, acceptance)

        factor = find_factor(name, risk, scaled, self._window)
        height, thickness = (scale_law(law, factor) for law in (self.height, self.thickness))
        return replace(self, height=height, thickness=thickness)

    def tip_grade(
        self,
        *,
        multiple: float,
        consumer_risk: float | None = None,
        producer_risk: float | None = None,
    ) -> int:
        """Return the coarsest IT grade of the tip diameter that keeps a wanted global risk.

        Of the grades in `IT_120_TO_180`; with it and every finer one, the risk is no more than
        wanted.

        Parameters
        ----------
        multiple : float
            Standard deviations in the tolerance field, which is centred on the nominal size: the
            deviation has the law Normal.from_width(0, IT, multiple).
        consumer_risk, producer_risk : float
            One wanted risk: at least that with the finest grade.

        Raises
        ------
        TypeError
            If neither risk is given, or both are, or `multiple` is no real number.
        ValueError
            If the risk is out of reach, the tip diameter beyond 120 to 180 mm, `multiple` not
            positive, or the laws and limits are several sets of parameters.

        """
        name, risk = choose_risk(consumer_risk, producer_risk)
        check_real("multiple", multiple)
        tip = self.wheel.m * (self.wheel.z + 2)
        allowed = f"must have a tip diameter above 120 and up to 180 mm, not {tip!r} mm"
        require(120 < tip <= 180, "wheel", self.wheel, allowed)
        coarsest = None
        for grade, field in IT_120_TO_180.items():
            part = replace(self, tip_diameter=Normal.from_width(0.0, field, multiple))
            found = get_risk(name, part.shares())
            if found > risk:
                break
            coarsest = grade
        if coarsest is None:
            refuse(name, risk, f"must be at least {found!r}, that of IT{grade}")
        return coarsest

    @property
    def _window(self) -> Window:
        """The tolerance limits; ValueError if there are several sets."""
        low, high = (np.asarray(limit) for limit in self.tolerance)
        one = low.ndim == high.ndim == 0
        require(one, "tolerance", self.tolerance, "must be one pair of numbers here")
        return float(low), float(high)
