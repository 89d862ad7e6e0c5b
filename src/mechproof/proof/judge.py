"""One row of a paper -> its line of the ledger, with correction, readings and conditions."""

from __future__ import annotations

from dataclasses import dataclass, replace

import sympy as sp

from mechproof.proof.dimensions import dimensions_of
from mechproof.proof.domain import Domain
from mechproof.proof.ladder import ContradictionError, decide
from mechproof.proof.verdict import Decision, Evidence, Judgement, Verdict
from mechproof.proof.wellformed import find_faults
from mechproof.record import Paper, Part, Row, Statement

AS_TYPED = "as typed"


@dataclass(frozen=True)
class _Outcome:
    decision: Decision
    corrected_by: str = ""


def judge(row: Row, paper: Paper) -> Judgement:
    """Return the line of the ledger for one row.

    A statement that no rung can read (an unknown function, a wrong record) is UNDECIDED and says
    why; only a contradiction within the ladder itself is raised.
    """
    try:
        outcome = _with_correction(row, paper, _decide_row(row, paper))
    except ContradictionError:
        raise
    except Exception as error:
        reason = f"{type(error).__name__}: {error}"
        outcome = _Outcome(Decision(Verdict.UNDECIDED, "none", reason))
    decision = outcome.decision
    reason = f"{decision.reason}. {row.note}" if row.note else decision.reason
    return Judgement(
        system=paper.system,
        number=row.number,
        kind=row.kind,
        verdict=decision.verdict,
        rung=decision.rung,
        marks=_marks(row),
        printed_latex=row.printed_latex,
        read_as=row.read_as,
        reason=reason,
        evidence=decision.evidence,
        corrected_latex=row.corrected.latex if row.corrected else "",
        corrected_by=outcome.corrected_by,
        may_stay_open=bool(row.stays_open),
    )


def _marks(row: Row) -> tuple[str, ...]:
    """Add to the marks that a printed row was not read from its print."""
    return row.marks if row.read_as or "ours" in row.marks else (*row.marks, AS_TYPED)


def _decide_row(row: Row, paper: Paper) -> Decision:
    domain = Domain.of(paper, row.on)
    decision = _decide_well_formed(row.statement, paper, domain)
    if decision.verdict is Verdict.REFUTED:
        convention = _find_convention(row, paper, domain, decision)
        return convention or _find_part(row, paper, decision)
    if decision.verdict is Verdict.UNDECIDED and row.stays_open:
        return replace(decision, reason=f"{decision.reason}; {row.stays_open}")
    return decision


def _decide_well_formed(says: Statement, paper: Paper, domain: Domain) -> Decision:
    faults = find_faults(says, dimensions_of(paper), domain)
    if not faults:
        return decide(says, domain)
    rungs = dict.fromkeys(fault.rung for fault in faults)
    reason = "; ".join(fault.reason for fault in faults)
    evidence = tuple(fault.evidence for fault in faults)
    return Decision(Verdict.ILL_FORMED, ", ".join(rungs), reason, evidence)


def _find_convention(row: Row, paper: Paper, domain: Domain, literal: Decision) -> Decision | None:
    """Return CONVENTION if another stated reading is proved."""
    for reading in row.readings:
        other = _decide_well_formed(reading.says, paper, domain)
        if other.verdict is Verdict.PROVED:
            shown = literal.evidence or (Evidence(literal.reason),)
            as_printed = tuple(replace(e, what=f"read literally: {e.what}") for e in shown)
            as_meant = Evidence(f"read as: {reading.text}: PROVED ({other.rung})")
            reason = f"true when read as: {reading.text}"
            return Decision(Verdict.CONVENTION, other.rung, reason, (*as_printed, as_meant))
    return None


def _find_part(row: Row, paper: Paper, refuted: Decision) -> Decision:
    """Return CONDITIONAL if the statement is proved on the stated part of the domain."""
    if row.holds_on is None or not _has_interior(row.holds_on):
        return refuted
    inside = decide(row.statement, Domain.of(paper, row.holds_on))
    if inside.verdict is not Verdict.PROVED:
        return refuted
    where = Evidence(f"{row.holds_on.text}: PROVED ({inside.rung})")
    outside = tuple(replace(item, what=f"elsewhere: {item.what}") for item in refuted.evidence)
    reason = f"true for {row.holds_on.text}, not on the whole domain"
    return Decision(Verdict.CONDITIONAL, inside.rung, reason, (where, *outside))


def _has_interior(part: Part) -> bool:
    open_sets = all(not isinstance(s, sp.FiniteSet) for s in part.within.values())
    return open_sets and not any(isinstance(r, sp.Equality) for r in part.where)


def _with_correction(row: Row, paper: Paper, decision: Decision) -> _Outcome:
    """Prove the corrected form; a correction that is not proved leaves the row open."""
    if row.corrected is None or decision.verdict is Verdict.PROVED:
        return _Outcome(decision)
    proof = _decide_well_formed(row.corrected.statement, paper, Domain.of(paper, row.on))
    if proof.verdict is Verdict.PROVED:
        evidence = (*decision.evidence, Evidence(f"corrected form: PROVED ({proof.rung})"))
        return _Outcome(replace(decision, evidence=evidence), proof.rung)
    reason = f"{decision.reason}; the corrected form is {proof.verdict}: {proof.reason}"
    return _Outcome(replace(decision, verdict=Verdict.UNDECIDED, reason=reason))
