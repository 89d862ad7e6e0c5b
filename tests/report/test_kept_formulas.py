"""Formulas are written once, and again after the code that writes them has changed."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from mechproof.report import mathml
from mechproof.report.mathml import KeptFormulas
from mechproof.tools.cache import VARIABLE, Store


@pytest.fixture
def written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    monkeypatch.setenv(VARIABLE, str(tmp_path))
    return []


def run(written: list[str], *formulas: str, display: str = "inline") -> list[str]:
    """Write formulas as a separate run would; add those missing from the store to `written`."""

    def write(latex: str, how: str) -> str:
        written.append(latex)
        return f"<{how}>{latex}"

    known = KeptFormulas(Store("formulas.json"))
    found = [known.find(latex, display, write) for latex in formulas]
    known.keep()
    return found


def test_a_formula_is_written_once(written: list[str]) -> None:
    assert run(written, "x", "y", "x") == ["<inline>x", "<inline>y", "<inline>x"]
    assert run(written, "y", "z") == ["<inline>y", "<inline>z"]
    assert written == ["x", "y", "z"]
    assert run(written, "x", display="block") == ["<block>x"]


def test_another_writer_writes_anew(
    written: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run(written, "x")
    other = tmp_path / "mathml.py"
    other.write_text("another", encoding="utf-8")
    monkeypatch.setattr(mathml, "WRITERS", (other,))
    run(written, "x")
    assert written == ["x", "x"]


def test_what_is_damaged_is_written_anew(written: list[str], tmp_path: Path) -> None:
    run(written, "x")
    file = tmp_path / "formulas.json"
    file.write_text(json.dumps(dict.fromkeys(json.loads(file.read_bytes()), 1)), encoding="utf-8")
    assert run(written, "x") == ["<inline>x"]
    assert written == ["x", "x"]


def test_no_more_than_so_many_are_kept(
    written: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(mathml, "MOST_KEPT", 2)
    run(written, "x", "y", "z")
    assert len(json.loads((tmp_path / "formulas.json").read_bytes())) == 2
    run(written, "y", "z")
    assert written == ["x", "y", "z"]
