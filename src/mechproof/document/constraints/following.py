"""Judge an equation that a paper says follows from others, by solving these and substituting.

Each of the others is solved for a letter in which it is linear and about which nothing else is
said; what remains of the equation must then be true on its own. If it is not, the others hold and
the equation does not. First the others are used alone, as a definition printed elsewhere may hold
only before an approximation. Then all definitions of letters are put in, except of the letters that
the others define.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace

import sympy as sp

from mechproof.document.constraints.combinations import list_factors
from mechproof.document.constraints.consequences import find_consequence, state_at
from mechproof.document.tasks import Role, Task
from mechproof.latex.matrix_meaning import is_matrix
from mechproof.latex.values import settle_all
from mechproof.proof.judge import judge
from mechproof.proof.signs import is_nonzero
from mechproof.proof.verdict import Judgement, Verdict
from mechproof.record import Definition, Equality, Paper, list_given
from mechproof.statement_domains.domain import Domain

ELIMINATION = "elimination"
_NO_NUMBERS = "only equations between numbers or printed matrices are compared with others"
_UNTIED = "does a letter depend on another there? If so, declare it in the block of letters: x(t)"
_OPEN = (Verdict.REFUTED, Verdict.ENCLOSED, Verdict.UNDECIDED)


def judge_following(task: Task, tasks: Sequence[Task]) -> Judgement | str:
    """Judge a row that is said to follow from other rows, or return why it cannot be judged."""
    found = judge(task.row, task.paper)
    if found.verdict not in _OPEN:
        return found
    names = tuple(f"{name}," for name in task.follows)
    given = [t for t in tasks if f"{t.row.number},".startswith(names)]
    letters = {v.symbol for v in task.paper.variables}
    answer: Judgement | str = ""
    for kept in (letters, {t.sign.letter for t in given}):
        others = [entry for t in given for entry in list_entries(t, kept)]
        answers = [_compare(entry, others, found) for entry in list_all_entries(task, kept)]
        answer = min(answers, key=_weigh, default=_NO_NUMBERS)
        if isinstance(answer, Judgement) and answer.verdict is Verdict.PROVED:
            break
    is_refuted = isinstance(answer, Judgement) and answer.verdict is Verdict.REFUTED
    if is_refuted and task.sign.role is Role.DERIVATIVE and any(t.ties_running for t in given):
        return f"{', '.join(task.follows)}: {_UNTIED}"
    return answer


def _weigh(answer: Judgement | str) -> int:
    """Return the rank of an entry's answer: the lowest is the row's, a misprint first."""
    if isinstance(answer, str):
        return 1
    return {Verdict.REFUTED: 0, Verdict.PROVED: 3}.get(answer.verdict, 2)


def list_entries(task: Task, letters: Collection[sp.Basic | None]) -> list[Task]:
    """Return the entries of a row, with `letters` kept as printed, whatever defines them.

    Entries that contain a matrix symbol are left out. A row that is not an equation has none.
    """
    return [one for one in _list_entries(task, letters) if not _has_matrix(one)]


def list_all_entries(task: Task, letters: Collection[sp.Basic | None]) -> list[Task]:
    """Return all entries of a row, or none if one of them contains a matrix symbol."""
    entries = _list_entries(task, letters)
    return [] if any(map(_has_matrix, entries)) else entries


def _has_matrix(entry: Task) -> bool:
    return bool(sp.sympify(entry.residual).has(sp.MatrixSymbol))


def _list_entries(task: Task, letters: Collection[sp.Basic | None]) -> list[Task]:
    says = task.row.says
    if not isinstance(says, Definition | Equality):
        return []
    one, other = says.printed, says.symbol if isinstance(says, Definition) else says.rebuilt
    if is_matrix(one) or isinstance(other, sp.MatrixExpr):
        one, other = (sp.sympify(side).doit() for side in (one, other))
        if isinstance(other, sp.MatrixSymbol):
            other = other.as_explicit()
        if not (isinstance(one, sp.MatrixBase) and isinstance(other, sp.MatrixBase)):
            return []
    rest = other - one
    variables = tuple(
        replace(v, given=None) if v.symbol in letters else v for v in task.paper.variables
    )
    values = list_given(variables)
    paper = replace(task.paper, variables=variables)
    return [
        replace(task, residual=settle_all(entry, values), paper=paper)
        for entry in (rest if isinstance(rest, sp.MatrixBase) else [rest])
    ]


def _compare(task: Task, given: Sequence[Task], found: Judgement) -> Judgement | str:
    """Judge one entry of a row given other rows, or return why it cannot be judged."""
    names = ", ".join(task.follows)
    given = [*state_at(given, task)]
    if not given:
        return f"{names}: no equation between letters was read there"
    consequence = find_consequence(task, given)
    if consequence and consequence[0] is Verdict.PROVED:
        verdict, rung, reason = consequence
        return replace(found, verdict=verdict, rung=rung, reason=reason, evidence=())
    residuals = [sp.sympify(t.residual) for t in (task, *given)]
    solution = _solve(residuals[1:], _list_free(task.paper), _Divisors.of(residuals, task.domain))
    if solution is None:
        return f"{names} cannot be solved for letters that appear in no other equation"
    values, is_everywhere = solution
    rest = sp.cancel(residuals[0].xreplace(values))
    if rest.has(sp.nan, sp.zoo):
        return f"it has no value once {names} are put in"
    left = judge(replace(task.row, says=Equality(rest, sp.S.Zero, "member")), task.paper)
    solved = ", ".join(map(str, values))
    if left.verdict is Verdict.PROVED and is_everywhere:
        reason = f"follows from {names}, taken as given and solved for {solved}"
        return replace(found, verdict=left.verdict, rung=ELIMINATION, reason=reason, evidence=())
    if left.verdict is Verdict.PROVED:
        return f"it follows from {names} where they can be solved for {solved}; not shown elsewhere"
    if left.verdict is Verdict.REFUTED:
        reason = f"does not follow from {names}: with these solved for {solved}, {left.reason}"
        return replace(left, reason=reason)
    return left


def _list_free(paper: Paper) -> set[sp.Basic]:
    """Return the letters that may have any real value."""
    said = set().union(*(relation.free_symbols for relation in paper.where))
    return {
        v.symbol
        for v in paper.variables
        if v.within == sp.S.Reals and v.given is None and v.symbol not in said
    }


@dataclass(frozen=True)
class _Divisors:
    """The allowed divisors: factors without a zero on the domain, or of the rows' own divisors."""

    below: frozenset[sp.Expr]
    domain: Domain

    @classmethod
    def of(cls, residuals: Sequence[sp.Expr], domain: Domain) -> _Divisors:
        below = [sp.fraction(sp.together(one))[1] for one in residuals]
        return cls(frozenset(factor for one in below for factor in list_factors(one)), domain)

    def allow(self, expression: sp.Expr) -> bool:
        """Return whether an expression is a product of allowed divisors."""
        return all(f in self.below or is_nonzero(f, self.domain) for f in list_factors(expression))


