"""Judging papers in processes: the same ledger in the same order, however rows are spread."""

from __future__ import annotations

import multiprocessing
from pathlib import Path

import pytest

from mechproof.derivation import DerivationError, load_paper
from mechproof.pipeline.verification import VerificationError, judge_derivations
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Verdict

TEXT = """
from pathlib import Path
from sympy import S, cos, sin, symbols
from mechproof.record import *
from ._shared import CITATION
x, y = symbols("x y", real=True)
VARIABLES = (Variable(x, "a number"), Variable(y, "another"))
ROWS = tuple(
    Equation(f"({n})", str(n), Equality((x + y)**n, ((x + y)**n).expand() + int(n == 3)))
    for n in range(1, 6)
)
PAPER = Paper("mine", CITATION, VARIABLES, ROWS)
"""
STARTS = [s for s in ("fork", "spawn") if s in multiprocessing.get_all_start_methods()]


@pytest.fixture
def file(tmp_path: Path) -> Path:
    (tmp_path / "_shared.py").write_text('CITATION = "my notes"\n')
    (tmp_path / "mine.py").write_text(TEXT, encoding="utf-8")
    return tmp_path / "mine.py"


@pytest.mark.slow
@pytest.mark.parametrize("start", STARTS)
def test_processes_change_nothing(file: Path, start: str) -> None:
    (ledger,) = judge_derivations([file], use_cache=False, processes=3, start=start)
    alone = load_paper(file)
    assert list(ledger.judgements) == [judge(row, alone) for row in alone.rows]
    assert ledger.paper.citation == "my notes"
    verdicts = [j.verdict for j in ledger.judgements]
    assert verdicts == [Verdict.REFUTED if n == 3 else Verdict.PROVED for n in range(1, 6)]


@pytest.mark.slow
def test_a_derivation_that_changes_while_it_is_judged_is_an_error(file: Path) -> None:
    """Each process that reads the file finds different rows."""
    count = "READ = Path(__file__).with_name('read')\nREAD.open('a').write('x')\n"
    text = TEXT.replace("ROWS =", f"{count}ROWS =").replace(
        'f"({n})"', 'f"({n}, {READ.read_text()})"'
    )
    file.write_text(text, encoding="utf-8")
    with pytest.raises(VerificationError, match=r"mine\.py: changed while it was judged"):
        judge_derivations([file], use_cache=False, processes=1, start="spawn")


def test_what_the_forms_refuse_is_charged_to_the_derivation(
    file: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(paper: object) -> None:
        raise NotImplementedError("no such rewrite")

    monkeypatch.setattr("mechproof.pipeline.opening.form_rows", refuse)
    with pytest.raises(DerivationError, match=r"mine\.py: no such rewrite"):
        judge_derivations([file])


def test_a_row_that_is_wrongly_stated_has_no_judgement_and_holds_nothing_up(file: Path) -> None:
    text = TEXT.replace("int(n == 3)", 'symbols(f"z{n}") * int(n == 3)')
    file.write_text(text, encoding="utf-8")
    (ledger,) = judge_derivations([file], use_cache=False)
    assert [j.verdict for j in ledger.judgements] == [Verdict.PROVED] * 4
    (failure,) = ledger.failures
    assert failure == (
        f"{file}: row (3): RecordError: rebuilt: z3 is not a declared symbol of the paper"
    )
