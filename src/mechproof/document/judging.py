"""What worker processes are asked for: the judgement of a row of a paper that they have read."""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

import sympy as sp

from mechproof.document.applicable_constraints import list_applicable
from mechproof.document.consequences import GIVEN, find_consequence, list_letters
from mechproof.document.following import judge_following, list_entries
from mechproof.document.layouts import TRANSPOSED, holds_transposed
from mechproof.document.misprints import FEW, RUNG, find_failure, find_misprint, holds_at_rest
from mechproof.document.roles import Role
from mechproof.document.rounded_factors import judge_factor
from mechproof.document.rows import Document
from mechproof.document.slips import Entry, find_slip
from mechproof.document.solutions import (
    SUBSTITUTION,
    Solutions,
    are_exchanged,
    judge_angles,
    judge_signs,
    write_sign,
)
from mechproof.document.sources import read_source
from mechproof.document.tasks import Task
from mechproof.document.unsaid_relations import find_relations
from mechproof.document.witnesses import find_points
from mechproof.proof.domain import Domain
from mechproof.proof.judge import judge
from mechproof.proof.ladder import ContradictionError, decide
from mechproof.proof.verdict import Evidence, Judgement, Left, Verdict
from mechproof.record import (
    Conjunction,
    Definition,
    Equality,
    Holds,
    PrintedNumber,
    RecordError,
    Statement,
)

# How the row of one sign of a chain is called.
_SIGN = re.compile(r", [\w-]+ (?:equals )?sign\Z")
# What is compared, even if letters that only one side has could make both sides equal.
COMPARED = (Role.REPEATED, Role.DERIVATIVE, Role.STEP)
# Seconds for one equation.
LIMIT = 60.0
# How far a row is never true: those that define its letters may be wrong instead.
WITH_DEFINITIONS = " with what defines its letters"
# Numbers and prints of rows that are judged elsewhere, each with the count of what its row states.
Elsewhere = frozenset[tuple[str, int]]
# Where a paper comes from, and what is judged elsewhere; the rows of papers that are at work: a
# process that was forked finds here what its parent had. SymPy would work relations out on their
# way through a pipe.
Key = tuple[str, str | None, Elsewhere]
opened: dict[Key, list[Task]] = {}


def name_equation(number: str) -> str:
    """Return the name of the equation that a row is a sign of."""
    return _SIGN.sub("", number)


def leave_out(rows: Sequence[Task | Left], elsewhere: Elsewhere) -> Iterator[Task | Left]:
    """Yield the rows that are judged nowhere else, by themselves or with all signs of their print.

    A row elsewhere judges all signs of its print if it states as many things. Of what is not read
    the signs are not known.
    """
    known = {text for text, _ in elsewhere}
    equations = {*map(name_equation, known)}
    signs = Counter(name_equation(one.row.number) for one in rows if isinstance(one, Task))
    stated = defaultdict[str, int](int)
    for text, parts in elsewhere:
        stated[text] = max(stated[text], parts)
    for one in rows:
        row = one.row if isinstance(one, Task) else one
        equation = name_equation(row.number)
        is_whole = stated[equation] >= max(1, signs[equation])
        is_told = is_whole if isinstance(one, Task) else equation in equations
        if not (is_told or known & {row.number, row.printed_latex}):
            yield one


def open_tasks(key: Key) -> list[Task]:
    """Return the rows of a paper that are judged, read again where nobody else has."""
    if key not in opened:
        path, content, elsewhere = key
        found = leave_out(Document(read_source(path, content)).read(LIMIT), elsewhere)
        opened[key] = [one for one in found if isinstance(one, Task)]
    return opened[key]


def judge_row(which: tuple[Key, int]) -> Judgement | str:
    """Judge a row by itself, or beside what it is said to follow from, or say why not."""
    tasks = open_tasks(which[0])
    task = tasks[which[1]]
    try:
        return judge_following(task, tasks) if task.follows else _judge_alone(task)
    except (RecordError, ContradictionError) as error:
        return str(error)


