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

# Prefix of the numbers of rows on the forms of a quantity, and the prefix in front of it for rows
# on derivatives.
KERNEL = "kernel "
DERIVATIVES = "derivatives of "


class EmittedForm(Protocol):
    """A form as read back from its emitted source, for a proof to compare."""

    def output(self, *kept: sp.Symbol) -> sp.Basic:
        """Return the value with every step inserted except the kept ones."""

    def step(self, name: sp.Symbol, *kept: sp.Symbol) -> sp.Expr:
        """Return the value of a step with every earlier step inserted except the kept ones."""


@dataclass(frozen=True)
class Chart:
    """Coordinates in which rounding errors are bounded: the arguments in terms of them, and ranges.

    Whatever vanishes at an end of a range does so as a product of powers of coordinates. `angle` is
    the coordinate that is reduced by whole turns; its range is that of its size. `rest` is what
    then remains of it in terms of the other coordinates, or half a turn plus that (by default it is
    itself a coordinate). `text` says which arguments this chart covers together with the charts
    that have the same text; empty means wherever the quantity has a value.
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
    the relation on the parameters under which it is used instead of the forms after it. `bound` is
    set for an approximation: a bound of |form - definition|. `states` makes the statement that
    proves the form from the emitted source (by default that it equals the definition), decided on
    `on`; if that is false, `holds_on` may say where it is true. `source` is where the form is
    printed. `charts` cover the arguments for which its rounding errors are bounded, up to changes
    of the signs of all arguments of a mirror; `proved` states what is certified of the errors and
    is filled in when it is printed.
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
    """A way to get the number that is not a form: a solver, a spline, a simulation, a library.

    `ordered`: it needs samples in order from 0 onwards. `slow`: measured on few points, timed at
    small sizes only. `ours`: hand-written code of the package itself, which may need one of its
    extras.
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

    One symbol: an array-like of any shape. Several symbols: components on the last axis. One
    `IndexedBase`: a last axis of any length, or two for a symbol with two indices. `usual` are the
    sizes met in practice, absolute values, as increasing edges: the ranges for which errors are
    recorded and from which points and timed calls are drawn.
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
            raise RecordError(f"{where}: usual = {self.usual}: must be two or more rising edges")
        object.__setattr__(self, "usual", usual)


@dataclass(frozen=True)
class Scale:
    """What an error is relative to: a name, an expression, and the symbols in that."""

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
    """The accuracy bound that the tests enforce: |error| <= `ulp` * eps * |scale|.

    Without a scale, the error is relative to the value itself. The bound holds where the relations
    `within` are true; `where` puts those into words if they are long.
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

    Integer symbols that are not variables of the paper run over all integers. `text` says what
    happens there, for the docstring of the kernel.
    """

    equation: sp.Basic
    text: str = ""


@dataclass(frozen=True)
class Periodicity:
    """Repetition in the running variable: after one `period`, the value is larger by `gain`."""

    period: sp.Expr
    gain: sp.Expr = sp.S.Zero


@dataclass(frozen=True)
class Quantity:
    """A function of a system and every form of it.

    `definition` is the exact meaning, against which accuracy is measured. The kernel uses the first
    of `forms` whose condition holds, up to the first without a condition. The forms after that one
    are rivals, each a function of its own. A quantity without forms is computed by hand-written
    code, the first of its peers; `call` is that call. `period` is the spacing of wrong branches,
    `periodicity` says how the running variable can be reduced. `slopes` is the accuracy of its
    derivatives, where the bound holds and its own relations, too; without it none are shipped.
    `workloads` names calls to be timed by the arguments that vary (by default the first).
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
        """Return whether an argument is a family, with any number of members."""
        return any(isinstance(symbol, sp.IndexedBase) for symbol in self.symbols)

    @property
    def is_scalar(self) -> bool:
        """Return whether it is a single number that depends on single numbers."""
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
                f"quantity {self.name!r}: each form that is not shipped needs a valid name as its "
                f"own key; these are not: {wrong}"
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
