"""Parameters of a planetary mechanism from readings of the encoders on both shafts.

Least squares of the output's errors, each taken to the nearest turn, with the derivatives of the
kernels (Gauss-Newton steps with the trust region of `scipy.optimize.least_squares`). Such errors
have many minima, so starts are searched over a grid so fine that the right one lies within a
fraction of a turn of a node. If the readings cannot tell several minima apart, none is returned.

What is identifiable: positions determine only the quotient of radii and, for two oval pairs, only
the single pair that moves alike (e2 with e1 = mount = 0).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.array_checks import check_array, check_flag, check_pair
from mechproof.arguments.scalars import check_not_negative, refuse, require
from mechproof.measurement.estimate import Estimate
from mechproof.measurement.fitted_models import MODELS, ZEROS, FittingProblem, Floats, Minimum

# Beyond this condition number, no readings tell the parameters apart.
LARGEST_CONDITION = 1e7
# Root mean square of errors to the nearest turn (rad): if they are random, it is pi/sqrt(3) = 1.8.
LARGEST_ERROR = 0.5
# Minima whose sums of squares differ by fewer variances are not told apart: 25 is 5 sigma.
CLEARANCE = 25.0
# Error that least squares leave even in an exact fit (rad, per radian of the carrier).
SHARPEST = 1e-9
# Minima are the same if their parameters are closer than this, relative to 1 and to themselves.
SAME = 0.01


@dataclass(frozen=True, eq=False)
class Fit:
    """Estimates of parameters with their covariance matrix, in the order of `names`.

    `sensitivities` are the derivatives of every reading with respect to the parameters, `residuals`
    the remaining errors (rad). `standard_deviation` is that of one reading, from the residuals or
    as stated. `condition` is the condition number of the sensitivities, each scaled to norm 1: near
    1 all parameters are told apart; at 10**n some of them are known to n digits less together than
    each would be alone.
    """

    names: tuple[str, ...]
    values: Floats
    covariance: Floats
    standard_deviation: float
    degrees_of_freedom: float
    sensitivities: Floats
    residuals: Floats
    condition: float

    @property
    def estimates(self) -> dict[str, Estimate]:
        """Return every parameter with its standard uncertainty; zeros of encoders in radians."""
        spread = np.sqrt(np.diag(self.covariance))
        return {
            name: Estimate(
                float(value), float(u), self.degrees_of_freedom, "rad" if name in ZEROS else ""
            )
            for name, value, u in zip(self.names, self.values, spread, strict=True)
        }

    @property
    def correlations(self) -> dict[tuple[str, str], float]:
        """Return the correlation coefficients in the form that `propagate` accepts."""
        spread = np.sqrt(np.diag(self.covariance))
        matrix = self.covariance / np.outer(spread, spread)
        pairs = zip(*np.triu_indices(len(self.names), 1), strict=True)
        return {(self.names[i], self.names[j]): float(matrix[i, j]) for i, j in pairs}

    def __str__(self) -> str:
        """Print one parameter per line in the notation of the GUM, and the readings' scatter."""
        lines = [f"{name} = {estimate}" for name, estimate in self.estimates.items()]
        scatter = f"readings scatter by {self.standard_deviation:.2g} rad"
        return "\n".join([*lines, f"{scatter}, condition {self.condition:.3g}"])


