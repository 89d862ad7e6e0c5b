"""Forms: in, a paper and the source emitted from it; out, the rows on what the forms compute."""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import pairwise
from typing import Any

import sympy as sp

from mechproof.codegen.backends.numpy import FORMS, render_derivatives, render_modules
from mechproof.codegen.formula_text import write_formula
from mechproof.codegen.kernel_reading import check_module
from mechproof.programs.evaluation import Enclosure, Solved
from mechproof.programs.kernel import Kernel, build_functions, list_functions, name_rival
from mechproof.programs.program import Stage
from mechproof.programs.raising import WrittenForm
from mechproof.programs.reverse_mode import differentiate, select_wanted
from mechproof.record import (
    Claim,
    Conjunction,
    Differentiated,
    EmittedForm,
    Equality,
    Form,
    Holds,
    Paper,
    Part,
    Quantity,
    Row,
    Statement,
    Unwritten,
)
from mechproof.record.implicit import LEFT, LastIterate
from mechproof.record.quantities import DERIVATIVES, KERNEL
from mechproof.record.relations import solve

# Suffix of the number of a row that states that a form's rewrites are legal.
LEGAL = ", legal"
# Suffix of the number of a row that states how near a polynomial is to the value it replaces.
NEAR_ZERO = ", near 0"
# Suffix of the number of a row that states that Newton's steps lead to a root.
CONVERGES = ", converges"
_ENDS = ("", LEGAL, NEAR_ZERO, CONVERGES)
# Place of an iterate, as a share of the bracket's width from its lower end.
_PLACE = sp.Symbol("place", real=True)


def form_rows(paper: Paper) -> tuple[Row, ...]:
    """Return the rows of every form: that its source computes it, and that its rewrites are legal.

    The source is read back first; raises `TranslationError` if it is not the program. A quantity
    without a kernel gets a row with the reason.
    """
    functions = build_functions(paper)
    read_back(_leave_out(functions.refused, paper), functions.kernels)
    written = (
        row
        for kernel in functions.kernels
        for number, stage in enumerate(kernel.code.stages)
        for row in _state_form(kernel, number, stage, paper)
    )
    refused = (q for q in paper.quantities if q.name in functions.refused)
    return (*written, *(_state_refusal(q, functions.refused[q.name]) for q in refused))


def derivative_rows(paper: Paper) -> tuple[Row, ...]:
    """Return the rows on what the derivatives' source, which is read back first, computes."""
    derived = differentiate(paper)
    kernels = read_derivatives_back(paper)
    wanted = {quantity.name: quantity for quantity in select_wanted(paper)}
    rows = (
        _note_differentiated(row, wanted[kernel.quantity.name])
        for kernel in kernels
        for row in _state_form(kernel, 0, kernel.code.stages[0], derived)
    )
    return tuple(_describe_derivatives(row) for row in rows)


def _note_differentiated(row: Row, quantity: Quantity) -> Row:
    """Attach to a row's equality of derivatives the differentiated expression and its letters."""
    if not isinstance(row.says, Equality):
        return row
    letters = tuple(argument.symbols[0] for argument in quantity.arguments)
    differentiated = Differentiated(quantity.definition, letters)
    return replace(row, says=replace(row.says, differentiated=differentiated))


def _describe_derivatives(row: Row) -> Row:
    """Turn a row about a kernel's source into one about the source of its derivatives."""
    latex = row.printed_latex.replace("the source of ", "the source of the derivatives of ")
    latex = latex.replace("its definition", "the derivatives of its definition by the chain rule")
    return replace(row, number=f"{DERIVATIVES}{row.number}", printed_latex=latex)


def list_derivative_numbers(quantity: Quantity) -> list[str]:
    """List the numbers that rows about a quantity's derivatives may have; the first one exists."""
    numbers = [n for form in quantity.shipped[-1:] for n in _number_rows(quantity, form)]
    return [f"{DERIVATIVES}{number}" for number in numbers]


