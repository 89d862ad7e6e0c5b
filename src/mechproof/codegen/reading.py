"""Reading: in, the emitted source of a module; out, the code of its kernels.

Python's own parser reads it, and the tables here are not the printer's: a bracket that a printer
leaves out, a term that it drops, two arguments that change places are seen as a difference between
what was meant and what was read.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Mapping
from types import MappingProxyType

from mechproof.codegen.code import KernelCode, Stage
from mechproof.codegen.program import NOTHING, TEMPORARY, Operand, Operation, Program

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
RENAMED: Mapping[str, str] = MappingProxyType({"abs": "absolute", "choose_where": "choose"})
LAST_CONSTANT: Mapping[str, str] = MappingProxyType(
    {"small_arctan": "ARCTANGENT", "tangent_quotient": "TANGENT"}
)


# Where compiled kernels find the elementary functions.
ELEMENTARY = "elementary."
# The last argument of a compiled function that is right up to the largest angle only.
EXACT = "exact"


class ReadingError(ValueError):
    """The emitted source has something that no kernel has."""


class TranslationError(ValueError):
    """The emitted source does not compute the program that was meant."""


def read_module(source: str) -> dict[str, KernelCode]:
    """Return the code of every public function of a generated module.

    Raises `ReadingError` with the line for what no kernel has.
    """
    functions = {
        node.name: node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef)
    }
    public = {
        name: node
        for name, node in functions.items()
        if not name.startswith("_") and any(arg.arg == "out" for arg in node.args.kwonlyargs)
    }
    return {name: _KernelReader(node, functions).read() for name, node in public.items()}


def read_scalars(source: str) -> dict[str, Program]:
    """Return the programs of the private functions of a compiled module that compute one point.

    What follows after `value = ...` says where the value is taken, and is not read.
    """
    functions = (n for n in ast.parse(source).body if isinstance(n, ast.FunctionDef))
    return {
        node.name: _read_scalar(node)
        for node in functions
        if any(ast.unparse(d) == "scalar" for d in node.decorator_list)
        and not any(isinstance(s, ast.If) for s in node.body[:1])
        and not any(isinstance(n, ast.Starred) for n in ast.walk(node))
    }


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
        if node.name.endswith("_at")
    }


# What a loop over terms is besides its parameters and its term.
ADDED = """
high, low = (0.0, 0.0)
{loops}
{space}term = TERM
{space}total = high + term
{space}low += elementary.total_rest(high, term, total)
{space}high = total
return choose(is_finite(low), high + low, high)
"""
HELD = """
holds = True
{loops}
{space}holds = holds & TERM
return holds
"""
LOOPS = ("for i in range(len(ARRAY)):", "    for j in range(len(ARRAY)):")
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
        if f"{node.name}_term(" in ast.unparse(node)
    }


def _read_reduction(node: ast.FunctionDef) -> Reduced:
    reader = _ReductionReader(node)
    body = ast.unparse(ast.Module([reader.visit(s) for s in node.body], []))
    for kind, text in (("sum", ADDED), ("every", HELD)):
        for axes in (1, 2):
            loops, space = "\n".join(LOOPS[:axes]), 4 * axes * " "
            if body == ast.unparse(ast.parse(text.format(loops=loops, space=space))):
                return kind, axes, reader.parameters, tuple(reader.elements)
    raise ReadingError(f"line {node.lineno}: {node.name} is no loop over terms")


class _ReductionReader(ast.NodeTransformer):
    """Takes the term and the array whose length is taken out of a loop."""

    def __init__(self, node: ast.FunctionDef) -> None:
        self.parameters = tuple(a.arg for a in node.args.args if a.arg != EXACT)
        self._term = f"{node.name}_term"
        self.elements = [
            _read_element(a)
            for call in ast.walk(node)
            if isinstance(call, ast.Call) and ast.unparse(call.func) == self._term
            for a in call.args
            if ast.unparse(a) != EXACT
        ]

    def visit_Call(self, node: ast.Call) -> ast.expr:
        match node:
            case ast.Call(func=ast.Name(id="len"), args=[ast.Name(id=name)]):
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
            func=ast.Name(id="float"), args=[ast.Subscript(value=ast.Name(id=name), slice=index)]
        ):
            return name, tuple("ij".index(letter) for letter in _names(index))
    raise ReadingError(f"line {node.lineno}: {ast.unparse(node)!r} is no element")


def _without_not(test: ast.expr) -> ast.expr:
    return test.operand if isinstance(test, ast.UnaryOp) and isinstance(test.op, ast.Not) else test


def _read_scalar(node: ast.FunctionDef) -> Program:
    assigned: list[tuple[str, ast.expr]] = []
    inputs = tuple(a.arg for a in node.args.args if a.arg != EXACT)
    for statement in node.body:
        match statement:
            case ast.Assign(targets=[ast.Name(id="value")], value=value):
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
            case ast.Attribute(value=ast.Name(id="np"), attr="pi" | "e" | "inf" | "nan" as name):
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
        views = {"(..., :, np.newaxis)": "along_first", "(..., np.newaxis, :)": "along_last"}
        kind = views.get(ast.unparse(node.slice)) or views.get(f"({ast.unparse(node.slice)})")
        if kind is None:
            raise ReadingError(f"line {node.lineno}: no view is written {ast.unparse(node)!r}")
        return self._add(kind, self.read(node.value))

    def _call(self, node: ast.Call) -> Operand:
        function = ast.unparse(node.func)
        is_scalar = function.startswith(("_", ELEMENTARY))
        name = function.removeprefix("np.").removeprefix(ELEMENTARY).removeprefix("_")
        keywords = {k.arg: ast.unparse(k.value) for k in node.keywords}
        if name in ("sum", "every") and set(keywords) == {"axis"}:
            count = {"-1": 1, "(-2, -1)": 2}[keywords["axis"]]
            (value,) = node.args
            return self._add("sum" if name == "sum" else "every", self.read(value), count)
        if ast.unparse(node).startswith("np.swapaxes(") and not keywords:
            value, *axes = node.args
            if [ast.unparse(a) for a in axes] == ["-1", "-2"]:
                return self._add("transpose", self.read(value))
        if name == "diagonal" and keywords == {"axis1": "-2", "axis2": "-1"}:
            return self._add("diagonal", self.read(node.args[0]))
        arguments = list(node.args)
        if keywords:
            raise ReadingError(f"line {node.lineno}: no operation is written {ast.unparse(node)!r}")
        constant = None if is_scalar else LAST_CONSTANT.get(name)
        if constant and ast.unparse(arguments.pop()) != constant:
            raise ReadingError(f"line {node.lineno}: {name} takes {LAST_CONSTANT[name]} last")
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
    return Program(inputs, tuple(reader.operations), results).normal_form()


class _KernelReader:
    """Reads one public function and the private ones that it calls."""

    def __init__(self, node: ast.FunctionDef, functions: Mapping[str, ast.FunctionDef]) -> None:
        self._node = node
        self._functions = functions
        self._arguments = tuple(argument.arg for argument in node.args.args)
        self._vectors: list[tuple[str, tuple[str, ...]]] = []
        self._indexed: tuple[tuple[str, int], ...] = ()
        self._inside: Program | None = None
        self._masked: tuple[str, ...] = ()
        self._assigned: list[tuple[str, ast.expr]] = []
        self._stages: list[Stage] = []
        self._shape: tuple[int, ...] = ()
        self._quiet = False

    def read(self) -> KernelCode:
        first, second, *body = self._node.body
        if not isinstance(first, ast.Expr):
            raise ReadingError(f"line {first.lineno}: {self._node.name} has no docstring")
        self._check_conversion(second)
        for statement in body:
            self._read_statement(statement)
        return KernelCode(
            self._node.name,
            self._arguments,
            tuple(self._vectors),
            self._indexed,
            self._inside,
            self._masked,
            tuple(self._stages),
            self._shape,
            self._quiet,
        )

    def _check_conversion(self, statement: ast.stmt) -> None:
        """Require `a, b = as_floats("a b", a, b)` with the arguments in their order."""
        names = ", ".join(self._arguments)
        comma = "," if len(self._arguments) == 1 else ""
        text = f"{names}{comma} = as_floats({' '.join(self._arguments)!r}, {names})"
        expected = ast.unparse(ast.parse(text))
        if ast.unparse(statement) != expected:
            raise ReadingError(f"line {statement.lineno}: expected {expected!r}")

    def _read_statement(self, statement: ast.stmt) -> None:
        match statement:
            case ast.Expr(value=ast.Call(func=ast.Name(id="check_components"), args=args)):
                name, count = ast.literal_eval(args[0]), ast.literal_eval(args[2])
                self._require(statement, ast.unparse(args[1]) == name)
                components = tuple(f"{name}[{i}]" for i in range(count))
                self._vectors.append((name, components))
            case ast.Assign(targets=[target], value=ast.Call(func=ast.Name(id=function)) as call):
                self._read_assignment(statement, target, function, call)
            case ast.Assign(targets=[ast.Name(id="inside")], value=value):
                self._inside = read_program(self._scalars(), (), (value,))
            case ast.Assign(targets=[ast.Name(id=name)], value=value):
                self._assigned.append((name, value))
            case ast.If(test=test, body=[ast.Assign() as inner], orelse=[]):
                self._require(test, ast.unparse(test) == "inside is not True")
                self._require(inner, ast.unparse(inner.value).startswith("nan_outside("))
                self._read_statement(inner)
            case ast.If(test=ast.Call(func=ast.Name(id="holds"), args=[when]), body=[inner]):
                self._read_return(inner, read_program(self._scalars(), (), (when,)))
            case ast.Return():
                self._read_return(statement, None)
            case ast.With(items=[context], body=body):
                self._require(context.context_expr, ast.unparse(context) == "quietly()")
                self._quiet = True
                for inner in body:
                    self._read_statement(inner)
            case _:
                raise ReadingError(f"line {statement.lineno}: no kernel has this statement")

    def _read_assignment(
        self, statement: ast.stmt, target: ast.expr, function: str, call: ast.Call
    ) -> None:
        names = _names(target)
        if function == "split_components":
            name, count = ast.literal_eval(call.args[0]), ast.literal_eval(call.args[2])
            self._require(statement, ast.unparse(call.args[1]) == name and count == len(names))
            self._vectors.append((name, names))
        elif function == "sum_axes":
            pairs = {str(k.arg): _pair(k.value) for k in call.keywords}
            self._require(statement, tuple(pairs) == names)
            self._require(statement, all(given == name for name, (given, _) in pairs.items()))
            self._indexed = tuple((name, count) for name, (_, count) in pairs.items())
        elif function == "nan_outside":
            inside, *values = map(ast.unparse, call.args)
            self._require(statement, inside == "inside" and tuple(values) == names)
            self._masked = names
        elif names == ("inside",):
            self._inside = read_program(self._scalars(), (), (call,))
        else:
            (name,) = names
            self._assigned.append((name, call))

    def _scalars(self) -> tuple[str, ...]:
        """Return the names that a condition may use, vectors by their components."""
        parts = dict(self._vectors)
        return tuple(n for a in self._arguments for n in parts.get(a, (a,)))

    def _read_return(self, statement: ast.stmt, when: Program | None) -> None:
        if not (isinstance(statement, ast.Return) and isinstance(statement.value, ast.Call)):
            raise ReadingError(f"line {statement.lineno}: expected a call to be returned")
        call = statement.value
        keywords = {k.arg: ast.unparse(k.value) for k in call.keywords}
        function = ast.unparse(call.func)
        if function == "store":
            value, out = call.args
            self._require(statement, ast.unparse(out) == "out" and not keywords)
            self._stages.append(self._read_inline(value))
            return
        self._require(statement, keywords.pop("out", None) == "out")
        self._quiet = keywords.pop("quiet", "False") == "True"
        if function == "transform":
            self._require(statement, not keywords)
            self._stages.append(self._read_affine(call, when))
        elif function == "in_blocks":
            self._shape = ast.literal_eval(keywords.pop("shape", "()"))
            self._require(statement, not keywords)
            self._stages.append(self._read_blocks(call, when))
        else:
            raise ReadingError(f"line {statement.lineno}: {function} evaluates no kernel")

    def _read_inline(self, value: ast.expr) -> Stage:
        program = read_program(self._scalars(), self._assigned, (value,))
        return Stage(None, self._scalars(), (), NOTHING, program)

    def _read_affine(self, call: ast.Call, when: Program | None) -> Stage:
        points, prepare, parameters = call.args
        self._require(call, ast.unparse(points) == self._arguments[0])
        (vector,) = (names for name, names in self._vectors if name == self._arguments[0])
        program = self._read_function(ast.unparse(prepare))
        self._shape = (len(vector),)
        return Stage(when, vector, _names(parameters), program, None)

    def _read_blocks(self, call: ast.Call, when: Program | None) -> Stage:
        evaluate, running, *rest = call.args
        program = self._read_function(ast.unparse(evaluate))
        if not rest:
            return Stage(when, _names(running), (), NOTHING, program)
        prepare, parameters = rest
        return Stage(
            when,
            _names(running),
            _names(parameters),
            self._read_function(ast.unparse(prepare)),
            program,
        )

    def _read_function(self, name: str) -> Program:
        node = self._functions[name]
        *body, last = node.body
        assigned = []
        for statement in body:
            if not (isinstance(statement, ast.Assign) and len(statement.targets) == 1):
                raise ReadingError(f"line {statement.lineno}: expected one assignment")
            assigned.append((ast.unparse(statement.targets[0]), statement.value))
        if not isinstance(last, ast.Return) or last.value is None:
            raise ReadingError(f"line {last.lineno}: {name} returns nothing")
        outputs = last.value.elts if isinstance(last.value, ast.Tuple) else [last.value]
        inputs = tuple(argument.arg for argument in node.args.args)
        return read_program(inputs, assigned, outputs)

    def _require(self, node: ast.stmt | ast.expr, condition: bool) -> None:
        if not condition:
            raise ReadingError(f"line {node.lineno}: {self._node.name} {ast.unparse(node)!r}")


def _names(node: ast.expr) -> tuple[str, ...]:
    parts = node.elts if isinstance(node, ast.Tuple) else [node]
    return tuple(map(ast.unparse, parts))


def _pair(node: ast.expr) -> tuple[str, int]:
    name, count = node.elts if isinstance(node, ast.Tuple) else (node, node)
    return ast.unparse(name), int(ast.literal_eval(count))
