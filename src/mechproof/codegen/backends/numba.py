"""numba backend: in, a paper; out, formatted source of compiled kernels."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import sympy as sp

from mechproof.codegen.backends.numpy import format_source, render_template
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
    "maximum", "overload", "rint", "run", "scalar", "take_row",
)  # fmt: skip


def render_compiled(paper: Paper) -> dict[str, str]:
    """Render the compiled kernels of a paper by the name of their file, empty without any."""
    kernels = list_scalars(paper)
    if not kernels:
        return {}
    data: dict[str, object] = {
        "system": paper.system,
        "sympy_version": sp.__version__,
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
    return {f"compiled/{paper.system}.py": source}


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
