"""The site: derivations with their ledgers in, the files of the report out, and their folder."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from mechproof.proof.ledger import AT_HAND, JudgedPaper
from mechproof.proof.rungs import RUNGS
from mechproof.report.judged_derivations import JudgedDerivation, find_source
from mechproof.report.kept_formulas import FORMULAS
from mechproof.report.pages import STYLESHEET, read_font, read_stylesheet, render
from mechproof.report.papers import FindingView, PaperView, count_totals, describe_paper
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
from mechproof.report.quantities import QuantityView, describe_quantities
from mechproof.report.rows import MARKED
from mechproof.tools.made import STAGED, ForeignFileError, Made

INDEX = "index.html"
# Lists the files of the report, so that the next one knows what it may replace.
LIST = "mechproof-report.sha256"


@dataclass(frozen=True)
class Legend:
    """What is explained to the reader: only what occurs."""

    looks: tuple[VerdictStyle, ...]
    marks: Mapping[str, str]
    rungs: Mapping[str, str]


@dataclass(frozen=True)
class Site:
    """The text of every file by its path in the folder, and what could not be drawn."""

    files: Mapping[str, str]
    failures: tuple[str, ...]


def build_site(
    locations: Sequence[Path],
    ledgers: Sequence[JudgedPaper],
    report: Callable[[str], None] = lambda text: None,
) -> Site:
    """Return the files of the report; a page shows where its picture could not be drawn.

    The same derivations and records give the same files. `report` is told what has been done.
    Raises ValueError for a record that cannot be read and `DerivationError` for figures that
    cannot be loaded.
    """
    sources = [find_source(*pair) for pair in zip(locations, ledgers, strict=True)]
    pictures = draw_pictures(_list_pictures(sources), report)
    systems = [source.system for source in sources]
    papers = [_describe(source, pictures) for source in sources]
    quantities = [tuple(describe_quantities(source)) for source in sources]
    found = {
        INDEX: _render_index(papers, sum(quantities, ()), sources, pictures.get(OVERVIEW)),
        STYLESHEET: read_font() + read_stylesheet(),
    }
    for paper, computed in zip(papers, quantities, strict=True):
        about = {"up": "../", "systems": systems, "system": paper.system, "pictures": pictures}
        found[f"papers/{paper.system}.html"] = render(
            "paper", **about, is_paper=True, paper=paper, glossary=f"../{INDEX}"
        )
        for quantity in computed:
            found[f"quantities/{quantity.system}.{quantity.name}.html"] = render(
                "quantity", **about, is_paper=False, quantity=quantity, glossary=f"../{INDEX}"
            )
    FORMULAS.keep()
    failures = (
        f"{name}: {picture.failure}" for name, picture in pictures.items() if picture.failure
    )
    return Site(found, tuple(failures))


def _list_pictures(sources: Sequence[JudgedDerivation]) -> Mapping[str, PictureTask]:
    """List what is to be drawn: the picture of all first, which takes longest."""
    records = [record for source in sources for record in source.records]
    tasks = list_overview(records)
    for source in sources:
        tasks |= list_figures(source.location)
    for record in records:
        tasks |= list_charts(record)
    return tasks


def _describe(source: JudgedDerivation, pictures: Mapping[str, Picture]) -> PaperView:
    own = list_figures(source.location)
    return describe_paper(source, {name: pictures[name].after for name in own})


def _render_index(
    papers: Sequence[PaperView],
    quantities: Sequence[QuantityView],
    sources: Sequence[JudgedDerivation],
    picture: Picture | None,
) -> str:
    judgements = [row for source in sources for row in source.ledger.judgements]
    return render(
        "index",
        up="",
        systems=[paper.system for paper in papers],
        system="",
        is_paper=False,
        papers=papers,
        findings=_sort_findings(papers),
        totals=tuple(count_totals(judgements)),
        overview=picture,
        legend=_find_legend(papers, quantities),
        at_hand=AT_HAND,
    )


def _sort_findings(papers: Sequence[PaperView]) -> list[FindingView]:
    """Return the findings of all papers, the gravest first, else in the order of the papers."""
    found = [finding for paper in papers for finding in paper.findings]
    return sorted(found, key=lambda finding: finding.weight)


def _find_legend(papers: Sequence[PaperView], quantities: Sequence[QuantityView]) -> Legend:
    """Find what occurs in the rows of the papers and in the forms of their quantities."""
    rows = [e.row for paper in papers for section in paper.sections for e in section.entries]
    rows += [row for quantity in quantities for row in (*quantity.rests_on, *quantity.rows)]
    forms = [form for quantity in quantities for form in quantity.forms]
    looks = {row.look for row in rows} | {form.look for form in forms}
    marks = {mark for row in rows for mark in row.marks}
    joined = [row.rung for row in rows] + [form.rung for form in forms]
    rungs = {rung for names in joined for rung in names.split(", ")}
    order = (NOT_JUDGED, *LEFT.values(), *LOOKS.values(), MEASURED)
    return Legend(
        tuple(look for look in order if look in looks),
        {name: meaning for name, meaning in MARKED.items() if name in marks},
        {name: meaning for name, meaning in RUNGS.items() if name in rungs},
    )


def check_folder(folder: Path) -> None:
    """Raise `ForeignFileError` for what is no folder, or holds other things than a report.

    An empty folder and one that is not there are right.
    """
    if folder.exists() and not folder.is_dir():
        raise ForeignFileError(f"{folder}: is a file, a folder is needed")
    names = {path.name for path in folder.iterdir()} if folder.is_dir() else set()
    # A first report that was killed leaves only what it was about to put in place.
    if LIST not in names and names - {STAGED}:
        raise ForeignFileError(
            f"{folder}: is not empty and holds no report of mechproof; name another folder"
        )
    Made(folder, LIST).read_list()


def write_folder(folder: Path, files: Mapping[str, str]) -> None:
    """Replace the files of the last report by those of this one.

    Raises `ForeignFileError` for a file that is in the way and is not of a report.
    """
    check_folder(folder)
    Made(folder, LIST).update(files)
