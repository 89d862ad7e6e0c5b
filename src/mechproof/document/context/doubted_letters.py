"""Rows that rest on letters whose definition may be wrong, belong to a case, or come later.

A row that is true or false whatever those letters are does not rest on their definitions. A row
that may not belong to a worked example is not proved or refuted by the values printed there, as
words do not always show where an example ends. Undeclared letters that may be matrices are read
as numbers, which commute and have no inverse but 1/x, so that rows with them are left open.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

import sympy as sp

from mechproof.document.checked_rows import CheckedRow, make_row
from mechproof.document.constraints.consequences import find_consequence, holds_elsewhere
from mechproof.document.constraints.following import list_all_entries
from mechproof.document.constraints.given_roots import list_radicands
from mechproof.document.context.doubts import (
    ROUNDING,
    defines,
    list_compared,
    list_printed,
    list_used,
    reach,
)
from mechproof.document.judging_workers import (
    COMPARED,
    Changes,
    Judging,
    judge_special,
    judge_without,
)
from mechproof.document.row_sides import write_out
from mechproof.document.tasks import CONSTRAINING, Role, Task
from mechproof.nomenclature.shown_letters import is_vector
from mechproof.nomenclature.symbols import Symbols
from mechproof.proof.ladder import decide
from mechproof.proof.verdict import Judgement, State, Verdict
from mechproof.record import Equality
from mechproof.statement_domains.domain import EMPTY

# Why a row with the same letters on both sides is left open.
EITHER = (
    "the two sides differ, though they have the same letters: a misprint, or a constraint? Say "
    "which in the block of letters: identity, or constraint"
)
_OPEN = (Verdict.UNDECIDED.value, Verdict.ENCLOSED.value)


def doubt_by_letters(at: Judging) -> Changes:
    """Refute no row by a letter whose definition may be wrong or may hold in one case only.

    A definition that is printed later may belong to another case, so no condition is proved by one,
    either. Rows that such definitions leave undecided, or give other letters, may be decided
    without them.
    """
    tasks, rows = at.tasks, at.rows
    doubted = [*_list_doubted(at)]
    free = [n for n in rows if n not in at.contested or rows[n].state is not State.NOT_JUDGED]
    found = {n: one for n in free if (one := _find_doubts(n, at, doubted))}
    asked = [(n, _list_letters(one, at.symbols)) for n, one in found.items()]
    for (n, _), answer in at.ask(judge_without, asked):
        is_open = rows[n].outcome in _OPEN or rows[n].state is State.NOT_JUDGED
        (others, why), *_ = found[n]
        names = ", ".join(one.row.number for one in others)
        if isinstance(answer, Judgement) and (is_open or answer.verdict is Verdict.REFUTED):
            reason = f"{answer.reason}; this does not rest on {names}"
            yield n, make_row(tasks[n], replace(answer, reason=reason))
        elif not is_open:
            first = "it differs" if rows[n].outcome == Verdict.REFUTED.value else "it holds"
            yield n, make_row(tasks[n], f"{first}, but rests on {names}, which {why}")


def _list_doubted(at: Judging) -> Iterator[Task]:
    """Yield definitions that are refuted, ill-formed, or may be wrong."""
    unfit = {n: row for n, row in at.rows.items() if row.outcome == Verdict.ILL_FORMED.value}
    for n, row in sorted({**at.contested, **unfit}.items()):
        is_wrong = row.outcome in (Verdict.REFUTED.value, Verdict.ILL_FORMED.value)
        task, is_open = at.tasks[n], row.state is State.NOT_JUDGED
        if task.sign.role is Role.DEFINITION and (is_wrong or is_open):
            yield task


def _find_doubts(number: int, at: Judging, doubted: Sequence[Task]) -> list[tuple[list[Task], str]]:
    """Return groups of doubted definitions on which a row rests, each with the reason."""
    tasks, task, outcome = at.tasks, at.tasks[number], at.rows[number].outcome
    is_condition = task.sign.role is Role.RELATION and outcome == Verdict.PROVED.value
    is_compared = task.sign.role in COMPARED and not task.is_solution
    # A definition of another case may be what leaves the letters no values.
    is_empty = at.rows[number].reason.endswith(EMPTY)
    is_open = outcome in _OPEN or (outcome == State.NOT_JUDGED.value and is_compared) or is_empty
    if not (outcome == Verdict.REFUTED.value or is_open or is_condition):
        return []
    letters = list_used(task, tasks)
    special = [one for one in tasks if one.said.is_special and not task.said.is_special]
    special = [one for one in special if defines(one, letters)]
    own = [one for one in special if one in tasks[:number] and _introduces(one, tasks)]
    if not task.said.is_general and len({one.said.scope for one in own}) == 1:
        special = [one for one in special if one not in own]
    after = [one for one in tasks[number + 1 :] if one.said.passage > task.said.passage]
    after = [one for one in after if not one.said.is_clause]
    if not (is_condition or is_empty):
        after = [one for one in after if not leaves_free(one, task, tasks)]
    groups = (
        (doubted, "may be wrong itself"),
        (special, "is about a special case"),
        (
            [one for one in after if one.said.is_new],
            "is printed later, perhaps for a special case",
        ),
        (after, "is printed later, and may be wrong itself"),
    )
    others = [one for one in tasks if one is not task and not holds_elsewhere(one, task)]
    found = ([one for one in g if one in others and defines(one, letters)] for g, _ in groups)
    return [(used, why) for used, (_, why) in zip(found, groups, strict=True) if used]


def _introduces(one: Task, tasks: Sequence[Task]) -> bool:
    """Return whether a definition is its letter's first print; later ones then share its case."""
    return all(one.sign.letter not in list_printed(other) for other in tasks[: tasks.index(one)])


