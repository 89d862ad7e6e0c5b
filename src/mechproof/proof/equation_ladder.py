"""The rungs of an equation: two sides and their domain -> an answer, cheapest rung first."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import chain, product
from typing import Any

import sympy as sp

from mechproof.proof.algebra import decide_equal, explain_unequal
from mechproof.proof.any_functions import decide_any, has_any_functions
from mechproof.proof.cases import (
    decide_by_pieces,
    decide_by_values,
    decide_from_last,
    decide_from_zero,
    decide_from_zero_end,
    list_poles,
    write_pieces,
)
from mechproof.proof.continuity import decide_by_derivative, explain_break
from mechproof.proof.convergence import (
    RUNG as DIVERGENCE,
    describe_divergence,
    lack_values_alike,
)
from mechproof.proof.count_zeros import (
    describe_zero_quotients,
    find_count_without_value,
    find_failing,
)
from mechproof.proof.definedness import (
    list_necessary,
    list_needed,
    list_unshown,
    list_unshown_inside,
    narrow_to,
    need_the_same,
    put_in,
)
from mechproof.proof.endless_sums import (
    KNOWN_SERIES,
    PARTIAL_SUMS,
    SUMS,
    find_endless,
    find_series,
)
from mechproof.proof.exact_values import decide_by_separation, decide_endless
from mechproof.proof.floors import decide_by_floors
from mechproof.proof.fraction_sums import RUNG as PARTIAL_FRACTIONS, find_fractions
from mechproof.proof.induction import decide_by_induction, decide_by_quotients
from mechproof.proof.integral_recurrences import decide_by_parts, settle_by_parts
from mechproof.proof.integrals import (
    RUNG as ANTIDERIVATIVE,
    decide_by_antiderivative,
    find_counterexample,
    find_improper,
)
from mechproof.proof.inverses import ROOT, decide_by_argument, decide_by_inverse
from mechproof.proof.known_integrals import RUNG as KNOWN_INTEGRAL, find_known
from mechproof.proof.limits import FROM_SIDES, describe_jump, describe_missing_limit, settle_limits
from mechproof.proof.powers import decide_by_logarithms, split_powers, take_signs, write_roots
from mechproof.proof.reasons import (
    WORST_FIRST,
    count_parts,
    describe_inside,
    describe_needs,
    join_answers,
    join_rungs,
    report_unproved,
)
from mechproof.proof.refutation import BALLS, EVERY_POINT, are_seen_to_differ, compare
from mechproof.proof.split_ranges import list_periods
from mechproof.proof.telescoping import decide_by_telescoping
from mechproof.proof.value_points import are_unlike, find_unlike
from mechproof.proof.verdict import Answer, Evidence, Verdict
from mechproof.proof.wave_sums import FOURIER, decide_by_binomials, decide_by_steps, find_waves
from mechproof.proof.witness_text import clip
from mechproof.record import DerivativeWhere, Slack
from mechproof.record.parts import ENDLESS, find_parts, has_parts
from mechproof.record.substitution import put_values, write_steps
from mechproof.statement_domains.domain import Domain
from mechproof.statement_domains.preparation import prepare, take_values

IDENTICAL = "identical"


def _decide_by_split_powers(left: sp.Expr, right: sp.Expr, domain: Domain) -> str | None:
    """Prove sides equal once powers of one base, x^n and x^(n - 1), are written by one of them."""
    difference = left - right
    split = split_powers(difference)
    return None if split == difference else decide_equal(split, sp.S.Zero, domain)


_FIRST = (
    decide_equal,
    _decide_by_split_powers,
    decide_by_argument,
    decide_by_separation,
    decide_by_derivative,
    decide_by_logarithms,
    decide_by_induction,
)
_LAST = (decide_by_quotients, decide_by_inverse, decide_by_telescoping, decide_by_floors)


def prove_equal(printed: sp.Expr, rebuilt: sp.Expr, domain: Domain) -> str | None:
    """Return the rungs that prove the sides equal wherever both have values, or None."""
    printed, rebuilt = (write_steps(take_values(side)) for side in (printed, rebuilt))
    if printed == rebuilt:
        return IDENTICAL
    if has_parts(printed, sp.Piecewise) or has_parts(rebuilt, sp.Piecewise):
        return decide_by_pieces((printed, rebuilt), domain, prove_equal)
    sides = printed, rebuilt = prepare(printed), prepare(rebuilt)
    for by_counts in (decide_from_last, decide_from_zero):
        if found := by_counts(sides, domain, prove_equal):
            return found
    found = next(filter(None, (rung(*sides, domain) for rung in _FIRST)), None)
    is_slow = any(has_parts(side, *ENDLESS) for side in sides)
    if not found and not is_slow and are_seen_to_differ(sides, domain):
        return None
    found = found or decide_by_antiderivative(*sides, domain, prove_equal)
    found = found or decide_by_parts(*sides, domain, prove_equal)
    found = found or decide_by_steps(*sides, domain, prove_equal)
    found = found or decide_by_binomials(*sides, domain, prove_equal)
    found = found or decide_by_values(sides, domain, prove_equal)
    found = found or decide_from_zero_end(sides, domain, prove_equal)
    found = found or _prove_by_cases(sides, domain)
    found = found or next(filter(None, (rung(*sides, domain) for rung in _LAST)), None)
    return found or _prove_by_squares(sides, domain)


def prove_where_defined(printed: sp.Expr, rebuilt: sp.Expr, domain: Domain) -> str | None:
    """Prove sides equal where the conditions of their roots, logarithms and so on hold."""
    sides = take_values(printed), take_values(rebuilt)
    necessary = {need for side in sides for need in list_necessary(domain.resolve(side))}
    unshown = [need for side in sides for need in list_unshown(side, domain)]
    part = narrow_to(domain, [need for need in unshown if need in necessary])
    return prove_equal(*sides, part) if part not in (None, domain) else None


def _prove_by_squares(sides: Sequence[sp.Expr], domain: Domain) -> str | None:
    """Prove sides equal after writing roots of squares as moduli."""
    letters = {letter for side in sides for letter in side.free_symbols}
    one, other = (write_roots(side, letters, domain) for side in sides)
    if (one, other) == tuple(sides):
        return None
    rest = prove_equal(take_signs(one, domain), take_signs(other, domain), domain)
    return f"{ROOT}, {rest}" if rest else None


def _prove_by_cases(sides: Sequence[sp.Expr], domain: Domain) -> str | None:
    """Prove sides equal for each combination of signs of the arguments of moduli."""
    poles = list_poles(sides)
    # SymPy raises a TypeError where a condition compares numbers that may be complex.
    with suppress(TypeError):
        one, other = (write_pieces(side, poles) for side in sides)
        return None if (one, other) == tuple(sides) else prove_equal(one, other, domain)
    return None


CROSS_EXAMINATION = 4
CROSS_PRECISION = (64,)
# Rungs that give values to parts of some kinds.
_SETTLED: Mapping[str, tuple[tuple[type, ...], Callable[..., sp.Expr | None]]] = {
    KNOWN_INTEGRAL: ((sp.Integral,), find_known),
    ANTIDERIVATIVE: ((sp.Integral,), find_improper),
    PARTIAL_SUMS: (SUMS, find_endless),
    KNOWN_SERIES: (SUMS, find_series),
    FOURIER: (SUMS, find_waves),
    PARTIAL_FRACTIONS: (SUMS, find_fractions),
}


class ContradictionError(RuntimeError):
    """A rung proved a statement that balls refute: a fault of the ladder itself."""


def decide_sides(printed: sp.Basic, rebuilt: sp.Basic, domain: Domain) -> Answer:
    """Decide whether two sides are the same wherever they have values."""
    if has_any_functions(printed, rebuilt):
        return decide_any(printed, rebuilt, domain, decide_sides)
    sides = [settle_limits(put_in(side, domain), domain) for side in (printed, rebuilt)]
    for rung, (kinds, find) in _SETTLED.items():
        printed, rebuilt = (put_values(side, domain, kinds, find) for side in sides)
        if [printed, rebuilt] != sides:
            answer = decide_sides(printed, rebuilt, domain)
            return replace(answer, rung=f"{rung}, {answer.rung}")
    is_endless = any(total.limits[0][2] == sp.oo for side in sides for total in side.atoms(sp.Sum))
    for part in list_periods(sides, domain) if is_endless else ():
        answer = decide_sides(printed, rebuilt, part)
        if answer.verdict in (Verdict.PROVED, Verdict.REFUTED):
            return answer
    if found := settle_by_parts(printed, rebuilt, domain, prove_equal):
        answer = decide_sides(found.printed, found.rebuilt, domain)
        return replace(answer, rung=f"{found.rung}, {answer.rung}")
    if told := describe_missing_limit((printed, rebuilt), domain):
        return Answer(Verdict.REFUTED, FROM_SIDES, told, (Evidence(told),))
    if told := describe_divergence((printed, rebuilt), domain):
        return Answer(Verdict.REFUTED, DIVERGENCE, told, (Evidence(told),))
    if limits := find_parts(printed, sp.Limit) | find_parts(rebuilt, sp.Limit):
        body, letter, point, _ = min(limits, key=str).args
        told = f"the limit of {body} as {letter} goes to {point} is not worked out"
        return Answer(Verdict.UNDECIDED, "none", clip(told))
    if isinstance(printed, sp.MatrixBase) or isinstance(rebuilt, sp.MatrixBase):
        return _decide_matrices(printed, rebuilt, domain)
    return _decide_scalars(printed, rebuilt, domain)


def settle_sides(sides: Sequence[sp.Expr], domain: Domain) -> tuple[tuple[sp.Expr, ...], list[str]]:
    """Replace integrals and infinite sums by their values; also name the rungs that found these."""
    rungs: list[str] = []
    for rung, (kinds, find) in _SETTLED.items():
        settled = tuple(put_values(side, domain, kinds, find) for side in sides)
        if settled != (*sides,):
            sides, rungs = settled, [*rungs, rung]
    return (*sides,), rungs


def _decide_matrices(printed: Any, rebuilt: Any, domain: Domain) -> Answer:
    shapes = [getattr(side, "shape", "of a number") for side in (printed, rebuilt)]
    if shapes[0] != shapes[1]:
        reason = f"the printed side has the shape {shapes[0]}, the other {shapes[1]}"
        return Answer(Verdict.REFUTED, "entrywise", reason, (Evidence(reason),))
    places = list(product(range(printed.rows), range(printed.cols)))
    entries = {place: _decide_scalars(printed[place], rebuilt[place], domain) for place in places}
    found = {answer.verdict for answer in entries.values()}
    # Only the entries with the worst verdict are reported.
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
        needed = describe_needs([list_unshown(side, domain) for side in sides])
        reason = f"both sides agree where {needed}, which is not stated"
        return Answer(Verdict.UNDECIDED, rung, reason)
    if told := _find_between_wholes(sides, domain):
        return told
    comparison = compare(printed, rebuilt, domain)
    if example := comparison.counterexample or find_counterexample(sides, domain, settle_sides):
        reason = explain_break(printed, domain, is_shown=True) or "the two sides differ"
        return Answer(Verdict.REFUTED, BALLS, reason, (example,))
    why = explain_break(printed - rebuilt, domain) or explain_unequal(printed, rebuilt, domain)
    return report_unproved(comparison, why)


def _find_between_wholes(sides: tuple[sp.Expr, sp.Expr], domain: Domain) -> Answer | None:
    """Answer for sides with infinite sums that are equal where a letter is not a whole number."""
    sums = {total for side in sides for total in side.atoms(sp.Sum) if total.limits[0][2] == sp.oo}
    letters = {s for total in sums for s in total.free_symbols if not s.is_integer}
    said = {s for relation in domain.where for s in relation.free_symbols}
    for letter in sorted(letters - said, key=str):
        apart = sp.Ne(letter, sp.floor(letter))
        answer = decide_sides(*sides, replace(domain, where=(*domain.where, apart)))
        if answer.verdict is Verdict.PROVED:
            told = f"both sides agree where {letter} is not a whole number, which is not stated"
            return Answer(Verdict.UNDECIDED, answer.rung, told)
    return None


def _report_equal(
    sides: tuple[sp.Expr, sp.Expr], domain: Domain, rung: str, is_alike: bool = False
) -> Answer:
    """Answer for sides that are equal where both have values: PROVED if they have them alike.

    `is_alike`: wherever their conditions fail, it is shown that neither side has a value.
    """
    needs = [list_unshown(side, domain) for side in sides]
    part = narrow_to(domain, [*chain(*needs)]) if is_alike else None
    inside = [list_unshown_inside(side, part or domain) for side in sides]
    if {*inside[0]} != {*inside[1]}:
        return Answer(Verdict.UNDECIDED, rung, describe_inside(inside))
    needed = describe_needs(needs)
    if told := describe_jump(sides, domain):
        return Answer(Verdict.UNDECIDED, rung, f"the differentiated function jumps: {told}")
    if any(has_parts(side, DerivativeWhere) for side in sides):
        domain = narrow_to(domain, [n for side in sides for n in list_needed(side)]) or domain
    undefined = _cross_examine(*sides, part) if part else _find_break(sides, needs, domain)
    if undefined:
        reason = f"both sides agree where both are defined; one is undefined at {undefined}"
        unsaid = f"; not stated: {needed}" if needed else ""
        return Answer(Verdict.UNDECIDED, rung, reason + unsaid)
    where = f"where {needed}" if needed else "wherever they are defined"
    said = filter(None, (f"both sides agree {where}", describe_zero_quotients(sides, domain)))
    return Answer(Verdict.PROVED, rung, "; ".join(said))


def _find_break(
    sides: tuple[sp.Expr, sp.Expr], needs: Sequence[list[Slack]], domain: Domain
) -> str:
    """Return an interior point at which only one side has a value, or "" if none is met.

    If no point gives values to both sides, that is reported in its place.
    """
    undefined = _cross_examine(*sides, domain)
    if undefined == EVERY_POINT and any(needs):
        # Random points seldom satisfy several conditions, so the search is narrowed to where they
        # hold.
        part = narrow_to(domain, [*chain(*needs)])
        undefined = _cross_examine(*sides, part) if part else undefined
    undefined = undefined or find_count_without_value(sides, domain)
    if undefined or sides[0] == sides[1] or not any(needs) or need_the_same(sides, needs, domain):
        return undefined
    unlike = find_unlike(sides, domain)
    return unlike or find_failing(sides, chain(*needs), domain, are_unlike)


def _cross_examine(printed: sp.Expr, rebuilt: sp.Expr, domain: Domain) -> str:
    """Return an interior point where only one side has a value, or ""; raise if balls refute."""
    if printed == rebuilt and compare(printed, rebuilt, domain, 1, CROSS_PRECISION).agreeing:
        return ""
    comparison = compare(printed, rebuilt, domain, CROSS_EXAMINATION, CROSS_PRECISION)
    if comparison.counterexample:
        raise ContradictionError(f"proved, yet {comparison.counterexample}: {printed} = {rebuilt}")
    return comparison.undefined
