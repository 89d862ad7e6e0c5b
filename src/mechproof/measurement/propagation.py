"""The law of propagation of uncertainty (JCGM 100, 5.1 and 5.2), also for `ufloat`s.

It is of first order. The propagation of distributions (JCGM 101) samples, as
`tolerance.monte_carlo_range` does for sizes that scatter; `certified_range` bounds the values that
a quantity can take.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import combinations
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechproof.arguments.array_checks import check_array
from mechproof.arguments.scalars import (
    check_function,
    check_items,
    check_mapping,
    check_real,
    check_text,
    require,
)
from mechproof.derivatives import differentiate
from mechproof.measurement.estimate import Estimate
from mechproof.tools.extras import describe_missing

Correlations = Mapping[tuple[str, str], float]
NONE: Correlations = MappingProxyType({})


@dataclass(frozen=True, eq=False)
class Propagation:
    """A value computed from uncertain inputs; for an array, at every point.

    `sensitivities` are the coefficients c_i = d f/d x_i at the estimates, `correlations` the
    coefficients of correlated inputs.
    """

    value: Any
    inputs: Mapping[str, Estimate]
    sensitivities: Mapping[str, Any]
    correlations: Correlations
    unit: str = ""

    @property
    def contributions(self) -> dict[str, Any]:
        """Return u_i(y) = |c_i| u(x_i) of every input (GUM 5.1.3)."""
        return {name: abs(part) for name, part in self._signed.items()}

    @property
    def uncertainty(self) -> Any:
        """Return the combined standard uncertainty (GUM 5.1.2; with correlations 5.2.2)."""
        names, signed = list(self.inputs), np.stack(np.broadcast_arrays(*self._signed.values()))
        matrix = to_matrix(names, self.correlations)
        square = np.einsum("i...,ij,j...->...", signed, matrix, signed)
        # With full correlation, rounding may make the sum negative.
        return np.sqrt(np.maximum(square, 0.0))[()]

    @property
    def degrees_of_freedom(self) -> Any:
        """Return the effective degrees of freedom (GUM G.4.1).

        NaN, unknown, if a correlated input has a finite number of them.
        """
        finite = {n: x for n, x in self.inputs.items() if math.isfinite(x.degrees_of_freedom)}
        if not finite:
            return np.full(np.shape(self.uncertainty), np.inf)[()]
        if any(finite.keys() & pair for pair in self.correlations):
            return np.full(np.shape(self.uncertainty), np.nan)[()]
        with np.errstate(divide="ignore", invalid="ignore"):
            shares = {n: self.contributions[n] / self.uncertainty for n in finite}
            loss = sum(s**4 / finite[n].degrees_of_freedom for n, s in shares.items())
            return np.divide(1.0, loss)[()]

    @property
    def estimate(self) -> Estimate:
        """Return value and uncertainty; ValueError for an array."""
        require(np.ndim(self.value) == 0, "estimate", self.value, "must be one value, not many")
        value, uncertainty = float(self.value), float(self.uncertainty)
        return Estimate(value, uncertainty, float(self.degrees_of_freedom), self.unit)

    @property
    def _signed(self) -> dict[str, Any]:
        return {n: self.sensitivities[n] * x.uncertainty for n, x in self.inputs.items()}

    def __str__(self) -> str:
        """Print the result and the budget, largest contribution first."""
        whole = self.estimate
        rows = sorted(self.contributions.items(), key=lambda row: -row[1])
        lines = (
            f"  {name}: {self.inputs[name]}, c = {float(self.sensitivities[name]):.6g}, "
            f"c u = {float(part):.3g}"
            for name, part in rows
        )
        return "\n".join((str(whole), *lines))


def propagate(
    function: Callable[..., Any],
    inputs: Mapping[str, Any],
    *,
    correlations: Correlations = NONE,
    unit: str = "",
) -> Propagation:
    """Propagate the uncertainties of inputs through a function, to first order.

    Parameters
    ----------
    function
        Called with the `inputs` by name, as arrays. For a kernel of `mechproof.kernels`, the
        sensitivity coefficients come from its kernel of derivatives; for other functions, each is
        (f(x + u) - f(x - u))/(2 u), the other inputs at their estimates (GUM 5.1.3, note 2).
    inputs
        Names, each with an `Estimate`, a `ufloat` of the package uncertainties, or an exact number
        or array. Correlations between ufloats are kept.
    correlations
        Pairs of names and their correlation coefficients, between -1 and 1; others are zero.
    unit
        Unit of the result.

    Raises
    ------
    TypeError, ValueError
        Names the input; also if the coefficients are impossible together.

    """
    check_function("function", function)
    check_text("unit", unit)
    check_mapping("inputs", inputs, "must map names to Estimates and numbers")
    given = {name: _read(f"inputs[{name!r}]", value) for name, value in inputs.items()}
    uncertain = {name: value for name, value in given.items() if isinstance(value, Estimate)}
    require(uncertain, "inputs", sorted(given), "at least one must be uncertain")
    known = {**read_correlations(inputs), **_check_correlations(correlations, uncertain)}
    points = {n: x.value if isinstance(x, Estimate) else x for n, x in given.items()}
    slopes = differentiate(function, points)
    if slopes is None:
        slopes = {n: _take_difference(function, points, n, x) for n, x in uncertain.items()}
    taken = {name: slopes[name] for name in uncertain}
    return Propagation(function(**points), uncertain, taken, known, unit)


def to_matrix(names: list[str], correlations: Correlations) -> NDArray[np.float64]:
    """Return the matrix of correlation coefficients."""
    matrix = np.eye(len(names))
    for (one, other), coefficient in correlations.items():
        i, j = names.index(one), names.index(other)
        matrix[i, j] = matrix[j, i] = coefficient
    return matrix


def _read(name: str, value: Any) -> Any:
    if isinstance(value, Estimate):
        return value
    return read_uncertain(value) if is_uncertain(value) else check_array(name, value)


def _take_difference(
    function: Callable[..., Any], points: Mapping[str, Any], name: str, estimate: Estimate
) -> Any:
    """Return the slope between the estimate minus and plus its standard uncertainty."""
    low, high = (estimate.value + sign * estimate.uncertainty for sign in (-1, 1))
    if low == high:
        return np.zeros(np.shape(function(**points)))[()]
    at_low, at_high = (np.asarray(function(**{**points, name: x})) for x in (low, high))
    return ((at_high - at_low) / (high - low))[()]


def _check_correlations(
    correlations: Any, uncertain: Mapping[str, Estimate]
) -> dict[tuple[str, str], float]:
    allowed = "must map pairs of names to coefficients"
    check_mapping("correlations", correlations, allowed)
    found: dict[tuple[str, str], float] = {}
    for pair, coefficient in correlations.items():
        one, other = check_items("correlations", pair, 2, allowed)
        known = one != other and {one, other} <= uncertain.keys()
        require(known, "correlations", pair, f"must be two of {sorted(uncertain)}")
        require((other, one) not in found, "correlations", pair, "is given twice")
        where = f"correlations[{pair!r}]"
        number = check_real(where, coefficient)
        require(-1 <= number <= 1, where, coefficient, "must lie between -1 and 1")
        found[one, other] = number
    least = np.linalg.eigvalsh(to_matrix(list(uncertain), found)).min()
    # Rounding errors of the eigenvalues are a few eps of their sum.
    allowed = "must be consistent (their matrix has a negative eigenvalue)"
    require(least > -1e-12 * len(uncertain), "correlations", correlations, allowed)
    return found


def is_uncertain(value: Any) -> bool:
    """Return whether a value is a ufloat or a function of some, without importing the package."""
    return hasattr(value, "nominal_value") and hasattr(value, "std_dev")


def read_uncertain(value: Any) -> Estimate:
    """Return a ufloat as an estimate; its degrees of freedom count as infinite."""
    return Estimate(float(value.nominal_value), float(value.std_dev))


def read_correlations(inputs: Mapping[str, Any]) -> dict[tuple[str, str], float]:
    """Return the nonzero correlation coefficients of the ufloats among the inputs."""
    names = [name for name, value in inputs.items() if is_uncertain(value) and value.std_dev]
    if len(names) < 2:
        return {}
    matrix = _load().correlation_matrix([inputs[name] for name in names])
    pairs = combinations(range(len(names)), 2)
    return {(names[i], names[j]): float(matrix[i, j]) for i, j in pairs if matrix[i, j]}


def to_ufloat(estimate: Estimate) -> Any:
    """Return an estimate as a ufloat, a new variable; ImportError without the package."""
    is_estimate = isinstance(estimate, Estimate)
    require(is_estimate, "estimate", estimate, "must be an Estimate", TypeError)
    return _load().ufloat(estimate.value, estimate.uncertainty)


def _load() -> Any:
    try:
        import uncertainties
    except ImportError as error:
        raise ImportError(describe_missing("a ufloat", "uncertain", error.name)) from error
    return uncertainties
