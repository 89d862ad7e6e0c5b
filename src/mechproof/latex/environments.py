"""Environments: matrices, determinants, and cases."""

from __future__ import annotations

from itertools import pairwise, takewhile
from typing import TYPE_CHECKING

from mechproof.latex import side_conditions
from mechproof.latex.characters import is_digit
from mechproof.latex.numerals import read_number
from mechproof.latex.printed_relations import RELATIONS, read_relations
from mechproof.latex.tree import Call, Cases, Chain, Node, Table
from mechproof.latex.words import ELSE, IF, UNDEFINED

if TYPE_CHECKING:
    from mechproof.latex.parser import Parser

MATRICES = ("pmatrix", "bmatrix", "matrix", "vmatrix")
_DOTS = (r"\dots", r"\vdots", r"\ddots")
_BRACED = "Bmatrix"
_CASES = ("cases", "dcases", _BRACED)


def read_environment(parser: Parser) -> Node:
    """Read a matrix, its determinant, or cases."""
    start = parser.start
    kind = parser.text[len(r"\begin{") : -1]
    if kind in _CASES and not (kind == _BRACED and _is_matrix(parser)):
        return read_cases(parser, parser.take().start)
    if kind not in (*MATRICES, _BRACED):
        raise parser.refuse(f"{kind} is not one of {', '.join((*MATRICES, *_CASES))}", place=start)
    table = _read_table(parser, kind)
    if kind == "vmatrix":
        return Call(parser.functions[r"\det"], (table,), start=start, end=parser.end)
    return table


def _is_matrix(parser: Parser) -> bool:
    """Return whether braces hold entries without a condition, as printed columns often do."""
    texts = (token.text for token in parser.rest)
    inside = {*takewhile(lambda text: text != rf"\end{{{_BRACED}}}", texts)}
    return not inside & {*RELATIONS, *IF, *ELSE, *UNDEFINED}


def _read_table(parser: Parser, kind: str) -> Table:
    start = parser.take().start
    parser.depth += 1
    rows: list[tuple[Node, ...]] = []
    while not parser.skip(rf"\end{{{kind}}}"):
        entries = [_read_entry(parser)]
        while parser.skip("&"):
            entries.append(_read_entry(parser))
        rows.append(tuple(entries))
        if not parser.skip(r"\\") and parser.text != rf"\end{{{kind}}}":
            raise parser.refuse("a matrix is continued in an unknown way")
    parser.depth -= 1
    if len({len(row) for row in rows}) != 1:
        raise parser.refuse("the rows of a matrix differ in length", place=start)
    return Table(tuple(rows), start=start, end=parser.end)


def _read_entry(parser: Parser) -> Node:
    r"""Read an entry; numbers separated by gaps, `0 \; 0`, are a row of a block."""
    if parser.text in _DOTS or [token.text for token in parser.rest[:2]] == [".", "."]:
        raise parser.refuse(
            "dots for entries of a matrix, whose number is not given",
            "Print all entries of a matrix of a certain size.",
        )
    if parser.text in ("&", r"\\") or parser.text.startswith(r"\end{"):
        raise parser.refuse(
            "an empty entry of a matrix: a zero, or left out?", "Print 0 where it is zero."
        )
    if not _is_list(parser):
        return parser.read_sum()
    start, found = parser.start, []
    while is_digit(parser.text):
        found.append(read_number(parser, in_list=True))
    return Table((tuple(found),), start=start, end=parser.end)


def _is_list(parser: Parser) -> bool:
    """Return whether an entry consists only of numbers with printed gaps between them."""
    tokens = list(takewhile(lambda t: is_digit(t.text) or t.text == ".", parser.rest))
    follows = parser.peek(len(tokens))
    is_end = follows in ("", "&", r"\\") or follows.startswith(r"\end")
    between = [parser.source.latex[one.end : other.start] for one, other in pairwise(tokens)]
    return is_end and any(gap.strip(" ") for gap in between)


# Cases ------------------------------------------------------------------------------------------


def is_cases(parser: Parser) -> bool:
    r"""Return whether a brace that nothing closes, \left\{…\right., opens a table here."""
    texts = [token.text for token in parser.rest]
    begins = texts[1:2] == [r"\begin{matrix}"] and r"\end{matrix}" in texts
    return begins and texts[texts.index(r"\end{matrix}") + 1 :][:1] == [r"\right."]


def read_cases(parser: Parser, start: int) -> Cases:
    """Read the rows of cases; the opening brace has already been read."""
    is_table = parser.skip(r"\begin{matrix}")
    parser.depth += 1
    pieces: list[tuple[Node | None, Chain]] = []
    otherwise = None
    while not parser.text.startswith(r"\end{"):
        if otherwise is not None:
            raise parser.refuse("a case after the value for all others")
        parser.skip("&")
        value = None if parser.skip(*UNDEFINED) else parser.read_sum()
        _skip_marks(parser)
        if parser.skip(*ELSE):
            otherwise = value
        else:
            parser.skip(*IF)
            if parser.text == r"\\" or parser.text.startswith(r"\end{"):
                raise parser.refuse("a case without its condition")
            pieces.append((value, _read_condition(parser)))
        parser.skip(",", ";", ".")
        parser.skip(r"\\")
    parser.take()
    if is_table and parser.text.startswith(r"\end{"):
        parser.take()
    parser.skip(r"\right.")
    parser.depth -= 1
    return Cases(tuple(pieces), otherwise, start=start, end=parser.end)


def _read_condition(parser: Parser) -> Chain:
    """Read the condition of a case, which may be in brackets."""

    def read() -> Chain:
        parser.skip(*IF)
        return read_relations(parser, parser.start, ",")

    if not side_conditions.is_bracketed(parser):
        return read()
    return parser.read_inside(parser.text, read)


def _skip_marks(parser: Parser) -> None:
    parser.skip(",", ";")
    parser.skip("&")
    parser.skip(",", ";")
