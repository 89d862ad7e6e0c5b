"""Papers: symbols, rows in printed order, published sizes, quantities and findings."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from enum import IntEnum
from pathlib import Path
from types import MappingProxyType

import sympy as sp

from mechproof.record.exactness import check_name, check_texts
from mechproof.record.memory import remember_last
from mechproof.record.quantities import OnePass, Quantity
from mechproof.record.rows import Row
from mechproof.record.variables import Notation, Part, Variable, list_given
from mechproof.tools.notebook import Displayed

# Names of the generated package that no system may take.
RESERVED = ("compiled", "derivatives", "forms", "kernels", "measured")


class Weight(IntEnum):
    """What a finding changes for a reader, the gravest first."""

    CONCLUSION = 0
    NUMBER = 1
    FORMULA = 2
    WORDING = 3


WEIGHTS: Mapping[Weight, str] = MappingProxyType(
    {
        Weight.CONCLUSION: "changes a conclusion",
        Weight.NUMBER: "changes a number that a reader would use",
        Weight.FORMULA: "a formula cannot be evaluated as printed",
        Weight.WORDING: "the wording misleads",
    }
)


@dataclass(frozen=True)
class Check:
    """A check for a pocket calculator: a sentence with its numbers as {0}, {1}, ... computed.

    The values are exact; they are shown in the unit, rounded to `decimals` decimals. {0:4} shows
    the bare number, without the unit, to 4 decimals.
    """

    text: str
    values: tuple[sp.Expr, ...] = ()
    decimals: int = 3
    unit: str = ""


@dataclass(frozen=True)
class Cost:
    """The effect of a fault at one place: the printed value, the right one, and their difference.

    `at` gives the symbols exact values (30 degrees are pi/6). Without `printed` and `right`, the
    values are those of the two sides of the row. Units are those of
    `mechproof.ledger.ledger_findings`. `names` are the names of the two values if neither is
    plainly the right one; by default the first is the printed one, or the literal reading of a
    convention.
    """

    where: str
    unit: str = ""
    decimals: int = 1
    printed: sp.Expr | None = None
    right: sp.Expr | None = None
    names: tuple[str, str] = ("printed", "right")
    at: Mapping[sp.Basic, sp.Expr] = field(default_factory=lambda: MappingProxyType({}))


@dataclass(frozen=True)
class FollowingRow:
    """A row that contains the print of its cause in other letters, or only parts of it.

    `renamed` maps symbols of the cause to their names in the row. `parts` maps parts of the cause's
    print to their replacements in its correction (by default the whole print).
    """

    row: str
    renamed: Mapping[sp.Basic, sp.Basic] = field(default_factory=lambda: MappingProxyType({}))
    parts: Mapping[sp.Basic, sp.Basic] = field(default_factory=lambda: MappingProxyType({}))


@dataclass(frozen=True)
class Finding:
    """A root cause: the row that shows it, what is wrong in a plain sentence, and what it costs.

    `mend` is the number of a proved row whose print is the smallest mend, if that is smaller than
    the correction of the row; `figure` is the name of a picture that shows the fault. `follows` are
    the rows that are wrong only for this reason: with the correction of the cause in place of its
    print, each of them is proved, which is a row of the ledger.
    """

    row: str
    wrong: str
    costs: tuple[Cost, ...] = ()
    follows: tuple[str | FollowingRow, ...] = ()
    weight: Weight = Weight.NUMBER
    mend: str = ""
    check: Check | None = None
    figure: str = ""

    @property
    def followers(self) -> tuple[FollowingRow, ...]:
        """Return what follows; a plain row number stands for a row with the whole print."""
        return tuple(FollowingRow(f) if isinstance(f, str) else f for f in self.follows)


@dataclass(frozen=True)
class Toleranced:
    """A size with its limit deviations, exact."""

    nominal: sp.Expr
    upper: sp.Expr
    lower: sp.Expr


@dataclass(frozen=True)
class PublishedSizes:
    """Sizes that a paper prints, exact; symbols without a printed size are left out.

    `marks` state what they rest on.
    """

    source: str
    sizes: Mapping[sp.Symbol, sp.Expr | Toleranced]
    marks: tuple[str, ...] = ()


@dataclass(frozen=True)
class Paper(Displayed):
    """A paper: its symbols, its rows in printed order, the quantities shipped from it.

    `usual` are practical sizes of symbols without a printed size: they decide nothing, but a
    difference is shown at them first. `print` is the file of the paper's own source, whose prints
    besides the rows are judged as far as that needs no mechanics. `transcription` is the version of
    the transcription from which the rows were read, a date or a number, and `sentences` is the
    number of its numbered sentences (S1, S2, ...); those that no row judges are listed in `aside`,
    with the reason. With `derivatives`, the partial derivatives of each scalar quantity are
    kernels, too.
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
                f"paper: system = {self.system!r}: must not be one of {', '.join(RESERVED)}"
            )
        for name, part in vars(self).items():
            _check_texts_of(self.system, name, part)
        for what, names in (
            ("row numbers", [row.number for row in self.rows]),
            ("symbols", _name_symbols(self.variables)),
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
        """Return the symbols defined by others, with their values, in the order of declaration."""
        return list_given(self.variables)

    def list_relations(self, *parts: Part | None) -> tuple[sp.Basic, ...]:
        """Return the relations that hold in the domain of the paper and in all given parts."""
        return self.where + tuple(r for part in parts if part for r in part.where)


# Changing one field of a paper leaves the others as they were checked.
@remember_last(64)
def _check_texts_of(system: str, name: str, part: object) -> None:
    check_texts(part, f"paper {system!r}, {name}")


@remember_last(8)
def _name_symbols(variables: Sequence[Variable]) -> list[str]:
    return [str(variable.symbol) for variable in variables]


def _check_sentences(paper: Paper) -> None:
    """Refuse numbers of sentences that the transcription lacks, and cited ones that are aside."""
    cited = {name for row in paper.rows for name in row.cites}
    known = {f"S{number}" for number in range(1, paper.sentences + 1)}
    where = f"paper {paper.system!r}"
    if unknown := sorted((cited | paper.aside.keys()) - known):
        raise ValueError(f"{where}: sentences = {paper.sentences}: unknown {unknown}")
    if both := sorted(cited & paper.aside.keys()):
        raise ValueError(f"{where}: aside: rows also judge {both}")


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
        raise ValueError(f"{where}: quantities with different arguments: {together.quantities}")
