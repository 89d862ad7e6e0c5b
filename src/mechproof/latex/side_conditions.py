r"""Conditions of a statement: `\text{ for }x>0`, `,\ x>0`, `\quad x>0`, `(x>0)`, `\forall x>0`.

A gap may separate a statement from its condition and, in square brackets, the entries of a row:
[x\quad y] is (x,y). Anywhere else it is a blank.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TYPE_CHECKING

from mechproof.latex.latex_signs import (
    CLOSED_BY,
    CLOSING,
    DOTS,
    GAPS,
    NARROW,
    WIDE,
    Token,
    find_close,
    measure_depths,
)
from mechproof.latex.printed_functions import FUNCTIONS
from mechproof.latex.printed_relations import DOWN, INEQUALITIES, RELATIONS, UP, join
from mechproof.latex.tree import Chain, Letter, Magnitude, Node, walk
from mechproof.latex.words import AND, IF

if TYPE_CHECKING:
    from mechproof.latex.parser import Parser

_RELATING = (*RELATIONS, r"\in")
_OPERATORS = (*_RELATING, "+", "/", *DOTS, r"\pm", r"\mp", r"\to", ",", ";", "&", r"\\", "")

# Signs that a list of entries does not contain.
_OTHERS = (*_RELATING, ",", ";", ":", "&", r"\\")
_JOINING = ("+", "-", "/", r"\pm", r"\mp", *DOTS)


# Gaps -------------------------------------------------------------------------------------------


def keep_gaps(tokens: Sequence[Token]) -> tuple[Token, ...]:
    """Return signs without the gaps that are mere blanks, in front of no condition.

    Gaps that may separate the entries of a row are kept, too.
    """
    tokens, unclear = _part_rows(tokens)
    texts = [token.text for token in tokens]
    depths = list(measure_depths(texts))
    return tuple(
        token
        for place, token in enumerate(tokens)
        if token.text not in GAPS
        or place in unclear
        or (depths[place] == 0 and _may_part(texts, depths, place))
    )


def _may_part(texts: Sequence[str], depths: Sequence[int], place: int) -> bool:
    """Return whether a gap follows a relation and precedes a possible condition."""
    before = next((n for n in range(place - 1, -1, -1) if texts[n] not in GAPS), None)
    after = next((n for n in range(place + 1, len(texts)) if texts[n] not in GAPS), None)
    if before is None or after is None or WIDE in texts[before:place]:
        return False
    is_sign = texts[after] == "-" and after + 1 < len(texts) and texts[after + 1] not in GAPS
    begins = is_sign or texts[after] not in (*_OPERATORS, *"([{", *CLOSING, "-")
    if not begins or texts[after].startswith((r"\text", r"\forall")):
        return False
    if texts[before] in (*_OPERATORS, "-", *IF, AND) or texts[before][1:] in FUNCTIONS:
        return False
    level = [t for t, depth in zip(texts, depths, strict=True) if depth == 0]
    here = sum(depth == 0 for depth in depths[:place])
    start = max((n + 1 for n, t in enumerate(level[:here]) if t in (",", ";")), default=0)
    left = level[start:here]
    if not any(text in _RELATING for text in left) or _is_integrand(left):
        return False
    return texts[place] == WIDE or _is_inequality_ahead(level[here + 1 :])


def _is_integrand(texts: Sequence[str]) -> bool:
    """Return whether an integral has begun whose differential is still to come."""
    last = max((n for n, text in enumerate(texts) if text in _RELATING), default=0)
    inside = texts[last:]
    return r"\int" in inside and "d" not in inside[inside.index(r"\int") :]


def _is_inequality_ahead(texts: Sequence[str]) -> bool:
    """Return whether the next relation is not an equality; letters in a list share it."""
    texts = [text for text in texts if text not in GAPS]
    first = next((n for n, text in enumerate(texts) if text in _RELATING), None)
    if first is None or texts[first] not in (*INEQUALITIES, r"\in"):
        return False
    commas = [-1, *(n for n, text in enumerate(texts[:first]) if text == ","), first]
    return len(commas) == 2 or all(b - a == 2 for a, b in pairwise(commas))


def _part_rows(tokens: Sequence[Token]) -> tuple[list[Token], set[int]]:
    """Return signs with commas for wide gaps between entries, and the places of unclear gaps.

    Narrow gaps are unclear in brackets without wide gaps, operators or signs.
    """
    texts = [token.text for token in tokens]
    parted, unclear = list(tokens), set[int]()
    for start in (n for n, text in enumerate(texts) if text == "["):
        inside = texts[start : start + find_close(texts[start:])]
        own = [start + n for n, depth in enumerate(measure_depths(inside)) if depth == 1]
        signs = {texts[n] for n in own}
        if signs & {*_OTHERS} or any(text.startswith(r"\text") for text in signs):
            continue
        gaps = [n for n in own if texts[n] in (WIDE, NARROW) and _stands_between(texts, n)]
        wide = [n for n in gaps if texts[n] == WIDE]
        for place in wide:
            parted[place] = replace(tokens[place], text=",")
        if not wide and not signs & {*_JOINING}:
            unclear |= {*gaps}
    return parted, unclear


def _stands_between(texts: Sequence[str], place: int) -> bool:
    """Return whether a gap lies between two entries, the second of which may have a sign."""
    before = next(text for text in texts[place::-1] if text not in GAPS)
    after = [text for text in texts[place + 1 :] if text not in GAPS][:1]
    is_sign = texts[place + 1 : place + 2] == ["-"] and texts[place + 2] not in GAPS
    begins = is_sign or (after[0] not in (*_JOINING, *CLOSING) if after else False)
    is_first = texts[place - 1] not in GAPS
    return is_first and begins and before not in (*_JOINING, *CLOSED_BY)


# Conditions -------------------------------------------------------------------------------------


@dataclass(frozen=True)
class ChainPart:
    """A chain between commas; `said` if a word, a gap or a bracket marks it as a condition."""

    chain: Chain
    said: bool = False


def is_bracketed(parser: Parser) -> bool:
    """Return whether a bracket with relations begins here: a condition, not a factor."""
    if parser.text not in ("(", "["):
        return False
    depth = 0
    for token in parser.tokens[parser.place :]:
        depth += (token.text in CLOSED_BY) - (token.text in CLOSING)
        if depth == 0:
            return False
        if depth == 1 and token.text in (*_RELATING, *IF, r"\forall"):
            return True
    return False


def fold(parser: Parser, parts: Sequence[ChainPart]) -> tuple[Chain, ...]:
    """Return the statements of a print, each with the conditions that follow them all.

    Inequalities before equations are conditions of these, too; those of more than one letter are
    also statements.
    """
    statements: list[Chain] = []
    conditions: list[Chain] = []
    before, rest = _split_leading([*_share_relations(parser, parts)])
    for part in rest:
        own = statements[-1].condition if statements else None
        if own and _is_value(part.chain, own, *statements):
            statements[-1] = _narrow(statements[-1], [part.chain])
        elif part.said or _narrows(parser, statements, conditions, part.chain):
            if not part.chain.relations:
                raise parser.refuse(
                    "a gap, but no relation after it: a factor, or a second print?",
                    r"Print \cdot before a factor, a comma between prints.",
                    part.chain.start,
                )
            conditions.append(part.chain)
        elif conditions or (own and not part.chain.condition):
            raise parser.refuse(
                "an equation after a condition: does the condition apply to it, too?",
                "Print one equation at a time, its condition after it.",
                part.chain.start,
            )
        else:
            statements.append(part.chain)
    if not statements:
        raise parser.refuse("a condition without a statement", "", parts[0].chain.start)
    claims = [chain for chain in before if not _bounds_letter(chain)]
    return (*claims, *(_narrow(chain, [*before, *conditions]) for chain in statements))


def _split_leading(parts: Sequence[ChainPart]) -> tuple[list[Chain], Sequence[ChainPart]]:
    """Return the inequalities printed before equations, and the parts after them."""
    first = next((n for n, part in enumerate(parts) if not is_inequality(part.chain)), 0)
    before = [part.chain for part in parts[:first] if not (part.said or part.chain.condition)]
    is_clear = len(before) == first and bool(parts[first].chain.relations)
    return (before, parts[first:]) if is_clear and not parts[first].said else ([], parts)


def _narrows(
    parser: Parser, statements: Sequence[Chain], conditions: Sequence[Chain], chain: Chain
) -> bool:
    """Return whether an unmarked relation is a condition."""
    says_values = bool(conditions) and {*conditions[-1].relations} <= {"=", AND}
    if says_values and _is_value(chain, *conditions, *statements):
        return True
    return bool(statements) and _is_condition(parser, statements, chain)


def _is_value(chain: Chain, *others: Chain) -> bool:
    r"""Return whether a chain gives a letter a value after a condition: \text{ for }x=0,\ y=0.

    The letter must not be a member of any of the other chains.
    """
    letter, *values = chain.members
    is_value = isinstance(letter, Letter) and not any(map(_has_letter, values))
    is_plain = {*chain.relations} == {"="} and chain.condition is None
    return is_value and is_plain and not any(letter in other.members for other in others)


def _narrow(chain: Chain, conditions: Sequence[Chain]) -> Chain:
    if not conditions:
        return chain
    said = [chain.condition] if chain.condition else []
    return replace(chain, condition=Chain(*join([*said, *conditions])))


def _share_relations(parser: Parser, parts: Sequence[ChainPart]) -> Iterator[ChainPart]:
    """Read x,y>0 as x>0 and y>0; refuse 0<x,y<1."""
    waiting: list[ChainPart] = []
    last: Chain | None = None
    for part in parts:
        chain = part.chain
        is_letter = isinstance(chain.members[0], Letter)
        if not chain.relations and is_letter and chain.condition is None:
            waiting.append(part)
            continue
        if waiting and is_letter and is_inequality(chain):
            for one in waiting:
                shared = replace(chain, members=(one.chain.members[0], *chain.members[1:]))
                yield ChainPart(shared, part.said or one.said)
            yield replace(part, said=part.said or waiting[0].said)
        else:
            yield from waiting
            _refuse_shared_bounds(parser, last, chain)
            yield part
        waiting, last = [], chain
    yield from waiting


def _refuse_shared_bounds(parser: Parser, last: Chain | None, chain: Chain) -> None:
    if last is None or not (last.relations and chain.relations):
        return
    signs = last.relations[-1], chain.relations[0]
    left, right = last.members[-1], chain.members[0]
    inner = isinstance(left, Letter) and isinstance(right, Letter) and left.text != right.text
    outer = any(_has_letter(one) for one in (last.members[0], chain.members[-1]))
    if inner and not outer and any(set(signs) <= set(way) for way in (UP, DOWN)):
        raise parser.refuse(
            "letters between two bounds: do both bounds hold for each of them?",
            "Print 0<x<1,\\ 0<y<1, or x>0,\\ y<1.",
            last.start,
        )


def _is_condition(parser: Parser, statements: Sequence[Chain], chain: Chain) -> bool:
    """Return whether a relation after statements is their condition; refuse what may be either."""
    if not is_inequality(chain) or not _has_letter(chain):
        return False
    if all(is_inequality(one) for one in statements) and not _bounds_letter(chain):
        raise parser.refuse(
            "a second relation: a condition of the first, or a claim of its own?",
            r"Print \text{ for } before a condition, claims one at a time.",
            chain.start,
        )
    return True


def _bounds_letter(chain: Chain) -> bool:
    letters = (m.inside if isinstance(m, Magnitude) else m for m in chain.members)
    return any(isinstance(member, Letter) for member in letters)


def is_inequality(chain: Chain) -> bool:
    """Return whether a chain states only an order or a difference, and no equality."""
    return bool(chain.relations) and all(sign in INEQUALITIES for sign in chain.relations)


def _has_letter(node: Node) -> bool:
    return any(isinstance(part, Letter) for part in walk(node))
