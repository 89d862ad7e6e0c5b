"""The commands that draw: the figures of papers, and what was measured."""

from __future__ import annotations

from importlib.resources.abc import Traversable
from pathlib import Path
from typing import Annotated

import typer

from mechproof.cli import options
from mechproof.cli.options import ending, fail, find_locations, find_places, refuse, say
from mechproof.derivation import DerivationError, find_systems, packaged_directory
from mechproof.measured import MADE_BY, Record, find_all_files, find_files, goes_by, read_record


def figures(
    systems: Annotated[
        list[str] | None, typer.Argument(help="Systems, or folders of derivations; by default all.")
    ] = None,
    out: options.Pictures = Path("figures"),
    derivations: options.Derivations = None,
) -> None:
    """Draw the papers' figures from the kernels, with the findings marked in them.

    Each is written with its caption as PNG and SVG, SYSTEM.FIGURE.png; the command prints each file
    and what it shows. A folder has figures if its pictures.py binds FIGURES.

    Exit status 0: drawn; 1: a derivation or a drawing fails (the others are drawn); 2: bad usage.
    """
    from mechproof.plot.figures import DrawingError, find_figures, write_files

    failures: list[str] = []
    for location in find_locations(systems or (), find_places(derivations, None)):
        try:
            found = find_figures(location)
        except DerivationError as error:
            failures.append(str(error))
            continue
        if systems and not found:
            failures.append(f"{location}: has no pictures.py, so no figures")
        for figure in found:
            try:
                files = write_files(figure, out, f"{location.stem}.{figure.name}")
            except OSError as error:
                fail(f"--out: {error}")
            except ImportError as error:
                fail(str(error))
            except DrawingError as error:
                failures.append(f"{location.stem} {error}")
                continue
            for file in files:
                say(f"{file}: {figure.title}")
    if failures:
        fail("\n".join(failures))


# What was generated from the user's own derivations, where commands find it, too.
OWN = Path("generated")
Files = dict[str, Traversable]


def chart(
    quantities: options.Quantities = None,
    out: options.Pictures = Path("charts"),
    measured: Annotated[
        Path | None,
        typer.Option(help="A folder of records; by default ./generated, then the package's."),
    ] = None,
    overview: Annotated[
        bool,
        typer.Option(
            "--overview", help="Draw one picture of all quantities instead of one for each."
        ),
    ] = False,
) -> None:
    """Draw time against error from the records, and jumps between branches.

    Jumps are not in the records but are computed again, for the quantities installed here. Every
    picture is written as PNG and SVG; the overview has a small panel for each quantity.

    Exit status 0: drawn; 2: bad usage.
    """
    from mechproof.lab.chart import draw_charts, draw_overview
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
    """Return the records with these names: quantity, system or system.quantity; by default all."""
    chosen = _choose(_list_sources(folder), names)
    if any(Path(str(file)).is_relative_to(OWN) for file in chosen.values()):
        say(f"records: {', '.join(sorted({str(Path(str(f)).parent) for f in chosen.values()}))}")
    with ending(ValueError, refuse):
        return [read_record(file) for file in chosen.values()]


def _list_sources(folder: Path | None) -> list[Files]:
    """Return the record files by quantity: of the folder, or of ./generated and the package."""
    sources = [find_all_files(OWN), find_files()] if folder is None else [find_files(folder)]
    found = [files for files in sources if files]
    if not found:
        refuse(f"--measured {folder}: no folder with records of {MADE_BY}")
    return found


def _choose(sources: list[Files], names: tuple[str, ...]) -> Files:
    """Return the files of the first source that has each name; without names the first source."""
    if not names:
        return sources[0]
    chosen: Files = {}
    for name in names:
        named = ({q: f for q, f in files.items() if goes_by(q, name)} for files in sources)
        found = next(filter(None, named), None)
        if found is None:
            known = dict.fromkeys(quantity for files in sources for quantity in files)
            refuse(
                f"quantity {name!r} is not one of {', '.join(known)}; give --measured for others"
            )
        chosen |= found
    return dict(sorted(chosen.items()))
