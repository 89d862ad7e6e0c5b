"""Reading of loops over many sets of terms: in, a compiled module; out, what each set is given.

That is what one point computes, too, as if the loops over terms stood where their values are taken.
"""

from __future__ import annotations

import ast

from mechproof.codegen.compiled_reading import OF_SETS
from mechproof.codegen.program import Program
from mechproof.codegen.reading import ReadingError, read_program

FILL = "_fill_each_of_"
PUT = "_put_sets"
SETS = "_sets_of_"
VALUES = "_values_of_"
SUMMED = ("_sum_", "_every_")


def read_fills(source: str) -> dict[str, Program]:
    """Return what each loop over sets of terms computes of one of them."""
    functions = (n for n in ast.parse(source).body if isinstance(n, ast.FunctionDef))
    return {
        node.name: _read_fill(node)
        for node in functions
        if node.name.startswith(FILL) and f"{PUT}(" in ast.unparse(node)
    }


def _read_fill(node: ast.FunctionDef) -> Program:
    value = f"_value_of_{node.name.removeprefix(FILL)}"
    inputs: list[str] = []
    found: dict[str, ast.expr] = {}
    for call in _list_calls(node):
        name = ast.unparse(call.func)
        if name == PUT:
            inputs.append(_read_put(call))
        elif name == value:
            return read_program(tuple(inputs), (), (_Inserted(found).visit(call),))
        elif name.startswith(SUMMED) and name.endswith(OF_SETS):
            target, *arguments = call.args
            kind = name.removesuffix(OF_SETS)
            if ast.unparse(target) != f"{SETS}{kind.removeprefix('_')}":
                raise ReadingError(f"line {call.lineno}: {name} is not put where it is taken")
            given: list[ast.expr] = [_Inserted({}).visit(a) for a in arguments]
            found[ast.unparse(target)] = ast.Call(ast.Name(kind), given, [])
    raise ReadingError(f"line {node.lineno}: {node.name} computes no set")


def _list_calls(node: ast.FunctionDef) -> list[ast.Call]:
    """List the calls in the order of their text."""
    calls = [n for n in ast.walk(node) if isinstance(n, ast.Call)]
    return sorted(calls, key=lambda call: (call.lineno, call.col_offset))


def _read_put(call: ast.Call) -> str:
    """Return what is put for each set; ReadingError for values of another argument."""
    target, values, *_ = call.args
    block = ast.unparse(target).partition(".")[0]
    name, values_of = block.removeprefix(SETS), ast.unparse(values)
    given, _, columns = values_of.partition("[:, ")
    argument = given.removeprefix(VALUES)
    number = columns.partition(":")[0].strip()
    if name != (f"{argument}_{number}" if columns else argument):
        raise ReadingError(f"line {call.lineno}: {values_of} are put into {block}")
    return name


class _Inserted(ast.NodeTransformer):
    """Puts calls where their values are taken, and numbers where those of a set are."""

    def __init__(self, found: dict[str, ast.expr]) -> None:
        self._found = found

    def visit_Compare(self, node: ast.Compare) -> ast.expr:
        match node:
            case ast.Compare(left=ast.Subscript() as left, ops=[ast.Gt()]):
                return self.visit_Subscript(left)
        return node

    def visit_Subscript(self, node: ast.Subscript) -> ast.expr:
        if ast.unparse(node.slice) not in ("_s", "(0, _s)"):
            raise ReadingError(f"line {node.lineno}: {ast.unparse(node)!r} is not of a set")
        value: ast.expr = self.visit(node.value)
        return value

    def visit_Name(self, node: ast.Name) -> ast.expr:
        return self._found.get(node.id, ast.Name(node.id.removeprefix(SETS)))
