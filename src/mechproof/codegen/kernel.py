"""Kernel: in, a quantity and its paper; out, the pure data that a template lays out."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from keyword import iskeyword

import sympy as sp

from mechproof.codegen.docstring import describe_kernel, input_names
from mechproof.codegen.domain import domain_relations, parameter_relations
from mechproof.codegen.evaluation import Evaluation, count_axes, entries, start_evaluation
from mechproof.codegen.numpy_printer import NumpyPrinter
from mechproof.codegen.rewrites import apply_rewrites
from mechproof.codegen.subexpressions import count_operations, share_subexpressions
from mechproof.record import Argument, Paper, Quantity

SUPPORT = ("as_floats", "assemble", "split_components", "sum_axes")
RESERVED = frozenset({"Any", "ArrayLike", "np", "inside", *SUPPORT})


@dataclass(frozen=True)
class Vector:
    """An argument with components on its last axis, and their names."""

    argument: str
    components: tuple[str, ...]


@dataclass(frozen=True)
class Indexed:
    """An argument with one or two axes that are summed over."""

    argument: str
    axes: int


@dataclass(frozen=True)
class Kernel:
    """All that is printed of one kernel, as text."""

    name: str
    arguments: tuple[tuple[str, float | None], ...]
    docstring: tuple[str, ...]
    source: str
    form: str
    rewrites: tuple[str, ...]
    digest: str
    operations: int
    vectors: tuple[Vector, ...]
    indexed: tuple[Indexed, ...]
    conditions: tuple[str, ...]
    masked: tuple[str, ...]
    steps: tuple[tuple[str, str], ...]
    outputs: tuple[str, ...]
    shape: tuple[int, ...]
    branches: bool


def evaluate_quantity(quantity: Quantity, paper: Paper) -> Evaluation:
    """Make the evaluation a kernel prints: the form, its rewrites, shared subexpressions."""
    started = start_evaluation(quantity, paper)
    return share_subexpressions(apply_rewrites(started, quantity.form.rewrites))


def build_kernel(quantity: Quantity, paper: Paper) -> Kernel:
    """Evaluate a quantity and print it.

    Raises ValueError where the quantity cannot be computed or its domain cannot be checked.
    """
    evaluation = evaluate_quantity(quantity, paper)
    names = input_names(quantity)
    _check_names(quantity, [*names.values(), *(str(s) for s, _ in evaluation.steps)])
    printer = NumpyPrinter(names, _point_sized(quantity, evaluation))
    conditions = parameter_relations(quantity, paper)
    masked = _choose_masked(quantity, evaluation) if conditions else ()
    output = evaluation.output
    return Kernel(
        name=quantity.name,
        arguments=tuple((a.name, a.default) for a in quantity.arguments),
        docstring=describe_kernel(
            quantity, paper, domain_relations(quantity, paper), conditions, masked
        ),
        source=quantity.source,
        form=quantity.form.name,
        rewrites=quantity.form.rewrites,
        digest=hash_expression(start_evaluation(quantity, paper)),
        operations=count_operations(evaluation),
        vectors=tuple(_vector(a, evaluation) for a in quantity.arguments if len(a.symbols) > 1),
        indexed=tuple(
            Indexed(a.name, count_axes(a, quantity))
            for a in quantity.arguments
            if isinstance(a.symbols[0], sp.IndexedBase)
        ),
        conditions=tuple(map(printer.print_condition, conditions)),
        masked=masked,
        steps=tuple((str(s), printer.print_expression(v)) for s, v in evaluation.steps),
        outputs=tuple(map(printer.print_expression, entries(output))),
        shape=_trailing_shape(output),
        branches=isinstance(output, sp.Piecewise),
    )


def hash_expression(evaluation: Evaluation) -> str:
    """Return the SHA-256 of the `srepr` of the unrewritten steps and output."""
    parts = [sp.srepr(part) for step in evaluation.steps for part in step]
    return hashlib.sha256("\n".join([*parts, sp.srepr(evaluation.output)]).encode()).hexdigest()


def _check_names(quantity: Quantity, names: list[str]) -> None:
    """Require every name to be a variable of its own in the printed function."""
    taken = {a.name for a in quantity.arguments if len(a.symbols) > 1}
    for name in names:
        if not name.isidentifier() or iskeyword(name) or name in RESERVED or name in taken:
            raise ValueError(f"{quantity.name}: {name!r} cannot name a variable of the kernel")
        taken.add(name)


def _point_sized(quantity: Quantity, evaluation: Evaluation) -> frozenset[sp.Basic]:
    """Collect the running variable and the steps computed from it."""
    large = set(quantity.arguments[0].symbols)
    for symbol, value in evaluation.steps:
        if value.has(*large):
            large.add(symbol)
    return frozenset(large)


def _choose_masked(quantity: Quantity, evaluation: Evaluation) -> tuple[str, ...]:
    """Find the fewest parameters, in the order of the arguments, on which every output depends."""
    open_entries = [entry.free_symbols for entry in entries(evaluation.expanded())]
    chosen: list[str] = []
    for argument in quantity.arguments[1:]:
        (symbol, *others) = argument.symbols
        if others or isinstance(symbol, sp.IndexedBase):
            continue
        left = [symbols for symbols in open_entries if symbol not in symbols]
        if len(left) < len(open_entries):
            open_entries = left
            chosen.append(argument.name)
    if open_entries:
        raise ValueError(f"{quantity.name}: no parameter through which an output can become NaN")
    return tuple(chosen)


def _vector(argument: Argument, evaluation: Evaluation) -> Vector:
    used = evaluation.output.free_symbols.union(*(v.free_symbols for _, v in evaluation.steps))
    return Vector(argument.name, tuple(str(s) if s in used else "_" for s in argument.symbols))


def _trailing_shape(output: sp.Basic) -> tuple[int, ...]:
    """Give () for an expression, (n,) for a column, (n, m) for a matrix."""
    if not isinstance(output, sp.MatrixBase):
        return ()
    rows, columns = output.shape
    return (rows,) if columns == 1 else (rows, columns)
