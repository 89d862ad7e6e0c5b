"""Doubted verdicts: a definition may be wrong or of another case, or cases may be mixed."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from dataclasses import replace

import sympy as sp

from mechproof.document.checked_rows import CheckedRow, make_row
from mechproof.document.constraints.consequences import is_left, is_turned
from mechproof.document.judging_workers import Changes, Judging
from mechproof.document.tasks import CONSTRAINING, Role, Task
from mechproof.document.where_true import WITH_DEFINITIONS, holds_alone
from mechproof.latex.characters import write_plain
from mechproof.nomenclature.shown_letters import name_symbol
from mechproof.proof.verdict import Left, State, Verdict
from mechproof.proof.wellformed import DIMENSIONS
from mechproof.record import Definition, Equality
from mechproof.record.parts import find_free

# Largest relative difference that rounding to two digits explains.
ROUNDING = sp.Rational(1, 100)
CONTRADICTING = " contradict each other"
_NUMBER = re.compile(r"\d+(?:(?:\.|\{,\})\d+)?")
# Numbers from 100 up with a prime factor above 5 may convert units, as 254 does; formulas of
# strength and stiffness have factors such as 64, 192 or 384.
_LARGE, _PRIME = 100, 5


def find_contradictions(at: Judging) -> Changes:
    """Leave open a row that contradicts a later definition of its letters, and that definition.

    An earlier definition counts, too, if words in front of the row say something new or reverse a
    sense.
    """
    for n, task in enumerate(at.tasks):
        is_beside = _is_refuted(at.rows[n]) and WITH_DEFINITIONS in at.rows[n].reason
        letters = list_printed(task) | task.sign.printed if is_beside else set[sp.Basic]()
        is_new = task.said.is_new
        others = [m for m, one in enumerate(at.tasks) if m > n or is_new or is_turned(one, task)]
        others = [m for m in others if defines(at.tasks[m], letters)]
        if names := ", ".join(at.tasks[m].row.number for m in others):
            yield n, make_row(task, describe_contradiction(names))
        for m in others:
            yield m, make_row(at.tasks[m], describe_contradiction(task.row.number))


def find_other_solutions(at: Judging) -> Changes:
    """Leave open a constraint and a later definition of one of its letters by all the others.

    The definition is its solution, or one of the two is wrong: together they would tie the other
    letters. A constraint that makes a letter zero although an earlier definition gives it a value
    may be of another case.
    """
    for n, task in enumerate(at.tasks):
        is_given = at.rows[n].outcome == Verdict.DEFINITION.value
        is_given |= _is_refuted(at.rows[n]) and task.said.is_new
        is_given &= task.sign.role in CONSTRAINING and isinstance(task.row.says, Equality)
        if not is_given or task.residual in (None, 0):
            continue
        letters, (one, other) = list_printed(task), task.sign.sides
        is_zero = _says_zero(task.residual)
        for m in range(0 if is_zero else n + 1, len(at.tasks)):
            is_solved = defines(at.tasks[m], letters) and list_printed(at.tasks[m]) == letters
            is_beside = at.tasks[m].said.passage == task.said.passage
            is_beside |= not (task.is_case or at.tasks[m].is_case)
            letter = at.tasks[m].sign.letter
            if not (is_solved and is_linear(one - other, letter)):
                continue
            if m < n:
                at.tasks[n] = replace(task, anew=_solve(one - other, letter, at))
                yield n, make_row(task, describe_contradiction(at.tasks[m].row.number))
            elif is_beside:
                yield n, make_row(task, describe_contradiction(at.tasks[m].row.number))
                yield m, make_row(at.tasks[m], describe_contradiction(task.row.number))


def _solve(rest: sp.Expr, letter: sp.Basic, at: Judging) -> dict[sp.Basic, sp.Expr | None]:
    """Return the value that a linear equation gives a letter; its derivatives are then unknown."""
    above = sp.Poly(sp.fraction(sp.together(rest))[0], letter)
    value = -above.coeff_monomial(1) / above.coeff_monomial(letter)
    return {**dict.fromkeys(at.symbols.find_rates(letter)), letter: value}


def _says_zero(residual: sp.Expr) -> bool:
    """Return whether a constraint says that a product of letters is zero."""
    factors = (one.as_base_exp()[0] for one in sp.Mul.make_args(sp.cancel(residual)))
    return all(one.is_Symbol or one.is_number for one in factors)


def doubt_by_indices(at: Judging) -> Changes:
    """Leave open an ill-formed equation between members of families whose index nothing binds."""
    for n, task in enumerate(at.tasks):
        if at.rows[n].outcome == Verdict.ILL_FORMED.value and (free := _list_indices(task)):
            names = ", ".join(sorted(map(str, free)))
            reason = f"it seems to hold for each {names}: members of a family are judged separately"
            yield n, make_row(task, reason)


def _list_indices(task: Task) -> set[sp.Basic]:
    """Return the letters of indices on both sides that are not letters of the paper."""
    says = task.row.says
    sides = says.sides if isinstance(says, Equality) else ()
    sides = (says.printed, says.symbol) if isinstance(says, Definition) else sides
    indices = [
        {
            i
            for s in find_free(side)
            if isinstance(s, sp.Indexed)
            for i in sp.Tuple(*s.indices).free_symbols
        }
        # SymPy counts the members of a sum among its free symbols, but not its index.
        & find_free(side)
        for side in sides
    ]
    common = set.intersection(*indices) if indices else set()
    return common - {v.symbol for v in task.paper.variables}


def doubt_by_decimals(at: Judging) -> Changes:
    """Leave open an exact print that differs little from an earlier one with a rounded decimal."""
    rounded = {task.row.number for task in at.tasks if task.is_rounded}
    for n, task in enumerate(at.tasks):
        says, first = task.row.says, task.sign.first
        is_compared = _is_refuted(at.rows[n]) and first in rounded and not task.is_rounded
        if not (is_compared and isinstance(says, Equality)):
            continue
        one, other = (task.domain.resolve(side) for side in says.sides)
        if not all(isinstance(side, sp.Expr) for side in (one, other)) or other == 0:
            continue
        ratio = sp.cancel(one / other)
        if ratio.is_number and abs(ratio - 1) < ROUNDING:
            yield n, make_row(task, f"it differs from {first} only as much as rounding may explain")


def doubt_by_rates(at: Judging) -> Changes:
    """Leave open a refuted derivative printed again after words that say something new."""
    rates = [n for n, task in enumerate(at.tasks) if task.sign.role is Role.DERIVATIVE]
    for n in rates:
        task = at.tasks[n]
        if not (_is_refuted(at.rows[n]) and task.said.is_new):
            continue
        before = [
            at.tasks[m].row.number
            for m in rates
            if m < n
            and at.rows[m].outcome == Verdict.PROVED.value
            and at.tasks[m].sign.letter == task.sign.letter
            and at.tasks[m].said.passage != task.said.passage
        ]
        if before:
            reason = f"it differs from {before[-1]}, which has the same derivative: another case?"
            yield n, make_row(task, reason)


def doubt_conditions(at: Judging) -> Changes:
    """Leave open a refuted condition of a case, which may hold outside the letters' domain."""
    for n, task in enumerate(at.tasks):
        if task.sign.role is Role.RELATION and task.said.is_case and _is_refuted(at.rows[n]):
            reason = "it is never true in the ranges of its letters: a condition of another case?"
            yield n, make_row(task, reason)


