"""The command `verify`: what it reads and shows, the shape of its JSON, and rows that fail."""

from __future__ import annotations

import json
import re
import signal
import time
from pathlib import Path

import pytest
from command import HEAD, OPEN, PROVED, in_process, run, write
from weights import first_of

from mechproof.derivation import DerivationError, stop_after
from mechproof.pipeline.verification import judge_derivations

FIELDS = {
    "id",
    "cites", "quantities",
    "system", "number", "kind", "verdict", "rung", "marks",
    "print", "paraphrase", "read_as", "compared_with", "on", "singular", "reason", "evidence",
    "corrected_latex",
}  # fmt: skip


def test_rows_have_the_stated_fields(tmp_path: Path) -> None:
    target = tmp_path / "rows.json"
    result = run("verify", str(write(tmp_path, PROVED)), "--json", str(target))
    assert result.exit_code == 0, result.output
    (row,) = json.loads(target.read_text(encoding="utf-8"))["rows"]
    assert row.keys() == FIELDS
    assert (row["system"], row["number"], row["kind"]) == ("mine", "(1)", "equation")
    assert (row["verdict"], row["read_as"], row["marks"]) == ("PROVED", "", ["as typed"])
    assert "\nverdict  printed equations\nPROVED   1\n" in result.output


def test_an_open_row_is_status_1(tmp_path: Path) -> None:
    result = run("verify", str(write(tmp_path, PROVED, OPEN)))
    assert result.exit_code == 1, result.output
    assert re.search(r"^\(2\) \(as typed\) +UNDECIDED  \w", result.output, re.MULTILINE)
    assert re.search(r"^UNDECIDED +1$", result.output, re.MULTILINE)


@pytest.mark.parametrize(("outcome", "status"), [("refuted", 0), ("undecided,proved", 1)])
def test_other_outcomes_may_fail(tmp_path: Path, outcome: str, status: int) -> None:
    result = run("verify", str(write(tmp_path, PROVED, OPEN)), "--fail-on", outcome)
    assert result.exit_code == status, result.output


