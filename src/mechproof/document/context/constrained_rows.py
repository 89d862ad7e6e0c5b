"""Rows judged by the constraints of their paper: what follows, and what constraints excuse."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from mechproof.document.checked_rows import CheckedRow, make_row
from mechproof.document.constraints.consequences import (
    FOLLOWING,
    GIVEN,
    SQUARE,
    list_applicable,
    list_letters,
    may_hold_for,
)
from mechproof.document.context.doubts import CONTRADICTING, defines, list_used
from mechproof.document.context.judging_by_constraints import (
    judge_by_constraints,
    judge_excused,
    judge_half,
    judge_roots,
)
from mechproof.document.judging_workers import Changes, Judging
from mechproof.document.tasks import CONSTRAINING, Role, Task
from mechproof.proof.verdict import Judgement, State, Verdict
from mechproof.record import Conjunction, Equality

# Rung of a step of a chain that is taken as a constraint, as further rows follow from it.
SUPPORTED = "constraint"
# Verdicts of rows that are not proved on their own, and are tried with constraints.
_UNPROVED = (Verdict.DEFINITION, Verdict.UNDECIDED, Verdict.ENCLOSED)


def follow_from_constraints(at: Judging) -> Changes:
    """Judge rows again that are not proved on their own: they may follow from earlier constraints.

    A step of a chain may be such a row, i=n_1/n_2=z_2/z_1; so may a print that differs from a
    definition but may be another case of it, or a claimed identity that does not hold on its own.
    """
    asked, proved = _ask_what_follows(at), set[int]()
    while asked:
        for n, row in _follow(at, asked):
            is_proof = row.outcome == Verdict.PROVED.value
            if is_proof or not proved:
                yield n, row
            proved |= {n} if is_proof else set()
        # With the proved rows left out, a smaller set of constraints may let another row follow.
        fewer = {n: tuple(g for g in given if g not in proved) for n, given in asked.items()}
        asked = {n: x for n, x in fewer.items() if x and n not in proved and x != asked[n]}


def _ask_what_follows(at: Judging) -> dict[int, tuple[int, ...]]:
    """Return the rows that are not proved on their own, with the constraints before each."""
    tasks, rows, asked = at.tasks, at.rows, {}
    given = [n for n, task in enumerate(tasks) if _may_be_premise(task, rows[n])]
    for n, task in enumerate(tasks):
        common = [g for g in list_applicable(given, n, tasks) if _have_common(tasks[g], task)]
        is_left = task.is_solution and rows[n].outcome == State.NOT_JUDGED.value
        is_open = rows[n].outcome in _UNPROVED or is_left
        is_false = rows[n].outcome == Verdict.REFUTED.value
        if common and (is_false if task.is_claimed else is_open):
            asked[n] = tuple(common)
    return asked


def _follow(at: Judging, asked: Mapping[int, tuple[int, ...]]) -> Changes:
    """Judge rows by constraints; name those from which a new constraint was not shown to follow."""
    for (n, given), found in at.ask(judge_by_constraints, [*asked.items()]):
        task, alone = at.tasks[n], at.rows[n].judgement
        if isinstance(found, Judgement):
            is_settled = task.is_claimed or not alone
            if found.verdict is Verdict.PROVED or not is_settled:
                yield n, make_row(task, found)
            continue
        names = _list_alike(task, [at.tasks[g] for g in given])
        if names and alone and alone.rung == GIVEN:
            reason = f"{alone.reason}; it was not shown to follow from {names}"
            yield n, make_row(task, replace(alone, reason=reason))


def support_steps(at: Judging) -> Changes:
    """Take a step of a chain for a constraint if further rows follow from it."""
    for n, task in enumerate(at.tasks):
        alone = at.rows[n].judgement
        if not (alone and alone.rung == GIVEN and task.sign.role is Role.STEP and binds(task)):
            continue
        if names := ", ".join(at.rows[m].name for m in list_following(n, at)):
            reason = f"a constraint, taken as given, used to show that {names} holds"
            yield n, make_row(task, replace(alone, rung=SUPPORTED, reason=reason))


def list_following(number: int, at: Judging) -> Iterator[int]:
    """Yield the rows whose reasons say that they follow from a row."""
    for n, row in at.rows.items():
        is_shown = row.judgement is not None and row.judgement.rung in FOLLOWING
        if is_shown and at.tasks[number].row.number in row.reason:
            yield n


def _list_alike(task: Task, given: Sequence[Task]) -> str:
    """Return the names of the constraints if they have all letters of another, else ""."""
    letters = {letter for one in given for letter in list_letters(one)}
    is_printed = task.sign.role is Role.CONSTRAINT and not task.sign.is_tied
    is_bound = is_printed and list_letters(task) <= letters
    return ", ".join(one.row.number for one in given) if is_bound else ""


def excuse_by_constraints(at: Judging) -> Changes:
    """Judge two sides again that were claimed equal and are not: constraints may make them so.

    Only rows that share letters with a constraint are judged again, and constraints that a letter
    of their own can always satisfy are ignored.
    """
    tasks, rows = at.tasks, at.rows
    given = [n for n, task in enumerate(tasks) if is_constraint(task, rows[n])]
    # An equation that a letter of its own can always satisfy says nothing about other rows.
    given = [g for g in given if not tasks[g].is_loose]
    numbers = []
    for n, task in enumerate(tasks):
        common = [g for g in given if _have_common(tasks[g], task)]
        is_refuted = rows[n].outcome == Verdict.REFUTED.value and task.asserts
        if common and is_refuted and not task.is_claimed:
            near = [g for g in given if g < n or may_hold_for(tasks[g], task)]
            numbers.append((n, tuple(connect(n, near, tasks))))
    for (n, _), answer in at.ask(judge_excused, numbers):
        yield n, make_row(tasks[n], answer)


def _have_common(one: Task, other: Task) -> bool:
    says = other.row.says
    is_equation = isinstance(says, Equality | Conjunction)
    return is_equation and bool(list_letters(one) & list_letters(other))


def solve_constraints(at: Judging) -> Changes:
    """Judge prints with a double sign again: both values may be roots of earlier constraints.

    A later constraint counts, too, if no words in between say anything new; of two such prints the
    first does not rest on the second.
    """
    tasks, rows = at.tasks, at.rows
    given = [n for n, task in enumerate(tasks) if is_constraint(task, rows[n])]
    solved = [n for n in given if tasks[n].sign.role is Role.SOLUTIONS]
    asked = [(n, tuple(g for g in given if _may_solve(g, n, tasks))) for n in solved]
    roots = {n: one for (n, _), one in at.ask(judge_roots, asked) if isinstance(one, Judgement)}
    solved_rows = {n: make_row(tasks[n], one) for n, one in roots.items()}
    yield from solved_rows.items()
    yield from _judge_halves(replace(at, rows={**rows, **solved_rows}))


def _judge_halves(at: Judging) -> Changes:
    """Judge definitions of one of two letters that were printed together before, x_{1,2}.

    The ties of the two letters are left open if the joint print is refuted.
    """
    tasks, asked = at.tasks, dict[int, int]()
    for n, task in enumerate(tasks):
        if not task.sign.is_tied:
            continue
        pair = next(m for m, one in enumerate(tasks) if one.row.number == task.sign.first)
        if at.rows[pair].outcome == Verdict.REFUTED.value:
            yield n, make_row(task, f"it comes from {tasks[pair].row.number}, which is refuted")
            continue
        halves = task.sign.sides[0].free_symbols
        after = [m for m in range(n, len(tasks)) if defines(tasks[m], halves)]
        asked |= {m: pair for m in after if may_hold_for(tasks[pair], tasks[m])}
    for (m, _), found in at.ask(judge_half, [*asked.items()]):
        if isinstance(found, Judgement):
            yield m, make_row(tasks[m], found)


def _may_solve(given: int, number: int, tasks: Sequence[Task]) -> bool:
    """Return whether a constraint may be the one whose roots are printed with a double sign."""
    one, task = tasks[given], tasks[number]
    is_known = given < number or not (one.said.is_new or one.sign.role is Role.SOLUTIONS)
    is_known &= given != number and one.sign.first != task.row.number
    return is_known and may_hold_for(one, task) and _have_common(one, task)


def doubt_by_premises(at: Judging) -> Changes:
    """Leave open what follows only from a refuted row, or only from contested rows.

    One of several rows that contradict each other may be right: a row stays proved if it also
    follows with one of them, without the definitions that this one contradicts.
    """
    tasks, rows = at.tasks, at.rows
    bound = [n for n, task in enumerate(tasks) if binds(task)]
    refuted = {n for n in bound if rows[n].outcome == Verdict.REFUTED.value}
    contested = {n for n in bound if rows[n].outcome == State.NOT_JUDGED.value}
    open_rows = [m for m, row in rows.items() if row.outcome == State.NOT_JUDGED.value]
    defining = [tasks[m] for m in open_rows if tasks[m].sign.role is Role.DEFINITION]
    judged = ((n, row.judgement) for n, row in rows.items() if not tasks[n].follows)
    asked, names = [], {}
    for n in [n for n, found in judged if found and found.rung in FOLLOWING]:
        given = [g for g in list_applicable(bound, n, tasks) if _have_common(tasks[g], tasks[n])]
        doubted = [g for g in given if g in refuted | contested]
        # A row that follows from a step of a chain names it.
        said = [g for g in doubted if tasks[g].row.number in rows[n].reason]
        doubted = [g for g in doubted if g in said or tasks[g].sign.role is not Role.STEP]
        # A proved constraint may itself rest on the doubted rows. A row that follows by its
        # square says which root is meant.
        squares = {g for g in given if (row := rows[g].judgement) and row.rung == SQUARE}
        certain = tuple(g for g in given if g in squares or is_constraint(tasks[g], rows[g]))
        rivals = {g: _list_denied(n, g, defining, at) for g in doubted if g in contested}
        chosen = {(*certain, g): denied for g, denied in rivals.items()}
        chosen = chosen or ({certain: frozenset()} if doubted else {})
        asked += [(n, tuple(sorted(one)), denied) for one, denied in chosen.items()]
        names[n] = ", ".join(tasks[g].row.number for g in doubted)
    proved = {n for (n, *_), found in at.ask(judge_by_constraints, asked) if is_proof(found)}
    for n in {n for n, *_ in asked} - proved:
        reason = f"it follows only with the help of {names[n]}, which may be wrong"
        yield n, make_row(tasks[n], reason)


def _list_denied(
    number: int, given: int, defining: Sequence[Task], at: Judging
) -> frozenset[sp.Basic]:
    """List the letters of a row and its premise whose definitions the premise contradicts."""
    used = set[sp.Basic]().union(*(list_used(at.tasks[n], at.tasks) for n in (number, given)))
    names = at.rows[given].reason.partition(CONTRADICTING)[0]
    denied = (one for one in defining if one.row.number in names and defines(one, used))
    return frozenset(one.sign.letter for one in denied if one.sign.letter is not None)


def is_proof(found: object) -> bool:
    """Return whether an answer proves its row."""
    return isinstance(found, Judgement) and found.verdict is Verdict.PROVED


def connect(number: int, given: Sequence[int], tasks: Sequence[Task]) -> Iterator[int]:
    """Yield constraints that share letters with a row, directly or through other constraints."""
    letters, left = list_letters(tasks[number]), [g for g in given if g != number]
    while tied := [g for g in left if list_letters(tasks[g]) & letters]:
        yield from tied
        letters = letters.union(*(list_letters(tasks[g]) for g in tied))
        left = [g for g in left if g not in tied]


def is_constraint(task: Task, row: CheckedRow) -> bool:
    """Return whether a row is taken as given.

    A step of a chain counts only if the block says so or further rows follow from it.
    """
    is_supported = row.judgement is not None and row.judgement.rung == SUPPORTED
    is_supported |= task.is_given
    return _may_be_constraint(task, row) and (task.sign.role is not Role.STEP or is_supported)


def _may_be_constraint(task: Task, row: CheckedRow) -> bool:
    return row.outcome == Verdict.DEFINITION.value and binds(task)


def _may_be_premise(task: Task, row: CheckedRow) -> bool:
    """Return whether a row is taken as given, or is shown to follow as the block says."""
    is_shown = bool(task.follows) and row.outcome == Verdict.PROVED.value
    return _may_be_constraint(task, row) or (is_shown and binds(task))


def binds(task: Task) -> bool:
    """Return whether a row may be a constraint that others follow from."""
    is_equation = isinstance(task.row.says, Equality) and task.residual is not None
    is_given = task.sign.role in (*CONSTRAINING, Role.STEP) and is_equation
    is_open = task.is_rounded or task.is_either or task.is_indexed
    return is_given and not (is_open or _needs_zeros(task))


def _needs_zeros(task: Task) -> bool:
    r"""Return whether a print forces some letter to be zero, n=2\pi n: much follows from that."""
    if task.sign.letter is None or any(side == 0 for side in task.sign.sides):
        return False
    rest = sp.factor_terms(task.residual)
    factors = (factor.as_base_exp()[0] for factor in sp.Mul.make_args(rest))
    return all(factor.is_Symbol or factor.is_number for factor in factors)
