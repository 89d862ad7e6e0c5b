"""Evaluation: in, a quantity and its paper; out, named steps and the output computed from them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import reduce

import sympy as sp

from mechproof.record import Argument, Form, Paper, Quantity
from mechproof.record.implicit import Root
from mechproof.record.parts import find_free, find_parts
from mechproof.record.substitution import write_steps, write_sums_out

Step = tuple[sp.Symbol, sp.Expr]


class KeepsShape(sp.Function):  # type: ignore[misc]
    """A value that takes only shape and NaN from an argument: value + 0*argument."""

    nargs = 2


@dataclass(frozen=True)
class Enclosure:
    """A step within `bound` of `exact` where |symbol| <= limit, and equal to it elsewhere."""

    step: sp.Symbol
    exact: sp.Expr
    symbol: sp.Symbol
    limit: sp.Rational
    bound: sp.Expr

    @property
    def inside(self) -> sp.Basic:
        """Return the condition under which the step may differ from `exact`."""
        return sp.Le(sp.Abs(self.symbol), self.limit)


@dataclass(frozen=True)
class Solved:
    """The iterates of Newton's method, as steps; the last one stands for the root `exact`."""

    exact: Root
    iterates: tuple[sp.Symbol, ...]

    @property
    def step(self) -> sp.Symbol:
        """Return the step that stands for the root."""
        return self.iterates[-1]


@dataclass(frozen=True)
class Evaluation:
    """Named steps, each in terms of inputs and earlier steps, and the output computed from them.

    `obligations` are the relations on the inputs under which the rewrites so far are legal;
    `enclosures` are the steps that are computed only to a bound.
    """

    inputs: frozenset[sp.Basic]
    steps: tuple[Step, ...]
    output: sp.Basic
    obligations: tuple[sp.Basic, ...] = ()
    enclosures: tuple[Enclosure | Solved, ...] = ()

    def enclose(self, enclosures: Iterable[Enclosure | Solved]) -> Evaluation:
        """Return the evaluation with more steps that are computed only to a bound."""
        return replace(self, enclosures=(*self.enclosures, *enclosures))

    def oblige(self, relations: Iterable[sp.Basic]) -> Evaluation:
        """Return the evaluation with more obligations, expressed in the inputs."""
        values = self.step_values()
        added = (relation.xreplace(values) for relation in relations)
        wanted = (r for r in (*self.obligations, *added) if r != sp.true)
        return replace(self, obligations=tuple(dict.fromkeys(wanted)))

    def step_values(self) -> dict[sp.Symbol, sp.Expr]:
        """Return every step in terms of the inputs."""
        values: dict[sp.Symbol, sp.Expr] = {}
        for symbol, value in self.steps:
            values[symbol] = value.xreplace(values)
        return values

    def expressions(self) -> tuple[sp.Expr, ...]:
        """List the values of the steps and the entries of the output."""
        return (*(value for _, value in self.steps), *entries(self.output))

    def new_symbol(self, name: str, steps: Iterable[Step] = ()) -> sp.Symbol:
        """Return a real symbol called `name`, numbered if an input or a step is called so."""
        taken = {str(s) for s in self.inputs} | {str(s) for s, _ in (*self.steps, *steps)}
        return sp.Symbol(unused_name(name, taken), real=True)

    def add_step(self, name: str, value: sp.Expr, steps: list[Step]) -> sp.Symbol:
        """Append a step to `steps` and return its new symbol."""
        symbol = self.new_symbol(name, steps)
        steps.append((symbol, value))
        return symbol

    def transform(
        self, convert: Callable[[sp.Expr], sp.Expr], steps: Iterable[Step] = ()
    ) -> Evaluation:
        """Apply `convert` to every expression and add `steps`, unconverted.

        `steps` is read last, so that `convert` may append to it.
        """
        old = [(symbol, convert(value)) for symbol, value in self.steps]
        output = map_entries(convert, self.output)
        return self.rearrange((*old, *steps), output)

    def convert_parts(
        self,
        is_meant: Callable[[sp.Basic], bool],
        convert: Callable[[sp.Expr], sp.Expr],
        steps: Iterable[Step] = (),
    ) -> Evaluation:
        """Apply `convert` to the parts for which `is_meant` holds, inner first, and add `steps`."""
        return self.transform(lambda value: value.replace(is_meant, convert), steps)

    def convert_output(self, convert: Callable[[sp.Expr], sp.Expr]) -> Evaluation:
        """Apply `convert` to every entry of the output."""
        return self.rearrange(self.steps, map_entries(convert, self.output))

    def list_angles(self, *functions: type[sp.Function]) -> list[sp.Expr]:
        """List the arguments to which any of the functions are applied, in SymPy's order."""
        found = {node.args[0] for e in self.expressions() for node in e.atoms(*functions)}
        return sorted(found, key=sp.default_sort_key)

    def rearrange(self, steps: Iterable[Step], output: sp.Basic) -> Evaluation:
        """Return the evaluation with new steps and a new output, without steps it does not need.

        The steps are ordered as the output needs them.
        """
        values: Mapping[sp.Symbol, sp.Expr] = dict(steps)
        ordered: dict[sp.Symbol, sp.Expr] = {}
        met: set[sp.Basic] = set()

        def visit(node: sp.Basic) -> None:
            if node in met:
                return
            met.add(node)
            if node in values:
                visit(values[node])
                ordered[node] = values[node]
            # Not by SymPy's traversals, which visit the arguments of Max and Min in set order.
            for argument in node.args:
                visit(argument)

        visit(output)
        return replace(self, steps=tuple(ordered.items()), output=output)


