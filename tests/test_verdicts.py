"""The expected verdict and rung of every row of every paper.

The derivations hold no verdict: it is what the ladder returns, and the tables in
`tests/expected` (number, verdict, rung) hold it to that.
"""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

import pytest

from mechproof.codegen.forms import form_rows
from mechproof.derivation import find_systems, load_paper, packaged_directory
from mechproof.proof.ledger import judge_paper
from mechproof.proof.verdict import Judgement, Verdict

EXPECTED = Path(__file__).parent / "expected"
SYSTEMS = find_systems(packaged_directory())

# Each paper is judged once, by one worker.
for_each_system = pytest.mark.parametrize(
    "system", [pytest.param(s, marks=pytest.mark.xdist_group(f"verdicts {s}")) for s in SYSTEMS]
)


@lru_cache
def judge_all(system: str) -> tuple[Judgement, ...]:
    paper = load_paper(SYSTEMS[system])
    return tuple(judge_paper(paper, form_rows(paper)))


def with_verdict(system: str, *verdicts: Verdict) -> list[Judgement]:
    return [j for j in judge_all(system) if j.verdict in verdicts]


def test_every_system_has_a_table() -> None:
    assert {file.stem for file in EXPECTED.glob("*.tsv")} == set(SYSTEMS)


@for_each_system
def test_every_row_has_its_verdict_and_rung(system: str) -> None:
    lines = (EXPECTED / f"{system}.tsv").read_text(encoding="utf-8").splitlines()
    found = ["\t".join((j.number, j.verdict.value, j.rung)) for j in judge_all(system)]
    assert found == lines


@for_each_system
def test_nothing_is_left_open(system: str) -> None:
    assert with_verdict(system, Verdict.UNDECIDED, Verdict.ENCLOSED) == []


@for_each_system
def test_forms_proved_in_the_derivation_are_proved(system: str) -> None:
    verdicts = {j.number: j.verdict for j in judge_all(system)}
    named = [q.form.proved_by for q in load_paper(SYSTEMS[system]).quantities if q.form.proved_by]
    assert [row for row in named if verdicts[row] is not Verdict.PROVED] == []


@for_each_system
def test_what_is_wrong_comes_with_a_proved_correction(system: str) -> None:
    wrong = with_verdict(system, Verdict.REFUTED, Verdict.ILL_FORMED)
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
