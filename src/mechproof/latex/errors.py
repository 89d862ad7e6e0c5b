"""Errors for prints that cannot be read, or could be read in two ways."""

from __future__ import annotations

from dataclasses import dataclass

TOO_DEEP = "it is nested too deeply to be read"


class ReadingError(ValueError):
    """A print that is ambiguous or not understood: the place in it, and what can be done.

    `row` is filled in once the row is known.
    """

    def __init__(self, latex: str, place: int, reason: str, remedy: str = "") -> None:
        self.latex, self.place, self.reason, self.remedy = latex, place, reason, remedy
        self.row = ""
        super().__init__(reason)

    def __str__(self) -> str:
        head = f"row {self.row!r}: {self.reason}" if self.row else self.reason
        lines = [head, f"  {self.latex}", f"  {' ' * self.place}^"]
        return "\n".join([*lines, f"  {self.remedy}"] if self.remedy else lines)


class MeaningError(TypeError):
    """The reason why a part of a print can have no meaning, worded for the user."""


@dataclass(frozen=True)
class Remedies:
    """How to declare what a print leaves open; {0} stands for the printed text."""

    name: str
    bracket: str
    function: str
    scope: str
    lower_limit: str
    family: str
    membership: str
    rate: str
    sign: str
    depends: str


MODULE = Remedies(
    name="Declare Variable(…, latex=(r'{0}',)) in the paper.",
    bracket=(
        "Declare Notation(factors=(r'{0}',)) for the product, Notation(functions={{…}}) for the "
        "function, or the whole print as a name, Variable(…, latex=(r'{0}(…)',))."
    ),
    function="Declare Notation(functions={{'{0}': …}}).",
    scope="Declare Scope(rows=(…), names={{r'{0}': None}}) in Notation.scopes.",
    lower_limit="Declare Notation(lower_limit=…), and the value of a constant of integration.",
    family="Declare an IndexedBase instead of {0}.",
    membership=r"Print an interval as a relation, 0<x<1; declare the set of a letter as `within`.",
    rate="If it is a derivative of {0}, declare that in Notation(moving=…). Otherwise:",
    sign=", or declare a letter that is 1 or -1, Notation(branch=…)",
    depends="If {0} depends on {1}, declare that in Notation(moving=…). Otherwise:",
)


@dataclass(frozen=True)
class PrintedText:
    """A print as errors point into it."""

    latex: str

    def refuse(self, place: int, reason: str, remedy: str = "") -> ReadingError:
        """Return the error at a place of the print, or at its end if the place is beyond that."""
        return ReadingError(self.latex, min(place, len(self.latex)), reason, remedy)
