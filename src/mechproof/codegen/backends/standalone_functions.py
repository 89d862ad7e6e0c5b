"""Formulas in other languages: in, a kernel; out, a function that needs no other file.

The programs are those of the NumPy kernels. Functions come from the language's own library; those
it lacks, above all the rests of roundings, become helper functions next to the formula.
"""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import partial

from mechproof.codegen.backends.numpy import format_source, render_template, tidy
from mechproof.codegen.backends.scalar_texts import BOOLEAN, ScalarKernel, write_scalar
from mechproof.codegen.docstrings import (
    describe_bound,
    describe_domain,
    describe_unit,
    show_formula,
)
from mechproof.codegen.languages import ARRAY, FORM, RESULT, SCRIPTS, STRUCTURED_TEXT_WORDS, Script
from mechproof.codegen.syntax import ProgramText, Syntax, write_program
from mechproof.programs.differentiable_branches import block_branches
from mechproof.programs.elementary.plain import needs_roundings, write_plainly
from mechproof.programs.kernel import Kernel, build_functions, list_functions
from mechproof.programs.operations import HELPER
from mechproof.programs.program import (
    TEMPORARY,
    Operand,
    Operation,
    Program,
    Stage,
    is_unnamed,
    unfuse,
)
from mechproof.programs.scalar import join_stage, list_conditions, list_stages
from mechproof.record import Paper

WIDTH = 92


@dataclass(frozen=True)
class Helper:
    """A helper function next to a formula."""

    name: str
    inputs: tuple[str, ...]
    text: ProgramText
    booleans: frozenset[str]
    is_boolean: bool


@dataclass(frozen=True)
class FormulaText:
    """The texts of a formula; each of the `helpers` comes before those that call it.

    `choices` are the steps that choose among forms, for languages of arrays. `written` are helpers
    whose text no program expresses.
    """

    name: str
    kernel: ScalarKernel
    lines: tuple[str, ...]
    choices: tuple[tuple[str, str], ...]
    helpers: tuple[Helper, ...]
    written: tuple[str, ...]


def render_scripts(paper: Paper, language: str) -> tuple[dict[str, str], tuple[str, ...]]:
    """Render a paper's kernels in a language by file name; also return why others cannot be."""
    script, files, refused = SCRIPTS[language], dict[str, str](), []
    texts = []
    for kernel in list_functions(paper):
        if not kernel.is_shipped:
            continue
        try:
            texts.append(_write(kernel, paper, script))
        except NotImplementedError as error:
            refused.append(f"{paper.system}.{kernel.name} in {language}: {error}")
    for text in texts if script.apart else ():
        files[f"{text.name}{script.suffix}"] = _render([text], script, paper)
    if texts and not script.apart:
        files[f"{paper.system}{script.suffix}"] = _render(texts, script, paper)
    return files, tuple(refused)


def render_script(kernel: Kernel, paper: Paper, language: str) -> str:
    """Render one kernel in a language.

    Raises NotImplementedError, saying why, for one that the language cannot compute.
    """
    script = SCRIPTS[language]
    return _render([_write(kernel, paper, script)], script, paper)


def _render(texts: Sequence[FormulaText], script: Script, paper: Paper) -> str:
    helpers = {helper.name: helper for text in texts for helper in text.helpers}
    written = {name: None for text in texts for name in text.written}
    data: dict[str, object] = {
        "formulas": texts,
        "helpers": list(helpers.values()),
        "origin": f"Generated from the derivation {paper.system}.",
    }
    data |= {"result": RESULT, "form": FORM} if script.takes_arrays else {}
    texts_beside = [script.helpers[name] for name in written]
    text = "\n".join([render_template(script.template, data), *texts_beside])
    return format_source(text) if script.suffix == ".py" else tidy(text)


