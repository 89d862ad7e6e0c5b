"""Equations with a letter alone on a side: they define it, repeat it, or constrain letters.

A print for one place or one range, or of a number, is only that: it gives no general definition.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NoReturn

import sympy as sp

from mechproof.document.known import Known, define_now
from mechproof.document.law_pieces import read_piece
from mechproof.document.row_sides import write_out
from mechproof.document.tasks import Role, Sign
from mechproof.latex import tree
from mechproof.latex.matrix_meaning import is_matrix
from mechproof.latex.measures import find_number
from mechproof.latex.reader import Print
from mechproof.latex.values import find_zero
from mechproof.record import FunctionWithoutArgument, IntegralWithoutDifferential


@dataclass(frozen=True)
class LetterAlone:
    """A letter alone and its equal in the print called `name`: the sides of its sign `left`."""

    name: str
    read: Print
    chain: tree.Chain
    left: int
    node: tree.Node
    symbol: sp.Basic
    value: Any
    sides: tuple[Any, Any]

    @property
    def nodes(self) -> tuple[tree.Node, ...]:
        """Return both sides as they are printed."""
        return self.chain.members[self.left : self.left + 2]

    @property
    def is_matrix(self) -> bool:
        """Return whether it is equal to a vector or a matrix."""
        return is_matrix(self.value)

    def to_sign(self, role: Role, first: str = "") -> Sign:
        """Return a sign between both sides that plays a role for the letter."""
        return Sign(role, self.symbol, first, self.sides)

    def to_number(self, role: Role, letter: sp.Basic | None = None) -> Sign:
        """Return a sign with the number, if any, that is one of its sides."""
        return Sign(role, letter, "", self.sides, *find_number(self.nodes, self.sides))


def is_bare(node: tree.Node) -> bool:
    """Return whether a side is a letter alone, and not a member of a family."""
    return isinstance(node, tree.Letter) and not node.indices


def has_place(nodes: tuple[tree.Node, ...]) -> bool:
    """Return whether sides contain a value at a place or a limit."""
    return any(isinstance(part, tree.At | tree.Approach) for part in tree.walk(nodes))


def compare_with_known(symbol: sp.Basic, known: Known) -> Role:
    """Return the role of another print of a letter, or of a derivative."""
    is_rate = symbol != known.symbols.find_steps(symbol)[1][0]
    return Role.DERIVATIVE if is_rate else Role.REPEATED


def find_role_of_letter(one: LetterAlone, known: Known) -> Sign:
    """Return the role of a sign next to a letter; definitions are entered in `known`.

    Raises `ReadingError` for a matrix that has the letter of a number.
    """
    symbol, value = one.symbol, one.value
    if has_place(one.nodes) and symbol in known.met:
        return one.to_number(Role.VALUE)
    if _is_piece(one, known):
        return one.to_sign(Role.DEFINITION, one.name)
    if not value.free_symbols and not one.is_matrix:
        return one.to_number(Role.NUMBER if symbol in known.values else Role.SIZE, symbol)
    if one.is_matrix and not isinstance(symbol, sp.MatrixSymbol):
        _refuse_matrix(one, known)
    if symbol not in known.values and (found := _find_role_of_new(one, known)):
        return found
    if define_now(one.name, symbol, value, known):
        return Sign(Role.DEFINITION, symbol, one.name)
    if _states_motion(one, known):
        return one.to_sign(Role.CONSTRAINT)
    if symbol in known.values:
        return one.to_sign(compare_with_known(symbol, known), known.printed[symbol])
    if one.is_matrix:
        known.circular.add(symbol)
    return one.to_sign(Role.CONSTRAINT)


def _find_role_of_new(one: LetterAlone, known: Known) -> Sign | None:
    """Return the sign of a letter without a value; None if its value contains it."""
    if _is_special(one, known):
        return one.to_sign(Role.CONSTRAINT)
    if known.follows_from_constraints(one.symbol, one.value):
        known.tied.setdefault(one.symbol, one.value)
        return one.to_sign(Role.CONSTRAINT)
    has_condition = one.chain.condition is not None or bool(known.held[one.name])
    if has_condition and one.symbol in known.constrained:
        return one.to_sign(Role.CONSTRAINT)
    if one.chain.condition is not None:
        return one.to_sign(Role.DEFINITION, one.name)
    if _counts_otherwise(one.symbol, one.value):
        return one.to_sign(Role.CONSTRAINT)
    if known.is_shown(one.symbol, one.value):
        return None
    if not one.value.has(FunctionWithoutArgument, IntegralWithoutDifferential):
        known.define(one.symbol, one.value, one.name)
    return Sign(Role.DEFINITION, one.symbol, one.name)


def _states_motion(one: LetterAlone, known: Known) -> bool:
    r"""Return whether a print says how a vector moves: \dot x=Ax, where x=(q,\dot q).

    Then all entries in which it differs from the derivative are derivatives of single letters.
    """
    if not (one.is_matrix and known.is_derived(one.symbol)):
        return False
    derived = known.settle(known.values[one.symbol])
    printed = write_out(known.settle(one.value))
    is_shown = isinstance(printed, sp.MatrixBase) and printed.shape == derived.shape
    differing = [a for n, a in enumerate(derived) if not (is_shown and a == printed[n])]
    return bool(differing) and all(entry.is_Symbol for entry in differing)


def _is_piece(one: LetterAlone, known: Known) -> bool:
    """Return whether a print is the piece that introduces its law; note the piece."""
    if one.left or not one.chain.condition or one.is_matrix:
        return False
    _note_piece(one.name, one.read, one.chain.condition, (one.symbol, one.value), known)
    is_piece = any(one.name == piece.name for piece in known.laws.get(one.symbol, ()))
    return is_piece and known.printed.get(one.symbol) == known.name_law(one.symbol)


def _refuse_matrix(one: LetterAlone, known: Known) -> NoReturn:
    """Refuse a matrix whose letter is a number, and note its size if that is clear."""
    rows, columns = one.value.shape
    if not any(map(_may_have_vectors, tree.walk(one.nodes))):
        known.sizes[one.symbol] = one.value.shape
    source, node = one.read.source, one.node
    told = f"{source.latex[node.start : node.end]} is a matrix here"
    raise source.refuse(node.start, told, f"Give its size after its name: {rows}x{columns}.")


def _note_piece(
    name: str, read: Print, condition: tree.Chain, sides: tuple[sp.Basic, Any], known: Known
) -> None:
    """Note the value of a letter in a range of the one that it depends on.

    The range may also be of another letter that depends on the same one.
    """
    symbol, value = sides
    by, steps = known.symbols.find_steps(symbol)
    if by in steps:
        return
    relations = [_show_range(one, by, known) for one in read.meaning().relate(condition)]
    given = {s: known.settle(s) for s in value.free_symbols & known.values.keys()}
    value = value.xreplace({s: v for s, v in given.items() if by in v.free_symbols})
    said = {letter for relation in relations for letter in relation.free_symbols}
    with_it = {x for x in said & value.free_symbols if known.symbols.find_steps(x)[0] == by}
    for letter in (by, *sorted(with_it - {*steps}, key=str)):
        if piece := read_piece(name, value, relations, letter):
            known.pieces.setdefault(symbol, []).append(piece)
            return


def _show_range(relation: sp.Basic, by: sp.Basic, known: Known) -> sp.Basic:
    r"""Turn a bound of a letter defined by `by` into a bound of `by`: 0<=\theta/\beta.

    The letter must grow with `by`, as seen from the letters that are declared positive.
    """
    letter = next((s for s in relation.free_symbols if s in known.values), None)
    is_order = isinstance(relation, sp.Lt | sp.Le | sp.Gt | sp.Ge) and letter in relation.args
    value = known.settle(letter) if is_order else None
    if not isinstance(value, sp.Expr):
        return relation
    slope, end = sp.diff(value, by), find_zero(relation.lhs - relation.rhs, letter)
    positive = {
        v.symbol: sp.Dummy(positive=True)
        for v in known.symbols.variables
        if v.within.is_subset(sp.Interval.open(0, sp.oo))
    }
    if end is None or not slope.xreplace(positive).is_positive:
        return relation
    point = find_zero(value - end, by)
    order = type(relation) if relation.lhs == letter else relation.reversed.func
    return relation if point is None else order(by, point)


def _is_special(one: LetterAlone, known: Known) -> bool:
    """Return whether a print equates letters, or a letter and a number, at a special position.

    A letter may be equated with another, with its negative, or with one of these plus a number.
    This is not so if the letter was not met before, the chain has no number, and the text announces
    nothing.
    """
    terms = [term for term in sp.Add.make_args(one.value) if not term.is_number]
    alone = terms[0] if len(terms) == 1 else one.value
    is_letter = alone.is_Symbol or (-alone).is_Symbol or isinstance(one.value, sp.MatrixSymbol)
    has_number = any(isinstance(member, tree.Number | tree.Measure) for member in one.chain.members)
    return is_letter and (one.symbol in known.met or has_number or known.said.is_equating)


def _counts_otherwise(symbol: sp.Basic, value: Any) -> bool:
    """Return whether a letter is an integer although its printed value need not be one."""
    is_count = value.is_integer and (value.is_positive or not symbol.is_positive)
    return bool(symbol.is_integer) and not is_count


def _may_have_vectors(node: tree.Node) -> bool:
    """Return whether a product contains a letter read as a number next to a matrix."""
    factors = node.factors if isinstance(node, tree.Product) else ()
    has_matrix = any(tree.shows_matrix(part) for part in tree.walk(factors))
    return has_matrix and any(
        isinstance(x, tree.Letter) and not tree.shows_matrix(x) for x in factors
    )
