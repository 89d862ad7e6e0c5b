"""Reasons: the text that says what was not shown, and several parts' answers joined into one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy as sp

from mechproof.proof import newton
from mechproof.proof.definedness import InnerNeed, describe
from mechproof.proof.refutation import Comparison
from mechproof.proof.verdict import Answer, Verdict
from mechproof.proof.witness_text import LONGEST, clip
from mechproof.record import Slack
from mechproof.record.relations import find_slack
from mechproof.statement_domains.domain import Domain

WORST_FIRST = [Verdict.REFUTED, Verdict.UNDECIDED, Verdict.ENCLOSED, *Verdict]


def join_answers(failed: Mapping[str, Answer], rung: str = "") -> Answer:
    """Return the worst verdict among the failed parts, with every part's reason and evidence."""
    named = sorted(failed.items(), key=lambda item: WORST_FIRST.index(item[1].verdict))
    reason = "; ".join(f"{name}: {answer.reason}" for name, answer in named)
    worst = named[0][1]
    if len(named) == 1:
        return replace(worst, rung=rung or worst.rung, reason=reason)
    evidence = [replace(e, what=f"{name}: {e.what}") for name, a in named for e in a.evidence]
    rung = rung or join_rungs([a.rung for _, a in named if a.verdict is worst.verdict])
    return replace(worst, rung=rung, reason=reason, evidence=tuple(evidence))


def describe_inside(needs: Sequence[Sequence[InnerNeed]]) -> str:
    """State the unproved conditions of terms of sums and of integrands."""
    told = dict.fromkeys(need.describe() for listed in needs for need in listed)
    return clip(f"it is true where {' and '.join(told)}, which is not shown")


def describe_needs(needs: Sequence[list[Slack]]) -> str:
    """State the unproved conditions of roots, logarithms and so on, or "" if there are none."""
    told = " and ".join(dict.fromkeys(describe(need) for listed in needs for need in listed))
    return told if len(told) <= LONGEST else "every root and logarithm has a real value"


def report_unproved(comparison: Comparison, why: str) -> Answer:
    """Return the answer if no point separates the sides: ENCLOSED if every point was decided."""
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
    """Name the sign that is not shown, or the failed step of a proof by Newton's method."""
    if told := newton.explain(relation, domain):
        return told
    slack = find_slack(relation)
    return clip(f"{f'the sign of {slack.value}' if slack else relation} is not shown")


def count_parts(number: int) -> str:
    """Write that all of a number of parts are meant: "both" or "all 3"."""
    return "both" if number == 2 else f"all {number}"


def join_rungs(rungs: list[str]) -> str:
    """Join the rungs' names, each of them once."""
    return ", ".join(dict.fromkeys(rungs))
