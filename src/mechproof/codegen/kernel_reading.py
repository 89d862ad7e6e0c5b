"""Reading of kernels: in, the emitted source of a module; out, the code of its kernels."""

from __future__ import annotations

import ast
from collections.abc import Mapping
from dataclasses import replace

from mechproof.codegen.conditions import join_conditions
from mechproof.codegen.frame import check_frame
from mechproof.codegen.reading import ReadingError, list_names, read_program
from mechproof.programs.code import KernelCode, Stage
from mechproof.programs.program import NOTHING, Program


def read_module(source: str) -> dict[str, KernelCode]:
    """Return the code of every public function of a generated module.

    Raises `ReadingError` with the line for what no kernel has.
    """
    check_frame(source)
    functions = {
        node.name: node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef)
    }
    public = {
        name: node
        for name, node in functions.items()
        if not name.startswith("_") and any(arg.arg == "out" for arg in node.args.kwonlyargs)
    }
    return {name: _KernelReader(node, functions).read() for name, node in public.items()}


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
        for statement in body:
            self._read_statement(statement)
        code = KernelCode(
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
        self._check_conversion(second, code.axes)
        return code

    def _check_conversion(self, statement: ast.stmt, axes: tuple[int, ...]) -> None:
        """Require `a, b = _as_floats("a b", a, b)` with the arguments in their order, and axes."""
        names = ", ".join(self._arguments)
        comma = "," if len(self._arguments) == 1 else ""
        last = f", axes={axes}" if axes else ""
        text = f"{names}{comma} = _as_floats({' '.join(self._arguments)!r}, {names}{last})"
        expected = ast.unparse(ast.parse(text))
        if ast.unparse(statement) != expected:
            raise ReadingError(f"line {statement.lineno}: expected {expected!r}")

    def _read_statement(self, statement: ast.stmt) -> None:
        match statement:
            case ast.Expr(value=ast.Call(func=ast.Name(id="_check_components"), args=args)):
                name, count = ast.literal_eval(args[0]), ast.literal_eval(args[2])
                self._require(statement, ast.unparse(args[1]) == name)
                components = tuple(f"{name}[{i}]" for i in range(count))
                self._vectors.append((name, components))
            case ast.Assign(targets=[target], value=ast.Call(func=ast.Name(id=function)) as call):
                self._read_assignment(statement, target, function, call)
            case ast.Assign(targets=[ast.Name(id=name)], value=value):
                self._assigned.append((name, value))
            case ast.If(test=ast.Call(func=ast.Name(id="_holds"), args=[when]), body=[inner]):
                self._read_return(inner, read_program(self._scalars(), (), (when,)))
            case ast.Return():
                self._read_return(statement, None)
            case ast.With(items=[context], body=body):
                self._require(context.context_expr, ast.unparse(context) == "_quietly()")
                self._quiet = True
                for inner in body:
                    self._read_statement(inner)
            case _:
                raise ReadingError(f"line {statement.lineno}: no kernel has this statement")

    def _read_assignment(
        self, statement: ast.stmt, target: ast.expr, function: str, call: ast.Call
    ) -> None:
        names = list_names(target)
        if function in ("_split_components", "_sum_axes"):
            self._require(statement, self._inside is None)
        if function == "_split_components":
            name, count = ast.literal_eval(call.args[0]), ast.literal_eval(call.args[2])
            self._require(statement, ast.unparse(call.args[1]) == name and count == len(names))
            self._vectors.append((name, names))
        elif function == "_sum_axes":
            pairs = {str(k.arg): _pair(k.value) for k in call.keywords}
            self._require(statement, tuple(pairs) == names)
            self._require(statement, all(given == name for name, (given, _) in pairs.items()))
            self._indexed = tuple((name, count) for name, (_, count) in pairs.items())
        elif function == "_nan_outside":
            self._read_check(statement, names, call)
        else:
            (name,) = names
            self._assigned.append((name, call))

    def _read_check(self, statement: ast.stmt, names: tuple[str, ...], call: ast.Call) -> None:
        """Read the conditions of a function: its parameters are the names, terms of sums last."""
        check, *values = map(ast.unparse, call.args)
        terms = {k.arg: list_names(k.value) for k in call.keywords}
        self._require(statement, tuple(values) == names and set(terms) <= {"terms"})
        self._require(statement, self._inside is None and not self._assigned and not self._stages)
        conditions = self._read_function(check, as_tuple=True)
        made = {step.result for step in conditions.operations}
        self._require(statement, bool(made) and made.issuperset(conditions.outputs))
        self._require(statement, conditions.inputs == names + terms.get("terms", ()))
        self._inside = join_conditions(replace(conditions, inputs=self._scalars()))
        self._masked = names

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
        if function == "_store":
            value, out = call.args
            self._require(statement, ast.unparse(out) == "out" and not keywords)
            self._stages.append(self._read_inline(value))
            return
        self._require(statement, keywords.pop("out", None) == "out")
        self._quiet = keywords.pop("quiet", "False") == "True"
        if function == "_transform":
            self._require(statement, not keywords)
            self._stages.append(self._read_affine(call, when))
        elif function == "_in_blocks":
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
        self._require(call, not self._assigned)
        self._require(call, ast.unparse(points) == self._arguments[0])
        (vector,) = (names for name, names in self._vectors if name == self._arguments[0])
        program = self._read_function(ast.unparse(prepare))
        self._shape = (len(vector),)
        return Stage(when, vector, list_names(parameters), program, None)

    def _read_blocks(self, call: ast.Call, when: Program | None) -> Stage:
        evaluate, running, *rest = call.args
        self._require(call, not self._assigned)
        program = self._read_function(ast.unparse(evaluate))
        if not rest:
            return Stage(when, list_names(running), (), NOTHING, program)
        prepare, parameters = rest
        return Stage(
            when,
            list_names(running),
            list_names(parameters),
            self._read_function(ast.unparse(prepare)),
            program,
        )

    def _read_function(self, name: str, *, as_tuple: bool = False) -> Program:
        node = self._functions[name]
        inputs = tuple(argument.arg for argument in node.args.args)
        if node.decorator_list or ast.unparse(node.args) != ": Any, ".join(inputs) + ": Any":
            raise ReadingError(f"line {node.lineno}: {name} takes more than its inputs")
        *body, last = node.body
        assigned = []
        for statement in body:
            if not (isinstance(statement, ast.Assign) and len(statement.targets) == 1):
                raise ReadingError(f"line {statement.lineno}: expected one assignment")
            assigned.append((ast.unparse(statement.targets[0]), statement.value))
        if not isinstance(last, ast.Return) or last.value is None:
            raise ReadingError(f"line {last.lineno}: {name} returns nothing")
        self._require(last, isinstance(last.value, ast.Tuple) or not as_tuple)
        outputs = last.value.elts if isinstance(last.value, ast.Tuple) else [last.value]
        return read_program(inputs, assigned, outputs)

    def _require(self, node: ast.stmt | ast.expr, condition: bool) -> None:
        if not condition:
            raise ReadingError(f"line {node.lineno}: {self._node.name} {ast.unparse(node)!r}")


def _pair(node: ast.expr) -> tuple[str, int]:
    name, count = node.elts if isinstance(node, ast.Tuple) else (node, node)
    return ast.unparse(name), int(ast.literal_eval(count))
