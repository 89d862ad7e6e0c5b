"""Tolerances from a wanted range: allocated by first order, then held by the certified range."""

from __future__ import annotations

import inspect
from collections.abc import Iterable, Mapping
from concurrent.futures import Executor
from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.array_checks import check_array
from mechproof.arguments.scalars import check_mapping, check_real, check_text, require
from mechproof.derivatives import differentiate
from mechproof.measured import KERNELS
from mechproof.tolerance.certified import CertifiedRange, certified_range
from mechproof.tolerance.sizes import Size

# The certified width comes this near to the wanted one, and steps that are tried for it.
NEAR, STEPS = 0.01, 12


@dataclass(frozen=True, eq=False)
class Allocation:
    """Sizes with the tolerances allocated to them, and the range that is proved of these.

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
    |c_i| T_i; the certified range then holds for all sizes together, however the quantity bends,
    and at every input it is no wider than `width`, and at one at most 1 % narrower.

    Parameters
    ----------
    system, quantity
        As in `certified_range`, of the package; the quantity has a kernel of derivatives.
    inputs
        The first argument, an array-like: the range is kept at all of them.
    nominal
        Name and number of every other argument.
    width
        Wanted, at most, of the quantity from its least to its largest value; positive.
    names
        The sizes that get a tolerance (left out: all on which the quantity depends).
    costs
        Name and cost a_i of these: that of a tolerance T counts as a_i/T, and the sum of all is
        made least (Spotts 1973), T_i going with sqrt(a_i/|c_i|). Left out, all contribute equally.
    budget, executor
        As in `certified_range`.

    Raises
    ------
    ImportError
        Without the `derive` extra.
    TypeError, ValueError
        Names the parameter; also where no tolerances, however narrow, are shown to keep the width.

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
    require(chosen and not unknown, "names", unknown, f"must be some of {sorted(steepest)}, "
            "and the quantity depend on them at the inputs")  # fmt: skip
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
        # The width goes nearly with the tolerances; a budget that does not reach asks for half.
        factor *= (1 - NEAR / 2) * width / largest if np.isfinite(largest) else 0.5
    if best is None:
        raise ValueError(f"width = {width!r}: not shown to be kept by any tolerances; raise budget")
    return best


def _find_slopes(
    system: str, quantity: str, points: Any, nominal: Mapping[str, float]
) -> dict[str, float]:
    """Return the largest |derivative| over the inputs by every size."""
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
