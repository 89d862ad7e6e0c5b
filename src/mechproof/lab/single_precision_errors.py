"""Single precision: a quantity's kernel in floats, as C computes it, and its worst errors found.

Each operation is rounded once. Beyond their largest angle, C uses its library's functions; here
these are assumed to be correctly rounded.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from functools import partial, reduce
from pathlib import Path
from typing import Any

import numpy as np
import sympy as sp

from mechproof.codegen.docstrings import describe_bound
from mechproof.lab.extended_oracle import extend
from mechproof.lab.oracle import EPS
from mechproof.lab.sampling.named_sets import TUNE, choose_evenly, join
from mechproof.lab.sampling.stated_sizes import MARGIN
from mechproof.lab.subject import Subject, make_subjects
from mechproof.lab.ways import Arguments, Array
from mechproof.lab.worst_search import SearchedInput, compare, draw_sets, scaled_errors
from mechproof.measured import round_up
from mechproof.programs.elementary.formats import DOUBLE, SINGLE
from mechproof.programs.elementary.function_programs import BODIES, build
from mechproof.programs.kernel import Kernel
from mechproof.programs.operations import KINDS, Arithmetic
from mechproof.programs.program import Stage
from mechproof.programs.scalar import ADDED, fold_sums, list_scalars
from mechproof.record import Paper
from mechproof.roundoff.climb import (
    BY_BALLS,
    JUDGED,
    Column,
    Measure,
    Points,
    Schedule,
    climb,
    climb_and_judge,
    gather,
)
from mechproof.roundoff.kernel_runs import blend, name_values, put_points_last, run_stage, run_test
from mechproof.roundoff.running import IN_DOUBLES, IN_EXTENDED, Values, add_to_odd, find_number, run
from mechproof.roundoff.steps import CONSTANT
from mechproof.roundoff.term_sums import run_loop

FORMAT = np.float32
SMALLEST = np.finfo(FORMAT).smallest_normal
# Operations whose results may fall below the range though no operand is 0.
SCALING = ("multiply", "divide", "square")
# The share of each set that is drawn, the most of its points that balls judge, and the rounds of
# the climb by long doubles.
SHARE, MOST, ROUNDS = 0.05, 20, 12
SCHEDULE = Schedule(300, 6)
WIDER = float(np.finfo(FORMAT).eps) / EPS
# Multiples of the eps of doubles in which distances from edges are stated.
FEW = range(1, 1000)
# Largest angles, in radians, that are reduced without the library: in doubles and in floats.
FAR, NEAR = sp.Integer(DOUBLE.largest), sp.Integer(SINGLE.largest)


def _fma(a: Any, b: Any, c: Any) -> Any:
    """Return a*b + c rounded once: the product is exact in doubles, the sum rounded to odd."""
    product, rest = np.multiply(a, b, dtype=float), np.asarray(c, float)
    total = product + rest
    return FORMAT(np.where(np.isfinite(total), add_to_odd(product, rest), total))


def _in_doubles(function: Callable[[Any], Any]) -> Callable[[Any], Any]:
    return lambda y: FORMAT(function(np.asarray(y, float)))


# Operations of the machine and of the library; elementary functions for angles too large.
_MACHINE = IN_DOUBLES.but(
    number=FORMAT,
    constant=lambda operand: FORMAT(float(find_number(operand))),
    fma=_fma,
    maximum=lambda a, b: np.where((a >= b) | np.isnan(a), a, b),
    power_of_two=lambda n: FORMAT(np.exp2(np.asarray(n, float))),
    **{kind: _in_doubles(getattr(np, kind)) for kind in ("sin", "cos", "tan")},
)


def _compute(kind: str, *operands: Any) -> Any:
    function = build(kind, SINGLE)
    given = dict(zip(function.program.inputs, operands, strict=True))
    (value,) = run(function.program, given, _MACHINE)
    if function.far is None:
        return value
    (beyond,) = run(function.far, given, _MACHINE)
    return np.where(np.abs(operands[0]) <= FORMAT(SINGLE.largest), value, beyond)


IN_SINGLES = _MACHINE.but(**{kind: partial(_compute, kind) for kind in BODIES})
COMPUTED = ("number", CONSTANT, *filter(IN_SINGLES.__contains__, KINDS))


class Singles:
    """A kernel in floats, as C computes it; every argument has an axis of points."""

    def __init__(self, kernel: Kernel) -> None:
        (folded,), self._loops = fold_sums([kernel])
        self._code = folded.code

    def __call__(self, *arguments: Column) -> Column:
        """Return the values; outside the domain they are NaN."""
        return self.run(arguments)[0]

    def run(self, arguments: Points) -> tuple[Column, Column]:
        """Return the values, and where some intermediate value leaves the range of floats."""
        given, count = self._name_values(arguments, FORMAT), len(arguments[0])
        with np.errstate(all="ignore"):
            *found, lost = blend(
                self._code.stages,
                lambda stage: self._run_stage(stage, given, count),
                lambda when: run_test(when, given, IN_SINGLES),
            )
        value = np.stack([np.broadcast_to(v, count) for v in found], -1)
        size = np.abs(value).max(axis=1)
        lost |= (size > 0) & (size < SMALLEST)
        value = np.where(self.mark_inside(arguments)[:, np.newaxis], value, FORMAT(np.nan))
        return value.reshape(count, *self._code.shape), lost

    def mark_inside(
        self, arguments: Points, arithmetic: Arithmetic = IN_SINGLES, kind: type[Any] = FORMAT
    ) -> Column:
        """Return a mask of points in the domain, as decided by numbers of type `kind`."""
        given, count = self._name_values(arguments, kind), len(arguments[0])
        with np.errstate(all="ignore"):
            held = run_test(self._code.inside, given, self._add_loops(arithmetic))
        return np.broadcast_to(held, count)

    def _run_stage(self, stage: Stage, given: Values, count: int) -> tuple[Any, ...]:
        lost = np.zeros(count, bool)
        watched = {kind: partial(_watch, kind, IN_SINGLES[kind], lost) for kind in COMPUTED}
        return *run_stage(stage, given, self._add_loops(IN_SINGLES.but(**watched))), lost

    def _add_loops(self, arithmetic: Arithmetic) -> Arithmetic:
        return arithmetic.but(
            **{r.name: partial(run_loop, r, arithmetic, IN_SINGLES[ADDED]) for r in self._loops}
        )

    def _name_values(self, arguments: Points, kind: type[Any]) -> Values:
        """Return the values of every component; elements to be summed are on the first axes."""
        constants = {"#pi": kind(np.pi), "#e": kind(np.e), "#nan": kind(np.nan)}
        return {**constants, **name_values(self._code, put_points_last(arguments, kind))}


def _watch(kind: str, compute: Callable[..., Any], lost: Column, *operands: Any) -> Any:
    """Compute an operation, and mark in `lost` where its value leaves the range of floats."""
    result = compute(*operands)
    if kind not in ("number", CONSTANT) and np.asarray(result).dtype == FORMAT:
        divisors = operands[1:] if kind == "divide" else ()
        lost |= _hold(np.isfinite, operands) & _hold(np.sign, divisors) & np.isinf(result)
        if kind in SCALING:
            lost |= _hold(np.sign, operands) & (np.abs(result) < SMALLEST)
    return result


def _hold(mark: Callable[[Any], Any], operands: Iterable[Any]) -> Any:
    """Return where a mark is true for all operands."""
    marks = (np.asarray(mark(operand), bool) for operand in operands)
    return reduce(lambda one, other: one & other, marks, np.asarray(True))


def find_worst_singles(subject: Subject, kernel: Kernel) -> SearchedInput:
    """Search for the worst error in floats, in eps of floats times the scale of the bound.

    Points are floats. Left out are points at which an intermediate value leaves the range of
    floats, and points so near a computed limit of the domain that floats cannot tell the side.
    """
    subject = narrow(subject)
    singles, extended = Singles(kernel), extend(subject)

    def judge(points: Arguments) -> Array:
        return _judge(partial(scaled_errors, subject, singles), points)

    def estimate(points: Arguments) -> Array:
        assert extended is not None
        return _judge(lambda kept: compare(singles, kept, extended.find_truth(kept)), points)

    def _judge(measure: Measure, points: Arguments) -> Array:
        rounded = round_singly(points)
        kept = mark_judged(subject, singles, rounded)
        heights = np.full(len(points[0]), -1.0)
        if kept.any():
            heights[kept] = measure(tuple(c[kept] for c in rounded))
        return np.where(heights > 0, heights / WIDER, heights)

    sets = [*draw_sets(subject, TUNE, SHARE)]
    few = join(*(tuple(c[choose_evenly(len(c), MOST)] for c in drawn) for drawn in sets))
    rng = np.random.default_rng(TUNE)
    population = climb(judge, few, BY_BALLS, 0, rng)
    if extended is not None:
        found = climb_and_judge(judge, estimate, join(*sets), SCHEDULE, ROUNDS, rng)
        population = gather(population, found, JUDGED)
    point, scaled = population.worst
    return SearchedInput(round_singly(point), scaled, population.tried)


def state_errors(paper: Paper, place: Path) -> Mapping[str, str]:
    """Return, for every kernel that C has in float, a text on its worst error found."""
    subjects = {s.quantity.name: s for s in make_subjects(paper, place, None)}
    kernels = {kernel.name: kernel for kernel in list_scalars(paper)}
    return {name: _state_error(subjects[name], kernel) for name, kernel in kernels.items()}


def _state_error(subject: Subject, kernel: Kernel) -> str:
    found = find_worst_singles(subject, kernel)
    if found.scaled < 0:
        return f"none of {found.tried} points could be judged"
    quantity, worst = narrow(subject).quantity, round_up(found.scaled)
    if quantity.accuracy is None:
        return f"{worst:g} units in the last place at the worst of {found.tried} points"
    told = describe_bound(replace(quantity, accuracy=replace(quantity.accuracy, ulp=worst)))
    return f"{told}; the worst of {found.tried} points"


def narrow(subject: Subject) -> Subject:
    """Return a quantity whose bound holds as far as floats reduce angles and resolve edges."""
    accuracy = subject.quantity.accuracy
    if accuracy is None:
        return subject
    within = tuple(
        relation.xreplace({FAR: NEAR}).replace(_is_a_few_eps, lambda few: few * int(WIDER))
        for relation in accuracy.within
    )
    quantity = replace(subject.quantity, accuracy=replace(accuracy, within=within))
    return replace(subject, quantity=quantity)


def _is_a_few_eps(number: sp.Basic) -> bool:
    """Return whether a number is a small multiple of the doubles' eps, as edge distances are."""
    return isinstance(number, sp.Rational) and (number / sp.Rational(EPS)) in FEW


def round_singly(points: Arguments) -> Arguments:
    """Round every number to the nearest float."""
    with np.errstate(over="ignore"):
        return tuple(np.asarray(c, FORMAT).astype(float) for c in points)


def mark_judged(subject: Subject, singles: Singles, points: Arguments) -> Array:
    """Return a mask of points inside at which no intermediate value leaves the range of floats.

    For sums, floats themselves decide as well whether a point near the limits is inside.
    """
    judged = singles.mark_inside(points, IN_EXTENDED, np.longdouble) & ~singles.run(points)[1]
    if subject.quantity.has_families:
        return judged & singles.mark_inside(points)
    columns = subject.facts.unpack(points)
    near: Array = subject.facts.region.mark_near(columns, MARGIN * WIDER)
    return judged & near
