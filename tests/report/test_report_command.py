"""The command that writes the report: its exit status, and what it refuses."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from own_papers import write_hostile, write_slider_crank
from pages import find_faults
from typer.testing import CliRunner, Result

from mechproof.cli import app


def run(*arguments: str) -> Result:
    return CliRunner().invoke(app, ["report", *arguments])


def test_a_paper_of_a_user_becomes_pages(tmp_path: Path) -> None:
    file, out = write_slider_crank(tmp_path), tmp_path / "pages"
    for _ in range(2):
        result = run(str(file), "--out", str(out))
        assert result.exit_code == 0, result.output
        assert "3 files" in result.output
    page = (out / "papers" / "slider_crank.html").read_text(encoding="utf-8")
    assert 'id="finding-eq-2"' in page
    assert page.index("refuted") < page.index('id="eq-1"')


def test_a_row_that_fails_is_shown_and_is_status_1(tmp_path: Path) -> None:
    out = tmp_path / "pages"
    result = run(str(write_hostile(tmp_path)), "--out", str(out))
    assert result.exit_code == 1
    assert "ghost" in result.output
    assert (out / "papers" / "größe.html").is_file()


def test_a_folder_of_other_things_is_refused_before_anything_is_judged(tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").write_text("mine")
    result = run(str(write_slider_crank(tmp_path)), "--out", str(tmp_path))
    assert result.exit_code == 2
    assert "is not a mechproof report" in result.output
    assert "judging" not in result.output


@pytest.mark.parametrize(
    ("text", "fault"), [("raise OSError('gone')", "gone"), ("x = 1", "must bind a mechproof")]
)
def test_a_derivation_that_fails_is_status_1(tmp_path: Path, text: str, fault: str) -> None:
    file = tmp_path / "mine.py"
    file.write_text(text, encoding="utf-8")
    result = run(str(file), "--out", str(tmp_path / "pages"))
    assert result.exit_code == 1
    assert fault in result.output
    assert not (tmp_path / "pages").exists()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("drawing", "fault"),
    [
        ("1 / 0", "pictures.py:2: ZeroDivisionError: division by zero"),
        ("canvas.text(0, 0, r'$\\frac$')", "ValueError"),
        ("__import__('os')._exit(3)", "its process ended with status 3"),
    ],
)
def test_a_figure_that_cannot_be_drawn_is_shown_and_is_status_1(
    tmp_path: Path, drawing: str, fault: str
) -> None:
    folder = tmp_path / "mine"
    folder.mkdir()
    write_slider_crank(folder).rename(folder / "__init__.py")
    (folder / "pictures.py").write_text(
        "from mechproof.plot import Figure\n"
        f"FIGURES = (Figure('one', None, 'A title', '', '(1)', lambda canvas: {drawing}),\n"
        "    Figure('two', None, 'Another', '', '(1)', lambda canvas: None))\n",
        encoding="utf-8",
    )
    out = tmp_path / "pages"
    result = run(str(folder), "--out", str(out))
    assert result.exit_code == 1
    assert result.stderr.count("mine, one: ") == 1
    assert fault in result.stderr
    page = (out / "papers" / "slider_crank.html").read_text(encoding="utf-8")
    place = page.index('id="figure-one"')
    assert f"Could not be drawn: {fault}" in page[place : page.index("</figure>", place)]
    assert page.count("<svg") == 1
    assert find_faults(out) == []


def test_only_what_is_done_is_said(tmp_path: Path) -> None:
    result = run(str(write_slider_crank(tmp_path)), "--out", str(tmp_path / "pages"))
    assert "writing the pages" in result.stderr
    assert "drawing" not in result.stderr


def test_only_what_occurs_is_explained(tmp_path: Path) -> None:
    out = tmp_path / "pages"
    run(str(write_slider_crank(tmp_path)), "--out", str(out))
    text = (out / "index.html").read_text(encoding="utf-8")
    legend = text[text.index('id="legend"') :]
    assert set(re.findall(r'class="badge v-([\w-]+)"', legend)) == {"proved", "refuted"}
    assert "mark-fitted" not in legend
    assert "two completions" not in legend
    assert "separating balls" in legend


@pytest.mark.parametrize("command", [["report"], ["figures"], ["chart"], ["emit", "c"]])
@pytest.mark.parametrize(
    ("out", "says"),
    [
        ("{}/taken", "{}/taken is not a folder"),
        ("{}/taken/deeper/pages", "{}/taken is not a folder"),
        ("{}/dangling", "{}/dangling is not a folder"),
        ("", "is empty"),
        ("/proc/pages", "cannot write to /proc"),
    ],
)
def test_a_folder_that_cannot_be_is_refused_first(
    tmp_path: Path, command: list[str], out: str, says: str
) -> None:
    (tmp_path / "taken").write_text("mine")
    (tmp_path / "dangling").symlink_to(tmp_path / "nowhere")
    arguments = [*command, "elliptic_planetary", "--out", out.format(tmp_path)]
    result = CliRunner().invoke(app, arguments)
    assert result.exit_code == 2, result.output
    (line,) = result.output.splitlines()
    assert line.startswith("--out")
    assert says.format(tmp_path) in line


def test_an_unknown_paper_is_bad_usage(tmp_path: Path) -> None:
    assert run("nothing", "--out", str(tmp_path / "pages")).exit_code == 2
