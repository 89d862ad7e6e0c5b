"""Expressions as single operations: their values and all their slopes, enclosed over boxes.

The slopes come from one run backwards through the operations, whatever their number. A given
symbol is an operation of its own: nothing is written out, nothing is differentiated but single
functions. SymPy and flint are loaded when called.
"""

from __future__ import annotations

import itertools
import operator
from collections.abc import Callable, Iterator, Mapping
from functools import cache, reduce
from typing import Any, NamedTuple

from mechproof.tolerance.rates import Rated, split

BITS = 96

Balls = list[Any]
Place = Callable[[Any], int]
# By which factor the value goes with each argument, from the arguments and which are wanted.
Partials = Callable[[Balls, list[bool]], Balls]
Sides = tuple[tuple[int, ...], tuple[int, ...]]


class Step(NamedTuple):
    """An operation on earlier steps; a symbol has none."""

    arguments: tuple[int, ...]
    evaluate: Callable[..., Any]
    partials: Partials | None
    # Of Max, Min and Abs: the partials, if the difference has one sign and if the other.
    sides: Sides | None = None


class Program:
    """An expression of symbols, of which some are given by others, as a list of operations."""

    def __init__(self, expression: Any, given: Mapping[Any, Any]) -> None:
        self._expression, self._given = expression, given
        self._slots: dict[Any, int] = {}
        self._steps: list[Step] = []
        self._symbols: dict[int, Any] = {}
        self._end = self._place(expression)
        self._needs: list[frozenset[Any]] = []
        for slot, step in enumerate(self._steps):
            own = {self._symbols[slot]} if slot in self._symbols else set()
            self._needs.append(frozenset(own.union(*(self._needs[k] for k in step.arguments))))

    def __reduce__(self) -> tuple[Any, ...]:
        """Send the expression: operations cannot be sent."""
        return Program, (self._expression, dict(self._given))

    @property
    def symbols(self) -> frozenset[Any]:
        """The symbols that need a value."""
        return self._needs[self._end]

    @property
    def is_continuous(self) -> bool:
        """Whether no operation has branches that need not meet, which have no slopes."""
        return all(s.partials or s.sides or k in self._symbols for k, s in enumerate(self._steps))

    def evaluate(self, values: Mapping[Any, Any]) -> Any:
        """Return a ball that holds all values of the expression."""
        return self._run(values)[self._end]

    def differentiate(
        self, values: Mapping[Any, Any], symbols: list[Any]
    ) -> tuple[Any, dict[Any, Balls]]:
        """Return a ball of all values and, for each symbol, the slopes.

        At a kink that lies in the box the slope may be anything between those of both sides: by
        the mean value theorem of Lipschitz functions the slope between two points lies in the
        hull of the returned ones.
        """
        from mechproof.proof.balls import working_precision

        balls = self._run(values)
        with working_precision(BITS):
            branches = [self._go_back(p, set(symbols)) for p in self._partials(balls, symbols)]
        return balls[self._end], {s: [branch[s] for branch in branches] for s in symbols}

    def bend(self, values: Mapping[Any, Any], symbol: Any) -> Any:
        """Return a ball of all second derivatives by a symbol, not finite where there is a kink."""
        from flint import arb

        from mechproof.proof.balls import NOT_FINITE, working_precision

        balls = self._run({**values, symbol: Rated(values[symbol], arb(1))})
        with working_precision(BITS):
            first, *others = self._partials(balls, [symbol])
            slope = self._go_back(first, {symbol})[symbol]
        return NOT_FINITE if others else split(slope)[1] + arb(0)

    def _run(self, values: Mapping[Any, Any]) -> Balls:
        from mechproof.proof.balls import working_precision

        balls: Balls = []
        with working_precision(BITS):
            for slot, step in enumerate(self._steps):
                known = slot in self._symbols
                ball = values[self._symbols[slot]] if known else _apply(step, balls)
                balls.append(ball)
        return balls

    def _partials(self, balls: Balls, symbols: list[Any]) -> Iterator[list[Balls]]:
        """Yield the partial derivatives of all steps, for every choice of sides at the kinks."""
        wanted, open_kinks = set(symbols), []
        partials: list[Balls] = []
        for slot, step in enumerate(self._steps):
            arguments = [balls[k] for k in step.arguments]
            used: Balls = []
            if step.sides and not wanted.isdisjoint(self._needs[slot]):
                side = _find_side(arguments)
                used = list(step.sides[side or 0])
                open_kinks += [slot] if side is None else []
            elif step.partials and not wanted.isdisjoint(self._needs[slot]):
                moved = [not wanted.isdisjoint(self._needs[k]) for k in step.arguments]
                used = step.partials(arguments, moved)
            partials.append(used)
        for choice in itertools.product((0, 1), repeat=len(open_kinks)):
            for slot, side in zip(open_kinks, choice, strict=True):
                partials[slot] = list((self._steps[slot].sides or ())[side])
            yield partials

    def _go_back(self, partials: list[Balls], wanted: set[Any]) -> dict[Any, Any]:
        from flint import arb

        slopes: list[Any] = [None] * len(self._steps)
        slopes[self._end] = arb(1)
        for slot in reversed(range(len(self._steps))):
            if slopes[slot] is None:
                continue
            for k, partial in zip(self._steps[slot].arguments, partials[slot], strict=False):
                # On the other side of a kink nothing is reached, though it may be undefined.
                if (isinstance(partial, int) and not partial) or wanted.isdisjoint(self._needs[k]):
                    continue
                part = slopes[slot] * partial
                slopes[k] = part if slopes[k] is None else slopes[k] + part
        reached = {s: slopes[slot] for slot, s in self._symbols.items() if s in wanted}
        return {s: arb(0) if (slope := reached.get(s)) is None else slope for s in wanted}

    def _place(self, node: Any) -> int:
        if node not in self._slots:
            inner = self._given.get(node)
            self._slots[node] = self._append(node) if inner is None else self._place(inner)
        return self._slots[node]

    def _append(self, node: Any) -> int:
        step = _make_step(node, self._place, self._given)
        self._steps.append(step)
        if step.evaluate is _refuse_call:
            self._symbols[len(self._steps) - 1] = node
        return len(self._steps) - 1


