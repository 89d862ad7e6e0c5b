"""The command line: exit states, errors that teach, the shape of the JSON."""

from __future__ import annotations

import importlib.metadata
import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from mechproof.__main__ import EXTRA
from mechproof.cli import app
from mechproof.verification import judge_derivations

FIELDS = {
    "system", "number", "kind", "verdict", "rung", "marks",
    "printed_latex", "read_as", "compared_with", "on", "singular", "reason", "evidence",
    "corrected_latex",
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
    (row,) = json.loads(target.read_text(encoding="utf-8"))["rows"]
    assert row.keys() == FIELDS
    assert (row["system"], row["number"], row["kind"]) == ("mine", "(1)", "equation")
    assert (row["verdict"], row["read_as"], row["marks"]) == ("PROVED", "", ["as typed"])
    assert "\nprinted equations: 1 PROVED\n" in result.output


@pytest.mark.parametrize(("reason", "status"), [("", 1), (', stays_open="no gamma rung"', 0)])
def test_an_open_row_must_say_why(tmp_path: Path, reason: str, status: int) -> None:
    result = run("verify", str(write(tmp_path, PROVED, OPEN % reason)))
    assert result.exit_code == status, result.output
    assert "1 UNDECIDED" in result.output


@pytest.mark.parametrize(
    ("text", "place", "message"),
    [
        ("PAPER = 1", "", "binds no mechproof.record.Paper"),
        ("\nimport nowhere", ":2", "No module named 'nowhere'"),
        (f"{HEAD}\nPAPER = paper({PROVED}, {PROVED})", ":7", "row numbers given twice"),
    ],
)
def test_a_derivation_that_fails_is_named(
    tmp_path: Path, text: str, place: str, message: str
) -> None:
    file = tmp_path / "broken.py"
    file.write_text(text, encoding="utf-8")
    result = run("verify", str(file))
    assert result.exit_code == 1
    assert re.search(rf"{re.escape(str(file))}{place}: ", result.output)
    assert message in result.output


@pytest.mark.parametrize(
    "arguments",
    [
        ["verify", "no_such_system"],
        ["verify", "missing.py"],
        ["verify", "elliptic_planetary", "--json", "no/such/folder/rows.json"],
        ["verify", "elliptic_planetary", "--json", "."],
        ["verify", "--no-such-option"],
        ["verify", "--derivations", "no/such/folder"],
        ["verify", "--derivations", "derivations", "--root", "."],
        ["regenerate", "--root", "no/such/folder"],
        ["regenerate", "--derivations", "no/such/folder"],
        ["measure", "--root", "no/such/folder"],
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
    assert f"mechproof regenerate --root {tmp_path}" in result.output


def test_regenerate_says_what_it_wrote_and_removed(tmp_path: Path) -> None:
    (tmp_path / "papers").mkdir()
    write(tmp_path / "papers", PROVED)
    folder = ("--derivations", str(tmp_path / "papers"))
    run("regenerate", *folder)
    target = tmp_path / "generated"
    (target / "old.py").write_text((target / "__init__.py").read_text(encoding="utf-8"))
    (target / "notes.txt").write_text("mine")
    (target / "LEDGER.md").unlink()
    check = run("regenerate", *folder, "--check")
    assert (check.exit_code, "notes.txt" in check.output) == (1, False)
    result = run("regenerate", *folder)
    assert result.exit_code == 0, result.output
    assert "removed old.py\n" in result.output
    assert "wrote LEDGER.md\n" in result.output
    assert "1 written, 1 removed" in result.output
    assert (target / "notes.txt").read_text() == "mine"
    assert not (target / "old.py").exists()


def test_a_file_in_the_way_is_named(tmp_path: Path) -> None:
    (tmp_path / "derivations").mkdir()
    write(tmp_path / "derivations", PROVED)
    (tmp_path / "generated").mkdir()
    (tmp_path / "generated" / "__init__.py").write_text("made_by = 'hand'\n")
    result = run("regenerate", "--root", str(tmp_path))
    assert result.exit_code == 1
    assert "__init__.py: is to be generated" in result.output


def test_two_papers_of_one_name_are_an_error(tmp_path: Path) -> None:
    text = write(tmp_path, PROVED).read_text(encoding="utf-8")
    (tmp_path / "other.py").write_text(text, encoding="utf-8")
    for command in ("verify", "regenerate"):
        result = run(command, "--derivations", str(tmp_path))
        assert result.exit_code == 1
        assert "other.py: its paper has the name 'mine'" in result.output


def test_verify_takes_the_folder_that_is_named_then_the_one_here_then_the_package(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name, row in (("derivations", PROVED), ("others", PROVED.replace("(1)", "(9)"))):
        (tmp_path / name).mkdir()
        write(tmp_path / name, row)
    monkeypatch.chdir(tmp_path)
    assert re.search(r"^\(1\) \(as typed\) +PROVED", run("verify", "--all").output, re.MULTILINE)
    mine = run("verify", "mine", "--all").output
    assert re.search(r"^\(1\) \(as typed\) +PROVED", mine, re.MULTILINE)
    named = run("verify", "--all", "--derivations", "others")
    assert re.search(r"^\(9\) \(as typed\) +PROVED", named.output, re.MULTILINE)
    monkeypatch.chdir(tmp_path / "others")
    refused = run("verify", "no_such_system")
    assert refused.exit_code == 2
    assert "elliptic_planetary" in refused.output


def test_the_rule_stands_in_the_help() -> None:
    for arguments in (["--help"], ["verify", "--help"], ["regenerate", "--help"]):
        assert "else those that come with the package" in " ".join(run(*arguments).output.split())


def test_a_folder_is_a_derivation(tmp_path: Path) -> None:
    text = write(tmp_path, PROVED).read_text(encoding="utf-8")
    (tmp_path / "large").mkdir()
    (tmp_path / "large" / "paper.py").write_text(text, encoding="utf-8")
    (tmp_path / "large" / "__init__.py").write_text("from .paper import PAPER\n")
    result = run("verify", str(tmp_path / "large"))
    assert result.exit_code == 0, result.output


def test_standing_in_the_folder_of_derivations(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "derivations").mkdir()
    write(tmp_path / "derivations", PROVED)
    monkeypatch.chdir(tmp_path / "derivations")
    assert run("regenerate", "--derivations", ".").exit_code == 0
    assert (tmp_path / "generated" / "ledger.json").is_file()


def test_a_row_that_crashes_is_an_error_and_no_verdict(tmp_path: Path) -> None:
    row = PROVED.replace("S.One)", "S.One), note=Fatal('n')")
    act = "os._exit(3) if os.getpid() != HERE else None"
    head = f"import os\nHERE = os.getpid()\nclass Fatal(str):\n    def __bool__(self): {act}\n"
    file = write(tmp_path, row)
    file.write_text(head + file.read_text(encoding="utf-8"), encoding="utf-8")
    result = run("verify", str(file), "--json", str(tmp_path / "rows.json"))
    assert result.exit_code == 1
    assert "mine.py: row (1): its process ended with status 3" in result.output
    assert "PROVED" not in result.output
    assert not (tmp_path / "rows.json").exists()


def in_process(*arguments: str, **variables: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "mechproof", *arguments]
    environment = {**os.environ, **variables}
    return subprocess.run(command, capture_output=True, text=True, env=environment)


def test_the_module_runs_and_tells_its_version() -> None:
    done = in_process("--version")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == f"mechproof {importlib.metadata.version('mechproof')}\n"


def test_piped_text_is_full(tmp_path: Path) -> None:
    note = "a note that is longer than any terminal is wide, " * 8
    file = write(tmp_path, PROVED.replace("S.One)", f"S.One), note={note!r}"))
    done = in_process("verify", "--all", str(file), COLUMNS="60")
    assert done.returncode == 0, done.stderr
    assert "\u2026" not in done.stdout
    (line,) = [line for line in done.stdout.splitlines() if line.startswith("(1)")]
    assert line.startswith("(1) (as typed)  PROVED")
    assert note.rstrip() in line
    assert line.endswith("trigonometric field")


@pytest.mark.parametrize(
    "variables", [{"PYTHONIOENCODING": "ascii"}, {"LC_ALL": "C", "PYTHONUTF8": "0"}]
)
def test_what_the_encoding_cannot_hold_is_replaced(
    tmp_path: Path, variables: dict[str, str]
) -> None:
    file = write(tmp_path, PROVED, 'Equation("(\u03c6)", "x", Equality(x, y))')
    target = tmp_path / "rows.json"
    done = in_process("verify", str(file), "--json", str(target), **variables)
    assert done.returncode == 0, done.stderr
    assert "Traceback" not in done.stderr
    assert [row["number"] for row in json.loads(target.read_bytes())["rows"]] == ["(1)", "(\u03c6)"]


def test_json_is_written_before_anything_is_printed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*arguments: object) -> None:
        raise OSError("no terminal")

    monkeypatch.setattr("mechproof.cli.commands.print_ledgers", fail)
    target = tmp_path / "rows.json"
    run("verify", str(write(tmp_path, PROVED)), "--json", str(target))
    assert len(json.loads(target.read_bytes())["rows"]) == 1


def test_a_plain_install_is_told_what_it_lacks(tmp_path: Path) -> None:
    """Missing packages are stood in for by a finder that does not find them."""
    code = (
        "import sys, runpy, importlib.machinery as m; find = m.PathFinder.find_spec\n"
        "gone = ('sympy', 'typer', 'rich')\n"
        "m.PathFinder.find_spec = classmethod(lambda cls, name, *rest: None if "
        "name.partition('.')[0] in gone else find(name, *rest))\n"
        "sys.argv = ['mechproof', 'verify']; runpy.run_module('mechproof', run_name='__main__')"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == (
        "mechproof needs rich, sympy, typer, the extra derive: in the folder of the sources, "
        "pip install '.[derive]'\n"
    )


def test_the_check_names_what_the_extra_installs() -> None:
    homes = importlib.metadata.packages_distributions()
    required = {
        re.match(r"[\w.-]+", requirement)[0]  # type: ignore[index]
        for requirement in importlib.metadata.requires("mechproof") or ()
        if re.search(r"extra == .derive.", requirement)
    }
    # The formatter has a program and a module that no list of packages names.
    assert {homes[name][0].lower() for name in EXTRA if name != "ruff"} == required - {"ruff"}


def test_brackets_in_names_are_shown_as_they_are(tmp_path: Path) -> None:
    file = write(tmp_path, PROVED)
    file.write_text(file.read_text(encoding="utf-8").replace('"my notes"', '"notes [/x] [red]"'))
    result = run("verify", str(file))
    assert result.exit_code == 0, result.output
    assert "notes [/x] [red]" in result.output


def test_findings_come_first_and_what_is_plain_is_counted(tmp_path: Path) -> None:
    wrong = 'Equation("(3)", "3", Equality(sin(x), cos(x)))'
    file = write(tmp_path, PROVED, wrong)
    lines = run("verify", str(file)).output.splitlines()
    starts = ["Finding in mine: (3): REFUTED", "mine: my notes", "(3) (as typed)  REFUTED"]
    places = [next(n for n, line in enumerate(lines) if line.startswith(s)) for s in starts]
    assert places == sorted(places)
    assert not any(line.startswith("(1)") for line in lines)
    assert lines[-3:] == [
        "1 paper, 2 rows, 1 finding",
        "1 row proved or defining not shown: --all shows every row",
        "What verdicts and marks mean: docs/verdicts.md of the sources, or the start page of "
        "`mechproof report`",
    ]
    shown = run("verify", "--all", str(file)).output
    assert re.search(r"^\(1\) \(as typed\) +PROVED", shown, re.MULTILINE)
    assert "not shown" not in shown


@pytest.mark.parametrize("derivations", [None, (), ("mine.py",)])
def test_without_a_command_it_says_what_can_be_done_here(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, derivations: tuple[str, ...] | None
) -> None:
    if derivations is not None:
        (tmp_path / "derivations").mkdir()
        for _ in derivations:
            write(tmp_path / "derivations", PROVED)
    monkeypatch.chdir(tmp_path)
    result = run()
    assert result.exit_code == 0
    assert ("elliptic_planetary" in result.output) == (derivations is None)
    assert ("mechproof verify mine" in result.output) == bool(derivations)
    assert ("regenerate" in result.output) == (derivations is not None)
    for line in re.findall(r"^  mechproof (\S+)", result.output, re.MULTILINE):
        assert run(line, "--help").exit_code == 0


def test_progress_counts_the_rows_of_each_paper(tmp_path: Path) -> None:
    said: list[str] = []
    file = write(tmp_path, PROVED, OPEN % "")
    judge_derivations([file], use_cache=False, processes=1, report=said.append)
    assert said == [f"loading {file}", "mine 1 of 2", "all rows judged"]


def test_a_parameter_given_twice_is_named(tmp_path: Path) -> None:
    sizes = ("--let", "e=0.475", "--let", "R1=66", "--let", "R2=16", "--let", "e=0.3")
    tailored = ("emit", "c", "elliptic_planetary.position", "--error", "1e-6")
    result = run(*tailored, *sizes, "--out", str(tmp_path))
    assert result.exit_code == 2
    assert "--let e: given twice" in result.output
    assert not any(tmp_path.iterdir())


def test_a_single_quantity_is_told_to_need_an_error(tmp_path: Path) -> None:
    result = run("emit", "c", "elliptic_planetary.position", "--out", str(tmp_path))
    assert result.exit_code == 2
    assert "a single quantity needs --error, and --let" in result.output
