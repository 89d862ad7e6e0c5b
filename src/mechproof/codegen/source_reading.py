"""Reading: in, an emitted source; out, the operations its functions perform on recording values.

The source is run in isolation, without builtins or modules other than stand-ins. Two things that a
run cannot show are checked before: that there is no loop, and that imports keep their names. Each
function, number, assignment and identity test in the source reports to a tape.

What is verified is not the printer but each text that it prints, like the compilations in
translation validation (Pnueli, Siegel and Singerman 1998).
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from itertools import zip_longest
from traceback import extract_tb
from types import FunctionType, MappingProxyType
from typing import Any

from mechproof.programs.operations import KINDS
from mechproof.programs.program import CONSTANTS, Operand
from mechproof.programs.trace import RecordedFunction, Tape, show

# The kinds of syntax that emitted code consists of.
_PARTS = (
    "Module Import ImportFrom alias FunctionDef arguments arg Assign Expr If Return With withitem "
    "Name Load Store Constant BinOp UnaryOp Compare BoolOp Call keyword Starred Attribute "
    "Subscript Slice Tuple List Dict Lambda NamedExpr And USub Not Add Sub Mult Div Pow BitAnd "
    "BitOr Lt LtE Gt GtE Eq Is IsNot"
)
KNOWN = frozenset(_PARTS.split())
# Modules have short names; everything else keeps its own, after an underscore.
SHORT = {"numpy": "_np", "math": "_math"}
MODULES = re.compile(
    r"__future__|builtins|math|typing|numpy(\.typing)?|mechproof\.(kernels\.|kernel_|compiled_).*"
)
TYPES = ("Any", "ArrayLike", "NDArray[Any]", "NDArray[Any] | None", "tuple[Any, ...]", "list[str]")
# Names in annotations, which are never evaluated, and the index of a new axis.
UNUSED = dict.fromkeys(("annotations", "Any", "ArrayLike", "NDArray", "newaxis"))
# Functions that are named unlike their operation.
RENAMED: Mapping[str, str] = MappingProxyType(
    {
        "abs": "absolute",
        "choose_where": "choose",
        **{str(row.c): kind for kind, row in KINDS.items() if row.numba == f"_math.{row.c}"},
    }
)
# Names of the functions that report to the tape; with blanks, so that no source can use them.
VALUE, ASSIGN, SAME, DEFINE = "a value", "an assignment", "an identity", "a function"
FILE = "<emitted>"
Offer = Callable[[Tape], Mapping[str, Any]]


class SourceError(ValueError):
    """The emitted source contains something that no kernel contains."""


class TranslationError(SourceError):
    """The emitted source does not compute the intended program."""


class _Instrument(ast.NodeTransformer):
    """Refuses syntax that no emitted code has, and inserts calls that report to the tape."""

    def visit(self, node: ast.AST) -> Any:
        if type(node).__name__ not in KNOWN:
            _refuse(node, f"emitted code never contains {ast.unparse(node)!r}")
        block = node.body if isinstance(node, ast.FunctionDef | ast.If | ast.With) else []
        if any(isinstance(statement, ast.Return) for statement in block[:-1]):
            # Code after a return never runs, so no tape would show it.
            _refuse(node, "code after a return")
        return super().visit(node)

    def visit_alias(self, node: ast.alias) -> ast.alias:
        # Otherwise one function could be called under the name of another.
        if node.asname not in (None, SHORT.get(node.name, f"_{node.name}")):
            _refuse(node, f"{node.name} is imported as {node.asname}")
        return node

    def visit_arg(self, node: ast.arg) -> ast.arg:
        _check_type(node.annotation)
        return node

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.AST:
        _check_type(node.returns)
        node.decorator_list.insert(0, ast.copy_location(ast.Name(DEFINE, ast.Load()), node))
        return self.generic_visit(node)

    def visit_Expr(self, node: ast.Expr) -> ast.AST:
        return node if isinstance(node.value, ast.Constant) else self.generic_visit(node)

    def visit_Constant(self, node: ast.Constant) -> ast.expr:
        if isinstance(node.value, str):
            node.value = repr(node.value)
            return _call(VALUE, node)
        return _call(VALUE, node) if type(node.value) in (int, float) else node

    def visit_Compare(self, node: ast.Compare) -> ast.AST:
        self.generic_visit(node)
        signs = {type(sign).__name__ for sign in node.ops}
        if signs in ({"Is"}, {"IsNot"}):
            return _call(SAME, ast.Constant(*signs), node.left, *node.comparators)
        return node

    def visit_Assign(self, node: ast.Assign) -> ast.Assign:
        (target,) = node.targets
        parts = target.elts if isinstance(target, ast.Tuple) else None
        names: Any = tuple(map(ast.unparse, parts)) if parts else ast.unparse(target)
        node.value = _call(ASSIGN, ast.Constant(names), self.visit(node.value))
        return node


def _check_type(node: ast.expr | None) -> None:
    if node is not None and ast.unparse(node) not in TYPES:
        _refuse(node, f"emitted code never uses the type {ast.unparse(node)}")


def _refuse(node: ast.AST, reason: str) -> None:
    raise SourceError(f"line {getattr(node, 'lineno', '?')}: {reason}")


def _call(name: str, *arguments: ast.expr) -> ast.Call:
    """Return a call at the source position of its last argument."""
    call = ast.Call(ast.Name(name, ast.Load()), list(arguments), [])
    for node in (call, call.func, *arguments):
        if not hasattr(node, "lineno"):
            ast.copy_location(node, arguments[-1])
    return call


class Module:
    """A module as emitted code sees it: offered names, constants, operations, other functions."""

    def __init__(self, tape: Tape, name: str, offered: Mapping[str, Any]) -> None:
        if not MODULES.fullmatch(name):
            raise SourceError(f"emitted code never imports {name}")
        self._tape, self._name, self._offered = tape, name, offered

    def __getattr__(self, name: str) -> Any:
        kind = RENAMED.get(name, name)
        if name in self._offered:
            return self._offered[name]
        if f"#{name}" in CONSTANTS:
            return self._tape.value(f"#{name}")
        if kind not in KINDS and not self._name.startswith("mechproof."):
            raise SourceError(f"no operation is written as {self._name}.{name}")
        return partial(self._tape.record, kind if kind in KINDS else f"_{name}")


def read_functions(source: str, offer: Offer) -> dict[str, RecordedFunction]:
    """Return the functions of a module by their names and, under "", the module's own statements.

    `offer` returns the stand-ins for imported names. Raises `SourceError`, with the line, for
    anything that no kernel has.
    """
    tape, defined = Tape(), dict[str, tuple[str, FunctionType]]()

    def define(found: Any) -> Any:
        decorator, function = found if isinstance(found, tuple) else ("", found)
        defined[function.__name__] = decorator, function
        # To its callers a compiled function is one operation; it is read separately.
        return partial(tape.record, function.__name__) if decorator else function

    offered = {**UNUSED, **offer(tape)}
    names: dict[str, Any] = {
        "__builtins__": {"__import__": lambda name, *_: Module(tape, name, offered)},
        **{VALUE: tape.value, ASSIGN: tape.assign, SAME: tape.record, DEFINE: define},
    }
    try:
        tree = _Instrument().visit(ast.parse(source))
        # The __future__ imports in force are the emitted text's, not this file's.
        code = compile(tree, FILE, "exec", dont_inherit=True)
        read = {"": tape.run(lambda: exec(code, names))}
        return read | {name: _read(tape, *found) for name, found in tuple(defined.items())}
    except Exception as error:
        lines = [at.lineno for at in extract_tb(error.__traceback__) if at.filename == FILE]
        where = f"line {lines[-1]}: " if lines else ""
        raise SourceError(f"{where}{error}") from error


def _read(tape: Tape, decorator: str, function: FunctionType) -> RecordedFunction:
    code, named = function.__code__, function.__kwdefaults__ or {}
    inputs = code.co_varnames[: code.co_argcount + code.co_kwonlyargcount]
    defaults = show((*(function.__defaults__ or ()), *named.values()))

    def call(*given: Any) -> Any:
        last = dict(zip(inputs[code.co_argcount :], given[code.co_argcount :], strict=True))
        return function(*given[: code.co_argcount], **last)

    return tape.run(call, inputs, decorator, defaults)


def compare(
    meant: Mapping[str, RecordedFunction], read: Mapping[str, RecordedFunction], system: str = ""
) -> None:
    """Raise `TranslationError` for the first difference between functions as meant and as read."""
    for name in {**meant, **read}:
        parts = zip_longest(*(_list_parts(found.get(name)) for found in (meant, read)))
        for one, other in parts:
            if one != other:
                raise TranslationError(
                    f"{system}{name or 'the module'} is not as meant: {one}, read {other}"
                )


def _list_parts(function: RecordedFunction | None) -> Iterator[object]:
    if function is not None:
        yield f"decorated by {function.decorator or 'nothing'}"
        yield function.inputs
        yield function.defaults
        yield f"ways through it: {len(function.ways)}"
        for way in function.ways:
            yield from (replace(o, operands=_round(o.operands)) for o in way.operations)
            yield _round(way.outputs)


def _round(operands: tuple[Operand, ...]) -> tuple[Operand, ...]:
    """Return operands with whole numbers rounded to doubles, as printing does."""
    return tuple(float(one) if isinstance(one, int) else one for one in operands)
