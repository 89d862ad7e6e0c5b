"""The effect of a fault at one place: both values, as a finding shows them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.proof.exact_values import RECOMPUTATION
from mechproof.proof.verdict import Evidence, Judgement, describe_number
from mechproof.proof.witness_text import show_plainly


@dataclass(frozen=True)
class LedgerCost:
    """The cost of a fault at one place: values by their names, in the unit; all as text."""

    where: str
    values: Mapping[str, str]
    unit: str = ""

    def __str__(self) -> str:
        unit = self.unit if self.unit in ("", "°") else f" {self.unit}"
        told = (f"{_lead(name)} {value}{unit}" for name, value in self.values.items())
        return f"{self.where}: {', '.join(told)}"

    def as_dict(self) -> dict[str, object]:
        """Return the JSON record: the text, and its numbers as numbers."""
        values = {name: describe_number(value) for name, value in self.values.items()}
        return {"text": str(self), "where": self.where, "unit": self.unit, "values": values}


def _lead(name: str) -> str:
    """Return a name for use in front of a value, with a colon after a letter, number or sign."""
    return f"{name}:" if re.search(r"[^a-z]$|(?<![a-z])[a-z]$", name) else name


def show_witness(row: Judgement) -> Iterator[LedgerCost]:
    """Yield the values of both sides where they were first found to differ."""
    for item in row.evidence[:1]:
        sides = zip(row.sides, (item.printed, item.rebuilt), strict=True)
        if item.at:
            at, *_ = item.list_values(row.sides)
            yield LedgerCost(at, {name: value for name, value in sides if value})
        elif row.rung == RECOMPUTATION and item.rebuilt:
            yield _show_number(row, item)


def _show_number(row: Judgement, item: Evidence) -> LedgerCost:
    """Return a printed number and the right one, at the sizes with which it was read."""
    _, said, sizes = row.read_as.partition(" at ")
    recomputed, _ = show_plainly(balls.read(item.rebuilt), balls.to_ball(sp.Rational(item.printed)))
    values = {"printed": item.printed, "recomputed": recomputed}
    return LedgerCost(f"at {sizes}" if said else "the number", values)
