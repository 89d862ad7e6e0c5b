"""Computed stages: in, a stage of a kernel; out, its steps and its error over boxes."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial
from types import MappingProxyType
from typing import Any

import numpy as np
import sympy as sp

from mechproof.arithmetic.cover import Boxes
from mechproof.arithmetic.intervals import EPS, Array
from mechproof.programs.elementary.formats import DOUBLE
from mechproof.programs.elementary.function_programs import BODIES, build
from mechproof.programs.kernel import Kernel, input_names
from mechproof.programs.operations import Arithmetic
from mechproof.programs.program import CONSTANTS, Program, Stage
from mechproof.record import Chart, Form
from mechproof.roundoff.affine import AffineMap, measure_norm
from mechproof.roundoff.bound import ErrorAnalysis
from mechproof.roundoff.branches import Branch, list_bounded_branches
from mechproof.roundoff.compiled_kernels import COMPILED
from mechproof.roundoff.elementary_errors import prove
from mechproof.roundoff.error_sums import ErrorScale
from mechproof.roundoff.interval_monomials import bound_in_groups
from mechproof.roundoff.regions import (
    ChartMembership,
    ChartRegion,
    add_up,
    express,
    find_membership,
)
from mechproof.roundoff.running import IN_DOUBLES, run
from mechproof.roundoff.steps import (
    CONSTANT,
    FUNCTIONS,
    NORMAL,
    SUMS,
    TERMS,
    StraightLineProgram,
)
from mechproof.roundoff.term_sums import SEARCHED, TermSum
from mechproof.roundoff.written_scales import WrittenScale

WAVES = ("sin", "cos")
# Over more steps than this, including those of the scale, intervals get so wide that they need many
# more boxes than linear forms do, although each box takes twice as long with these. Over fewer,
# forms may even bound a part of a box less closely than the box.
LONG = 150
# The constants as doubles, as kernels compare with them.
NUMBERS = MappingProxyType({name: IN_DOUBLES[CONSTANT](name) for name in CONSTANTS})


@dataclass(frozen=True)
class ComputedStage:
    """A stage of a kernel in one of the ways in which it is computed.

    `exact` are steps whose values without rounding are the truth; `scale` are the steps of the
    quantity that errors are relative to, None for the value itself; `computed` are those of a
    compiled kernel, with calls of elementary functions. For a `map` of points the norm of the error
    counts, and the scale is that of the matrix. For a sum over a set, `total` describes the sum and
    `kernel` takes a number in its place. `sums` are cached for each chart.
    """

    kernel: Kernel
    form: Form
    stage: Stage
    way: str
    straight: StraightLineProgram
    exact: StraightLineProgram
    scale: WrittenScale | None
    computed: StraightLineProgram | None = None
    map: AffineMap | None = None
    total: TermSum | None = None
    sums: dict[tuple[int, int], Mapping[str, sp.Expr]] = field(
        default_factory=dict, init=False, compare=False
    )

    @property
    def digest(self) -> str:
        """Return the SHA-256 of the steps, the coordinates and the scale."""
        parts = (*self._bounded, *self._programs, *((self.total,) if self.total else ()))
        return hashlib.sha256("\n".join(map(str, parts)).encode()).hexdigest()

    @property
    def basis(self) -> tuple[object, ...]:
        """Return everything a bound is computed from: ways with equal bases share their bounds."""
        return (*self._bounded, self.map)

    @property
    def _bounded(self) -> tuple[object, ...]:
        scale = self.scale.straights if self.scale else (None,)
        return (self.straight, self.form.charts, self.form.mirrors, *scale)

    @property
    def _programs(self) -> Iterator[StraightLineProgram | Program]:
        """Yield the steps of a compiled kernel and the programs of the functions they call."""
        if self.computed:
            yield self.computed
            for kind in sorted({step.kind for step in self.computed.steps} & BODIES.keys()):
                yield build(kind, DOUBLE).program

    @property
    def where(self) -> tuple[str, ...]:
        """List the conditions on arguments under which the bound holds; empty if for all."""
        return tuple(dict.fromkeys(chart.text for chart in self.form.charts if chart.text))

    @property
    def assumptions(self) -> tuple[str, ...]:
        """List the assumptions that the bound rests on, as texts."""
        kinds = {step.kind for step in self.straight.steps if not step.proved}
        functions = (FUNCTIONS[k] for k in sorted(kinds & FUNCTIONS.keys()))
        sums = SUMS if self.map else TERMS if self.total else ""
        return (*functions, *((sums,) if sums and not self.computed else ()), NORMAL)

    @cached_property
    def branches(self) -> tuple[Branch, ...]:
        """Return the branches of the steps that are bounded separately."""
        return list_bounded_branches(self.straight)

    def bound(self, region: ChartRegion, boxes: Boxes) -> Array:
        """Bound the error in eps of the scale over boxes; infinite where it cannot be bounded.

        For a sum over a set, this is the bound for one term.
        """
        found = self._bound_branches(region, boxes)
        return self.total.widen(found) if self.total else found

    @property
    def each(self) -> float:
        """Return how much each term of a set after the first adds to the bound, in eps."""
        return self.total.each if self.total else 0.0

    @property
    def more(self) -> float:
        """Return how much the terms after the first add, in eps, for sets of the searched size."""
        return self.each * (SEARCHED - 1)

    def _bound_branches(self, region: ChartRegion, boxes: Boxes) -> Array:
        if len(self.branches) == 1:
            return bound_in_groups(partial(self._bound, self.branches[0], region), boxes)
        highest = np.zeros(len(boxes))
        for branch in self.branches:
            taken = bound_in_groups(partial(self._find_taken, branch, region), boxes) > 0
            found = bound_in_groups(partial(self._bound, branch, region), boxes[taken])
            highest[taken] = np.maximum(highest[taken], found)
        return highest

    def _bound(
        self, branch: Branch, region: ChartRegion, part: Boxes, forced: tuple[int, ...]
    ) -> Array:
        evaluation, bar = self.evaluate(branch, region, part, forced)
        if self.total and not bar.holds_value:
            # Each term adds a share of the value, which a scale without the value cannot bound.
            return np.full(len(part), np.inf)
        if self.map:
            return np.broadcast_to(self.map.bound(evaluation, bar), len(part))
        highest = np.zeros(len(part))
        for output in branch.straight.outputs:
            highest = np.maximum(highest, evaluation.sum_errors(output, bar))
        return highest

    def _find_taken(
        self, branch: Branch, region: ChartRegion, part: Boxes, forced: tuple[int, ...]
    ) -> Array:
        """Return 1 for boxes in which a branch may be taken, 0 for others."""
        (found,) = self._run([branch.test], region, part, forced)
        is_taken = branch.find_taken(found.value(branch.tested))
        return np.broadcast_to(np.where(is_taken, 1.0, 0.0), len(part))

    def evaluate(
        self, branch: Branch, region: ChartRegion, boxes: Boxes, forced: tuple[int, ...] = ()
    ) -> tuple[ErrorAnalysis, ErrorScale]:
        """Return the analysis of all values over boxes, and the scale of their errors."""
        steps = self.map.entries if self.map else branch.straight
        if self.scale is None:
            return self._run([steps], region, boxes, forced)[0], ErrorScale(None, True)
        analysis, *scales = self._run([steps, *self.scale.straights], region, boxes, forced)
        pairs = zip(scales, self.scale.straights, strict=True)
        return analysis, self.scale.weigh(*([*map(s.value, own.outputs)] for s, own in pairs))

    @cached_property
    def has_forms(self) -> bool:
        """Return whether linear forms bound it: a map, whose signs are kept, or many steps."""
        scales = self.scale.straights if self.scale else ()
        count = sum(len(straight.steps) for straight in (self.straight, *scales))
        return self.map is not None or count > LONG

    def _run(
        self,
        straights: Sequence[StraightLineProgram],
        region: ChartRegion,
        boxes: Boxes,
        forced: tuple[int, ...],
    ) -> list[ErrorAnalysis]:
        """Return the analyses of several lists of steps over the same boxes."""
        kinds = [step.kind for straight in straights for step in straight.steps]
        # If the scale has terms of its own, sines and cosines that vanish cancel term by term.
        waves = sum(map(kinds.count, WAVES)) if self.scale and self.scale.terms else 0
        variables, monomials, turn = region.enter(
            boxes,
            kinds.count("tan"),
            forced,
            waves,
            has_forms=self.has_forms,
            is_bent=self.map is not None,
        )
        names = input_names(self.kernel.quantity)
        arguments = region.chart.arguments.items()
        given = {names[symbol]: express(value, variables, monomials) for symbol, value in arguments}
        found = []
        for straight in straights:
            plain = self._add_up(straight, region.chart)
            stated = {
                result: express(value, variables, monomials) for result, value in plain.items()
            }
            found.append(ErrorAnalysis(straight, variables, given, stated, turn, prove))
        return found

    def _add_up(self, straight: StraightLineProgram, chart: Chart) -> Mapping[str, sp.Expr]:
        key = (id(straight), id(chart))
        if key not in self.sums:
            self.sums[key] = add_up(straight, chart, input_names(self.kernel.quantity))
        return self.sums[key]

    def compute(self, points: Mapping[str, Any]) -> Array:
        """Return the outputs computed in doubles, in this stage's way."""
        given = self.total.put_rounded(points) if self.total else points
        if self.computed:
            return np.array(run(self.computed, given, COMPILED))
        return np.array(run(self.straight, given, IN_DOUBLES))

    def complete(self, given: Mapping[str, Any], arithmetic: Arithmetic) -> Mapping[str, Any]:
        """Return the values of the arguments, with that of the sum over a set if there is one."""
        return self.total.put_exact(given, arithmetic) if self.total else given

    def weigh(
        self, found: Sequence[Any], given: Mapping[str, Any], arithmetic: Arithmetic
    ) -> list[Any]:
        """Return the outputs' errors in eps of the scale; for a map, the norm of its error."""
        exact = run(self.exact, given, arithmetic)
        apart = [
            arithmetic["number"](value) - true for value, true in zip(found, exact, strict=True)
        ]
        scales = exact
        if self.scale:
            scales = run(self.scale.straights[0], given, arithmetic)[:1] * len(exact)
        if self.map:
            whole = self.map.compute_scale(scales[0], given, arithmetic)
            return [measure_norm(apart, arithmetic) / whole / EPS]
        return [abs(off / scale) / EPS for off, scale in zip(apart, scales, strict=True)]

    @cached_property
    def inside(self) -> ChartMembership:
        """Return the test of whether arguments lie where the bound holds."""
        return find_membership(self.form, input_names(self.kernel.quantity))

    def holds(self, points: Mapping[str, Any]) -> Any:
        """Return where points lie in the kernel's domain and meet the stage's condition."""
        programs = [p for p in (self.kernel.code.inside, self.stage.when) if p]
        given = {**NUMBERS, **self.complete(points, IN_DOUBLES)}
        asking = self.total.asking if self.total else IN_DOUBLES
        inside = [run(p, given, asking)[0] for p in programs]
        return np.logical_and.reduce(inside) if inside else True
