"""The frame of an emitted module: what stands around the formulas that are read back.

Formulas are read as programs. That a name is what it is called, that a function is nothing but what
it says, and that a number goes where it belongs, is held by rules here, which name no module.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Mapping, Sequence

from mechproof.codegen.reading import EXACT, ReadingError

Fault = tuple[ast.stmt | ast.expr, str]
# A pattern of names, and the decorator of what has such a name.
Decorators = Sequence[tuple[str, str]]
# Modules go by short names; everything else has its own, behind the underscore of the machinery.
SHORT = {"numpy": "_np", "math": "_math"}
# What stands before a compiled function, by how its name begins; before any other nothing.
COMPILED = (
    (r"_(prepare|form|value|point)_|_(sum|every)_\d+_term$", "_scalar"),
    (r"_(row|fill)_|_(sum|every)_\d+", "_loop"),
    (r"_offer_of_(\w+)$", r"_overload(\1)"),
)
# The elementary functions.
ELEMENTARY = ((r"\w", "_scalar"),)
# An element of a column, of a block of it, a block of a result: of what they are.
PARTS = (
    (r"_float64\((\w+)\)$", r"\1"),
    (r"_block_of_(\w+)$", r"_values_of_\1"),
    (r"_out_block(\w*)$", r"_out\1"),
    (r"(True|None)$", EXACT),
)
# Components of points go by their places; loops over elements are read with their sums.
READ_ELSEWHERE = r"\w+[\[(]|_sets_of_"
VALUE = "_value_of_"
NOT_A_NUMBER = r"return \(?_math\.nan(, _math\.nan)*\)?"


def check_frame(source: str, decorators: Decorators = ()) -> None:
    """Check imports, decorators, calls between functions, and what is given outside the domain.

    `decorators` are `COMPILED` for a compiled module; functions of NumPy have none.
    Raises `ReadingError` with the line for what breaks a rule.
    """
    tree = ast.parse(source)
    functions = {node.name: node for node in tree.body if isinstance(node, ast.FunctionDef)}
    faults = [*_list_foreign_names(tree)]
    for function in functions.values():
        faults += _list_decorators(function, decorators)
        faults += _list_crossed_calls(function, functions)
        faults += _list_values_outside(function)
    for node, told in faults:
        raise ReadingError(f"line {node.lineno}: {told}")


def _list_foreign_names(tree: ast.Module) -> Iterator[Fault]:
    for node in tree.body:
        for name in node.names if isinstance(node, ast.Import | ast.ImportFrom) else ():
            own = SHORT.get(name.name, f"_{name.name}")
            if name.asname not in (None, own):
                yield node, f"{name.name} is called {name.asname}"


def _list_decorators(function: ast.FunctionDef, known: Decorators) -> Iterator[Fault]:
    found, name = [ast.unparse(d) for d in function.decorator_list], function.name
    wanted = [re.sub(f"(?:{p}).*", d, name) for p, d in known if re.match(p, name)]
    if found != wanted[:1]:
        yield function, f"{name} is decorated by {', '.join(found) or 'nothing'}"


def _list_crossed_calls(
    function: ast.FunctionDef, functions: Mapping[str, ast.FunctionDef]
) -> Iterator[Fault]:
    """List calls of functions of the module that pass something to a parameter of another name."""
    for call in ast.walk(function):
        if isinstance(call, ast.Call) and isinstance(call.func, ast.Name):
            called = functions.get(call.func.id)
            if called is not None and called.name.startswith("_") and not _fits(call, called):
                yield call, f"{function.name} calls {ast.unparse(call)}"


def _fits(call: ast.Call, called: ast.FunctionDef) -> bool:
    names = [argument.arg for argument in called.args.args]
    given = [_name_whole(ast.unparse(argument)) for argument in call.args]
    if any(re.match(READ_ELSEWHERE, name) for name in given):
        return True
    starred = [k for k, argument in enumerate(call.args) if isinstance(argument, ast.Starred)]
    if not starred:
        return given == names
    first, after = starred[0], len(given) - starred[-1] - 1
    tail = names[len(names) - after :]
    return given[:first] == names[:first] and given[len(given) - after :] == tail


def _name_whole(given: str) -> str:
    """Return the name of what an argument is a part of."""
    for pattern, whole in PARTS:
        if re.match(pattern, given):
            return re.sub(pattern, whole, given)
    return given


def _list_values_outside(function: ast.FunctionDef) -> Iterator[Fault]:
    """List what is returned where a condition of the domain does not hold and is no NaN."""
    for node in function.body if function.name.startswith(VALUE) else ():
        if isinstance(node, ast.If) and ast.unparse(node.test).startswith("not "):
            told = [ast.unparse(s) for s in node.body if isinstance(s, ast.Return)]
            if not all(re.fullmatch(NOT_A_NUMBER, text) for text in told):
                yield node, f"{function.name}: {told[0]} outside its domain"
