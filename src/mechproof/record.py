"""The words every layer shares: paper, row, statement, quantity, form.

A derivation module fills these records and binds one `Paper` to the name `PAPER`.
Nothing here decides anything: verdicts come from `mechproof.proof`, source code from
`mechproof.codegen`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from keyword import iskeyword
from types import MappingProxyType
from typing import Any, ClassVar, Literal, Protocol

import sympy as sp
from sympy.logic.boolalg import Boolean

Power = int | Fraction
Derived = Mapping[sp.Basic, sp.Basic]

# Names of the generated package that no system may take.
RESERVED = ("compiled", "forms", "kernels", "measured")
MARKS = ("rebuilt", "calibrated", "fitted", "uncertain", "inferred", "ours")
_DECIMAL = re.compile(r"-?\d+(\.\d+)?")


class RecordError(ValueError):
    """A record that says something it cannot mean: a fault of the derivation, not of the paper."""


def _make_exact(record: object, *names: str) -> None:
    """Turn numbers and matrices of the named fields into SymPy's; refuse what is not exact."""
    for name in names:
        value = getattr(record, name)
        if isinstance(value, sp.MatrixBase):
            value = sp.ImmutableMatrix(value)
        elif isinstance(value, int | Fraction) and not isinstance(value, bool):
            value = sp.Rational(value)
        if not isinstance(value, sp.Expr | sp.MatrixBase):
            where = f"{type(record).__name__}: {name} = {value!r}"
            raise RecordError(f"{where}: allowed are SymPy expressions, integers and fractions")
        if value.has(sp.Float):
            where = f"{type(record).__name__}: {name} = {value}"
            raise RecordError(f"{where}: it has a float; exact is Rational('0.1')")
        object.__setattr__(record, name, value)


@dataclass(frozen=True)
class Dimension:
    """Exponents of the base quantities; angles and pure numbers have none.

    That of the angle is kept beside them: it tells how a value is shown and is compared nowhere.
    """

    length: Power = 0
    mass: Power = 0
    time: Power = 0
    temperature: Power = 0
    angle: Power = field(default=0, compare=False)

    @property
    def is_angle(self) -> bool:
        """Return whether values are shown in degrees too."""
        return self == NUMBER and self.angle == 1

    def __mul__(self, other: Dimension) -> Dimension:
        return Dimension(
            self.length + other.length,
            self.mass + other.mass,
            self.time + other.time,
            self.temperature + other.temperature,
            self.angle + other.angle,
        )

    def __pow__(self, power: Power) -> Dimension:
        return Dimension(
            self.length * power,
            self.mass * power,
            self.time * power,
            self.temperature * power,
            self.angle * power,
        )

    def __truediv__(self, other: Dimension) -> Dimension:
        return self * other**-1

    def __str__(self) -> str:
        powers = zip("LMTK", (self.length, self.mass, self.time, self.temperature), strict=True)
        return "·".join(n if p == 1 else f"{n}^{p}" for n, p in powers if p) or "1"


NUMBER = Dimension()
ANGLE = Dimension(angle=1)
LENGTH = Dimension(length=1)
SPEED = Dimension(length=1, time=-1)
FREQUENCY = Dimension(time=-1)


@dataclass(frozen=True)
class Variable:
    r"""A symbol of the paper: what it means, its dimension, its values, its sign convention.

    `within` is an interval (or `S.Naturals` for a count). `given` defines the symbol by
    others (a = (R1 - R2)/2) and is substituted before anything is decided.
    `latex` are the ways it is printed, whole idioms included (`\varphi_3'`, `\rho(\varphi_5)`,
    `\frac{d\varphi_3}{d\varphi_1}`); without one it cannot be printed. A family (`IndexedBase`)
    is printed with its indices, which `#` stands for (`K_#(t)`; left out: at the end, `_#`).
    """

    symbol: sp.Symbol | sp.IndexedBase | sp.MatrixSymbol
    meaning: str
    dimension: Dimension = NUMBER
    within: sp.Set = sp.S.Reals
    given: sp.Expr | None = None
    sign: str = ""
    latex: tuple[str, ...] = ()


@dataclass(frozen=True)
class Scope:
    """Letters that mean something else in the named rows; None: nothing, a bound index."""

    rows: tuple[str, ...]
    names: Mapping[str, sp.Symbol | sp.IndexedBase | sp.MatrixSymbol | None]


