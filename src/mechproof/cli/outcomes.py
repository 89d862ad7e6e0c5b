"""What makes a command fail: outcomes of rows, said by --fail-on."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Annotated

import typer

from mechproof.cli.console import refuse
from mechproof.proof.verdict import State, Verdict

FailOnOption = Annotated[
    list[str] | None,
    typer.Option(
        "--fail-on",
        metavar="OUTCOME",
        help="Exit with 1 for such rows: a verdict, not-read, not-judged, or none.",
    ),
]
NONE = "none"
# Outcomes by the words of the option: REFUTED as refuted, `not read` as not-read.
OUTCOMES = {
    str(outcome.value).lower().replace("_", "-").replace(" ", "-"): str(outcome.value)
    for outcome in (*Verdict, State.NOT_READ, State.NOT_JUDGED, State.SKIPPED)
}


def read_outcomes(words: list[str] | None, default: Iterable[str]) -> frozenset[str]:
    """Return the outcomes that make a command fail; refuse a word that is none."""
    if not words:
        return frozenset(default)
    said = [word.strip().lower().replace("_", "-") for x in words for word in x.split(",")]
    if unknown := [word for word in said if word not in (*OUTCOMES, NONE)]:
        refuse(f"--fail-on {unknown[0]}: is none of {', '.join((*OUTCOMES, NONE))}")
    return frozenset(OUTCOMES[word] for word in said if word != NONE)
