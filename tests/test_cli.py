"""The command line: exit states, errors that teach, the shape of the JSON."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from mechproof.cli import app

FIELDS = {
    "system", "number", "kind", "verdict", "rung", "marks",
    "printed_latex", "reason", "evidence", "corrected_latex",
}  # fmt: skip
HEAD = """
from sympy import Function, Integral, Interval, S, Symbol, cos, gamma, oo, pi, sin, symbols
from mechproof.record import *
x, y = symbols("x y", real=True)
def paper(*rows):
    variables = (Variable(x, "a number"), Variable(y, "another"))
    return Paper("mine", "my notes", variables, rows)
"""
PROVED = 'Equation("(1)", "1", Equality(sin(x)**2 + cos(x)**2, S.One))'
OPEN = 'Equation("(2)", "2", Equality(gamma(x**2 + 1), x**2 * gamma(x**2))%s)'


def run(*arguments: str) -> Result:
    return CliRunner().invoke(app, list(arguments))


def write(folder: Path, *rows: str) -> Path:
    file = folder / "mine.py"
    file.write_text(f"{HEAD}\nPAPER = paper({', '.join(rows)})\n", encoding="utf-8")
    return file


def test_rows_have_the_stated_fields(tmp_path: Path) -> None:
    target = tmp_path / "rows.json"
    result = run("verify", str(write(tmp_path, PROVED)), "--json", str(target))
    assert result.exit_code == 0, result.output
    (row,) = json.loads(target.read_text(encoding="utf-8"))
    assert row.keys() == FIELDS
    assert (row["system"], row["number"], row["kind"]) == ("mine", "(1)", "equation")
    assert row["verdict"] == "PROVED"
    assert "mine, printed: 1 PROVED" in result.output


@pytest.mark.parametrize(("reason", "status"), [("", 1), (', stays_open="no gamma rung"', 0)])
def test_an_open_row_must_say_why(tmp_path: Path, reason: str, status: int) -> None:
    result = run("verify", str(write(tmp_path, PROVED, OPEN % reason)))
    assert result.exit_code == status, result.output
    assert "1 UNDECIDED" in result.output


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("PAPER = 1", "binds no mechproof.record.Paper"),
        ("import nowhere", "No module named 'nowhere'"),
        (f"{HEAD}\nPAPER = paper({PROVED}, {PROVED})", "row numbers given twice"),
    ],
)
def test_a_derivation_that_fails_is_named(tmp_path: Path, text: str, message: str) -> None:
    file = tmp_path / "broken.py"
    file.write_text(text, encoding="utf-8")
    result = run("verify", str(file))
    assert result.exit_code == 1
    assert "broken.py" in result.output.replace("\n", "")
    assert message in " ".join(result.output.split())


@pytest.mark.parametrize(
    "arguments",
    [
        ["verify", "no_such_system"],
        ["verify", "missing.py"],
        ["verify", "elliptic_planetary", "--json", "no/such/folder/rows.json"],
        ["verify", "elliptic_planetary", "--json", "."],
        ["verify", "--no-such-option"],
        ["regenerate", "--root", "no/such/folder"],
    ],
)
def test_bad_usage_is_2(arguments: list[str]) -> None:
    assert run(*arguments).exit_code == 2


def test_regenerate_writes_a_users_own_folder(tmp_path: Path) -> None:
    (tmp_path / "derivations").mkdir()
    write(tmp_path / "derivations", PROVED)
    assert run("regenerate", "--root", str(tmp_path), "--check").exit_code == 1
    assert run("regenerate", "--root", str(tmp_path)).exit_code == 0
    assert run("regenerate", "--root", str(tmp_path), "--check").exit_code == 0
    ledger = tmp_path / "generated" / "LEDGER.md"
    ledger.write_text(ledger.read_text(encoding="utf-8") + "edited", encoding="utf-8")
    result = run("regenerate", "--root", str(tmp_path), "--check")
    assert result.exit_code == 1
    assert "mechproof regenerate" in result.output


def test_brackets_in_names_are_shown_as_they_are(tmp_path: Path) -> None:
    file = write(tmp_path, PROVED)
    file.write_text(file.read_text(encoding="utf-8").replace('"my notes"', '"notes [/x] [red]"'))
    result = run("verify", str(file))
    assert result.exit_code == 0, result.output
    assert "notes [/x] [red]" in result.output
