"""The pipeline called as a library: its stages in order, and faults, which write nothing."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from command import OPEN, PROVED, write

from mechproof.codegen.regenerate import LIST
from mechproof.pipeline import stages
from mechproof.pipeline.judging import PipelineError
from mechproof.pipeline.stages import ValidationError, regenerate


def test_the_stages_run_in_their_order(tmp_path: Path) -> None:
    told: list[str] = []

    @contextmanager
    def progress(title: str) -> Iterator[Callable[[str], None]]:
        told.append(f"begin {title}")
        yield told.append
        told.append(f"end {title}")

    done = regenerate([write(tmp_path, PROVED)], tmp_path / "generated", progress=progress)
    stages = ("judging mine", "bounding the rounding errors")
    stages += ("running the emitted kernels",)
    ends = [text for text in told if text.startswith(("begin ", "end "))]
    assert ends == [f"{end} {stage}" for stage in stages for end in ("begin", "end")]
    assert "all rows judged" in told[: told.index(f"end {stages[0]}")]
    assert [change.name for change in done.changes] == sorted(done.files)
    for name, text in done.files.items():
        assert (tmp_path / "generated" / name).read_text(encoding="utf-8") == text


def test_what_would_change_is_returned_and_not_written(tmp_path: Path) -> None:
    paper, generated = write(tmp_path, PROVED), tmp_path / "generated"
    first = regenerate([paper], generated, check=True)
    assert not generated.exists()
    changes = regenerate([paper], generated).changes
    assert changes == tuple(change for change in first.changes if change.name != LIST)
    again = regenerate([paper], generated)
    assert (again.files, again.changes) == (first.files, ())
    (generated / "LEDGER.md").unlink()
    (change,) = regenerate([paper], generated, check=True).changes
    assert change in first.changes


def refuse(*arguments: object, **named: object) -> None:
    raise ValueError("a fault")


def invalidate(*arguments: object, **named: object) -> None:
    raise ValidationError("another value")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("stage", "fault", "said"),
    [
        ("certify_derivations", refuse, "^a fault$"),
        ("render_package", refuse, ": a fault$"),
        ("read_records", refuse, "^a fault$"),
        ("validate_derivations", invalidate, "^another value$"),
    ],
)
def test_a_fault_of_any_stage_writes_nothing(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    stage: str,
    fault: Callable[..., None],
    said: str,
) -> None:
    monkeypatch.setattr(stages, stage, fault)
    with pytest.raises(PipelineError, match=said):
        regenerate([write(tmp_path, PROVED)], tmp_path / "generated")
    assert not (tmp_path / "generated").exists()


@pytest.mark.parametrize(
    ("text", "said"),
    [("1 / 0", r"mine\.py:\d+: ZeroDivisionError"), ("PAPER = None", "must bind a")],
)
def test_a_derivation_that_fails_is_named(tmp_path: Path, text: str, said: str) -> None:
    (tmp_path / "mine.py").write_text(text, encoding="utf-8")
    with pytest.raises(PipelineError, match=said):
        regenerate([tmp_path / "mine.py"], tmp_path / "generated")
    assert not (tmp_path / "generated").exists()


def test_what_is_in_the_way_is_named_and_kept(tmp_path: Path) -> None:
    generated = tmp_path / "generated"
    generated.mkdir()
    (generated / "ledger.json").write_text("mine")
    with pytest.raises(PipelineError, match=r"ledger\.json: not overwritten, since"):
        regenerate([write(tmp_path, PROVED, OPEN)], generated)
    assert [(path.name, path.read_text()) for path in generated.iterdir()] == [
        ("ledger.json", "mine")
    ]


def test_no_derivation_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="locations: must have at least one"):
        regenerate([], tmp_path)
