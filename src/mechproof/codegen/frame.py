"""The frame of an emitted module: what stands around the formulas that are read back.

Formulas are read as programs. That a name is what it is called, that a function is nothing but what
it says, and that a number goes where it belongs, is held by rules here, which name no module.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Mapping, Sequence

from mechproof.codegen.reading import ReadingError

Fault = tuple[ast.stmt | ast.expr, str]
# A pattern of names, and the decorator of what has such a name.
Decorators = Sequence[tuple[str, str]]
# Modules go by short names; everything else has its own, behind the underscore of the machinery.
SHORT = {"numpy": "_np", "math": "_math"}
# What stands before a compiled function, by how its name begins; before any other nothing.
COMPILED = (
    (r"_(form|value|sums)_|_(sum|every)_\d+_term$", "_scalar"),
    (r"_fill_", "_loop"),
    (r"_point_of_(\w+)$", r"_point_of(\1)"),
)
# The elementary functions.
ELEMENTARY = ((r"\w", "_scalar"),)
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
        faults += _list_other_values(function)
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
    """List calls in functions of points that pass something to a parameter of another name."""
    for call in ast.walk(function) if function.name.startswith(VALUE) else ():
        if isinstance(call, ast.Call) and isinstance(call.func, ast.Name):
            called = functions.get(call.func.id)
            if called and [*map(ast.unparse, call.args)] != [a.arg for a in called.args.args]:
                yield call, f"{function.name} calls {ast.unparse(call)}"


def _list_other_values(function: ast.FunctionDef) -> Iterator[Fault]:
    """List what is returned under a condition and is no NaN outside the domain, or no form's."""
    conditions = [s for s in function.body if isinstance(s, ast.If)]
    number, name = 0, function.name.removeprefix(VALUE)
    for node in conditions if function.name.startswith(VALUE) else ():
        told = "; ".join(map(ast.unparse, (*node.body, *node.orelse)))
        if ast.unparse(node.test).startswith("not "):
            pattern, place = NOT_A_NUMBER, "outside its domain"
        else:
            number += 1
            pattern, place = rf"return _form_{number}_of_{name}\(.*\)", f"for form {number}"
        if not re.fullmatch(pattern, told):
            yield node, f"{function.name}: {told} {place}"
