"""Which constraints apply to a row, as far as words tell.

What makes letters equal at a special position no longer holds after the next words that say
something new. What is printed again with other signs, behind other words, holds instead of the
first print.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from mechproof.document.tasks import Task
from mechproof.latex.values import settle_all
from mechproof.record import Definition


def list_applicable(given: Sequence[int], number: int, tasks: Sequence[Task]) -> list[int]:
    """List the constraints before a row that hold for it."""
    task = tasks[number]
    before = [g for g in given if g < number and may_hold_for(tasks[g], task)]
    before = [g for g in before if not is_left(tasks[g], task)]
    return _leave_out_restated(before, tasks)


def state_at(given: Sequence[Task], task: Task) -> Iterator[Task]:
    """Yield constraints at the values of letters that are said of a row.

    What is said under a condition that is none of the row is left out.
    """
    for one in given:
        if one.residual is not None and _list_conditions(one) <= _list_conditions(task):
            rests = (sp.sympify(rest) for rest in (one.residual, *one.rates))
            residual, *rates = (settle_all(rest, task.at) for rest in rests)
            if not residual.has(sp.nan, sp.zoo, sp.oo) and sp.expand(residual) != 0:
                yield replace(one, residual=residual, rates=tuple(rates))


def _list_conditions(task: Task) -> set[object]:
    on, said = task.row.on, {sp.Eq(*one, evaluate=False) for one in task.at.items()}
    return {*said, *on.where, *on.within.items()} if on else {*said}


def is_turned(one: Task, other: Task) -> bool:
    """Return whether words between two rows turn the sense in which something is counted."""
    return one.said.turns != other.said.turns


def may_hold_for(given: Task, task: Task) -> bool:
    """Return whether a constraint is said of what a row is about, as far as words tell.

    A special position is left with the next passage that says something new.
    """
    is_special = given.said.is_equating or task.said.is_general
    is_left = given.said.is_position or (is_special and is_plain(given))
    is_left &= given.said.scope != task.said.scope
    return not (is_left or is_turned(given, task) or is_of_another_example(given, task))


def is_of_another_example(one: Task, other: Task) -> bool:
    """Return whether a row is printed in a worked example in which another one is not."""
    return one.said.example.number not in (0, other.said.example.number)


def holds_elsewhere(one: Task, other: Task) -> bool:
    """Return whether what introduces a letter in a worked example gives it in that only."""
    given = (v.given for v in other.paper.variables if v.symbol == one.sign.letter)
    return is_of_another_example(one, other) and not any(value is not None for value in given)


def is_left(given: Task, task: Task) -> bool:
    """Return whether letters made equal may differ behind the next words that say something new."""
    return is_bare(given) and given.said.scope != task.said.scope


def is_bare(task: Task) -> bool:
    """Return whether a row makes letters of one meaning equal, or a letter a number, and no more.

    Letters that are declared in one line have one meaning. Those of two are equal by a law.
    """
    says = task.row.says
    one, other = (says.symbol, says.printed) if isinstance(says, Definition) else task.sign.sides
    meanings = {v.symbol: v.meaning for v in task.paper.variables}
    own = meanings.get(_find_letter(one)) or meanings.get(_find_letter(other))
    return bool(own) and all(
        isinstance(side, sp.Expr) and (side.is_number or meanings.get(_find_letter(side)) == own)
        for side in (one, other)
    )


def _find_letter(side: sp.Basic | None) -> sp.Basic | None:
    """Return the letter that a side is, or of which it is the opposite."""
    if not isinstance(side, sp.Expr):
        return None
    return next((one for one in (side, -side) if one.is_Symbol), None)


def _leave_out_restated(given: Sequence[int], tasks: Sequence[Task]) -> list[int]:
    """Leave out constraints that are printed again behind other words, with other signs."""
    terms = [_list_terms(tasks[g]) for g in given]
    return [
        g
        for place, g in enumerate(given)
        if not any(
            terms[place] == own and tasks[g].said.passage != tasks[later].said.passage
            for later, own in zip(given[place + 1 :], terms[place + 1 :], strict=True)
        )
    ]


def _list_terms(task: Task) -> frozenset[sp.Expr]:
    """Return the terms of a constraint but for their signs."""
    terms = sp.Add.make_args(task.residual)
    return frozenset(-t if t.could_extract_minus_sign() else t for t in terms)


def is_plain(task: Task) -> bool:
    """Return whether a constraint makes sums of letters and numbers equal, as a = b + pi.

    Both sides may have been multiplied or divided by letters.
    """
    one, other = task.sign.sides
    is_printed = isinstance(one, sp.Expr) and isinstance(other, sp.Expr)
    above, _ = sp.fraction(sp.together(one - other if is_printed else task.residual))
    factors = (f.as_base_exp()[0] for f in sp.Mul.make_args(sp.factor_terms(above)))
    terms = (term for factor in factors for term in sp.Add.make_args(factor))
    return all(term.as_coeff_Mul()[1].is_Symbol or term.is_number for term in terms)
