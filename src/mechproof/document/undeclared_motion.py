"""Letters that move, though nobody says so: constraints tie them to letters that do.

If with the others constant constraints leave no letter free to move, another one moves, too. What
is differentiated as if it did not is neither proved nor refuted.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence

import numpy as np
import sympy as sp

from mechproof.document.checked_rows import CheckedRow, make_row
from mechproof.document.consequences import GIVEN
from mechproof.document.doubts import list_compared
from mechproof.document.judging import Key, open_tasks
from mechproof.document.symbols import Symbols
from mechproof.document.tasks import Task
from mechproof.document.witnesses import find_points
from mechproof.proof.domain import Domain
from mechproof.proof.verdict import Verdict
from mechproof.tools.processes import WorkerError, run_tasks

_COUNT = 4
# What a singular value is to the largest slope where a letter is free to move.
_FREE = 1e-9


def doubt_by_motion(
    key: Key,
    tasks: Sequence[Task],
    rows: Mapping[int, CheckedRow],
    symbols: Symbols,
    limit: float,
) -> Iterator[tuple[int, CheckedRow]]:
    """Leave open what has derivatives and a letter that has to move and is not said to."""
    groups = [(group, _list_angles(group, tasks, symbols)) for group in _join(tasks, rows, symbols)]
    groups = [(group, angles) for group, angles in groups if angles]
    if not groups:
        return
    rates = _list_rates(symbols)
    asked = [(n, one) for n, one in enumerate(tasks) if _has_rates(one, rows[n], rates)]
    moving = tuple(map(str, symbols.moving))
    held = [(key, group, moving) for group, _ in groups] if asked else []
    for place, answer in run_tasks(leave_none_free, held, limit=limit):
        group, angles = groups[place]
        if isinstance(answer, WorkerError) or not answer:
            continue
        for n, task in asked:
            if met := sorted(list_compared(task, tasks) & angles, key=str):
                yield n, make_row(task, _tell(met, [tasks[g] for g in group]))


def _tell(letters: Sequence[sp.Basic], group: Sequence[Task]) -> str:
    names = ", ".join(one.row.number for one in group)
    which = ", ".join(f"{letter}(t)" for letter in letters)
    return (
        f"beside {names} nothing moves unless further letters do; if these depend on time, say so "
        f"in the block of letters: {which}"
    )


def _has_rates(task: Task, row: CheckedRow, rates: Collection[sp.Basic]) -> bool:
    is_certain = row.outcome in (Verdict.PROVED.value, Verdict.REFUTED.value)
    return is_certain and bool(task.sign.printed & {*rates})


def _join(
    tasks: Sequence[Task], rows: Mapping[int, CheckedRow], symbols: Symbols
) -> list[tuple[int, ...]]:
    """Return the constraints that have letters that move, those together that share one."""
    groups: list[tuple[set[int], set[sp.Basic]]] = []
    for n, task in enumerate(tasks):
        letters = _list_moving(task, rows[n], symbols)
        near = [group for group in groups if letters and group[1] & letters]
        groups = [group for group in groups if group not in near]
        if letters:
            numbers = {n}.union(*(group[0] for group in near))
            groups.append((numbers, letters.union(*(group[1] for group in near))))
    return [tuple(sorted(numbers)) for numbers, _ in groups]


def _list_moving(task: Task, row: CheckedRow, symbols: Symbols) -> set[sp.Basic]:
    """Return the letters of a constraint that move; none of one of derivatives, or of a case."""
    found = row.judgement
    if not (found and found.rung == GIVEN and task.residual is not None) or task.said.is_equating:
        return set()
    letters = task.residual.free_symbols
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


def leave_none_free(which: tuple[Key, tuple[int, ...], tuple[str, ...]]) -> bool:
    """Return whether constraints hold what moves where it is, at a point at which they hold."""
    key, numbers, names = which
    tasks = [open_tasks(key)[n] for n in numbers]
    residuals = [sp.sympify(task.residual) for task in tasks]
    domain = Domain.of(tasks[0].paper, tasks[0].row.on)
    letters = {s for one in residuals for s in one.free_symbols}
    moving = sorted((s for s in letters if str(s) in names), key=str)
    slopes = sp.Matrix(residuals).jacobian(moving)
    for point in find_points(residuals, letters, domain, _COUNT):
        there = np.array(slopes.xreplace(point).evalf().tolist(), dtype=float)
        least = _FREE * np.abs(there).max()
        return bool(np.linalg.matrix_rank(there, tol=least) == len(moving))
    return False
