"""The ladder: a statement and its domain -> an answer, cheapest rung first.

Rungs are tried one after another, like tactics under ORELSE in Edinburgh LCF (Gordon, Milner
and Wadsworth 1979). There a small kernel checks every result of a tactic. Here each rung is
responsible for its own soundness, balls contradict it at points, and for many rows Coq checks a
separate proof (`mechproof.coq`).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache
from itertools import chain, product
from typing import Any

import sympy as sp
from sympy.core.relational import Relational

from mechproof.proof import descents, integrand_signs, newton
from mechproof.proof.approximations import describe_order
from mechproof.proof.cases import decide_by_pieces, fix, write_pieces
from mechproof.proof.convergence import RUNG as DIVERGENCE, find_condition
from mechproof.proof.count_zeros import find_failing
from mechproof.proof.definedness import list_unshown, list_unshown_inside, put_in
from mechproof.proof.descents import holds_by_descent
from mechproof.proof.equation_ladder import CROSS_EXAMINATION, decide_sides, settle_sides
from mechproof.proof.exact_values import decide_exact, decide_number, resolve_sides
from mechproof.proof.floors import leave_fractions
from mechproof.proof.induction import OF_INEQUALITIES, holds_by_steps
from mechproof.proof.inequalities import show_sign
from mechproof.proof.integrals import RUNG as ANTIDERIVATIVE, find_value
from mechproof.proof.integrand_signs import holds_by_integrand
from mechproof.proof.limits import FROM_SIDES
from mechproof.proof.reasons import (
    count_parts,
    describe_inside,
    describe_needs,
    explain_relation,
    join_answers,
    join_rungs,
)
from mechproof.proof.refutation import BALLS, POINTS, find_violation
from mechproof.proof.signs import is_nonzero, is_shown
from mechproof.proof.single_variable import (
    BISECTION,
    NEAR_ZERO,
    holds_between,
    holds_near_zero,
    holds_on_interval,
)
from mechproof.proof.split_ranges import prove_on_parts
from mechproof.proof.value_points import find_undefined, lacks_any
from mechproof.proof.verdict import OPEN, Answer, Evidence, Verdict
from mechproof.proof.witness_text import clip
from mechproof.record import (
    Completion,
    Completions,
    Conjunction,
    Definition,
    Distinct,
    Equality,
    Holds,
    Nearly,
    NotCheckable,
    PrintedNumber,
    Slack,
    Statement,
    Unwritten,
)
from mechproof.record.estimates import without_estimates
from mechproof.record.parts import find_free, has_parts
from mechproof.record.relations import find_slack
from mechproof.record.substitution import put_values, write_steps
from mechproof.statement_domains.domain import Domain
from mechproof.statement_domains.preparation import take_values

UNCOMPARED = "nothing to compare with"
# What was checked of a newly introduced letter, in the reasons of definitions.
BOUND_AGREE = "bound symbols agree"
AGREE = f"dimensions and {BOUND_AGREE}"


@without_estimates()
def decide(statement: Statement, domain: Domain) -> Answer:
    """Decide one statement on one domain."""
    return _RULES[type(statement)](statement, domain)


def _decide_equality(statement: Equality, domain: Domain) -> Answer:
    answer = decide_sides(statement.printed, statement.rebuilt, domain)
    if answer.verdict in OPEN:
        sides = (statement.printed, statement.rebuilt)
        return find_condition(sides, domain, decide_sides) or answer
    is_repeated, source = _is_declaration(statement, domain), statement.rebuilt_from
    is_compared = source in ("mechanics", "member") and not is_repeated
    if answer.verdict is not Verdict.PROVED or is_compared:
        return answer
    said = "it repeats the definition of its letter"
    reason = said if is_repeated else f"the other side is built from the {source}"
    return Answer(Verdict.DEFINITION, answer.rung, f"{reason}: nothing to prove")


def _is_declaration(statement: Equality, domain: Domain) -> bool:
    """Return whether a side is a symbol and the other side is that symbol's declared value."""
    sides = (statement.printed, statement.rebuilt)
    return any(domain.given.get(one) == other for one, other in (sides, sides[::-1]))


