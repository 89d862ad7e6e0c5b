"""The oracle: a quantity's definition at exact doubles, decided far below half an ulp; and errors.

The same SymPy expression that the proofs are about is enclosed in a ball, at rising precision until
the ball is small enough. Values that stay undecided are marked, never dropped. Raising the
precision until a result is decided is Ziv's strategy (1991), which Herbie's oracle follows with
intervals.

A result's errors against that truth are ulps, bits, wrong branches, NaN and infinity. Bits are a
logarithm of the error, as in Herbie (Panchekha et al. 2015), which counts the doubles between
result and truth; here ulps of the truth are counted instead, as most doubles lie near zero.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp

from mechproof.arithmetic.balls import evaluate, evaluate_until, working_precision
from mechproof.lab.subject import Subject
from mechproof.lab.ways import Arguments, Array
from mechproof.measured import SetErrors
from mechproof.programs.evaluation import count_axes, entries, result_shape

# 2**-12 ulp of a double: what the ball leaves open cannot be seen in an error of 1e-3 ulp.
DECIDED_BITS = 65
# 1 - cos(1e-300) keeps 65 bits if 2100 are carried; the last steps are for such points only.
PRECISIONS = (128, 256, 512, 1024, 2048, 4096)
# A ball integral at more bits takes seconds; shares below about 1e-50 stay undecided.
PRECISIONS_OF_INTEGRALS = (128, 256)
# The scale of an error is needed to a few digits only.
SCALE_BITS = 30
# A lost value loses every bit of a double.
ALL_BITS = 64.0
EPS = float(np.finfo(float).eps)
# Errors in a summary when no point is decided.
NOTHING = (np.nan, np.nan, np.nan, np.nan, np.nan)


@dataclass(frozen=True)
class Truth:
    """Exact values as two doubles, high + low; shape (points, *trailing axes).

    `scale` is the size that the bound refers to, of shape (points,): NaN where it or the value is
    undecided; None for a quantity without an accuracy bound.
    """

    high: Array
    low: Array
    decided: Array
    scale: Array | None

    def __getitem__(self, chosen: Array) -> Truth:
        scale = None if self.scale is None else self.scale[chosen]
        return Truth(self.high[chosen], self.low[chosen], self.decided[chosen], scale)

    @property
    def undecided(self) -> int:
        """Count the points without a decided value."""
        return int(np.sum(~self.decided))


def find_truth(subject: Subject, arguments: Arguments) -> Truth:
    """Evaluate the definition and the scale of the accuracy bound at every point."""
    definition = subject.exact
    points = list(list_values(subject, arguments))
    pairs = np.array([[*_to_pairs(subject, values)] for values in points])
    pairs = pairs.reshape(len(points), -1, 2)
    high, low = (pairs[..., i].reshape(len(points), *result_shape(definition)) for i in (0, 1))
    decided = np.isfinite(pairs[..., 0]).all(axis=1)
    return Truth(high, low, decided, _find_scale(subject, high, points))


def _find_scale(
    subject: Subject, high: Array, points: list[Mapping[sp.Basic, Any]]
) -> Array | None:
    """Evaluate the scale of the accuracy bound, or the value's own size if it has none."""
    accuracy, given = subject.quantity.accuracy, subject.domain.given
    if accuracy is None:
        return None
    if accuracy.scale is not None:
        scale = accuracy.scale
        named = {**given, **dict(scale.where)}
        return np.array([_to_double(scale.expression, named, values) for values in points])
    size: Array = np.abs(high).reshape(len(points), -1).max(axis=1, initial=0)
    return size


def list_values(subject: Subject, arguments: Arguments) -> Iterator[Mapping[sp.Basic, Any]]:
    """Yield, for each point, the exact values of all symbols of the definition."""
    axes = [_count_own_axes(subject, i) for i in range(len(arguments))]
    count = count_points(subject, arguments)
    shaped = [
        np.broadcast_to(a, (count, *np.shape(a)[np.ndim(a) - n :]))
        for a, n in zip(arguments, axes, strict=True)
    ]
    for index in range(count):
        yield _name_values(subject, [array[index] for array in shaped])


