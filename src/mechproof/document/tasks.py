"""What becomes of an equation or a cell that is read: a row to be judged."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from mechproof.document.roles import Role, Sign
from mechproof.record import Paper, PrintedNumber, Row
from mechproof.sources.announcements import NOTHING, Announced
from mechproof.sources.text import Place

_DECIMAL = re.compile(r"\d(?:\.|\{,\})\d")


@dataclass(frozen=True)
class Task:
    """A row to be judged, where it stands, what it does, and the paper that it is judged in.

    `asserts` says whether its sides are claimed to be equal, `is_claimed` that the block says so;
    `residual` is their difference, the values of letters put in, `rates` are its derivatives.
    `is_either` tells a constraint that may also be meant as an identity: both sides have the same
    letters, and the block does not say which it is. `is_solution` tells a later print of a letter
    that may be another solution. `others` compare the same print with further members of the chain
    that it is compared with. `follows` names what the block says that it follows from. `is_loose`
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
