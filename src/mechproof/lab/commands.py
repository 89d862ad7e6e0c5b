"""Commands of the laboratory that draw from what was measured."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, NoReturn

import typer
from rich.console import Console

from mechproof.measured import Record, find_files, read_record


def chart(
    quantities: Annotated[
        list[str] | None,
        typer.Argument(help="Quantities, systems or system.quantity; all if none."),
    ] = None,
    out: Annotated[Path, typer.Option(help="The folder that the pictures go to.")] = Path("charts"),
    measured: Annotated[
        Path | None,
        typer.Option(help="A folder of records; left out: those that come with the package."),
    ] = None,
) -> None:
    """Draw time against error from the records, and jumps between branches.

    Records hold no jumps: they are computed anew, for the quantities of this installation. Every
    picture is written as PNG and SVG.

    Exit status 0: drawn; 2: bad usage.
    """
    from mechproof.lab.chart import draw_charts
    from mechproof.lab.subject import find_subjects

    console = Console(highlight=False)
    records = _read(measured, tuple(quantities or ()))
    subjects = {subject.name: subject for subject in find_subjects()}
    for record in records:
        for file in draw_charts(record, subjects.get(record.quantity), out):
            console.print(str(file), markup=False, soft_wrap=True)


def _read(folder: Path | None, names: tuple[str, ...]) -> list[Record]:
    """Read the records with these names: quantity, system or system.quantity; all without."""
    files = find_files(folder)
    if not files:
        _refuse(f"--measured {folder}: no folder with records of `mechproof measure`")
    for name in names:
        if not any(_fits(quantity, name) for quantity in files):
            _refuse(f"quantity {name!r} is not one of {', '.join(files)}")
    chosen = (q for q in files if not names or any(_fits(q, name) for name in names))
    try:
        return [read_record(files[quantity]) for quantity in chosen]
    except ValueError as error:
        _refuse(str(error))


def _refuse(message: str) -> NoReturn:
    Console(stderr=True, highlight=False).print(message, style="red", markup=False, soft_wrap=True)
    raise typer.Exit(2)


def _fits(quantity: str, name: str) -> bool:
    system, _, short = quantity.partition(".")
    return name in (quantity, system, short)
