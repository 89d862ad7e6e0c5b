r"""Functions that prints define, f(x)=x^2: their letters have brackets wherever they stand."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from itertools import pairwise

from mechproof.latex import ReadingError
from mechproof.latex.latex_signs import find_close, measure_depths
from mechproof.latex.tokens import list_signs
from mechproof.nomenclature.adjacent_letters import list_letters, skip_power


def find_bracketed(prints: Iterable[str]) -> frozenset[str]:
    """Return the letters that have a round bracket behind them wherever they stand."""
    behind: dict[str, set[bool]] = defaultdict(set)
    for texts in _read_signs(prints):
        for letter, end in list_letters(texts):
            place = skip_power(texts, end)
            behind[letter].add(texts[place : place + 1] == ["("])
    return frozenset(letter for letter, found in behind.items() if found == {True})


def find_defined(prints: Sequence[str]) -> Iterator[tuple[str, str]]:
    """Yield the functions that equations begin with and define, and their arguments.

    Each argument is a letter; one at least stands behind the sign of equality, too.
    """
    bracketed = find_bracketed(prints)
    for texts in _cut(_read_signs(prints)):
        letter, end = next(list_letters(texts), ("", 0))
        close = end + find_close(texts[end:])
        inside = texts[end + 1 : close]
        arguments = [x for x, _ in list_letters(inside)]
        if (
            letter in bracketed
            and texts[: end + 1] == [*list_signs(letter), "("]
            and texts[close + 1 : close + 2] == ["="]
            and ",".join(arguments) == "".join(inside)
            and not {x for x, _ in list_letters(texts[close + 2 :])}.isdisjoint(arguments)
        ):
            yield letter, "".join(inside)


def _cut(prints: Iterable[Sequence[str]]) -> Iterator[Sequence[str]]:
    """Yield what stands between commas outside brackets."""
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
