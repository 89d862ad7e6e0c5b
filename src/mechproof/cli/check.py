"""The command that judges one pasted equation."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from mechproof.cli.console import fail, refuse, say, show_progress
from mechproof.cli.json_file import clear_json, write_json
from mechproof.cli.ledger import print_details
from mechproof.pasted import Checked, Pasted, PastedError, check_pasted
from mechproof.processes import WorkerError
from mechproof.proof.ledger import Ledger, to_json
from mechproof.proof.verdict import Verdict

LIMIT = 60.0
Texts = list[str] | None
DEFAULTS = (
    "What is not said is taken so: letters are real numbers, a letter up to which a sum goes is "
    "a natural number, d within an integral is its differential. Nothing else is guessed."
)
SUCCESS = (Verdict.PROVED, Verdict.DEFINITION, Verdict.CONVENTION)
REMARKS = {
    Verdict.REFUTED: "REFUTED means: not true for all values of its letters. Where one of them "
    "depends on others (an angle on an angle), say it: --let 'letter=…'; where they are "
    "restricted: --where.",
    Verdict.DEFINITION: "DEFINITION means: nothing was compared, the equation itself says what the "
    "letter is. To have it judged, say what the letter is otherwise: --let 'letter=…'.",
}


def check(
    equation: Annotated[
        str,
        typer.Argument(
            help="LaTeX: one equation, a chain, or a relation; its condition behind it: |x|=x, x>0."
        ),
    ],
    names: Annotated[
        Texts, typer.Option("--name", help="A print that is one quantity: AC.")
    ] = None,
    factors: Annotated[
        Texts, typer.Option("--factor", help="A name that a bracket after it multiplies: a(1+e).")
    ] = None,
    where: Annotated[
        Texts, typer.Option("--where", help="A relation in which it is meant: 0<x<1.")
    ] = None,
    values: Annotated[
        Texts, typer.Option("--let", help="The value of a letter: k=a/b, C=0.")
    ] = None,
    natural: Annotated[Texts, typer.Option("--natural", help="A letter that counts: n.")] = None,
    start: Annotated[
        str, typer.Option("--from", help="Where integrals without limits start: 0.")
    ] = "",
    json_file: Annotated[
        Path | None, typer.Option("--json", help="Also write the rows to this file.")
    ] = None,
    limit: Annotated[
        float, typer.Option("--limit", metavar="SECONDS", min=0, help="What takes longer fails.")
    ] = LIMIT,
) -> None:
    """Judge one pasted equation: whether it is true for all values of its letters.

    Exit status 0: every sign is PROVED, a DEFINITION or a CONVENTION; 1: one is not, REFUTED and
    ENCLOSED among them, or it takes too long or crashes; 2: bad usage, an empty domain, or the
    equation cannot be read without a guess.
    """
    pasted = Pasted(
        equation,
        names=tuple(names or ()),
        factors=tuple(factors or ()),
        where=tuple(where or ()),
        values=tuple(values or ()),
        natural=tuple(natural or ()),
        lower_limit=start,
    )
    clear_json(json_file)
    answer = _judge(pasted, limit)
    write_json(json_file, to_json([Ledger("pasted", "", answer.judgements)]))
    for row in answer.judgements:
        print_details(row, ("one side", "other side"))
    for verdict, remark in REMARKS.items():
        if any(row.verdict is verdict for row in answer.judgements):
            say(remark)
    for letter, kind in answer.taken.items():
        say(f"  taken as  {letter}: {kind}")
    say(DEFAULTS)
    if any(row.verdict not in SUCCESS for row in answer.judgements):
        raise typer.Exit(1)


def _judge(pasted: Pasted, limit: float) -> Checked:
    try:
        with show_progress("judging the equation"):
            return check_pasted(pasted, limit)
    except PastedError as error:
        refuse(str(error))
    except WorkerError as error:
        fail(
            f"the equation: {error}; a larger --limit, --natural for letters that count, or "
            "--where for what restricts them may help"
        )
