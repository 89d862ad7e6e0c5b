"""Papers: a ledger in the order of its paper, as its page shows it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import sympy as sp
from markupsafe import Markup

from mechproof.ledger.cards import Card, make_card
from mechproof.ledger.judged import OURS, JudgedPaper, classify, sort_by_class
from mechproof.ledger.ledger_findings import LedgerFinding
from mechproof.proof.anchors import find_only_equation, name_anchors, name_equation
from mechproof.proof.comparison_latex import write_latex, write_letter
from mechproof.proof.verdict import Judgement, Left
from mechproof.record import Equality, Paper, Row, Variable
from mechproof.record.papers import WEIGHTS
from mechproof.report.judged_derivations import JudgedDerivation
from mechproof.report.mathml import write_formula
from mechproof.report.pages import (
    RowView,
    describe_failure,
    describe_left,
    describe_print,
    describe_row,
    name_symbols,
)
from mechproof.report.phrases import LEFT, LOOKS, NOT_JUDGED, VerdictStyle, look_of

CONSEQUENCE = "consequence"


@dataclass(frozen=True)
class FindingView:
    """A finding and its card, with links to the row that shows it and to those that follow."""

    found: LedgerFinding
    card: Card
    look: VerdictStyle
    matter: str
    anchor: str
    follows: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class Count:
    """The number of rows of a class that have a verdict."""

    look: VerdictStyle
    number: int


@dataclass(frozen=True)
class Total:
    """A class of rows and its verdicts."""

    name: str
    counts: tuple[Count, ...]


@dataclass(frozen=True)
class Entry:
    """An item in the sequence of a paper: a row, and the equation that begins with it, if any."""

    row: RowView
    begins: str = ""
    figures: tuple[str, ...] = ()


@dataclass(frozen=True)
class EquationLink:
    """An equation of the index: its number, its anchor, and the gravest of its verdicts."""

    number: str
    anchor: str
    look: VerdictStyle


@dataclass(frozen=True)
class SymbolView:
    """A symbol of a paper."""

    name: Markup
    meaning: str
    dimension: str
    within: Markup
    given: Markup


@dataclass(frozen=True)
class Section:
    """A part of the page: its rows in order."""

    key: str
    title: str
    says: str
    entries: tuple[Entry, ...]


@dataclass(frozen=True)
class PaperView:
    """The page of a paper; the `loose` ones of its `figures` belong to no row.

    `found` counts the verdicts of printed rows, `ours` those of our own rows on the page (rows on
    kernels are on the pages of their quantities), `left` the rows of a paper's own source that have
    no verdict.
    """

    paper: Paper
    totals: tuple[Total, ...]
    found: tuple[Count, ...]
    ours: tuple[Count, ...]
    left: tuple[Count, ...]
    findings: tuple[FindingView, ...]
    failures: tuple[str, ...]
    index: tuple[EquationLink, ...]
    sections: tuple[Section, ...]
    figures: tuple[str, ...]
    loose: tuple[str, ...]
    printed_symbols: tuple[SymbolView, ...]
    own_symbols: tuple[SymbolView, ...]


def describe_paper(source: JudgedDerivation, figures: Mapping[str, str]) -> PaperView:
    """Describe a paper; `figures` map names to the number of the row after which each is shown."""
    ledger = source.ledger
    paper = ledger.paper
    anchors = _name_all(ledger)
    sections = tuple(_list_sections(source, anchors, figures))
    shown = {name for section in sections for entry in section.entries for name in entry.figures}
    on_page = {entry.row.number for section in sections for entry in section.entries}
    shown_rows = [row for row in ledger.judgements if row.number in on_page]
    return PaperView(
        paper=paper,
        totals=tuple(count_totals(ledger.judgements)),
        found=count_verdicts([row for row in ledger.judgements if "ours" not in row.marks]),
        ours=count_verdicts([row for row in shown_rows if classify(row) == OURS]),
        left=count_left(ledger.left),
        findings=tuple(describe_finding(found, anchors) for found in ledger.findings),
        failures=tuple(_strip_failures(source)),
        index=tuple(_index_equations(sections[0].entries)),
        sections=tuple(section for section in sections if section.entries),
        figures=tuple(figures),
        loose=tuple(name for name in figures if name not in shown),
        printed_symbols=tuple(_describe_symbol(v, paper) for v in paper.variables if v.latex),
        own_symbols=tuple(_describe_symbol(v, paper) for v in paper.variables if not v.latex),
    )


def _name_all(ledger: JudgedPaper) -> dict[str, str]:
    numbers = [row.number for row in ledger.paper.rows]
    numbers += [row.number for row in ledger.judgements]
    return name_anchors(dict.fromkeys(numbers))


def describe_finding(found: LedgerFinding, anchors: Mapping[str, str]) -> FindingView:
    """Describe a finding, given the anchors of its paper's rows."""
    return FindingView(
        found,
        make_card(found),
        look_of(found.verdict),
        WEIGHTS[found.weight],
        anchors[found.number],
        tuple((number, anchors[number]) for number in found.follows),
    )


def count_totals(judgements: Sequence[Judgement]) -> Iterator[Total]:
    """Yield the verdict counts of each class of rows, without a sum over classes."""
    for name, rows in sort_by_class(judgements).items():
        yield Total(name, count_verdicts(rows))


