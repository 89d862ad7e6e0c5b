"""Atoms: numbers, brackets, fractions, roots, matrices."""

from __future__ import annotations

from typing import TYPE_CHECKING

import sympy as sp

from mechproof.latex import calculus, derivatives, letters
from mechproof.latex.characters import is_digit
from mechproof.latex.numerals import read_number
from mechproof.latex.tree import (
    Bracket,
    Call,
    Degrees,
    Entries,
    Letter,
    Magnitude,
    Node,
    Quotient,
    Root,
    Table,
    Transposed,
)

if TYPE_CHECKING:
    from mechproof.latex.parser import Parser

MATRICES = ("pmatrix", "bmatrix", "matrix", "vmatrix")
_CLOSED_BY = {"(": ")", "[": "]"}


def read_atom(parser: Parser) -> Node:
    """Read what stands between two operators."""
    start = parser.start
    text = parser.text
    if is_digit(text):
        return read_number(parser)
    if match := parser.names.match(parser.tokens, parser.place):
        return letters.read_letter(parser, match)
    if text == r"\frac" and derivatives.is_derivative(parser):
        return derivatives.read_derivative(parser)
    if text == r"\frac":
        return _read_fraction(parser, start)
    if text == r"\sqrt":
        return _read_root(parser, start)
    if text in _CLOSED_BY:
        return _read_bracket(parser, start)
    if text == "|":
        return _read_magnitude(parser, start)
    if text == r"\lvert":
        inside = parser.read_inside(r"\lvert", parser.read_sum, r"\rvert")
        return _enclose(parser, inside, start)
    if text.startswith(r"\begin{"):
        return _read_table(parser, start)
    if text in (r"\sum", r"\prod"):
        return calculus.read_repeated(parser)
    if text == r"\lim":
        return derivatives.read_limit(parser)
    if text == r"\int":
        return calculus.read_integral(parser)
    return letters.read_letter(parser, None)


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
    parts = parser.read_inside(parser.text, lambda: read_list(parser), closing)
    if len(parts) == 1:
        return Bracket(parts[0], start=start, end=parser.end)
    return Entries(tuple(parts), start=start, end=parser.end)


def read_list(parser: Parser) -> list[Node]:
    """Read what stands in brackets or braces, parted by commas."""
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
    _refuse_bar_between_factors(parser)
    return _enclose(parser, inside, start)


def _enclose(parser: Parser, inside: Node, start: int) -> Node:
    """Return what bars say: the determinant of a printed matrix, else the absolute value."""
    table = inside.inside if isinstance(inside, Bracket) else inside
    if isinstance(table, Table):
        return Call(parser.functions[r"\det"], (table,), start=start, end=parser.end)
    return Magnitude(inside, start=start, end=parser.end)


def _refuse_bar_between_factors(parser: Parser) -> None:
    """Refuse |x|y|z|, which may be |x| times y|z|, or the value of x|y|z."""
    if parser.ends_product() or parser.text in ("|", "/", r"\cdot", "^"):
        return
    if "|" in parser.rest_of_member():
        raise parser.refuse(
            "upright bars around factors side by side: which belong together?",
            r"Print \left| and \right|, or \cdot behind the bar.",
        )


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
    table = Table(tuple(rows), start=start, end=parser.end)
    if kind == "vmatrix":
        return Call(parser.functions[r"\det"], (table,), start=start, end=parser.end)
    return table


def read_special_power(parser: Parser, base: Node, start: int) -> Node | None:
    """Read a power that is none: transposition, degrees."""
    texts = [token.text for token in parser.tokens[parser.place + 1 : parser.place + 4]]
    inside = base.inside if isinstance(base, Bracket) else base
    is_matrix = isinstance(inside, Entries | Table) or (
        isinstance(base, Letter) and isinstance(base.symbol, sp.MatrixSymbol)
    )
    if texts == ["{", "T", "}"] and is_matrix:
        parser.place += 4
        return Transposed(base, start=start, end=parser.end)
    if texts == ["{", "T", "}"] and parser.collects and not parser.names.find("T"):
        raise parser.refuse(
            "a power T: an exponent, or the transposed of a matrix?",
            parser.remedies.name.format("T"),
        )
    if texts == ["{", r"\circ", "}"]:
        parser.place += 4
        return Degrees(base, start=start, end=parser.end)
    return None
