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

from mechproof.codegen.error_free import EXACT, SmallArctan, TangentQuotient
from mechproof.codegen.evaluation import arrange
from mechproof.codegen.kernel import SUPPORT, build_kernel
from mechproof.codegen.numpy_printer import NumpyPrinter
from mechproof.codegen.polynomials import fit_arctangent, fit_tangent, split_pi
from mechproof.codegen.subexpressions import share_subexpressions
from mechproof.record import Paper

TEMPLATES = Path(__file__).parent / "templates"
LINE_LENGTH = 100


@dataclass(frozen=True)
class Backend:
    """A kind of kernel: the templates of its modules, of their support files, of its package."""

    name: str
    module: str
    support: Mapping[str, str]
    package: str


NUMPY = Backend(
    "NumPy",
    "numpy_module.py.jinja",
    {"_arrays": "numpy_arrays.py.jinja", "_polynomials": "numpy_polynomials.py.jinja"},
    "numpy_package.py.jinja",
)
# What the templates of the support files ask for.
SUPPORT_DATA: Mapping[str, Callable[[], dict[str, object]]] = MappingProxyType(
    {
        "_arrays": dict,
        "_polynomials": lambda: {
            "pi": split_pi(),
            "tangent": fit_tangent(),
            "arctangent": fit_arctangent(),
            "plain_quotient": print_plainly(TangentQuotient, "y a b"),
            "plain_arctan": print_plainly(SmallArctan, "y"),
        },
    }
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
    }
    body = render_template(backend.module, data)
    data["support"] = {
        file: used
        for file, names in SUPPORT.items()
        if (used := [name for name in names if f"{name}(" in body])
    }
    return format_source(render_template(backend.module, data))


def render_support(backend: Backend = NUMPY) -> dict[str, str]:
    """Render the files that the kernels share, under their names."""
    return {
        f"{file}.py": format_source(render_template(template, SUPPORT_DATA[file]()))
        for file, template in backend.support.items()
    }


def print_plainly(function: type[sp.Function], names: str) -> dict[str, object]:
    """Print what a function is exactly: the steps that occur twice, and the value."""
    arguments = sp.symbols(names, real=True, seq=True)
    evaluation = arrange(frozenset(arguments), (), EXACT[function](*arguments))
    printer = NumpyPrinter({}, frozenset())
    shared = share_subexpressions(evaluation)
    steps = [(str(s), printer.print_expression(value)) for s, value in shared.steps]
    return {"steps": steps, "value": printer.print_expression(shared.output)}


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
