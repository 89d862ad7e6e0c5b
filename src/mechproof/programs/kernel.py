"""Kernel: in, a quantity and the forms of one function; out, its code as programs.

Computations with the parameters alone are separated from those for each point; every backend prints
the same code.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Any

import sympy as sp
from sympy.printing.repr import ReprPrinter

from mechproof.programs.argument_conditions import can_be_left, checked_relations
from mechproof.programs.evaluation import (
    Enclosure,
    Evaluation,
    KeepsShape,
    Solved,
    count_axes,
    entries,
    find_carried,
    input_symbols,
    result_shape,
    start_evaluation,
    trace_inputs,
)
from mechproof.programs.lowering import KNOWN, lower_conditions, lower_steps
from mechproof.programs.program import NOTHING, KernelCode, Stage
from mechproof.programs.rewrites import apply_rewrites
from mechproof.programs.step_names import PUBLIC_IN_MODULES, is_free, share_subexpressions
from mechproof.record import Argument, Form, Paper, Quantity
from mechproof.record.memory import remember_last


@dataclass(frozen=True)
class Kernel:
    """A function to print: its forms, tried in order, and its code.

    `obligations` are, for each form, the relations under which its rewrites are legal; `enclosures`
    are the steps of each form that are computed only to a bound.
    """

    name: str
    quantity: Quantity
    forms: tuple[Form, ...]
    digest: str
    code: KernelCode
    obligations: tuple[tuple[sp.Basic, ...], ...]
    enclosures: tuple[tuple[Enclosure | Solved, ...], ...] = ((),)

    @property
    def is_shipped(self) -> bool:
        """Return whether this is the quantity's own kernel, not a rival."""
        return self.forms == self.quantity.shipped

    @property
    def is_alternative(self) -> bool:
        """Return whether this is a rival of our own that equals the definition unconditionally."""
        said = [(f.source, f.note, f.bound, f.on, f.holds_on) for f in self.forms]
        return not self.is_shipped and not any(map(any, said))


@dataclass(frozen=True)
class Functions:
    """The kernels of a paper and, by name of a quantity without one, the reason and the remedy."""

    kernels: tuple[Kernel, ...]
    refused: Mapping[str, str]


def list_functions(paper: Paper) -> tuple[Kernel, ...]:
    """Build the kernel of every quantity that has forms, each followed by its rivals.

    Raises NotImplementedError if a form uses something that no kernel can compute.
    """
    functions = build_functions(paper)
    for refusal in functions.refused.values():
        raise NotImplementedError(refusal)
    return functions.kernels


@remember_last(8)
def build_functions(paper: Paper) -> Functions:
    """Build the kernel of every quantity that can have one, each followed by its rivals."""
    kernels: list[Kernel] = []
    refused: dict[str, str] = {}
    for quantity in paper.quantities:
        try:
            kernels += _build(quantity, paper)
        except NotImplementedError as error:
            refused[quantity.name] = (
                f"quantity {quantity.name}: {error}; known are powers, Piecewise, Max, Min, "
                f"{KNOWN}: write its forms with these, or leave them out to have no kernel"
            )
    return Functions(tuple(kernels), refused)


def _build(quantity: Quantity, paper: Paper) -> list[Kernel]:
    if not quantity.forms:
        return []
    kernel = build_kernel(quantity.name, quantity, quantity.shipped, paper)
    named = ((name_rival(quantity, form), form) for form in quantity.rivals)
    return [kernel, *(build_kernel(name, quantity, (form,), paper) for name, form in named)]


def name_rival(quantity: Quantity, form: Form) -> str:
    """Return the name of a rival form's function."""
    return f"{quantity.name}_{form.key}"


def evaluate_form(quantity: Quantity, form: Form, paper: Paper) -> Evaluation:
    """Return the evaluation to print: the form's, rewritten, with shared subexpressions named."""
    started = start_evaluation(quantity, form, paper)
    return share_subexpressions(apply_rewrites(started, form.rewrites))


