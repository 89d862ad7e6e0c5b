"""Quantities: what can be computed, by which forms, how accurately, and where it is singular."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, Protocol

import sympy as sp

from mechproof.record.exactness import RecordError, check_name, is_name, make_exact, to_number
from mechproof.record.statements import Statement
from mechproof.record.variables import Part

# Prefix of the numbers of rows on the forms of a quantity, and before it that of rows on
# derivatives.
KERNEL = "kernel "
DERIVATIVES = "derivatives of "


class EmittedForm(Protocol):
    """A form as its emitted source has it: what a proof compares."""

    def output(self, *kept: sp.Symbol) -> sp.Basic:
        """Return the value with every step inserted but the kept ones."""

    def step(self, name: sp.Symbol, *kept: sp.Symbol) -> sp.Expr:
        """Return the value of a step with every step before it inserted but the kept ones."""


@dataclass(frozen=True)
class Chart:
    """Coordinates over which rounding errors are bounded: the arguments by them, and their ranges.

    What vanishes at an end of a range does so as a product of powers of coordinates. `angle` is
    the coordinate that is taken off by whole turns, its range being that of its size. `rest` is
    what is left of it by the other coordinates, or half a turn and that (left out: it is one
    itself). `text` says where the arguments are that this and the charts with the same text cover
    together; empty, wherever the quantity has a value.
    """

    text: str
    arguments: Mapping[sp.Basic, sp.Expr]
    within: Mapping[sp.Symbol, sp.Interval]
    angle: sp.Symbol | None = None
    rest: sp.Expr | None = None


@dataclass(frozen=True)
class Form:
    """One algebraic way to compute: an expression and the named rewrites applied to it in order.

    `key` ends the name of its function, <quantity>_<key>; the shipped form needs none. `when` is
    the relation on the parameters under which it is taken instead of the forms after it. `bound`
    is set for an approximation: a bound of |form - definition|. `states` makes the statement
    that proves it from what was emitted (left out: it equals the definition), decided on `on`;
    where false, `holds_on` may say where it is true. `source` is where it is printed. `charts`
    cover the arguments for which its rounding errors are bounded, but for changes of the signs of
    all arguments of a mirror; `proved` says what is certified of them and is filled in when it is
    printed.
    """

    name: str
    expression: sp.Basic
    rewrites: tuple[str, ...] = ()
    key: str = ""
    when: sp.Basic | None = None
    bound: sp.Expr | None = None
    states: Callable[[EmittedForm], Statement] | None = None
    on: Part | None = None
    holds_on: Part | None = None
    source: str = ""
    note: str = ""
    charts: tuple[Chart, ...] = ()
    mirrors: tuple[tuple[sp.Basic, ...], ...] = ()
    proved: str = ""

    def __post_init__(self) -> None:
        make_exact(self, "expression")


@dataclass(frozen=True)
class Peer:
    """A way to get the number that is no form: a solver, a spline, a simulation, a library.

    `ordered`: it needs samples in order from 0 on. `slow`: measured on few points, timed at small
    sizes only. `ours`: hand-written code of the package itself, which may need one of its extras.
    """

    name: str
    compute: Callable[..., Any]
    ordered: bool = False
    slow: bool = False
    ours: bool = False
    note: str = ""
    needs: str = ""


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

    def __post_init__(self) -> None:
        where = f"argument {self.name!r}"
        if self.default is not None:
            object.__setattr__(self, "default", to_number(f"{where}: default", self.default))
        usual = tuple(to_number(f"{where}: usual", edge) for edge in self.usual)
        if usual and (len(usual) < 2 or any(low >= high for low, high in pairwise(usual))):
            raise RecordError(
                f"{where}: usual = {self.usual}: must be edges that rise, two or more"
            )
        object.__setattr__(self, "usual", usual)


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
        # All at once, because SymPy compares the arguments of a maximum whenever one of them
        # changes.
        return self.expression.xreplace(values)


@dataclass(frozen=True)
class Accuracy:
    """The accuracy bound that the tests hold: |error| <= `ulp` * eps * |scale|.

    Without a scale, of the value itself. It holds where the relations `within` are true; `where`
    says so in words, where they are long.
    """

    ulp: float
    scale: Scale | None = None
    within: tuple[sp.Basic, ...] = ()
    where: str = ""


# Accuracy of derivatives relative to their conditioning: a rounding of 1/2 eps, of a step or on the
# way back, counts as a change of that step. Searches find no more than a third of the bound.
SLOPES = Accuracy(4)


@dataclass(frozen=True)
class Singular:
    """A set where a quantity is undefined, jumps, is steep or cancels, as an equation.

    Integer symbols that are no variables of the paper run over all integers. `text` says what
    happens there; it stands in the docstring of the kernel.
    """

    equation: sp.Basic
    text: str = ""


@dataclass(frozen=True)
class Periodicity:
    """What comes again in the running variable: a `period` on, the value is more by the `gain`."""

    period: sp.Expr
    gain: sp.Expr = sp.S.Zero


@dataclass(frozen=True)
class Quantity:
    """A function of a system and every form of it.

    `definition` is the exact meaning (what accuracy is measured against). The kernel takes the
    first of `forms` whose condition holds; the first without a condition ends it. The forms after
    that one are rivals, each a function of its own. A quantity without forms is computed by
    hand-written code, the first of its peers; `call` is how. `period` is the spacing of wrong
    branches, `repeats` says how the running variable can be reduced.
    `slopes` is the accuracy of its derivatives, where the bound holds and within; without it none
    are shipped. `workloads` names calls to be timed by the arguments that vary (left out: the
    first).
    """

    name: str
    summary: str
    arguments: tuple[Argument, ...]
    definition: sp.Basic
    forms: tuple[Form, ...]
    source: str
    unit: str = "1"
    accuracy: Accuracy | None = None
    slopes: Accuracy | None = SLOPES
    on: Part | None = None
    singular: tuple[Singular, ...] = ()
    period: sp.Expr | None = None
    periodicity: Periodicity | None = None
    workloads: tuple[tuple[str, tuple[str, ...]], ...] = ()
    remarks: tuple[str, ...] = ()
    call: str = ""

    @property
    def symbols(self) -> tuple[sp.Symbol | sp.IndexedBase, ...]:
        """Return the symbols of all arguments, in order."""
        return tuple(symbol for argument in self.arguments for symbol in argument.symbols)

    @property
    def has_families(self) -> bool:
        """Say whether an argument is a family, of any number of members."""
        return any(isinstance(symbol, sp.IndexedBase) for symbol in self.symbols)

    @property
    def is_scalar(self) -> bool:
        """Say whether it is one number of single numbers."""
        return (
            len(self.symbols) == len(self.arguments)
            and not self.has_families
            and not isinstance(self.definition, sp.MatrixBase)
        )

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
        check_name("quantity: name", self.name)
        make_exact(self, "definition")
        if self.forms and all(form.when is not None for form in self.forms):
            raise ValueError(f"quantity {self.name!r}: every form has a condition")
        keys = [form.key for form in self.rivals]
        wrong = sorted({k for k in keys if not is_name(f"x_{k}") or keys.count(k) > 1 or not k})
        if wrong:
            raise ValueError(
                f"quantity {self.name!r}: each form that is not shipped needs a key that is a name "
                f"and that no other has; these are none: {wrong}"
            )


@dataclass(frozen=True)
class OnePass:
    """Quantities of the same arguments that compiled kernels compute in one pass, by their names.

    What they have in common is computed once.
    """

    name: str
    quantities: tuple[str, ...]

    def __post_init__(self) -> None:
        check_name("together: name", self.name)
