"""The rows of a paper while they are judged, and the questions that worker processes answer.

A worker process that has not inherited the rows of a paper reads the paper again.
"""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import sympy as sp

from mechproof.document.checked_rows import CheckedRow
from mechproof.document.constraints.consequences import GIVEN
from mechproof.document.constraints.following import judge_following
from mechproof.document.constraints.solutions import are_exchanged, judge_angles, judge_signs
from mechproof.document.numbers.conversions import judge_factor
from mechproof.document.row_sides import have_same_letters
from mechproof.document.slips import find_slip
from mechproof.document.source_rows import Document
from mechproof.document.tasks import Role, Task
from mechproof.document.where_true import (
    WITH_DEFINITIONS,
    describe_never_true,
    find_relations,
    list_shallow,
)
from mechproof.latex.matrix_meaning import is_matrix
from mechproof.nomenclature.possible_matrices import UNIT_MATRIX
from mechproof.nomenclature.symbols import Symbols
from mechproof.proof.equation_ladder import ContradictionError
from mechproof.proof.judge import judge
from mechproof.proof.ladder import AGREE, BOUND_AGREE
from mechproof.proof.refutation import are_seen_to_differ
from mechproof.proof.verdict import Judgement, Left, Verdict
from mechproof.record import Definition, Equality, Holds, Nearly, PrintedNumber, RecordError
from mechproof.sources.paper_files import read_source
from mechproof.tools.processes import run_tasks

# The end of a row's name if the row is one sign of a chain.
_SIGN = re.compile(r", [\w-]+ (?:equals )?sign\Z")
# Roles of rows whose sides are compared even if letters on one side only could make them equal.
COMPARED = (Role.REPEATED, Role.DERIVATIVE, Role.STEP)
# Seconds that reading, or judging, one equation may take.
LIMIT = 60.0
# Errors raised by mechproof itself, whose messages are sentences.
_UNDECIDED = (RecordError, ContradictionError, NotImplementedError)
# Completes the reason of a row that differs from another value of the same letter.
UNLIKE = ", which has the same letters: one of them is wrong or about another case"
TRANSPOSED = (
    "it holds with one side transposed: a misprint, or derivatives with one row for each letter?"
)
# Rows judged elsewhere: their numbers and prints, each with the number of statements of its row.
Elsewhere = frozenset[tuple[str, int]]
# The rows of the papers being judged, by path, content and the rows judged elsewhere. They are
# global so that a forked process inherits them: unpickling SymPy relations would evaluate them.
Key = tuple[str, str | None, Elsewhere]
opened: dict[Key, list[Task]] = {}
# Rows that have changed, with their numbers.
Changes = Iterator[tuple[int, CheckedRow]]


def name_equation(number: str) -> str:
    """Return the name of the equation that a row is a sign of."""
    return _SIGN.sub("", number)


