"""Roots of the equations of singular sets and edges: the double nearest to each."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import cache, cached_property, lru_cache
from typing import Any

import numpy as np
import sympy as sp
from flint import arb

from mechproof.arithmetic.ball_evaluation import compile_expression
from mechproof.arithmetic.ball_functions import take_real_part
from mechproof.arithmetic.balls import to_ball, working_precision
from mechproof.kernel_support.order import step_ulps
from mechproof.lab.ways import Array

# The values of each symbol, one for each point.
Columns = Mapping[sp.Symbol, Array]
Wanted = Callable[[Array], Array]
# Precision, in bits: a sign that is still undecided there is taken for a root.
BITS = 320
HALVINGS = 60
# Longer equations are not brought to a common denominator.
SHORT = 60
# Distances from a drawn value, in multiples of its size and to both sides, at which a sign change
# is sought.
REACH = np.concatenate([[0.0], np.logspace(-3, 1, 17)])
# The most doubles that a root may be away from where bisection in doubles puts it.
FARTHEST = 2**44


@dataclass(frozen=True)
class ZeroSet:
    """The points where `gap` is zero; symbols that are not arguments run over the integers."""

    gap: sp.Expr
    text: str

    @cached_property
    def symbols(self) -> set[sp.Basic]:
        """Return the symbols, including integers."""
        return set(self.gap.free_symbols)

    def split(self, arguments: Iterable[sp.Symbol]) -> tuple[list[sp.Symbol], list[sp.Symbol]]:
        """Return the arguments that occur, and all other symbols."""
        own = [s for s in arguments if s in self.symbols]
        return own, sorted(self.symbols - set(own), key=str)


def find_roots(
    place: ZeroSet, symbol: sp.Symbol, values: Columns, within: tuple[float, float], wanted: Wanted
) -> Array:
    """Return the double nearest to a root near each drawn value, NaN if there is none.

    `values` has all arguments and integers of the place; those of `symbol` say where to look.
    `wanted` marks the approximate roots that are worth polishing.
    """
    guesses = _guess(place, symbol, values, within)
    names = sorted(place.symbols - {symbol}, key=str)
    roots = np.full(len(guesses), np.nan)
    for index in np.flatnonzero(np.isfinite(guesses) & wanted(guesses)):
        given = {s: float(values[s][index]) for s in names}
        roots[index] = _polish(place.gap, symbol, given, float(guesses[index]))
    return roots


def find_integers(place: ZeroSet, integer: sp.Symbol, values: Columns) -> Array | None:
    """Return the integers for which the drawn values are nearest to a root; None if not linear."""
    found = solve_linear(place.gap, integer)
    return None if found is None else np.rint(call(found, values))


def _guess(
    place: ZeroSet, symbol: sp.Symbol, values: Columns, within: tuple[float, float]
) -> Array:
    solution = solve_linear(place.gap, symbol)
    with np.errstate(all="ignore"):
        if solution is not None:
            return call(solution, values)
        return _bisect(_as_function(place, symbol, values), values[symbol], within)


@lru_cache(maxsize=256)
def solve_linear(gap: sp.Expr, symbol: sp.Symbol) -> sp.Expr | None:
    """Return the symbol for which the gap is zero; None if its numerator is not linear in it."""
    whole = sp.fraction(sp.together(gap))[0] if sp.count_ops(gap) <= SHORT else gap
    slope = sp.diff(whole, symbol)
    if slope == 0 or slope.has(symbol):
        return None
    return -whole.subs(symbol, 0) / slope


@lru_cache(maxsize=512)
def _compile(expression: sp.Expr) -> tuple[tuple[sp.Symbol, ...], Callable[..., Any]]:
    names = tuple(sorted(expression.free_symbols, key=str))
    return names, sp.lambdify(names, expression, "numpy", cse=True)


def call(expression: sp.Expr, values: Columns) -> Array:
    """Evaluate an expression in doubles, point by point."""
    names, function = _compile(expression)
    shape = np.broadcast(*values.values()).shape
    with np.errstate(all="ignore"):
        result = np.asarray(function(*(values[s] for s in names)), float)
    return result if result.shape == shape else np.broadcast_to(result, shape)


def _as_function(place: ZeroSet, symbol: sp.Symbol, values: Columns) -> Callable[[Array], Array]:
    others = {s: v for s, v in values.items() if s in place.symbols and s != symbol}
    return lambda tried: call(
        place.gap,
        {s: v[:, np.newaxis] if tried.ndim > v.ndim else v for s, v in others.items()}
        | {symbol: tried},
    )


def _bisect(function: Callable[[Array], Array], start: Array, within: tuple[float, float]) -> Array:
    """Return a sign change by bisection, the nearest to each drawn value on a grid around it."""
    size = np.maximum(np.abs(start), 1e-3)[:, np.newaxis]
    grid = start[:, np.newaxis] + size * np.concatenate([-REACH[:0:-1], REACH])
    grid = np.clip(grid, *within) if np.isfinite(within).all() else grid
    signs = np.sign(function(grid))
    changes = signs[:, 1:] * signs[:, :-1] <= 0
    middle = np.abs(np.arange(grid.shape[1] - 1) - REACH.size + 1)
    nearest = np.argmin(np.where(changes, middle, middle.max() + 1), axis=1)
    rows = np.arange(len(start))
    low, high, below = grid[rows, nearest], grid[rows, nearest + 1], signs[rows, nearest]
    for _ in range(HALVINGS):
        centre = low + (high - low) / 2
        before = np.sign(function(centre)) == below
        low, high = np.where(before, centre, low), np.where(before, high, centre)
    return np.where(changes.any(axis=1), high, np.nan)


def _polish(
    gap: sp.Expr, symbol: sp.Symbol, given: Mapping[sp.Symbol, float], guess: float
) -> float:
    """Return the double nearest to a change of sign; the guess itself if none is near."""
    enclose = compile_expression(gap)
    with working_precision(BITS):
        balls = {s: to_ball(value) for s, value in given.items()}

        def sign_of(at: arb) -> int:
            ball = take_real_part(enclose({**balls, symbol: at}))
            return 1 if ball > 0 else -1 if ball < 0 else 0

        @cache
        def sign(steps: int) -> int:
            return sign_of(arb(float(step_ulps(guess, steps))))

        if sign(0) == 0:
            return guess
        reach = 1
        while sign(-reach) * sign(reach) > 0:
            reach *= 8
            if reach > FARTHEST:
                return guess
        least, most = _narrow(sign, reach)
        low, high = (float(step_ulps(guess, steps)) for steps in (least, most))
        return high if sign(least) * sign_of((arb(low) + arb(high)) / 2) > 0 else low


def _narrow(sign: Callable[[int], int], reach: int) -> tuple[int, int]:
    """Halve the steps around a guess until two neighbours are left, or the root itself."""
    least, most = -reach, reach
    while most - least > 1:
        middle = (least + most) // 2
        if sign(middle) * sign(-reach) > 0:
            least = middle
        else:
            most = middle
    return least, most
