"""Reading: in, assignments of an emitted source; out, the program that they compute.

Python's own parser reads it, and the tables here are not the printer's: a bracket that a printer
leaves out, a term that it drops, two arguments that change places are seen as a difference between
what was meant and what was read.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Mapping
from types import MappingProxyType

from mechproof.programs.operations import KINDS
from mechproof.programs.program import TEMPORARY, Operand, Operation, Program

BINARY: Mapping[type[ast.operator], str] = MappingProxyType(
    {
        ast.Add: "add",
        ast.Sub: "subtract",
        ast.Mult: "multiply",
        ast.Div: "divide",
        ast.BitAnd: "both",
        ast.BitOr: "either",
    }
)
COMPARED: Mapping[type[ast.cmpop], str] = MappingProxyType(
    {
        ast.Lt: "less",
        ast.LtE: "less_equal",
        ast.Gt: "greater",
        ast.GtE: "greater_equal",
        ast.Eq: "equal",
    }
)
# Functions whose operation has another name; the others are called like it.
RENAMED: Mapping[str, str] = MappingProxyType(
    {
        "abs": "absolute",
        "choose_where": "choose",
        **{f"math.{row.c}": kind for kind, row in KINDS.items() if row.numba == f"_math.{row.c}"},
    }
)
REDUCED: Mapping[str, str] = MappingProxyType({"add_up": "sum", "every": "every"})
# Where compiled kernels find the elementary functions.
ELEMENTARY = "_elementary."
# The last argument of a compiled function that is right up to the largest angle only.
EXACT = "_exact"


class ReadingError(ValueError):
    """The emitted source has something that no kernel has."""


class TranslationError(ValueError):
    """The emitted source does not compute the program that was meant."""


class _ProgramReader:
    """Turns expressions of Python into operations."""

    def __init__(self) -> None:
        self.operations: list[Operation] = []

    def assign(self, name: str, value: ast.expr) -> None:
        result = self.read(value)
        if isinstance(result, str) and result.startswith(TEMPORARY):
            last = self.operations.pop()
            self.operations.append(Operation(name, last.kind, last.operands))
        else:
            self.operations.append(Operation(name, "copy", (result,)))

    def read(self, node: ast.expr) -> Operand:
        match node:
            case ast.Name(id=name):
                return name
            case ast.Constant(value=int() | float() as number):
                return number
            case ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=int() | float() as number)):
                return -number
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return self._add("negate", self.read(operand))
            case ast.Attribute(value=ast.Name(id="_np"), attr="pi" | "e" | "inf" | "nan" as name):
                return f"#{name}"
            case ast.BinOp(left=base, op=ast.Pow(), right=ast.Constant(value=2)):
                return self._add("square", self.read(base))
            case ast.BinOp(left=base, op=ast.Pow(), right=exponent):
                return self._add("power", self.read(base), self.read(exponent))
            case ast.BinOp(left=left, op=op, right=right) if type(op) in BINARY:
                return self._add(BINARY[type(op)], self.read(left), self.read(right))
            case ast.Compare(left=left, ops=[op], comparators=[right]) if type(op) in COMPARED:
                return self._add(COMPARED[type(op)], self.read(left), self.read(right))
            case ast.Subscript():
                return self._view(node)
            case ast.Call():
                return self._call(node)
        raise ReadingError(f"line {node.lineno}: no operation is written {ast.unparse(node)!r}")

    def _add(self, kind: str, *operands: Operand) -> str:
        # The list never shrinks, so that no two temporaries have one number.
        result = f"{TEMPORARY}{len(self.operations) + 1}"
        self.operations.append(Operation(result, kind, operands))
        return result

    def _view(self, node: ast.Subscript) -> Operand:
        views = {"(..., :, _np.newaxis)": "along_first", "(..., _np.newaxis, :)": "along_last"}
        kind = views.get(ast.unparse(node.slice)) or views.get(f"({ast.unparse(node.slice)})")
        if kind is None:
            raise ReadingError(f"line {node.lineno}: no view is written {ast.unparse(node)!r}")
        return self._add(kind, self.read(node.value))

    def _call(self, node: ast.Call) -> Operand:
        function = ast.unparse(node.func)
        name = function.removeprefix("_np.").removeprefix(ELEMENTARY).removeprefix("_")
        keywords = {k.arg: ast.unparse(k.value) for k in node.keywords}
        if name in REDUCED and set(keywords) == {"axis"}:
            count = {"-1": 1, "(-2, -1)": 2}[keywords["axis"]]
            (value,) = node.args
            return self._add(REDUCED[name], self.read(value), count)
        if ast.unparse(node).startswith("_np.swapaxes(") and not keywords:
            value, *axes = node.args
            if [ast.unparse(a) for a in axes] == ["-1", "-2"]:
                return self._add("transpose", self.read(value))
        if name == "diagonal" and keywords == {"axis1": "-2", "axis2": "-1"}:
            return self._add("diagonal", self.read(node.args[0]))
        arguments = list(node.args)
        if keywords:
            raise ReadingError(f"line {node.lineno}: no operation is written {ast.unparse(node)!r}")
        if arguments and ast.unparse(arguments[-1]) == EXACT:
            arguments.pop()
        return self._add(RENAMED.get(name, name), *map(self.read, arguments))


def read_program(
    inputs: tuple[str, ...],
    assignments: Iterable[tuple[str, ast.expr]],
    outputs: Iterable[ast.expr],
) -> Program:
    """Return the program of assignments and outputs."""
    reader = _ProgramReader()
    for name, value in assignments:
        reader.assign(name, value)
    results = tuple(map(reader.read, outputs))
    _check_names({*inputs}, reader.operations, results)
    return Program(inputs, tuple(reader.operations), results).normal_form()


def _check_names(
    known: set[Operand], operations: Iterable[Operation], outputs: tuple[Operand, ...]
) -> None:
    """Raise `ReadingError` for a name that is no constant, no input and no result before it."""
    for step in (*operations, Operation("", "copy", outputs)):
        for name in step.operands:
            if isinstance(name, str) and name not in known and not name.startswith("#"):
                raise ReadingError(f"{name}: read before anything has this name")
        known.add(step.result)


def list_names(node: ast.expr) -> tuple[str, ...]:
    """List the texts of a target, of arguments or of an index."""
    parts = node.elts if isinstance(node, ast.Tuple) else [node]
    return tuple(map(ast.unparse, parts))
