"""The range of a function over all combinations of limits of its sizes.

This is the worst-case analysis of dimensional chains, exact if the function is monotonic in every
size. If it turns between limits, the corner range is too narrow, unlike `certified_range`.
"""

from __future__ import annotations

from collections.abc import Mapping
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from mechproof.arguments.array_checks import check_array
from mechproof.arguments.scalars import check_count, check_function, refuse, require
from mechproof.executors import check_executor, run_in_order, slices
from mechproof.tolerance.sizes import (
    Floats,
    Function,
    Progress,
    Report,
    Size,
    check_sizes,
    evaluate,
    evaluate_nominal,
)

# 2**24 combinations take seconds for each input, and each further size doubles that.
MOST_SIZES = 24

# Values per call: few, so that a kernel keeps results that depend on few sizes that short.
CHUNK = 2**14
# Loops along the last axis should be at least this long.
LONG_LOOP = 64

Index = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class CornerRange:
    """Smallest and largest value over all combinations of limits, at every input.

    `nominal`, `lower`, `upper` and `undefined` have the inputs' shape; `lower_signs` and
    `upper_signs` add a last axis along `names`, the toleranced sizes in their given order.
    A sign tells which limit of the size gives the value: +1 upper, -1 lower, 0 either (with every
    other size as its own sign says, and sizes of sign 0 at their lower limits).

    `undefined` counts the combinations at which the function is NaN. If there are any, no range is
    claimed: `lower` and `upper` are NaN, and both rows of signs show the first such combination.
    """

    names: tuple[str, ...]
    nominal: Any
    lower: Any
    upper: Any
    lower_signs: NDArray[np.int8]
    upper_signs: NDArray[np.int8]
    undefined: Any

    @property
    def spread(self) -> Any:
        """Upper minus lower."""
        return self.upper - self.lower

    @property
    def combinations(self) -> int:
        """Number of combinations of limits, all of which were computed."""
        return int(2 ** len(self.names))

    @property
    def influential(self) -> tuple[str, ...]:
        """The sizes that matter: the range stays the same with all others at their lower limits."""
        matters = np.count_nonzero(self._all_signs(), axis=0)
        return tuple(name for name, count in zip(self.names, matters, strict=True) if count)

    @property
    def influential_combinations(self) -> int:
        """Number of combinations of limits of the sizes that matter."""
        return int(2 ** len(self.influential))

    @property
    def extreme_combinations(self) -> NDArray[np.int8]:
        """The distinct rows of signs that give the smallest or largest value at some input."""
        return np.unique(self._all_signs(), axis=0)

    def describe(self, signs: ArrayLike) -> str:
        """Return a row of signs as text, such as "+l_BC -l_CD"; sizes of sign 0 are left out."""
        row = check_array("signs", signs)
        require(row.shape == (len(self.names),), "signs", signs, f"must be {len(self.names)} signs")
        pairs = zip(self.names, row, strict=True)
        return " ".join(f"{'+' if sign > 0 else '-'}{name}" for name, sign in pairs if sign)

    def _all_signs(self) -> NDArray[np.int8]:
        width = len(self.names)
        both = (self.lower_signs.reshape(-1, width), self.upper_signs.reshape(-1, width))
        return np.concatenate(both)


