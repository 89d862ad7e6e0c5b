"""The command that searches for forms that lose fewer digits than the shipped ones."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer

from mechproof.cli import options
from mechproof.cli.options import Places, ending, fail, find_places, refuse, say, show_progress
from mechproof.derivation import DerivationError, add_chosen
from mechproof.tools.processes import WorkerError

# Time limit in seconds for one quantity.
SEARCH_LIMIT = 300.0


def improve(
    quantities: Annotated[
        list[str] | None,
        typer.Argument(help="Quantities, systems, system.quantity or FILE.py; by default all."),
    ] = None,
    write: Annotated[
        bool,
        typer.Option("--write", help="Keep the forms found next to the derivation, to be shipped."),
    ] = False,
    derivations: options.Derivations = None,
    root: options.Root = None,
    limit: Annotated[
        float,
        typer.Option(
            "--limit", metavar="SECONDS", min=0, help="Give up on a search after this time."
        ),
    ] = SEARCH_LIMIT,
) -> None:
    """Search the named rewrites for forms that lose fewer digits than those that are shipped.

    Each shipped form is compared with rewritten forms of its definition on points chosen to hurt. A
    form is offered only if its source is PROVED to compute the definition; its error is measured on
    other points than those it was chosen on. --write keeps the offered forms in FILE.forms.json
    next to the derivation (forms.json in a folder), where `regenerate` finds them; the form shipped
    before becomes a rival. `mechproof regenerate --improve` does both.

    Exit status 0: searched; 1: a search fails or takes too long, or a derivation fails; 2: bad
    usage.
    """
    places, names = find_places(derivations, root), list(quantities or ())
    if len(names) == 1 and Path(names[0]).suffix == ".py":
        file = Path(names[0])
        if not file.is_file():
            refuse(f"{file}: there is no such file")
        places, names = replace(places, derivations=file.absolute().parent), [file.stem]
    if not offer_forms(names, places, write=write, limit=limit):
        raise typer.Exit(1)


def offer_forms(names: Sequence[str], places: Places, *, write: bool, limit: float) -> bool:
    """Print a line for each quantity, and keep the forms if `write`; return whether none failed."""
    from mechproof.improvement import Offer, find_offers

    directory = None if places.is_packaged else places.derivations
    succeeded = True
    with ending(ValueError, refuse), ending(DerivationError, fail):
        with show_progress("searching for better forms") as report:
            offers = list(find_offers(names, directory, limit=limit, report=report))
        for subject, offer in offers:
            if not isinstance(offer, Offer):
                say(f"{subject.name}: {offer}")
                succeeded &= not isinstance(offer, WorkerError)
                continue
            say(offer.describe())
            if write and offer.found and subject.origin:
                chosen = {subject.quantity.name: offer.rewrites}
                say(f"wrote {add_chosen(subject.origin[0], chosen)}")
    return succeeded
