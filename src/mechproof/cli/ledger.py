"""The ledger on a terminal, as a table; where it is piped, as full lines."""

from __future__ import annotations

import re
from collections.abc import Sequence

from rich.table import Table
from rich.text import Text

from mechproof.cli.console import console, say
from mechproof.proof.ledger import PLAIN, show_totals
from mechproof.proof.verdict import Judgement, Verdict
from mechproof.record import Paper

COLUMNS = ("number", "verdict", "rung", "reason")
STYLES = {
    Verdict.PROVED: "green",
    Verdict.DEFINITION: "dim",
    Verdict.REFUTED: "bold red",
    Verdict.ILL_FORMED: "bold red",
    Verdict.CONDITIONAL: "yellow",
    Verdict.CONVENTION: "yellow",
    Verdict.UNDERDETERMINED: "cyan",
    Verdict.ENCLOSED: "magenta",
    Verdict.UNDECIDED: "bold magenta",
}


def print_ledger(paper: Paper, judgements: Sequence[Judgement]) -> None:
    """Print the rows of a paper, the details of those that are not plain, and the totals."""
    title = f"{paper.system}: {paper.citation}"
    print_rows = _print_table if console.is_terminal else _print_lines
    print_rows(title, judgements)
    for row in judgements:
        if row.verdict not in PLAIN:
            _print_details(row)
    for label, ours in (("printed", False), ("ours", True)):
        say(f"{paper.system}, {label}: {show_totals(judgements, ours)}")
    say("")


def _to_cells(row: Judgement) -> tuple[str, str, str, str]:
    marks = f" ({', '.join(row.marks)})" if row.marks else ""
    return (f"{row.number}{marks}", row.verdict.value, row.rung, row.reason)


def _print_lines(title: str, judgements: Sequence[Judgement]) -> None:
    rows = [COLUMNS, *map(_to_cells, judgements)]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    say(title)
    for row in rows:
        padded = (cell.ljust(width) for cell, width in zip(row, widths, strict=True))
        say("  ".join(padded).rstrip())


def _print_table(title: str, judgements: Sequence[Judgement]) -> None:
    table = Table(title=Text(title), title_justify="left", expand=True)
    table.add_column("number", ratio=3)
    table.add_column("verdict", no_wrap=True, min_width=15)
    table.add_column("rung", ratio=2)
    table.add_column("reason", ratio=5, no_wrap=True, overflow="ellipsis")
    for row in judgements:
        number, verdict, rung, reason = _to_cells(row)
        styled = Text(verdict, style=STYLES[row.verdict])
        table.add_row(Text(number), styled, Text(rung), Text(reason))
    console.print(table)


def _print_details(row: Judgement) -> None:
    say(Text(f"{row.number}: ").append(row.verdict, style=STYLES[row.verdict]))
    lines = [("printed", _plain(row.printed_latex))]
    lines += [("read as", row.read_as)] if row.read_as else []
    lines.append(("reason", row.reason))
    for item in row.evidence:
        at = ", ".join(f"{name} = {value}" for name, value in item.at.items())
        sides = [f"at {at}"] if at else []
        sides += [f"printed {item.printed}"] if item.printed else []
        sides += [f"rebuilt {item.rebuilt}"] if item.rebuilt else []
        lines.append(("evidence", "; ".join([item.what, *sides])))
    if row.corrected_latex:
        proof = f"   (proved: {row.corrected_by})" if row.corrected_by else ""
        lines.append(("corrected", row.corrected_latex + proof))
    for label, text in lines:
        say(Text(f"  {label:9} ", style="dim").append(Text(text, style="default")))


def _plain(latex: str) -> str:
    r"""Drop the \text{} around a sentence."""
    sentence = re.fullmatch(r"\\text\{([^\\{}]*)\}", latex)
    return sentence[1] if sentence else latex