def _decide_distinct(statement: Distinct, domain: Domain) -> Answer:
    equal = decide_sides(statement.left, statement.right, domain)
    opposite = {Verdict.REFUTED: Verdict.PROVED, Verdict.PROVED: Verdict.REFUTED}
    verdict = opposite.get(equal.verdict, Verdict.UNDECIDED)
    if verdict is Verdict.PROVED and equal.rung.endswith((DIVERGENCE, FROM_SIDES)):
        # A side without a value is no number, so the sides are not shown to be different numbers.
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
            return Answer(Verdict.UNDECIDED, "none", describe_inside(inside))
        answer = _decide_numbers(statement.relation, relation, domain)
        if answer.verdict is not Verdict.UNDECIDED or not has_parts(relation, sp.Integral):
            return answer
    if isinstance(relation, sp.Equality):
        return decide_sides(relation.lhs, relation.rhs, domain)
    # Points come first: once a point refutes a relation, the rungs need not be tried.
    if violation := find_violation(relation, domain):
        reason = newton.explain(relation, domain) or "a point violates it"
        return Answer(Verdict.REFUTED, BALLS, reason, (violation,))
    if rung := prove_relation(take_values(relation), domain):
        if any(inside):
            return Answer(Verdict.UNDECIDED, rung, describe_inside(inside))
        needs = [list_unshown(side, domain) for side in relation.args]
        needed = describe_needs(needs)
        count = POINTS if needed else CROSS_EXAMINATION
        undefined = find_undefined(relation.args, domain, count) or find_failing(
            relation.args, chain(*needs), domain, lacks_any
        )
        if undefined:
            reason = f"true wherever it is defined; it is undefined at {undefined}"
            return Answer(Verdict.UNDECIDED, rung, reason)
        where = f"where {needed}" if needed else "wherever it is defined"
        return Answer(Verdict.PROVED, rung, f"true {where}")
    settled = [put_values(side, domain, (sp.Integral,), find_value) for side in relation.args]
    if settled != [*relation.args]:
        answer = _decide_relation(Holds(relation.func(*settled, evaluate=False)), domain)
        return replace(answer, rung=f"{ANTIDERIVATIVE}, {answer.rung}")
    reason = f"{explain_relation(relation, domain)}; no violation at any point tried"
    return Answer(Verdict.UNDECIDED, "enclosure", reason)


def _put_in(relation: sp.Basic, domain: Domain) -> sp.Basic:
    if not isinstance(relation, Relational):
        return domain.resolve(relation)
    sides = [put_in(side, domain) for side in relation.args]
    # If evaluated, SymPy would compare integrals by floating-point values without bounds.
    return relation.func(*sides, evaluate=False)


# Many rows compare the same numbers.
@lru_cache(maxsize=256)
def _decide_numbers(printed: sp.Basic, relation: sp.Basic, domain: Domain) -> Answer:
    """Decide a relation without letters, using the values of its integrals and infinite sums."""
    sides, rungs = settle_sides(resolve_sides(printed, domain), domain)
    if rungs:
        settled, _ = settle_sides(relation.args, domain)
        relation = relation.func(*settled, evaluate=False)
    answer = decide_exact(relation, sides, getattr(printed, "rel_op", ""))
    return replace(answer, rung=", ".join([*rungs, answer.rung]))


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


def _decide_printed_number(statement: PrintedNumber, domain: Domain) -> Answer:
    (value,), rungs = settle_sides((domain.resolve(statement.value),), domain)
    answer = decide_number(statement, value)
    return replace(answer, rung=", ".join([*rungs, answer.rung]))


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
    return decide(completion.says, fix(domain, {missing: completion.value}))


def _describe(completion: Completion, answer: Answer) -> Evidence:
    what = f"{completion.text}: {answer.verdict}: {answer.reason} ({answer.rung})"
    first = answer.evidence[0] if answer.evidence else Evidence("")
    return Evidence(what, first.at, first.printed, first.rebuilt)


_RULES: dict[type, Callable[[Any, Domain], Answer]] = {
    Equality: _decide_equality,
    Distinct: _decide_distinct,
    Holds: _decide_relation,
    PrintedNumber: _decide_printed_number,
    Definition: lambda statement, domain: Answer(
        Verdict.DEFINITION, "definition", f"introduces a symbol; {AGREE}"
    ),
    Conjunction: _decide_conjunction,
    Completions: _decide_completions,
    Nearly: lambda statement, domain: Answer(
        Verdict.UNDECIDED, "none", describe_order(statement.left, statement.right, domain)
    ),
    NotCheckable: lambda statement, domain: Answer(
        Verdict.NOT_CHECKABLE, UNCOMPARED, f"not checkable: {statement.lacks}"
    ),
    Unwritten: lambda statement, domain: Answer(Verdict.UNDECIDED, "none", statement.reason),
}


