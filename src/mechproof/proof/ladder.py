"""The ladder: a statement and its domain -> an answer, cheapest rung first."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import chain, product
from typing import Any

import sympy as sp
from sympy.core.relational import Relational

from mechproof.domains.domain import Domain
from mechproof.domains.preparation import take_values
from mechproof.proof import newton
from mechproof.proof.algebra import explain_unequal
from mechproof.proof.antiderivative import explain_break
from mechproof.proof.any_functions import decide_any, has_any_functions
from mechproof.proof.conditions import find_condition
from mechproof.proof.count_zeros import find_count_without_value, tell_zero_quotients
from mechproof.proof.definedness import (
    list_needed,
    list_unshown,
    list_unshown_inside,
    narrow_to,
    need_the_same,
    put_in,
)
from mechproof.proof.divergence import RUNG as DIVERGENCE, lack_values_alike, tell_divergence
from mechproof.proof.endless_sums import RUNG as PARTIAL_SUMS, settle_endless
from mechproof.proof.equalities import prove_equal, prove_where_defined
from mechproof.proof.exact_values import decide_endless, decide_exact, resolve_sides
from mechproof.proof.fourier_series import RUNG as FOURIER_SERIES, settle_waves
from mechproof.proof.integral_recurrences import settle_by_parts
from mechproof.proof.integrals import RUNG as ANTIDERIVATIVE, find_counterexample, settle_improper
from mechproof.proof.known_integrals import RUNG as KNOWN_INTEGRAL, settle_known_integrals
from mechproof.proof.known_series import RUNG as KNOWN_SERIES, settle_series
from mechproof.proof.limits import FROM_SIDES, settle_limits, tell_jump, tell_missing_limit
from mechproof.proof.printed_number import decide_number
from mechproof.proof.reasons import (
    WORST_FIRST,
    count_parts,
    explain_relation,
    join_answers,
    join_rungs,
    report_unproved,
    tell_inside,
    tell_needs,
)
from mechproof.proof.refutation import (
    BALLS,
    EVERY_POINT,
    POINTS,
    compare,
    find_undefined,
    find_unlike,
    find_violation,
)
from mechproof.proof.relations import prove_relation
from mechproof.proof.verdict import OPEN, Answer, Evidence, Verdict
from mechproof.proof.witness_text import clip
from mechproof.record import (
    Completion,
    Completions,
    Conjunction,
    Definition,
    DerivativeWhere,
    Distinct,
    Equality,
    Holds,
    NotCheckable,
    PrintedNumber,
    Slack,
    Statement,
    Unwritten,
)
from mechproof.record.parts import find_free, find_parts, has_parts
from mechproof.record.substitution import substitute

UNCOMPARED = "nothing to compare with"
# What was seen of a letter that is introduced.
BOUND_AGREE = "bound symbols agree"
AGREE = f"dimensions and {BOUND_AGREE}"
CROSS_EXAMINATION = 4
CROSS_PRECISION = (64,)
_SETTLED = {
    KNOWN_INTEGRAL: settle_known_integrals,
    ANTIDERIVATIVE: settle_improper,
    PARTIAL_SUMS: settle_endless,
    KNOWN_SERIES: settle_series,
    FOURIER_SERIES: settle_waves,
}


class ContradictionError(RuntimeError):
    """A rung proved what balls refute: a fault of the ladder itself."""


def decide(statement: Statement, domain: Domain) -> Answer:
    """Decide one statement on one domain."""
    return _RULES[type(statement)](statement, domain)


def _decide_equality(statement: Equality, domain: Domain) -> Answer:
    answer = _decide_sides(statement.printed, statement.rebuilt, domain)
    if answer.verdict in OPEN:
        sides = (statement.printed, statement.rebuilt)
        return find_condition(sides, domain, _decide_sides) or answer
    is_repeated, source = _is_declaration(statement, domain), statement.rebuilt_from
    is_compared = source in ("mechanics", "member") and not is_repeated
    if answer.verdict is not Verdict.PROVED or is_compared:
        return answer
    said = "it repeats the definition of its letter"
    reason = said if is_repeated else f"the other side is built from the {source}"
    return Answer(Verdict.DEFINITION, answer.rung, f"{reason}: nothing to prove")


def _is_declaration(statement: Equality, domain: Domain) -> bool:
    """Tell whether a side is a symbol and the other what the symbol is declared to be."""
    sides = (statement.printed, statement.rebuilt)
    return any(domain.given.get(one) == other for one, other in (sides, sides[::-1]))


def _decide_sides(printed: sp.Basic, rebuilt: sp.Basic, domain: Domain) -> Answer:
    if has_any_functions(printed, rebuilt):
        return decide_any(printed, rebuilt, domain, _decide_sides)
    sides = [settle_limits(put_in(side, domain), domain) for side in (printed, rebuilt)]
    for rung, settle in _SETTLED.items():
        printed, rebuilt = (settle(side, domain) for side in sides)
        if [printed, rebuilt] != sides:
            answer = _decide_sides(printed, rebuilt, domain)
            return replace(answer, rung=f"{rung}, {answer.rung}")
    if found := settle_by_parts(printed, rebuilt, domain, prove_equal):
        answer = _decide_sides(found.printed, found.rebuilt, domain)
        return replace(answer, rung=f"{found.rung}, {answer.rung}")
    if told := tell_missing_limit((printed, rebuilt), domain):
        return Answer(Verdict.REFUTED, FROM_SIDES, told, (Evidence(told),))
    if told := tell_divergence((printed, rebuilt), domain):
        return Answer(Verdict.REFUTED, DIVERGENCE, told, (Evidence(told),))
    if limits := sorted(map(str, find_parts(printed, sp.Limit) | find_parts(rebuilt, sp.Limit))):
        return Answer(Verdict.UNDECIDED, "none", clip(f"{limits[0]} is not worked out"))
    if isinstance(printed, sp.MatrixBase) or isinstance(rebuilt, sp.MatrixBase):
        return _decide_matrices(printed, rebuilt, domain)
    return _decide_scalars(printed, rebuilt, domain)


def _decide_matrices(printed: Any, rebuilt: Any, domain: Domain) -> Answer:
    shapes = [getattr(side, "shape", "of a number") for side in (printed, rebuilt)]
    if shapes[0] != shapes[1]:
        reason = f"the printed side has the shape {shapes[0]}, the other {shapes[1]}"
        return Answer(Verdict.REFUTED, "entrywise", reason, (Evidence(reason),))
    places = list(product(range(printed.rows), range(printed.cols)))
    entries = {place: _decide_scalars(printed[place], rebuilt[place], domain) for place in places}
    found = {answer.verdict for answer in entries.values()}
    # Those are told that are judged worst.
    verdict = min(found, key=WORST_FIRST.index, default=Verdict.PROVED)
    told = {place: answer for place, answer in entries.items() if answer.verdict is verdict}
    rung = f"entrywise, {join_rungs([answer.rung for answer in told.values()])}"
    if verdict is Verdict.PROVED:
        return Answer(verdict, rung, f"{count_parts(len(told))} entries agree")
    named = {f"entry ({row + 1}, {column + 1})": a for (row, column), a in told.items()}
    return join_answers(named, rung)


def _decide_scalars(printed: sp.Expr, rebuilt: sp.Expr, domain: Domain) -> Answer:
    sides = printed, rebuilt
    if found := decide_endless(sides):
        return found
    if rung := prove_equal(printed, rebuilt, domain):
        return _report_equal(sides, domain, rung)
    if rung := prove_where_defined(printed, rebuilt, domain):
        if not any(has_parts(side, sp.Integral, sp.Sum, sp.Product) for side in sides):
            return _report_equal(sides, domain, rung)
        if lack_values_alike(sides, domain):
            return _report_equal(sides, domain, rung, is_alike=True)
        needed = tell_needs([list_unshown(side, domain) for side in sides])
        reason = f"both sides agree where {needed}, which is not said"
        return Answer(Verdict.UNDECIDED, rung, reason)
    comparison = compare(printed, rebuilt, domain)
    if example := comparison.counterexample or find_counterexample(sides, domain):
        reason = explain_break(printed, domain, is_shown=True) or "the two sides differ"
        return Answer(Verdict.REFUTED, BALLS, reason, (example,))
    why = explain_break(printed - rebuilt, domain) or explain_unequal(printed, rebuilt, domain)
    return report_unproved(comparison, why)


def _report_equal(
    sides: tuple[sp.Expr, sp.Expr], domain: Domain, rung: str, is_alike: bool = False
) -> Answer:
    """Answer for sides that are equal where both have values: PROVED if they have them alike.

    `is_alike`: beyond what they need it is shown that both have none.
    """
    needs = [list_unshown(side, domain) for side in sides]
    part = narrow_to(domain, [*chain(*needs)]) if is_alike else None
    inside = [list_unshown_inside(side, part or domain) for side in sides]
    if {*inside[0]} != {*inside[1]}:
        return Answer(Verdict.UNDECIDED, rung, tell_inside(inside))
    needed = tell_needs(needs)
    if told := tell_jump(sides, domain):
        return Answer(Verdict.UNDECIDED, rung, f"what is differentiated jumps: {told}")
    if any(has_parts(side, DerivativeWhere) for side in sides):
        domain = narrow_to(domain, [n for side in sides for n in list_needed(side)]) or domain
    undefined = _cross_examine(*sides, part) if part else _find_break(sides, needs, domain)
    if undefined:
        reason = f"both sides agree where both are defined, which fails at {undefined}"
        unsaid = f"; what is not said: {needed}" if needed else ""
        return Answer(Verdict.UNDECIDED, rung, reason + unsaid)
    where = f"where {needed}" if needed else "wherever they are defined"
    said = filter(None, (f"both sides agree {where}", tell_zero_quotients(sides, domain)))
    return Answer(Verdict.PROVED, rung, "; ".join(said))


def _find_break(
    sides: tuple[sp.Expr, sp.Expr], needs: Sequence[list[Slack]], domain: Domain
) -> str:
    """Return an interior point at which only one side has a value, empty if none is met.

    Where no point gives values to both, that is told as well.
    """
    undefined = _cross_examine(*sides, domain)
    if undefined == EVERY_POINT and any(needs):
        # Few points lie where more than one letter has to be positive.
        part = narrow_to(domain, [*chain(*needs)])
        undefined = _cross_examine(*sides, part) if part else undefined
    undefined = undefined or find_count_without_value(sides, domain)
    if undefined or sides[0] == sides[1] or not any(needs) or need_the_same(sides, needs, domain):
        return undefined
    return find_unlike(sides, domain)


def _cross_examine(printed: sp.Expr, rebuilt: sp.Expr, domain: Domain) -> str:
    """Return an interior point at which only one side has a value, empty if there is none."""
    if printed == rebuilt and compare(printed, rebuilt, domain, 1, CROSS_PRECISION).agreeing:
        return ""
    comparison = compare(printed, rebuilt, domain, CROSS_EXAMINATION, CROSS_PRECISION)
    if comparison.counterexample:
        raise ContradictionError(f"proved, yet {comparison.counterexample}: {printed} = {rebuilt}")
    return comparison.undefined


def _decide_distinct(statement: Distinct, domain: Domain) -> Answer:
    equal = _decide_sides(statement.left, statement.right, domain)
    opposite = {Verdict.REFUTED: Verdict.PROVED, Verdict.PROVED: Verdict.REFUTED}
    verdict = opposite.get(equal.verdict, Verdict.UNDECIDED)
    if verdict is Verdict.PROVED and equal.rung.endswith(DIVERGENCE):
        # What has no value is no number that differs.
        return replace(equal, verdict=Verdict.UNDECIDED)
    told = "the two do not differ: " if verdict is Verdict.REFUTED else ""
    return replace(equal, verdict=verdict, reason=f"{told}{equal.reason}")


def _decide_relation(statement: Holds, domain: Domain) -> Answer:
    if statement.relation in (sp.true, sp.false):
        reason = "SymPy evaluated the relation when it was written: build it with evaluate=False"
        return Answer(Verdict.UNDECIDED, "none", reason)
    relation = _put_in(statement.relation, domain)
    if has_parts(relation, sp.Limit):
        return Answer(Verdict.UNDECIDED, "none", clip(f"{relation}: a limit is not worked out"))
    if isinstance(statement.relation, sp.And):
        parts = tuple(Holds(part) for part in sorted(statement.relation.args, key=str))
        return _decide_conjunction(Conjunction(parts), domain)
    inside = [list_unshown_inside(side, domain) for side in statement.relation.args]
    if relation in (sp.true, sp.false) or not find_free(relation):
        if any(inside):
            return Answer(Verdict.UNDECIDED, "none", tell_inside(inside))
        sign = getattr(statement.relation, "rel_op", "")
        return decide_exact(relation, resolve_sides(statement.relation, domain), sign)
    if isinstance(relation, sp.Equality):
        return _decide_sides(relation.lhs, relation.rhs, domain)
    # What points refute need not be tried by every rung.
    if violation := find_violation(relation, domain):
        reason = newton.explain(relation, domain) or "a point violates it"
        return Answer(Verdict.REFUTED, BALLS, reason, (violation,))
    if rung := prove_relation(take_values(relation), domain):
        if any(inside):
            return Answer(Verdict.UNDECIDED, rung, tell_inside(inside))
        needed = tell_needs([list_unshown(side, domain) for side in relation.args])
        count = POINTS if needed else CROSS_EXAMINATION
        if undefined := find_undefined(relation.args, domain, count):
            reason = f"true wherever it is defined, which fails at {undefined}"
            return Answer(Verdict.UNDECIDED, rung, reason)
        where = f"where {needed}" if needed else "wherever it is defined"
        return Answer(Verdict.PROVED, rung, f"true {where}")
    reason = f"{explain_relation(relation, domain)}; no violation at any point tried"
    return Answer(Verdict.UNDECIDED, "enclosure", reason)


def _put_in(relation: sp.Basic, domain: Domain) -> sp.Basic:
    if not isinstance(relation, Relational):
        return domain.resolve(relation)
    sides = [put_in(side, domain) for side in relation.args]
    return relation if sides == [*relation.args] else relation.func(*sides)


def _decide_conjunction(statement: Conjunction, domain: Domain) -> Answer:
    answers = [decide(part, domain) for part in statement.parts]
    if statement.needs_first and answers[0].verdict is not Verdict.PROVED:
        first = getattr(statement.parts[0], "relation", statement.parts[0])
        return Answer(Verdict.UNDECIDED, "none", f"it rests on {first}, which is not proved")
    failed = {
        f"part {number} of {len(answers)}": d
        for number, d in enumerate(answers, start=1)
        if d.verdict not in (Verdict.PROVED, Verdict.DEFINITION)
    }
    if failed:
        return next(iter(failed.values())) if len(answers) == 1 else join_answers(failed)
    evidence = tuple(item for answer in answers for item in answer.evidence)
    rung = join_rungs([d.rung for d in answers])
    if all(d.verdict is Verdict.DEFINITION for d in answers):
        introduced = f"introduces {len(answers)} symbols; {AGREE}"
        reason = introduced if len(answers) > 1 else answers[0].reason
        return Answer(Verdict.DEFINITION, rung, reason, evidence)
    reason = f"{count_parts(len(answers))} parts hold" if len(answers) > 1 else "holds"
    return Answer(Verdict.PROVED, rung, reason, evidence)


def _decide_completions(statement: Completions, domain: Domain) -> Answer:
    sides = (statement.first, statement.second)
    answers = [_decide_completion(side, statement.missing, domain) for side in sides]
    evidence = tuple(_describe(s, d) for s, d in zip(sides, answers, strict=True))
    if {d.verdict for d in answers} == {Verdict.PROVED, Verdict.REFUTED}:
        reason = f"not stated: {statement.missing}; two completions give opposite answers"
        return Answer(Verdict.UNDERDETERMINED, "two completions", reason, evidence)
    reason = "the two completions do not give opposite answers"
    return Answer(Verdict.UNDECIDED, "two completions", reason, evidence)


def _decide_completion(completion: Completion, missing: str | sp.Symbol, domain: Domain) -> Answer:
    if not isinstance(missing, sp.Symbol):
        return decide(completion.says, domain)
    given = {**domain.given, missing: completion.value}
    within = {s: values for s, values in domain.within.items() if s != missing}
    where = tuple(substitute(r, {missing: completion.value}) for r in domain.where)
    return decide(completion.says, replace(domain, within=within, where=where, given=given))


def _describe(completion: Completion, answer: Answer) -> Evidence:
    what = f"{completion.text}: {answer.verdict}: {answer.reason} ({answer.rung})"
    first = answer.evidence[0] if answer.evidence else Evidence("")
    return Evidence(what, first.at, first.printed, first.rebuilt)


_RULES: dict[type, Callable[[Any, Domain], Answer]] = {
    Equality: _decide_equality,
    Distinct: _decide_distinct,
    Holds: _decide_relation,
    PrintedNumber: lambda statement, domain: decide_number(
        statement, domain.resolve(statement.value)
    ),
    Definition: lambda statement, domain: Answer(
        Verdict.DEFINITION, "definition", f"introduces a symbol; {AGREE}"
    ),
    Conjunction: _decide_conjunction,
    Completions: _decide_completions,
    NotCheckable: lambda statement, domain: Answer(
        Verdict.NOT_CHECKABLE, UNCOMPARED, f"not checkable: {statement.lacks}"
    ),
    Unwritten: lambda statement, domain: Answer(Verdict.UNDECIDED, "none", statement.reason),
}
