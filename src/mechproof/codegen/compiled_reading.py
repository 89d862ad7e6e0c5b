"""Reading of compiled modules: in, their source; out, what computes one point.

That is programs, the conditions that choose among them, and loops over terms.
"""

from __future__ import annotations

import ast

from mechproof.codegen.program import Program
from mechproof.codegen.reading import EXACT, ReadingError, list_names, read_program


def read_scalars(source: str) -> dict[str, Program]:
    """Return the programs of the private functions of a compiled module that compute one point.

    What follows after `_value = ...` says where the value is taken, and is not read.
    """
    functions = (n for n in ast.parse(source).body if isinstance(n, ast.FunctionDef))
    return {
        node.name: _read_scalar(node)
        for node in functions
        if any(ast.unparse(d) == "_scalar" for d in node.decorator_list)
        and not any(isinstance(s, ast.If) for s in node.body[:1])
        and not any(isinstance(n, ast.Starred) for n in ast.walk(node))
    }


def _read_scalar(node: ast.FunctionDef) -> Program:
    assigned: list[tuple[str, ast.expr]] = []
    inputs = tuple(a.arg for a in node.args.args if a.arg != EXACT)
    for statement in node.body:
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
    functions = (n for n in ast.parse(source).body if isinstance(n, ast.FunctionDef))
    return {
        node.name: tuple(
            read_program(tuple(a.arg for a in node.args.args if a.arg != EXACT), (), (test,))
            for statement in node.body
            if isinstance(statement, ast.If)
            for test in [_without_not(statement.test)]
        )
        for node in functions
        if node.name.startswith("_value_of_")
    }


def _without_not(test: ast.expr) -> ast.expr:
    return test.operand if isinstance(test, ast.UnaryOp) and isinstance(test.op, ast.Not) else test


# What a loop over terms is besides its parameters and its term.
ADDED = """
_high, _low = (0.0, 0.0)
{loops}
{space}_term = TERM
{space}_total = _high + _term
{space}_low += _elementary.total_rest(_high, _term, _total)
{space}_high = _total
return _choose(_is_finite(_low), _high + _low, _high)
"""
HELD = """
_holds = True
{loops}
{space}_holds = _holds & TERM
return _holds
"""
# The same for many sets beside each other.
OF_SETS = "_sets"
ADDED_OF_SETS = """
_widen()
_high, _low = (_own_row(), _own_row())
for _s in _range(_len(_out)):
    _high[_s], _low[_s] = (0.0, 0.0)
{loops}
{space}for _s in _range(_len(_out)):
{space}    _term = TERM
{space}    _total = _high[_s] + _term
{space}    _low[_s] += _elementary.total_rest(_high[_s], _term, _total)
{space}    _high[_s] = _total
for _s in _range(_len(_out)):
    _out[_s] = _choose(_is_finite(_low[_s]), _high[_s] + _low[_s], _high[_s])
"""
HELD_OF_SETS = """
_widen()
_holds = _own_row()
for _s in _range(_len(_out)):
    _holds[_s] = 1.0
{loops}
{space}for _s in _range(_len(_out)):
{space}    _holds[_s] = _choose(TERM, _holds[_s], 0.0)
for _s in _range(_len(_out)):
    _out[_s] = _holds[_s]
"""
LOOPS = ("for _i in _range(_len(ARRAY)):", "    for _j in _range(_len(ARRAY)):")
LETTERS = ("_i", "_j")
Reduced = tuple[str, int, tuple[str, ...], tuple[tuple[str, tuple[int, ...]], ...]]


def read_reductions(source: str) -> dict[str, Reduced]:
    """Return the loops over terms of a compiled module.

    Each is its kind, the number of its axes, its parameters and what its term takes: a parameter
    and the indices of its element.
    """
    functions = (n for n in ast.parse(source).body if isinstance(n, ast.FunctionDef))
    return {
        node.name: _read_reduction(node)
        for node in functions
        if f"{_name_term(node)}(" in ast.unparse(node)
    }


def _name_term(node: ast.FunctionDef) -> str:
    return f"{node.name.removesuffix(OF_SETS)}_term"


def _read_reduction(node: ast.FunctionDef) -> Reduced:
    reader = _ReductionReader(node)
    body = ast.unparse(ast.Module([reader.visit(s) for s in node.body], []))
    added, held = (ADDED_OF_SETS, HELD_OF_SETS) if reader.of_sets else (ADDED, HELD)
    for kind, text in (("sum", added), ("every", held)):
        for axes in (1, 2):
            loops, space = "\n".join(LOOPS[:axes]), 4 * axes * " "
            if body == ast.unparse(ast.parse(text.format(loops=loops, space=space))):
                return kind, axes, reader.parameters, tuple(reader.elements)
    raise ReadingError(f"line {node.lineno}: {node.name} is no loop over terms")


class _ReductionReader(ast.NodeTransformer):
    """Takes the term and the array whose length is taken out of a loop."""

    def __init__(self, node: ast.FunctionDef) -> None:
        self.of_sets = node.name.endswith(OF_SETS)
        names = tuple(a.arg for a in node.args.args if a.arg != EXACT)
        self.parameters = names[1:] if self.of_sets else names
        self._term = _name_term(node)
        read = _read_element_of_sets if self.of_sets else _read_element
        self.elements = [
            read(a)
            for call in ast.walk(node)
            if isinstance(call, ast.Call) and ast.unparse(call.func) == self._term
            for a in call.args
            if ast.unparse(a) != EXACT
        ]

    def visit_Call(self, node: ast.Call) -> ast.expr:
        match node:
            case ast.Call(func=ast.Name(id="_len"), args=[ast.Name(id=name)]):
                if any(name == array and indices for array, indices in self.elements):
                    return ast.Call(node.func, [ast.Name("ARRAY")], [])
            case ast.Call(func=ast.Name(id=name)) if name == self._term:
                return ast.Name("TERM")
        return ast.Call(node.func, [self.visit(a) for a in node.args], node.keywords)


def _read_element(node: ast.expr) -> tuple[str, tuple[int, ...]]:
    match node:
        case ast.Name(id=name):
            return name, ()
        case ast.Call(
            func=ast.Name(id="_float64"), args=[ast.Subscript(value=ast.Name(id=name), slice=index)]
        ):
            return name, tuple(LETTERS.index(letter) for letter in list_names(index))
    raise ReadingError(f"line {node.lineno}: {ast.unparse(node)!r} is no element")


def _read_element_of_sets(node: ast.expr) -> tuple[str, tuple[int, ...]]:
    match node:
        case ast.Subscript(value=ast.Name(id=name), slice=index):
            *letters, last = list_names(index)
            if last == "_s" and (letters == ["0"] or set(letters) <= set(LETTERS)):
                return name, tuple(LETTERS.index(letter) for letter in letters if letter != "0")
    raise ReadingError(f"line {node.lineno}: {ast.unparse(node)!r} is no element of a set")
