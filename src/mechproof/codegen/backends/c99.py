"""C backend: in, a paper; out, a header and a source that need only <math.h>.

Elementary functions of angles are valid up to the format's largest angle. A separate program, the
part of the stage that computes angles, tests whether all angles of a point are below it. It runs
over a block of points before a loop without a branch.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

from mechproof.codegen.backends.numpy import render_template, tidy
from mechproof.codegen.backends.one_pass import join_kernels, list_unlike_domains
from mechproof.codegen.backends.scalar_texts import (
    ScalarKernel,
    ScalarStage,
    extend_syntax,
    join_scalars,
    list_booleans,
    write_elementary,
    write_reduction,
    write_scalar,
)
from mechproof.codegen.c_names import spell_in_c
from mechproof.codegen.docstrings import (
    SLOPES,
    describe_bound,
    describe_domain,
    describe_unit,
    show_formula,
)
from mechproof.codegen.languages import C99, C99_FAR, C99_SINGLE, C99_SINGLE_FAR
from mechproof.codegen.syntax import ProgramText, Syntax, write_program
from mechproof.programs.elementary.formats import DOUBLE, SINGLE, Format
from mechproof.programs.elementary.function_programs import BODIES
from mechproof.programs.elementary.plain import write_plainly
from mechproof.programs.kernel import Kernel
from mechproof.programs.operations import HELPER, KINDS
from mechproof.programs.program import TEMPORARY, Operand, Operation, Program, Stage
from mechproof.programs.reverse_mode import differentiate
from mechproof.programs.scalar import LOOPS, fold_sums, list_scalars, list_stages, put_off_divisions
from mechproof.record import OnePass, Paper

WIDTH = 90
# Line endings after which a blank line is kept.
ENDS = ("}", "*/", ");")
ACCURACY = {
    False: "Accuracy is the error bound that the tests enforce; eps = 2**-52. What the help of the "
    "NumPy kernels calls proved for compiled kernels is proved for these, too: without "
    "contractions they compute the same.",
    True: "Accuracy is the largest error that a search has found, in floats computed as here, "
    "provided that no intermediate value leaves their range; eps = 2**-23.",
}
# Contracted operations would round differently from the proofs; errno and traps would keep loops
# from being vectorised.
FLAGS = "-std=c99 -O3 -march=native -ffp-contract=off -fno-math-errno -fno-trapping-math"
COMMAND = f"cc {FLAGS}"
# Number of points whose angles are tested together: a block's numbers stay in the L1 cache.
BLOCK = 512
# Operations that are helper functions of the source, besides the elementary functions.
MACHINE = tuple(kind for kind, row in KINDS.items() if row.c == f"{HELPER}{kind}")
# Names of C's headers: if a file next to the source has such a name, <math.h> or a header that it
# includes may resolve to it.
HEADERS = frozenset({
    "assert", "complex", "ctype", "errno", "features", "fenv", "float", "inttypes", "iso646",
    "limits", "locale", "math", "setjmp", "signal", "stdalign", "stdarg", "stdatomic", "stdbit",
    "stdbool", "stdckdint", "stddef", "stdint", "stdio", "stdlib", "stdnoreturn", "string",
    "tgmath", "threads", "time", "uchar", "wchar", "wctype",
})  # fmt: skip


def render_makefile() -> str:
    """Return the makefile that builds a shared library from each source in its folder."""
    return render_template("Makefile.jinja", {"flags": FLAGS})


def render_c(paper: Paper, *, errors: Mapping[str, str] | None = None) -> dict[str, str]:
    """Render the header and the source of a paper's kernels by their file names.

    They compute in float if `errors` is given: for each kernel, a text on the errors found in
    float. Raises ValueError if there is no kernel, or if the names of two kernels clash in C.
    """
    kernels = list_scalars(paper)
    if not kernels:
        raise ValueError(f"{paper.system}: no kernel that C can compute point by point")
    single = errors is not None
    file = f"{paper.system}_single" if single else paper.system
    about = paper.reference, ACCURACY[single], paper.system
    notes = {k.name: _describe(k, paper, errors) for k in kernels}
    return render_c_kernels(file, kernels, about, notes, paper.one_pass, single=single)


def render_c_derivatives(paper: Paper) -> dict[str, str]:
    """Render the header and the source of a paper's derivatives by their file names.

    Raises ValueError if there are none.
    """
    kernels = list_scalars(differentiate(paper))
    if not kernels:
        raise ValueError(f"{paper.system}: no kernel whose derivatives are wanted")
    about = paper.reference, SLOPES, paper.system
    notes = {k.name: _describe(k, paper, None) for k in kernels}
    return render_c_kernels(f"{paper.system}_derivatives", kernels, about, notes)


def render_c_formula(kernel: Kernel, paper: Paper) -> str:
    """Render one kernel as a single source, with its header inlined."""
    about = paper.reference, ACCURACY[False], paper.system
    notes = {kernel.name: _describe(kernel, paper, None)}
    scalar = put_off_divisions(kernel)
    header, source = render_c_kernels(paper.system, [scalar], about, notes).values()
    return source.replace(f'#include "{paper.system}.h"\n', header)


def _describe(kernel: Kernel, paper: Paper, errors: Mapping[str, str] | None) -> list[str]:
    """Return the lines of a function's comment: formula, domain, accuracy, source."""
    quantity = kernel.quantity
    told = describe_bound(quantity) if errors is None else errors[kernel.name]
    notes = [f"Domain: {describe_domain(quantity, paper)}."]
    notes += [f"Accuracy: {told}."] if told else []
    notes += [f"Source: {quantity.source}."]
    wrapped = [line for note in notes for line in textwrap.wrap(note, WIDTH)]
    return [*show_formula(kernel, paper), "", *wrapped]


