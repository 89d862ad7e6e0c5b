"""A checked paper on a terminal: its rows, what was not read by its causes, and totals."""

from __future__ import annotations

from collections import Counter

from rich.text import Text

from mechproof.cli.console import say
from mechproof.cli.ledger import STYLES, count, print_details, print_left
from mechproof.document.checked_rows import CheckedRow
from mechproof.document.checking import CheckedPaper
from mechproof.proof.verdict import Verdict

PLAIN = (Verdict.PROVED.value, Verdict.DEFINITION.value)


def print_checked(paper: CheckedPaper, *, show_all: bool) -> None:
    """Print a line for each row, the details of those that are not plain, and what is left out."""
    say(Text(f"{paper.file}: {count(paper.rows, 'row')}", style="bold"))
    for row in paper.rows:
        if row.judgement:
            _print_row(row)
        if row.judgement and (show_all or row.outcome not in PLAIN):
            print_details(row.judgement)
    print_left([row.leave() for row in paper.rows if not row.judgement])
    for place, reason in (*paper.missing, *paper.told):
        say(f"{place}: {reason}")
    if paper.taken:
        say(
            "There is no block of letters, so each letter is taken to be a real number, or the "
            "matrix it is printed or, in bold, used as. --draft writes a block for you to confirm."
        )
        say(f"  letters taken: {', '.join(paper.taken)}")
    counted = Counter(row.outcome for row in paper.rows)
    say(", ".join(f"{outcome} {number}" for outcome, number in sorted(counted.items())))


def _print_row(row: CheckedRow) -> None:
    assert row.judgement is not None
    style = STYLES[row.judgement.verdict]
    line = Text(f"{row.name}  ").append(row.outcome, style=style)
    say(line.append(f"  line {row.place.line}: {row.reason}"))