def count_points(subject: Subject, arguments: Arguments) -> int:
    """Return the number of points: the leading axis of the arguments that have one."""
    leading = [
        np.shape(a)[: np.ndim(a) - _count_own_axes(subject, i)] for i, a in enumerate(arguments)
    ]
    return int(np.prod(np.broadcast_shapes(*leading), dtype=int))


def _count_own_axes(subject: Subject, index: int) -> int:
    argument = subject.quantity.arguments[index]
    if isinstance(argument.symbols[0], sp.IndexedBase):
        return int(count_axes(argument, subject.quantity))
    return int(len(argument.symbols) > 1)


def _name_values(subject: Subject, row: list[Array]) -> dict[sp.Basic, Any]:
    values: dict[sp.Basic, Any] = {}
    for argument, value in zip(subject.quantity.arguments, row, strict=True):
        first = argument.symbols[0]
        if isinstance(first, sp.IndexedBase):
            for index in np.ndindex(value.shape):
                values[first[tuple(i + 1 for i in index)]] = float(value[index])
            values |= dict.fromkeys(_counts(subject), value.shape[0])
        else:
            numbers = np.atleast_1d(value).tolist()
            values |= dict(zip(argument.symbols, numbers, strict=True))
    return values


def _counts(subject: Subject) -> set[sp.Basic]:
    """Return the symbols that are the numbers of terms of the definition's sums."""
    sums = subject.quantity.definition.atoms(sp.Sum)
    return {s for total in sums for limit in total.limits for s in limit[2].free_symbols}


def _to_pairs(subject: Subject, values: Mapping[sp.Basic, Any]) -> Iterator[tuple[float, float]]:
    """Yield the entries of the value, each as two doubles.

    Definition and form are equal: if the ball of the definition stays wide, as for a difference of
    equal sines, the ball of a form that is decided counts.
    """
    for index, entry in enumerate(entries(subject.exact)):
        pair = _to_pair(entry, values)
        if not np.isfinite(pair[0]) and _is_defined(entry, values):
            equal = (_to_pair(entries(form)[index], values) for form in subject.equal_forms)
            pair = next((p for p in equal if np.isfinite(p[0])), pair)
        yield pair


def _is_defined(expression: sp.Basic, values: Mapping[sp.Basic, Any]) -> bool:
    if expression.has(sp.Integral) or not np.isfinite([float(v) for v in values.values()]).all():
        return False
    return bool(evaluate(expression, values, PRECISIONS[0]).is_finite())


def _to_pair(expression: sp.Basic, values: Mapping[sp.Basic, Any]) -> tuple[float, float]:
    """Return the value as two doubles, NaN if it is undecided."""
    if not np.isfinite([float(v) for v in values.values()]).all():
        return np.nan, np.nan
    precisions = PRECISIONS_OF_INTEGRALS if expression.has(sp.Integral) else PRECISIONS
    ball = evaluate_until(expression, values, DECIDED_BITS, precisions)
    if not ball.is_finite():
        return np.nan, np.nan
    with working_precision(PRECISIONS[-1]):
        middle = ball.mid()
        high = float(middle)
        return high, float(middle - high)


def _to_double(
    expression: sp.Basic, given: Mapping[sp.Basic, sp.Expr], values: Mapping[sp.Basic, Any]
) -> float:
    """Return the value as a double, NaN if it is undecided.

    Given symbols get balls of their own: if they were substituted, SymPy could not see that the
    argument of |...| is real, and would turn it into a root of a product with its conjugate.
    """
    for bits in PRECISIONS:
        ball = evaluate(expression, give_balls(expression, given, values, bits), bits)
        if ball.is_finite() and (ball.rel_accuracy_bits() >= SCALE_BITS or ball == 0):
            return float(ball)
    return np.nan


def give_balls(
    expression: sp.Basic,
    given: Mapping[sp.Basic, sp.Expr],
    values: Mapping[sp.Basic, Any],
    bits: int,
) -> Mapping[sp.Basic, Any]:
    """Add the balls of the given symbols that an expression needs, directly or through others."""
    for symbol in (expression.free_symbols & given.keys()) - values.keys():
        values = give_balls(given[symbol], given, values, bits)
        values = {**values, symbol: evaluate(given[symbol], values, bits)}
    return values


