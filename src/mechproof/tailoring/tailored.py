"""Kernels: in, a model; out, a function printed by a backend and loaded, with its properties."""

from __future__ import annotations

import pickle
import sys
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from hashlib import sha256
from importlib.util import find_spec
from pathlib import Path
from tempfile import mkdtemp
from types import ModuleType
from typing import Any

import sympy as sp
from numpy.typing import ArrayLike, NDArray

from mechproof.arguments.scalars import require
from mechproof.codegen.backends.c99 import render_c_kernels
from mechproof.codegen.backends.numba import render_scalars
from mechproof.codegen.backends.numpy import render_module, write_kernel
from mechproof.codegen.c_names import WORDS
from mechproof.codegen.docstrings import show_formula
from mechproof.codegen.kernel_reading import check_module
from mechproof.programs.kernel import Kernel
from mechproof.programs.program import NOTHING, KernelCode, Stage, unfuse
from mechproof.record import Form
from mechproof.tailoring.build import Built, round_up
from mechproof.tailoring.model import Model
from mechproof.tailoring.receiving import receive
from mechproof.tailoring.request import Request
from mechproof.tools.cache import cache_folder
from mechproof.tools.files import import_file, write_whole

NUMBA, NUMPY = "numba", "NumPy"
# Length to which every C99 compiler distinguishes names.
LONGEST = 63


@dataclass(frozen=True, repr=False)
class Tailored:
    """A quantity as a function of its running variable, at fixed parameters.

    It takes a number or an array, and `out`, as all kernels do. The result is NaN outside `low` to
    `high` and where the argument is NaN. `bound` is proved: no result at a double in the range is
    off by more, in the unit of the quantity, rounding included. `asked` is the error asked for.
    `degrees` are those of the polynomials between `edges`, in the variable less whole periods, or
    in its absolute value. `function` is the function called; with numba, compiled functions can
    call it, too. A pickled kernel is printed and loaded again where it is unpickled, from the same
    numbers for the same backend.
    """

    name: str
    parameters: Mapping[str, float] = field(hash=False)
    variable: str
    low: float
    high: float
    unit: str
    asked: float
    bound: float
    degrees: tuple[int, ...]
    edges: tuple[float, ...]
    operations: int
    backend: str
    function: Any
    _request: Request = field(compare=False)
    _built: Built = field(compare=False)

    def __call__(self, points: ArrayLike, *, out: NDArray[Any] | None = None) -> Any:
        """Return the values at `points`, in `out` if given."""
        return self.function(points, out=out)

    def __reduce__(self) -> tuple[Any, ...]:
        # `receive` names a missing extra before this module is imported.
        made_by = make_kernel, self._request, self._built, self.backend
        return receive, (self.backend, pickle.dumps(made_by))

    def __repr__(self) -> str:
        sizes = ", ".join(f"{name}={value!r}" for name, value in self.parameters.items())
        degrees = ", ".join(map(str, self.degrees))
        return (
            f"<{self.name}({self.variable}; {sizes}): {_describe_bound(self)}, degrees {degrees}, "
            f"{self.operations} operations, {self.backend}>"
        )

    def write_c(self, folder: str | Path, *, name: str | None = None) -> tuple[Path, ...]:
        """Write a header and a source file in C99 into a folder, and return their paths.

        `name`, by default <system>_tailored, names the files and precedes the quantity in function
        names. Raises TypeError if it is not a string, ValueError if not a C identifier, and
        FileExistsError if a file of that name exists with other content.
        """
        called = f"{self.name.partition('.')[0]}_tailored" if name is None else name
        require(isinstance(called, str), "name", name, "must be a string", TypeError)
        is_name = called.isidentifier() and called.isascii() and called not in WORDS
        require(is_name and called[0] != "_", "name", name, "must be a valid C identifier")
        require(len(called) <= LONGEST, "name", name, f"must have at most {LONGEST} characters")
        files = _render_c(self._request, self._built.model, called, _describe_bound(self))
        texts = {Path(folder) / file: text for file, text in files.items()}
        for file, text in texts.items():
            if file.exists() and file.read_bytes() != text.encode():
                raise FileExistsError(f"{file} exists with other content")
        for file, text in texts.items():
            write_whole(file, text)
        return tuple(texts)


