"""Numbers and derivatives compared with a later print of a letter, which has to be proved itself.

Beside a loop the definition of a position may need an angle that no table has, and no velocity
shows; what follows from both gives the position by the angle of the crank alone.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from mechproof.document.checked_rows import CheckedRow, make_row
from mechproof.document.constraints.applicable_constraints import is_plain
from mechproof.document.constraints.consequences import FOLLOWING, GIVEN
from mechproof.document.context.constrained_rows import binds
from mechproof.document.judged_tasks import Changes, Judging
from mechproof.document.judging_workers import judge_row, name_equation
from mechproof.document.row_sides import have_same_letters
from mechproof.document.tasks import Role, Task
from mechproof.latex.values import differentiate
from mechproof.nomenclature.symbols import Symbols
from mechproof.proof.verdict import Judgement, Verdict
from mechproof.record import Equality
from mechproof.statement_domains.domain import Domain


def compare_restated(at: Judging) -> Changes:
    """Compare a derivative that lacks a letter of the first print with the last that is proved.

    Its task is then one that compares it with that, and rests on it.
    """
    tasks, rows, first = at.tasks, at.rows, {}
    for n, task in enumerate(tasks):
        if task.sign.role is Role.DERIVATIVE and _is_open(task, rows[n]):
            proved = (m for m in range(n) if rows[m].outcome == Verdict.PROVED.value)
            for m in proved:
                if one := _compare(task, tasks[m], at.symbols):
                    first[n], tasks[n] = task, one
    for (n,), answer in at.ask(judge_row, [(n,) for n in first]):
        if isinstance(answer, Judgement):
            yield n, make_row(tasks[n], answer)
        else:
            tasks[n] = first[n]


def tell_unlike(task: Task) -> str:
    """Tell that a row differs from another print of its letter, and what it may be."""
    other, name = task.sign.first or "the member before", name_equation(task.row.number)
    return (
        f"it differs from {other} and has other letters: a constraint, or a misprint? If a "
        f"constraint, say constraint {name}; if it is meant for all their values, say so "
        f"in the block of letters: identity {name}"
    )


def _is_open(task: Task, row: CheckedRow) -> bool:
    found = row.judgement
    is_taken = found is not None and found.rung == GIVEN and not task.is_given
    return is_taken and not _may_be_case(task)


def _compare(task: Task, later: Task, symbols: Symbols) -> Task | None:
    """Return a derivative compared with that of a later print, if both have the same letters."""
    value, says = _find_rate(later, task, symbols), task.row.says
    if value is None or not isinstance(says, Equality):
        return None
    sides = says.printed, value
    if not have_same_letters([*map(Domain.of(task.paper, task.row.on).resolve, sides)]):
        return None
    row = replace(task.row, says=replace(says, rebuilt=value))
    name = name_equation(later.row.number)
    sign = replace(task.sign, first=name, sides=sides)
    return replace(task, row=row, sign=sign, asserts=True, rests_on=(name, tell_unlike(task)))


def _find_rate(one: Task, other: Task, symbols: Symbols) -> sp.Expr | None:
    """Return what a later print of a letter makes of the derivative that another row has."""
    letter, sides = one.sign.letter, one.sign.sides
    if one.sign.role is not Role.REPEATED or letter not in sides or other.sign.letter is None:
        return None
    by, steps = symbols.find_steps(letter)
    value = sides[1 - sides.index(letter)]
    if other.sign.letter not in steps or not isinstance(value, sp.Expr):
        return None
    for _ in range(steps.index(other.sign.letter) - steps.index(letter)):
        value = differentiate(value, by, symbols.moving)
    return value


def doubt_by_restated(at: Judging) -> Changes:
    """Leave open what rests on a later print that is not proved, or that may be of a case."""
    for n, task in enumerate(at.tasks):
        name, reason = task.rests_on
        if name and not _holds_in_general(name, at):
            yield n, make_row(task, reason)


def _holds_in_general(name: str, at: Judging) -> bool:
    """Return whether all signs of an equation are proved, and nothing tells that this is a case."""
    tasks = at.tasks
    own = [n for n, task in enumerate(tasks) if name_equation(task.row.number) == name]
    are_proved = bool(own) and all(at.rows[n].outcome == Verdict.PROVED.value for n in own)
    return are_proved and not any(
        _may_be_case(tasks[m]) or (m not in own and is_plain(tasks[m]))
        for n in own
        for m in (n, *_list_premises(n, at))
    )


def _list_premises(number: int, at: Judging) -> Iterator[int]:
    """Yield the constraints that a row follows from, as it says."""
    found = at.rows[number].judgement
    for m, one in enumerate(at.tasks):
        is_used = found is not None and found.rung in FOLLOWING and binds(one)
        if is_used and m != number and one.row.number in at.rows[number].reason:
            yield m


def _may_be_case(task: Task) -> bool:
    said = task.said
    is_special = said.is_special or said.is_position or said.is_equating or bool(task.at)
    return is_special or said.is_case or bool(said.example.number)
