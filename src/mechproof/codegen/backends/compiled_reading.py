"""Reading of compiled modules: what each of their functions is meant to do.

This is stated in Python and recorded like the emitted source; both records must agree.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from typing import Any

from mechproof.codegen.backends.loopless_kernels import mean_term
from mechproof.codegen.backends.scalar_texts import LoopCall, ScalarKernel, is_limited
from mechproof.codegen.languages import EXACT, NUMBA, NUMBA_FAR
from mechproof.codegen.source_reading import Module, read_functions
from mechproof.programs.elementary.formats import DOUBLE
from mechproof.programs.elementary.function_programs import BODIES, build
from mechproof.programs.kernel import Kernel
from mechproof.programs.program import Program
from mechproof.programs.scalar import ADDED, TermLoop, join_stage, list_conditions, list_stages
from mechproof.programs.trace import RecordedFunction, Tape, Value, show

SCALAR, LOOP = "_scalar", "_loop"
Meant = Iterator[tuple[str, RecordedFunction]]


def read_compiled(source: str) -> dict[str, RecordedFunction]:
    """Return the functions of a compiled module by their names."""
    return read_functions(source, _offer)


def _offer(on: Tape) -> dict[str, Any]:
    """Return stand-ins for types and decorators, and for functions named like an operation."""
    return {
        "every": partial(on.record, "_every"),
        **{name: partial(on.record, name) for name in ("element", "float64", "type")},
        **{name: on.value(name) for name in ("float", "ndarray")},
        "scalar": lambda function: (SCALAR, function),
        "loop": lambda function: (LOOP, function),
        "point_of": lambda public, **told: (
            lambda function: (_name_point(show(public), **told), function)
        ),
        "elementary": Module(on, "mechproof.kernels.compiled.elementary", {}),
    }


def _name_point(public: str, spread: object = False) -> str:
    return f"_point_of({public}{', spread' if spread is True else ''})"


def mean_elementary() -> Meant:
    """Yield what the functions of the module of elementary functions are meant to do."""
    on = Tape()
    yield "", on.run(partial(_hold, on, BODIES, _LARGEST=DOUBLE.largest))
    for kind, (_, inputs, far) in BODIES.items():
        does = partial(_compute_elementary, on, kind)
        yield kind, on.run(does, (*inputs, *([EXACT] if far else [])), SCALAR)


def _hold(on: Tape, public: Iterable[str], **held: float) -> None:
    """Assign `__all__` and whatever else a module defines besides functions."""
    for name, value in {"__all__": [*map(repr, sorted(public, key=str.lower))], **held}.items():
        on.assign(name, value)


def _compute_elementary(on: Tape, kind: str, *given: Value) -> Any:
    function = build(kind, DOUBLE)
    (value,) = on.replay(function.program, NUMBA.last)
    if not function.far:
        return value
    on.assign("_value", value)
    if abs(given[0]) <= on.value("_LARGEST"):
        return "_value"
    if on.record("Is", given[-1], None):
        return "#nan"
    return on.replay(function.far, NUMBA_FAR.last)[0]


def mean_compiled(
    kernels: Iterable[Kernel], written: Sequence[ScalarKernel], reductions: Iterable[TermLoop]
) -> Meant:
    """Yield what a module's functions are meant to do: loops over terms, and kernels without them.

    `written` are the texts of the kernels, in their order, then of those that call several.
    """
    on = Tape()
    yield "", on.run(lambda: _hold_loops(on, written))
    yield "__dir__", on.run(lambda: "__all__")
    for found in reductions:
        term = mean_term(found)
        does = partial(_compute, on, term)
        exact = [EXACT] if is_limited(found.term, NUMBA) else []
        yield f"_{found.name}_term", on.run(does, (*term.inputs, *exact), SCALAR)
    for kernel, text in zip(kernels, written, strict=False):
        yield from _mean_forms(on, kernel, text)
    for text in written:
        yield from _mean_ways_in(on, text)


def _compute(on: Tape, program: Program, *_: Value) -> Any:
    outputs = on.replay(program, NUMBA.last)
    return outputs if len(outputs) > 1 else outputs[0]


def _list_exact(text: ScalarKernel) -> tuple[str, ...]:
    return (EXACT,) if text.limited else ()


def _mean_forms(on: Tape, kernel: Kernel, text: ScalarKernel) -> Meant:
    """Yield the functions of numbers: each form but the last, and the value by the form taken."""
    for (name, form), part in zip(list_stages(kernel)[:-1], text.stages, strict=False):
        does = partial(_compute, on, join_stage(form))
        yield f"_form{name}", on.run(does, (*part.needed, *_list_exact(text)), SCALAR)
    does = partial(_compute_value, on, kernel, text)
    yield f"_value_of_{text.name}", on.run(does, (*text.taken_names, *_list_exact(text)), SCALAR)


def _compute_value(on: Tape, kernel: Kernel, text: ScalarKernel, *_: Value) -> Any:
    conditions = list_conditions(kernel)
    if text.inside and not _compute(on, conditions.pop(0)):
        return ("#nan",) * text.count if text.shape else "#nan"
    names, stages = zip(*list_stages(kernel), strict=True)
    for condition, name, part in zip(conditions, names, text.stages, strict=False):
        if _compute(on, condition):
            return on.record(f"_form{name}", *part.needed, *_list_exact(text))
    return _compute(on, join_stage(stages[-1]))


def _mean_ways_in(on: Tape, text: ScalarKernel) -> Meant:
    """Yield the functions that lead to a value: of members, sums, arrays, and the public ones."""
    name, names = text.name, tuple(argument.name for argument in text.arguments)
    defaults = tuple(a.default for a in text.arguments if a.default is not None)
    if text.members:
        inputs = (*text.taken_names, *_list_exact(text))
        yield f"_value_of_{name}", on.run(partial(_compute_members, on, text), inputs, SCALAR)
    if text.sums:
        does = partial(_add_up, on, text)
        yield f"_sums_of_{name}", on.run(does, ("_at", "_terms", *text.names), SCALAR)
    targets = ("_out", "_terms") if text.sums else text.targets
    fill = _fill_sets if text.sums else _fill
    yield f"_fill_of_{name}", on.run(partial(fill, on, text), (*targets, *names), LOOP)
    yield name, on.run(partial(_enter, on, text), (*names, "out"), "", (*defaults, show(None)))
    does = partial(_compute_point, on, text)
    yield f"_point_of_{name}", on.run(does, names, _name_point(name, text.is_plain), defaults)


def _compute_members(on: Tape, text: ScalarKernel, *_: Value) -> tuple[Value, ...]:
    return tuple(
        on.record(f"_value_of_{m.name}", *m.taken_names, *_list_exact(m)) for m in text.members
    )


def _add_up(on: Tape, text: ScalarKernel, at: Value, terms: Value, *_: Value) -> Any:
    """Return the inputs of a kernel's value: numbers, and results of loops over terms."""
    elements = [on.record("element", number, at) for number in text.numbers]
    loops = [_loop(on, row, called, at, terms) for row, called in enumerate(text.loops)]
    return *elements, *loops


