"""Does a correction, or a reading, concern its row? Else it is our fault: an error.

What is true of something else mends nothing. A correction has to state the quantity of its row, a
reading what the row prints or what is held against it, and neither may compare anything else with
itself. A print in words is stated by hand: there a letter in common is enough.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

import sympy as sp
from sympy.core.relational import Relational

from mechproof.record import (
    Completions,
    Conjunction,
    Definition,
    Distinct,
    Equality,
    Holds,
    PrintedNumber,
    RecordError,
    Row,
    Statement,
)
from mechproof.statement_domains.domain import Domain

_WORDS = re.compile(r"\\text\{[^{}]*\}")
_SIGN = re.compile(r"[=<>≤≥≈≠]|\\(?:le|ge|leq|geq|leqslant|geqslant|ne|neq|approx|equiv)\b")


def check_restatements(row: Row, domain: Domain) -> None:
    """Raise `RecordError` for a correction or a reading that is not about its row."""
    if row.corrected:
        what = f"correction {row.corrected.latex!r}"
        _check(what, row.corrected.statement, row, domain, _quantities(row.statement))
    for reading in row.readings:
        _check(f"reading {reading.text!r}", reading.says, row, domain, _sides(row.statement))


def _check(what: str, says: Statement, row: Row, domain: Domain, shown: Iterable[sp.Basic]) -> None:
    """Require a part that says something, with a side of those that are `shown`."""
    ours, own = (_resolve(sides, domain) for sides in (_quantities(row.statement), shown))
    telling = [part for part in _parts(says) if not _is_void(part, ours, domain)]
    if not telling:
        raise RecordError(f"{what}: its two sides are the same, it says nothing of the row")
    if any(own & _resolve(_sides(part), domain) for part in telling):
        return
    letters = _letters(row.statement, domain)
    rest, words = _WORDS.subn("", row.printed_latex)
    is_in_words = words > 0 and not _SIGN.search(rest)
    if is_in_words and (not letters or letters & _letters(says, domain)):
        return
    raise RecordError(f"{what}: no side of it is one of the row, so it is about something else")


def _resolve(sides: Iterable[sp.Basic], domain: Domain) -> set[sp.Basic]:
    """Return sides as they stand and with what is declared of their letters."""
    listed = list(sides)
    return {*listed, *map(domain.resolve, listed)}


def _is_void(part: Statement, ours: set[sp.Basic], domain: Domain) -> bool:
    """Return whether something is compared with itself that is no quantity of the row."""
    if isinstance(part, Holds):
        relations = part.relation.atoms(Relational)
        return any(relation.lhs == relation.rhs for relation in relations)
    if not isinstance(part, Equality) or part.printed != part.rebuilt:
        return False
    is_ours = part.rebuilt_from != "member" and bool(ours & _resolve([part.rebuilt], domain))
    return not is_ours and not isinstance(part.rebuilt, sp.MatrixBase)


def _letters(says: Statement, domain: Domain) -> set[sp.Basic]:
    sides = list(_sides(says))
    return set().union(*(side.free_symbols | domain.resolve(side).free_symbols for side in sides))


def _parts(says: Statement) -> Iterator[Statement]:
    if isinstance(says, Conjunction):
        for part in says.parts:
            yield from _parts(part)
    elif isinstance(says, Completions):
        yield from _parts(says.first.says)
        yield from _parts(says.second.says)
    else:
        yield says


def _quantities(says: Statement) -> Iterator[sp.Basic]:
    """Yield what is the row's own whatever is printed of it: our side, where there is one."""
    for part in _parts(says):
        if isinstance(part, Equality) and part.rebuilt_from == "mechanics":
            yield part.rebuilt
        else:
            yield from _sides(part)


def _sides(says: Statement) -> Iterator[sp.Basic]:
    for part in _parts(says):
        if isinstance(part, Equality):
            yield from (part.printed, part.rebuilt)
        elif isinstance(part, Distinct):
            yield from (part.left, part.right)
        elif isinstance(part, Definition):
            yield from (part.symbol, part.printed)
        elif isinstance(part, PrintedNumber):
            yield part.value
        elif isinstance(part, Holds):
            for relation in part.relation.atoms(Relational):
                yield from relation.args