def count_verdicts(judgements: Sequence[Judgement]) -> tuple[Count, ...]:
    """Count verdicts, the gravest first."""
    counted = Counter(str(row.verdict) for row in judgements)
    return tuple(
        Count(look, counted[verdict]) for verdict, look in LOOKS.items() if counted[verdict]
    )


def count_left(rows: Sequence[Left]) -> tuple[Count, ...]:
    """Count rows without a verdict by how far they got."""
    counted = Counter(row.state for row in rows)
    return tuple(Count(look, counted[state]) for state, look in LEFT.items() if counted[state])


def _list_sections(
    source: JudgedDerivation, anchors: Mapping[str, str], figures: Mapping[str, str]
) -> Iterator[Section]:
    paper, judged = source.ledger.paper, {j.number: j for j in source.ledger.judgements}
    own = {row.number for row in paper.rows}
    follows = {row.number for row in paper.rows if CONSEQUENCE in row.marks}
    again = {
        f"{follower.row}, with {finding.row} corrected"
        for finding in paper.findings
        for follower in finding.followers
    }
    elsewhere = {row.number for row in paper.rows if row.quantities}
    views = [view for view in _view_rows(source, anchors) if view.number not in elsewhere]
    printed = [view for view in views if view.number not in follows]
    yield Section(
        "rows", "The paper, row by row", "", tuple(_place(printed, figures, mark_equations=True))
    )
    yield Section(
        "consequences",
        "Consequences",
        "What the rows mean for the paper's own numbers and conclusions, each number recomputed.",
        tuple(_place([view for view in views if view.number in follows], figures)),
    )
    about = (name_symbols(paper), source.checks)
    others = [row for number, row in judged.items() if number in again - own]
    yield Section(
        "corrected",
        "With the correction inserted",
        "What follows from a finding is true with its correction in place of the print.",
        tuple(_place([describe_row(r, anchors[r.number], *about) for r in others], figures)),
    )


def _view_rows(source: JudgedDerivation, anchors: Mapping[str, str]) -> list[RowView]:
    """Return views of the paper's own rows; those without a judgement say why they have none."""
    ledger, about = source.ledger, (name_symbols(source.ledger.paper), source.checks)
    views = {j.number: describe_row(j, anchors[j.number], *about) for j in ledger.judgements}
    views |= {row.number: describe_left(row, anchors[row.number]) for row in ledger.left}
    return [
        views[row.number]
        if row.number in views
        else describe_failure(row, anchors[row.number], _find_failure(source, row))
        for row in ledger.paper.rows
    ]


def _find_failure(source: JudgedDerivation, row: Row) -> str:
    start = f"row {row.number}: "
    failures = (f for f in _strip_failures(source) if f.startswith(start))
    return next(failures, "").removeprefix(start)


def _strip_failures(source: JudgedDerivation) -> Iterator[str]:
    """Yield the failures without the file's path, which means nothing to the reader."""
    return (text.removeprefix(f"{source.location}: ") for text in source.ledger.failures)


def _place(
    views: Iterable[RowView], figures: Mapping[str, str], *, mark_equations: bool = False
) -> Iterator[Entry]:
    """Add figures to their rows, and an anchor to the first row of an equation that has none."""
    views = list(views)
    taken = {view.anchor for view in views}
    for view in views:
        begins = ""
        if mark_equations and (equation := find_only_equation(view.number)):
            anchor = name_equation(equation)
            begins = "" if anchor in taken else anchor
            taken.add(anchor)
        after = tuple(name for name, number in figures.items() if number == view.number)
        yield Entry(view, begins, after)


def _index_equations(entries: Sequence[Entry]) -> Iterator[EquationLink]:
    """Yield the equations in the paper's order, each with the gravest verdict of its rows."""
    groups: dict[str, list[Entry]] = {}
    for entry in entries:
        if "ours" not in entry.row.marks and (equation := find_only_equation(entry.row.number)):
            groups.setdefault(equation, []).append(entry)
    order = [NOT_JUDGED, *LEFT.values(), *LOOKS.values()]
    for equation, group in groups.items():
        gravest = min((entry.row.look for entry in group), key=order.index)
        yield EquationLink(f"({equation})", group[0].begins or group[0].row.anchor, gravest)


def list_prints(paper: Paper) -> list[RowView]:
    """Return views of the rows of a paper that nobody has judged."""
    anchors = name_anchors(row.number for row in paper.rows)
    return [describe_print(row, anchors[row.number]) for row in paper.rows]


def _list_formulas(paper: Paper) -> Iterator[sp.Basic]:
    """Yield formulas that show how many indices a family has."""
    yield from (quantity.definition for quantity in paper.quantities)
    yield from (row.says.rebuilt for row in paper.rows if isinstance(row.says, Equality))


def _describe_symbol(variable: Variable, paper: Paper) -> SymbolView:
    given = variable.given
    return SymbolView(
        name=write_formula(write_letter(variable.symbol, [variable], _list_formulas(paper))),
        meaning=variable.meaning + (f"; {variable.sign}" if variable.sign else ""),
        dimension="angle" if variable.dimension.is_angle else str(variable.dimension),
        within=write_formula(write_latex(variable.within, ())),
        given=Markup("") if given is None else write_formula(write_latex(given, paper.variables)),
    )
