"""Rows beside the constraints of their paper: what follows, what is excused, what is a misprint."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from mechproof.document.applicable_constraints import (
    is_plain,
    is_turned,
    list_applicable,
    may_hold_for,
)
from mechproof.document.checked_rows import CheckedRow, list_standing, make_row
from mechproof.document.consequences import FOLLOWING, GIVEN, SQUARE, list_letters
from mechproof.document.doubted_definitions import leaves_free
from mechproof.document.doubts import (
    CONTRADICTING,
    defines,
    list_printed,
    list_used,
    tell_contradiction,
)
from mechproof.document.judging import Key
from mechproof.document.judging_beside import (
    judge_beside,
    judge_excused,
    judge_freed,
    judge_misprint,
    judge_roots,
)
from mechproof.document.roles import CONSTRAINING, Role
from mechproof.document.slips import WITHIN
from mechproof.document.tasks import Task
from mechproof.proof.verdict import Judgement, State, Verdict
from mechproof.record import Conjunction, Equality
from mechproof.tools.processes import WorkerError, run_tasks

# What may yet follow from constraints.
_UNPROVED = (Verdict.DEFINITION, Verdict.UNDECIDED, Verdict.ENCLOSED)


def follow_from_constraints(
    key: Key, tasks: Sequence[Task], rows: Mapping[int, CheckedRow], limit: float
) -> Iterator[tuple[int, CheckedRow]]:
    """Judge again what is not shown to hold by itself: it may follow from constraints before it."""
    given = [n for n, task in enumerate(tasks) if _is_constraint(task, rows[n])]
    numbers = []
    for n, task in enumerate(tasks):
        common = [g for g in list_applicable(given, n, tasks) if _have_common(tasks[g], task)]
        if common and rows[n].outcome in _UNPROVED and not task.is_claimed:
            numbers.append((key, n, tuple(common)))
    for place, found in run_tasks(judge_beside, numbers, limit=limit):
        number = numbers[place][1]
        if isinstance(found, Judgement):
            yield number, make_row(tasks[number], found)
        elif names := _list_alike(tasks[number], [tasks[g] for g in numbers[place][2]]):
            alone = rows[number].judgement
            if alone and alone.rung == GIVEN:
                reason = f"{alone.reason}; that it follows from {names} was not shown"
                yield number, make_row(tasks[number], replace(alone, reason=reason))


def _list_alike(task: Task, given: Sequence[Task]) -> str:
    """Return the names of constraints that have all letters of another, none for other rows."""
    letters = {letter for one in given for letter in list_letters(one)}
    is_bound = task.sign.role is Role.CONSTRAINT and list_letters(task) <= letters
    return ", ".join(one.row.number for one in given) if is_bound else ""


def excuse_by_constraints(
    key: Key, tasks: Sequence[Task], rows: Mapping[int, CheckedRow], limit: float
) -> Iterator[tuple[int, CheckedRow]]:
    """Judge again two sides that were said to be equal and are not: constraints may make them so.

    Without any that have letters of theirs, and no letter of their own, they are not asked.
    """
    given = [n for n, task in enumerate(tasks) if _is_constraint(task, rows[n])]
    numbers = []
    for n, task in enumerate(tasks):
        common = [g for g in given if _have_common(tasks[g], task) and not tasks[g].is_loose]
        is_refuted = rows[n].outcome == Verdict.REFUTED.value and task.asserts
        if common and is_refuted and not task.is_claimed:
            near = [g for g in given if g < n or may_hold_for(tasks[g], task)]
            numbers.append((key, n, tuple(_connect(n, near, tasks))))
    for place, answer in run_tasks(judge_excused, numbers, limit=limit):
        yield numbers[place][1], make_row(tasks[numbers[place][1]], answer)


def _have_common(one: Task, other: Task) -> bool:
    says = other.row.says
    is_equation = isinstance(says, Equality | Conjunction)
    return is_equation and bool(list_letters(one) & list_letters(other))


def solve_constraints(
    key: Key, tasks: Sequence[Task], rows: Mapping[int, CheckedRow], limit: float
) -> Iterator[tuple[int, CheckedRow]]:
    """Judge again what is printed with a double sign: both may be roots of what is said before.

    Of a constraint behind it, too, if no words between say anything new; of two such prints the
    first does not rest on the second.
    """
    given = [n for n, task in enumerate(tasks) if _is_constraint(task, rows[n])]
    solved = [n for n in given if tasks[n].sign.role is Role.SOLUTIONS]
    asked = [(key, n, tuple(g for g in given if _may_solve(g, n, tasks))) for n in solved]
    for place, found in run_tasks(judge_roots, asked, limit=limit):
        if isinstance(found, Judgement):
            number = asked[place][1]
            yield number, make_row(tasks[number], found)


def _may_solve(given: int, number: int, tasks: Sequence[Task]) -> bool:
    """Return whether a constraint may be one of which a print with a double sign has the roots."""
    one, task = tasks[given], tasks[number]
    is_known = given < number or not (one.said.is_new or one.sign.role is Role.SOLUTIONS)
    return given != number and is_known and may_hold_for(one, task) and _have_common(one, task)


def find_misprints(
    key: Key, tasks: Sequence[Task], rows: Mapping[int, CheckedRow], limit: float
) -> Iterator[tuple[int, CheckedRow]]:
    """Judge what may be a constraint or a misprint.

    One that shows only beside another print that may itself be wrong, or be meant for another
    case, contradicts that print: neither is refuted. That it may be meant for another case is ruled
    out where it comes first and further rows follow from it, and not without it.
    """
    given = [n for n, task in enumerate(tasks) if _is_constraint(task, rows[n])]
    asked = {
        n: tuple(_connect(n, [g for g in given if may_hold_for(tasks[g], task)], tasks))
        for n, task in enumerate(tasks)
        if _may_be_misprint(task, rows[n])
        # Of a letter whose first prints differ nobody knows which is meant.
        and not (task.others and len(list_standing(task, tasks, rows)) > 1)
    }
    found = _accuse(key, [*asked.items()], limit)
    accused = {n: found[place] for place, n in enumerate(asked) if place in found}
    beside = [(n, other) for n in accused for other in asked[n]]
    certain = {
        (n, other)
        for n, other in beside
        if (other in accused and n in asked[other]) or _may_be_special(tasks, n, other)
    }
    rivals = [pair for pair in beside if pair in certain or tasks[pair[1]].is_excused]
    without = [(n, tuple(o for o in asked[n] if o != other)) for n, other in rivals]
    still = _accuse(key, without, limit)
    pairs = [pair for place, pair in enumerate(rivals) if place not in still]
    excused = {(n, other) for n, other in pairs if other < n} - certain
    needed = _find_needed(key, tasks, rows, {other for _, other in excused}, limit)
    pairs = [pair for pair in pairs if not (pair in excused and pair[1] in needed)]
    open_pairs, wrong = _ask_definitions(key, tasks, rows, accused, limit)
    pairs += [*open_pairs, *_list_later(tasks, accused)]
    refuted = accused.keys() - {n for n, _ in pairs} - {*wrong.values()}
    for n in {*accused, *(one for pair in pairs for one in pair)}:
        others = {one for pair in pairs if n in pair for one in pair} - {n}
        names = ", ".join(tasks[other].row.number for other in sorted(others))
        said = f": {accused[n].reason}" if n in accused else ""
        contradicts = f"{tell_contradiction(names)}{said}"
        if n in refuted or n not in wrong.values():
            yield n, make_row(tasks[n], accused[n] if n in refuted else contradicts)
    for m, n in wrong.items():
        yield m, make_row(tasks[m], _charge(rows[m], accused[n], tasks[n].row.number))


def doubt_by_premises(
    key: Key, tasks: Sequence[Task], rows: Mapping[int, CheckedRow], limit: float
) -> Iterator[tuple[int, CheckedRow]]:
    """Leave open what follows only from a row that is refuted, or from several that are contested.

    Of rows that contradict each other one may be right, and none defines a letter of the others.
    """
    bound = [n for n, task in enumerate(tasks) if _binds(task)]
    refuted = {n for n in bound if rows[n].outcome == Verdict.REFUTED.value}
    contested = {n for n in bound if rows[n].outcome == State.NOT_JUDGED.value}
    open_rows = [m for m, row in rows.items() if row.outcome == State.NOT_JUDGED.value]
    defining = [tasks[m] for m in open_rows if tasks[m].sign.role is Role.DEFINITION]
    judged = ((n, row.judgement) for n, row in rows.items() if not tasks[n].follows)
    asked, names = [], {}
    for n in [n for n, found in judged if found and found.rung in FOLLOWING]:
        given = [g for g in list_applicable(bound, n, tasks) if _have_common(tasks[g], tasks[n])]
        doubted = [g for g in given if g in refuted | contested]
        # What is proved itself may be so by these.
        certain = tuple(g for g in given if _may_be_given(tasks[g], rows[g]))
        rivals = {g: _list_denied(n, g, defining, tasks, rows) for g in doubted if g in contested}
        chosen = {(*certain, g): denied for g, denied in rivals.items()}
        chosen = chosen or ({certain: frozenset()} if doubted else {})
        asked += [(key, n, tuple(sorted(one)), denied) for one, denied in chosen.items()]
        names[n] = ", ".join(tasks[g].row.number for g in doubted)
    answers = run_tasks(judge_freed, asked, limit=limit)
    proved = {asked[place][1] for place, found in answers if _is_proof(found)}
    for n in {n for _, n, *_ in asked} - proved:
        reason = f"it follows only with the help of {names[n]}, which may be wrong"
        yield n, make_row(tasks[n], reason)


def _list_denied(
    number: int,
    given: int,
    defining: Sequence[Task],
    tasks: Sequence[Task],
    rows: Mapping[int, CheckedRow],
) -> frozenset[sp.Basic]:
    """List letters of a row and of a premise of it by definitions that the premise contradicts."""
    used = list_used(tasks[number], tasks) | list_used(tasks[given], tasks)
    names = rows[given].reason.partition(CONTRADICTING)[0]
    denied = (one for one in defining if one.row.number in names and defines(one, used))
    return frozenset(one.sign.letter for one in denied if one.sign.letter is not None)


def _ask_definitions(
    key: Key,
    tasks: Sequence[Task],
    rows: Mapping[int, CheckedRow],
    accused: Mapping[int, Judgement],
    limit: float,
) -> tuple[list[tuple[int, int]], dict[int, int]]:
    """Return misprints with the definitions that they contradict, and definitions to blame.

    These stand later, or before words that turn a sense. A definition is to blame that would have
    to be changed if further rows follow from what it contradicts.
    """
    later = [(n, m) for n in accused for m in range(n + 1, len(tasks))]
    later = [(n, m) for n, m in later if _restates(tasks[n], tasks[m])]
    needed = _find_needed(key, tasks, rows, {n for n, _ in later}, limit)
    wrong = {
        m: n
        for n, m in later
        if n in needed and WITHIN in accused[n].reason and not tasks[m].is_case
    }
    turned = [
        (n, m)
        for n in accused
        for m, one in enumerate(tasks)
        if is_turned(one, tasks[n]) and defines(one, list_used(tasks[n], tasks))
    ]
    return [(n, m) for n, m in later if m not in wrong] + turned, wrong


def _restates(task: Task, other: Task) -> bool:
    """Return whether a row is about the same letters as the definition of one of them."""
    letters = list_printed(task)
    return defines(other, letters) and list_printed(other) == letters


def _accuse(
    key: Key, asked: Sequence[tuple[int, tuple[int, ...]]], limit: float
) -> dict[int, Judgement]:
    """Return the places of rows that are misprints beside constraints, with their judgements."""
    answers = run_tasks(judge_misprint, [(key, *one) for one in asked], limit=limit)
    return {place: found for place, found in answers if isinstance(found, Judgement)}


def _may_be_special(tasks: Sequence[Task], number: int, other: int) -> bool:
    """Return whether a constraint may be said of a special position that is no matter of a row.

    It is announced as another case, words between them turn a sense, or it comes later and is an
    equation such as a = b + pi.
    """
    may_equate = other > number or tasks[other].said.is_equating
    is_other = tasks[other].is_case or is_turned(tasks[other], tasks[number])
    is_equal = may_equate and is_plain(tasks[other])
    return is_equal or is_other or tasks[other].sign.role is Role.SOLUTIONS


def _find_needed(
    key: Key,
    tasks: Sequence[Task],
    rows: Mapping[int, CheckedRow],
    others: Collection[int],
    limit: float,
) -> set[int]:
    """Return constraints without which a row does not follow that is shown to follow."""
    given = [n for n, task in enumerate(tasks) if _is_constraint(task, rows[n])]
    following = [n for n, row in rows.items() if row.judgement and row.judgement.rung in FOLLOWING]
    pairs = [(other, n) for other in others for n in following if other < n]
    asked = [(key, n, tuple(g for g in given if g < n and g != other)) for other, n in pairs]
    found = dict(run_tasks(judge_beside, asked, limit=limit))
    # What took too long may follow without it.
    without = {p for p, one in found.items() if isinstance(one, WorkerError) or _is_proof(one)}
    return {other for place, (other, _) in enumerate(pairs) if place not in without}


def _charge(row: CheckedRow, found: Judgement, name: str) -> Judgement | str:
    """Return that a definition is wrong, as an equation shows from which further rows follow."""
    reason = f"it contradicts {name}, from which further rows follow: {found.reason}"
    if row.judgement is None:
        return reason
    verdict, rung, evidence = Verdict.REFUTED, found.rung, found.evidence
    return replace(row.judgement, verdict=verdict, rung=rung, reason=reason, evidence=evidence)


def _is_proof(found: object) -> bool:
    return isinstance(found, Judgement) and found.verdict is Verdict.PROVED


def _list_later(tasks: Sequence[Task], accused: Collection[int]) -> Iterator[tuple[int, int]]:
    """Yield rows that are accused, with what defines their letters after them.

    What says behind a display what its letters mean is no print of its own.
    """
    for n in accused:
        used = list_used(tasks[n], tasks)
        behind = (m for m in range(n + 1, len(tasks)) if not tasks[m].said.is_clause)
        used_later = [m for m in behind if defines(tasks[m], used)]
        yield from ((n, m) for m in used_later if not leaves_free(tasks[m], tasks[n], tasks))


def _may_be_misprint(task: Task, row: CheckedRow) -> bool:
    is_open = row.state is State.NOT_JUDGED or bool(row.judgement and row.judgement.rung == GIVEN)
    is_equation = isinstance(task.row.says, Equality) and task.sign.number in ("", "0")
    is_one_of_two = task.is_solution or (task.is_excused and not task.asserts)
    is_one_of_two |= task.sign.role is Role.SOLUTIONS
    return is_open and is_equation and not (task.is_rounded or is_one_of_two)


def _connect(number: int, given: Sequence[int], tasks: Sequence[Task]) -> Iterator[int]:
    """Yield the constraints that have letters of a row, or of others of them."""
    letters, left = list_letters(tasks[number]), [g for g in given if g != number]
    while tied := [g for g in left if list_letters(tasks[g]) & letters]:
        yield from tied
        letters = letters.union(*(list_letters(tasks[g]) for g in tied))
        left = [g for g in left if g not in tied]


def _is_constraint(task: Task, row: CheckedRow) -> bool:
    return row.outcome == Verdict.DEFINITION.value and _binds(task)


def _may_be_given(task: Task, row: CheckedRow) -> bool:
    """Return whether a row is a constraint, or follows by its square and says which root is."""
    is_square = row.judgement is not None and row.judgement.rung == SQUARE
    return is_square or _is_constraint(task, row)


def _binds(task: Task) -> bool:
    """Return whether a row may be a constraint that others follow from."""
    is_equation = isinstance(task.row.says, Equality) and task.residual is not None
    is_given = task.sign.role in CONSTRAINING and is_equation
    return is_given and not (task.is_rounded or task.is_either or _needs_zeros(task))


def _needs_zeros(task: Task) -> bool:
    r"""Return whether a letter is printed that has to be zero, n=2\pi n: much follows from that."""
    if task.sign.letter is None or any(side == 0 for side in task.sign.sides):
        return False
    rest = sp.factor_terms(task.residual)
    factors = (factor.as_base_exp()[0] for factor in sp.Mul.make_args(rest))
    return all(factor.is_Symbol or factor.is_number for factor in factors)
