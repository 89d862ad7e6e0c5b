"""Functions that prints define, f(x)=x^2: letters with a bracket wherever they appear."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from itertools import pairwise

from mechproof.latex import ReadingError
from mechproof.latex.latex_signs import find_close, measure_depths
from mechproof.latex.tokens import list_signs
from mechproof.nomenclature.adjacent_letters import list_letters, skip_power

# Brackets after a letter that depends on time: none, (t) or (0).
_OF_TIME = {"", "(t", "(0"}


def find_bracketed(prints: Iterable[str]) -> frozenset[str]:
    """Return the letters that have a round bracket after them wherever they appear."""
    return frozenset(letter for letter, found in _list_brackets(prints).items() if "" not in found)


def _list_brackets(prints: Iterable[str]) -> dict[str, set[str]]:
    """Return each letter with the round brackets printed after it, "" for none."""
    after: dict[str, set[str]] = defaultdict(set)
    for texts in _read_signs(prints):
        for letter, end in list_letters(texts):
            rest = texts[skip_power(texts, end) :]
            has_bracket = rest[:1] == ["("]
            after[letter].add("".join(rest[: find_close(rest)]) if has_bracket else "")
    return after


def find_defined(prints: Sequence[str]) -> Iterator[tuple[str, str]]:
    """Yield the functions that equations define at their beginning, and their arguments.

    Each argument is a letter; at least one appears on the right of the equals sign, too. A letter
    without a bracket counts as its function of time, x for x(t).
    """
    brackets = _list_brackets(prints)
    bracketed = {letter for letter, found in brackets.items() if "" not in found}
    timed = {letter for letter, found in brackets.items() if found <= _OF_TIME}
    for texts in _cut(_read_signs(prints)):
        letter, end = next(list_letters(texts), ("", 0))
        close = end + find_close(texts[end:])
        inside = texts[end + 1 : close]
        arguments = [x for x, _ in list_letters(inside)]
        after = {x for x, _ in list_letters(texts[close + 2 :])}
        # If the letter itself is on the right, as in v(t)=v+at, it is a different one.
        is_timed = letter in timed and inside == ["t"] and letter not in after
        if (
            (letter in bracketed or is_timed)
            and texts[: end + 1] == [*list_signs(letter), "("]
            and texts[close + 1 : close + 2] == ["="]
            and ",".join(arguments) == "".join(inside)
            and not after.isdisjoint(arguments)
        ):
            yield letter, "".join(inside)


def _cut(prints: Iterable[Sequence[str]]) -> Iterator[Sequence[str]]:
    """Yield the parts of prints between commas outside brackets."""
    for texts in prints:
        ends = [
            place
            for place, (text, depth) in enumerate(zip(texts, measure_depths(texts), strict=True))
            if not depth and text in (",", ";")
        ]
        for start, end in pairwise([-1, *ends, len(texts)]):
            yield texts[start + 1 : end]


def _read_signs(prints: Iterable[str]) -> Iterator[list[str]]:
    for latex in prints:
        with suppress(ReadingError):
            yield list_signs(latex)
