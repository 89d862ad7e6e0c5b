"""The relation signs of a print, one after another: the role of each, and its effect on `Known`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise, takewhile
from typing import Any

import sympy as sp

from mechproof.document.known import BLOCK, Known
from mechproof.document.letters_alone import (
    LetterAlone,
    compare_with_known,
    find_role_of_letter,
    has_place,
    is_bare,
)
from mechproof.document.numbers.calculated_sizes import add_calculations, find_span
from mechproof.document.tasks import Role, Sign, Varied
from mechproof.latex import ReadingError
from mechproof.latex.expansion import name_ordinal
from mechproof.latex.measures import find_factor, find_number, is_number, name_unit_after
from mechproof.latex.printed_relations import EQUAL
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
    Node,
    strip,
    walk,
)
from mechproof.nomenclature.said_relations import read_relations


def give_values(text: str, known: Known) -> None:
    """Take relations, k=a/b, as definitions; raises `ValueError` for any other text."""
    for relation in read_relations(text, known.symbols.reader()):
        is_letter = isinstance(relation.lhs, sp.Symbol | sp.MatrixSymbol)
        if not (isinstance(relation, sp.Equality) and is_letter):
            raise ValueError(f"let: {text}: a value is written letter=expression")
        symbol, value = relation.args
        if known.is_derived(symbol) and known.settle(value) == known.settle(symbol):
            continue
        if symbol in known.values or symbol in known.settle(value).free_symbols:
            raise ValueError(f"let: {text}: it already has a value, or is defined by itself")
        if symbol.is_integer and not known.settle(value).is_integer:
            raise ValueError(
                f"let: {text}: {symbol} is a whole number, which {value} is not shown to be"
            )
        if isinstance(value, sp.MatrixBase) and isinstance(symbol, sp.Symbol):
            size = "x".join(map(str, value.shape))
            raise ValueError(f"let: {text}: it is a matrix, so declare its size: {symbol} {size}")
        known.define(symbol, value, BLOCK)


def find_roles(name: str, read: Print, known: Known) -> list[Sign]:
    """Return the roles of a print's signs, in order, and enter its definitions in `known`.

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
                **_find_places(nodes, read),
            )
            for sign, is_not, nodes in zip(
                found, pairwise(given), pairwise(chain.members), strict=True
            )
        ]
        _note_others(name, found, known)
        if chain.condition is None and not known.said.example.number:
            _note_again(name, found, known)
        signs += add_calculations(read, chain, found, known.symbols.list_exact())
    for sign in signs:
        if sign.role is Role.CONSTRAINT:
            known.constrained.update(*(side.free_symbols for side in sign.sides))
    for chain in read.chains:
        letters = _list_letters(chain)
        known.met.update(letters)
        for letter in letters:
            known.shown_in.setdefault(letter, set()).add(known.said.example.number)
    return signs


def _list_letters(nodes: Any) -> frozenset[sp.Basic]:
    return frozenset(part.symbol for part in walk(nodes) if isinstance(part, Letter))


def _list_varied(nodes: Any) -> Iterator[Varied]:
    """Yield letters by which parts are integrated, differentiated etc., with the parts' letters."""
    for part in walk(nodes):
        if isinstance(part, At | Approach | Extremum):
            yield part.by.symbol, _list_letters(part.term)
        elif isinstance(part, Derivation) and not part.is_partial:
            yield part.by.symbol, _list_letters(part.of)
        elif isinstance(part, Integration) and isinstance(part.differential, Letter):
            yield part.differential.symbol, _list_letters(part.integrand)


def _find_places(nodes: tuple[Node, ...], read: Print) -> dict[str, Any]:
    """Return the places of a side that is a value at a place, and the other side's letters."""
    for node, other in (nodes, nodes[::-1]):
        places, inside = dict[sp.Basic, sp.Expr](), strip(node)
        while isinstance(inside, At):
            places[inside.by.symbol] = read.meaning().of(inside.point)
            inside = strip(inside.term)
        if places and not has_place((inside, other)):
            are_numbers = all(point.is_number for point in places.values())
            return {"places": places, "beside": _list_letters(other)} if are_numbers else {}
    return {}


