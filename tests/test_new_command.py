"""The command `new`: its files verify and regenerate, and it overwrites nothing."""

from __future__ import annotations

from contextlib import chdir
from pathlib import Path

import pytest
from command import run

from mechproof import choose
from mechproof.tools.cache import VARIABLE


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv(VARIABLE, str(tmp_path / "cache"))
    (tmp_path / "derivations").mkdir()
    return tmp_path


def run_in(folder: Path, *arguments: str) -> str:
    with chdir(folder):
        done = run(*arguments)
    assert done.exit_code == 0, done.output
    return done.output


def assert_verified(said: str) -> None:
    totals = dict(line.split() for line in said.splitlines() if line.startswith(("PROVED", "DEF")))
    assert totals == {"PROVED": "1", "DEFINITION": "2"}


@pytest.mark.slow
def test_a_paper_and_the_derivation_of_it_verify(folder: Path) -> None:
    run_in(folder, "new", "crank.tex")
    assert_verified(run_in(folder, "verify", "crank.tex"))
    assert "line 24" in run_in(folder, "check", "crank.tex")
    run_in(folder, "new", "crank.py")
    assert 'PRINT.symbols("r l varphi' in (folder / "crank.py").read_text()
    assert_verified(run_in(folder, "verify", "crank.py"))


@pytest.mark.slow
def test_a_derivation_of_its_own_is_proved_and_its_kernel_written(folder: Path) -> None:
    run_in(folder, "new", "derivations/slider_crank.py")
    output = run_in(folder, "regenerate")
    assert "wrote slider_crank.py" in output
    assert "REFUTED" not in (folder / "generated" / "LEDGER.md").read_text()
    run_in(folder, "measure", "--quick")
    measured = folder / "generated" / "measured" / "quick"
    (quantity,) = (file.stem for file in measured.glob("*.json"))
    run_in(folder, "chart", "--measured", str(measured), "--out", "charts")
    assert list((folder / "charts").glob(f"{quantity}*.svg"))
    run_in(folder, "report")
    assert (folder / "report" / "quantities" / f"{quantity}.html").is_file()
    choice = choose(quantity, error=1e-9, measured=measured)
    assert choice.error <= 1e-9


@pytest.mark.parametrize(
    ("file", "told"),
    [
        ("crank.tex", "exists already"),
        ("crank.txt", "must end in .tex"),
        ("two words.py", "letters, digits and underscores"),
        ("kernels.py", "must not be compiled, derivatives, forms, kernels"),
    ],
)
def test_nothing_is_overwritten_and_bad_names_are_refused(
    folder: Path, file: str, told: str
) -> None:
    (folder / "crank.tex").write_text("mine")
    with chdir(folder):
        done = run("new", file)
    assert (done.exit_code, told in done.output) == (2, True), done.output
    assert (folder / "crank.tex").read_text() == "mine"


def test_a_source_that_cannot_be_read_is_refused(folder: Path) -> None:
    (folder / "crank.tex").write_text("%% mechproof\n%% no colon\n%% end\n")
    with chdir(folder):
        done = run("new", "crank.py")
    assert (done.exit_code, "crank.tex:2:4" in done.output) == (2, True), done.output
