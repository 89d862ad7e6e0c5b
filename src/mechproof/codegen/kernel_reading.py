"""Reading of NumPy kernels: what each function of their modules is meant to do.

This is stated in Python and recorded like the emitted source; both records must agree.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import nullcontext
from dataclasses import replace
from functools import partial
from types import MappingProxyType
from typing import Any

from mechproof.codegen.condition_outputs import join_conditions
from mechproof.codegen.source_reading import SourceError, compare, read_functions
from mechproof.programs.kernel import Kernel
from mechproof.programs.program import (
    CHECK,
    KernelCode,
    Program,
    Stage,
    list_suffixes,
    name_functions,
)
from mechproof.programs.trace import RecordedFunction, Tape, Value, show

# Functions that act on axes, with their arguments other than the array, and the operations they
# stand for, with operands.
OF_AXES: Mapping[Any, tuple[Any, ...]] = MappingProxyType(
    {
        ("add_up", ("axis", -1)): ("sum", 1),
        ("add_up", ("axis", (-2, -1))): ("sum", 2),
        ("every", ("axis", -1)): ("every", 1),
        ("every", ("axis", (-2, -1))): ("every", 2),
        ("swapaxes", -1, -2): ("transpose",),
        ("diagonal", ("axis1", -2), ("axis2", -1)): ("diagonal",),
    }
)
# Names that a module defines besides functions; these are not read here.
HELD = frozenset({"__all__", "DOMAIN", "PUBLISHED"})
Meant = Iterator[tuple[str, RecordedFunction]]


def check_module(source: str, kernels: Iterable[Kernel], system: str = "") -> None:
    """Read a module back; raise `SourceError` if a function does not do what is meant."""
    compare(dict(_mean_module(kernels)), read_module(source), system)


def read_module(source: str) -> dict[str, RecordedFunction]:
    """Return the functions of a module by their names, checks with their conditions joined."""
    functions = read_functions(source, _offer)
    (held,) = functions.pop("").ways
    if others := {step.result for step in held.operations} - HELD:
        raise SourceError(f"a module must not contain {min(others)}")
    return {name: _join_conditions(name, function) for name, function in functions.items()}


def _offer(tape: Tape) -> dict[str, Any]:
    """Return the stand-ins for functions that act on axes, and for facts."""

    def act(name: str, value: Value, *last: Any, **named: Any) -> Value:
        given = name, *show(last), *((word, show(axes)) for word, axes in named.items())
        if given not in OF_AXES:
            raise SourceError(f"no operation is written as {given}")
        kind, *numbers = OF_AXES[given]
        return tape.record(kind, value, *numbers)

    facts = dict.fromkeys(("Condition", "Sizes"), lambda *_: None)
    return {name: partial(act, name) for name, *_ in OF_AXES} | facts


def _join_conditions(name: str, function: RecordedFunction) -> RecordedFunction:
    """Return a check's function as if it returned whether all conditions hold; others unchanged."""
    (way, *_) = function.ways
    (outputs,) = way.outputs
    made = {step.result for step in way.operations}
    if not name.startswith(CHECK):
        return function
    if not (isinstance(outputs, tuple) and outputs and made.issuperset(outputs)):
        raise SourceError(f"{name} returns {outputs} instead of conditions")
    joined = join_conditions(replace(way, outputs=outputs))
    return replace(function, ways=(joined, *function.ways[1:]))


def _mean_module(kernels: Iterable[Kernel]) -> Meant:
    """Yield what the functions of a module are meant to do, by name."""
    tape, kernels = Tape(), tuple(kernels)
    names = name_functions(kernel.code for kernel in kernels)
    yield "__dir__", tape.run(lambda: "__all__")
    for kernel in kernels:
        code = kernel.code
        defaults = [a.default for a in kernel.quantity.arguments if a.default is not None]
        does = partial(_run_kernel, tape, code, names)
        inputs = (*code.arguments, "out")
        yield code.name, tape.run(does, inputs, defaults=(*defaults, show(None)))
        yield from ((name, does) for name, does in _mean_helpers(tape, code) if names[name] == name)


def _mean_helpers(tape: Tape, code: KernelCode) -> Meant:
    """Yield what the helper functions of a kernel are meant to do: check, preparation, form."""
    if code.inside:
        asked = replace(code.inside, inputs=(*code.masked, *code.terms))
        yield f"{CHECK}{code.name}", RecordedFunction(asked.inputs, "", (), (asked,))
    for stage, suffix in zip(code.stages, list_suffixes(code), strict=True):
        if stage.prepares:
            prepare = partial(_compute, tape, stage.prepare)
            yield f"_prepare{suffix}", tape.run(prepare, stage.parameters)
        if stage.evaluate and not code.indexed:
            form = partial(_compute, tape, stage.evaluate, one=not code.shape)
            yield f"_form{suffix}", tape.run(form, stage.evaluate.inputs)


def _compute(tape: Tape, program: Program, *_: Value, one: bool = False) -> Any:
    outputs = tape.replay(program)
    return outputs[0] if one else outputs


def _run_kernel(tape: Tape, code: KernelCode, names: Mapping[str, str], *given: Value) -> Any:
    """Perform the operations of a public function on recording values."""
    *arguments, out = given
    axes = {"axes": code.axes} if code.axes else {}
    tape.assign(
        code.arguments,
        tape.record("_as_floats", repr(" ".join(code.arguments)), *arguments, **axes),
    )
    for vector, components in code.vectors:
        if code.stages[0].affine and vector == code.vectors[0][0]:
            tape.record("_check_components", repr(vector), vector, len(components))
        else:
            split = tape.record("_split_components", repr(vector), vector, len(components))
            tape.assign(components, split)
    if code.indexed:
        summed = {name: (name, axes) for name, axes in code.indexed}
        tape.assign(tuple(summed), tape.record("_sum_axes", **summed))
    if code.inside:
        of_sums = {"terms": code.terms} if code.terms else {}
        called = names[f"{CHECK}{code.name}"]
        check = tape.record("_nan_outside", called, *code.masked, **of_sums)
        tape.assign(code.masked, check)
    *stages, last = zip(code.stages, list_suffixes(code), strict=True)
    for stage, suffix in stages:
        assert stage.when is not None
        if tape.record("_holds", *tape.replay(stage.when)):
            return _run_stage(tape, code, names, stage, suffix, out)
    return _run_stage(tape, code, names, *last, out)


def _run_stage(
    tape: Tape, code: KernelCode, names: Mapping[str, str], stage: Stage, suffix: str, out: Value
) -> Value:
    prepared = (names[f"_prepare{suffix}"], stage.parameters) if stage.prepares else ()
    given = {"parameters": stage.parameters} if stage.parameters and not prepared else {}
    named: dict[str, Any] = {**given, "out": out}
    named |= {"shape": code.shape} if code.shape and not stage.affine else {}
    named |= {"quiet": True} if code.quiet else {}
    if code.indexed:
        assert stage.evaluate is not None
        with tape.record("_quietly") if code.quiet else nullcontext():
            return tape.record("_store", *tape.replay(stage.evaluate), out)
    if stage.affine:
        return tape.record("_transform", code.arguments[0], *prepared, **named)
    return tape.record("_in_blocks", names[f"_form{suffix}"], stage.running, *prepared, **named)
