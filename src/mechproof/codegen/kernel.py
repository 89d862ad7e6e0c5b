"""Kernel: in, a quantity and its paper; out, the pure data that a template lays out."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import chain
from keyword import iskeyword
from types import MappingProxyType

import sympy as sp

from mechproof.codegen.docstring import describe_kernel, input_names
from mechproof.codegen.domain import domain_relations, parameter_relations
from mechproof.codegen.evaluation import (
    Evaluation,
    Step,
    count_axes,
    entries,
    input_symbols,
    start_evaluation,
)
from mechproof.codegen.numpy_printer import NumpyPrinter
from mechproof.codegen.rewrites import apply_rewrites
from mechproof.codegen.subexpressions import count_operations, share_subexpressions
from mechproof.record import Argument, Paper, Quantity

SUPPORT: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "arrays": (
            "as_floats",
            "check_components",
            "choose_where",
            "holds",
            "in_blocks",
            "is_finite",
            "nan_outside",
            "split_components",
            "store",
            "sum_axes",
            "transform",
        ),
        "error_free": ("product_rest", "quotient_rest", "small_tangent", "sum_rest"),
        "polynomials": ("small_arctan", "tangent_quotient"),
    }
)
# Constants that functions of the support package take as their last argument.
CONSTANTS: Mapping[str, str] = MappingProxyType(
    {
        "TANGENT": "tan(r/2)/r in powers of r**2",
        "ARCTANGENT": "(atan(y)/y - 1)/y**2 in powers of y**2",
    }
)
RESERVED = frozenset(
    {"Any", "ArrayLike", "NDArray", "np", "inside", "out", *CONSTANTS, *chain(*SUPPORT.values())}
)


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
class Stage:
    """One form in two functions: what the parameters alone decide, and the rest, point by point.

    `when` is the condition on the parameters under which the form is taken, "" for always.
    `prepare` has inputs, steps and results; `evaluate` has inputs, steps and outputs.
    """

    when: str
    suffix: str
    form: str
    rewrites: tuple[str, ...]
    operations: int
    parameters: tuple[str, ...]
    prepare: tuple[tuple[str, str], ...]
    prepared: tuple[str, ...]
    running: tuple[str, ...]
    evaluate: tuple[tuple[str, str], ...]
    outputs: tuple[str, ...]
    affine: bool


@dataclass(frozen=True)
class Kernel:
    """All that is printed of one kernel, as text."""

    name: str
    arguments: tuple[tuple[str, float | None], ...]
    docstring: tuple[str, ...]
    source: str
    digest: str
    vectors: tuple[Vector, ...]
    indexed: tuple[Indexed, ...]
    conditions: tuple[str, ...]
    masked: tuple[str, ...]
    stages: tuple[Stage, ...]
    shape: tuple[int, ...]


def evaluate_quantity(quantity: Quantity, paper: Paper) -> Evaluation:
    """Make the evaluation a kernel prints: the form, its rewrites, shared subexpressions."""
    started = start_evaluation(quantity, paper)
    return share_subexpressions(apply_rewrites(started, quantity.form.rewrites))


def take_shortcut(quantity: Quantity) -> Quantity | None:
    """Return the quantity with its shortcut as the form, None if it has none."""
    return replace(quantity, form=quantity.shortcut.form) if quantity.shortcut else None


def build_kernel(quantity: Quantity, paper: Paper) -> Kernel:
    """Evaluate a quantity and print it.

    Raises ValueError where the quantity cannot be computed or its domain cannot be checked.
    """
    evaluation = evaluate_quantity(quantity, paper)
    conditions = parameter_relations(quantity, paper)
    masked = _choose_masked(quantity, evaluation) if conditions else ()
    printer = NumpyPrinter(input_names(quantity), frozenset())
    shorter = take_shortcut(quantity)
    stages = [build_stage(quantity, evaluation)]
    if shorter and any(isinstance(s, sp.IndexedBase) for s in evaluation.inputs):
        raise ValueError(f"{quantity.name}: a shortcut of sums over an axis is not printed")
    if shorter and quantity.shortcut:
        when = printer.print_expression(quantity.shortcut.when)
        stages.insert(0, build_stage(shorter, evaluate_quantity(shorter, paper), when))
    return Kernel(
        name=quantity.name,
        arguments=tuple((a.name, a.default) for a in quantity.arguments),
        docstring=describe_kernel(
            quantity, paper, domain_relations(quantity, paper), conditions, masked
        ),
        source=quantity.source,
        digest=hash_expression(start_evaluation(quantity, paper)),
        vectors=tuple(_vector(a, evaluation) for a in quantity.arguments if len(a.symbols) > 1),
        indexed=tuple(
            Indexed(a.name, count_axes(a, quantity))
            for a in quantity.arguments
            if isinstance(a.symbols[0], sp.IndexedBase)
        ),
        conditions=tuple(map(printer.print_condition, conditions)),
        masked=masked,
        stages=tuple(stages),
        shape=_trailing_shape(evaluation.output),
    )


def build_stage(quantity: Quantity, evaluation: Evaluation, when: str = "") -> Stage:
    """Divide an evaluation into what the parameters alone decide and the rest, and print both."""
    names = input_names(quantity)
    _check_names(quantity, [*names.values(), *(str(s) for s, _ in evaluation.steps)])
    large = _point_sized(quantity, evaluation)
    printer = NumpyPrinter(names, large)
    occurring = input_symbols(evaluation.output).union(
        *(input_symbols(value) for _, value in evaluation.steps)
    )
    running, *others = (
        [s for s in argument.symbols if s in occurring] for argument in quantity.arguments
    )
    parameters = [s for symbols in others for s in symbols]
    before = [step for step in evaluation.steps if step[0] not in large]
    after = [step for step in evaluation.steps if step[0] in large]
    outputs = entries(evaluation.output)
    affine = _affine_coefficients(quantity, outputs) if not after else None
    last = [value for _, value in after] + list(outputs)
    used = set().union(*(input_symbols(value) for value in last))
    needed = [names.get(s, str(s)) for s in (*parameters, *(s for s, _ in before)) if s in used]
    return Stage(
        when=when,
        suffix="_shortcut" if when else "",
        form=quantity.form.name,
        rewrites=quantity.form.rewrites,
        operations=count_operations(evaluation),
        parameters=tuple(names[s] for s in parameters),
        prepare=_print_steps(before, printer),
        prepared=tuple(map(printer.print_expression, affine) if affine else needed),
        running=tuple(names[s] for s in running),
        evaluate=_print_steps(after, printer),
        outputs=tuple(map(printer.print_expression, outputs)),
        affine=affine is not None,
    )


def _print_steps(steps: list[Step], printer: NumpyPrinter) -> tuple[tuple[str, str], ...]:
    return tuple((str(symbol), printer.print_expression(value)) for symbol, value in steps)


def _affine_coefficients(quantity: Quantity, outputs: tuple[sp.Expr, ...]) -> list[sp.Expr] | None:
    """List the matrix row by row, then the shift, of outputs affine in as many components."""
    point = quantity.arguments[0].symbols
    if not 1 < len(point) == len(outputs):
        return None
    matrix = [sp.diff(output, component) for output in outputs for component in point]
    if any(entry.has(*point) for entry in matrix):
        return None
    return matrix + [output.xreplace(dict.fromkeys(point, sp.S.Zero)) for output in outputs]


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
