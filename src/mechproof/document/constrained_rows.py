"""Rows beside the constraints of their paper: what follows, what is excused, what is a misprint."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from mechproof.document.checked_rows import CheckedRow, list_standing, make_row
from mechproof.document.consequences import COMBINATION, GIVEN, MULTIPLE, list_letters
from mechproof.document.judging import (
    WITH_DEFINITIONS,
    Key,
    holds_alone,
    judge_beside,
    judge_excused,
    judge_misprint,
    judge_roots,
)
from mechproof.document.roles import CONSTRAINING, Role
from mechproof.document.slips import WITHIN
from mechproof.document.tasks import Task
from mechproof.proof.verdict import Judgement, State, Verdict
from mechproof.record import Conjunction, Definition, Equality
from mechproof.tools.processes import WorkerError, run_tasks

# How rows follow from constraints.
_FOLLOWING = (MULTIPLE, COMBINATION)
# What may yet follow from constraints.
_UNPROVED = (Verdict.DEFINITION, Verdict.UNDECIDED, Verdict.ENCLOSED)


def follow_from_constraints(
    key: Key, tasks: Sequence[Task], rows: Mapping[int, CheckedRow], limit: float
) -> Iterator[tuple[int, CheckedRow]]:
    """Judge again what is not shown to hold by itself: it may follow from constraints before it."""
    given = [n for n, task in enumerate(tasks) if _is_constraint(task, rows[n])]
    numbers = []
    for n, task in enumerate(tasks):
        before = [g for g in given if g < n and _may_hold_for(tasks[g], task)]
        common = [g for g in before if _have_common(tasks[g], task)]
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
            numbers.append((key, n, tuple(_connect(n, given, tasks))))
    for place, answer in run_tasks(judge_excused, numbers, limit=limit):
        yield numbers[place][1], make_row(tasks[numbers[place][1]], answer)


def _have_common(one: Task, other: Task) -> bool:
    says = other.row.says
    is_equation = isinstance(says, Equality | Conjunction)
    return is_equation and bool(list_letters(one) & list_letters(other))


def solve_constraints(
    key: Key, tasks: Sequence[Task], rows: Mapping[int, CheckedRow], limit: float
) -> Iterator[tuple[int, CheckedRow]]:
    """Judge again letters that are printed with a double sign: they may be roots."""
    given = [n for n, task in enumerate(tasks) if _is_constraint(task, rows[n])]
    asked = [
        (key, n, tuple(g for g in given if g != n and _have_common(tasks[g], task)))
        for n, task in enumerate(tasks)
        if n in given and task.sign.role is Role.SOLUTIONS
    ]
    for place, found in run_tasks(judge_roots, asked, limit=limit):
        if isinstance(found, Judgement):
            number = asked[place][1]
            yield number, make_row(tasks[number], found)


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
        n: tuple(_connect(n, given, tasks))
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
    pairs += open_pairs
    refuted = accused.keys() - {n for n, _ in pairs} - {*wrong.values()}
    for n in {*accused, *(one for pair in pairs for one in pair)}:
        others = {one for pair in pairs if n in pair for one in pair} - {n}
        names = ", ".join(tasks[other].row.number for other in sorted(others))
        said = f": {accused[n].reason}" if n in accused else ""
        contradicts = f"{_tell_contradiction(names)}{said}"
        if n in refuted or n not in wrong.values():
            yield n, make_row(tasks[n], accused[n] if n in refuted else contradicts)
    for m, n in wrong.items():
        yield m, make_row(tasks[m], _charge(rows[m], accused[n], tasks[n].row.number))


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
        if _is_turned(one, tasks[n]) and _defines(one, _list_used(tasks[n], tasks))
    ]
    return [(n, m) for n, m in later if m not in wrong] + turned, wrong


def find_contradictions(
    tasks: Sequence[Task], rows: Mapping[int, CheckedRow]
) -> Iterator[tuple[int, CheckedRow]]:
    """Accuse neither what is never true beside a definition after it, nor that definition.

    The same is true of any definition, if words before the row announce no consequence, or turn a
    sense.
    """
    for n, task in enumerate(tasks):
        is_beside = _is_refuted(rows[n]) and WITH_DEFINITIONS in rows[n].reason
        letters = _list_printed(task) if is_beside else set[sp.Basic]()
        is_new = task.said.is_new
        others = [m for m, one in enumerate(tasks) if m > n or is_new or _is_turned(one, task)]
        others = [m for m in others if _defines(tasks[m], letters)]
        if names := ", ".join(tasks[m].row.number for m in others):
            yield n, make_row(task, _tell_contradiction(names))
        for m in others:
            yield m, make_row(tasks[m], _tell_contradiction(task.row.number))


def doubt_by_letters(
    tasks: Sequence[Task], rows: Mapping[int, CheckedRow], contested: Mapping[int, CheckedRow]
) -> Iterator[tuple[int, CheckedRow]]:
    """Refute no row by a letter whose definition another print contradicts, or is said of a case.

    `contested` are the misprints, and the rows that contradict each other.
    """
    doubted = [
        tasks[n]
        for n, row in sorted(contested.items())
        if tasks[n].sign.role is Role.DEFINITION
        and (row.state is State.NOT_JUDGED or _is_refuted(row))
    ]
    special = [one for one in tasks if one.said.is_special]
    for n, task in enumerate(tasks):
        letters = _list_used(task, tasks) if _is_refuted(rows[n]) else ()
        of_cases = [] if task.said.is_special else special
        for others, why in ((doubted, "may be wrong itself"), (of_cases, "is said of a case")):
            defining = (one for one in others if one is not task and _defines(one, letters))
            if names := ", ".join(one.row.number for one in defining):
                yield n, make_row(task, f"it differs, but rests on {names}, which {why}")
                break


def doubt_by_positions(
    tasks: Sequence[Task], rows: Mapping[int, CheckedRow]
) -> Iterator[tuple[int, CheckedRow]]:
    """Prove no row by definitions that are said of several positions, unless it needs none."""
    placed = [one for one in tasks if one.said.is_position and one.sign.role is Role.DEFINITION]
    for n, task in enumerate(tasks):
        is_proved = rows[n].outcome == Verdict.PROVED.value
        letters = _list_used(task, tasks) if is_proved and len(placed) > 1 else ()
        used = [one for one in placed if one is not task and _defines(one, letters)]
        if len({one.said.scope for one in used}) > 1 and not holds_alone(task):
            names = ", ".join(one.row.number for one in used)
            reason = f"it holds if {names} hold together: are they said of one case?"
            yield n, make_row(task, reason)


def _is_refuted(row: CheckedRow) -> bool:
    return row.outcome == Verdict.REFUTED.value


def _list_printed(task: Task) -> set[sp.Basic]:
    """Return the letters that stand on the sides of a row."""
    says = task.row.says
    sides = (says.symbol, says.printed) if isinstance(says, Definition) else task.sign.sides
    return {s for side in sides for s in getattr(side, "free_symbols", ())}


def _list_used(task: Task, tasks: Sequence[Task]) -> set[sp.Basic]:
    """Return the letters of a row, and of what defines them."""
    letters, before = _list_printed(task), set[sp.Basic]()
    while letters != before:
        before = letters
        letters = letters.union(*(_list_printed(one) for one in tasks if _defines(one, letters)))
    return letters


def _defines(task: Task, letters: Collection[sp.Basic]) -> bool:
    return task.sign.role is Role.DEFINITION and task.sign.letter in letters


def _tell_contradiction(names: str) -> str:
    return f"it and {names} contradict each other: one is wrong, or of another case"


def _restates(task: Task, other: Task) -> bool:
    """Return whether a row is about the same letters as the definition of one of them."""
    letters = _list_printed(task)
    return _defines(other, letters) and _list_printed(other) == letters


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
    is_plain = (other > number or tasks[other].said.is_equating) and _is_plain(tasks[other])
    is_other = tasks[other].is_case or _is_turned(tasks[other], tasks[number])
    return is_plain or is_other or tasks[other].sign.role is Role.SOLUTIONS


def _may_hold_for(given: Task, task: Task) -> bool:
    """Return whether a constraint is said of what a row is about, as far as words tell.

    A special position is left with the next passage that says something new.
    """
    is_special = given.said.is_equating or task.said.is_general
    is_left = given.said.is_position or (is_special and _is_plain(given))
    is_left &= given.said.scope != task.said.scope
    return not (is_left or _is_turned(given, task))


def _is_plain(task: Task) -> bool:
    """Return whether a constraint makes sums of letters and numbers equal, as a = b + pi.

    That may be multiplied by letters.
    """
    factors = sp.Mul.make_args(sp.factor_terms(task.residual))
    return all(_is_term(term) for factor in factors for term in sp.Add.make_args(factor))


def _is_term(term: sp.Expr) -> bool:
    return bool(term.as_coeff_Mul()[1].is_Symbol or term.is_number)


def _is_turned(one: Task, other: Task) -> bool:
    """Return whether words between two rows turn the sense in which something is counted."""
    return one.said.turns != other.said.turns


def _find_needed(
    key: Key,
    tasks: Sequence[Task],
    rows: Mapping[int, CheckedRow],
    others: Collection[int],
    limit: float,
) -> set[int]:
    """Return constraints without which a row does not follow that is shown to follow."""
    given = [n for n, task in enumerate(tasks) if _is_constraint(task, rows[n])]
    following = [n for n, row in rows.items() if row.judgement and row.judgement.rung in _FOLLOWING]
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
    is_given = row.outcome == Verdict.DEFINITION.value and task.sign.role in CONSTRAINING
    is_equation = isinstance(task.row.says, Equality) and task.residual is not None
    return is_given and is_equation and not (task.is_rounded or task.is_either)
