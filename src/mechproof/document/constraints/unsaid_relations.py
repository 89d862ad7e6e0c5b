"""What an equation would need to be true: lengths that are positive, angles that are acute.

Papers take both for granted, and do not say them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import permutations

import sympy as sp

from mechproof.document.constraints.consequences import list_letters
from mechproof.document.tasks import Task
from mechproof.proof.equation_ladder import ContradictionError
from mechproof.proof.ladder import decide
from mechproof.proof.verdict import Verdict
from mechproof.record import Conjunction, Equality, Holds, Part, RecordError
from mechproof.record.parts import TURNING
from mechproof.statement_domains.domain import Domain

_POSITIVE = sp.Interval.open(0, sp.oo)
_ACUTE = sp.Interval.open(0, sp.pi / 2)


def find_relations(task: Task) -> str:
    """Return relations of letters of which nothing is said, if an equation holds where they do.

    These say that lengths are positive, or angles acute.
    """
    free = Domain.of(task.paper, task.row.on)
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
    """Return that what is printed to be a root is not negative, if it is that or the opposite."""
    says, domain = task.row.says, Domain.of(task.paper, task.row.on)
    sides = (says.printed, says.rebuilt) if isinstance(says, Equality) else ()
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
            for side in (part.printed, part.rebuilt):
                yield from Domain.of(task.paper).resolve(side).atoms(*TURNING)


def _holds_within(task: Task, within: Mapping[sp.Basic, sp.Set]) -> bool:
    """Return whether an equation holds where some of its letters lie in sets."""
    inside = Part("what is not said of some letters holds", within)
    try:
        answer = decide(task.row.statement, Domain.of(task.paper, task.row.on, inside))
    except (RecordError, ContradictionError):
        return False
    return answer.verdict is Verdict.PROVED