def fit(
    position: Callable[..., Any],
    phi1: ArrayLike,
    measured: ArrayLike,
    *,
    ratio: tuple[float, float] = (0.1, 12.0),
    uncertainty: float | None = None,
    zeros: bool = True,
) -> Fit:
    """Fit a planetary mechanism to readings of both encoders.

    Parameters
    ----------
    position
        `position` of `mechproof.kernels.elliptic_planetary` (fits R1/R2 and e), `position` or
        `position_cylindrical` of `oval_planetary` (e2; R4/R5 and e2). Radii, and the
        eccentricities of two oval pairs, cannot be told apart: give one, and the other follows.
    phi1, measured
        Readings of the carrier's encoder, with every turn counted, and of the output's, on any turn
        (rad); one-dimensional, of the same length. Pairs with a NaN raise ValueError.
    ratio
        Range in which the quotient of radii is sought.
    uncertainty
        Standard uncertainty of one reading (rad), if known; by default it is estimated from the
        residuals.
    zeros
        Whether to fit the encoders' zeros, too; otherwise both are those of the mechanism.

    Raises
    ------
    TypeError, ValueError
        Names the argument. ValueError also if no parameters explain the readings, if several sets
        explain them equally, or if the readings do not determine the parameters.

    Notes
    -----
    The carrier's zero is determined to whole periods and chosen next to 0; the output's, to turns.

    """
    known = ", ".join(f"{f.__module__}.{f.__name__}" for f in MODELS)
    is_known = callable(position) and position in MODELS
    require(is_known, "position", position, f"must be one of the kernels {known}")
    fitted = check_flag("zeros", zeros)
    problem = FittingProblem(position, MODELS[position], *_check_readings(phi1, measured), fitted)
    spread = None if uncertainty is None else check_not_negative("uncertainty", uncertainty)
    lowest, highest = (float(end) for end in check_pair("ratio", ratio))
    require(math.isfinite(highest - lowest), "ratio", ratio, "must be finite")
    allowed = f"has {problem.angles.size} readings for {len(problem.names)} parameters"
    require(problem.angles.size > len(problem.names), "phi1", phi1, allowed)
    minima = sorted(problem.find_minima(lowest, highest), key=lambda minimum: minimum.square)
    return _conclude(problem, minima, spread)


def _conclude(problem: FittingProblem, minima: list[Minimum], uncertainty: float | None) -> Fit:
    """Return the lowest minimum; ValueError unless it is unique, small, and sharp."""
    best, count = minima[0], problem.angles.size
    error = math.sqrt(best.square / count)
    if not error <= LARGEST_ERROR:
        text = f"the best of all starts leaves a root-mean-square error of {error:.2g} rad"
        text = f"no parameters in these ranges explain it, in radians: {text}"
        refuse("measured", problem.readings, text)
    freedom = count - len(problem.names)
    deviation = math.sqrt(best.square / freedom) if uncertainty is None else uncertainty
    # Even readings without scatter leave the error of least squares itself.
    noise = max(deviation, SHARPEST * (1 + np.abs(problem.angles).max()))
    for other in minima[1:]:
        apart = np.abs(other.sizes - best.sizes) > SAME * np.maximum(1, np.abs(best.sizes))
        if apart.any() and other.square - best.square < CLEARANCE * noise**2:
            sets = " and ".join(", ".join(problem.describe(m)) for m in (best, other))
            text = f"these readings do not distinguish {sets}"
            refuse("phi1", problem.angles, f"{text}; narrow ratio, or read at uneven angles")
    jacobian = problem.differentiate(best.values)
    norms = np.linalg.norm(jacobian, axis=0)
    with np.errstate(divide="ignore", invalid="ignore"):
        scaled = jacobian / norms
    condition = float(np.linalg.cond(scaled)) if np.isfinite(scaled).all() else math.inf
    if not condition <= LARGEST_CONDITION:
        text = f"the readings do not determine {', '.join(problem.names)} together"
        zeros = "; with e = 0 the zeros of both encoders are the same" if problem.zeros else ""
        refuse("phi1", problem.angles, f"{text} (condition {condition:.2g}){zeros}")
    inverse = np.linalg.inv(scaled.T @ scaled) / np.outer(norms, norms)
    return Fit(
        problem.names,
        best.values,
        deviation**2 * inverse,
        deviation,
        freedom if uncertainty is None else math.inf,
        jacobian,
        problem.find_errors(best.values),
        condition,
    )


def _check_readings(phi1: ArrayLike, measured: ArrayLike) -> tuple[Floats, Floats]:
    angles, readings = check_array("phi1", phi1), check_array("measured", measured)
    for name, array in (("phi1", angles), ("measured", readings)):
        require(array.ndim == 1, name, array, f"must have one dimension, not shape {array.shape}")
        require(np.isfinite(array).all(), name, array, "must be finite")
    allowed = f"has {readings.size} readings, phi1 has {angles.size}"
    require(angles.size == readings.size, "measured", measured, allowed)
    return angles, readings
