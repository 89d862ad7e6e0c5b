"""Rows after a newer print of a letter, which may be of another case.

It is not known which of the prints they mean. A verdict stands if both prints give it; with several
letters reprinted, a refutation stands only if every choice of their prints refutes. A row that
holds by the newer print alone is proved if no words, or only words of a consequence, lie between;
otherwise it is left open. A print that differs, but solves the same equation, is another root.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations
from typing import Any

import sympy as sp

from mechproof.document.checked_rows import CheckedRow, make_row
from mechproof.document.constraints.consequences import FOLLOWING, is_bare, is_of_another_example
from mechproof.document.context.doubts import (
    is_later_case,
    is_left_case,
    is_linear,
    list_printed,
    list_used,
)
from mechproof.document.judging_workers import (
    COMPARED,
    Changes,
    Judging,
    judge_without,
)
from mechproof.document.tasks import Role, Task
from mechproof.latex.values import list_reached
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Judgement, State, Verdict
from mechproof.record import Equality, list_given
from mechproof.record.statements import list_letters

_CERTAIN = (Verdict.PROVED, Verdict.REFUTED)
# Work limit: number of newer prints up to which all combinations are tried.
_MANY = 4


def find_roots(at: Judging) -> Changes:
    """Leave open a print of a letter that is another root of an equation printed for it.

    The new value of the letter is kept with its task.
    """
    tasks, rows, asked = at.tasks, at.rows, []
    for n, task in enumerate(tasks):
        letter, sides = task.sign.letter, task.sign.sides
        is_other = rows[n].outcome == Verdict.REFUTED.value and task.sign.role is Role.REPEATED
        if letter not in sides or not is_other or task.is_claimed:
            continue
        value = sides[1 - sides.index(letter)]
        given = (m for m, one in enumerate(tasks) if one.sign.role is Role.CONSTRAINT)
        asked += [(m, {letter: value}, n) for m in given if _has_roots(tasks[m], letter)]
    for (m, values, n), answer in at.ask(judge_root, asked):
        if isinstance(answer, Judgement) and _is_root(answer, rows[m]):
            task, letter = tasks[n], tasks[n].sign.letter
            tasks[n] = replace(task, anew=dict.fromkeys(at.symbols.find_rates(letter)) | values)
            reason = f"it differs from {task.sign.first}, but also solves {tasks[m].row.number}"
            yield n, make_row(task, reason)


def _has_roots(task: Task, letter: sp.Basic) -> bool:
    """Return whether an equation contains a letter and is not linear in it."""
    one, other = task.sign.sides
    is_met = task.residual is not None and letter in list_printed(task)
    return is_met and not is_linear(one - other, letter)


def _is_root(answer: Judgement, row: CheckedRow) -> bool:
    """Return whether an equation is true with another value, or as undecided as with the first."""
    found = row.judgement
    is_alike = found is not None and (found.verdict, found.rung) == (answer.verdict, answer.rung)
    return answer.verdict is Verdict.PROVED or (is_alike and answer.verdict is Verdict.UNDECIDED)


def judge_root(
    tasks: Sequence[Task], number: int, values: Mapping[sp.Basic, Any], _: int
) -> Judgement | str:
    """Judge an equation with another value of a letter; one true with any value has no roots."""
    task = tasks[number]
    found = _judge_with(task, values)
    any_value = {s: x + sp.sqrt(7) for s, x in values.items() if isinstance(x, sp.Expr)}
    free = _judge_with(task, any_value) if any_value else ""
    is_free = isinstance(free, Judgement) and free.verdict is Verdict.PROVED
    return "it is true with any value" if is_free else found


def compare_newer_prints(at: Judging) -> Changes:
    """Judge again rows that rest on a letter printed anew before them, with the new print.

    Rows left open because they are contested stay open.
    """
    tasks, rows, asked = at.tasks, at.rows, []
    for n, task in enumerate(tasks):
        newer = [m for m in range(n) if tasks[m].anew and rows[m].state is State.NOT_JUDGED]
        newer = [m for m in newer if not is_of_another_example(tasks[m], task)]
        letters = list_letters(task.row.statement) | task.sign.printed
        used = list_reached(letters, list_given(task.paper.variables)) if newer else ()
        newer = _list_last([m for m in newer if tasks[m].anew.keys() & {*used}], tasks)
        is_said = task.is_claimed or task.follows
        is_open = n in at.contested and rows[n].state is State.NOT_JUDGED
        if newer and rows[n].outcome == Verdict.PROVED.value:
            is_open |= rows[n].reason.endswith(f"compared with {tasks[newer[-1]].row.number}")
        differs = rows[n].state is State.NOT_JUDGED and task.sign.role in COMPARED
        is_compared = rows[n].outcome in _CERTAIN or differs
        if newer and is_compared and not (is_said or is_open):
            asked.append((n, tuple(newer)))
    refuted = [(n, before) for n, before in asked if rows[n].outcome == Verdict.REFUTED.value]
    some = [(n, part) for n, before in refuted for part in _list_parts(before)]
    found = {one: x for one, x in at.ask(judge_anew, asked + some) if isinstance(x, Judgement)}
    for n, before in asked:
        others = [found.get((m, part)) for m, part in some if m == n]
        is_doubted = any(one and one.verdict is not Verdict.REFUTED for one in others)
        own = None if is_doubted else found.get((n, before))
        if chosen := _choose(tasks[n], rows[n], own, [tasks[m] for m in before]):
            yield n, make_row(tasks[n], chosen)


def _list_parts(newer: Sequence[int]) -> Iterator[tuple[int, ...]]:
    """Yield the proper subsets of newer prints: other letters may be meant as first printed."""
    if len(newer) <= _MANY:
        for count in range(1, len(newer)):
            yield from combinations(newer, count)


def _list_last(newer: Sequence[int], tasks: Sequence[Task]) -> list[int]:
    """Keep the last new print of each letter."""
    last = {symbol: m for m in newer for symbol in tasks[m].anew}
    return sorted({*last.values()})


def _choose(
    task: Task, row: CheckedRow, found: Judgement | None, newer: Sequence[Task]
) -> Judgement | str | None:
    """Return what replaces a row's verdict, or None if the verdict stands."""
    is_proved = row.outcome == Verdict.PROVED.value
    # A row that repeats the new print is judged a definition.
    is_same = found is not None and found.verdict is Verdict.DEFINITION and is_proved
    if is_same or (found and found.verdict == row.outcome):
        return None
    names = ", ".join(one.row.number for one in newer)
    last, said = newer[-1].said, task.said
    goes_on = not said.is_new or said.passage == last.passage
    is_proof = found is not None and found.verdict is Verdict.PROVED and goes_on
    if found and (is_proof or _is_convicted(task, row, found, newer[-1])):
        return replace(found, reason=f"{found.reason}, by {names}")
    if row.judgement is None:
        return None
    first = "it holds" if is_proved else "it differs"
    redefine = "redefines" if len(newer) == 1 else "redefine"
    return f"{first} with the first definition of what {names} {redefine}: which one is meant?"


