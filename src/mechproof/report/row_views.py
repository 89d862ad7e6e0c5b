"""Rows: the judgements of a paper as its page shows them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

from markupsafe import Markup

from mechproof.ledger.judged import PLAIN
from mechproof.proof.verdict import Evidence, Judgement, Left, Verdict
from mechproof.record import MARKS, Paper, Row
from mechproof.report.formulas import write_lines, write_print
from mechproof.report.mathml import write_formula
from mechproof.report.phrases import (
    LEFT,
    NOT_JUDGED,
    VerdictStyle,
    look_of,
    set_numbers,
    set_prose,
    set_reason,
    set_value,
)
from mechproof.sources.located_text import Place

# Evidence beyond so many items is folded away.
SHOWN = 4
NOTHING = Markup()
# Letters of LaTeX beyond which a formula is folded away, and beyond which it is no more set.
LONG, LONGEST = 500, 3000
MARKED = {**MARKS, "as typed": "its statement was typed by hand, not read from the print"}


@dataclass(frozen=True)
class Witness:
    """One piece of evidence: what it is, where, and the two values."""

    what: Markup
    at: Sequence[tuple[Markup, str]]
    printed: str
    rebuilt: str


@dataclass(frozen=True)
class RowView:
    """One row of a page; without a judgement `failure` says why.

    `place` is where it stands in a paper's own source, `sides` are what its two values are.
    """

    anchor: str
    number: str
    look: VerdictStyle
    is_plain: bool
    marks: tuple[str, ...]
    printed: Markup
    read_as: str = ""
    reason: Markup = NOTHING
    compared: Markup = NOTHING
    compared_is_long: bool = False
    evidence: tuple[Witness, ...] = ()
    more_evidence: tuple[Witness, ...] = ()
    corrected: Markup = NOTHING
    corrected_by: str = ""
    on: Markup = NOTHING
    singular: Markup = NOTHING
    rung: str = ""
    checked: str = ""
    failure: str = ""
    place: str = ""
    sides: tuple[str, str] = ("", "")


def name_symbols(paper: Paper) -> dict[str, str]:
    """Return how the paper prints the symbols that evidence names."""
    printed = {str(v.symbol): v.latex[0] for v in paper.variables if v.latex}
    return {name: latex for name, latex in printed.items() if "#" not in latex}


def describe_row(
    row: Judgement,
    anchor: str,
    symbols: Mapping[str, str],
    checks: Mapping[str, str] = MappingProxyType({}),
) -> RowView:
    """Return the view of a judgement; `symbols` are those of its paper as it prints them.

    `checks` say of rows, by their ids, whether Coq has checked them.
    """
    witnesses = tuple(_describe_evidence(item, symbols) for item in row.evidence)
    return RowView(
        anchor=anchor,
        number=row.number,
        look=look_of(row.verdict),
        is_plain=row.verdict in PLAIN,
        marks=row.marks,
        printed=write_print(row.printed_latex),
        read_as=row.read_as,
        reason=set_reason(row.reason),
        compared=_write_compared(row.compared_with),
        compared_is_long=len(row.compared_with) > LONG,
        evidence=witnesses[:SHOWN],
        more_evidence=witnesses[SHOWN:],
        corrected=write_print(row.corrected_latex),
        corrected_by=row.corrected_by,
        on=set_prose(row.on),
        singular=set_prose(", ".join(row.singular)),
        rung="" if row.verdict is Verdict.NOT_CHECKABLE else row.rung,
        checked=checks.get(row.id, ""),
        place=_say_place(row.place),
        sides=row.sides,
    )


def describe_failure(row: Row, anchor: str, failure: str) -> RowView:
    """Return the view of a row that could not be judged."""
    printed = write_print(row.printed_latex)
    return RowView(
        anchor, row.number, NOT_JUDGED, False, row.marks, printed, row.read_as, failure=failure
    )


def describe_left(row: Left, anchor: str) -> RowView:
    """Return the view of a row of a paper's own source that has no verdict."""
    look, printed = LEFT[row.state], write_print(row.printed_latex)
    says = ". ".join(filter(None, (row.reason, row.remedy)))
    return RowView(
        anchor, row.number, look, False, (), printed, failure=says, place=_say_place(row.place)
    )


def _write_compared(latex: str) -> Markup:
    if len(latex) > LONGEST:
        return Markup('<code class="latex">{}</code>').format(latex)
    return write_lines(latex)


def _say_place(place: Place | None) -> str:
    return f"line {place.line}" if place else ""


def describe_print(row: Row, anchor: str) -> RowView:
    """Return the view of a row that nobody has judged: what is printed, and how it is read."""
    look = VerdictStyle("unjudged", "", "", "")
    return RowView(
        anchor, row.number, look, True, row.marks, write_print(row.printed_latex), row.read_as
    )


def _describe_evidence(item: Evidence, symbols: Mapping[str, str]) -> Witness:
    at = [(_write_symbol(name, symbols), set_value(value)) for name, value in item.at.items()]
    return Witness(set_prose(item.what), at, set_numbers(item.printed), set_numbers(item.rebuilt))


def _write_symbol(name: str, symbols: Mapping[str, str]) -> Markup:
    return write_formula(symbols[name]) if name in symbols else set_prose(name)