def corner_range(
    function: Function,
    inputs: ArrayLike,
    sizes: Mapping[str, Size],
    *,
    chunk: int = CHUNK,
    progress: Progress | None = None,
    executor: Executor | None = None,
) -> CornerRange:
    """Evaluate `function(inputs, **sizes)` at all 2^m combinations of limits of m sizes.

    This is not a bound over the box of sizes: if the dependence on a size turns between its limits,
    values inside lie beyond those at the corners. It is a bound if the function is monotonic in
    every size.

    Parameters
    ----------
    function
        Called with inputs on the last axis and sizes on separate axes before it, some of them
        together on one axis, or of the inputs' shape. It returns real numbers that broadcast to the
        common shape, so results that depend on few sizes stay small. Fixed sizes are passed as
        their nominal number.
    inputs
        Array-like of any shape; NaN in, NaN out.
    sizes
        Name and `Size`; at most 24 of them with a tolerance.
    chunk
        Values per call. Memory use is a few times this, plus a few numbers per input and size,
        whatever the number of combinations.
    progress
        Called as progress(done, total) after every call, in function values.
    executor
        Any executor of `concurrent.futures`, such as a process pool or dask's
        `Client.get_executor()`; the result is the same to the last bit. Processes need a function
        that can be pickled.

    Returns
    -------
    CornerRange
        The values themselves are those of `function`, unchanged. Of equal values, the first
        combination counts, with the lower limit before the upper.

    Raises
    ------
    TypeError, ValueError
        Names the parameter; also if the function returns complex numbers or another shape, or
        cannot be sent to the processes of an executor.
    mechproof.tools.processes.WorkerError
        If the executor loses a worker and does not recover.

    Source: Bazuev et al. 2021 (wedge_linkage), boundaries II to IV of the transfer function.

    """
    check_function("function", function)
    check_count("chunk", chunk)
    check_executor(executor)
    points = check_array("inputs", inputs)
    box = _Box(function, sizes)
    report = Report(points.size * box.combinations, progress)
    lowest, highest, undefined = _search(box, points.ravel(), chunk, report, executor)
    shape = points.shape
    return CornerRange(
        names=tuple(box.varying),
        nominal=evaluate_nominal(function, points, sizes)[()],
        lower=lowest.value.reshape(shape)[()],
        upper=highest.value.reshape(shape)[()],
        lower_signs=_find_signs(box, points, lowest.index, chunk, executor),
        upper_signs=_find_signs(box, points, highest.index, chunk, executor),
        undefined=undefined.reshape(shape)[()],
    )


