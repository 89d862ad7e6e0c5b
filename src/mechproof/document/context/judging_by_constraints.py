"""Judge rows by the constraints of their paper, in worker processes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import chain

import sympy as sp

from mechproof.document.constraints.consequences import (
    COMBINATION,
    MULTIPLE,
    find_consequence,
    list_applicable,
    list_letters,
    state_at,
)
from mechproof.document.constraints.following import list_all_entries, list_entries
from mechproof.document.constraints.solutions import (
    SUBSTITUTION,
    Solutions,
    join_values,
    write_sign,
)
from mechproof.document.misprints import RUNG, Misprint, find_failure, find_misprint, holds_at_rest
from mechproof.document.row_sides import write_out
from mechproof.document.slips import PrintedSides
from mechproof.document.tasks import Role, Task
from mechproof.latex.values import settle_all
from mechproof.proof.equation_ladder import ContradictionError
from mechproof.proof.judge import judge
from mechproof.proof.ladder import decide
from mechproof.proof.verdict import Evidence, Judgement, Verdict
from mechproof.record import Conjunction, Definition, Equality, RecordError
from mechproof.statement_domains.domain import Domain


def judge_by_constraints(
    tasks: Sequence[Task],
    number: int,
    others: Sequence[int],
    letters: frozenset[sp.Basic] = frozenset(),
) -> Judgement | None:
    """Judge a row by the constraints before it; None if it is not shown to follow.

    `letters` are kept as printed, whatever defines them.
    """
    before = [tasks[other] for other in list_applicable(others, number, tasks)]
    answer, own = None, tasks[number]
    for task in filter(None, (own, own.special, own.case)):
        rows = [list_entries(t, letters) if letters else [t] for t in (task, *before)]
        entries, given = rows[0], [*chain(*rows[1:])]
        if task.residual is None:
            entries = list_all_entries(task, letters)
        found = _find_consequence_of_entries(entries, given) if given else None
        # The case that words mention may prove a row, but refutes none.
        is_told = found and (task is not own.case or found[0] is Verdict.PROVED)
        answer = _replace(task, *found) if found and is_told else answer
        if answer and answer.verdict is Verdict.PROVED:
            break
    return answer


def _find_consequence_of_entries(
    entries: Sequence[Task], given: Sequence[Task]
) -> tuple[Verdict, str, str] | None:
    """Judge one equation, or all entries of an equation of matrices, by constraints."""
    if len(entries) == 1:
        (one,) = entries
        known = [*state_at(given, one)] if one.residual is not None else []
        return find_consequence(one, known) if known else None
    reasons: dict[str, None] = {}
    rung = MULTIPLE
    for one in entries:
        zero = Equality(sp.sympify(one.residual), sp.S.Zero, "member")
        if decide(zero, one.domain).verdict is Verdict.PROVED:
            continue
        found = find_consequence(one, [*state_at(given, one)])
        if not found or found[0] is not Verdict.PROVED:
            return None
        # The multiplier of an entry is left out of the reason; the constraint's name is kept.
        reasons[found[2].partition(":")[0] if found[1] == MULTIPLE else found[2]] = None
        rung = rung if found[1] == MULTIPLE else COMBINATION
    said = f"each entry that differs {'; '.join(reasons)}"
    return (Verdict.PROVED, rung, said) if reasons else None


def judge_excused(tasks: Sequence[Task], number: int, others: Sequence[int]) -> Judgement | str:
    """Judge by all constraints what is not true on its own, or name those that may make it true."""
    task, found = tasks[number], judge_by_constraints(tasks, number, others)
    if found and found.verdict is Verdict.PROVED:
        return found
    before = [tasks[other] for other in others]
    given = list(_list_given(task, [*state_at(before, task)] if task.at else before))
    names = ", ".join(tasks[other].row.number for other in others)
    for entry in _list_entries(task):
        if evidence := find_failure(entry.sides, given, task.domain):
            hold = "holds" if len(others) == 1 else "hold"
            beside = f", also where {names} {hold}" if names else ""
            compared = f"; compared with {task.sign.first}" if task.sign.first else ""
            reason = f"the two sides differ{beside}{compared}"
            return _replace(task, Verdict.REFUTED, RUNG, reason, (evidence,))
    make = "makes" if len(others) == 1 else "make"
    return f"the two sides differ unless {names} {make} them equal, which could not be decided"


def judge_misprint(tasks: Sequence[Task], number: int, others: Sequence[int]) -> Judgement | None:
    """Judge whether a possible constraint is a misprint, given constraints; None if not refuted."""
    found = _find_misprint(tasks, number, others, may_repeat=False)
    if found is None:
        return None
    task, misprint, compared_with = found
    reason = write_sign(f"{misprint.change.reason}{compared_with}")
    return _replace(task, Verdict.REFUTED, RUNG, reason, (misprint.evidence,))


def describe_misprint(
    tasks: Sequence[Task], number: int, others: Sequence[int], proved: Sequence[int]
) -> str:
    """Return what a row may be meant to say given constraints, even if that is printed elsewhere.

    If the mended row is one of the `proved` rows, that one is named. Returns "" if nothing mends
    it.
    """
    found = _find_misprint(tasks, number, others, may_repeat=True)
    if found is None:
        return ""
    task, misprint, compared_with = found
    one, other = map(task.domain.resolve, misprint.change.sides)
    rows = (tasks[m] for m in proved)
    alike = [row.row.number for row in rows if _is_multiple(one - other, row.residual)]
    if alike:
        return f"it differs from {alike[0]}, which is proved: a misprint, or another case?"
    return write_sign(f"{misprint.change.reason}{compared_with}: another case?")


def _is_multiple(rest: sp.Expr, residual: sp.Expr | None) -> bool:
    if residual in (None, 0) or rest.free_symbols != residual.free_symbols:
        return False
    return bool(sp.cancel(rest / residual).is_number)


def _becomes_one(found: Misprint, later: Sequence[Task], domain: Domain) -> bool:
    """Return whether a mended print is a later one times powers of its letters.

    In that case it is open which of the two is wrong.
    """
    one, other = map(domain.resolve, found.change.sides)
    rest = one - other
    residuals = (task.residual for task in later)
    ratios = [sp.cancel(rest / x) for x in residuals if x not in (None, 0)]
    ratios = [ratio for ratio in ratios if ratio.free_symbols <= rest.free_symbols]
    powers = ([f.as_base_exp() for f in sp.Mul.make_args(ratio)] for ratio in ratios)
    return any(
        all(base.is_number or (base.is_Symbol and exp.is_number) for base, exp in factors)
        for factors in powers
    )


def _find_misprint(
    tasks: Sequence[Task], number: int, others: Sequence[int], *, may_repeat: bool
) -> tuple[Task, Misprint, str] | None:
    """Return a row that may be a misprint, what mends it, and what it is compared with."""
    # A statement about one case does not accuse a statement about all cases.
    task, *constraints = (tasks[n].special or tasks[n] for n in (number, *others))
    try:
        domain = task.domain
        beside = [*state_at(constraints, task)]
        given = list(_list_given(task, beside))
        compared = [*_list_compared(task, tasks[number].others, tasks)]
        state = partial(join_values, task.sign)
        if tasks[number].others and not all(find_failure(e.sides, given, domain) for e in compared):
            return None
        cases = [] if task.at else [(one.special or one).at for one in tasks[:number]]
        cases.append(dict(_list_zeros(tasks[number:])))
        if any(at and _may_hold_at(at, task, constraints) for at in cases):
            return None
        plain = [one for one in constraints if not one.sign.is_tied]
        # A print that becomes another one of the paper is no misprint, unless it may repeat that.
        is_same = task.asserts or task.sign.is_tied or may_repeat
        printed, repeated = _list_printed(tasks), None if is_same else [*_list_given(task, plain)]
        second = {s for t in (task, *beside) for s in _list_accelerations(t)}
        for entry in compared:
            found = find_misprint(entry, given, domain, printed, repeated, state=state)
            later = [tasks[m] for m in others if m > number and _is_another(tasks[m])]
            if found and not is_same and _becomes_one(found, later, domain):
                continue
            if found and not holds_at_rest(state(entry.sides), given, domain, second):
                met = dict.fromkeys((task.sign.first, *(one.row.number for one in beside)))
                names = ", ".join(name for name in met if name not in ("", task.row.number))
                return task, found, f"; compared with {names}" if names else ""
    except (RecordError, ContradictionError):
        pass
    return None


def _list_zeros(later: Sequence[Task]) -> Iterator[tuple[sp.Basic, sp.Expr]]:
    """Yield letters that later rows set to zero: a row may already assume that."""
    for says in (task.row.says for task in later if task.sign.role is Role.SIZE):
        if isinstance(says, Definition) and says.printed == 0:
            yield says.symbol, sp.S.Zero


def _is_another(task: Task) -> bool:
    """Return whether a row is an equation of its own: neither another case nor a print of roots."""
    return not (task.is_case or task.sign.role is Role.SOLUTIONS)


def _may_hold_at(at: Mapping[sp.Basic, sp.Basic], task: Task, constraints: Sequence[Task]) -> bool:
    """Return whether a row may hold at the values that an earlier row's text gives letters."""
    there = replace(task, at={**task.at, **at})
    given = [*_list_given(there, [*state_at(constraints, there)])]
    sides = ([settle_all(task.domain.resolve(s), at) for s in e.sides] for e in _list_entries(task))
    return not all(find_failure((one, other), given, task.domain) for one, other in sides)