def _describe_bound(kernel: Tailored) -> str:
    unit = "" if kernel.unit == "1" else f" {kernel.unit}"
    return (
        f"|error| <= {round_up(kernel.bound)}{unit} for "
        f"{kernel.low:.9g} <= {kernel.variable} <= {kernel.high:.9g}"
    )


def make_kernel(request: Request, built: Built, backend: str | None = None) -> Tailored:
    """Print, read back and load the kernel of a model, with numba if it is installed."""
    model = built.model
    chosen = backend or (NUMBA if find_spec("numba") else NUMPY)
    function = _load(request, model, chosen, built.bound.error)
    return Tailored(
        name=request.name,
        parameters=request.values,
        variable=request.variable,
        low=model.low,
        high=model.high,
        unit=request.quantity.unit,
        asked=request.error,
        bound=built.bound.error,
        degrees=model.pieces.degrees,
        edges=model.pieces.edges,
        operations=model.program().count_operations(),
        backend=chosen,
        function=function,
        _request=request,
        _built=built,
    )


def _wrap(request: Request, model: Model, *, fused: bool) -> Kernel:
    """Return a model as the kernel of a quantity without parameters; its range is its domain."""
    quantity = request.quantity
    program = model.program() if fused else unfuse(model.program())
    first = quantity.arguments[0]
    form = Form("tailored", sp.S.Zero)
    alone = replace(
        quantity, arguments=(first,), forms=(form,), accuracy=None, singular=(), workloads=()
    )
    code = KernelCode(
        name=quantity.name,
        arguments=(first.name,),
        vectors=(),
        indexed=(),
        inside=model.inside(),
        masked=(first.name,),
        stages=(Stage(None, (first.name,), (), NOTHING, program),),
        shape=(),
        quiet=True,
    )
    digest = sha256(repr(program).encode()).hexdigest()
    return Kernel(quantity.name, alone, (form,), digest, code, ((),))


def _describe(request: Request, bound: float) -> tuple[str, ...]:
    sizes = ", ".join(f"{name} = {value!r}" for name, value in request.values.items())
    return (
        f"`{request.name}` tailored to {sizes}: off by at most {round_up(bound)}.",
        "",
        f"Generated from the derivation {request.paper.system} by `mechproof.tailor`.",
    )


def _load(request: Request, model: Model, backend: str, bound: float) -> Any:
    """Return the function of a module printed into the cache folder and read back."""
    docstring = _describe(request, bound)
    if backend == NUMBA:
        kernel = _wrap(request, model, fused=True)
        source = render_scalars(request.paper.system, docstring, [kernel])
    else:
        kernel = _wrap(request, model, fused=False)
        text = write_kernel(kernel, (request.quantity.summary,))
        source = render_module(docstring, [text])
        check_module(source, [kernel])
    return getattr(_import(source), request.quantity.name)


def _import(source: str) -> ModuleType:
    """Import source code from a file, next to which numba caches compiled code."""
    name = f"mechproof_tailored_{sha256(source.encode()).hexdigest()[:16]}"
    known = sys.modules.get(name)
    return import_file(name, _keep(name, source)) if known is None else known


def _keep(name: str, source: str) -> Path:
    """Write source code to the cache folder or, if that fails, to a new folder."""
    file = cache_folder() / "tailored" / f"{name}.py"
    try:
        if not file.is_file() or file.read_text(encoding="utf-8") != source:
            write_whole(file, source)
    except OSError:
        file = Path(mkdtemp(prefix="mechproof-")) / file.name
        write_whole(file, source)
    return file


def _render_c(request: Request, model: Model, called: str, accuracy: str) -> dict[str, str]:
    sizes = ", ".join(f"{name} = {value!r}" for name, value in request.values.items())
    about = (
        f"Tailored to {sizes}.",
        f"{accuracy}, proved, roundings included.",
        request.paper.system,
    )
    kernel = _wrap(request, model, fused=True)
    domain = f"Domain: {model.low:.17g} <= {request.variable} <= {model.high:.17g}."
    notes = {kernel.name: [*show_formula(kernel, request.paper), "", domain]}
    return render_c_kernels(called, [kernel], about, notes)
