"""Evaluation: in, a quantity and its paper; out, named steps and the output computed from them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

import sympy as sp

from mechproof.codegen.error_free import EXACT
from mechproof.record import Argument, Paper, Quantity

Step = tuple[sp.Symbol, sp.Expr]


@dataclass(frozen=True)
class Evaluation:
    """A straight-line program: every step uses inputs and the steps before it."""

    inputs: frozenset[sp.Basic]
    steps: tuple[Step, ...]
    output: sp.Basic

    def new_symbol(self, name: str, steps: Iterable[Step] = ()) -> sp.Symbol:
        """Return a real symbol called `name`, numbered if an input or a step has that name."""
        taken = {str(s) for s in self.inputs} | {str(s) for s, _ in (*self.steps, *steps)}
        return sp.Symbol(unused_name(name, taken), real=True)

    def transform(
        self, convert: Callable[[sp.Expr], sp.Expr], steps: Iterable[Step] = ()
    ) -> Evaluation:
        """Apply `convert` to every expression and add `steps` as they stand.

        `steps` is read last, so that `convert` may still add to it.
        """
        old = [(symbol, convert(value)) for symbol, value in self.steps]
        output = map_entries(convert, self.output)
        return arrange(self.inputs, (*old, *steps), output)

    def expanded(self) -> sp.Basic:
        """Return the output in terms of the inputs, all steps inserted: what a proof compares."""
        values: dict[sp.Symbol, sp.Expr] = {}
        for symbol, value in self.steps:
            values[symbol] = value.xreplace(values)
        return map_entries(lambda e: write_exactly(e.xreplace(values)), self.output)


def write_exactly(expression: sp.Expr) -> sp.Expr:
    """Replace the functions that exist for their rounding by what they are exactly."""
    for function, exact in EXACT.items():
        expression = expression.replace(function, exact)
    return expression


def start_evaluation(quantity: Quantity, paper: Paper) -> Evaluation:
    """Take the form's expression; symbols that the paper defines by others become steps.

    Raises ValueError if the expression has a symbol that is neither argument nor defined,
    or if an argument does not occur.
    """
    inputs = frozenset(s for argument in quantity.arguments for s in argument.symbols)
    given = {v.symbol: v.given for v in paper.variables if v.given is not None}
    steps = [(s, g) for s, g in given.items() if s not in inputs]
    evaluation = arrange(inputs, steps, map_entries(sp.sympify, quantity.form.expression))
    used = input_symbols(evaluation.output).union(
        *(input_symbols(value) for _, value in evaluation.steps)
    )
    known = inputs | {symbol for symbol, _ in evaluation.steps}
    if unknown := sorted(map(str, used - known)):
        raise ValueError(f"{paper.system}.{quantity.name}: symbols without a value: {unknown}")
    if idle := [a.name for a in quantity.arguments if used.isdisjoint(a.symbols)]:
        raise ValueError(f"{paper.system}.{quantity.name}: arguments that do not occur: {idle}")
    return evaluation


def arrange(inputs: frozenset[sp.Basic], steps: Iterable[Step], output: sp.Basic) -> Evaluation:
    """Order the steps as the output needs them and leave out those it does not need."""
    values: Mapping[sp.Symbol, sp.Expr] = dict(steps)
    ordered: dict[sp.Symbol, sp.Expr] = {}

    def visit(expression: sp.Basic) -> None:
        for node in sp.preorder_traversal(expression):
            if node in values and node not in ordered:
                visit(values[node])
                ordered[node] = values[node]

    visit(output)
    return Evaluation(inputs, tuple(ordered.items()), output)


def input_symbols(expression: sp.Basic) -> set[sp.Basic]:
    """Find the symbols and indexed bases an expression needs; bound indices and labels are not."""
    bases: set[sp.Basic] = expression.atoms(sp.IndexedBase)
    labels = {base.label for base in bases}
    indices = {i for item in expression.atoms(sp.Indexed) for i in item.indices}
    counts = {s for total in expression.atoms(sp.Sum) for limit in total.limits for s in limit}
    plain = expression.free_symbols - labels - indices - counts
    return {s for s in plain if isinstance(s, sp.Symbol)} | bases


def count_axes(argument: Argument, quantity: Quantity) -> int:
    """Count the indices with which the form uses an indexed argument."""
    items = quantity.form.expression.atoms(sp.Indexed)
    return next(len(item.indices) for item in items if item.base == argument.symbols[0])


def entries(output: sp.Basic) -> tuple[sp.Expr, ...]:
    """List the entries of a matrix row by row, or the one expression."""
    return tuple(output) if isinstance(output, sp.MatrixBase) else (output,)


def map_entries(convert: Callable[[sp.Expr], sp.Expr], output: sp.Basic) -> sp.Basic:
    """Apply `convert` to every entry."""
    if isinstance(output, sp.MatrixBase):
        return sp.ImmutableDenseMatrix(output.applyfunc(convert))
    return convert(output)


def unused_name(name: str, taken: Iterable[str]) -> str:
    """Return `name`, or name_2, name_3, ... if it is taken."""
    taken = set(taken)
    numbered = (name if i == 1 else f"{name}_{i}" for i in range(1, len(taken) + 2))
    return next(candidate for candidate in numbered if candidate not in taken)
