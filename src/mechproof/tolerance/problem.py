"""A derived quantity over its sizes, ready to be bounded, and where it is defined."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from mechproof.arguments.scalars import require
from mechproof.tolerance.sizes import Size, check_sizes
from mechproof.tolerance.subdivision import (
    Box,
    Known,
    Search,
    common_sign,
    find_widest,
    halve,
    open_symbols,
    put_to_limit,
    to_values,
)

if TYPE_CHECKING:
    from mechproof.record import Paper, Quantity
    from mechproof.statement_domains.domain import Domain


# Inputs at which the influence of a size may show.
PROBES = (0.1, -0.1, 1.0, -1.0, 10.0, -10.0)


class Bounds(NamedTuple):
    """Bounds and attained values at one input, the sizes that turn, the boxes examined."""

    lower: float
    lower_attained: float
    upper: float
    upper_attained: float
    turning: frozenset[str]
    boxes: int


class Problem:
    """A quantity, its derivatives and its domain, ready to be enclosed over boxes of sizes."""

    def __init__(self, paper: Paper, name: str, sizes: Mapping[str, Size]) -> None:
        from mechproof.arithmetic.slopes import GradientTape
        from mechproof.statement_domains.domain import Domain

        quantity = _find_quantity(paper, name)
        self.running = quantity.arguments[0].symbols[0]
        self.sizes, self.sized = sizes, _match_symbols(paper, quantity, sizes)
        domain = Domain.of(paper, quantity.on)
        sets = {v.symbol: v.within for v in paper.variables} | dict(domain.within)
        check_sets(sizes, {n: sets[s] for n, s in self.sized.items()})
        self.inputs = sets[self.running]
        chosen = {self.running, *self.sized.values()}
        given = {s: g for s, g in domain.given.items() if s not in chosen}
        free = Domain(domain.within, (), given)
        # Definition and form are equal (an approximation is not used), but their balls are not: the
        # narrower one counts. The form avoids cancellation; the definition has shorter derivatives.
        exact = [quantity.definition]
        exact += [form.expression for form in quantity.shipped[-1:] if form.bound is None]
        self.tapes = [GradientTape(e, given) for e in exact]
        relations = map(free.resolve, paper.list_relations(quantity.on))
        self.conditions = self._collect(relations)
        self._sort_sizes(domain, lambda: free.resolve(exact[-1]))

    def _sort_sizes(self, domain: Domain, write_out: Callable[[], Any]) -> None:
        """Separate the sizes that vary from those that are fixed or have no influence.

        Raises ValueError if branches of the quantity need not meet.
        """
        varying = {n: self.sized[n] for n in check_sizes(self.sizes)}
        tied = set().union(*(c.relation.free_symbols for c in self.conditions))
        if varying and not all(tape.is_continuous for tape in self.tapes):
            raise ValueError("the quantity may jump between its branches; use Max, Min or Abs")
        moving = self._find_moving(list(varying.values()))
        free = {n: s for n, s in varying.items() if s not in tied | moving}
        self.idle = [n for n, s in free.items() if _is_idle(write_out(), s, domain)]
        self.names = {n: s for n, s in varying.items() if n not in self.idle}
        self.limits: Box = {s: self.sizes[n].limits for n, s in self.names.items()}
        self.fixed = {
            s: self.sizes[n].nominal for n, s in self.sized.items() if n not in self.names
        }

    def _find_moving(self, symbols: list[Any]) -> set[Any]:
        """Find sizes that show influence at the nominal ones; proof has to decide the others."""
        nominal = {s: self.sizes[n].nominal for n, s in self.sized.items()}
        moving: set[Any] = set()
        for x in filter(partial(is_inside, self.inputs), PROBES):
            known = {**nominal, self.running: x}
            if all(condition.decide(known, {}) for condition in self.conditions):
                _, slopes = self.tapes[-1].differentiate(to_values(known, {}), symbols)
                moving |= {s for s in symbols if all(b > 0 or b < 0 for b in slopes[s])}
        return moving

    def _collect(self, relations: Iterable[Any]) -> list[BoxCondition]:
        """Return the conditions to decide at every input, after checking those of sizes alone."""
        single = [part for relation in relations for part in split(relation)]
        names = {s: n for n, s in self.sized.items()}
        known = [r for r in single if r.free_symbols <= {self.running, *names}]
        kept = []
        for relation in known:
            condition = BoxCondition(relation)
            symbols = relation.free_symbols
            within = {names[s]: self.sizes[names[s]] for s in symbols - {self.running}}
            if self.running in symbols or not check_relation(condition, within, self.sized):
                kept.append(condition)
        return kept

    def bound(self, x: float, gap: float, budget: int) -> Bounds:
        """Return the bounds at an input."""
        if x != x:
            return Bounds(x, x, x, x, frozenset(), 0)
        if not is_inside(self.inputs, x):
            return Bounds(-np.inf, np.nan, np.inf, np.nan, frozenset(self.names), 0)
        known = {**self.fixed, self.running: x}
        low = Search(self, known, -1).run(gap, budget)
        high = Search(self, known, 1).run(gap, budget)
        turning = {n for n, s in self.names.items() if s in low.turning | high.turning}
        attained = (np.nan if np.isinf(s.attained) else s.attained for s in (low, high))
        lower, upper = (sign * value for sign, value in zip((-1, 1), attained, strict=True))
        boxes = low.boxes + high.boxes
        return Bounds(-low.bound, lower, high.bound, upper, frozenset(turning), boxes)


def _find_quantity(paper: Paper, name: str) -> Quantity:
    found = {q.name: q for q in paper.quantities}
    require(name in found, "quantity", name, f"must be one of {sorted(found)}")
    quantity = found[name]
    require(quantity.is_scalar, "quantity", name, "must be a scalar function of scalars")
    return quantity


def _match_symbols(paper: Paper, quantity: Quantity, sizes: Mapping[str, Size]) -> dict[str, Any]:
    """Return the symbols of the sizes; an argument's name may differ from its symbol's."""
    running, *needed = quantity.arguments
    symbols = {str(v.symbol): v.symbol for v in paper.variables}
    symbols |= {a.name: a.symbols[0] for a in needed}
    allowed = {n: s for n, s in symbols.items() if s != running.symbols[0]}
    missing = sorted({a.name for a in needed} - set(sizes))
    unknown = sorted(set(sizes) - set(allowed))
    needs = f"missing {missing}, unknown {unknown}; needed are {[a.name for a in needed]}"
    require(not (missing or unknown), "sizes", sorted(sizes), needs)
    return {n: allowed[n] for n in sizes}


def _is_idle(value: Any, symbol: Any, domain: Any) -> bool:
    """Return whether the derivative is proved to be identically zero."""
    import sympy as sp

    from mechproof.proof.algebra import decide_equal

    slope = sp.diff(value, symbol)
    return slope == 0 or (
        not slope.has(sp.Heaviside, sp.Max) and decide_equal(slope, sp.S.Zero, domain) is not None
    )


# Boxes to examine for a relation between sizes before it is decided at every input.
BUDGET = 200


class BoxCondition:
    """A relation decided over boxes by balls and, size by size, by the sign of its slope."""

    def __init__(self, relation: Any) -> None:
        from mechproof.arithmetic.slopes import GradientTape
        from mechproof.record.relations import find_slack

        self.relation = relation
        slack = find_slack(relation)
        self.slack = GradientTape(slack.value, {}) if slack else None
        self.strict = slack is not None and slack.strict

    def decide(self, known: Known, box: Box) -> bool | None:
        """Return True if it holds all over the box, False if it fails at some point, else None."""
        if self.slack is None:
            return self._decide_at_point(known, box)
        symbols = open_symbols(box) if self.slack.is_continuous else []
        slack, slopes = self.slack.differentiate(to_values(known, box), symbols)
        if self._is_enough(slack):
            return True
        for symbol in symbols:
            if sign := common_sign(slopes[symbol]):
                box = put_to_limit(box, symbol, upper=sign < 0)
        slack = self.slack.evaluate(to_values(known, box))
        if self._is_enough(slack):
            return True
        return False if (slack <= 0 if self.strict else slack < 0) else None

    def _is_enough(self, slack: Any) -> bool:
        return bool(slack > 0 if self.strict else slack >= 0)

    def _decide_at_point(self, known: Known, box: Box) -> bool | None:
        from mechproof.arithmetic import balls

        if open_symbols(box):
            return None
        return balls.truth(self.relation, {**known, **{s: low for s, (low, _) in box.items()}})


def split(relation: Any) -> list[Any]:
    """Return relations that are jointly equivalent to the given one, such as two for |u| <= v."""
    import sympy as sp

    if isinstance(relation, sp.And):
        return [part for inner in relation.args for part in split(inner)]
    if isinstance(relation, sp.Le | sp.Ge | sp.Lt | sp.Gt) and isinstance(relation.lts, sp.Abs):
        less = sp.Le if isinstance(relation, sp.Le | sp.Ge) else sp.Lt
        (inner,) = relation.lts.args
        return [less(inner, relation.gts), less(-inner, relation.gts)]
    return [relation]


def is_inside(values: Any, number: float) -> bool:
    """Return whether a number lies in the set of a variable."""
    import sympy as sp

    if not math.isfinite(number):
        return False
    exact = Fraction(number)
    inside = values.contains(sp.Rational(exact.numerator, exact.denominator))
    return bool(inside == sp.true)


def check_sets(sizes: Mapping[str, Size], sets: Mapping[str, Any]) -> None:
    """Raise ValueError, naming the size, unless its limits lie in the set of its variable."""
    import sympy as sp

    for name, size in sizes.items():
        values = sets[name]
        whole = isinstance(values, sp.Interval) or values == sp.S.Reals or not size.tolerance
        inside = whole and all(is_inside(values, limit) for limit in size.limits)
        require(inside, f"sizes[{name!r}]", size, f"must lie in {values}, limits included")


def check_relation(
    condition: BoxCondition, sizes: Mapping[str, Size], symbols: Mapping[str, Any]
) -> bool:
    """Return whether the relation is shown for all sizes within their limits.

    Raises ValueError, naming the sizes, if it is violated at some of them.
    """
    box = {symbols[name]: size.limits for name, size in sizes.items()}
    parts, undecided = deque([box]), False
    for _ in range(BUDGET):
        if not parts:
            return not undecided
        part = parts.popleft()
        holds = condition.decide({}, part)
        if holds is False:
            given = ", ".join(f"sizes[{name!r}] = {size}" for name, size in sizes.items())
            raise ValueError(f"{given}: must satisfy {condition.relation} within all limits")
        widest = find_widest(part, box)
        if holds is None and widest is None:
            undecided = True
        elif holds is None:
            parts += halve(part, widest)
    return False
