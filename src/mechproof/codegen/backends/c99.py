"""C backend: in, a paper; out, a header and a source that need <math.h> alone."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import partial

from mechproof.codegen.backends.numpy import render_template
from mechproof.codegen.backends.one_pass import join_kernels, list_unlike_domains
from mechproof.codegen.backends.scalar import list_elementary, list_scalars
from mechproof.codegen.backends.scalar_texts import (
    ScalarKernel,
    extend_syntax,
    join_scalars,
    write_elementary,
    write_reduction,
    write_scalar,
)
from mechproof.codegen.backends.sums import LOOPS, fold_sums
from mechproof.codegen.c_names import HELPER, spell_in_c
from mechproof.codegen.elementary.formats import DOUBLE, SINGLE
from mechproof.codegen.elementary.functions import build
from mechproof.codegen.kernel import Kernel
from mechproof.codegen.languages import C99, C99_FAR, C99_SINGLE, C99_SINGLE_FAR
from mechproof.codegen.syntax import Syntax
from mechproof.record import Paper, Together

WIDTH = 90
ACCURACY = {
    False: "Tests hold them to the accuracy bounds that the help of the NumPy kernels states. What "
    "it says is proved of compiled kernels is proved of these, without contractions.",
    True: "No accuracy bound is stated in float.",
}
# With a file of the same name beside it, <math.h>, or what it includes, may be that one.
HEADERS = frozenset({
    "assert", "complex", "ctype", "errno", "features", "fenv", "float", "inttypes", "iso646",
    "limits", "locale", "math", "setjmp", "signal", "stdalign", "stdarg", "stdatomic", "stdbit",
    "stdbool", "stdckdint", "stddef", "stdint", "stdio", "stdlib", "stdnoreturn", "string",
    "tgmath", "threads", "time", "uchar", "wchar", "wctype",
})  # fmt: skip


def render_c(paper: Paper, *, single: bool = False) -> dict[str, str]:
    """Render the header and the source of a paper's kernels by their file names.

    Raises ValueError if there is no kernel, or the names of two kernels meet in C.
    """
    kernels = list_scalars(paper)
    if not kernels:
        raise ValueError(f"{paper.system}: no kernel that C can compute point by point")
    file = f"{paper.system}_single" if single else paper.system
    about = paper.citation, ACCURACY[single], paper.system
    return render_c_kernels(file, kernels, about, paper.together, single=single)


def render_c_kernels(
    file: str,
    kernels: Sequence[Kernel],
    about: tuple[str, str, str],
    together: Iterable[Together] = (),
    *,
    single: bool = False,
) -> dict[str, str]:
    """Render the header and the source of kernels whose names begin with that of the file.

    `about` says what they are, how accurate, and of which system.
    Raises ValueError where the names of files or functions meet, NotImplementedError for what has
    no pass in common. Kernels of different domains are called one after the other, point by point.
    """
    if file.lower() in HEADERS:
        raise ValueError(f"{file}: C has a header {file.lower()}.h, kernels need another name")
    if f"{file}_".startswith(HELPER):
        raise ValueError(
            f"{file}: what begins with {HELPER} are helpers, kernels need another name"
        )
    citation, accuracy, system = about
    form, language, far = (SINGLE, C99_SINGLE, C99_SINGLE_FAR) if single else (DOUBLE, C99, C99_FAR)
    language = replace(language, name=partial(spell_in_c, file=file))
    folded, reductions = fold_sums(kernels)
    extended = extend_syntax(language, reductions, HELPER, "terms")
    written = [write_scalar(kernel, extended) for kernel in folded]
    written += [_write_together(several, folded, written, extended) for several in together]
    names = [name for kernel in written for name in (kernel.name, f"{kernel.name}_array")]
    if twice := sorted({name for name in names if names.count(name) > 1}):
        raise ValueError(f"{file}: two kernels would be called {file}_{twice[0]} in C")
    common: dict[str, object] = {
        "prefix": file,
        "real": "float" if single else "double",
        "kernels": written,
    }
    elementary = list_elementary(folded, reductions)
    steps = [step for kind in elementary for step in build(kind, form).program.operations]
    header = {
        **common,
        "citation": textwrap.wrap(citation, WIDTH),
        "guard": f"{file.upper()}_H",
        "system": system,
        "precision": "single precision" if single else "double precision",
        "accuracy": textwrap.wrap(accuracy, WIDTH),
    }
    source = {
        **common,
        "helper": HELPER,
        "largest": form.largest,
        "limit": language.number(form.largest),
        "absolute": language.calls["absolute"],
        "number": language.number,
        "powers": any(step.kind == "power_of_two" for step in steps),
        "form": form,
        "functions": [write_elementary(kind, form, language, far) for kind in elementary],
        "letters": [f"{HELPER}{letter}" for letter in LOOPS],
        "reductions": [write_reduction(found, extended) for found in reductions],
    }
    return {
        f"{file}.h": _tidy(render_template("c_header.h.jinja", header)),
        f"{file}.c": _tidy(render_template("c_source.c.jinja", source)),
    }


def _write_together(
    together: Together, kernels: Sequence[Kernel], written: Sequence[ScalarKernel], syntax: Syntax
) -> ScalarKernel:
    several = join_scalars(together, written)
    named = {kernel.name: kernel for kernel in kernels}
    members = [named[name] for name in together.quantities]
    if list_unlike_domains(members):
        return several
    joined = join_kernels(together.name, members)
    text = write_scalar(joined, syntax)
    return replace(text, summary=several.summary, members=several.members)


def _tidy(text: str) -> str:
    """Leave no blank lines but single ones after what ends."""
    lines = [""]
    for line in map(str.rstrip, text.splitlines()):
        if line or lines[-1].endswith(("}", "*/", ");")):
            lines.append(line)
    return "\n".join(lines).strip() + "\n"
