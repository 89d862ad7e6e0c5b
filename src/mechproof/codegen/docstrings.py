"""Docstrings: in, a paper and its kernels; out, the lines of the documentation."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Collection, Iterable, Mapping
from textwrap import TextWrapper
from types import MappingProxyType

import sympy as sp

from mechproof.codegen.formula_text import chain_relations, join_equal_limits, write_formula
from mechproof.programs.argument_conditions import domain_relations
from mechproof.programs.evaluation import find_needed
from mechproof.programs.kernel import Kernel, input_names, list_functions, shape_of
from mechproof.record import Accuracy, Argument, Paper, Quantity, Scale

WIDTH = 92
INDENT = "    "
# The most lines of a scale's formula without steps that are shown; of a longer formula only the
# name is shown.
LONGEST_SCALE = 8
# The most symbols that a formula explains itself; if there are more, those shared by several
# kernels are explained once, by the module.
MOST_SYMBOLS = 4
# Paragraphs of a module's docstring about all its kernels.
COMMON = (
    "Arguments broadcast. The result is a NumPy scalar if all arguments are scalars, otherwise an "
    "array; it is float32 if every array argument is float32, otherwise float64. `out`, an array "
    "of the result's type and shape, receives the result; it may overlap an argument. The result "
    "is NaN outside the domain and where an argument is NaN; in a domain numpy.pi counts as pi.",
    "TypeError: an argument is complex or not numeric, or `out` is not an array of the result's "
    "type. ValueError: shapes do not broadcast, a last axis is wrong, or `out` has another shape.",
)
ACCURACY = (
    "Accuracy is tested: on the stated arguments no search has found a larger error. It is that of "
    "float64, in which float32 is computed, too; eps = 2**-52."
)
# Heading of a kernel's tested accuracy where a proved one is listed as well.
TESTED = "Accuracy, tested"
DERIVATIVES = (
    "Arguments, domain, `out` and errors are those of the kernel with the same name, one module "
    "up; along a last axis the result has the derivative by each argument, in their order."
)
SLOPES = (
    "At a kink a derivative is that on the side of the greater argument; at a pole it is infinite "
    "or NaN. Each is proved to follow from the definition by the chain rule. Accuracy is tested: "
    "the error of an entry d is at most the stated multiple of eps = 2**-52 times its condition, "
    "|d| + the sum of |p * d d/d p| over the arguments and the symbols p of the kernel's formula, "
    "plus, if the kernel's own error has a scale, that scale divided by the argument (the "
    "first counts as at most 1 rad or mm)."
)
SCALES = "What errors are relative to:"
PROVED = (
    "A proved bound holds for all arguments stated in its line, in float64 rounded to nearest, on "
    "the assumptions of that line. These speak of the results of all intermediate operations; the "
    "normal range is 0 and everything of at least 2**-1022 in size. A proved bound may be larger "
    "than a tested one, since a proof adds up roundings that may never occur together."
)


def fold(text: str) -> str:
    """Return a text in one line, keeping its leading blanks."""
    return re.sub(r"\s*[\n\t]\s*", " ", text)


def write_c_comment(text: str) -> str:
    """Return a text as one line of a C comment, which it neither ends nor opens again."""
    return fold(text).replace("*/", "* /").replace("/*", "/ *")


def write_docstring(text: str) -> str:
    """Return a text escaped for use between a docstring's quotes, keeping its lines."""
    return text.replace("\\", "\\\\").replace('"""', r"\"\"\"")


# The escaping of a paper's texts for each place they are put in; templates use these as filters.
ESCAPES: Mapping[str, Callable[[str], str]] = MappingProxyType(
    {
        "comment": fold,
        "c_comment": write_c_comment,
        "docstring": write_docstring,
        "python_string": repr,
    }
)


def describe_module(paper: Paper, first_line: str, kernels: Iterable[Kernel]) -> tuple[str, ...]:
    """Return the lines of a module's docstring: reference, conventions, scales, shared symbols."""
    kernels = tuple(kernels)
    shipped = [k for k in kernels if k.is_shipped]
    paragraphs = [first_line, paper.reference, paper.conventions, *COMMON]
    paragraphs += [ACCURACY] if any(k.quantity.accuracy for k in shipped) else []
    paragraphs += [PROVED] if any(f.proved for k in shipped for f in k.forms) else []
    paragraphs += [SCALES] if any(_scale_of(k.quantity) for k in shipped) else []
    lines = [line for p in paragraphs if p for line in (*_fill(p), "")]
    symbols, scales = _define_shared(kernels, paper), _define_scales(shipped)
    return (*lines, *(line for block in (*scales, symbols) if block for line in (*block, "")))


def _define_shared(kernels: tuple[Kernel, ...], paper: Paper) -> list[str]:
    """Return lines that define the symbols shared by the formulas of several kernels."""
    shared = _find_shared(kernels, paper)
    names = {s: n for k in kernels for s, n in input_names(k.quantity).items()}
    shown = (f"{s} = {write_formula(g, names)}" for s, g in paper.given.items() if s in shared)
    lines = [line for text in shown for line in _wrap_formula(text)]
    return [*_fill("Symbols of the formulas:"), "", *lines] if lines else []


