"""Quantities: what can be computed, as the page of each one shows it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from markupsafe import Markup

from mechproof.codegen import docstrings
from mechproof.codegen.form_rows import number_form
from mechproof.lab.chart_points import find_time, find_usual_set, list_workloads
from mechproof.lab.sampling.point_sets import SWEEP
from mechproof.measured import IN_C, Record, Searched
from mechproof.programs.kernel import Kernel, build_functions, input_names, shape_of
from mechproof.proof.anchors import name_anchors
from mechproof.proof.comparison_latex import write_latex, write_letter
from mechproof.proof.verdict import Judgement
from mechproof.record import Argument, Form, Paper, Quantity, Variable
from mechproof.report.formula_texts import Sources, list_calls, write_header, write_sources
from mechproof.report.formulas import describe_turned, goes_on, write_definition, write_given
from mechproof.report.judged_derivations import JudgedDerivation
from mechproof.report.mathml import write_formula
from mechproof.report.pages import RowView, describe_row, name_symbols
from mechproof.report.phrases import VerdictStyle, look_of, set_numbers, set_prose

# An argument with more numbers than this is shown by their count.
MANY = 4
# Remark on a form that is shipped together with one before it.
TOGETHER = Markup("elsewhere; measured with the form above, as one kernel")
# An argument with its symbols and its shape as they are written.
ArgumentView = tuple[Argument, Markup, str]


@dataclass(frozen=True)
class Costs:
    """The errors and times of a way to compute, as text; empty if nothing was measured.

    `usual` is the error in usual calls, `absolute` the same in the unit of the quantity.
    """

    error: str = ""
    usual: str = ""
    absolute: str = ""
    time: str = ""
    ratio: str = ""


@dataclass(frozen=True)
class FormView:
    """A way to compute: its name, what is proved of it, its errors and its times."""

    name: str
    is_shipped: bool
    look: VerdictStyle
    rung: str
    note: Markup
    costs: Costs


@dataclass(frozen=True)
class Measured:
    """What the record says of the quantity: the worst error found, where, when and how.

    `usual` says what usual calls are, `absolute` in which unit besides eps their error is given;
    `swept` gives the error of a position over some turns in radians.
    """

    worst: str
    usual: Markup
    unit: str
    absolute: str
    points: str
    searched: Markup
    swept: Markup
    taken: str
    machine: str
    is_quick: bool
    timed: str


@dataclass(frozen=True)
class QuantityView:
    """The page of a quantity."""

    quantity: Quantity
    arguments: tuple[ArgumentView, ...]
    formula: Markup
    given: tuple[Markup, ...]
    domain: Markup
    notes: tuple[tuple[str, Markup], ...]
    stated: Markup
    turned: Markup
    proved: tuple[Markup, ...]
    measured: Measured | None
    forms: tuple[FormView, ...]
    calls: tuple[tuple[str, str, str], ...]
    sources: Sources | None
    charts: tuple[str, ...]
    rests_on: tuple[RowView, ...]
    rows: tuple[RowView, ...]


def describe_quantities(source: JudgedDerivation) -> Iterator[QuantityView]:
    """Describe every quantity of a paper."""
    paper = source.ledger.paper
    kernels = {kernel.name: kernel for kernel in build_functions(paper).kernels}
    header = write_header(paper)
    told = {quantity.name: quantity for quantity in source.told.quantities}
    for quantity in paper.quantities:
        name = f"{paper.system}.{quantity.name}"
        record = next((r for r in source.records if r.quantity == name), None)
        kernel = kernels.get(quantity.name)
        forms = told[quantity.name].forms
        yield QuantityView(
            quantity=quantity,
            arguments=tuple(_describe_arguments(quantity, paper.variables)),
            formula=write_definition(quantity, paper),
            given=tuple(write_given(quantity, paper)),
            domain=set_prose(re.sub(r"\boo\b", "∞", docstrings.describe_domain(quantity, paper))),
            notes=tuple(_pick_notes(kernel, paper)),
            stated=_describe_stated(quantity),
            turned=describe_turned(quantity, paper),
            proved=tuple(set_prose(form.proved) for form in forms if form.proved),
            measured=_describe_record(record, quantity) if record else None,
            forms=tuple(_list_forms(quantity, source, record)),
            calls=tuple(list_calls(quantity, source, header)),
            sources=write_sources(kernel, source) if kernel else None,
            charts=tuple(_name_charts(record)) if record else (),
            rests_on=tuple(_list_rows(quantity, source, of_paper=True)),
            rows=tuple(_list_rows(quantity, source, of_paper=False)),
        )


def _name_charts(record: Record) -> Iterator[str]:
    return (f"{record.quantity}, {workload}" for workload, _ in list_workloads(record))


def _list_rows(
    quantity: Quantity, source: JudgedDerivation, *, of_paper: bool
) -> Iterator[RowView]:
    """Yield views of its rows in the paper's module if `of_paper`, else of those on its code."""
    judgements, paper = source.ledger.judgements, source.ledger.paper
    stated = {row.number for row in paper.rows}
    anchors, symbols = name_anchors(row.number for row in judgements), name_symbols(paper)
    for row in judgements:
        if quantity.name in row.quantities and of_paper == (row.number in stated):
            yield describe_row(row, anchors[row.number], symbols, source.checks)


