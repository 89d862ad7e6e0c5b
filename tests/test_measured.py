from __future__ import annotations

import json
import os
from dataclasses import replace
from math import inf, nan
from pathlib import Path
from typing import Any

import pytest

from mechproof.measured import (
    Cell,
    CellErrors,
    Machine,
    MeasuredTailoring,
    MeasuredWay,
    Record,
    Searched,
    SetErrors,
    Timing,
    find_files,
    read_record,
    round_off,
    round_up,
    write_record,
)

RECORD = Record(
    quantity="gear.angle",
    unit="rad",
    taken="2026-01-01T00:00:00+00:00",
    quick=False,
    machine=Machine("a processor", None, ("V3",), "Linux", "3.11", {"numpy": "2.0"}),
    load=0.5,
    seeds={"tune": 1, "report": 2},
    scale="|value|, µm",
    bound=None,
    typical=None,
    ranges={"phi": (0.0, inf)},
    searched=(Searched("kernel", 1.5, 10, (0.1, (-0.0, 5e-324), ((1.0,), (2.0,)))),),
    ufuncs={"sin": 1.25},
    ways=(
        MeasuredWay("kernel", "kernel", "PROVED", "a rung"),
        MeasuredWay("inf", "peer", note='"quoted"\n'),
    ),
    sets=(
        SetErrors("generic", "kernel", 9, 0, 0, 0, 0, 1.5, 0.5, 0.25, 1e-16, None, (0.1, inf)),
        SetErrors("generic", "inf", 9, 0, 1, 2, 3, inf, inf, 64.0, inf, inf),
    ),
    cells=(Cell({"phi": (0.0, inf)}, 9, 1),),
    cell_errors=(CellErrors(0, "kernel", 1e-16, None, 0), CellErrors(0, "inf", inf, 1e-3, 2)),
    tailored=(MeasuredTailoring("t", "N angles", 1e-3, 9e-4, {"e": 0.5}, (-1.0, 2.0), (7, 9)),),
    times=(Timing("N angles", "kernel", 1000, 3, 20.0, 19.0, 21.5, None),),
)


def written(folder: Path) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((folder / "gear.angle.json").read_text(encoding="utf-8"))
    return found


def test_everything_survives_the_file(tmp_path: Path) -> None:
    again = read_record(write_record(RECORD, tmp_path / "new"))
    # repr also compares types and the signs of zeros.
    assert repr(again) == repr(RECORD)


def test_nan_survives_the_file(tmp_path: Path) -> None:
    undecided = replace(RECORD.sets[0], worst_ulp=nan, worst_absolute=-inf)
    again = read_record(write_record(replace(RECORD, sets=(undecided,)), tmp_path))
    assert repr(again.sets[0]) == repr(undecided)


def test_the_file_is_strict_json_with_a_line_for_each_row(tmp_path: Path) -> None:
    def refuse(name: str) -> None:
        raise AssertionError(name)

    text = write_record(RECORD, tmp_path).read_text(encoding="utf-8")
    json.loads(text, parse_constant=refuse)
    slower = replace(RECORD, times=(replace(RECORD.times[0], median=22.0),))
    other = write_record(slower, tmp_path).read_text(encoding="utf-8")
    pairs = zip(text.splitlines(), other.splitlines(), strict=True)
    assert [a for a, b in pairs if a != b] == ['["N angles","kernel",1000,3,20.0,19.0,21.5,null]']


def test_an_interrupted_write_leaves_the_old_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = write_record(RECORD, tmp_path)

    def stop(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "replace", stop)
    with pytest.raises(KeyboardInterrupt):
        write_record(replace(RECORD, unit="mm"), tmp_path)
    assert read_record(file) == RECORD
    assert find_files(tmp_path) == {"gear.angle": file}


def drop(found: dict[str, Any]) -> None:
    del found["unit"]


def add(found: dict[str, Any]) -> None:
    found["colour"] = "red"


def rename(found: dict[str, Any]) -> None:
    found["times"]["columns"][0] = "load"


def shorten(found: dict[str, Any]) -> None:
    found["times"]["rows"][0].pop()


def prove_a_peer(found: dict[str, Any]) -> None:
    found["ways"]["rows"][1][2] = "PROVED"


def spell(found: dict[str, Any]) -> None:
    found["times"]["rows"][0][4] = "fast"


def miscount(found: dict[str, Any]) -> None:
    found["sets"]["rows"][0][2] = 9.5


def flatten(found: dict[str, Any]) -> None:
    found["cells"] = []


@pytest.mark.parametrize(
    ("spoil", "says"),
    [
        (drop, r"missing in a Record: unit$"),
        (add, r"unknown in a Record: colour$"),
        (rename, r"times, row 0: unknown in a Timing: load$"),
        (shorten, r"times, row 0: 7 of 8 columns$"),
        (prove_a_peer, r"ways, row 1: way 'inf': a peer is MEASURED, not PROVED$"),
        (spell, r"times, row 0: median: 'fast' is not of type float$"),
        (miscount, r"sets, row 0: points: 9.5 is not of type int$"),
        (flatten, r"cells: a table must have columns and rows$"),
    ],
)
def test_what_is_no_record_is_refused(tmp_path: Path, spoil: Any, says: str) -> None:
    file = write_record(RECORD, tmp_path)
    found = written(tmp_path)
    spoil(found)
    file.write_text(json.dumps(found), encoding="utf-8")
    with pytest.raises(ValueError, match=rf"gear\.angle\.json: {says}"):
        read_record(file)


@pytest.mark.parametrize(
    ("text", "says"), [("[1, 2", r"not JSON: Expecting"), ("[1, 2]", r"is not of type Record")]
)
def test_what_is_no_json_is_refused(tmp_path: Path, text: str, says: str) -> None:
    file = tmp_path / "gear.angle.json"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(ValueError, match=rf"gear\.angle\.json: .*{says}"):
        read_record(file)


def test_errors_are_rounded_up_and_times_to_the_nearest() -> None:
    assert [round_up(x) for x in (0.1, 1.00001, 9.9999, -1.00001, 0.0, inf)] == [
        0.1, 1.001, 10.0, -1.001, 0.0, inf,
    ]  # fmt: skip
    assert round_up(5e-324) >= 5e-324
    assert [round_off(x) for x in (12.345, 0.99951, 1e7)] == [12.3, 1.0, 1e7]


def test_every_record_of_the_package_is_read() -> None:
    records = {name: read_record(file) for name, file in find_files().items()}
    assert len(records) > 30
    for name, record in records.items():
        assert record.quantity == name
        known = {way.name for way in record.ways}
        assert {errors.way for errors in record.sets} <= known
        assert {errors.way for errors in record.cell_errors} <= known