@dataclass(frozen=True)
class Errors:
    """Errors at each point, shape (points,).

    `absolute` is |result - exact|, its norm for a vector, or its largest entry for a matrix. `ulp`
    is in units in the last place of the exact value (of the vector's norm, of the matrix's largest
    entry). `scaled` is in eps times the scale of the accuracy bound, or as `ulp` without a bound.
    All three are NaN at undecided points, and infinite where the result is NaN or infinite but the
    truth is not.
    """

    absolute: Array
    ulp: Array
    scaled: Array
    result: Array

    @property
    def bits(self) -> Array:
        """Return log2(1 + ulps), at most 64: a lost value loses all bits."""
        bits: Array = np.minimum(np.log2(1 + self.ulp), ALL_BITS)
        return bits


def find_errors(result: Any, truth: Truth) -> Errors:
    """Compare a result with the truth.

    Raises ValueError if their shapes differ.
    """
    result = np.asarray(result)
    if result.shape != truth.high.shape:
        raise ValueError(f"the result has shape {result.shape}, the truth {truth.high.shape}")
    with np.errstate(all="ignore"):
        # The first difference is exact if the result is within a factor of 2 of the truth
        # (Sterbenz 1974), so that errors of a few ulps are not blurred.
        gap = (result.astype(np.float64) - truth.high) - truth.low
        absolute, size = _measure_size(gap), _measure_size(truth.high)
        # An error of at most one subnormal spacing is due to the range of doubles, not to the
        # formula.
        visible = np.where(absolute <= np.finfo(float).smallest_subnormal, 0.0, absolute)
        ulp = visible / np.spacing(size)
        scaled = ulp if truth.scale is None else _scale(visible, truth.scale)
    lost = ~np.isfinite(_measure_size(result.astype(np.float64)))
    lost_all = (np.where(lost, np.inf, e) for e in (absolute, ulp, scaled))
    absolute, ulp, scaled = (np.where(truth.decided, e, np.nan) for e in lost_all)
    return Errors(absolute, ulp, scaled, result)


def _scale(visible: Array, scale: Array) -> Array:
    """Return errors in eps of the scale; infinite for an undecided scale, so that none passes."""
    scaled = np.where(visible == 0, 0.0, visible / (EPS * scale))
    return np.where((visible > 0) & np.isnan(scale), np.inf, scaled)


def _measure_size(values: Array) -> Array:
    """Return |x|, the norm of a vector or the largest entry of a matrix; one number per point."""
    if values.ndim == 1:
        return np.abs(values)
    if values.ndim == 2:
        largest = np.max(np.abs(values), axis=1, initial=0)
        scale = np.where(largest > 0, largest, 1.0)
        size: Array = largest * np.sqrt(np.sum((values / scale[:, None]) ** 2, axis=1))
        return size
    matrix: Array = np.max(np.abs(values), axis=(1, 2))
    return matrix


def count_wrong_branches(errors: Errors, period: float | None) -> int:
    """Return the number of finite results nearer to another branch than to the right one."""
    if period is None:
        return 0
    finite = np.isfinite(errors.absolute)
    return int(np.sum(np.abs(errors.absolute[finite]) > period / 2))


def summarise(
    errors: Errors, truth: Truth, period: float | None = None, name: str = "", way: str = ""
) -> SetErrors:
    """Return the counts and the largest and mean errors of one way on one point set."""
    decided = truth.decided
    if not decided.any():
        return SetErrors(name, way, len(decided), truth.undecided, 0, 0, 0, *NOTHING)
    flat = errors.result.reshape(len(decided), -1)[decided]
    return SetErrors(
        set=name,
        way=way,
        points=len(decided),
        undecided=truth.undecided,
        nan=int(np.isnan(flat).any(axis=1).sum()),
        infinite=int(np.isinf(flat).any(axis=1).sum()),
        wrong_branch=count_wrong_branches(errors, period),
        worst_ulp=float(np.max(errors.ulp[decided])),
        mean_ulp=float(np.mean(errors.ulp[decided])),
        mean_bits=float(np.mean(errors.bits[decided])),
        worst_absolute=float(np.max(errors.absolute[decided])),
        worst_scaled=float(np.max(errors.scaled[decided])),
    )
