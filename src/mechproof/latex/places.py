r"""Values at a place: `y|_{x=0}`, `\left.y\right|_{x=0}`, and `y(0)` of a letter that depends on x.

Differences between two places are read, too: `[y]_0^1`, `\left.y\right|_{x=0}^{x=1}`.
"""

from __future__ import annotations

from itertools import pairwise, takewhile
from typing import TYPE_CHECKING

import sympy as sp

from mechproof.latex.characters import is_digit
from mechproof.latex.measures import begins_member
from mechproof.latex.name_table import find_brace
from mechproof.latex.tree import Add, Approach, At, Bracket, Constant, Letter, Node, strip, walk

if TYPE_CHECKING:
    from mechproof.latex.parser import Parser

LEFT = r"\left."
_AT = r"\text{at}"
_BARS = ("|", r"\rvert")
_NUMERIC = (r"\pi", r"\frac", "{", "}", "/", "-", ".", r"\cdot", "^", r"\circ")


def read_enclosed(parser: Parser) -> Node:
    r"""Read \left.…\right|_{x=0}."""
    start = parser.start
    inside = parser.read_inside(LEFT, parser.read_sum)
    if parser.text != "_":
        raise parser.refuse("a bar that does not say where the value is meant", place=start)
    return _read_place(parser, inside)


def is_bar(parser: Parser) -> bool:
    """Return whether a bar with a place comes next, and does not close another bar."""
    before = [token.text for token in parser.tokens[: parser.place]]
    is_closing = before.count(LEFT) + before.count(r"\lvert") > before.count(r"\rvert")
    is_closing = parser.bars["|"] > 0 if parser.text == "|" else is_closing
    return (
        parser.text in _BARS and not is_closing and (parser.peek(1), parser.peek(2)) == ("_", "{")
    )


def read_bar(parser: Parser, term: Node, place: int) -> Node:
    """Read a bar after a factor, which begins at token `place`."""
    bar = parser.take()
    if not begins_member(parser, place):
        raise parser.refuse(
            "how far does the bar reach?", r"Print \left. where it begins.", bar.start
        )
    return _read_place(parser, term)


def read_indexed(parser: Parser, term: Node) -> Node:
    r"""Read (a/b)_{\max}, the value of a bracket at the place that \text{at }x=0 names after it.

    With "for x=0" it would mean the largest value in that case.
    """
    start, after = parser.start, [token.text for token in parser.rest]
    if _AT not in after or "=" not in after[after.index(_AT) :]:
        raise parser.refuse(
            "an index after a bracket: at which place is its value meant?",
            r"Print the place after the equation, \text{ at }x=0; or state the largest value "
            r"overall as \max_x(…)=….",
            start,
        )
    parser.take("_")
    parser.take("{")
    while not parser.skip("}"):
        parser.take()
    return term


def _read_place(parser: Parser, term: Node) -> Node:
    if is_between(parser):
        return read_between(parser, term)
    parser.take("_")
    return parser.read_inside("{", lambda: _read_values(parser, term))


def is_between(parser: Parser) -> bool:
    """Return whether a lower and an upper limit come next."""
    if (parser.text, parser.peek()) != ("_", "{"):
        return False
    end = find_brace(parser.tokens, parser.place + 2)
    return [token.text for token in parser.tokens[end + 1 : end + 3]] == ["^", "{"]


def read_between(parser: Parser, term: Node) -> Node:
    """Read limits after a term: its value at the upper limit minus that at the lower one."""
    start, by = parser.start, None
    ends: list[tuple[Letter | None, Node]] = []
    for sign in ("_", "^"):
        parser.take(sign)
        ends.append(parser.read_inside("{", lambda: _read_end(parser)))
        by = ends[-1][0] or by
    is_found = by is None
    by = by or _find_moving(parser, term)
    if by is None:
        raise parser.refuse(
            "limits after a term: limits of which letter?",
            r"Print the letter: \right|_{x=0}^{x=1}.",
            start,
        )
    low, high = (_put(term, by, point, is_found=is_found) for _, point in ends)
    difference = Add(((1, high), (-1, low)), start=term.start, end=parser.end)
    return Bracket(difference, start=term.start, end=parser.end)


def _read_end(parser: Parser) -> tuple[Letter | None, Node]:
    """Read x=0, or 0 alone."""
    first = parser.read_sum()
    if isinstance(first, Letter) and parser.skip("="):
        return first, parser.read_sum()
    return None, first


def _find_moving(parser: Parser, term: Node) -> Letter | None:
    """Return the only letter of a term, or the one of integration: x in [x]_0^a with dx printed.

    If the letters are functions of one other letter, return that one.
    """
    letters = {node.text: node for node in walk(term) if isinstance(node, Letter)}
    if len(letters) > 1 or isinstance(strip(term), Letter):
        called = {parser.notation.called.get(node.symbol) for node in letters.values()}
        if len(called) == 1 and (by := called.pop()):
            return Letter(by, str(by), start=term.start, end=term.end)
        texts = [token.text for token in parser.tokens]
        letters = {x: node for x, node in letters.items() if ("d", x) in pairwise(texts)}
    return next(iter(letters.values())) if len(letters) == 1 else None