def doubt_by_factors(at: Judging) -> Changes:
    """Leave an equation's dimensions open if one of its numbers may convert units, as 254 does.

    In an equation of numerical values, letters are numbers in units of their own.
    """
    for n, task in enumerate(at.tasks):
        found = at.rows[n].judgement
        if found is None or found.rung != DIMENSIONS or found.verdict is not Verdict.ILL_FORMED:
            continue
        numbers = _NUMBER.findall(task.row.printed_latex)
        if odd := next(filter(_is_odd, numbers), None):
            shown = odd.replace("{,}", ",")
            yield n, make_row(task, f"{found.reason}: does {shown} have a unit?")


def _is_odd(number: str) -> bool:
    """Return whether a number is a decimal, or at least 100 with a prime factor above 5."""
    if not number.isdigit():
        return True
    return int(number) >= _LARGE and max(sp.primefactors(int(number))) > _PRIME


def doubt_by_positions(at: Judging) -> Changes:
    """Leave open a row proved by definitions for several positions, unless it needs none."""
    placed = [one for one in at.tasks if one.said.is_position and one.sign.role is Role.DEFINITION]
    for n, task in enumerate(at.tasks):
        is_proved = at.rows[n].outcome == Verdict.PROVED.value
        letters = list_used(task, at.tasks) if is_proved and len(placed) > 1 else ()
        used = [one for one in placed if one is not task and defines(one, letters)]
        if len({one.said.scope for one in used}) > 1 and not holds_alone(task):
            names = ", ".join(one.row.number for one in used)
            reason = f"it holds only if {names} hold together: are they about the same case?"
            yield n, make_row(task, reason)