def _judge_alone(task: Task) -> Judgement | str:
    """Judge a row, or say why not; what asserts nothing is refuted only if it is true nowhere."""
    try:
        found = judge(task.row, task.paper)
    except (RecordError, ContradictionError) as error:
        return str(error)
    if found.verdict is Verdict.REFUTED and are_exchanged(task):
        return "both signs give the same two values, but the other way round"
    if found.verdict is Verdict.PROVED and task.sign.role is Role.SOLUTIONS:
        return judge_signs(task, found)
    if found.verdict is Verdict.REFUTED and task.is_rounded and (task.asserts or task.is_either):
        return judge_factor(task)
    if found.verdict is Verdict.REFUTED and holds_transposed(task):
        return TRANSPOSED
    if found.verdict is Verdict.REFUTED and task.sign.role is Role.SEAM and not task.asserts:
        return "the pieces differ where they meet: a jump, or a misprint?"
    if found.verdict is Verdict.REFUTED and task.is_solution:
        return (
            f"it differs from {task.sign.first}, but may be another solution or case; if it is "
            f"none, say so in the block of letters: identity {name_equation(task.row.number)}"
        )
    is_compared = task.asserts or task.sign.role in COMPARED
    if found.verdict is Verdict.REFUTED and is_compared and (said := find_relations(task)):
        return (
            "it holds for some values of its letters; if they are meant, say so in the block of "
            f"letters: where {said}"
        )
    if found.verdict is Verdict.REFUTED and task.is_alone:
        says = task.row.says
        if isinstance(says, PrintedNumber) and (slip := find_slip(says, says.value)):
            return replace(found, reason=f"{found.reason}: a slip for {slip}?")
        return f"not the value at the declared sizes: {found.reason}"
    if task.sign.first and found.verdict is Verdict.REFUTED and task.asserts:
        reason = f"{found.reason.removesuffix('.')}; compared with {task.sign.first}"
        return replace(found, reason=reason)
    if task.asserts or found.verdict not in (Verdict.REFUTED, Verdict.UNDECIDED, Verdict.ENCLOSED):
        return found
    if found.verdict is Verdict.REFUTED and (turned := judge_angles(task)):
        return turned
    if found.verdict is Verdict.REFUTED and not task.is_rounded and _is_nowhere_true(task):
        beside = "" if _is_false_alone(task) else WITH_DEFINITIONS
        return replace(found, reason=f"it is never true{beside}: {found.reason}")
    return _take_as_given(task, found)


def _is_nowhere_true(task: Task) -> bool:
    """Return whether a row is proved to be true nowhere; not asked where a zero is met."""
    says = task.row.says
    domain = Domain.of(task.paper, task.row.on)
    if isinstance(says, Equality) and task.residual is not None:
        rest = domain.resolve(says.printed) - domain.resolve(says.rebuilt)
        if any(find_points([rest], rest.free_symbols, domain, FEW)):
            return False
        apart = Holds(sp.Ne(says.printed, says.rebuilt, evaluate=False))
        return decide(apart, domain).verdict is Verdict.PROVED
    if isinstance(says, Holds):
        return decide(Holds(sp.Not(says.relation)), domain).verdict is Verdict.PROVED
    return False


def _is_false_alone(task: Task) -> bool:
    """Return whether a row is true nowhere, whatever defines its letters."""
    return _decide_alone(task, lambda *sides: Holds(sp.Ne(*sides, evaluate=False))) is not False


def holds_alone(task: Task) -> bool:
    """Return whether a row is true whatever defines its letters."""
    return _decide_alone(task, Equality) is True


def _decide_alone(task: Task, state: Callable[..., Statement]) -> bool | None:
    """Return whether what is stated of the sides is proved without what defines letters.

    None for sides that are no numbers.
    """
    one, other = task.sign.sides
    if not (isinstance(one, sp.Expr) and isinstance(other, sp.Expr)):
        return None
    domain = replace(Domain.of(task.paper, task.row.on), given={})
    return decide(state(one, other), domain).verdict is Verdict.PROVED


