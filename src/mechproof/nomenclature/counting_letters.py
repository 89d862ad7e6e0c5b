r"""Letters that count, by where they stand: n!, \sum_{k=1}^n, 1+\dots+n."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import accumulate, takewhile

from mechproof.latex.tokens import list_signs

# The letters of last terms, behind dots.
_LAST = ("n", "N", "m", "k")
_RELATIONS = ("=", "<", ">", r"\le", r"\ge")


def find_counts(prints: Iterable[str], said: Iterable[str]) -> tuple[str, ...]:
    r"""Return what is said to count, the letters of n! and those up to which sums go.

    It is n also in \sum_{k=1}^{n-1}, in \dots+n^2, and alone in \dots+kx_n.
    """
    found = dict.fromkeys(said)
    for texts in map(list_signs, prints):
        for place, text in enumerate(texts):
            if text in (r"\sum", r"\prod"):
                found |= dict.fromkeys(_letters_of_limit(texts[place + 1 :]))
            if text == "!":
                found |= dict.fromkeys(_letters_of_factorial(texts[:place]))
            if text == r"\dots":
                found |= dict.fromkeys(_letters_of_last(texts[place + 1 :]))
            if text == r"\binom":
                found |= dict.fromkeys(_letters_of_binomial(texts[place + 1 :]))
    return tuple(found)


def _letters_of_last(texts: list[str]) -> Iterator[str]:
    """Yield the letters of a last term, those of its index if it has one."""
    behind = [*takewhile(lambda sign: sign not in _RELATIONS, texts)]
    inside = list(accumulate(behind, _step_index, initial=False))[1:]
    indices = [sign for sign, is_index in zip(behind, inside, strict=True) if is_index]
    yield from (sign for sign in (indices or behind) if sign in _LAST)


def _step_index(is_inside: bool, sign: str) -> bool:
    """Return whether an index goes on or begins."""
    return sign == "_" or (is_inside and sign != "}")


def _letters_of_factorial(texts: list[str]) -> Iterator[str]:
    """Yield the letter before the sign, or those of the plain sum in the bracket before it."""
    start = len(texts) - 1
    if texts[-1:] == [")"] and "(" in texts:
        start = len(texts) - texts[::-1].index("(")
    inside = texts[start:]
    if all(text.isalnum() or text in ("+", "-", ")") for text in inside):
        yield from (text for text in inside if text.isalpha())


def _letters_of_binomial(texts: list[str]) -> Iterator[str]:
    """Yield the letters that stand alone or in a plain sum in either of two groups of braces."""
    for _ in range(2):
        close = texts.index("}") if "}" in texts else 0
        yield from _letters_of_factorial(["(", *texts[1:close], ")"])
        texts = texts[close + 1 :]


def _letters_of_limit(texts: list[str]) -> Iterator[str]:
    """Yield the letters of the upper limit that follows a lower one, if it is a plain sum."""
    low = texts.index("}") + 1 if texts[:1] == ["_"] and "}" in texts else 0
    if texts[low : low + 2] != ["^", "{"] or "}" not in texts[low:]:
        return
    limit = texts[low + 2 : texts.index("}", low)]
    if all(text.isalnum() or text in ("+", "-") for text in limit):
        yield from (text for text in limit if text.isalpha())
