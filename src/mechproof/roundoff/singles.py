"""Single precision: kernels in floats as C computes them, each operation rounded once.

Beyond their largest angle the functions of C's own library are taken; here these are rounded right.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial, reduce
from typing import Any

import numpy as np

from mechproof.programs.code import Stage
from mechproof.programs.elementary.formats import SINGLE
from mechproof.programs.elementary.function_programs import BODIES, build
from mechproof.programs.kernel import Kernel
from mechproof.programs.operations import KINDS, Arithmetic
from mechproof.programs.scalar import list_arguments, list_stages, name_domain
from mechproof.programs.term_loops import ADDED, fold_sums
from mechproof.roundoff.climb import Column, Points
from mechproof.roundoff.running import IN_DOUBLES, Values, add_to_odd, find_number, run
from mechproof.roundoff.steps import CONSTANT, flatten_stage
from mechproof.roundoff.term_sums import run_loop

FORMAT = np.float32
SMALLEST = np.finfo(FORMAT).smallest_normal
# What may leave the range below, of operands that are not 0.
SCALING = ("multiply", "divide", "square")


def _fma(a: Any, b: Any, c: Any) -> Any:
    """Return a*b + c rounded once: the product is exact in doubles, the sum rounded to odd."""
    product, rest = np.multiply(a, b, dtype=float), np.asarray(c, float)
    total = product + rest
    return FORMAT(np.where(np.isfinite(total), add_to_odd(product, rest), total))


def _in_doubles(function: Callable[[Any], Any]) -> Callable[[Any], Any]:
    return lambda y: FORMAT(function(np.asarray(y, float)))


# What the machine and the library compute, an elementary function beyond its largest angle too.
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
        self._code, self._arguments = folded.code, list_arguments(folded)
        self._inside = name_domain(folded)
        self._stages = [stage for _, stage in list_stages(folded)]

    def __call__(self, *arguments: Column) -> Column:
        """Return the values; outside the domain they are NaN."""
        return self.run(arguments)[0]

    def run(self, arguments: Points) -> tuple[Column, Column]:
        """Return the values, and where a value on the way leaves the range of floats."""
        given, count = self._name_values(arguments, FORMAT), len(arguments[0])
        with np.errstate(all="ignore"):
            value, lost = self._run_stage(self._stages[-1], given, count)
            for stage in self._stages[-2::-1]:
                assert stage.when is not None
                here = np.broadcast_to(run(stage.when, given, IN_SINGLES)[0], count)
                other, other_lost = self._run_stage(stage, given, count)
                value = np.where(here[:, np.newaxis], other, value)
                lost = np.where(here, other_lost, lost)
        size = np.abs(value).max(axis=1)
        lost |= (size > 0) & (size < SMALLEST)
        value = np.where(self.mark_inside(arguments)[:, np.newaxis], value, FORMAT(np.nan))
        return value.reshape(count, *self._code.shape), lost

    def mark_inside(
        self, arguments: Points, arithmetic: Arithmetic = IN_SINGLES, kind: type[Any] = FORMAT
    ) -> Column:
        """Mark the points of the domain, as numbers of some kind decide it."""
        given, count = self._name_values(arguments, kind), len(arguments[0])
        with np.errstate(all="ignore"):
            held = (
                run(self._inside, given, self._add_loops(arithmetic))[0] if self._inside else True
            )
        return np.broadcast_to(held, count)

    def _run_stage(self, stage: Stage, given: Values, count: int) -> tuple[Column, Column]:
        lost = np.zeros(count, bool)
        watched = {kind: partial(_watch, kind, IN_SINGLES[kind], lost) for kind in COMPUTED}
        found = run(flatten_stage(stage, {}), given, self._add_loops(IN_SINGLES.but(**watched)))
        return np.stack([np.broadcast_to(v, count) for v in found], -1), lost

    def _add_loops(self, arithmetic: Arithmetic) -> Arithmetic:
        return arithmetic.but(
            **{r.name: partial(run_loop, r, arithmetic, IN_SINGLES[ADDED]) for r in self._loops}
        )

    def _name_values(self, arguments: Points, kind: type[Any]) -> Values:
        """Give every component its values; the elements of what is summed lie before the points."""
        given: Values = {"#pi": kind(np.pi), "#e": kind(np.e), "#nan": kind(np.nan)}
        for argument, array in zip(self._arguments, arguments, strict=True):
            columns = np.moveaxis(np.asarray(array, kind), 0, -1)
            pairs = zip(argument.components, columns, strict=True) if argument.width else ()
            given |= dict(pairs) or {argument.name: columns}
        return given


def _watch(kind: str, compute: Callable[..., Any], lost: Column, *operands: Any) -> Any:
    """Compute an operation, and mark where its value leaves the range of floats."""
    result = compute(*operands)
    if kind not in ("number", CONSTANT) and np.asarray(result).dtype == FORMAT:
        divisors = operands[1:] if kind == "divide" else ()
        lost |= _hold(np.isfinite, operands) & _hold(np.sign, divisors) & np.isinf(result)
        if kind in SCALING:
            lost |= _hold(np.sign, operands) & (np.abs(result) < SMALLEST)
    return result


def _hold(mark: Callable[[Any], Any], operands: Iterable[Any]) -> Any:
    """Say where a mark is true of all operands."""
    marks = (np.asarray(mark(operand), bool) for operand in operands)
    return reduce(lambda one, other: one & other, marks, np.asarray(True))
