"""numba backend: in, a paper; out, formatted source of compiled kernels."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from hashlib import sha256
from pathlib import Path
from types import MappingProxyType

from mechproof.codegen.backends.compiled_reading import (
    mean_compiled,
    mean_elementary,
    read_compiled,
)
from mechproof.codegen.backends.loopless_kernels import (
    describe_calls,
    name_elements,
    take_out_loops,
)
from mechproof.codegen.backends.numpy import REGENERATED, describe_origin, render_python
from mechproof.codegen.backends.scalar_texts import (
    ScalarKernel,
    extend_syntax,
    join_scalars,
    write_elementary,
    write_reduction,
    write_scalar,
)
from mechproof.codegen.languages import ELEMENTARY, NUMBA, NUMBA_FAR
from mechproof.codegen.source_reading import compare
from mechproof.codegen.syntax import Syntax
from mechproof.programs.elementary.formats import DOUBLE
from mechproof.programs.elementary.function_programs import BODIES
from mechproof.programs.kernel import Kernel
from mechproof.programs.operations import KINDS
from mechproof.programs.scalar import LOOPS, TermLoop, fold_sums, list_scalars
from mechproof.record import OnePass, Paper

# Names that modules use besides those of operations.
_FRAME = (
    *("Loops", "Sums", "add_up", "count_terms", "element", "every", "fill", "fill_blocks"),
    *("fill_sets", "loop", "point_of", "run", "run_sums", "scalar", "take_row", "take_square"),
    *("take_terms", "vector"),
)
_MACHINE = (kind for kind, row in KINDS.items() if row.numba == f"_{kind}")
# In numba, float() of a float32 stays a float32; float64() does not.
SUPPORT: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "builtins": ("abs", "float", "type"),
        "numpy": ("float64", "ndarray"),
        "mechproof.compiled_support": tuple(sorted({*_FRAME, *_MACHINE})),
        "mechproof.kernels.compiled": ("elementary",),
    }
)
# Docstring lines of modules that have sums.
SUMMED = (
    "Sums over axes are added in the order of the index, keeping the rounding error of every",
    "addition. Many sets of terms are added side by side, each to the same bits as alone. Inside",
    "functions that numba compiles, a sum takes one array of terms for each argument, or a number",
    "if all are equal.",
    "",
)


def render_compiled(paper: Paper) -> dict[str, str]:
    """Render the compiled kernels of a paper by file name; empty if it has none."""
    kernels = list_scalars(paper)
    if not kernels:
        return {}
    about = (*_describe(paper.system), *(SUMMED if any(k.code.indexed for k in kernels) else ()))
    docstring = (*about, *describe_origin(paper.system))
    source = render_scalars(paper.system, docstring, kernels, paper.one_pass)
    return {f"compiled/{paper.system}.py": source}


def _describe(system: str) -> tuple[str, ...]:
    return (
        f"Compiled kernels of the system `{system}`: one loop for each, by numba.",
        "",
        f"Names, arguments, domains, NaN and errors are those of `mechproof.kernels.{system}`,",
        "and so are the formulas. Kernels take numbers and NumPy arrays. Functions that numba",
        "compiles can call them, also with numbers and arrays mixed; arguments and results with",
        "components are then indexed.",
        "",
        "Tests hold them to the same accuracy bounds. Proved bounds on rounding errors, as help",
        "states them, hold for these kernels where it says `compiled`, otherwise for NumPy's.",
        "",
        f"Elementary functions: `{ELEMENTARY.strip('_.')}` {_hash_elementary()}.",
        "",
    )


# Folder of the functions that are compiled into kernels besides the elementary functions.
SUPPORT_FOLDER = Path(__file__).parents[2] / "compiled_support"
# Docstring of the module of the elementary functions.
ELEMENTARY_TEXT = (
    "Elementary functions in plain arithmetic, for compiled kernels.",
    "",
    "The errors of their approximations are enclosed in balls over the whole interval.",
    f"Angles up to {DOUBLE.largest} rad are reduced here. Beyond that the C library's functions",
    "are used if `exact` is true; if it is None the result is NaN.",
    "",
)


@cache
def render_elementary() -> str:
    """Render the elementary functions and read them back."""
    data: dict[str, object] = {
        "docstring": (*ELEMENTARY_TEXT, _name_support(), "", REGENERATED),
        "largest": DOUBLE.largest,
        "functions": [write_elementary(kind, DOUBLE, NUMBA, NUMBA_FAR) for kind in BODIES],
    }
    source = render_python("numba_elementary.py.jinja", data, SUPPORT)
    check_elementary(source)
    return source


def check_elementary(source: str) -> None:
    """Read the elementary functions back; `TranslationError` if one is not its program."""
    compare(dict(mean_elementary()), read_compiled(source))


@cache
def _hash_elementary() -> str:
    """Hash the elementary functions; printed in modules so that a change compiles these anew."""
    return sha256(render_elementary().encode()).hexdigest()[:12]


def _name_support() -> str:
    """Return the text that names the support by its hash, for the same reason."""
    texts = [path.read_text(encoding="utf-8") for path in sorted(SUPPORT_FOLDER.glob("*.py"))]
    digest = sha256("".join(texts).encode()).hexdigest()
    return f"Compiled with them: `compiled_support` {digest[:12]}."


def render_scalars(
    system: str,
    docstring: Sequence[str],
    kernels: Sequence[Kernel],
    together: Iterable[OnePass] = (),
) -> str:
    """Render a module of kernels and read it back."""
    _, written, reductions, language = _write(kernels, together)
    data: dict[str, object] = {
        "system": system,
        "docstring": docstring,
        "letters": [f"_{letter}" for letter in LOOPS],
        "reductions": [write_reduction(found, language) for found in reductions],
        "kernels": written,
    }
    source = render_python("numba_module.py.jinja", data, SUPPORT)
    check_translation(source, kernels, together)
    return source


def _write(
    kernels: Iterable[Kernel], together: Iterable[OnePass]
) -> tuple[list[Kernel], list[ScalarKernel], tuple[TermLoop, ...], Syntax]:
    """Return the kernels without their loops, all kernels' texts, the loops, and the language."""
    folded, found = fold_sums(kernels)
    reductions = tuple(map(name_elements, found))
    language = extend_syntax(NUMBA, reductions, "_")
    names = frozenset(found.name for found in reductions)
    parted = [take_out_loops(kernel, names) for kernel in folded]
    written = [
        write_scalar(kernel, language, describe_calls(calls, reductions, language))
        for kernel, calls in parted
    ]
    written += [join_scalars(several, written) for several in together]
    return [kernel for kernel, _ in parted], written, reductions, language


def check_translation(source: str, kernels: Iterable[Kernel], together: Iterable[OnePass]) -> None:
    """Read the functions of a module back; `TranslationError` if one is not its program."""
    taken, written, reductions, _ = _write(kernels, together)
    compare(dict(mean_compiled(taken, written, reductions)), read_compiled(source))
