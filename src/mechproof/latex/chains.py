r"""A whole print -> its chains of members and relation signs, with cases and conditions.

A comma parts one chain from the next: `x=…,\ y=…`. `\text{ if }`, `\text{ for }` begin a condition,
`\text{ and }` joins the relations of one.
"""

from __future__ import annotations

from mechproof.latex.parser import RELATIONS, Parser
from mechproof.latex.tree import AND, Bracket, Cases, Chain, Node, Product

_IF = (r"\text{if}", r"\text{for}", r"\text{where}", r"\text{since}")
_ELSE = (r"\text{else}", r"\text{otherwise}")


def read_print(parser: Parser) -> tuple[Chain, ...]:
    """Read all chains of a print up to its end."""
    chains = [_read_chain(parser)]
    while parser.skip(",", ";"):
        parser.brackets = _brackets_among_factors(chains[-1].members[-1])
        chains.append(_read_chain(parser))
    if parser.text:
        raise parser.refuse(f"{parser.text} is not understood here")
    return tuple(chains)


def _brackets_among_factors(member: Node) -> tuple[Bracket, ...]:
    factors = member.factors if isinstance(member, Product) else (member,)
    return tuple(factor for factor in factors if isinstance(factor, Bracket))


def _read_chain(parser: Parser) -> Chain:
    start = parser.start
    members, relations = [parser.read_sum()], []
    while parser.text in RELATIONS:
        relations.append(parser.take().text)
        members.append(parser.read_sum())
    condition = None
    if parser.text in _IF:
        cases = _read_cases(parser, members.pop())
        if len(cases.pieces) == 1 and cases.otherwise is None:
            ((value, condition),) = cases.pieces
            members.append(value)
        else:
            members.append(cases)
    return Chain(tuple(members), tuple(relations), condition, start=start, end=parser.end)


def _read_cases(parser: Parser, value: Node) -> Cases:
    pieces = [(value, _read_condition(parser))]
    while True:
        place = parser.place
        parser.skip(",", ";")
        if parser.skip(*_ELSE):
            return Cases(tuple(pieces), parser.read_sum(), start=value.start, end=parser.end)
        if not parser.text or place == parser.place:
            break
        other = parser.read_sum()
        if parser.text not in _IF:
            parser.place = place
            break
        pieces.append((other, _read_condition(parser)))
    return Cases(tuple(pieces), start=value.start, end=parser.end)


def _read_condition(parser: Parser) -> Chain:
    parser.take()
    start = parser.start
    members = [parser.read_sum()]
    relations: list[str] = []
    while parser.text in RELATIONS or (parser.text == AND and relations and relations[-1] != AND):
        relations.append(parser.take().text)
        members.append(parser.read_sum())
    if not relations or relations[-1] == AND:
        raise parser.refuse("a condition needs a relation sign")
    return Chain(tuple(members), tuple(relations), start=start, end=parser.end)
