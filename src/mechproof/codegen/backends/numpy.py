"""NumPy backend: in, a paper; out, formatted source. Templates only have the layout."""

from __future__ import annotations

import subprocess
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from importlib.util import find_spec
from pathlib import Path
from types import MappingProxyType

import jinja2
import sympy as sp
from jinja2 import meta

from mechproof.codegen.condition_outputs import split_conditions
from mechproof.codegen.docstrings import (
    ESCAPES,
    describe_derivatives,
    describe_derivatives_module,
    describe_kernel,
    describe_module,
)
from mechproof.codegen.formula_text import chain_relations, write_formula
from mechproof.codegen.languages import NUMPY, NUMPY_BODY
from mechproof.codegen.syntax import ProgramText, write_program
from mechproof.programs.argument_conditions import checked_relations
from mechproof.programs.evaluation import input_symbols
from mechproof.programs.kernel import Kernel, input_names, list_functions
from mechproof.programs.lowering import lower_conditions
from mechproof.programs.operations import KINDS, Support
from mechproof.programs.program import NOTHING, Stage, list_suffixes, name_functions
from mechproof.programs.reverse_mode import differentiate
from mechproof.programs.step_names import list_imports
from mechproof.record import Form, Paper, Toleranced
from mechproof.record.relations import find_slack

TEMPLATES = Path(__file__).parents[1] / "templates"
LINE_LENGTH = 100
# Folder of the forms that are not shipped.
FORMS = "forms/"
# Folder of the partial derivatives of kernels.
DERIVATIVES = "derivatives/"
REGENERATED = "Regenerate with `mechproof regenerate`, which refuses to overwrite edits."
# Names that modules import besides those of operations.
_FRAME: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "arrays": ("as_floats", "check_components", "split_components", "sum_axes"),
        "blocks": ("in_blocks", "quietly", "store", "transform"),
        "domains": ("holds", "nan_outside"),
        "facts": ("Condition", "Sizes"),
    }
)


def _list_support() -> dict[str, tuple[str, ...]]:
    """Return the names that modules may import, by module of the support package or of Python."""
    offered = {module: {*names} for module, names in _FRAME.items()}
    for row in KINDS.values():
        if isinstance(row.numpy, Support):
            offered.setdefault(row.numpy.module, set()).add(row.numpy.name)
    found = {f"mechproof.kernel_support.{m}": tuple(sorted(names)) for m, names in offered.items()}
    return {"builtins": ("abs",), **dict(sorted(found.items()))}


SUPPORT: Mapping[str, tuple[str, ...]] = MappingProxyType(_list_support())


@dataclass(frozen=True)
class StageText:
    """The texts of a stage."""

    form: Form
    operations: int
    suffix: str
    when: str
    code: Stage
    prepare: ProgramText
    evaluate: ProgramText


@dataclass(frozen=True)
class KernelText:
    """The texts of a kernel."""

    kernel: Kernel
    docstring: tuple[str, ...]
    conditions: tuple[str, ...]
    stages: tuple[StageText, ...]


def render_modules(paper: Paper) -> dict[str, str]:
    """Render the modules of a paper by file name: its kernels, and their rival forms."""
    system, functions = paper.system, list_functions(paper)
    kernels = tuple(f for f in functions if f.is_shipped)
    rivals = tuple(f for f in functions if not f.is_shipped)
    modules: dict[str, str] = {}
    if kernels:
        facts = list_conditions(paper), list_sizes(paper)
        text = describe_module(paper, f"Kernels of the system `{system}`.", kernels)
        modules[f"{system}.py"] = _render(paper, text, kernels, *facts)
    if rivals:
        text = describe_module(paper, f"Other forms of the kernels of `{system}`.", rivals)
        modules[f"{FORMS}{system}.py"] = _render(paper, text, rivals, (), ())
    return modules