def _solve(
    residuals: Sequence[sp.Expr], free: set[sp.Basic], divisors: _Divisors
) -> tuple[dict[sp.Basic, sp.Expr], bool] | None:
    """Return values of letters at which all residuals are zero, and whether they are the only ones.

    None if none are found. Where a divisor may be zero, the values may not be the only ones.
    """
    values: dict[sp.Basic, sp.Expr] = {}
    is_everywhere = True
    for residual in residuals:
        above = sp.expand(sp.fraction(sp.cancel(residual.xreplace(values)))[0])
        if above == 0:
            continue
        found = _solve_one(above, free - values.keys(), divisors)
        solved = min(found, key=lambda one: (*one[:3], str(one[3])), default=None)
        if solved is None:
            return None
        is_number, is_in_part, _, symbol, value = solved
        is_everywhere &= not (is_number or is_in_part)
        values = {s: sp.cancel(old.xreplace({symbol: value})) for s, old in values.items()}
        values[symbol] = value
    has_values = all(sp.cancel(one.xreplace(values)) != 0 for one in divisors.below)
    return (values, is_everywhere) if has_values else None


def _solve_one(
    above: sp.Expr, free: set[sp.Basic], divisors: _Divisors
) -> Iterator[tuple[bool, bool, int, sp.Basic, sp.Expr]]:
    """Yield, for each letter solved for, the objections to its value, the letter and the value.

    The objections: the value is a number; its divisor may be zero; the size of the divisor.
    """
    for symbol in free & above.free_symbols:
        slope = sp.diff(above, symbol)
        if symbol not in slope.free_symbols:
            value = sp.cancel(symbol - above / slope)
            is_number = bool(value.is_number)
            yield is_number, not divisors.allow(slope), slope.count_ops(), symbol, value
