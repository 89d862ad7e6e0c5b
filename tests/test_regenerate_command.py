"""The command that writes a user's kernels and ledgers, and what stops it."""

from __future__ import annotations

from pathlib import Path

import pytest
from command import PROVED, run, write
from weights import first_of

from mechproof.codegen.regenerate import LIST
from mechproof.tools.made import Made


def test_regenerate_writes_a_users_own_folder(tmp_path: Path) -> None:
    (tmp_path / "derivations").mkdir()
    write(tmp_path / "derivations", PROVED)
    assert run("regenerate", "--root", str(tmp_path), "--check").exit_code == 1
    assert run("regenerate", "--root", str(tmp_path)).exit_code == 0
    assert run("regenerate", "--root", str(tmp_path), "--check").exit_code == 0
    (tmp_path / "generated" / "LEDGER.md").unlink()
    result = run("regenerate", "--root", str(tmp_path), "--check")
    assert result.exit_code == 1
    assert f"mechproof regenerate --root {tmp_path}" in result.output


@pytest.mark.parametrize(
    "name", first_of(["LEDGER.md", "ledger.json", "__init__.py", "forms/__init__.py"])
)
def test_what_was_edited_is_shown_and_kept(tmp_path: Path, name: str) -> None:
    (tmp_path / "derivations").mkdir()
    write(tmp_path / "derivations", PROVED)
    run("regenerate", "--root", str(tmp_path))
    file = tmp_path / "generated" / name
    file.write_text("edited\n", encoding="utf-8")
    for options, said in (((), "move it away or delete it"), (("--check",), f"different: {name}")):
        result = run("regenerate", "--root", str(tmp_path), *options)
        assert result.exit_code == 1
        assert said in result.output
    assert file.read_text(encoding="utf-8") == "edited\n"
    file.unlink()
    assert run("regenerate", "--root", str(tmp_path)).exit_code == 0


def test_regenerate_says_what_it_wrote_and_removed(tmp_path: Path) -> None:
    (tmp_path / "papers").mkdir()
    write(tmp_path / "papers", PROVED)
    folder = ("--derivations", str(tmp_path / "papers"))
    run("regenerate", *folder)
    target = tmp_path / "generated"
    listed = Made(target, LIST)
    listed.update({"old.py": "x = 1\n"}, and_remove=False)
    (target / "copy.py").write_text((target / "__init__.py").read_text(encoding="utf-8"))
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
    assert (target / "copy.py").is_file()
    assert not (target / "old.py").exists()


def test_a_file_in_the_way_is_named(tmp_path: Path) -> None:
    (tmp_path / "derivations").mkdir()
    write(tmp_path / "derivations", PROVED)
    (tmp_path / "generated").mkdir()
    (tmp_path / "generated" / "__init__.py").write_text("made_by = 'hand'\n")
    result = run("regenerate", "--root", str(tmp_path))
    assert result.exit_code == 1
    assert "__init__.py: not overwritten, since not made" in result.output


def test_a_place_that_cannot_be_written_to_is_a_sentence(tmp_path: Path) -> None:
    (tmp_path / "derivations").mkdir()
    write(tmp_path / "derivations", PROVED)
    (tmp_path / "generated").write_text("mine")
    result = run("regenerate", "--root", str(tmp_path))
    assert (result.exit_code, type(result.exception)) == (1, SystemExit)
    assert "File exists: " in result.output


def test_two_papers_of_one_name_are_an_error(tmp_path: Path) -> None:
    text = write(tmp_path, PROVED).read_text(encoding="utf-8")
    (tmp_path / "other.py").write_text(text, encoding="utf-8")
    for command in ("verify", "regenerate"):
        result = run(command, "--derivations", str(tmp_path))
        assert result.exit_code == 1
        assert "other.py: its paper has the same name" in result.output


def test_standing_in_the_folder_of_derivations(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "derivations").mkdir()
    write(tmp_path / "derivations", PROVED)
    monkeypatch.chdir(tmp_path / "derivations")
    assert run("regenerate", "--derivations", ".").exit_code == 0
    assert (tmp_path / "generated" / "ledger.json").is_file()
