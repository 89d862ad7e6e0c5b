"""The report as one file: every id in it is unique, and its links stay inside it."""

from __future__ import annotations

from pathlib import Path

import pytest
from own_papers import write_slider_crank
from pages import find_faults, read_page
from typer.testing import CliRunner, Result

from mechproof.cli import app
from mechproof.report import join_pages

pytestmark = pytest.mark.xdist_group("report")


def run(*arguments: str) -> Result:
    return CliRunner().invoke(app, ["report", *arguments])


@pytest.fixture(scope="module")
def page(files: dict[str, str]) -> str:
    return join_pages(files)


def test_it_has_the_faults_of_one_file_alone(
    files: dict[str, str], page: str, tmp_path: Path
) -> None:
    (tmp_path / "one.html").write_text(page, encoding="utf-8")
    found = find_faults(tmp_path)
    titles = sum(name.endswith(".html") for name in files)
    assert set(found) == {"one.html: a <style>", f"one.html: {titles} elements <h1>"}


def test_every_link_of_a_page_to_another_leads_within_it(files: dict[str, str], page: str) -> None:
    links = read_page(page).links
    assert len(links) > 200
    assert all(link.startswith(("#", "https://")) for link in links)


def test_a_link_that_leads_nowhere_is_seen(page: str, tmp_path: Path) -> None:
    broken = page.replace('id="papers/elliptic_planetary.html/eq-3"', 'id="elsewhere"')
    (tmp_path / "one.html").write_text(broken, encoding="utf-8")
    assert any("eq-3" in fault for fault in find_faults(tmp_path))


def test_the_command_replaces_a_report_and_nothing_else(tmp_path: Path) -> None:
    paper, out = write_slider_crank(tmp_path), tmp_path / "one.html"
    for _ in range(2):
        result = run(str(paper), "--single", "--out", str(out))
        assert result.exit_code == 0, result.output
        assert f"wrote {out}" in result.output
    assert [path.name for path in tmp_path.glob("*.html")] == ["one.html"]
    out.write_text("a page of my own", encoding="utf-8")
    refused = run(str(paper), "--single", "--out", str(out))
    assert refused.exit_code == 2
    assert "exists and is not a mechproof report" in refused.output
    assert out.read_text(encoding="utf-8") == "a page of my own"
    assert run(str(paper), "--single", "--out", "").exit_code == 2
