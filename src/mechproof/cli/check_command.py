"""The command that judges a paper's source, or one pasted equation."""

from __future__ import annotations

import sys
from collections import Counter
from pathlib import Path
from typing import Annotated

import typer
from rich.text import Text

from mechproof.cli import options
from mechproof.cli.ledger_command import STYLES, count, print_details, print_left
from mechproof.cli.options import ending, fail, refuse, say, show_progress
from mechproof.document.checked_rows import CheckedRow, rows_to_json
from mechproof.document.checking import CheckedPaper, check as check_paper
from mechproof.document.drafts.draft import draft_block
from mechproof.document.judging_workers import LIMIT
from mechproof.ledger.judged import Ledger, to_json
from mechproof.pipeline.pasted import Checked, PastedError, check_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import State, Verdict
from mechproof.sources.paper_files import STDIN, SUFFIXES, is_file, read_source
from mechproof.tools.processes import WorkerError

DEFAULTS = (
    "Unless you say otherwise, letters are real numbers, the first or last index of a sum is a "
    "natural number from 1 on, d in an integral is its differential, and e with letters in its "
    "exponent is Euler's number. A letter that also appears without a bracket multiplies the "
    r"bracket after it if that cannot be an argument, r(1-\cos x). \omega t, \pi p, \frac abt and "
    r"whatever follows two functions alike are one argument; \Delta x is one quantity. Nothing "
    "else is guessed."
)
SUCCESS = (Verdict.PROVED, Verdict.DEFINITION, Verdict.CONVENTION, State.SKIPPED)
DEFAULT = frozenset(options.OUTCOMES.values()) - {str(outcome.value) for outcome in SUCCESS}
REMARKS = {
    Verdict.REFUTED: "REFUTED means: not true for all values of its letters. If one of them "
    "depends on others (an angle on an angle), say so with --let 'letter=…'; if they are "
    "restricted, with --where.",
    Verdict.DEFINITION: "DEFINITION means: nothing was compared, since the equation itself defines "
    "the letter. To have it judged, give another value of the letter: --let 'letter=…'.",
}
PLAIN = (Verdict.PROVED.value, Verdict.DEFINITION.value)


def check(
    equations: Annotated[
        list[str],
        typer.Argument(
            metavar="FILE ... | EQUATION",
            help="Papers, .tex or .md, - for stdin; or one equation, chain or relation in LaTeX, "
            "a condition after it: |x|=x, x>0. Write -- before one that begins with a minus.",
        ),
    ],
    names: options.Names = None,
    factors: options.Factors = None,
    where: Annotated[
        options.Texts, typer.Option("--where", help="The domain: 0<x<1, A+B+C=\\pi.")
    ] = None,
    values: options.Values = None,
    natural: Annotated[
        options.Texts, typer.Option("--natural", help="A letter that stands for 1, 2, 3, …: n.")
    ] = None,
    start: Annotated[
        str, typer.Option("--from", help="The lower limit of integrals without limits: 0.")
    ] = "",
    draft: Annotated[
        bool,
        typer.Option(
            "--draft", help="Print a first block of letters for the paper; judge nothing."
        ),
    ] = False,
    show_all: Annotated[
        bool, typer.Option("--all", help="Show the details of every row of a paper.")
    ] = False,
    fail_on: options.FailOn = None,
    json_file: options.Rows = None,
    limit: Annotated[
        float,
        typer.Option(
            "--limit", metavar="SECONDS", min=0, help="Give up on an equation after this time."
        ),
    ] = LIMIT,
) -> None:
    """Judge the equations of papers, or one pasted equation.

    A paper declares its letters in a block of comments, from `%% mechproof` to `%% end`; --draft
    writes a first one. The first print of a letter defines it; later prints, derivatives and the
    steps of chains are compared with it. An argument that names no file is read as an equation.

    Exit status 0: every relation is PROVED, a DEFINITION or a CONVENTION, or the block skips its
    row; 1: one is not (a row that is ENCLOSED or not read counts), or has an outcome that --fail-on
    names, or takes too long or crashes; 2: bad usage, an empty domain, a paper without a displayed
    equation, or a pasted equation that cannot be read without guessing.
    """
    outcomes = options.read_outcomes(fail_on, DEFAULT)
    said = {"where": where, "values": values, "names": names, "factors": factors}
    said |= {"natural": natural}
    options.clear_json(json_file)
    if files := _find_files(equations):
        if start or any(said.values()):
            refuse("the letters of a paper are declared in its block of letters, not by options")
        met = _check_files(files, draft=draft, show_all=show_all, json_file=json_file, limit=limit)
    elif draft:
        refuse("--draft needs a paper")
    else:
        met = _check_equation(options.paste(equations[0], said, start), json_file, limit)
    if met & outcomes:
        raise typer.Exit(1)


