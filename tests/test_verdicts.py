"""The expected verdict and rung of every row of every paper.

The derivations contain no verdicts: the ladder returns them, and the tables in `tests/expected`
(number, verdict, rung) pin them down.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from derived import judge_all, paper_of
from quantities import KERNELS

from mechproof.derivation import find_systems, packaged_directory
from mechproof.proof.verdict import Judgement, Verdict

EXPECTED = Path(__file__).parent / "expected"
SYSTEMS = find_systems(packaged_directory())

# Each paper is judged once, by one worker.
for_each_system = pytest.mark.parametrize(
    "system", [pytest.param(s, marks=pytest.mark.xdist_group(f"verdicts {s}")) for s in SYSTEMS]
)


def with_verdict(system: str, *verdicts: Verdict) -> list[Judgement]:
    return [j for j in judge_all(system).values() if j.verdict in verdicts]


def test_every_system_has_a_table() -> None:
    assert {file.stem for file in EXPECTED.glob("*.tsv")} == set(SYSTEMS)


@pytest.mark.slow
@for_each_system
def test_every_row_has_its_verdict_and_rung(system: str) -> None:
    lines = (EXPECTED / f"{system}.tsv").read_text(encoding="utf-8").splitlines()
    found = ["\t".join((j.number, j.verdict.value, j.rung)) for j in judge_all(system).values()]
    assert found == lines


@for_each_system
def test_nothing_is_left_open(system: str) -> None:
    assert with_verdict(system, Verdict.UNDECIDED, Verdict.ENCLOSED) == []


def of_forms(system: str) -> list[Judgement]:
    """Return the rows of forms; the correction of a wrong one is the kernel itself."""
    return [j for j in judge_all(system).values() if j.number.startswith("kernel ")]


@for_each_system
def test_every_kernel_and_every_rewrite_is_proved(system: str) -> None:
    shipped = {name.removeprefix(f"{system}.") for name in KERNELS}
    for j in of_forms(system):
        name = j.number.removeprefix("kernel ").split(",")[0]
        if name in shipped or j.number.endswith(", legal"):
            assert j.verdict is Verdict.PROVED, j.number


@for_each_system
def test_every_form_says_that_its_source_was_read_back(system: str) -> None:
    forms = [j for j in of_forms(system) if not j.number.endswith(", legal")]
    assert [j.number for j in forms if "Read back from the source" not in j.reason] == []


@for_each_system
def test_what_is_wrong_comes_with_a_proved_correction(system: str) -> None:
    forms = of_forms(system)
    wrong = [j for j in with_verdict(system, Verdict.REFUTED, Verdict.ILL_FORMED) if j not in forms]
    assert [j.number for j in wrong if not (j.corrected_latex and j.corrected_by)] == []


@for_each_system
def test_what_is_refuted_shows_both_balls(system: str) -> None:
    shown = {
        j.number: any(item.printed and item.rebuilt for item in j.evidence)
        for j in with_verdict(system, Verdict.REFUTED, Verdict.CONDITIONAL)
    }
    assert [number for number, both in shown.items() if not both] == []


@for_each_system
def test_what_is_ill_formed_shows_its_witness(system: str) -> None:
    for j in with_verdict(system, Verdict.ILL_FORMED):
        assert j.evidence[0].what, j.number


@for_each_system
def test_a_convention_shows_both_readings(system: str) -> None:
    for j in with_verdict(system, Verdict.CONVENTION):
        texts = [item.what for item in j.evidence]
        assert any(text.startswith("read literally") for text in texts), j.number
        assert any(text.startswith("read as") for text in texts), j.number


@for_each_system
def test_missing_data_show_two_completions_with_opposite_answers(system: str) -> None:
    for j in with_verdict(system, Verdict.UNDERDETERMINED):
        texts = [item.what for item in j.evidence]
        assert len(texts) == 2, j.number
        assert sorted(": PROVED" in text for text in texts) == [False, True], j.number
        assert sorted(": REFUTED" in text for text in texts) == [False, True], j.number


@for_each_system
def test_what_is_wrong_in_print_has_a_stated_cause(system: str) -> None:
    findings = paper_of(system).findings
    caused = {f.row for f in findings} | {row.row for f in findings for row in f.followers}
    wrong = with_verdict(system, Verdict.REFUTED, Verdict.ILL_FORMED)
    assert [j.number for j in wrong if "ours" not in j.marks and j.number not in caused] == []
