"""Regenerate: in, papers; out, the files of the generated package."""

from __future__ import annotations

from collections.abc import Iterable

from mechproof.codegen.backends.numba import render_compiled, render_elementary
from mechproof.codegen.backends.numpy import (
    DERIVATIVES,
    render_derivatives,
    render_init,
    render_modules,
)
from mechproof.codegen.backends.stubs import render_stubs
from mechproof.record import Paper

# Lists the files of the generated package, so that the next run knows what it may replace.
LIST = "mechproof-generated.sha256"


def render_package(papers: Iterable[Paper], *, is_own: bool = False) -> dict[str, str]:
    """Render every file of the generated package, by its name relative to the package.

    Papers without forms have no module. `is_own` says that it is `mechproof.kernels`, where the
    compiled kernels of all packages find the elementary functions.
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
