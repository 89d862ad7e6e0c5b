"""What each relation sign of a paper does, and what becomes of it: a row to be judged.

What is printed first of a letter defines it. Later prints of it, derivatives of it and the further
members of a chain are compared. Two compound sides, or a side that is zero, constrain letters. A
bare number is a size.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

import sympy as sp

from mechproof.record import Paper, PrintedNumber, Row
from mechproof.sources.announcements import NOTHING, Announced
from mechproof.sources.located_text import Place

EQUAL = ("=", r"\equiv")
_DECIMAL = re.compile(r"\d(?:\.|\{,\})\d")


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


# Roles of rows that are taken as given.
CONSTRAINING = (Role.CONSTRAINT, Role.SOLUTIONS)


# The letter by which a part of a print is integrated, differentiated and the like, and the letters
# of that part.
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
    `halves` are x_1 and x_2 of what is printed of both, x_{1,2}. `own` is the letter that its chain
    is about, in whose unit a number of it counts.
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
    own: sp.Basic | None = None

    @property
    def is_tied(self) -> bool:
        """Return whether it is what ties two letters that are printed at once, as `first` says."""
        return self.role is Role.CONSTRAINT and bool(self.first) and all(self.worked_out)


@dataclass(frozen=True)
class Task:
    """A row to be judged, where it stands, what it does, and the paper that it is judged in.

    `asserts` says whether its sides are claimed to be equal, `is_claimed` that the block says so;
    `residual` is their difference, the values of letters put in, `rates` are its derivatives.
    `is_either` tells a constraint that may also be meant as an identity: both sides have the same
    letters, and the block does not say which it is. `is_solution` tells a later print of a letter
    that may be another solution, or an inequality that may be said of another case. `others`
    compare the same print with further members of the chain that it is compared with.
    `follows` names what the block says that it follows from. `is_loose`
    tells that a letter that no other equation has makes it true, whatever the others are;
    `ties_running` that it has a letter on which others depend and none of those: if it holds for
    all values, a letter depends on it of which that is not said. `is_case` tells that words before
    it may announce another case, or that the block says it to be a constraint, `is_excused` also
    that it has a letter that nothing else has, on one side: it may say what is said nowhere else.
    `said` is what words before it announce, `at` are the values of letters that a condition beside
    it says, `special` is the row at those that words before it say, too. `anew` are the values of
    letters and derivatives if it is another case; None for one without a value then. `is_given`
    tells that the block says it to be a constraint. `local` is the row at the values that worked
    examples print of letters, which may not be meant here. `rests_on` names an equation that has to
    be proved for it, and what is said otherwise.
    """

    row: Row
    place: Place
    sign: Sign
    paper: Paper
    asserts: bool
    is_claimed: bool = False
    residual: sp.Expr | None = None
    rates: tuple[sp.Expr, ...] = ()
    is_either: bool = False
    is_solution: bool = False
    others: tuple[Task, ...] = ()
    follows: tuple[str, ...] = ()
    is_loose: bool = False
    ties_running: bool = False
    is_case: bool = False
    is_excused: bool = False
    said: Announced = NOTHING
    at: Mapping[sp.Basic, sp.Basic] = field(default_factory=dict)
    special: Task | None = None
    anew: Mapping[sp.Basic, Any] = field(default_factory=dict)
    is_given: bool = False
    local: Task | None = None
    rests_on: tuple[str, str] = ("", "")
    lacking: str = ""
    mixed: tuple[sp.Expr, Paper] | None = None

    @property
    def is_rounded(self) -> bool:
        """Return whether a decimal stands beside letters: it is a rounded number."""
        is_number = isinstance(self.row.says, PrintedNumber) or self.sign.is_calculated
        return not is_number and bool(_DECIMAL.search(self.row.printed_latex))

    @property
    def is_alone(self) -> bool:
        """Return whether it is the number of a letter that is defined elsewhere."""
        return self.sign.role is Role.NUMBER and self.sign.letter is not None
