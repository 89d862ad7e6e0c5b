"""Pages that a report has written before: those of a paper are kept while nothing changes them.

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
from mechproof.report.site import Share, Site
from mechproof.tools.cache import Store, digest_program, make_key, name_place

# What is generated for readers, and lists of files: no page is made from it.
UNSHOWN = frozenset({".md", ".sha256", ".pyc"})
UNSHOWN_NAMES = frozenset({"ledger.json"})


def load_shares(keys: Mapping[Path, str]) -> dict[Path, Share]:
    """Return what is kept of each paper under its key; what cannot be read is as good as absent."""
    found = {}
    for place, key in keys.items():
        with suppress(KeyError, TypeError):
            found[place] = Share(**_store(place).read()[key])
    return found


def keep_shares(keys: Mapping[Path, str], site: Site) -> None:
    """Keep what a site has of each paper in the place of the last; not if a picture failed."""
    for (place, key), share in zip(keys.items(), site.shares, strict=True):
        if key and not share.failures:
            _store(place).write({key: asdict(share)})


def key_shares(
    locations: Sequence[Path], systems: Sequence[str], reads: Sequence[Mapping[str, str]]
) -> dict[Path, str]:
    """Return the digests of all that the pages of each paper show.

    Each page leads to those of all systems; `reads` are the digests of the ledgers' sources. It is
    empty where not all of that is known: for other places than folders, and for a ledger that is
    not kept.
    """
    return {
        place: _key(place, systems, read) if read and place.is_dir() else ""
        for place, read in zip(locations, reads, strict=True)
    }


def _key(place: Path, systems: Sequence[str], read: Mapping[str, str]) -> str:
    shown = sorted(set(_list_shown(place)))
    return make_key(
        shown, (), digest_program(), str(place), *systems, json.dumps(read, sort_keys=True)
    )


def _store(place: Path) -> Store:
    return Store(f"reports/{name_place(place)}.json")


def _list_shown(place: Path) -> Iterator[Path]:
    for folder in (place, Path(str(find_generated(place))), Path(str(files(KERNELS)))):
        for path in folder.rglob("*") if folder.is_dir() else ():
            is_shown = path.suffix not in UNSHOWN and path.name not in UNSHOWN_NAMES
            if is_shown and path.is_file():
                yield path
