"""Letters that prints show: which there are, which are one, which look like matrices."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

from mechproof.document.cells import name_unit
from mechproof.latex import Reader, ReadingError
from mechproof.latex.errors import Remedies
from mechproof.latex.left_scripts import LEFT, VECTORS
from mechproof.record import Notation

REMEDIES = Remedies(
    name="Declare it in the block of letters: {0} : its meaning",
    bracket="Say in the block of letters: factor {0}, or declare the whole print, {0}(…), as a "
    "letter.",
    function="Print a function that is the same everywhere (ln, lg, arctg).",
    scope="Print another letter for '{0}' where it is bound.",
    lower_limit="Say in the block of letters: from 0, or where else it starts.",
    family="Leave {0} out of the block of letters.",
    membership="Print an interval as a relation, 0<x<1, or say natural for a letter that counts.",
)
_ASKS = re.compile(r"a bracket after (.+?): a factor")
_MATRIX = re.compile(
    r"(?P<name>[^=&]{1,40}?)\s*=\s*(?:\\left[\[(])?\s*"
    r"\\begin\{(?:[bpvBV]?matrix|array)\}(?:\{[lcr|]+\})?(?P<body>.*?)\\end\{",
    re.DOTALL,
)


def name_symbol(latex: str) -> str:
    """Return the name of the symbol that is printed so."""
    return re.sub(r"[\\{}\s]", "", latex)


def group_alike(letters: Iterable[str]) -> list[tuple[str, ...]]:
    r"""Return letters with those that print alike, \dot{x}_1 and \dot{x_1}, as one."""
    groups: dict[str, dict[str, None]] = {}
    for letter in letters:
        groups.setdefault(name_symbol(letter), {})[letter] = None
    return [tuple(group) for group in groups.values()]


@dataclass(frozen=True)
class Collected:
    """Letters that are not declared, those before a bracket, and why some prints show none.

    What could not be read is keyed by the number of its print.
    """

    letters: list[str]
    factors: list[str]
    unread: Mapping[int, str]


def collect_letters(printed: Iterable[str]) -> Collected:
    """Collect the letters of prints."""
    letters: dict[str, None] = {}
    factors: dict[str, None] = {}
    unread: dict[int, str] = {}
    for number, latex in enumerate(printed):
        found = _collect_from(latex, factors)
        if isinstance(found, str):
            unread[number] = found
        else:
            letters |= dict.fromkeys(found)
    return Collected([x for x in letters if "#" not in x], list(factors), unread)


def _collect_from(latex: str, factors: dict[str, None]) -> list[str] | str:
    """Return the letters of a print, or why it cannot be read."""
    while True:
        try:
            return Reader(
                (), Notation(factors=tuple(factors), name_unit=name_unit), REMEDIES
            ).collect(latex)
        except ReadingError as error:
            asks = _ASKS.search(error.args[0])
            if asks is None or asks[1] in factors:
                return str(error.args[0])
            factors[asks[1]] = None
        except RecursionError:
            return "it is nested too deeply"


def is_vector(letter: str) -> bool:
    """Return whether a letter is printed as a vector, or in a frame: it is no number then."""
    return letter.startswith((*VECTORS, LEFT))


def find_shapes(prints: Iterable[str]) -> Iterator[tuple[str, tuple[int, int]]]:
    """Yield the letters that are printed to be a matrix, and its numbers of rows and columns."""
    for latex in prints:
        for match in _MATRIX.finditer(latex):
            rows = [row for row in match["body"].split(r"\\") if row.strip()]
            columns = rows[0].count("&") + 1 if rows else 1
            yield name_symbol(match["name"]), (len(rows), columns)
