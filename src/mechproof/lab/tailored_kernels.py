"""Kernels tailored to the sizes of a timed call: what an error asked for costs."""

from __future__ import annotations

from collections.abc import Iterator
from importlib.util import find_spec
from typing import Any

import numpy as np
import sympy as sp

from mechproof.lab.sampling.point_sets import list_workloads
from mechproof.lab.subject import Subject
from mechproof.lab.ways import COMPILED, Arguments, Array, Way
from mechproof.measured import MeasuredTailoring
from mechproof.tailoring import tailor
from mechproof.tailoring.tailored import Tailored

# Errors asked for, in the unit of the quantity.
ASKED = (1e-3, 1e-6, 1e-9, 1e-12)

Tailoring = tuple[MeasuredTailoring, Way]


def list_tailored(subject: Subject, count: int) -> list[Tailoring]:
    """Tailor a quantity of the package to its timed calls with so many points.

    Where numba is missing there is nothing to gain, and so it is where no function is computed.
    """
    is_packaged = subject.origin is not None and subject.origin[1] is None
    if not (is_packaged and find_spec("numba") and subject.exact.has(sp.Function)):
        return []
    calls = ((name, workload(count)) for name, workload in list_workloads(subject))
    return [found for name, call in calls for found in _tailor(subject, name, call)]


def _tailor(subject: Subject, workload: str, call: Arguments) -> Iterator[Tailoring]:
    """Tailor to numbers where only the first argument varies, and only to what can be reached."""
    first, *others = subject.quantity.arguments
    running, *numbers = (np.asarray(a, float) for a in call)
    if running.ndim != 1 or any(a.ndim for a in numbers):
        return
    ends = float(running.min()), float(running.max())
    sizes = {a.name: float(number) for a, number in zip(others, numbers, strict=True)}
    arguments: dict[str, Any] = {first.name: ends, **sizes}
    for asked in ASKED:
        try:
            kernel = tailor(subject.name, error=asked, derivations=subject.folder, **arguments)
        except (TypeError, ValueError):
            return
        yield _describe(kernel, workload, ends, sizes), _as_way(kernel)


def _describe(
    kernel: Tailored, workload: str, ends: tuple[float, float], sizes: dict[str, float]
) -> MeasuredTailoring:
    return MeasuredTailoring(
        _name(kernel), workload, kernel.asked, kernel.bound, sizes, ends, kernel.degrees
    )


def _as_way(kernel: Tailored) -> Way:
    def compute(running: Array, *sizes: Array) -> Array:
        del sizes
        found: Array = kernel(running)
        return found

    return Way(_name(kernel), compute, "form", needs=COMPILED)


def _name(kernel: Tailored) -> str:
    return f"tailored to {kernel.asked:g}"
