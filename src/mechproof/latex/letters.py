"""Letters: declared names, bound letters and constants."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import takewhile
from typing import TYPE_CHECKING

import sympy as sp

from mechproof.latex import places, side_conditions, undeclared
from mechproof.latex.characters import is_digit
from mechproof.latex.errors import ReadingError
from mechproof.latex.latex_signs import STAR
from mechproof.latex.name_table import Match
from mechproof.latex.numerals import read_number
from mechproof.latex.printed_functions import CONSTANTS
from mechproof.latex.summands import TIME, is_no_argument
from mechproof.latex.tree import (
    Add,
    Bracket,
    Constant,
    Derivation,
    Entries,
    Letter,
    Node,
    Number,
    Power,
    Transposed,
    shows_matrix,
    walk,
)
from mechproof.latex.words import ITALICS, LONGEST_ROW
from mechproof.record import NUMBER

if TYPE_CHECKING:
    from mechproof.latex.parser import Parser

_WORD = re.compile(r"[A-Za-z][a-z]+")
_PARTS = {"_": "an index", "'": "a prime", STAR: "a star"}


_SCRIPT_TYPES = (r"\mathcal", r"\mathscr", r"\mathfrak")


def check_bracket_after(parser: Parser, left: Node) -> None:
    """Refuse a round bracket after a letter, unless the letter is known to be a factor."""
    letter = left.base if isinstance(left, Power) else left
    letter = letter.of if isinstance(letter, Transposed) else letter
    if isinstance(letter, Derivation) and parser.text == "(":
        _refuse_place(parser)
    if not isinstance(letter, Letter) or letter.text in parser.bound:
        return
    # Script letters are just as often operators: \mathcal L\{f\}.
    brackets = ("(", "[") if letter.text.startswith(_SCRIPT_TYPES) else ("(",)
    if parser.text not in brackets:
        return
    place = parser.place
    is_matrix = isinstance(letter.symbol, sp.MatrixSymbol)
    if letter.text in parser.factors or (is_matrix and not _may_be_called(parser)):
        return
    if place not in parser.multiplied:
        # Remembered: otherwise each nested bracket would be read twice for every enclosing one.
        parser.multiplied[place] = _multiplies(parser, letter)
    if not parser.multiplied[place]:
        printed = parser.source.latex[letter.start : letter.end]
        raise parser.refuse(
            f"a bracket after {printed}: a factor, or the argument of a function?",
            parser.remedies.bracket.format(printed),
        )


def _refuse_place(parser: Parser) -> None:
    r"""Refuse \frac{dx}{dt}(t_0), which may be the value at t_0, or a product."""
    bracket, _ = _look_at_bracket(parser)
    if isinstance(bracket, Bracket) and isinstance(bracket.inside, Letter | Number):
        raise parser.refuse(
            "a bracket after a derivative: a factor, or the place where its value is meant?",
            r"Print \left.…\right|_{x=x_0} for the place, \cdot before a factor.",
        )


def _multiplies(parser: Parser, letter: Letter) -> bool:
    r"""Return whether a bracket multiplies the letter before it: s(s-a), r(1-\cos\varphi), k(a+b).

    It does if the letter itself appears in the bracket, or if units decide: the letter depends on
    nothing but time, and the bracket is a sum that cannot be its argument.
    """
    bracket, _ = _look_at_bracket(parser)
    inside = bracket.inside if isinstance(bracket, Bracket) else None
    if inside and any(isinstance(x, Letter) and x.text == letter.text for x in walk(inside)):
        return True
    moving, known = parser.notation.moving, parser.notation.dimensions
    by = {by for one, (by, rates) in moving.items() if letter.symbol in (one, *rates)}
    if letter.symbol not in known or any(known.get(one) != TIME for one in by):
        return False
    is_sum = isinstance(inside, Add) and is_no_argument(inside, parser.notation, moves=bool(by))
    # A bracket that cannot be read is refused later, at its own place.
    return bracket is None or is_sum


def read_argument_after(parser: Parser, raised: Power | Transposed) -> Node:
    r"""Read a declared name's bracket after its power: R^T(\theta) is R(\theta)^T.

    A power such as f^{-1}(x) is returned unchanged, as it may be an inverse function.
    """
    base = raised.of if isinstance(raised, Transposed) else raised.base
    exponent = raised.exponent if isinstance(raised, Power) else None
    if not isinstance(base, Letter) or not (shows_matrix(base) or isinstance(exponent, Number)):
        return raised
    for signs in parser.names.list_arguments(base.symbol):
        if tuple(token.text for token in parser.rest[: len(signs)]) == signs:
            parser.place += len(signs)
            return raised
    if not (places.is_value(parser, base) or _is_called(parser, base)):
        return raised
    value = places.read_value(parser, base)
    if isinstance(raised, Transposed):
        return replace(raised, of=value, end=parser.end)
    return replace(raised, base=value, end=parser.end)


def _may_be_called(parser: Parser) -> bool:
    r"""Return whether a bracket after a matrix may be its argument: R(2\theta), not A(x+y)."""
    bracket, after = _look_at_bracket(parser)
    if not isinstance(bracket, Bracket):
        # A column is printed as (x,y)^T.
        return isinstance(bracket, Entries) and after != "^"
    inside = bracket.inside
    is_product = isinstance(inside, Add) and is_no_argument(inside, parser.notation, moves=False)
    return isinstance(inside, Letter) or not (is_product or any(map(shows_matrix, walk(inside))))


def _look_at_bracket(parser: Parser) -> tuple[Node | None, str]:
    """Return the bracket here and the sign after it without moving on; (None, "") if unreadable."""
    place, count = parser.place, len(parser.collected)
    try:
        return parser.read_atom(), parser.text
    except ReadingError:
        return None, ""
    finally:
        parser.place = place
        del parser.collected[count:]


def read_letter(parser: Parser, match: Match | None) -> Node:
    """Read the longest declared name, a bound letter, or a constant."""
    start, place = parser.start, parser.place
    unit = parser.notation.imaginary
    if unit and parser.text in (unit, "e") and match is None:
        value = sp.E if parser.text == "e" else sp.I
        return Constant(value, parser.take().text, start=start, end=parser.end)
    if match is None or match.end == place + 1:
        _refuse_italics(parser)
    if parser.text in parser.bound and (match is None or match.end == place + 1):
        return _read_bound(parser, match)
    if match:
        return _read_name(parser, match)
    is_indexed = [token.text for token in parser.rest[:2]] == [r"\pi", "_"]
    if parser.text in CONSTANTS and not is_indexed:
        token = parser.take()
        shown = token.text.removeprefix(r"\mathrm").strip("\\{}")
        return Constant(CONSTANTS[token.text], shown, start=start, end=token.end)
    return undeclared.read_undeclared(parser)


def _refuse_italics(parser: Parser) -> None:
    """Refuse adjacent letters that look like a word or a function set in italics."""
    found = _WORD.match(parser.source.latex, parser.start)
    if found is None or parser.text != found[0][0]:
        return
    # The letters of \frac lg are separate arguments, not a word.
    tokens = zip(parser.tokens[parser.place :], found[0], strict=False)
    word = "".join(letter for _, letter in takewhile(lambda one: one[0].text == one[1], tokens))
    lengths = range(len(word), 1, -1)
    begun = (word[:n] for n in lengths if rf"\{word[:n]}" in parser.functions)
    name = "" if word in ITALICS else next(begun, "")
    if name:
        raise parser.refuse(
            f"{name} in italics: a function or a product?",
            rf"Print \{name}, or \cdot between the letters. "
            + parser.remedies.function.format(name).replace(rf"\{name}", name),
        )
    # A product names no factor twice, but an integral may print dxdydz.
    is_spelled = len(word) > LONGEST_ROW and len({*word}) < len(word)
    if word in ITALICS or (is_spelled and not (parser.integrals and "d" in word)):
        raise parser.refuse(
            f"{word} in italics: a word or a product?",
            rf"Print \text{{ {word} }}, or \cdot between the letters.",
        )


def _read_bound(parser: Parser, match: Match | None) -> Node:
    start, place = parser.start, parser.place
    token = parser.take()
    if match:
        raise parser.refuse(
            f"{token.text} is bound here, but also declared as {match.name.symbol}",
            parser.remedies.scope.format(token.text),
            start,
        )
    _refuse_continuation(parser, token.text, place)
    return Letter(index_symbol(parser, token.text), token.text, start=start, end=token.end)


def index_symbol(parser: Parser, letter: str) -> sp.Symbol:
    """Return the symbol of an index letter."""
    declared = (s for s in parser.notation.indices if s.name == letter)
    return next(declared, sp.Symbol(letter.strip("\\"), integer=True))


def _read_name(parser: Parser, match: Match) -> Node:
    start, place = parser.start, parser.place
    _refuse_running_index(parser, match)
    indices = tuple(i for span in match.indices for i in _read_indices(parser, *span))
    parser.place = match.end
    latex = parser.source.latex[start : parser.end]
    _refuse_continuation(parser, latex, place)
    text = "".join([token.text for token in parser.tokens[place : match.end]])
    letter = Letter(match.name.symbol, text, indices, start=start, end=parser.end)
    if places.is_value(parser, letter) or _is_called(parser, letter):
        return places.read_value(parser, letter)
    other = parser.names.longer(match.name, "(") if parser.text == "(" else None
    is_rate = any(letter.symbol in rates for _, rates in parser.notation.moving.values())
    is_factor = letter.text in parser.factors or _is_of_others(parser, letter)
    # A relation in brackets after a wide gap is a condition.
    gap = parser.source.latex[letter.end : parser.start]
    is_factor |= "quad" in gap and side_conditions.is_bracketed(parser)
    if other and not is_rate and not is_factor:
        raise parser.refuse(
            f"{other.latex} is declared, but this bracket differs: an argument or a factor?",
            parser.remedies.bracket.format(latex),
        )
    return letter


def _is_called(parser: Parser, letter: Letter) -> bool:
    """Return whether the bracket after a letter that always has one contains its argument.

    It does not if the letter depends on time and the bracket is a sum without time.
    """
    if letter.text not in parser.notation.bracketed or letter.text in parser.factors:
        return False
    running = places.find_running(parser, letter) if parser.text == "(" else None
    bracket, _ = _look_at_bracket(parser) if running else (None, "")
    inside = bracket.inside if isinstance(bracket, Bracket) else None
    if running is None or inside is None:
        return False
    if isinstance(inside, Add):
        met = {node.text for node in walk(inside) if isinstance(node, Letter)}
        is_amount = running.text == "t" and running.text not in met
        if is_amount or is_no_argument(inside, parser.notation, moves=False):
            return False
    return not _is_of_others(parser, letter)


def _is_of_others(parser: Parser, letter: Letter) -> bool:
    """Return whether no letter in a bracket has the dimension of what the letter depends on."""
    moving, known = parser.notation.moving, parser.notation.dimensions
    by = moving[letter.symbol][0] if letter.symbol in moving else None
    texts = [token.text for token in parser.tokens[parser.place :]]
    if by not in known or ")" not in texts:
        return False
    places = range(parser.place + 1, parser.place + texts.index(")"))
    names = [match.name for place in places if (match := parser.names.match(parser.tokens, place))]
    symbols = {name.symbol for name in names}
    return bool(symbols) and all(known.get(s) not in (None, NUMBER, known[by]) for s in symbols)


def _refuse_running_index(parser: Parser, match: Match) -> None:
    """Refuse a single quantity whose index runs here: it should be declared as a family."""
    signs = match.name.signs
    script = signs[signs.index("_") + 2 :] if "_" in signs else ()
    letters = script[: script.index("}")] if script else ()
    if letters and all(letter in parser.bound for letter in letters):
        raise parser.refuse(
            f"{match.name.latex} is declared as one quantity, but its index runs here",
            parser.remedies.family.format(match.name.latex, "".join(letters)),
        )


def _refuse_continuation(parser: Parser, latex: str, place: int) -> None:
    if parser.text in _PARTS:
        name = parser.names.find(*(t.text for t in parser.tokens[place : parser.place]))
        rate = undeclared.advise_running(parser, name, "…") if parser.text == "'" else ""
        declared = parser.remedies.name.format(undeclared.printed_name(parser, place))
        raise parser.refuse(
            f"{latex} is declared, but not with {_PARTS[parser.text]}",
            " ".join(filter(None, (rate, declared))),
        )


def _read_indices(parser: Parser, start: int, end: int) -> list[Node]:
    """Read the indices of a family: single letters and numbers, or one expression."""
    parser.place = start
    if any(token.text in ("+", "-") for token in parser.tokens[start:end]):
        return [_read_index_sum(parser, end)]
    found: list[Node] = []
    while parser.place < end:
        found.append(read_number(parser) if is_digit(parser.text) else _read_index(parser))
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
