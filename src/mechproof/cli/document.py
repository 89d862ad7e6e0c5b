"""A checked paper on a terminal: its rows, what was not read by its causes, and totals."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from rich.text import Text

from mechproof.cli.console import say
from mechproof.cli.ledger import STYLES, print_details
from mechproof.document.checking import CheckedPaper, CheckedRow
from mechproof.document.rows import State
from mechproof.proof.verdict import Verdict

PLAIN = (Verdict.PROVED.value, Verdict.DEFINITION.value)


def print_checked(paper: CheckedPaper, *, show_all: bool) -> None:
    """Print a line for each row, the details of those that are not plain, and what is left out."""
    say(Text(f"{paper.file}: {_count(paper.rows, 'row')}", style="bold"))
    for row in paper.rows:
        if row.judgement:
            _print_row(row)
        if row.judgement and (show_all or row.outcome not in PLAIN):
            print_details(row.judgement, ("one side", "other side"))
    for state in (State.NOT_READ, State.NOT_JUDGED, State.SKIPPED):
        _print_left([row for row in paper.rows if row.state is state], state)
    for place, reason in paper.missing:
        say(f"{place}: {reason}")
    if paper.taken:
        say(
            "There is no block of letters: each letter is taken as a real number, or as the matrix "
            "that it is printed to be. --draft writes a block to be confirmed."
        )
        say(f"  taken so: {', '.join(paper.taken)}")
    counted = Counter(row.outcome for row in paper.rows)
    say(", ".join(f"{outcome} {number}" for outcome, number in sorted(counted.items())))


def _print_row(row: CheckedRow) -> None:
    assert row.judgement is not None
    style = STYLES[row.judgement.verdict]
    line = Text(f"{row.name}  ").append(row.outcome, style=style)
    say(line.append(f"  line {row.place.line}: {row.reason}"))


def _print_left(rows: Sequence[CheckedRow], state: State) -> None:
    """Print what was left out, rows of one cause in one line."""
    causes: dict[tuple[str, str], list[CheckedRow]] = {}
    for row in rows:
        causes.setdefault((row.reason, row.remedy), []).append(row)
    if causes:
        say(Text(f"{state.value}: {_count(rows, 'row')}", style="bold"))
    for (reason, remedy), met in causes.items():
        say(f"  {reason}")
        if remedy:
            say(f"  {remedy}")
        for row in met:
            say(f"    {row.name}  {row.place}  {' '.join(row.latex.split())}")


def _count(things: Sequence[object], name: str) -> str:
    return f"{len(things)} {name}{'' if len(things) == 1 else 's'}"
