r"""Sums and products with dots: 1+2+\dots+n, 1\cdot2\cdots n.

The last term determines the others: putting numbers in for its count must give the terms in front
of the dots, in their order, at least two of them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import sympy as sp

from mechproof.latex.characters import is_digit
from mechproof.latex.latex_signs import DOTS
from mechproof.latex.tree import Dotted, Node

if TYPE_CHECKING:
    from mechproof.latex.meaning import Meaning
    from mechproof.latex.parser import Parser

_DOTTED = r"\dots"
# Limits on the number of terms in front of the dots: most that are tried, fewest that must fit.
_MOST = 12
_FEWEST = 2


def is_dotted_sum(parser: Parser) -> bool:
    """Return whether a sign, dots and another sign follow."""
    return parser.peek() == _DOTTED and parser.peek(2) in parser.signs


def read_dotted_sum(parser: Parser, terms: Sequence[tuple[int, Node]], start: int) -> Node:
    """Read dots and the last term of the sum after them."""
    parser.place += 2
    last = parser.read_term()
    _refuse_number_after(parser)
    return Dotted("sum", tuple(terms), last, start=start, end=parser.end)


def is_dotted_product(parser: Parser) -> bool:
    """Return whether dots for factors, and another factor after them, follow."""
    texts = [token.text for token in parser.rest[:3]]
    inside = texts[1:] if texts[:1] and texts[0] in DOTS else texts
    return inside[:1] == [_DOTTED] and len(inside) > 1 and inside[1] not in (*parser.signs, "=")


def read_dotted_product(parser: Parser, factors: Sequence[Node], start: int) -> Node:
    """Read dots and the last factor of the product after them."""
    while parser.text in (*DOTS, _DOTTED):
        parser.take()
    last = parser.read_factor()
    _refuse_number_after(parser)
    terms = tuple((1, factor) for factor in factors)
    return Dotted("product", terms, (1, last), start=start, end=parser.end)


def _refuse_number_after(parser: Parser) -> None:
    """Refuse a number after the last term, which may be a part of it: n-1."""
    if parser.text in parser.signs and is_digit(parser.peek()):
        raise parser.refuse(
            f"{parser.text}{parser.peek()} after the last term: is it part of that term?",
            "Print brackets around the last term, (n-1), or the number before the dots.",
        )


def give_dotted(meaning: Meaning, node: Dotted) -> sp.Expr:
    """Return the sum or product, over a new index, whose first and last terms are printed."""
    first = [sign * meaning.take_number(term, meaning.of(term)) for sign, term in node.first]
    sign, term = node.last
    last = sign * meaning.take_number(term, meaning.of(term))
    runs = list(_find_runs(first, last))
    if len(runs) != 1:
        command = r"\sum" if node.name == "sum" else r"\prod"
        raise meaning.source.refuse(
            node.start,
            "which terms do the dots stand for?",
            rf"Print {command}_{{k=1}}^{{n}}, or two terms before the dots that the last one gives "
            "for whole numbers; declare its letter as a whole number.",
        )
    ((count, low, used),) = runs
    index = _choose_index([*first, last], starts_at_zero=low == 0)
    kind, join = (sp.Sum, sp.Add) if node.name == "sum" else (sp.Product, sp.Mul)
    total = kind(last.subs(count, index), (index, low, count))
    return join(*first[: len(first) - used], total)


def _choose_index(terms: Sequence[sp.Expr], *, starts_at_zero: bool) -> sp.Symbol:
    met = {symbol.name for term in terms for symbol in term.free_symbols}
    name = next(letter for letter in (*"kjlpq", "index") if letter not in met)
    return sp.Symbol(name, integer=True, **{"nonnegative" if starts_at_zero else "positive": True})


def _find_runs(first: Sequence[sp.Expr], last: sp.Expr) -> Iterator[tuple[sp.Symbol, int, int]]:
    """Yield a count, its value in the first term counted, and how many printed terms it counts."""
    for count in sorted((s for s in last.free_symbols if s.is_integer), key=str):
        for following in range(1, _MOST):
            used = 0
            while used < min(len(first), following):
                if sp.expand(first[-1 - used] - last.subs(count, following - 1 - used)) != 0:
                    break
                used += 1
            if used >= _FEWEST:
                yield count, following - used, used
