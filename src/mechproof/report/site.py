"""The site: derivations with their ledgers in, the files of the report out."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path

from mechproof.proof.ledger import Ledger
from mechproof.proof.rungs import RUNGS
from mechproof.report.layout import STYLESHEET, read_stylesheet, render
from mechproof.report.papers import PaperView, count_totals, describe_paper
from mechproof.report.pictures import (
    Picture,
    draw_pictures,
    list_charts,
    list_figures,
    overview,
)
from mechproof.report.quantities import describe_quantities
from mechproof.report.sources import Source, find_source
from mechproof.report.words import LOOKS, MEASURED

OVERVIEW = "overview"
INDEX = "index.html"


def build_site(
    locations: Sequence[Path],
    ledgers: Sequence[Ledger],
    report: Callable[[str], None] = lambda text: None,
) -> dict[str, str]:
    """Return the text of every file of the report by its path in the folder.

    The same derivations and records give the same files. `report` is told what has been done.
    Raises ValueError for a record that cannot be read, `DerivationError` for figures that cannot
    be loaded and `PictureError` for what cannot be drawn.
    """
    sources = [find_source(*pair) for pair in zip(locations, ledgers, strict=True)]
    pictures = draw_pictures(_list_pictures(sources), report)
    systems = [source.system for source in sources]
    papers = [_describe(source, pictures) for source in sources]
    found = {
        INDEX: _render_index(papers, sources, pictures.get(OVERVIEW)),
        STYLESHEET: read_stylesheet(),
    }
    for source, paper in zip(sources, papers, strict=True):
        about = {"up": "../", "systems": systems, "system": paper.system, "pictures": pictures}
        found[f"papers/{paper.system}.html"] = render(
            "paper", **about, is_paper=True, paper=paper, glossary=f"../{INDEX}"
        )
        for quantity in describe_quantities(source):
            found[f"quantities/{quantity.system}.{quantity.name}.html"] = render(
                "quantity", **about, is_paper=False, quantity=quantity
            )
    return found


def _list_pictures(sources: Sequence[Source]) -> Mapping[str, Callable[[], Picture]]:
    """List what is to be drawn: the picture of all first, which takes longest."""
    records = [record for source in sources for record in source.records]
    tasks: dict[str, Callable[[], Picture]] = {}
    if len(records) > 1:
        tasks[OVERVIEW] = partial(overview, records)
    for source in sources:
        tasks |= list_figures(source.location)
    for record in records:
        tasks |= list_charts(record)
    return tasks


def _describe(source: Source, pictures: Mapping[str, Picture]) -> PaperView:
    own = list_figures(source.location)
    return describe_paper(source, {name: pictures[name].after for name in own})


def _render_index(
    papers: Sequence[PaperView], sources: Sequence[Source], picture: Picture | None
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
        looks=(*LOOKS.values(), MEASURED),
        rungs=RUNGS,
    )
