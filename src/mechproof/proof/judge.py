"""One row of a paper -> its line of the ledger, with correction, readings and conditions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import sympy as sp

from mechproof.proof.cases import narrow
from mechproof.proof.comparison_latex import write_compared
from mechproof.proof.count_zeros import describe_division_by_zero
from mechproof.proof.equation_ladder import ContradictionError
from mechproof.proof.ladder import decide
from mechproof.proof.reasons import join_rungs
from mechproof.proof.refutation import refuse_empty
from mechproof.proof.statement_checks import check_restatements, check_statement
from mechproof.proof.verdict import OPEN, Answer, Evidence, Judgement, Verdict
from mechproof.proof.wellformed import find_faults
from mechproof.record import Paper, Part, RecordError, Row, Statement
from mechproof.record.estimates import without_estimates
from mechproof.statement_domains.dimension_inference import dimensions_of
from mechproof.statement_domains.domain import Domain
from mechproof.statement_domains.set_values import COUNTS

AS_TYPED = "as typed"
# What SymPy's errors mean to a reader of a paper.
_TOLD: Mapping[type[Exception], str] = {
    RecursionError: "it is nested too deeply",
    ZeroDivisionError: "a part of it divides by zero",
    OverflowError: "a number in it is too large",
    MemoryError: "it needs more memory than is available",
}
_WITHOUT_RULE = (
    "SymPy has no rule for a part of it; judge its parts separately, or at values of its letters"
)


@without_estimates()
def judge(row: Row, paper: Paper) -> Judgement:
    """Return the line of the ledger for one row.

    A statement that no rung can read (an unknown function) is UNDECIDED, with the reason. Raises
    `RecordError` for errors that are not the paper's, and `ContradictionError`.
    """
    try:
        answer = _with_correction(row, paper, _decide_row(row, paper))
    except (ContradictionError, RecordError):
        raise
    except Exception as error:
        answer = Answer(Verdict.UNDECIDED, "none", _explain(error))
    on = row.on.text if row.on else ""
    is_charged = row.corrected is not None and answer.verdict is not Verdict.PROVED
    where = [f"where {on}"] if on else []
    where += [f"singular at {', '.join(row.singular)}"] if row.singular else []
    reason = "; ".join([answer.reason, *where])
    reason = f"{reason}. {row.note}" if row.note else reason
    return Judgement(
        system=paper.system,
        number=row.number,
        kind=row.kind,
        verdict=answer.verdict,
        rung=answer.rung,
        # A row that was typed in rather than read from its print says so.
        marks=row.marks if row.read_as or "ours" in row.marks else (*row.marks, AS_TYPED),
        printed_latex=row.printed_latex,
        read_as=row.read_as,
        on=on,
        singular=row.singular,
        reason=reason,
        evidence=answer.evidence,
        corrected_latex=row.corrected.latex if row.corrected and is_charged else "",
        corrected_by=answer.corrected_by,
        compared_with=write_compared(row.statement, paper.variables),
        cites=row.cites,
        quantities=row.quantities,
    )


def _explain(error: Exception) -> str:
    """Return why a row was refused: our own messages as they are, others explained here."""
    told = str(error)
    if isinstance(error, NotImplementedError) and told and "\n" not in told:
        return told
    known = (words for kind, words in _TOLD.items() if isinstance(error, kind))
    return f"it cannot be worked out: {next(known, _WITHOUT_RULE)}"


def _decide_row(row: Row, paper: Paper) -> Answer:
    domain = Domain.of(paper, row.on)
    refuse_empty(domain)
    check_restatements(row, domain)
    answer = _decide_well_formed(row, paper, domain)
    if answer.verdict is Verdict.REFUTED:
        convention = _find_convention(row, paper, domain, answer)
        return convention or _find_part(row, paper, answer)
    return answer


def _decide_well_formed(row: Row, paper: Paper, domain: Domain) -> Answer:
    says, known = row.statement, dimensions_of(paper)
    mended = row.corrected is not None
    check_statement(says, known, domain, mended=mended)
    faults = find_faults(says, known, domain, mended=mended)
    if not faults:
        answer = _decide_where_it_divides(row, domain)
        undefined = answer.verdict is Verdict.PROVED and describe_division_by_zero(
            row.divisors, domain
        )
        return replace(answer, verdict=Verdict.UNDECIDED, reason=undefined) if undefined else answer
    rungs = join_rungs([fault.rung for fault in faults])
    reason = "; ".join(fault.reason for fault in faults)
    evidence = tuple(item for fault in faults for item in fault.evidence)
    return Answer(Verdict.ILL_FORMED, rungs, reason, evidence)


def _decide_where_it_divides(row: Row, domain: Domain) -> Answer:
    """Decide a row's statement; where a divisor that cancels is zero, it claims nothing."""
    answer = decide(row.statement, domain)
    if not row.divisors or answer.verdict is not Verdict.REFUTED:
        return answer
    part: Domain | None = domain
    for divisor in row.divisors:
        part = part and narrow(part, sp.Ne(divisor, 0))
    if part is None:
        return Answer(Verdict.UNDECIDED, "none", "it divides by zero for all values of its letters")
    return decide(row.statement, part)


