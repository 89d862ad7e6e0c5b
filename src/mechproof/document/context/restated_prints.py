"""Derivatives compared with another print: one across a heading, or a later one that is proved.

A heading may introduce another mechanism whose letters are not printed anew. If a display has one
correct derivative of a letter, it is about the mechanism for which that letter was printed; so are
the display's other derivatives, of letters printed next to that one, and the letter's later
derivatives after words of a consequence. A derivative with all signs reversed may count in the
other sense: it is left open.

In a closed loop the definition of a position may need an angle that is in no table and in no
velocity; what follows from both gives the position by the crank angle alone.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from mechproof.document.checked_rows import CheckedRow, make_row
from mechproof.document.constraints.consequences import FOLLOWING, GIVEN, is_plain
from mechproof.document.context.constrained_rows import binds
from mechproof.document.judging_workers import Changes, Judging, judge_row, name_equation
from mechproof.document.row_sides import have_same_letters
from mechproof.document.tasks import Role, Task
from mechproof.latex.values import differentiate
from mechproof.nomenclature.symbols import Symbols
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Judgement, State, Verdict
from mechproof.record import Equality


def compare_restated(at: Judging) -> Changes:
    """Compare a derivative that lacks a letter of the first print with the last proved reprint.

    Its task is replaced by one that makes this comparison and rests on the reprint.
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


def describe_unlike(task: Task) -> str:
    """Return the reason why a row that differs from another print of its letter is left open."""
    other, name = task.sign.first or "the member before", name_equation(task.row.number)
    return (
        f"it differs from {other} and has other letters: a constraint, or a misprint? In "
        f"the block of letters, declare constraint {name} or, if it is meant for all their "
        f"values, identity {name}"
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
    if not have_same_letters([*map(task.domain.resolve, sides)]):
        return None
    row = replace(task.row, says=replace(says, rebuilt=value))
    name = name_equation(later.row.number)
    sign = replace(task.sign, first=name, sides=sides)
    return replace(task, row=row, sign=sign, asserts=True, rests_on=(name, describe_unlike(task)))


def _find_rate(one: Task, other: Task, symbols: Symbols) -> sp.Expr | None:
    """Return the derivative that a later print of a letter gives for another row, or None."""
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
    """Leave open a row that rests on a later print that is unproved or may be of a case."""
    for n, task in enumerate(at.tasks):
        name, reason = task.rests_on
        if name and not _holds_in_general(name, at):
            yield n, make_row(task, reason)


def _holds_in_general(name: str, at: Judging) -> bool:
    """Return whether all signs of an equation are proved, and no words show it to be a case."""
    tasks = at.tasks
    own = [n for n, task in enumerate(tasks) if name_equation(task.row.number) == name]
    are_proved = bool(own) and all(at.rows[n].outcome == Verdict.PROVED.value for n in own)
    return are_proved and not any(
        _may_be_case(tasks[m]) or (m not in own and is_plain(tasks[m]))
        for n in own
        for m in (n, *_list_premises(n, at))
    )


def _list_premises(number: int, at: Judging) -> Iterator[int]:
    """Yield the constraints that a row follows from, according to its reason."""
    found = at.rows[number].judgement
    for m, one in enumerate(at.tasks):
        is_used = found is not None and found.rung in FOLLOWING and binds(one)
        if is_used and m != number and one.row.number in at.rows[number].reason:
            yield m


def _may_be_case(task: Task) -> bool:
    said = task.said
    is_special = said.is_special or said.is_position or said.is_equating or bool(task.at)
    return is_special or said.is_case or bool(said.example.number)


def compare_rates(at: Judging) -> Changes:
    """Judge again derivatives that were left open only because a heading comes before them."""
    tasks, rows, asked = at.tasks, at.rows, []
    for n, task in enumerate(tasks):
        if rows[n].state is not State.NOT_JUDGED or not task.is_solution:
            continue
        proved = [m for m, row in rows.items() if row.outcome == Verdict.PROVED.value]
        anew = [one for m, one in enumerate(tasks) if m not in proved]
        if any(_are_together(tasks[m], task, tasks, anew) for m in proved):
            asked.append((n,))
    for (n,), answer in at.ask(judge_rate, asked):
        if isinstance(answer, Judgement):
            yield n, make_row(tasks[n], answer)


def _are_together(one: Task, other: Task, tasks: Sequence[Task], anew: Sequence[Task]) -> bool:
    """Return whether two derivatives, and their letters' first prints, are printed together.

    Together means without words in between, but two derivatives of one print may have words of a
    consequence between them. Nothing is known about letters that are printed `anew`.
    """
    if any(task.sign.role is not Role.DERIVATIVE or task.said.is_case for task in (one, other)):
        return False
    names = one.sign.first, other.sign.first
    first = [t for name in names for t in tasks if t.row.number == name]
    is_near = one.said.passage == other.said.passage
    if names[0] == names[1] and not one.said.is_apart(other.said):
        later = max(one.said, other.said, key=lambda said: said.passage)
        is_near |= not (later.is_new or one.said.is_equating or other.said.is_equating)
    if len(first) != len(names) or not is_near:
        return False
    is_turned = first[1].said.turns != other.said.turns or other.said.is_of_other(first[1].said)
    letters = {x.sign.letter for x in first}
    is_anew = any(t.sign.letter in letters and t.sign.role is Role.REPEATED for t in anew)
    return first[0].said.passage == first[1].said.passage and not (is_turned or is_anew)


def judge_rate(tasks: Sequence[Task], number: int) -> Judgement | None:
    """Return a derivative's refutation by its letter's print; None if it agrees up to its sign."""
    task = tasks[number]
    found, says = judge(task.row, task.paper), task.row.says
    if found.verdict is not Verdict.REFUTED or not isinstance(says, Equality):
        return None
    turned = replace(task.row, says=Equality(says.printed, -says.rebuilt, "member"))
    if judge(turned, task.paper).verdict is not Verdict.REFUTED:
        return None
    return replace(
        found, reason=f"{found.reason.removesuffix('.')}; compared with {task.sign.first}"
    )