def _write(kernel: Kernel, paper: Paper, script: Script) -> FormulaText:
    _refuse(kernel, script)
    if script.fuses:
        _refuse_rests(kernel, paper, script)
    name = f"{paper.system}_{kernel.name}"
    syntax = replace(script.syntax, name=_name_apart(kernel, script))
    kernel = _spell_out(kernel, script)
    choices = _choose(kernel, syntax) if script.takes_arrays else ()
    kinds = [step.kind for step in _list_steps(kernel, script)]
    kinds += ["choose"] * bool(choices)
    helpers = _find_helpers(kinds, script)
    written = tuple(k for k in script.helpers if k in {*kinds, *_list_kinds(helpers)})
    return FormulaText(
        name,
        _write_stages(kernel, syntax, script),
        tuple(describe_formula(kernel, paper)),
        choices,
        tuple(_write_helper(kind, script) for kind in helpers),
        written,
    )


def _spell_out(kernel: Kernel, script: Script) -> Kernel:
    """Return a kernel with functions that mean a single operation replaced by that operation."""

    def change(program: Program) -> Program:
        return replace(program, operations=tuple(_mean(s, script) for s in program.operations))

    stages = tuple(stage.change(change) for stage in kernel.code.stages)
    return replace(kernel, code=replace(kernel.code, stages=stages))


def _mean(step: Operation, script: Script) -> Operation:
    if step.kind in script.native or step.kind in script.helpers:
        return step
    program = write_plainly(step.kind)
    if len(program.operations) != 1:
        return step
    (only,) = program.operations
    given = dict(zip(program.inputs, step.operands, strict=True))
    operands = tuple(given.get(str(o), o) for o in only.operands)
    # A result without a name may be used only once.
    twice = {o for o in operands if is_unnamed(o) and operands.count(o) > 1}
    return step if twice else replace(step, kind=only.kind, operands=operands)


def _refuse(kernel: Kernel, script: Script) -> None:
    """Raise NotImplementedError for sums over axes, and for vectors if the language has none."""
    if kernel.code.indexed:
        raise NotImplementedError("formulas cannot sum over axes of arbitrary length")
    if (kernel.code.vectors or kernel.code.shape) and not script.takes_vectors:
        raise NotImplementedError("functions there take and return numbers, not vectors")


def _refuse_rests(kernel: Kernel, paper: Paper, script: Script) -> None:
    """Raise NotImplementedError for rests of roundings, naming rivals that do without them."""
    if lost := _list_rests(kernel, script):
        others = [
            f"{paper.system}.{other.name}"
            for other in build_functions(paper).kernels
            if other.is_alternative and other.quantity.name == kernel.quantity.name
            if not _list_rests(other, script)
        ]
        offer = f"; {' or '.join(others)} does without them" if others else ""
        raise NotImplementedError(
            "compilers of arrays may merge sums and products, which destroys the rounding errors "
            f"kept in {', '.join(lost)}{offer}"
        )


def _list_rests(kernel: Kernel, script: Script) -> list[str]:
    kinds = dict.fromkeys(step.kind for step in _list_steps(kernel, script))
    return [k for k in kinds if k not in script.native and needs_roundings(k)]


def _list_steps(kernel: Kernel, script: Script) -> list[Operation]:
    programs = [_join(stage, script) for _, stage in list_stages(kernel)]
    return [step for p in (*programs, *list_conditions(kernel)) for step in p.operations]


def _join(stage: Stage, script: Script) -> Program:
    program = join_stage(stage)
    return block_branches(_make_arrays(unfuse(program), script)) if script.fuses else program


def _make_arrays(program: Program, script: Script) -> Program:
    """Return the program with numbers that are passed to functions turned into arrays."""
    numbers, operations = set[Operand](), list[Operation]()
    for step in program.operations:
        given = [o for o in step.operands if o in numbers or not str(o).isidentifier()]
        if step.kind in script.syntax.calls:
            names: dict[Operand, str] = {
                o: f"{TEMPORARY}{ARRAY}{len(operations) + i}" for i, o in enumerate(given)
            }
            operations += [Operation(name, ARRAY, (o,)) for o, name in names.items()]
            step = step.rename(names)
        elif len(given) == len(step.operands):
            numbers.add(step.result)
        operations.append(step)
    return replace(program, operations=tuple(operations)).normal_form()


def _write_stages(kernel: Kernel, syntax: Syntax, script: Script) -> ScalarKernel:
    written = write_scalar(kernel, syntax)
    stages = zip(written.stages, list_stages(kernel), strict=True)
    wholes = [(text, write_program(_join(stage, script), syntax)) for text, (_, stage) in stages]
    return replace(written, stages=tuple(replace(text, whole=whole) for text, whole in wholes))