def _is_convicted(task: Task, row: CheckedRow, found: Judgement, last: Task) -> bool:
    """Return whether a derivative is refuted by a print just before it that is of the same case.

    It must be a print of what it is the derivative of: one of other letters leaves it as open as
    the first print does.
    """
    said, own = last.said, task.sign.letter in last.anew
    is_open = row.judgement is None and found.verdict is Verdict.REFUTED
    is_beside = task.said.is_clause or not task.said.is_new or task.said.passage == said.passage
    is_rate = task.sign.role is Role.DERIVATIVE and own
    return is_open and is_rate and is_beside and not said.is_apart(task.said)


def doubt_by_cases(at: Judging) -> Changes:
    """Leave open what is proved only by a definition that may be of another case."""
    tasks, rows, asked = at.tasks, at.rows, dict[int, list[int]]()
    for n, task in enumerate(tasks):
        found = rows[n].judgement
        is_proved = found and found.verdict is Verdict.PROVED and found.rung not in FOLLOWING
        is_said = task.is_claimed or task.follows or task.sign.role is Role.RELATION
        used = list_used(task, tasks) if is_proved and not is_said else ()
        cases = [m for m in range(n + 1, len(tasks)) if is_later_case(tasks[m], task, used)]
        cases += [m for m in range(n) if is_left_case(tasks[m], task, used)]
        cases = [m for m in cases if not is_of_another_example(tasks[m], task)]
        if cases:
            asked[n] = cases
    without = [(n, frozenset(tasks[m].sign.letter for m in others)) for n, others in asked.items()]
    for (n, _), answer in at.ask(judge_without, without):
        if not (isinstance(answer, Judgement) and answer.verdict is Verdict.PROVED):
            others = asked[n]
            names = ", ".join(tasks[m].row.number for m in others)
            why = (
                "printed later, perhaps for a special case"
                if others[0] > n
                else "perhaps about a special case"
            )
            reason = f"it holds, but rests on {names}, which is {why}"
            if is_bare(tasks[others[0]]):
                said = tasks[others[0]].row.printed_latex
                reason = f"{reason}; if it holds here, too, add let {said} to the block of letters"
            yield n, make_row(tasks[n], reason)


def judge_anew(tasks: Sequence[Task], number: int, newer: Sequence[int]) -> Judgement | str:
    """Judge a row by the newer prints of letters, or return why it is not judged."""
    task, anew = tasks[number], dict[sp.Basic, Any]()
    for m in newer:
        anew |= tasks[m].anew
    says, own = task.row.says, anew.get(task.sign.letter)
    if task.sign.role is Role.DERIVATIVE and isinstance(says, Equality) and own is not None:
        return judge(replace(task.row, says=replace(says, rebuilt=own)), task.paper)
    return _judge_with(task, anew)


def _judge_with(task: Task, anew: Mapping[sp.Basic, Any]) -> Judgement | str:
    """Judge a row with other values of letters, None for a letter without a value."""
    given = task.give_values(anew)
    return judge(given.row, given.paper) if given else "the value of the first print is put in"
