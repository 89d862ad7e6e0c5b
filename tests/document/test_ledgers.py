"""The source of a paper as an argument of `verify` and `report`."""

from __future__ import annotations

import json
import os
import time
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from mechproof.cli import app
from mechproof.pipeline.verification import find_ledgers
from mechproof.proof.verdict import State, Verdict
from mechproof.tools.cache import VARIABLE

BLOCK = "%% mechproof\n%% r ; l : lengths [mm]\n%% k : ratio\n%% end\n"
RIGHT = BLOCK + "\\begin{equation}k=\\frac rl\\end{equation}\n"
TRUE = RIGHT + "\\begin{equation}kl=r\\end{equation}\n"
WRONG = RIGHT + "\\begin{equation}k=\\frac lr\\end{equation}\n"
UNREAD = RIGHT + "\\begin{equation}q=3r\\end{equation}\n$$k=\\frac lr$$"


@pytest.fixture
def paper(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv(VARIABLE, str(tmp_path / "cache"))
    return tmp_path / "a paper.tex"


def write(file: Path, content: str) -> None:
    file.write_text(content)
    # A ledger is not cached if the file is as recent as the reading itself.
    before = time.time() - 10
    os.utime(file, (before, before))


def run(*arguments: str) -> Result:
    return CliRunner().invoke(app, list(arguments))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("content", "options", "status"),
    [
        (TRUE, [], 0),
        (WRONG, [], 0),
        (WRONG, ["--fail-on", "refuted"], 1),
        (UNREAD, [], 1),
        (UNREAD, ["--fail-on", "undecided"], 0),
    ],
)
def test_verify_takes_a_source_as_it_takes_a_derivation(
    paper: Path, content: str, options: list[str], status: int
) -> None:
    write(paper, content)
    assert run("verify", str(paper), *options).exit_code == status


def test_a_misprint_is_a_finding_and_what_was_not_read_is_listed(paper: Path) -> None:
    write(paper, UNREAD)
    file = paper.with_suffix(".json")
    output = run("verify", str(paper), "--json", str(file)).output
    assert "\na_paper display 1  REFUTED  at l = " in output
    assert "1 paper, 2 rows, 1 finding, 1 row without a verdict" in output
    assert output.count("q is not declared") == 1
    written = json.loads(file.read_text())
    assert [row["place"] for row in written["rows"]] == [f"{paper}:5:17", f"{paper}:7:3"]
    assert [row["state"] for row in written["left"]] == ["not read"]


def test_a_wrong_number_costs_what_is_printed_instead_of_the_right_one(paper: Path) -> None:
    table = "\\begin{tabular}{ccc}$r$ & $l$ & $k$\\\\ 2 & 4 & 0.5\\\\ 2 & 8 & 0.52\\end{tabular}\n"
    write(paper, RIGHT + table)
    (ledger,) = find_ledgers([paper])
    costs = [str(cost) for finding in ledger.findings for cost in finding.costs]
    assert costs == ["at r = 2, l = 8: printed 0.52, recomputed 0.25"]


def test_a_ledger_is_kept_until_its_paper_or_the_file_beside_it_changes(paper: Path) -> None:
    write(paper, UNREAD)
    (first,) = find_ledgers([paper])
    (again,) = find_ledgers([paper], report=(said := []).append)
    assert (again.judgements, again.findings, again.left, said) == (
        first.judgements,
        first.findings,
        first.left,
        [],
    )
    assert [row.state for row in again.left] == [State.NOT_READ]
    write(paper.with_suffix(".letters"), "q : a length [mm]\n")
    (declared,) = find_ledgers([paper])
    assert declared.left == ()
    write(paper, TRUE)
    (changed,) = find_ledgers([paper])
    assert [row.verdict for row in changed.judgements] == [Verdict.DEFINITION, Verdict.PROVED]


def test_a_paper_with_a_table_that_is_not_compared_is_kept(paper: Path) -> None:
    table = "\\begin{tabular}{ll}Material & Price\\\\ steel & 12\\\\ \\end{tabular}"
    write(paper, TRUE + table)
    find_ledgers([paper])
    find_ledgers([paper], report=(said := []).append)
    assert said == []


def test_what_lacks_a_file_is_not_kept(paper: Path) -> None:
    write(paper, TRUE + "\\input{more}")
    find_ledgers([paper])
    write(paper.parent / "more.tex", "$$k=\\frac lr$$")
    (ledger,) = find_ledgers([paper])
    assert [finding.number for finding in ledger.findings] == ["display 1"]


def test_rows_of_one_name_are_told_apart(paper: Path) -> None:
    write(paper, BLOCK + "$$k=\\frac rl\\tag{1}$$\n$$k=\\frac lr\\tag{1}$$")
    (ledger,) = find_ledgers([paper])
    assert [row.number for row in ledger.judgements] == [f"(1), {paper}:5:3", f"(1), {paper}:6:3"]


def test_a_block_that_cannot_be_read_ends_the_command(paper: Path) -> None:
    write(paper, "%% mechproof\n%% no colon\n%% end\n")
    result = run("verify", str(paper))
    assert result.exit_code == 1
    assert f"{paper}:2:4: neither a letter" in result.output


def test_kernels_are_not_emitted_from_a_source(paper: Path) -> None:
    write(paper, TRUE)
    result = run("emit", "c", str(paper), "--out", str(paper.parent / "c"))
    assert result.exit_code == 2
    assert "is neither a file FILE.py, nor" in result.output


def test_the_report_shows_where_rows_stand_and_why_some_have_no_verdict(paper: Path) -> None:
    write(paper, UNREAD)
    out = paper.parent / "site"
    assert run("report", str(paper), "--out", str(out)).exit_code == 0
    page = (out / "papers" / "a_paper.html").read_text()
    assert '<small class="place">line 6</small>' in page
    assert "q is not declared. Declare it in the block of letters" in page
    assert '<th scope="row">one side</th>' in page
    assert "rebuilt" not in page
    assert "no verdict" in (out / "index.html").read_text()