def _describe_arguments(
    quantity: Quantity, variables: Sequence[Variable]
) -> Iterator[ArgumentView]:
    for argument in quantity.arguments:
        symbols = Markup(", ").join(
            write_formula(write_letter(symbol, variables, [quantity.definition]))
            for symbol in argument.symbols
        )
        default = "" if argument.default is None else f", default {argument.default:g}"
        yield argument, symbols, f"{shape_of(argument, quantity)}{default}"


def _pick_notes(kernel: Kernel | None, paper: Paper) -> Iterator[tuple[str, Markup]]:
    """Yield the notes other than domain, accuracy and source, which are shown elsewhere."""
    for note in docstrings.list_notes(kernel, paper) if kernel else ():
        lead, colon, rest = note.partition(": ")
        if lead not in ("Domain", docstrings.TESTED, "Source"):
            named = colon and len(lead.split()) == 1
            yield (lead, set_prose(rest)) if named else ("", set_prose(note))


def _describe_stated(quantity: Quantity) -> Markup:
    if quantity.accuracy is None:
        return Markup()
    return set_prose(docstrings.describe_accuracy(quantity.accuracy, input_names(quantity)))


def _describe_record(record: Record, quantity: Quantity) -> Measured:
    first = record.ways[0].name
    rows = record.errors_of(first)
    worst = record.worst_of(first)
    searched = "; ".join(_describe_searched(found, quantity) for found in record.searched)
    machine = record.machine
    return Measured(
        worst="none" if worst is None else f"{worst:.3g}",
        usual=set_prose(_describe_usual(record, quantity)),
        unit=record.error_unit,
        absolute="" if quantity.unit == "1" else docstrings.describe_unit(quantity.unit),
        points=f"{sum(row.points - row.undecided for row in rows):,}",
        searched=set_prose(searched),
        swept=set_prose(_describe_swept(record, quantity)),
        taken=record.taken[:10],
        machine=f"{machine.processor}, NumPy {machine.versions.get('numpy', '')}",
        is_quick=record.quick,
        timed=", ".join(f"{count:,} points, {name}" for name, count in list_workloads(record)[:1]),
    )


def _describe_usual(record: Record, quantity: Quantity) -> str:
    """Return the points of usual errors; a sweep ends after a number of half turns."""
    usual = find_usual_set(record)
    if goes_on(quantity) and usual.startswith("sweep"):
        return f"{usual}, over {SWEEP // 2} turns of {quantity.arguments[0].name}"
    return usual


