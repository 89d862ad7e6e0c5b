"""Letters that must move though nothing says so, as constraints tie them to moving letters.

If constraints leave no letter free to move while the others are constant, another letter moves,
too. A row differentiated as if it did not is neither proved nor refuted. Nor is a row that is
differentiated or integrated over one letter, or has a value of it put in, while a constraint ties
another letter to that one.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence, Set

import numpy as np
import sympy as sp

from mechproof.document.checked_rows import CheckedRow, make_row
from mechproof.document.constraints.consequences import FOLLOWING, GIVEN, list_letters
from mechproof.document.constraints.witnesses import find_points
from mechproof.document.context.doubts import defines, list_compared, list_printed, reach
from mechproof.document.judging_workers import Changes, Judging
from mechproof.document.tasks import Role, Task
from mechproof.nomenclature.symbols import Symbols
from mechproof.proof.verdict import Verdict
from mechproof.record.parts import TURNING
from mechproof.tools.processes import WorkerError

_COUNT = 4
# Ratio to the largest slope below which a singular value means that a letter is free to move.
_FREE = 1e-9


def doubt_by_motion(at: Judging) -> Changes:
    """Leave open rows with derivatives and a letter that must move but is not said to."""
    tasks, symbols = at.tasks, at.symbols
    groups = [(group, _list_angles(group, tasks, symbols)) for group in _join(at)]
    groups = [(group, angles) for group, angles in groups if angles]
    if not groups:
        return
    rates = _list_rates(symbols)
    asked = [(n, one) for n, one in enumerate(tasks) if _has_rates(one, at.rows[n], rates)]
    moving = tuple(map(str, symbols.moving))
    held = [(group, moving, angles) for group, angles in groups] if asked else []
    for (group, _, angles), answer in at.ask(leave_none_free, held):
        if isinstance(answer, WorkerError) or not answer:
            continue
        for n, task in asked:
            if met := sorted(list_compared(task, tasks) & angles, key=str):
                yield n, make_row(task, _describe(met, [tasks[g] for g in group]))


def doubt_by_stillness(at: Judging) -> Changes:
    """Leave open rows with rates of a letter said to move but given by letters that do not.

    The rates would be zero, so one of the other letters must move, too.
    """
    moving, rates = at.symbols.moving, _list_rates(at.symbols)
    still: dict[sp.Basic, str] = {}
    for one in at.tasks:
        if not defines(one, moving):
            continue
        letter = one.sign.letter
        by, own = moving[letter]
        letters = one.domain.resolve(letter).free_symbols
        if letters and letters.isdisjoint({by, *moving, *rates}):
            may = ", ".join(sorted(f"{s}({by})" for s in letters))
            reason = (
                f"{one.row.number} defines {letter}, which depends on {by}, by others that do not; "
                f"declare in the block of letters which of them do: {may}"
            )
            still |= dict.fromkeys(own, reason)
    for n, task in enumerate(at.tasks if still else ()):
        is_certain = at.rows[n].outcome in (Verdict.PROVED.value, Verdict.REFUTED.value)
        met = list_compared(task, at.tasks) & still.keys() if is_certain else ()
        if met:
            yield n, make_row(task, still[min(met, key=str)])


def doubt_by_ties(at: Judging) -> Changes:
    """Leave open rows that vary one letter and have another that a constraint ties to it."""
    tasks, rows = at.tasks, at.rows
    running = {letter for task in tasks for letter, _ in task.sign.varied}
    ties = {letter: find_ties(letter, at) for letter in running}
    held: dict[sp.Basic, str] = {}
    for n, task in enumerate(tasks):
        letters = list_compared(task, tasks)
        reasons = [held[one] for one in sorted(held.keys() & letters, key=str)]
        found, varied = rows[n].judgement, [by for by, _ in task.sign.varied]
        is_beside = task.sign.role is Role.CONSTRAINT and not task.asserts
        is_beside |= found is not None and found.rung in FOLLOWING
        for by, inside in task.sign.varied:
            if by in task.at and varied.count(by) == 1 and is_beside:
                # Its value was put into the constraints, too.
                continue
            tied, given = ties[by]
            met = tied & reach({at.symbols.find_steps(s)[1][0] for s in inside}, tasks)
            # Letters that the row lacks may move instead, one for each constraint.
            if met and len(tied - letters) < len(given):
                reasons.append(_describe_tie(given, min(map(str, met)), by))
        if reasons and task.sign.role is Role.DEFINITION and task.sign.letter is not None:
            held.setdefault(task.sign.letter, reasons[0])
        is_certain = rows[n].outcome in (Verdict.PROVED.value, Verdict.REFUTED.value)
        if reasons and is_certain and n not in at.placed:
            yield n, make_row(task, reasons[0])


def _describe_tie(given: Sequence[Task], letter: str, by: sp.Basic) -> str:
    names = ", ".join(one.row.number for one in given)
    return (
        f"by {names}, {letter} may change with {by}; declare in the block of letters that it does, "
        f"{letter}({by}), or its value, let {letter}=…"
    )


def find_ties(by: sp.Basic, at: Judging) -> tuple[set[sp.Basic], list[Task]]:
    """Return the letters that constraints tie to `by`, and those constraints."""
    found = [task for n, task in enumerate(at.tasks) if _is_given(task, at.rows[n])]
    left = [task for task in found if not list_letters(task) & _list_rates(at.symbols)]
    reached, tied, given = {by}, set[sp.Basic](), list[Task]()
    while near := [one for one in left if list_letters(one) & reached]:
        left = [one for one in left if one not in near]
        reached = set[sp.Basic]().union(*(_list_running(one, by, at.symbols) for one in near))
        tied |= reached
        given += near
    return tied, given


def _list_running(task: Task, by: sp.Basic, symbols: Symbols) -> set[sp.Basic]:
    """Return the letters of a constraint that may move when `by` does.

    These are letters said to depend on something else, angles, and letters alone on a side.
    """
    residual = sp.sympify(task.residual)
    turning = {s for call in residual.atoms(*TURNING) for s in call.free_symbols}
    sides = [side.free_symbols for side in task.sign.sides if side is not None]
    alone = [letters for letters in sides if len(letters) == 1]

    def may_move(letter: sp.Basic) -> bool:
        if letter in symbols.moving:
            return bool(symbols.moving[letter][0] != by)
        unit = symbols.notation.dimensions.get(letter)
        is_angle = unit.is_angle if unit else letter in turning
        return {letter} in alone or bool(is_angle)

    return {s for s in list_letters(task) - {by} if may_move(s)}


def _is_given(task: Task, row: CheckedRow) -> bool:
    """Return whether a row is a constraint that is not said of one case only."""
    is_given = row.judgement is not None and row.judgement.rung == GIVEN
    is_given &= task.sign.role is not Role.VALUE and task.residual is not None
    return is_given and not task.said.is_equating


def _describe(letters: Sequence[sp.Basic], group: Sequence[Task]) -> str:
    names = ", ".join(one.row.number for one in group)
    which = ", ".join(f"{letter}(t)" for letter in letters)
    return (
        f"given {names}, nothing moves unless other letters do; if these depend on time, declare "
        f"that in the block of letters: {which}"
    )


def _has_rates(task: Task, row: CheckedRow, rates: Collection[sp.Basic]) -> bool:
    is_certain = row.outcome in (Verdict.PROVED.value, Verdict.REFUTED.value)
    return is_certain and bool(task.sign.printed & {*rates})


def _join(at: Judging) -> list[tuple[int, ...]]:
    """Return groups of constraints with moving letters, joined where they share a letter."""
    groups: list[tuple[set[int], set[sp.Basic]]] = []
    for n, task in enumerate(at.tasks):
        letters = _list_moving(task, at.rows[n], at.symbols)
        if letters and _has_own_angle(n, at.tasks, at.symbols):
            continue
        near = [group for group in groups if letters and group[1] & letters]
        groups = [group for group in groups if group not in near]
        if letters:
            numbers = {n}.union(*(group[0] for group in near))
            groups.append((numbers, letters.union(*(group[1] for group in near))))
    return [tuple(sorted(numbers)) for numbers, _ in groups]


def _has_own_angle(number: int, tasks: Sequence[Task], symbols: Symbols) -> bool:
    """Return whether a constraint has an angle that no other row has: that angle then moves."""
    printed = (list_printed(one) | one.sign.printed for n, one in enumerate(tasks) if n != number)
    return bool(_list_angles((number,), tasks, symbols) - set[sp.Basic]().union(*printed))


def _list_moving(task: Task, row: CheckedRow, symbols: Symbols) -> set[sp.Basic]:
    """Return a constraint's moving letters; none if it has derivatives or belongs to a case."""
    if not _is_given(task, row):
        return set()
    letters = list_letters(task)
    return set() if letters & _list_rates(symbols) else letters & symbols.moving.keys()


