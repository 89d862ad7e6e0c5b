"""What each relation sign of a paper does: introduces a letter, compares, or constrains.

What is printed first of a letter defines it. Later prints of it, derivatives of it and the further
members of a chain are compared. Two compound sides, or a side that is zero, constrain letters. A
bare number is a size.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

import sympy as sp

EQUAL = ("=", r"\equiv")


class Role(StrEnum):
    """What a relation sign does."""

    DEFINITION = "definition"
    SIZE = "size"
    REPEATED = "printed again"
    DERIVATIVE = "derivative"
    STEP = "step"
    NUMBER = "number"
    VALUE = "value at a place"
    CONSTRAINT = "constraint"
    SOLUTIONS = "both solutions"
    SEAM = "seam"
    RELATION = "relation"


# What is taken as given.
CONSTRAINING = (Role.CONSTRAINT, Role.SOLUTIONS)
# A letter over which a part of a print goes alone, and the letters of that part.
Varied = tuple[sp.Basic, frozenset[sp.Basic]]


@dataclass(frozen=True)
class Sign:
    """One relation sign: its role, the letter that it is about, who printed it first; its sides.

    `number` are the digits of a side that is a number, `unit` is that behind them and `value` the
    other side then; `given` are the digits and the unit of that, if it is a number with a unit,
    too. `worked_out` tells which sides are no print: derivatives, and what matrices
    give. `printed` are the letters of both sides as they are printed, `factor`
    the digits of their only decimal, if it is a factor. `varied` are letters over which a part goes
    alone, by which it is differentiated or integrated, or of which a value is put in, each with
    the letters of that part. `formula` is what stands before a calculation that a number is of,
    `span` between what this lies whose decimals are rounded, `is_calculated` tells that it is one.
    Of two calculations `span` is that of their difference.
    `halves` are x_1 and x_2 of what is printed of both, x_{1,2}.
    Of an inequality `units` are the units of its sides, and `limited` the sides if one has any.
    `places` are the numbers that letters are where one side is the value of something, `beside` the
    letters of the other side then.
    """

    role: Role
    letter: sp.Basic | None = None
    first: str = ""
    sides: tuple[Any, Any] = (None, None)
    number: str = ""
    value: Any = None
    unit: str = ""
    given: tuple[str, str] = ("", "")
    worked_out: tuple[bool, bool] = (False, False)
    printed: frozenset[sp.Basic] = frozenset()
    varied: tuple[Varied, ...] = ()
    factor: str = ""
    formula: Any = None
    span: tuple[float, float] | None = None
    is_calculated: bool = False
    units: tuple[str, str] = ("", "")
    limited: tuple[Any, Any] = (None, None)
    halves: tuple[sp.Basic, ...] = ()
    places: Mapping[sp.Basic, sp.Expr] = field(default_factory=dict)
    beside: frozenset[sp.Basic] = frozenset()

    @property
    def is_tied(self) -> bool:
        """Return whether it is what ties two letters that are printed at once, as `first` says."""
        return self.role is Role.CONSTRAINT and bool(self.first) and all(self.worked_out)
