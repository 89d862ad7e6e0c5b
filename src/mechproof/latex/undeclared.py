"""Undeclared letters: refused, bound by an integral, or collected on request."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import sympy as sp

from mechproof.latex.characters import advise, is_digit, name_character
from mechproof.latex.latex_signs import SUFFIXES, Token, find_command, join
from mechproof.latex.left_scripts import LEFT, begins_letter
from mechproof.latex.name_table import INDEX, Name, find_brace, strip_braces
from mechproof.latex.printed_commands import ACCENTS, TEXT, UPRIGHT, VECTORS
from mechproof.latex.printed_functions import AMBIGUOUS
from mechproof.latex.printed_relations import RELATIONS
from mechproof.latex.several_equations import ARROWS, EQUIVALENCES
from mechproof.latex.tree import Letter, Node
from mechproof.latex.words import AND, ELSE, IF, LONGEST_ROW
from mechproof.record.unit_notation import is_unit

if TYPE_CHECKING:
    from mechproof.latex.parser import Parser

# Letters that readers interpret differently when they have no index.
UNSURE = {
    "e": r"Print \mathrm{e} for Euler's number. Otherwise:",
    "i": "The imaginary unit is not read. If it is a letter, such as a ratio:",
    "d": r"Print \frac{d}{dx}(…) for a derivative. Otherwise:",
}
# Signs that form one quantity with the next letter, or a product with it.
_INCREMENTS = (r"\Delta", r"\delta")
# Signs after which a d is a letter, not a differential.
_BEHIND = ("", "=", "+", "-", ")", "]", ",", "&", r"\\")
# Signs between factors, and between any operands.
_FACTORS = (r"\cdot", r"\times", "/")
_BETWEEN = ("+", "-", *_FACTORS)
# Units that, after a number, may just as well be letters.
_LETTERS = frozenset("ACFHKLSTVl")
_UNREAD = {
    **dict.fromkeys((r"\pm", r"\mp"), "It stands for two equations: print them one by one."),
    **dict.fromkeys((r"\lim", r"\to"), r"Print \lim_{x\to a}."),
    r"\partial": r"Print \frac{\partial …}{\partial x} with a letter x.",
    r"\nabla": "Give the derivative a name of its own.",
    r"\propto": "Print an equation with the factor of proportionality.",
    **dict.fromkeys(
        (r"\ll", r"\gg"), r"Leave it out next to \approx, where no sizes are compared."
    ),
    r"\leftarrow": "Leave out the arrow and what it points at.",
    "!": "Print n! or (…)!, and brackets around what is raised or follows.",
    **dict.fromkeys((r"\div", "÷"), r"Print \frac{…}{…}."),
    ":": r"Print \frac{…}{…} for a quotient; leave out what a colon introduces.",
    **dict.fromkeys(RELATIONS, "Enter the whole chain, with what comes before this sign."),
    **dict.fromkeys(
        ARROWS,
        r"Print the conclusion, and its condition after it: \text{ for }x>0.",
    ),
    **dict.fromkeys(
        EQUIVALENCES, r"Print one equation at a time, or \Rightarrow before one that follows."
    ),
    r"\mid": r"Print | or \left| for an absolute value.",
    **dict.fromkeys(VECTORS, "Vectors need their components: check these."),
}


def read_undeclared(parser: Parser) -> Node:
    """Collect a letter if that is requested, let an integral bind it, or refuse it."""
    text = parser.text
    if not text:
        raise parser.refuse("the print ends, but something must follow")
    if text == r"\dots":
        raise parser.refuse("dots in place of an earlier print", "Enter the whole chain.")
    if text[1:] in AMBIGUOUS:
        unclear, options = AMBIGUOUS[text[1:]]
        raise parser.refuse(
            f"{text[1:]} is not the same everywhere: state {unclear}",
            parser.remedies.function.format(text[1:]).replace("is …", f"is {options}"),
        )
    word = _upright_word(parser)
    _refuse_unit(parser, word)
    if not begins_letter(text) and not (word and parser.collects):
        remedy = parser.remedies.name.format(word) if word else _UNREAD.get(text, "")
        reason = f"{name_character(text)} has no meaning here"
        raise parser.refuse(reason, remedy or advise(text))
    is_unsure = _is_unsure(parser)
    if parser.collects and not is_unsure:
        return _collect(parser)
    if parser.integrals and text != "d" and not parser.collects:
        return _read_running(parser)
    printed = printed_name(parser, parser.place)
    begun = [latex for latex in parser.names.beginning(text) if latex != printed]
    near = f" (declared: {', '.join(begun[:4])})" if begun else ""
    hint = UNSURE[text] if is_unsure else _UNREAD.get(text, "") or _advise_rate(parser)
    index = _find_running_index(parser, parser.place, find_end(parser.tokens, parser.place))
    name = parser.remedies.family if index else parser.remedies.name
    remedy = " ".join(filter(None, (hint, name.format(printed, index))))
    raise parser.refuse(f"{printed} is not declared{near}", remedy)


def _advise_rate(parser: Parser) -> str:
    r"""Return how to declare \dot x as the rate of a declared letter that has none yet."""
    signs = [
        token.text for token in parser.tokens[parser.place : find_end(parser.tokens, parser.place)]
    ]
    if not signs[0].endswith("dot") or "}" not in signs:
        return ""
    close = signs.index("}")
    return advise_running(parser, parser.names.find(*signs[2:close], *signs[close + 1 :]), "t")


def advise_running(parser: Parser, name: Name | None, by: str) -> str:
    """Return how to declare that a letter depends on another one, "" if it already does."""
    is_free = name is not None and name.symbol not in parser.notation.moving
    return parser.remedies.rate.format(name.latex, by) if name and is_free else ""


def _refuse_unit(parser: Parser, word: str) -> None:
    """Refuse a unit after a number: it is not a factor of its own."""
    before = parser.tokens[parser.place - 1].text if parser.place else ""
    inside = word.partition("{")[2].strip("}")
    if inside and is_digit(before) and is_unit(inside) and inside not in _LETTERS:
        raise parser.refuse(
            f"{word} after a number: units are not read",
            "Print the number alone, in the unit of the sizes (mm, rad); 30^\\circ for degrees.",
        )


def _upright_word(parser: Parser) -> str:
    """Return the upright name that comes next, as it is printed, or ""."""
    token = parser.tokens[parser.place]
    command = find_command(parser.source.latex, token.start)
    if command not in (*UPRIGHT, *TEXT):
        return ""
    inside = token.text.partition("{")[2] or token.text
    word = inside.strip("\\} ")
    parts = word.split()
    is_name = word[:1].isalpha() and all(map(str.isalnum, parts))
    is_name &= token.text not in (AND, *IF, *ELSE) and (len(parts) == 1 or _is_operand(parser))
    kind = r"\text" if command in TEXT else r"\mathrm"
    return rf"{kind}{{{word}}}" if is_name else ""


def _is_operand(parser: Parser) -> bool:
    """Return whether words are used as a quantity, rather than to describe what is next to them.

    At the end they may name what is left out, or what is meant: "constant over time".
    """
    texts = ["", *(token.text for token in parser.tokens), ""]
    before, after = texts[parser.place], texts[parser.place + 2]
    if not after:
        return before in _FACTORS
    begins = before in ("", "{", "(", *_BETWEEN, *RELATIONS)
    return begins and after in ("}", ")", *_BETWEEN, *RELATIONS)


def _is_unsure(parser: Parser) -> bool:
    """Return whether a letter here may not be a quantity, and its context does not decide.

    In a row of letters from a onwards (`a & b & c & d`) it is one of them, and a d with nothing
    after it is not a differential.
    """
    text, place = parser.text, parser.place
    if text not in UNSURE or find_end(parser.tokens, place) > place + 1:
        return False
    texts = {token.text for token in parser.tokens}
    if all(chr(code) in texts for code in range(ord("a"), ord(text))):
        return False
    following = parser.tokens[place + 1].text if place + 1 < len(parser.tokens) else ""
    return text != "d" or following not in _BEHIND


def _read_running(parser: Parser) -> Letter:
    """Read an undeclared letter that the differential of an enclosing integral may bind."""
    letter = _read_plain(parser)
    if other := parser.names.find_alike(letter.symbol):
        raise parser.refuse(
            f"{letter.text} would be confused with {other}, which has the same name",
            "Print another letter for the bound variable.",
            letter.start,
        )
    parser.integrals[-1].running.append(letter)
    return letter


def _read_plain(parser: Parser) -> Letter:
    """Read a letter with its scripts and primes as a real symbol."""
    start, word = parser.start, _upright_word(parser)
    end = find_end(parser.tokens, parser.place)
    texts = [token.text for token in parser.tokens[parser.place : end]]
    _refuse_expression(parser, texts)
    latex = join([word or texts[0], *texts[1:]])
    parser.place = end
    return Letter(sp.Symbol(latex, real=True), latex, start=start, end=parser.end)


def _refuse_expression(parser: Parser, texts: list[str]) -> None:
    """Refuse a letter whose index contains a relation, or whose accent spans more than a name."""
    if not {"=", "<", ">", r"\le", r"\ge"}.isdisjoint(texts):
        raise parser.refuse(
            "a relation in an index: a sum, or a value at a place?",
            r"Print \sum for a sum, a value at a place with brackets or as a separate letter.",
        )
    first = next((n for n, text in enumerate(texts) if text in ACCENTS), len(texts))
    inside = texts[first + 2 : texts.index("}", first)] if first < len(texts) else []
    if any(not (is_digit(t) or begins_letter(t) or t in ("_", "{", *SUFFIXES)) for t in inside):
        printed = printed_name(parser, parser.place)
        raise parser.refuse(
            f"{printed}: an accent over an expression", parser.remedies.name.format(printed)
        )


def _collect(parser: Parser) -> Letter:
    """Collect an undeclared letter; with a bound index it is a member of a family."""
    place = parser.place
    letter = _read_plain(parser)
    if parser.text and letter.text in _INCREMENTS and begins_letter(parser.text):
        raise parser.refuse(
            f"{letter.text} before a letter: one quantity, or a product?",
            f"{parser.remedies.name} Print a dot for the product.".format(
                f"{letter.text} {printed_name(parser, parser.place)}"
            ),
            letter.start,
        )
    index = _find_running_index(parser, place, parser.place)
    if index:
        base, _, script = letter.text.partition("_")
        before = strip_braces(script).removesuffix(index)
        parser.collected.append(f"{base}_{{{before}{INDEX}}}" if before else f"{base}_{INDEX}")
    elif parser.integrals:
        parser.integrals[-1].running.append(letter)
    else:
        parser.collected.append(letter.text)
    return letter


def _find_running_index(parser: Parser, start: int, end: int) -> str:
    """Return the bound letters at the end of a letter's index: i of d_{bi}, none of d_{pitch}."""
    texts = [token.text for token in parser.tokens[start:end]]
    index = [text for text in texts[texts.index("_") + 2 :] if text != "}"] if "_" in texts else []
    own = next((n for n, text in enumerate(index) if text in parser.bound), len(index))
    is_word = len(index) > LONGEST_ROW and all(map(str.isalpha, index))
    return "" if is_word and not {*index[own:]} <= {*parser.bound} else "".join(index[own:])


