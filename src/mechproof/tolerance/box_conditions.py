"""Where a quantity is defined: sets of single sizes, relations between sizes and the input."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from mechproof.arguments.scalars import require
from mechproof.tolerance.boxes import (
    Box,
    Known,
    common_sign,
    find_widest,
    halve,
    open_symbols,
    put_to_limit,
    to_values,
)
from mechproof.tolerance.sizes import Size

# Boxes to examine for a relation between sizes before it is left to every input.
BUDGET = 200


class BoxCondition:
    """A relation, decided over boxes by balls and, size by size, by the sign of its slope."""

    def __init__(self, relation: Any) -> None:
        from mechproof.arithmetic.slopes import GradientTape
        from mechproof.record.relations import find_slack

        self.relation = relation
        slack = find_slack(relation)
        self.slack = GradientTape(slack.value, {}) if slack else None
        self.strict = slack is not None and slack.strict

    def decide(self, known: Known, box: Box) -> bool | None:
        """Return whether it holds all over the box; False: at some point not; None: unknown."""
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
    """Return relations that hold together where the given one does, |u| <= v as two of u."""
    import sympy as sp

    if isinstance(relation, sp.And):
        return [part for inner in relation.args for part in split(inner)]
    if isinstance(relation, sp.Le | sp.Ge | sp.Lt | sp.Gt) and isinstance(relation.lts, sp.Abs):
        less = sp.Le if isinstance(relation, sp.Le | sp.Ge) else sp.Lt
        (inner,) = relation.lts.args
        return [less(inner, relation.gts), less(-inner, relation.gts)]
    return [relation]


def is_inside(values: Any, number: float) -> bool:
    """Say whether a number lies in the set of a variable."""
    import sympy as sp

    if not math.isfinite(number):
        return False
    exact = Fraction(number)
    inside = values.contains(sp.Rational(exact.numerator, exact.denominator))
    return bool(inside == sp.true)


def check_sets(sizes: Mapping[str, Size], sets: Mapping[str, Any]) -> None:
    """Raise ValueError, naming the size, unless all of it lies in the set of its variable."""
    import sympy as sp

    for name, size in sizes.items():
        values = sets[name]
        whole = isinstance(values, sp.Interval) or values == sp.S.Reals or not size.tolerance
        inside = whole and all(is_inside(values, limit) for limit in size.limits)
        require(inside, f"sizes[{name!r}]", size, f"must lie in {values} with its limits")


def check_relation(
    condition: BoxCondition, sizes: Mapping[str, Size], symbols: Mapping[str, Any]
) -> bool:
    """Return whether the relation is shown for all the sizes within their limits.

    Raises ValueError that names the sizes if it is violated at some of them.
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
            raise ValueError(f"{given}: must satisfy {condition.relation} with all their limits")
        widest = find_widest(part, box)
        if holds is None and widest is None:
            undecided = True
        elif holds is None:
            parts += halve(part, widest)
    return False