def _leave_out(names: Container[str], paper: Paper) -> Paper:
    """Return a paper without some of its quantities and the one-pass kernels that include them."""
    left = tuple(q for q in paper.quantities if q.name not in names)
    together = tuple(t for t in paper.one_pass if not any(name in names for name in t.quantities))
    return paper if left == paper.quantities else replace(paper, quantities=left, one_pass=together)


def _state_refusal(quantity: Quantity, reason: str) -> Row:
    shown = _show(quantity.name)
    number = number_form(quantity, quantity.shipped[-1])
    return _claim_of(quantity, number, f"{shown} has a kernel", Unwritten(reason))


def _claim_of(
    quantity: Quantity, number: str, text: str, says: Statement, note: str = "", **about: Any
) -> Claim:
    """Return a claim about the source of a quantity."""
    about |= {"marks": ("ours",), "quantities": (quantity.name,)}
    return Claim(number, rf"\text{{{text}}}", says, note=note, **about)


def _show(name: str) -> str:
    return name.replace("_", r"\_")


def read_back(paper: Paper, kernels: Sequence[Kernel]) -> None:
    """Read the emitted modules of a paper back and compare them with its kernels.

    Raises `SourceError` for any difference.
    """
    for name, source in render_modules(paper).items():
        own = [kernel for kernel in kernels if kernel.is_shipped != name.startswith(FORMS)]
        check_module(source, own, f"{paper.system}.")


def read_derivatives_back(paper: Paper) -> tuple[Kernel, ...]:
    """Return the kernels of a paper's derivatives, after comparing the emitted module with them.

    Raises `SourceError` for any difference.
    """
    kernels = list_functions(differentiate(paper))
    for source in render_derivatives(paper).values():
        check_module(source, kernels, f"derivatives of {paper.system}.")
    return kernels


def number_form(quantity: Quantity, form: Form) -> str:
    """Return the number of the row on what the source of a form computes."""
    if form is quantity.shipped[-1]:
        return f"{KERNEL}{quantity.name}"
    if any(form is one for one in quantity.shipped):
        return f"{KERNEL}{quantity.name}, {form.name}"
    return f"{KERNEL}{name_rival(quantity, form)}"


def number_shipped(paper: Paper) -> frozenset[str]:
    """Return the numbers of the rows that a paper's kernels rely on."""
    forms = ((q, form) for q in paper.quantities for form in q.shipped)
    return frozenset(number for q, form in forms for number in _number_rows(q, form))


def _number_rows(quantity: Quantity, form: Form) -> list[str]:
    return [f"{number_form(quantity, form)}{end}" for end in _ENDS]


def _state_form(kernel: Kernel, place: int, stage: Stage, paper: Paper) -> Iterator[Row]:
    quantity, form = kernel.quantity, kernel.forms[place]
    number = number_form(quantity, form)
    shown = _show(kernel.name)
    meant = "its definition" if kernel.is_shipped else f"the definition of {_show(quantity.name)}"
    meant += "" if form.bound is None else " within a bound"
    rewrites = ", ".join(form.rewrites) or "none"
    bound = "" if form.bound is None else f"; off by at most {write_formula(form.bound, {})}"
    definition = _write_out(quantity.definition, paper)
    enclosures = kernel.enclosures[place]
    states = form.states or partial(_equal_but_enclosures, enclosures, definition)
    written = WrittenForm(quantity, kernel.code, stage)
    on = _join_parts(quantity, form, paper)
    note = f" {form.note[:1].upper()}{form.note[1:]}." if form.note else ""
    claim = partial(_claim_of, quantity)
    text = f"the source of {shown} computes {meant}"
    told = f"Read back from the source: {form.name}; rewrites: {rewrites}{bound}.{note}"
    yield claim(number, text, states(written), told, on=on, holds_on=form.holds_on)
    if obligations := kernel.obligations[place]:
        text, told = f"the rewrites of {shown} are legal", f"The conditions of {rewrites}."
        legal = Conjunction(tuple(map(Holds, obligations)))
        yield claim(f"{number}{LEGAL}", text, legal, told, on=on)
    for enclosure in sorted(enclosures, key=lambda one: not isinstance(one, Solved)):
        if isinstance(enclosure, Solved):
            text = f"Newton's steps in {shown} lead to the one root in the bracket"
            steps = enclosure.exact.steps
            told = f"{steps} steps leave an error of at most 2**-64 of the bracket."
            says = _state_steps(written, enclosure)
            yield claim(f"{number}{CONVERGES}", text, says, told, on=_widen(on))
            continue
        symbol, limit = enclosure.symbol, enclosure.limit
        inside = Part(f"|{symbol}| <= {limit}", {symbol: sp.Interval(-limit, limit)})
        text = f"the polynomial of {shown} is off by less than a rounding"
        told = "Outside this range the function itself is computed."
        says = _state_enclosure(written, enclosure)
        yield claim(f"{number}{NEAR_ZERO}", text, says, told, on=inside)


