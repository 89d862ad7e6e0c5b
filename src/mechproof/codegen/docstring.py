"""Docstring: in, a quantity and its domain; out, the lines of the kernel's documentation."""

from __future__ import annotations

from collections.abc import Mapping
from textwrap import wrap
from types import MappingProxyType

import sympy as sp
from sympy.printing.precedence import PRECEDENCE
from sympy.printing.str import StrPrinter

from mechproof.codegen.evaluation import count_axes
from mechproof.codegen.names import sort_positive_first
from mechproof.record import Argument, Paper, Quantity

WIDTH = 92
INDENT = "    "
OUT = (
    "out : ndarray, optional",
    "    Where the result goes, of its type and shape; it may overlap an argument.",
)

# What a rewrite does that a user may see.
NOTES: Mapping[str, str] = MappingProxyType(
    {
        "small_arc": "There, where NumPy has no vector loop for tan, long arrays are computed by "
        "polynomials: faster, with other last bits than short ones, and held to the same accuracy."
    }
)


def describe_kernel(
    quantity: Quantity,
    paper: Paper,
    domain: tuple[sp.Basic, ...],
    checked: tuple[sp.Basic, ...],
    masked: tuple[str, ...],
) -> tuple[str, ...]:
    """Write the NumPy-style lines: formula, arguments, result, errors, domain, accuracy, source."""
    return (
        quantity.summary,
        *(
            []
            if not quantity.specimen
            else ["", *_fill(f"Specimen, not for use: {quantity.specimen}.")]
        ),
        "",
        *_formula(quantity, paper),
        *_section(
            "Parameters",
            [*(line for a in quantity.arguments for line in _parameter(a, quantity)), *OUT],
        ),
        *_section("Returns", _result(quantity)),
        *_section("Raises", _errors(quantity)),
        *_section("Notes", _notes(quantity, domain, checked, masked)),
    )


def input_names(quantity: Quantity) -> Mapping[sp.Basic, str]:
    """Name the inputs: a lone symbol is called like its argument, components like their symbols."""
    return {
        s: argument.name if len(argument.symbols) == 1 else str(s)
        for argument in quantity.arguments
        for s in argument.symbols
    }


class FormulaPrinter(StrPrinter):  # type: ignore[misc]
    """Plain text with the arguments' names and sums in the order people write them."""

    def __init__(self, names: Mapping[sp.Basic, str]) -> None:
        super().__init__()
        self._names = names

    def _print_Symbol(self, expr: sp.Symbol) -> str:  # noqa: N802
        return str(self._names.get(expr, expr.name))

    def _print_Indexed(self, expr: sp.Indexed) -> str:  # noqa: N802
        name = self._names.get(expr.base, str(expr.base))
        return f"{name}[{','.join(map(self._print, expr.indices))}]"

    def _print_Add(self, expr: sp.Add, order: str | None = None) -> str:  # noqa: N802
        first, *others = sorted(expr.args, key=sort_positive_first)
        text = str(self.parenthesize(first, PRECEDENCE["Add"], strict=True))
        for term in others:
            sign, size = ("-", -term) if term.could_extract_minus_sign() else ("+", term)
            text += f" {sign} {self.parenthesize(size, PRECEDENCE['Add'])}"
        return text

    def _print_Sum(self, expr: sp.Sum) -> str:  # noqa: N802
        limits = ", ".join(f"{i}={low}..{high}" for i, low, high in reversed(expr.limits))
        return f"Sum[{limits}]({self._print(expr.function)})"


def write_formula(expression: sp.Basic, quantity: Quantity) -> str:
    """Write the plain text of an expression or relation of a quantity."""
    if isinstance(expression, sp.GreaterThan | sp.StrictGreaterThan):
        expression = expression.reversed
    printer = FormulaPrinter(input_names(quantity))
    if isinstance(expression, sp.Eq):
        return f"{printer.doprint(expression.lhs)} = {printer.doprint(expression.rhs)}"
    return str(printer.doprint(expression))


def _chain(limits: list[str]) -> list[str]:
    """Join neighbours: 0 < R1, R1 < oo -> 0 < R1 < oo."""
    chained: list[str] = []
    for limit in limits:
        last = chained[-1].split(" ")[-1] if chained else ""
        first, _, rest = limit.partition(" ")
        if first == last and chained[-1].count(" ") == 2:
            chained[-1] += f" {rest}"
        else:
            chained.append(limit)
    return chained


def _section(title: str, lines: list[str]) -> list[str]:
    return ["", title, "-" * len(title), *lines]


