"""Scripts of rows: one for each that is proved or refuted, in the order of the ledger."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from mechproof import row_scripts
from mechproof.row_scripts import WITHOUT_ROW, write_row_scripts
from mechproof.verification import judge_derivations

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


def test_a_row_at_which_it_fails_is_named(place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (ledger,) = judge_derivations([place], use_cache=False)

    def fail(*given: object) -> None:
        raise RuntimeError("no words")

    monkeypatch.setattr(row_scripts, "write_row_script", fail)
    with pytest.raises(ValueError, match=r"mine: \(\d\): RuntimeError: no words"):
        write_row_scripts({place: ledger})