def find_end(tokens: Sequence[Token], place: int) -> int:
    """Return the place after a letter with its accent, index and primes."""
    place = _find_base(tokens, place)
    end = find_brace(tokens, place + 2) + 1 if tokens[place].text in ACCENTS else place + 1
    while end < len(tokens) and tokens[end].text in ("_", *SUFFIXES):
        end = find_brace(tokens, end + 2) + 1 if tokens[end].text == "_" else end + 1
    # Nobody prints a power as x^{(i)}, or by a word.
    texts = [token.text for token in tokens[end : end + 6]]
    if [*texts[:3], *texts[4:]] == ["^", "{", "(", ")", "}"]:
        return end + 6
    is_word = [*texts[:2], *texts[3:4]] == ["^", "{", "}"] and texts[2].startswith(r"\text{")
    return end + 4 if is_word else end


def _find_base(tokens: Sequence[Token], place: int) -> int:
    """Return the place after the left scripts of a letter."""
    if tokens[place].text != LEFT:
        return place
    place += 1
    while place < len(tokens) and tokens[place].text in ("^", "_"):
        place = find_brace(tokens, place + 2) + 1
    return place


def printed_name(parser: Parser, place: int) -> str:
    """Return the print of the letter at a place, with its index and primes."""
    tokens = parser.tokens[place : find_end(parser.tokens, place)]
    # Primes that share braces with a power have no place of their own in the print.
    hidden = (t.text for t in tokens if t.text in SUFFIXES and t.start == t.end)
    return parser.source.latex[tokens[0].start : tokens[-1].end] + "".join(hidden)