def _put(term: Node, by: Letter, point: Node, *, is_found: bool) -> Node:
    start, end = term.start, point.end
    is_endless = any(isinstance(node, Constant) and node.value is sp.oo for node in walk(point))
    if is_endless:
        return Approach(term, by, point, "-", start=start, end=end)
    return At(term, by, point, is_found, start=start, end=end)


def _read_values(parser: Parser, term: Node) -> Node:
    """Read x=0,y=0: one value after the other."""
    start = term.start
    while True:
        by = parser.read_atom()
        if not isinstance(by, Letter) or by.indices:
            raise parser.refuse("a place is given as the value of a letter: x=0", place=by.start)
        parser.take("=")
        point = parser.read_sum()
        if not parser.skip(","):
            return At(term, by, point, start=start, end=parser.end)
        term = At(term, by, point, start=start, end=start)


def is_value(parser: Parser, letter: Letter) -> bool:
    r"""Return whether a letter that depends on another one is followed by an argument.

    That is a number, x(0), x(t=0), another letter, s(\beta), one of these times or divided by a
    number, s(2\beta), s(\frac{\beta}{2}), or, if x(t) is printed too, a sum that begins with t,
    x(t+T). Any other sum may be a factor.
    """
    running = find_running(parser, letter)
    if parser.text != "(" or letter.text in parser.factors or running is None:
        return False
    if letter.symbol in parser.notation.called or _is_letter_inside(parser, letter):
        return True
    if _is_shifted(parser, letter, running) or _find_sign(parser, letter, running):
        return True
    texts = [token.text for token in parser.rest[1:]]
    inside = list(takewhile(lambda text: text not in ("(", ")", ""), texts))
    has_number = any(is_digit(text) or text == r"\pi" for text in inside)
    ends = texts[len(inside) : len(inside) + 1] == [")"]
    return ends and has_number and all(is_digit(text) or text in _NUMERIC for text in inside)


def _is_shifted(parser: Parser, letter: Letter, running: Letter) -> bool:
    """Return whether a bracket begins with the running letter t and a sign, and x(t) is printed."""
    printed = "".join(token.text for token in parser.tokens)
    is_first = [token.text for token in parser.rest[:3]] in (
        ["(", running.text, sign] for sign in "+-"
    )
    return is_first and f"{letter.text}({running.text})" in printed


def _find_sign(parser: Parser, letter: Letter, running: Letter) -> int:
    """Return the place of the sign in x(t=0), 0 if there is none or a gap makes it a condition."""
    between = parser.source.latex[letter.end : parser.start].strip()
    match = parser.names.match(parser.tokens, parser.place + 1)
    if between or match is None or match.name.symbol != running.symbol:
        return 0
    return match.end if parser.peek(match.end - parser.place) == "=" else 0


def _is_letter_inside(parser: Parser, letter: Letter) -> bool:
    """Return whether a bracket contains one other declared letter, possibly with numbers."""
    place, met = parser.place + 1, 0
    while place < len(parser.tokens) and (text := parser.tokens[place].text) != ")":
        match = parser.names.match(parser.tokens, place)
        is_own = match is not None and match.name.symbol == letter.symbol
        if is_own or not (match or is_digit(text) or text in _NUMERIC):
            return False
        met += match is not None
        place = match.end if match else place + 1
    return met == 1


def find_running(parser: Parser, letter: Letter) -> Letter | None:
    """Return the letter that a letter depends on, or that a matrix is declared a function of."""
    if isinstance(letter.symbol, sp.MatrixSymbol):
        name = parser.names.find_argument(letter.symbol)
        found = (name.symbol, name.latex) if name else None
    else:
        moving = parser.notation.moving.items()
        running = (by for symbol, (by, rates) in moving if letter.symbol in (symbol, *rates))
        by = parser.notation.called.get(letter.symbol) or next(running, None)
        found = (by, str(by)) if by else None
    return Letter(*found, start=letter.start, end=letter.end) if found else None


def _read_point(parser: Parser, sign: int) -> Node:
    parser.place = sign + 1 if sign else parser.place
    return parser.read_sum()


def read_value(parser: Parser, letter: Letter) -> Node:
    """Read x(0), the value of a letter that depends on another one."""
    running = find_running(parser, letter)
    assert running is not None
    sign = _find_sign(parser, letter, running)
    point = parser.read_inside("(", lambda: _read_point(parser, sign))
    is_own = isinstance(point, Letter) and point.symbol == running.symbol
    if is_own and letter.symbol not in parser.notation.called:
        return letter
    return At(letter, running, point, start=letter.start, end=parser.end)
