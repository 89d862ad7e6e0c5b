"""Numbers of the package uncertainties (`ufloat`): in and out, where it is installed."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import combinations
from typing import Any

from mechproof.arguments.scalars import require
from mechproof.measurement.estimate import Estimate
from mechproof.tools.extras import tell_missing


def is_uncertain(value: Any) -> bool:
    """Return whether a value is a ufloat, or a function of some; without importing the package."""
    return hasattr(value, "nominal_value") and hasattr(value, "std_dev")


def read_uncertain(value: Any) -> Estimate:
    """Return the estimate that a ufloat is; its degrees of freedom count as infinite."""
    return Estimate(float(value.nominal_value), float(value.std_dev))


def read_correlations(inputs: Mapping[str, Any]) -> dict[tuple[str, str], float]:
    """Return the correlation coefficients of the ufloats among inputs, those that are not zero."""
    names = [name for name, value in inputs.items() if is_uncertain(value) and value.std_dev]
    if len(names) < 2:
        return {}
    matrix = _load().correlation_matrix([inputs[name] for name in names])
    pairs = combinations(range(len(names)), 2)
    return {(names[i], names[j]): float(matrix[i, j]) for i, j in pairs if matrix[i, j]}


def to_ufloat(estimate: Estimate) -> Any:
    """Return the ufloat of an estimate, a new variable; ImportError without the package."""
    is_estimate = isinstance(estimate, Estimate)
    require(is_estimate, "estimate", estimate, "must be an Estimate", TypeError)
    return _load().ufloat(estimate.value, estimate.uncertainty)


def _load() -> Any:
    try:
        import uncertainties
    except ImportError as error:
        raise ImportError(tell_missing("a ufloat", "uncertain", error.name)) from error
    return uncertainties