def start_evaluation(quantity: Quantity, form: Form, paper: Paper) -> Evaluation:
    """Return the evaluation of a form; symbols that the paper defines by others become steps.

    An argument that does not occur in a rival form contributes only shape and NaN. Raises
    ValueError if the expression has a symbol that is neither an argument nor defined, or if an
    argument does not occur in a form that is no rival.
    """
    inputs = frozenset(s for argument in quantity.arguments for s in argument.symbols)
    steps = [(s, g) for s, g in paper.given.items() if s not in inputs]
    evaluation = arrange(inputs, steps, map_entries(_write_out, form.expression))
    used = input_symbols(evaluation.output).union(
        *(input_symbols(value) for _, value in evaluation.steps)
    )
    where = f"{paper.system}.{quantity.name}, {form.name}"
    known = inputs | {symbol for symbol, _ in evaluation.steps}
    if unknown := sorted(map(str, used - known)):
        raise ValueError(f"{where}: symbols without a value: {unknown}")
    idle = [a for a in quantity.arguments if used.isdisjoint(a.symbols)]
    if idle and form not in quantity.rivals:
        raise ValueError(f"{where}: arguments that do not occur: {[a.name for a in idle]}")
    alongside = [s for argument in idle for s in argument.symbols]
    return _solve(evaluation).convert_output(lambda entry: reduce(KeepsShape, alongside, entry))


def _solve(evaluation: Evaluation) -> Evaluation:
    """Replace implicit roots by the steps of Newton's method."""
    roots = dict.fromkeys(r for e in evaluation.expressions() for r in find_parts(e, Root))
    steps: list[Step] = []
    found: list[Solved] = []
    for root in sorted(roots, key=sp.default_sort_key):
        iterates = [evaluation.add_step("root_0", root.start, steps)]
        for k in range(1, root.steps + 1):
            value = root.step_from(iterates[-1])
            iterates.append(evaluation.add_step(f"root_{k}", value, steps))
        found.append(Solved(root, tuple(iterates)))
    if not found:
        return evaluation
    last = {solved.exact: solved.step for solved in found}
    return evaluation.transform(lambda value: value.xreplace(last), steps).enclose(found)


def _write_out(entry: sp.Expr) -> sp.Expr:
    """Write out the record's step functions and all sums except those over indexed arguments."""
    return write_sums_out(write_steps(sp.sympify(entry)), lambda total: not total.has(sp.Indexed))


def arrange(inputs: frozenset[sp.Basic], steps: Iterable[Step], output: sp.Basic) -> Evaluation:
    """Return an evaluation of the steps that the output needs, in the order it needs them."""
    return Evaluation(inputs, (), output).rearrange(steps, output)