def _find_shared(kernels: Iterable[Kernel], paper: Paper) -> set[sp.Symbol]:
    used = [find_given(_shown_formula(k), k.quantity, paper) for k in kernels]
    counts = Counter(s for symbols in used if len(symbols) > MOST_SYMBOLS for s in symbols)
    return {s for s, count in counts.items() if count > 1}


def _shown_formula(kernel: Kernel) -> sp.Basic:
    return kernel.quantity.definition if kernel.is_shipped else kernel.forms[0].expression


def describe_kernel(kernel: Kernel, paper: Paper) -> tuple[str, ...]:
    """Return a function's docstring lines: formula, arguments, result, domain, accuracy, source."""
    quantity = kernel.quantity
    if not kernel.is_shipped:
        return _describe_rival(kernel, paper)
    return (
        fold(quantity.summary),
        "",
        *_formula(kernel, paper),
        *_section(
            "Parameters", [line for a in quantity.arguments for line in _parameter(a, quantity)]
        ),
        *_section("Returns", _result(kernel)),
        *_section("Notes", _paragraphs(list_notes(kernel, paper))),
    )


def _describe_rival(kernel: Kernel, paper: Paper) -> tuple[str, ...]:
    quantity, (form,) = kernel.quantity, kernel.forms
    notes = [f"{capitalise(form.note)}."] if form.note else []
    notes += _approximations(kernel)
    part = form.on or quantity.on
    notes += [f"Same domain as `{quantity.name}`" + (f", {part.text}." if part else ".")]
    notes += [f"Source: {form.source}."] if form.source else []
    return (
        f"Compute `{quantity.name}` by another form: {form.name}.",
        "",
        *_formula(kernel, paper),
        "",
        *_paragraphs(notes),
    )


def describe_derivatives_module(paper: Paper) -> tuple[str, ...]:
    """Return the docstring lines of a module of derivatives."""
    first = f"Partial derivatives of the kernels of `{paper.system}`, by every argument."
    paragraphs = (first, paper.reference, DERIVATIVES, SLOPES)
    return tuple(line for text in paragraphs for line in (*_fill(text), ""))


def describe_derivatives(kernel: Kernel) -> tuple[str, ...]:
    """Return the docstring lines of a function of derivatives: subject, unit and accuracy."""
    quantity = kernel.quantity
    assert quantity.accuracy is not None
    told = describe_accuracy(quantity.accuracy, input_names(quantity))
    return (
        *_fill(quantity.summary),
        "",
        *_fill(f"In {quantity.unit}. {TESTED}: {told}."),
    )


def _scale_of(quantity: Quantity) -> Scale | None:
    return quantity.accuracy.scale if quantity.accuracy else None


def _define_scales(kernels: Iterable[Kernel]) -> list[list[str]]:
    """Return blocks of lines that define the scales of errors, beginning with shared steps."""
    scales = [_write_scale(k, s) for k in kernels if (s := _scale_of(k.quantity))]
    counts = Counter(step for _, steps in scales for step in steps)
    shared = [line for step, n in counts.items() if n > 1 for line in _wrap_formula(step)]
    blocks = [shared]
    for scale, steps in scales:
        texts = (scale, *(step for step in steps if counts[step] == 1))
        lines = [line for text in texts for line in _wrap_formula(text)]
        # A long formula without steps is omitted, as its name describes it.
        if steps or len(lines) <= LONGEST_SCALE:
            blocks.append(lines)
    return blocks


def _write_scale(kernel: Kernel, scale: Scale) -> tuple[str, list[str]]:
    """Return the texts of a scale's formula and of its steps."""
    names = input_names(kernel.quantity)
    formula = write_formula(scale.expression, names)
    steps = [f"{s} = {write_formula(value, names)}" for s, value in scale.where]
    return f"{scale.name} ({kernel.name}) = {formula}", steps


def _section(title: str, lines: list[str]) -> list[str]:
    return ["", title, "-" * len(title), *lines]


class _Wrapper(TextWrapper):
    """Wraps at blanks, and products longer than a line also after their signs."""

    def _split(self, text: str) -> list[str]:
        room = self.width - len(self.subsequent_indent)
        return [part for chunk in super()._split(text) for part in _break_product(chunk, room)]


def _break_product(text: str, room: int) -> list[str]:
    return re.split(r"(?<=[^*][*/])(?=[^*])", text) if len(text) > room else [text]


def _fill(text: str, indent: str = "", hanging: str = "") -> list[str]:
    wrapper = _Wrapper(
        WIDTH, initial_indent=indent, subsequent_indent=indent + hanging, break_long_words=False
    )
    return wrapper.wrap(text)


def _wrap_formula(text: str) -> list[str]:
    return _fill(text, INDENT, INDENT)


def _paragraphs(notes: list[str]) -> list[str]:
    return [line for i, note in enumerate(notes) for line in ([""] if i else []) + _fill(note)]


