"""The command that draws what was measured."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from mechproof.cli import options
from mechproof.cli.console import refuse, say
from mechproof.derivation import find_systems, packaged_directory
from mechproof.measured import MADE_BY, Record, find_files, goes_by, read_record


def chart(
    quantities: options.Quantities = None,
    out: options.Pictures = Path("charts"),
    measured: Annotated[
        Path | None,
        typer.Option(help="A folder of records; left out: those that come with the package."),
    ] = None,
    overview: Annotated[
        bool, typer.Option("--overview", help="One picture of all instead of one for each.")
    ] = False,
) -> None:
    """Draw time against error from the records, and jumps between branches.

    Records hold no jumps: they are computed anew, for the quantities of this installation. Every
    picture is written as PNG and SVG; the overview has a small panel for each quantity.

    Exit status 0: drawn; 2: bad usage.
    """
    from mechproof.lab.chart import draw_charts
    from mechproof.lab.overview import draw_overview
    from mechproof.lab.subject import find_subjects

    records = _read(measured, tuple(quantities or ()))
    if overview:
        for file in draw_overview(records, out):
            say(str(file))
        return
    systems = {record.quantity.partition(".")[0] for record in records}
    own = systems & find_systems(packaged_directory()).keys()
    subjects = {subject.name: subject for subject in (find_subjects(tuple(own)) if own else ())}
    for record in records:
        for file in draw_charts(record, subjects.get(record.quantity), out):
            say(str(file))


def _read(folder: Path | None, names: tuple[str, ...]) -> list[Record]:
    """Read the records with these names: quantity, system or system.quantity; all without."""
    files = find_files(folder)
    if not files:
        refuse(f"--measured {folder}: no folder with records of {MADE_BY}")
    for name in names:
        if not any(goes_by(quantity, name) for quantity in files):
            refuse(f"quantity {name!r} is not one of {', '.join(files)}")
    chosen = (q for q in files if not names or any(goes_by(q, name) for name in names))
    try:
        return [read_record(files[quantity]) for quantity in chosen]
    except ValueError as error:
        refuse(str(error))
