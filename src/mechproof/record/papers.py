"""Papers: symbols, rows in printed order, published sizes and the quantities shipped."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from types import MappingProxyType

import sympy as sp

from mechproof.record.exactness import check_name, check_texts
from mechproof.record.findings import Finding
from mechproof.record.quantities import OnePass, Quantity
from mechproof.record.rows import Row
from mechproof.record.variables import Notation, Part, Variable, list_given
from mechproof.tools.notebook import Displayed

# Names of the generated package that no system may take.
RESERVED = ("compiled", "derivatives", "forms", "kernels", "measured")


@dataclass(frozen=True)
class Toleranced:
    """A size with its limit deviations, exact."""

    nominal: sp.Expr
    upper: sp.Expr
    lower: sp.Expr


@dataclass(frozen=True)
class PublishedSizes:
    """Sizes that a paper prints, exact; a symbol that is left out is not printed.

    `marks` say what they rest on.
    """

    source: str
    sizes: Mapping[sp.Symbol, sp.Expr | Toleranced]
    marks: tuple[str, ...] = ()


@dataclass(frozen=True)
class Paper(Displayed):
    """A paper: its symbols, its rows in printed order, the quantities shipped from it.

    `usual` are sizes as in practice of symbols that have no printed one: they decide nothing, but
    a difference is shown at them first. `print` is the file of the paper's own source: what it has
    besides the rows is judged as far as that needs no mechanics. `transcription` is the version of
    the transcription that the rows were read from, a date or a number, and `sentences` how many it
    numbers (S1, S2, ...); those that no row judges stand in `aside`, with the reason. With
    `derivatives` the partial derivatives of each scalar quantity are kernels, too.
    """

    system: str
    citation: str
    variables: tuple[Variable, ...]
    rows: tuple[Row, ...]
    where: tuple[sp.Basic, ...] = ()
    quantities: tuple[Quantity, ...] = ()
    one_pass: tuple[OnePass, ...] = ()
    published: tuple[PublishedSizes, ...] = ()
    findings: tuple[Finding, ...] = ()
    conventions: str = ""
    notation: Notation = field(default_factory=Notation)
    usual: Mapping[sp.Basic, sp.Expr] = field(default_factory=lambda: MappingProxyType({}))
    print: Path | None = None
    doi: str = ""
    transcription: str = ""
    sentences: int = 0
    aside: Mapping[str, str] = field(default_factory=lambda: MappingProxyType({}))
    derivatives: bool = False

    def __post_init__(self) -> None:
        check_name("paper: system", self.system)
        if self.system in RESERVED:
            raise ValueError(
                f"paper: system = {self.system!r}: must be none of {', '.join(RESERVED)}"
            )
        check_texts(self, f"paper {self.system!r}")
        for what, names in (
            ("row numbers", [row.number for row in self.rows]),
            ("symbols", [str(variable.symbol) for variable in self.variables]),
            ("quantities", [q.name for q in self.quantities] + [t.name for t in self.one_pass]),
            ("findings", [finding.row for finding in self.findings]),
        ):
            twice = sorted({name for name in names if names.count(name) > 1})
            if twice:
                raise ValueError(f"paper {self.system!r}: {what} given twice: {twice}")
        _check_sentences(self)
        for together in self.one_pass:
            _check_together(self, together)

    @property
    def reference(self) -> str:
        """Return the citation with the DOI."""
        return f"{self.citation}, doi {self.doi}" if self.doi else self.citation

    @property
    def given(self) -> dict[sp.Symbol, sp.Expr]:
        """Return the symbols that others give, in the order in which they are declared."""
        return list_given(self.variables)

    def list_relations(self, *parts: Part | None) -> tuple[sp.Basic, ...]:
        """List the relations that hold wherever the paper and all parts of its domain speak."""
        return self.where + tuple(r for part in parts if part for r in part.where)


def _check_sentences(paper: Paper) -> None:
    """Refuse numbers of sentences that the transcription does not have, or that are aside, too."""
    cited = {name for row in paper.rows for name in row.cites}
    known = {f"S{number}" for number in range(1, paper.sentences + 1)}
    where = f"paper {paper.system!r}"
    if unknown := sorted((cited | paper.aside.keys()) - known):
        raise ValueError(f"{where}: sentences = {paper.sentences}: there are no {unknown}")
    if both := sorted(cited & paper.aside.keys()):
        raise ValueError(f"{where}: aside: rows judge {both}")


def _check_together(paper: Paper, together: OnePass) -> None:
    arguments = {
        q.name: tuple((a.name, a.symbols, a.default) for a in q.arguments)
        for q in paper.quantities
        if q.forms
    }
    where = f"paper {paper.system!r}: {together.name!r}"
    unknown = sorted(set(together.quantities) - arguments.keys())
    if unknown:
        raise ValueError(f"{where}: no quantities with forms: {unknown}")
    if len({arguments[name] for name in together.quantities}) != 1:
        raise ValueError(f"{where}: quantities of different arguments: {together.quantities}")
