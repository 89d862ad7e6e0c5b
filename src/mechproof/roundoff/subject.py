"""Subjects: in, a stage of a kernel; out, what bounds its error over a box of a region."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from mechproof.codegen.kernel import Kernel, input_names
from mechproof.record import Form
from mechproof.roundoff.bound import Evaluation
from mechproof.roundoff.expansions import WAYS
from mechproof.roundoff.regions import Box, Region
from mechproof.roundoff.steps import Straight, flatten_stage


@dataclass(frozen=True)
class Subject:
    """A stage of a kernel in one of the ways in which it is computed."""

    kernel: Kernel
    form: Form
    way: str
    straight: Straight

    def bound(self, region: Region, box: Box) -> float:
        """Bound the error in eps of the scale over a box; infinite where it cannot be bounded."""
        try:
            evaluation = self.evaluate(region, box)
        except (ZeroDivisionError, IndexError):
            return math.inf
        (output,) = self.straight.outputs
        return evaluation.sum_errors(output, evaluation.value(output))

    def evaluate(self, region: Region, box: Box) -> Evaluation:
        """Return all values over a box."""
        poles = sum(step.kind == "tan" for step in self.straight.steps)
        frame, arguments, turn = region.enter(box, poles)
        names = input_names(self.kernel.quantity)
        given = {names[symbol]: germ for symbol, germ in arguments.items()}
        return Evaluation(self.straight, frame, given, turn)


def list_subjects(kernel: Kernel) -> Iterator[Subject]:
    """List the stages of a kernel that have charts, in every way of computing them."""
    for form, stage in zip(kernel.forms, kernel.code.stages, strict=True):
        if not form.charts:
            continue
        known: list[Straight] = []
        for way, expansions in WAYS.items():
            straight = flatten_stage(stage, expansions)
            if straight not in known:
                known.append(straight)
                yield Subject(kernel, form, way, straight)
