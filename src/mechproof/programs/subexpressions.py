"""Common subexpressions: in, an evaluation; out, the same with what occurs twice as a step.

What compilers do to programs (Cocke 1970) is done to expressions here, before an order of rounding
is decided: so proofs, counts and every language see the same steps.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Container, Mapping
from functools import lru_cache, partial

import sympy as sp

from mechproof.programs.evaluation import Evaluation, Step, map_entries
from mechproof.programs.step_names import suggest_name
from mechproof.record.parts import find_free, replace_parts


def share_subexpressions(evaluation: Evaluation) -> Evaluation:
    """Name every compound subexpression that occurs more than once, largest first.

    Purely structural: sums and products are never regrouped, because a rewrite may have
    chosen their order for accuracy.
    """
    shared: list[Step] = []
    for repeated in _list_repeated(evaluation):
        evaluation.add_step(suggest_name(repeated), repeated, shared)
    names = {value: symbol for symbol, value in shared}
    steps = [(symbol, _rebuild(value, names)) for symbol, value in shared]
    steps += [(symbol, replace_parts(value, names)) for symbol, value in evaluation.steps]
    output = map_entries(partial(replace_parts, values=names), evaluation.output)
    return _merge_steps(evaluation.rearrange(steps, output))


def _list_repeated(evaluation: Evaluation) -> list[sp.Expr]:
    """List what is repeated, the largest first."""
    named = {value for _, value in evaluation.steps}
    seen: Counter[sp.Expr] = Counter()
    for value in evaluation.expressions():
        _count(value, seen, named)
    repeated = [node for node, count in seen.items() if count > 1 and node not in named]
    return sorted(repeated, key=_count_operations, reverse=True)


def _count(expression: sp.Expr, seen: Counter[sp.Expr], named: Container[sp.Expr]) -> None:
    """Count compound nodes in order; what lies inside a Sum depends on its index and stays there.

    What lies inside of what repeats is smaller than that, and not counted again.
    """
    if isinstance(expression, sp.Sum) or _is_worth_naming(expression):
        seen[expression] += 1
        if isinstance(expression, sp.Sum) or (seen[expression] > 1 and expression not in named):
            return
    for argument in expression.args:
        _count(argument, seen, named)


@lru_cache(maxsize=1 << 14)
def _count_operations(expression: sp.Expr) -> int:
    return int(sp.count_ops(expression))


@lru_cache(maxsize=1 << 14)
def _is_worth_naming(expression: sp.Basic) -> bool:
    """Accept sums, products, powers, functions; not -x, 1/x, 2*x, cheap where they stand."""
    if not isinstance(expression, sp.Expr) or expression.is_Atom or not find_free(expression):
        return False
    number, rest = expression.as_coeff_Mul()
    if number == -1:
        return False
    return not (rest.is_Atom or (rest.is_Pow and rest.exp == -1 and rest.base.is_Atom))


def _merge_steps(evaluation: Evaluation) -> Evaluation:
    """Use a step wherever its value occurs outside it."""
    names = {value: symbol for symbol, value in evaluation.steps if not value.is_Atom}
    steps = [(symbol, _rebuild(value, names)) for symbol, value in evaluation.steps]
    output = map_entries(partial(replace_parts, values=names), evaluation.output)
    return evaluation.rearrange(steps, output)


def _rebuild(value: sp.Expr, names: Mapping[sp.Expr, sp.Symbol]) -> sp.Expr:
    if value.is_Atom:
        return value
    return value.func(*(replace_parts(argument, names) for argument in value.args))