def build_kernel(name: str, quantity: Quantity, forms: tuple[Form, ...], paper: Paper) -> Kernel:
    """Build the code of one function.

    Raises ValueError if the quantity cannot be computed or its domain cannot be checked.
    """
    if not is_free(name, PUBLIC_IN_MODULES) or name.endswith("_"):
        raise ValueError(f"{paper.system}: {name!r} cannot name a kernel")
    checked = checked_relations(quantity, paper)
    evaluations = [
        _carry_nan(evaluate_form(quantity, form, paper), _list_masked(quantity, checked))
        for form in forms
    ]
    used = set().union(*map(_used_symbols, evaluations))
    running = quantity.arguments[0].symbols
    # Conditions on the parameters alone come first: each compares single numbers, the others all
    # points.
    conditions = tuple(sorted(checked, key=lambda r: r.has(*running)))
    names = input_names(quantity)
    affine = len(forms) == 1 and _affine_coefficients(quantity, evaluations[0]) is not None
    vectors = _name_vectors(quantity, used, affine)
    parts = dict(vectors)
    # Names that a condition may use: the arguments, and for vectors their components.
    scalars = tuple(n for a in quantity.arguments for n in parts.get(a.name, (a.name,)))
    if len(forms) > 1 and any(isinstance(s, sp.IndexedBase) for s in evaluations[0].inputs):
        raise ValueError(f"{name}: forms of sums over an axis cannot be chosen by a condition")
    code = KernelCode(
        name=name,
        arguments=tuple(a.name for a in quantity.arguments),
        vectors=vectors,
        indexed=tuple(
            (a.name, count_axes(a, quantity))
            for a in quantity.arguments
            if isinstance(a.symbols[0], sp.IndexedBase)
        ),
        inside=lower_conditions(names, scalars, conditions) if conditions else None,
        masked=tuple(names[s] for s in _list_masked(quantity, checked)),
        stages=tuple(
            _build_stage(quantity, form, evaluation, scalars, vectors)
            for form, evaluation in zip(forms, evaluations, strict=True)
        ),
        shape=result_shape(evaluations[0].output),
        quiet=can_be_left(quantity, paper, conditions)
        # All pieces are computed everywhere and may warn even where another one is taken.
        or any(f.expression.has(sp.Piecewise) for f in forms),
    )
    started = [start_evaluation(quantity, form, paper) for form in forms]
    obligations = tuple(evaluation.obligations for evaluation in evaluations)
    enclosures = tuple(evaluation.enclosures for evaluation in evaluations)
    return Kernel(name, quantity, forms, hash_expressions(started), code, obligations, enclosures)


def _build_stage(
    quantity: Quantity,
    form: Form,
    evaluation: Evaluation,
    scalars: tuple[str, ...],
    vectors: tuple[tuple[str, tuple[str, ...]], ...],
) -> Stage:
    names = input_names(quantity)
    _check_names(quantity, [*names.values(), *(str(s) for s, _ in evaluation.steps)])
    when = lower_conditions(names, scalars, (form.when,)) if form.when is not None else None
    large = _point_sized(quantity, evaluation)
    occurring = _used_symbols(evaluation)
    running, *others = (
        [s for s in argument.symbols if s in occurring] for argument in quantity.arguments
    )
    outputs = entries(evaluation.output)
    if any(isinstance(s, sp.IndexedBase) for s in evaluation.inputs):
        program = lower_steps(names, large, scalars, evaluation.steps, outputs)
        return Stage(when, scalars, (), NOTHING, program)
    parameters = [s for symbols in others for s in symbols]
    given = tuple(names[s] for s in parameters)
    affine = _affine_coefficients(quantity, evaluation)
    if affine is not None:
        prepare = lower_steps(names, large, given, evaluation.steps, affine)
        return Stage(when, dict(vectors)[quantity.arguments[0].name], given, prepare, None)
    before = [step for step in evaluation.steps if given and step[0] not in large]
    after = [step for step in evaluation.steps if step not in before]
    last = [value for _, value in after] + list(outputs)
    wanted = set().union(*(input_symbols(value) for value in last))
    passed = [s for s in (*parameters, *(s for s, _ in before)) if s in wanted]
    prepare = lower_steps(names, large, given, before, passed) if given else NOTHING
    moving = tuple(names[s] for s in running)
    inputs = (*moving, *(names.get(s, str(s)) for s in passed))
    return Stage(when, moving, given, prepare, lower_steps(names, large, inputs, after, outputs))


def input_names(quantity: Quantity) -> Mapping[sp.Basic, str]:
    """Return the inputs' names: a lone symbol has its argument's, components their symbols'."""
    return {
        s: argument.name if len(argument.symbols) == 1 else str(s)
        for argument in quantity.arguments
        for s in argument.symbols
    }


