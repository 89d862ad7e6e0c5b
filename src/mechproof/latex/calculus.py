"""Sums, products and integrals: which letters they bind, and how far they reach."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from itertools import takewhile
from typing import TYPE_CHECKING

import sympy as sp

from mechproof.latex import letters, tree
from mechproof.latex.latex_signs import DOTS, find_close
from mechproof.latex.left_scripts import begins_letter
from mechproof.latex.printed_relations import RELATIONS, UP
from mechproof.latex.undeclared import printed_name

if TYPE_CHECKING:
    from mechproof.latex.parser import Parser

_NEEDS_BOTH, _WITH_BOTH = "an index needs its first value and its last", r"Print \sum_{k=1}^n."


@dataclass
class OpenIntegral:
    """An integral being read: its differential, and the letters that it may bind."""

    depth: int
    differential: tree.Node | None = None
    running: list[tree.Letter] = field(default_factory=list)


def compare_derivatives(chain: tree.Chain) -> tree.Chain:
    r"""Read \int f\,dx=F+C without a lower limit as the statement that f is the derivative of F+C.

    The chain is returned unchanged if the other side is a single letter, which the integral then
    defines, or if the integrand has letters that the other side lacks and does not contain the
    variable of integration, as in an integral over a body, \int r^2\,dm.
    """
    if len(chain.members) != 2 or chain.relations != ("=",):
        return chain
    sides = [tree.strip(member) for member in chain.members]
    unlimited = [n for n, side in enumerate(sides) if _has_no_limits(side)]
    if len(unlimited) != 1:
        return chain
    (place,) = unlimited
    integral, other = sides[place], sides[1 - place]
    assert isinstance(integral, tree.Integration)
    by, is_read = integral.differential, not any(map(_has_no_limits, tree.walk(other)))
    if not isinstance(by, tree.Letter) or isinstance(other, tree.Letter) or not is_read:
        return chain
    inside, beside = _list_symbols(integral.integrand), _list_symbols(other)
    if by.symbol not in inside and not inside <= beside:
        return chain
    sides[place] = replace(integral.integrand, start=integral.start, end=integral.end)
    sides[1 - place] = tree.Derivation(other, by, start=other.start, end=other.end)
    return replace(chain, members=tuple(sides))


def _has_no_limits(node: tree.Node) -> bool:
    return isinstance(node, tree.Integration) and node.low is None and node.high is None


def _list_symbols(node: tree.Node) -> set[sp.Basic]:
    return {part.symbol for part in tree.walk(node) if isinstance(part, tree.Letter)}


# Sums -------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Range:
    """An index of a sum, its first value, and the values that it skips."""

    index: tree.Letter
    low: tree.Node
    apart: tuple[tree.Node, ...] = ()


def read_repeated(parser: Parser) -> tree.Node:
    r"""Read \sum_{k=1}^n and the product after it; \sum_{k=1,k\ne i} leaves one term out.

    \sum_{i,j=1}^n and \sum_{1\le i<j\le n} are nested sums.
    """
    start = parser.start
    name = parser.take().text.strip("\\")
    if parser.text != "_":
        raise parser.refuse(
            f"a {name} without limits: which index, from where to where?",
            rf"Print \{name}_{{k=1}}^n. {_name_whole(parser, name)}".strip(),
        )
    ranges, high = _read_below(parser)
    if high is None and parser.text != "^":
        raise parser.refuse(f"a {name} without an upper limit", rf"Print \{name}_{{k=1}}^n.")
    high = high or parser.read_script("^")
    names = [one.index.text for one in ranges]
    parser.bound += names
    parser.sums += [(f"{name} {index}", parser.depth) for index in names]
    term = parser.read_product()
    del parser.sums[-len(names) :], parser.bound[-len(names) :]
    for one in reversed(ranges):
        place = {"start": start, "end": parser.end}
        term = tree.Repeated(name, term, one.index, one.low, high, one.apart, **place)
    return term


def is_double_sum(parser: Parser) -> bool:
    r"""Return whether a second sum over the index of the open sum follows as its factor.

    Reading it as a factor of the term would give the same value, \sum_{k=1}^nk\cdot\sum_{k=1}^nk,
    if k is in neither of its limits.
    """
    place = parser.place + (parser.text in DOTS)
    texts = [token.text for token in parser.tokens[place:]]
    index = "".join(texts[3:4])
    if texts[:3] != [r"\sum", "_", "{"] or parser.sums[-1:] != [(f"sum {index}", parser.depth)]:
        return False
    low = 3 + texts[3:].index("}")
    high = texts[low + 2 : low + 2 + find_close(texts[low + 2 :])]
    return index not in (*texts[4:low], *high)


def _name_whole(parser: Parser, name: str) -> str:
    r"""Return how to declare a sum without an index and limits as a single letter, \sum F_x."""
    if not begins_letter(parser.text):
        return ""
    return parser.remedies.name.format(rf"\{name} {printed_name(parser, parser.place)}")


def _read_below(parser: Parser) -> tuple[list[_Range], tree.Node | None]:
    """Read the text below a sum: its indices, and their last value if it is given there."""
    parser.take("_")
    parser.take("{")
    count = len(parser.bound)
    ranges, high = _read_values(parser) if _begins_values(parser) else _read_order(parser)
    while parser.skip(","):
        _add_difference(parser, ranges)
    del parser.bound[count:]
    parser.take("}")
    return ranges, high


def _begins_values(parser: Parser) -> bool:
    r"""Return whether first values come next, k=1 or i,j=1, rather than an order, 1\le i."""
    place = 0
    while parser.peek(place + 1) == ",":
        place += 2
    return parser.peek(place + 1) not in UP


def _read_values(parser: Parser) -> tuple[list[_Range], None]:
    """Read i=1, or i,j=1."""
    indices = [_read_index(parser)]
    while parser.skip(","):
        indices.append(_read_index(parser))
    if parser.text != "=":
        raise parser.refuse("an index needs its first value", _WITH_BOTH)
    parser.take("=")
    del parser.bound[-len(indices) :]
    low = parser.read_sum()
    parser.bound += [index.text for index in indices]
    return [_Range(index, low) for index in indices], None


def _read_order(parser: Parser) -> tuple[list[_Range], tree.Node]:
    r"""Read 1\le i\le n, or 1\le i<j\le n."""
    below = takewhile(lambda token: token.text != "}", parser.tokens[parser.place :])
    if sum(token.text in UP for token in below) == 1:
        raise parser.refuse(_NEEDS_BOTH, _WITH_BOTH)
    low, found = parser.read_sum(), list[_Range]()
    while parser.text in UP:
        step = int(parser.take().text == "<")
        if found and parser.peek() not in UP:
            return found, _add_count(parser.read_sum(), -step)
        index = _read_index(parser)
        found.append(_Range(index, _add_count(low, step)))
        low = index
    raise parser.refuse(_NEEDS_BOTH, _WITH_BOTH)


def _add_count(node: tree.Node, count: int) -> tree.Node:
    one = tree.Number("1", start=node.start, end=node.end)
    return tree.Add(((1, node), (count, one))) if count else node


def _read_index(parser: Parser) -> tree.Letter:
    token = parser.take()
    if token.text in parser.bound:
        raise parser.refuse(
            f"{token.text} is already the index of an enclosing sum",
            "Print another letter for one of them.",
            token.start,
        )
    symbol = letters.index_symbol(parser, token.text)
    parser.bound.append(token.text)
    return tree.Letter(symbol, token.text, start=token.start, end=token.end)


def _add_difference(parser: Parser, ranges: list[_Range]) -> None:
    r"""Read k\ne i, where k or i is an index of the sum; of two, the inner one skips a value."""
    start, left = parser.start, parser.read_sum()
    parser.take(r"\ne")
    sides = (left, parser.read_sum())
    for place, one in reversed([*enumerate(ranges)]):
        others = [side for side in sides if side != one.index]
        if len(others) == 1:
            ranges[place] = replace(one, apart=(*one.apart, *others))
            return
    raise parser.refuse("a condition below a sum that lacks its index", r"Print k\ne i.", start)


# Integrals --------------------------------------------------------------------------------------


def read_integral(parser: Parser) -> tree.Node:
    """Read an integral up to its differential, or to the end of the product if it has none."""
    start = parser.start
    parser.take()
    low = parser.read_script("_") if parser.text == "_" else None
    high = parser.read_script("^") if parser.text == "^" else None
    if (low is None) != (high is None):
        raise parser.refuse("an integral with one limit only", place=start)
    opened = OpenIntegral(parser.depth)
    parser.integrals.append(opened)
    integrand = _read_integrand(parser, opened)
    parser.integrals.pop()
    _bind(parser, opened)
    return tree.Integration(integrand, opened.differential, low, high, start=start, end=parser.end)


def _read_integrand(parser: Parser, opened: OpenIntegral) -> tree.Node:
    """Read one product, or a sum that ends with the differential."""
    start = parser.start
    if is_differential(parser):
        read_differential(parser, opened)
        _refuse_factor_after(parser)
        return tree.Number("1", start=start, end=start)
    terms = [parser.read_term()]
    _end_with_differential(parser, opened)
    place, bound = parser.place, len(opened.running)
    while opened.differential is None and parser.text in parser.signs:
        terms.append(parser.read_term())
        _end_with_differential(parser, opened)
    if opened.differential is None:
        parser.place, terms = place, terms[:1]
        del opened.running[bound:]
    return parser.add_up(terms, start)


def _end_with_differential(parser: Parser, opened: OpenIntegral) -> None:
    if opened.differential is None and is_differential(parser):
        read_differential(parser, opened)
    if opened.differential is not None:
        _refuse_factor_after(parser)


def _refuse_factor_after(parser: Parser) -> None:
    opened = parser.integrals.pop()
    if not parser.ends_product():
        raise parser.refuse(
            "does this factor after the differential belong to the integrand?",
            "Print it before the differential, or brackets around the integral.",
        )
    parser.integrals.append(opened)


def is_over(parser: Parser) -> bool:
    """Return whether the product ends here because the integral around it does."""
    if not parser.integrals:
        return False
    opened = parser.integrals[-1]
    ended = opened.differential is not None and opened.depth == parser.depth
    return ended or is_differential(parser)


def is_differential(parser: Parser) -> bool:
    """Return whether a differential starts here: a d in an integral that begins no known name."""
    place = parser.place + (parser.text == r"\cdot")
    rest = parser.tokens[place:]
    follows = [token.text for token in rest[:2]]
    if not parser.integrals or follows[:1] != ["d"] or follows[1:] in (["_"], ["'"]):
        return False
    # For each token, whether it is a d printed upright as a differential, \mathrm{d}x.
    upright = [d.text == "d" != parser.source.latex[d.start : d.end] for d in rest]
    if upright[0]:
        return True
    match = parser.names.match(parser.tokens, place)
    if match and match.end == place + 1:
        if any(upright):
            return False
        if _is_needed(parser):
            return True
        raise parser.refuse(
            f"d within an integral: a differential, or {match.name.symbol}?",
            parser.remedies.scope.format("d"),
        )
    return match is None


def _is_needed(parser: Parser) -> bool:
    """Return whether the open integrals need every letter d up to the next relation sign."""
    after = takewhile(lambda token: token.text not in RELATIONS, parser.rest)
    left = sum(opened.differential is None for opened in parser.integrals)
    return sum(token.text == "d" for token in after) <= left


def read_differential(parser: Parser, opened: OpenIntegral) -> None:
    """Read d and the single factor after it as the differential."""
    parser.skip(r"\cdot")
    start = parser.take("d").start
    operand = parser.read_factor()
    if opened.differential is not None:
        raise parser.refuse("a second differential", place=start)
    opened.differential = operand


def read_numerator(parser: Parser) -> tree.Node:
    """Read the numerator of a fraction, which may contain the differentials of integrals."""
    start = parser.start
    alone = is_differential(parser)
    inside = tree.Number("1", start=start, end=start) if alone else parser.read_sum()
    for opened in reversed(parser.integrals):
        if is_differential(parser):
            read_differential(parser, opened)
    return inside


def _bind(parser: Parser, opened: OpenIntegral) -> None:
    """Pass letters that this integral does not bind to the enclosing one, or refuse them."""
    bound = opened.differential.text if isinstance(opened.differential, tree.Letter) else None
    free = [letter for letter in opened.running if letter.text != bound]
    if parser.integrals:
        parser.integrals[-1].running += free
    elif parser.collects:
        parser.collected += [letter.text for letter in free]
    elif free:
        printed = parser.source.latex[free[0].start : free[0].end]
        raise parser.refuse(
            f"{printed} is neither declared nor bound by the differential",
            parser.remedies.name.format(printed),
            free[0].start,
        )
