"""Letters: declared names, bound letters, constants, and what is neither."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import sympy as sp

from mechproof.latex.characters import advise, is_digit, is_letter, name_character
from mechproof.latex.functions import AMBIGUOUS, CONSTANTS
from mechproof.latex.names import INDEX, Match, find_brace
from mechproof.latex.numerals import read_number
from mechproof.latex.tokens import ACCENTS
from mechproof.latex.tree import Constant, Letter, Node, Power
from mechproof.latex.words import ITALICS

if TYPE_CHECKING:
    from mechproof.latex.parser import Parser

_WORD = re.compile(r"[a-z]{2,}")


# Letters that not everybody reads alike, where they stand without index.
UNSURE = {
    "e": r"Print \mathrm{e} for Euler's number.",
    "i": "The imaginary unit is not read.",
    "d": r"Print \frac{d}{dx}(…) for a derivative.",
}
# Before another letter they make one quantity of it, or a product.
_INCREMENTS = (r"\Delta", r"\delta")
_UNREAD = {
    **dict.fromkeys((r"\pm", r"\mp"), "It says two equations: print one after the other."),
    **dict.fromkeys((r"\lim", r"\to"), r"Print \lim_{x\to a}."),
    **dict.fromkeys((r"\partial", r"\nabla"), "A derivative needs a name of its own."),
    "!": "Print n! or (…)!, and brackets around what is raised or follows.",
    r"\binom": r"Print factorials, \frac{n!}{k!(n-k)!}.",
    **dict.fromkeys((":", r"\div", "÷"), r"Print \frac{…}{…}."),
    **dict.fromkeys(
        (r"\Rightarrow", r"\implies", r"\iff", r"\Leftrightarrow"),
        r"Print the conclusion, and its condition behind it: \text{ for }x>0.",
    ),
    **dict.fromkeys((r"\mid", r"\Vert", r"\|"), r"Print | or \left| for an absolute value."),
    **dict.fromkeys((r"\vec", r"\mathbf", r"\bm"), "Vectors need their components: check these."),
}
_UPRIGHT = r"\mathrm{"
GREEK = frozenset(
    (
        *("alpha", "beta", "gamma", "delta", "epsilon", "varepsilon", "zeta", "eta", "theta"),
        *("vartheta", "iota", "kappa", "varkappa", "lambda", "mu", "nu", "xi", "pi", "varpi"),
        *("rho", "varrho", "sigma", "varsigma", "tau", "upsilon", "phi", "varphi", "chi", "psi"),
        *("omega", "Gamma", "Delta", "Theta", "Lambda", "Xi", "Pi", "Sigma", "Upsilon", "Phi"),
        *("Psi", "Omega", "ell"),
    )
)


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
            parser.remedies.bracket.format(printed),
        )


def read_letter(parser: Parser, match: Match | None) -> Node:
    """Read the longest declared name, a bound letter, or a constant."""
    start, place = parser.start, parser.place
    if match is None or match.end == place + 1:
        _refuse_italics(parser)
    if parser.text in parser.bound and (match is None or match.end == place + 1):
        return _read_bound(parser, match)
    if match:
        return _read_name(parser, match)
    if parser.text in CONSTANTS:
        token = parser.take()
        return Constant(CONSTANTS[token.text], token.text.strip("\\"), start=start, end=token.end)
    return _read_undeclared(parser)


def _refuse_italics(parser: Parser) -> None:
    """Refuse letters side by side that begin like a function."""
    word = _WORD.match(parser.source.latex, parser.start)
    if word is None or parser.text != word[0][0]:
        return
    if word[0] in ITALICS:
        raise parser.refuse(
            f"{word[0]} in italics: a word or a product?",
            rf"Print \text{{ {word[0]} }}, or \cdot between the letters.",
        )
    lengths = range(len(word[0]), 1, -1)
    begun = (word[0][:n] for n in lengths if rf"\{word[0][:n]}" in parser.functions)
    if name := next(begun, ""):
        raise parser.refuse(
            f"{name} in italics: a function or a product?",
            rf"Print \{name}, or \cdot between the letters.",
        )


def _read_bound(parser: Parser, match: Match | None) -> Node:
    start, place = parser.start, parser.place
    token = parser.take()
    if match:
        raise parser.refuse(
            f"{token.text} is bound here and declared as {match.name.symbol}",
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
    if parser.text == "(" and (other := parser.names.longer(match.name, "(")):
        raise parser.refuse(
            f"{other.latex} is a declared name, this is another: an argument or a factor?",
            parser.remedies.name.format(f"{latex}(…)"),
        )
    text = "".join(token.text for token in parser.tokens[place : match.end])
    return Letter(match.name.symbol, text, indices, start=start, end=parser.end)


def _refuse_running_index(parser: Parser, match: Match) -> None:
    """Refuse one quantity with an index that runs here: it is a family."""
    signs = match.name.signs
    script = signs[signs.index("_") + 2 :] if "_" in signs else ()
    letters = script[: script.index("}")] if script else ()
    if letters and all(letter in parser.bound for letter in letters):
        raise parser.refuse(
            f"{match.name.latex} is declared as one quantity, but its index runs here",
            parser.remedies.family.format(match.name.latex),
        )


def _refuse_continuation(parser: Parser, latex: str, place: int) -> None:
    if parser.text in ("_", "'"):
        part = "an index" if parser.text == "_" else "a prime"
        raise parser.refuse(
            f"{latex} is declared, but not with {part}",
            parser.remedies.name.format(_printed_name(parser, place)),
        )


def _read_indices(parser: Parser, start: int, end: int) -> list[Node]:
    """Read the indices of a family: letters one by one, or one expression."""
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


def _read_undeclared(parser: Parser) -> Node:
    text = parser.text
    if not text:
        raise parser.refuse("the print ends, but something must follow")
    if text == r"\dots":
        raise parser.refuse("dots for what was printed before", "Enter the chain as a whole.")
    if text[1:] in AMBIGUOUS:
        raise parser.refuse(
            f"{text[1:]} is not the same everywhere: {AMBIGUOUS[text[1:]]} must be said",
            parser.remedies.function.format(text[1:]),
        )
    if not _begins_letter(text):
        is_upright = text.startswith(_UPRIGHT)
        remedy = parser.remedies.name.format(text) if is_upright else _UNREAD.get(text, "")
        reason = f"{name_character(text)} has no meaning here"
        raise parser.refuse(reason, remedy or advise(text))
    printed = _printed_name(parser, parser.place)
    is_unsure = text in UNSURE and _find_end(parser, parser.place) == parser.place + 1
    if parser.collects and text != r"\vec" and not is_unsure:
        return _collect(parser)
    if parser.integrals and text != "d" and not parser.collects:
        return _read_running(parser)
    begun = [latex for latex in parser.names.beginning(text) if latex != printed]
    near = f" (declared are {', '.join(begun[:4])})" if begun else ""
    hint = UNSURE[text] if is_unsure else _UNREAD.get(text, "")
    remedy = " ".join(filter(None, (hint, parser.remedies.name.format(printed))))
    raise parser.refuse(f"{printed} is not declared{near}", remedy)


def _read_running(parser: Parser) -> Letter:
    """Read an undeclared letter that the differential of an integral around it may bind."""
    letter = _read_plain(parser)
    if other := parser.names.symbols.get(str(letter.symbol), ""):
        raise parser.refuse(
            f"{letter.text} would be taken for {other}, which has its name",
            "Print another letter for what is bound.",
            letter.start,
        )
    parser.integrals[-1].running.append(letter)
    return letter


def _read_plain(parser: Parser) -> Letter:
    """Read a letter with its index and primes as a real symbol."""
    start = parser.start
    end = _find_end(parser, parser.place)
    texts = [token.text for token in parser.tokens[parser.place : end]]
    _refuse_expression(parser, texts)
    latex = "".join(texts)
    parser.place = end
    name = re.sub(r"[\\{}\s]", "", latex)
    return Letter(sp.Symbol(name, real=True), latex, start=start, end=parser.end)


def _refuse_expression(parser: Parser, texts: list[str]) -> None:
    """Refuse a letter whose index says a relation, or whose accent spans more than a name."""
    if not {"=", "<", ">", r"\le", r"\ge"}.isdisjoint(texts):
        raise parser.refuse(
            "an index with a relation in it: a sum, or a value at a place?",
            r"Print \sum for a sum, a value at a place with brackets or as a letter of its own.",
        )
    is_accent = texts[0] in ACCENTS
    inside = texts[2 : texts.index("}")] if is_accent else []
    if any(not (is_digit(t) or _begins_letter(t) or t in ("_", "{", "'")) for t in inside):
        printed = _printed_name(parser, parser.place)
        raise parser.refuse(
            f"{printed}: an accent over an expression", parser.remedies.name.format(printed)
        )


def _collect(parser: Parser) -> Letter:
    """Note a letter that nobody declared; with a bound index it is one of a family."""
    place = parser.place
    letter = _read_plain(parser)
    if parser.text and letter.text in _INCREMENTS and _begins_letter(parser.text):
        raise parser.refuse(
            f"{letter.text} before a letter: one quantity, or a product?",
            f"{parser.remedies.name} Print a dot for the product.".format(
                f"{letter.text} {_printed_name(parser, parser.place)}"
            ),
            letter.start,
        )
    base, _, index = letter.text.partition("_")
    signs = {token.text for token in parser.tokens[place : parser.place]}
    if index and signs & set(parser.bound):
        parser.collected.append(f"{base}_{INDEX}")
    elif parser.integrals:
        parser.integrals[-1].running.append(letter)
    else:
        parser.collected.append(letter.text)
    return letter


def _begins_letter(text: str) -> bool:
    return is_letter(text) or text[1:] in GREEK or text in ACCENTS


def _find_end(parser: Parser, place: int) -> int:
    """Return the place behind a letter with its accent, index and primes."""
    tokens = parser.tokens
    end = find_brace(tokens, place + 2) + 1 if tokens[place].text in ACCENTS else place + 1
    while end < len(tokens) and tokens[end].text in ("_", "'"):
        end = find_brace(tokens, end + 2) + 1 if tokens[end].text == "_" else end + 1
    return end


def _printed_name(parser: Parser, place: int) -> str:
    """Return how the letter at a place is printed, with its index and primes."""
    last = parser.tokens[_find_end(parser, place) - 1]
    return parser.source.latex[parser.tokens[place].start : last.end]
