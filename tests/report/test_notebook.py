"""Notebooks: objects that display themselves there, and a tour run from top to bottom."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient
from pages import read_page

import mechproof
from mechproof.derivation import load_paper, packaged_directory
from mechproof.ledger.judged import JudgedPaper
from mechproof.proof.judge import judge
from mechproof.report.notebook_pieces import read_parameters

TOUR = Path(__file__).parents[2] / "docs" / "tour.ipynb"
MECHANISMS = (
    mechproof.EllipticPlanetary.published(2),
    mechproof.OvalPlanetary.published(3),
    mechproof.ToothThickness.published(),
    mechproof.TrackWheel.published(z=8, H=20.0, shift=(0.0, 0.0, 0.0)),
    mechproof.WedgeLinkage.published(1),
)


def show(thing: object) -> str:
    """Return the HTML that a notebook would get; it must be well nested and run nothing."""
    text: str = thing._repr_html_()  # type: ignore[attr-defined]
    page = read_page(text)
    assert page.open == []
    assert [fault for fault in page.faults if fault != "a <style>"] == []
    assert page.links == []
    return text


@pytest.mark.parametrize("mechanism", MECHANISMS, ids=lambda m: type(m).__name__)
def test_a_mechanism_shows_its_parameters_and_its_motion(mechanism: object) -> None:
    text = show(mechanism)
    for name in vars(mechanism):
        assert f"<code>{name}</code>" in text
        assert read_parameters(type(mechanism).__doc__ or "")[name]
    moves = isinstance(mechanism, mechproof.EllipticPlanetary | mechproof.OvalPlanetary)
    assert ("<svg" in text) is moves


def test_a_paper_shows_its_prints_and_its_ledger_the_verdicts() -> None:
    paper = load_paper(packaged_directory() / "measurement")
    text = show(paper)
    assert "8 rows, not judged" in text
    assert "proved" not in text[text.index("</style>") :]
    row = judge(paper.rows[2], paper)
    assert "proved" in show(JudgedPaper("measurement", "", (row,), paper=paper))
    assert row.number in show(row)


def test_nothing_of_a_paper_is_markup() -> None:
    paper = load_paper(packaged_directory() / "measurement")
    hostile = type(paper)("x", "<script>hurt</script>", (), ())
    assert "<script" not in show(hostile)


@pytest.mark.slow
def test_without_the_extra_there_is_the_plain_text() -> None:
    code = (
        "import sys; sys.modules['jinja2'] = None; import mechproof;"
        "print(mechproof.EllipticPlanetary.published(2)._repr_html_())"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "None"


@pytest.mark.slow
@pytest.mark.xdist_group("report")
def test_the_tour_runs_from_top_to_bottom() -> None:
    tour = nbformat.read(TOUR, as_version=4)
    cells = [cell for cell in tour.cells if cell.cell_type == "code"]
    assert all(cell.outputs == [] and cell.execution_count is None for cell in cells)
    NotebookClient(tour, timeout=120, kernel_name="python3").execute()
    shown = [cell.outputs[-1].data for cell in cells if cell.outputs and "data" in cell.outputs[-1]]
    assert len(shown) == len(cells)
    pieces = [data["text/html"] for data in shown if "text/html" in data]
    assert len(pieces) == 5
    assert all('class="mechproof piece"' in piece for piece in pieces)
    assert "image/png" in shown[2]
    assert "refuted" in pieces[-1]
