"""Rows: the lines of a paper's ledger, what they assert and what should be printed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, ClassVar, Literal

import sympy as sp

from mechproof.record.statements import Statement, check_statement
from mechproof.record.variables import Part

Derived = Mapping[sp.Basic, sp.Basic]

# Marks of rows: what a row rests on, and what that means for a reader.
MARKS = {
    "rebuilt": "the print is damaged and was restored from the equations around it: what was "
    "restored cannot be charged to the paper, and that it is proved confirms nothing",
    "inferred": "not printed in so many words, but read from a figure or from the sense",
    "uncertain": "a character or a digit of the print may be another",
    "calibrated": "rests on a number that the paper does not print and that was reconstructed",
    "fitted": "rests on a number that was fitted to this very print, which is no confirmation",
    "ours": "not printed in the paper: a result that other rows or the kernels rest on",
    "consequence": "what follows from the rows for the paper's own numbers and conclusions",
}


@dataclass(frozen=True)
class Reading:
    """Another reading of an ambiguous sentence, sign, order or direction."""

    text: str
    says: Statement

    def __post_init__(self) -> None:
        check_statement(self.says)


@dataclass(frozen=True)
class Correction:
    """What should be printed, and the statement whose proof makes it right.

    Without `says` the LaTeX is read like the sign of the row that it corrects.
    """

    latex: str
    says: Statement | None = None

    @property
    def statement(self) -> Statement:
        """Return what the correction asserts; `ValueError` for LaTeX that has not been read."""
        if self.says is None:
            raise ValueError(f"correction {self.latex}: it has not been read")
        return self.says

    def __post_init__(self) -> None:
        if self.says is not None:
            check_statement(self.says)


@dataclass(frozen=True, kw_only=True)
class _Told:
    """What is told of a row, or of one relation of its print."""

    note: str = ""
    corrected: Correction | None = None
    readings: tuple[Reading, ...] = ()
    holds_on: Part | None = None
    on: Part | None = None
    singular: tuple[str, ...] = ()
    marks: tuple[str, ...] = ()
    derived: Derived = field(default_factory=lambda: MappingProxyType({}))
    residual: sp.Expr | None = None
    substituted: Mapping[sp.Expr, sp.Expr] = field(default_factory=lambda: MappingProxyType({}))


@dataclass(frozen=True)
class ChainLink(_Told):
    """What one relation of a chain a = b = c has of its own; its words are those of `Row`."""

    says: Statement | None = None


@dataclass(frozen=True)
class Row(_Told):
    """One line of the ledger: what is printed and what it asserts.

    `printed_latex` is the whole print, chains a = b = c included. Without `says` it is read: each
    relation sign becomes a line of its own and asserts the relation of its two members.

    `derived` is what our mechanics give for symbols of this print, or for a whole member; it takes
    the place of the declared value. `residual` is what they give for left - right of an equation
    between independent symbols. `substituted` is put into both members before they are compared
    (tg(x/2) -> U). `defines` are symbols that the print introduces. `links` has by number, from
    1 on, what one relation has instead. `cites` are the sentences of the transcription that the
    row judges, by their numbers (S52). `quantities` are those, by their names, on whose pages a row
    of ours stands, as their formulas or kernels rest on it. `read_as` is filled in by the reader,
    and `divisors`: what the print divides by, and what it says does not any more.
    """

    kind: ClassVar[Literal["equation", "claim", "datum"]]

    number: str
    printed_latex: str
    says: Statement | None = None
    defines: tuple[sp.Basic, ...] = ()
    links: Mapping[int, ChainLink] = field(default_factory=lambda: MappingProxyType({}))
    cites: tuple[str, ...] = ()
    quantities: tuple[str, ...] = ()
    read_as: str = ""
    divisors: tuple[sp.Expr, ...] = ()

    def __post_init__(self) -> None:
        marks = {*self.marks, *(mark for link in self.links.values() for mark in link.marks)}
        if unknown := marks - set(MARKS):
            raise ValueError(f"row {self.number!r}: marks {sorted(unknown)} not in {tuple(MARKS)}")
        if self.quantities and "ours" not in self.marks:
            raise ValueError(f"row {self.number!r}: quantities: only rows of ours name them")
        if self.says is not None:
            check_statement(self.says)

    @property
    def statement(self) -> Statement:
        """Return what the row asserts; `ValueError` for a print that has not been read."""
        if self.says is None:
            raise ValueError(f"row {self.number!r}: its print has not been read")
        return self.says


@dataclass(frozen=True)
class Equation(Row):
    """A numbered equation of the paper."""

    kind = "equation"


@dataclass(frozen=True)
class Claim(Row):
    """Any other checkable statement: a number, an interval, a sentence."""

    kind = "claim"


@dataclass(frozen=True)
class Datum(Row):
    """A printed datum: a size, a property of an instrument, a coverage factor."""

    kind = "datum"


def ours(
    number: str, latex: str, says: Statement | None = None, marks: tuple[str, ...] = (), **more: Any
) -> Claim:
    """Return a claim that no paper prints; `more` are further fields of `Row`."""
    return Claim(number, latex, says, marks=("ours", *marks), **more)