def _describe_swept(record: Record, quantity: Quantity) -> str:
    """Return the largest error of a position over some turns; a sweep keeps all other sizes."""
    usual, first = find_usual_set(record), record.ways[0].name
    errors = next((e for e in record.errors_of(first) if e.set == usual), None)
    if not (goes_on(quantity) and usual.startswith("sweep") and errors and errors.worst_at):
        return ""
    sizes = ", ".join(map(_describe_point, quantity.arguments[1:], errors.worst_at[1:]))
    largest = f"{errors.worst_absolute:.1e} {quantity.unit}"
    return f"over {SWEEP // 2} turns at most {largest} on {errors.points:,} points, with {sizes}"


def _describe_searched(found: Searched, quantity: Quantity) -> str:
    at = ", ".join(map(_describe_point, quantity.arguments, found.at))
    return f"{found.scaled:.3g} ({found.way}) at {at}"


def _describe_point(argument: Argument, value: object) -> str:
    """Return an argument and its value; of many numbers only the count, as in the record."""
    parts = value if isinstance(value, tuple | list) else [value]
    if len(parts) > MANY:
        rows = " in a matrix" if isinstance(parts[0], tuple | list) else ""
        return f"{len(parts)} {argument.name}{rows}"
    numbers = [f"{part:.6g}" if isinstance(part, float) else str(part) for part in parts]
    told = numbers[0] if len(numbers) == 1 else f"({', '.join(numbers)})"
    return f"{argument.name} = {told}"


def _list_forms(
    quantity: Quantity, source: JudgedDerivation, record: Record | None
) -> Iterator[FormView]:
    """Yield the forms with their current verdicts, then the other ways measured."""
    judged = {j.number: j for j in source.ledger.judgements}
    count = len(quantity.shipped)
    for place, form in enumerate(quantity.forms):
        # Errors and times of the kernel are measured for all its forms together.
        measured = "" if 0 < place < count else form.name if place else "kernel"
        row = judged.get(number_form(quantity, form))
        view = _view_form(form, place < count, row, record, measured, source.told.variables)
        yield view if measured else replace(view, note=TOGETHER)
    known = {"kernel", *(form.name for form in quantity.rivals)}
    for number, way in enumerate(record.ways if record else ()):
        if way.name not in known:
            note, costs = set_prose(way.note), _find_costs(record, way.name)
            look = look_of(way.verdict)
            yield FormView(way.name, number == 0, look, way.rung, note, costs)
    if record and record.lacking:
        look = VerdictStyle("unjudged", "", "", "")
        yield FormView(IN_C, False, look, "", Markup("not measured"), Costs())


def _view_form(
    form: Form,
    shipped: bool,
    row: Judgement | None,
    record: Record | None,
    way: str,
    variables: Sequence[Variable],
) -> FormView:
    look = look_of(row.verdict) if row else VerdictStyle("unjudged", "not judged", "", "")
    parts = [
        Markup("{} {}").format(says, write_formula(write_latex(value, variables)))
        for says, value in (("where", form.when), ("off by at most", form.bound))
        if value is not None
    ]
    note = Markup("; ").join([*parts, *filter(None, (set_prose(form.note),))])
    rung = row.rung if row else ""
    return FormView(form.name, shipped, look, rung, note, _find_costs(record, way))


def _find_costs(record: Record | None, way: str) -> Costs:
    """Return the errors, the time per point of the first workload, and its ratio, as text."""
    if record is None:
        return Costs()
    usual = next((e for e in record.errors_of(way) if e.set == find_usual_set(record)), None)
    timing = find_time(record, way, *list_workloads(record)[0])
    return Costs(
        error=_write_found(record.worst_of(way)),
        usual=_write_found(usual.worst_scaled if usual else None),
        absolute=_write_found(usual.worst_absolute if usual else None),
        time=_write_found(timing.median if timing else None),
        ratio=_write_found(timing.ratio if timing else None),
    )


def _write_found(value: float | None) -> str:
    if value is None:
        return ""
    return "none right" if value == float("inf") else set_numbers(f"{value:.3g}")
