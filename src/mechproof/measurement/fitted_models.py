"""Models that are fitted to encoder readings, their errors and derivatives, and the starts."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from mechproof.derivatives import differentiate
from mechproof.kernels import elliptic_planetary, oval_planetary
from mechproof.measurement.uncertainty import wrap_angle

Floats = NDArray[np.float64]
# The zeros of the encoders: their readings where the mechanism is at its own zero.
ZEROS = ("phi1_zero", "phi3_zero")
# Eccentricities tried as starts, and the number of carrier zeros tried in a period.
ECCENTRICITIES = (0.05, 0.25, 0.45, 0.65, 0.8, 0.9, 0.96)
PARTS = 12
_ECCENTRICITIES = np.array(ECCENTRICITIES)[:, None, None]
# Number of starts refined; turns of the readings that choose them, and most such readings.
REFINED, TURNS, CHOSEN = 12, 4, 200
# Beyond this, the kernels' derivatives grow without bound.
FLATTEST = 1 - 1e-6


class FittedModel(NamedTuple):
    """How a position function is fitted.

    `fixed` holds arguments that positions do not determine, `fitted` the names of those they do.
    `speed` is how many times shorter than 2 pi the period of the carrier is, per unit of ratio.
    """

    fixed: Mapping[str, float]
    fitted: Mapping[str, str]
    speed: float
    least: float = 0.0


MODELS: Mapping[Callable[..., Any], FittedModel] = MappingProxyType(
    {
        elliptic_planetary.position: FittedModel({"R2": 1.0}, {"R1/R2": "R1", "e": "e"}, 1.0, 1.0),
        oval_planetary.position_cylindrical: FittedModel(
            {"R5": 1.0}, {"R4/R5": "R4", "e2": "e2"}, 2.0
        ),
        oval_planetary.position: FittedModel({"e1": 0.0, "mount": 0.0}, {"e2": "e2"}, 2.0),
    }
)


class Minimum(NamedTuple):
    """Parameters, the sizes among them, and the sum of squared errors there."""

    values: Floats
    sizes: Floats
    square: float


class FittingProblem:
    """Readings and the model that is fitted to them."""

    def __init__(
        self,
        position: Callable[..., Any],
        model: FittedModel,
        angles: Floats,
        readings: Floats,
        zeros: bool,
    ) -> None:
        self.position, self.model = position, model
        self.angles, self.readings, self.zeros = angles, readings, zeros
        self.names = (*model.fitted, *(ZEROS if zeros else ()))

    def find_errors(self, values: Floats, chosen: Any = slice(None)) -> Floats:
        """Return measured minus calculated angles, each on the nearest turn."""
        arguments, (_, zero) = self._split(values, chosen)
        errors: Floats = wrap_angle(self.readings[chosen] - zero - self.position(**arguments))
        return errors

    def differentiate(self, values: Floats, chosen: Any = slice(None)) -> Floats:
        """Return the derivatives of the calculated angles by the parameters."""
        arguments, _ = self._split(values, chosen)
        slopes = differentiate(self.position, arguments)
        assert slopes is not None
        columns = [slopes[name] for name in self.model.fitted.values()]
        if self.zeros:
            columns += [-slopes["phi1"], np.ones(self.angles[chosen].shape)]
        return np.stack(columns, axis=-1)

    def find_minima(self, lowest: float, highest: float) -> Iterator[Minimum]:
        """Refine the best starts on more and more turns."""
        for start in self._choose_starts(max(lowest, self.model.least), highest):
            values = start
            for chosen in self._list_windows():
                values = self._refine(values, chosen)
            values = self._normalise(values)
            square = float(np.sum(self.find_errors(values) ** 2))
            yield Minimum(values, values[: len(self.model.fitted)], square)

    def describe(self, minimum: Minimum) -> list[str]:
        """Write the sizes of a minimum."""
        return [f"{n} = {v:.6g}" for n, v in zip(self.model.fitted, minimum.sizes, strict=True)]

    def _split(self, values: Floats, chosen: Any) -> tuple[dict[str, Any], tuple[float, float]]:
        """Return the arguments of the position function, and the zeros of both encoders."""
        sizes = dict(zip(self.model.fitted.values(), values, strict=False))
        first, second = values[-2:] if self.zeros else (0.0, 0.0)
        phi1 = self.angles[chosen] - first
        return {"phi1": phi1, **self.model.fixed, **sizes}, (first, second)

    def _refine(self, start: Floats, chosen: Any) -> Floats:
        from scipy.optimize import least_squares

        count = len(self.model.fitted)
        lower, upper = np.full(start.shape, -np.inf), np.full(start.shape, np.inf)
        # The quotient comes before the eccentricity; its domain is open at its least value.
        lower[: count - 1] = np.nextafter(self.model.least, np.inf)
        lower[count - 1], upper[count - 1] = 0.0, FLATTEST
        found = least_squares(
            lambda values: self.find_errors(values, chosen),
            np.clip(start, lower, upper),
            lambda values: -self.differentiate(values, chosen),
            (lower, upper),
            x_scale="jac",
        )
        values: Floats = found.x
        return values

    def _list_windows(self) -> Iterator[NDArray[np.bool_]]:
        """List the readings to use: those of a few turns, of twice as many, and so on to all."""
        run = self.angles - self.angles.min()
        turns = 2 * math.pi * TURNS
        while np.count_nonzero(run <= turns) < min(run.size, 10 * len(self.names)):
            turns *= 2
        while True:
            yield run <= turns
            if turns >= run.max():
                return
            turns *= 2

    def _choose_starts(self, lowest: float, highest: float) -> list[Floats]:
        """Choose the grid nodes where the errors agree best, over all zeros of the output."""
        inside = np.flatnonzero(next(self._list_windows()))
        if inside.size > CHOSEN:
            inside = np.random.default_rng(1).choice(inside, CHOSEN, replace=False)
        run = float(np.ptp(self.angles[inside]))
        ratios: Any = [()]
        if len(self.model.fitted) > 1:
            # From node to node, the calculated angles change by less than half a radian.
            count = max(2, math.ceil((highest - lowest) * (run + 1) * self.model.speed))
            ratios = np.linspace(lowest, highest, count + 2)[1:-1, None]
        found = [self._try(tuple(ratio), inside) for ratio in ratios]
        if len(found) > 1:
            agreed = np.array([tried[0][0] for tried in found])
            beside = np.pad(agreed, 1, constant_values=-1.0)
            peaks = (agreed >= beside[:-2]) & (agreed >= beside[2:])
            found = [tried for tried, peak in zip(found, peaks, strict=True) if peak]
        best = sorted((start for tried in found for start in tried), key=lambda s: -s[0])
        return [values for _, values in best[:REFINED]]

    def _try(self, ratio: tuple[float, ...], inside: Any) -> list[tuple[float, Floats]]:
        """Return the best agreement at a ratio (1 if all errors are equal) and its parameters."""
        period = 2 * math.pi / (self.model.speed * (ratio[0] if ratio else 1.0))
        zeros = period / PARTS * np.arange(PARTS) if self.zeros else np.zeros(1)
        sizes = dict(zip(self.model.fitted.values(), (*ratio, _ECCENTRICITIES), strict=True))
        phi1 = self.angles[inside] - zeros[:, None]
        calculated = self.position(**{"phi1": phi1, **self.model.fixed, **sizes})
        # The mean direction of angles (Fisher 1993).
        mean = np.mean(np.exp(1j * (self.readings[inside] - calculated)), axis=-1)
        agreed = np.abs(mean) if self.zeros else mean.real
        best = np.argsort(-agreed, axis=None)[: 1 if ratio else REFINED]
        places = zip(*np.unravel_index(best, agreed.shape), strict=True)
        return [
            (
                float(agreed[i, j]),
                np.array(
                    [
                        *ratio,
                        ECCENTRICITIES[i],
                        *((zeros[j], np.angle(mean[i, j])) if self.zeros else ()),
                    ]
                ),
            )
            for i, j in places
        ]

    def _normalise(self, values: Floats) -> Floats:
        """Subtract whole periods from the carrier's zero, and turns from the output's."""
        if not self.zeros:
            return values
        ratio = values[0] if len(self.model.fitted) > 1 else 1.0
        period = 2 * math.pi / (self.model.speed * ratio)
        shift = period * round(values[-2] / period)
        arguments = {**self._split(values, slice(None))[0], "phi1": shift}
        first = values[-2] - shift
        second = float(wrap_angle(values[-1] - self.position(**arguments)))
        return np.array([*values[:-2], first, second])
