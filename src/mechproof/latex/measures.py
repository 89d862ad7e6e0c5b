r"""Numbers with a unit: `66\,\mathrm{mm}`, `\SI{66}{mm}`, as a member or a part of one."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import sympy as sp

from mechproof.latex import tree
from mechproof.latex.latex_signs import GAPS, find_command
from mechproof.latex.numerals import read_number
from mechproof.latex.printed_commands import QUANTITIES, TEXT, UPRIGHT
from mechproof.latex.printed_relations import RELATIONS
from mechproof.latex.words import AND, ELSE, IF

if TYPE_CHECKING:
    from mechproof.latex.parser import Parser

_RAISED = r"\s*\^\s*(?:\{\s*(?P<braced>-?\d+)\s*\}|(?P<digit>\d))"
_CELSIUS = re.compile(r"\^\{\\circ\}\\[a-z]+\{C\}")
_GAP = r"(?:\s|\\[,;:!])*"
_POWER, _EXPONENT = re.compile(rf"{_GAP}\\(?:cdot|times){_GAP}10{_RAISED}"), re.compile(_RAISED)
# Digits of calculated numbers, far more than papers print.
_DIGITS = 15
_BETWEEN = ("/", "^", "{", "}", "-", r"\cdot", r"\circ", r"\%")
_ENDS = (*RELATIONS, *GAPS.values(), ",", ";", "&", r"\\", AND, *IF, *ELSE)


def read_measure(parser: Parser) -> tree.Number | tree.Measure:
    """Read a number and its unit: the rest of the member, or the upright signs after the number."""
    is_first = begins_member(parser, parser.place)
    alone, name_unit = read_number(parser), parser.notation.name_unit
    if name_unit is None:
        return alone
    place, number = parser.place, _take_power(parser, alone)
    for last in (_find_end(parser) if is_first else parser.place, _find_upright_end(parser)):
        unit = name_unit(parser.source.latex[number.end : parser.tokens[last - 1].end])
        if last > parser.place and unit:
            parser.place = last
            return tree.Measure(number, unit, start=number.start, end=parser.end)
    parser.place = place
    return alone


def _take_power(parser: Parser, number: tree.Number) -> tree.Number:
    r"""Return a number together with a power of ten after it, 2.1\cdot10^5, or 10^5 itself."""
    latex, is_ten = parser.source.latex, number.text == "10"
    times = _POWER.match(latex, parser.end)
    match = times or (_EXPONENT.match(latex, parser.end) if is_ten else None)
    if match is None:
        return number
    while parser.text and parser.tokens[parser.place].end <= match.end():
        parser.take()
    power = int(match["braced"] or match["digit"])
    # A power of ten alone is exact.
    exact = "1".ljust(power + 1, "0") if power >= 0 else f"0.{'1'.rjust(-power, '0')}"
    return replace(number, text=f"{number.text}e{power}" if times else exact, end=parser.end)


def begins_member(parser: Parser, place: int) -> bool:
    """Return whether a member begins at a place, or at the sign in front of it."""
    if place and parser.tokens[place - 1].text in ("-", "+"):
        place -= 1
    return place == 0 or parser.tokens[place - 1].text in _ENDS


def _find_end(parser: Parser) -> int:
    """Return the place after a unit that ends a member, or the current place if there is none."""
    place, has_unit = parser.place, False
    while place < len(parser.tokens) and parser.tokens[place].text not in _ENDS:
        text, before = parser.tokens[place].text, parser.tokens[place - 1].text
        is_unit = _is_upright(parser, place)
        is_joint = text in _BETWEEN or _is_micro(parser, place)
        # Elsewhere the minus subtracts another number.
        if text == "-" and before not in ("^", "{"):
            return parser.place
        if not (is_unit or is_joint or (text.isdigit() and before in ("{", "-"))):
            return parser.place
        has_unit, place = has_unit or is_unit, place + 1
    return place if has_unit else parser.place


def read_unit(parser: Parser) -> tree.Measure | None:
    """Read a unit after a calculated value, as one times that unit; None if there is none."""
    unit, last, start = *_find_unit(parser), parser.start
    if not unit:
        return None
    parser.place = last
    return tree.Measure(tree.Number("1", start=start, end=start), unit, start=start, end=parser.end)


def is_unit(parser: Parser) -> bool:
    """Return whether a unit follows a calculated value."""
    return bool(_find_unit(parser)[0])


def _find_unit(parser: Parser) -> tuple[str, int]:
    """Return the unit after a calculated value, "" if there is none, and the place after it."""
    place, name_unit = parser.place, parser.notation.name_unit
    before = parser.tokens[place - 1].text if place else ""
    if name_unit is None or parser.collects or not (before[-1:].isdigit() or before in ("}", ")")):
        return "", place
    last = _find_upright_end(parser)
    if last == place:
        return "", place
    return name_unit(parser.source.latex[parser.start : parser.tokens[last - 1].end]), last


def _find_upright_end(parser: Parser) -> int:
    r"""Return the place after upright units, \mathrm{N}/\mathrm{mm}^2, or the current place."""
    texts = [token.text for token in parser.tokens[parser.place : parser.place + 6]]
    is_empty = texts[:1] == ["{}"]
    if _CELSIUS.fullmatch("".join(texts[is_empty : is_empty + 5])):
        return parser.place + is_empty + 5
    return _skip_unit(parser, parser.place)


def _skip_unit(parser: Parser, place: int) -> int:
    last = _skip_factor(parser, place)
    while last > place:
        is_joint = last < len(parser.tokens) and parser.tokens[last].text in ("/", r"\cdot")
        end = _skip_factor(parser, last + is_joint)
        if end == last + is_joint:
            break
        last = end
    return last


def _skip_factor(parser: Parser, place: int) -> int:
    """Return the place after an upright sign with its exponent, or a fraction of such signs."""
    if place < len(parser.tokens) and parser.tokens[place].text == r"\frac":
        return _skip_group(parser, _skip_group(parser, place + 1)) or place
    first = place + (place < len(parser.tokens) and _is_micro(parser, place))
    if first >= len(parser.tokens) or not _is_upright(parser, first):
        return place
    following = parser.tokens[first + 1].text if first + 1 < len(parser.tokens) else ""
    is_function = parser.tokens[first].text == r"\min" and following in ("(", r"\{", "_")
    if is_function or parser.source.latex.startswith(r"\min", parser.tokens[first].start):
        return place
    match = _EXPONENT.match(parser.source.latex, parser.tokens[first].end)
    end = first + 1
    while match and end < len(parser.tokens) and parser.tokens[end].end <= match.end():
        end += 1
    return end


def _skip_group(parser: Parser, place: int) -> int:
    """Return the place after a group of upright signs, or of a one; 0 if it contains others."""
    texts = [token.text for token in parser.tokens[place:]]
    if not place or texts[:1] != ["{"]:
        return 0
    end = place + 2 if texts[1:2] == ["1"] else _skip_unit(parser, place + 1)
    return end + 1 if end > place + 1 and texts[end - place : end - place + 1] == ["}"] else 0


def _is_upright(parser: Parser, place: int) -> bool:
    command = find_command(parser.source.latex, parser.tokens[place].start)
    is_word = command in (*UPRIGHT, *TEXT, *QUANTITIES, "{")
    text = parser.tokens[place].text
    is_letter = parser.names.match(parser.tokens, place) is not None
    return text in (r"\%", "°", r"\min") or (
        (is_word or text == r"\Omega") and text.startswith("\\") and not is_letter
    )


def _is_micro(parser: Parser, place: int) -> bool:
    r"""Return whether \mu is the prefix micro, in front of a unit."""
    is_mu = parser.tokens[place].text == r"\mu"
    return is_mu and place + 1 < len(parser.tokens) and _is_upright(parser, place + 1)


def put_units(chain: tree.Chain, weigh: Callable[[str], sp.Expr | None]) -> tree.Chain:
    """Turn numbers with units next to letters into quantities: `weigh` returns a unit's value.

    If it returns None, the number remains as it is.
    """

    def change(node: tree.Node) -> tree.Node | None:
        if not isinstance(node, tree.Measure):
            return None
        factor = weigh(node.unit)
        return node if factor is None else replace(node, factor=factor)

    def settle(member: tree.Node) -> tree.Node:
        has_letters = any(isinstance(node, tree.Letter) for node in tree.walk(member))
        settled: tree.Node = tree.exchange(member, change) if has_letters else member
        return settled

    return replace(chain, members=tuple(map(settle, chain.members)))


def put_sizes(
    chain: tree.Chain, weigh: Callable[[str], sp.Expr | None], own: Mapping[sp.Basic, sp.Expr]
) -> tree.Chain:
    """Turn the sizes in a condition into numbers in the `own` units of their letters.

    If a member of the chain has a unit, they become quantities. A size stays as it is if its letter
    has no unit, a unit of another kind, or also a value without a unit.
    """
    if chain.condition is None:
        return chain
    nodes = list(tree.walk(chain.members))
    are_quantities = any(isinstance(node, tree.Measure) for node in nodes)
    members, said = list(chain.condition.members), list[tuple[int, tree.Letter]]()
    for n, sign in enumerate(chain.condition.relations):
        for place, beside in ((n, members[n + 1]), (n + 1, members[n])) if sign != AND else ():
            if isinstance(beside, tree.Letter) and is_number(members[place]):
                said.append((place, beside))
    plain = {one.symbol for place, one in said if _has_no_unit(members[place])}
    for place, letter in said:
        sign, size = split_sign(members[place])
        if not isinstance(size, tree.Measure) or (unit := weigh(size.unit)) is None:
            continue
        if letter.symbol in plain or letter.symbol not in own:
            continue
        ratio = unit / own[letter.symbol]
        if ratio.is_Rational:
            factor = unit if are_quantities else ratio
            settled = replace(size, factor=factor, is_settled=True)
            members[place] = tree.Add(((-1, settled),)) if sign else settled
    return replace(chain, condition=replace(chain.condition, members=tuple(members)))


def _has_no_unit(node: tree.Node) -> bool:
    """Return whether a number lacks a unit that it needs; zero needs none."""
    inside = split_sign(node)[1]
    return isinstance(inside, tree.Number) and sp.Rational(inside.text) != 0


def find_number(
    nodes: tuple[tree.Node, ...], sides: tuple[Any, Any]
) -> tuple[str, Any, str, tuple[str, str]]:
    """Return the digits and sign of the side that is a number, the other side, and the unit.

    The last result is the pair of digits and unit of the other side, if that too is a number with a
    unit. A calculation has a unit but no digits.
    """
    for node, partner, other in zip(reversed(nodes), nodes, sides, strict=True):
        digits, unit = _read_digits(node)
        if digits:
            return digits, other, unit, _read_given(partner)
    units = [node.unit for node in nodes if isinstance(node, tree.Calculated)]
    return "", None, units[0] if len(units) == 1 else "", ("", "")


def _read_given(node: tree.Node) -> tuple[str, str]:
    """Return the digits and unit of a number with a unit or of a calculation, else ("", "")."""
    if isinstance(node, tree.Calculated):
        return str(sp.N(node.value, _DIGITS)).lower().replace("+", ""), node.unit
    return _read_digits(node) if isinstance(split_sign(node)[1], tree.Measure) else ("", "")


def _read_digits(node: tree.Node) -> tuple[str, str]:
    """Return the digits of a number, with its sign, and its unit; ("", "") for other nodes."""
    sign, inside = split_sign(node)
    if isinstance(inside, tree.Number):
        return sign + inside.text, ""
    if isinstance(inside, tree.Measure):
        return sign + inside.number.text, inside.unit
    if isinstance(inside, tree.Degrees) and isinstance(inside.number, tree.Number):
        return sign + inside.number.text, "°"
    return "", ""


def name_unit_after(node: tree.Node) -> str:
    """Return the unit of a number, "" if it has none."""
    inside = split_sign(node)[1]
    return inside.unit if isinstance(inside, tree.Measure | tree.Calculated) else ""


def find_factor(nodes: tuple[tree.Node, ...]) -> str:
    """Return the digits of the only decimal in the members if it is a factor of one, else ""."""
    decimals = [one for one in tree.walk(nodes) if isinstance(one, tree.Number) and "." in one.text]
    members = (split_sign(node)[1] for node in nodes)
    factors = [
        one for member in members if isinstance(member, tree.Product) for one in member.factors
    ]
    return decimals[0].text if len(decimals) == 1 and decimals[0] in factors else ""


def split_sign(node: tree.Node) -> tuple[str, tree.Node]:
    """Return the sign in front of a node ("-" or ""), and the node without it."""
    if isinstance(node, tree.Add) and len(node.terms) == 1:
        return "-", node.terms[0][1]
    return "", node


def is_number(node: tree.Node) -> bool:
    """Return whether a node is a number, possibly with a sign and a unit, or a calculation."""
    return isinstance(
        split_sign(node)[1], tree.Number | tree.Measure | tree.Degrees | tree.Calculated
    )
