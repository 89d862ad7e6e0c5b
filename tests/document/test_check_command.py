"""The command `check`, run on the files of papers."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

import mechproof
from mechproof.cli import app

BLOCK = "%% mechproof\n%% r ; l : lengths [mm]\n%% k : ratio\n%% end\n"
RIGHT = BLOCK + "\\begin{equation}k=\\frac rl\\end{equation}\n"
WRONG = RIGHT + "\\begin{equation}k=\\frac lr\\end{equation}\n"
OPENED = BLOCK + "\\begin{equation}k=\\frac rl\n"
UNREAD = RIGHT + "\\begin{equation}q=3r\\end{equation}\n$$q=4l$$"


def run(*arguments: str, text: str | None = None) -> Result:
    return CliRunner().invoke(app, ["check", *arguments], input=text)


@pytest.mark.parametrize(
    ("content", "options", "status"),
    [
        (RIGHT, [], 0),
        (WRONG, [], 1),
        (WRONG, ["--fail-on", "not-read"], 0),
        (UNREAD, [], 1),
        (UNREAD, ["--fail-on", "refuted,undecided"], 0),
        (UNREAD, ["--fail-on", "refuted", "--fail-on", "not-read"], 1),
        (UNREAD, ["--fail-on", "none"], 0),
        (OPENED, [], 1),
        (BLOCK, [], 2),
        (BLOCK + "where $k=r/l$\n", ["--fail-on", "none"], 2),
    ],
)
def test_the_status_is_said_by_outcomes(
    tmp_path: Path, content: str, options: list[str], status: int
) -> None:
    file = tmp_path / "paper.tex"
    file.write_text(content)
    assert run(str(file), *options).exit_code == status


def test_rows_of_one_cause_are_one_line(tmp_path: Path) -> None:
    file = tmp_path / "paper.tex"
    file.write_text(UNREAD)
    output = run(str(file)).output
    assert output.count("q is not declared") == 1
    assert "not read: 2 rows" in output
    assert f"(2)  {file}:6:17" in output
    assert f"display 1  {file}:7:3" in output
    assert "DEFINITION 1, not read 2" in output


def test_where_no_equation_is_found_it_is_said_what_is_looked_for() -> None:
    result = run("-", text="Let $k=r/l$ be their ratio.")
    assert result.exit_code == 2
    assert "there is no equation" in result.output
    assert r"\begin{equation}" in result.output


def test_what_comes_from_a_pipe_is_read_like_a_file() -> None:
    result = run("-", text=WRONG)
    assert result.exit_code == 1
    assert "compared with (1)" in result.output


def test_several_papers_are_checked_each_with_its_letters(tmp_path: Path) -> None:
    names = [tmp_path / "one.tex", tmp_path / "two.tex"]
    for name, content in zip(names, (RIGHT, WRONG), strict=True):
        name.write_text(content)
    result = run(*map(str, names), "--json", str(tmp_path / "rows.json"))
    assert result.exit_code == 1
    rows = json.loads((tmp_path / "rows.json").read_text())["rows"]
    assert [row["outcome"] for row in rows] == ["DEFINITION", "DEFINITION", "REFUTED"]
    assert rows[2]["judgement"]["rung"] == "separating balls"


def test_a_draft_is_read_again(tmp_path: Path) -> None:
    file = tmp_path / "paper.tex"
    text = (
        "Here $r$ is the radius of the crank [mm], and $\\varphi$ denotes its angle.\n"
        "$$x=r\\cos\\varphi$$ $$\\dot x=-r\\dot\\varphi\\sin\\varphi$$\n"
    )
    file.write_text(text)
    block = run("--draft", str(file)).output
    assert "%% r : radius of the crank [mm]" in block
    assert "%% x(t) :" in block
    assert "%% # line 1 says:" in block
    file.write_text(block + text)
    result = run(str(file))
    assert result.exit_code == 0
    assert "DEFINITION 1, PROVED 1" in result.output


def test_a_draft_says_which_equations_show_no_letters(tmp_path: Path) -> None:
    file = tmp_path / "paper.tex"
    file.write_text("$$a=b$$\n$$y=\\frac{p}{$$\n$$q(x)=\\unknown{r}$$\n")
    block = run("--draft", str(file)).output
    assert "%% a :" in block
    assert "%% # display 2, line 2: its letters are missing here:" in block
    assert "%% # display 3, line 3" in block
    file.write_text(block + file.read_text())
    assert [row.outcome for row in mechproof.check(file).rows] == [
        "DEFINITION",
        "not read",
        "not read",
    ]


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (["none.tex"], "no such file"),
        (["x=x", "y=y"], "alone"),
        (["--draft", "x=x"], "--draft needs a paper"),
        (["--fail-on", "wrong", "x=x"], "--fail-on wrong"),
        (["x=x", "--json", "paper.tex"], "has the name of a paper"),
    ],
)
def test_bad_usage(arguments: list[str], reason: str) -> None:
    result = run(*arguments)
    assert result.exit_code == 2
    assert reason in result.output


def test_options_of_equations_are_refused_for_files(tmp_path: Path) -> None:
    file = tmp_path / "paper.tex"
    file.write_text(RIGHT)
    result = run(str(file), "--factor", "k")
    assert result.exit_code == 2
    assert "block of letters" in result.output


def test_a_wrong_block_is_bad_usage(tmp_path: Path) -> None:
    file = tmp_path / "paper.tex"
    file.write_text(RIGHT.replace("k : ratio", "k is a ratio"))
    result = run(str(file))
    assert result.exit_code == 2
    assert f"{file}:3:4" in result.output


def test_papers_are_checked_in_python(tmp_path: Path) -> None:
    file = tmp_path / "paper.tex"
    file.write_text(WRONG)
    found = mechproof.check(file)
    assert [row.outcome for row in found.rows] == ["DEFINITION", "REFUTED"]
    assert mechproof.check("paper.tex", RIGHT).rows[0].outcome == "DEFINITION"