def render_c_kernels(
    file: str,
    kernels: Sequence[Kernel],
    about: tuple[str, str, str],
    notes: Mapping[str, Sequence[str]],
    together: Iterable[OnePass] = (),
    *,
    single: bool = False,
) -> dict[str, str]:
    """Render the header and the source of kernels whose names begin with that of the file.

    `about` has the citation, the accuracy and the system; `notes` has lines on each kernel, by
    name. Raises ValueError if names of files or functions clash, NotImplementedError for kernels
    that cannot be computed in one pass. In a pass, kernels with different domains are called one
    after the other for each point.
    """
    if file.lower() in HEADERS:
        raise ValueError(f"{file}: C has a header {file.lower()}.h; choose another name")
    if f"{file}_".startswith(HELPER):
        raise ValueError(f"{file}: {HELPER} is the prefix of helper functions; choose another name")
    form, language, far = (SINGLE, C99_SINGLE, C99_SINGLE_FAR) if single else (DOUBLE, C99, C99_FAR)
    language = replace(language, name=partial(spell_in_c, file=file))
    folded, reductions = fold_sums(kernels)
    extended = extend_syntax(language, reductions, HELPER, "terms")
    angles: dict[str, Angles] = {}
    written = [_write(kernel, extended, form, angles) for kernel in folded]
    written += [
        _write_together(several, folded, written, extended, form, angles) for several in together
    ]
    names = [name for kernel in written for name in (kernel.name, f"{kernel.name}_array")]
    if twice := sorted({name for name in names if names.count(name) > 1}):
        raise ValueError(f"{file}: two kernels would be called {file}_{twice[0]} in C")
    citation, accuracy, system = about
    common: dict[str, object] = {
        "prefix": file,
        "real": "float" if single else "double",
        "kernels": written,
    }
    header = {
        **common,
        "citation": textwrap.wrap(citation, WIDTH),
        "guard": f"{file.upper()}_H",
        "system": system,
        "precision": "single precision" if single else "double precision",
        "accuracy": textwrap.wrap(accuracy, WIDTH),
        "notes": notes,
        "command": COMMAND,
        "describe_unit": describe_unit,
    }
    source = {
        **common,
        "helper": HELPER,
        "largest": form.largest,
        "block": BLOCK,
        "limit": language.number(form.largest),
        "absolute": language.calls["absolute"],
        "number": language.number,
        "form": form,
        "letters": [f"{HELPER}{letter}" for letter in LOOPS],
        "reductions": [write_reduction(found, extended) for found in reductions],
        "far": angles,
        "split": write_program(write_plainly("fma"), language),
    }
    return {
        f"{file}.h": tidy(render_template("c_header.h.jinja", header), ENDS),
        f"{file}.c": tidy(_render_source(source, form, language, far), ENDS),
    }


