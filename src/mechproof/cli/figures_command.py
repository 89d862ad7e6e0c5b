"""The command that draws the figures of papers."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from mechproof.cli import options
from mechproof.cli.console import fail, say
from mechproof.cli.paths import find_locations, find_places
from mechproof.derivation import DerivationError


def figures(
    systems: Annotated[
        list[str] | None, typer.Argument(help="Systems, or folders of derivations; all if none.")
    ] = None,
    out: options.Pictures = Path("figures"),
    derivations: options.Derivations = None,
) -> None:
    """Draw the papers' figures from the kernels, with what was found marked in them.

    Each is written with its caption as PNG and SVG, SYSTEM.FIGURE.png; what is printed is the file
    and what it shows. A folder has figures if its pictures.py binds FIGURES.

    Exit status 0: drawn; 1: a derivation or a drawing fails, the others are drawn; 2: bad usage.
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
            failures.append(f"{location}: has no pictures.py, and so no figures")
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
