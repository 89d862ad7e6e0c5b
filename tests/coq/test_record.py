"""The record of what Coq accepts matches the current ledger and the current libraries."""

from __future__ import annotations

import json
from html import escape
from pathlib import Path

from mechproof.coq.folder import (
    CERTIFIABLE,
    PAGE,
    RECORD,
    Coverage,
    RowScript,
    read_checks,
    write_page,
)
from mechproof.coq.scripts import digest_libraries
from mechproof.ledger.judged import MARKDOWN

GENERATED = Path(__file__).parents[2] / "generated"
RECORDED = json.loads((GENERATED / RECORD).read_text(encoding="utf-8"))
ROWS = json.loads((GENERATED / "ledger.json").read_text(encoding="utf-8"))["rows"]


def test_every_row_that_is_proved_or_refuted_is_recorded_once() -> None:
    certifiable = [row["id"] for row in ROWS if row["verdict"] in CERTIFIABLE]
    assert [row["id"] for row in RECORDED["rows"]] == certifiable


def test_the_record_is_of_these_libraries() -> None:
    assert RECORDED["libraries"] == digest_libraries()


def test_a_row_has_a_file_that_is_accepted_or_a_reason() -> None:
    for row in RECORDED["rows"]:
        assert bool(row["withheld"]) or (row["file"] and row["sha256"])


def test_the_page_says_what_is_recorded() -> None:
    page = (GENERATED / PAGE).read_text(encoding="utf-8")
    accepted = [row for row in RECORDED["rows"] if not row["withheld"]]
    rows = len(RECORDED["rows"])
    assert f"{len(accepted)} of {rows} rows ({len(accepted) / rows:.1%}) are accepted" in page
    for row in RECORDED["rows"]:
        told = f"withheld: {row['withheld']}" if row["withheld"] else f"`{row['file']}`"
        assert f"[{row['id']}](LEDGER.md#{row['id']})" in page
        assert told in page


def test_the_ledger_says_of_every_row_what_is_recorded() -> None:
    lines = (GENERATED / "LEDGER.md").read_text(encoding="utf-8").splitlines()
    checks = read_checks(GENERATED)
    assert list(checks) == [row["id"] for row in RECORDED["rows"]]
    for name, told in checks.items():
        (line,) = (line for line in lines if line.startswith(f'| <a id="{escape(name)}"></a>'))
        assert line.endswith(f"| {told.translate(MARKDOWN)} |")


def test_where_coq_stopped_is_not_told_beside_a_row() -> None:
    told = set(read_checks(GENERATED).values())
    assert "not checked: Coq refuses the proof that was written for it" in told
    assert not [text for text in told if "Coq: line" in text]


def test_a_script_that_is_refused_or_differs_is_lost() -> None:
    certificates = [
        RowScript(
            *(f"mine/{name}", "PROVED", "identical, radicals", "ours", f"{name}.v", text),
            is_alike=name != "new",
        )
        for name, text in (("same", "a"), ("changed", "b"), ("refused", "c"), ("new", "d"))
    ]
    known = {c.id: c.digest for c in certificates[:3]} | {"mine/changed": "other"}
    faults = {c.file: "" for c in certificates} | {"refused.v": "Coq: line 1: no"}
    coverage = Coverage("8.16", tuple(certificates), faults)
    assert coverage.find_lost(known) == [
        "mine/changed: its script differs from the recorded one",
        "mine/refused: Coq: line 1: no",
    ]
    assert coverage.count() == "3 of 4 rows (75.0%) are accepted by Coq 8.16, 2 of them A = A"
    page = write_page(coverage)
    assert page.count("| 3 | 2 | 1 |") == len(["ours", "identical", "radicals"])
    assert "| `same.v`, A = A |" in page
    assert "| `new.v` |" in page
    partly = Coverage("8.16", tuple(certificates), {"same.v": ""})
    assert partly.count() == (
        "1 of 4 rows (25.0%) are accepted by Coq 8.16, 1 of them A = A, "
        "3 are not checked in this run"
    )