def _decide_ours(says: Statement, paper: Paper, domain: Domain) -> Answer:
    """Decide a statement of our own that replaces the print."""
    check_statement(says, dimensions_of(paper), domain, printed=False)
    return decide(says, domain)


def _find_convention(row: Row, paper: Paper, domain: Domain, literal: Answer) -> Answer | None:
    """Return CONVENTION if another reading is proved; an undecided reading leaves the row open."""
    left_open = None
    for reading in row.readings:
        other = _decide_ours(reading.says, paper, domain)
        if other.verdict is Verdict.PROVED:
            shown = literal.evidence or (Evidence(literal.reason),)
            as_printed = tuple(replace(e, what=f"read literally: {e.what}") for e in shown)
            as_meant = Evidence(f"read as: {reading.text}: PROVED ({other.rung})")
            reason = f"true when read as: {reading.text}"
            return Answer(Verdict.CONVENTION, other.rung, reason, (*as_printed, as_meant))
        if other.verdict in OPEN:
            left_open = left_open or _leave_open(f"when read as {reading.text}", other, literal)
    return left_open


def _find_part(row: Row, paper: Paper, refuted: Answer) -> Answer:
    """Return CONDITIONAL if the statement is proved on the stated part of the domain."""
    if row.holds_on is None:
        return refuted
    part = Domain.of(paper, row.on, row.holds_on)
    if not _has_interior(row.holds_on, part):
        return refuted
    inside = decide(row.statement, part)
    if inside.verdict in OPEN:
        return _leave_open(f"for {row.holds_on.text}", inside, refuted)
    if inside.verdict is not Verdict.PROVED:
        return refuted
    where = Evidence(f"{row.holds_on.text}: PROVED ({inside.rung})")
    outside = tuple(replace(item, what=f"elsewhere: {item.what}") for item in refuted.evidence)
    reason = f"true for {row.holds_on.text}, not on the whole domain"
    return Answer(Verdict.CONDITIONAL, inside.rung, reason, (where, *outside))


def _leave_open(meant: str, answer: Answer, refuted: Answer) -> Answer:
    """Report a row that is false literally and undecided in its intended sense."""
    literal = tuple(replace(item, what=f"as printed: {item.what}") for item in refuted.evidence)
    reason = f"not true as printed; not proved {meant}: {answer.reason}"
    return replace(answer, reason=reason, evidence=(*answer.evidence, *literal))


def _has_interior(part: Part, domain: Domain) -> bool:
    sets = [domain.set_of(symbol) for symbol in part.within]
    is_open = all(s in COUNTS or (isinstance(s, sp.Interval) and s.measure > 0) for s in sets)
    return is_open and not any(relation.has(sp.Equality) for relation in part.where)


def _with_correction(row: Row, paper: Paper, answer: Answer) -> Answer:
    """Prove the corrected form; a correction that is not proved leaves the row open."""
    if row.corrected is None or answer.verdict is Verdict.PROVED:
        return answer
    proof = _decide_ours(row.corrected.statement, paper, Domain.of(paper, row.on))
    if proof.verdict is Verdict.PROVED:
        evidence = (*answer.evidence, Evidence(f"corrected form: PROVED ({proof.rung})"))
        return replace(answer, evidence=evidence, corrected_by=proof.rung)
    reason = f"{answer.reason}; the corrected form is {proof.verdict}: {proof.reason}"
    return replace(answer, verdict=Verdict.UNDECIDED, reason=reason)
