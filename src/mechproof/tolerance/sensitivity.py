"""First-order contributions of toleranced sizes, and their root-sum-square range.

For independent sizes the root sum square is the law of propagation of uncertainty (JCGM 100,
5.1.2), with tolerances in place of standard uncertainties.
"""

from __future__ import annotations

import inspect
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.array_checks import check_array
from mechproof.arguments.scalars import check_function, refuse, require
from mechproof.derivatives import differentiate, find_derivatives
from mechproof.tolerance.sizes import (
    Floats,
    Function,
    Size,
    check_names,
    check_sizes,
    evaluate,
    evaluate_nominal,
)


class Range(NamedTuple):
    """Lower and upper end, of the inputs' shape."""

    lower: Any
    upper: Any


@dataclass(frozen=True, eq=False)
class Contributions:
    """First-order effect of every size that has a tolerance, at every input.

    `nominal` has the inputs' shape; `sensitivities` (change of the value per change of the
    size) adds a last axis along `names`.
    """

    names: tuple[str, ...]
    sizes: tuple[Size, ...]
    nominal: Any
    sensitivities: Floats

    @property
    def effects(self) -> Floats:
        """Change of the value from the lower to the upper limit of each size."""
        tolerances = np.array([size.tolerance for size in self.sizes])
        effects: Floats = self.sensitivities * tolerances
        return effects

    @property
    def middle(self) -> Any:
        """First-order value with every size in the middle between its limits."""
        deviations = np.array([size.middle_deviation for size in self.sizes])
        return self.nominal + self.sensitivities @ deviations

    @property
    def ranking(self) -> tuple[tuple[str, float], ...]:
        """Names with their largest |effect| over the inputs, largest first, NaN before all."""
        largest = np.abs(self.effects).reshape(-1, len(self.names)).max(axis=0)
        pairs = zip(self.names, largest.tolist(), strict=True)
        return tuple(sorted(pairs, key=lambda pair: (pair[1] == pair[1], -pair[1])))


def contributions(
    function: Function,
    inputs: ArrayLike,
    sizes: Mapping[str, Size],
    *,
    sensitivities: Mapping[str, ArrayLike] | None = None,
) -> Contributions:
    """Return the first-order contribution of every toleranced size.

    Of a kernel of `mechproof.kernels` that has derivatives, the sensitivities are these at the
    nominal sizes. Of any other function, without `sensitivities`, each is the difference quotient
    between the limits of its size, the others nominal: exact for a linear function, else off by
    about T²/24 times the third derivative and, for unequal limits, by their middle deviation times
    the second. NaN in, NaN out.

    Parameters
    ----------
    function, inputs, sizes
        As in `corner_range`; sizes are passed as numbers.
    sensitivities
        Exact derivatives at the nominal sizes: name and array-like that broadcasts to the
        inputs, for every toleranced size and no other.

    Raises
    ------
    TypeError, ValueError
        Names the parameter.

    Source: the sensitivities S_i of equation (3) of Kapitonov and Yakubovsky 2022 (track_wheel).

    """
    points = check_array("inputs", inputs)
    check_function("function", function)
    varying = check_sizes(sizes)
    nominal = evaluate_nominal(function, points, sizes)
    if sensitivities is None and find_derivatives(function):
        columns = _differentiate(function, points, sizes, list(varying))
    elif sensitivities is None:
        columns = [_difference_quotient(function, points, sizes, name) for name in varying]
    else:
        columns = _check_sensitivities(sensitivities, varying, points.shape)
    table = np.stack([np.empty(points.shape), *columns], axis=-1)[..., 1:]
    return Contributions(tuple(varying), tuple(varying.values()), nominal[()], table)


def _differentiate(
    function: Function, inputs: Floats, sizes: Mapping[str, Size], names: list[str]
) -> list[Floats]:
    nominal = {name: size.nominal for name, size in sizes.items()}
    running = next(iter(inspect.signature(function).parameters))
    slopes = differentiate(function, {running: inputs, **nominal})
    assert slopes is not None
    return [np.asarray(slopes[name]) for name in names]


def _difference_quotient(
    function: Function, inputs: Floats, sizes: Mapping[str, Size], name: str
) -> Floats:
    nominal = {other: size.nominal for other, size in sizes.items()}
    low, high = sizes[name].limits
    at_low, at_high = (
        evaluate(function, inputs, nominal | {name: limit}, inputs.shape) for limit in (low, high)
    )
    # The limits as doubles, whose distance is not quite the tolerance.
    return (at_high - at_low) / (high - low)


def _check_sensitivities(
    given: Mapping[str, ArrayLike], varying: Mapping[str, Size], shape: tuple[int, ...]
) -> list[Floats]:
    check_names("sensitivities", given, varying)
    columns = []
    for name in varying:
        where = f"sensitivities[{name!r}]"
        values = check_array(where, given[name])
        try:
            columns.append(np.broadcast_to(values, shape))
        except ValueError:
            allowed = f"has shape {values.shape}; it must broadcast to the inputs' {shape}"
            refuse(where, given[name], allowed)
    return columns


def root_sum_square(contributions: Contributions) -> Range:
    """Return the middle value ± half the root of the sum of squared effects.

    To first order and for independent sizes this is the range of probability 0.9973 if every
    size is normal about the middle between its limits with six standard deviations between
    them; generally, the range of K standard deviations where each tolerance is K of its size's.

    Source: equation (5) of Kapitonov and Yakubovsky 2022 (track_wheel) with the sensitivities
    kept and all relative-scatter coefficients equal.
    """
    is_one = isinstance(contributions, Contributions)
    require(is_one, "contributions", contributions, "must be Contributions", TypeError)
    half = np.linalg.norm(contributions.effects, axis=-1) / 2
    return Range(contributions.middle - half, contributions.middle + half)
