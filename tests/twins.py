"""Statements in LaTeX with false twins: a rung must prove the one, none may accept the other."""

from __future__ import annotations

from collections.abc import Mapping

from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

# A print, a slightly wrong twin, and the conditions stated for both.
Twins = tuple[str, str, str]
ACCEPTED = {Verdict.PROVED, Verdict.CONDITIONAL, Verdict.CONVENTION, Verdict.DEFINITION}


def judge(latex: str, where: str = "") -> tuple[Verdict, str]:
    """Return the verdict on one printed statement, and its rung."""
    stated = tuple(filter(None, where.split(", ")))
    (judgement,) = judge_pasted(Pasted(latex, where=stated)).judgements
    return judgement.verdict, judgement.rung


def list_rows(tables: Mapping[str, tuple[Twins, ...]]) -> list[tuple[str, str, str, str]]:
    """List the twins of all tables, each preceded by the rung of its table."""
    return [(rung, *twins) for rung, table in tables.items() for twins in table]


def check_twins(rung: str, printed: str, twin: str, where: str) -> None:
    """Assert that the rung proves the print, and that no rung accepts the twin."""
    verdict, named = judge(printed, where)
    assert verdict is Verdict.PROVED
    assert rung in named.split(", ")
    assert judge(twin, where)[0] not in ACCEPTED
