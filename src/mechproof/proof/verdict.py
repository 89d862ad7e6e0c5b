"""The ladder's answers and the ledger's lines: a judgement, or a row left without a verdict."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from fractions import Fraction
from types import MappingProxyType

from mechproof.latex.sentences import is_sentence
from mechproof.proof.anchors import name_anchor
from mechproof.sources.located_text import Place
from mechproof.tools.notebook import Displayed


class Verdict(StrEnum):
    """A row's verdict: every judged row has exactly one."""

    PROVED = "PROVED"
    REFUTED = "REFUTED"
    ILL_FORMED = "ILL_FORMED"
    CONDITIONAL = "CONDITIONAL"
    CONVENTION = "CONVENTION"
    DEFINITION = "DEFINITION"
    ENCLOSED = "ENCLOSED"
    UNDERDETERMINED = "UNDERDETERMINED"
    NOT_CHECKABLE = "NOT_CHECKABLE"
    UNDECIDED = "UNDECIDED"


# Verdicts of rows that no rung proves or refutes.
OPEN = (Verdict.ENCLOSED, Verdict.UNDECIDED)


class State(StrEnum):
    """How far a row got; a row that is not judged has no verdict."""

    JUDGED = "judged"
    NOT_JUDGED = "not judged"
    NOT_READ = "not read"
    SKIPPED = "skipped"


MEANINGS: Mapping[Verdict, str] = MappingProxyType(
    {
        Verdict.PROVED: "proved on the whole domain by a complete decision procedure, the named "
        "rung",
        Verdict.REFUTED: "a counterexample whose enclosures separate both sides; the corrected "
        "form is proved",
        Verdict.ILL_FORMED: "cannot be evaluated as printed: the witness is shown, the corrected "
        "form is proved",
        Verdict.CONDITIONAL: "true on a stated part of the domain, false elsewhere with a "
        "counterexample there",
        Verdict.CONVENTION: "true after a stated change of sign, order, direction or reading; "
        "both are shown",
        Verdict.DEFINITION: "introduces a symbol or a datum, or is compared with something "
        "built from it: nothing to prove beyond dimensions and consistent use",
        Verdict.ENCLOSED: "not proved: the difference is enclosed at stated points",
        Verdict.UNDERDETERMINED: "the paper lacks a named datum: two completions of it give "
        "opposite answers",
        Verdict.NOT_CHECKABLE: "what it would be compared with, named in the reason, is lost or "
        "not printed",
        Verdict.UNDECIDED: "none of the others; the reason names what could not be shown",
    }
)


def name_row(system: str, number: str) -> str:
    """Return the id by which a row can be cited: its paper and its number."""
    return f"{system}/{name_anchor(number)}"


def describe_print(latex: str, *, is_source: bool) -> dict[str, str]:
    """Return a text under "print" if it is verbatim, else under "paraphrase": in our words.

    Everything read from a paper's own source is verbatim.
    """
    name = "paraphrase" if is_sentence(latex) and not is_source else "print"
    return {"print": "", "paraphrase": "", name: latex}


@dataclass(frozen=True)
class Left:
    """A row without a verdict: its place, how far it got, why no further, and a remedy."""

    number: str
    place: Place
    printed_latex: str
    state: State
    reason: str
    remedy: str = ""

    def as_dict(self) -> dict[str, object]:
        """Return the JSON row."""
        return {
            "number": self.number,
            "place": str(self.place),
            "state": self.state.value,
            **describe_print(self.printed_latex, is_source=True),
            "reason": self.reason,
            "remedy": self.remedy,
        }


