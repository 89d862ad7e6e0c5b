"""Reading of NumPy's kernels: what each function of their modules is meant to do.

It is stated in Python and recorded like the emitted source: both have to do the same.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import nullcontext
from dataclasses import replace
from functools import partial
from types import MappingProxyType
from typing import Any

from mechproof.codegen.conditions import join_conditions
from mechproof.codegen.reading import SourceError, compare, read_functions
from mechproof.programs.code import KernelCode, Stage
from mechproof.programs.kernel import Kernel
from mechproof.programs.program import Program
from mechproof.programs.trace import RecordedFunction, Tape, Value, show

# Functions that act on axes, by what they are given besides an array: the operation, and operands.
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
# How functions of conditions are called.
CHECK = "_check_of_"
# What a module holds besides functions, which is not read here.
HELD = frozenset({"__all__", "DOMAIN", "PUBLISHED"})
Meant = Iterator[tuple[str, RecordedFunction]]


def check_module(source: str, kernels: Iterable[Kernel], system: str = "") -> None:
    """Read a module back; raise `SourceError` where a function does not do what is meant."""
    compare(dict(_mean_module(kernels)), read_module(source), system)


def read_module(source: str) -> dict[str, RecordedFunction]:
    """Return the functions of a module by their names."""
    functions = read_functions(source, _offer)
    (held,) = functions.pop("").ways
    if others := {step.result for step in held.operations} - HELD:
        raise SourceError(f"no module holds {min(others)}")
    return {name: _join_conditions(name, function) for name, function in functions.items()}


def _offer(tape: Tape) -> dict[str, Any]:
    """Return what stands in for functions of axes, and for facts."""

    def act(name: str, value: Value, *last: Any, **named: Any) -> Value:
        given = name, *show(last), *((word, show(axes)) for word, axes in named.items())
        if given not in OF_AXES:
            raise SourceError(f"no operation is written {given}")
        kind, *numbers = OF_AXES[given]
        return tape.record(kind, value, *numbers)

    facts = dict.fromkeys(("Condition", "Sizes"), lambda *_: None)
    return {name: partial(act, name) for name, *_ in OF_AXES} | facts


def _join_conditions(name: str, function: RecordedFunction) -> RecordedFunction:
    """Return the function of a check as if it returned that all conditions hold."""
    (way, *_) = function.ways
    (outputs,) = way.outputs
    made = {step.result for step in way.operations}
    if not name.startswith(CHECK):
        return function
    if not (isinstance(outputs, tuple) and outputs and made.issuperset(outputs)):
        raise SourceError(f"{name} returns {outputs}, no conditions")
    joined = join_conditions(replace(way, outputs=outputs))
    return replace(function, ways=(joined, *function.ways[1:]))


def _mean_module(kernels: Iterable[Kernel]) -> Meant:
    """State what the functions of a module do."""
    tape = Tape()
    yield "__dir__", tape.run(lambda: "__all__")
    for kernel in kernels:
        code = kernel.code
        used = {o for s in code.inside.operations for o in s.operands} if code.inside else ()
        terms = tuple(name for name, _ in code.indexed if name in used)
        defaults = [a.default for a in kernel.quantity.arguments if a.default is not None]
        does = partial(_run_kernel, tape, code, terms)
        inputs = (*code.arguments, "out")
        yield code.name, tape.run(does, inputs, defaults=(*defaults, show(None)))
        if code.inside:
            asked = replace(code.inside, inputs=(*code.masked, *terms))
            yield f"{CHECK}{code.name}", RecordedFunction(asked.inputs, "", (), (asked,))
        for stage, suffix in zip(code.stages, _list_suffixes(code), strict=True):
            if stage.parameters:
                prepare = partial(_compute, tape, stage.prepare)
                yield f"_prepare{suffix}", tape.run(prepare, stage.parameters)
            if stage.evaluate and not code.indexed:
                form = partial(_compute, tape, stage.evaluate, one=not code.shape)
                yield f"_form{suffix}", tape.run(form, stage.evaluate.inputs)


def _list_suffixes(code: KernelCode) -> list[str]:
    """List how the functions of stages are called, the last one like the kernel."""
    others = [f"_{number}_of_{code.name}" for number in range(1, len(code.stages))]
    return [*others, f"_of_{code.name}"]


def _compute(tape: Tape, program: Program, *_: Value, one: bool = False) -> Any:
    outputs = tape.replay(program)
    return outputs[0] if one else outputs


def _run_kernel(tape: Tape, code: KernelCode, terms: tuple[str, ...], *given: Value) -> Any:
    """Do what a public function does."""
    *arguments, out = given
    axes = {"axes": code.axes} if code.axes else {}
    tape.assign(
        code.arguments,
        tape.record("_as_floats", repr(" ".join(code.arguments)), *arguments, **axes),
    )
    for vector, names in code.vectors:
        if code.stages[0].affine and vector == code.vectors[0][0]:
            tape.record("_check_components", repr(vector), vector, len(names))
        else:
            split = tape.record("_split_components", repr(vector), vector, len(names))
            tape.assign(names, split)
    if code.indexed:
        summed = {name: (name, axes) for name, axes in code.indexed}
        tape.assign(tuple(summed), tape.record("_sum_axes", **summed))
    if code.inside:
        of_sums = {"terms": terms} if terms else {}
        check = tape.record("_nan_outside", f"{CHECK}{code.name}", *code.masked, **of_sums)
        tape.assign(code.masked, check)
    *stages, last = zip(code.stages, _list_suffixes(code), strict=True)
    for stage, suffix in stages:
        assert stage.when is not None
        if tape.record("_holds", *tape.replay(stage.when)):
            return _run_stage(tape, code, stage, suffix, out)
    return _run_stage(tape, code, *last, out)


def _run_stage(tape: Tape, code: KernelCode, stage: Stage, suffix: str, out: Value) -> Value:
    prepared = (f"_prepare{suffix}", stage.parameters) if stage.parameters else ()
    named: dict[str, Any] = {"out": out}
    named |= {"shape": code.shape} if code.shape and not stage.affine else {}
    named |= {"quiet": True} if code.quiet else {}
    if code.indexed:
        assert stage.evaluate is not None
        with tape.record("_quietly") if code.quiet else nullcontext():
            return tape.record("_store", *tape.replay(stage.evaluate), out)
    if stage.affine:
        return tape.record("_transform", code.arguments[0], *prepared, **named)
    return tape.record("_in_blocks", f"_form{suffix}", stage.running, *prepared, **named)