def _list_rates(symbols: Symbols) -> set[sp.Basic]:
    return {rate for _, steps in symbols.moving.values() for rate in steps}


def _list_angles(group: Sequence[int], tasks: Sequence[Task], symbols: Symbols) -> set[sp.Basic]:
    """Return the angles of constraints that are not said to move."""
    letters = {s for n in group for s in sp.sympify(tasks[n].residual).free_symbols}
    known = symbols.notation.dimensions
    running = {by for by, _ in symbols.moving.values()}
    still = letters - symbols.moving.keys() - running
    return {s for s in still if s in known and known[s].is_angle}


def leave_none_free(
    all_tasks: Sequence[Task], numbers: Sequence[int], names: Sequence[str], _: Set[sp.Basic]
) -> bool:
    """Return whether constraints fix the moving letters at a point where the constraints hold."""
    tasks = [all_tasks[n] for n in numbers]
    residuals = [sp.sympify(task.residual) for task in tasks]
    letters = {s for one in residuals for s in one.free_symbols}
    moving = sorted((s for s in letters if str(s) in names), key=str)
    slopes = sp.Matrix(residuals).jacobian(moving)
    for point in find_points(residuals, letters, tasks[0].domain, _COUNT):
        there = np.array(slopes.xreplace(point).evalf().tolist(), dtype=float)
        least = _FREE * np.abs(there).max()
        return bool(np.linalg.matrix_rank(there, tol=least) == len(moving))
    return False