def _used_symbols(evaluation: Evaluation) -> set[sp.Basic]:
    return set().union(*map(input_symbols, evaluation.expressions()))


def _affine_coefficients(quantity: Quantity, evaluation: Evaluation) -> list[sp.Expr] | None:
    """List matrix (row by row) and shift if the outputs are affine in as many components."""
    point, outputs = quantity.arguments[0].symbols, entries(evaluation.output)
    large = _point_sized(quantity, evaluation)
    if not 1 < len(point) == len(outputs) or any(s in large for s, _ in evaluation.steps):
        return None
    matrix = [sp.diff(output, component) for output in outputs for component in point]
    if any(entry.has(*point) for entry in matrix):
        return None
    return matrix + [output.xreplace(dict.fromkeys(point, sp.S.Zero)) for output in outputs]


class _Writer(ReprPrinter):  # type: ignore[misc]
    """SymPy's `srepr`, which keeps the text of each part, as many occur repeatedly."""

    def __init__(self) -> None:
        super().__init__()
        self._known: dict[sp.Basic, str] = {}

    def _print(self, node: Any, **options: Any) -> str:
        if not isinstance(node, sp.Basic):
            return str(super()._print(node, **options))
        if node not in self._known:
            self._known[node] = super()._print(node, **options)
        return self._known[node]


def hash_expressions(evaluations: list[Evaluation]) -> str:
    """Return the SHA-256 of the `srepr` of the steps and outputs before any rewrite."""
    write = _Writer().doprint
    parts = [write(part) for e in evaluations for step in e.steps for part in step]
    parts += [write(e.output) for e in evaluations]
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()


def _check_names(quantity: Quantity, names: list[str]) -> None:
    """Raise ValueError unless every name can be a separate variable in the printed function."""
    taken = {a.name for a in quantity.arguments if len(a.symbols) > 1}
    for name in names:
        if not is_free(name) or name in taken:
            raise ValueError(f"{quantity.name}: {name!r} cannot name a variable of the kernel")
        taken.add(name)


def _point_sized(quantity: Quantity, evaluation: Evaluation) -> frozenset[sp.Basic]:
    """Return the running symbols and the steps computed from them."""
    large = set(quantity.arguments[0].symbols)
    for symbol, value in evaluation.steps:
        if value.has(*large):
            large.add(symbol)
    return frozenset(large)


def _list_masked(quantity: Quantity, conditions: Iterable[sp.Basic]) -> list[sp.Symbol]:
    """List the parameters in the conditions, which are masked outside the domain."""
    met = set().union(*map(input_symbols, conditions))
    return [s for a in quantity.arguments for s in a.symbols if s in met and s.is_Symbol]


def _carry_nan(evaluation: Evaluation, masked: Sequence[sp.Symbol]) -> Evaluation:
    """Make every output NaN where a number it depends on is NaN, and outside the domain.

    If one of the masked parameters is NaN, all of them become NaN, so one suffices.
    """
    steps = dict(evaluation.steps)

    def carry(entry: sp.Expr) -> sp.Expr:
        carried = find_carried(entry, steps, {})
        lost = trace_inputs(entry, steps) - carried - {*masked}
        alongside = [*sorted(lost, key=str), *(masked[-1:] if carried.isdisjoint(masked) else ())]
        return reduce(KeepsShape, alongside, entry)

    return evaluation.convert_output(carry)


def _name_vectors(
    quantity: Quantity, used: set[sp.Basic], affine: bool
) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Return the names of vectors' components: "_" if unused; points of affine maps have items."""
    vectors = []
    for number, argument in enumerate(quantity.arguments):
        if len(argument.symbols) == 1:
            continue
        names = tuple(str(s) if s in used else "_" for s in argument.symbols)
        if affine and number == 0:
            names = tuple(f"{argument.name}[{i}]" for i in range(len(names)))
        vectors.append((argument.name, names))
    return tuple(vectors)


def shape_of(argument: Argument, quantity: Quantity) -> str:
    """Return a text that describes the shape of an argument."""
    if len(argument.symbols) > 1:
        return f"shape (..., {len(argument.symbols)})"
    if isinstance(argument.symbols[0], sp.IndexedBase):
        return f"shape (..., {', '.join('n' * count_axes(argument, quantity))})"
    return "any shape"
