"""Statements in LaTeX beside false twins: one must be proved by a rung, the other not accepted."""

from __future__ import annotations

from collections.abc import Mapping

from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

# What is printed, a twin that is slightly wrong, and where both are meant.
Twins = tuple[str, str, str]
ACCEPTED = {Verdict.PROVED, Verdict.CONDITIONAL, Verdict.CONVENTION, Verdict.DEFINITION}


def judge(latex: str, where: str = "") -> tuple[Verdict, str]:
    """Return the verdict on one printed statement, and its rung."""
    stated = tuple(filter(None, where.split(", ")))
    (judgement,) = judge_pasted(Pasted(latex, where=stated)).judgements
    return judgement.verdict, judgement.rung


def list_rows(tables: Mapping[str, tuple[Twins, ...]]) -> list[tuple[str, str, str, str]]:
    """List the rows of tables, each of which is of one rung."""
    return [(rung, *twins) for rung, table in tables.items() for twins in table]


def check_twins(rung: str, printed: str, twin: str, where: str) -> None:
    """Assert that the rung proves what is printed, and that no rung accepts the twin."""
    verdict, named = judge(printed, where)
    assert verdict is Verdict.PROVED
    assert rung in named.split(", ")
    assert judge(twin, where)[0] not in ACCEPTED