def _take_as_given(task: Task, found: Judgement) -> Judgement:
    what = "a condition" if isinstance(task.row.says, Holds) else "a constraint"
    reason = f"{what}, taken as given: it does not hold for all values of its letters"
    if found.verdict is not Verdict.REFUTED:
        if task.is_either:
            return found
        reason = f"{what}, taken as given"
    return replace(found, verdict=Verdict.DEFINITION, rung=GIVEN, reason=reason, evidence=())


def judge_members(which: tuple[Key, int, list[list[str]]]) -> Judgement | str:
    """Judge a print by the members that stand: one is enough to prove it.

    It is refuted by any of them, unless they differ themselves.
    """
    key, number, standing = which
    task = open_tasks(key)[number]
    names = [name for group in standing for name in group]
    compared = [one for one in (task, *task.others) if one.sign.first in names]
    answers = [(_judge_alone(one), one) for one in compared]
    for wanted in (Verdict.PROVED, Verdict.REFUTED):
        # A member behind a step that is not shown may be meant for a case: it accuses nobody.
        alone = answers[:1] if wanted is Verdict.REFUTED and compared[0] is task else answers
        for found, one in alone:
            if isinstance(found, Judgement) and found.verdict is wanted:
                if wanted is Verdict.REFUTED and len(standing) > 1:
                    first = task.sign.first
                    return f"it differs from members of {first} that differ from one another"
                beside = f"; compared with {one.sign.first}" if one.sign.first else ""
                said = found.reason.removesuffix(beside).removesuffix(".")
                return replace(found, reason=f"{said}{beside}")
    return answers[0][0]


def judge_beside(which: tuple[Key, int, tuple[int, ...]]) -> Judgement | None:
    """Judge by the constraints before it what may follow from them; None if that is not shown."""
    key, number, others = which
    tasks = open_tasks(key)
    task = tasks[number]
    before = [tasks[other] for other in list_applicable(others, number, tasks)]
    found = find_consequence(task, before) if task.residual is not None else None
    return _replace(task, *found) if found else None


def judge_freed(
    which: tuple[Key, int, tuple[int, ...], frozenset[sp.Basic]],
) -> Judgement | None:
    """Judge as `judge_beside` does, some letters as they are printed, whatever defines them."""
    key, number, others, letters = which
    if not letters:
        return judge_beside((key, number, others))
    tasks = open_tasks(key)
    entries = list_entries(tasks[number], letters)
    before = [entry for n in others for entry in list_entries(tasks[n], letters)]
    found = find_consequence(entries[0], before) if len(entries) == 1 else None
    return _replace(tasks[number], *found) if found else None


def judge_excused(which: tuple[Key, int, tuple[int, ...]]) -> Judgement | str:
    """Judge beside all constraints what is not true by itself, or say which may make it true."""
    key, number, others = which
    tasks = open_tasks(key)
    task = tasks[number]
    found = judge_beside(which)
    if found and found.verdict is Verdict.PROVED:
        return found
    given = list(_list_given(task, [tasks[other] for other in others]))
    names = ", ".join(tasks[other].row.number for other in others)
    domain = Domain.of(task.paper, task.row.on)
    for entry in _list_entries(task):
        if evidence := find_failure(entry.sides, given, domain):
            reason = f"the two sides differ, also where {names} hold"
            return _replace(task, Verdict.REFUTED, RUNG, reason, (evidence,))
    return f"the two sides differ unless {names} makes them equal, which could not be decided"


def judge_misprint(which: tuple[Key, int, tuple[int, ...]]) -> Judgement | None:
    """Judge what may be a constraint or a misprint beside the constraints: None if not refuted."""
    key, number, others = which
    tasks = open_tasks(key)
    task = tasks[number]
    try:
        domain = Domain.of(task.paper, task.row.on)
        given = list(_list_given(task, [tasks[other] for other in others]))
        compared = [entry for one in (task, *task.others) for entry in _list_entries(one)]
        if task.others and not all(find_failure(e.sides, given, domain) for e in compared):
            return None
        printed = _list_printed(tasks)
        second = {s for t in (task, *(tasks[o] for o in others)) for s in _list_accelerations(t)}
        for entry in compared:
            found = find_misprint(entry, given, domain, printed, may_repeat=task.asserts)
            if found and not holds_at_rest(entry.sides, given, domain, second):
                met = dict.fromkeys((task.sign.first, *(tasks[o].row.number for o in others)))
                names = ", ".join(name for name in met if name not in ("", task.row.number))
                beside = f"; compared with {names}" if names else ""
                reason = f"{found.change.reason}{beside}"
                return _replace(task, Verdict.REFUTED, RUNG, reason, (found.evidence,))
    except (RecordError, ContradictionError):
        pass
    return None


