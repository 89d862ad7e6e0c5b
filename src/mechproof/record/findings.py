"""Findings: the root causes of what is wrong, what follows from them and what they cost."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import IntEnum
from types import MappingProxyType

import sympy as sp


class Weight(IntEnum):
    """What a finding changes for a reader, the gravest first."""

    CONCLUSION = 0
    NUMBER = 1
    FORMULA = 2
    WORDING = 3


WEIGHTS: Mapping[Weight, str] = MappingProxyType(
    {
        Weight.CONCLUSION: "changes a conclusion",
        Weight.NUMBER: "changes a number that a reader would use",
        Weight.FORMULA: "a formula cannot be evaluated as printed",
        Weight.WORDING: "the wording misleads",
    }
)


@dataclass(frozen=True)
class Check:
    """A check for a pocket calculator: a sentence with its numbers as {0}, {1}, ... computed.

    The values are exact; they are shown in the unit, rounded to so many decimals. {0:4} shows the
    number itself, without the unit, to 4 decimals.
    """

    text: str
    values: tuple[sp.Expr, ...] = ()
    decimals: int = 3
    unit: str = ""


@dataclass(frozen=True)
class Cost:
    """What a fault makes at one place: the printed value, the right one, and their difference.

    `at` gives the symbols exact values (30 degrees are pi/6). Without `printed` and `right` the
    values are those of the two sides of the row. Units are those of
    `mechproof.ledger.ledger_findings`. `names` are what the two values are called where neither is
    plainly the right one; by default the first is the printed one, or what a convention gives when
    read literally.
    """

    where: str
    unit: str = ""
    decimals: int = 1
    printed: sp.Expr | None = None
    right: sp.Expr | None = None
    names: tuple[str, str] = ("printed", "right")
    at: Mapping[sp.Basic, sp.Expr] = field(default_factory=lambda: MappingProxyType({}))


@dataclass(frozen=True)
class FollowingRow:
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

    `mend` is the number of a proved row whose print is the smallest mend, where that is less than
    the correction of the row; `figure` is the name of a picture that shows the fault.
    `follows` are the rows that are wrong for this reason alone: with the correction of the root in
    the place of its print each of them is proved, which is a row of the ledger.
    """

    row: str
    wrong: str
    costs: tuple[Cost, ...] = ()
    follows: tuple[str | FollowingRow, ...] = ()
    weight: Weight = Weight.NUMBER
    mend: str = ""
    check: Check | None = None
    figure: str = ""

    @property
    def followers(self) -> tuple[FollowingRow, ...]:
        """Return what follows, a mere number as the row that holds the whole print."""
        return tuple(FollowingRow(f) if isinstance(f, str) else f for f in self.follows)
