"""The command that writes the report."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from mechproof.cli.console import fail, refuse, say, show_progress
from mechproof.cli.judging import LimitOption, NoCacheOption, judge_papers, refuse_failures
from mechproof.cli.paths import (
    DerivationsOption,
    PapersArgument,
    find_locations,
    find_places,
    read_out,
)
from mechproof.derivation import DerivationError
from mechproof.document.sources import SUFFIXES
from mechproof.made import ForeignFileError
from mechproof.verification import LIMIT


def report(
    papers: PapersArgument = None,
    out: Annotated[
        Path,
        typer.Option(metavar="FOLDER", help="The folder that the pages go to.", parser=read_out),
    ] = Path("report"),
    derivations: DerivationsOption = None,
    no_cache: NoCacheOption = False,
    limit: LimitOption = LIMIT,
) -> None:
    """Write pages for a browser: every row with its verdict, every quantity, the papers' figures.

    They open from the file, without network or script: index.html first. A folder that holds
    anything but a report is refused.

    Exit status 0: written; 1: a row or a figure hangs or crashes, or a kernel is not PROVED, which
    the page of its paper shows, or a derivation fails; 2: bad usage.
    """
    from mechproof.report import build_site, check_folder, write_folder

    try:
        check_folder(out)
    except ForeignFileError as error:
        refuse(f"--out {error}")
    locations = find_locations(papers or (), find_places(derivations, None), SUFFIXES)
    ledgers = judge_papers(locations, use_cache=not no_cache, limit=limit)
    try:
        with show_progress("writing the pages") as tell:
            site = build_site(locations, ledgers, tell)
        write_folder(out, site.files)
    except (DerivationError, ForeignFileError, ValueError) as error:
        fail(str(error))
    except OSError as error:
        fail(f"--out: {error}")
    say(f"{out}: {len(site.files)} files; open {out / 'index.html'}")
    refuse_failures(ledgers, site.failures)