@pytest.mark.parametrize(
    ("text", "place", "message"),
    [
        ("PAPER = 1", "", "must bind a mechproof.record.Paper"),
        ("\nimport nowhere", ":2", "No module named 'nowhere'"),
        ("import os\nos._exit(0)", ":2", "SystemExit: os._exit(0)"),
        ("import sys\nsys.exit(0)", ":2", "SystemExit: 0"),
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


@pytest.mark.slow
@pytest.mark.parametrize("loop", ["while True: pass", "import time; time.sleep(600)"])
def test_a_derivation_that_loops_is_stopped_by_the_limit(tmp_path: Path, loop: str) -> None:
    file = tmp_path / "loops.py"
    file.write_text(loop, encoding="utf-8")
    for command in ("verify", "report"):
        out = ("--out", str(tmp_path / "out")) if command == "report" else ()
        result = run(command, str(file), "--limit", "1", *out)
        assert result.exit_code == 1
        assert f"{file}: did not load within 1 s\n" in result.output


def test_an_interrupt_of_the_user_stays_one(tmp_path: Path) -> None:
    # Background jobs of a shell ignore interrupts.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt), stop_after(60.0, tmp_path):
            signal.raise_signal(signal.SIGINT)
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        with stop_after(60.0, tmp_path):
            signal.raise_signal(signal.SIGINT)
        late = pytest.raises(DerivationError, match=r"did not load within 0\.1 s")
        with late, stop_after(0.1, tmp_path):
            time.sleep(60)
        assert signal.getsignal(signal.SIGINT) is signal.SIG_IGN
    finally:
        signal.signal(signal.SIGINT, before)


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


def test_a_folder_is_a_derivation(tmp_path: Path) -> None:
    text = write(tmp_path, PROVED).read_text(encoding="utf-8")
    (tmp_path / "large").mkdir()
    (tmp_path / "large" / "paper.py").write_text(text, encoding="utf-8")
    (tmp_path / "large" / "__init__.py").write_text("from .paper import PAPER\n")
    result = run("verify", str(tmp_path / "large"))
    assert result.exit_code == 0, result.output


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


def test_a_run_that_fails_leaves_no_rows_of_an_earlier_one(tmp_path: Path) -> None:
    target = tmp_path / "rows.json"
    file = write(tmp_path, PROVED)
    for text, status in ((None, 0), ("PAPER = 1", 1)):
        if text:
            file.write_text(text, encoding="utf-8")
        assert run("verify", str(file), "--json", str(target)).exit_code == status
        assert target.exists() is (status == 0)


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full")
def test_a_full_disk_is_a_sentence(tmp_path: Path) -> None:
    result = run("verify", str(write(tmp_path, PROVED)), "--json", "/dev/full")
    assert (result.exit_code, Path("/dev/full").exists()) == (1, True)
    assert "--json /dev/full: No space left on device\n" in result.output


@pytest.mark.slow
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


@pytest.mark.slow
@pytest.mark.parametrize(
    "variables", first_of([{"PYTHONIOENCODING": "ascii"}, {"LC_ALL": "C", "PYTHONUTF8": "0"}])
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


def test_brackets_in_names_are_shown_as_they_are(tmp_path: Path) -> None:
    file = write(tmp_path, PROVED)
    file.write_text(file.read_text(encoding="utf-8").replace('"my notes"', '"notes [/x] [red]"'))
    result = run("verify", "--all", str(file))
    assert result.exit_code == 0, result.output
    assert "notes [/x] [red]" in result.output


WRONG = 'Equation("(3)", "\\\\sin x=3", Equality(sin(x), cos(x)))'


def test_a_run_ends_in_a_line_for_each_finding_and_the_totals(tmp_path: Path) -> None:
    file = write(tmp_path, PROVED, WRONG)
    lines = run("verify", str(file)).output.splitlines()
    finding = next(n for n, line in enumerate(lines) if line.startswith("mine (3)"))
    assert re.fullmatch(r"mine \(3\)  REFUTED  at x = .*: printed .*, rebuilt .*", lines[finding])
    assert lines[finding + 1 :] == [
        "",
        "verdict  printed equations",
        "PROVED   1",
        "REFUTED  1",
        "",
        "1 paper, 2 rows, 1 finding",
        "--findings shows what is right, and why; --all shows every row, with its evidence",
        "What verdicts and marks mean: docs/verdicts.md of the sources, or the start page of "
        "`mechproof report`",
    ]


def test_cards_and_rows_are_shown_when_asked_for(tmp_path: Path) -> None:
    file = write(tmp_path, PROVED, WRONG)
    cards = run("verify", "--findings", str(file)).output
    labels = ("mine (3): REFUTED (as typed): changes a", "  printed   ", "  why ", "  costs ")
    places = [cards.index(label) for label in labels]
    assert places == sorted(places)
    assert not re.search(r"^\(1\)", cards, re.MULTILINE)
    shown = run("verify", "--all", str(file)).output
    assert re.search(r"^\(1\) \(as typed\) +PROVED", shown, re.MULTILINE)
    assert "  why " not in shown


def test_what_a_mend_changes_is_marked(tmp_path: Path) -> None:
    says = "Equality(1 - sin(x)**2/2, cos(x)**2)"
    right = r'Correction(r"1-\sin^2x", Equality(1 - sin(x)**2, cos(x)**2))'
    row = rf'Equation("(4)", r"1-\frac{{\sin^2x}}2", {says}, corrected={right})'
    output = run("verify", "--findings", str(write(tmp_path, row))).output
    assert r"printed   1-[-\frac{-]\sin^{2}x[-}{2}-]" in output
    assert r"right     1-\sin^{2}x   (proved: " in output


def test_progress_counts_the_rows_of_each_paper(tmp_path: Path) -> None:
    said: list[str] = []
    file = write(tmp_path, PROVED, OPEN)
    judge_derivations([file], use_cache=False, processes=1, report=said.append)
    assert said == [f"loading {file}", "mine 1 of 2", "all rows judged"]
