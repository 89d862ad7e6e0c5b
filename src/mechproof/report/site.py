"""The site: derivations with their ledgers in, the files of the report out."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from mechproof.proof.ledger import JudgedPaper
from mechproof.report.layout import STYLESHEET, read_stylesheet, render
from mechproof.report.legend import find_legend
from mechproof.report.papers import PaperView, count_totals, describe_paper
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
from mechproof.report.sources import Source, find_source

INDEX = "index.html"


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
        STYLESHEET: read_stylesheet(),
    }
    for paper, computed in zip(papers, quantities, strict=True):
        about = {"up": "../", "systems": systems, "system": paper.system, "pictures": pictures}
        found[f"papers/{paper.system}.html"] = render(
            "paper", **about, is_paper=True, paper=paper, glossary=f"../{INDEX}"
        )
        for quantity in computed:
            found[f"quantities/{quantity.system}.{quantity.name}.html"] = render(
                "quantity", **about, is_paper=False, quantity=quantity
            )
    failures = (
        f"{name}: {picture.failure}" for name, picture in pictures.items() if picture.failure
    )
    return Site(found, tuple(failures))


def _list_pictures(sources: Sequence[Source]) -> Mapping[str, PictureTask]:
    """List what is to be drawn: the picture of all first, which takes longest."""
    records = [record for source in sources for record in source.records]
    tasks = list_overview(records)
    for source in sources:
        tasks |= list_figures(source.location)
    for record in records:
        tasks |= list_charts(record)
    return tasks


def _describe(source: Source, pictures: Mapping[str, Picture]) -> PaperView:
    own = list_figures(source.location)
    return describe_paper(source, {name: pictures[name].after for name in own})


def _render_index(
    papers: Sequence[PaperView],
    quantities: Sequence[QuantityView],
    sources: Sequence[Source],
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
        totals=tuple(count_totals(judgements)),
        overview=picture,
        legend=find_legend(papers, quantities),
    )