SIGN = "sign in positive coordinates"
# Work limit: powers of negative numbers with symbolic whole exponents; each doubles the cases.
_MOST_TURNS = 2


def prove_relation(relation: sp.Basic, domain: Domain) -> str | None:
    """Return the rung that proves an inequality wherever its sides have values, or None."""
    if (cases := _list_turns(relation)) is not None:
        left = [case for case in cases if case != sp.true]
        rungs = [None if case == sp.false else prove_relation(case, domain) for case in left]
        return None if None in rungs else next(iter(rungs), SIGN)
    slack = find_slack(relation)
    if slack and relation.has(sp.floor, sp.ceiling):
        # A whole number is at least zero if it is greater than -1.
        is_met = slack.strict or not slack.value.is_integer
        above = slack if is_met else Slack(slack.value + 1, True)
        left, part = leave_fractions(write_steps(above.value), domain)
        if is_shown(above._replace(value=left), part):
            return SIGN
    if newton.converges(relation, domain):
        return newton.RUNG
    if holds_near_zero(relation, domain):
        return NEAR_ZERO
    if holds_on_interval(relation, domain):
        return BISECTION
    if _holds_by_sign(relation, domain):
        return SIGN
    if slack is None:
        return None
    if has_parts(slack.value, sp.Integral) and holds_by_integrand(slack, domain, _is_shown):
        return integrand_signs.RUNG
    if holds_by_steps(slack, domain, show_sign):
        return OF_INEQUALITIES
    if holds_by_descent(slack, domain, show_sign):
        return descents.RUNG
    if found := _hold_by_cases(relation, domain) or show_sign(slack, domain):
        return found
    if holds_between(relation, domain):
        return BISECTION
    return prove_on_parts(relation, domain, prove_relation)


def _is_shown(slack: Slack, domain: Domain) -> bool:
    """Return whether any rung proves a number positive, or non-negative if it is not strict."""
    relation = (sp.Gt if slack.strict else sp.Ge)(slack.value, 0, evaluate=False)
    return prove_relation(relation, domain) is not None


def _list_turns(relation: sp.Basic) -> list[sp.Basic] | None:
    """List variants of a relation, with each power (-2)^n written as 2^n or as -2^n.

    Whichever signs the powers have, one of the variants is equivalent to the relation. None if
    there are no such powers, or too many.
    """
    powers = [p for p in relation.atoms(sp.Pow) if p.base.is_negative and p.exp.free_symbols]
    if not 0 < len(powers) <= _MOST_TURNS or not all(p.exp.is_integer for p in powers):
        return None
    signs = product((1, -1), repeat=len(powers))
    sizes = [(-p.base) ** p.exp for p in powers]
    return [
        relation.xreplace(
            {p: sign * size for p, sign, size in zip(powers, one, sizes, strict=True)}
        )
        for one in signs
    ]


def _hold_by_cases(relation: sp.Basic, domain: Domain) -> str | None:
    """Prove an inequality piece by piece, and for all signs of the arguments of its moduli."""
    slack = find_slack(relation)
    if slack is None or not (written := write_pieces(slack.value)).has(sp.Piecewise):
        return None

    def prove(value: sp.Expr, zero: sp.Expr, part: Domain) -> str | None:
        if value is sp.nan:
            # Between the pieces there is no value.
            return None
        if value.has(sp.Piecewise):
            return decide_by_pieces((value, zero), part, prove)
        one = slack._replace(value=value)
        if is_shown(one, part):
            return SIGN
        relation = (sp.Gt if slack.strict else sp.Ge)(value, 0, evaluate=False)
        return show_sign(one, part) or prove_on_parts(relation, part, prove_relation)

    return prove(written, sp.S.Zero, domain)


def _holds_by_sign(relation: sp.Basic, domain: Domain) -> bool:
    if isinstance(relation, sp.Unequality):
        return is_nonzero(relation.lhs - relation.rhs, domain)
    slack = find_slack(relation)
    return slack is not None and is_shown(slack, domain)
