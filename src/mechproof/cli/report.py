"""The command that writes the report."""

from __future__ import annotations

from collections.abc import Container, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from mechproof.cli import options
from mechproof.cli.console import fail, refuse, say, show_progress
from mechproof.cli.judging import load_papers, read_ledgers, refuse_failures
from mechproof.cli.paths import find_locations, find_places, read_out
from mechproof.derivation import DerivationError
from mechproof.pipeline.ledger_cache import LedgerCache
from mechproof.pipeline.verification import LIMIT
from mechproof.sources.files import SUFFIXES
from mechproof.tools.files import write_whole
from mechproof.tools.made import ForeignFileError

if TYPE_CHECKING:
    from mechproof.ledger.judged import Ledger
    from mechproof.report import Site


def report(
    papers: options.Papers = None,
    out: Annotated[
        str | None,
        typer.Option(
            metavar="FOLDER",
            help="The folder that the pages go to, report by default; with --single the file, "
            "report.html.",
        ),
    ] = None,
    single: Annotated[
        bool, typer.Option("--single", help="Write one HTML file that holds all pages.")
    ] = False,
    derivations: options.Derivations = None,
    no_cache: options.NoCache = False,
    limit: options.Limit = LIMIT,
) -> None:
    """Write pages for a browser: every row with its verdict, every quantity, the papers' figures.

    They open from the file, without network or script: index.html first. A folder that holds
    anything but a report is refused, and so is a file that is none.

    Exit status 0: written; 1: a row or a figure hangs or crashes, or a kernel is not PROVED, which
    the page of its paper shows, or a derivation fails; 2: bad usage.
    """
    from mechproof.report import build_site, keep_shares, key_shares, load_shares

    target = _find_target(out, is_file=single)
    locations = find_locations(papers or (), find_places(derivations, None), SUFFIXES)
    ledgers = read_ledgers(locations, use_cache=not no_cache, limit=limit)
    reads = [{} if no_cache else LedgerCache(place).read_sources() for place in locations]
    keys = key_shares(locations, [ledger.system for ledger in ledgers], reads)
    kept = load_shares(keys)
    try:
        shown = _load_others(locations, ledgers, kept, limit)
        with show_progress("writing the pages") as tell:
            site = build_site(locations, shown, tell, kept)
        keep_shares(keys, site)
        _write(target, site, is_file=single)
    except (DerivationError, ForeignFileError, ValueError) as error:
        fail(str(error))
    except OSError as error:
        fail(f"--out: {error}")
    refuse_failures(ledgers, site.failures)


def _load_others(
    locations: Sequence[Path], ledgers: Sequence[Ledger], kept: Container[Path], limit: float
) -> list[Ledger]:
    """Load the papers of which no pages are kept; return the ledgers of all."""
    others = [place for place in locations if place not in kept]
    found = dict(zip(locations, ledgers, strict=True))
    if others:
        judged = load_papers([found[place] for place in others], others, limit=limit)
        found.update(zip(others, judged, strict=True))
    return list(found.values())


def _find_target(out: str | None, *, is_file: bool) -> Path:
    """Return the file or folder that --out names; refuse what holds anything but a report."""
    from mechproof.report import check_file, check_folder

    target = read_out(("report.html" if is_file else "report") if out is None else out, is_file)
    try:
        (check_file if is_file else check_folder)(target)
    except ForeignFileError as error:
        refuse(f"--out {error}")
    return target


def _write(target: Path, site: Site, *, is_file: bool) -> None:
    from mechproof.report import join_pages, write_folder

    if is_file:
        write_whole(target, join_pages(site.files))
        say(f"wrote {target}")
    else:
        write_folder(target, site.files)
        say(f"{target}: {len(site.files)} files; open {target / 'index.html'}")
