"""What each relation sign of a paper does: introduces a letter, compares, or constrains.

What is printed first of a letter defines it. Later prints of it, derivatives of it and the further
members of a chain are compared. Two compound sides, or a side that is zero, constrain letters. A
bare number is a size.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from itertools import pairwise, takewhile
from typing import Any

import sympy as sp

from mechproof.document.calculated_sizes import find_span
from mechproof.document.calculations import add_calculations
from mechproof.document.known import Known
from mechproof.document.later_matrices import define_now
from mechproof.document.laws import read_piece
from mechproof.latex import ReadingError
from mechproof.latex.expansion import name_ordinal
from mechproof.latex.measures import find_factor, find_number, is_number, name_unit_behind
from mechproof.latex.reader import Print
from mechproof.latex.sides import list_arcs, turn
from mechproof.latex.tree import (
    Approach,
    At,
    Chain,
    Derivation,
    Extremum,
    Integration,
    Letter,
    Measure,
    Node,
    Number,
    Product,
    shows_matrix,
    walk,
)
from mechproof.nomenclature.relations import read_relations

EQUAL = ("=", r"\equiv")


class Role(StrEnum):
    """What a relation sign does."""

    DEFINITION = "definition"
    SIZE = "size"
    REPEATED = "printed again"
    DERIVATIVE = "derivative"
    STEP = "step"
    NUMBER = "number"
    VALUE = "value at a place"
    CONSTRAINT = "constraint"
    SOLUTIONS = "both solutions"
    SEAM = "seam"
    RELATION = "relation"


# What is taken as given.
CONSTRAINING = (Role.CONSTRAINT, Role.SOLUTIONS)
# A letter over which a part of a print goes alone, and the letters of that part.
Varied = tuple[sp.Basic, frozenset[sp.Basic]]


@dataclass(frozen=True)
class Sign:
    """One relation sign: its role, the letter that it is about, who printed it first; its sides.

    `number` are the digits of a side that is a number, `unit` is that behind them and `value` the
    other side then; `given` are the digits and the unit of that, if it is a number with a unit,
    too. `worked_out` tells which sides are no print: derivatives, and what matrices
    give. `printed` are the letters of both sides as they are printed, `factor`
    the digits of their only decimal, if it is a factor. `varied` are letters over which a part goes
    alone, by which it is differentiated or integrated, or of which a value is put in, each with
    the letters of that part. `formula` is what stands before a calculation that a number is of,
    `span` between what this lies whose decimals are rounded, `is_calculated` tells that it is one.
    Of two calculations `span` is that of their difference.
    Of an inequality `units` are the units of its sides, and `limited` the sides if one has any.
    """

    role: Role
    letter: sp.Basic | None = None
    first: str = ""
    sides: tuple[Any, Any] = (None, None)
    number: str = ""
    value: Any = None
    unit: str = ""
    given: tuple[str, str] = ("", "")
    worked_out: tuple[bool, bool] = (False, False)
    printed: frozenset[sp.Basic] = frozenset()
    varied: tuple[Varied, ...] = ()
    factor: str = ""
    formula: Any = None
    span: tuple[float, float] | None = None
    is_calculated: bool = False
    units: tuple[str, str] = ("", "")
    limited: tuple[Any, Any] = (None, None)


def give_values(text: str, known: Known) -> None:
    """Take relations, k=a/b, as definitions; `ValueError` for what is none."""
    for relation in read_relations(text, known.symbols.reader()):
        is_letter = isinstance(relation.lhs, sp.Symbol | sp.MatrixSymbol)
        if not (isinstance(relation, sp.Equality) and is_letter):
            raise ValueError(f"let: {text}: a value is written letter=expression")
        symbol, value = relation.args
        if symbol in known.values or symbol in known.settle(value).free_symbols:
            raise ValueError(f"let: {text}: it has a value already, or is given by itself")
        known.define(symbol, value, "the block of letters")


def find_roles(name: str, read: Print, known: Known) -> list[Sign]:
    """Return the roles of the signs of a print, in their order; what it defines is known then.

    Raises `ReadingError` for members that cannot be worked out.
    """
    signs = []
    for chain in read.chains:
        found = [_find_role(name, read, chain, n, known) for n in range(len(chain.relations))]
        given = [_is_worked_out(node) for node in chain.members]
        put_in = (*_list_put_in(chain),)
        found = [
            replace(
                sign,
                worked_out=is_not,
                printed=_list_letters(nodes),
                factor=find_factor(nodes),
                varied=(*put_in, *_list_varied(nodes)),
            )
            for sign, is_not, nodes in zip(
                found, pairwise(given), pairwise(chain.members), strict=True
            )
        ]
        _note_others(name, found, known)
        signs += add_calculations(read, chain, found, known.symbols.list_exact())
    for sign in signs:
        if sign.role is Role.CONSTRAINT:
            known.constrained.update(*(side.free_symbols for side in sign.sides))
    for chain in read.chains:
        known.met.update(_list_letters(chain))
    return signs


def _list_letters(nodes: Any) -> frozenset[sp.Basic]:
    return frozenset(part.symbol for part in walk(nodes) if isinstance(part, Letter))


def _list_varied(nodes: Any) -> Iterator[Varied]:
    """Yield letters over which parts go, with the letters of what is taken there."""
    for part in walk(nodes):
        if isinstance(part, At | Approach | Extremum):
            yield part.by.symbol, _list_letters(part.term)
        elif isinstance(part, Derivation) and not part.is_partial:
            yield part.by.symbol, _list_letters(part.of)
        elif isinstance(part, Integration) and isinstance(part.differential, Letter):
            yield part.differential.symbol, _list_letters(part.integrand)


def _list_put_in(chain: Chain) -> Iterator[Varied]:
    """Yield the letters of which the condition of a chain says the value."""
    said = chain.condition
    if said is not None and {*said.relations} & {*EQUAL}:
        members = _list_letters(chain.members)
        yield from ((one.symbol, members) for one in said.members if isinstance(one, Letter))


def _find_role(name: str, read: Print, chain: Chain, left: int, known: Known) -> Sign:
    nodes = chain.members[left : left + 2]
    is_rounded = chain.relations[left] == r"\approx" and is_number(nodes[1])
    if chain.relations[left] == r"\approx" and find_factor(nodes) and find_factor(nodes[1:]):
        return _find_role_of_factor(nodes, read, known)
    if chain.relations[left] not in EQUAL and not is_rounded:
        units = (name_unit_behind(nodes[0]), name_unit_behind(nodes[1]))
        limited = (_work_out(read, nodes[0], known), _work_out(read, nodes[1], known))
        return Sign(Role.RELATION, units=units, limited=limited if any(units) else (None, None))
    has_place = any(isinstance(part, At | Approach) for part in walk(nodes))
    for node in nodes:
        if isinstance(node, Extremum):
            _refuse_range(read, chain, node, known)
            return _find_role_of_extremum(name, read, chain, left, known)
    try:
        worked_out = _work_out(read, nodes[0], known), _work_out(read, nodes[1], known)
        sides = one, other = turn((nodes[0], nodes[1]), worked_out)
    except ReadingError:
        if has_place:
            # What it is a value of may be printed behind it.
            return Sign(Role.VALUE)
        raise
    _note_arcs(read, nodes, sides, known)
    for node, symbol, value in ((nodes[0], one, other), (nodes[1], other, one)):
        if not _is_bare(node):
            continue
        symbol = node.symbol if isinstance(node, Letter) else symbol
        if has_place and symbol in known.met:
            return Sign(Role.VALUE, None, "", sides, *find_number(nodes, sides))
        is_matrix = isinstance(value, sp.MatrixBase | sp.MatrixExpr)
        if not left and chain.condition and not is_matrix:
            _note_piece(name, read, chain.condition, (symbol, value), known)
            is_piece = any(name == one.name for one in known.laws.get(symbol, ()))
            if is_piece and known.printed.get(symbol) == known.name_law(symbol):
                return Sign(Role.DEFINITION, symbol, name, sides)
        if not value.free_symbols and not is_matrix:
            role = Role.NUMBER if symbol in known.values else Role.SIZE
            return Sign(role, symbol, "", sides, *find_number(nodes, sides))
        is_fit = is_matrix <= isinstance(symbol, sp.MatrixSymbol)
        if not is_fit:
            if not any(map(_may_have_vectors, walk(nodes))):
                known.sizes[symbol] = value.shape
            remedy = f"Say its size behind its name: {value.shape[0]}x{value.shape[1]}."
            letter = read.source.latex[node.start : node.end]
            raise read.source.refuse(node.start, f"{letter} is a matrix here", remedy)
        if symbol not in known.values and _is_special(symbol, value, chain, known):
            return Sign(Role.CONSTRAINT, symbol, sides=sides)
        if symbol not in known.values and known.follows_from_constraints(symbol, value):
            known.tied.setdefault(symbol, value)
            return Sign(Role.CONSTRAINT, symbol, sides=sides)
        if symbol not in known.values and chain.condition is not None:
            return Sign(Role.DEFINITION, symbol, name, sides)
        if symbol not in known.values and _counts_otherwise(symbol, value):
            return Sign(Role.CONSTRAINT, symbol, sides=sides)
        if symbol not in known.values and not known.is_shown(symbol, value):
            known.define(symbol, value, name)
            return Sign(Role.DEFINITION, symbol, name)
        if define_now(name, symbol, value, known):
            return Sign(Role.DEFINITION, symbol, name)
        if symbol in known.values:
            return Sign(_compare(symbol, known), symbol, known.printed[symbol], sides)
        if is_matrix:
            known.circular.add(symbol)
        return Sign(Role.CONSTRAINT, symbol, sides=sides)
    if has_place:
        return Sign(Role.VALUE, None, "", sides, *find_number(nodes, sides))
    if any(isinstance(node, Derivation) for node in nodes):
        return Sign(Role.DERIVATIVE, sides=sides)
    if not left:
        return Sign(Role.CONSTRAINT, None, "", sides, *find_number(nodes, sides))
    if not (one.free_symbols and other.free_symbols):
        return Sign(Role.NUMBER, None, "", sides, *find_number(nodes, sides))
    return Sign(Role.STEP, sides=sides)


def _find_role_of_factor(nodes: tuple[Node, ...], read: Print, known: Known) -> Sign:
    """Return that a rounded factor is compared; that of a new letter defines nothing."""
    sides = _work_out(read, nodes[0], known), _work_out(read, nodes[1], known)
    if not _is_bare(nodes[0]):
        return Sign(Role.STEP, sides=sides)
    symbol = sides[0]
    role = _compare(symbol, known) if symbol in known.values else Role.RELATION
    return Sign(role, symbol, known.printed.get(symbol, ""), sides)


def _note_arcs(read: Print, nodes: tuple[Node, ...], sides: tuple[Any, Any], known: Known) -> None:
    """Note what angles are whose sine, cosine or tangent is printed.

    A number is rounded, and so is what has rounded decimals. What numbers give is of their passage.
    """
    exact = known.symbols.list_exact()
    for function, arc in list_arcs(sides):
        angle = function.args[0]
        if arc.free_symbols:
            known.arcs.setdefault(angle, []).append(arc)
        elif arc.is_real and not any(is_number(x) or find_span(read, x, exact) for x in nodes):
            known.angles.setdefault((known.said.passage, angle), []).append((function.func, arc))


def _find_role_of_extremum(name: str, read: Print, chain: Chain, left: int, known: Known) -> Sign:
    """Return that a letter is introduced as the largest or smallest value, which follows."""
    first, *others = chain.members[left:]
    if left or not (isinstance(first, Letter) and _is_bare(first)) or first.symbol in known.values:
        return Sign(Role.VALUE)
    if others[1:]:
        known.define(first.symbol, _work_out(read, others[1], known), name)
        return Sign(Role.DEFINITION, first.symbol, name)
    return Sign(Role.VALUE, first.symbol)


def _is_worked_out(node: Node) -> bool:
    return any(
        isinstance(part, Derivation)
        or (isinstance(part, Letter) and isinstance(part.symbol, sp.MatrixSymbol))
        for part in walk(node)
    )


def _note_piece(
    name: str, read: Print, condition: Chain, sides: tuple[sp.Basic, Any], known: Known
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


def _refuse_range(read: Print, chain: Chain, node: Extremum, known: Known) -> None:
    """Refuse what is said of the letter that moves, besides the set in which it lies."""
    said = {part.symbol for part in walk(chain.condition) if isinstance(part, Letter)}
    said |= {symbol for relation in known.symbols.where for symbol in relation.free_symbols}
    if node.by.symbol in said:
        raise read.source.refuse(
            node.by.start,
            f"a range of {node.by.text} that is not said where it is declared",
            f"Say it in the block of letters behind {node.by.text}: {{0<{node.by.text}<1}}",
        )


def name_member(number: int, name: str) -> str:
    """Return how a member of an equation is called, counted from the letter on."""
    return f"the {name_ordinal(number)} member of {name}"


def _note_others(name: str, signs: Sequence[Sign], known: Known) -> None:
    """Note the further members of a chain that defines a letter."""
    if not signs or known.printed.get(signs[0].letter) != name:
        return
    letter = signs[0].letter
    for number, sign in takewhile(lambda one: one[1].role is Role.STEP, enumerate(signs[1:], 3)):
        value = sign.sides[1]
        if letter not in known.settle(value, {letter}).free_symbols:
            known.others.setdefault(letter, []).append((name_member(number, name), value))


def _is_special(symbol: sp.Basic, value: Any, chain: Chain, known: Known) -> bool:
    """Return whether a letter is said to be another one, or both a number, at a special position.

    It may be its opposite, or turned. A letter that is introduced so has not been met before, and
    no words tell of a special position.
    """
    terms = [term for term in sp.Add.make_args(value) if not term.is_number]
    alone = terms[0] if len(terms) == 1 else value
    is_letter = alone.is_Symbol or (-alone).is_Symbol or isinstance(value, sp.MatrixSymbol)
    has_number = any(isinstance(member, Number | Measure) for member in chain.members)
    return is_letter and (symbol in known.met or has_number or known.said.is_equating)


def _counts_otherwise(symbol: sp.Basic, value: Any) -> bool:
    """Return whether a letter is said to count, and what is printed of it need not be a count."""
    is_count = value.is_integer and (value.is_positive or not symbol.is_positive)
    return bool(symbol.is_integer) and not is_count


def _may_have_vectors(node: Node) -> bool:
    """Return whether a letter that is taken as a number stands beside a matrix as a factor."""
    factors = node.factors if isinstance(node, Product) else ()
    has_matrix = any(shows_matrix(part) for part in walk(factors))
    return has_matrix and any(isinstance(x, Letter) and not shows_matrix(x) for x in factors)


def _compare(symbol: sp.Basic, known: Known) -> Role:
    is_rate = symbol != known.symbols.find_steps(symbol)[1][0]
    return Role.DERIVATIVE if is_rate else Role.REPEATED


def _is_bare(node: Node) -> bool:
    return isinstance(node, Letter) and not node.indices


def _work_out(read: Print, node: Node, known: Known) -> Any:
    """Return a member, with the values of letters where it cannot be said without them.

    That is what is integrated by a letter on which it depends.
    """
    integrals = [part for part in walk(node) if isinstance(part, Integration)]
    running = {p.symbol for i in integrals for p in walk(i.differential) if isinstance(p, Letter)}
    moving = {
        s: v for s, v in known.values.items() if running and known.settle(v).free_symbols & running
    }
    matrices = {**known.list_matrices(), **known.entries}
    try:
        return read.meaning({**matrices, **moving}).of(node)
    except ReadingError:
        return read.meaning({**known.tied, **known.values, **known.entries}).of(node)