def render_derivatives(paper: Paper) -> dict[str, str]:
    """Render the module of a paper's derivatives by file name; empty if it has none."""
    kernels = list_functions(differentiate(paper))
    if not kernels:
        return {}
    lines = (*describe_derivatives_module(paper), *describe_origin(paper.system))
    texts = [write_kernel(kernel, describe_derivatives(kernel)) for kernel in kernels]
    return {f"{DERIVATIVES}{paper.system}.py": render_module(lines, texts)}


def _render(
    paper: Paper,
    docstring: tuple[str, ...],
    kernels: tuple[Kernel, ...],
    conditions: tuple[ConditionText, ...],
    sizes: tuple[SizesText, ...],
) -> str:
    lines = (*docstring, *describe_origin(paper.system))
    texts = [write_kernel(kernel, describe_kernel(kernel, paper)) for kernel in kernels]
    return render_module(lines, texts, conditions, sizes)


def describe_origin(system: str) -> tuple[str, ...]:
    """Return the lines that state what a module is generated from, and how."""
    return (
        f"Generated from the derivation {system} with SymPy {sp.__version__}.",
        REGENERATED,
    )


def render_module(
    docstring: Sequence[str],
    kernels: Sequence[KernelText],
    conditions: tuple[ConditionText, ...] = (),
    sizes: tuple[SizesText, ...] = (),
) -> str:
    """Render a module of kernels."""
    data: dict[str, object] = {
        "docstring": docstring,
        "kernels": kernels,
        "conditions": conditions,
        "sizes": sizes,
        "functions": name_functions(text.kernel.code for text in kernels),
    }
    return render_python("numpy_module.py.jinja", data, SUPPORT)


def render_python(
    name: str, data: Mapping[str, object], support: Mapping[str, tuple[str, ...]]
) -> str:
    """Render and format a Python module, importing the support functions that its body uses."""
    body = render_template(name, {**data, "imports": []})
    imports = list_imports(body, support)
    kind = name.removesuffix(".jinja")
    return format_source(render_template(name, {**data, "imports": imports}), kind)


def write_kernel(kernel: Kernel, docstring: tuple[str, ...]) -> KernelText:
    """Return the texts of a kernel."""
    code, stages = kernel.code, []
    counts = kernel.forms, code.stages, code.count_operations(), list_suffixes(code)
    for form, stage, operations, suffix in zip(*counts, strict=True):
        stages.append(
            StageText(
                form,
                operations,
                suffix,
                "".join(write_program(stage.when or NOTHING, NUMPY_BODY).outputs),
                stage,
                write_program(stage.prepare, NUMPY_BODY),
                write_program(stage.evaluate or NOTHING, NUMPY_BODY),
            )
        )
    inside = split_conditions(code.inside) if code.inside else NOTHING
    return KernelText(kernel, docstring, write_program(inside, NUMPY_BODY).outputs, tuple(stages))


def render_init(text: str) -> str:
    """Render the `__init__.py` of a package."""
    docstring = text, "", REGENERATED
    return format_source(render_template("numpy_package.py.jinja", {"docstring": docstring}))


def render_template(name: str, data: Mapping[str, object], folder: Path = TEMPLATES) -> str:
    """Render a template with `data`; ValueError unless the template uses exactly its keys."""
    asked, template = _compile((folder / name).read_text(encoding="utf-8"), folder)
    if asked != set(data):
        raise ValueError(f"template {name} asks for {sorted(asked)}, but is given {sorted(data)}")
    return template.render(data)


# Cached, because a few templates render all modules of all papers.
@lru_cache(maxsize=32)
def _compile(text: str, folder: Path) -> tuple[set[str], jinja2.Template]:
    """Return a template's variables, and the template, which may include others in its folder."""
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(folder),
        # Without this, a misspelt name would be rendered as nothing.
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
    )
    environment.filters.update(ESCAPES)
    asked = meta.find_undeclared_variables(environment.parse(text))
    return asked, environment.from_string(text)


def tidy(text: str, after: tuple[str, ...] = ("",)) -> str:
    """Strip trailing blanks; keep only single blank lines, after lines that end as in `after`."""
    lines = [""]
    for line in map(str.rstrip, text.splitlines()):
        if line or (lines[-1] and lines[-1].endswith(after)):
            lines.append(line)
    return "\n".join(lines).strip() + "\n"