def _list_letters(
    groups: Sequence[tuple[list[Task], str]], symbols: Symbols
) -> frozenset[sp.Basic]:
    """Return the letters that groups of definitions define, with their derivatives."""
    letters = {one.sign.letter for used, _ in groups for one in used}
    return frozenset(x for s in letters if s is not None for x in symbols.find_rates(s))


def leaves_free(one: Task, task: Task, tasks: Sequence[Task]) -> bool:
    """Return whether a definition gives its letter in terms of a letter that a row lacks.

    Then the row is about any value of the letter, and does not rest on the definition.
    """
    others = [other for other in tasks if other is not one]
    bound = {s for other in others if other.sign.role in CONSTRAINING for s in list_printed(other)}
    used = reach(list_printed(task) | task.sign.printed, others) | reach(bound, others)
    return bool(list_printed(one) - used - {one.sign.letter})


def doubt_by_examples(at: Judging) -> Changes:
    """Leave open refuted or differing rows that hold at the values of an example.

    Within the example, so are rows that may hold at its values.
    """
    asked = [(n, "local") for n, task in enumerate(at.tasks) if _may_be_local(task, at.rows[n])]
    for (n, _), answer in at.ask(judge_special, asked):
        task = at.tasks[n]
        found = answer.verdict.value if isinstance(answer, Judgement) else None
        holds = found == Verdict.PROVED.value
        if task.local and (holds or (task.said.example.number and found in _OPEN)):
            said = ", ".join(f"{s} = {value}" for s, value in task.local.at.items())
            verb = "holds" if holds else "may hold"
            reason = f"it {verb} for {said}, which is printed in a worked example: is that meant?"
            yield n, make_row(task, reason)


def _may_be_local(task: Task, row: CheckedRow) -> bool:
    """Return whether an unproved row says something else at the values of an example."""
    is_open = row.state is State.NOT_JUDGED and task.sign.role in COMPARED
    is_open |= row.outcome == Verdict.REFUTED.value
    return is_open and task.local is not None and task.local.row.says != task.row.says


def doubt_by_matrices(at: Judging) -> Changes:
    """Neither prove nor refute rows with letters that are shown the way matrices are."""
    shown = at.matrices
    for n, task in enumerate(at.tasks):
        outcome = at.rows[n].outcome
        if outcome not in (Verdict.PROVED.value, Verdict.REFUTED.value) or not shown:
            continue
        named = (one for one in at.tasks if one is task or one.row.number in at.rows[n].reason)
        letters = set[sp.Basic]().union(*(list_compared(one, at.tasks) for one in named))
        if met := sorted(letters & shown.keys(), key=str):
            holds, letter = "holds" if outcome == Verdict.PROVED.value else "differs", met[0]
            kind, size = ("vector", "3x1") if is_vector(shown[letter]) else ("matrix", "3x3")
            reason = (
                f"it {holds} if {letter} is a number: is it a {kind}, as {shown[letter]} suggests? "
                f"Declare it in the block of letters: {letter} {size} : its meaning, or "
                f"{letter} : number"
            )
            yield n, make_row(task, reason)


