"""The extended oracle: a kernel's own operations in long doubles, millions of points a minute.

Cancellation loses bits here, too, and a wrong formula is wrong in both. Such shadow values are
those of FpDebug (Benz et al. 2012); they only guide a search here, and balls judge its finds.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp

from mechproof.lab.oracle import Truth
from mechproof.lab.sampling.stated_sizes import MARGIN
from mechproof.lab.subject import Subject
from mechproof.lab.ways import Arguments, Array
from mechproof.programs.evaluation import arrange, entries
from mechproof.programs.kernel import input_names, list_functions
from mechproof.programs.lowering import lower_conditions, lower_steps
from mechproof.programs.program import KernelCode, Program
from mechproof.programs.rewrites import apply_rewrites
from mechproof.programs.step_names import share_subexpressions
from mechproof.record.relations import find_slack
from mechproof.roundoff.kernel_runs import blend, name_values, put_points_last, run_stage, run_test
from mechproof.roundoff.running import DIGITS_OF, IN_EXTENDED, IS_LONGER, LONG_DOUBLE, Values, run

IN_PLACE = IN_EXTENDED.but(number=np.float64)


@dataclass(frozen=True)
class Extended:
    """The programs run for a quantity: its code, its errors' scale, and the bound's domain."""

    subject: Subject
    code: KernelCode
    scale: Program | None
    slacks: Program | None
    conditions: Program | None

    def find_truth(self, arguments: Arguments) -> Truth:
        """Return approximate values; points beyond the domain and the bound are undecided."""
        given = self._name_values(arguments, LONG_DOUBLE)
        plain = self._name_values(arguments, np.float64)
        with np.errstate(all="ignore"):
            values = blend(
                self.code.stages,
                lambda stage: run_stage(stage, given, IN_EXTENDED),
                lambda when: run_test(when, plain, IN_PLACE),
            )
            count = len(arguments[0])
            value = np.stack([np.broadcast_to(v, count) for v in values], -1)
            high = value.astype(float)
            held = np.isfinite(high).all(-1)
            # Decided as a kernel decides it, which rounds an irrational end to a double.
            held &= run_test(self.code.inside, plain, IN_PLACE) & self._mark_near(plain)
            held &= run_test(self.conditions, given, IN_EXTENDED)
            for slack in run(self.slacks, given, IN_EXTENDED) if self.slacks else ():
                held &= slack >= 0
            low = (value - high).astype(float)
            scale = self._find_scale(value, given)
            held &= scale is None or np.isfinite(scale)
        shape = count, *self.code.shape
        return Truth(high.reshape(shape), low.reshape(shape), held, scale)

    def _mark_near(self, given: Values) -> Any:
        """Return a mask of points near the domain; for sums only the kernel can decide this."""
        if self.code.indexed:
            return True
        names = input_names(self.subject.quantity)
        columns = {symbol: given[name] for symbol, name in names.items()}
        return self.subject.facts.region.mark_near(columns, MARGIN)

    def _find_scale(self, value: Array, given: Values) -> Array | None:
        if self.subject.quantity.accuracy is None:
            return None
        if self.scale is None:
            size: Array = np.abs(value).max(-1).astype(float)
            return size
        (found,) = run(self.scale, given, IN_EXTENDED)
        scale: Array = np.broadcast_to(found, len(value)).astype(float)
        return scale

    def _name_values(self, arguments: Arguments, kind: type[np.floating[Any]]) -> Values:
        """Return all inputs by name: numbers, components, elements (points on the last axis)."""
        columns = put_points_last(arguments, kind)
        given: Values = {name: kind(digits) for name, digits in DIGITS_OF.items()}
        for argument, column in zip(self.subject.quantity.arguments, columns, strict=True):
            if len(argument.symbols) > 1:
                given |= zip(map(str, argument.symbols), column, strict=True)
        return given | name_values(self.code, columns)


def extend(subject: Subject) -> Extended | None:
    """Return a quantity in long doubles; None without code of its own, or without long doubles."""
    kernels = (k for k in list_functions(subject.paper) if k.is_shipped)
    kernel = next((k for k in kernels if k.name == subject.quantity.name), None)
    if kernel is None or not IS_LONGER:
        return None
    return Extended(subject, kernel.code, _lower_scale(subject), *_lower_within(subject))


def _lower(subject: Subject, where: Mapping[sp.Symbol, sp.Expr], *outputs: sp.Expr) -> Program:
    names = input_names(subject.quantity)
    steps = {s: v for s, v in {**subject.domain.given, **where}.items() if s not in names}
    plain = arrange(frozenset(names), steps.items(), sp.ImmutableDenseMatrix(outputs))
    # Rewritten as the value is, so that common parts cancel in neither.
    found = share_subexpressions(apply_rewrites(plain, subject.quantity.shipped[-1].rewrites))
    return lower_steps(
        names, frozenset(), tuple(names.values()), found.steps, entries(found.output)
    )


def _lower_scale(subject: Subject) -> Program | None:
    accuracy = subject.quantity.accuracy
    if accuracy is None or accuracy.scale is None:
        return None
    return _lower(subject, dict(accuracy.scale.where), accuracy.scale.expression)


def _lower_within(subject: Subject) -> tuple[Program | None, Program | None]:
    """Return the slacks that are not negative where the bound holds, and its other conditions."""
    accuracy, names = subject.quantity.accuracy, input_names(subject.quantity)
    relations = accuracy.within if accuracy else ()
    slacks = {r: slack for r in relations if (slack := find_slack(r)) and not r.has(sp.Indexed)}
    others = [subject.domain.resolve(r) for r in relations if r not in slacks]
    conditions = lower_conditions(names, tuple(names.values()), others) if others else None
    values = [slack.value for slack in slacks.values()]
    return _lower(subject, {}, *values) if values else None, conditions
