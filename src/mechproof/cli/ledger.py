"""The ledger on a terminal: findings, a table of rows, totals; full lines where it is piped."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence

from rich.table import Table
from rich.text import Text

from mechproof.cli.console import console, say
from mechproof.proof.findings import LedgerFinding
from mechproof.proof.ledger import COUNTED, PLAIN, Ledger, classify, show_totals
from mechproof.proof.verdict import Judgement, Left, State, Verdict

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
POINTER = (
    "What verdicts and marks mean: docs/verdicts.md of the sources, or the start page of "
    "`mechproof report`"
)


def print_ledgers(ledgers: Sequence[Ledger], *, show_all: bool) -> None:
    """Print the findings of all papers, then the rows and totals of each, then all totals.

    Rows that are proved or define are counted only, unless all are to be shown: then with the
    details of those that are not plain.
    """
    findings = [found for ledger in ledgers for found in ledger.findings]
    for found in findings:
        _print_finding(found)
    for ledger in ledgers:
        _print_paper(ledger, show_all)
    rows = [row for ledger in ledgers for row in ledger.judgements]
    if len(ledgers) > 1:
        _print_sums(rows)
    counts = [count(ledgers, "paper"), count(rows, "row"), count(findings, "finding")]
    if left := [row for ledger in ledgers for row in ledger.left]:
        counts.append(f"{count(left, 'row')} without a verdict")
    say(", ".join(counts))
    hidden = [row for row in rows if row.verdict in PLAIN]
    if hidden and not show_all:
        say(f"{count(hidden, 'row')} proved or defining not shown: --all shows every row")
    say(POINTER)


def count(things: Sequence[object], name: str) -> str:
    """Say how many things there are."""
    return f"{len(things)} {name}{'' if len(things) == 1 else 's'}"


def _print_paper(ledger: Ledger, show_all: bool) -> None:
    say(Text(f"{ledger.system}: {ledger.citation}", style="bold"))
    rows = [row for row in ledger.judgements if show_all or row.verdict not in PLAIN]
    _print_rows(rows, with_rungs=show_all)
    for row in rows if show_all else ():
        if row.verdict not in PLAIN:
            print_details(row)
    print_left(ledger.left)
    for name, line in show_totals(ledger.judgements).items():
        say(f"{name}: {line}")
    say("")


def print_left(rows: Sequence[Left]) -> None:
    """Print the rows that have no verdict by how far they got, those of one cause together."""
    for state in (State.NOT_READ, State.NOT_JUDGED, State.SKIPPED):
        met = [row for row in rows if row.state is state]
        causes = dict.fromkeys((row.reason, row.remedy) for row in met)
        if met:
            say(Text(f"{state.value}: {count(met, 'row')}", style="bold"))
        for cause in causes:
            for line in filter(None, cause):
                say(f"  {line}")
            for row in met:
                if (row.reason, row.remedy) == cause:
                    say(f"    {row.number}  {row.place}  {' '.join(row.printed_latex.split())}")


def _print_sums(rows: Sequence[Judgement]) -> None:
    """Print how many rows of each class have each verdict."""
    counted = Counter((row.verdict, classify(row)) for row in rows)
    names = [name for name in COUNTED if any(counted[v, name] for v in Verdict)]
    lines = [
        [v.value, *(str(counted[v, name] or "") for name in names)]
        for v in Verdict
        if any(counted[v, name] for name in names)
    ]
    _print_padded([["all papers", *names], *lines])


def _print_finding(found: LedgerFinding) -> None:
    marks = f" ({', '.join(found.marks)})" if found.marks else ""
    say(Text(f"Finding in {found.system}: {found.number}: {found.verdict}{marks}", style="bold"))
    lines = [("printed", _plain(found.printed_latex)), ("wrong", found.wrong)]
    lines += [("costs", cost) for cost in found.costs]
    if found.corrected_latex:
        lines.append(("right", f"{found.corrected_latex}   (proved: {found.corrected_by})"))
    lines += [("follows", number) for number in found.follows]
    _print_fields(lines)
    say("")


def _print_rows(rows: Sequence[Judgement], *, with_rungs: bool) -> None:
    cells = [_to_cells(row)[: 4 if with_rungs else 3] for row in rows]
    if not console.is_terminal:
        _print_padded(cells)
        return
    table = Table.grid(padding=(0, 2, 0, 0))
    table.add_column(max_width=console.width // 3)
    table.add_column(no_wrap=True)
    for number, verdict, *rest in cells:
        styled = Text(verdict, style=STYLES[Verdict(verdict)])
        table.add_row(Text(number), styled, *map(Text, rest))
    console.print(table)


def _to_cells(row: Judgement) -> tuple[str, ...]:
    marks = f" ({', '.join(row.marks)})" if row.marks else ""
    return (f"{row.number}{marks}", row.verdict, row.reason, row.rung)


def _print_padded(rows: Sequence[Sequence[str]]) -> None:
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for row in rows:
        padded = (cell.ljust(width) for cell, width in zip(row, widths, strict=True))
        say("  ".join(padded).rstrip())


def print_details(row: Judgement, names: tuple[str, str] | None = None) -> None:
    """Print all that the ledger has of a row; `names` are those of its two sides."""
    say(Text(f"{row.number}: ").append(row.verdict, style=STYLES[row.verdict]))
    lines = [("stands at", str(row.place))] if row.place else []
    lines += [("printed", _plain(row.printed_latex))]
    lines += [("read as", row.read_as)] if row.read_as else []
    lines += [("compared", row.compared_with)] if row.compared_with else []
    lines += [("reason", row.reason), ("rung", row.rung)]
    for item in row.evidence:
        at = ", ".join(f"{name} = {value}" for name, value in item.at.items())
        sides = [f"at {at}"] if at else []
        values = zip(names or row.sides, (item.printed, item.rebuilt), strict=True)
        sides += [f"{name} {value}" for name, value in values if value]
        lines.append(("evidence", "; ".join([item.what, *sides])))
    if row.corrected_latex:
        proof = f"   (proved: {row.corrected_by})" if row.corrected_by else ""
        lines.append(("corrected", row.corrected_latex + proof))
    _print_fields(lines)


def _print_fields(lines: Sequence[tuple[str, str]]) -> None:
    if not console.is_terminal:
        for label, text in lines:
            say(f"  {label:9} {text}")
        return
    table = Table.grid(padding=(0, 1, 0, 0))
    table.add_column(style="dim", no_wrap=True)
    table.add_column(overflow="fold")
    for label, text in lines:
        table.add_row(f"  {label}", Text(text))
    console.print(table)


def _plain(latex: str) -> str:
    r"""Drop the \text{} around a sentence."""
    sentence = re.fullmatch(r"\\text\{([^\\{}]*)\}", latex)
    return sentence[1] if sentence else latex
