"""Coq scripts, one for each proved or refuted row, and the command that writes them."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path

import pytest
from command import PROVED, run, write

from mechproof.pipeline import row_scripts
from mechproof.pipeline.row_scripts import BESIDE_OTHERS, WITHOUT_ROW, write_row_scripts
from mechproof.pipeline.verification import judge_derivations
from mechproof.proof.verdict import Verdict

needs_coq = pytest.mark.skipif(shutil.which("coqc") is None, reason="Coq is not installed")

TEXT = """
from sympy import symbols
from mechproof.record import *
x = symbols("x", real=True)
ROWS = tuple(
    Equation(f"({n})", "print", Equality((x + n) ** 2, x**2 + 2*n*x + n**2 + int(n == 2)))
    for n in (1, 2, 3)
)
PAPER = Paper("mine", "my notes", (Variable(x, "a number"),), ROWS)
"""

CONDITIONAL = """
from sympy import Ge, Interval, oo, symbols
from mechproof.record import *
x = symbols("x", real=True)
PART = Part("x from 1 on", within={x: Interval(1, oo)})
ROWS = (Equation("(1)", "print", Holds(Ge(x**2, x)), holds_on=PART),)
PAPER = Paper("mine", "my notes", (Variable(x, "a number"),), ROWS)
"""


@pytest.fixture
def place(tmp_path: Path) -> Path:
    file = tmp_path / "mine.py"
    file.write_text(TEXT, encoding="utf-8")
    return file


def test_every_row_has_a_script_or_a_reason_in_the_order_of_the_ledger(place: Path) -> None:
    (ledger,) = judge_derivations([place], use_cache=False)
    first = ledger.judgements[0]
    alone = replace(first, number="(0)")
    ledger = replace(ledger, judgements=(alone, *ledger.judgements))
    told: list[str] = []
    written = write_row_scripts({place: ledger}, told.append)
    assert [script.id for script in written] == [f"mine/eq-{n}" for n in range(4)]
    assert [script.reason for script in written] == [WITHOUT_ROW, "", "", ""]
    assert sorted(told) == ["mine: (1)", "mine: (2)", "mine: (3)"]


@pytest.mark.parametrize("suffix", [".tex", ".py"])
def test_prints_without_mechanics_have_scripts_but_for_what_follows(
    tmp_path: Path, suffix: str
) -> None:
    printed = r"$$(x+1)^2=x^2+2x+1$$ $$\sqrt2=1.42$$ $$x\cos y=z\sin y$$ $$2x\cos y=2z\sin y$$"
    (tmp_path / "own.tex").write_text(printed, encoding="utf-8")
    file = tmp_path / f"own{suffix}"
    assert suffix == ".tex" or run("new", str(file)).exit_code == 0
    (ledger,) = judge_derivations([file], use_cache=False)
    written = write_row_scripts({file: ledger})
    assert [script.reason for script in written] == ["", "", BESIDE_OTHERS]
    assert [bool(script.text) for script in written] == [True, True, False]


def test_a_conditional_row_has_a_theorem_and_a_point_at_which_it_fails(tmp_path: Path) -> None:
    file = tmp_path / "mine.py"
    file.write_text(CONDITIONAL, encoding="utf-8")
    (ledger,) = judge_derivations([file], use_cache=False)
    assert [one.verdict for one in ledger.judgements] == [Verdict.CONDITIONAL]
    (script,) = write_row_scripts({file: ledger})
    assert "Theorem part_1 : forall x : R, (x >= 1) -> ((x ^ 2) >= x)." in script.text
    assert "Theorem part_2 : exists x : R, ((x ^ 2) < x)." in script.text


@pytest.mark.parametrize(
    ("printed", "is_alike"),
    [(r"x-y=x-y", True), (r"x-y+1=1-(y-x)", True), (r"(x-y)^2=x^2-2xy+y^2", False)],
)
def test_it_is_told_where_both_sides_are_one(tmp_path: Path, printed: str, is_alike: bool) -> None:
    file = tmp_path / "own.tex"
    file.write_text(f"$${printed}$$", encoding="utf-8")
    (ledger,) = judge_derivations([file], use_cache=False)
    (script,) = write_row_scripts({file: ledger})
    assert script.is_alike is is_alike
    assert ("reflexivity." in script.text) is is_alike


def test_what_coq_refuses_by_the_record_is_left_out(
    place: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (ledger,) = judge_derivations([place], use_cache=False)
    refused = {script.id: script.digest for script in write_row_scripts({place: ledger})[:2]}
    refused["mine/eq-2"] = "of another script"
    monkeypatch.setattr("mechproof.pipeline.row_scripts.read_refused", lambda folder: refused)
    result = run("certify", str(place), "--out", str(tmp_path / "coq"))
    assert "2 scripts of 3 rows" in " ".join(result.output.split())
    assert "left out: 1 scripts recorded as refused by Coq" in " ".join(result.output.split())
    assert not (tmp_path / "coq" / "mine_eq_1.v").exists()


def test_a_row_at_which_it_fails_is_named(place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (ledger,) = judge_derivations([place], use_cache=False)

    def fail(*given: object) -> None:
        raise RuntimeError("no words")

    monkeypatch.setattr(row_scripts, "write_row_script", fail)
    with pytest.raises(ValueError, match=r"mine: \(\d\): RuntimeError: no words"):
        write_row_scripts({place: ledger})


def test_the_command_writes_a_folder_and_refuses_another(tmp_path: Path) -> None:
    file, out = write(tmp_path, PROVED), tmp_path / "coq"
    result = run("certify", str(file), "--out", str(out))
    assert result.exit_code == 0, result.output
    assert "1 scripts of 1 rows" in result.output.replace("\n", " ")
    assert sorted(path.suffix for path in out.iterdir()) == ["", ".sha256", *[".v"] * 3]
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "notes.txt").write_text("mine")
    assert run("certify", str(file), "--out", str(tmp_path / "other")).exit_code == 1
    assert run("certify", str(file), "--out", str(out), "--record").exit_code == 2


@needs_coq
@pytest.mark.thorough
def test_the_command_has_coq_check(tmp_path: Path) -> None:
    file, out = write(tmp_path, PROVED), tmp_path / "coq"
    result = run("certify", str(file), "--out", str(out), "--check")
    assert result.exit_code == 0, result.output
    assert "1 of 1 rows (100.0%) are accepted" in result.output.replace("\n", " ")
    assert "mine_eq_1.v" in (out / "COQ.md").read_text(encoding="utf-8")
