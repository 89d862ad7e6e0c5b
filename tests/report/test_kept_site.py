"""A report whose papers and files are as before is not built again."""

from __future__ import annotations

import os
import time
from pathlib import Path

import pytest
from own_papers import write_slider_crank
from typer.testing import CliRunner

from mechproof.cli import app
from mechproof.report.kept_site import SITE, load_site
from mechproof.tools.cache import VARIABLE

AGED = 10.0


def age(file: Path) -> None:
    """Make a file older than the load that reads it: what is as young is not kept."""
    before = time.time() - AGED
    os.utime(file, (before, before))


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with one derivation, for which nothing is kept yet."""
    monkeypatch.setenv(VARIABLE, str(tmp_path / "cache"))
    folder = tmp_path / "derivations" / "slider_crank"
    folder.mkdir(parents=True)
    write_slider_crank(folder).rename(folder / "__init__.py")
    age(folder / "__init__.py")
    return folder


def builds(place: Path, *options: str) -> bool:
    """Write a report, and tell whether it was built for this."""
    out = place.parents[1] / "pages"
    result = CliRunner().invoke(app, ["report", str(place), "--out", str(out), *options])
    assert result.exit_code == 0, result.output
    assert "refuted" in (out / "papers" / "slider_crank.html").read_text(encoding="utf-8")
    return "writing the pages" in result.output


def test_a_site_is_built_once(place: Path) -> None:
    assert builds(place)
    assert not builds(place)
    assert builds(place, "--no-cache")


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
    # Younger than its load, so that the ledger is judged anew each time and the old one stays.
    helper.write_text("letter = 2", encoding="utf-8")
    os.utime(helper, (time.time() + AGED, time.time() + AGED))
    assert [builds(place), builds(place)] == [True, True]


def test_a_derivation_of_one_file_is_built_each_time(place: Path) -> None:
    # What else in its folder is of its figures is not known.
    file = place.parent / "alone.py"
    (place / "__init__.py").rename(file)
    assert [builds(file), builds(file)] == [True, True]


def test_what_is_damaged_is_built_anew(place: Path) -> None:
    builds(place)
    (key,) = SITE.read()
    SITE.write({key: {"files": {}}})
    assert load_site(key) is None
    assert builds(place)
