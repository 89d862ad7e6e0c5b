"""Rows: the entries of a paper's ledger, what they assert and what should be printed."""

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
    "restored cannot be charged to the paper, and its proof confirms nothing",
    "inferred": "not printed explicitly, but read from a figure or from the meaning",
    "uncertain": "a character or a digit of the print may be another",
    "calibrated": "rests on a number that the paper does not print and that was reconstructed",
    "fitted": "rests on a number that was fitted to this very print, so it confirms nothing",
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

    Without `says`, the LaTeX is read in the same way as the relation of the row that it corrects.
    """

    latex: str
    says: Statement | None = None

    @property
    def statement(self) -> Statement:
        """Return the assertion; raises `ValueError` if the LaTeX has not been read."""
        if self.says is None:
            raise ValueError(f"correction {self.latex}: it has not been read")
        return self.says

    def __post_init__(self) -> None:
        if self.says is not None:
            check_statement(self.says)


@dataclass(frozen=True, kw_only=True)
class _Told:
    """Statements about a row, or about one relation of its print."""

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
    """The statements on one relation of a chain a = b = c; the fields are those of `Row`."""

    says: Statement | None = None


@dataclass(frozen=True)
class Row(_Told):
    """One row of the ledger: what is printed and what it asserts.

    `printed_latex` is the whole print, chains a = b = c included. Without `says` it is read: each
    relation sign becomes a row of its own, which asserts the relation of its two members.

    `derived` is what our mechanics give for symbols of this print, or for a whole member, in place
    of the declared value. `residual` is what they give for left - right of an equation between
    independent symbols. `substituted` is put into both members before they are compared (tg(x/2) ->
    U). `defines` are symbols that the print introduces. `links` has, by the numbers of relations
    from 1 onwards, what applies to that relation instead. `cites` are the sentences of the
    transcription that the row judges, by their numbers (S52). `quantities` names the quantities on
    whose pages one of our own rows is shown, as their formulas or kernels rest on it. The reader
    fills in `read_as`, and `divisors`: what the print divides by although `says` no longer does.
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
            raise ValueError(f"row {self.number!r}: quantities: only rows marked 'ours' name them")
        if self.says is not None:
            check_statement(self.says)

    @property
    def statement(self) -> Statement:
        """Return the assertion of the row; raises `ValueError` if its print has not been read."""
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
    """Return a claim that no paper prints; `more` are other fields of `Row`."""
    return Claim(number, latex, says, marks=("ours", *marks), **more)
