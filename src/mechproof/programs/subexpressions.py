"""Common subexpressions: in, an evaluation; out, the same with what occurs twice as a step."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from operator import methodcaller

import sympy as sp

from mechproof.programs.evaluation import Evaluation, entries, map_entries
from mechproof.programs.names import suggest_name


def share_subexpressions(evaluation: Evaluation) -> Evaluation:
    """Name every compound subexpression that occurs more than once, largest first.

    Purely structural: sums and products are never regrouped, because a rewrite may have
    chosen their order for accuracy.
    """
    while (repeated := _find_repeated(evaluation)) is not None:
        symbol = evaluation.new_symbol(suggest_name(repeated))
        replace = methodcaller("xreplace", {repeated: symbol})
        evaluation = evaluation.rearrange(
            [(symbol, repeated), *((s, replace(v)) for s, v in evaluation.steps)],
            map_entries(replace, evaluation.output),
        )
    return _merge_steps(evaluation)


def _find_repeated(evaluation: Evaluation) -> sp.Expr | None:
    values = [value for _, value in evaluation.steps] + list(entries(evaluation.output))
    named = {value for _, value in evaluation.steps}
    seen = Counter(node for value in values for node in _worth_naming(value))
    repeated = [node for node, count in seen.items() if count > 1 and node not in named]
    # max keeps the first of equals, and the counter keeps the order of appearance.
    return max(repeated, key=sp.count_ops, default=None)


def _worth_naming(expression: sp.Expr) -> list[sp.Expr]:
    """List compound nodes in order; what lies inside a Sum depends on its index and stays there."""
    if isinstance(expression, sp.Sum):
        return [expression]
    inner = [node for argument in expression.args for node in _worth_naming(argument)]
    return [expression, *inner] if _is_worth_naming(expression) else inner


def _is_worth_naming(expression: sp.Basic) -> bool:
    """Accept sums, products, powers, functions; not -x, 1/x, 2*x, cheap where they stand."""
    if not isinstance(expression, sp.Expr) or expression.is_Atom or not expression.free_symbols:
        return False
    number, rest = expression.as_coeff_Mul()
    if number == -1:
        return False
    return not (rest.is_Atom or (rest.is_Pow and rest.exp == -1 and rest.base.is_Atom))


def _merge_steps(evaluation: Evaluation) -> Evaluation:
    """Use a step wherever its value occurs outside it."""
    names = {value: symbol for symbol, value in evaluation.steps if not value.is_Atom}
    steps = [(symbol, _rebuild(value, names)) for symbol, value in evaluation.steps]
    output = map_entries(lambda e: e.xreplace(names), evaluation.output)
    return evaluation.rearrange(steps, output)


def _rebuild(value: sp.Expr, names: Mapping[sp.Expr, sp.Symbol]) -> sp.Expr:
    if value.is_Atom:
        return value
    return value.func(*(argument.xreplace(names) for argument in value.args))
