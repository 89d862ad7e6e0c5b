"""Rows that are true nowhere, and rows that need positive lengths or acute angles.

The former are false whatever their letters are; for matrices, one false entry is enough. Papers
take positive lengths and acute angles for granted without saying so.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from itertools import permutations

import sympy as sp

from mechproof.document.constraints.consequences import list_letters
from mechproof.document.constraints.witnesses import find_points
from mechproof.document.misprints import FEW
from mechproof.document.row_sides import write_out
from mechproof.document.tasks import Task
from mechproof.latex.matrix_meaning import is_matrix
from mechproof.latex.values import list_reached
from mechproof.proof.equation_ladder import ContradictionError
from mechproof.proof.ladder import decide
from mechproof.proof.refutation import compare
from mechproof.proof.verdict import Verdict
from mechproof.record import Conjunction, Equality, Holds, Part, RecordError, Statement
from mechproof.record.parts import TURNING
from mechproof.statement_domains.domain import Domain

# Completes the reason of a row that is never true: the definitions may be wrong instead.
WITH_DEFINITIONS = " with the definitions of its letters"
# How often definitions are put in before all of them are.
_DEPTH = 3
_POSITIVE = sp.Interval.open(0, sp.oo)
_ACUTE = sp.Interval.open(0, sp.pi / 2)


def describe_never_true(task: Task, reason: str) -> str:
    """Return the reason that a row is proved to be true nowhere, or ""."""
    if said := next(_list_false_entries(task, task.domain), ""):
        beside = WITH_DEFINITIONS if task.sign.printed & task.domain.given.keys() else ""
        return f"it is never true{beside}: {said}"
    if not _is_nowhere_true(task, task.domain):
        return ""
    beside = WITH_DEFINITIONS if _is_true_alone(task) else ""
    return f"it is never true{beside}: {reason}"


def _is_true_alone(task: Task) -> bool:
    """Return whether a row that is true nowhere may be true without the definitions it uses."""
    if not isinstance(task.row.says, Holds):
        return decide_alone(task, lambda *sides: Holds(sp.Ne(*sides, evaluate=False))) is False
    domain = replace(task.domain, given={})
    return decide(Holds(sp.Not(task.row.says.relation)), domain).verdict is not Verdict.PROVED


def _is_nowhere_true(task: Task, domain: Domain) -> bool:
    """Return whether a row is proved to be true nowhere; not tried if a zero is found."""
    says = task.row.says
    if isinstance(says, Equality) and task.residual is not None:
        return _are_apart(*says.sides, domain)
    if isinstance(says, Holds):
        return decide(Holds(sp.Not(says.relation)), domain).verdict is Verdict.PROVED
    return False


def _are_apart(one: sp.Expr, other: sp.Expr, domain: Domain) -> bool:
    rest = domain.resolve(one) - domain.resolve(other)
    if any(find_points([rest], rest.free_symbols, domain, FEW)):
        return False
    return decide(Holds(sp.Ne(one, other, evaluate=False)), domain).verdict is Verdict.PROVED


def _list_false_entries(task: Task, domain: Domain) -> Iterator[str]:
    """Yield the statements of matrix entries that are never true.

    A zero in a column of a linear system is skipped: there it means that the system has no
    solution.
    """
    says = task.row.says
    if not isinstance(says, Equality):
        return
    one, other = (write_out(domain.resolve(side)) for side in says.sides)
    if not (isinstance(one, sp.MatrixBase) and isinstance(other, sp.MatrixBase)):
        return
    is_system = min(one.shape) == 1 and bool(one.free_symbols | other.free_symbols)
    for row, column in (divmod(n, one.cols) for n in range(len(one)) if one.shape == other.shape):
        left, right = one[row, column], other[row, column]
        if not (is_system and 0 in (left, right)) and _are_apart(left, right, domain):
            said = f"{sp.sstr(sp.simplify(left))} = {sp.sstr(sp.simplify(right))}"
            yield f"entry ({row + 1}, {column + 1}) says {said}"


def holds_alone(task: Task) -> bool:
    """Return whether a row is true whatever defines its letters."""
    return decide_alone(task, Equality) is True


def decide_alone(task: Task, state: Callable[..., Statement]) -> bool | None:
    """Return whether a statement about the sides is proved without the letters' definitions.

    None if a side is not a number.
    """
    one, other = task.sign.sides
    if not (isinstance(one, sp.Expr) and isinstance(other, sp.Expr)):
        return None
    domain = replace(task.domain, given={})
    return decide(state(one, other), domain).verdict is Verdict.PROVED


def list_shallow(task: Task) -> Iterator[Task]:
    """Yield an equation in its letters as printed, then with definitions put in once, and so on.

    What holds whatever defines the letters is found sooner there than with all definitions put in.
    """
    sides, given = task.sign.sides, task.domain.given
    if not (isinstance(task.row.says, Equality) and all(isinstance(x, sp.Expr) for x in sides)):
        return
    free = tuple(replace(v, given=None) for v in task.paper.variables)
    for _ in range(_DEPTH):
        letters = {s for side in sides for s in side.free_symbols} & given.keys()
        if not letters:
            return
        row = replace(task.row, says=Equality(*sides, task.row.says.rebuilt_from))
        paper = replace(task.paper, variables=free)
        yield replace(task, row=row, paper=paper, residual=None)
        # A letter by which another one is given waits until that is put in.
        later = {s for one in letters for s in list_reached({one}, given) if s != one}
        sides = tuple(side.xreplace({s: given[s] for s in letters - later}) for side in sides)


def find_relations(task: Task) -> str:
    """Return relations between unrestricted letters under which an equation holds, or "".

    The relations say that lengths are positive, angles acute, or a side equal to a root not
    negative.
    """
    return next(filter(None, map(_find_relations, (*list_shallow(task), task))), "")


def _find_relations(task: Task) -> str:
    free = task.domain
    met = sorted(list_letters(task), key=str)
    letters = [s for s in met if free.within.get(s) == sp.S.Reals]
    turning = {s for f in _list_turning(task) for s in f.args[0].free_symbols}
    for angles in ([], [s for s in letters if s in turning]):
        within = {s: _ACUTE if s in angles else _POSITIVE for s in letters}
        if within and _holds_within(task, within):
            break
    else:
        return _ask_sign(task)
    for letter in letters:
        others = {s: inside for s, inside in within.items() if s != letter}
        within = others if others and _holds_within(task, others) else within
    said = {_ACUTE: r"0<{}<\pi/2", _POSITIVE: "{}>0"}
    names = {v.symbol: v.latex[0] for v in task.paper.variables if v.latex}
    return ", ".join(said[inside].format(names.get(s, s)) for s, inside in within.items())


def _ask_sign(task: Task) -> str:
    """Return the condition that the other side of a root is not negative, if a row needs it."""
    says, domain = task.row.says, task.domain
    sides = says.sides if isinstance(says, Equality) else ()
    for root, other in permutations(sides, 2):
        resolved = domain.resolve(root)
        if not (isinstance(resolved, sp.Pow) and resolved.exp == sp.Rational(1, 2)):
            continue
        is_square = Equality(resolved.base, domain.resolve(other) ** 2, "member")
        answers = (decide(one, domain).verdict for one in (is_square, Holds(sp.Le(other, 0))))
        if [*answers] == [Verdict.PROVED, Verdict.REFUTED]:
            return rf"{sp.latex(other)}\ge0"
    return ""


def _list_turning(task: Task) -> Iterator[sp.Basic]:
    says = task.row.says
    for part in says.parts if isinstance(says, Conjunction) else (says,):
        if isinstance(part, Equality):
            for side in part.sides:
                yield from Domain.of(task.paper).resolve(side).atoms(*TURNING)


def _holds_within(task: Task, within: Mapping[sp.Basic, sp.Set]) -> bool:
    """Return whether an equation holds where some of its letters lie in sets."""
    inside = Part("assumed ranges of some letters", within)
    domain = Domain.of(task.paper, task.row.on, inside)
    says = task.row.statement
    sides = says.sides if isinstance(says, Equality) else []
    sides = [domain.resolve(side) for side in sides if not is_matrix(side)]
    try:
        # Points are tried first: most choices of letters are refuted by one.
        with suppress(NotImplementedError):
            if len(sides) == 2 and compare(sides[0], sides[1], domain).counterexample:
                return False
        answer = decide(says, domain)
    except (RecordError, ContradictionError):
        return False
    return answer.verdict is Verdict.PROVED
