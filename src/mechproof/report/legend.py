"""Legend: the verdicts, marks and rungs that a report shows, each with its meaning."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from mechproof.proof.rungs import RUNGS
from mechproof.report.papers import PaperView
from mechproof.report.quantities import QuantityView
from mechproof.report.rows import MARKED
from mechproof.report.words import LOOKS, MEASURED, NOT_JUDGED, VerdictStyle


@dataclass(frozen=True)
class Legend:
    """What is explained to the reader: only what occurs."""

    looks: tuple[VerdictStyle, ...]
    marks: Mapping[str, str]
    rungs: Mapping[str, str]


def find_legend(papers: Sequence[PaperView], quantities: Sequence[QuantityView]) -> Legend:
    """Find what occurs in the rows of the papers and in the forms of their quantities."""
    rows = [e.row for paper in papers for section in paper.sections for e in section.entries]
    forms = [form for quantity in quantities for form in quantity.forms]
    looks = {row.look for row in rows} | {form.look for form in forms}
    marks = {mark for row in rows for mark in row.marks}
    joined = [row.rung for row in rows] + [form.rung for form in forms]
    rungs = {rung for names in joined for rung in names.split(", ")}
    return Legend(
        tuple(look for look in (NOT_JUDGED, *LOOKS.values(), MEASURED) if look in looks),
        {name: meaning for name, meaning in MARKED.items() if name in marks},
        {name: meaning for name, meaning in RUNGS.items() if name in rungs},
    )
