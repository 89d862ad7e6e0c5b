"""The command that writes kernels for other languages."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from mechproof.cli.console import fail, say
from mechproof.cli.places import DerivationsOption, find_locations, find_places
from mechproof.derivation import DerivationError, load_paper
from mechproof.files import write_whole

app = typer.Typer(help="Write kernels for other languages.", no_args_is_help=True)


@app.command(name="c")
def emit_c(
    systems: Annotated[
        list[str] | None,
        typer.Argument(help="Systems, files FILE.py or folders of derivations; all if none."),
    ] = None,
    out: Annotated[Path, typer.Option(help="The folder that the files go to.")] = Path("c"),
    float32: Annotated[
        bool, typer.Option("--float32", help="Compute in float, for processors without double.")
    ] = False,
    derivations: DerivationsOption = None,
) -> None:
    """Write a header and a source in C99 for each system; they need <math.h> alone.

    Each kernel is a function of one point, and one with _array after its name of many. Sums over
    axes of any length are left out. Link with -lm.

    Exit status 0: written; 1: a derivation fails, or has no kernel for C; 2: bad usage.
    """
    from mechproof.codegen.backends.c99 import render_c

    for location in find_locations(systems or (), find_places(derivations, None)):
        try:
            files = render_c(load_paper(location), single=float32)
        except (DerivationError, ValueError, NotImplementedError) as error:
            if systems:
                fail(str(error))
            say(f"left out: {error}")
            continue
        for name, text in files.items():
            _write(out / name, text)


def _write(file: Path, text: str) -> None:
    try:
        write_whole(file, text)
    except OSError as error:
        fail(f"--out: {error}")
    say(str(file))
