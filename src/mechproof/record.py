"""The words every layer shares: paper, row, statement, quantity, form.

A derivation module fills these records and binds one `Paper` to the name `PAPER`.
Nothing here decides anything: verdicts come from `mechproof.proof`, source code from
`mechproof.codegen`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from types import MappingProxyType
from typing import ClassVar, Literal

import sympy as sp

Power = int | Fraction

MARKS = ("rebuilt", "calibrated", "fitted", "uncertain", "inferred", "ours")


@dataclass(frozen=True)
class Dimension:
    """Exponents of the base quantities; angles and pure numbers have none."""

    length: Power = 0
    mass: Power = 0
    time: Power = 0
    temperature: Power = 0

    def __mul__(self, other: Dimension) -> Dimension:
        return Dimension(
            self.length + other.length,
            self.mass + other.mass,
            self.time + other.time,
            self.temperature + other.temperature,
        )

    def __pow__(self, power: Power) -> Dimension:
        return Dimension(
            self.length * power,
            self.mass * power,
            self.time * power,
            self.temperature * power,
        )

    def __truediv__(self, other: Dimension) -> Dimension:
        return self * other**-1

    def __str__(self) -> str:
        powers = zip("LMTK", (self.length, self.mass, self.time, self.temperature), strict=True)
        return "·".join(n if p == 1 else f"{n}^{p}" for n, p in powers if p) or "1"


NUMBER = Dimension()
LENGTH = Dimension(length=1)
SPEED = Dimension(length=1, time=-1)
FREQUENCY = Dimension(time=-1)


@dataclass(frozen=True)
class Variable:
    """A symbol of the paper: what it means, its dimension, its values, its sign convention.

    `within` is an interval (or `S.Naturals` for a count). `given` defines the symbol by
    others (a = (R1 - R2)/2) and is substituted before anything is decided.
    """

    symbol: sp.Symbol | sp.IndexedBase
    meaning: str
    dimension: Dimension = NUMBER
    within: sp.Set = sp.S.Reals
    given: sp.Expr | None = None
    sign: str = ""


@dataclass(frozen=True)
class Part:
    """A part of the domain in words and in mathematics: narrower sets, further relations."""

    text: str
    within: Mapping[sp.Symbol, sp.Set] = field(default_factory=lambda: MappingProxyType({}))
    where: tuple[sp.Basic, ...] = ()


# Statements: what a row asserts. The ladder has one way to decide each kind.


@dataclass(frozen=True)
class Equality:
    """`printed` equals `rebuilt` everywhere on the domain (expressions or matrices).

    The two sides come from different sources: one is the paper's, one is derived.
    """

    printed: sp.Basic
    rebuilt: sp.Basic


@dataclass(frozen=True)
class Distinct:
    """The two sides differ somewhere on the domain (decided by a counterexample)."""

    left: sp.Basic
    right: sp.Basic


@dataclass(frozen=True)
class Holds:
    """A relation (or several joined by And) is true on the whole domain."""

    relation: sp.Basic


@dataclass(frozen=True)
class PrintedNumber:
    """`value` rounds to the decimal string `printed` (half a unit of its last place)."""

    printed: str
    value: sp.Expr


@dataclass(frozen=True)
class Definition:
    """`symbol` is introduced as `printed`; only dimensions and bound symbols are checked."""

    symbol: sp.Symbol
    printed: sp.Basic


@dataclass(frozen=True)
class Conjunction:
    """Every part is true."""

    parts: tuple[Statement, ...]


@dataclass(frozen=True)
class Completion:
    """The missing data completed in one stated way, and what the statement then becomes."""

    text: str
    says: Statement


@dataclass(frozen=True)
class Completions:
    """The paper lacks data; two completions whose decisions are compared."""

    first: Completion
    second: Completion


Statement = Equality | Distinct | Holds | PrintedNumber | Definition | Conjunction | Completions


class IntegralWithoutDifferential(sp.Function):  # type: ignore[misc]
    """An integral sign whose differential is missing in print; it has no value."""


def sum_distinct(term: sp.Expr, outer: sp.Symbol, inner: sp.Symbol, count: sp.Expr) -> sp.Expr:
    """Sum of `term` over outer = 1..count and inner = 1..count, inner != outer."""
    off_diagonal = term * (1 - sp.KroneckerDelta(outer, inner))
    return sp.Sum(off_diagonal, (inner, 1, count), (outer, 1, count))


@dataclass(frozen=True)
class Reading:
    """Another reading of an ambiguous sentence, sign, order or direction."""

    text: str
    says: Statement


@dataclass(frozen=True)
class Correction:
    """What should be printed, and the statement whose proof makes it right."""

    latex: str
    says: Statement


@dataclass(frozen=True)
class Row:
    """One line of the ledger: what is printed and what it asserts."""

    kind: ClassVar[Literal["equation", "claim"]]

    number: str
    printed_latex: str
    says: Statement
    note: str = ""
    corrected: Correction | None = None
    readings: tuple[Reading, ...] = ()
    holds_on: Part | None = None
    on: Part | None = None
    singular: tuple[str, ...] = ()
    marks: tuple[str, ...] = ()
    stays_open: str = ""

    def __post_init__(self) -> None:
        unknown = set(self.marks) - set(MARKS)
        if unknown:
            raise ValueError(f"row {self.number!r}: marks {sorted(unknown)} not in {MARKS}")


@dataclass(frozen=True)
class Equation(Row):
    """A numbered equation of the paper."""

    kind = "equation"


@dataclass(frozen=True)
class Claim(Row):
    """Any other checkable statement: a number, an interval, a sentence."""

    kind = "claim"


# Quantities: what the generated kernels compute.


@dataclass(frozen=True)
class Argument:
    """An argument of a kernel.

    One symbol: an array-like of any shape. Several symbols: components on the last axis.
    One `IndexedBase`: a last axis of any length, or two for a symbol with two indices.
    """

    name: str
    symbols: tuple[sp.Symbol | sp.IndexedBase, ...]
    meaning: str
    unit: str = "1"
    default: float | None = None


@dataclass(frozen=True)
class Bar:
    """Accuracy the tests hold: error <= `ulp` * eps * |scale|; `scale` None: the value itself."""

    ulp: float
    of: str = "the value"
    scale: sp.Expr | None = None


@dataclass(frozen=True)
class Form:
    """One way to compute: a starting expression and the named rewrites applied to it in order.

    `bound` is set for an approximation: a proved bound of |form - definition|. `proved_by` names
    the row of the paper that states form = definition, where the derivation does it itself.
    """

    name: str
    expression: sp.Basic
    rewrites: tuple[str, ...] = ()
    bound: sp.Expr | None = None
    proved_by: str = ""


@dataclass(frozen=True)
class Shortcut:
    """A cheaper form, taken where `when`, a relation on the parameters, is true of all of them."""

    form: Form
    when: sp.Basic


@dataclass(frozen=True)
class Quantity:
    """A function of a system that is generated as a kernel.

    `definition` is the exact meaning (what the accuracy is measured against), `form` what is
    printed, `shortcut` what is computed instead where it is as accurate. `specimen` holds, for a
    function kept only for comparison, what is wrong with it.
    """

    name: str
    summary: str
    arguments: tuple[Argument, ...]
    definition: sp.Basic
    form: Form
    source: str
    unit: str = "1"
    bar: Bar | None = None
    on: Part | None = None
    singular: tuple[str, ...] = ()
    specimen: str = ""
    shortcut: Shortcut | None = None


@dataclass(frozen=True)
class Paper:
    """A paper: its symbols, its rows in printed order, the quantities shipped from it."""

    system: str
    citation: str
    variables: tuple[Variable, ...]
    rows: tuple[Row, ...]
    where: tuple[sp.Basic, ...] = ()
    quantities: tuple[Quantity, ...] = ()
    conventions: str = ""

    def __post_init__(self) -> None:
        for what, names in (
            ("row numbers", [row.number for row in self.rows]),
            ("symbols", [str(variable.symbol) for variable in self.variables]),
            ("quantities", [quantity.name for quantity in self.quantities]),
        ):
            twice = sorted({name for name in names if names.count(name) > 1})
            if twice:
                raise ValueError(f"paper {self.system!r}: {what} given twice: {twice}")