def _list_printed(tasks: Sequence[Task]) -> set[sp.Basic]:
    return {task.row.says.symbol for task in tasks if isinstance(task.row.says, Definition)}


def _list_accelerations(task: Task) -> set[sp.Basic]:
    """Return the second derivatives that those of a row have and nothing before them."""
    first = {s for rate in task.rates[:1] for s in rate.free_symbols} | list_letters(task)
    return {s for rate in task.rates[1:] for s in rate.free_symbols} - first


def judge_roots(which: tuple[Key, int, tuple[int, ...]]) -> Judgement | None:
    """Judge a print with a double sign beside constraints: None if nothing is shown."""
    key, number, others = which
    tasks = open_tasks(key)
    task = tasks[number]
    given = {tasks[o].row.number: tasks[o].residual for o in others}
    letters = {s for residual in given.values() for s in sp.sympify(residual).free_symbols}
    solutions = Solutions(*task.sign.sides).name_root(sorted(letters, key=str))
    domain = Domain.of(task.paper, task.row.on)
    if met := solutions.find_met(given, domain):
        reason = "both signs give {} of {}, taken as given".format(*met)
        return _replace(task, Verdict.PROVED, SUBSTITUTION, reason)
    if task.is_case:
        return None
    if found := solutions.find_misprint([*given.values()], domain, _list_printed(tasks)):
        reason = f"{write_sign(found.change.reason)}; both signs compared with what else is printed"
        return _replace(task, Verdict.REFUTED, RUNG, reason, (found.evidence,))
    return None


def _replace(
    task: Task, verdict: Verdict, rung: str, reason: str, evidence: tuple[Evidence, ...] = ()
) -> Judgement:
    """Return what a row is judged to be by itself, with another verdict."""
    alone = judge(task.row, task.paper)
    return replace(alone, verdict=verdict, rung=rung, reason=reason, evidence=evidence)


def _list_entries(task: Task) -> Iterator[Entry]:
    """Yield the sides of equations, entry by entry if they are matrices."""
    says, sign = task.row.says, task.sign
    worked_out = zip(sign.sides, sign.worked_out, strict=True)
    printed = [side for side, is_not in worked_out if not (is_not or side is None)]
    for part in says.parts if isinstance(says, Conjunction) else (says,):
        if not isinstance(part, Equality):
            continue
        one, other = map(_take_out, (part.printed, part.rebuilt))
        are_printed = part.printed in printed, part.rebuilt in printed
        if isinstance(one, sp.MatrixBase) and isinstance(other, sp.MatrixBase):
            pairs = zip(one, other, strict=True) if one.shape == other.shape else ()
            yield from (Entry(pair, are_printed) for pair in pairs)
        elif isinstance(one, sp.Expr) and isinstance(other, sp.Expr):
            yield Entry((one, other), are_printed)


def _take_out(side: sp.Basic) -> sp.Basic:
    """Return the entry of a matrix that has but one."""
    side = side.doit() if isinstance(side, sp.MatrixExpr) else side
    return side[0] if isinstance(side, sp.MatrixBase) and side.shape == (1, 1) else side


def _list_given(task: Task, others: Sequence[Task]) -> Iterator[sp.Expr]:
    """Yield the residuals of constraints, with derivatives as long as they add letters of a row."""
    letters = list_letters(task)
    for other in others:
        met: set[sp.Basic] = set()
        for one in (other.residual, *other.rates):
            if met and not one.free_symbols & letters - met:
                break
            yield one
            met |= one.free_symbols
