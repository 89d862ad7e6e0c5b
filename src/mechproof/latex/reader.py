"""The reader of a paper: prints -> expressions in its symbols and notation."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Any

import sympy as sp

from mechproof.latex.calculus import compare_derivatives
from mechproof.latex.chains import read_print
from mechproof.latex.errors import MODULE, PrintedText, ReadingError, Remedies
from mechproof.latex.meaning import Meaning
from mechproof.latex.measures import put_sizes, put_units
from mechproof.latex.name_table import build_names
from mechproof.latex.parser import Parser
from mechproof.latex.tree import Chain
from mechproof.record import Notation, Row, Variable, list_given

_OPENING, _CLOSING = re.compile(r"(?<!\\)\{"), re.compile(r"(?<!\\)\}")
# A group that begins just in front, with its command: \num{.
_GROUP = re.compile(r"(?:\\[A-Za-z]+\s*)?(?<!\\)\{[\s+-]*\Z")


@dataclass(frozen=True)
class Print:
    """A print that has been parsed: its chains and how to turn them into expressions."""

    source: PrintedText
    chains: tuple[Chain, ...]
    reader: Reader
    upper: int = 0

    def meaning(self, derived: Mapping[sp.Basic, sp.Basic] | None = None) -> Meaning:
        """Return the converter of its trees into expressions, with `derived` overriding values."""
        values = {**self.reader.values, **(derived or {})}
        reader = self.reader
        return Meaning(self.source, values, reader.notation, reader.remedies)

    def cut(self, chain: Chain, first: int, last: int) -> str:
        """Return the source of some members of a chain, with the signs between them."""
        latex = self.source.latex
        start, end = chain.members[first].start, chain.members[last].end
        while _count(_CLOSING, latex[start:end]) > _count(_OPENING, latex[start:end]):
            before = _GROUP.search(latex, 0, start)
            if before is None:
                break
            start = before.start()
        while _count(_OPENING, latex[start:end]) > _count(_CLOSING, latex[start:end]):
            after = _CLOSING.search(latex, end)
            if after is None:
                break
            end = after.end()
        return latex[start:end].strip()


def _count(sign: re.Pattern[str], text: str) -> int:
    return len(sign.findall(text))


class Reader:
    """Reads the prints of one paper."""

    def __init__(
        self,
        variables: Sequence[Variable],
        notation: Notation | None = None,
        remedies: Remedies = MODULE,
    ) -> None:
        self.remedies = remedies
        self.variables = tuple(variables)
        self.notation = notation or Notation()
        self.values = list_given(variables)
        self._names = lru_cache(partial(build_names, self.variables, self.notation))

    def parse(self, latex: str, row: str = "", upper: int = 0) -> Print:
        """Read a print with the names of a row; raises `ReadingError` if it is ambiguous.

        `upper` selects the double signs: 1 the upper, -1 the lower ones; 0 lets a declared letter
        decide.
        """
        with _naming(row):
            parser = Parser(latex, self._names(row), self.notation, self.remedies, upper=upper)
            chains = read_print(parser)
            if self.notation.lower_limit is None:
                chains = tuple(map(compare_derivatives, chains))
            if weigh := self.notation.weigh_unit:
                own = self.notation.units
                chains = tuple(put_sizes(put_units(chain, weigh), weigh, own) for chain in chains)
            return Print(parser.source, chains, self, upper)

    def collect(self, latex: str) -> list[str]:
        """Return the undeclared letters of a print; `#` stands for bound indices.

        Raises `ReadingError`.
        """
        collected: list[str] = []
        read_print(Parser(latex, self._names(""), self.notation, self.remedies, collected, 1))
        return list(dict.fromkeys(collected))

    def members(self, row: Row) -> tuple[Any, ...]:
        """Return the members of the chains of a row as printed, for claims and forms.

        Raises `ReadingError`.
        """
        read = self.parse(row.printed_latex, row.number)
        with _naming(row.number):
            meaning = read.meaning()
            return tuple(meaning.of(member) for chain in read.chains for member in chain.members)


@contextmanager
def _naming(row: str) -> Iterator[None]:
    """Give a `ReadingError` the number of the row that it is about."""
    try:
        yield
    except ReadingError as error:
        error.row = error.row or row
        raise