def _apply(step: Step, balls: Balls) -> Any:
    return step.evaluate(*(balls[k] for k in step.arguments))


def _find_side(arguments: Balls) -> int | None:
    """Return which argument is the greater one (of one: whether it is negative), if shown."""
    first, *others = (split(argument)[0] for argument in arguments)
    difference = first - others[0] if others else first
    return 0 if difference > 0 else 1 if difference < 0 else None


def _make_step(node: Any, place: Place, given: Mapping[Any, Any]) -> Step:
    import sympy as sp

    if not node.free_symbols:
        return _make_constant(node)
    if isinstance(node, sp.Symbol | sp.Indexed):
        return Step((), _refuse_call, None)
    if isinstance(node, sp.Add):
        return Step(tuple(map(place, node.args)), _add, lambda arguments, moved: [1] * len(moved))
    if isinstance(node, sp.Mul):
        return Step(tuple(map(place, node.args)), _multiply, _leave_one_out)
    if isinstance(node, sp.Max | sp.Min | sp.Abs):
        return _make_kink(node, place)
    if isinstance(node, sp.Sum | sp.Integral | sp.Piecewise):
        return _make_whole(node, place, given)
    return _make_function(node, place)


def _make_constant(node: Any) -> Step:
    from mechproof.proof import balls

    ball = balls.evaluate(node, {}, BITS)
    return Step((), lambda: ball, lambda arguments, moved: [])


def _refuse_call() -> None:
    raise AssertionError("a symbol has a value, no operation")


def _add(*balls: Any) -> Any:
    return reduce(operator.add, balls)


def _multiply(*balls: Any) -> Any:
    return reduce(operator.mul, balls)


def _leave_one_out(factors: Balls, moved: list[bool]) -> Balls:
    """Return the products of all factors but one."""
    before = itertools.accumulate(factors[:-1], operator.mul, initial=1)
    after = [*itertools.accumulate(reversed(factors[1:]), operator.mul, initial=1)]
    return [a * b for a, b in zip(before, reversed(after), strict=True)]


