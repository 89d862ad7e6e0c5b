"""What Coq accepts of the ledger: a record of digests, and a page for a reader."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from importlib.resources.abc import Traversable
from pathlib import Path
from types import MappingProxyType

from mechproof.coq.checker import ASSUMED, ASSUMED_MODULES, LIMIT, check_files, find_version
from mechproof.coq.folder import RowScript, list_texts, write_folder
from mechproof.coq.scripts import digest_libraries

PAGE = "COQ.md"
RECORD = "coq.json"
NOT_CHECKED = "not checked in this run"
# What Coq itself says of a file begins so, and what a reader is told of it.
BY_COQ, REFUSED = "Coq: ", "Coq refuses the proof that was written for it"
_INTRODUCTION = """# What Coq checks

Rows of the ledger that are PROVED, REFUTED or CONDITIONAL, written as theorems of Coq {version}
and proved there once more: `mechproof certify --out FOLDER --check` writes the files and runs Coq.
A theorem states the whole row in the letters of the paper, with the domain as its hypotheses and
with what every quotient, root and tangent needs to have a value; a point that satisfies all
hypotheses is proved to exist beside it. Of a refuted row a point is proved at which it fails; a
conditional row has both, the theorem on the part where it is true. A law by pieces is a theorem for
each piece, under its condition; sums go to any whole number, over families of any numbers. Each
file is read back from its text by a reader of its own and compared with the row before it is
written.

Where both sides are one formula that is the derivative of a known one, the theorem says so, and Coq
differentiates, too. Of some rows a theorem says no more than A = A: both sides are one formula once
they are read and worked out, as where a form is what the paper prints, or where SymPy has taken a
derivative of what the row does not name. Coq adds nothing to what was read then, so that they are
counted apart.

No file has an axiom of its own. What the theorems rest on is what Coq's real numbers rest on
({assumed}) and, where numbers are computed, the machine integers and floats of coq-interval
({modules}).

This page is generated.

"""


@dataclass(frozen=True)
class Coverage:
    """Certificates, and what Coq says of their files: nothing where it accepts them.

    Files of which it says neither were not looked at.
    """

    version: str
    certificates: tuple[RowScript, ...]
    faults: Mapping[str, str]

    def explain(self, certificate: RowScript) -> str:
        """Return why a row is withheld; nothing if Coq accepts its file."""
        return certificate.reason or self.faults.get(certificate.file, NOT_CHECKED)

    def find_lost(self, known: Mapping[str, str]) -> list[str]:
        """List the rows that a record has as accepted, and that are refused or other ones now.

        `known` are the digests of the record by the ids of their rows.
        """
        lost = []
        for certificate in self.certificates:
            reason = self.explain(certificate)
            if certificate.id in known and reason not in ("", NOT_CHECKED):
                lost.append(f"{certificate.id}: {reason}")
            elif certificate.digest != known.get(certificate.id, certificate.digest):
                lost.append(f"{certificate.id}: another script than the one recorded")
        return lost

    def count(self) -> str:
        """Say how many rows are certified."""
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
    """Have Coq check every file of a folder, or one in so many; remove what it refuses.

    Files whose digests are `known` by the ids of their rows were accepted before as they are.
    The folder gets the page, too. Raises `CheckerError`.
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
    """Write the record and the page beside what is generated."""
    (folder / RECORD).write_text(write_record(coverage), encoding="utf-8")
    (folder / PAGE).write_text(write_page(coverage), encoding="utf-8")


def read_known(folder: Traversable) -> dict[str, str]:
    """Return the digests of the files that a record has as accepted, by the ids of their rows."""
    return {row["id"]: row["sha256"] for row in _read_rows(folder) if not row["withheld"]}


def read_refused(folder: Traversable) -> dict[str, str]:
    """Return the digests of the files that Coq refuses by a record, by the ids of their rows."""
    rows = _read_rows(folder)
    return {row["id"]: row["sha256"] for row in rows if row["withheld"].startswith(BY_COQ)}


def read_checks(folder: Traversable) -> dict[str, str]:
    """Say of the rows of a record which file Coq accepts, or why there is none, by their ids."""
    return {row["id"]: _tell(row["withheld"], row["file"]) for row in _read_rows(folder)}


def _tell(withheld: str, file: str) -> str:
    """Say whether a row is checked; where Coq stopped is of use only beside the file."""
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
    """Count what is accepted and withheld of each kind; a row may be of several."""
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
