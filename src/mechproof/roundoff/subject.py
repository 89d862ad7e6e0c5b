"""Subjects: in, a stage of a kernel; out, what bounds its error over a box of a region."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import sympy as sp
from flint import arb
from numpy.typing import NDArray

from mechproof.codegen.code import Stage
from mechproof.codegen.kernel import Kernel, input_names
from mechproof.codegen.program import MEANINGS
from mechproof.proof.balls import working_precision
from mechproof.record import Chart, Form
from mechproof.roundoff.assumptions import FUNCTIONS, NORMAL
from mechproof.roundoff.bound import EPS, Evaluation
from mechproof.roundoff.compensation import hold_compensated
from mechproof.roundoff.expansions import WAYS
from mechproof.roundoff.regions import Box, Region, express
from mechproof.roundoff.running import IN_DOUBLES, run
from mechproof.roundoff.steps import Straight, flatten_stage
from mechproof.roundoff.symmetry import check_symmetry

BITS = 64


@dataclass(frozen=True)
class Subject:
    """A stage of a kernel in one of the ways in which it is computed.

    `exact` are the steps whose values without rounding are the truth.
    """

    kernel: Kernel
    form: Form
    stage: Stage
    way: str
    straight: Straight
    exact: Straight

    @property
    def digest(self) -> str:
        """Return the SHA-256 of the steps and of the coordinates."""
        text = f"{self.straight}\n{self.form.charts}"
        return hashlib.sha256(text.encode()).hexdigest()

    @property
    def assumptions(self) -> tuple[str, ...]:
        """List what the bound rests on."""
        kinds = {step.kind for step in self.straight.steps}
        return (*(FUNCTIONS[k].text for k in sorted(kinds & FUNCTIONS.keys())), NORMAL)

    def bound(self, region: Region, box: Box) -> float:
        """Bound the error in eps of the scale over a box; infinite where it cannot be bounded."""
        with working_precision(BITS):
            try:
                evaluation = self.evaluate(region, box)
            except (ZeroDivisionError, IndexError):
                return math.inf
            (output,) = self.straight.outputs
            return evaluation.sum_errors(output, evaluation.value(output))

    def evaluate(self, region: Region, box: Box) -> Evaluation:
        """Return all values over a box."""
        poles = sum(step.kind == "tan" for step in self.straight.steps)
        frame, germs, turn = region.enter(box, poles)
        names = input_names(self.kernel.quantity)
        arguments = region.chart.arguments.items()
        given = {names[symbol]: express(value, frame, germs) for symbol, value in arguments}
        plain = next(plain for chart, plain in self.plain if chart is region.chart)
        stated = {result: express(value, frame, germs) for result, value in plain.items()}
        return Evaluation(self.straight, frame, given, stated, turn)

    @cached_property
    def plain(self) -> tuple[tuple[Chart, Mapping[str, sp.Expr]], ...]:
        """List by charts the sums of arguments and numbers, written in coordinates.

        What cancels there, 1 - e for e = 1 - d, does so before balls are put in.
        """
        names = input_names(self.kernel.quantity)
        return tuple((chart, _add_up(self.straight, chart, names)) for chart in self.form.charts)

    def weigh(self, found: NDArray[np.float64], exact: Sequence[Any], given: Any) -> float:
        """Return the error of outputs in eps of the scale."""
        ((value, true),) = zip(found.tolist(), exact, strict=True)
        return float(abs(arb(value) - true) / abs(true) / EPS) if true != 0 else 0.0

    def holds(self, points: Mapping[str, Any]) -> Any:
        """Say where the stage is taken."""
        programs = [p for p in (self.kernel.code.inside, self.stage.when) if p]
        inside = [run(p, points, IN_DOUBLES)[0] for p in programs]
        return np.logical_and.reduce(inside) if inside else True


def _add_up(
    straight: Straight, chart: Chart, names: Mapping[sp.Basic, str]
) -> Mapping[str, sp.Expr]:
    values = {names[symbol]: value for symbol, value in chart.arguments.items()}
    sums: dict[str, sp.Expr] = {}
    for step in straight.steps:
        given = [values.get(o) if isinstance(o, str) else sp.Rational(o) for o in step.operands]
        if step.kind in ("add", "subtract") and all(value is not None for value in given):
            sums[step.result] = sp.expand(MEANINGS[step.kind](*given))
    return sums


def list_subjects(kernel: Kernel) -> Iterator[Subject]:
    """List the stages of a kernel that have charts, in every way of computing them."""
    for form, stage in zip(kernel.forms, kernel.code.stages, strict=True):
        if not form.charts:
            continue
        known: list[Straight] = []
        for way, expansions in WAYS.items():
            straight = hold_compensated(flatten_stage(stage, expansions))
            if straight not in known:
                known.append(straight)
                for chart in form.charts:
                    if chart.angle is not None:
                        check_symmetry(straight, chart, input_names(kernel.quantity))
                yield Subject(kernel, form, stage, way, straight, known[0])