def _list_put_in(chain: Chain) -> Iterator[Varied]:
    """Yield letters that the condition of a chain gives a value, with the letters of the chain."""
    said = chain.condition
    if said is not None and {*said.relations} & {*EQUAL}:
        members = _list_letters(chain.members)
        yield from ((one.symbol, members) for one in said.members if isinstance(one, Letter))


def _find_role(name: str, read: Print, chain: Chain, left: int, known: Known) -> Sign:
    members = chain.members[left : left + 2]
    nodes = tuple(strip(node) if is_bare(strip(node)) else node for node in members)
    is_rounded = chain.relations[left] == r"\approx" and is_number(nodes[1])
    if chain.relations[left] == r"\approx" and find_factor(nodes) and find_factor(nodes[1:]):
        return _find_role_of_factor(nodes, read, known)
    if chain.relations[left] not in EQUAL and not is_rounded:
        units = (name_unit_after(nodes[0]), name_unit_after(nodes[1]))
        limited = (_work_out(read, nodes[0], known), _work_out(read, nodes[1], known))
        return Sign(Role.RELATION, units=units, limited=limited if any(units) else (None, None))
    for node in nodes:
        if isinstance(node, Extremum):
            _refuse_range(read, chain, node, known)
            return _find_role_of_extremum(name, read, chain, left, known)
    try:
        worked_out = _work_out(read, nodes[0], known), _work_out(read, nodes[1], known)
        sides = one, other = turn((nodes[0], nodes[1]), worked_out)
    except ReadingError:
        if has_place(nodes):
            # It is a value at a place, but the definition of its letter may be printed later.
            return Sign(Role.VALUE)
        raise
    _note_arcs(read, nodes, sides, known)
    for node, symbol, value in ((nodes[0], one, other), (nodes[1], other, one)):
        if is_bare(node) and not (node is nodes[1] and _is_input(symbol, value, known)):
            symbol = node.symbol if isinstance(node, Letter) else symbol
            alone = LetterAlone(name, read, chain, left, node, symbol, value, sides)
            return find_role_of_letter(alone, known)
    if has_place(nodes):
        return Sign(Role.VALUE, None, "", sides, *find_number(nodes, sides))
    if any(isinstance(node, Derivation) for node in nodes):
        return Sign(Role.DERIVATIVE, sides=sides)
    if not left and (multiplied := _find_multiplied(sides, known)):
        symbol, value = multiplied
        alone = LetterAlone(name, read, chain, left, nodes[0], symbol, value, multiplied)
        return find_role_of_letter(alone, known)
    if not left:
        return Sign(Role.CONSTRAINT, None, "", sides, *find_number(nodes, sides))
    if not (one.free_symbols and other.free_symbols):
        return Sign(Role.NUMBER, None, "", sides, *find_number(nodes, sides))
    return Sign(Role.STEP, sides=sides)


def _is_input(symbol: sp.Basic, value: Any, known: Known) -> bool:
    r"""Return whether a letter has a size that other letters lack: e in r\sin q-l\sin p=e."""
    sizes = known.symbols.usual.keys()
    is_free = symbol in sizes and symbol not in known.values
    return is_free and bool(getattr(value, "free_symbols", set()) - sizes)


def _find_multiplied(sides: tuple[Any, Any], known: Known) -> tuple[sp.Basic, Any] | None:
    """Return w and its value from E I w = …, if w depends on a place but E and I do not.

    An equation of a letter that depends on time may hold at one instant only.
    """
    one, other = sides
    factors = one.args if isinstance(one, sp.Mul) else ()
    moving = known.symbols.moving
    found = [s for s in factors if s in moving and str(moving[s][0]) != "t"]
    constants = [s for s in factors if s.is_Symbol and s not in found]
    if len(found) != 1 or len(constants) + 1 != len(factors) or not isinstance(other, sp.Expr):
        return None
    is_free = not {*known.symbols.find_steps(found[0])[1]} & other.free_symbols
    is_fixed = not any(x in moving or x == moving[found[0]][0] for x in constants)
    return (found[0], other / sp.Mul(*constants)) if is_free and is_fixed else None


