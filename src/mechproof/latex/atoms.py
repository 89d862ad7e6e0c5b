"""Atoms: numbers, brackets, fractions, roots, matrices."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import pairwise
from typing import TYPE_CHECKING

import sympy as sp

from mechproof.latex import calculus, environments, letters, places, printed_derivatives, tree
from mechproof.latex.characters import is_digit
from mechproof.latex.latex_signs import CLOSED_BY, DOTS, NARROW, find_close, measure_depths
from mechproof.latex.matrix_meaning import give_inner_product, make_cross_matrix
from mechproof.latex.measures import read_measure, read_unit
from mechproof.latex.name_table import find_brace
from mechproof.latex.numerals import read_number
from mechproof.latex.printed_commands import VECTORS

if TYPE_CHECKING:
    from mechproof.latex.parser import Parser

_TRANSPOSED = (r"\top", r"\intercal", r"\mathrm{T}")
# Each sign that opens a rounding bracket -> its function.
_ROUNDING = {
    r"\lfloor": tree.PrintedFunction("floor", sp.floor),
    r"\lceil": tree.PrintedFunction("ceil", sp.ceiling),
}


def read_atom(parser: Parser) -> tree.Node:
    """Read the operand at the current place, up to the next operator."""
    start = parser.start
    text = parser.text
    if is_digit(text):
        return read_measure(parser)
    if match := parser.names.match(parser.tokens, parser.place):
        return letters.read_letter(parser, match)
    if text in VECTORS and [token.text for token in parser.rest[1:4]] == ["{", "0", "}"]:
        for _ in range(4):
            parser.take()
        # Next to a matrix, a zero stands for a matrix of zeros.
        return tree.Number("0", start=start, end=parser.end)
    if text == r"\frac" and printed_derivatives.is_derivative(parser):
        return printed_derivatives.read_derivative(parser)
    if text.startswith(r"\begin{"):
        return environments.read_environment(parser)
    if text in _READERS:
        return _READERS[text](parser)
    return read_unit(parser) or letters.read_letter(parser, None)


def _read_fraction(parser: Parser) -> tree.Node:
    if unit := read_unit(parser):
        return unit
    start = parser.take().start
    above = parser.read_inside("{", lambda: calculus.read_numerator(parser))
    below = parser.read_group()
    return tree.Quotient(above, below, start=start, end=parser.end)


def _read_root(parser: Parser) -> tree.Node:
    start = parser.take().start
    degree = None
    if parser.text == "[":
        degree = parser.read_inside("[", parser.read_sum)
    return tree.Radical(parser.read_group(), degree, start=start, end=parser.end)


def _read_bracket(parser: Parser) -> tree.Node:
    start = parser.start
    if parser.text == "[" and environments.is_cases(parser):
        parser.take()
        return environments.read_cases(parser, start)
    closing = CLOSED_BY[parser.text]
    if (parser.peek(1), parser.peek(2)) == (r"\dots", closing):
        return _repeat_bracket(parser, start)
    parts = parser.read_inside(parser.text, lambda: read_list(parser))
    if len(parts) == 1:
        bracket = tree.Bracket(parts[0], start=start, end=parser.end)
        return _read_cross(parser, bracket) if closing == "]" else bracket
    return tree.Entries(tuple(parts), start=start, end=parser.end)


def _read_cross(parser: Parser, bracket: tree.Bracket) -> tree.Node:
    r"""Read [a]_\times, the matrix of the cross product with a."""
    is_cross = [token.text for token in parser.rest[:4]] == ["_", "{", r"\times", "}"]
    if places.is_between(parser) and not is_cross:
        return places.read_between(parser, bracket)
    if not is_cross:
        _refuse_index(parser, bracket.start)
        return bracket
    parser.place += 4
    make = tree.PrintedFunction("cross", make_cross_matrix)
    return tree.Call(make, (bracket.inside,), start=bracket.start, end=parser.end)


def _refuse_index(parser: Parser, start: int) -> None:
    """Refuse an index after a square bracket: it names the coordinates of an undeclared matrix."""
    if parser.text == "_":
        end = parser.tokens[find_brace(parser.tokens, parser.place + 2)].end
        printed = parser.source.latex[start:end]
        raise parser.refuse(
            f"{printed} is not declared", parser.remedies.name.format(printed), start
        )


def read_list(parser: Parser) -> list[tree.Node]:
    """Read the comma-separated terms inside brackets or braces."""
    parts = [parser.read_sum()]
    while parser.skip(","):
        parts.append(parser.read_sum())
    if parser.text == NARROW:
        raise parser.refuse(
            "a blank in square brackets: between entries of a row, or factors?",
            r"Print commas between entries, \cdot between factors.",
        )
    return parts


def _repeat_bracket(parser: Parser, start: int) -> tree.Node:
    """Read (…) as the bracket of the preceding print, which must have exactly one."""
    parser.place += 3
    if len(parser.brackets) != 1:
        raise parser.refuse(
            f"(…) repeats a bracket, but the preceding print has {len(parser.brackets)}",
            "Print the bracket.",
            start,
        )
    return tree.Bracket(parser.brackets[0].inside, start=start, end=parser.end)


def _read_bars(parser: Parser) -> tree.Node:
    start, bar = parser.start, parser.take().text
    parser.bars[bar] += 1
    inside = parser.read_sum()
    parser.bars[bar] -= 1
    parser.take(bar)
    if bar == r"\|":
        return tree.Magnitude(inside, start=start, end=parser.end)
    _refuse_bar_between_factors(parser)
    return _enclose(parser, inside, start)


def _read_sized_bars(parser: Parser) -> tree.Node:
    start = parser.start
    inside = parser.read_inside(r"\lvert", parser.read_sum)
    return _enclose(parser, inside, start)


def _read_rounding(parser: Parser) -> tree.Node:
    start, opening = parser.start, parser.text
    inside = parser.read_inside(opening, parser.read_sum)
    return tree.Call(_ROUNDING[opening], (inside,), start=start, end=parser.end)


def _read_angles(parser: Parser) -> tree.Node:
    """Read an inner product of two vectors."""
    start = parser.start
    parts = parser.read_inside(r"\langle", lambda: read_list(parser))
    are_shown = [any(map(tree.shows_matrix, tree.walk(part))) for part in parts]
    if parser.text == "_" or not (parser.collects or are_shown == [True, True]):
        raise parser.refuse(
            "angle brackets: an inner product, entries of a vector, or a mean?",
            r"Declare both vectors, or print \cdot between them, (…) around entries.",
            start,
        )
    product = tree.PrintedFunction("inner product", give_inner_product)
    return tree.Call(product, tuple(parts), start=start, end=parser.end)


def _enclose(parser: Parser, inside: tree.Node, start: int) -> tree.Node:
    """Return what bars mean: the determinant of a printed matrix, otherwise the absolute value.

    The bars around a vector are its magnitude.
    """
    table = inside.inside if isinstance(inside, tree.Bracket) else inside
    is_symbol = isinstance(table, tree.Letter) and tree.shows_matrix(table)
    if isinstance(table, tree.Letter) and is_symbol and 1 in table.symbol.shape:
        return tree.Magnitude(inside, start=start, end=parser.end)
    if isinstance(table, tree.Table) or is_symbol:
        return tree.Call(parser.functions[r"\det"], (table,), start=start, end=parser.end)
    is_open = parser.collects and _shows_determinant(parser)
    if is_open and isinstance(table, tree.Letter) and not parser.names.find_alike(table.symbol):
        raise parser.refuse(
            f"bars around {table.text} next to a determinant: of a matrix, or an absolute value?",
            parser.remedies.name.format(table.text),
            start,
        )
    return tree.Magnitude(inside, start=start, end=parser.end)


def _shows_determinant(parser: Parser) -> bool:
    texts = [token.text for token in parser.tokens]
    is_in_bars = (r"\lvert", r"\begin{matrix}") in pairwise(texts)
    return is_in_bars or r"\begin{vmatrix}" in texts


def _refuse_bar_between_factors(parser: Parser) -> None:
    """Refuse |x|y|z|, which may be |x| times y|z|, or the value of x|y|z."""
    if parser.ends_product() or parser.text in ("|", "/", *DOTS, "^"):
        return
    if "|" in parser.rest_of_member():
        raise parser.refuse(
            "adjacent factors in upright bars: which bars belong together?",
            r"Print \left| and \right|, or \cdot after the bar.",
        )


def read_excerpt(parser: Parser, whole: tree.Node, start: int) -> tree.Node:
    """Read the rows and columns, [1:3, 4], that are taken from a matrix."""
    parser.take("[")
    ranges = [_read_range(parser)]
    while parser.skip(","):
        ranges.append(_read_range(parser))
    parser.take("]")
    return tree.Excerpt(whole, tuple(ranges), start=start, end=parser.end)


def is_pair(parser: Parser, count: int) -> bool:
    """Return whether a bracket with two arguments begins `count` tokens ahead."""
    texts = [token.text for token in parser.rest[count:]]
    depths = zip(texts[: find_close(texts)], measure_depths(texts), strict=False)
    return texts[:1] == ["("] and (",", 1) in depths


def is_excerpt(parser: Parser) -> bool:
    """Return whether the next token opens a square bracket that contains a colon."""
    texts = [token.text for token in parser.rest]
    return texts[:1] == ["["] and "]" in texts and ":" in texts[: texts.index("]")]


def _read_range(parser: Parser) -> tuple[int, int] | None:
    """Read a first and last number, or a single number as both; None for a colon alone."""
    if parser.skip(":"):
        return None
    first = _read_count(parser)
    return (first, _read_count(parser)) if parser.skip(":") else (first, first)


def _read_count(parser: Parser) -> int:
    if not is_digit(parser.text):
        raise parser.refuse("rows and columns are given by their numbers only", "Print [1:3, 4].")
    number = read_number(parser, in_list=True)
    if not number.text.isdigit():
        raise parser.refuse("a row number that is not a whole number", "", number.start)
    return int(number.text)


def read_special_power(parser: Parser, base: tree.Node, start: int) -> tree.Node | None:
    """Read a superscript that is not a power: a transposition or degrees; None for any other."""
    texts = [token.text for token in parser.tokens[parser.place + 1 : parser.place + 4]]
    is_plain = texts == ["{", "T", "}"]
    mark = texts[1] if texts[::2] == ["{", "}"] else ""
    has_matrix = is_plain and any(_shows_vector(parser, part) for part in tree.walk(base))
    if mark in _TRANSPOSED or has_matrix:
        parser.place += 4
        return tree.Transposed(base, start=start, end=parser.end)
    if is_plain and parser.collects and not parser.names.find("T"):
        raise parser.refuse(
            "a power T: an exponent, or the transpose of a matrix?",
            parser.remedies.name.format("T"),
        )
    is_ring = (
        texts == ["{", "o", "}"] and isinstance(base, tree.Number) and not parser.names.find("o")
    )
    if is_ring or texts == ["{", r"\circ", "}"]:
        parser.place += 4
        return tree.Degrees(base, start=start, end=parser.end)
    return None


def _shows_vector(parser: Parser, part: tree.Node) -> bool:
    """Return whether a part is a vector or a matrix.

    A bold letter counts as a vector if no letter T is declared.
    """
    is_bold = isinstance(part, tree.Letter) and part.text.startswith(VECTORS)
    return tree.shows_matrix(part) or (is_bold and not parser.names.find("T"))


# The sign with which an atom begins -> the function that reads the atom.
_READERS: Mapping[str, Callable[[Parser], tree.Node]] = {
    r"\frac": _read_fraction,
    r"\sqrt": _read_root,
    r"\binom": printed_derivatives.read_binomial,
    **dict.fromkeys(("(", "["), _read_bracket),
    **dict.fromkeys(("|", r"\|"), _read_bars),
    r"\lvert": _read_sized_bars,
    places.LEFT: places.read_enclosed,
    **dict.fromkeys(_ROUNDING, _read_rounding),
    r"\langle": _read_angles,
    **dict.fromkeys((r"\sum", r"\prod"), calculus.read_repeated),
    r"\lim": printed_derivatives.read_limit,
    r"\int": calculus.read_integral,
}