def doubt_by_frames(at: Judging) -> Changes:
    """Accuse no derivative of a vector that may be taken in a rotating frame.

    It then differs from the derivative of the entries by a cross product with the vector.
    """
    asked = []
    for n, task in enumerate(at.tasks):
        if task.sign.role is Role.DERIVATIVE and at.rows[n].outcome == Verdict.REFUTED.value:
            _, steps = at.symbols.find_steps(task.sign.letter)
            asked += [(n, before) for before, rate in pairwise(steps) if rate == task.sign.letter]
    for (n, _), is_turned in at.ask(_may_turn, asked):
        if is_turned is True:
            reason = (
                f"it differs from the derivative of the entries of {at.tasks[n].sign.first} by a "
                "vector perpendicular to these: is it the derivative in a rotating frame?"
            )
            yield n, make_row(at.tasks[n], reason)


def _may_turn(tasks: Sequence[Task], number: int, before: sp.Basic) -> bool:
    """Return whether a print differs from a vector's derivative at right angles to the vector."""
    task = tasks[number]
    domain, says = task.domain, task.row.says
    vector = write_out(domain.resolve(before))
    if not (isinstance(says, Equality) and isinstance(vector, sp.MatrixBase) and vector.cols == 1):
        return False
    one, other = (write_out(domain.resolve(side)) for side in says.sides)
    across = Equality(vector.dot(one - other), sp.S.Zero, "member")
    return decide(across, domain).verdict is Verdict.PROVED


def doubt_by_lengths(at: Judging) -> Changes:
    """Accuse no row that holds where a sum of squares is 1: words may say so of a length."""
    refuted = Verdict.REFUTED.value
    asked = [(n,) for n, row in at.rows.items() if row.outcome == refuted or row.reason == EITHER]
    for (n,), said in at.ask(_describe_length, asked):
        if isinstance(said, str) and said:
            yield n, make_row(at.tasks[n], said)


def _describe_length(tasks: Sequence[Task], number: int) -> str:
    """Say that a row holds if a vector of its letters has length 1; return "" if it does not."""
    task = tasks[number]
    entries = [one for one in list_all_entries(task, ()) if one.residual != 0]
    for base in list_radicands(sp.sympify(one.residual) for one in entries):
        unit = replace(task, residual=base - 1, rates=())
        found = (find_consequence(one, [unit]) for one in entries)
        if all(one and one[0] is Verdict.PROVED for one in found):
            said = f"{sp.latex(base)}=1"
            return f"it holds where {said}; if that is meant, print that equation first"
    return ""


def doubt_by_rounded(at: Judging) -> Changes:
    """Leave open a refuted matrix if rounded decimals in definitions may explain the difference."""
    rounded = [one for one in at.tasks if one.is_rounded or one.sign.is_calculated]
    for n, task in enumerate(at.tasks):
        if at.rows[n].outcome != Verdict.REFUTED.value or not rounded:
            continue
        used = list_used(task, at.tasks)
        names = [one.row.number for one in rounded if one is not task and defines(one, used)]
        if names and _differ_little(task):
            reason = (
                f"it differs only as much as the rounded decimals of {', '.join(names)} may explain"
            )
            yield n, make_row(task, reason)


def _differ_little(task: Task) -> bool:
    """Return whether the coefficients of a difference are small compared with those of a side."""
    says = task.row.says
    if not isinstance(says, Equality):
        return False
    one, other = (write_out(task.domain.resolve(side)) for side in says.sides)
    if not all(isinstance(x, sp.MatrixBase) for x in (one, other)) or one.shape != other.shape:
        return False
    return bool(_find_largest(one - other) < ROUNDING * _find_largest(other))


def _find_largest(matrix: sp.MatrixBase) -> Any:
    """Return the largest absolute coefficient of a term of an entry."""
    terms = (sp.expand(entry).as_coefficients_dict() for entry in matrix)
    return max((abs(factor) for one in terms for factor in one.values()), default=0)