def _find_role_of_factor(nodes: tuple[Node, ...], read: Print, known: Known) -> Sign:
    """Return a comparison with a rounded factor, which defines nothing for a new letter."""
    sides = _work_out(read, nodes[0], known), _work_out(read, nodes[1], known)
    if not is_bare(nodes[0]):
        return Sign(Role.STEP, sides=sides)
    symbol = sides[0]
    role = compare_with_known(symbol, known) if symbol in known.values else Role.RELATION
    return Sign(role, symbol, known.printed.get(symbol, ""), sides)


def _note_arcs(read: Print, nodes: tuple[Node, ...], sides: tuple[Any, Any], known: Known) -> None:
    """Note, as arc functions, the angles whose sine, cosine or tangent is printed.

    Numbers and calculations with rounded decimals are left out. Angles given by numbers are noted
    for their passage only.
    """
    exact = known.symbols.list_exact()
    for function, arc in list_arcs(sides):
        angle = function.args[0]
        if arc.free_symbols:
            known.arcs.setdefault(angle, []).append(arc)
        elif arc.is_real and not any(is_number(x) or find_span(read, x, exact) for x in nodes):
            known.angles.setdefault((known.said.passage, angle), []).append((function.func, arc))


def _find_role_of_extremum(name: str, read: Print, chain: Chain, left: int, known: Known) -> Sign:
    """Return a definition if a letter is introduced as an extreme value whose formula follows."""
    first, *others = chain.members[left:]
    if left or not (isinstance(first, Letter) and is_bare(first)) or first.symbol in known.values:
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


def _refuse_range(read: Print, chain: Chain, node: Extremum, known: Known) -> None:
    """Refuse a range of the varied letter that is stated anywhere but in its declaration."""
    said = {part.symbol for part in walk(chain.condition) if isinstance(part, Letter)}
    said |= {symbol for relation in known.symbols.where for symbol in relation.free_symbols}
    if node.by.symbol in said:
        raise read.source.refuse(
            node.by.start,
            f"a range of {node.by.text} that is not given where it is declared",
            f"Give it in the block of letters after {node.by.text}: {{0<{node.by.text}<1}}",
        )


def name_member(number: int, name: str) -> str:
    """Return the name of a member of an equation, counting the letter as the first."""
    return f"the {name_ordinal(number)} member of {name}"


def _note_others(name: str, signs: Sequence[Sign], known: Known) -> None:
    """Note the further members of a chain that defines a letter."""
    if not signs or known.printed.get(signs[0].letter) != name:
        return
    letter = signs[0].letter
    steps = takewhile(lambda one: one[1].role in (Role.STEP, Role.VALUE), enumerate(signs[1:], 3))
    for number, sign in steps:
        value = sign.sides[1]
        if value is not None and letter not in known.settle(value, {letter}).free_symbols:
            known.others.setdefault(letter, []).append((name_member(number, name), value))


def _note_again(name: str, signs: Sequence[Sign], known: Known) -> None:
    """Note prints that repeat a letter or a derivative."""
    for sign in signs:
        if sign.role in (Role.REPEATED, Role.DERIVATIVE) and sign.letter in sign.sides:
            value = next((side for side in sign.sides[::-1] if side != sign.letter), None)
            if isinstance(value, sp.Expr) and sign.letter not in known.list_used(value):
                known.again.setdefault(sign.letter, []).append((name, value))


def _work_out(read: Print, node: Node, known: Known) -> Any:
    """Return a member's expression, with values put in for letters if it cannot be read otherwise.

    Integrands, for instance, need the values of letters that depend on the variable.
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
