"""The command that writes the report."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from mechproof.cli import options
from mechproof.cli.options import (
    ending,
    fail,
    find_locations,
    find_places,
    read_out,
    refuse,
    say,
    show_progress,
)
from mechproof.pipeline.judging import PipelineError
from mechproof.pipeline.verification import LIMIT
from mechproof.sources.paper_files import SUFFIXES
from mechproof.tools.made import ForeignFileError


def report(
    papers: options.Papers = None,
    out: Annotated[
        str | None,
        typer.Option(
            metavar="FOLDER",
            help="The folder to write the pages to, by default report; with --single the file, "
            "by default report.html.",
        ),
    ] = None,
    single: Annotated[
        bool, typer.Option("--single", help="Write all pages as one HTML file.")
    ] = False,
    derivations: options.Derivations = None,
    no_cache: options.NoCache = False,
    limit: options.Limit = LIMIT,
) -> None:
    """Write pages for a browser: every row with its verdict, every quantity, the papers' figures.

    Open index.html: the pages need neither a network nor scripts. A folder or file that holds
    anything but a report is refused.

    Exit status 0: written; 1: a row or a figure hangs or crashes, or a kernel is not PROVED, which
    the page of its paper shows, or a derivation fails; 2: bad usage.
    """
    from mechproof.pipeline.reporting import write_report

    target = _find_target(out, is_file=single)
    locations = find_locations(papers or (), find_places(derivations, None), SUFFIXES)
    with ending(PipelineError, fail), ending(OSError, fail, "--out: "):
        count, failures = write_report(
            locations,
            target,
            single=single,
            use_cache=not no_cache,
            limit=limit,
            progress=show_progress,
        )
    say(f"wrote {target}" if single else f"{target}: {count} files; open {target / 'index.html'}")
    if failures:
        fail("\n".join(failures))


def _find_target(out: str | None, *, is_file: bool) -> Path:
    """Return the file or folder that --out names; refuse one with anything but a report."""
    from mechproof.report import check_file, check_folder

    target = read_out(("report.html" if is_file else "report") if out is None else out, is_file)
    with ending(ForeignFileError, refuse, "--out "):
        (check_file if is_file else check_folder)(target)
    return target
