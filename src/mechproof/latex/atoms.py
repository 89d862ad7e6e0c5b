"""Atoms: numbers, names, brackets, fractions, roots, matrices."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import sympy as sp

from mechproof.latex import calculus
from mechproof.latex.functions import AMBIGUOUS, CONSTANTS
from mechproof.latex.names import Match
from mechproof.latex.tokens import ACCENTS
from mechproof.latex.tree import (
    Bracket,
    Constant,
    Degrees,
    Entries,
    Letter,
    Magnitude,
    Node,
    Number,
    Power,
    Quotient,
    Root,
    Table,
    Transposed,
)

if TYPE_CHECKING:
    from mechproof.latex.parser import Parser

MATRICES = ("pmatrix", "bmatrix", "matrix")
_CLOSED_BY = {"(": ")", "[": "]"}
_WORD = re.compile(r"[a-z]{2,}")
DECLARE = "Declare Variable(…, latex=(r'{0}',)) in the paper."


def read_atom(parser: Parser) -> Node:
    """Read what stands between two operators."""
    start = parser.start
    text = parser.text
    if text.isdigit():
        return read_number(parser)
    if match := parser.names.match(parser.tokens, parser.place):
        return read_letter(parser, match)
    if text == r"\frac":
        return _read_fraction(parser, start)
    if text == r"\sqrt":
        return _read_root(parser, start)
    if text in _CLOSED_BY:
        return _read_bracket(parser, start)
    if text == "|":
        return _read_magnitude(parser, start)
    if text.startswith(r"\begin{"):
        return _read_table(parser, start)
    if text in (r"\sum", r"\prod"):
        return calculus.read_repeated(parser)
    if text == r"\int":
        return calculus.read_integral(parser)
    return read_letter(parser, None)


def read_number(parser: Parser) -> Number:
    """Read digits that stand close together, and a decimal point."""
    start = parser.start
    text = parser.take().text
    while parser.text.isdigit() or (parser.text == "." and "." not in text):
        if parser.start != parser.end and "." not in (parser.text, text[-1]):
            raise parser.refuse("a blank within a number: one number or two?", "Close the gap.")
        text += parser.take().text
    if text[-1] == ".":
        raise parser.refuse("a number ends with a point")
    follows = parser.tokens[parser.place + 1 : parser.place + 2]
    if parser.text == "," and follows and follows[0].text.isdigit():
        close = follows[0].start == parser.end + 1 and parser.start == parser.end
        if close:
            raise parser.refuse(
                "a comma between digits: a decimal comma or a list?",
                "Print 0.5 or 0{,}5 for the number, a blank after the comma for a list.",
            )
    return Number(text, start=start, end=parser.end)


def _read_fraction(parser: Parser, start: int) -> Node:
    parser.take()
    above = calculus.read_numerator(parser)
    below = parser.read_group()
    return Quotient(above, below, start=start, end=parser.end)


def _read_root(parser: Parser, start: int) -> Node:
    parser.take()
    degree = None
    if parser.text == "[":
        degree = parser.read_inside("[", parser.read_sum, "]")
    return Root(parser.read_group(), degree, start=start, end=parser.end)


def _read_bracket(parser: Parser, start: int) -> Node:
    closing = _CLOSED_BY[parser.text]
    following = [token.text for token in parser.tokens[parser.place + 1 : parser.place + 3]]
    if following == [r"\dots", closing]:
        return _repeat_bracket(parser, start)
    parts = parser.read_inside(parser.text, lambda: _read_list(parser), closing)
    if len(parts) == 1:
        return Bracket(parts[0], start=start, end=parser.end)
    return Entries(tuple(parts), start=start, end=parser.end)


def _read_list(parser: Parser) -> list[Node]:
    parts = [parser.read_sum()]
    while parser.skip(","):
        parts.append(parser.read_sum())
    return parts


def _repeat_bracket(parser: Parser, start: int) -> Node:
    """(…) is the bracket of the print before, if that has exactly one among its factors."""
    parser.place += 3
    if len(parser.brackets) != 1:
        raise parser.refuse(
            f"(…) repeats a bracket, but the print before it has {len(parser.brackets)}",
            "Print the bracket.",
            start,
        )
    return Bracket(parser.brackets[0].inside, start=start, end=parser.end)


def _read_magnitude(parser: Parser, start: int) -> Node:
    parser.take("|")
    parser.bars += 1
    inside = parser.read_sum()
    parser.bars -= 1
    parser.take("|")
    return Magnitude(inside, start=start, end=parser.end)


def _read_table(parser: Parser, start: int) -> Node:
    opening = parser.take()
    kind = opening.text[len(r"\begin{") : -1]
    if kind not in MATRICES:
        raise parser.refuse(f"{kind} is none of {', '.join(MATRICES)}", place=start)
    parser.depth += 1
    rows: list[tuple[Node, ...]] = []
    while not parser.skip(rf"\end{{{kind}}}"):
        entries = [parser.read_sum()]
        while parser.skip("&"):
            entries.append(parser.read_sum())
        rows.append(tuple(entries))
        if not parser.skip(r"\\") and parser.text != rf"\end{{{kind}}}":
            raise parser.refuse("a matrix goes on in an unknown way")
    parser.depth -= 1
    if len({len(row) for row in rows}) != 1:
        raise parser.refuse("the rows of a matrix are not equally long", place=start)
    return Table(tuple(rows), start=start, end=parser.end)


def read_special_power(parser: Parser, base: Node, start: int) -> Node | None:
    """Read a power that is none: transposition, degrees."""
    texts = [token.text for token in parser.tokens[parser.place + 1 : parser.place + 4]]
    is_matrix = isinstance(base, Entries | Table) or (
        isinstance(base, Letter) and isinstance(base.symbol, sp.MatrixSymbol)
    )
    if texts == ["{", "T", "}"] and is_matrix:
        parser.place += 4
        return Transposed(base, start=start, end=parser.end)
    if texts == ["{", r"\circ", "}"]:
        parser.place += 4
        return Degrees(base, start=start, end=parser.end)
    return None


def check_bracket_after(parser: Parser, left: Node) -> None:
    """Refuse a round bracket after a letter, unless the letter is declared to be a factor."""
    letter = left.base if isinstance(left, Power) else left
    if parser.text != "(" or not isinstance(letter, Letter) or letter.text in parser.bound:
        return
    if isinstance(letter.symbol, sp.MatrixSymbol):
        return
    if letter.text not in parser.factors:
        printed = parser.source.latex[letter.start : letter.end]
        raise parser.refuse(
            f"a bracket after {printed}: a factor, or the argument of a function?",
            f"Declare Notation(factors=(r'{printed}',)) for the product, "
            f"Notation(functions={{…}}) for the function, or the whole print as a name, "
            f"Variable(…, latex=(r'{printed}(…)',)).",
        )


def read_letter(parser: Parser, match: Match | None) -> Node:
    """Read the longest declared name, a bound letter, or a constant."""
    start, place = parser.start, parser.place
    if parser.text in parser.bound and (match is None or match.end == place + 1):
        return _read_bound(parser, match)
    if match:
        return _read_name(parser, match)
    if parser.text in CONSTANTS:
        token = parser.take()
        return Constant(CONSTANTS[token.text], token.text.strip("\\"), start=start, end=token.end)
    return _read_undeclared(parser)


def _read_bound(parser: Parser, match: Match | None) -> Node:
    start = parser.start
    token = parser.take()
    if match:
        raise parser.refuse(
            f"{token.text} is bound here and declared as {match.name.symbol}",
            f"Declare Scope(rows=(…), names={{r'{token.text}': None}}) in Notation.scopes.",
            start,
        )
    _refuse_continuation(parser, token.text, start)
    return Letter(index_symbol(parser, token.text), token.text, start=start, end=token.end)


def index_symbol(parser: Parser, letter: str) -> sp.Symbol:
    """Return the symbol of an index letter."""
    declared = (s for s in parser.notation.indices if s.name == letter)
    return next(declared, sp.Symbol(letter.strip("\\"), integer=True))


def _read_name(parser: Parser, match: Match) -> Node:
    start, signs = parser.start, parser.tokens[parser.place : match.end]
    indices = tuple(i for span in match.indices for i in _read_indices(parser, *span))
    parser.place = match.end
    latex = parser.source.latex[start : parser.end]
    _refuse_continuation(parser, latex, start)
    if parser.text == "(" and (other := parser.names.longer(match.name, "(")):
        raise parser.refuse(
            f"{other.latex} is a declared name, this is another: an argument or a factor?",
            f"{DECLARE.format(latex + '(…)')}",
        )
    text = "".join(token.text for token in signs)
    return Letter(match.name.symbol, text, indices, start=start, end=parser.end)


def _refuse_continuation(parser: Parser, latex: str, start: int) -> None:
    if parser.text in ("_", "'"):
        part = "an index" if parser.text == "_" else "a prime"
        raise parser.refuse(
            f"{latex} is declared, but not with {part}",
            DECLARE.format(_printed_name(parser, start)),
        )


def _read_indices(parser: Parser, start: int, end: int) -> list[Node]:
    """Read the indices of a family: letters one by one, or one expression."""
    parser.place = start
    if any(token.text in ("+", "-") for token in parser.tokens[start:end]):
        return [_read_index_sum(parser, end)]
    found: list[Node] = []
    while parser.place < end:
        found.append(read_number(parser) if parser.text.isdigit() else _read_index(parser))
    return found


def _read_index(parser: Parser) -> Node:
    token = parser.take()
    name = parser.names.find(token.text)
    bound = token.text in parser.bound
    symbol = name.symbol if name and not bound else index_symbol(parser, token.text)
    return Letter(symbol, token.text, start=token.start, end=token.end)


def _read_index_sum(parser: Parser, end: int) -> Node:
    letters = {t.text for t in parser.tokens[parser.place : end] if t.text.isalpha()}
    before = len(parser.bound)
    parser.bound += [x for x in letters if not parser.names.find(x)]
    node = parser.read_sum()
    del parser.bound[before:]
    return node


def _read_undeclared(parser: Parser) -> Node:
    start, text = parser.start, parser.text
    if not text:
        raise parser.refuse("the print ends, but something must follow")
    word = _WORD.match(parser.source.latex, start)
    if word and rf"\{word[0]}" in parser.functions:
        raise parser.refuse(
            f"{word[0]} in italics: a function or a product?", rf"Print \{word[0]}."
        )
    if text == r"\dots":
        raise parser.refuse("dots for what was printed before", "Enter the chain as a whole.")
    if text[1:] in AMBIGUOUS:
        raise parser.refuse(
            f"{text[1:]} is not the same everywhere: {AMBIGUOUS[text[1:]]} must be said",
            f"Declare Notation(functions={{'{text[1:]}': …}}).",
        )
    if not (text.isalpha() or (text[0] == "\\" and text[1:2].isalpha())):
        raise parser.refuse(f"{text} has no meaning here")
    if parser.integrals and calculus.is_plain_letter(parser):
        return calculus.read_running_letter(parser)
    printed = _printed_name(parser, start)
    begun = [latex for latex in parser.names.beginning(text) if latex != printed]
    near = f" (declared are {', '.join(begun[:4])})" if begun else ""
    raise parser.refuse(f"{printed} is not declared{near}", DECLARE.format(printed))


def _printed_name(parser: Parser, start: int) -> str:
    """Return the letter at a place of the source with its index and primes."""
    place = next(n for n, token in enumerate(parser.tokens) if token.start >= start)
    end = place + 1
    texts = [token.text for token in parser.tokens]
    if texts[place] in ACCENTS:
        end = texts.index("}", end) + 1
    while end < len(texts) and texts[end] in ("_", "'"):
        end = texts.index("}", end) + 1 if texts[end] == "_" else end + 1
    return parser.source.latex[start : parser.tokens[end - 1].end]
