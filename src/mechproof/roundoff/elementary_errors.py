"""Elementary functions of compiled kernels: in, the programs that are printed; out, their errors.

The proof uses the printed programs themselves. With its decisions resolved a program is rational:
its roundings are bounded as those of kernels are, and its value is compared with the function over
whole intervals. De Dinechin, Lauter and Melquiond (2011) prove functions of CRlibm in this way,
with Gappa and hints for each function.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cache, partial
from types import MappingProxyType
from typing import Any

import numpy as np
from flint import arb

from mechproof.arithmetic.intervals import EPS, ONE, PI, Array, Interval, careful, exactly
from mechproof.programs.elementary.fits import MARGIN, Sides, enclose_pieces
from mechproof.programs.elementary.formats import DOUBLE
from mechproof.programs.elementary.function_programs import build
from mechproof.programs.program import Program
from mechproof.roundoff.bound import ErrorAnalysis
from mechproof.roundoff.compensation import find_scaled
from mechproof.roundoff.error_sums import ErrorScale
from mechproof.roundoff.error_tables import ErrorTable, find_highest
from mechproof.roundoff.interval_monomials import BoxVariables, Rows, split_cases
from mechproof.roundoff.reduction import NEAR, bound_reduction
from mechproof.roundoff.running import IN_BALLS, run
from mechproof.roundoff.specialisation import REST, Case, Resolved, Whole, name_size, resolve
from mechproof.roundoff.steps import EXACT, HALF, Step, StraightLineProgram, keep_needed
from mechproof.roundoff.symmetry import EVEN, ODD, find_parities

# Number of pieces that a quarter turn, or the interval of another function, is divided into.
PIECES = 64
QUARTERS = 4
# Factor by which intervals are extended beyond their ends.
BEYOND = 1 + MARGIN / 2
Series = Any


def _sine(rest: Series, quarters: int) -> Series:
    """Return the sine of a rest plus a number of quarter turns; with one more, it is the cosine."""
    value = rest.cos() if quarters % 2 else rest.sin()
    return -value if quarters % QUARTERS > 1 else value


# For functions of an angle of n quarter turns and a rest r, with a/b the program's last quotient:
# two sides that are equal if a/b is the exact function.
ANGLES: Mapping[str, Callable[[Series, Series, Series, int], tuple[Series, Series]]] = (
    MappingProxyType(
        {
            "tan": lambda a, b, r, n: (a * _sine(r, n + 1), b * _sine(r, n)),
            "sin": lambda a, b, r, n: (a, b * _sine(r, n)),
            "cos": lambda a, b, r, n: (a, b * _sine(r, n + 1)),
        }
    )
)


@cache
def prove(kind: str) -> ErrorTable:
    """Bound the error of a function piece by piece; ValueError if no rule fits its program."""
    return _PROVED[kind](kind)


def _prove_angle(kind: str) -> ErrorTable:
    edges = _list_angles()
    reduced, unreduced = np.zeros(len(edges) - 1), np.full(len(edges) - 1, np.nan)
    for quarters in range(QUARTERS):
        number = Whole(Fraction(QUARTERS), Fraction(quarters))
        found = resolve(build(kind, DOUBLE).program, Case(number))
        # Raises unless the error is the same for the other sign.
        find_parities(found.straight, {REST: ODD})
        places, low, high = _list_rests(edges, quarters)
        straight = _leave_quotient(found.straight)
        off = _enclose_angle(kind, found, quarters, low, high)
        bounds = _put_on(_bound_reduced(replace(found, straight=straight), low, high), off)
        if not quarters:
            unreduced[places] = _put_on(_bound(straight, {REST: None}, low, high), off)
            # Slightly beyond `near` the nearest number of quarter turns may still be zero, so that
            # the angle is not reduced.
            bounds = np.maximum(bounds, unreduced[places])
        reduced[places] = np.maximum(reduced[places], bounds)
    # Up to here the number of quarter turns is zero, whatever the roundings.
    near = float((PI * exactly(0.25)).low) * (1 - MARGIN)
    tables = find_highest(reduced), find_highest(unreduced)
    return ErrorTable(edges, *tables, near=near, largest=DOUBLE.largest)


def _leave_quotient(straight: StraightLineProgram) -> StraightLineProgram:
    """Return the steps with an exact last quotient, if they end in one."""
    *others, last = straight.steps
    if last.kind != "divide":
        return straight
    return replace(straight, steps=(*others, replace(last, ulps=EXACT)))


def _enclose_angle(kind: str, found: Resolved, quarters: int, low: Array, high: Array) -> Array:
    """Bound the approximation error, in eps, of rests in pieces after a number of quarter turns."""
    *_, last = found.straight.steps
    outputs = last.operands if last.kind == "divide" else found.straight.outputs
    plain = keep_needed(replace(found.straight, outputs=outputs))

    def sides(rest: Series) -> tuple[Series, Series]:
        above, *below = run(plain, {REST: rest}, IN_BALLS)
        return ANGLES[kind](above, (*below, arb(1))[0], rest, quarters)

    return _enclose(sides, low, high)


def _enclose(sides: Sides, low: Array, high: Array) -> Array:
    # Functions that may vanish are expanded at zero, so their first pieces must start there.
    start = np.where(low < high - low, 0.0, low)
    pieces = zip(map(arb, start.tolist()), map(arb, high.tolist()), strict=True)
    return np.array(enclose_pieces(sides, pieces)) / EPS


def _list_angles() -> Array:
    quarter = float((PI * exactly(0.5)).high) * BEYOND
    inner = np.linspace(0, quarter, PIECES + 1)[1:-1]
    return np.array([0.0, NEAR, *inner, np.pi / 2 - 2 * NEAR, quarter])


def find_end_of_rests() -> float:
    """Return an upper bound on the size of an angle reduced by quarter turns."""
    return float((PI * exactly(0.25)).high) * BEYOND


def find_end_of_small() -> float:
    """Return an upper bound on the arguments of `small_arctan`."""
    return _find_legal() * BEYOND


def _find_legal() -> float:
    return float(np.nextafter((ONE / exactly(3.0)).sqrt().high, 1.0))


def bound_roundings(straight: StraightLineProgram, high: float) -> float:
    """Bound the roundings of steps, in eps of their value, for one input in [0, high]."""
    edges = np.linspace(0.0, high, PIECES + 1)
    given = dict.fromkeys(straight.inputs)
    return float(np.max(_bound(straight, given, edges[:-1], edges[1:])))


def _list_rests(edges: Array, quarters: int) -> tuple[Rows, Array, Array]:
    """Return the pieces that may need `quarters` quarter turns, and the ends of their rests."""
    least, most = edges[:-1], edges[1:]
    if quarters % 2:
        half = PI * exactly(0.5)
        rests = half - Interval(least, most)
        least, most = np.maximum(rests.low, 0.0), np.maximum(rests.high, -rests.low)
    end = find_end_of_rests()
    (places,) = np.nonzero(least < end)
    return places, least[places], np.minimum(most[places], end)


def _bound_reduced(found: Resolved, low: Array, high: Array) -> Array:
    """Bound the roundings in eps of the value, including those of the reduction of the angle."""
    reduction, bounds = bound_reduction(found.per, found.words), np.empty(len(low))
    for rows, ulps in ((low < NEAR, reduction.near), (low >= NEAR, reduction.far)):
        made = (
            Step("rounded", "copy", ("angle",), HALF),
            Step(REST, "approximate", ("rounded",), ulps),
        )
        straight = replace(found.straight, steps=(*made, *found.straight.steps))
        bounds[rows] = _bound(straight, {"angle": None}, low[rows], high[rows])
    return bounds


def _bound(
    straight: StraightLineProgram, given: Mapping[str, float | None], low: Array, high: Array
) -> Array:
    """Bound the roundings of steps in eps of their value; inputs given as None are in pieces."""

    def compute(rows: Rows, forced: tuple[int, ...]) -> Array:
        variables = BoxVariables([Interval(low[rows], high[rows])], [True], 0, forced)
        monomials = {
            name: variables.variable(0) if value is None else variables.constant(exactly(value))
            for name, value in given.items()
        }
        with careful(moves=False):
            evaluation = ErrorAnalysis(straight, variables, monomials, {}, None)
            return np.broadcast_to(
                evaluation.sum_errors(straight.outputs[0], ErrorScale(None, True)), len(rows)
            )

    return split_cases(compute, len(low))


def _put_on(bounds: Array, off: Array) -> Array:
    """Return bounds on roundings with the approximation error added, all in eps."""
    return (bounds * (1 + off * EPS) + off) * (1 + 4 * EPS)


def _prove_arc(signs: int, reversals: Sequence[bool], kind: str) -> ErrorTable:
    """Bound the error of a quotient's arctangent, or a point's angle, by the size of the quotient.

    The result must change sign with each of the first `signs` arguments; `reversals` lists
    the signs of the second argument to cover: False for positive, True for negative.
    """
    program = build(kind, DOUBLE).program
    _check_signs(program, program.inputs[:signs])
    edges = np.linspace(0.0, 1.0, PIECES + 1)
    flat, steep = (
        np.max(
            [_bound_arc(kind, edges[:-1], edges[1:], Case(None, s, b)) for b in reversals], axis=0
        )
        for s in (False, True)
    )
    # The last piece extends beyond 2, for reciprocals that are rounded to zero.
    places = np.array([*edges, *(2 - edges[-2:0:-1]), 2 * BEYOND])
    return ErrorTable(places, find_highest(np.array([*flat, *steep[::-1]])))


def _check_signs(program: Program, arguments: Sequence[str]) -> None:
    """Raise ValueError unless the result changes sign with each of the arguments."""
    for turned in arguments:
        parities = find_parities(program, {n: ODD if n == turned else EVEN for n in program.inputs})
        if any(parities[str(output)] == EVEN for output in program.outputs):
            raise ValueError(f"the result does not change its sign with {turned}")


def _bound_arc(kind: str, low: Array, high: Array, case: Case) -> Array:
    """Bound the error of angles whose quotient, or its reciprocal, is in pieces of [0, 1]."""
    program = build(kind, DOUBLE).program
    found = resolve(program, case)
    one, other = map(name_size, program.inputs)
    # One size can be taken to be 1, as only the quotient of the two sizes matters.
    sizes = (Step(name, "copy", (1.0,), EXACT, scaled="size") for name in (one, other))
    scaled = find_scaled(replace(found.straight, steps=(*sizes, *found.straight.steps))).scaled
    straight = replace(found.straight, scaled=scaled)
    above, below = (other, one) if case.is_larger else (one, other)
    quarters = 1 if case.is_larger else 2 * case.is_left
    is_backward = case.is_larger != case.is_left

    def sides(w: Series) -> tuple[Series, Series]:
        (value,) = run(found.straight, {above: w, below: arb(1)}, IN_BALLS)
        start = arb.pi() * quarters / 2
        return value, start - w.atan() if is_backward else start + w.atan()

    bounds = _bound(straight, {above: None, below: 1.0}, low, high)
    return _put_on(bounds, _enclose(sides, low, high))


def _prove_small(kind: str) -> ErrorTable:
    """Bound the error of the arctangent of arguments meant to be at most 1/sqrt(3)."""
    (name,) = build(kind, DOUBLE).program.inputs
    found = resolve(build(kind, DOUBLE).program, Case())
    find_parities(found.straight, {name: ODD})
    legal = _find_legal()
    end = find_end_of_small()

    def sides(y: Series) -> tuple[Series, Series]:
        (value,) = run(found.straight, {name: y}, IN_BALLS)
        return value, y.atan()

    edges = np.linspace(0.0, end, PIECES + 1)
    off = _enclose(sides, edges[:-1], edges[1:])
    bounds = _put_on(_bound(found.straight, {name: None}, edges[:-1], edges[1:]), off)
    return ErrorTable(edges, find_highest(bounds), legal=legal)


_PROVED: Mapping[str, Callable[[str], ErrorTable]] = MappingProxyType(
    {
        **dict.fromkeys(ANGLES, _prove_angle),
        "arctan_quotient": partial(_prove_arc, 2, (False,)),
        # For points other than the origin.
        "arctan2": partial(_prove_arc, 1, (False, True)),
        "small_arctan": _prove_small,
    }
)
