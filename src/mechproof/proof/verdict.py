"""What the ladder answers and what the ledger prints: a judgement, or a row left without one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from types import MappingProxyType

from mechproof.notebook import Displayed


class Verdict(StrEnum):
    """Exactly one for each row."""

    PROVED = "PROVED"
    REFUTED = "REFUTED"
    ILL_FORMED = "ILL_FORMED"
    CONDITIONAL = "CONDITIONAL"
    CONVENTION = "CONVENTION"
    DEFINITION = "DEFINITION"
    ENCLOSED = "ENCLOSED"
    UNDERDETERMINED = "UNDERDETERMINED"
    UNDECIDED = "UNDECIDED"


class State(StrEnum):
    """How far a row got; what is not judged has no verdict."""

    JUDGED = "judged"
    NOT_JUDGED = "not judged"
    NOT_READ = "not read"
    SKIPPED = "skipped"


MEANINGS: Mapping[Verdict, str] = MappingProxyType(
    {
        Verdict.PROVED: "a complete decision procedure, the named rung, says so on the whole "
        "domain",
        Verdict.REFUTED: "a counterexample whose enclosures separate both sides; the corrected "
        "form is proved",
        Verdict.ILL_FORMED: "cannot be evaluated as printed: the witness is shown, the corrected "
        "form is proved",
        Verdict.CONDITIONAL: "true on a stated part of the domain, false elsewhere with a "
        "counterexample there",
        Verdict.CONVENTION: "true after a stated change of sign, order, direction or reading; "
        "both are shown",
        Verdict.DEFINITION: "introduces a symbol or a datum, or is compared with what was built "
        "from it: nothing to prove beyond dimensions and consistent use",
        Verdict.ENCLOSED: "not proved: the difference is enclosed at stated points",
        Verdict.UNDERDETERMINED: "the paper lacks a named datum: two completions of it give "
        "opposite answers",
        Verdict.UNDECIDED: "none of the others, with what could not be shown",
    }
)


@dataclass(frozen=True)
class Place:
    """A place in a file; lines and columns are counted from 1."""

    file: str
    line: int
    column: int

    def __str__(self) -> str:
        return f"{self.file}:{self.line}:{self.column}"


@dataclass(frozen=True)
class Left:
    """A row without a verdict: where it stands, how far it got, why, and what can be done."""

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
            "printed_latex": self.printed_latex,
            "reason": self.reason,
            "remedy": self.remedy,
        }


@dataclass(frozen=True)
class Evidence:
    """What a verdict rests on: where, and the two sides as balls, or a witness in words."""

    what: str
    at: dict[str, str] = field(default_factory=dict)
    printed: str = ""
    rebuilt: str = ""

    def as_dict(self) -> dict[str, object]:
        """Return the record that goes into the ledger; empty fields are left out."""
        fields = {"what": self.what, "at": self.at, "printed": self.printed}
        fields["rebuilt"] = self.rebuilt
        return {name: value for name, value in fields.items() if value}


@dataclass(frozen=True)
class Answer:
    """What the ladder says of one statement; `corrected_by` is the rung of a proved correction."""

    verdict: Verdict
    rung: str
    reason: str
    evidence: tuple[Evidence, ...] = ()
    corrected_by: str = ""


@dataclass(frozen=True)
class Judgement(Displayed):
    """One line of the ledger; `on` is the part of the paper's domain that it is said of.

    `compared_with` is the LaTeX of the other side; `place` is where a paper's own source has it.
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
    place: Place | None = None

    @property
    def sides(self) -> tuple[str, str]:
        """Return what the two sides of evidence are: in a paper's own source both are printed."""
        return ("one side", "other side") if self.place else ("printed", "rebuilt")

    def as_dict(self) -> dict[str, object]:
        """Return the JSON row."""
        return {
            "system": self.system,
            "number": self.number,
            **({"place": str(self.place)} if self.place else {}),
            "kind": self.kind,
            "verdict": self.verdict.value,
            "reason": self.reason,
            "rung": self.rung,
            "marks": list(self.marks),
            "printed_latex": self.printed_latex,
            "read_as": self.read_as,
            "compared_with": self.compared_with,
            "on": self.on,
            "singular": list(self.singular),
            "evidence": [item.as_dict() for item in self.evidence],
            "corrected_latex": self.corrected_latex,
        }