def _list_printed(tasks: Sequence[Task]) -> set[sp.Basic]:
    return {task.row.says.symbol for task in tasks if isinstance(task.row.says, Definition)}


def _list_accelerations(task: Task) -> set[sp.Basic]:
    """Return the letters that occur in the second derivative of a row only."""
    first = {s for rate in task.rates[:1] for s in rate.free_symbols} | list_letters(task)
    return {s for rate in task.rates[1:] for s in rate.free_symbols} - first


def judge_roots(tasks: Sequence[Task], number: int, others: Sequence[int]) -> Judgement | None:
    """Judge a print with a double sign by constraints; None if nothing is shown."""
    task = tasks[number]
    given = {one.row.number: one.residual for one in state_at([tasks[o] for o in others], task)}
    letters = {s for residual in given.values() for s in sp.sympify(residual).free_symbols}
    solutions = Solutions(*task.sign.sides).name_root(sorted(letters, key=str))
    if met := solutions.find_met(given, task.domain):
        reason = "with either sign, {} solves {}, taken as given".format(*met)
        return _replace(task, Verdict.PROVED, SUBSTITUTION, reason)
    if task.is_case or solutions.is_pair:
        return None
    if found := solutions.find_misprint([*given.values()], task.domain, _list_printed(tasks)):
        reason = f"{write_sign(found.change.reason)}; both signs compared with other prints"
        return _replace(task, Verdict.REFUTED, RUNG, reason, (found.evidence,))
    return None


