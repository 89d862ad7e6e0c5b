"""Papers with their verdicts -> the files of a folder that `make` has Coq check, and what is left.

A row has a file, or a reason why it has none.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path

from mechproof.coq.families import name_letters
from mechproof.coq.proofs import is_the_same
from mechproof.coq.script_comparison import compare_script
from mechproof.coq.scripts import (
    LIBRARIES,
    ROUNDINGS,
    digest_required,
    list_required,
    read_library,
    write_assumptions,
    write_script,
)
from mechproof.coq.terms import UnwritableError
from mechproof.coq.theorems import Theorem, build_theorems
from mechproof.ledger.judged import JudgedPaper, classify
from mechproof.proof.verdict import Judgement, Verdict
from mechproof.record import Paper, Row
from mechproof.statement_domains.domain import Domain
from mechproof.tools.made import ForeignFileError, Made

LIST = "mechproof-coq.sha256"
# What of a ledger says that something is proved, of all values, at a point, or of each a part.
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


@dataclass(frozen=True)
class RowScript:
    """What there is of a row: its file with the text, or the reason why there is none.

    `is_alike` tells that all its theorems have equalities with the same term on both sides:
    what is left of both sides once they are read and worked out.
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
        """Return the SHA-256 of the text and what it requires, or nothing where there is none."""
        return digest_required(self.text) if self.text else ""


def write_row_script(judgement: Judgement, row: Row, ledger: JudgedPaper) -> RowScript:
    """Write what Coq is given of a certifiable row, read back and compared with the row."""
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
    """List what a row says; of one that is true on a part, that, and a point at which it fails."""
    whole = Domain.of(paper, row.on)
    if verdict is not Verdict.CONDITIONAL:
        return build_theorems(row, verdict, whole)
    inside = build_theorems(row, Verdict.PROVED, Domain.of(paper, row.on, row.holds_on))
    return [*inside, *build_theorems(row, Verdict.REFUTED, whole)]


def _is_alike(theorem: Theorem) -> bool:
    listed = (*theorem.hypotheses, theorem.conclusion)
    return is_the_same(theorem.conclusion, name_letters(theorem.symbols, *listed))


def withhold(judgement: Judgement, reason: str) -> RowScript:
    """Say why there is no script of a row."""
    about = (judgement.id, judgement.verdict.value, judgement.rung, classify(judgement))
    return RowScript(*about, reason=reason)


def list_texts(scripts: Iterable[RowScript]) -> dict[str, str]:
    """Return the texts that there are by the names of their files."""
    return {script.file: script.text for script in scripts if script.text}


def list_files(scripts: Mapping[str, str]) -> dict[str, str]:
    """Return the text of every file of a folder of scripts by its name."""
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

    Raises `ForeignFileError` for any other, and `OSError`.
    """
    if folder.is_dir() and not (folder / LIST).exists() and any(folder.iterdir()):
        raise ForeignFileError(f"{folder}: holds files that are no scripts of `mechproof certify`")
    Made(folder, LIST).update(list_files(scripts))
