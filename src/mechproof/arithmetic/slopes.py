"""Slopes: enclosures of an expression's values and of all its slopes over a box of its symbols.

All slopes come from a single backward run through the layout: reverse mode of automatic
differentiation (Griewank and Walther 2008) in balls, as in the mean value forms of Moore (1966),
except that a kink gives the slopes of both its sides. Only single functions are differentiated
symbolically.
"""

from __future__ import annotations

import itertools
import operator
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache, reduce
from typing import Any

import sympy as sp
from flint import arb

from mechproof.arithmetic.ball_evaluation import compile_expression, plan as plan_balls
from mechproof.arithmetic.balls import NOT_FINITE, working_precision
from mechproof.arithmetic.layout import WHOLE, Given, Layout, Plan, Values
from mechproof.record.relations import KINKED

# Precision in bits, more than that of doubles: the width of slopes should come from boxes, not from
# rounding.
BITS = 96
Balls = list[Any]
# The partial derivatives of functions with a kink, on one side of it and on the other.
SIDES: Mapping[type[sp.Basic], tuple[tuple[int, ...], tuple[int, ...]]] = {
    sp.Max: ((1, 0), (0, 1)),
    sp.Min: ((0, 1), (1, 0)),
    sp.Abs: ((1,), (-1,)),
}


@dataclass(frozen=True, eq=False)
class Dual:
    """A ball and that of its derivative (Clifford 1873); a plain ball counts as constant."""

    value: Any
    rate: Any

    def __add__(self, other: Any) -> Dual:
        value, rate = split(other)
        return Dual(self.value + value, self.rate + rate)

    def __mul__(self, other: Any) -> Dual:
        value, rate = split(other)
        return Dual(self.value * value, self.rate * value + self.value * rate)

    __radd__ = __add__
    __rmul__ = __mul__


def split(ball: Any) -> tuple[Any, Any]:
    """Return a ball's value and its rate, 0 for a plain ball."""
    return (ball.value, ball.rate) if isinstance(ball, Dual) else (ball, 0)


class GradientTape:
    """An expression of symbols, some of which are given by others."""

    def __init__(self, expression: sp.Basic, given: Given) -> None:
        self._expression, self._given = expression, given
        self._layout = Layout(expression, _plan, given)
        with working_precision(BITS):
            self._layout.settle({})

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the expression, as operations cannot be pickled."""
        return GradientTape, (self._expression, dict(self._given))

    @property
    def symbols(self) -> frozenset[sp.Basic]:
        """The symbols that need a value."""
        return self._layout.needs[-1]

    @property
    def is_continuous(self) -> bool:
        """Whether no operation has branches that need not meet, which have no slopes."""
        return not any(
            operands and type(node) not in SIDES and _is_rough(node)
            for node, operands in zip(self._layout.nodes, self._layout.operands, strict=True)
        )

    def evaluate(self, values: Values) -> Any:
        """Return a ball that contains all values of the expression."""
        with working_precision(BITS):
            return self._layout.run(values)[-1]

    def differentiate(
        self, values: Values, symbols: list[sp.Basic]
    ) -> tuple[Any, dict[sp.Basic, Balls]]:
        """Return a ball of all values and, for each symbol, the slopes.

        At a kink inside the box the slope may be anything between those of both sides: by the mean
        value theorem for Lipschitz functions the slope between two points lies in the hull of the
        returned ones.
        """
        with working_precision(BITS):
            balls = self._layout.run(values)
            branches = [self._go_back(p, set(symbols)) for p in self._partials(balls, symbols)]
        return balls[-1], {s: [branch[s] for branch in branches] for s in symbols}

    def bend(self, values: Values, symbol: sp.Basic) -> Any:
        """Return a ball of all second derivatives by a symbol, not finite where there is a kink."""
        with working_precision(BITS):
            balls = self._layout.run({**values, symbol: Dual(values[symbol], arb(1))})
            first, *others = self._partials(balls, [symbol])
            slope = self._go_back(first, {symbol})[symbol]
            return NOT_FINITE if others else split(slope)[1] + arb(0)

    def _partials(self, balls: Balls, symbols: list[sp.Basic]) -> Iterator[list[Balls]]:
        """Yield the partial derivatives of all steps, for every choice of sides at the kinks."""
        wanted, open_kinks = set(symbols), []
        partials: list[Balls] = []
        for slot, node in enumerate(self._layout.nodes):
            operands = self._layout.operands[slot]
            given, used = [balls[k] for k in operands], []
            if not operands or wanted.isdisjoint(self._layout.needs[slot]):
                pass
            elif type(node) in SIDES:
                side = _find_side(given)
                used = list(SIDES[type(node)][side or 0])
                open_kinks += [slot] if side is None else []
            elif not _is_rough(node):
                moved = [not wanted.isdisjoint(self._layout.needs[k]) for k in operands]
                used = _differentiate(node, given, moved)
            partials.append(used)
        for choice in itertools.product((0, 1), repeat=len(open_kinks)):
            for slot, side in zip(open_kinks, choice, strict=True):
                partials[slot] = list(SIDES[type(self._layout.nodes[slot])][side])
            yield partials

    def _go_back(self, partials: list[Balls], wanted: set[sp.Basic]) -> dict[sp.Basic, Any]:
        layout = self._layout
        slopes: list[Any] = [None] * len(layout.nodes)
        slopes[-1] = arb(1)
        for slot in reversed(range(len(slopes))):
            if slopes[slot] is None:
                continue
            for k, partial in zip(layout.operands[slot], partials[slot], strict=False):
                # A zero marks the side of a kink that is not taken: nothing is passed there, as it
                # may be undefined.
                if (isinstance(partial, int) and not partial) or wanted.isdisjoint(layout.needs[k]):
                    continue
                part = slopes[slot] * partial
                slopes[k] = part if slopes[k] is None else slopes[k] + part
        reached = {n: slope for n, slope in zip(layout.nodes, slopes, strict=True) if n in wanted}
        return {s: arb(0) if (slope := reached.get(s)) is None else slope for s in wanted}


def _find_side(given: Balls) -> int | None:
    """Return the index of the greater operand, if shown; for one operand, 1 if it is negative."""
    first, *others = (split(ball)[0] for ball in given)
    difference = first - others[0] if others else first
    return 0 if difference > 0 else 1 if difference < 0 else None


def _plan(node: sp.Basic) -> Plan:
    """Return how to run a node in balls with rates; kinks and bound symbols are special."""
    if isinstance(node, sp.Symbol | sp.Indexed):
        return (lambda values: values[node]), ()
    if type(node) in SIDES:
        return _plan_kink(node)
    if isinstance(node, sp.Add | sp.Mul) or not node.free_symbols:
        return plan_balls(node)
    _, _, arguments = _describe(node)
    return (lambda values, *given: _call(node, list(given))), arguments


def _plan_kink(node: sp.Basic) -> Plan:
    first, *others = node.args
    if len(others) > 1:
        others = [node.func(*others, evaluate=False)]
    operation, _ = plan_balls(node)

    def choose(values: Values, *given: Any) -> Any:
        balls, rates = zip(*map(split, given), strict=True)
        value = operation(values, *balls)
        if not any(isinstance(ball, Dual) for ball in given):
            return value
        # Where the side is not shown the rate does not matter, and either one will do.
        side = SIDES[type(node)][_find_side(list(balls)) or 0]
        return Dual(value, sum(map(operator.mul, side, rates)))

    return choose, (first, *others)


def _call(node: sp.Basic, given: Balls) -> Any:
    expression, dummies, _ = _describe(node)
    return _enclose(expression, dummies, given)


def _enclose(expression: sp.Basic, dummies: tuple[sp.Basic, ...], given: Balls) -> Any:
    """Enclose an expression of dummies, and its rate if any of them has one."""
    balls, rates = zip(*map(split, given), strict=True)
    value = compile_expression(expression)(dict(zip(dummies, balls, strict=True)))
    if not any(isinstance(ball, Dual) for ball in given):
        return value
    slopes = zip(_diff(expression, dummies), rates, strict=True)
    moved = [(slope, rate) for slope, rate in slopes if isinstance(rate, arb)]
    parts = [_enclose(slope, dummies, list(balls)) * rate for slope, rate in moved]
    return Dual(value, reduce(operator.add, parts))


def _differentiate(node: sp.Basic, given: Balls, moved: list[bool]) -> Balls:
    """Return a node's slope by each operand, or 0 for operands that are not to move."""
    if isinstance(node, sp.Add):
        return [1] * len(given)
    if isinstance(node, sp.Mul):
        return _leave_one_out(given)
    expression, dummies, _ = _describe(node)
    slopes = zip(_diff(expression, dummies), moved, strict=True)
    return [_enclose(slope, dummies, given) if wanted else 0 for slope, wanted in slopes]


