"""Every rung that occurs has an explanation, and stands in the ledger's table once."""

from __future__ import annotations

from pathlib import Path

import pytest

from mechproof.document.consequences import MULTIPLE
from mechproof.proof import (
    antiderivative,
    bisection,
    induction,
    integrals,
    newton,
    powers,
    printed_number,
    taylor,
    vector_angles,
)
from mechproof.proof.ladder import IDENTICAL, UNCOMPARED
from mechproof.proof.rungs import RUNGS, name_rungs

ROOT = Path(__file__).parents[2]
EXPECTED = [
    line.split("\t")[2]
    for file in sorted((ROOT / "tests" / "expected").glob("*.tsv"))
    for line in file.read_text(encoding="utf-8").splitlines()
]
NAMED = [antiderivative.RUNG, vector_angles.RUNG, bisection.RUNG, printed_number.RUNG, IDENTICAL]
NAMED += [
    MULTIPLE,
    taylor.RUNG,
    integrals.RUNG,
    powers.RUNG,
    induction.RUNG,
    UNCOMPARED,
    newton.RUNG,
]


def test_every_rung_that_occurs_is_explained() -> None:
    assert set(name_rungs([*EXPECTED, *NAMED, "none", "enclosure"])) == set(RUNGS)


def test_a_rung_without_an_explanation_is_refused() -> None:
    with pytest.raises(KeyError, match="guesswork"):
        name_rungs(["identical, guesswork"])


def test_the_ledger_explains_each_rung_once() -> None:
    page = (ROOT / "generated" / "LEDGER.md").read_text(encoding="utf-8")
    table = page.split("\n## Rungs\n")[1]
    for name in name_rungs(EXPECTED):
        assert table.count(f"\n| {name} | ") == 1