def format_source(source: str, name: str = "kernel.py") -> str:
    """Format Python source with `ruff format`; unchanged if ruff, needed only here, is missing.

    The suffix of the name tells a module from a stub.
    Raises ValueError with the formatter's message if the source is not Python.
    """
    if find_spec("ruff") is None:
        return source
    # Runs ruff's binary directly: starting it through Python takes ten times as long.
    from ruff.__main__ import find_ruff_bin

    # Isolated, because settings in one of the user's folders would change the bytes.
    command = [find_ruff_bin(), "format", "--isolated", "--target-version", "py311"]
    arguments = ["--line-length", str(LINE_LENGTH), "--stdin-filename", name, "-"]
    done = subprocess.run(
        [*command, *arguments], input=source, capture_output=True, text=True, encoding="utf-8"
    )
    if done.returncode:
        raise ValueError(f"the formatter rejects the generated source: {done.stderr.strip()}")
    return done.stdout


@dataclass(frozen=True)
class ConditionText:
    """The texts of a condition: the parameter to blame, a description, names, the test."""

    parameter: str
    text: str
    names: tuple[str, ...]
    test: str
    quantities: tuple[str, ...]


@dataclass(frozen=True)
class SizesText:
    """Published sizes to print: doubles, with limit deviations if there are any."""

    source: str
    sizes: tuple[tuple[str, float | tuple[float, float, float]], ...]
    marks: tuple[str, ...]


def list_conditions(paper: Paper) -> tuple[ConditionText, ...]:
    """List the conditions on parameters, each once, with the quantities that need it."""
    needed: dict[tuple[tuple[str, ...], tuple[sp.Basic, ...]], list[str]] = {}
    for quantity in paper.quantities:
        names = input_names(quantity)
        grouped: dict[tuple[str, ...], list[sp.Basic]] = {}
        for relation in checked_relations(quantity, paper):
            used = {names[s] for s in input_symbols(relation)}
            if relation.has(sp.Indexed):
                continue
            grouped.setdefault(tuple(n for n in names.values() if n in used), []).append(relation)
        for key, relations in grouped.items():
            needed.setdefault((key, tuple(relations)), []).append(quantity.name)
    spelled = {s: n for q in paper.quantities for s, n in input_names(q).items()}
    return tuple(
        _describe(names, relations, tuple(quantities), spelled)
        for (names, relations), quantities in needed.items()
    )


def _describe(
    names: tuple[str, ...],
    relations: tuple[sp.Basic, ...],
    quantities: tuple[str, ...],
    spelled: dict[sp.Basic, str],
) -> ConditionText:
    text = ", ".join(chain_relations([write_formula(r, spelled) for r in relations]))
    (test,) = write_program(lower_conditions(spelled, names, relations), NUMPY).outputs
    is_order = len(names) > 1 and find_slack(relations[0]) is not None
    smaller = relations[0].lts.free_symbols if is_order else set()
    blamed = sorted(spelled[s] for s in smaller) or list(names)
    return ConditionText(blamed[0], text, names, test, quantities)


def list_sizes(paper: Paper) -> tuple[SizesText, ...]:
    """List the published sizes by the names of the kernels' arguments, rounded once to doubles."""
    spelled = {s: n for q in paper.quantities for s, n in input_names(q).items()}
    return tuple(
        SizesText(
            published.source,
            tuple(
                (spelled[s], _round(size)) for s, size in published.sizes.items() if s in spelled
            ),
            published.marks,
        )
        for published in paper.published
    )


def _round(size: sp.Expr | Toleranced) -> float | tuple[float, float, float]:
    if isinstance(size, Toleranced):
        nominal, upper, lower = (float(sp.N(v, 40)) for v in (size.nominal, size.upper, size.lower))
        return nominal, upper, lower
    return float(sp.N(size, 40))
