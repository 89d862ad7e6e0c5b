"""The ledger on a terminal: findings, rows, totals; untruncated lines if it is piped."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence

from rich.table import Table
from rich.text import Text

from mechproof.cli.options import console, say
from mechproof.latex.changes import Style
from mechproof.ledger.cards import make_card
from mechproof.ledger.judged import PLAIN, Ledger, show_totals, sort_by_class, sort_findings
from mechproof.ledger.ledger_findings import LedgerFinding
from mechproof.proof.verdict import Judgement, Left, State, Verdict
from mechproof.record.papers import WEIGHTS

STYLES = {
    Verdict.PROVED: "green",
    Verdict.DEFINITION: "dim",
    Verdict.REFUTED: "bold red",
    Verdict.ILL_FORMED: "bold red",
    Verdict.CONDITIONAL: "yellow",
    Verdict.CONVENTION: "yellow",
    Verdict.UNDERDETERMINED: "cyan",
    Verdict.NOT_CHECKABLE: "dim cyan",
    Verdict.ENCLOSED: "magenta",
    Verdict.UNDECIDED: "bold magenta",
}
POINTER = (
    "What verdicts and marks mean: docs/verdicts.md of the sources, or the start page of "
    "`mechproof report`"
)


# What a mend removes from a print and adds to it, marked as in a word diff.
TAKEN = Style("[-{}-]".format, "-]{}[-".format)
PUT = Style("{{+{}+}}".format, "+}}{}{{+".format)
OPEN = (Verdict.UNDECIDED, Verdict.ENCLOSED)
MORE = "--findings shows what is right, and why; --all shows every row, with its evidence"


def print_ledgers(ledgers: Sequence[Ledger], *, show_findings: bool, show_all: bool) -> None:
    """Print a line for each finding, the gravest first, what is open, and the totals: one screen.

    If requested, the cards of all findings or every row of every paper come first.
    """
    findings = sort_findings(ledgers)
    for found in findings if show_findings else ():
        _print_finding(found)
    for ledger in ledgers if show_all else ():
        _print_paper(ledger)
    _print_lines(findings)
    for ledger in () if show_all else ledgers:
        print_left(ledger.left)
    rows = [row for ledger in ledgers for row in ledger.judgements]
    if undecided := [row for row in rows if row.verdict in OPEN]:
        _print_rows(undecided)
        say("")
    _print_sums(rows)
    counts = [count(ledgers, "paper"), count(rows, "row"), count(findings, "finding")]
    if left := [row for ledger in ledgers for row in ledger.left]:
        counts.append(f"{count(left, 'row')} without a verdict")
    say(", ".join(counts))
    if not (show_findings or show_all):
        say(MORE)
    say(POINTER)


def _print_lines(findings: Sequence[LedgerFinding]) -> None:
    """Print on a line each where something is wrong, its verdict, and its first cost or weight."""
    cells = [
        (
            f"{f.system} {f.number}",
            f.verdict.value,
            str(f.costs[0]) if f.costs else WEIGHTS[f.weight],
        )
        for f in findings
    ]
    if not console.is_terminal:
        _print_padded(cells)
    else:
        table = Table.grid(padding=(0, 2, 0, 0))
        for _ in range(3):
            table.add_column(no_wrap=True, overflow="ellipsis")
        for number, verdict, cost in cells:
            styled = Text(verdict, style=STYLES[Verdict(verdict)])
            table.add_row(Text(number), styled, Text(cost))
        console.print(table)
    if findings:
        say("")


def count(things: Sequence[object], name: str) -> str:
    """Return the number of things with their name, in the plural if necessary."""
    return f"{len(things)} {name}{'' if len(things) == 1 else 's'}"


def _print_paper(ledger: Ledger) -> None:
    say(Text(f"{ledger.system}: {ledger.citation}", style="bold"))
    _print_rows(ledger.judgements)
    for row in ledger.judgements:
        if row.verdict not in PLAIN:
            print_details(row)
    print_left(ledger.left)
    for name, line in show_totals(ledger.judgements).items():
        say(f"{name}: {line}")
    say("")


def print_left(rows: Sequence[Left]) -> None:
    """Print the rows without a verdict by how far they got, grouped by cause."""
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
    classes = sort_by_class(rows)
    counted = {name: Counter(row.verdict for row in found) for name, found in classes.items()}
    lines = [[v.value, *(str(found[v] or "") for found in counted.values())] for v in Verdict]
    _print_padded([["verdict", *counted], *(line for line in lines if any(line[1:]))])
    say("")


def _print_finding(found: LedgerFinding) -> None:
    """Print the card: what is printed, right, wrong, what it costs, a check, the figure."""
    marks = f" ({', '.join(found.marks)})" if found.marks else ""
    heading = f"{found.system} {found.number}: {found.verdict}{marks}: {WEIGHTS[found.weight]}"
    say(Text(heading, style="bold"))
    card = make_card(found, TAKEN, PUT)
    lines = [("printed", _plain(card.printed))]
    for label, latex, by in card.mends:
        name = label.lower().removeprefix("in ")
        lines += [(name, f"{latex}   (proved: {by})")] if latex else []
    lines.append(("why", found.wrong))
    lines += [("costs", str(cost)) for cost in found.costs]
    lines += [("check", found.check)] if found.check else []
    lines += [("figure", f"{found.system}.{found.figure}")] if found.figure else []
    lines += [("follows", number) for number in found.follows]
    _print_fields(lines)
    say("")


def _print_rows(rows: Sequence[Judgement]) -> None:
    cells = [_to_cells(row) for row in rows]
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
    """Print all that the ledger has on a row; `names` are those of its two sides."""
    say(Text(f"{row.number}: ").append(row.verdict, style=STYLES[row.verdict]))
    lines = [("place", str(row.place))] if row.place else []
    lines += [("printed", _plain(row.printed_latex))]
    lines += [("read as", row.read_as)] if row.read_as else []
    lines += [("compared", row.compared_with)] if row.compared_with else []
    lines += [("reason", row.reason), ("rung", row.rung)]
    for item in row.evidence:
        values = item.list_values(names or row.sides)
        lines.append(("evidence", "; ".join([item.what, *values])))
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
    r"""Return a sentence without the \text{} around it, any other LaTeX unchanged."""
    sentence = re.fullmatch(r"\\text\{([^\\{}]*)\}", latex)
    return sentence[1] if sentence else latex