def _equal_but_enclosures(
    enclosures: Sequence[Enclosure | Solved], definition: sp.Basic, code: EmittedForm
) -> Statement:
    """State that the code equals the definition, with exact values for the enclosed steps."""
    exact = {enclosure.step: enclosure.exact for enclosure in enclosures}
    return Equality(code.output(*exact).xreplace(exact), definition)


def _state_steps(code: EmittedForm, solved: Solved) -> Statement:
    """State that the steps are Newton's, from any place in the bracket, and end near the root."""
    root = solved.exact
    low, high = root.ends
    # A plain symbol for the iterate would be taken for a pure number.
    place = low + _PLACE * (high - low)
    steps = (
        Equality(code.step(step, before).xreplace({before: place}), root.step_from(place))
        for before, step in pairwise(solved.iterates)
    )
    distance = sp.Abs(LastIterate.towards(root) - root)
    near = Holds(sp.Le(distance, LEFT * (high - low), evaluate=False))
    begun = Equality(code.step(solved.iterates[0]), root.start)
    return Conjunction((begun, *steps, near))


def _widen(on: Part | None) -> Part:
    """Return a part in which the place of an iterate may also be any real number."""
    on = on or Part("", {})
    return replace(on, within={**on.within, _PLACE: sp.S.Reals})


def _state_enclosure(code: EmittedForm, enclosure: Enclosure) -> Statement:
    """State that a step's polynomial is within its bound, and that its other branch is exact."""
    value = code.step(enclosure.step)

    def take(place: int) -> sp.Expr:
        return value.replace(
            lambda node: isinstance(node, sp.Piecewise) and node.args[0].cond == enclosure.inside,
            lambda node: node.args[place].expr,
        )

    return Conjunction(
        (
            Holds(sp.Le(sp.Abs(take(0) - enclosure.exact), enclosure.bound)),
            Equality(take(1), enclosure.exact),
        )
    )


def _write_out(definition: sp.Basic, paper: Paper) -> sp.Basic:
    """Return the declared value of a definition that is itself a declared symbol."""
    given = paper.given
    for _ in given:
        definition = given.get(definition, definition)
    return definition


def _join_parts(quantity: Quantity, form: Form, paper: Paper) -> Part | None:
    """Join the parts on which the quantity and the form are defined, and when the form is taken."""
    parts = [part for part in (quantity.on, form.on) if part is not None]
    if form.when is not None:
        parts.append(_as_part(form.when, {v.symbol: v.within for v in paper.variables}))
    if not parts:
        return None
    within = {s: values for part in parts for s, values in part.within.items()}
    where = tuple(relation for part in parts for relation in part.where)
    return Part("; ".join(part.text for part in parts), within, where)


def _as_part(condition: sp.Basic, sets: Mapping[sp.Basic, sp.Set]) -> Part:
    """Return a condition as a narrower interval of its only symbol if it is one, else unchanged."""
    symbols = condition.free_symbols & sets.keys()
    if len(symbols) == 1 == len(condition.free_symbols):
        (symbol,) = symbols
        narrowed = sets[symbol].intersect(solve(condition, symbol))
        if isinstance(narrowed, sp.Interval):
            return Part(str(condition), {symbol: narrowed})
    return Part(str(condition), where=(condition,))
