r"""Values at a place, `x|_{\varphi=0}`, where constraints tie other letters to the letter put in.

With $l\sin\beta=r\sin\varphi$ and $-\pi/2<\beta<\pi/2$ there is one angle $\beta$ where
$\varphi=0$. A letter that may have another value there, as in the other assembly of a loop, is not
solved for.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence, Set
from dataclasses import replace

import sympy as sp

from mechproof.document.checked_rows import make_row
from mechproof.document.constraints.consequences import list_applicable, list_letters, state_at
from mechproof.document.context.constrained_rows import connect, is_constraint
from mechproof.document.context.undeclared_motion import find_ties
from mechproof.document.judging_workers import Changes, Judging
from mechproof.document.row_sides import have_same_letters
from mechproof.document.tasks import Role, Task
from mechproof.latex.sides import INVERSES
from mechproof.latex.values import list_reached
from mechproof.nomenclature.symbols import Symbols
from mechproof.proof.equation_ladder import ContradictionError
from mechproof.proof.judge import judge
from mechproof.proof.ladder import decide
from mechproof.proof.signs import is_nonzero
from mechproof.proof.verdict import Judgement, Verdict
from mechproof.record import Equality, RecordError
from mechproof.record.substitution import resolve
from mechproof.statement_domains.domain import Domain

# Roles of rows that a condition printed after them may restrict to one place.
_CONDITIONED = (Role.REPEATED, Role.DERIVATIVE)
_BESIDE = "constraints may change a letter next to the value: is the value meant for"

Values = dict[sp.Basic, sp.Expr]


def compare_at_places(at: Judging) -> Changes:
    """Judge values at a place, with tied letters solved for there, or give a reason why not.

    The print that is compared with the value must have no letter that moves with the one put in.
    Rows left open because they are contested stay open.
    """
    changed = {n: row for n, row in _compare_at_places(at) if n not in at.contested}
    at.placed.update(changed)
    yield from changed.items()


def _compare_at_places(at: Judging) -> Changes:
    tasks, rows, symbols = at.tasks, at.rows, at.symbols
    given = [n for n, task in enumerate(tasks) if is_constraint(task, rows[n])]
    met = {s for n in given for s in list_letters(tasks[n])}
    asked = []
    for n, task in enumerate(tasks):
        values = dict(_list_put_in(task, symbols))
        running = values.keys() - _find_places(task).keys()
        moving = {
            letter for letter in met & symbols.moving.keys() if symbols.moving[letter][0] in running
        }
        tied = _list_tied(task, moving, at)
        is_apart = _is_apart(task, tied, symbols)
        if tied and is_apart and rows[n].outcome != Verdict.PROVED.value:
            before = tuple(connect(n, list_applicable(given, n, tasks), tasks))
            asked.append((n, before, tied, values))
        elif tied & moving and not is_apart:
            yield n, make_row(task, f"{_BESIDE} {_write(_find_places(task))}?")
    for (n, others, tied, _), found in at.ask(judge_at_place, asked):
        if isinstance(found, Judgement):
            yield n, make_row(tasks[n], found)
        elif rows[n].outcome == Verdict.DEFINITION.value:
            yield n, make_row(tasks[n], _describe(tasks[n], [tasks[o] for o in others], tied))


def _list_put_in(task: Task, symbols: Symbols) -> Iterator[tuple[sp.Basic, sp.Expr]]:
    """Yield the values of constraint letters at a place; for an angle omega t, that of the time."""
    for letter, value in _find_places(task).items():
        given, by = resolve(letter, task.paper.given), symbols.find_steps(letter)[0]
        slope = sp.diff(given, by)
        if given == letter:
            yield letter, value
        elif slope != 0 and not slope.has(by):
            yield by, sp.cancel((value - given.xreplace({by: sp.S.Zero})) / slope)


def _list_tied(task: Task, moving: Set[sp.Basic], at: Judging) -> frozenset[sp.Basic]:
    """Return the letters, with derivatives, that constraints tie to the letters put in.

    Letters said to depend on these are included. Empty for a row that has no tied letter.
    """
    places = {*_find_places(task)}
    if not (places and task.residual is not None and isinstance(task.row.says, Equality)):
        return frozenset()
    tied = {s for by in places for s in find_ties(by, at)[0]}
    tied |= moving - task.paper.given.keys()
    tied = {rate for s in tied - places for rate in at.symbols.find_steps(s)[1]}
    return frozenset(tied if tied & list_letters(task) else ())


def _is_apart(task: Task, tied: frozenset[sp.Basic], symbols: Symbols) -> bool:
    """Return whether the other side of a value has no letter that moves with the one put in."""
    places = {*_find_places(task)}
    running = {symbols.find_steps(by)[0] for by in places} | places | tied
    return not running & list_reached(task.sign.beside, task.paper.given)


def _find_places(task: Task) -> Mapping[sp.Basic, sp.Expr]:
    """Return the numeric values of letters at the place of a row, or under its condition."""
    if task.sign.places or task.sign.role not in _CONDITIONED or task.is_solution:
        return task.sign.places
    return {s: value for s, value in task.at.items() if value.is_number}


def judge_at_place(
    tasks: Sequence[Task],
    number: int,
    others: Sequence[int],
    tied: frozenset[sp.Basic],
    at: Mapping[sp.Basic, sp.Expr],
) -> Judgement | None:
    """Judge a value at a place, with tied letters at their only values there; None if not unique.

    A difference is refuted only if both sides then have the same letters, as identities have.
    """
    places = _find_places(tasks[number])
    task = replace(tasks[number], at={**tasks[number].at, **at})
    given = [*state_at([tasks[o] for o in others], task)]
    residuals = [rest for one in given for rest in (one.residual, *one.rates) if rest is not None]
    says = task.row.says
    try:
        values = _solve_at_place(residuals, tied, task.domain)
        if not (values and isinstance(says, Equality)):
            return None
        printed = [task.domain.resolve(side) for side in says.sides]
        sides = [side.xreplace(values) for side in printed]
        if any(side.free_symbols & tied for side in sides):
            return None
        row = replace(task.row, says=Equality(sides[0], sides[1], "member"))
        found = judge(row, task.paper)
    except (RecordError, ContradictionError):
        return None
    is_refuted = found.verdict is Verdict.REFUTED and have_same_letters(sides) and not task.is_case
    if not (is_refuted or found.verdict is Verdict.PROVED):
        return None
    met = {s for side in printed for s in side.free_symbols}
    used = {s: value for s, value in values.items() if s in met}
    names = ", ".join(one.row.number for one in given)
    reason = f"{found.reason.rstrip('.')}; by {names}, {_write(used)} for {_write(places)}"
    return replace(found, reason=reason)


def _describe(task: Task, given: Sequence[Task], tied: frozenset[sp.Basic]) -> str:
    """Return the reason that names the letters which may have several values at a place."""
    names = ", ".join(one.row.number for one in given) or "the prints before it"
    letters = ", ".join(sorted(map(str, tied & list_letters(task)))) or "another letter"
    return (
        f"it was not shown by {names} that {letters} has only one value for "
        f"{_write(_find_places(task))}; if its range decides, declare that in the block of letters"
    )


def _write(values: Mapping[sp.Basic, sp.Expr]) -> str:
    return ", ".join(f"{s} = {value}" for s, value in values.items())


def _solve_at_place(
    residuals: Sequence[sp.Expr], tied: Collection[sp.Basic], domain: Domain
) -> Values | None:
    """Return the unique values of tied letters at which the residuals are zero, where found.

    None if some residual without another tied letter is then not shown to be zero.
    """
    values: Values = {}
    while found := next(_solve_any(residuals, values, tied, domain), None):
        values = {s: v.xreplace(found) for s, v in values.items()} | found
    rests = (rest.xreplace(values) for rest in residuals)
    settled = (Equality(rest, sp.S.Zero) for rest in rests if not rest.free_symbols & {*tied})
    is_met = all(decide(one, domain).verdict is Verdict.PROVED for one in settled)
    return values if is_met else None


def _solve_any(
    residuals: Sequence[sp.Expr], values: Values, tied: Collection[sp.Basic], domain: Domain
) -> Iterator[Values]:
    """Yield a letter with its value for each residual that has a single tied letter left."""
    for residual in residuals:
        rest = sp.expand(residual.xreplace(values))
        letter, *others = sorted(rest.free_symbols & {*tied}, key=str) or [None]
        if letter is None or others:
            continue
        if (value := _solve(rest, letter, domain)) is not None:
            yield {letter: value}


def _solve(residual: sp.Expr, letter: sp.Basic, domain: Domain) -> sp.Expr | None:
    """Return the only value of a letter at which a residual is zero; None if there may be others.

    The value is checked to lie in the letter's set.
    """
    name, within = sp.Dummy(), domain.set_of(letter)
    if any(letter in relation.free_symbols for relation in domain.where):
        return None
    if within == sp.S.Reals:
        return _solve_linear(residual.xreplace({letter: name}), name, letter, domain)
    for function, (inverse, values) in INVERSES.items():
        shown = residual.xreplace({function(letter): name})
        sine = _solve_linear(shown, name, letter, domain) if within.is_subset(values) else None
        if sine is None:
            continue
        value = inverse(sine)
        is_whole = values.interior.is_subset(within)
        is_within = within.contains(value) == sp.true if value.is_number else is_whole
        return value if is_within else None
    return None


def _solve_linear(
    residual: sp.Expr, name: sp.Dummy, letter: sp.Basic, domain: Domain
) -> sp.Expr | None:
    slope = sp.diff(residual, name)
    if slope == 0 or slope.has(name) or residual.has(letter) or not is_nonzero(slope, domain):
        return None
    return sp.cancel(-residual.xreplace({name: sp.S.Zero}) / slope)
