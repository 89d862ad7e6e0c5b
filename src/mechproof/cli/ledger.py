"""The ledger on a terminal, as a table; where it is piped, as full lines."""

from __future__ import annotations

import re
from collections.abc import Sequence

from rich.table import Table
from rich.text import Text

from mechproof.cli.console import console, say
from mechproof.proof.findings import Found
from mechproof.proof.ledger import PLAIN, Ledger, show_totals
from mechproof.proof.verdict import Judgement, Verdict

COLUMNS = ("number", "verdict", "reason", "rung")
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


def print_ledger(ledger: Ledger) -> None:
    """Print the findings, the rows, the details of those that are not plain, and the totals."""
    title = f"{ledger.paper.system}: {ledger.paper.citation}"
    for found in ledger.findings:
        _print_finding(found)
    print_rows = _print_table if console.is_terminal else _print_lines
    print_rows(title, ledger.judgements)
    for row in ledger.judgements:
        if row.verdict not in PLAIN:
            print_details(row)
    for name, line in show_totals(ledger.judgements).items():
        say(f"{ledger.paper.system}, {name}: {line}")
    say("")


def _print_finding(found: Found) -> None:
    marks = f" ({', '.join(found.marks)})" if found.marks else ""
    say(Text(f"Finding in {found.system}: {found.number}: {found.verdict}{marks}", style="bold"))
    lines = [("printed", _plain(found.printed_latex)), ("wrong", found.wrong)]
    lines += [("costs", cost) for cost in found.costs]
    if found.corrected_latex:
        lines.append(("right", f"{found.corrected_latex}   (proved: {found.corrected_by})"))
    lines += [("follows", number) for number in found.follows]
    _print_fields(lines)
    say("")


def _to_cells(row: Judgement) -> tuple[str, str, str, str]:
    marks = f" ({', '.join(row.marks)})" if row.marks else ""
    return (f"{row.number}{marks}", row.verdict.value, row.reason, row.rung)


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
    table.add_column("reason", ratio=5, no_wrap=True, overflow="ellipsis")
    table.add_column("rung", ratio=2)
    for row in judgements:
        number, verdict, reason, rung = _to_cells(row)
        styled = Text(verdict, style=STYLES[row.verdict])
        table.add_row(Text(number), styled, Text(reason), Text(rung))
    console.print(table)


def print_details(row: Judgement, names: tuple[str, str] = ("printed", "rebuilt")) -> None:
    """Print all that the ledger has of a row; `names` are those of its two sides."""
    say(Text(f"{row.number}: ").append(row.verdict, style=STYLES[row.verdict]))
    lines = [("printed", _plain(row.printed_latex))]
    lines += [("read as", row.read_as)] if row.read_as else []
    lines += [("compared", row.compared_with)] if row.compared_with else []
    lines += [("reason", row.reason), ("rung", row.rung)]
    for item in row.evidence:
        at = ", ".join(f"{name} = {value}" for name, value in item.at.items())
        sides = [f"at {at}"] if at else []
        values = zip(names, (item.printed, item.rebuilt), strict=True)
        sides += [f"{name} {value}" for name, value in values if value]
        lines.append(("evidence", "; ".join([item.what, *sides])))
    if row.corrected_latex:
        proof = f"   (proved: {row.corrected_by})" if row.corrected_by else ""
        lines.append(("corrected", row.corrected_latex + proof))
    _print_fields(lines)


def _print_fields(lines: Sequence[tuple[str, str]]) -> None:
    for label, text in lines:
        say(Text(f"  {label:9} ", style="dim").append(Text(text, style="default")))


def _plain(latex: str) -> str:
    r"""Drop the \text{} around a sentence."""
    sentence = re.fullmatch(r"\\text\{([^\\{}]*)\}", latex)
    return sentence[1] if sentence else latex
