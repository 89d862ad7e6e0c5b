"""Validation: the emitted kernels are run in doubles before they are written.

The value of every function, support code included, must be one that some order of roundings of
its program can give; a shipped kernel must also compute its definition, whatever its row states
about it, and keep its accuracy bound against the oracle. The first check alone would pass a dropped
low word, which is smaller than the roundings. The points lie on both sides of every condition,
single and in arrays longer than every block. If numba is installed, compiled kernels are held to
the same bound in each of their loops, or without a bound to the balls of their programs.

A value outside the ball of a result cannot come from any order of roundings: then the source that
was run is not the program. This is the running error analysis of Wilkinson (Higham 2002, section
3.3), with a ball in place of the sum of bounds. IEEE 754 arithmetic is rounded to nearest; every
loop of NumPy's functions is assumed to stay within `LOOPS` ulps.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
import sympy as sp
from flint import arb

from mechproof.arithmetic.balls import evaluate, working_precision
from mechproof.arithmetic.intervals import LEAST_NORMAL, UNIT
from mechproof.codegen.source_reading import TranslationError
from mechproof.kernel_support import blocks
from mechproof.lab.oracle import Truth, count_points, find_errors, find_truth, list_values
from mechproof.lab.sampling.named_sets import TUNE, PointSet, choose_evenly, draw_points
from mechproof.lab.sampling.point_sets import list_sets
from mechproof.lab.subject import Subject
from mechproof.lab.ways import Arguments, Array, Compute
from mechproof.lab.worst_search import mark_accuracy_domain
from mechproof.programs.kernel import Kernel, build_functions, list_functions
from mechproof.programs.operations import KINDS, VIEWS, Arithmetic, Rounding
from mechproof.programs.program import KernelCode, Program, Stage, spell_out_forms
from mechproof.programs.scalar import list_scalars
from mechproof.record import Form
from mechproof.roundoff.kernel_runs import name_values
from mechproof.roundoff.running import IN_BALLS, ON_ARRAYS, run

# Bits of precision, so many that roundings of balls are negligible next to those of doubles.
BITS = 192
# Half an ulp of a float32, relative.
SINGLE_UNIT = 2.0**-24
SMALLEST = 2.0**-1074
LOOPS = 4
LOSSES: Mapping[Rounding, float] = {
    Rounding.EXACT: 0.0,
    Rounding.NEAREST: 1.0,
    Rounding.LIBRARY: 2.0 * LOOPS,
}
# An undecided choice encloses both values; doubles give the zero vector an angle; a sum that is
# never negative may be rounded to zero.
ENCLOSING = IN_BALLS.but(
    arctan2=arb.atan2,
    choose=lambda holds, a, b: a.union(b) if holds is None else a if holds else b,
    nonnegative=lambda total, size: total.union(arb(0)) if total < 0 else total,
)
# Number of points of the first set that are enclosed, and of every set that go to the oracle.
ENCLOSED, DECIDED = 8, 6
# Length of a row of equal points, for compiled loops over rows.
ROW = 3
# The share of a set that is drawn.
SHARE = 0.05
# A ball wider than this share of its value says nothing.
TELLING = 1e-6


@dataclass(frozen=True)
class RoundedBalls:
    """Balls, and whether they enclose float32; None for literal numbers, which have no type."""

    balls: Any
    is_single: bool | None = False


# The constants, as the doubles that a kernel uses for them.
CONSTANTS = {
    **{"#pi": RoundedBalls(arb(np.pi)), "#e": RoundedBalls(arb(np.e))},
    **{"#inf": RoundedBalls(arb("inf")), "#nan": RoundedBalls(arb("nan"))},
}


def enclose_stage(stage: Stage, inputs: Mapping[str, float | Array]) -> list[arb]:
    """Return balls that hold all doubles that the stage can compute from its inputs.

    `inputs` are numbers, or arrays if an axis is summed over. An undecided branch gives both
    values.
    """
    with working_precision(BITS):
        known = {name: _as_balls(value) for name, value in inputs.items()}
        prepared = _run(stage.prepare, known)
        running = tuple(known[name] for name in stage.running)
        if stage.evaluate is None:
            return _map_affinely([v.balls for v in prepared], [v.balls for v in running])
        given = dict(zip(stage.evaluate.inputs, running + prepared, strict=True))
        return [value.balls for value in _run(stage.evaluate, given)]


def decide(condition: Program, inputs: Mapping[str, float | Array]) -> bool:
    """Return whether a condition on the inputs is certainly true."""
    with working_precision(BITS):
        known = {name: _as_balls(value) for name, value in inputs.items()}
        (result,) = _run(condition, known)
        return result.balls is True


def _as_balls(value: float | Array) -> RoundedBalls:
    return RoundedBalls(np.frompyfunc(lambda v: arb(float(v)), 1, 1)(np.asarray(value, float)))


def _run(program: Program, known: Mapping[str, RoundedBalls]) -> tuple[RoundedBalls, ...]:
    return run(spell_out_forms(program), {**known, **CONSTANTS}, ROUNDED)


def _operate(kind: str, *given: RoundedBalls) -> RoundedBalls:
    told = [value.is_single for value in given if value.is_single is not None]
    single = kind == "single" or (bool(told) and all(told))
    return RoundedBalls(_enclose(kind, single, *(v.balls for v in given)), single)


def _enclose(kind: str, single: bool, *values: Any) -> Any:
    if kind in VIEWS:
        return ON_ARRAYS[kind](values[0])
    if kind == "sum":
        return _sum(values[0])
    if kind == "whole_turns_off":
        return np.frompyfunc(_take_turns_off, 1, 1)(values[0])
    exact = np.frompyfunc(ENCLOSING[kind], len(values), 1)(*values)
    loss = LOSSES[KINDS[kind].rounding] * (SINGLE_UNIT if single else UNIT)
    if not loss:
        return exact
    if kind == "tangent_quotient":
        return np.frompyfunc(lambda q, y, c, a, r, b: _spread_quotient(q, c, a, b, loss), 6, 1)(
            exact, *values
        )
    return np.frompyfunc(lambda ball: _spread(ball, loss), 1, 1)(exact)


ROUNDED = Arithmetic(
    {
        **{kind: partial(_operate, kind) for kind in KINDS},
        "number": lambda value: RoundedBalls(arb(value), None),
    }
)


def _spread(ball: arb, relative: float) -> arb:
    """Return the ball widened by a relative error and by the least double."""
    return (
        ball + arb(0, float(abs(ball).upper()) * relative + SMALLEST) if ball.is_finite() else ball
    )


def _spread_quotient(quotient: arb, c: arb, a: arb, b: arb, relative: float) -> arb:
    """Widen a quotient by a share of the largest c*t/(a + b*t**2), as its description states it."""
    largest = float((abs(c) / (2 * (a * b).sqrt())).upper()) * float(
        (1 + (b / a).max(a / b).sqrt()).upper()
    )
    return quotient + arb(0, largest * relative) if quotient.is_finite() else arb(0, largest)


def _take_turns_off(x: arb) -> arb:
    """Return x minus the turns that the nearest double loses, with the roundings of both."""
    if not x.is_finite():
        return x
    turns = round(float(x.mid()) / (2 * np.pi))
    return x - 2 * arb.pi() * turns + arb(0, 4 * UNIT * float(abs(x).upper()))


def _sum(array: Any) -> Any:
    terms = np.asarray(array, object).ravel()
    total = sum(terms, start=arb(0))
    size = sum((float(abs(t).upper()) for t in terms), start=0.0)
    return total + arb(0, size * UNIT * len(terms))


def _map_affinely(entries: list[Any], point: list[Any]) -> list[Any]:
    """Return M @ p + v with the error of sums and products in any order."""
    count = len(point)
    rows = [entries[i * count : (i + 1) * count] for i in range(count)]
    found = []
    for row, shift in zip(rows, entries[-count:], strict=True):
        terms = [m * p for m, p in zip(row, point, strict=True)] + [shift]
        size = sum((float(abs(t).upper()) for t in terms), start=0.0)
        found.append(sum(terms, start=arb(0)) + arb(0, 2 * (count + 1) * UNIT * size))
    return found


def validate(subjects: Iterator[Subject]) -> None:
    """Run the functions of all quantities.

    Raises `TranslationError` with the function, the point, and both values.
    """
    for subject in subjects:
        own = [f for f in list_functions(subject.paper) if f.quantity is subject.quantity]
        for kernel in own:
            for module in subject.modules:
                if hasattr(module, kernel.name):
                    _check_rounding(subject, kernel, getattr(module, kernel.name))
        if subject.quantity.forms and subject.modules[0] is not None:
            check_meaning(subject)
            _check_compiled(subject)
        if subject.quantity.forms and subject.quantity.accuracy:
            _check_accuracy(subject)


def _check_rounding(subject: Subject, kernel: Kernel, compute: Compute) -> None:
    """Compare scalars and long arrays with the balls of the program."""
    arguments = _take(subject, list_sets(subject, SHARE)[0], ENCLOSED)
    telling = 0
    for index in range(count_points(subject, arguments)):
        point = tuple(np.asarray(a[index]) for a in arguments)
        named = name_values(kernel.code, point)
        balls = enclose_stage(_choose_stage(kernel.code, named), named)
        for result in _compute_every_way(compute, point):
            values = np.ravel(result)
            for value, ball in zip(values, balls, strict=True):
                _require_inside(kernel.name, point, float(value), ball)
        telling += all(ball.rad() <= TELLING * abs(ball).upper() + LEAST_NORMAL for ball in balls)
    if not telling:
        raise TranslationError(
            f"{kernel.name}: at every point, the ball of the program is too wide to show an error"
        )


def check_meaning(subject: Subject) -> None:
    """Compare the shipped programs with the definition, which a row may state differently.

    Raises `TranslationError` with the function, the point, and both values.
    """
    quantity, functions = subject.quantity, build_functions(subject.paper).kernels
    (kernel,) = (f for f in functions if f.quantity is quantity and f.is_shipped)
    arguments = _take(subject, list_sets(subject, SHARE)[0], ENCLOSED)
    truth = find_truth(subject, arguments)
    for index, values in enumerate(list_values(subject, arguments)):
        point = tuple(np.asarray(a[index]) for a in arguments)
        named = name_values(kernel.code, point)
        stage = _choose_stage(kernel.code, named)
        form = kernel.forms[kernel.code.stages.index(stage)]
        for ball, value in zip(enclose_stage(stage, named), truth.high[index].flat, strict=True):
            apart = abs(ball - arb(float(value)))
            allowed = TELLING * abs(ball) + _bound_of(form, subject, values)
            if truth.decided[index] and apart > allowed:
                shown = ", ".join(repr(p.tolist()) for p in point)
                raise TranslationError(
                    f"{quantity.name}({shown}): its program gives {ball.str(20)}, its definition "
                    f"{float(value)!r}"
                )


def _check_compiled(subject: Subject) -> None:
    """Compare a compiled kernel that has no bound with the balls of its program."""
    quantity = subject.quantity
    compiled = getattr(subject.load_compiled(), quantity.name, None)
    if compiled is None or quantity.accuracy:
        return
    (kernel,) = (k for k in list_scalars(subject.paper) if k.quantity is quantity)
    if not kernel.code.indexed:
        _check_rounding(subject, kernel, compiled)


def _bound_of(form: Form, subject: Subject, values: Mapping[sp.Basic, Any]) -> arb:
    return arb(0) if form.bound is None else evaluate(subject.domain.resolve(form.bound), values)


def _require_inside(name: str, point: Arguments, value: float, ball: arb) -> None:
    if ball.is_finite() and not ball.contains(arb(value)):
        shown = ", ".join(repr(p.tolist()) for p in point)
        raise TranslationError(f"{name}({shown}): {value!r}, its program gives {ball.str(20)}")


def _compute_every_way(compute: Compute, point: Arguments) -> Iterator[float | np.ndarray]:
    """Yield a point's value computed on its own, and in an array longer than a block."""
    with np.errstate(all="ignore"):
        yield compute(*point)
        first, *others = point
        many = np.broadcast_to(first, (blocks.BLOCK, *first.shape)).copy()
        yield compute(many, *others)[blocks.BLOCK // 2]


def _choose_stage(code: KernelCode, named: Mapping[str, float | Array]) -> Stage:
    return next(s for s in code.stages if s.when is None or decide(s.when, named))


def _check_accuracy(subject: Subject) -> None:
    """Hold the shipped and the compiled kernel to their bound on a few points of every set."""
    for point_set in list_sets(subject, SHARE):
        if point_set.ordered:
            continue
        arguments = _take(subject, point_set, DECIDED)
        truth = find_truth(subject, arguments)
        held = mark_accuracy_domain(subject, arguments) & truth.decided
        with np.errstate(all="ignore"):
            _require_accuracy(subject, arguments, truth, held, subject.kernel(*arguments))
        if compiled := getattr(subject.load_compiled(), subject.quantity.name, None):
            for result in _compute_compiled(compiled, arguments):
                _require_accuracy(subject, arguments, truth, held, result, "compiled: ")


def _compute_compiled(compute: Compute, arguments: Arguments) -> Iterator[np.ndarray]:
    """Yield the points' values by every compiled loop: together, one by one, in rows of equals."""
    points = list(zip(*arguments, strict=True))
    yield compute(*arguments)
    yield np.array([compute(*point) for point in points])
    rows = [compute(np.repeat(first[None], ROW, 0), *others) for first, *others in points]
    yield np.array([row[-1] for row in rows])


def _require_accuracy(
    subject: Subject,
    arguments: Arguments,
    truth: Truth,
    held: np.ndarray,
    result: np.ndarray,
    how: str = "",
) -> None:
    accuracy = subject.quantity.accuracy
    assert accuracy is not None
    errors = np.where(held, find_errors(result, truth).scaled, 0.0)
    worst = int(np.argmax(errors))
    if errors[worst] > accuracy.ulp:
        shown = ", ".join(repr(np.asarray(a[worst]).tolist()) for a in arguments)
        raise TranslationError(
            f"{how}{subject.name}({shown}): {np.asarray(result)[worst]!r}, the oracle gives "
            f"{truth.high[worst]!r}: off by {errors[worst]:.3g} eps, allowed are {accuracy.ulp:g}"
        )


def _take(subject: Subject, point_set: PointSet, count: int) -> Arguments:
    """Take a few points of a set, evenly spread over it."""
    arguments = draw_points(point_set, TUNE)
    total = count_points(subject, arguments)
    chosen = choose_evenly(total, count)
    return tuple(
        a[chosen] if len(a) == total else np.repeat(a[None], len(chosen), 0) for a in arguments
    )
