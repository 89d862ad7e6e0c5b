"""Every rung that occurs has an explanation, which appears once in the ledger's table."""

from __future__ import annotations

from pathlib import Path

import pytest
from twins import judge

from mechproof.document.constraints.consequences import MULTIPLE
from mechproof.proof import (
    angle_differences,
    any_functions,
    binomial_squares,
    continuity,
    convergence,
    descents,
    endless_sums,
    floors,
    fraction_sums,
    induction,
    inequalities,
    integral_recurrences,
    integrals,
    integrand_signs,
    inverses,
    known_integrals,
    limits,
    monotonicity,
    newton,
    powers,
    single_variable,
    telescoping,
    wave_sums,
)
from mechproof.proof.equation_ladder import IDENTICAL
from mechproof.proof.exact_values import RECOMPUTATION, SEPARATION
from mechproof.proof.ladder import UNCOMPARED
from mechproof.proof.rungs import RUNGS, name_rungs
from mechproof.proof.verdict import Verdict

ROOT = Path(__file__).parents[2]
EXPECTED = [
    line.split("\t")[2]
    for file in sorted((ROOT / "tests" / "expected").glob("*.tsv"))
    for line in file.read_text(encoding="utf-8").splitlines()
]
NAMED = [continuity.RUNG, inverses.ARGUMENTS, single_variable.BISECTION, RECOMPUTATION, IDENTICAL]
NAMED += [
    MULTIPLE,
    single_variable.NEAR_ZERO,
    integrals.RUNG,
    integral_recurrences.RUNG,
    powers.RUNG,
    induction.RUNG,
    induction.OF_INEQUALITIES,
    wave_sums.RUNG,
    wave_sums.BINOMIALS,
    wave_sums.FOURIER,
    fraction_sums.RUNG,
    descents.RUNG,
    UNCOMPARED,
    limits.FROM_SIDES,
    newton.RUNG,
    inverses.INVERSE,
    inverses.TURNS,
    inverses.LOGARITHMS,
    inverses.ROOT,
    integrand_signs.RUNG,
    inequalities.SQUARES,
    inequalities.HALF_ANGLES,
    inequalities.ORDERS,
    inequalities.GAPS,
    inequalities.VALUES,
    monotonicity.RUNG,
    binomial_squares.RUNG,
    telescoping.RUNG,
    SEPARATION,
    endless_sums.PARTIAL_SUMS,
    endless_sums.KNOWN_SERIES,
    known_integrals.RUNG,
    integral_recurrences.DERIVATIVES,
    any_functions.RUNG,
    floors.RUNG,
    convergence.RUNG,
    inequalities.SIGNS,
    inequalities.MEAN_VALUE,
    angle_differences.RUNG,
]


def test_every_rung_that_occurs_is_explained() -> None:
    assert set(name_rungs([*EXPECTED, *NAMED, "none", "enclosure"])) == set(RUNGS)


def list_documented() -> list[list[str]]:
    """List the rows of the table of examples: kind of statement, print, domain, rung."""
    page = (ROOT / "docs" / "verdicts.md").read_text(encoding="utf-8")
    table = page.split("| statements |")[1].split("\n\n")[0]
    lines = (line.strip("| ").split(" |") for line in table.splitlines()[2:])
    return [[cell.replace("`", "").strip() for cell in line] for line in lines]


@pytest.mark.slow
@pytest.mark.parametrize(("kind", "printed", "where", "rung"), list_documented())
def test_what_is_documented_is_proved_by_the_rung(
    kind: str, printed: str, where: str, rung: str
) -> None:
    verdict, named = judge(printed, where)
    assert verdict is Verdict.PROVED, kind
    assert rung in named
    assert set(name_rungs([rung])) <= set(RUNGS)


def test_a_rung_without_an_explanation_is_refused() -> None:
    with pytest.raises(KeyError, match="guesswork"):
        name_rungs(["identical, guesswork"])


def test_the_ledger_explains_each_rung_once() -> None:
    page = (ROOT / "generated" / "LEDGER.md").read_text(encoding="utf-8")
    table = page.split("\n## Rungs\n")[1]
    for name in name_rungs(EXPECTED):
        assert table.count(f"\n| {name} | ") == 1