@dataclass(frozen=True)
class Evidence:
    """What a verdict rests on: a point and both sides there as balls, or a witness as text.

    `dimension` is that of both sides; angles are in radians.
    """

    what: str
    at: dict[str, str] = field(default_factory=dict)
    printed: str = ""
    rebuilt: str = ""
    dimension: str = ""

    def list_values(self, sides: tuple[str, str]) -> list[str]:
        """List the point and both sides under their names, as far as there are any."""
        at = ", ".join(f"{name} = {value}" for name, value in self.at.items())
        values = zip(("at", *sides), (at, self.printed, self.rebuilt), strict=True)
        return [f"{name} {value}" for name, value in values if value]

    def as_dict(self) -> dict[str, object]:
        """Return the record that goes into the ledger; empty fields are left out."""
        fields: dict[str, object] = {"what": self.what}
        fields["at"] = {name: describe_number(value) for name, value in self.at.items()}
        sides = {"printed": self.printed, "rebuilt": self.rebuilt}
        fields |= {name: describe_number(text) for name, text in sides.items() if text}
        fields["dimension"] = self.dimension
        return {name: value for name, value in fields.items() if value}


@dataclass(frozen=True)
class Answer:
    """The ladder's answer to one statement; `corrected_by` is the rung that proves a correction."""

    verdict: Verdict
    rung: str
    reason: str
    evidence: tuple[Evidence, ...] = ()
    corrected_by: str = ""


@dataclass(frozen=True)
class Judgement(Displayed):
    """One line of the ledger; `on` is the part of the paper's domain that it is about.

    `compared_with` is the LaTeX of the other side; `cites` lists the sentences of the transcription
    that the line judges, `quantities` those whose formulas or kernels rest on it; `place` is the
    position in a paper's own source.
    """

    system: str
    number: str
    kind: str
    verdict: Verdict
    rung: str
    marks: tuple[str, ...]
    printed_latex: str
    read_as: str
    on: str
    singular: tuple[str, ...]
    reason: str
    evidence: tuple[Evidence, ...]
    corrected_latex: str
    corrected_by: str
    compared_with: str
    cites: tuple[str, ...] = ()
    quantities: tuple[str, ...] = ()
    place: Place | None = None

    @property
    def id(self) -> str:
        """Return the id by which a row can be cited: its paper and its number."""
        return name_row(self.system, self.number)

    @property
    def sides(self) -> tuple[str, str]:
        """Return the names of the evidence's sides; in a paper's own source both are printed."""
        return ("one side", "other side") if self.place else ("printed", "rebuilt")

    def as_dict(self) -> dict[str, object]:
        """Return the JSON row."""
        return {
            "id": self.id,
            "system": self.system,
            "number": self.number,
            **({"place": str(self.place)} if self.place else {}),
            "cites": list(self.cites),
            "quantities": list(self.quantities),
            "kind": self.kind,
            "verdict": self.verdict.value,
            "reason": self.reason,
            "rung": self.rung,
            "marks": list(self.marks),
            **describe_print(self.printed_latex, is_source=self.place is not None),
            "read_as": self.read_as,
            "compared_with": self.compared_with,
            "on": self.on,
            "singular": list(self.singular),
            "evidence": [item.as_dict() for item in self.evidence],
            "corrected_latex": self.corrected_latex,
        }


BALL = re.compile(r"\[(\S+) \+/- (\S+)\]")
# A multiple of pi: 19*pi/180.
TURN = re.compile(r"(-?)(?:(\d+)\*)?pi(?:/(\d+))?")


def read_number(text: str) -> Mapping[str, float]:
    """Return the value and, for a ball, the radius; nothing if the text is not a number.

    Text in round brackets after the number, such as its degrees, is ignored.
    """
    number = text.partition(" (")[0]
    if ball := BALL.fullmatch(number):
        return _keep_finite({"value": ball[1], "radius": ball[2]})
    if turn := TURN.fullmatch(number):
        factor = Fraction(int(turn[2] or 1), int(turn[3] or 1)) * (-1 if turn[1] else 1)
        return {"value": float(factor) * math.pi}
    return _keep_finite({"value": number})


def describe_number(text: str) -> dict[str, object]:
    """Return a text together with its value and radius, if it has them."""
    return {"text": text, **read_number(text)}


def _keep_finite(texts: Mapping[str, str]) -> Mapping[str, float]:
    try:
        found = {name: float(Fraction(text)) for name, text in texts.items()}
    except (ValueError, OverflowError, ZeroDivisionError):
        return {}
    return found
