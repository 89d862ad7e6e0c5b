r"""Relations and the marks of conditions: signs of order, intervals, `\text{ if }`."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

import sympy as sp

from mechproof.latex.characters import is_digit
from mechproof.latex.numerals import read_number
from mechproof.latex.tree import Chain, Letter, Node
from mechproof.latex.words import AND, ELSE

if TYPE_CHECKING:
    from mechproof.latex.parser import Parser

EQUAL, UP, DOWN = ("=", r"\equiv"), ("<", r"\le"), (">", r"\ge")
INEQUALITIES = (*UP, *DOWN, r"\ne")
RELATIONS = (*EQUAL, *INEQUALITIES, r"\approx")
# The signs that are exact -> the relations that they state.
STATED: Mapping[str, Callable[..., sp.Basic]] = {
    **dict.fromkeys(EQUAL, sp.Eq),
    **{"<": sp.Lt, r"\le": sp.Le, ">": sp.Gt, r"\ge": sp.Ge, r"\ne": sp.Ne},
}
# Letters for sets of numbers -> the SymPy assumption that their members satisfy.
_SETS = {"Z": "integer", "N": "positive", "R": "real"}
_LIMITS = {"(": "<", "[": r"\le", ")": "<", "]": r"\le"}


def read_condition(parser: Parser) -> Chain:
    """Read relations joined by "and", after a word that marks them as a condition."""
    start = parser.take().start
    parser.skip(r"\forall")
    return read_relations(parser, start)


def read_relations(parser: Parser, start: int, *also: str) -> Chain:
    """Read relations joined by "and", or by one of the signs `also`."""
    found = _read_shared(parser)
    while parser.skip(AND, *also):
        parser.skip(AND)
        if parser.text == r"\\" or parser.text.startswith(r"\end{"):
            break
        found += _read_shared(parser)
    members, relations = join(found)
    return Chain(members, relations, start=start, end=parser.end)


def join(conditions: Sequence[Chain]) -> tuple[tuple[Node, ...], tuple[str, ...]]:
    """Return the members and the signs of conditions that hold together."""
    relations = [sign for one in conditions for sign in (AND, *one.relations)]
    return tuple(m for one in conditions for m in one.members), tuple(relations[1:])


def _read_shared(parser: Parser) -> list[Chain]:
    """Read a relation; x,y>0 is read as one relation for each letter."""
    heads = [parser.read_sum()]
    while parser.text == "," and parser.peek() not in ELSE:
        parser.take()
        heads.append(parser.read_sum())
    if parser.text == r"\in":
        limits = read_interval(parser)
        return [place_between(head, *limits) for head in heads]
    relations, rest = [], []
    while parser.text in RELATIONS:
        relations.append(parser.take().text)
        rest.append(parser.read_sum())
    if not relations:
        raise parser.refuse("a condition needs a relation sign")
    return [Chain((head, *rest), tuple(relations)) for head in heads]


def read_interval(parser: Parser) -> tuple[Chain, Chain]:
    r"""Read \in[a,b], \in(a,b) and the like as two ends, each with its sign of order."""
    start, place = parser.start, parser.place
    parser.take(r"\in")
    low = _LIMITS.get(parser.text)
    is_set = parser.source.latex.startswith(r"\{", parser.start)
    if parser.text not in ("(", "[") or is_set:
        parser.place = place
        raise parser.refuse("sets are not read", parser.remedies.membership)
    parser.take()
    parser.depth += 1
    one = _read_end(parser)
    if not parser.skip(","):
        raise parser.refuse("an interval has two ends", parser.remedies.membership, start)
    other = _read_end(parser)
    parser.depth -= 1
    if parser.text not in (")", "]"):
        raise parser.refuse("an interval has two ends", parser.remedies.membership, start)
    high = _LIMITS[parser.take().text]
    return Chain((one,), (str(low),)), Chain((other,), (high,))


def _read_end(parser: Parser) -> Node:
    """Read an end of an interval; a comma after digits is not a decimal comma here."""
    if is_digit(parser.text) and parser.peek() in (",", ")", "]"):
        return read_number(parser, in_list=True)
    return parser.read_sum()


def skip_set(parser: Parser, letters: Sequence[Letter]) -> bool:
    r"""Move past \in\mathbb{Z} if the letters before it are declared as members of that set.

    Returns False if no such set comes next.
    """
    texts = [token.text for token in parser.rest[:3]]
    if texts[:2] != [r"\in", r"\mathbb"]:
        return False
    facts = _SETS.get(texts[2], "")
    if not facts or not all(getattr(x.symbol, f"is_{facts}", False) for x in letters):
        raise parser.refuse("sets are not read", parser.remedies.membership)
    parser.place += 3
    return True


def place_between(head: Node, low: Chain, high: Chain) -> Chain:
    """Return the relation that a node lies in an interval."""
    members = (*low.members, head, *high.members)
    return Chain(members, (*low.relations, *high.relations), start=head.start, end=head.end)
