"""The site: takes derivations with their ledgers, returns the files of the report, writes them.

Pages of a paper are cached until something changes them. All that they show is known for folders of
derivations: their ledgers with the files that these were made from, their own files, which draw the
figures, and everything generated, measured and checked.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass
from importlib.resources import files
from pathlib import Path

from mechproof.ledger.judged import AT_HAND, JudgedPaper, Ledger
from mechproof.measured import KERNELS
from mechproof.proof.rungs import RUNGS
from mechproof.report.judged_derivations import (
    JudgedDerivation,
    find_generated,
    find_source,
    read_records,
)
from mechproof.report.mathml import FORMULAS
from mechproof.report.pages import MARKED, STYLESHEET, read_font, read_stylesheet, render
from mechproof.report.paper_pages import PaperView, count_totals, describe_paper
from mechproof.report.phrases import LEFT, LOOKS, MEASURED, NOT_JUDGED, VerdictStyle
from mechproof.report.pictures import (
    OVERVIEW,
    Picture,
    PictureTask,
    draw_pictures,
    list_charts,
    list_figures,
    list_overview,
)
from mechproof.report.quantity_pages import QuantityView, describe_quantities
from mechproof.tools.cache import Store, digest_program, make_key, name_place
from mechproof.tools.made import STAGED, ForeignFileError, Made

INDEX = "index.html"
# Name of the list of the report's files, by which the next report knows what it may replace.
LIST = "mechproof-report.sha256"
# Files that no page is made from: those generated for readers, and lists of files.
UNSHOWN = frozenset({".md", ".sha256", ".pyc"})
UNSHOWN_NAMES = frozenset({"ledger.json"})


@dataclass(frozen=True)
class Legend:
    """The explanations for the reader, only of what occurs."""

    looks: tuple[VerdictStyle, ...]
    marks: Mapping[str, str]
    rungs: Mapping[str, str]


@dataclass(frozen=True)
class Share:
    """The share of a paper in a report: its pages, and what the start page says of it.

    `findings` are lines with their weights. `met` are the keys of the verdicts, marks and rungs
    that occur, `measured` the quantities with records, `failures` the pictures that could not be
    drawn.
    """

    files: Mapping[str, str]
    card: str
    findings: Sequence[tuple[int, str]]
    met: Mapping[str, Sequence[str]]
    measured: Sequence[str]
    failures: Sequence[str]


@dataclass(frozen=True)
class Site:
    """The text of every file by its path in the folder, and the pictures that could not be drawn.

    `shares` are the shares of the papers, in their order.
    """

    files: Mapping[str, str]
    failures: tuple[str, ...]
    shares: tuple[Share, ...]


def build_site(
    locations: Sequence[Path],
    ledgers: Sequence[Ledger],
    report: Callable[[str], None] = lambda text: None,
    kept: Mapping[Path, Share] | None = None,
) -> Site:
    """Return the files of the report; a page says so if its picture could not be drawn.

    The same derivations and records give the same files. A share that is `kept` is reused; the
    ledgers of other papers must contain their papers. `report` is called with the progress. Raises
    ValueError for a record that cannot be read and `DerivationError` for figures that cannot be
    loaded.
    """
    kept = kept or {}
    sources = {
        place: find_source(place, ledger)
        for place, ledger in zip(locations, ledgers, strict=True)
        if place not in kept and isinstance(ledger, JudgedPaper)
    }
    records = [
        record
        for place in locations
        for record in (
            sources[place].records
            if place in sources
            else read_records(find_generated(place), kept[place].measured)
        )
    ]
    # The picture of all quantities comes first, because it takes longest.
    tasks = {**list_overview(records), **_list_pictures(sources.values())}
    pictures = draw_pictures(tasks, report)
    systems = [ledger.system for ledger in ledgers]
    shares = [
        _describe(sources[place], pictures, systems) if place in sources else kept[place]
        for place in locations
    ]
    FORMULAS.keep()
    overview = pictures.get(OVERVIEW)
    found = {
        INDEX: _render_index(ledgers, shares, overview),
        STYLESHEET: read_font() + read_stylesheet(),
    }
    for share in shares:
        found |= share.files
    failures = [failure for share in shares for failure in share.failures]
    failures += [f"{OVERVIEW}: {overview.failure}"] if overview and overview.failure else []
    return Site(found, tuple(failures), tuple(shares))


def _list_pictures(sources: Iterable[JudgedDerivation]) -> Mapping[str, PictureTask]:
    """Return the figures of papers and the charts of their quantities."""
    tasks: dict[str, PictureTask] = {}
    for source in sources:
        tasks |= list_figures(source.location)
        for record in source.records:
            tasks |= list_charts(record)
    return tasks


def _describe(
    source: JudgedDerivation, pictures: Mapping[str, Picture], systems: Sequence[str]
) -> Share:
    """Write the pages of a paper and of its quantities, and its part of the start page."""
    own = _list_pictures([source])
    after = {name: pictures[name].after for name in list_figures(source.location)}
    view, quantities = describe_paper(source, after), tuple(describe_quantities(source))
    paper = source.ledger.paper
    about: dict[str, object] = {"up": "../", "glossary": f"../{INDEX}", "pictures": pictures}
    about |= {"paper": paper, "system": paper.system, "systems": systems}
    files = {f"papers/{paper.system}.html": render("paper", **about, is_paper=True, view=view)}
    for one in quantities:
        files[f"quantities/{paper.system}.{one.quantity.name}.html"] = render(
            "quantity", **about, is_paper=False, view=one, quantity=one.quantity
        )
    return Share(
        files,
        render("card", paper=paper, view=view),
        [
            (int(finding.found.weight), render("finding", finding=finding))
            for finding in view.findings
        ],
        _list_met(view, quantities),
        [record.quantity for record in source.records],
        [f"{name}: {pictures[name].failure}" for name in own if pictures[name].failure],
    )


def _list_met(paper: PaperView, quantities: Sequence[QuantityView]) -> Mapping[str, Sequence[str]]:
    """List the verdicts, marks and rungs in the rows of a paper and the forms of its quantities."""
    rows = [entry.row for section in paper.sections for entry in section.entries]
    rows += [row for quantity in quantities for row in (*quantity.rests_on, *quantity.rows)]
    forms = [form for quantity in quantities for form in quantity.forms]
    looks = [row.look for row in rows] + [form.look for form in forms]
    rungs = [row.rung for row in rows] + [form.rung for form in forms]
    found = {
        "looks": {look.key for look in looks if look.meaning},
        "marks": {mark for row in rows for mark in row.marks},
        "rungs": {rung for names in rungs for rung in names.split(", ")},
    }
    return {kind: sorted(names) for kind, names in found.items()}


def _render_index(
    ledgers: Sequence[Ledger], shares: Sequence[Share], overview: Picture | None
) -> str:
    judgements = [row for ledger in ledgers for row in ledger.judgements]
    # The gravest come first, the others keep the order of the papers.
    findings = sorted((line for share in shares for line in share.findings), key=lambda x: x[0])
    return render(
        "index",
        up="",
        systems=[ledger.system for ledger in ledgers],
        system="",
        is_paper=False,
        # Papers without findings come last, standards among them.
        cards=[share.card for share in sorted(shares, key=lambda share: not share.findings)],
        findings=[line for _, line in findings],
        totals=tuple(count_totals(judgements)),
        overview=overview,
        legend=_find_legend(shares),
        at_hand=AT_HAND,
    )


def _find_legend(shares: Sequence[Share]) -> Legend:
    looks, marks, rungs = (
        {name for share in shares for name in share.met[kind]}
        for kind in ("looks", "marks", "rungs")
    )
    order = (NOT_JUDGED, *LEFT.values(), *LOOKS.values(), MEASURED)
    return Legend(
        tuple(look for look in order if look.key in looks),
        {name: meaning for name, meaning in MARKED.items() if name in marks},
        {name: meaning for name, meaning in RUNGS.items() if name in rungs},
    )


def check_folder(folder: Path) -> None:
    """Raise `ForeignFileError` for a file, or a folder with anything but a report.

    An empty folder and one that does not exist are accepted.
    """
    if folder.exists() and not folder.is_dir():
        raise ForeignFileError(f"{folder}: is a file, a folder is needed")
    names = {path.name for path in folder.iterdir()} if folder.is_dir() else set()
    # A first report that was killed leaves only the files that it was about to put in place.
    if LIST not in names and names - {STAGED}:
        raise ForeignFileError(
            f"{folder}: is not empty and is not a mechproof report; name another folder"
        )
    Made(folder, LIST).read_list()


def write_folder(folder: Path, files: Mapping[str, str]) -> None:
    """Replace the files of the last report by those of this one.

    Raises `ForeignFileError` for a file in the way that does not belong to a report.
    """
    check_folder(folder)
    Made(folder, LIST).update(files)


def load_shares(keys: Mapping[Path, str]) -> dict[Path, Share]:
    """Return the cached share of each paper under its key; unreadable ones count as missing."""
    found = {}
    for place, key in keys.items():
        with suppress(KeyError, TypeError):
            found[place] = Share(**_store(place).read()[key])
    return found


def keep_shares(keys: Mapping[Path, str], site: Site) -> None:
    """Store each paper's share of a site in place of its last one, unless a picture failed."""
    for (place, key), share in zip(keys.items(), site.shares, strict=True):
        if key and not share.failures:
            _store(place).write({key: asdict(share)})


def key_shares(
    locations: Sequence[Path], systems: Sequence[str], reads: Sequence[Mapping[str, str]]
) -> dict[Path, str]:
    """Return the digests of all that the pages of each paper show.

    Each page links to those of all systems; `reads` are the digests of the ledgers' sources. A
    digest is empty if not all of this is known: if the place is not a folder, or its ledger is not
    cached.
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
