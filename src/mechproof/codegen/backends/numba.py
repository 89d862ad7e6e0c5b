"""numba backend: in, a paper; out, formatted source of compiled kernels."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from mechproof.codegen.backends.numpy import format_source, render_template, tell_origin
from mechproof.codegen.backends.scalar import (
    list_conditions,
    list_elementary,
    list_scalars,
    list_stages,
    write_elementary,
    write_scalar,
)
from mechproof.codegen.elementary.formats import DOUBLE
from mechproof.codegen.elementary.functions import build
from mechproof.codegen.kernel import Kernel
from mechproof.codegen.languages import NUMBA, NUMBA_FAR
from mechproof.codegen.program import NOTHING
from mechproof.codegen.reading import TranslationError, read_guards, read_scalars
from mechproof.record import Paper

SUPPORT = (
    "BLOCK", "Loops", "choose", "copysign", "floor", "fma", "has_nan", "is_finite", "loop",
    "maximum", "overload", "rint", "run", "scalar", "take_row", "widen",
)  # fmt: skip


def render_compiled(paper: Paper) -> dict[str, str]:
    """Render the compiled kernels of a paper by the name of their file, empty without any."""
    kernels = list_scalars(paper)
    if not kernels:
        return {}
    docstring = (*_describe(paper.system), *tell_origin(paper.system))
    return {f"compiled/{paper.system}.py": render_scalars(paper.system, docstring, kernels)}


def _describe(system: str) -> tuple[str, ...]:
    return (
        f"Compiled kernels of the system `{system}`: one loop for each, by numba.",
        "",
        f"Names, arguments, domains, NaN and errors are those of `mechproof.kernels.{system}`,",
        "and so are the formulas. Numbers and NumPy arrays are taken. With numbers,",
        "kernels can be called inside functions that numba compiles; arguments with components "
        "are then",
        "indexed, and so are results.",
        "",
        "Tests hold them to the same accuracy bounds. What help says is proved of rounding errors "
        "is proved",
        "of the NumPy kernels alone.",
        "",
        f"Angles up to {DOUBLE.largest} rad are reduced here; farther out the C library's "
        "functions are taken.",
        "",
    )


def render_scalars(system: str, docstring: Sequence[str], kernels: Sequence[Kernel]) -> str:
    """Render a module of kernels and read it back."""
    data: dict[str, object] = {
        "system": system,
        "docstring": docstring,
        "largest": DOUBLE.largest,
        "support": SUPPORT,
        "numpy": [],
        "functions": [
            write_elementary(kind, DOUBLE, NUMBA, NUMBA_FAR) for kind in list_elementary(kernels)
        ],
        "kernels": [write_scalar(kernel, NUMBA) for kernel in kernels],
    }
    # What the body names is imported.
    _, _, used = render_template("numba_module.py.jinja", data).partition("__all__")
    data["support"] = tuple(name for name in SUPPORT if name in used)
    data["numpy"] = [
        *(["import numpy as np"] if "np." in used else []),
        *(["from numpy import float64, ndarray"] if "float64(" in used else []),
    ]
    source = format_source(render_template("numba_module.py.jinja", data))
    check_translation(source, kernels)
    return source


def check_translation(source: str, kernels: Iterable[Kernel]) -> None:
    """Read the functions of a module back; `TranslationError` where one is not its program."""
    read = read_scalars(source)
    meant = {f"_{kind}": build(kind, DOUBLE).program for kind in list_elementary(kernels)}
    for kernel in kernels:
        for name, stage in list_stages(kernel):
            meant[f"_prepare{name}"] = stage.prepare
            meant[name] = stage.evaluate or NOTHING
    for name, program in meant.items():
        if program != NOTHING and read.get(name) != program:
            raise TranslationError(f"{name}: meant {program}, read {read.get(name)}")
    guards = read_guards(source)
    for kernel in kernels:
        name, taken = f"_{kernel.name}_at", write_scalar(kernel, NUMBA).taken_names
        conditions = tuple(replace(c, inputs=taken) for c in list_conditions(kernel))
        if guards.get(name) != conditions:
            raise TranslationError(f"{name}: meant {conditions}, read {guards.get(name)}")