def _fill(text: str, indent: str = "") -> list[str]:
    return wrap(
        text, WIDTH, initial_indent=indent, subsequent_indent=indent, break_long_words=False
    )


def _formula(quantity: Quantity, paper: Paper) -> list[str]:
    definition = quantity.definition
    given = {v.symbol: v.given for v in paper.variables if v.given is not None}
    used = [s for s in given if definition.has(s)]
    used = [s for s in given if s in used or any(given[u].has(s) for u in used)]
    if isinstance(definition, sp.MatrixBase):
        rows = [[write_formula(entry, quantity) for entry in row] for row in definition.tolist()]
        shown = [f"[{', '.join(row)}]" for row in rows]
    else:
        shown = [f"{quantity.name} = {write_formula(definition, quantity)}"]
    shown += [f"{s} = {write_formula(given[s], quantity)}" for s in used]
    return [
        line
        for text in shown
        for line in wrap(
            text, WIDTH, initial_indent=INDENT, subsequent_indent=2 * INDENT, break_long_words=False
        )
    ]


def _parameter(argument: Argument, quantity: Quantity) -> list[str]:
    default = "" if argument.default is None else f", default {argument.default:g}"
    return [
        f"{argument.name} : array_like, {_shape(argument, quantity)}{default}",
        *_fill(f"{_sentence(argument.meaning)} ({_unit(argument.unit)}).", INDENT),
    ]


def _shape(argument: Argument, quantity: Quantity) -> str:
    if len(argument.symbols) > 1:
        return f"shape (..., {len(argument.symbols)})"
    if isinstance(argument.symbols[0], sp.IndexedBase):
        return f"shape (..., {', '.join('n' * count_axes(argument, quantity))})"
    return "any shape"


def _unit(unit: str) -> str:
    return "pure number" if unit == "1" else unit


def _sentence(text: str) -> str:
    return text[:1].upper() + text[1:]


def _result(quantity: Quantity) -> list[str]:
    form = quantity.form.expression
    trailing = ""
    if isinstance(form, sp.MatrixBase):
        trailing = f", {form.rows}" if form.cols == 1 else f", {form.rows}, {form.cols}"
    head = f"ndarray, shape (...{trailing})" if trailing else "ndarray or NumPy scalar"
    text = (
        f"The broadcast of the arguments ({_unit(quantity.unit)}); float32 if every array "
        "argument is float32, float64 otherwise."
    )
    return [head, *_fill(text, INDENT)]


def _errors(quantity: Quantity) -> list[str]:
    shaped = [a.name for a in quantity.arguments if _shape(a, quantity) != "any shape"]
    types = "If an argument is complex or not numeric, or `out` has another type."
    what = f"If the last axis of {' or '.join(shaped)} is wrong, " if shaped else "If "
    shapes = f"{what}shapes do not broadcast, or `out` has another shape."
    return ["TypeError", *_fill(types, INDENT), "ValueError", *_fill(shapes, INDENT)]


def _notes(
    quantity: Quantity,
    domain: tuple[sp.Basic, ...],
    checked: tuple[sp.Basic, ...],
    masked: tuple[str, ...],
) -> list[str]:
    part = f" ({quantity.on.text})" if quantity.on else ""
    limits = _chain([write_formula(r, quantity) for r in domain])
    notes = [f"Domain: {', '.join(limits) or 'all real arguments'}{part}."]
    if checked:
        skipped = [write_formula(r, quantity) for r in domain if r not in checked]
        outside = f"Outside it the result is NaN, by way of {' and '.join(masked)}"
        notes.append(outside + (f"; {', '.join(skipped)} is not checked." if skipped else "."))
    notes += [f"Singular: {point}." for point in quantity.singular]
    if quantity.form.bound is not None:
        bound = (
            f"|result - exact| <= {write_formula(quantity.form.bound, quantity)}, rounding apart"
        )
        notes.append(f"Approximation, {quantity.form.name}: {bound}.")
    if quantity.shortcut is not None:
        when = write_formula(quantity.shortcut.when, quantity)
        notes.append(f"Where {when} for all elements, {quantity.shortcut.form.name} is as good.")
    forms = [quantity.form, *([quantity.shortcut.form] if quantity.shortcut else [])]
    notes += [NOTES[name] for form in forms for name in form.rewrites if name in NOTES]
    if quantity.bar is not None:
        notes.append(
            f"Accuracy held by the tests: error <= {quantity.bar.ulp:g} eps * ({quantity.bar.of}), "
            "eps the spacing of floats at 1."
        )
    notes.append(f"Source: {quantity.source}.")
    return [line for i, note in enumerate(notes) for line in ([""] if i else []) + _fill(note)]