def judge_half(tasks: Sequence[Task], number: int, pair: int) -> Judgement | None:
    """Judge the definition of x_1 by the print of x_{1,2}; None if nothing is shown."""
    task, says = tasks[number], tasks[number].row.says
    if not (isinstance(says, Definition) and isinstance(says.printed, sp.Expr)):
        return None
    both = Solutions(*tasks[pair].sign.sides)
    half = both.name_half(says.printed)
    if half.is_met(task.domain):
        reason = f"it is one of the two values of {tasks[pair].row.number}"
        return _replace(task, Verdict.PROVED, SUBSTITUTION, reason)
    entry = PrintedSides((half.left, both.left), (True, False))
    found = find_misprint(entry, [tasks[pair].residual], task.domain, _list_printed(tasks))
    if found is None or task.is_case:
        return None
    reason = f"{found.change.reason}; compared with both values of {tasks[pair].row.number}"
    return _replace(task, Verdict.REFUTED, RUNG, reason, (found.evidence,))


def _replace(
    task: Task, verdict: Verdict, rung: str, reason: str, evidence: tuple[Evidence, ...] = ()
) -> Judgement:
    """Return the judgement of a row on its own, with its verdict and grounds replaced."""
    alone = judge(task.row, task.paper)
    values = ", ".join(f"{letter} = {value}" for letter, value in task.at.items())
    reason = f"{reason}; for {values}" if values else reason
    return replace(alone, verdict=verdict, rung=rung, reason=reason, evidence=evidence)


def _list_compared(
    task: Task, others: Sequence[Task], tasks: Sequence[Task]
) -> Iterator[PrintedSides]:
    """Yield the sides of a row and of others; for a tie of two letters, of the joint print."""
    if task.sign.is_tied:
        pair = next(one for one in tasks if one.row.number == task.sign.first)
        yield PrintedSides(pair.sign.sides, (False, True))
        return
    for one in (task, *others):
        yield from _list_entries(one)


def _list_entries(task: Task) -> Iterator[PrintedSides]:
    """Yield the sides of equations, entry by entry if they are matrices."""
    says, sign = task.row.says, task.sign
    worked_out = zip(sign.sides, sign.worked_out, strict=True)
    printed = [side for side, is_not in worked_out if not (is_not or side is None)]
    for part in says.parts if isinstance(says, Conjunction) else (says,):
        if not isinstance(part, Equality):
            continue
        one, other = map(_take_out, part.sides)
        are_printed = part.printed in printed, part.rebuilt in printed
        if isinstance(one, sp.MatrixBase) and isinstance(other, sp.MatrixBase):
            pairs = zip(one, other, strict=True) if one.shape == other.shape else ()
            yield from (PrintedSides(pair, are_printed) for pair in pairs)
        elif isinstance(one, sp.Expr) and isinstance(other, sp.Expr):
            yield PrintedSides((one, other), are_printed)


def _take_out(side: sp.Basic) -> sp.Basic:
    """Return a side, or the only entry of a 1x1 matrix."""
    side = write_out(side)
    return side[0] if isinstance(side, sp.MatrixBase) and side.shape == (1, 1) else side


def _list_given(task: Task, others: Sequence[Task]) -> Iterator[sp.Expr]:
    """Yield the residuals of constraints, and derivatives as long as they add letters of a row."""
    letters = list_letters(task)
    for other in others:
        met: set[sp.Basic] = set()
        for one in (other.residual, *other.rates):
            if met and not one.free_symbols & letters - met:
                break
            yield one
            met |= one.free_symbols
