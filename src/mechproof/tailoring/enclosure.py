"""Enclosure: in, a model and the exact function; out, a proved bound on the error of its program.

Over cells of the reduced variable, the difference between program and definition is a Taylor
polynomial with remainder, in balls. The rounding errors of the program, of the reduction before it
and of the sum after it are added. For the approximation alone, this is the certified supremum norm
of Sollya (Chevillard et al. 2011).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from itertools import pairwise

from flint import arb, arb_series

from mechproof.arithmetic.balls import Ball
from mechproof.arithmetic.series import Series, is_finite, list_terms, working
from mechproof.programs.elementary.fits import bound_terms
from mechproof.programs.program import Program
from mechproof.tailoring.model import (
    LEAST,
    UNIT,
    Model,
    PeriodReduction,
    TaylorModel,
    UndecidedError,
    start,
    track,
)

Exact = Callable[[Series], Series]
ORDER = 14
# A cell is cut while its bound exceeds the error met at points by this factor, and this share of
# the limit.
WIDE, SMALL = 1.05, 0.1
# Shares of the range: cells in which rounding errors are no longer overestimated, and the
# narrowest.
NARROW, NARROWEST = 2.0**-9, 2.0**-48
# Share of the values: a function that the narrowest cell cannot enclose closer jumps there.
JUMP = 2.0**-30
SAMPLES = 16
# A cell must be narrow enough for one swing of the error of a polynomial with its coefficients.
SWINGS = 2


class ExceededError(ArithmeticError):
    """Raised if the error exceeds the limit somewhere."""


class BreakError(ArithmeticError):
    """Raised if the definition cannot be enclosed about a point: it jumps or is undefined there."""

    def __init__(self, place: float) -> None:
        super().__init__(place)
        self.place = place


@dataclass(frozen=True)
class Bound:
    """A bound on the whole error; no polynomial can reduce `roundings`."""

    error: float
    roundings: float


@dataclass(frozen=True)
class Repetition:
    """A period, and the gain over it divided by it, in balls."""

    period: Ball
    rate: Ball


@dataclass
class _Worst:
    """The largest over cells: bound, error surely attained, rounding error, slope and value."""

    bound: Ball
    met: Ball
    off: Ball
    slope: Ball
    size: Ball

    def join(self, other: _Worst) -> None:
        """Include another cell."""
        for name in ("bound", "met", "off", "slope", "size"):
            setattr(self, name, getattr(self, name).max(getattr(other, name)))


def enclose(model: Model, exact: Exact, repetition: Repetition | None, limit: float) -> Bound:
    """Bound the error of a model's program.

    `exact` is the definition less the gain, as a series. Raises `ExceededError` if the bound
    exceeds the limit.
    """
    with working(ORDER):
        if model.reduction is None or repetition is None:
            worst = _enclose_part(model, exact, (model.low, model.high), arb(limit), arb(0))
            return _finish(worst, arb(0), limit)
        farthest = arb(max(-model.low, model.high))
        reach, off = _bound_reduction(model.reduction, repetition, farthest)
        after = _bound_sum(model.reduction, repetition, farthest)
        rest = arb(limit) - after
        if not rest > 0:
            raise ExceededError(float(after.upper()))
        worst = _enclose_part(model, exact, (-reach, reach), rest, off)
        if model.reduction.rate:
            # The sum also rounds what the polynomials add to it.
            after += UNIT * worst.size
        return _finish(worst, after + worst.slope * off, limit)


def _finish(worst: _Worst, outside: Ball, limit: float) -> Bound:
    bound = Bound(float((worst.bound + outside).upper()), float((worst.off + outside).upper()))
    if not bound.error <= limit:
        raise ExceededError(bound.error)
    return bound


def bound_outside(
    reduction: PeriodReduction, repetition: Repetition, farthest: float, slope: float
) -> float:
    """Bound the errors of the reduction and the final sum; they grow with the range."""
    with working(1):
        _, off = _bound_reduction(reduction, repetition, arb(farthest))
        after = _bound_sum(reduction, repetition, arb(farthest))
        return float((after + slope * off).upper())


def _bound_reduction(
    reduction: PeriodReduction, repetition: Repetition, point: Ball
) -> tuple[float, Ball]:
    """Bound the remainder of the reduction and its error."""
    turns = point * reduction.per_period
    # The rounded count is off by its factor's error and, without fma, by a rounding.
    share = arb(0.5) + abs(point / repetition.period - turns) + UNIT * turns + LEAST
    count = turns + 2 * share
    rest = share * repetition.period
    left, off = repetition.period, arb(0)
    for word in reduction.words:
        left -= arb(word)
        # A product with a word short enough for the result to be a double is exact.
        product = arb(0) if _is_short(word, count) else abs(arb(word)) * count * UNIT
        result = rest + abs(left) * count + off + product
        off += product + UNIT * result + LEAST
    off += abs(left) * count
    reach = float((rest + off).upper()) * (1 + 2.0**-50)
    return reach, off.upper()


def _is_short(word: float, count: Ball) -> bool:
    """Return whether whole multiples, up to `count`, of a word are doubles."""
    above, _ = word.as_integer_ratio()
    odd = above // (above & -above)
    return bool(count * odd < arb(2) ** 53)


def _bound_sum(reduction: PeriodReduction, repetition: Repetition, point: Ball) -> Ball:
    """Bound the error of rate*point + value, except what the value adds to the last rounding."""
    product = abs(arb(reduction.rate)) * point
    return (
        abs(arb(reduction.rate) - repetition.rate) * point + 2 * UNIT * product * (1 + UNIT)
    ).upper()


def _enclose_part(
    model: Model, exact: Exact, ends: tuple[float, float], limit: Ball, off: Ball
) -> _Worst:
    """Bound the error of the polynomials between the ends, at a point with the error `off`."""
    program = model.part()
    terms = max(len(p.coefficients) for p in model.pieces.pieces)
    cells = sorted(_list_cells(model, ends, SWINGS * terms), key=lambda cell: -abs(sum(cell)))
    narrow, narrowest = ((ends[1] - ends[0]) * share for share in (NARROW, NARROWEST))
    worst = _Worst(*[arb(0)] * 5)
    while cells:
        low, high = cells.pop()
        found = _enclose_cell(program, exact, low, high)
        middle = low + (high - low) / 2
        is_last = high - low <= narrowest or middle in (low, high)
        if found is None:
            if is_last:
                raise BreakError(middle)
            cells += [(low, middle), (middle, high)]
            continue
        rest = limit - found.slope * off if off != 0 else limit
        too_much = found.met.max(found.off) if high - low <= narrow else found.met
        if too_much > rest:
            raise ExceededError(float(too_much))
        worst.met = worst.met.max(found.met)
        # What remains at the middle, with rounding errors, however finely the cell is cut.
        least = found.met + 2 * found.off
        enough = rest if is_last else (WIDE * worst.met.max(least)).max(SMALL * limit).min(rest)
        if found.bound <= enough:
            worst.join(found)
        elif not is_last:
            cells += [(low, middle), (middle, high)]
        elif found.bound <= JUMP * _sample(exact, ends):
            raise ExceededError(float(found.bound))
        else:
            raise BreakError(middle)
    return worst


def seek_break(exact: Exact, low: float, high: float) -> None:
    """Raise `BreakError` if a definition jumps or is undefined between the ends."""
    with working(ORDER):
        narrowest, jump = (high - low) * NARROWEST, JUMP * _sample(exact, (low, high))
        cells = [(low, high)]
        while cells:
            low, high = cells.pop()
            value, *slopes = list_terms(exact(start(low, high).whole))
            middle = low + (high - low) / 2
            if is_finite([value, *slopes]):
                continue
            if high - low > narrowest and middle not in (low, high):
                cells += [(middle, high), (low, middle)]
            elif not value.rad() <= jump:
                raise BreakError(middle)


def _sample(exact: Exact, ends: tuple[float, float]) -> Ball:
    """Return the largest absolute value of a function at some samples."""
    points = (ends[0] + (ends[1] - ends[0]) * i / SAMPLES for i in range(1, SAMPLES))
    sizes = (abs(list_terms(exact(arb_series([arb(point)])))[0]) for point in points)
    return max(sizes, key=lambda size: float(size.mid()))


def _list_cells(
    model: Model, ends: tuple[float, float], count: int
) -> Iterable[tuple[float, float]]:
    """Yield `count` cells in each interval between the edges of pieces, in both signs."""
    edges = {*ends, 0.0, *model.pieces.edges, *(-e for e in model.pieces.edges)}
    for low, high in pairwise(sorted(e for e in edges if ends[0] <= e <= ends[1])):
        step = (high - low) / count
        corners = [low, *(low + i * step for i in range(1, count)), high]
        yield from pairwise(corners)


def _enclose_cell(program: Program, exact: Exact, low: float, high: float) -> _Worst | None:
    """Bound the error on a cell; None if a comparison or the definition is undecided."""
    try:
        found = track(program, low, high)
    except UndecidedError:
        return None
    point = start(low, high)
    true = TaylorModel(exact(point.middle), exact(point.whole), arb(0))
    near, far = found.middle - true.middle, found.whole - true.whole
    terms = bound_terms(near, far)
    whole = list_terms(far)
    slope = abs(list_terms(true.whole)[1]) / ((arb(high) - low) / 2)
    # Every term over the whole cell counts: an undefined function may leave the last one zero.
    if is_finite([*terms, *whole]):
        bound = sum(terms, arb(0)).upper()
        met = terms[0].lower() - found.off
    else:
        # A corner lies within the cell: use the values alone.
        bound, met = abs(whole[0]).upper(), arb(0)
        slope = arb("inf")
    if not bound.is_finite():
        return None
    return _Worst(bound + found.off, met, found.off, slope.upper(), found.largest)
