r"""Scripts to the left of a letter, `{}^A_B R`: where they are, and what they belong to.

All their spellings (`{}^A_BR`, `{^A_B}R`, `{^A_BR}`, `{ }_{B}^{A}R`, `R\ ^BP`) become the sign
`LEFT` followed by the scripts, the upper one first, in front of the letter.
"""

from __future__ import annotations

from collections.abc import Sequence

from mechproof.latex.characters import GREEK, is_letter
from mechproof.latex.printed_commands import ACCENTS, TEXT, UPRIGHT
from mechproof.latex.printed_relations import RELATIONS

LEFT = "{}"
_SCRIPTS = ("^", "_")
# Signs after which a script has no base to its left.
_OPERATORS = (
    *(*RELATIONS, "+", "-", r"\pm", r"\mp", "/"),
    *(r"\cdot", r"\times", r"\to", ",", ";", "&", r"\\", "(", "[", r"\lvert", ":"),
)


def begins_letter(text: str) -> bool:
    """Return whether a sign begins a name, including an accent or left scripts."""
    return is_letter(text) or text[1:] in GREEK or text in (*ACCENTS, LEFT)


def stands_alone(before: Sequence[str]) -> bool:
    """Return whether these signs do not end with anything that could carry a script."""
    return not before or before[-1] in _OPERATORS or before[-1].startswith(r"\begin{")


def skip_empty(texts: Sequence[str], place: int) -> int:
    """Return the place after any empty pairs of braces."""
    while list(texts[place : place + 2]) == ["{", "}"]:
        place += 2
    return place


def find_base(texts: Sequence[str], place: int) -> tuple[int, list[str]]:
    """Return the place after consecutive scripts, and the signs of the scripts."""
    inside: list[str] = []
    while texts[place : place + 1] and texts[place] in _SCRIPTS:
        end = _find_end(texts, place + 1)
        inside += [texts[place], *texts[place + 1 : end]]
        place = skip_empty(texts, end)
    return place, inside


def _find_end(texts: Sequence[str], place: int) -> int:
    depth = 0
    for end in range(place, len(texts)):
        depth += {"{": 1, "}": -1}.get(texts[end], 0)
        if depth <= 0:
            return end + 1
    return len(texts)


def may_begin(text: str) -> bool:
    """Return whether a sign may begin a letter, before the signs are normalised."""
    return begins_letter(text) or text in (*UPRIGHT, *TEXT, "{")


def is_power(inside: Sequence[str]) -> bool:
    """Return whether a single script may belong to the base before it, like a number or a T."""
    marks = sum(text in _SCRIPTS for text in inside)
    plain = [text for text in inside if text not in ("{", "}", *_SCRIPTS)]
    # Nobody prints a power of zero or one.
    is_trivial = inside[0] == "^" and plain in (["0"], ["1"])
    is_letter_alone = plain != ["T"] and any(map(begins_letter, plain))
    return marks == 1 and not (is_trivial or is_letter_alone)
