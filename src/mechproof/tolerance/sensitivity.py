"""First-order contributions of toleranced sizes, and their root-sum-square range.

For independent sizes the root sum square is the law of propagation of uncertainty (JCGM 100,
5.1.2), with tolerances in place of standard uncertainties. Tolerances for a wanted range are
allocated by first order, then held by the certified range.
"""

from __future__ import annotations

import inspect
from collections.abc import Iterable, Mapping
from concurrent.futures import Executor
from dataclasses import dataclass
from importlib import import_module
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.array_checks import check_array
from mechproof.arguments.scalars import (
    check_function,
    check_mapping,
    check_real,
    check_text,
    refuse,
    require,
)
from mechproof.derivatives import differentiate, find_derivatives
from mechproof.measured import KERNELS
from mechproof.tolerance.certified import CertifiedRange, certified_range
from mechproof.tolerance.sizes import (
    Floats,
    Function,
    Size,
    check_names,
    check_sizes,
    evaluate,
    evaluate_nominal,
)

# How near the certified width comes to the wanted one, and how many steps are tried for that.
NEAR, STEPS = 0.01, 12


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
        """Change of the value between the lower and the upper limit of each size."""
        tolerances = np.array([size.tolerance for size in self.sizes])
        effects: Floats = self.sensitivities * tolerances
        return effects

    @property
    def middle(self) -> Any:
        """First-order value with every size midway between its limits."""
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

    For a kernel of `mechproof.kernels` with derivatives, the sensitivities are the derivatives at
    the nominal sizes. For any other function, without `sensitivities`, each is the difference
    quotient between the limits of its size, with the others nominal. It is exact for a linear
    function; otherwise it is off by about T²/24 times the third derivative and, for unequal limits,
    by their middle deviation times the second. NaN in, NaN out.

    Parameters
    ----------
    function, inputs, sizes
        As in `corner_range`; sizes are passed as numbers.
    sensitivities
        Exact derivatives at the nominal sizes: a name and an array-like that broadcasts to the
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
    # The limits are doubles, and their distance is not exactly the tolerance.
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

    To first order, for independent sizes, this is the range of probability 0.9973 if every size is
    normal about the middle of its limits, with six standard deviations between them. In general, it
    is the range of K standard deviations if each tolerance is K of its size's.

    Source: equation (5) of Kapitonov and Yakubovsky 2022 (track_wheel) with the sensitivities
    kept and all relative-scatter coefficients equal.
    """
    is_one = isinstance(contributions, Contributions)
    require(is_one, "contributions", contributions, "must be Contributions", TypeError)
    half = np.linalg.norm(contributions.effects, axis=-1) / 2
    return Range(contributions.middle - half, contributions.middle + half)


@dataclass(frozen=True, eq=False)
class Allocation:
    """Sizes with the tolerances allocated to them, and the range that is proved for these.

    `effects` are the first-order changes of the value over each tolerance, at the input where
    they are largest.
    """

    sizes: Mapping[str, Size]
    effects: Mapping[str, float]
    range: CertifiedRange

    @property
    def width(self) -> Any:
        """Return the proved width of the range at every input."""
        return self.range.upper - self.range.lower


def allocate_tolerances(
    system: str,
    quantity: str,
    inputs: ArrayLike,
    nominal: Mapping[str, float],
    width: float,
    *,
    names: Iterable[str] | None = None,
    costs: Mapping[str, float] | None = None,
    budget: int = 200,
    executor: Executor | None = None,
) -> Allocation:
    """Return the widest tolerances, in stated proportions, that keep a quantity in a width.

    Each lies symmetrically about its nominal size. To first order the worst case is the sum of
    |c_i| T_i; the certified range then holds for all sizes together, however the quantity bends:
    at every input it is no wider than `width`, and at some input at most 1 % narrower.

    Parameters
    ----------
    system, quantity
        As in `certified_range`, but of the package, and with a kernel of derivatives.
    inputs
        The first argument, an array-like: the range is kept at all of them.
    nominal
        Name and number of every other argument.
    width
        Largest allowed distance between the quantity's least and largest value; positive.
    names
        The sizes that get a tolerance (default: all on which the quantity depends).
    costs
        Name and cost a_i of these: a tolerance T costs a_i/T, and the total cost is minimised
        (Spotts 1973), so that T_i is proportional to sqrt(a_i/|c_i|). By default, all sizes
        contribute equally.
    budget, executor
        As in `certified_range`.

    Raises
    ------
    ImportError
        Without the `derive` extra.
    TypeError, ValueError
        Names the parameter; also if no tolerances, however narrow, are shown to keep the width.

    """
    check_text("quantity", quantity)
    points = np.atleast_1d(check_array("inputs", inputs))
    require(check_real("width", width) > 0, "width", width, "must be positive")
    check_mapping("nominal", nominal, "must map names to numbers")
    steepest = _find_slopes(system, quantity, points, nominal)
    acting = [n for n, c in steepest.items() if c]
    is_list = names is None or (isinstance(names, Iterable) and not isinstance(names, str))
    require(is_list, "names", names, "must be a list of names", TypeError)
    chosen = acting if names is None else list(names)
    unknown = sorted(set(map(str, chosen)) - {*acting})
    require(chosen and not unknown, "names", unknown, f"must be among {sorted(steepest)}, "
            "and the quantity must depend on them at the inputs")  # fmt: skip
    shares = _weigh(chosen, steepest, costs)
    factor = width / sum(steepest[n] * share for n, share in shares.items())
    best: Allocation | None = None
    for _ in range(STEPS):
        tolerances = {n: factor * share for n, share in shares.items()}
        sizes = {
            n: Size(x, tolerances[n] / 2, -tolerances[n] / 2) if n in tolerances else Size(x)
            for n, x in nominal.items()
        }
        found = certified_range(
            system, quantity, points, sizes, gap=width * NEAR / 4, budget=budget, executor=executor
        )
        effects = {n: steepest[n] * tolerance for n, tolerance in tolerances.items()}
        largest = float(np.max(found.upper - found.lower))
        if largest <= width:
            best = Allocation(sizes, effects, found)
            if largest >= (1 - NEAR) * width:
                break
        # The width is nearly proportional to the tolerances; without a finite width, halve them.
        factor *= (1 - NEAR / 2) * width / largest if np.isfinite(largest) else 0.5
    if best is None:
        raise ValueError(f"width = {width!r}: no tolerances are shown to keep it; raise budget")
    return best


def _find_slopes(
    system: str, quantity: str, points: Any, nominal: Mapping[str, float]
) -> dict[str, float]:
    """Return, for every size, the largest |derivative| over the inputs."""
    check_text("system", system)
    kernels = import_module(f"{KERNELS}.{system}")
    function = getattr(kernels, quantity, None)
    slopes = None
    if function is not None:
        running = next(iter(inspect.signature(function).parameters))
        slopes = differentiate(function, {running: points, **nominal})
    if slopes is None:
        raise ValueError(f"quantity = {quantity!r}: {system} has no kernel of its derivatives")
    largest = {name: float(np.max(np.abs(slopes[name]))) for name in nominal}
    bad = [name for name, slope in largest.items() if not np.isfinite(slope)]
    require(not bad, "inputs", points.tolist(), f"the derivatives by {bad} are not finite there")
    return largest


def _weigh(
    names: list[str], slopes: Mapping[str, float], costs: Mapping[str, float] | None
) -> dict[str, float]:
    """Return the proportions of the tolerances."""
    if costs is None:
        return {name: 1 / slopes[name] for name in names}
    allowed = f"must be given for {sorted(names)} and be positive"
    check_mapping("costs", costs, allowed)
    require(set(costs) == set(names), "costs", dict(costs), allowed)
    for name in names:
        where = f"costs[{name!r}]"
        require(check_real(where, costs[name]) > 0, where, costs[name], "must be positive")
    return {name: float(np.sqrt(costs[name] / slopes[name])) for name in names}
