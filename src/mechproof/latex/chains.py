r"""A whole print -> its chains of members and relation signs, with cases and conditions.

A comma separates chains: `x=…,\ y=…`. An inequality after a comma is a condition, as is whatever
follows `\text{ if }` or `\text{ for }` or is put in brackets. `\text{ and }` joins relations.
Braces are not printed, so what they enclose must also be a unit of what is read.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from mechproof.latex import modulo, side_conditions
from mechproof.latex.latex_signs import NARROW, WIDE
from mechproof.latex.left_scripts import begins_letter
from mechproof.latex.printed_relations import (
    EQUAL,
    RELATIONS,
    place_between,
    read_condition,
    read_interval,
    skip_set,
)
from mechproof.latex.several_equations import Line
from mechproof.latex.side_conditions import ChainPart
from mechproof.latex.tree import Add, Bracket, Cases, Chain, Letter, Node, Number, Product, walk
from mechproof.latex.words import AND, ELSE, IF

if TYPE_CHECKING:
    from mechproof.latex.parser import Parser

_LEFT_OVER = {
    "(": r"Print the number of an equation by \tag{…}.",
    AND: "Print one equation at a time.",
}


def read_print(parser: Parser) -> tuple[Chain, ...]:
    """Read all chains of a print: of its lines, and of the steps in each line."""
    statements: list[Chain] = []
    lines = list(parser.lines)
    for line, after in zip(lines, [*lines[1:], None], strict=True):
        if line.arrow and set(statements[-1].relations) - {*EQUAL, r"\le", r"\ge"}:
            raise parser.refuse(
                f"{line.arrow.text} has no meaning here",
                r"Print the conclusion, and its condition after it: \text{ for }x>0.",
                line.arrow.start,
            )
        parser.begin(line.tokens, _find_end(parser, after))
        statements += _read_line(parser)
    return tuple(statements)


def _find_end(parser: Parser, after: Line | None) -> int:
    """Return where a line ends in the source: in front of the line `after`, if there is one."""
    if after is None:
        return len(parser.source.latex)
    return after.arrow.start if after.arrow else after.tokens[0].start


def _read_line(parser: Parser) -> tuple[Chain, ...]:
    """Read all chains of a line."""
    if parser.text in (*IF, r"\forall") and not (_skip_membership(parser) and parser.skip(",")):
        raise parser.refuse("a condition before its statement", "Print it after the statement.")
    parts = [ChainPart(_read_chain(parser))]
    while parser.text:
        if parser.skip(",", ";"):
            last = parts[-1].chain.members[-1]
            factors = last.factors if isinstance(last, Product) else (last,)
            parser.brackets = tuple(one for one in factors if isinstance(one, Bracket))
        elif not (parser.text in (WIDE, *IF, r"\forall") or side_conditions.is_bracketed(parser)):
            raise _refuse_rest(parser)
        parts += _read_parts(parser, parts)
    _refuse_cut(parser, [part.chain for part in parts])
    return side_conditions.fold(parser, parts)


def _refuse_rest(parser: Parser) -> Exception:
    if parser.text == NARROW:
        return parser.refuse(
            "a blank before a relation: does it separate a condition, or factors?",
            r"Print ,\quad or \text{ for } before a condition, \cdot between factors.",
        )
    if parser.text.startswith(r"\text"):
        remedy = r"A condition is read as a relation: \text{ for }x>0. Leave other words out."
        return parser.refuse(f"{parser.text} is not understood here", remedy)
    if parser.text == r"\in":
        return parser.refuse("a chain whose members are in a set", parser.remedies.membership)
    remedy = _LEFT_OVER.get(parser.text, "")
    return parser.refuse(f"{parser.text} is not understood here", remedy)


def _read_parts(parser: Parser, before: Sequence[ChainPart]) -> list[ChainPart]:
    """Read what follows a comma or a gap: a chain, or conditions that are marked as such.

    A wide gap separates an equation from inequalities before it; others may be part of a product.
    """
    if _skip_membership(parser):
        return []
    if side_conditions.is_bracketed(parser):
        return parser.read_inside(parser.text, lambda: _read_bracketed(parser))
    if parser.text in (*IF, r"\forall"):
        return [ChainPart(read_condition(parser), said=True)]
    if not parser.skip(WIDE):
        return [ChainPart(_read_chain(parser))]
    if parser.text in (*IF, r"\forall") or side_conditions.is_bracketed(parser):
        return _read_parts(parser, before)
    start = parser.start
    chain = _read_chain(parser)
    if not set(chain.relations).isdisjoint((*EQUAL, r"\approx")):
        if all(side_conditions.is_inequality(part.chain) for part in before):
            return [ChainPart(chain)]
        raise parser.refuse(
            "a wide gap before an equation: a second one, or a factor?",
            r"Print a comma between equations, \cdot between factors.",
            start,
        )
    return [ChainPart(chain, said=True)]


def _skip_membership(parser: Parser) -> bool:
    r"""Skip a membership k,m\in\mathbb{Z} if the letters are declared accordingly.

    Returns False, at the old place, if none starts here.
    """
    place, count = parser.place, len(parser.collected)
    if r"\mathbb" not in {token.text for token in parser.rest}:
        return False
    parser.skip(WIDE)
    parser.skip(*IF, r"\forall")
    found: list[Letter] = []
    while begins_letter(parser.text):
        letter = parser.read_atom()
        if not isinstance(letter, Letter):
            break
        found.append(letter)
        if skip_set(parser, found):
            return True
        if not parser.skip(","):
            break
    parser.place = place
    del parser.collected[count:]
    return False


def _read_bracketed(parser: Parser) -> list[ChainPart]:
    """Read the conditions in a bracket."""
    parts: list[ChainPart] = []
    while not parts or parser.skip(",", ";"):
        if _skip_membership(parser):
            return parts
        chain = read_condition(parser) if parser.text in (*IF, r"\forall") else _read_chain(parser)
        parts.append(ChainPart(chain, said=True))
    return parts


def _read_chain(parser: Parser) -> Chain:
    start = parser.start
    members, relations = [parser.read_sum()], []
    while parser.text in RELATIONS:
        relations.append(parser.take().text)
        members.append(parser.read_sum())
        _refuse_number_of_equation(parser, members[-1])
    members = modulo.read_congruence(parser, members, relations)
    condition = None
    if parser.text in IF and not _skip_membership(parser):
        value = members.pop()
        cases = _read_cases(parser, value)
        if len(cases.pieces) == 1 and cases.otherwise is None:
            condition = cases.pieces[0][1]
            members.append(value)
        else:
            members.append(cases)
    if parser.text == r"\in" and not relations and condition is None:
        return place_between(members[0], *read_interval(parser))
    return Chain(tuple(members), tuple(relations), condition, start=start, end=parser.end)


def _refuse_number_of_equation(parser: Parser, member: Node) -> None:
    r"""Refuse \theta_2=(4): a number in brackets is usually that of an equation."""
    printed = parser.source.latex[member.start : member.end].removeprefix(r"\left")
    is_round = printed.lstrip().startswith("(")
    if is_round and isinstance(member, Bracket) and isinstance(member.inside, Number):
        raise parser.refuse(
            f"({member.inside.text}): the number, or the equation with that number?",
            "Print the number without brackets, or refer to the equation in the text.",
            member.start,
        )


def _read_cases(parser: Parser, value: Node) -> Cases:
    pieces = [(value, read_condition(parser))]
    while True:
        place = parser.place
        parser.skip(",", ";")
        if parser.skip(*ELSE):
            return Cases(tuple(pieces), parser.read_sum(), start=value.start, end=parser.end)
        if not parser.text or place == parser.place or parser.text in IF:
            parser.place = place
            break
        other = parser.read_sum()
        if parser.text not in IF:
            parser.place = place
            break
        pieces.append((other, read_condition(parser)))
    return Cases(tuple(pieces), start=value.start, end=parser.end)


def _refuse_cut(parser: Parser, nodes: Sequence[Node]) -> None:
    """Refuse {a+b}^2, 2{x+1}, a-{b+c} and the like, whose printed form means something else."""
    found = [node for node in walk(tuple(nodes)) if node.start < node.end]
    for group in parser.groups:
        if any(_cuts(node, *group) for node in found):
            raise parser.refuse(
                "braces print nothing, but these contain only parts of terms",
                r"Print \left( and \right) around what belongs together, or leave the braces out.",
                group[0],
            )


def _cuts(node: Node, start: int, end: int) -> bool:
    """Return whether a node splits a group, or a sign before it applies only to part of it."""
    if node.start < start < node.end < end or start < node.start < end < node.end:
        return True
    if not isinstance(node, Add):
        return False
    inside = [(sign, t) for sign, t in node.terms if start <= t.start and t.end <= end]
    if not inside:
        return False
    (sign, first), is_sign_inside = inside[0], inside[0][1].start > start
    is_later = first is not node.terms[0][1]
    return (is_sign_inside and is_later) or (len(inside) > 1 and sign < 0 and not is_sign_inside)
