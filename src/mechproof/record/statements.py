"""Statements: what a row asserts. The ladder has one way to decide each kind."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Literal

import sympy as sp
from sympy.logic.boolalg import Boolean

from mechproof.record.exactness import RecordError, make_exact

_DECIMAL = re.compile(r"-?\d+(\.\d+)?(e-?\d+)?")


@dataclass(frozen=True)
class Differentiated:
    """The derivatives of an expression by letters, in their order."""

    expression: sp.Expr
    by: tuple[sp.Symbol, ...]


@dataclass(frozen=True)
class Equality:
    """`printed` equals `rebuilt` everywhere on the domain (expressions or matrices).

    The two sides come from different sources: one is the paper's, one is derived. If `rebuilt` is
    built from the print itself, or from the declaration of the printed symbol, `rebuilt_from` says
    so: then equality proves nothing. Two members of one print are both the paper's, and so are
    their faults. `rebuilt` may be the derivatives of the expression `differentiated`, an entry for
    each letter: if both sides are the same formula, only the differentiation remains to be checked.
    """

    printed: sp.Basic
    rebuilt: sp.Basic
    rebuilt_from: Literal["mechanics", "member", "print", "declaration"] = "mechanics"
    differentiated: Differentiated | None = None

    def __post_init__(self) -> None:
        make_exact(self, "printed", "rebuilt")

    @property
    def sides(self) -> tuple[sp.Basic, sp.Basic]:
        """Return both sides."""
        return self.printed, self.rebuilt


@dataclass(frozen=True)
class Distinct:
    """The two sides differ somewhere on the domain (decided by a counterexample)."""

    left: sp.Basic
    right: sp.Basic

    def __post_init__(self) -> None:
        make_exact(self, "left", "right")


@dataclass(frozen=True)
class Holds:
    """A relation (or several joined by And) is true on the whole domain."""

    relation: sp.Basic

    def __post_init__(self) -> None:
        if not isinstance(self.relation, Boolean) or self.relation.is_Symbol:
            raise RecordError(f"Holds: {self.relation!r} is not a relation of SymPy")
        if self.relation.has(sp.Float):
            raise RecordError(f"Holds: {self.relation} has a float; write Rational('0.1')")


@dataclass(frozen=True)
class PrintedNumber:
    """`value` rounds to the decimal string `printed` (half a unit of its last place).

    A power of ten may follow the digits: 2.1e5.
    """

    printed: str
    value: sp.Expr

    def __post_init__(self) -> None:
        if not (isinstance(self.printed, str) and _DECIMAL.fullmatch(self.printed)):
            raise RecordError(
                f"PrintedNumber: printed {self.printed!r} is not a decimal number such as '-0.93'"
            )
        make_exact(self, "value")

    @property
    def half_place(self) -> sp.Rational:
        """Return half a unit of the last printed place."""
        return find_last_place(self.printed) / 2


def find_last_place(digits: str) -> sp.Rational:
    """Return the unit of the last digit of a decimal string: 0.01 for 2.15, 10**4 for 2.1e5."""
    number, _, power = digits.partition("e")
    return sp.Rational(10) ** (int(power or 0) - len(number.partition(".")[2]))


@dataclass(frozen=True)
class Definition:
    """`symbol` is introduced as `printed`; only dimensions and bound symbols are checked."""

    symbol: sp.Symbol
    printed: sp.Basic

    def __post_init__(self) -> None:
        make_exact(self, "symbol", "printed")


@dataclass(frozen=True)
class Conjunction:
    """Every part is true; with `needs_first` the others mean nothing if the first is not proved."""

    parts: tuple[Statement, ...]
    needs_first: bool = False

    def __post_init__(self) -> None:
        if not self.parts:
            raise RecordError("a Conjunction needs at least one part")
        for part in self.parts:
            check_statement(part)


@dataclass(frozen=True)
class Completion:
    """The missing datum completed in one stated way, and the statement that results."""

    text: str
    says: Statement
    value: sp.Expr | None = None

    def __post_init__(self) -> None:
        check_statement(self.says)


@dataclass(frozen=True)
class Completions:
    """The paper lacks a datum, named here; two completions of it whose decisions are compared.

    If the missing datum is a symbol of the paper, it gets the `value` of each completion, and their
    statements are the same; a datum given in words is completed by the words of each.
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
                    f"Completions: must have two values of {self.missing} and one statement"
                )
        elif not self.missing or self.first.text == self.second.text:
            raise RecordError("Completions: name what is missing, and complete it in two ways")


@dataclass(frozen=True)
class NotCheckable:
    """The print asserts something, but what it would be compared with is lost or not printed."""

    lacks: str

    def __post_init__(self) -> None:
        if not self.lacks.strip():
            raise RecordError("NotCheckable: name what is lost or not printed")


@dataclass(frozen=True)
class Nearly:
    """Two sides are said to be nearly equal, but not how nearly, so nothing decides it."""

    left: sp.Basic
    right: sp.Basic

    def __post_init__(self) -> None:
        make_exact(self, "left", "right")


@dataclass(frozen=True)
class Unwritten:
    """No kernel is written for a quantity: why, and what would mend that. It is never proved."""

    reason: str


Statement = (
    Equality
    | Distinct
    | Holds
    | PrintedNumber
    | Definition
    | Conjunction
    | Completions
    | NotCheckable
    | Nearly
    | Unwritten
)


def list_parts(statement: Statement) -> Iterator[Statement]:
    """Yield the parts of a conjunction, also of nested ones, or any other statement itself."""
    if isinstance(statement, Conjunction):
        for part in statement.parts:
            yield from list_parts(part)
    else:
        yield statement


def list_letters(statement: Statement) -> set[sp.Basic]:
    """Return the letters of a statement."""
    values = (value for part in list_parts(statement) for value in vars(part).values())
    return {s for value in values for s in getattr(value, "free_symbols", ())}


def all_of(*parts: Statement) -> Conjunction:
    """State that every part is true."""
    return Conjunction(parts)


def less(left: sp.Expr, right: sp.Expr) -> Holds:
    """State left < right, keeping SymPy from deciding it."""
    return Holds(sp.Lt(left, right, evaluate=False))


def not_above(left: sp.Expr, right: sp.Expr) -> Holds:
    """State left <= right, keeping SymPy from deciding it."""
    return Holds(sp.Le(left, right, evaluate=False))


def rounded(numbers: Iterable[str], values: Iterable[sp.Expr]) -> tuple[PrintedNumber, ...]:
    """State that each value rounds to its number; raises `ValueError` for unequal counts."""
    return tuple(PrintedNumber(*pair) for pair in zip(numbers, values, strict=True))


def check_statement(says: object) -> None:
    """Raise RecordError unless it is a statement."""
    if not isinstance(says, Statement):
        raise RecordError(f"{says!r} is not a statement: {type(says).__name__}")
