"""The role of each relation sign of a paper, and the row to be judged that is made of it.

The first print of a letter defines it. Later prints of it, its derivatives and further members of a
chain are compared. Two compound sides, or a side that is zero, constrain letters. A bare number is
a size.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum
from functools import cached_property
from typing import Any

import sympy as sp

from mechproof.latex.values import list_reached
from mechproof.record import Paper, PrintedNumber, Row, list_given
from mechproof.record.statements import list_letters
from mechproof.sources.announcements import NOTHING, Announced
from mechproof.sources.located_text import Place
from mechproof.statement_domains.domain import Domain

_DECIMAL = re.compile(r"\d(?:\.|\{,\})\d")
_INDEXED = re.compile(r"\)\s*_")


class Role(StrEnum):
    """The role of a relation sign."""

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


# The letter by which a part of a print is integrated, differentiated or the like, and the letters
# of that part.
Varied = tuple[sp.Basic, frozenset[sp.Basic]]


@dataclass(frozen=True)
class Sign:
    """One relation sign: its role, its letter, the equation that printed that first, and its sides.

    `number` has the digits of a side that is a number, `unit` the unit after them and `value` the
    other side; if that is a number with a unit, too, `given` has its digits and unit. `worked_out`
    says which sides are computed and not printed: derivatives, and products of matrices. `printed`
    has the letters of both sides as printed, `factor` the digits of their only decimal, if it is a
    factor. `varied` has the letters by which a part is differentiated or integrated, or that have a
    value put in, each with the letters of that part. If a side is a calculation of numbers,
    `is_calculated` is true, `formula` is the member before it, and `span` is its range if decimals
    in it are rounded; for two calculations, `span` is the range of their difference. `halves` has
    x_1 and x_2 for a print of both, x_{1,2}. `own` is the letter that the chain is about, in whose
    unit its numbers count. For an inequality, `units` has the units of its sides, and `limited` the
    sides if one has a unit. If one side is a value at a place, `places` has the numbers that
    letters are there, and `beside` the letters of the other side.
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
        """Return whether it ties two letters that the equation `first` prints at once, x_{1,2}."""
        return self.role is Role.CONSTRAINT and bool(self.first) and all(self.worked_out)


@dataclass(frozen=True)
class Task:
    """A row to be judged: its place, its sign, and the paper that it is judged in.

    `asserts` says whether its sides are claimed to be equal, `is_claimed` that the block says so;
    `residual` is their difference with the values of letters put in, `rates` are its derivatives.
    `is_either` marks a constraint that may also be meant as an identity: both sides have the same
    letters, and the block does not say which it is. `is_solution` marks a later print of a letter
    that may be another solution, or an inequality that may belong to another case. `others`
    compare the same print with further members of the chain that it is compared with. `follows`
    names the equations from which it follows according to the block. `is_loose` says that it has a
    letter that no other equation has, and that can make it true whatever the other letters are;
    `ties_running` that it has a letter on which others depend, but none of those: if it holds for
    all values, some letter depends on that one without being declared so. `is_case` says that words
    before it may announce another case, or that the block calls it a constraint; `is_excused` also
    that a letter of one side occurs nowhere else: it may state something new. `said` is what the
    words before it announce, `at` are the values that a condition next to it gives letters,
    `special` is the row at these and at those that words before it give. `anew` are the values of
    letters and derivatives if it is another case, None for one without a value then. `is_given`
    says that the block calls it a constraint. `local` is the row at the values that worked examples
    print for letters, which might not be meant here. `case` is the row at those that words around
    it give for a case, where it may be proved. `rests_on` names an equation that must be proved for
    it, and the reason reported otherwise.
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
    case: Task | None = None
    rests_on: tuple[str, str] = ("", "")
    lacking: str = ""
    mixed: tuple[sp.Expr, Paper] | None = None

    @cached_property
    def domain(self) -> Domain:
        """Return the values that its letters may have."""
        return Domain.of(self.paper, self.row.on)

    @property
    def is_rounded(self) -> bool:
        """Return whether the print has a decimal next to letters, which is taken to be rounded."""
        is_number = isinstance(self.row.says, PrintedNumber) or self.sign.is_calculated
        return not is_number and bool(_DECIMAL.search(self.row.printed_latex))

    @property
    def is_indexed(self) -> bool:
        r"""Return whether the value of a bracket at one place is meant, (a/b)_{\max}."""
        return bool(_INDEXED.search(self.row.printed_latex))

    @property
    def is_alone(self) -> bool:
        """Return whether the row only gives a number for a letter that is defined elsewhere."""
        return self.sign.role is Role.NUMBER and self.sign.letter is not None

    def give_values(self, values: Mapping[sp.Basic, Any]) -> Task | None:
        """Return the row with other values of letters, None for a letter without a value.

        Returns None if the values of their first prints are put into its statement, as they are
        into integrands and derivatives.
        """
        given = list_given(self.paper.variables)
        used = list_reached(list_letters(self.row.statement), given)
        put_in = list_reached(self.sign.printed, given) - used
        if put_in & values.keys() or not used & values.keys():
            return None
        variables = tuple(
            replace(v, given=values[v.symbol]) if v.symbol in values else v
            for v in self.paper.variables
        )
        return replace(self, paper=replace(self.paper, variables=variables))
