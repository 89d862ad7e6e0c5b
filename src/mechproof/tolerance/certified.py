"""The range of a derived quantity over the whole box of its sizes, certified by ball arithmetic.

A corner range is not a bound if the dependence on a size turns between its limits. Here, the
derivation of a quantity gives its derivatives, and balls give their signs over the box. A size in
which the quantity is monotonic goes to a limit; the others are bisected until the bound meets an
attained value or a budget is spent. What then remains open is the gap. This is interval branch and
bound (Moore 1966, Hansen and Walster 2004; `subdivision`), whereas the GUM stops at first order and
JCGM 101 samples.

Needs the `derive` extra (sympy, python-flint).

>>> from mechproof import WedgeLinkage
>>> from mechproof.tolerance import certified_range
>>> sizes = WedgeLinkage.published_sizes(1)
>>> bool(certified_range("wedge_linkage", "position", -30.0, sizes).upper_gap < 1e-9)
True
"""

from __future__ import annotations

import pickle
from collections.abc import Mapping
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import cached_property, lru_cache, partial
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from mechproof.arguments.array_checks import check_array
from mechproof.arguments.scalars import check_count, check_number, check_text, require
from mechproof.executors import BALLS, check_executor, run_in_order
from mechproof.tolerance.problem import Bounds, Problem
from mechproof.tolerance.sizes import Floats, Progress, Report, Size, check_sizes
from mechproof.tools.extras import describe_missing

if TYPE_CHECKING:
    from mechproof.record import Paper

# Inputs per task of a worker.
INPUTS = 4


@dataclass(frozen=True, eq=False)
class CertifiedRange:
    """Bounds of a quantity over the whole box of sizes, at every input.

    `lower` and `upper` are bounds: no sizes within their limits give a value beyond them. The true
    extremes lie between the bounds and `lower_attained`, `upper_attained`, which are values of the
    quantity at sizes in the box, NaN if none was found. Infinite bounds mean that the quantity may
    be undefined there, or was not shown to be defined within the budget.

    `turning` adds a last axis along `names`, the toleranced sizes: True if the quantity was not
    shown to be monotonic in the size over the whole box. `without_influence` names the sizes whose
    derivative is proved to be identically zero. `boxes` counts the boxes examined.
    """

    names: tuple[str, ...]
    without_influence: tuple[str, ...]
    lower: Floats
    upper: Floats
    lower_attained: Floats
    upper_attained: Floats
    turning: NDArray[np.bool_]
    boxes: NDArray[np.int64]

    @property
    def lower_gap(self) -> Floats:
        """What remains open at the lower end, in the unit of the quantity."""
        return self.lower_attained - self.lower

    @property
    def upper_gap(self) -> Floats:
        """What remains open at the upper end, in the unit of the quantity."""
        return self.upper - self.upper_attained


def certified_range(
    system: str | Paper,
    quantity: str,
    inputs: ArrayLike,
    sizes: Mapping[str, Size],
    *,
    gap: float = 1e-9,
    budget: int = 200,
    progress: Progress | None = None,
    executor: Executor | None = None,
) -> CertifiedRange:
    """Bound a derived quantity over the box of its sizes.

    Parameters
    ----------
    system
        Name of a system of the package, or a `Paper` of your own.
    quantity
        Name of one of its scalar quantities; its first argument takes the inputs.
    inputs
        Array-like of any shape.
    sizes
        Name and `Size` of every other argument, and of any other variable of the paper. All their
        limits must satisfy the sets and relations stated by the paper and the quantity.
    gap
        Bisection continues while bound and attained value are further apart than this.
    budget
        Largest number of boxes to examine for each end at each input.
    progress
        Called as progress(done, total) after every input.
    executor
        Any executor of `concurrent.futures`; the result is the same to the last bit. Processes are
        sent the quantity, not the paper. Threads gain nothing: they take turns at ball arithmetic.

    Returns
    -------
    CertifiedRange
        Arrays of the inputs' shape. NaN in, NaN out; infinite bounds if the input and the sizes are
        not shown to lie in the domain together.

    Raises
    ------
    ImportError
        If the `derive` extra is not installed.
    TypeError, ValueError
        Names the parameter, which may be a size partly outside the domain.
    mechproof.tools.processes.WorkerError
        If the executor loses a worker and does not recover.

    """
    check_count("budget", budget)
    require(check_number("gap", gap) >= 0, "gap", gap, "must not be negative")
    points = check_array("inputs", inputs)
    check_executor(executor)
    report = Report(points.size, progress)
    check_text("quantity", quantity)
    check_sizes(sizes)
    with BALLS:
        problem = Problem(_load(system), quantity, sizes)
    bound = partial(_bound, _Sent(problem), gap, budget)
    results = []
    for bounds in run_in_order(bound, points.ravel().tolist(), executor, batch=INPUTS):
        results.append(bounds)
        report.add(1)
    ends = np.array([r[:4] for r in results], np.float64).reshape(-1, 4)
    lower, lower_attained, upper, upper_attained = ends.T.reshape(4, *points.shape)
    names = (*problem.names, *problem.idle)
    turning = np.array([[n in r.turning for n in names] for r in results], bool)
    return CertifiedRange(
        names=names,
        without_influence=tuple(problem.idle),
        lower=lower,
        upper=upper,
        lower_attained=lower_attained,
        upper_attained=upper_attained,
        turning=turning.reshape(*points.shape, len(names)),
        boxes=np.array([r.boxes for r in results], np.int64).reshape(points.shape),
    )


@dataclass(frozen=True)
class _Sent:
    """A problem in transfer: pickled once, unpickled once by every process."""

    problem: Problem

    def __reduce__(self) -> tuple[Any, ...]:
        return _receive, (self._written,)

    @cached_property
    def _written(self) -> bytes:
        return pickle.dumps(self.problem)


@lru_cache(maxsize=2)
def _receive(written: bytes) -> _Sent:
    return _Sent(pickle.loads(written))


def _bound(sent: _Sent, gap: float, budget: int, x: float) -> Bounds:
    with BALLS:
        return sent.problem.bound(x, gap, budget)


def _load(system: str | Paper) -> Paper:
    try:
        import flint  # noqa: F401

        from mechproof.derivation import find_systems, load_packaged, packaged_directory
        from mechproof.record import Paper
    except ImportError as error:
        raise ImportError(describe_missing("certified_range", "derive", error.name)) from error
    if not isinstance(system, str):
        require(isinstance(system, Paper), "system", system, "must be a name or a Paper", TypeError)
        return system
    systems = find_systems(packaged_directory())
    require(system in systems, "system", system, f"must be one of {sorted(systems)}")
    return load_packaged(system)