def doubt_by_unread(at: Judging) -> Changes:
    """Leave open a row if an unread equation in between may redefine one of its letters."""
    unread = _list_unread(at.found)
    for n, task in enumerate(at.tasks):
        is_certain = at.rows[n].outcome in (Verdict.PROVED.value, Verdict.REFUTED.value)
        if not (is_certain and unread):
            continue
        letters = list_compared(task, at.tasks)
        named = [defines(one, letters) and _name_plain(str(one.sign.letter)) for one in at.tasks]
        between = [x for place, name, x in unread if place <= n and name in named[:place]]
        if names := ", ".join(left.number for left in between):
            first = "it differs" if _is_refuted(at.rows[n]) else "it holds"
            reason = f"{first}, but {names}, not read, may redefine one of its letters"
            yield n, make_row(task, reason)


def _list_unread(found: Sequence[Task | Left]) -> list[tuple[int, str, Left]]:
    """List unread equations: the number of rows before each, its left side's name, and itself."""
    unread, place = [], 0
    for one in found:
        if isinstance(one, Task):
            place += 1
        elif one.state is State.NOT_READ and "=" in one.printed_latex:
            unread.append((place, _name_plain(one.printed_latex.partition("=")[0].strip()), one))
    return unread


def _name_plain(latex: str) -> str:
    """Return a letter's name; a look-alike from another alphabet counts as the same letter."""
    return name_symbol(write_plain(latex))


def _is_refuted(row: CheckedRow) -> bool:
    return row.outcome == Verdict.REFUTED.value


def list_printed(task: Task) -> set[sp.Basic]:
    """Return the letters that occur on the sides of a row."""
    says = task.row.says
    sides = (says.symbol, says.printed) if isinstance(says, Definition) else task.sign.sides
    return {s for side in sides for s in getattr(side, "free_symbols", ())}


def list_used(task: Task, tasks: Sequence[Task]) -> set[sp.Basic]:
    """Return the letters of a row and, repeatedly, of the definitions of its letters."""
    return reach(list_printed(task) | task.sign.printed, tasks)


def reach(letters: Collection[sp.Basic], tasks: Sequence[Task]) -> set[sp.Basic]:
    """Return letters with those of their definitions, repeatedly."""
    letters, before = {*letters}, set[sp.Basic]()
    while letters != before:
        before = letters
        letters = letters.union(*(list_printed(one) for one in tasks if defines(one, letters)))
    return letters


def list_compared(task: Task, tasks: Sequence[Task]) -> set[sp.Basic]:
    """Return the letters used by a row and by the row that it is compared with."""
    compared = [one for one in tasks if one.row.number == task.sign.first]
    return set[sp.Basic]().union(*(list_used(one, tasks) for one in (task, *compared)))


def defines(task: Task, letters: Collection[sp.Basic]) -> bool:
    """Return whether a row defines one of some letters."""
    return task.sign.role is Role.DEFINITION and task.sign.letter in letters


def is_later_case(one: Task, task: Task, used: Collection[sp.Basic]) -> bool:
    """Return whether a row defines one of `used` after words that may announce a case."""
    said = one.said
    may_tell = said.is_new and (said.is_case or said.is_equating)
    is_later = said.passage > task.said.passage and not said.is_clause
    return defines(one, used) and may_tell and is_later


def is_left_case(one: Task, task: Task, used: Collection[sp.Basic]) -> bool:
    """Return whether a row defines one of `used` in a case that the text has since left."""
    is_before = one.said.passage < task.said.general
    return defines(one, used) and ((one.said.is_equating and is_before) or is_left(one, task))


def describe_contradiction(names: str) -> str:
    """Return the reason why a row and others cannot all be true of one case."""
    return f"it and {names}{CONTRADICTING}: one of them is wrong or about another case"


def is_linear(expression: sp.Expr, letter: sp.Basic | None) -> bool:
    """Return whether an equation is solved for a letter by a division."""
    above = sp.fraction(sp.together(expression))[0]
    return bool(above.is_polynomial(letter)) and sp.degree(above, letter) == 1
