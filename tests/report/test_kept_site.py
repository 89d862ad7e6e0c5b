"""Unchanged pages of a paper are not written again, and none of them is stale."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest
from own_papers import write_slider_crank
from typer.testing import CliRunner

from mechproof.cli import app
from mechproof.report import site
from mechproof.report.judged_derivations import JudgedDerivation
from mechproof.report.paper_pages import PaperView, describe_paper
from mechproof.report.site import _store, load_shares
from mechproof.tools.cache import VARIABLE

AGED = 10.0
# The message shown when papers are loaded for their pages.
LOADS = "loading earlier verdicts"
SMALL = """
from sympy import Symbol

from mechproof.record import Claim, Equality, Paper, Variable

x = Symbol("x", real=True)
PAPER = Paper(
    system="{system}",
    citation="Nobody 2001",
    conventions="",
    variables=(Variable(x, "a number", latex=("x",)),),
    rows=(Claim("(1)", "x+x=2x", Equality(x + x, 2 * x), note="A sum."),),
)
"""


def age(file: Path) -> None:
    """Make a file older than the load that reads it: with a younger one, nothing is cached."""
    before = time.time() - AGED
    os.utime(file, (before, before))


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a folder with one derivation, for which nothing is cached yet."""
    monkeypatch.setenv(VARIABLE, str(tmp_path / "cache"))
    folder = tmp_path / "derivations" / "slider_crank"
    folder.mkdir(parents=True)
    write_slider_crank(folder).rename(folder / "__init__.py")
    age(folder / "__init__.py")
    return folder


def write_report(places: list[Path], *options: str) -> tuple[dict[str, str], str]:
    """Write a report of papers; return its pages by their names, and the output."""
    out = places[0].parents[1] / "pages"
    result = CliRunner().invoke(app, ["report", *map(str, places), "--out", str(out), *options])
    assert result.exit_code == 0, result.output
    pages = {str(f.relative_to(out)): f for f in out.rglob("*.html")}
    return {name: f.read_text(encoding="utf-8") for name, f in pages.items()}, result.output


def builds(place: Path, *options: str) -> bool:
    """Write a report; return whether the pages of its paper were made for it."""
    pages, said = write_report([place], *options)
    assert "refuted" in pages["papers/slider_crank.html"]
    return LOADS in said


def write_small(folder: Path, small: str = SMALL) -> None:
    """Write a derivation with one row."""
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / "__init__.py"
    file.write_text(small.replace("{system}", folder.name), encoding="utf-8")
    age(file)


@pytest.fixture
def pair(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> list[Path]:
    """Return two derivations with one row each, for which nothing is cached yet."""
    monkeypatch.setenv(VARIABLE, str(tmp_path / "cache"))
    places = [tmp_path / "derivations" / name for name in ("first", "second")]
    for place in places:
        write_small(place)
    return places


def test_a_changed_row_changes_its_pages_and_nothing_else_is_written_again(
    pair: list[Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    before, _ = write_report(pair)
    write_small(pair[1], SMALL.replace("2x", "3x").replace("2 * x", "3 * x"))
    described: list[str] = []
    monkeypatch.setattr(site, "describe_paper", _note_system(described))
    after, _ = write_report(pair)
    assert described == ["second"]
    changed = {name for name in after if after[name] != before[name]}
    assert changed == {"index.html", "papers/second.html"}
    assert after == write_report(pair, "--no-cache")[0]


def _note_system(described: list[str]) -> Callable[..., PaperView]:
    def describe(source: JudgedDerivation, figures: Mapping[str, str]) -> PaperView:
        described.append(source.system)
        return describe_paper(source, figures)

    return describe


def test_other_papers_beside_one_are_on_its_pages(pair: list[Path]) -> None:
    write_report(pair[:1])
    assert "second.html" in write_report(pair)[0]["papers/first.html"]


@pytest.mark.slow
def test_a_site_is_built_once(place: Path) -> None:
    assert builds(place)
    assert not builds(place)
    assert builds(place, "--no-cache")


@pytest.mark.slow
@pytest.mark.parametrize(
    "name", ["slider_crank/figures.tex", "slider_crank/__init__.py", "../generated/coq.json"]
)
def test_what_a_site_shows_makes_it_anew(place: Path, name: str) -> None:
    builds(place)
    file = place.parent / name
    file.parent.mkdir(exist_ok=True)
    with file.open("a", encoding="utf-8") as end:
        end.write("# {}" if file.suffix == ".py" else "{}")
    age(file)
    assert builds(place)
    assert not builds(place)


def test_a_site_of_ledgers_that_are_not_kept_is_not_taken(place: Path) -> None:
    builds(place)
    helper = place.parent / "helper.py"
    helper.write_text("letter = 1", encoding="utf-8")
    age(helper)
    with (place / "__init__.py").open("a", encoding="utf-8") as end:
        end.write("\nfrom ..helper import letter\n")
    age(place / "__init__.py")
    assert [builds(place), builds(place)] == [True, False]
    # Younger than its load, so that the ledger is judged again each time and the old one stays.
    helper.write_text("letter = 2", encoding="utf-8")
    os.utime(helper, (time.time() + AGED, time.time() + AGED))
    assert [builds(place), builds(place)] == [True, True]


def test_a_derivation_of_one_file_is_built_each_time(place: Path) -> None:
    # It is not known which other files of its folder its figures use.
    file = place.parent / "alone.py"
    (place / "__init__.py").rename(file)
    assert [builds(file), builds(file)] == [True, True]


def test_what_is_damaged_is_built_anew(place: Path) -> None:
    builds(place)
    store = _store(place)
    (key,) = store.read()
    store.write({key: {"files": {}}})
    assert load_shares({place: key}) == {}
    assert builds(place)
