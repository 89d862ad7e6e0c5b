"""Two members and the sign between them -> what the sign asserts."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp

from mechproof.latex.extrema import state_extremum
from mechproof.latex.matrix_meaning import is_matrix, is_power, says_from_one_on, state_power
from mechproof.latex.measures import find_factor
from mechproof.latex.printed_relations import EQUAL, STATED
from mechproof.latex.reader import Reader
from mechproof.latex.sides import name_entries, round_to, says_nothing, turn
from mechproof.latex.tree import Extremum, Letter, Node, walk
from mechproof.latex.values import depends, find_ratio, settle, settle_all
from mechproof.record import (
    Definition,
    Distinct,
    Equality,
    FunctionWithoutArgument,
    Holds,
    IntegralWithoutDifferential,
    Nearly,
    PrintedNumber,
    Row,
    Statement,
)


@dataclass(frozen=True)
class Members:
    """Both members as printed, and read with the derived values at hand."""

    nodes: tuple[Node, Node]
    printed: tuple[Any, Any]
    derived: tuple[Any, Any]


def _turn_rows(members: Members) -> Members:
    """Return members in which comma-separated entries become a column if the other is a column."""
    nodes = members.nodes
    return Members(nodes, turn(nodes, members.printed), turn(nodes, members.derived))


def state(row: Row, sign: str, members: Members, reader: Reader) -> Statement:
    """Return what a relation sign of a row asserts.

    Raises `ValueError` if the declarations do not determine it.
    """
    if any(map(is_power, members.printed)):
        return _state_power(row, sign, members, reader)
    members = _turn_rows(members)
    if any(isinstance(node, Extremum) for node in members.nodes):
        return _state_extremum(row, sign, members, reader)
    if sign == r"\approx":
        return _round(row, members, reader)
    if sign not in EQUAL:
        return _relate(row, sign, members, reader)
    if row.residual is not None:
        return _state_residual(row, row.residual, members)
    if rounded := _find_rounded(row, members, reader):
        return rounded
    sides = left, right = _derive(row, members, reader)
    changed = tuple(
        _is_derived(row, node, member, reader)
        for node, member in zip(members.nodes, members.printed, strict=True)
    )
    if not any(changed):
        defined = _find_definition(row, members, reader)
        if defined:
            return defined
        if not any(_is_faulty(side, reader) for side in sides):
            _refuse_unknown(row, members, reader)
    if says_nothing(left, right):
        _refuse_unknown_entries(row, left, right)
    left, right = (_substitute(row, name_entries(side)) for side in sides)
    if not any(changed):
        return Equality(left, right, "member")
    if changed == (False, True):
        return Equality(left, right)
    return Equality(right, left)


def _state_power(row: Row, sign: str, members: Members, reader: Reader) -> Statement:
    """State a power of a matrix to a letter that no other declaration or condition restricts."""
    sides = members.printed
    where = [one for one in (row.on.where if row.on else ()) if not says_from_one_on(one)]
    said = {symbol for one in where for symbol in one.free_symbols}
    said |= {v.symbol for v in reader.variables if v.given is not None}
    all_numbers = (sp.S.Naturals, sp.S.Naturals0)
    free = {v.symbol for v in reader.variables if v.within in all_numbers} - said
    has_values = any(side.free_symbols & said for side in sides if hasattr(side, "free_symbols"))
    stated = state_power(sides, free) if sign == "=" and not has_values else None
    if stated is None:
        raise ValueError(
            f"row {row.number!r}: a matrix power to a whole number must be alone on one side, "
            "with its value for all numbers on the other"
        )
    return stated


def _state_extremum(row: Row, sign: str, members: Members, reader: Reader) -> Statement:
    sides = _derive(row, members, reader)
    if isinstance(members.nodes[1], Extremum):
        sides = sides[::-1]
    node = next(node for node in members.nodes if isinstance(node, Extremum))
    if sign != "=" or all(isinstance(node, Extremum) for node in members.nodes):
        raise ValueError(
            f"row {row.number!r}: one \\{node.name} is read, on one side of an equals sign"
        )
    within = next((v.within for v in reader.variables if v.symbol == node.by.symbol), sp.S.Reals)
    stated = state_extremum(node, sides, reader.values, within)
    if stated is None:
        raise ValueError(
            f"row {row.number!r}: no stationary point or end was found where it is {sides[1]}"
        )
    return stated


def _state_residual(row: Row, residual: sp.Expr, members: Members) -> Equality:
    """State that the difference of the members equals a residual, up to the sign of the latter."""
    left, right = members.printed
    _refuse_unknown_entries(row, left, right)
    if isinstance(left, sp.MatrixBase) != isinstance(right, sp.MatrixBase):
        raise ValueError(f"row {row.number!r}: a number and a matrix have no residual")
    ratio = find_ratio(left - right, residual)
    is_opposite = ratio is not None and abs(ratio + 1) < 1e-9
    return Equality(right - left if is_opposite else left - right, residual)


def _is_derived(row: Row, node: Node, member: Any, reader: Reader) -> bool:
    """Return whether the row gives a derived value for a member or for anything it depends on."""
    letters = {part.symbol for part in walk(node) if isinstance(part, Letter)}
    keys = row.derived.keys()
    return member in row.derived or any(depends(s, keys, reader.values) for s in letters)


def _derive(row: Row, members: Members, reader: Reader) -> tuple[Any, Any]:
    """Return both members with the row's derived values put in."""
    left, right = (
        row.derived[member] if member in row.derived else settle(value, reader.values, row.derived)
        for member, value in zip(members.printed, members.derived, strict=True)
    )
    return left, right


def _substitute(row: Row, member: Any) -> Any:
    return member.xreplace(dict(row.substituted))


