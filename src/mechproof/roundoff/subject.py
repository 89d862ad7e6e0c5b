"""Subjects: in, a stage of a kernel; out, what bounds its error over a box of a region."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
import sympy as sp
from flint import arb
from numpy.typing import NDArray

from mechproof.codegen.backends.scalar import put_off_stage
from mechproof.codegen.code import Stage
from mechproof.codegen.elementary.formats import DOUBLE
from mechproof.codegen.elementary.functions import BODIES, build
from mechproof.codegen.kernel import Kernel, build_kernel, input_names
from mechproof.codegen.program import MEANINGS, Operand
from mechproof.record import Chart, Form, Paper, Quantity
from mechproof.roundoff.apart import Rows, bound_apart
from mechproof.roundoff.assumptions import FUNCTIONS, NORMAL
from mechproof.roundoff.bound import EPS, Bar, Evaluation
from mechproof.roundoff.compensation import hold_compensated
from mechproof.roundoff.compiled import COMPILED, WAY, list_expansions
from mechproof.roundoff.elementary import prove
from mechproof.roundoff.expansions import WAYS
from mechproof.roundoff.intervals import careful
from mechproof.roundoff.regions import Boxes, Region, express
from mechproof.roundoff.running import IN_BALLS, IN_DOUBLES, Values, run
from mechproof.roundoff.scales import find_scaled
from mechproof.roundoff.steps import EXACT, Step, Straight, flatten_stage, keep_needed
from mechproof.roundoff.symmetry import check_symmetry

# Boxes that are bounded together.
TOGETHER = 1024
POLYNOMIAL = ("add", "subtract", "multiply", "square", "negate")
PLAIN_REWRITES = ("half_angle_tangent",)


@dataclass(frozen=True)
class Subject:
    """A stage of a kernel in one of the ways in which it is computed.

    `exact` are the steps whose values without rounding are the truth, `scale` those of what an
    error is relative to, if it is not the value; `computed` are those of a compiled kernel, with
    calls of elementary functions. `sums` are kept for each chart.
    """

    kernel: Kernel
    form: Form
    stage: Stage
    way: str
    straight: Straight
    exact: Straight
    scale: Straight | None
    computed: Straight | None = None
    sums: dict[tuple[int, int], Mapping[str, sp.Expr]] = field(default_factory=dict, compare=False)

    @property
    def digest(self) -> str:
        """Return the SHA-256 of the steps and of the coordinates."""
        text = f"{self.straight}\n{self.form.charts}"
        if self.computed:
            kinds = sorted({step.kind for step in self.computed.steps} & BODIES.keys())
            text += f"\n{self.computed}\n{[build(kind, DOUBLE).program for kind in kinds]}"
        return hashlib.sha256(text.encode()).hexdigest()

    @property
    def where(self) -> tuple[str, ...]:
        """Say for which arguments the bound is."""
        return tuple(dict.fromkeys(chart.text for chart in self.form.charts))

    @property
    def assumptions(self) -> tuple[str, ...]:
        """List what the bound rests on."""
        kinds = {step.kind for step in self.straight.steps if not step.proved}
        return (*(FUNCTIONS[k].text for k in sorted(kinds & FUNCTIONS.keys())), NORMAL)

    def bound(self, region: Region, boxes: Boxes) -> NDArray[np.float64]:
        """Bound the error in eps of the scale over boxes; infinite where it cannot be bounded."""
        bounds = np.full(len(boxes), np.inf)
        if not len(boxes):
            return bounds
        # What is never negative is the same in all boxes that are bounded together.
        _, groups = np.unique(boxes[:, :, 0] >= 0, axis=0, return_inverse=True)
        for group in range(groups.max() + 1):
            rows = np.flatnonzero(groups == group)
            for start in range(0, len(rows), TOGETHER):
                part = rows[start : start + TOGETHER]
                bounds[part] = self._bound_alike(region, boxes[part], moves=False)
        return bounds

    def _bound_alike(self, region: Region, boxes: Boxes, *, moves: bool) -> NDArray[np.float64]:
        def compute(rows: Rows, forced: tuple[int, ...]) -> NDArray[np.float64]:
            evaluation, bar = self.evaluate(region, boxes[rows], forced)
            highest = np.zeros(len(rows))
            for output in self.straight.outputs:
                highest = np.maximum(highest, evaluation.sum_errors(output, bar))
            return highest

        def try_rows(rows: Rows, forced: tuple[int, ...]) -> NDArray[np.float64]:
            try:
                with careful(moves=moves):
                    return compute(rows, forced)
            except IndexError:
                return np.full(len(rows), np.inf)
            except FloatingPointError:
                if moves:
                    return np.full(len(rows), np.inf)
                return self._bound_alike(region, boxes[rows], moves=True)

        return bound_apart(try_rows, len(boxes))

    def evaluate(
        self, region: Region, boxes: Boxes, forced: tuple[int, ...] = ()
    ) -> tuple[Evaluation, Bar]:
        """Return all values over boxes, and what errors are relative to."""
        both = (self.straight, *([self.scale] if self.scale else []))
        poles = sum(step.kind == "tan" for straight in both for step in straight.steps)
        frame, germs, turn = region.enter(boxes, poles, forced)
        names = input_names(self.kernel.quantity)
        arguments = region.chart.arguments.items()
        given = {names[symbol]: express(value, frame, germs) for symbol, value in arguments}
        found = []
        for straight in both:
            plain = self._add_up(straight, region.chart)
            stated = {result: express(value, frame, germs) for result, value in plain.items()}
            found.append(Evaluation(straight, frame, given, stated, turn, prove))
        if self.scale is None:
            return found[0], Bar(None, True)
        whole, *rest = (found[1].value(output) for output in self.scale.outputs)
        return found[0], Bar(whole, bool(rest) and rest[0].decide_sign() > 0)

    def _add_up(self, straight: Straight, chart: Chart) -> Mapping[str, sp.Expr]:
        key = (id(straight), id(chart))
        if key not in self.sums:
            self.sums[key] = add_up(straight, chart, input_names(self.kernel.quantity))
        return self.sums[key]

    def compute(self, points: Mapping[str, Any]) -> NDArray[np.float64]:
        """Return the outputs in doubles, as they are computed."""
        if self.computed:
            return np.array(run(self.computed, points, COMPILED))
        return np.array(run(self.straight, points, IN_DOUBLES))

    def weigh(self, found: NDArray[np.float64], exact: Sequence[arb], given: Values) -> float:
        """Return the largest error of the outputs in eps of the scale."""
        scale = run(self.scale, given, IN_BALLS)[0] if self.scale else None
        errors = [
            (arb(value) - true) / (true if scale is None else scale)
            for value, true in zip(found.tolist(), exact, strict=True)
            if scale is not None or true != 0
        ]
        return max((float(abs(error) / EPS) for error in errors), default=0.0)

    def holds(self, points: Mapping[str, Any]) -> Any:
        """Say where the stage is taken."""
        programs = [p for p in (self.kernel.code.inside, self.stage.when) if p]
        inside = [run(p, points, IN_DOUBLES)[0] for p in programs]
        return np.logical_and.reduce(inside) if inside else True


def add_up(
    straight: Straight, chart: Chart, names: Mapping[sp.Basic, str]
) -> Mapping[str, sp.Expr]:
    """Return the sums of arguments and numbers, written in coordinates.

    What cancels there, 1 - e for e = 1 - d, does so before balls are put in.
    """
    values = {names[symbol]: value for symbol, value in chart.arguments.items()}
    sums: dict[str, sp.Expr] = {}
    for step in straight.steps:
        given = [values.get(o) if isinstance(o, str) else sp.Rational(o) for o in step.operands]
        if step.kind in POLYNOMIAL and all(value is not None for value in given):
            value = sp.factor(MEANINGS[step.kind](*given))
            if step.kind in ("add", "subtract"):
                sums[step.result] = value
            if step.ulps == EXACT:
                values[step.result] = value
    return sums


def list_subjects(kernel: Kernel, paper: Paper) -> Iterator[Subject]:
    """List the stages of a kernel that have charts, in every way of computing them."""
    for form, stage in zip(kernel.forms, kernel.code.stages, strict=True):
        if not form.charts:
            continue
        scale = _write_scale(kernel.quantity, form, paper)
        known: list[Straight] = []
        for way, expansions in WAYS.items():
            straight = hold_compensated(flatten_stage(stage, expansions))
            if straight not in known:
                known.append(straight)
                _check_charts(straight, kernel, form)
                yield Subject(kernel, form, stage, way, straight, known[0], scale)
        if kernel.is_shipped:
            compiled = put_off_stage(stage)
            expanded = keep_needed(flatten_stage(compiled, list_expansions()))
            straight = find_scaled(hold_compensated(expanded))
            _check_charts(straight, kernel, form)
            computed = flatten_stage(compiled, {})
            yield Subject(kernel, form, stage, WAY, straight, known[0], scale, computed)


def _check_charts(straight: Straight, kernel: Kernel, form: Form) -> None:
    for chart in form.charts:
        check_symmetry(straight, chart, input_names(kernel.quantity))


def _write_scale(quantity: Quantity, form: Form, paper: Paper) -> Straight | None:
    """Write the scale as the form is written, but for its low words, and without roundings."""
    if quantity.accuracy is None or quantity.accuracy.scale is None:
        return None
    rewrites = tuple(name for name in form.rewrites if name in PLAIN_REWRITES)
    size, value = quantity.accuracy.scale.written_out(), quantity.definition
    more = [size - part for part in (value, sp.Abs(value)) if _has_terms(size, part)]
    straights = [
        _write_exact(expression, rewrites, quantity, paper) for expression in (size, *more)
    ]
    return _join(straights)


def _has_terms(size: sp.Expr, part: sp.Basic) -> bool:
    """Say whether a sum has all terms of another."""
    return isinstance(part, sp.Expr) and {*sp.Add.make_args(part)} <= {*sp.Add.make_args(size)}


def _write_exact(
    expression: sp.Expr, rewrites: tuple[str, ...], quantity: Quantity, paper: Paper
) -> Straight:
    if not expression.free_symbols:
        return Straight((), (), (float(expression),))
    written = Form("scale", expression, rewrites)
    (stage,) = build_kernel(
        "scale", replace(quantity, forms=(written,)), (written,), paper
    ).code.stages
    (plain, *_) = WAYS.values()
    straight = flatten_stage(stage, plain)
    return replace(straight, steps=tuple(replace(step, ulps=EXACT) for step in straight.steps))


def _join(straights: Sequence[Straight]) -> Straight:
    """Put steps one after the other under names of their own."""
    steps: list[Step] = []
    outputs: list[Operand] = []
    for number, straight in enumerate(straights):
        own = {step.result: f"{number}.{step.result}" for step in straight.steps}

        def rename(operand: Operand, own: Mapping[str, str] = own) -> Operand:
            return own.get(operand, operand) if isinstance(operand, str) else operand

        steps += [
            replace(s, result=own[s.result], operands=tuple(map(rename, s.operands)))
            for s in straight.steps
        ]
        outputs += map(rename, straight.outputs)
    return Straight(straights[0].inputs, tuple(steps), tuple(outputs))
