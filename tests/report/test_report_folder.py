"""A report replaces what the last one made, and nothing else."""

from __future__ import annotations

from pathlib import Path

import pytest

from mechproof.report.site import LIST, check_folder, write_folder
from mechproof.tools.made import STAGED, ForeignFileError

FILES = {"index.html": "one", "papers/a.html": "a", "papers/b.html": "b"}


def list_all(folder: Path) -> set[str]:
    return {str(f.relative_to(folder)) for f in folder.rglob("*") if f.is_file()}


def test_a_new_report_replaces_the_old_one(tmp_path: Path) -> None:
    folder = tmp_path / "deep" / "report"
    write_folder(folder, FILES)
    assert list_all(folder) == {*FILES, LIST}
    (folder / "papers" / "note.txt").write_text("mine")
    write_folder(folder, {"index.html": "two"})
    assert list_all(folder) == {"index.html", LIST, "papers/note.txt"}
    assert (folder / "index.html").read_text() == "two"


def test_empty_folders_of_the_last_report_go(tmp_path: Path) -> None:
    write_folder(tmp_path, FILES)
    write_folder(tmp_path, {"index.html": "two"})
    assert not (tmp_path / "papers").exists()


def test_a_folder_that_holds_something_else_is_refused(tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").write_text("mine")
    for call in (lambda: check_folder(tmp_path), lambda: write_folder(tmp_path, FILES)):
        with pytest.raises(ForeignFileError, match="is not a mechproof report"):
            call()
    assert list_all(tmp_path) == {"thesis.tex"}


def test_a_file_is_no_folder(tmp_path: Path) -> None:
    file = tmp_path / "report"
    file.write_text("mine")
    with pytest.raises(ForeignFileError, match="is a file"):
        check_folder(file)


def test_a_file_in_the_way_is_kept(tmp_path: Path) -> None:
    write_folder(tmp_path, {"index.html": "one"})
    (tmp_path / "papers").mkdir()
    (tmp_path / "papers" / "a.html").write_text("mine")
    with pytest.raises(ForeignFileError, match=r"a\.html: .* not made"):
        write_folder(tmp_path, FILES)
    assert (tmp_path / "index.html").read_text() == "one"


def test_a_list_that_is_none_is_refused_before_anything_is_judged(tmp_path: Path) -> None:
    (tmp_path / LIST).write_text("mine")
    with pytest.raises(ForeignFileError, match="is not a list"):
        check_folder(tmp_path)


def test_a_first_report_that_was_killed_can_be_written_again(tmp_path: Path) -> None:
    (tmp_path / STAGED).mkdir()
    (tmp_path / STAGED / "index.html").write_text("half")
    write_folder(tmp_path, FILES)
    assert list_all(tmp_path) == {*FILES, LIST}


def test_a_page_that_was_edited_is_kept(tmp_path: Path) -> None:
    write_folder(tmp_path, FILES)
    (tmp_path / "index.html").write_text("mine")
    with pytest.raises(ForeignFileError, match=r"index\.html: .* edited since"):
        write_folder(tmp_path, {"index.html": "two"})
    assert (tmp_path / "index.html").read_text() == "mine"
