"""Reasons: what an answer says of what was not shown, and the answers of several parts as one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy as sp

from mechproof.proof import newton
from mechproof.proof.definedness import InnerNeed, tell
from mechproof.proof.refutation import Comparison
from mechproof.proof.verdict import Answer, Verdict
from mechproof.proof.witness_text import LONGEST, clip
from mechproof.record import Slack
from mechproof.record.relations import find_slack
from mechproof.statement_domains.domain import Domain

WORST_FIRST = [Verdict.REFUTED, Verdict.UNDECIDED, Verdict.ENCLOSED, *Verdict]


def join_answers(failed: Mapping[str, Answer], rung: str = "") -> Answer:
    """Return the worst verdict of parts that fail, with what is said of each of them."""
    named = sorted(failed.items(), key=lambda item: WORST_FIRST.index(item[1].verdict))
    reason = "; ".join(f"{name}: {answer.reason}" for name, answer in named)
    worst = named[0][1]
    if len(named) == 1:
        return replace(worst, rung=rung or worst.rung, reason=reason)
    evidence = [replace(e, what=f"{name}: {e.what}") for name, a in named for e in a.evidence]
    rung = rung or join_rungs([a.rung for _, a in named if a.verdict is worst.verdict])
    return replace(worst, rung=rung, reason=reason, evidence=tuple(evidence))


def tell_inside(needs: Sequence[Sequence[InnerNeed]]) -> str:
    """Say what terms of sums and integrands need that is not shown."""
    told = dict.fromkeys(need.tell() for listed in needs for need in listed)
    return clip(f"it is true where {' and '.join(told)}, which is not shown")


def tell_needs(needs: Sequence[list[Slack]]) -> str:
    """Say what roots, logarithms and so on need that is not shown, empty for nothing."""
    told = " and ".join(dict.fromkeys(tell(need) for listed in needs for need in listed))
    return told if len(told) <= LONGEST else "every root and logarithm has a real value"


def report_unproved(comparison: Comparison, why: str) -> Answer:
    """Answer for sides that points do not tell apart: ENCLOSED if all of them could be decided."""
    agreeing, undecided = comparison.agreeing, comparison.undecided
    told = [clip(why)]
    if agreeing:
        points = "1 exact point" if agreeing == 1 else f"{agreeing} exact points"
        within = f" within {comparison.widest}" if comparison.widest else ""
        told.append(f"both sides agree{within} at {points}")
    if undecided:
        points = f"at {undecided} of the exact points " if agreeing or undecided > 1 else ""
        told.append(f"{points}a side could not be enclosed closely enough")
    verdict = Verdict.ENCLOSED if agreeing and not undecided else Verdict.UNDECIDED
    return Answer(verdict, "enclosure", "; ".join(told))


def explain_relation(relation: sp.Basic, domain: Domain) -> str:
    """Name the sign that is not shown, or what of a root is not."""
    if told := newton.explain(relation, domain):
        return told
    slack = find_slack(relation)
    return clip(f"{f'the sign of {slack.value}' if slack else relation} is not shown")


def count_parts(number: int) -> str:
    """Say of how many parts something holds."""
    return "both" if number == 2 else f"all {number}"


def join_rungs(rungs: list[str]) -> str:
    """Name each of the rungs once."""
    return ", ".join(dict.fromkeys(rungs))
