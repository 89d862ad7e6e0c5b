"""Check that a statement uses its symbols only as declared; otherwise the error is ours.

A paper's print may be ill-formed, which is a verdict (`wellformed`). Our rebuilt sides,
corrections, readings and completions must not be. Nor does a truth about something else mend
anything: a correction has to state its row's quantity, a reading the row's print or the side that
the print is compared with, and neither may compare anything else with itself. A print in words is
stated by hand: there one common letter is enough.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

import sympy as sp
from sympy.concrete.expr_with_limits import ExprWithLimits
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational

from mechproof.arithmetic import balls
from mechproof.proof.signs import is_shown
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
    Slack,
    Statement,
)
from mechproof.record.implicit import Implicit
from mechproof.record.parts import find_free, find_parts
from mechproof.statement_domains.dimension_inference import DimensionError, Dimensions, infer_common
from mechproof.statement_domains.domain import Domain
from mechproof.statement_domains.set_values import Facts, describe_excess, facts_of, find_excess

Side = tuple[str, sp.Basic]
# The fields that hold the sides of a statement, the printed one first.
_SIDES: Mapping[type, tuple[str, ...]] = {
    Equality: ("printed", "rebuilt"),
    Distinct: ("left", "right"),
    Definition: ("printed",),
    Holds: ("relation",),
    PrintedNumber: ("value",),
}
LARGEST_EXPONENT = 10**5


def check_statement(
    statement: Statement,
    known: Dimensions,
    domain: Domain,
    printed: bool = True,
    mended: bool = False,
) -> None:
    """Raise `RecordError` for errors that no paper can be blamed for.

    `printed`: the print is among the sides; a correction, a reading or a completion is all ours.
    `mended`: a correction is given, so that unlike dimensions are the print's fault.
    """
    if isinstance(statement, Conjunction | Completions):
        for part, is_printed in _parts(statement, printed):
            check_statement(part, known, domain, is_printed, mended)
        return
    prints, ours = _sides(statement, printed)
    for name, side in prints + ours:
        _check_size(name, side)
        if undefined := sorted(map(str, find_parts(side, AppliedUndef))):
            raise RecordError(f"{name}: the function in {undefined[0]} is not defined")
        _check_bound(name, side, domain)
        _check_names(name, side, known, domain, may_be_unknown=(name, side) in prints)
    if isinstance(statement, Holds) and printed:
        return
    for name, side in ours:
        _check_dimension(name, side, known)
    if isinstance(statement, Equality | Distinct) and ours and not (printed and mended):
        _check_likeness(prints + ours, known)
    if isinstance(statement, PrintedNumber) and find_free(domain.resolve(statement.value)):
        raise RecordError(f"PrintedNumber {statement.printed}: {statement.value} is not a number")


def _parts(statement: Conjunction | Completions, printed: bool) -> Iterator[tuple[Statement, bool]]:
    if isinstance(statement, Conjunction):
        yield from ((part, printed) for part in statement.parts)
    else:
        yield from ((side.says, False) for side in (statement.first, statement.second))


def _sides(statement: Statement, printed: bool) -> tuple[list[Side], list[Side]]:
    """Return the sides that the paper may be blamed for, and ours."""
    sides = [(name, getattr(statement, name)) for name in _SIDES.get(type(statement), ())]
    prints = 0 if isinstance(statement, Holds | PrintedNumber) or not printed else 1
    if prints and isinstance(statement, Equality) and statement.rebuilt_from == "member":
        prints = 2
    return sides[:prints], sides[prints:]


def _check_size(name: str, side: sp.Basic) -> None:
    """Refuse towers of powers that no step could write out: a limit of the prover."""
    for power in find_parts(side, sp.Pow):
        exponent = power.exp
        if exponent.is_number and not abs(balls.evaluate(exponent, {})) < LARGEST_EXPONENT:
            raise NotImplementedError(
                f"{name}: an exponent is not below {LARGEST_EXPONENT} in absolute value"
            )


def _check_names(
    name: str, side: sp.Basic, known: Dimensions, domain: Domain, may_be_unknown: bool
) -> None:
    declared = {*known, *domain.within, *domain.given}
    labels = {getattr(symbol, "label", symbol) for symbol in declared}
    free = find_free(side) - find_parts(side, sp.Indexed)
    for symbol in sorted(free - labels - declared, key=str):
        if str(symbol) in map(str, declared):
            raise RecordError(
                f"{name}: its {symbol} is not the declared {symbol}: the two have different SymPy "
                "assumptions"
            )
        if not may_be_unknown:
            raise RecordError(f"{name}: {symbol} is not a declared symbol of the paper")


def _check_bound(name: str, side: sp.Basic, domain: Domain) -> None:
    for node in find_parts(side, ExprWithLimits):
        for bound, *limits in node.limits:
            facts = _facts_of_bound(node, limits, domain)
            if excess := find_excess(bound, facts):
                raise RecordError(
                    f"{name}: the limits of {node} do not imply all SymPy assumptions of {bound}: "
                    f"{describe_excess(excess)}"
                )


def _facts_of_bound(node: ExprWithLimits, limits: list[sp.Expr], domain: Domain) -> Facts:
    if isinstance(node, sp.Sum | sp.Product):
        lower = limits[0] if limits else -sp.oo
        counts = ((lower - 1, sp.S.Naturals), (lower, sp.S.Naturals0))
        return facts_of(next((s for e, s in counts if _has_sign(e, 1, domain)), sp.S.Integers))
    if isinstance(node, Implicit):
        limits = list(node.ends)
    for direction, strict, where in _HALF_LINES:
        if limits and all(_has_sign(end, direction, domain, strict) for end in limits):
            return facts_of(where)
    return facts_of(sp.S.Reals)


_HALF_LINES = (
    (1, True, sp.Interval.open(0, sp.oo)),
    (1, False, sp.Interval(0, sp.oo)),
    (-1, True, sp.Interval.open(-sp.oo, 0)),
    (-1, False, sp.Interval(-sp.oo, 0)),
)


def _has_sign(expression: sp.Expr, direction: int, domain: Domain, strict: bool = False) -> bool:
    directed = direction * expression
    if directed.is_extended_positive or (directed.is_extended_nonnegative and not strict):
        return True
    return is_shown(Slack(directed, strict), domain)


def _check_dimension(name: str, side: sp.Basic, known: Dimensions) -> None:
    try:
        infer_common((side,), known)
    except DimensionError as error:
        raise RecordError(f"{name}: {error}") from error


def _check_likeness(sides: list[Side], known: Dimensions) -> None:
    try:
        for _, side in sides:
            infer_common((side,), known)
    except DimensionError:
        return
    try:
        infer_common(tuple(side for _, side in sides), known)
    except DimensionError as error:
        names = " and ".join(name for name, _ in sides)
        raise RecordError(
            f"{names} have different dimensions: {error}; if the print is wrong, give its "
            "correction"
        ) from error


_WORDS = re.compile(r"\\text\{[^{}]*\}")
_SIGN = re.compile(r"[=<>≤≥≈≠]|\\(?:le|ge|leq|geq|leqslant|geqslant|ne|neq|approx|equiv)\b")


def check_restatements(row: Row, domain: Domain) -> None:
    """Raise `RecordError` for a correction or a reading that is not about its row."""
    if row.corrected:
        what = f"correction {row.corrected.latex!r}"
        _compare(what, row.corrected.statement, row, domain, _quantities(row.statement))
    for reading in row.readings:
        _compare(f"reading {reading.text!r}", reading.says, row, domain, _list_sides(row.statement))


def _compare(
    what: str, says: Statement, row: Row, domain: Domain, shown: Iterable[sp.Basic]
) -> None:
    """Require a part that is not void and has a side among `shown`; less of a print in words."""
    ours, own = (_resolve(sides, domain) for sides in (_quantities(row.statement), shown))
    telling = [part for part in _list_parts(says) if not _is_void(part, ours, domain)]
    if not telling:
        raise RecordError(f"{what}: its two sides are the same, so it says nothing about the row")
    if any(own & _resolve(_list_sides(part), domain) for part in telling):
        return
    letters = _letters(row.statement, domain)
    rest, words = _WORDS.subn("", row.printed_latex)
    is_in_words = words > 0 and not _SIGN.search(rest)
    if is_in_words and (not letters or letters & _letters(says, domain)):
        return
    raise RecordError(f"{what}: none of its sides is in the row, so it is about something else")


def _resolve(sides: Iterable[sp.Basic], domain: Domain) -> set[sp.Basic]:
    """Return the sides as written and also with the declared values of their letters."""
    listed = list(sides)
    return {*listed, *map(domain.resolve, listed)}


def _is_void(part: Statement, ours: set[sp.Basic], domain: Domain) -> bool:
    """Return whether a part only compares something other than the row's quantity with itself."""
    if isinstance(part, Holds):
        relations = part.relation.atoms(Relational)
        return any(relation.lhs == relation.rhs for relation in relations)
    if not isinstance(part, Equality) or part.printed != part.rebuilt:
        return False
    is_ours = part.rebuilt_from != "member" and bool(ours & _resolve([part.rebuilt], domain))
    return not is_ours and not isinstance(part.rebuilt, sp.MatrixBase)


def _letters(says: Statement, domain: Domain) -> set[sp.Basic]:
    sides = list(_list_sides(says))
    return set().union(*(side.free_symbols | domain.resolve(side).free_symbols for side in sides))


def _list_parts(says: Statement) -> Iterator[Statement]:
    if isinstance(says, Conjunction | Completions):
        for part, _ in _parts(says, True):
            yield from _list_parts(part)
    else:
        yield says


def _quantities(says: Statement) -> Iterator[sp.Basic]:
    """Yield the row's own quantities, whatever is printed: our side if mechanics gives it."""
    for part in _list_parts(says):
        if isinstance(part, Equality) and part.rebuilt_from == "mechanics":
            yield part.rebuilt
        else:
            yield from _list_sides(part)


def _list_sides(says: Statement) -> Iterator[sp.Basic]:
    for part in _list_parts(says):
        if isinstance(part, Holds):
            for relation in part.relation.atoms(Relational):
                yield from relation.args
            continue
        if isinstance(part, Definition):
            yield part.symbol
        yield from (getattr(part, name) for name in _SIDES.get(type(part), ()))