@dataclass(frozen=True)
class Notation:
    r"""How a paper prints what is no symbol, as far as a reader has to be told.

    `factors` are names that a bracket after them multiplies (`a(1-e^2)`). `functions` adds to or
    replaces the names of functions in the table of `mechproof.latex`. `lower_limit` is where an
    integral printed without limits starts. `indices` are the symbols of index letters (left out:
    an integer symbol of that name). `scopes` are letters used twice.
    """

    factors: tuple[str, ...] = ()
    functions: Mapping[str, Callable[..., sp.Expr]] = field(
        default_factory=lambda: MappingProxyType({})
    )
    lower_limit: sp.Expr | None = None
    indices: tuple[sp.Symbol, ...] = ()
    scopes: tuple[Scope, ...] = ()


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

    The two sides come from different sources: one is the paper's, one is derived. Where `rebuilt`
    is built from the print itself, or from the declaration of the symbol that is printed,
    `rebuilt_from` says so: equality proves nothing then. Two members of one print are both the
    paper's: their faults are its own.
    """

    printed: sp.Basic
    rebuilt: sp.Basic
    rebuilt_from: Literal["mechanics", "member", "print", "declaration"] = "mechanics"

    def __post_init__(self) -> None:
        _make_exact(self, "printed", "rebuilt")


@dataclass(frozen=True)
class Distinct:
    """The two sides differ somewhere on the domain (decided by a counterexample)."""

    left: sp.Basic
    right: sp.Basic

    def __post_init__(self) -> None:
        _make_exact(self, "left", "right")


@dataclass(frozen=True)
class Holds:
    """A relation (or several joined by And) is true on the whole domain."""

    relation: sp.Basic

    def __post_init__(self) -> None:
        if not isinstance(self.relation, Boolean) or self.relation.is_Symbol:
            raise RecordError(f"Holds: {self.relation!r} is no relation of SymPy")
        if self.relation.has(sp.Float):
            raise RecordError(f"Holds: {self.relation} has a float; exact is Rational('0.1')")


@dataclass(frozen=True)
class PrintedNumber:
    """`value` rounds to the decimal string `printed` (half a unit of its last place)."""

    printed: str
    value: sp.Expr

    def __post_init__(self) -> None:
        if not (isinstance(self.printed, str) and _DECIMAL.fullmatch(self.printed)):
            raise RecordError(
                f"PrintedNumber: printed {self.printed!r} is not a decimal number such as '-0.93'"
            )
        _make_exact(self, "value")


@dataclass(frozen=True)
class Definition:
    """`symbol` is introduced as `printed`; only dimensions and bound symbols are checked."""

    symbol: sp.Symbol
    printed: sp.Basic

    def __post_init__(self) -> None:
        _make_exact(self, "symbol", "printed")


@dataclass(frozen=True)
class Conjunction:
    """Every part is true."""

    parts: tuple[Statement, ...]

    def __post_init__(self) -> None:
        if not self.parts:
            raise RecordError("a Conjunction needs at least one part")
        for part in self.parts:
            _check_statement(part)


@dataclass(frozen=True)
class Completion:
    """The missing datum completed in one stated way, and what the statement then becomes."""

    text: str
    says: Statement
    value: sp.Expr | None = None

    def __post_init__(self) -> None:
        _check_statement(self.says)


@dataclass(frozen=True)
class Completions:
    """The paper lacks a datum, named here; two completions of it whose decisions are compared.

    A symbol of the paper gets the `value` of each completion, which say the same of it; a datum
    in words is completed by the words of each.
    """

    missing: str | sp.Symbol
    first: Completion
    second: Completion

    def __post_init__(self) -> None:
        sides = (self.first, self.second)
        if isinstance(self.missing, sp.Symbol):
            has_values = all(side.value is not None for side in sides)
            is_one = self.first.says == self.second.says
            if not (has_values and is_one and self.first.value != self.second.value):
                raise RecordError(
                    f"Completions: two values of {self.missing} are needed, and one statement"
                )
        elif not self.missing or self.first.text == self.second.text:
            raise RecordError("Completions: name what is missing, and complete it in two ways")


Statement = Equality | Distinct | Holds | PrintedNumber | Definition | Conjunction | Completions


def _check_statement(says: object) -> None:
    if not isinstance(says, Statement):
        raise RecordError(f"{says!r} is no statement: {type(says).__name__}")


class IntegralWithoutDifferential(sp.Function):  # type: ignore[misc]
    """An integral sign whose differential is missing in print; it has no value."""


class FunctionWithoutArgument(sp.Function):  # type: ignore[misc]
    """A function, named by its argument, that is printed without one; it has no value."""


def sum_distinct(term: sp.Expr, outer: sp.Symbol, inner: sp.Symbol, count: sp.Expr) -> sp.Expr:
    """Sum of `term` over outer = 1..count and inner = 1..count, inner != outer."""
    off_diagonal = term * (1 - sp.KroneckerDelta(outer, inner))
    return sp.Sum(off_diagonal, (inner, 1, count), (outer, 1, count))


@dataclass(frozen=True)
class Reading:
    """Another reading of an ambiguous sentence, sign, order or direction."""

    text: str
    says: Statement

    def __post_init__(self) -> None:
        _check_statement(self.says)


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
            _check_statement(self.says)


@dataclass(frozen=True)
class Sign:
    """What is special about one relation sign of a row; its words are those of `Row`."""

    says: Statement | None = None
    note: str = ""
    corrected: Correction | None = None
    readings: tuple[Reading, ...] = ()
    holds_on: Part | None = None
    on: Part | None = None
    singular: tuple[str, ...] = ()
    marks: tuple[str, ...] = ()
    stays_open: str = ""
    derived: Derived = field(default_factory=lambda: MappingProxyType({}))
    residual: sp.Expr | None = None
    substituted: Mapping[sp.Expr, sp.Expr] = field(default_factory=lambda: MappingProxyType({}))


@dataclass(frozen=True)
class Row:
    """One line of the ledger: what is printed and what it asserts.

    `printed_latex` is the whole print, chains a = b = c included. Without `says` it is read: each
    relation sign becomes a line of its own and asserts the relation of its two members.

    `derived` is what our mechanics give for symbols of this print, or for a whole member; it takes
    the place of the declared value. `residual` is what they give for left - right of an equation
    between independent symbols. `substituted` is put into both members before they are compared
    (tg(x/2) -> U). `defines` are symbols that the print introduces. `signs` has by number, from
    1 on, what one sign has instead. `read_as` is filled in by the reader.
    """

    kind: ClassVar[Literal["equation", "claim", "datum"]]

    number: str
    printed_latex: str
    says: Statement | None = None
    note: str = ""
    corrected: Correction | None = None
    readings: tuple[Reading, ...] = ()
    holds_on: Part | None = None
    on: Part | None = None
    singular: tuple[str, ...] = ()
    marks: tuple[str, ...] = ()
    stays_open: str = ""
    derived: Derived = field(default_factory=lambda: MappingProxyType({}))
    residual: sp.Expr | None = None
    substituted: Mapping[sp.Expr, sp.Expr] = field(default_factory=lambda: MappingProxyType({}))
    defines: tuple[sp.Basic, ...] = ()
    signs: Mapping[int, Sign] = field(default_factory=lambda: MappingProxyType({}))
    read_as: str = ""

    def __post_init__(self) -> None:
        marks = {*self.marks, *(mark for sign in self.signs.values() for mark in sign.marks)}
        if unknown := marks - set(MARKS):
            raise ValueError(f"row {self.number!r}: marks {sorted(unknown)} not in {MARKS}")
        if self.says is not None:
            _check_statement(self.says)

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


@dataclass(frozen=True)
class Cost:
    """What a fault makes at one place: the printed value, the right one, and their difference.

    `at` gives the symbols exact values (30 degrees are pi/6). Without `printed` and `right` the
    values are those of the two sides of the row. Units are those of `mechproof.proof.findings`.
    `names` are what the two values are called where neither is plainly the right one.
    """

    where: str
    at: Mapping[sp.Basic, sp.Expr]
    unit: str = ""
    decimals: int = 1
    printed: sp.Expr | None = None
    right: sp.Expr | None = None
    names: tuple[str, str] = ("printed", "right")


@dataclass(frozen=True)
class Follower:
    """A row that holds the print of its cause in other letters, or only parts of it.

    `renamed` has what symbols of the cause are called in the row. `parts` pairs parts of the
    cause's print with what stands for them in its correction (left out: the whole print).
    """

    row: str
    renamed: Mapping[sp.Basic, sp.Basic] = field(default_factory=lambda: MappingProxyType({}))
    parts: Mapping[sp.Basic, sp.Basic] = field(default_factory=lambda: MappingProxyType({}))


@dataclass(frozen=True)
class Finding:
    """A root cause: the row that shows it, what is wrong in a plain sentence, and what it costs.

    `follows` are the rows that are wrong for this reason alone: with the correction of the root in
    the place of its print each of them is proved, which is a row of the ledger.
    """

    row: str
    wrong: str
    costs: tuple[Cost, ...] = ()
    follows: tuple[str | Follower, ...] = ()

    @property
    def followers(self) -> tuple[Follower, ...]:
        """Return what follows, a mere number as the row that holds the whole print."""
        return tuple(Follower(f) if isinstance(f, str) else f for f in self.follows)


# Quantities: what can be computed, and every way of computing it.


@dataclass(frozen=True)
class Argument:
    """An argument of a kernel.

    One symbol: an array-like of any shape. Several symbols: components on the last axis.
    One `IndexedBase`: a last axis of any length, or two for a symbol with two indices.
    `usual` are the sizes met in practice, absolute values, as edges that rise: the ranges that
    errors are kept for and that points and timed calls are drawn from.
    """

    name: str
    symbols: tuple[sp.Symbol | sp.IndexedBase, ...]
    meaning: str
    unit: str = "1"
    default: float | None = None
    usual: tuple[float, ...] = ()


@dataclass(frozen=True)
class Scale:
    """What an error is relative to: a name, an expression, and the symbols it is written with."""

    name: str
    expression: sp.Expr
    where: tuple[tuple[sp.Symbol, sp.Expr], ...] = ()

    def written_out(self) -> sp.Expr:
        """Return the expression without the symbols of `where`; each may use those before it."""
        values: dict[sp.Symbol, sp.Expr] = {}
        for symbol, value in self.where:
            values[symbol] = value.xreplace(values)
        # At once: SymPy compares the arguments of a maximum whenever one of them changes.
        return self.expression.xreplace(values)


@dataclass(frozen=True)
class Accuracy:
    """The accuracy bound that the tests hold: |error| <= `ulp` * eps * |scale|.

    Without a scale, of the value itself. It holds where the relations `within` are true.
    """

    ulp: float
    scale: Scale | None = None
    within: tuple[sp.Basic, ...] = ()


@dataclass(frozen=True)
class Singular:
    """A set where a quantity is undefined, jumps, is steep or cancels, as an equation.

    Integer symbols that are no variables of the paper run over all integers. `text` says what
    happens there; it stands in the docstring of the kernel.
    """

    equation: sp.Basic
    text: str = ""


class Written(Protocol):
    """A form as its emitted source has it: what a proof compares."""

    def output(self, *kept: sp.Symbol) -> sp.Basic:
        """Return the value with every step inserted but the kept ones."""

    def step(self, name: sp.Symbol, *kept: sp.Symbol) -> sp.Expr:
        """Return the value of a step with every step before it inserted but the kept ones."""


@dataclass(frozen=True)
class Chart:
    """Coordinates over which rounding errors are bounded: the arguments by them, and their ranges.

    What vanishes at an end of a range does so as a product of powers of coordinates. `angle` is
    the coordinate that is taken off by whole turns, its range being that of its size. `text` says
    where the arguments are that this and the charts with the same text cover together.
    """

    text: str
    arguments: Mapping[sp.Basic, sp.Expr]
    within: Mapping[sp.Symbol, sp.Interval]
    angle: sp.Symbol | None = None


@dataclass(frozen=True)
class Form:
    """One algebraic way to compute: an expression and the named rewrites applied to it in order.

    `key` ends the name of its function, <quantity>_<key>; the shipped form needs none. `when` is
    the relation on the parameters under which it is taken instead of the forms after it. `bound`
    is set for an approximation: a bound of |form - definition|. `states` makes the statement
    that proves it from what was emitted (left out: it equals the definition), decided on `on`;
    where false, `holds_on` may say where it is true. `source` is where it is printed. `charts`
    cover the arguments for which it is taken and its accuracy is stated; `proved` says what is
    certified of its roundings over them and is filled in when it is printed.
    """

    name: str
    expression: sp.Basic
    rewrites: tuple[str, ...] = ()
    key: str = ""
    when: sp.Basic | None = None
    bound: sp.Expr | None = None
    states: Callable[[Written], Statement] | None = None
    on: Part | None = None
    holds_on: Part | None = None
    source: str = ""
    note: str = ""
    charts: tuple[Chart, ...] = ()
    proved: str = ""


@dataclass(frozen=True)
class Quantity:
    """A function of a system and every form of it.

    `definition` is the exact meaning (what accuracy is measured against). The kernel takes the
    first of `forms` whose condition holds; the first without a condition ends it. The forms after
    that one are rivals, each a function of its own. A quantity without forms is computed by
    hand-written code, the first of its peers. `period` is the spacing of wrong branches.
    `workloads` names calls to be timed by the arguments that vary (left out: the first).
    """

    name: str
    summary: str
    arguments: tuple[Argument, ...]
    definition: sp.Basic
    forms: tuple[Form, ...]
    source: str
    unit: str = "1"
    accuracy: Accuracy | None = None
    on: Part | None = None
    singular: tuple[Singular, ...] = ()
    period: sp.Expr | None = None
    workloads: tuple[tuple[str, tuple[str, ...]], ...] = ()
    remarks: tuple[str, ...] = ()

    @property
    def shipped(self) -> tuple[Form, ...]:
        """Return the forms of the kernel, in the order in which they are tried."""
        conditional = [form.when is not None for form in self.forms]
        return self.forms[: conditional.index(False) + 1] if self.forms else ()

    @property
    def rivals(self) -> tuple[Form, ...]:
        """Return the forms kept for comparison."""
        return self.forms[len(self.shipped) :]

    def __post_init__(self) -> None:
        if self.forms and all(form.when is not None for form in self.forms):
            raise ValueError(f"quantity {self.name!r}: every form has a condition")
        keys = [form.key for form in self.rivals]
        wrong = sorted(
            {k for k in keys if not f"x_{k}".isidentifier() or keys.count(k) > 1 or not k}
        )
        if wrong:
            raise ValueError(f"quantity {self.name!r}: keys of rivals {wrong}: no names, or twice")


@dataclass(frozen=True)
class Peer:
    """A way to get the number that is no form: a solver, a spline, a simulation, a library.

    `ordered`: it needs samples in order from 0 on. `slow`: measured on few points, timed at small
    sizes only. `ours`: hand-written code of the package itself.
    """

    name: str
    compute: Callable[..., Any]
    ordered: bool = False
    slow: bool = False
    ours: bool = False
    note: str = ""


@dataclass(frozen=True)
class Toleranced:
    """A size with its limit deviations, exact."""

    nominal: sp.Expr
    upper: sp.Expr
    lower: sp.Expr


@dataclass(frozen=True)
class Published:
    """Sizes that a paper prints, exact; a symbol that is left out is not printed.

    `marks` say what they rest on.
    """

    source: str
    sizes: Mapping[sp.Symbol, sp.Expr | Toleranced]
    marks: tuple[str, ...] = ()


@dataclass(frozen=True)
class Paper:
    """A paper: its symbols, its rows in printed order, the quantities shipped from it."""

    system: str
    citation: str
    variables: tuple[Variable, ...]
    rows: tuple[Row, ...]
    where: tuple[sp.Basic, ...] = ()
    quantities: tuple[Quantity, ...] = ()
    published: tuple[Published, ...] = ()
    findings: tuple[Finding, ...] = ()
    conventions: str = ""
    notation: Notation = Notation()

    def __post_init__(self) -> None:
        if not _names_module(self.system):
            raise ValueError(
                f"paper: system = {self.system!r}: it names a module, so it must be a Python name "
                f"that begins with no underscore and is none of {', '.join(RESERVED)}"
            )
        for what, names in (
            ("row numbers", [row.number for row in self.rows]),
            ("symbols", [str(variable.symbol) for variable in self.variables]),
            ("quantities", [quantity.name for quantity in self.quantities]),
            ("findings", [finding.row for finding in self.findings]),
        ):
            twice = sorted({name for name in names if names.count(name) > 1})
            if twice:
                raise ValueError(f"paper {self.system!r}: {what} given twice: {twice}")


def _names_module(system: str) -> bool:
    is_name = isinstance(system, str) and system.isidentifier() and not iskeyword(system)
    return is_name and not system.startswith("_") and system not in RESERVED
