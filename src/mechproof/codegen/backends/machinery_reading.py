"""Reading of what a compiled module does with its formulas: loops, and the ways into them.

It is the same text for every kernel but for names, and nothing else is accepted.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator

from mechproof.codegen.backends.scalar_texts import LoopCall, ScalarKernel
from mechproof.codegen.reading import EXACT, ReadingError

OUT = "out: NDArray[Any] | None = None"
ENTERED = """
{space}if _type({first}) is _ndarray and (_row := _take_row({first}, out)) is not None:
{space}    _loops_of_{name}.fill(_row, {listed})
{space}    return _row
{space}if _type({first}) is _float and out is None:
{space}    return _float64(_loops_of_{name}.point({listed}))
"""


def check_machinery(source: str, kernels: Iterable[ScalarKernel]) -> None:
    """Raise `ReadingError` with the line where a module does something else with its kernels."""
    body = ast.parse(source).body
    found = {_name(node): node for node in body}
    meant = {"__all__"}
    for text in (text for kernel in kernels for text in list_machinery(kernel)):
        (node,) = ast.parse(text).body
        name = _name(node)
        if name not in found:
            raise ReadingError(f"{name} is missing")
        if _unparse(found[name]) != ast.unparse(node):
            raise ReadingError(f"line {found[name].lineno}: {name} is not\n{ast.unparse(node)}")
        meant.add(name)
    for node in body:
        if isinstance(node, ast.Assign) and _name(node) not in meant:
            raise ReadingError(f"line {node.lineno}: nothing is called {_name(node)}")


def _name(node: ast.stmt) -> str:
    if isinstance(node, ast.FunctionDef):
        return node.name
    return ", ".join(map(ast.unparse, node.targets)) if isinstance(node, ast.Assign) else ""


def _unparse(node: ast.stmt) -> str:
    """Return the text of a statement, without the words of a function."""
    if isinstance(node, ast.FunctionDef) and ast.get_docstring(node) is not None:
        node.body = node.body[1:]
    return ast.unparse(node)


def list_machinery(kernel: ScalarKernel) -> Iterator[str]:
    """List the functions of a kernel that compute nothing themselves, and its object."""
    if kernel.members:
        yield _write_members(kernel)
    if kernel.sums:
        yield _write_sums(kernel)
    yield _write_loop(kernel)
    yield _write_entry(kernel)
    yield _write_point(kernel)
    yield _write_object(kernel)


def _tuple(items: Iterable[object]) -> str:
    listed = tuple(map(str, items))
    return f"({', '.join(listed)}{',' * (len(listed) == 1)})"


def _list_names(kernel: ScalarKernel) -> list[str]:
    return [argument.name for argument in kernel.arguments]


def _write_members(kernel: ScalarKernel) -> str:
    calls = [f"_value_of_{m.name}{_tuple_of_call(m)}" for m in kernel.members]
    return (
        f"@_scalar\ndef _value_of_{kernel.name}{_tuple_of_call(kernel)}:\n return {_tuple(calls)}"
    )


def _tuple_of_call(kernel: ScalarKernel) -> str:
    return f"({', '.join([*kernel.taken_names, *([EXACT] * kernel.limited)])})"


def _write_sums(kernel: ScalarKernel) -> str:
    """Write what the value of a kernel takes: numbers, and loops over terms."""
    found = [f"_element({name}, _at)" for name in kernel.numbers]
    found += [_write_loop_over_terms(called, row) for row, called in enumerate(kernel.loops)]
    taken = ", ".join(kernel.names)
    return f"@_scalar\ndef _sums_of_{kernel.name}(_at, _terms, {taken}):\n return {_tuple(found)}"


def _write_loop_over_terms(called: LoopCall, row: int) -> str:
    way = "_every({}" if called.boolean else "_add_up({}, _elementary.total_rest"
    counts = _tuple(["_terms"] * called.axes)
    last = ", True" * called.limited
    head = way.format(f"_{called.name}_term")
    return f"{head}, _at, {row}, {counts}, {_tuple(called.arguments)}{last})"


def _write_loop(kernel: ScalarKernel) -> str:
    name, names = kernel.name, _list_names(kernel)
    if kernel.sums:
        targets: tuple[str, ...] = ("_out", "_terms")
        exact = _tuple(["True"] * kernel.limited)
        tables = _tuple(kernel.index("[:, {0} : {0} + 1]"))
        loop = (
            f"_fill_sets(_value_of_{name}, _sums_of_{name}, {len(kernel.loops)}, "
            f"_out, _terms, {tables}, {_tuple(kernel.sizes)}, {exact})"
        )
    else:
        targets = kernel.targets
        goal = _tuple(targets) if kernel.members else _write_vector("_out", kernel.width)
        values = _tuple(_write_vector(a.name, a.width) for a in kernel.arguments)
        way = "_fill_blocks" if kernel.limited else "_fill"
        loop = f"{way}(_value_of_{name}, {goal}, {values})"
    return f"@_loop\ndef _fill_of_{name}({', '.join([*targets, *names])}):\n {loop}"


def _write_vector(name: str, width: int) -> str:
    return f"_vector({name}, {width})" if width else name


def _write_entry(kernel: ScalarKernel) -> str:
    """Write the function that callers see."""
    name, names = kernel.name, _list_names(kernel)
    first, *others = names
    text = ""
    if kernel.is_plain:
        same = "".join(f"_type({other}) is " for other in others)
        text = f" if {same}_float:\n" if others else ""
        space = "  " if others else " "
        text += ENTERED.format(space=space, name=name, first=first, listed=", ".join(names))
    run = "_run_sums" if kernel.sums else "_run"
    given = [_write_default(f"{a.name}: ArrayLike", a.default) for a in kernel.arguments]
    return (
        f"def {name}({', '.join([*given, '*', OUT])}) -> Any:\n{text}"
        f" return {run}(_loops_of_{name}, {_tuple(names)}, out)"
    )


def _write_default(name: str, default: float | None) -> str:
    return name if default is None else f"{name}={default}"


def _write_point(kernel: ScalarKernel) -> str:
    """Write what compiled functions call instead."""
    name, given = kernel.name, [_write_default(a.name, a.default) for a in kernel.arguments]
    head = f"@_point_of({name})\ndef _point_of_{name}({', '.join(given)}):\n"
    exact = ["True"] * kernel.limited
    numbers = kernel.index("[{}]")
    if not kernel.sums:
        taken = [*(f"_float64({number})" for number in numbers), *exact]
        return f"{head} return _value_of_{name}({', '.join(taken)})"
    summed = [a for a in kernel.arguments if a.axes]
    head += f" _terms = _count_terms({', '.join(a.name for a in summed)})\n"
    for a in summed:
        way = "_take_terms" if a.axes == 1 else "_take_square"
        head += f" {a.name} = {way}({a.name!r}, {a.name}, _terms)\n"
    found = f"*_sums_of_{name}(None, _terms, {', '.join(numbers)})"
    return f"{head} return _value_of_{name}({', '.join([found, *exact])})"


def _write_object(kernel: ScalarKernel) -> str:
    given = [_tuple(map(repr, _list_names(kernel)))]
    given += [_tuple(a.axes for a in kernel.arguments)] if kernel.sums else []
    given += [f"_point_of_{kernel.name}", f"_fill_of_{kernel.name}"]
    widths = [a.width for a in kernel.arguments]
    given += [f"widths={_tuple(widths)}"] if any(widths) else []
    given += [f"shape={_tuple(kernel.shape)}"] if kernel.shape else []
    given += [f"results={len(kernel.members)}"] if kernel.members else []
    kind = "_Sums" if kernel.sums else "_Loops"
    return f"_loops_of_{kernel.name} = {kind}({', '.join(given)})"
