"""Runs of whole kernels: arguments by name, and stages chosen point by point, in any arithmetic."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from mechproof.programs.operations import Arithmetic
from mechproof.programs.program import KernelCode, Program, Stage
from mechproof.roundoff.running import Values, run
from mechproof.roundoff.steps import flatten_stage


def name_values(code: KernelCode, arguments: Iterable[Any]) -> Values:
    """Return the arguments by their names in the code, vectors by those of their components."""
    parts = dict(code.vectors)
    named: Values = {}
    for name, value in zip(code.arguments, arguments, strict=True):
        named |= dict(zip(parts[name], value, strict=True)) if name in parts else {name: value}
    return named


def put_points_last(arguments: Iterable[Any], kind: type[Any]) -> list[Any]:
    """Return arrays as arrays of numbers of a type, with the axis of points last, not first."""
    return [np.moveaxis(np.asarray(array, kind), 0, -1) for array in arguments]


def run_stage(stage: Stage, given: Mapping[str, Any], arithmetic: Arithmetic) -> tuple[Any, ...]:
    """Return the outputs of a stage."""
    return run(flatten_stage(stage.spell_out(), {}), given, arithmetic)


def run_test(test: Program | None, given: Mapping[str, Any], arithmetic: Arithmetic) -> Any:
    """Return whether a condition is true; a missing one always is."""
    return True if test is None else run(test, given, arithmetic)[0]


def blend(
    stages: Sequence[Stage],
    compute: Callable[[Stage], Sequence[Any]],
    is_met: Callable[[Program | None], Any],
) -> Sequence[Any]:
    """Return the outputs at all points, each by the first stage whose condition it meets."""
    values = compute(stages[-1])
    for stage in stages[-2::-1]:
        here, pairs = is_met(stage.when), zip(compute(stage), values, strict=True)
        values = [np.where(here, other, value) for other, value in pairs]
    return values
