"""Reporting: from the places of papers to a folder of pages or one file, in three stages.

1. Judge: every row of the papers gets a verdict, unless nothing that its pages show has changed.
2. Build: a page for each paper and each quantity; cached pages of a paper are reused.
3. Write: a folder or file that holds anything but a report is left unchanged.
"""

from __future__ import annotations

from collections.abc import Container, Sequence
from pathlib import Path

from mechproof import report
from mechproof.derivation import DerivationError
from mechproof.ledger.judged import Ledger
from mechproof.pipeline.judging import Progress, name_faults, read_ledgers, report_nothing
from mechproof.pipeline.ledger_cache import LedgerCache
from mechproof.pipeline.verification import LIMIT, VerificationError, list_failures, restore_papers
from mechproof.tools.files import write_whole
from mechproof.tools.made import ForeignFileError


def write_report(
    locations: Sequence[Path],
    target: Path,
    *,
    single: bool = False,
    use_cache: bool = True,
    limit: float = LIMIT,
    progress: Progress = report_nothing,
) -> tuple[int, list[str]]:
    """Write the report of papers, in one file if `single`; return the file count and failures.

    Raises `PipelineError`, and OSError if a file cannot be written.
    """
    ledgers = read_ledgers(locations, use_cache=use_cache, limit=limit, progress=progress)
    reads = [LedgerCache(place).read_sources() if use_cache else {} for place in locations]
    keys = report.key_shares(locations, [ledger.system for ledger in ledgers], reads)
    kept = report.load_shares(keys)
    with name_faults(DerivationError, VerificationError, ForeignFileError, ValueError):
        shown = _load_others(locations, ledgers, kept, limit, progress)
        with progress("writing the pages") as tell:
            site = report.build_site(locations, shown, tell, kept)
        report.keep_shares(keys, site)
        if single:
            write_whole(target, report.join_pages(site.files))
        else:
            report.write_folder(target, site.files)
    return len(site.files), [*list_failures(ledgers), *site.failures]


def _load_others(
    locations: Sequence[Path],
    ledgers: Sequence[Ledger],
    kept: Container[Path],
    limit: float,
    progress: Progress,
) -> list[Ledger]:
    """Load the papers without cached pages; return the ledgers of all."""
    others = [place for place in locations if place not in kept]
    found = dict(zip(locations, ledgers, strict=True))
    if others:
        with progress("loading earlier verdicts") as tell:
            judged = restore_papers(
                [found[one] for one in others], others, limit=limit, report=tell
            )
        found.update(zip(others, judged, strict=True))
    return list(found.values())