def _make_kink(node: Any, place: Place) -> Step:
    import sympy as sp

    first, *others = node.args
    if len(others) > 1:
        others = [node.func(*others, evaluate=False)]
    slots = tuple(place(argument) for argument in (first, *others))
    if isinstance(node, sp.Abs):
        return _make_sided(slots, abs, ((1,), (-1,)))
    if isinstance(node, sp.Max):
        return _make_sided(slots, lambda a, b: a.max(b), ((1, 0), (0, 1)))
    return _make_sided(slots, lambda a, b: a.min(b), ((0, 1), (1, 0)))


def _make_sided(slots: tuple[int, ...], function: Callable[..., Any], sides: Sides) -> Step:
    def evaluate(*arguments: Any) -> Any:
        values, rates = zip(*map(split, arguments), strict=True)
        if not any(isinstance(argument, Rated) for argument in arguments):
            return function(*values)
        # Where the side is not shown, the rate is not asked for.
        side = sides[_find_side(list(values)) or 0]
        return Rated(function(*values), sum(map(operator.mul, side, rates)))

    return Step(slots, evaluate, None, sides)


def _make_function(node: Any, place: Place) -> Step:
    """Make a step of a function of the arguments that vary."""
    varying = [k for k, argument in enumerate(node.args) if argument.free_symbols]
    dummies = [_dummy(k) for k in range(len(varying))]
    arguments = list(node.args)
    for k, dummy in zip(varying, dummies, strict=True):
        arguments[k] = dummy
    slots = tuple(place(node.args[k]) for k in varying)
    return _make_call(node.func(*arguments), dummies, slots)


def _make_whole(node: Any, place: Place, given: Mapping[Any, Any]) -> Step:
    """Make one step of what has bound symbols or branches; the ends of a sum are arguments."""
    import sympy as sp

    from mechproof.proof.domain import Domain

    ends: dict[Any, Any] = {}
    if not isinstance(node, sp.Piecewise) and len(node.limits) == 1:
        ((bound, *limits),) = node.limits
        ends = {_dummy(k): end for k, end in enumerate(limits) if end.free_symbols}
        names = {end: dummy for dummy, end in ends.items()}
        node = node.func(node.function, (bound, *(names.get(end, end) for end in limits)))
    resolved = Domain({}, (), given).resolve(node)
    symbols = sorted(resolved.free_symbols, key=str)
    return _make_call(resolved, symbols, tuple(place(ends.get(s, s)) for s in symbols))


def _make_call(expression: Any, symbols: list[Any], slots: tuple[int, ...]) -> Step:
    import sympy as sp

    def call(inner: Any, arguments: Balls) -> Any:
        from flint import arb

        values, rates = zip(*map(split, arguments), strict=True)
        ball = _call(inner, symbols, values)
        if not any(isinstance(argument, Rated) for argument in arguments):
            return ball
        slopes = zip(_diff(inner, tuple(symbols)), rates, strict=True)
        parts = [
            _call(slope, symbols, values) * rate for slope, rate in slopes if isinstance(rate, arb)
        ]
        return Rated(ball, _add(*parts))

    def partials(arguments: Balls, moved: list[bool]) -> Balls:
        slopes = zip(_diff(expression, tuple(symbols)), moved, strict=True)
        return [call(slope, arguments) if wanted else 0 for slope, wanted in slopes]

    def evaluate(*arguments: Any) -> Any:
        return call(expression, list(arguments))

    # A kink under a bound symbol has no one side.
    rough = (sp.Piecewise, sp.floor, sp.ceiling, sp.sign, sp.Max, sp.Min, sp.Abs)
    return Step(slots, evaluate, None if expression.has(*rough) else partials)


def _call(expression: Any, symbols: list[Any], values: tuple[Any, ...]) -> Any:
    from mechproof.proof import balls

    return balls.evaluate(expression, dict(zip(symbols, values, strict=True)), BITS)


@cache
def _dummy(place: int) -> Any:
    import sympy as sp

    return sp.Dummy(f"u{place}", real=True)


@cache
def _diff(expression: Any, symbols: tuple[Any, ...]) -> list[Any]:
    import sympy as sp

    return [sp.diff(expression, symbol) for symbol in symbols]