def _put_in(row: Row, members: Members, reader: Reader) -> tuple[Any, Any]:
    """Return both members with the row's derived values and then its substitutions put in."""
    left, right = (_substitute(row, side) for side in _derive(row, members, reader))
    return left, right


def _relate(row: Row, sign: str, members: Members, reader: Reader) -> Statement:
    left, right = _put_in(row, members, reader)
    _refuse_unknown_entries(row, left, right)
    matrices = [side for side in (left, right) if isinstance(side, sp.MatrixBase)]
    if any(matrix.is_zero_matrix for matrix in matrices):
        raise ValueError(f"row {row.number!r}: whether a matrix is zero somewhere is not judged")
    if sign == r"\ne" and isinstance(left, sp.MatrixBase):
        return Distinct(left, right)
    if matrices:
        raise ValueError(f"row {row.number!r}: matrices cannot be ordered by {sign}")
    return Holds(STATED[sign](left, right, evaluate=False))


def _round(row: Row, members: Members, reader: Reader) -> Statement:
    """State that the left member rounds to the number on the right, or to a multiple of it.

    If the number is a factor, the rest of the right member is moved to the left, which is then a
    number. Any other sides are only stated to be nearly equal.
    """
    value, right = _put_in(row, members, reader)
    stated = round_to(members.nodes[1], value)
    if stated and value in row.defines:
        return Definition(value, right)
    is_open = not (row.derived or value.is_Symbol)
    if stated and is_open and settle_all(value, reader.values).free_symbols:
        return Nearly(value, right)
    number = find_factor(members.nodes) and find_factor(members.nodes[1:])
    are_numbers = not any(is_matrix(side) for side in (value, right))
    if stated is None and number and are_numbers:
        above, below = (settle_all(side, reader.values) for side in (value, right))
        ratio = sp.cancel(sp.Rational(number) * above / below) if below != 0 else sp.nan
        is_number = ratio.is_finite and not ratio.free_symbols
        stated = PrintedNumber(number, ratio) if is_number else None
    return stated or Nearly(value, right)


def _find_rounded(row: Row, members: Members, reader: Reader) -> PrintedNumber | None:
    """State that a constant rounds to the decimal on the other side of an equals sign.

    Returns None for a decimal that is exactly the constant, and for a whole number: those are
    stated as equal.
    """
    values = _put_in(row, members, reader)
    for node, value, number in zip(members.nodes[::-1], values, values[::-1], strict=True):
        stated = round_to(node, value) if isinstance(value, sp.Expr) else None
        if stated is None or "." not in stated.printed:
            continue
        constant = settle_all(value, reader.values)
        if not constant.free_symbols and constant != number:
            return stated
    return None


def _find_definition(row: Row, members: Members, reader: Reader) -> Definition | None:
    """Return the definition that a sign prints: of a symbol it introduces or its declared value."""
    left, right = members.printed
    for node, other in zip(members.nodes, (right, left), strict=True):
        if isinstance(node, Letter) and not node.indices and _introduces(row, node, other, reader):
            return Definition(node.symbol, other)
    printed = left.free_symbols | right.free_symbols
    for symbol in sorted(printed & reader.values.keys(), key=str):
        value = reader.values[symbol]
        if value.free_symbols <= printed and _is_declared_by(symbol, value, members):
            return Definition(symbol, value)
    return None


def _introduces(row: Row, letter: Letter, other: Any, reader: Reader) -> bool:
    """Return whether the row defines a symbol, or prints the matrix that it is declared as."""
    symbol = letter.symbol
    is_new = symbol in row.defines and symbol not in other.free_symbols
    return is_new or (isinstance(symbol, sp.MatrixSymbol) and reader.values.get(symbol) == other)


def _is_declared_by(symbol: sp.Basic, value: sp.Basic, members: Members) -> bool:
    """Return whether the print, solved for a symbol, gives the declared value."""
    left, right = members.printed
    if isinstance(left, sp.MatrixBase) or isinstance(right, sp.MatrixBase):
        return False
    difference = left - right
    slope = sp.diff(difference, symbol)
    if slope == 0 or slope.has(symbol):
        return False
    return bool(sp.expand(sp.together(difference.xreplace({symbol: value}))) == 0)


def _refuse_unknown(row: Row, members: Members, reader: Reader) -> None:
    """Refuse a member that is a symbol without a declared value: nothing can be compared to it."""
    for member, other in (members.printed, members.printed[::-1]):
        is_bare = isinstance(member, sp.Symbol | sp.Indexed | sp.MatrixSymbol)
        if is_bare and member not in reader.values and member not in other.free_symbols:
            raise _describe_unknown(row, member)


def _refuse_unknown_entries(row: Row, *sides: Any) -> None:
    """Refuse matrices without known entries: nothing can be compared to them."""
    for symbol in sorted({s for side in sides for s in side.atoms(sp.MatrixSymbol)}, key=str):
        raise _describe_unknown(row, symbol)


def _describe_unknown(row: Row, symbol: sp.Basic) -> ValueError:
    return ValueError(
        f"row {row.number!r}: nothing is known about {symbol}: give its value by our "
        "mechanics (`derived`), or mark it as introduced by the print (`defines`)"
    )


def _is_faulty(member: Any, reader: Reader) -> bool:
    """Return whether a member is visibly impossible to evaluate, e.g. contains unknown symbols."""
    if member.has(IntegralWithoutDifferential, FunctionWithoutArgument):
        return True
    known = {getattr(v.symbol, "label", v.symbol) for v in reader.variables}
    known |= {v.symbol for v in reader.variables}
    return bool(member.free_symbols - member.atoms(sp.Indexed) - known)