def leave_out(rows: Sequence[Task | Left], elsewhere: Elsewhere) -> Iterator[Task | Left]:
    """Yield the rows that are not judged elsewhere, on their own or with their whole print.

    A row elsewhere covers a print if it makes at least as many statements as the print has signs.
    For a print that could not be read, any row elsewhere of its equation counts.
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
    """Return the rows of a paper that are judged, reading them if this process has not yet."""
    if key not in opened:
        path, content, elsewhere = key
        found = leave_out(Document(read_source(path, content)).read(LIMIT), elsewhere)
        opened[key] = [one for one in found if isinstance(one, Task)]
    return opened[key]


def judge_row(tasks: Sequence[Task], number: int) -> Judgement | str:
    """Judge a row on its own or by the rows it is said to follow from; else return why not."""
    task = tasks[number]
    try:
        return judge_following(task, tasks) if task.follows else _judge_alone(task)
    except _UNDECIDED as error:
        return _describe(error)


def _describe(error: Exception) -> str:
    """Return why a row is not decided; proofs that contradict each other are a bug here."""
    if isinstance(error, ContradictionError):
        return (
            "its proof and its values contradict each other: a bug in mechproof, please report it"
        )
    return str(error)


def judge_special(tasks: Sequence[Task], number: int, kind: str) -> Judgement | str:
    """Judge a row at the values of its letters in its `special` or `local` variant."""
    special: Task = getattr(tasks[number], kind)
    return _judge_alone(special)


def judge_without(
    tasks: Sequence[Task], number: int, letters: frozenset[sp.Basic]
) -> Judgement | None:
    """Judge a row without the definitions of some letters; None unless it is proved or refuted.

    A difference is refuted only if both sides then have the same letters, as identities have.
    """
    task = tasks[number].give_values(dict.fromkeys(letters))
    if task is None:
        return None
    try:
        found = judge(task.row, task.paper)
        sides = [*map(task.domain.resolve, task.sign.sides)]
    except (RecordError, ContradictionError, TypeError):
        return None
    is_compared = task.asserts or task.sign.role in COMPARED
    is_refuted = found.verdict is Verdict.REFUTED and is_compared and have_same_letters(sides)
    return found if is_refuted or found.verdict is Verdict.PROVED else None


def _judge_alone(task: Task) -> Judgement | str:
    """Judge a row on its own, or return why not.

    A row that asserts nothing is refuted only if it is true nowhere.
    """
    try:
        found = _find_mixture(task) or judge(task.row, task.paper)
    except _UNDECIDED as error:
        return _describe(error)
    if isinstance(task.row.says, Nearly):
        return found.reason
    if found.verdict in (Verdict.UNDECIDED, Verdict.ENCLOSED):
        found = _prove_in_letters(task) or found
    if found.verdict is Verdict.DEFINITION:
        return _say_compared(task, found)
    if found.verdict is Verdict.REFUTED and are_exchanged(task):
        return "both signs give the same two values, but the other way round"
    if found.verdict is Verdict.PROVED and task.sign.role is Role.SOLUTIONS:
        return judge_signs(task, found)
    if found.verdict is Verdict.REFUTED and task.is_rounded and (task.asserts or task.is_either):
        return judge_factor(task)
    if found.verdict is Verdict.REFUTED and _holds_transposed(task):
        return TRANSPOSED
    if found.verdict is Verdict.REFUTED and task.sign.role is Role.SEAM and not task.asserts:
        return "the pieces differ where they meet: a jump, or a misprint?"
    is_relation = task.sign.role is Role.RELATION
    if found.verdict is Verdict.REFUTED and task.is_solution and not is_relation:
        return (
            f"it differs from {task.sign.first or 'an earlier print'}, but may be another solution "
            f"or case; if it is neither, declare identity {name_equation(task.row.number)} in the "
            "block of letters"
        )
    is_compared = task.asserts or task.sign.role in COMPARED
    if found.verdict is Verdict.REFUTED and is_compared and (said := find_relations(task)):
        return (
            "it holds for some values of its letters; if these are meant, declare them in the "
            f"block of letters: where {said}"
        )
    if found.verdict is Verdict.REFUTED and task.is_alone:
        says = task.row.says
        if isinstance(says, PrintedNumber) and (slip := find_slip(says, says.value)):
            return replace(found, reason=f"{found.reason}: a misprint for {slip}?")
        return f"not the value at the declared sizes: {found.reason}"
    if task.sign.first and found.verdict is Verdict.REFUTED and task.asserts:
        reason = f"{found.reason.removesuffix('.')}; compared with {task.sign.first}"
        return replace(found, reason=reason)
    if task.asserts or found.verdict not in (Verdict.REFUTED, Verdict.UNDECIDED, Verdict.ENCLOSED):
        return found
    if found.verdict is Verdict.REFUTED and (turned := judge_angles(task)):
        return turned
    is_exact = found.verdict is Verdict.REFUTED and not task.is_rounded
    if is_exact and (never := describe_never_true(task, found.reason)):
        if task.is_solution and WITH_DEFINITIONS in never:
            return f"it is never true{WITH_DEFINITIONS}, but may be about another case"
        return replace(found, reason=never)
    return _take_as_given(task, found)


def _prove_in_letters(task: Task) -> Judgement | None:
    """Judge an equation before all definitions are put in; None unless it is proved."""
    for one in list_shallow(task):
        says = one.row.says
        sides = says.sides if isinstance(says, Equality) else ()
        if sides and not any(map(is_matrix, sides)) and not are_seen_to_differ(sides, one.domain):
            found = judge(one.row, one.paper)
            if found.verdict is Verdict.PROVED:
                return found
    return None


def _find_mixture(task: Task) -> Judgement | None:
    """Judge the part of a row that mixes dimensions; None unless it is ill-formed."""
    if task.mixed is None:
        return None
    part, paper = task.mixed
    found = judge(replace(task.row, says=Equality(part, part, "member")), paper)
    return found if found.verdict is Verdict.ILL_FORMED else None


def _say_compared(task: Task, found: Judgement) -> Judgement:
    """Return a judgement whose reason claims no more than was compared."""
    said = f"{BOUND_AGREE}; dimensions are not compared: {task.lacking}"
    reason = found.reason.replace(AGREE, said) if task.lacking else found.reason
    asked = _ask_unit_matrix(task)
    return replace(found, reason=f"{reason.removesuffix('.')}. {asked}" if asked else reason)


def _ask_unit_matrix(task: Task) -> str:
    """Ask whether a letter that matrices define is a unit matrix, as I usually is."""
    says, name = task.row.says, str(task.sign.letter)
    symbol = says.symbol if isinstance(says, Definition) else None
    is_printed = r"\begin{" in task.row.printed_latex
    if is_printed or not isinstance(symbol, sp.MatrixSymbol) or not UNIT_MATRIX.fullmatch(name):
        return ""
    rows, columns = symbol.shape
    said = f"If it is the unit matrix, say so: {name} {rows}x{columns} : unit matrix"
    return said if rows == columns else ""


def _holds_transposed(task: Task) -> bool:
    """Return whether a matrix of derivatives is printed in the other layout.

    In derivatives by a vector, each row belongs to one entry, or to one letter.
    """
    says = task.row.says
    if r"\partial" not in task.row.printed_latex or not isinstance(says, Equality):
        return False
    one, other = says.sides
    if not (is_matrix(one) and is_matrix(other)):
        return False
    turned = replace(task.row, says=Equality(one.T, other, "member"))
    return one.shape == other.shape[::-1] and judge(turned, task.paper).verdict is Verdict.PROVED


def _take_as_given(task: Task, found: Judgement) -> Judgement:
    what = "a condition" if isinstance(task.row.says, Holds) else "a constraint"
    reason = f"{what}, taken as given: it does not hold for all values of its letters"
    if found.verdict is not Verdict.REFUTED:
        if task.is_either:
            return found
        reason = f"{what}, taken as given"
    return replace(found, verdict=Verdict.DEFINITION, rung=GIVEN, reason=reason, evidence=())


def judge_members(
    tasks: Sequence[Task], number: int, standing: Sequence[Sequence[str]]
) -> Judgement | str:
    """Judge a print by the agreeing members of a chain: a proof by one of them is enough.

    A difference from its first member refutes it, unless the members differ among themselves.
    """
    task = tasks[number]
    names = [name for group in standing for name in group]
    compared = [one for one in (task, *task.others) if one.sign.first in names]
    answers = [(_judge_alone(one), one) for one in compared]
    for wanted in (Verdict.PROVED, Verdict.REFUTED):
        # A member after an unproved step may be meant for a case, so it refutes nothing.
        alone = answers[:1] if wanted is Verdict.REFUTED and compared[0] is task else answers
        for found, one in alone:
            if isinstance(found, Judgement) and found.verdict is wanted:
                if wanted is Verdict.REFUTED and len(standing) > 1:
                    first = task.sign.first
                    return f"it differs from members of {first} that differ from one another"
                beside = f"; compared with {one.sign.first}" if one.sign.first else ""
                said = found.reason.removesuffix(beside).removesuffix(".")
                return replace(found, reason=f"{said}{beside}")
    own = answers[0][0]
    judged = [(found, one) for found, one in answers[1:] if isinstance(found, Judgement)]
    refuted = [one for found, one in judged if found.verdict is Verdict.REFUTED]
    unlike = [one for one in refuted if have_same_letters(one.sign.sides)]
    if unlike and isinstance(own, Judgement) and own.rung == GIVEN:
        return replace(own, reason=f"it differs from {unlike[0].sign.first}{UNLIKE}")
    return own


@dataclass(frozen=True)
class Judging:
    """The tasks of a paper, the rows judged so far, and the seconds allowed for each judgement.

    `found` has the rows that were not read, too, and `matrices` the letters shown as matrices are.
    `contested` has the misprints and the rows that contradict each other, `placed` the numbers of
    those judged at a place.
    """

    key: Key
    tasks: list[Task]
    rows: dict[int, CheckedRow]
    symbols: Symbols
    limit: float
    found: Sequence[Task | Left]
    matrices: Mapping[sp.Basic, str]
    contested: dict[int, CheckedRow] = field(default_factory=dict)
    placed: set[int] = field(default_factory=set)

    def ask(
        self, judge: Callable[..., Any], asked: Sequence[tuple[Any, ...]]
    ) -> Iterator[tuple[tuple[Any, ...], Any]]:
        """Yield each of `asked` with its answer, or with a `WorkerError`, in order of completion.

        `judge` is a module-level function, called with all tasks and the elements of one of
        `asked`.
        """
        calls = [(self.key, judge, one) for one in asked]
        for place, answer in run_tasks(_answer, calls, limit=self.limit):
            yield asked[place], answer


def _answer(call: tuple[Key, Callable[..., Any], tuple[Any, ...]]) -> Any:
    key, judge, asked = call
    return judge(open_tasks(key), *asked)