def _find_files(equations: list[str]) -> list[str]:
    """Return the arguments if they are files, [] for an equation; refuse a mixture."""
    files = [text for text in equations if text == STDIN or is_file(text)]
    if len(files) == len(equations):
        return files
    if files or len(equations) > 1:
        other = next(text for text in equations if text not in files)
        refuse(f"{other}: there is no such file; give an equation alone, in quotes")
    if equations[0].endswith(SUFFIXES):
        refuse(f"{equations[0]}: there is no such file")
    return []


def _check_files(
    files: list[str], *, draft: bool, show_all: bool, json_file: Path | None, limit: float
) -> set[str]:
    """Check papers one after the other and return the outcomes that occur."""
    checked: list[CheckedPaper] = []
    for file in files:
        content = sys.stdin.read() if file == STDIN else None
        with ending(ValueError, refuse):
            if draft:
                say(draft_block(read_source(file, content)))
                continue
            with show_progress(f"checking {file}") as report:
                checked.append(check_paper(file, content, limit=limit, report=report))
        print_checked(checked[-1], show_all=show_all)
    rows = [row for paper in checked for row in paper.rows]
    if checked:
        options.write_json(json_file, rows_to_json(rows))
    return {row.outcome for row in rows}


def _check_equation(pasted: Pasted, json_file: Path | None, limit: float) -> set[str]:
    """Check an equation and return its verdicts."""
    answer = _judge(pasted, limit)
    options.write_json(json_file, to_json([Ledger("pasted", "", answer.judgements)]))
    for row in answer.judgements:
        print_details(row, ("one side", "other side"))
    for verdict, remark in REMARKS.items():
        if any(row.verdict is verdict for row in answer.judgements):
            say(remark)
    for letter, kind in answer.taken.items():
        say(f"  taken as  {letter}: {kind}")
    say(DEFAULTS)
    return {row.verdict.value for row in answer.judgements}


def _judge(pasted: Pasted, limit: float) -> Checked:
    try:
        with show_progress("judging the equation"):
            return check_pasted(pasted, limit)
    except PastedError as error:
        refuse(str(error))
    except WorkerError as error:
        fail(
            f"the equation: {error}; a larger --limit may help, or --natural for letters that are "
            "natural numbers, or --where for conditions"
        )


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
            "There is no block of letters, so each letter is taken to be a real number, or a "
            "matrix if printed as one or, in bold, used as one. --draft writes a block to confirm."
        )
        say(f"  letters assumed: {', '.join(paper.taken)}")
    counted = Counter(row.outcome for row in paper.rows)
    say(", ".join(f"{outcome} {number}" for outcome, number in sorted(counted.items())))


def _print_row(row: CheckedRow) -> None:
    assert row.judgement is not None
    style = STYLES[row.judgement.verdict]
    line = Text(f"{row.name}  ").append(row.outcome, style=style)
    say(line.append(f"  line {row.place.line}: {row.reason}"))
