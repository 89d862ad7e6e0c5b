"""Sites that a report has built before: kept whole while nothing that they show has changed.

What they show is known of folders of derivations: their ledgers and the files that these were made
from, their own files, which draw the figures, and what was generated, measured and checked.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import asdict
from importlib.resources import files
from pathlib import Path

from mechproof.measured import KERNELS
from mechproof.report.judged_derivations import find_generated
from mechproof.report.site import Site
from mechproof.tools.cache import Store, make_key
from mechproof.tools.reads import digest_program

SITE = Store("report.json")


def load_site(key: str) -> Site | None:
    """Return the site of a key; what cannot be read is as good as absent."""
    with suppress(KeyError, TypeError):
        kept = SITE.read()[key]
        return Site(kept["files"], tuple(kept["failures"]))
    return None


def keep_site(key: str, site: Site) -> None:
    """Keep a site in the place of the last one; not if something could not be drawn."""
    if key and not site.failures:
        SITE.write({key: asdict(site)})


def key_site(locations: Sequence[Path], reads: Sequence[Mapping[str, str]]) -> str:
    """Return the digest of all that a site shows; `reads` are the digests of the ledgers' sources.

    It is empty where not all of that is known: for other places than folders, and where a ledger
    is not kept.
    """
    if not reads or not all(reads) or not all(location.is_dir() for location in locations):
        return ""
    shown = sorted({path for location in locations for path in _list_shown(location)})
    texts = (json.dumps(read, sort_keys=True) for read in reads)
    return make_key(shown, (), digest_program(), *map(str, locations), *texts)


def _list_shown(location: Path) -> Iterator[Path]:
    for folder in (location, Path(str(find_generated(location))), Path(str(files(KERNELS)))):
        found = folder.rglob("*") if folder.is_dir() else ()
        yield from (path for path in found if path.suffix != ".pyc" and path.is_file())