def _loop(on: Tape, row: int, called: LoopCall, at: Value, terms: Value) -> Value:
    taken = [f"_{called.name}_term", *([] if called.boolean else [ADDED])]
    where = at, row, (terms,) * called.axes
    exact = (True,) * called.limited
    kind = "_every" if called.boolean else "_add_up"
    return on.record(kind, *taken, *where, called.arguments, *exact)


def _vector(on: Tape, name: Value, width: int) -> Value:
    return on.record("_vector", name, width) if width else name


def _fill(on: Tape, text: ScalarKernel, *given: Value) -> None:
    count = len(text.targets)
    goal = given[:count] if text.members else _vector(on, given[0], text.width)
    pairs = zip(given[count:], text.arguments, strict=True)
    values = tuple(_vector(on, value, argument.width) for value, argument in pairs)
    kind = "_fill_blocks" if text.limited else "_fill"
    on.record(kind, f"_value_of_{text.name}", goal, values)


def _fill_sets(on: Tape, text: ScalarKernel, out: Value, terms: Value, *given: Value) -> None:
    value, sums = f"_value_of_{text.name}", f"_sums_of_{text.name}"
    tables = tuple(_index(text, given, lambda i: (slice(None), slice(i, on.record("add", i, 1)))))
    axes = [a.axes for a in text.arguments for _ in a.components]
    sizes = tuple(terms * terms if count == 2 else terms if count else 1 for count in axes)
    count, exact = len(text.loops), (True,) * text.limited
    on.record("_fill_sets", value, sums, count, out, terms, tables, sizes, exact)


def _index(
    text: ScalarKernel, given: Iterable[Value], key: Callable[[int], Any]
) -> Iterator[Value]:
    """Yield plain numbers as given, and the components of vectors by their places."""
    for value, argument in zip(given, text.arguments, strict=True):
        for place in range(len(argument.components)):
            yield value[key(place)] if argument.width else value


def _enter(on: Tape, text: ScalarKernel, *given: Value) -> Value:
    """Perform the public function: plain numbers and rows take a shortcut."""
    *values, out = given
    first, *others = values
    loops, is_float = on.value(f"_loops_of_{text.name}"), "float"
    types = (on.record("type", other) for other in others)
    if text.is_plain and (not others or on.record("Is", *types, is_float)):
        if on.record("Is", on.record("type", first), "ndarray"):
            row = on.record("_take_row", first, out)
            if on.record("IsNot", row, None):
                loops.fill(row, *values)
                return row
        if on.record("Is", on.record("type", first), is_float) and on.record("Is", out, None):
            return on.record("float64", loops.point(*values))
    return on.record("_run_sums" if text.sums else "_run", loops, tuple(values), out)


def _compute_point(on: Tape, text: ScalarKernel, *given: Value) -> Value:
    """Perform the function that compiled callers call in place of the public one."""
    value, exact = f"_value_of_{text.name}", (True,) * text.limited
    if not text.sums:
        numbers = _index(text, given, int)
        return on.record(value, *(on.record("float64", number) for number in numbers), *exact)
    summed = [a for a in text.arguments if a.axes]
    terms = on.assign("_terms", on.record("_count_terms", *(a.name for a in summed)))
    for a in summed:
        kind = "_take_terms" if a.axes == 1 else "_take_square"
        on.assign(a.name, on.record(kind, repr(a.name), a.name, terms))
    found = on.record(f"_sums_of_{text.name}", None, terms, *_index(text, given, int))
    return on.record(value, *found, *exact)


def _hold_loops(on: Tape, written: Iterable[ScalarKernel]) -> None:
    _hold(on, (text.name for text in written))
    for text in written:
        widths, results = [argument.width for argument in text.arguments], len(text.members)
        told: dict[str, Any] = {"widths": widths} if any(widths) else {}
        told |= {"shape": text.shape} if text.shape else {}
        told |= {"results": results} if results else {}
        names = tuple(repr(argument.name) for argument in text.arguments)
        axes = [[argument.axes for argument in text.arguments]] if text.sums else []
        ways = f"_point_of_{text.name}", f"_fill_of_{text.name}"
        loops = on.record("_Sums" if text.sums else "_Loops", names, *axes, *ways, **told)
        on.assign(f"_loops_of_{text.name}", loops)