def _block_shape(points: int, sizes: int, chunk: int) -> tuple[int, int]:
    """Return the number of inputs in a block, and how many of the first sizes vary in it."""
    rows = max(1, min(points, chunk, max(LONG_LOOP, chunk >> sizes)))
    return rows, min(sizes, (chunk // rows).bit_length() - 1)


def _search(
    box: _Box, points: Floats, chunk: int, report: Report, executor: Executor | None
) -> tuple[_Extreme, _Extreme, Index]:
    """Find the extremes of every input, block by block of combinations."""
    rows, width = _block_shape(points.size, len(box.varying), chunk)
    starts = range(0, box.combinations, 2**width)
    parts = ((part, first) for part in slices(points.size, rows) for first in starts)
    tasks = ((points[part], first) for part, first in parts)
    blocks = run_in_order(partial(_search_block, box, width), tasks, executor)
    lowest = _Extreme(points.size, np.less_equal, np.inf)
    highest = _Extreme(points.size, np.greater_equal, -np.inf)
    undefined = np.zeros(points.size, np.int64)
    for part in slices(points.size, rows):
        # In this order, since the first of equal values counts.
        for _ in starts:
            block = next(blocks)
            lowest.update(part, *block.lowest)
            highest.update(part, *block.highest)
            undefined[part] += block.undefined
            report.add(block.values)
    return lowest, highest, undefined


class _Block(NamedTuple):
    """The extremes of some inputs over some combinations: values and numbers of combinations."""

    lowest: tuple[Floats, Index]
    highest: tuple[Floats, Index]
    undefined: Any
    values: int


def _search_block(box: _Box, width: int, task: tuple[Floats, int]) -> _Block:
    inputs, first = task
    values = box.evaluate_block(inputs, first, width)
    columns = np.arange(inputs.size)
    # The first NaN counts as both extremes.
    low, high = values.argmin(axis=0), values.argmax(axis=0)
    lowest, highest = values[low, columns], values[high, columns]
    undefined = np.count_nonzero(np.isnan(values), axis=0) if np.isnan(lowest).any() else 0
    return _Block((lowest, first + low), (highest, first + high), undefined, values.size)


def _find_signs(
    box: _Box, points: Floats, index: Index, chunk: int, executor: Executor | None
) -> NDArray[np.int8]:
    signs = np.empty((points.size, len(box.varying)), np.int8)
    parts = [*slices(points.size, max(1, chunk // (1 + len(box.varying))))]
    tasks = ((points.ravel()[part], index[part]) for part in parts)
    for part, found in zip(parts, run_in_order(box.find_signs, tasks, executor), strict=True):
        signs[part] = found
    return signs.reshape(*points.shape, len(box.varying))


class _Box:
    """The function at numbered combinations; bit j is set where size j is at its upper limit."""

    def __init__(self, function: Function, sizes: Mapping[str, Size]) -> None:
        self.function = function
        self.varying = check_sizes(sizes)
        if len(self.varying) > MOST_SIZES:
            combinations = f"{2 ** len(self.varying):,} combinations"
            allowed = (
                f"must be at most {MOST_SIZES} with a tolerance, not {combinations}; fix sizes "
                "of small `contributions`, or use `monte_carlo_range` or `certified_range`"
            )
            refuse("sizes", [*self.varying], allowed)
        self.nominal: dict[str, float | Floats] = {
            name: size.nominal for name, size in sizes.items()
        }
        self.bits = np.arange(len(self.varying))
        self.combinations = 2 ** len(self.varying)

    def evaluate_block(self, inputs: Floats, first: int, width: int) -> Floats:
        """Return the values of 2**width combinations from `first` on, shape (2**width, inputs).

        The first sizes share an axis until its loops are long; every other size has its own.
        """
        together = min(width, (LONG_LOOP // max(inputs.size, 1)).bit_length())
        axes = (2,) * (width - together) + (2**together,)
        at_limits: dict[str, float | Floats] = {}
        for bit, (name, size) in enumerate(self.varying.items()):
            limits = np.array(size.limits)
            if bit < together:
                at_limits[name] = limits[np.arange(2**together) >> bit & 1, np.newaxis]
            elif bit < width:
                at_limits[name] = limits.reshape(2, *[1] * (bit - together + 2))
            else:
                at_limits[name] = size.limits[first >> bit & 1]
        shape = (*axes, inputs.size)
        values = evaluate(self.function, inputs, self.nominal | at_limits, shape)
        return values.reshape(2**width, inputs.size)

    def evaluate(self, inputs: Floats, index: Index) -> Floats:
        """Return the values at combinations chosen for every input, shape of `index`."""
        at_limits: dict[str, Floats] = {
            name: np.where(index >> bit & 1, *reversed(size.limits))
            for bit, (name, size) in enumerate(self.varying.items())
        }
        return evaluate(self.function, inputs, self.nominal | at_limits, index.shape)

    def find_signs(self, task: tuple[Floats, Index]) -> NDArray[np.int8]:
        """Return the limit at which each size gives the value of its combination; 0 for either."""
        inputs, index = task
        # Both sides of a comparison come from one call: with another memory layout, NumPy may take
        # another code path and differ in the last bit.
        bits = self.bits[:, np.newaxis]
        values = self.evaluate(inputs, np.vstack([index, index ^ 1 << bits]))
        here, flipped = values[:1], values[1:]
        same = (here == flipped) | (np.isnan(here) & np.isnan(flipped))
        return np.where(same, 0, 2 * (index >> bits & 1) - 1).astype(np.int8).T


class _Extreme:
    """The smallest or largest value of every input so far; the first NaN wins and stays."""

    def __init__(self, count: int, keeps: Any, start: float) -> None:
        self.keeps = keeps
        self.value = np.full(count, start)
        self.index = np.zeros(count, np.int64)

    def update(self, part: slice, value: Floats, index: Index) -> None:
        """Include the values of a part that go beyond those so far."""
        best, at = self.value[part], self.index[part]
        better = ~(self.keeps(best, value) | np.isnan(best))
        best[better] = value[better]
        at[better] = index[better]