def _leave_one_out(factors: Balls) -> Balls:
    """Return, for each factor, the product of all others."""
    # Not by division of the product by each factor, as its ball may contain zero.
    before = itertools.accumulate(factors[:-1], operator.mul, initial=1)
    after = [*itertools.accumulate(reversed(factors[1:]), operator.mul, initial=1)]
    return [a * b for a, b in zip(before, reversed(after), strict=True)]


@cache
def _describe(
    node: sp.Basic,
) -> tuple[sp.Basic, tuple[sp.Basic, ...], tuple[sp.Basic, ...]]:
    """Return a node in dummies, the dummies, and the varying parts that these stand for.

    For nodes with bound symbols these are the free symbols, and separately the ends of a sum.
    """
    if isinstance(node, WHOLE):
        return _describe_whole(node)
    varying = [k for k, argument in enumerate(node.args) if argument.free_symbols]
    dummies = tuple(map(_dummy, range(len(varying))))
    arguments = list(node.args)
    for k, dummy in zip(varying, dummies, strict=True):
        arguments[k] = dummy
    return node.func(*arguments), dummies, tuple(node.args[k] for k in varying)


def _describe_whole(
    node: sp.Basic,
) -> tuple[sp.Basic, tuple[sp.Basic, ...], tuple[sp.Basic, ...]]:
    ends: dict[sp.Basic, sp.Basic] = {}
    if not isinstance(node, sp.Piecewise) and len(node.limits) == 1:
        ((bound, *limits),) = node.limits
        ends = {_dummy(k): end for k, end in enumerate(limits) if end.free_symbols}
        names = {end: dummy for dummy, end in ends.items()}
        node = node.func(node.function, (bound, *(names.get(end, end) for end in limits)))
    symbols = tuple(sorted(node.free_symbols, key=str))
    return node, symbols, tuple(ends.get(s, s) for s in symbols)


@cache
def _is_rough(node: sp.Basic) -> bool:
    """Return whether a node has no slopes: kinks under bound symbols have no single side."""
    expression, _, _ = _describe(node)
    return bool(expression.has(*KINKED))


@cache
def _dummy(place: int) -> sp.Symbol:
    return sp.Dummy(f"u{place}", real=True)


@cache
def _diff(expression: sp.Basic, symbols: tuple[sp.Basic, ...]) -> list[sp.Basic]:
    return [sp.diff(expression, symbol) for symbol in symbols]
