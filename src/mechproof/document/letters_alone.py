"""Equations of which a side is a letter alone: they define it, repeat it, or constrain letters.

What is said at a place, in a range or of a number is that alone, and defines nothing.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NoReturn

import sympy as sp

from mechproof.document.known import Known, define_now, read_piece
from mechproof.document.tasks import Role, Sign
from mechproof.latex import tree
from mechproof.latex.matrix_meaning import is_matrix
from mechproof.latex.measures import find_number
from mechproof.latex.reader import Print


@dataclass(frozen=True)
class LetterAlone:
    """A letter alone and what it is equal to, in a print of a name: the sides of sign `left`."""

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
        """Return a sign between both sides that does so to the letter."""
        return Sign(role, self.symbol, first, self.sides)

    def to_number(self, role: Role, letter: sp.Basic | None = None) -> Sign:
        """Return a sign beside a number, if one of the sides is any."""
        return Sign(role, letter, "", self.sides, *find_number(self.nodes, self.sides))


def is_bare(node: tree.Node) -> bool:
    """Return whether a side is a letter alone, and of no family."""
    return isinstance(node, tree.Letter) and not node.indices


def has_place(nodes: tuple[tree.Node, ...]) -> bool:
    """Return whether a value at a place is taken."""
    return any(isinstance(part, tree.At | tree.Approach) for part in tree.walk(nodes))


def compare_with_known(symbol: sp.Basic, known: Known) -> Role:
    """Return what a further print of a letter is, or of a rate."""
    is_rate = symbol != known.symbols.find_steps(symbol)[1][0]
    return Role.DERIVATIVE if is_rate else Role.REPEATED


def find_role_of_letter(one: LetterAlone, known: Known) -> Sign:
    """Return what a sign beside a letter does; what it defines is known then.

    Raises `ReadingError` for a matrix that is called by the letter of a number.
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
    if symbol in known.values:
        return one.to_sign(compare_with_known(symbol, known), known.printed[symbol])
    if one.is_matrix:
        known.circular.add(symbol)
    return one.to_sign(Role.CONSTRAINT)


def _find_role_of_new(one: LetterAlone, known: Known) -> Sign | None:
    """Return what a sign does to a letter without a value; nothing for one that is a circle."""
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
    known.define(one.symbol, one.value, one.name)
    return Sign(Role.DEFINITION, one.symbol, one.name)


def _is_piece(one: LetterAlone, known: Known) -> bool:
    """Return whether a print is the piece of a law that it introduces; note what it says there."""
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
    raise source.refuse(node.start, told, f"Say its size behind its name: {rows}x{columns}.")


def _note_piece(
    name: str, read: Print, condition: tree.Chain, sides: tuple[sp.Basic, Any], known: Known
) -> None:
    """Note what is printed of a letter in a range of the one on which it depends.

    Or of another one that depends on the same.
    """
    symbol, value = sides
    by, steps = known.symbols.find_steps(symbol)
    if by in steps:
        return
    relations = read.meaning().relate(condition)
    said = {letter for relation in relations for letter in relation.free_symbols}
    with_it = {x for x in said & value.free_symbols if known.symbols.find_steps(x)[0] == by}
    for letter in (by, *sorted(with_it - {*steps}, key=str)):
        if piece := read_piece(name, value, relations, letter):
            known.pieces.setdefault(symbol, []).append(piece)
            return


def _is_special(one: LetterAlone, known: Known) -> bool:
    """Return whether a letter is said to be another one, or both a number, at a special position.

    It may be its opposite, or turned. A letter that is introduced so has not been met before, and
    no words tell of a special position.
    """
    terms = [term for term in sp.Add.make_args(one.value) if not term.is_number]
    alone = terms[0] if len(terms) == 1 else one.value
    is_letter = alone.is_Symbol or (-alone).is_Symbol or isinstance(one.value, sp.MatrixSymbol)
    has_number = any(isinstance(member, tree.Number | tree.Measure) for member in one.chain.members)
    return is_letter and (one.symbol in known.met or has_number or known.said.is_equating)


def _counts_otherwise(symbol: sp.Basic, value: Any) -> bool:
    """Return whether a letter is said to count, and what is printed of it need not be a count."""
    is_count = value.is_integer and (value.is_positive or not symbol.is_positive)
    return bool(symbol.is_integer) and not is_count


def _may_have_vectors(node: tree.Node) -> bool:
    """Return whether a letter that is taken as a number stands beside a matrix as a factor."""
    factors = node.factors if isinstance(node, tree.Product) else ()
    has_matrix = any(tree.shows_matrix(part) for part in tree.walk(factors))
    return has_matrix and any(
        isinstance(x, tree.Letter) and not tree.shows_matrix(x) for x in factors
    )
