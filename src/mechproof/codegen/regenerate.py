"""Regenerate: in, papers; out, the files of the generated package.

Types of kernels, which compiled kernels share, are in separate stub files: each function is typed
up to three times, with its arguments by name.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

from mechproof.codegen.backends.numba import render_compiled, render_elementary
from mechproof.codegen.backends.numpy import (
    DERIVATIVES,
    REGENERATED,
    render_derivatives,
    render_init,
    render_modules,
    render_python,
)
from mechproof.programs.kernel import Kernel, list_functions
from mechproof.record import Argument, Paper

SUPPORT: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "builtins": ("float", "tuple"),
        "typing": ("TypeAlias", "overload"),
        "numpy": ("float64",),
        "mechproof.kernel_support.facts": ("Condition", "Sizes"),
    }
)
# Lines of stubs for names other than functions, and for types.
HEADER = (
    "DOMAIN: _tuple[_Condition, ...]",
    "PUBLISHED: _tuple[_Sizes, ...]",
    "_Floats: _TypeAlias = _float | NDArray[_float64]",
)
OUT = "_Out: _TypeAlias = NDArray[Any] | None"
# File that lists the generated files, so that the next run knows which ones it may replace.
LIST = "mechproof-generated.sha256"


class Signature(NamedTuple):
    """The types of all arguments, of `out` if it may be given, and of the result."""

    takes: str
    out: str
    gives: str


# For lists, single precision and other packages' arrays, types do not determine the result's.
ANY = Signature("ArrayLike", "_Out", "Any")
NUMBERS = (
    Signature("_float", "", "_float64"),
    Signature("_Floats", "", "NDArray[_float64]"),
    ANY,
)
ARRAYS = (Signature("ArrayLike", "_Out", "NDArray[Any]"),)


class StubFunction(NamedTuple):
    """A function in a stub: its name, arguments and overloads."""

    name: str
    arguments: tuple[Argument, ...]
    signatures: tuple[Signature, ...]


def render_stubs(paper: Paper) -> dict[str, str]:
    """Render the stubs of a paper's kernels by file name; empty if it has no kernels."""
    kernels = {kernel.name: kernel for kernel in list_functions(paper) if kernel.is_shipped}
    if not kernels:
        return {}
    functions = [_describe(kernel) for kernel in kernels.values()]
    passes = [
        StubFunction(one.name, kernels[one.quantities[0]].quantity.arguments, ARRAYS)
        for one in paper.one_pass
    ]
    system = paper.system
    own = (OUT,) if passes else ()
    return {
        f"{system}.pyi": _render(system, functions, header=(*HEADER, OUT)),
        f"compiled/{system}.pyi": _render(system, passes, header=own, beside=system),
    }


def _describe(kernel: Kernel) -> StubFunction:
    # A sum over all axes is a number; one over the last of several is an array.
    of_one = (ANY,) if kernel.code.axes else NUMBERS
    return StubFunction(
        kernel.name, kernel.quantity.arguments, ARRAYS if kernel.code.shape else of_one
    )


def _render(
    system: str, functions: Sequence[StubFunction], *, header: Sequence[str], beside: str = ""
) -> str:
    """Render a stub, which also takes over everything in the stub of `beside`, if given."""
    data: dict[str, object] = {
        "docstring": (f"Types of the kernels of `{system}`.", "", REGENERATED),
        "header": header,
        "beside": beside,
        "functions": functions,
    }
    return render_python("stub.pyi.jinja", data, SUPPORT)


def render_package(papers: Iterable[Paper], *, is_own: bool = False) -> dict[str, str]:
    """Render every file of the generated package, by its name relative to the package.

    Papers without forms have no module. `is_own` marks `mechproof.kernels`, where the compiled
    kernels of all packages find the elementary functions.
    """
    files = {
        name: text
        for paper in papers
        for render in (render_modules, render_stubs, render_derivatives, render_compiled)
        for name, text in render(paper).items()
    }
    if any(name.startswith(DERIVATIVES) for name in files):
        text = "Derivatives of the kernels: one module per system."
        files[f"{DERIVATIVES}__init__.py"] = render_init(text)
    return {
        "__init__.py": render_init("Generated kernels: one module per system."),
        "forms/__init__.py": render_init("Other forms of the kernels: one module per system."),
        "compiled/__init__.py": render_init("Compiled kernels: one module per system."),
        **({"compiled/elementary.py": render_elementary()} if is_own else {}),
        **dict(sorted(files.items())),
    }