def _name_apart(kernel: Kernel, script: Script) -> Callable[[str], str]:
    """Return the function that spells names, distinct beyond case if the language ignores case."""
    if not script.ignores_case:
        return script.syntax.name
    taken, names = set(STRUCTURED_TEXT_WORDS.split()), dict[str, str]()
    for name in (*kernel.code.arguments, *sorted(kernel.code.names)):
        spelled = name.strip("_").replace("__", "_") or "v"
        while spelled.lower() in taken or spelled.lower().startswith(HELPER):
            spelled = f"v_{spelled}"
        if name not in names:
            names[name] = spelled
            taken.add(spelled.lower())
    return lambda name: names.get(name, name)


def _choose(kernel: Kernel, syntax: Syntax) -> tuple[tuple[str, str], ...]:
    """Return the steps that choose a form for each element, and NaN outside the domain."""
    steps: list[tuple[str, str]] = []
    stages = list_stages(kernel)
    for place in range(len(join_stage(stages[0][1]).outputs)):
        result = f"{RESULT}_{place}"
        value = f"{FORM}{len(stages)}_{place}"
        for number in reversed(range(1, len(stages))):
            when = stages[number - 1][1].when
            assert when is not None
            value = _append(steps, when, f"{FORM}{number}_{place}", value, result, syntax)
        if kernel.code.inside:
            inside = list_conditions(kernel)[0]
            value = _append(steps, inside, value, "#nan", result, syntax)
        if value != result:
            steps.append((result, value))
    return tuple(steps)


def _append(
    steps: list[tuple[str, str]],
    condition: Program,
    one: str,
    other: str,
    result: str,
    syntax: Syntax,
) -> str:
    chosen = Operation(f"{TEMPORARY}chosen", "choose", (condition.outputs[0], one, other))
    operations, outputs = (*condition.operations, chosen), (chosen.result,)
    program = replace(condition, operations=operations, outputs=outputs).normal_form()
    own = replace(syntax, name=lambda name: name if name in (one, other) else syntax.name(name))
    steps.append((result, write_program(program, own).outputs[0]))
    return result


def _find_helpers(kinds: Iterable[str], script: Script) -> tuple[str, ...]:
    """Return the kinds of helpers that a formula needs, each before those that call it."""
    found: dict[str, None] = {}

    def visit(kind: str) -> None:
        if kind in script.native or kind in script.helpers or kind in found:
            return
        for step in write_plainly(kind).operations:
            visit(step.kind)
        found[kind] = None

    for kind in kinds:
        visit(kind)
    return tuple(found)


def _list_kinds(helpers: Iterable[str]) -> set[str]:
    return {step.kind for kind in helpers for step in write_plainly(kind).operations}


def _write_helper(kind: str, script: Script) -> Helper:
    program = write_plainly(kind)
    booleans = frozenset(s.result for s in program.operations if s.kind in BOOLEAN)
    text = write_program(program, script.syntax)
    return Helper(f"{HELPER}{kind}", program.inputs, text, booleans, kind in BOOLEAN)


def describe_formula(kernel: Kernel, paper: Paper) -> Iterable[str]:
    """Yield comment lines on a formula: result, arguments, units, domain, accuracy and source."""
    quantity = kernel.quantity
    yield from textwrap.wrap(quantity.summary, WIDTH)
    yield from show_formula(kernel, paper)
    for argument in quantity.arguments:
        yield f"{argument.name}: {argument.meaning} ({describe_unit(argument.unit)})"
    fill = partial(textwrap.wrap, width=WIDTH)
    yield from fill(f"Result: {describe_unit(quantity.unit)}.")
    yield from fill(f"Domain: {describe_domain(quantity, paper)}.")
    if kernel.is_shipped and (told := describe_bound(quantity)):
        yield from fill(
            f"Tested accuracy of the NumPy kernel: {told}, eps = 2**-52. In another language the "
            "last digits depend on its own functions."
        )
    yield from fill(f"Source: {quantity.source}.")