def _render_source(data: Mapping[str, object], form: Format, language: Syntax, far: Syntax) -> str:
    """Render a source with only the helpers that it calls."""

    def render(helpers: Sequence[str]) -> str:
        texts = [write_elementary(k, form, language, far) for k in BODIES if k in helpers]
        return render_template("c_source.c.jinja", {**data, "functions": texts, "used": helpers})

    known = (*BODIES, *MACHINE)
    called: tuple[str, ...] = ()
    # Repeated until nothing is added: helpers of kernels, then helpers of helpers.
    while True:
        text = render(called)
        found = tuple(kind for kind in known if f"{language.calls[kind]}(" in text)
        if found == called:
            return text
        called = found


def _write(kernel: Kernel, syntax: Syntax, form: Format, angles: dict[str, Angles]) -> ScalarKernel:
    """Return a kernel's text, and add the tests of its angles to `angles` by stage name."""
    text = write_scalar(kernel, syntax)
    if text.sums:
        return text
    stages = []
    for written, (name, stage) in zip(text.stages, list_stages(kernel), strict=True):
        told, asked = ask_first(written, stage, form.largest, syntax)
        stages.append(told)
        angles.update({name: asked} if asked else {})
    return replace(text, stages=tuple(stages))


def _write_together(
    together: OnePass,
    kernels: Sequence[Kernel],
    written: Sequence[ScalarKernel],
    *how: Any,
) -> ScalarKernel:
    several = join_scalars(together, written)
    named = {kernel.name: kernel for kernel in kernels}
    members = [named[name] for name in together.quantities]
    if list_unlike_domains(members):
        return several
    text = _write(join_kernels(together.name, members), *how)
    return replace(text, summary=several.summary, members=several.members)


LIMITED = frozenset(kind for kind, (_, _, far) in BODIES.items() if far)


@dataclass(frozen=True)
class Angles:
    """The text of the test of whether all angles of a point are near, and the inputs it takes."""

    running: tuple[str, ...]
    prepared: tuple[tuple[str, int], ...]
    text: ProgramText
    booleans: frozenset[str]


def find_angles(stage: Stage, largest: float) -> Program | None:
    """Return the program that tests whether all angles of a point are near; None without angles."""
    assert stage.evaluate is not None
    program, steps = stage.evaluate, list(stage.evaluate.operations)
    angles = dict.fromkeys(step.operands[0] for step in steps if step.kind in LIMITED)
    result: Operand = True
    for number, angle in enumerate(angles):
        size, near, both = (f"{TEMPORARY}{kind}{number}" for kind in ("size", "near", "both"))
        steps.append(Operation(size, "absolute", (angle,)))
        steps.append(Operation(near, "less_equal", (size, largest)))
        steps.append(Operation(both, "both", (result, near)))
        result = both if number else near
    found = _keep_needed(replace(program, operations=tuple(steps), outputs=(result,)))
    return found if angles else None


def _keep_needed(program: Program) -> Program:
    """Return the program without operations and inputs that no output needs."""
    needed: set[Operand] = set(program.outputs)
    kept: list[Operation] = []
    for step in reversed(program.operations):
        if step.result in needed:
            needed.update(step.operands)
            kept.insert(0, step)
    inputs = tuple(name for name in program.inputs if name in needed)
    return replace(program, inputs=inputs, operations=tuple(kept)).normal_form()


def ask_first(
    written: ScalarStage, stage: Stage, largest: float, syntax: Syntax
) -> tuple[ScalarStage, Angles | None]:
    """Return a stage whose functions take a flag for far angles, and the test that sets it.

    Without angles, the stage is unchanged and there is no test.
    """
    program = find_angles(stage, largest)
    if program is None:
        return written, None
    assert stage.evaluate is not None
    told = replace(syntax, last={**syntax.last, **dict.fromkeys(LIMITED, f"{HELPER}exact")})
    places = {n: i for i, n in enumerate(stage.evaluate.inputs[len(stage.running) :])}
    angles = Angles(
        tuple(syntax.name(name) for name in program.inputs if name not in places),
        tuple((syntax.name(name), places[name]) for name in program.inputs if name in places),
        write_program(program, syntax),
        list_booleans(program, syntax),
    )
    return replace(written, evaluate=write_program(stage.evaluate, told)), angles
