"""Papers with their verdicts -> a folder of files that `make` has Coq check, and the rest.

A row has a file, or a reason why it has none. Coq's results are kept as a record of digests, and as
a page for a reader.
"""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from importlib.resources.abc import Traversable
from itertools import pairwise
from pathlib import Path
from types import MappingProxyType

from mechproof.coq.checker import ASSUMED, ASSUMED_MODULES, LIMIT, check_files, find_version
from mechproof.coq.proofs import is_the_same
from mechproof.coq.script_comparison import compare_script
from mechproof.coq.scripts import (
    LIBRARIES,
    ROUNDINGS,
    digest_libraries,
    digest_required,
    list_required,
    read_library,
    write_assumptions,
    write_script,
)
from mechproof.coq.terms import UnwritableError, name_letters
from mechproof.coq.theorems import Theorem, build_theorems
from mechproof.ledger.judged import JudgedPaper, classify
from mechproof.proof.verdict import Judgement, Verdict
from mechproof.record import Paper, Row
from mechproof.statement_domains.domain import Domain
from mechproof.tools.made import ForeignFileError, Made

LIST = "mechproof-coq.sha256"
# Verdicts that say that something is proved: for all values, at a point, or each on a part.
CERTIFIABLE = (Verdict.PROVED, Verdict.REFUTED, Verdict.CONDITIONAL)
ASSUMPTIONS = "Assumptions.v"
_MAKEFILE = """# Has Coq check every file, and print what all of them assume: make -j2
LIBRARIES := {libraries}
SCRIPTS := $(filter-out $(LIBRARIES) {assumptions}, $(wildcard *.v))

all: $(SCRIPTS:.v=.vo)
\tcoqc -q -w none {assumptions}

%.vo: %.v
\tcoqc -q -w none $<

$(SCRIPTS:.v=.vo): $(LIBRARIES:.v=.vo)
{chain}
clean:
\trm -f *.vo *.vok *.vos *.glob .*.aux

.PHONY: all clean
"""
PAGE = "COQ.md"
RECORD = "coq.json"
NOT_CHECKED = "not checked in this run"
# Prefix of reasons that come from Coq itself, and what readers are told about such a file.
BY_COQ, REFUSED = "Coq: ", "Coq refuses the proof that was written for it"
_INTRODUCTION = """# What Coq checks

The rows of the ledger that are PROVED, REFUTED or CONDITIONAL are written as theorems of Coq
{version} and proved there again: `mechproof certify --out FOLDER --check` writes the files and runs
Coq. A theorem states the whole row in the letters of the paper. Its hypotheses are the domain, and
what every quotient, root and tangent needs to have a value; next to it, a point is proved to
satisfy all hypotheses. For a refuted row a point is proved at which it fails; a conditional row has
both, with the theorem on the part where it is true. A law by pieces is a theorem for each piece,
under its condition; sums run to any whole number, over families of any numbers. Before a file is
written, a separate reader reads it back from its text and compares it with the row.

If both sides are one formula that is the derivative of a known one, the theorem says so, and Coq
differentiates, too. For some rows the theorem says no more than A = A: both sides are one formula
once they are read and worked out, for example where a form is what the paper prints, or where SymPy
has taken a derivative that the row does not name. There Coq adds nothing, so these rows are counted
separately.

No file has an axiom of its own. The theorems rest on what Coq's real numbers rest on ({assumed})
and, where numbers are computed, on the machine integers and floats of coq-interval ({modules}).

This page is generated.

"""


@dataclass(frozen=True)
class RowScript:
    """The file of a row with its text, or the reason why there is none.

    `is_alike` says that in every theorem of the file both sides are the same term, once they are
    read and evaluated.
    """

    id: str
    verdict: str
    rung: str
    counted_as: str
    file: str = ""
    text: str = ""
    reason: str = ""
    is_alike: bool = False

    @property
    def digest(self) -> str:
        """Return the SHA-256 of the text and of all it requires, or "" if there is no text."""
        return digest_required(self.text) if self.text else ""


def write_row_script(judgement: Judgement, row: Row, ledger: JudgedPaper) -> RowScript:
    """Write the script of a certifiable row, read back and compared with the row."""
    name = f"{re.sub(r'[^a-z0-9]+', '_', judgement.id.lower())}.v"
    try:
        theorems = _list_theorems(row, judgement.verdict, ledger.paper)
        text = write_script(judgement.id, theorems)
    except UnwritableError as error:
        return withhold(judgement, str(error))
    compare_script(text, theorems)
    return replace(
        withhold(judgement, ""), file=name, text=text, is_alike=all(map(_is_alike, theorems))
    )