def _formula(kernel: Kernel, paper: Paper) -> list[str]:
    beside = (k for k in list_functions(paper) if k.is_shipped == kernel.is_shipped)
    used = find_given(_shown_formula(kernel), kernel.quantity, paper)
    shared = _find_shared(beside, paper) if len(used) > MOST_SYMBOLS else set()
    elsewhere = ["", *_fill("Symbols without an equation here: see the module.")] if shared else []
    return [*show_formula(kernel, paper, shared), *elsewhere]


def show_formula(
    kernel: Kernel, paper: Paper, shared: Collection[sp.Symbol] = frozenset()
) -> list[str]:
    """Return a kernel's formula, with an equation for each given symbol that is not in `shared`."""
    formula, names, given = _shown_formula(kernel), input_names(kernel.quantity), paper.given
    if isinstance(formula, sp.MatrixBase):
        rows = [[write_formula(entry, names) for entry in row] for row in formula.tolist()]
        shown = [f"[{', '.join(row)}]" for row in rows]
    else:
        shown = [f"{kernel.name} = {write_formula(formula, names)}"]
    used = find_given(formula, kernel.quantity, paper)
    shown += [f"{s} = {write_formula(given[s], names)}" for s in used if s not in shared]
    return [line for text in shown for line in _wrap_formula(text)]


def find_given(formula: sp.Basic, quantity: Quantity, paper: Paper) -> list[sp.Symbol]:
    """List the given symbols that a formula needs, directly or through others."""
    inputs = input_names(quantity)
    given = {s: g for s, g in paper.given.items() if s not in inputs}
    needed = find_needed(formula, given)
    return [s for s in given if s in needed]


def _parameter(argument: Argument, quantity: Quantity) -> list[str]:
    default = "" if argument.default is None else f", default {argument.default:g}"
    return [
        f"{argument.name} : array_like, {shape_of(argument, quantity)}{default}",
        *_fill(f"{capitalise(argument.meaning)} ({describe_unit(argument.unit)}).", INDENT),
    ]


def describe_unit(unit: str) -> str:
    """Return the text of a unit; "pure number" for 1."""
    return "pure number" if unit == "1" else unit


def capitalise(text: str) -> str:
    """Return a text with its first letter capitalised, the others unchanged."""
    return text[:1].upper() + text[1:]


def _result(kernel: Kernel) -> list[str]:
    trailing = ", ".join(map(str, kernel.code.shape))
    head = f"ndarray, shape (..., {trailing})" if trailing else "ndarray or NumPy scalar"
    return [f"{head} ({describe_unit(kernel.quantity.unit)})"]


def list_notes(kernel: Kernel, paper: Paper) -> list[str]:
    """List the notes on a kernel: domain, singular sets, remarks, accuracy, source."""
    quantity, names = kernel.quantity, input_names(kernel.quantity)
    notes = [f"Domain: {describe_domain(quantity, paper)}."]
    notes += [
        f"Singular: {s.text}."
        if s.equation.has(sp.Sum)
        else f"Singular: {write_formula(s.equation, names)}, {s.text}."
        for s in quantity.singular
        if s.text
    ]
    notes += [f"{capitalise(remark)}." for remark in quantity.remarks]
    notes += _approximations(kernel)
    for form in kernel.forms[:-1]:
        assert form.when is not None
        notes.append(
            f"Where {write_formula(form.when, names)} for all elements, {form.name} is computed."
        )
    told = describe_bound(quantity)
    notes += [f"{TESTED}: {told}."] if told else []
    notes += [form.proved for form in kernel.forms if form.proved]
    return [*notes, f"Source: {quantity.source}."]


def describe_domain(quantity: Quantity, paper: Paper) -> str:
    """Return the text of a quantity's domain."""
    names = input_names(quantity)
    part = f" ({quantity.on.text})" if quantity.on else ""
    # The text about a part says more than the formula of a sum.
    told = (r for r in domain_relations(quantity, paper) if not (part and r.has(sp.Sum)))
    relations = [write_formula(r, names) for r in told]
    limits = join_equal_limits(chain_relations(relations))
    return f"{', '.join(limits) or 'all real arguments'}{part}"


def _approximations(kernel: Kernel) -> list[str]:
    names = input_names(kernel.quantity)
    return [
        f"Approximation, {form.name}: |result - exact| <= {write_formula(form.bound, names)}, "
        "apart from rounding."
        for form in kernel.forms
        if form.bound is not None
    ]


def describe_bound(quantity: Quantity) -> str:
    """Return the text of a quantity's promised error bound; empty if it has none."""
    return describe_accuracy(quantity.accuracy, input_names(quantity)) if quantity.accuracy else ""


def describe_accuracy(accuracy: Accuracy, names: Mapping[sp.Basic, str]) -> str:
    """Return the text of a promised error bound and of where it holds."""
    of = accuracy.scale.name if accuracy.scale else "the value"
    relations = dict.fromkeys(write_formula(r, names) for r in accuracy.within)
    limits = join_equal_limits(chain_relations([*relations]))
    within = accuracy.where or " and ".join(limits)
    where = f", where {within}" if within else ""
    return f"{accuracy.ulp:.4g} eps of {of}{where}"
