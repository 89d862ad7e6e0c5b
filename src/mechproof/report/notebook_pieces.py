"""Fragments: takes a single object, returns the piece of a page that a notebook shows."""

from __future__ import annotations

import re
from dataclasses import fields
from fractions import Fraction
from inspect import cleandoc
from typing import Any

from mechproof.ledger.judged import JudgedPaper
from mechproof.plot.canvas import use_style
from mechproof.plot.figures import write_svg
from mechproof.plot.motion_plot import motion
from mechproof.proof.anchors import name_anchors
from mechproof.proof.verdict import Judgement
from mechproof.record import Paper
from mechproof.report.pages import describe_row, name_symbols, read_stylesheet, render
from mechproof.report.paper_pages import count_totals, describe_finding, list_prints
from mechproof.report.pictures import Picture

SECTION = re.compile(r"\nParameters\n-+\n(.*?)(?:\n\n|\Z)", re.DOTALL)
ENTRY = re.compile(r"^(\S.*?) : .*\n((?:    .*\n?)+)", re.MULTILINE)


def show(thing: object) -> str:
    """Return a paper, a ledger, a row of it or a mechanism as HTML with its style."""
    if isinstance(thing, Paper):
        return _render("paper", paper=thing, rows=list_prints(thing), totals=(), findings=())
    if isinstance(thing, JudgedPaper):
        return _show_ledger(thing)
    if isinstance(thing, Judgement):
        return _render("row", row=describe_row(thing, "", {}))
    return _show_mechanism(thing)


def _render(kind: str, **data: object) -> str:
    return render("fragment", kind=kind, style=read_stylesheet(), **data)


def _show_ledger(ledger: JudgedPaper) -> str:
    """Show findings and rows, without links, which would lead nowhere."""
    anchors = name_anchors(row.number for row in ledger.judgements)
    symbols = name_symbols(ledger.paper)
    return _render(
        "paper",
        paper=ledger.paper,
        rows=[describe_row(row, anchors[row.number], symbols) for row in ledger.judgements],
        totals=tuple(count_totals(ledger.judgements)),
        findings=[describe_finding(found, anchors) for found in ledger.findings],
    )


def _show_mechanism(mechanism: Any) -> str:
    meanings = read_parameters(type(mechanism).__doc__ or "")
    summary = cleandoc(type(mechanism).__doc__ or "").partition("\n")[0]
    values = [
        (field.name, _write(getattr(mechanism, field.name)), meanings.get(field.name, ""))
        for field in fields(mechanism)
    ]
    return _render(
        "mechanism",
        name=type(mechanism).__name__,
        summary=summary,
        values=values,
        picture=_draw_motion(mechanism),
    )


def read_parameters(text: str) -> dict[str, str]:
    """Return the meanings of a class's parameters from its docstring; names may share a line."""
    section = SECTION.search(cleandoc(text))
    entries = ENTRY.findall(f"{section[1]}\n" if section else "")
    return {
        name: " ".join(meaning.split())
        for names, meaning in entries
        for name in re.split(r",\s*", names)
    }


def _write(value: object) -> str:
    return str(value) if isinstance(value, Fraction | tuple) else repr(value)


def _draw_motion(mechanism: Any) -> Picture | None:
    """Return a picture of the motion of a mechanism, None if it has none."""
    try:
        canvas = motion(mechanism)[0].figure
    except TypeError:
        return None
    says = f"The motion of {mechanism!r}"
    with use_style({"svg.hashsalt": says}):
        return Picture(says, "", write_svg(canvas, says))  # type: ignore[arg-type]
