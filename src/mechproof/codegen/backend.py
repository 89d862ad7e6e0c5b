"""Backend: in, kernels as data; out, formatted source text. Templates hold layout only."""

from __future__ import annotations

import subprocess
import sys
import textwrap
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType

import jinja2
import sympy as sp
from jinja2 import meta

from mechproof.codegen.kernel import CONSTANTS, SUPPORT, build_kernel
from mechproof.codegen.polynomials import Rational, fit_arctangent, fit_tangent
from mechproof.record import Paper

TEMPLATES = Path(__file__).parent / "templates"
LINE_LENGTH = 100


@dataclass(frozen=True)
class Backend:
    """A kind of kernel: the templates of its modules and of its package."""

    name: str
    module: str
    package: str


NUMPY = Backend("NumPy", "numpy_module.py.jinja", "numpy_package.py.jinja")
FITS: Mapping[str, Callable[[], Rational]] = MappingProxyType(
    {"TANGENT": fit_tangent, "ARCTANGENT": fit_arctangent}
)


def render_module(paper: Paper, backend: Backend = NUMPY) -> str:
    """Render the module with the kernels of a paper's quantities."""
    kernels = [build_kernel(quantity, paper) for quantity in paper.quantities]
    data: dict[str, object] = {
        "system": paper.system,
        "citation": textwrap.fill(paper.citation, LINE_LENGTH),
        "conventions": textwrap.fill(paper.conventions, LINE_LENGTH),
        "sympy_version": sp.__version__,
        "kernels": kernels,
        "support": {},
        "constants": [],
    }
    body = render_template(backend.module, data)
    data["support"] = {
        file: used
        for file, names in SUPPORT.items()
        if (used := [name for name in names if f"{name}(" in body])
    }
    data["constants"] = [
        (name, meaning, FITS[name]()) for name, meaning in CONSTANTS.items() if name in body
    ]
    return format_source(render_template(backend.module, data))


def render_init(backend: Backend = NUMPY) -> str:
    """Render the package file."""
    return format_source(render_template(backend.package, {}))


def render_template(name: str, data: Mapping[str, object], folder: Path = TEMPLATES) -> str:
    """Lay out `data`; ValueError unless the template asks for exactly its keys."""
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(folder),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
    )
    text = (folder / name).read_text(encoding="utf-8")
    asked = meta.find_undeclared_variables(environment.parse(text))
    if asked != set(data):
        raise ValueError(f"template {name}: asks for {sorted(asked)}, is given {sorted(data)}")
    return environment.from_string(text).render(data)


def format_source(source: str) -> str:
    """Format with `ruff format`; ValueError with the formatter's message if it is not Python."""
    command = [sys.executable, "-m", "ruff", "format", "--isolated", "--target-version", "py311"]
    arguments = ["--line-length", str(LINE_LENGTH), "--stdin-filename", "kernel.py", "-"]
    done = subprocess.run(
        [*command, *arguments], input=source, capture_output=True, text=True, encoding="utf-8"
    )
    if done.returncode:
        raise ValueError(f"the formatter rejects the generated source: {done.stderr.strip()}")
    return done.stdout