def input_symbols(expression: sp.Basic) -> set[sp.Basic]:
    """Return the symbols and indexed bases of an expression, without indices, bounds and labels."""
    bases: set[sp.Basic] = find_parts(expression, sp.IndexedBase)
    labels = {base.label for base in bases}
    indices = {i for item in find_parts(expression, sp.Indexed) for i in item.indices}
    sums = find_parts(expression, sp.Sum)
    counts = {s for total in sums for limit in total.limits for s in limit}
    plain = find_free(expression) - labels - indices - counts
    return {s for s in plain if isinstance(s, sp.Symbol)} | bases


def trace_inputs(expression: sp.Basic, values: Mapping[sp.Basic, sp.Basic]) -> set[sp.Basic]:
    """Return the symbols without a value that an expression needs, directly or through others."""
    return find_needed(expression, values) - values.keys()


def find_needed(expression: sp.Basic, values: Mapping[sp.Basic, sp.Basic]) -> set[sp.Basic]:
    """Return all symbols that an expression needs, directly or through those with values."""
    found: set[sp.Basic] = set()
    waiting = [expression]
    while waiting:
        met = input_symbols(waiting.pop()) - found
        found |= met
        waiting += [values[symbol] for symbol in met & values.keys()]
    return found


def find_carried(
    expression: sp.Expr,
    values: Mapping[sp.Basic, sp.Basic],
    known: dict[sp.Basic, set[sp.Basic]],
) -> set[sp.Basic]:
    """Return the inputs whose NaN certainly makes an expression NaN; `known` caches those of steps.

    If conditions of pieces compare with a NaN, only the last piece is taken there; otherwise any
    piece may be. Each step is visited once: a Newton step contains the one before several times.
    """
    if isinstance(expression, sp.Piecewise):
        return _find_carried_by_pieces(expression, values, known)
    if isinstance(expression, sp.Pow) and not expression.exp.is_number:
        return set()
    if expression in values:
        if expression not in known:
            known[expression] = find_carried(values[expression], values, known)
        return known[expression]
    if not expression.has(sp.Piecewise, sp.Pow, *values):
        return input_symbols(expression)
    return set().union(*(find_carried(part, values, known) for part in expression.args))


def _find_carried_by_pieces(
    pieces: sp.Piecewise,
    values: Mapping[sp.Basic, sp.Basic],
    known: dict[sp.Basic, set[sp.Basic]],
) -> set[sp.Basic]:
    carried = [find_carried(piece, values, known) for piece, _ in pieces.args if piece != sp.nan]
    always = set.intersection(*carried)
    if any(condition.has(sp.Ne) for _, condition in pieces.args):
        return always
    asked = set().union(*(trace_inputs(condition, values) for _, condition in pieces.args))
    otherwise, last = pieces.args[-1]
    is_nan = last != sp.true or otherwise == sp.nan
    return always | (asked if is_nan else asked & carried[-1])


def count_axes(argument: Argument, quantity: Quantity) -> int:
    """Return the number of indices with which the definition uses an indexed argument."""
    items = quantity.definition.atoms(sp.Indexed)
    return next(len(item.indices) for item in items if item.base == argument.symbols[0])


def entries(output: sp.Basic) -> tuple[sp.Expr, ...]:
    """Return the entries of a matrix row by row, or a tuple of the single expression."""
    return tuple(output) if isinstance(output, sp.MatrixBase) else (output,)


def result_shape(output: sp.Basic) -> tuple[int, ...]:
    """Return the last axes of a result: () for an expression, (n,) for a column, (m, n)."""
    if not isinstance(output, sp.MatrixBase):
        return ()
    rows, columns = output.shape
    return (rows,) if columns == 1 else (rows, columns)


def map_entries(convert: Callable[[sp.Expr], sp.Expr], output: sp.Basic) -> sp.Basic:
    """Return the output with `convert` applied to every entry, or to the single expression."""
    if isinstance(output, sp.MatrixBase):
        return sp.ImmutableDenseMatrix(output.applyfunc(convert))
    return convert(output)


def unused_name(name: str, taken: Iterable[str]) -> str:
    """Return `name`, or name_2, name_3, ... if it is taken."""
    taken = set(taken)
    numbered = (name if i == 1 else f"{name}_{i}" for i in range(1, len(taken) + 2))
    return next(candidate for candidate in numbered if candidate not in taken)
