r"""Letters that count, as in n!, \sum_{k=1}^n, 1+\dots+n, \frac{d^n}{dx^n}, a\bmod n."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from itertools import accumulate, takewhile

from mechproof.latex import modulo
from mechproof.latex.latex_signs import find_close
from mechproof.latex.left_scripts import begins_letter
from mechproof.latex.printed_relations import RELATIONS
from mechproof.latex.tokens import list_signs

# Letters that number the last term, after dots.
_LAST = ("n", "N", "m", "k")
# Remainders modulo 1, a sign of numbers that are not whole.
_BY_ONE = re.compile(rf"(?:{'|'.join(map(re.escape, modulo.SIGNS))})\{{?1(?!\d)")
# Things that come in whole numbers only: no turns, revolutions or cycles, and no virtual teeth.
_THINGS = (
    r"(?:(?:equal|identical|cylindrical|round|small|steel)\s+)?"
    r"(?:teeth|pins|planets|planet gears|rollers|balls|cylinders|pistons|blades|lobes|bolts|rivets"
    r"|discs|spokes)\b"
)
_LETTER = r"\$\s*(\\?[A-Za-z]+(?:_(?:\w|\{\w+\}))?)\s*(?:=[^$=]{1,30})?\$"
_COUNTED = re.compile(
    rf"{_LETTER}\s+{_THINGS}|\bnumber\s+of\s+{_THINGS}\s+{_LETTER}"
    rf"|{_LETTER}\s+is\s+the\s+number\s+of\s+{_THINGS}"
)
_VIRTUAL = re.compile(
    r"\b(?:virtual|fictitious|negative)\b"
    r"|\b(?:equivalent|ideal|theoretical|mean|average|effective)\s+"
    rf"(?:\w+\s+){{0,2}}(?:{_THINGS}|numbers?|tooth|gears?|wheels?|counts?)"
)
_ARGUMENT = r"\\(?:sin|cos|tan|cot)\s*(?:\d|\\pi|\s)*"


def find_counts(prints: Iterable[str], said: Iterable[str]) -> tuple[str, ...]:
    r"""Return the letters `said` to count, and those of factorials, orders and limits of sums.

    The letter n is also found in \sum_{k=1}^{n-1}, in \dots+n^2, in the index of \dots+kx_n, and in
    (-1)^n.
    """
    found = dict.fromkeys(said)
    for texts in map(list_signs, prints):
        for place, text in enumerate(texts):
            if text in (r"\sum", r"\prod"):
                found |= dict.fromkeys(_letters_of_limit(texts[place + 1 :]))
            if text == "!":
                found |= dict.fromkeys(_letters_of_factorial(texts[:place]))
            if texts[place : place + 5] == ["(", "-", "1", ")", "^"]:
                after = texts[place + 5 : place + 5 + find_close(texts[place + 5 :])]
                found |= dict.fromkeys(sign for sign in after if sign in _LAST)
            if text == r"\dots":
                found |= dict.fromkeys(_letters_of_last(texts[place + 1 :]))
            if texts[place : place + 4] == ["{", "d", "^", "{"]:
                found |= dict.fromkeys(_letters_of_order(texts[place + 4 :]))
            if text in modulo.SIGNS:
                found |= dict.fromkeys(_letters_of_congruence(texts))
            if text == r"\binom":
                found |= dict.fromkeys(_letters_of_binomial(texts[place + 1 :]))
    return tuple(found)


def find_counted(text: str, prints: Iterable[str]) -> Iterator[str]:
    r"""Yield letters that the text says count things, N of "N pins", and that are in \cos N\varphi.

    Elsewhere it does not matter whether a letter counts. Nothing is yielded for a text that
    mentions negative or virtual numbers.
    """
    displays = [*prints]
    for match in () if _VIRTUAL.search(text) else _COUNTED.finditer(text):
        letter = next(filter(None, match.groups()))
        argument = re.compile(rf"{_ARGUMENT}{re.escape(letter)}(?![A-Za-z_])")
        if any(map(argument.search, displays)):
            yield letter


def _letters_of_last(texts: list[str]) -> Iterator[str]:
    """Yield the letters of a last term, or of its index if it has one."""
    after = [*takewhile(lambda sign: sign not in RELATIONS, texts)]
    inside = list(accumulate(after, _step_index, initial=False))[1:]
    indices = [sign for sign, is_index in zip(after, inside, strict=True) if is_index]
    yield from (sign for sign in (indices or after) if sign in _LAST)


def _step_index(is_inside: bool, sign: str) -> bool:
    """Return whether the sign is inside an index, or begins one."""
    return sign == "_" or (is_inside and sign != "}")


def _letters_of_factorial(texts: list[str]) -> Iterator[str]:
    """Yield the letter in front of the sign, or those of a plain sum in brackets there."""
    start = len(texts) - 1
    if texts[-1:] == [")"] and "(" in texts:
        start = len(texts) - texts[::-1].index("(")
    inside = texts[start:]
    if all(text.isalnum() or text in ("+", "-", ")") for text in inside):
        yield from (text for text in inside if text.isalpha())


def _letters_of_binomial(texts: list[str]) -> Iterator[str]:
    """Yield the letters that are alone or in a plain sum in either of two groups of braces."""
    for _ in range(2):
        close = texts.index("}") if "}" in texts else 0
        yield from _letters_of_factorial(["(", *texts[1:close], ")"])
        texts = texts[close + 1 :]


def _letters_of_order(texts: list[str]) -> Iterator[str]:
    """Yield the letters of the order of a derivative, if that is a plain sum."""
    yield from _letters_of_factorial(["(", *takewhile(lambda sign: sign != "}", texts), ")"])


def _letters_of_congruence(texts: list[str]) -> Iterator[str]:
    """Yield all letters of a print with remainders, except remainders of turns or modulo 1."""
    if r"\pi" in texts or _BY_ONE.search("".join(texts)):
        return
    for place, text in enumerate(texts):
        if begins_letter(text) and text not in modulo.SIGNS and "_" not in texts[place - 2 : place]:
            after = texts[place + 1 :]
            index = after[: after.index("}") + 1] if after[:1] == ["_"] else []
            yield "".join((text, *index))


def _letters_of_limit(texts: list[str]) -> Iterator[str]:
    """Yield the letters of a lower limit and of the upper one after it, if they are plain sums."""
    low = texts.index("}") + 1 if texts[:1] == ["_"] and "}" in texts else 0
    if texts[low : low + 2] != ["^", "{"] or "}" not in texts[low:]:
        return
    begin = texts[:low].index("=") + 1 if "=" in texts[:low] else low
    for limit in (texts[begin : low - 1], texts[low + 2 : texts.index("}", low)]):
        if all(text.isalnum() or text in ("+", "-") for text in limit):
            yield from (text for text in limit if text.isalpha())
