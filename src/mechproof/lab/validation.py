"""Validation: the emitted kernels are run in doubles before they are written.

Every function, its support code included, has to give a value that some order of roundings of its
program can give; a shipped kernel has to compute its definition, whatever its row states of it, and
to keep its accuracy bound against the oracle as well. The first alone would pass a low word that is
dropped: it is smaller than what rounding may do. The points lie on both sides of every condition,
alone and in arrays longer than every block. Compiled kernels are held to the same bound, each of
their loops, where numba is installed; to the balls of their programs where there is no bound.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
import sympy as sp
from flint import arb

from mechproof.arithmetic.balls import evaluate
from mechproof.arithmetic.intervals import LEAST_NORMAL
from mechproof.codegen.source_reading import TranslationError
from mechproof.kernel_support import blocks
from mechproof.lab.accuracy_domain import mark_accuracy_domain
from mechproof.lab.error import find_errors
from mechproof.lab.oracle import Truth, count_points, find_truth, list_values
from mechproof.lab.rounding import decide, enclose_stage
from mechproof.lab.sampling.named_sets import TUNE, PointSet, choose_evenly, draw_points
from mechproof.lab.sampling.point_sets import list_sets
from mechproof.lab.subject import Subject
from mechproof.lab.ways import Arguments, Compute
from mechproof.programs.code import KernelCode, Stage
from mechproof.programs.kernel import Kernel, build_functions, list_functions
from mechproof.programs.scalar import list_scalars
from mechproof.record import Form

# Of the first set so many points are enclosed, of every set so many go to the oracle.
ENCLOSED, DECIDED = 8, 6
# A row of equal points for compiled loops over rows.
ROW = 3
# Of a set so much is drawn.
SHARE = 0.05
# Of a value and its ball: a ball wider than this part of the value says nothing.
TELLING = 1e-6


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
        balls = enclose_stage(_choose_stage(kernel.code, point), _name(kernel.code, point))
        for result in _compute_every_way(compute, point):
            values = np.ravel(result)
            for value, ball in zip(values, balls, strict=True):
                _require_inside(kernel.name, point, float(value), ball)
        telling += all(ball.rad() <= TELLING * abs(ball).upper() + LEAST_NORMAL for ball in balls)
    if not telling:
        raise TranslationError(f"{kernel.name}: rounding explains every value at every point")


def check_meaning(subject: Subject) -> None:
    """Compare the shipped programs with the definition, which a row may state in other words.

    Raises `TranslationError` with the function, the point, and both values.
    """
    quantity, functions = subject.quantity, build_functions(subject.paper).kernels
    (kernel,) = (f for f in functions if f.quantity is quantity and f.is_shipped)
    arguments = _take(subject, list_sets(subject, SHARE)[0], ENCLOSED)
    truth = find_truth(subject, arguments)
    for index, values in enumerate(list_values(subject, arguments)):
        point = tuple(np.asarray(a[index]) for a in arguments)
        named = _name(kernel.code, point)
        stage = _choose_stage(kernel.code, point)
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
    """Compare a compiled kernel that is held to no bound with the balls of its program."""
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
    """Compute a point alone, and in an array longer than a block."""
    with np.errstate(all="ignore"):
        yield compute(*point)
        first, *others = point
        many = np.broadcast_to(first, (blocks.BLOCK, *first.shape)).copy()
        yield compute(many, *others)[blocks.BLOCK // 2]


def _choose_stage(code: KernelCode, point: Arguments) -> Stage:
    named = _name(code, point)
    return next(s for s in code.stages if s.when is None or decide(s.when, named))


def _name(code: KernelCode, point: Arguments) -> Mapping[str, float | np.ndarray]:
    """Name the values of a point as the programs do, vectors by their components."""
    parts = dict(code.vectors)
    named: dict[str, float | np.ndarray] = {}
    for name, value in zip(code.arguments, point, strict=True):
        named |= dict(zip(parts[name], value, strict=True)) if name in parts else {name: value}
    return named


def _check_accuracy(subject: Subject) -> None:
    """Hold the shipped kernel to its bound on a few points of every set, and the compiled one."""
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
    """Compute points by every loop of a compiled kernel: together, alone, and in rows of equals."""
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
            f"{truth.high[worst]!r}: {errors[worst]:.3g} of {accuracy.ulp:g} eps"
        )


def _take(subject: Subject, point_set: PointSet, count: int) -> Arguments:
    """Take a few points of a set, evenly spread over it."""
    arguments = draw_points(point_set, TUNE)
    total = count_points(subject, arguments)
    chosen = choose_evenly(total, count)
    return tuple(
        a[chosen] if len(a) == total else np.repeat(a[None], len(chosen), 0) for a in arguments
    )
