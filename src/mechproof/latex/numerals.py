"""Numbers: digits without gaps, with a decimal point."""

from __future__ import annotations

import re
from itertools import dropwhile
from typing import TYPE_CHECKING

from mechproof.latex.characters import is_digit
from mechproof.latex.tree import Bracket, Letter, Node, Number

if TYPE_CHECKING:
    from mechproof.latex.parser import Parser

LONGEST_NUMBER = 300
# Vectors whose commas separate entries: unit vectors, and those that end with two zeros.
_ALONG_AXIS = re.compile(
    r"[(\[](?:0,0,(?=\D)|[01],[01],[01](?=[)\]])|[^()\[\],]*[^()\[\],\d],0,0(?=[)\]]))"
)
_THOUSANDS = re.compile(r"\d{1,3}(?:\\,\d{3})+(?!\d)")
_POWER_OF_TEN = re.compile(r"\s*[eE]\+?(?P<exponent>[-\u2212]?[0-9]+)")
# In these commands an e after digits marks a power of ten, not a letter.
_QUANTITY = re.compile(r"\\(?:num|SI|qty)\s*\{\s*[-+]?\s*\Z")


def read_number(parser: Parser, *, in_list: bool = False) -> Number:
    """Read adjacent digits with an optional decimal point.

    In a list a gap or a comma ends a number.
    """
    start = parser.start
    text = parser.take().text
    while is_digit(parser.text) or (_is_point(parser) and "." not in text):
        if parser.start != parser.end and "." not in (parser.text, text[-1]):
            if in_list:
                break
            if _is_grouped(parser, start):
                text += parser.take().text
                continue
            raise parser.refuse("a blank within a number: one number or two?", "Close the gap.")
        text += parser.take().text
    if text[-1] == ".":
        raise parser.refuse("a number ends with a point")
    if len(text) > LONGEST_NUMBER:
        raise parser.refuse(f"a number of more than {LONGEST_NUMBER} digits", place=start)
    follows = parser.tokens[parser.place + 1 : parser.place + 2]
    if parser.text == "," and not in_list and follows and is_digit(follows[0].text):
        close = follows[0].start == parser.end + 1 and parser.start == parser.end
        along = _ALONG_AXIS.finditer(parser.source.latex)
        if close and not any(one.start() < start < one.end() for one in along):
            raise parser.refuse(
                "a comma between digits: a decimal comma or a list?",
                "Print 0.5 or 0{,}5 for the number, a blank after the comma for a list.",
            )
    if power := _POWER_OF_TEN.match(parser.source.latex, parser.end):
        if _QUANTITY.search(parser.source.latex[:start]):
            while parser.start < power.end():
                parser.take()
            exponent = power["exponent"].replace("\u2212", "-")
            return Number(f"{text}e{exponent}", start=start, end=parser.end)
        raise parser.refuse(
            "a number before an E and digits: a power of ten, or a product?",
            rf"Print {text}\cdot 10^{{…}}, or \cdot before the letter.",
        )
    return Number(text, start=start, end=parser.end)


def _is_point(parser: Parser) -> bool:
    """Return whether a decimal point is next, rather than the full stop after a row of cases."""
    return parser.text == "." and not parser.peek(1).startswith((r"\end{", r"\\"))


def _is_grouped(parser: Parser, start: int) -> bool:
    r"""Return whether the gap here separates thousands: 60\,000."""
    grouped = _THOUSANDS.match(parser.source.latex, start)
    return grouped is not None and parser.start < grouped.end()


def is_number_fraction(parser: Parser) -> bool:
    """Return whether the fraction here consists of numbers only."""
    texts = [token.text for token in parser.tokens[parser.place + 1 :]]
    inside = texts[: texts.index("}", texts.index("}") + 1)]
    return all(is_digit(text) or text in "{}." for text in inside)


def may_follow(parser: Parser, left: Node) -> bool:
    """Return whether a number after a factor is a factor, too: after a bracket, or in n2^{n-1}.

    There, the letter counts, and a number with a power is not an index of it.
    """
    if not isinstance(left, Letter):
        return isinstance(left, Bracket)
    after = dropwhile(is_digit, (token.text for token in parser.rest))
    counts = left.text in parser.factors and (parser.collects or bool(left.symbol.is_integer))
    return counts and next(after, "") == "^"