def _list_theorems(row: Row, verdict: Verdict, paper: Paper) -> list[Theorem]:
    """List a row's theorems; a CONDITIONAL row has those on its part and one at a point outside."""
    whole = Domain.of(paper, row.on)
    if verdict is not Verdict.CONDITIONAL:
        return build_theorems(row, verdict, whole)
    inside = build_theorems(row, Verdict.PROVED, Domain.of(paper, row.on, row.holds_on))
    return [*inside, *build_theorems(row, Verdict.REFUTED, whole)]


def _is_alike(theorem: Theorem) -> bool:
    listed = (*theorem.hypotheses, theorem.conclusion)
    return is_the_same(theorem.conclusion, name_letters(theorem.symbols, *listed))


def withhold(judgement: Judgement, reason: str) -> RowScript:
    """Return a record of a row without a script, with the reason."""
    about = (judgement.id, judgement.verdict.value, judgement.rung, classify(judgement))
    return RowScript(*about, reason=reason)


def list_texts(scripts: Iterable[RowScript]) -> dict[str, str]:
    """Return the texts of scripts that have one, by file name."""
    return {script.file: script.text for script in scripts if script.text}


def list_files(scripts: Mapping[str, str]) -> dict[str, str]:
    """Return the text of every file of a folder of scripts, by file name."""
    assumptions = write_assumptions([name.removesuffix(".v") for name in scripts])
    required = {name for text in scripts.values() for name in list_required(text)}
    libraries = [name for name in (*LIBRARIES, ROUNDINGS) if name in required]
    makefile = _MAKEFILE.format(
        libraries=" ".join(f"{name}.v" for name in libraries),
        assumptions=ASSUMPTIONS,
        chain="".join(f"{b}.vo: {a}.vo\n" for a, b in pairwise(libraries)),
    )
    texts = {f"{name}.v": read_library(name) for name in libraries}
    return {**texts, **scripts, ASSUMPTIONS: assumptions, "Makefile": makefile}


def write_folder(folder: Path, scripts: Mapping[str, str]) -> None:
    """Write scripts and what they require into a folder that is new, empty or was written so.

    Raises `ForeignFileError` for any other folder, and `OSError`.
    """
    if folder.is_dir() and not (folder / LIST).exists() and any(folder.iterdir()):
        raise ForeignFileError(f"{folder}: contains files that are not of `mechproof certify`")
    Made(folder, LIST).update(list_files(scripts))


@dataclass(frozen=True)
class Coverage:
    """Certificates, and what Coq finds wrong with each file, "" if it accepts it.

    Files without an entry in `faults` were not checked.
    """

    version: str
    certificates: tuple[RowScript, ...]
    faults: Mapping[str, str]

    def explain(self, certificate: RowScript) -> str:
        """Return why a row is withheld, or "" if Coq accepts its file."""
        return certificate.reason or self.faults.get(certificate.file, NOT_CHECKED)

    def find_lost(self, known: Mapping[str, str]) -> list[str]:
        """List the rows that a record has as accepted, but that are now refused or different.

        `known` are the digests of the record by the ids of their rows.
        """
        lost = []
        for certificate in self.certificates:
            reason = self.explain(certificate)
            if certificate.id in known and reason not in ("", NOT_CHECKED):
                lost.append(f"{certificate.id}: {reason}")
            elif certificate.digest != known.get(certificate.id, certificate.digest):
                lost.append(f"{certificate.id}: its script differs from the recorded one")
        return lost

    def count(self) -> str:
        """Report how many rows are certified."""
        told = [self.explain(c) for c in self.certificates]
        left = told.count(NOT_CHECKED)
        rest = f", {left} are {NOT_CHECKED}" if left else ""
        alike = sum(not t and c.is_alike for t, c in zip(told, self.certificates, strict=True))
        accepted = told.count("")
        share = f"{accepted / len(told):.1%}" if told else "none"
        return (
            f"{accepted} of {len(told)} rows ({share}) are accepted by Coq {self.version}, "
            f"{alike} of them A = A{rest}"
        )


def check_folder(
    folder: Path,
    certificates: Sequence[RowScript],
    tell: Callable[[str], None] = lambda text: None,
    *,
    known: Mapping[str, str] = MappingProxyType({}),
    one_in: int = 1,
    limit: float = LIMIT,
) -> Coverage:
    """Have Coq check every file of a folder, or every `one_in`-th; remove those that it refuses.

    Files whose digests are in `known`, under the ids of their rows, were accepted before and are
    not checked again. The page is written into the folder, too. Raises `CheckerError`.
    """
    written = [c for c in certificates if c.text]
    taken = {c.file: "" for c in written if known.get(c.id) == c.digest}
    names = [c.file for c in written if c.file not in taken][::one_in]
    faults = check_files(folder, names, tell, limit=limit)
    coverage = Coverage(find_version(), tuple(certificates), {**taken, **faults})
    refused = {name for name, fault in faults.items() if fault}
    write_folder(folder, list_texts(c for c in certificates if c.file not in refused))
    (folder / PAGE).write_text(write_page(coverage), encoding="utf-8")
    return coverage


