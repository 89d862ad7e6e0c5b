"""Forms: the ways to compute a quantity; and peers, which get its number without a formula."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Protocol

import sympy as sp

from mechproof.record.exactness import make_exact
from mechproof.record.statements import Statement
from mechproof.record.variables import Part

# Begins the number of each row on the form of a quantity; this before it, of one on derivatives.
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
