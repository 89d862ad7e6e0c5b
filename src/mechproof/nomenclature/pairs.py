r"""Letters that are printed two at once, x_{1,2}=a\pm b: what the print is of, and what it ties."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from mechproof.nomenclature.block import Block, Declared
from mechproof.nomenclature.shown_letters import name_symbol

# A double sign.
DOUBLE = re.compile(r"\\(?:pm|mp)(?![A-Za-z])|[±∓]")
_PAIR = re.compile(r"(.+)_\{?(\d)\s*(?:[,/]|\{,\}|\\,)+\s*(\d)\}?")
_PRINT = re.compile(
    r"(?:\\[A-Za-z]+|[A-Za-z])\s*_\s*\{\s*\d\s*(?:[,/]|\{,\}|\\,)+\s*\d\s*\}", re.DOTALL
)


def find_stem(letter: str) -> str:
    """Return x of the name of two letters, x_{1,2}, nothing of another."""
    pair = _PAIR.fullmatch(letter)
    return pair[1] if pair else ""


def list_halves(letter: str) -> tuple[str, ...]:
    """Return x_1 and x_2 of the name of two letters, x_{1,2}, nothing of another."""
    pair = _PAIR.fullmatch(letter)
    return (f"{pair[1]}_{pair[2]}", f"{pair[1]}_{pair[3]}") if pair else ()


def find_pairs(prints: Iterable[str]) -> Iterator[str]:
    """Yield the names of two letters that stand beside double signs."""
    for latex in prints:
        if DOUBLE.search(latex):
            yield from _PRINT.findall(latex)


def leave_pairs(letters: Iterable[str], prints: Iterable[str]) -> list[str]:
    """Return letters without what is printed of two of them at once."""
    letters = [*letters]
    known = {*map(name_symbol, letters)}
    pairs = map(name_symbol, find_pairs(prints))
    both = {name for name in pairs if {*list_halves(name)} <= known}
    return [x for x in letters if name_symbol(x) not in both]


def add_pairs(block: Block, prints: Iterable[str]) -> dict[str, tuple[str, ...]]:
    """Declare what is printed of two declared letters at once; return both by its name.

    It has the unit of the first; what is said of each is not said of both. What the block declares
    itself is a letter of its own, as the ratio i_{1,2} is.
    """
    declared = {name_symbol(name): x for x in block.letters for name in x.names}
    found: dict[str, dict[str, None]] = {}
    for name in find_pairs(prints):
        if {*list_halves(name_symbol(name))} <= declared.keys() - {name_symbol(name)}:
            found.setdefault(name_symbol(name), {})[name] = None
    pairs = {name: list_halves(name) for name in found if name not in declared}
    for name, halves in pairs.items():
        one = declared[halves[0]]
        block.letters.append(Declared((*found[name],), one.meaning, one.unit, shape=one.shape))
    return pairs
