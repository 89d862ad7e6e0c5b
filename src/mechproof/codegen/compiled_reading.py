"""Reading of compiled modules: in, their source; out, what computes one point.

That is programs, of a point or a term of a sum, and the conditions that choose among them.
"""

from __future__ import annotations

import ast
import re

from mechproof.codegen.reading import EXACT, ReadingError, read_program
from mechproof.programs.program import Program

VALUE = "_value_of_"
# Functions that call others and compute nothing themselves.
CALLING = re.compile(r"_(sums|point)_of_")


def read_scalars(source: str) -> dict[str, Program]:
    """Return the programs of the functions of a compiled module that compute one point or a term.

    What stands before them are conditions. What follows after `_value = ...` says where the value
    is taken, and is not read.
    """
    return {
        node.name: _read_scalar(node)
        for node in _list_functions(source)
        if any(ast.unparse(d) == "_scalar" for d in node.decorator_list)
        and not CALLING.match(node.name)
    }


def _list_functions(source: str) -> list[ast.FunctionDef]:
    return [node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef)]


def _list_inputs(node: ast.FunctionDef) -> tuple[str, ...]:
    return tuple(a.arg for a in node.args.args if a.arg != EXACT)


def _list_conditions(node: ast.FunctionDef) -> list[ast.If]:
    """List the conditions that a value begins with."""
    conditions: list[ast.If] = []
    for statement in node.body if node.name.startswith(VALUE) else ():
        if not isinstance(statement, ast.If):
            break
        conditions.append(statement)
    return conditions


def _read_scalar(node: ast.FunctionDef) -> Program:
    assigned: list[tuple[str, ast.expr]] = []
    inputs = _list_inputs(node)
    for statement in node.body[len(_list_conditions(node)) :]:
        match statement:
            case ast.Assign(targets=[ast.Name(id="_value")], value=value):
                return read_program(inputs, assigned, (value,))
            case ast.Assign(targets=[ast.Name(id=name)], value=value):
                assigned.append((name, value))
            case ast.Return(value=ast.Tuple(elts=outputs)):
                return read_program(inputs, assigned, outputs)
            case ast.Return(value=ast.expr() as output):
                return read_program(inputs, assigned, (output,))
            case ast.Expr(value=ast.Constant(value=str())):
                continue
            case _:
                break
    raise ReadingError(f"line {node.lineno}: {node.name} computes no point")


def read_guards(source: str) -> dict[str, tuple[Program, ...]]:
    """Return the conditions of the compiled functions that choose what is computed, in their order.

    The first is negated in the text where a domain is checked.
    """
    return {
        node.name: tuple(_read_guard(node, condition) for condition in _list_conditions(node))
        for node in _list_functions(source)
        if node.name.startswith(VALUE)
    }


def _read_guard(node: ast.FunctionDef, condition: ast.If) -> Program:
    test = condition.test
    if isinstance(test, ast.UnaryOp) and isinstance(test.op, ast.Not):
        test = test.operand
    return read_program(_list_inputs(node), (), (test,))