def keep_record(folder: Path, coverage: Coverage) -> None:
    """Write the record and the page next to the generated files."""
    (folder / RECORD).write_text(write_record(coverage), encoding="utf-8")
    (folder / PAGE).write_text(write_page(coverage), encoding="utf-8")


def read_known(folder: Traversable) -> dict[str, str]:
    """Return the digests of the files that a record has as accepted, by row id."""
    return {row["id"]: row["sha256"] for row in _read_rows(folder) if not row["withheld"]}


def read_refused(folder: Traversable) -> dict[str, str]:
    """Return the digests of the files that a record has as refused by Coq, by row id."""
    rows = _read_rows(folder)
    return {row["id"]: row["sha256"] for row in rows if row["withheld"].startswith(BY_COQ)}


def read_checks(folder: Traversable) -> dict[str, str]:
    """Return, by row id, which file of a record Coq accepts, or why there is none."""
    return {row["id"]: _describe(row["withheld"], row["file"]) for row in _read_rows(folder)}


def _describe(withheld: str, file: str) -> str:
    """Write whether a row is checked, without Coq's message, which is useful only with the file."""
    if not withheld:
        return f"checked: {file}"
    return f"not checked: {REFUSED if withheld.startswith(BY_COQ) else withheld}"


def _read_rows(folder: Traversable) -> Sequence[Mapping[str, str]]:
    file = folder.joinpath(RECORD)
    record = json.loads(file.read_text(encoding="utf-8")) if file.is_file() else {}
    rows: Sequence[Mapping[str, str]] = record.get("rows", ())
    return rows


def write_record(coverage: Coverage) -> str:
    """Write the digests of the files that Coq accepts, and why the other rows are withheld."""
    rows = [
        {"id": c.id, "file": c.file, "sha256": c.digest, "withheld": coverage.explain(c)}
        for c in coverage.certificates
    ]
    lines = ",\n".join(json.dumps(row, ensure_ascii=False) for row in rows)
    head = f'"coq": "{coverage.version}",\n"libraries": "{digest_libraries()}"'
    return f'{{{head},\n"rows": [\n{lines}\n]}}\n'


def write_page(coverage: Coverage) -> str:
    """Write the page: how many rows of each class and rung are certified, and all rows."""
    introduction = _INTRODUCTION.format(
        version=coverage.version,
        assumed=", ".join(f"`{name}`" for name in sorted(ASSUMED)),
        modules=", ".join(f"`{name}`" for name in sorted(ASSUMED_MODULES)),
    )
    parts = [introduction + f"{coverage.count()}.\n"]
    parts.append(_tabulate("rows", [[c.counted_as] for c in coverage.certificates], coverage))
    parts.append("A row that several rungs decide counts with each of them.\n")
    parts.append(_tabulate("rung", [c.rung.split(", ") for c in coverage.certificates], coverage))
    parts.append(_list_rows(coverage))
    return "\n".join(parts)


def _tabulate(name: str, kinds: Sequence[Sequence[str]], coverage: Coverage) -> str:
    """Count the certified and the withheld rows of each kind; a row may be of several kinds."""
    counted: dict[str, Counter[str]] = {}
    for kinds_of, c in zip(kinds, coverage.certificates, strict=True):
        said = ["withheld"] if coverage.explain(c) else ["certified", *["alike"] * c.is_alike]
        for kind in dict.fromkeys(kinds_of):
            counted.setdefault(kind, Counter()).update(said)
    lines = [f"| {name} | certified | of them A = A | withheld |", "|---|---|---|---|"]
    for kind, count in counted.items():
        numbers = f"{count['certified']} | {count['alike']} | {count['withheld']}"
        lines.append(f"| {kind} | {numbers} |")
    return "\n".join([*lines, ""])


def _list_rows(coverage: Coverage) -> str:
    lines = ["| row | verdict | file, or why there is none |", "|---|---|---|"]
    for c in coverage.certificates:
        reason = coverage.explain(c)
        told = f"withheld: {reason}" if reason else f"`{c.file}`{', A = A' if c.is_alike else ''}"
        lines.append(f"| [{c.id}](LEDGER.md#{c.id}) | {c.verdict} | {told} |")
    return "\n".join([*lines, ""])
